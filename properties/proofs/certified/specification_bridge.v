(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* What specification.v says of points, edges and winding numbers is what the other proofs say of vectors, segments and
   signed crossings (winding_number.v); and the checker's integers give the same. `boundary r` are the edges of a region
   as segments. *)
From Coq Require Import QArith Lqa ZArith Lia Bool List.
From Oplus Require Import convolution specification checker regions signed_crossings homogeneous_points.
Import ListNotations.

Open Scope Q_scope.

Definition as_vector (p : point) : vector := Vector (x_of p) (y_of p).
Definition as_point (v : vector) : point := Point (vx v) (vy v).

Lemma as_vector_of_point (v : vector) : as_vector (as_point v) = v.
Proof. now destruct v. Qed.

Definition boundary (r : polygonal_region) : list segment := map segment_of_hedge (hedges_of_region r).

Lemma boundary_is (r : polygonal_region) :
  boundary r = region_edges (map (map (fun p => vector_of (homogeneous p))) r).
Proof.
  unfold boundary, hedges_of_region, edges_of_region, region_edges. rewrite map_map.
  set (as_segment := fun e : point * point => segment_of_hedge (homogeneous (fst e), homogeneous (snd e))).
  induction r as [| c r IH]; [reflexivity |]. cbn [flat_map map]. rewrite map_app. f_equal; [clear IH | exact IH].
  unfold edges, edges_of_chain. destruct c as [| first rest]; [reflexivity |]. cbn [map rotated].
  change [vector_of (homogeneous first)] with (map (fun p => vector_of (homogeneous p)) [first]).
  rewrite <- map_app. change (vector_of (homogeneous first) :: map (fun p => vector_of (homogeneous p)) rest)
    with (map (fun p => vector_of (homogeneous p)) (first :: rest)).
  generalize (rest ++ [first]). generalize (first :: rest). clear first rest.
  induction l as [| a l IH]; intros [| b others]; [reflexivity .. |]. cbn. now rewrite IH.
Qed.

Lemma boundary_cycles (r : polygonal_region) : cycles (boundary r).
Proof. rewrite boundary_is. apply region_cycles. Qed.

(* Only the values of coordinates matter. *)
Lemma lies_on_of_equal (x y : vector) (a b c d : vector) :
  equal_vectors x y -> equal_vectors a c -> equal_vectors b d -> lies_on x (Segment a b) -> lies_on y (Segment c d).
Proof.
  intros [x1 x2] [a1 a2] [b1 b2] (t & range & X & Y). exists t. split; [exact range |]. cbn [source target] in *.
  rewrite <- x1, <- x2, <- a1, <- a2, <- b1, <- b2. tauto.
Qed.

(* What is between two points of a segment is on it. *)
Lemma common_part (s : segment) (v w y : vector) : lies_on v s -> lies_on w s -> lies_on y (Segment v w) -> lies_on y s.
Proof.
  intros (k & k_range & kx & ky) (l & l_range & lx & ly) (t & t_range & tx & ty). cbn [source target] in *.
  exists ((1 - t) * k + t * l). split; [nra | rewrite tx, ty, kx, ky, lx, ly; split; ring].
Qed.

Lemma at_most_is (a b : Q) : at_most a b = Qle_bool a b.
Proof.
  unfold at_most. destruct (Qle_bool a b) eqn:order_.
  - apply Qle_bool_iff in order_. destruct (Qcompare_spec a b); [reflexivity .. | lra].
  - destruct (Qcompare_spec a b); [| | reflexivity]; apply not_true_iff_false in order_; exfalso; apply order_;
      apply Qle_bool_iff; lra.
Qed.

Lemma turn_of_is_orientation (a b x : vector) : orientation a b x = (turn_of a b x ?= 0).
Proof. apply compare_as_difference. unfold turn_of. ring. Qed.

Lemma signed_crossing_of_equal (x y a b c d : vector) :
  equal_vectors x y -> equal_vectors a c -> equal_vectors b d ->
  signed_crossing x (Segment a b) = signed_crossing y (Segment c d).
Proof.
  intros [x1 x2] [a1 a2] [b1 b2]. unfold signed_crossing, at_most. cbn [source target].
  rewrite !turn_of_is_orientation. unfold turn_of. now rewrite x1, x2, a1, a2, b1, b2.
Qed.

(* A signed crossing by signs: above is what is strictly higher than x. *)
Lemma signed_crossing_by_turn (x a b : vector) :
  signed_crossing x (Segment a b) =
  match Qle_bool (vy a) (vy x), Qle_bool (vy b) (vy x) with
  | true, false => if Qle_bool (turn_of a b x) 0 then 0%Z else 1%Z
  | false, true => if Qle_bool 0 (turn_of a b x) then 0%Z else (-1)%Z
  | _, _ => 0%Z
  end.
Proof.
  unfold signed_crossing, ray_crossing. cbn [source target].
  rewrite turn_of_is_orientation, (at_most_is (vy a)), (at_most_is (vy b)).
  generalize (Qle_bool (vy a) (vy x)) (Qle_bool (vy b) (vy x)) (turn_of a b x). intros a_below b_below side.
  rewrite <- (at_most_is side 0), <- (at_most_is 0 side). unfold at_most. rewrite <- (Qcompare_antisym side).
  destruct a_below, b_below, (side ?= 0); reflexivity.
Qed.

Definition ends_of (e : edge) : segment := Segment (as_vector (fst e)) (as_vector (snd e)).

Lemma is_on_is (x : point) (e : edge) :
  is_on x e <-> lies_on (as_vector x) (segment_of_hedge (homogeneous (fst e), homogeneous (snd e))).
Proof.
  unfold is_on. pose proof (homogeneous_is (fst e)) as first_is. pose proof (homogeneous_is (snd e)) as second_is.
  split; intros on.
  - apply (lies_on_of_equal (as_vector x) _ (as_vector (fst e)) (as_vector (snd e)));
      [reflexivity | now symmetry .. | exact on].
  - refine (lies_on_of_equal _ (as_vector x) _ _ (as_vector (fst e)) (as_vector (snd e)) _ _ _ on);
      [reflexivity | assumption ..].
Qed.

Lemma crossing_is (x : point) (e : edge) :
  specification.crossing x e = signed_crossing (as_vector x) (segment_of_hedge (homogeneous (fst e), homogeneous (snd e))).
Proof.
  transitivity (signed_crossing (as_vector x) (ends_of e)).
  - unfold ends_of. rewrite signed_crossing_by_turn. reflexivity.
  - apply signed_crossing_of_equal; [reflexivity | symmetry; apply homogeneous_is ..].
Qed.

Lemma winding_number_is (x : point) (r : polygonal_region) :
  region_winding_number x r = winding_number (as_vector x) (boundary r).
Proof.
  unfold region_winding_number, winding_number, sum, boundary, hedges_of_region. rewrite !map_map. f_equal.
  apply map_ext. intros e. apply crossing_is.
Qed.

(* Theorem. The points of a region, in the words of the other proofs. *)
Theorem member_is (x : point) (r : polygonal_region) :
  member x r <->
  (exists s, In s (boundary r) /\ lies_on (as_vector x) s) \/ winding_number (as_vector x) (boundary r) <> 0%Z.
Proof.
  unfold member. rewrite winding_number_is. unfold boundary, hedges_of_region. rewrite map_map.
  split; (intros [(e & there & on) | round]; [left | now right]).
  - exists (segment_of_hedge (homogeneous (fst e), homogeneous (snd e))). split; [| now apply is_on_is].
    apply in_map_iff. now exists e.
  - apply in_map_iff in there. destruct there as (edge_ & <- & there). exists edge_. split; [exact there |].
    now apply is_on_is.
Qed.

(* The same of what is inside and not on the boundary. *)
Lemma inner_point_by_boundary (x : point) (r : polygonal_region) : is_inner_point x r <->
  winding_number (as_vector x) (boundary r) <> 0%Z /\ off (as_vector x) (boundary r).
Proof.
  unfold is_inner_point. rewrite winding_number_is. unfold boundary, hedges_of_region. rewrite map_map.
  split; intros [round free]; (split; [exact round |]).
  - intros s S on. apply in_map_iff in S. destruct S as (e & <- & E). now apply (free e E), is_on_is.
  - intros e E on. apply is_on_is in on. refine (free _ _ on). apply in_map_iff. now exists e.
Qed.

(* What the checker computes. *)
Lemma left_turn_sign (a b c : hpoint) :
  inject_Z (left_turn a b c) == turn_of (vector_of a) (vector_of b) (vector_of c) *
    (inject_Z (Zpos (pw a)) * inject_Z (Zpos (pw b)) * inject_Z (Zpos (pw c))).
Proof. unfold left_turn. rewrite value_is, value_of_line_through. ring. Qed.

Lemma product_with_positive (a k : Q) :
  0 < k -> (0 < a * k <-> 0 < a) /\ (a * k < 0 <-> a < 0) /\ (a * k == 0 <-> a == 0).
Proof.
  intros positive. destruct (Q_dec a 0) as [[low | high] | zero_].
  - assert (0 < - a * k) by (apply Qmult_lt_0_compat; lra). repeat split; intros; lra.
  - assert (0 < a * k) by (apply Qmult_lt_0_compat; lra). repeat split; intros; lra.
  - assert (a * k == 0) by (rewrite zero_; ring). repeat split; intros; lra.
Qed.

Lemma left_turn_compare (a b c : hpoint) :
  (left_turn a b c ?= 0)%Z = (turn_of (vector_of a) (vector_of b) (vector_of c) ?= 0).
Proof.
  set (k := inject_Z (Zpos (pw a)) * inject_Z (Zpos (pw b)) * inject_Z (Zpos (pw c))).
  assert (some : 0 < k) by (unfold k; repeat apply Qmult_lt_0_compat; apply positive_denominator).
  pose proof (left_turn_sign a b c) as value_. fold k in value_.
  destruct (product_with_positive (turn_of (vector_of a) (vector_of b) (vector_of c)) k some) as (up & down & none).
  rewrite <- value_ in up, down, none. change 0 with (inject_Z 0) in up, down, none at 1.
  rewrite <- Zlt_Qlt in up, down. rewrite inject_Z_injective in none.
  destruct (Z.compare_spec (left_turn a b c) 0) as [zero_ | low | high]; symmetry.
  - apply (proj1 (Qeq_alt _ _)). now apply none.
  - apply (proj1 (Qlt_alt _ _)). now apply down.
  - apply (proj1 (Qgt_alt _ _)). now apply up.
Qed.

Lemma hcrossing_is (x : hpoint) (e : hedge) : hcrossing x e = signed_crossing (vector_of x) (segment_of_hedge e).
Proof.
  destruct e as [a b]. unfold hcrossing, segment_of_hedge. cbn [fst snd].
  assert (below : forall c,
    (py c * Zpos (pw x) <=? py x * Zpos (pw c))%Z = at_most (vy (vector_of c)) (vy (vector_of x))).
  { intros c. rewrite at_most_is. reflexivity. }
  rewrite !below. unfold signed_crossing, ray_crossing. cbn [source target].
  rewrite turn_of_is_orientation, <- left_turn_compare.
  unfold Z.leb. rewrite (Z.compare_antisym (left_turn a b x) 0).
  destruct (at_most (vy (vector_of a)) (vy (vector_of x))), (at_most (vy (vector_of b)) (vy (vector_of x))),
    (left_turn a b x ?= 0)%Z; reflexivity.
Qed.

Lemma hwinding_is (x : hpoint) (es : list hedge) : hwinding x es = winding_number (vector_of x) (map segment_of_hedge es).
Proof.
  unfold hwinding, winding_number, sum. rewrite map_map.
  assert (from_count : forall l count,
    fold_left (fun c e => c + hcrossing x e)%Z l count =
    (count + fold_right Z.add 0 (map (fun e => signed_crossing (vector_of x) (segment_of_hedge e)) l))%Z).
  { induction l as [| e l IH]; intros count; cbn [fold_left map fold_right]; [lia |]. rewrite IH, hcrossing_is. lia. }
  now rewrite from_count.
Qed.
