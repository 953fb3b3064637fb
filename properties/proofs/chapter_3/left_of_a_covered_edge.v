(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* P and -Q + x touch, at w of P and u of Q, and their interiors do not meet; x is moved a little, by alpha + beta, so
   that w + alpha is inside P and u + beta inside Q. Then an edge at the contact has this step to its left, and is met
   there by the other region (right_one_of_two_edges.v): so a segment of the convolution covers x that has the step to
   its left. Say beta is to the left of alpha. Between beta and -alpha, Q ends, by an edge b that comes to u; between b
   and alpha P begins, by an edge a that leaves w. If Q has a not in a tangent set, the pass of b goes on between b and
   a, to the right of a. Chains may touch, but not cross. *)
From Coq Require Import ZArith Lia Bool List.
From Oplus Require Import numbers convolution signed_crossings tie_rule convolution_winding regions weight finite_sums
  tangent_count meeting_of_segments neighbourhoods winding_number_of_the_sum interiors_meet left_of_an_edge
  theorem_4_2_1 simple_chain boundary_points inside_a_corner tangent_direction reduced_convolution edges_at_a_point
  fan_at_a_point fans_that_touch edges_that_pass reduced_edges_that_pass chains_that_do_not_cross
  right_one_of_two_edges.
Import ListNotations.

Open Scope Q_scope.

(* An edge of P through x has the step n to its left, and Q meets it: by an edge or in a tangent set. *)
Definition met_to_the_right (p q : region) (x n : vector) (label : summand) : Prop :=
  exists w u e, equal_vectors x (plus w u) /\ In e (region_edges p) /\ lies_on w e /\
    meets_direction q u label (along e) /\ 0 < cross (along e) n.

Lemma covered_to_the_right (p q : region) (x n : vector) : valid_region p -> valid_region q ->
  met_to_the_right p q x n OfP \/ met_to_the_right q p x n OfQ ->
  exists s, In s (convolution_segments p q) /\ lies_on x s /\ 0 < cross (along s) n.
Proof.
  intros p_region q_region met_.
  assert (covered : exists d, covered_along p q x d /\ 0 < cross d n).
  { destruct met_ as
     [(w & u & e & sum_ & E & on & [(f & F & on_f & same_) | (chain & j & C & J & at_ & tangent)] & left_) |
      (u & w & f & sum_ & F & on & [(e & E & on_e & same_) | (chain & i & C & I & at_ & tangent)] & left_)];
      [exists (along e) | exists (along e) | exists (along f) | exists (along f)]; (split; [| exact left_]).
    - destruct (common_direction_is_a_tie p q x w u p_region q_region sum_ e f E F on on_f same_)
        as (a & b & A & B & tie).
      apply (tie_is_covered p q x p_region q_region a b); trivial.
      now apply (region_edges_are_directions p (proj1 p_region)).
    - now apply (tangent_of_p_is_covered p q x w u sum_ e chain j).
    - apply sum_in_other_order in sum_. apply (covered_in_the_same_direction _ x (along e));
        [now apply same_direction_symmetric |]. apply same_direction_symmetric in same_.
      destruct (common_direction_is_a_tie p q x w u p_region q_region sum_ e f E F on_e on same_)
        as (a & b & A & B & tie).
      apply (tie_is_covered p q x p_region q_region a b); trivial.
      now apply (region_edges_are_directions p (proj1 p_region)).
    - apply sum_in_other_order in sum_. now apply (tangent_of_q_is_covered p q x w u sum_ f chain i). }
  destruct covered as (d & (s & S & on & (a & some & X & Y)) & left_). exists s. split; [exact S |].
  split; [exact on |]. assert (value : cross (along s) n == a * cross d n) by (unfold cross; rewrite X, Y; ring).
  rewrite value. now apply Qmult_lt_0_compat.
Qed.

Section Contact.
  Variables p q : region.
  Variables x w u alpha beta : vector.
  Variable label : summand.
  Variables radius_p radius_q : Q.
  Hypothesis p_region : valid_region p.
  Hypothesis q_region : valid_region q.
  Hypothesis p_crosses_nowhere : chains_do_not_cross p.
  Hypothesis q_crosses_nowhere : chains_do_not_cross q.
  Hypothesis outside : ~ interiors_meet x p q.
  Hypothesis sum_ : equal_vectors x (plus w u).
  Hypothesis near_p : nothing_else_near w radius_p p.
  Hypothesis near_q : nothing_else_near u radius_q q.
  Hypothesis close_p : within radius_p w (plus w alpha).
  Hypothesis close_q : within radius_q u (plus u beta).
  Hypothesis close_back : within radius_q u (plus u (opposite alpha)).
  Hypothesis in_p : inside (plus w alpha) p.
  Hypothesis in_q : inside (plus u beta) q.
  Hypothesis turn : 0 < cross alpha beta.

  Let p_edges : no_edges_are_points p := proj1 p_region.
  Let q_edges : no_edges_are_points q := proj1 q_region.
  Let outside' : ~ interiors_meet x q p.
  Proof. intros meet_. apply outside. now apply interiors_meet_other_way. Qed.

  Lemma regular (r : region) : valid_region r -> is_regular r.
  Proof. intros (points & valid & meet). now apply regions_are_regular. Qed.

  Lemma nothing_there (v : vector) : equal_vectors x (plus (plus w alpha) v) ->
    off v (region_edges q) /\ winding_number v (region_edges q) = 0%Z.
  Proof.
    intros equal. assert (free : ~ in_region v q).
    { intros there. apply outside. exact (inner_point_and_point p q x _ v (regular q q_region) in_p there equal). }
    assert (free' : off v (region_edges q)) by (intros f F on; apply free; right; now exists f).
    split; [exact free' |]. pose proof (proj1 (proj2 q_region) v free') as not_negative.
    destruct (Z.eq_dec (winding_number v (region_edges q)) 0) as [| some_]; [assumption |]. destruct free. left.
    unfold in_region. lia.
  Qed.

  Let n := plus alpha beta.
  Let result := met_to_the_right p q x n label \/ met_to_the_right q p x n (other label).

  (* Where the edge b of Q, which comes to u, leads in P: nothing, or P goes along b. *)
  Lemma nothing_ahead (b : segment) : In b (region_edges q) -> arrives u b = true ->
    (exists s, In s (region_edges p) /\ lies_on w s /\ same_direction (along b) (along s)) \/
    eventually (fun k => off (plus w (scaled_by k (along b))) (region_edges p) /\
      winding_number (plus w (scaled_by k (along b))) (region_edges p) = 0%Z).
  Proof.
    intros B there. pose proof (region_edges_are_directions q q_edges b B) as long_b. set (D := along b) in *.
    destruct (one_or_all (exists s, In s (region_edges p) /\ lies_on w s /\ same_direction D (along s))
      (fun s => lies_on w s -> ~ same_direction D (along s)) (region_edges p)) as [| none]; [| now left | right].
    { intros s S. destruct (lies_on_dec w s) as [on |]; [| now right].
      pose proof (region_edges_are_directions p p_edges s S) as long_s. rewrite same_direction_angle by trivial.
      destruct (Qeq_dec (angle.angle D) (angle.angle (along s))) as [same_ | different]; [left | now right].
      exists s. split; [exact S |]. split; [exact on |]. now apply same_direction_angle. }
    refine (eventually_implied _ _ _ (eventually_and _ _ (comes_from_behind u b there) (eventually_and _ _
      (small_steps_stay_within radius_p w D (proj1 near_p)) (eventually_and _ _ (leaves_all_vertices p w D long_b)
      (eventually_below 1 ltac:(lra)))))).
    intros k (on_b & close & no_vertex & some & _). set (y := plus w (scaled_by k D)) in *. fold D in on_b.
    assert (y_is : equal_vectors (moved_along w D k) y)
      by (unfold y, moved_along, plus, scaled_by; split; cbn [vx vy]; ring).
    assert (y_sum : equal_vectors x (plus y (moved_along u (opposite D) k))).
    { destruct sum_ as [X Y]. unfold y, plus, scaled_by, moved_along, opposite in *. cbn [vx vy] in *.
      split; cbn [vx vy]; lra. }
    assert (free : off y (region_edges p)).
    { intros s S on. destruct (proj2 near_p s) as [on_w | away].
      { apply in_flat_map. exists s. split; [exact S | now left]. }
      2: { apply (away _ close). apply (lies_on_equal y); [now symmetry | exact on]. }
      pose proof (region_edges_are_directions p p_edges s S) as long_s. pose proof on as on'. unfold y in on'.
      destruct (ahead_or_behind w _ s on_w on') as (m & X & Y & _). unfold scaled_by in X, Y. cbn [vx vy] in X, Y.
      destruct (Q_dec m 0) as [[low | high] | zero_].
      - apply outside, (opposite_edge_meets p q x y (moved_along u (opposite D) k) (along s) b); trivial.
        + now apply fills_left_beside_an_edge.
        + fold D. exists (k / - m). split; [apply Qlt_shift_div_l; lra |]. unfold opposite. cbn [vx vy].
          assert (value : forall v, k / - m * - v == / m * (k * v)) by (intros v; field; lra).
          rewrite !value, X, Y. split; field; lra.
      - apply (none s S on_w). exists (m / k). split; [apply Qlt_shift_div_l; lra |].
        assert (value : forall v, m / k * v == / k * (m * v)) by (intros v; field; lra).
        rewrite !value, <- X, <- Y. split; field; lra.
      - apply long_b. rewrite zero_ in X, Y. split; apply (Qmult_inj_l _ _ k); lra. }
    split; [exact free |]. pose proof (proj1 (proj2 p_region) _ free) as not_negative.
    destruct (Z.eq_dec (winding_number y (region_edges p)) 0) as [| some_]; [assumption | exfalso].
    apply outside, (inner_point_and_point p q x y (moved_along u (opposite D) k) (regular q q_region));
      [split; [exact free | lia] | right; now exists b | exact y_sum].
  Qed.

  (* Theorem. *)
  Theorem left_of_a_met_edge : result.
  Proof.
    destruct (nothing_there (plus u (opposite alpha))) as [free none].
    { destruct sum_ as [X Y]. unfold plus, opposite in *. cbn [vx vy] in *. split; cbn [vx vy]; lra. }
    destruct in_q as [free_q round_q], in_p as [free_p round_p].
    destruct (arrives_between q u beta (opposite alpha) radius_q) as (b & B & there & amid_b); trivial.
    { unfold cross, opposite in *. cbn [vx vy]. lra. }
    { lia. }
    destruct (is_amid_spec beta (opposite alpha) (opposite (along b))) as [[after_ before_] |]; [| discriminate].
    set (D := along b) in *.
    assert (b_alpha : 0 < cross D alpha) by (clear - before_; unfold cross, opposite in *; cbn [vx vy] in *; lra).
    assert (b_beta : 0 < cross D beta) by (clear - after_; unfold cross, opposite in *; cbn [vx vy] in *; lra).
    assert (to_n : forall d, cross d n == cross d alpha + cross d beta)
      by (intros d; unfold n, cross, plus; cbn [vx vy]; ring).
    assert (b_n : 0 < cross D n) by (rewrite to_n; lra). clear after_ before_ amid_b.
    assert (on_b : lies_on u b) by (now apply arrives_is in there).
    destruct (nothing_ahead b B there) as [(s & S & on_s & same_) | nothing].
    { right. exists u, w, b. split; [now apply sum_in_other_order |]. split; [exact B |]. split; [exact on_b |].
      split; [left; now exists s | exact b_n]. }
    fold D in nothing. pose proof (proj1 near_p) as R.
    destruct (some_small _ (eventually_and _ _ nothing (small_steps_stay_within radius_p w D R)))
      as (k & some & (free_k & none_k) & close_k).
    destruct (departs_between p w (scaled_by k D) alpha radius_p) as (a & A & leaves & amid_a); trivial.
    { assert (value : cross (scaled_by k D) alpha == k * cross D alpha)
        by (unfold cross, scaled_by; cbn [vx vy]; ring). rewrite value. now apply Qmult_lt_0_compat. }
    { lia. }
    destruct (is_amid_spec (scaled_by k D) alpha (along a)) as [[after_ a_alpha] |]; [| discriminate].
    assert (b_a : 0 < cross D (along a)).
    { assert (value : cross (scaled_by k D) (along a) == k * cross D (along a))
        by (unfold cross, scaled_by; cbn [vx vy]; ring).
      rewrite value in after_. apply Qnot_le_lt. intros not_. nra. }
    clear after_ amid_a free_k none_k close_k nothing. set (E := along a) in *.
    assert (a_n : 0 < cross E n).
    { rewrite to_n. enough (0 < cross E beta) by lra.
      assert (value : cross D alpha * cross E beta == cross E alpha * cross D beta + cross D E * cross alpha beta)
        by (unfold cross; ring).
      assert (0 < cross E alpha * cross D beta) by now apply Qmult_lt_0_compat.
      assert (0 < cross D E * cross alpha beta) by now apply Qmult_lt_0_compat.
      apply Qnot_le_lt. intros not_. nra. }
    assert (on_a : lies_on w a) by (now apply departs_is in leaves).
    destruct (pass_of_arriving q u b B there) as (g & pass). fold D in pass.
    assert (long_a : nonzero E) by (now apply (region_edges_are_directions p)).
    destruct (beside_a_pass q u label q_region E D g long_a pass) as [met_ | [_ beside_]].
    - left. exists w, u, a. split; [exact sum_ |]. split; [exact A |]. split; [exact on_a |]. now split.
    - destruct (beside_ b_a) as [g_a b_g]. clear beside_. right.
      destruct (edges_of_a_pass q q_edges u D g pass) as [_ (t & T & t_leaves & t_along)].
      exists u, w, t. split; [now apply sum_in_other_order |]. split; [exact T |].
      split; [now apply departs_is in t_leaves |]. split.
      + apply (right_one_is_met q p x u w (other label) q_region p_region outside' (sum_in_other_order _ _ _ sum_) t T
          t_leaves p_crosses_nowhere a A leaves). now rewrite t_along.
      + rewrite t_along. assert (value : cross D E * cross g n == cross g E * cross D n + cross D g * cross E n)
          by (unfold cross; ring).
        assert (0 < cross g E * cross D n) by now apply Qmult_lt_0_compat.
        assert (0 <= cross D g * cross E n) by (apply Qmult_le_0_compat; lra).
        apply Qnot_le_lt. intros not_. nra.
  Qed.
End Contact.
