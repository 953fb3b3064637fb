(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* What signed_crossing_of_step (signed_crossings.v), which counts as the code does, has to do with the thesis's
   Definition 4.2.3: where it is not zero the step and the segment have a point in common; and if no end of the one is
   on the line of the other, it is then the sign of the step along the segment's normal to the left.
   That signed crossings add up to winding numbers is in signed_crossings.v, whether segments have a point
   in common in segments_apart.v. *)
From Coq Require Import ZArith Bool List.
From Oplus Require Import numbers winding rotation shifted_ray signed_crossings secants segments_apart
  meeting_of_segments small_numbers.
Import ListNotations.

Open Scope Q_scope.

Lemma orientation_by_dot (a b c : vector) : orientation a b c = (dot (normal (minus b a)) (minus c a) ?= 0).
Proof. unfold orientation, dot, normal, minus. cbn [vx vy]. apply compare_as_difference. ring. Qed.

(* No end of the one is on the line of the other. *)
Definition in_general_position (from to : vector) (s : segment) : Prop :=
  orientation (source s) (target s) from <> Eq /\ orientation (source s) (target s) to <> Eq /\
  orientation from to (source s) <> Eq /\ orientation from to (target s) <> Eq.

(* Theorem (Definition 4.2.3). In general position, a step crosses a segment iff the two have a point in common,
   and the signed crossing is then the sign of the step along the segment's normal to the left. *)
Theorem crossing_in_general_position (from to : vector) (s : segment) :
  in_general_position from to s ->
  let along_normal := dot (normal (minus (target s) (source s))) (minus to from) ?= 0 in
  (signed_crossing_of_step from to s <> 0%Z <->
   exists x, lies_on x (Segment from to) /\ lies_on x s) /\
  (signed_crossing_of_step from to s <> 0%Z ->
   signed_crossing_of_step from to s = sign_of along_normal).
Proof.
  destruct s as [a b]. unfold in_general_position. cbn [source target].
  intros (from_off & to_off & a_off & b_off).
  set (along_normal := dot (normal (minus b a)) (minus to from) ?= 0).
  assert (sides_differ : forall x y t, 0 <= t <= 1 -> (1 - t) * x + t * y == 0 ->
    (x ?= 0) <> Eq -> (y ?= 0) <> Eq ->
    same_side (x ?= 0) (y ?= 0) = false /\ (y - x ?= 0) = (y ?= 0)).
  { intros x y t range balance x_off y_off.
    compared_numbers (x ?= 0); compared_numbers (y ?= 0); try (now elim x_off); try (now elim y_off);
      try (exfalso; nra); (split; [reflexivity |]).
    - apply (proj1 (Qgt_alt _ _)). lra.
    - apply (proj1 (Qlt_alt _ _)). lra. }
  assert (common : forall x, lies_on x (Segment from to) -> lies_on x (Segment a b) ->
    signed_crossing_of_step from to (Segment a b) = sign_of along_normal /\
    signed_crossing_of_step from to (Segment a b) <> 0%Z).
  { intros x (t & range_t & xt & yt) (r & range_r & xr & yr). cbn [source target] in *.
    unfold signed_crossing_of_step, side_of_segment, side_of_step. cbn [source target].
    rewrite !orientation_by_dot in *. unfold along_normal.
    set (u := minus to from) in *. set (v := minus b a) in *.
    set (fa := dot (normal v) (minus from a)) in *. set (ta := dot (normal v) (minus to a)) in *.
    set (au := dot (normal u) (minus a from)) in *. set (bu := dot (normal u) (minus b from)) in *.
    assert (on_segment_line : (1 - t) * fa + t * ta == 0).
    { unfold fa, ta, u, v, normal in *. in_coordinates. by_equations. }
    assert (on_step_line : (1 - r) * au + r * bu == 0).
    { unfold au, bu, u, v, normal in *. in_coordinates. by_equations. }
    destruct (sides_differ fa ta t range_t on_segment_line from_off to_off) as [apart_ends sign_is].
    destruct (sides_differ au bu r range_r on_step_line a_off b_off) as [apart_sides _].
    assert (fa_is : match fa ?= 0 with Eq => turn_to_shift v | c => c end = (fa ?= 0)) by now destruct (fa ?= 0).
    assert (ta_is : match ta ?= 0 with Eq => turn_to_shift v | c => c end = (ta ?= 0)) by now destruct (ta ?= 0).
    assert (au_is : match au ?= 0 with Eq => CompOpp (turn_to_shift u) | c => c end = (au ?= 0))
      by now destruct (au ?= 0).
    assert (bu_is : match bu ?= 0 with Eq => CompOpp (turn_to_shift u) | c => c end = (bu ?= 0))
      by now destruct (bu ?= 0).
    rewrite fa_is, ta_is, au_is, bu_is, apart_ends, apart_sides. cbn [orb].
    rewrite (compare_as_difference (dot (normal v) u) 0 (ta - fa) 0), sign_is
      by (unfold ta, fa, u, dot, minus; cbn [vx vy]; ring).
    split; [reflexivity |]. now destruct (ta ?= 0). }
  split; [split |].
  - apply crossing_steps_meet.
  - intros (x & on_step & on_segment). now apply (common x).
  - intros crossed. destruct (crossing_steps_meet _ _ _ crossed) as (x & on_step & on_segment).
    now apply (common x).
Qed.

Lemma ends_leave_the_line (from to a : vector) :
  nonzero (minus to from) ->
  eventually (fun e =>
    orientation (moved (shifted from) e) (moved (shifted to) e) a <> Eq).
Proof.
  intros n. set (d := minus to from) in *. set (o := dot (normal d) (minus a from)).
  destruct (quadratic_nearby o (vy d) (- vx d)) as (limit & positive & near).
  exists limit. split; [exact positive |]. intros e e_positive small.
  unfold orientation.
  rewrite (compare_as_difference _ _ (o + e * vy d + e * e * - vx d) 0)
    by (unfold o, d, dot, normal, minus; cbn; ring).
  rewrite near by assumption. unfold sign_nearby, nonzero in *.
  compared_numbers (o ?= 0); try discriminate. compared_numbers (vy d ?= 0); try discriminate.
  intros none. apply equal_comparison in none. apply n. lra.
Qed.

(* Theorem. In any position the signed crossing is that of the step shifted by (e, e^2) for any small enough e,
   which is in general position. *)
Theorem crossing_is_that_of_a_shifted_step (from to : vector) (s : segment) :
  nonzero (minus to from) -> nonzero (minus (target s) (source s)) ->
  eventually (fun e =>
    let from' := moved (shifted from) e in let to' := moved (shifted to) e in
    in_general_position from' to' s /\
    signed_crossing_of_step from' to' s = signed_crossing_of_step from to s).
Proof.
  intros n m.
  refine (eventually_implied _ _ _ (eventually_and _ _ (step_nearby from to s n) (eventually_and _ _
    (eventually_and _ _ (side_of_segment_nearby from s m) (side_of_segment_nearby to s m))
    (eventually_and _ _ (ends_leave_the_line from to (source s) n) (ends_leave_the_line from to (target s) n))))).
  intros e (same_crossing & ([_ from_off] & [_ to_off]) & source_off & target_off). now repeat split.
Qed.
