(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Theorem 2.3.2 is false as printed, for polygons whose chains touch. It says that the sum of an edge e of P and a
   reflex vertex of Q is not on the boundary of the sum. Q is a triangle with a hole that touches its right side in
   the vertex (4, 3), which is reflex, P a triangle with a vertical side at its right: their sum is part of the right
   side of the sum, (6, 7/2) is one of its points. The proof in the thesis looks at the edges that encompass e, at
   points where chains touch; there these are the outer chain's, not the hole's. What holds is proved in
   theorem_2_3_2.v: no other chain touches the vertex. What the title says, that the reduced convolution covers the
   boundary, is true where chains touch, too. *)
From Coq Require Import QArith Lqa List.
From Oplus Require Import convolution regions left_of_an_edge theorem_4_2_1 theorem_2_2_10 valid_components
  inside_a_corner boundary_points reduced_convolution theorem_2_3_2 small_polygons polygons_of_the_thesis
  drawn_regions drawn_sums touching_holes.
Import ListNotations.

Open Scope Q_scope.

(* Not all of the sum of the edge e of P and the reflex vertex i of a chain of Q is on the boundary. *)
Definition theorem_2_3_2_as_printed : Prop :=
  forall (p q : list component) (e : segment) (chain : list vector) (i : nat),
    valid_components p -> valid_components q -> In e (region_edges (region_of p)) ->
    In chain (region_of q) -> (i < length chain)%nat -> is_reflex (corner_of_chain chain i) = true ->
    ~ (forall w, lies_on w e -> on_boundary_of_sum (plus w (nth i chain nowhere)) (region_of p) (region_of q)).

(* Theorem. *)
Theorem theorem_2_3_2_is_false_as_printed : ~ theorem_2_3_2_as_printed.
Proof.
  intros printed.
  apply (printed [Component small_triangle []] triangle_with_inscribed_hole (Segment (Vector 2 0) (Vector 2 1))
    inscribed_hole 0%nat).
  - exact small_triangle_is_valid.
  - exact triangle_with_inscribed_hole_is_valid.
  - vm_compute. tauto.
  - vm_compute. tauto.
  - vm_compute. repeat constructor.
  - vm_compute. reflexivity.
  - intros [a b] (t & range & X & Y). cbn [source target vx vy] in *.
    apply right_side_is_on_the_boundary; cbn; lra.
Qed.

(* Theorem 2.3.2 as corrected: the edges f_in and f_out of Q meet in a reflex vertex that no other chain touches, and
   w is no vertex of P. *)
Theorem theorem_2_3_2_as_corrected (p q : region) (e f_in f_out : segment) (w : vector) :
  valid_region p -> valid_region q -> In e (region_edges p) -> lies_on w e -> ~ is_vertex w p ->
  meet_in_vertex f_in f_out q -> cross (along f_in) (along f_out) < 0 ->
  ~ on_boundary_of_sum (plus w (source f_out)) p q.
Proof. exact (edge_plus_reflex_vertex_is_not_on_the_boundary p q e f_in f_out w). Qed.

(* And its title: the reduced convolution contains the boundary. *)
Theorem title_of_theorem_2_3_2 (p q : region) (x : vector) :
  valid_region p -> valid_region q -> on_boundary_of_sum x p q -> on_reduced_convolution x p q.
Proof. exact (boundary_is_part_of_the_reduced_convolution p q x). Qed.

(* The hole of the chamber has a reflex vertex in (4, 4); the square's lower side moved there is inside the sum. *)
Example at_a_corner_of_the_hole : ~ on_boundary_of_sum (Vector 5 4) [square] chamber.
Proof.
  apply (theorem_2_3_2_as_corrected _ _ (Segment (Vector 0 0) (Vector 2 0)) (Segment (Vector 2 4) (Vector 4 4))
    (Segment (Vector 4 4) (Vector 4 2)) (Vector 1 0)).
  - apply square_is_a_region.
  - apply drawn_regions.
  - now left.
  - apply on_edge_by_computation. vm_compute. reflexivity.
  - apply no_vertex_by_computation. vm_compute. reflexivity.
  - destruct drawn_regions as (_ & apart & _). apply (apart [Vector 2 2; Vector 2 4; Vector 4 4; Vector 4 2] 2%nat).
    + vm_compute. tauto.
    + vm_compute. repeat constructor.
  - reflexivity.
Qed.

Example the_wall_is_on_the_reduced_convolution : on_reduced_convolution (Vector 2 3) [room] [fitting_diamond].
Proof.
  apply title_of_theorem_2_3_2;
    [apply simple_polygons_are_regions, drawn_polygons .. | exact wall_of_the_sum].
Qed.
