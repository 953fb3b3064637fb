(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The segments that the ray to the right of a point meets, by their heights, and the first of them; and chains that
   have no point in common with others, along which the winding number by these is the same. *)
From Coq Require Import ZArith Lia Bool List.
From Oplus Require Import numbers winding signed_crossings meeting_of_segments.
Import ListNotations.

Open Scope Q_scope.

(* Of finitely many numbers one is the least. *)
Lemma least_of {A : Type} (f : A -> Q) (l : list A) : l <> [] -> exists b, In b l /\ forall c, In c l -> f b <= f c.
Proof.
  induction l as [| b l IH]; intros some; [contradiction |].
  destruct l as [| c l]; [exists b; split; [now left | intros e [<- | []]; lra] |].
  destruct IH as (least & listed & below); [discriminate |].
  destruct (Qlt_le_dec (f least) (f b)).
  - exists least. split; [now right |]. intros e [<- | I]; [lra | now apply below].
  - exists b. split; [now left |]. intros e [<- | I]; [lra |]. specialize (below e I). lra.
Qed.

(* The point of a segment's line at a height. *)
Definition point_at_height (s : segment) (y : Q) : vector :=
  Vector (vx (source s) + (y - vy (source s)) / (vy (target s) - vy (source s)) *
            (vx (target s) - vx (source s))) y.

(* Whether exactly one end of a segment is at most at this height. *)
Definition spans (s : segment) (y : Q) : bool :=
  xorb (at_most (vy (source s)) y) (at_most (vy (target s)) y).

Lemma heights_of_spanning (s : segment) (y : Q) : spans s y = true ->
  vy (source s) <= y < vy (target s) \/ vy (target s) <= y < vy (source s).
Proof.
  unfold spans. destruct (at_most_spec (vy (source s)) y), (at_most_spec (vy (target s)) y);
    try discriminate; intros _; lra.
Qed.

Lemma point_at_height_lies_on (s : segment) (y : Q) : spans s y = true -> lies_on (point_at_height s y) s.
Proof.
  intros spanning. apply heights_of_spanning in spanning.
  exists ((y - vy (source s)) / (vy (target s) - vy (source s))). split; [| split].
  - assert (fraction : (y - vy (source s)) / (vy (target s) - vy (source s)) ==
      (vy (source s) - y) / ((vy (source s) - y) - (vy (target s) - y))) by (field; lra).
    rewrite fraction. apply fraction_between; lra.
  - cbn. ring.
  - cbn. field. lra.
Qed.

(* What a segment adds to the winding number: it is met by the ray to the right if that is where it
   comes to the height of the ray. *)
Lemma signed_crossing_by_height (p : vector) (s : segment) :
  signed_crossing p s =
  (if spans s (vy p) && negative (vx p - vx (point_at_height s (vy p)))
   then if at_most (vy (source s)) (vy p) then 1 else -1
   else 0)%Z.
Proof.
  destruct s as [a b]. unfold signed_crossing, ray_crossing.
  pose proof (heights_of_spanning (Segment a b) (vy p)) as heights.
  rewrite orientation_by_area. cbn [source target] in *.
  unfold spans in *. cbn [source target] in *.
  destruct (at_most_spec (vy a) (vy p)) as [A | A], (at_most_spec (vy b) (vy p)) as [B | B];
    cbn [xorb Bool.eqb andb] in *; try reflexivity; specialize (heights eq_refl);
    (assert (value : area (Segment a b) p ==
      (vy b - vy a) * (vx (point_at_height (Segment a b) (vy p)) - vx p))
      by (unfold area, point_at_height, cross, minus; cbn; field; lra));
    set (X := vx (point_at_height (Segment a b) (vy p))) in *; clearbody X;
    destruct (negative_spec (vx p - X)); compared_numbers (area (Segment a b) p ?= 0);
      try reflexivity; exfalso; nra.
Qed.

Lemma crossed_ahead (p : vector) (s : segment) : signed_crossing p s <> 0%Z ->
  spans s (vy p) = true /\ vx p < vx (point_at_height s (vy p)).
Proof.
  rewrite signed_crossing_by_height. destruct (spans s (vy p)); [| now intros []].
  destruct (negative_spec (vx p - vx (point_at_height s (vy p)))); [split; [reflexivity | lra] | now intros []].
Qed.

(* Of the segments that the ray crosses the first. *)
Lemma first_crossed (p : vector) (segments : list segment) :
  (forall s, In s segments -> signed_crossing p s = 0%Z) \/
  exists s, In s segments /\ signed_crossing p s <> 0%Z /\
    forall t, In t segments -> signed_crossing p t <> 0%Z ->
      vx (point_at_height s (vy p)) <= vx (point_at_height t (vy p)).
Proof.
  set (crossed := fun s => negb (signed_crossing p s =? 0)%Z).
  assert (crossed_is : forall s, In s segments -> signed_crossing p s <> 0%Z -> In s (filter crossed segments))
    by (intros s I met; apply filter_In; split; [exact I |]; now apply negb_true_iff, Z.eqb_neq).
  destruct (filter crossed segments) as [| a rest] eqn:hits.
  - left. intros s I. destruct (Z.eq_dec (signed_crossing p s) 0) as [| met]; [assumption |].
    destruct (crossed_is s I met).
  - right. destruct (least_of (fun s => vx (point_at_height s (vy p))) (a :: rest)) as (s & I & first);
    [discriminate |].
    exists s. rewrite <- hits in I. apply filter_In in I. destruct I as [I met].
    split; [exact I |]. split; [now apply Z.eqb_neq, negb_true_iff |]. intros t J also. now apply first, crossed_is.
Qed.

Lemma inside_by_height (w : vector) (s : segment) : lies_on w s -> ~ vy (source s) == vy w -> ~ vy (target s) == vy w ->
  strictly_inside w s.
Proof.
  intros on not_source not_target.
  destruct (inside_or_end w s on) as [inside_ | [[_ Y] | [_ Y]]]; [exact inside_ | contradiction ..].
Qed.

Lemma met_at_height (v : vector) (f : segment) (y : Q) : lies_on v f -> vy v == y ->
  ~ vy (source f) == y -> ~ vy (target f) == y -> spans f y = true /\ vx v == vx (point_at_height f y).
Proof.
  intros (t & range & X & Y) height not_source not_target.
  assert (heights : vy (source f) < y < vy (target f) \/ vy (target f) < y < vy (source f)).
  { rewrite <- height in *. destruct (Qlt_le_dec (vy (source f)) (vy (target f))).
    - left. split; apply Qnot_le_lt; intros extreme; [apply not_source | apply not_target]; nra.
    - right. split; apply Qnot_le_lt; intros extreme; [apply not_target | apply not_source]; nra. }
  split.
  - unfold spans. destruct (at_most_spec (vy (source f)) y), (at_most_spec (vy (target f)) y); trivial; exfalso; lra.
  - unfold point_at_height; cbn [vx].
    assert (t_is : (y - vy (source f)) / (vy (target f) - vy (source f)) == t)
      by (rewrite <- height, Y; field; lra).
    rewrite t_is, X. ring.
Qed.

(* They have no point in common, and no end of a segment of the second has winding number other than zero with
   respect to the first. *)
Definition have_no_common_point (some others : list segment) : Prop :=
  forall s t w, In s some -> In t others -> lies_on w s -> lies_on w t -> False.

Definition vertices_outside (some others : list segment) : Prop :=
  forall s, In s some -> winding_number (target s) others = 0%Z.

(* So the winding number does not change along a segment. *)
Lemma same_up_to_the_end (some others : list segment) (s : segment) (w : vector) :
  cycles others -> have_no_common_point some others -> In s some -> lies_on w s ->
  winding_number w others = winding_number (target s) others.
Proof.
  intros closed separate I on. apply (winding_number_along (Segment w (target s)) others closed).
  intros v on_part t J on_t. apply (separate s t v I J); [| exact on_t].
  now apply (part_of_segment w v s).
Qed.

Lemma no_common_point_swapped some others : have_no_common_point some others -> have_no_common_point others some.
Proof. intros none s o z S O on_s on_o. exact (none o s z O S on_o on_s). Qed.
