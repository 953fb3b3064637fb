(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Hopf's theorem of turning tangents for all simple chains (thesis, Definition 2.1.9): the turning number
   is 1 or -1, by the turn at any vertex at which all others are on one side of a line, as at the smallest
   one, which is where reference/chains/region_of.cpp looks. The theorem for chains that begin there is in
   turning_tangents.v, simple chains are in simple_chain.v. *)
From Coq Require Import PeanoNat ZArith Lia Bool List Permutation.
From Oplus Require Import numbers convolution regions secants segments_apart turning_tangents simple_chain.
Import ListNotations.

Open Scope nat_scope.

(* A simple chain, without the edge that closes it, is a path without crossings. *)
Lemma apart_from_by_index p q path :
  (forall j, S j < length path -> apart p q (vertex path j) (vertex path (S j))) ->
  apart_from p q path.
Proof.
  induction path as [| a path IH]; intros each; [exact I |].
  destruct path as [| b path]; [exact I |]. split.
  - apply (each 0). cbn. lia.
  - apply IH. intros j J. apply (each (S j)). cbn in *. lia.
Qed.

Lemma without_crossings_by_index path :
  (forall i, S (S i) < length path ->
     turns (minus (vertex path (S i)) (vertex path i)) (minus (vertex path (S (S i))) (vertex path (S i)))) ->
  (forall i j, S i < j -> S j < length path ->
     apart (vertex path i) (vertex path (S i)) (vertex path j) (vertex path (S j))) ->
  without_crossings path.
Proof.
  induction path as [| p path IH]; intros turn far; [exact I |].
  destruct path as [| q path]; [exact I |]. destruct path as [| r path]; [exact I |].
  split; [| split].
  - apply (turn 0). cbn. lia.
  - apply apart_from_by_index. intros j J. apply (far 0 (S (S j))); cbn in *; lia.
  - apply IH.
    + intros i I. apply (turn (S i)). cbn in *. lia.
    + intros i j L J. apply (far (S i) (S j)); cbn in *; lia.
Qed.

Lemma simple_chain_without_crossings chain : simple chain -> without_crossings chain.
Proof.
  intros chain_simple. apply without_crossings_by_index.
  - intros i L. pose proof (simple_chain_turns chain i chain_simple) as t. cbv zeta in t.
    rewrite !next_below in t by lia. apply t. lia.
  - intros i j L J. apply are_apart_sound.
    pose proof (simple_chain_edges_apart chain i j chain_simple) as far. cbv zeta in far.
    rewrite !next_below in far by lia. apply far; lia.
Qed.

(* Beginning at the next vertex. *)
Lemma vertex_rotated chain i : i < length chain -> vertex (rotated chain) i = vertex chain (next i (length chain)).
Proof. intros I. unfold vertex. now apply nth_rotated. Qed.

Lemma edge_rotated chain i : i < length chain -> edge_at (rotated chain) i = edge_at chain (next i (length chain)).
Proof.
  intros I. pose proof (next_in_range i (length chain) I) as J.
  rewrite !edge_is, rotated_length by (try rewrite rotated_length; assumption).
  now rewrite !vertex_rotated.
Qed.

Lemma edge_of_chain_rotated chain i : i < length chain ->
  edge_of_chain (rotated chain) i = edge_of_chain chain (next i (length chain)).
Proof.
  intros I. pose proof (next_in_range i (length chain) I) as J.
  rewrite !edge_of_chain_joins_vertices, rotated_length by (try rewrite rotated_length; assumption).
  now rewrite !vertex_rotated.
Qed.

Lemma corner_rotated chain i : i < length chain ->
  corner_of_chain (rotated chain) i = corner_of_chain chain (next i (length chain)).
Proof.
  intros I. pose proof (next_in_range i (length chain) I) as J.
  pose proof (previous_below (length chain) i I) as K.
  rewrite !corner_is, rotated_length by (try rewrite rotated_length; assumption).
  now rewrite !edge_of_chain_rotated, next_previous, previous_next.
Qed.

Lemma corners_rotated chain : corners (rotated chain) = rotated (corners chain).
Proof.
  apply (nth_ext _ _ (Corner nowhere nowhere) (Corner nowhere nowhere)).
  - now rewrite corners_length, !rotated_length, corners_length.
  - intros i I. rewrite corners_length, rotated_length in I.
    rewrite nth_rotated, corners_length by now rewrite corners_length. now apply corner_rotated.
Qed.

Lemma turning_number_rotated chain : turning_number (rotated chain) = turning_number chain.
Proof.
  unfold turning_number, turns_past. rewrite corners_rotated.
  destruct (corners chain) as [| c rest]; [reflexivity |]. cbn [rotated]. rewrite map_app, sum_of_both.
  unfold sum. cbn [map fold_right]. lia.
Qed.

Lemma next_injective n i j : i < n -> j < n -> next i n = next j n -> i = j.
Proof. intros I J same_next. rewrite <- (previous_next i n I), same_next. now apply previous_next. Qed.

Lemma simple_rotated chain : simple chain -> simple (rotated chain).
Proof.
  intros (N & e & common). unfold simple. rewrite rotated_length.
  split; [exact N | split].
  - intros u I. apply (In_nth _ _ nowhere) in I. destruct I as (i & I & <-).
    rewrite edges_length, rotated_length in I. fold (edge_of_chain (rotated chain) i).
    rewrite edge_of_chain_rotated by exact I. apply edge_nonzero; [exact e | now apply next_in_range].
  - intros i j x I J differ on_i on_j.
    pose proof (next_in_range i _ I) as I'. pose proof (next_in_range j _ J) as J'.
    rewrite edge_rotated in on_i, on_j by assumption. rewrite !vertex_rotated by assumption.
    assert (differ' : next i (length chain) <> next j (length chain))
      by (intros same_next; apply differ; now apply next_injective with (length chain)).
    destruct (common _ _ x I' J' differ' on_i on_j) as [[follows x_is] | [follows x_is]].
    + left. split; [| exact x_is]. now apply next_injective with (length chain).
    + right. split; [| exact x_is]. now apply next_injective with (length chain).
Qed.

Lemma simple_chain_turns_everywhere chain : simple chain -> turns_everywhere chain.
Proof.
  intros chain_simple c I. apply (In_nth _ _ (Corner nowhere nowhere)) in I.
  destruct I as (i & I & <-). rewrite corners_length in I. fold (corner_of_chain chain i).
  pose proof (previous_below (length chain) i I) as J.
  rewrite corner_is by exact I. cbn [incoming outgoing].
  rewrite !edge_of_chain_joins_vertices by assumption.
  pose proof (simple_chain_turns chain (previous (length chain) i) chain_simple J) as t.
  cbv zeta in t. now rewrite next_previous in t |- * by exact I.
Qed.

Lemma first_vertex_extreme chain d s :
  simple chain -> nonzero d ->
  (forall j, 0 < j < length chain -> in_half_turn s d (minus (vertex chain j) (vertex chain 0))) ->
  turning_number chain = if is_reflex (corner_of_chain chain 0) then (-1)%Z else 1%Z.
Proof.
  intros chain_simple nd extreme.
  pose proof (simple_chain_turns_everywhere chain chain_simple) as everywhere.
  pose proof (simple_chain_without_crossings chain chain_simple) as first_free.
  pose proof (simple_chain_without_crossings _ (simple_rotated chain chain_simple)) as last_free.
  destruct chain_simple as (N & _ & _).
  destruct chain as [| v [| a rest]]; [cbn in N; lia .. |].
  destruct (exists_last (l := rest)) as (middle & z & ->); [intros ->; cbn in N; lia |].
  rewrite (turns_once_at_an_extreme_vertex d s v a z middle nd everywhere first_free).
  - set (chain := v :: a :: middle ++ [z]).
    assert (last_place : previous (length chain) 0 = S (S (length middle))).
    { unfold chain, previous. cbn [length]. rewrite app_length. cbn [length]. lia. }
    assert (long : length chain = S (S (S (length middle))))
      by (unfold chain; cbn [length]; rewrite app_length; cbn [length]; lia).
    rewrite corner_is, last_place by (rewrite long; lia). rewrite !edge_of_chain_joins_vertices by (rewrite long; lia).
    rewrite long. unfold next. rewrite Nat.eqb_refl.
    destruct (Nat.eqb_spec 1 (S (S (S (length middle))))); [lia |].
    assert (last_vertex : vertex chain (S (S (length middle))) = z).
    { unfold chain, vertex. cbn [nth]. now rewrite app_nth2, Nat.sub_diag by lia. }
    now rewrite last_vertex.
  - cbn [rotated app] in last_free. now rewrite <- app_assoc in last_free.
  - intros b I. apply (In_nth _ _ nowhere) in I. destruct I as (j & J & <-).
    apply (extreme (S j)). cbn [length] in *. lia.
Qed.

(* Theorem. Of a simple chain with all other vertices on one side of a line through vertex k, those on the line
   on one side of it, too, the turning number is 1 if the chain turns left at k, else -1. *)
Theorem simple_chain_turns_once_at chain d s k :
  simple chain -> nonzero d -> k < length chain ->
  (forall j, j < length chain -> j <> k -> in_half_turn s d (minus (vertex chain j) (vertex chain k))) ->
  turning_number chain = if is_reflex (corner_of_chain chain k) then (-1)%Z else 1%Z.
Proof.
  revert chain. induction k as [| k IH]; intros chain chain_simple nd K extreme.
  - apply (first_vertex_extreme chain d s); trivial. intros j J. apply extreme; lia.
  - assert (k < length chain) as k_below by lia. pose proof (next_below k _ K) as following.
    rewrite <- (turning_number_rotated chain), (IH (rotated chain)).
    + now rewrite corner_rotated, following.
    + now apply simple_rotated.
    + exact nd.
    + now rewrite rotated_length.
    + rewrite rotated_length. intros j J differ. rewrite !vertex_rotated, following by assumption.
      apply extreme; [now apply next_in_range |]. intros same_next. apply differ.
      apply (next_injective (length chain)); trivial. now rewrite following.
Qed.

(* The smallest vertex, by x, then by y. *)
Definition is_smaller (a b : vector) : bool :=
  negative (vx a - vx b)%Q || (zero (vx a - vx b)%Q && negative (vy a - vy b)%Q).

Fixpoint smallest_of (chain : list vector) : nat :=
  match chain with
  | a :: ((_ :: _) as rest) =>
      let k := smallest_of rest in if is_smaller (vertex rest k) a then S k else 0
  | _ => 0
  end.

(* Whether the chain turns left at its smallest vertex. *)
Definition is_counterclockwise (chain : list vector) : bool :=
  negb (is_reflex (corner_of_chain chain (smallest_of chain))).

Lemma is_smaller_spec (a b : vector) : reflect (vx a < vx b \/ (vx a == vx b /\ vy a < vy b))%Q (is_smaller a b).
Proof.
  unfold is_smaller.
  destruct (negative_spec (vx a - vx b)), (zero_spec (vx a - vx b)), (negative_spec (vy a - vy b));
    constructor; lra.
Qed.

Lemma smallest_of_is_smallest chain : chain <> [] ->
  smallest_of chain < length chain /\
  forall j, j < length chain -> is_smaller (vertex chain j) (vertex chain (smallest_of chain)) = false.
Proof.
  assert (none_before_itself : forall a, is_smaller a a = false)
    by (intros a; destruct (is_smaller_spec a a); [lra | reflexivity]).
  induction chain as [| a rest IH]; intros some; [contradiction |]. clear some.
  destruct rest as [| b rest].
  { cbn. split; [lia |]. intros [| j] J; [apply none_before_itself | lia]. }
  destruct IH as [inside least]; [discriminate |].
  set (others := b :: rest) in *.
  change (smallest_of (a :: others)) with
    (if is_smaller (vertex others (smallest_of others)) a then S (smallest_of others) else 0).
  destruct (is_smaller_spec (vertex others (smallest_of others)) a) as [smaller | not_smaller].
  - split; [cbn [length]; lia |]. intros [| j] J.
    + change (is_smaller a (vertex others (smallest_of others)) = false).
      destruct (is_smaller_spec a (vertex others (smallest_of others))); [lra | reflexivity].
    + apply (least j). cbn [length] in J. lia.
  - split; [cbn [length]; lia |]. intros [| j] J; [apply none_before_itself |].
    cbn [length] in J. specialize (least j). change (is_smaller (vertex others j) a = false).
    destruct (is_smaller_spec (vertex others j) a) as [too_small |]; [exfalso | reflexivity].
    destruct (is_smaller_spec (vertex others j) (vertex others (smallest_of others))) as [| not_below];
      [discriminate least; lia | lra].
Qed.

Lemma vertices_differ chain i j : simple chain -> i < length chain -> j < length chain -> i <> j ->
  ~ equal_vectors (vertex chain i) (vertex chain j).
Proof.
  intros (N & e & common) I J differ [x_is y_is].
  assert (starts : forall k, k < length chain -> lies_on (vertex chain k) (edge_at chain k)).
  { intros k K. rewrite edge_is by exact K. exists 0%Q. cbn [source target]. repeat split; lra. }
  assert (on_j : lies_on (vertex chain i) (edge_at chain j)).
  { rewrite edge_is by exact J. exists 0%Q. cbn [source target]. repeat split; lra. }
  assert (apart_vertices : forall k, k < length chain ->
    ~ equal_vectors (vertex chain k) (vertex chain (next k (length chain)))).
  { intros k K [xk yk]. apply (edges_of_simple_chains chain k e K). unfold minus. cbn [vx vy]. lra. }
  destruct (common i j _ I J differ (starts i I) on_j) as [[follows _] | [follows _]].
  - apply (apart_vertices i I). rewrite <- follows. now split.
  - apply (apart_vertices j J). rewrite <- follows. split; lra.
Qed.

Definition down : vector := Vector 0 (-1).

Lemma smallest_is_extreme chain j : simple chain -> j < length chain -> j <> smallest_of chain ->
  in_half_turn OfQ down (minus (vertex chain j) (vertex chain (smallest_of chain))).
Proof.
  intros chain_simple J differ. pose proof chain_simple as (N & _).
  destruct (smallest_of_is_smallest chain) as [K least]; [intros ->; cbn in N; lia |].
  pose proof (vertices_differ chain j _ chain_simple J K differ) as apart_vertices.
  specialize (least j J). unfold equal_vectors in apart_vertices.
  destruct (is_smaller_spec (vertex chain j) (vertex chain (smallest_of chain))); [discriminate |].
  unfold in_half_turn, cross, dot, minus, down. cbn [vx vy].
  set (k := smallest_of chain) in *.
  destruct (Q_dec (vx (vertex chain j)) (vx (vertex chain k))) as [[? | ?] | same_x]; [lra | left; lra |].
  right. destruct (Q_dec (vy (vertex chain j)) (vy (vertex chain k))) as [[? | ?] | same_y]; lra.
Qed.

(* Theorem (Hopf). The turning number of a simple chain is 1 if it turns left at its smallest vertex, and -1 if it
   turns right there. *)
Theorem simple_chain_turns_once chain :
  simple chain -> turning_number chain = if is_counterclockwise chain then 1%Z else (-1)%Z.
Proof.
  intros chain_simple. pose proof chain_simple as (N & _).
  destruct (smallest_of_is_smallest chain) as [K _]; [intros ->; cbn in N; lia |].
  rewrite (simple_chain_turns_once_at chain down OfQ (smallest_of chain)); trivial.
  - unfold is_counterclockwise. now destruct (is_reflex _).
  - unfold nonzero, down. cbn [vx vy]. lra.
  - intros j J differ. now apply smallest_is_extreme.
Qed.

(* So a test by signs decides it. *)
Corollary simple_by_the_test_turns_once chain :
  is_simple chain = true -> turning_number chain = 1%Z \/ turning_number chain = (-1)%Z.
Proof.
  intros test. apply is_simple_decides in test. rewrite (simple_chain_turns_once chain test).
  destruct (is_counterclockwise chain); [now left | now right].
Qed.
