(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The theorem: what the checker (checker.v) accepts is the Minkowski sum, as specification.v says. Sums of points of
   pieces are in S (sums_are_inside.v), points of S are sums of points of pieces (cells_are_sums.v), and the pieces
   are the regions (pieces_cover.v). *)
From Coq Require Import NArith QArith Bool List FMapPositive.
From Oplus Require Import specification checker angular_crossings homogeneous_points specification_bridge fans
  sums_of_pieces cells_are_sums pieces_cover connected_pieces sums_are_inside edges_touch_at_most.
Import ListNotations.

(* What `check` has looked at where it refuses nothing. *)
Lemma accepted_means (p q s : polygonal_region) (c : certificate) : accepts p q s c = true ->
  let p_pieces := map piece_of (summand_pieces (of_p c)) in
  let q_pieces := map piece_of (summand_pieces (of_q c)) in
  are_a_region (hedges_of_region p) (summand_inserted (of_p c)) p_pieces = true /\
  are_a_region (hedges_of_region q) (summand_inserted (of_q c)) q_pieces = true /\
  are_a_region (hedges_of_region s) (sum_inserted c) (map (fun d => piece_of (fst d)) (sum_pieces c)) = true /\
  (forall d, In d (sum_pieces c) ->
    are_sums (numbers_from 1 p_pieces) (numbers_from 1 q_pieces) (fst d) (snd d) = true).
Proof.
  unfold accepts, check. cbv zeta. intros accepted.
  destruct (are_a_region (hedges_of_region p) _ _) eqn:p_region; cbn [negb] in accepted; [| discriminate].
  destruct (are_a_region (hedges_of_region q) _ _) eqn:q_region; cbn [negb] in accepted; [| discriminate].
  destruct (are_a_region (hedges_of_region s) _ _) eqn:s_region; cbn [negb] in accepted; [| discriminate].
  repeat split; trivial.
  repeat match type of accepted with
  | context [if negb ?test then _ else _] => destruct test; cbn [negb] in accepted; [| discriminate]
  end.
  match type of accepted with
  | context [first_failure ?beside 0%N (hedges_of_region s)] =>
    destruct (first_failure beside 0%N (hedges_of_region s)); [discriminate |]
  end.
  match type of accepted with
  | context [first_failure ?test 0%N (sum_pieces c)] =>
    destruct (first_failure test 0%N (sum_pieces c)) eqn:passed; [discriminate |]
  end.
  intros d D. exact (no_failure _ _ _ passed d D).
Qed.

(* Each piece of S is made of sums. *)
Lemma members_are_sums (p q s : polygonal_region) (c : certificate) : accepts p q s c = true ->
  forall x, member x s -> exists a b, member a p /\ member b q /\ equal_points x (sum_of_points a b).
Proof.
  intros accepted x in_s. destruct (accepted_means p q s c accepted) as (p_region & q_region & s_region & cells).
  pose proof (pieces_of_polygons_are_convex _ _ _ p_region) as p_convex. pose proof (pieces_of_polygons_are_convex _ _ _ q_region) as q_convex.
  destruct (region_is_in_pieces _ _ _ s_region x in_s) as (t & T & x_in).
  apply in_map_iff in T. destruct T as (d & <- & D).
  edestruct (cells_are_in_sums (numbers_from 1 (map piece_of (summand_pieces (of_p c))))
    (numbers_from 1 (map piece_of (summand_pieces (of_q c)))) (snd d))
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

Lemma sums_are_members (p q s : polygonal_region) (c : certificate) : accepts p q s c = true ->
  forall x a b, member a p -> member b q -> equal_points x (sum_of_points a b) -> member x s.
Proof.
  intros accepted x a b in_p in_q x_is. destruct (accepted_means p q s c accepted) as (p_region & q_region & _).
  destruct (region_is_in_pieces _ _ _ p_region a in_p) as (t & T & a_in).
  destruct (region_is_in_pieces _ _ _ q_region b in_q) as (u & U & b_in).
  exact (sums_of_pieces_are_members p q s c accepted t u (as_vector a) (as_vector b) x T U a_in b_in x_is).
Qed.

(* No edges cross or overlap. *)
Lemma accepted_edges (p q s : polygonal_region) (c : certificate) : accepts p q s c = true ->
  edges_touch_at_most p /\ edges_touch_at_most q /\ edges_touch_at_most s.
Proof.
  unfold accepts, check. cbv zeta. intros accepted.
  do 6 match type of accepted with
  | (match (if negb ?test then _ else _) with _ => _ end) = true =>
    destruct test; cbn [negb] in accepted; [| discriminate]
  end.
  do 2 (destruct (first_failure _ _ _); [discriminate |]).
  destruct (touch_at_most _ (hedges_of_region p)) eqn:p_touch; [| discriminate].
  destruct (touch_at_most _ (hedges_of_region q)) eqn:q_touch; [| discriminate].
  destruct (touch_at_most _ (hedges_of_region s)) eqn:s_touch; [| discriminate].
  repeat split; now apply (found_edges_touch_at_most (unit c)).
Qed.

(* If the checker accepts P, Q, S and a certificate, S is the Minkowski sum of P and Q, and their edges touch at most. *)
Theorem accepted_sums_are_sums : accepts_only_sums accepts.
Proof.
  intros p q s c accepted. split; [| now apply (accepted_edges p q s c)].
  intros x. split; [now apply (members_are_sums p q s c) |].
  intros (a & b & in_p & in_q & x_is). now apply (sums_are_members p q s c accepted x a b).
Qed.
