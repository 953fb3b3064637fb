(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The open sum in the words of specification.v: for regions that pass the test of checked_collision.v,
   checked_open_sum returns the open sum. Its chains are those of the closed sum, as they are found by.v or
   otherwise. *)
From Coq Require Import QArith Lqa ZArith Lia Bool List Permutation.
From Oplus Require Import specification checker convolution signed_crossings tie_rule convolution_winding regions
  winding_number_of_the_sum interiors_meet neighbourhoods left_of_an_edge beside_every_point observation_2_2_4
  theorem_4_2_1 location homogeneous_points specification_bridge pieces collision_is_complete checked_collision
  filling cut_pieces sum_program sum_is_right sum_of_uncovered_pieces open_sum_program
    open_along_a_piece open_sum_is_right maximal_segments walks.
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

Lemma inner_point_is (x : point) (r : polygonal_region) :
  is_inner_point x r <->
  winding_number (as_vector x) (region_edges (as_region r)) <> 0%Z /\ off (as_vector x) (region_edges (as_region r)).
Proof.
  unfold is_inner_point. rewrite number_of_region_is. split; intros [round free]; (split; [exact round |]).
  - intros s S on. destruct (proj2 (on_boundary_is x r)) as (e & E & on_e); [now exists s | exact (free e E on_e)].
  - intros e E on. destruct (proj1 (on_boundary_is x r)) as (s & S & on_s); [now exists e | exact (free s S on_s)].
Qed.

Lemma inner_point_of_valid (x : point) (r : polygonal_region) : valid_region (as_region r) ->
  (is_inner_point x r <-> inside (as_vector x) (as_region r)).
Proof.
  intros (_ & not_negative & _). rewrite inner_point_is. unfold inside.
  split; intros [a b]; split; trivial; [specialize (not_negative _ b); lia | lia].
Qed.

(* Near every point of an edge is one outside. *)
Lemma outside_is_near (r : region) (x : vector) (s : segment) (radius : Q) : valid_region r -> nowhere_above_one r ->
  In s (region_edges r) -> lies_on x s -> 0 < radius ->
  exists y, within radius x y /\ off y (region_edges r) /\ winding_number y (region_edges r) = 0%Z.
Proof.
  intros (not_points & not_negative & meet) simple S on R.
  pose proof (region_edges_are_directions r not_points s S) as long.
  destruct (no_vertex_near r s x ((1 # 2) * radius) long on) as (w & near_w & on_w & no_vertex); [lra |].
  set (n := Vector (- vy (along s)) (vx (along s))).
  pose proof (left_normal s long) as left_. fold n in left_.
  assert (half : 0 < (1 # 2) * radius) by lra.
  destruct (eventually_and _ _ (left_is_one_more r s w n meet S on_w no_vertex left_)
    (small_steps_stay_within _ w (opposite n) half)) as (limit & L & all).
  destruct (all ((1 # 2) * limit)) as ((off_left & off_right & more) & close); [lra | lra |].
  set (e := (1 # 2) * limit) in *. exists (moved_along w n (- e)). split; [| split; [exact off_right |]].
  - unfold within, moved_along, opposite in *; cbn [vx vy] in *. lra.
  - pose proof (simple _ off_left). pose proof (not_negative _ off_right). lia.
Qed.

(* Near every point of an edge is one that is no member: edges are the boundary. *)
Definition beside_the_outside (r : polygonal_region) : Prop :=
  forall x e radius, In e (edges_of_region r) -> is_on x e -> 0 < radius ->
    exists y, within radius (as_vector x) (as_vector y) /\ ~ member y r.

(* The vertices may be written in other ways. *)
Lemma chains_are_beside_the_outside (chains : region) : valid_region chains -> nowhere_above_one chains ->
  beside_the_outside (map (map as_point) chains).
Proof.
  intros valid simple x e radius E on R.
  set (h := fun v => vector_of (homogeneous (as_point v))).
  assert (same : forall v, equal_vectors (h v) v).
  { intros v. unfold h. rewrite (homogeneous_is (as_point v)). split; reflexivity. }
  assert (edges_are : region_edges (as_region (map (map as_point) chains)) = map (moved_ends h) (region_edges chains)).
  { unfold as_region. rewrite map_map, <- edges_of_images. f_equal. apply map_ext. intros c. now rewrite map_map. }
  destruct (proj1 (on_boundary_is x (map (map as_point) chains))) as (s & S & on_s); [now exists e |].
  rewrite edges_are in S.
  destruct (proj1 (on_images h same (as_vector x) (region_edges chains))) as (t & T & on_t); [now exists s |].
  destruct (outside_is_near chains (as_vector x) t radius valid simple T on_t R) as (y & close & free & zero_).
  exists (as_point y). rewrite as_vector_of_point. split; [exact close |]. rewrite member_of_chains, as_vector_of_point.
  intros [(u & U & on_u) | round]; [exact (free u U on_u) | exact (round zero_)].
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
      rewrite <- !member_of_region by assumption. split; [exact in_p |]. split; [exact in_q |]. exact equal.
    - intros (a & b & in_p & in_q & equal). exists (as_point a), (as_point b).
      rewrite !member_of_region, !as_vector_of_point by assumption. split; [exact in_p |]. split; [exact in_q |].
      exact equal. }
  assert (member_by_edges : forall y, member y sum_ <->
    (exists s, In s (region_edges (as_region sum_)) /\ lies_on (as_vector y) s) \/
    winding_number (as_vector y) (region_edges (as_region sum_)) <> 0%Z).
  { intros y. unfold member. now rewrite on_boundary_is, number_of_region_is. }
  transitivity (interiors_meet (as_vector x) (as_region p) (as_region q)).
  - rewrite <- (open_sum_has (as_region p) (as_region q) (as_region sum_) p_region q_region p_simple q_simple).
    + unfold open_member. rewrite inner_point_is. cbn [open_chains dangling_edges isolated_points open_sum_around].
      set (D := dangling_among _ _ _ _). set (V := isolated_among _ _ _ _ _).
      assert (long : forall t, In t D -> nonzero (along t)).
      { intros t T. apply nodup_In, filter_In in T. destruct T as [T _].
        destruct (touching_piece_is _ _ t T) as (u & piece & U & I & place_). apply (long_of_one_place _ _ place_).
        pose proof (all_vertex_edge_segments_are_long _ _ p_region q_region u U) as long_u.
        destruct (cut_returns u (flat_map (intersection u) (all_vertex_edge_segments (as_region p) (as_region q)))
          long_u)
          as [parts _].
        destruct (parts piece I) as [part _]. now destruct (met_pieces.part_is_long piece u part long_u). }
      pose proof (maximal_segments_are (as_vector x) D long) as same_points.
      assert (edges_ : (forall e, In e (map as_edge (maximal_segments D)) -> ~ is_on x e) <-> off (as_vector x) D).
      { split; intros free.
        - intros t T on. destruct (proj2 same_points) as (u & U & on_u); [now exists t |].
          exact (free (as_edge u) (in_map as_edge _ u U) on_u).
        - intros e E on. apply in_map_iff in E. destruct E as (u & <- & U).
          destruct (proj1 same_points) as (t & T & on_t); [now exists u | exact (free t T on_t)]. }
      assert (points_ : (forall v, In v (map as_point V) -> ~ equal_points x v) <->
        (forall v, In v V -> ~ equal_vectors (as_vector x) v)).
      { split; intros free.
        - intros v I equal. exact (free (as_point v) (in_map as_point V v I) equal).
        - intros v I equal. apply in_map_iff in I. destruct I as (w & <- & I). exact (free w I equal). }
      rewrite edges_, points_. tauto.
    + intros y. rewrite <- (as_vector_of_point y). rewrite <- member_by_edges. apply member_is_in_sum.
    + intros y s radius S on R. rewrite <- (as_vector_of_point y) in on.
      destruct (proj2 (on_boundary_is (as_point y) sum_)) as (e & E & on_e); [now exists s |].
      destruct (beside (as_point y) e radius E on_e R) as (z & close & out). exists (as_vector z).
      rewrite as_vector_of_point in close. split; [exact close |]. now rewrite <- member_is_in_sum.
  - unfold interiors_meet. split.
    + intros (z & in_p & in_q). exists (as_point z), (as_point (minus (as_vector x) z)).
      rewrite !inner_point_of_valid, !as_vector_of_point by assumption. split; [exact in_p |]. split; [exact in_q |].
      unfold equal_points, sum_of_points, as_point, minus, as_vector; cbn [x_of y_of vx vy]. split; ring.
    + intros (a & b & in_p & in_q & equal). exists (as_vector a).
      rewrite <- !inner_point_of_valid by assumption. rewrite inner_point_of_valid in in_q by assumption.
      split; [exact in_p |]. refine (inside_equal _ _ _ _ in_q).
      destruct equal as [X Y]. unfold minus, as_vector; cbn [vx vy x_of y_of sum_of_points] in *.
      split; cbn [vx vy]; [rewrite X | rewrite Y]; ring.
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
  intros p_region q_region p_simple q_simple. apply open_sum_around_is_the_open_sum; trivial.
  - now apply quick_sum_is_the_sum.
  - now apply sums_are_beside_the_outside.
Qed.

(* With a test of what it is given. *)
Definition checked_open_sum (p q : polygonal_region) : option open_region :=
  if covers_nothing_twice (as_region p) then
    if covers_nothing_twice (as_region q) then Some (open_sum_of_regions p q) else None
  else None.

Theorem open_sums_are_right (p q : polygonal_region) (s : open_region) : checked_open_sum p q = Some s -> is_open_sum
  p q s.
Proof.
  unfold checked_open_sum. destruct (covers_nothing_twice (as_region p)) eqn:p_test; [| discriminate].
  destruct (covers_nothing_twice (as_region q)) eqn:q_test; [| discriminate]. intros [= <-].
  apply covers_nothing_twice_is_right in p_test, q_test. destruct p_test, q_test.
  now apply open_sum_of_regions_is_the_open_sum.
Qed.
