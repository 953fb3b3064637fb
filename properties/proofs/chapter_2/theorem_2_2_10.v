(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Theorem 2.2.10: the boundary of the Minkowski sum is part of the convolution. From Theorem 4.2.1
   (theorem_4_2_1.v): off the convolution the winding number decides whether a point is in the sum, and it
   is the same for all points near (neighbourhoods.v). *)
From Coq Require Import ZArith Lia Bool List.
From Oplus Require Import numbers regions_and_sums.
Import ListNotations.

Open Scope Q_scope.

(* x is a boundary point of the sum: every neighbourhood has points of the sum and points that are not. *)
Definition on_boundary_of_sum (x : vector) (p q : region) : Prop :=
  forall radius, 0 < radius ->
    (exists y, within radius x y /\ in_sum y p q) /\ (exists y, within radius x y /\ ~ in_sum y p q).

(* All points near x are in the sum. *)
Definition inner_point_of_sum (x : vector) (p q : region) : Prop :=
  exists radius, 0 < radius /\ forall y, within radius x y -> in_sum y p q.

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

(* Theorem. Every point off the convolution that is in the sum is an inner point of it: all points near it are in the
   sum. And every point off both has no point of the sum near it. *)
Theorem off_the_convolution_all_near_are_alike (p q : region) (x : vector) :
  valid_region p -> valid_region q -> off x (convolution_segments p q) ->
  exists radius, 0 < radius /\ forall y, within radius x y -> (in_sum y p q <-> in_sum x p q).
Proof.
  intros p_region q_region free. pose proof p_region as (p_edges & _). pose proof q_region as (q_edges & _).
  destruct (winding_number_near x _ (convolution_is_closed p q p_edges q_edges) free) as (radius & R & near).
  exists radius. split; [exact R |]. intros y close. destruct (near y close) as [free_y same_number].
  rewrite <- (positive_winding_number_iff_common_point p q x p_region q_region free).
  rewrite <- (positive_winding_number_iff_common_point p q y p_region q_region free_y).
  now rewrite same_number.
Qed.

(* Theorem 2.2.10. The boundary of the sum is part of the convolution. *)
Theorem boundary_is_part_of_the_convolution (p q : region) (x : vector) :
  valid_region p -> valid_region q -> on_boundary_of_sum x p q ->
  exists s, In s (convolution_segments p q) /\ lies_on x s.
Proof.
  intros p_region q_region boundary.
  destruct (on_or_off x (convolution_segments p q)) as [on | free]; [exact on | exfalso].
  destruct (off_the_convolution_all_near_are_alike p q x p_region q_region free) as (radius & R & alike).
  destruct (boundary radius R) as [(y & near_y & in_) (z & near_z & out)].
  apply out, alike; [exact near_z |]. now apply (alike y).
Qed.
