(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Closed segments cut into pieces that have no points but ends in common: the pieces with a positive winding number to
   the left and none to the right (filling.v) are crossed once, as seen from where the winding number is positive, and
   as often in one direction as in the other from elsewhere. Go along the ray to the right, from piece to piece. *)
From Coq Require Import QArith Qabs Qminmax Lqa Qfield ZArith Lia Bool List.
From Oplus Require Import balanced_edges direction angle angular_crossings winding_number shifted_ray signed_crossings
  tie_rule regions meeting_of_segments first_hit neighbourhoods left_of_an_edge beside_every_point right_of_an_edge
  location pieces beside_a_piece filling.
Import ListNotations.

Open Scope Q_scope.

Definition ends_avoid (height : Q) (s : segment) : Prop := ~ vy (source s) == height /\ ~ vy (target s) == height.

Lemma spans_at (s : segment) (w : vector) : ends_avoid (vy w) s -> lies_on w s ->
  spans s (vy w) = true /\ vx (point_at_height s (vy w)) == vx w.
Proof.
  intros [no_source no_target] (k & range & X & Y).
  set (a := vy (source s)) in *. set (b := vy (target s)) in *.
  assert (sides : (a < vy w /\ vy w < b) \/ (b < vy w /\ vy w < a)).
  { destruct (Q_dec a (vy w)) as [[? | ?] | ?]; [| | contradiction];
      (destruct (Q_dec b (vy w)) as [[? | ?] | ?]; [| | contradiction]); try tauto; exfalso.
    - assert (0 <= (1 - k) * (vy w - a)) by (apply Qmult_le_0_compat; lra).
      assert (0 <= k * (vy w - b)) by (apply Qmult_le_0_compat; lra).
      destruct (Qlt_le_dec 0 k).
      + assert (0 < k * (vy w - b)) by (apply Qmult_lt_0_compat; lra). lra.
      + assert (k == 0) as k_is by lra. rewrite k_is in Y. lra.
    - assert (0 <= (1 - k) * (a - vy w)) by (apply Qmult_le_0_compat; lra).
      assert (0 <= k * (b - vy w)) by (apply Qmult_le_0_compat; lra).
      destruct (Qlt_le_dec 0 k).
      + assert (0 < k * (b - vy w)) by (apply Qmult_lt_0_compat; lra). lra.
      + assert (k == 0) as k_is by lra. rewrite k_is in Y. lra. }
  split.
  - unfold spans. fold a b. destruct (at_most_spec a (vy w)), (at_most_spec b (vy w)); try reflexivity; exfalso; lra.
  - unfold point_at_height. cbn [vx]. fold a b.
    assert (fraction_ : (vy w - a) / (b - a) == k).
    { apply (Qmult_inj_r _ _ (b - a)); [lra |].
      setoid_replace ((vy w - a) / (b - a) * (b - a)) with (vy w - a) by (field; lra). rewrite Y. ring. }
    rewrite fraction_, X. ring.
Qed.

Lemma inside_at_height (s : segment) (y : Q) : ends_avoid y s -> spans s y = true ->
  strictly_inside (point_at_height s y) s.
Proof.
  intros [no_source no_target] spanning. pose proof (heights_of_spanning s y spanning) as heights.
  destruct (point_at_height_lies_on s y spanning) as (k & range & X & Y). exists k. split; [| split; assumption].
  change (vy (point_at_height s y)) with y in Y.
  split; apply Qnot_le_lt; intros extreme.
  - apply no_source. assert (k == 0) as k_is by lra. rewrite Y, k_is. ring.
  - apply no_target. assert (k == 1) as k_is by lra. rewrite Y, k_is. ring.
Qed.

Lemma spans_reversed (s : segment) (y : Q) : spans (reversed s) y = spans s y.
Proof. unfold spans, reversed. cbn [source target]. apply xorb_comm. Qed.

Lemma reversed_at_height (s : segment) (y : Q) : spans s y = true ->
  vx (point_at_height (reversed s) y) == vx (point_at_height s y).
Proof.
  intros spanning. apply heights_of_spanning in spanning. unfold point_at_height, reversed. cbn [source target vx].
  field. split; lra.
Qed.

Lemma signed_crossing_reversed (x : vector) (s : segment) :
  signed_crossing x (reversed s) = (- signed_crossing x s)%Z.
Proof.
  rewrite !signed_crossing_by_height, spans_reversed. destruct (spans s (vy x)) eqn:spanning; [| reflexivity].
  pose proof (reversed_at_height s (vy x) spanning) as same_place.
  cbn [andb]. destruct (negative_spec (vx x - vx (point_at_height (reversed s) (vy x)))),
    (negative_spec (vx x - vx (point_at_height s (vy x)))); try (exfalso; lra); [| reflexivity].
  unfold spans in spanning. cbn [reversed source target].
  destruct (at_most (vy (source s)) (vy x)), (at_most (vy (target s)) (vy x)); try discriminate; reflexivity.
Qed.

Lemma strictly_inside_reversed (w : vector) (s : segment) : strictly_inside w s -> strictly_inside w (reversed s).
Proof.
  intros (k & range & X & Y). exists (1 - k). cbn [reversed source target]. split; [lra |].
  rewrite X, Y. split; ring.
Qed.

Lemma area_reversed (s : segment) (w : vector) : area (reversed s) w == - area s w.
Proof. unfold area, cross, minus, reversed. cbn [source target vx vy]. ring. Qed.

Lemma reversed_twice (s : segment) : reversed (reversed s) = s.
Proof. now destruct s. Qed.

Lemma met_only_along_reversed (segments : list segment) (s : segment) :
  met_only_along segments s -> met_only_along segments (reversed s).
Proof.
  intros only w t inside_ J on. apply strictly_inside_reversed in inside_. rewrite reversed_twice in inside_.
  destruct (only w t inside_ J on) as [a b]. split; rewrite area_reversed; lra.
Qed.

(* No position is taken twice. *)
Definition apart_from_all (pieces : list segment) : Prop :=
  forall before e after f w, pieces = before ++ e :: after -> In f (before ++ after) ->
    strictly_inside w e -> ~ strictly_inside w f.

(* What is asked of the pieces. *)
Record are_pieces (segments pieces : list segment) : Prop := {
  pieces_are_long : forall e, In e pieces -> nonzero (along e);
  pieces_are_on : forall e w, In e pieces -> lies_on w e -> exists t, In t segments /\ lies_on w t;
  pieces_are_all : forall t w, In t segments -> lies_on w t -> exists e, In e pieces /\ lies_on w e;
  pieces_are_met_along : forall e, In e pieces -> met_only_along segments e;
  pieces_are_apart : apart_from_all pieces }.

Definition as_number (b : bool) : Z := if b then 1%Z else 0%Z.

Section Core.
  Variables segments pieces : list segment.
  Hypothesis closed : cycles segments.
  Hypothesis cut_ : are_pieces segments pieces.

  Definition kept_sign (e : segment) : Z :=
    (as_number (is_right_inside segments (reversed e)) - as_number (is_right_inside segments e))%Z.

  Definition kept_pieces : list segment := flat_map (kept_piece segments) pieces.

  Lemma crossings_of_kept (x : vector) :
    winding_number x kept_pieces = sum (map (fun e => (signed_crossing x e * kept_sign e)%Z) pieces).
  Proof.
    unfold winding_number, kept_pieces. clear cut_. induction pieces as [| e rest IH]; [reflexivity |].
    cbn [flat_map map]. rewrite map_app, sum_of_both, IH. unfold sum at 3. cbn [fold_right]. f_equal.
    unfold kept_piece, kept_sign.
    destruct (is_right_inside segments (reversed e)), (is_right_inside segments e); cbn [map]; unfold sum;
      cbn [fold_right as_number]; rewrite ?signed_crossing_reversed; lia.
  Qed.

  Lemma kept_are_on (f : segment) (w : vector) : In f kept_pieces -> lies_on w f ->
    exists t, In t segments /\ lies_on w t.
  Proof.
    intros I on. apply in_flat_map in I. destruct I as (e & E & I).
    apply (pieces_are_on _ _ cut_ e); [exact E |]. unfold kept_piece in I.
    assert (back : forall s, lies_on w (reversed s) -> lies_on w s).
    { intros s (k & range & X & Y). exists (1 - k). cbn [reversed source target] in *. split; [lra |].
      rewrite X, Y. split; ring. }
    destruct (is_right_inside segments (reversed e)), (is_right_inside segments e); try easy;
      destruct I as [<- | []]; [exact on | now apply back].
  Qed.

  Section OneHeight.
    Variable y : Q.
    Hypothesis pieces_avoid : forall e, In e pieces -> ends_avoid y e.

    Definition place_at (s : segment) : Q := vx (point_at_height s y).
    Definition meets_ahead (a : Q) (s : segment) : bool := spans s y && negative (a - place_at s).

    Lemma meets_ahead_spec (a : Q) (s : segment) : reflect (spans s y = true /\ a < place_at s) (meets_ahead a s).
    Proof.
      unfold meets_ahead. apply iff_reflect. rewrite andb_true_iff.
      destruct (negative_spec (a - place_at s)); (split; intros [u v]; split; trivial; try lra; try discriminate).
    Qed.

    Definition direction_of (s : segment) : Z := if at_most (vy (source s)) y then 1%Z else (-1)%Z.

    Lemma crossing_at_height (a : Q) (s : segment) :
      signed_crossing (Vector a y) s = if meets_ahead a s then direction_of s else 0%Z.
    Proof. now rewrite signed_crossing_by_height. Qed.

    (* For each segment ahead a piece is ahead, at the same place. *)
    Lemma segment_has_a_piece (t : segment) (a : Q) : In t segments -> meets_ahead a t = true ->
      exists e, In e pieces /\ meets_ahead a e = true /\ place_at e == place_at t.
    Proof.
      intros J ahead. destruct (meets_ahead_spec a t) as [[spanning before] |]; [| discriminate].
      destruct (pieces_are_all _ _ cut_ t _ J (point_at_height_lies_on t y spanning)) as (e & E & on).
      destruct (spans_at e (point_at_height t y) (pieces_avoid e E) on) as [spanning_e place_e].
      change (vy (point_at_height t y)) with y in *. exists e. split; [exact E |].
      assert (same_place : place_at e == place_at t) by exact place_e. split; [| exact same_place].
      destruct (meets_ahead_spec a e) as [| not_ahead]; [reflexivity |]. exfalso. apply not_ahead.
      split; [exact spanning_e | lra].
    Qed.

    Definition inside_at (a : Q) : bool := (0 <? winding_number (Vector a y) segments)%Z.

    (* Close to a piece, on its two sides. *)
    Lemma beside_the_piece (e : segment) : In e pieces -> spans e y = true ->
      eventually (fun d =>
        inside_at (place_at e + d) = is_right_inside segments (if at_most (vy (source e)) y then e else reversed e) /\
        inside_at (place_at e - d) = is_right_inside segments (if at_most (vy (source e)) y then reversed e else e)).
    Proof.
      intros E spanning. pose proof (pieces_are_long _ _ cut_ e E) as long.
      pose proof (pieces_are_met_along _ _ cut_ e E) as only.
      pose proof (met_only_along_reversed _ _ only) as only_back.
      assert (long_back : nonzero (along (reversed e))).
      { intros [X Y]. apply long. unfold along, minus, reversed in *. cbn [source target vx vy] in *. split; lra. }
      pose proof (inside_at_height e y (pieces_avoid e E) spanning) as inside_.
      pose proof (strictly_inside_reversed _ _ inside_) as inside_back.
      apply heights_of_spanning in spanning. destruct (pieces_avoid e E) as [no_source no_target].
      assert (same_point : forall d, equal_vectors (moved_along (point_at_height e y) (Vector 1 0) d)
                                                    (Vector (place_at e + d) y) /\
                                     equal_vectors (moved_along (point_at_height e y) (Vector (-1) 0) d)
                                                    (Vector (place_at e - d) y)).
      { intros d. unfold moved_along, equal_vectors, place_at, point_at_height. cbn [vx vy]. repeat split; ring. }
      unfold inside_at, is_right_inside.
      destruct (at_most_spec (vy (source e)) y) as [up | down].
      - refine (eventually_implied _ _ _ (eventually_and _ _
          (to_the_right_of_a_piece segments e closed only long _ (Vector 1 0) inside_ _)
          (to_the_right_of_a_piece segments (reversed e) closed only_back long_back _ (Vector (-1) 0) inside_back _))).
        + intros d [right_ left_]. destruct (same_point d) as [[X1 Y1] [X2 Y2]].
          rewrite <- (winding_number_of_equal _ _ _ X1 Y1), <- (winding_number_of_equal _ _ _ X2 Y2).
          now rewrite right_, left_.
        + unfold cross, along, minus. cbn [vx vy]. lra.
        + unfold cross, along, minus, reversed. cbn [source target vx vy]. lra.
      - refine (eventually_implied _ _ _ (eventually_and _ _
          (to_the_right_of_a_piece segments (reversed e) closed only_back long_back _ (Vector 1 0) inside_back _)
          (to_the_right_of_a_piece segments e closed only long _ (Vector (-1) 0) inside_ _))).
        + intros d [right_ left_]. destruct (same_point d) as [[X1 Y1] [X2 Y2]].
          rewrite <- (winding_number_of_equal _ _ _ X1 Y1), <- (winding_number_of_equal _ _ _ X2 Y2).
          now rewrite right_, left_.
        + unfold cross, along, minus, reversed. cbn [source target vx vy]. lra.
        + unfold cross, along, minus. cbn [vx vy]. lra.
    Qed.

    Lemma same_if_the_same_are_ahead (a b : Q) (l : list segment) :
      (forall t, In t l -> meets_ahead a t = meets_ahead b t) ->
      winding_number (Vector a y) l = winding_number (Vector b y) l.
    Proof.
      intros same_ahead. unfold winding_number. f_equal. apply map_ext_in. intros t J.
      now rewrite !crossing_at_height, same_ahead.
    Qed.

    Lemma count_of_two_lists (f : segment -> bool) (l m : list segment) :
      length (filter f (l ++ m)) = (length (filter f l) + length (filter f m))%nat.
    Proof. now rewrite filter_app, app_length. Qed.

    (* At a height at which there are no ends. *)
    Lemma core_at_height (fuel : nat) : forall a, (length (filter (meets_ahead a) pieces) <= fuel)%nat ->
      winding_number (Vector a y) kept_pieces = as_number (inside_at a).
    Proof.
      induction fuel as [| fuel IH]; intros a few.
      - assert (none : forall e, In e pieces -> meets_ahead a e = false).
        { intros e E. destruct (meets_ahead a e) eqn:ahead; [| reflexivity]. exfalso.
          assert (In e (filter (meets_ahead a) pieces)) as found by (now apply filter_In).
          destruct (filter (meets_ahead a) pieces); [destruct found | cbn in few; lia]. }
        rewrite crossings_of_kept. unfold inside_at.
        assert (zero_sum : forall l, (forall e, In e l -> signed_crossing (Vector a y) e = 0%Z) ->
          sum (map (fun e => (signed_crossing (Vector a y) e * kept_sign e)%Z) l) = 0%Z /\
          winding_number (Vector a y) l = 0%Z).
        { unfold winding_number, sum. induction l as [| e l IHl]; intros all_zero; [split; reflexivity |].
          cbn [map fold_right]. destruct IHl as [one two]; [intros; apply all_zero; now right |].
          rewrite one, two, (all_zero e) by now left. split; reflexivity. }
        destruct (zero_sum pieces) as [-> _].
        { intros e E. now rewrite crossing_at_height, none. }
        destruct (zero_sum segments) as [_ ->]; [| reflexivity].
        intros t J. rewrite crossing_at_height. destruct (meets_ahead a t) eqn:ahead; [| reflexivity].
        destruct (segment_has_a_piece t a J ahead) as (e & E & ahead_e & _). now rewrite none in ahead_e.
      - destruct (filter (meets_ahead a) pieces) as [| first_ others] eqn:met.
        { apply IH. rewrite met. cbn. lia. }
        destruct (least_of place_at (filter (meets_ahead a) pieces)) as (e & listed & least); [now rewrite met |].
        apply filter_In in listed. destruct listed as [E ahead].
        assert (least_piece : forall f, In f pieces -> meets_ahead a f = true -> place_at e <= place_at f).
        { intros f F ahead_f. apply least. now apply filter_In. }
        assert (least_segment : forall t, In t segments -> meets_ahead a t = true -> place_at e <= place_at t).
        { intros t J ahead_t. destruct (segment_has_a_piece t a J ahead_t) as (f & F & ahead_f & same_place).
          rewrite <- same_place. now apply least_piece. }
        assert (facts : spans e y = true /\ a < place_at e) by (now destruct (meets_ahead_spec a e)).
        destruct facts as [spanning before]. destruct (in_split _ _ E) as (earlier & later & pieces_are).
        assert (others_beyond : forall f, In f (earlier ++ later) -> meets_ahead a f = true -> place_at e < place_at f).
        { intros f F ahead_f. assert (F' : In f pieces).
          { rewrite pieces_are. apply in_app_iff in F. apply in_app_iff. cbn. tauto. }
          destruct (Q_dec (place_at e) (place_at f)) as [[less | more] | equal]; [exact less | |].
          - pose proof (least_piece f F' ahead_f). lra.
          - exfalso. destruct (meets_ahead_spec a f) as [[spanning_f _] |]; [| discriminate].
            pose proof (inside_at_height e y (pieces_avoid e E) spanning) as inside_e.
            pose proof (inside_at_height f y (pieces_avoid f F') spanning_f) as inside_f.
            apply (pieces_are_apart _ _ cut_ earlier e later f (point_at_height e y) pieces_are F inside_e).
            destruct inside_f as (k & range & X & Y). exists k. split; [exact range |].
            split; [| exact Y]. unfold place_at in equal. now rewrite equal. }
        (* a little further, and a little before *)
        assert (gaps : eventually (fun d => forall f, In f (earlier ++ later) -> meets_ahead a f = true ->
          place_at e + d < place_at f)).
        { apply (eventually_for_all (fun f d => meets_ahead a f = true -> place_at e + d < place_at f)). intros f F.
          destruct (meets_ahead a f) eqn:ahead_f.
          - pose proof (others_beyond f F ahead_f). exists (place_at f - place_at e). split; [lra |]. intros; lra.
          - exists 1. split; [lra |]. discriminate. }
        destruct (eventually_and _ _ gaps (eventually_and _ _ (beside_the_piece e E spanning)
          (ex_intro _ (place_at e - a) (conj (ltac:(lra) : 0 < place_at e - a)
            (fun d some small => conj some small : 0 < d /\ d < place_at e - a))))) as (limit & L & near).
        destruct (near ((1 # 2) * limit)) as (beyond & (after_number & before_number) & d_some & d_small);
          [lra | lra |].
        set (d := (1 # 2) * limit) in *. clearbody d. clear near gaps L limit.
        assert (number_before : inside_at a = inside_at (place_at e - d)).
        { unfold inside_at. rewrite (same_if_the_same_are_ahead a (place_at e - d)); [reflexivity |]. intros t J.
          destruct (meets_ahead a t) eqn:ahead_t.
          - pose proof (least_segment t J ahead_t). destruct (meets_ahead_spec a t) as [[spanning_t _] |];
              [| discriminate].
            destruct (meets_ahead_spec (place_at e - d) t) as [| no]; [reflexivity |]. exfalso. apply no. split;
              [assumption | lra].
          - destruct (meets_ahead_spec (place_at e - d) t) as [[spanning_t beyond_t] |]; [| reflexivity].
            destruct (meets_ahead_spec a t) as [| no]; [discriminate |]. exfalso. apply no. split; [assumption | lra]. }
        assert (same_others : forall f, In f (earlier ++ later) -> meets_ahead (place_at e + d) f = meets_ahead a f).
        { intros f F. destruct (meets_ahead a f) eqn:ahead_f.
          - pose proof (beyond f F ahead_f). destruct (meets_ahead_spec a f) as [[spanning_f _] |]; [| discriminate].
            destruct (meets_ahead_spec (place_at e + d) f) as [| no]; [reflexivity |]. exfalso. apply no. split;
              [assumption | lra].
          - destruct (meets_ahead_spec (place_at e + d) f) as [[spanning_f beyond_f] |]; [| reflexivity].
            destruct (meets_ahead_spec a f) as [| no]; [discriminate |]. exfalso. apply no. split; [assumption | lra]. }
        assert (passed : meets_ahead (place_at e + d) e = false).
        { destruct (meets_ahead_spec (place_at e + d) e) as [[_ wrong] |]; [lra | reflexivity]. }
        assert (fewer : (length (filter (meets_ahead (place_at e + d)) pieces) <= fuel)%nat).
        { rewrite <- met in few. rewrite pieces_are in few |- *. rewrite count_of_two_lists in few |- *.
          cbn [filter] in *. rewrite passed. rewrite ahead in few. cbn [length] in few.
          assert (alike : forall l, incl l (earlier ++ later) -> filter (meets_ahead (place_at e + d)) l = filter
            (meets_ahead a) l).
          { intros l part. apply filter_ext_in. intros f F. apply same_others, part, F. }
          rewrite (alike earlier), (alike later); [lia | |]; intros f F; apply in_app_iff; tauto. }
        specialize (IH (place_at e + d) fewer).
        assert (step : winding_number (Vector a y) kept_pieces =
          (winding_number (Vector (place_at e + d) y) kept_pieces + direction_of e * kept_sign e)%Z).
        { rewrite !crossings_of_kept, pieces_are, !map_app, !sum_of_both. cbn [map].
          assert (alike : forall l, incl l (earlier ++ later) ->
            map (fun f => (signed_crossing (Vector a y) f * kept_sign f)%Z) l =
            map (fun f => (signed_crossing (Vector (place_at e + d) y) f * kept_sign f)%Z) l).
          { intros l part. apply map_ext_in. intros f F.
            now rewrite !crossing_at_height, (same_others f (part f F)). }
          rewrite (alike earlier), (alike later); [| intros f F; apply in_app_iff; tauto ..].
          unfold sum at 2 4. cbn [fold_right]. rewrite !crossing_at_height, ahead, passed.
          change (fold_right Z.add 0%Z) with sum. lia. }
        rewrite step, IH, number_before, before_number, after_number. unfold kept_sign, direction_of.
        destruct (at_most (vy (source e)) y); lia.
    Qed.
  End OneHeight.

  (* Theorem. Seen from anywhere, also from points on the segments. *)
  Theorem core (x : vector) :
    winding_number x kept_pieces = as_number (0 <? winding_number x segments)%Z.
  Proof.
    assert (beside : eventually (fun d => forall s, In s (segments ++ pieces ++ kept_pieces) ->
      signed_crossing (moved (shifted x) d) s = signed_crossing x s /\ ends_avoid (vy (moved (shifted x) d)) s)).
    { apply (eventually_for_all (fun s d => signed_crossing (moved (shifted x) d) s = signed_crossing x s /\
        ends_avoid (vy (moved (shifted x) d)) s)). intros s _.
      refine (eventually_implied _ _ _ (eventually_and _ _ (crossing_beside x s) (eventually_and _ _
        (below_nearby (shifted x) (source s) (shifted_leaves_its_height x))
        (below_nearby (shifted x) (target s) (shifted_leaves_its_height x))))).
      intros d (same_crossing & (_ & no_source) & (_ & no_target)). split; [exact same_crossing | now split]. }
    destruct beside as (limit & L & near). specialize (near ((1 # 2) * limit)).
    set (z := moved (shifted x) ((1 # 2) * limit)) in *.
    assert (good : forall s, In s (segments ++ pieces ++ kept_pieces) ->
      signed_crossing z s = signed_crossing x s /\ ends_avoid (vy z) s) by (apply near; lra).
    clear near. clearbody z.
    assert (same_number : forall l, incl l (segments ++ pieces ++ kept_pieces) ->
      winding_number x l = winding_number z l).
    { intros l part. unfold winding_number. f_equal. apply map_ext_in. intros s I. symmetry. now apply good, part. }
    rewrite !same_number by (intros s I; rewrite !in_app_iff; tauto). destruct z as [a y].
    apply (core_at_height y) with (fuel := length (filter (meets_ahead y a) pieces)); [| lia].
    intros e E. apply good. rewrite !in_app_iff. tauto.
  Qed.
End Core.
