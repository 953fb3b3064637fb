(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Theorem 2.2.6 as printed: each point of the boundary of the sum of two polygons is the sum of a vertex of one and a
   point of an edge of the other (Definition 2.2.1). It is proved in theorem_2_2_6.v. *)
From Coq Require Import List.
From Oplus Require Import numbers convolution regions left_of_an_edge theorem_4_2_1 theorem_2_2_10 theorem_2_2_6
  polygons_of_the_thesis.
Import ListNotations.

Open Scope Q_scope.

(* Theorem 2.2.6. *)
Theorem theorem_2_2_6_as_printed (p q : region) (x : vector) :
  valid_region p -> valid_region q -> on_boundary_of_sum x p q ->
  (exists v f, is_vertex v p /\ In f (region_edges q) /\ lies_on (minus x v) f) \/
  (exists v e, is_vertex v q /\ In e (region_edges p) /\ lies_on (minus x v) e).
Proof. exact (boundary_is_part_of_the_vertex_edge_sum p q x). Qed.
