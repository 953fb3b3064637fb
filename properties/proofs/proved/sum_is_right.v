(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Chains of the pieces of the convolution that are kept are the Minkowski sum, as specification.v says: off the
   convolution, by Theorem 4.2.1; what is on the convolution is in the sum; and near each point of the sum are points
   where the interiors meet. The rest is true of all sets that end at pieces (region_of_pieces.v). *)
From Coq Require Import QArith Qminmax Lqa ZArith Lia Bool List Permutation.
From Oplus Require Import specification checker regions_and_sums tracing theorem_2_2_10 theorem_2_2_6
  observation_2_2_4 lemma_2_2_2 test_of_regions homogeneous_points specification_bridge pieces filling
  placed_collision kept_pieces_go_round cut_pieces rule_of_sides region_of_pieces walks sum_program.
Import ListNotations.

Open Scope Q_scope.

Lemma convolution_segments_are_long (p q : region) (s : segment) :
  no_edges_are_points p -> no_edges_are_points q -> In s (convolution_segments p q) -> nonzero (along s).
Proof.
  intros p_edges q_edges I.
  destruct (convolution_segment_is p q s I) as (a & b & i & j & in_p & in_q & i_below & j_below & [-> | ->]).
  - pose proof (region_edges_are_directions p p_edges _ (edge_in_region a p i in_p i_below)) as long.
    intros [X Y]. apply long. unfold plus in *. in_coordinates. split; lra.
  - pose proof (region_edges_are_directions q q_edges _ (edge_in_region b q j in_q j_below)) as long.
    intros [X Y]. apply long. unfold plus in *. in_coordinates. split; lra.
Qed.

Theorem filled_is_balanced (segments : list segment) : (forall t, In t segments -> nonzero (along t)) ->
  cycles segments -> is_balanced (filled segments).
Proof.
  intros all_long closed. exact (kept_is_balanced segments _ _ (filled_ends_at_pieces segments all_long
    closed)).
Qed.

Section Sum.
  Variables p q chains : region.
  Hypothesis p_region : valid_region p.
  Hypothesis q_region : valid_region q.
  Let convolution_ := convolution_segments p q.
  Hypothesis edges_are : Permutation (region_edges chains) (filled convolution_).

  Lemma all_are_long (t : segment) : In t convolution_ -> nonzero (along t).
  Proof. destruct p_region as (p_edges & _), q_region as (q_edges & _). now apply convolution_segments_are_long. Qed.

  Lemma all_are_closed : cycles convolution_.
  Proof. destruct p_region as (p_edges & _), q_region as (q_edges & _). now apply convolution_is_closed. Qed.

  Lemma winding_number_of_chains (x : vector) :
    winding_number x (region_edges chains) = if (0 <? winding_number x convolution_)%Z then 1%Z else 0%Z.
  Proof.
    rewrite (permuted_winding_number x _ _ edges_are). apply filled_is_right;
      [exact all_are_long | exact all_are_closed].
  Qed.

  Lemma on_the_convolution_is_in_the_sum (x : vector) (s : segment) : In s convolution_ -> lies_on x s -> in_sum x p q.
  Proof.
    intros I on. apply vertex_edge_sums_are_in_the_sum.
    now apply (convolution_is_part_of_the_vertex_edge_sum p q x s).
  Qed.

  Lemma sums_are_regular (x : vector) : in_sum x p q -> regularised (fun y => in_sum y p q) x.
  Proof.
    pose proof p_region as (p_edges & p_numbers & p_meet). pose proof q_region as (q_edges & q_numbers & q_meet).
    intros in_ radius R. destruct (interiors_meet_near p q x radius) as (y & close & meet); trivial;
      try (now apply regions_are_regular).
    exists y. split; [exact close |]. now apply interiors_meet_means_inner_point.
  Qed.

  Theorem points_of_the_sum (x : vector) : in_region x chains <-> in_sum x p q.
  Proof.
    apply (points_of_a_closed_set convolution_ all_are_long _ _
      (filled_ends_at_pieces _ all_are_long all_are_closed) chains edges_are (fun y => in_sum y p q)).
    - intros y free. now rewrite Z.ltb_lt, <- (positive_winding_number_iff_common_point p q y p_region q_region free).
    - exact on_the_convolution_is_in_the_sum.
    - exact sums_are_regular.
  Qed.

  (* Theorem. The sum is a valid region again. *)
  Theorem sums_are_valid : valid_region chains.
  Proof.
    exact (chains_are_valid convolution_ _ _ (filled_ends_at_pieces _ all_are_long all_are_closed)
      chains edges_are).
  Qed.
End Sum.

(* Vertices replaced by equal ones. *)
Section Equal.
  Variable h : vector -> vector.
  Hypothesis same : forall v, equal_vectors (h v) v.

  Lemma winding_number_of_images (x : vector) (l : list segment) :
    winding_number x (map (moved_ends h) l) = winding_number x l.
  Proof.
    unfold winding_number. rewrite map_map. f_equal. apply map_ext. intros [a b].
    apply signed_crossing_of_equal; [reflexivity | apply same ..].
  Qed.

  Lemma on_images (x : vector) (l : list segment) :
    (exists s, In s (map (moved_ends h) l) /\ lies_on x s) <-> (exists s, In s l /\ lies_on x s).
  Proof.
    split.
    - intros (s & I & on). apply in_map_iff in I. destruct I as ([a b] & <- & I). exists (Segment a b).
      split; [exact I |]. refine (lies_on_of_equal x x _ _ a b _ _ _ on); [reflexivity | apply same ..].
    - intros ([a b] & I & on). exists (moved_ends h (Segment a b)). split; [now apply in_map |].
      refine (lies_on_of_equal x x a b _ _ _ _ _ on); [reflexivity | symmetry; apply same ..].
  Qed.
End Equal.

(* So the vertices of a region may be written in other ways. *)
Lemma chains_as_points (x : vector) (chains : region) :
  let written := region_edges (as_region (map (map as_point) chains)) in
  ((exists s, In s written /\ lies_on x s) <-> (exists s, In s (region_edges chains) /\ lies_on x s)) /\
  winding_number x written = winding_number x (region_edges chains).
Proof.
  set (h := fun v => vector_of (homogeneous (as_point v))).
  assert (same : forall v, equal_vectors (h v) v)
    by (intros v; unfold h; rewrite (homogeneous_is (as_point v)); split; reflexivity).
  cbv zeta. unfold as_region. rewrite map_map, (map_ext _ (map h)) by (intros c; now rewrite map_map).
  rewrite edges_of_images. split; [apply (on_images h same) | apply (winding_number_of_images h same)].
Qed.

(* The words of the specification. *)
Lemma member_by_edges (x : point) (r : polygonal_region) :
  member x r <-> (exists s, In s (region_edges (as_region r)) /\ lies_on (as_vector x) s) \/
    winding_number (as_vector x) (region_edges (as_region r)) <> 0%Z.
Proof. rewrite member_is, boundary_is. reflexivity. Qed.

Lemma in_valid_region (x : vector) (r : region) : valid_region r ->
  ((exists s, In s (region_edges r) /\ lies_on x s) \/ winding_number x (region_edges r) <> 0%Z <-> in_region x r).
Proof.
  intros (_ & not_negative & _). pose proof (nowhere_negative_everywhere _ not_negative x). unfold in_region.
  intuition lia.
Qed.

Lemma member_of_region (x : point) (r : polygonal_region) : valid_region (as_region r) ->
  (member x r <-> in_region (as_vector x) (as_region r)).
Proof. rewrite member_by_edges. apply in_valid_region. Qed.

Lemma member_of_chains (x : point) (chains : region) :
  member x (map (map as_point) chains) <->
  (exists s, In s (region_edges chains) /\ lies_on (as_vector x) s) \/
  winding_number (as_vector x) (region_edges chains) <> 0%Z.
Proof. rewrite member_by_edges. destruct (chains_as_points (as_vector x) chains) as [-> ->]. reflexivity. Qed.

Lemma member_of_valid_chains (x : point) (chains : region) : valid_region chains ->
  (member x (map (map as_point) chains) <-> in_region (as_vector x) chains).
Proof. rewrite member_of_chains. apply in_valid_region. Qed.

Lemma sums_of_members (p q : polygonal_region) (x : point) : valid_region (as_region p) -> valid_region (as_region q) ->
  ((exists a b, member a p /\ member b q /\ equal_points x (sum_of_points a b)) <->
   in_sum (as_vector x) (as_region p) (as_region q)).
Proof.
  intros p_region q_region. split.
  - intros (a & b & in_p & in_q & equal). exists (as_vector a), (as_vector b).
    rewrite <- !member_of_region by assumption. now split.
  - intros (a & b & in_p & in_q & equal). exists (as_point a), (as_point b).
    rewrite !member_of_region, !as_vector_of_point by assumption. now split.
Qed.

(* Chains of what is kept, however they are found. *)
Theorem chains_are_the_sum (p q : polygonal_region) (chains : region) :
  valid_region (as_region p) -> valid_region (as_region q) ->
  Permutation (region_edges chains) (filled (convolution_segments (as_region p) (as_region q))) ->
  is_minkowski_sum p q (map (map as_point) chains).
Proof.
  intros p_region q_region permuted x. rewrite sums_of_members by assumption.
  rewrite member_of_valid_chains by exact (sums_are_valid _ _ chains p_region q_region permuted).
  exact (points_of_the_sum _ _ chains p_region q_region permuted (as_vector x)).
Qed.
