(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* before is a strict linear order of the labelled directions, ccw the strict cyclic order that it
   closes to. *)
From Coq Require Import Bool.
From Oplus Require Import numbers direction angle.

Open Scope Q_scope.

(* Where an angle is shared, that of Q comes later. *)
Definition place (d : direction) : Q := match of d with OfP => 0 | OfQ => 1 end.

Definition earlier (a b : direction) : Prop :=
  angle (vec a) < angle (vec b) \/ (angle (vec a) == angle (vec b) /\ place a < place b).

Definition equal (a b : direction) : Prop :=
  angle (vec a) == angle (vec b) /\ place a == place b.

(* Linear arithmetic over angles and places decides what follows from the linear order. *)
Ltac order := unfold earlier, equal in *; lra.

Lemma place_of (a b : direction) : place a == place b <-> of a = of b.
Proof. unfold place. destruct (of a), (of b); split; (discriminate || reflexivity || lra). Qed.

Lemma compare_spec (a b : direction) :
  proper a -> proper b -> CompareSpec (equal a b) (earlier a b) (earlier b a) (compare a b).
Proof.
  intros m n. unfold compare, place, earlier, equal. rewrite compare_angle_is by assumption.
  destruct (Qcompare_spec (angle (vec a)) (angle (vec b))); [| constructor; lra..].
  unfold place. destruct (of a), (of b); constructor; lra.
Qed.

Ltac compared a b :=
  let c := fresh "c" in
  assert (c : CompareSpec (equal a b) (earlier a b) (earlier b a) (compare a b))
    by (now apply compare_spec);
  apply CompareSpec2Type in c; destruct c.

Lemma before_spec (a b : direction) : proper a -> proper b -> reflect (earlier a b) (before a b).
Proof. intros m n. unfold before. compared a b; constructor; order. Qed.

Lemma same_spec (a b : direction) : proper a -> proper b -> reflect (equal a b) (same a b).
Proof. intros m n. unfold same. compared a b; constructor; order. Qed.

Lemma earlier_total (a b : direction) : earlier a b \/ equal a b \/ earlier b a.
Proof. order. Qed.

(* Going round from the positive x-axis, the three are met in this order, or in one that starts with
   the second or the third of them. *)
Definition in_order (a b c : direction) : Prop :=
  (earlier a b /\ earlier b c) \/ (earlier b c /\ earlier c a) \/ (earlier c a /\ earlier a b).

Lemma ccw_spec (d from to : direction) :
  proper d -> proper from -> proper to -> reflect (in_order from d to) (ccw d from to).
Proof.
  intros l m n. unfold ccw, in_order.
  destruct (before_spec from d m l), (before_spec d to l n); compared from to;
    constructor; order.
Qed.

(* ccw(d, from, to) is a strict cyclic order of the directions of P and Q, ties told apart:
   - of three that are met in this order going round, each may be named first;
   - going round the other way they are not met in this order;
   - orders combine: if b is met between a and c, and c between a and d, then b is met between a and d;
   - any three of which no two are equal directions of one summand are met in one of the two orders;
   - two equal directions of one summand are never met with anything between. *)
Theorem ccw_is_a_cyclic_order :
  (forall a b c, proper a -> proper b -> proper c -> ccw b a c = true -> ccw c b a = true) /\
  (forall a b c, proper a -> proper b -> proper c -> ccw b a c = true -> ccw c a b = false) /\
  (forall a b c d, proper a -> proper b -> proper c -> proper d ->
     ccw b a c = true -> ccw c a d = true -> ccw b a d = true) /\
  (forall a b c, proper a -> proper b -> proper c ->
     same a b = false -> same b c = false -> same a c = false ->
     ccw b a c = true \/ ccw c a b = true) /\
  (forall a b c, proper a -> proper b -> proper c ->
     same a b = true \/ same b c = true \/ same a c = true -> ccw b a c = false).
Proof.
  repeat split.
  - intros a b c l m n. destruct (ccw_spec b a c), (ccw_spec c b a); trivial.
    unfold in_order in *. intros _. exfalso. order.
  - intros a b c l m n. destruct (ccw_spec b a c), (ccw_spec c a b); try easy.
    unfold in_order in *. intros _. exfalso. order.
  - intros a b c d k l m n. destruct (ccw_spec b a c), (ccw_spec c a d), (ccw_spec b a d); try easy.
    unfold in_order in *. intros _ _. exfalso. order.
  - intros a b c l m n.
    destruct (same_spec a b), (same_spec b c), (same_spec a c), (ccw_spec b a c), (ccw_spec c a b);
      trivial; try discriminate; try tauto.
    unfold in_order in *. intros _ _ _. exfalso. order.
  - intros a b c l m n.
    destruct (same_spec a b), (same_spec b c), (same_spec a c), (ccw_spec b a c); trivial;
      unfold in_order in *; intros [? | [? | ?]]; try discriminate; exfalso; order.
Qed.
