(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Lemma 2.2.5: if the sum of a point inside an edge of P and a point inside an edge of Q is on the boundary of the
   sum, the edges have the same direction. Both points are no vertices: where chains touch, the lemma is false
   for open regions (docs/findings.md). Otherwise the edge of Q would lead across the edge of P one way or back, or lie
   along it in the opposite direction, and interiors would meet (edges_that_pass.v, boundary_points.v). *)
From Coq Require Import ZArith Lia Bool List.
From Oplus Require Import numbers regions_and_sums inside_a_corner boundary_points fans_that_touch edges_that_pass
  theorem_2_2_10 lemma_2_2_2.
Import ListNotations.

Open Scope Q_scope.

(* Theorem, Lemma 2.2.5. *)
Theorem points_inside_edges (p q : region) (e f : segment) (w u : vector) :
  valid_region p -> valid_region q ->
  In e (region_edges p) -> lies_on w e -> ~ is_vertex w p ->
  In f (region_edges q) -> lies_on u f -> ~ is_vertex u q ->
  on_boundary_of_sum (plus w u) p q ->
  cross (along e) (along f) == 0 /\ 0 < dot (along e) (along f).
Proof.
  intros p_region q_region I on_e w_free J on_f u_free boundary.
  pose proof (region_edges_are_directions p (proj1 p_region) e I) as long_e.
  pose proof (region_edges_are_directions q (proj1 q_region) f J) as long_f.
  pose proof (fills_left_beside_an_edge p e w p_region I on_e w_free) as fills.
  assert (sum_ : equal_vectors (plus w u) (plus w u)) by (split; reflexivity).
  assert (outside : ~ interiors_meet (plus w u) p q).
  { intros meet. apply (inner_points_are_not_on_the_boundary p q (plus w u)); [| exact boundary].
    now apply interiors_meet_means_inner_point. }
  destruct (passes_both_ways q u f J on_f u_free) as [departing_ arriving].
  destruct (sides_of_edges p q (plus w u) w u (along e) f q_region outside sum_ fills J) as [ahead behind].
  specialize (ahead departing_). specialize (behind arriving).
  assert (parallel : cross (along e) (along f) == 0) by lra. split; [exact parallel |].
  destruct (parallel_directions _ _ long_e long_f parallel) as [(m & some & X & Y) | back].
  - pose proof (square_positive _ long_f) as square. unfold dot in *. rewrite X, Y. nra.
  - exfalso. now apply outside, (opposite_edge_meets p q _ w u (along e) f).
Qed.

(* Near a point, all points are reached along two directions that are not parallel, by small steps. *)
Lemma reached_along_two (E F : vector) (m : Q) (x : vector) : 0 < m -> ~ cross E F == 0 ->
  exists radius, 0 < radius /\ forall y, within radius x y ->
    exists a b, - m < a < m /\ - m < b < m /\ equal_vectors y (plus x (Vector (a * vx E + b * vx F) (a * vy E + b * vy F))).
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
  In e (region_edges p) -> lies_on w e -> ~ equal_vectors w (source e) -> ~ equal_vectors w (target e) ->
  In f (region_edges q) -> lies_on u f -> ~ equal_vectors u (source f) -> ~ equal_vectors u (target f) ->
  on_boundary_of_sum (plus w u) p q ->
  cross (along e) (along f) == 0 /\ 0 < dot (along e) (along f).
Proof.
  intros p_region q_region I (k & k_range & wx & wy) not_first not_last J (l & l_range & ux & uy) not_first' not_last'
    boundary.
  assert (inside_ : forall s v t, 0 <= t <= 1 -> vx v == (1 - t) * vx (source s) + t * vx (target s) ->
    vy v == (1 - t) * vy (source s) + t * vy (target s) -> ~ equal_vectors v (source s) ->
    ~ equal_vectors v (target s) -> 0 < t < 1).
  { intros s v t range X Y first_ last_. split; apply Qnot_le_lt; intros at_end.
    - apply first_. assert (t_is : t == 0) by lra. rewrite t_is in X, Y. split; lra.
    - apply last_. assert (t_is : t == 1) by lra. rewrite t_is in X, Y. split; lra. }
  pose proof (inside_ e w k k_range wx wy not_first not_last) as [k0 k1].
  pose proof (inside_ f u l l_range ux uy not_first' not_last') as [l0 l1]. clear inside_.
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
  destruct (Qlt_le_dec 0 (dot (along e) (along f))) as [| back]; [assumption | exfalso].
  pose proof (region_edges_are_directions p (proj1 p_region) e I) as long.
  pose proof (region_edges_are_directions q (proj1 q_region) f J) as long_f.
  pose proof (square_positive _ long) as square. pose proof (square_positive _ long_f) as square_f.
  set (E := along e) in *. set (F := along f) in *.
  (* along e by t, and back along f *)
  set (c := - dot E F / dot F F).
  assert (c_dot : c * dot F F == - dot E F) by (unfold c; field; lra).
  assert (not_ahead : 0 <= c) by (unfold c; apply Qle_shift_div_l; lra).
  assert (E_is : vx E == - (c * vx F) /\ vy E == - (c * vy F)).
  { split; apply (Qmult_inj_l _ _ (dot F F)); try lra.
    - transitivity (dot E F * vx F + cross E F * vy F); [unfold cross, dot; ring |]. rewrite parallel.
      transitivity (- (c * dot F F) * vx F); [rewrite c_dot; ring | ring].
    - transitivity (dot E F * vy F - cross E F * vx F); [unfold cross, dot; ring |]. rewrite parallel.
      transitivity (- (c * dot F F) * vy F); [rewrite c_dot; ring | ring]. }
  clearbody c. destruct E_is as [Ex Ey].
  assert (limit : 0 < m / (1 + c)) by (apply Qlt_shift_div_l; lra).
  destruct (some_small _ (eventually_and _ _ (eventually_below _ limit) (eventually_and _ _
    (leaves_all_vertices p w E long) (leaves_all_vertices q u (opposite E) (opposite_nonzero E long)))))
    as (t & t0 & (_ & t1) & free_w & free_u).
  assert (steps : t * (1 + c) < m).
  { assert (value : m / (1 + c) * (1 + c) == m) by (field; lra). nra. }
  assert (0 <= t * c) by (apply Qmult_le_0_compat; lra).
  assert (on_f' : lies_on (moved_along u (opposite E) t) f).
  { apply (lies_on_equal (moved_along u F (t * c))); [| apply on_f; lra].
    unfold moved_along, opposite; cbn [vx vy]. split; cbn [vx vy]; [rewrite Ex | rewrite Ey]; ring. }
  destruct (points_inside_edges p q e f _ _ p_region q_region I (on_e t ltac:(lra)) free_w J on_f' free_u)
    as [_ ahead_]; [| fold E F in ahead_; lra].
  intros radius R. destruct (boundary radius R) as ((y & near_y & in_y) & (z & near_z & out_z)).
  split; [exists y | exists z]; (split; [| assumption]);
    unfold within, plus, moved_along, opposite in *; cbn [vx vy] in *; lra.
Qed.
