(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* A point just right of the middle of a piece: on the way there from the middle no segment is met. For tests that need
   a point with coordinates, as the collision test does. *)
From Coq Require Import QArith Qminmax Lqa Qfield ZArith Lia Bool List.
From Oplus Require Import convolution regions meeting_of_segments first_hit interiors_meet neighbourhoods
  left_of_an_edge observation_2_2_4 pieces naive_collision collision_is_sound beside_a_piece sums_of_two_edges.
Import ListNotations.

Open Scope Q_scope.

Definition to_the_right (e : segment) : vector := Vector (vy (along e)) (- vx (along e)).

(* How far from m in the direction n a segment may be met: its line is, or its ends are beside. *)
Definition distances (m n : vector) (t : segment) : list Q :=
  [cross (minus (source t) m) (along t) / cross n (along t);
   dot (minus (source t) m) n / dot n n; dot (minus (target t) m) n / dot n n].

Definition half_way (m n : vector) (segments : list segment) : Q :=
  fold_right (fun k least => if positive k then smaller k least else least) 1 (flat_map (distances m n) segments) / 2.

Definition just_right_of (segments : list segment) (e : segment) : vector :=
  moved_along (middle e) (to_the_right e) (half_way (middle e) (to_the_right e) segments).

Lemma half_way_is (m n : vector) (segments : list segment) :
  0 < half_way m n segments /\
  forall t k, In t segments -> In k (distances m n t) -> 0 < k -> half_way m n segments < k.
Proof.
  unfold half_way.
  enough (least_of_all : forall l,
    let least := fold_right (fun k least => if positive k then smaller k least else least) 1 l in
    0 < least /\ forall k, In k l -> 0 < k -> least <= k).
  { destruct (least_of_all (flat_map (distances m n) segments)) as [some least].
    set (number := fold_right _ _ _) in *. assert (half : number / 2 == (1 # 2) * number) by field.
    split; [lra |]. intros t k T K k_some.
    assert (number <= k) by (apply least; [apply in_flat_map; now exists t | exact k_some]). lra. }
  induction l as [| a l IH]; cbn [fold_right]; [split; [lra | intros k []] |].
  destruct IH as [some least]. set (number := fold_right _ _ l) in *. clearbody number.
  assert (no_more : forall b c, smaller b c <= b /\ smaller b c <= c /\ (0 < b -> 0 < c -> 0 < smaller b c)).
  { intros b c. unfold smaller. destruct (Qle_bool b c) eqn:order; [apply Qle_bool_iff in order; lra |].
    assert (~ b <= c) by (rewrite <- Qle_bool_iff; congruence). lra. }
  destruct (no_more a number) as (n1 & n2 & n3).
  unfold positive. destruct (negative_spec (- a)) as [a_some | none].
  - split; [apply n3; lra |]. intros k [-> | K] k_some; [exact n1 | specialize (least k K k_some); lra].
  - split; [exact some |]. intros k [-> | K] k_some; [exfalso; lra | now apply least].
Qed.

Section OnePiece.
  Variable segments : list segment.
  Variable e : segment.
  Hypothesis long : nonzero (along e).
  Hypothesis only : met_only_along segments e.

  Let m := middle e.
  Let n := to_the_right e.

  Lemma right_normal : cross (along e) n < 0.
  Proof.
    pose proof (left_normal e long) as left_. unfold n, to_the_right, cross in *. cbn [vx vy] in *. lra.
  Qed.

  (* Theorem. From the middle, itself excepted, to the point just right of it no segment is met. *)
  Theorem nothing_just_right (k : Q) : 0 < k -> k <= half_way m n segments -> off (moved_along m n k) segments.
  Proof.
    intros some before_ t T (u & u_range & X & Y). unfold moved_along in X, Y. cbn [vx vy] in X, Y.
    destruct (half_way_is m n segments) as [_ less]. pose proof right_normal as right_.
    assert (impossible : forall a, In a (distances m n t) -> k <= a -> a <= k -> False).
    { intros a A low high. assert (half_way m n segments < a) by (apply (less t a T A); lra). lra. }
    assert (square : 0 < dot n n).
    { unfold n, to_the_right, dot, cross in *. cbn [vx vy] in *. lra. }
    set (v := along t).
    assert (vx_is : vx v == vx (target t) - vx (source t)) by reflexivity.
    assert (vy_is : vy v == vy (target t) - vy (source t)) by reflexivity.
    destruct (Qeq_dec (cross n v) 0) as [parallel | turn].
    - (* on the line of the segment *)
      set (a := dot (minus (source t) m) n / dot n n). set (b := dot (minus (target t) m) n / dot n n).
      assert (a_is : a * dot n n == dot (minus (source t) m) n) by (unfold a; field; lra).
      assert (b_is : b * dot n n == dot (minus (target t) m) n) by (unfold b; field; lra).
      assert (k_is : k == (1 - u) * a + u * b).
      { apply (Qmult_inj_r _ _ (dot n n)); [lra |].
        setoid_replace (((1 - u) * a + u * b) * dot n n) with ((1 - u) * (a * dot n n) + u * (b * dot n n)) by ring.
        rewrite a_is, b_is. unfold dot, minus. cbn [vx vy].
        setoid_replace (k * (vx n * vx n + vy n * vy n)) with
          ((vx m + k * vx n - vx m) * vx n + (vy m + k * vy n - vy m) * vy n) by ring.
        rewrite X, Y. ring. }
      assert (a_far : 0 < a -> k < a).
      { intros a_some.
        assert (half_way m n segments < a) by (apply (less t a T); [right; now left | exact a_some]). lra. }
      assert (b_far : 0 < b -> k < b).
      { intros b_some. assert (half_way m n segments < b) by
          (apply (less t b T); [right; right; now left | exact b_some]). lra. }
      (* so the middle is on it *)
      assert (on_line : cross n (minus (source t) m) == 0).
      { assert (along_line : cross n (minus (source t) m) == - u * cross n v).
        { unfold cross, minus. cbn [vx vy]. rewrite vx_is, vy_is.
          assert (sx : vx (source t) == vx m + k * vx n - u * (vx (target t) - vx (source t))) by lra.
          assert (sy : vy (source t) == vy m + k * vy n - u * (vy (target t) - vy (source t))) by lra.
          setoid_replace (vx n * (vy (source t) - vy m) - vy n * (vx (source t) - vx m)) with
            (vx n * (vy (source t)) - vy n * (vx (source t)) - (vx n * vy m - vy n * vx m)) by ring.
          rewrite sx, sy at 1. ring. }
        rewrite along_line, parallel. ring. }
      assert (between_ : (a <= 0 /\ 0 < b) \/ (0 < a /\ b <= 0)).
      { destruct (Qlt_le_dec 0 a) as [a_some | a_none], (Qlt_le_dec 0 b) as [b_some | b_none];
          [| now right | now left |]; exfalso.
        - specialize (a_far a_some). specialize (b_far b_some). destruct (Qlt_le_dec 0 u) as [u_some | u_none].
          + assert (0 < u * (b - k)) by (apply Qmult_lt_0_compat; lra).
            assert (0 <= (1 - u) * (a - k)) by (apply Qmult_le_0_compat; lra). lra.
          + assert (u_is : u == 0) by lra. rewrite u_is in k_is. lra.
        - assert (0 <= (1 - u) * - a) by (apply Qmult_le_0_compat; lra).
          assert (0 <= u * - b) by (apply Qmult_le_0_compat; lra). lra. }
      assert (apart_ : ~ b - a == 0) by lra.
      set (h := - a / (b - a)).
      assert (h_is : h * (b - a) == - a) by (unfold h; field; exact apart_).
      assert (h_range : 0 <= h <= 1).
      { destruct between_ as [[low high] | [low high]].
        - unfold h. split; [apply Qle_shift_div_l | apply Qle_shift_div_r]; lra.
        - setoid_replace h with (a / (a - b)) by (unfold h; field; split; lra).
          split; [apply Qle_shift_div_l | apply Qle_shift_div_r]; lra. }
      assert (source_is : vx (source t) == vx m + a * vx n /\ vy (source t) == vy m + a * vy n).
      { split; apply (Qmult_inj_r _ _ (dot n n)); try lra.
        - setoid_replace ((vx m + a * vx n) * dot n n) with (vx m * dot n n + a * dot n n * vx n) by ring.
          rewrite a_is. setoid_replace (vx (source t) * dot n n) with
            (vx m * dot n n + dot (minus (source t) m) n * vx n - vy n * cross n (minus (source t) m))
            by (unfold dot, cross, minus; cbn [vx vy]; ring).
          rewrite on_line. ring.
        - setoid_replace ((vy m + a * vy n) * dot n n) with (vy m * dot n n + a * dot n n * vy n) by ring.
          rewrite a_is. setoid_replace (vy (source t) * dot n n) with
            (vy m * dot n n + dot (minus (source t) m) n * vy n + vx n * cross n (minus (source t) m))
            by (unfold dot, cross, minus; cbn [vx vy]; ring).
          rewrite on_line. ring. }
      assert (on_line_too : cross n (minus (target t) m) == 0).
      { setoid_replace (cross n (minus (target t) m)) with (cross n (minus (source t) m) + cross n v)
          by (unfold v, along, cross, minus; cbn [vx vy]; ring). lra. }
      assert (target_is : vx (target t) == vx m + b * vx n /\ vy (target t) == vy m + b * vy n).
      { split; apply (Qmult_inj_r _ _ (dot n n)); try lra.
        - setoid_replace ((vx m + b * vx n) * dot n n) with (vx m * dot n n + b * dot n n * vx n) by ring.
          rewrite b_is. setoid_replace (vx (target t) * dot n n) with
            (vx m * dot n n + dot (minus (target t) m) n * vx n - vy n * cross n (minus (target t) m))
            by (unfold dot, cross, minus; cbn [vx vy]; ring).
          rewrite on_line_too. ring.
        - setoid_replace ((vy m + b * vy n) * dot n n) with (vy m * dot n n + b * dot n n * vy n) by ring.
          rewrite b_is. setoid_replace (vy (target t) * dot n n) with
            (vy m * dot n n + dot (minus (target t) m) n * vy n + vx n * cross n (minus (target t) m))
            by (unfold dot, cross, minus; cbn [vx vy]; ring).
          rewrite on_line_too. ring. }
      destruct source_is as [sx sy], target_is as [tx ty].
      assert (on_t : lies_on m t).
      { exists h. split; [exact h_range |]. rewrite sx, sy, tx, ty.
        split; [setoid_replace ((1 - h) * (vx m + a * vx n) + h * (vx m + b * vx n)) with
          (vx m + (a + h * (b - a)) * vx n) by ring |
          setoid_replace ((1 - h) * (vy m + a * vy n) + h * (vy m + b * vy n)) with
          (vy m + (a + h * (b - a)) * vy n) by ring]; rewrite h_is; ring. }
      destruct (only m t (middle_is_inside e) T on_t) as [s_on t_on].
      assert (both : cross (along e) v == 0).
      { setoid_replace (cross (along e) v) with (area e (target t) - area e (source t))
          by (unfold v, area, along, cross, minus; cbn [vx vy]; ring). lra. }
      assert (step : vx v == (b - a) * vx n /\ vy v == (b - a) * vy n).
      { rewrite vx_is, vy_is, sx, sy, tx, ty. split; ring. }
      destruct step as [step_x step_y].
      assert (product : (b - a) * cross (along e) n == 0).
      { rewrite <- both. unfold cross. rewrite step_x, step_y. ring. }
      destruct (Qmult_integral _ _ product); [contradiction | lra].
    - (* across *)
      set (a := cross (minus (source t) m) v / cross n v).
      assert (k_is : k == a).
      { apply (Qmult_inj_r _ _ (cross n v)); [exact turn |].
        setoid_replace (a * cross n v) with (cross (minus (source t) m) v) by (unfold a; field; exact turn).
        unfold cross, minus. cbn [vx vy].
        setoid_replace (k * (vx n * vy v - vy n * vx v)) with
          ((vx m + k * vx n - vx m) * vy v - (vy m + k * vy n - vy m) * vx v) by ring.
        rewrite X, Y, vx_is, vy_is. ring. }
      apply (impossible a); [now left | lra | lra].
  Qed.

  Theorem just_right_of_is_off : off (just_right_of segments e) segments.
  Proof. apply nothing_just_right; [apply half_way_is | apply Qle_refl]. Qed.
End OnePiece.
