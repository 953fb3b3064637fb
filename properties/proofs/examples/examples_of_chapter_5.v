(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The theorems of Chapter 5 that are not in as_printed/, on the room and the diamond and the square with a hole and
   the square. *)
From Coq Require Import QArith Lqa List.
From Oplus Require Import regions_and_sums small_numbers shifted_ray reflected simple_chain simple_chains_turn_once
  simple_polygons naive_collision placed_collision observation_5_2_1 pairs_of_edges collision_by_pairs
  printed_section_5_1_2 printed_section_5_2 polygons_of_the_thesis drawn_regions drawn_sums.
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

(* Sections 5.1.1 and 5.1.2: two triangles that cross, found by a sweep and by hierarchies of boxes. *)
Definition triangle_below : list vector := points_at [(0, 0); (2, 0); (1, 2)].
Definition triangle_above_reflected : list vector := points_at [(0, -1); (-2, -1); (-1, -3)].

Definition unit_square_here : list vector := points_at [(0, 0); (1, 0); (1, 1); (0, 1)].
Definition unit_square_here_reflected : list vector := points_at [(0, 0); (-1, 0); (-1, -1); (0, -1)].

Fixpoint some_hierarchy (s : segment) (l : list segment) : hierarchy :=
  match l with [] => OneEdge s | f :: rest => joined_hierarchies (OneEdge s) (some_hierarchy f rest) end.

Lemma some_hierarchy_is_one (l : list segment) : forall s,
  is_boxed (some_hierarchy s l) /\ edges_of_hierarchy (some_hierarchy s l) = s :: l.
Proof.
  induction l as [| f rest IH]; intros s; [now split |]. destruct (IH f) as [boxed edges_are]. split.
  - apply joined_is_boxed; [exact I | exact boxed].
  - cbn [some_hierarchy joined_hierarchies edges_of_hierarchy app]. now rewrite edges_are.
Qed.

Lemma triangles_are_regions : valid_region [triangle_below] /\ valid_region [triangle_above_reflected] /\
  off_vertex_edge_sum (Vector 0 0) [triangle_below] [triangle_above_reflected].
Proof.
  split; [| split].
  1, 2: apply simple_polygons_are_regions; split; [apply is_simple_decides |]; vm_compute; reflexivity.
  apply general_position_by_computation. vm_compute. reflexivity.
Qed.

Example triangles_found_by_hierarchies : interiors_meet (Vector 0 0) [triangle_below] [triangle_above_reflected].
Proof.
  destruct triangles_are_regions as (p_region & q_region & general).
  set (of_p := region_edges [triangle_below]).
  set (of_q := map (reflected (Vector 0 0)) (region_edges [triangle_above_reflected])).
  destruct (some_hierarchy_is_one (tl of_p) (hd no_segment of_p)) as [boxed_p edges_p].
  destruct (some_hierarchy_is_one (tl of_q) (hd no_segment of_q)) as [boxed_q edges_q].
  apply (collision_by_hierarchies _ _ _ _ _ p_region q_region general boxed_p boxed_q).
  - intros s. rewrite edges_p. reflexivity.
  - intros s. rewrite edges_q. reflexivity.
  - left. eexists _, _. vm_compute. left. reflexivity.
Qed.

Example triangles_found_by_a_sweep : interiors_meet (Vector 0 0) [triangle_below] [triangle_above_reflected].
Proof.
  destruct triangles_are_regions as (p_region & q_region & general).
  apply (collision_by_sweep _ _ _ (map (pair true) (region_edges [triangle_below]) ++
    map (pair false) (map (reflected (Vector 0 0)) (region_edges [triangle_above_reflected])))
    p_region q_region general).
  - repeat constructor; vm_compute; discriminate.
  - reflexivity.
  - left. eexists _, _. vm_compute. left. reflexivity.
Qed.

(* Section 5.2: close to the right of an edge of a convolution, a traversal of the faces gives a number. *)
Example a_face_gets_a_number : exists e k, 0 < e /\ gets_number
  (convolution_segments [triangle_below] [triangle_above_reflected])
  (moved (right_of_middle (Segment (Vector 0 (-1)) (Vector 2 (-1)))) e) k.
Proof.
  destruct (some_small _ (section_5_2_as_printed [triangle_below] [triangle_above_reflected]
    (Segment (Vector 0 (-1)) (Vector 2 (-1)))
    (proj1 (proj1 triangles_are_regions)) (proj1 (proj1 (proj2 triangles_are_regions)))
    ltac:(unfold nonzero, along, minus; cbn; lra))) as (e & some & (k & number) & _).
  now exists e, k.
Qed.

(* Where boundaries run along each other: two squares, the second one moved by 1/2. *)
Example squares_found_by_hierarchies : interiors_meet (Vector (1 # 2) 0) [unit_square_here]
  [unit_square_here_reflected].
Proof.
  assert (polygons : simple_polygon unit_square_here /\ simple_polygon unit_square_here_reflected)
    by (split; (split; [apply is_simple_decides |]; vm_compute; reflexivity)).
  destruct polygons as [p_polygon q_polygon].
  set (of_p := region_edges [unit_square_here]).
  set (of_q := map (reflected (Vector 0 0)) (region_edges [unit_square_here_reflected])).
  destruct (some_hierarchy_is_one (tl of_p) (hd no_segment of_p)) as [boxed_p edges_p].
  destruct (some_hierarchy_is_one (tl of_q) (hd no_segment of_q)) as [boxed_q edges_q].
  apply (section_5_1_2_as_printed _ _ _ _ p_polygon q_polygon boxed_p boxed_q edges_p edges_q).
  vm_compute. reflexivity.
Qed.
