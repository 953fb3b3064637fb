(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Where the checker (checker.v) finds that a point is in the sum of two convex pieces, it is the sum of a point of the
   one and a point of the other: of a corner and another point, or of points at which two sides cross. If that is so
   for the corners of a polygon that has a fan (fans.v), it is so for all points of the polygon. *)
From Coq Require Import QArith Lqa Qfield ZArith Lia Bool List.
From Oplus Require Import winding specification checker homogeneous_points fans.
Import ListNotations.

Open Scope Q_scope.

(* x is the sum of a point of t and a point of u. *)
Definition is_in_sum (t u : piece) (x : vector) : Prop :=
  exists a b, inside_piece t a /\ inside_piece u b /\ equal_vectors x (added a b).

(* A point of the segment between two points of a piece. *)
Lemma segment_is_inside (t : piece) (a b : vector) (s : Q) :
  0 <= s <= 1 -> inside_piece t a -> inside_piece t b ->
  inside_piece t (Vector ((1 - s) * vx a + s * vx b) ((1 - s) * vy a + s * vy b)).
Proof.
  intros [s_low s_high] a_in b_in. apply (combination_is_inside (1 - s) s 0 t a b a); trivial.
  - repeat split; lra.
  - split; cbn [vx vy]; ring.
Qed.

Lemma left_turn_is_negative (a b c : hpoint) :
  (left_turn a b c < 0)%Z <-> turn_of (vector_of a) (vector_of b) (vector_of c) < 0.
Proof.
  pose proof (left_turn_is_positive b a c) as reversed.
  assert (left_turn b a c = - left_turn a b c)%Z as negated_
    by (unfold left_turn, value, line_through; cbn [la lb lc]; ring).
  assert (turn_of (vector_of b) (vector_of a) (vector_of c) == - turn_of (vector_of a) (vector_of b) (vector_of c))
    as is_opposite by (unfold turn_of; ring).
  rewrite is_opposite, negated_ in reversed. split; intros sign;
    [assert (0 < - left_turn a b c)%Z as opposite by lia |
     assert (0 < - turn_of (vector_of a) (vector_of b) (vector_of c)) as opposite by lra];
    apply reversed in opposite; [lra | lia].
Qed.

Definition are_opposite (u v : Q) : Prop := 0 < u /\ v < 0 \/ u < 0 /\ 0 < v.

Lemma turns_are_opposite (a b c d : hpoint) :
  (left_turn a b c * left_turn a b d <? 0)%Z = true ->
  are_opposite (turn_of (vector_of a) (vector_of b) (vector_of c)) (turn_of (vector_of a) (vector_of b) (vector_of d)).
Proof.
  rewrite Z.ltb_lt. intros product. unfold are_opposite. rewrite <- !left_turn_is_negative, <- !left_turn_is_positive.
  apply Z.lt_mul_0 in product. tauto.
Qed.

Lemma ratio_of_opposites (u v : Q) : are_opposite u v -> ~ u - v == 0 /\ 0 <= u / (u - v) <= 1.
Proof.
  intros [[high low] | [low high]].
  - split; [lra |]. split.
    + apply Qle_shift_div_l; lra.
    + apply Qle_shift_div_r; lra.
  - split; [lra |]. assert (ratio : u / (u - v) == - u / (v - u)) by (field; lra). rewrite ratio. split.
    + apply Qle_shift_div_l; lra.
    + apply Qle_shift_div_r; lra.
Qed.

Lemma sides_are_corners (v : polygon) (e : hedge) : In e (sides v) -> In (fst e) v /\ In (snd e) v.
Proof.
  destruct v as [| first rest]; [easy |]. unfold sides. destruct e as [a b]. intros side. split.
  - exact (in_combine_l _ _ _ _ side).
  - apply in_combine_r, in_app_or in side. cbn in *. tauto.
Qed.

Theorem sum_of_both_is_in_sum (t u : piece) (x : hpoint) :
  is_convex t = true -> is_convex u = true -> is_sum_of_both t u x = true -> is_in_sum t u (vector_of x).
Proof.
  intros t_convex u_convex. unfold is_sum_of_both. rewrite !orb_true_iff, !existsb_exists.
  assert (differ : forall a, equal_vectors (added (vector_of (hminus x a)) (vector_of a)) (vector_of x))
    by (intros; apply vector_of_minus).
  intros [[(a & corner & within) | (b & corner & within)] | (s & s_side & crosses)].
  - exists (vector_of a), (vector_of (hminus x a)). split; [now apply corners_are_inside |].
    split; [now apply left_of_all_is_inside |]. destruct (differ a) as [x_is y_is].
    unfold added, equal_vectors in *. cbn [vx vy] in *. split; [rewrite <- x_is | rewrite <- y_is]; ring.
  - exists (vector_of (hminus x b)), (vector_of b). split; [now apply left_of_all_is_inside |].
    split; [now apply corners_are_inside |]. destruct (differ b) as [x_is y_is].
    unfold added, equal_vectors in *. cbn [vx vy] in *. split; [now rewrite <- x_is | now rewrite <- y_is].
  - apply existsb_exists in crosses as (r & r_side & crosses). unfold do_cross in crosses.
    rewrite andb_true_iff in crosses. destruct crosses as [ends_of_r ends_of_s].
    apply turns_are_opposite in ends_of_r, ends_of_s.
    destruct (sides_are_corners _ _ s_side) as [a_corner b_corner].
    destruct (sides_are_corners _ _ r_side) as [c_corner d_corner].
    destruct (differ (fst r)) as [xc yc]. destruct (differ (snd r)) as [xd yd].
    apply corners_are_inside in a_corner, b_corner, c_corner, d_corner; trivial.
    destruct (ratio_of_opposites _ _ ends_of_s) as [distinct_s ratio_s].
    destruct (ratio_of_opposites _ _ ends_of_r) as [distinct_r ratio_r].
    revert distinct_s ratio_s distinct_r ratio_r xc yc xd yd a_corner b_corner c_corner d_corner. clear.
    generalize (vector_of (hminus x (fst r))), (vector_of (hminus x (snd r))).
    generalize (vector_of (fst r)), (vector_of (snd r)), (vector_of (fst s)), (vector_of (snd s)), (vector_of x).
    clear. intros c d a b x c' d' distinct_s ratio_s distinct_r ratio_r xc yc xd yd a_in b_in c_in d_in.
    eexists _, _. split; [exact (segment_is_inside t a b _ ratio_s a_in b_in) |].
    split; [exact (segment_is_inside u c d _ ratio_r c_in d_in) |].
    unfold added, equal_vectors, turn_of in *. cbn [vx vy] in *.
    assert (vx c == vx x - vx c') as xc_is by lra. assert (vy c == vy x - vy c') as yc_is by lra.
    assert (vx d == vx x - vx d') as xd_is by lra. assert (vy d == vy x - vy d') as yd_is by lra.
    rewrite xc_is, yc_is, xd_is, yd_is. split; field; split; lra.
Qed.

(** Sums with weights *)

Definition combination (p q r : Q) (a b c : vector) : vector :=
  Vector (p * vx a + q * vx b + r * vx c) (p * vy a + q * vy b + r * vy c).

Lemma combination_is_in_sum (t u : piece) (p q r : Q) (a b c x : vector) :
  are_weights p q r -> is_combination p q r a b c x ->
  is_in_sum t u a -> is_in_sum t u b -> is_in_sum t u c -> is_in_sum t u x.
Proof.
  intros weights [x_is y_is] (a1 & a2 & a1_in & a2_in & ax & ay)
    (b1 & b2 & b1_in & b2_in & bx & by_)
    (c1 & c2 & c1_in & c2_in & cx & cy).
  exists (combination p q r a1 b1 c1), (combination p q r a2 b2 c2).
  split; [| split].
  - apply (combination_is_inside p q r t a1 b1 c1); trivial. split; reflexivity.
  - apply (combination_is_inside p q r u a2 b2 c2); trivial. split; reflexivity.
  - unfold equal_vectors, added in *. cbn [combination vx vy] in *.
    rewrite x_is, y_is, ax, ay, bx, by_, cx, cy. split; ring.
Qed.

Theorem polygon_is_in_sum (t u : piece) (tries : nat) (v : polygon) (x : vector) :
  is_convex t = true -> is_convex u = true ->
  some_corner_has_a_fan tries v = true -> forallb (is_sum_of_both t u) v = true -> inside_piece (piece_of v) x ->
  is_in_sum t u x.
Proof.
  intros t_convex u_convex fan sums x_in. rewrite forallb_forall in sums.
  destruct (inside_is_combination tries v x fan x_in)
    as (a & b & c & p & q & r & a_in & b_in & c_in & weights & is_sum).
  apply (combination_is_in_sum t u p q r (vector_of a) (vector_of b) (vector_of c)); auto using sum_of_both_is_in_sum.
Qed.
