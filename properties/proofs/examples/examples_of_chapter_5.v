(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The theorems of Chapter 5 that are not in as_printed/, on the room and the diamond and the square with a hole and
   the square. *)
From Coq Require Import QArith List.
From Oplus Require Import convolution small_numbers shifted_ray regions naive_collision placed_collision
  observation_5_2_1 polygons_of_the_thesis drawn_regions drawn_sums.
Import ListNotations.

Open Scope Q_scope.

(* Observation 5.2.1. The segment from (2, 1) to (2, 5) of the convolution leads upwards, the ray leaves it behind; to
   its right is the hole of the sum, inside the room. *)
Example ray_from_the_wall :
  let wall := Segment (Vector 2 1) (Vector 2 5) in
  signed_crossing_of_shifted (right_of_middle wall) wall = 0%Z /\
  eventually (fun e => ~ in_sum (moved (right_of_middle wall) e) [room] [fitting_diamond]).
Proof.
  split; [now apply what_an_edge_adds_to_its_ray |].
  destruct (rays_from_edges_decide [room] [fitting_diamond] (Segment (Vector 2 1) (Vector 2 5))) as (limit & L & near).
  - apply simple_polygons_are_regions, drawn_polygons.
  - apply simple_polygons_are_regions, drawn_polygons.
  - intros [_ Y]. discriminate Y.
  - exists limit. split; [exact L |]. intros e some little. destruct (near e some little) as [_ <-].
    vm_compute. discriminate.
Qed.

(* Off the convolution, the collision test and the winding number say the same. *)
Example both_verdicts : collide [room] (placed (Vector (41 # 10) (11 # 2)) [fitting_diamond]) = true.
Proof.
  apply collide_is_positive_winding_number; [apply simple_polygons_are_regions, drawn_polygons .. | | | |].
  - apply simple_polygons_cover_nothing_twice, drawn_polygons.
  - apply simple_polygons_cover_nothing_twice, drawn_polygons.
  - apply off_by_computation. vm_compute. reflexivity.
  - vm_compute. reflexivity.
Qed.

(* On the dangling edge the collision test is right, too. *)
Example no_collision_in_the_hatch : collide [room] (placed (Vector 4 (11 # 2)) [fitting_diamond]) <> true.
Proof.
  rewrite collide_decides_whether_interiors_meet; [apply passage_of_the_hatch | | | |];
    first [apply simple_polygons_are_regions | apply simple_polygons_cover_nothing_twice]; apply drawn_polygons.
Qed.
