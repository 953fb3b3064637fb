(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Points near a point: around a point off closed chains is a square of points off them, with the same winding
   number (thesis, Observation 4.2.5). Whether a point is on a segment is decidable. Segments and winding
   numbers are those of winding_number.v. *)
From Coq Require Import ZArith Lia Bool List.
From Oplus Require Import numbers winding shifted_ray signed_crossings small_numbers tie_rule meeting_of_segments.
Import ListNotations.

Open Scope Q_scope.

(* y is in the open square of this radius around x. *)
Definition within (radius : Q) (x y : vector) : Prop :=
  (- radius < vx y - vx x < radius) /\ (- radius < vy y - vy x < radius).

Lemma abs_bounds (a : Q) : 0 <= Qabs a /\ - Qabs a <= a <= Qabs a.
Proof. destruct (abs_cases a) as [[sign ->] | [sign ->]]; split; lra. Qed.

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

Lemma off_near_one (x : vector) (s : segment) : ~ lies_on x s ->
  eventually (fun radius => forall y, within radius x y -> ~ lies_on y s).
Proof.
  intros free. destruct (off_one_segment_near x s free) as (radius & R & near). exists radius. split; [exact R |].
  intros smaller _ less y close. apply near. refine (within_smaller _ _ _ _ _ close). lra.
Qed.

Lemma off_near (x : vector) (segments : list segment) : off x segments ->
  exists radius, 0 < radius /\ forall y, within radius x y -> off y segments.
Proof.
  intros free.
  destruct (some_small _ (eventually_for_all (fun s radius => forall y, within radius x y -> ~ lies_on y s) segments
    (fun s I => off_near_one x s (free s I)))) as (radius & R & near).
  exists radius. split; [exact R |]. intros y close s I. exact (near s I y close).
Qed.

(* A square is convex. *)
Lemma between_bounds (a b h radius : Q) :
  - radius < a < radius -> - radius < b < radius -> 0 <= h <= 1 -> - radius < (1 - h) * a + h * b < radius.
Proof. intros range_a range_b range. split; [apply mixed_is_more | apply mixed_is_less]; lra. Qed.

Lemma within_along (radius : Q) (w x y v : vector) :
  within radius w x -> within radius w y -> lies_on v (Segment x y) -> within radius w v.
Proof.
  intros [X1 Y1] [X2 Y2] (h & range & vx_is & vy_is). cbn [source target] in *. unfold within.
  pose proof (between_bounds _ _ h _ X1 X2 range). pose proof (between_bounds _ _ h _ Y1 Y2 range). lra.
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

Lemma moved_stays_within (radius : Q) (p : shifted_point) : 0 < radius ->
  eventually (fun e => within radius (at_ p) (moved p e)).
Proof.
  intros R. assert (half : 0 < (1 # 2) * radius) by lra.
  refine (eventually_implied _ _ _ (eventually_and _ _ (small_steps_stay_within _ (at_ p) (first p) half)
    (eventually_squared _ (small_steps_stay_within _ (at_ p) (second p) half)))).
  intros e. unfold within, moved, moved_along. cbn [vx vy]. lra.
Qed.

Lemma shifted_stays_within (radius : Q) (x : vector) : 0 < radius ->
  eventually (fun e => within radius x (moved (shifted x) e)).
Proof. exact (moved_stays_within radius (shifted x)). Qed.
