(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Signed crossings count whole turns: around a closed sequence of directions, the signed angles from
   each to the next add up to that number of full turns. *)
From Coq Require Import ZArith Lia Bool List SetoidList SetoidPermutation.
From Oplus Require Import numbers winding tangent_set turning_number.
Import ListNotations.

Open Scope Q_scope.

(* The signed angle of the turn by less than pi from u to v, positive counterclockwise, measured along
   the diamond (angle.v), on which a full turn is 4. *)
Definition signed_angle (u v : vector) : Q :=
  let t := angle v - angle u in
  if negative (t + 2) then t + 4 else if negative (2 - t) then t - 4 else t.

Definition total_angle (pairs : list (vector * vector)) : Q :=
  fold_right (fun p rest => signed_angle (fst p) (snd p) + rest) 0 pairs.

(* The signed angle has the sign of the skew product, and is less than half a turn. *)
Lemma signed_angle_sign : forall u v, turns u v ->
  -2 < signed_angle u v < 2 /\ (0 < signed_angle u v <-> 0 < cross u v) /\
  (signed_angle u v < 0 <-> cross u v < 0).
Proof.
  intros u v (U & V & N). pose proof (cross_angle u v U V) as T. unfold turns_by in T.
  pose proof (angle_range u U). pose proof (angle_range v V).
  unfold signed_angle. set (t := angle v - angle u) in *.
  assert (E : t == angle v - angle u) by reflexivity. clearbody t.
  assert (D : ~ (cross u v == 0 /\ dot u v < 0)) by (intros [C O]; specialize (N C); lra).
  destruct (negative_spec (t + 2)), (negative_spec (2 - t)); repeat split; try intros; lra.
Qed.

Lemma signed_angle_by_axis : forall u v, turns u v ->
  signed_angle u v == angle v - angle u + 4 * inject_Z (passes_axis u v).
Proof.
  intros u v (U & V & N). pose proof (cross_angle u v U V) as T. unfold turns_by in T.
  pose proof (angle_range u U). pose proof (angle_range v V). unfold signed_angle, passes_axis.
  destruct (before_spec (Direction u OfP) (Direction v OfP) U V) as [B | B],
    (before_spec (Direction v OfP) (Direction u OfP) V U) as [B' | B']; unfold earlier, place in B, B';
    cbn [vec of] in B, B'; destruct (negative_spec (angle v - angle u + 2)), (negative_spec (2 - (angle v - angle u)));
    compared_numbers (cross u v ?= 0); try (specialize (N C)); cbn [Z.b2z Z.opp];
    change (inject_Z 0) with 0; change (inject_Z 1) with 1; change (inject_Z (-1)) with (-1); lra.
Qed.

Lemma angle_of_equal : forall u v, equal_vectors u v -> angle u == angle v.
Proof.
  intros u v [X Y]. unfold angle, size.
  replace (half u) with (half v) by (unfold half, negative, zero; rewrite X, Y; reflexivity).
  destruct (half v); rewrite X, Y; reflexivity.
Qed.

Definition sum_of_angles (us : list vector) : Q := fold_right (fun u rest => angle u + rest) 0 us.

Lemma sum_of_angles_permuted : forall us vs,
  PermutationA equal_vectors us vs -> sum_of_angles us == sum_of_angles vs.
Proof.
  intros us vs P. unfold sum_of_angles. induction P; cbn [fold_right].
  - reflexivity.
  - rewrite (angle_of_equal _ _ H), IHP. reflexivity.
  - ring.
  - rewrite IHP1. exact IHP2.
Qed.

(* Theorem. Around a closed sequence of directions, the signed angles add up to as many full turns as
   any direction is passed, counterclockwise less clockwise. *)
Theorem sweeps_count_turns : forall pairs d,
  closed pairs -> (forall u v, In (u, v) pairs -> turns u v) -> proper d ->
  total_angle pairs == 4 * inject_Z (total (fun p => sweep d (fst p) (snd p)) pairs).
Proof.
  intros pairs d C T D. rewrite (sweeps_are_axis pairs d C T D).
  assert (A : total_angle pairs == sum_of_angles (map snd pairs) - sum_of_angles (map fst pairs) +
                                   4 * inject_Z (total (fun p => passes_axis (fst p) (snd p)) pairs)).
  { clear C D. unfold total, sum. induction pairs as [| [u v] rest IH]; [cbn; ring |].
    cbn [total_angle fold_right map fst snd sum_of_angles]. rewrite inject_Z_plus.
    unfold total_angle in IH. rewrite IH by (intros; apply T; right; assumption).
    rewrite signed_angle_by_axis by (apply T; left; reflexivity).
    unfold sum_of_angles. ring. }
  rewrite A, (sum_of_angles_permuted _ _ C). ring.
Qed.

(* Theorem. The winding number of a point off closed chains, counted by crossings of a ray, is the angle
   by which their edges turn around it, in full turns (thesis, Definition 4.2.2). *)
Theorem winding_number_counts_turns : forall p segments,
  cycles segments -> off p segments ->
  total_angle (map (seen_from p) segments) == 4 * inject_Z (winding_number p segments).
Proof.
  intros p segments C O. rewrite winding_number_as_sweeps by assumption.
  apply sweeps_count_turns; [now apply cycles_seen | now apply seen_turns | unfold proper, nonzero, right; cbn; lra].
Qed.

(* Theorem. The signed angles at a closed chain's vertices add up to its turning number, in full turns
   (thesis, Definition 2.1.9). *)
Theorem turning_number_counts_turns : forall chain,
  turns_everywhere chain ->
  total_angle (turns_of chain) == 4 * inject_Z (turning_number chain).
Proof.
  intros chain T. unfold turning_number. rewrite turns_past_total.
  apply sweeps_count_turns; [apply turns_closed | now apply turns_of_chain | unfold proper, nonzero; cbn; lra].
Qed.
