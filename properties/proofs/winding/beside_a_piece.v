(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Closed segments, and a piece that no other than collinear ones meet between its ends: all along it the winding
   number close to its right is the same, that right of its middle, as counted on symbolic shifts (shifted_ray.v). So it
   is along edges of regions that meet others at their ends only (right_of_an_edge.v). *)
From Coq Require Import ZArith Lia Bool List.
From Oplus Require Import numbers winding small_numbers shifted_ray signed_crossings tie_rule meeting_of_segments
  secants segments_apart neighbourhoods.
Import ListNotations.

Open Scope Q_scope.

(* A segment that does not meet another does not meet it either when that is shifted a little: all of it stays on one
   side of a line. *)
Lemma shifted_segments_do_not_meet (w1 w2 n : vector) (t : segment) :
  nonzero (minus w2 w1) -> (forall p, lies_on p (Segment w1 w2) -> ~ lies_on p t) ->
  eventually (fun e => forall p, lies_on p (Segment (moved_along w1 n e) (moved_along w2 n e)) -> ~ lies_on p t).
Proof.
  intros moves none. destruct t as [t0 t1].
  destruct (are_apart_decides w1 w2 t0 t1 moves) as [[found | (p & on & on_t)] _]; [| now destruct (none p on)].
  destruct (are_apart_sound _ _ _ _ found) as (w & f1 & f2 & f3 & f4).
  assert (near : forall a b, in_front w (minus b a) -> eventually (fun e => in_front w (minus b (moved_along a n e)))).
  { intros a b front. refine (eventually_implied _ _ _ (eventually_positive _ (- dot w n) front)).
    intros e. unfold in_front, dot, minus, moved_along. cbn [vx vy]. lra. }
  refine (eventually_implied _ _ _ (eventually_and _ _ (eventually_and _ _ (near _ _ f1) (near _ _ f2))
    (eventually_and _ _ (near _ _ f3) (near _ _ f4)))).
  intros e [[g1 g2] [g3 g4]] p. apply apart_have_no_common_point. now exists w.
Qed.

Definition point_at (s : segment) (k : Q) : vector :=
  Vector ((1 - k) * vx (source s) + k * vx (target s)) ((1 - k) * vy (source s) + k * vy (target s)).

Lemma point_at_lies_on (s : segment) (k : Q) : 0 <= k <= 1 -> lies_on (point_at s k) s.
Proof. intros range. exists k. split; [exact range |]. split; reflexivity. Qed.

Lemma strictly_inside_at (s : segment) (k : Q) : 0 < k < 1 -> strictly_inside (point_at s k) s.
Proof. intros range. exists k. split; [exact range |]. split; reflexivity. Qed.

Lemma right_step_is_right (s : segment) (w n : vector) (e : Q) :
  area s w == 0 -> 0 < cross (along s) n -> 0 < e -> area s (moved_along w n (- e)) < 0.
Proof.
  intros line left_ some. setoid_replace (area s (moved_along w n (- e))) with (area s w - e * cross (along s) n)
    by by_coordinates.
  rewrite line. nra.
Qed.

(* All of t is on the line of s. *)
Definition collinear (s t : segment) : Prop := area s (source t) == 0 /\ area s (target t) == 0.

Lemma collinear_dec (s t : segment) : {collinear s t} + {~ collinear s t}.
Proof.
  unfold collinear. destruct (Qeq_dec (area s (source t)) 0), (Qeq_dec (area s (target t)) 0); [left | right ..]; tauto.
Qed.

Lemma area_of_collinear (s t : segment) (w : vector) : collinear s t -> lies_on w t -> area s w == 0.
Proof. intros [a b] (k & _ & X & Y). in_coordinates. by_equations. Qed.

(* What has a point strictly inside the piece is collinear. *)
Definition met_only_along (segments : list segment) (s : segment) : Prop :=
  forall w t, strictly_inside w s -> In t segments -> lies_on w t -> collinear s t.

Lemma strictly_inside_reversed (w : vector) (s : segment) : strictly_inside w s -> strictly_inside w (reversed s).
Proof.
  intros (k & range & X & Y). exists (1 - k). cbn [reversed source target]. split; [lra |].
  rewrite X, Y. split; ring.
Qed.

Lemma reversed_twice (s : segment) : reversed (reversed s) = s.
Proof. now destruct s. Qed.

Lemma met_only_along_reversed (segments : list segment) (s : segment) :
  met_only_along segments s -> met_only_along segments (reversed s).
Proof.
  intros only w t inside_ J on. apply strictly_inside_reversed in inside_. rewrite reversed_twice in inside_.
  destruct (only w t inside_ J on) as [a b]. split; rewrite area_reversed; lra.
Qed.

Definition value_to_the_right (segments : list segment) (s : segment) (w : vector) (number : Z) : Prop :=
  exists radius, 0 < radius /\ forall y, within radius w y -> area s y < 0 -> winding_number y segments = number.

Section OnePiece.
  Variable segments : list segment.
  Variable s : segment.
  Hypothesis closed : cycles segments.
  Hypothesis along_only : met_only_along segments s.
  Hypothesis long : nonzero (along s).

  (* All points close to the right of a point of the piece have one winding number. *)
  Lemma right_side_is_alike (w : vector) : strictly_inside w s ->
    exists radius, 0 < radius /\ forall y z, within radius w y -> within radius w z ->
      area s y < 0 -> area s z < 0 -> winding_number y segments = winding_number z segments.
  Proof.
    intros inside_. set (others := filter (fun t => if lies_on_dec w t then false else true) segments).
    assert (free : off w others).
    { intros t J. apply filter_In in J. destruct J as [_ J]. now destruct (lies_on_dec w t). }
    destruct (off_near w others free) as (radius & R & near). exists radius. split; [exact R |].
    intros y z y_near z_near y_right z_right. apply (winding_number_along (Segment y z) segments closed).
    intros v on_way t J on_t. destruct (lies_on_dec w t) as [on_w | off_w] eqn:on_or_off_.
    - pose proof (area_of_collinear s t v (along_only w t inside_ J on_w) on_t).
      pose proof (area_between s y z v y_right z_right on_way). lra.
    - refine (near v _ t _ on_t); [now apply (within_along radius w y z) |]. apply filter_In. split; [exact J |].
      now rewrite on_or_off_.
  Qed.

  (* Close to two points of the piece are points to the right that have the same number. *)
  Lemma same_along (k1 k2 r1 r2 : Q) : 0 < k1 -> k1 < k2 -> k2 < 1 -> 0 < r1 -> 0 < r2 ->
    exists y z, within r1 (point_at s k1) y /\ within r2 (point_at s k2) z /\ area s y < 0 /\ area s z < 0 /\
      winding_number y segments = winding_number z segments.
  Proof.
    intros k1_some order k2_some R1 R2. set (w1 := point_at s k1) in *. set (w2 := point_at s k2) in *.
    set (n := Vector (vy (minus w2 w1)) (- vx (minus w2 w1))).
    pose proof (square_positive _ long) as square.
    assert (moves : nonzero (minus w2 w1)).
    { intros [zero_x zero_y]. apply long. unfold w1, w2, point_at in *. in_coordinates.
      split; apply (Qmult_inj_r _ _ (k2 - k1)); lra. }
    assert (inside_ : forall p, lies_on p (Segment w1 w2) -> strictly_inside p s).
    { intros p (h & range & px & py). exists ((1 - h) * k1 + h * k2). unfold w1, w2, point_at in *. cbn in px, py.
      split; [split; [apply mixed_is_more | apply mixed_is_less]; lra |]. rewrite px, py. split; ring. }
    assert (others_apart : eventually (fun e => forall t, In t segments -> ~ collinear s t ->
      forall p, lies_on p (Segment (moved_along w1 n e) (moved_along w2 n e)) -> ~ lies_on p t)).
    { apply (eventually_for_all (fun t e => ~ collinear s t -> forall p,
        lies_on p (Segment (moved_along w1 n e) (moved_along w2 n e)) -> ~ lies_on p t)).
      intros t J. destruct (collinear_dec s t) as [along_s | across]; [exists 1; split; [lra | contradiction] |].
      refine (eventually_implied _ _ _ (shifted_segments_do_not_meet w1 w2 n t moves _)); [intros e apart_ _;
        exact apart_ |].
      intros p on on_t. exact (across (along_only p t (inside_ p on) J on_t)). }
    destruct (some_small _ (eventually_and _ _ others_apart (eventually_and _ _
      (small_steps_stay_within r1 w1 n R1) (small_steps_stay_within r2 w2 n R2))))
        as (e & some & free & near_1 & near_2).
    assert (to_the_right : forall k, area s (moved_along (point_at s k) n e) < 0).
    { intros k. setoid_replace (area s (moved_along (point_at s k) n e))
      with (- (e * (k2 - k1) * dot (along s) (along s)))
        by (unfold n, w1, w2, point_at; by_coordinates).
      assert (0 < e * (k2 - k1)) by (apply Qmult_lt_0_compat; lra). nra. }
    exists (moved_along w1 n e), (moved_along w2 n e). repeat split; try apply near_1; try apply near_2;
      try apply to_the_right.
    apply (winding_number_along (Segment (moved_along w1 n e) (moved_along w2 n e)) _ closed).
    intros p on t J on_t. destruct (collinear_dec s t) as [along_s | across]; [| exact (free t J across p on on_t)].
    pose proof (area_of_collinear s t p along_s on_t).
    pose proof (area_between s _ _ p (to_the_right k1) (to_the_right k2) on). lra.
  Qed.

  (* Beside the middle it is what is counted on symbolic shifts. *)
  Lemma value_to_the_right_of_the_middle :
    value_to_the_right segments s (point_at s (1 # 2)) (winding_number_shifted (right_of_middle s) segments).
  Proof.
    set (m := right_of_middle s).
    destruct (right_side_is_alike (point_at s (1 # 2))) as (radius & R & alike);
      [apply strictly_inside_at; lra |].
    destruct (some_small _ (eventually_and _ _ (shifts_are_small_moves s segments long)
      (moved_stays_within radius m R)))
      as (e & some & [_ number_is] & close).
    exists radius. split; [exact R |]. intros y y_near y_right. fold m in number_is. rewrite <- number_is.
    apply alike; trivial.
    - unfold within, m, right_of_middle, point_at in *. cbn [at_ vx vy] in *.
      setoid_replace ((1 - (1 # 2)) * vx (source s) + (1 # 2) * vx (target s))
        with ((vx (source s) + vx (target s)) / 2)
        by field.
      now setoid_replace ((1 - (1 # 2)) * vy (source s) + (1 # 2) * vy (target s))
        with ((vy (source s) + vy (target s)) / 2) by field.
    - pose proof (square_positive _ long) as square.
      setoid_replace (area s (moved m e)) with (- (e * e * dot (along s) (along s))); [assert (0 < e * e); nra |].
      unfold m, moved, right_of_middle. cbn [at_ first second]. in_coordinates.
      destruct (negative (vy (target s) - vy (source s))); cbn [vx vy]; field.
  Qed.

  Lemma value_to_the_right_of_all (w : vector) : strictly_inside w s ->
    value_to_the_right segments s w (winding_number_shifted (right_of_middle s) segments).
  Proof.
    intros inside_. destruct (right_side_is_alike w inside_) as (r & R & alike).
    destruct value_to_the_right_of_the_middle as (r' & R' & value). destruct inside_ as (k & range & X & Y).
    assert (same_ : forall radius z, within radius (point_at s k) z -> within radius w z)
      by (intros radius z; unfold within, point_at; cbn [vx vy]; now rewrite X, Y).
    destruct (Q_dec k (1 # 2)) as [[before_ | after_] | middle_]; [exists r; split; [exact R |] .. |].
    - intros y y_near y_right.
      destruct (same_along k (1 # 2) r r') as (z & z' & close & close' & z_right & z'_right & equal); trivial; try lra.
      rewrite (alike y z), equal; auto.
    - intros y y_near y_right.
      destruct (same_along (1 # 2) k r' r) as (z' & z & close' & close & z'_right & z_right & equal); trivial; try lra.
      rewrite (alike y z), <- equal; auto.
    - exists r'. split; [exact R' |]. intros y close. apply value. unfold within, point_at in *. cbn [vx vy].
      now rewrite X, Y, middle_ in close.
  Qed.

  (* Theorem. So close to the right of every point between the ends. *)
  Theorem to_the_right_of_a_piece (w n : vector) : strictly_inside w s -> cross (along s) n < 0 ->
    eventually (fun e => winding_number (moved_along w n e) segments =
                         winding_number_shifted (right_of_middle s) segments).
  Proof.
    intros inside_ right_. destruct (value_to_the_right_of_all w inside_) as (radius & R & value).
    refine (eventually_implied _ _ _ (eventually_and _ _ (small_steps_stay_within radius w n R)
      (eventually_below 1 ltac:(lra)))).
    intros e [near [some _]]. apply value; [exact near |].
    pose proof (on_the_line w s (strictly_inside_lies_on w s inside_)) as line.
    setoid_replace (area s (moved_along w n e)) with (area s w + e * cross (along s) n) by by_coordinates.
    rewrite line. nra.
  Qed.
End OnePiece.
