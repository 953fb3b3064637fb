(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* A weakly simple chain that does not cross itself goes round each point not at all, or once in the direction in which
   it turns: as the simple chain does that is made of it by cutting its corners a little. With each vertex twice it is
   a chain whose vertices are moved then (small_moves.v). *)
From Coq Require Import ZArith Lia Bool List.
From Oplus Require Import numbers convolution small_numbers neighbourhoods regions simple_chain
  winding_numbers_of_simple_chains strictly_convex_curve small_moves cut_corners simple_when_cut
  touching_chains.
Import ListNotations.

Open Scope Q_scope.

Definition with_each_vertex_twice (chain : list vector) : list vector :=
  flat_map (fun i => [vertex chain i; vertex chain i]) (seq 0 (length chain)).

Section Twice.
  Variable chain : list vector.
  Let n := length chain.
  Let twice := with_each_vertex_twice chain.

  Lemma twice_length : length twice = (2 * n)%nat.
  Proof.
    unfold twice, with_each_vertex_twice, n. rewrite <- (seq_length (length chain) 0) at 2.
    generalize (seq 0 (length chain)). intros l. induction l as [| i l IH]; [reflexivity |].
    cbn [flat_map app length]. lia.
  Qed.

  Lemma twice_vertices (i : nat) : (i < n)%nat ->
    vertex twice (2 * i) = vertex chain i /\ vertex twice (2 * i + 1) = vertex chain i.
  Proof. intros I. exact (two_each vector _ _ nowhere n 0 i I). Qed.

  Lemma twice_edges (i : nat) : (i < n)%nat ->
    edge_at twice (2 * i) = Segment (vertex chain i) (vertex chain i) /\ edge_at twice (2 * i + 1) = edge_at chain i.
  Proof.
    intros I. rewrite !edge_is by (rewrite ?twice_length; fold n; lia). rewrite twice_length. fold n.
    destruct (next_of_two n i I) as [-> ->]. destruct (twice_vertices i I) as [-> ->].
    destruct (twice_vertices (next i n) (next_in_range i n I)) as [-> _]. now split.
  Qed.

  Lemma same_winding_number (x : vector) : winding_number x (edges twice) = winding_number x (edges chain).
  Proof.
    unfold winding_number. rewrite (edges_by_number twice), (edges_by_number chain), !map_map, twice_length,
      sum_of_twos.
    fold n. f_equal. apply map_ext_in. intros i I. apply in_seq in I. destruct (twice_edges i ltac:(lia)) as [-> ->].
    unfold signed_crossing at 1, ray_crossing. cbn [source target]. now rewrite eqb_reflx.
  Qed.

  Lemma off_twice (x : vector) : off x (edges chain) -> off x (edges twice).
  Proof.
    intros free t T on. rewrite edges_by_number in T. apply in_map_iff in T. destruct T as (j & <- & J).
    apply in_seq in J. rewrite twice_length in J. destruct (one_of_two n j ltac:(lia)) as (i & I & which).
    assert (edge_in : In (edge_at chain i) (edges chain)) by (apply nth_In; now rewrite edges_are_as_many).
    destruct (twice_edges i I) as [even odd]. destruct which as [-> | ->]; [rewrite even in on | rewrite odd in on].
    - apply (free _ edge_in). rewrite edge_is by exact I. destruct on as (t & range & X & Y). exists 0.
      cbn [source target] in *. split; [lra |]. rewrite X, Y. split; ring.
    - exact (free _ edge_in on).
  Qed.

  Lemma cut_is_near_twice (radius : Q) : 0 < radius ->
    eventually (fun e => near radius twice (with_cut_corners chain e)).
  Proof.
    intros R. assert (each : forall i, In i (seq 0 n) -> eventually (fun e =>
      within radius (vertex chain i) (before_corner chain e i) /\
        within radius (vertex chain i) (after_corner chain e i)))
      by (intros i _; apply eventually_and; now apply small_steps_stay_within).
    refine (eventually_implied _ _ _ (eventually_for_all _ _ each)). intros e close.
    split; [now rewrite cut_length, twice_length |]. intros j J. rewrite twice_length in J.
    destruct (one_of_two n j J) as (i & I & which). destruct (close i ltac:(apply in_seq; lia)) as [before_ after_].
    destruct (cut_vertices chain e i I) as [cut_before cut_after], (twice_vertices i I) as [even odd].
    destruct which as [-> | ->]; [rewrite even, cut_before | rewrite odd, cut_after]; assumption.
  Qed.
End Twice.

(* Theorem. *)
Theorem touching_chain_goes_round_once (chain : list vector) (x : vector) :
  (2 <= length chain)%nat -> turns_everywhere chain -> edges_are_interior_disjoint chain ->
  vertices_touch_from_one_side chain -> vertices_do_not_cross chain -> off x (edges chain) ->
  winding_number x (edges chain) = 0%Z \/ winding_number x (edges chain) = turning_number chain.
Proof.
  intros long turn disjoint one_side crossing_free free.
  pose proof (off_twice chain x free) as free_twice.
  destruct (some_small _ (eventually_and _ _ (winding_number_stays _ x free_twice) (stays_off _ x free_twice)))
    as (radius & R & number & still_off).
  destruct (some_small _ (eventually_and _ _ (cut_is_near_twice chain radius R)
    (small_cuts_make_it_simple chain long turn disjoint one_side crossing_free))) as (e & _ & close & simple_ & turns_).
  rewrite <- (same_winding_number chain x), <- (number _ close (still_off _ close)), <- turns_.
  apply simple_chain_winds_at_most_once; [exact simple_ | exact (still_off _ close)].
Qed.
