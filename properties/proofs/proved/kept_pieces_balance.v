(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The pieces that are kept (kept_pieces_go_round.v) enter each point as often as they leave it: compare their crossings
   as seen from four points around it. *)
From Coq Require Import QArith Qabs Qminmax Lqa Qfield ZArith Lia Bool List.
From Oplus Require Import direction angle angular_crossings winding_number shifted_ray signed_crossings
  small_numbers regions meeting_of_segments first_hit neighbourhoods left_of_an_edge location pieces beside_a_piece
  filling kept_pieces_go_round.
Import ListNotations.

Open Scope Q_scope.

(* Whether a segment starts in v, less whether it ends there. *)
Definition leaves (v : vector) (e : segment) : Z :=
  (as_number (same_point (source e) v) - as_number (same_point (target e) v))%Z.

Definition is_level (e : segment) : bool := zero (vy (target e) - vy (source e)).

Definition corner_crossings (v : vector) (delta d : Q) (e : segment) : Z :=
  (signed_crossing (Vector (vx v - delta) (vy v + d)) e - signed_crossing (Vector (vx v + delta) (vy v + d)) e
   - signed_crossing (Vector (vx v - delta) (vy v - d)) e + signed_crossing (Vector (vx v + delta) (vy v - d)) e)%Z.

Lemma on_but_not_inside (v : vector) (e : segment) : lies_on v e -> ~ strictly_inside v e ->
  equal_vectors (source e) v \/ equal_vectors (target e) v.
Proof. intros on not_inside. destruct (inside_or_end v e on); [contradiction | assumption]. Qed.

Lemma corners_of_others (v : vector) (delta d : Q) (e : segment) : 0 < d -> d < delta ->
  (forall y, within (2 * delta) v y -> ~ lies_on y e) -> corner_crossings v delta d e = 0%Z.
Proof.
  intros some small free. unfold corner_crossings. rewrite !crossing_at_height.
  assert (same_ahead : forall y, - delta < y - vy v < delta ->
    meets_ahead y (vx v - delta) e = meets_ahead y (vx v + delta) e).
  { intros y range. unfold meets_ahead, place_at. destruct (spans e y) eqn:spanning; [| reflexivity]. cbn [andb].
    destruct (negative_spec (vx v - delta - vx (point_at_height e y))),
      (negative_spec (vx v + delta - vx (point_at_height e y))); try reflexivity; exfalso; [| lra].
    apply (free (point_at_height e y)); [| now apply point_at_height_lies_on].
    unfold within. change (vy (point_at_height e y)) with y. lra. }
  rewrite !same_ahead by lra. lia.
Qed.

Lemma corners_of_level (v : vector) (delta d : Q) (e : segment) :
  is_level e = true -> corner_crossings v delta d e = 0%Z.
Proof.
  intros level. unfold is_level in level. destruct (zero_spec (vy (target e) - vy (source e))) as [same_height |];
    [| discriminate].
  assert (no_span : forall y, spans e y = false).
  { intros y. unfold spans. destruct (at_most_spec (vy (source e)) y), (at_most_spec (vy (target e)) y);
      try reflexivity; exfalso; lra. }
  unfold corner_crossings. rewrite !crossing_at_height. unfold meets_ahead. now rewrite !no_span.
Qed.

Lemma place_of_end (v : vector) (e : segment) (y : Q) : ~ vy (target e) - vy (source e) == 0 ->
  equal_vectors (source e) v \/ equal_vectors (target e) v ->
  vx (point_at_height e y) ==
    vx v + (y - vy v) * ((vx (target e) - vx (source e)) / (vy (target e) - vy (source e))).
Proof.
  intros steep [[X Y] | [X Y]]; unfold point_at_height; cbn [vx]; rewrite <- X, <- Y; field; exact steep.
Qed.

Lemma same_point_of_equal (a b : vector) : equal_vectors a b -> same_point a b = true.
Proof. intros equal. destruct (same_point_spec a b); [reflexivity | contradiction]. Qed.

Lemma corners_of_end (v : vector) (delta : Q) (e : segment) : 0 < delta -> is_level e = false ->
  equal_vectors (source e) v \/ equal_vectors (target e) v ->
  eventually (fun d => corner_crossings v delta d e = leaves v e).
Proof.
  intros wide level end_. unfold is_level in level.
  destruct (zero_spec (vy (target e) - vy (source e))) as [| steep]; [discriminate |].
  pose proof (place_of_end v e) as places. set (m := (vx (target e) - vx (source e)) / (vy (target e) - vy (source
    e))) in *.
  assert (heights : eventually (fun d => d < vy (target e) - vy (source e) \/ d < vy (source e) - vy (target e))).
  { destruct (Q_dec (vy (target e) - vy (source e)) 0) as [[low | high] |]; [| | contradiction].
    - exists (vy (source e) - vy (target e)). split; [lra |]. intros; right; lra.
    - exists (vy (target e) - vy (source e)). split; [lra |]. intros; left; lra. }
  refine (eventually_implied _ _ _ (eventually_and _ _ heights (eventually_and _ _
    (eventually_positive delta m wide) (eventually_and _ _ (eventually_positive delta (- m) wide)
      (ex_intro _ 1 (conj (ltac:(lra) : 0 < 1) (fun e some _ => some : 0 < e))))))).
  intros d (height_ & in_1 & in_2 & some).
  assert (place_up : place_at (vy v + d) e == vx v + d * m)
    by (unfold place_at; rewrite (places (vy v + d) steep end_); ring).
  assert (place_down : place_at (vy v - d) e == vx v - d * m)
    by (unfold place_at; rewrite (places (vy v - d) steep end_); ring).
  unfold corner_crossings. rewrite !crossing_at_height.
  assert (four : forall y, (place_at y e == vx v + d * m \/ place_at y e == vx v - d * m) ->
    meets_ahead y (vx v - delta) e = spans e y /\ meets_ahead y (vx v + delta) e = false).
  { intros y where_. unfold meets_ahead.
    destruct (negative_spec (vx v - delta - place_at y e)); [| exfalso; lra].
    destruct (negative_spec (vx v + delta - place_at y e)); [exfalso; lra |].
    now rewrite andb_true_r, andb_false_r. }
  destruct (four (vy v + d) (or_introl place_up)) as [-> ->].
  destruct (four (vy v - d) (or_intror place_down)) as [-> ->].
  unfold spans, direction_of, leaves.
  destruct end_ as [[X Y] | [X Y]].
  - rewrite (same_point_of_equal (source e) v) by now split.
    destruct (same_point_spec (target e) v) as [[X' Y'] |]; [exfalso; lra |]. cbn [as_number].
    destruct (at_most_spec (vy (source e)) (vy v + d)); [| exfalso; lra].
    destruct (at_most_spec (vy (source e)) (vy v - d)); [exfalso; lra |].
    destruct (at_most_spec (vy (target e)) (vy v + d)), (at_most_spec (vy (target e)) (vy v - d)); cbn [xorb];
      try lia; exfalso; lra.
  - rewrite (same_point_of_equal (target e) v) by now split.
    destruct (same_point_spec (source e) v) as [[X' Y'] |]; [exfalso; lra |]. cbn [as_number].
    destruct (at_most_spec (vy (target e)) (vy v + d)); [| exfalso; lra].
    destruct (at_most_spec (vy (target e)) (vy v - d)); [exfalso; lra |].
    destruct (at_most_spec (vy (source e)) (vy v + d)), (at_most_spec (vy (source e)) (vy v - d)); cbn [xorb];
      try lia; exfalso; lra.
Qed.

(* Whether the point at this height is inside a level piece. *)
Definition is_inside_level (y a : Q) (e : segment) : bool :=
  is_level e && zero (vy (source e) - y) && negative (vx (source e) - a) && negative (a - vx (target e)).

Lemma is_inside_level_spec (y a : Q) (e : segment) :
  reflect (vy (target e) == vy (source e) /\ vy (source e) == y /\ vx (source e) < a /\ a < vx (target e))
    (is_inside_level y a e).
Proof.
  unfold is_inside_level, is_level. apply iff_reflect. rewrite !andb_true_iff.
  destruct (zero_spec (vy (target e) - vy (source e))), (zero_spec (vy (source e) - y)),
    (negative_spec (vx (source e) - a)), (negative_spec (a - vx (target e)));
    (split; [intros H; repeat split; trivial; exfalso; lra | intros [[[? ?] ?] ?]; try discriminate; repeat split;
      lra]).
Qed.

Section Balance.
  Variable inside : vector -> bool.
  Variable right_inside : segment -> bool.
  Variable pieces : list segment.
  Hypothesis ends_ : ends_at_pieces inside right_inside pieces.
  Hypothesis in_order : forall e, In e pieces -> comes_first (source e) (target e).

  Let sign := kept_sign right_inside.
  Let inside_ (x : vector) : Z := as_number (inside x).

  Definition weighted (f : segment -> Z) (l : list segment) : Z := sum (map (fun e => (f e * sign e)%Z) l).

  Lemma weighted_same (f g : segment -> Z) (l : list segment) :
    (forall e, In e l -> f e = g e) -> weighted f l = weighted g l.
  Proof. intros same_. unfold weighted. f_equal. apply map_ext_in. intros e E. now rewrite same_. Qed.

  Lemma inside_level (e : segment) (a y : Q) : is_inside_level y a e = true -> strictly_inside (Vector a y) e.
  Proof.
    intros level. destruct (is_inside_level_spec y a e) as [(f1 & f2 & f3 & f4) |]; [| discriminate].
    exists ((a - vx (source e)) / (vx (target e) - vx (source e))).
    assert (value : (a - vx (source e)) / (vx (target e) - vx (source e)) * (vx (target e) - vx (source e)) ==
      a - vx (source e)) by (field; lra).
    split; [split; [apply Qlt_shift_div_l; lra | apply Qlt_shift_div_r; lra] |]. cbn [vx vy]. split; [lra |].
    rewrite f1, f2. ring.
  Qed.

  (* Above and below a point inside no piece but level ones. *)
  Lemma above_and_below (a y : Q) :
    (forall e, In e pieces -> lies_on (Vector a y) e -> is_inside_level y a e = true) ->
    eventually (fun d => (inside_ (Vector a (y + d)) - inside_ (Vector a (y - d)))%Z =
                         weighted (fun e => as_number (is_inside_level y a e)) pieces /\
                         off (Vector a (y + d)) pieces /\ off (Vector a (y - d)) pieces).
  Proof.
    intros level_only. apply eventually_and.
    - destruct (existsb (is_inside_level y a) pieces) eqn:some_level.
      + apply existsb_exists in some_level. destruct some_level as (e & E & level).
        destruct (in_split _ _ E) as (before & after & pieces_are).
        assert (facts : vy (target e) == vy (source e) /\ vy (source e) == y /\ vx (source e) < a /\ a < vx (target e))
          by (now destruct (is_inside_level_spec y a e)).
        destruct facts as (same_height & height_ & after_source & before_target).
        pose proof (inside_level e a y level) as inside_e.
        assert (the_sum : weighted (fun e => as_number (is_inside_level y a e)) pieces = sign e).
        { unfold weighted. rewrite pieces_are, (sums_but_for_one _ _ (fun _ => 0%Z));
            [rewrite sum_of_zeros, level by trivial; cbn [as_number]; lia |].
          intros f F. destruct (is_inside_level y a f) eqn:level_f; [| reflexivity]. exfalso.
          exact (pieces_have_nothing_in_common _ _ _ ends_ before e after f (Vector a y) pieces_are F inside_e
            (inside_level f a y level_f)). }
        rewrite the_sum.
        refine (eventually_implied _ _ _ (eventually_and _ _
          (same_beside_pieces _ _ _ ends_ e e (Vector a y) (Vector 0 (-1)) E (or_introl eq_refl) inside_e _)
          (same_beside_pieces _ _ _ ends_ e (reversed e) (Vector a y) (Vector 0 1) E (or_intror eq_refl)
            (strictly_inside_reversed _ _ inside_e) _))).
        * intros d [below above]. unfold sign, kept_sign, inside_. rewrite <- below, <- above.
          rewrite (same_of_equal _ _ _ ends_ (Vector a (y + d)) (moved_along (Vector a y) (Vector 0 1) d)),
            (same_of_equal _ _ _ ends_ (Vector a (y - d)) (moved_along (Vector a y) (Vector 0 (-1)) d));
            [reflexivity | split; unfold moved_along; cbn [vx vy]; ring ..].
        * unfold cross, along, minus. cbn [vx vy]. lra.
        * unfold cross, along, minus, reversed. cbn [source target vx vy]. lra.
      + assert (none : forall e, In e pieces -> is_inside_level y a e = false).
        { intros e E. destruct (is_inside_level y a e) eqn:level; [| reflexivity].
          assert (existsb (is_inside_level y a) pieces = true) by (apply existsb_exists; now exists e). congruence. }
        assert (the_sum : weighted (fun e => as_number (is_inside_level y a e)) pieces = 0%Z).
        { apply sum_of_zeros. intros e E. now rewrite none. }
        rewrite the_sum.
        assert (free : off (Vector a y) pieces).
        { intros e E on. specialize (level_only e E on). rewrite (none e E) in level_only. discriminate. }
        destruct (unchanged_near _ _ _ ends_ _ free) as (radius & R & near). exists radius. split; [exact R |].
        intros d some small. unfold inside_.
        destruct (near (Vector a (y + d))) as [_ ->]; [unfold within; cbn [vx vy]; lra |].
        destruct (near (Vector a (y - d))) as [_ ->]; [unfold within; cbn [vx vy]; lra |]. lia.
    - assert (each : forall e, In e pieces ->
        eventually (fun d => ~ lies_on (Vector a (y + d)) e /\ ~ lies_on (Vector a (y - d)) e)).
      { intros e E. destruct (lies_on_dec (Vector a y) e) as [on | free].
        - specialize (level_only e E on). destruct (is_inside_level_spec y a e) as [(f1 & f2 & _) |]; [| discriminate].
          exists 1. split; [lra |]. intros d some _.
          split; intros (k & _ & _ & Y); cbn [vy] in Y; rewrite f1, f2 in Y; lra.
        - destruct (off_one_segment_near _ e free) as (radius & R & near). exists radius. split; [exact R |].
          intros d some small. split; apply near; unfold within; cbn [vx vy]; lra. }
      refine (eventually_implied _ _ _ (eventually_for_all _ pieces each)). intros d all. split; intros e E;
        now apply all.
  Qed.

  Variable v : vector.
  Hypothesis v_inside_none : forall e, In e pieces -> ~ strictly_inside v e.

  Lemma weighted_sum (f g : segment -> Z) (l : list segment) :
    weighted (fun e => f e + g e)%Z l = (weighted f l + weighted g l)%Z.
  Proof. unfold weighted, sum. induction l as [| e l IH]; cbn; lia. Qed.

  Theorem balanced_at : weighted (leaves v) pieces = 0%Z.
  Proof.
    (* so near that there are no other pieces and no other ends *)
    assert (near : eventually (fun delta => forall e, In e pieces ->
      (lies_on v e \/ forall y, within (2 * delta) v y -> ~ lies_on y e) /\
      (vx (source e) < vx v -> vx (source e) < vx v - delta) /\ (vx v < vx (target e) -> vx v + delta < vx (target
        e)))).
    { apply (eventually_for_all (fun e delta =>
        (lies_on v e \/ forall y, within (2 * delta) v y -> ~ lies_on y e) /\
        (vx (source e) < vx v -> vx (source e) < vx v - delta) /\
        (vx v < vx (target e) -> vx v + delta < vx (target e)))). intros e E.
      apply eventually_and; [| apply eventually_and].
      - destruct (lies_on_dec v e) as [on | free]; [exists 1; split; [lra | tauto] |].
        destruct (off_one_segment_near v e free) as (radius & R & near). exists ((1 # 2) * radius). split; [lra |].
        intros delta some small. right. intros y close. apply near. refine (within_smaller _ _ _ _ _ close). lra.
      - destruct (Qlt_le_dec (vx (source e)) (vx v)); [| exists 1; split; [lra | intros; lra]].
        exists (vx v - vx (source e)). split; [lra |]. intros; lra.
      - destruct (Qlt_le_dec (vx v) (vx (target e))); [| exists 1; split; [lra | intros; lra]].
        exists (vx (target e) - vx v). split; [lra |]. intros; lra. }
    destruct (some_small _ near) as (delta & wide & near'). clear near. rename near' into near.
    set (a1 := vx v - delta). set (a2 := vx v + delta).
    assert (only_level : forall a, a = a1 \/ a = a2 -> forall e, In e pieces -> lies_on (Vector a (vy v)) e ->
      is_inside_level (vy v) a e = true).
    { intros a which e E on. destruct (near e E) as ([on_v | free] & left_ & right_).
      - destruct (on_but_not_inside v e on_v (v_inside_none e E)) as [[X Y] | [X Y]];
          destruct on as (k & range & kx & ky); cbn [vx vy] in kx, ky;
          pose proof (in_order e E) as order_; unfold comes_first in order_;
          destruct (is_inside_level_spec (vy v) a e) as [| not_level]; trivial; exfalso; apply not_level.
        + assert (k_some : ~ k == 0)
            by (intros none; rewrite none in kx; destruct which as [-> | ->]; unfold a1, a2 in *; lra).
          assert (level : vy (target e) == vy (source e)) by (apply (Qmult_inj_l _ _ k k_some); lra).
          assert (0 <= k * (vx (target e) - vx (source e))) by (apply Qmult_le_0_compat; lra).
          destruct which as [-> | ->]; unfold a1, a2 in *; [exfalso; lra |].
          specialize (right_ ltac:(lra)). repeat split; lra.
        + assert (k_some : ~ 1 - k == 0)
            by (intros none; assert (k == 1) as k_is by lra; rewrite k_is in kx; destruct which as [-> | ->];
                unfold a1, a2 in *; lra).
          assert (level : vy (target e) == vy (source e)) by (apply (Qmult_inj_l _ _ (1 - k) k_some); lra).
          assert (0 <= (1 - k) * (vx (target e) - vx (source e))) by (apply Qmult_le_0_compat; lra).
          destruct which as [-> | ->]; unfold a1, a2 in *; [| exfalso; lra].
          specialize (left_ ltac:(lra)). repeat split; lra.
      - exfalso. apply (free (Vector a (vy v))); [| exact on].
        unfold within. cbn [vx vy]. destruct which as [-> | ->]; unfold a1, a2; lra. }
    set (level_part := fun e => (as_number (is_inside_level (vy v) a1 e) - as_number (is_inside_level (vy v) a2 e))%Z).
    assert (each : forall e, In e pieces ->
      eventually (fun d => corner_crossings v delta d e = (leaves v e + level_part e)%Z)).
    { intros e E. destruct (near e E) as ([on_v | free] & left_ & right_).
      - pose proof (on_but_not_inside v e on_v (v_inside_none e E)) as end_.
        pose proof (in_order e E) as order_. unfold comes_first in order_.
        destruct (is_level e) eqn:level.
        + exists 1. split; [lra |]. intros d _ _. rewrite corners_of_level by exact level. unfold is_level in level.
          destruct (zero_spec (vy (target e) - vy (source e))) as [same_height |]; [| discriminate].
          unfold leaves, level_part.
          destruct (is_inside_level_spec (vy v) a1 e) as [in_1 | out_1],
            (is_inside_level_spec (vy v) a2 e) as [in_2 | out_2],
            (same_point_spec (source e) v) as [s_is | s_not], (same_point_spec (target e) v) as [t_is | t_not];
            cbn [as_number]; try reflexivity; exfalso; unfold a1, a2, equal_vectors in *; try lra;
            try (destruct end_; [tauto | tauto]);
            try (apply out_1; pose proof (left_ ltac:(lra)); repeat split; lra);
            try (apply out_2; pose proof (right_ ltac:(lra)); repeat split; lra).
        + refine (eventually_implied _ _ _ (corners_of_end v delta e wide level end_)). intros d ->.
          unfold level_part, is_inside_level. rewrite level. cbn [andb as_number]. lia.
      - exists delta. split; [exact wide |]. intros d some small. rewrite corners_of_others by assumption.
        assert (no_end : forall w, lies_on w e -> same_point w v = false).
        { intros w on. destruct (same_point_spec w v) as [equal |]; [| reflexivity]. exfalso.
          apply (free w); [| exact on]. unfold within. destruct equal. lra. }
        unfold leaves, level_part. rewrite (no_end _ (source_lies_on e)), (no_end _ (target_lies_on e)).
        assert (not_inside : forall a, a = a1 \/ a = a2 -> is_inside_level (vy v) a e = false).
        { intros a which. destruct (is_inside_level_spec (vy v) a e) as [(e1 & e2 & e3 & e4) |]; [| reflexivity].
          exfalso. apply (free (Vector a (vy v))).
          - unfold within. cbn [vx vy]. destruct which as [-> | ->]; unfold a1, a2; lra.
          - apply strictly_inside_lies_on, inside_level. now destruct (is_inside_level_spec (vy v) a e) as [| []]. }
        rewrite (not_inside a1), (not_inside a2) by tauto. reflexivity. }
    destruct (some_small _ (eventually_and _ _ (eventually_for_all (fun e d => corner_crossings v delta d e =
      (leaves v e + level_part e)%Z) pieces each)
      (eventually_and _ _ (above_and_below a1 (vy v) (only_level a1 (or_introl eq_refl)))
        (above_and_below a2 (vy v) (only_level a2 (or_intror eq_refl))))))
      as (d & _ & corners_ & (jump_1 & free_1 & free_1') & jump_2 & free_2 & free_2').
    assert (by_core : weighted (corner_crossings v delta d) pieces =
      (inside_ (Vector a1 (vy v + d)) - inside_ (Vector a2 (vy v + d))
       - inside_ (Vector a1 (vy v - d)) + inside_ (Vector a2 (vy v - d)))%Z).
    { unfold inside_. rewrite <- !(core_off_pieces _ _ _ ends_) by assumption.
      rewrite !crossings_of_kept. unfold corner_crossings. fold a1 a2. unfold weighted, sign, sum. clear.
      induction pieces as [| e l IH]; cbn; lia. }
    rewrite (weighted_same _ (fun e => leaves v e + level_part e)%Z) in by_core by exact corners_.
    rewrite weighted_sum in by_core.
    assert (level_sum : weighted level_part pieces =
      (weighted (fun e => as_number (is_inside_level (vy v) a1 e)) pieces -
       weighted (fun e => as_number (is_inside_level (vy v) a2 e)) pieces)%Z).
    { unfold weighted, level_part, sum. clear. induction pieces as [| e l IH]; cbn; lia. }
    lia.
  Qed.
End Balance.
