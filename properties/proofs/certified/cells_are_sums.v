(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Where the checker (checker.v) accepts the cells of a polygon, each point of the polygon is the sum of points of two
   pieces. Cutting a polygon by a line leaves each point on one side (clipped_polygons.v), and polygons that are not cut
   again are in the sum of two pieces if their corners are (sums_of_pieces.v). *)
From Coq Require Import QArith Lqa ZArith Lia Bool List FMapPositive.
From Oplus Require Import winding specification checker homogeneous_points fans sums_of_pieces clipped_polygons.
Import ListNotations.

Open Scope Q_scope.

Definition are_all_convex (pieces : numbered) : Prop :=
  forall i t, PositiveMap.find i pieces = Some t -> is_convex t = true.

Lemma value_at_opposite_line (l : line) (x : vector) : value_at (opposite_line l) x == - value_at l x.
Proof. unfold value_at, opposite_line. cbn [la lb lc]. rewrite !inject_Z_opp. ring. Qed.

Theorem cells_are_in_sums (is_seam : line -> polygon -> option seam -> bool) (p q : numbered) (c : cells) :
  are_all_convex p -> are_all_convex q ->
  forall (v : polygon) (x : vector), are_sums is_seam p q v c = true -> inside_piece (piece_of v) x ->
  exists i j t u, PositiveMap.find i p = Some t /\ PositiveMap.find j q = Some u /\ is_in_sum t u x.
Proof.
  intros p_convex q_convex. induction c as [i j | l along one IH_one other IH_other]; intros v x; cbn [are_sums].
  - destruct (PositiveMap.find i p) as [t |] eqn:t_is; [| easy].
    destruct (PositiveMap.find j q) as [u |] eqn:u_is; [| easy].
    rewrite andb_true_iff. intros [fan sums] x_in. exists i, j, t, u. repeat split; trivial.
    exact (polygon_is_in_sum t u _ v x (p_convex i t t_is) (q_convex j u u_is) fan sums x_in).
  - rewrite !andb_true_iff. intros ((((ahead & ahead_opposite) & _) & sums_one) & sums_other) x_in.
    destruct (Qlt_le_dec (value_at l x) 0) as [right_ | left_].
    + apply (IH_other _ x sums_other), clipped_has_what_is_left; trivial. rewrite value_at_opposite_line. lra.
    + apply (IH_one _ x sums_one), clipped_has_what_is_left; trivial.
Qed.
