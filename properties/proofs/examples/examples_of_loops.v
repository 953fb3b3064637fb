(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The theorems of Chapter 3 on the loops of the boundary, on Algorithm 1 and on dangling edges as the thesis prints
   them, applied to regions that one can draw. *)
From Coq Require Import QArith Qminmax Lqa ZArith Lia Bool List Permutation.
From Oplus Require Import regions_and_sums simple_chain simple_chains_turn_once angle inside_a_corner theorem_2_2_10
  lemma_2_2_2 observation_2_2_4 filling interiors_meet parallelogram reduced_convolution polygons_of_the_thesis
  printed_lemma_2_2_2 drawn_regions drawn_sums connected_sets refuted_definition_2_1_9 refuted_corollary_3_1_3
  faces_of_the_sum chains_of_faces loops_of_the_boundary algorithm_1 arranged_convolution arrangement_of_the_convolution
  printed_lemma_3_1_2 printed_observation_3_1_4 printed_observation_3_2_4 printed_observation_3_2_5
  printed_theorem_3_2_8 printed_observation_3_2_6 refuted_observation_3_1_5.
Import ListNotations.

Open Scope Q_scope.

Lemma room_and_diamond_are_regions : valid_region [room] /\ valid_region [fitting_diamond].
Proof. split; apply simple_polygons_are_regions, drawn_polygons. Qed.

Lemma slit_and_square_are_regions : valid_region [room_with_a_slit] /\ valid_region [unit_square].
Proof. split; apply simple_polygons_are_regions, they_are_polygons. Qed.

(* Lemma 3.1.2. (2, 3) is on the wall that the room leaves the diamond, so a loop passes there. *)
Example a_loop_along_the_wall : exists loop e, orientable_loop loop /\ In e (edges loop) /\ lies_on (Vector 2 3) e /\
  is_directed_as_the_convolution [room] [fitting_diamond] e.
Proof.
  destruct room_and_diamond_are_regions as [p_region q_region].
  destruct (lemma_3_1_2_as_printed _ _ p_region q_region) as (loops & boundary & orientable & directed_).
  destruct (proj1 (boundary (Vector 2 3)) wall_of_the_sum) as (e & E & on). pose proof E as F.
  apply in_flat_map in F. destruct F as (loop & L & F). exists loop, e. auto.
Qed.

(* Observation 3.1.4. The sum of the room with a slit and the square has a hole: an external loop and one inside. *)
Example an_external_loop_and_a_hole :
  map is_counterclockwise (boundary_loops [room_with_a_slit] [unit_square]) = [true; false].
Proof. vm_compute. reflexivity. Qed.

(* Observation 3.2.6. And so it is by the theorem: one external loop, and holes in it. *)
Example one_loop_is_external : exists outer_ holes,
  Permutation (boundary_loops [room_with_a_slit] [unit_square]) (outer_ :: holes) /\
  is_counterclockwise outer_ = true /\ forall h, In h holes -> is_counterclockwise h = false /\ encloses outer_ h.
Proof. apply observation_3_2_6_as_printed; apply they_are_polygons. Qed.

Example paths_in_the_sum : connected_in (fun z => in_sum z [room_with_a_slit] [unit_square])
  (plus (Vector 0 0) (Vector 1 1)) (plus (Vector 6 0) (Vector 0 0)).
Proof.
  assert (corner : forall chain i, (i < length chain)%nat -> in_region (nth i chain nowhere) [chain]).
  { intros chain i I. right. exists (edge_at chain i). split; [apply edge_at_in_region; [now left | exact I] |].
    rewrite edge_at_is by exact I. apply (source_lies_on (Segment _ _)). }
  apply observation_3_2_6_as_printed; [apply they_are_polygons .. | |].
  - exists (Vector 0 0), (Vector 1 1). split; [apply (corner room_with_a_slit 0%nat); cbn; lia |].
    split; [apply (corner unit_square 2%nat); cbn; lia | reflexivity].
  - exists (Vector 6 0), (Vector 0 0). split; [apply (corner room_with_a_slit 1%nat); cbn; lia |].
    split; [apply (corner unit_square 0%nat); cbn; lia | reflexivity].
Qed.

Example loops_are_nested : exists loops : list (list vector),
  (forall a b, In a loops -> In b loops -> directly_encloses loops a b ->
     (is_counterclockwise a = true -> is_counterclockwise b = false) /\
     (is_counterclockwise a = false -> is_counterclockwise b = true)).
Proof.
  destruct slit_and_square_are_regions as [p_region q_region].
  destruct (observation_3_1_4_as_printed _ _ p_region q_region) as (loops & _ & _ & _ & nested & _). now exists loops.
Qed.

(* Observation 3.2.4. From the lower side of a sum the largest clockwise turn leads on along its boundary. *)
Example along_the_boundary : exists e',
  best_direction (arrangement_of (convolution_segments [room_with_a_slit] [unit_square]))
    (Segment (Vector 0 0) (Vector 6 0)) = Some e' /\
  is_boundary_edge [room_with_a_slit] [unit_square] e'.
Proof.
  destruct slit_and_square_are_regions as [p_region q_region].
  set (e := Segment (Vector 0 0) (Vector 6 0)).
  assert (computed : is_listed segment_dec e (arrangement_of (convolution_segments [room_with_a_slit] [unit_square])) =
    true /\ is_listed segment_dec e (edges_on_the_boundary [room_with_a_slit] [unit_square]
    (convolution_segments [room_with_a_slit] [unit_square])) = true) by (split; vm_compute; reflexivity).
  destruct computed as [listed kept]. apply is_listed_spec in listed, kept.
  revert p_region q_region listed kept. generalize [room_with_a_slit], [unit_square]. intros p q p_region q_region.
  intros listed kept. pose proof (proj1 (both_are_convolutions p q)) as convolution_.
  apply (observation_3_2_4_as_printed p q (convolution_segments p q) e p_region q_region convolution_ listed).
  exact (proj2 (boundary_edges_are_kept p q p_region q_region _ convolution_ e listed) kept).
Qed.

(* Observation 3.2.5. Of the same sum Algorithm 1 traces the two loops, of 11 and of 5 edges, that share none. *)
Example traced_loops_share_no_edge :
  NoDup (concat (algorithm_1 (convolution_arrangement [room_with_a_slit] [unit_square]))).
Proof.
  destruct slit_and_square_are_regions as [p_region q_region].
  exact (proj1 (proj2 (observation_3_2_5_as_printed _ _ _ p_region q_region (proj1 (both_are_convolutions _ _))))).
Qed.

Example number_of_loops :
  map (@length segment) (algorithm_1 (convolution_arrangement [room_with_a_slit] [unit_square])) = [11%nat; 5%nat].
Proof. vm_compute. reflexivity. Qed.

(* Theorem 3.2.8. The diamond slides through the hatch along a dangling edge. *)
Definition way_through_the_hatch : segment := Segment (Vector 4 (21 # 4)) (Vector 4 (23 # 4)).

Lemma the_way_is_a_dangling_edge : dangling_edge way_through_the_hatch [room] [fitting_diamond].
Proof.
  split; [intros [_ Y]; vm_compute in Y; discriminate |]. intros [a b] (k & range & X & Y).
  unfold way_through_the_hatch in *. cbn [source target vx vy] in X, Y.
  assert (a_is : a == 4) by lra. assert (height : (21 # 4) < b /\ b < (23 # 4)) by lra. clear k range X Y.
  split; [| split].
  - intros (z & in_room & in_diamond). apply (hatch_is_free b); [lra .. |]. exists z. split; [exact in_room |].
    refine (inside_equal _ _ _ _ in_diamond). unfold minus; split; cbn [vx vy]; lra.
  - intros radius R. assert (exists t, 0 < t /\ t < 1 # 4 /\ t < radius) as (t & some & little & close).
    { exists ((1 # 2) * Qmin radius (1 # 4)). pose proof (Q.min_glb_lt radius (1 # 4) 0 R ltac:(lra)).
      pose proof (Q.le_min_l radius (1 # 4)). pose proof (Q.le_min_r radius (1 # 4)). lra. }
    exists (Vector (4 - t) b). split; [unfold within; cbn [vx vy]; lra |]. split; [in_coordinates; nra |].
    exists (Vector (3 - (1 # 2) * t) b). unfold minus; cbn [vx vy]. split; inside_by_arithmetic.
  - intros radius R. assert (exists t, 0 < t /\ t < 1 # 4 /\ t < radius) as (t & some & little & close).
    { exists ((1 # 2) * Qmin radius (1 # 4)). pose proof (Q.min_glb_lt radius (1 # 4) 0 R ltac:(lra)).
      pose proof (Q.le_min_l radius (1 # 4)). pose proof (Q.le_min_r radius (1 # 4)). lra. }
    exists (Vector (4 + t) b). split; [unfold within; cbn [vx vy]; lra |]. split; [in_coordinates; nra |].
    exists (Vector (4 + (1 # 2) * t) b). unfold minus; cbn [vx vy]. split; inside_by_arithmetic.
Qed.

Example segments_along_the_way (x : vector) : lies_on x way_through_the_hatch ->
  (exists s, In s (convolution_segments [room] [fitting_diamond]) /\ lies_on x s /\
     same_direction (along s) (along way_through_the_hatch)) /\
  (exists s, In s (convolution_segments [room] [fitting_diamond]) /\ lies_on x s /\
     same_direction (along s) (opposite (along way_through_the_hatch))).
Proof.
  intros on. destruct room_and_diamond_are_regions as [p_region q_region].
  exact (theorem_3_2_8_as_printed _ _ _ x p_region q_region the_way_is_a_dangling_edge on).
Qed.

(* Corollary 3.1.3 as corrected. *)
Example faces_have_weakly_simple_chains : exists chains : list (list vector),
  (forall chain, In chain chains -> weakly_simple chain) /\
  forall a x, inner_point_of_sum a [room_with_a_slit] [unit_square] ->
    on_boundary_of_set (face_of_the_sum [room_with_a_slit] [unit_square] a) x -> on_boundary x chains.
Proof.
  destruct slit_and_square_are_regions as [p_region q_region].
  destruct (corollary_3_1_3_as_corrected _ _ p_region q_region) as (chains & simple_ & bound & _). now exists chains.
Qed.

Example chains_bound_faces : exists chains : list (list vector),
  (forall x, on_boundary_of_sum x [room_with_a_slit] [unit_square] <-> on_boundary x chains) /\
  forall chain, In chain chains -> weakly_simple chain /\ exists a,
    inner_point_of_sum a [room_with_a_slit] [unit_square] /\ forall x, on_boundary x [chain] ->
      on_boundary_of_set (face_of_the_sum [room_with_a_slit] [unit_square] a) x.
Proof.
  destruct slit_and_square_are_regions as [p_region q_region].
  destruct (corollary_3_1_3_for_each_chain _ _ p_region q_region) as (chains & simple_ & boundary & face_ & _).
  exists chains. split; [exact boundary |]. intros chain C. split; [exact (simple_ chain C) | exact (face_ chain C)].
Qed.
