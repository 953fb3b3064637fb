(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Lemma 2.2.2 and Corollary 2.2.3: a boundary point of the sum is the sum of boundary points only, and is such a sum.
   Inner points of one region move with the point (neighbourhoods.v); that a boundary point is a sum at all is from
   Theorem 2.2.6 (theorem_2_2_6.v). *)
From Coq Require Import ZArith Lia Bool List.
From Oplus Require Import numbers regions_and_sums inside_a_corner theorem_2_2_10 theorem_2_2_6 observation_2_2_4.
Import ListNotations.

Open Scope Q_scope.

Definition on_boundary (w : vector) (r : region) : Prop := exists s, In s (region_edges r) /\ lies_on w s.

(* An inner point and a point add up to an inner point. *)
Lemma inner_plus_point (p q : region) (a b x : vector) :
  inside a p -> in_region b q -> equal_vectors x (plus a b) -> inner_point_of_sum x p q.
Proof.
  intros [free positive_] in_q [X Y].
  destruct (winding_number_near a _ (region_cycles p) free) as (radius & R & near).
  exists radius. split; [exact R |]. intros y close. unfold plus in X, Y; cbn [vx vy] in X, Y.
  destruct (near (minus y b)) as [_ same_number].
  - unfold within, minus in *; cbn [vx vy]. lra.
  - apply (in_sum_of y (minus y b) b); [left; lia | exact in_q |].
    unfold plus, minus. split; cbn [vx vy]; ring.
Qed.

Lemma inner_other_way (x : vector) (p q : region) : inner_point_of_sum x p q -> inner_point_of_sum x q p.
Proof.
  intros (radius & R & near). exists radius. split; [exact R |]. intros y close. now apply in_sum_other_way, near.
Qed.

Lemma interiors_meet_means_inner_point (p q : region) (x : vector) :
  interiors_meet x p q -> inner_point_of_sum x p q.
Proof.
  intros (z & in_p & in_q). apply (inner_plus_point p q z (minus x z) x in_p).
  - now apply inside_is_in_region.
  - unfold plus, minus. split; cbn [vx vy]; ring.
Qed.

Lemma inside_or_on_boundary (w : vector) (r : region) : in_region w r -> inside w r \/ on_boundary w r.
Proof.
  intros in_r. destruct (on_or_off w (region_edges r)) as [on | free]; [now right | left].
  split; [exact free |]. destruct in_r as [positive_ | (s & I & on)]; [exact positive_ | exfalso; exact (free s I on)].
Qed.

(* Theorem, Lemma 2.2.2. Wherever a boundary point of the sum is the sum of a point of P and a point of Q, both are on
   the boundaries of P and Q. The regions may be any sets of closed chains. *)
Theorem summands_of_boundary_points (p q : region) (x a b : vector) :
  on_boundary_of_sum x p q -> in_region a p -> in_region b q -> equal_vectors x (plus a b) ->
  on_boundary a p /\ on_boundary b q.
Proof.
  intros boundary in_p in_q equal. split.
  - destruct (inside_or_on_boundary a p in_p) as [inside_p | on]; [exfalso | exact on].
    apply (inner_points_are_not_on_the_boundary p q x); [| exact boundary].
    now apply (inner_plus_point p q a b).
  - destruct (inside_or_on_boundary b q in_q) as [inside_q | on]; [exfalso | exact on].
    apply (inner_points_are_not_on_the_boundary p q x); [| exact boundary].
    apply inner_other_way. apply (inner_plus_point q p b a); trivial.
    destruct equal as [X Y]. unfold plus in *; cbn [vx vy] in *. split; cbn [vx vy]; lra.
Qed.

(* Sums of a vertex and a point of an edge are in the sum. *)
Lemma vertex_edge_sums_are_in_the_sum (p q : region) (x : vector) : on_vertex_edge_sum x p q -> in_sum x p q.
Proof.
  intros [(v & f & vertex & I & on) | (v & e & vertex & I & on)].
  - apply (in_sum_of x v (minus x v)); [now apply vertex_is_in_region | right; now exists f |].
    unfold plus, minus. split; cbn [vx vy]; ring.
  - apply (in_sum_of x (minus x v) v); [right; now exists e | now apply vertex_is_in_region |].
    unfold plus, minus. split; cbn [vx vy]; ring.
Qed.

(* Theorem. The sum contains its boundary. *)
Theorem sum_is_closed (p q : region) (x : vector) :
  valid_region p -> valid_region q -> on_boundary_of_sum x p q -> in_sum x p q.
Proof.
  intros p_region q_region boundary. apply vertex_edge_sums_are_in_the_sum.
  now apply boundary_is_part_of_the_vertex_edge_sum.
Qed.

(* Theorem, Corollary 2.2.3. *)
Theorem boundary_points_are_sums_of_boundary_points (p q : region) (x : vector) :
  valid_region p -> valid_region q -> on_boundary_of_sum x p q ->
  exists a b, on_boundary a p /\ on_boundary b q /\ equal_vectors x (plus a b).
Proof.
  intros p_region q_region boundary.
  destruct (sum_is_closed p q x p_region q_region boundary) as (a & b & in_p & in_q & equal).
  destruct (summands_of_boundary_points p q x a b boundary in_p in_q equal) as [on_p on_q].
  exists a, b. tauto.
Qed.
