(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The real numbers by the names that numbers/numbers.v has for the rational ones: with this file in place of that one,
   the theory says the same of real coordinates. So `Q` is Coq's R here, and what is called `Qmult_comm`
   is said of R. Where the theory uses another name, add it. All rests on the axioms of Coq's Reals. *)
From Coq Require Export ZArith Bool Setoid Morphisms Field RealField Lra Psatz.
From Coq Require Import Reals.
From Coq Require Nsatz.

Declare Scope Q_scope.
Delimit Scope Q_scope with Q.
Notation Q := R.
Bind Scope Q_scope with R.
Number Notation R Rdefinitions.of_number Rdefinitions.to_number (via Rdefinitions.IR
  mapping [IZR => Rdefinitions.IRZ, Q2R => Rdefinitions.IRQ, Rmult => Rdefinitions.IRmult, Rdiv => Rdefinitions.IRdiv,
           Z.pow_pos => QArith_base.IZpow_pos, Z0 => QArith_base.IZ0, Zpos => QArith_base.IZpos,
           Zneg => QArith_base.IZneg]) : Q_scope.
Open Scope Q_scope.

Infix "+" := Rplus : Q_scope.
Infix "-" := Rminus : Q_scope.
Infix "*" := Rmult : Q_scope.
Infix "/" := Rdiv : Q_scope.
Notation "- x" := (Ropp x) : Q_scope.
Notation "/ x" := (Rinv x) : Q_scope.
Infix "<" := Rlt : Q_scope.
Infix "<=" := Rle : Q_scope.
Notation "x > y" := (Rlt y x) (only parsing) : Q_scope.
Notation "x >= y" := (Rle y x) (only parsing) : Q_scope.
Notation "x <= y <= z" := (x <= y /\ y <= z) : Q_scope.
Notation "x <= y < z" := (x <= y /\ y < z) : Q_scope.
Notation "x < y <= z" := (x < y /\ y <= z) : Q_scope.
Notation "x < y < z" := (x < y /\ y < z) : Q_scope.
Notation "x == y" := (@eq R x y) (at level 70, no associativity) : Q_scope.
Notation "a # b" := (IZR a%Z / IZR (Zpos b%positive)) (at level 55, no associativity) : Q_scope.
Notation inject_Z := IZR.
Arguments Rmin (_ _)%Q_scope.
Arguments Rabs _%Q_scope.
Notation Qmin := Rmin.
Notation Qabs := Rabs.

(* What setoid_replace shows: with Nsatz comes another relation. *)
#[global] Instance equal_by_default : DefaultRelation (@eq R) := {}.

(* Comparisons. *)
Definition Qcompare (x y : Q) : comparison :=
  match total_order_T x y with inleft (left _) => Lt | inleft (right _) => Eq | inright _ => Gt end.
Infix "?=" := Qcompare (at level 70, no associativity) : Q_scope.

Lemma Qcompare_spec (x y : Q) : CompareSpec (x == y) (x < y) (y < x) (x ?= y).
Proof. unfold Qcompare. destruct (total_order_T x y) as [[? | ?] | ?]; constructor; lra. Qed.

Lemma Qeq_alt (x y : Q) : x == y <-> (x ?= y) = Eq.
Proof. split; destruct (Qcompare_spec x y); intros; trivial; (discriminate || lra). Qed.

Lemma Qlt_alt (x y : Q) : x < y <-> (x ?= y) = Lt.
Proof. split; destruct (Qcompare_spec x y); intros; trivial; (discriminate || lra). Qed.

Lemma Qgt_alt (x y : Q) : x > y <-> (x ?= y) = Gt.
Proof. split; destruct (Qcompare_spec x y); intros; trivial; (discriminate || lra). Qed.

Lemma Qcompare_antisym (x y : Q) : CompOpp (x ?= y) = (y ?= x).
Proof. destruct (Qcompare_spec x y), (Qcompare_spec y x); trivial; lra. Qed.

Lemma Q_dec (x y : Q) : {x < y} + {y < x} + {x == y}.
Proof. destruct (total_order_T x y) as [[? | ?] | ?]; auto. Qed.

Lemma Qlt_le_dec (x y : Q) : {x < y} + {y <= x}.
Proof. destruct (Q_dec x y) as [[? | ?] | ?]; [left | right | right]; lra. Qed.

Lemma Qeq_dec (x y : Q) : {x == y} + {~ x == y}.
Proof. apply Req_EM_T. Qed.

Definition Qeq_bool (x y : Q) : bool := if Qeq_dec x y then true else false.

Lemma Qeq_bool_iff (x y : Q) : Qeq_bool x y = true <-> x == y.
Proof. unfold Qeq_bool. destruct (Qeq_dec x y); split; intros; trivial; (discriminate || contradiction). Qed.

Lemma Qeq_bool_eq (x y : Q) : Qeq_bool x y = true -> x == y.
Proof. apply Qeq_bool_iff. Qed.

(* Whole numbers. *)
Lemma inject_Z_plus (a b : Z) : inject_Z (a + b) == inject_Z a + inject_Z b.
Proof. apply plus_IZR. Qed.

Lemma Zlt_Qlt (a b : Z) : (a < b)%Z <-> inject_Z a < inject_Z b.
Proof. split; [apply IZR_lt | apply lt_IZR]. Qed.

(* Equations and inequalities. *)
Lemma Qeq_refl (x : Q) : x == x.
Proof. reflexivity. Qed.

Lemma Qopp_comp (x y : Q) : x == y -> - x == - y.
Proof. intros. lra. Qed.

Lemma Qnot_eq_sym (x y : Q) : ~ x == y -> ~ y == x.
Proof. intros. lra. Qed.

Lemma Qplus_comm (x y : Q) : x + y == y + x.
Proof. ring. Qed.

Lemma Qmult_comm (x y : Q) : x * y == y * x.
Proof. ring. Qed.

Lemma Qmult_integral (x y : Q) : x * y == 0 -> x == 0 \/ y == 0.
Proof. apply Rmult_integral. Qed.

Lemma Qmult_inj_r (x y z : Q) : ~ z == 0 -> (x * z == y * z <-> x == y).
Proof. intros some. split; [intros; now apply (Rmult_eq_reg_r z) | now intros ->]. Qed.

Lemma Qmult_inj_l (x y z : Q) : ~ z == 0 -> (z * x == z * y <-> x == y).
Proof. intros some. split; [intros; now apply (Rmult_eq_reg_l z) | now intros ->]. Qed.

Lemma Qle_refl (x : Q) : x <= x.
Proof. lra. Qed.

Lemma Qlt_not_eq (x y : Q) : x < y -> ~ x == y.
Proof. lra. Qed.

Lemma Qnot_le_lt (x y : Q) : ~ x <= y -> y < x.
Proof. lra. Qed.

Lemma Qnot_lt_le (x y : Q) : ~ x < y -> y <= x.
Proof. lra. Qed.

Lemma Qlt_le_trans (x y z : Q) : x < y -> y <= z -> x < z.
Proof. lra. Qed.

Lemma Qmult_lt_0_compat (a b : Q) : 0 < a -> 0 < b -> 0 < a * b.
Proof. apply Rmult_lt_0_compat. Qed.

Lemma Qmult_le_0_compat (a b : Q) : 0 <= a -> 0 <= b -> 0 <= a * b.
Proof. apply Rmult_le_pos. Qed.

Lemma Qmult_le_compat_r (x y z : Q) : x <= y -> 0 <= z -> x * z <= y * z.
Proof. intros. now apply Rmult_le_compat_r. Qed.

Lemma Qmult_lt_r (x y z : Q) : 0 < z -> (x * z < y * z <-> x < y).
Proof. intros. split; [now apply (Rmult_lt_reg_r z) | now apply Rmult_lt_compat_r]. Qed.

Lemma Qmult_lt_l (x y z : Q) : 0 < z -> (z * x < z * y <-> x < y).
Proof. intros. split; [now apply (Rmult_lt_reg_l z) | now apply Rmult_lt_compat_l]. Qed.

Lemma Qmult_lt_0_le_reg_r (x y z : Q) : 0 < z -> x * z <= y * z -> x <= y.
Proof. intros. now apply (Rmult_le_reg_r z). Qed.

Lemma Qinv_lt_0_compat (a : Q) : 0 < a -> 0 < / a.
Proof. apply Rinv_0_lt_compat. Qed.

Lemma Qle_shift_div_l (a b c : Q) : 0 < c -> a * c <= b -> a <= b / c.
Proof. intros. apply (Rmult_le_reg_r c); [| replace (b / c * c) with b by (field; lra)]; trivial. Qed.

Lemma Qle_shift_div_r (a b c : Q) : 0 < b -> a <= c * b -> a / b <= c.
Proof. intros. apply (Rmult_le_reg_r b); [| replace (a / b * b) with a by (field; lra)]; trivial. Qed.

Lemma Qlt_shift_div_l (a b c : Q) : 0 < c -> a * c < b -> a < b / c.
Proof. intros. apply (Rmult_lt_reg_r c); [| replace (b / c * c) with b by (field; lra)]; trivial. Qed.

Lemma Qlt_shift_div_r (a b c : Q) : 0 < b -> a < c * b -> a / b < c.
Proof. intros. apply (Rmult_lt_reg_r b); [| replace (a / b * b) with a by (field; lra)]; trivial. Qed.

(* Absolute values and minima. *)
Lemma Qabs_pos (x : Q) : 0 <= x -> Qabs x == x.
Proof. apply Rabs_pos_eq. Qed.

Lemma Qabs_neg (x : Q) : x <= 0 -> Qabs x == - x.
Proof. apply Rabs_left1. Qed.

Lemma Qabs_nonneg (x : Q) : 0 <= Qabs x.
Proof. apply Rabs_pos. Qed.

Module Q.
  Lemma le_min_l (x y : Q) : Qmin x y <= x.
  Proof. apply Rmin_l. Qed.

  Lemma le_min_r (x y : Q) : Qmin x y <= y.
  Proof. apply Rmin_r. Qed.

  Lemma min_glb_lt (x y z : Q) : z < x -> z < y -> z < Qmin x y.
  Proof. apply Rmin_glb_lt. Qed.
End Q.

(* Numbers in lowest terms: a real number is written in one way. *)
Definition Qred (x : Q) : Q := x.

Lemma Qred_correct (x : Q) : Qred x == x.
Proof. reflexivity. Qed.

Lemma Qred_complete (x y : Q) : x == y -> Qred x = Qred y.
Proof. trivial. Qed.

(* `=` and `==` are one. *)
Definition identical_dec (x y : Q) : {x = y} + {x <> y} := Req_EM_T x y.

Lemma negated_twice (x : Q) : - - x = x.
Proof. ring. Qed.
