(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* All along an edge that meets others at its ends only, the winding number close to its right is the same: that right
   of
   its middle, as the code counts it on symbolic shifts (beside_a_piece.v).
   And the winding number of every point off the
   chains is that to the right of some edge, one more, or zero: go to the right until the first edge (first_hit.v). So
   winding numbers are nowhere negative if they are not beside the middles of edges. *)
From Coq Require Import ZArith Lia Bool List.
From Oplus Require Import numbers regions_and_sums observation_2_2_4.
From Oplus Require Export beside_a_piece.
Import ListNotations.

Open Scope Q_scope.

(* All points close to the right of a point of an edge have one winding number. *)
Lemma right_side_near (r : region) (s : segment) (w : vector) :
  edges_meet_in_vertices r -> In s (region_edges r) -> lies_on w s -> ~ is_vertex w r ->
  exists radius, 0 < radius /\ forall y z, within radius w y -> within radius w z ->
    area s y < 0 -> area s z < 0 -> winding_number y (region_edges r) = winding_number z (region_edges r).
Proof.
  intros meet I on no_vertex.
  destruct (no_other_edge_near r s w meet I on no_vertex) as (earlier & later & radius & _ & R & near).
  exists radius. split; [exact R |]. intros y z y_near z_near y_right z_right.
  apply (winding_number_along (Segment y z) _ (region_cycles r)). intros v on_way.
  apply near; [now apply (within_along radius w y z) |]. pose proof (area_between s y z v y_right z_right on_way). lra.
Qed.

(* No vertex, of this or another chain, is between the ends of the edge. *)
Definition clear_edge (r : region) (s : segment) : Prop :=
  forall k w, 0 < k < 1 -> vx w == (1 - k) * vx (source s) + k * vx (target s) ->
    vy w == (1 - k) * vy (source s) + k * vy (target s) -> ~ is_vertex w r.

(* So what is said of pieces (beside_a_piece.v) is true of it. *)
Lemma clear_edge_is_met_only_along (r : region) (s : segment) :
  edges_meet_in_vertices r -> In s (region_edges r) -> clear_edge r s -> met_only_along (region_edges r) s.
Proof.
  intros meet I clear_ w t inside_ J on. destruct (in_split _ _ I) as (earlier & later & edges_are).
  rewrite edges_are in J. apply in_elt_inv in J.
  destruct J as [<- | J]; [split; unfold area, cross, minus; cbn [vx vy]; ring | exfalso].
  pose proof inside_ as (k & range & X & Y). apply (clear_ k w range X Y).
  exact (meet earlier s later t w edges_are J (strictly_inside_lies_on w s inside_) on).
Qed.

(* Up to the first edge to the right, the winding number is the same. *)
Lemma same_before_the_first_hit (x z : vector) (s : segment) (segments : list segment) :
  vy z = vy x -> vx x <= vx z -> vx z < vx (point_at_height s (vy x)) ->
  (forall t, In t segments -> signed_crossing x t <> 0%Z ->
     vx (point_at_height s (vy x)) <= vx (point_at_height t (vy x))) ->
  winding_number z segments = winding_number x segments.
Proof.
  intros height ahead_ before_ first_. unfold winding_number. f_equal. apply map_ext_in. intros t J.
  specialize (first_ t J). rewrite !signed_crossing_by_height. rewrite signed_crossing_by_height in first_.
  rewrite height. destruct (spans t (vy x)); [| reflexivity]. cbn [andb] in *.
  destruct (negative_spec (vx x - vx (point_at_height t (vy x)))) as [hit | miss],
    (negative_spec (vx z - vx (point_at_height t (vy x)))) as [hit_z | miss_z]; try reflexivity; exfalso.
  - assert (vx (point_at_height s (vy x)) <= vx (point_at_height t (vy x)))
      by (apply first_; destruct (at_most (vy (source t)) (vy x)); discriminate). lra.
  - lra.
Qed.

(* Theorem. Off the chains, every winding number is zero, or that to the right of the middle of some edge, or one more. *)
Theorem winding_number_by_middles (r : region) (x : vector) :
  no_edges_are_points r -> edges_meet_in_vertices r -> (forall s, In s (region_edges r) -> clear_edge r s) ->
  off x (region_edges r) ->
  winding_number x (region_edges r) = 0%Z \/
  exists s, In s (region_edges r) /\
    (winding_number x (region_edges r) = winding_number_shifted (right_of_middle s) (region_edges r) \/
     winding_number x (region_edges r) = (winding_number_shifted (right_of_middle s) (region_edges r) + 1)%Z).
Proof.
  intros not_points meet all_clear free.
  destruct (winding_number_near x _ (region_cycles r) free) as (radius & R & near).
  (* at a height at which there is no vertex *)
  destruct (some_small _ (eventually_and _ _ (leaves_all_heights (region_edges r) x)
    (small_steps_stay_within radius x (Vector 0 1) R))) as (height & _ & no_vertex & close).
  destruct (near _ close) as [_ <-]. set (x' := moved_along x (Vector 0 1) height) in *. clearbody x'.
  destruct (first_crossed x' (region_edges r)) as [none | (s & I & met & first_of_all)];
    [left; now apply sum_of_zeros |].
  destruct (crossed_ahead x' s met) as [spanning ahead_].
  pose proof (region_edges_are_directions r not_points s I) as long.
  set (w := point_at_height s (vy x')) in *.
  assert (on : lies_on w s) by now apply point_at_height_lies_on.
  assert (no_vertex_w : ~ is_vertex w r) by (intros (t & J & [_ wy]); exact (no_vertex t J wy)).
  assert (to_the_right : forall n, cross (along s) n < 0 -> eventually (fun e =>
    winding_number (moved_along w n e) (region_edges r) = winding_number_shifted (right_of_middle s) (region_edges r))).
  { intros n. apply to_the_right_of_a_piece; [apply region_cycles | now apply clear_edge_is_met_only_along, all_clear
      | exact long | now apply (inside_an_edge r)]. }
  assert (before_hit : eventually (fun e =>
    winding_number (moved_along w (Vector (-1) 0) e) (region_edges r) = winding_number x' (region_edges r))).
  { exists (vx w - vx x'). split; [lra |]. intros e e0 e1.
    rewrite (winding_number_of_equal _ (Vector (vx w - e) (vy x')))
      by (unfold moved_along, w, point_at_height; cbn [vx vy]; ring).
    apply (same_before_the_first_hit x' (Vector (vx w - e) (vy x')) s); trivial; cbn [vx]; fold w; lra. }
  right. exists s. split; [exact I |]. apply heights_of_spanning in spanning. destruct spanning as [up | down].
  - (* x is to the left of the edge *)
    assert (left_ : 0 < cross (along s) (Vector (-1) 0)) by (unfold cross, along, minus; cbn [vx vy]; lra).
    destruct (some_small _ (eventually_and _ _ before_hit (eventually_and _ _
      (to_the_right (Vector 1 0) ltac:(unfold cross in *; cbn [vx vy] in *; lra))
      (left_is_one_more r s w _ meet I on no_vertex_w left_)))) as (e & _ & <- & right_ & _ & _ & more).
    right. rewrite more, <- right_. f_equal. apply winding_number_of_equal; unfold moved_along; cbn [vx vy]; ring.
  - (* x is to the right of it *)
    destruct (some_small _ (eventually_and _ _ before_hit (to_the_right (Vector (-1) 0)
      ltac:(unfold cross, along, minus; cbn [vx vy]; lra)))) as (e & _ & <- & right_). now left.
Qed.

(* Theorem. If winding numbers to the right of the middles of edges are not negative, none is. *)
Theorem nowhere_negative_by_middles (r : region) :
  no_edges_are_points r -> edges_meet_in_vertices r -> (forall s, In s (region_edges r) -> clear_edge r s) ->
  (forall s, In s (region_edges r) ->
     (0 <= winding_number_shifted (right_of_middle s) (region_edges r))%Z) ->
  nowhere_negative r.
Proof.
  intros not_points meet all_clear middles x free.
  destruct (winding_number_by_middles r x not_points meet all_clear free) as [zero_ | (s & I & value)]; [lia |].
  specialize (middles s I). lia.
Qed.
