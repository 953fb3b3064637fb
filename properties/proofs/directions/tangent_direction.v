(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Tangent sets (thesis, Definition 2.1.13) are empty inside straight lines only, and every closed chain has a
   vertex whose tangent set is not empty. Directions and ccw are those of direction.v, chains those of
   turning_number.v. *)
From Coq Require Import QArith Lqa Lia Bool List.
From Oplus Require Import convolution regions small_numbers first_hit first_edge_of_a_ray.
Import ListNotations.

Open Scope Q_scope.

(* A direction to the left of the edge that enters, which has the edge that leaves to its left. *)
Lemma tangent_between (d : direction) (c : corner) :
  0 < cross (incoming c) (vec d) -> 0 < cross (vec d) (outgoing c) -> in_tangent_set d c = true.
Proof.
  destruct d as [d label], c as [u v]. cbn [vec incoming outgoing]. intros left_of_u left_of_d.
  assert (proper_u : nonzero u) by (intros [x y]; unfold cross in *; rewrite x, y in *; lra).
  assert (proper_v : nonzero v) by (intros [x y]; unfold cross in *; rewrite x, y in *; lra).
  assert (proper_d : nonzero d) by (intros [x y]; unfold cross in *; rewrite x, y in *; lra).
  pose proof (cross_angle u d proper_u proper_d) as first_turn.
  pose proof (cross_angle d v proper_d proper_v) as second_turn. unfold turns_by in *.
  pose proof (angle_range u proper_u). pose proof (angle_range v proper_v).
  pose proof (angle_range d proper_d).
  unfold in_tangent_set. cbn [of incoming outgoing].
  destruct (ccw_spec (Direction d label) (Direction u (other label)) (Direction v (other label))
              proper_d proper_u proper_v) as [between | not_between]; [reflexivity | exfalso].
  apply not_between. unfold in_order, earlier. cbn [vec]. lra.
Qed.

(* Equal directions, or a direction between. *)
Lemma tangent_or_straight (c : corner) : proper_corner c ->
  (cross (incoming c) (outgoing c) == 0 /\ 0 < dot (incoming c) (outgoing c)) \/
  exists d, nonzero d /\ forall label, in_tangent_set (Direction d label) c = true.
Proof.
  destruct c as [u v]. intros [proper_u proper_v]. cbn [incoming outgoing] in *.
  assert (found : forall d, 0 < cross u d -> 0 < cross d v ->
    exists d, nonzero d /\ forall label, in_tangent_set (Direction d label) (Corner u v) = true).
  { intros d left_of_u left_of_d. exists d. split.
    - intros [x y]. unfold cross in *. rewrite x, y in *. lra.
    - intros label. now apply tangent_between. }
  compared_numbers (cross u v ?= 0).
  - destruct (Qlt_le_dec 0 (dot u v)) as [ahead | back]; [now left | right].
    pose proof (square_positive u proper_u) as square. unfold dot in square.
    assert (not_zero : ~ dot u v == 0).
    { intros zero_dot. apply proper_v. unfold cross, dot in *.
      split; apply (Qmult_inj_r _ _ (vx u * vx u + vy u * vy u)); try lra.
      - setoid_replace (vx v * (vx u * vx u + vy u * vy u)) with
          ((vx u * vx v + vy u * vy v) * vx u - (vx u * vy v - vy u * vx v) * vy u) by ring.
        rewrite C, zero_dot. ring.
      - setoid_replace (vy v * (vx u * vx u + vy u * vy u)) with
          ((vx u * vx v + vy u * vy v) * vy u + (vx u * vy v - vy u * vx v) * vx u) by ring.
        rewrite C, zero_dot. ring. }
    apply (found (Vector (- vy u) (vx u))); unfold cross, dot in *; cbn; lra.
  - right. apply (found (Vector (- (vx u + vx v)) (- (vy u + vy v)))); unfold cross in *; cbn; lra.
  - right. apply (found (Vector (vx u + vx v) (vy u + vy v))); unfold cross in *; cbn; lra.
Qed.

(* Theorem. Every closed chain, no edge of which is a point, has a vertex with a direction in its tangent set: a
   vertex that is extreme in a direction that no edge has. *)
Theorem some_tangent_set_is_not_empty (chain : list vector) :
  no_edge_is_a_point chain -> chain <> [] ->
  exists i d, (i < length chain)%nat /\ nonzero d /\
    forall label, in_tangent_set (Direction d label) (corner_of_chain chain i) = true.
Proof.
  intros proper some. destruct (direction_beside (edge_directions chain) proper) as (w & _ & beside).
  destruct (least_of (cross w) chain some) as (v & I & least).
  apply (In_nth chain v nowhere) in I. destruct I as (i & I & <-). pose proof (previous_below _ _ I) as J.
  destruct (tangent_or_straight (corner_of_chain chain i) (corner_proper chain i proper I))
    as [[along ahead] | (d & D & tangent)]; [exfalso | now exists i, d].
  rewrite corner_is in along, ahead by exact I. cbn [incoming outgoing] in *.
  assert (beside_edge : forall k, (k < length chain)%nat -> ~ cross w (edge_of_chain chain k) == 0)
    by (intros k K; apply beside, nth_In; now rewrite edges_length).
  pose proof (beside_edge i I) as beside_out. pose proof (beside_edge _ J) as beside_in.
  pose proof (least _ (nth_In chain nowhere J)) as less_in.
  pose proof (least _ (nth_In chain nowhere (next_in_range _ _ I))) as less_out.
  rewrite (edge_of_chain_is chain i I) in along, ahead, beside_out.
  rewrite (edge_of_chain_is chain _ J), next_previous in along, ahead, beside_in by exact I.
  set (u := minus _ (nth (previous _ _) _ _)) in *. set (v := minus (nth (next _ _) _ _) _) in *.
  assert (into : cross w u <= 0) by (unfold u, cross, minus in *; cbn [vx vy]; lra).
  assert (out_of : 0 <= cross w v) by (unfold v, cross, minus in *; cbn [vx vy]; lra).
  clearbody u v.
  assert (parallel : dot u u * cross w v == dot u v * cross w u) by (unfold cross, dot in *; by_equations).
  assert (0 <= dot u u) by (unfold dot; nra). assert (cross w u < 0) by lra. nra.
Qed.

(* A vertex that is not inside a straight line. *)
Lemma some_vertex_turns (chain : list vector) : no_edge_is_a_point chain -> chain <> [] ->
  exists i, (i < length chain)%nat /\
    ~ angle (edge_of_chain chain (previous (length chain) i)) == angle (edge_of_chain chain i).
Proof.
  intros proper some. destruct (some_tangent_set_is_not_empty chain proper some) as (i & d & I & D & tangent).
  exists i. split; [exact I |]. intros straight. specialize (tangent OfP).
  rewrite corner_is in tangent by exact I. unfold in_tangent_set in tangent.
  cbn [of other incoming outgoing] in tangent.
  pose proof (edge_nonzero chain i proper I) as out_.
  pose proof (edge_nonzero chain _ proper (previous_below _ _ I)) as in_.
  destruct (ccw_spec (Direction d OfP) (Direction (edge_of_chain chain (previous (length chain) i)) OfQ)
              (Direction (edge_of_chain chain i) OfQ) D in_ out_) as [order_ |]; [| discriminate tangent].
  unfold in_order, earlier, place in order_. cbn [vec of] in order_. lra.
Qed.
