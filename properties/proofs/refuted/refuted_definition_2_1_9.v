(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* What the thesis says below Definition 2.1.9 is false as printed: signed angles of closed weakly simple chains add
   up to one full turn, in one direction or the other. By Definition 2.1.6 a chain may pass a point twice and cross
   itself there, as this does in (0, 0): its two loops turn in opposite directions, and the sum is zero. Also, the
   text says that the sum is negative for counterclockwise chains; with the formula of the definition it is positive.
   What holds is proved in simple_chains_turn_once.v and total_turn.v: simple chains turn once, counterclockwise ones
   by a positive angle. Angles are measured along a diamond (angle.v), on which a full turn is 4, and not 2 pi. *)
From Coq Require Import QArith Lqa Lia List.
From Oplus Require Import convolution regions meeting_of_segments pieces total_turn small_polygons simple_polygons
  simple_chain simple_chains_turn_once polygons_of_the_thesis drawn_regions.
Import ListNotations.

Open Scope Q_scope.

(* Definition 2.1.6. No point is inside two of the edges; and where a vertex is inside an edge, the vertices before
   and after it are on the same side of that edge. *)
Definition weakly_simple (chain : list vector) : Prop :=
  let n := length chain in
  (forall i j x, (i < n)%nat -> (j < n)%nat -> i <> j ->
     ~ (strictly_inside x (edge_at chain i) /\ strictly_inside x (edge_at chain j))) /\
  (forall i j, (i < n)%nat -> (j < n)%nat -> strictly_inside (vertex chain i) (edge_at chain j) ->
     let side k := area (edge_at chain j) (vertex chain k) in
     (0 <= side (previous n i) /\ 0 <= side (next i n)) \/ (side (previous n i) <= 0 /\ side (next i n) <= 0)).

(* Of chains that turn back nowhere, so that the sign of each angle is determined. *)
Definition definition_2_1_9_as_printed : Prop :=
  forall chain, chain <> [] -> turns_everywhere chain -> weakly_simple chain ->
    total_angle (turns_of chain) == 4 \/ total_angle (turns_of chain) == -4.

Definition crossing_loops : list vector := points_at [(-1, -1); (0, 0); (1, 1); (1, -1); (0, 0); (-1, 1)].

(* A number below 6 is one of six; edges and vertices of that number. *)
Ltac each_index i := do 6 (try (destruct i as [| i])); try lia.

Ltac known_edges :=
  repeat match goal with
  | H : context [edge_at crossing_loops ?i] |- _ =>
      let e := eval vm_compute in (edge_at crossing_loops i) in change (edge_at crossing_loops i) with e in H
  | H : context [vertex crossing_loops ?i] |- _ =>
      let v := eval vm_compute in (vertex crossing_loops i) in change (vertex crossing_loops i) with v in H
  end; cbn [source target vx vy] in *.

(* Theorem. *)
Theorem definition_2_1_9_is_false_as_printed : ~ definition_2_1_9_as_printed.
Proof.
  intros printed.
  assert (none : total_angle (turns_of crossing_loops) == 0) by (vm_compute; reflexivity).
  destruct (printed crossing_loops) as [once | once]; [discriminate | | | lra | lra].
  - intros c I. vm_compute in I.
    repeat match type of I with _ \/ _ => destruct I as [I | I] end; try contradiction; subst c;
      (split; [| split]; [intros [X Y]; vm_compute in X, Y; discriminate .. |]);
      intros parallel; vm_compute in parallel |- *; congruence.
  - split.
    + intros i j [a b] I J differ [(k & range & X & Y) (l & range' & X' & Y')].
      cbn in I, J. each_index i; each_index j; known_edges; lra.
    + intros i j I J (k & range & X & Y). exfalso.
      cbn in I, J. each_index i; each_index j; known_edges; lra.
Qed.

(* What the text says of the sign, with the formula's angles, is false of a square. *)
Definition sign_in_the_text : Prop :=
  forall chain, simple_polygon chain -> total_angle (turns_of chain) == -4.

(* Theorem. *)
Theorem sign_in_the_text_is_not_that_of_the_formula : ~ sign_in_the_text.
Proof.
  intros printed. assert (plus_ : total_angle (turns_of square) == 4) by (vm_compute; reflexivity).
  specialize (printed square (proj1 drawn_polygons)). lra.
Qed.

(* Theorem, Definition 2.1.9 as corrected. *)
Theorem definition_2_1_9_as_corrected (chain : list vector) : simple chain ->
  total_angle (turns_of chain) == if is_counterclockwise chain then 4 else -4.
Proof.
  intros chain_simple.
  rewrite (turning_number_counts_turns chain) by now apply simple_chain_turns_everywhere.
  rewrite (simple_chain_turns_once chain chain_simple). now destruct (is_counterclockwise chain).
Qed.

(* The room, and its outline as a hole has it. *)
Example the_room_turns_once : total_angle (turns_of room) == 4 /\ total_angle (turns_of (rev room)) == -4.
Proof.
  split; [apply (definition_2_1_9_as_corrected room) | apply (definition_2_1_9_as_corrected (rev room))];
    apply is_simple_decides; vm_compute; reflexivity.
Qed.
