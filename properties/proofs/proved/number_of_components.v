(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Theorem 4.2.14: for two simple polygons P and Q and x in general position, the winding number of the original
   convolution is the number of connected components of the intersection of P and -Q + x. Its chains are as many as
   their turning numbers add up to, since all are counterclockwise, and as many as the components
   (components_of_the_intersection.v). Where x is off the original convolution, but not in general position, this is so
   for all x in general position close by. *)
From Coq Require Import QArith Qminmax Lqa ZArith Lia Bool List Permutation.
From Oplus Require Import regions_and_sums simple_chain simple_chains_turn_once meeting_of_segments theorem_4_2_1
  turning_number replaced_segments lemma_4_2_13 size_of_valid_regions polygons_of_the_thesis connected_sets
  placed_collision reflected walks region_of_pieces neighbourhoods edges_of_the_intersection reflected_polygons
  boundary_of_the_intersection chains_of_the_intersection connected_beside_pieces points_of_the_intersection
  components_of_the_intersection.
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
  rewrite placed_. split.
  - intros (v & in_ & X & Y). apply (in_region_of_equal [q] v); [| exact in_]. unfold equal_vectors, minus in *.
    cbn [vx vy] in *. split; lra.
  - intros in_. exists (minus x z). split; [exact in_ |]. unfold equal_vectors, minus. cbn [vx vy]. split; ring.
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
  - destruct (components_are_the_chains p b p_polygon b_polygon p_off b_off r edges_are all_simple _ crossings)
      as (points & long & in_ & all & apart_).
    assert (same_ : forall z, in_both p b z <-> in_region z [p] /\ in_reflected x [q] z)
      by (intros z; unfold in_both; now rewrite in_reflected_is_in_placed).
    assert (paths : forall v w, connected_in (in_both p b) v w <->
      connected_in (fun z => in_region z [p] /\ in_reflected x [q] z) v w).
    { intros v w. split; apply connected_in_more; intros z; apply same_. }
    exists points. split; [exact long |]. split; [intros v V; now apply same_, in_ |]. split.
    + intros z Z. apply same_ in Z. destruct (all z Z) as (v & V & there). exists v. split; [exact V | now apply paths].
    + clear - apart_ paths. induction apart_ as [| v l first_ _ IH]; constructor; [| exact IH].
      rewrite Forall_forall in *. intros w W there. apply (first_ w W). now apply paths.
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

(* And for all x in general position that are close to one off the original convolution. *)
Corollary theorem_4_2_14_close_by (p q : list vector) (x : vector) : simple_polygon p -> simple_polygon q ->
  off x (original_convolution [p] [q]) -> exists radius, 0 < radius /\
    forall y, within radius x y -> off_vertex_edge_sum y [p] [q] ->
      exists k, has_components (fun z => in_region z [p] /\ in_reflected y [q] z) k /\
        winding_number x (original_convolution [p] [q]) = Z.of_nat k.
Proof.
  intros p_polygon q_polygon free.
  assert (closed : cycles (original_convolution [p] [q])).
  { apply replaced_segments_are_cycles; [exact (proj1 (simple_polygons_are_regions p p_polygon)) |
      exact (proj1 (simple_polygons_are_regions q q_polygon))]. }
  destruct (winding_number_near x _ closed free) as (radius & R & near). exists radius. split; [exact R |].
  intros y close general.
  destruct (theorem_4_2_14_in_general_position p q y p_polygon q_polygon general) as (k & components & number).
  exists k. split; [exact components |]. now rewrite <- (proj2 (near y close)).
Qed.
