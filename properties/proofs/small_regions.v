(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Regions with holes that the test of validity_test.v accepts, and some that it refuses: what the theorems on
   valid regions ask for, these have. *)
From Coq Require Import QArith ZArith Bool List.
From Oplus Require Import direction winding_number turning_number convolution_size in_out_degree
  region_size small_polygons simple_chain simple_chains_turn_once size_of_simple_regions simple_polygons
  valid_components validity_test.
Import ListNotations.

Open Scope Q_scope.

Definition box (x y width height : Q) : list vector :=
  at_ [(x, y); (x + width, y); (x + width, y + height); (x, y + height)].

(* Two holes, one not convex, and in the other an island with a hole of its own. *)
Definition plate : component :=
  Component (box 0 0 20 10) [rev (box 1 1 8 8); rev (at_ [(11, 1); (19, 1); (19, 9); (15, 3)])].
Definition island : component := Component (box 2 2 6 6) [rev (box 4 4 2 2)].

Example they_are_valid : is_valid [plate; island] = true.
Proof. vm_compute. reflexivity. Qed.

Example winding_numbers_of_the_plate :
  map (fun p => winding_number p (edges_of_region [plate; island]))
    (at_ [(-1, 5); (1 # 2, 5); (3 # 2, 5); (3, 5); (5, 5); (10, 5); (18, 5); (30, 5)]) =
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
  [[Component square [rev (box 5 5 1 1)]];
   [Component square [rev (box 1 1 5 (1 # 2))]];
   [Component (box 0 0 4 4) [box 1 1 1 1]];
   [Component (box 0 0 9 9) [rev (box 1 1 7 7); rev (box 2 2 1 1)]];
   [Component (box 0 0 9 9) []; Component (box 1 1 1 1) []];
   [Component (box 0 0 9 9) []; Component (box 5 5 9 9) []]].

Example they_are_refused : existsb is_valid invalid_regions = false.
Proof. vm_compute. reflexivity. Qed.
