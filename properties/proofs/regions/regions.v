(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The edges and vertices of a region, any number of closed chains (in_out_degree.v), its points, and the
   points of the sum of two regions; and the edges of a chain by their indices. *)
From Coq Require Import ZArith Lia Bool List Arith.
From Oplus Require Import numbers convolution.
Import ListNotations.

Open Scope nat_scope.

Definition region_edges (r : region) : list segment := flat_map edges r.

(* Each vertex with the edges before and after it. *)
Definition region_vertices (r : region) : list (vector * corner) :=
  flat_map (fun chain => combine chain (corners chain)) r.

(* Points inside a region, those on its boundary included. *)
Definition in_region (x : vector) (r : region) : Prop :=
  (0 < winding_number x (region_edges r))%Z \/ exists s, In s (region_edges r) /\ lies_on x s.

(* The Minkowski sum as a set of points. *)
Definition in_sum (x : vector) (p q : region) : Prop :=
  exists a b, in_region a p /\ in_region b q /\ equal_vectors x (plus a b).

Definition no_edges_are_points (r : region) : Prop := forall chain, In chain r -> no_edge_is_a_point chain.

(* Valid regions have winding numbers 0 and 1 off their boundary, and chains that go round several times
   counterclockwise are allowed, too. *)
Definition nowhere_negative (r : region) : Prop :=
  forall x, off x (region_edges r) -> (0 <= winding_number x (region_edges r))%Z.

Lemma region_cycles (r : region) : cycles (region_edges r).
Proof.
  induction r as [| chain r IH]; [apply (closed_chain_cycles []) |].
  cbn [region_edges flat_map]. apply cycles_together; [apply closed_chain_cycles | exact IH].
Qed.

Lemma edges_are_as_many (chain : list vector) : length (edges chain) = length chain.
Proof. rewrite <- (map_length source (edges chain)). now destruct (edges_ends chain) as [-> _]. Qed.

Lemma ends_of_edges (chain : list vector) (s : segment) : In s (edges chain) ->
  In (source s) chain /\ In (target s) chain.
Proof.
  intros I. destruct (edges_ends chain) as [sources targets].
  assert (J : In (target s) (rotated chain)) by (rewrite <- targets; now apply in_map).
  split; [rewrite <- sources; now apply in_map |]. destruct chain as [| v rest]; [destruct J |].
  cbn [rotated] in J. apply in_app_iff in J. destruct J as [J | [<- | []]]; [now right | now left].
Qed.

Lemma edge_from_vertex (chain : list vector) (v : vector) : In v chain -> exists s, In s (edges chain) /\ source s = v.
Proof.
  intros I. destruct (edges_ends chain) as [sources _]. rewrite <- sources in I. apply in_map_iff in I.
  destruct I as (s & equal & I). now exists s.
Qed.

Lemma nth_rotated A (l : list A) default i :
  i < length l -> nth i (rotated l) default = nth (next i (length l)) l default.
Proof.
  destruct l as [| first rest]; intros below; cbn [length] in *; [lia |]. unfold next. cbn [rotated].
  destruct (Nat.eqb_spec (S i) (S (length rest))) as [last_ | not_last].
  - rewrite app_nth2 by lia. now replace (i - length rest) with 0 by lia.
  - now rewrite app_nth1 by lia.
Qed.

Definition no_segment : segment := Segment nowhere nowhere.

(* Edge i leads from vertex i to the next. *)
Lemma edge_by_index (chain : list vector) i :
  i < length chain ->
  nth i (edges chain) no_segment =
  Segment (nth i chain nowhere) (nth (next i (length chain)) chain nowhere).
Proof.
  intros below. unfold edges.
  set (segment_of := fun ends : vector * vector => Segment (fst ends) (snd ends)).
  change no_segment with (segment_of (nowhere, nowhere)).
  rewrite map_nth, combine_nth.
  - unfold segment_of. cbn [fst snd]. now rewrite nth_rotated.
  - destruct chain; [reflexivity |]. cbn. rewrite app_length. cbn. lia.
Qed.

Definition edge_at (chain : list vector) (i : nat) : segment := nth i (edges chain) no_segment.

Lemma edge_at_is (chain : list vector) i :
  i < length chain ->
  edge_at chain i = Segment (nth i chain nowhere) (nth (next i (length chain)) chain nowhere).
Proof. apply edge_by_index. Qed.

(* An edge by its chain and index. *)
Lemma edge_by_chain (r : region) (s : segment) : In s (region_edges r) ->
  exists chain i, In chain r /\ (i < length chain)%nat /\ s = edge_at chain i.
Proof.
  intros I. apply in_flat_map in I. destruct I as (chain & J & I).
  apply (In_nth (edges chain) s no_segment) in I. destruct I as (i & below & is_s).
  rewrite edges_are_as_many in below. exists chain, i. split; [exact J |]. split; [exact below | now symmetry].
Qed.

Lemma edge_at_in_region (r : region) (chain : list vector) i :
  In chain r -> (i < length chain)%nat -> In (edge_at chain i) (region_edges r).
Proof.
  intros J I. apply in_flat_map. exists chain. split; [exact J |]. apply nth_In. now rewrite edges_are_as_many.
Qed.

Lemma direction_by_index (chain : list vector) i :
  i < length chain -> edge_of_chain chain i = along (nth i (edges chain) no_segment).
Proof.
  intros below. unfold edge_of_chain, edge_directions.
  rewrite nth_indep with (d' := along no_segment) by (rewrite map_length, edges_are_as_many; exact below).
  exact (map_nth along (edges chain) no_segment i).
Qed.

Lemma edge_of_chain_is (chain : list vector) i :
  i < length chain -> edge_of_chain chain i = minus (nth (next i (length chain)) chain nowhere) (nth i chain nowhere).
Proof. intros below. now rewrite direction_by_index, edge_by_index. Qed.

Lemma vertex_is_on_the_boundary (v : vector) (c : corner) (r : region) :
  In (v, c) (region_vertices r) -> exists s, In s (region_edges r) /\ lies_on v s.
Proof.
  intros I. apply in_flat_map in I. destruct I as (chain & J & I). apply in_combine_l, edge_from_vertex in I.
  destruct I as (s & I & <-). exists s. split.
  - apply in_flat_map. now exists chain.
  - exists 0%Q. repeat split; cbn; lra.
Qed.

(* A vertex's two edges. *)
Lemma edges_of_vertex (v : vector) (c : corner) (r : region) :
  In (v, c) (region_vertices r) ->
  (exists s, In s (region_edges r) /\ target s = v /\ along s = incoming c) /\
  (exists s, In s (region_edges r) /\ source s = v /\ along s = outgoing c).
Proof.
  intros I. apply in_flat_map in I. destruct I as (chain & J & I).
  apply (In_nth _ _ (nowhere, Corner nowhere nowhere)) in I. destruct I as (i & below & at_i).
  rewrite combine_length, corners_length in below. assert (range : (i < length chain)%nat) by lia.
  rewrite combine_nth in at_i by (symmetry; apply corners_length).
  injection at_i as v_is c_is. change (corner_of_chain chain i = c) in c_is. rewrite corner_is in c_is by exact range.
  subst c. cbn [incoming outgoing].
  pose proof (previous_below _ _ range) as range'.
  split.
  - exists (nth (previous (length chain) i) (edges chain) no_segment). split; [now apply edge_at_in_region |].
    rewrite direction_by_index by exact range'. split; [| reflexivity].
    rewrite edge_by_index by exact range'. cbn [target]. now rewrite next_previous.
  - exists (nth i (edges chain) no_segment). split; [now apply edge_at_in_region |].
    rewrite direction_by_index by exact range. split; [| reflexivity].
    rewrite edge_by_index by exact range. exact v_is.
Qed.
