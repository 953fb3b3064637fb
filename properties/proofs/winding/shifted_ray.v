(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Winding numbers to the right of an edge's middle, as checked/arrangement/ray_shooting.cpp counts them:
   its symbolic shifts mean what an actual small shift does. *)
From Coq Require Import ZArith Lia Bool List.
From Oplus Require Import numbers winding small_numbers.
Import ListNotations.

Open Scope Q_scope.

(* A point moved infinitesimally, by e first + e^2 second. *)
Record shifted_point := ShiftedPoint { at_ : vector; first : vector; second : vector }.

(* The same moved by an actual number. *)
Definition moved (p : shifted_point) (e : Q) : vector :=
  Vector (vx (at_ p) + e * vx (first p) + e * e * vx (second p))
         (vy (at_ p) + e * vy (first p) + e * e * vy (second p)).

Definition is_above (p : shifted_point) : bool := positive (vy (first p)) || positive (vy (second p)).

(* Greater than zero if the point is to the left of the segment's line, less if to the right. *)
Definition side (p : shifted_point) (s : segment) : comparison :=
  let d := minus (target s) (source s) in
  match orientation (source s) (target s) (at_ p) with
  | Eq => match cross d (first p) ?= 0 with Eq => cross d (second p) ?= 0 | by_first => by_first end
  | exact => exact
  end.

(* What a segment adds: the ray goes to the right at the height of the shifted point, at which no segment ends. *)
Definition signed_crossing_of_shifted (p : shifted_point) (s : segment) : Z :=
  let below a := if is_above p then at_most (vy a) (vy (at_ p)) else negb (at_most (vy (at_ p)) (vy a)) in
  ray_crossing (below (source s)) (below (target s)) (side p s).

Definition winding_number_shifted (p : shifted_point) (segments : list segment) : Z :=
  sum (map (signed_crossing_of_shifted p) segments).

(* The middle of an edge, moved along the edge, upwards, and then to its right. *)
Definition right_of_middle (edge : segment) : shifted_point :=
  let d := minus (target edge) (source edge) in
  ShiftedPoint
    (Vector ((vx (source edge) + vx (target edge)) / 2) ((vy (source edge) + vy (target edge)) / 2))
    (if negative (vy d) then Vector (- vx d) (- vy d) else d)
    (Vector (vy d) (- vx d)).

(* The sign of c0 + c1 e + c2 e^2 for an infinitesimal e > 0. *)
Definition sign_nearby (c0 c1 c2 : Q) : comparison :=
  match c0 ?= 0 with Eq => match c1 ?= 0 with Eq => c2 ?= 0 | c => c end | c => c end.

Lemma positive_nearby : forall a b c, 0 < a -> eventually (fun e => 0 < a + e * b + e * e * c).
Proof.
  intros a b c A. assert (half : 0 < (1 # 2) * a) by lra.
  refine (eventually_implied _ _ _ (eventually_and _ _ (eventually_positive _ b half)
    (eventually_squared _ (eventually_positive _ c half)))). intros e. lra.
Qed.

Lemma quadratic_nearby : forall c0 c1 c2,
  eventually (fun e => (c0 + e * c1 + e * e * c2 ?= 0) = sign_nearby c0 c1 c2).
Proof.
  intros c0 c1 c2.
  assert (scaled : forall a b k, 0 < k -> b == k * a -> (b ?= 0) = (a ?= 0)).
  { intros a b k some equal. destruct (Qcompare_spec b 0), (Qcompare_spec a 0); trivial; exfalso; nra. }
  assert (nearby : forall a b c, ~ a == 0 -> eventually (fun e => (a + e * b + e * e * c ?= 0) = (a ?= 0))).
  { intros a b c apart. destruct (Q_dec a 0) as [[some | some] |];
      [refine (eventually_implied _ _ _ (positive_nearby (- a) (- b) (- c) _)); [| lra]
      | refine (eventually_implied _ _ _ (positive_nearby a b c some)) | contradiction]; intros e near;
      destruct (Qcompare_spec (a + e * b + e * e * c) 0), (Qcompare_spec a 0); trivial; exfalso; lra. }
  unfold sign_nearby. destruct (Qeq_dec c0 0) as [zero_ | apart]; [destruct (Qeq_dec c1 0) as [zero_' | apart] |].
  - exists 1. split; [lra |]. intros e some _.
    rewrite (proj1 (Qeq_alt c0 0) zero_), (proj1 (Qeq_alt c1 0) zero_').
    apply (scaled c2 _ (e * e)); [nra | rewrite zero_, zero_'; ring].
  - refine (eventually_implied _ _ _ (eventually_and _ _ (eventually_below 1 ltac:(lra)) (nearby c1 c2 0 apart))).
    intros e [[some _] near]. rewrite (proj1 (Qeq_alt c0 0) zero_), (scaled (c1 + e * c2 + e * e * 0) _ e some), near
      by (rewrite zero_; ring).
    compared_numbers (c1 ?= 0); trivial; lra.
  - refine (eventually_implied _ _ _ (nearby c0 c1 c2 apart)). intros e ->. compared_numbers (c0 ?= 0); trivial; lra.
Qed.

(* The shift decides on which side of its own height the point comes to be; so does that of an edge's middle. *)
Definition leaves_its_height (p : shifted_point) : Prop :=
  0 <= vy (first p) /\ (vy (first p) == 0 -> ~ vy (second p) == 0).

Lemma middles_leave_their_height : forall edge,
  nonzero (minus (target edge) (source edge)) -> leaves_its_height (right_of_middle edge).
Proof.
  intros edge N. unfold nonzero, leaves_its_height in *; cbn in *.
  set (x := vx (target edge) - vx (source edge)) in *.
  set (y := vy (target edge) - vy (source edge)) in *.
  destruct (negative_spec y) as [M | M]; cbn; (split; [| intros E X; apply N; split; unfold x, y in *; lra]).
  - lra.
  - now apply Qnot_lt_le.
Qed.

Lemma below_nearby : forall p a, leaves_its_height p ->
  eventually (fun e =>
    at_most (vy a) (vy (moved p e)) =
    (if is_above p then at_most (vy a) (vy (at_ p)) else negb (at_most (vy (at_ p)) (vy a))) /\
    ~ vy a == vy (moved p e)).
Proof.
  intros p a [F S].
  refine (eventually_implied _ _ _ (quadratic_nearby (vy (at_ p) - vy a) (vy (first p)) (vy (second p)))).
  intros e near. set (c := vy (at_ p) - vy a + e * vy (first p) + e * e * vy (second p)) in *.
  assert (height : vy (moved p e) == vy a + c) by (unfold c; cbn; ring). clearbody c.
  assert (side_ : ~ c == 0 /\ (if is_above p then c < 0 <-> vy (at_ p) < vy a else 0 < c <-> vy a < vy (at_ p))).
  { revert near. unfold sign_nearby, is_above, positive.
    compared_numbers (vy (at_ p) - vy a ?= 0); try compared_numbers (vy (first p) ?= 0);
      try compared_numbers (vy (second p) ?= 0); compared_numbers (c ?= 0); (discriminate || intros _);
      destruct (negative_spec (- vy (first p))), (negative_spec (- vy (second p))); cbn [orb]; lra. }
  destruct side_ as [apart_ side_], (is_above p), (at_most_spec (vy a) (vy (moved p e))),
    (at_most_spec (vy a) (vy (at_ p))), (at_most_spec (vy (at_ p)) (vy a)); split; trivial; (exfalso; lra) || lra.
Qed.

Lemma side_nearby : forall p s, eventually (fun e => orientation (source s) (target s) (moved p e) = side p s).
Proof.
  intros p [a b]. set (d := minus b a). set (o := cross d (minus (at_ p) a)).
  refine (eventually_implied _ _ _ (quadratic_nearby o (cross d (first p)) (cross d (second p)))).
  intros e H. unfold side; cbn. unfold orientation.
  rewrite (compare_as_difference _ _ (o + e * cross d (first p) + e * e * cross d (second p)) 0), H
    by (unfold o, d, cross, minus; cbn; ring).
  unfold sign_nearby. now rewrite (compare_as_difference _ ((vy b - vy a) * (vx (at_ p) - vx a)) o 0)
    by (unfold o, d, cross, minus; cbn; ring).
Qed.

(* Beside an edge's middle there is no other segment: one along the edge is to its left. *)
Lemma beside_every_segment : forall edge s,
  nonzero (minus (target edge) (source edge)) -> nonzero (minus (target s) (source s)) ->
  side (right_of_middle edge) s <> Eq.
Proof.
  intros [a b] [u v] N M. unfold side, right_of_middle; cbn [source target first second at_] in *.
  destruct (orientation u v _); try discriminate.
  set (d := minus b a) in *. set (w := minus v u) in *.
  assert (P : cross w (if negative (vy d) then Vector (- vx d) (- vy d) else d) == 0 -> cross w d == 0).
  { destruct (negative (vy d)); [| trivial]. unfold cross; cbn. lra. }
  compared_numbers (cross w (if negative (vy d) then Vector (- vx d) (- vy d) else d) ?= 0);
    try discriminate.
  intros E. apply equal_comparison in E. specialize (P C).
  pose proof (cross_angle w d M N) as T. unfold turns_by in T.
  assert (dot w d == - cross w (Vector (vy d) (- vx d))) as D by (unfold cross, dot; cbn; ring).
  lra.
Qed.

Lemma on_its_line : forall p s, lies_on p s -> orientation (source s) (target s) p = Eq.
Proof. intros p s (t & _ & X & Y). unfold orientation. apply (proj1 (Qeq_alt _ _)). rewrite X, Y. ring. Qed.

Lemma crossing_nearby : forall edge s,
  nonzero (minus (target edge) (source edge)) ->
  eventually (fun e =>
    ~ lies_on (moved (right_of_middle edge) e) s /\
    signed_crossing (moved (right_of_middle edge) e) s =
    signed_crossing_of_shifted (right_of_middle edge) s).
Proof.
  intros edge s N. pose proof (middles_leave_their_height edge N) as U.
  refine (eventually_implied _ _ _ (eventually_and _ _ (eventually_and _ _
    (below_nearby (right_of_middle edge) (source s) U) (below_nearby (right_of_middle edge) (target s) U))
    (side_nearby (right_of_middle edge) s))).
  intros e (([B1 A1] & [B2 _]) & H3). split.
  - intros I. pose proof (on_its_line _ _ I) as Z. rewrite H3 in Z.
    apply (beside_every_segment edge s); [exact N | | exact Z].
    intros [X Y]. destruct I as (t & _ & _ & I). apply A1. cbn in X, Y. rewrite I.
    setoid_replace (vy (target s)) with (vy (source s)) by lra. ring.
  - unfold signed_crossing, signed_crossing_of_shifted, ray_crossing. rewrite B1, B2, H3. reflexivity.
Qed.

(* Theorem. What the code counts on symbolic shifts is the winding number, counted on the ray to the
   right, of every point that is close enough to the right of the edge's middle, moved by actual
   numbers e and e^2 instead of infinitesimals; and those points are on no segment. *)
Theorem shifts_are_small_moves : forall edge segments,
  nonzero (minus (target edge) (source edge)) ->
  eventually (fun e =>
    off (moved (right_of_middle edge) e) segments /\
    winding_number (moved (right_of_middle edge) e) segments =
    winding_number_shifted (right_of_middle edge) segments).
Proof.
  intros edge segments N.
  refine (eventually_implied _ _ _ (eventually_for_all _ segments (fun s _ => crossing_nearby edge s N))).
  intros e near. split; [intros s I; now apply near |]. unfold winding_number, winding_number_shifted. f_equal.
  apply map_ext_in. intros s I. now apply near.
Qed.

(* Theorem. So a ray in any other direction, turned to either side, from such a point counts the same
   on closed chains. *)
Theorem shifts_count_as_any_ray : forall edge segments,
  nonzero (minus (target edge) (source edge)) -> cycles segments ->
  exists limit, 0 < limit /\ forall e k d, 0 < e -> e < limit -> nonzero d ->
    winding_number_by_ray k d (moved (right_of_middle edge) e) segments =
    winding_number_shifted (right_of_middle edge) segments.
Proof.
  intros edge segments N C. destruct (shifts_are_small_moves edge segments N) as (l & L & H).
  exists l. split; [exact L |]. intros e k d E M D. destruct (H e E M) as [O <-].
  now apply winding_number_by_any_ray.
Qed.
