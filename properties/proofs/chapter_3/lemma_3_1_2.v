(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Lemma 3.1.2, as far as directions go: the sum is to the left of each segment of the convolution, so where the
   complement of the sum is to the right of a boundary edge, all segments along it have the edge's direction, and a
   segment of the reduced convolution is there. Half squares in the sum are from observation_2_2_4.v, that the
   boundary is covered from theorem_2_3_2.v. *)
From Coq Require Import ZArith Lia Bool List.
From Oplus Require Import numbers regions_and_sums tracing simple_chain definition_2_2_8 theorem_2_2_10 theorem_2_2_6
  observation_2_2_4 lemma_2_2_5 lemma_2_2_2 inside_a_corner boundary_points reduced_convolution edges_at_a_point
  reduced_edges_that_pass theorem_2_3_2.
Import ListNotations.

Open Scope Q_scope.

(* x is the sum of a point inside an edge of direction d of one region, and any point of the other. *)
Definition edge_passes (x d : vector) (p q : region) : Prop :=
  exists e w u, In e (region_edges p) /\ lies_on w e /\ ~ is_vertex w p /\ in_region u q /\
    equal_vectors x (plus w u) /\ d = along e.

Definition passes (x d : vector) (p q : region) : Prop := edge_passes x d p q \/ edge_passes x d q p.

Lemma half_square_of_what_passes (x d : vector) (p q : region) :
  valid_region p -> valid_region q -> passes x d p q ->
  nonzero d /\ exists radius, 0 < radius /\ forall y, within radius x y -> 0 <= cross d (minus y x) -> in_sum y p q.
Proof.
  assert (one : forall p q, valid_region p -> edge_passes x d p q ->
    nonzero d /\ exists radius, 0 < radius /\ forall y, within radius x y -> 0 <= cross d (minus y x) -> in_sum y p q).
  { intros a b a_region (e & w & u & I & on & no_vertex & in_b & [X Y] & ->). split.
    - destruct a_region as (a_edges & _). now apply (winding_number_of_the_sum.region_edges_are_directions a).
    - destruct (half_square_of_the_sum a b e w u a_region I on no_vertex in_b) as (radius & R & near).
      exists radius. split; [exact R |]. intros y close left_. apply near.
      + unfold within, plus in *; cbn [vx vy] in *. lra.
      + unfold cross, minus, plus in *; cbn [vx vy] in *. rewrite X, Y in left_. exact left_. }
  intros p_region q_region [of_p | of_q]; [now apply one |].
  destruct (one q p q_region of_q) as (long & radius & R & near). split; [exact long |].
  exists radius. split; [exact R |]. intros y close left_. now apply in_sum_other_way, near.
Qed.

(* Near x, no point to the right of the direction D is in the sum. *)
Definition complement_to_the_right (x D : vector) (p q : region) : Prop :=
  exists radius, 0 < radius /\ forall y, within radius x y -> cross D (minus y x) < 0 -> ~ in_sum y p q.

(* Theorem. What passes along the boundary has its direction. *)
Theorem boundary_edges_have_the_direction_of_segments (p q : region) (x d D : vector) :
  valid_region p -> valid_region q -> nonzero D -> complement_to_the_right x D p q -> passes x d p q ->
  cross D d == 0 /\ 0 < dot D d.
Proof.
  intros p_region q_region long_D (r1 & R1 & outside) passing.
  destruct (half_square_of_what_passes x d p q p_region q_region passing) as (long_d & r2 & R2 & half_square).
  assert (impossible : forall h, 0 <= cross d h -> cross D h < 0 -> False).
  { intros h left_ right_.
    destruct (some_small _ (eventually_and _ _ (small_steps_stay_within r1 x h R1) (small_steps_stay_within r2 x h R2)))
      as (e & some & near_1 & near_2).
    assert (scaled : forall a, cross a (minus (moved_along x h e) x) == e * cross a h)
      by (intros a; unfold cross, minus, moved_along; cbn [vx vy]; ring).
    apply (outside _ near_1).
    - rewrite scaled. assert (0 < e * - cross D h) by (apply Qmult_lt_0_compat; lra). lra.
    - apply half_square; [exact near_2 |]. rewrite scaled. apply Qmult_le_0_compat; lra. }
  destruct (Q_dec (cross D d) 0) as [[right_ | left_] | parallel].
  - exfalso. apply (impossible d); [unfold cross; lra | exact right_].
  - exfalso. apply (impossible (opposite d)); unfold cross, opposite in *; cbn [vx vy]; lra.
  - split; [exact parallel |]. destruct (Qlt_le_dec 0 (dot D d)) as [| back]; [assumption | exfalso].
    pose proof (square_positive D long_D) as square.
    apply (impossible (Vector (vy D) (- vx D))); unfold cross, dot in *; cbn [vx vy]; lra.
Qed.

(* A point strictly between the ends of an edge is no vertex. *)
Lemma between_is_no_vertex (r : region) (chain : list vector) i k :
  no_edges_are_points r -> chains_do_not_touch r -> In chain r -> (i < length chain)%nat -> 0 < k < 1 ->
  ~ is_vertex (point_along chain i k) r.
Proof.
  intros not_points apart_ C I range (s & S & at_source).
  destruct (edge_by_chain r s S) as (c & m & c_in & m_below & ->).
  destruct (apart_ c m c_in m_below) as (_ & _ & at_target & only).
  assert (long : nonzero (edge_of_chain chain i)) by (apply edge_nonzero; auto).
  assert (range' : 0 <= k <= 1) by lra. destruct (before_the_end chain i k long I range') as [goes_on comes].
  specialize (goes_on (proj2 range)). specialize (comes (proj1 range)). apply departs_is in goes_on.
  apply arrives_is in comes.
  destruct (only (edge_at chain i)) as [is_in | is_out].
  - now apply edge_at_in_region.
  - exact (lies_on_equal _ _ _ at_source (proj1 comes)).
  - apply goes_on. rewrite is_in, at_source. now symmetry.
  - apply comes. now rewrite is_out.
Qed.

(* Between its ends, a segment of the convolution passes. *)
Lemma edges_pass (p q : region) (x : vector) (a b : list vector) i j k :
  no_edges_are_points p -> chains_do_not_touch p -> In a p -> In b q -> (i < length a)%nat -> (j < length b)%nat ->
  0 < k < 1 -> equal_vectors x (plus (point_along a i k) (vertex b j)) -> edge_passes x (along (edge_at a i)) p q.
Proof.
  intros p_edges p_apart A B I J range x_is.
  exists (edge_at a i), (point_along a i k), (vertex b j). split; [now apply edge_at_in_region |].
  split; [apply point_along_is_on; trivial; lra |]. split; [now apply between_is_no_vertex |].
  split; [| split; [exact x_is | reflexivity]]. right. exists (edge_at b j). split; [now apply edge_at_in_region |].
  rewrite edge_at_is by exact J. apply (source_lies_on (Segment _ _)).
Qed.

Lemma segments_pass (p q : region) (x : vector) (s : segment) (k : Q) :
  valid_region p -> valid_region q -> chains_do_not_touch p -> chains_do_not_touch q ->
  In s (convolution_segments p q) -> 0 < k < 1 ->
  equal_vectors x (Vector ((1 - k) * vx (source s) + k * vx (target s))
                          ((1 - k) * vy (source s) + k * vy (target s))) ->
  exists d, passes x d p q /\ equal_vectors d (along s).
Proof.
  intros (p_edges & _) (q_edges & _) p_apart q_apart S range x_is.
  destruct (convolution_segment_is p q s S) as (a & b & i & j & A & B & I & J & [-> | ->]).
  - exists (along (edge_at a i)). split; [left; apply (edges_pass p q x a b i j k); trivial |].
    + rewrite x_is. unfold point_along. rewrite edge_of_chain_is by exact I. unfold vertex, plus, minus.
      cbn [source target vx vy]. split; cbn [vx vy]; ring.
    + rewrite edge_at_is by exact I. unfold along, plus, minus. cbn [source target vx vy]. split; cbn [vx vy]; ring.
  - exists (along (edge_at b j)). split; [right; apply (edges_pass q p x b a j i k); trivial |].
    + rewrite x_is. unfold point_along. rewrite edge_of_chain_is by exact J. unfold vertex, plus, minus.
      cbn [source target vx vy]. split; cbn [vx vy]; ring.
    + rewrite edge_at_is by exact J. unfold along, plus, minus. cbn [source target vx vy]. split; cbn [vx vy]; ring.
Qed.

(* Theorem, Lemma 3.1.2. Let the complement of the sum be to the right of a boundary edge of direction D at its point x.
   Then a segment of the reduced convolution covers x, and every segment of the convolution with x between its
   ends has the direction D. *)
Theorem boundary_edges_are_covered_in_their_direction (p q : region) (x D : vector) :
  valid_region p -> valid_region q -> chains_do_not_touch p -> chains_do_not_touch q ->
  on_boundary_of_sum x p q -> nonzero D -> complement_to_the_right x D p q ->
  on_reduced_convolution x p q /\
  (forall s k, In s (convolution_segments p q) -> 0 < k < 1 ->
     equal_vectors x (Vector ((1 - k) * vx (source s) + k * vx (target s))
                             ((1 - k) * vy (source s) + k * vy (target s))) ->
     cross D (along s) == 0 /\ 0 < dot D (along s)).
Proof.
  intros p_region q_region p_apart q_apart boundary long right_. split.
  - now apply boundary_is_part_of_the_reduced_convolution.
  - intros s k I range x_is.
    destruct (segments_pass p q x s k p_region q_region p_apart q_apart I range x_is) as (d & passing & [d_x d_y]).
    destruct (boundary_edges_have_the_direction_of_segments p q x d D p_region q_region long right_ passing)
      as [parallel ahead_].
    unfold cross, dot in *. rewrite <- d_x, <- d_y. split; assumption.
Qed.
