(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Observation 2.2.4: around the sum of a point inside an edge of P and any point of Q, a half square, to the left of
   the edge, is in the sum. The point inside the edge is no vertex of P: the observation is false where
   another chain touches the edge (docs/findings.md). What is left of an edge is from inside_a_corner.v. *)
From Coq Require Import ZArith Lia Bool List.
From Oplus Require Import numbers regions_and_sums inside_a_corner theorem_2_2_10.
Import ListNotations.

Open Scope Q_scope.

Lemma inside_is_in_region (z : vector) (r : region) : inside z r -> in_region z r.
Proof. intros [_ positive_]. now left. Qed.

Lemma in_sum_of (y a b : vector) (p q : region) :
  in_region a p -> in_region b q -> equal_vectors y (plus a b) -> in_sum y p q.
Proof. intros in_p in_q equal. now exists a, b. Qed.

(* A point of an edge that is not one of its ends is strictly between them. *)
Lemma strictly_between (r : region) (s : segment) (w : vector) :
  nonzero (along s) -> In s (region_edges r) -> lies_on w s -> ~ is_vertex w r ->
  dot (minus (source s) w) (minus (target s) w) < 0.
Proof.
  intros long I on no_vertex. destruct (inside_an_edge r s w I on no_vertex) as (k & range & X & Y).
  pose proof (square_positive _ long) as square. assert (0 < k * (1 - k)) by (apply Qmult_lt_0_compat; lra).
  setoid_replace (dot (minus (source s) w) (minus (target s) w)) with (- (k * (1 - k) * dot (along s) (along s)))
    by (in_coordinates; by_equations).
  nra.
Qed.

Lemma on_its_edge_near (s : segment) (w : vector) : dot (minus (source s) w) (minus (target s) w) < 0 ->
  exists radius, 0 < radius /\ forall z, within radius w z -> area s z == 0 -> lies_on z s.
Proof.
  intros between_. destruct s as [a b]. cbn [source target] in *.
  set (u := vx a + vx b - 2 * vx w). set (v := vy a + vy b - 2 * vy w).
  destruct (radius_for (- dot (minus a w) (minus b w)) (Qabs u + Qabs v + 2)) as (radius & R & small); [lra | |].
  { pose proof (abs_bounds u). pose proof (abs_bounds v). lra. }
  exists (Qmin 1 radius). split; [apply Q.min_glb_lt; lra |]. intros z near line.
  assert (near_1 : within 1 w z) by (refine (within_smaller _ _ _ _ _ near); apply Q.le_min_l).
  assert (near_2 : within radius w z) by (refine (within_smaller _ _ _ _ _ near); apply Q.le_min_r).
  apply lies_on_by_signs. cbn [source target]. split.
  - rewrite <- line. unfold area, cross, minus; cbn [source target vx vy]. ring.
  - assert (change : dot (minus a z) (minus b z) == dot (minus a w) (minus b w) -
      ((vx z - vx w) * u + (vy z - vy w) * v) +
      ((vx z - vx w) * (vx z - vx w) + (vy z - vy w) * (vy z - vy w)))
      by (unfold u, v, dot, minus; cbn [vx vy]; ring).
    rewrite change. destruct near_1 as [X1 Y1], near_2 as [X2 Y2].
    pose proof (product_bounds _ u _ X2). pose proof (product_bounds _ v _ Y2).
    assert (square_bound : forall h, - 1 < h < 1 -> - radius < h < radius -> h * h <= radius).
    { intros h range_1 range_2. destruct (Qlt_le_dec h 0); nra. }
    pose proof (square_bound _ X1 X2). pose proof (square_bound _ Y1 Y2). lra.
Qed.

(* Theorem, Observation 2.2.4. w is a point of the edge e of P and no vertex, u any point of Q. All points near w + u
   and to the left of the line of the edge e + u, or on it, are in the sum. *)
Theorem half_square_of_the_sum (p q : region) (e : segment) (w u : vector) :
  valid_region p -> In e (region_edges p) -> lies_on w e -> ~ is_vertex w p -> in_region u q ->
  exists radius, 0 < radius /\ forall y, within radius (plus w u) y ->
    0 <= cross (along e) (minus y (plus w u)) -> in_sum y p q.
Proof.
  intros p_region I on no_vertex in_q.
  pose proof (region_edges_are_directions p (proj1 p_region) e I) as long.
  destruct (fills_left_beside_an_edge p e w p_region I on no_vertex) as (r1 & R1 & fills).
  destruct (on_its_edge_near e w (strictly_between p e w long I on no_vertex)) as (r2 & R2 & on_the_edge).
  exists (Qmin r1 r2). split; [now apply Q.min_glb_lt |]. intros y close left_.
  pose proof (Q.le_min_l r1 r2). pose proof (Q.le_min_r r1 r2). set (z := minus y u).
  assert (value : cross (along e) (minus z w) == cross (along e) (minus y (plus w u)))
    by (unfold z, plus; by_coordinates).
  assert (near : within (Qmin r1 r2) w z) by (unfold z, within, plus, minus in *; cbn [vx vy] in *; lra).
  apply (in_sum_of y z u); [| exact in_q | split; unfold z, plus, minus; cbn [vx vy]; ring].
  destruct (Qlt_le_dec 0 (cross (along e) (minus z w))) as [inside_ | at_most_].
  - now apply inside_is_in_region, fills; [apply (within_smaller (Qmin r1 r2)) |].
  - right. exists e. split; [exact I |]. apply on_the_edge; [now apply (within_smaller (Qmin r1 r2)) |].
    rewrite (area_from w z e on). lra.
Qed.
