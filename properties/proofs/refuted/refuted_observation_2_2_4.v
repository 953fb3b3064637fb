(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Observation 2.2.4 is false as printed. It says that around the sum of a point inside an edge of P and any point of
   Q, a half disk, to the left of the edge, is in the sum. Where a hole of P touches the edge in that point, P itself
   does not fill a half disk there: P is a square whose hole touches its lower side in (3, 0), Q a triangle that fits,
   reflected, into the hole's corner; no point directly above (3, 0) is in the sum. What holds is proved in
   observation_2_2_4.v: the point inside the edge is no vertex of P, not of another chain either. Half squares instead
   of half disks say the same. *)
From Coq Require Import QArith Qminmax Lqa List.
From Oplus Require Import convolution regions left_of_an_edge neighbourhoods theorem_4_2_1
  theorem_4_2_1_for_valid_regions valid_components observation_2_2_4 drawn_regions touching_holes.
Import ListNotations.

Open Scope Q_scope.

(* w is a point inside the edge e, u is a point of Q. *)
Definition observation_2_2_4_as_printed : Prop :=
  forall (p q : list component) (e : segment) (w u : vector),
    valid_components p -> valid_components q ->
    In e (region_edges (region_of p)) -> lies_on w e ->
    ~ equal_vectors w (source e) -> ~ equal_vectors w (target e) -> in_region u (region_of q) ->
    exists radius, 0 < radius /\ forall y, within radius (plus w u) y ->
      0 < cross (along e) (minus y (plus w u)) -> in_sum y (region_of p) (region_of q).

(* Theorem. *)
Theorem observation_2_2_4_is_false_as_printed : ~ observation_2_2_4_as_printed.
Proof.
  intros printed.
  destruct (printed square_with_lower_hole [Component narrow_triangle []] (Segment (Vector 0 0) (Vector 6 0))
    (Vector 3 0) (Vector 0 0)) as (radius & R & half_disk).
  - exact square_with_lower_hole_is_valid.
  - exact narrow_triangle_is_valid.
  - now left.
  - apply on_edge_by_computation. vm_compute. reflexivity.
  - intros [X _]. discriminate X.
  - intros [X _]. discriminate X.
  - right. exists (Segment (Vector 0 0) (Vector (-1) (-2))). split; [now left |].
    apply on_edge_by_computation. vm_compute. reflexivity.
  - pose proof (Q.min_glb_lt radius (1 # 2) 0 R ltac:(lra)). pose proof (Q.le_min_l radius (1 # 2)).
    pose proof (Q.le_min_r radius (1 # 2)).
    apply (above_the_corner ((1 # 2) * Qmin radius (1 # 2))); [lra |]. apply half_disk.
    + unfold within, plus; cbn [vx vy]. lra.
    + unfold cross, along, minus, plus; cbn [source target vx vy]. lra.
Qed.

(* Theorem, Observation 2.2.4 as corrected, for all valid regions. *)
Theorem observation_2_2_4_as_corrected (p q : region) (e : segment) (w u : vector) :
  valid_region p -> In e (region_edges p) -> lies_on w e -> ~ is_vertex w p -> in_region u q ->
  exists radius, 0 < radius /\ forall y, within radius (plus w u) y ->
    0 <= cross (along e) (minus y (plus w u)) -> in_sum y p q.
Proof. exact (half_square_of_the_sum p q e w u). Qed.

(* Beside the hole, at (1, 0), it holds. *)
Example beside_the_hole : exists radius, 0 < radius /\ forall y, within radius (Vector 1 0) y ->
  0 <= cross (Vector 6 0) (minus y (Vector 1 0)) -> in_sum y (region_of square_with_lower_hole) [narrow_triangle].
Proof.
  apply (observation_2_2_4_as_corrected _ _ (Segment (Vector 0 0) (Vector 6 0)) (Vector 1 0) (Vector 0 0)).
  - apply valid_components_are_valid_regions, square_with_lower_hole_is_valid.
  - now left.
  - apply on_edge_by_computation. vm_compute. reflexivity.
  - apply no_vertex_by_computation. vm_compute. reflexivity.
  - right. exists (Segment (Vector 0 0) (Vector (-1) (-2))). split; [now left |].
    apply on_edge_by_computation. vm_compute. reflexivity.
Qed.
