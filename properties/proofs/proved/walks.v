(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Walks from segment to segment that turn clockwise most at each point (thesis, Definition 3.2.1), until the next one
   would be the first again. If every point is left as often as it is entered, each walk closes, what it leaves over is
   like that again, and so all segments are on some chain. *)
From Coq Require Import QArith ZArith Lia Bool List Permutation.
From Oplus Require Import balanced_edges direction angular_crossings winding_number regions filling.
Import ListNotations.

(* Whether u is met on the way counterclockwise from b to g, if these are not one direction. *)
Definition is_met_between (b g u : vector) : bool :=
  if negative (cross g b) then negative (cross u b) && negative (cross g u) else negative (cross u b) || negative
    (cross g u).

(* Whether b is not met before a on the way counterclockwise from the way back. *)
Definition turns_more (before a b : segment) : bool :=
  negb (is_met_between (minus (source before) (target before)) (along a) (along b)).

(* Of the segments that start where one ends, that which turns clockwise most, and the others. *)
Fixpoint next_and_others (before : segment) (l : list segment) : option (segment * list segment) :=
  match l with
  | [] => None
  | e :: rest =>
    let starts_there := if vector_dec (source e) (target before) then true else false in
    match next_and_others before rest with
    | None => if starts_there then Some (e, rest) else None
    | Some (f, others) => if starts_there && turns_more before e f then Some (e, rest) else Some (f, e :: others)
    end
  end.

(* From segment to segment until it would be the first again; the segments that are left. *)
Fixpoint walk (fuel : nat) (first before : segment) (l : list segment) : list vector * list segment :=
  match fuel with
  | O => ([], l)
  | S fewer =>
    match next_and_others before l with
    | None => ([], l)
    | Some (e, rest) =>
      if (if vector_dec (target before) (source first) then turns_more before first e else false) then ([], l)
      else let (chain, others) := walk fewer first e rest in (source e :: chain, others)
    end
  end.

Fixpoint chains_of (fuel : nat) (l : list segment) : list (list vector) :=
  match fuel, l with
  | S fewer, e :: rest =>
    let (chain, others) := walk (length rest) e e rest in (source e :: chain) :: chains_of fewer others
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

Lemma next_is (before : segment) (l : list segment) (e : segment) : forall rest,
  next_and_others before l = Some (e, rest) -> source e = target before /\ Permutation (e :: rest) l.
Proof.
  revert e. induction l as [| f l IH]; intros e rest; cbn [next_and_others]; [discriminate |].
  destruct (next_and_others before l) as [[g others] |]; destruct (vector_dec (source f) (target before)) as [there |];
    cbn [andb]; try discriminate.
  - destruct (turns_more before f g); intros [= <- <-]; [split; [exact there | reflexivity] |].
    destruct (IH g others eq_refl) as [is_there permuted]. split;
      [exact is_there |]. rewrite <- permuted. apply perm_swap.
  - intros [= <- <-]. destruct (IH g others eq_refl) as [is_there permuted]. split; [exact is_there |].
    rewrite <- permuted. apply perm_swap.
  - intros [= <- <-]. split; [exact there | reflexivity].
Qed.

Lemma no_next (before : segment) (l : list segment) : next_and_others before l = None ->
  forall e, In e l -> source e <> target before.
Proof.
  induction l as [| f l IH]; intros none e I; [destruct I |]. cbn [next_and_others] in none.
  destruct (next_and_others before l) as [[g others] |].
  - destruct (_ && _); discriminate.
  - destruct (vector_dec (source f) (target before)) as [| not_there]; [discriminate |].
    destruct I as [<- | I]; [exact not_there | now apply IH].
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

Lemma path_of_both (l m : list vector) (z : vector) : path (l ++ m) z = path l (hd z m) ++ path m z.
Proof.
  induction l as [| a l IH]; [reflexivity |]. cbn [app path]. rewrite IH. f_equal. f_equal. now destruct l.
Qed.

Lemma edges_are_a_path (chain : list vector) (a : vector) : edges (a :: chain) = path (a :: chain) a.
Proof. rewrite path_is. reflexivity. Qed.

Lemma rotated_permutes {A : Type} (l : list A) : Permutation (rotated l) l.
Proof. destruct l as [| a l]; [reflexivity |]. symmetry. apply Permutation_cons_append. Qed.

Lemma walk_returns (fuel : nat) (first : segment) : forall before l, (length l <= fuel)%nat ->
  (forall v, surplus v l = one_if (target before) v - one_if (source first) v) ->
  let (chain, others) := walk fuel first before l in is_balanced others /\
    hd (source first) chain = target before /\ Permutation (path chain (source first) ++ others) l.
Proof.
  assert (stop : forall before l, (forall v, surplus v l = one_if (target before) v - one_if (source first) v) ->
    target before = source first \/ (forall e, In e l -> source e <> target before) ->
    is_balanced l /\ source first = target before /\ Permutation l l).
  { intros before l counts which. assert (returned : target before = source first).
    { destruct which as [| none]; [assumption |]. destruct (vector_dec (target before) (source first)) as [| going];
        [assumption | exfalso]. destruct (something_leaves (target before) l) as (e & E & there);
          [| exact (none e E there)].
      rewrite counts. unfold one_if. destruct (vector_dec (target before) (target before)), (vector_dec (source first)
        (target before)); congruence || lia. }
    split; [| now split]. intros v. rewrite counts, returned. lia. }
  induction fuel as [| fuel IH]; intros before l enough_ counts; cbn [walk].
  - apply stop; [exact counts |]. right. destruct l; [intros e [] | cbn in enough_; lia].
  - destruct (next_and_others before l) as [[e rest] |] eqn:next_.
    2: { apply stop; [exact counts |]. right. exact (no_next before l next_). }
    destruct (if vector_dec _ _ then _ else _) eqn:closes.
    { apply stop; [exact counts | left]. now destruct (vector_dec (target before) (source first)). }
    apply next_is in next_. destruct next_ as [there permuted]. specialize (IH e rest).
    destruct (walk fuel first e rest) as [chain others]. destruct IH as (balanced_ & starts & all).
    + apply Permutation_length in permuted. cbn in permuted. lia.
    + intros v. specialize (counts v). rewrite <- (surplus_permuted v _ _ permuted), surplus_of_more,
      there in counts. lia.
    + split; [exact balanced_ |]. split; [exact there |].
      cbn [path app]. rewrite starts, all, <- permuted. now destruct e.
Qed.

Lemma chains_take_all (fuel : nat) : forall l, (length l <= fuel)%nat -> is_balanced l ->
  Permutation (region_edges (chains_of fuel l)) l.
Proof.
  induction fuel as [| fuel IH]; intros l enough_ balanced_.
  - destruct l; [reflexivity | cbn in enough_; lia].
  - destruct l as [| e l]; [reflexivity |]. cbn [chains_of].
    pose proof (walk_returns (length l) e e l (le_n _)) as returns. destruct (walk (length l) e e l) as [chain others].
    destruct returns as (balanced_others & starts & all).
    + intros v. specialize (balanced_ v). rewrite surplus_of_more in balanced_. lia.
    + cbn [region_edges flat_map].
      assert (fewer : (length others <= fuel)%nat).
      { apply Permutation_length in all. rewrite app_length in all. cbn [length] in enough_. lia. }
      change (flat_map edges (chains_of fuel others)) with (region_edges (chains_of fuel others)).
      rewrite (IH others fewer balanced_others), edges_are_a_path. cbn [path app]. rewrite starts, all. now destruct e.
Qed.
