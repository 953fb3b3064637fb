(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The chains that bound the intersection of two simple polygons in general position (boundary_of_the_intersection.v)
   are simple: at each place one kept piece starts, so they pass no point twice. So the winding number of the original
   convolution is the number of outer chains less that of holes. *)
From Coq Require Import QArith Lqa ZArith Lia Bool List Permutation.
From Oplus Require Import convolution regions meeting_of_segments simple_chain theorem_4_2_1 polygons_of_the_thesis
  placed_collision met_pieces interiors_meet region_size size_of_valid_regions replaced_segments filling walks
  kept_pieces_go_round region_of_pieces edges_of_polygons edges_of_the_intersection corners_of_the_intersection
  starts_of_kept_pieces corners_of_chains places_of_corners reflected_polygons boundary_of_the_intersection.
Import ListNotations.

Open Scope Q_scope.

Lemma chains_are_not_empty : forall fuel l c, In c (chains_of fuel l) -> c <> [].
Proof.
  induction fuel as [| fuel IH]; intros l c C; [destruct C |]. destruct l as [| e l]; [destruct C |].
  cbn [chains_of] in C.
  destruct (walk (length l) e e l) as [chain others]. destruct C as [<- | C]; [discriminate | exact (IH _ _ C)].
Qed.

Section TwoPolygons.
  Variables a b : list vector.
  Hypothesis a_polygon : simple_polygon a.
  Hypothesis b_polygon : simple_polygon b.
  Hypothesis a_off : vertices_are_off a b.
  Hypothesis b_off : vertices_are_off b a.
  Variable do_cross : nat -> nat -> bool.
  Hypothesis crossings : forall i j, (i < length a)%nat -> (j < length b)%nat ->
    do_cross i j = true <-> exists v, lies_on v (edge_at a i) /\ lies_on v (edge_at b j).

  Lemma one_piece_starts (g f g' f' : segment) : In g (kept_boundary a b) -> In f (kept_boundary a b) ->
    In g' (kept_boundary a b) -> In f' (kept_boundary a b) -> target g = source f -> target g' = source f' ->
    equal_vectors (source f) (source f') -> f = f'.
  Proof.
    intros G F G' F' meets meets' same_.
    destruct (each_corner_has_a_place a b a_polygon b_polygon a_off b_off do_cross crossings g f G F meets)
      as (p & P & at_p & part & _).
    destruct (each_corner_has_a_place a b a_polygon b_polygon a_off b_off do_cross crossings g' f' G' F' meets')
      as (p' & P' & at_p' & part' & _). cbn [snd] in *.
    assert (at_p'' : is_at a b (source f) p').
    { destruct p' as [of_first i | i j]; cbn [is_at] in *.
      - now rewrite same_.
      - split; apply (lies_on_equal (source f')); try (now symmetry); apply at_p'. }
    pose proof (one_place_there a b a_polygon b_polygon a_off b_off do_cross (source f) p p' P P' at_p at_p'') as p_is.
    subst p'. apply (one_kept_piece_starts a b a_polygon b_polygon f f' (edge_from a b p)); trivial.
    exact (edges_from_are_long a b a_polygon b_polygon do_cross p P).
  Qed.

  (* Theorem. *)
  Theorem kept_chains_are_simple (r : region) (c : list vector) : Permutation (region_edges r) (kept_boundary a b) ->
    In c r -> c <> [] -> simple c.
  Proof.
    intros edges_are C some.
    pose proof (kept_share_ends _ _ _ (two_families_end a b a_polygon b_polygon)) as share.
    assert (edge_kept : forall i, (i < length c)%nat -> In (edge_at c i) (kept_boundary a b)).
    { intros i I. apply (Permutation_in _ edges_are). now apply edge_at_in_region. }
    assert (distinct_ : NoDup (edges c)).
    { assert (all : NoDup (region_edges r)) by (apply (Permutation_NoDup (Permutation_sym edges_are)),
        (are_distinct _ share)).
      clear - C all. induction r as [| d r IH]; [destruct C |]. unfold region_edges in *. cbn [flat_map] in all.
      destruct C as [-> | C]; [| apply IH; [exact C |]].
      - clear - all. induction (edges c) as [| e l IH]; [constructor |]. inversion all as [| ? ? new rest]; subst.
        constructor; [intros I; apply new, in_app_iff; now left | now apply IH].
      - clear - all. induction (edges d) as [| e l IH]; [exact all |]. inversion all. now apply IH. }
    assert (edges_differ : forall i j, (i < length c)%nat -> (j < length c)%nat -> edge_at c i = edge_at c j -> i = j).
    { intros i j I J same_. apply (proj1 (NoDup_nth (edges c) no_segment) distinct_);
        [now rewrite edges_are_as_many | now rewrite edges_are_as_many | exact same_]. }
    assert (ends_of : forall i, (i < length c)%nat ->
      source (edge_at c i) = vertex c i /\ target (edge_at c i) = vertex c (next i (length c)))
      by (intros i I; rewrite edge_is by exact I; now split).
    assert (one_vertex_each : forall i j, (i < length c)%nat -> (j < length c)%nat ->
      equal_vectors (vertex c i) (vertex c j) -> i = j).
    { intros i j I J same_. apply edges_differ; trivial.
      pose proof (previous_below _ i I) as I'. pose proof (previous_below _ j J) as J'.
      apply (one_piece_starts (edge_at c (previous (length c) i)) _ (edge_at c (previous (length c) j))); auto.
      - destruct (ends_of i I) as [-> _], (ends_of _ I') as [_ ->]. now rewrite next_previous.
      - destruct (ends_of j J) as [-> _], (ends_of _ J') as [_ ->]. now rewrite next_previous.
      - destruct (ends_of i I) as [-> _], (ends_of j J) as [-> _]. exact same_. }
    assert (long : forall i, (i < length c)%nat -> nonzero (along (edge_at c i)))
      by (intros i I; exact (are_long _ share _ (edge_kept i I))).
    assert (at_ends : forall i j x, (i < length c)%nat -> (j < length c)%nat -> i <> j ->
      lies_on x (edge_at c i) -> lies_on x (edge_at c j) ->
      equal_vectors x (vertex c i) \/ equal_vectors x (vertex c (next i (length c)))).
    { intros i j x I J differ on_i on_j. destruct (ends_of i I) as [<- <-].
      destruct (inside_or_end x (edge_at c i) on_i) as [inside_ | [equal | equal]]; [exfalso | left;
        now symmetry | right; now symmetry].
      apply (nothing_inside _ share (edge_at c i) (edge_at c j) x); auto. }
    assert (three : (3 <= length c)%nat).
    { destruct c as [| u [| v [| w rest]]]; [contradiction | exfalso | exfalso | cbn; lia].
      - apply (long 0%nat ltac:(cbn; lia)). unfold edge_at, along, minus. cbn. split; ring.
      - pose proof (edge_kept 0%nat ltac:(cbn; lia)) as first_. pose proof (edge_kept 1%nat ltac:(cbn; lia)) as second_.
        assert (differ : edge_at [u; v] 0 <> edge_at [u; v] 1).
        { intros same_. specialize (edges_differ 0%nat 1%nat ltac:(cbn; lia) ltac:(cbn; lia) same_). discriminate. }
        apply (nothing_inside _ share _ _ (beside_a_piece.point_at (edge_at [u; v] 0) (1 # 2)) first_ second_ differ).
        + exists (1 # 2). split; [lra |]. unfold edge_at, beside_a_piece.point_at. cbn. split; ring.
        + apply beside_a_piece.strictly_inside_at. lra. }
    split; [exact three |]. split.
    - intros e I. apply (In_nth _ _ nowhere) in I. destruct I as (i & I & <-). rewrite edges_length in I.
      fold (edge_of_chain c i). rewrite edge_of_chain_joins_vertices by exact I.
      destruct (ends_of i I) as [source_is target_is].
      pose proof (long i I) as some_i. unfold along in some_i. now rewrite source_is, target_is in some_i.
    - intros i j x I J differ on_i on_j. pose proof (next_in_range i _ I) as I'. pose proof (next_in_range j _ J) as J'.
      destruct (at_ends i j x I J differ on_i on_j) as [x_i | x_i],
        (at_ends j i x J I (not_eq_sym differ) on_j on_i) as [x_j | x_j].
      + destruct differ. apply one_vertex_each; trivial. now rewrite <- x_i.
      + right. split; [| exact x_i]. apply one_vertex_each; trivial. now rewrite <- x_i.
      + left. split; [| exact x_j]. apply one_vertex_each; trivial. now rewrite <- x_j.
      + exfalso. apply differ. rewrite <- (previous_next i _ I), <- (previous_next j _ J). f_equal.
        apply one_vertex_each; trivial. now rewrite <- x_i.
  Qed.
End TwoPolygons.

(* Theorem 4.2.14 with the boundary of the intersection constructed, for two simple polygons and x in general position:
   it is a valid region of simple chains that has the points inside both P and -Q + x, and no others; and the winding
   number of the original convolution at x is the number of its outer chains less that of its holes. *)
Theorem theorem_4_2_14_with_the_boundary_constructed (p q : list vector) (x : vector) :
  simple_polygon p -> simple_polygon q -> off_vertex_edge_sum x [p] [q] ->
  exists r, valid_region r /\ (forall chain, In chain r -> simple chain) /\
    (forall y, winding_number y (region_edges r) = 1%Z <->
       (0 < winding_number y (region_edges [p]))%Z /\ (0 < winding_number y (region_edges (placed x [q])))%Z) /\
    winding_number x (original_convolution [p] [q]) = (outer_chains r - holes r)%Z.
Proof.
  intros p_polygon q_polygon general. set (b := reflected_polygon x q).
  pose proof (reflected_polygon_is_one x q q_polygon) as b_polygon.
  destruct (winding_number_of_the_constructed_intersection p q x p_polygon q_polygon general) as (valid & points &
    number).
  fold b in valid, points, number. set (r := chains_of (length (kept_boundary p b)) (kept_boundary p b)) in *.
  assert (edges_are : Permutation (region_edges r) (kept_boundary p b))
    by exact (chains_of_kept _ _ _ (two_families_end p b p_polygon b_polygon)).
  assert (all_simple : forall chain, In chain r -> simple chain).
  { intros chain C. apply (kept_chains_are_simple p b p_polygon b_polygon (p_off_b p q x general) (b_off_p p q x
      general)
      (edges_do_cross p q x) (edges_do_cross_is_right p q x p_polygon q_polygon general) r chain edges_are C).
    exact (chains_are_not_empty _ _ chain C). }
  exists r. split; [exact valid |]. split; [exact all_simple |]. split; [exact points |].
  now rewrite number, turning_numbers_of_simple_chains.
Qed.
