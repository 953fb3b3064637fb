(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The sum that reference/definitions/tangent_count.cpp computes, and what it returns by the identity of
   tangent_count.v: the winding number of the convolution, whichever direction is given. *)
From Coq Require Import QArith ZArith List.
From Oplus Require Import direction tangent_set sweep winding_number in_out_degree convolution_winding sums weight
  regions tangent_count.
Import ListNotations.

Open Scope Z_scope.

Definition count_tangents (x : vector) (p q : region) (d : vector) : Z :=
  tangent_vertices_of_p d x (region_vertices p) (region_edges q) +
  tangent_vertices_of_q d x (region_vertices q) (region_edges p) +
  tangent_crossings d x (region_edges p) (region_edges q).

(* What the convolution's segments say, as reference/definitions/ computes it from `convolution`. *)
Definition convolution_winding_number (x : vector) (p q : region) : Z :=
  winding_number x (convolution_segments p q).

(* Theorem. For any closed chains, no edge of which is a point, and any direction: the tangents that are counted are as
   many as the convolution winds around x. *)
Theorem count_tangents_returns (x : vector) (p q : region) (d : vector) :
  no_edges_are_points p -> no_edges_are_points q -> nonzero d ->
  count_tangents x p q d = convolution_winding_number x p q.
Proof.
  intros p_edges q_edges proper_d. symmetry. now apply tangent_count_of_regions.
Qed.
