(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Lemma 2.2.5: if the sum of a point inside an edge of P and a point inside an edge of Q is on the boundary of the
   sum, the edges have the same direction. Both points are no vertices: where chains touch, the lemma is false
   for open regions (docs/findings.md). Edges that slide are from lemma_2_2_9.v. *)
From Coq Require Import QArith Qminmax Lqa ZArith Lia Bool List.
From Oplus Require Import regions_and_sums theorem_2_2_10 observation_2_2_4 lemma_2_2_9.
Import ListNotations.

Open Scope Q_scope.

Lemma inner_points_are_not_on_the_boundary (p q : region) (x : vector) :
  inner_point_of_sum x p q -> ~ on_boundary_of_sum x p q.
Proof.
  intros (radius & R & near) boundary. destruct (boundary radius R) as [_ (y & close & out)].
  now apply out, near.
Qed.

Lemma in_sum_other_way (x : vector) (p q : region) : in_sum x p q -> in_sum x q p.
Proof.
  intros (a & b & in_p & in_q & X & Y). exists b, a. split; [exact in_q |]. split; [exact in_p |].
  unfold plus in *; cbn [vx vy] in *. split; cbn [vx vy]; lra.
Qed.

(* From a point of an edge that is no vertex, there is a part of the edge in both directions. *)
Lemma segments_both_ways (r : region) (f : segment) (u : vector) :
  In f (region_edges r) -> lies_on u f -> ~ is_vertex u r ->
  has_segment r u (along f) /\ has_segment r u (opposite (along f)).
Proof.
  intros I on no_vertex. destruct (inside_an_edge r f u I on no_vertex) as (k & [first_part second_part] & X & Y).
  split.
  - exists (1 - k). split; [lra |]. intros t t0 t1. right. exists f. split; [exact I |]. exists (k + t).
    unfold moved_along, along, minus; cbn [vx vy]. split; [lra |]. rewrite X, Y. split; ring.
  - exists k. split; [lra |]. intros t t0 t1. right. exists f. split; [exact I |]. exists (k - t).
    unfold moved_along, opposite, along, minus; cbn [vx vy]. split; [lra |]. rewrite X, Y. split; ring.
Qed.

(* Edges of opposite directions, or of the same line: what is to the right of one is to the left of the other. *)
Lemma right_is_left_of_opposite (e f h : vector) :
  nonzero e -> cross e f == 0 -> dot e f <= 0 -> cross e h < 0 -> 0 <= cross f h.
Proof.
  intros some parallel back right_.
  pose proof (square_positive e some) as square.
  assert (value : dot e e * cross f h == dot e f * cross e h - cross e f * dot e h) by (unfold cross, dot; ring).
  rewrite parallel in value. destruct (Qlt_le_dec (cross f h) 0) as [negative_ |]; [exfalso | assumption].
  set (c := cross f h) in *. set (b := cross e h) in *. set (a := dot e f) in *. clearbody a b c. nra.
Qed.

(* Theorem, Lemma 2.2.5. *)
Theorem points_inside_edges (p q : region) (e f : segment) (w u : vector) :
  valid_region p -> valid_region q ->
  In e (region_edges p) -> lies_on w e -> ~ is_vertex w p ->
  In f (region_edges q) -> lies_on u f -> ~ is_vertex u q ->
  on_boundary_of_sum (plus w u) p q ->
  cross (along e) (along f) == 0 /\ 0 < dot (along e) (along f).
Proof.
  intros p_region q_region I on_e w_free J on_f u_free boundary.
  destruct (segments_both_ways q f u J on_f u_free) as [ahead back].
  destruct (Q_dec (cross (along e) (along f)) 0) as [[right_ | left_] | parallel].
  - exfalso. apply (inner_points_are_not_on_the_boundary p q (plus w u)); [| exact boundary].
    now apply (sliding p q e w u (along f)).
  - exfalso. apply (inner_points_are_not_on_the_boundary p q (plus w u)); [| exact boundary].
    apply (sliding p q e w u (opposite (along f))); trivial. unfold cross, opposite in *; cbn [vx vy]. lra.
  - split; [exact parallel |].
    destruct (Qlt_le_dec 0 (dot (along e) (along f))) as [| opposite_]; [assumption | exfalso].
    apply (inner_points_are_not_on_the_boundary p q (plus w u)); [| exact boundary].
    assert (u_in_q : in_region u q) by (right; now exists f).
    assert (w_in_p : in_region w p) by (right; now exists e).
    destruct (half_square_of_the_sum p q e w u p_region I on_e w_free u_in_q) as (r1 & R1 & left_of_e).
    destruct (half_square_of_the_sum q p f u w q_region J on_f u_free w_in_p) as (r2 & R2 & left_of_f).
    exists (Qmin r1 r2). split; [now apply Q.min_glb_lt |]. intros y close.
    pose proof (Q.le_min_l r1 r2). pose proof (Q.le_min_r r1 r2).
    destruct (Qlt_le_dec (cross (along e) (minus y (plus w u))) 0) as [right_ | left_].
    + apply in_sum_other_way, left_of_f.
      * unfold within, plus in *; cbn [vx vy] in *. lra.
      * destruct p_region as (p_edges & _). pose proof (region_edges_are_directions p p_edges e I) as long.
        pose proof (right_is_left_of_opposite _ _ _ long parallel opposite_ right_) as value.
        unfold cross, minus, plus in *; cbn [vx vy] in *. lra.
    + apply left_of_e; [| exact left_]. now apply (within_smaller (Qmin r1 r2)).
Qed.
