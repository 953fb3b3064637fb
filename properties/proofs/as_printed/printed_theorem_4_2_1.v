(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Theorem 4.2.1 as printed: P and Q are two simple polygons, x is a point off their convolution. Then the winding
   number of the convolution at x is positive if and only if P and -Q + x have a point in common. The thesis has
   closed polygons; for open ones, whose common point is inside both, it holds, too. Both are proved for all regions,
   of any number of chains: the first in theorem_4_2_1.v, the second in fans_that_touch.v. *)
From Coq Require Import List.
From Oplus Require Import numbers convolution convolution_winding regions interiors_meet theorem_4_2_1 fans_that_touch
  polygons_of_the_thesis.
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
