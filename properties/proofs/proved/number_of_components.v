(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Theorem 4.2.14: for two simple polygons P and Q and x in general position, the winding number of the original
   convolution is the number of connected components of the intersection of P and -Q + x. Its chains are as many as
   their turning numbers add up to, since all are counterclockwise, and as many as the components
   (components_of_the_intersection.v). *)
From Coq Require Import QArith Qminmax Lqa ZArith Lia Bool List Permutation.
From Oplus Require Import regions_and_sums simple_chain simple_chains_turn_once meeting_of_segments theorem_4_2_1
  turning_number replaced_segments lemma_4_2_13 size_of_valid_regions polygons_of_the_thesis connected_sets
  placed_collision reflected walks region_of_pieces neighbourhoods edges_of_the_intersection reflected_polygons
  boundary_of_the_intersection chains_of_the_intersection connected_beside_pieces points_of_the_intersection
  components_of_the_intersection components_of_near_sets components_stay.
Import ListNotations.

Open Scope Q_scope.

(* If each of these points is connected with one of those, and no two of these with each other, they are at most as
   many. *)
Lemma at_most_as_many (A : vector -> Prop) (these : list vector) : forall those,
  (forall v, In v these -> exists w, In w those /\ connected_in A v w) ->
  ForallOrdPairs (fun v w => ~ connected_in A v w) these -> (length these <= length those)%nat.
Proof.
  induction these as [| v these IH]; intros those each apart_; [apply Nat.le_0_l |].
  destruct (each v (or_introl eq_refl)) as (w & W & there).
  inversion apart_ as [| ? ? first_ apart_']; subst. rewrite Forall_forall in first_.
  destruct (in_split _ _ W) as (before & after & ->). rewrite app_length. cbn [length].
  rewrite Nat.add_succ_r, <- app_length. apply le_n_S, IH; [| exact apart_']. intros u U.
  destruct (each u (or_intror U)) as (t & T & there'). exists t. split; [| exact there'].
  apply in_app_iff. apply in_app_iff in T. destruct T as [T | [<- | T]]; [now left | | now right].
  destruct (first_ u U). exact (connected_on A _ _ _ there (connected_back A _ _ there')).
Qed.

(* That there are k components says how many there are. *)
Theorem components_are_so_many (A : vector -> Prop) (j k : nat) : has_components A j -> has_components A k -> j = k.
Proof.
  assert (most : forall m n, has_components A m -> has_components A n -> (m <= n)%nat).
  { intros m n (these & <- & in_these & _ & apart_) (those & <- & _ & all_those & _).
    apply (at_most_as_many A these those); [intros v V; apply all_those, in_these, V | exact apart_]. }
  intros J K. apply Nat.le_antisymm; now apply most.
Qed.

Lemma in_reflected_is_in_placed (x : vector) (q : list vector) (z : vector) :
  in_reflected x [q] z <-> in_region z [reflected_polygon x q].
Proof.
  change [reflected_polygon x q] with (placed x [q]).
  assert (z_is : equal_vectors (minus x z) (minus x z)) by reflexivity.
  assert (placed_ : in_region z (placed x [q]) <-> in_region (minus x z) [q]).
  { unfold in_region. rewrite edges_of_placed. split.
    - intros [some | (s & S & on)].
      + destruct (on_or_off (minus x z) (region_edges [q])) as [on | free]; [now right | left].
        rewrite <- (winding_number_of_placed x z [q] free), edges_of_placed. exact some.
      + apply in_map_iff in S. destruct S as (t & <- & T). right. exists t. split; [exact T | now apply on_reflected].
    - intros [some | (t & T & on)].
      + destruct (on_or_off (minus x z) (region_edges [q])) as [(t & T & on) | free].
        * right. exists (reflected x t). split; [now apply in_map | now apply on_reflected].
        * left. rewrite <- edges_of_placed, (winding_number_of_placed x z [q] free). exact some.
      + right. exists (reflected x t). split; [now apply in_map | now apply on_reflected]. }
  now rewrite placed_, in_reflected_is.
Qed.

(* Theorem 4.2.14, for x in general position. *)
Theorem theorem_4_2_14_in_general_position (p q : list vector) (x : vector) :
  simple_polygon p -> simple_polygon q -> off_vertex_edge_sum x [p] [q] ->
  exists k, has_components (fun z => in_region z [p] /\ in_reflected x [q] z) k /\
    winding_number x (original_convolution [p] [q]) = Z.of_nat k.
Proof.
  intros p_polygon q_polygon general. set (b := reflected_polygon x q).
  pose proof (reflected_polygon_is_one x q q_polygon) as b_polygon.
  pose proof (p_off_b p q x general) as p_off. pose proof (b_off_p p q x general) as b_off.
  destruct (winding_number_of_the_constructed_intersection p q x p_polygon q_polygon general) as (_ & _ & number).
  fold b in number. set (r := chains_of (length (kept_boundary p b)) (kept_boundary p b)) in *.
  assert (edges_are : Permutation (region_edges r) (kept_boundary p b))
    by exact (chains_of_kept _ _ _ (two_families_end p b p_polygon b_polygon)).
  pose proof (edges_do_cross_is_right p q x p_polygon q_polygon general) as crossings.
  assert (all_simple : forall chain, In chain r -> simple chain).
  { intros chain C. apply (kept_chains_are_simple p b p_polygon b_polygon p_off b_off _ crossings r chain edges_are C).
    exact (chains_are_not_empty _ _ chain C). }
  exists (length r). split.
  - apply (components_of_equal_sets (in_both p b)).
    + intros z. unfold in_both. now rewrite in_reflected_is_in_placed.
    + exact (components_are_the_chains p b p_polygon b_polygon p_off b_off r edges_are all_simple _ crossings).
  - rewrite number, turning_numbers_of_simple_chains by exact all_simple.
    assert (none : filter (fun chain => negb (is_counterclockwise chain)) r = []).
    { destruct (filter _ r) as [| c l] eqn:found; [reflexivity | exfalso].
      assert (C : In c (filter (fun chain => negb (is_counterclockwise chain)) r)) by (rewrite found; now left).
      apply filter_In in C. destruct C as [C turned].
      destruct (all_counterclockwise p b p_polygon b_polygon p_off b_off r edges_are all_simple c C) as [_ way].
      rewrite way in turned. discriminate. }
    assert (all_outer : filter is_counterclockwise r = r).
    { clear - none. induction r as [| c l IH]; [reflexivity |]. cbn [filter] in *.
      destruct (is_counterclockwise c); cbn [negb] in none; [now rewrite IH | discriminate]. }
    unfold outer_chains, holes, count. rewrite none, all_outer. cbn [length]. lia.
Qed.
