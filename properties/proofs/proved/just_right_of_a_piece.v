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
    intros some before_ t T (u & u_range & X & Y). destruct (half_way_is m n segments) as [_ less].
    pose proof right_normal as right_. pose proof (middle_is_inside e : strictly_inside m e) as in_middle.
    assert (square : 0 < dot n n) by (unfold n, to_the_right, dot, cross in *; cbn [vx vy] in *; lra). clearbody m n.
    assert (far : forall a, In a (distances m n t) -> 0 < a -> k < a)
      by (intros a A a_some; pose proof (less t a T A a_some); lra).
    unfold distances in far. destruct (Qeq_dec (cross n (along t)) 0) as [parallel | turn].
    - (* on the line of the segment: so the middle is on it *)
      set (a := dot (minus (source t) m) n / dot n n) in *. set (b := dot (minus (target t) m) n / dot n n) in *.
      assert (a_is : a * dot n n == dot (minus (source t) m) n) by (unfold a; field; lra).
      assert (b_is : b * dot n n == dot (minus (target t) m) n) by (unfold b; field; lra).
      pose proof (far a ltac:(cbn; tauto)) as a_far. pose proof (far b ltac:(cbn; tauto)) as b_far.
      clear far less before_. clearbody a b.
      assert (cancelled : forall x y : Q, dot n n * x == dot n n * y -> x == y) by (intros x y; apply Qmult_inj_l; lra).
      assert (k_is : k == (1 - u) * a + u * b) by (apply cancelled; in_coordinates; by_equations).
      assert (source_is : vx (source t) == vx m + a * vx n /\ vy (source t) == vy m + a * vy n)
        by (clear k_is; split; apply cancelled; in_coordinates; by_equations).
      assert (target_is : vx (target t) == vx m + b * vx n /\ vy (target t) == vy m + b * vy n)
        by (clear k_is source_is; split; apply cancelled; in_coordinates; by_equations).
      destruct source_is as [sx sy], target_is as [tx ty].
      assert (between_ : (a <= 0 /\ 0 < b) \/ (0 < a /\ b <= 0)).
      { destruct (Qlt_le_dec 0 a) as [a_some | a_none], (Qlt_le_dec 0 b) as [b_some | b_none];
          [| now right | now left |]; exfalso; [| nra].
        pose proof (mixed_is_more u a b k u_range (a_far a_some) (b_far b_some)). lra. }
      assert (h_is : - a / (b - a) * (b - a) == - a) by (field; lra). set (h := - a / (b - a)) in *. clearbody h.
      assert (on_t : lies_on m t).
      { exists h. split; [destruct between_; split; apply Qnot_lt_le; intros outside; nra |].
        clear - sx sy tx ty h_is. split; by_equations. }
      destruct (only m t in_middle T on_t) as [s_on t_on].
      pose proof (on_the_line m e (strictly_inside_lies_on _ _ in_middle)) as line.
      assert (a_none : a * cross (along e) n == 0) by (clear - s_on line sx sy; in_coordinates; by_equations).
      assert (b_none : b * cross (along e) n == 0) by (clear - t_on line tx ty; in_coordinates; by_equations).
      destruct (Qmult_integral _ _ a_none), (Qmult_integral _ _ b_none); lra.
    - (* across *)
      set (a := cross (minus (source t) m) (along t) / cross n (along t)) in *.
      assert (a_is : a * cross n (along t) == cross (minus (source t) m) (along t)) by (unfold a; field; exact turn).
      assert (k == a) by (apply (Qmult_inj_r _ _ _ turn); clearbody a; in_coordinates; by_equations).
      pose proof (far a ltac:(cbn; tauto)). lra.
  Qed.
End OnePiece.
