(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* What oplus-proved computes, and what that is: the one place that says which functions the program is made of.
   Vertices of its regions may touch edges. *)
From Coq Require Import QArith ZArith Bool List Permutation.
From Oplus Require Import specification convolution regions winding_number_of_the_sum theorem_4_2_1
  specification_bridge homogeneous_points location pieces collision_is_complete checked_collision sum_program
  sum_of_uncovered_pieces touching_vertices complement_in_a_frame open_sum_program open_sums inner_fit_program
  inner_fit_is_right polygons canonical_chains canonical_regions walked_again boolean_operations complements openings
  simple_chain valid_components nested_polygons written_regions.
Import ListNotations.

(* Whether the theorems are about the region. *)
Definition is_covered (r : polygonal_region) : bool := covers_nothing_twice (as_region (prepared_region r)).

Lemma is_covered_is_right (r : polygonal_region) : is_covered r = true ->
  valid_region (as_region (prepared_region r)) /\ nowhere_above_one (as_region (prepared_region r)).
Proof. exact (covers_nothing_twice_is_right _). Qed.

(* Inner points stay inner points if vertices that touch edges become vertices of these. *)
Lemma prepared_inner_points (r : polygonal_region) (x : point) :
  is_inner_point x (prepared_region r) <-> is_inner_point x r.
Proof.
  destruct (divided_region (as_region r) (as_vector x)) as [same_points same_number].
  unfold prepared_region. rewrite inner_point_of_chains, inner_point_is, same_number.
  split; intros [round free]; (split; [exact round |]); intros s S on.
  - destruct (proj2 same_points) as (t & T & on_t); [now exists s | exact (free t T on_t)].
  - destruct (proj1 same_points) as (t & T & on_t); [now exists s | exact (free t T on_t)].
Qed.

(* Results as files have them. *)
Definition written_polygons : polygonal_region -> list polygon_with_holes := canonical_polygons.

Definition written_polygons_are_the_region := canonical_polygons_are_the_region.

(* Theorem. Of three vertices in a row, the first ones following the last, none is inside the edge that the others
   would have. *)
Theorem written_chains_are_straight (r : polygonal_region) (c before after : chain) (a v b : point) :
  In c (flat_map chains_of_polygon (written_polygons r)) -> c ++ c = before ++ a :: v :: b :: after ->
  is_on v (a, b) -> equal_points v a \/ equal_points v b.
Proof.
  intros C twice on. apply (Permutation_in _ (canonical_polygons_permute r)) in C.
  apply in_map_iff in C. destruct C as (d & <- & D). apply in_map_iff in D. destruct D as (ring & <- & _).
  apply (f_equal (map as_vector)) in twice.
  rewrite !map_app, map_map, (map_ext _ (fun u => u)), map_id in twice by (now intros []).
  destruct (in_a_row _ _ _ _ _ _ _ (written_ring_is_a_rotation ring) twice) as (before' & after' & twice').
  clear twice. rename twice' into twice.
  apply canonical_chain_is_straight in twice. unfold is_between_ends in twice.
  destruct (is_on_spec (as_vector v) (Segment (as_vector a) (as_vector b))) as [_ | off_]; [| destruct (off_ on)].
  destruct (same_point_spec (as_vector v) (as_vector a)) as [equal | _]; [now left |].
  destruct (same_point_spec (as_vector v) (as_vector b)) as [equal | _]; [now right | discriminate].
Qed.

(* The sum, as polygons with holes. *)
Definition proved_sum (p q : polygonal_region) : list polygon_with_holes :=
  written_polygons (quick_sum (prepared_region p) (prepared_region q)).

Definition region_of_polygons : list polygon_with_holes -> polygonal_region := flat_map chains_of_polygon.

(* Theorem. *)
Theorem proved_sum_is_the_sum (p q : polygonal_region) : is_covered p = true -> is_covered q = true ->
  is_minkowski_sum p q (region_of_polygons (proved_sum p q)).
Proof.
  intros p_valid q_valid x. apply is_covered_is_right in p_valid, q_valid. destruct p_valid, q_valid.
  unfold region_of_polygons, proved_sum. rewrite (proj1 (written_polygons_are_the_region _ x)).
  now apply sum_of_prepared_regions, quick_sum_is_the_sum.
Qed.

(* The single points of a set in order. *)
Definition open_in_order (s : open_region) : open_region :=
  OpenRegion (open_chains s) (dangling_edges s) (written_points (isolated_points s)).
Definition placements_in_order (f : placements) : placements :=
  Placements (fit_chains f) (fit_edges f) (written_points (fit_points f)).

Lemma in_order_is_the_same (s : open_region) (f : placements) (x : point) :
  (open_member x (open_in_order s) <-> open_member x s) /\ (fits x (placements_in_order f) <-> fits x f).
Proof.
  pose proof (written_points_are (isolated_points s) x) as of_open.
  pose proof (written_points_are (fit_points f) x) as of_fit.
  split; [| unfold fits, placements_in_order; cbn [fit_chains fit_edges fit_points]; now rewrite of_fit].
  assert (none : forall l, (forall v, In v l -> ~ equal_points x v) <-> ~ exists v, In v l /\
    equal_points x v) by firstorder.
  unfold open_member, open_in_order. cbn [open_chains dangling_edges isolated_points]. now rewrite !none, of_open.
Qed.

Definition proved_open_sum (p q : polygonal_region) : open_region :=
  open_in_order (open_sum_of_regions (prepared_region p) (prepared_region q)).

(* Theorem. *)
Theorem proved_open_sum_is_the_open_sum (p q : polygonal_region) : is_covered p = true -> is_covered q = true ->
  is_open_sum p q (proved_open_sum p q).
Proof.
  intros p_valid q_valid x. apply is_covered_is_right in p_valid, q_valid. destruct p_valid, q_valid.
  unfold proved_open_sum. rewrite (proj1 (in_order_is_the_same _ (Placements [] [] []) x)).
  etransitivity; [apply (open_sum_of_regions_is_the_open_sum (prepared_region p)
    (prepared_region q)); trivial |].
  split; intros (a & b & in_p & in_q & equal); exists a, b; rewrite !prepared_inner_points in *; tauto.
Qed.

Definition proved_no_fit (a b : polygonal_region) : open_region :=
  open_in_order (no_fit (prepared_region a) (prepared_region b)).

(* Theorem. *)
Theorem proved_no_fit_is_the_no_fit (a b : polygonal_region) : is_covered a = true -> is_covered b = true ->
  is_no_fit a b (proved_no_fit a b).
Proof.
  intros a_valid b_valid x. apply is_covered_is_right in a_valid, b_valid. destruct a_valid, b_valid.
  unfold proved_no_fit. rewrite (proj1 (in_order_is_the_same _ (Placements [] [] []) x)).
  etransitivity; [apply (no_fit_is_the_no_fit (prepared_region a) (prepared_region b));
    trivial |].
  split; intros (y & z & in_a & in_b & equal); exists y, z; rewrite !prepared_inner_points in *; tauto.
Qed.

Definition has_points (r : polygonal_region) : bool :=
  match concat (prepared_region r) with [] => false | _ => true end.

Lemma has_points_is (r : polygonal_region) : has_points r = true ->
  exists c v, In c (prepared_region r) /\ In v c.
Proof.
  unfold has_points. intros some. destruct (concat (prepared_region r)) as [| v rest] eqn:vertices; [discriminate |].
  destruct (proj1 (in_concat (prepared_region r) v)) as (c & C & V); [rewrite vertices; now left | now exists c, v].
Qed.

Definition proved_inner_fit (a b : polygonal_region) : placements :=
  placements_in_order (inner_fit (prepared_region a) (prepared_region b)).

(* Theorem. *)
Theorem proved_inner_fit_is_the_inner_fit (a b : polygonal_region) : is_covered a = true -> is_covered b = true ->
  has_points b = true -> is_inner_fit a b (proved_inner_fit a b).
Proof.
  intros a_valid b_valid some x. apply is_covered_is_right in a_valid, b_valid. destruct a_valid, b_valid.
  unfold proved_inner_fit. rewrite (proj2 (in_order_is_the_same (OpenRegion [] [] []) _ x)).
  destruct (inner_fit_is_the_inner_fit (prepared_region a) (prepared_region b)) as [is_fit _];
    trivial; [now apply has_points_is |].
  etransitivity; [apply is_fit |]. split; intros all y; specialize (all y); unfold prepared_region in *;
    rewrite !touching_vertices_add_no_points in *; exact all.
Qed.

(* The chains of an open region, and of placements, as polygons with holes. *)
Definition polygons_of_open (s : open_region) : list polygon_with_holes := written_polygons (open_chains s).
Definition polygons_of_placements (f : placements) : list polygon_with_holes := written_polygons (walked_again
  (fit_chains f)).

(* Theorem. They are the chains: the points of placements, and the inner points of an open region, stay. *)
Theorem canonical_chains_are_the_chains (s : open_region) (f : placements) (x : point) :
  (is_inner_point x (region_of_polygons (polygons_of_open s)) <-> is_inner_point x (open_chains s)) /\
  (member x (region_of_polygons (polygons_of_placements f)) <-> member x (fit_chains f)).
Proof.
  split; [apply written_polygons_are_the_region |].
  etransitivity; [apply written_polygons_are_the_region | apply walked_again_has_the_points].
Qed.

(* Union, intersection and difference of regions. *)
Definition of_prepared (operation : polygonal_region -> polygonal_region -> polygonal_region)
  (p q : polygonal_region) : list polygon_with_holes :=
  written_polygons (operation (prepared_region p) (prepared_region q)).

Definition proved_union : polygonal_region -> polygonal_region -> list polygon_with_holes := of_prepared union.
Definition proved_intersection : polygonal_region -> polygonal_region -> list polygon_with_holes :=
  of_prepared intersection_of_regions.
Definition proved_difference : polygonal_region -> polygonal_region -> list polygon_with_holes :=
  of_prepared difference.

Lemma same_closure (A B : point -> Prop) (x : point) : (forall y, A y <-> B y) ->
  (closure (interior A) x <-> closure (interior B) x).
Proof. intros same. split; apply more_closure; intros y; apply same. Qed.

(* Theorem. *)
Theorem proved_booleans_are_right (p q : polygonal_region) : is_covered p = true -> is_covered q = true ->
  is_union p q (region_of_polygons (proved_union p q)) /\
  is_intersection p q (region_of_polygons (proved_intersection p q)) /\
  is_difference p q (region_of_polygons (proved_difference p q)).
Proof.
  intros p_valid q_valid. apply is_covered_is_right in p_valid, q_valid.
  destruct p_valid as [p_valid _], q_valid as [q_valid _].
  assert (same_p : forall y, member y (prepared_region p) <-> member y p) by apply touching_vertices_add_no_points.
  assert (same_q : forall y, member y (prepared_region q) <-> member y q) by apply touching_vertices_add_no_points.
  split; [| split]; intros x; (etransitivity; [apply written_polygons_are_the_region |]).
  - rewrite (union_is_the_union _ _ p_valid q_valid x). now rewrite same_p, same_q.
  - rewrite (intersection_is_the_intersection _ _ p_valid q_valid x). apply same_closure.
    intros y. now rewrite same_p, same_q.
  - rewrite (difference_is_the_difference _ _ p_valid q_valid x). apply same_closure.
    intros y. now rewrite same_p, same_q.
Qed.

Lemma results_are_read_again (p q : polygonal_region) : is_covered p = true -> is_covered q = true ->
  forall polygons, In polygons [proved_sum p q; polygons_of_open (proved_open_sum p q);
    polygons_of_open (proved_no_fit p q); proved_union p q; proved_intersection p q; proved_difference p q] ->
  is_covered (region_of_polygons polygons) = true /\
  (forall c, In c (region_of_polygons polygons) -> is_simple_chain c) /\ valid_components (map component_of polygons).
Proof.
  intros p_valid q_valid polygons. apply is_covered_is_right in p_valid, q_valid.
  destruct p_valid as [p_valid _], q_valid as [q_valid q_above].
  pose proof (two_are_closed (prepared_region p) (prepared_region q)) as closed.
  pose proof (two_are_long (prepared_region p) (prepared_region q) p_valid q_valid) as long.
  pose proof (half_turned_is_valid _ q_valid q_above) as [turned _].
  intros [<- | [<- | [<- | [<- | [<- | [<- | []]]]]]].
  - exact (sums_are_read_again _ _ p_valid q_valid).
  - exact (sums_are_read_again _ _ p_valid q_valid).
  - exact (sums_are_read_again _ _ p_valid turned).
  - exact (regions_by_rule_are_read_again some_positive _ closed long eq_refl).
  - exact (regions_by_rule_are_read_again all_positive _ closed long eq_refl).
  - exact (regions_by_rule_are_read_again first_positive _ closed long eq_refl).
Qed.

(* Theorem. What is written of these has simple chains: they pass no point twice, and only edges that follow each other
   meet. *)
Theorem results_are_simple (p q : polygonal_region) : is_covered p = true -> is_covered q = true ->
  forall polygons c, In polygons [proved_sum p q; polygons_of_open (proved_open_sum p q);
    polygons_of_open (proved_no_fit p q); proved_union p q; proved_intersection p q; proved_difference p q] ->
  In c (region_of_polygons polygons) -> is_simple_chain c.
Proof. intros p_valid q_valid polygons c which. now apply (results_are_read_again p q p_valid q_valid). Qed.

(* Theorem. What is written of these is accepted again; of the sets that are open, their chains are. *)
Theorem results_are_covered (p q : polygonal_region) : is_covered p = true -> is_covered q = true ->
  forall polygons, In polygons [proved_sum p q; polygons_of_open (proved_open_sum p q); polygons_of_open
    (proved_no_fit p q);
    proved_union p q; proved_intersection p q; proved_difference p q] ->
  is_covered (region_of_polygons polygons) = true.
Proof. intros p_valid q_valid polygons which. now apply (results_are_read_again p q p_valid q_valid). Qed.

(* Theorem. What is written of these are valid components: outer chains, counterclockwise, each with its holes,
   clockwise, inside it and beside each other, and the components beside each other. *)
Theorem results_are_valid_components (p q : polygonal_region) : is_covered p = true -> is_covered q = true ->
  forall polygons, In polygons [proved_sum p q; polygons_of_open (proved_open_sum p q);
    polygons_of_open (proved_no_fit p q); proved_union p q; proved_intersection p q; proved_difference p q] ->
  valid_components (map component_of polygons).
Proof. intros p_valid q_valid polygons which. now apply (results_are_read_again p q p_valid q_valid). Qed.

(* Erosion, opening and closing, of a region that has points. *)
Definition proved_erosion : polygonal_region -> polygonal_region -> list polygon_with_holes := of_prepared erosion.
Definition proved_opening : polygonal_region -> polygonal_region -> list polygon_with_holes := of_prepared opening.
Definition proved_closing : polygonal_region -> polygonal_region -> list polygon_with_holes := of_prepared closing.

(* Theorem. *)
Theorem proved_erosion_opening_and_closing_are_right (p q : polygonal_region) :
  is_covered p = true -> is_covered q = true -> has_points q = true ->
  is_erosion p q (region_of_polygons (proved_erosion p q)) /\
  is_opening p q (region_of_polygons (proved_opening p q)) /\
  is_closing p q (region_of_polygons (proved_closing p q)).
Proof.
  intros p_valid q_valid some%has_points_is. apply is_covered_is_right in p_valid, q_valid.
  destruct p_valid as [p_valid p_simple], q_valid as [q_valid q_simple].
  assert (same_p : forall y, member y (prepared_region p) <-> member y p) by apply touching_vertices_add_no_points.
  assert (same_q : forall y, member y (prepared_region q) <-> member y q) by apply touching_vertices_add_no_points.
  split; [| split]; intros x; (etransitivity; [apply written_polygons_are_the_region |]).
  - rewrite (erosion_is_the_erosion _ _ p_valid p_simple q_valid q_simple some x). apply same_closure.
    intros y. unfold is_moved_into. setoid_rewrite same_p. setoid_rewrite same_q. reflexivity.
  - rewrite (opening_is_the_opening _ _ p_valid p_simple q_valid q_simple some x).
    unfold is_moved_into. setoid_rewrite same_p. setoid_rewrite same_q. reflexivity.
  - rewrite (closing_is_the_closing _ _ p_valid q_valid q_simple some x). apply same_closure.
    intros y. unfold is_moved_into. setoid_rewrite same_p. setoid_rewrite same_q. reflexivity.
Qed.

Lemma erosions_openings_and_closings_are_read_again (p q : polygonal_region) :
  is_covered p = true -> is_covered q = true -> has_points q = true ->
  forall polygons, In polygons [proved_erosion p q; proved_opening p q; proved_closing p q] ->
  is_covered (region_of_polygons polygons) = true /\
  (forall c, In c (region_of_polygons polygons) -> is_simple_chain c) /\ valid_components (map component_of polygons).
Proof.
  intros [p_valid p_simple]%is_covered_is_right [q_valid q_simple]%is_covered_is_right some%has_points_is polygons.
  destruct (quick_sum_is_valid _ _ p_valid q_valid) as [sum_valid sum_simple].
  intros [<- | [<- | [<- | []]]]; refine (regions_by_rule_are_read_again some_nonzero _ _ _ (nothing_is_zero _)).
  - exact (fit_edges_are_closed _ _).
  - exact (fit_edges_are_long _ _ p_valid p_simple q_valid q_simple some).
  - exact (families_are_closed _ _).
  - exact (families_are_long _ _ p_valid p_simple q_valid q_simple some).
  - exact (fit_edges_are_closed _ _).
  - exact (fit_edges_are_long _ _ sum_valid sum_simple q_valid q_simple some).
Qed.

(* Theorem. What is written of these is accepted again, and its chains are simple. *)
Theorem erosions_openings_and_closings_are_covered (p q : polygonal_region) :
  is_covered p = true -> is_covered q = true -> has_points q = true ->
  forall polygons, In polygons [proved_erosion p q; proved_opening p q; proved_closing p q] ->
  is_covered (region_of_polygons polygons) = true /\ forall c, In c (region_of_polygons polygons) -> is_simple_chain c.
Proof.
  intros p_valid q_valid some polygons which.
  destruct (erosions_openings_and_closings_are_read_again p q p_valid q_valid some polygons which) as (yes & all & _).
  now split.
Qed.

(* Theorem. It is valid components, too. *)
Theorem erosions_openings_and_closings_are_valid_components (p q : polygonal_region) :
  is_covered p = true -> is_covered q = true -> has_points q = true ->
  forall polygons, In polygons [proved_erosion p q; proved_opening p q; proved_closing p q] ->
  valid_components (map component_of polygons).
Proof.
  intros p_valid q_valid some polygons which.
  now apply (erosions_openings_and_closings_are_read_again p q p_valid q_valid some).
Qed.

(* What is unbounded, as the holes in it, and what is in these. *)
Definition unbounded_polygons := (list chain * list polygon_with_holes)%type.
Definition region_of_unbounded (s : unbounded_polygons) : polygonal_region := fst s ++ region_of_polygons (snd s).

Definition written_unbounded (r : polygonal_region) : unbounded_polygons :=
  let (polygons, holes) := partition (fun p => is_outer_chain (fst p)) (written_polygons r) in
  (region_of_polygons holes, polygons).

Lemma written_unbounded_is_the_region (r : polygonal_region) (x : point) :
  unbounded_member x (region_of_unbounded (written_unbounded r)) <-> unbounded_member x r.
Proof.
  rewrite !unbounded_member_is. apply not_iff_compat. unfold written_unbounded, region_of_unbounded.
  transitivity (is_inner_point x (region_of_polygons (written_polygons r)));
    [| apply written_polygons_are_the_region].
  apply chains_in_another_order. unfold region_of_polygons. generalize (written_polygons r). intros all.
  unfold polygon_with_holes in *. destruct (partition _ all) as [polygons holes] eqn:parts. cbn [fst snd].
  rewrite <- flat_map_app. apply Permutation_flat_map. rewrite (partition_permutes _ _ _ _ parts).
  apply Permutation_app_comm.
Qed.

Definition proved_complement (p : polygonal_region) : unbounded_polygons :=
  written_unbounded (walked_again (turned_region (as_region (prepared_region p)))).

(* Theorem. *)
Theorem proved_complement_is_the_complement (p : polygonal_region) : is_covered p = true ->
  is_complement p (region_of_unbounded (proved_complement p)).
Proof.
  intros [valid simple]%is_covered_is_right x. unfold proved_complement.
  rewrite written_unbounded_is_the_region, unbounded_member_is, (proj2 (walked_again_has_the_points _ x)),
    <- unbounded_member_is, (turned_region_is_the_complement _ valid simple x).
  unfold closure, prepared_region. now setoid_rewrite touching_vertices_add_no_points.
Qed.

(* Whether the theorems are about the unbounded region. *)
Definition is_covered_unbounded (u : polygonal_region) : bool :=
  covers_nothing_twice (framed (with_touching_vertices (as_region u))).

Definition proved_complement_of_unbounded (u : polygonal_region) : list polygon_with_holes :=
  written_polygons (walked_again (turned_region (with_touching_vertices (as_region u)))).

(* Theorem. And in any square around x, the unbounded region is the bounded one with the square as its outer chain. *)
Theorem proved_complement_of_unbounded_is_the_complement (u : polygonal_region) : is_covered_unbounded u = true ->
  is_complement_of_unbounded u (region_of_polygons (proved_complement_of_unbounded u)) /\
  forall k x, - k < x_of x < k -> - k < y_of x < k ->
    (member x (map as_point (frame k) :: prepared_region u) <-> unbounded_member x u).
Proof.
  intros [valid simple]%covers_nothing_twice_is_right.
  assert (same : forall x, unbounded_member x (prepared_region u) <-> unbounded_member x u).
  { intros x. rewrite !unbounded_member_is. apply not_iff_compat, prepared_inner_points. }
  split.
  - intros x. unfold proved_complement_of_unbounded.
    rewrite (proj1 (written_polygons_are_the_region _ x)), (proj1 (walked_again_has_the_points _ x)),
      (turned_region_is_the_complement_of_unbounded _ valid simple x).
    change (as_polygonal _) with (prepared_region u). unfold closure. now setoid_rewrite same.
  - intros k x in_x in_y. rewrite <- same. exact (the_frame_does_not_matter _ valid simple k x in_x in_y).
Qed.
