(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Turning by less than half a turn over a direction between: it turns to that and on from there, and counts the same.
   For chains whose corners are cut (touching_chains.v). *)
From Coq Require Import ZArith Lia Bool List.
From Oplus Require Import numbers winding strictly_convex_curve.
Import ListNotations.

Open Scope Q_scope.

Lemma turns_respects (u v u' v' : vector) : equal_vectors u u' -> equal_vectors v v' -> turns u' v' -> turns u v.
Proof.
  intros [X Y] [Z W] (some_u & some_v & forwards). unfold turns, nonzero, cross, dot in *. rewrite X, Y, Z, W. tauto.
Qed.

(* What is between two directions, less than half a turn apart, turns from the one and to the other. *)
Lemma turns_between (u v : vector) (k l j : Q) : turns u v -> 0 < k -> 0 < l -> 0 < j ->
  turns (stretched j u) (vector_sum (stretched k u) (stretched l v)) /\
  turns (vector_sum (stretched k u) (stretched l v)) (stretched j v).
Proof.
  intros (some_u & some_v & forwards) K L J. pose proof (square_positive u some_u) as uu.
  pose proof (square_positive v some_v) as vv.
  assert (long : forall w i, nonzero w -> 0 < i -> nonzero (stretched i w)).
  { intros w i some I [X Y]. unfold stretched in X, Y. cbn [vx vy] in X, Y. apply some.
    split; apply (Qmult_inj_l _ _ i); lra. }
  assert (with_u : cross (stretched j u) (vector_sum (stretched k u) (stretched l v)) == j * l * cross u v /\
    dot (stretched j u) (vector_sum (stretched k u) (stretched l v)) == j * (k * dot u u + l * dot u v))
    by (unfold cross, dot, stretched, vector_sum; cbn [vx vy]; split; ring).
  assert (with_v : cross (vector_sum (stretched k u) (stretched l v)) (stretched j v) == j * k * cross u v /\
    dot (vector_sum (stretched k u) (stretched l v)) (stretched j v) == j * (k * dot u v + l * dot v v))
    by (unfold cross, dot, stretched, vector_sum; cbn [vx vy]; split; ring).
  pose proof (products j l J L) as jl. pose proof (products j k J K) as jk.
  assert (ahead : cross u v == 0 -> 0 < dot u v /\ 0 < k * dot u u + l * dot u v /\ 0 < k * dot u v + l * dot v v).
  { intros flat. specialize (forwards flat). split; [exact forwards |]. split; nra. }
  assert (middle : nonzero (vector_sum (stretched k u) (stretched l v))).
  { intros [X Y]. assert (zero_ : cross u v == 0).
    { apply (Qmult_inj_l _ _ (j * l)); [lra |]. rewrite <- (proj1 with_u). unfold cross. rewrite X, Y. ring. }
    destruct (ahead zero_) as (_ & positive_ & _). pose proof (products j _ J positive_) as more.
    rewrite <- (proj2 with_u) in more. unfold dot in more. rewrite X, Y in more. lra. }
  assert (flat_is : forall c, 0 < c -> c * cross u v == 0 -> cross u v == 0)
    by (intros c C zero_; apply (Qmult_inj_l _ _ c); lra).
  split; (split; [now apply long || exact middle |]; split; [now apply long || exact middle |]).
  - rewrite (proj1 with_u), (proj2 with_u). intros zero_. apply products; [exact J |].
    apply ahead, (flat_is _ jl zero_).
  - rewrite (proj1 with_v), (proj2 with_v). intros zero_. apply products; [exact J |].
    apply ahead, (flat_is _ jk zero_).
Qed.

(* Turning over a direction between counts what turning at once does. *)
Lemma sweep_over_a_direction_between (d u v w : vector) (s : summand) (k l : Q) : nonzero d -> turns u v ->
  ~ cross d u == 0 -> ~ cross d v == 0 -> 0 < k -> 0 < l ->
  equal_vectors w (vector_sum (stretched k u) (stretched l v)) -> nonzero w ->
  (sweep (Direction d s) u w + sweep (Direction d s) w v = sweep (Direction d s) u v)%Z.
Proof.
  intros some (some_u & some_v & forwards) beside_u beside_v K L [X Y] some_w.
  rewrite !sweep_by_sides by assumption. unfold vector_sum, stretched in X, Y. cbn [vx vy] in X, Y.
  assert (uw : cross u w == l * cross u v) by (unfold cross; rewrite X, Y; ring).
  assert (wv : cross w v == k * cross u v) by (unfold cross; rewrite X, Y; ring).
  assert (dw : cross d w == k * cross d u + l * cross d v) by (unfold cross; rewrite X, Y; ring).
  assert (turned : forall c, cross c d == - cross d c) by (intros; unfold cross; ring).
  assert (sign_of_product : forall c, 0 < c -> (c * cross u v ?= 0) = (cross u v ?= 0)).
  { intros c C. compared_numbers (cross u v ?= 0); compared_numbers (c * cross u v ?= 0); trivial; exfalso; nra. }
  assert (uw_sign : (cross u w ?= 0) = (cross u v ?= 0)).
  { rewrite (compare_as_difference (cross u w) 0 (l * cross u v) 0) by (rewrite uw; ring). now apply sign_of_product. }
  assert (wv_sign : (cross w v ?= 0) = (cross u v ?= 0)).
  { rewrite (compare_as_difference (cross w v) 0 (k * cross u v) 0) by (rewrite wv; ring). now apply sign_of_product. }
  rewrite uw_sign, wv_sign.
  assert (between_ : left_of_ray s d u = left_of_ray s d v -> left_of_ray s d w = left_of_ray s d u).
  { assert (both_left : 0 < cross d u -> 0 < cross d v -> 0 < cross d w).
    { intros A B. pose proof (products k _ K A). pose proof (products l _ L B). lra. }
    assert (both_right : cross d u < 0 -> cross d v < 0 -> cross d w < 0).
    { intros A B. pose proof (products k (- cross d u) K ltac:(lra)).
      pose proof (products l (- cross d v) L ltac:(lra)). lra. }
    unfold left_of_ray. pose proof (turned u). pose proof (turned v). pose proof (turned w).
    destruct (Q_dec (cross d u) 0) as [[u_right | u_left] | ?]; [| | contradiction];
      (destruct (Q_dec (cross d v) 0) as [[v_right | v_left] | ?]; [| | contradiction]);
      try specialize (both_left u_left v_left); try specialize (both_right u_right v_right);
      (destruct s; [destruct (negative_spec (cross d u)), (negative_spec (cross d v)), (negative_spec (cross d w)) |
        destruct (negative_spec (cross u d)), (negative_spec (cross v d)), (negative_spec (cross w d))]);
      intros equal; trivial; try discriminate equal; exfalso; lra. }
  destruct (left_of_ray s d u), (left_of_ray s d v), (left_of_ray s d w); try (specialize (between_ eq_refl);
    discriminate);
    unfold ray_crossing; cbn [negb Bool.eqb]; destruct (cross u v ?= 0); reflexivity.
Qed.
