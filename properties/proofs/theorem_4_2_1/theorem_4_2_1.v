(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Theorem 4.2.1: off the convolution, the winding number at x is positive if and only if P and -Q + x have a point
   in common. That a positive winding number means a common point is in winding_number_of_the_sum.v, that
   common inner points mean a positive winding number in interiors_meet.v. A common point that is not inside
   both has points inside near it (left_of_an_edge.v), and near x the winding number is the same
   (neighbourhoods.v). In general position the interiors meet, too. *)
From Coq Require Import ZArith Lia Bool List.
From Oplus Require Import numbers convolution signed_crossings small_numbers tie_rule convolution_winding weight
  regions parallelogram winding_number_of_the_sum crossing_edges interiors_meet neighbourhoods left_of_an_edge.
Import ListNotations.

Open Scope Q_scope.

(* No edge is a point, winding numbers are not negative, and edges meet in vertices only: all valid regions are
   like this (notation.md), chains that touch included. *)
Definition valid_region (r : region) : Prop :=
  no_edges_are_points r /\ nowhere_negative r /\ edges_meet_in_vertices r.

Lemma inside_equal (a b : vector) (r : region) : equal_vectors a b -> inside a r -> inside b r.
Proof.
  intros equal [free positive_]. split; [now apply (off_equal a b) |].
  destruct equal as [X Y]. now rewrite <- (winding_number_of_equal a b _ X Y).
Qed.

(* Points near a point of P and near a point of Q that are inside. *)
Lemma interiors_meet_near (p q : region) (x : vector) (radius : Q) :
  is_regular p -> is_regular q -> in_sum x p q -> 0 < radius ->
  exists y, within radius x y /\ interiors_meet y p q.
Proof.
  intros p_regular q_regular (a & b & in_p & in_q & X & Y) R.
  destruct (inside_near p a ((1 # 2) * radius) p_regular in_p) as (a' & near_a & inside_p); [lra |].
  destruct (inside_near q b ((1 # 2) * radius) q_regular in_q) as (b' & near_b & inside_q); [lra |].
  exists (plus a' b'). unfold plus, within in *. cbn [vx vy] in *. split; [lra |].
  exists a'. split; [exact inside_p |]. apply (inside_equal b'); [| exact inside_q].
  split; unfold minus; cbn [vx vy]; ring.
Qed.

(* Theorem. Off the convolution, P and -Q + x have a point in common, inside or on the boundary, if and only if the
   winding number is positive. *)
Theorem positive_winding_number_iff_common_point (p q : region) (x : vector) :
  valid_region p -> valid_region q -> off x (convolution_segments p q) ->
  ((0 < winding_number x (convolution_segments p q))%Z <-> in_sum x p q).
Proof.
  intros (p_edges & p_valid & p_meet) (q_edges & q_valid & q_meet) free. split.
  - now apply positive_winding_number_is_in_the_sum.
  - intros common.
    destruct (winding_number_near x _ (convolution_is_closed p q p_edges q_edges) free) as (radius & R & near).
    destruct (interiors_meet_near p q x radius) as (y & close & meet); trivial;
      try (now apply regions_are_regular).
    destruct (near y close) as [_ <-]. now apply interiors_meet_means_positive_winding_number.
Qed.

(* An inner point of Q, moved by a vertex of P, has inner points of both near it. *)
Lemma vertex_inside (p q : region) (x : vector) (v : vector * tangent_set.corner) :
  is_regular p -> off_vertex_edge_sum x p q -> In v (region_vertices p) ->
  (0 < winding_number (minus x (fst v)) (region_edges q))%Z ->
  exists z, inside z p /\ inside (minus x z) q.
Proof.
  intros p_regular general I positive_. destruct v as [v c]. cbn [fst] in *.
  assert (vertex : exists s, In s (region_edges p) /\ source s = v).
  { apply in_flat_map in I. destruct I as (chain & J & I). apply in_combine_l, edge_from_vertex in I.
    destruct I as (s & I & is_source). exists s. split; [apply in_flat_map; now exists chain | exact is_source]. }
  destruct vertex as (s & J & <-).
  assert (free : off (minus x (source s)) (region_edges q)) by (intros f F; now destruct (general s f J F)).
  destruct (winding_number_near _ _ (region_cycles q) free) as (radius & R & near).
  destruct (p_regular (source s) s radius J (meeting_of_segments.source_lies_on s) R) as (z & close & in_p).
  exists z. split; [exact in_p |].
  destruct (near (minus x z)) as [off_z same_number].
  - unfold within, minus in *. cbn [vx vy]. lra.
  - split; [exact off_z | lia].
Qed.

Lemma transversal_edges_meet (p q : region) (x w u : vector) (e f : segment) :
  valid_region p -> valid_region q -> In e (region_edges p) -> In f (region_edges q) -> lies_on w e -> lies_on u f ->
  ~ is_vertex w p -> ~ is_vertex u q -> equal_vectors x (plus w u) -> ~ cross (along e) (along f) == 0 ->
  interiors_meet x p q.
Proof.
  intros (p_edges & p_valid & p_meet) (q_edges & q_valid & q_meet) E F on_e on_f w_free u_free [X Y] turn.
  assert (found : forall n, 0 < cross (along e) n -> 0 < cross (along f) (opposite n) -> interiors_meet x p q).
  { intros n left_of_e left_of_f.
    destruct (some_small _ (eventually_and _ _
      (left_of_an_edge_is_inside p e w n p_valid p_meet E on_e w_free left_of_e)
      (left_of_an_edge_is_inside q f u (opposite n) q_valid q_meet F on_f u_free left_of_f))) as (d & _ & in_p & in_q).
    exists (moved_along w n d). split; [exact in_p |]. refine (inside_equal _ _ _ _ in_q).
    unfold plus, minus, moved_along, opposite in *. split; cbn [vx vy] in *; [rewrite X | rewrite Y]; ring. }
  set (E_ := along e) in *. set (F_ := along f) in *. unfold cross in *.
  destruct (Q_dec (vx E_ * vy F_ - vy E_ * vx F_) 0) as [[right_ | left_] | parallel]; [| | contradiction].
  - apply (found (Vector (- (vx E_ + vx F_)) (- (vy E_ + vy F_)))); unfold opposite; cbn [vx vy]; lra.
  - apply (found (Vector (vx E_ + vx F_) (vy E_ + vy F_))); unfold opposite; cbn [vx vy]; lra.
Qed.

(* Beside the point where two edges cross are inner points of both. *)
Lemma crossing_inside (p q : region) (x : vector) (e f : segment) :
  valid_region p -> valid_region q -> off_vertex_edge_sum x p q ->
  In e (region_edges p) -> In f (region_edges q) -> is_sum_of_points x e f -> interiors_meet x p q.
Proof.
  intros p_region q_region general E F is_sum.
  pose proof (crossing_edges_count x e f (region_edges_are_directions p (proj1 p_region) e E)
    (region_edges_are_directions q (proj1 q_region) f F) is_sum (general e f E F)) as turn.
  destruct is_sum as (w & u & on_e & on_f & X & Y).
  assert (w_free : ~ is_vertex w p).
  { intros (t & T & tx & ty). destruct (general t f T F) as (free & _). apply free.
    destruct on_f as (k & range & ux & uy). exists k. unfold plus, minus in *. cbn [vx vy] in *.
    split; [exact range |]. split; lra. }
  assert (u_free : ~ is_vertex u q).
  { intros (t & T & tx & ty). destruct (general e t E T) as (_ & _ & free & _). apply free.
    destruct on_e as (k & range & wx & wy). exists k. unfold plus, minus in *. cbn [vx vy] in *.
    split; [exact range |]. split; lra. }
  apply (transversal_edges_meet p q x w u e f); trivial; [now split | destruct turn as [[sign _] | [sign _]]; lra].
Qed.

(* Theorem. If x is on no sum of a vertex and an edge, the interiors of P and -Q + x meet if and only if the winding
   number is positive. *)
Theorem positive_winding_number_iff_interiors_meet (p q : region) (x : vector) :
  valid_region p -> valid_region q -> off_vertex_edge_sum x p q ->
  ((0 < winding_number x (convolution_segments p q))%Z <-> interiors_meet x p q).
Proof.
  intros p_region q_region general. pose proof p_region as (p_edges & p_valid & p_meet).
  pose proof q_region as (q_edges & q_valid & q_meet).
  split; [| now apply interiors_meet_means_positive_winding_number].
  assert (proper_d : nonzero (Vector 1 0)) by (unfold nonzero; cbn; lra).
  intros positive_.
  destruct (a_term_is_positive p q (Vector 1 0) x p_edges q_edges p_valid q_valid proper_d positive_)
    as [(v & I & _ & inside_q) | [(v & I & _ & inside_p) | (e & f & E & F & _ & _ & is_sum)]].
  - apply (vertex_inside p q x v); trivial. now apply regions_are_regular.
  - destruct (vertex_inside q p x v) as (z & in_q & in_p); trivial.
    + now apply regions_are_regular.
    + now apply off_vertex_edge_sum_other_way.
    + exists (minus x z). split; [exact in_p |]. refine (inside_equal _ _ _ _ in_q).
      split; unfold minus; cbn [vx vy]; ring.
  - now apply (crossing_inside p q x e f).
Qed.
