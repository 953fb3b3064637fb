(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Where all that is near a point of an edge and to the left of the edge is inside: at points that are no vertices, and
   at a vertex that no other edge touches, if it is not convex. A half square to the left of the edge meets no edge
   there; beside the edge it is inside by left_of_an_edge.v, so all of it is. *)
From Coq Require Import ZArith Lia Bool List.
From Oplus Require Import numbers regions_and_sums edges_at_a_point.
Import ListNotations.

Open Scope Q_scope.

Lemma vertex_is_in_region (v : vector) (r : region) : is_vertex v r -> in_region v r.
Proof.
  intros (s & I & at_source). right. exists s. split; [exact I |].
  apply (lies_on_equal (source s)); [now symmetry | apply source_lies_on].
Qed.

(* f_in ends where f_out begins, and no other edge comes there. *)
Definition meet_in_vertex (f_in f_out : segment) (r : region) : Prop :=
  In f_in (region_edges r) /\ In f_out (region_edges r) /\ equal_vectors (target f_in) (source f_out) /\
  forall t, In t (region_edges r) -> lies_on (source f_out) t -> t = f_in \/ t = f_out.

(* Near w, all that is to the left of the direction d is inside. *)
Definition fills_left (w d : vector) (r : region) : Prop :=
  exists radius, 0 < radius /\ forall z, within radius w z -> 0 < cross d (minus z w) -> inside z r.

Lemma area_from (w z : vector) (s : segment) : lies_on w s -> area s z == cross (along s) (minus z w).
Proof. intros on. pose proof (on_the_line w s on). in_coordinates. by_equations. Qed.

Lemma fills_left_where_free (r : region) (s : segment) (w : vector) (radius : Q) :
  valid_region r -> In s (region_edges r) -> lies_on w s -> 0 < radius ->
  (forall z, within radius w z -> 0 < area s z -> off z (region_edges r)) -> fills_left w (along s) r.
Proof.
  intros (not_points & valid & meet) I on R free. exists radius. split; [exact R |]. intros z near_z left_z.
  rewrite <- (area_from w z s on) in left_z. pose proof (region_edges_are_directions r not_points s I) as long.
  destruct (no_vertex_near r s w ((1 # 2) * radius) long on) as (v & near_v & on_v & no_vertex); [lra |].
  pose proof (left_normal s long) as left_n. set (n := Vector (- vy (along s)) (vx (along s))) in *.
  destruct (some_small _ (eventually_and _ _ (left_of_an_edge_is_inside r s v n valid meet I on_v no_vertex left_n)
    (small_steps_stay_within ((1 # 2) * radius) v n ltac:(lra)))) as (e & some & [off_start round] & near_start).
  set (start := moved_along v n e) in *.
  assert (left_start : 0 < area s start).
  { setoid_replace (area s start) with (e * cross (along s) n + area s v) by (unfold start; by_coordinates).
    rewrite (on_the_line v s on_v). nra. }
  assert (free_way : forall y, lies_on y (Segment start z) -> off y (region_edges r)).
  { intros y on_way. apply free.
    - apply (within_along radius w start z); trivial.
      apply (within_twice ((1 # 2) * radius) ((1 # 2) * radius) radius w v); trivial; lra.
    - pose proof (area_between (reversed s) start z y) as left_y. rewrite !area_reversed in left_y.
      specialize (left_y ltac:(lra) ltac:(lra) on_way). lra. }
  split; [apply free_way, (target_lies_on (Segment start z)) |].
  pose proof (winding_number_along (Segment start z) _ (region_cycles r) free_way) as same_number.
  cbn [source target] in same_number. lia.
Qed.

Theorem fills_left_beside_an_edge (r : region) (s : segment) (w : vector) :
  valid_region r -> In s (region_edges r) -> lies_on w s -> ~ is_vertex w r -> fills_left w (along s) r.
Proof.
  intros r_valid I on no_vertex.
  destruct (no_other_edge_near r s w (proj2 (proj2 r_valid)) I on no_vertex)
    as (before & after & radius & _ & R & near).
  apply (fills_left_where_free r s w radius); trivial. intros z close left_. apply near; [exact close | lra].
Qed.

Theorem fills_left_at_a_vertex (r : region) (f_in f_out : segment) :
  valid_region r -> meet_in_vertex f_in f_out r -> cross (along f_in) (along f_out) <= 0 ->
  fills_left (source f_out) (along f_in) r /\ fills_left (source f_out) (along f_out) r.
Proof.
  intros r_valid (I & J & [tx ty] & alone) not_convex.
  destruct (some_square (source f_out) r) as (radius & R & near).
  assert (free : forall z, within radius (source f_out) z -> ~ lies_on z f_in -> ~ lies_on z f_out ->
    off z (region_edges r)).
  { intros z close off_in off_out t T. destruct (near t) as [on | away]; [| | now apply away].
    - apply in_flat_map. exists t. split; [exact T | now left].
    - destruct (alone t T on) as [-> | ->]; assumption. }
  assert (on_in : lies_on (source f_out) f_in)
    by (apply (lies_on_equal (target f_in)); [now split | apply target_lies_on]).
  pose proof (source_lies_on f_out) as on_out. split; apply (fills_left_where_free r _ _ radius); trivial;
    intros z close left_; apply free; trivial; try (apply off_by_area; lra); intros (k & [k0 k1] & X & Y).
  - assert (value : area f_in z == k * cross (along f_in) (along f_out)) by (in_coordinates; by_equations). nra.
  - assert (value : area f_out z == (1 - k) * cross (along f_in) (along f_out)) by (in_coordinates; by_equations). nra.
Qed.
