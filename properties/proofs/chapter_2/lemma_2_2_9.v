(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Lemma 2.2.9, the sliding lemma: an edge of P, moved along a segment inside Q that leads to the edge's right, covers
   what is near. So if an edge of Q at its vertex q leads to the right of an edge e of P, the points of e + q are
   inner points of the sum, but for those that come from vertices of P. Those are excluded, touching ones too:
   there the lemma is false (docs/findings.md). To the left of the edge is observation_2_2_4.v. *)
From Coq Require Import ZArith Lia Bool List.
From Oplus Require Import numbers regions_and_sums theorem_2_2_10 observation_2_2_4.
Import ListNotations.

Open Scope Q_scope.

(* Q has a short segment from u in the direction n. *)
Definition has_segment (r : region) (u n : vector) : Prop :=
  exists length, 0 < length /\ forall t, 0 <= t -> t < length -> in_region (moved_along u n t) r.

Lemma in_region_equal (a b : vector) (r : region) : equal_vectors a b -> in_region a r -> in_region b r.
Proof.
  intros [X Y] [positive_ | (s & I & (k & range & on_x & on_y))].
  - left. now rewrite <- (winding_number_of_equal a b _ X Y).
  - right. exists s. split; [exact I |]. exists k. rewrite X, Y in *. now split.
Qed.

(* Theorem. What an edge covers that slides to its right. *)
Theorem sliding (p q : region) (e : segment) (w u n : vector) :
  valid_region p -> In e (region_edges p) -> lies_on w e -> ~ is_vertex w p ->
  has_segment q u n -> cross (along e) n < 0 -> inner_point_of_sum (plus w u) p q.
Proof.
  intros p_region I on no_vertex (len & some_length & slide) right_.
  assert (u_in_q : in_region u q).
  { apply (in_region_equal (moved_along u n 0)); [split; unfold moved_along; cbn [vx vy]; ring |].
    apply slide; lra. }
  destruct (half_square_of_the_sum p q e w u p_region I on no_vertex u_in_q) as (r1 & R1 & left_half).
  destruct (half_square_beside_an_edge p e w p_region I on no_vertex) as (r2 & R2 & near_e).
  set (E := along e) in *. set (turn := - cross E n) in *. assert (0 < turn) as some_turn by (unfold turn; lra).
  set (slope := Qabs (vx E) + Qabs (vy E)).
  assert (slope_range : 0 <= slope)
    by (unfold slope; pose proof (abs_bounds (vx E)); pose proof (abs_bounds (vy E)); lra).
  set (size := Qabs (vx n) + Qabs (vy n)).
  assert (size_range : 0 <= size)
    by (unfold size; pose proof (abs_bounds (vx n)); pose proof (abs_bounds (vy n)); lra).
  destruct (radius_for (turn * len) slope) as (r3 & R3 & short); [now apply Qmult_lt_0_compat | exact slope_range |].
  destruct (radius_for (turn * ((1 # 2) * r2)) (slope * size)) as (r4 & R4 & close_);
    [apply Qmult_lt_0_compat; lra | now apply Qmult_le_0_compat |].
  set (radius := Qmin (Qmin r1 ((1 # 2) * r2)) (Qmin r3 r4)).
  assert (bounds : 0 < radius /\ radius <= r1 /\ radius <= (1 # 2) * r2 /\ radius <= r3 /\ radius <= r4).
  { unfold radius. pose proof (Q.le_min_l (Qmin r1 ((1 # 2) * r2)) (Qmin r3 r4)).
    pose proof (Q.le_min_r (Qmin r1 ((1 # 2) * r2)) (Qmin r3 r4)).
    pose proof (Q.le_min_l r1 ((1 # 2) * r2)). pose proof (Q.le_min_r r1 ((1 # 2) * r2)).
    pose proof (Q.le_min_l r3 r4). pose proof (Q.le_min_r r3 r4).
    split; [repeat apply Q.min_glb_lt; lra |]. lra. }
  clearbody radius. destruct bounds as (R & B1 & B2 & B3 & B4).
  exists radius. split; [exact R |]. intros y close.
  set (h := minus y (plus w u)).
  destruct (Qlt_le_dec (cross E h) 0) as [to_the_right | to_the_left];
    [| apply left_half; [now apply (within_smaller radius) | exact to_the_left]].
  (* The edge reaches y when it has slid t. *)
  assert (h_bounds : - radius < vx h < radius /\ - radius < vy h < radius) by exact close.
  destruct h_bounds as [hx hy].
  set (t := - cross E h / turn).
  assert (t_value : t * turn == - cross E h) by (unfold t; field; lra).
  assert (t_positive : 0 <= t) by (unfold t; apply Qle_shift_div_l; lra).
  assert (small_turn : - cross E h <= radius * slope).
  { unfold cross, slope. pose proof (product_bounds _ (vy E) _ hx). pose proof (product_bounds _ (vx E) _ hy). lra. }
  assert (t_short : t < len).
  { unfold t. apply Qlt_shift_div_r; [exact some_turn |].
    assert (radius * slope <= r3 * slope) by (apply Qmult_le_compat_r; lra). lra. }
  assert (t_close : t * size < (1 # 2) * r2).
  { assert (t * size * turn < (1 # 2) * r2 * turn); [| now apply (Qmult_lt_r _ _ turn)].
    setoid_replace (t * size * turn) with (t * turn * size) by ring. rewrite t_value.
    assert (- cross E h * size <= radius * slope * size) by (apply Qmult_le_compat_r; lra).
    assert (radius * (slope * size) <= r4 * (slope * size))
      by (apply Qmult_le_compat_r; [lra | now apply Qmult_le_0_compat]).
    lra. }
  clearbody t.
  set (z := Vector (vx w + (vx h - t * vx n)) (vy w + (vy h - t * vy n))).
  assert (z_near : within r2 w z).
  { assert (step_bound : forall a, Qabs a <= size -> - ((1 # 2) * r2) < t * a < (1 # 2) * r2).
    { intros a small. pose proof (abs_bounds a) as [_ range].
      assert (t * Qabs a <= t * size)
        by (rewrite (Qmult_comm t (Qabs a)), (Qmult_comm t size); apply Qmult_le_compat_r; lra).
      assert (0 <= t * (Qabs a - a)) by (apply Qmult_le_0_compat; lra).
      assert (0 <= t * (Qabs a + a)) by (apply Qmult_le_0_compat; lra). lra. }
    pose proof (abs_bounds (vx n)). pose proof (abs_bounds (vy n)).
    pose proof (step_bound (vx n)) as step_x. pose proof (step_bound (vy n)) as step_y. unfold size in step_x, step_y.
    assert (- ((1 # 2) * r2) < t * vx n < (1 # 2) * r2) by (apply step_x; lra).
    assert (- ((1 # 2) * r2) < t * vy n < (1 # 2) * r2) by (apply step_y; lra).
    unfold within, z; cbn [vx vy]. lra. }
  destruct (near_e z z_near) as [_ on_the_edge].
  apply (in_sum_of y z (moved_along u n t)).
  - right. exists e. split; [exact I |]. apply on_the_edge.
    setoid_replace (area e z) with (area e w + cross E h + t * turn) by (unfold turn, E, z; by_coordinates).
    rewrite (on_the_line w e on), t_value. ring.
  - now apply slide.
  - unfold z, h. split; unfold plus, minus, moved_along; cbn [vx vy]; ring.
Qed.

(* An edge of Q, from its source and backwards from its target. *)
Lemma segment_from_source (r : region) (f : segment) : In f (region_edges r) ->
  has_segment r (source f) (along f).
Proof.
  intros I. exists 1. split; [lra |]. intros t t0 t1. right. exists f. split; [exact I |].
  exists t. unfold moved_along, along, minus; cbn [vx vy]. split; [lra |]. split; ring.
Qed.

Lemma segment_from_target (r : region) (f : segment) : In f (region_edges r) ->
  has_segment r (target f) (opposite (along f)).
Proof.
  intros I. exists 1. split; [lra |]. intros t t0 t1. right. exists f. split; [exact I |].
  exists (1 - t). unfold moved_along, opposite, along, minus; cbn [vx vy]. split; [lra |]. split; ring.
Qed.

(* Theorem, Lemma 2.2.9. f is the edge of Q that leaves its vertex q, and leads to the right of the edge e of P; or f
   is the edge that enters q, and f reversed leads to the right of e. Then each point of e, unless it is a
   vertex of P, plus q is an inner point of the sum. *)
Theorem sliding_lemma (p q : region) (e f : segment) (w : vector) :
  valid_region p -> In e (region_edges p) -> lies_on w e -> ~ is_vertex w p -> In f (region_edges q) ->
  (cross (along e) (along f) < 0 -> inner_point_of_sum (plus w (source f)) p q) /\
  (cross (along e) (opposite (along f)) < 0 -> inner_point_of_sum (plus w (target f)) p q).
Proof.
  intros p_region I on no_vertex J. split; intros right_.
  - apply (sliding p q e w (source f) (along f)); trivial. now apply segment_from_source.
  - apply (sliding p q e w (target f) (opposite (along f))); trivial. now apply segment_from_target.
Qed.
