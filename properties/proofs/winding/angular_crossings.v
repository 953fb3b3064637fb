(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* How often turning from one direction to the next passes a third, and that around a closed sequence
   of directions it does not matter which third. Winding numbers and turning numbers are such sums. *)
From Coq Require Import ZArith Lia Bool List SetoidList SetoidPermutation.
From Oplus Require Import numbers directions.
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

Lemma sum_of_both (l m : list Z) : sum (l ++ m) = (sum l + sum m)%Z.
Proof. unfold sum. induction l; cbn; lia. Qed.

Lemma sum_of_zeros A (f : A -> Z) l : (forall a, In a l -> f a = 0%Z) -> sum (map f l) = 0%Z.
Proof.
  intros zeros. unfold sum. induction l as [| a l IH]; [reflexivity |]. cbn.
  rewrite (zeros a (or_introl eq_refl)), IH by (intros b I; apply zeros; now right). reflexivity.
Qed.

(* Sums that differ in one place. *)
Lemma sums_but_for_one A (f g : A -> Z) before a after : (forall b, In b (before ++ after) -> f b = g b) ->
  sum (map f (before ++ a :: after)) = (sum (map g (before ++ a :: after)) - g a + f a)%Z.
Proof.
  intros same_. rewrite !map_app, !sum_of_both. cbn [map]. rewrite (map_ext_in f g before), (map_ext_in f g after);
    [unfold sum; cbn; lia | |]; intros b I; apply same_, in_app_iff; tauto.
Qed.

Lemma equal_comparison x y : (x ?= y) = Eq -> x == y.
Proof. apply (proj2 (Qeq_alt x y)). Qed.
Lemma less_comparison x y : (x ?= y) = Lt -> x < y.
Proof. apply (proj2 (Qlt_alt x y)). Qed.
Lemma greater_comparison x y : (x ?= y) = Gt -> y < x.
Proof. apply (proj2 (Qgt_alt x y)). Qed.

(* Case analysis of a comparison of numbers, with what it says about them. *)
Ltac compared_numbers c :=
  let E := fresh "C" in
  destruct c eqn:E;
  [ apply equal_comparison in E | apply less_comparison in E | apply greater_comparison in E ].

Lemma compare_as_difference : forall x y z t, y - x == t - z -> (x ?= y) = (z ?= t).
Proof. intros x y z t E. destruct (Qcompare_spec x y), (Qcompare_spec z t); trivial; exfalso; lra. Qed.

(* On which side of the ray from the origin along d a point is, strictly to its left or not; the ray
   is turned by an infinitesimal: counterclockwise if `side` is OfQ, so that points on it are not to
   its left, clockwise if it is OfP. *)
Definition left_of_ray (side : summand) (d a : vector) : bool :=
  match side with OfQ => negative (cross a d) | OfP => negb (negative (cross d a)) end.

(* Seen from the origin, a ray is crossed by a turn to the left iff its direction is met on the way. *)
Lemma crossed_to_the_left : forall k d a b,
  nonzero d -> nonzero a -> nonzero b -> 0 < cross a b ->
  ccw (Direction d k) (Direction a (other k)) (Direction b (other k)) =
  negb (left_of_ray k d a) && left_of_ray k d b.
Proof.
  intros k d a b D A B G.
  pose proof (cross_angle d a D A) as DA. pose proof (cross_angle d b D B) as DB.
  pose proof (cross_angle a b A B) as AB.
  pose proof (angle_range d D). pose proof (angle_range a A). pose proof (angle_range b B).
  assert (a_first : forall c, cross c d == - cross d c) by (intros; unfold cross; ring).
  destruct (ccw_spec (Direction d k) (Direction a (other k)) (Direction b (other k)) D A B) as [I | I];
    unfold left_of_ray, in_order, earlier, place, turns_by in *; destruct k; cbn [vec of other] in *;
    destruct (negative_spec (cross a d)), (negative_spec (cross b d)), (negative_spec (cross d a)),
      (negative_spec (cross d b)); cbn; try reflexivity; rewrite ?a_first in *; exfalso; lra.
Qed.

(* The key: what passing d depends on d with is a difference of two terms, one of each end. *)
Lemma ccw_as_difference : forall d a b,
  proper d -> proper a -> proper b -> of a <> of d -> of b <> of d -> compare a b <> Eq ->
  Z.b2z (ccw d a b) = (Z.b2z (before a d) - Z.b2z (before b d) + Z.b2z (before b a))%Z.
Proof.
  intros d a b D A B DA DB AB.
  assert (~ equal a b) by (intro; revert AB; compared a b; intros AB; [tauto | order | order]).
  assert (~ place a == place d) by now rewrite place_of.
  assert (~ place b == place d) by now rewrite place_of.
  destruct (ccw_spec d a b D A B), (before_spec a d A D), (before_spec b d B D), (before_spec b a B A);
    try reflexivity; exfalso; unfold in_order in *; order.
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
Proof. unfold before, compare; cbn. intros u v s t. destruct (compare_angle u v), s, t; reflexivity. Qed.

(* What passing d adds to the potential `is_before`, the axis pays for: whatever d is. *)
Lemma sweep_as_difference : forall d u v,
  proper d -> turns u v ->
  sweep d u v = (is_before u d - is_before v d + passes_axis u v)%Z.
Proof.
  intros [d s] u v D (U & V & N). unfold sweep, passes_axis, is_before; cbn [of].
  pose proof (cross_angle u v U V) as T. unfold turns_by in T.
  assert (of_d : forall w, of (Direction w (other s)) <> of (Direction d s))
    by (intros w; destruct s; discriminate).
  assert (apart : forall a b t, nonzero a -> nonzero b -> ~ angle a == angle b ->
    compare (Direction a t) (Direction b t) <> Eq).
  { intros a b t A B C. compared (Direction a t) (Direction b t); [| discriminate ..].
    exfalso. unfold equal in *. cbn [vec] in *. lra. }
  compared_numbers (cross u v ?= 0).
  - assert (F : angle u == angle v) by (specialize (N C); lra).
    destruct (before_spec (Direction u (other s)) (Direction d s) U D),
      (before_spec (Direction v (other s)) (Direction d s) V D); try reflexivity;
      exfalso; unfold earlier in *; cbn [vec] in *; unfold place in *; cbn [of] in *; lra.
  - rewrite ccw_as_difference; auto; [| apply apart; trivial; lra].
    rewrite (before_of_one_summand u v OfP (other s)). lia.
  - rewrite ccw_as_difference; auto; [| apply apart; trivial; lra].
    rewrite (before_of_one_summand v u OfP (other s)). lia.
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

Lemma sum_of_permuted : forall (f : vector -> Z),
  (forall u v, equal_vectors u v -> f u = f v) ->
  forall us vs, PermutationA equal_vectors us vs -> sum (map f us) = sum (map f vs).
Proof. intros f F us vs P. unfold sum. induction P; cbn; try rewrite (F _ _ H); lia. Qed.

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

Lemma compare_angle_of_equal : forall u u' v v',
  equal_vectors u u' -> equal_vectors v v' -> compare_angle u v = compare_angle u' v'.
Proof.
  assert (halves : forall u v, equal_vectors u v -> half u = half v)
    by (intros u v [X Y]; unfold half, negative, zero; rewrite X, Y; reflexivity).
  intros u u' v v' U V. unfold compare_angle. rewrite (halves u u' U), (halves v v' V).
  destruct U as [X Y], V as [X' Y'], (half u'), (half v'); trivial; now rewrite X, Y, X', Y'.
Qed.

Lemma sweeps_are_axis : forall pairs d,
  closed pairs -> (forall u v, In (u, v) pairs -> turns u v) -> proper d ->
  total (fun p => sweep d (fst p) (snd p)) pairs =
  total (fun p => passes_axis (fst p) (snd p)) pairs.
Proof.
  intros pairs d C T D. apply closed_total with (f := fun u => is_before u d); cbn; [| assumption |].
  - intros u v E. unfold is_before, before, compare; cbn.
    now rewrite (compare_angle_of_equal u v (vec d) (vec d) E (reflexivity _)).
  - intros u v I. apply sweep_as_difference; auto.
Qed.

(* Theorem. Around a closed sequence of directions, each turned to the next by less than pi, all
   directions are passed equally often, counterclockwise less clockwise. *)
Theorem sweeps_are_equal : forall pairs d e,
  closed pairs -> (forall u v, In (u, v) pairs -> turns u v) -> proper d -> proper e ->
  total (fun p => sweep d (fst p) (snd p)) pairs = total (fun p => sweep e (fst p) (snd p)) pairs.
Proof. intros pairs d e C T D E. rewrite !sweeps_are_axis by assumption. reflexivity. Qed.
