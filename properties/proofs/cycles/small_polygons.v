(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The definitions on polygons small enough to count by hand: what the theorems ask for, these have. *)
From Coq Require Import QArith Lqa ZArith List.
From Oplus Require Import winding tangent_set turning_number total_turn convolution_size.
Import ListNotations.

Open Scope Q_scope.

Definition square : list vector := [Vector 0 0; Vector 2 0; Vector 2 2; Vector 0 2].

(* With a vertex inside a straight line, (1, 0). *)
Definition letter_l : list vector :=
  [Vector 0 0; Vector 1 0; Vector 2 0; Vector 2 1; Vector 1 1; Vector 1 2; Vector 0 2].

Definition square_hole : list vector := rev square.

(* Twice around a square. *)
Definition double : list vector := square ++ square.

Ltac each_corner :=
  let c := fresh "c" in let I := fresh "I" in intros c I; vm_compute in I;
  repeat match goal with H : _ \/ _ |- _ => destruct H as [H | H] end; try contradiction; subst;
  unfold turns, nonzero, cross, dot; cbn; (split; [lra | split; [lra | intros; lra]]).

Example all_turn_everywhere :
  turns_everywhere square /\ turns_everywhere letter_l /\ turns_everywhere square_hole /\
  turns_everywhere double.
Proof. refine (conj _ (conj _ (conj _ _))); each_corner. Qed.

Example turning_numbers_of_small_polygons :
  turning_number square = 1%Z /\ turning_number letter_l = 1%Z /\
  turning_number square_hole = (-1)%Z /\ turning_number double = 2%Z.
Proof. repeat split; vm_compute; reflexivity. Qed.

Example reflex_vertices_of_small_polygons :
  reflex_vertices square = 0%nat /\ reflex_vertices letter_l = 1%nat /\
  reflex_vertices square_hole = 4%nat.
Proof. repeat split; vm_compute; reflexivity. Qed.

(* 7 (1 + 0) + 4 (1 + 1). *)
Example size_of_a_small_convolution : length (convolution letter_l square) = 15%nat.
Proof. vm_compute. reflexivity. Qed.

Example small_winding_numbers :
  winding_number (Vector 1 1) (edges square) = 1%Z /\
  winding_number (Vector 3 1) (edges square) = 0%Z /\
  winding_number (Vector 1 1) (edges square_hole) = (-1)%Z /\
  winding_number (Vector 1 1) (edges double) = 2%Z.
Proof. repeat split; vm_compute; reflexivity. Qed.

(* That points are off the chains is needed: on an edge rays to its two sides differ. *)
Example on_an_edge_rays_differ :
  winding_number_by_ray OfQ (Vector 1 0) (Vector 2 1) (edges square) = 0%Z /\
  winding_number_by_ray OfQ (Vector 0 1) (Vector 2 1) (edges square) = 1%Z.
Proof. split; vm_compute; reflexivity. Qed.
