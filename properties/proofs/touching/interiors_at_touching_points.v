(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Where P and -Q + x touch without common inner points, x is on the convolution, even on the reduced one
   (Definition 2.3.1). Chains do not touch here: where a point at which chains of P touch meets such a point of Q, x
   need not be on the reduced convolution (docs/findings.md), but is on the convolution (fans_that_touch.v). Around the
   common point both are corners, or edges (boundary_points.v); touching_corners.v says which edge is in a tangent set,
   parallel_edges.v is about edges along each other. *)
From Coq Require Import ZArith Lia Bool List Arith.
From Oplus Require Import numbers regions_and_sums parallelogram observation_2_2_4 lemma_2_2_9 inside_a_corner
  tangent_direction touching_corners boundary_points reduced_convolution parallel_edges.
Import ListNotations.

Open Scope Q_scope.

(* Theorem. Where P and -Q + x touch in a point, the interiors meet, or x is on the reduced convolution. *)
Theorem segments_at_touching_points (p q : region) (x w u : vector) a i_in i_out eu ev b j_in j_out fu fv :
  valid_region p -> valid_region q -> chains_do_not_touch p -> chains_do_not_touch q ->
  boundary_point p w a i_in i_out eu ev -> boundary_point q u b j_in j_out fu fv -> equal_vectors x (plus w u) ->
  interiors_meet x p q \/ on_reduced_convolution x p q.
Proof.
  intros p_region q_region p_apart q_apart at_w at_u equal.
  pose proof p_region as (p_edges & p_valid & p_meet). pose proof q_region as (q_edges & q_valid & q_meet).
  pose proof (regions_are_regular p p_edges p_valid p_meet) as p_regular.
  pose proof (regions_are_regular q q_edges q_valid q_meet) as q_regular.
  assert (swapped : equal_vectors x (plus u w))
    by (destruct equal as [X Y]; unfold plus in *; cbn [vx vy] in *; split; cbn [vx vy]; lra).
  assert (outcome : forall d, reduced_along_or_meet p q x d -> interiors_meet x p q \/ on_reduced_convolution x p q).
  { intros d [(s & S & on & _) | meet_]; [right; now exists s | now left]. }
  destruct at_w as [a_in i_in_below i_out_below eu_is ev_is (lp & lp_range & w_in) (kp & kp_range & w_out)
    p_turns p_ahead p_tangent p_inside].
  destruct at_u as [b_in j_in_below j_out_below fu_is fv_is (lq & lq_range & u_in) (kq & kq_range & u_out)
    q_turns q_ahead q_tangent q_inside].
  pose proof p_turns as (proper_eu & proper_ev & _). pose proof q_turns as (proper_fu & proper_fv & _).
  destruct (Qeq_dec (angle ev) (angle fu)) as [along_ | apart_1].
  { apply (outcome ev). rewrite ev_is, fu_is in along_. rewrite ev_is.
    apply (parallel_edges_along p q a b p_region q_region p_apart q_apart a_in b_in x i_out j_in kp lq); trivial.
    rewrite <- ev_is, <- fu_is. destruct equal as [X Y], w_out as [wx wy], u_in as [ux uy].
    unfold plus in *; cbn [vx vy] in *. split; cbn [vx vy]; lra. }
  destruct (Qeq_dec (angle eu) (angle fv)) as [along_ | apart_2].
  { (* both a little back *)
    apply (outcome eu).
    assert (ratio : same_direction fv eu) by (apply same_direction_angle; trivial; now symmetry).
    destruct ratio as (r & some & r_x & r_y).
    set (step_ := Qmin lp ((1 - kq) * r)).
    assert (0 < (1 - kq) * r) by (apply Qmult_lt_0_compat; lra).
    assert (step_range : 0 < step_ /\ step_ <= lp /\ step_ <= (1 - kq) * r).
    { unfold step_. split; [apply Q.min_glb_lt; lra |]. split; [apply Q.le_min_l | apply Q.le_min_r]. }
    clearbody step_. assert (value : step_ / r * r == step_) by (field; lra).
    assert (quotient : 0 < step_ / r /\ step_ / r <= 1 - kq)
      by (split; [apply Qlt_shift_div_l; lra | apply Qle_shift_div_r; lra]).
    set (m := step_ / r) in *. clearbody m.
    rewrite eu_is, fv_is in along_. rewrite eu_is.
    apply (parallel_edges_along p q a b p_region q_region p_apart q_apart a_in b_in x i_in j_out (lp - step_) (kq + m));
      trivial; try lra.
    rewrite <- eu_is, <- fv_is. destruct equal as [X Y], w_in as [wx wy], u_out as [ux uy].
    unfold plus, moved_along in *; cbn [vx vy] in *. split; cbn [vx vy]; by_equations. }
  pose proof (direction_by_index a i_out i_out_below) as ev_along. fold (edge_at a i_out) in ev_along.
  pose proof (direction_by_index b j_out j_out_below) as fv_along. fold (edge_at b j_out) in fv_along.
  destruct (Qeq_dec (angle ev) (angle (opposite fv))) as [back | apart_3].
  { rewrite ev_is, ev_along in p_ahead. rewrite fv_is, fv_along in q_ahead. left.
    apply (opposite_edges_meet p q x w u (edge_at a i_out) (edge_at b j_out)); trivial;
      try now apply edge_at_in_region.
    rewrite <- ev_along, <- fv_along, <- ev_is, <- fv_is.
    apply same_direction_angle; [exact proper_ev | now apply opposite_nonzero | exact back]. }
  assert (part_on : forall chain k l v z, (k < length chain)%nat -> v = edge_of_chain chain k -> 0 <= l <= 1 ->
    equal_vectors z (moved_along (nth k chain nowhere) v l) -> lies_on z (edge_at chain k)).
  { intros chain k l v z below -> range [zx zy]. exists l. rewrite edge_at_is by exact below.
    rewrite edge_of_chain_is in zx, zy by exact below. unfold moved_along, minus in zx, zy.
    cbn [source target vx vy] in *. split; [exact range |]. rewrite zx, zy. split; ring. }
  assert (w_on_in : lies_on w (edge_at a i_in)) by (apply (part_on a i_in lp eu); trivial; lra).
  assert (w_on_out : lies_on w (edge_at a i_out)) by (apply (part_on a i_out kp ev); trivial; lra).
  assert (u_on_in : lies_on u (edge_at b j_in)) by (apply (part_on b j_in lq fu); trivial; lra).
  assert (u_on_out : lies_on u (edge_at b j_out)) by (apply (part_on b j_out kq fv); trivial; lra).
  assert (q_point : forall k, (k < length a)%nat -> equal_vectors w (nth k a nowhere) ->
    forall t, lies_on u t -> lies_on (minus x (nth k a nowhere)) t).
  { intros k _ [wx wy] t on. destruct equal as [X Y]. refine (lies_on_equal _ _ _ _ on).
    unfold plus, minus in *; cbn [vx vy] in *. split; cbn [vx vy]; lra. }
  assert (p_point : forall k, (k < length b)%nat -> equal_vectors u (nth k b nowhere) ->
    forall t, lies_on w t -> lies_on (minus x (nth k b nowhere)) t).
  { intros k _ [ux uy] t on. destruct equal as [X Y]. refine (lies_on_equal _ _ _ _ on).
    unfold plus, minus in *; cbn [vx vy] in *. split; cbn [vx vy]; lra. }
  destruct (touching_corners eu ev fu fv proper_eu proper_ev proper_fu proper_fv p_turns q_turns apart_1 apart_2
    apart_3)
    as [leads | [leads | [[is_convex [tangent | tangent]] | [is_convex [tangent | tangent]]]]].
  - destruct (some_small _ (eventually_and _ _ (p_inside _ leads) q_ahead)) as (t & _ & inside_p & on_q). left.
    refine (inner_point_and_point p q x _ _ q_regular inside_p _ _).
    + right. exists (edge_at b j_out). split; [now apply edge_at_in_region | exact on_q].
    + destruct equal as [X Y]. unfold plus, moved_along, opposite in *; cbn [vx vy] in *.
      split; cbn [vx vy]; [rewrite X | rewrite Y]; ring.
  - destruct (some_small _ (eventually_and _ _ (q_inside _ leads) p_ahead)) as (t & _ & inside_q & on_p). left.
    apply interiors_meet_other_way. refine (inner_point_and_point q p x _ _ p_regular inside_q _ _).
    + right. exists (edge_at a i_out). split; [now apply edge_at_in_region | exact on_p].
    + destruct swapped as [X Y]. unfold plus, moved_along, opposite in *; cbn [vx vy] in *.
      split; cbn [vx vy]; [rewrite X | rewrite Y]; ring.
  - apply (outcome fv). left. rewrite fv_is.
    destruct (p_tangent _ tangent) as (k & below & corner_ & at_vertex).
    apply (reduced_along_by_q p q a b a_in b_in x k j_out below j_out_below); [| | now apply q_point];
      rewrite corner_, <- ?fv_is; [exact tangent | exact is_convex].
  - apply (outcome fu). left. rewrite fu_is.
    destruct (p_tangent _ tangent) as (k & below & corner_ & at_vertex).
    apply (reduced_along_by_q p q a b a_in b_in x k j_in below j_in_below); [| | now apply q_point];
      rewrite corner_, <- ?fu_is; [exact tangent | exact is_convex].
  - apply (outcome eu). left. rewrite eu_is.
    destruct (q_tangent _ tangent) as (k & below & corner_ & at_vertex).
    apply (reduced_along_by_p p q a b a_in b_in x i_in k i_in_below below); [| | now apply p_point];
      rewrite corner_, <- ?eu_is; [exact tangent | exact is_convex].
  - apply (outcome ev). left. rewrite ev_is.
    destruct (q_tangent _ tangent) as (k & below & corner_ & at_vertex).
    apply (reduced_along_by_p p q a b a_in b_in x i_out k i_out_below below); [| | now apply p_point];
      rewrite corner_, <- ?ev_is; [exact tangent | exact is_convex].
Qed.

(* Theorem. Off the reduced convolution, where P and -Q + x have a point in common, their interiors meet. *)
Theorem common_point_means_common_inner_point (p q : region) (x : vector) :
  valid_region p -> valid_region q -> chains_do_not_touch p -> chains_do_not_touch q ->
  off x (reduced_convolution p q) -> in_sum x p q -> interiors_meet x p q.
Proof.
  intros p_region q_region p_apart q_apart free (w & u & in_p & in_q & equal).
  pose proof p_region as (p_edges & p_valid & p_meet). pose proof q_region as (q_edges & q_valid & q_meet).
  pose proof (regions_are_regular p p_edges p_valid p_meet) as p_regular.
  pose proof (regions_are_regular q q_edges q_valid q_meet) as q_regular.
  assert (swapped : equal_vectors x (plus u w))
    by (destruct equal as [X Y]; unfold plus in *; cbn [vx vy] in *; split; cbn [vx vy]; lra).
  destruct (on_or_off w (region_edges p)) as [(e & E & on_e) | off_p].
  2: { apply (inner_point_and_point p q x w u q_regular); trivial. split; [exact off_p |].
       destruct in_p as [positive_ | (s & S & on)]; [exact positive_ | exfalso; exact (off_p s S on)]. }
  destruct (on_or_off u (region_edges q)) as [(f & F & on_f) | off_q].
  2: { apply interiors_meet_other_way. apply (inner_point_and_point q p x u w p_regular); trivial.
       split; [exact off_q |].
       destruct in_q as [positive_ | (s & S & on)]; [exact positive_ | exfalso; exact (off_q s S on)]. }
  destruct (boundary_points p w e p_region p_apart E on_e) as (a & i_in & i_out & eu & ev & at_w).
  destruct (boundary_points q u f q_region q_apart F on_f) as (b & j_in & j_out & fu & fv & at_u).
  destruct (segments_at_touching_points p q x w u a i_in i_out eu ev b j_in j_out fu fv) as
    [meet_ | (s & S & on)]; trivial.
  exfalso. exact (free s S on).
Qed.
