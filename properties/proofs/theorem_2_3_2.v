(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Theorem 2.3.2, first part: the sum of an edge of P and a reflex vertex of Q is not on the boundary of the sum, but
   for the sums of vertices of P. No other chain of Q touches the vertex: without this the theorem is false
   (docs/findings.md). Near a reflex vertex more than a half plane is inside, so an edge can slide to its right
   (lemma_2_2_9.v). *)
From Coq Require Import QArith Qminmax Lqa ZArith Lia Bool List.
From Oplus Require Import direction angle sweep winding_number signed_crossings tie_rule in_out_degree regions
  weight winding_number_of_the_sum meeting_of_segments interiors_meet neighbourhoods left_of_an_edge
  theorem_4_2_1 theorem_2_2_10 observation_2_2_4 lemma_2_2_9 lemma_2_2_5.
Import ListNotations.

Open Scope Q_scope.

(* f_in ends where f_out begins, and no other edge comes there. *)
Definition meet_in_vertex (f_in f_out : segment) (r : region) : Prop :=
  In f_in (region_edges r) /\ In f_out (region_edges r) /\ equal_vectors (target f_in) (source f_out) /\
  forall t, In t (region_edges r) -> lies_on (source f_out) t -> t = f_in \/ t = f_out.

(* Near the vertex, only its two edges are near. *)
Lemma only_its_edges_near (f_in f_out : segment) (r : region) : meet_in_vertex f_in f_out r ->
  exists radius, 0 < radius /\ forall y, within radius (source f_out) y ->
    ~ lies_on y f_in -> ~ lies_on y f_out -> off y (region_edges r).
Proof.
  intros (_ & _ & _ & alone).
  set (others := filter (fun t => if lies_on_dec (source f_out) t then false else true) (region_edges r)).
  assert (free : off (source f_out) others).
  { intros t I. apply filter_In in I. destruct I as [_ is_other].
    destruct (lies_on_dec (source f_out) t); [discriminate is_other | assumption]. }
  destruct (off_near _ _ free) as (radius & R & near). exists radius. split; [exact R |].
  intros y close not_in not_out t I. destruct (lies_on_dec (source f_out) t) as [on | off_t] eqn:decided.
  - destruct (alone t I on) as [-> | ->]; assumption.
  - apply near; [exact close |]. apply filter_In. split; [exact I |]. now rewrite decided.
Qed.

(* Inside a reflex vertex, opposite to the middle of its two edges. *)
Lemma inside_a_reflex_vertex (r : region) (f_in f_out : segment) :
  valid_region r -> meet_in_vertex f_in f_out r -> cross (along f_in) (along f_out) < 0 ->
  has_segment r (source f_out) (minus (along f_in) (along f_out)).
Proof.
  intros (not_points & valid & meet) vertex right_turn.
  pose proof vertex as (I & J & [tx ty] & _).
  destruct (only_its_edges_near f_in f_out r vertex) as (radius & R & near).
  pose proof (region_edges_are_directions r not_points f_out J) as long.
  assert (half_positive : 0 < (1 # 2) * radius) by lra.
  destruct (no_vertex_near r f_out (source f_out) ((1 # 2) * radius) long (source_lies_on f_out) half_positive)
    as (v & v_near & v_on & v_free).
  set (n := minus (along f_in) (along f_out)).
  assert (left_of_out : 0 < cross (along f_out) n)
    by (unfold n, cross, minus in *; cbn [vx vy] in *; lra).
  destruct (eventually_and _ _ (left_of_an_edge_is_inside r f_out v n valid meet J v_on v_free left_of_out)
    (eventually_and _ _ (small_steps_stay_within radius (source f_out) n R)
      (small_steps_stay_within ((1 # 2) * radius) v n half_positive))) as (limit & L & all).
  exists limit. split; [exact L |]. intros t t0 t1.
  destruct (Qlt_le_dec 0 t) as [t_positive | none].
  - destruct (all t t_positive t1) as (start_inside & end_near & start_near). apply inside_is_in_region.
    apply (within_twice ((1 # 2) * radius) ((1 # 2) * radius) radius (source f_out) v) in start_near; [| lra | exact v_near].
    set (start := moved_along v n t) in *. set (end_ := moved_along (source f_out) n t) in *.
    assert (free_way : forall y, lies_on y (Segment start end_) -> off y (region_edges r)).
    { intros y on_way. apply near; [now apply (within_along radius (source f_out) start end_) | |].
      - (* y is not on f_in *)
        intros (k & [k0 k1] & X & Y). destruct on_way as (h & [h0 h1] & yx & yy).
        destruct v_on as (s & [s0 s1] & vx_is & vy_is). cbn [source target] in *.
        assert (seen : cross (minus y (source f_out)) (along f_out) == t * cross (along f_in) (along f_out)).
        { unfold minus at 1. unfold cross at 1. cbn [vx vy]. rewrite yx, yy. unfold start, end_, moved_along.
          cbn [vx vy]. rewrite vx_is, vy_is. unfold n, cross, along, minus; cbn [vx vy]. ring. }
        assert (also : cross (minus y (source f_out)) (along f_out) ==
                       - (1 - k) * cross (along f_in) (along f_out)).
        { unfold minus at 1. unfold cross at 1. cbn [vx vy]. rewrite X, Y, <- tx, <- ty.
          unfold cross, along, minus; cbn [vx vy]. ring. }
        rewrite seen in also. set (c := cross (along f_in) (along f_out)) in *. clearbody c.
        assert (0 <= (1 - k) * - c) by (apply Qmult_le_0_compat; lra).
        assert (0 < t * - c) by (apply Qmult_lt_0_compat; lra). lra.
      - apply off_by_area. destruct on_way as (h & _ & yx & yy).
        destruct v_on as (s & _ & vx_is & vy_is). cbn [source target] in *.
        assert (value : area f_out y == t * cross (along f_out) n).
        { unfold area, minus at 2. unfold cross at 1. cbn [vx vy]. rewrite yx, yy. unfold start, end_, moved_along.
          cbn [vx vy]. rewrite vx_is, vy_is. unfold n, cross, along, minus; cbn [vx vy]. ring. }
        rewrite value. assert (0 < t * cross (along f_out) n) by now apply Qmult_lt_0_compat. lra. }
    pose proof (winding_number_along (Segment start end_) _ (region_cycles r) free_way) as same_number.
    cbn [source target] in same_number. split; [| rewrite <- same_number; apply start_inside].
    apply free_way. apply (target_lies_on (Segment start end_)).
  - right. exists f_out. split; [exact J |]. assert (t_is : t == 0) by lra. exists 0.
    unfold moved_along; cbn [vx vy]. rewrite t_is. split; [lra |]. split; ring.
Qed.

Lemma inner_point_equal (x y : vector) (p q : region) :
  equal_vectors x y -> inner_point_of_sum x p q -> inner_point_of_sum y p q.
Proof.
  intros [X Y] (radius & R & near). exists radius. split; [exact R |]. intros z close. apply near.
  unfold within in *. lra.
Qed.

(* Theorem 2.3.2, first part. *)
Theorem edge_plus_reflex_vertex_is_inner (p q : region) (e f_in f_out : segment) (w : vector) :
  valid_region p -> valid_region q ->
  In e (region_edges p) -> lies_on w e -> ~ is_vertex w p ->
  meet_in_vertex f_in f_out q -> cross (along f_in) (along f_out) < 0 ->
  inner_point_of_sum (plus w (source f_out)) p q.
Proof.
  intros p_region q_region I on no_vertex vertex right_turn.
  pose proof vertex as (in_ & out_ & [tx ty] & _).
  destruct (sliding_lemma p q e f_out w p_region I on no_vertex out_) as [slide_out _].
  destruct (sliding_lemma p q e f_in w p_region I on no_vertex in_) as [_ slide_in].
  destruct (Qlt_le_dec (cross (along e) (along f_out)) 0) as [out_right | out_left]; [now apply slide_out |].
  destruct (Qlt_le_dec (cross (along e) (opposite (along f_in))) 0) as [in_right | in_left].
  { apply (inner_point_equal (plus w (target f_in))); [| now apply slide_in].
    unfold plus. split; cbn [vx vy]; lra. }
  apply (sliding p q e w (source f_out) (minus (along f_in) (along f_out))); trivial.
  - now apply inside_a_reflex_vertex.
  - destruct p_region as (p_edges & _). pose proof (region_edges_are_directions p p_edges e I) as long.
    assert (square : 0 < vx (along e) * vx (along e) + vy (along e) * vy (along e)).
    { destruct (Qlt_le_dec 0 (vx (along e) * vx (along e) + vy (along e) * vy (along e))) as [| none];
        [assumption |]. exfalso. apply long. now apply no_squares. }
    assert (value : (vx (along e) * vx (along e) + vy (along e) * vy (along e)) *
                    cross (along f_in) (along f_out) ==
                    cross (along e) (along f_out) * dot (along e) (along f_in) -
                    cross (along e) (along f_in) * dot (along e) (along f_out)) by (unfold cross, dot; ring).
    assert (difference : cross (along e) (minus (along f_in) (along f_out)) ==
                         cross (along e) (along f_in) - cross (along e) (along f_out))
      by (unfold cross, minus; cbn [vx vy]; ring).
    assert (back : cross (along e) (opposite (along f_in)) == - cross (along e) (along f_in))
      by (unfold cross, opposite; cbn [vx vy]; ring).
    rewrite difference. rewrite back in in_left.
    destruct (Qlt_le_dec (cross (along e) (along f_in) - cross (along e) (along f_out)) 0) as [| none];
      [assumption | exfalso].
    assert (zero_out : cross (along e) (along f_out) == 0) by lra.
    assert (zero_in : cross (along e) (along f_in) == 0) by lra.
    rewrite zero_out, zero_in in value.
    set (c := cross (along f_in) (along f_out)) in *. clearbody c. nra.
Qed.

(* So it is not on the boundary. *)
Theorem edge_plus_reflex_vertex_is_not_on_the_boundary (p q : region) (e f_in f_out : segment) (w : vector) :
  valid_region p -> valid_region q ->
  In e (region_edges p) -> lies_on w e -> ~ is_vertex w p ->
  meet_in_vertex f_in f_out q -> cross (along f_in) (along f_out) < 0 ->
  ~ on_boundary_of_sum (plus w (source f_out)) p q.
Proof.
  intros p_region q_region I on no_vertex vertex right_turn. apply inner_points_are_not_on_the_boundary.
  now apply (edge_plus_reflex_vertex_is_inner p q e f_in).
Qed.
