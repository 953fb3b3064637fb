(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The boundary of the sum of two segments, a parallelogram, has winding number 0 or the sign of the
   segments' skew product, and points where it is not 0 are sums (docs/winding.md). Winding numbers are counted
   as in winding_number.v, on the boundary too. *)
From Coq Require Import ZArith Lia Bool List.
From Oplus Require Import numbers convolution regions.
Import ListNotations.

Open Scope Q_scope.

(* From e's source plus f's source first along e, then along f, and back. *)
Definition parallelogram (e f : segment) : list segment :=
  edges [plus (source e) (source f); plus (target e) (source f); plus (target e) (target f);
         plus (source e) (target f)].

(* x is the sum of a point of one segment and a point of another. *)
Definition is_sum_of_points (x : vector) (e f : segment) : Prop :=
  exists a b, lies_on a e /\ lies_on b f /\ equal_vectors x (plus a b).

(* What an edge adds by the heights of its ends and by a number that is positive to its left. *)
Lemma crossing_by_numbers (x : vector) (s : segment) (k u v side : Q) :
  k - u == vy x - vy (source s) -> k - v == vy x - vy (target s) ->
  side == cross (along s) (minus x (source s)) ->
  signed_crossing x s = ray_crossing (at_most u k) (at_most v k) (side ?= 0).
Proof.
  intros source_is target_is side_is. unfold signed_crossing. f_equal.
  - unfold at_most. now rewrite (compare_as_difference u k (vy (source s)) (vy x)) by lra.
  - unfold at_most. now rewrite (compare_as_difference v k (vy (target s)) (vy x)) by lra.
  - unfold orientation. apply compare_as_difference. rewrite side_is.
    unfold cross, along, minus. cbn. ring.
Qed.

(* What the four edges add: u and v are the heights of the segments, k that of x above the first corner, b and c
   are the skew products of the segments with x seen from there, and d their own. *)
Definition four_crossings (u v k b c d : Q) : Z :=
  let low := at_most 0 k in let after_e := at_most u k in
  let high := at_most (u + v) k in let after_f := at_most v k in
  let by_e := b ?= 0 in let by_f := d - c ?= 0 in let back_e := d - b ?= 0 in let back_f := c ?= 0 in
  (ray_crossing low after_e by_e + ray_crossing after_e high by_f + ray_crossing high after_f back_e +
   ray_crossing after_f low back_f)%Z.

Lemma winding_number_of_parallelogram (x : vector) (e f : segment) :
  let base := plus (source e) (source f) in
  let z := minus x base in
  let u := vy (along e) in let v := vy (along f) in let k := vy z in
  let b := cross (along e) z in let c := cross z (along f) in let d := cross (along e) (along f) in
  winding_number x (parallelogram e f) =
  four_crossings u v k b c d.
Proof.
  intros base z u v k b c d. unfold winding_number, parallelogram, edges, four_crossings.
  cbn [rotated app combine map fst snd sum fold_right]. rewrite Z.add_0_r, !Z.add_assoc.
  repeat apply (f_equal2 Z.add); apply crossing_by_numbers;
    unfold b, c, d, u, v, k, z, base, cross, along, minus, plus; cbn; ring.
Qed.

Lemma parallelogram_by_signs (u v k b c d : Q) :
  0 <= d -> d * k == c * u + b * v ->
  four_crossings u v k b c d = 0%Z \/
  (four_crossings u v k b c d = 1%Z /\ 0 < d /\ 0 <= b <= d /\ 0 <= c <= d).
Proof.
  intros positive height. unfold four_crossings, ray_crossing.
  destruct (at_most_spec 0 k), (at_most_spec u k), (at_most_spec (u + v) k), (at_most_spec v k);
    cbn [Bool.eqb Z.add]; try (left; reflexivity); try (exfalso; lra);
    compared_numbers (b ?= 0); compared_numbers (c ?= 0);
    compared_numbers (d - b ?= 0); compared_numbers (d - c ?= 0); cbn [Z.add Z.opp];
    try (left; reflexivity); try (exfalso; lra);
    try (right; split; [reflexivity |]; repeat split; lra).
  all: exfalso; nra.
Qed.

Lemma crossing_reversed (source_right target_right : bool) (side : comparison) :
  ray_crossing target_right source_right (CompOpp side) = (- ray_crossing source_right target_right side)%Z.
Proof. now destruct source_right, target_right, side. Qed.

Lemma opposite_comparison (a b : Q) : b == - a -> (b ?= 0) = CompOpp (a ?= 0).
Proof. intros is_opposite. rewrite (Qcompare_antisym a 0). apply compare_as_difference. lra. Qed.

(* With e and f exchanged. *)
Lemma other_way_round (u v k b c d : Q) : four_crossings v u k (- c) (- b) (- d) = (- four_crossings u v k b c d)%Z.
Proof.
  unfold four_crossings.
  assert (at_most (v + u) k = at_most (u + v) k) as ->
    by (destruct (at_most_spec (v + u) k), (at_most_spec (u + v) k); trivial; exfalso; lra).
  rewrite (opposite_comparison b (- b)), (opposite_comparison c (- c)),
    (opposite_comparison (d - b) (- d - - b)), (opposite_comparison (d - c) (- d - - c)) by ring.
  rewrite !crossing_reversed. lia.
Qed.

(* A point with these skew products is a sum. *)
Lemma sum_by_skew_products (x : vector) (e f : segment) :
  let z := minus x (plus (source e) (source f)) in let d := cross (along e) (along f) in
  ~ d == 0 -> 0 <= cross z (along f) / d <= 1 -> 0 <= cross (along e) z / d <= 1 ->
  is_sum_of_points x e f.
Proof.
  intros z d turn on_e on_f. set (s := cross z (along f) / d) in *. set (t := cross (along e) z / d) in *.
  exists (Vector ((1 - s) * vx (source e) + s * vx (target e)) ((1 - s) * vy (source e) + s * vy (target e))),
    (Vector ((1 - t) * vx (source f) + t * vx (target f)) ((1 - t) * vy (source f) + t * vy (target f))).
  split; [| split].
  - exists s. cbn. repeat split; trivial; reflexivity || apply on_e.
  - exists t. cbn. repeat split; trivial; reflexivity || apply on_f.
  - split; cbn; unfold s, t, d, z, cross, along, minus, plus in *; cbn in *; field; exact turn.
Qed.

Lemma quotient_in_range (a d : Q) : 0 < d -> 0 <= a <= d -> 0 <= a / d <= 1.
Proof. intros positive range. split; [apply Qle_shift_div_l | apply Qle_shift_div_r]; lra. Qed.

(* Theorem. The winding number of every point by the boundary of e + f is 0 or the sign of the skew product of
   e and f; where it is not 0, the point is the sum of one of e and one of f. *)
Theorem parallelogram_winding_number (x : vector) (e f : segment) :
  winding_number x (parallelogram e f) = 0%Z \/
  ((winding_number x (parallelogram e f) = 1%Z /\ 0 < cross (along e) (along f) \/
    winding_number x (parallelogram e f) = (-1)%Z /\ cross (along e) (along f) < 0) /\
   is_sum_of_points x e f).
Proof.
  rewrite winding_number_of_parallelogram. set (z := minus x (plus (source e) (source f))).
  set (d := cross (along e) (along f)). set (b := cross (along e) z). set (c := cross z (along f)).
  assert (height : d * vy z == c * vy (along e) + b * vy (along f))
    by (unfold d, b, c, cross; ring).
  destruct (Qlt_le_dec d 0) as [negative_turn | no_negative_turn].
  - destruct (parallelogram_by_signs (vy (along f)) (vy (along e)) (vy z) (- c) (- b) (- d))
      as [zero_ | (one & _ & range_c & range_b)]; [lra | lra | |]; rewrite other_way_round in *; [left; lia |].
    right. split; [right; split; [lia | exact negative_turn] |].
    apply sum_by_skew_products; fold z; fold d; fold b; fold c; [lra | |].
    + setoid_replace (c / d) with (- c / - d) by (field; lra). apply quotient_in_range; lra.
    + setoid_replace (b / d) with (- b / - d) by (field; lra). apply quotient_in_range; lra.
  - destruct (parallelogram_by_signs (vy (along e)) (vy (along f)) (vy z) b c d no_negative_turn height)
      as [zero_ | (one & positive_turn & range_b & range_c)]; [now left |].
    right. split; [left; split; [exact one | exact positive_turn] |].
    apply sum_by_skew_products; fold z; fold d; fold b; fold c; [lra | |]; now apply quotient_in_range.
Qed.
