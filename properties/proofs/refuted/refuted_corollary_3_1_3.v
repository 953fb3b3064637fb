(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Corollary 3.1.3 is false as printed. It says that the boundary of each face interior to the sum is one weakly
   simple chain. Where the sum has a hole, it is two chains: P is a square room with a slit in its right wall, a
   simple polygon, Q a small square that does not pass the slit; their sum is the square from (0, 0) to (7, 7) without
   the open square from (3, 3) to (4, 4). The points between the two squares are inner points, so an edge of a chain
   on the boundary cannot lead from the one square to the other. That each chain of a boundary is weakly simple is not
   proved. *)
From Coq Require Import QArith Qminmax Lqa Qfield ZArith Lia Bool List Arith.
From Oplus Require Import convolution convolution_winding regions meeting_of_segments neighbourhoods interiors_meet
  theorem_4_2_1 theorem_2_2_10 observation_2_2_4 lemma_2_2_2 simple_chain simple_chains_turn_once simple_polygons
  valid_components polygons_of_the_thesis drawn_regions drawn_sums printed_lemma_2_2_2 refuted_definition_2_1_9
  connected_sets.
Import ListNotations.

Open Scope Q_scope.

(* The face around an inner point a: the inner points to which paths of inner points lead. *)
Definition face_of_the_sum (p q : region) (a : vector) : vector -> Prop :=
  connected_in (fun z => inner_point_of_sum z p q) a.

Definition corollary_3_1_3_as_printed : Prop :=
  forall (p q : list vector) (a : vector), simple_polygon p -> simple_polygon q -> inner_point_of_sum a [p] [q] ->
    exists chain, weakly_simple chain /\
      forall x, on_boundary_of_set (face_of_the_sum [p] [q] a) x <-> on_boundary x [chain].

Definition room_with_a_slit : list vector :=
  points_at [(0, 0); (6, 0); (6, 5 # 2); (4, 5 # 2); (4, 2); (2, 2); (2, 4); (4, 4); (4, 3); (6, 3); (6, 6); (0, 6)].
Definition unit_square : list vector := points_at [(0, 0); (1, 0); (1, 1); (0, 1)].

Lemma they_are_polygons : simple_polygon room_with_a_slit /\ simple_polygon unit_square.
Proof. split; (split; [apply is_simple_decides |]); vm_compute; reflexivity. Qed.

Lemma unit_square_contains (a b : Q) : 0 <= a <= 1 -> 0 <= b <= 1 -> in_region (Vector a b) [unit_square].
Proof.
  intros A B. destruct (Qeq_dec b 0) as [low |]; [right | destruct (Qeq_dec b 1) as [high |]; [right |
    destruct (Qeq_dec a 0) as [left_ |]; [right | destruct (Qeq_dec a 1) as [right_ |]; [right | left]]]].
  - exists (Segment (Vector 0 0) (Vector 1 0)). split; [vm_compute; tauto |]. exists a. cbn. split; [exact A |]. lra.
  - exists (Segment (Vector 1 1) (Vector 0 1)). split; [vm_compute; tauto |]. exists (1 - a). cbn. split; [lra |]. lra.
  - exists (Segment (Vector 0 1) (Vector 0 0)). split; [vm_compute; tauto |]. exists (1 - b). cbn. split; [lra |]. lra.
  - exists (Segment (Vector 1 0) (Vector 1 1)). split; [vm_compute; tauto |]. exists b. cbn. split; [exact B |]. lra.
  - assert (one : winding_number (Vector a b) (region_edges [unit_square]) = 1%Z); [| rewrite one; reflexivity].
    assert (0 < a /\ a < 1 /\ 0 < b /\ b < 1)
      by (repeat split; match goal with |- ?x < ?y => destruct (Qlt_le_dec x y); [assumption | exfalso; lra] end).
    number_by_arithmetic.
Qed.

(* Between the two squares. *)
Definition is_between_the_squares (x : vector) : Prop :=
  (0 < vx x /\ vx x < 7) /\ (0 < vy x /\ vy x < 7) /\ (vx x < 3 \/ 4 < vx x \/ vy x < 3 \/ 4 < vy x).

Lemma inner_points_between_the_squares (x : vector) :
  is_between_the_squares x -> inner_point_of_sum x [room_with_a_slit] [unit_square].
Proof.
  destruct x as [a b]. intros (A & B & beside). cbn [vx vy] in *.
  assert (found : forall c d e f, inside (Vector c d) [room_with_a_slit] -> 0 <= e <= 1 -> 0 <= f <= 1 ->
    a == c + e -> b == d + f -> inner_point_of_sum (Vector a b) [room_with_a_slit] [unit_square]).
  { intros c d e f in_room E F X Y.
    apply (inner_plus_point _ _ (Vector c d) (Vector e f)); [exact in_room | now apply unit_square_contains |].
    split; unfold plus; cbn [vx vy]; lra. }
  destruct (Qlt_le_dec b 3) as [low |]; [| destruct (Qlt_le_dec 4 b) as [high |];
    [| destruct (Qlt_le_dec a 3) as [left_ |]; [| destruct (Qlt_le_dec b (7 # 2)) as [below | above]]]].
  - apply (found ((6 # 7) * a) ((2 # 3) * b) ((1 # 7) * a) ((1 # 3) * b)); try lra. inside_by_arithmetic.
  - apply (found ((6 # 7) * a) (4 + (2 # 3) * (b - 4)) ((1 # 7) * a) ((1 # 3) * (b - 4))); try lra.
    inside_by_arithmetic.
  - apply (found ((2 # 3) * a) ((6 # 7) * b) ((1 # 3) * a) ((1 # 7) * b)); try lra. inside_by_arithmetic.
  - apply (found (4 + (2 # 3) * (a - 4)) (b - 1) ((1 # 3) * (a - 4)) 1); try lra. inside_by_arithmetic.
  - apply (found (4 + (2 # 3) * (a - 4)) b ((1 # 3) * (a - 4)) 0); try lra. inside_by_arithmetic.
Qed.

(* The boundary of a face is off the inner points. *)
Lemma inner_points_are_on_no_boundary (p q : region) (a x : vector) :
  inner_point_of_sum x p q -> ~ on_boundary_of_set (face_of_the_sum p q a) x.
Proof.
  intros (radius & R & inner) boundary.
  destruct (boundary ((1 # 2) * radius)) as [(y & near_y & path & walk) (z & near_z & outside)]; [lra |].
  apply outside. exists (path ++ [y]). apply leads_further; [exact walk |].
  intros w on. exists ((1 # 2) * radius). split; [lra |]. intros v near_v. apply inner.
  pose proof (within_along _ _ _ _ _ near_y near_z on). unfold within in *. lra.
Qed.

(* Points in the small square, and points that are not between the sides of the large one. *)
Definition is_in_the_small_square (x : vector) : Prop := 3 <= vx x <= 4 /\ 3 <= vy x <= 4.
Definition is_beyond_the_large_square (x : vector) : Prop := vx x <= 0 \/ 7 <= vx x \/ vy x <= 0 \/ 7 <= vy x.

Lemma where_it_is (x : vector) :
  is_between_the_squares x \/ is_in_the_small_square x \/ is_beyond_the_large_square x.
Proof.
  unfold is_between_the_squares, is_in_the_small_square, is_beyond_the_large_square.
  destruct (Qlt_le_dec 0 (vx x)); [| tauto]. destruct (Qlt_le_dec (vx x) 7); [| tauto].
  destruct (Qlt_le_dec 0 (vy x)); [| tauto]. destruct (Qlt_le_dec (vy x) 7); [| tauto].
  destruct (Qlt_le_dec (vx x) 3); [tauto |]. destruct (Qlt_le_dec 4 (vx x)); [tauto |].
  destruct (Qlt_le_dec (vy x) 3); [tauto |]. destruct (Qlt_le_dec 4 (vy x)); [tauto |]. tauto.
Qed.

(* A segment from the one to the other has a point between the squares. *)
Lemma segments_pass_between (a b : vector) : is_in_the_small_square a -> is_beyond_the_large_square b ->
  exists z, lies_on z (Segment a b) /\ is_between_the_squares z.
Proof.
  destruct a as [a1 a2], b as [b1 b2]. unfold is_in_the_small_square, is_beyond_the_large_square. cbn [vx vy].
  intros [A1 A2] B.
  assert (largest : exists m, 7 # 2 <= m /\ - m <= b1 - (7 # 2) <= m /\ - m <= b2 - (7 # 2) <= m /\
    (b1 - (7 # 2) == m \/ b1 - (7 # 2) == - m \/ b2 - (7 # 2) == m \/ b2 - (7 # 2) == - m)).
  { destruct (Qlt_le_dec (b1 - (7 # 2)) 0), (Qlt_le_dec (b2 - (7 # 2)) 0).
    - destruct (Qlt_le_dec b1 b2); [exists ((7 # 2) - b1) | exists ((7 # 2) - b2)]; repeat split; lra.
    - destruct (Qlt_le_dec ((7 # 2) - b1) (b2 - (7 # 2))); [exists (b2 - (7 # 2)) | exists ((7 # 2) - b1)]; repeat
      split; lra.
    - destruct (Qlt_le_dec (b1 - (7 # 2)) ((7 # 2) - b2)); [exists ((7 # 2) - b2) | exists (b1 - (7 # 2))]; repeat
      split; lra.
    - destruct (Qlt_le_dec b1 b2); [exists (b2 - (7 # 2)) | exists (b1 - (7 # 2))]; repeat split; lra. }
  destruct largest as (m & M & range1 & range2 & attained).
  assert (k_m : 2 / m * m == 2) by (field; lra). set (k := 2 / m) in *. clearbody k.
  assert (K : 0 < k /\ k < 1) by (split; nra).
  assert (bound1 : - (2) <= k * (b1 - (7 # 2)) <= 2) by (split; nra).
  assert (bound2 : - (2) <= k * (b2 - (7 # 2)) <= 2) by (split; nra).
  assert (small1 : - (1 # 2) <= (1 - k) * (a1 - (7 # 2)) <= 1 # 2) by (split; nra).
  assert (small2 : - (1 # 2) <= (1 - k) * (a2 - (7 # 2)) <= 1 # 2) by (split; nra).
  assert (far : k * (b1 - (7 # 2)) == 2 \/ k * (b1 - (7 # 2)) == - (2) \/ k * (b2 - (7 # 2)) == 2 \/
    k * (b2 - (7 # 2)) == - (2)).
  { destruct attained as [e | [e | [e | e]]]; rewrite e; [left | right; left | do 2 right; left | do 3 right]; lra. }
  exists (Vector ((1 - k) * a1 + k * b1) ((1 - k) * a2 + k * b2)). split.
  - exists k. cbn [source target vx vy]. split; [lra |]. split; reflexivity.
  - unfold is_between_the_squares. cbn [vx vy]. repeat split; lra.
Qed.

Lemma part_between (w v z : vector) (s : segment) :
  lies_on w s -> lies_on v s -> lies_on z (Segment w v) -> lies_on z s.
Proof.
  intros (i & I & wx & wy) (j & J & vx_ & vy_) (k & K & zx & zy). cbn [source target] in *.
  exists ((1 - k) * i + k * j). split; [split; nra |]. rewrite zx, zy, wx, wy, vx_, vy_. split; ring.
Qed.

(* Vertices of a chain that is off what is between the squares are all in the small square, or none. *)
Section Chain.
  Variable chain : list vector.
  Hypothesis nothing_between : forall x, on_boundary x [chain] -> ~ is_between_the_squares x.

  Lemma one_side_of_an_edge (s : segment) (w v : vector) : In s (region_edges [chain]) -> lies_on w s -> lies_on v s ->
    is_in_the_small_square w -> is_in_the_small_square v.
  Proof.
    intros I on_w on_v in_. destruct (where_it_is v) as [between_ | [| beyond]]; [exfalso | assumption | exfalso].
    - apply (nothing_between v); [now exists s | exact between_].
    - destruct (segments_pass_between w v in_ beyond) as (z & on_z & between_).
      apply (nothing_between z); [| exact between_]. exists s. split; [exact I |].
      exact (part_between w v z s on_w on_v on_z).
  Qed.

  Lemma ends_of_edge (i : nat) : (i < length chain)%nat ->
    In (edge_at chain i) (region_edges [chain]) /\ lies_on (nth i chain nowhere) (edge_at chain i) /\
    lies_on (nth (fiber_grid.next i (length chain)) chain nowhere) (edge_at chain i).
  Proof.
    intros I. split; [apply edge_at_in_region; [now left | exact I] |]. rewrite edge_at_is by exact I.
    split; [apply (source_lies_on (Segment _ _)) | apply (target_lies_on (Segment _ _))].
  Qed.

  Lemma next_of_smaller (i n : nat) : (S i < n)%nat -> fiber_grid.next i n = S i.
  Proof. unfold fiber_grid.next. intros L. destruct (Nat.eqb_spec (S i) n); [lia | reflexivity]. Qed.

  Lemma back_to_the_first (i : nat) : (i < length chain)%nat ->
    is_in_the_small_square (nth i chain nowhere) -> is_in_the_small_square (nth 0 chain nowhere).
  Proof.
    induction i as [| i IH]; intros I in_; [exact in_ |]. apply IH; [lia |].
    destruct (ends_of_edge i) as (J & on_source & on_target); [lia |]. rewrite next_of_smaller in on_target by exact I.
    exact (one_side_of_an_edge _ _ _ J on_target on_source in_).
  Qed.

  Lemma from_the_first (i : nat) : (i < length chain)%nat ->
    is_in_the_small_square (nth 0 chain nowhere) -> is_in_the_small_square (nth i chain nowhere).
  Proof.
    induction i as [| i IH]; intros I in_; [exact in_ |].
    destruct (ends_of_edge i) as (J & on_source & on_target); [lia |]. rewrite next_of_smaller in on_target by exact I.
    apply (one_side_of_an_edge _ _ _ J on_source on_target), IH; [lia | exact in_].
  Qed.

  Lemma all_in_the_small_square (w v : vector) : on_boundary w [chain] -> on_boundary v [chain] ->
    is_in_the_small_square w -> is_in_the_small_square v.
  Proof.
    intros (s & S_ & on_w) (t & T & on_v) in_.
    destruct (edge_by_chain [chain] s S_) as (c & i & [<- | []] & I & ->).
    destruct (edge_by_chain [chain] t T) as (c & j & [<- | []] & J & ->).
    destruct (ends_of_edge i I) as (_ & on_i & _). destruct (ends_of_edge j J) as (_ & on_j & _).
    apply (one_side_of_an_edge _ _ _ T on_j on_v), from_the_first, (back_to_the_first i); trivial.
    exact (one_side_of_an_edge _ _ _ S_ on_w on_i in_).
  Qed.
End Chain.

(* Both squares are boundary of the face. *)
Definition inner_start : vector := Vector (7 # 2) (3 # 2).

Lemma up_and_down (height : Q) : 0 < height < 3 ->
  face_of_the_sum [room_with_a_slit] [unit_square] inner_start (Vector (7 # 2) height).
Proof.
  intros H. exists []. intros z (t & T & X & Y). apply inner_points_between_the_squares.
  unfold inner_start in *; cbn [source target vx vy] in *.
  assert (0 < vy z < 3) by (rewrite Y; split; nra).
  unfold is_between_the_squares. rewrite X. repeat split; lra.
Qed.

Lemma only_sums_in_the_face (x : vector) : face_of_the_sum [room_with_a_slit] [unit_square] inner_start x ->
  in_sum x [room_with_a_slit] [unit_square].
Proof.
  intros (path & walk). apply leads_to_a_point in walk. destruct walk as (radius & R & inner). apply inner.
  unfold within. lra.
Qed.

Lemma nothing_in_the_hole (height : Q) : 3 < height < 4 ->
  ~ in_sum (Vector (7 # 2) height) [room_with_a_slit] [unit_square].
Proof.
  intros H. rewrite <- positive_winding_number_iff_common_point by
    first [apply simple_polygons_are_regions, they_are_polygons | off_by_arithmetic].
  assert (none : winding_number (Vector (7 # 2) height) (convolution_segments [room_with_a_slit] [unit_square]) = 0%Z)
    by number_by_arithmetic.
  rewrite none. now apply Z.lt_irrefl.
Qed.

Lemma boundary_above_and_below (height : Q) :
  (forall radius, 0 < radius -> exists inner outer_, 0 < inner < 3 /\
     within radius (Vector (7 # 2) height) (Vector (7 # 2) inner) /\
     within radius (Vector (7 # 2) height) (Vector (7 # 2) outer_) /\
     ~ in_sum (Vector (7 # 2) outer_) [room_with_a_slit] [unit_square]) ->
  on_boundary_of_set (face_of_the_sum [room_with_a_slit] [unit_square] inner_start) (Vector (7 # 2) height).
Proof.
  intros near radius R. destruct (near radius R) as (inner & outer_ & H & near_inner & near_outer & outside). split.
  - exists (Vector (7 # 2) inner). split; [exact near_inner | now apply up_and_down].
  - exists (Vector (7 # 2) outer_). split; [exact near_outer |]. intros face. now apply outside, only_sums_in_the_face.
Qed.

(* Theorem. *)
Theorem corollary_3_1_3_is_false_as_printed : ~ corollary_3_1_3_as_printed.
Proof.
  intros printed. destruct they_are_polygons as [p_polygon q_polygon].
  destruct (printed room_with_a_slit unit_square inner_start p_polygon q_polygon) as (chain & _ & boundary).
  - apply inner_points_between_the_squares. unfold is_between_the_squares, inner_start. cbn [vx vy]. repeat split; lra.
  - assert (nothing_between : forall x, on_boundary x [chain] -> ~ is_between_the_squares x).
    { intros x on between_. apply boundary in on.
      now apply (inner_points_are_on_no_boundary _ _ inner_start x (inner_points_between_the_squares x between_)). }
    assert (sides : is_in_the_small_square (Vector (7 # 2) 0)); [| destruct sides as [_ low]; cbn in low; lra].
    apply (all_in_the_small_square chain nothing_between (Vector (7 # 2) 3)); [apply boundary .. |].
    + apply boundary_above_and_below. intros radius R. exists (3 - (1 # 2) * Qmin radius 1), (3 + (1 # 2) * Qmin
      radius 1).
      pose proof (Q.min_glb_lt radius 1 0 R ltac:(lra)). pose proof (Q.le_min_l radius 1).
      pose proof (Q.le_min_r radius 1). unfold within; cbn [vx vy].
      split; [lra |]. split; [lra |]. split; [lra |]. apply nothing_in_the_hole. lra.
    + apply boundary_above_and_below. intros radius R. exists ((1 # 2) * Qmin radius 1), (- (1 # 2) * Qmin radius 1).
      pose proof (Q.min_glb_lt radius 1 0 R ltac:(lra)). pose proof (Q.le_min_l radius 1).
      pose proof (Q.le_min_r radius 1). unfold within; cbn [vx vy].
      split; [lra |]. split; [lra |]. split; [lra |].
      apply (nothing_is_lower _ _ 0 0); [vm_compute; reflexivity .. |]. cbn [vy]. lra.
    + unfold is_in_the_small_square. cbn [vx vy]. split; lra.
Qed.
