(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Section 5.2.2 as the thesis has it: a ray to the left from the middle of an edge s of a loop that goes round a hole,
   clockwise; it counts s itself, and what overlaps s, so it starts a little to the right of s. Its number is the
   winding number there, as that of any ray. If s leads upwards, there is inside the loop. If s leads downwards, inside
   is to the left of s, across all that overlaps s: the winding number changes by 1 for each segment that leads
   upwards, by -1 for each that leads downwards. So Observation 5.2.1 says -1 where s only is there. *)
From Coq Require Import ZArith Lia Bool List.
From Oplus Require Import numbers convolution small_numbers signed_crossings neighbourhoods meeting_of_segments regions
  beside_a_piece location simple_chain simple_chains_turn_once winding_numbers_of_simple_chains.
Import ListNotations.

Open Scope Q_scope.

Definition to_the_left : vector := Vector (-1) 0.

(* Moved to the right; to the left if e is negative. *)
Definition moved_right (x : vector) (e : Q) : vector := Vector (vx x + e) (vy x).

(* What a ray to the left from x counts, as if it were a little higher, so that a point at its height is below it. *)
Definition left_ray_number (x : vector) (segments : list segment) : Z :=
  winding_number_by_ray OfP to_the_left x segments.

Definition middle_of (s : segment) : vector := point_at s (1 # 2).

Definition leads_upwards (s : segment) : Prop := vy (source s) < vy (target s).
Definition leads_downwards (s : segment) : Prop := vy (target s) < vy (source s).

(* How many of the segments at a point lead upwards, less those that lead downwards. *)
Definition upward_less_downward (x : vector) (segments : list segment) : Z :=
  sum (map (fun t => if is_on_segment x t then if negative (vy (along t)) then (-1)%Z else 1%Z else 0%Z) segments).

(* None of the segments at the point ends there, and none is horizontal. *)
Definition passed_up_or_down (x : vector) (segments : list segment) : Prop :=
  forall t, In t segments -> lies_on x t -> strictly_inside x t /\ (leads_upwards t \/ leads_downwards t).

Lemma area_moved_right (t : segment) (x : vector) (e : Q) : area t (moved_right x e) == area t x - e * vy (along t).
Proof. unfold moved_right. by_coordinates. Qed.

Lemma crossing_of_a_passing_segment (x : vector) (t : segment) (e : Q) : 0 < e ->
  strictly_inside x t -> leads_upwards t \/ leads_downwards t ->
  signed_crossing_of_step (moved_right x e) (moved_right x (- e)) t =
    (if negative (vy (along t)) then (-1)%Z else 1%Z) /\
  ~ lies_on (moved_right x e) t /\ ~ lies_on (moved_right x (- e)) t.
Proof.
  intros some inside_ slanted. pose proof (on_the_line x t (strictly_inside_lies_on x t inside_)) as line.
  destruct inside_ as (k & range & _ & height).
  assert (vy_along : vy (along t) == vy (target t) - vy (source t)) by (unfold along, minus; cbn [vy]; ring).
  assert (not_flat : ~ vy (along t) == 0) by (unfold leads_upwards, leads_downwards in slanted; lra).
  pose proof (area_moved_right t x e) as right_. pose proof (area_moved_right t x (- e)) as left_.
  rewrite line in right_, left_.
  split; [| split; apply off_by_area; rewrite ?right_, ?left_; nra].
  unfold signed_crossing_of_step, side_of_segment, side_of_step.
  assert (step_side : forall c, orientation (moved_right x e) (moved_right x (- e)) c = (vy x - vy c ?= 0)).
  { intros c. unfold orientation, moved_right. cbn [vx vy].
    assert (twice : (vx x + - e - (vx x + e)) * (vy c - vy x) - (vy x - vy x) * (vx c - (vx x + e)) ==
      2 * e * (vy x - vy c)) by ring.
    compared_numbers (vy x - vy c ?= 0); [apply (proj1 (Qeq_alt _ _)) | apply (proj1 (Qlt_alt _ _)) |
      apply (proj1 (Qgt_alt _ _))]; nra. }
  destruct t as [a b]. rewrite !step_side, !orientation_by_area. cbn [source target] in *.
  destruct (negative_spec (vy (along (Segment a b)))) as [down | up].
  - rewrite (proj1 (Qgt_alt (area (Segment a b) (moved_right x e)) 0)) by nra.
    rewrite (proj1 (Qlt_alt (area (Segment a b) (moved_right x (- e))) 0)) by nra.
    rewrite (proj1 (Qlt_alt (vy x - vy a) 0)) by nra. rewrite (proj1 (Qgt_alt (vy x - vy b) 0)) by nra. reflexivity.
  - assert (0 < vy (along (Segment a b))) by lra.
    rewrite (proj1 (Qlt_alt (area (Segment a b) (moved_right x e)) 0)) by nra.
    rewrite (proj1 (Qgt_alt (area (Segment a b) (moved_right x (- e))) 0)) by nra.
    rewrite (proj1 (Qgt_alt (vy x - vy a) 0)) by nra. rewrite (proj1 (Qlt_alt (vy x - vy b) 0)) by nra. reflexivity.
Qed.

Lemma crossing_of_another_segment (x : vector) (t : segment) : ~ lies_on x t ->
  eventually (fun e =>
    signed_crossing_of_step (moved_right x e) (moved_right x (- e)) t = 0%Z /\
    ~ lies_on (moved_right x e) t /\ ~ lies_on (moved_right x (- e)) t).
Proof.
  intros free. destruct (off_one_segment_near x t free) as (radius & R & near).
  refine (eventually_implied _ _ _ (eventually_below radius R)). intros e [some small].
  assert (right_ : within radius x (moved_right x e)) by (unfold within, moved_right; cbn [vx vy]; lra).
  assert (left_ : within radius x (moved_right x (- e))) by (unfold within, moved_right; cbn [vx vy]; lra).
  split; [| split; now apply near].
  destruct (Z.eq_dec (signed_crossing_of_step (moved_right x e) (moved_right x (- e)) t) 0) as [-> | crosses];
    [reflexivity | exfalso].
  destruct (crossing_steps_meet _ _ _ crosses) as (w & on & on_t).
  exact (near w (within_along radius x _ _ w right_ left_ on) on_t).
Qed.

(* Lemma. Just to the left of a point the winding number is that just to its right, and what passes the point. *)
Lemma across_a_point (x : vector) (segments : list segment) : cycles segments -> passed_up_or_down x segments ->
  eventually (fun e =>
    off (moved_right x e) segments /\ off (moved_right x (- e)) segments /\
    winding_number (moved_right x (- e)) segments =
      (winding_number (moved_right x e) segments + upward_less_downward x segments)%Z).
Proof.
  intros closed passed_. refine (eventually_implied _ _ _ (eventually_and _ _ (eventually_below 1 ltac:(lra))
    (eventually_for_all (fun t e =>
      signed_crossing_of_step (moved_right x e) (moved_right x (- e)) t =
        (if is_on_segment x t then if negative (vy (along t)) then (-1)%Z else 1%Z else 0%Z) /\
      ~ lies_on (moved_right x e) t /\ ~ lies_on (moved_right x (- e)) t) segments _))).
  - intros e [[some _] each].
    assert (free : off (moved_right x e) segments) by (intros t T; apply (each t T)).
    assert (free' : off (moved_right x (- e)) segments) by (intros t T; apply (each t T)).
    split; [exact free |]. split; [exact free' |].
    pose proof (step_changes_winding_number _ _ segments closed free free') as change.
    rewrite (map_ext_in _ (fun t => if is_on_segment x t then if negative (vy (along t)) then (-1)%Z else 1%Z else 0%Z))
      in change by (intros t T; apply (each t T)).
    unfold upward_less_downward. rewrite change; [lia |]. unfold nonzero, minus, moved_right. cbn [vx vy]. lra.
  - intros t T. destruct (is_on_spec x t) as [on | free]; [| now apply crossing_of_another_segment].
    destruct (passed_ t T on) as [inside_ slanted]. exists 1. split; [lra |]. intros e some _.
    now apply crossing_of_a_passing_segment.
Qed.

(* Inside a loop: off its edges, which go round the point. *)
Definition inside_loop (x : vector) (loop : list vector) : Prop :=
  off x (edges loop) /\ winding_number x (edges loop) <> 0%Z.

Lemma middle_of_is_inside (s : segment) : strictly_inside (middle_of s) s.
Proof. apply strictly_inside_at. lra. Qed.

(* No other edge of a simple chain has the middle of one. *)
Lemma middle_is_on_one_edge (loop : list vector) (i j : nat) : simple loop ->
  (i < length loop)%nat -> (j < length loop)%nat -> lies_on (middle_of (edge_at loop i)) (edge_at loop j) -> i = j.
Proof.
  intros (_ & long & common) I J on. destruct (Nat.eq_dec i j) as [same_ | differ]; [exact same_ | exfalso].
  pose proof (edges_of_simple_chains loop i long I) as some.
  pose proof (strictly_inside_lies_on _ _ (middle_of_is_inside (edge_at loop i))) as on_i.
  assert (middle_is : forall c, c = vertex loop i \/ c = vertex loop (next i (length loop)) ->
    ~ equal_vectors (middle_of (edge_at loop i)) c).
  { intros c which [X Y]. apply some. rewrite edge_is in X, Y by exact I. unfold middle_of, point_at, minus in *.
    cbn [source target vx vy] in *. destruct which as [-> | ->]; split; lra. }
  destruct (common i j _ I J differ on_i on) as [[-> is_vertex_] | [i_is is_vertex_]].
  - exact (middle_is _ (or_intror eq_refl) is_vertex_).
  - exact (middle_is _ (or_introl eq_refl) is_vertex_).
Qed.

Lemma one_edge_at_its_middle (loop : list vector) (i : nat) : simple loop -> (i < length loop)%nat ->
  let s := edge_at loop i in
  upward_less_downward (middle_of s) (edges loop) = if negative (vy (along s)) then (-1)%Z else 1%Z.
Proof.
  intros simple_ I s. assert (I' : (i < length (edges loop))%nat) by now rewrite edges_are_as_many.
  destruct (nth_split (edges loop) no_segment I') as (front & back & split_ & place_).
  assert (others : forall l, (forall t, In t l -> exists j, (j < length loop)%nat /\ i <> j /\ t = edge_at loop j) ->
    upward_less_downward (middle_of s) l = 0%Z).
  { induction l as [| t l IH]; intros each; [reflexivity |]. unfold upward_less_downward, sum in *.
    cbn [map fold_right].
    rewrite IH by (intros u U; apply each; now right). destruct (each t (or_introl eq_refl)) as (j & J & differ & ->).
    destruct (is_on_spec (middle_of s) (edge_at loop j)) as [on |]; [| reflexivity].
    destruct differ. now apply (middle_is_on_one_edge loop). }
  fold (edge_at loop i) in split_. fold s in split_.
  assert (by_place : forall t k, nth_error (front ++ back) k = Some t ->
    exists j, (j < length loop)%nat /\ i <> j /\ t = edge_at loop j).
  { intros t k found. destruct (Nat.lt_ge_cases k i) as [less | more].
    - exists k. split; [lia |]. split; [lia |]. unfold edge_at. rewrite split_, app_nth1 by lia.
      rewrite nth_error_app1 in found by lia. symmetry. now apply nth_error_nth.
    - assert (short : (k < length (front ++ back))%nat) by (apply nth_error_Some; congruence).
      assert (whole : length (edges loop) = S (length (front ++ back)))
        by (rewrite split_, !app_length; cbn [length]; lia).
      rewrite edges_are_as_many in whole. exists (S k). split; [lia |]. split; [lia |]. unfold edge_at.
      rewrite split_, app_nth2 by lia. rewrite nth_error_app2 in found by lia.
      replace (S k - length front)%nat with (S (k - length front))%nat by lia. cbn [nth]. symmetry.
      now apply nth_error_nth. }
  assert (sum_is : upward_less_downward (middle_of s) (edges loop) =
    (upward_less_downward (middle_of s) (front ++ back) + upward_less_downward (middle_of s) [s])%Z).
  { rewrite split_. unfold upward_less_downward. rewrite !map_app, !sum_of_both. unfold sum. cbn [map fold_right].
    lia. }
  rewrite sum_is, others
    by (intros t T; apply In_nth_error in T; destruct T as (k & T); exact (by_place t k T)).
  unfold upward_less_downward, sum. cbn [map fold_right].
  destruct (is_on_spec (middle_of s) s) as [_ | no]; [destruct (negative _); reflexivity |].
  destruct no. apply strictly_inside_lies_on, middle_of_is_inside.
Qed.

(* Lemma. Just to the right of an edge that leads upwards is inside a clockwise loop, and to its left is not; to the
   left of an edge that leads downwards is inside, and to its right is not. *)
Lemma inside_is_beside_the_edge (loop : list vector) (i : nat) :
  simple loop -> is_counterclockwise loop = false -> (i < length loop)%nat ->
  let s := edge_at loop i in let m := middle_of s in
  (leads_upwards s -> eventually (fun e => inside_loop (moved_right m e) loop /\
    ~ inside_loop (moved_right m (- e)) loop)) /\
  (leads_downwards s -> eventually (fun e => inside_loop (moved_right m (- e)) loop /\
    ~ inside_loop (moved_right m e) loop)).
Proof.
  intros simple_ clockwise I s m.
  assert (vy_along : vy (along s) == vy (target s) - vy (source s)) by (unfold along, minus; cbn [vy]; ring).
  assert (passed_ : leads_upwards s \/ leads_downwards s -> passed_up_or_down m (edges loop)).
  { intros slanted t T on. apply (In_nth _ _ no_segment) in T. destruct T as (j & J & <-).
    rewrite edges_are_as_many in J.
    fold (edge_at loop j) in on |- *. rewrite <- (middle_is_on_one_edge loop i j simple_ I J on).
    split; [apply middle_of_is_inside | exact slanted]. }
  split; intros way; (refine (eventually_implied _ _ _ (across_a_point m (edges loop) (closed_chain_cycles loop) _));
    [| apply passed_; tauto]); intros e (free & free' & change); unfold m, s in change;
    rewrite one_edge_at_its_middle in change by assumption; fold s in change; fold m in change;
    pose proof (winding_numbers_of_simple_chains loop _ simple_ free) as at_right;
    pose proof (winding_numbers_of_simple_chains loop _ simple_ free') as at_left;
    rewrite clockwise in at_right, at_left; unfold leads_upwards, leads_downwards in way;
    destruct (negative_spec (vy (along s))); try (exfalso; lra);
    (split; [split; [assumption | lia] | intros [_ inside_]; lia]).
Qed.

(* Theorem. Whatever the loop and the closed chains, if none of the segments at the middle of the loop's edge ends
   there or is horizontal: the winding number inside the loop, beside that middle, is that of the ray to the left if
   the edge leads upwards; if it leads downwards, one more for each segment there that leads upwards, and one less for
   each that leads downwards. *)
Theorem left_rays_from_a_loop (segments : list segment) (loop : list vector) (i : nat) :
  cycles segments -> simple loop -> is_counterclockwise loop = false -> (i < length loop)%nat ->
  let s := edge_at loop i in let m := middle_of s in passed_up_or_down m segments ->
  (leads_upwards s -> eventually (fun e => let x := moved_right m e in inside_loop x loop /\ off x segments /\
     winding_number x segments = left_ray_number (moved_right m e) segments)) /\
  (leads_downwards s -> eventually (fun e => let x := moved_right m (- e) in inside_loop x loop /\ off x segments /\
     winding_number x segments =
       (left_ray_number (moved_right m e) segments + upward_less_downward m segments)%Z)).
Proof.
  intros closed simple_ clockwise I s m passed_.
  destruct (inside_is_beside_the_edge loop i simple_ clockwise I) as [up down]. fold s in up, down. fold m in up, down.
  assert (some_ray : nonzero to_the_left) by (unfold nonzero, to_the_left; cbn [vx vy]; lra).
  split; intros way; [specialize (up way) | specialize (down way)];
    refine (eventually_implied _ _ _ (eventually_and _ _ ltac:(eassumption)
      (across_a_point m segments closed passed_)));
    intros e ([inside_ _] & free & free' & change); unfold left_ray_number;
    rewrite winding_number_by_any_ray by assumption; cbv zeta;
    (split; [exact inside_ | split; [assumption | first [reflexivity | exact change]]]).
Qed.
