(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Observation 3.1.5 is false as printed. It says that all points of a false loop make P and -Q + x collide, that is,
   have an inner point in common. A false loop is one that Algorithm 1 traces and that is not on the boundary of the
   sum. P is a square with a triangular hole, Q the triangle that, reflected, just fits into the hole, at x = (0, 0):
   there they only touch, and (0, 0) is a vertex of a false loop. What holds is said of points inside edges: none of
   them is on the boundary of the sum, all are inner points of it. For if one edge of a loop is on the boundary, so are
   all that follow (Observation 3.2.4), and that is all of the loop. And P and -Q + x collide there, sums of two
   vertices included (segments_left_of_a_step.v), unless the edge runs along another one of the opposite direction,
   where the sum of the open polygons can have a dangling edge (Theorem 3.2.8). *)
From Coq Require Import QArith Lqa ZArith Lia Bool List Permutation.
From Oplus Require Import regions_and_sums simple_chain simple_chains_turn_once simple_polygons valid_components
  winding_numbers_of_valid_regions test_of_components theorem_2_2_10 theorem_2_2_6 parallelogram inside_a_corner
  boundary_points reduced_convolution edges_at_a_point fans_that_touch reduced_edges_that_pass
  segments_beside_the_open_sum angle filling pieces met_pieces cut_pieces beside_a_piece naive_collision
  collision_is_sound collision_is_complete placed_collision checked_collision beside_a_vertex kept_pieces_go_round
  chains_that_do_not_cross segments_left_of_a_step
  rule_of_sides sum_is_right loops_of_the_boundary algorithm_1 what_algorithm_1_traces arranged_convolution
  arrangement_of_the_convolution polygons_of_the_thesis drawn_regions.
Import ListNotations.

Open Scope Q_scope.

Definition is_false_loop (p q : region) (segments loop : list segment) : Prop :=
  In loop (algorithm_1 (arrangement_of segments)) /\ ~ forall e, In e loop -> is_boundary_edge p q e.

Definition observation_3_1_5_as_printed : Prop :=
  forall (p q : list component) (loop : list segment) (e : segment) (x : vector),
    valid_components p -> valid_components q ->
    is_false_loop (region_of p) (region_of q) (convolution_segments (region_of p) (region_of q)) loop ->
    In e loop -> lies_on x e -> interiors_meet x (region_of p) (region_of q).

Definition square_with_a_triangle : list component :=
  [Component (points_at [(-2, -2); (3, -2); (3, 3); (-2, 3)]) [points_at [(0, 0); (0, 1); (1, 0)]]].
Definition triangle_that_fits : list component := [Component (points_at [(0, 0); (-1, 0); (0, -1)]) []].

Definition false_loop : list segment :=
  edges (points_at [(0, -1); (0, 0); (1, -1); (1, 0); (0, 0); (0, 1); (-1, 1); (0, 0); (-1, 0)]).

Definition is_listed {A : Type} (same : forall a b : A, {a = b} + {a <> b}) (a : A) (l : list A) : bool :=
  if in_dec same a l then true else false.

Lemma is_listed_spec {A : Type} (same : forall a b : A, {a = b} + {a <> b}) (a : A) (l : list A) :
  (is_listed same a l = true -> In a l) /\ (is_listed same a l = false -> ~ In a l).
Proof. unfold is_listed. now destruct (in_dec same a l). Qed.

Lemma what_is_computed :
  let p := region_of square_with_a_triangle in let q := region_of triangle_that_fits in
  let e := Segment (Vector 0 (-1)) (Vector 0 0) in
  covers_nothing_twice p = true /\ covers_nothing_twice q = true /\ collide p (placed (Vector 0 0) q) = false /\
  is_listed (list_eq_dec segment_dec) false_loop (algorithm_1 (convolution_arrangement p q)) = true /\
  is_listed segment_dec e (convolution_arrangement p q) = true /\
  is_listed segment_dec e (edges_on_the_boundary p q (convolution_segments p q)) = false.
Proof. vm_compute. repeat split. Qed.

Lemma not_on_the_boundary (p q : region) (e : segment) : valid_region p -> valid_region q ->
  In e (convolution_arrangement p q) -> ~ In e (edges_on_the_boundary p q (convolution_segments p q)) ->
  ~ is_boundary_edge p q e.
Proof.
  intros p_region q_region listed none boundary. apply none.
  now apply (boundary_edges_are_kept p q p_region q_region _ (proj1 (both_are_convolutions p q)) e listed).
Qed.

Lemma false_loop_by_an_edge (p q : region) (loop : list segment) (e : segment) : valid_region p -> valid_region q ->
  In loop (algorithm_1 (convolution_arrangement p q)) -> In e loop -> In e (convolution_arrangement p q) ->
  ~ In e (edges_on_the_boundary p q (convolution_segments p q)) ->
  is_false_loop p q (convolution_segments p q) loop.
Proof.
  intros p_region q_region L E listed none. split; [exact L |]. intros boundary.
  exact (not_on_the_boundary p q e p_region q_region listed none (boundary e E)).
Qed.

(* Theorem. *)
Theorem observation_3_1_5_is_false_as_printed : ~ observation_3_1_5_as_printed.
Proof.
  intros printed. destruct what_is_computed as (p_test & q_test & no_collision & loop_listed & e_listed & not_filled).
  apply covers_nothing_twice_is_right in p_test, q_test.
  destruct p_test as [p_region p_simple], q_test as [q_region q_simple].
  apply is_listed_spec in loop_listed as L.
  specialize (printed square_with_a_triangle triangle_that_fits false_loop (Segment (Vector 0 (-1)) (Vector 0 0))
    (Vector 0 0)).
  revert printed p_region p_simple q_region q_simple no_collision L e_listed not_filled. clear loop_listed.
  generalize (are_valid_components_sound square_with_a_triangle), (are_valid_components_sound triangle_that_fits).
  intros p_valid q_valid. specialize (p_valid eq_refl). specialize (q_valid eq_refl).
  set (e := Segment (Vector 0 (-1)) (Vector 0 0)).
  generalize dependent (region_of square_with_a_triangle). generalize dependent (region_of triangle_that_fits).
  intros q p printed p_region p_simple q_region q_simple no_collision L e_listed not_filled.
  apply is_listed_spec in e_listed as listed. apply is_listed_spec in not_filled as none.
  assert (meet : interiors_meet (Vector 0 0) p q).
  { apply printed; [exact p_valid | exact q_valid | | now left | exact (target_lies_on e)]. split; [exact L |].
    intros boundary. exact (not_on_the_boundary p q e p_region q_region listed none (boundary e (or_introl eq_refl))). }
  apply (collide_decides_whether_interiors_meet p q (Vector 0 0) p_region q_region p_simple q_simple) in meet.
  congruence.
Qed.

Section Corrected.
  Variables p q : region.
  Hypothesis p_region : valid_region p.
  Hypothesis q_region : valid_region q.

  Section AnyConvolution.
  Variable segments : list segment.
  Hypothesis convolution_ : is_convolution p q segments.
  Variable loop : list segment.
  Hypothesis false_ : is_false_loop p q segments loop.

  Lemma edges_of_false_loops (e : segment) : In e loop ->
    In e (arrangement_of segments) /\ ~ In e (edges_on_the_boundary p q segments).
  Proof.
    intros E. destruct false_ as [L other]. set (arrangement := arrangement_of segments) in *.
    destruct (traced_loops arrangement arrangement []) as (are_loops & _);
      [constructor | intros g [] | apply incl_refl |].
    pose proof (are_loops loop L) as traced. pose proof traced as (_ & _ & part & _). split; [now apply part |].
    intros on. apply other. intros f F.
    apply (boundary_edges_are_kept p q p_region q_region segments convolution_ f (part f F)).
    refine (all_or_none arrangement (edges_on_the_boundary p q segments) _ loop e traced E on f F).
    intros g G.
    destruct (largest_turn_stays_on_the_loops p q p_region q_region segments convolution_ g G) as (h & is_ & H & _).
    exists h. split; assumption.
  Qed.

  Lemma inner_points_inside_edges (e : segment) (x : vector) :
    In e loop -> strictly_inside x e -> inner_point_of_sum x p q.
  Proof.
    intros E inside_. destruct (edges_of_false_loops e E) as [listed not_on].
    pose proof (arranged_are_long p q p_region q_region segments convolution_) as all_long.
    pose proof (arranged_loops_are_the_sum p q p_region q_region segments convolution_) as loops_.
    destruct (arrangement_edge_is segments e all_long listed) as (D & t & T & _ & covers_).
    pose proof (covers_ x (strictly_inside_lies_on _ _ inside_)) as on.
    destruct (off_the_loops_of_segments p q _ _ _ loops_ x) as [| (radius & R & none)]; [| assumption |].
    - intros k K on_k. apply (kept_are_edges p q _ _ _ loops_) in K.
      destruct (segment_dec e k) as [<- | other]; [contradiction |].
      destruct (segment_dec e (reversed k)) as [-> | other'];
        [exact (none_runs_back p q p_region q_region segments convolution_ k K listed) |].
      exact (directed_are_apart _ (pieces_of_share_ends segments all_long) e k x D
        (kept_are_pieces _ _ _ _ _ loops_ k K) other other' inside_ on_k).
    - exfalso. apply (none x); [unfold within; lra |].
      exact (on_the_convolution_is_in_the_sum p q x t (proj1 convolution_ t T) on).
  Qed.
  End AnyConvolution.

  Let segments := convolution_segments p q.
  Let convolution_ := proj1 (both_are_convolutions p q).
  Let arrangement := convolution_arrangement p q.
  Let all_long := all_are_long p q p_region q_region.
  Variable loop : list segment.
  Hypothesis false_ : is_false_loop p q segments loop.

  (* What covers a point inside an edge is along it. *)
  Lemma covering_is_parallel (e s : segment) (x : vector) : In e loop -> strictly_inside x e ->
    In s segments -> lies_on x s -> cross (along e) (along s) == 0.
  Proof.
    intros E inside_ S on.
    destruct (edges_of_false_loops segments convolution_ loop false_ e E) as [listed _].
    pose proof (arrangement_is_directed p q p_region q_region segments convolution_ e listed) as D.
    pose proof (pieces_meet_along p q p_region q_region segments convolution_ e D) as only.
    destruct (only x s inside_ S on) as [from to]. in_coordinates. lra.
  Qed.

  (* Beside it P and -Q + x collide. *)
  Lemma collide_beside (e : segment) (x n : vector) : In e loop -> strictly_inside x e -> ~ cross (along e) n == 0 ->
    eventually (fun t => interiors_meet (moved_along x n t) p q).
  Proof.
    intros E inside_ turn.
    destruct (inner_points_inside_edges segments convolution_ loop false_ e x E inside_) as (radius & R & inner).
    destruct (edges_of_false_loops segments convolution_ loop false_ e E) as [listed _].
    pose proof (arrangement_is_directed p q p_region q_region segments convolution_ e listed) as D.
    pose proof (pieces_meet_along p q p_region q_region segments convolution_ e D) as only.
    pose proof (nothing_met_beside segments e x n only inside_ turn) as free.
    refine (eventually_implied _ _ _ (eventually_and _ _ free (small_steps_stay_within radius x n R))).
    intros t [off_ close]. exact (common_point_off_the_convolution p q _ p_region q_region off_ (inner _ close)).
  Qed.

  Lemma collide_inside_edges (e : segment) (x : vector) : nowhere_above_one p -> nowhere_above_one q ->
    chains_do_not_cross p -> chains_do_not_cross q ->
    In e loop -> strictly_inside x e -> ~ In (reversed e) arrangement -> interiors_meet x p q.
  Proof.
    intros p_simple q_simple p_crosses_nowhere q_crosses_nowhere E inside_ none_back.
    pose proof (collide_decides_whether_interiors_meet p q x p_region q_region p_simple q_simple) as decides.
    destruct (collide p (placed x q)); [now apply decides | exfalso].
    assert (outside : ~ interiors_meet x p q) by (intros meet; now apply decides in meet). clear decides.
    destruct (edges_of_false_loops segments convolution_ loop false_ e E) as [listed _].
    pose proof (arrangement_is_directed p q p_region q_region segments convolution_ e listed) as D.
    pose proof (directed_is_long _ (pieces_of_share_ends segments all_long) e D) as long.
    set (n := Vector (vy (along e)) (- vx (along e))).
    assert (right_ : cross (along e) n < 0).
    { pose proof (left_normal e long). unfold n, cross in *. cbn [vx vy] in *. lra. }
    (* a segment covers x that has n to its left, and so runs back *)
    destruct (segment_left_of_a_step p q x n p_region q_region p_crosses_nowhere q_crosses_nowhere outside)
      as (s & S & on & left_); [intros [X Y]; unfold cross in right_; rewrite X, Y in right_; lra | |].
    { apply (collide_beside e x n E inside_). lra. }
    pose proof (covering_is_parallel e s x E inside_ S on) as line.
    destruct (multiple_of (along s) (along e) long) as (c & cx & cy); [unfold cross in *; lra |].
    assert (back : c < 0).
    { apply Qnot_le_lt. intros ahead_. unfold cross in left_, right_. rewrite cx, cy in left_. nra. }
    destruct (proj2 (cut_returns s (flat_map (intersection s) segments) (all_long s S)) x on)
      as (piece & P & part & on_piece).
    assert (listed' : In (reduced_segment piece) arrangement)
      by (apply nodup_In, in_flat_map; exists s; split; [exact S | now apply in_map]).
    pose proof (lies_on_of_one_place _ _ _ (of_one_place_sym _ _ (reduced_segment_place piece)) on_piece) as on_.
    destruct (segment_dec e (reduced_segment piece)) as [is_ | other].
    - destruct (part_is_long piece s part (all_long s S)) as [_ (b & b_some & bx & by_)].
      destruct (reduced_segment_is piece) as [[sx sy] [tx ty]].
      assert (e_x : vx (along e) == b * c * vx (along e) /\ vy (along e) == b * c * vy (along e)).
      { assert (along_x : vx (along e) == vx (along piece)) by (rewrite is_; unfold along, minus; cbn [vx]; lra).
        assert (along_y : vy (along e) == vy (along piece)) by (rewrite is_; unfold along, minus; cbn [vy]; lra).
        rewrite along_x at 1. rewrite along_y at 1. rewrite bx, by_, cx, cy. split; ring. }
      assert (0 < b * - c) by (apply Qmult_lt_0_compat; lra).
      apply long. split; apply (Qmult_inj_l _ _ (1 - b * c)); lra.
    - destruct (segment_dec e (reversed (reduced_segment piece))) as [is_ | other'].
      + apply none_back. now rewrite is_, reversed_twice.
      + exact (directed_are_apart _ (pieces_of_share_ends segments all_long) e _ x D
          (arrangement_is_directed p q p_region q_region segments convolution_ _ listed') other other' inside_ on_).
  Qed.
End Corrected.

(* Theorem, Observation 3.1.5 as corrected: x is inside an edge. The loop is traced in the arrangement of the full
   convolution, or of the reduced one, or of anything between. *)
Theorem observation_3_1_5_as_corrected (p q : region) (segments loop : list segment) (e : segment) (x : vector) :
  valid_region p -> valid_region q -> is_convolution p q segments -> is_false_loop p q segments loop ->
  In e loop -> strictly_inside x e -> inner_point_of_sum x p q.
Proof.
  intros p_region q_region convolution_ false_.
  exact (inner_points_inside_edges p q p_region q_region segments convolution_ loop false_ e x).
Qed.

(* Theorem. Where P and -Q + x do not collide, an edge runs back. *)
Theorem false_loops_make_them_collide_inside_edges (p q : region) (loop : list segment) (e : segment) (x : vector) :
  valid_region p -> valid_region q -> nowhere_above_one p -> nowhere_above_one q ->
  chains_do_not_cross p -> chains_do_not_cross q -> is_false_loop p q (convolution_segments p q) loop ->
  In e loop -> strictly_inside x e -> ~ In (reversed e) (convolution_arrangement p q) -> interiors_meet x p q.
Proof.
  intros p_region q_region p_simple q_simple p_crosses_nowhere q_crosses_nowhere false_.
  exact (collide_inside_edges p q p_region q_region loop false_ e x p_simple q_simple p_crosses_nowhere
    q_crosses_nowhere).
Qed.

(* Inside the first edge of the false loop. *)
Example inside_an_edge_of_the_false_loop :
  inner_point_of_sum (Vector 0 (- (1 # 2))) (region_of square_with_a_triangle) (region_of triangle_that_fits).
Proof.
  destruct what_is_computed as (p_test & q_test & _ & loop_listed & e_listed & not_filled).
  apply covers_nothing_twice_is_right in p_test, q_test. destruct p_test as [p_region _], q_test as [q_region _].
  apply is_listed_spec in loop_listed, e_listed, not_filled.
  assert (E : In (Segment (Vector 0 (-1)) (Vector 0 0)) false_loop) by exact (or_introl eq_refl).
  pose proof (false_loop_by_an_edge _ _ _ _ p_region q_region loop_listed E e_listed not_filled) as false_.
  refine (observation_3_1_5_as_corrected _ _ _ false_loop _ _ p_region q_region (proj1 (both_are_convolutions _ _))
    false_ E _).
  exists (1 # 2). cbn [source target vx vy]. split; [lra | split; lra].
Qed.
