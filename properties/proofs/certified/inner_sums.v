(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Sums of points strictly inside two convex pieces T and U of the checker (checker.v). They are what is strictly inside
   T + U: if from x, away from the sum m of two inner points, one can go on a little and is still in T + U, then x is
   between such a point and m. So is what is strictly between two sums on a line, if other sums are on both sides of the
   line; and what the checker's middle of common corners shows. *)
From Coq Require Import QArith Lqa Qfield ZArith Lia Bool List.
From Oplus Require Import direction angular_crossings winding_number small_numbers neighbourhoods specification checker
  homogeneous_points specification_bridge fans sums_of_pieces clipped_polygons edges_beside_sums sums_are_inside.
Import ListNotations.

Open Scope Q_scope.

Definition strictly_in (t : piece) (x : vector) : Prop := forall l, In l (side_lines t) -> 0 < value_at l x.

Definition is_inner_sum_of (t u : piece) (x : vector) : Prop :=
  exists a b, strictly_in t a /\ strictly_in u b /\ equal_vectors x (added a b).

Lemma strictly_in_is_inside (t : piece) (x : vector) : strictly_in t x -> inside_piece t x.
Proof. intros strict l L. apply Qlt_le_weak. now apply strict. Qed.

Lemma value_moved (l : line) (x v : vector) (e : Q) :
  value_at l (moved_along x v e) == value_at l x + e * dot (normal_of l) v.
Proof. unfold value_at, moved_along, dot, normal_of. cbn [vx vy]. ring. Qed.

Lemma stays_strictly_in (t : piece) (x v : vector) :
  strictly_in t x -> eventually (fun e => strictly_in t (moved_along x v e)).
Proof.
  intros strict. apply (eventually_for_all (fun l e => 0 < value_at l (moved_along x v e))). intros l L.
  refine (eventually_implied _ _ _ (eventually_positive _ (dot (normal_of l) v) (strict l L))).
  intros e. now rewrite value_moved.
Qed.

Section Two.
  Variables t u : piece.
  Hypotheses (t_convex : is_convex t = true) (u_convex : is_convex u = true).
  Hypotheses (t_lines : t = piece_of (corners_of t)) (u_lines : u = piece_of (corners_of u)).

  Lemma inner_is_strictly_in (r : piece) : is_convex r = true -> r = piece_of (corners_of r) ->
    strictly_in r (vector_of (inner r)).
  Proof.
    intros convex lines l L. rewrite value_at_is.
    pose proof (inner_is_farther (normal_of l) (- inject_Z (lc l)) r convex (side_line_has_a_normal r convex lines l L))
      as far.
    enough (- inject_Z (lc l) < dot (normal_of l) (vector_of (inner r))) by lra.
    apply far. intros a A. pose proof (corners_are_inside r a convex A l L) as left_. rewrite value_at_is in left_. lra.
  Qed.

  Lemma towards_the_middle (x y : vector) (k : Q) : 0 < k <= 1 -> is_in_sum t u y ->
    equal_vectors x (point_between y (inner_sum t u) k) -> is_inner_sum_of t u x.
  Proof.
    intros range (a & b & A & B & y_x & y_y) [x_x x_y].
    exists (point_between a (vector_of (inner t)) k), (point_between b (vector_of (inner u)) k).
    assert (strict : forall r c, is_convex r = true -> r = piece_of (corners_of r) -> inside_piece r c ->
      strictly_in r (point_between c (vector_of (inner r)) k)).
    { intros r c convex lines C l L. rewrite value_between. specialize (C l L).
      pose proof (inner_is_strictly_in r convex lines l L) as inner_left.
      assert (0 <= (1 - k) * value_at l c) by (apply Qmult_le_0_compat; lra).
      assert (0 < k * value_at l (vector_of (inner r))) by (apply Qmult_lt_0_compat; lra). lra. }
    split; [now apply strict | split; [now apply strict |]].
    unfold equal_vectors, point_between, inner_sum, added in *. cbn [vx vy] in *.
    rewrite x_x, x_y, y_x, y_y. split; ring.
  Qed.

  (* If all small steps away from the middle end in the sum. *)
  Lemma inner_if_steps_stay (x : vector) :
    (forall v, eventually (fun e => is_in_sum t u (moved_along x v e))) -> is_inner_sum_of t u x.
  Proof.
    intros steps. set (v := Vector (vx x - vx (inner_sum t u)) (vy x - vy (inner_sum t u))).
    destruct (some_small _ (steps v)) as (e & some & y_in).
    apply (towards_the_middle x (moved_along x v e) (e / (1 + e))); [| exact y_in |].
    - split; [apply Qlt_shift_div_l; lra | apply Qle_shift_div_r; lra].
    - unfold equal_vectors, point_between, moved_along, v. cbn [vx vy]. split; field; lra.
  Qed.

  (* Two vectors along a line. *)
  Lemma along_one_line (n d w : vector) : nonzero n -> nonzero d -> dot n d == 0 -> dot n w == 0 ->
    exists k, vx w == k * vx d /\ vy w == k * vy d.
  Proof.
    unfold nonzero, dot. intros some long d_along w_along.
    assert (x_part : vx n * (vx d * vy w - vy d * vx w) == 0) by by_equations.
    assert (y_part : vy n * (vx d * vy w - vy d * vx w) == 0) by by_equations.
    assert (parallel : vx d * vy w == vy d * vx w)
      by (apply Qmult_integral in x_part; apply Qmult_integral in y_part; lra).
    destruct (Qeq_dec (vx d) 0) as [none | wide].
    - assert (high : ~ vy d == 0) by tauto. exists (vy w / vy d). split; [| field; exact high].
      rewrite none. assert (vx w == 0); [| lra].
      rewrite none, Qmult_0_l in parallel. symmetry in parallel. apply Qmult_integral in parallel. tauto.
    - exists (vx w / vx d). split; [field; exact wide |].
      transitivity (vy d * vx w / vx d); [rewrite <- parallel; field; exact wide | field; exact wide].
  Qed.

  (* Strictly between two sums on a line, if there are sums on both sides of it. *)
  Lemma between_is_inner (l : line) (a b c d x : vector) (s : Q) :
    is_in_sum t u a -> is_in_sum t u b -> is_in_sum t u c -> is_in_sum t u d -> ~ equal_vectors a b ->
    value_at l a == 0 -> value_at l b == 0 -> 0 < value_at l c -> value_at l d < 0 ->
    0 < s < 1 -> equal_vectors x (point_between a b s) -> is_inner_sum_of t u x.
  Proof.
    intros A B C D apart a_on b_on c_left d_right range [x_x x_y]. apply inner_if_steps_stay. intros v.
    assert (some : nonzero (normal_of l)).
    { unfold nonzero, normal_of. cbn [vx vy]. unfold value_at in *. intros [x_is y_is].
      rewrite x_is, y_is in *. lra. }
    assert (long : nonzero (Vector (vx b - vx a) (vy b - vy a))).
    { unfold nonzero. cbn [vx vy]. intros [x_is y_is]. apply apart. split; lra. }
    assert (by_one : forall m, is_in_sum t u m -> ~ value_at l m == 0 -> 0 <= dot (normal_of l) v / value_at l m ->
      eventually (fun e => is_in_sum t u (moved_along x v e))).
    { intros m M off_ sign. set (h := dot (normal_of l) v / value_at l m) in *.
      assert (h_is : h * value_at l m == dot (normal_of l) v) by (unfold h; field; exact off_). clearbody h.
      destruct (along_one_line (normal_of l) (Vector (vx b - vx a) (vy b - vy a))
        (Vector (vx v - h * (vx m - vx a)) (vy v - h * (vy m - vy a)))) as (k & k_x & k_y); trivial.
      - rewrite value_at_is in a_on, b_on. unfold dot in *. cbn [vx vy]. lra.
      - transitivity (dot (normal_of l) v - h * (value_at l m - value_at l a));
          [rewrite !value_at_is; unfold dot; cbn [vx vy]; ring | rewrite a_on, <- h_is; ring].
      - cbn [vx vy] in k_x, k_y.
        assert (one : 0 < 1 - s) by lra.
        refine (eventually_implied _ _ _ (eventually_and _ _ (eventually_positive s k (proj1 range))
          (eventually_and _ _ (eventually_positive (1 - s) (- k - h) one) (eventually_below 1 ltac:(reflexivity))))).
        intros e (b_some & a_some & e_range).
        apply (combination_is_in_sum t u (1 - s + e * (- k - h)) (s + e * k) (e * h) a b m); trivial.
        + assert (0 <= e * h) by (apply Qmult_le_0_compat; lra). unfold are_weights. repeat split; lra.
        + unfold is_combination, moved_along, point_between in *. cbn [vx vy] in *. rewrite x_x, x_y.
          assert (v_x : vx v == k * (vx b - vx a) + h * (vx m - vx a)) by lra.
          assert (v_y : vy v == k * (vy b - vy a) + h * (vy m - vy a)) by lra.
          rewrite v_x, v_y. split; ring. }
    destruct (Qlt_le_dec (dot (normal_of l) v) 0) as [low | high].
    - apply (by_one d D); [lra |]. apply Qle_lteq. left.
      setoid_replace (dot (normal_of l) v / value_at l d) with (- dot (normal_of l) v / - value_at l d) by (field; lra).
      apply Qlt_shift_div_l; lra.
    - apply (by_one c C); [lra |]. apply Qle_shift_div_l; lra.
  Qed.

  (* What the checker tests of a point. *)
  Lemma inner_sum_is_found (x : hpoint) : is_inner_sum t u x = true -> is_inner_sum_of t u (vector_of x).
  Proof.
    assert (strict : forall r a, is_strictly_in r a = true -> strictly_in r (vector_of a)).
    { intros r a. unfold is_strictly_in. rewrite forallb_forall. intros all l L. apply value_positive.
      specialize (all l L). lia. }
    unfold is_inner_sum. destruct (common_corners t u x) as [| first rest]; [discriminate |]. cbv zeta.
    rewrite andb_true_iff. intros [in_t in_u]. eexists _, _. split; [exact (strict _ _ in_t) |].
    split; [exact (strict _ _ in_u) |].
    destruct (vector_of_minus x (Hpoint (px (fold_left hplus rest first)) (py (fold_left hplus rest first))
      (Pos.of_succ_nat (length rest) * pw (fold_left hplus rest first)))) as [x_is y_is].
    unfold added, equal_vectors in *. cbn [vx vy] in *. split; [rewrite <- x_is | rewrite <- y_is]; ring.
  Qed.
End Two.

(* In every direction, an inner sum is strictly farther than some sum of corners. *)
Lemma inner_sum_is_farther_than (n : vector) (k : Q) (t u : piece) (x : vector) :
  is_convex t = true -> t = piece_of (corners_of t) -> is_convex u = true -> u = piece_of (corners_of u) ->
  nonzero n -> is_inner_sum_of t u x ->
  (forall a b, In a (corners_of t) -> In b (corners_of u) -> k <= dot n (added (vector_of a) (vector_of b))) ->
  k < dot n x.
Proof.
  intros t_convex t_lines u_convex u_lines some (a & b & A & B & x_is) far.
  destruct (some_small _ (stays_strictly_in t a (opposite_of n) A)) as (e & e_some & moved_in).
  apply strictly_in_is_inside in moved_in, B.
  assert (square : 0 < e * dot n n).
  { apply Qmult_lt_0_compat; [exact e_some |]. unfold nonzero, dot in *.
    destruct (Qeq_dec (vx n) 0), (Qeq_dec (vy n) 0); [tauto | nra ..]. }
  rewrite (dot_of_equal n _ _ x_is), dot_added.
  assert (k - dot n b <= dot n (moved_along a (opposite_of n) e)) as less.
  { apply (inside_is_as_far n _ t); trivial. intros c C.
    enough (k - dot n (vector_of c) <= dot n b) by lra.
    apply (inside_is_as_far n _ u); trivial. intros d D. specialize (far c d C D). rewrite dot_added in far. lra. }
  unfold dot, moved_along, opposite_of in *. cbn [vx vy] in *. lra.
Qed.
