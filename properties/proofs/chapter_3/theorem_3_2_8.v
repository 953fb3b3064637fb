(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Theorem 3.2.8 of the thesis: segments of the reduced convolution of the direction of a dangling edge of the open sum
   cover it, and such of the opposite direction; all its points but the sums of two vertices, which are finitely many.
   The open sum is to the left of each edge that passes, so these are along the dangling
   edge; on either side there is one by segments_beside_the_open_sum.v. *)
From Coq Require Import ZArith Lia Bool List Arith.
From Oplus Require Import numbers regions_and_sums parallelogram crossing_edges observation_2_2_4 lemma_2_2_9
  inside_a_corner tangent_direction boundary_points reduced_convolution reduced_edges_that_pass
  segments_beside_the_open_sum.
Import ListNotations.

Open Scope Q_scope.

Lemma parallel_and_ahead (u v : vector) :
  nonzero v -> cross u v == 0 -> 0 < dot v u -> same_direction u v.
Proof.
  intros long parallel ahead_. destruct (multiple_of u v long parallel) as (c & X & Y). exists c. split; [| now split].
  pose proof (square_positive v long). unfold dot in *. rewrite X, Y in ahead_. apply Qnot_le_lt. intros none. nra.
Qed.

(* An edge that passes is along D. *)
Lemma passing_is_parallel (p q : region) (x D : vector) (e : segment) (w u : vector) :
  valid_region p -> valid_region q ->
  eventually (fun t => ~ interiors_meet (moved_along x D t) p q) ->
  eventually (fun t => ~ interiors_meet (moved_along x (opposite D) t) p q) ->
  In e (region_edges p) -> lies_on w e -> ~ is_vertex w p -> in_region u q -> equal_vectors x (plus w u) ->
  cross (along e) D == 0.
Proof.
  intros p_region q_region ahead_ behind I on no_vertex in_q [X Y]. pose proof p_region as (_ & valid & meet).
  pose proof q_region as (q_edges & q_valid & q_meet).
  pose proof (regions_are_regular q q_edges q_valid q_meet) as q_regular.
  assert (one : forall d, eventually (fun t => ~ interiors_meet (moved_along x d t) p q) ->
    0 < cross (along e) d -> False).
  { intros d free side.
    destruct (some_small _ (eventually_and _ _ free (left_of_an_edge_is_inside p e w d valid meet I on no_vertex side)))
      as (t & _ & out & in_p).
    apply out.
    refine (inner_point_and_point p q _ _ u q_regular in_p in_q _).
    unfold plus, moved_along in *; cbn [vx vy] in *. split; cbn [vx vy]; [rewrite X | rewrite Y]; ring. }
  destruct (Q_dec (cross (along e) D) 0) as [[right_ | left_e] | parallel]; [exfalso | exfalso | exact parallel].
  - apply (one (opposite D) behind). unfold cross, opposite in *; cbn [vx vy]. lra.
  - exact (one D ahead_ left_e).
Qed.

(* x is on a dangling edge of direction D: the line in both directions is not in the open sum, close to x, but what
   is close in a direction to its left and in one to its right. *)
Definition on_dangling_edge (x D : vector) (p q : region) : Prop :=
  ~ interiors_meet x p q /\
  eventually (fun t => ~ interiors_meet (moved_along x D t) p q) /\
  eventually (fun t => ~ interiors_meet (moved_along x (opposite D) t) p q) /\
  (exists n, 0 < cross D n /\ eventually (fun t => interiors_meet (moved_along x n t) p q)) /\
  (exists n, cross D n < 0 /\ eventually (fun t => interiors_meet (moved_along x n t) p q)).

Lemma direction_of_sides (D n : vector) : 0 < cross D n -> nonzero D.
Proof. intros left_ [X Y]. unfold cross in left_. rewrite X, Y in left_. lra. Qed.

(* Both directions by one: what has n to its left, and is along D, has the direction D. *)
Lemma one_side_of_a_dangling_edge (p q : region) (x D n : vector) :
  valid_region p -> valid_region q -> ~ interiors_meet x p q ->
  eventually (fun t => ~ interiors_meet (moved_along x D t) p q) ->
  eventually (fun t => ~ interiors_meet (moved_along x (opposite D) t) p q) ->
  0 < cross D n -> eventually (fun t => interiors_meet (moved_along x n t) p q) ->
  (forall w u, is_vertex w p -> is_vertex u q -> ~ equal_vectors x (plus w u)) ->
  reduced_along p q x D.
Proof.
  intros p_region q_region outside ahead_ behind left_ meet_ free.
  pose proof (direction_of_sides D n left_) as proper_D.
  pose proof (square_positive D proper_D) as square.
  assert (ahead_' : eventually (fun t => ~ interiors_meet (moved_along x D t) q p))
    by (refine (eventually_implied _ _ _ ahead_); intros t out meets; apply out; now apply interiors_meet_other_way).
  assert (behind' : eventually (fun t => ~ interiors_meet (moved_along x (opposite D) t) q p))
    by (refine (eventually_implied _ _ _ behind); intros t out meets; apply out; now apply interiors_meet_other_way).
  assert (not_along : forall e, nonzero (along e) -> cross (along e) D == 0 -> ~ cross (along e) n == 0).
  { intros e long parallel flat. apply long. assert (turn : ~ cross D n == 0) by lra.
    split; apply (Qmult_inj_l _ _ _ turn); in_coordinates; by_equations. }
  destruct (segments_beside_the_open_sum p q x n)
    as (d & found & left_d & (e & w & u & is_d & on & x_is & passes)); trivial.
  - intros e w u I on no_vertex in_q x_is. apply not_along.
    + now apply (region_edges_are_directions p (proj1 p_region)).
    + now apply (passing_is_parallel p q x D e w u).
  - intros e w u I on no_vertex in_q x_is. apply not_along.
    + now apply (region_edges_are_directions q (proj1 q_region)).
    + now apply (passing_is_parallel q p x D e w u).
  - refine (covered_in_the_same_direction _ x d D _ found).
    assert (parallel : cross d D == 0).
    { rewrite <- is_d. destruct passes as [(I & no_vertex & in_q) | (I & no_vertex & in_p)];
        [now apply (passing_is_parallel p q x D e w u) | now apply (passing_is_parallel q p x D e w u)]. }
    apply parallel_and_ahead; [exact proper_D | exact parallel |].
    destruct (Qlt_le_dec 0 (dot D d)) as [| none]; [assumption | exfalso].
    assert (value : dot D D * cross d n == dot D d * cross D n + cross d D * dot D n) by (unfold cross, dot; ring).
    rewrite parallel in value. nra.
Qed.

(* Theorem 3.2.8. Every point of a dangling edge that is not the sum of two vertices is on a segment of the reduced
   convolution of its direction, and on one of the opposite direction. *)
Theorem dangling_edges_are_on_opposite_segments (p q : region) (x D : vector) :
  valid_region p -> valid_region q -> on_dangling_edge x D p q ->
  (forall w u, is_vertex w p -> is_vertex u q -> ~ equal_vectors x (plus w u)) ->
  (exists s, In s (reduced_convolution p q) /\ lies_on x s /\ same_direction (along s) D) /\
  (exists s, In s (reduced_convolution p q) /\ lies_on x s /\ same_direction (along s) (opposite D)).
Proof.
  intros p_region q_region (outside & ahead_ & behind & (n & left_ & meet_n) &
    (m & right_ & meet_m)) free.
  assert (left_m : 0 < cross (opposite D) m) by (unfold cross, opposite in *; cbn [vx vy]; lra).
  assert (ahead_of_back : eventually (fun t => ~ interiors_meet (moved_along x (opposite (opposite D)) t) p q)).
  { refine (eventually_implied _ _ _ ahead_). intros t out (z & in_p & in_q). apply out. exists z.
    split; [exact in_p |]. refine (inside_equal _ _ _ _ in_q).
    unfold minus, moved_along, opposite; cbn [vx vy]. split; cbn [vx vy]; ring. }
  split.
  - now apply (one_side_of_a_dangling_edge p q x D n).
  - now apply (one_side_of_a_dangling_edge p q x (opposite D) m).
Qed.
