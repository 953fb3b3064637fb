(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* What the naive collision test looks for (reference/definitions/collision.cpp), in every position of two regions,
   touching ones included: their interiors have a point in common if and only if a point of one boundary is inside the
   other region, or two edges pass a point that is no vertex, not in opposite directions. From a common point a ray to
   the right, at a height at which no vertex is, meets such a place first (first_hit.v). *)
From Coq Require Import QArith Lqa ZArith Lia Bool List.
From Oplus Require Import direction angle sweep winding_number tie_rule in_out_degree sums weight regions
  winding_number_of_the_sum meeting_of_segments first_hit interiors_meet neighbourhoods left_of_an_edge theorem_4_2_1.
Import ListNotations.

Open Scope Q_scope.

Definition have_common_interior (a b : region) : Prop := exists z, inside z a /\ inside z b.

(* As for valid regions: not two chains around a point. *)
Definition at_most_once (r : region) : Prop :=
  forall x, off x (region_edges r) -> (winding_number x (region_edges r) <= 1)%Z.

Definition boundary_enters (a b : region) : Prop :=
  exists s w, In s (region_edges a) /\ lies_on w s /\ inside w b.

(* They cross, or run along each other in the same direction. *)
Definition edges_pass (a b : region) : Prop :=
  exists s t w, In s (region_edges a) /\ In t (region_edges b) /\ lies_on w s /\ lies_on w t /\
    ~ is_vertex w a /\ ~ is_vertex w b /\ turns (along s) (along t).

Lemma edges_pass_other_way (a b : region) : edges_pass a b -> edges_pass b a.
Proof.
  intros (s & t & w & I & J & on_s & on_t & no_a & no_b & (proper_s & proper_t & ahead)).
  exists t, s, w. do 6 (split; [assumption |]). split; [exact proper_t |]. split; [exact proper_s |].
  intros parallel. unfold cross, dot in *.
  assert (vx (along s) * vy (along t) - vy (along s) * vx (along t) == 0) as same_ by lra.
  specialize (ahead same_). lra.
Qed.

(* Each of these places has common inner points near it. *)
Lemma boundary_enters_shows (a b : region) :
  is_regular a -> boundary_enters a b -> have_common_interior a b.
Proof.
  intros regular (s & w & I & on & free & positive_).
  destruct (winding_number_near w _ (region_cycles b) free) as (radius & R & near).
  destruct (regular w s radius I on R) as (z & close & in_a). exists z. split; [exact in_a |].
  destruct (near z close) as [off_z same_number]. split; [exact off_z | lia].
Qed.

Lemma edges_pass_shows (a b : region) :
  valid_region a -> valid_region b -> edges_pass a b -> have_common_interior a b.
Proof.
  intros (a_edges & a_valid & a_meet) (b_edges & b_valid & b_meet)
    (s & t & w & I & J & on_s & on_t & no_a & no_b & (proper_s & proper_t & ahead)).
  assert (found : forall n, 0 < cross (along s) n -> 0 < cross (along t) n -> have_common_interior a b).
  { intros n left_of_s left_of_t.
    destruct (eventually_and _ _ (left_of_an_edge_is_inside a s w n a_valid a_meet I on_s no_a left_of_s)
      (left_of_an_edge_is_inside b t w n b_valid b_meet J on_t no_b left_of_t)) as (limit & L & near).
    exists (moved_along w n ((1 # 2) * limit)). apply near; lra. }
  set (u := along s) in *. set (v := along t) in *. clearbody u v. unfold cross, dot in *.
  destruct (Q_dec (vx u * vy v - vy u * vx v) 0) as [[right_turn | left_turn] | parallel].
  - apply (found (Vector (vx u - vx v) (vy u - vy v))); cbn [vx vy]; lra.
  - apply (found (Vector (vx v - vx u) (vy v - vy u))); cbn [vx vy]; lra.
  - specialize (ahead parallel). apply (found (Vector (- vy u) (vx u))); cbn [vx vy]; [| lra].
    pose proof (squares_are_not_negative (vx u) (vy u)).
    destruct (Qlt_le_dec 0 (vx u * vx u + vy u * vy u)) as [| none]; [lra |].
    exfalso. apply proper_s. now apply no_squares.
Qed.

(* No edge of the region ends at this height. *)
Definition no_end_at (y : Q) (r : region) : Prop :=
  forall s, In s (region_edges r) -> ~ vy (source s) == y /\ ~ vy (target s) == y.

Definition place_at (s : segment) (y : Q) : Q := vx (point_at_height s y).

(* A point of an edge at such a height is the edge's only one. *)
Lemma only_point_at_height (v : vector) (s : segment) (y : Q) :
  ~ vy (source s) == y -> ~ vy (target s) == y -> lies_on v s -> vy v == y ->
  spans s y = true /\ vx v == place_at s y.
Proof.
  intros no_source no_target (t & [t0 t1] & X & Y) height. rewrite height in Y.
  assert (sides : vy (source s) < y < vy (target s) \/ vy (target s) < y < vy (source s)).
  { assert (t_inside : 0 < t < 1).
    { split; apply Qnot_le_lt; intros extreme.
      - apply no_source. assert (t == 0) as t_is by lra. rewrite t_is in Y. lra.
      - apply no_target. assert (t == 1) as t_is by lra. rewrite t_is in Y. lra. }
    destruct (Q_dec (vy (source s)) y) as [[below | above] | equal],
      (Q_dec (vy (target s)) y) as [[below' | above'] | equal']; try contradiction; try lra; exfalso.
    - assert (0 < t * (y - vy (target s))) by (apply Qmult_lt_0_compat; lra).
      assert (0 < (1 - t) * (y - vy (source s))) by (apply Qmult_lt_0_compat; lra). lra.
    - assert (0 < t * (vy (target s) - y)) by (apply Qmult_lt_0_compat; lra).
      assert (0 < (1 - t) * (vy (source s) - y)) by (apply Qmult_lt_0_compat; lra). lra. }
  split.
  - unfold spans. destruct (at_most_spec (vy (source s)) y), (at_most_spec (vy (target s)) y); trivial; exfalso; lra.
  - unfold place_at, point_at_height. cbn [vx]. rewrite X.
    assert (t_is : t == (y - vy (source s)) / (vy (target s) - vy (source s))) by (rewrite Y; field; lra).
    rewrite <- t_is. ring.
Qed.

(* What a ray to the right at height y counts of an edge. *)
Lemma crossing_at_height (p : vector) (s : segment) :
  signed_crossing p s <> 0%Z ->
  spans s (vy p) = true /\ vx p < place_at s (vy p) /\
  ((signed_crossing p s = 1%Z /\ vy (source s) <= vy p < vy (target s)) \/ signed_crossing p s = (-1)%Z).
Proof.
  unfold place_at. rewrite signed_crossing_by_height. intros met.
  destruct (spans s (vy p)) eqn:spanning; [| now destruct met]. cbn [andb] in *.
  destruct (negative_spec (vx p - vx (point_at_height s (vy p)))); [| now destruct met].
  split; [reflexivity |]. split; [lra |]. pose proof (heights_of_spanning s (vy p) spanning) as heights.
  destruct (at_most_spec (vy (source s)) (vy p)); [left | now right]. split; [reflexivity | lra].
Qed.

Lemma crossing_is_met (p : vector) (s : segment) :
  spans s (vy p) = true -> vx p < place_at s (vy p) -> signed_crossing p s <> 0%Z.
Proof.
  unfold place_at. intros spanning ahead. rewrite signed_crossing_by_height, spanning. cbn [andb].
  destruct (negative_spec (vx p - vx (point_at_height s (vy p)))); [| exfalso; lra].
  destruct (at_most (vy (source s)) (vy p)); discriminate.
Qed.

Section OneRegion.
  Variable r : region.
  Variable z : vector.
  Hypothesis meet : edges_meet_in_vertices r.
  Hypothesis once : at_most_once r.
  Hypothesis here : inside z r.
  Hypothesis no_end : no_end_at (vy z) r.

  Lemma no_vertex_at_height (w : vector) : vy w == vy z -> ~ is_vertex w r.
  Proof. intros height (s & I & _ & Y). destruct (no_end s I) as [no_source _]. apply no_source. lra. Qed.

  Lemma places_beyond (x : Q) : eventually (fun e => forall s, In s (region_edges r) ->
    x < place_at s (vy z) -> x + e < place_at s (vy z)).
  Proof.
    apply (eventually_for_all (fun s e => x < place_at s (vy z) -> x + e < place_at s (vy z))). intros s _.
    destruct (Qlt_le_dec x (place_at s (vy z))) as [ahead | behind].
    - exists (place_at s (vy z) - x). split; [lra |]. intros e _ below _. lra.
    - exists 1. split; [lra |]. intros e _ _ ahead. lra.
  Qed.

  (* The first edge that the ray meets goes up, so that the inside is to its left. *)
  Lemma first_edge_goes_up (s : segment) :
    In s (region_edges r) -> signed_crossing z s <> 0%Z ->
    (forall t, In t (region_edges r) -> signed_crossing z t <> 0%Z -> place_at s (vy z) <= place_at t (vy z)) ->
    vy (source s) <= vy z < vy (target s).
  Proof.
    intros I met first. destruct here as [free positive_].
    destruct (crossing_at_height z s met) as (spanning & ahead & [[_ up] | down]); [exact up | exfalso].
    destruct (places_beyond (place_at s (vy z))) as (limit & L & beyond).
    set (e := (1 # 2) * limit). assert (e_range : 0 < e /\ e < limit) by (unfold e; lra).
    specialize (beyond e (proj1 e_range) (proj2 e_range)). destruct e_range as [e0 _]. clearbody e.
    set (q := Vector (place_at s (vy z) + e) (vy z)).
    assert (off_q : off q (region_edges r)).
    { intros t J on. destruct (no_end t J) as [no_source no_target].
      destruct (only_point_at_height q t (vy z) no_source no_target on (Qeq_refl _)) as [_ place].
      unfold q in place. cbn [vx] in place. pose proof (beyond t J). lra. }
    destruct (in_split s (region_edges r) I) as (earlier & later & edges_are).
    assert (on_s : lies_on (point_at_height s (vy z)) s) by now apply point_at_height_lies_on.
    assert (others : forall t, In t (earlier ++ later) -> signed_crossing q t = signed_crossing z t).
    { intros t J.
      assert (K : In t (region_edges r)) by (rewrite edges_are; apply in_app_iff in J; apply in_app_iff; cbn; tauto).
      rewrite !signed_crossing_by_height. change (vy q) with (vy z). change (vx q) with (place_at s (vy z) + e).
      destruct (spans t (vy z)) eqn:spanning_t; [| reflexivity]. cbn [andb].
      fold (place_at t (vy z)).
      assert (differ : ~ place_at t (vy z) == place_at s (vy z)).
      { intros equal. apply (no_vertex_at_height (point_at_height s (vy z)) (Qeq_refl _)).
        apply (meet earlier s later t (point_at_height s (vy z)) edges_are J on_s).
        destruct (point_at_height_lies_on t (vy z) spanning_t) as (k & range & X & Y).
        exists k. split; [exact range |]. split; [| exact Y]. rewrite <- X. symmetry. exact equal. }
      pose proof (first t K) as not_before. pose proof (crossing_is_met z t spanning_t) as is_met.
      pose proof (beyond t K) as is_beyond.
      destruct (negative_spec (vx z - place_at t (vy z))) as [right_of_z | left_of_z],
        (negative_spec (place_at s (vy z) + e - place_at t (vy z))) as [right_of_q | left_of_q]; trivial; exfalso.
      - assert (place_at s (vy z) <= place_at t (vy z)) by (apply not_before, is_met; lra).
        assert (place_at s (vy z) + e < place_at t (vy z)) by (apply is_beyond; lra). lra.
      - lra. }
    assert (none : signed_crossing q s = 0%Z).
    { rewrite signed_crossing_by_height. change (vy q) with (vy z). change (vx q) with (place_at s (vy z) + e).
      rewrite spanning. cbn [andb]. fold (place_at s (vy z)).
      destruct (negative_spec (place_at s (vy z) + e - place_at s (vy z))); [exfalso; lra | reflexivity]. }
    pose proof (once q off_q) as at_q. unfold winding_number in at_q, positive_.
    change (0 < sum_of (signed_crossing z) (region_edges r))%Z in positive_.
    change (sum_of (signed_crossing q) (region_edges r) <= 1)%Z in at_q.
    rewrite edges_are, sum_of_two_lists, sum_of_more in positive_, at_q.
    rewrite none, (sum_equally _ (signed_crossing q) (signed_crossing z) earlier),
      (sum_equally _ (signed_crossing q) (signed_crossing z) later) in at_q
      by (intros t J; apply others, in_app_iff; tauto).
    lia.
  Qed.
End OneRegion.

(* The first edge that the ray meets, one of a, shows it. *)
Lemma first_hit_shows (a b : region) (z : vector) (s : segment) :
  edges_meet_in_vertices a -> edges_meet_in_vertices b -> at_most_once a -> at_most_once b ->
  inside z a -> inside z b -> no_end_at (vy z) a -> no_end_at (vy z) b ->
  In s (region_edges a) -> signed_crossing z s <> 0%Z ->
  (forall t, In t (region_edges a ++ region_edges b) -> signed_crossing z t <> 0%Z ->
     place_at s (vy z) <= place_at t (vy z)) ->
  boundary_enters a b \/ edges_pass a b.
Proof.
  intros a_meet b_meet a_once b_once in_a in_b no_a no_b I met first.
  destruct (crossing_at_height z s met) as (spanning & ahead & _).
  set (w := point_at_height s (vy z)). assert (on_s : lies_on w s) by now apply point_at_height_lies_on.
  destruct (on_or_off w (region_edges b)) as [(t & J & on_t) | free].
  - right. destruct (no_b t J) as [no_source no_target].
    destruct (only_point_at_height w t (vy z) no_source no_target on_t (Qeq_refl _)) as [spanning_t place_t].
    change (place_at s (vy z) == place_at t (vy z)) in place_t.
    assert (s_up : vy (source s) <= vy z < vy (target s)).
    { apply (first_edge_goes_up a z a_meet a_once in_a no_a s I met). intros u K. apply first, in_app_iff. now left. }
    assert (t_up : vy (source t) <= vy z < vy (target t)).
    { apply (first_edge_goes_up b z b_meet b_once in_b no_b t J).
      - apply crossing_is_met; [exact spanning_t | lra].
      - intros u K met_u. rewrite <- place_t. apply first; [apply in_app_iff; now right | exact met_u]. }
    exists s, t, w. do 4 (split; [assumption |]).
    split; [now apply (no_vertex_at_height a z no_a) |]. split; [now apply (no_vertex_at_height b z no_b) |].
    assert (s_rises : 0 < vy (along s)) by (unfold along, minus; cbn [vy]; lra).
    assert (t_rises : 0 < vy (along t)) by (unfold along, minus; cbn [vy]; lra).
    split; [intros [_ flat]; lra |]. split; [intros [_ flat]; lra |].
    set (u := along s) in *. set (v := along t) in *. clearbody u v. unfold cross, dot. intros parallel.
    assert (product_ : vy u * (vx u * vx v + vy u * vy v) == vy v * (vx u * vx u + vy u * vy u)).
    { assert (vy u * vx v == vx u * vy v) as same_ by lra.
      setoid_replace (vy u * (vx u * vx v + vy u * vy v)) with (vx u * (vy u * vx v) + vy u * vy u * vy v) by ring.
      rewrite same_. ring. }
    assert (0 < vy v * (vx u * vx u + vy u * vy u)) by (apply Qmult_lt_0_compat; [exact t_rises | nra]).
    destruct (Qlt_le_dec 0 (vx u * vx v + vy u * vy v)) as [| none]; [assumption | exfalso]. nra.
  - left. exists s, w. split; [exact I |]. split; [exact on_s |]. split; [exact free |].
    destruct in_b as [free_z positive_].
    assert (way : forall v, lies_on v (Segment z w) -> off v (region_edges b)).
    { intros v (k & [k0 k1] & X & Y) t J on. cbn [source target] in X, Y. change (vy w) with (vy z) in Y.
      assert (height : vy v == vy z) by (rewrite Y; ring). destruct (no_b t J) as [no_source no_target].
      destruct (only_point_at_height v t (vy z) no_source no_target on height) as [spanning_t place_t].
      assert (on_copy : forall u, vx u == vx v -> vy u == vy v -> lies_on u t).
      { intros u ux uy. destruct on as (l & range & lx & ly). exists l. rewrite ux, uy. now repeat split. }
      change (vx w) with (place_at s (vy z)) in X. set (place := place_at s (vy z)) in *.
      assert (between_ : vx z <= vx v <= place) by (rewrite X; split; nra).
      destruct (Qlt_le_dec (vx z) (vx v)) as [after | at_z].
      - assert (place <= place_at t (vy z)).
        { apply first; [apply in_app_iff; now right |]. apply crossing_is_met; [exact spanning_t | lra]. }
        apply (free t J), on_copy; [change (vx w) with place; lra | change (vy w) with (vy z); now symmetry].
      - apply (free_z t J), on_copy; [lra | now symmetry]. }
    pose proof (winding_number_along (Segment z w) _ (region_cycles b) way) as same_number.
    cbn [source target] in same_number. now rewrite <- same_number.
Qed.

(* Near a common inner point is one at whose height no vertex is. *)
Lemma no_vertex_at_its_height (a b : region) : have_common_interior a b ->
  exists z, inside z a /\ inside z b /\ no_end_at (vy z) a /\ no_end_at (vy z) b.
Proof.
  intros (z & [free_a positive_a] & [free_b positive_b]).
  destruct (winding_number_near z _ (region_cycles a) free_a) as (radius_a & R_a & near_a).
  destruct (winding_number_near z _ (region_cycles b) free_b) as (radius_b & R_b & near_b).
  set (up := Vector 0 1).
  assert (differs : forall y, eventually (fun e => ~ y == vy (moved_along z up e))).
  { intros y. unfold moved_along, up. cbn [vy]. destruct (Qlt_le_dec 0 (y - vy z)) as [above | below].
    - exists (y - vy z). split; [exact above |]. intros e e0 e1. lra.
    - exists 1. split; [lra |]. intros e e0 e1. lra. }
  assert (heights : forall r, eventually (fun e => no_end_at (vy (moved_along z up e)) r)).
  { intros r. apply (eventually_for_all (fun s e => ~ vy (source s) == vy (moved_along z up e) /\
      ~ vy (target s) == vy (moved_along z up e))). intros s _. apply eventually_and; apply differs. }
  destruct (eventually_and _ _ (eventually_and _ _ (heights a) (heights b))
    (eventually_and _ _ (small_steps_stay_within radius_a z up R_a) (small_steps_stay_within radius_b z up R_b)))
    as (limit & L & near).
  destruct (near ((1 # 2) * limit)) as [[no_a no_b] [close_a close_b]]; [lra | lra |].
  exists (moved_along z up ((1 # 2) * limit)).
  destruct (near_a _ close_a) as [off_a same_a]. destruct (near_b _ close_b) as [off_b same_b].
  split; [split; [exact off_a | lia] |]. split; [split; [exact off_b | lia] |]. now split.
Qed.

(* Theorem. The interiors of two valid regions have a point in common if and only if a point of one boundary is inside
   the other region, or two edges have a point in common that is no vertex of either, and are not opposite. *)
Theorem common_interior_iff_boundaries_show_it (a b : region) :
  valid_region a -> valid_region b -> at_most_once a -> at_most_once b ->
  (have_common_interior a b <-> boundary_enters a b \/ boundary_enters b a \/ edges_pass a b).
Proof.
  intros a_valid b_valid a_once b_once. pose proof a_valid as (a_edges & a_positive & a_meet).
  pose proof b_valid as (b_edges & b_positive & b_meet). split.
  - intros common. destruct (no_vertex_at_its_height a b common) as (z & in_a & in_b & no_a & no_b).
    destruct (first_of segment (fun s => place_at s (vy z))
      (filter (fun s => negb (signed_crossing z s =? 0)%Z) (region_edges a ++ region_edges b))) as (s & I & first).
    { destruct in_a as [_ positive_]. apply positive_sum in positive_. destruct positive_ as (s & I & some).
      intros none. assert (J : In s []); [| destruct J]. rewrite <- none. apply filter_In.
      split; [apply in_app_iff; now left |]. apply negb_true_iff, Z.eqb_neq. lia. }
    apply filter_In in I. destruct I as [I met]. apply negb_true_iff, Z.eqb_neq in met.
    assert (first_of_all : forall t, In t (region_edges a ++ region_edges b) -> signed_crossing z t <> 0%Z ->
      place_at s (vy z) <= place_at t (vy z)).
    { intros t J met_t. apply first, filter_In. split; [exact J |]. now apply negb_true_iff, Z.eqb_neq. }
    apply in_app_iff in I. destruct I as [I | I].
    + destruct (first_hit_shows a b z s) as [enters | pass]; trivial; [now left | right; now right].
    + destruct (first_hit_shows b a z s) as [enters | pass]; trivial.
      * intros t J. apply first_of_all. apply in_app_iff. apply in_app_iff in J. tauto.
      * right. now left.
      * right. right. now apply edges_pass_other_way.
  - intros [enters | [enters | pass]].
    + apply boundary_enters_shows; [now apply regions_are_regular | exact enters].
    + destruct (boundary_enters_shows b a) as (z & in_b & in_a);
        [now apply regions_are_regular | exact enters | now exists z].
    + now apply edges_pass_shows.
Qed.
