(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* What Theorem 4.2.1 (theorem_4_2_1.v) asks of a region, valid regions have, which valid_components.v defines by points, and
   what the test of test_of_components.v accepts: no hypothesis on winding numbers is left open. *)
From Coq Require Import ZArith Bool List.
From Oplus Require Import numbers regions_and_sums valid_components winding_numbers_of_valid_regions
  edges_of_valid_regions test_of_components.

Theorem valid_components_are_valid_regions (components : list component) :
  valid_components components -> valid_region (region_of components).
Proof.
  intros valid. split; [| split].
  - intros chain. now apply valid_regions_have_edges.
  - intros x x_off. now apply valid_regions_are_nowhere_negative.
  - intros earlier s later t w. now apply edges_of_valid_regions_meet_in_vertices.
Qed.

(* Theorem 4.2.1 for regions that the test accepts. *)
Corollary theorem_4_2_1_by_the_test (p q : list component) (x : vector) :
  are_valid_components p = true -> are_valid_components q = true ->
  off x (convolution_segments (region_of p) (region_of q)) ->
  ((0 < winding_number x (convolution_segments (region_of p) (region_of q)))%Z <->
   in_sum x (region_of p) (region_of q)).
Proof.
  intros test_p test_q.
  apply positive_winding_number_iff_common_point; apply valid_components_are_valid_regions;
    now apply are_valid_components_sound.
Qed.
