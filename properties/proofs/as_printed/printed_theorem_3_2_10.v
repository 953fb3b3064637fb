(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Theorem 3.2.10 as printed: through an isolated vertex there are segments of the convolution of at least three
   directions, passing or ending there. P and Q are open (Section 3.2.4); an isolated vertex (Definition 3.2.9) is not
   in their sum, but all points near it are. It may be a sum of two vertices, where any number of chains touch. Whatever
   direction n one goes from it, a segment that covers it has n to its left (segments_left_of_a_step.v). Take one, d1;
   then one that has d1 to its left, and one that has -d1 to its left: these are three directions. *)
From Coq Require Import QArith Lqa List.
From Oplus Require Import regions_and_sums parallelogram boundary_points observation_2_2_4 theorem_3_2_10
  chains_that_do_not_cross segments_left_of_a_step polygons_of_the_thesis.
Import ListNotations.

Open Scope Q_scope.

(* Theorem. No half plane is free of them: every direction is to the left of one. *)
Theorem every_direction_is_left_of_a_segment (p q : region) (x n : vector) :
  valid_region p -> valid_region q -> chains_do_not_cross p -> chains_do_not_cross q ->
  isolated_vertex x p q -> nonzero n ->
  exists s, In s (convolution_segments p q) /\ lies_on x s /\ 0 < cross (along s) n.
Proof.
  intros p_region q_region p_crosses_nowhere q_crosses_nowhere (outside & radius & R & near) long.
  apply segment_left_of_a_step; trivial. refine (eventually_implied _ _ _ (eventually_and _ _
    (small_steps_stay_within radius x n R) (leaves_a_point x n x long))).
  intros t [close moved_]. apply near; [exact close |]. intros equal. apply moved_. now symmetry.
Qed.

(* Theorem 3.2.10. *)
Theorem theorem_3_2_10_as_printed (p q : region) (x : vector) :
  valid_region p -> valid_region q -> chains_do_not_cross p -> chains_do_not_cross q -> isolated_vertex x p q ->
  exists s1 s2 s3, incl [s1; s2; s3] (convolution_segments p q) /\ lies_on x s1 /\ lies_on x s2 /\ lies_on x s3 /\
    ~ same_direction (along s1) (along s2) /\ ~ same_direction (along s1) (along s3) /\
    ~ same_direction (along s2) (along s3).
Proof.
  intros p_region q_region p_crosses_nowhere q_crosses_nowhere isolated.
  pose proof (every_direction_is_left_of_a_segment p q x) as each.
  destruct (each (Vector 1 0)) as (s1 & S1 & on_1 & left_1); trivial; [intros [X _]; discriminate X |].
  assert (long : nonzero (along s1)).
  { intros [X Y]. unfold cross in left_1. rewrite X, Y in left_1. lra. }
  destruct (each (along s1)) as (s2 & S2 & on_2 & left_2); trivial.
  destruct (each (opposite (along s1))) as (s3 & S3 & on_3 & left_3); trivial; [now apply opposite_nonzero |].
  exists s1, s2, s3. split; [intros s [<- | [<- | [<- | []]]]; assumption |].
  split; [exact on_1 |]. split; [exact on_2 |]. split; [exact on_3 |].
  unfold same_direction, cross, opposite in *. cbn [vx vy] in *.
  split; [| split]; intros (a & some & X & Y).
  - rewrite X, Y in left_2. lra.
  - rewrite X, Y in left_3. lra.
  - rewrite X, Y in left_2.
    assert (0 < a * (vx (along s3) * vy (along s1) - vy (along s3) * vx (along s1))) by lra.
    assert (0 < a * - (vx (along s3) * vy (along s1) - vy (along s3) * vx (along s1)))
      by (apply Qmult_lt_0_compat; lra). lra.
Qed.

(* Theorem. Of two simple polygons it need not be said that chains do not cross. *)
Theorem theorem_3_2_10_for_simple_polygons (p q : list vector) (x : vector) :
  simple_polygon p -> simple_polygon q -> isolated_vertex x [p] [q] ->
  exists s1 s2 s3, incl [s1; s2; s3] (convolution_segments [p] [q]) /\ lies_on x s1 /\ lies_on x s2 /\ lies_on x s3 /\
    ~ same_direction (along s1) (along s2) /\ ~ same_direction (along s1) (along s3) /\
    ~ same_direction (along s2) (along s3).
Proof.
  assert (region_of_one : forall chain, simple_polygon chain -> valid_region [chain] /\ chains_do_not_cross [chain]).
  { intros chain polygon. pose proof (simple_polygons_are_regions chain polygon) as valid. split; [exact valid |].
    now apply chains_that_do_not_touch_do_not_cross, simple_polygons_do_not_touch. }
  intros p_polygon q_polygon. destruct (region_of_one p p_polygon), (region_of_one q q_polygon).
  now apply theorem_3_2_10_as_printed.
Qed.
