(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Lemma 4.1.5 as printed: the convolution graph decomposes into directed cycles that share no edge. Its nodes are
   points; a cycle passes no node twice. It is proved in convolution_graph.v, with closed walks of which no two have a
   node in common, Euler circuits. *)
From Coq Require Import List Permutation.
From Oplus Require Import convolution regions balanced_graph convolution_graph.
Import ListNotations.

(* Theorem, Lemma 4.1.5. *)
Theorem lemma_4_1_5_as_printed (p q : region) :
  no_edges_are_points p -> no_edges_are_points q ->
  exists cycles,
    Forall (simple_cycle starts_at_node ends_at_node) cycles /\ Permutation (concat cycles) (segments_of_regions p q).
Proof. exact (edge_disjoint_cycles p q). Qed.
