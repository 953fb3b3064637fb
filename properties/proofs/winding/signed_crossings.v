(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Along a path, the winding number changes by the signed crossings, counted as in
   properties/statements/chapter4/observation_4_2_5_signed_crossings.cpp. *)
From Coq Require Import QArith Qminmax Lqa ZArith Lia Bool List.
From Oplus Require Import winding shifted_ray small_numbers.
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
Lemma crossings_of_free_paths : forall segments path first,
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

(* A point of the path moved by (e, e^2), which the path's points on the chains need. *)
Definition shifted (p : vector) : shifted_point := ShiftedPoint p (Vector 1 0) (Vector 0 1).

Lemma side_of_segment_nearby : forall p s, nonzero (minus (target s) (source s)) ->
  eventually (fun e =>
    side_of_segment s (moved (shifted p) e) = side_of_segment s p /\
    orientation (source s) (target s) (moved (shifted p) e) <> Eq).
Proof.
  intros p s N. destruct (side_nearby (shifted p) s) as (l & L & H).
  exists l. split; [exact L |]. intros e E M. specialize (H e E M). unfold side_of_segment. rewrite H.
  pose proof (turn_to_shift_decides _ N) as T.
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
  intros from to a N. set (d := minus to from) in *.
  set (o := (vx to - vx from) * (vy a - vy from) - (vy to - vy from) * (vx a - vx from)).
  destruct (quadratic_nearby o (vy d) (- vx d)) as (l & L & H).
  exists l. split; [exact L |]. intros e E M. specialize (H e E M).
  pose proof (turn_to_shift_decides _ N) as T. unfold side_of_step.
  assert (X : orientation (moved (shifted from) e) (moved (shifted to) e) a =
              sign_nearby o (vy d) (- vx d)).
  { rewrite <- H. unfold orientation. apply compare_as_difference. unfold o, d. cbn. ring. }
  assert (Y : orientation from to a = (o ?= 0)).
  { unfold orientation. apply compare_as_difference. unfold o. ring. }
  assert (Z : match vy d ?= 0 with Eq => - vx d ?= 0 | c => c end = CompOpp (turn_to_shift d)).
  { unfold turn_to_shift.
    rewrite (compare_as_difference (- vx d) 0 0 (vx d)) by ring.
    rewrite <- (Qcompare_antisym (vx d) 0). destruct (vy d ?= 0); reflexivity. }
  rewrite X, Y. unfold sign_nearby. rewrite Z. fold d.
  destruct (o ?= 0); try reflexivity. destruct (turn_to_shift d); [now destruct T | reflexivity ..].
Qed.

Lemma step_nearby : forall from to s, nonzero (minus to from) ->
  eventually (fun e =>
    signed_crossing_of_step (moved (shifted from) e) (moved (shifted to) e) s =
    signed_crossing_of_step from to s).
Proof.
  intros from to s N.
  destruct (side_of_step_nearby from to (source s) N) as (l1 & L1 & H1).
  destruct (side_of_step_nearby from to (target s) N) as (l2 & L2 & H2).
  destruct (zero_spec (vx (target s) - vx (source s))) as [X | X],
    (zero_spec (vy (target s) - vy (source s))) as [Y | Y].
  1: { (* a segment of length zero is on one side of everything *)
    exists (Qmin l1 l2). split; [now apply Q.min_glb_lt |]. intros e E M.
    pose proof (Q.le_min_l l1 l2). pose proof (Q.le_min_r l1 l2).
    unfold signed_crossing_of_step. rewrite H1, H2 by lra.
    assert (side_of_step from to (source s) = side_of_step from to (target s)) as ->.
    { unfold side_of_step, orientation.
      rewrite (compare_as_difference ((vx to - vx from) * (vy (source s) - vy from)) ((vy to - vy from) * (vx (source s) - vx from))
                 ((vx to - vx from) * (vy (target s) - vy from)) ((vy to - vy from) * (vx (target s) - vx from)));
        [reflexivity |].
      assert (vx (target s) == vx (source s)) as -> by lra.
      assert (vy (target s) == vy (source s)) as -> by lra. ring. }
    destruct (side_of_step from to (target s)); cbn [same_side]; rewrite !orb_true_r; reflexivity. }
  all: assert (D : nonzero (minus (target s) (source s))) by (unfold nonzero, minus; cbn; tauto);
    destruct (side_of_segment_nearby from s D) as (l3 & L3 & H3);
    destruct (side_of_segment_nearby to s D) as (l4 & L4 & H4);
    exists (Qmin (Qmin l1 l2) (Qmin l3 l4));
    (split; [repeat apply Q.min_glb_lt; assumption |]); intros e E M;
    pose proof (Q.le_min_l (Qmin l1 l2) (Qmin l3 l4)); pose proof (Q.le_min_r (Qmin l1 l2) (Qmin l3 l4));
    pose proof (Q.le_min_l l1 l2); pose proof (Q.le_min_r l1 l2);
    pose proof (Q.le_min_l l3 l4); pose proof (Q.le_min_r l3 l4);
    unfold signed_crossing_of_step; rewrite H1, H2 by lra;
    destruct (H3 e E) as [-> _]; [lra |]; destruct (H4 e E) as [-> _]; [lra | reflexivity].
Qed.

Lemma shifted_leaves_its_height : forall p, leaves_its_height (shifted p).
Proof. intros p. split; cbn; lra. Qed.

Lemma shifted_off : forall p s,
  eventually (fun e => ~ lies_on (moved (shifted p) e) s).
Proof.
  intros p s.
  destruct (zero_spec (vx (target s) - vx (source s))) as [X | X],
    (zero_spec (vy (target s) - vy (source s))) as [Y | Y].
  1: { destruct (below_nearby (shifted p) (source s) (shifted_leaves_its_height p)) as (l & L & H).
       exists l. split; [exact L |]. intros e E M (t & _ & _ & I). destruct (H e E M) as [_ N].
       apply N. rewrite I. setoid_replace (vy (target s)) with (vy (source s)) by lra. ring. }
  all: assert (D : nonzero (minus (target s) (source s))) by (unfold nonzero, minus; cbn; tauto);
    destruct (side_of_segment_nearby p s D) as (l & L & H); exists l; (split; [exact L |]);
    intros e E M I; destruct (H e E M) as [_ N]; apply N; now apply on_its_line.
Qed.

Lemma crossing_of_shifted : forall p s, ~ lies_on p s ->
  eventually (fun e =>
    signed_crossing (moved (shifted p) e) s = signed_crossing p s).
Proof.
  intros p s N.
  destruct (below_nearby (shifted p) (source s) (shifted_leaves_its_height p)) as (l1 & L1 & H1).
  destruct (below_nearby (shifted p) (target s) (shifted_leaves_its_height p)) as (l2 & L2 & H2).
  destruct (side_nearby (shifted p) s) as (l3 & L3 & H3).
  exists (Qmin l1 (Qmin l2 l3)). split; [repeat apply Q.min_glb_lt; assumption |]. intros e E M.
  pose proof (Q.le_min_l l1 (Qmin l2 l3)). pose proof (Q.le_min_r l1 (Qmin l2 l3)).
  pose proof (Q.le_min_l l2 l3). pose proof (Q.le_min_r l2 l3).
  destruct (H1 e E) as [B1 _]; [lra |]. destruct (H2 e E) as [B2 _]; [lra |].
  assert (e < l3) as E3 by lra. specialize (H3 e E E3).
  change (is_above (shifted p)) with true in B1, B2. cbv iota in B1, B2.
  change (vy (at_ (shifted p))) with (vy p) in B1, B2.
  pose proof (beside_what_crosses OfQ right p s N) as O.
  pose proof (the_codes_ray p s) as C. unfold signed_crossing, signed_crossing_of_ray, ray_crossing in C.
  unfold signed_crossing, ray_crossing. rewrite B1, B2, H3.
  assert (K : forall a, at_most (vy a) (vy p) = negb (left_of_ray OfQ right (minus a p))).
  { intros a. unfold at_most, left_of_ray, negative.
    rewrite (compare_as_difference (cross (minus a p) right) 0 (vy p) (vy a))
      by (unfold cross, minus, right; cbn; ring).
    rewrite <- (Qcompare_antisym (vy a) (vy p)). destruct (vy a ?= vy p); reflexivity. }
  rewrite !K.
  destruct (left_of_ray OfQ right (minus (source s) p)), (left_of_ray OfQ right (minus (target s) p));
    cbn [negb Bool.eqb]; try reflexivity;
    (assert (T : true <> false) by discriminate; assert (F : false <> true) by discriminate);
    try specialize (O T); try specialize (O F); unfold side; cbn [shifted at_];
    destruct (orientation (source s) (target s) p); try reflexivity; now destruct O.
Qed.

Lemma path_nearby : forall segments path,
  eventually (fun e =>
    signed_crossings_of_path (map (fun p => moved (shifted p) e) path) segments =
    signed_crossings_of_path path segments).
Proof.
  intros segments path. induction path as [| from [| to rest] IH].
  - exists 1. split; [lra | reflexivity].
  - exists 1. split; [lra | reflexivity].
  - destruct IH as (l & L & H).
    assert (S : eventually (fun e =>
      (if zero (vx to - vx from) && zero (vy to - vy from) then 0%Z
       else sum (map (signed_crossing_of_step (moved (shifted from) e) (moved (shifted to) e)) segments)) =
      (if zero (vx to - vx from) && zero (vy to - vy from) then 0%Z
       else sum (map (signed_crossing_of_step from to) segments)))).
    { destruct (zero (vx to - vx from) && zero (vy to - vy from)) eqn:Z.
      - exists 1. split; [lra | reflexivity].
      - assert (N : nonzero (minus to from)).
        { unfold nonzero, minus; cbn. destruct (zero_spec (vx to - vx from)), (zero_spec (vy to - vy from));
            cbn in Z; try discriminate; tauto. }
        destruct (eventually_for_all (fun s e =>
          signed_crossing_of_step (moved (shifted from) e) (moved (shifted to) e) s =
          signed_crossing_of_step from to s) segments) as (k & K & F).
        { intros s _. now apply step_nearby. }
        exists k. split; [exact K |]. intros e E M. f_equal. apply map_ext_in. exact (F e E M). }
    destruct S as (k & K & F). exists (Qmin k l). split; [now apply Q.min_glb_lt |]. intros e E M.
    pose proof (Q.le_min_l k l). pose proof (Q.le_min_r k l).
    assert (zero_moved : forall a b, zero (vx (moved (shifted a) e) - vx (moved (shifted b) e)) =
                                     zero (vx a - vx b) /\
                                     zero (vy (moved (shifted a) e) - vy (moved (shifted b) e)) =
                                     zero (vy a - vy b)).
    { intros a b. unfold zero. split.
      - rewrite (compare_as_difference _ 0 (vx a - vx b) 0) by (cbn; ring). reflexivity.
      - rewrite (compare_as_difference _ 0 (vy a - vy b) 0) by (cbn; ring). reflexivity. }
    assert (unfolded : forall a b others, signed_crossings_of_path (a :: b :: others) segments =
      ((if zero (vx b - vx a) && zero (vy b - vy a) then 0
        else sum (map (signed_crossing_of_step a b) segments))
       + signed_crossings_of_path (b :: others) segments)%Z) by reflexivity.
    cbn [map]. rewrite !unfolded. destruct (zero_moved to from) as [-> ->].
    rewrite F by lra. cbn [map] in H. rewrite H by lra. reflexivity.
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
  destruct (path_nearby segments (first :: path)) as (l1 & L1 & H1).
  assert (S : forall p, eventually (fun e =>
    off (moved (shifted p) e) segments)).
  { intros p. apply (eventually_for_all (fun s e => ~ lies_on (moved (shifted p) e) s)).
    intros s _. apply shifted_off. }
  destruct (eventually_for_all (fun p e => off (moved (shifted p) e) segments) (first :: path)
              (fun p _ => S p)) as (l2 & L2 & H2).
  assert (W : forall p, off p segments -> eventually (fun e =>
    winding_number (moved (shifted p) e) segments = winding_number p segments)).
  { intros p F.
    destruct (eventually_for_all (fun s e =>
      signed_crossing (moved (shifted p) e) s = signed_crossing p s) segments) as (k & K & G).
    { intros s I. apply crossing_of_shifted. now apply F. }
    exists k. split; [exact K |]. intros e E M. unfold winding_number. f_equal.
    apply map_ext_in. exact (G e E M). }
  destruct (W first O) as (l3 & L3 & H3). destruct (W (last path first) P) as (l4 & L4 & H4).
  set (e := (1 # 2) * Qmin (Qmin l1 l2) (Qmin l3 l4)).
  assert (0 < Qmin (Qmin l1 l2) (Qmin l3 l4)) by (repeat apply Q.min_glb_lt; assumption).
  assert (E : e < Qmin (Qmin l1 l2) (Qmin l3 l4)) by (unfold e; lra).
  assert (E0 : 0 < e) by (unfold e; lra).
  pose proof (Q.le_min_l (Qmin l1 l2) (Qmin l3 l4)). pose proof (Q.le_min_r (Qmin l1 l2) (Qmin l3 l4)).
  pose proof (Q.le_min_l l1 l2). pose proof (Q.le_min_r l1 l2).
  pose proof (Q.le_min_l l3 l4). pose proof (Q.le_min_r l3 l4). clearbody e.
  rewrite <- (H1 e) by lra. rewrite <- (H3 e) by lra. rewrite <- (H4 e) by lra.
  cbn [map]. rewrite crossings_of_free_paths.
  - rewrite (last_of_images _ _ (fun p => moved (shifted p) e)). reflexivity.
  - exact C.
  - intros p I. change (moved (shifted first) e :: map (fun q => moved (shifted q) e) path) with
      (map (fun q => moved (shifted q) e) (first :: path)) in I.
    apply in_map_iff in I. destruct I as (q & <- & I). apply H2; [exact E0 | lra | exact I].
Qed.
