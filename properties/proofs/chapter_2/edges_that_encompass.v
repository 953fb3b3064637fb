(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Theorem 2.3.2, first part, as its proof in the thesis has it where chains touch: the edges of Q at u that are next to
   the direction of an edge e of P, on both sides of it, decide. If these two, one that comes to u and one that leaves
   it, turn to the right, the sum of u and a point inside e is not on the boundary of the sum. Were it there, nothing of
   Q near u would be to the right of e: P fills all to the left of e, and could slide across. So if e is not inside Q
   between the two edges, they turn to the left. And if it is, all between them is inside Q, also what is to the right
   of e. Ties are open as in the convolution. *)
From Coq Require Import ZArith Lia Bool List.
From Oplus Require Import numbers regions_and_sums first_edge_of_a_ray theorem_2_2_10 observation_2_2_4
  lemma_2_2_9 inside_a_corner lemma_2_2_2 finite_sums edges_at_a_point fans_that_touch edges_that_pass.
Import ListNotations.

Open Scope Q_scope.

(* Turning counterclockwise from a, one meets d before b. *)
Definition is_met_from_to (a d b : vector) : Prop :=
  ccw (Direction d OfP) (Direction a OfQ) (Direction b OfQ) = true.

(* No edge of r at u leads from it between a and b. *)
Definition nothing_between (r : region) (u a b : vector) : Prop :=
  forall s c, In s (region_edges r) ->
    (departs u s = true /\ c = along s) \/ (arrives u s = true /\ c = opposite (along s)) ->
    ccw (Direction c OfQ) (Direction a OfQ) (Direction b OfQ) = false.

(* Of the edges of r at u, f comes to it and g leaves it, and d is directly between them, one way or the other. *)
Definition directly_encompass (r : region) (u d : vector) (f g : segment) : Prop :=
  In f (region_edges r) /\ arrives u f = true /\ In g (region_edges r) /\ departs u g = true /\
  ((is_met_from_to (opposite (along f)) d (along g) /\ nothing_between r u (opposite (along f)) (along g)) \/
   (is_met_from_to (along g) d (opposite (along f)) /\ nothing_between r u (along g) (opposite (along f)))).

(* Turning from g, what is to the left of it comes before what is to the right. *)
Lemma left_before_right (g c h : vector) : 0 < cross g c -> cross g h < 0 ->
  ccw (Direction c OfQ) (Direction g OfQ) (Direction h OfQ) = true.
Proof.
  intros left_ right_. assert (proper : nonzero g /\ nonzero c /\ nonzero h)
    by (split; [| split]; intros [X Y]; unfold cross in *; rewrite X, Y in *; lra).
  destruct proper as (long_g & long_c & long_h).
  pose proof (cross_angle g c long_g long_c) as g_c. pose proof (cross_angle g h long_g long_h) as g_h.
  unfold turns_by in *. pose proof (angle_range g long_g). pose proof (angle_range c long_c).
  pose proof (angle_range h long_h).
  destruct (ccw_spec (Direction c OfQ) (Direction g OfQ) (Direction h OfQ) long_c long_g long_h) as [| none];
    [reflexivity | exfalso]. apply none. unfold in_order, earlier. cbn [vec]. lra.
Qed.

(* Turning from a, which is not behind b, one does not meet before b what is right of both, or along a. *)
Lemma not_met_between (a d b : vector) : nonzero d -> 0 <= cross d a -> 0 <= cross d b -> 0 < cross a b ->
  ~ is_met_from_to a d b.
Proof.
  intros long_d left_a left_b turn met_. assert (proper : nonzero a /\ nonzero b)
    by (split; intros [X Y]; unfold cross in *; rewrite X, Y in *; lra).
  destruct proper as (long_a & long_b).
  pose proof (cross_angle a b long_a long_b) as a_b. pose proof (cross_angle d a long_d long_a) as d_a.
  pose proof (cross_angle d b long_d long_b) as d_b. unfold turns_by in *.
  pose proof (angle_range a long_a). pose proof (angle_range b long_b). pose proof (angle_range d long_d).
  unfold is_met_from_to in met_.
  destruct (ccw_spec (Direction d OfP) (Direction a OfQ) (Direction b OfQ) long_d long_a long_b) as [order |];
    [| discriminate]. unfold in_order, earlier, place in order. cbn [vec of] in order. lra.
Qed.

(* Theorem. *)
Theorem encompassed_by_a_reflex_vertex (p q : region) (e f g : segment) (w u : vector) :
  valid_region p -> valid_region q -> In e (region_edges p) -> lies_on w e -> ~ is_vertex w p ->
  directly_encompass q u (along e) f g -> cross (along f) (along g) < 0 ->
  ~ on_boundary_of_sum (plus w u) p q.
Proof.
  intros p_region q_region E on_e no_vertex (F & f_arrives & G & g_leaves & which) right_turn boundary.
  pose proof (fills_left_beside_an_edge p e w p_region E on_e no_vertex) as fills.
  pose proof (region_edges_are_directions p (proj1 p_region) e E) as long_e.
  pose proof (region_edges_are_directions q (proj1 q_region) g G) as long_g. set (d := along e) in *.
  assert (none_right : forall v, cross d v < 0 -> eventually (fun t => in_region (moved_along u v t) q) -> False).
  { intros v right_ there. apply (inner_points_are_not_on_the_boundary p q (plus w u)); [| exact boundary].
    exact (sliding p q w u d v fills there right_). }
  assert (left_g : 0 <= cross d (along g)).
  { apply Qnot_lt_le. intros right_. apply (none_right _ right_).
    refine (eventually_implied _ _ _ (goes_ahead_from u g g_leaves)). intros t on. right. now exists g. }
  assert (left_f : 0 <= cross d (opposite (along f))).
  { apply Qnot_lt_le. intros right_. apply (none_right _ right_).
    refine (eventually_implied _ _ _ (comes_from_behind u f f_arrives)). intros t on. right. now exists f. }
  assert (turn : 0 < cross (opposite (along f)) (along g)) by (unfold cross, opposite in *; cbn [vx vy]; lra).
  destruct which as [[met_ _] | [_ nothing]]; [exact (not_met_between _ d _ long_e left_f left_g turn met_) |].
  set (h := along g) in *.
  (* a direction to the right of e and to the left of g: all up to it is inside Q *)
  assert (found : exists v, cross d v < 0 /\ 0 < cross h v).
  { destruct (Qlt_le_dec 0 (cross d h)) as [some | none].
    - exists (opposite (plus d h)). unfold cross, plus, opposite in *. cbn [vx vy]. split; lra.
    - assert (flat : cross h d == 0) by (unfold cross in *; lra).
      destruct (multiple_of h d long_e flat) as (c & X & Y).
      assert (back : c < 0).
      { apply Qnot_le_lt. intros ahead. unfold cross, opposite in *. cbn [vx vy] in *. rewrite X, Y in turn. nra. }
      pose proof (square_positive d long_e) as square. unfold dot in square. exists (Vector (vy d) (- vx d)).
      unfold cross in *. cbn [vx vy]. rewrite X, Y. split; [lra | nra]. }
  destruct found as (v & right_v & left_v). apply (none_right v right_v).
  destruct (some_square u q) as (radius & near). pose proof near as [R _]. assert (half : 0 < (1 # 2) * radius) by lra.
  destruct (some_small _ (eventually_and _ _ (goes_ahead_from u g g_leaves) (eventually_and _ _
    (small_steps_stay_within _ u h half) (leaves_all_vertices q u h long_g))))
    as (k & some_k & on_g & close_k & free_g).
  fold h in on_g. pose proof q_region as (q_edges & q_valid & q_meet).
  destruct (some_small _ (eventually_and _ _ (left_of_an_edge_is_inside q g _ v q_valid q_meet G on_g free_g left_v)
    (small_steps_stay_within _ (moved_along u h k) v half))) as (m & some_m & (free_z & round) & close_m).
  set (z := moved_along (moved_along u h k) v m) in *.
  pose proof (within_twice ((1 # 2) * radius) ((1 # 2) * radius) radius _ _ _ ltac:(lra) close_k close_m) as close_z.
  set (b := Vector (k * vx h + m * vx v) (k * vy h + m * vy v)).
  assert (z_is : equal_vectors z (plus u b)) by (unfold z, b, plus, moved_along; split; cbn [vx vy]; ring).
  refine (eventually_implied _ _ _ (eventually_and _ _ (eventually_below 1 ltac:(lra))
    (small_steps_stay_within radius u v R))). intros t [[some_t _] close_t].
  destruct (on_or_off (moved_along u v t) (region_edges q)) as [(s & S & on) | free]; [right; now exists s | left].
  set (c := Vector (t * vx v) (t * vy v)).
  assert (c_is : equal_vectors (moved_along u v t) (plus u c))
    by (unfold c, plus, moved_along; split; cbn [vx vy]; ring).
  assert (b_c : 0 < cross b c).
  { assert (value : cross b c == k * t * cross h v) by (unfold b, c, cross; cbn [vx vy]; ring). rewrite value.
    apply Qmult_lt_0_compat; [now apply Qmult_lt_0_compat | exact left_v]. }
  assert (amid_left : forall a, is_amid b c a = true -> ccw (Direction a OfQ) (Direction h OfQ)
    (Direction (opposite (along f)) OfQ) = true).
  { intros a amid_. apply left_before_right; [| unfold cross in *; lra].
    destruct (is_amid_spec b c a) as [[after_ before_] |]; [| discriminate].
    assert (after_v : cross b a == k * cross h a + m * cross v a) by (unfold b, cross; cbn [vx vy]; ring).
    assert (before_v : cross a c == t * - cross v a) by (unfold c, cross; cbn [vx vy]; ring).
    rewrite after_v in after_. rewrite before_v in before_.
    assert (cross v a < 0) by (apply Qnot_le_lt; intros not_; nra).
    apply Qnot_le_lt. intros not_. assert (0 < m * - cross v a) by (apply Qmult_lt_0_compat; lra). nra. }
  assert (off_c : off (plus u c) (region_edges q)) by (now apply (off_equal (moved_along u v t))).
  assert (off_b : off (plus u b) (region_edges q)) by (now apply (off_equal z)).
  assert (close_c : within radius u (plus u c)) by (destruct c_is as [X Y]; unfold within in *; lra).
  assert (close_b : within radius u (plus u b)) by (destruct z_is as [X Y]; unfold within in *; lra).
  pose proof (winding_number_around_the_point q u b c radius q_edges near b_c close_b close_c off_b off_c) as change_.
  rewrite <- (winding_number_of_equal z (plus u b) _ (proj1 z_is) (proj2 z_is)),
    <- (winding_number_of_equal _ (plus u c) _ (proj1 c_is) (proj2 c_is)) in change_.
  match type of change_ with _ = ?sum_ => assert (none : sum_ = 0%Z) end; [| rewrite none in change_; lia].
  apply sum_of_zeros. intros s S.
  destruct (departs u s) eqn:leaves; [destruct (is_amid b c (along s)) eqn:amid_ |];
    [exfalso | destruct (arrives u s) eqn:comes; [destruct (is_amid b c (opposite (along s))) eqn:amid' |] ..];
    cbn [Z.b2z]; try lia; exfalso.
  - apply amid_left in amid_. rewrite (nothing s (along s) S (or_introl (conj leaves eq_refl))) in amid_. discriminate.
  - apply amid_left in amid'. rewrite (nothing s _ S (or_intror (conj comes eq_refl))) in amid'. discriminate.
  - apply amid_left in amid'. rewrite (nothing s _ S (or_intror (conj comes eq_refl))) in amid'. discriminate.
Qed.
