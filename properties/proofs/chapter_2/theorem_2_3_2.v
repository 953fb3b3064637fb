(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Theorem 2.3.2, first part: the sum of an edge of P and a reflex vertex of Q is not on the boundary of the sum, but
   for the sums of vertices of P. No other chain of Q touches the vertex: without this the theorem is false
   (docs/findings.md). Near a reflex vertex more than a half plane is inside (inside_a_corner.v), so an
   edge can slide to its right (lemma_2_2_9.v). *)
From Coq Require Import QArith Qminmax Lqa ZArith Lia Bool List.
From Oplus Require Import regions_and_sums theorem_2_2_10 observation_2_2_4 lemma_2_2_9 lemma_2_2_5 inside_a_corner
  lemma_2_2_2 boundary_points reduced_convolution interiors_at_touching_points.
Import ListNotations.

Open Scope Q_scope.

(* Inside a reflex vertex, opposite to the middle of its two edges. *)
Lemma inside_a_reflex_vertex (r : region) (f_in f_out : segment) :
  valid_region r -> meet_in_vertex f_in f_out r -> cross (along f_in) (along f_out) < 0 ->
  has_segment r (source f_out) (minus (along f_in) (along f_out)).
Proof.
  intros r_valid vertex right_turn. pose proof vertex as (_ & J & _).
  destruct (inside_a_corner r f_in f_out (minus (along f_in) (along f_out)) r_valid vertex) as (len & L & near).
  - right. split; [exact right_turn |]. left. unfold cross, minus in *; cbn [vx vy] in *. lra.
  - exists len. split; [exact L |]. intros t t0 t1. destruct (Qlt_le_dec 0 t) as [some | none].
    + now apply inside_is_in_region, near.
    + right. exists f_out. split; [exact J |]. assert (t_is : t == 0) by lra. exists 0.
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
    pose proof (square_positive _ long) as square.
    assert (value : dot (along e) (along e) * cross (along f_in) (along f_out) ==
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

(* Theorem 2.3.2, second part: the boundary of the sum is part of the reduced convolution (Definition 2.3.1), if no
   chains of P touch, and none of Q. Without this it is false (docs/findings.md). A boundary point of the sum is a sum,
   but not one with inner points of P and -Q + x in common, so interiors_at_touching_points.v applies. *)
Theorem boundary_is_part_of_the_reduced_convolution (p q : region) (x : vector) :
  valid_region p -> valid_region q -> chains_do_not_touch p -> chains_do_not_touch q ->
  on_boundary_of_sum x p q -> on_reduced_convolution x p q.
Proof.
  intros p_region q_region p_apart q_apart boundary.
  destruct (on_or_off x (reduced_convolution p q)) as [on | free]; [exact on | exfalso].
  apply (inner_points_are_not_on_the_boundary p q x); [| exact boundary].
  apply interiors_meet_means_inner_point.
  apply common_point_means_common_inner_point; trivial. now apply sum_is_closed.
Qed.
