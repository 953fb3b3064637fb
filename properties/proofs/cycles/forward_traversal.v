(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Lemma 4.1.3 at one vertex of P and one vertex of Q, for any four edges. *)
From Coq Require Import PeanoNat ZArith Bool Lia.
From Oplus Require Import numbers directions tangent_set angular_crossings.

Open Scope Q_scope.

(* None of the edges is the zero vector. Edges may be equal, or turn back. *)
Definition proper_corner (c : corner) : Prop := nonzero (incoming c) /\ nonzero (outgoing c).

(* Whether the edge of P, or of Q, that enters the state, or leaves it, is in the convolution there. *)
Definition p_enters (of_p of_q : corner) : bool := in_tangent_set (Direction (incoming of_p) OfP) of_q.
Definition q_enters (of_p of_q : corner) : bool := in_tangent_set (Direction (incoming of_q) OfQ) of_p.
Definition p_leaves (of_p of_q : corner) : bool := in_tangent_set (Direction (outgoing of_p) OfP) of_q.
Definition q_leaves (of_p of_q : corner) : bool := in_tangent_set (Direction (outgoing of_q) OfQ) of_p.

Definition entering (of_p of_q : corner) : nat :=
  Nat.b2n (p_enters of_p of_q) + Nat.b2n (q_enters of_p of_q).
Definition leaving (of_p of_q : corner) : nat :=
  Nat.b2n (p_leaves of_p of_q) + Nat.b2n (q_leaves of_p of_q).

Lemma before_other_way (a b : direction) :
  proper a -> proper b -> of a <> of b -> Z.b2z (before b a) = (1 - Z.b2z (before a b))%Z.
Proof.
  intros m n o. assert (~ place a == place b) by (now rewrite place_of).
  destruct (before_spec a b m n), (before_spec b a n m); trivial; exfalso; order.
Qed.

(* Equal directions of one summand cannot be told apart. *)
Lemma before_equal (a b d : direction) :
  proper a -> proper b -> proper d -> equal a b ->
  before a d = before b d /\ before d a = before d b.
Proof.
  intros l m n e.
  destruct (before_spec a d l n), (before_spec b d m n), (before_spec d a n l), (before_spec d b n m);
    split; trivial; exfalso; order.
Qed.

Lemma ccw_of_equal (a b c d : direction) :
  proper a -> proper b -> proper c -> proper d -> equal a b ->
  ccw c a b = false /\ ccw a c d = ccw b c d.
Proof.
  intros ma mb mc md e. split.
  - unfold ccw. compared a b; trivial; exfalso; order.
  - unfold ccw.
    destruct (before_equal a b c ma mb mc e) as [_ ->], (before_equal a b d ma mb md e) as [-> _].
    reflexivity.
Qed.

Lemma compare_equal (a b : direction) : proper a -> proper b -> equal a b \/ compare a b <> Eq.
Proof. intros m n. compared a b; [now left | right | right]; discriminate. Qed.

(* As many of the two edges of P's vertex are between those of Q's, and of Q's between P's, on the way
   in as on the way out: whatever the four directions are, ties told apart. *)
Lemma as_many_between (a b c d : direction) :
  proper a -> proper b -> proper c -> proper d ->
  of a = OfP -> of b = OfP -> of c = OfQ -> of d = OfQ ->
  (Z.b2z (ccw a c d) + Z.b2z (ccw c a b) = Z.b2z (ccw b c d) + Z.b2z (ccw d a b))%Z.
Proof.
  intros ma mb mc md oa ob oc od.
  destruct (compare_equal a b ma mb) as [e | ab].
  { destruct (ccw_of_equal a b c d ma mb mc md e) as [-> ->].
    destruct (ccw_of_equal a b d c ma mb md mc e) as [-> _]. lia. }
  destruct (compare_equal c d mc md) as [e | cd].
  { destruct (ccw_of_equal c d a b mc md ma mb e) as [-> ->].
    destruct (ccw_of_equal c d b a mc md mb ma e) as [-> _]. lia. }
  rewrite !ccw_as_difference; try congruence.
  pose proof (before_other_way a c). pose proof (before_other_way a d).
  pose proof (before_other_way b c). pose proof (before_other_way b d).
  rewrite H, H0, H1, H2 by congruence. lia.
Qed.

Lemma as_many_leave_as_enter (of_p of_q : corner) :
  proper_corner of_p -> proper_corner of_q -> entering of_p of_q = leaving of_p of_q.
Proof.
  intros [m n] [m' n'].
  pose proof (as_many_between (Direction (incoming of_p) OfP) (Direction (outgoing of_p) OfP)
                              (Direction (incoming of_q) OfQ) (Direction (outgoing of_q) OfQ)
                              m n m' n' eq_refl eq_refl eq_refl eq_refl) as e.
  unfold entering, leaving, p_enters, q_enters, p_leaves, q_leaves, in_tangent_set. cbn [of other].
  destruct (ccw _ _ _), (ccw _ _ _), (ccw _ _ _), (ccw _ _ _); cbn in *; lia.
Qed.

(* Lemma 4.1.3, and more. P's vertex has any two edges, Q's has any two edges; they may be equal to each
   other, opposite, or equal across P and Q, where the tie rule decides. As many of the two segments
   that could enter the state are in the convolution as of the two that could leave it. So
   (1) if one enters, one leaves; (2) two leave if and only if two enter. *)
Theorem forward_traversal (of_p of_q : corner) :
  proper_corner of_p -> proper_corner of_q ->
  entering of_p of_q = leaving of_p of_q /\
  (p_enters of_p of_q = true \/ q_enters of_p of_q = true ->
   p_leaves of_p of_q = true \/ q_leaves of_p of_q = true) /\
  (p_leaves of_p of_q = true /\ q_leaves of_p of_q = true <->
   p_enters of_p of_q = true /\ q_enters of_p of_q = true).
Proof.
  intros m n. pose proof (as_many_leave_as_enter of_p of_q m n) as e. split; [exact e |].
  unfold entering, leaving in e.
  destruct (p_enters of_p of_q), (q_enters of_p of_q), (p_leaves of_p of_q), (q_leaves of_p of_q);
    cbn in e; try discriminate e; intuition discriminate.
Qed.
