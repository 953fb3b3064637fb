(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Chains in canonical form (reference/definitions/values.hpp): no vertex is between the two beside it, the first one is
   the smallest, and if a chain passes it several times, the chain begins so that it is the smallest list. The points
   of a region and all winding numbers stay what they were, since two edges in line have the points of one. That
   chains turn clockwise most is in walks.v. *)
From Coq Require Import QArith Lqa ZArith Lia Bool List Permutation.
From Oplus Require Import balanced_edges direction angular_crossings winding_number in_out_degree regions location
  pieces
  walks touching_vertices.
Import ListNotations.

Fixpoint compare_chains (c d : list vector) : comparison :=
  match c, d with
  | [], [] => Eq
  | [], _ :: _ => Lt
  | _ :: _, [] => Gt
  | v :: c, w :: d => match compare_points v w with Eq => compare_chains c d | by_first => by_first end
  end.

Definition smaller_chain (c d : list vector) : list vector := match compare_chains d c with Lt => d | _ => c end.
Definition smaller_point (v w : vector) : vector := match compare_points w v with Lt => w | _ => v end.

(* The rotations that begin with v, given what is before the list, backwards. *)
Fixpoint rotations_at (v : vector) (passed l : list vector) : list (list vector) :=
  match l with
  | [] => []
  | w :: rest => (if same_point v w then [l ++ rev passed] else []) ++ rotations_at v (w :: passed) rest
  end.

Definition least_rotation (c : list vector) : list vector :=
  match c with
  | [] => []
  | first :: rest => fold_left smaller_chain (rotations_at (fold_left smaller_point rest first) [] c) c
  end.

(* What follows a, up to z, without vertices between the two beside them. *)
Fixpoint straightened (a : vector) (l : list vector) (z : vector) : list vector :=
  match l with
  | [] => []
  | b :: rest => if is_between_ends b a (hd z rest) then straightened a rest z else b :: straightened b rest z
  end.

Definition straight_chain (c : list vector) : list vector :=
  match c with [] => [] | a :: rest => a :: straightened a rest a end.

Definition canonical_chain (c : list vector) : list vector := least_rotation (straight_chain (least_rotation c)).

(* The same points, and the same winding number, as seen from x. *)
Definition alike_from (x : vector) (l m : list segment) : Prop :=
  ((exists s, In s l /\ lies_on x s) <-> (exists s, In s m /\ lies_on x s)) /\
  winding_number x l = winding_number x m.

Section Alike.
  Variable x : vector.

  Lemma alike_transitive (l m n : list segment) : alike_from x l m -> alike_from x m n -> alike_from x l n.
  Proof. unfold alike_from. intros [on number_is] [on' number_is']. split; [tauto | congruence]. Qed.

  Lemma alike_permuted (l m : list segment) : Permutation l m -> alike_from x l m.
  Proof.
    intros permuted. split.
    - split; intros (s & S & on); exists s; (split; [| exact on]);
        [now apply (Permutation_in _ permuted) | now apply (Permutation_in _ (Permutation_sym permuted))].
    - unfold winding_number. apply sum_of_permutation. now apply Permutation_map.
  Qed.

  Lemma alike_together (l l' m m' : list segment) :
    alike_from x l l' -> alike_from x m m' -> alike_from x (l ++ m) (l' ++ m').
  Proof.
    intros [on_l number_l] [on_m number_m]. split.
    - assert (both : forall a b, (exists s, In s (a ++ b) /\ lies_on x s) <->
        (exists s, In s a /\ lies_on x s) \/ (exists s, In s b /\ lies_on x s)).
      { intros a b. split; [intros (s & S & on); apply in_app_iff in S; destruct S; [left | right]; now exists s |].
        intros [(s & S & on) | (s & S & on)]; exists s; rewrite in_app_iff; tauto. }
      rewrite !both. tauto.
    - unfold winding_number in *. rewrite !map_app, !sum_of_both. lia.
  Qed.

  Lemma straight_path (z : vector) (l : list vector) : forall a,
    alike_from x (path (a :: straightened a l z) z) (path (a :: l) z).
  Proof.
    induction l as [| b rest IH]; intros a; [now apply alike_permuted |]. cbn [straightened].
    destruct (is_between_ends b a (hd z rest)) eqn:between_.
    - apply (alike_transitive _ _ _ (IH a)). set (c := hd z rest) in *.
      change (path (a :: rest) z) with (Segment a c :: path rest z).
      change (path (a :: b :: rest) z) with ([Segment a b; Segment b c] ++ path rest z).
      apply (alike_together [Segment a c] [Segment a b; Segment b c]); [| now apply alike_permuted]. split.
      + split.
        * intros (s & [<- | []] & on). apply (on_divided b a c x between_) in on.
          destruct on; [exists (Segment a b) | exists (Segment b c)]; cbn; tauto.
        * intros (s & S & on). exists (Segment a c). split; [now left |]. apply (on_divided b a c x between_).
          destruct S as [<- | [<- | []]]; tauto.
      + unfold winding_number, sum. cbn [map fold_right]. rewrite (crossing_divided b a c x between_). lia.
    - exact (alike_together [Segment a b] [Segment a b] _ _ (alike_permuted _ _ (Permutation_refl _)) (IH b)).
  Qed.

  Lemma straight_chain_is_alike (c : list vector) : alike_from x (edges (straight_chain c)) (edges c).
  Proof.
    destruct c as [| a rest]; [now apply alike_permuted |]. cbn [straight_chain]. rewrite !edges_are_a_path.
    apply straight_path.
  Qed.
End Alike.

Lemma path_of_both (l m : list vector) (z : vector) : path (l ++ m) z = path l (hd z m) ++ path m z.
Proof.
  induction l as [| a l IH]; [reflexivity |]. cbn [app path]. rewrite IH. f_equal. f_equal. now destruct l.
Qed.

Lemma edges_of_rotation (a b : list vector) : Permutation (edges (b ++ a)) (edges (a ++ b)).
Proof.
  destruct a as [| v a]; [now rewrite app_nil_r |]. destruct b as [| w b]; [now rewrite app_nil_r |].
  cbn [app]. rewrite !edges_are_a_path.
  change (w :: b ++ v :: a) with ((w :: b) ++ v :: a). change (v :: a ++ w :: b) with ((v :: a) ++ w :: b).
  rewrite !path_of_both. apply Permutation_app_comm.
Qed.

Definition is_rotation (d c : list vector) : Prop := exists a b, c = a ++ b /\ d = b ++ a.

Lemma rotations_are (v : vector) (l : list vector) : forall passed d, In d (rotations_at v passed l) ->
  is_rotation d (rev passed ++ l).
Proof.
  induction l as [| w rest IH]; intros passed d I; [destruct I |]. cbn [rotations_at] in I. apply in_app_iff in I.
  destruct I as [I | I].
  - destruct (same_point v w); [destruct I as [<- | []] | destruct I]. now exists (rev passed), (w :: rest).
  - apply IH in I. cbn [rev] in I. now rewrite <- app_assoc in I.
Qed.

Lemma least_is_a_rotation (c : list vector) : is_rotation (least_rotation c) c.
Proof.
  destruct c as [| first rest]; [now exists [], [] |]. unfold least_rotation.
    set (v := fold_left smaller_point rest first).
  assert (one : forall ls best, In (fold_left smaller_chain ls best) (best :: ls)).
  { induction ls as [| d ls IH]; intros best; [now left |]. cbn [fold_left].
    destruct (IH (smaller_chain best d)) as [is_ | I]; [| right; now right].
    rewrite <- is_. unfold smaller_chain. destruct (compare_chains d best); cbn; tauto. }
  destruct (one (rotations_at v [] (first :: rest)) (first :: rest)) as [is_ | I].
  - rewrite <- is_. exists [], (first :: rest). split; [reflexivity | now rewrite app_nil_r].
  - exact (rotations_are v (first :: rest) [] _ I).
Qed.

Lemma canonical_chain_is_alike (x : vector) (c : list vector) : alike_from x (edges (canonical_chain c)) (edges c).
Proof.
  assert (rotated_ : forall d, alike_from x (edges (least_rotation d)) (edges d)).
  { intros d. destruct (least_is_a_rotation d) as (a & b & d_is & ->). rewrite d_is.
    apply alike_permuted, edges_of_rotation. }
  apply (alike_transitive x _ _ _ (rotated_ _)). apply (alike_transitive x _ _ _ (straight_chain_is_alike x _)).
  apply rotated_.
Qed.

(* Theorem. *)
Theorem canonical_chains_are_alike (x : vector) (r : region) :
  alike_from x (region_edges (map canonical_chain r)) (region_edges r).
Proof.
  induction r as [| c r IH]; [now apply alike_permuted |]. cbn [map].
  exact (alike_together x _ _ _ _ (canonical_chain_is_alike x c) IH).
Qed.
