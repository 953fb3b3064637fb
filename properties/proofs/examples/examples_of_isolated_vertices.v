(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Theorem 3.2.10 where the isolated vertex is a sum of two vertices: a triangle that just fits into a triangular hole,
   with all three vertices, and the same with a slit, so that the polygons are simple; and two pairs of triangles, each
   pair touching in one point, that fit between each other, so that chains of both touch there. And Observation 3.1.5
   for a loop that passes the first one. *)
From Coq Require Import QArith Lqa List Bool ZArith.
From Oplus Require Import convolution convolution_winding regions meeting_of_segments interiors_meet neighbourhoods
  left_of_an_edge theorem_4_2_1 valid_components simple_polygons inside_a_corner boundary_points simple_chain
  simple_chains_turn_once edges_at_a_point reduced_edges_that_pass test_of_regions small_regions collision_is_complete
  checked_collision filling pieces algorithm_1 arranged_convolution arrangement_of_the_convolution theorem_3_2_10
  chains_that_do_not_cross
  printed_theorem_3_2_10 small_polygons polygons_of_the_thesis drawn_regions drawn_sums refuted_observation_3_1_5.
Import ListNotations.

Open Scope Q_scope.

Definition around_the_triangle : region := region_of square_with_a_triangle.
Definition fitting_triangle : region := region_of triangle_that_fits.

Lemma only_place_in_the_triangle : isolated_vertex (Vector 0 0) around_the_triangle fitting_triangle.
Proof.
  split.
  - rewrite <- collide_decides_for_checked_regions by (vm_compute; reflexivity). vm_compute. discriminate.
  - exists (1 # 8). split; [lra |]. intros [a b] near differ. unfold within, equal_vectors in *; cbn [vx vy] in *.
    destruct (Qlt_le_dec a 0) as [? | a_low]; [| destruct (Qlt_le_dec b 0) as [? | b_low];
      [| destruct (Qlt_le_dec 0 (a + b)) as [? | none]]].
    + exists (Vector ((1 # 2) * a) (1 # 2)). unfold minus; cbn [vx vy]. split; inside_by_arithmetic.
    + exists (Vector (1 # 2) ((1 # 2) * b)). unfold minus; cbn [vx vy]. split; inside_by_arithmetic.
    + exists (Vector ((1 # 2) + (1 # 4) * (a + b)) ((1 # 2) + (1 # 4) * (a + b))). unfold minus; cbn [vx vy].
      split; inside_by_arithmetic.
    + exfalso. apply differ. split; lra.
Qed.

(* A slit makes the square with the triangular hole a simple polygon. *)
Definition square_with_a_slit : list vector :=
  points_at [(-2, -2); (3, -2); (3, 3); (-2, 3); (-2, 3 # 8); (0, 3 # 8); (0, 1); (1, 0); (0, 0); (0, 1 # 4);
    (-2, 1 # 4)].
Definition one_triangle : list vector := points_at [(0, 0); (-1, 0); (0, -1)].

Lemma only_place_beside_the_slit : isolated_vertex (Vector 0 0) [square_with_a_slit] [one_triangle].
Proof.
  split.
  - rewrite <- collide_decides_for_checked_regions by (vm_compute; reflexivity). vm_compute. discriminate.
  - exists (1 # 8). split; [lra |]. intros [a b] near differ. unfold within, equal_vectors in *; cbn [vx vy] in *.
    destruct (Qlt_le_dec a 0) as [? | a_low]; [| destruct (Qlt_le_dec b 0) as [? | b_low];
      [| destruct (Qlt_le_dec 0 (a + b)) as [? | none]]].
    + exists (Vector ((1 # 2) * a) (1 # 2)). unfold minus; cbn [vx vy]. split; inside_by_arithmetic.
    + exists (Vector (1 # 2) ((1 # 2) * b)). unfold minus; cbn [vx vy]. split; inside_by_arithmetic.
    + exists (Vector ((1 # 2) + (1 # 4) * (a + b)) ((1 # 2) + (1 # 4) * (a + b))). unfold minus; cbn [vx vy].
      split; inside_by_arithmetic.
    + exfalso. apply differ. split; lra.
Qed.

Example three_directions_of_simple_polygons : exists s1 s2 s3,
  incl [s1; s2; s3] (convolution_segments [square_with_a_slit] [one_triangle]) /\
  lies_on (Vector 0 0) s1 /\ lies_on (Vector 0 0) s2 /\ lies_on (Vector 0 0) s3 /\
  ~ same_direction (along s1) (along s2) /\ ~ same_direction (along s1) (along s3) /\
  ~ same_direction (along s2) (along s3).
Proof.
  apply theorem_3_2_10_for_simple_polygons; [split; [apply is_simple_decides |]; vm_compute; reflexivity .. |].
  exact only_place_beside_the_slit.
Qed.

Definition triangles_left_and_right : region :=
  [points_at [(0, 0); (1, -1); (1, 1)]; points_at [(0, 0); (-1, 1); (-1, -1)]].
Definition triangles_above_and_below : region :=
  [points_at [(0, 0); (1, 1); (-1, 1)]; points_at [(0, 0); (-1, -1); (1, -1)]].

Lemma only_place_between_the_triangles :
  isolated_vertex (Vector 0 0) triangles_left_and_right triangles_above_and_below.
Proof.
  split.
  - rewrite <- collide_decides_for_checked_regions by (vm_compute; reflexivity). vm_compute. discriminate.
  - exists (1 # 8). split; [lra |]. intros [a b] near differ. unfold within, equal_vectors in *; cbn [vx vy] in *.
    destruct (Q_dec a 0) as [[? | ?] | a_none]; destruct (Q_dec b 0) as [[? | ?] | b_none];
      [exists (Vector a 0) | exists (Vector a 0) | exists (Vector a (- (1 # 2) * a)) |
       exists (Vector a 0) | exists (Vector a 0) | exists (Vector a ((1 # 2) * a)) |
       exists (Vector (- (1 # 2) * b) 0) | exists (Vector ((1 # 2) * b) 0) | exfalso; apply differ; split; lra];
      unfold minus; cbn [vx vy]; split; inside_by_arithmetic.
Qed.

Lemma these_are_regions :
  (valid_region around_the_triangle /\ valid_region fitting_triangle /\ valid_region triangles_left_and_right /\
   valid_region triangles_above_and_below) /\
  chains_do_not_cross around_the_triangle /\ chains_do_not_cross fitting_triangle /\
  chains_do_not_cross triangles_left_and_right /\ chains_do_not_cross triangles_above_and_below.
Proof.
  assert (all : valid_region around_the_triangle /\ valid_region fitting_triangle /\
    valid_region triangles_left_and_right /\ valid_region triangles_above_and_below)
    by (split; [| split; [| split]]; apply is_valid_region_is_right; vm_compute; reflexivity).
  split; [exact all |]. destruct all as (r1 & r2 & r3 & r4).
  split; [| split; [| split]]; apply cross_nowhere_is_right; trivial; vm_compute; reflexivity.
Qed.

Example three_directions_where_the_triangle_fits : exists s1 s2 s3,
  incl [s1; s2; s3] (convolution_segments around_the_triangle fitting_triangle) /\
  lies_on (Vector 0 0) s1 /\ lies_on (Vector 0 0) s2 /\ lies_on (Vector 0 0) s3 /\
  ~ same_direction (along s1) (along s2) /\ ~ same_direction (along s1) (along s3) /\
  ~ same_direction (along s2) (along s3).
Proof. apply theorem_3_2_10_as_printed; [apply these_are_regions .. | exact only_place_in_the_triangle]. Qed.

Example three_directions_where_chains_touch : exists s1 s2 s3,
  incl [s1; s2; s3] (convolution_segments triangles_left_and_right triangles_above_and_below) /\
  lies_on (Vector 0 0) s1 /\ lies_on (Vector 0 0) s2 /\ lies_on (Vector 0 0) s3 /\
  ~ same_direction (along s1) (along s2) /\ ~ same_direction (along s1) (along s3) /\
  ~ same_direction (along s2) (along s3).
Proof. apply theorem_3_2_10_as_printed; [apply these_are_regions .. | exact only_place_between_the_triangles]. Qed.

(* That chains of both touch there. *)
Example chains_touch_in_the_vertex :
  ~ alone (Vector 0 0) triangles_left_and_right /\ ~ alone (Vector 0 0) triangles_above_and_below.
Proof.
  split; intros alone_.
  - destruct (alone_ (points_at [(0, 0); (1, -1); (1, 1)]) 0%nat) as (_ & _ & _ & only);
      [now left | repeat constructor | now split |].
    destruct (only (Segment (Vector 0 0) (Vector (-1) 1))) as [is_ | is_]; [vm_compute; tauto | | |];
      [apply on_edge_by_computation; vm_compute; reflexivity | vm_compute in is_; discriminate is_ ..].
  - destruct (alone_ (points_at [(0, 0); (1, 1); (-1, 1)]) 0%nat) as (_ & _ & _ & only);
      [now left | repeat constructor | now split |].
    destruct (only (Segment (Vector 0 0) (Vector (-1) (-1)))) as [is_ | is_]; [vm_compute; tauto | | |];
      [apply on_edge_by_computation; vm_compute; reflexivity | vm_compute in is_; discriminate is_ ..].
Qed.

Example a_segment_below_the_vertex : exists s,
  In s (convolution_segments triangles_left_and_right triangles_above_and_below) /\ lies_on (Vector 0 0) s /\
  0 < cross (along s) (Vector 0 (-1)).
Proof.
  apply every_direction_is_left_of_a_segment; [apply these_are_regions .. | exact only_place_between_the_triangles |].
  intros [_ Y]. discriminate Y.
Qed.

(* Close to the vertex, inside an edge of the false loop that passes it, the triangle overlaps the square. *)
Example collision_inside_the_false_loop :
  interiors_meet (Vector 0 (- (1 # 2))) around_the_triangle fitting_triangle.
Proof.
  destruct what_is_computed as (p_test & q_test & _ & loop_listed & e_listed & not_filled).
  apply covers_nothing_twice_is_right in p_test, q_test.
  destruct p_test as [p_region p_simple], q_test as [q_region q_simple].
  apply is_listed_spec in loop_listed, e_listed, not_filled. set (e := Segment (Vector 0 (-1)) (Vector 0 0)) in *.
  assert (E : In e false_loop) by exact (or_introl eq_refl).
  assert (back : is_listed segment_dec (reversed e) (convolution_arrangement around_the_triangle fitting_triangle) =
    false) by (vm_compute; reflexivity).
  apply is_listed_spec in back. destruct these_are_regions as (_ & p_crosses_nowhere & q_crosses_nowhere & _).
  refine (false_loops_make_them_collide_inside_edges _ _ false_loop e _ p_region q_region p_simple q_simple
    p_crosses_nowhere q_crosses_nowhere _ E _ back).
  - exact (false_loop_by_an_edge _ _ _ _ p_region q_region loop_listed E e_listed not_filled).
  - exists (1 # 2). cbn [source target vx vy e]. split; [lra | split; lra].
Qed.
