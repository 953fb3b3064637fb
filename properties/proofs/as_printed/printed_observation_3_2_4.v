(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Observation 3.2.4 as printed: e is an edge of the arrangement of the convolution, on the boundary of the sum; then
   the edge that leaves its end with the largest clockwise turn from it is on the boundary of the sum, too. Edges have
   the directions of the convolution's segments of which they are part. The convolution is the full one, the reduced
   one, or anything between (is_convolution). It is proved in arrangement_of_the_convolution.v. *)
From Coq Require Import List.
From Oplus Require Import convolution theorem_4_2_1 algorithm_1 arranged_convolution
  arrangement_of_the_convolution.
Import ListNotations.

(* Theorem, Observation 3.2.4. *)
Theorem observation_3_2_4_as_printed (p q : region) (segments : list segment) (e : segment) :
  valid_region p -> valid_region q -> is_convolution p q segments ->
  In e (arrangement_of segments) -> is_boundary_edge p q e ->
  exists e', best_direction (arrangement_of segments) e = Some e' /\ is_boundary_edge p q e'.
Proof.
  intros p_region q_region convolution_ E boundary.
  apply (boundary_edges_are_kept p q p_region q_region segments convolution_ e E) in boundary.
  destruct (largest_turn_stays_on_the_loops p q p_region q_region segments convolution_ e boundary)
    as (f & best & F & _).
  exists f. split; [exact best |].
  apply (boundary_edges_are_kept p q p_region q_region segments convolution_ f); [| exact F].
  now apply (loops_are_in_the_arrangement p q p_region q_region segments convolution_).
Qed.
