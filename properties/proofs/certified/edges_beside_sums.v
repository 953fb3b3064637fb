(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* What the checker's search of two trees of boxes means (`are_apart` in checker.v): if it succeeds for an edge, then for
   every piece in the one tree and every piece in the other there is a direction in which both ends of the edge are at most
   as far as every sum of two corners of the pieces. Trees made by `trees_of` have all pieces that have corners. *)
From Coq Require Import QArith Lqa Qfield ZArith Lia Bool List.
From Oplus Require Import direction angular_crossings winding_number specification checker homogeneous_points fans.
Import ListNotations.

Open Scope Q_scope.

(** Lines *)

Definition normal_of (l : line) : vector := Vector (inject_Z (la l)) (inject_Z (lb l)).

Lemma value_at_is (l : line) (x : vector) : value_at l x == dot (normal_of l) x + inject_Z (lc l).
Proof. unfold value_at, dot, normal_of. cbn [vx vy]. ring. Qed.

Lemma dot_added (n a b : vector) : dot n (added a b) == dot n a + dot n b.
Proof. unfold dot, added. cbn [vx vy]. ring. Qed.

Lemma dot_of_equal (n a b : vector) : equal_vectors a b -> dot n a == dot n b.
Proof. intros [x_is y_is]. unfold dot. now rewrite x_is, y_is. Qed.

Definition opposite_of (n : vector) : vector := Vector (- vx n) (- vy n).

Lemma dot_opposite_of (n a : vector) : dot (opposite_of n) a == - dot n a.
Proof. unfold dot, opposite_of. cbn [vx vy]. ring. Qed.

Lemma opposite_is_nonzero (n : vector) : nonzero n -> nonzero (opposite_of n).
Proof. unfold nonzero, opposite_of. cbn [vx vy]. intros some [x_is y_is]. apply some. split; lra. Qed.

Lemma line_has_a_normal (p q : hpoint) :
  ~ equal_vectors (vector_of p) (vector_of q) -> nonzero (normal_of (line_through p q)).
Proof.
  unfold equal_vectors, nonzero, normal_of, line_through, vector_of, Qeq, inject_Z.
  cbn [vx vy la lb Qnum Qden]. intros apart [x_is y_is]. apply apart. split; lia.
Qed.

Lemma value_at_first (p q : hpoint) : value_at (line_through p q) (vector_of p) == 0.
Proof. rewrite value_of_line_through. unfold turn_of. ring. Qed.

Lemma value_at_second (p q : hpoint) : value_at (line_through p q) (vector_of q) == 0.
Proof. rewrite value_of_line_through. unfold turn_of. ring. Qed.

(* The line along an edge is one, and both ends are on it. *)
Lemma line_along_is (e : hedge) : nonzero (normal_of (line_along e)) /\
  value_at (line_along e) (vector_of (fst e)) == 0 /\ value_at (line_along e) (vector_of (snd e)) == 0.
Proof.
  unfold line_along.
  destruct (Z.eqb_spec (la (line_through (fst e) (snd e))) 0) as [x_is |]; cbn [andb];
    [destruct (Z.eqb_spec (lb (line_through (fst e) (snd e))) 0) as [y_is |] |].
  - cbn [la lb lc line_through] in x_is, y_is. rewrite <- !value_zero. unfold nonzero, normal_of, value, Qeq, inject_Z.
    cbn [vx vy la lb lc Qnum Qden]. lia.
  - split; [| split; [apply value_at_first | apply value_at_second]].
    unfold nonzero, normal_of, Qeq, inject_Z. cbn [vx vy Qnum Qden]. lia.
  - split; [| split; [apply value_at_first | apply value_at_second]].
    unfold nonzero, normal_of, Qeq, inject_Z. cbn [vx vy Qnum Qden]. lia.
Qed.

(* A left turn has no two equal corners. *)
Lemma left_turn_is_proper (a b c : hpoint) : (0 < left_turn a b c)%Z ->
  ~ equal_vectors (vector_of a) (vector_of b) /\ ~ equal_vectors (vector_of b) (vector_of c) /\
  ~ equal_vectors (vector_of c) (vector_of a).
Proof.
  rewrite left_turn_is_positive. unfold turn_of. intros left_.
  repeat split; intros [x_is y_is]; rewrite ?x_is, ?y_is in left_; ring_simplify in left_; lra.
Qed.

Lemma sides_of_a_fan (first : hpoint) (rest : polygon) : forall b,
  fan_turns_left first (b :: rest) = true -> ~ equal_vectors (vector_of b) (vector_of first) ->
  forall s, In s (combine (b :: rest) (rest ++ [first])) -> ~ equal_vectors (vector_of (fst s)) (vector_of (snd s)).
Proof.
  induction rest as [| c rest IH]; intros b fan apart s.
  - intros [<- | []]. exact apart.
  - cbn [fan_turns_left] in fan. apply andb_true_iff in fan. destruct fan as [turn_ fan]. apply Z.ltb_lt in turn_.
    apply left_turn_is_proper in turn_. destruct turn_ as (_ & b_c & c_first).
    intros [<- | I]; [exact b_c |]. now apply (IH c).
Qed.

Lemma sides_are_proper (v : polygon) : has_a_fan v = true ->
  forall s, In s (sides v) -> ~ equal_vectors (vector_of (fst s)) (vector_of (snd s)).
Proof.
  destruct v as [| first [| b [| c rest]]]; try discriminate. intros fan s I.
  change (has_a_fan (first :: b :: c :: rest)) with (fan_turns_left first (b :: c :: rest)) in fan.
  pose proof fan as turn_. cbn [fan_turns_left] in turn_. apply andb_true_iff in turn_. destruct turn_ as [turn_ _].
  apply Z.ltb_lt, left_turn_is_proper in turn_. destruct turn_ as (first_b & _ & _).
  destruct I as [<- | I]; [exact first_b |].
  apply (sides_of_a_fan first (c :: rest) b fan); [| exact I].
  intros equal_. apply first_b. now symmetry.
Qed.

Lemma side_line_has_a_normal (t : piece) : is_convex t = true -> t = piece_of (corners_of t) ->
  forall l, In l (side_lines t) -> nonzero (normal_of l).
Proof.
  intros convex lines l I. rewrite lines in I. cbn [side_lines piece_of] in I. apply in_map_iff in I.
  destruct I as (s & <- & I). apply line_has_a_normal. apply (sides_are_proper (corners_of t)); [| exact I].
  unfold is_convex in convex. now apply andb_true_iff in convex.
Qed.

(** Edges beside sums of pieces *)

(* No sum of corners is less far in this direction than the ends of the edge. *)
Definition is_beside (n : vector) (e : hedge) (t u : piece) : Prop := forall a b, In a (corners_of t) -> In b (corners_of u) ->
  dot n (vector_of (fst e)) <= dot n (added (vector_of a) (vector_of b)) /\
  dot n (vector_of (snd e)) <= dot n (added (vector_of a) (vector_of b)).

Definition are_beside (e : hedge) (t u : piece) : Prop := exists n, nonzero n /\ is_beside n e t u.

Lemma are_beside_exchanged (e : hedge) (t u : piece) : are_beside e u t -> are_beside e t u.
Proof.
  intros (n & some & beside). exists n. split; [exact some |]. intros a b A B.
  specialize (beside b a B A). rewrite dot_added in *. lra.
Qed.

(* Both ends are on the edge's line: it is enough that all sums are on one side of it. *)
Section Line.
  Variables (e : hedge) (t u : piece).

  Let l : line := line_along e.

  Lemma beside_if_left :
    (forall a b, In a (corners_of t) -> In b (corners_of u) -> 0 <= value_at l (added (vector_of a) (vector_of b))) ->
    are_beside e t u.
  Proof.
    intros left_. destruct (line_along_is e) as (some & first & second). exists (normal_of l).
    split; [exact some |]. intros a b A B.
    specialize (left_ a b A B). rewrite value_at_is in left_.
    fold l in first, second. rewrite value_at_is in first, second. lra.
  Qed.

  Lemma beside_if_right :
    (forall a b, In a (corners_of t) -> In b (corners_of u) -> value_at l (added (vector_of a) (vector_of b)) <= 0) ->
    are_beside e t u.
  Proof.
    intros right_. destruct (line_along_is e) as (some & first & second). exists (opposite_of (normal_of l)).
    split; [now apply opposite_is_nonzero |].
    intros a b A B. rewrite !dot_opposite_of.
    specialize (right_ a b A B). rewrite value_at_is in right_.
    fold l in first, second. rewrite value_at_is in first, second. lra.
  Qed.
End Line.

Lemma value_at_of_equal (l : line) (x y : vector) : equal_vectors x y -> value_at l x == value_at l y.
Proof. intros same_. rewrite !value_at_is. now rewrite (dot_of_equal _ x y same_). Qed.

Lemma all_sums (test : hpoint -> bool) (t u : piece) : are_all_sums test t u = true ->
  forall a b, In a (corners_of t) -> In b (corners_of u) -> test (hplus a b) = true.
Proof.
  unfold are_all_sums. rewrite forallb_forall. intros all a b A B. specialize (all a A).
  rewrite forallb_forall in all. now apply all.
Qed.

(* Beyond the line of a side of t: all of t is to the left of it, and what is left of the edge without u to the right. *)
Lemma beside_if_beyond_a_side (D : positive) (e : hedge) (t u : piece) :
  is_convex t = true -> t = piece_of (corners_of t) -> is_beyond_a_side (placed_hedge D e) t u = true -> are_beside e t u.
Proof.
  intros convex lines beyond. unfold is_beyond_a_side in beyond. apply existsb_exists in beyond.
  destruct beyond as (l & L & beyond). rewrite forallb_forall in beyond.
  exists (normal_of l). split; [now apply (side_line_has_a_normal t) |]. intros a b A B.
  pose proof (corners_are_inside t a convex A l L) as left_. specialize (beyond b B).
  apply andb_true_iff in beyond. rewrite !Z.leb_le, !value_not_positive in beyond. cbn [from to placed_hedge] in beyond.
  rewrite !value_at_is in *.
  rewrite <- (dot_of_equal _ _ _ (vector_of_minus (fst e) b)), <- (dot_of_equal _ _ _ (vector_of_minus (snd e) b)).
  rewrite !dot_added. lra.
Qed.

Lemma beside_if_pieces_are_apart (D : positive) (e : hedge) (t u : piece) :
  is_convex t = true -> t = piece_of (corners_of t) -> is_convex u = true -> u = piece_of (corners_of u) ->
  are_pieces_apart (placed_hedge D e) t u = true -> are_beside e t u.
Proof.
  intros t_convex t_lines u_convex u_lines apart. unfold are_pieces_apart in apart.
  rewrite !orb_true_iff in apart. destruct apart as [[[left_ | right_] | beyond] | beyond].
  - apply beside_if_left. intros a b A B. pose proof (all_sums _ t u left_ a b A B) as sign.
    cbv beta in sign. apply Z.leb_le, value_not_negative in sign.
    now rewrite (value_at_of_equal _ _ _ (vector_of_plus a b)) in sign.
  - apply beside_if_right. intros a b A B. pose proof (all_sums _ t u right_ a b A B) as sign.
    cbv beta in sign. apply Z.leb_le, value_not_positive in sign.
    now rewrite (value_at_of_equal _ _ _ (vector_of_plus a b)) in sign.
  - now apply (beside_if_beyond_a_side D).
  - now apply are_beside_exchanged, (beside_if_beyond_a_side D).
Qed.

(** Boxes *)

Section Boxes.
  Variable D : positive.

  Let unit_ : Q := inject_Z (Zpos D).

  Definition in_box (b : bounding_box) (x : vector) : Prop :=
    (inject_Z (x_low b) <= vx x * unit_ <= inject_Z (x_high b)) /\
    (inject_Z (y_low b) <= vy x * unit_ <= inject_Z (y_high b)).

  Lemma rounded_down_is_below (n : Z) (w : positive) : inject_Z (rounded_down D n w) <= (n # w) * unit_.
  Proof.
    unfold rounded_down, unit_, Qle, Qmult, inject_Z. cbn [Qnum Qden]. rewrite Pos.mul_1_r.
    pose proof (Z.mul_div_le (n * Zpos D) (Zpos w) eq_refl). lia.
  Qed.

  Lemma rounded_up_is_above (n : Z) (w : positive) : (n # w) * unit_ <= inject_Z (rounded_up D n w).
  Proof.
    unfold rounded_up, unit_, Qle, Qmult, inject_Z. cbn [Qnum Qden]. rewrite Pos.mul_1_r.
    pose proof (Z.mul_div_le (- n * Zpos D) (Zpos w) eq_refl). lia.
  Qed.

  Lemma in_box_of_point (p : hpoint) : in_box (box_of_point D p) (vector_of p).
  Proof.
    unfold in_box, box_of_point, vector_of. cbn [x_low x_high y_low y_high vx vy].
    repeat split; first [apply rounded_down_is_below | apply rounded_up_is_above].
  Qed.

  Lemma in_box_of_both (a b : bounding_box) (x : vector) : in_box a x \/ in_box b x -> in_box (box_of_both a b) x.
  Proof.
    unfold in_box, box_of_both. cbn [x_low x_high y_low y_high].
    intros [[X Y] | [X Y]]; (split; split);
      try (eapply Qle_trans; [rewrite <- Zle_Qle | apply X]; lia);
      try (eapply Qle_trans; [rewrite <- Zle_Qle | apply Y]; lia);
      try (eapply Qle_trans; [apply X | rewrite <- Zle_Qle]; lia);
      try (eapply Qle_trans; [apply Y | rewrite <- Zle_Qle]; lia).
  Qed.

  Lemma in_box_of_points (first : hpoint) (rest : list hpoint) :
    forall p, In p (first :: rest) -> in_box (box_of_points D first rest) (vector_of p).
  Proof.
    assert (grown : forall points start x, in_box start x \/ (exists p, In p points /\ x = vector_of p) ->
      in_box (fold_left (fun b p => box_of_both b (box_of_point D p)) points start) x).
    { induction points as [| q points IH]; intros start x there; cbn [fold_left].
      - now destruct there as [| (p & [] & _)].
      - apply IH. destruct there as [there | (p & [-> | I] & ->)].
        + left. apply in_box_of_both. now left.
        + left. apply in_box_of_both. right. apply in_box_of_point.
        + right. now exists p. }
    intros p [<- | I]; apply grown; [left; apply in_box_of_point | right; now exists p].
  Qed.

  (** Trees *)

  Fixpoint pieces_in (t : tree) : list piece :=
    match t with Leaf _ piece_ => [piece_] | Node _ one other => pieces_in one ++ pieces_in other end.

  Definition has_in_its_box (t : tree) : Prop :=
    forall piece_ a, In piece_ (pieces_in t) -> In a (corners_of piece_) -> in_box (box_of t) (vector_of a).

  Fixpoint is_well_boxed (t : tree) : Prop :=
    has_in_its_box t /\
    match t with Leaf _ _ => True | Node _ one other => is_well_boxed one /\ is_well_boxed other end.

  Lemma well_boxed_has (t : tree) : is_well_boxed t -> has_in_its_box t.
  Proof. destruct t; intros [there _]; exact there. Qed.

  Lemma leaf_is_well_boxed (t : piece) : Forall is_well_boxed (leaf_of D t).
  Proof.
    unfold leaf_of. destruct (corners_of t) as [| first rest] eqn:these; constructor; [| constructor].
    cbn. split; [| trivial]. intros piece_ a [<- | []] A. rewrite these in A. now apply in_box_of_points.
  Qed.

  Lemma node_is_well_boxed (a b : tree) : is_well_boxed a -> is_well_boxed b -> is_well_boxed (tree_of_both a b).
  Proof.
    intros A B. cbn. split; [| now split]. intros piece_ x I X. cbn [pieces_in tree_of_both] in I. cbn [box_of tree_of_both].
    apply in_box_of_both. apply in_app_iff in I. destruct I as [I | I]; [left | right].
    - now apply (well_boxed_has a A piece_).
    - now apply (well_boxed_has b B piece_).
  Qed.

  Lemma paired_keeps : forall l : list tree,
    flat_map pieces_in (paired l) = flat_map pieces_in l /\ (Forall is_well_boxed l -> Forall is_well_boxed (paired l)).
  Proof.
    fix IH 1. intros [| a [| b rest]]; [split; trivial .. |].
    destruct (IH rest) as [same_ boxed]. split.
    - cbn [paired flat_map pieces_in tree_of_both]. now rewrite same_, app_assoc.
    - intros all. cbn [paired]. inversion all as [| ? ? A all_more]. inversion all_more as [| ? ? B all_rest].
      constructor; [now apply node_is_well_boxed | now apply boxed].
  Qed.

  Lemma tree_of_keeps (levels : nat) : forall l,
    flat_map pieces_in (tree_of levels l) = flat_map pieces_in l /\
    (Forall is_well_boxed l -> Forall is_well_boxed (tree_of levels l)).
  Proof.
    induction levels as [| fewer IH]; intros l; [now split |].
    destruct l as [| a [| b rest]]; [now split .. |]. cbn [tree_of].
    destruct (IH (paired (a :: b :: rest))) as [same_ boxed].
    destruct (paired_keeps (a :: b :: rest)) as [same_paired boxed_pairs].
    split; [now rewrite same_ | intros all; now apply boxed, boxed_pairs].
  Qed.

  Lemma pieces_in_leaves (pieces : list piece) (t : piece) :
    In t pieces -> corners_of t <> [] -> In t (flat_map pieces_in (flat_map (leaf_of D) pieces)).
  Proof.
    intros I some. apply in_flat_map. unfold leaf_of. destruct (corners_of t) as [| first rest] eqn:these; [easy |].
    exists (Leaf (box_of_points D first rest) t). split; [| now left].
    apply in_flat_map. exists t. split; [exact I |]. rewrite these. now left.
  Qed.

  (* Every piece that has a corner is in one of the trees, all the boxes of which have in them what they should. *)
  Theorem trees_have_all_pieces (pieces : list piece) (t : piece) : In t pieces -> corners_of t <> [] ->
    exists its_tree, In its_tree (trees_of D pieces) /\ In t (pieces_in its_tree) /\ is_well_boxed its_tree.
  Proof.
    intros I some. pose proof (pieces_in_leaves pieces t I some) as there.
    unfold trees_of. destruct (tree_of_keeps (length (flat_map (leaf_of D) pieces)) (flat_map (leaf_of D) pieces))
      as [same_ boxed].
    rewrite <- same_ in there. apply in_flat_map in there. destruct there as (its_tree & T & there).
    exists its_tree. split; [exact T |]. split; [exact there |].
    assert (all : Forall is_well_boxed (flat_map (leaf_of D) pieces)).
    { clear. induction pieces as [| t rest IH]; [constructor |]. cbn [flat_map]. apply Forall_app.
      split; [apply leaf_is_well_boxed | exact IH]. }
    apply boxed in all. rewrite Forall_forall in all. now apply all.
  Qed.

  Lemma trees_have_only_pieces (pieces : list piece) (its_tree : tree) (t : piece) :
    In its_tree (trees_of D pieces) -> In t (pieces_in its_tree) -> In t pieces.
  Proof.
    intros T I. assert (there : In t (flat_map pieces_in (trees_of D pieces))) by (apply in_flat_map; now exists its_tree).
    unfold trees_of in there.
    destruct (tree_of_keeps (length (flat_map (leaf_of D) pieces)) (flat_map (leaf_of D) pieces)) as [same_ _].
    rewrite same_ in there. apply in_flat_map in there. destruct there as (leaf & L & there).
    apply in_flat_map in L. destruct L as (u & U & L). unfold leaf_of in L.
    destruct (corners_of u) as [| first rest]; [easy |]. destruct L as [<- | []]. now destruct there as [<- | []].
  Qed.

  (** The search *)

  (* A multiple of a number between two others is at least that of the one of them that the factor's sign chooses. *)
  Lemma least_multiple (f low high : Z) (x : Q) : inject_Z low <= x <= inject_Z high ->
    inject_Z (f * (if (0 <=? f)%Z then low else high)) <= inject_Z f * x.
  Proof.
    intros range. rewrite inject_Z_mult. destruct (Z.leb_spec 0 f) as [sign | sign].
    - rewrite Zle_Qle in sign. change (inject_Z 0) with 0 in sign. nra.
    - rewrite Zlt_Qlt in sign. change (inject_Z 0) with 0 in sign. nra.
  Qed.

  Lemma greatest_multiple (f low high : Z) (x : Q) : inject_Z low <= x <= inject_Z high ->
    inject_Z f * x <= inject_Z (f * (if (0 <=? f)%Z then high else low)).
  Proof.
    intros range. rewrite inject_Z_mult. destruct (Z.leb_spec 0 f) as [sign | sign].
    - rewrite Zle_Qle in sign. change (inject_Z 0) with 0 in sign. nra.
    - rewrite Zlt_Qlt in sign. change (inject_Z 0) with 0 in sign. nra.
  Qed.

  Lemma no_more_in_units (x y : Q) : x * unit_ <= y * unit_ -> x <= y.
  Proof. apply Qmult_le_r. reflexivity. Qed.

  Lemma beside_if_boxes_are_apart (e : hedge) (t u : piece) (b c : bounding_box) :
    (forall a, In a (corners_of t) -> in_box b (vector_of a)) -> (forall a, In a (corners_of u) -> in_box c (vector_of a)) ->
    are_boxes_apart D (placed_hedge D e) b c = true -> are_beside e t u.
  Proof.
    intros t_in u_in apart.
    assert (range : forall a a', In a (corners_of t) -> In a' (corners_of u) ->
      (inject_Z (x_low b + x_low c) <= (vx (vector_of a) + vx (vector_of a')) * unit_ <= inject_Z (x_high b + x_high c)) /\
      (inject_Z (y_low b + y_low c) <= (vy (vector_of a) + vy (vector_of a')) * unit_ <= inject_Z (y_high b + y_high c))).
    { intros a a' A A'. destruct (t_in a A) as [X Y]. destruct (u_in a' A') as [X' Y']. rewrite !inject_Z_plus. lra. }
    pose proof (in_box_of_points (fst e) [snd e] (fst e) (or_introl eq_refl)) as [first_x first_y].
    pose proof (in_box_of_points (fst e) [snd e] (snd e) (or_intror (or_introl eq_refl))) as [second_x second_y].
    unfold are_boxes_apart in apart. cbn [edge_box edge_line placed_hedge] in apart.
    set (f := box_of_points D (fst e) [snd e]) in *. set (l := line_along e) in *.
    set (x0 := (x_low b + x_low c)%Z) in *. set (x1 := (x_high b + x_high c)%Z) in *.
    set (y0 := (y_low b + y_low c)%Z) in *. set (y1 := (y_high b + y_high c)%Z) in *.
    rewrite !orb_true_iff, !Z.leb_le in apart.
    assert (by_direction : forall n, nonzero n -> (forall a a', In a (corners_of t) -> In a' (corners_of u) ->
      dot n (vector_of (fst e)) * unit_ <= dot n (added (vector_of a) (vector_of a')) * unit_ /\
      dot n (vector_of (snd e)) * unit_ <= dot n (added (vector_of a) (vector_of a')) * unit_) -> are_beside e t u).
    { intros n some less. exists n. split; [exact some |]. intros a a' A A'. specialize (less a a' A A').
      split; now apply no_more_in_units. }
    assert (in_units : forall a a', value_at l (added (vector_of a) (vector_of a')) * unit_ ==
      inject_Z (la l) * ((vx (vector_of a) + vx (vector_of a')) * unit_) +
      inject_Z (lb l) * ((vy (vector_of a) + vy (vector_of a')) * unit_) + inject_Z (lc l * Zpos D)).
    { intros a a'. rewrite inject_Z_mult. fold unit_. unfold value_at, added. cbn [vx vy]. ring. }
    destruct apart as [[[[apart | apart] | apart] | apart] | [apart | apart]].
    - apply (by_direction (Vector 1 0)); [now intros [? ?] |]. intros a a' A A'. destruct (range a a' A A') as [X Y].
      rewrite Zle_Qle in apart. unfold dot, added. cbn [vx vy]. split; lra.
    - apply (by_direction (Vector (-1) 0)); [now intros [? ?] |]. intros a a' A A'. destruct (range a a' A A') as [X Y].
      rewrite Zle_Qle in apart. unfold dot, added. cbn [vx vy]. split; lra.
    - apply (by_direction (Vector 0 1)); [now intros [? ?] |]. intros a a' A A'. destruct (range a a' A A') as [X Y].
      rewrite Zle_Qle in apart. unfold dot, added. cbn [vx vy]. split; lra.
    - apply (by_direction (Vector 0 (-1))); [now intros [? ?] |]. intros a a' A A'. destruct (range a a' A A') as [X Y].
      rewrite Zle_Qle in apart. unfold dot, added. cbn [vx vy]. split; lra.
    - apply beside_if_left. intros a a' A A'. destruct (range a a' A A') as [X Y].
      apply no_more_in_units. fold l. rewrite in_units.
      pose proof (least_multiple (la l) _ _ _ X). pose proof (least_multiple (lb l) _ _ _ Y).
      rewrite Zle_Qle, !inject_Z_plus in apart. change (inject_Z 0) with 0 in apart. lra.
    - apply beside_if_right. intros a a' A A'. destruct (range a a' A A') as [X Y].
      apply no_more_in_units. fold l. rewrite in_units.
      pose proof (greatest_multiple (la l) _ _ _ X). pose proof (greatest_multiple (lb l) _ _ _ Y).
      rewrite Zle_Qle, !inject_Z_plus in apart. change (inject_Z 0) with 0 in apart. lra.
  Qed.

  Lemma are_apart_is (e : placed_edge) (t u : tree) :
    are_trees_apart D e t u =
    are_boxes_apart D e (box_of t) (box_of u) ||
    match t, u with
    | Leaf _ a, Leaf _ b => are_pieces_apart e a b
    | Leaf _ _, Node _ u1 u2 => are_trees_apart D e t u1 && are_trees_apart D e t u2
    | Node _ t1 t2, Leaf _ _ => are_trees_apart D e t1 u && are_trees_apart D e t2 u
    | Node b t1 t2, Node c u1 u2 =>
      if is_larger b c then are_trees_apart D e t1 u && are_trees_apart D e t2 u else are_trees_apart D e t u1 && are_trees_apart D e t u2
    end.
  Proof. destruct t, u; reflexivity. Qed.

  (* Theorem. If the search of two trees succeeds for an edge, it is beside all sums of pieces of the one and the other. *)
  Theorem search_finds_directions (e : hedge) : forall t u : tree,
    (forall a, In a (pieces_in t) -> is_convex a = true /\ a = piece_of (corners_of a)) ->
    (forall b, In b (pieces_in u) -> is_convex b = true /\ b = piece_of (corners_of b)) ->
    is_well_boxed t -> is_well_boxed u -> are_trees_apart D (placed_hedge D e) t u = true ->
    forall a b, In a (pieces_in t) -> In b (pieces_in u) -> are_beside e a b.
  Proof.
    induction t as [tb ta | tb t1 IH1 t2 IH2]; induction u as [ub ua | ub u1 IHu1 u2 IHu2];
      intros t_convex u_convex t_boxed u_boxed apart a b A B; rewrite are_apart_is in apart;
      apply orb_true_iff in apart; (destruct apart as [apart | apart];
      [eapply beside_if_boxes_are_apart with (b := box_of _) (c := box_of _); [| | exact apart];
        intros x X; [exact (well_boxed_has _ t_boxed a x A X) | exact (well_boxed_has _ u_boxed b x B X)] |]).
    - destruct A as [<- | []], B as [<- | []]. destruct (t_convex ta (or_introl eq_refl)), (u_convex ua (or_introl eq_refl)).
      now apply (beside_if_pieces_are_apart D).
    - apply andb_true_iff in apart. destruct apart as [one other]. destruct u_boxed as (_ & boxed_1 & boxed_2).
      cbn [pieces_in] in B. apply in_app_iff in B.
      destruct B as [B | B]; [apply IHu1 | apply IHu2]; trivial; intros c C; apply u_convex; apply in_app_iff; tauto.
    - apply andb_true_iff in apart. destruct apart as [one other]. destruct t_boxed as (_ & boxed_1 & boxed_2).
      cbn [pieces_in] in A. apply in_app_iff in A.
      destruct A as [A | A]; [apply (IH1 (Leaf ub ua)) | apply (IH2 (Leaf ub ua))]; trivial;
        intros c C; apply t_convex; apply in_app_iff; tauto.
    - destruct (is_larger tb ub); apply andb_true_iff in apart; destruct apart as [one other].
      + destruct t_boxed as (_ & boxed_1 & boxed_2). cbn [pieces_in] in A. apply in_app_iff in A.
        destruct A as [A | A]; [apply (IH1 (Node ub u1 u2)) | apply (IH2 (Node ub u1 u2))]; trivial;
          intros c C; apply t_convex; apply in_app_iff; tauto.
      + destruct u_boxed as (_ & boxed_1 & boxed_2). cbn [pieces_in] in B. apply in_app_iff in B.
        destruct B as [B | B]; [apply IHu1 | apply IHu2]; trivial; intros c C; apply u_convex; apply in_app_iff; tauto.
  Qed.
End Boxes.
