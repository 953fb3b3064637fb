(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Theorem 3.2.8 as printed: a dangling edge exists only where convolution segments of opposite directions overlap. P
   and Q are open (Section 3.2.4): their sum are the points x for which P and -Q + x have an inner point in common. A
   dangling edge (Definition 3.2.7) is on the boundary of the sum, and touches it on both sides. All points of such an
   edge, also sums of two vertices, are on a segment of the convolution with the edge's direction, and on one with the
   opposite direction; even segments of the reduced convolution do. For all but finitely many of its points this is
   proved in theorem_3_2_8.v; these are near all others, and segments are closed. *)
From Coq Require Import ZArith Lia Bool List.
From Oplus Require Import numbers regions_and_sums signed_crossings observation_2_2_4 theorem_2_2_10 parallelogram
  beside_a_piece inside_a_corner boundary_points reduced_convolution fans_that_touch theorem_3_2_8.
Import ListNotations.

Open Scope Q_scope.

Definition sum_is_beside (e : segment) (p q : region) (x : vector) (is_beside : Q -> Prop) : Prop :=
  forall radius, 0 < radius -> exists y, within radius x y /\ is_beside (area e y) /\ interiors_meet y p q.

(* Definition 3.2.7. *)
Definition dangling_edge (e : segment) (p q : region) : Prop :=
  nonzero (along e) /\
  forall x, strictly_inside x e -> ~ interiors_meet x p q /\
    sum_is_beside e p q x (fun area => 0 < area) /\ sum_is_beside e p q x (fun area => area < 0).

Section DanglingEdge.
  Variables p q : region.
  Hypothesis p_region : valid_region p.
  Hypothesis q_region : valid_region q.
  Variable e : segment.
  Hypothesis dangling : dangling_edge e p q.

  Let segments := convolution_segments p q.
  Let long : nonzero (along e) := proj1 dangling.

  (* At most points of the edge all segments that pass are along it. *)
  Definition is_general (x : vector) : Prop :=
    (forall t, In t segments -> lies_on x t -> collinear e t) /\
    forall w u, is_vertex w p -> is_vertex u q -> ~ equal_vectors x (plus w u).

  Lemma most_points_are_general (x u : vector) : lies_on x e -> nonzero u -> cross (along e) u == 0 ->
    eventually (fun d => is_general (moved_along x u d)).
  Proof.
    intros on moves line. apply eventually_and.
    - apply (eventually_for_all (fun t d => lies_on (moved_along x u d) t -> collinear e t)). intros t T.
      destruct (collinear_dec e t) as [yes | no]; [exists 1; split; [lra | now intros] |].
      assert (on_line : forall d, area e (moved_along x u d) == 0).
      { intros d. rewrite (area_from x _ e on). transitivity (d * cross (along e) u);
          [unfold cross, minus, moved_along; cbn [vx vy]; ring | rewrite line; ring]. }
      destruct (Qeq_dec (cross (along t) u) 0) as [parallel | turn].
      + exists 1. split; [lra |]. intros d _ _ (k & range & X & Y). exfalso. apply no.
        destruct (multiple_of (along t) u moves parallel) as (c & cx & cy).
        destruct (multiple_of (along e) u moves line) as (b & bx & by_). specialize (on_line d).
        assert (flat : cross (along e) (along t) == 0) by (unfold cross; rewrite bx, by_, cx, cy; ring).
        split.
        * transitivity (area e (moved_along x u d) - k * cross (along e) (along t)); [| rewrite on_line, flat; ring].
          set (y := moved_along x u d) in *. clearbody y. in_coordinates. rewrite X, Y. ring.
        * transitivity (area e (moved_along x u d) + (1 - k) * cross (along e) (along t));
            [| rewrite on_line, flat; ring].
          set (y := moved_along x u d) in *. clearbody y. in_coordinates. rewrite X, Y. ring.
      + refine (eventually_implied _ _ _ (leaves_a_number (area t x) (cross (along t) u) 0 turn)).
        intros d differ on_t. exfalso. apply differ. rewrite <- (on_the_line _ t on_t).
        unfold moved_along. in_coordinates. ring.
    - refine (eventually_implied _ _ _ (eventually_for_all (fun ends d =>
        ~ equal_vectors (moved_along x u d) (plus (source (fst ends)) (source (snd ends))))
        (list_prod (region_edges p) (region_edges q)) (fun ends _ => leaves_a_point x u _ moves))).
      intros d differ w v (s & S & [sx sy]) (t & T & [tx ty]) [X Y].
      apply (differ (s, t) (proj2 (in_prod_iff _ _ s t) (conj S T))). unfold plus in *. cbn [fst snd vx vy] in *.
      split; cbn [vx vy]; lra.
  Qed.

  Lemma open_on_a_side (x n : vector) (is_beside : Q -> Prop) : strictly_inside x e -> is_general x ->
    (is_beside = (fun area => 0 < area) /\ 0 < cross (along e) n \/
     is_beside = (fun area => area < 0) /\ cross (along e) n < 0) ->
    sum_is_beside e p q x is_beside -> eventually (fun t => interiors_meet (moved_along x n t) p q).
  Proof.
    intros inside_ [met _] side touches_. pose proof (strictly_inside_lies_on _ _ inside_) as on.
    pose proof p_region as (p_edges & _). pose proof q_region as (q_edges & _).
    destruct (off_near x (filter (fun t => if lies_on_dec x t then false else true) segments)) as (radius & R & near).
    { intros t T. apply filter_In in T. destruct T as [_ T]. now destruct (lies_on_dec x t). }
    assert (free : forall y, within radius x y -> ~ area e y == 0 -> off y segments).
    { intros y close aside t T on_t. destruct (lies_on_dec x t) as [on_x | off_x] eqn:decided.
      - exact (aside (area_of_collinear e t y (met t T on_x) on_t)).
      - apply (near y close t); [| exact on_t]. apply filter_In. split; [exact T | now rewrite decided]. }
    destruct (touches_ radius R) as (y & close_y & side_y & meets).
    refine (eventually_implied _ _ _ (eventually_and _ _ (small_steps_stay_within radius x n R)
      (eventually_below 1 ltac:(lra)))). intros t [close [some _]]. set (z := moved_along x n t) in *.
    assert (area_z : area e z == t * cross (along e) n).
    { rewrite (area_from x z e on). unfold z, cross, minus, moved_along. cbn [vx vy]. ring. }
    assert (way_is_free : forall w, lies_on w (Segment y z) -> off w segments).
    { intros w on_way. apply free; [exact (within_along radius x y z w close_y close on_way) |].
      destruct side as [[-> left_] | [-> right_]].
      - assert (0 < area e z) by (rewrite area_z; now apply Qmult_lt_0_compat).
        destruct on_way as (k & range & X & Y). cbn [source target] in X, Y.
        assert (value : area e w == (1 - k) * area e y + k * area e z) by (in_coordinates; rewrite X, Y; ring).
        pose proof (mixed_is_more k (area e y) (area e z) 0 range side_y ltac:(assumption)). lra.
      - assert (area e z < 0) by (rewrite area_z; nra).
        pose proof (area_between e y z w side_y ltac:(assumption) on_way). lra. }
    pose proof (winding_number_along _ segments (convolution_is_closed p q p_edges q_edges) way_is_free) as same_number.
    cbn [source target] in same_number.
    apply (positive_winding_number_iff_common_inner_point p q z p_region q_region);
      [exact (way_is_free z (target_lies_on (Segment y z))) |]. fold segments. rewrite <- same_number.
    apply (positive_winding_number_iff_common_inner_point p q y p_region q_region); [| exact meets].
    exact (way_is_free y (source_lies_on (Segment y z))).
  Qed.

  Lemma general_points_are_on_opposite_segments (x : vector) : strictly_inside x e -> is_general x ->
    reduced_along p q x (along e) /\ reduced_along p q x (opposite (along e)).
  Proof.
    intros inside_ general. destruct (proj2 dangling x inside_) as (outside & left_ & right_).
    assert (along_ : forall u, u = along e \/ u = opposite (along e) ->
      eventually (fun t => ~ interiors_meet (moved_along x u t) p q)).
    { intros u which. destruct inside_ as (k & range & X & Y).
      refine (eventually_implied _ _ _ (eventually_and _ _ (eventually_below k ltac:(lra))
        (eventually_below (1 - k) ltac:(lra)))). intros t [low high].
      apply (proj2 dangling). destruct which as [-> | ->]; [exists (k + t) | exists (k - t)]; (split; [lra |]);
        unfold moved_along, opposite, along, minus; cbn [vx vy]; rewrite X, Y; split; ring. }
    set (n := Vector (- vy (along e)) (vx (along e))). pose proof (left_normal e long) as turn. fold n in turn.
    assert (back : cross (along e) (opposite n) < 0) by (unfold cross, opposite in *; cbn [vx vy]; lra).
    apply (dangling_edges_are_on_opposite_segments p q x (along e) p_region q_region); [| apply general].
    split; [exact outside |]. split; [exact (along_ _ (or_introl eq_refl)) |].
    split; [exact (along_ _ (or_intror eq_refl)) |]. split.
    - exists n. split; [exact turn |]. apply (open_on_a_side x n (fun area => 0 < area)); auto.
    - exists (opposite n). split; [exact back |]. apply (open_on_a_side x (opposite n) (fun area => area < 0)); auto.
  Qed.

  (* Segments are closed. *)
  Lemma covered_if_near_points_are (x D : vector) : nonzero D -> lies_on x e ->
    (forall y, strictly_inside y e -> is_general y -> reduced_along p q y D) -> reduced_along p q x D.
  Proof.
    intros long_D on covered_.
    set (ahead_ s := if Qeq_dec (cross (along s) D) 0 then if Qlt_le_dec 0 (dot D (along s)) then true else false
      else false).
    assert (ahead_is : forall s, ahead_ s = true <-> same_direction (along s) D).
    { intros s. unfold ahead_. split.
      - destruct (Qeq_dec (cross (along s) D) 0) as [flat |]; [| discriminate].
        destruct (Qlt_le_dec 0 (dot D (along s))) as [some |]; [| discriminate]. intros _. now apply parallel_and_ahead.
      - intros (a & some & X & Y). pose proof (square_positive D long_D) as square. unfold dot in square.
        destruct (Qeq_dec (cross (along s) D) 0) as [_ | turn];
          [| exfalso; apply turn; unfold cross; rewrite X, Y; ring].
        destruct (Qlt_le_dec 0 (dot D (along s))) as [_ | none]; [reflexivity | exfalso].
        assert (0 < a * (vx D * vx D + vy D * vy D)) by now apply Qmult_lt_0_compat.
        unfold dot in none. rewrite X, Y in none. lra. }
    destruct (on_or_off x (filter ahead_ (reduced_convolution p q))) as [(s & S & on_s) | free].
    { apply filter_In in S. exists s. split; [apply S |]. split; [exact on_s | apply ahead_is, S]. }
    exfalso. destruct (off_near x _ free) as (radius & R & near).
    assert (found : forall u, nonzero u -> cross (along e) u == 0 ->
      eventually (fun d => strictly_inside (moved_along x u d) e) -> False).
    { intros u moves line inside_. destruct (some_small _ (eventually_and _ _ inside_ (eventually_and _ _
        (most_points_are_general x u on moves line) (small_steps_stay_within radius x u R))))
        as (d & _ & in_e & general & close).
      destruct (covered_ _ in_e general) as (s & S & on_s & same_). apply (near _ close s); [| exact on_s].
      apply filter_In. split; [exact S | now apply ahead_is]. }
    destruct on as (k & range & X & Y). destruct (Qlt_le_dec k 1) as [before_ | at_end].
    - apply (found (along e) long); [unfold cross; ring |].
      refine (eventually_implied _ _ _ (eventually_below (1 - k) ltac:(lra))). intros d d_range. exists (k + d).
      split; [lra |]. unfold moved_along, along, minus. cbn [vx vy]. rewrite X, Y. split; ring.
    - apply (found (opposite (along e)) (opposite_nonzero _ long)); [unfold cross, opposite; cbn [vx vy]; ring |].
      refine (eventually_implied _ _ _ (eventually_below 1 ltac:(lra))). intros d d_range. exists (k - d).
      split; [lra |]. unfold moved_along, opposite, along, minus. cbn [vx vy]. rewrite X, Y. split; ring.
  Qed.
End DanglingEdge.

(* Theorem 3.2.8, with segments of the reduced convolution. *)
Theorem theorem_3_2_8_by_reduced_segments (p q : region) (e : segment) (x : vector) :
  valid_region p -> valid_region q -> dangling_edge e p q -> lies_on x e ->
  (exists s, In s (reduced_convolution p q) /\ lies_on x s /\ same_direction (along s) (along e)) /\
  (exists s, In s (reduced_convolution p q) /\ lies_on x s /\ same_direction (along s) (opposite (along e))).
Proof.
  intros p_region q_region dangling on. pose proof (proj1 dangling) as long.
  pose proof (general_points_are_on_opposite_segments p q p_region q_region e dangling) as general. split.
  - apply (covered_if_near_points_are p q e dangling x _ long on). intros y inside_ is_. now apply general.
  - apply (covered_if_near_points_are p q e dangling x _ (opposite_nonzero _ long) on). intros y inside_ is_.
    now apply general.
Qed.

(* Theorem 3.2.8. *)
Theorem theorem_3_2_8_as_printed (p q : region) (e : segment) (x : vector) :
  valid_region p -> valid_region q -> dangling_edge e p q -> lies_on x e ->
  (exists s, In s (convolution_segments p q) /\ lies_on x s /\ same_direction (along s) (along e)) /\
  (exists s, In s (convolution_segments p q) /\ lies_on x s /\ same_direction (along s) (opposite (along e))).
Proof.
  intros p_region q_region dangling on.
  destruct (theorem_3_2_8_by_reduced_segments p q e x p_region q_region dangling on) as [(s & S & on_s) (t & T & on_t)].
  apply reduced_is_part_of_the_convolution in S, T. split; [now exists s | now exists t].
Qed.
