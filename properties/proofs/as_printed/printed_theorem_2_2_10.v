(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Theorem 2.2.10 as printed: the boundary of the sum of two polygons is part of the convolution (Definition 2.2.7).
   It is proved in theorem_2_2_10.v. *)
From Coq Require Import List.
From Oplus Require Import numbers convolution convolution_winding theorem_4_2_1 theorem_2_2_10 polygons_of_the_thesis.
Import ListNotations.

Open Scope Q_scope.

(* Theorem 2.2.10. *)
Theorem theorem_2_2_10_as_printed (p q : region) (x : vector) :
  valid_region p -> valid_region q -> on_boundary_of_sum x p q ->
  exists s, In s (convolution_segments p q) /\ lies_on x s.
Proof. exact (boundary_is_part_of_the_convolution p q x). Qed.
