(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Lemma 2.2.5: if the sum of a point inside an edge of P and a point inside an edge of Q is on the boundary of the
   sum, the edges have the same direction. Both points are no vertices: where chains touch, the lemma is false
   for open regions (docs/findings.md). Otherwise the edge of Q would lead across the edge of P one way or back, or lie
   along it in the opposite direction, and interiors would meet (edges_that_pass.v, boundary_points.v). *)
From Coq Require Import QArith Qminmax Lqa ZArith Lia Bool List.
From Oplus Require Import regions_and_sums inside_a_corner boundary_points fans_that_touch edges_that_pass
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
