(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Along a path, the winding number changes by the signed crossings, counted as in
   properties/chapter4/observation_4_2_5_signed_crossings.cpp. *)
From Coq Require Import QArith Lqa ZArith Lia Bool List.
From Oplus Require Import direction angle sweep winding_number.
Import ListNotations.

Open Scope Q_scope.

(* The sign of [v, (e, e^2)] for an infinitesimal e > 0. *)
Definition turn_to_shift (v : vector) : comparison :=
  match vy v ?= 0 with Eq => vx v ?= 0 | c => CompOpp c end.

(* On which side of a segment, and of a step of a path, points are, if the path is shifted by (e, e^2):
   Gt is to the left, Lt to the right. *)
Definition side_of_segment (s : segment) (p : vector) : comparison :=
  match orientation (source s) (target s) p with
  | Eq => turn_to_shift (minus (target s) (source s))
  | c => c
  end.

Definition side_of_step (from to p : vector) : comparison :=
  match orientation from to p with Eq => CompOpp (turn_to_shift (minus to from)) | c => c end.

Definition same_side (a b : comparison) : bool :=
  match a, b with Lt, Lt | Eq, Eq | Gt, Gt => true | _, _ => false end.

Definition sign_of (c : comparison) : Z := match c with Lt => -1 | Eq => 0 | Gt => 1 end.

(* How the winding number changes along a step, where it crosses a segment: 1 from the segment's right
   to its left, -1 from left to right, 0 if it does not cross. *)
Definition signed_crossing_of_step (from to : vector) (s : segment) : Z :=
  let before := side_of_segment s from in
  let after := side_of_segment s to in
  if same_side before after || same_side (side_of_step from to (source s)) (side_of_step from to (target s))
  then 0
  else sign_of after.

(* Of a path's steps; a step of length zero crosses nothing. *)
Fixpoint signed_crossings_of_path (path : list vector) (segments : list segment) : Z :=
  match path with
  | from :: ((to :: _) as rest) =>
      (if zero (vx to - vx from) && zero (vy to - vy from) then 0
       else sum (map (signed_crossing_of_step from to) segments))
      + signed_crossings_of_path rest segments
  | _ => 0
  end.

(* To which side points on the path's line count. *)
Definition side_of_ties (d : vector) : summand :=
  match turn_to_shift d with Lt => OfP | _ => OfQ end.

Lemma turn_to_shift_decides : forall d, nonzero d -> turn_to_shift d <> Eq.
Proof.
  intros d N E. apply N. unfold turn_to_shift in E. compared_numbers (vy d ?= 0); try discriminate.
  apply equal_comparison in E. auto.
Qed.

Lemma side_of_step_is_side_of_ray : forall from to p, nonzero (minus to from) ->
  side_of_step from to p =
  (if left_of_ray (side_of_ties (minus to from)) (minus to from) (minus p from) then Gt else Lt).
Proof.
  intros from to p N. pose proof (turn_to_shift_decides _ N) as T.
  unfold side_of_step, side_of_ties, left_of_ray, orientation, negative.
  set (d := minus to from) in *.
  rewrite (compare_as_difference _ _ (cross d (minus p from)) 0) by (unfold d, cross, minus; cbn; ring).
  rewrite (compare_as_difference (cross (minus p from) d) 0 0 (cross d (minus p from)))
    by (unfold cross; ring).
  rewrite <- (Qcompare_antisym (cross d (minus p from)) 0).
  destruct (cross d (minus p from) ?= 0), (turn_to_shift d); cbn; congruence.
Qed.

(* The line of a step is the line of the rays from both its ends. *)
Lemma one_line : forall k from to p,
  left_of_ray k (minus to from) (minus p to) = left_of_ray k (minus to from) (minus p from).
Proof.
  intros k from to p. unfold left_of_ray, negative.
  rewrite (compare_as_difference (cross (minus p to) (minus to from)) 0
             (cross (minus p from) (minus to from)) 0) by (unfold cross, minus; cbn; ring).
  rewrite (compare_as_difference (cross (minus to from) (minus p to)) 0
             (cross (minus to from) (minus p from)) 0) by (unfold cross, minus; cbn; ring).
  reflexivity.
Qed.

(* Where a segment crosses the line of a ray from p, and p is not on it, p is on one of its sides. *)
Lemma beside_what_crosses : forall k d p s, ~ lies_on p s ->
  left_of_ray k d (minus (source s) p) <> left_of_ray k d (minus (target s) p) ->
  orientation (source s) (target s) p <> Eq.
Proof.
  intros k d p [a b] N C E. cbn [source target] in *. apply C. clear C.
  destruct (turns_around p _ N) as (A & B & D). cbn [source target] in A, B, D.
  apply equal_comparison in E.
  assert (Z : cross (minus a p) (minus b p) == 0) by (unfold cross, minus; cbn; lra).
  specialize (D Z). set (u := minus a p) in *. set (v := minus b p) in *. clearbody u v.
  assert (S : 0 < vx u * vx u + vy u * vy u).
  { destruct (Qlt_le_dec 0 (vx u * vx u + vy u * vy u)); [assumption |].
    exfalso. apply A. now apply no_squares. }
  assert (I : (vx u * vx u + vy u * vy u) * cross d v == dot u v * cross d u).
  { setoid_replace ((vx u * vx u + vy u * vy u) * cross d v) with
      (dot u v * cross d u + cross u v * dot d u) by (unfold cross, dot; ring).
    rewrite Z. ring. }
  assert (F : forall w, cross w d == - cross d w) by (intros; unfold cross; ring).
  set (q := vx u * vx u + vy u * vy u) in *. clearbody q.
  unfold left_of_ray. destruct k.
  - f_equal. destruct (negative_spec (cross d u)), (negative_spec (cross d v)); trivial; exfalso; nra.
  - destruct (negative_spec (cross u d)), (negative_spec (cross v d)); trivial; exfalso;
      rewrite F in *; nra.
Qed.

(* One step over one segment: it is on the rays from both ends of the step, or on that from one. *)
Lemma crossing_as_difference : forall from to s,
  nonzero (minus to from) -> ~ lies_on from s -> ~ lies_on to s ->
  let d := minus to from in
  let k := side_of_ties d in
  signed_crossing_of_step from to s =
  (signed_crossing_of_ray k d to s - signed_crossing_of_ray k d from s)%Z.
Proof.
  intros from to s N F T d k. unfold signed_crossing_of_step, signed_crossing_of_ray.
  rewrite !side_of_step_is_side_of_ray by exact N. fold d k.
  pose proof (one_line k from to (source s)) as S. pose proof (one_line k from to (target s)) as R.
  fold d in S, R.
  pose proof (beside_what_crosses k d from s F) as B. pose proof (beside_what_crosses k d to s T) as C.
  rewrite S, R in *. unfold side_of_segment.
  destruct (left_of_ray k d (minus (source s) from)), (left_of_ray k d (minus (target s) from));
    cbn [negb Bool.eqb]; try (rewrite orb_true_r; reflexivity);
    (assert (X : true <> false) by discriminate; assert (Y : false <> true) by discriminate);
    try specialize (B X); try specialize (B Y); try specialize (C X); try specialize (C Y);
    destruct (orientation (source s) (target s) from), (orientation (source s) (target s) to);
    try congruence; reflexivity.
Qed.

Lemma step_changes_winding_number : forall from to segments,
  cycles segments -> off from segments -> off to segments -> nonzero (minus to from) ->
  sum (map (signed_crossing_of_step from to) segments) =
  (winding_number to segments - winding_number from segments)%Z.
Proof.
  intros from to segments C F T N.
  rewrite <- (winding_number_by_any_ray from segments (side_of_ties (minus to from)) (minus to from))
    by assumption.
  rewrite <- (winding_number_by_any_ray to segments (side_of_ties (minus to from)) (minus to from))
    by assumption.
  unfold winding_number_by_ray. clear C. unfold sum.
  induction segments as [| s rest IH]; [reflexivity |]. cbn [map fold_right].
  rewrite (crossing_as_difference from to s N (F s (or_introl eq_refl)) (T s (or_introl eq_refl))).
  rewrite IH by (intros t I; first [now apply F; right | now apply T; right]). lia.
Qed.

Lemma winding_number_of_equal : forall p q segments, vx p == vx q -> vy p == vy q ->
  winding_number p segments = winding_number q segments.
Proof.
  intros p q segments X Y. unfold winding_number. f_equal. apply map_ext. intros s.
  assert (H : forall a, at_most a (vy p) = at_most a (vy q))
    by (intros a; unfold at_most; rewrite Y; reflexivity).
  assert (O : forall a b, orientation a b p = orientation a b q)
    by (intros a b; unfold orientation; rewrite X, Y; reflexivity).
  unfold signed_crossing. rewrite !H, O. reflexivity.
Qed.

Lemma last_of_more : forall A (rest : list A) a d, last (a :: rest) d = last rest a.
Proof.
  intros A rest. induction rest as [| b rest IH]; intros a d; [reflexivity |].
  change (last (a :: b :: rest) d) with (last (b :: rest) d). rewrite !IH. reflexivity.
Qed.

(* Theorem. Along any path of straight steps whose points are off closed chains, the signed crossings add
   up to the winding number at its end less that at its beginning. Its steps may pass through vertices
   of the chains and run along their edges. *)
Theorem signed_crossings_add_up : forall segments path first,
  cycles segments -> (forall p, In p (first :: path) -> off p segments) ->
  signed_crossings_of_path (first :: path) segments =
  (winding_number (last path first) segments - winding_number first segments)%Z.
Proof.
  intros segments path. induction path as [| to rest IH]; intros first C O.
  - cbn. lia.
  - change (signed_crossings_of_path (first :: to :: rest) segments) with
      ((if zero (vx to - vx first) && zero (vy to - vy first) then 0
        else sum (map (signed_crossing_of_step first to) segments))
       + signed_crossings_of_path (to :: rest) segments)%Z.
    rewrite (IH to C) by (intros p I; apply O; now right).
    rewrite last_of_more.
    destruct (zero_spec (vx to - vx first)) as [X |], (zero_spec (vy to - vy first)) as [Y |];
      cbn [andb].
    + rewrite (winding_number_of_equal to first) by lra. lia.
    + rewrite step_changes_winding_number; [lia | exact C | | |]; try (apply O; cbn; tauto).
      unfold nonzero, minus; cbn; tauto.
    + rewrite step_changes_winding_number; [lia | exact C | | |]; try (apply O; cbn; tauto).
      unfold nonzero, minus; cbn; tauto.
    + rewrite step_changes_winding_number; [lia | exact C | | |]; try (apply O; cbn; tauto).
      unfold nonzero, minus; cbn; tauto.
Qed.
