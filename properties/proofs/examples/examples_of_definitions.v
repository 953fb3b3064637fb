(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* What is proved of directions, turning numbers and winding numbers, on directions of squares and of the room. *)
From Coq Require Import QArith Lqa ZArith Lia Bool List.
From Oplus Require Import convolution rotation small_numbers tie_rule tangent_set_returns crossing_of_a_step total_turn
  signed_crossings convolution_winding regions theorem_4_2_1 forward_traversal small_polygons polygons_of_the_thesis
  drawn_regions fans_that_touch.
Import ListNotations.

Open Scope Q_scope.

Definition rightwards : vector := Vector 1 0.
Definition upwards : vector := Vector 0 1.
Definition leftwards : vector := Vector (-1) 0.

Ltac some_direction := intros [X Y]; vm_compute in X, Y; discriminate.

(* Definition 2.1.10. Rotating from the right to the left, one meets up. *)
Example up_is_met_first : exists s t, 0 < s /\ s < t /\ t < 4 /\
  same_direction upwards (turned rightwards s) /\ same_direction leftwards (turned rightwards t).
Proof. apply ccw_is_met_first; [some_direction .. | vm_compute; reflexivity]. Qed.

(* Definition 2.2.7. The directions of two squares with parallel sides: turned a little, none of Q's is one of P's. *)
Example parallel_squares : let directions := map (fun s => Direction rightwards s) [OfP; OfQ] in
  eventually (fun epsilon =>
    (forall a b, In a directions -> In b directions -> of a = OfP -> of b = OfQ ->
       ~ same_direction (nudged epsilon a) (nudged epsilon b)) /\
    (forall d from to, In d directions -> In from directions -> In to directions ->
       ccw d from to = ccw_of_vectors (nudged epsilon d) (nudged epsilon from) (nudged epsilon to))).
Proof. apply tie_rule_is_a_rotation. intros d [<- | [<- | []]]; some_direction. Qed.

(* The lower side of one square is in the tangent set of the other's vertex (2, 0) or (0, 0), as it is of P or of
   Q. *)
Example tie_at_a_corner :
  in_tangent_set (Direction rightwards OfP) (Corner leftwards rightwards) = true /\
  eventually (fun epsilon => exists s t, 0 < s /\ s < t /\ t < 4 /\
    same_direction (nudged epsilon (Direction rightwards OfP)) (turned (nudged epsilon (Direction leftwards OfQ)) s) /\
    same_direction (nudged epsilon (Direction rightwards OfQ)) (turned (nudged epsilon (Direction leftwards OfQ)) t)).
Proof.
  split; [vm_compute; reflexivity |].
  destruct (in_tangent_set_returns (Direction rightwards OfP) (Corner leftwards rightwards)) as (limit & L & returned).
  - some_direction.
  - split; some_direction.
  - exists limit. split; [exact L |]. intros e some little. apply (returned e some little). vm_compute. reflexivity.
Qed.

(* Definition 2.1.9. The room's tangent passes each direction once; the tangent sets of its vertices, of which four
   are reflex, contain each direction five times. *)
Example tangents_of_the_room (d : direction) : proper d ->
  turns_past d room = 1%Z /\ count (in_tangent_set d) (corners room) = 5%nat.
Proof.
  assert (turning : turns_everywhere room).
  { apply (chains_turn_everywhere [room]); [apply simple_polygons_are_regions, drawn_polygons | now left]. }
  intros some. rewrite turns_past_every_direction by assumption. split; [vm_compute; reflexivity |].
  rewrite tangent_sets_cover_once_and_at_reflex_vertices by (trivial; vm_compute; reflexivity).
  vm_compute. reflexivity.
Qed.

(* Definition 4.2.2. Every ray from the middle of the chamber's wall counts one turn of the chains. *)
Example rays_from_the_wall (side : summand) (d : vector) : nonzero d ->
  winding_number_by_ray side d (Vector 1 3) (region_edges chamber) = 1%Z /\
  total_angle (map (seen_from (Vector 1 3)) (region_edges chamber)) == 4.
Proof.
  intros some. assert (free : off (Vector 1 3) (region_edges chamber))
    by (apply off_by_computation; vm_compute; reflexivity).
  rewrite winding_number_by_any_ray, winding_number_counts_turns by (trivial; apply region_cycles).
  split; vm_compute; reflexivity.
Qed.

(* Definition 4.2.3. A step to the right into the square crosses its left side, which leads down: one more. *)
Example a_step_into_the_square :
  signed_crossing_of_step (Vector (-1) 1) (Vector 1 1) (Segment (Vector 0 2) (Vector 0 0)) = 1%Z /\
  exists x, lies_on x (Segment (Vector (-1) 1) (Vector 1 1)) /\ lies_on x (Segment (Vector 0 2) (Vector 0 0)).
Proof.
  assert (crossed : signed_crossing_of_step (Vector (-1) 1) (Vector 1 1) (Segment (Vector 0 2) (Vector 0 0)) = 1%Z)
    by (vm_compute; reflexivity).
  split; [exact crossed |]. apply crossing_in_general_position; [| rewrite crossed; discriminate].
  vm_compute. repeat split; discriminate.
Qed.
