(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Section 5.1, in general position: whether interiors meet is seen at the boundaries.
   They meet if and only if a vertex of one region is inside the other, or two edges cross. From the terms of the identity (winding_number_of_the_sum.v)
   and Theorem 4.2.1. *)
From Coq Require Import ZArith Lia Bool List.
From Oplus Require Import numbers regions_and_sums parallelogram.
Import ListNotations.

Open Scope Q_scope.

(* A vertex of the first region is inside the second, reflected and placed at x. *)
Definition a_vertex_is_inside (x : vector) (p q : region) : Prop :=
  exists v, In v (region_vertices p) /\ inside (minus x (fst v)) q.

(* An edge of P and an edge of -Q + x have a point in common; in general position they cross there. *)
Definition edges_cross (x : vector) (p q : region) : Prop :=
  exists e f, In e (region_edges p) /\ In f (region_edges q) /\ is_sum_of_points x e f.

Lemma vertex_off (x : vector) (p q : region) (v : vector * tangent_set.corner) :
  off_vertex_edge_sum x p q -> In v (region_vertices p) -> off (minus x (fst v)) (region_edges q).
Proof.
  intros general I. destruct v as [v c]. destruct (edges_of_vertex v c p I) as [_ (s & J & <- & _)].
  intros f F. now destruct (general s f J F).
Qed.

Theorem collision_in_general_position (p q : region) (x : vector) :
  valid_region p -> valid_region q -> off_vertex_edge_sum x p q ->
  (interiors_meet x p q <-> a_vertex_is_inside x p q \/ a_vertex_is_inside x q p \/ edges_cross x p q).
Proof.
  intros p_region q_region general. pose proof p_region as (p_edges & p_valid & p_meet).
  pose proof q_region as (q_edges & q_valid & q_meet). split.
  - intros meet_.
    pose proof (interiors_meet_means_positive_winding_number p q x p_edges q_edges p_valid q_valid meet_) as positive_.
    assert (proper_d : nonzero (Vector 1 0)) by (unfold nonzero; cbn; lra).
    destruct (a_term_is_positive p q (Vector 1 0) x p_edges q_edges p_valid q_valid proper_d positive_)
      as [(v & I & _ & in_q) | [(v & I & _ & in_p) | (e & f & E & F & _ & _ & is_sum)]].
    + left. exists v. split; [exact I |]. split; [now apply (vertex_off x p q) | exact in_q].
    + right. left. exists v. split; [exact I |]. split; [| exact in_p].
      apply (vertex_off x q p); [now apply off_vertex_edge_sum_other_way | exact I].
    + right. right. now exists e, f.
  - intros [(v & I & _ & in_q) | [(v & I & _ & in_p) | (e & f & E & F & is_sum)]].
    + apply (vertex_inside p q x v); trivial. now apply regions_are_regular.
    + destruct (vertex_inside q p x v) as (z & z_in_q & z_in_p); trivial.
      * now apply regions_are_regular.
      * now apply off_vertex_edge_sum_other_way.
      * exists (minus x z). split; [exact z_in_p |]. refine (inside_equal _ _ _ _ z_in_q).
        split; unfold minus; cbn [vx vy]; ring.
    + now apply (crossing_inside p q x e f).
Qed.
