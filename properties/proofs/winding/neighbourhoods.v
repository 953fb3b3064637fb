(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Points near a point: around a point off closed chains is a square of points off them, with the same winding
   number (thesis, Observation 4.2.5). Whether a point is on a segment is decidable. Segments and winding
   numbers are those of winding_number.v. *)
From Coq Require Import ZArith Lia Bool List.
From Oplus Require Import numbers winding shifted_ray signed_crossings small_numbers tie_rule meeting_of_segments
  secants.
Import ListNotations.

Open Scope Q_scope.

(* y is in the open square of this radius around x. *)
Definition within (radius : Q) (x y : vector) : Prop :=
  (- radius < vx y - vx x < radius) /\ (- radius < vy y - vy x < radius).

Lemma abs_bounds (a : Q) : 0 <= Qabs a /\ - Qabs a <= a <= Qabs a.
Proof. destruct (abs_cases a) as [[sign ->] | [sign ->]]; split; lra. Qed.

Lemma lies_on_dec (p : vector) (s : segment) : {lies_on p s} + {~ lies_on p s}.
Proof.
  destruct (Qeq_dec (cross (minus (source s) p) (minus (target s) p)) 0) as [line | beside];
    [destruct (Qlt_le_dec 0 (dot (minus (source s) p) (minus (target s) p))) as [outside | between_] |];
    [right | left | right]; rewrite lies_on_by_signs; lra.
Qed.

Lemma on_or_off (p : vector) (segments : list segment) : (exists s, In s segments /\ lies_on p s) \/ off p segments.
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
Lemma radius_for (value slope : Q) : 0 < value -> 0 <= slope -> exists radius, 0 < radius /\ radius * slope < value.
Proof.
  intros some _. destruct (some_small _ (eventually_positive value (- slope) some)) as (radius & R & small).
  exists radius. split; [exact R | lra].
Qed.

Lemma squares_are_not_negative (u v : Q) : 0 <= u * u + v * v.
Proof. destruct (Qlt_le_dec u 0), (Qlt_le_dec v 0); nra. Qed.

(* What is in front of a point is in front of those near it. *)
Lemma in_front_near (w a x : vector) : in_front w (minus a x) ->
  eventually (fun radius => forall y, within radius x y -> in_front w (minus a y)).
Proof.
  intros front. refine (eventually_implied _ _ _ (eventually_positive _ (- (Qabs (vx w) + Qabs (vy w))) front)).
  intros radius some y [X Y]. pose proof (product_bounds _ (vx w) _ X). pose proof (product_bounds _ (vy w) _ Y).
  unfold in_front, dot, minus in *. cbn [vx vy] in *. lra.
Qed.

Lemma within_smaller (r s : Q) (x y : vector) : r <= s -> within r x y -> within s x y.
Proof. unfold within. lra. Qed.

Lemma off_near_one (x : vector) (s : segment) : ~ lies_on x s ->
  eventually (fun radius => forall y, within radius x y -> ~ lies_on y s).
Proof.
  intros free. destruct (turning_is_in_front _ _ (turns_around x s free)) as (w & f & g).
  refine (eventually_implied _ _ _ (eventually_and _ _ (in_front_near w _ x f) (in_front_near w _ x g))).
  intros radius [near_source near_target] y close (t & range & X & Y).
  pose proof (mixed_is_more t _ _ 0 range (near_source y close) (near_target y close)) as some.
  assert (none : (1 - t) * dot w (minus (source s) y) + t * dot w (minus (target s) y) == 0)
    by (in_coordinates; by_equations). lra.
Qed.

Lemma off_one_segment_near (x : vector) (s : segment) : ~ lies_on x s ->
  exists radius, 0 < radius /\ forall y, within radius x y -> ~ lies_on y s.
Proof. intros free. exact (some_small _ (off_near_one x s free)). Qed.

Lemma off_near (x : vector) (segments : list segment) : off x segments ->
  exists radius, 0 < radius /\ forall y, within radius x y -> off y segments.
Proof.
  intros free.
  destruct (some_small _ (eventually_for_all (fun s radius => forall y, within radius x y -> ~ lies_on y s) segments
    (fun s I => off_near_one x s (free s I)))) as (radius & R & near).
  exists radius. split; [exact R |]. intros y close s I. exact (near s I y close).
Qed.

(* A square is convex. *)
Lemma within_along (radius : Q) (w x y v : vector) :
  within radius w x -> within radius w y -> lies_on v (Segment x y) -> within radius w v.
Proof.
  intros [[X1 X2] [Y1 Y2]] [[X3 X4] [Y3 Y4]] (h & range & vx_is & vy_is). cbn [source target] in *. unfold within.
  pose proof (mixed_is_more h _ _ _ range X1 X3). pose proof (mixed_is_less h _ _ _ range X2 X4).
  pose proof (mixed_is_more h _ _ _ range Y1 Y3). pose proof (mixed_is_less h _ _ _ range Y2 Y4). lra.
Qed.

(* Theorem. Around every point off closed chains there is a square of points off them that have its winding number. *)
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
  intros R. assert (each : forall a, eventually (fun e => 0 < radius + e * a /\ 0 < radius + e * - a))
    by (intros a; apply eventually_and; now apply eventually_positive).
  refine (eventually_implied _ _ _ (eventually_and _ _ (each (vx u)) (each (vy u)))).
  intros e. unfold within, moved_along. cbn [vx vy]. lra.
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
