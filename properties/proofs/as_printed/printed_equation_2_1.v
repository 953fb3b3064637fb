(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Equation 2.1 as printed: the points of the sum of two segments, from a to b and from c to d, are a + k (b - a) + c
   + l (d - c) for k and l between 0 and 1. And what the thesis says below it of segments of one direction: their sum
   is one segment, from a + c to b + d. *)
From Coq Require Import List.
From Oplus Require Import numbers convolution printed_lemma_2_2_2.
Import ListNotations.

Open Scope Q_scope.

(* Theorem, Equation 2.1. *)
Theorem equation_2_1_as_printed (a b c d x : vector) :
  sum_of_sets (fun y => lies_on y (Segment a b)) (fun y => lies_on y (Segment c d)) x <->
  exists k l, 0 <= k <= 1 /\ 0 <= l <= 1 /\
    vx x == vx a + k * (vx b - vx a) + vx c + l * (vx d - vx c) /\
    vy x == vy a + k * (vy b - vy a) + vy c + l * (vy d - vy c).
Proof.
  unfold sum_of_sets, lies_on, equal_vectors, plus. cbn [source target vx vy]. split.
  - intros (y & z & (k & K & X & Y) & (l & L & X' & Y') & X'' & Y''). exists k, l.
    rewrite X'', Y'', X, Y, X', Y'. repeat split; try tauto; ring.
  - intros (k & l & K & L & X & Y).
    exists (Vector ((1 - k) * vx a + k * vx b) ((1 - k) * vy a + k * vy b)),
      (Vector ((1 - l) * vx c + l * vx d) ((1 - l) * vy c + l * vy d)).
    split; [exists k; cbn; repeat split; try tauto; reflexivity |].
    split; [exists l; cbn; repeat split; try tauto; reflexivity |]. cbn [vx vy]. rewrite X, Y. split; ring.
Qed.

(* Theorem. Segments of the same direction add up to one segment: that from c to d is r times as long as that from a
   to b. *)
Theorem sum_of_segments_of_one_direction (a b c d x : vector) (r : Q) :
  0 < r -> vx d - vx c == r * (vx b - vx a) -> vy d - vy c == r * (vy b - vy a) ->
  (sum_of_sets (fun y => lies_on y (Segment a b)) (fun y => lies_on y (Segment c d)) x <->
   lies_on x (Segment (plus a c) (plus b d))).
Proof.
  intros R X Y. rewrite equation_2_1_as_printed. unfold lies_on, plus. cbn [source target vx vy]. split.
  - intros (k & l & K & L & x_is & y_is). exists ((k + l * r) / (1 + r)).
    assert (0 <= l * r) by (apply Qmult_le_0_compat; lra).
    assert (0 <= (1 - l) * r) by (apply Qmult_le_0_compat; lra).
    split; [split; [apply Qle_shift_div_l | apply Qle_shift_div_r]; lra |].
    rewrite x_is, y_is, X, Y.
    setoid_replace (vx d) with (vx c + r * (vx b - vx a)) by lra.
    setoid_replace (vy d) with (vy c + r * (vy b - vy a)) by lra. split; field; lra.
  - intros (t & T & x_is & y_is). exists t, t. split; [exact T |]. split; [exact T |]. rewrite x_is, y_is. split; ring.
Qed.
