(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Where the checker (checker.v) accepts the cells of a polygon with the seams of its cuts, each point around which
   there is some of the polygon on all sides is strictly inside the sum of two pieces, on a dangling edge, or isolated.
   For such a point is strictly on one side of a cut, and has some of that side around it; or it is on the cut, between
   the points where the polygon's sides cross it: then it is in an interval of the seam, or between two of them. *)
From Coq Require Import QArith Lqa Qfield ZArith Lia Bool List FMapPositive.
From Oplus Require Import direction angular_crossings winding_number small_numbers neighbourhoods specification checker
  homogeneous_points specification_bridge fans sums_of_pieces clipped_polygons edges_beside_sums sums_are_inside
  balanced_edges connected_pieces cells_are_sums inner_sums.
Import ListNotations.

Open Scope Q_scope.

Definition lies_strictly_between (a b x : vector) : Prop :=
  ~ equal_vectors a b /\ exists s, 0 < s < 1 /\ equal_vectors x (point_between a b s).

(* Of what is between a and b, a third point on their line leaves what is before it, itself, and what is behind it. *)
Lemma between_in_two_steps (l : line) (a b w x : vector) : nonzero (normal_of l) ->
  value_at l a == 0 -> value_at l b == 0 -> value_at l w == 0 -> lies_strictly_between a b x ->
  lies_strictly_between a w x \/ equal_vectors x w \/ lies_strictly_between w b x.
Proof.
  intros some a_on b_on w_on (apart & s & range & x_x & x_y). rewrite value_at_is in a_on, b_on, w_on.
  destruct (along_one_line (normal_of l) (Vector (vx b - vx a) (vy b - vy a)) (Vector (vx w - vx a) (vy w - vy a)))
    as (k & k_x & k_y); [exact some | | unfold dot in *; cbn [vx vy]; lra .. |].
  { unfold nonzero. cbn [vx vy]. intros [x_is y_is]. apply apart. split; lra. }
  cbn [vx vy] in *. unfold lies_strictly_between, equal_vectors, point_between in *. cbn [vx vy] in *.
  assert (w_x : vx w == vx a + k * (vx b - vx a)) by lra. assert (w_y : vy w == vy a + k * (vy b - vy a)) by lra.
  assert (scaled : forall h d, ~ h == 0 -> h * d == 0 -> d == 0)
    by (intros h d other none; apply Qmult_integral in none; tauto).
  destruct (Q_dec s k) as [[before | behind] | equal_].
  - left. split.
    + intros [x_is y_is]. apply apart. rewrite w_x in x_is. rewrite w_y in y_is.
      split; [assert (vx b - vx a == 0) | assert (vy b - vy a == 0)]; try lra; apply (scaled k); lra.
    + exists (s / k). split; [split; [apply Qlt_shift_div_l | apply Qlt_shift_div_r]; lra |].
      rewrite x_x, x_y, w_x, w_y. split; field; lra.
  - right. right. split.
    + intros [x_is y_is]. apply apart. rewrite w_x in x_is. rewrite w_y in y_is.
      split; [assert (vx b - vx a == 0) | assert (vy b - vy a == 0)]; try lra; apply (scaled (1 - k)); lra.
    + exists ((s - k) / (1 - k)). split; [split; [apply Qlt_shift_div_l | apply Qlt_shift_div_r]; lra |].
      rewrite x_x, x_y, w_x, w_y. split; field; lra.
  - right. left. rewrite x_x, x_y, w_x, w_y, equal_. split; ring.
Qed.

Lemma some_sum_is_not (test : hpoint -> bool) (t u : piece) : are_all_sums test t u = false ->
  exists a b, In a (corners_of t) /\ In b (corners_of u) /\ test (hplus a b) = false.
Proof.
  assert (not_all : forall (f : hpoint -> bool) l, forallb f l = false -> exists a, In a l /\ f a = false).
  { intros f l. induction l as [| a l IH]; [discriminate |]. cbn [forallb]. destruct (f a) eqn:passed.
    - intros none. destruct (IH none) as (b & B & failed). exists b. split; [now right | exact failed].
    - intros _. exists a. split; [now left | exact passed]. }
  unfold are_all_sums. intros none. destruct (not_all _ _ none) as (a & A & of_a).
  destruct (not_all _ _ of_a) as (b & B & failed). now exists a, b.
Qed.

Section Seams.
  Variables (p q : list piece) (dangling : list hedge) (isolated : list hpoint).

  Hypothesis p_convex : forall t, In t p -> is_convex t = true /\ t = piece_of (corners_of t).
  Hypothesis q_convex : forall u, In u q -> is_convex u = true /\ u = piece_of (corners_of u).

  Let p_numbers : numbered := numbers_from 1 p.
  Let q_numbers : numbered := numbers_from 1 q.
  Let edges_ : PositiveMap.t hedge := numbers_from 1 dangling.
  Let points_ : PositiveMap.t hpoint := numbers_from 1 isolated.

  (* An inner sum of two of the pieces. *)
  Definition is_inner_sum_of_some (x : vector) : Prop := exists t u, In t p /\ In u q /\ is_inner_sum_of t u x.

  Definition is_sum_or_left_out (x : vector) : Prop :=
    is_inner_sum_of_some x \/ (exists e, In e dangling /\ lies_on x (segment_of_hedge e)) \/
    exists v, In v isolated /\ equal_vectors x (vector_of v).

  Lemma covered_if_equal (x y : vector) : equal_vectors x y -> is_sum_or_left_out y -> is_sum_or_left_out x.
  Proof.
    intros [x_is y_is] [(t & u & T & U & a & b & A & B & y_x & y_y) | [(e & E & k & range & X & Y) | (v & V & X & Y)]].
    - left. exists t, u. split; [exact T | split; [exact U |]]. exists a, b. split; [exact A | split; [exact B |]].
      split; lra.
    - right. left. exists e. split; [exact E |]. exists k. split; [exact range | split; lra].
    - right. right. exists v. split; [exact V | split; lra].
  Qed.

  Lemma interval_is_covered (l : line) (a b : hpoint) (c : position) (x : vector) :
    is_interval_in p_numbers q_numbers edges_ l a b c = true ->
    value_at l (vector_of a) == 0 -> value_at l (vector_of b) == 0 -> lies_strictly_between (vector_of a) (vector_of b) x ->
    is_sum_or_left_out x.
  Proof.
    intros found a_on b_on (apart & s & range & x_is). destruct c as [i j | k | k]; cbn [is_interval_in] in found.
    - destruct (PositiveMap.find i p_numbers) as [t |] eqn:t_is; [| discriminate].
      destruct (PositiveMap.find j q_numbers) as [u |] eqn:u_is; [| discriminate].
      apply numbers_are_from in t_is, u_is. destruct t_is as [_ T], u_is as [_ U].
      destruct (p_convex t T) as [t_convex t_lines]. destruct (q_convex u U) as [u_convex u_lines].
      rewrite !andb_true_iff, !negb_true_iff in found. destruct found as [[[right_ left_] A] B].
      apply some_sum_is_not in right_, left_. destruct right_ as (d1 & d2 & D1 & D2 & right_).
      destruct left_ as (c1 & c2 & C1 & C2 & left_). apply Z.leb_gt in right_, left_.
      rewrite value_negative in right_. rewrite value_positive in left_.
      assert (sums : forall e f, In e (corners_of t) -> In f (corners_of u) -> is_in_sum t u (vector_of (hplus e f))).
      { intros e f E F. exists (vector_of e), (vector_of f).
        split; [now apply corners_are_inside | split; [now apply corners_are_inside | apply vector_of_plus]]. }
      left. exists t, u. split; [exact T | split; [exact U |]].
      apply (between_is_inner t u t_convex u_convex t_lines u_lines l (vector_of a) (vector_of b)
        (vector_of (hplus c1 c2)) (vector_of (hplus d1 d2)) x s); auto using sum_of_both_is_in_sum.
    - unfold is_on_edge in found. destruct (PositiveMap.find k edges_) as [e |] eqn:e_is; [| discriminate].
      apply numbers_are_from in e_is. destruct e_is as [_ E]. apply andb_true_iff in found. destruct found as [A B].
      apply is_between_lies_on in A, B. right. left. exists e. split; [exact E |].
      apply (common_part _ _ _ _ A B). exists s. split; [lra |]. cbn [source target]. exact x_is.
    - discriminate.
  Qed.

  Lemma point_is_covered (x : hpoint) (c : position) :
    is_point_in p_numbers q_numbers edges_ points_ x c = true -> is_sum_or_left_out (vector_of x).
  Proof.
    destruct c as [i j | k | k]; cbn [is_point_in].
    - destruct (PositiveMap.find i p_numbers) as [t |] eqn:t_is; [| discriminate].
      destruct (PositiveMap.find j q_numbers) as [u |] eqn:u_is; [| discriminate].
      apply numbers_are_from in t_is, u_is. destruct t_is as [_ T], u_is as [_ U]. intros found.
      left. exists t, u. split; [exact T | split; [exact U |]]. now apply inner_sum_is_found.
    - unfold is_on_edge. destruct (PositiveMap.find k edges_) as [e |] eqn:e_is; [| discriminate].
      apply numbers_are_from in e_is. destruct e_is as [_ E]. intros on. right. left. exists e.
      split; [exact E | now apply is_between_lies_on].
    - destruct (PositiveMap.find k points_) as [v |] eqn:v_is; [| discriminate].
      apply numbers_are_from in v_is. destruct v_is as [_ V]. intros on. right. right. exists v. split; [exact V |].
      apply is_between_lies_on in on. destruct on as (s & _ & x_is & y_is). cbn [source target] in *. split; lra.
  Qed.

  Lemma seam_is_covered (l : line) (others : list (hpoint * position * position)) : nonzero (normal_of l) ->
    forall (a b : hpoint) (c : position) (x : vector), is_seam p_numbers q_numbers edges_ points_ l a b c others = true ->
    value_at l (vector_of a) == 0 -> value_at l (vector_of b) == 0 -> lies_strictly_between (vector_of a) (vector_of b) x ->
    is_sum_or_left_out x.
  Proof.
    intros some. induction others as [| [[w of_w] next] rest IH]; intros a b c x; cbn [is_seam].
    - apply interval_is_covered.
    - rewrite !andb_true_iff, Z.eqb_eq, value_zero. intros [[[w_on first] here] more] a_on b_on between_.
      destruct (between_in_two_steps l _ _ _ _ some a_on b_on w_on between_) as [before | [equal_ | behind]].
      + now apply (interval_is_covered l a w c).
      + apply (covered_if_equal _ _ equal_). now apply (point_is_covered w of_w).
      + now apply (IH w b next).
  Qed.

  (* A point on the cut around which there is some of what is on the left. *)
  Lemma cut_is_covered (l : line) (v : polygon) (s : option seam) (x : vector) :
    is_seam_of_cut p_numbers q_numbers edges_ points_ l v s = true -> value_at l x == 0 ->
    (forall w, dot (normal_of l) w == 0 -> eventually (fun e => inside_piece (piece_of v) (moved_along x w e))) ->
    is_sum_or_left_out x.
  Proof.
    unfold is_seam_of_cut. destruct s as [s |]; [| discriminate].
    destruct (find (fun e => (0 <? value l (fst e))%Z && (value l (snd e) =? 0)%Z) (sides v)) as [e |] eqn:e_is;
      [| discriminate].
    destruct (find (fun e => (value l (fst e) =? 0)%Z && (0 <? value l (snd e))%Z) (sides v)) as [f |] eqn:f_is;
      [| discriminate].
    apply find_some in e_is, f_is. destruct e_is as [E e_is], f_is as [F f_is].
    rewrite !andb_true_iff, !Z.ltb_lt, !Z.eqb_eq in *. destruct e_is as [e_left e_on], f_is as [f_on _].
    rewrite !left_turn_is_positive. intros [[e_turn f_turn] found] x_on steps.
    rewrite value_zero in e_on, f_on. rewrite value_positive in e_left.
    assert (some : nonzero (normal_of l)).
    { unfold nonzero, normal_of. cbn [vx vy]. unfold value_at in *. intros [x_is y_is]. rewrite x_is, y_is in *. lra. }
    set (a := vector_of (snd e)) in *. set (b := vector_of (fst f)) in *.
    set (d := Vector (vx b - vx a) (vy b - vy a)).
    assert (d_along : dot (normal_of l) d == 0)
      by (rewrite value_at_is in e_on, f_on; unfold d, dot in *; cbn [vx vy]; lra).
    assert (apart : ~ equal_vectors a b).
    { intros [x_is y_is]. unfold turn_of in e_turn. rewrite <- x_is, <- y_is in e_turn. fold a in e_turn. lra. }
    destruct (along_one_line (normal_of l) d (Vector (vx x - vx a) (vy x - vy a))) as (k & k_x & k_y); trivial.
    { unfold d, nonzero. cbn [vx vy]. intros [x_is y_is]. apply apart. split; lra. }
    { rewrite value_at_is in e_on, x_on. unfold dot in *. cbn [vx vy]. lra. }
    unfold d in k_x, k_y. cbn [vx vy] in k_x, k_y.
    assert (x_x : vx x == vx a + k * (vx b - vx a)) by lra. assert (x_y : vy x == vy a + k * (vy b - vy a)) by lra.
    destruct (some_small _ (eventually_and _ _ (steps d d_along)
      (steps (opposite_of d) ltac:(unfold dot, opposite_of in *; cbn [vx vy]; lra)))) as (h & h_some & ahead & back).
    rewrite inside_is_left_of_sides in ahead, back. specialize (ahead f F). specialize (back e E).
    fold a in back. fold b in ahead.
    assert (before_b : 0 <= (1 - k - h) * turn_of b (vector_of (snd f)) a).
    { eapply Qle_trans; [exact ahead |]. apply Qle_lteq. right. unfold turn_of, moved_along, d. cbn [vx vy].
      rewrite x_x, x_y. ring. }
    assert (behind_a : 0 <= (k - h) * turn_of (vector_of (fst e)) a b).
    { eapply Qle_trans; [exact back |]. apply Qle_lteq. right. unfold turn_of, moved_along, opposite_of, d. cbn [vx vy].
      rewrite x_x, x_y. ring. }
    apply (seam_is_covered l (later s) some (snd e) (fst f) (beginning s) x found e_on f_on).
    fold a b. split; [exact apart |]. exists k. split; [split; nra |].
    unfold equal_vectors, point_between. cbn [vx vy]. rewrite x_x, x_y. split; ring.
  Qed.

  (* Theorem. Cells and the seams of their cuts cover what has some of the polygon around it. *)
  Theorem cells_are_covered (c : cells) : forall (v : polygon) (x : vector),
    are_sums (is_seam_of_cut p_numbers q_numbers edges_ points_) p_numbers q_numbers v c = true ->
    (forall w, eventually (fun e => inside_piece (piece_of v) (moved_along x w e))) -> is_sum_or_left_out x.
  Proof.
    induction c as [i j | l along one IH_one other IH_other]; intros v x; cbn [are_sums].
    - destruct (PositiveMap.find i p_numbers) as [t |] eqn:t_is; [| easy].
      destruct (PositiveMap.find j q_numbers) as [u |] eqn:u_is; [| easy].
      apply numbers_are_from in t_is, u_is. destruct t_is as [_ T], u_is as [_ U].
      destruct (p_convex t T) as [t_convex t_lines]. destruct (q_convex u U) as [u_convex u_lines].
      rewrite andb_true_iff. intros [fan sums] steps. left. exists t, u. split; [exact T | split; [exact U |]].
      apply inner_if_steps_stay; trivial. intros w. refine (eventually_implied _ _ _ (steps w)). intros e.
      now apply polygon_is_in_sum with (tries := length v).
    - rewrite !andb_true_iff. intros [[[[ahead ahead_opposite] seam_] sums_one] sums_other] steps.
      destruct (Q_dec (value_at l x) 0) as [[right_ | left_] | on].
      + apply (IH_other _ x sums_other). intros w.
        assert (opposite_left : 0 < - value_at l x) by lra.
        refine (eventually_implied _ _ _ (eventually_and _ _ (steps w)
          (eventually_positive _ (- dot (normal_of l) w) opposite_left))).
        intros e [within_ beyond]. apply clipped_has_what_is_left; trivial.
        rewrite value_at_opposite_line, value_moved. lra.
      + apply (IH_one _ x sums_one). intros w.
        refine (eventually_implied _ _ _ (eventually_and _ _ (steps w)
          (eventually_positive _ (dot (normal_of l) w) left_))).
        intros e [within_ beyond]. apply clipped_has_what_is_left; trivial. rewrite value_moved. lra.
      + apply (cut_is_covered l _ along x seam_ on). intros w along_w.
        refine (eventually_implied _ _ _ (steps w)). intros e within_.
        apply clipped_has_what_is_left; trivial. rewrite value_moved, on, along_w. lra.
  Qed.
End Seams.
