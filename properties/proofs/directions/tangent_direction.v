(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Tangent sets (thesis, Definition 2.1.13) are empty inside straight lines only, and every closed chain has a
   vertex whose tangent set is not empty. Directions and ccw are those of direction.v, chains those of
   turning_number.v. *)
From Coq Require Import Lia Bool List.
From Oplus Require Import numbers convolution regions.
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

(* Of two points, one comes first from left to right, and from below if they are one above the other. *)
Definition not_before (a b : vector) : Prop := vx b < vx a \/ (vx a == vx b /\ vy b <= vy a).

Lemma last_point (l : list vector) : l <> [] -> exists a, In a l /\ forall b, In b l -> not_before a b.
Proof.
  unfold not_before. induction l as [| a l IH]; intros some; [now destruct some |]. destruct l as [| b l].
  - exists a. split; [now left |]. intros c [<- | []]. lra.
  - destruct IH as (c & I & last); [discriminate |].
    assert (order : not_before a c \/ not_before c a).
    { unfold not_before. destruct (Qlt_le_dec (vx c) (vx a)), (Qlt_le_dec (vx a) (vx c)); try tauto.
      destruct (Qlt_le_dec (vy c) (vy a)); [left | right]; right; split; lra. }
    unfold not_before in order. destruct order as [later | later].
    + exists a. split; [now left |]. intros d [<- | J]; [lra |]. specialize (last d J). lra.
    + exists c. split; [now right |]. intros d [<- | J]; [lra | auto].
Qed.

(* Theorem. Every closed chain, no edge of which is a point, has a vertex with a direction in its tangent set. *)
Theorem some_tangent_set_is_not_empty (chain : list vector) :
  no_edge_is_a_point chain -> chain <> [] ->
  exists i d, (i < length chain)%nat /\ nonzero d /\
    forall label, in_tangent_set (Direction d label) (corner_of_chain chain i) = true.
Proof.
  intros proper some. destruct (last_point chain some) as (a & I & last).
  apply (In_nth chain a nowhere) in I. destruct I as (i & I & <-).
  pose proof (previous_below _ _ I) as J. pose proof (next_in_range _ _ I) as K.
  destruct (tangent_or_straight (corner_of_chain chain i) (corner_proper chain i proper I))
    as [[along ahead] | (d & D & tangent)]; [exfalso | now exists i, d].
  rewrite corner_is in along, ahead by exact I. cbn [incoming outgoing] in *.
  pose proof (edge_nonzero chain i proper I) as proper_out.
  pose proof (edge_nonzero chain _ proper J) as proper_in.
  rewrite (edge_of_chain_is chain i I) in along, ahead, proper_out.
  rewrite (edge_of_chain_is chain _ J), next_previous in along, ahead, proper_in by exact I.
  pose proof (last _ (nth_In chain nowhere J)) as before. pose proof (last _ (nth_In chain nowhere K)) as after.
  unfold not_before, cross, dot, nonzero, minus in *. cbn [vx vy] in *.
  set (ax := vx (nth i chain nowhere)) in *. set (ay := vy (nth i chain nowhere)) in *.
  set (bx := vx (nth (previous (length chain) i) chain nowhere)) in *.
  set (by_ := vy (nth (previous (length chain) i) chain nowhere)) in *.
  set (cx := vx (nth (next i (length chain)) chain nowhere)) in *.
  set (cy := vy (nth (next i (length chain)) chain nowhere)) in *.
  clearbody ax ay bx by_ cx cy. clear last some.
  assert (in_x : 0 <= ax - bx) by lra. assert (out_x : cx - ax <= 0) by lra.
  set (ux := ax - bx) in *. set (wx := cx - ax) in *. set (uy := ay - by_) in *. set (wy := cy - ay) in *.
  assert (before_ : 0 < ux \/ (ux == 0 /\ 0 <= uy)) by (unfold ux, uy; lra).
  assert (after_ : wx < 0 \/ (wx == 0 /\ wy <= 0)) by (unfold wx, wy; lra).
  clearbody ux wx uy wy. clear before after ax ay bx by_ cx cy.
  destruct before_ as [before | [ux_zero before]], after_ as [after | [wx_zero after]].
  - assert (0 < uy * wy) by nra. destruct (Qlt_le_dec 0 uy); nra.
  - rewrite wx_zero in *. apply proper_out. split; [reflexivity | nra].
  - rewrite ux_zero in *. apply proper_in. split; [reflexivity | nra].
  - rewrite ux_zero, wx_zero in *. nra.
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
