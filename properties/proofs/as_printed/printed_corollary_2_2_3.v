(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Corollary 2.2.3 as printed: each point of the boundary of the sum of two polygons is the sum of a boundary point of
   P and one of Q. Polygons may have holes, several components and chains that touch. It is proved in
   lemma_2_2_2.v. *)
From Coq Require Import List.
From Oplus Require Import numbers convolution theorem_4_2_1 theorem_2_2_10 lemma_2_2_2 polygons_of_the_thesis.
Import ListNotations.

Open Scope Q_scope.

(* Theorem, Corollary 2.2.3. *)
Theorem corollary_2_2_3_as_printed (p q : region) (x : vector) :
  valid_region p -> valid_region q -> on_boundary_of_sum x p q ->
  exists a b, on_boundary a p /\ on_boundary b q /\ equal_vectors x (plus a b).
Proof. exact (boundary_points_are_sums_of_boundary_points p q x). Qed.
