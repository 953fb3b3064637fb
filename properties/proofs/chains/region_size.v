(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The number of convolution segments of two regions of several chains. *)
From Coq Require Import ZArith Lia List.
From Oplus Require Import convolution.
Import ListNotations.

Open Scope Z_scope.

Definition vertices (r : region) : Z := sum (map (fun chain => Z.of_nat (length chain)) r).

(* Of outer chains 1 each, of holes -1. *)
Definition turning_numbers (r : region) : Z := sum (map turning_number r).

Definition all_reflex_vertices (r : region) : Z :=
  sum (map (fun chain => Z.of_nat (reflex_vertices chain)) r).

Lemma size_with_one_chain : forall chain q,
  turns_everywhere chain -> (forall other_chain, In other_chain q -> turns_everywhere other_chain) ->
  Z.of_nat (length (flat_map (fun chains => map (pair chains) (convolution (fst chains) (snd chains)))
                      (map (pair chain) q))) =
  Z.of_nat (length chain) * (turning_numbers q + all_reflex_vertices q) +
  vertices q * (turning_number chain + Z.of_nat (reflex_vertices chain)).
Proof.
  intros chain q C Q. unfold turning_numbers, all_reflex_vertices, vertices, sum.
  induction q as [| c rest IH]; [cbn; lia |].
  cbn [map flat_map fold_right fst snd]. rewrite app_length, map_length, Nat2Z.inj_add.
  rewrite IH by (intros; apply Q; now right).
  rewrite (convolution_size_by_turning_numbers chain c C (Q c (or_introl eq_refl))). lia.
Qed.

(* Theorem. The size of the convolution of two regions, each of any number of closed chains, of n_P and
   n_Q vertices, of which r_P and r_Q are reflex, is n_P (x_Q + r_Q) + n_Q (x_P + r_P), where x_P and
   x_Q are the sums of the chains' turning numbers: the number of outer chains less that of holes. *)
Theorem convolution_size_of_regions : forall p q : region,
  (forall chain, In chain p -> turns_everywhere chain) ->
  (forall chain, In chain q -> turns_everywhere chain) ->
  Z.of_nat (length (segments_of_regions p q)) =
  vertices p * (turning_numbers q + all_reflex_vertices q) +
  vertices q * (turning_numbers p + all_reflex_vertices p).
Proof.
  intros p q P Q. unfold segments_of_regions, states.named_segment.
  induction p as [| chain rest IH]; [cbn; lia |].
  change (list_prod (chain :: rest) q) with (map (pair chain) q ++ list_prod rest q).
  rewrite flat_map_app, app_length, Nat2Z.inj_add.
  rewrite size_with_one_chain by (trivial; apply P; now left).
  rewrite IH by (intros; apply P; now right).
  unfold turning_numbers, all_reflex_vertices, vertices, sum. cbn [map fold_right]. lia.
Qed.
