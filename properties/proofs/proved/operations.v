(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* What oplus-proved computes, and what that is: the one place that says which functions the program is made of. *)
From Coq Require Import Bool List.
From Oplus Require Import specification theorem_4_2_1 test_of_regions theorem_4_2_1_for_valid_regions sum_program
  sums_in_less_time polygons.

(* Whether the theorems are about the region. *)
Definition can_be_summed (r : polygonal_region) : bool := is_valid_region (as_region r).

Definition proved_sum (p q : polygonal_region) : list polygon_with_holes := polygons_of (fast_sum p q).

Definition region_of_polygons : list polygon_with_holes -> polygonal_region := flat_map chains_of_polygon.

(* Theorem. *)
Theorem proved_sums_are_sums (p q : polygonal_region) :
  can_be_summed p = true -> can_be_summed q = true -> is_minkowski_sum p q (region_of_polygons (proved_sum p q)).
Proof.
  intros p_valid q_valid x. unfold region_of_polygons, proved_sum. rewrite polygons_are_the_region.
  apply fast_sum_is_the_sum; now apply is_valid_region_is_right.
Qed.
