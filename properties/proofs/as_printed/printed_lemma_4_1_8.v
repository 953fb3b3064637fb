(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Lemma 4.1.8 as printed, for the fiber grid of two simple polygons (Definition 4.1.7): each row, the states of one
   vertex of Q, has a state that a vertical edge leaves, along Q; each column, the states of one vertex of P, has one
   that a horizontal edge leaves, along P. It is proved in lemma_4_1_8.v, for holes with two instead of one. *)
From Coq Require Import Lia List.
From Oplus Require Import convolution lemma_4_1_8 polygons_of_the_thesis.
Import ListNotations.

Open Scope nat_scope.

Lemma counted_ones_exist (test : nat -> bool) (n : nat) :
  1 <= count test (seq 0 n) -> exists i, i < n /\ test i = true.
Proof.
  unfold count. intros some. destruct (filter test (seq 0 n)) as [| i rest] eqn:found; [inversion some |].
  assert (I : In i (filter test (seq 0 n))) by (rewrite found; now left).
  apply filter_In in I. destruct I as [I yes]. apply in_seq in I. exists i. split; [lia | exact yes].
Qed.

(* Theorem, Lemma 4.1.8. *)
Theorem lemma_4_1_8_as_printed (p q : list vector) :
  simple_polygon p -> simple_polygon q ->
  (forall j, j < length q -> exists i, i < length p /\ is_convolution_segment p q OfQ i j = true) /\
  (forall i, i < length p -> exists j, j < length q /\ is_convolution_segment p q OfP i j = true).
Proof.
  intros [simple_p _] [simple_q _].
  destruct (rows_and_columns_of_simple_chains p q simple_p simple_q) as (columns & rows & _). split.
  - intros j J. apply counted_ones_exist, (rows j J).
  - intros i I. apply counted_ones_exist, (columns i I).
Qed.
