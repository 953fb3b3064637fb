(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Over both numbers the theory says the same of rational regions: which of them are valid, which rational points are on
   their edges, in them and inside them, and which are in their Minkowski sum. What is compared agrees by
   rational_polygons.v. What is said of all points, real ones included, follows from the rational ones: near a real
   point are rational points, and where rational segments cross or overlap, too. *)
From Coq Require Import Rbase QArith Qreals ZArith Bool List.
From Coq Require Lra.
Require Import Oplus.numbers.numbers Oplus.directions.direction Oplus.directions.angle Oplus.winding.angular_crossings
  Oplus.winding.winding_number Oplus.directions.small_numbers Oplus.winding.neighbourhoods
  Oplus.winding.beside_a_piece Oplus.chains.turning_number Oplus.cycles.states Oplus.cycles.in_out_degree
  Oplus.regions.regions Oplus.regions.left_of_an_edge Oplus.theorem_4_2_1.convolution_winding
  Oplus.theorem_4_2_1.interiors_meet Oplus.theorem_4_2_1.theorem_4_2_1 Oplus.chapter_2.theorem_2_2_6
  Oplus.chapter_2.lemma_2_2_2 Oplus.examples.drawn_regions.
Require Oplus.reals.theorem_4_2_1.theorem_4_2_1 Oplus.reals.winding.beside_a_piece.
Require Import Oplus.both.rational_polygons.
Import ListNotations.

Module RealSmall := Oplus.reals.directions.small_numbers.
Module RealCrossings := Oplus.reals.winding.angular_crossings.
Module RealNear := Oplus.reals.winding.neighbourhoods.
Module RealPiece := Oplus.reals.winding.beside_a_piece.
Module RealEdges := Oplus.reals.regions.left_of_an_edge.
Module RealInterior := Oplus.reals.theorem_4_2_1.interiors_meet.
Module RealTheorem := Oplus.reals.theorem_4_2_1.theorem_4_2_1.

Open Scope Q_scope.

(* Between two real numbers is a rational one. *)
Lemma some_rational (a b : R) : (a < b)%R -> exists q, (a < Q2R q < b)%R.
Proof.
  intros less. assert (some : (0 < b - a)%R) by Lra.lra.
  destruct (archimed (/ (b - a))) as [many _]. set (n := up (/ (b - a))) in *.
  assert (inverse : (0 < / (b - a))%R) by now apply Rinv_0_lt_compat.
  assert (n_positive : (0 < n)%Z) by (apply lt_IZR; Lra.lra).
  destruct n as [| n | n]; try discriminate.
  destruct (archimed (a * IZR (Zpos n))) as [above close]. set (m := up (a * IZR (Zpos n))) in *.
  exists (m # n). unfold Q2R. cbn [Qnum Qden].
  assert (n_is : (0 < IZR (Zpos n))%R) by now apply IZR_lt.
  assert (wide : (1 < (b - a) * IZR (Zpos n))%R).
  { apply (Rmult_lt_compat_l (b - a)) in many; [| exact some]. rewrite Rinv_r in many by Lra.lra. exact many. }
  split; apply (Rmult_lt_reg_r (IZR (Zpos n))); trivial; rewrite Rmult_assoc, Rinv_l by Lra.lra; Lra.lra.
Qed.

(* Points on edges, in regions and inside them. *)
Lemma edge_is_real (r : region) (s : RealWinding.segment) : In s (RealRegions.region_edges (real_region r)) <->
  exists t, real_segment t = s /\ In t (region_edges r).
Proof. rewrite region_edges_are. apply in_map_iff. Qed.

Lemma off_is (p : vector) (segments : list segment) :
  RealWinding.off (real_point p) (map real_segment segments) <-> off p segments.
Proof.
  split; intros free s I.
  - rewrite <- lies_on_is. now apply free, in_map.
  - apply in_map_iff in I. destruct I as (t & <- & I). rewrite lies_on_is. now apply free.
Qed.

(* Theorem. A rational point is in a rational region over the reals if and only if it is in it over the rationals. *)
Theorem points_of_regions_agree (x : vector) (r : region) :
  RealRegions.in_region (real_point x) (real_region r) <-> in_region x r.
Proof.
  unfold RealRegions.in_region, in_region. rewrite region_edges_are, winding_numbers_agree.
  split; (intros [number | (s & I & on)]; [now left | right]).
  - apply in_map_iff in I. destruct I as (t & <- & I). exists t. split; [exact I | now apply lies_on_is].
  - exists (real_segment s). split; [now apply in_map | now apply lies_on_is].
Qed.

(* And so are points off the boundary. *)
Theorem inner_points_agree (x : vector) (r : region) :
  RealInterior.inside (real_point x) (real_region r) <-> inside x r.
Proof. unfold RealInterior.inside, inside. now rewrite region_edges_are, winding_numbers_agree, off_is. Qed.

Lemma equal_is (u v : vector) : RealCrossings.equal_vectors (real_point u) (real_point v) <-> equal_vectors u v.
Proof.
  unfold RealCrossings.equal_vectors, equal_vectors. cbn [real_point RealDirection.vx RealDirection.vy].
  split; intros [X Y]; split; (apply eqR_Qeq || apply Qeq_eqR); assumption.
Qed.

Lemma is_vertex_is (w : vector) (r : region) : RealEdges.is_vertex (real_point w) (real_region r) <-> is_vertex w r.
Proof.
  split; intros (u & I & equal).
  - apply edge_is_real in I. destruct I as (t & <- & I). exists t. split; [exact I | now apply equal_is].
  - exists (real_segment u). split; [apply edge_is_real; now exists u | now apply equal_is].
Qed.

(* Valid regions. *)
Lemma nonzero_is (v : vector) : RealDirection.nonzero (real_point v) <-> nonzero v.
Proof.
  unfold RealDirection.nonzero, nonzero. cbn [real_point RealDirection.vx RealDirection.vy]. rewrite <- real_zero.
  split; intros some [X Y]; apply some; split; (apply eqR_Qeq || apply Qeq_eqR); assumption.
Qed.

Lemma edges_are_no_points_over_both (r : region) :
  RealRegions.no_edges_are_points (real_region r) <-> no_edges_are_points r.
Proof.
  split; intros some chain I e J.
  - apply nonzero_is. apply (some (real_chain chain)); [now apply in_map |]. rewrite edge_directions_are.
    now apply in_map.
  - apply in_map_iff in I. destruct I as (c & <- & I). rewrite edge_directions_are in J. apply in_map_iff in J.
    destruct J as (d & <- & J). apply nonzero_is. now apply (some c).
Qed.

Lemma nowhere_negative_over_both (r : region) :
  RealRegions.nowhere_negative (real_region r) <-> nowhere_negative r.
Proof.
  split; intros valid x free.
  - rewrite <- winding_numbers_agree, <- region_edges_are. apply valid. rewrite region_edges_are. now apply off_is.
  - destruct (RealNear.winding_number_near x _ (RealRegions.region_cycles _) free) as (radius & some & near).
    destruct (some_rational (RealDirection.vx x) (RealDirection.vx x + radius)%R) as (a & A); [Lra.lra |].
    destruct (some_rational (RealDirection.vy x) (RealDirection.vy x + radius)%R) as (b & B); [Lra.lra |].
    destruct (near (real_point (Vector a b))) as [free_ <-].
    { unfold RealNear.within. cbn [real_point RealDirection.vx RealDirection.vy vx vy]. Lra.lra. }
    rewrite region_edges_are in *. rewrite winding_numbers_agree. now apply valid, off_is.
Qed.

(* A real point of two rational segments that is no end of them is rational, or they overlap. *)
Lemma point_at_is (s : segment) (k : Q) : RealPiece.point_at (real_segment s) (Q2R k) = real_point (point_at s k).
Proof.
  unfold RealPiece.point_at, point_at, real_point.
  cbn [real_segment RealWinding.source RealWinding.target RealDirection.vx RealDirection.vy vx vy].
  rewrite !Q2R_plus, !Q2R_mult, !Q2R_minus. unfold real_point. cbn [RealDirection.vx RealDirection.vy].
  now replace (Q2R 1) with 1%R by (unfold Q2R; cbn; field).
Qed.

Lemma area_is (s : segment) (p : vector) : RealWinding.area (real_segment s) (real_point p) = Q2R (area s p).
Proof.
  unfold RealWinding.area, area, RealDirection.cross, cross. cbn [real_segment RealWinding.source RealWinding.target].
  rewrite !minus_is. cbn [real_point RealDirection.vx RealDirection.vy]. now rewrite Q2R_minus, !Q2R_mult.
Qed.

(* The point at which t crosses the line of s. *)
Lemma crossing_is_rational (s t : segment) (w : RealDirection.vector) :
  ~ area s (source t) == area s (target t) ->
  RealWinding.lies_on w (real_segment s) -> RealWinding.lies_on w (real_segment t) -> exists v, w = real_point v.
Proof.
  intros crosses (k & _ & sx & sy) (j & _ & tx & ty).
  assert (some : ~ area s (target t) - area s (source t) == 0) by (intros e; apply crosses; lra).
  exists (point_at t (- area s (source t) / (area s (target t) - area s (source t)))).
  assert (differ : Q2R (area s (source t)) <> Q2R (area s (target t))) by (intros e; now apply crosses, eqR_Qeq).
  assert (line : ((1 - j) * Q2R (area s (source t)) + j * Q2R (area s (target t)) = 0)%R).
  { rewrite <- !area_is. unfold RealWinding.area, RealDirection.cross, RealWinding.minus in *.
    destruct w as [x y].
    cbn [real_segment RealWinding.source RealWinding.target RealDirection.vx RealDirection.vy] in *.
    rewrite sx in tx. rewrite sy in ty. RealWinding.by_equations. }
  rewrite <- point_at_is, Q2R_div, Q2R_opp, Q2R_minus by exact some.
  set (a := Q2R (area s (source t))) in *. set (b := Q2R (area s (target t))) in *.
  assert (j_is : (j = - a / (b - a))%R).
  { apply (Rmult_eq_reg_r (b - a)); [| Lra.lra]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by Lra.lra. Lra.lra. }
  rewrite <- j_is. destruct w. unfold RealPiece.point_at. cbn [RealDirection.vx RealDirection.vy] in *.
  now rewrite tx, ty.
Qed.

(* Edges that overlap have two common points, and between them are some that are no vertices. *)
Lemma edges_do_not_overlap (r : region) (earlier later : list segment) (s t : segment) (k l : Q) :
  edges_meet_in_vertices r -> nonzero (along s) -> region_edges r = earlier ++ s :: later -> In t (earlier ++ later) ->
  0 <= k -> k < l -> l <= 1 -> lies_on (point_at s k) t -> lies_on (point_at s l) t -> False.
Proof.
  intros meet long edges_are I first less last_ (i & range_i & ix & iy) (j & range_j & jx & jy).
  destruct (some_small _ (eventually_and _ _ (leaves_all_vertices r (point_at s k) (along s) long)
    (eventually_below (l - k) ltac:(lra)))) as (e & _ & no_vertex & range).
  apply no_vertex, (meet earlier s later t); trivial.
  - exists (k + e). split; [lra |]. unfold moved_along, along, minus, point_at. cbn [vx vy]. split; ring.
  - assert (h_is : e / (l - k) * (l - k) == e) by (field; lra).
    set (h := e / (l - k)) in *. clearbody h. exists ((1 - h) * i + h * j).
    assert (0 <= h <= 1) by (split; nra). split; [split; nra |].
    unfold point_at, moved_along, along, minus in *. cbn [vx vy] in *. clear - h_is ix iy jx jy. split; by_equations.
Qed.

Lemma real_overlap_is_rational (s t : segment) (w : RealDirection.vector) :
  area s (source t) == area s (target t) -> nonzero (along t) ->
  RealWinding.strictly_inside w (real_segment s) -> RealWinding.strictly_inside w (real_segment t) ->
  exists k l, 0 <= k /\ k < l /\ l <= 1 /\ lies_on (point_at s k) t /\ lies_on (point_at s l) t.
Proof.
  intros parallel long (k & range & sx & sy) (j & range_j & tx & ty).
  assert (multiple : exists c,
    RealDirection.vx (real_point (along s)) = (c * RealDirection.vx (real_point (along t)))%R /\
    RealDirection.vy (real_point (along s)) = (c * RealDirection.vy (real_point (along t)))%R).
  { apply RealWinding.multiple_of; [now apply nonzero_is |].
    unfold RealDirection.cross. cbn [real_point RealDirection.vx RealDirection.vy].
    rewrite <- !Q2R_mult, <- Q2R_minus, <- real_zero. apply Qeq_eqR.
    unfold area, cross, along, minus in *. cbn [vx vy] in *. lra. }
  destruct multiple as (c & cx & cy). unfold along in cx, cy. rewrite <- !minus_is in cx, cy.
  destruct (RealSmall.eventually_and _ _ (RealSmall.eventually_positive j c (proj1 range_j))
    (RealSmall.eventually_and _ _ (RealSmall.eventually_positive (1 - j)%R (- c)%R ltac:(Lra.lra))
      (RealSmall.eventually_positive (1 - k)%R (-1)%R ltac:(Lra.lra)))) as (bound & some & small).
  destruct (some_rational k (k + bound)%R) as (a & A); [Lra.lra |].
  destruct (some_rational (Q2R a) (k + bound)%R) as (b & B); [Lra.lra |].
  assert (on : forall q, (k < Q2R q < k + bound)%R -> (0 <= Q2R q <= 1)%R /\ lies_on (point_at s q) t).
  { intros q close. destruct (small (Q2R q - k)%R) as (low & high & below); [Lra.lra | Lra.lra |]. split; [Lra.lra |].
    apply lies_on_is. rewrite <- point_at_is. exists (j + (Q2R q - k) * c)%R. split; [Lra.lra |].
    unfold RealPiece.point_at. unfold RealWinding.minus in *.
    cbn [real_segment RealWinding.source RealWinding.target RealDirection.vx RealDirection.vy] in *.
    rewrite sx in tx. rewrite sy in ty. clear - tx ty cx cy. split; RealWinding.by_equations. }
  destruct (on a) as [[a0 _] on_a]; [Lra.lra |]. destruct (on b) as [[_ b1] on_b]; [Lra.lra |].
  exists a, b. rewrite <- real_zero in a0. apply Rle_Qle in a0.
  split; [exact a0 |]. split; [now apply Rlt_Qlt |]. split; [| now split].
  apply Rle_Qle. now replace (Q2R 1) with 1%R by (unfold Q2R; cbn; field).
Qed.

(* Theorem. A rational region is valid over the reals if and only if it is valid over the rationals. *)
Theorem valid_regions_agree (r : region) : RealTheorem.valid_region (real_region r) <-> valid_region r.
Proof.
  unfold RealTheorem.valid_region, valid_region.
  enough (no_edges_are_points r ->
    (RealEdges.edges_meet_in_vertices (real_region r) <-> edges_meet_in_vertices r)) as meet.
  { rewrite edges_are_no_points_over_both, nowhere_negative_over_both. tauto. }
  intros edges_are_long. split; intros meet earlier s later t w is_ I on_s on_t.
  - apply is_vertex_is.
    apply (meet (map real_segment earlier) (real_segment s) (map real_segment later) (real_segment t)).
    + now rewrite region_edges_are, is_, map_app.
    + rewrite <- map_app. now apply in_map.
    + now apply lies_on_is.
    + now apply lies_on_is.
  - assert (S : In s (RealRegions.region_edges (real_region r))) by (rewrite is_; apply in_elt).
    assert (T : In t (RealRegions.region_edges (real_region r))).
    { rewrite is_. apply in_app_iff in I. apply in_app_iff. cbn [In]. tauto. }
    assert (inside_or_vertex : forall u, In u (RealRegions.region_edges (real_region r)) -> RealWinding.lies_on w u ->
      RealWinding.strictly_inside w u \/ RealEdges.is_vertex w (real_region r)).
    { intros u U on. destruct (RealWinding.inside_or_end w u on) as [inside_ | [equal | equal]]; [now left | right ..].
      - exists u. split; [exact U |]. destruct equal as [X Y]. split; now symmetry.
      - apply (RealEdges.vertex_of_equal _ _ _ equal), RealEdges.target_is_vertex, U. }
    destruct (inside_or_vertex s S on_s) as [inside_s |]; trivial.
    destruct (inside_or_vertex t T on_t) as [inside_t |]; trivial.
    rewrite region_edges_are in is_. apply map_eq_app in is_. destruct is_ as (l & m & is_ & <- & rest).
    apply map_eq_cons in rest. destruct rest as (s' & m' & -> & <- & <-). rewrite <- map_app in I.
    apply in_map_iff in I. destruct I as (t' & <- & I).
    assert (long : forall u, In u (region_edges r) -> nonzero (along u)).
    { intros u U. apply in_flat_map in U. destruct U as (chain & C & U). apply (edges_are_long chain C).
      unfold edge_directions. now apply (in_map (fun e => minus (target e) (source e))). }
    assert (T' : In t' (region_edges r)).
    { rewrite is_. apply in_app_iff in I. apply in_app_iff. cbn [In]. tauto. }
    destruct (Qeq_dec (area s' (source t')) (area s' (target t'))) as [parallel | crosses].
    + destruct (real_overlap_is_rational s' t' w) as (a & b & first & less & last_ & on_a & on_b); trivial;
        [now apply long |].
      destruct (edges_do_not_overlap r l m' s' t' a b); trivial. apply long. rewrite is_. apply in_elt.
    + destruct (crossing_is_rational s' t' w crosses on_s on_t) as (v & ->). apply is_vertex_is.
      apply (meet l s' m' t'); trivial; now apply lies_on_is.
Qed.

(* So regions that one can draw are valid over the reals, too: hypotheses are not empty there. *)
Example chamber_over_the_reals : RealTheorem.valid_region (real_region chamber).
Proof. apply valid_regions_agree, drawn_regions. Qed.

(* Theorem. Over the reals the Minkowski sum of two rational regions has the same rational points as over the
   rationals. *)
Theorem sums_agree (p q : region) (x : vector) : valid_region p -> valid_region q ->
  (RealRegions.in_sum (real_point x) (real_region p) (real_region q) <-> in_sum x p q).
Proof.
  intros p_valid q_valid. split.
  - intros common. destruct (on_or_off x (convolution_segments p q)) as [(s & I & on) | free].
    + apply vertex_edge_sums_are_in_the_sum. now apply (convolution_is_part_of_the_vertex_edge_sum p q x s).
    + apply positive_winding_number_iff_common_point; trivial.
      rewrite <- winding_numbers_agree, <- convolutions_agree.
      apply RealTheorem.positive_winding_number_iff_common_point; trivial; try now apply valid_regions_agree.
      rewrite convolutions_agree. now apply off_is.
  - intros (a & b & in_p & in_q & equal). exists (real_point a), (real_point b).
    split; [now apply points_of_regions_agree |]. split; [now apply points_of_regions_agree |].
    rewrite plus_is. now apply equal_is.
Qed.
