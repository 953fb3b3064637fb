(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Closed segments, and a piece that no other than collinear ones meet between its ends: all along it the winding number
   close to its right is the same, that right of its middle, as counted on symbolic shifts (shifted_ray.v). The same for
   edges of regions is in right_of_an_edge.v. *)
From Coq Require Import QArith Qabs Qminmax Lqa Qfield ZArith Lia Bool List.
From Oplus Require Import direction angle angular_crossings winding_number shifted_ray signed_crossings tie_rule
  regions meeting_of_segments first_hit neighbourhoods left_of_an_edge observation_2_2_4 right_of_an_edge location
  pieces.
Import ListNotations.

Open Scope Q_scope.

(* All of t is on the line of s. *)
Definition collinear (s t : segment) : Prop := area s (source t) == 0 /\ area s (target t) == 0.

Lemma collinear_dec (s t : segment) : {collinear s t} + {~ collinear s t}.
Proof.
  unfold collinear. destruct (Qeq_dec (area s (source t)) 0), (Qeq_dec (area s (target t)) 0); [left | right ..]; tauto.
Qed.

Lemma area_of_collinear (s t : segment) (w : vector) : collinear s t -> lies_on w t -> area s w == 0.
Proof.
  intros [a b] (k & _ & X & Y).
  assert (value : area s w == (1 - k) * area s (source t) + k * area s (target t))
    by (unfold area, cross, minus; cbn [vx vy]; rewrite X, Y; ring).
  rewrite value, a, b. ring.
Qed.

(* What has a point strictly inside the piece is collinear. *)
Definition met_only_along (segments : list segment) (s : segment) : Prop :=
  forall w t, strictly_inside w s -> In t segments -> lies_on w t -> collinear s t.

Definition value_to_the_right (segments : list segment) (s : segment) (w : vector) (number : Z) : Prop :=
  exists radius, 0 < radius /\ forall y, within radius w y -> area s y < 0 -> winding_number y segments = number.

Lemma area_between (s : segment) (y z v : vector) :
  area s y < 0 -> area s z < 0 -> lies_on v (Segment y z) -> area s v < 0.
Proof.
  intros y_right z_right (h & range & X & Y). cbn [source target] in *.
  assert (value : area s v == (1 - h) * area s y + h * area s z)
    by (unfold area, cross, minus; cbn [vx vy]; rewrite X, Y; ring).
  rewrite value. destruct (Qlt_le_dec 0 h) as [some | none].
  - assert (0 < h * - area s z) by (apply Qmult_lt_0_compat; lra).
    assert (0 <= (1 - h) * - area s y) by (apply Qmult_le_0_compat; lra). lra.
  - assert (h == 0) as -> by lra. lra.
Qed.

Lemma strictly_inside_at (s : segment) (k : Q) : 0 < k < 1 -> strictly_inside (point_at s k) s.
Proof. intros range. exists k. split; [exact range |]. split; reflexivity. Qed.

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
    intros inside_. set (others := filter (fun t => negb (is_on_segment w t)) segments).
    assert (free : off w others).
    { intros t J. apply filter_In in J. destruct J as [_ J]. destruct (is_on_spec w t); [discriminate | assumption]. }
    destruct (off_near w others free) as (radius & R & near). exists radius. split; [exact R |].
    intros y z y_near z_near y_right z_right. apply (winding_number_along (Segment y z) segments closed).
    intros v on_way t J on_t. destruct (is_on_spec w t) as [on_w | off_w].
    - pose proof (area_of_collinear s t v (along_only w t inside_ J on_w) on_t).
      pose proof (area_between s y z v y_right z_right on_way). lra.
    - refine (near v _ t _ on_t); [now apply (within_along radius w y z) |]. apply filter_In. split; [exact J |].
      destruct (is_on_spec w t); [contradiction | reflexivity].
  Qed.

  Lemma some_value_to_the_right (k : Q) : 0 < k < 1 ->
    exists number, value_to_the_right segments s (point_at s k) number.
  Proof.
    intros range. destruct (right_side_is_alike (point_at s k) (strictly_inside_at s k range)) as (radius & R & alike).
    pose proof (left_normal s long) as left_. set (n := Vector (- vy (along s)) (vx (along s))) in *.
    destruct (small_steps_stay_within radius (point_at s k) (opposite n) R) as (limit & L & near).
    set (e := (1 # 2) * limit). assert (e_range : 0 < e < limit) by (unfold e; lra).
    set (y := moved_along (point_at s k) n (- e)).
    assert (y_near : within radius (point_at s k) y).
    { specialize (near e ltac:(lra) ltac:(lra)). unfold y, within, moved_along, opposite in *; cbn [vx vy] in *. lra. }
    assert (y_right : area s y < 0)
      by (apply right_step_is_right; [apply point_at_is_on_the_line | exact left_ | lra]).
    exists (winding_number y segments), radius. split; [exact R |]. intros z z_near z_right. now apply alike.
  Qed.

  (* The same all along the piece. *)
  Lemma value_to_the_right_ahead (k1 k2 : Q) (number_1 number_2 : Z) : 0 < k1 -> k1 < k2 -> k2 < 1 ->
    value_to_the_right segments s (point_at s k1) number_1 ->
    value_to_the_right segments s (point_at s k2) number_2 -> number_1 = number_2.
  Proof.
    intros k1_some order k2_some (r1 & R1 & value_1) (r2 & R2 & value_2).
    set (w1 := point_at s k1) in *. set (w2 := point_at s k2) in *.
    set (n := Vector (vy (minus w2 w1)) (- vx (minus w2 w1))).
    assert (step_x : vx (minus w2 w1) == (k2 - k1) * vx (along s))
      by (unfold w1, w2, point_at, along, minus; cbn [vx vy]; ring).
    assert (step_y : vy (minus w2 w1) == (k2 - k1) * vy (along s))
      by (unfold w1, w2, point_at, along, minus; cbn [vx vy]; ring).
    assert (square : 0 < vx (along s) * vx (along s) + vy (along s) * vy (along s)).
    { destruct (Qlt_le_dec 0 (vx (along s) * vx (along s) + vy (along s) * vy (along s))) as [| none];
        [assumption |]. exfalso. apply long. now apply no_squares. }
    assert (right_ : cross (along s) n < 0).
    { assert (value : cross (along s) n ==
        - ((k2 - k1) * (vx (along s) * vx (along s) + vy (along s) * vy (along s))))
        by (unfold n, cross; cbn [vx vy]; rewrite step_x, step_y; ring).
      rewrite value. assert (0 < (k2 - k1) * (vx (along s) * vx (along s) + vy (along s) * vy (along s)))
        by (apply Qmult_lt_0_compat; lra). lra. }
    assert (moves : nonzero (minus w2 w1)).
    { intros [zero_x zero_y]. apply long. split; apply (Qmult_inj_r _ _ (k2 - k1)); lra. }
    assert (inside_ : forall p, lies_on p (Segment w1 w2) -> strictly_inside p s).
    { intros p (h & [h0 h1] & px & py). cbn [source target] in px, py. exists ((1 - h) * k1 + h * k2).
      assert (0 <= h * (k2 - k1)) by (apply Qmult_le_0_compat; lra).
      assert (0 <= (1 - h) * (k2 - k1)) by (apply Qmult_le_0_compat; lra). split; [lra |].
      unfold w1, w2, point_at in *; cbn [vx vy] in *. rewrite px, py. split; ring. }
    assert (others_apart : eventually (fun e => forall t, In t segments -> ~ collinear s t ->
      forall p, lies_on p (Segment (shifted_right w1 w2 e w1) (shifted_right w1 w2 e w2)) -> ~ lies_on p t)).
    { apply (eventually_for_all (fun t e => ~ collinear s t -> forall p,
        lies_on p (Segment (shifted_right w1 w2 e w1) (shifted_right w1 w2 e w2)) -> ~ lies_on p t)).
      intros t J. destruct (collinear_dec s t) as [along_s | across].
      - exists 1. split; [lra |]. intros e _ _ not_along. contradiction.
      - refine (eventually_implied _ _ _ (shifted_segments_do_not_meet w1 w2 t moves _)); [intros e apart_ _;
          exact apart_ |].
        intros p on on_t. exact (across (along_only p t (inside_ p on) J on_t)). }
    destruct (eventually_and _ _ others_apart (eventually_and _ _
      (small_steps_stay_within r1 w1 n R1) (small_steps_stay_within r2 w2 n R2))) as (limit & L & near).
    destruct (near ((1 # 2) * limit)) as (free & near_1 & near_2); [lra | lra |].
    set (e := (1 # 2) * limit) in *. assert (some : 0 < e) by (unfold e; lra). clearbody e. clear near.
    assert (to_the_right : forall k, area s (moved_along (point_at s k) n e) < 0).
    { intros k. assert (value : area s (moved_along (point_at s k) n e) == e * cross (along s) n)
        by (unfold area, point_at, cross, along, minus, moved_along; cbn [vx vy]; ring).
      rewrite value. assert (0 < e * - cross (along s) n) by (apply Qmult_lt_0_compat; lra). lra. }
    rewrite <- (value_1 (moved_along w1 n e) near_1 (to_the_right k1)).
    rewrite <- (value_2 (moved_along w2 n e) near_2 (to_the_right k2)).
    apply (winding_number_along (Segment (moved_along w1 n e) (moved_along w2 n e)) _ closed).
    intros p on t J on_t. destruct (collinear_dec s t) as [along_s | across].
    - pose proof (area_of_collinear s t p along_s on_t).
      pose proof (area_between s _ _ p (to_the_right k1) (to_the_right k2) on). lra.
    - exact (free t J across p on on_t).
  Qed.

  Lemma one_value_to_the_right (k1 k2 : Q) (number_1 number_2 : Z) : 0 < k1 < 1 -> 0 < k2 < 1 ->
    value_to_the_right segments s (point_at s k1) number_1 ->
    value_to_the_right segments s (point_at s k2) number_2 -> number_1 = number_2.
  Proof.
    intros range_1 range_2 value_1 value_2. destruct (Q_dec k1 k2) as [[before_ | after_] | equal].
    - apply (value_to_the_right_ahead k1 k2); trivial; lra.
    - symmetry. apply (value_to_the_right_ahead k2 k1); trivial; lra.
    - (* one point *)
      destruct (Qlt_le_dec k1 (1 # 2)) as [low | high].
      + destruct (some_value_to_the_right (3 # 4)) as (number & value); [lra |].
        rewrite (value_to_the_right_ahead k1 (3 # 4) number_1 number),
          (value_to_the_right_ahead k2 (3 # 4) number_2 number); trivial; lra.
      + destruct (some_value_to_the_right (1 # 4)) as (number & value); [lra |].
        rewrite <- (value_to_the_right_ahead (1 # 4) k1 number number_1),
          <- (value_to_the_right_ahead (1 # 4) k2 number number_2); trivial; lra.
  Qed.

  (* Beside the middle it is what is counted on symbolic shifts. *)
  Lemma value_to_the_right_of_the_middle :
    value_to_the_right segments s (point_at s (1 # 2)) (winding_number_shifted (right_of_middle s) segments).
  Proof.
    destruct (some_value_to_the_right (1 # 2)) as (number & radius & R & value); [lra |].
    enough (same_number : winding_number_shifted (right_of_middle s) segments = number)
      by (rewrite same_number; now exists radius).
    set (m := right_of_middle s).
    destruct (shifts_are_small_moves s segments long) as (l0 & L0 & shifts). fold m in shifts.
    assert (quarter : 0 < (1 # 2) * radius) by lra.
    destruct (small_steps_stay_within _ (point_at s (1 # 2)) (first m) quarter) as (l1 & L1 & near_1).
    destruct (small_steps_stay_within _ (point_at s (1 # 2)) (second m) quarter) as (l2 & L2 & near_2).
    set (limit := Qmin (Qmin l0 l1) (Qmin l2 1)).
    assert (bounds : 0 < limit /\ limit <= l0 /\ limit <= l1 /\ limit <= l2 /\ limit <= 1).
    { unfold limit. pose proof (Q.le_min_l (Qmin l0 l1) (Qmin l2 1)). pose proof (Q.le_min_r (Qmin l0 l1) (Qmin l2 1)).
      pose proof (Q.le_min_l l0 l1). pose proof (Q.le_min_r l0 l1). pose proof (Q.le_min_l l2 1).
      pose proof (Q.le_min_r l2 1). split; [repeat apply Q.min_glb_lt; lra | lra]. }
    clearbody limit. destruct bounds as (L & B0 & B1 & B2 & B3).
    set (e := (1 # 2) * limit). assert (e_range : 0 < e /\ e < limit) by (unfold e; lra). clearbody e.
    assert (e_square : 0 < e * e /\ e * e < limit) by (split; [apply Qmult_lt_0_compat; lra | nra]).
    destruct (shifts e) as [_ <-]; [lra | lra |].
    specialize (near_1 e ltac:(lra) ltac:(lra)). specialize (near_2 (e * e) ltac:(lra) ltac:(lra)).
    assert (at_x : vx (at_ m) == vx (point_at s (1 # 2)))
      by (unfold m, right_of_middle, point_at; cbn [at_ vx vy]; field).
    assert (at_y : vy (at_ m) == vy (point_at s (1 # 2)))
      by (unfold m, right_of_middle, point_at; cbn [at_ vx vy]; field).
    apply value.
    - unfold within, moved_along, moved in *; cbn [vx vy] in *. rewrite at_x, at_y. lra.
    - assert (area_is : area s (moved m e) ==
        e * cross (along s) (first m) + e * e * cross (along s) (second m)).
      { unfold area, cross, along, minus, moved; cbn [vx vy]. rewrite at_x, at_y. unfold point_at; cbn [vx vy]. ring. }
      assert (along_first : cross (along s) (first m) == 0).
      { unfold m, right_of_middle; cbn [first]. fold (along s). unfold cross.
        destruct (negative (vy (along s))); cbn [vx vy]; ring. }
      assert (to_second : cross (along s) (second m) < 0).
      { pose proof (left_normal s long) as left_. unfold cross in left_ |- *.
        unfold m, right_of_middle; cbn [second vx vy] in *. fold (along s). lra. }
      rewrite area_is, along_first.
      assert (0 < e * e * - cross (along s) (second m)) by (apply Qmult_lt_0_compat; lra). lra.
  Qed.

  (* Theorem. So close to the right of every point between the ends. *)
  Theorem to_the_right_of_a_piece (w n : vector) : strictly_inside w s -> cross (along s) n < 0 ->
    eventually (fun e => winding_number (moved_along w n e) segments =
                         winding_number_shifted (right_of_middle s) segments).
  Proof.
    intros (k & range & X & Y) right_.
    destruct (some_value_to_the_right k range) as (number & value).
    rewrite <- (one_value_to_the_right k (1 # 2) _ _ range ltac:(lra) value value_to_the_right_of_the_middle).
    destruct value as (radius & R & value).
    destruct (small_steps_stay_within radius (point_at s k) n R) as (limit & L & near).
    exists limit. split; [exact L |]. intros e some small. specialize (near e some small).
    apply value.
    - unfold within, moved_along, point_at in *. cbn [vx vy] in *. lra.
    - assert (area_is : area s (moved_along w n e) == e * cross (along s) n)
        by (unfold area, moved_along, cross, along, minus; cbn [vx vy]; rewrite X, Y; ring).
      rewrite area_is. assert (0 < e * - cross (along s) n) by (apply Qmult_lt_0_compat; lra). lra.
  Qed.
End OnePiece.
