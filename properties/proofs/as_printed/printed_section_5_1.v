(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Section 5.1 as printed: the collision test decides whether two simple polygons have a point of their interiors in
   common; touching does not count. `collide` is a naive test that also decides the cases of Section 5.1.1, if not by the
   order of edges around a contact: edges that cross, or a piece of an edge, between two contacts, that is inside the
   other polygon or along its boundary in the same direction. The second theorem is the naive test as it is told in Section 5.1: where no vertex is on an edge,
   interiors meet if and only if two edges cross, or a vertex of one is inside the other. Both are proved for all
   regions, in collision_is_complete.v and section_5_1.v. *)
From Coq Require Import List.
From Oplus Require Import numbers convolution interiors_meet naive_collision collision_is_complete section_5_1
  simple_chain polygons_of_the_thesis.
Import ListNotations.

Open Scope Q_scope.

(* Theorem, Section 5.1. *)
Theorem section_5_1_as_printed (p q : list vector) : simple_polygon p -> simple_polygon q ->
  (collide [p] [q] = true <-> exists z, inside z [p] /\ inside z [q]).
Proof.
  intros. apply collide_returns;
    first [now apply simple_polygons_are_regions | now apply simple_polygons_cover_nothing_twice].
Qed.

(* Theorem, the naive test. P and -Q + x. *)
Theorem section_5_1_in_general_position (p q : list vector) (x : vector) :
  simple_polygon p -> simple_polygon q -> off_vertex_edge_sum x [p] [q] ->
  (interiors_meet x [p] [q] <->
   edges_cross x [p] [q] \/ a_vertex_is_inside x [p] [q] \/ a_vertex_is_inside x [q] [p]).
Proof.
  intros. rewrite (collision_in_general_position [p] [q] x) by (trivial; now apply simple_polygons_are_regions). tauto.
Qed.
