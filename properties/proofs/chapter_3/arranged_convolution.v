(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The arrangement of the convolution, or of the reduced one, or of what is between: segments cut where they meet, each
   piece with the direction of its segment. The sum ends at such pieces: off them no boundary loop is met
   (loops_of_the_boundary.v), and loops run along pieces only. So chains of those that have the sum on their left only
   are the boundary of the sum, too (region_of_pieces.v). *)
From Coq Require Import QArith Lqa ZArith Lia Bool List Permutation.
From Oplus Require Import regions_and_sums angle beside_every_point theorem_2_2_10 theorem_2_2_6 reduced_convolution
  observation_2_2_4 inside_a_corner pieces met_pieces naive_collision collision_is_sound beside_a_piece filling
  kept_pieces_go_round cut_pieces rule_of_sides beside_a_vertex region_of_pieces sum_is_right walks written_regions
  loops_of_the_boundary.
Import ListNotations.

Open Scope Q_scope.

Definition reduced_segment (e : segment) : segment :=
  Segment (reduced_vector (source e)) (reduced_vector (target e)).

Definition arrangement_of (segments : list segment) : list segment :=
  nodup segment_dec (flat_map (fun s => map reduced_segment (cut_where_met s segments)) segments).

Definition convolution_arrangement (p q : region) : list segment := arrangement_of (convolution_segments p q).

(* The convolution, the reduced convolution, or what is between. *)
Definition is_convolution (p q : region) (segments : list segment) : Prop :=
  incl segments (convolution_segments p q) /\ incl (reduced_convolution p q) segments.

Lemma both_are_convolutions (p q : region) :
  is_convolution p q (convolution_segments p q) /\ is_convolution p q (reduced_convolution p q).
Proof.
  assert (part : incl (reduced_convolution p q) (convolution_segments p q))
    by (intros s; apply reduced_is_part_of_the_convolution).
  split; split; trivial; apply incl_refl.
Qed.

(* Beside a piece nothing is met that does not run along it. *)
Lemma nothing_met_beside (segments : list segment) (s : segment) (x n : vector) : met_only_along segments s ->
  strictly_inside x s -> ~ cross (along s) n == 0 -> eventually (fun t => off (moved_along x n t) segments).
Proof.
  intros only inside_ turn. apply (eventually_for_all (fun k t => ~ lies_on (moved_along x n t) k)). intros k K.
  destruct (lies_on_dec x k) as [on | off_].
  - exists 1. split; [lra |]. intros t some _ on_t.
    pose proof (area_of_collinear s k _ (only x k inside_ K on) on_t) as zero_. apply turn.
    apply (Qmult_inj_l _ _ t); [lra |]. rewrite (area_from x _ s (strictly_inside_lies_on _ _ inside_)) in zero_.
    transitivity (cross (along s) (minus (moved_along x n t) x)); [| rewrite zero_; ring].
    unfold cross, minus, moved_along. cbn [vx vy]. ring.
  - destruct (off_one_segment_near x k off_) as (radius & R & near).
    refine (eventually_implied _ _ _ (small_steps_stay_within radius x n R)). intros t close. now apply near.
Qed.

Lemma reduced_segment_is (e : segment) :
  equal_vectors (source (reduced_segment e)) (source e) /\ equal_vectors (target (reduced_segment e)) (target e).
Proof. split; apply reduced_is. Qed.

Lemma reduced_segment_place (e : segment) : of_one_place (reduced_segment e) e.
Proof. left. apply reduced_segment_is. Qed.

Lemma undirected_is_one_direction (e : segment) :
  undirected e = reduced_segment e \/ undirected e = reversed (reduced_segment e).
Proof. unfold undirected, reduced_segment, reversed. cbn [source target]. destruct (compare_points _ _); tauto. Qed.

(* An edge of the arrangement is a piece, in one of its directions, and part of a segment of its direction. *)
Lemma arrangement_edge_is (segments : list segment) (e : segment) :
  (forall t, In t segments -> nonzero (along t)) -> In e (arrangement_of segments) ->
  directed (pieces_of segments) e /\
  exists t, In t segments /\ same_direction (along e) (along t) /\ forall x, lies_on x e -> lies_on x t.
Proof.
  intros all_long E. apply nodup_In, in_flat_map in E. destruct E as (t & T & E).
  apply in_map_iff in E. destruct E as (piece & <- & P). split.
  - assert (listed : In (undirected piece) (pieces_of segments))
      by (apply nodup_In, in_flat_map; exists t; split; [exact T | now apply in_map]).
    destruct (undirected_is_one_direction piece) as [is_ | is_]; rewrite is_ in listed; [now left | now right].
  - destruct (proj1 (cut_returns t (flat_map (intersection t) segments) (all_long t T)) piece P) as [part _].
    exists t. split; [exact T |]. split.
    + destruct (part_is_long piece t part (all_long t T)) as [_ (c & some & X & Y)]. exists c. split; [exact some |].
      destruct (reduced_segment_is piece) as [[sx sy] [tx ty]]. unfold along, minus in *. cbn [vx vy] in *.
      rewrite sx, sy, tx, ty. now split.
    + intros x on. apply (part_lies_on piece t x part).
      exact (lies_on_of_one_place _ _ x (reduced_segment_place piece) on).
Qed.

(* The pieces that have the sum on their left only. *)
Definition edges_on_the_boundary (p q : region) (segments : list segment) : list segment :=
  kept_pieces (is_right_inside (region_edges (boundary_loops p q))) (pieces_of segments).

Section Sum.
  Variables p q : region.
  Hypothesis p_region : valid_region p.
  Hypothesis q_region : valid_region q.
  Variable segments : list segment.
  Hypothesis convolution_ : is_convolution p q segments.

  Let around := region_edges (boundary_loops p q).
  Let inside x := (0 <? winding_number x around)%Z.
  Let right_inside := is_right_inside around.
  Let pieces := pieces_of segments.

  Lemma arranged_are_long (t : segment) : In t segments -> nonzero (along t).
  Proof. intros T. now apply (all_are_long p q p_region q_region), convolution_. Qed.

  Let cut_ := pieces_are_pieces segments arranged_are_long.

  Lemma pieces_meet_along (s : segment) : directed pieces s -> met_only_along segments s.
  Proof.
    pose proof (pieces_are_met_along _ _ cut_) as met.
    intros [S | S]; [now apply met | rewrite <- (reversed_twice s); now apply met_only_along_reversed, met].
  Qed.

  Lemma on_the_loops_is_on_segments (k : segment) : In k around ->
    exists t, In t segments /\ forall y, lies_on y k -> lies_on y t.
  Proof.
    intros K. destruct (reduced_segment_along_the_loops p q p_region q_region k K) as (t & T & covers_ & _).
    exists t. split; [now apply convolution_ | exact covers_].
  Qed.

  Lemma loops_meet_along (s : segment) : directed pieces s -> met_only_along around s.
  Proof.
    intros S w k inside_ K on. destruct (on_the_loops_is_on_segments k K) as (t & T & covers_).
    pose proof (pieces_meet_along s S w t inside_ T (covers_ w on)) as line.
    split; apply (area_of_collinear s t _ line), covers_; [apply source_lies_on | apply target_lies_on].
  Qed.

  Lemma sum_ends_at_pieces : ends_at_pieces inside right_inside pieces.
  Proof.
    pose proof (pieces_of_share_ends segments arranged_are_long) as parts. split.
    - exact parts.
    - intros a b [X Y]. unfold inside. now rewrite (winding_number_of_equal a b _ X Y).
    - intros a b free. unfold inside. f_equal.
      apply (winding_number_along (Segment a b) around (region_cycles _)). intros w on k K on_k.
      destruct (on_the_loops_is_on_segments k K) as (t & T & covers_).
      destruct (pieces_are_all _ _ cut_ t w T (covers_ w on_k)) as (e & E & on_e). exact (free w on e E on_e).
    - intros s w n S inside_ turn. refine (eventually_implied _ _ _ (to_the_right_of_a_piece around s (region_cycles _)
        (loops_meet_along s S) (directed_is_long _ parts s S) w n inside_ turn)).
      intros d same_number. unfold inside, right_inside, is_right_inside. now rewrite same_number.
    - destruct (nothing_far_to_the_right around) as (limit & none). exists limit. intros x far. unfold inside.
      assert (zero_ : winding_number x around = 0%Z) by (apply sum_of_zeros; intros s S; now apply none).
      now rewrite zero_.
  Qed.

  Let ends_ := sum_ends_at_pieces.
  Let parts := pieces_of_share_ends segments arranged_are_long.
  Let kept := edges_on_the_boundary p q segments.
  Let chains := chains_of (length kept) kept.

  (* Theorem. *)
  Theorem arranged_loops_are_the_sum : loops_of_the_sum p q segments kept chains.
  Proof.
    pose proof (loops_fill_the_sum _ _ _ _ _ (boundary_loops_are_loops_of_the_sum p q p_region q_region)) as fills.
    split.
    - apply convolution_.
    - apply convolution_.
    - exact (kept_share_ends segments inside right_inside ends_).
    - intros e E. exact (proj1 (proj1 (of_kept segments right_inside e) E)).
    - exact (chains_of_kept segments inside right_inside ends_).
    - exact (chains_are_written_of_kept segments inside right_inside ends_ kept (Permutation_refl _)).
    - intros x. apply (points_of_a_closed_set segments arranged_are_long inside right_inside ends_ chains
        (chains_of_kept segments inside right_inside ends_) (fun y => in_sum y p q)).
      + intros y free. rewrite <- fills. unfold inside. rewrite Z.ltb_lt. split; [| now left].
        intros [some | (k & K & on)]; [exact some | exfalso].
        destruct (on_the_loops_is_on_segments k K) as (t & T & covers_). exact (free t T (covers_ y on)).
      + intros y t T. apply on_the_convolution_is_in_the_sum, convolution_, T.
      + exact (sums_are_regular p q p_region q_region).
  Qed.
End Sum.
