(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Lemma 3.1.2, as far as directions go: the sum is to the left of each segment of the convolution, so where the
   complement of the sum is to the right of a boundary edge, all segments along it have the edge's direction, and a
   segment of the reduced convolution is there. Half squares in the sum are from observation_2_2_4.v, that the
   boundary is covered from theorem_2_3_2.v. *)
From Coq Require Import ZArith Lia Bool List.
From Oplus Require Import numbers regions_and_sums tracing theorem_2_2_10 theorem_2_2_6 observation_2_2_4 lemma_2_2_5
  lemma_2_2_2 inside_a_corner boundary_points reduced_convolution parallel_edges interiors_at_touching_points
  theorem_2_3_2.
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

(* Between its ends, a segment of the convolution passes. *)
Lemma segments_pass (p q : region) (x : vector) (s : segment) (k : Q) :
  valid_region p -> valid_region q -> chains_do_not_touch p -> chains_do_not_touch q ->
  In s (convolution_segments p q) -> 0 < k < 1 ->
  equal_vectors x (Vector ((1 - k) * vx (source s) + k * vx (target s))
                          ((1 - k) * vy (source s) + k * vy (target s))) ->
  exists d, passes x d p q /\ equal_vectors d (along s).
Proof.
  intros p_region q_region p_apart q_apart I range [X Y].
  destruct (convolution_segment_is p q s I) as (a & b & i & j & in_p & in_q & i_below & j_below & s_is).
  assert (vertex_in : forall chain r m, In chain r -> (m < length chain)%nat -> in_region (nth m chain nowhere) r).
  { intros chain r m chain_in below. right. exists (edge_at chain m). split; [now apply edge_at_in_region |].
    exists 0. rewrite edge_at_is by exact below. cbn [source target]. split; [lra |]. split; ring. }
  assert (edge_point : forall chain r m, valid_region r -> chains_do_not_touch r -> In chain r ->
    (m < length chain)%nat ->
    let w := Vector ((1 - k) * vx (source (edge_at chain m)) + k * vx (target (edge_at chain m)))
                    ((1 - k) * vy (source (edge_at chain m)) + k * vy (target (edge_at chain m))) in
    In (edge_at chain m) (region_edges r) /\ lies_on w (edge_at chain m) /\ ~ is_vertex w r).
  { intros chain r m r_region r_apart chain_in below w. split; [now apply edge_at_in_region |]. split.
    - exists k. unfold w; cbn [vx vy]. split; [lra |]. split; reflexivity.
    - apply (between_is_no_vertex r chain m k w); trivial; reflexivity. }
  destruct s_is as [-> | ->]; unfold plus in *; cbn [source target vx vy] in *.
  - destruct (edge_point a p i p_region p_apart in_p i_below) as (E & on & no_vertex). cbv zeta in on, no_vertex.
    exists (along (edge_at a i)). split.
    + left. eexists (edge_at a i), _, (nth j b nowhere). split; [exact E |]. split; [exact on |].
      split; [exact no_vertex |]. split; [now apply vertex_in |]. split; [| reflexivity].
      rewrite edge_at_is by exact i_below. cbn [source target]. unfold plus. split; cbn [vx vy];
        [rewrite X | rewrite Y]; ring.
    + rewrite edge_at_is by exact i_below. unfold along, minus; cbn [source target vx vy]. split; cbn [vx vy]; ring.
  - destruct (edge_point b q j q_region q_apart in_q j_below) as (F & on & no_vertex). cbv zeta in on, no_vertex.
    exists (along (edge_at b j)). split.
    + right. eexists (edge_at b j), _, (nth i a nowhere). split; [exact F |]. split; [exact on |].
      split; [exact no_vertex |]. split; [now apply vertex_in |]. split; [| reflexivity].
      rewrite edge_at_is by exact j_below. cbn [source target]. unfold plus. split; cbn [vx vy];
        [rewrite X | rewrite Y]; ring.
    + rewrite edge_at_is by exact j_below. unfold along, minus; cbn [source target vx vy]. split; cbn [vx vy]; ring.
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
