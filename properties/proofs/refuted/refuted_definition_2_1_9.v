(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* What the thesis says below Definition 2.1.9 is false as printed: signed angles of closed weakly simple chains add
   up to one full turn, in one direction or the other. By Definition 2.1.6 a chain may pass a point twice and cross
   itself there, as this does in (0, 0): its two loops turn in opposite directions, and the sum is zero. Also, the
   text says that the sum is negative for counterclockwise chains; with the formula of the definition it is positive.
   What holds is proved in simple_chains_turn_once.v and total_turn.v: simple chains turn once, counterclockwise ones
   by a positive angle; and in touching_chains.v: so do weakly simple chains that do not cross themselves. Angles are
   measured along a diamond (angle.v), on which a full turn is 4, and not 2 pi. *)
From Coq Require Import QArith Lqa ZArith Lia List.
From Oplus Require Import convolution regions meeting_of_segments pieces total_turn small_polygons simple_polygons
  simple_chain simple_chains_turn_once polygons_of_the_thesis drawn_regions strictly_convex_curve
  chords_around_a_point cut_corners simple_when_cut touching_chains winding_numbers_of_touching_chains.
Import ListNotations.

Open Scope Q_scope.

(* Definition 2.1.6. *)
Definition weakly_simple (chain : list vector) : Prop :=
  edges_are_interior_disjoint chain /\ vertices_touch_from_one_side chain.

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

(* Theorem, Definition 2.1.9 as corrected, for weakly simple chains: that do not cross themselves in vertices, either.
   The angles add up to one full turn, and the sign is that of the direction in which the chain goes round points: it
   goes round each by that turn, or not at all. *)
Theorem definition_2_1_9_for_weakly_simple_chains (chain : list vector) :
  chain <> [] -> turns_everywhere chain -> weakly_simple chain -> vertices_do_not_cross chain ->
  (total_angle (turns_of chain) == 4 \/ total_angle (turns_of chain) == -4) /\
  (forall x, off x (edges chain) -> winding_number x (edges chain) <> 0%Z ->
     total_angle (turns_of chain) == 4 * inject_Z (winding_number x (edges chain))).
Proof.
  intros some turn [disjoint one_side] crossing_free.
  assert (long : (2 <= length chain)%nat).
  { destruct chain as [| a [| b rest]]; [contradiction | exfalso | cbn; lia].
    destruct (turn (corner_of_chain [a] 0) ltac:(now left)) as [long _]. apply long. cbn. split; lra. }
  pose proof (turning_number_counts_turns chain turn) as angle_is. split.
  - destruct (touching_chain_turns_once chain long turn disjoint one_side crossing_free) as [number | number];
      rewrite number in angle_is; [left | right]; exact angle_is.
  - intros x free goes_round. rewrite angle_is.
    destruct (touching_chain_goes_round_once chain x long turn disjoint one_side crossing_free free) as [none | ->];
      [contradiction | reflexivity].
Qed.

(* Two triangles that touch in (1, 1), as one chain that passes that point twice. *)
Definition two_triangles : list vector := points_at [(0, 0); (1, 1); (2, 0); (2, 2); (1, 1); (0, 2)].

Ltac known_vertices :=
  repeat match goal with
  | H : context [edge_at two_triangles ?i] |- _ =>
      let v := eval vm_compute in (edge_at two_triangles i) in change (edge_at two_triangles i) with v in H
  | H : context [vertex two_triangles ?i] |- _ =>
      let v := eval vm_compute in (vertex two_triangles i) in change (vertex two_triangles i) with v in H
  end; cbn [source target vx vy] in *.

Example two_triangles_turn_once : total_angle (turns_of two_triangles) == 4.
Proof.
  assert (turn : turns_everywhere two_triangles).
  { intros c I. vm_compute in I.
    repeat match type of I with _ \/ _ => destruct I as [I | I] end; try contradiction; subst c;
      (split; [| split]; [intros [X Y]; vm_compute in X, Y; discriminate .. |]);
      intros parallel; vm_compute in parallel |- *; congruence. }
  destruct (definition_2_1_9_for_weakly_simple_chains two_triangles ltac:(discriminate) turn) as [_ by_points].
  - split.
    + intros i j [a b] I J differ [(k & range & X & Y) (l & range' & X' & Y')].
      cbn in I, J. each_index i; each_index j; known_vertices; lra.
    + intros i j I J (k & range & X & Y). exfalso. cbn in I, J. each_index i; each_index j; known_vertices; lra.
  - intros i j I J differ [X Y]. cbn in I, J.
    each_index i; each_index j; known_vertices; try (exfalso; lra); (split; [intros _ | intros flat]);
      unfold inside_angle; vm_compute in *; (split; intros [? ?]; discriminate) || discriminate || reflexivity.
  - rewrite (by_points (Vector (1 # 2) 1)); [vm_compute; reflexivity | | vm_compute; discriminate].
    apply off_by_computation. vm_compute. reflexivity.
Qed.
