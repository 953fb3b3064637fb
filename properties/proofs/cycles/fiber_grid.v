(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Walks in the fiber grid (thesis, Definition 4.1.7): what every cycle crosses, and that none can be
   missed by starting in the first row and the first column. *)
From Coq Require Import Arith Lia Bool List.
From Oplus Require Import direction.
Import ListNotations.

Open Scope nat_scope.

(* A state: vertex i of P, of n vertices, at vertex j of Q, of m. *)
Definition state := (nat * nat)%type.

Definition next (i length : nat) : nat := if S i =? length then 0 else S i.

(* The state to which an edge of P, or one of Q, leads. *)
Definition step (n m : nat) (along : summand) (s : state) : state :=
  match along with OfP => (next (fst s) n, snd s) | OfQ => (fst s, next (snd s) m) end.

(* The states of a walk, but for its last, and its last. *)
Fixpoint passed (n m : nat) (s : state) (steps : list summand) : list state :=
  match steps with [] => [] | along :: rest => s :: passed n m (step n m along s) rest end.

Fixpoint arrived (n m : nat) (s : state) (steps : list summand) : state :=
  match steps with [] => s | along :: rest => arrived n m (step n m along s) rest end.

Definition is_of_p (along : summand) : bool := match along with OfP => true | OfQ => false end.

Definition steps_of_p (steps : list summand) : nat := length (filter is_of_p steps).
Definition steps_of_q (steps : list summand) : nat := length (filter (fun a => negb (is_of_p a)) steps).

Lemma next_is_modulo : forall i n k, i < n -> (next i n + k) mod n = (i + S k) mod n.
Proof.
  intros i n k L. unfold next. destruct (Nat.eqb_spec (S i) n) as [E | E].
  - replace (i + S k) with (k + 1 * n) by lia. rewrite Nat.mod_add by lia. reflexivity.
  - f_equal. lia.
Qed.

Lemma next_in_range : forall i n, i < n -> next i n < n.
Proof. intros i n L. unfold next. destruct (Nat.eqb_spec (S i) n); lia. Qed.

Lemma next_below i k : S i < k -> next i k = S i.
Proof. intros L. unfold next. destruct (Nat.eqb_spec (S i) k); lia. Qed.

Lemma next_last k : 0 < k -> next (k - 1) k = 0.
Proof. intros L. unfold next. destruct (Nat.eqb_spec (S (k - 1)) k); lia. Qed.

Lemma arrival_of_p : forall n m steps i j, i < n -> fst (arrived n m (i, j) steps) = (i + steps_of_p steps) mod n.
Proof.
  intros n m steps. induction steps as [| [|] rest IH]; intros i j L; cbn.
  - rewrite Nat.add_0_r, Nat.mod_small; trivial.
  - rewrite IH by now apply next_in_range. now rewrite next_is_modulo.
  - now rewrite IH.
Qed.

Lemma arrival_of_q : forall n m steps i j, j < m -> snd (arrived n m (i, j) steps) = (j + steps_of_q steps) mod m.
Proof.
  intros n m steps. induction steps as [| [|] rest IH]; intros i j L; cbn.
  - rewrite Nat.add_0_r, Nat.mod_small; trivial.
  - now rewrite IH.
  - rewrite IH by now apply next_in_range. now rewrite next_is_modulo.
Qed.

Lemma passed_of_p : forall n m steps i j k, i < n -> k < steps_of_p steps ->
  exists s, In s (passed n m (i, j) steps) /\ fst s = (i + k) mod n.
Proof.
  intros n m steps. induction steps as [| [|] rest IH]; intros i j k L K; cbn in K |- *; [lia | |].
  - destruct k as [| k].
    + exists (i, j). rewrite Nat.add_0_r, Nat.mod_small; auto.
    + destruct (IH (next i n) j k) as (s & I & E); [now apply next_in_range | unfold steps_of_p; lia |].
      exists s. split; [right; exact I |]. rewrite E. now apply next_is_modulo.
  - destruct (IH i (next j m) k L K) as (s & I & E). exists s. auto.
Qed.

Lemma passed_of_q : forall n m steps i j k, j < m -> k < steps_of_q steps ->
  exists s, In s (passed n m (i, j) steps) /\ snd s = (j + k) mod m.
Proof.
  intros n m steps. induction steps as [| [|] rest IH]; intros i j k L K; cbn in K |- *; [lia | |].
  - destruct (IH (next i n) j k L K) as (s & I & E). exists s. auto.
  - destruct k as [| k].
    + exists (i, j). rewrite Nat.add_0_r, Nat.mod_small; auto.
    + destruct (IH i (next j m) k) as (s & I & E); [now apply next_in_range | unfold steps_of_q; lia |].
      exists s. split; [right; exact I |]. rewrite E. now apply next_is_modulo.
Qed.

Lemma whole_rounds : forall i n a, i < n -> (i + a) mod n = i -> exists rounds, a = rounds * n.
Proof.
  intros i n a L E. exists ((i + a) / n).
  pose proof (Nat.div_mod (i + a) n) as D. nia.
Qed.

Lemma every_index : forall i n a, i < n -> n <= a -> forall k, k < n -> exists t, t < a /\ (i + t) mod n = k.
Proof.
  intros i n a L A k K. destruct (le_lt_dec i k).
  - exists (k - i). split; [lia |]. rewrite Nat.mod_small; lia.
  - exists (k + n - i). split; [lia |].
    replace (i + (k + n - i)) with (k + 1 * n) by lia. rewrite Nat.mod_add, Nat.mod_small; lia.
Qed.

Definition closed_walk (n m : nat) (start : state) (steps : list summand) : Prop :=
  fst start < n /\ snd start < m /\ steps <> [] /\ arrived n m start steps = start.

(* Theorem. A closed walk goes round the chain of P a whole number of times, and round that of Q. *)
Theorem closed_walks_go_round : forall n m start steps,
  closed_walk n m start steps ->
  (exists a, steps_of_p steps = a * n) /\ (exists b, steps_of_q steps = b * m) /\
  length steps = steps_of_p steps + steps_of_q steps.
Proof.
  intros n m [i j] steps (I & J & _ & E). cbn in I, J. repeat split.
  - apply (whole_rounds i); [exact I |]. rewrite <- (arrival_of_p n m steps i j I), E. reflexivity.
  - apply (whole_rounds j); [exact J |]. rewrite <- (arrival_of_q n m steps i j J), E. reflexivity.
  - clear. unfold steps_of_p, steps_of_q.
    induction steps as [| [|] rest IH]; cbn; rewrite ?IH; lia.
Qed.

(* Theorem. A closed walk passes every vertex of P, that is every column of the grid, or every vertex of
   Q, that is every row. *)
Theorem closed_walks_cross_the_grid : forall n m start steps,
  closed_walk n m start steps ->
  (forall i, i < n -> exists j, In (i, j) (passed n m start steps)) \/
  (forall j, j < m -> exists i, In (i, j) (passed n m start steps)).
Proof.
  intros n m start steps W. pose proof (closed_walks_go_round n m start steps W) as (A & B & L).
  destruct W as (I & J & N & _). destruct start as [i j]; cbn in I, J.
  destruct A as (a & A), B as (b & B).
  destruct (Nat.eq_dec a 0) as [-> | PA].
  - right. intros k K. assert (b <> 0) by (intros ->; destruct steps; [now apply N | rewrite A, B in L; cbn in L; lia]).
    destruct (every_index j m (steps_of_q steps) J) with (k := k) as (t & T & E); [nia | exact K |].
    destruct (passed_of_q n m steps i j t J T) as ([x y] & P & F).
    exists x. cbn in F. rewrite <- E, <- F. exact P.
  - left. intros k K.
    destruct (every_index i n (steps_of_p steps) I) with (k := k) as (t & T & E); [nia | exact K |].
    destruct (passed_of_p n m steps i j t I T) as ([x y] & P & F).
    exists y. cbn in F. rewrite <- E, <- F. exact P.
Qed.

(* An edge of the grid, named by the state that it leaves. *)
Definition grid_edge := (summand * state)%type.

(* Theorem. Take any edges of the grid of which each leads to a state that one of them leaves, as those do that are
   left over when cycles are taken away. If there are any, one of them leaves a state of the first row or the first
   column. So starting there, until nothing is left, misses none. *)
Theorem what_is_left_meets_the_first_row_or_column : forall n m (edges : list grid_edge),
  (forall along s, In (along, s) edges -> fst s < n /\ snd s < m) ->
  (forall along s, In (along, s) edges -> exists on, In (on, step n m along s) edges) ->
  edges <> [] ->
  exists along i j, In (along, (i, j)) edges /\ (i = 0 \/ j = 0).
Proof.
  intros n m edges R C N. destruct edges as [| [along s] rest] eqn:E; [now destruct N |].
  rewrite <- E in *. assert (F : In (along, s) edges) by (rewrite E; left; reflexivity).
  clear E N rest. remember (n + m - (fst s + snd s)) as distance eqn:D.
  revert along s F D. induction distance as [distance IH] using lt_wf_ind.
  intros along [i j] F D. cbn in D. pose proof (R along (i, j) F) as [I J]. cbn in I, J.
  destruct (C along (i, j) F) as (on & G).
  destruct (Nat.eq_dec i 0); [exists along, i, j; auto |].
  destruct (Nat.eq_dec j 0); [exists along, i, j; auto |].
  pose proof (R on _ G) as [I' J']. destruct along; cbn in G, I', J'; unfold next in *.
  - destruct (Nat.eqb_spec (S i) n); [exists on, 0, j; auto |].
    eapply IH; [| exact G | reflexivity]. cbn. lia.
  - destruct (Nat.eqb_spec (S j) m); [exists on, i, 0; auto |].
    eapply IH; [| exact G | reflexivity]. cbn. lia.
Qed.
