(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Lemma 4.1.8, holes included: a hole's chain is clockwise, and turns right at three vertices at least. *)
From Coq Require Import ZArith Lia Bool List.
From Oplus Require Import numbers winding tangent_set turning_number convolution_size total_turn.
Import ListNotations.

Open Scope Q_scope.

Definition turns_right (pair : vector * vector) : bool := negative (cross (fst pair) (snd pair)).

(* Each right turn takes away less than half a turn. *)
Lemma total_angle_at_least pairs :
  (forall pair, In pair pairs -> turns (fst pair) (snd pair)) ->
  let right_turns := inject_Z (Z.of_nat (count turns_right pairs)) in
  (right_turns == 0 /\ 0 <= total_angle pairs) \/
  (1 <= right_turns /\ -2 * right_turns < total_angle pairs).
Proof.
  unfold count. induction pairs as [| pair pairs IH]; intros T;
    [left; split; [reflexivity | apply Qle_refl] |].
  specialize (IH (fun p I => T p (or_intror I))). cbn [filter total_angle fold_right].
  fold (total_angle pairs).
  pose proof (signed_angle_sign _ _ (T pair (or_introl eq_refl))) as (range & _ & sign).
  assert (r : reflect (cross (fst pair) (snd pair) < 0) (turns_right pair)) by apply negative_spec.
  destruct r as [n | n].
  - cbn [length]. rewrite Nat2Z.inj_succ. unfold Z.succ. rewrite inject_Z_plus.
    change (inject_Z 1) with 1. right. cbv zeta in IH. lra.
  - cbv zeta in IH. lra.
Qed.

Lemma reflex_vertices_are_right_turns chain : reflex_vertices chain = count turns_right (turns_of chain).
Proof. unfold reflex_vertices, corners. now rewrite count_of_images. Qed.

Lemma three_reflex_vertices chain :
  turns_everywhere chain -> turning_number chain = (-1)%Z -> (3 <= reflex_vertices chain)%nat.
Proof.
  intros T N. pose proof (turning_number_counts_turns chain T) as e. rewrite N in e.
  change (inject_Z (-1)) with (-1) in e.
  destruct (total_angle_at_least (turns_of chain)) as [[r t] | [r t]].
  - intros pair I. apply (T (Corner (fst pair) (snd pair))). unfold corners, turns_of in *.
    apply in_map_iff. now exists pair.
  - lra.
  - rewrite reflex_vertices_are_right_turns. set (k := count _ _) in *.
    assert (2 < inject_Z (Z.of_nat k)) as more by lra.
    change 2 with (inject_Z 2) in more. rewrite <- Zlt_Qlt in more. lia.
Qed.

(* The chain of an outer boundary is counterclockwise and turns once, that of a hole once clockwise. *)
Definition outer (chain : list vector) : Prop := turning_number chain = 1%Z.
Definition hole (chain : list vector) : Prop := turning_number chain = (-1)%Z.

Lemma covered_enough (chain : list vector) (times : nat) :
  turns_everywhere chain -> outer chain \/ hole chain ->
  Z.of_nat times = (turning_number chain + Z.of_nat (reflex_vertices chain))%Z ->
  (1 <= times)%nat /\ (hole chain -> (2 <= times)%nat).
Proof.
  intros T [o | h] e.
  - unfold outer, hole in *. lia.
  - pose proof (three_reflex_vertices chain T h). unfold hole in *. lia.
Qed.

(* Lemma 4.1.8, for two closed chains that turn back nowhere, each of an outer boundary or of a hole. Every
   column of the fiber grid, the states of one vertex of P, is left along P's edge from at least one state,
   from two if Q's chain is a hole; and every row likewise along Q's edge. *)
Theorem rows_and_columns_are_left (p q : list vector) :
  turns_everywhere p -> turns_everywhere q -> outer p \/ hole p -> outer q \/ hole q ->
  (forall i, (i < length p)%nat ->
     let times := count (fun j => is_convolution_segment p q OfP i j) (seq 0 (length q)) in
     (1 <= times)%nat /\ (hole q -> (2 <= times)%nat)) /\
  (forall j, (j < length q)%nat ->
     let times := count (fun i => is_convolution_segment p q OfQ i j) (seq 0 (length p)) in
     (1 <= times)%nat /\ (hole p -> (2 <= times)%nat)).
Proof.
  intros tp tq op oq. split.
  - intros i I. apply covered_enough; trivial. now apply covered_by_q.
  - intros j J. apply covered_enough; trivial. now apply covered_by_p.
Qed.
