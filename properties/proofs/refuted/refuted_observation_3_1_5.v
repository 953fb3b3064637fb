(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Observation 3.1.5 is false as printed. It says that all points of a false loop make P and -Q + x collide, that is,
   have an inner point in common. A false loop is one that Algorithm 1 traces and that is not on the boundary of the
   sum. P is a square with a triangular hole, Q the triangle that, reflected, just fits into the hole, at x = (0, 0):
   there they only touch, and (0, 0) is a vertex of a false loop. What holds is said of points inside edges: none of
   them is on the boundary of the sum, all are inner points of it. For if one edge of a loop is on the boundary, so are
   all that follow (Observation 3.2.4), and that is all of the loop. And P and -Q + x collide there, unless x is one of
   the finitely many sums of two vertices, or the edge runs along another one of the opposite direction, where the sum
   of the open polygons can have a dangling edge (Theorem 3.2.8). *)
From Coq Require Import QArith Lqa ZArith Lia Bool List Permutation.
From Oplus Require Import regions_and_sums simple_chain simple_chains_turn_once simple_polygons valid_components
  winding_numbers_of_valid_regions test_of_components theorem_2_2_10 theorem_2_2_6 parallelogram inside_a_corner
  boundary_points reduced_convolution edges_at_a_point fans_that_touch reduced_edges_that_pass
  segments_beside_the_open_sum angle filling pieces met_pieces cut_pieces beside_a_piece naive_collision
  collision_is_sound collision_is_complete placed_collision checked_collision beside_a_vertex kept_pieces_go_round
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
  Lemma covering_is_parallel (e s : segment) (x d : vector) : In e loop -> strictly_inside x e ->
    In s (reduced_convolution p q) -> lies_on x s -> same_direction (along s) d -> cross (along e) d == 0.
  Proof.
    intros E inside_ S on (a & some & X & Y). apply reduced_is_part_of_the_convolution in S.
    destruct (edges_of_false_loops segments convolution_ loop false_ e E) as [listed _].
    pose proof (arrangement_is_directed p q p_region q_region segments convolution_ e listed) as D.
    pose proof (pieces_meet_along p q p_region q_region segments convolution_ e D) as only.
    destruct (only x s inside_ S on) as [from to]. apply (Qmult_inj_l _ _ a); [lra |].
    transitivity (cross (along e) (along s)); [unfold cross; rewrite X, Y; ring |].
    in_coordinates. lra.
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
    In e loop -> strictly_inside x e -> ~ In (reversed e) arrangement ->
    (forall w u, is_vertex w p -> is_vertex u q -> ~ equal_vectors x (plus w u)) -> interiors_meet x p q.
  Proof.
    intros p_simple q_simple E inside_ none_back no_vertices.
    pose proof (collide_decides_whether_interiors_meet p q x p_region q_region p_simple q_simple) as decides.
    destruct (collide p (placed x q)); [now apply decides | exfalso].
    assert (outside : ~ interiors_meet x p q) by (intros meet; now apply decides in meet). clear decides.
    destruct (edges_of_false_loops segments convolution_ loop false_ e E) as [listed _].
    pose proof (arrangement_is_directed p q p_region q_region segments convolution_ e listed) as D.
    pose proof (directed_is_long _ (pieces_of_share_ends segments all_long) e D) as long.
    set (n := Vector (vy (along e)) (- vx (along e))).
    assert (right_ : cross (along e) n < 0).
    { pose proof (left_normal e long). unfold n, cross in *. cbn [vx vy] in *. lra. }
    assert (none_meet : forall w u, is_vertex w p -> is_vertex u q -> equal_vectors x (plus w u) ->
      alone w p /\ alone u q)
      by (intros w u W U is_; now destruct (no_vertices w u W U)).
    assert (aside : forall f, nonzero (along f) -> reduced_along p q x (along f) -> ~ cross (along f) n == 0).
    { intros f long_f (s & S & on & same_) flat. pose proof (covering_is_parallel e s x _ E inside_ S on same_) as line.
      destruct (multiple_of (along f) (along e) long) as (c & X & Y); [unfold cross in *; lra |].
      assert (c_none : c * cross (along e) n == 0) by (rewrite <- flat; unfold cross; rewrite X, Y; ring).
      destruct (Qmult_integral _ _ c_none) as [zero_ | zero_]; [| lra]. apply long_f. rewrite X, Y, zero_.
      split; ring. }
    destruct (segments_beside_the_open_sum p q x n p_region q_region outside)
      as (d & (s & S & on & same_) & left_d & _).
    - intros f w u F on no_vertex in_q x_is.
      apply aside; [now apply (region_edges_are_directions p (proj1 p_region)) |].
      now apply (passing_edges_of_p_are_covered p q x p_region q_region outside none_meet w u f).
    - intros f u w F on no_vertex in_p x_is.
      apply aside; [now apply (region_edges_are_directions q (proj1 q_region)) |].
      now apply (passing_edges_of_q_are_covered p q x p_region q_region outside none_meet u w f).
    - exact no_vertices.
    - apply (collide_beside e x n E inside_). lra.
    - pose proof (covering_is_parallel e s x d E inside_ S on same_) as line.
      apply reduced_is_part_of_the_convolution in S. destruct same_ as (a & some & X & Y).
      destruct (multiple_of d (along e) long) as (c & cx & cy); [unfold cross in *; lra |].
      assert (back : c < 0).
      { apply Qnot_le_lt. intros ahead_. unfold cross in left_d, right_. rewrite cx, cy in left_d. nra. }
      destruct (proj2 (cut_returns s (flat_map (intersection s) segments) (all_long s S)) x on)
        as (piece & P & part & on_piece).
      assert (listed' : In (reduced_segment piece) arrangement)
        by (apply nodup_In, in_flat_map; exists s; split; [exact S | now apply in_map]).
      pose proof (lies_on_of_one_place _ _ _ (of_one_place_sym _ _ (reduced_segment_place piece)) on_piece) as on_.
      destruct (segment_dec e (reduced_segment piece)) as [is_ | other].
      + destruct (part_is_long piece s part (all_long s S)) as [_ (b & b_some & bx & by_)].
        destruct (reduced_segment_is piece) as [[sx sy] [tx ty]].
        assert (e_x : vx (along e) == b * a * c * vx (along e) /\ vy (along e) == b * a * c * vy (along e)).
        { assert (along_x : vx (along e) == vx (along piece)) by (rewrite is_; unfold along, minus; cbn [vx]; lra).
          assert (along_y : vy (along e) == vy (along piece)) by (rewrite is_; unfold along, minus; cbn [vy]; lra).
          rewrite along_x at 1. rewrite along_y at 1. rewrite bx, by_, X, Y, cx, cy. split; ring. }
        assert (0 < b * a) by now apply Qmult_lt_0_compat.
        assert (0 < b * a * - c) by (apply Qmult_lt_0_compat; lra).
        apply long. split; apply (Qmult_inj_l _ _ (1 - b * a * c)); lra.
      + destruct (segment_dec e (reversed (reduced_segment piece))) as [is_ | other'].
        * apply none_back. now rewrite is_, reversed_twice.
        * exact (directed_are_apart _ (pieces_of_share_ends segments all_long) e _ x D
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

(* Theorem. Where P and -Q + x do not collide, x is a sum of two vertices, or an edge runs back. *)
Theorem false_loops_make_them_collide (p q : region) (loop : list segment) (e : segment) (x : vector) :
  valid_region p -> valid_region q -> nowhere_above_one p -> nowhere_above_one q ->
  is_false_loop p q (convolution_segments p q) loop -> In e loop -> strictly_inside x e -> ~ In (reversed e)
    (convolution_arrangement p q) ->
  (forall w u, is_vertex w p -> is_vertex u q -> ~ equal_vectors x (plus w u)) -> interiors_meet x p q.
Proof.
  intros p_region q_region p_simple q_simple false_.
  exact (collide_inside_edges p q p_region q_region loop false_ e x p_simple q_simple).
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
