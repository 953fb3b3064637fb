(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Along a path, the winding number changes by the signed crossings, counted as in
   properties/statements/chapter4/section_4_2_signed_crossings.cpp. *)
From Coq Require Import ZArith Lia Bool List.
From Oplus Require Import numbers winding shifted_ray small_numbers.
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
  pose proof (square_positive u A) as S.
  assert (I : dot u u * cross d v == dot u v * cross d u) by (unfold cross, dot in *; by_equations).
  assert (F : forall w, cross w d == - cross d w) by (intros; unfold cross; ring).
  set (q := dot u u) in *. clearbody q.
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
  intros from to s N F T d k. unfold signed_crossing_of_step, signed_crossing_of_ray, ray_crossing.
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
  unfold signed_crossing, ray_crossing. rewrite !H, O. reflexivity.
Qed.

Lemma last_of_more : forall A (rest : list A) a d, last (a :: rest) d = last rest a.
Proof.
  intros A rest. induction rest as [| b rest IH]; intros a d; [reflexivity |].
  change (last (a :: b :: rest) d) with (last (b :: rest) d). rewrite !IH. reflexivity.
Qed.

(* For paths whose points are off the chains; their steps may pass through vertices of the chains and run
   along their edges. *)
(* One step of a path. *)
Definition crossings_of_step (from to : vector) (segments : list segment) : Z :=
  if zero (vx to - vx from) && zero (vy to - vy from) then 0 else sum (map (signed_crossing_of_step from to) segments).

Lemma crossings_of_more : forall from to rest segments,
  signed_crossings_of_path (from :: to :: rest) segments =
  (crossings_of_step from to segments + signed_crossings_of_path (to :: rest) segments)%Z.
Proof. reflexivity. Qed.

Lemma crossings_of_free_paths : forall segments path first,
  cycles segments -> (forall p, In p (first :: path) -> off p segments) ->
  signed_crossings_of_path (first :: path) segments =
  (winding_number (last path first) segments - winding_number first segments)%Z.
Proof.
  intros segments path. induction path as [| to rest IH]; intros first C O; [cbn; lia |].
  rewrite crossings_of_more, (IH to C), last_of_more by (intros p I; apply O; now right). unfold crossings_of_step.
  destruct (zero_spec (vx to - vx first)) as [X |], (zero_spec (vy to - vy first)) as [Y |]; cbn [andb];
    [rewrite (winding_number_of_equal to first) by lra; lia | ..];
    (rewrite step_changes_winding_number; [lia | exact C | apply O; cbn; tauto .. | intros []; contradiction]).
Qed.

(* A point of the path moved by (e, e^2), which the path's points on the chains need. *)
Definition shifted (p : vector) : shifted_point := ShiftedPoint p (Vector 1 0) (Vector 0 1).

Lemma side_of_segment_nearby : forall p s, nonzero (minus (target s) (source s)) ->
  eventually (fun e =>
    side_of_segment s (moved (shifted p) e) = side_of_segment s p /\
    orientation (source s) (target s) (moved (shifted p) e) <> Eq).
Proof.
  intros p s N. refine (eventually_implied _ _ _ (side_nearby (shifted p) s)). intros e H.
  unfold side_of_segment. rewrite H. pose proof (turn_to_shift_decides _ N) as T.
  unfold side. cbn [shifted at_ first second]. set (d := minus (target s) (source s)) in *.
  assert (U : match cross d (Vector 1 0) ?= 0 with
              | Eq => cross d (Vector 0 1) ?= 0 | by_first => by_first end = turn_to_shift d).
  { unfold turn_to_shift.
    rewrite (compare_as_difference (cross d (Vector 1 0)) 0 0 (vy d)) by (unfold cross; cbn; ring).
    rewrite (compare_as_difference (cross d (Vector 0 1)) 0 (vx d) 0) by (unfold cross; cbn; ring).
    rewrite <- (Qcompare_antisym (vy d) 0). destruct (vy d ?= 0); reflexivity. }
  rewrite U. destruct (orientation (source s) (target s) p), (turn_to_shift d); split; congruence.
Qed.

Lemma side_of_step_nearby : forall from to a, nonzero (minus to from) ->
  eventually (fun e =>
    side_of_step (moved (shifted from) e) (moved (shifted to) e) a = side_of_step from to a).
Proof.
  intros from to a N. set (d := minus to from) in *. set (o := cross d (minus a from)).
  refine (eventually_implied _ _ _ (quadratic_nearby o (vy d) (- vx d))). intros e H. unfold side_of_step.
  assert (X : orientation (moved (shifted from) e) (moved (shifted to) e) a = sign_nearby o (vy d) (- vx d)).
  { rewrite <- H. apply compare_as_difference. unfold o, d, cross. cbn. ring. }
  assert (Y : orientation from to a = (o ?= 0)) by (apply compare_as_difference; unfold o, d, cross; cbn; ring).
  rewrite X, Y. unfold sign_nearby, turn_to_shift. fold d. pose proof (turn_to_shift_decides _ N) as T.
  rewrite (compare_as_difference (- vx d) 0 0 (vx d)) by ring. rewrite <- (Qcompare_antisym (vx d) 0).
  unfold turn_to_shift in T. destruct (o ?= 0), (vy d ?= 0), (vx d ?= 0); trivial; now destruct T.
Qed.

Lemma step_nearby : forall from to s, nonzero (minus to from) ->
  eventually (fun e =>
    signed_crossing_of_step (moved (shifted from) e) (moved (shifted to) e) s =
    signed_crossing_of_step from to s).
Proof.
  intros from to s N.
  pose proof (eventually_and _ _ (side_of_step_nearby from to (source s) N) (side_of_step_nearby from to (target s) N))
    as ends.
  destruct (zero_or_not (minus (target s) (source s))) as [[X Y] | D].
  - (* a segment of length zero is on one side of everything *)
    refine (eventually_implied _ _ _ ends). intros e [H1 H2]. unfold signed_crossing_of_step. rewrite H1, H2.
    assert (side_of_step from to (source s) = side_of_step from to (target s)) as ->.
    { unfold side_of_step. replace (orientation from to (source s)) with (orientation from to (target s));
        [reflexivity |]. cbn in X, Y. apply compare_as_difference.
      assert (vx (target s) == vx (source s) /\ vy (target s) == vy (source s)) as [-> ->] by lra. ring. }
    destruct (side_of_step from to (target s)); cbn [same_side]; rewrite !orb_true_r; reflexivity.
  - refine (eventually_implied _ _ _ (eventually_and _ _ ends
      (eventually_and _ _ (side_of_segment_nearby from s D) (side_of_segment_nearby to s D)))).
    intros e ([H1 H2] & [H3 _] & [H4 _]). unfold signed_crossing_of_step. now rewrite H1, H2, H3, H4.
Qed.

Lemma shifted_is_above (p : vector) : is_above (shifted p) = true.
Proof. unfold is_above. cbn [shifted first second vy]. destruct (positive_spec 1); [apply orb_true_r | lra]. Qed.

Lemma shifted_leaves_its_height : forall p, leaves_its_height (shifted p).
Proof. intros p. split; cbn; lra. Qed.

Lemma shifted_off : forall p s, eventually (fun e => ~ lies_on (moved (shifted p) e) s).
Proof.
  intros p s. destruct (zero_or_not (minus (target s) (source s))) as [[X Y] | D].
  - refine (eventually_implied _ _ _ (below_nearby (shifted p) (source s) (shifted_leaves_its_height p))).
    intros e [_ N] (t & _ & _ & I). apply N. rewrite I. cbn in X, Y.
    setoid_replace (vy (target s)) with (vy (source s)) by lra. ring.
  - refine (eventually_implied _ _ _ (side_of_segment_nearby p s D)). intros e [_ N] I. now apply N, on_its_line.
Qed.

Lemma shifted_off_all (x : vector) (segments : list segment) :
  eventually (fun e => off (moved (shifted x) e) segments).
Proof. exact (eventually_for_all _ segments (fun s _ => shifted_off x s)). Qed.

Lemma crossing_beside (p : vector) (s : segment) :
  eventually (fun e => signed_crossing (moved (shifted p) e) s = signed_crossing p s).
Proof.
  pose proof (below_nearby (shifted p) (source s) (shifted_leaves_its_height p)) as source_height.
  pose proof (below_nearby (shifted p) (target s) (shifted_leaves_its_height p)) as target_height.
  pose proof (side_nearby (shifted p) s) as on_side.
  refine (eventually_implied _ _ _ (eventually_and _ _ source_height (eventually_and _ _ target_height on_side))).
  intros e ((source_is & _) & (target_is & _) & side_is).
  rewrite (shifted_is_above p) in *. cbv iota in *.
  change (vy (at_ (shifted p))) with (vy p) in *.
  unfold signed_crossing. rewrite source_is, target_is, side_is. unfold side. cbn [shifted at_ first second].
  destruct (orientation (source s) (target s) p); try reflexivity. unfold ray_crossing, at_most.
  compared_numbers (vy (source s) ?= vy p); compared_numbers (vy (target s) ?= vy p);
    cbn [Bool.eqb]; try reflexivity;
    compared_numbers (cross (minus (target s) (source s)) (Vector 1 0) ?= 0);
    unfold cross, minus in *; cbn in *; try reflexivity; exfalso; lra.
Qed.

Lemma same_beside (x : vector) (segments : list segment) :
  eventually (fun e => winding_number (moved (shifted x) e) segments = winding_number x segments).
Proof.
  refine (eventually_implied _ _ _ (eventually_for_all _ segments (fun s _ => crossing_beside x s))).
  intros e same_ones. unfold winding_number. f_equal. now apply map_ext_in.
Qed.

Lemma crossings_of_step_nearby : forall from to segments,
  eventually (fun e =>
    crossings_of_step (moved (shifted from) e) (moved (shifted to) e) segments = crossings_of_step from to segments).
Proof.
  intros from to segments.
  assert (zero_moved : forall e,
    zero (vx (moved (shifted to) e) - vx (moved (shifted from) e)) = zero (vx to - vx from) /\
    zero (vy (moved (shifted to) e) - vy (moved (shifted from) e)) = zero (vy to - vy from)).
  { intros e. unfold zero. split; [rewrite (compare_as_difference _ 0 (vx to - vx from) 0)
      | rewrite (compare_as_difference _ 0 (vy to - vy from) 0)]; trivial; cbn; ring. }
  assert (steps : nonzero (minus to from) -> eventually (fun e => forall s, In s segments ->
    signed_crossing_of_step (moved (shifted from) e) (moved (shifted to) e) s = signed_crossing_of_step from to s))
    by (intros N; exact (eventually_for_all _ segments (fun s _ => step_nearby from to s N))).
  unfold crossings_of_step.
  destruct (zero_spec (vx to - vx from)), (zero_spec (vy to - vy from)); cbn [andb] in *;
    [exists 1; split; [lra |]; intros d _ _; now destruct (zero_moved d) as [-> ->] | ..];
    (refine (eventually_implied _ _ _ (steps _)); [| intros []; contradiction]);
    intros d F; destruct (zero_moved d) as [-> ->]; cbn [andb]; f_equal; now apply map_ext_in.
Qed.

Lemma path_nearby : forall segments path,
  eventually (fun e =>
    signed_crossings_of_path (map (fun p => moved (shifted p) e) path) segments =
    signed_crossings_of_path path segments).
Proof.
  intros segments path. induction path as [| from [| to rest] IH]; [exists 1; split; [lra | reflexivity] .. |].
  refine (eventually_implied _ _ _ (eventually_and _ _ (crossings_of_step_nearby from to segments) IH)).
  intros e [F H]. cbn [map] in *. now rewrite !crossings_of_more, F, H.
Qed.

Lemma last_of_images : forall A B (f : A -> B) l a, last (map f l) (f a) = f (last l a).
Proof.
  intros A B f l. induction l as [| b rest IH]; intros a; [reflexivity |].
  cbn [map]. rewrite !last_of_more. apply IH.
Qed.

(* Theorem. Along any path of straight steps between two points off closed chains, the signed crossings
   add up to the winding number at its end less that at its beginning. All between may be anywhere: on
   the chains, on their vertices, and the path may run along their edges. *)
Theorem signed_crossings_add_up : forall segments path first,
  cycles segments -> off first segments -> off (last path first) segments ->
  signed_crossings_of_path (first :: path) segments =
  (winding_number (last path first) segments - winding_number first segments)%Z.
Proof.
  intros segments path first C O P.
  destruct (some_small _ (eventually_and _ _ (eventually_and _ _ (path_nearby segments (first :: path))
    (eventually_for_all (fun p e => off (moved (shifted p) e) segments) (first :: path)
      (fun p _ => shifted_off_all p segments)))
    (eventually_and _ _ (same_beside first segments) (same_beside (last path first) segments))))
    as (e & _ & (<- & H2) & <- & <-).
  cbn [map]. rewrite crossings_of_free_paths.
  - rewrite (last_of_images _ _ (fun p => moved (shifted p) e)). reflexivity.
  - exact C.
  - intros p I. change (moved (shifted first) e :: map (fun q => moved (shifted q) e) path) with
      (map (fun q => moved (shifted q) e) (first :: path)) in I.
    apply in_map_iff in I. destruct I as (q & <- & I). now apply H2.
Qed.
