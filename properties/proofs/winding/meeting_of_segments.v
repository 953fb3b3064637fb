(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* A step with a signed crossing (thesis, Definition 4.2.3 and Observation 4.2.5) meets the
   segment that it crosses, so that the winding number is constant along a step that meets no segment.
   Signed crossings of steps and that they add up are in signed_crossings.v. *)
From Coq Require Import ZArith Lia Bool List.
From Oplus Require Import numbers winding signed_crossings.
Import ListNotations.

Open Scope Q_scope.

Lemma orientation_by_area (a b p : vector) : orientation a b p = (area (Segment a b) p ?= 0).
Proof. unfold orientation. apply compare_as_difference. unfold area, cross, minus; cbn. ring. Qed.

Lemma on_the_line (w : vector) (s : segment) : lies_on w s -> area s w == 0.
Proof. intros (t & _ & X & Y). in_coordinates. by_equations. Qed.

Lemma off_by_area (p : vector) (s : segment) : ~ area s p == 0 -> ~ lies_on p s.
Proof. intros beside on. now apply beside, on_the_line. Qed.

Lemma area_reversed (s : segment) (w : vector) : area (reversed s) w == - area s w.
Proof. unfold area, cross, minus, reversed. cbn [source target vx vy]. ring. Qed.

Lemma area_between (s : segment) (y z v : vector) :
  area s y < 0 -> area s z < 0 -> lies_on v (Segment y z) -> area s v < 0.
Proof.
  intros y_right z_right (h & range & X & Y). setoid_replace (area s v) with ((1 - h) * area s y + h * area s z)
    by (in_coordinates; by_equations).
  now apply mixed_is_less.
Qed.

(* Not on the same side, ties decided by one and the same rule. *)
Lemma sides_differ (c d tie : comparison) (u v : Q) :
  c = (u ?= 0) -> d = (v ?= 0) ->
  same_side (match c with Eq => tie | Lt => Lt | Gt => Gt end)
            (match d with Eq => tie | Lt => Lt | Gt => Gt end) = false ->
  (0 <= u /\ v <= 0 \/ u <= 0 /\ 0 <= v) /\ ~ u == v.
Proof.
  intros -> -> differ.
  compared_numbers (u ?= 0); compared_numbers (v ?= 0); destruct tie; try discriminate differ;
    (split; [lra | intros equal; lra]).
Qed.

Lemma fraction_between (u v : Q) : (0 <= u /\ v <= 0 \/ u <= 0 /\ 0 <= v) -> ~ u == v -> 0 <= u / (u - v) <= 1.
Proof.
  intros signs differ.
  assert (value : u / (u - v) * (u - v) == u) by (field; lra).
  set (t := u / (u - v)) in *. clearbody t.
  destruct (Qlt_le_dec u v) as [below | above].
  - split; apply Qnot_lt_le; intros outside; nra.
  - assert (v < u) by lra. split; apply Qnot_lt_le; intros outside; nra.
Qed.

(* Where neither is on one side of the other's line. *)
Lemma common_point (from to a b : vector) :
  let F := area (Segment a b) from in let T := area (Segment a b) to in
  let U := area (Segment from to) a in let V := area (Segment from to) b in
  (0 <= F /\ T <= 0 \/ F <= 0 /\ 0 <= T) -> ~ F == T -> (0 <= U /\ V <= 0 \/ U <= 0 /\ 0 <= V) -> ~ U == V ->
  exists w, lies_on w (Segment from to) /\ lies_on w (Segment a b).
Proof.
  intros F T U V step_signs step_crosses signs crosses.
  pose proof (fraction_between _ _ step_signs step_crosses) as f_range.
  pose proof (fraction_between _ _ signs crosses) as g_range.
  assert (D : ~ F - T == 0) by lra.
  assert (f_is : F / (F - T) * (F - T) == F) by (field; lra).
  assert (g_is : U / (U - V) * (U - V) == U) by (field; lra).
  set (f := F / (F - T)) in *. set (g := U / (U - V)) in *. clearbody f g.
  exists (Vector ((1 - f) * vx from + f * vx to) ((1 - f) * vy from + f * vy to)).
  split; [exists f; split; [exact f_range | split; reflexivity] |]. exists g. split; [exact g_range |].
  clear - f_is g_is D. split; apply (Qmult_inj_r _ _ (F - T) D); unfold F, T, U, V in *; in_coordinates; by_equations.
Qed.

(* Theorem. Where a step crosses a segment, by the rule for signed crossings, they have a point in common. *)
Theorem crossing_steps_meet (from to : vector) (s : segment) :
  signed_crossing_of_step from to s <> 0%Z ->
  exists w, lies_on w (Segment from to) /\ lies_on w s.
Proof.
  destruct s as [a b]. unfold signed_crossing_of_step, side_of_segment, side_of_step. cbn [source target].
  destruct (same_side (match orientation a b from with Eq => _ | _ => _ end) _) eqn:sides; [now cbn |].
  destruct (same_side (match orientation from to a with Eq => _ | _ => _ end) _) eqn:ends; [now cbn |].
  intros _. apply (sides_differ _ _ _ _ _ (orientation_by_area a b from) (orientation_by_area a b to)) in sides.
  apply (sides_differ _ _ _ _ _ (orientation_by_area from to a) (orientation_by_area from to b)) in ends.
  now apply common_point.
Qed.

Lemma source_lies_on (s : segment) : lies_on (source s) s.
Proof. exists 0. repeat split; lra. Qed.

Lemma target_lies_on (s : segment) : lies_on (target s) s.
Proof. exists 1. repeat split; lra. Qed.

(* Theorem. From one end of a segment to the other, the winding number with respect to closed chains is the
   same, if no point of the segment is on the chains. *)
Theorem winding_number_along (s : segment) (segments : list segment) :
  cycles segments -> (forall w, lies_on w s -> off w segments) ->
  winding_number (source s) segments = winding_number (target s) segments.
Proof.
  intros closed apart. destruct s as [from to].
  pose proof (apart _ (source_lies_on _)) as off_source. pose proof (apart _ (target_lies_on _)) as off_target.
  cbn [source target] in *. destruct (zero_or_not (minus to from)) as [[X Y] | moves];
    [cbn in X, Y; apply winding_number_of_equal; lra |].
  pose proof (step_changes_winding_number from to segments closed off_source off_target moves) as change.
  rewrite sum_of_zeros in change; [lia |]. intros s I.
  destruct (Z.eq_dec (signed_crossing_of_step from to s) 0) as [| crosses]; [assumption | exfalso].
  destruct (crossing_steps_meet from to s crosses) as (w & on & on_s). exact (apart w on s I on_s).
Qed.

(* A part of a segment from one of its points to its end. *)
Lemma part_of_segment (w v : vector) (s : segment) : lies_on w s -> lies_on v (Segment w (target s)) -> lies_on v s.
Proof.
  intros (t & [t0 t1] & wx & wy) (r & [r0 r1] & x & y). cbn [source target] in *.
  exists (1 - (1 - r) * (1 - t)). split; [split; nra |].
  rewrite x, y, wx, wy. split; ring.
Qed.
