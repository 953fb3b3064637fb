(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The theorems of Chapter 3 on regions that one can draw: an edge of a sum, the dangling edge of the room and the
   diamond, and the isolated vertex of the chamber and the inscribed diamond. *)
From Coq Require Import QArith Lqa List.
From Oplus Require Import convolution convolution_winding regions small_polygons reduced_convolution lemma_3_1_2
  theorem_3_2_8 theorem_3_2_10 three_directions polygons_of_the_thesis drawn_regions drawn_sums.
Import ListNotations.

Open Scope Q_scope.

(* Lemma 3.1.2. Below the lower side of the sum of the square with a hole and the square nothing is in the sum. *)
Lemma nothing_below_the_sum : complement_to_the_right (Vector 1 0) (Vector 1 0) chamber [square].
Proof.
  exists 1. split; [reflexivity |]. intros y _ below.
  apply (nothing_is_lower _ _ 0 0); [vm_compute; reflexivity .. |].
  unfold cross, minus in below. cbn [vx vy] in below. lra.
Qed.

(* All segments through (1, 0), between their ends, lead to the right, and a segment of the reduced convolution
   does. *)
Example lower_side_has_its_direction :
  on_reduced_convolution (Vector 1 0) chamber [square] /\
  (forall s k, In s (convolution_segments chamber [square]) -> 0 < k < 1 ->
     equal_vectors (Vector 1 0) (Vector ((1 - k) * vx (source s) + k * vx (target s))
                                        ((1 - k) * vy (source s) + k * vy (target s))) ->
     cross (Vector 1 0) (along s) == 0 /\ 0 < dot (Vector 1 0) (along s)).
Proof.
  apply boundary_edges_are_covered_in_their_direction.
  - apply drawn_regions.
  - apply square_is_a_region.
  - apply drawn_regions.
  - apply simple_polygons_do_not_touch, drawn_polygons.
  - apply lower_side_of_the_sum. lra.
  - intros [X _]. discriminate X.
  - exact nothing_below_the_sum.
Qed.

(* Theorem 3.2.8. Segments lead through the hatch in both directions. *)
Example segments_through_the_hatch :
  (exists s, In s (reduced_convolution [room] [fitting_diamond]) /\ lies_on (Vector 4 (11 # 2)) s /\
     same_direction (along s) (Vector 0 1)) /\
  (exists s, In s (reduced_convolution [room] [fitting_diamond]) /\ lies_on (Vector 4 (11 # 2)) s /\
     same_direction (along s) (opposite (Vector 0 1))).
Proof.
  apply dangling_edges_are_on_opposite_segments; [apply simple_polygons_are_regions, drawn_polygons .. | |].
  - exact passage_of_the_hatch.
  - apply no_sum_of_vertices_by_computation. vm_compute. reflexivity.
Qed.

(* Theorem 3.2.10. In (3, 3) segments of four directions meet. What is proved: three do; each direction is to the left
   of one of them or along two. *)
Example three_directions_in_the_chamber : exists s1 s2 s3, covers s1 (Vector 3 3) chamber [inscribed_diamond] /\
  covers s2 (Vector 3 3) chamber [inscribed_diamond] /\ covers s3 (Vector 3 3) chamber [inscribed_diamond] /\
  ~ same_direction (along s1) (along s2) /\ ~ same_direction (along s1) (along s3) /\
  ~ same_direction (along s2) (along s3).
Proof.
  apply three_segments_at_an_isolated_vertex.
  - apply drawn_regions.
  - apply simple_polygons_are_regions, drawn_polygons.
  - apply drawn_regions.
  - apply simple_polygons_cover_nothing_twice, drawn_polygons.
  - exact only_place_in_the_chamber.
  - apply no_sum_of_vertices_by_computation. vm_compute. reflexivity.
Qed.

Example a_segment_above_the_isolated_vertex (m : vector) : nonzero m ->
  (exists s, covers s (Vector 3 3) chamber [inscribed_diamond] /\ 0 < cross (along s) m) \/
  ((exists s, covers s (Vector 3 3) chamber [inscribed_diamond] /\ same_direction (along s) m) /\
   (exists s, covers s (Vector 3 3) chamber [inscribed_diamond] /\ same_direction (along s) (opposite m))).
Proof.
  apply segments_on_all_sides_of_an_isolated_vertex.
  - apply drawn_regions.
  - apply simple_polygons_are_regions, drawn_polygons.
  - exact only_place_in_the_chamber.
  - apply no_sum_of_vertices_by_computation. vm_compute. reflexivity.
Qed.

Example not_two_directions_only :
  ~ (forall s, covers s (Vector 3 3) chamber [inscribed_diamond] ->
       same_direction (along s) (Vector 1 0) \/ same_direction (along s) (Vector 0 1)).
Proof.
  intros two. destruct (three_directions_at_an_isolated_vertex chamber [inscribed_diamond] (Vector 3 3)
    (Vector 1 0) (Vector 0 1)) as (k & K & X & Y); trivial.
  - apply drawn_regions.
  - apply simple_polygons_are_regions, drawn_polygons.
  - exact only_place_in_the_chamber.
  - apply no_sum_of_vertices_by_computation. vm_compute. reflexivity.
  - intros [X _]. discriminate X.
  - intros [_ Y]. discriminate Y.
  - unfold opposite in *. cbn [vx vy] in *. lra.
Qed.
