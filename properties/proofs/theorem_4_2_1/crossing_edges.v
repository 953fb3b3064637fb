(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Where x is the sum of a point of an edge and a point of another, and of no vertex of either with the other,
   the boundary of the edges' sum (parallelogram.v) goes once round x, counterclockwise if the second edge turns
   left from the first: in docs/winding.md, two edges that cross count 1 or -1. *)
From Coq Require Import ZArith Lia Bool List.
From Oplus Require Import numbers convolution reflected regions parallelogram.
Import ListNotations.

Open Scope Q_scope.

(* x is not the sum of an end of one segment and a point of the other. *)
Definition not_sum_of_an_end (x : vector) (e f : segment) : Prop :=
  ~ lies_on (minus x (source e)) f /\ ~ lies_on (minus x (target e)) f /\
  ~ lies_on (minus x (source f)) e /\ ~ lies_on (minus x (target f)) e.

(* Two parallel segments have no sum of points that is not the sum of an end and a point. *)
Lemma parallel_sums (x : vector) (e f : segment) :
  nonzero (along f) -> cross (along e) (along f) == 0 -> is_sum_of_points x e f -> not_sum_of_an_end x e f -> False.
Proof.
  intros proper_f parallel (a & b & (s & [s0 s1] & ax & ay) & (t & [t0 t1] & bx & by_) & x_is & y_is)
    (not_1 & not_2 & not_3 & not_4).
  destruct (multiple_of (along e) (along f) proper_f parallel) as (r & along_x & along_y).
  destruct e as [e1 e2], f as [f1 f2]. unfold along, plus, minus, lies_on in *. cbn [source target vx vy] in *.
  clear proper_f parallel. set (fx := vx f2 - vx f1) in *. set (fy := vy f2 - vy f1) in *.
  assert (x_value : vx x - vx e1 == vx f1 + (t + s * r) * fx) by (unfold fx in *; by_equations).
  assert (y_value : vy x - vy e1 == vy f1 + (t + s * r) * fy) by (unfold fy in *; by_equations).
  (* Where the ends of e, moved, are along f. *)
  assert (out_1 : ~ 0 <= t + s * r <= 1).
  { intros range. apply not_1. exists (t + s * r). split; [exact range |].
    split; [rewrite x_value; unfold fx; ring | rewrite y_value; unfold fy; ring]. }
  assert (some_r : ~ r == 0) by (intros zero_r; rewrite zero_r in out_1; apply out_1; lra).
  (* An end of f is along e. *)
  assert (on_e : forall u k : Q, 0 <= u <= 1 -> u * r == s * r + k ->
            vx x - vx e1 - (vx f1 + (t - k) * fx) == u * (vx e2 - vx e1) /\
            vy x - vy e1 - (vy f1 + (t - k) * fy) == u * (vy e2 - vy e1)).
  { intros u k _ equal. rewrite x_value, y_value, along_x, along_y. split; by_equations. }
  destruct (Qlt_le_dec (t + s * r) 0) as [below | above].
  - assert (r < 0) by nra.
    assert (quotient : t / r * r == t) by (field; lra). set (k := t / r) in *.
    assert (k <= 0) by (clearbody k; nra). assert (0 <= s + k) by (clearbody k; nra).
    apply not_3. exists (s + k). clearbody k.
    destruct (on_e (s + k) t) as [X Y]; [lra | lra |].
    split; [lra |]. split; [lra | lra].
  - assert (over : 1 < t + s * r) by (destruct (Qlt_le_dec 1 (t + s * r)); [assumption | exfalso; lra]).
    assert (0 < r) by nra.
    assert (quotient : (1 - t) / r * r == 1 - t) by (field; lra). set (k := (1 - t) / r) in *.
    assert (0 <= k) by (clearbody k; nra). assert (k <= s) by (clearbody k; nra).
    apply not_4. exists (s - k). clearbody k.
    destruct (on_e (s - k) (t - 1)) as [X Y]; [lra | lra |].
    split; [lra |]. unfold fx, fy in *. split; lra.
Qed.

(* Such an x is on no side of the parallelogram. *)
Lemma off_parallelogram (x : vector) (e f : segment) : not_sum_of_an_end x e f -> off x (parallelogram e f).
Proof.
  intros (not_1 & not_2 & not_3 & not_4).
  assert (backwards : forall w u v, lies_on w (Segment v u) -> lies_on w (Segment u v)).
  { intros w u v (k & range & X & Y). exists (1 - k). cbn [source target] in *.
    split; [lra |]. split; [rewrite X | rewrite Y]; ring. }
  intros side I on. cbn in I. destruct I as [<- | [<- | [<- | [<- | []]]]].
  - apply not_3. destruct on as (k & range & X & Y). exists k. cbn in *. split; [exact range |]. split; lra.
  - apply not_2. destruct on as (k & range & X & Y). exists k. cbn in *. split; [exact range |]. split; lra.
  - apply backwards in on. apply not_4. destruct on as (k & range & X & Y). exists k. cbn in *.
    split; [exact range |]. split; lra.
  - apply backwards in on. apply not_1. destruct on as (k & range & X & Y). exists k. cbn in *.
    split; [exact range |]. split; lra.
Qed.

Lemma negative_is_true (u : Q) : u < 0 -> negative u = true.
Proof. intros below. destruct (negative_spec u); [reflexivity | exfalso; lra]. Qed.

Lemma negative_is_false (u : Q) : 0 <= u -> negative u = false.
Proof. intros above. destruct (negative_spec u); [exfalso; lra | reflexivity]. Qed.

Lemma orientation_is (a b c : vector) (u : Q) :
  u == cross (minus b a) (minus c a) -> orientation a b c = (u ?= 0).
Proof.
  intros equal. unfold orientation. apply compare_as_difference. rewrite equal.
  unfold cross, minus; cbn. ring.
Qed.

Lemma positive_comparison (u : Q) : 0 < u -> (u ?= 0) = Gt.
Proof. apply (proj1 (Qgt_alt u 0)). Qed.

Lemma negative_comparison (u : Q) : u < 0 -> (u ?= 0) = Lt.
Proof. apply (proj1 (Qlt_alt u 0)). Qed.

(* Theorem. If x is the sum of a point of e and a point of f, and not the sum of an end of one of them and a point
   of the other, then e and f are not parallel, and the boundary of their sum goes round x once, in the
   direction in which f turns from e. *)
Theorem crossing_edges_count (x : vector) (e f : segment) :
  nonzero (along e) -> nonzero (along f) -> is_sum_of_points x e f -> not_sum_of_an_end x e f ->
  (0 < cross (along e) (along f) /\ winding_number x (parallelogram e f) = 1%Z) \/
  (cross (along e) (along f) < 0 /\ winding_number x (parallelogram e f) = (-1)%Z).
Proof.
  intros proper_e proper_f is_sum no_end.
  assert (turn : ~ cross (along e) (along f) == 0)
    by (intros parallel; exact (parallel_sums x e f proper_f parallel is_sum no_end)).
  destruct is_sum as (a & b & (s & [s0 s1] & ax & ay) & (t & [t0 t1] & bx & by_) & x_is & y_is).
  assert (off_boundary : off x (parallelogram e f)) by now apply off_parallelogram.
  (* x is inside, not on a side. *)
  assert (s_inside : 0 < s < 1).
  { destruct no_end as (not_1 & not_2 & _). split; apply Qnot_le_lt; intros extreme.
    - apply not_1. exists t. assert (s == 0) as s_is by lra. unfold minus; cbn [vx vy].
      split; [lra |]. rewrite x_is, y_is. unfold plus; cbn [vx vy]. rewrite ax, ay, bx, by_, s_is. split; ring.
    - apply not_2. exists t. assert (s == 1) as s_is by lra. unfold minus; cbn [vx vy].
      split; [lra |]. rewrite x_is, y_is. unfold plus; cbn [vx vy]. rewrite ax, ay, bx, by_, s_is. split; ring. }
  assert (t_inside : 0 < t < 1).
  { destruct no_end as (_ & _ & not_3 & not_4). split; apply Qnot_le_lt; intros extreme.
    - apply not_3. exists s. assert (t == 0) as t_is by lra. unfold minus; cbn [vx vy].
      split; [lra |]. rewrite x_is, y_is. unfold plus; cbn [vx vy]. rewrite ax, ay, bx, by_, t_is. split; ring.
    - apply not_4. exists s. assert (t == 1) as t_is by lra. unfold minus; cbn [vx vy].
      split; [lra |]. rewrite x_is, y_is. unfold plus; cbn [vx vy]. rewrite ax, ay, bx, by_, t_is. split; ring. }
  clear no_end s0 s1 t0 t1.
  (* A ray along e crosses the two sides along f only. *)
  rewrite <- (winding_number_by_any_ray x (parallelogram e f) OfQ (along e) (closed_chain_cycles _) off_boundary
    proper_e).
  set (D := cross (along e) (along f)) in *.
  unfold plus in x_is, y_is; cbn [vx vy] in x_is, y_is. rewrite ax, bx in x_is. rewrite ay, by_ in y_is.
  clear off_boundary ax ay bx by_ a b.
  unfold winding_number_by_ray, parallelogram, edges, signed_crossing_of_ray, left_of_ray.
  cbn [rotated app combine map fst snd sum fold_right source target].
  set (base := plus (source e) (source f)). set (after_e := plus (target e) (source f)).
  set (far := plus (target e) (target f)). set (after_f := plus (source e) (target f)).
  assert (low : cross (minus base x) (along e) == t * D /\ cross (minus after_e x) (along e) == t * D)
    by (unfold base, after_e, along, D, along, plus, minus, cross; cbn [vx vy]; rewrite x_is, y_is; split; ring).
  assert (high : cross (minus far x) (along e) == - ((1 - t) * D) /\
                 cross (minus after_f x) (along e) == - ((1 - t) * D))
    by (unfold far, after_f, along, D, along, plus, minus, cross; cbn [vx vy]; rewrite x_is, y_is; split; ring).
  assert (up : (1 - s) * D == cross (minus far after_e) (minus x after_e))
    by (unfold far, after_e, along, D, along, plus, minus, cross; cbn [vx vy]; rewrite x_is, y_is; ring).
  assert (down : s * D == cross (minus base after_f) (minus x after_f))
    by (unfold base, after_f, along, D, along, plus, minus, cross; cbn [vx vy]; rewrite x_is, y_is; ring).
  rewrite (same_negative _ _ (proj1 low)), (same_negative _ _ (proj2 low)), (same_negative _ _ (proj1 high)),
    (same_negative _ _ (proj2 high)), (orientation_is _ _ _ _ up), (orientation_is _ _ _ _ down).
  destruct (Q_dec D 0) as [[right_turn | left_turn] | no_turn]; [right | left | now destruct turn].
  - split; [exact right_turn |].
    rewrite (negative_is_true (t * D)), (negative_is_false (- ((1 - t) * D))),
      (negative_comparison ((1 - s) * D)), (negative_comparison (s * D)) by nra.
    reflexivity.
  - split; [exact left_turn |].
    rewrite (negative_is_false (t * D)), (negative_is_true (- ((1 - t) * D))),
      (positive_comparison ((1 - s) * D)), (positive_comparison (s * D)) by nra.
    reflexivity.
Qed.
