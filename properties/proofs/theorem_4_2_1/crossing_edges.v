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
  clear proper_f parallel.
  (* It is the sum of other points, too, until one is an end. *)
  assert (sum_at : forall s' t', 0 <= s' <= 1 -> 0 <= t' <= 1 -> t' == t + (s - s') * r ->
    s' == 0 \/ t' == 0 \/ t' == 1 -> False).
  { intros s' t' s_range t_range t_is.
    assert (X : vx x == (1 - s') * vx e1 + s' * vx e2 + ((1 - t') * vx f1 + t' * vx f2)) by by_equations.
    assert (Y : vy x == (1 - s') * vy e1 + s' * vy e2 + ((1 - t') * vy f1 + t' * vy f2)) by by_equations.
    intros [at_ | [at_ | at_]]; rewrite at_ in X, Y;
      [apply not_1; exists t' | apply not_3; exists s' | apply not_4; exists s']; repeat split; lra. }
  destruct (Qlt_le_dec (t + s * r) 0) as [below |]; [| destruct (Qlt_le_dec 1 (t + s * r)) as [above |]].
  - assert (r < 0) by nra. assert (quotient : t / r * r == t) by (field; lra). set (k := t / r) in *. clearbody k.
    apply (sum_at (s + k) 0); [split; nra | lra | lra | right; left; reflexivity].
  - assert (0 < r) by nra. assert (quotient : (1 - t) / r * r == 1 - t) by (field; lra). set (k := (1 - t) / r) in *.
    clearbody k. apply (sum_at (s - k) 1); [split; nra | lra | lra | right; right; reflexivity].
  - apply (sum_at 0 (t + s * r)); [lra | lra | ring | left; reflexivity].
Qed.

(* Such an x is on no side of the parallelogram. *)
Lemma off_parallelogram (x : vector) (e f : segment) : not_sum_of_an_end x e f -> off x (parallelogram e f).
Proof.
  intros (not_1 & not_2 & not_3 & not_4) side I (k & range & X & Y). cbn in I.
  destruct I as [<- | [<- | [<- | [<- | []]]]]; cbn in X, Y;
    [apply not_3; exists k | apply not_2; exists k | apply not_4; exists (1 - k) | apply not_1; exists (1 - k)];
    unfold minus; cbn [vx vy]; repeat split; lra.
Qed.

(* What the four edges add where x is to the left of all of them. *)
Lemma four_crossings_inside (u v k b c d : Q) :
  0 < b < d -> 0 < c < d -> ~ (u == 0 /\ v == 0) -> d * k == c * u + b * v -> four_crossings u v k b c d = 1%Z.
Proof.
  intros range_b range_c some height. unfold four_crossings.
  rewrite (proj1 (Qgt_alt b 0)), (proj1 (Qgt_alt c 0)), (proj1 (Qgt_alt (d - b) 0)), (proj1 (Qgt_alt (d - c) 0)) by lra.
  destruct (at_most_spec 0 k), (at_most_spec u k), (at_most_spec (u + v) k), (at_most_spec v k); try reflexivity;
    exfalso; try lra; assert (u < 0 \/ 0 < u \/ v < 0 \/ 0 < v) as signs by lra; clear some;
    destruct (Qlt_le_dec 0 u), (Qlt_le_dec 0 v); destruct signs as [? | [? | [? | ?]]]; nra.
Qed.

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
  destruct is_sum as (a & b & on_e & on_f & x_is & y_is), no_end as (not_1 & not_2 & not_3 & not_4).
  assert (moved : forall v w s, equal_vectors x (plus v w) -> lies_on w s -> lies_on (minus x v) s).
  { intros v w s [X Y]. apply lies_on_equal. unfold equal_vectors, plus, minus in *. cbn [vx vy] in *. lra. }
  unfold plus in *. cbn [vx vy] in *.
  (* x is inside, not on a side. *)
  destruct (inside_or_end a e on_e) as [(s & s_range & ax & ay) | [[ax ay] | [ax ay]]];
    [| elim not_1 | elim not_2]; [| apply (moved _ b); [split; cbn [vx vy]; lra | exact on_f] ..].
  destruct (inside_or_end b f on_f) as [(t & t_range & bx & by_) | [[bx by_] | [bx by_]]];
    [| elim not_3 | elim not_4]; [| apply (moved _ a); [split; cbn [vx vy]; lra | exact on_e] ..].
  rewrite winding_number_of_parallelogram. set (z := minus x _). set (d := cross (along e) (along f)) in *.
  assert (values : cross (along e) z == t * d /\ cross z (along f) == s * d /\
    vy z == s * vy (along e) + t * vy (along f))
    by (unfold z, d, along, plus, minus, cross; cbn [vx vy]; rewrite x_is, y_is, ax, ay, bx, by_; repeat split; ring).
  destruct values as (b_is & c_is & k_is).
  assert (some : ~ (vy (along e) == 0 /\ vy (along f) == 0))
    by (intros [e_flat f_flat]; apply turn; unfold d, cross; rewrite e_flat, f_flat; ring).
  destruct (Q_dec d 0) as [[right_turn | left_turn] | no_turn]; [right | left | now destruct turn].
  - split; [exact right_turn |].
    assert (one : four_crossings (vy (along f)) (vy (along e)) (vy z)
                    (- cross z (along f)) (- cross (along e) z) (- d) = 1%Z)
      by (apply four_crossings_inside; rewrite ?b_is, ?c_is, ?k_is; [nra | nra | tauto | ring]).
    rewrite other_way_round in one. lia.
  - split; [exact left_turn |]. apply four_crossings_inside; rewrite ?b_is, ?c_is, ?k_is; [nra | nra | tauto | ring].
Qed.
