(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Observation 3.2.6 as printed: the sum of two simple polygons is connected, and its boundary is one external loop and
   any number of holes. The sums are of closed polygons, which have no low dimensional features, so none has to be
   excepted; and the interior of the sum is connected, too, so loops that touch are no exception. The interior goes
   round no loop partly: a path in it meets none (sums_are_connected.v). To the left of an external loop it is inside
   the loop, to the left of a hole it is not; so it is inside all external loops, and in no hole. But the numbers of all
   loops add up to 1 there, so there is one external loop. The loops are those of Lemma 3.1.2. *)
From Coq Require Import QArith Lqa ZArith Lia Bool List Permutation.
From Oplus Require Import regions_and_sums simple_chain simple_chains_turn_once winding_numbers_of_simple_chains
  valid_components edges_of_valid_regions finite_sums tangent_count connected_sets connected_beside_pieces
  theorem_2_2_10 pieces naive_collision collision_is_sound beside_a_piece complement_in_a_frame nested_chains
  nested_polygons loops_of_the_boundary printed_observation_3_1_4 polygons_of_the_thesis sums_are_connected.
Import ListNotations.

Open Scope Q_scope.

Lemma left_by_a_step (e : segment) (w n : vector) (d : Q) : lies_on w e -> 0 < cross (along e) n -> 0 < d ->
  0 < area e (moved_along w n d).
Proof.
  intros on turn some. rewrite (inside_a_corner.area_from w _ e on).
  setoid_replace (cross (along e) (minus (moved_along w n d) w)) with (d * cross (along e) n)
    by (unfold cross, minus, moved_along; cbn [vx vy]; ring).
  now apply Qmult_lt_0_compat.
Qed.

Lemma one_of_them (l : list (list vector)) : sum_of (fun loop => Z.b2z (is_counterclockwise loop)) l = 1%Z ->
  exists outer_ holes, Permutation l (outer_ :: holes) /\ is_counterclockwise outer_ = true /\
    forall h, In h holes -> is_counterclockwise h = false.
Proof.
  assert (none : forall l, sum_of (fun loop => Z.b2z (is_counterclockwise loop)) l = 0%Z ->
    forall h, In h l -> is_counterclockwise h = false).
  { intros m total h H. assert (terms : forall c, In c m -> (0 <= Z.b2z (is_counterclockwise c))%Z)
      by (intros c _; destruct (is_counterclockwise c); cbn; lia).
    pose proof (zero_sum _ _ _ terms total h H) as term. cbv beta in term.
    destruct (is_counterclockwise h); [discriminate | reflexivity]. }
  induction l as [| a l IH]; intros total; [discriminate |]. change (Z.b2z (is_counterclockwise a) +
    sum_of (fun loop => Z.b2z (is_counterclockwise loop)) l = 1)%Z in total.
  destruct (is_counterclockwise a) eqn:turns_; cbn [Z.b2z] in total.
  - exists a, l. split; [reflexivity |]. split; [exact turns_ |]. apply none. lia.
  - destruct IH as (outer_ & holes & same_ & is_outer & are_holes); [lia |]. exists outer_, (a :: holes).
    split; [rewrite same_; apply perm_swap |]. split; [exact is_outer |].
    intros h [<- | H]; [exact turns_ | exact (are_holes h H)].
Qed.

Section Loops.
  Variables p q : list vector.
  Hypothesis p_polygon : simple_polygon p.
  Hypothesis q_polygon : simple_polygon q.

  Let p_region := simple_polygons_are_regions p p_polygon.
  Let q_region := simple_polygons_are_regions q q_polygon.
  Let inner := fun z => inner_point_of_sum z [p] [q].
  Variable loops : list (list vector).
  Hypothesis are_simple : forall loop, In loop loops -> simple loop.
  Hypothesis valid : valid_region loops.
  Hypothesis above : nowhere_above_one loops.
  Hypothesis on_the_loops : forall x,
    on_boundary_of_sum x [p] [q] <-> exists e, In e (region_edges loops) /\ lies_on x e.
  Hypothesis no_vertex_inside : forall e x, In e (region_edges loops) -> strictly_inside x e -> ~ is_vertex x loops.
  Hypothesis beside_the_loops : forall x, off x (region_edges loops) ->
    inner x \/ exists radius, 0 < radius /\ forall y, within radius x y -> ~ in_sum y [p] [q].
  Hypothesis fills : forall x, in_region x loops <-> in_sum x [p] [q].

  Lemma inner_points_are_off_the_loops (y : vector) : inner y -> off y (region_edges loops).
  Proof.
    intros inner_y s S on. apply (inner_points_are_not_on_the_boundary [p] [q] y inner_y).
    apply on_the_loops. exists s. split; assumption.
  Qed.

  Lemma edges_of_a_loop (loop : list vector) : In loop loops -> incl (edges loop) (region_edges loops).
  Proof. intros L s S. apply in_flat_map. exists loop. split; assumption. Qed.

  (* A loop goes round all inner points equally often. *)
  Lemma same_number_in_the_interior (loop : list vector) (y z : vector) : In loop loops -> inner y -> inner z ->
    winding_number y (edges loop) = winding_number z (edges loop).
  Proof.
    intros L inner_y inner_z.
    destruct (interior_of_the_sum_is_connected p q p_region q_region y z inner_y inner_z) as (path & walk).
    assert (step : forall a c, (forall v, lies_on v (Segment a c) -> inner v) ->
      winding_number a (edges loop) = winding_number c (edges loop)).
    { intros a c all. apply (winding_number_along (Segment a c) _ (closed_chain_cycles loop)).
      intros v on s S. apply (inner_points_are_off_the_loops v (all v on)), (edges_of_a_loop loop L s S). }
    clear inner_y. revert y walk. induction path as [| c rest IH]; intros y walk; [exact (step y z walk) |].
    destruct walk as [first_ walk].
    transitivity (winding_number c (edges loop)); [exact (step y c first_) | exact (IH c walk)].
  Qed.

  (* Once if it is external, never if it is a hole. *)
  Lemma number_in_the_interior (loop : list vector) (y : vector) : In loop loops -> inner y ->
    winding_number y (edges loop) = Z.b2z (is_counterclockwise loop).
  Proof.
    intros L inner_y. pose proof (are_simple loop L) as loop_simple.
    assert (some : exists e, In e (edges loop)).
    { destruct loop_simple as (three & _). exists (edge_at loop 0). apply nth_In. rewrite edges_are_as_many. lia. }
    destruct some as (e & E). pose proof (edges_of_a_loop loop L e E) as E'.
    pose proof (middle_is_inside e) as inside_. set (w := middle e) in *.
    pose proof (strictly_inside_lies_on _ _ inside_) as on.
    pose proof (no_vertex_inside e w E' inside_) as no_vertex.
    destruct (inside_beside_an_edge loops e w valid above E' on no_vertex) as (radius & R & near).
    set (n := Vector (- vy (along e)) (vx (along e))).
    assert (turn : 0 < cross (along e) n).
    { destruct loop_simple as (_ & long & _). apply left_normal, long. now apply in_map. }
    assert (one : region_edges [loop] = edges loop) by apply app_nil_r.
    assert (meet : edges_meet_in_vertices [loop]).
    { apply edges_meet_by_pairs. rewrite one. apply edges_of_one_chain; [exact loop_simple | apply incl_refl]. }
    assert (no_vertex' : ~ is_vertex w [loop]).
    { intros (u & U & equal). apply no_vertex. exists u. split; [| exact equal]. rewrite one in U.
      exact (edges_of_a_loop loop L u U). }
    destruct (some_small _ (eventually_and _ _ (small_steps_stay_within radius w n R)
      (left_is_one_more [loop] e w n meet ltac:(now rewrite one) on no_vertex' turn)))
      as (d & some & close & free & free' & more). rewrite one in free, free', more.
    pose proof (winding_numbers_of_simple_chains loop _ loop_simple free) as range.
    pose proof (winding_numbers_of_simple_chains loop _ loop_simple free') as range'.
    rewrite (same_number_in_the_interior loop y (moved_along w n d) L inner_y).
    - destruct (is_counterclockwise loop); cbn [Z.b2z]; lia.
    - assert (left_ : 0 < area e (moved_along w n d)).
      { exact (left_by_a_step e w n d on turn some). }
      destruct (proj2 (proj1 (near _ close)) left_) as [free_y number_].
      destruct (beside_the_loops _ free_y) as [| (r & r_some & none)]; [assumption | exfalso].
      apply (none (moved_along w n d)); [unfold within; lra |]. apply fills. now left.
  Qed.

  (* Close to each point of a loop are inner points: each boundary point has points of the sum close to it. *)
  Lemma inner_points_close_to_a_loop (loop : list vector) (x : vector) (radius : Q) : In loop loops ->
    on_one_of x (edges loop) -> 0 < radius -> exists y, within radius x y /\ inner y.
  Proof.
    intros L (s & S & on) R.
    destruct (inside_near loops x radius (coordinates.valid_is_regular _ valid)) as (y & close & free & round);
      [right; exists s; split; [exact (edges_of_a_loop loop L s S) | exact on] | exact R |].
    exists y. split; [exact close |].
    destruct (beside_the_loops y free) as [| (r & r_some & none)]; [assumption | exfalso].
    apply (none y); [unfold within; lra |]. apply fills. left. exact round.
  Qed.

  Lemma some_inner_point : exists y, inner y.
  Proof.
    destruct (proj1 p_polygon) as (three & _).
    assert (E : In (edge_at p 0) (region_edges [p])) by (apply edge_at_in_region; [now left | lia]).
    destruct (proj1 q_polygon) as (three' & _).
    assert (F : In (edge_at q 0) (region_edges [q])) by (apply edge_at_in_region; [now left | lia]).
    destruct (inside_near [q] (source (edge_at q 0)) 1 (coordinates.valid_is_regular _ q_region)) as (b & _ & in_q);
      [right; exists (edge_at q 0); split; [exact F | apply source_lies_on] | lra |].
    exists (plus (source (edge_at p 0)) b). apply point_and_inner_point; [| exact in_q].
    right. exists (edge_at p 0). split; [exact E | apply source_lies_on].
  Qed.

  Lemma one_external_loop : exists outer_ holes, Permutation loops (outer_ :: holes) /\
    is_counterclockwise outer_ = true /\
    forall h, In h holes -> is_counterclockwise h = false /\ encloses outer_ h.
  Proof.
    destruct some_inner_point as (y & inner_y).
    destruct (one_of_them loops) as (outer_ & holes & same_ & is_outer & are_holes).
    { pose proof (inner_points_are_off_the_loops y inner_y) as free.
      transitivity (winding_number y (region_edges loops)).
      - rewrite winding_number_of_region. apply sum_equally. intros a A. symmetry.
        exact (number_in_the_interior a y A inner_y).
      - pose proof (above y free) as at_most. destruct inner_y as (radius & R & near).
        assert (in_y : in_region y loops) by (apply fills, near; unfold within; lra).
        destruct in_y as [round | (s & S & on)]; [lia | destruct (free s S on)]. }
    exists outer_, holes. split; [exact same_ |]. split; [exact is_outer |]. intros h H.
    assert (L : In outer_ loops) by (apply (Permutation_in _ (Permutation_sym same_)); now left).
    assert (M : In h loops) by (apply (Permutation_in _ (Permutation_sym same_)); now right).
    split; [exact (are_holes h H) |]. split.
    { intros <-. rewrite (are_holes _ H) in is_outer. discriminate. }
    intros x on off_x.
    destruct (winding_number_near x (edges outer_) (closed_chain_cycles outer_) off_x) as (radius & R & near).
    destruct (inner_points_close_to_a_loop h x radius M on R) as (z & close & inner_z).
    destruct (near z close) as [_ <-]. rewrite (number_in_the_interior outer_ z L inner_z), is_outer. discriminate.
  Qed.
End Loops.

(* Theorem. The boundary is one external loop, and holes that it encloses. *)
Theorem observation_3_2_6_as_printed (p q : list vector) : simple_polygon p -> simple_polygon q ->
  (forall x y, in_sum x [p] [q] -> in_sum y [p] [q] -> connected_in (fun z => in_sum z [p] [q]) x y) /\
  exists outer_ holes, Permutation (boundary_loops [p] [q]) (outer_ :: holes) /\
    is_counterclockwise outer_ = true /\
    forall h, In h holes -> is_counterclockwise h = false /\ encloses outer_ h.
Proof.
  intros p_polygon q_polygon.
  pose proof (simple_polygons_are_regions p p_polygon) as p_region.
  pose proof (simple_polygons_are_regions q q_polygon) as q_region.
  split; [intros x y; exact (sum_is_connected p q x y) |].
  pose proof (boundary_loops_are_loops_of_the_sum [p] [q] p_region q_region) as loops_.
  pose proof (boundary_loops_do_not_cross [p] [q] p_region q_region) as (_ & are_simple & _).
  destruct (loops_are_valid _ _ _ _ _ loops_) as [valid above].
  apply (one_external_loop p q p_polygon q_polygon (boundary_loops [p] [q]) are_simple valid above).
  - exact (boundary_is_on_the_loops [p] [q] p_region q_region).
  - exact (inside_no_vertex [p] [q] p_region q_region).
  - exact (off_the_loops [p] [q] p_region q_region).
  - exact (loops_fill_the_sum _ _ _ _ _ loops_).
Qed.

(* Its interior is connected, also where loops touch. *)
Theorem interior_of_the_sum_as_printed (p q : list vector) (x y : vector) : simple_polygon p -> simple_polygon q ->
  inner_point_of_sum x [p] [q] -> inner_point_of_sum y [p] [q] ->
  connected_in (fun z => inner_point_of_sum z [p] [q]) x y.
Proof.
  intros p_polygon q_polygon.
  exact (interior_of_the_sum_is_connected p q (simple_polygons_are_regions p p_polygon)
    (simple_polygons_are_regions q q_polygon) x y).
Qed.
