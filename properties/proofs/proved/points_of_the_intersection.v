(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Points of the intersection of two simple polygons in general position: close to each are points inside both; so it is
   on a kept piece, or these go round it; and from there one comes straight ahead to a kept piece, inside both. *)
From Coq Require Import QArith Qminmax Lqa ZArith Lia Bool List Permutation.
From Oplus Require Import regions_and_sums small_numbers simple_chain left_of_an_edge interiors_meet valid_components
  inside_a_corner coordinates polygons_of_the_thesis connected_sets beside_a_piece filling first_on_the_way
  kept_pieces_go_round cut_pieces rule_of_sides region_of_pieces written_regions edges_of_polygons
  edges_of_the_intersection connected_beside_pieces no_holes_in_the_intersection.
Import ListNotations.

Open Scope Q_scope.

Lemma connected_with_itself (A : vector -> Prop) (v : vector) :
  (forall a b, equal_vectors a b -> A a -> A b) -> A v -> connected_in A v v.
Proof.
  intros equal in_. apply connected_by_a_step. intros z (k & _ & X & Y). apply (equal v); [| exact in_].
  cbn [source target] in *. split; [rewrite X | rewrite Y]; ring.
Qed.

Lemma connected_in_more (A B : vector -> Prop) (v w : vector) :
  (forall z, A z -> B z) -> connected_in A v w -> connected_in B v w.
Proof.
  intros more (path & walk). exists path. revert v walk.
  induction path as [| u rest IH]; intros v walk; cbn [leads_through] in *; [auto |]. destruct walk. split; auto.
Qed.

Lemma in_region_of_equal (r : region) (v w : vector) : equal_vectors v w -> in_region v r -> in_region w r.
Proof.
  intros equal [some | (s & S & on)].
  - left. destruct equal as [X Y]. now rewrite <- (winding_number_of_equal v w _ X Y).
  - right. exists s. split; [exact S | now apply (lies_on_equal v)].
Qed.

Lemma part_of_a_step (a b z w : vector) : lies_on z (Segment a b) -> lies_on w (Segment a z) -> lies_on w (Segment a b).
Proof.
  intros (k & range & X & Y) (h & range' & X' & Y'). cbn [source target] in *.
  exists (h * k). cbn [source target]. split; [split; nra |]. rewrite X', Y', X, Y. split; ring.
Qed.

Section TwoPolygons.
  Variables a b : list vector.
  Hypothesis a_polygon : simple_polygon a.
  Hypothesis b_polygon : simple_polygon b.
  Hypothesis a_off : vertices_are_off a b.
  Hypothesis b_off : vertices_are_off b a.
  Let kept := kept_boundary a b.
  Let ends_ := two_families_end a b a_polygon b_polygon.
  Let share := kept_share_ends _ _ _ ends_.

  Definition in_both (z : vector) : Prop := in_region z [a] /\ in_region z [b].

  Lemma in_each (c o : list vector) (z : vector) : one_and_other a b c o -> in_both z ->
    in_region z [c] /\ in_region z [o].
  Proof. intros [] [in_a in_b]; now split. Qed.

  Lemma in_both_of_equal (v w : vector) : equal_vectors v w -> in_both v -> in_both w.
  Proof. intros equal [in_a in_b]. split; now apply (in_region_of_equal _ v). Qed.

  Lemma kept_is_in_both (f : segment) (v : vector) : In f kept -> lies_on v f -> in_both v.
  Proof.
    intros F on. assert (each : forall c o, one_and_other a b c o -> in_region v [c]).
    { intros c o pair_. destruct (on_or_off v (region_edges [c])) as [on_c | free]; [now right | left].
      exact (kept_is_in_each a b a_polygon b_polygon a_off b_off c o f v pair_ F on free). }
    split; [exact (each a b (FirstOne a b)) | exact (each b a (SecondOne a b))].
  Qed.

  Lemma number_of_kept (z : vector) : winding_number z kept = 1%Z <->
    (0 < winding_number z (region_edges [a]))%Z /\ (0 < winding_number z (region_edges [b]))%Z.
  Proof.
    unfold kept, kept_boundary. rewrite (boundary_by_rule_goes_round boolean_operations.all_positive (two_families a b)
      (both_are_closed a b) (both_are_long a b a_polygon b_polygon) eq_refl z).
    rewrite <- (all_positive_of_two a b a b z (FirstOne a b)).
    destruct (by_rule _ _ z); cbn; split; intros; congruence || lia.
  Qed.

  (* Close to a point of the intersection are points inside both. *)
  Lemma inside_both_near (z : vector) (radius : Q) : in_both z -> 0 < radius ->
    exists y, within radius z y /\ winding_number y kept = 1%Z.
  Proof.
    intros in_ R.
    assert (one_only : forall c o, one_and_other a b c o -> on_one_of z (region_edges [c]) -> off z (region_edges [o])
      ->
      exists y, within radius z y /\ winding_number y kept = 1%Z).
    { intros c o pair_ (s & S & on) free. destruct (in_each c o z pair_ in_) as [_ [some | (t & T & on_t)]];
        [| destruct (free t T on_t)].
      destruct (winding_number_near z _ (region_cycles [o]) free) as (r & r_some & near).
      destruct (both_polygons a b a_polygon b_polygon c o pair_) as [polygon _].
      destruct (valid_is_regular [c] (simple_polygons_are_regions c polygon) z s (Qmin radius r) S on)
        as (y & close & _ & inside_); [now apply Q.min_glb_lt |].
      exists y. split; [exact (within_smaller _ _ _ _ (Q.le_min_l _ _) close) |]. apply number_of_kept.
      pose proof (proj2 (near y (within_smaller _ _ _ _ (Q.le_min_r _ _) close))) as same_.
      destruct pair_; rewrite same_; now split. }
    destruct (on_or_off z (region_edges [a])) as [on_a | free_a], (on_or_off z (region_edges [b])) as [on_b | free_b].
    - destruct on_a as (s & S & on_s), on_b as (t & T & on_t).
      destruct (edges_of_both_cross a b a_polygon b_polygon a_off b_off a b s t z (FirstOne a b) S T on_s on_t)
        as (in_s & in_t & turn).
      assert (exists n, 0 < cross (along s) n /\ 0 < cross (along t) n) as (n & left_s & left_t).
      { destruct (Qlt_le_dec 0 (cross (along s) (along t))) as [left_ | right_].
        - exists (minus (along t) (along s)). unfold cross, minus in *. cbn [vx vy] in *. split; lra.
        - exists (minus (along s) (along t)). unfold cross, minus in *. cbn [vx vy] in *. split; lra. }
      destruct (some_small _ (eventually_and _ _ (eventually_and _ _ (beside_an_edge a a_polygon s z n S in_s left_s)
        (beside_an_edge b b_polygon t z n T in_t left_t)) (small_steps_stay_within radius z n R)))
        as (d & _ & [[one _] [one' _]] & close).
      exists (moved_along z n d). split; [exact close |]. apply number_of_kept. rewrite one, one'. lia.
    - exact (one_only a b (FirstOne a b) on_a free_b).
    - exact (one_only b a (SecondOne a b) on_b free_a).
    - exists z. split; [unfold within; lra |]. apply number_of_kept.
      destruct in_ as [[some | (s & S & on)] [some' | (t & T & on')]]; [now split | ..]; exfalso;
        first [exact (free_b t T on') | exact (free_a s S on)].
  Qed.

  Lemma kept_is_closed : cycles kept.
  Proof. exact (cycles_permuted _ _ (chains_of_kept _ _ _ ends_) (region_cycles _)). Qed.

  Lemma on_the_boundary_or_inside (z : vector) : in_both z -> off z kept -> winding_number z kept = 1%Z.
  Proof.
    intros in_ free. destruct (winding_number_near z kept kept_is_closed free) as (radius & R & near).
    destruct (inside_both_near z radius in_ R) as (y & close & one). now rewrite <- (proj2 (near y close)).
  Qed.

  (* From each point one comes to the boundary. *)
  Lemma straight_to_the_boundary (z : vector) : in_both z ->
    exists f v, In f kept /\ lies_on v f /\ connected_in in_both z v.
  Proof.
    intros in_. destruct (on_or_off z kept) as [(f & F & on) | free].
    { exists f, z. split; [exact F |]. split; [exact on |]. apply connected_with_itself;
      [exact in_both_of_equal | exact in_]. }
    pose proof (on_the_boundary_or_inside z in_ free) as one.
    destruct (nothing_far_away_is_met kept) as (limit & far). set (m := Vector (limit + 1) 0).
    destruct (far m) as [_ none]; [cbn [m vx]; lra |]. set (u := minus m z).
    destruct (first_on_the_way z u kept) as [all | (k & t & T & [range on] & before)].
    - exfalso. rewrite <- (number_on_the_way z u kept 1 kept_is_closed ltac:(lra)) in one
        by (intros j low high; apply all; lra).
      rewrite (winding_number_of_equal _ m) in one; [lia | |]; unfold moved_along, u, minus; cbn [vx vy]; ring.
    - exists t, (moved_along z u k). split; [exact T |]. split; [exact on |]. apply connected_by_a_step.
      intros p (h & h_range & X & Y). cbn [source target] in X, Y.
      apply (in_both_of_equal (moved_along z u (h * k))).
      { unfold equal_vectors, moved_along in *. cbn [vx vy] in *. rewrite X, Y. split; ring. }
      destruct (Qlt_le_dec (h * k) k) as [less | last].
      + rewrite <- (number_on_the_way z u kept (h * k) kept_is_closed ltac:(nra)) in one
          by (intros j low high; apply before; lra).
        apply number_of_kept in one. split; left; apply one.
      + apply (kept_is_in_both t _ T), (lies_on_equal (moved_along z u k)); [| exact on].
        assert (there : h * k == k) by nra. unfold equal_vectors, moved_along. cbn [vx vy]. rewrite there. split; ring.
  Qed.
End TwoPolygons.
