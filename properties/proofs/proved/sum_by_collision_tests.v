(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The thesis's algorithm: segments of the reduced convolution are cut where segments of the convolution meet them, and
   a piece is kept if the collision test says that just right of its middle the interiors of P and -Q + x do not meet,
   and just left of it they do. By Theorem 4.2.1 the test says what winding numbers say; by Theorem 2.3.2 nothing that
   is kept is on other segments. So it returns the same sum. Chains of a region may not touch: with them Theorem 2.3.2
   is false. *)
From Coq Require Import QArith Lqa ZArith Lia Bool List Permutation.
From Oplus Require Import specification checker homogeneous_points specification_bridge regions_and_sums
  theorem_2_2_10 lemma_2_2_2 boundary_points reduced_convolution interiors_at_touching_points test_of_regions location
  pieces met_pieces naive_collision collision_is_sound collision_is_complete placed_collision checked_collision
  beside_a_piece filling kept_pieces_go_round cut_pieces beside_a_vertex sum_program sum_is_right
  sum_of_uncovered_pieces just_right_of_a_piece walks
  fans_that_touch.
Import ListNotations.

Open Scope Q_scope.

Definition collides_to_the_right (p q : region) (e : segment) : bool :=
  collide p (placed (just_right_of (convolution_segments p q) e) q).

Definition kept_by_collisions (p q : region) (e : segment) : list segment :=
  match collides_to_the_right p q (reversed e), collides_to_the_right p q e with
  | true, false => [e]
  | false, true => [reversed e]
  | _, _ => []
  end.

Definition reduced_pieces (p q : region) : list segment :=
  nodup segment_dec
    (flat_map (fun s => map undirected (cut_where_met s (convolution_segments p q))) (reduced_convolution p q)).

Definition reduced_filled (p q : region) : list segment := flat_map (kept_by_collisions p q) (reduced_pieces p q).

Definition reduced_sum (p q : polygonal_region) : polygonal_region :=
  let f := reduced_filled (as_region p) (as_region q) in
  map (map as_point) (chains_of (length f) f).

Section ValidRegions.
  Variables p q : region.
  Hypothesis p_region : valid_region p.
  Hypothesis q_region : valid_region q.
  Hypothesis p_apart : chains_do_not_touch p.
  Hypothesis q_apart : chains_do_not_touch q.
  Let segments := convolution_segments p q.
  Let all_long := all_are_long p q p_region q_region.
  Let closed := all_are_closed p q p_region q_region.
  Let cut_ := pieces_are_pieces segments all_long.

  (* Off the reduced convolution, all of the convolution is inside the sum (Theorem 2.3.2). *)
  Lemma kept_are_on_the_reduced_convolution (e : segment) : In e (pieces_of segments) -> kept_piece (is_right_inside segments) e <> [] ->
    on_reduced_convolution (middle e) p q.
  Proof.
    intros E kept_. destruct (on_or_off (middle e) (reduced_convolution p q)) as [on | free]; [exact on | exfalso].
    apply kept_. apply (inner_pieces_are_not_kept p q p_region q_region e (middle e) E (middle_is_inside e)).
    apply interiors_meet_means_inner_point, common_point_means_common_inner_point; trivial.
    destruct (pieces_are_on _ _ cut_ e (middle e) E (strictly_inside_lies_on _ _ (middle_is_inside e)))
      as (t & T & on_t).
    exact (on_the_convolution_is_in_the_sum p q (middle e) t T on_t).
  Qed.

  Lemma kept_are_reduced_pieces (e : segment) : In e (pieces_of segments) -> kept_piece (is_right_inside segments) e <> [] ->
    In e (reduced_pieces p q).
  Proof.
    intros E kept_. destruct (kept_are_on_the_reduced_convolution e E kept_) as (r & R & on_r).
    pose proof (reduced_is_part_of_the_convolution p q r R) as T.
    destruct (cut_returns r (flat_map (intersection r) segments) (all_long r T)) as [_ all_].
    destruct (all_ (middle e) on_r) as (piece & P & _ & on_piece).
    assert (listed : In (undirected piece) (pieces_of segments)).
    { apply nodup_In, in_flat_map. exists r. split; [exact T | now apply in_map]. }
    destruct (segment_dec e (undirected piece)) as [-> | differ].
    - apply nodup_In, in_flat_map. exists r. split; [exact R | now apply in_map].
    - exfalso. refine (different_pieces segments all_long e (undirected piece) E listed differ (middle e)
        (middle_is_inside e) _).
      pose proof (lies_on_of_one_place _ _ _ (of_one_place_sym _ _ (undirected_place piece)) on_piece) as on_.
      assert (not_end : forall v, v = source (undirected piece) \/ v = target (undirected piece) ->
        ~ equal_vectors v (middle e)).
      { intros v end_ [same_x same_y].
        apply (no_vertex_is_inside segments all_long (undirected piece) e v listed E end_).
        destruct (middle_is_inside e) as (j & j_range & jx & jy). exists j. rewrite same_x, same_y. tauto. }
      destruct (inside_or_end _ _ on_) as [inside_ | [equal | equal]]; [exact inside_ | exfalso ..].
      + apply (not_end (source (undirected piece))); tauto.
      + apply (not_end (target (undirected piece))); tauto.
  Qed.

  Hypothesis p_simple : nowhere_above_one p.
  Hypothesis q_simple : nowhere_above_one q.

  (* The collision test returns what the winding number says. *)
  Lemma collides_to_the_right_is (s : segment) : nonzero (along s) -> met_only_along segments s ->
    collides_to_the_right p q s = is_right_inside segments s.
  Proof.
    intros long only. set (m := middle s). set (n := to_the_right s). set (far := half_way m n segments).
    assert (far_some : 0 < far) by apply half_way_is.
    destruct (some_small _ (eventually_and _ _ (to_the_right_of_a_piece segments s closed only long m n
      (middle_is_inside s) (right_normal s long)) (eventually_below far far_some))) as (d & _ & near & d_range).
    unfold is_right_inside. rewrite <- near.
    assert (way_is_free : forall w, lies_on w (Segment (moved_along m n d) (just_right_of segments s)) ->
      off w segments).
    { intros w (k & range & X & Y).
      assert (0 <= k * (far - d)) by (apply Qmult_le_0_compat; lra).
      assert (0 <= (1 - k) * (far - d)) by (apply Qmult_le_0_compat; lra).
      apply (off_equal (moved_along m n (d + k * (far - d)))).
      - unfold just_right_of, moved_along in *. fold m n far in X, Y. cbn [source target vx vy] in *.
        unfold equal_vectors. cbn [vx vy]. rewrite X, Y. split; ring.
      - apply nothing_just_right; trivial; [lra |]. fold m n far. lra. }
    pose proof (winding_number_along _ segments closed way_is_free) as same_number.
    cbn [source target] in same_number. rewrite same_number.
    pose proof (way_is_free _ (target_lies_on _)) as free. cbn [target] in free.
    set (x := just_right_of segments s) in *. unfold collides_to_the_right. fold segments. fold x.
    apply eq_true_iff_eq. rewrite Z.ltb_lt.
    rewrite (collide_decides_whether_interiors_meet p q x p_region q_region p_simple q_simple).
    symmetry. now apply positive_winding_number_iff_common_inner_point.
  Qed.

  Lemma kept_by_collisions_is (e : segment) : In e (pieces_of segments) ->
    kept_by_collisions p q e = kept_piece (is_right_inside segments) e.
  Proof.
    intros E. pose proof (pieces_are_long _ _ cut_ e E) as long. pose proof (pieces_are_met_along _ _ cut_ e E) as only.
    unfold kept_by_collisions, kept_piece. rewrite (collides_to_the_right_is e long only), collides_to_the_right_is.
    - reflexivity.
    - exact (long_of_one_place _ _ (reversed_place e) long).
    - now apply met_only_along_reversed.
  Qed.

  (* Theorem. The same pieces are kept. *)
  Theorem reduced_filled_is : Permutation (reduced_filled p q) (filled segments).
  Proof.
    assert (part_ : incl (reduced_pieces p q) (pieces_of segments)).
    { intros e I. apply nodup_In, in_flat_map in I. destruct I as (r & R & I). apply nodup_In, in_flat_map. exists r.
      split; [now apply reduced_is_part_of_the_convolution | exact I]. }
    unfold reduced_filled, filled, kept_pieces.
    transitivity (flat_map (kept_piece (is_right_inside segments)) (reduced_pieces p q)).
    - enough (same_ : forall l, incl l (pieces_of segments) ->
        flat_map (kept_by_collisions p q) l = flat_map (kept_piece (is_right_inside segments)) l) by (now rewrite same_).
      induction l as [| e l IH]; intros l_part; [reflexivity |]. cbn [flat_map].
      rewrite kept_by_collisions_is by (apply l_part; now left). f_equal. apply IH. intros f F. apply l_part. now right.
    - apply kept_of_a_part; [apply NoDup_nodup | apply NoDup_nodup | exact part_ |].
      intros e E not_listed. destruct (kept_piece (is_right_inside segments) e) as [| s l] eqn:kept_; [reflexivity | exfalso].
      apply not_listed, kept_are_reduced_pieces; [exact E |]. rewrite kept_. discriminate.
  Qed.
End ValidRegions.

(* Theorem. Of valid regions of which no chains touch it is the Minkowski sum. *)
Theorem reduced_sum_is_the_sum (p q : polygonal_region) :
  valid_region (as_region p) -> valid_region (as_region q) ->
  chains_do_not_touch (as_region p) -> chains_do_not_touch (as_region q) ->
  nowhere_above_one (as_region p) -> nowhere_above_one (as_region q) -> is_minkowski_sum p q (reduced_sum p q).
Proof.
  intros p_region q_region p_apart q_apart p_simple q_simple. unfold reduced_sum. cbv zeta.
  apply chains_are_the_sum; trivial.
  pose proof (reduced_filled_is _ _ p_region q_region p_apart q_apart p_simple q_simple) as same_pieces.
  rewrite <- same_pieces. apply chains_take_all; [lia |]. intros v. rewrite (surplus_permuted v _ _ same_pieces).
  apply filled_is_balanced; [now apply all_are_long | now apply all_are_closed].
Qed.

(* Corollary. So it is of regions that pass two tests by comparisons. *)
Corollary reduced_sum_of_checked_regions (p q : polygonal_region) :
  covers_nothing_twice (as_region p) && does_not_touch (as_region p) = true ->
  covers_nothing_twice (as_region q) && does_not_touch (as_region q) = true -> is_minkowski_sum p q (reduced_sum p q).
Proof.
  rewrite !andb_true_iff. intros [p_check p_apart] [q_check q_apart].
  apply covers_nothing_twice_is_right in p_check, q_check. destruct p_check, q_check.
  apply reduced_sum_is_the_sum; trivial; now apply does_not_touch_is_right.
Qed.
