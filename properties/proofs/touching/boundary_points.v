(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The boundary of a region at each of its points: an edge that enters and one that leaves, which at a point
   inside an edge are the same, their tangent set, and what is inside near the point. Chains do not touch here:
   only the two edges of a vertex meet there. What is inside near is from left_of_an_edge.v and inside_a_corner.v. *)
From Coq Require Import ZArith Lia Bool List Arith.
From Oplus Require Import numbers convolution signed_crossings tie_rule regions weight winding_number_of_the_sum
  meeting_of_segments interiors_meet neighbourhoods left_of_an_edge theorem_4_2_1 observation_2_2_4 inside_a_corner
  tangent_direction.
Import ListNotations.

Open Scope Q_scope.

(* At each vertex only the two edges of its chain meet. *)
Definition chains_do_not_touch (r : region) : Prop :=
  forall chain i, In chain r -> (i < length chain)%nat ->
    meet_in_vertex (edge_at chain (previous (length chain) i)) (edge_at chain i) r.

Lemma vertex_or_not (w : vector) (r : region) : is_vertex w r \/ ~ is_vertex w r.
Proof.
  unfold is_vertex. induction (region_edges r) as [| s rest IH]; [right; intros (u & [] & _) |].
  destruct (Qeq_dec (vx w) (vx (source s))) as [X | X], (Qeq_dec (vy w) (vy (source s))) as [Y | Y];
    [left; exists s; split; [now left | now split] | ..];
    (destruct IH as [(u & I & equal) | none];
     [left; exists u; split; [now right | exact equal] |
      right; intros (u & [<- | I] & [ux uy]); [tauto | apply none; exists u; split; [exact I | now split]]]).
Qed.

(* Edges one of which begins where the other ends do not lie along each other. *)
Lemma consecutive_edges_turn (r : region) (f_in f_out : segment) :
  valid_region r -> In f_in (region_edges r) -> In f_out (region_edges r) ->
  equal_vectors (target f_in) (source f_out) -> turns (along f_in) (along f_out).
Proof.
  intros (not_points & valid & meet) I J [tx ty].
  pose proof (region_edges_are_directions r not_points f_in I) as long_in.
  pose proof (region_edges_are_directions r not_points f_out J) as long_out.
  split; [exact long_in |]. split; [exact long_out |]. intros parallel.
  destruct (Qlt_le_dec 0 (dot (along f_in) (along f_out))) as [| back]; [assumption | exfalso].
  set (u := along f_in) in *. set (v := along f_out) in *.
  pose proof (square_positive u long_in) as square.
  destruct (multiple_of v u long_in) as (c & v_x & v_y); [unfold cross in *; lra |].
  set (m := - c). assert (m_range : 0 <= m)
    by (unfold m; unfold dot in back, square; rewrite v_x, v_y in back; apply Qnot_lt_le; intros ahead_; nra).
  assert (m_x : vx v == - m * vx u) by (unfold m; lra). assert (m_y : vy v == - m * vy u) by (unfold m; lra).
  clear v_x v_y. rename m_x into v_x, m_y into v_y. clearbody m.
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

Lemma vertex_turns (r : region) (f_in f_out : segment) :
  valid_region r -> meet_in_vertex f_in f_out r -> turns (along f_in) (along f_out).
Proof. intros valid (I & J & follows & _). now apply (consecutive_edges_turn r). Qed.

(* The boundary of a region at one of its points: an edge of a chain comes in direction u and one leaves in
   direction v; at a point inside an edge both are that edge. *)
Record boundary_point (r : region) (w : vector) (chain : list vector) (i_in i_out : nat) (u v : vector) : Prop :=
  BoundaryPoint {
    chain_in : In chain r;
    in_below : (i_in < length chain)%nat;
    out_below : (i_out < length chain)%nat;
    u_is : u = edge_of_chain chain i_in;
    v_is : v = edge_of_chain chain i_out;
    on_in : exists l, 0 < l <= 1 /\ equal_vectors w (moved_along (nth i_in chain nowhere) u l);
    on_out : exists k, 0 <= k < 1 /\ equal_vectors w (moved_along (nth i_out chain nowhere) v k);
    corner_turns : turns u v;
    goes_ahead : eventually (fun t => lies_on (moved_along w v t) (edge_at chain i_out));
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
    exists chain, (previous (length chain) i), i, (edge_of_chain chain (previous (length chain) i)),
      (edge_of_chain chain i).
    split; trivial.
    + exists 1. split; [lra |]. rewrite edge_of_chain_is, next_previous by assumption.
      rewrite edge_at_is in vertex by exact below. destruct vertex as [X Y]. unfold moved_along, minus.
      cbn [source vx vy] in *. split; cbn [vx vy]; lra.
    + exists 0. split; [lra |]. rewrite edge_at_is in vertex by exact below. destruct vertex as [X Y].
      unfold moved_along; cbn [source vx vy] in *. split; cbn [vx vy]; lra.
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
    destruct (inside_an_edge r _ w I on no_vertex) as (k & [after_start before_end] & X & Y).
    assert (w_is : equal_vectors w (moved_along (nth i chain nowhere) (edge_of_chain chain i) k)).
    { rewrite is_along, edge_at_is by exact below. rewrite edge_at_is in X, Y by exact below.
      unfold moved_along, along, minus; cbn [source target vx vy] in *.
      split; cbn [vx vy]; [rewrite X | rewrite Y]; ring. }
    exists chain, i, i, (edge_of_chain chain i), (edge_of_chain chain i). split; trivial.
    + exists k. split; [lra |]. exact w_is.
    + exists k. split; [lra |]. exact w_is.
    + split; [exact long |]. split; [exact long |]. intros _. exact (square_positive _ long).
    + exists (1 - k). split; [lra |]. intros t t0 t1. exists (k + t). unfold moved_along; cbn [vx vy].
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
