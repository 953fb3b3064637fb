(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The open sum in the words of specification.v: for valid regions whose winding numbers are 0 and 1,
   open_sum_of_regions returns the open sum. Its chains are those of the closed sum, however they are found. *)
From Coq Require Import QArith Lqa ZArith Lia Bool List Permutation.
From Oplus Require Import specification checker regions_and_sums observation_2_2_4 homogeneous_points
  specification_bridge collision_is_complete filling sum_program sum_is_right sum_of_uncovered_pieces coordinates
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

Lemma member_by_edges (x : point) (r : polygonal_region) :
  member x r <-> (exists s, In s (region_edges (as_region r)) /\ lies_on (as_vector x) s) \/
    winding_number (as_vector x) (region_edges (as_region r)) <> 0%Z.
Proof. unfold member. now rewrite on_boundary_is, number_of_region_is. Qed.

Lemma inner_point_is (x : point) (r : polygonal_region) : is_inner_point x r <->
  winding_number (as_vector x) (region_edges (as_region r)) <> 0%Z /\ off (as_vector x) (region_edges (as_region r)).
Proof.
  unfold is_inner_point. rewrite number_of_region_is, off_is, <- on_boundary_is. split; intros [round free];
    (split; [exact round |]); [intros (e & E & on); exact (free e E on) | intros e E on; apply free; now exists e].
Qed.

Lemma inner_point_of_valid (x : point) (r : polygonal_region) : valid_region (as_region r) ->
  (is_inner_point x r <-> inside (as_vector x) (as_region r)).
Proof.
  intros (_ & not_negative & _). rewrite inner_point_is. unfold inside.
  split; intros [a b]; split; trivial; [specialize (not_negative _ b); lia | lia].
Qed.

(* The vertices may be written in other ways. *)
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

(* Near every point of an edge is one outside. *)
Lemma outside_is_near (r : region) (x : vector) (s : segment) (radius : Q) : valid_region r -> nowhere_above_one r ->
  In s (region_edges r) -> lies_on x s -> 0 < radius ->
  exists y, within radius x y /\ off y (region_edges r) /\ winding_number y (region_edges r) = 0%Z.
Proof.
  intros (not_points & not_negative & meet) simple S on R.
  pose proof (region_edges_are_directions r not_points s S) as long.
  destruct (no_vertex_near r s x ((1 # 2) * radius) long on) as (w & near_w & on_w & no_vertex); [lra |].
  set (n := Vector (- vy (along s)) (vx (along s))). pose proof (left_normal s long) as left_. fold n in left_.
  assert (half_ : 0 < (1 # 2) * radius) by lra.
  destruct (some_small _ (eventually_and _ _ (left_is_one_more r s w n meet S on_w no_vertex left_)
    (small_steps_stay_within _ w (opposite n) half_))) as (e & _ & (off_left & off_right & more) & close).
  exists (moved_along w n (- e)). split; [| split; [exact off_right |]].
  - clear - near_w close. unfold within, moved_along, opposite in *; cbn [vx vy] in *. lra.
  - pose proof (simple _ off_left). pose proof (not_negative _ off_right). lia.
Qed.

(* Near every point of an edge is one that is no member: edges are the boundary. *)
Definition beside_the_outside (r : polygonal_region) : Prop :=
  forall x e radius, In e (edges_of_region r) -> is_on x e -> 0 < radius ->
    exists y, within radius (as_vector x) (as_vector y) /\ ~ member y r.

Lemma chains_are_beside_the_outside (chains : region) : valid_region chains -> nowhere_above_one chains ->
  beside_the_outside (map (map as_point) chains).
Proof.
  intros valid simple x e radius E on R.
  destruct (proj1 (proj1 (chains_as_points (as_vector x) chains))) as (t & T & on_t);
    [apply on_boundary_is; now exists e |].
  destruct (outside_is_near chains (as_vector x) t radius valid simple T on_t R) as (y & close & free & zero_).
  exists (as_point y). rewrite member_of_chains, as_vector_of_point. rewrite off_is in free. now split; [| tauto].
Qed.

(* Theorem. The open sum, around any region that is the closed one and has its boundary as edges. *)
Theorem open_sum_around_is_the_open_sum (sum_ p q : polygonal_region) :
  valid_region (as_region p) -> valid_region (as_region q) ->
  nowhere_above_one (as_region p) -> nowhere_above_one (as_region q) ->
  is_minkowski_sum p q sum_ -> beside_the_outside sum_ -> is_open_sum p q (open_sum_around sum_ p q).
Proof.
  intros p_region q_region p_simple q_simple is_sum beside x.
  assert (member_is_in_sum : forall y, member y sum_ <-> in_sum (as_vector y) (as_region p) (as_region q)).
  { intros y. rewrite (is_sum y). split.
    - intros (a & b & in_p & in_q & equal). exists (as_vector a), (as_vector b).
      rewrite <- !member_of_region by assumption. split; [exact in_p | split; [exact in_q | exact equal]].
    - intros (a & b & in_p & in_q & equal). exists (as_point a), (as_point b).
      rewrite !member_of_region by assumption. now rewrite !as_vector_of_point. }
  transitivity (interiors_meet (as_vector x) (as_region p) (as_region q)).
  - rewrite <- (open_sum_has (as_region p) (as_region q) (as_region sum_) p_region q_region p_simple q_simple).
    + unfold open_member. rewrite inner_point_is. cbn [open_chains dangling_edges isolated_points open_sum_around].
      set (D := dangling_among _ _ _ _). set (V := isolated_among _ _ _ _ _).
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
      rewrite edges_, points_. tauto.
    + intros y. rewrite <- (as_vector_of_point y), <- member_by_edges. apply member_is_in_sum.
    + intros y s radius S on R. rewrite <- (as_vector_of_point y) in on.
      destruct (proj2 (on_boundary_is (as_point y) sum_)) as (e & E & on_e); [now exists s |].
      destruct (beside (as_point y) e radius E on_e R) as (z & close & out). exists (as_vector z).
      split; [exact close | now rewrite <- member_is_in_sum].
  - split.
    + intros (z & in_p & in_q). exists (as_point z), (as_point (minus (as_vector x) z)).
      rewrite !inner_point_of_valid, !as_vector_of_point by assumption.
      split; [exact in_p | split; [exact in_q | by_computing]].
    + intros (a & b & in_p & in_q & equal). exists (as_vector a).
      rewrite !inner_point_of_valid in * by assumption. split; [exact in_p |].
      apply (inside_equal (as_vector b)); [clear - equal; by_computing | exact in_q].
Qed.

Lemma sums_are_beside_the_outside (p q : polygonal_region) :
  valid_region (as_region p) -> valid_region (as_region q) -> beside_the_outside (quick_sum p q).
Proof.
  intros p_region q_region. pose proof (quick_chains_are (as_region p) (as_region q) p_region q_region) as permuted.
  unfold quick_sum. cbv zeta in *. set (f := quick_filled _ _) in *.
  apply chains_are_beside_the_outside.
  - now apply (sums_are_valid (as_region p) (as_region q)).
  - intros y _. rewrite (winding_number_of_chains (as_region p) (as_region q) _ p_region q_region permuted).
    destruct (0 <? _)%Z; lia.
Qed.

(* Theorem. So what open_sum_of_regions returns is the open sum. *)
Theorem open_sum_of_regions_is_the_open_sum (p q : polygonal_region) :
  valid_region (as_region p) -> valid_region (as_region q) ->
  nowhere_above_one (as_region p) -> nowhere_above_one (as_region q) -> is_open_sum p q (open_sum_of_regions p q).
Proof.
  intros p_region q_region p_simple q_simple. apply open_sum_around_is_the_open_sum; trivial;
    [now apply quick_sum_is_the_sum | now apply sums_are_beside_the_outside].
Qed.
