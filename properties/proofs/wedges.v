(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The wedge of a vertex, in which its region is: the directions from the edge that leaves it counterclockwise to
   the edge that enters it, reversed. If no segment of the convolution is at a vertex of P and a vertex of Q,
   or along an edge of one through a vertex of the other, then the wedges of P and -Q there overlap. The local
   part of Theorem 4.2.1 at points of the vertex-edge sum. *)
From Coq Require Import QArith Qminmax Lqa Bool.
From Oplus Require Import direction angle cyclic_order rotation tangent_set sweep weight.

Open Scope Q_scope.

Definition in_wedge (u : vector) (c : corner) : bool := ccw_of_vectors u (outgoing c) (opposite (incoming c)).

(* From x counterclockwise to z, y is met before. *)
Definition arc (x y z : Q) : Prop := (x < y /\ y < z) \/ (y < z /\ z < x) \/ (z < x /\ x < y).

Lemma in_arc (d from to : vector) :
  nonzero d -> nonzero from -> nonzero to ->
  reflect (arc (angle from) (angle d) (angle to)) (ccw_of_vectors d from to).
Proof.
  intros proper_d proper_from proper_to. unfold ccw_of_vectors.
  destruct (ccw_spec (Direction d OfP) (Direction from OfP) (Direction to OfP) proper_d proper_from proper_to)
    as [met | not_met]; constructor; unfold in_order, earlier, place, arc in *; cbn [vec of] in *; lra.
Qed.

Lemma number_just_after (x y z : Q) :
  0 <= x < 4 -> 0 <= y < 4 -> 0 <= z < 4 -> ~ x == y -> ~ x == z ->
  exists t, 0 <= t < 4 /\ arc x t y /\ arc x t z.
Proof.
  intros x_range y_range z_range not_y not_z. unfold arc.
  set (y_after := if Qlt_le_dec x y then y else 4). set (z_after := if Qlt_le_dec x z then z else 4).
  assert (after : x < Qmin y_after z_after).
  { unfold y_after, z_after. destruct (Qlt_le_dec x y), (Qlt_le_dec x z); apply Q.min_glb_lt; lra. }
  pose proof (Q.le_min_l y_after z_after) as at_most_y. pose proof (Q.le_min_r y_after z_after) as at_most_z.
  set (least := Qmin y_after z_after) in *. clearbody least.
  exists ((1 # 2) * (x + least)). unfold y_after, z_after in *.
  destruct (Qlt_le_dec x y), (Qlt_le_dec x z); repeat split; lra.
Qed.

(* Between v and two others, counterclockwise, is something. *)
Lemma just_after (v w w' : vector) :
  nonzero v -> nonzero w -> nonzero w' -> ~ angle v == angle w -> ~ angle v == angle w' ->
  exists u, nonzero u /\ arc (angle v) (angle u) (angle w) /\ arc (angle v) (angle u) (angle w').
Proof.
  intros proper_v proper_w proper_w' not_w not_w'.
  destruct (number_just_after (angle v) (angle w) (angle w')) as (t & range & before_w & before_w');
    try apply angle_range; trivial.
  assert (angle_is : angle (diamond t) == t) by (apply (angle_diamond _ t 1); trivial; lra || ring).
  exists (diamond t). split; [now apply diamond_nonzero |]. unfold arc in *. lra.
Qed.

(* Angles seen from another one. *)
Definition from_angle (a x : Q) : Q := if Qlt_le_dec x a then x - a + 4 else x - a.

Lemma arc_from_angle (a x y z : Q) :
  0 <= a < 4 -> 0 <= x < 4 -> 0 <= y < 4 -> 0 <= z < 4 ->
  arc x y z <-> arc (from_angle a x) (from_angle a y) (from_angle a z).
Proof.
  intros ra rx ry rz. unfold arc, from_angle.
  destruct (Qlt_le_dec x a), (Qlt_le_dec y a), (Qlt_le_dec z a); lra.
Qed.

Lemma from_angle_range (a x : Q) : 0 <= a < 4 -> 0 <= x < 4 -> 0 <= from_angle a x < 4.
Proof. intros ra rx. unfold from_angle. destruct (Qlt_le_dec x a); lra. Qed.

Lemma from_angle_equal (a x y : Q) : 0 <= a < 4 -> 0 <= x < 4 -> 0 <= y < 4 ->
  x == y <-> from_angle a x == from_angle a y.
Proof. intros ra rx ry. unfold from_angle. destruct (Qlt_le_dec x a), (Qlt_le_dec y a); lra. Qed.

Lemma from_angle_opposite (a x y : Q) : 0 <= a < 4 -> 0 <= x < 4 -> 0 <= y < 4 ->
  y == x + 2 \/ y == x - 2 -> from_angle a y == from_angle a x + 2 \/ from_angle a y == from_angle a x - 2.
Proof. intros ra rx ry opposite_. unfold from_angle. destruct (Qlt_le_dec x a), (Qlt_le_dec y a); lra. Qed.

(* Seen from the first. *)
Lemma arcs_overlap_from_zero (a b c d a' d' : Q) :
  a == 0 -> 0 <= b < 4 -> 0 <= c < 4 -> 0 <= d < 4 -> 0 <= a' < 4 -> 0 <= d' < 4 ->
  (a' == a + 2 \/ a' == a - 2) -> (d' == d + 2 \/ d' == d - 2) ->
  ~ b == a' -> ~ d' == c -> ~ a == c -> ~ a == d -> ~ b == c -> ~ b == d ->
  ~ arc c a d -> ~ arc a c b -> ~ arc a d b ->
  b == d' \/ arc d' b c \/ arc b d' a'.
Proof.
  intros zero_ rb rc rd ra' rd' opposite_a opposite_d turn_p turn_q ac ad bc bd na nc nd.
  assert (c <= d) by (unfold arc in na; lra). assert (b < c) by (unfold arc in nc; lra).
  clear na nc nd. unfold arc.
  destruct opposite_a as [opposite_a | opposite_a]; [| exfalso; lra].
  destruct opposite_d as [opposite_d | opposite_d]; [lra |].
  destruct (Q_dec b d') as [[before | after] | equal]; lra.
Qed.

(* Directions a, b and c, d of two corners, no two of different corners equal; a' is opposite to a, d' to d. If none
   is between those of the other corner, the arcs from b to a' and from d' to c overlap. *)
Lemma arcs_overlap (a b c d a' d' : Q) :
  0 <= a < 4 -> 0 <= b < 4 -> 0 <= c < 4 -> 0 <= d < 4 -> 0 <= a' < 4 -> 0 <= d' < 4 ->
  (a' == a + 2 \/ a' == a - 2) -> (d' == d + 2 \/ d' == d - 2) ->
  ~ b == a' -> ~ d' == c -> ~ a == c -> ~ a == d -> ~ b == c -> ~ b == d ->
  ~ arc c a d -> ~ arc a c b -> ~ arc a d b ->
  b == d' \/ arc d' b c \/ arc b d' a'.
Proof.
  intros ra rb rc rd ra' rd' opposite_a opposite_d turn_p turn_q ac ad bc bd na nc nd.
  rewrite (arc_from_angle a) in na, nc, nd by assumption. rewrite (from_angle_equal a) in turn_p, turn_q, ac, ad, bc, bd by assumption.
  rewrite (from_angle_equal a b d'), (arc_from_angle a d' b c), (arc_from_angle a b d' a') by assumption.
  assert (start : from_angle a a == 0) by (unfold from_angle; destruct (Qlt_le_dec a a); lra).
  apply (arcs_overlap_from_zero (from_angle a a) (from_angle a b) (from_angle a c) (from_angle a d)
    (from_angle a a') (from_angle a d')); trivial; try (apply from_angle_range; assumption);
    apply from_angle_opposite; assumption.
Qed.

Lemma not_between (d : direction) (from to : vector) :
  proper d -> nonzero from -> nonzero to ->
  ~ angle from == angle (vec d) -> ~ angle to == angle (vec d) ->
  ccw d (Direction from (other (of d))) (Direction to (other (of d))) = false ->
  ~ arc (angle from) (angle (vec d)) (angle to).
Proof.
  intros proper_d proper_from proper_to not_from not_to not_met between_.
  destruct (ccw_spec d (Direction from (other (of d))) (Direction to (other (of d))) proper_d proper_from proper_to)
    as [met | no]; [discriminate |].
  apply no. unfold in_order, earlier, arc in *. cbn [vec] in *. clear no not_met. lra.
Qed.

Lemma no_turning_back (u v : vector) : turns u v -> ~ angle v == angle (opposite u).
Proof.
  intros (proper_u & proper_v & turn) back.
  pose proof (cross_angle u v proper_u proper_v) as u_v. pose proof (opposite_angle u proper_u).
  unfold turns_by in u_v. lra.
Qed.

Lemma in_wedge_by_arc (u : vector) (c : corner) :
  nonzero u -> nonzero (incoming c) -> nonzero (outgoing c) ->
  arc (angle (outgoing c)) (angle u) (angle (opposite (incoming c))) -> in_wedge u c = true.
Proof.
  intros proper_u proper_in proper_out between_. unfold in_wedge.
  destruct (in_arc u (outgoing c) (opposite (incoming c)) proper_u proper_out (opposite_nonzero _ proper_in));
    [reflexivity | contradiction].
Qed.

Lemma opposite_arc (x y z x' y' z' : Q) :
  0 <= x < 4 -> 0 <= y < 4 -> 0 <= z < 4 -> 0 <= x' < 4 -> 0 <= y' < 4 -> 0 <= z' < 4 ->
  (x' == x + 2 \/ x' == x - 2) -> (y' == y + 2 \/ y' == y - 2) -> (z' == z + 2 \/ z' == z - 2) ->
  arc x y z -> arc x' y' z'.
Proof. intros rx ry rz rx' ry' rz' ox oy oz. unfold arc. destruct ox, oy, oz; lra. Qed.

(* An arc that starts inside another, or with it, has something in common with it at the start. *)
Lemma arc_within (x y z t : Q) : x == y \/ arc x y z -> arc y t z -> arc x t z.
Proof. unfold arc. intros [equal | between_]; lra. Qed.

(* Theorem. Take a vertex of P and one of Q at neither of which the chain turns back, and no edge of the one with the
   direction of an edge of the other. If no segment of the convolution is at the state, then some direction is in the
   wedge of P's vertex and its opposite in that of Q's. The same for points inside edges, with the edge on both sides
   of the point. *)
Theorem wedges_overlap (of_p of_q : corner) :
  turns (incoming of_p) (outgoing of_p) -> turns (incoming of_q) (outgoing of_q) ->
  ~ angle (incoming of_p) == angle (incoming of_q) -> ~ angle (incoming of_p) == angle (outgoing of_q) ->
  ~ angle (outgoing of_p) == angle (incoming of_q) -> ~ angle (outgoing of_p) == angle (outgoing of_q) ->
  in_tangent_set (Direction (incoming of_p) OfP) of_q = false ->
  in_tangent_set (Direction (incoming of_q) OfQ) of_p = false ->
  in_tangent_set (Direction (outgoing of_q) OfQ) of_p = false ->
  exists u, nonzero u /\ in_wedge u of_p = true /\ in_wedge (opposite u) of_q = true.
Proof.
  destruct of_p as [a b], of_q as [c d]. cbn [incoming outgoing].
  intros turn_p turn_q ac ad bc bd na nc nd.
  pose proof (no_turning_back a b turn_p) as not_back_p. pose proof (no_turning_back c d turn_q) as not_back_q.
  destruct turn_p as (proper_a & proper_b & _). destruct turn_q as (proper_c & proper_d & _).
  assert (na' : ~ arc (angle c) (angle a) (angle d)).
  { apply (not_between (Direction a OfP)); cbn [vec]; trivial; intros equal; [apply ac | apply ad]; now symmetry. }
  assert (nc' : ~ arc (angle a) (angle c) (angle b)) by (apply (not_between (Direction c OfQ)); cbn [vec]; trivial).
  assert (nd' : ~ arc (angle a) (angle d) (angle b)) by (apply (not_between (Direction d OfQ)); cbn [vec]; trivial).
  clear na nc nd.
  pose proof (opposite_nonzero a proper_a) as proper_a'. pose proof (opposite_nonzero d proper_d) as proper_d'.
  pose proof (opposite_nonzero c proper_c) as proper_c'.
  pose proof (opposite_angle a proper_a) as opposite_a. pose proof (opposite_angle d proper_d) as opposite_d.
  pose proof (opposite_angle c proper_c) as opposite_c.
  assert (not_back_q' : ~ angle (opposite d) == angle c).
  { pose proof (angle_range c proper_c) as rc. pose proof (angle_range d proper_d) as rd.
    pose proof (angle_range _ proper_c') as rc'. pose proof (angle_range _ proper_d') as rd'.
    clear - not_back_q opposite_c opposite_d rc rd rc' rd'. lra. }
  assert (found : exists u, nonzero u /\ arc (angle b) (angle u) (angle (opposite a)) /\
    arc (angle (opposite d)) (angle u) (angle c)).
  { destruct (arcs_overlap (angle a) (angle b) (angle c) (angle d) (angle (opposite a)) (angle (opposite d)))
      as [start | [start | start]]; try (apply angle_range; assumption); trivial.
    - destruct (just_after b (opposite a) c) as (u & proper_u & first & second); trivial.
      exists u. split; [exact proper_u |]. split; [exact first |].
      apply (arc_within _ (angle b)); [left; now symmetry | exact second].
    - destruct (just_after b (opposite a) c) as (u & proper_u & first & second); trivial.
      exists u. split; [exact proper_u |]. split; [exact first |].
      apply (arc_within _ (angle b)); [now right | exact second].
    - destruct (just_after (opposite d) (opposite a) c) as (u & proper_u & first & second); trivial.
      { intros equal. unfold arc in start. clear - start equal. lra. }
      exists u. split; [exact proper_u |]. split; [| exact second].
      apply (arc_within _ (angle (opposite d))); [now right | exact first]. }
  destruct found as (u & proper_u & in_p & in_q). exists u. split; [exact proper_u |]. split.
  - now apply in_wedge_by_arc.
  - pose proof (opposite_nonzero u proper_u) as proper_u'. apply in_wedge_by_arc; trivial. cbn [incoming outgoing].
    apply (opposite_arc (angle (opposite d)) (angle u) (angle c)); try (apply angle_range; assumption); trivial.
    + clear - opposite_d. lra.
    + now apply opposite_angle.
Qed.
