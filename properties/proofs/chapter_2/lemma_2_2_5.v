(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Lemma 2.2.5: if the sum of a point inside an edge of P and a point inside an edge of Q is on the boundary of the
   sum, the edges have the same direction. Both points are no vertices: where chains touch, the lemma is false
   for open regions (docs/findings.md). Edges that are not parallel add up to a parallelogram around the point; where
   edges lie along each other in opposite directions, interiors meet (fans_that_touch.v). *)
From Coq Require Import ZArith Lia Bool List.
From Oplus Require Import numbers regions_and_sums edges_at_a_point fans_that_touch edges_that_pass theorem_2_2_10
  lemma_2_2_2.
Import ListNotations.

Open Scope Q_scope.

(* Near a point, all points are reached along two directions that are not parallel, by small steps. *)
Lemma reached_along_two (E F : vector) (m : Q) (x : vector) : 0 < m -> ~ cross E F == 0 ->
  exists radius, 0 < radius /\ forall y, within radius x y ->
    exists a b, - m < a < m /\ - m < b < m /\
      equal_vectors y (plus x (Vector (a * vx E + b * vx F) (a * vy E + b * vy F))).
Proof.
  intros some turn. set (D := cross E F) in *.
  set (K := 1 + (Qabs (vx E) + Qabs (vy E) + Qabs (vx F) + Qabs (vy F))).
  pose proof (abs_bounds (vx E)). pose proof (abs_bounds (vy E)). pose proof (abs_bounds (vx F)).
  pose proof (abs_bounds (vy F)). pose proof (abs_bounds D).
  assert (size : 0 < Qabs D) by (destruct (abs_cases D) as [[sign value] | [sign value]]; lra).
  assert (large : 0 < K) by (unfold K; lra).
  exists (m * Qabs D / K). split; [apply Qlt_shift_div_l; [exact large |]; nra |].
  set (r := m * Qabs D / K). assert (r_is : r * K == m * Qabs D) by (unfold r; field; lra). clearbody r.
  intros y [[left_ right_] [below above]]. set (dx := vx y - vx x) in *. set (dy := vy y - vy x) in *.
  assert (small : forall d c, - r < d < r -> - (r * Qabs c) <= d * c <= r * Qabs c).
  { intros d c range. pose proof (abs_bounds c). destruct (abs_cases c) as [[sign ->] | [sign ->]]; nra. }
  assert (quotient : forall n, - (m * Qabs D) < n < m * Qabs D -> - m < n / D < m).
  { intros n range. assert (n_is : n / D * D == n) by (field; exact turn). set (a := n / D) in *. clearbody a.
    destruct (abs_cases D) as [[sign value] | [sign value]]; rewrite value in range; split; nra. }
  exists ((dx * vy F - dy * vx F) / D), ((vx E * dy - vy E * dx) / D).
  pose proof (small dx (vy F) ltac:(lra)). pose proof (small dy (vx F) ltac:(lra)).
  pose proof (small dy (vx E) ltac:(lra)). pose proof (small dx (vy E) ltac:(lra)). unfold K in r_is.
  split; [apply quotient; nra |]. split; [apply quotient; nra |].
  unfold plus, D, cross, dx, dy in *; cbn [vx vy]. split; cbn [vx vy]; field; exact turn.
Qed.

(* Theorem, Lemma 2.2.5, where other chains may have vertices at these points. *)
Theorem points_strictly_inside_edges (p q : region) (e f : segment) (w u : vector) :
  valid_region p -> valid_region q ->
  In e (region_edges p) -> strictly_inside w e -> In f (region_edges q) -> strictly_inside u f ->
  on_boundary_of_sum (plus w u) p q ->
  cross (along e) (along f) == 0 /\ 0 < dot (along e) (along f).
Proof.
  intros p_region q_region I (k & [k0 k1] & wx & wy) J (l & [l0 l1] & ux & uy) boundary.
  set (m := Qmin (Qmin k (1 - k)) (Qmin l (1 - l))).
  assert (some : 0 < m) by (repeat apply Q.min_glb_lt; lra).
  assert (small : m <= k /\ m <= 1 - k /\ m <= l /\ m <= 1 - l).
  { unfold m. pose proof (Q.le_min_l (Qmin k (1 - k)) (Qmin l (1 - l))).
    pose proof (Q.le_min_r (Qmin k (1 - k)) (Qmin l (1 - l))). pose proof (Q.le_min_l k (1 - k)).
    pose proof (Q.le_min_r k (1 - k)). pose proof (Q.le_min_l l (1 - l)). pose proof (Q.le_min_r l (1 - l)). lra. }
  clearbody m.
  assert (on_e : forall a, - m < a < m -> lies_on (moved_along w (along e) a) e).
  { intros a range. exists (k + a). split; [lra |]. unfold moved_along, along, minus; cbn [vx vy].
    rewrite wx, wy. split; ring. }
  assert (on_f : forall a, - m < a < m -> lies_on (moved_along u (along f) a) f).
  { intros a range. exists (l + a). split; [lra |]. unfold moved_along, along, minus; cbn [vx vy].
    rewrite ux, uy. split; ring. }
  destruct (Qeq_dec (cross (along e) (along f)) 0) as [parallel | turn].
  2: { exfalso. apply (inner_points_are_not_on_the_boundary p q (plus w u)); [| exact boundary].
       destruct (reached_along_two (along e) (along f) m (plus w u) some turn) as (radius & R & reached).
       exists radius. split; [exact R |]. intros y close. destruct (reached y close) as (a & b & A & B & X & Y).
       exists (moved_along w (along e) a), (moved_along u (along f) b).
       split; [right; exists e; auto |]. split; [right; exists f; auto |].
       unfold plus, moved_along in *; cbn [vx vy] in *. split; cbn [vx vy]; lra. }
  split; [exact parallel |].
  pose proof (region_edges_are_directions p (proj1 p_region) e I) as long.
  pose proof (region_edges_are_directions q (proj1 q_region) f J) as long_f.
  destruct (parallel_directions _ _ long long_f parallel) as [(c & c_some & X & Y) | back].
  - pose proof (square_positive _ long_f) as square. unfold dot in *. rewrite X, Y. nra.
  - exfalso. apply (inner_points_are_not_on_the_boundary p q (plus w u)); [| exact boundary].
    assert (departing : forall s v k, nonzero (along s) -> 0 <= k < 1 ->
      vx v == (1 - k) * vx (source s) + k * vx (target s) -> vy v == (1 - k) * vy (source s) + k * vy (target s) ->
      departs v s = true).
    { intros s v j proper range X Y. apply departs_is. split; [exists j; split; [lra | now split] |].
      intros [X' Y']. apply proper. unfold along, minus. split; cbn [vx vy]; apply (Qmult_inj_l _ _ (1 - j)); lra. }
    apply interiors_meet_means_inner_point, (opposite_edges_meet p q _ w u e f); trivial;
      [split; reflexivity | apply (departing e w k); trivial; lra | apply (departing f u l); trivial; lra].
Qed.

(* Theorem, Lemma 2.2.5. *)
Theorem points_inside_edges (p q : region) (e f : segment) (w u : vector) :
  valid_region p -> valid_region q ->
  In e (region_edges p) -> lies_on w e -> ~ is_vertex w p ->
  In f (region_edges q) -> lies_on u f -> ~ is_vertex u q ->
  on_boundary_of_sum (plus w u) p q ->
  cross (along e) (along f) == 0 /\ 0 < dot (along e) (along f).
Proof.
  intros p_region q_region I on_e w_free J on_f u_free boundary.
  apply (points_strictly_inside_edges p q e f w u); trivial;
    [exact (inside_an_edge p e w I on_e w_free) | exact (inside_an_edge q f u J on_f u_free)].
Qed.
