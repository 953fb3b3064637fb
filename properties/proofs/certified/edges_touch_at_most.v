(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* What the checker's search for edges that cross or overlap finds: if it finds none, no two edges of a region have a
   point in common that is an end of neither. A line between two edges, with an end of one of them off it, shows that: a
   point within that edge is off the line, too, and on the other side than the other edge. Boxes that are disjoint have
   no point in common. The search looks at all pairs: in each half of a tree, and of one half and the other. *)
From Coq Require Import QArith Lqa ZArith Lia Bool List Permutation.
From Oplus Require Import direction angular_crossings winding_number specification checker homogeneous_points
  specification_bridge edges_beside_sums.
Import ListNotations.

Open Scope Q_scope.

(* A point within both edges, by the ratios in which it divides them. *)
Definition divides (x : vector) (e : hedge) (t : Q) : Prop :=
  equal_vectors x (Vector ((1 - t) * vx (vector_of (fst e)) + t * vx (vector_of (snd e)))
    ((1 - t) * vy (vector_of (fst e)) + t * vy (vector_of (snd e)))).

Definition is_inside_both (x : vector) (e f : hedge) : Prop :=
  exists t u, 0 < t < 1 /\ 0 < u < 1 /\ divides x e t /\ divides x f u.

Lemma value_divided (l : line) (x : vector) (e : hedge) (t : Q) : divides x e t ->
  value_at l x == (1 - t) * value_at l (vector_of (fst e)) + t * value_at l (vector_of (snd e)).
Proof. intros [x_is y_is]. unfold value_at. rewrite x_is, y_is. cbn [vx vy]. ring. Qed.

Lemma separated_edges_touch (l : line) (x : vector) (e f : hedge) : separates l e f = true -> ~ is_inside_both x e f.
Proof.
  unfold separates. cbv zeta. rewrite !andb_true_iff, negb_true_iff, !Z.leb_le, !value_not_positive,
    !value_not_negative.
  intros [[[[a b] c] d] off] (t & u & t_range & u_range & on_e & on_f).
  pose proof (value_divided l x e t on_e) as by_e. pose proof (value_divided l x f u on_f) as by_f.
  assert (not_all : ~ (value_at l (vector_of (fst e)) == 0 /\ value_at l (vector_of (snd e)) == 0 /\
    value_at l (vector_of (fst f)) == 0 /\ value_at l (vector_of (snd f)) == 0)).
  { rewrite <- !value_zero. intros (a_0 & b_0 & c_0 & d_0). rewrite a_0, b_0, c_0, d_0 in off. discriminate. }
  apply not_all. repeat split; nra.
Qed.

Lemma turned_pair (x : vector) (e f : hedge) : is_inside_both x e f -> is_inside_both x f e.
Proof. intros (t & u & all). exists u, t. tauto. Qed.

Lemma edge_on_one_side_touches (x : vector) (e f : hedge) : is_on_one_side e f = true -> ~ is_inside_both x e f.
Proof.
  unfold is_on_one_side. cbv zeta.
  rewrite andb_true_iff, orb_true_iff, !andb_true_iff, negb_true_iff, !Z.leb_le, !value_not_positive,
    !value_not_negative.
  set (l := line_through (fst e) (snd e)). intros [sides_ off] (t & u & t_range & u_range & on_e & on_f).
  pose proof (value_divided l x e t on_e) as by_e. pose proof (value_divided l x f u on_f) as by_f.
  assert (zero_ : value_at l x == 0).
  { rewrite by_e. unfold l. rewrite value_at_first, value_at_second. ring. }
  assert (not_both : ~ (value_at l (vector_of (fst f)) == 0 /\ value_at l (vector_of (snd f)) == 0)).
  { rewrite <- !value_zero. intros (c_0 & d_0). rewrite c_0, d_0 in off. discriminate. }
  apply not_both. destruct sides_; split; nra.
Qed.

Lemma touching_edges (x : vector) (e f : hedge) : do_touch_at_most e f = true -> ~ is_inside_both x e f.
Proof.
  unfold do_touch_at_most. rewrite !orb_true_iff. intros [[[apart | apart] | apart] | apart] inside.
  - exact (edge_on_one_side_touches x e f apart inside).
  - exact (edge_on_one_side_touches x f e apart (turned_pair x e f inside)).
  - exact (separated_edges_touch _ x e f apart inside).
  - exact (separated_edges_touch _ x e f apart inside).
Qed.

Section Boxes.
  Variable D : positive.

  (* What the box of an edge's ends has in it, it has all along. *)
  Lemma in_box_if_ends_are (b : bounding_box) (x : vector) (e : hedge) (t : Q) :
    in_box D b (vector_of (fst e)) -> in_box D b (vector_of (snd e)) -> 0 < t < 1 -> divides x e t -> in_box D b x.
  Proof.
    unfold in_box. generalize (inject_Z (Zpos D)). intros unit_ [x1 y1] [x2 y2] range [x_is y_is].
    cbn [vx vy] in x_is, y_is. rewrite x_is, y_is.
    assert (between : forall low a b high, low <= a * unit_ <= high -> low <= b * unit_ <= high ->
      low <= ((1 - t) * a + t * b) * unit_ <= high).
    { intros low a c high in_a in_c. setoid_replace (((1 - t) * a + t * c) * unit_)
        with ((1 - t) * (a * unit_) + t * (c * unit_)) by ring. split; nra. }
    split; now apply between.
  Qed.

  Lemma disjoint_boxes (b c : bounding_box) (x : vector) : are_disjoint b c = true -> in_box D b x -> in_box D c x ->
    False.
  Proof.
    unfold are_disjoint, in_box. rewrite !orb_true_iff, !Z.ltb_lt, !Zlt_Qlt.
    intros [[[] |] |] [] []; lra.
  Qed.

  (* Of pieces that are edges. *)
  Definition touch (g h : piece) : Prop :=
    forall e f x, g = piece_of_edge e -> h = piece_of_edge f -> ~ is_inside_both x e f.

  Lemma touch_if_disjoint (t u : tree) : is_well_boxed D t -> is_well_boxed D u ->
    are_disjoint (box_of t) (box_of u) = true ->
    forall g h, In g (pieces_in t) -> In h (pieces_in u) -> touch g h.
  Proof.
    intros boxed_t%well_boxed_has boxed_u%well_boxed_has far g h G H e f x -> ->
      (s & r & s_range & r_range & on_e & on_f).
    apply (disjoint_boxes (box_of t) (box_of u) x far).
    - apply (in_box_if_ends_are _ x e s); trivial; apply (boxed_t (piece_of_edge e) _ G); [now left | right; now left].
    - apply (in_box_if_ends_are _ x f r); trivial; apply (boxed_u (piece_of_edge f) _ H); [now left | right; now left].
  Qed.

  Lemma touch_each_other_is (t u : tree) : touch_each_other t u =
    are_disjoint (box_of t) (box_of u) ||
    match t, u with
    | Leaf _ e, Leaf _ f =>
      match corners_of e, corners_of f with
      | [a; b], [c; d] => do_touch_at_most (a, b) (c, d)
      | _, _ => false
      end
    | Leaf _ _, Node _ u1 u2 => touch_each_other t u1 && touch_each_other t u2
    | Node _ t1 t2, Leaf _ _ => touch_each_other t1 u && touch_each_other t2 u
    | Node b t1 t2, Node c u1 u2 =>
      if is_larger b c then touch_each_other t1 u && touch_each_other t2 u
      else touch_each_other t u1 && touch_each_other t u2
    end.
  Proof. destruct t, u; reflexivity. Qed.

  Lemma touch_if_found (t : tree) : forall u, is_well_boxed D t -> is_well_boxed D u -> touch_each_other t u = true ->
    forall g h, In g (pieces_in t) -> In h (pieces_in u) -> touch g h.
  Proof.
    induction t as [b g | b t1 IH1 t2 IH2]; induction u as [c h | c u1 IHu1 u2 IHu2]; intros boxed_t boxed_u found;
      rewrite touch_each_other_is in found; (apply orb_true_iff in found; destruct found as [far | found];
        [exact (touch_if_disjoint _ _ boxed_t boxed_u far) |]).
    - intros g' h' [<- | []] [<- | []] [a a'] [d d'] x -> ->. exact (touching_edges x _ _ found).
    - apply andb_true_iff in found. destruct found as [one other], boxed_u as (_ & boxed1 & boxed2).
      intros g' h' G H. apply in_app_or in H. destruct H as [H | H]; [now apply IHu1 | now apply IHu2].
    - apply andb_true_iff in found. destruct found as [one other], boxed_t as (_ & boxed1 & boxed2).
      intros g' h' G H. apply in_app_or in G.
      destruct G as [G | G]; [now apply (IH1 (Leaf c h)) | now apply (IH2 (Leaf c h))].
    - destruct (is_larger b c); apply andb_true_iff in found; destruct found as [one other]; intros g' h' G H.
      + destruct boxed_t as (_ & boxed1 & boxed2). apply in_app_or in G.
        destruct G as [G | G]; [now apply (IH1 (Node c u1 u2)) | now apply (IH2 (Node c u1 u2))].
      + destruct boxed_u as (_ & boxed1 & boxed2). apply in_app_or in H.
        destruct H as [H | H]; [now apply IHu1 | now apply IHu2].
  Qed.

  Lemma pairs_of_both {A} (related : A -> A -> Prop) (l m : list A) : ForallOrdPairs related l ->
    ForallOrdPairs related m ->
    (forall a b, In a l -> In b m -> related a b) -> ForallOrdPairs related (l ++ m).
  Proof.
    intros of_l of_m of_both. induction of_l as [| a l first_ rest IH]; [exact of_m |]. cbn [app]. constructor.
    - apply Forall_app. split; [exact first_ |]. apply Forall_forall. intros b B. apply of_both; [now left | exact B].
    - apply IH. intros b c B C. apply of_both; [now right | exact C].
  Qed.

  Lemma touch_in_one (t : tree) : is_well_boxed D t -> touch_in_tree t = true -> ForallOrdPairs touch (pieces_in t).
  Proof.
    induction t as [b g | b one IH_one other IH_other]; intros boxed found; [repeat constructor |].
    destruct boxed as (_ & boxed_one & boxed_other). cbn [touch_in_tree pieces_in] in *. apply andb_true_iff in found.
    destruct found as [found both]. apply andb_true_iff in found. destruct found as [in_one in_other].
    apply pairs_of_both; [now apply IH_one | now apply IH_other | now apply touch_if_found].
  Qed.

  Lemma pairs_in_another_order {A} (related : A -> A -> Prop) (l m : list A) :
    (forall a b, related a b -> related b a) -> Permutation l m -> ForallOrdPairs related l -> ForallOrdPairs related m.
  Proof.
    intros symmetric permuted. induction permuted as [| a l m permuted IH | a b l | l m n _ IH _ IH']; intros of_l.
    - constructor.
    - inversion_clear of_l as [| ? ? first_ rest]. constructor; [| now apply IH]. now rewrite <- permuted.
    - inversion_clear of_l as [| ? ? first_ of_rest]. inversion_clear of_rest as [| ? ? second_ rest].
      inversion_clear first_ as [| ? ? related_ first_rest]. repeat (constructor; auto).
    - now apply IH', IH.
  Qed.

  Lemma parts_permute {A} (f : A -> bool) (l one other : list A) : partition f l = (one, other) ->
    Permutation (one ++ other) l.
  Proof.
    revert one other. induction l as [| a l IH]; intros one other parts; cbn [partition] in parts.
    - now injection parts as <- <-.
    - destruct (partition f l) as [one' other']. specialize (IH one' other' eq_refl).
      destruct (f a); injection parts as <- <-; [now constructor |]. rewrite <- Permutation_middle. now constructor.
  Qed.

  Lemma trees_by_place_keep (levels : nat) : forall l,
    Permutation (flat_map pieces_in (trees_by_place levels l)) (flat_map pieces_in l) /\
    (Forall (is_well_boxed D) l -> Forall (is_well_boxed D) (trees_by_place levels l)).
  Proof.
    assert (as_they_come : forall n l, Permutation (flat_map pieces_in (tree_of n l)) (flat_map pieces_in l) /\
      (Forall (is_well_boxed D) l -> Forall (is_well_boxed D) (tree_of n l))).
    { intros n l. now destruct (tree_of_keeps D n l) as [-> boxed]. }
    induction levels as [| fewer IH]; intros l; [apply as_they_come |]. cbn [trees_by_place].
    do 5 (destruct l as [| ? l]; [apply as_they_come |]). cbv zeta.
    match goal with |- context [partition ?before ?whole] => set (test := before); set (all := whole) end.
    destruct (partition test all) as [[| a one] other] eqn:parts; [apply as_they_come |].
    apply parts_permute in parts. destruct (IH (a :: one)) as [same_one boxed_one],
      (IH other) as [same_other boxed_other].
    destruct (as_they_come 1%nat (trees_by_place fewer (a :: one) ++ trees_by_place fewer other))
      as [same_both boxed_both].
    split.
    - rewrite same_both, flat_map_app, same_one, same_other, <- flat_map_app. now apply Permutation_flat_map.
    - intros boxed. rewrite <- parts in boxed. apply Forall_app in boxed. apply boxed_both, Forall_app. tauto.
  Qed.

  Lemma leaves_of_edges (es : list hedge) : flat_map pieces_in (flat_map (leaf_of D) (map piece_of_edge es)) =
    map piece_of_edge es /\
    Forall (is_well_boxed D) (flat_map (leaf_of D) (map piece_of_edge es)).
  Proof.
    induction es as [| e es [same_ boxed]]; [now repeat constructor |]. cbn [map flat_map]. split.
    - change (piece_of_edge e :: flat_map pieces_in (flat_map (leaf_of D) (map piece_of_edge es)) =
        piece_of_edge e :: map piece_of_edge es).
      now f_equal.
    - apply Forall_app. split; [apply leaf_is_well_boxed | exact boxed].
  Qed.

  Lemma all_pairs_touch (es : list hedge) : touch_at_most D es = true -> ForallOrdPairs touch (map piece_of_edge es).
  Proof.
    unfold touch_at_most. intros found. destruct (leaves_of_edges es) as [same_ boxed].
    destruct (trees_by_place_keep 64 (flat_map (leaf_of D) (map piece_of_edge es))) as [permuted all_boxed].
    specialize (all_boxed boxed). rewrite same_ in permuted.
    apply (pairs_in_another_order touch _ _) in permuted; [exact permuted | |].
    - intros g h touching e f x -> -> meet. exact (touching f e x eq_refl eq_refl (turned_pair x e f meet)).
    - destruct (trees_by_place 64 _) as [| t [| ? ?]]; [constructor | | discriminate].
      cbn [flat_map]. rewrite app_nil_r. inversion_clear all_boxed. now apply touch_in_one.
  Qed.
End Boxes.

(* A point within an edge divides it. *)
Lemma within_divides (x : point) (e : edge) : is_within x e ->
  exists t, 0 < t < 1 /\ divides (as_vector x) (homogeneous (fst e), homogeneous (snd e)) t.
Proof.
  intros [(t & range & x_is & y_is) [not_first not_second]]. exists t. cbn [x_of y_of] in x_is, y_is.
  assert (~ t == 0) by (intros zero_; apply not_first; split; rewrite ?x_is, ?y_is, zero_; ring).
  assert (~ t == 1) by (intros one_; apply not_second; split; rewrite ?x_is, ?y_is, one_; ring).
  split; [lra |]. unfold divides. cbn [fst snd].
  pose proof (homogeneous_is (fst e)) as [first_x first_y]. pose proof (homogeneous_is (snd e)) as [second_x second_y].
  split; cbn [vx vy as_vector] in *; [now rewrite first_x, second_x | now rewrite first_y, second_y].
Qed.

Lemma pairs_if_of_images {A B} (f : A -> B) (of_images : B -> B -> Prop) (related : A -> A -> Prop) (l : list A) :
  (forall a b, of_images (f a) (f b) -> related a b) -> ForallOrdPairs of_images (map f l) -> ForallOrdPairs related l.
Proof.
  intros all. induction l as [| a l IH]; intros of_l; [constructor |]. inversion_clear of_l as [| ? ? first_ rest].
  constructor; [| now apply IH]. rewrite Forall_forall in *.
  intros b I. now apply all, first_, in_map.
Qed.

(* Theorem. *)
Theorem found_edges_touch_at_most (D : positive) (r : polygonal_region) :
  touch_at_most D (hedges_of_region r) = true -> edges_touch_at_most r.
Proof.
  intros found%all_pairs_touch. unfold hedges_of_region in found. rewrite map_map in found. revert found.
  apply pairs_if_of_images. intros e f touching x [in_e in_f]. apply within_divides in in_e, in_f.
  destruct in_e as (t & t_range & on_e), in_f as (u & u_range & on_f).
  apply (touching _ _ (as_vector x) eq_refl eq_refl). now exists t, u.
Qed.
