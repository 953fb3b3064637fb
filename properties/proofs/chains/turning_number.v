(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* How often the tangent sets of a closed chain cover a direction, and from that the number of segments
   of the convolution. *)
From Coq Require Import ZArith Lia Bool List SetoidList SetoidPermutation Permutation.
From Oplus Require Import numbers winding tangent_set.
Import ListNotations.

Open Scope Q_scope.

(* The list with its last element moved to the front. *)
Definition from_the_last {A} (l : list A) : list A :=
  match rev l with [] => [] | final :: rest => final :: rev rest end.

(* The directions of a closed chain's edges, edge i leaving vertex i. *)
Definition edge_directions (chain : list vector) : list vector :=
  map (fun e => minus (target e) (source e)) (edges chain).

(* At vertex j, the edges before it and after it. *)
Definition corners (chain : list vector) : list corner :=
  map (fun ends => Corner (fst ends) (snd ends))
    (combine (from_the_last (edge_directions chain)) (edge_directions chain)).

(* No two consecutive vertices are equal, and at no vertex does the chain turn back on itself. Nothing
   else is asked of a chain: it may cross itself and have vertices inside straight lines. *)
Definition turns_everywhere (chain : list vector) : Prop :=
  forall c, In c (corners chain) -> turns (incoming c) (outgoing c).

(* How often a chain's tangent, turning at each vertex by less than pi, passes a direction, clockwise
   counted negative. *)
Definition turns_past (d : direction) (chain : list vector) : Z :=
  sum (map (fun c => sweep d (incoming c) (outgoing c)) (corners chain)).

(* The turning number: how often the tangent passes the direction of the positive x-axis. It is 1 for simple polygons
   that are counterclockwise, -1 for their holes, which are clockwise; that is proved in simple_chains_turn_once.v. *)
Definition turning_number (chain : list vector) : Z := turns_past (Direction right OfQ) chain.

Definition count {A} (f : A -> bool) (l : list A) : nat := length (filter f l).

Definition reflex_vertices (chain : list vector) : nat := count is_reflex (corners chain).

Lemma from_the_last_permutes : forall A (l : list A), Permutation (from_the_last l) l.
Proof.
  intros A l. unfold from_the_last. rewrite <- (rev_involutive l) at 2.
  destruct (rev l) as [| final rest]; [reflexivity | apply Permutation_cons_append].
Qed.

Lemma combine_ends : forall A B (l : list A) (m : list B), length l = length m ->
  map fst (combine l m) = l /\ map snd (combine l m) = m.
Proof.
  intros A B l. induction l as [| a l IH]; intros [| b m] L; cbn in *; try discriminate;
    [split; reflexivity |].
  destruct (IH m) as [-> ->]; [lia | split; reflexivity].
Qed.

Lemma permuted_vectors : forall us vs, Permutation us vs -> PermutationA equal_vectors us vs.
Proof.
  intros us vs P.
  induction P; [apply permA_nil | now apply permA_skip | apply permA_swap | eapply permA_trans; eassumption].
Qed.

Definition turns_of (chain : list vector) : list (vector * vector) :=
  combine (from_the_last (edge_directions chain)) (edge_directions chain).

Lemma turns_closed : forall chain, closed (turns_of chain).
Proof.
  intros chain. unfold closed, turns_of.
  destruct (combine_ends _ _ (from_the_last (edge_directions chain)) (edge_directions chain))
    as [-> ->].
  - apply Permutation_length, from_the_last_permutes.
  - apply permuted_vectors, from_the_last_permutes.
Qed.

Lemma turns_past_total : forall d chain,
  turns_past d chain = total (fun p => sweep d (fst p) (snd p)) (turns_of chain).
Proof. intros d chain. unfold turns_past, total, corners, turns_of. rewrite map_map. reflexivity. Qed.

Lemma turns_of_chain : forall chain, turns_everywhere chain -> forall u v, In (u, v) (turns_of chain) -> turns u v.
Proof.
  intros chain T u v I. apply (T (Corner u v)). unfold corners, turns_of in *. apply in_map_iff. now exists (u, v).
Qed.

(* Theorem. A closed chain's tangent passes every direction, of either summand, as often as any other,
   which is its turning number. *)
Theorem turns_past_every_direction : forall chain d,
  turns_everywhere chain -> proper d -> turns_past d chain = turning_number chain.
Proof.
  intros chain d T D. unfold turning_number. rewrite !turns_past_total.
  apply sweeps_are_equal; [apply turns_closed | now apply turns_of_chain | exact D |].
  unfold proper, nonzero; cbn; lra.
Qed.

(* A vertex that turns left has in its tangent set what it passes; one that turns right has all else. *)
Lemma in_tangent_set_by_sweep : forall d c,
  proper d -> turns (incoming c) (outgoing c) ->
  Z.b2z (in_tangent_set d c) = (sweep d (incoming c) (outgoing c) + Z.b2z (is_reflex c))%Z.
Proof.
  intros d [u v] D (U & V & N). cbn in U, V, N. unfold in_tangent_set, is_reflex, sweep, negative; cbn.
  pose proof (cross_angle u v U V) as T. unfold turns_by in T.
  set (a := Direction u (other (of d))). set (b := Direction v (other (of d))).
  assert (A : proper a) by assumption. assert (B : proper b) by assumption.
  assert (~ place a == place d) by (rewrite place_of; cbn; destruct (of d); discriminate).
  assert (E : place a == place b) by (now apply place_of).
  assert (angle (vec a) == angle u) by reflexivity. assert (angle (vec b) == angle v) by reflexivity.
  clearbody a b.
  compared_numbers (cross u v ?= 0); try (specialize (N C));
    destruct (ccw_spec d a b D A B), (ccw_spec d b a D B A); cbn; try reflexivity; exfalso;
    unfold in_order in *; order.
Qed.

Lemma count_as_sum : forall A (f : A -> bool) l, Z.of_nat (count f l) = sum (map (fun a => Z.b2z (f a)) l).
Proof.
  intros A f l. unfold count, sum. induction l as [| a l IH]; [reflexivity |].
  cbn. rewrite <- IH. destruct (f a); cbn [length Z.b2z]; lia.
Qed.

Lemma sum_of_sums : forall A (f g h : A -> Z) l, (forall a, In a l -> h a = (f a + g a)%Z) ->
  sum (map h l) = (sum (map f l) + sum (map g l))%Z.
Proof.
  intros A f g h l H. unfold sum. induction l as [| a l IH]; [reflexivity |].
  cbn. rewrite IH by (intros; apply H; right; assumption).
  rewrite (H a) by (left; reflexivity). lia.
Qed.

(* Theorem. Every direction of one summand is in as many tangent sets of a closed chain of the other
   as the chain's turning number and its reflex vertices together, ties decided by the tie rule. *)
Theorem tangent_sets_cover : forall chain d,
  turns_everywhere chain -> proper d ->
  Z.of_nat (count (in_tangent_set d) (corners chain)) =
  (turning_number chain + Z.of_nat (reflex_vertices chain))%Z.
Proof.
  intros chain d T D. rewrite <- (turns_past_every_direction chain d T D).
  unfold reflex_vertices. rewrite !count_as_sum. unfold turns_past.
  apply sum_of_sums. intros c I. apply in_tangent_set_by_sweep; auto.
Qed.

(* Theorem. With turning number one, every direction of the other summand is in exactly one tangent
   set more than the chain has reflex vertices. *)
Theorem tangent_sets_cover_once_and_at_reflex_vertices : forall chain d,
  turns_everywhere chain -> turning_number chain = 1%Z -> proper d ->
  count (in_tangent_set d) (corners chain) = (1 + reflex_vertices chain)%nat.
Proof. intros chain d T N D. pose proof (tangent_sets_cover chain d T D). lia. Qed.
