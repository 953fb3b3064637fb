(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Rational points, segments and polygons as real ones. What the theory computes from comparisons of sums and products
   comes out the same over both numbers: sides of segments, winding numbers, tangent sets, the convolution. Short names
   are those of the rational version; real_ is before what is of the other. *)
From Coq Require Import Rbase QArith Qreals ZArith Bool List.
Require Import Oplus.directions.direction Oplus.winding.winding_number Oplus.winding.angular_crossings
  Oplus.directions.tangent_set Oplus.chains.turning_number Oplus.chains.convolution_size Oplus.cycles.fiber_grid
  Oplus.cycles.states Oplus.cycles.in_out_degree Oplus.theorem_4_2_1.convolution_winding Oplus.regions.regions
  Oplus.winding.location.
Require Oplus.reals.theorem_4_2_1.convolution_winding Oplus.reals.regions.regions Oplus.reals.winding.location.
Import ListNotations.

Module RealNumbers := Oplus.reals.numbers.numbers.
Module RealDirection := Oplus.reals.directions.direction.
Module RealTangentSet := Oplus.reals.directions.tangent_set.
Module RealWinding := Oplus.reals.winding.winding_number.
Module RealLocation := Oplus.reals.winding.location.
Module RealTurning := Oplus.reals.chains.turning_number.
Module RealSize := Oplus.reals.chains.convolution_size.
Module RealStates := Oplus.reals.cycles.states.
Module RealConvolution := Oplus.reals.theorem_4_2_1.convolution_winding.
Module RealDegree := Oplus.reals.cycles.in_out_degree.
Module RealRegions := Oplus.reals.regions.regions.

Open Scope Q_scope.

Definition real_point (v : vector) : RealDirection.vector := RealDirection.Vector (Q2R (vx v)) (Q2R (vy v)).
Definition real_segment (s : segment) : RealWinding.segment :=
  RealWinding.Segment (real_point (source s)) (real_point (target s)).
Definition real_chain : list vector -> list RealDirection.vector := map real_point.
Definition real_region : region -> RealDegree.region := map real_chain.

(* Comparisons. *)
Lemma compare_is (a b : Q) : RealNumbers.Qcompare (Q2R a) (Q2R b) = (a ?= b).
Proof.
  destruct (RealNumbers.Qcompare_spec (Q2R a) (Q2R b)) as [e | less | more]; symmetry.
  - apply Qeq_alt, eqR_Qeq, e.
  - apply Qlt_alt, Rlt_Qlt, less.
  - apply Qgt_alt, Rlt_Qlt, more.
Qed.

Lemma real_zero : Q2R 0 = 0%R.
Proof. unfold Q2R. cbn. apply Rmult_0_l. Qed.

Lemma negative_is (a : Q) : RealDirection.negative (Q2R a) = negative a.
Proof. unfold RealDirection.negative. now rewrite <- real_zero, compare_is. Qed.

Lemma zero_is (a : Q) : RealDirection.zero (Q2R a) = zero a.
Proof. unfold RealDirection.zero. now rewrite <- real_zero, compare_is. Qed.

Lemma at_most_is (a b : Q) : RealWinding.at_most (Q2R a) (Q2R b) = at_most a b.
Proof. unfold RealWinding.at_most. now rewrite compare_is. Qed.

Lemma minus_is (a b : vector) : RealWinding.minus (real_point a) (real_point b) = real_point (minus a b).
Proof.
  unfold RealWinding.minus, real_point. cbn [RealDirection.vx RealDirection.vy vx vy minus].
  now rewrite !Q2R_minus.
Qed.

Lemma plus_is (a b : vector) : RealDegree.plus (real_point a) (real_point b) = real_point (plus a b).
Proof.
  unfold RealDegree.plus, real_point. cbn [RealDirection.vx RealDirection.vy vx vy plus]. now rewrite !Q2R_plus.
Qed.

(* Winding numbers. *)
Lemma orientation_is (a b c : vector) :
  RealWinding.orientation (real_point a) (real_point b) (real_point c) = orientation a b c.
Proof.
  unfold RealWinding.orientation, real_point. cbn [RealDirection.vx RealDirection.vy].
  rewrite <- !Q2R_minus, <- !Q2R_mult. apply compare_is.
Qed.

Lemma signed_crossing_is (p : vector) (s : segment) :
  RealWinding.signed_crossing (real_point p) (real_segment s) = signed_crossing p s.
Proof.
  unfold RealWinding.signed_crossing. cbn [real_segment RealWinding.source RealWinding.target].
  rewrite orientation_is. cbn [real_point RealDirection.vy]. now rewrite !at_most_is.
Qed.

(* Theorem. The winding number of a rational point with respect to rational segments is the same over both. *)
Theorem winding_numbers_agree (p : vector) (segments : list segment) :
  RealWinding.winding_number (real_point p) (map real_segment segments) = winding_number p segments.
Proof.
  unfold RealWinding.winding_number, winding_number. rewrite map_map.
  rewrite (map_ext _ _ (signed_crossing_is p)). reflexivity.
Qed.

(* Points of segments, by comparisons. *)
Lemma is_on_segment_is (p : vector) (s : segment) :
  RealLocation.is_on_segment (real_point p) (real_segment s) = is_on_segment p s.
Proof.
  unfold RealLocation.is_on_segment, RealLocation.between.
  cbn [real_segment RealWinding.source RealWinding.target]. rewrite orientation_is.
  cbn [real_point RealDirection.vx RealDirection.vy]. now rewrite !at_most_is.
Qed.

Lemma lies_on_is (p : vector) (s : segment) :
  RealWinding.lies_on (real_point p) (real_segment s) <-> lies_on p s.
Proof.
  rewrite (reflect_iff _ _ (RealLocation.is_on_spec _ _)), (reflect_iff _ _ (is_on_spec _ _)), is_on_segment_is.
  reflexivity.
Qed.

(* Edges. *)
Lemma rotated_is (chain : list vector) : RealWinding.rotated (real_chain chain) = real_chain (rotated chain).
Proof. destruct chain; [reflexivity |]. cbn. unfold real_chain. now rewrite map_app. Qed.

Lemma combined {A B : Type} (f : A -> B) (l m : list A) :
  combine (map f l) (map f m) = map (fun ends => (f (fst ends), f (snd ends))) (combine l m).
Proof.
  revert m. induction l as [| a l IH]; intros [| b m]; try reflexivity. cbn [map combine fst snd]. now rewrite IH.
Qed.

Lemma edges_are (chain : list vector) : RealWinding.edges (real_chain chain) = map real_segment (edges chain).
Proof.
  unfold RealWinding.edges, edges. rewrite rotated_is. unfold real_chain. rewrite combined, !map_map. reflexivity.
Qed.

Lemma region_edges_are (r : region) :
  RealRegions.region_edges (real_region r) = map real_segment (region_edges r).
Proof.
  unfold RealRegions.region_edges, region_edges, real_region.
  induction r as [| chain r IH]; [reflexivity |]. cbn [map flat_map]. now rewrite IH, edges_are, map_app.
Qed.

(* The convolution. *)
Definition real_summand (s : summand) : RealDirection.summand :=
  match s with OfP => RealDirection.OfP | OfQ => RealDirection.OfQ end.
Definition real_direction (d : direction) : RealDirection.direction :=
  RealDirection.Direction (real_point (vec d)) (real_summand (of d)).
Definition real_corner (c : corner) : RealTangentSet.corner :=
  RealTangentSet.Corner (real_point (incoming c)) (real_point (outgoing c)).

Lemma half_is (v : vector) : RealDirection.half (real_point v) = half v.
Proof.
  unfold RealDirection.half. cbn [real_point RealDirection.vx RealDirection.vy]. now rewrite !negative_is, zero_is.
Qed.

Lemma compare_angle_is (u v : vector) : RealDirection.compare_angle (real_point u) (real_point v) = compare_angle u v.
Proof.
  unfold RealDirection.compare_angle. rewrite !half_is. cbn [real_point RealDirection.vx RealDirection.vy].
  now rewrite <- !Q2R_mult, compare_is.
Qed.

Lemma compare_directions_is (a b : direction) :
  RealDirection.compare (real_direction a) (real_direction b) = compare a b.
Proof.
  unfold RealDirection.compare. cbn [real_direction RealDirection.vec RealDirection.of]. rewrite compare_angle_is.
  unfold compare. now destruct (compare_angle _ _), (of a), (of b).
Qed.

Lemma ccw_is (d from to : direction) :
  RealDirection.ccw (real_direction d) (real_direction from) (real_direction to) = ccw d from to.
Proof. unfold RealDirection.ccw, RealDirection.before. now rewrite !compare_directions_is. Qed.

Lemma in_tangent_set_is (d : direction) (c : corner) :
  RealTangentSet.in_tangent_set (real_direction d) (real_corner c) = in_tangent_set d c.
Proof.
  unfold in_tangent_set. rewrite <- ccw_is. unfold RealTangentSet.in_tangent_set, real_direction.
  cbn [real_corner RealTangentSet.incoming RealTangentSet.outgoing vec of RealDirection.of]. now destruct (of d).
Qed.

Lemma edge_directions_are (chain : list vector) :
  RealTurning.edge_directions (real_chain chain) = real_chain (edge_directions chain).
Proof.
  unfold RealTurning.edge_directions, edge_directions. rewrite edges_are. unfold real_chain. rewrite !map_map.
  apply map_ext. intros e. apply minus_is.
Qed.

Lemma corners_are (chain : list vector) : RealTurning.corners (real_chain chain) = map real_corner (corners chain).
Proof.
  unfold RealTurning.corners, corners. rewrite edge_directions_are.
  assert (last_first : forall l, RealTurning.from_the_last (real_chain l) = real_chain (from_the_last l)).
  { intros l. unfold RealTurning.from_the_last, from_the_last, real_chain. rewrite <- map_rev.
    destruct (rev l); [reflexivity |]. cbn [map]. now rewrite map_rev. }
  rewrite last_first. unfold real_chain. rewrite combined, !map_map. reflexivity.
Qed.

Lemma nowhere_is : RealSize.nowhere = real_point nowhere.
Proof. unfold real_point. cbn [nowhere vx vy]. now rewrite real_zero. Qed.

Lemma is_convolution_segment_is (p q : list vector) (s : summand) (i j : nat) :
  RealSize.is_convolution_segment (real_chain p) (real_chain q) (real_summand s) i j = is_convolution_segment p q s i j.
Proof.
  assert (corner_is : forall c k,
    RealSize.corner_of_chain (real_chain c) k = real_corner (corner_of_chain c k)).
  { intros c k. unfold RealSize.corner_of_chain. rewrite corners_are, nowhere_is.
    exact (map_nth real_corner (corners c) (Corner nowhere nowhere) k). }
  assert (edge_is : forall c k, RealSize.edge_of_chain (real_chain c) k = real_point (edge_of_chain c k)).
  { intros c k. unfold RealSize.edge_of_chain. rewrite edge_directions_are, nowhere_is. apply map_nth. }
  destruct s; cbn [real_summand RealSize.is_convolution_segment is_convolution_segment];
    rewrite corner_is, edge_is;
    [exact (in_tangent_set_is (Direction _ OfP) _) | exact (in_tangent_set_is (Direction _ OfQ) _)].
Qed.

Definition real_name (s : named_segment) : RealStates.named_segment := (real_summand (fst s), snd s).

Lemma filtered {A B : Type} (f : A -> B) (test : B -> bool) (own : A -> bool) (l : list A) :
  (forall a, test (f a) = own a) -> filter test (map f l) = map f (filter own l).
Proof.
  intros same. induction l as [| a l IH]; [reflexivity |]. cbn [map filter]. rewrite same, IH. now destruct (own a).
Qed.

Lemma convolution_is (p q : list vector) :
  RealSize.convolution (real_chain p) (real_chain q) = map real_name (convolution p q).
Proof.
  unfold RealSize.convolution, convolution, real_chain. rewrite !map_length.
  rewrite <- (filtered real_name (fun s => RealSize.is_convolution_segment (map real_point p) (map real_point q) (fst s)
    (fst (snd s)) (snd (snd s)))).
  - f_equal. cbn [list_prod app]. rewrite !map_app, !map_map. reflexivity.
  - intros [s [i j]]. apply is_convolution_segment_is.
Qed.

(* Theorem. The convolution of two rational regions is the same over both. *)
Theorem convolutions_agree (p q : region) :
  RealConvolution.convolution_segments (real_region p) (real_region q) = map real_segment (convolution_segments p q).
Proof.
  unfold RealConvolution.convolution_segments, convolution_segments, RealDegree.segments_of_regions,
    segments_of_regions.
  assert (pairs : forall r, list_prod (real_region p) (real_region r) =
    map (fun chains => (real_chain (fst chains), real_chain (snd chains))) (list_prod p r)).
  { intros r. unfold real_region. induction p as [| chain rest IH]; [reflexivity |]. cbn [map list_prod].
    rewrite IH, map_app, !map_map. reflexivity. }
  rewrite pairs. clear pairs. induction (list_prod p q) as [| [a b] rest IH]; [reflexivity |].
  cbn [map flat_map fst snd]. rewrite !map_app. f_equal; [| exact IH]. rewrite convolution_is, !map_map. apply map_ext.
  assert (point_is : forall at_,
    RealDegree.point_of (real_chain a, real_chain b) at_ = real_point (point_of (a, b) at_)).
  { intros at_. unfold RealDegree.point_of, point_of. cbn [fst snd]. rewrite <- plus_is, nowhere_is.
    unfold real_chain. now rewrite !map_nth. }
  intros [s at_]. unfold RealDegree.starts_at, RealDegree.ends_at, starts_at, ends_at, real_segment.
  cbn [fst snd source target real_name]. unfold RealStates.state_before, RealStates.state_after, real_chain.
  cbn [fst snd]. rewrite !map_length. fold (real_chain a) (real_chain b). rewrite !point_is. now destruct s.
Qed.
