(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Definition 4.2.3, in general position: where a step meets a segment, and no end of one is on the line of the other, the
   signed crossing is 1 if the segment is crossed from its right to its left, and -1 if from left to right; where they
   do not meet it is 0. So what signed_crossings.v counts is what the definition says. *)
From Coq Require Import QArith Lqa Qfield ZArith Lia Bool List.
From Oplus Require Import direction angle sweep winding_number signed_crossings meeting_of_segments.
Import ListNotations.

Open Scope Q_scope.

(* No end of one is on the line of the other. *)
Definition in_general_position (from to : vector) (s : segment) : Prop :=
  ~ area s from == 0 /\ ~ area s to == 0 /\
  ~ area (Segment from to) (source s) == 0 /\ ~ area (Segment from to) (target s) == 0.

Lemma side_without_tie (u : Q) (tie : comparison) : ~ u == 0 ->
  match u ?= 0 with Eq => tie | Lt => Lt | Gt => Gt end = if negative u then Lt else Gt.
Proof. intros some. compared_numbers (u ?= 0); destruct (negative_spec u); trivial; exfalso; lra. Qed.

Lemma signed_crossing_in_general_position (from to : vector) (s : segment) :
  in_general_position from to s ->
  signed_crossing_of_step from to s =
  (if Bool.eqb (negative (area s from)) (negative (area s to)) ||
      Bool.eqb (negative (area (Segment from to) (source s))) (negative (area (Segment from to) (target s)))
   then 0 else if negative (area s to) then -1 else 1)%Z.
Proof.
  intros (off_from & off_to & off_source & off_target). destruct s as [a b].
  unfold signed_crossing_of_step, side_of_segment, side_of_step. rewrite !orientation_by_area.
  cbn [source target] in *. rewrite !side_without_tie by assumption.
  destruct (negative (area (Segment a b) from)), (negative (area (Segment a b) to)),
    (negative (area (Segment from to) a)), (negative (area (Segment from to) b)); reflexivity.
Qed.

(* Theorem. The direction of the step against the segment gives the sign. *)
Theorem sign_of_a_crossing (from to : vector) (s : segment) :
  in_general_position from to s ->
  (forall w, lies_on w (Segment from to) -> lies_on w s ->
     (0 < cross (minus (target s) (source s)) (minus to from) -> signed_crossing_of_step from to s = 1%Z) /\
     (cross (minus (target s) (source s)) (minus to from) < 0 -> signed_crossing_of_step from to s = (-1)%Z)) /\
  ((forall w, lies_on w (Segment from to) -> ~ lies_on w s) -> signed_crossing_of_step from to s = 0%Z).
Proof.
  intros general. split.
  - intros w (h & [h0 h1] & wx & wy) (k & [k0 k1] & X & Y). cbn [source target] in *.
    rewrite (signed_crossing_in_general_position from to s general).
    destruct general as (off_from & off_to & off_source & off_target).
    assert (on_s : (1 - h) * area s from + h * area s to == 0).
    { assert (value : (1 - h) * area s from + h * area s to == area s w)
        by (unfold area, cross, minus; cbn [vx vy]; rewrite wx, wy; ring).
      rewrite value. unfold area, cross, minus; cbn [vx vy]. rewrite X, Y. ring. }
    assert (on_step : (1 - k) * area (Segment from to) (source s) + k * area (Segment from to) (target s) == 0).
    { assert (value : (1 - k) * area (Segment from to) (source s) + k * area (Segment from to) (target s) ==
                      area (Segment from to) w)
        by (unfold area, cross, minus; cbn [source target vx vy]; rewrite X, Y; ring).
      rewrite value. unfold area, cross, minus; cbn [source target vx vy]. rewrite wx, wy. ring. }
    assert (change : area s to - area s from == cross (minus (target s) (source s)) (minus to from))
      by (unfold area, cross, minus; cbn [vx vy]; ring).
    assert (other_change : area (Segment from to) (target s) - area (Segment from to) (source s) ==
                           - cross (minus (target s) (source s)) (minus to from))
      by (unfold area, cross, minus; cbn [source target vx vy]; ring).
    rewrite <- change in *.
    set (A := area s from) in *. set (B := area s to) in *.
    set (C := area (Segment from to) (source s)) in *. set (D := area (Segment from to) (target s)) in *.
    clearbody A B C D.
    assert (opposite_signs : forall t u v : Q, 0 <= t -> t <= 1 -> ~ u == 0 -> ~ v == 0 -> (1 - t) * u + t * v == 0 ->
      (u < 0 /\ 0 < v) \/ (0 < u /\ v < 0)).
    { intros t u v t0 t1 u_some v_some sum_.
      destruct (Q_dec u 0) as [[u_neg | u_pos] | u_zero], (Q_dec v 0) as [[v_neg | v_pos] | v_zero];
        try contradiction; try (now left); try (now right); exfalso.
      - assert (0 <= (1 - t) * - u) by (apply Qmult_le_0_compat; lra).
        assert (0 <= t * - v) by (apply Qmult_le_0_compat; lra).
        assert (t * - v == 0) as none by lra. apply Qmult_integral in none.
        destruct none as [none |]; [rewrite none in sum_; lra | lra].
      - assert (0 <= (1 - t) * u) by (apply Qmult_le_0_compat; lra).
        assert (0 <= t * v) by (apply Qmult_le_0_compat; lra).
        assert (t * v == 0) as none by lra. apply Qmult_integral in none.
        destruct none as [none |]; [rewrite none in sum_; lra | lra]. }
    pose proof (opposite_signs h A B h0 h1 off_from off_to on_s) as signs.
    pose proof (opposite_signs k C D k0 k1 off_source off_target on_step) as other_signs.
    split; intros sign;
      destruct (negative_spec A), (negative_spec B), (negative_spec C), (negative_spec D); cbn [Bool.eqb orb];
      trivial; exfalso; lra.
  - intros apart. destruct (Z.eq_dec (signed_crossing_of_step from to s) 0) as [| crosses]; [assumption | exfalso].
    destruct (crossing_steps_meet from to s crosses) as (w & on_step & on_s). exact (apart w on_step on_s).
Qed.
