(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Close to a vertex that no other chain touches, its wedge (wedges.v) is inside the region, as what is close to the
   left of an edge is (left_of_an_edge.v): from there a short step leads to each direction of the wedge, and meets
   no edge. *)
From Coq Require Import QArith Qminmax Lqa ZArith Lia Bool List Arith.
From Oplus Require Import direction angle sweep winding_number tie_rule turning_number convolution_size fiber_grid
  states in_out_degree tangent_set regions weight meeting_of_segments interiors_meet neighbourhoods left_of_an_edge
  wedges.
Import ListNotations.

Open Scope Q_scope.

(* Only the edges of a vertex pass through it. So chains do not touch, and none comes to a point twice. *)
Definition vertices_are_apart (r : region) : Prop :=
  forall v c s, In (v, c) (region_vertices r) -> In s (region_edges r) -> lies_on v s ->
    (equal_vectors (target s) v /\ along s = incoming c) \/ (equal_vectors (source s) v /\ along s = outgoing c).

(* Near a point are only the edges through it. *)
Lemma only_edges_through_near (v : vector) (segments : list segment) :
  exists radius, 0 < radius /\ forall y s, within radius v y -> In s segments -> lies_on y s -> lies_on v s.
Proof.
  set (others := filter (fun s => if lies_on_dec v s then false else true) segments).
  assert (free : off v others).
  { intros s I. apply filter_In in I. destruct I as [_ I]. now destruct (lies_on_dec v s). }
  destruct (off_near v others free) as (radius & R & near). exists radius. split; [exact R |].
  intros y s close I on. destruct (lies_on_dec v s) as [through | beside]; [exact through | exfalso].
  apply (near y close s); [| exact on]. apply filter_In. split; [exact I |]. now destruct (lies_on_dec v s).
Qed.

(* The wedge by skew products: left of both edges, or at a reflex vertex left of one. *)
Lemma wedge_by_sides (u : vector) (c : corner) :
  nonzero u -> turns (incoming c) (outgoing c) -> in_wedge u c = true ->
  (0 < cross (outgoing c) u /\ 0 < cross (incoming c) u) \/
  (cross (incoming c) (outgoing c) < 0 /\ (0 < cross (outgoing c) u \/ 0 < cross (incoming c) u)).
Proof.
  destruct c as [a b]. cbn [incoming outgoing]. intros proper_u (proper_a & proper_b & turn) met.
  unfold in_wedge in met. cbn [incoming outgoing] in met.
  destruct (in_arc u b (opposite a) proper_u proper_b (opposite_nonzero a proper_a)) as [between_ |];
    [clear met | discriminate].
  pose proof (opposite_angle a proper_a) as half_turn. pose proof (angle_range a proper_a) as ra.
  pose proof (angle_range b proper_b) as rb. pose proof (angle_range u proper_u) as ru.
  pose proof (angle_range _ (opposite_nonzero a proper_a)) as ra'.
  pose proof (cross_angle a b proper_a proper_b) as a_b. pose proof (cross_angle a u proper_a proper_u) as a_u.
  pose proof (cross_angle b u proper_b proper_u) as b_u. unfold turns_by in *. unfold arc in between_.
  destruct (Qlt_le_dec (cross a b) 0) as [reflex | left_].
  - right. split; [exact reflex |]. destruct (Qlt_le_dec 0 (cross b u)); [now left | right]. lra.
  - left. split; lra.
Qed.

(* A combination of two directions, from v. *)
Definition combination (v g u : vector) (x y : Q) : vector :=
  Vector (vx v + x * vx g + y * vx u) (vy v + x * vy g + y * vy u).

Section OneVertex.
  Variable r : region.
  Variables v u g : vector.
  Variable c : corner.
  Variable base : segment.
  Hypothesis valid : nowhere_negative r.
  Hypothesis meet : edges_meet_in_vertices r.
  Hypothesis apart_ : vertices_are_apart r.
  Hypothesis here : In (v, c) (region_vertices r).
  Hypothesis base_here : In base (region_edges r).
  Hypothesis base_runs : forall e, 0 < e -> e < 1 -> lies_on (combination v g u e 0) base.
  Hypothesis left_of_base : 0 < cross (along base) u.
  (* Between g and u is no edge of the vertex. *)
  Hypothesis free_of_incoming : forall x y z, 0 <= x -> 0 < y -> 0 <= z ->
    ~ (x * vx g + y * vx u == - (z * vx (incoming c)) /\ x * vy g + y * vy u == - (z * vy (incoming c))).
  Hypothesis free_of_outgoing : forall x y z, 0 <= x -> 0 < y -> 0 <= z ->
    ~ (x * vx g + y * vx u == z * vx (outgoing c) /\ x * vy g + y * vy u == z * vy (outgoing c)).
  Hypothesis no_end : forall e, 0 < e -> e < 1 ->
    ~ (e * vx g == - vx (incoming c) /\ e * vy g == - vy (incoming c)).
  Hypothesis g_nonzero : nonzero g.

  Lemma through_the_vertex (s : segment) (x y : Q) :
    In s (region_edges r) -> lies_on v s -> lies_on (combination v g u x y) s ->
    (exists z, 0 <= z /\ x * vx g + y * vx u == - (z * vx (incoming c)) /\
       x * vy g + y * vy u == - (z * vy (incoming c))) \/
    (exists z, 0 <= z /\ x * vx g + y * vx u == z * vx (outgoing c) /\ x * vy g + y * vy u == z * vy (outgoing c)).
  Proof.
    intros I on (k & range & X & Y). unfold combination in X, Y. cbn [vx vy] in X, Y.
    destruct (apart_ v c s here I on) as [[[tx ty] is_in] | [[sx sy] is_out]].
    - left. exists (1 - k). rewrite <- is_in. unfold along, minus; cbn [vx vy]. repeat split; lra.
    - right. exists k. rewrite <- is_out. unfold along, minus; cbn [vx vy]. repeat split; lra.
  Qed.

  Lemma close_to_the_vertex : eventually (fun e => inside (moved_along v u e) r).
  Proof.
    destruct (only_edges_through_near v (region_edges r)) as (radius & R & near).
    refine (eventually_implied _ _ _ (eventually_and _ _ (ex_intro _ 1 (conj _ (fun e some small => conj some small)))
      (eventually_and _ _ (small_steps_stay_within ((1 # 2) * radius) v u _)
        (small_steps_stay_within ((1 # 2) * radius) v g _)))); [| lra ..].
    intros e ((some & small) & close_u & close_g).
    assert (close : forall x y, 0 <= x <= 1 -> 0 <= y <= 1 -> within radius v (combination v g u (e * x) (e * y))).
    { intros x y rx ry. unfold within, moved_along, combination in *. cbn [vx vy] in *. clear - close_u close_g rx ry.
      destruct close_u as [[u1 u2] [u3 u4]], close_g as [[g1 g2] [g3 g4]].
      set (p := e * vx u) in *. set (q := e * vy u) in *. set (s := e * vx g) in *. set (t := e * vy g) in *.
      setoid_replace (vx v + e * x * vx g + e * y * vx u - vx v) with (x * s + y * p) by (unfold s, p; ring).
      setoid_replace (vy v + e * x * vy g + e * y * vy u - vy v) with (x * t + y * q) by (unfold t, q; ring).
      assert (part : forall a k, - ((1 # 2) * radius) < a < (1 # 2) * radius -> 0 <= k <= 1 ->
        - ((1 # 2) * radius) < k * a < (1 # 2) * radius).
      { clear. intros a k [low high] [k0 k1]. split; nra. }
      pose proof (part p y) as py. pose proof (part q y) as qy. pose proof (part s x) as sx. pose proof (part t x) as tx.
      lra. }
    assert (free : forall x y, 0 <= x <= 1 -> 0 < y <= 1 -> off (combination v g u (e * x) (e * y)) (region_edges r)).
    { intros x y rx ry s I on.
      assert (through : lies_on v s) by (apply (near _ s (close x y rx ltac:(lra)) I on)).
      assert (0 <= e * x) by nra. assert (0 < e * y) by nra.
      destruct (through_the_vertex s (e * x) (e * y) I through on) as [(z & rz & equal) | (z & rz & equal)].
      - now apply (free_of_incoming (e * x) (e * y) z).
      - now apply (free_of_outgoing (e * x) (e * y) z). }
    set (w := combination v g u e 0).
    assert (w_close : within radius v w).
    { pose proof (close 1 0 ltac:(lra) ltac:(lra)) as c1. unfold within, w, combination in *. cbn [vx vy] in *. lra. }
    assert (no_vertex : ~ is_vertex w r).
    { intros (s & I & X & Y). unfold w, combination in X, Y. cbn [vx vy] in X, Y.
      assert (on : lies_on w s) by (exists 0; unfold w, combination; cbn [vx vy]; repeat split; lra).
      assert (through : lies_on v s) by exact (near w s w_close I on).
      destruct (apart_ v c s here I through) as [[[tx ty] is_in] | [[sx sy] is_out]].
      - apply (no_end e some small). rewrite <- is_in. unfold along, minus; cbn [vx vy]. split; lra.
      - apply g_nonzero. split; nra. }
    destruct (left_of_an_edge_is_inside r base w u valid meet base_here (base_runs e some small) no_vertex left_of_base)
      as (limit & L & inside_near).
    set (t := Qmin ((1 # 2) * limit) e).
    assert (t_range : 0 < t /\ t < limit /\ t <= e).
    { unfold t. pose proof (Q.le_min_l ((1 # 2) * limit) e). pose proof (Q.le_min_r ((1 # 2) * limit) e).
      repeat split; try lra. apply Q.min_glb_lt; lra. }
    destruct t_range as (t0 & t1 & t2). clearbody t.
    destruct (inside_near t t0 t1) as [_ positive_].
    assert (step : forall q, lies_on q (Segment (moved_along w u t) (moved_along v u e)) -> off q (region_edges r)).
    { intros q (k & [k0 k1] & X & Y). cbn [source target] in X, Y.
      assert (t_over : t / e * e == t) by (field; lra).
      assert (ratio : 0 < t / e <= 1) by (split; [apply Qlt_shift_div_l | apply Qle_shift_div_r]; lra).
      set (tau := t / e) in *. clearbody tau.
      apply (off_equal (combination v g u (e * (1 - k)) (e * ((1 - k) * tau + k)))).
      - unfold moved_along, w, combination in *. cbn [vx vy] in *. split; cbn [vx vy].
        + rewrite X, <- t_over. ring.
        + rewrite Y, <- t_over. ring.
      - apply free; [lra |]. split; nra. }
    split.
    - apply step, (target_lies_on (Segment (moved_along w u t) (moved_along v u e))).
    - pose proof (winding_number_along _ _ (region_cycles r) step) as same_number. cbn [source target] in same_number.
      now rewrite <- same_number.
  Qed.
End OneVertex.

(* Theorem. Close to a vertex that only its own edges pass, all directions of its wedge lead inside. *)
Theorem wedge_is_inside (r : region) (v u : vector) (c : corner) :
  nowhere_negative r -> edges_meet_in_vertices r -> vertices_are_apart r ->
  In (v, c) (region_vertices r) -> turns (incoming c) (outgoing c) -> nonzero u -> in_wedge u c = true ->
  eventually (fun e => inside (moved_along v u e) r).
Proof.
  intros valid meet apart_ here turning proper_u met.
  pose proof (wedge_by_sides u c proper_u turning met) as sides.
  destruct (edges_of_vertex v c r here) as [(s_in & I_in & target_is & is_in) (s_out & I_out & source_is & is_out)].
  destruct turning as (proper_a & proper_b & ahead).
  assert (cases : (0 < cross (outgoing c) u /\ (cross (incoming c) (outgoing c) < 0 \/ 0 < cross (incoming c) u)) \/
    (0 < cross (incoming c) u /\ cross (incoming c) (outgoing c) < 0)) by (clear - sides; tauto).
  clear sides. destruct c as [a b]. cbn [incoming outgoing] in *.
  destruct cases as [(left_of_b & beside_a) | (left_of_a & reflex)].
  - apply (close_to_the_vertex r v u b (Corner a b) s_out); trivial; cbn [incoming outgoing].
    + intros e e0 e1. exists e. rewrite <- is_out, <- source_is. unfold combination, along, minus. cbn [vx vy].
      repeat split; try lra; ring.
    + now rewrite is_out.
    + intros x y z x0 y0 z0 [X Y].
      assert (by_a : x * cross a b + y * cross a u == 0).
      { transitivity (vx a * (x * vy b + y * vy u) - vy a * (x * vx b + y * vx u)); [unfold cross; ring |].
        rewrite X, Y. ring. }
      assert (by_b : y * cross b u == z * cross a b).
      { transitivity (vx b * (x * vy b + y * vy u) - vy b * (x * vx b + y * vx u)); [unfold cross; ring |].
        rewrite X, Y. unfold cross. ring. }
      destruct (Qlt_le_dec (cross a b) 0) as [negative_ | not_negative].
      * assert (0 < y * cross b u) by (apply Qmult_lt_0_compat; assumption). nra.
      * destruct beside_a as [impossible | beside_a]; [lra |].
        assert (0 < y * cross a u) by (apply Qmult_lt_0_compat; assumption). nra.
    + intros x y z x0 y0 z0 [X Y].
      assert (by_b : y * cross b u == 0).
      { transitivity (vx b * (x * vy b + y * vy u) - vy b * (x * vx b + y * vx u)); [unfold cross; ring |].
        rewrite X, Y. unfold cross. ring. }
      assert (0 < y * cross b u) by (apply Qmult_lt_0_compat; assumption). lra.
    + intros e e0 e1 [X Y]. unfold cross, dot in ahead.
      assert (ax : vx a == - (e * vx b)) by lra. assert (ay : vy a == - (e * vy b)) by lra.
      rewrite ax, ay in ahead. assert (zero_ : - (e * vx b) * vy b - - (e * vy b) * vx b == 0) by ring.
      specialize (ahead zero_). pose proof (squares_are_not_negative (vx b) (vy b)).
      assert (0 <= e * (vx b * vx b + vy b * vy b)) by (apply Qmult_le_0_compat; lra). lra.
  - apply (close_to_the_vertex r v u (opposite a) (Corner a b) s_in); trivial; cbn [incoming outgoing].
    + intros e e0 e1. exists (1 - e). rewrite <- is_in, <- target_is. unfold combination, along, minus, opposite.
      cbn [vx vy]. repeat split; try lra; ring.
    + now rewrite is_in.
    + intros x y z x0 y0 z0 [X Y]. unfold opposite in X, Y. cbn [vx vy] in X, Y.
      assert (by_a : y * cross a u == 0).
      { transitivity (vx a * (x * - vy a + y * vy u) - vy a * (x * - vx a + y * vx u)); [unfold cross; ring |].
        rewrite X, Y. ring. }
      assert (0 < y * cross a u) by (apply Qmult_lt_0_compat; assumption). lra.
    + intros x y z x0 y0 z0 [X Y]. unfold opposite in X, Y. cbn [vx vy] in X, Y.
      assert (by_a : y * cross a u == z * cross a b).
      { transitivity (vx a * (x * - vy a + y * vy u) - vy a * (x * - vx a + y * vx u)); [unfold cross; ring |].
        rewrite X, Y. unfold cross. ring. }
      assert (0 < y * cross a u) by (apply Qmult_lt_0_compat; assumption). nra.
    + intros e e0 e1 [X Y]. unfold opposite in X, Y. cbn [vx vy] in X, Y. apply proper_a. split; nra.
    + now apply opposite_nonzero.
Qed.
