(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The intersection of two simple polygons has no holes. Chains of its boundary are in both polygons. A point that is
   not in one of these is connected with points far away by a path outside it (inside_and_outside.v), which meets none
   of the chains: so none goes round the point. But the points just right of a chain's edge are not in both; so the
   chain goes round what is on its left, counterclockwise. *)
From Coq Require Import QArith Qminmax Lqa ZArith Lia Bool List Permutation.
From Oplus Require Import regions_and_sums small_numbers simple_chain simple_chains_turn_once
  winding_numbers_of_simple_chains edges_of_valid_regions left_of_an_edge interiors_meet inside_a_corner
  complement_in_a_frame polygons_of_the_thesis connected_sets naive_collision collision_is_sound met_pieces
  beside_a_piece filling kept_pieces_go_round cut_pieces rule_of_sides region_of_pieces valid_regions_are_accepted
  edges_of_polygons just_right_of_a_piece edges_of_the_intersection connected_beside_pieces inside_and_outside.
Import ListNotations.

Open Scope Q_scope.

Lemma one_chain (c : list vector) : region_edges [c] = edges c.
Proof. apply app_nil_r. Qed.

Lemma nothing_far_away_is_met (l : list segment) :
  exists limit, forall z, limit < vx z -> off z l /\ winding_number z l = 0%Z.
Proof.
  destruct (nothing_far_to_the_right l) as (limit & none).
  assert (exists most, forall z, most < vx z -> off z l) as (most & free).
  { clear. induction l as [| s l (most & free)]; [exists 0; intros z _ t [] |].
    set (ends := Qmax (vx (source s)) (vx (target s))). exists (Qmax most ends). intros z far t T.
    pose proof (Q.le_max_l most ends). pose proof (Q.le_max_r most ends).
    destruct T as [<- | T]; [| apply free; [lra | exact T]]. intros (k & range & X & _).
    pose proof (Q.le_max_l (vx (source s)) (vx (target s)) : _ <= ends).
    pose proof (Q.le_max_r (vx (source s)) (vx (target s)) : _ <= ends).
    pose proof (mixed_is_less k (vx (source s)) (vx (target s)) (vx z) range ltac:(lra) ltac:(lra)). lra. }
  exists (Qmax limit most). intros z far. pose proof (Q.le_max_l limit most). pose proof (Q.le_max_r limit most).
  split; [apply free; lra |]. assert (all : forall s, In s l -> signed_crossing z s = 0%Z) by (intros; apply none;
    lra || trivial).
  clear - all. induction l as [| s l IH]; [reflexivity |].
  change (s :: l) with ([s] ++ l). rewrite winding_number_is_additive, IH by (intros; apply all; now right).
  unfold winding_number, sum. cbn. rewrite (all s) by now left. reflexivity.
Qed.

(* Along a path off closed segments all points have the winding number of the first. *)
Lemma connected_with_one_number (l : list segment) (a b : vector) : cycles l ->
  connected_in (fun z => off z l) a b ->
  connected_in (fun z => off z l /\ winding_number z l = winding_number a l) a b.
Proof.
  intros closed (path & walk). exists path. revert a walk.
  assert (step : forall a c, (forall z, lies_on z (Segment a c) -> off z l) ->
    forall z, lies_on z (Segment a c) -> off z l /\ winding_number z l = winding_number a l).
  { intros a c free z on. split; [now apply free |]. symmetry. apply (winding_number_along (Segment a z) l closed).
    intros w (h & range' & X' & Y'). apply free. destruct on as (k & range & X & Y). cbn [source target] in *.
    exists (h * k). cbn [source target]. split; [split; nra |]. rewrite X', Y', X, Y. split; ring. }
  induction path as [| c rest IH]; intros a walk; [exact (step a b walk) |]. destruct walk as [first_ walk].
  split; [exact (step a c first_) |]. rewrite <- (proj2 (step a c first_ c (target_lies_on (Segment a c)))).
    now apply IH.
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

  Lemma from_an_end_to_the_middle (v w : vector) (f : segment) : lies_on v f -> lies_on w (Segment v (middle f)) ->
    equal_vectors w v \/ strictly_inside w f.
  Proof.
    intros (k & range & X & Y) (h & range' & X' & Y'). cbn [source target] in X', Y'.
    destruct (Qlt_le_dec 0 h) as [some | none].
    - right. exists ((1 - h) * k + h * (1 # 2)). split; [split; nra |].
      unfold middle in X', Y'. cbn [vx vy] in X', Y'. rewrite X', Y', X, Y. split; field.
    - left. assert (h_is : h == 0) by lra. rewrite h_is in X', Y'. split; [rewrite X' | rewrite Y']; ring.
  Qed.

  Lemma kept_is_in_each (c o : list vector) (f : segment) (v : vector) : one_and_other a b c o -> In f kept ->
    lies_on v f -> off v (region_edges [c]) -> (0 < winding_number v (region_edges [c]))%Z.
  Proof.
    intros pair_ F on free.
    destruct (proj1 (kept_is_inside_the_other a b a_polygon b_polygon a_off b_off f) F)
      as (_ & c' & o' & s & pair_' & S & part & inside_other).
    assert (c' = c \/ o' = c) as [-> | ->] by (destruct pair_, pair_'; tauto).
    - destruct (free s S (part_lies_on f s v part on)).
    - destruct (inside_other (middle f) (middle_is_inside f)) as [_ some].
      pose proof (winding_number_along (Segment v (middle f)) (region_edges [c]) (region_cycles [c])) as same_.
      cbn [source target] in same_. rewrite same_; [exact some |]. intros w on_w.
        destruct (from_an_end_to_the_middle v w f on on_w) as [equal | inside_].
      + apply (off_equal v); [now symmetry | exact free].
      + apply inside_other, inside_.
  Qed.

  (* Closed segments that are kept do not go round what is outside one of the two. *)
  Theorem nothing_goes_round_the_outside (l : list segment) (c o : list vector) (y : vector) : one_and_other a b c o ->
    cycles l -> incl l kept -> off y (region_edges [c]) -> winding_number y (region_edges [c]) = 0%Z ->
    winding_number y l = 0%Z.
  Proof.
    intros pair_ closed part free none. set (boundary := region_edges [c]) in *.
    destruct (both_polygons a b a_polygon b_polygon c o pair_) as [polygon _].
    destruct (nothing_far_away_is_met l) as (limit & far), (nothing_far_away_is_met boundary) as (limit' & far').
    set (z := Vector (Qmax limit limit' + 1) 0).
    pose proof (Q.le_max_l limit limit'). pose proof (Q.le_max_r limit limit').
    destruct (far z) as [_ zero_]; [cbn [z vx]; lra |]. destruct (far' z) as [free_z none_z]; [cbn [z vx]; lra |].
    rewrite <- zero_. apply (connected_points_have_one_number l
      (fun v => off v boundary /\ winding_number v boundary = winding_number y boundary) y z closed).
    - intros v [free_v none_v] f F on. pose proof (kept_is_in_each c o f v pair_ (part f F) on free_v) as some.
      fold boundary in some. lia.
    - apply connected_with_one_number; [apply region_cycles |].
      apply (inside_and_outside_are_connected c polygon y z free free_z). fold boundary. congruence.
  Qed.

  Lemma not_in_both_to_the_right (e : segment) : In e kept -> exists radius, 0 < radius /\
    forall y, within radius (middle e) y -> area e y < 0 ->
      exists c o, one_and_other a b c o /\ off y (region_edges [c]) /\ winding_number y (region_edges [c]) = 0%Z.
  Proof.
    intros E. pose proof (are_long _ share e E) as long.
    destruct (proj1 (of_kept _ _ e) E) as (D & _ & not_right).
    pose proof (both_are_long a b a_polygon b_polygon) as all_long.
    assert (only : met_only_along (concat (two_families a b)) e).
    { destruct D as [D | D]; [| rewrite <- (reversed_twice e); apply met_only_along_reversed];
        exact (pieces_are_met_along _ _ (pieces_are_pieces _ all_long) _ D). }
    destruct (right_half_is_free (concat (two_families a b)) e only (middle e) (middle_is_inside e)) as (radius & R &
      free).
    exists radius. split; [exact R |]. intros y close right_.
    (* all such points are not in both, since the closest are not *)
    set (n := to_the_right e).
    destruct (some_small _ (eventually_and _ _ (same_beside_pieces _ _ _ ends_ e (middle e) n D (middle_is_inside e)
      (right_normal e long)) (small_steps_stay_within radius (middle e) n R))) as (d & some & beside & close').
    rewrite not_right in beside. set (z := moved_along (middle e) n d) in *.
    assert (right_z : area e z < 0).
    { apply right_of_a_step; trivial. apply strictly_inside_lies_on, middle_is_inside. }
    assert (free' : forall w, lies_on w (Segment y z) -> off w (concat (two_families a b))).
    { intros w on. apply free; [exact (within_along radius (middle e) y z w close close' on) |
      exact (area_between e y z w right_ right_z on)]. }
    assert (off_one : forall c o w, one_and_other a b c o -> lies_on w (Segment y z) -> off w (region_edges [c])).
    { intros c o w pair_ on s S. apply (free' w on), segments_of_both. now exists c, o. }
    assert (same_ : forall c o, one_and_other a b c o ->
      winding_number y (region_edges [c]) = winding_number z (region_edges [c])).
    { intros c o pair_. apply (winding_number_along (Segment y z) _ (region_cycles [c])). intros w on.
      exact (off_one c o w pair_ on). }
    pose proof (source_lies_on (Segment y z)) as at_y. cbn [source] in at_y.
    pose proof (off_one a b y (FirstOne a b) at_y) as free_a. pose proof (off_one b a y (SecondOne a b) at_y) as free_b.
    destruct (simple_polygons_go_round_once a y a_polygon free_a) as [none | one];
      [exists a, b; split; [constructor | now split] |].
    destruct (simple_polygons_go_round_once b y b_polygon free_b) as [none | one'];
      [exists b, a; split; [constructor | now split] |].
    exfalso. rewrite (same_ a b (FirstOne a b)) in one. rewrite (same_ b a (SecondOne a b)) in one'.
    apply not_true_iff_false in beside. apply beside, (all_positive_of_two a b a b z (FirstOne a b)). lia.
  Qed.

  (* Theorem. A simple chain of kept pieces is counterclockwise. *)
  Theorem kept_chains_are_counterclockwise (c : list vector) : simple c -> incl (edges c) kept ->
    is_counterclockwise c = true.
  Proof.
    intros chain_simple part. pose proof chain_simple as (three & long & _).
    set (e := edge_at c 0). assert (E : In e (edges c)) by (unfold e, edge_at; apply nth_In;
      rewrite edges_are_as_many; lia).
    pose proof (part e E) as K. pose proof (are_long _ share e K) as e_long. pose proof (middle_is_inside e) as inside_.
    set (n := Vector (- vy (along e)) (vx (along e))). pose proof (left_normal e e_long : 0 < cross (along e) n) as
      turn.
    assert (meet : edges_meet_in_vertices [c]).
    { apply edges_meet_by_pairs. rewrite one_chain. apply edges_of_one_chain; [exact chain_simple | apply incl_refl]. }
    assert (no_vertex : ~ is_vertex (middle e) [c]).
    { intros (t & T & equal). rewrite one_chain in T. destruct (segment_dec e t) as [<- | other].
      - apply (proj1 (ends_are_not_inside e (middle e) e_long inside_)). exact equal.
      - apply (nothing_inside _ share e t (middle e) K (part t T) other); [| exact inside_].
        apply (lies_on_equal (source t)); [now symmetry | apply source_lies_on]. }
    destruct (not_in_both_to_the_right e K) as (radius & R & right_).
    destruct (some_small _ (eventually_and _ _ (left_is_one_more [c] e (middle e) n meet ltac:(now rewrite one_chain)
      (strictly_inside_lies_on _ _ inside_) no_vertex turn) (small_steps_stay_within radius (middle e) (opposite n) R)))
      as (d & some & (free & _ & more) & close).
    destruct (right_ (moved_along (middle e) n (- d))) as (o & o' & pair_ & free' & none).
    - unfold within, moved_along, opposite in *. cbn [vx vy] in *. lra.
    - apply right_step_is_right; trivial. pose proof (on_the_line (middle e) e (strictly_inside_lies_on _ _ inside_)).
      assumption.
    - rewrite (nothing_goes_round_the_outside (region_edges [c]) o o' (moved_along (middle e) n (- d)) pair_
        (region_cycles [c])) in more; trivial.
      + rewrite one_chain in *. pose proof (winding_numbers_of_simple_chains c _ chain_simple free) as range.
        destruct (is_counterclockwise c); [reflexivity | lia].
      + now rewrite one_chain.
  Qed.
End TwoPolygons.
