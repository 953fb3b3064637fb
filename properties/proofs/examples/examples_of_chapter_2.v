(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The theorems of Chapter 2 on chains that touch, and on open sums: their hypotheses hold for regions that one can
   draw. Those that are as printed have examples in as_printed/ and in refuted/. *)
From Coq Require Import QArith Lqa List.
From Oplus Require Import convolution small_numbers convolution_winding neighbourhoods theorem_2_2_10 theorem_2_2_6
  small_polygons test_of_regions small_regions reduced_convolution open_sum polygons_of_the_thesis drawn_regions
  drawn_sums valid_components theorem_4_2_1_for_valid_regions touching_holes.
Import ListNotations.

Open Scope Q_scope.

(* A hole that touches the side of a square, in a vertex of both: the boundary is on the convolution as well. *)
Example chains_that_touch :
  exists s, In s (convolution_segments square_with_touching_hole [square]) /\ lies_on (Vector 1 0) s.
Proof.
  apply boundary_is_part_of_the_convolution; [apply drawn_regions | apply square_is_a_region |].
  apply (lowest_points_are_on_the_boundary _ _ 0 0); [vm_compute; reflexivity .. | | reflexivity].
  exists (Vector 1 0), (Vector 0 0). split; [| split; [| split; reflexivity]]; right.
  - exists (Segment (Vector 0 0) (Vector 6 0)). split; [now left |].
    apply on_edge_by_computation. vm_compute. reflexivity.
  - exists (Segment (Vector 0 0) (Vector 2 0)). split; [now left |].
    apply on_edge_by_computation. vm_compute. reflexivity.
Qed.

(* A hole that touches the lower side of a square between the ends of this side. *)
Example a_vertex_that_touches_an_edge :
  exists s, In s (convolution_segments (region_of square_with_lower_hole) [narrow_triangle]) /\
    lies_on (Vector 2 (-2)) s.
Proof.
  apply boundary_is_part_of_the_convolution.
  - apply valid_components_are_valid_regions, square_with_lower_hole_is_valid.
  - apply (valid_components_are_valid_regions [Component narrow_triangle []]), narrow_triangle_is_valid.
  - apply (lowest_points_are_on_the_boundary _ _ 0 (-2)); [vm_compute; reflexivity .. | | reflexivity].
    exists (Vector 3 0), (Vector (-1) (-2)). split; [| split; [| split; reflexivity]]; right.
    + exists (Segment (Vector 0 0) (Vector 6 0)). split; [now left |].
      apply on_edge_by_computation. vm_compute. reflexivity.
    + exists (Segment (Vector 0 0) (Vector (-1) (-2))). split; [now left |].
      apply on_edge_by_computation. vm_compute. reflexivity.
Qed.

(* The point of the dangling edge in the hatch is a boundary point of the open sum. *)
Lemma hatch_is_on_the_boundary_of_the_open_sum : on_boundary_of_open_sum (Vector 4 (11 # 2)) [room] [fitting_diamond].
Proof.
  destruct passage_of_the_hatch as (outside & _ & _ & (n & _ & beside) & _). split; [exact outside |].
  intros radius R. destruct (eventually_and _ _ beside (small_steps_stay_within radius (Vector 4 (11 # 2)) n R))
    as (limit & L & near).
  destruct (near ((1 # 2) * limit)) as [meet close]; [lra | lra |].
  exists (moved_along (Vector 4 (11 # 2)) n ((1 # 2) * limit)). now split.
Qed.

Example the_hatch_is_on_the_reduced_convolution : on_reduced_convolution (Vector 4 (11 # 2)) [room] [fitting_diamond].
Proof.
  apply boundary_of_the_open_sum; [apply simple_polygons_are_regions, drawn_polygons .. | | |
    exact hatch_is_on_the_boundary_of_the_open_sum]; apply simple_polygons_do_not_touch, drawn_polygons.
Qed.

Example the_hatch_is_on_the_vertex_edge_sum : on_vertex_edge_sum (Vector 4 (11 # 2)) [room] [fitting_diamond].
Proof.
  apply boundary_of_the_open_sum_is_on_the_vertex_edge_sum; [apply simple_polygons_are_regions, drawn_polygons .. |
    exact hatch_is_on_the_boundary_of_the_open_sum].
Qed.
