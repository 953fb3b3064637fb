(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Lemma 2.2.9, the sliding lemma, is false as printed. It says that the sum of an edge e of P and a vertex of Q is
   interior to the sum if the edge of Q that leaves the vertex, or the one that enters it reversed, leads to the right
   of e. With the regions of refuted_observation_2_2_4.v, both edges of Q's vertex (0, 0) lead to the right of P's
   lower side; and (3, 0) on that side, where the hole touches it, is no inner point of the sum: what slides from
   there does not sweep over (3, 0), and the hole is beside it. What holds is proved in lemma_2_2_9.v: for points of e
   that are no vertices of P. *)
From Coq Require Import QArith Qminmax Lqa List.
From Oplus Require Import convolution regions left_of_an_edge neighbourhoods theorem_4_2_1
  theorem_4_2_1_for_valid_regions theorem_2_2_10 valid_components lemma_2_2_9 drawn_regions touching_holes.
Import ListNotations.

Open Scope Q_scope.

(* w is a point inside the edge e of P; the edge f of Q leaves its source and enters its target. *)
Definition lemma_2_2_9_as_printed : Prop :=
  forall (p q : list component) (e f : segment) (w : vector),
    valid_components p -> valid_components q ->
    In e (region_edges (region_of p)) -> lies_on w e ->
    ~ equal_vectors w (source e) -> ~ equal_vectors w (target e) -> In f (region_edges (region_of q)) ->
    (cross (along e) (along f) < 0 -> inner_point_of_sum (plus w (source f)) (region_of p) (region_of q)) /\
    (cross (along e) (opposite (along f)) < 0 -> inner_point_of_sum (plus w (target f)) (region_of p) (region_of q)).

(* Theorem. *)
Theorem lemma_2_2_9_is_false_as_printed : ~ lemma_2_2_9_as_printed.
Proof.
  intros printed.
  destruct (printed square_with_lower_hole [Component narrow_triangle []] (Segment (Vector 0 0) (Vector 6 0))
    (Segment (Vector 0 0) (Vector (-1) (-2))) (Vector 3 0)) as [leaving _].
  - exact square_with_lower_hole_is_valid.
  - exact narrow_triangle_is_valid.
  - now left.
  - apply on_edge_by_computation. vm_compute. reflexivity.
  - intros [X _]. discriminate X.
  - intros [X _]. discriminate X.
  - now left.
  - destruct leaving as (radius & R & inner); [reflexivity |].
    pose proof (Q.min_glb_lt radius (1 # 2) 0 R ltac:(lra)). pose proof (Q.le_min_l radius (1 # 2)).
    pose proof (Q.le_min_r radius (1 # 2)).
    apply (above_the_corner ((1 # 2) * Qmin radius (1 # 2))); [lra |]. apply inner.
    unfold within, plus; cbn [source vx vy]. lra.
Qed.

(* Theorem, Lemma 2.2.9 as corrected, for all valid regions. *)
Theorem lemma_2_2_9_as_corrected (p q : region) (e f : segment) (w : vector) :
  valid_region p -> In e (region_edges p) -> lies_on w e -> ~ is_vertex w p -> In f (region_edges q) ->
  (cross (along e) (along f) < 0 -> inner_point_of_sum (plus w (source f)) p q) /\
  (cross (along e) (opposite (along f)) < 0 -> inner_point_of_sum (plus w (target f)) p q).
Proof. exact (sliding_lemma p q e f w). Qed.

(* Beside the hole, at (1, 0), it holds. *)
Example sliding_beside_the_hole :
  inner_point_of_sum (Vector 1 0) (region_of square_with_lower_hole) [narrow_triangle].
Proof.
  apply (lemma_2_2_9_as_corrected _ _ (Segment (Vector 0 0) (Vector 6 0)) (Segment (Vector 0 0) (Vector (-1) (-2)))
    (Vector 1 0)); [| now left | | | now left | reflexivity].
  - apply valid_components_are_valid_regions, square_with_lower_hole_is_valid.
  - apply on_edge_by_computation. vm_compute. reflexivity.
  - apply no_vertex_by_computation. vm_compute. reflexivity.
Qed.
