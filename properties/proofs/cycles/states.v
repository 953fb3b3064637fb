(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The states of the fiber grid of two closed chains, which segments lead from one to the next, and that
   as many lead to a state as leave it. *)
From Coq Require Import PeanoNat Lia Bool List Permutation.
From Oplus Require Import numbers winding tangent_set turning_number convolution_size fiber_grid forward_traversal
  distinct.
Import ListNotations.

Open Scope nat_scope.

(* Indices are cyclic; n is the number of vertices. *)
Definition previous (n i : nat) : nat := match i with 0 => n - 1 | S k => k end.

Lemma previous_below n i : i < n -> previous n i < n.
Proof. unfold previous. destruct i; lia. Qed.
Lemma previous_next i n : i < n -> previous n (next i n) = i.
Proof. unfold next, previous. destruct (Nat.eqb_spec (S i) n); lia. Qed.
Lemma next_previous n i : i < n -> next (previous n i) n = i.
Proof.
  unfold next, previous. destruct i as [| i]; [destruct (Nat.eqb_spec (S (n - 1)) n); lia |].
  destruct (Nat.eqb_spec (S i) n); lia.
Qed.

(* A segment is named by the summand whose edge it is along and by the state it leaves. *)
Definition named_segment : Set := summand * (nat * nat).

Definition state_before (s : named_segment) : state := snd s.
Definition state_after (n m : nat) (s : named_segment) : state :=
  step n m (fst s) (snd s).

(* The segment along this summand that leads to a state. *)
Definition segment_to (n m : nat) (along : summand) (at_ : state) : named_segment :=
  match along with
  | OfP => (OfP, (previous n (fst at_), snd at_))
  | OfQ => (OfQ, (fst at_, previous m (snd at_)))
  end.

Definition state_eq_dec (a b : state) : {a = b} + {a <> b}.
Proof. repeat decide equality. Defined.

Definition in_grid (n m : nat) (at_ : state) : Prop := fst at_ < n /\ snd at_ < m.

Definition states (n m : nat) : list state := list_prod (seq 0 n) (seq 0 m).
Definition all_segments (n m : nat) : list named_segment := list_prod [OfP; OfQ] (states n m).

Lemma in_states n m at_ : In at_ (states n m) <-> in_grid n m at_.
Proof. destruct at_ as [i j]. etransitivity; [apply in_prod_iff |]. unfold in_grid. rewrite !in_seq. cbn. lia. Qed.

Lemma in_all_segments n m s : In s (all_segments n m) <-> in_grid n m (state_before s).
Proof.
  destruct s as [along at_]. etransitivity; [apply in_prod_iff |]. rewrite in_states. cbn.
  destruct along; tauto.
Qed.

Lemma states_NoDup n m : NoDup (states n m).
Proof. apply NoDup_list_prod; apply seq_NoDup. Qed.

Lemma all_segments_NoDup n m : NoDup (all_segments n m).
Proof.
  apply NoDup_list_prod; [| apply states_NoDup].
  repeat constructor; cbn; intuition discriminate.
Qed.

Lemma after_in_grid n m s : in_grid n m (state_before s) -> in_grid n m (state_after n m s).
Proof. destruct s as [[|] [i j]]; unfold in_grid; cbn; intros [? ?]; split; trivial; now apply next_in_range. Qed.

Lemma after_segment_to n m along at_ : in_grid n m at_ -> state_after n m (segment_to n m along at_) = at_.
Proof. destruct along, at_ as [i j]; unfold in_grid; cbn; intros [? ?]; now rewrite next_previous. Qed.

Lemma segment_to_after n m s : in_grid n m (state_before s) -> segment_to n m (fst s) (state_after n m s) = s.
Proof. destruct s as [[|] [i j]]; unfold in_grid; cbn; intros [? ?]; now rewrite previous_next. Qed.

Lemma state_after_injective n m along a b :
  in_grid n m a -> in_grid n m b ->
  state_after n m (along, a) = state_after n m (along, b) -> a = b.
Proof.
  intros A B e.
  pose proof (segment_to_after n m (along, a) A) as f. rewrite e in f.
  pose proof (segment_to_after n m (along, b) B) as g. cbn [fst] in f, g. congruence.
Qed.

(* Going along one summand from everywhere leads everywhere. *)
Lemma states_permuted n m along :
  Permutation (map (fun at_ => state_after n m (along, at_)) (states n m)) (states n m).
Proof.
  apply injective_permutes.
  - apply states_NoDup.
  - intros a I. rewrite in_states in *. now apply (after_in_grid n m (along, a)).
  - intros a b I J. rewrite in_states in *. now apply state_after_injective.
Qed.

(* What this file proves of two chains holds wherever as many segments enter each state as leave it. *)
Definition leaving_state (belongs : named_segment -> bool) (at_ : state) : nat :=
  Nat.b2n (belongs (OfP, at_)) + Nat.b2n (belongs (OfQ, at_)).
Definition entering_state (n m : nat) (belongs : named_segment -> bool) (at_ : state) : nat :=
  Nat.b2n (belongs (segment_to n m OfP at_)) + Nat.b2n (belongs (segment_to n m OfQ at_)).
Definition balanced (n m : nat) (belongs : named_segment -> bool) : Prop :=
  forall at_, in_grid n m at_ -> entering_state n m belongs at_ = leaving_state belongs at_.

(* The convolution's segments of two chains. *)
Definition in_convolution (p q : list vector) (s : named_segment) : bool :=
  is_convolution_segment p q (fst s) (fst (snd s)) (snd (snd s)).

(* No two consecutive vertices are equal. *)
Definition no_edge_is_a_point (chain : list vector) : Prop :=
  forall e, In e (edge_directions chain) -> nonzero e.

Lemma turning_chains_have_edges chain : turns_everywhere chain -> no_edge_is_a_point chain.
Proof.
  intros turning e I. apply (In_nth _ _ nowhere) in I. destruct I as (i & below & <-).
  rewrite edges_length in below. exact (edges_are_directions chain i OfP turning below).
Qed.

Lemma edge_nonzero chain i : no_edge_is_a_point chain -> i < length chain -> nonzero (edge_of_chain chain i).
Proof. intros e I. apply e. apply nth_In. now rewrite edges_length. Qed.

Lemma from_the_last_length A (l : list A) : length (from_the_last l) = length l.
Proof. apply Permutation_length, from_the_last_permutes. Qed.

Lemma nth_from_the_last A (l : list A) (d : A) i :
  i < length l -> nth i (from_the_last l) d = nth (previous (length l) i) l d.
Proof.
  intros I. unfold from_the_last. destruct (rev l) as [| final rest] eqn:r.
  - apply (f_equal (@rev A)) in r. rewrite rev_involutive in r. subst l. cbn in I. lia.
  - apply (f_equal (@rev A)) in r. rewrite rev_involutive in r. cbn in r. subst l.
    rewrite app_length in *. cbn [length] in *. destruct i as [| i]; cbn [nth previous].
    + rewrite app_nth2 by lia. now replace (length (rev rest) + 1 - 1 - length (rev rest)) with 0 by lia.
    + now rewrite app_nth1 by lia.
Qed.

Lemma corner_is chain i :
  i < length chain ->
  corner_of_chain chain i =
  Corner (edge_of_chain chain (previous (length chain) i)) (edge_of_chain chain i).
Proof.
  intros I. unfold corner_of_chain, edge_of_chain, corners.
  pose proof (edges_length chain) as l. rewrite <- l in I |- *.
  generalize dependent (edge_directions chain). intros edges I _.
  set (corner_of := fun ends : vector * vector => Corner (fst ends) (snd ends)).
  change (Corner nowhere nowhere) with (corner_of (nowhere, nowhere)).
  rewrite map_nth, combine_nth by apply from_the_last_length.
  unfold corner_of. cbn [fst snd]. now rewrite nth_from_the_last.
Qed.

Lemma corner_proper chain i : no_edge_is_a_point chain -> i < length chain -> proper_corner (corner_of_chain chain i).
Proof.
  intros e I. rewrite corner_is by assumption. split; cbn; apply edge_nonzero; trivial.
  now apply previous_below.
Qed.

(* Lemma 4.1.4 at states, for two closed chains of any shape, no two consecutive vertices equal: as many
   convolution segments lead to the state of vertex i of P and vertex j of Q as leave it. *)
Theorem convolution_is_balanced (p q : list vector) :
  no_edge_is_a_point p -> no_edge_is_a_point q ->
  balanced (length p) (length q) (in_convolution p q).
Proof.
  intros ep eq [i j] [I J]. cbn [fst snd] in I, J.
  pose proof (as_many_leave_as_enter (corner_of_chain p i) (corner_of_chain q j)
                (corner_proper p i ep I) (corner_proper q j eq J)) as e.
  unfold entering, leaving, p_enters, q_enters, p_leaves, q_leaves in e.
  assert (forall chain k, k < length chain ->
            incoming (corner_of_chain chain k) = edge_of_chain chain (previous (length chain) k) /\
            outgoing (corner_of_chain chain k) = edge_of_chain chain k) as ends
    by (intros chain k K; now rewrite corner_is).
  destruct (ends p i I) as [pi po], (ends q j J) as [qi qo]. rewrite pi, po, qi, qo in e. exact e.
Qed.

(* Lemma 4.1.3 in a fiber grid. A state of two closed chains has two segments that could lead to it, from
   the states (i - 1, j) and (i, j - 1), and two that could leave it.
   (1) If one that leads to it is in the convolution, one that leaves it is: tracing can always go on.
   (2) Both that leave it are in the convolution if and only if both that lead to it are. *)
Theorem forward_traversal_of_states (p q : list vector) (at_ : state) :
  no_edge_is_a_point p -> no_edge_is_a_point q -> in_grid (length p) (length q) at_ ->
  let enters along := in_convolution p q (segment_to (length p) (length q) along at_) = true in
  let leaves along := in_convolution p q (along, at_) = true in
  (enters OfP \/ enters OfQ -> leaves OfP \/ leaves OfQ) /\
  (leaves OfP /\ leaves OfQ <-> enters OfP /\ enters OfQ).
Proof.
  intros ep eq g enters leaves. pose proof (convolution_is_balanced p q ep eq at_ g) as e.
  unfold entering_state, leaving_state in e. unfold enters, leaves.
  destruct (in_convolution p q (segment_to _ _ OfP at_)), (in_convolution p q (segment_to _ _ OfQ at_)),
    (in_convolution p q (OfP, at_)), (in_convolution p q (OfQ, at_)); cbn in e; try discriminate e;
    intuition discriminate.
Qed.
