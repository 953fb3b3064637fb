(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Valid regions stay valid when their vertices are written in another way, and so does the outside of one in a square
   frame around it (inner_fit_program.v). *)
From Coq Require Import QArith Qabs Lqa ZArith Lia Bool List Permutation.
From Oplus Require Import specification regions_and_sums homogeneous_points specification_bridge collision_is_complete
  placed_collision distinct edges_of_valid_regions walks sum_program sum_is_right turned_chains inner_fit_program.
Import ListNotations.

Open Scope Q_scope.

Lemma source_is_a_target (r : region) (s : segment) : In s (region_edges r) ->
  exists t, In t (region_edges r) /\ target t = source s.
Proof.
  intros S. apply in_flat_map in S. destruct S as (c & C & S). destruct (edges_ends c) as [sources targets].
  assert (I : In (source s) (map target (edges c))).
  { rewrite targets. apply (Permutation_in _ (Permutation_sym (rotated_permutes c))). rewrite <- sources.
    now apply in_map. }
  apply in_map_iff in I. destruct I as (t & equal & T). exists t. split; [| exact equal]. apply in_flat_map.
  now exists c.
Qed.

(* Pairs of a list, in whatever order. *)
Section Pairs.
  Context {A : Type}.
  Variable related : A -> A -> Prop.
  Hypothesis symmetric : forall a b, related a b -> related b a.

  Lemma pairs_by_position (l : list A) : ForallOrdPairs related l <->
    forall earlier s later t, l = earlier ++ s :: later -> In t (earlier ++ later) -> related s t.
  Proof.
    split.
    - intros pairs earlier s later t -> T. destruct (pair_at _ _ _ _ _ pairs T); auto.
    - induction l as [| a l IH]; intros all; constructor.
      + apply Forall_forall. intros b B. now apply (all [] a l).
      + apply IH. intros earlier s later t -> T. apply (all (a :: earlier) s later); [reflexivity | now right].
  Qed.

  Lemma pairs_permuted (l k : list A) : Permutation l k -> ForallOrdPairs related l -> ForallOrdPairs related k.
  Proof.
    intros permuted. induction permuted as [| a l k permuted IH | a b l | l k m _ IH _ IH']; intros pairs; auto;
      inversion pairs as [| ? ? first rest]; subst.
    - constructor; [now apply (Permutation_Forall permuted) | auto].
    - inversion rest as [| ? ? first' rest']; inversion first; subst. repeat constructor; auto.
  Qed.
End Pairs.

Lemma pairs_mapped {A B : Type} (related : A -> A -> Prop) (others : B -> B -> Prop) (f : A -> B) (l : list A) :
  (forall s t, In s l -> In t l -> related s t -> others (f s) (f t)) -> ForallOrdPairs related l ->
  ForallOrdPairs others (map f l).
Proof.
  intros more pairs. apply (weaker_pairs _ _ _ more) in pairs. clear more. induction pairs; constructor; trivial.
  now apply Forall_map.
Qed.

Lemma edges_meet_by_pairs (r : region) :
  edges_meet_in_vertices r <-> ForallOrdPairs (meet_in_sources (region_edges r)) (region_edges r).
Proof.
  rewrite (pairs_by_position _ (meet_in_sources_swapped _)). split.
  - intros meet earlier s later t is_ T w. exact (meet earlier s later t w is_ T).
  - intros meet earlier s later t w is_ T. exact (meet earlier s later t is_ T w).
Qed.

(* Vertices written in another way. *)
Theorem images_are_valid (h : vector -> vector) (r : region) : (forall v, equal_vectors (h v) v) ->
  valid_region r -> valid_region (map (map h) r).
Proof.
  intros same (not_points & not_negative & meet). split; [| split].
  - apply edges_are_no_points. rewrite edges_of_images. intros s S. apply in_map_iff in S. destruct S as (t & <- & T).
    pose proof (region_edges_are_directions r not_points t T) as long.
    destruct (same (source t)) as [sx sy], (same (target t)) as [tx ty]. intros [X Y]. apply long.
    unfold along, moved_ends, minus in *; cbn [source target vx vy] in *. split; lra.
  - intros x free. rewrite edges_of_images, (winding_number_of_images h same). apply not_negative. intros s S on.
    destruct (proj2 (on_images h same x (region_edges r))) as (t & T & on_t); [now exists s |].
    rewrite <- edges_of_images in T. exact (free t T on_t).
  - apply edges_meet_by_pairs. rewrite edges_of_images. apply edges_meet_by_pairs in meet.
    refine (pairs_mapped _ _ _ _ _ meet). intros s t S T related w on_s on_t.
    assert (back : forall u, lies_on w (moved_ends h u) -> lies_on w u).
    { intros [c d] on. unfold moved_ends in on. cbn [source target] in on.
      refine (lies_on_of_equal w w _ _ c d _ _ _ on); [reflexivity | apply same ..]. }
    destruct (related w (back s on_s) (back t on_t)) as (u & U & equal). exists (moved_ends h u).
    split; [now apply in_map |]. destruct (same (source u)), equal.
    unfold moved_ends; cbn [source]. split; lra.
Qed.

Theorem images_are_simple (h : vector -> vector) (r : region) : (forall v, equal_vectors (h v) v) ->
  nowhere_above_one r -> nowhere_above_one (map (map h) r).
Proof.
  intros same simple x free. rewrite edges_of_images, (winding_number_of_images h same). apply simple. intros s S on.
  destruct (proj2 (on_images h same x (region_edges r))) as (t & T & on_t); [now exists s |].
  rewrite <- edges_of_images in T. exact (free t T on_t).
Qed.

Lemma as_image (r : region) : exists h, (forall v, equal_vectors (h v) v) /\ as_region (as_polygonal r) = map (map h) r.
Proof.
  exists (fun v => homogeneous_points.vector_of (checker.homogeneous (as_point v))). split.
  - intros v. rewrite (homogeneous_points.homogeneous_is (as_point v)). split; reflexivity.
  - unfold as_region, as_polygonal. rewrite map_map. apply map_ext. intros c. now rewrite map_map.
Qed.

Corollary polygonal_is_valid (r : region) : valid_region r -> nowhere_above_one r ->
  valid_region (as_region (as_polygonal r)) /\ nowhere_above_one (as_region (as_polygonal r)).
Proof.
  destruct (as_image r) as (h & same & ->). split; [now apply images_are_valid | now apply images_are_simple].
Qed.

(* The frame. *)
Lemma frame_goes_round (k : Q) (x : vector) : - k < vx x < k -> - k < vy x < k ->
  winding_number x (edges (frame k)) = 1%Z.
Proof.
  intros in_x in_y. unfold winding_number, edges, frame, sum. cbn [rotated app combine map fst snd fold_right].
  rewrite !signed_crossing_by_turn. cbn [vx vy].
  assert (low : Qle_bool (- k) (vy x) = true) by (apply Qle_bool_iff; lra).
  assert (high : Qle_bool k (vy x) = false) by (apply not_true_iff_false; rewrite Qle_bool_iff; lra).
  rewrite low, high. unfold turn_of; cbn [vx vy].
  assert (positive_ : forall u v : Q, 0 < u -> 0 < v -> 0 < u * v) by (intros; now apply Qmult_lt_0_compat).
  pose proof (positive_ (k - - k) (k - vx x) ltac:(lra) ltac:(lra)).
  pose proof (positive_ (k - - k) (vx x - - k) ltac:(lra) ltac:(lra)).
  match goal with |- context [Qle_bool ?u 0] =>
    assert (right_ : Qle_bool u 0 = false) by (apply not_true_iff_false; rewrite Qle_bool_iff; lra) end.
  match goal with |- context [Qle_bool 0 ?u] => assert (left_ : Qle_bool 0 u = true) by (apply Qle_bool_iff; lra) end.
  rewrite right_, left_. reflexivity.
Qed.

Lemma on_the_frame (k : Q) (x : vector) (s : segment) : In s (edges (frame k)) -> lies_on x s ->
  (vx x == k \/ vx x == - k) \/ (vy x == k \/ vy x == - k).
Proof.
  intros S (t & range & X & Y). unfold edges, frame in S. cbn [rotated app combine map fst snd] in S.
  destruct S as [<- | [<- | [<- | [<- | []]]]]; cbn [source target vx vy] in *; lra.
Qed.

Lemma off_the_frame (k : Q) (x : vector) : - k < vx x < k -> - k < vy x < k -> off x (edges (frame k)).
Proof. intros in_x in_y s S on. pose proof (on_the_frame k x s S on). lra. Qed.

Lemma frame_is_all_around (k : Q) (x : vector) : 0 < k -> in_square k x -> off x (edges (frame k)) ->
  - k < vx x < k /\ - k < vy x < k.
Proof.
  intros some [in_x in_y] free.
  assert (ratio : forall u, - k <= u <= k -> exists t, 0 <= t <= 1 /\ u == (1 - t) * - k + t * k).
  { intros u range. exists ((u + k) / (2 * k)).
    assert (value : (u + k) / (2 * k) * (2 * k) == u + k) by (field; lra).
    split; [split; [apply Qle_shift_div_l | apply Qle_shift_div_r]; lra |]. set (t := (u + k) / (2 * k)) in *. lra. }
  destruct (ratio (vx x) in_x) as (t & t_range & at_x), (ratio (vy x) in_y) as (l & l_range & at_y).
  unfold off, edges, frame in free. cbn [rotated app combine map fst snd] in free.
  repeat split; apply Qnot_le_lt; intros extreme;
    [apply (free (Segment (Vector (- k) k) (Vector (- k) (- k)))); [cbn; tauto |]; exists (1 - l) |
     apply (free (Segment (Vector k (- k)) (Vector k k))); [cbn; tauto |]; exists l |
     apply (free (Segment (Vector (- k) (- k)) (Vector k (- k)))); [cbn; tauto |]; exists t |
     apply (free (Segment (Vector k k) (Vector (- k) k))); [cbn; tauto |]; exists (1 - t)];
    cbn [source target vx vy]; (split; [lra | split; lra]).
Qed.

Lemma frame_goes_round_once (k : Q) (x : vector) : 0 < k -> off x (edges (frame k)) ->
  winding_number x (edges (frame k)) = 0%Z \/ winding_number x (edges (frame k)) = 1%Z.
Proof.
  intros some free. destruct (is_in_square_spec k x) as [close | far].
  - right. destruct (frame_is_all_around k x some close free). now apply frame_goes_round.
  - left. apply (nothing_goes_round_outside k); [apply closed_chain_cycles | | exact far].
    intros s S. unfold edges, frame in S. cbn [rotated app combine map fst snd] in S.
    destruct S as [<- | [<- | [<- | [<- | []]]]]; unfold in_square; cbn [source target vx vy]; lra.
Qed.

Lemma number_of_both (x : vector) (l k : list segment) :
  winding_number x (l ++ k) = (winding_number x l + winding_number x k)%Z.
Proof. unfold winding_number, sum. rewrite map_app. induction (map (signed_crossing x) l); cbn; lia. Qed.

Section Complement.
  Variable a : region.
  Variables m k : Q.
  Hypothesis some : 0 < m.
  Hypothesis larger_frame : m < k.
  Hypothesis a_fits : forall s, In s (region_edges a) -> in_square m (source s) /\ in_square m (target s).
  Hypothesis a_region : valid_region a.
  Hypothesis a_simple : nowhere_above_one a.

  Lemma number_of_complement (x : vector) : off x (region_edges (complement_in_frame k a)) ->
    winding_number x (region_edges (complement_in_frame k a)) = 0%Z \/
    winding_number x (region_edges (complement_in_frame k a)) = 1%Z.
  Proof.
    intros free. unfold complement_in_frame in *. cbn [region_edges flat_map] in *.
    fold (region_edges (map turned_chain a)) in *. rewrite number_of_both, winding_number_of_turned.
    assert (free_frame : off x (edges (frame k))) by (intros s S; apply free, in_app_iff; now left).
    assert (free_a : off x (region_edges a)).
    { intros s S on. destruct (proj2 (on_turned x a)) as (t & T & on_t); [now exists s |].
      apply (free t); [apply in_app_iff; now right | exact on_t]. }
    destruct (is_in_square_spec m x) as [[in_x in_y] | far].
    - rewrite frame_goes_round by lra. destruct a_region as (_ & not_negative & _).
      pose proof (not_negative x free_a). pose proof (a_simple x free_a). lia.
    - rewrite (nothing_goes_round_outside m (region_edges a) x (region_cycles a) a_fits far).
      destruct (frame_goes_round_once k x ltac:(lra) free_frame); lia.
  Qed.

  Theorem complement_is_valid : valid_region (complement_in_frame k a) /\ nowhere_above_one (complement_in_frame k a).
  Proof.
    pose proof a_region as (not_points & _ & meet).
    split; [split; [| split] |].
    - apply edges_are_no_points. intros s S. unfold complement_in_frame in S. cbn [region_edges flat_map] in S.
      apply in_app_iff in S. destruct S as [S | S].
      + unfold edges, frame in S. cbn [rotated app combine map fst snd] in S.
        destruct S as [<- | [<- | [<- | [<- | []]]]]; unfold nonzero, along, minus; cbn [source target vx vy]; lra.
      + apply (Permutation_in _ (region_edges_of_turned a)), in_map_iff in S. destruct S as (t & <- & T).
        pose proof (region_edges_are_directions a not_points t T) as long. intros [X Y]. apply long.
        unfold along, reversed, minus in *; cbn [source target vx vy] in *. split; lra.
    - intros x free. destruct (number_of_complement x free); lia.
    - apply edges_meet_by_pairs. unfold complement_in_frame at 2. cbn [region_edges flat_map].
      fold (region_edges (map turned_chain a)). apply pairs_of_two_lists.
      + apply (weaker_pairs (fun s t => forall w, lies_on w s -> lies_on w t -> exists e,
          In e (edges (frame k)) /\ equal_vectors w (source e))).
        { intros s t _ _ common w on_s on_t. destruct (common w on_s on_t) as (e & E & equal). exists e.
          split; [apply in_app_iff; now left | exact equal]. }
        unfold edges, frame. cbn [rotated app combine map fst snd].
        repeat (constructor; [repeat constructor |]); try constructor;
          intros w (u & u_range & ux & uy) (v & v_range & v_x & v_y); cbn [source target vx vy] in *;
          first [exfalso; lra | eexists; (split; [now left |]); split; cbn; lra |
            eexists; (split; [right; now left |]); split; cbn; lra |
            eexists; (split; [right; right; now left |]); split; cbn; lra |
            eexists; (split; [right; right; right; now left |]); split; cbn; lra].
      + apply (pairs_permuted _ (meet_in_sources_swapped _) _ _ (Permutation_sym (region_edges_of_turned a))).
        apply edges_meet_by_pairs in meet. refine (pairs_mapped _ _ _ _ _ meet).
        intros s t S T related w on_s on_t. apply lies_on_reversed in on_s. apply lies_on_reversed in on_t.
        destruct (related w on_s on_t) as (u & U & equal).
        destruct (source_is_a_target a u U) as (v & V & end_). exists (reversed v). split.
        * apply in_app_iff. right.
          apply (Permutation_in _ (Permutation_sym (region_edges_of_turned a))). now apply in_map.
        * cbn [reversed source]. now rewrite end_.
      + intros s t S T w on_s on_t. exfalso. pose proof (on_the_frame k w s S on_s) as where_.
        apply (Permutation_in _ (region_edges_of_turned a)), in_map_iff in T. destruct T as (u & <- & U).
        apply lies_on_reversed in on_t. destruct (a_fits u U) as [in_source in_target].
        destruct (squares_are_convex m u w in_source in_target on_t). lra.
    - intros x free. destruct (number_of_complement x free); lia.
  Qed.
End Complement.
