(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Where P and -Q + x touch in a point, w of P and u of Q, and their interiors do not meet: of an edge a of P that
   leaves w and an edge b of Q that leaves u, the one to the right is covered by the convolution. Say b is to the left
   of a. If no pass of Q through u has a in its tangent set, the pass that goes on along b comes from an edge with a
   direction between a and b. Between b and -a, Q ends, since a, backwards in Q, is outside: there an edge h of Q comes
   in. The pass along h goes on between h and a. But then these two passes cross. *)
From Coq Require Import ZArith Lia Bool List.
From Oplus Require Import numbers convolution signed_crossings tie_rule convolution_winding regions weight finite_sums
  tangent_count meeting_of_segments neighbourhoods winding_number_of_the_sum interiors_meet left_of_an_edge
  theorem_4_2_1 simple_chain boundary_points inside_a_corner tangent_direction reduced_convolution edges_at_a_point
  fan_at_a_point fans_that_touch edges_that_pass reduced_edges_that_pass chains_that_do_not_cross.
Import ListNotations.

Open Scope Q_scope.

(* d is not in the tangent set of a corner, and has none of its directions. *)
Lemma beside_a_tangent_set (d f g : vector) (label : summand) : nonzero d -> turns f g ->
  in_tangent_set (Direction d label) (Corner f g) = false -> ~ same_direction d f -> ~ same_direction d g ->
  (0 < cross d g -> 0 < cross d f /\ 0 <= cross f g) /\ (0 < cross f d -> 0 < cross g d /\ 0 <= cross f g).
Proof.
  intros long_d (long_f & long_g & ahead) none not_f not_g. rewrite same_direction_angle in not_f, not_g by trivial.
  pose proof (cross_angle d f long_d long_f) as d_f. pose proof (cross_angle d g long_d long_g) as d_g.
  pose proof (cross_angle f g long_f long_g) as f_g. unfold turns_by in *.
  pose proof (angle_range d long_d). pose proof (angle_range f long_f). pose proof (angle_range g long_g).
  assert (back_f : cross f d == - cross d f) by (unfold cross; ring).
  assert (back_g : cross g d == - cross d g) by (unfold cross; ring).
  unfold in_tangent_set in none. cbn [of incoming outgoing] in none.
  destruct (ccw_spec (Direction d label) (Direction f (other label)) (Direction g (other label)) long_d long_f long_g)
    as [| not_between]; [discriminate |].
  unfold in_order, earlier in not_between. cbn [vec] in not_between.
  rewrite back_f, back_g. clear back_f back_g none long_d long_f long_g.
  assert (f_to_g : 0 <= cross f g \/ (cross f g < 0 /\ (-2 < angle g - angle f < 0 \/ 2 < angle g - angle f))) by lra.
  split; intros side; split; apply Qnot_le_lt || apply Qnot_lt_le; intros other_way; lra.
Qed.

(* From direction a to direction b the winding number falls, so an edge arrives between; or rises, so one departs. *)
Lemma arrives_between (r : region) (v a b : vector) (radius : Q) : no_edges_are_points r ->
  nothing_else_near v radius r -> 0 < cross a b -> within radius v (plus v a) -> within radius v (plus v b) ->
  off (plus v a) (region_edges r) -> off (plus v b) (region_edges r) ->
  (winding_number (plus v b) (region_edges r) < winding_number (plus v a) (region_edges r))%Z ->
  exists h, In h (region_edges r) /\ arrives v h = true /\ is_amid a b (opposite (along h)) = true.
Proof.
  intros not_points near left_ close_a close_b free_a free_b falls.
  pose proof (winding_number_around_the_point r v a b radius not_points near left_ close_a close_b free_a free_b)
    as change_.
  destruct (one_or_all (exists h, In h (region_edges r) /\ arrives v h = true /\
      is_amid a b (opposite (along h)) = true)
    (fun h => arrives v h = true -> is_amid a b (opposite (along h)) = false) (region_edges r))
    as [| no_one]; [| assumption | exfalso].
  { intros h H. destruct (arrives v h) eqn:there; [| now right].
    destruct (is_amid a b (opposite (along h))) eqn:amid_; [left; now exists h | now right]. }
  assert (more : (0 <= sum_of (fun s => Z.b2z (departs v s) * Z.b2z (is_amid a b (along s)) -
      Z.b2z (arrives v s) * Z.b2z (is_amid a b (opposite (along s))))%Z (region_edges r))%Z); [| lia].
  apply sum_is_not_negative. intros s S. specialize (no_one s S).
  destruct (arrives v s); [rewrite (no_one eq_refl) |]; destruct (departs v s), (is_amid a b (along s));
    cbn [Z.b2z]; lia.
Qed.

Lemma departs_between (r : region) (v a b : vector) (radius : Q) : no_edges_are_points r ->
  nothing_else_near v radius r -> 0 < cross a b -> within radius v (plus v a) -> within radius v (plus v b) ->
  off (plus v a) (region_edges r) -> off (plus v b) (region_edges r) ->
  (winding_number (plus v a) (region_edges r) < winding_number (plus v b) (region_edges r))%Z ->
  exists h, In h (region_edges r) /\ departs v h = true /\ is_amid a b (along h) = true.
Proof.
  intros not_points near left_ close_a close_b free_a free_b rises.
  pose proof (winding_number_around_the_point r v a b radius not_points near left_ close_a close_b free_a free_b)
    as change_.
  destruct (one_or_all (exists h, In h (region_edges r) /\ departs v h = true /\ is_amid a b (along h) = true)
    (fun h => departs v h = true -> is_amid a b (along h) = false) (region_edges r))
    as [| no_one]; [| assumption | exfalso].
  { intros h H. destruct (departs v h) eqn:there; [| now right].
    destruct (is_amid a b (along h)) eqn:amid_; [left; now exists h | now right]. }
  assert (less : (0 <= sum_of (fun s => Z.b2z (arrives v s) * Z.b2z (is_amid a b (opposite (along s))) -
      Z.b2z (departs v s) * Z.b2z (is_amid a b (along s)))%Z (region_edges r))%Z).
  { apply sum_is_not_negative. intros s S. specialize (no_one s S).
    destruct (departs v s); [rewrite (no_one eq_refl) |]; destruct (arrives v s), (is_amid a b (opposite (along s)));
      cbn [Z.b2z]; lia. }
  rewrite sum_minus in less, change_. lia.
Qed.

Section Contact.
  Variables p q : region.
  Variables x w u : vector.
  Variable label : summand.
  Hypothesis p_region : valid_region p.
  Hypothesis q_region : valid_region q.
  Hypothesis outside : ~ interiors_meet x p q.
  Hypothesis sum_ : equal_vectors x (plus w u).

  Let p_edges : no_edges_are_points p := proj1 p_region.
  Let q_edges : no_edges_are_points q := proj1 q_region.
  Let outside' : ~ interiors_meet x q p.
  Proof. intros meet_. apply outside. now apply interiors_meet_other_way. Qed.

  (* An edge of Q at u has the direction d, or a corner there has it in its tangent set. *)
  Definition meets_direction (d : vector) : Prop :=
    (exists f, In f (region_edges q) /\ lies_on u f /\ same_direction d (along f)) \/
    (exists chain j, In chain q /\ (j < length chain)%nat /\ equal_vectors u (vertex chain j) /\
       in_tangent_set (Direction d label) (corner_of_chain chain j) = true).

  Lemma beside_a_pass (d f g : vector) : nonzero d -> is_pass q u f g ->
    meets_direction d \/
    ((0 < cross d g -> 0 < cross d f /\ 0 <= cross f g) /\ (0 < cross f d -> 0 < cross g d /\ 0 <= cross f g)).
  Proof.
    intros long_d pass. pose proof (passes_turn q u f g q_region pass) as turn.
    pose proof (edges_of_a_pass q q_edges u f g pass) as [(s & S & s_there & s_along) (t & T & t_there & t_along)].
    apply arrives_is in s_there. apply departs_is in t_there.
    assert (dec : forall v, nonzero v -> same_direction d v \/ ~ same_direction d v).
    { intros v long_v. rewrite same_direction_angle by trivial. destruct (Qeq_dec (angle d) (angle v)); tauto. }
    destruct turn as (long_f & long_g & ahead).
    destruct (dec f long_f) as [same_ | not_f]; [left; left; exists s; rewrite s_along; tauto |].
    destruct (dec g long_g) as [same_ | not_g]; [left; left; exists t; rewrite t_along; tauto |].
    destruct pass as [(e & E & inside_ & -> & ->) | (chain & j & C & J & at_ & f_is & g_is)].
    - right. assert (cross (along e) (along e) == 0) by (unfold cross; ring).
      split; intros side; split; lra.
    - destruct (in_tangent_set (Direction d label) (corner_of_chain chain j)) eqn:tangent.
      + left. right. now exists chain, j.
      + right. rewrite corner_is in tangent by exact J. rewrite <- f_is, <- g_is in tangent.
        now apply (beside_a_tangent_set d f g label).
  Qed.

  (* An edge of P that leaves w, by direction; backwards it is outside Q. *)
  Variable a : segment.
  Hypothesis in_p : In a (region_edges p).
  Hypothesis leaves : departs w a = true.

  Let long_a : nonzero (along a) := region_edges_are_directions p p_edges a in_p.

  Lemma nothing_behind : meets_direction (along a) \/
    eventually (fun k => off (plus u (scaled_by k (opposite (along a)))) (region_edges q) /\
      winding_number (plus u (scaled_by k (opposite (along a)))) (region_edges q) = 0%Z).
  Proof.
    destruct (one_or_all (meets_direction (along a))
      (fun f => lies_on u f -> ~ same_direction (along a) (along f)) (region_edges q))
      as [| none]; [| now left | right].
    { intros f F. destruct (lies_on_dec u f) as [on |]; [| now right].
      pose proof (region_edges_are_directions q q_edges f F) as long_f. rewrite same_direction_angle by trivial.
      destruct (Qeq_dec (angle (along a)) (angle (along f))) as [same_ | other]; [left | now right].
      left. exists f. split; [exact F |]. split; [exact on |]. now apply same_direction_angle. }
    destruct (some_square u q) as (radius & R & near).
    refine (eventually_implied _ _ _ (eventually_and _ _ (goes_ahead_from w a leaves) (eventually_and _ _
      (small_steps_stay_within radius u (opposite (along a)) R) (eventually_below 1 ltac:(lra))))).
    intros k (on_a & close & some & _). set (y := plus u (scaled_by k (opposite (along a)))) in *.
    assert (y_is : equal_vectors (moved_along u (opposite (along a)) k) y)
      by (unfold y, moved_along, plus, scaled_by; split; cbn [vx vy]; ring).
    assert (free : off y (region_edges q)).
    { intros f F on. destruct (near f) as [on_u | away].
      { apply in_flat_map. exists f. split; [exact F | now left]. }
      2: { apply (away _ close). apply (lies_on_equal y); [now symmetry | exact on]. }
      pose proof (region_edges_are_directions q q_edges f F) as long_f. unfold y in on.
      destruct (ahead_or_behind u _ f on_u on) as (m & X & Y & ahead & _).
      unfold scaled_by, opposite in X, Y. cbn [vx vy] in X, Y.
      destruct (Q_dec m 0) as [[low | high] | zero_].
      - apply (none f F on_u). exists (- m / k). split; [apply Qlt_shift_div_l; lra |].
        assert (value : forall v, - m / k * v == (- / k) * (m * v)) by (intros v; field; lra).
        rewrite !value, <- X, <- Y. split; field; lra.
      - apply outside, (opposite_edges_meet p q x w u a f); trivial; [now apply ahead |].
        exists (m / k). split; [apply Qlt_shift_div_l; lra |]. unfold opposite. cbn [vx vy].
        assert (value : forall v, m / k * - v == (- / k) * (m * v)) by (intros v; field; lra).
        rewrite !value, <- X, <- Y. split; field; lra.
      - apply long_a. rewrite zero_ in X, Y. split; apply (Qmult_inj_l _ _ k); lra. }
    split; [exact free |].
    pose proof (proj1 (proj2 q_region) _ free) as not_negative.
    destruct (Z.eq_dec (winding_number y (region_edges q)) 0) as [| some_]; [assumption | exfalso].
    apply outside', (inner_point_and_point q p x y (moved_along w (along a) k)
      (regions_are_regular p p_edges (proj1 (proj2 p_region)) (proj2 (proj2 p_region)))).
    - split; [exact free | lia].
    - right. now exists a.
    - destruct sum_ as [X Y]. unfold y, plus, scaled_by, moved_along, opposite in *. cbn [vx vy] in *.
      split; cbn [vx vy]; lra.
  Qed.

  Hypothesis not_crossing : chains_do_not_cross q.
  Variable b : segment.
  Hypothesis in_q : In b (region_edges q).
  Hypothesis b_leaves : departs u b = true.
  Hypothesis left_ : 0 < cross (along a) (along b).

  (* Between b and -a an edge of Q comes in. *)
  Lemma comes_in_between : meets_direction (along a) \/
    exists h, In h (region_edges q) /\ arrives u h = true /\ 0 < cross (along h) (along b) /\
      0 < cross (along h) (along a).
  Proof.
    destruct nothing_behind as [| nothing]; [now left | right]. set (A := along a) in *. set (B := along b) in *.
    destruct (some_square u q) as (radius & near). pose proof near as [R _].
    pose proof (region_edges_are_directions q q_edges b in_q) as long_b.
    destruct (some_small _ (eventually_and _ _ nothing (small_steps_stay_within radius u (opposite A) R)))
      as (k & some & (free_a & none) & close_a).
    assert (half : 0 < (1 # 2) * radius) by lra.
    destruct (some_small _ (eventually_and _ _ (goes_ahead_from u b b_leaves) (eventually_and _ _
      (small_steps_stay_within _ u B half) (leaves_all_vertices q u B long_b))))
      as (l & some_l & on_b & close_b & no_vertex).
    assert (side : 0 < cross B (opposite A)) by (unfold cross, opposite in *; cbn [vx vy] in *; lra).
    destruct (some_small _ (eventually_and _ _ (left_of_an_edge_is_inside q b _ (opposite A) (proj1 (proj2 q_region))
      (proj2 (proj2 q_region)) in_q on_b no_vertex side)
      (small_steps_stay_within _ (moved_along u B l) (opposite A) half))) as (t & some_t & (free_b & round) & close_t).
    fold B in free_b, round. set (z := moved_along (moved_along u B l) (opposite A) t) in *.
    set (beta := minus z u). set (alpha := scaled_by k (opposite A)) in *.
    assert (z_is : equal_vectors z (plus u beta)) by (unfold beta, plus, minus; split; cbn [vx vy]; ring).
    assert (beta_x : vx beta == l * vx B - t * vx A /\ vy beta == l * vy B - t * vy A).
    { unfold beta, z, moved_along, minus, opposite. split; cbn [vx vy]; ring. }
    destruct beta_x as [beta_x beta_y].
    assert (turn : 0 < cross beta alpha).
    { assert (value : cross beta alpha == l * k * cross A B).
      { unfold cross at 1. rewrite beta_x, beta_y. unfold alpha, scaled_by, opposite, cross. cbn [vx vy]. ring. }
      rewrite value. apply Qmult_lt_0_compat; [now apply Qmult_lt_0_compat | exact left_]. }
    pose proof (within_twice ((1 # 2) * radius) ((1 # 2) * radius) radius _ _ _ ltac:(lra) close_b close_t) as close_z.
    destruct (arrives_between q u beta alpha radius q_edges near turn) as (h & H & there & amid_).
    { clear - close_z. unfold within, beta, plus, minus in *. cbn [vx vy]. lra. }
    { clear - close_a. unfold within, alpha, plus, scaled_by, moved_along in *. cbn [vx vy] in *. lra. }
    { apply (off_equal z); [exact z_is | exact free_b]. }
    { exact free_a. }
    { rewrite none, <- (winding_number_of_equal z (plus u beta) _ (proj1 z_is) (proj2 z_is)). exact round. }
    exists h. split; [exact H |]. split; [exact there |].
    destruct (is_amid_spec beta alpha (opposite (along h))) as [[after_ before_] |]; [| discriminate].
    unfold alpha, scaled_by, opposite, cross in after_, before_. cbn [vx vy] in after_, before_.
    rewrite beta_x, beta_y in after_. unfold cross. set (H_ := along h) in *.
    assert (right_a : 0 < vx H_ * vy A - vy H_ * vx A).
    { apply Qnot_le_lt. intros not_. assert (k * (vx H_ * vy A - vy H_ * vx A) <= 0) by nra. lra. }
    split; [| exact right_a].
    assert (0 < t * (vx H_ * vy A - vy H_ * vx A)) by now apply Qmult_lt_0_compat.
    apply Qnot_le_lt. intros not_. assert (l * (vx H_ * vy B - vy H_ * vx B) <= 0) by nra. lra.
  Qed.

  (* Theorem. *)
  Theorem right_one_is_met : meets_direction (along a).
  Proof.
    destruct comes_in_between as [| (h & H & h_there & h_b & h_a)]; [assumption |].
    destruct (pass_of_departing q u b in_q b_leaves) as (f & first_).
    destruct (pass_of_arriving q u h H h_there) as (g & second).
    destruct (beside_a_pass (along a) f (along b) long_a first_) as [| [at_b _]]; [assumption |].
    destruct (beside_a_pass (along a) (along h) g long_a second) as [| [_ at_h]]; [assumption | exfalso].
    destruct (at_b left_) as [a_f f_b]. destruct (at_h h_a) as [g_a h_g]. clear at_b at_h.
    set (A := along a) in *. set (B := along b) in *. set (H_ := along h) in *.
    apply (not_crossing u f B H_ g first_ second). left. split.
    - left. split; [exact f_b |]. assert (value : cross A B * cross f (opposite H_) ==
        cross f B * cross H_ A + cross A f * cross H_ B) by (unfold cross, opposite; cbn [vx vy]; ring).
      split; [| unfold cross, opposite in *; cbn [vx vy]; lra].
      apply Qnot_le_lt. intros not_. assert (0 <= cross f B * cross H_ A) by (apply Qmult_le_0_compat; lra).
      assert (0 < cross A f * cross H_ B) by now apply Qmult_lt_0_compat.
      assert (cross A B * cross f (opposite H_) <= 0) by nra. lra.
    - left. split; [exact f_b |]. right. assert (value : cross H_ A * cross B g ==
        - (cross g A * cross H_ B + cross H_ g * cross A B)) by (unfold cross; ring).
      apply Qnot_le_lt. intros not_. assert (0 < cross g A * cross H_ B) by now apply Qmult_lt_0_compat.
      assert (0 <= cross H_ g * cross A B) by (apply Qmult_le_0_compat; lra).
      assert (0 <= cross H_ A * cross B g) by (apply Qmult_le_0_compat; lra). lra.
  Qed.
End Contact.
