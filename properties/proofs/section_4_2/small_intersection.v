(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The count of tangent features on polygons small enough to count by hand: a bar across the two arms of a U. The
   intersection is two rectangles, and what theorem_4_2_14.v asks for is so. *)
From Coq Require Import QArith Lqa ZArith List SetoidList SetoidPermutation.
From Oplus Require Import convolution convolution_winding regions weight tangent_count tangent_features
  replaced_segments theorem_4_2_14.
Import ListNotations.

Open Scope Q_scope.

Definition region_of_letter_u : region :=
  [[Vector 0 0; Vector 5 0; Vector 5 4; Vector 4 4; Vector 4 1; Vector 1 1; Vector 1 4; Vector 0 4]].

(* -Q is the bar from (-1, 2) to (6, 3). *)
Definition bar : region := [[Vector 1 (-2); Vector (-6) (-2); Vector (-6) (-3); Vector 1 (-3)]].

Definition origin : vector := Vector 0 0.

Definition two_rectangles : region :=
  [[Vector 5 2; Vector 5 3; Vector 4 3; Vector 4 2]; [Vector 1 2; Vector 1 3; Vector 0 3; Vector 0 2]].

Ltac same_directions :=
  unfold same_corner, nonzero; cbn; repeat split; try (intros _; lra); try (vm_compute; reflexivity).

Example two_rectangles_bound_the_intersection : bounds_the_intersection two_rectangles origin region_of_letter_u bar.
Proof.
  unfold bounds_the_intersection.
  set (of_r := filter bends _). vm_compute in of_r. set (of_both := filter bends _). vm_compute in of_both.
  subst of_r of_both.
  do 2 (apply permA_skip; [same_directions |]).
  eapply permA_trans; [apply permA_swap |]. do 4 (apply permA_skip; [same_directions |]).
  eapply permA_trans; [apply permA_swap |]. do 2 (apply permA_skip; [same_directions |]). apply permA_nil.
Qed.

Example two_components :
  winding_number origin (original_convolution region_of_letter_u bar) = 2%Z /\ region_size.turning_numbers two_rectangles = 2%Z.
Proof. split; vm_compute; reflexivity. Qed.

(* In the direction to the right: the lower sides of both rectangles, turned by an infinitesimal. *)
Example features_to_the_right :
  let d := Vector 1 0 in
  signed_tangent_vertices (Direction d OfQ) origin region_of_letter_u bar = 0%Z /\
  signed_tangent_vertices (Direction (opposite d) OfP) origin bar region_of_letter_u = 0%Z /\
  tangent_crossings d origin (region_edges region_of_letter_u) (region_edges bar) = 2%Z.
Proof. repeat split; vm_compute; reflexivity. Qed.

(* The bar moved down: it has the corners (4, 1) and (1, 1) of the U, which turn right, inside. They count for the
   convolution, and not for the original one: the intersection is one component. *)
Example reflex_vertices_count :
  let x := Vector 0 (-(3 # 2)) in
  winding_number x (convolution_segments region_of_letter_u bar) = 3%Z /\
  reflex_vertices_inside x region_of_letter_u bar = 2%Z /\ reflex_vertices_inside x bar region_of_letter_u = 0%Z /\
  winding_number x (original_convolution region_of_letter_u bar) = 1%Z.
Proof. repeat split; vm_compute; reflexivity. Qed.
