(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The theorems of as_printed/, applied to regions that one can draw: their hypotheses hold for these, as is
   computed. *)
From Coq Require Import QArith Lqa ZArith Lia Bool List Permutation.
From Oplus Require Import convolution theorem_4_2_1 theorem_2_2_10 lemma_2_2_2 polygons_of_the_thesis drawn_regions
  printed_corollary_2_2_3 definition_2_2_8 small_polygons fans_that_touch printed_definition_2_2_7 printed_lemma_2_2_2
  printed_equation_2_1 regions neighbourhoods printed_lemma_2_2_2 left_of_an_edge winding_number_of_the_sum lemma_2_2_5
  theorem_3_2_8 printed_lemma_2_2_5 printed_lemma_4_1_3 printed_lemma_4_1_4 balanced_graph convolution_graph
  printed_lemma_4_1_5 lemma_4_1_8 printed_lemma_4_1_8 tracing_programs printed_theorem_4_1_10 signed_crossings
  replaced_segments lemma_4_2_13
  printed_lemma_4_2_13 convolution_winding finite_sums interiors_meet lemma_4_2_15 simple_chain simple_chains_turn_once
  printed_lemma_4_2_15 theorem_2_2_6 reflected placed_collision printed_observation_4_2_5
  printed_observation_4_2_8 naive_collision
  collision_is_complete section_5_1 simple_polygons printed_section_5_1 printed_theorem_2_2_10 printed_theorem_2_2_6
  test_of_regions printed_theorem_4_2_1 connected_sets small_intersection printed_theorem_4_2_14 drawn_sums.
Import ListNotations.

Open Scope Q_scope.

(* In the room, the diamond can touch the left wall. *)
Example at_the_wall : exists a b, on_boundary a [room] /\ on_boundary b [fitting_diamond] /\
  equal_vectors (Vector 2 3) (plus a b).
Proof.
  apply corollary_2_2_3_as_printed; [apply simple_polygons_are_regions, drawn_polygons .. | exact wall_of_the_sum].
Qed.

(* Squares with parallel sides, one with a hole: all directions of the one are equal to some of the other. *)
Example ties_do_not_matter (x : vector) :
  in_convolution_by_2_2_7 chamber [square] x <-> in_convolution_by_2_2_7 [square] chamber x.
Proof. apply definition_2_2_7_as_printed; [apply drawn_regions | apply square_is_a_region]. Qed.

(* The segments differ: with Q's directions turned, the edge of the small square from (0, 0) to (2, 0) is at the
   vertex (6, 0) of the large one, with those of P turned it is at (0, 0). *)
Example but_the_segments_are_others :
  existsb (fun s => Qeq_bool (vx (starts_at s)) 0 && Qeq_bool (vy (starts_at s)) 0 && Qeq_bool (vx (ends_at s)) 2)
    (segments_of_regions chamber [square]) = false /\
  existsb (fun s => Qeq_bool (vx (starts_at s)) 0 && Qeq_bool (vy (starts_at s)) 0 && Qeq_bool (vx (ends_at s)) 2)
    (segments_of_regions [square] chamber) = true.
Proof. split; vm_compute; reflexivity. Qed.

(* Two sides of squares. *)
Example lower_sides_add_up (x : vector) :
  sum_of_sets (fun y => lies_on y (Segment (Vector 0 0) (Vector 6 0)))
    (fun y => lies_on y (Segment (Vector 0 0) (Vector 2 0))) x <-> lies_on x (Segment (Vector 0 0) (Vector 8 0)).
Proof.
  apply (sum_of_segments_of_one_direction (Vector 0 0) (Vector 6 0) (Vector 0 0) (Vector 2 0) x (1 # 3)); reflexivity.
Qed.

(* (0, 0) is a boundary point of the sum of a square with a hole and a square, and the sum of (0, 0) and (0, 0). *)
Example lowest_corner_of_a_sum :
  on_boundary_of_set (fun a => in_region a chamber) (Vector 0 0) /\
  on_boundary_of_set (fun b => in_region b [square]) (Vector 0 0).
Proof.
  apply (lemma_2_2_2_as_printed _ _ (Vector 0 0)).
  - apply sums_of_regions_are_sums_of_sets, lower_side_of_the_sum. lra.
  - right. exists (Segment (Vector 0 0) (Vector 6 0)). split; [now left |].
    apply on_edge_by_computation. vm_compute. reflexivity.
  - right. exists (Segment (Vector 0 0) (Vector 2 0)). split; [now left |].
    apply on_edge_by_computation. vm_compute. reflexivity.
  - split; reflexivity.
Qed.

(* (2, 0) is the sum of points inside the lower sides of both squares. *)
Example lower_sides (d : vector) :
  in_tangent_set_inside (Segment (Vector 0 0) (Vector 6 0)) d <->
  in_tangent_set_inside (Segment (Vector 0 0) (Vector 2 0)) d.
Proof.
  apply (lemma_2_2_5_as_printed chamber [square] _ _ (Vector 1 0) (Vector 1 0)).
  - apply drawn_regions.
  - apply square_is_a_region.
  - now left.
  - exists (1 # 6). vm_compute. repeat split; reflexivity.
  - now left.
  - exists (1 # 2). vm_compute. repeat split; reflexivity.
  - change (plus (Vector 1 0) (Vector 1 0)) with (Vector 2 0). apply lower_side_of_the_sum. lra.
Qed.

(* Two rooms: at the inner corner (6, 5) of one and (1, 1) of the other both segments leave, so both lead there. *)
Example opposite_inner_corners :
  segment_leads_to room room OfP (5, 7)%nat /\ segment_leads_to room room OfQ (5, 7)%nat.
Proof.
  assert (edges_ : no_edge_is_a_point room)
    by (apply (simple_polygons_are_regions room); [apply drawn_polygons | now left]).
  apply (lemma_4_1_3_as_printed room room 5 7); trivial.
  - cbn. repeat constructor.
  - cbn. repeat constructor.
  - exists OfP. vm_compute. reflexivity.
  - split; vm_compute; reflexivity.
Qed.

(* Four segments end in (4, 4), and four start there. Four states are this point: each corner of the hole with the
   opposite one of the square. *)
Example degrees_where_states_coincide :
  indegree chamber [square] (Vector 4 4) = outdegree chamber [square] (Vector 4 4) /\
  outdegree chamber [square] (Vector 4 4) = 4%nat.
Proof.
  split; [| vm_compute; reflexivity].
  apply lemma_4_1_4_as_printed; [apply drawn_regions | apply square_is_a_region].
Qed.

(* The square with a hole and the square. *)
Example cycles_of_a_square_with_a_hole :
  exists cycles, Forall (simple_cycle starts_at_node ends_at_node) cycles /\
    Permutation (concat cycles) (segments_of_regions chamber [square]).
Proof. apply lemma_4_1_5_as_printed; [apply drawn_regions | apply square_is_a_region]. Qed.

(* The room and the diamond. *)
Example rows_and_columns_of_the_room :
  (forall j, (j < 4)%nat -> exists i, (i < 12)%nat /\ is_convolution_segment room fitting_diamond OfQ i j = true) /\
  (forall i, (i < 12)%nat -> exists j, (j < 4)%nat /\ is_convolution_segment room fitting_diamond OfP i j = true).
Proof. apply (lemma_4_1_8_as_printed room fitting_diamond); apply drawn_polygons. Qed.

(* 12 and 4 vertices, 32 segments. *)
Example tracing_the_room_takes_little_time : (operation_count (traced room fitting_diamond) <= 16 * (12 + 4 + 32))%nat.
Proof.
  destruct (theorem_4_1_10_as_printed room fitting_diamond) as (_ & few & _); [apply drawn_polygons .. |].
  assert (size : length (convolution room fitting_diamond) = 32%nat) by (vm_compute; reflexivity).
  rewrite size in few. exact few.
Qed.

(* The room has four reflex vertices. *)
Example the_original_convolution_of_the_room :
  well_defined_winding_numbers (original_convolution [room] [fitting_diamond]).
Proof. apply lemma_4_2_13_as_printed; apply simple_polygons_are_regions, drawn_polygons. Qed.

(* A bar across the two arms of the letter U meets it in two components, where it is flush with the ends of the arms and
   with a side of the U, too: there x is on the vertex-edge sum, but off the convolution. *)
Example bar_in_two_components :
  has_components (fun z => in_region z region_of_letter_u /\ in_reflected (Vector 1 1) bar z) 2.
Proof.
  destruct (theorem_4_2_14_as_printed (hd [] region_of_letter_u) (hd [] bar) (Vector 1 1)) as (k & components & number).
  1, 2: split; [apply is_simple_decides |]; vm_compute; reflexivity.
  1, 2: apply off_by_computation; vm_compute; reflexivity.
  unfold region_of_letter_u, bar in *. cbn [hd] in *.
  change (winding_number _ _) with (Z.of_nat 2) in number.
  apply Nat2Z.inj in number. now rewrite <- number in components.
Qed.

(* At the inner corner (6, 5) of the room, in a point inside the diamond placed there. *)
Example at_an_inner_corner : let x := Vector (13 # 2) 5 in
  winding_number x (replaced (only_vertex OfP room 5) [room] [fitting_diamond]) =
  (winding_number x (convolution_segments [room] [fitting_diamond]) - 1)%Z.
Proof.
  apply (lemma_4_2_15_as_printed room fitting_diamond 5); [apply drawn_polygons .. | | |].
  - cbn. repeat constructor.
  - apply off_by_computation. vm_compute. reflexivity.
  - apply inside_by_computation. vm_compute. reflexivity.
Qed.

(* (2, 3) is on a segment of the convolution of the room and the diamond; there the diamond touches the wall. *)
Example a_vertex_on_an_edge :
  (exists v f, is_vertex v [room] /\ In f (region_edges (placed (Vector 2 3) [fitting_diamond])) /\ lies_on v f) \/
  (exists v e, is_vertex v (placed (Vector 2 3) [fitting_diamond]) /\ In e (region_edges [room]) /\ lies_on v e).
Proof.
  apply (observation_4_2_8_as_printed [room] [fitting_diamond] _ (Segment (Vector 2 1) (Vector 2 5))).
  - vm_compute. tauto.
  - apply on_edge_by_computation. vm_compute. reflexivity.
Qed.

(* The square from (0, 0) to (2, 2) touches the room's corner from within; the letter L overlaps it. *)
Example touching_is_no_collision :
  ~ (exists z, inside z [room] /\ inside z [points_at [(1, 1); (3, 1); (3, 3); (1, 3)]]) /\
  (exists z, inside z [room] /\ inside z [letter_l]).
Proof.
  rewrite <- !section_5_1_as_printed by first [apply drawn_polygons |
    split; [apply is_simple_decides |]; vm_compute; reflexivity].
  split; [vm_compute; discriminate | vm_compute; reflexivity].
Qed.

(* From (-1, 1) a path to (1, 1) crosses the left side of the square with corners (0, 0) and (2, 2). *)
Example into_the_square : let path := [Vector (-1) 1; Vector 1 1] in
  sum (map (fun step_ => sum (map (fun s => if negative (vy (along s)) then 1%Z else 0%Z) (edges square)))
    (steps_of_path path)) =
  (winding_number (Vector 1 1) (edges square) - winding_number (Vector (-1) 1) (edges square))%Z.
Proof.
  apply (observation_4_2_5_as_printed square [Vector 1 1] (Vector (-1) 1)
    (fun _ s => if negative (vy (along s)) then 1%Z else 0%Z)).
  - apply off_by_computation. vm_compute. reflexivity.
  - apply off_by_computation. vm_compute. reflexivity.
  - intros step_ s x [<- | []] [<- | [<- | [<- | [<- | []]]]] (k & range & X & Y) (l & range' & X' & Y');
      cbn [fst snd source target vx vy] in *; try (exfalso; lra). split; [exists k | split; [exists l |]].
    + split; [lra | split; [exact X | exact Y]].
    + split; [lra | split; [exact X' | exact Y']].
    + vm_compute. discriminate.
  - intros step_ s [<- | []] [<- | [<- | [<- | [<- | []]]]]; (split; [| try reflexivity]);
      try (intros x (k & range & X & Y) (l & range' & X' & Y'); cbn [fst snd source target vx vy] in *; exfalso; lra).
    + intros x _ _. vm_compute. reflexivity.
    + intros apart_. destruct (apart_ (Vector 0 1)); [exists (1 # 2) | exists (1 # 2)];
        cbn [fst snd source target vx vy]; lra.
Qed.

(* Where the diamond touches the room's wall. *)
Example the_wall_is_on_the_convolution :
  exists s, In s (convolution_segments [room] [fitting_diamond]) /\ lies_on (Vector 2 3) s.
Proof.
  apply theorem_2_2_10_as_printed; [apply simple_polygons_are_regions, drawn_polygons .. | exact wall_of_the_sum].
Qed.

(* Where the diamond touches the room's wall. *)
Example the_wall_is_on_the_vertex_edge_sum : on_vertex_edge_sum (Vector 2 3) [room] [fitting_diamond].
Proof.
  apply theorem_2_2_6_as_printed; [apply simple_polygons_are_regions, drawn_polygons .. | exact wall_of_the_sum].
Qed.

(* In the hatch of the room the diamond, moved a little to the side, meets a wall; in the middle of the room it does
   not. *)
Example in_the_hatch : exists z, inside z [room] /\ inside (minus (Vector (41 # 10) (11 # 2)) z) [fitting_diamond].
Proof.
  apply theorem_4_2_1_for_open_polygons; [apply drawn_polygons .. | |].
  - apply off_by_computation. vm_compute. reflexivity.
  - vm_compute. reflexivity.
Qed.

Example in_the_room : ~ exists z, in_region z [room] /\ in_reflected (Vector 4 3) [fitting_diamond] z.
Proof.
  rewrite <- theorem_4_2_1_as_printed; [| apply drawn_polygons .. |].
  - intros positive_. vm_compute in positive_. discriminate positive_.
  - apply off_by_computation. vm_compute. reflexivity.
Qed.

(* A small square fits into the hole of a large one. *)
Example in_the_hole :
  let small := points_at [(0, 0); (1, 0); (1, 1); (0, 1)] in
  ~ exists z, in_region z chamber /\ in_reflected (Vector (7 # 2) (7 # 2)) [small] z.
Proof.
  cbv zeta. destruct (theorem_4_2_1_for_regions chamber [points_at [(0, 0); (1, 0); (1, 1); (0, 1)]]
    (Vector (7 # 2) (7 # 2))) as [by_number _].
  - apply drawn_regions.
  - apply is_valid_region_is_right. vm_compute. reflexivity.
  - apply off_by_computation. vm_compute. reflexivity.
  - rewrite <- by_number. intros positive_. vm_compute in positive_. discriminate positive_.
Qed.
