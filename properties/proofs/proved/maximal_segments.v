(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Segments that go on in the same direction where another ends are joined, so that dangling edges are as long as can
   be; and sorted. The points are the same. *)
From Coq Require Import QArith Lqa Qfield ZArith Bool List.
From Oplus Require Import convolution meeting_of_segments rotation regions location pieces collision_is_complete.
Import ListNotations.

Open Scope Q_scope.

(* t goes on where s ends. *)
Definition goes_on (s t : segment) : bool :=
  same_point (target s) (source t) && zero (cross (along s) (along t)) && positive (dot (along s) (along t)).

Fixpoint joined_with (s : segment) (l : list segment) : list segment :=
  match l with
  | [] => [s]
  | t :: rest =>
    if goes_on s t then joined_with (Segment (source s) (target t)) rest
    else if goes_on t s then joined_with (Segment (source t) (target s)) rest
    else t :: joined_with s rest
  end.

Fixpoint inserted_segment (s : segment) (l : list segment) : list segment :=
  match l with
  | [] => [s]
  | t :: rest =>
    match compare_points (source s) (source t), compare_points (target s) (target t) with
    | Lt, _ | Eq, Lt => s :: l
    | _, _ => t :: inserted_segment s rest
    end
  end.

Definition maximal_segments (l : list segment) : list segment :=
  fold_right inserted_segment [] (fold_right joined_with [] l).

Definition on_one (x : vector) (l : list segment) : Prop := exists s, In s l /\ lies_on x s.

Lemma on_one_of_more (x : vector) (s : segment) (l : list segment) :
  on_one x (s :: l) <-> lies_on x s \/ on_one x l.
Proof.
  unfold on_one. split.
  - intros (t & [<- | T] & on); [now left | right; now exists t].
  - intros [on | (t & T & on)]; [exists s; split; [now left | exact on] | exists t; split; [now right | exact on]].
Qed.

(* Together they are one segment. *)
Lemma on_both_parts (s t : segment) (x : vector) : nonzero (along s) -> goes_on s t = true ->
  (lies_on x (Segment (source s) (target t)) <-> lies_on x s \/ lies_on x t) /\
  nonzero (along (Segment (source s) (target t))).
Proof.
  intros long both. unfold goes_on in both. rewrite !andb_true_iff in both. destruct both as [[at_end line] ahead].
  destruct (same_point_spec (target s) (source t)) as [[X Y] |]; [clear at_end | discriminate].
  destruct (zero_spec (cross (along s) (along t))) as [parallel |]; [clear line | discriminate].
  unfold positive in ahead. destruct (negative_spec (- dot (along s) (along t))) as [same_way |]; [clear ahead |
    discriminate].
  destruct (multiple_of (along t) (along s) long) as (c & cx & cy); [unfold cross in *; lra |].
  pose proof (square_positive _ long) as square.
  assert (some : 0 < c).
  { apply Qnot_le_lt. intros back. unfold dot in *. rewrite cx, cy in same_way.
    assert (0 <= - c * (vx (along s) * vx (along s) + vy (along s) * vy (along s))) by (apply Qmult_le_0_compat; lra).
    lra. }
  unfold along, minus in cx, cy; cbn [vx vy] in cx, cy.
  set (ux := vx (target s) - vx (source s)) in *. set (uy := vy (target s) - vy (source s)) in *.
  assert (sx : vx (target s) == vx (source s) + ux) by (unfold ux; ring).
  assert (sy : vy (target s) == vy (source s) + uy) by (unfold uy; ring).
  assert (tx : vx (target t) == vx (source s) + (1 + c) * ux) by lra.
  assert (ty : vy (target t) == vy (source s) + (1 + c) * uy) by lra.
  assert (from_x : vx (source t) == vx (source s) + ux) by lra.
  assert (from_y : vy (source t) == vy (source s) + uy) by lra.
  split.
  - split.
    + intros (k & range & kx & ky). cbn [source target] in kx, ky.
      assert (0 <= k * (1 + c)) by (apply Qmult_le_0_compat; lra).
      assert (0 <= (1 - k) * (1 + c)) by (apply Qmult_le_0_compat; lra).
      destruct (Qlt_le_dec 1 (k * (1 + c))) as [later | earlier]; [right | left].
      * assert (value : (k * (1 + c) - 1) / c * c == k * (1 + c) - 1) by (field; lra).
        exists ((k * (1 + c) - 1) / c). split; [split; [apply Qle_shift_div_l | apply Qle_shift_div_r]; lra |].
        set (j := (k * (1 + c) - 1) / c) in *. clearbody j. rewrite kx, ky, tx, ty, from_x, from_y. split.
        -- setoid_replace ((1 - j) * (vx (source s) + ux) + j * (vx (source s) + (1 + c) * ux))
             with (vx (source s) + ux + j * c * ux) by ring. rewrite value. ring.
        -- setoid_replace ((1 - j) * (vy (source s) + uy) + j * (vy (source s) + (1 + c) * uy))
             with (vy (source s) + uy + j * c * uy) by ring. rewrite value. ring.
      * exists (k * (1 + c)). split; [lra |]. rewrite kx, ky, tx, ty, sx, sy. split; ring.
    + intros [(k & range & kx & ky) | (k & range & kx & ky)].
      * assert (value : k / (1 + c) * (1 + c) == k) by (field; lra).
        exists (k / (1 + c)). split; [split; [apply Qle_shift_div_l | apply Qle_shift_div_r]; lra |].
        set (j := k / (1 + c)) in *. clearbody j. cbn [source target]. rewrite kx, ky, tx, ty, sx, sy, <- value.
        split; ring.
      * assert (value : (1 + k * c) / (1 + c) * (1 + c) == 1 + k * c) by (field; lra).
        assert (0 <= k * c) by (apply Qmult_le_0_compat; lra). assert (0 <= (1 - k) * c) by (apply Qmult_le_0_compat;
          lra).
        exists ((1 + k * c) / (1 + c)). split; [split; [apply Qle_shift_div_l | apply Qle_shift_div_r]; lra |].
        set (j := (1 + k * c) / (1 + c)) in *. clearbody j. cbn [source target].
        rewrite kx, ky, tx, ty, from_x, from_y. split.
        -- setoid_replace ((1 - j) * vx (source s) + j * (vx (source s) + (1 + c) * ux))
             with (vx (source s) + j * (1 + c) * ux) by ring. rewrite value. ring.
        -- setoid_replace ((1 - j) * vy (source s) + j * (vy (source s) + (1 + c) * uy))
             with (vy (source s) + j * (1 + c) * uy) by ring. rewrite value. ring.
  - intros [no_x no_y]. apply long. unfold along, minus in *; cbn [source target vx vy] in *. fold ux uy.
    rewrite tx in no_x. rewrite ty in no_y. assert (zero_x : (1 + c) * ux == 0) by lra.
    assert (zero_y : (1 + c) * uy == 0) by lra. apply Qmult_integral in zero_x, zero_y. split; lra.
Qed.

Lemma joined_with_is (x : vector) (l : list segment) : (forall t, In t l -> nonzero (along t)) -> forall s,
  nonzero (along s) ->
  (on_one x (joined_with s l) <-> lies_on x s \/ on_one x l) /\
  (forall t, In t (joined_with s l) -> nonzero (along t)).
Proof.
  induction l as [| t l IH]; intros long s long_s; cbn [joined_with].
  - split; [apply on_one_of_more | intros t [<- | []]; exact long_s].
  - assert (long_t : nonzero (along t)) by (apply long; now left).
    assert (long_l : forall u, In u l -> nonzero (along u)) by (intros u U; apply long; now right).
    rewrite on_one_of_more. destruct (goes_on s t) eqn:after; [| destruct (goes_on t s) eqn:before].
    + destruct (on_both_parts s t x long_s after) as [parts long_j].
      destruct (IH long_l _ long_j) as [points longs]. split; [rewrite points, parts; tauto | exact longs].
    + destruct (on_both_parts t s x long_t before) as [parts long_j].
      destruct (IH long_l _ long_j) as [points longs]. split; [rewrite points, parts; tauto | exact longs].
    + destruct (IH long_l s long_s) as [points longs]. split; [rewrite on_one_of_more, points; tauto |].
      intros u [<- | U]; [exact long_t | now apply longs].
Qed.

Lemma on_inserted (x : vector) (s : segment) (l : list segment) :
  on_one x (inserted_segment s l) <-> lies_on x s \/ on_one x l.
Proof.
  induction l as [| t l IH]; cbn [inserted_segment]; [apply on_one_of_more |].
  destruct (compare_points (source s) (source t)), (compare_points (target s) (target t));
    rewrite ?on_one_of_more, ?IH, ?on_one_of_more; tauto.
Qed.

(* Theorem. The points stay. *)
Theorem maximal_segments_are (x : vector) (l : list segment) : (forall s, In s l -> nonzero (along s)) ->
  on_one x (maximal_segments l) <-> on_one x l.
Proof.
  intros long. unfold maximal_segments.
  assert (joined : (on_one x (fold_right joined_with [] l) <-> on_one x l) /\
    forall s, In s (fold_right joined_with [] l) -> nonzero (along s)).
  { induction l as [| s l IH]; [cbn; split; [tauto | intros s []] |]. cbn [fold_right].
    destruct IH as [points longs]; [intros t T; apply long; now right |].
    destruct (joined_with_is x _ longs s) as [more longs']; [apply long; now left |].
    split; [rewrite more, points, on_one_of_more; tauto | exact longs']. }
  destruct joined as [<- _]. induction (fold_right joined_with [] l) as [| s k IH]; [reflexivity |].
  cbn [fold_right]. rewrite on_inserted, IH, on_one_of_more. tauto.
Qed.
