(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The theorems of Chapter 4 that are not in as_printed/ or refuted/, on the room and the diamond and the square with
   a hole and the square. *)
From Coq Require Import QArith Lqa ZArith Lia Bool List Permutation.
From Oplus Require Import convolution tracing balanced_graph convolution_graph convolution_cycles signed_crossings
  convolution_winding regions region_size valid_components test_of_components theorem_4_2_1_for_valid_regions
  size_of_valid_regions interiors_meet theorem_4_2_1 tangent_count small_polygons simple_polygons replaced_segments
  tangent_features polygons_of_the_thesis drawn_regions fans_that_touch simple_chain connected_parts
  tracing_programs printed_theorem_4_1_10 chains_of_the_intersection.
Import ListNotations.

Open Scope Q_scope.

(* The convolution has 12 (1 + 0) + 4 (1 + 4) segments, since the room has four reflex vertices. *)
Example size_of_the_convolution : length (convolution room fitting_diamond) = 32%nat.
Proof.
  rewrite convolution_size; [vm_compute; reflexivity | | | vm_compute; reflexivity ..];
    [apply (chains_turn_everywhere [room]) | apply (chains_turn_everywhere [fitting_diamond])];
    [apply simple_polygons_are_regions, drawn_polygons | now left ..
    | apply simple_polygons_are_regions, drawn_polygons | now left].
Qed.

(* Theorem 4.1.6 as it is coded, Theorem 4.1.10: tracing looks at 12 + 4 - 1 + 32 states, less one for each cycle. *)
Example tracing_the_room : exists cycles,
  trace_cycles 12 4 (in_convolution room fitting_diamond) = Some cycles /\ Forall (is_cycle 12 4) cycles /\
  Permutation (concat cycles) (convolution room fitting_diamond) /\
  (states_looked_at 12 4 cycles + length cycles = 47)%nat.
Proof.
  assert (edges_ : no_edge_is_a_point room /\ no_edge_is_a_point fitting_diamond).
  { split; [apply (simple_polygons_are_regions room) | apply (simple_polygons_are_regions fitting_diamond)];
      first [apply drawn_polygons | now left]. }
  destruct edges_ as [p_edges q_edges].
  destruct (cycles_cover_the_convolution room fitting_diamond p_edges q_edges)
    as (cycles & traced & are_cycles & together);
    [discriminate .. |].
  exists cycles. split; [exact traced |]. split; [exact are_cycles |]. split; [exact together |].
  pose proof (states_looked_at_are_few room fitting_diamond cycles p_edges q_edges) as few.
  rewrite size_of_the_convolution in few. cbn [length room fitting_diamond points_at map] in few.
  specialize (few ltac:(discriminate) ltac:(discriminate) traced). lia.
Qed.

(* The square with a hole and the square: one chain of 4 vertices is a hole. *)
Example tracing_the_chamber : let k := length (segments_of_regions chamber [square]) in
  (12 <= k)%nat /\
  (list_sum (map (fun c => operation_count (traced (fst c) (snd c))) (list_prod chamber [square])) <= 24 * k)%nat.
Proof.
  destruct (theorem_4_1_10_for_regions chamber [square]) as [few long]; [| | discriminate .. |].
  - repeat (apply Forall_cons; [apply simple_chains_turn_so, is_simple_decides; vm_compute; reflexivity |]).
    apply Forall_nil.
  - repeat (apply Forall_cons; [apply simple_chains_turn_so, is_simple_decides; vm_compute; reflexivity |]).
    apply Forall_nil.
  - split; [exact long | exact few].
Qed.

(* Lemma 4.1.5 with connected parts: whatever is connected to a segment of the room's convolution is on its circuit. *)
Example one_circuit_of_the_room e : In e (convolution room fitting_diamond) ->
  exists circuit others, closed_walk_of_edges state_before (state_after 12 4) circuit /\
    Permutation (circuit ++ others) (convolution room fitting_diamond) /\
    (forall f, In f circuit <-> is_connected state_before (state_after 12 4) (convolution room fitting_diamond) e f) /\
    (forall f, In f others -> ~ is_connected state_before (state_after 12 4) (convolution room fitting_diamond) e f).
Proof.
  apply (euler_circuit_of_connected_states room fitting_diamond);
    [apply (simple_polygons_are_regions room) | apply (simple_polygons_are_regions fitting_diamond)];
    first [apply drawn_polygons | now left].
Qed.

(* Observation 4.2.5. From outside, through the hatch's walls, to the middle of the room: crossings add up to zero. *)
Example a_path_into_the_room :
  signed_crossings_of_path [Vector 20 20; Vector 5 (11 # 2); Vector 4 3]
    (convolution_segments [room] [fitting_diamond]) = 0%Z.
Proof.
  destruct (convolution_crossings_add_up [room] [fitting_diamond] [Vector 5 (11 # 2); Vector 4 3]
    (Vector 20 20)) as [-> _].
  - apply (simple_polygons_are_regions room), drawn_polygons.
  - apply (simple_polygons_are_regions fitting_diamond), drawn_polygons.
  - apply off_by_computation. vm_compute. reflexivity.
  - apply off_by_computation. vm_compute. reflexivity.
  - vm_compute. reflexivity.
Qed.

(* Theorem 4.2.14: where the diamond is in the hatch of the room, the intersection has chains. *)
Example chains_in_the_hatch : exists r, valid_region r /\ (forall chain, In chain r -> simple chain) /\
  winding_number (Vector (41 # 10) (11 # 2)) (original_convolution [room] [fitting_diamond]) =
    (outer_chains r - holes r)%Z.
Proof.
  destruct (theorem_4_2_14_with_the_boundary_constructed room fitting_diamond (Vector (41 # 10) (11 # 2)))
    as (r & valid & all_simple & _ & number); [apply drawn_polygons .. | |].
  - apply general_position_by_computation. vm_compute. reflexivity.
  - exists r. split; [exact valid | split; [exact all_simple | exact number]].
Qed.

(* Theorem 4.2.1 in general position. *)
Example hatch_in_general_position : interiors_meet (Vector (41 # 10) (11 # 2)) [room] [fitting_diamond].
Proof.
  apply positive_winding_number_iff_interiors_meet; [apply simple_polygons_are_regions, drawn_polygons .. | |].
  - apply general_position_by_computation. vm_compute. reflexivity.
  - vm_compute. reflexivity.
Qed.

(* Section 4.2.4: the features at which a direction is tangent are as many for every direction. *)
Example tangents_in_the_hatch (d : vector) : nonzero d ->
  tangent_features d (Vector (41 # 10) (11 # 2)) [room] [fitting_diamond] = 1%Z.
Proof.
  intros some. rewrite (tangent_features_do_not_depend_on_the_direction _ _ d (Vector 1 0)).
  - vm_compute. reflexivity.
  - intros chain. now apply chains_turn_everywhere, simple_polygons_are_regions, drawn_polygons.
  - intros chain. now apply chains_turn_everywhere, simple_polygons_are_regions, drawn_polygons.
  - exact some.
  - intros [X _]. discriminate X.
Qed.

(* The same by any other ray, and as turns around the point. *)
Example by_any_ray (side : summand) (d : vector) : nonzero d ->
  winding_number_by_ray side d (Vector 4 3) (convolution_segments [room] [fitting_diamond]) = 0%Z.
Proof.
  intros some. destruct (convolution_winding_number_by_any_ray [room] [fitting_diamond] (Vector 4 3) side d)
    as [-> _]; trivial.
  - apply (simple_polygons_are_regions room), drawn_polygons.
  - apply (simple_polygons_are_regions fitting_diamond), drawn_polygons.
  - apply off_by_computation. vm_compute. reflexivity.
Qed.

(* Lemma 4.1.5, Euler circuits. *)
Example circuits_of_a_square_with_a_hole :
  exists circuits, circuits_of starts_at_node ends_at_node circuits (segments_of_regions chamber [square]).
Proof. apply euler_circuits_of_the_convolution; [apply drawn_regions | apply square_is_a_region]. Qed.

(* Regions by Definition 2.1.17: the square with the hole, by the test of components. *)
Definition chamber_component : list component :=
  [Component (points_at [(0, 0); (6, 0); (6, 6); (0, 6)]) [points_at [(2, 2); (2, 4); (4, 4); (4, 2)]]].
Definition square_component : list component := [Component square []].

Example by_the_test_of_components : in_sum (Vector 1 1) (region_of chamber_component) (region_of square_component).
Proof.
  apply theorem_4_2_1_by_the_test; [vm_compute; reflexivity .. | | vm_compute; reflexivity].
  apply off_by_computation. vm_compute. reflexivity.
Qed.

(* Its convolution with the square has 8 (1 + 0) + 4 (1 - 1 + 4) segments: one hole, of which all vertices are
reflex. *)
Example size_with_a_hole :
  length (segments_of_regions (region_of chamber_component) (region_of square_component)) = 24%nat.
Proof.
  apply Nat2Z.inj. rewrite convolution_size_of_valid_regions by (apply are_valid_components_sound; vm_compute;
    reflexivity).
  vm_compute. reflexivity.
Qed.

(* The tangent count: in the hatch, the point is counted once for every direction. *)
Example tangents_counted (d : vector) : nonzero d ->
  count_tangents (Vector (41 # 10) (11 # 2)) [room] [fitting_diamond] d =
  winding_number (Vector (41 # 10) (11 # 2)) (convolution_segments [room] [fitting_diamond]).
Proof.
  intros some. apply count_tangents_returns; trivial.
  - apply simple_polygons_are_regions, drawn_polygons.
  - apply simple_polygons_are_regions, drawn_polygons.
Qed.
