(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Regions with holes that the tests of test_of_components.v and test_of_regions.v accept, and some that they refuse:
   what the theorems on valid regions ask for, these have. *)
From Coq Require Import QArith ZArith Bool List.
From Oplus Require Import convolution regions small_polygons simple_polygons valid_components test_of_components
  test_of_regions.
Import ListNotations.

Open Scope Q_scope.

Definition rectangle (x y width height : Q) : list vector :=
  points_at [(x, y); (x + width, y); (x + width, y + height); (x, y + height)].

(* Two holes, one not convex, and in the other an island with a hole of its own. *)
Definition plate : component :=
  Component (rectangle 0 0 20 10) [rev (rectangle 1 1 8 8); rev (points_at [(11, 1); (19, 1); (19, 9); (15, 3)])].
Definition island : component := Component (rectangle 2 2 6 6) [rev (rectangle 4 4 2 2)].

Example they_are_valid : are_valid_components [plate; island] = true.
Proof. vm_compute. reflexivity. Qed.

Example winding_numbers_of_the_plate :
  map (fun p => winding_number p (edges_of_components [plate; island]))
    (points_at [(-1, 5); (1 # 2, 5); (3 # 2, 5); (3, 5); (5, 5); (10, 5); (18, 5); (30, 5)]) =
  [0; 1; 0; 1; 0; 1; 0; 0]%Z.
Proof. vm_compute. reflexivity. Qed.

(* 20 vertices, 11 of which are reflex, 2 outer chains, 3 holes; the square's 4 and 1 outer chain:
   20 (1 + 0) + 4 (2 - 3 + 11) = 60. *)
Example size_with_a_plate :
  length (segments_of_regions (region_of [plate; island]) [square]) = 60%nat.
Proof. vm_compute. reflexivity. Qed.

(* A hole outside its outer chain, one that crosses it, one that is counterclockwise, one inside another, a
   component inside another, and two that overlap. *)
Definition invalid_regions : list (list component) :=
  [[Component square [rev (rectangle 5 5 1 1)]];
   [Component square [rev (rectangle 1 1 5 (1 # 2))]];
   [Component (rectangle 0 0 4 4) [rectangle 1 1 1 1]];
   [Component (rectangle 0 0 9 9) [rev (rectangle 1 1 7 7); rev (rectangle 2 2 1 1)]];
   [Component (rectangle 0 0 9 9) []; Component (rectangle 1 1 1 1) []];
   [Component (rectangle 0 0 9 9) []; Component (rectangle 5 5 9 9) []]].

Example they_are_refused : existsb are_valid_components invalid_regions = false.
Proof. vm_compute. reflexivity. Qed.

(* A square with a hole, and one with a hole that touches its side in a vertex. *)
Definition square_with_hole : region :=
  [[Vector 0 0; Vector 6 0; Vector 6 6; Vector 0 6]; [Vector 2 2; Vector 2 4; Vector 4 4; Vector 4 2]].
Definition square_with_touching_hole : region :=
  [[Vector 0 0; Vector 6 0; Vector 6 6; Vector 0 6; Vector 0 3]; [Vector 0 3; Vector 3 4; Vector 3 2]].

(* The letter L has a vertex inside a straight line and a reflex one. *)
Example small_regions_are_valid :
  is_valid_region [square] = true /\ is_valid_region [letter_l] = true /\ is_valid_region square_with_hole = true /\
  is_valid_region square_with_touching_hole = true /\
  does_not_touch [square] = true /\ does_not_touch [letter_l] = true /\ does_not_touch square_with_hole = true.
Proof. repeat split; vm_compute; reflexivity. Qed.

(* A chain that is clockwise, one that is there twice, and one that crosses itself are not;
   nor is a hole that touches the inside of an edge. *)
Example other_regions_are_not :
  is_valid_region [square_hole] = false /\ is_valid_region [square; square] = false /\
  is_valid_region [[Vector 0 0; Vector 2 2; Vector 2 0; Vector 0 2]] = false /\
  is_valid_region [[Vector 0 0; Vector 6 0; Vector 6 6; Vector 0 6]; [Vector 0 3; Vector 3 4; Vector 3 2]] = false /\
  does_not_touch square_with_touching_hole = false.
Proof. repeat split; vm_compute; reflexivity. Qed.
