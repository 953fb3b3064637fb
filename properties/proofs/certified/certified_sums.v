(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The theorem: what the checker (checker.v) accepts is the Minkowski sum, as specification.v says. Sums of points of
   pieces are in S (sums_are_inside.v), points of S are sums of points of pieces (cells_are_sums.v), and the pieces
   are the regions (pieces_cover.v). *)
From Coq Require Import QArith Bool List FMapPositive.
From Oplus Require Import specification checker angular_crossings homogeneous_points specification_bridge fans
  sums_of_pieces cells_are_sums pieces_cover connected_pieces sums_are_inside edges_touch_at_most what_is_checked.
Import ListNotations.

Lemma members_are_sums (is_open : bool) (p q : polygonal_region) (s : open_region) (c : certificate) :
  is_checked is_open p q s c ->
  forall x, member x (open_chains s) -> exists a b, member a p /\ member b q /\ equal_points x (sum_of_points a b).
Proof.
  intros [p_region q_region s_region _ _ _ _ cells _ _ _ _ _] x in_s.
  pose proof (pieces_of_polygons_are_convex _ _ _ p_region) as p_convex.
  pose proof (pieces_of_polygons_are_convex _ _ _ q_region) as q_convex.
  destruct (region_is_in_pieces _ _ _ s_region x in_s) as (t & T & x_in).
  apply in_map_iff in T. destruct T as (d & <- & D).
  edestruct cells_are_in_sums
    as (i & j & t & u & t_is & u_is & a & b & a_in & b_in & x_is); [| | exact (cells d D) | exact x_in |].
  - intros i t t_is. apply numbers_are_from in t_is. now apply p_convex.
  - intros i t t_is. apply numbers_are_from in t_is. now apply q_convex.
  - apply numbers_are_from in t_is, u_is. destruct t_is as [_ T], u_is as [_ U].
    exists (as_point a), (as_point b). repeat split.
    + apply (pieces_are_in_region _ _ _ p_region (pieces_of_corners _) t); [exact T |]. now rewrite as_vector_of_point.
    + apply (pieces_are_in_region _ _ _ q_region (pieces_of_corners _) u); [exact U |]. now rewrite as_vector_of_point.
    + exact (proj1 x_is).
    + exact (proj2 x_is).
Qed.

(* No edges cross or overlap. *)
Lemma accepted_edges (is_open : bool) (p q : polygonal_region) (s : open_region) (c : certificate) :
  is_checked is_open p q s c ->
  edges_touch_at_most p /\ edges_touch_at_most q /\ edges_touch_at_most (open_chains s).
Proof. intros checked. repeat split; apply (found_edges_touch_at_most (unit c)), checked. Qed.

(* If the checker accepts P, Q, S and a certificate, S is the Minkowski sum of P and Q, and their edges touch at most. *)
Theorem accepted_sums_are_sums : accepts_only_sums accepts.
Proof.
  intros p q s c accepted. apply accepted_is_checked in accepted. split; [| exact (accepted_edges _ _ _ _ _ accepted)].
  intros x. split; [exact (members_are_sums _ _ _ _ _ accepted x) |]. intros (a & b & in_p & in_q & x_is).
  pose proof accepted as [p_region q_region _ _ _ _ _ _ _ _ _ _ _].
  destruct (region_is_in_pieces _ _ _ p_region a in_p) as (t & T & a_in).
  destruct (region_is_in_pieces _ _ _ q_region b in_q) as (u & U & b_in).
  exact (sums_of_pieces_are_members _ _ _ _ _ accepted t u (as_vector a) (as_vector b) x T U a_in b_in x_is).
Qed.
