(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Theorem 4.1.6 is false as printed: Algorithm 2 need not return to the state where it starts. As printed, segments
   count as visited if an earlier activation took them, and none is marked while a cycle is traced. Then, in the first
   activation, for a triangle and a quadrangle one of whose vertices has all directions of the triangle in its tangent
   set, the algorithm goes round the triangle at that vertex for ever. What holds is proved in algorithm_2.v: with
   segments marked as soon as they are taken, it returns. *)
From Coq Require Import Lia List.
From Oplus Require Import convolution tracing algorithm_2 algorithm_2_goes_round simple_chain small_polygons
  polygons_of_the_thesis.
Import ListNotations.

Open Scope nat_scope.

(* The first activation, before which nothing was visited, from a state that a convolution segment leaves, returns
   after some number of steps. *)
Definition theorem_4_1_6_as_printed : Prop :=
  forall (p q : list vector) (start : state),
    simple_polygon p -> simple_polygon q -> in_grid (length p) (length q) start ->
    (exists along_, In (along_, start) (convolution p q)) ->
    exists steps cycle,
      algorithm_2_as_printed (length p) (length q) (in_convolution p q) steps start [] start = Some cycle.

(* Theorem. *)
Theorem theorem_4_1_6_is_false_as_printed : ~ theorem_4_1_6_as_printed.
Proof.
  intros printed. destruct algorithm_2_as_printed_need_not_end as [_ never].
  destruct (printed triangle quadrangle (0, 0)) as (steps & cycle & returned).
  - split; [apply is_simple_decides |]; vm_compute; reflexivity.
  - split; [apply is_simple_decides |]; vm_compute; reflexivity.
  - split; cbn; lia.
  - exists OfP. vm_compute. tauto.
  - cbn [length triangle quadrangle] in returned. rewrite never in returned. discriminate returned.
Qed.

(* Theorem 4.1.6 as corrected. `visited` are the segments of earlier cycles; the cycle that is traced is a closed walk
   of convolution segments of which none was visited and none is there twice, and with them visited the next
   activation can start. *)
Theorem theorem_4_1_6_as_corrected (p q : list vector) (visited : list named_segment) (start : state) :
  no_edge_is_a_point p -> no_edge_is_a_point q ->
  NoDup visited -> incl visited (convolution p q) -> balanced (length p) (length q) (fun s => is_in s visited) ->
  in_grid (length p) (length q) start ->
  (exists along_, In (along_, start) (convolution p q) /\ ~ In (along_, start) visited) ->
  exists cycle,
    algorithm_2 (length p) (length q) (in_convolution p q) (2 * length p * length q) start visited start = Some cycle /\
    cycle <> [] /\ is_walk (length p) (length q) start cycle start /\
    NoDup (rev cycle ++ visited) /\ incl (rev cycle ++ visited) (convolution p q) /\
    balanced (length p) (length q) (fun s => is_in s (rev cycle ++ visited)).
Proof.
  intros p_edges q_edges distinct_ within_ even [I J]. now apply algorithm_2_traces_convolution_cycles.
Qed.

(* Theorem, the else branch. Whatever segment Algorithm 2 takes, along Q without a test or along P after one, is in the
   convolution and not visited before. *)
Theorem else_branch_is_right (p q : list vector) (visited : list named_segment) (start : state) (steps : nat)
    (front back : list named_segment) (s : named_segment) :
  no_edge_is_a_point p -> no_edge_is_a_point q ->
  NoDup visited -> incl visited (convolution p q) -> balanced (length p) (length q) (fun s => is_in s visited) ->
  in_grid (length p) (length q) start ->
  (exists along_, In (along_, start) (convolution p q) /\ ~ In (along_, start) visited) ->
  algorithm_2 (length p) (length q) (in_convolution p q) (2 * length p * length q) start visited start =
    Some (front ++ s :: back) ->
  In s (convolution p q) /\ ~ In s (rev front ++ visited).
Proof.
  intros p_edges q_edges distinct_ within_ even inside_ some found.
  destruct (theorem_4_1_6_as_corrected p q visited start p_edges q_edges distinct_ within_ even inside_ some)
    as (cycle & returned & _ & _ & distinct' & within' & _).
  rewrite found in returned. injection returned as <-.
  rewrite rev_app_distr in distinct', within'. cbn [rev] in distinct', within'.
  rewrite <- !app_assoc in distinct', within'.
  split; [apply within', in_app_iff; right; now left |].
  apply NoDup_remove_2 in distinct'. intros I. now apply distinct', in_app_iff; right.
Qed.

(* Theorem. It is right only if an unvisited segment leaves the state where it starts. That the state's point is one of
   the convolution, as the input of Algorithm 2 is said to be, is not enough: for two equal squares (2, 0) is the point
   of two states, a segment leaves the one of them, and from the other the else branch takes one that is none of the
   convolution. *)
Theorem else_branch_needs_a_segment_that_leaves : exists other_state,
  In (OfQ, other_state) (convolution square square) /\
  equal_vectors (point_of (square, square) other_state) (point_of (square, square) (0, 1)) /\
  ~ In (chosen (in_convolution square square) [] (0, 1)) (convolution square square).
Proof.
  exists (1, 0). split; [vm_compute; tauto |]. split; [split; reflexivity |].
  intros I. vm_compute in I. repeat (destruct I as [I | I]; [discriminate I |]). exact I.
Qed.

(* The triangle and the quadrangle again, from the same state. *)
Example marked_at_once :
  exists cycle, algorithm_2 3 4 (in_convolution triangle quadrangle) 24 (0, 0) [] (0, 0) = Some cycle /\ cycle <> [].
Proof.
  destruct (theorem_4_1_6_as_corrected triangle quadrangle [] (0, 0)) as (cycle & returned & some & _).
  - apply (simple_polygons_are_regions triangle); [| now left].
    split; [apply is_simple_decides |]; vm_compute; reflexivity.
  - apply (simple_polygons_are_regions quadrangle); [| now left].
    split; [apply is_simple_decides |]; vm_compute; reflexivity.
  - constructor.
  - intros s [].
  - intros at_ _. reflexivity.
  - split; cbn; lia.
  - exists OfP. split; [vm_compute; tauto | intros []].
  - exists cycle. now split.
Qed.
