(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* What holds for all small enough positive numbers: small moves, turns and shifts are about such. *)
From Coq Require Import List.
From Oplus Require Import numbers.
Import ListNotations.

Open Scope Q_scope.

(* For all small enough epsilon. *)
Definition eventually (holds : Q -> Prop) : Prop :=
  exists bound, 0 < bound /\ forall epsilon, 0 < epsilon -> epsilon < bound -> holds epsilon.

Lemma eventually_and (A B : Q -> Prop) :
  eventually A -> eventually B -> eventually (fun epsilon => A epsilon /\ B epsilon).
Proof.
  intros (a & pa & ha) (b & pb & hb). exists (Qmin a b). split.
  - now apply Q.min_glb_lt.
  - intros e p l. pose proof (Q.le_min_l a b). pose proof (Q.le_min_r a b).
    split; [apply ha | apply hb]; lra.
Qed.

(* So for some number. *)
Lemma some_small (holds : Q -> Prop) : eventually holds -> exists epsilon, 0 < epsilon /\ holds epsilon.
Proof. intros (bound & some & near). exists ((1 # 2) * bound). split; [lra |]. apply near; lra. Qed.

Lemma eventually_below (limit : Q) : 0 < limit -> eventually (fun epsilon => 0 < epsilon /\ epsilon < limit).
Proof. intros some. exists limit. now split. Qed.

Lemma eventually_squared (holds : Q -> Prop) :
  eventually holds -> eventually (fun epsilon => holds (epsilon * epsilon)).
Proof.
  intros (bound & some & near). exists (Qmin 1 bound). split; [apply Q.min_glb_lt; lra |]. intros e positive_ less.
  pose proof (Q.le_min_l 1 bound). pose proof (Q.le_min_r 1 bound). apply near; nra.
Qed.

Lemma eventually_implied (A B : Q -> Prop) : (forall epsilon, A epsilon -> B epsilon) -> eventually A -> eventually B.
Proof. intros i (a & p & h). exists a. auto. Qed.

Lemma eventually_for_all {A : Type} (holds : A -> Q -> Prop) (l : list A) :
  (forall a, In a l -> eventually (holds a)) ->
  eventually (fun epsilon => forall a, In a l -> holds a epsilon).
Proof.
  induction l as [| a l IH]; intros each.
  - exists 1. split; [lra |]. intros e _ _ a [].
  - refine (eventually_implied _ _ _
              (eventually_and _ _ (each a (or_introl eq_refl)) (IH (fun b I => each b (or_intror I))))).
    intros e [here there] b [<- | I]; auto.
Qed.

(* A linear change that is small does not reach zero. *)
Lemma eventually_positive (a b : Q) : 0 < a -> eventually (fun epsilon => 0 < a + epsilon * b).
Proof.
  intros some. destruct (Qlt_le_dec b 0) as [less | more].
  - exists (a / - b). assert (value : a / - b * - b == a) by (field; lra).
    split; [apply Qlt_shift_div_l; lra |]. intros e _ below. nra.
  - exists 1. split; [lra |]. intros e positive _. nra.
Qed.

(* Adding small multiples of a number, one leaves every number. *)
Lemma leaves_a_number (a b c : Q) : ~ b == 0 -> eventually (fun epsilon => ~ a + epsilon * b == c).
Proof.
  intros some. destruct (Q_dec a c) as [[below | above] | equal].
  - refine (eventually_implied _ _ _ (eventually_positive (c - a) (- b) _)); [intros e | ]; lra.
  - refine (eventually_implied _ _ _ (eventually_positive (a - c) b _)); [intros e | ]; lra.
  - exists 1. split; [lra |]. intros e positive _ still. apply some.
    apply (Qmult_inj_l _ _ e); lra.
Qed.
