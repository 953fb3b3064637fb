(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Theorem 4.2.1 for interiors, at every x off the convolution: where P and -Q + x touch without common inner points, x is
   on the convolution. Chains do not touch here: where a point at which chains of P touch meets such a point of
   Q, it is false (docs/findings.md). Around the common point both are corners, or edges; touching_corners.v says
   which edge is in a tangent set, parallel_edges.v is about edges along each other. In general position it is
   in theorem_4_2_1.v. *)
From Coq Require Import QArith Qminmax Lqa Qfield ZArith Lia Bool List Arith.
From Oplus Require Import direction angle cyclic_order tangent_set sweep winding_number signed_crossings tie_rule
  turning_number convolution_size fiber_grid forward_traversal states in_out_degree convolution_winding regions
  weight parallelogram winding_number_of_the_sum meeting_of_segments interiors_meet neighbourhoods
  left_of_an_edge theorem_4_2_1 observation_2_2_4 lemma_2_2_9 inside_a_corner touching_corners parallel_edges.
Import ListNotations.

Open Scope Q_scope.

(* At each vertex only the two edges of its chain meet. *)
Definition chains_do_not_touch (r : region) : Prop :=
  forall chain i, In chain r -> (i < length chain)%nat ->
    meet_in_vertex (edge_at chain (previous (length chain) i)) (edge_at chain i) r.

Lemma lies_on_equal (a b : vector) (s : segment) : equal_vectors a b -> lies_on a s -> lies_on b s.
Proof. intros [X Y] (t & range & on_x & on_y). exists t. rewrite <- X, <- Y. tauto. Qed.

Lemma vertex_or_not (w : vector) (r : region) : is_vertex w r \/ ~ is_vertex w r.
Proof.
  unfold is_vertex. induction (region_edges r) as [| s rest IH]; [right; intros (u & [] & _) |].
  destruct (Qeq_dec (vx w) (vx (source s))) as [X | X], (Qeq_dec (vy w) (vy (source s))) as [Y | Y];
    [left; exists s; split; [now left | now split] | ..];
    (destruct IH as [(u & I & equal) | none];
     [left; exists u; split; [now right | exact equal] |
      right; intros (u & [<- | I] & [ux uy]); [tauto | apply none; exists u; split; [exact I | now split]]]).
Qed.

(* An edge by its chain and index. *)
Lemma edge_by_chain (r : region) (s : segment) : In s (region_edges r) ->
  exists chain i, In chain r /\ (i < length chain)%nat /\ s = edge_at chain i.
Proof.
  intros I. apply in_flat_map in I. destruct I as (chain & J & I).
  apply (In_nth (edges chain) s no_segment) in I. destruct I as (i & below & is_s).
  rewrite edges_are_as_many in below. exists chain, i. split; [exact J |]. split; [exact below | now symmetry].
Qed.

Lemma edge_at_in_region (r : region) (chain : list vector) i :
  In chain r -> (i < length chain)%nat -> In (edge_at chain i) (region_edges r).
Proof.
  intros J I. apply in_flat_map. exists chain. split; [exact J |]. apply nth_In. now rewrite edges_are_as_many.
Qed.

(* Edges that meet in a vertex do not lie along each other. *)
Lemma vertex_turns (r : region) (f_in f_out : segment) :
  valid_region r -> meet_in_vertex f_in f_out r -> turns (along f_in) (along f_out).
Proof.
  intros (not_points & valid & meet) (I & J & [tx ty] & _).
  pose proof (region_edges_are_directions r not_points f_in I) as long_in.
  pose proof (region_edges_are_directions r not_points f_out J) as long_out.
  split; [exact long_in |]. split; [exact long_out |]. intros parallel.
  destruct (Qlt_le_dec 0 (dot (along f_in) (along f_out))) as [| back]; [assumption | exfalso].
  set (u := along f_in) in *. set (v := along f_out) in *.
  assert (square : 0 < vx u * vx u + vy u * vy u).
  { destruct (Qlt_le_dec 0 (vx u * vx u + vy u * vy u)) as [| none]; [assumption |]. exfalso. apply long_in.
    now apply no_squares. }
  set (m := - dot u v / (vx u * vx u + vy u * vy u)).
  assert (m_value : m * (vx u * vx u + vy u * vy u) == - dot u v) by (unfold m; field; lra).
  assert (v_x : vx v == - m * vx u).
  { apply (Qmult_inj_r _ _ (vx u * vx u + vy u * vy u)); [lra |].
    setoid_replace (- m * vx u * (vx u * vx u + vy u * vy u)) with
      (- (m * (vx u * vx u + vy u * vy u)) * vx u) by ring.
    rewrite m_value. setoid_replace (vx v * (vx u * vx u + vy u * vy u)) with
      (dot u v * vx u - cross u v * vy u) by (unfold dot, cross; ring).
    rewrite parallel. ring. }
  assert (v_y : vy v == - m * vy u).
  { apply (Qmult_inj_r _ _ (vx u * vx u + vy u * vy u)); [lra |].
    setoid_replace (- m * vy u * (vx u * vx u + vy u * vy u)) with
      (- (m * (vx u * vx u + vy u * vy u)) * vy u) by ring.
    rewrite m_value. setoid_replace (vy v * (vx u * vx u + vy u * vy u)) with
      (dot u v * vy u + cross u v * vx u) by (unfold dot, cross; ring).
    rewrite parallel. ring. }
  assert (m_range : 0 <= m) by (unfold m; apply Qle_shift_div_l; lra).
  clearbody m.
  (* points of both edges near the vertex *)
  assert (small : eventually (fun t => 0 < t /\ t <= 1 /\ t * m <= 1)).
  { exists (1 / (1 + m)). split; [apply Qlt_shift_div_l; lra |]. intros t some below.
    assert (value : 1 / (1 + m) * (1 + m) == 1) by (field; lra).
    assert (t * (1 + m) < 1 / (1 + m) * (1 + m)) by (apply Qmult_lt_r; lra).
    assert (0 <= t * m) by (apply Qmult_le_0_compat; lra). lra. }
  destruct (eventually_and _ _ small
    (eventually_for_all (fun s t => ~ equal_vectors (moved_along (source f_out) v t) (source s)) (region_edges r)
      (fun s _ => leaves_a_point (source f_out) v (source s) long_out))) as (limit & L & near).
  destruct (near ((1 # 2) * limit)) as ((t0 & t1 & tm) & free); [lra | lra |].
  set (t := (1 # 2) * limit) in *. clearbody t.
  assert (vertex : is_vertex (moved_along (source f_out) v t) r).
  { destruct (in_split _ _ J) as (earlier & later & edges_are).
    apply (meet earlier f_out later f_in _ edges_are).
    - rewrite edges_are in I. apply in_app_iff in I. apply in_app_iff.
      destruct I as [I | [same_ | I]]; [now left | exfalso | now right].
      assert (v = u) as v_is by (unfold u, v; now rewrite same_). rewrite v_is in v_x, v_y.
      apply long_in. split; nra.
    - exists t. unfold moved_along, v, along, minus; cbn [vx vy]. split; [lra |]. split; ring.
    - exists (1 - t * m). split.
      + assert (0 <= t * m) by (apply Qmult_le_0_compat; lra). lra.
      + unfold moved_along; cbn [vx vy]. rewrite v_x, v_y, <- tx, <- ty.
        unfold u, along, minus; cbn [vx vy]. split; ring. }
  destruct vertex as (s & S & equal). exact (free s S equal).
Qed.

(* The boundary of a region at one of its points: an edge of a chain comes in direction u and one leaves in
   direction v; at a point inside an edge both are that edge. *)
Record boundary_point (r : region) (w : vector) (chain : list vector) (i_in i_out : nat) (u v : vector) : Prop :=
  Boundary {
    chain_in : In chain r;
    in_below : (i_in < length chain)%nat;
    out_below : (i_out < length chain)%nat;
    u_is : u = edge_of_chain chain i_in;
    v_is : v = edge_of_chain chain i_out;
    on_in : lies_on w (edge_at chain i_in);
    on_out : lies_on w (edge_at chain i_out);
    corner_turns : turns u v;
    ahead : eventually (fun t => lies_on (moved_along w v t) (edge_at chain i_out));
    tangent_vertex : forall d, in_tangent_set d (Corner u v) = true ->
      exists k, (k < length chain)%nat /\ corner_of_chain chain k = Corner u v /\
        equal_vectors w (nth k chain nowhere);
    corner_inside : forall n, leads_inside u v n -> eventually (fun t => inside (moved_along w n t) r) }.

Lemma boundary_points (r : region) (w : vector) (s : segment) :
  valid_region r -> chains_do_not_touch r -> In s (region_edges r) -> lies_on w s ->
  exists chain i_in i_out u v, boundary_point r w chain i_in i_out u v.
Proof.
  intros r_valid apart_ I on. pose proof r_valid as (not_points & valid & meet).
  destruct (vertex_or_not w r) as [(f & J & vertex) | no_vertex].
  - destruct (edge_by_chain r f J) as (chain & i & in_r & below & ->).
    pose proof (apart_ chain i in_r below) as corner_. pose proof (previous_below _ _ below) as before_.
    pose proof (vertex_turns r _ _ r_valid corner_) as turn.
    pose proof (direction_by_index chain i below) as out_is.
    pose proof (direction_by_index chain _ before_) as in_is.
    fold (edge_at chain i) in out_is. fold (edge_at chain (previous (length chain) i)) in in_is.
    rewrite <- out_is, <- in_is in turn.
    exists chain, (previous (length chain) i), i, (edge_of_chain chain (previous (length chain) i)), (edge_of_chain chain i).
    split; trivial.
    + destruct corner_ as (_ & _ & [tx ty] & _). destruct vertex as [X Y].
      exists 1. rewrite X, Y, <- tx, <- ty. split; [lra |]. split; ring.
    + destruct vertex as [X Y]. exists 0. rewrite X, Y. split; [lra |]. split; ring.
    + exists 1. split; [lra |]. intros t t0 t1. destruct vertex as [X Y]. exists t.
      unfold moved_along; cbn [vx vy]. rewrite out_is, X, Y. unfold along, minus; cbn [vx vy].
      split; [lra |]. split; ring.
    + intros d _. exists i. split; [exact below |]. split; [now apply corner_is |].
      rewrite edge_at_is in vertex by exact below. exact vertex.
    + intros n leads. rewrite in_is, out_is in leads.
      refine (eventually_implied _ _ _ (inside_a_corner r _ _ n r_valid corner_ leads)).
      intros t. apply inside_equal. destruct vertex as [X Y]. unfold moved_along.
      split; cbn [vx vy]; [rewrite X | rewrite Y]; reflexivity.
  - destruct (edge_by_chain r s I) as (chain & i & in_r & below & ->).
    pose proof (direction_by_index chain i below) as is_along. fold (edge_at chain i) in is_along.
    assert (long : nonzero (edge_of_chain chain i))
      by (rewrite is_along; now apply (region_edges_are_directions r)).
    exists chain, i, i, (edge_of_chain chain i), (edge_of_chain chain i). split; trivial.
    + split; [exact long |]. split; [exact long |]. intros _. unfold dot.
      destruct (Qlt_le_dec 0 (vx (edge_of_chain chain i) * vx (edge_of_chain chain i) +
        vy (edge_of_chain chain i) * vy (edge_of_chain chain i))) as [| none]; [assumption |].
      exfalso. apply long. now apply no_squares.
    + destruct on as (k & [k0 k1] & X & Y).
      assert (before_end : k < 1).
      { apply Qnot_le_lt. intros extreme. apply no_vertex.
        destruct (target_is_vertex r _ I) as (u & J & tx & ty). exists u. split; [exact J |].
        assert (k == 1) as k_is by lra. rewrite k_is in X, Y. split; lra. }
      exists (1 - k). split; [lra |]. intros t t0 t1. exists (k + t). unfold moved_along; cbn [vx vy].
      rewrite is_along. unfold along, minus; cbn [vx vy]. split; [lra |]. rewrite X, Y. split; ring.
    + intros d tangent. exfalso. unfold in_tangent_set in tangent. cbn [incoming outgoing] in tangent.
      unfold ccw in tangent.
      destruct (compare (Direction (edge_of_chain chain i) (other (of d)))
                  (Direction (edge_of_chain chain i) (other (of d)))) eqn:itself; [discriminate tangent | |];
        pose proof (compare_spec (Direction (edge_of_chain chain i) (other (of d)))
          (Direction (edge_of_chain chain i) (other (of d))) long long) as spec; rewrite itself in spec;
        inversion spec as [| strict | strict]; unfold earlier in strict; lra.
    + intros n leads. apply (left_of_an_edge_is_inside r (edge_at chain i) w n valid meet I on no_vertex).
      rewrite <- is_along. assert (itself : cross (edge_of_chain chain i) (edge_of_chain chain i) == 0)
        by (unfold cross; ring).
      unfold leads_inside in leads. rewrite itself in leads. lra.
Qed.

(* An inner point of P and a point of Q have inner points of both near them. *)
Lemma inner_point_and_point (p q : region) (x a b : vector) :
  is_regular q -> inside a p -> in_region b q -> equal_vectors x (plus a b) -> interiors_meet x p q.
Proof.
  intros regular [free positive_] in_q [X Y].
  destruct (winding_number_near a _ (region_cycles p) free) as (radius & R & near).
  destruct (inside_near q b radius regular in_q R) as (b' & close & inside_q).
  exists (minus x b'). unfold plus in X, Y; cbn [vx vy] in X, Y. split.
  - destruct (near (minus x b')) as [free_a same_number].
    + unfold within, minus in *; cbn [vx vy]. lra.
    + split; [exact free_a | lia].
  - refine (inside_equal _ _ _ _ inside_q). unfold minus. split; cbn [vx vy]; ring.
Qed.

Lemma interiors_meet_other_way (p q : region) (x : vector) : interiors_meet x p q -> interiors_meet x q p.
Proof.
  intros (z & in_p & in_q). exists (minus x z). split; [exact in_q |].
  refine (inside_equal _ _ _ _ in_p). unfold minus. split; cbn [vx vy]; ring.
Qed.

(* Edges that leave a common point in opposite directions. *)
Lemma opposite_edges_meet (p q : region) (x w u : vector) (e f : segment) :
  valid_region p -> valid_region q -> In e (region_edges p) -> In f (region_edges q) ->
  equal_vectors x (plus w u) -> same_direction (along e) (opposite (along f)) ->
  eventually (fun t => lies_on (moved_along w (along e) t) e) ->
  eventually (fun t => lies_on (moved_along u (along f) t) f) -> interiors_meet x p q.
Proof.
  intros p_region q_region I J [X Y] (m & some & m_x & m_y) on_e (limit_f & L_f & on_f).
  pose proof p_region as (p_edges & p_valid & p_meet). pose proof q_region as (q_edges & q_valid & q_meet).
  pose proof (region_edges_are_directions p p_edges e I) as long_e.
  pose proof (region_edges_are_directions q q_edges f J) as long_f.
  set (E := along e) in *. set (F := along f) in *.
  unfold opposite in m_x, m_y; cbn [vx vy] in m_x, m_y.
  assert (scaled : forall holds, eventually holds -> eventually (fun t => holds (t * m))).
  { intros holds (limit & L & near). exists (limit / m). split; [apply Qlt_shift_div_l; lra |].
    intros t t0 t1. apply near; [now apply Qmult_lt_0_compat |].
    assert (value : limit / m * m == limit) by (field; lra).
    assert (t * m < limit / m * m) by (now apply Qmult_lt_r). lra. }
  destruct (eventually_and _ _
    (eventually_and _ _ on_e (scaled _ (ex_intro _ limit_f (conj L_f on_f))))
    (eventually_and _ _
      (eventually_for_all (fun s t => ~ equal_vectors (moved_along w E t) (source s)) (region_edges p)
        (fun s _ => leaves_a_point w E (source s) long_e))
      (scaled _ (eventually_for_all (fun s t => ~ equal_vectors (moved_along u F t) (source s)) (region_edges q)
        (fun s _ => leaves_a_point u F (source s) long_f))))) as (limit & L & near).
  destruct (near ((1 # 2) * limit)) as ((on_e' & on_f') & (free_p & free_q)); [lra | lra |].
  set (t := (1 # 2) * limit) in *. clearbody t. clear near.
  set (w' := moved_along w E t) in *. set (u' := moved_along u F (t * m)) in *.
  set (n := Vector (- vy E) (vx E)).
  pose proof (left_normal e long_e) as left_e. fold E in left_e. fold n in left_e.
  assert (left_f : 0 < cross F (opposite n)).
  { assert (value : m * cross F (opposite n) == cross E n)
      by (unfold cross, opposite; cbn [vx vy]; rewrite m_x, m_y; ring).
    destruct (Qlt_le_dec 0 (cross F (opposite n))) as [| none]; [assumption | exfalso].
    assert (0 <= m * - cross F (opposite n)) by (apply Qmult_le_0_compat; lra). lra. }
  assert (w_free : ~ is_vertex w' p) by (intros (s & S & equal); exact (free_p s S equal)).
  assert (u_free : ~ is_vertex u' q) by (intros (s & S & equal); exact (free_q s S equal)).
  destruct (eventually_and _ _
    (left_of_an_edge_is_inside p e w' n p_valid p_meet I on_e' w_free left_e)
    (left_of_an_edge_is_inside q f u' (opposite n) q_valid q_meet J on_f' u_free left_f)) as (len & positive_ & both).
  destruct (both ((1 # 2) * len)) as [in_p in_q]; [lra | lra |].
  exists (moved_along w' n ((1 # 2) * len)). split; [exact in_p |]. refine (inside_equal _ _ _ _ in_q).
  unfold plus in X, Y; cbn [vx vy] in X, Y. unfold minus, u', w', moved_along, opposite.
  split; cbn [vx vy]; [rewrite X, m_x | rewrite Y, m_y]; ring.
Qed.

(* Theorem. Off the convolution, where P and -Q + x have a point in common, their interiors meet. *)
Theorem common_point_means_common_inner_point (p q : region) (x : vector) :
  valid_region p -> valid_region q -> chains_do_not_touch p -> chains_do_not_touch q ->
  off x (convolution_segments p q) -> in_sum x p q -> interiors_meet x p q.
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
  assert (contradiction_ : on_convolution x p q -> interiors_meet x p q)
    by (intros (s & S & on); exfalso; exact (free s S on)).
  destruct (boundary_points p w e p_region p_apart E on_e) as (a & i_in & i_out & eu & ev & at_w).
  destruct (boundary_points q u f q_region q_apart F on_f) as (b & j_in & j_out & fu & fv & at_u).
  destruct at_w as [a_in i_in_below i_out_below eu_is ev_is w_on_in w_on_out p_turns p_ahead p_tangent p_inside].
  destruct at_u as [b_in j_in_below j_out_below fu_is fv_is u_on_in u_on_out q_turns q_ahead q_tangent q_inside].
  pose proof p_turns as (proper_eu & proper_ev & _). pose proof q_turns as (proper_fu & proper_fv & _).
  assert (is_sum : forall s t, lies_on w s -> lies_on u t -> is_sum_of_points x s t)
    by (intros s t on_s on_t; now exists w, u).
  destruct (Qeq_dec (angle ev) (angle fu)) as [along_ | apart_1].
  { apply contradiction_. rewrite ev_is, fu_is in along_.
    apply (parallel_edges_are_on_the_convolution p q a b a_in b_in (p_edges a a_in) (q_edges b b_in) x i_out j_in);
      auto. }
  destruct (Qeq_dec (angle eu) (angle fv)) as [along_ | apart_2].
  { apply contradiction_. rewrite eu_is, fv_is in along_.
    apply (parallel_edges_are_on_the_convolution p q a b a_in b_in (p_edges a a_in) (q_edges b b_in) x i_in j_out);
      auto. }
  pose proof (direction_by_index a i_out i_out_below) as ev_along. fold (edge_at a i_out) in ev_along.
  pose proof (direction_by_index b j_out j_out_below) as fv_along. fold (edge_at b j_out) in fv_along.
  destruct (Qeq_dec (angle ev) (angle (opposite fv))) as [back | apart_3].
  { rewrite ev_is, ev_along in p_ahead. rewrite fv_is, fv_along in q_ahead.
    apply (opposite_edges_meet p q x w u (edge_at a i_out) (edge_at b j_out)); trivial;
      try now apply edge_at_in_region.
    rewrite <- ev_along, <- fv_along, <- ev_is, <- fv_is.
    apply same_direction_angle; [exact proper_ev | now apply opposite_nonzero | exact back]. }
  assert (q_point : forall k, (k < length a)%nat -> equal_vectors w (nth k a nowhere) ->
    forall t, lies_on u t -> lies_on (minus x (nth k a nowhere)) t).
  { intros k _ [wx wy] t on. destruct equal as [X Y]. refine (lies_on_equal _ _ _ _ on).
    unfold plus, minus in *; cbn [vx vy] in *. split; cbn [vx vy]; lra. }
  assert (p_point : forall k, (k < length b)%nat -> equal_vectors u (nth k b nowhere) ->
    forall t, lies_on w t -> lies_on (minus x (nth k b nowhere)) t).
  { intros k _ [ux uy] t on. destruct equal as [X Y]. refine (lies_on_equal _ _ _ _ on).
    unfold plus, minus in *; cbn [vx vy] in *. split; cbn [vx vy]; lra. }
  destruct (touching_corners eu ev fu fv proper_eu proper_ev proper_fu proper_fv p_turns q_turns apart_1 apart_2 apart_3)
    as [leads | [leads | [tangent | [tangent | [tangent | tangent]]]]].
  - destruct (eventually_and _ _ (p_inside _ leads) q_ahead) as (limit & L & near).
    destruct (near ((1 # 2) * limit)) as [inside_p on_q]; [lra | lra |].
    refine (inner_point_and_point p q x _ _ q_regular inside_p _ _).
    + right. exists (edge_at b j_out). split; [now apply edge_at_in_region | exact on_q].
    + destruct equal as [X Y]. unfold plus, moved_along, opposite in *; cbn [vx vy] in *.
      split; cbn [vx vy]; [rewrite X | rewrite Y]; ring.
  - destruct (eventually_and _ _ (q_inside _ leads) p_ahead) as (limit & L & near).
    destruct (near ((1 # 2) * limit)) as [inside_q on_p]; [lra | lra |].
    apply interiors_meet_other_way. refine (inner_point_and_point q p x _ _ p_regular inside_q _ _).
    + right. exists (edge_at a i_out). split; [now apply edge_at_in_region | exact on_p].
    + destruct swapped as [X Y]. unfold plus, moved_along, opposite in *; cbn [vx vy] in *.
      split; cbn [vx vy]; [rewrite X | rewrite Y]; ring.
  - apply contradiction_. destruct (p_tangent _ tangent) as (k & below & corner_ & at_vertex).
    apply (on_convolution_by_q p q a b a_in b_in x k j_out below j_out_below); [| now apply q_point].
    rewrite corner_, <- fv_is. exact tangent.
  - apply contradiction_. destruct (p_tangent _ tangent) as (k & below & corner_ & at_vertex).
    apply (on_convolution_by_q p q a b a_in b_in x k j_in below j_in_below); [| now apply q_point].
    rewrite corner_, <- fu_is. exact tangent.
  - apply contradiction_. destruct (q_tangent _ tangent) as (k & below & corner_ & at_vertex).
    apply (on_convolution_by_p p q a b a_in b_in x i_in k i_in_below below); [| now apply p_point].
    rewrite corner_, <- eu_is. exact tangent.
  - apply contradiction_. destruct (q_tangent _ tangent) as (k & below & corner_ & at_vertex).
    apply (on_convolution_by_p p q a b a_in b_in x i_out k i_out_below below); [| now apply p_point].
    rewrite corner_, <- ev_is. exact tangent.
Qed.

(* Theorem. For every x off the convolution, the winding number is positive if and only if the interiors of P and
   -Q + x have a point in common. *)
Theorem positive_winding_number_iff_common_inner_point (p q : region) (x : vector) :
  valid_region p -> valid_region q -> chains_do_not_touch p -> chains_do_not_touch q ->
  off x (convolution_segments p q) ->
  ((0 < winding_number x (convolution_segments p q))%Z <-> interiors_meet x p q).
Proof.
  intros p_region q_region p_apart q_apart free. split.
  - intros positive_. apply common_point_means_common_inner_point; trivial.
    now apply (positive_winding_number_iff_common_point p q x p_region q_region free).
  - destruct p_region as (p_edges & p_valid & _), q_region as (q_edges & q_valid & _).
    now apply interiors_meet_means_positive_winding_number.
Qed.
