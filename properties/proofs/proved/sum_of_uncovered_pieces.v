(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The same sum in little time. Nearly all of the convolution is inside the sum, and the sums of two edges
   (sums_of_two_edges.v) cover nearly all of that. So only segments of which parts are not covered are cut, and only by
   segments whose boxes meet theirs; and only of pieces in these parts winding numbers are counted. Proved here: a piece
   that has an inner point of the sum is not kept, so the same pieces are kept. *)
From Coq Require Import QArith Lqa ZArith Lia Bool List Permutation.
From Oplus Require Import specification checker homogeneous_points specification_bridge regions_and_sums
  theorem_2_2_10 observation_2_2_4 location pieces met_pieces naive_collision collision_is_sound beside_a_piece
  filling kept_pieces_go_round cut_pieces beside_a_vertex sum_program sum_is_right sums_in_less_time
  sums_of_two_edges convolution_in_less_time walks.
Import ListNotations.

Open Scope Q_scope.

(* Both numbers of one pair are less than both of the other. *)
Definition ranges_apart (a b c d : Q) : bool :=
  (negb (at_most c a) && negb (at_most c b) && negb (at_most d a) && negb (at_most d b)) ||
  (negb (at_most a c) && negb (at_most b c) && negb (at_most a d) && negb (at_most b d)).

Definition boxes_apart (s t : segment) : bool :=
  ranges_apart (vx (source s)) (vx (target s)) (vx (source t)) (vx (target t)) ||
  ranges_apart (vy (source s)) (vy (target s)) (vy (source t)) (vy (target t)).

Definition quick_intersection (s t : segment) : list vector := if boxes_apart s t then [] else intersection s t.

(* cut_where_met of pieces.v, in less time. *)
Definition quick_cut (s : segment) (others : list segment) : list segment :=
  cut s (flat_map (quick_intersection s) others).

Definition is_in_parts (k : Q) (l : list part) : bool :=
  existsb (fun part_ => at_most (fst part_) k && at_most k (snd part_)) l.

(* The pieces of a segment that sums of two edges do not cover. *)
Definition uncovered_pieces (d : denominator) (sums : list sum_of_two) (segments : list segment) (s : segment) :
  list segment :=
  match uncovered_parts d sums s with
  | [] => []
  | parts => filter (fun piece => is_in_parts (fraction s (middle piece)) parts) (quick_cut s segments)
  end.

Definition quick_filled (p q : region) : list segment :=
  let segments := quick_convolution p q in
  let d := common_multiple (denominators (segments ++ region_edges p ++ region_edges q)) in
  let sums := sums_of_edges d (region_edges p) (region_edges q) in
  kept_pieces (fun e => 0 <? number_to_the_right segments e)%Z
    (without_copies (flat_map (fun s => map undirected (uncovered_pieces d sums segments s)) segments)).

Definition quick_sum (p q : polygonal_region) : polygonal_region :=
  let f := quick_filled (as_region p) (as_region q) in
  map (map as_point) (chains_of (length f) f).

(* What is left out is not met. *)
Lemma ranges_apart_is (a b c d u v : Q) : 0 <= u <= 1 -> 0 <= v <= 1 ->
  (1 - u) * a + u * b == (1 - v) * c + v * d -> ranges_apart a b c d = false.
Proof.
  intros u_range v_range common. unfold ranges_apart.
  destruct (at_most_spec c a), (at_most_spec c b), (at_most_spec d a), (at_most_spec d b); cbn [negb andb orb];
    destruct (at_most_spec a c), (at_most_spec b c), (at_most_spec a d), (at_most_spec b d); cbn [negb andb];
    try reflexivity; exfalso.
  all: try (assert ((1 - u) * a + u * b < (1 - v) * c + v * d)
    by (apply mixed_is_more; trivial; apply mixed_is_less; trivial; lra); lra).
  all: assert ((1 - v) * c + v * d < (1 - u) * a + u * b)
    by (apply mixed_is_more; trivial; apply mixed_is_less; trivial; lra); lra.
Qed.

Lemma quick_intersection_is (s t : segment) : quick_intersection s t = intersection s t.
Proof.
  unfold quick_intersection, boxes_apart. destruct (intersection s t) as [| w l] eqn:common; [now destruct (_ || _) |].
  destruct (intersection_is_on_both s t w) as ((u & u_range & ux & uy) & (v & v_range & vx_ & vy_) & _);
    [rewrite common; now left |].
  rewrite (ranges_apart_is _ _ _ _ u v u_range v_range), (ranges_apart_is _ _ _ _ u v u_range v_range) by lra.
  reflexivity.
Qed.

Lemma quick_cut_is (s : segment) (others : list segment) : quick_cut s others = cut_where_met s others.
Proof. unfold quick_cut, cut_where_met. f_equal. apply flat_map_ext. apply quick_intersection_is. Qed.

Lemma is_in_parts_spec (k : Q) (l : list part) :
  reflect (exists part_, In part_ l /\ is_in_part k part_) (is_in_parts k l).
Proof.
  apply iff_reflect. unfold is_in_parts, is_in_part. rewrite existsb_exists.
  split; intros (part_ & I & inside_); exists part_; (split; [exact I |]);
    destruct (at_most_spec (fst part_) k), (at_most_spec k (snd part_)); cbn in *; try easy; lra.
Qed.

(* Pieces that are not kept may be left out. *)
Lemma kept_of_a_part (keep : segment -> list segment) (l some : list segment) : NoDup l -> NoDup some -> incl some l ->
  (forall e, In e l -> ~ In e some -> keep e = []) -> Permutation (flat_map keep some) (flat_map keep l).
Proof.
  intros l_distinct some_distinct part_ others.
  set (is_one := fun e => if in_dec segment_dec e some then true else false).
  assert (two_parts : forall m, incl m l -> Permutation (flat_map keep (filter is_one m)) (flat_map keep m)).
  { induction m as [| e m IH]; intros m_part; [constructor |]. cbn [filter flat_map]. unfold is_one at 1.
    assert (rest : incl m l) by (intros f F; apply m_part; now right).
    destruct (in_dec segment_dec e some) as [| not_one]; cbn [flat_map].
    - now apply Permutation_app_head, IH.
    - rewrite (others e); [now apply IH | apply m_part; now left | exact not_one]. }
  rewrite <- (two_parts l) by apply incl_refl.
  apply Permutation_flat_map, NoDup_Permutation; [exact some_distinct | now apply NoDup_filter |].
  intros e. rewrite filter_In. unfold is_one. destruct (in_dec segment_dec e some) as [I |]; [| easy].
  split; [| tauto]. intros _. split; [now apply part_ | reflexivity].
Qed.

Section ValidRegions.
  Variables p q : region.
  Hypothesis p_region : valid_region p.
  Hypothesis q_region : valid_region q.
  Let segments := convolution_segments p q.

  Lemma positive_at_inner_points (x : vector) : inner_point_of_sum x p q -> (0 < winding_number x segments)%Z.
  Proof.
    intros (radius & R & near).
    destruct (some_small _ (eventually_and _ _ (same_beside x segments) (eventually_and _ _
      (shifted_off_all x segments) (shifted_stays_within radius x R)))) as (e & _ & <- & free & close).
    apply positive_winding_number_iff_common_point; trivial. now apply near.
  Qed.

  Let segments_are_long := all_are_long p q p_region q_region.
  Let segments_are_closed := all_are_closed p q p_region q_region.

  Lemma positive_beside_inner_points (e : segment) (w : vector) : met_only_along segments e -> nonzero (along e) ->
    strictly_inside w e -> inner_point_of_sum w p q -> is_right_inside segments e = true.
  Proof.
    intros only long inside_ (radius & R & near). apply Z.ltb_lt.
    set (n := Vector (vy (along e)) (- vx (along e))).
    assert (right_ : cross (along e) n < 0).
    { pose proof (left_normal e long) as left_. unfold n, cross in *. cbn [vx vy] in *. lra. }
    destruct (some_small _ (eventually_and _ _
      (to_the_right_of_a_piece segments e segments_are_closed only long w n inside_ right_)
      (small_steps_stay_within ((1 # 2) * radius) w n ltac:(lra)))) as (d & _ & <- & close).
    apply positive_at_inner_points.
    exists ((1 # 2) * radius). split; [lra |]. intros y y_near. apply near. unfold within in *. lra.
  Qed.

  (* Theorem. What has an inner point of the sum is not kept. *)
  Theorem inner_pieces_are_not_kept (e : segment) (w : vector) : In e (pieces_of segments) -> strictly_inside w e ->
    inner_point_of_sum w p q -> kept_piece (is_right_inside segments) e = [].
  Proof.
    intros E inside_ inner. pose proof (pieces_are_pieces segments segments_are_long) as pieces_.
    pose proof (pieces_are_long _ _ pieces_ e E) as long. pose proof (pieces_are_met_along _ _ pieces_ e E) as only.
    unfold kept_piece. rewrite (positive_beside_inner_points e w), (positive_beside_inner_points (reversed e) w);
      trivial; [now apply met_only_along_reversed | exact (long_of_one_place _ _ (reversed_place e) long) |].
    now apply strictly_inside_reversed.
  Qed.

  Let d := common_multiple (denominators (segments ++ region_edges p ++ region_edges q)).
  Let sums := sums_of_edges d (region_edges p) (region_edges q).
  Let listed := flat_map (fun s => map undirected (uncovered_pieces d sums segments s)) segments.

  Lemma uncovered_pieces_are (s piece : segment) :
    In piece (uncovered_pieces d sums segments s) <->
    In piece (cut_where_met s segments) /\
    exists part_, In part_ (uncovered_parts d sums s) /\ is_in_part (fraction s (middle piece)) part_.
  Proof.
    unfold uncovered_pieces. rewrite quick_cut_is.
    destruct (uncovered_parts d sums s) as [| part_ parts].
    - split; [intros [] | intros (_ & part_ & [] & _)].
    - rewrite filter_In. now destruct (is_in_parts_spec (fraction s (middle piece)) (part_ :: parts)).
  Qed.

  Lemma listed_are_pieces (e : segment) : In e listed -> In e (pieces_of segments).
  Proof.
    intros I. apply in_flat_map in I. destruct I as (s & S & I). apply in_map_iff in I. destruct I as (piece & <- & I).
    apply uncovered_pieces_are in I. apply nodup_In, in_flat_map. exists s. split; [exact S | now apply in_map].
  Qed.

  Lemma others_are_not_kept (e : segment) : In e (pieces_of segments) -> ~ In e listed ->
    kept_piece (is_right_inside segments) e = [].
  Proof.
    intros E not_listed.
    destruct (piece_is segments segments_are_long e E) as (s & piece & S & P & e_is & part_ & long & _).
    pose proof (segments_are_long s S) as s_long.
    pose proof (strictly_inside_lies_on _ _ (middle_is_inside piece)) as on_piece.
    destruct (fraction_on s _ s_long (part_lies_on piece s _ part_ on_piece)) as (range & is_middle).
    change (equal_vectors (middle piece) (point_at s (fraction s (middle piece)))) in is_middle.
    destruct (covered_is_inside_the_sum p q d s (fraction s (middle piece))) as [found | inner]; trivial.
    { intros t which. apply ends_have_denominator, in_app_iff. rewrite in_app_iff. destruct which as [-> |]; tauto. }
    - exfalso. apply not_listed, in_flat_map. exists s. split; [exact S |]. rewrite e_is. apply in_map.
      now apply uncovered_pieces_are.
    - refine (inner_pieces_are_not_kept e (point_at s _) E (strictly_inside_equal (middle piece) _ _ is_middle _)
        inner).
      rewrite e_is. apply (strictly_inside_of_one_place piece), middle_is_inside.
      apply of_one_place_sym, undirected_place.
  Qed.

  (* Theorem. The same pieces are kept. *)
  Theorem quick_filled_is : Permutation (quick_filled p q) (filled segments).
  Proof.
    unfold quick_filled. rewrite quick_convolution_is. fold segments. cbv zeta. fold d. fold sums. fold listed.
    unfold filled, kept_pieces. rewrite (flat_map_ext _ (kept_piece (is_right_inside segments)))
      by (intros e; unfold kept_piece, is_right_inside; now rewrite !number_to_the_right_is).
    apply kept_of_a_part; [apply NoDup_nodup | apply without_copies_is_distinct | |].
    - intros e I. apply listed_are_pieces. now apply in_without_copies.
    - intros e E not_listed. apply others_are_not_kept; [exact E |]. intros I. apply not_listed.
      now apply in_without_copies.
  Qed.
End ValidRegions.

(* The chains consist of these pieces. *)
Lemma chains_of_permuted (p q : region) (f : list segment) : valid_region p -> valid_region q ->
  Permutation f (filled (convolution_segments p q)) ->
  Permutation (region_edges (chains_of (length f) f)) (filled (convolution_segments p q)).
Proof.
  intros p_region q_region same_pieces. rewrite <- same_pieces. apply chains_take_all; [lia |]. intros v.
  rewrite (surplus_permuted v _ _ same_pieces).
  apply filled_is_balanced; [now apply all_are_long | now apply all_are_closed].
Qed.

Lemma quick_chains_are (p q : region) : valid_region p -> valid_region q ->
  let f := quick_filled p q in Permutation (region_edges (chains_of (length f) f)) (filled (convolution_segments p q)).
Proof. intros p_region q_region. now apply chains_of_permuted, quick_filled_is. Qed.

(* Theorem. Of valid regions it is the Minkowski sum. *)
Theorem quick_sum_is_the_sum (p q : polygonal_region) :
  valid_region (as_region p) -> valid_region (as_region q) -> is_minkowski_sum p q (quick_sum p q).
Proof.
  intros p_region q_region. unfold quick_sum. cbv zeta. apply chains_are_the_sum; trivial. now apply quick_chains_are.
Qed.
