(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The weight w(e, f) that a pair of edges, e of P and f of Q, has in a direction d (docs/winding.md): 1 or
   -1, the sign of their skew product, if d is a tangent direction where e crosses -f, else 0. Tangent sets are
   differences of weights, up to terms of one vertex. ccw and labels are those of direction.v, their order is
   that of cyclic_order.v, and ccw as a difference is from angular_crossings.v. *)
From Coq Require Import ZArith Lia Bool.
From Oplus Require Import numbers winding tangent_set forward_traversal.

Open Scope Z_scope.

(* d is labelled as Q's and compared with edges of P, -d is labelled as P's and compared with edges of Q:
   so no tie is open. *)
Definition weight (d e f : vector) : Z :=
  Z.b2z (before (Direction e OfP) (Direction f OfQ)) - Z.b2z (before (Direction e OfP) (Direction d OfQ)) +
  Z.b2z (before (Direction f OfQ) (Direction (opposite d) OfP)) -
  Z.b2z (before (Direction d OfQ) (Direction (opposite d) OfP)).

Lemma opposite_angle (v : vector) : nonzero v ->
  (angle (opposite v) == angle v + 2 \/ angle (opposite v) == angle v - 2)%Q.
Proof.
  intros n. pose proof (cross_angle v (opposite v) n (opposite_nonzero v n)) as turn.
  assert (cross v (opposite v) == 0)%Q as along by (unfold cross, opposite; cbn; ring).
  assert (dot v (opposite v) <= 0)%Q as back
    by (unfold dot, opposite; cbn; nra).
  unfold turns_by in turn. lra.
Qed.

(* As ccw_as_difference, for equal edges too. *)
Lemma in_tangent_set_as_difference (d : direction) (c : corner) :
  proper d -> proper_corner c ->
  Z.b2z (in_tangent_set d c) =
  Z.b2z (before (Direction (incoming c) (other (of d))) d) -
  Z.b2z (before (Direction (outgoing c) (other (of d))) d) +
  Z.b2z (before (Direction (outgoing c) (other (of d))) (Direction (incoming c) (other (of d)))).
Proof.
  intros proper_d [proper_in proper_out]. unfold in_tangent_set.
  set (u := Direction (incoming c) (other (of d))). set (v := Direction (outgoing c) (other (of d))).
  assert (proper_u : proper u) by exact proper_in. assert (proper_v : proper v) by exact proper_out.
  assert (labels : of u <> of d /\ of v <> of d)
    by (unfold u, v; cbn [of]; destruct (of d); split; discriminate).
  destruct (compare_equal u v proper_u proper_v) as [e | apart]; [| now apply ccw_as_difference].
  destruct (ccw_of_equal u v d d proper_u proper_v proper_d proper_d e) as [-> _].
  destruct (before_equal u v d proper_u proper_v proper_d e) as [-> _].
  destruct (before_spec v u proper_v proper_u); [exfalso; order | cbn; lia].
Qed.

(* Whether an edge of P is in a tangent set of Q is whether -d is, plus a difference of weights. *)
Lemma p_in_tangent_set (d e : vector) (c : corner) :
  nonzero d -> nonzero e -> proper_corner c ->
  Z.b2z (in_tangent_set (Direction e OfP) c) =
  Z.b2z (in_tangent_set (Direction (opposite d) OfP) c) + weight d e (outgoing c) - weight d e (incoming c).
Proof.
  intros proper_d proper_e proper_c. pose proof (opposite_nonzero d proper_d) as proper_o.
  rewrite !in_tangent_set_as_difference by assumption. unfold weight. cbn [of other].
  destruct proper_c as [proper_in proper_out].
  rewrite !(before_other_way (Direction e OfP)) by (trivial; discriminate). lia.
Qed.

(* Whether an edge of Q is in a tangent set of P is whether d is, less a difference of weights. *)
Lemma q_in_tangent_set (d f : vector) (c : corner) :
  nonzero d -> nonzero f -> proper_corner c ->
  Z.b2z (in_tangent_set (Direction f OfQ) c) =
  Z.b2z (in_tangent_set (Direction d OfQ) c) + weight d (incoming c) f - weight d (outgoing c) f.
Proof.
  intros proper_d proper_f proper_c.
  rewrite !in_tangent_set_as_difference by assumption. unfold weight. cbn [of other]. lia.
Qed.

(* Theorem. The weight has the sign of the edges' skew product, and is at most 1 in size. *)
Theorem weight_has_the_sign_of_the_skew_product (d e f : vector) :
  nonzero d -> nonzero e -> nonzero f ->
  ((0 < cross e f)%Q -> 0 <= weight d e f <= 1) /\ ((cross e f < 0)%Q -> -1 <= weight d e f <= 0).
Proof.
  intros proper_d proper_e proper_f. pose proof (opposite_nonzero d proper_d) as proper_o.
  pose proof (cross_angle e f proper_e proper_f) as turn. unfold turns_by in turn.
  pose proof (opposite_angle d proper_d) as half_turn.
  pose proof (angle_range d proper_d). pose proof (angle_range e proper_e).
  pose proof (angle_range f proper_f). pose proof (angle_range (opposite d) proper_o).
  unfold weight.
  destruct (before_spec (Direction e OfP) (Direction f OfQ) proper_e proper_f),
    (before_spec (Direction e OfP) (Direction d OfQ) proper_e proper_d),
    (before_spec (Direction f OfQ) (Direction (opposite d) OfP) proper_f proper_o),
    (before_spec (Direction d OfQ) (Direction (opposite d) OfP) proper_d proper_o);
    unfold earlier, place in *; cbn [vec of Z.b2z] in *; split; intros sign; try lia; exfalso; lra.
Qed.

(* Theorem. In the direction e - f the weight is that sign. *)
Theorem weight_in_the_direction_of_the_difference (e f : vector) :
  nonzero e -> nonzero f ->
  ((0 < cross e f)%Q -> weight (minus e f) e f = 1) /\ ((cross e f < 0)%Q -> weight (minus e f) e f = -1).
Proof.
  intros proper_e proper_f.
  enough (turning : ~ (cross e f == 0)%Q ->
    ((0 < cross e f)%Q -> weight (minus e f) e f = 1) /\ ((cross e f < 0)%Q -> weight (minus e f) e f = -1))
    by (split; intros sign; apply turning; lra).
  intros turn. set (d := minus e f).
  assert (e_to_d : (cross e d == - cross e f)%Q) by (unfold d, cross, minus; cbn; ring).
  assert (f_to_d : (cross f d == - cross e f)%Q) by (unfold d, cross, minus; cbn; ring).
  assert (proper_d : nonzero d).
  { intros [x y]. apply turn. apply Qopp_comp in e_to_d. unfold cross in e_to_d at 1.
    rewrite x, y in e_to_d. lra. }
  clearbody d. pose proof (opposite_nonzero d proper_d) as proper_o.
  pose proof (cross_angle e f proper_e proper_f) as e_f. pose proof (cross_angle e d proper_e proper_d) as e_d.
  pose proof (cross_angle f d proper_f proper_d) as f_d. pose proof (opposite_angle d proper_d) as half_turn.
  pose proof (angle_range d proper_d). pose proof (angle_range e proper_e).
  pose proof (angle_range f proper_f). pose proof (angle_range (opposite d) proper_o).
  unfold turns_by in *. unfold weight.
  destruct (before_spec (Direction e OfP) (Direction f OfQ) proper_e proper_f),
    (before_spec (Direction e OfP) (Direction d OfQ) proper_e proper_d),
    (before_spec (Direction f OfQ) (Direction (opposite d) OfP) proper_f proper_o),
    (before_spec (Direction d OfQ) (Direction (opposite d) OfP) proper_d proper_o);
    unfold earlier, place in *; cbn [vec of Z.b2z] in *; split; intros sign; try reflexivity; exfalso; lra.
Qed.
