(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Section 5.1.2 as printed: two hierarchies of bounding boxes, of the edges of P and of those of -Q, are built once;
  for
   each x, with the second one moved by x, they decide whether P and -Q + x collide.
     The collision test looks only at the
   pairs of edges that they find. Edges of a simple polygon are not cut by each other, so the pieces that the test is
   about are the edges; the rest is in collision_by_found_pairs.v. *)
From Coq Require Import ZArith Lia Bool List.
From Oplus Require Import numbers regions_and_sums reflected simple_chain polygons_of_the_thesis location pieces
  met_pieces reflected_polygons naive_collision placed_collision interiors_meet pairs_of_edges collision_by_pairs
    collision_by_found_pairs.
Import ListNotations.

Open Scope Q_scope.

(* What is met at its ends only is not cut. *)
Lemma not_cut (e : segment) (l : list segment) : nonzero (along e) ->
  (forall t q, In t l -> In q (intersection e t) -> equal_vectors q (source e) \/ equal_vectors q (target e)) ->
  cut_where_met e l = [e].
Proof.
  intros long at_ends. unfold cut_where_met, cut, points_along.
  assert (none : filter (fun p => negb (same_point p (source e)) && negb (same_point p (target e)) && is_on_segment p e)
    (flat_map (intersection e) l) = []).
  { assert (all : forall q, In q (flat_map (intersection e) l) ->
      equal_vectors q (source e) \/ equal_vectors q (target e)).
    { intros q I. apply in_flat_map in I. destruct I as (t & T & I). exact (at_ends t q T I). }
    induction (flat_map (intersection e) l) as [| q m IH]; [reflexivity |]. cbn [filter].
    rewrite IH by (intros p P; apply all; now right). specialize (all q (or_introl eq_refl)).
    destruct (same_point_spec q (source e)), (same_point_spec q (target e)); cbn [negb andb]; try reflexivity.
    tauto. }
  rewrite none. cbn [app sorted_points fold_right insert_point].
  assert (differ : ~ equal_vectors (source e) (target e)).
  { intros [X Y]. apply long. unfold along, minus. cbn [vx vy]. split; lra. }
  destruct (compare_points_spec (source e) (target e)) as [equal | before | after];
    destruct (compare_points_spec (target e) (source e)) as [equal' | before' | after'];
    try contradiction; try (exfalso; unfold comes_first, equal_vectors in *; lra); destruct e; reflexivity.
Qed.

Lemma edges_of_simple_polygons_are_not_cut (c : list vector) : simple_polygon c ->
  boundary_pieces [c] = region_edges [c].
Proof.
  intros [(_ & long & common) _]. unfold boundary_pieces.
  assert (each : forall e, In e (region_edges [c]) -> cut_where_met e (region_edges [c]) = [e]).
  { intros e E. destruct (edge_by_chain [c] e E) as (d & i & [<- | []] & I & ->).
    pose proof (edges_of_simple_chains c i long I) as e_long.
    assert (e_is : along (edge_at c i) = minus (vertex c (fiber_grid.next i (length c))) (vertex c i))
      by now rewrite edge_is.
    apply not_cut; [now rewrite e_is |]. intros t q T Q. destruct (edge_by_chain [c] t T) as (d & j & [<- | []] & J &
      ->).
    destruct (intersection_is_on_both _ _ q Q) as (on_i & on_j & which).
    destruct (Nat.eq_dec i j) as [<- | other].
    - destruct which as [[-> | [-> | [-> | ->]]] | turn]; try (left; reflexivity); try (right; reflexivity).
      exfalso. apply turn. unfold cross. ring.
    - rewrite edge_is by exact I. cbn [source target].
      destruct (common i j q I J other on_i on_j) as [[-> at_j] | [-> at_i]]; [now right | now left]. }
  enough (all : forall l, incl l (region_edges [c]) ->
    flat_map (fun e => cut_where_met e (region_edges [c])) l = l) by apply all, incl_refl.
  induction l as [| e l IH]; intros part; [reflexivity |]. cbn [flat_map]. rewrite each by (apply part; now left).
  cbn [app]. f_equal. apply IH. intros f F. apply part. now right.
Qed.

(* Theorem, Section 5.1.2. *)
Theorem section_5_1_2_as_printed (p q : list vector) (t u : hierarchy) :
  simple_polygon p -> simple_polygon q -> is_boxed t -> is_boxed u ->
  edges_of_hierarchy t = region_edges [p] ->
  edges_of_hierarchy u = map (reflected (Vector 0 0)) (region_edges [q]) ->
  forall x, collide_among (is_among_the_pairs x (pairs_by_hierarchy x (meets_moved x) t u)) [p] (placed x [q]) = true
    <->
    interiors_meet x [p] [q].
Proof.
  intros p_polygon q_polygon T U edges_t edges_u x.
  apply collision_by_hierarchies_in_any_position; trivial;
    try (now apply simple_polygons_are_regions); try (now apply simple_polygons_cover_nothing_twice).
  - intros s. rewrite edges_t, edges_of_simple_polygons_are_not_cut by exact p_polygon. trivial.
  - intros f F. assert (pieces_are : boundary_pieces (placed x [q]) = map (reflected x) (region_edges [q])).
    { change (placed x [q]) with [reflected_polygon x q].
      rewrite edges_of_simple_polygons_are_not_cut by exact (reflected_polygon_is_one x q q_polygon).
      exact (edges_of_placed x [q]). }
    rewrite pieces_are in F. apply in_map_iff in F. destruct F as (e & <- & E).
    exists (reflected (Vector 0 0) e). rewrite edges_u. split; [now apply in_map |].
    unfold is_moved, equal_vectors, reflected, plus, minus. cbn [source target vx vy]. repeat split; ring.
Qed.
