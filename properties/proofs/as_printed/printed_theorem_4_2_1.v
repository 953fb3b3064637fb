(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Theorem 4.2.1 as printed: P and Q are two simple polygons, x is a point off their convolution. Then the winding
   number of the convolution at x is positive if and only if P and -Q + x have a point in common. The thesis has
   closed polygons; for open ones, whose common point is inside both, it holds, too. Both are proved for all regions,
   of any number of chains: the first in theorem_4_2_1.v, the second in fans_that_touch.v. *)
From Coq Require Import List.
From Oplus Require Import numbers convolution convolution_winding regions interiors_meet theorem_4_2_1 fans_that_touch
  simple_polygons test_of_regions polygons_of_the_thesis drawn_regions.
Import ListNotations.

Open Scope Q_scope.

(* Theorem 4.2.1. *)
Theorem theorem_4_2_1_as_printed (p q : list vector) (x : vector) :
  simple_polygon p -> simple_polygon q -> off x (convolution_segments [p] [q]) ->
  ((0 < winding_number x (convolution_segments [p] [q]))%Z <-> exists z, in_region z [p] /\ in_reflected x [q] z).
Proof.
  intros. rewrite <- sum_as_intersection.
  apply positive_winding_number_iff_common_point; trivial; now apply simple_polygons_are_regions.
Qed.

(* Theorem 4.2.1 for open polygons: z is inside P, and x - z inside Q. *)
Theorem theorem_4_2_1_for_open_polygons (p q : list vector) (x : vector) :
  simple_polygon p -> simple_polygon q -> off x (convolution_segments [p] [q]) ->
  ((0 < winding_number x (convolution_segments [p] [q]))%Z <-> exists z, inside z [p] /\ inside (minus x z) [q]).
Proof.
  intros. apply positive_winding_number_iff_common_inner_point; trivial;
    now apply simple_polygons_are_regions.
Qed.

(* Theorem 4.2.1 for polygons with holes and several components, as Section 4.2.4 has them. *)
Theorem theorem_4_2_1_for_regions (p q : region) (x : vector) :
  valid_region p -> valid_region q -> off x (convolution_segments p q) ->
  ((0 < winding_number x (convolution_segments p q))%Z <-> exists z, in_region z p /\ in_reflected x q z) /\
  ((0 < winding_number x (convolution_segments p q))%Z <-> exists z, inside z p /\ inside (minus x z) q).
Proof.
  intros. rewrite <- sum_as_intersection. split.
  - now apply positive_winding_number_iff_common_point.
  - now apply positive_winding_number_iff_common_inner_point.
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
