(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The angle of a vector, measured along the diamond |x| + |y| = 1 instead of the circle, so that it
   stays rational: from 0, at the positive x-axis, counterclockwise to 4. Signs of cross products, and
   with them everything that is decided about directions, become linear conditions on angles. *)
From Coq Require Import Bool Lia.
From Oplus Require Import numbers direction.

Open Scope Q_scope.

Definition positive (q : Q) : bool := negative (- q).

Definition opposite (v : vector) : vector := Vector (- vx v) (- vy v).

Lemma opposite_nonzero (v : vector) : nonzero v -> nonzero (opposite v).
Proof. unfold nonzero, opposite; cbn. intros n [x y]. apply n. split; lra. Qed.

(* How far v is from zero, along the axes. *)
Definition size (v : vector) : Q := Qabs (vx v) + Qabs (vy v).

Definition angle (v : vector) : Q :=
  if half v then 3 + vx v / size v else 1 - vx v / size v.

(* The point of the diamond at an angle in [0, 4). *)
Definition diamond (t : Q) : vector :=
  if Qlt_le_dec t 2 then Vector (1 - t) (1 - Qabs (1 - t))
  else Vector (t - 3) (Qabs (t - 3) - 1).

Lemma negative_spec (q : Q) : reflect (q < 0) (negative q).
Proof. unfold negative. destruct (CompareSpec2Type (Qcompare_spec q 0)); constructor; lra. Qed.

Lemma positive_spec (q : Q) : reflect (0 < q) (positive q).
Proof. unfold positive. destruct (negative_spec (- q)); constructor; lra. Qed.

Lemma zero_spec (q : Q) : reflect (q == 0) (zero q).
Proof. unfold zero. destruct (CompareSpec2Type (Qcompare_spec q 0)); constructor; lra. Qed.

Lemma half_spec (v : vector) : reflect (vy v < 0 \/ (vy v == 0 /\ vx v < 0)) (half v).
Proof.
  unfold half. destruct (negative_spec (vy v)), (zero_spec (vy v)), (negative_spec (vx v)); constructor; tauto.
Qed.

Lemma abs_cases (q : Q) : (0 <= q /\ Qabs q == q) \/ (q < 0 /\ Qabs q == - q).
Proof.
  destruct (Qlt_le_dec q 0) as [n | p].
  - right. split; [assumption |]. apply Qabs_neg. lra.
  - left. split; [assumption |]. now apply Qabs_pos.
Qed.

Lemma size_positive (v : vector) : nonzero v -> 0 < size v.
Proof.
  unfold nonzero, size. intros n.
  destruct (abs_cases (vx v)) as [[? ->] | [? ->]], (abs_cases (vy v)) as [[? ->] | [? ->]]; lra.
Qed.

(* What an angle is, without a division. *)
Lemma angle_size (v : vector) : nonzero v -> vx v == (if half v then angle v - 3 else 1 - angle v) * size v.
Proof. intros n. pose proof (size_positive v n). unfold angle. destruct (half v); field; lra. Qed.

(* The coordinates (x, y) of the point of the diamond at angle a, quadrant by quadrant. *)
Definition on_diamond (a x y : Q) : Prop :=
  (0 <= a < 1 /\ x == 1 - a /\ y == a) \/
  (1 <= a < 2 /\ x == 1 - a /\ y == 2 - a) \/
  (2 <= a < 3 /\ x == a - 3 /\ y == 2 - a) \/
  (3 <= a < 4 /\ x == a - 3 /\ y == a - 4).

(* A vector is a positive multiple of the point of the diamond at its angle. *)
Lemma angle_cases (v : vector) :
  nonzero v ->
  exists s x y, 0 < s /\ on_diamond (angle v) x y /\ vx v == x * s /\ vy v == y * s.
Proof.
  intros n. set (s := size v). set (a := angle v). exists s.
  assert (positive : 0 < s) by now apply size_positive.
  pose proof (angle_size v n) as x_is. fold s a in x_is.
  assert (s_is : s == Qabs (vx v) + Qabs (vy v)) by reflexivity.
  clearbody s a.
  enough (on_diamond a (vx v / s) (vy v / s)) by
    (exists (vx v / s), (vy v / s); repeat split; trivial; field; lra).
  assert (x_over : (vx v / s) * s == vx v) by (field; lra).
  assert (y_over : (vy v / s) * s == vy v) by (field; lra).
  generalize dependent (vx v / s). generalize dependent (vy v / s). intros y y_is x x_is'.
  unfold on_diamond.
  destruct (half_spec v) as [h | h]; unfold nonzero in n;
    destruct (abs_cases (vx v)) as [[? e] | [? e]], (abs_cases (vy v)) as [[? f] | [? f]];
    rewrite e, f in s_is; clear e f.
  all: try (exfalso; lra).
  - right. right. right. repeat split; nra.
  - assert (vy v == 0) by lra. right. right. left. repeat split; nra.
  - right. right. left. repeat split; nra.
  - destruct (Qlt_le_dec 0 (vx v)).
    + left. repeat split; nra.
    + right. left. repeat split; nra.
  - right. left. repeat split; nra.
Qed.

Lemma angle_range (v : vector) : nonzero v -> 0 <= angle v < 4.
Proof. intros n. destruct (angle_cases v n) as (s & x & y & _ & c & _). unfold on_diamond in c. lra. Qed.

Lemma half_angle (v : vector) : nonzero v -> reflect (2 <= angle v) (half v).
Proof.
  intros n. apply iff_reflect. destruct (angle_cases v n) as (s & x & y & positive & c & x_is & y_is).
  destruct (half_spec v) as [h | h]; split; intro e; trivial; try discriminate e;
    destruct c as [c | [c | [c | c]]]; try lra; exfalso; nra.
Qed.

(* The sign of the cross product of two points of the diamond is that of the turn from one to the
   other, less than half a turn either way; it is zero where they are equal or opposite. *)
Definition turns_by (turn cross dot : Q) : Prop :=
  (0 < cross /\ (0 < turn < 2 \/ turn < -2)) \/
  (cross < 0 /\ (-2 < turn < 0 \/ 2 < turn)) \/
  (cross == 0 /\ 0 < dot /\ turn == 0) \/
  (cross == 0 /\ dot < 0 /\ (turn == 2 \/ turn == -2)).

Lemma diamond_turns (a b x y x' y' : Q) :
  on_diamond a x y -> on_diamond b x' y' ->
  turns_by (b - a) (x * y' - y * x') (x * x' + y * y').
Proof.
  unfold on_diamond, turns_by. intros c d.
  destruct c as [[r [e f]] | [[r [e f]] | [[r [e f]] | [r [e f]]]]],
           d as [[r' [e' f']] | [[r' [e' f']] | [[r' [e' f']] | [r' [e' f']]]]];
    rewrite e, f, e', f'; clear e f e' f' x y x' y';
    destruct (Q_dec (b - a) 0) as [[? | ?] | zero_turn];
    try (exfalso; lra);
    destruct (Q_dec (b - a) 2) as [[? | ?] | half_turn];
    try (exfalso; lra);
    destruct (Q_dec (b - a) (-2)) as [[? | ?] | half_turn_back];
    try (exfalso; lra);
    first [left; split; [nra | lra] | right; left; split; [nra | lra]
         | right; right; left; repeat split; [nra | nra | lra]
         | right; right; right; repeat split; [nra | nra | lra]].
Qed.

(* Longer vectors turn as much. *)
Lemma turns_by_scaled (turn c d c' d' k : Q) :
  0 < k -> c' == k * c -> d' == k * d -> turns_by turn c d <-> turns_by turn c' d'.
Proof.
  intros positive e f. unfold turns_by. rewrite e, f.
  assert (sign : forall x, (0 < x <-> 0 < k * x) /\ (x < 0 <-> k * x < 0) /\ (x == 0 <-> k * x == 0))
    by (intros x; destruct (Q_dec x 0) as [[? | ?] | ?]; repeat split; intros; nra).
  pose proof (sign c). pose proof (sign d). tauto.
Qed.

Lemma cross_angle (u v : vector) : nonzero u -> nonzero v -> turns_by (angle v - angle u) (cross u v) (dot u v).
Proof.
  intros m n.
  destruct (angle_cases u m) as (s & x & y & positive & c & x_is & y_is),
           (angle_cases v n) as (t & x' & y' & positive' & d & x_is' & y_is').
  apply (turns_by_scaled _ (x * y' - y * x') (x * x' + y * y') _ _ (s * t)); [nra | | | now apply diamond_turns];
    unfold cross, dot; rewrite x_is, y_is, x_is', y_is'; ring.
Qed.

(* compare_angle compares angles. *)
Lemma compare_angle_is (u v : vector) : nonzero u -> nonzero v -> compare_angle u v = (angle u ?= angle v).
Proof.
  intros m n. pose proof (cross_angle u v m n) as turns. unfold turns_by, cross in turns.
  pose proof (angle_range u m). pose proof (angle_range v n). unfold compare_angle.
  destruct (half_angle u m), (half_angle v n), (Qcompare_spec (angle u) (angle v)); trivial; try (exfalso; lra);
    destruct (Qcompare_spec (vy u * vx v) (vx u * vy v)); trivial; exfalso; lra.
Qed.

(* Thesis, Definition 2.1.7: two directions are equal iff one is a positive multiple of the other. *)
Definition same_direction (u v : vector) : Prop :=
  exists a : Q, 0 < a /\ vx u == a * vx v /\ vy u == a * vy v.

Lemma same_direction_angle (u v : vector) : nonzero u -> nonzero v -> same_direction u v <-> angle u == angle v.
Proof.
  intros m n. split.
  - intros (a & positive & x_is & y_is).
    pose proof (cross_angle u v m n) as turns. unfold turns_by, cross, dot in turns.
    unfold nonzero in n.
    destruct turns as [[c _] | [[c _] | [(_ & _ & turn) | (_ & d & _)]]];
      [exfalso | exfalso | lra | exfalso]; rewrite x_is, y_is in *; [nra | nra |].
    nra.
  - intro equal.
    destruct (angle_cases u m) as (s & x & y & positive & c & x_is & y_is),
             (angle_cases v n) as (t & x' & y' & positive' & d & x_is' & y_is').
    assert (x == x' /\ y == y') as [ex ey] by (unfold on_diamond in *; lra).
    exists (s / t). rewrite x_is, y_is, x_is', y_is', ex, ey.
    repeat split; [| field; lra | field; lra].
    apply Qlt_shift_div_l; lra.
Qed.
