(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Segments that go on in the same direction where another ends are joined, so that dangling edges are as long as can
   be; and sorted. The points are the same. *)
From Coq Require Import QArith Lqa Qfield ZArith Bool List.
From Oplus Require Import convolution meeting_of_segments rotation regions location pieces specification_bridge
  coordinates touching_vertices.
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

Lemma on_one_of_more (x : vector) (s : segment) (l : list segment) : on_one x (s :: l) <-> lies_on x s \/ on_one x l.
Proof.
  unfold on_one; cbn. split; [intros (t & [<- | T] & on) | intros [on | (t & T & on)]]; eauto.
Qed.

(* Together they are one segment. *)
Lemma on_both_parts (s t : segment) (x : vector) : nonzero (along s) -> goes_on s t = true ->
  (lies_on x (Segment (source s) (target t)) <-> lies_on x s \/ lies_on x t) /\
  nonzero (along (Segment (source s) (target t))).
Proof.
  intros long both. unfold goes_on in both. rewrite !andb_true_iff in both. destruct both as [[at_end line] ahead].
  destruct (same_point_spec (target s) (source t)) as [meet |]; [clear at_end | discriminate].
  destruct (zero_spec (cross (along s) (along t))) as [parallel |]; [clear line | discriminate].
  unfold positive in ahead.
  destruct (negative_spec (- dot (along s) (along t))) as [same_way |]; [clear ahead | discriminate].
  destruct (multiple_of (along t) (along s) long) as (c & cx & cy); [unfold cross in *; lra |].
  pose proof (square_positive _ long) as square.
  assert (some : 0 < c) by (unfold dot in *; rewrite cx, cy in same_way; nra).
  assert (whole : equal_vectors (along (Segment (source s) (target t))) (moved_along (along s) (along s) c))
    by (clear - meet cx cy; by_computing).
  assert (whole_long : nonzero (along (Segment (source s) (target t)))).
  { destruct whole as [wx wy]. intros [X Y]. rewrite wx in X. rewrite wy in Y. unfold moved_along in X, Y.
    cbn [vx vy] in X, Y.
    apply long. split; apply (Qmult_inj_l _ _ (1 + c)); lra. }
  assert (between_ : is_between_ends (target s) (source s) (target t) = true).
  { apply is_between_ends_iff. split; [intros [X Y]; apply whole_long; clear - X Y; by_computing |].
    assert (value : / (1 + c) * (1 + c) == 1) by (field; lra). exists (/ (1 + c)).
    split; [split; [apply Qinv_lt_0_compat; lra | nra] |]. set (k := / (1 + c)) in *. clearbody k.
    destruct whole as [wx wy], meet as [mx my]. to_coordinates. split; by_equations. }
  split; [| exact whole_long].
  rewrite (on_divided _ _ _ x between_).
  assert (same : lies_on x (Segment (target s) (target t)) <-> lies_on x t).
  { destruct t as [v b]. split; apply lies_on_of_equal; try reflexivity; [exact meet | now symmetry]. }
  destruct s. rewrite same. tauto.
Qed.

Lemma joined_with_is (x : vector) (l : list segment) : (forall t, In t l -> nonzero (along t)) -> forall s,
  nonzero (along s) -> (on_one x (joined_with s l) <-> lies_on x s \/ on_one x l) /\ (forall t,
  In t (joined_with s l) -> nonzero (along t)).
Proof.
  induction l as [| t l IH]; intros long s long_s; cbn [joined_with].
  - split; [apply on_one_of_more | intros t [<- | []]; exact long_s].
  - assert (long_t : nonzero (along t)) by (apply long; now left).
    assert (long_l : forall u, In u l -> nonzero (along u)) by (intros u U; apply long; now right).
    rewrite on_one_of_more. destruct (goes_on s t) eqn:after; [| destruct (goes_on t s) eqn:before].
    1: destruct (on_both_parts s t x long_s after) as [parts long_j].
    2: destruct (on_both_parts t s x long_t before) as [parts long_j].
    1, 2: destruct (IH long_l _ long_j) as [points longs]; split; [rewrite points, parts; tauto | exact longs].
    destruct (IH long_l s long_s) as [points longs]. split; [rewrite on_one_of_more, points; tauto |].
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
