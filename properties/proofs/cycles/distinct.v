(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Lists without repetition; what holds of any two members of a list. *)
From Coq Require Import Bool List Permutation Lia.
Import ListNotations.

Lemma NoDup_of_two A (l m : list A) : NoDup l -> NoDup m -> (forall a, In a l -> ~ In a m) -> NoDup (l ++ m).
Proof.
  intros L M apart. induction L as [| a l N L IH]; [exact M |].
  cbn. constructor.
  - rewrite in_app_iff. intros [I | I]; [tauto |]. apply (apart a); [now left | exact I].
  - apply IH. intros b I. apply apart. now right.
Qed.

Lemma NoDup_second A (l m : list A) : NoDup (l ++ m) -> NoDup m.
Proof. induction l as [| a l IH]; intros L; [exact L |]. apply IH. now inversion L. Qed.

Lemma NoDup_images A B (f : A -> B) (l : list A) :
  NoDup l -> (forall a b, In a l -> In b l -> f a = f b -> a = b) -> NoDup (map f l).
Proof.
  intros L. induction L as [| a l N L IH]; intros injective; [constructor |].
  cbn. constructor.
  - rewrite in_map_iff. intros (b & e & I). apply N.
    rewrite <- (injective b a); trivial; [now right | now left].
  - apply IH. intros b c I J. apply injective; now right.
Qed.

Lemma NoDup_list_prod A B (l : list A) (m : list B) : NoDup l -> NoDup m -> NoDup (list_prod l m).
Proof.
  intros L M. induction L as [| a l N L IH]; [constructor |]. cbn.
  apply NoDup_of_two; trivial.
  - apply NoDup_images; trivial. now intros b c _ _ [= ->].
  - intros [x y] I J. apply in_map_iff in I. destruct I as (b & [= -> ->] & _).
    apply in_prod_iff in J. tauto.
Qed.

(* A map of a list to itself that sends no two elements to one sends something to each. *)
Lemma injective_permutes A (f : A -> A) (l : list A) :
  NoDup l -> (forall a, In a l -> In (f a) l) ->
  (forall a b, In a l -> In b l -> f a = f b -> a = b) ->
  Permutation (map f l) l.
Proof.
  intros L stays injective. apply NoDup_Permutation_bis.
  - now apply NoDup_images.
  - now rewrite map_length.
  - intros b I. apply in_map_iff in I. destruct I as (a & <- & I). now apply stays.
Qed.

Fixpoint all_pairs {A : Type} (test : A -> A -> bool) (l : list A) : bool :=
  match l with [] => true | a :: rest => forallb (test a) rest && all_pairs test rest end.

Lemma all_pairs_sound {A : Type} (test : A -> A -> bool) (holds : A -> A -> Prop) (l : list A) :
  (forall a b, test a b = true -> holds a b) -> all_pairs test l = true -> ForallOrdPairs holds l.
Proof.
  intros sound. induction l as [| a l IH]; intros all; constructor; cbn [all_pairs] in all;
    apply andb_prop in all; destruct all as [first rest].
  - rewrite forallb_forall in first. apply Forall_forall. auto.
  - now apply IH.
Qed.

Lemma pair_at {A : Type} (related : A -> A -> Prop) (earlier later : list A) (s t : A) :
  ForallOrdPairs related (earlier ++ s :: later) -> In t (earlier ++ later) -> related s t \/ related t s.
Proof.
  induction earlier as [| a earlier IH]; intros pairs I; cbn [app] in *; inversion pairs as [| ? ? first rest]; subst.
  - left. rewrite Forall_forall in first. now apply first.
  - destruct I as [<- | I]; [| now apply IH]. right.
    rewrite Forall_forall in first. apply first, in_app_iff. right. now left.
Qed.
