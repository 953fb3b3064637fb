(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Tracing the convolution cycles of two closed chains: Theorem 4.1.6 for the algorithm as it is coded in
   checked/cycles/cycle_tracing.cpp. *)
From Coq Require Import Lia Bool List Permutation Arith.
From Oplus Require Import convolution orbit tracing.
Import ListNotations.

Open Scope nat_scope.

(* Theorem 4.1.6 for one cycle. From any convolution segment on, going on along the same summand
   where that is possible and else along the other one, without a test, the trace returns to the
   state where it began after at most 2 n m steps. All it takes are convolution segments, none of
   them twice, and each leaves the state to which the one before it leads. *)
Theorem trace_returns_to_its_start (p q : list vector) (s : named_segment) :
  no_edge_is_a_point p -> no_edge_is_a_point q -> In s (convolution p q) ->
  exists cycle,
    trace (length p) (length q) (in_convolution p q) (2 * length p * length q) (state_before s) s =
      Some (s :: cycle) /\
    is_walk (length p) (length q) (state_before s) (s :: cycle) (state_before s) /\
    NoDup (s :: cycle) /\ incl (s :: cycle) (convolution p q).
Proof.
  intros ep eq I. pose proof (convolution_is_balanced p q ep eq) as b.
  set (n := length p) in *. set (m := length q) in *.
  destruct (trace_ends n m _ b s I) as (k & e & ends & apart).
  rewrite first_of_orbit_cons in e. eexists. split; [exact e |].
  rewrite <- first_of_orbit_cons. split; [| split].
  - rewrite <- ends at 2. apply orbit_is_walk.
  - apply (first_of_orbit_NoDup _ (those n m (in_convolution p q)));
      [now apply segment_after_self_injection | exact I |].
    intros [| i] i_range e'; [lia |]. apply (apart i); [lia |]. rewrite <- e' at 2. reflexivity.
  - intros t J. apply in_first_of_orbit in J. destruct J as (i & _ & ->).
    apply (iterated_in _ (those n m (in_convolution p q)));
      [now apply segment_after_self_injection | exact I].
Qed.

(* Theorem 4.1.6 for all of them. Started at the unvisited segments that leave the first row and the first
   column, every trace ends; each is a closed walk from state to state; together they are the
   convolution, each segment in exactly one cycle, once. *)
Theorem cycles_cover_the_convolution (p q : list vector) :
  no_edge_is_a_point p -> no_edge_is_a_point q -> p <> [] -> q <> [] ->
  exists cycles,
    trace_cycles (length p) (length q) (in_convolution p q) = Some cycles /\
    Forall (is_cycle (length p) (length q)) cycles /\
    Permutation (concat cycles) (convolution p q).
Proof.
  intros ep eq p_is q_is.
  apply (cycles_are_traced _ _ _ (convolution_is_balanced p q ep eq)).
  - destruct p; [contradiction | cbn; lia].
  - destruct q; [contradiction | cbn; lia].
Qed.

(* How many states are looked at: the starts, and each state a cycle comes to before it is back. *)
Definition states_looked_at (n m : nat) (cycles : list (list named_segment)) : nat :=
  length (starts n m) + list_sum (map (fun cycle => length cycle - 1) cycles).

Lemma length_concat (A : Type) (lists : list (list A)) : length (concat lists) = list_sum (map (@length A) lists).
Proof. induction lists as [| l lists IH]; [reflexivity |]. cbn. now rewrite app_length, IH. Qed.

(* The step count of Theorem 4.1.10: with K segments in the convolution, n + m - 1 + K states are
   looked at, minus one for each cycle. *)
Theorem states_looked_at_are_few (p q : list vector) (cycles : list (list named_segment)) :
  no_edge_is_a_point p -> no_edge_is_a_point q -> p <> [] -> q <> [] ->
  trace_cycles (length p) (length q) (in_convolution p q) = Some cycles ->
  states_looked_at (length p) (length q) cycles + length cycles + 1 =
  length p + length q + length (convolution p q).
Proof.
  intros ep eq p_is q_is e.
  destruct (cycles_cover_the_convolution p q ep eq p_is q_is) as (cycles' & e' & good & permuted).
  rewrite e in e'. injection e' as <-. clear e.
  apply Permutation_length in permuted. rewrite length_concat in permuted.
  assert (list_sum (map (@length named_segment) cycles) = length (convolution p q)) as size
    by exact permuted. clear permuted.
  unfold states_looked_at, starts. rewrite app_length, !map_length, !seq_length.
  assert (length p <> 0 /\ length q <> 0) as [? ?] by (destruct p, q; cbn; split; congruence).
  assert (list_sum (map (fun cycle => length cycle - 1) cycles) + length cycles =
          list_sum (map (@length named_segment) cycles)).
  { clear size. induction good as [| cycle rest [nonempty _] _ IH]; [reflexivity |].
    destruct cycle as [| first others]; [contradiction |].
    unfold list_sum in *. cbn [map fold_right length]. lia. }
  unfold named_segment, state in *. lia.
Qed.

(* What tracing makes of one pair of chains. *)
Definition traced_pair : Type := (list vector * list vector) * list (list named_segment).

Definition is_traced (pair : traced_pair) : Prop :=
  let n := length (fst (fst pair)) in
  let m := length (snd (fst pair)) in
  trace_cycles n m (in_convolution (fst (fst pair)) (snd (fst pair))) = Some (snd pair) /\
  Forall (is_cycle n m) (snd pair).

(* Theorem 4.1.6 for two regions, each of any number of closed chains, holes among them: tracing each chain of
   P with each of Q, all traces end, each is a closed walk, and together they are the convolution, each
   segment in exactly one cycle, once. *)
Theorem cycles_cover_the_convolution_of_regions (p q : region) :
  (forall chain, In chain p -> no_edge_is_a_point chain /\ chain <> []) ->
  (forall chain, In chain q -> no_edge_is_a_point chain /\ chain <> []) ->
  exists pairs : list traced_pair,
    map fst pairs = list_prod p q /\ Forall is_traced pairs /\
    Permutation (flat_map (fun pair => map (fun s => (fst pair, s)) (concat (snd pair))) pairs)
                (segments_of_regions p q).
Proof.
  intros ep eq. unfold segments_of_regions.
  assert (proper_pairs : forall a b, In (a, b) (list_prod p q) ->
            (no_edge_is_a_point a /\ a <> []) /\ (no_edge_is_a_point b /\ b <> [])).
  { intros a b I. apply in_prod_iff in I. split; [apply ep | apply eq]; tauto. }
  induction (list_prod p q) as [| [a b] rest IH]; [exists []; repeat split; constructor |].
  destruct IH as (pairs & firsts & good & all); [intros; apply proper_pairs; now right |].
  destruct (proper_pairs a b (or_introl eq_refl)) as [[ea na] [eb nb]].
  destruct (cycles_cover_the_convolution a b ea eb na nb) as (cycles & traced & closed & covered).
  exists (((a, b), cycles) :: pairs). cbn [map flat_map fst snd]. repeat split.
  - now rewrite firsts.
  - constructor; [now split | exact good].
  - apply Permutation_app; [| exact all]. exact (Permutation_map _ covered).
Qed.
