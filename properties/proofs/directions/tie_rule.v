(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The tie rule (thesis, Definition 2.2.7) is a rotation: what ccw says of labelled directions is what
   it says of plain vectors once all of Q's have been turned counterclockwise by a small enough angle. *)
From Coq Require Import Bool List.
From Oplus Require Import numbers directions rotation.
From Oplus Require Export small_numbers.

Open Scope Q_scope.

(* A direction of Q is turned by epsilon, one of P stays. *)
Definition nudged (epsilon : Q) (d : direction) : vector :=
  match of d with OfP => vec d | OfQ => turned (vec d) epsilon end.

(* Turned a little, v passes no direction that comes later, the full turn included. *)
Lemma turned_a_little (v : vector) (limit : Q) :
  nonzero v -> angle v < limit -> limit <= 4 ->
  eventually (fun epsilon => nonzero (turned v epsilon) /\ angle v < angle (turned v epsilon) < limit).
Proof.
  intros n before_limit r. pose proof (angle_range v n) as rv.
  assert (exists later, angle v < later < limit /\ later < angle v + 2) as (later & between & near).
  { destruct (Qlt_le_dec (angle v + 1) limit); [exists (angle v + 1) | exists ((1 # 2) * (angle v + limit))]; lra. }
  set (w := diamond later). assert (nw : nonzero w) by (apply diamond_nonzero; lra).
  assert (angle_w : angle w == later)
    by (apply (angle_diamond _ later 1); [lra | lra | unfold w; ring | unfold w; ring]).
  assert (left : 0 < cross v w).
  { pose proof (cross_angle v w n nw) as k. unfold turns_by in k. rewrite angle_w in k. lra. }
  refine (eventually_implied _ _ _ (eventually_and _ _ (eventually_below 1 _)
    (eventually_positive _ (- (cross v w + dot v w)) left))); [| lra].
  intros e [small rest]. destruct (diamond_first e) as [x_is y_is]; [lra |].
  assert (nt : nonzero (turned v e)) by (apply product_nonzero; [| apply diamond_nonzero]; trivial; lra).
  split; [exact nt |].
  assert (turn : 0 < cross v (turned v e)).
  { assert (cross v (turned v e) == dot v v * e) as ->
      by (unfold turned, product, cross, dot; cbn [vx vy]; rewrite x_is, y_is; ring).
    pose proof (square_positive v n). nra. }
  assert (turn_to_w : cross (turned v e) w == cross v w + e * - (cross v w + dot v w))
    by (unfold turned, product, cross, dot; cbn [vx vy]; rewrite x_is, y_is; ring).
  pose proof (cross_angle v _ n nt) as k. pose proof (cross_angle _ w nt nw) as k'.
  unfold turns_by in k, k'. rewrite angle_w in k'.
  assert (0 < angle (turned v e) - angle v < 2 \/ angle (turned v e) - angle v < -2) by lra.
  assert (0 < later - angle (turned v e) < 2 \/ later - angle (turned v e) < -2) by lra.
  lra.
Qed.

Lemma nudged_a_little (d : direction) (limit : Q) :
  proper d -> angle (vec d) < limit -> limit <= 4 ->
  eventually (fun epsilon => nonzero (nudged epsilon d) /\
                             angle (vec d) <= angle (nudged epsilon d) < limit /\
                             (of d = OfQ -> angle (vec d) < angle (nudged epsilon d))).
Proof.
  intros n before_limit r. unfold nudged. destruct (of d) eqn:label.
  - exists 1. split; [lra |]. intros e _ _. repeat split; trivial; try lra. discriminate.
  - refine (eventually_implied _ _ _ (turned_a_little (vec d) limit n before_limit r)).
    intros e [? ?]. repeat split; trivial; lra.
Qed.

Lemma turned_same (u v : vector) (t : Q) : same_direction u v -> same_direction (turned u t) (turned v t).
Proof.
  intros (a & positive & x_is & y_is). exists a. unfold turned, product. cbn [vx vy].
  rewrite x_is, y_is. repeat split; trivial; ring.
Qed.

(* Nudging keeps the order of two directions, and makes it one of angles alone. *)
Lemma nudged_earlier (a b : direction) :
  proper a -> proper b ->
  eventually (fun epsilon =>
    nonzero (nudged epsilon a) /\ (earlier a b -> angle (nudged epsilon a) < angle (nudged epsilon b))).
Proof.
  intros m n. pose proof (angle_range (vec a) m). pose proof (angle_range (vec b) n).
  assert (exists limit, angle (vec a) < limit <= 4 /\ (angle (vec a) < angle (vec b) -> limit <= angle (vec b)))
    as (limit & range & before_b).
  { destruct (Qlt_le_dec (angle (vec a)) (angle (vec b))); [exists (angle (vec b)) | exists 4]; repeat split; lra. }
  refine (eventually_implied _ _ _
            (eventually_and _ _ (nudged_a_little a limit m _ _) (nudged_a_little b 4 n _ _))); try lra.
  intros e [(na & before_limit & _) (_ & after_b & qb)]. split; [exact na |].
  unfold earlier, place. intros [less | [tie labels]]; [specialize (before_b less); lra |].
  destruct (of a) eqn:label_a, (of b) eqn:label_b; try (exfalso; lra).
  specialize (qb eq_refl). assert (nudged e a = vec a) as -> by (unfold nudged; now rewrite label_a). lra.
Qed.

Lemma nudged_order (a b : direction) :
  proper a -> proper b ->
  eventually (fun epsilon =>
    nonzero (nudged epsilon a) /\ nonzero (nudged epsilon b) /\
    (earlier a b -> angle (nudged epsilon a) < angle (nudged epsilon b)) /\
    (equal a b -> angle (nudged epsilon a) == angle (nudged epsilon b)) /\
    (earlier b a -> angle (nudged epsilon b) < angle (nudged epsilon a))).
Proof.
  intros m n.
  refine (eventually_implied _ _ _ (eventually_and _ _ (nudged_earlier a b m n) (nudged_earlier b a n m))).
  intros e [(na & ab) (nb & ba)]. repeat split; trivial. intros [same_angle labels]. apply place_of in labels.
  apply same_direction_angle; trivial. apply same_direction_angle in same_angle; trivial.
  unfold nudged. rewrite labels. destruct (of b); [trivial | now apply turned_same].
Qed.

Lemma nudged_ccw (d from to : direction) :
  proper d -> proper from -> proper to ->
  eventually (fun epsilon =>
    ccw d from to = ccw_of_vectors (nudged epsilon d) (nudged epsilon from) (nudged epsilon to)).
Proof.
  intros l m n.
  refine (eventually_implied _ _ _
            (eventually_and _ _ (nudged_order from d m l)
               (eventually_and _ _ (nudged_order d to l n) (nudged_order from to m n)))).
  intros e ((nf & nd & a1 & a2 & a3) & (_ & nt & b1 & b2 & b3) & (_ & _ & c1 & c2 & c3)).
  unfold ccw_of_vectors.
  destruct (ccw_spec d from to l m n) as [o | o],
    (ccw_spec (Direction (nudged e d) OfP) (Direction (nudged e from) OfP)
              (Direction (nudged e to) OfP) nd nf nt) as [o' | o']; trivial; exfalso;
    unfold in_order in *; unfold earlier at 1 2 3 4 5 6 in o'; cbn [vec place of] in o';
    destruct (earlier_total from d) as [x | [x | x]], (earlier_total d to) as [y | [y | y]],
      (earlier_total from to) as [z | [z | z]]; try (exfalso; clear a1 a2 a3 b1 b2 b3 c1 c2 c3 o'; order);
    repeat match goal with
           | h : ?A -> _, k : ?A |- _ => specialize (h k)
           end; lra.
Qed.

(* Definition 2.2.7's tie rule, for any finite number of directions of P and Q. Turn those of Q
   counterclockwise by one and the same angle, leave those of P, and forget to whom they belong. For every
   small enough angle, no direction of P is equal to one of Q any more, and ccw of what comes out, which
   Definition 2.1.10 defines, is ccw of the labelled directions. *)
Theorem tie_rule_is_a_rotation (directions : list direction) :
  (forall d, In d directions -> proper d) ->
  eventually (fun epsilon =>
      (forall a b, In a directions -> In b directions -> of a = OfP -> of b = OfQ ->
         ~ same_direction (nudged epsilon a) (nudged epsilon b)) /\
      (forall d from to, In d directions -> In from directions -> In to directions ->
         ccw d from to =
         ccw_of_vectors (nudged epsilon d) (nudged epsilon from) (nudged epsilon to))).
Proof.
  intros all_proper. apply eventually_and.
  - refine (eventually_implied _ _ _ (eventually_for_all _ directions (fun a A =>
      eventually_for_all _ directions (fun b B => nudged_order a b (all_proper a A) (all_proper b B))))).
    intros e orders a b A B oa ob. destruct (orders a A b B) as (na & nb & ab & _ & ba).
    rewrite same_direction_angle by assumption.
    destruct (earlier_total a b) as [o | [[_ o] | o]]; [specialize (ab o); lra | | specialize (ba o); lra].
    apply place_of in o. rewrite oa, ob in o. discriminate o.
  - refine (eventually_implied _ _ _ (eventually_for_all _ directions (fun d D =>
      eventually_for_all _ directions (fun from F => eventually_for_all _ directions (fun to T =>
        nudged_ccw d from to (all_proper d D) (all_proper from F) (all_proper to T)))))).
    intros e equal d from to D F T. now apply equal.
Qed.
