(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Corollary 3.1.3 as it holds for faces with holes. A face of the sum is what paths inside its interior reach from an
   inner point. The boundary of each face is on the loops of the boundary (loops_of_the_boundary.v), which are weakly
   simple chains, and do not cross; and each point inside an edge of a loop is on the boundary of a face, which is to
   the left of the edge. That all of the boundary is one chain is false (refuted_corollary_3_1_3.v). *)
From Coq Require Import QArith Qminmax Lqa ZArith Lia Bool List.
From Oplus Require Import regions_and_sums simple_chain valid_components connected_sets theorem_2_2_10 lemma_2_2_2
  inside_a_corner lemma_3_1_2 collision_is_sound valid_regions_are_accepted nested_polygons printed_lemma_2_2_2
  refuted_definition_2_1_9 refuted_corollary_3_1_3 loops_of_the_boundary.
Import ListNotations.

Open Scope Q_scope.

Lemma simple_chains_are_weakly_simple (chain : list vector) : simple chain -> weakly_simple chain.
Proof.
  intros (three & long & common). unfold weakly_simple. set (n := length chain) in *.
  assert (long_edge : forall i, (i < n)%nat -> nonzero (along (edge_at chain i))).
  { intros i I. apply long, in_map, nth_In. now rewrite edges_are_as_many. }
  assert (ends_ : forall i x, (i < n)%nat -> strictly_inside x (edge_at chain i) ->
    ~ equal_vectors x (vertex chain i) /\ ~ equal_vectors x (vertex chain (next i n))).
  { intros i x I inside_. pose proof (ends_are_not_inside _ x (long_edge i I) inside_) as none.
    rewrite edge_at_is in none by exact I. exact none. }
  split.
  - intros i j x I J differ [in_i in_j].
    destruct (common i j x I J differ (strictly_inside_lies_on _ _ in_i) (strictly_inside_lies_on _ _ in_j))
      as [[_ at_j] | [_ at_i]]; [exact (proj1 (ends_ j x J in_j) at_j) | exact (proj1 (ends_ i x I in_i) at_i)].
  - intros i j I J inside_. exfalso. destruct (ends_ j _ J inside_) as [no_source no_target].
    destruct (Nat.eq_dec i j) as [<- | differ]; [now apply no_source |].
    destruct (common i j (vertex chain i) I J differ) as [[_ at_j] | [is_next _]].
    + rewrite edge_at_is by exact I. apply (source_lies_on (Segment _ _)).
    + now apply strictly_inside_lies_on.
    + now apply no_source.
    + apply no_target. now rewrite <- is_next.
Qed.

Section Sum.
  Variables p q : region.
  Hypothesis p_region : valid_region p.
  Hypothesis q_region : valid_region q.
  Let loops := boundary_loops p q.

  (* Theorem. What is on the boundary of a face is on the boundary of the sum. *)
  Theorem boundaries_of_faces (a x : vector) : on_boundary_of_set (face_of_the_sum p q a) x -> on_boundary_of_sum x p q.
  Proof.
    intros boundary radius R. split.
    - destruct (boundary radius R) as [(y & close & path & walk) _]. exists y. split; [exact close |].
      destruct (leads_to_a_point _ _ _ _ walk) as (r & r_some & near). apply near. unfold within. lra.
    - destruct (on_or_off x (region_edges loops)) as [on | free].
      { apply (boundary_is_on_the_loops p q p_region q_region) in on. exact (proj2 (on radius R)). }
      destruct (off_the_loops p q p_region q_region x free) as [inner | (r & r_some & none)].
      + destruct (inner_points_are_on_no_boundary p q a x inner boundary).
      + exists x. split; [unfold within; lra |]. apply none. unfold within. lra.
  Qed.

  (* Theorem. To the left of an edge of a loop there is a face that it bounds. *)
  Theorem faces_beside_the_loops (e : segment) (x : vector) : In e (region_edges loops) -> strictly_inside x e ->
    exists a, 0 < area e a /\ inner_point_of_sum a p q /\ on_boundary_of_set (face_of_the_sum p q a) x.
  Proof.
    intros E inside_.
    destruct (loops_are_valid _ _ _ _ _ (boundary_loops_are_loops_of_the_sum p q p_region q_region)) as [valid above].
    pose proof (strictly_inside_lies_on _ _ inside_) as on.
    destruct (inside_beside_an_edge loops e x valid above E on (inside_no_vertex p q p_region q_region e x E inside_))
      as (radius & R & near).
    assert (inner : forall y, within radius x y -> 0 < area e y -> inner_point_of_sum y p q).
    { intros y close left_. destruct (proj2 (proj1 (near y close)) left_) as [free some].
      destruct (off_the_loops p q p_region q_region y free) as [| (r & r_some & none)]; [assumption | exfalso].
      apply (none y); [unfold within; lra |].
      apply (loops_fill_the_sum _ _ _ _ _ (boundary_loops_are_loops_of_the_sum p q p_region q_region)). now left. }
    set (n := Vector (- vy (along e)) (vx (along e))).
    pose proof (proj1 valid) as edges_.
    pose proof (left_normal e (winding_number_of_the_sum.region_edges_are_directions loops edges_ e E)) as turn.
    fold n in turn.
    assert (left_of : forall d, 0 < d -> 0 < area e (moved_along x n d)).
    { intros d some. rewrite (area_from x _ e on). setoid_replace (cross (along e) (minus (moved_along x n d) x))
        with (d * cross (along e) n) by (unfold cross, minus, moved_along; cbn [vx vy]; ring).
      now apply Qmult_lt_0_compat. }
    destruct (some_small _ (small_steps_stay_within radius x n R)) as (d & some & close).
    exists (moved_along x n d). split; [now apply left_of |]. split; [apply inner; auto |].
    intros r r_some. split.
    - destruct (some_small _ (eventually_and _ _ (small_steps_stay_within radius x n R)
        (small_steps_stay_within r x n r_some))) as (h & h_some & close_h & near_h).
      exists (moved_along x n h). split; [exact near_h |]. exists []. intros z on_way. apply inner.
      + exact (within_along radius x _ _ z close close_h on_way).
      + destruct on_way as (k & range & X & Y). cbn [source target] in X, Y.
        pose proof (left_of d some). pose proof (left_of h h_some).
        assert (value : area e z == (1 - k) * area e (moved_along x n d) + k * area e (moved_along x n h)).
        { set (u := moved_along x n d) in *. set (v := moved_along x n h) in *. clearbody u v.
          in_coordinates. rewrite X, Y. ring. }
        pose proof (mixed_is_more k (area e (moved_along x n d)) (area e (moved_along x n h)) 0 range ltac:(assumption)
          ltac:(assumption)). lra.
    - destruct (proj2 (boundary_is_on_the_loops p q p_region q_region x) (ex_intro _ e (conj E on)) r r_some)
        as [_ (y & near_y & outside)].
      exists y. split; [exact near_y |]. intros (path & walk).
      destruct (leads_to_a_point _ _ _ _ walk) as (s & s_some & near_s). apply outside, near_s. unfold within. lra.
  Qed.
End Sum.

(* Theorem, Corollary 3.1.3 as corrected. *)
Theorem corollary_3_1_3_as_corrected (p q : region) : valid_region p -> valid_region q ->
  exists chains : list (list vector),
    (forall chain, In chain chains -> weakly_simple chain) /\
    (forall a x, inner_point_of_sum a p q -> on_boundary_of_set (face_of_the_sum p q a) x -> on_boundary x chains) /\
    (forall e x, In e (region_edges chains) -> strictly_inside x e ->
       exists a, 0 < area e a /\ inner_point_of_sum a p q /\ on_boundary_of_set (face_of_the_sum p q a) x) /\
    (forall a b, In a chains -> In b chains -> a <> b -> meet_in_ends_only (edges a) (edges b) /\
       forall y z, on_one_of y (edges b) -> off y (edges a) -> on_one_of z (edges b) -> off z (edges a) ->
         winding_number y (edges a) = winding_number z (edges a)).
Proof.
  intros p_region q_region. exists (boundary_loops p q).
  pose proof (boundary_loops_do_not_cross p q p_region q_region) as (_ & are_simple & _ & apart_).
  split; [| split; [| split]].
  - intros chain C. apply simple_chains_are_weakly_simple. exact (are_simple chain C).
  - intros a x _ boundary. apply (boundary_is_on_the_loops p q p_region q_region).
    exact (boundaries_of_faces p q p_region q_region a x boundary).
  - exact (faces_beside_the_loops p q p_region q_region).
  - exact apart_.
Qed.
