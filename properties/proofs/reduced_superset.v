(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Theorem 2.3.2, second part: the boundary of the Minkowski sum is part of the reduced convolution (Definition 2.3.1),
   if no chains of P touch, and none of Q. Without this it is false (docs/findings.md). A boundary point of the sum is
   a sum, but not one with inner points of P and -Q + x in common, so interiors_at_touching_points.v applies. *)
From Coq Require Import QArith Lqa ZArith Lia Bool List.
From Oplus Require Import direction sweep winding_number in_out_degree regions interiors_meet neighbourhoods
  left_of_an_edge theorem_4_2_1 theorem_2_2_10 lemma_2_2_5 lemma_2_2_2 boundary_points reduced_convolution
  interiors_at_touching_points.
Import ListNotations.

Open Scope Q_scope.

(* Theorem 2.3.2, second part. *)
Theorem boundary_is_part_of_the_reduced_convolution (p q : region) (x : vector) :
  valid_region p -> valid_region q -> chains_do_not_touch p -> chains_do_not_touch q ->
  on_boundary_of_sum x p q -> on_reduced_convolution x p q.
Proof.
  intros p_region q_region p_apart q_apart boundary.
  destruct (on_or_off x (reduced_convolution p q)) as [on | free]; [exact on | exfalso].
  apply (inner_points_are_not_on_the_boundary p q x); [| exact boundary].
  apply interiors_meet_means_inner_point.
  apply common_point_means_common_inner_point; trivial. now apply sum_is_closed.
Qed.
