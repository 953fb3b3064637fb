(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* What open_sum_program.v returns is the open sum, for any chains of the closed sum that are a valid region. An inner
   point of the sum that is on no sum of a vertex and an edge is in the open sum by Theorem 4.2.1; one that is, and is
   not in the open sum, is an end of a piece or inside one, along which the interiors meet nowhere
   (open_along_a_piece.v). *)
From Coq Require Import QArith Qminmax Lqa Qfield ZArith Lia Bool List.
From Oplus Require Import regions_and_sums reflected observation_2_2_4 right_of_an_edge theorem_2_2_10 theorem_2_2_6
  lemma_2_2_2 boundary_points fans_that_touch location pieces naive_collision met_pieces specification_bridge
  collision_is_complete placed_collision filling cut_pieces sum_is_right sum_of_uncovered_pieces coordinates
  contacts_that_stay open_sum_program open_along_a_piece.
Import ListNotations.

Open Scope Q_scope.

(* A segment of the convolution is a sum of a vertex and an edge. *)
Lemma convolution_segment_is_listed (p q : region) (t : segment) : In t (convolution_segments p q) -> exists u,
  In u (all_vertex_edge_segments p q) /\ equal_vectors (source t) (source u) /\ equal_vectors (target t) (target u).
Proof.
  intros I. destruct (convolution_segment_is p q t I) as (a & b & i & j & in_p & in_q & i_below & j_below & t_is).
  pose proof (edge_at_in_region p a i in_p i_below) as E. pose proof (edge_at_in_region q b j in_q j_below) as F.
  destruct t_is as [-> | ->]; [exists (moved_segment (source (edge_at b j)) (edge_at a i)) |
    exists (moved_segment (source (edge_at a i)) (edge_at b j))];
    (split; [apply in_all | rewrite !edge_at_is by assumption; unfold moved_segment; split; by_computing]);
    [exists q, p, (edge_at b j), (edge_at a i) | exists p, q, (edge_at a i), (edge_at b j)]; unfold are_both; tauto.
Qed.

Section OpenSum.
  Variables p q sum_ : region.
  Hypotheses (p_region : valid_region p) (q_region : valid_region q).
  Hypotheses (p_simple : nowhere_above_one p) (q_simple : nowhere_above_one q).
  (* The chains of the closed sum. *)
  Hypotheses (sum_region : valid_region sum_) (sum_simple : nowhere_above_one sum_).
  Hypothesis sum_is : forall x, in_region x sum_ <-> in_sum x p q.
  Let convolution_ := convolution_segments p q.
  Let dangling := dangling_among p q (touching_pieces p q) (region_edges sum_).
  Let isolated := isolated_among p q (touching_pieces p q) (region_edges sum_) dangling.

  Lemma inside_is_inner (x : vector) : inside x sum_ <-> inner_point_of_sum x p q.
  Proof.
    split.
    - intros [free round]. destruct (winding_number_near x _ (region_cycles sum_) free) as (radius & R & near).
      exists radius. split; [exact R |]. intros y close. apply sum_is. left. now rewrite (proj2 (near y close)).
    - intros (radius & R & near). assert (free : off x (region_edges sum_)).
      { intros s S on. destruct (outside_is_near sum_ x s radius sum_region sum_simple S on R)
          as (y & close & off_y & none).
        apply near, sum_is in close. destruct close as [round | (t & T & on_t)]; [lia | exact (off_y t T on_t)]. }
      split; [exact free |]. destruct (proj2 (sum_is x)) as [round | (s & S & on)];
        [| exact round | now destruct (free s S)].
      apply near. unfold within. lra.
  Qed.

  Lemma pieces_are_met_along_only (e : segment) : In e (touching_pieces p q) -> met_only_along convolution_ e.
  Proof.
    intros E w t inside_ T on.
    destruct (touching_piece_is p q p_region q_region e E) as (s & piece & S & I & place_ & long & _).
    destruct (convolution_segment_is_listed p q t T) as (u & U & same_source & same_target).
    apply (strictly_inside_of_one_place _ _ _ place_) in inside_.
    assert (on_u : lies_on w u).
    { destruct t, u. exact (lies_on_of_equal w w _ _ _ _ (reflexivity w) same_source same_target on). }
    apply (collinear_of_one_place e piece t place_).
    destruct (pieces_are_met_only_along s _ piece long I w u inside_ U on_u) as [line_1 line_2].
    destruct same_source, same_target. clear - line_1 line_2 H H0 H1 H2. unfold collinear. in_coordinates.
    split; by_equations.
  Qed.

  Lemma meets_at (x : vector) : interiors_meet_at p q x = true <-> interiors_meet x p q.
  Proof. now apply collide_decides_whether_interiors_meet. Qed.

  Lemma crossing_means_meeting (x : vector) : pieces_cross_at (boundary_pieces p) (boundary_pieces q) x = true ->
    interiors_meet x p q.
  Proof.
    intros (s & S & (t' & (t & <- & T)%in_map_iff & crossing_)%existsb_exists)%existsb_exists.
    destruct (crossing_point_is s (reflected x t) crossing_) as (in_s & (k & range & X & Y) & turn).
    set (w := crossing_point s (reflected x t)) in *. clearbody w.
    destruct (boundary_piece_is p s (proj1 p_region) S) as (e & E & long_e & s_part & p_free).
    destruct (boundary_piece_is q t (proj1 q_region) T) as (f & F & long_f & t_part & q_free).
    destruct (p_free w in_s) as [on_e not_p], (q_free (minus x w)) as [on_f not_q];
      [exists k; split; [exact range | by_computing] |].
    apply (transversal_edges_meet p q x w (minus x w) e f); trivial; [by_computing |]. intros parallel. apply turn.
    destruct (part_is_long s e s_part long_e) as (_ & c & _ & cx & cy).
    destruct (part_is_long t f t_part long_f) as (_ & d & _ & dx & dy).
    clear - parallel cx cy dx dy. to_coordinates. by_equations.
  Qed.

  Lemma left_out_is (v : vector) :
    is_left_out p q (boundary_pieces p) (boundary_pieces q) (region_edges sum_) v = true <->
    inside v sum_ /\ ~ interiors_meet v p q.
  Proof.
    unfold is_left_out, inside. pose proof (proj1 (proj2 sum_region) v) as not_negative. rewrite off_is in *.
    destruct (is_on_one_spec v (region_edges sum_)); [intuition discriminate |].
    destruct (Z.eqb_spec (winding_number v (region_edges sum_)) 0); [intuition (discriminate || lia) |].
    destruct (pieces_cross_at _ _ v) eqn:crossing_;
      [apply crossing_means_meeting in crossing_; intuition discriminate |].
    rewrite negb_true_iff, <- not_true_iff_false, meets_at. intuition lia.
  Qed.

  Lemma dangling_is (e : segment) : In e dangling <->
    In e (touching_pieces p q) /\ inside (middle e) sum_ /\ ~ interiors_meet (middle e) p q.
  Proof. unfold dangling, dangling_among. now rewrite nodup_In, filter_In, left_out_is. Qed.

  Lemma isolated_is (w : vector) : In w isolated <->
    In w (flat_map (fun e => [source e; target e]) (touching_pieces p q) ++ vertex_sums p q) /\
    off w dangling /\ inside w sum_ /\ ~ interiors_meet w p q.
  Proof.
    unfold isolated, isolated_among. rewrite nodup_In, filter_In, off_is, <- left_out_is.
    destruct (is_on_one_spec w dangling); intuition discriminate.
  Qed.

  (* All along a piece the interiors meet if they do at one of its points, also at an end. *)
  Lemma open_points_are_on_no_dangling_edge (x : vector) (e : segment) : interiors_meet x p q -> In e dangling ->
    ~ lies_on x e.
  Proof.
    intros meet_x E (k & range & X & Y). apply dangling_is in E. destruct E as (E & _ & outside). apply outside.
    destruct (interiors_meet_all_near p q x meet_x) as (radius & R & near).
    destruct (some_small _ (eventually_and _ _ (small_steps_stay_within radius x (minus (middle e) x) R)
      (eventually_below 1 ltac:(reflexivity)))) as (t & _ & close & range_t).
    apply (meeting_is_the_same_along_a_piece p q p_region q_region p_simple q_simple e
      (moved_along x (minus (middle e) x) t)); trivial; [| apply middle_is_inside | now apply near].
    exists ((1 - t) * k + t * (1 # 2)). split; [split; nra |]. clear - X Y. to_coordinates. rewrite X, Y. split; lra.
  Qed.

  (* All along a piece are inner points of the sum, if one is: on both sides the winding number is positive. *)
  Lemma inner_all_along (e : segment) (x : vector) : In e (touching_pieces p q) -> strictly_inside x e ->
    inside x sum_ -> inside (middle e) sum_.
  Proof.
    rewrite !inside_is_inner. intros E inside_ inner.
    destruct (touching_piece_is p q p_region q_region e E) as (s & piece & S & I & place_ & long_s & part & long).
    assert (beside : forall e', met_only_along convolution_ e' -> nonzero (along e') -> strictly_inside x e' ->
      strictly_inside (middle e) e' ->
      exists radius, 0 < radius /\ forall y, within radius (middle e) y -> area e' y < 0 -> in_sum y p q).
    { intros e' only long' in_x in_m. pose proof (positive_beside_inner_points p q p_region q_region e' x only long'
        in_x inner)
        as positive_. apply Z.ltb_lt in positive_.
      destruct (value_to_the_right_of_all _ e' (all_are_closed p q p_region q_region) only long' _ in_m)
        as (r & R & value).
      exists r. split; [exact R |]. intros y close right_. destruct p_region as (? & ? & _), q_region as (? & ? & _).
      apply positive_winding_number_is_in_the_sum; trivial. now rewrite (value y close right_). }
    pose proof (pieces_are_met_along_only e E) as only. pose proof (middle_is_inside e) as in_m.
    destruct (beside e only long inside_ in_m) as (r1 & R1 & right_).
    destruct (beside (reversed e)) as (r2 & R2 & left_);
      [now apply met_only_along_reversed | exact (long_of_one_place _ _ (reversed_place e) long) |
       now apply strictly_inside_reversed .. |].
    destruct (on_its_edge_near e (middle e)) as (r3 & R3 & on_e).
    { pose proof (rotation.square_positive _ long). to_coordinates. lra. }
    exists (Qmin r1 (Qmin r2 r3)). split; [repeat apply Q.min_glb_lt; assumption |]. intros y close.
    pose proof (within_smaller _ _ _ _ (Q.le_min_l r1 (Qmin r2 r3)) close) as close_1.
    apply (within_smaller _ _ _ _ (Q.le_min_r r1 (Qmin r2 r3))) in close.
    destruct (Q_dec (area e y) 0) as [[low | high] | flat]; [now apply right_ | |].
    - apply left_; [exact (within_smaller _ _ _ _ (Q.le_min_l r2 r3) close) | rewrite area_reversed; lra].
    - apply (within_smaller _ _ _ _ (Q.le_min_r r2 r3)) in close.
      apply vertex_edge_sums_are_in_the_sum, on_listed_is. exists s. split; [exact S |].
      exact (part_lies_on piece s y part (lies_on_of_one_place _ _ y place_ (on_e y close flat))).
  Qed.

  Theorem open_sum_has (x : vector) :
    inside x sum_ /\ off x dangling /\ (forall v, In v isolated -> ~ equal_vectors x v) <-> interiors_meet x p q.
  Proof.
    split.
    - intros (inside_x & free_d & not_isolated).
      destruct (interiors_meet_at p q x) eqn:met; [now apply meets_at | exfalso].
      assert (outside : ~ interiors_meet x p q) by (rewrite <- meets_at; congruence).
      assert (alone : forall w, equal_vectors x w ->
        ~ In w (flat_map (fun e => [source e; target e]) (touching_pieces p q) ++ vertex_sums p q)).
      { intros w equal W. apply (not_isolated w); [| exact equal]. apply isolated_is. split; [exact W |].
        split; [now apply (off_equal x) |]. split; [exact (inside_equal x w sum_ equal inside_x) |].
        intros meet. apply outside. now apply (interiors_meet_of_equal p q w). }
      destruct (on_or_off x (all_vertex_edge_segments p q)) as [(t & T & on) | general].
      + destruct (not_meeting_is_on_a_piece p q p_region q_region p_simple q_simple x t T on outside)
          as [(w & W & equal) | (e & E & on_e)].
        * apply (alone w equal), in_app_iff. now right.
        * assert (ends : forall w, In w [source e; target e] -> ~ equal_vectors w x).
          { intros w W equal. apply (alone w (symmetry equal)), in_app_iff. left. apply in_flat_map. now exists e. }
          destruct (inside_or_end x e on_e) as [inside_ | [equal | equal]];
            [| apply (ends (source e)); cbn; tauto | apply (ends (target e)); cbn; tauto].
          apply (free_d e); [| exact on_e]. apply dangling_is. split; [exact E |].
          split; [now apply (inner_all_along e x) |]. intros meet. apply outside.
          apply (meeting_is_the_same_along_a_piece p q p_region q_region p_simple q_simple e (middle e)); trivial.
          apply middle_is_inside.
      + apply outside, positive_winding_number_iff_common_inner_point; trivial.
        * intros t T on. destruct (convolution_segment_is_listed p q t T) as (u & U & same_source & same_target).
          apply (general u U). destruct t, u. exact (lies_on_of_equal x x _ _ _ _ (reflexivity x) same_source
            same_target on).
        * apply positive_at_inner_points; trivial. now apply inside_is_inner.
    - intros meet_x. split; [now apply inside_is_inner, interiors_meet_means_inner_point |].
      split; [intros e E; now apply open_points_are_on_no_dangling_edge |].
      intros v V equal. apply isolated_is in V. now apply V, (interiors_meet_of_equal p q x).
  Qed.
End OpenSum.
