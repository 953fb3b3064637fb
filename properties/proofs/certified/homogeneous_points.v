(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The integers of the checker (checker.v) as points and lines with rational coordinates: what its sums, differences and
   signs mean. *)
From Coq Require Import QArith Lqa Qfield ZArith Lia Bool List.
From Oplus Require Import direction angular_crossings winding_number specification checker.
Import ListNotations.

Open Scope Q_scope.

Definition vector_of (p : hpoint) : vector := Vector (px p # pw p) (py p # pw p).

Definition segment_of_hedge (e : hedge) : segment := Segment (vector_of (fst e)) (vector_of (snd e)).

Definition value_at (l : line) (x : vector) : Q := inject_Z (la l) * vx x + inject_Z (lb l) * vy x + inject_Z (lc l).

Definition added (a b : vector) : vector := Vector (vx a + vx b) (vy a + vy b).

(* x is in the convex polygon: to the left of each side, or on it. *)
Definition inside_piece (t : piece) (x : vector) : Prop := forall l, In l (side_lines t) -> 0 <= value_at l x.

Lemma as_quotient (n : Z) (d : positive) : n # d == inject_Z n / inject_Z (Zpos d).
Proof. now rewrite Qmake_Qdiv. Qed.

Lemma positive_denominator (d : positive) : 0 < inject_Z (Zpos d).
Proof. reflexivity. Qed.

Lemma value_is (l : line) (p : hpoint) : inject_Z (value l p) == value_at l (vector_of p) * inject_Z (Zpos (pw p)).
Proof.
  pose proof (positive_denominator (pw p)). unfold value, value_at, vector_of. cbn [vx vy].
  rewrite !as_quotient, !inject_Z_plus, !inject_Z_mult. field. lra.
Qed.

Lemma value_positive (l : line) (p : hpoint) : (0 < value l p)%Z <-> 0 < value_at l (vector_of p).
Proof.
  pose proof (positive_denominator (pw p)) as w. rewrite (Zlt_Qlt 0), value_is. change (inject_Z 0) with 0.
  split; intros positive.
  - destruct (Qlt_le_dec 0 (value_at l (vector_of p))) as [| low]; [assumption | exfalso].
    assert (0 <= - value_at l (vector_of p) * inject_Z (Zpos (pw p))) by (apply Qmult_le_0_compat; lra). lra.
  - now apply Qmult_lt_0_compat.
Qed.

Lemma value_negative (l : line) (p : hpoint) : (value l p < 0)%Z <-> value_at l (vector_of p) < 0.
Proof.
  pose proof (positive_denominator (pw p)) as w. rewrite (Zlt_Qlt _ 0), value_is. change (inject_Z 0) with 0.
  split; intros negative_.
  - destruct (Qlt_le_dec (value_at l (vector_of p)) 0) as [| high]; [assumption | exfalso].
    assert (0 <= value_at l (vector_of p) * inject_Z (Zpos (pw p))) by (apply Qmult_le_0_compat; lra). lra.
  - assert (0 < - value_at l (vector_of p) * inject_Z (Zpos (pw p))) by (apply Qmult_lt_0_compat; lra). lra.
Qed.

Lemma value_zero (l : line) (p : hpoint) : (value l p = 0)%Z <-> value_at l (vector_of p) == 0.
Proof.
  pose proof (value_positive l p). pose proof (value_negative l p).
  split; intros zero_.
  - destruct (Q_dec (value_at l (vector_of p)) 0) as [[low | high] |]; [exfalso; apply H0 in low; lia | exfalso; apply H in high; lia | assumption].
  - destruct (Z.lt_trichotomy (value l p) 0) as [low | [| high]]; [apply H0 in low; lra | assumption | apply H in high; lra].
Qed.

Lemma value_not_negative (l : line) (p : hpoint) : (0 <= value l p)%Z <-> 0 <= value_at l (vector_of p).
Proof.
  pose proof (value_negative l p) as negative_. split; intros.
  - apply Qnot_lt_le. intros low. apply negative_ in low. lia.
  - apply Z.nlt_ge. intros low. apply negative_ in low. lra.
Qed.

Lemma value_not_positive (l : line) (p : hpoint) : (value l p <= 0)%Z <-> value_at l (vector_of p) <= 0.
Proof.
  pose proof (value_positive l p) as positive_. split; intros.
  - apply Qnot_lt_le. intros high. apply positive_ in high. lia.
  - apply Z.nlt_ge. intros high. apply positive_ in high. lra.
Qed.

(* How far x is to the left of the line from a to b. *)
Definition turn_of (a b x : vector) : Q := (vx b - vx a) * (vy x - vy a) - (vy b - vy a) * (vx x - vx a).

Lemma value_of_line_through (a b : hpoint) (x : vector) :
  value_at (line_through a b) x ==
  turn_of (vector_of a) (vector_of b) x * (inject_Z (Zpos (pw a)) * inject_Z (Zpos (pw b))).
Proof.
  pose proof (positive_denominator (pw a)). pose proof (positive_denominator (pw b)).
  unfold value_at, line_through, turn_of, vector_of. cbn [la lb lc vx vy]. rewrite !as_quotient.
  unfold Zminus. rewrite ?inject_Z_plus, ?inject_Z_opp, ?inject_Z_mult. field. split; lra.
Qed.

Lemma same_is_equal (a b : hpoint) : same_hpoint a b = true -> a = b.
Proof.
  unfold same_hpoint. rewrite !andb_true_iff, !Z.eqb_eq, Pos.eqb_eq. destruct a, b. cbn. now intros [[-> ->] ->].
Qed.

Lemma vector_of_plus (a b : hpoint) : equal_vectors (vector_of (hplus a b)) (added (vector_of a) (vector_of b)).
Proof.
  pose proof (positive_denominator (pw a)). pose proof (positive_denominator (pw b)).
  unfold hplus, vector_of, added, equal_vectors. destruct (Pos.eqb_spec (pw a) (pw b)) as [equal_ |]; cbn [vx vy px py pw].
  - rewrite !as_quotient, <- equal_, !inject_Z_plus. split; field; lra.
  - rewrite !as_quotient, Pos2Z.inj_mul, !inject_Z_plus, !inject_Z_mult. split; field; split; lra.
Qed.

Lemma vector_of_minus (a b : hpoint) : equal_vectors (added (vector_of (hminus a b)) (vector_of b)) (vector_of a).
Proof.
  destruct (vector_of_plus a (negated b)) as [x_is y_is]. unfold hminus, added, equal_vectors in *. cbn [vx vy] in *.
  rewrite x_is, y_is. unfold vector_of, negated. cbn [vx vy px py pw]. rewrite !as_quotient, !inject_Z_opp.
  pose proof (positive_denominator (pw b)). pose proof (positive_denominator (pw a)). split; field; split; lra.
Qed.

Lemma homogeneous_is (p : point) : equal_vectors (vector_of (homogeneous p)) (Vector (x_of p) (y_of p)).
Proof.
  destruct p as [x y]. unfold homogeneous, vector_of, equal_vectors. cbn [x_of y_of vx vy px py pw].
  pose proof (Qred_correct x) as x_is. pose proof (Qred_correct y) as y_is.
  destruct (Qred x) as [a c], (Qred y) as [b d]. cbn [Qnum Qden]. rewrite <- x_is, <- y_is. clear x y x_is y_is.
  destruct (Z.gcd_divide_l (Zpos c) (Zpos d)) as [m m_is]. destruct (Z.gcd_divide_r (Zpos c) (Zpos d)) as [n n_is].
  pose proof (Z.gcd_nonneg (Zpos c) (Zpos d)) as sign. set (g := Z.gcd (Zpos c) (Zpos d)) in *. clearbody g.
  pose proof (Pos2Z.is_pos c). pose proof (Pos2Z.is_pos d).
  assert (0 < g)%Z by (destruct (Z.eq_dec g 0) as [zero_ |]; [rewrite zero_ in m_is |]; lia).
  assert (0 < m)%Z by nia. assert (0 < n)%Z by nia.
  assert (c_part : (Zpos c / g)%Z = m) by (rewrite m_is; now apply Z.div_mul; lia).
  assert (d_part : (Zpos d / g)%Z = n) by (rewrite n_is; now apply Z.div_mul; lia).
  rewrite c_part, d_part. unfold Qeq. cbn [Qnum Qden]. rewrite !Z2Pos.id by lia. split; [ring |]. rewrite n_is, m_is. ring.
Qed.
