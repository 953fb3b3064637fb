(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Signed crossings (winding_number.v) at every point x, whether it is on the segments or not: those of a segment and
   its reverse cancel, those of the two parts of a segment add up, and those of a triangle that turns left are 0 or 1
   together: 0 if x is not in the closed triangle, 1 if it is strictly inside. *)
From Coq Require Import QArith Lqa ZArith Lia Bool List.
From Oplus Require Import convolution specification checker signed_crossings homogeneous_points
  specification_bridge fans.
Import ListNotations.

Open Scope Q_scope.

Lemma order_cases (a b : Q) : (a <= b /\ Qle_bool a b = true) \/ (b < a /\ Qle_bool a b = false).
Proof.
  destruct (Qlt_le_dec b a) as [low | high]; [right | left; split; [exact high | now apply Qle_bool_iff]].
  split; [exact low |]. apply not_true_iff_false. rewrite Qle_bool_iff. lra.
Qed.

(* All cases of the heights of points and of the sides on which they are. *)
Ltac by_order := repeat match goal with
  | |- context [if Qle_bool ?a ?b then _ else _] => 
      let order_ := fresh "order_" in destruct (order_cases a b) as [[order_ ->] | [order_ ->]]
  end.

Lemma crossing_of_the_reverse (x a b : vector) :
  signed_crossing x (Segment b a) = (- signed_crossing x (Segment a b))%Z.
Proof.
  assert (back : turn_of b a x == - turn_of a b x) by (unfold turn_of; ring).
  rewrite !signed_crossing_by_turn. by_order; first [reflexivity | exfalso; lra].
Qed.

Lemma crossing_of_parts (x a m b : vector) : lies_on m (Segment a b) ->
  signed_crossing x (Segment a b) = (signed_crossing x (Segment a m) + signed_crossing x (Segment m b))%Z.
Proof.
  intros (t & range & mx & my). cbn [source target] in *.
  assert (before_ : turn_of a m x == t * turn_of a b x) by (unfold turn_of; rewrite mx, my; ring).
  assert (after_ : turn_of m b x == (1 - t) * turn_of a b x) by (unfold turn_of; rewrite mx, my; ring).
  rewrite !signed_crossing_by_turn.
  destruct (Q_dec t 0) as [[low | some] | none]; [lra | |].
  - destruct (Q_dec t 1) as [[less | high] | all]; [| lra |].
    + destruct (product_with_positive (turn_of a b x) t some) as (up & down & _).
      destruct (product_with_positive (turn_of a b x) (1 - t)) as (up' & down' & _); [lra |].
      rewrite Qmult_comm, <- before_ in up, down. rewrite Qmult_comm, <- after_ in up', down'.
      assert (0 <= (1 - t) * (vy b - vy x) \/ vy b < vy x)
        by (destruct (Qlt_le_dec (vy b) (vy x)); [now right | left; apply Qmult_le_0_compat; lra]).
      by_order; first [reflexivity | exfalso; first [lra | nra]].
    + rewrite all in *. by_order; first [reflexivity | exfalso; lra].
  - rewrite none in *. by_order; first [reflexivity | exfalso; lra].
Qed.

Definition sides_of_triangle (a b c : vector) : list segment := [Segment a b; Segment b c; Segment c a].

Lemma winding_number_of_a_triangle (x a b c : vector) : 0 < turn_of a b c ->
  (0 <= winding_number x (sides_of_triangle a b c) <= 1)%Z /\
  (winding_number x (sides_of_triangle a b c) <> 0%Z -> in_triangle a b c x) /\
  (0 < turn_of a b x -> 0 < turn_of b c x -> 0 < turn_of c a x -> winding_number x (sides_of_triangle a b c) = 1%Z).
Proof.
  intros left_. unfold winding_number, sides_of_triangle, sum, in_triangle. cbn [map fold_right].
  assert (whole : turn_of a b x + turn_of b c x + turn_of c a x == turn_of a b c) by (unfold turn_of; ring).
  assert (height : turn_of b c x * (vy a - vy x) + turn_of c a x * (vy b - vy x) + turn_of a b x * (vy c - vy x) == 0)
    by (unfold turn_of; ring).
  assert (flat : turn_of a b c ==
    (vx b - vx a) * ((vy c - vy x) - (vy a - vy x)) - ((vy b - vy x) - (vy a - vy x)) * (vx c - vx a))
    by (unfold turn_of; ring).
  rewrite !signed_crossing_by_turn. set (w := turn_of a b x) in *. set (u := turn_of b c x) in *.
  set (v := turn_of c a x) in *. set (size := turn_of a b c) in *. clearbody w u v size.
  set (p := vy a - vy x) in *. set (q := vy b - vy x) in *. set (r := vy c - vy x) in *.
  assert (rewrite_order : forall y, Qle_bool y (vy x) = Qle_bool (y - vy x) 0).
  { intros y. destruct (order_cases y (vy x)) as [[o ->] | [o ->]],
      (order_cases (y - vy x) 0) as [[o' ->] | [o' ->]]; trivial; exfalso; lra. }
  rewrite !rewrite_order. fold p q r. clearbody p q r. set (h := vx b - vx a) in *. set (k := vx c - vx a) in *.
  clearbody h k.
  assert (level : 0 < u -> 0 < v -> 0 < w -> (p <= 0 /\ q <= 0 /\ r <= 0) \/ (0 <= p /\ 0 <= q /\ 0 <= r) -> False).
  { intros U V W same_. assert (p == 0 /\ q == 0 /\ r == 0) as (p_is & q_is & r_is);
      [| rewrite p_is, q_is, r_is in flat; lra].
    assert (signs : forall s z : Q, 0 < s -> (z <= 0 -> s * z <= 0) /\ (0 <= z -> 0 <= s * z))
      by (intros s z some; split; intros; nra).
    destruct (signs u p U), (signs v q V), (signs w r W).
    assert (u * p == 0 /\ v * q == 0 /\ w * r == 0) as (P & Q_ & R)
      by (destruct same_ as [(? & ? & ?) | (? & ? & ?)]; repeat split; lra).
    apply Qmult_integral in P, Q_, R. repeat split; lra. }
  by_order; (split; [| split]); intros; try lia; try (split; [| split]); try reflexivity; try lra; try congruence;
    try (apply Qnot_lt_le; intros negative_); exfalso;
    first [apply level; lra | lra | nra].
Qed.
