(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Points near a point: around a point off closed chains is a square of points off them, with the same winding
   number (thesis, Observation 4.2.5). Whether a point is on a segment is decidable. Segments and winding
   numbers are those of winding_number.v. *)
From Coq Require Import QArith Qabs Qminmax Lqa Qfield ZArith Lia Bool List.
From Oplus Require Import winding shifted_ray signed_crossings tie_rule meeting_of_segments.
Import ListNotations.

Open Scope Q_scope.

(* y is in the open square of this radius around x. *)
Definition within (radius : Q) (x y : vector) : Prop :=
  (- radius < vx y - vx x < radius) /\ (- radius < vy y - vy x < radius).

Lemma abs_bounds (a : Q) : 0 <= Qabs a /\ - Qabs a <= a <= Qabs a.
Proof. destruct (abs_cases a) as [[sign ->] | [sign ->]]; split; lra. Qed.

(* A point is on a segment if it is on its line, and between the ends as seen from there. *)
Lemma lies_on_by_signs (p : vector) (s : segment) :
  lies_on p s <->
  cross (minus (source s) p) (minus (target s) p) == 0 /\ dot (minus (source s) p) (minus (target s) p) <= 0.
Proof.
  destruct s as [a b]. unfold lies_on, cross, dot, minus. cbn [source target vx vy]. split.
  - intros (t & range & X & Y).
    assert (first_x : vx a - vx p == - t * (vx b - vx a)) by (rewrite X; ring).
    assert (first_y : vy a - vy p == - t * (vy b - vy a)) by (rewrite Y; ring).
    assert (second_x : vx b - vx p == (1 - t) * (vx b - vx a)) by (rewrite X; ring).
    assert (second_y : vy b - vy p == (1 - t) * (vy b - vy a)) by (rewrite Y; ring).
    rewrite first_x, first_y, second_x, second_y.
    set (u := vx b - vx a). set (v := vy b - vy a). split; [ring |].
    setoid_replace (- t * u * ((1 - t) * u) + - t * v * ((1 - t) * v))
      with (- (t * (1 - t) * (u * u + v * v))) by ring.
    assert (0 <= t * (1 - t)) by (apply Qmult_le_0_compat; lra).
    assert (0 <= u * u + v * v) by nra.
    assert (0 <= t * (1 - t) * (u * u + v * v)) by (now apply Qmult_le_0_compat). lra.
  - set (ux := vx a - vx p). set (uy := vy a - vy p). set (wx := vx b - vx p). set (wy := vy b - vy p).
    intros [line between_].
    assert (dx : vx b - vx a == wx - ux) by (unfold wx, ux; ring).
    assert (dy : vy b - vy a == wy - uy) by (unfold wy, uy; ring).
    set (len := (wx - ux) * (wx - ux) + (wy - uy) * (wy - uy)).
    destruct (Qlt_le_dec 0 len) as [long | point].
    + set (t := - (ux * (wx - ux) + uy * (wy - uy)) / len).
      assert (value : t * len == - (ux * (wx - ux) + uy * (wy - uy))) by (unfold t; field; lra).
      exists t. split; [split |].
      * unfold t. apply Qle_shift_div_l; [exact long |]. unfold len in *. nra.
      * unfold t. apply Qle_shift_div_r; [exact long |]. unfold len in *. nra.
      * assert (x_part : ux + t * (wx - ux) == 0).
        { apply (Qmult_inj_r _ _ len); [lra |].
          setoid_replace ((ux + t * (wx - ux)) * len) with (ux * len + t * len * (wx - ux)) by ring.
          rewrite value. unfold len.
          setoid_replace (ux * ((wx - ux) * (wx - ux) + (wy - uy) * (wy - uy)) +
            - (ux * (wx - ux) + uy * (wy - uy)) * (wx - ux)) with ((ux * wy - uy * wx) * (wy - uy)) by ring.
          rewrite line. ring. }
        assert (y_part : uy + t * (wy - uy) == 0).
        { apply (Qmult_inj_r _ _ len); [lra |].
          setoid_replace ((uy + t * (wy - uy)) * len) with (uy * len + t * len * (wy - uy)) by ring.
          rewrite value. unfold len.
          setoid_replace (uy * ((wx - ux) * (wx - ux) + (wy - uy) * (wy - uy)) +
            - (ux * (wx - ux) + uy * (wy - uy)) * (wy - uy)) with (- (ux * wy - uy * wx) * (wx - ux)) by ring.
          rewrite line. ring. }
        clearbody t. unfold ux, uy, wx, wy in x_part, y_part. split; lra.
    + apply no_squares in point. destruct point as [no_x no_y].
      assert (square : ux * ux + uy * uy <= 0).
      { assert (wx == ux) as wx_is by lra. assert (wy == uy) as wy_is by lra.
        rewrite wx_is, wy_is in between_. exact between_. }
      apply no_squares in square. exists 0. unfold ux, uy in square. split; [lra |]. split; lra.
Qed.

Lemma lies_on_dec (p : vector) (s : segment) : {lies_on p s} + {~ lies_on p s}.
Proof.
  destruct (Qeq_dec (cross (minus (source s) p) (minus (target s) p)) 0) as [line | beside].
  - destruct (Qlt_le_dec 0 (dot (minus (source s) p) (minus (target s) p))) as [outside | between_].
    + right. rewrite lies_on_by_signs. lra.
    + left. now apply lies_on_by_signs.
  - right. rewrite lies_on_by_signs. tauto.
Qed.

Lemma on_or_off (p : vector) (segments : list segment) :
  (exists s, In s segments /\ lies_on p s) \/ off p segments.
Proof.
  induction segments as [| s rest IH]; [right; intros s [] |].
  destruct (lies_on_dec p s) as [on | free]; [left; exists s; split; [now left | exact on] |].
  destruct IH as [(t & I & on) | free_rest].
  - left. exists t. split; [now right | exact on].
  - right. intros t [<- | I]; [exact free | now apply free_rest].
Qed.

(* A product with a number of limited size. *)
Lemma product_bounds (h a radius : Q) : - radius < h < radius -> - (radius * Qabs a) <= h * a <= radius * Qabs a.
Proof. intros range. destruct (abs_cases a) as [[sign ->] | [sign ->]]; split; nra. Qed.

(* What is positive stays positive on small changes that are at most linear. *)
Lemma radius_for (value slope : Q) : 0 < value -> 0 <= slope ->
  exists radius, 0 < radius /\ radius * slope < value.
Proof.
  intros some slope_. exists (value / (slope + 1)). split.
  - apply Qlt_shift_div_l; lra.
  - assert (exact_ : value / (slope + 1) * (slope + 1) == value) by (field; lra).
    assert (0 < value / (slope + 1)) by (apply Qlt_shift_div_l; lra). lra.
Qed.

Lemma squares_are_not_negative (u v : Q) : 0 <= u * u + v * v.
Proof. destruct (Qlt_le_dec u 0), (Qlt_le_dec v 0); nra. Qed.

Lemma off_one_segment_near (x : vector) (s : segment) : ~ lies_on x s ->
  exists radius, 0 < radius /\ forall y, within radius x y -> ~ lies_on y s.
Proof.
  intros free. destruct (turns_around x s free) as (_ & _ & ahead).
  destruct s as [a b]. cbn [source target] in *.
  set (c := cross (minus a x) (minus b x)) in *. set (d := dot (minus a x) (minus b x)) in *.
  assert (change_of_cross : forall y, cross (minus a y) (minus b y) ==
    c - ((vx y - vx x) * (vy b - vy a) - (vy y - vy x) * (vx b - vx a)))
    by (intros y; unfold c, cross, minus; cbn; ring).
  set (slope := Qabs (vy b - vy a) + Qabs (vx b - vx a)).
  assert (0 <= slope)
    by (unfold slope; pose proof (abs_bounds (vy b - vy a)); pose proof (abs_bounds (vx b - vx a)); lra).
  assert (by_cross : forall value, 0 < value -> value <= c \/ value <= - c ->
    exists radius, 0 < radius /\ forall y, within radius x y -> ~ lies_on y (Segment a b)).
  { intros value some size. destruct (radius_for value slope) as (radius & R & small); [exact some | assumption |].
    exists radius. split; [exact R |]. intros y [X Y] on.
    apply lies_on_by_signs in on. destruct on as [line _]. cbn [source target] in line.
    rewrite change_of_cross in line.
    pose proof (product_bounds _ (vy b - vy a) _ X). pose proof (product_bounds _ (vx b - vx a) _ Y).
    unfold slope in small. lra. }
  destruct (Q_dec c 0) as [[right_ | left_] | line].
  - apply (by_cross (- c)); [lra | now right; lra].
  - apply (by_cross c); [lra | now left; lra].
  - specialize (ahead line).
    set (u := vx a + vx b - 2 * vx x). set (v := vy a + vy b - 2 * vy x).
    assert (change_of_dot : forall y, dot (minus a y) (minus b y) ==
      d - ((vx y - vx x) * u + (vy y - vy x) * v) +
      ((vx y - vx x) * (vx y - vx x) + (vy y - vy x) * (vy y - vy x)))
      by (intros y; unfold d, u, v, dot, minus; cbn; ring).
    destruct (radius_for d (Qabs u + Qabs v)) as (radius & R & small); [exact ahead | |].
    { pose proof (abs_bounds u). pose proof (abs_bounds v). lra. }
    exists radius. split; [exact R |]. intros y [X Y] on.
    apply lies_on_by_signs in on. destruct on as [_ between_]. cbn [source target] in between_.
    rewrite change_of_dot in between_.
    pose proof (product_bounds _ u _ X). pose proof (product_bounds _ v _ Y).
    pose proof (squares_are_not_negative (vx y - vx x) (vy y - vy x)). lra.
Qed.

Lemma within_smaller (r s : Q) (x y : vector) : r <= s -> within r x y -> within s x y.
Proof. unfold within. lra. Qed.

Lemma off_near (x : vector) (segments : list segment) : off x segments ->
  exists radius, 0 < radius /\ forall y, within radius x y -> off y segments.
Proof.
  induction segments as [| s rest IH]; intros free.
  - exists 1. split; [lra |]. intros y _ s [].
  - destruct (off_one_segment_near x s (free s (or_introl eq_refl))) as (r1 & R1 & near_1).
    destruct IH as (r2 & R2 & near_2); [intros t I; apply free; now right |].
    exists (Qmin r1 r2). split; [now apply Q.min_glb_lt |]. intros y near t [<- | I].
    + apply near_1. refine (within_smaller _ _ _ _ _ near). apply Q.le_min_l.
    + apply near_2; [| exact I]. refine (within_smaller _ _ _ _ _ near). apply Q.le_min_r.
Qed.

(* A square is convex. *)
Lemma between_bounds (a b h radius : Q) :
  - radius < a < radius -> - radius < b < radius -> 0 <= h <= 1 -> - radius < (1 - h) * a + h * b < radius.
Proof.
  intros range_a range_b range.
  assert (mixed : forall u v : Q, 0 < u -> 0 < v -> 0 < (1 - h) * u + h * v).
  { intros u v U V. destruct (Qlt_le_dec 0 h) as [some | none].
    - assert (0 < h * v) by now apply Qmult_lt_0_compat.
      assert (0 <= (1 - h) * u) by (apply Qmult_le_0_compat; lra). lra.
    - assert (0 < (1 - h) * u) by (apply Qmult_lt_0_compat; lra).
      assert (h == 0) as -> by lra. lra. }
  pose proof (mixed (radius - a) (radius - b)). pose proof (mixed (radius + a) (radius + b)). lra.
Qed.

Lemma within_along (radius : Q) (w x y v : vector) :
  within radius w x -> within radius w y -> lies_on v (Segment x y) -> within radius w v.
Proof.
  intros [X1 Y1] [X2 Y2] (h & range & vx_is & vy_is). cbn [source target] in *. unfold within.
  rewrite vx_is, vy_is.
  setoid_replace ((1 - h) * vx x + h * vx y - vx w) with ((1 - h) * (vx x - vx w) + h * (vx y - vx w)) by ring.
  setoid_replace ((1 - h) * vy x + h * vy y - vy w) with ((1 - h) * (vy x - vy w) + h * (vy y - vy w)) by ring.
  split; now apply between_bounds.
Qed.

(* Theorem. Around every point off closed chains there is a square of points off them that have its winding
   number. *)
Theorem winding_number_near (x : vector) (segments : list segment) :
  cycles segments -> off x segments ->
  exists radius, 0 < radius /\ forall y, within radius x y ->
    off y segments /\ winding_number y segments = winding_number x segments.
Proof.
  intros closed free. destruct (off_near x segments free) as (radius & R & near).
  exists radius. split; [exact R |]. intros y close. split; [now apply near |]. symmetry.
  apply (winding_number_along (Segment x y) segments closed).
  intros w on. apply near. apply (within_along radius x x y); trivial. unfold within. lra.
Qed.

(* A small step in any direction stays in the square. *)
Definition moved_along (w u : vector) (e : Q) : vector := Vector (vx w + e * vx u) (vy w + e * vy u).

Lemma small_steps_stay_within (radius : Q) (w u : vector) : 0 < radius ->
  eventually (fun e => within radius w (moved_along w u e)).
Proof.
  intros R. destruct (radius_for radius (Qabs (vx u) + Qabs (vy u))) as (limit & L & small); [exact R | |].
  { pose proof (abs_bounds (vx u)). pose proof (abs_bounds (vy u)). lra. }
  exists limit. split; [exact L |]. intros e positive below. unfold within, moved_along; cbn [vx vy].
  setoid_replace (vx w + e * vx u - vx w) with (e * vx u) by ring.
  setoid_replace (vy w + e * vy u - vy w) with (e * vy u) by ring.
  assert (range : - limit < e < limit) by lra.
  pose proof (product_bounds e (vx u) limit range). pose proof (product_bounds e (vy u) limit range).
  pose proof (abs_bounds (vx u)). pose proof (abs_bounds (vy u)).
  assert (0 <= limit * Qabs (vx u)) by (apply Qmult_le_0_compat; lra).
  assert (0 <= limit * Qabs (vy u)) by (apply Qmult_le_0_compat; lra). lra.
Qed.
