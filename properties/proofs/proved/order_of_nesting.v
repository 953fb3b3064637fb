(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* What goes round what, of finitely many things, as chains that do not cross: of two that go round a third, one goes
   round the other. All together they go round one that runs counterclockwise 0 times, and round a clockwise one once:
   so directly around a clockwise one is a counterclockwise one, and the other way round. Then no two holes of one
   outer chain go round each other, and an outer chain with its holes goes 0 times round what is not its own. Chains
   are in nested_chains.v. *)
From Coq Require Import ZArith Lia Bool List.
From Oplus Require Import angular_crossings.
Import ListNotations.

Open Scope Z_scope.

(* Of those with a property, the first one by a relation. *)
Lemma first_by {T : Type} (P : T -> Prop) (before : T -> T -> Prop) (l : list T) :
  (forall x y : T, {x = y} + {x <> y}) -> (forall x, {P x} + {~ P x}) ->
  (forall x y, P x -> P y -> x <> y -> before x y \/ before y x) ->
  (forall x y z, P x -> P y -> P z -> before x y -> before y z -> before x z) ->
  Exists P l -> exists m, P m /\ forall x, In x l -> P x -> x <> m -> before x m.
Proof.
  intros same decided total through. induction l as [| a l IH]; intros some; [now apply Exists_nil in some |].
  assert (alone : (forall x, In x l -> P x -> x <> a -> before x a) -> P a -> exists m, P m /\
    forall x, In x (a :: l) -> P x -> x <> m -> before x m).
  { intros all holds. exists a. split; [exact holds |]. intros x [<- | X] x_holds other; [contradiction | auto]. }
  destruct (Exists_dec P l decided) as [some' | none].
  - destruct (IH some') as (m & holds & first).
    assert (still : (P a -> a <> m -> before a m) -> exists m, P m /\
      forall x, In x (a :: l) -> P x -> x <> m -> before x m)
      by (intros a_first; exists m; split; [exact holds | intros x [<- | X]; auto]).
    destruct (decided a) as [yes | no]; [| apply still; intros yes; contradiction].
    destruct (same a m) as [-> | differ]; [apply still; contradiction |].
    destruct (total a m yes holds differ) as [| later]; [now apply still |]. apply alone; [| exact yes].
    intros x X x_holds other. destruct (same x m) as [-> | other']; [exact later | apply (through x m a); auto].
  - apply Exists_cons in some. destruct some as [yes | some]; [| contradiction]. apply alone; [| exact yes].
    intros x X x_holds. destruct none. apply Exists_exists. now exists x.
Qed.

(* Sums that differ in one number. *)
Lemma sums_differ_by {T : Type} (f g : T -> Z) (m : T) (l : list T) : NoDup l -> In m l ->
  (forall x, In x l -> x <> m -> f x = g x) -> sum (map f l) + g m = sum (map g l) + f m.
Proof.
  intros once I alike. destruct (in_split _ _ I) as (before & after & ->).
  rewrite (sums_but_for_one _ f g before m after); [lia |]. apply NoDup_remove_2 in once. intros x X. apply alike.
  - apply in_app_iff. apply in_app_iff in X. cbn. tauto.
  - intros ->. contradiction.
Qed.

Section Order.
  Context {T : Type}.
  Variable same : forall x y : T, {x = y} + {x <> y}.
  Variable all : list T.
  Hypothesis distinct_ : NoDup all.
  Variable number : T -> T -> Z.
  Variable counterclockwise : T -> bool.

  Definition is_round (a b : T) : Prop := In a all /\ In b all /\ number a b <> 0.

  Hypothesis not_itself : forall a, number a a = 0.
  Hypothesis number_is : forall a b, is_round a b -> number a b = if counterclockwise a then 1 else -1.
  Hypothesis one_way : forall a b, is_round a b -> ~ is_round b a.
  Hypothesis through : forall a b c, is_round a b -> is_round b c -> is_round a c.
  Hypothesis in_line : forall a b c, is_round a c -> is_round b c -> a <> b -> is_round a b \/ is_round b a.
  Hypothesis together : forall b, In b all -> sum (map (fun a => number a b) all) = if counterclockwise b then 0 else 1.

  Definition directly_round (a b : T) : Prop := is_round a b /\ forall c, is_round c b -> c <> a -> is_round c a.

  Lemma round_or_not (a b : T) : {is_round a b} + {~ is_round a b}.
  Proof.
    unfold is_round. destruct (in_dec same a all), (in_dec same b all), (Z.eq_dec (number a b) 0); tauto.
  Qed.

  Lemma not_round (a b : T) : In a all -> In b all -> ~ is_round a b -> number a b = 0.
  Proof. intros A B no. destruct (Z.eq_dec (number a b) 0) as [| other]; [assumption |]. destruct no. now split. Qed.

  Lemma not_round_itself (a : T) : ~ is_round a a.
  Proof. intros itself. exact (one_way a a itself itself). Qed.

  Lemma directions_alternate (a b : T) : directly_round a b -> counterclockwise a = negb (counterclockwise b).
  Proof.
    intros [round first]. pose proof round as (A & B & _).
    assert (more : sum (map (fun c => number c b) all) + number a a = sum (map (fun c => number c a) all) + number a b).
    { apply (sums_differ_by (fun c => number c b) (fun c => number c a)); trivial.
      intros c C other. destruct (round_or_not c b) as [yes | no].
      - pose proof (first c yes other) as yes'. now rewrite (number_is _ _ yes), (number_is _ _ yes').
      - rewrite (not_round c b C B no), (not_round c a C A); [reflexivity |].
        intros yes. apply no. now apply (through c a b). }
    rewrite (together b B), (together a A), not_itself, (number_is a b round) in more.
    destruct (counterclockwise a), (counterclockwise b); trivial; lia.
  Qed.

  (* Directly around a clockwise one is a counterclockwise one. *)
  Lemma outer_of_hole (h : T) : In h all -> counterclockwise h = false ->
    exists a, directly_round a h /\ counterclockwise a = true.
  Proof.
    intros H clockwise.
    destruct (first_by (fun a => is_round a h) is_round all same) as (a & round & first).
    - intros x. apply round_or_not.
    - intros x y X Y. now apply (in_line x y h).
    - intros x y z _ _ _. apply through.
    - destruct (Exists_dec (fun a => is_round a h) all (fun a => round_or_not a h)) as [| none]; [assumption | exfalso].
      pose proof (together h H) as once. rewrite clockwise, sum_of_zeros in once; [discriminate |].
      intros a A. apply not_round; trivial. intros round. apply none, Exists_exists. now exists a.
    - assert (direct : directly_round a h) by (split; [exact round | intros c C; apply first; [apply C | exact C]]).
      exists a. split; [exact direct |]. now rewrite (directions_alternate a h direct), clockwise.
  Qed.

  (* Two that have the same one directly around them do not go round each other. *)
  Lemma beside_within (c g h : T) : directly_round c g -> directly_round c h -> ~ is_round g h.
  Proof.
    intros [round_g _] [_ first] round. apply (one_way c g round_g), first; [exact round |].
    intros ->. exact (not_round_itself c round_g).
  Qed.

  (* Around what another one goes round, there is one which that goes round directly, or it is so itself. *)
  Lemma first_within_another (c x : T) : is_round c x -> exists g, (g = x \/ is_round g x) /\ directly_round c g.
  Proof.
    intros round. set (between g := (g = x \/ is_round g x) /\ is_round c g).
    destruct (first_by between (fun a b => is_round b a) all same) as (g & [which round_g] & first).
    - intros a. unfold between.
      destruct (same a x), (round_or_not a x), (round_or_not c a); tauto.
    - intros a b [[-> | A] _] [[-> | B] _] other; [contradiction | now left | now right |].
      destruct (in_line a b x A B other); tauto.
    - intros a b d _ _ _ B D. now apply (through d b a).
    - apply Exists_exists. exists x. split; [apply round |]. split; [now left | exact round].
    - exists g. split; [exact which |]. split; [exact round_g |]. intros b B other.
      destruct (in_line b c g B round_g other) as [| inside]; [assumption | exfalso]. apply (one_way b g B).
      apply first; [apply B | | intros ->; exact (not_round_itself g B)].
      split; [right; destruct which as [<- | which]; [exact B | now apply (through b g x)] | exact inside].
  Qed.

  (* Theorem. An outer chain and its holes go 0 times round what is not its own. *)
  Theorem components_are_beside (c x : T) (holes : list T) : In c all -> In x all -> x <> c ->
    NoDup holes -> (forall g, In g holes <-> counterclockwise g = false /\ directly_round c g) ->
    counterclockwise c = true -> ~ In x holes -> number c x + sum (map (fun g => number g x) holes) = 0.
  Proof.
    intros C X other once holes_are outer not_own. destruct (round_or_not c x) as [round | no].
    - destruct (first_within_another c x round) as (g & which & direct).
      pose proof (directions_alternate c g direct) as turned. rewrite outer in turned.
      assert (G : In g holes) by (apply holes_are; split; [now destruct (counterclockwise g) | exact direct]).
      destruct which as [-> | round_g]; [contradiction |].
      pose proof (sums_differ_by (fun h => number h x) (fun _ => 0) g holes once G) as one.
      rewrite (sum_of_zeros _ (fun _ => 0)), (number_is g x round_g) in one by reflexivity.
      rewrite (number_is c x round), outer. destruct (counterclockwise g); [discriminate |]. enough (alike : forall h,
        In h holes -> h <> g -> number h x = 0) by (specialize (one alike); lia).
      intros h H differ. pose proof (proj2 (proj1 (holes_are h) H)) as direct_h.
      refine (not_round h x (proj1 (proj2 (proj1 direct_h))) X _). intros round_h.
      destruct (in_line h g x round_h round_g differ) as [wrong | wrong]; revert wrong; now apply (beside_within c).
    - rewrite (not_round c x C X no), sum_of_zeros; [reflexivity |]. intros g G.
      pose proof (proj2 (proj1 (holes_are g) G)) as [round_g _].
      refine (not_round g x (proj1 (proj2 round_g)) X _). intros round. apply no. now apply (through c g x).
  Qed.
End Order.
