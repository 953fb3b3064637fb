(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The corners of chains as pairs of consecutive edges; and two lists whose elements belong to each other, each to one,
   are in the same order, if one is permuted. For places_of_corners.v. *)
From Coq Require Import Arith Lia List Permutation.
From Oplus Require Import convolution regions simple_chain.
Import ListNotations.

(* Two lists without repetition whose elements belong to each other, each to one. *)
Lemma matched {A B} (belong : A -> B -> Prop) : forall (l : list A) (m : list B), NoDup l -> NoDup m ->
  (forall x, In x l -> exists y, In y m /\ belong x y) -> (forall y, In y m -> exists x, In x l /\ belong x y) ->
  (forall x x' y, In x l -> In x' l -> belong x y -> belong x' y -> x = x') ->
  (forall x y y', In y m -> In y' m -> belong x y -> belong x y' -> y = y') ->
  exists m', Permutation m' m /\ Forall2 belong l m'.
Proof.
  induction l as [| x l IH]; intros m distinct_l distinct_m there back one other_one.
  - destruct m as [| y m]; [exists []; split; constructor |]. destruct (back y (or_introl eq_refl)) as (x & [] & _).
  - destruct (there x (or_introl eq_refl)) as (y & Y & xy). apply in_split in Y. destruct Y as (m1 & m2 & ->).
    inversion distinct_l as [| ? ? new distinct_l']; subst.
    pose proof (NoDup_remove_1 _ _ _ distinct_m) as distinct_m'. pose proof (NoDup_remove_2 _ _ _ distinct_m) as not_y.
    assert (still : forall z, In z (m1 ++ m2) -> In z (m1 ++ y :: m2)) by (intros z; rewrite !in_app_iff; cbn; tauto).
    destruct (IH (m1 ++ m2)) as (m' & permuted & pairs_); trivial.
    + intros z Z. destruct (there z (or_intror Z)) as (w & W & zw). exists w. split; [| exact zw].
      apply in_app_iff in W. cbn in W. destruct W as [W | [<- | W]]; [apply in_app_iff;
        tauto | exfalso | apply in_app_iff; tauto].
      apply new. now rewrite (one x z y (or_introl eq_refl) (or_intror Z) xy zw).
    + intros w W. destruct (back w (still w W)) as (z & [<- | Z] & zw); [exfalso | now exists z].
      apply not_y. rewrite (other_one x y w); trivial; [apply in_app_iff; right; now left | now apply still].
    + intros z z' w Z Z'. apply one; now right.
    + intros z w w' W W'. apply other_one; now apply still.
    + exists (y :: m'). split; [rewrite permuted; apply Permutation_middle | now constructor].
Qed.

(* Edge by edge, with the one before. *)
Definition consecutive_edges (r : region) : list (segment * segment) :=
  flat_map (fun c => combine (from_the_last (edges c)) (edges c)) r.

Lemma map_from_the_last {A B} (f : A -> B) (l : list A) : map f (from_the_last l) = from_the_last (map f l).
Proof.
  unfold from_the_last. rewrite <- map_rev. destruct (rev l) as [| z rest]; [reflexivity |]. cbn [map].
  now rewrite map_rev.
Qed.

Lemma combine_mapped {A B} (f : A -> B) : forall l m : list A,
  combine (map f l) (map f m) = map (fun ends => (f (fst ends), f (snd ends))) (combine l m).
Proof. induction l as [| x l IH]; intros [| y m]; cbn; [reflexivity .. |]. now rewrite IH. Qed.

Definition corner_of_edges (ends : segment * segment) : corner := Corner (along (fst ends)) (along (snd ends)).

Lemma corners_of_consecutive_edges (r : region) : flat_map corners r = map corner_of_edges (consecutive_edges r).
Proof.
  unfold consecutive_edges. induction r as [| c r IH]; [reflexivity |]. cbn [flat_map]. rewrite map_app, IH. f_equal.
  unfold corners, edge_directions. change (fun e => minus (target e) (source e)) with along.
  now rewrite <- map_from_the_last, combine_mapped, map_map.
Qed.

Lemma consecutive_edges_are (r : region) (g f : segment) : In (g, f) (consecutive_edges r) ->
  In g (region_edges r) /\ In f (region_edges r) /\ target g = source f.
Proof.
  intros I. apply in_flat_map in I. destruct I as (c & C & I). apply (In_nth _ _ (no_segment, no_segment)) in I.
  destruct I as (i & I & is_pair). rewrite combine_length, from_the_last_length, Nat.min_id, edges_are_as_many in I.
  rewrite combine_nth in is_pair by apply from_the_last_length. injection is_pair as <- <-.
  rewrite nth_from_the_last, edges_are_as_many by now rewrite edges_are_as_many.
  pose proof (previous_below _ i I) as J. fold (edge_at c i). fold (edge_at c (previous (length c) i)).
  split; [now apply edge_at_in_region |]. split; [now apply edge_at_in_region |].
  rewrite !edge_is by assumption. cbn [source target]. now rewrite next_previous.
Qed.

Lemma second_of_consecutive_edges (r : region) : map snd (consecutive_edges r) = region_edges r.
Proof.
  unfold consecutive_edges, region_edges. induction r as [| c r IH]; [reflexivity |]. cbn [flat_map].
  rewrite map_app, IH. f_equal. apply combine_ends. apply from_the_last_length.
Qed.

Lemma distinct_by_second {A B} (l : list (A * B)) x y z : NoDup (map snd l) -> In (x, z) l -> In (y, z) l -> x = y.
Proof.
  induction l as [| [u w] l IH]; cbn; [easy |]. intros distinct_. inversion distinct_ as [| ? ? new rest]; subst.
  intros [X | X] [Y | Y]; [congruence | exfalso | exfalso | now apply IH]; apply new, in_map_iff.
  - exists (y, z). split; [cbn; congruence | exact Y].
  - exists (x, z). split; [cbn; congruence | exact X].
Qed.
