(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The boundary of the sum as it is kept in filling.v is part of the reduced convolution (Theorem 2.3.2), and meets its
   pieces along them only, or in their ends. So it is known by what is on both sides of these pieces, and there, off the
   reduced convolution, the sum is where the interiors of P and -Q + x meet, which the collision test decides. *)
From Coq Require Import QArith Lqa ZArith Lia Bool List Permutation.
From Oplus Require Import convolution shifted_ray signed_crossings small_numbers in_out_degree
  convolution_winding regions winding_number_of_the_sum meeting_of_segments interiors_meet neighbourhoods
  left_of_an_edge theorem_4_2_1 theorem_2_2_10 observation_2_2_4 lemma_2_2_2 boundary_points reduced_convolution
  interiors_at_touching_points location pieces met_pieces naive_collision collision_is_sound collision_is_complete
  placed_collision beside_a_piece filling kept_pieces_go_round cut_pieces sum_program sum_is_right total_sum valid_sum
  sums_of_two_edges sum_of_uncovered_pieces just_right_of_a_piece.
Import ListNotations.

Open Scope Q_scope.

(* The collision test says whether the sum is to the right of a piece. *)
Definition collides_to_the_right (p q : region) (e : segment) : bool :=
  collide p (placed (just_right_of (reduced_convolution p q) e) q).

Section ValidRegions.
  Variables p q : region.
  Hypothesis p_region : valid_region p.
  Hypothesis q_region : valid_region q.
  Hypothesis p_apart : chains_do_not_touch p.
  Hypothesis q_apart : chains_do_not_touch q.
  Let segments := convolution_segments p q.
  Let reduced_ := reduced_convolution p q.

  (* The boundary as chains. *)
  Definition boundary_of_the_sum : list segment :=
    region_edges (chains_of (length (filled segments)) (filled segments)).

  Lemma boundary_is_filled : Permutation boundary_of_the_sum (filled segments).
  Proof.
    apply chains_take_all; [lia |].
    apply filled_is_balanced; [now apply segments_are_long | now apply segments_are_closed].
  Qed.

  Lemma boundary_is_closed : cycles boundary_of_the_sum.
  Proof. apply region_cycles. Qed.

  Lemma boundary_goes_round (x : vector) :
    winding_number x boundary_of_the_sum = if (0 <? winding_number x segments)%Z then 1%Z else 0%Z.
  Proof.
    rewrite (permuted_winding_number x _ _ boundary_is_filled).
    apply filled_is_right; [now apply segments_are_long | now apply segments_are_closed].
  Qed.

  Lemma on_the_reduced_is_in_the_sum (x : vector) (s : segment) : In s reduced_ -> lies_on x s -> in_sum x p q.
  Proof.
    intros S. apply (on_the_convolution_is_in_the_sum p q x s). now apply reduced_is_part_of_the_convolution.
  Qed.

  (* Off the reduced convolution the boundary goes round what is in the sum. *)
  Lemma boundary_goes_round_the_sum (x : vector) : off x reduced_ ->
    (winding_number x boundary_of_the_sum = 1%Z <-> interiors_meet x p q).
  Proof.
    intros free. rewrite boundary_goes_round.
    pose proof p_region as (p_edges & p_valid & _). pose proof q_region as (q_edges & q_valid & _).
    destruct (Z.ltb_spec 0 (winding_number x segments)) as [positive_ | none].
    - split; [intros _ | reflexivity]. apply common_point_means_common_inner_point; trivial.
      now apply positive_winding_number_is_in_the_sum.
    - split; [discriminate |]. intros meet_.
      pose proof (interiors_meet_means_positive_winding_number p q x p_edges q_edges p_valid q_valid meet_).
      unfold segments in none. lia.
  Qed.

  Lemma inside_of_boundary_is_not_inner (k : segment) (w : vector) : In k boundary_of_the_sum ->
    strictly_inside w k -> ~ inner_point_of_sum w p q.
  Proof.
    intros K inside_ inner. apply (Permutation_in _ boundary_is_filled) in K. apply in_flat_map in K.
    destruct K as (e & E & K). apply (inside_of_kept segments e k w K) in inside_.
    unfold segments in K. now rewrite (inner_pieces_are_not_kept p q p_region q_region e w E inside_ inner) in K.
  Qed.

  Lemma on_boundary_is_in_the_sum (k : segment) (w : vector) : In k boundary_of_the_sum -> lies_on w k -> in_sum w p q.
  Proof.
    intros K on. apply (Permutation_in _ boundary_is_filled) in K.
    destruct (filled_is_on segments (segments_are_long p q p_region q_region) k w K on) as (t & T & on_t).
    exact (on_the_convolution_is_in_the_sum p q w t T on_t).
  Qed.

  (* Theorem 2.3.2, for what is kept. *)
  Theorem boundary_is_on_the_reduced_convolution (k : segment) (w : vector) :
    In k boundary_of_the_sum -> lies_on w k -> on_reduced_convolution w p q.
  Proof.
    intros K (j & range & X & Y). destruct (on_or_off w reduced_) as [on | free]; [exact on | exfalso].
    destruct (off_near w reduced_ free) as (radius & R & near).
    set (u := minus (middle k) w).
    destruct (small_steps_stay_within radius w u R) as (limit & L & close).
    set (d := (1 # 2) * (if Qlt_le_dec limit 1 then limit else 1)).
    assert (d_range : 0 < d /\ d < limit /\ d < 1) by (unfold d; destruct (Qlt_le_dec limit 1); lra).
    clearbody d. specialize (close d ltac:(lra) ltac:(lra)). specialize (near _ close).
    assert (inside_ : strictly_inside (moved_along w u d) k).
    { exists ((1 - d) * j + d * (1 # 2)). assert (0 <= (1 - d) * j) by (apply Qmult_le_0_compat; lra).
      assert (0 <= (1 - d) * (1 - j)) by (apply Qmult_le_0_compat; lra). split; [lra |].
      unfold u, moved_along, middle, minus. cbn [vx vy]. rewrite X, Y. split; field. }
    apply (inside_of_boundary_is_not_inner k _ K inside_), interiors_meet_means_inner_point.
    apply common_point_means_common_inner_point; trivial.
    apply (on_boundary_is_in_the_sum k); [exact K | now apply strictly_inside_lies_on].
  Qed.

  Hypothesis reduced_is_long : forall t, In t reduced_ -> nonzero (along t).

  Lemma boundary_meets_pieces_along (e : segment) : In e (pieces_of reduced_) -> met_only_along boundary_of_the_sum e.
  Proof.
    intros E w k inside_ K on. pose proof (pieces_are_pieces reduced_ reduced_is_long) as pieces_.
    destruct (Qeq_dec (cross (along e) (along k)) 0) as [parallel | across].
    { apply (collinear_by_direction e k w); trivial. now apply strictly_inside_lies_on. }
    exfalso. pose proof on as (j & range & X & Y).
    set (others := filter (fun r => negb (is_on_segment w r)) reduced_).
    assert (free : off w others).
    { intros r I. apply filter_In in I. destruct I as [_ I]. destruct (is_on_spec w r); [discriminate | assumption]. }
    destruct (off_near w others free) as (radius & R & near).
    assert (way : exists c u, 0 < c /\ (u = along k \/ u = opposite (along k)) /\
      forall d, 0 < d -> d < c -> lies_on (moved_along w u d) k).
    { destruct (Qlt_le_dec j 1) as [less | all].
      - exists (1 - j), (along k). split; [lra |]. split; [now left |]. intros d some small. exists (j + d).
        unfold moved_along, along, minus. cbn [vx vy]. rewrite X, Y. split; [lra |]. split; ring.
      - exists 1, (opposite (along k)). split; [lra |]. split; [now right |]. intros d some small. exists (j - d).
        unfold moved_along, opposite, along, minus. cbn [vx vy]. rewrite X, Y. split; [lra |]. split; ring. }
    destruct way as (c & u & c_some & u_is & way).
    destruct (small_steps_stay_within radius w u R) as (limit & L & close).
    set (d := (1 # 2) * (if Qlt_le_dec limit c then limit else c)).
    assert (d_range : 0 < d /\ d < limit /\ d < c) by (unfold d; destruct (Qlt_le_dec limit c); lra).
    clearbody d. specialize (close d ltac:(lra) ltac:(lra)). specialize (way d ltac:(lra) ltac:(lra)).
    destruct (boundary_is_on_the_reduced_convolution k _ K way) as (r & I & on_r).
    destruct (is_on_spec w r) as [w_on_r | w_off_r].
    - pose proof (pieces_are_met_along _ _ pieces_ e E w r inside_ I w_on_r) as collinear_.
      pose proof (area_of_collinear e r _ collinear_ on_r) as zero_1.
      pose proof (area_of_collinear e r _ collinear_ w_on_r) as zero_2.
      assert (product : d * cross (along e) (along k) == 0).
      { destruct u_is as [-> | ->]; unfold area, moved_along, opposite, cross, along, minus in *;
          cbn [vx vy] in *; lra. }
      destruct (Qmult_integral _ _ product); [lra | contradiction].
    - refine (near _ close r _ on_r). apply filter_In. split; [exact I |].
      destruct (is_on_spec w r); [contradiction | reflexivity].
  Qed.

  Hypothesis p_simple : nowhere_above_one p.
  Hypothesis q_simple : nowhere_above_one q.

  (* Theorem. The collision test returns whether the sum is to the right. *)
  Theorem collides_to_the_right_is (e s : segment) : In e (pieces_of reduced_) -> s = e \/ s = reversed e ->
    collides_to_the_right p q s = (0 <? winding_number_shifted (right_of_middle s) boundary_of_the_sum)%Z.
  Proof.
    intros E which. pose proof (pieces_are_pieces reduced_ reduced_is_long) as pieces_.
    assert (long : nonzero (along s)).
    { pose proof (pieces_are_long _ _ pieces_ e E) as long. destruct which as [-> | ->]; [exact long |].
      exact (long_of_one_place _ _ (reversed_place e) long). }
    assert (only : met_only_along reduced_ s).
    { pose proof (pieces_are_met_along _ _ pieces_ e E) as only. destruct which as [-> | ->]; [exact only |].
      now apply met_only_along_reversed. }
    assert (only_boundary : met_only_along boundary_of_the_sum s).
    { pose proof (boundary_meets_pieces_along e E) as along_. destruct which as [-> | ->]; [exact along_ |].
      now apply met_only_along_reversed. }
    set (m := middle s). set (n := to_the_right s). set (far := half_way m n reduced_).
    assert (far_some : 0 < far) by apply half_way_is.
    destruct (to_the_right_of_a_piece boundary_of_the_sum s boundary_is_closed only_boundary long m n
      (middle_is_inside s) (right_normal s long)) as (limit & L & near).
    set (d := (1 # 2) * (if Qlt_le_dec limit far then limit else far)).
    assert (d_range : 0 < d /\ d < limit /\ d < far) by (unfold d; destruct (Qlt_le_dec limit far); lra).
    clearbody d. rewrite <- (near d) by lra.
    assert (way_is_free : forall w, lies_on w (Segment (moved_along m n d) (just_right_of reduced_ s)) ->
      off w boundary_of_the_sum).
    { intros w (k & range & X & Y) t T on_t.
      destruct (boundary_is_on_the_reduced_convolution t w T on_t) as (r & I & on_r).
      assert (0 <= k * (far - d)) by (apply Qmult_le_0_compat; lra).
      assert (0 <= (1 - k) * (far - d)) by (apply Qmult_le_0_compat; lra).
      refine (nothing_just_right reduced_ s long only (d + k * (far - d)) _ _ r I _); [lra | |].
      { fold m n far. lra. }
      apply (lies_on_equal w); [| exact on_r]. unfold just_right_of, moved_along in *. fold m n in X, Y |- *.
      fold far in X, Y. cbn [source target vx vy] in *. unfold equal_vectors. cbn [vx vy]. rewrite X, Y. split; ring. }
    pose proof (winding_number_along _ boundary_of_the_sum boundary_is_closed way_is_free) as same_number.
    cbn [source target] in same_number. rewrite same_number. clear way_is_free same_number near.
    set (x := just_right_of reduced_ s).
    assert (free : off x reduced_) by (now apply just_right_of_is_off).
    unfold collides_to_the_right. fold reduced_. fold x.
    pose proof (collide_decides_whether_interiors_meet p q x p_region q_region p_simple q_simple) as decided.
    pose proof (boundary_goes_round_the_sum x free) as goes_round.
    destruct (Z.ltb_spec 0 (winding_number x boundary_of_the_sum)) as [positive_ | none].
    - apply decided, goes_round. rewrite boundary_goes_round in *. destruct (0 <? _)%Z; lia.
    - apply not_true_iff_false. intros hit. apply decided, goes_round in hit. lia.
  Qed.
End ValidRegions.
