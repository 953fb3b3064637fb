(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The thesis's algorithm: segments of the reduced convolution are cut where segments of the convolution meet them, and
   a piece is kept if the collision test says that just right of its middle the interiors of P and -Q + x do not meet,
   and just left of it they do. By Theorem 4.2.1 the test says what winding numbers say; by Theorem 2.3.2 nothing that
   is kept is on other segments, for it is on the boundary of the sum. So it returns the same sum. *)
From Coq Require Import QArith Lqa ZArith Lia Bool List Permutation.
From Oplus Require Import specification checker homogeneous_points specification_bridge regions_and_sums
  theorem_2_2_10 theorem_2_3_2 reduced_convolution fans_that_touch location pieces met_pieces naive_collision
  collision_is_complete placed_collision beside_a_piece filling kept_pieces_go_round cut_pieces rule_of_sides
  region_of_pieces sum_program sum_is_right sum_of_uncovered_pieces just_right_of_a_piece walks.
Import ListNotations.

Open Scope Q_scope.

Definition collides_to_the_right (p q : region) (e : segment) : bool :=
  collide p (placed (just_right_of (convolution_segments p q) e) q).

Definition reduced_pieces (p q : region) : list segment :=
  nodup segment_dec
    (flat_map (fun s => map undirected (cut_where_met s (convolution_segments p q))) (reduced_convolution p q)).

Definition reduced_filled (p q : region) : list segment := kept_pieces (collides_to_the_right p q) (reduced_pieces p q).

Definition reduced_sum (p q : polygonal_region) : polygonal_region :=
  let f := reduced_filled (as_region p) (as_region q) in
  map (map as_point) (chains_of (length f) f).

Section ValidRegions.
  Variables p q : region.
  Hypothesis p_region : valid_region p.
  Hypothesis q_region : valid_region q.
  Let segments := convolution_segments p q.
  Let all_long := all_are_long p q p_region q_region.
  Let closed := all_are_closed p q p_region q_region.
  Let cut_ := pieces_are_pieces segments all_long.

  (* What is kept is an edge of the sum, so its points are boundary points. *)
  Lemma kept_are_on_the_reduced_convolution (e : segment) : In e (pieces_of segments) ->
    kept_piece (is_right_inside segments) e <> [] -> on_reduced_convolution (middle e) p q.
  Proof.
    intros E kept_. apply boundary_is_part_of_the_reduced_convolution; trivial. intros radius R.
    pose proof (strictly_inside_lies_on _ _ (middle_is_inside e)) as on_e. split.
    - exists (middle e). split; [unfold within; lra |]. destruct (pieces_are_on _ _ cut_ e _ E on_e) as (t & T & on).
      exact (on_the_convolution_is_in_the_sum p q _ t T on).
    - pose proof (chains_of_kept segments _ _ (filled_ends_at_pieces segments all_long closed)) as permuted.
      set (chains := chains_of _ _) in permuted.
      destruct (kept_piece _ e) as [| s l] eqn:kept_is_; [contradiction |].
      assert (S : In s (kept_piece (is_right_inside segments) e)) by (rewrite kept_is_; now left).
      assert (on_s : lies_on (middle e) s).
      { destruct (proj2 (kept_is _ e s S)) as [-> | ->]; [exact on_e |].
        exact (strictly_inside_lies_on _ _ (strictly_inside_reversed _ _ (middle_is_inside e))). }
      assert (simple : nowhere_above_one chains).
      { intros y _. rewrite (winding_number_of_chains p q chains p_region q_region permuted).
        destruct (0 <? _)%Z; lia. }
      pose proof (sums_are_valid p q chains p_region q_region permuted) as valid.
      destruct (outside_is_near chains (middle e) s radius valid simple)
        as (y & close & free & none); trivial.
      { apply (Permutation_in _ (Permutation_sym permuted)), in_flat_map. now exists e. }
      exists y. split; [exact close |]. rewrite <- (points_of_the_sum p q chains p_region q_region permuted).
      intros [round | (t & T & on)]; [lia | exact (free t T on)].
  Qed.

  Lemma kept_are_reduced_pieces (e : segment) : In e (pieces_of segments) ->
    kept_piece (is_right_inside segments) e <> [] -> In e (reduced_pieces p q).
  Proof.
    intros E kept_. destruct (kept_are_on_the_reduced_convolution e E kept_) as (r & R & on_r).
    pose proof (reduced_is_part_of_the_convolution p q r R) as T.
    destruct (proj2 (cut_returns r (flat_map (intersection r) segments) (all_long r T)) _ on_r) as (piece & P & _ & on).
    rewrite (inside_one_piece segments all_long e (undirected piece) (middle e) E).
    - apply nodup_In, in_flat_map. exists r. split; [exact R | now apply in_map].
    - apply nodup_In, in_flat_map. exists r. split; [exact T | now apply in_map].
    - apply middle_is_inside.
    - exact (lies_on_of_one_place _ _ _ (of_one_place_sym _ _ (undirected_place piece)) on).
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

  (* Theorem. The same pieces are kept. *)
  Theorem reduced_filled_is : Permutation (reduced_filled p q) (filled segments).
  Proof.
    assert (part_ : incl (reduced_pieces p q) (pieces_of segments)).
    { intros e I. apply nodup_In, in_flat_map in I. destruct I as (r & R & I). apply nodup_In, in_flat_map. exists r.
      split; [now apply reduced_is_part_of_the_convolution | exact I]. }
    unfold reduced_filled, filled, kept_pieces.
    transitivity (flat_map (kept_piece (is_right_inside segments)) (reduced_pieces p q)).
    - rewrite !flat_map_concat_map. erewrite map_ext_in; [reflexivity |]. intros e E%part_.
      pose proof (pieces_are_long _ _ cut_ e E) as long. pose proof (pieces_are_met_along _ _ cut_ e E) as only.
      unfold kept_piece. rewrite !collides_to_the_right_is; trivial; [| now apply met_only_along_reversed].
      exact (long_of_one_place _ _ (reversed_place e) long).
    - apply kept_of_a_part; [apply NoDup_nodup | apply NoDup_nodup | exact part_ |].
      intros e E not_listed. destruct (kept_piece (is_right_inside segments) e) as [| s l] eqn:kept_; [reflexivity |].
      destruct not_listed. apply kept_are_reduced_pieces; [exact E |]. rewrite kept_. discriminate.
  Qed.
End ValidRegions.

(* Theorem. Of valid regions it is the Minkowski sum. *)
Theorem reduced_sum_is_the_sum (p q : polygonal_region) :
  valid_region (as_region p) -> valid_region (as_region q) ->
  nowhere_above_one (as_region p) -> nowhere_above_one (as_region q) -> is_minkowski_sum p q (reduced_sum p q).
Proof.
  intros p_region q_region p_simple q_simple. unfold reduced_sum. cbv zeta. apply chains_are_the_sum; trivial.
  now apply chains_of_permuted, reduced_filled_is.
Qed.
