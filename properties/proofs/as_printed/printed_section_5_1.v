(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Section 5.1 as printed: the collision test decides whether two simple polygons have a point of their interiors in
   common; touching does not count. `collide` is a naive test that also decides the cases of Section 5.1.1, if not by the
   order of edges around a contact: edges that cross, or a piece of an edge, between two contacts, that is inside the
   other polygon or along its boundary in the same direction. The second theorem is the naive test as it is told in Section 5.1: where no vertex is on an edge,
   interiors meet if and only if two edges cross, or a vertex of one is inside the other. Both are proved for all
   regions, in collision_is_complete.v and section_5_1.v. *)
From Coq Require Import QArith List.
From Oplus Require Import convolution interiors_meet naive_collision collision_is_complete section_5_1 simple_chain
  small_polygons simple_polygons polygons_of_the_thesis drawn_regions.
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

(* The square from (0, 0) to (2, 2) touches the room's corner from within; the letter L overlaps it. *)
Example touching_is_no_collision :
  ~ (exists z, inside z [room] /\ inside z [points_at [(1, 1); (3, 1); (3, 3); (1, 3)]]) /\
  (exists z, inside z [room] /\ inside z [letter_l]).
Proof.
  rewrite <- !section_5_1_as_printed by first [apply drawn_polygons |
    split; [apply is_simple_decides |]; vm_compute; reflexivity].
  split; [vm_compute; discriminate | vm_compute; reflexivity].
Qed.
