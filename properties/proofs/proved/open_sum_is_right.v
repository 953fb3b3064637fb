(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* What open_sum_program.v returns is the open sum, for any chains of the closed sum of which every point is beside
   the outside. An inner point of the sum that is on no sum of a vertex and an edge is in the open sum by Theorem
   4.2.1; one that is, and is not in the open sum, is an end of a piece or inside one, along which the interiors meet
   nowhere (open_along_a_piece.v). *)
From Coq Require Import QArith Qminmax Lqa ZArith Lia Bool List.
From Oplus Require Import regions_and_sums reflected observation_2_2_4 right_of_an_edge theorem_2_2_10 theorem_2_2_6
  lemma_2_2_2 boundary_points location naive_collision met_pieces specification_bridge collision_is_sound
  collision_is_complete placed_collision beside_a_piece filling kept_pieces_go_round cut_pieces coordinates contacts
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
  (* The chains of the closed sum, all of them beside the outside. *)
  Hypothesis sum_is : forall x,
    (exists s, In s (region_edges sum_) /\ lies_on x s) \/ winding_number x (region_edges sum_) <> 0%Z <-> in_sum x p q.
  Hypothesis sum_is_bounded : forall x s radius, In s (region_edges sum_) -> lies_on x s -> 0 < radius ->
    exists y, within radius x y /\ ~ in_sum y p q.

  Let convolution_ := convolution_segments p q.
  Let dangling := dangling_among p q (touching_pieces p q) (region_edges sum_).
  Let isolated := isolated_among p q (touching_pieces p q) (region_edges sum_) dangling.

  Lemma convolution_is_closed_ : cycles convolution_.
  Proof. apply convolution_is_closed; [apply p_region | apply q_region]. Qed.

  (* Where all points near are in the sum, the winding number is positive. *)
  Lemma inner_points_are_gone_round (x : vector) : inner_point_of_sum x p q -> (0 < winding_number x convolution_)%Z.
  Proof.
    intros (radius & R & near).
    destruct (some_small _ (eventually_and _ _ (shifted_off_all x convolution_)
      (eventually_and _ _ (same_beside x convolution_) (shifted_stays_within radius x R))))
      as (e & _ & free & same_number & close).
    rewrite <- same_number. apply positive_winding_number_iff_common_point; trivial. now apply near.
  Qed.

  (* Inside the chains are the inner points of the sum. *)
  Definition is_gone_round (x : vector) : Prop :=
    off x (region_edges sum_) /\ winding_number x (region_edges sum_) <> 0%Z.

  Lemma all_near_are_inner (x : vector) : is_gone_round x ->
    exists radius, 0 < radius /\ forall y, within radius x y -> inner_point_of_sum y p q.
  Proof.
    intros [free round]. destruct (winding_number_near x _ (region_cycles sum_) free) as (radius & R & near).
    exists ((1 # 2) * radius). split; [lra |]. intros y close. exists ((1 # 2) * radius). split; [lra |].
    intros z close_z. apply sum_is. right.
    destruct (near z) as [_ same_number]; [unfold within in *; lra |]. now rewrite same_number.
  Qed.

  Lemma inner_points_are_off (x : vector) : inner_point_of_sum x p q -> is_gone_round x.
  Proof.
    intros (radius & R & near). assert (free : off x (region_edges sum_)).
    { intros s S on. destruct (sum_is_bounded x s radius S on R) as (y & close & out). exact (out (near y close)). }
    split; [exact free |]. destruct (proj2 (sum_is x)) as [(s & S & on) | round];
      [now apply near, within_of_equal | now destruct (free s S) | exact round].
  Qed.

  Lemma pieces_are_met_along_only (e : segment) : In e (touching_pieces p q) -> met_only_along convolution_ e.
  Proof.
    intros E w t inside_ T on.
    destruct (touching_piece_is p q p_region q_region e E) as (s & piece & S & I & place_ & long & part & _).
    destruct (convolution_segment_is_listed p q t T) as (u & U & same_source & same_target).
    apply (strictly_inside_of_one_place _ _ _ place_) in inside_.
    assert (on_u : lies_on w u).
    { destruct t, u. apply (lies_on_of_equal w w _ _ _ _ (reflexivity w) same_source same_target on). }
    destruct (nothing_meets_a_piece s _ piece u w long I inside_ U) as (_ & _ & parallel). specialize (parallel on_u).
    apply (collinear_of_one_place e piece t place_).
    apply (collinear_by_direction piece t w); [now apply strictly_inside_lies_on | exact on |].
    destruct (part_is_long piece s part long) as (_ & c & _ & cx & cy).
    assert (same : equal_vectors (along t) (along u)) by (clear - same_source same_target; by_computing).
    destruct same as [along_x along_y]. unfold cross in *. by_equations.
  Qed.

  (* On both sides of a piece is the sum. *)
  Lemma sides_are_inside (s : segment) (w : vector) : met_only_along convolution_ s -> nonzero (along s) ->
    strictly_inside w s -> is_gone_round w -> (0 < winding_number_shifted (right_of_middle s) convolution_)%Z.
  Proof.
    intros only long inside_ gone. destruct (all_near_are_inner w gone) as (radius & R & near).
    set (n := Vector (vy (along s)) (- vx (along s))).
    assert (right_ : cross (along s) n < 0)
      by (pose proof (rotation.square_positive _ long); unfold n, cross, dot in *; cbn [vx vy] in *; lra).
    destruct (some_small _ (eventually_and _ _ (small_steps_stay_within radius w n R)
      (to_the_right_of_a_piece convolution_ s convolution_is_closed_ only long w n inside_ right_)))
      as (e & _ & close & same_number).
    rewrite <- same_number. now apply inner_points_are_gone_round, near.
  Qed.

  Lemma meets_at (x : vector) : interiors_meet_at p q x = true <-> interiors_meet x p q.
  Proof. now apply collide_decides_whether_interiors_meet. Qed.

  Lemma crossing_means_meeting (x : vector) : pieces_cross_at (boundary_pieces p) (boundary_pieces q) x = true ->
    interiors_meet x p q.
  Proof.
    intros crossing_. apply existsb_exists in crossing_. destruct crossing_ as (s & S & crossing_).
    apply existsb_exists in crossing_. destruct crossing_ as (t' & T & crossing_). apply in_map_iff in T.
    destruct T as (t & <- & T).
    apply meet_inside_placed, (edges_that_cross_show p (placed x q) p_region (placed_is_valid x q q_region)).
    destruct (boundary_piece_runs p s (proj1 p_region) S) as (e & e_is).
    destruct (boundary_piece_runs q t (proj1 q_region) T) as (f & f_is).
    exact (crossing_parts _ _ s (reflected x t) e (reflected x f) e_is (runs_inside_reflected x q t f f_is) crossing_).
  Qed.

  Lemma left_out_is (v : vector) :
    is_left_out p q (boundary_pieces p) (boundary_pieces q) (region_edges sum_) v = true <->
    is_gone_round v /\ ~ interiors_meet v p q.
  Proof.
    unfold is_left_out, is_gone_round. rewrite off_is.
    destruct (is_on_one_spec v (region_edges sum_)); [intuition discriminate |].
    destruct (Z.eqb_spec (winding_number v (region_edges sum_)) 0); [intuition discriminate |].
    destruct (pieces_cross_at _ _ v) eqn:crossing_;
      [apply crossing_means_meeting in crossing_; intuition discriminate |].
    rewrite negb_true_iff, <- not_true_iff_false, meets_at. tauto.
  Qed.

  Lemma dangling_is (e : segment) : In e dangling <->
    In e (touching_pieces p q) /\ is_gone_round (middle e) /\ ~ interiors_meet (middle e) p q.
  Proof. unfold dangling, dangling_among. now rewrite nodup_In, filter_In, left_out_is. Qed.

  Lemma isolated_is (w : vector) : In w isolated <->
    In w (flat_map (fun e => [source e; target e]) (touching_pieces p q) ++ vertex_sums p q) /\
    off w dangling /\ is_gone_round w /\ ~ interiors_meet w p q.
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

  (* All along a piece are inner points of the sum, if one is. *)
  Lemma inner_all_along (e : segment) (x : vector) : In e (touching_pieces p q) -> strictly_inside x e ->
    is_gone_round x -> inner_point_of_sum (middle e) p q.
  Proof.
    intros E inside_ gone.
    destruct (touching_piece_is p q p_region q_region e E) as (s & piece & S & I & place_ & long_s & part & long_e).
    pose proof (pieces_are_met_along_only e E) as only.
    pose proof (met_only_along_reversed _ _ only) as only_back.
    pose proof (long_of_one_place _ _ (reversed_place e) long_e) as long_back.
    pose proof (sides_are_inside e x only long_e inside_ gone) as right_.
    pose proof (sides_are_inside _ x only_back long_back (strictly_inside_reversed x e inside_) gone) as left_.
    destruct (value_to_the_right_of_the_middle convolution_ e convolution_is_closed_ only long_e)
      as (r1 & R1 & value_1).
    destruct (value_to_the_right_of_the_middle convolution_ _ convolution_is_closed_ only_back long_back)
      as (r2 & R2 & value_2).
    destruct (on_its_edge_near e (middle e)) as (r3 & R3 & on_e).
    { pose proof (rotation.square_positive _ long_e). to_coordinates. lra. }
    exists (Qmin r1 (Qmin r2 r3)). split; [repeat apply Q.min_glb_lt; assumption |]. intros y close.
    pose proof (Q.le_min_l r1 (Qmin r2 r3)). pose proof (Q.le_min_r r1 (Qmin r2 r3)).
    pose proof (Q.le_min_l r2 r3). pose proof (Q.le_min_r r2 r3). set (r := Qmin r1 (Qmin r2 r3)) in *. clearbody r.
    pose proof p_region as (p_edges & p_valid & _). pose proof q_region as (q_edges & q_valid & _).
    destruct (Q_dec (area e y) 0) as [[low | high] | flat].
    - apply positive_winding_number_is_in_the_sum; trivial. fold convolution_.
      rewrite (value_1 y); [exact right_ | | exact low]. clear - close H. by_computing.
    - apply positive_winding_number_is_in_the_sum; trivial. fold convolution_.
      rewrite (value_2 y); [exact left_ | | rewrite area_reversed; lra]. clear - close H0 H1. by_computing.
    - apply vertex_edge_sums_are_in_the_sum, on_listed_is. exists s. split; [exact S |].
      apply (part_lies_on piece s y long_s part), (lies_on_of_one_place _ _ y place_), on_e; [| exact flat].
      clear - close H0 H2. by_computing.
  Qed.

  Theorem open_sum_has (x : vector) :
    (winding_number x (region_edges sum_) <> 0%Z /\ off x (region_edges sum_)) /\
      off x dangling /\ (forall v, In v isolated -> ~ equal_vectors x v) <->
    interiors_meet x p q.
  Proof.
    split.
    - intros ((round & free) & free_d & not_isolated). assert (gone : is_gone_round x) by now split.
      destruct (interiors_meet_at p q x) eqn:met; [now apply meets_at | exfalso].
      assert (outside : ~ interiors_meet x p q) by (rewrite <- meets_at; congruence).
      assert (alone : forall w, equal_vectors x w ->
        ~ In w (flat_map (fun e => [source e; target e]) (touching_pieces p q) ++ vertex_sums p q)).
      { intros w equal W. apply (not_isolated w); [| exact equal]. apply isolated_is. split; [exact W |].
        split; [now apply (off_equal x) |]. split.
        - destruct equal as [X Y]. split; [now apply (off_equal x) |].
          now rewrite <- (winding_number_of_equal _ _ _ X Y).
        - intros meet. apply outside. now apply (interiors_meet_of_equal p q w). }
      destruct (all_near_are_inner x gone) as (radius & R & near).
      assert (inner : inner_point_of_sum x p q) by now apply near, within_of_equal.
      destruct (on_or_off x (all_vertex_edge_segments p q)) as [(t & T & on) | general].
      + destruct (not_meeting_is_on_a_piece p q p_region q_region p_simple q_simple x t T on outside)
          as [(w & W & equal) | (e & E & on_e)].
        * apply (alone w equal), in_app_iff. now right.
        * assert (ends : forall w, In w [source e; target e] -> ~ equal_vectors w x).
          { intros w W equal. apply (alone w (symmetry equal)), in_app_iff. left. apply in_flat_map. now exists e. }
          destruct (inside_or_end x e on_e) as [inside_ | [equal | equal]];
            [| apply (ends (source e)); cbn; tauto | apply (ends (target e)); cbn; tauto].
          apply (free_d e); [| exact on_e]. apply dangling_is. split; [exact E |].
          split; [now apply inner_points_are_off, (inner_all_along e x) |]. intros meet. apply outside.
          apply (meeting_is_the_same_along_a_piece p q p_region q_region p_simple q_simple e (middle e)); trivial.
          apply middle_is_inside.
      + apply off_listed_is in general. apply outside, positive_winding_number_iff_interiors_meet; trivial.
        now apply inner_points_are_gone_round.
    - intros meet_x. pose proof (interiors_meet_means_inner_point p q x meet_x) as inner.
      apply inner_points_are_off in inner. destruct inner. split; [now split |].
      split; [intros e E; now apply open_points_are_on_no_dangling_edge |].
      intros v V equal. apply isolated_is in V. now apply V, (interiors_meet_of_equal p q x).
  Qed.
End OpenSum.
