(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The size of the convolution of two valid regions, by numbers of vertices, reflex vertices, components and
   holes; and of regions of any simple chains. That simple chains turn once is in simple_chains_turn_once.v.
   All chains of valid regions are simple, so Lemma 4.1.8 (lemma_4_1_8.v) and Corollary 4.1.9 (corollary_4_1_9.v) hold
   for any two of them; valid regions are in valid_components.v. *)
From Coq Require Import ZArith Lia Bool List.
From Oplus Require Import convolution region_size simple_chain simple_chains_turn_once valid_components.
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

(* Theorem. The convolution of two regions of simple chains, with n_P and n_Q vertices, r_P and r_Q reflex ones, o_P
   and o_Q outer chains and h_P and h_Q holes has n_P (o_Q - h_Q + r_Q) + n_Q (o_P - h_P + r_P) segments. *)
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

Definition number_of_holes (components : list component) : Z :=
  Z.of_nat (length (flat_map hole_chains components)).

Lemma count_constant {A : Type} (test : A -> bool) (b : bool) (l : list A) :
  (forall a, In a l -> test a = b) -> count test l = if b then length l else 0%nat.
Proof.
  unfold count. induction l as [| a l IH]; intros all; [now destruct b |]. cbn [filter].
  specialize (IH (fun c I => all c (or_intror I))). rewrite (all a (or_introl eq_refl)).
  destruct b; cbn [length]; now rewrite IH.
Qed.

Lemma chains_of_valid_regions (components : list component) :
  valid_components components ->
  outer_chains (region_of components) = Z.of_nat (length components) /\
  holes (region_of components) = number_of_holes components.
Proof.
  intros [each _]. unfold outer_chains, holes, number_of_holes, region_of.
  induction components as [| c rest IH]; [now split |].
  destruct IH as [outer_rest holes_rest]; [intros b I; apply each; now right |].
  destruct (each c (or_introl eq_refl)) as (_ & left_turn & holes_valid & _).
  cbn [flat_map length]. rewrite !count_of_two, app_length, !Nat2Z.inj_add, outer_rest, holes_rest.
  unfold chains_of_component.
  change (outer_chain c :: hole_chains c) with ([outer_chain c] ++ hole_chains c).
  rewrite !count_of_two.
  rewrite (count_constant is_counterclockwise false (hole_chains c)) by (intros h I; now apply holes_valid).
  rewrite (count_constant (fun chain => negb (is_counterclockwise chain)) true (hole_chains c))
    by (intros h I; destruct (holes_valid h I) as (_ & clockwise & _); now rewrite clockwise).
  unfold count. cbn [filter]. rewrite left_turn. cbn [negb length]. lia.
Qed.

(* Theorem. The convolution of two valid regions with n_P and n_Q vertices, r_P and r_Q reflex ones, c_P and c_Q
   components and h_P and h_Q holes has n_P (c_Q - h_Q + r_Q) + n_Q (c_P - h_P + r_P) segments. *)
Theorem convolution_size_of_valid_regions (p q : list component) :
  valid_components p -> valid_components q ->
  Z.of_nat (length (segments_of_regions (region_of p) (region_of q))) =
  vertices (region_of p) *
    (Z.of_nat (length q) - number_of_holes q + all_reflex_vertices (region_of q)) +
  vertices (region_of q) *
    (Z.of_nat (length p) - number_of_holes p + all_reflex_vertices (region_of p)).
Proof.
  intros valid_p valid_q.
  destruct (chains_of_valid_regions p valid_p) as [<- <-], (chains_of_valid_regions q valid_q) as [<- <-].
  apply convolution_size_of_simple_regions; intros chain; now apply chains_of_valid_regions_are_simple.
Qed.
