(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* What the checker's links and roots mean (`all_reached` in checker.v): if all pieces are reached, then what holds between
   pieces with a common corner, and is an equivalence, holds between every piece and one of the roots. Numbers of pieces
   are the places in their list. *)
From Coq Require Import QArith ZArith Lia Bool List FMapPositive.
From Oplus Require Import specification checker.
Import ListNotations.

Lemma find_added {A} (n m : positive) (t : A) (pieces : PositiveMap.t A) :
  PositiveMap.find m (PositiveMap.add n t pieces) = if Pos.eqb m n then Some t else PositiveMap.find m pieces.
Proof. destruct (Pos.eqb_spec m n) as [-> |]; [apply PositiveMap.gss | now apply PositiveMap.gso]. Qed.

Lemma numbers_are_from {A} (pieces : list A) : forall n i t,
  PositiveMap.find i (numbers_from n pieces) = Some t -> (n <= i)%positive /\ In t pieces.
Proof.
  induction pieces as [| u rest IH]; intros n i t; cbn [numbers_from].
  - now rewrite PositiveMap.gempty.
  - rewrite find_added. destruct (Pos.eqb_spec i n) as [-> |]; intros found.
    + injection found as ->. split; [apply Pos.le_refl | now left].
    + destruct (IH _ _ _ found) as [later I]. split; [lia | now right].
Qed.

Lemma all_have_numbers (pieces : list piece) : forall n t,
  In t pieces -> exists i, PositiveMap.find i (numbers_from n pieces) = Some t.
Proof.
  induction pieces as [| u rest IH]; intros n t; [easy |]. cbn [numbers_from]. intros [<- | I].
  - exists n. apply PositiveMap.gss.
  - destruct (IH (Pos.succ n) t I) as (i & found). exists i. rewrite find_added.
    destruct (Pos.eqb_spec i n) as [-> |]; [| exact found].
    apply numbers_are_from in found. lia.
Qed.

Section Reached.
  Variables (pieces : list piece) (first_number : positive) (starts : list positive).
  Variable connected : piece -> piece -> Prop.

  Hypothesis connected_itself : forall t, connected t t.
  Hypothesis connected_exchanged : forall t u, connected t u -> connected u t.
  Hypothesis connected_on : forall t u v, connected t u -> connected u v -> connected t v.
  Hypothesis connected_by_a_corner : forall t u, In t pieces -> In u pieces ->
    have_a_common_corner t u = true -> connected t u.

  Let all := numbers_from first_number pieces.

  (* What is reached is connected with the root it is said to be reached from. *)
  Definition is_right (reached : reached_pieces) : Prop := forall n root, PositiveMap.find n reached = Some root ->
    (exists i, In i starts /\ PositiveMap.find i all = Some root) /\
    exists t, PositiveMap.find n all = Some t /\ connected t root.

  Lemma right_at_start (some : list positive) : incl some starts -> forall reached, is_right reached ->
    is_right (fold_left (start_at_root all) some reached).
  Proof.
    induction some as [| i some IH]; intros those reached right_; [exact right_ |]. cbn [fold_left].
    apply IH; [intros j J; apply those; now right |]. unfold start_at_root.
    destruct (PositiveMap.find i all) as [t |] eqn:found; [| exact right_].
    intros n root. rewrite find_added. destruct (Pos.eqb_spec n i) as [-> |]; [| now apply right_].
    intros [= <-]. split.
    - exists i. split; [apply those; now left | exact found].
    - exists t. now split.
  Qed.

  Lemma right_by_links (those : list (positive * positive)) : forall reached, is_right reached ->
    is_right (fold_left (reach all) those reached).
  Proof.
    induction those as [| [i j] those IH]; intros reached right_; [exact right_ |]. cbn [fold_left].
    apply IH. unfold reach. cbn [fst snd].
    destruct (PositiveMap.find i reached) as [root |] eqn:from_; [| exact right_].
    destruct (PositiveMap.find i all) as [t |] eqn:found_t; [| exact right_].
    destruct (PositiveMap.find j all) as [u |] eqn:found_u; [| exact right_].
    destruct (have_a_common_corner t u) eqn:common; [| exact right_].
    intros n other_root. rewrite find_added. destruct (Pos.eqb_spec n j) as [-> |]; [| now apply right_].
    intros [= <-]. destruct (right_ i root from_) as [start (t' & found & t_root)]. split; [exact start |].
    exists u. split; [exact found_u |]. rewrite found_t in found. injection found as <-.
    apply (connected_on u t); [| exact t_root]. apply connected_exchanged, connected_by_a_corner; [.. | exact common].
    - now apply numbers_are_from in found_t.
    - now apply numbers_are_from in found_u.
  Qed.

  (* Theorem. *)
  Theorem reached_from_a_root (those : list (positive * positive)) :
    are_all_reached all (all_reached all starts those) = true ->
    forall t, In t pieces -> exists i root, In i starts /\ PositiveMap.find i all = Some root /\ connected t root.
  Proof.
    unfold are_all_reached. rewrite forallb_forall. intros reached t I.
    destruct (all_have_numbers pieces first_number t I) as (n & found). fold all in found.
    specialize (reached (n, t) (PositiveMap.elements_correct _ _ found)). cbn [fst] in reached.
    rewrite PositiveMap.mem_find in reached.
    destruct (PositiveMap.find n (all_reached all starts those)) as [root |] eqn:from_; [| discriminate].
    assert (right_ : is_right (all_reached all starts those)).
    { apply right_by_links, right_at_start; [apply incl_refl |]. intros m u. now rewrite PositiveMap.gempty. }
    destruct (right_ n root from_) as [(i & start & found_root) (t' & found' & t_root)].
    rewrite found in found'. injection found' as <-. now exists i, root.
  Qed.
End Reached.
