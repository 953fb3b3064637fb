(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* In a region whose edges meet in vertices only, and whose winding numbers are not negative, what is close to the
   left of an edge is inside: the winding number there is one more than to the right (thesis, Observation
   4.2.5, on a step across the edge). So every point of a region has points near it that are inside. Small steps
   and neighbourhoods are from neighbourhoods.v. *)
From Coq Require Import ZArith Lia Bool List.
From Oplus Require Import numbers convolution shifted_ray signed_crossings small_numbers tie_rule regions weight
  beside_every_point meeting_of_segments interiors_meet neighbourhoods.
Import ListNotations.

Open Scope Q_scope.

Definition is_vertex (w : vector) (r : region) : Prop :=
  exists u, In u (region_edges r) /\ equal_vectors w (source u).

(* A point that is on two edges is a vertex. Chains may touch, also a vertex the inside of an edge; they may not
   cross or overlap, and no edge may be there twice. *)
Definition edges_meet_in_vertices (r : region) : Prop :=
  forall earlier s later t w, region_edges r = earlier ++ s :: later -> In t (earlier ++ later) ->
    lies_on w s -> lies_on w t -> is_vertex w r.

(* The closure of its interior: every boundary point has points inside the region near it. *)
Definition is_regular (r : region) : Prop :=
  forall w s radius, In s (region_edges r) -> lies_on w s -> 0 < radius ->
    exists z, within radius w z /\ inside z r.

Lemma target_is_vertex (r : region) (s : segment) : In s (region_edges r) -> is_vertex (target s) r.
Proof.
  intros I. apply in_flat_map in I. destruct I as (chain & J & I).
  destruct (edge_from_vertex chain (target s) (proj2 (ends_of_edges chain s I))) as (u & U & is_source).
  exists u. split; [apply in_flat_map; now exists chain |]. rewrite is_source. reflexivity.
Qed.

Lemma vertex_of_equal (v w : vector) (r : region) : equal_vectors v w -> is_vertex v r -> is_vertex w r.
Proof. intros equal (u & U & is_u). exists u. split; [exact U |]. now rewrite <- equal. Qed.

Lemma inside_an_edge (r : region) (s : segment) (w : vector) :
  In s (region_edges r) -> lies_on w s -> ~ is_vertex w r -> strictly_inside w s.
Proof.
  intros I on no_vertex. destruct (inside_or_end w s on) as [inside_ | [equal | equal]];
    [exact inside_ | destruct no_vertex ..].
  - now exists s.
  - apply (vertex_of_equal _ _ r equal), target_is_vertex, I.
Qed.

(* Near a point of an edge that is no vertex is no other edge. *)
Lemma no_other_edge_near (r : region) (s : segment) (w : vector) :
  edges_meet_in_vertices r -> In s (region_edges r) -> lies_on w s -> ~ is_vertex w r ->
  exists earlier later radius, region_edges r = earlier ++ s :: later /\ 0 < radius /\
    forall v, within radius w v -> off v (earlier ++ later) /\ (~ area s v == 0 -> off v (region_edges r)).
Proof.
  intros meet I on no_vertex. destruct (in_split _ _ I) as (earlier & later & edges_are).
  destruct (off_near w (earlier ++ later)) as (radius & R & near).
  { intros t J on_t. apply no_vertex. exact (meet earlier s later t w edges_are J on on_t). }
  exists earlier, later, radius. split; [exact edges_are |]. split; [exact R |]. intros v close.
  split; [now apply near |]. intros beside t J. rewrite edges_are in J. apply in_elt_inv in J.
  destruct J as [<- | J]; [now apply off_by_area | now apply near].
Qed.

(* A step across an edge from its right to its left is counted once. *)
Lemma step_across (s : segment) (w n : vector) (e : Q) :
  strictly_inside w s -> 0 < cross (along s) n -> 0 < e ->
  area s (moved_along w n e) > 0 /\ area s (moved_along w n (- e)) < 0 /\
  signed_crossing_of_step (moved_along w n (- e)) (moved_along w n e) s = 1%Z.
Proof.
  intros (k & range & X & Y) left_ small. destruct s as [a b]. unfold along in left_. cbn [source target] in *.
  set (c := cross (minus b a) n) in *.
  assert (after : area (Segment a b) (moved_along w n e) == e * c)
    by (unfold area, c, cross, minus, moved_along; cbn; rewrite X, Y; ring).
  assert (before : area (Segment a b) (moved_along w n (- e)) == - (e * c))
    by (unfold area, c, cross, minus, moved_along; cbn; rewrite X, Y; ring).
  assert (positive_ : 0 < e * c) by nra.
  split; [lra |]. split; [lra |].
  assert (of_source : area (Segment (moved_along w n (- e)) (moved_along w n e)) a == 2 * k * (e * c))
    by (unfold area, c, cross, minus, moved_along; cbn; rewrite X, Y; ring).
  assert (of_target : area (Segment (moved_along w n (- e)) (moved_along w n e)) b == - (2 * (1 - k) * (e * c)))
    by (unfold area, c, cross, minus, moved_along; cbn; rewrite X, Y; ring).
  assert (0 < k * (e * c) /\ 0 < (1 - k) * (e * c)) as [? ?] by (split; apply Qmult_lt_0_compat; lra).
  unfold signed_crossing_of_step, side_of_segment, side_of_step. cbn [source target]. rewrite !orientation_by_area.
  rewrite (proj1 (Qlt_alt _ 0)), (proj1 (Qgt_alt (area _ (moved_along w n e)) 0)),
    (proj1 (Qgt_alt (area _ a) 0)), (proj1 (Qlt_alt (area _ b) 0)) by lra.
  reflexivity.
Qed.

(* Theorem. Where an edge meets no other, at a point that is no vertex, the winding number to its left is one more than
   to its right. *)
Theorem left_is_one_more (r : region) (s : segment) (w n : vector) :
  edges_meet_in_vertices r -> In s (region_edges r) -> lies_on w s -> ~ is_vertex w r -> 0 < cross (along s) n ->
  eventually (fun e =>
    off (moved_along w n e) (region_edges r) /\ off (moved_along w n (- e)) (region_edges r) /\
    winding_number (moved_along w n e) (region_edges r) =
      (winding_number (moved_along w n (- e)) (region_edges r) + 1)%Z).
Proof.
  intros meet I on no_vertex left_.
  destruct (no_other_edge_near r s w meet I on no_vertex) as (earlier & later & radius & edges_are & R & near).
  pose proof (inside_an_edge r s w I on no_vertex) as inside_.
  refine (eventually_implied _ _ _ (eventually_and _ _ (eventually_below 1 _)
    (eventually_and _ _ (small_steps_stay_within radius w n R) (small_steps_stay_within radius w (opposite n) R))));
      [| lra].
  intros e ([some _] & close_left & close_right).
  assert (close_right_ : within radius w (moved_along w n (- e)))
    by (unfold within, moved_along, opposite in *; cbn [vx vy] in *; lra).
  destruct (step_across s w n e inside_ left_ some) as (on_left & on_right & once).
  set (from := moved_along w n (- e)) in *. set (to := moved_along w n e) in *.
  assert (off_from : off from (region_edges r)) by (apply near; [exact close_right_ | lra]).
  assert (off_to : off to (region_edges r)) by (apply near; [exact close_left | lra]).
  assert (moves : nonzero (minus to from)).
  { intros [zero_x zero_y]. assert (area s to == area s from); [| lra].
    unfold from, to in *. in_coordinates. by_equations. }
  pose proof (step_changes_winding_number from to _ (region_cycles r) off_from off_to moves) as change.
  assert (others : forall t, In t (earlier ++ later) -> signed_crossing_of_step from to t = 0%Z).
  { intros t J. destruct (Z.eq_dec (signed_crossing_of_step from to t) 0) as [| crosses]; [assumption | exfalso].
    destruct (crossing_steps_meet from to t crosses) as (v & on_step & on_t).
    exact (proj1 (near v (within_along radius w from to v close_right_ close_left on_step)) t J on_t). }
  rewrite edges_are, (sums_but_for_one _ _ (fun _ => 0%Z)), sum_of_zeros, once, <- edges_are in change by trivial.
  split; [exact off_to |]. split; [exact off_from |]. lia.
Qed.

(* Theorem. So what is close to its left is inside, if no winding number is negative. *)
Theorem left_of_an_edge_is_inside (r : region) (s : segment) (w n : vector) :
  nowhere_negative r -> edges_meet_in_vertices r ->
  In s (region_edges r) -> lies_on w s -> ~ is_vertex w r -> 0 < cross (along s) n ->
  eventually (fun e => inside (moved_along w n e) r).
Proof.
  intros valid meet I on no_vertex left_.
  refine (eventually_implied _ _ _ (left_is_one_more r s w n meet I on no_vertex left_)).
  intros e (off_to & off_from & more). split; [exact off_to |].
  pose proof (valid _ off_from). lia.
Qed.

(* Of the points close to w in a direction, at most one is a given point. *)
Lemma leaves_a_point (w u v : vector) : nonzero u -> eventually (fun e => ~ equal_vectors (moved_along w u e) v).
Proof.
  intros moves.
  destruct (Qeq_dec (vx u) 0) as [no_x | some_x].
  - destruct (Qeq_dec (vy u) 0) as [no_y | some_y]; [exfalso; now apply moves |].
    refine (eventually_implied _ _ _ (leaves_a_number (vy w) (vy u) (vy v) some_y)).
    intros e differ [_ equal]. exact (differ equal).
  - refine (eventually_implied _ _ _ (leaves_a_number (vx w) (vx u) (vx v) some_x)).
    intros e differ [equal _]. exact (differ equal).
Qed.

Lemma leaves_all_heights (segments : list segment) (x : vector) :
  eventually (fun e => forall t, In t segments -> ~ vy (moved_along x (Vector 0 1) e) == vy (source t)).
Proof.
  apply (eventually_for_all (fun t e => ~ vy x + e * 1 == vy (source t))). intros t _. apply leaves_a_number. lra.
Qed.

Lemma leaves_all_vertices (r : region) (w u : vector) : nonzero u ->
  eventually (fun e => ~ is_vertex (moved_along w u e) r).
Proof.
  intros moves. refine (eventually_implied _ _ _ (eventually_for_all _ (region_edges r)
    (fun t _ => leaves_a_point w u (source t) moves))). intros e differ (t & I & equal). exact (differ t I equal).
Qed.

(* Near each point of an edge are points of it that are no vertices. *)
Lemma no_vertex_near (r : region) (s : segment) (w : vector) (radius : Q) :
  nonzero (along s) -> lies_on w s -> 0 < radius ->
  exists v, within radius w v /\ lies_on v s /\ ~ is_vertex v r.
Proof.
  intros long (k & [k0 k1] & X & Y) R.
  assert (found : forall u, nonzero u -> eventually (fun e => lies_on (moved_along w u e) s) ->
    exists v, within radius w v /\ lies_on v s /\ ~ is_vertex v r).
  { intros u moves on.
    destruct (some_small _ (eventually_and _ _ on (eventually_and _ _ (small_steps_stay_within radius w u R)
      (leaves_all_vertices r w u moves)))) as (e & _ & on_s & close & differ). now exists (moved_along w u e). }
  destruct (Qlt_le_dec k 1) as [before_end | at_end].
  - apply (found (along s) long). exists (1 - k). split; [lra |]. intros e positive_ below.
    exists (k + e). unfold moved_along, along, minus; cbn [vx vy]. split; [lra |].
    rewrite X, Y. split; ring.
  - apply (found (opposite (along s)) (opposite_nonzero _ long)). exists 1. split; [lra |]. intros e positive_ below.
    exists (k - e). unfold moved_along, along, opposite, minus; cbn [vx vy]. split; [lra |].
    rewrite X, Y. split; ring.
Qed.

Lemma within_twice (r1 r2 radius : Q) (x y z : vector) :
  r1 + r2 <= radius -> within r1 x y -> within r2 y z -> within radius x z.
Proof. unfold within. lra. Qed.

(* Theorem. So such a region is the closure of its interior. *)
Theorem regions_are_regular (r : region) :
  no_edges_are_points r -> nowhere_negative r -> edges_meet_in_vertices r -> is_regular r.
Proof.
  intros not_points valid meet w s radius I on R.
  pose proof (winding_number_of_the_sum.region_edges_are_directions r not_points s I) as long.
  destruct (no_vertex_near r s w ((1 # 2) * radius) long on) as (v & near_v & on_v & no_vertex); [lra |].
  set (n := Vector (- vy (along s)) (vx (along s))).
  destruct (some_small _ (eventually_and _ _
    (left_of_an_edge_is_inside r s v n valid meet I on_v no_vertex (left_normal s long))
    (small_steps_stay_within ((1 # 2) * radius) v n ltac:(lra)))) as (e & _ & in_r & close).
  exists (moved_along v n e). split; [| exact in_r].
  apply (within_twice ((1 # 2) * radius) ((1 # 2) * radius) radius w v); [lra | exact near_v | exact close].
Qed.

(* Every point of a region has points inside near it. *)
Lemma inside_near (r : region) (a : vector) (radius : Q) :
  is_regular r -> in_region a r -> 0 < radius -> exists z, within radius a z /\ inside z r.
Proof.
  intros regular [positive_ | (s & I & on)] R; [| now apply (regular a s)].
  destruct (some_small _ (eventually_and _ _ (shifted_stays_within radius a R)
    (eventually_and _ _ (shifted_off_all a (region_edges r)) (same_beside a (region_edges r)))))
    as (e & _ & near_a & off_r & same_number).
  exists (moved (shifted a) e). split; [exact near_a |]. split; [exact off_r | lia].
Qed.
