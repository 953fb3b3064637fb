(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Theorem 2.3.2, first part: the sum of an edge of P and a reflex vertex of Q is not on the boundary of the sum, but
   for the sums of vertices of P. No other chain of Q touches the vertex: without this the theorem is false
   (docs/findings.md). To the left of each edge of a reflex vertex all is inside (inside_a_corner.v). *)
From Coq Require Import ZArith Lia Bool List.
From Oplus Require Import numbers regions_and_sums first_edge_of_a_ray theorem_2_2_6 theorem_2_2_10 observation_2_2_4
  lemma_2_2_9 lemma_2_2_5 inside_a_corner lemma_2_2_2 boundary_points boundary_between reduced_convolution
  edges_at_a_point fan_at_a_point fans_that_touch edges_that_pass reduced_edges_that_pass.
Import ListNotations.

Open Scope Q_scope.

Lemma inner_point_equal (x y : vector) (p q : region) :
  equal_vectors x y -> inner_point_of_sum x p q -> inner_point_of_sum y p q.
Proof.
  intros [X Y] (radius & R & near). exists radius. split; [exact R |]. intros z close. apply near.
  unfold within in *. lra.
Qed.

(* Theorem 2.3.2, first part. One of the two edges of the vertex is not parallel to e, so from the vertex a step along e
   or back leads inside Q, and the opposite step stays on e. *)
Theorem edge_plus_reflex_vertex_is_inner (p q : region) (e f_in f_out : segment) (w : vector) :
  valid_region p -> valid_region q ->
  In e (region_edges p) -> lies_on w e -> ~ is_vertex w p ->
  meet_in_vertex f_in f_out q -> cross (along f_in) (along f_out) < 0 ->
  inner_point_of_sum (plus w (source f_out)) p q.
Proof.
  intros p_region q_region I on no_vertex vertex right_turn.
  pose proof (region_edges_are_directions p (proj1 p_region) e I) as long.
  destruct (passes_both_ways p w e I on no_vertex) as [departing_ arriving].
  assert (by_step : forall d v, fills_left (source f_out) d q -> cross d v < 0 ->
    eventually (fun t => lies_on (moved_along w v t) e) -> inner_point_of_sum (plus w (source f_out)) p q).
  { intros d v fills side on_e. apply inner_other_way.
    apply (inner_point_equal (plus (source f_out) w)); [unfold plus; split; cbn [vx vy]; ring |].
    apply (sliding q p (source f_out) w d v fills); [| exact side].
    refine (eventually_implied _ _ _ on_e). intros t on_t. right. now exists e. }
  assert (by_edge : forall d, fills_left (source f_out) d q -> ~ cross d (along e) == 0 ->
    inner_point_of_sum (plus w (source f_out)) p q).
  { intros d fills turn. destruct (Q_dec (cross d (along e)) 0) as [[right_ | left_] | flat]; [| | contradiction].
    - now apply (by_step d (along e) fills), goes_ahead_from.
    - apply (by_step d (opposite (along e)) fills); [| now apply comes_from_behind].
      unfold cross, opposite in *; cbn [vx vy]. lra. }
  destruct (fills_left_at_a_vertex q f_in f_out q_region vertex) as [fills_in fills_out]; [lra |].
  destruct (Qeq_dec (cross (along f_in) (along e)) 0) as [flat_in |]; [| now apply (by_edge (along f_in))].
  destruct (Qeq_dec (cross (along f_out) (along e)) 0) as [flat_out |]; [| now apply (by_edge (along f_out))].
  exfalso. destruct (multiple_of _ _ long flat_in) as (c & X & Y), (multiple_of _ _ long flat_out) as (c' & X' & Y').
  unfold cross in right_turn. rewrite X, Y, X', Y' in right_turn. lra.
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

(* Theorem 2.3.2, second part: the boundary of the sum is part of the reduced convolution (Definition 2.3.1), where
   chains touch, too. A boundary point of the sum is a sum, but not one with inner points of P and -Q + x in common, so
   this is reduced_edges_that_pass.v, but for sums of two vertices. Of these there are finitely many, and on a line that
   passes none of them is a boundary point near x (boundary_between.v). *)
Theorem boundary_is_part_of_the_reduced_convolution (p q : region) (x : vector) :
  valid_region p -> valid_region q -> on_boundary_of_sum x p q -> on_reduced_convolution x p q.
Proof.
  intros p_region q_region boundary.
  pose proof p_region as (p_edges & p_valid & p_meet). pose proof q_region as (q_edges & q_valid & q_meet).
  destruct (on_or_off x (reduced_convolution p q)) as [on | free]; [exact on | exfalso].
  pose proof (sum_is_closed p q x p_region q_region boundary) as in_x.
  destruct (off_near x (reduced_convolution p q) free) as (radius & R & near).
  (* a point outside the sum, one inside *)
  destruct (boundary radius R) as [_ (y & near_y & out)].
  assert (off_y : off y (convolution_segments p q)).
  { intros s I on. apply out, vertex_edge_sums_are_in_the_sum.
    now apply (convolution_is_part_of_the_vertex_edge_sum p q y s). }
  assert (zero_ : winding_number y (convolution_segments p q) = 0%Z).
  { pose proof (convolution_is_nowhere_negative p q y p_edges q_edges p_valid q_valid).
    destruct (Z_lt_le_dec 0 (winding_number y (convolution_segments p q))) as [some |]; [exfalso | lia].
    now apply out, positive_winding_number_is_in_the_sum. }
  assert (half : 0 < (1 # 2) * radius) by lra.
  destruct (interiors_meet_near p q x ((1 # 2) * radius)) as (z & near_z & meet); trivial;
    try now apply regions_are_regular.
  pose proof (interiors_meet_means_positive_winding_number p q z p_edges q_edges p_valid q_valid meet) as round.
  set (lines := map (fun pair => Segment y (plus (source (fst pair)) (source (snd pair))))
    (list_prod (region_edges p) (region_edges q))).
  destruct (point_beside z _ (convolution_segments p q) lines half)
    as (z' & near_z' & same_number & off_z & off_lines).
  { intros t I. apply in_map_iff in I. destruct I as ([e f] & <- & I). apply in_prod_iff in I. destruct I as [E F].
    intros [X Y]. apply out. unfold along, minus in X, Y; cbn [fst snd source target vx vy] in X, Y.
    apply (in_sum_of y (source e) (source f)); [right; exists e | right; exists f | split; lra];
      (split; [assumption | apply source_lies_on]). }
  pose proof (within_twice ((1 # 2) * radius) ((1 # 2) * radius) radius x z z' ltac:(lra) near_z near_z') as close_z.
  set (u := minus z' y).
  assert (at_start : equal_vectors y (moved_along y u 0)) by (split; unfold moved_along; cbn [vx vy]; ring).
  assert (at_end : equal_vectors z' (moved_along y u 1)) by (split; unfold moved_along, u, minus; cbn [vx vy]; ring).
  assert (aside : forall w v, is_vertex w p -> is_vertex v q -> ~ cross u (minus (plus w v) y) == 0).
  { intros w v (e & E & ex & ey) (f & F & fx & fy) flat.
    apply (off_lines (Segment y (plus (source e) (source f)))).
    - apply in_map_iff. exists (e, f). split; [reflexivity | now apply in_prod].
    - transitivity (- cross u (minus (plus w v) y)); [| lra].
      unfold area, u, cross, minus, plus; cbn [source target vx vy]. rewrite ex, ey, fx, fy. ring. }
  (* and a boundary point between them *)
  destruct (boundary_between p q y u p_region q_region) as (t & t0 & t1 & boundary_t).
  - intros s I. destruct (convolution_segment_is p q s I) as (a & b & i & j & A & B & I' & J & [-> | ->]); split;
      apply aside; apply vertex_by_index; trivial; now apply next_in_range.
  - now apply (off_equal y).
  - now rewrite <- (winding_number_of_equal y _ _ (proj1 at_start) (proj2 at_start)).
  - now apply (off_equal z').
  - rewrite <- (winding_number_of_equal z' _ _ (proj1 at_end) (proj2 at_end)). lia.
  - set (c := moved_along y u t) in *.
    assert (close_c : within radius x c).
    { apply (within_along radius x y z'); trivial. exists t. split; [lra |].
      unfold c, u, moved_along, minus; cbn [source target vx vy]. split; ring. }
    destruct (common_point_is_on_the_reduced_convolution p q c p_region q_region) as (s & S & on).
    + intros meet_c. apply (inner_points_are_not_on_the_boundary p q c); [| exact boundary_t].
      now apply interiors_meet_means_inner_point.
    + intros w v of_p of_q [X Y]. exfalso. apply (aside w v of_p of_q). transitivity (cross u (minus c y)).
      * unfold cross, minus; cbn [vx vy]. rewrite X, Y. reflexivity.
      * unfold c, moved_along, cross, minus; cbn [vx vy]. ring.
    + now apply sum_is_closed.
    + exact (near c close_c s S on).
Qed.
