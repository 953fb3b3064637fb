(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* A closed curve around the origin that is strictly convex and has a point with rational coordinates on each ray, which
   a circle has not: where gauge is 1, four arcs of ellipses. Chords of it with the ends of the one on one side of the
   other have no point in common, and what is on a ray, on the curve or further out, has none with a chord that does
   not end on that ray. For touching_chains.v. *)
From Coq Require Import Bool List.
From Oplus Require Import numbers winding neighbourhoods.
Import ListNotations.

Open Scope Q_scope.

(* Of two numbers that are not negative, and not both zero. *)
Definition gauge_of (a b : Q) : Q := (a * a + a * b + b * b) / (a + b).

Definition gauge (u : vector) : Q := gauge_of (Qabs (vx u)) (Qabs (vy u)).

Lemma abs_sum_is_positive (u : vector) : nonzero u -> 0 < Qabs (vx u) + Qabs (vy u).
Proof.
  intros some. destruct (abs_cases (vx u)) as [[x_sign ->] | [x_sign ->]],
    (abs_cases (vy u)) as [[y_sign ->] | [y_sign ->]];
    (destruct (Qeq_dec (vx u) 0), (Qeq_dec (vy u) 0); [exfalso; now apply some | lra ..]).
Qed.

Lemma products (s t : Q) : 0 < s -> 0 < t -> 0 < s * t.
Proof. intros. nra. Qed.

Lemma quotients_by_sign (e f : Q) : 0 < f -> (0 <= e -> 0 <= e / f) /\ (0 < e -> 0 < e / f).
Proof. intros some. split; intros sign; [apply Qle_shift_div_l | apply Qlt_shift_div_l]; lra. Qed.

Lemma squares (e : Q) : 0 <= e * e /\ (~ e == 0 -> 0 < e * e).
Proof. split; [destruct (Qlt_le_dec 0 e); nra |]. intros some.
destruct (Q_dec e 0) as [[less | more] |]; [nra | nra | tauto]. Qed.

Lemma sums_of_gauges (a b c d : Q) : 0 <= a -> 0 <= b -> 0 <= c -> 0 <= d -> 0 < a + b -> 0 < c + d ->
  gauge_of (a + c) (b + d) <= gauge_of a b + gauge_of c d /\
  (~ a * d == b * c -> gauge_of (a + c) (b + d) < gauge_of a b + gauge_of c d).
Proof.
  intros A B C D first_ second_.
  assert (difference : gauge_of a b + gauge_of c d - gauge_of (a + c) (b + d) ==
    (a * d - b * c) * (a * d - b * c) / ((a + b) * (c + d) * (a + b + (c + d)))) by (unfold gauge_of; field; lra).
  assert (below : 0 < (a + b) * (c + d) * (a + b + (c + d))) by (repeat apply products; lra).
  destruct (squares (a * d - b * c)) as [not_negative positive_].
  destruct (quotients_by_sign ((a * d - b * c) * (a * d - b * c)) _ below) as [at_least more].
  split; [specialize (at_least not_negative); lra |]. intros differ.
  specialize (more (positive_ ltac:(lra))). lra.
Qed.

Lemma larger_gauge (a b a' : Q) : 0 <= a -> 0 <= b -> 0 < a + b -> a <= a' ->
  gauge_of a b <= gauge_of a' b /\ (a < a' -> gauge_of a b < gauge_of a' b).
Proof.
  intros A B some more.
  assert (difference : gauge_of a' b - gauge_of a b ==
    (a' - a) * (a * a' + a * b + a' * b) / ((a + b) * (a' + b))) by (unfold gauge_of; field; lra).
  assert (below : 0 < (a + b) * (a' + b)) by (apply products; lra).
  destruct (quotients_by_sign ((a' - a) * (a * a' + a * b + a' * b)) _ below) as [at_least larger].
  assert (0 <= a * a' + a * b + a' * b) by nra.
  split; [assert (0 <= (a' - a) * (a * a' + a * b + a' * b)) by (apply Qmult_le_0_compat; lra); lra |].
  intros strictly.
  assert (0 < a * a' + a * b + a' * b) by (destruct (Qlt_le_dec 0 a); nra).
  assert (0 < (a' - a) * (a * a' + a * b + a' * b)) by nra. lra.
Qed.

Lemma gauge_of_exchanged (a b : Q) : gauge_of a b == gauge_of b a.
Proof.
  unfold gauge_of. setoid_replace (a * a + a * b + b * b) with (b * b + b * a + a * a) by ring.
  setoid_replace (a + b) with (b + a) by ring. reflexivity.
Qed.

Lemma larger_gauges (a b a' b' : Q) : 0 <= a -> 0 <= b -> 0 < a + b -> a <= a' -> b <= b' ->
  gauge_of a b <= gauge_of a' b' /\ (a < a' \/ b < b' -> gauge_of a b < gauge_of a' b').
Proof.
  intros A B some A' B'. destruct (larger_gauge a b a' A B some A') as [first_ strictly].
  destruct (larger_gauge b a' b' B ltac:(lra) ltac:(lra) B') as [second_ strictly'].
  rewrite (gauge_of_exchanged b a'), (gauge_of_exchanged b' a') in *.
  split; [lra |]. intros [less | less]; [specialize (strictly less) | specialize (strictly' less)]; lra.
Qed.

Definition vector_sum (u v : vector) : vector := Vector (vx u + vx v) (vy u + vy v).
Definition stretched (k : Q) (u : vector) : vector := Vector (k * vx u) (k * vy u).

(* Lemma. The gauge of a sum is less than that of both together, if they are not parallel. *)
Lemma gauge_of_a_sum (u v : vector) : ~ cross u v == 0 -> gauge (vector_sum u v) < gauge u + gauge v.
Proof.
  intros turn.
  assert (some_u : nonzero u) by (intros [X Y]; apply turn; unfold cross; rewrite X, Y; ring).
  assert (some_v : nonzero v) by (intros [X Y]; apply turn; unfold cross; rewrite X, Y; ring).
  assert (some : nonzero (vector_sum u v)).
  { unfold nonzero, vector_sum. cbn [vx vy]. intros [X Y]. apply turn. unfold cross.
    setoid_replace (vx v) with (- vx u) by lra. setoid_replace (vy v) with (- vy u) by lra. ring. }
  apply abs_sum_is_positive in some_u, some_v, some. unfold gauge, vector_sum in *. cbn [vx vy] in *.
  unfold cross in turn. destruct u as [a b], v as [c d]. cbn [vx vy] in *.
  assert (triangle_ : forall s t, 0 <= Qabs s /\ Qabs (s + t) <= Qabs s + Qabs t /\
    (s * t < 0 -> Qabs (s + t) < Qabs s + Qabs t) /\ Qabs s * Qabs s == s * s).
  { intros s t. destruct (abs_cases s) as [[s_sign s_is] | [s_sign s_is]],
      (abs_cases t) as [[t_sign t_is] | [t_sign t_is]],
      (abs_cases (s + t)) as [[sum_sign sum_is] | [sum_sign sum_is]]; rewrite s_is, t_is, sum_is;
      (split; [lra |]; split; [lra |]; split; [intros product |]); try ring; try lra;
      (destruct (Qlt_le_dec 0 s), (Qlt_le_dec 0 t); lra || (exfalso; nra)). }
  destruct (triangle_ a c) as (A & AC & AC' & aa), (triangle_ b d) as (B & BD & BD' & bb),
    (triangle_ c 0) as (C & _ & _ & cc), (triangle_ d 0) as (D & _ & _ & dd).
  assert (at_sum : 0 <= Qabs (a + c) /\ 0 <= Qabs (b + d)) by (split; apply triangle_; exact 0).
  destruct (sums_of_gauges (Qabs a) (Qabs b) (Qabs c) (Qabs d) A B C D some_u some_v) as [at_most_ less].
  destruct (larger_gauges (Qabs (a + c)) (Qabs (b + d)) (Qabs a + Qabs c) (Qabs b + Qabs d))
    as [more strictly]; try tauto.
  destruct (Qeq_dec (Qabs a * Qabs d) (Qabs b * Qabs c)) as [equal | differ]; [| specialize (less differ); lra].
  assert (opposite_signs : a * c < 0 \/ b * d < 0).
  { assert (squares : (a * d) * (a * d) == (b * c) * (b * c)).
    { setoid_replace ((a * d) * (a * d)) with ((a * a) * (d * d)) by ring. rewrite <- aa, <- dd.
      setoid_replace (Qabs a * Qabs a * (Qabs d * Qabs d)) with ((Qabs a * Qabs d) * (Qabs a * Qabs d)) by ring.
      rewrite equal. setoid_replace ((b * c) * (b * c)) with ((b * b) * (c * c)) by ring. rewrite <- bb, <- cc. ring. }
    assert (negated : a * d + b * c == 0).
    { apply (Qmult_inj_l _ _ (a * d - b * c)); [lra |].
      setoid_replace ((a * d - b * c) * (a * d + b * c)) with ((a * d) * (a * d) - (b * c) * (b * c)) by ring. lra. }
    assert (product : (a * c) * (b * d) == - ((a * d) * (a * d))).
    { setoid_replace ((a * c) * (b * d)) with ((a * d) * (b * c)) by ring.
      setoid_replace (b * c) with (- (a * d)) by lra. ring. }
    assert (~ a * d == 0) by (intros zero_; apply turn; lra).
    assert (0 < (a * d) * (a * d)) by (destruct (Qlt_le_dec 0 (a * d)); nra).
    destruct (Qlt_le_dec (a * c) 0); [now left |]. destruct (Qlt_le_dec (b * d) 0); [now right |]. nra. }
  assert (gauge_of (Qabs (a + c)) (Qabs (b + d)) < gauge_of (Qabs a + Qabs c) (Qabs b + Qabs d)); [| lra].
  apply strictly. destruct opposite_signs; [left | right]; auto.
Qed.

Lemma gauge_of_stretched (k : Q) (u : vector) : 0 < k -> nonzero u -> gauge (stretched k u) == k * gauge u.
Proof.
  intros some nonzero_. apply abs_sum_is_positive in nonzero_. unfold gauge, stretched. cbn [vx vy].
  assert (abs_scaled : forall a, Qabs (k * a) == k * Qabs a).
  { intros a. destruct (abs_cases a) as [[sign ->] | [sign ->]], (abs_cases (k * a)) as [[sign' ->] | [sign' ->]];
      nra. }
  assert (respects : forall a b c d, a == c -> b == d -> gauge_of a b == gauge_of c d).
  { intros a b c d E F. unfold gauge_of. now rewrite E, F. }
  rewrite (respects _ _ _ _ (abs_scaled (vx u)) (abs_scaled (vy u))). unfold gauge_of. field. nra.
Qed.

Lemma gauge_is_positive (u : vector) : nonzero u -> 0 < gauge u.
Proof.
  intros some. apply abs_sum_is_positive in some. unfold gauge, gauge_of.
  pose proof (abs_bounds (vx u)). pose proof (abs_bounds (vy u)). apply Qlt_shift_div_l; [exact some |].
  destruct (Qlt_le_dec 0 (Qabs (vx u))); nra.
Qed.

Lemma gauge_respects (u v : vector) : equal_vectors u v -> gauge u == gauge v.
Proof.
  intros [X Y]. unfold gauge, gauge_of.
  assert (abs_same : forall a b, a == b -> Qabs a == Qabs b).
  { intros a b same_. destruct (abs_cases a) as [[s ->] | [s ->]], (abs_cases b) as [[t ->] | [t ->]]; lra. }
  now rewrite (abs_same _ _ X), (abs_same _ _ Y).
Qed.

(* Of two directions, whether they are one. *)
Definition same_ray (u v : vector) : Prop := cross u v == 0 /\ 0 < dot u v.

Definition is_on_curve (u : vector) : Prop := nonzero u /\ gauge u == 1.

(* The point of the curve in a direction. *)
Definition on_curve (u : vector) : vector := stretched (1 / gauge u) u.

Lemma on_curve_is_a_multiple (u : vector) : nonzero u ->
  exists k, 0 < k /\ on_curve u = stretched k u /\ is_on_curve (on_curve u).
Proof.
  intros some. pose proof (gauge_is_positive u some) as positive_. exists (1 / gauge u).
  assert (0 < 1 / gauge u) by (apply Qlt_shift_div_l; lra). split; [assumption |]. split; [reflexivity |].
  split; [intros [X Y]; apply some; unfold on_curve, stretched in X, Y; cbn [vx vy] in X, Y; split; nra |].
  unfold on_curve. rewrite gauge_of_stretched by assumption. field. lra.
Qed.

(* Strictly between a and b, on the side on which they are less than half a turn apart. *)
Definition inside_angle (a b r : vector) : Prop := 0 < cross a b * cross a r /\ 0 < cross a b * cross r b.

Lemma inside_angle_dec (a b r : vector) : {inside_angle a b r} + {~ inside_angle a b r}.
Proof.
  unfold inside_angle. destruct (Qlt_le_dec 0 (cross a b * cross a r)), (Qlt_le_dec 0 (cross a b * cross r b));
    [left; tauto | right; lra ..].
Qed.

Lemma gauge_of_mixed (a b r : vector) (s t : Q) : is_on_curve a -> is_on_curve b -> ~ cross a b == 0 -> 0 < s ->
  0 < t ->
  equal_vectors r (vector_sum (stretched s a) (stretched t b)) -> gauge r < s + t.
Proof.
  intros [some_a one_a] [some_b one_b] turn S T r_is. rewrite (gauge_respects _ _ r_is).
  pose proof (gauge_of_stretched s a S some_a) as at_a.
  pose proof (gauge_of_stretched t b T some_b) as at_b.
  assert (turned : ~ cross (stretched s a) (stretched t b) == 0).
  { intros zero_. apply turn. apply (Qmult_inj_l _ _ (s * t)); [nra |].
    unfold cross, stretched in *. cbn [vx vy] in *. lra. }
  pose proof (gauge_of_a_sum _ _ turned). rewrite at_a, at_b, one_a, one_b in *. lra.
Qed.

(* Lemma. The curve is on the other side of a chord than the origin inside the chord's angle, and on the same side
   outside of it. *)
Lemma side_of_a_chord (a b r : vector) : is_on_curve a -> is_on_curve b -> is_on_curve r -> ~ cross a b == 0 ->
  ~ same_ray r a -> ~ same_ray r b ->
  let side := cross (minus b a) (minus r a) in
  (inside_angle a b r -> cross a b * side < 0) /\ (~ inside_angle a b r -> 0 < cross a b * side).
Proof.
  intros one_a one_b one_r turn not_a not_b side.
  set (k := cross a b) in *. set (s := cross r b / k). set (t := cross a r / k).
  assert (s_is : s * k == cross r b) by (unfold s; field; exact turn).
  assert (t_is : t * k == cross a r) by (unfold t; field; exact turn).
  assert (r_is : equal_vectors r (vector_sum (stretched s a) (stretched t b))).
  { unfold equal_vectors, vector_sum, stretched. cbn [vx vy]. unfold k, cross in *.
    split; apply (Qmult_inj_l _ _ (vx a * vy b - vy a * vx b)); trivial; clearbody s t; by_equations. }
  assert (side_is : k * side == k * k * (1 - s - t)).
  { unfold side. assert (parts : cross (minus b a) (minus r a) == k - cross r b - cross a r)
      by (unfold k, cross, minus; cbn [vx vy]; ring). rewrite parts, <- s_is, <- t_is. ring. }
  clearbody s t. assert (square : 0 < k * k) by (destruct (Qlt_le_dec 0 k); [nra | assert (k < 0) by lra; nra]).
  assert (inside_is : inside_angle a b r <-> 0 < s /\ 0 < t).
  { unfold inside_angle. fold k. rewrite <- s_is, <- t_is. split; intros [A B].
    - split; [destruct (Qlt_le_dec 0 s) | destruct (Qlt_le_dec 0 t)]; trivial; exfalso; nra.
    - split; nra. }
  pose proof (proj1 one_a) as some_a. pose proof (proj1 one_b) as some_b. pose proof (proj2 one_r) as r_one.
  rewrite inside_is. split; [intros [S T] | intros outside_]; rewrite side_is.
  - pose proof (gauge_of_mixed a b r s t one_a one_b turn S T r_is). nra.
  - enough (s + t < 1) by nra. destruct (Qlt_le_dec (s + t) 1) as [less | more]; [exact less | exfalso].
    assert (ray : forall c l, nonzero c -> equal_vectors r (stretched l c) -> 0 < l -> same_ray r c).
    { intros c l some_c [X Y] L. unfold stretched in X, Y. cbn [vx vy] in X, Y. pose proof (square_positive c some_c).
      unfold same_ray, cross, dot in *. rewrite X, Y. split; [ring | nra]. }
    assert (other_way : forall u v l m, is_on_curve u -> is_on_curve v -> ~ cross u v == 0 ->
      equal_vectors r (vector_sum (stretched l u) (stretched m v)) -> 1 <= l + m -> l < 0 -> False).
    { intros u v l m one_u one_v turn' [X Y] enough_ L. unfold vector_sum, stretched in X, Y. cbn [vx vy] in X, Y.
      assert (M : 0 < m) by lra.
      assert (inverse : 1 / m * m == 1) by (field; lra). assert (0 < 1 / m) by (apply Qlt_shift_div_l; lra).
      set (i := 1 / m) in *. clearbody i.
      pose proof (proj2 one_v) as v_one.
      assert (v_less : gauge v < i + i * - l).
      { apply (gauge_of_mixed r u v i (i * - l)); trivial; [| nra |].
        - unfold cross. rewrite X, Y. intros zero_. apply turn'. unfold cross.
          apply (Qmult_inj_l _ _ (- m)); [lra |]. lra.
        - unfold equal_vectors, vector_sum, stretched. cbn [vx vy]. rewrite X, Y.
          split; [setoid_replace (vx v) with (i * m * vx v) at 1 by (rewrite inverse; ring)
            | setoid_replace (vy v) with (i * m * vy v) at 1 by (rewrite inverse; ring)]; ring. }
      nra. }
    destruct (Q_dec s 0) as [[less | s_positive] | s_zero].
    + exact (other_way a b s t one_a one_b turn r_is more less).
    + destruct (Q_dec t 0) as [[less | t_positive] | t_zero]; [| tauto |].
      * apply (other_way b a t s one_b one_a); trivial; [| | lra].
        -- intros zero_. apply turn. unfold k, cross in *. lra.
        -- destruct r_is as [X Y]. unfold equal_vectors, vector_sum, stretched in *. cbn [vx vy] in *. split; lra.
      * apply not_a, (ray a s some_a); [| exact s_positive]. destruct r_is as [X Y].
        unfold equal_vectors, vector_sum, stretched in *. cbn [vx vy] in *. rewrite t_zero in X, Y. split; lra.
    + apply not_b, (ray b t some_b); [| lra]. destruct r_is as [X Y].
      unfold equal_vectors, vector_sum, stretched in *. cbn [vx vy] in *. rewrite s_zero in X, Y. split; lra.
Qed.
