(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* What the search for two pieces without a line between them (layout_checker.v) means: if it finds none, each two are
   apart, that is, in some direction no corner of one is farther than a corner of the other. Then points inside a piece
   are in none of the others. *)
From Coq Require Import QArith Lqa ZArith Lia Bool List Permutation.
From Oplus Require Import specification checker direction rotation angular_crossings winding_number small_numbers
  signed_crossings neighbourhoods homogeneous_points fans pieces_cover edges_beside_sums sums_are_inside
  inner_sums edges_touch_at_most layout_checker.
Import ListNotations.

Open Scope Q_scope.

(** Two pieces *)

(* In some direction no corner of t is farther than a corner of u. *)
Definition are_apart_by_a_line (t u : piece) : Prop := exists n, nonzero n /\
  forall a b, In a (corners_of t) -> In b (corners_of u) -> dot n (vector_of a) <= dot n (vector_of b).

Lemma apart_exchanged (t u : piece) : are_apart_by_a_line t u -> are_apart_by_a_line u t.
Proof.
  intros (n & some & less). exists (opposite_of n). split; [now apply opposite_is_nonzero |]. intros a b A B.
  rewrite !dot_opposite_of. specialize (less b a B A). lra.
Qed.

Definition is_piece (t : piece) : Prop := is_convex t = true /\ t = piece_of (corners_of t).

Lemma inside_is_less_far (n : vector) (k : Q) (t : piece) (x : vector) : is_piece t ->
  (forall a, In a (corners_of t) -> dot n (vector_of a) <= k) -> inside_piece t x -> dot n x <= k.
Proof.
  intros [convex lines] near in_. enough (- k <= dot (opposite_of n) x) by (rewrite dot_opposite_of in *; lra).
  apply (inside_is_as_far _ _ t); trivial. intros a A. rewrite dot_opposite_of. specialize (near a A). lra.
Qed.

(* A small step towards the inner point leads into the piece. *)
Lemma strictly_in_near (t : piece) (x : vector) (radius : Q) : is_piece t -> inside_piece t x -> 0 < radius ->
  exists y, within radius x y /\ strictly_in t y.
Proof.
  intros [convex its] in_ R. set (z := vector_of (inner t)).
  destruct (some_small _ (eventually_and _ _ (small_steps_stay_within radius x (Vector (vx z - vx x) (vy z - vy x)) R)
    (eventually_below 1 ltac:(reflexivity)))) as (e & E & close & below).
  eexists. split; [exact close |]. intros l L. specialize (in_ l L).
  pose proof (inner_is_strictly_in t convex its l L) as at_z. fold z in at_z.
  unfold value_at, moved_along in *. cbn [vx vy] in *. nra.
Qed.

(* Pieces that are apart from it have no such points. *)
Lemma strictly_in_alone (t u : piece) (y : vector) : is_piece t -> is_piece u -> are_apart_by_a_line t u ->
  strictly_in t y -> ~ inside_piece u y.
Proof.
  intros T U (n & some & less) strict in_u.
  assert (near : forall a, In a (corners_of t) -> dot n (vector_of a) <= dot n y)
    by (intros a A; apply (inside_is_as_far n _ u); [apply U .. | auto | exact in_u]).
  destruct (some_small _ (stays_strictly_in t y n strict)) as (e & E & stays).
  pose proof (inside_is_less_far n _ t _ T near (strictly_in_is_inside t _ stays)) as no_farther.
  pose proof (square_positive n some). unfold moved_along, dot in *. cbn [vx vy] in *. nra.
Qed.

(** The search *)

Lemma side_is_apart (t u : piece) : is_piece t -> is_right_of_a_side t u = true -> are_apart_by_a_line u t.
Proof.
  intros [convex lines] (l & L & right_)%existsb_exists. rewrite forallb_forall in right_.
  exists (normal_of l). split; [now apply (side_line_has_a_normal t) |]. intros b a B A.
  specialize (right_ b B). apply Z.leb_le, value_not_positive in right_.
  pose proof (corners_are_inside t a convex A l L) as left_. rewrite value_at_is in *. lra.
Qed.

Lemma separate_is_apart (t u : piece) : is_piece t -> is_piece u -> are_separate t u = true -> are_apart_by_a_line t u.
Proof.
  intros T U [found | found]%orb_true_iff; [apply apart_exchanged |]; now apply side_is_apart.
Qed.

Section Boxes.
  Variable D : positive.

  Lemma boxes_are_apart (t u : tree) : is_well_boxed D t -> is_well_boxed D u ->
    are_boxes_separate (box_of t) (box_of u) = true ->
    forall a b, In a (pieces_in t) -> In b (pieces_in u) -> are_apart_by_a_line a b.
  Proof.
    intros boxed_t%well_boxed_has boxed_u%well_boxed_has separate a b A B.
    assert (by_direction : forall n, nonzero n -> (forall c d, in_box D (box_of t) c -> in_box D (box_of u) d ->
      dot n c * inject_Z (Zpos D) <= dot n d * inject_Z (Zpos D)) -> are_apart_by_a_line a b).
    { intros n some less. exists n. split; [exact some |]. intros c d C E. apply (no_more_in_units D).
      apply less; [exact (boxed_t a c A C) | exact (boxed_u b d B E)]. }
    unfold are_boxes_separate in separate. rewrite !orb_true_iff, !Z.leb_le, !Zle_Qle in separate.
    destruct separate as [[[less | less] | less] | less];
      [apply (by_direction (Vector 1 0)) | apply (by_direction (Vector (-1) 0)) | apply (by_direction (Vector 0 1)) |
       apply (by_direction (Vector 0 (-1)))]; try (now intros [? ?]); intros c d [X Y] [X' Y'];
      unfold dot; cbn [vx vy]; lra.
  Qed.

  Lemma overlap_of_trees_is (t u : tree) : overlap_of_trees t u =
    if are_boxes_separate (box_of t) (box_of u) then None
    else
      match t, u with
      | Leaf _ a, Leaf _ b => if are_separate a b then None else Some (a, b)
      | Leaf _ _, Node _ u1 u2 => match overlap_of_trees t u1 with None => overlap_of_trees t u2 | found => found end
      | Node _ t1 t2, Leaf _ _ => match overlap_of_trees t1 u with None => overlap_of_trees t2 u | found => found end
      | Node b t1 t2, Node c u1 u2 =>
        if is_larger b c then match overlap_of_trees t1 u with None => overlap_of_trees t2 u | found => found end
        else match overlap_of_trees t u1 with None => overlap_of_trees t u2 | found => found end
      end.
  Proof. destruct t, u; reflexivity. Qed.

  Lemma apart_if_none_found (t : tree) : forall u, is_well_boxed D t -> is_well_boxed D u ->
    Forall is_piece (pieces_in t) -> Forall is_piece (pieces_in u) -> overlap_of_trees t u = None ->
    forall a b, In a (pieces_in t) -> In b (pieces_in u) -> are_apart_by_a_line a b.
  Proof.
    assert (of_both : forall (P : piece -> Prop) one other, (forall a, In a one -> P a) ->
      (forall a, In a other -> P a) -> forall a, In a (one ++ other) -> P a)
      by (intros P one other all all' a [A | A]%in_app_or; auto).
    induction t as [c g | c t1 IH1 t2 IH2]; induction u as [d h | d u1 IHu1 u2 IHu2];
      intros boxed_t boxed_u T U none; pose proof (boxes_are_apart _ _ boxed_t boxed_u) as by_boxes;
      rewrite overlap_of_trees_is in none;
      (destruct (are_boxes_separate _ _); [now apply by_boxes |]); clear by_boxes;
      try (pose proof boxed_t as (_ & boxed_t1 & boxed_t2); pose proof T as [T1 T2]%Forall_app);
      try (pose proof boxed_u as (_ & boxed_u1 & boxed_u2); pose proof U as [U1 U2]%Forall_app).
    - inversion_clear T. inversion_clear U. destruct (are_separate g h) eqn:separate; [| discriminate].
      intros a b [<- | []] [<- | []]. now apply separate_is_apart.
    - destruct (overlap_of_trees (Leaf c g) u1) eqn:first_; [discriminate |].
      intros a b A. revert b. apply of_both; intros b B; [now apply IHu1 | now apply IHu2].
    - destruct (overlap_of_trees t1 (Leaf d h)) eqn:first_; [discriminate |].
      intros a b A B. revert a A.
      apply of_both; intros a A; [now apply (IH1 (Leaf d h)) | now apply (IH2 (Leaf d h))].
    - destruct (is_larger c d).
      + destruct (overlap_of_trees t1 (Node d u1 u2)) eqn:first_; [discriminate |]. intros a b A B. revert a A.
        apply of_both; intros a A; [now apply (IH1 (Node d u1 u2)) | now apply (IH2 (Node d u1 u2))].
      + destruct (overlap_of_trees (Node c t1 t2) u1) eqn:first_; [discriminate |]. intros a b A. revert b.
        apply of_both; intros b B; [now apply IHu1 | now apply IHu2].
  Qed.

  Lemma apart_in_one (t : tree) : is_well_boxed D t -> Forall is_piece (pieces_in t) -> overlap_in_tree t = None ->
    ForallOrdPairs are_apart_by_a_line (pieces_in t).
  Proof.
    induction t as [b g | b one IH_one other IH_other]; intros boxed all none; [repeat constructor |].
    destruct boxed as (_ & boxed_one & boxed_other). cbn [overlap_in_tree pieces_in] in *. apply Forall_app in all.
    destruct all as [of_one of_other], (overlap_in_tree one), (overlap_in_tree other); try discriminate.
    apply pairs_of_both; [now apply IH_one | now apply IH_other | now apply apart_if_none_found].
  Qed.

  Lemma leaves_of_pieces (pieces : list piece) : Forall is_piece pieces ->
    flat_map pieces_in (flat_map (leaf_of D) pieces) = pieces /\ Forall (is_well_boxed D) (flat_map (leaf_of D) pieces).
  Proof.
    induction pieces as [| t l IH]; intros all; [now repeat constructor |]. inversion_clear all as [| ? ? T L].
    destruct (IH L) as [same_ boxed]. cbn [flat_map]. split.
    - unfold leaf_of at 1. pose proof (convex_has_corners t (proj1 T)). destruct (corners_of t); [easy |].
      cbn [app flat_map pieces_in]. now f_equal.
    - apply Forall_app. split; [apply leaf_is_well_boxed | exact boxed].
  Qed.

  Lemma one_tree (rest : list tree) : forall t, Forall (is_well_boxed D) (t :: rest) ->
    is_well_boxed D (fold_left tree_of_both rest t) /\
    pieces_in (fold_left tree_of_both rest t) = flat_map pieces_in (t :: rest).
  Proof.
    induction rest as [| u rest IH]; intros t all; inversion_clear all as [| ? ? T others].
    - cbn. now rewrite app_nil_r.
    - inversion_clear others as [| ? ? U more]. destruct (IH (tree_of_both t u)) as [boxed same_];
        [constructor; [now apply node_is_well_boxed | exact more] |]. cbn [fold_left]. split; [exact boxed |].
      rewrite same_. cbn [flat_map tree_of_both pieces_in]. now rewrite app_assoc.
  Qed.

  (* Theorem. If the search finds no two pieces, all are apart. *)
  Theorem no_overlap_is_found (pieces : list piece) : Forall is_piece pieces -> found_overlap D pieces = None ->
    ForallOrdPairs are_apart_by_a_line pieces.
  Proof.
    unfold found_overlap. intros all none. destruct (leaves_of_pieces pieces all) as [same_ boxed].
    destruct (trees_by_place_keep D 64 (flat_map (leaf_of D) pieces)) as [permuted all_boxed].
    specialize (all_boxed boxed). rewrite same_ in permuted.
    apply (pairs_in_another_order are_apart_by_a_line _ _ apart_exchanged permuted).
    destruct (trees_by_place 64 _) as [| t rest]; [constructor |].
    destruct (one_tree rest t all_boxed) as [its_boxes its_pieces]. rewrite <- its_pieces in *.
    apply apart_in_one; trivial. apply Forall_forall. intros a A. rewrite Forall_forall in all.
    exact (all a (Permutation_in _ permuted A)).
  Qed.
End Boxes.
