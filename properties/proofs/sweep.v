(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* How often turning from one direction to the next passes a third, and that around a closed sequence
   of directions it does not matter which third. Winding numbers and turning numbers are such sums. *)
From Coq Require Import QArith Lqa ZArith Lia Bool List SetoidList SetoidPermutation.
From Oplus Require Import direction.
Import ListNotations.

Open Scope Q_scope.

(* Turning by less than pi, left or right, from `from` to `to`, which are of the other summand than d:
   1 if d is passed counterclockwise, -1 if clockwise, 0 if not. *)
Definition sweep (d : direction) (from to : vector) : Z :=
  let from_ := Direction from (other (of d)) in
  let to_ := Direction to (other (of d)) in
  match (cross from to ?= 0)%Q with
  | Gt => Z.b2z (ccw d from_ to_)
  | Eq => 0
  | Lt => - Z.b2z (ccw d to_ from_)
  end.

(* Neither is zero, and they are not opposite: the turn by less than pi is defined. *)
Definition turns (from to : vector) : Prop :=
  nonzero from /\ nonzero to /\ (cross from to == 0 -> 0 < dot from to).

(* The sum over a list of numbers. *)
Definition sum (numbers : list Z) : Z := fold_right Z.add 0%Z numbers.

Lemma equal_comparison x y : (x ?= y) = Eq -> x == y.
Proof. apply (proj2 (Qeq_alt x y)). Qed.
Lemma less_comparison x y : (x ?= y) = Lt -> x < y.
Proof. apply (proj2 (Qlt_alt x y)). Qed.
Lemma greater_comparison x y : (x ?= y) = Gt -> y < x.
Proof. apply (proj2 (Qgt_alt x y)). Qed.

(* Case analysis of a comparison, with what it says about its sides. *)
Ltac compared c :=
  let E := fresh "C" in
  destruct c eqn:E;
  [ apply equal_comparison in E | apply less_comparison in E | apply greater_comparison in E ].

Lemma compare_as_difference : forall x y z t, y - x == t - z -> (x ?= y) = (z ?= t).
Proof.
  intros x y z t E. compared (z ?= t).
  - apply (proj1 (Qeq_alt _ _)); lra.
  - apply (proj1 (Qlt_alt _ _)); lra.
  - apply (proj1 (Qgt_alt _ _)); lra.
Qed.

Lemma half_false : forall v, nonzero v -> half v = false -> 0 < vy v \/ (vy v == 0 /\ 0 < vx v).
Proof.
  intros [x y]; unfold nonzero, half, negative, zero; cbn; intros N H.
  compared (y ?= 0); compared (x ?= 0); cbn in H; try discriminate; tauto.
Qed.

Lemma half_true : forall v, half v = true -> vy v < 0 \/ (vy v == 0 /\ vx v < 0).
Proof.
  intros [x y]; unfold half, negative, zero; cbn; intros H.
  compared (y ?= 0); compared (x ?= 0); cbn in H; try discriminate; tauto.
Qed.

Ltac halves v :=
  let H := fresh "H" in
  destruct (half v) eqn:H; [apply half_true in H | apply half_false in H; [|assumption]].

(* On which side of the ray from the origin along d a point is, strictly to its left or not; the ray
   is turned by an infinitesimal: counterclockwise if `side` is OfQ, so that points on it are not to
   its left, clockwise if it is OfP. *)
Definition left_of_ray (side : summand) (d a : vector) : bool :=
  match side with OfQ => negative (cross a d) | OfP => negb (negative (cross d a)) end.

Lemma crossed_to_the_left : forall k d a b,
  nonzero d -> nonzero a -> nonzero b -> 0 < cross a b ->
  ccw (Direction d k) (Direction a (other k)) (Direction b (other k)) =
  negb (left_of_ray k d a) && left_of_ray k d b.
Proof.
  intros k [dx dy] [ax ay] [bx by_] ND NA NB G.
  assert (X : cross (Vector ax ay) (Vector bx by_) * dx ==
              (dx * by_ - dy * bx) * ax - (dx * ay - dy * ax) * bx) by (unfold cross; cbn; ring).
  assert (Y : cross (Vector ax ay) (Vector bx by_) * dy ==
              (dx * by_ - dy * bx) * ay - (dx * ay - dy * ax) * by_) by (unfold cross; cbn; ring).
  unfold ccw, before, compare, compare_angle, left_of_ray, negative; cbn [vec of].
  halves (Vector ax ay); halves (Vector bx by_); halves (Vector dx dy).
  all: clear ND NA NB; unfold cross in *; cbn [vx vy] in *.
  all: set (A := dx * ay - dy * ax) in *; set (B := dx * by_ - dy * bx) in *;
    set (g := ax * by_ - ay * bx) in *.
  all: rewrite ?(compare_as_difference (ay * dx) (ax * dy) A 0) by (subst A B g; ring).
  all: rewrite ?(compare_as_difference (ax * dy - ay * dx) 0 0 A) by (subst A B g; ring).
  all: rewrite ?(compare_as_difference (bx * dy - by_ * dx) 0 0 B) by (subst A B g; ring).
  all: rewrite ?(compare_as_difference (by_ * dx) (bx * dy) B 0) by (subst A B g; ring).
  all: rewrite ?(compare_as_difference (ay * bx) (ax * by_) 0 g) by (subst A B g; ring).
  all: rewrite ?(compare_as_difference (dy * ax) (dx * ay) 0 A) by (subst A B g; ring).
  all: rewrite ?(compare_as_difference (dy * bx) (dx * by_) 0 B) by (subst A B g; ring).
  all: rewrite ?(proj1 (Qlt_alt 0 g) G).
  all: rewrite <- ?(Qcompare_antisym 0 A), <- ?(Qcompare_antisym 0 B).
  all: clearbody A B g.
  all: compared (0 ?= A); compared (0 ?= B); destruct k; cbn; try reflexivity; exfalso.
  all: repeat match goal with H : _ \/ _ |- _ => destruct H as [? | [? ?]] end; nra.
Qed.

Lemma compare_antisymmetric : forall a b, compare b a = CompOpp (compare a b).
Proof.
  intros [[ax ay] s] [[bx by_] t]; unfold compare, compare_angle; cbn [vec of vx vy].
  destruct (half (Vector ax ay)), (half (Vector bx by_)); try reflexivity;
    rewrite (compare_as_difference (by_ * ax) (bx * ay) (ax * by_) (ay * bx)) by ring;
    rewrite <- (Qcompare_antisym (ay * bx) (ax * by_));
    destruct (ay * bx ?= ax * by_), s, t; reflexivity.
Qed.

Lemma same_half_transitive : forall u v w,
  nonzero v -> half u = half v -> half v = half w ->
  vy u * vx v <= vx u * vy v -> vy v * vx w <= vx v * vy w ->
  vy u * vx w <= vx u * vy w.
Proof.
  intros [ux uy] [vx vy] [wx wy]; unfold nonzero, half, negative, zero; cbn [direction.vx direction.vy].
  intros N HU HW A B.
  compared (uy ?= 0); compared (vy ?= 0); compared (wy ?= 0); compared (ux ?= 0); compared (vx ?= 0);
    compared (wx ?= 0); cbn in HU, HW; try discriminate; try tauto; nra.
Qed.

Lemma compare_angle_antisymmetric : forall u v, compare_angle v u = CompOpp (compare_angle u v).
Proof.
  intros u v. pose proof (compare_antisymmetric (Direction u OfP) (Direction v OfP)) as H.
  unfold compare in H; cbn [vec of] in H.
  destruct (compare_angle u v), (compare_angle v u); cbn in *; congruence.
Qed.

Lemma compare_angle_not_greater : forall u v w,
  nonzero v -> compare_angle u v <> Gt -> compare_angle v w <> Gt -> compare_angle u w <> Gt.
Proof.
  intros u v w N A B G. unfold compare_angle in *.
  pose proof (same_half_transitive u v w N) as T.
  destruct (half u), (half v), (half w); try congruence;
    apply greater_comparison in G;
    refine (Qlt_not_le _ _ G (T eq_refl eq_refl _ _)); apply Qle_alt; assumption.
Qed.

Lemma compare_angle_transitive : forall u v w,
  nonzero u -> nonzero v -> nonzero w ->
  compare_angle u v <> Gt -> compare_angle v w <> Gt ->
  compare_angle u w =
  match compare_angle u v, compare_angle v w with Eq, Eq => Eq | _, _ => Lt end.
Proof.
  intros u v w Nu Nv Nw A B.
  pose proof (compare_angle_not_greater u v w Nv A B).
  pose proof (compare_angle_not_greater w v u Nv) as C.
  pose proof (compare_angle_not_greater v w u Nw B) as D.
  pose proof (compare_angle_not_greater w u v Nu) as E.
  rewrite (compare_angle_antisymmetric u w), (compare_angle_antisymmetric u v),
    (compare_angle_antisymmetric v w) in *.
  destruct (compare_angle u v), (compare_angle v w), (compare_angle u w); cbn in *;
    intuition congruence.
Qed.

Lemma before_transitive : forall a b c,
  proper a -> proper b -> proper c -> before a b = true -> before b c = true -> before a c = true.
Proof.
  unfold proper, before, compare. intros a b c A B C AB BC.
  pose proof (compare_angle_transitive (vec a) (vec b) (vec c) A B C) as T.
  destruct (compare_angle (vec a) (vec b)), (compare_angle (vec b) (vec c)); try congruence;
    rewrite T by congruence; try reflexivity.
  destruct (of a), (of b), (of c); congruence.
Qed.

(* Of two directions that are not equal, one is before the other. *)
Lemma before_total : forall a b, compare a b <> Eq -> before a b = negb (before b a).
Proof.
  unfold before. intros a b N. rewrite (compare_antisymmetric a b).
  destruct (compare a b); cbn; congruence.
Qed.

Lemma never_equal : forall u v s, compare (Direction u s) (Direction v (other s)) <> Eq.
Proof.
  unfold compare; cbn. intros u v s. destruct (compare_angle u v), s; cbn; congruence.
Qed.

(* The key: what passing d depends on d with is a difference of two terms, one of each end. *)
Lemma ccw_as_difference : forall d a b,
  proper d -> proper a -> proper b ->
  compare d b <> Eq -> compare a b <> Eq ->
  Z.b2z (ccw d a b) = (Z.b2z (before a d) - Z.b2z (before b d) + Z.b2z (before b a))%Z.
Proof.
  intros d a b D A B DB AB.
  pose proof (before_transitive a b d A B D) as T.
  pose proof (before_transitive b a d B A D) as U.
  unfold ccw. rewrite (before_total d b DB).
  unfold before in T, U |- *. rewrite (compare_antisymmetric a b) in *.
  destruct (compare a b); try congruence; cbn in *;
    destruct (compare a d), (compare b d); cbn in *; try reflexivity;
    try (specialize (T eq_refl eq_refl)); try (specialize (U eq_refl eq_refl)); congruence.
Qed.

(* Whether the positive x-axis is passed, or reached, counterclockwise or clockwise. *)
Definition passes_axis (from to : vector) : Z :=
  match (cross from to ?= 0)%Q with
  | Gt => Z.b2z (before (Direction to OfP) (Direction from OfP))
  | Eq => 0
  | Lt => - Z.b2z (before (Direction from OfP) (Direction to OfP))
  end.

Definition is_before (a : vector) (d : direction) : Z := Z.b2z (before (Direction a (other (of d))) d).

Lemma before_of_one_summand : forall u v s t,
  before (Direction u s) (Direction v s) = before (Direction u t) (Direction v t).
Proof.
  unfold before, compare; cbn. intros u v s t. destruct (compare_angle u v), s, t; reflexivity.
Qed.

(* Equal angles are same directions. *)
Lemma compare_angle_equal : forall u v, nonzero u -> nonzero v ->
  (compare_angle u v = Eq <-> cross u v == 0 /\ 0 < dot u v).
Proof.
  intros [ux uy] [vx vy] U V. unfold compare_angle, cross, dot.
  assert (Y : vy * (ux * vx + uy * vy) == uy * (vx * vx + vy * vy) + vx * (ux * vy - uy * vx)) by ring.
  assert (X : vx * (ux * vx + uy * vy) == ux * (vx * vx + vy * vy) - vy * (ux * vy - uy * vx)) by ring.
  assert (S : 0 < vx * vx + vy * vy).
  { unfold nonzero in V; cbn in V. destruct (Qlt_le_dec 0 (vx * vx + vy * vy)) as [|L]; [assumption|].
    exfalso. apply V. split; nra. }
  halves (Vector ux uy); halves (Vector vx vy); cbn [direction.vx direction.vy] in *; clear U V;
    set (d := ux * vx + uy * vy) in *; set (s := vx * vx + vy * vy) in *;
    clearbody d s;
    (split; [intros E | intros [E F]]);
    try discriminate; try apply equal_comparison in E;
    assert (Z : ux * vy - uy * vx == 0) by lra; rewrite Z in X, Y;
    repeat match goal with H : _ \/ _ |- _ => destruct H as [? | [? ?]] end;
    first [ split; nra | exfalso; nra | apply (proj1 (Qeq_alt _ _)); lra ].
Qed.

Lemma equal_angles : forall u v w, nonzero u -> nonzero v -> nonzero w ->
  compare_angle u v = Eq -> compare_angle u w = compare_angle v w.
Proof.
  intros u v w U V W E.
  assert (F : compare_angle v u = Eq) by (rewrite compare_angle_antisymmetric, E; reflexivity).
  pose proof (compare_angle_transitive u v w U V W) as A.
  pose proof (compare_angle_transitive v u w V U W) as B.
  rewrite E in A. rewrite F in B.
  destruct (compare_angle u w), (compare_angle v w); try reflexivity;
    solve [symmetry; apply A; congruence | apply A; congruence
          | apply B; congruence | symmetry; apply B; congruence ].
Qed.

(* What passing d adds to the potential `is_before`, the axis pays for: whatever d is. *)
Lemma sweep_as_difference : forall d u v,
  proper d -> turns u v ->
  sweep d u v = (is_before u d - is_before v d + passes_axis u v)%Z.
Proof.
  intros [d s] u v D (U & V & N). unfold sweep, passes_axis, is_before; cbn [of].
  assert (AB : ~ cross u v == 0 -> compare (Direction u (other s)) (Direction v (other s)) <> Eq).
  { intros C E. apply C. apply (compare_angle_equal u v U V).
    unfold compare in E; cbn in E. destruct (compare_angle u v), s; cbn in E; congruence. }
  assert (BA : ~ cross u v == 0 -> compare (Direction v (other s)) (Direction u (other s)) <> Eq).
  { intros C. rewrite compare_antisymmetric. specialize (AB C).
    destruct (compare (Direction u (other s)) (Direction v (other s))); cbn; congruence. }
  compared (cross u v ?= 0).
  - assert (compare_angle u v = Eq) as E by (apply compare_angle_equal; auto).
    unfold before, compare; cbn. rewrite (equal_angles u v d); auto. lia.
  - rewrite ccw_as_difference; auto using never_equal.
    + rewrite (before_of_one_summand u v OfP (other s)). lia.
    + apply BA. lra.
  - rewrite ccw_as_difference; auto using never_equal.
    + rewrite (before_of_one_summand v u OfP (other s)). lia.
    + apply AB. lra.
Qed.

(* Pairs of directions, one turned to the other, in any order; closed if each direction is turned
   from as often as it is turned to, the same vector however its coordinates are written. *)
Definition equal_vectors (u v : vector) : Prop := vx u == vx v /\ vy u == vy v.

Definition closed (pairs : list (vector * vector)) : Prop :=
  PermutationA equal_vectors (map fst pairs) (map snd pairs).

Global Instance equal_vectors_equivalence : Equivalence equal_vectors.
Proof.
  split; unfold equal_vectors.
  - intros u; split; reflexivity.
  - intros u v [? ?]; split; symmetry; assumption.
  - intros u v w [? ?] [? ?]; split; etransitivity; eassumption.
Qed.

Definition total (f : vector * vector -> Z) (pairs : list (vector * vector)) : Z := sum (map f pairs).

Lemma total_of_two_lists : forall f some others,
  total f (some ++ others) = (total f some + total f others)%Z.
Proof.
  intros f some others. unfold total, sum. induction some as [| p rest IH]; cbn; lia.
Qed.

Lemma sum_of_permuted : forall (f : vector -> Z),
  (forall u v, equal_vectors u v -> f u = f v) ->
  forall us vs, PermutationA equal_vectors us vs -> sum (map f us) = sum (map f vs).
Proof.
  intros f F us vs P. unfold sum. induction P; cbn; try rewrite (F _ _ H); lia.
Qed.

Lemma closed_total : forall (f : vector -> Z) g h pairs,
  (forall u v, equal_vectors u v -> f u = f v) -> closed pairs ->
  (forall u v, In (u, v) pairs -> h (u, v) = (f u - f v + g (u, v))%Z) ->
  total h pairs = total g pairs.
Proof.
  intros f g h pairs F C H. apply (sum_of_permuted f F) in C.
  assert (total h pairs = sum (map f (map fst pairs)) - sum (map f (map snd pairs)) + total g pairs)%Z.
  { clear C. unfold total, sum. induction pairs as [| [u v] rest IH]; cbn; [reflexivity |].
    rewrite (H u v) by (left; reflexivity).
    rewrite IH by (intros; apply H; right; assumption). lia. }
  lia.
Qed.

Lemma compare_angle_of_equal : forall u v w,
  equal_vectors u v -> compare_angle u w = compare_angle v w.
Proof.
  intros u v w [X Y]. unfold compare_angle.
  replace (half u) with (half v) by (unfold half, negative, zero; rewrite X, Y; reflexivity).
  destruct (half v), (half w); try reflexivity; rewrite X, Y; reflexivity.
Qed.

(* Around a closed sequence each direction is passed equally often, counterclockwise less clockwise. *)
Theorem sweeps_are_equal : forall pairs d e,
  closed pairs -> (forall u v, In (u, v) pairs -> turns u v) -> proper d -> proper e ->
  total (fun p => sweep d (fst p) (snd p)) pairs = total (fun p => sweep e (fst p) (snd p)) pairs.
Proof.
  intros pairs d e C T.
  assert (forall d, proper d -> total (fun p => sweep d (fst p) (snd p)) pairs =
                                total (fun p => passes_axis (fst p) (snd p)) pairs) as A.
  { clear d e. intros d D.
    apply closed_total with (f := fun u => is_before u d); cbn; [| assumption |].
    - intros u v E. unfold is_before, before, compare; cbn.
      rewrite (compare_angle_of_equal u v (vec d) E). reflexivity.
    - intros u v I. apply sweep_as_difference; auto. }
  intros D E. rewrite (A d D), (A e E). reflexivity.
Qed.
