(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Corollary 4.1.9, as it is corrected, with no hypothesis on turning numbers: for all simple chains,
   counterclockwise or clockwise. Cycles of chains that turn once are in sizes_of_cycles.v and
   crossing_cycles.v, that simple chains turn once in simple_chains_turn_once.v. *)
From Coq Require Import Lia Bool List Permutation.
From Oplus Require Import convolution tracing convolution_cycles crossing_cycles rows_and_columns sizes_of_cycles
  simple_chain simple_chains_turn_once lemma_4_1_8.
Import ListNotations.

Open Scope nat_scope.

Lemma simple_chain_not_empty chain : simple chain -> chain <> [].
Proof. intros (N & _) ->. cbn in N. lia. Qed.

Lemma simple_chain_has_edges chain : simple chain -> no_edge_is_a_point chain.
Proof. now intros (_ & e & _). Qed.

(* Theorem. The cycles of two simple chains of n and m vertices are traced to their ends and are the convolution. Each
   takes a n edges of P and b m edges of Q, for whole numbers a and b that are not both zero, and nothing else; one
   cycle goes round both chains, so it has n + m segments or more, and so has the convolution. *)
Theorem cycles_of_simple_chains (p q : list vector) :
  simple p -> simple q ->
  exists cycles,
    trace_cycles (length p) (length q) (in_convolution p q) = Some cycles /\
    Permutation (concat cycles) (convolution p q) /\
    (forall cycle, In cycle cycles ->
       exists a b, length cycle = a * length p + b * length q /\
                   steps_of_p (map fst cycle) = a * length p /\
                   steps_of_q (map fst cycle) = b * length q /\ (a <> 0 \/ b <> 0)) /\
    (exists cycle, In cycle cycles /\
       length p <= steps_of_p (map fst cycle) /\ length q <= steps_of_q (map fst cycle)) /\
    length p + length q <= length (convolution p q).
Proof.
  intros simple_p simple_q.
  pose proof (simple_chain_turns_everywhere p simple_p) as turns_p.
  pose proof (simple_chain_turns_everywhere q simple_q) as turns_q.
  pose proof (simple_chain_not_empty p simple_p) as some_p.
  pose proof (simple_chain_not_empty q simple_q) as some_q.
  pose proof (simple_chain_has_edges p simple_p) as edges_p.
  pose proof (simple_chain_has_edges q simple_q) as edges_q.
  pose proof (simple_chain_is_outer_or_hole q simple_q) as once_q.
  destruct (cycles_cover_the_convolution p q edges_p edges_q some_p some_q)
    as (cycles & traced & all_cycles & together).
  exists cycles. split; [exact traced |]. split; [exact together |]. split; [| split].
  - intros cycle I.
    destruct (traced_cycles_cross_the_grid p q cycles cycle edges_p edges_q some_p some_q traced I)
      as [_ (a & b & steps_p & steps_q & size)].
    exists a, b. repeat split; trivial.
    rewrite Forall_forall in all_cycles. destruct (all_cycles cycle I) as [not_empty _].
    destruct a; [right | now left]. destruct b; [| discriminate].
    destruct cycle; [contradiction | discriminate size].
  - now apply some_cycle_goes_round_both.
  - destruct (some_cycle_is_long p q cycles turns_p turns_q some_p some_q once_q traced) as (cycle & _ & long).
    lia.
Qed.

(* Theorem. Two simple chains without reflex vertices have one cycle, of n + m segments. *)
Theorem one_cycle_of_convex_chains (p q : list vector) :
  simple p -> simple q -> reflex_vertices p = 0 -> reflex_vertices q = 0 ->
  exists cycle,
    trace_cycles (length p) (length q) (in_convolution p q) = Some [cycle] /\
    length cycle = length p + length q.
Proof.
  intros simple_p simple_q convex_p convex_q.
  assert (once : forall chain, simple chain -> reflex_vertices chain = 0 -> outer chain).
  { intros chain chain_simple convex. destruct (simple_chain_is_outer_or_hole chain chain_simple)
      as [is_outer | is_hole]; [exact is_outer |].
    pose proof (three_reflex_vertices chain (simple_chain_turns_everywhere chain chain_simple) is_hole). lia. }
  destruct (cycles_of_simple_chains p q simple_p simple_q) as (cycles & traced & _).
  destruct (convex_chains_have_one_cycle p q cycles) as (cycle & -> & size); trivial;
    try (now apply simple_chain_turns_everywhere); try (now apply simple_chain_not_empty);
    try (now apply once).
  now exists cycle.
Qed.
