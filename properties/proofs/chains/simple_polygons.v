(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Polygons with reflex vertices that the test of simple_chain.v accepts, and chains that it refuses: what the
   theorems on simple chains ask for, these have. *)
From Coq Require Import QArith ZArith List.
From Oplus Require Import convolution small_polygons simple_chain simple_chains_turn_once.
Import ListNotations.

Open Scope Q_scope.

Definition points_at (points : list (Q * Q)) : list vector := map (fun p => Vector (fst p) (snd p)) points.

Definition arrow_head := points_at [(0, 0); (2, 1); (0, 2); (1, 1)].
Definition letter_u := points_at [(0, 0); (5, 0); (5, 4); (4, 4); (4, 1); (1, 1); (1, 4); (0, 4)].
Definition letter_t := points_at [(1, 0); (2, 0); (2, 2); (3, 2); (3, 3); (0, 3); (0, 2); (1, 2)].
Definition plus_sign :=
  points_at [(1, 0); (2, 0); (2, 1); (3, 1); (3, 2); (2, 2); (2, 3); (1, 3); (1, 2); (0, 2); (0, 1); (1, 1)].
Definition comb :=
  points_at [(0, 0); (9, 0); (9, 4); (8, 4); (7, 1); (6, 4); (5, 4); (4, 1); (3, 4); (2, 4); (1, 1); (0, 4)].
Definition spiral :=
  points_at [(0, 0); (7, 0); (7, 7); (1, 7); (1, 2); (5, 2); (5, 5); (3, 5); (3, 4); (4, 4); (4, 3); (2, 3); (2, 6);
       (6, 6); (6, 1); (0, 1)].
Definition star := points_at [(0, -5); (1, -1); (5, 0); (1, 1); (0, 5); (-1, 1); (-5, 0); (-1, -1)].
(* With a chain of four reflex vertices. *)
Definition bay := points_at [(0, 0); (10, 0); (6, 1); (5, 2); (9 # 2, 3); (13 # 3, 4); (4, 9)].
Definition zigzag := points_at [(0, 0); (4, 1); (1, 2); (4, 3); (1, 4); (4, 5); (0, 6); (3, 5); (0, 4); (3, 3); (0, 2); (3, 1)].
Definition on_a_grid_of_thirds :=
  points_at [(1 # 3, 0); (2, 1 # 3); (4 # 3, 1); (5 # 3, 2); (2 # 3, 4 # 3); (-1 # 3, 5 # 3); (0, 2 # 3)].
Definition needle := points_at [(0, 0); (1000000, 1); (1000001, 2); (1000000, 2); (1, 2 # 3); (0, 1)].
(* Three of its vertices are inside straight lines, one of them beside the smallest vertex. *)
Definition with_straight_vertices :=
  points_at [(0, 1); (0, 0); (2, 0); (4, 0); (4, 3); (3, 3); (3, 2); (3, 1); (1, 1); (1, 3); (0, 3)].

Definition simple_ones : list (list vector) :=
  [square; letter_l; arrow_head; letter_u; letter_t; plus_sign; comb; spiral; star; bay; zigzag;
   on_a_grid_of_thirds; needle; with_straight_vertices].

Example they_are_simple : forallb is_simple simple_ones = true.
Proof. vm_compute. reflexivity. Qed.

(* So are they backwards, as holes. *)
Example so_are_their_holes : forallb (fun chain => is_simple (rev chain)) simple_ones = true.
Proof. vm_compute. reflexivity. Qed.

Example they_are_counterclockwise :
  forallb is_counterclockwise simple_ones = true /\
  forallb (fun chain => negb (is_counterclockwise (rev chain))) simple_ones = true.
Proof. split; vm_compute; reflexivity. Qed.

(* The theorem says so; here is what the numbers are. *)
Example their_turning_numbers :
  map turning_number simple_ones = map (fun _ => 1%Z) simple_ones /\
  map (fun chain => turning_number (rev chain)) simple_ones = map (fun _ => (-1)%Z) simple_ones.
Proof. split; vm_compute; reflexivity. Qed.

Example their_reflex_vertices :
  map reflex_vertices simple_ones = [0; 1; 1; 2; 2; 4; 3; 6; 4; 4; 5; 2; 1; 2]%nat.
Proof. vm_compute. reflexivity. Qed.

(* Edges that cross, a vertex twice, a vertex inside an edge, an edge that goes back along the one before
   it, edges that overlap, an edge that is a point, two vertices only, and twice around a square. *)
Definition others : list (list vector) :=
  [points_at [(0, 0); (2, 2); (2, 0); (0, 2)];
   points_at [(0, 0); (2, 0); (1, 1); (2, 2); (0, 2); (1, 1)];
   points_at [(0, 0); (4, 0); (4, 2); (2, 0); (0, 2)];
   points_at [(0, 0); (4, 0); (2, 0); (2, 2)];
   points_at [(0, 0); (4, 0); (4, 2); (3, 0); (1, 0); (0, 2)];
   points_at [(0, 0); (2, 0); (2, 0); (0, 2)];
   points_at [(0, 0); (2, 0)];
   double].

Example they_are_not_simple : existsb is_simple others = false.
Proof. vm_compute. reflexivity. Qed.
