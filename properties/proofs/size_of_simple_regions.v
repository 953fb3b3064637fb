(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The size of the convolution of two regions whose chains are simple, by numbers of vertices, reflex vertices
   and chains only, with no hypothesis on turning numbers. The size by turning numbers is in region_size.v,
   that simple chains turn once in simple_chains_turn_once.v. *)
From Coq Require Import ZArith Lia Bool List.
From Oplus Require Import direction sweep turning_number convolution_size in_out_degree region_size
  simple_chain simple_chains_turn_once.
Import ListNotations.

Open Scope Z_scope.

(* Outer chains less holes. *)
Definition outer_chains (r : region) : Z := Z.of_nat (count is_counterclockwise r).
Definition holes (r : region) : Z := Z.of_nat (count (fun chain => negb (is_counterclockwise chain)) r).

Lemma turning_numbers_of_simple_chains (r : region) :
  (forall chain, In chain r -> simple chain) -> turning_numbers r = outer_chains r - holes r.
Proof.
  intros all_simple. unfold turning_numbers, outer_chains, holes, sum, count.
  induction r as [| chain r IH]; [reflexivity |]. cbn [map fold_right filter].
  rewrite IH by (intros; apply all_simple; now right).
  rewrite (simple_chain_turns_once chain (all_simple chain (or_introl eq_refl))).
  destruct (is_counterclockwise chain); cbn [negb length]; lia.
Qed.

(* Theorem. The convolution of two regions of simple chains, with n_P and n_Q vertices, r_P and r_Q reflex ones,
   o_P and o_Q outer chains and h_P and h_Q holes has n_P (o_Q - h_Q + r_Q) + n_Q (o_P - h_P + r_P)
   segments. *)
Theorem convolution_size_of_simple_regions (p q : region) :
  (forall chain, In chain p -> simple chain) -> (forall chain, In chain q -> simple chain) ->
  Z.of_nat (length (segments_of_regions p q)) =
  vertices p * (outer_chains q - holes q + all_reflex_vertices q) +
  vertices q * (outer_chains p - holes p + all_reflex_vertices p).
Proof.
  intros simple_p simple_q.
  rewrite <- !turning_numbers_of_simple_chains by assumption.
  apply convolution_size_of_regions; intros chain I; apply simple_chain_turns_everywhere; auto.
Qed.

(* For two counterclockwise chains. *)
Corollary convolution_size_of_simple_polygons (p q : list vector) :
  simple p -> simple q -> is_counterclockwise p = true -> is_counterclockwise q = true ->
  length (convolution p q) =
  (length p * (1 + reflex_vertices q) + length q * (1 + reflex_vertices p))%nat.
Proof.
  intros simple_p simple_q left_p left_q.
  apply convolution_size; try (now apply simple_chain_turns_everywhere).
  - now rewrite (simple_chain_turns_once p simple_p), left_p.
  - now rewrite (simple_chain_turns_once q simple_q), left_q.
Qed.
