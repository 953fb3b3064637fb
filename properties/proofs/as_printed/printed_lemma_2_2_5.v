(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Lemma 2.2.5 as printed: if a point inside an edge of P and a point inside an edge of Q add up to a boundary point
   of the sum, their tangent sets are equal. The points are no ends of their edges; other chains may have
   vertices there. By Definition 2.1.13 the tangent set of a point inside an edge has the edge's direction and no other,
   so the edges have the same direction, which is proved in lemma_2_2_5.v. *)
From Coq Require Import List.
From Oplus Require Import numbers convolution regions left_of_an_edge winding_number_of_the_sum theorem_4_2_1
  theorem_2_2_10 lemma_2_2_5 theorem_3_2_8.
Import ListNotations.

Open Scope Q_scope.

(* d is in the tangent set of the points inside the edge e. *)
Definition in_tangent_set_inside (e : segment) (d : vector) : Prop := same_direction d (along e).

Lemma equal_tangent_sets_inside (e f : segment) :
  same_direction (along e) (along f) -> forall d, in_tangent_set_inside e d <-> in_tangent_set_inside f d.
Proof.
  intros (k & K & X & Y) d. split; intros (l & L & x_is & y_is).
  - exists (l * k). split; [nra |]. rewrite x_is, y_is, X, Y. split; ring.
  - exists (l / k). split; [now apply Qlt_shift_div_l; lra |]. rewrite x_is, y_is, X, Y. split; field; lra.
Qed.

(* Theorem, Lemma 2.2.5. *)
Theorem lemma_2_2_5_as_printed (p q : region) (e f : segment) (w u : vector) :
  valid_region p -> valid_region q ->
  In e (region_edges p) -> strictly_inside w e -> In f (region_edges q) -> strictly_inside u f ->
  on_boundary_of_sum (plus w u) p q ->
  forall d, in_tangent_set_inside e d <-> in_tangent_set_inside f d.
Proof.
  intros p_region q_region E inside_e F inside_f boundary.
  destruct (points_strictly_inside_edges p q e f w u) as [parallel ahead_]; trivial.
  apply equal_tangent_sets_inside, parallel_and_ahead.
  - apply (region_edges_are_directions q); [apply q_region | exact F].
  - exact parallel.
  - unfold dot in *. lra.
Qed.
