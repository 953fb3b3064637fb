(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Walks from segment to segment, until the start is reached again. If every point is left as often as it is entered,
   each walk closes, what it leaves over is like that again, and so all segments are on some chain. *)
From Coq Require Import QArith ZArith Lia Bool List Permutation.
From Oplus Require Import balanced_edges direction angular_crossings winding_number regions filling.
Import ListNotations.

(* The first of the segments that starts there, and the others. *)
Fixpoint taken_from (v : vector) (l : list segment) : option (segment * list segment) :=
  match l with
  | [] => None
  | e :: rest =>
    if vector_dec (source e) v then Some (e, rest)
    else match taken_from v rest with None => None | Some (f, others) => Some (f, e :: others) end
  end.

(* From segment to segment until the start is reached again; the segments that are left. *)
Fixpoint walk (fuel : nat) (start here : vector) (l : list segment) : list vector * list segment :=
  match fuel with
  | O => ([], l)
  | S fewer =>
    match taken_from here l with
    | None => ([], l)
    | Some (e, rest) =>
      if vector_dec (target e) start then ([here], rest)
      else let (chain, others) := walk fewer start (target e) rest in (here :: chain, others)
    end
  end.

Fixpoint chains_of (fuel : nat) (l : list segment) : list (list vector) :=
  match fuel, l with
  | S fewer, e :: _ => let (chain, others) := walk (length l) (source e) (source e) l in chain :: chains_of fewer others
  | _, _ => []
  end.

Open Scope Z_scope.

Definition one_if (v w : vector) : Z := if vector_dec v w then 1 else 0.
Definition surplus (v : vector) (l : list segment) : Z :=
  sum (map (fun e => one_if (source e) v - one_if (target e) v) l).
Definition is_balanced (l : list segment) : Prop := forall v, surplus v l = 0.

Lemma surplus_of_more (v : vector) (e : segment) (l : list segment) :
  surplus v (e :: l) = one_if (source e) v - one_if (target e) v + surplus v l.
Proof. reflexivity. Qed.

Lemma surplus_permuted (v : vector) (l m : list segment) : Permutation l m -> surplus v l = surplus v m.
Proof. unfold surplus, sum. intros permuted. induction permuted; cbn; lia. Qed.

Lemma taken_from_is (v : vector) (l : list segment) (e : segment) : forall rest,
  taken_from v l = Some (e, rest) -> source e = v /\ Permutation (e :: rest) l.
Proof.
  induction l as [| f l IH]; intros rest; cbn; [discriminate |].
  destruct (vector_dec (source f) v) as [is_v |]; [intros [= <- <-]; split; [exact is_v | reflexivity] |].
  destruct (taken_from v l) as [[g others] |]; [| discriminate]. intros [= <- <-].
  destruct (IH others eq_refl) as [is_v permuted]. split; [exact is_v |]. rewrite <- permuted. apply perm_swap.
Qed.

Lemma something_is_taken (v : vector) (l : list segment) : (exists e, In e l /\ source e = v) -> taken_from v l <> None.
Proof.
  induction l as [| f l IH]; intros (e & I & is_v); [destruct I |]. cbn.
  destruct (vector_dec (source f) v); [discriminate |]. destruct I as [-> | I]; [contradiction |].
  destruct (taken_from v l) as [[g others] |] eqn:taken; [discriminate |].
  exfalso. apply IH; [now exists e | reflexivity].
Qed.

Lemma something_leaves (v : vector) (l : list segment) : 0 < surplus v l -> exists e, In e l /\ source e = v.
Proof.
  induction l as [| e l IH]; [cbn; lia |]. rewrite surplus_of_more. intros some.
  unfold one_if in some. destruct (vector_dec (source e) v) as [is_v |]; [exists e; split; [now left | exact is_v] |].
  destruct IH as (f & F & is_v).
  - destruct (vector_dec (target e) v); lia.
  - exists f. split; [now right | exact is_v].
Qed.

(* From vertex to vertex, and to the end. *)
Fixpoint path (chain : list vector) (z : vector) : list segment :=
  match chain with [] => [] | a :: rest => Segment a (hd z rest) :: path rest z end.

Lemma path_is (chain : list vector) (z : vector) : forall first,
  path (first :: chain) z = map (fun ends => Segment (fst ends) (snd ends)) (combine (first :: chain) (chain ++ [z])).
Proof.
  induction chain as [| a chain IH]; intros first; [reflexivity |].
  change (path (first :: a :: chain) z) with (Segment first a :: path (a :: chain) z). now rewrite IH.
Qed.

Lemma walk_returns (start : vector) (fuel : nat) : forall here l, (length l <= fuel)%nat ->
  (forall v, surplus v l = one_if here v - one_if start v) -> (exists e, In e l /\ source e = here) ->
  exists rest others, walk fuel start here l = (here :: rest, others) /\ is_balanced others /\
    Permutation (path (here :: rest) start ++ others) l.
Proof.
  induction fuel as [| fuel IH]; intros here l enough_ counts some.
  - destruct some as (e & I & _). destruct l; [destruct I | cbn in enough_; lia].
  - cbn [walk]. pose proof (something_is_taken here l some) as taken_.
    destruct (taken_from here l) as [[e rest] |] eqn:taken; [| contradiction]. clear taken_.
    apply taken_from_is in taken. destruct taken as [is_here permuted].
    assert (counts_rest : forall v, surplus v rest = one_if (target e) v - one_if start v).
    { intros v. specialize (counts v). rewrite <- (surplus_permuted v _ _ permuted), surplus_of_more,
      is_here in counts. lia. }
    destruct (vector_dec (target e) start) as [returned | going].
    + exists [], rest. split; [reflexivity |]. split.
      * intros v. rewrite counts_rest, returned. lia.
      * cbn [path hd app]. rewrite <- permuted, <- is_here, <- returned. now destruct e.
    + destruct (IH (target e) rest) as (further & others & -> & balanced_ & all).
      * apply Permutation_length in permuted. cbn in permuted. lia.
      * exact counts_rest.
      * apply something_leaves. rewrite counts_rest. unfold one_if.
        destruct (vector_dec (target e) (target e)) as [_ |]; [| contradiction].
        destruct (vector_dec start (target e)); [congruence | lia].
      * exists (target e :: further), others. split; [reflexivity |]. split; [exact balanced_ |].
        change (path (here :: target e :: further) start) with
          (Segment here (target e) :: path (target e :: further) start).
        cbn [app]. rewrite all, <- permuted, <- is_here. now destruct e.
Qed.

Lemma chains_take_all (fuel : nat) : forall l, (length l <= fuel)%nat -> is_balanced l ->
  Permutation (region_edges (chains_of fuel l)) l.
Proof.
  induction fuel as [| fuel IH]; intros l enough_ balanced_.
  - destruct l; [reflexivity | cbn in enough_; lia].
  - destruct l as [| e l]; [reflexivity |]. cbn [chains_of].
    destruct (walk_returns (source e) (length (e :: l)) (source e) (e :: l)) as (rest & others & -> & balanced_others
      & all).
    + lia.
    + intros v. rewrite balanced_. lia.
    + exists e. split; [now left | reflexivity].
    + cbn [region_edges flat_map]. fold (region_edges (chains_of fuel others)).
      assert (fewer : (length others <= fuel)%nat).
      { apply Permutation_length in all. rewrite app_length in all. cbn [path length] in all, enough_. lia. }
      change (flat_map edges (chains_of fuel others)) with (region_edges (chains_of fuel others)).
      rewrite (IH others fewer balanced_others). etransitivity; [| exact all]. apply Permutation_app_tail.
      rewrite path_is. reflexivity.
Qed.
