(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* A test by signs and winding numbers that accepts valid regions whose chains do not touch, and no region that is
   not valid (valid_components.v). Of a chain that does not meet other segments it looks at one vertex only: around
   all its points they go as often. *)
From Coq Require Import ZArith Lia Bool List.
From Oplus Require Import numbers convolution regions secants segments_apart simple_chain simple_chains_turn_once
  valid_components winding_numbers_of_valid_regions meeting_of_segments first_hit interiors_meet.
Import ListNotations.

Open Scope nat_scope.

(* Whether segments have no point in common with others (first_hit.v). *)
Definition all_apart (some others : list segment) : bool :=
  forallb (fun s => forallb (fun o => are_apart (source s) (target s) (source o) (target o)) others) some.

Lemma all_apart_sound some others : all_apart some others = true -> have_no_common_point some others.
Proof.
  unfold all_apart. rewrite forallb_forall. intros each s o z S O on_s on_o.
  specialize (each s S). rewrite forallb_forall in each. specialize (each o O).
  apply are_apart_sound in each. destruct s as [a b], o as [c e]. cbn [source target] in each.
  revert on_o. now apply (apart_have_no_common_point a b c e z).
Qed.

(* Around all points of a chain other segments that it does not meet go as often as around its first vertex. *)
Lemma around_all_of_a_chain (chain : list vector) (others : list segment) (p : vector) :
  cycles others -> have_no_common_point (edges chain) others -> on_one_of p (edges chain) ->
  off p others /\ winding_number p others = winding_number (vertex chain 0) others.
Proof.
  intros closed none (s & S & on_s). split; [intros o O on_o; exact (none s o p S O on_s on_o) |].
  rewrite (same_up_to_the_end _ _ s p closed none S on_s).
  apply (In_nth _ _ no_segment) in S. destruct S as (i & I & <-). rewrite edges_are_as_many in I.
  rewrite edge_by_index by exact I. apply same_at_all_vertices; trivial. now apply next_in_range.
Qed.

(* The first vertex of each chain is outside. *)
Definition all_outside (chains : list (list vector)) (others : list segment) : bool :=
  forallb (fun chain => (winding_number (vertex chain 0) others =? 0)%Z) chains.

Definition are_outside_each_other (some others : list (list vector)) : bool :=
  all_apart (flat_map edges some) (flat_map edges others) &&
  all_outside some (flat_map edges others) && all_outside others (flat_map edges some).

Lemma all_outside_sound chains others p :
  cycles others -> have_no_common_point (flat_map edges chains) others -> all_outside chains others = true ->
  on_one_of p (flat_map edges chains) -> is_outside p others.
Proof.
  unfold all_outside. rewrite forallb_forall. intros closed none each (s & S & on_s).
  apply in_flat_map in S. destruct S as (chain & C & S). specialize (each chain C). cbv beta in each.
  apply Z.eqb_eq in each.
  destruct (around_all_of_a_chain chain others p closed) as [p_off same].
  - intros e o z E O. apply (none e o z); [apply in_flat_map; now exists chain | exact O].
  - now exists s.
  - split; [exact p_off | now rewrite same].
Qed.

Lemma never_meet some others : have_no_common_point some others -> meet_in_ends_only some others.
Proof. intros none p (s & S & on_s) (o & O & on_o). exfalso. now apply (none s o p). Qed.

Lemma are_beside_sound some others :
  are_outside_each_other some others = true -> beside_each_other (flat_map edges some) (flat_map edges others).
Proof.
  unfold are_outside_each_other. rewrite !andb_true_iff. intros [[none some_outside] others_outside].
  apply all_apart_sound in none. split; [now apply never_meet | split].
  - intros p on_some _. apply (all_outside_sound some); trivial. apply region_cycles.
  - intros p on_others _. apply (all_outside_sound others); trivial; [apply region_cycles |].
    now apply no_common_point_swapped.
Qed.

Definition is_hole_of (hole outer : list vector) : bool :=
  is_simple hole && negb (is_counterclockwise hole) && all_apart (edges hole) (edges outer) &&
  negb (winding_number (vertex hole 0) (edges outer) =? 0)%Z &&
  (winding_number (vertex outer 0) (edges hole) =? 0)%Z.

(* The test of a region. *)
Definition is_valid_component (c : component) : bool :=
  is_simple (outer_chain c) && is_counterclockwise (outer_chain c) &&
  forallb (fun hole => is_hole_of hole (outer_chain c)) (hole_chains c) &&
  all_pairs (fun g h => are_outside_each_other [g] [h]) (hole_chains c).

Definition are_valid_components (components : list component) : bool :=
  forallb is_valid_component components &&
  all_pairs (fun b c => are_outside_each_other (chains_of_component b) (chains_of_component c)) components.

Lemma is_hole_of_sound hole outer : is_hole_of hole outer = true ->
  simple hole /\ is_counterclockwise hole = false /\ is_inside (edges hole) (edges outer).
Proof.
  unfold is_hole_of. rewrite !andb_true_iff, !negb_true_iff, Z.eqb_neq, Z.eqb_eq.
  intros [[[[hole_simple clockwise] none] inside] outside].
  apply is_simple_decides in hole_simple. apply all_apart_sound in none.
  split; [exact hole_simple | split; [exact clockwise |]].
  split; [now apply never_meet | split].
  - intros p on_hole _ [_ none_there].
    destruct (around_all_of_a_chain hole (edges outer) p (closed_chain_cycles outer) none on_hole) as [_ same].
    apply inside. now rewrite <- same.
  - intros p on_outer _.
    destruct (around_all_of_a_chain outer (edges hole) p (closed_chain_cycles hole)
                (no_common_point_swapped _ _ none) on_outer) as [p_off same].
    split; [exact p_off | now rewrite same].
Qed.

(* Theorem. What the test accepts is valid. *)
Theorem are_valid_components_sound (components : list component) : are_valid_components components = true -> valid_components components.
Proof.
  unfold are_valid_components. rewrite andb_true_iff, forallb_forall. intros [each beside]. split.
  - intros c I. specialize (each c I). unfold is_valid_component in each.
    rewrite !andb_true_iff, forallb_forall in each. destruct each as [[[outer_simple left_turn] holes] apart_holes].
    split; [now apply is_simple_decides | split; [exact left_turn | split]].
    + intros h H. apply is_hole_of_sound. now apply holes.
    + revert apart_holes. apply all_pairs_sound. intros g h found. apply are_beside_sound in found.
      cbn [flat_map] in found. now rewrite !app_nil_r in found.
  - revert beside. apply all_pairs_sound. intros b c. apply are_beside_sound.
Qed.
