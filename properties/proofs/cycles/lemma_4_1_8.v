(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Lemma 4.1.8 with no hypothesis on turning numbers: for all simple chains, counterclockwise or, as holes are,
   clockwise. What is counted is in rows_and_columns.v, that simple chains turn once in
   simple_chains_turn_once.v. *)
From Coq Require Import Lia Bool List.
From Oplus Require Import convolution rows_and_columns simple_chain simple_chains_turn_once.
Import ListNotations.

Open Scope nat_scope.

Lemma simple_chain_is_outer_or_hole chain : simple chain -> outer chain \/ hole chain.
Proof.
  intros chain_simple. pose proof (simple_chain_turns_once chain chain_simple) as once.
  unfold outer, hole. destruct (is_counterclockwise chain); [now left | now right].
Qed.

Lemma clockwise_is_hole chain : simple chain -> is_counterclockwise chain = false -> hole chain.
Proof.
  intros chain_simple clockwise. unfold hole.
  now rewrite (simple_chain_turns_once chain chain_simple), clockwise.
Qed.

(* Theorem. Every column of the fiber grid of two simple chains, the states of one vertex of P, is left along P's
   edge from at least one state, from two if Q's chain is clockwise; every row likewise along Q's edge. A
   clockwise chain has three reflex vertices or more. *)
Theorem rows_and_columns_of_simple_chains (p q : list vector) :
  simple p -> simple q ->
  (forall i, i < length p ->
     let times := count (fun j => is_convolution_segment p q OfP i j) (seq 0 (length q)) in
     1 <= times /\ (is_counterclockwise q = false -> 2 <= times)) /\
  (forall j, j < length q ->
     let times := count (fun i => is_convolution_segment p q OfQ i j) (seq 0 (length p)) in
     1 <= times /\ (is_counterclockwise p = false -> 2 <= times)) /\
  (is_counterclockwise p = false -> 3 <= reflex_vertices p).
Proof.
  intros simple_p simple_q.
  pose proof (simple_chain_turns_everywhere p simple_p) as turns_p.
  pose proof (simple_chain_turns_everywhere q simple_q) as turns_q.
  destruct (rows_and_columns_are_left p q turns_p turns_q
              (simple_chain_is_outer_or_hole p simple_p) (simple_chain_is_outer_or_hole q simple_q))
    as [columns rows].
  split; [| split].
  - intros i I. destruct (columns i I) as [once twice]. split; [exact once |].
    intros clockwise. now apply twice, clockwise_is_hole.
  - intros j J. destruct (rows j J) as [once twice]. split; [exact once |].
    intros clockwise. now apply twice, clockwise_is_hole.
  - intros clockwise. apply three_reflex_vertices; [exact turns_p | now apply clockwise_is_hole].
Qed.
