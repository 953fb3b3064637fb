(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* What it means to rotate (thesis, Definition 2.1.10), and that ccw says what is met first. The circle
   is replaced by the diamond |x| + |y| = 1, of circumference 4 in the norm |x| + |y| of its quarter:
   which directions are met, and in which order, is the same, and all numbers stay rational. *)
From Coq Require Import Bool Lia.
From Oplus Require Import numbers direction angle cyclic_order.

Open Scope Q_scope.

(* The product of complex numbers: v seen from b instead of from the positive x-axis, and back. *)
Definition product (b v : vector) : vector :=
  Vector (vx b * vx v - vy b * vy v) (vx b * vy v + vy b * vx v).

(* b after a counterclockwise turn by t: 1 is a right angle, 2 half a turn, 4 the full turn. *)
Definition turned (b : vector) (t : Q) : vector := product b (diamond t).

(* v in the coordinates of b: how far ahead, how far to the left. *)
Definition seen (b v : vector) : vector := Vector (dot b v) (cross b v).

Lemma diamond_on (t : Q) : 0 <= t < 4 -> on_diamond t (vx (diamond t)) (vy (diamond t)).
Proof.
  intros r. unfold diamond, on_diamond. destruct (Qlt_le_dec t 2); cbn [vx vy].
  - destruct (abs_cases (1 - t)) as [[? e] | [? e]]; rewrite e; lra.
  - destruct (abs_cases (t - 3)) as [[? e] | [? e]]; rewrite e; lra.
Qed.

Lemma diamond_first (t : Q) : 0 <= t < 1 -> vx (diamond t) == 1 - t /\ vy (diamond t) == t.
Proof. intros r. pose proof (diamond_on t ltac:(lra)) as on. unfold on_diamond in on. lra. Qed.

Lemma square_positive (v : vector) : nonzero v -> 0 < dot v v.
Proof.
  unfold nonzero, dot. intros n.
  destruct (Q_dec (vx v) 0) as [[? | ?] | e]; [nra | nra |].
  destruct (Q_dec (vy v) 0) as [[? | ?] | f]; [nra | nra |]. tauto.
Qed.

Lemma diamond_nonzero (t : Q) : 0 <= t < 4 -> nonzero (diamond t).
Proof. intros r. pose proof (diamond_on t r). unfold on_diamond, nonzero in *. lra. Qed.

Lemma nonzero_by_square (v : vector) : 0 < dot v v -> nonzero v.
Proof. unfold dot. intros some [x_is y_is]. rewrite x_is, y_is in some. lra. Qed.

Lemma product_nonzero (b v : vector) : nonzero b -> nonzero v -> nonzero (product b v).
Proof.
  intros m n. pose proof (square_positive b m). pose proof (square_positive v n). apply nonzero_by_square.
  setoid_replace (dot (product b v) (product b v)) with (dot b b * dot v v) by (unfold dot; cbn [product vx vy]; ring).
  nra.
Qed.

Lemma seen_nonzero (b v : vector) : nonzero b -> nonzero v -> nonzero (seen b v).
Proof.
  intros m n. pose proof (square_positive b m). pose proof (square_positive v n). apply nonzero_by_square.
  setoid_replace (dot (seen b v) (seen b v)) with (dot b b * dot v v)
    by (unfold seen, cross, dot; cbn [vx vy]; ring).
  nra.
Qed.

(* The only angle a multiple of a point of the diamond has is the point's. *)
Lemma angle_diamond (v : vector) (t s : Q) :
  0 <= t < 4 -> 0 < s -> vx v == s * vx (diamond t) -> vy v == s * vy (diamond t) -> angle v == t.
Proof.
  intros r positive x_of y_of.
  pose proof (diamond_on t r) as on.
  assert (n : nonzero v).
  { pose proof (diamond_nonzero t r) as n. unfold nonzero in *. nra. }
  destruct (angle_cases v n) as (s' & x & y & positive' & c & x_is & y_is).
  pose proof (diamond_turns _ _ _ _ _ _ c on) as turns.
  assert (x * (s' / s) == vx (diamond t))
    by (apply (Qmult_inj_l _ _ s); [lra |]; rewrite <- x_of, x_is; field; lra).
  assert (y * (s' / s) == vy (diamond t))
    by (apply (Qmult_inj_l _ _ s); [lra |]; rewrite <- y_of, y_is; field; lra).
  assert (0 < s' / s) by (apply Qlt_shift_div_l; lra).
  unfold turns_by in turns.
  destruct turns as [[? ?] | [[? ?] | [[? [? ?]] | [? [? ?]]]]]; try lra; exfalso; nra.
Qed.

(* To be the same direction is to be so as seen from b. *)
Lemma same_as_turned (b v : vector) (t : Q) :
  nonzero b -> nonzero v -> 0 <= t < 4 ->
  same_direction v (turned b t) <-> angle (seen b v) == t.
Proof.
  intros m n r. pose proof (square_positive b m) as positive.
  pose proof (diamond_nonzero t r) as k.
  assert (l : nonzero (turned b t)) by now apply product_nonzero.
  assert (e : same_direction v (turned b t) <-> same_direction (seen b v) (seen b (turned b t))).
  { unfold same_direction, seen, dot, cross. cbn [vx vy].
    split; intros (a & positive_a & x_is & y_is); exists a; split; try assumption.
    - rewrite x_is, y_is. split; ring.
    - unfold dot in positive. split.
      + apply (Qmult_inj_l _ _ (vx b * vx b + vy b * vy b)); [lra |].
        transitivity (vx b * (vx b * vx v + vy b * vy v) - vy b * (vx b * vy v - vy b * vx v)); [ring |].
        rewrite x_is, y_is. ring.
      + apply (Qmult_inj_l _ _ (vx b * vx b + vy b * vy b)); [lra |].
        transitivity (vy b * (vx b * vx v + vy b * vy v) + vx b * (vx b * vy v - vy b * vx v)); [ring |].
        rewrite x_is, y_is. ring. }
  rewrite e, same_direction_angle by (apply seen_nonzero; assumption).
  assert (angle (seen b (turned b t)) == t) as ->; [| reflexivity].
  apply (angle_diamond _ t (dot b b)); trivial; unfold turned, seen, product, dot, cross;
    cbn [vx vy]; ring.
Qed.

(* The directions of one summand, or of vectors that belong to none. *)
Definition ccw_of_vectors (d from to : vector) : bool :=
  ccw (Direction d OfP) (Direction from OfP) (Direction to OfP).

(* Angles as seen from b differ as much as those from the x-axis, up to less than half a turn. *)
Lemma turns_as_seen (b u v : vector) :
  nonzero b -> nonzero u -> nonzero v ->
  turns_by (angle (seen b v) - angle (seen b u)) (cross u v) (dot u v).
Proof.
  intros l m n. apply (turns_by_scaled _ _ _ (cross (seen b u) (seen b v)) (dot (seen b u) (seen b v)) (dot b b));
    [now apply square_positive | | | apply cross_angle; now apply seen_nonzero];
    unfold seen, cross, dot; cbn [vx vy]; ring.
Qed.

Lemma angle_seen_itself (b : vector) : nonzero b -> angle (seen b b) == 0.
Proof.
  intros n. destruct (diamond_first 0 ltac:(lra)) as [x_is y_is].
  apply (angle_diamond _ 0 (dot b b)); [lra | now apply square_positive | |];
    rewrite ?x_is, ?y_is; unfold seen, cross, dot; cbn [vx vy]; ring.
Qed.

(* Two turns that cross and dot products cannot tell apart. *)
Lemma turns_alike (t t' c d : Q) :
  turns_by t c d -> turns_by t' c d ->
  ((0 < t < 2 \/ t < -2) /\ (0 < t' < 2 \/ t' < -2)) \/
  ((-2 < t < 0 \/ 2 < t) /\ (-2 < t' < 0 \/ 2 < t')) \/
  (t == 0 /\ t' == 0) \/ ((t == 2 \/ t == -2) /\ (t' == 2 \/ t' == -2)).
Proof.
  unfold turns_by.
  intros [[? ?] | [[? ?] | [[? [? ?]] | [? [? ?]]]]] [[? ?] | [[? ?] | [[? [? ?]] | [? [? ?]]]]];
    tauto || (exfalso; lra).
Qed.

(* Which of d and `to` is met first when turning from `from`. *)
Lemma ccw_seen (d from to : vector) :
  nonzero d -> nonzero from -> nonzero to ->
  ccw_of_vectors d from to = true <->
  0 < angle (seen from d) /\ angle (seen from d) < angle (seen from to).
Proof.
  intros l m n. unfold ccw_of_vectors.
  assert (o : in_order (Direction from OfP) (Direction d OfP) (Direction to OfP) <->
              0 < angle (seen from d) /\ angle (seen from d) < angle (seen from to)).
  { unfold in_order, earlier, place. cbn [vec of].
    pose proof (turns_alike _ _ _ _ (cross_angle from d m l) (turns_as_seen from from d m m l)) as a.
    pose proof (turns_alike _ _ _ _ (cross_angle from to m n) (turns_as_seen from from to m m n)) as b.
    pose proof (turns_alike _ _ _ _ (cross_angle d to l n) (turns_as_seen from d to m l n)) as c.
    pose proof (angle_seen_itself from m) as itself. rewrite itself in a, b. clear itself.
    pose proof (angle_range (seen from d) (seen_nonzero _ _ m l)).
    pose proof (angle_range (seen from to) (seen_nonzero _ _ m n)).
    pose proof (angle_range from m). pose proof (angle_range d l). pose proof (angle_range to n).
    generalize dependent (angle (seen from d)). generalize dependent (angle (seen from to)).
    generalize dependent (angle from). generalize dependent (angle d).
    generalize dependent (angle to). clear. intros.
    destruct a as [[[? | ?] [? | ?]] | [[[? | ?] [? | ?]] | [[? ?] | [[? | ?] [? | ?]]]]]; try lra;
    destruct b as [[[? | ?] [? | ?]] | [[[? | ?] [? | ?]] | [[? ?] | [[? | ?] [? | ?]]]]]; lra. }
  rewrite <- o.
  destruct (ccw_spec (Direction d OfP) (Direction from OfP) (Direction to OfP) l m n);
    split; easy.
Qed.

(* Turning from 0 towards 4 is a full counterclockwise turn: it starts in the direction of b; it turns
   left all the time, since of two of its directions less than half a turn apart, the later is to the
   left of the earlier; and it meets every direction at exactly one time. *)
Theorem turned_is_a_full_turn (b : vector) :
  nonzero b ->
  same_direction (turned b 0) b /\
  (forall s t, 0 <= s -> s < t < 4 -> t < s + 2 -> 0 < cross (turned b s) (turned b t)) /\
  (forall v, nonzero v -> exists t, 0 <= t < 4 /\ same_direction v (turned b t) /\
     forall s, 0 <= s < 4 -> same_direction v (turned b s) -> s == t).
Proof.
  intros m. pose proof (square_positive b m). repeat split.
  - exists 1. destruct (diamond_first 0 ltac:(lra)) as [x_is y_is].
    unfold turned, product. cbn [vx vy]. rewrite x_is, y_is. repeat split; (lra || ring).
  - intros s t r r' r''.
    pose proof (diamond_turns _ _ _ _ _ _ (diamond_on s ltac:(lra)) (diamond_on t ltac:(lra))) as k.
    assert (0 < cross (diamond s) (diamond t)) by (unfold turns_by in k; unfold cross; lra).
    assert (cross (turned b s) (turned b t) == dot b b * cross (diamond s) (diamond t)) as ->
      by (unfold turned, product, cross, dot; cbn [vx vy]; ring).
    nra.
  - intros v n. exists (angle (seen b v)).
    pose proof (angle_range (seen b v) (seen_nonzero b v m n)). repeat split; try lra.
    + apply same_as_turned; [assumption .. | reflexivity].
    + intros s r e. apply same_as_turned in e; [symmetry | | |]; assumption.
Qed.

(* Thesis, Definition 2.1.10, for vectors that have no labels: while rotating counterclockwise from the
   direction `from`, d is met, after the start, before `to`, which is met before the turn is full. *)
Theorem ccw_is_met_first (d from to : vector) :
  nonzero d -> nonzero from -> nonzero to ->
  ccw_of_vectors d from to = true <->
  exists s t, 0 < s /\ s < t /\ t < 4 /\
    same_direction d (turned from s) /\ same_direction to (turned from t).
Proof.
  intros l m n. rewrite ccw_seen by assumption.
  pose proof (angle_range (seen from d) (seen_nonzero _ _ m l)).
  pose proof (angle_range (seen from to) (seen_nonzero _ _ m n)).
  split.
  - intros [? ?]. exists (angle (seen from d)), (angle (seen from to)).
    repeat split; try lra; apply same_as_turned; try assumption; reflexivity.
  - intros (s & t & ? & ? & ? & e & f).
    apply same_as_turned in e; [| assumption .. | lra]. apply same_as_turned in f; [| assumption .. | lra].
    lra.
Qed.

(* Seen from `from`, a direction is ahead, or to the left or straight behind, or to the right: by the signs
   of a cross and a dot product. *)
Definition ahead (from v : vector) : bool := zero (cross from v) && negb (negative (dot from v)).
Definition on_the_far_side (from v : vector) : bool :=
  negative (cross from v) || (zero (cross from v) && negative (dot from v)).

Definition ccw_by_signs (d from to : vector) : bool :=
  negb (ahead from d) &&
  match on_the_far_side from d, on_the_far_side from to with
  | false, true => true
  | true, false => false
  | _, _ => negative (cross to d)
  end.

Lemma ahead_angle (b v : vector) : nonzero b -> nonzero v -> ahead b v = true <-> angle (seen b v) == 0.
Proof.
  intros m n. pose proof (turns_as_seen b b v m m n) as k. unfold turns_by in k.
  pose proof (angle_seen_itself b m). pose proof (angle_range (seen b v) (seen_nonzero b v m n)).
  unfold ahead. destruct (zero_spec (cross b v)), (negative_spec (dot b v)); cbn;
    split; (discriminate || lra || (intros; exfalso; lra) || trivial).
Qed.

(* The same predicate by signs of cross and dot products of the three vectors alone: the x-axis, from which
   the code measures angles, does not matter. *)
Theorem ccw_is_by_signs (d from to : vector) :
  nonzero d -> nonzero from -> nonzero to ->
  ccw_of_vectors d from to = ccw_by_signs d from to.
Proof.
  intros l m n. apply eq_true_iff_eq. rewrite ccw_seen by assumption.
  pose proof (ahead_angle from d m l) as a.
  pose proof (angle_range (seen from d) (seen_nonzero _ _ m l)) as range.
  pose proof (compare_angle_is (seen from d) (seen from to)
                (seen_nonzero _ _ m l) (seen_nonzero _ _ m n)) as c.
  assert (smaller : angle (seen from d) < angle (seen from to) <->
                    compare_angle (seen from d) (seen from to) = Lt)
    by (rewrite c; apply Qlt_alt).
  assert (halves : forall v, half (seen from v) = on_the_far_side from v) by reflexivity.
  assert (products : (vy (seen from d) * vx (seen from to) ?= vx (seen from d) * vy (seen from to))
                     = Lt <-> cross to d < 0).
  { pose proof (square_positive from m).
    assert (vx (seen from d) * vy (seen from to) - vy (seen from d) * vx (seen from to) ==
            dot from from * - cross to d) as e
      by (unfold seen, cross, dot; cbn [vx vy]; ring).
    rewrite <- Qlt_alt. split; intros; nra. }
  unfold ccw_by_signs, compare_angle in *. rewrite !halves in *.
  rewrite andb_true_iff, negb_true_iff, <- not_true_iff_false, a, smaller.
  assert (0 < angle (seen from d) <-> ~ angle (seen from d) == 0) as -> by lra.
  destruct (on_the_far_side from d), (on_the_far_side from to);
    rewrite ?products; destruct (negative_spec (cross to d)); intuition discriminate.
Qed.
