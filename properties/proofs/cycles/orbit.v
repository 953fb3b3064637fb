(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Iterating an injective map of a finite set to itself returns to the start. *)
From Coq Require Import List Permutation Lia Arith.
From Oplus Require Import distinct.
Import ListNotations.

Section orbit.

Context {A : Type} (decide : forall a b : A, {a = b} + {a <> b}) (f : A -> A) (l : list A).

(* f maps the list to itself, and no two of its elements to one. *)
Definition self_injection : Prop :=
  NoDup l /\ (forall a, In a l -> In (f a) l) /\
  (forall a b, In a l -> In b l -> f a = f b -> a = b).

Fixpoint iterated (k : nat) (a : A) : A := match k with 0 => a | S k => f (iterated k a) end.

(* The first k of a, f a, f (f a), and so on. *)
Definition first_of_orbit (k : nat) (a : A) : list A := map (fun i => iterated i a) (seq 0 k).

Lemma iterated_once_more k a : iterated k (f a) = iterated (S k) a.
Proof. induction k as [| k IH]; [reflexivity |]. cbn. now rewrite IH. Qed.

Lemma first_of_orbit_cons k a : first_of_orbit (S k) a = a :: first_of_orbit k (f a).
Proof.
  unfold first_of_orbit. cbn [seq map iterated]. f_equal. rewrite <- seq_shift, map_map.
  apply map_ext. intros i. symmetry. apply iterated_once_more.
Qed.

Lemma in_first_of_orbit k a b : In b (first_of_orbit k a) <-> exists i, i < k /\ b = iterated i a.
Proof.
  unfold first_of_orbit. rewrite in_map_iff. split.
  - intros (i & <- & I). apply in_seq in I. exists i. split; [lia | reflexivity].
  - intros (i & I & ->). exists i. rewrite in_seq. split; [reflexivity | lia].
Qed.

Lemma first_of_orbit_length k a : length (first_of_orbit k a) = k.
Proof. unfold first_of_orbit. rewrite map_length. apply seq_length. Qed.

Lemma iterated_in k a : self_injection -> In a l -> In (iterated k a) l.
Proof. intros (_ & stays & _) I. induction k as [| k IH]; [exact I |]. cbn. apply stays, IH. Qed.

Lemma iterated_cancel i k a : self_injection -> In a l -> iterated (i + k) a = iterated i a -> iterated k a = a.
Proof.
  intros s I. induction i as [| i IH]; intros e; [exact e |]. cbn in e. apply IH.
  pose proof s as (_ & _ & injective). apply injective; trivial; now apply iterated_in.
Qed.

(* If a is not met again before step k, the first k are distinct. *)
Lemma first_of_orbit_NoDup k a :
  self_injection -> In a l -> (forall i, 0 < i < k -> iterated i a <> a) ->
  NoDup (first_of_orbit k a).
Proof.
  intros s I apart. unfold first_of_orbit.
  apply NoDup_images; [apply seq_NoDup |]. intros i j IK JK e. rewrite in_seq in IK, JK.
  destruct (lt_eq_lt_dec i j) as [[c | c] | c]; trivial; exfalso.
  - apply (apart (j - i)); [lia |]. apply (iterated_cancel i); trivial.
    now replace (i + (j - i)) with j by lia.
  - apply (apart (i - j)); [lia |]. apply (iterated_cancel j); trivial.
    now replace (j + (i - j)) with i by lia.
Qed.

Lemma first_within (holds : nat -> Prop) :
  (forall k, {holds k} + {~ holds k}) ->
  forall k, {i : nat | i < k /\ holds i /\ forall j, j < i -> ~ holds j} +
            {forall i, i < k -> ~ holds i}.
Proof.
  intros decide_holds k. induction k as [| k [(i & I & h & none) | none]].
  - right. lia.
  - left. exists i. repeat split; trivial. lia.
  - destruct (decide_holds k) as [h | n].
    + left. exists k. repeat split; trivial. lia.
    + right. intros i I. destruct (Nat.eq_dec i k) as [-> | d]; [exact n | apply none; lia].
Qed.

(* Back at a after no more steps than there are elements. *)
Theorem orbit_returns a : self_injection -> In a l -> exists k, 0 < k <= length l /\ iterated k a = a.
Proof.
  intros s I.
  destruct (first_within (fun k => iterated (S k) a = a) (fun k => decide _ _) (length l))
    as [(k & K & e & _) | none].
  - exists (S k). split; [lia | exact e].
  - exfalso.
    assert (NoDup (first_of_orbit (S (length l)) a)) as distinct.
    { apply first_of_orbit_NoDup; trivial. intros i J. destruct i as [| i]; [lia |]. apply none. lia. }
    apply NoDup_incl_length with (l' := l) in distinct.
    + rewrite first_of_orbit_length in distinct. lia.
    + intros b J. apply in_first_of_orbit in J. destruct J as (i & _ & ->). now apply iterated_in.
Qed.

End orbit.
