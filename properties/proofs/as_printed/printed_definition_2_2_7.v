(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* What the thesis says beside Definition 2.2.7: whether directions of Q are turned a little, so that they come after
   equal directions of P, or those of P, so that they come after those of Q, the points of the convolution are the
   same; its segments need not be. To turn those of P is to apply the definition with the names P and Q exchanged. And
   what it says below Definition 2.2.8: both definitions give the same points. Without ties, as in Definition 2.2.8, P
   and Q have the same part, so the first follows from the second, which is proved in definition_2_2_8.v. A vertex
   inside a straight line counts as a point of the line. *)
From Coq Require Import List.
From Oplus Require Import numbers convolution theorem_4_2_1 definition_2_2_8 polygons_of_the_thesis fans_that_touch.
Import ListNotations.

Open Scope Q_scope.

(* Theorem, Definition 2.2.8. *)
Theorem definition_2_2_8_as_printed (p q : region) (x : vector) :
  valid_region p -> valid_region q -> in_convolution_by_2_2_7 p q x <-> in_convolution_by_2_2_8 p q x.
Proof.
  intros p_region q_region.
  apply both_definitions_have_the_same_points; intros chain; now apply chains_turn_everywhere.
Qed.

Lemma definition_2_2_8_is_symmetric (p q : region) (x : vector) :
  in_convolution_by_2_2_8 p q x -> in_convolution_by_2_2_8 q p x.
Proof.
  intros (chain_p & chain_q & a & b & d & P & Q_ & D & A & B & X & Y). exists chain_q, chain_p, b, a, d.
  repeat split; trivial; unfold plus in *; cbn [vx vy] in *; lra.
Qed.

(* Theorem, Definition 2.2.7. *)
Theorem definition_2_2_7_as_printed (p q : region) (x : vector) :
  valid_region p -> valid_region q -> in_convolution_by_2_2_7 p q x <-> in_convolution_by_2_2_7 q p x.
Proof.
  intros. rewrite !definition_2_2_8_as_printed by assumption. split; apply definition_2_2_8_is_symmetric.
Qed.
