(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Theorem 2.3.2 is false as printed, for polygons whose chains touch. It says that the sum of an edge e of P and a
   reflex vertex of Q is not on the boundary of the sum. Q is a triangle with a hole that touches its right side in
   the vertex (4, 3), which is reflex, P a triangle with a vertical side at its right: their sum is part of the right
   side of the sum, (6, 7/2) is one of its points. The proof in the thesis looks at the edges that encompass e, at
   points where chains touch; there these are the outer chain's, not the hole's. What holds is proved in
   theorem_2_3_2.v: no other chain touches the vertex; or, where chains touch, it is these edges that turn to the right
   (edges_that_encompass.v). What the title says, that the reduced convolution covers the boundary, is true where chains
   touch, too. *)
From Coq Require Import QArith Lqa List.
From Oplus Require Import convolution regions left_of_an_edge theorem_4_2_1 theorem_2_2_10 valid_components
  theorem_4_2_1_for_valid_regions inside_a_corner boundary_points edges_at_a_point reduced_convolution theorem_2_3_2
  edges_that_encompass meeting_of_segments tie_rule small_polygons simple_polygons polygons_of_the_thesis
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

(* And where chains touch: the edges of Q at u that are next to the direction of e, f before u and g after it, turn to
   the right. *)
Theorem theorem_2_3_2_where_chains_touch (p q : region) (e f g : segment) (w u : vector) :
  valid_region p -> valid_region q -> In e (region_edges p) -> lies_on w e -> ~ is_vertex w p ->
  directly_encompass q u (along e) f g -> cross (along f) (along g) < 0 ->
  ~ on_boundary_of_sum (plus w u) p q.
Proof. exact (encompassed_by_a_reflex_vertex p q e f g w u). Qed.

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

(* Where the hole touches the triangle's side, an edge that leads into the hole is between the hole's edges. *)
Example where_the_hole_touches :
  ~ on_boundary_of_sum (Vector 5 (5 # 2)) [points_at [(0, 0); (1, -2); (2, -1)]]
    (region_of triangle_with_inscribed_hole).
Proof.
  set (e := Segment (Vector 2 (-1)) (Vector 0 0)). set (u := Vector 4 3).
  set (f := Segment (Vector 3 4) (Vector 4 3)). set (g := Segment (Vector 4 3) (Vector 2 3)).
  apply (theorem_2_3_2_where_chains_touch _ _ e f g (Vector 1 (- (1 # 2))) u).
  - apply simple_polygons_are_regions. split; [apply simple_chain.is_simple_decides |]; vm_compute; reflexivity.
  - apply valid_components_are_valid_regions, triangle_with_inscribed_hole_is_valid.
  - vm_compute. tauto.
  - apply on_edge_by_computation. vm_compute. reflexivity.
  - apply no_vertex_by_computation. vm_compute. reflexivity.
  - split; [vm_compute; tauto |]. split.
    { apply arrives_at_its_target; [intros [X _]; discriminate X | split; reflexivity]. }
    split; [vm_compute; tauto |]. split.
    { apply departs_from_its_source; [intros [X _]; discriminate X | split; reflexivity]. }
    left. split; [vm_compute; reflexivity |]. intros s c S at_u.
    assert (on : lies_on u s) by (destruct at_u as [[there _] | [there _]];
      [apply departs_is in there | apply arrives_is in there]; tauto).
    vm_compute in S. destruct on as (t & range & X & Y).
    destruct S as [<- | [<- | [<- | [<- | [<- | [<- | []]]]]]]; unfold u in X, Y; cbn [source target vx vy] in X, Y;
      first [exfalso; lra | destruct at_u as [[_ ->] | [_ ->]]; vm_compute; reflexivity].
  - reflexivity.
Qed.
