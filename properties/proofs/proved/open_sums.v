(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The open sum in the words of specification.v: for valid regions whose winding numbers are 0 and 1,
   open_sum_of_regions returns the open sum. *)
From Coq Require Import QArith Lqa ZArith Lia Bool List Permutation.
From Oplus Require Import specification checker regions_and_sums homogeneous_points specification_bridge
  collision_is_complete filling sum_program sum_is_right sum_of_uncovered_pieces complement_in_a_frame coordinates
  open_sum_program open_along_a_piece open_sum_is_right maximal_segments.
Import ListNotations.

Open Scope Q_scope.

Lemma on_boundary_is (x : point) (r : polygonal_region) :
  (exists e, In e (edges_of_region r) /\ is_on x e) <->
  (exists s, In s (region_edges (as_region r)) /\ lies_on (as_vector x) s).
Proof.
  unfold as_region. rewrite <- boundary_is. unfold boundary, hedges_of_region. rewrite map_map. split.
  - intros (e & E & on). exists (segment_of_hedge (homogeneous (fst e), homogeneous (snd e))).
    split; [apply in_map_iff; now exists e | now apply is_on_is].
  - intros (s & S & on). apply in_map_iff in S. destruct S as (e & <- & E). exists e.
    split; [exact E | now apply is_on_is].
Qed.

Lemma number_of_region_is (x : point) (r : polygonal_region) :
  region_winding_number x r = winding_number (as_vector x) (region_edges (as_region r)).
Proof. unfold as_region. rewrite <- boundary_is. apply winding_number_is. Qed.

Lemma inner_point_is (x : point) (r : polygonal_region) : is_inner_point x r <->
  winding_number (as_vector x) (region_edges (as_region r)) <> 0%Z /\ off (as_vector x) (region_edges (as_region r)).
Proof. unfold as_region. rewrite <- boundary_is. apply inner_point_by_boundary. Qed.

Lemma inner_point_of_valid (x : point) (r : polygonal_region) : valid_region (as_region r) ->
  (is_inner_point x r <-> inside (as_vector x) (as_region r)).
Proof.
  intros (_ & not_negative & _). rewrite inner_point_is. unfold inside.
  split; intros [a b]; split; trivial; [specialize (not_negative _ b); lia | lia].
Qed.

(* Sums are regions of which one may ask for sums again. *)
Lemma quick_sum_is_valid (p q : polygonal_region) : valid_region (as_region p) -> valid_region (as_region q) ->
  valid_region (as_region (quick_sum p q)) /\ nowhere_above_one (as_region (quick_sum p q)).
Proof.
  intros p_region q_region. pose proof (quick_chains_are (as_region p) (as_region q) p_region q_region) as permuted.
  apply polygonal_is_valid; [now apply (sums_are_valid (as_region p) (as_region q)) |]. intros x _.
  rewrite (winding_number_of_chains (as_region p) (as_region q) _ p_region q_region permuted).
  destruct (0 <? _)%Z; lia.
Qed.

(* Theorem. What open_sum_of_regions returns is the open sum. *)
Theorem open_sum_of_regions_is_the_open_sum (p q : polygonal_region) :
  valid_region (as_region p) -> valid_region (as_region q) ->
  nowhere_above_one (as_region p) -> nowhere_above_one (as_region q) -> is_open_sum p q (open_sum_of_regions p q).
Proof.
  intros p_region q_region p_simple q_simple x. destruct (quick_sum_is_valid p q p_region q_region) as [s_region
    s_simple].
  pose proof (quick_sum_is_the_sum p q p_region q_region) as is_sum.
  transitivity (interiors_meet (as_vector x) (as_region p) (as_region q)).
  - rewrite <- (open_sum_has (as_region p) (as_region q) (as_region (quick_sum p q))); trivial.
    + unfold open_member, open_sum_of_regions, open_sum_around. cbn [open_chains dangling_edges isolated_points].
      rewrite (inner_point_of_valid _ _ s_region). set (D := dangling_among _ _ _ _).
      set (V := isolated_among _ _ _ _ _).
      assert (long : forall t, In t D -> nonzero (along t)).
      { intros t T. apply nodup_In, filter_In in T. destruct T as [T _].
        now destruct (touching_piece_is _ _ p_region q_region t T) as (u & piece & _ & _ & _ & _ & _ & long). }
      assert (edges_ : (forall e, In e (map as_edge (maximal_segments D)) -> ~ is_on x e) <-> off (as_vector x) D).
      { rewrite off_is. fold (on_one (as_vector x) D). rewrite <- (maximal_segments_are (as_vector x) D long). split.
        - intros free (u & U & on). exact (free (as_edge u) (in_map as_edge _ u U) on).
        - intros none e E on. apply in_map_iff in E. destruct E as (u & <- & U). apply none. now exists u. }
      assert (points_ : (forall v, In v (map as_point V) -> ~ equal_points x v) <->
        (forall v, In v V -> ~ equal_vectors (as_vector x) v)).
      { split; intros free v I equal; [exact (free (as_point v) (in_map as_point V v I) equal) |].
        apply in_map_iff in I. destruct I as (w & <- & I). exact (free w I equal). }
      now rewrite edges_, points_.
    + intros y. rewrite <- (as_vector_of_point y), <- member_of_region, <- sums_of_members by assumption. apply is_sum.
  - split.
    + intros (z & in_p & in_q). exists (as_point z), (as_point (minus (as_vector x) z)).
      rewrite !inner_point_of_valid, !as_vector_of_point by assumption.
      split; [exact in_p | split; [exact in_q | by_computing]].
    + intros (a & b & in_p & in_q & equal). exists (as_vector a).
      rewrite !inner_point_of_valid in * by assumption. split; [exact in_p |].
      apply (inside_equal (as_vector b)); [clear - equal; by_computing | exact in_q].
Qed.
