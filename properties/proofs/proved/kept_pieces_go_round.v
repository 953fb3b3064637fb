(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* A set that ends at pieces only, which have no points but ends in common: the pieces that have it on one side go
   round it once. So seen from a point of the set, they are crossed once more in one direction than in the other, and as
   often from elsewhere. Go along the ray to the right, from piece to piece. What the set is does not matter: that its
   points are those of some winding number (rule_of_sides.v), or those where two regions meet. *)
From Coq Require Import QArith Qabs Qminmax Lqa Qfield ZArith Lia Bool List.
From Oplus Require Import direction angle angular_crossings winding_number shifted_ray small_numbers signed_crossings
  tie_rule regions meeting_of_segments first_hit neighbourhoods left_of_an_edge beside_every_point location pieces
  beside_a_piece filling.
Import ListNotations.

Open Scope Q_scope.

Definition ends_avoid (height : Q) (s : segment) : Prop := ~ vy (source s) == height /\ ~ vy (target s) == height.

Lemma inside_at_height (s : segment) (y : Q) : ends_avoid y s -> spans s y = true ->
  strictly_inside (point_at_height s y) s.
Proof. intros [no_source no_target] spanning. apply inside_by_height; trivial. now apply point_at_height_lies_on. Qed.

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

(* No position is taken twice. *)
Definition apart_from_all (pieces : list segment) : Prop :=
  forall before e after f w, pieces = before ++ e :: after -> In f (before ++ after) ->
    strictly_inside w e -> ~ strictly_inside w f.

(* A set of points, of which only those off the pieces matter, and what is said to be to the right of pieces. *)
Record ends_at_pieces (inside : vector -> bool) (right_inside : segment -> bool) (pieces : list segment) : Prop := {
  pieces_have_length : forall e, In e pieces -> nonzero (along e);
  pieces_have_nothing_in_common : apart_from_all pieces;
  same_of_equal : forall a b, equal_vectors a b -> inside a = inside b;
  same_off_pieces : forall a b, (forall w, lies_on w (Segment a b) -> off w pieces) -> inside a = inside b;
  same_beside_pieces : forall e s w n, In e pieces -> s = e \/ s = reversed e -> strictly_inside w s ->
    cross (along s) n < 0 -> eventually (fun d => inside (moved_along w n d) = right_inside s);
  nothing_far_away : exists limit, forall x, limit < vx x -> inside x = false }.

Definition as_number (b : bool) : Z := if b then 1%Z else 0%Z.

Section Core.
  Variable inside : vector -> bool.
  Variable right_inside : segment -> bool.
  Variable pieces : list segment.
  Hypothesis ends_ : ends_at_pieces inside right_inside pieces.

  Let kept := kept_pieces right_inside pieces.

  Definition kept_sign (e : segment) : Z := (as_number (right_inside (reversed e)) - as_number (right_inside e))%Z.

  Lemma kept_is (e s : segment) : In s (kept_piece right_inside e) ->
    kept_piece right_inside e = [s] /\ (s = e \/ s = reversed e).
  Proof.
    unfold kept_piece. destruct (right_inside (reversed e)), (right_inside e); intros I;
      try destruct I as [<- | []]; try destruct I; tauto.
  Qed.

  Lemma crossings_of_kept (x : vector) :
    winding_number x kept = sum (map (fun e => (signed_crossing x e * kept_sign e)%Z) pieces).
  Proof.
    unfold winding_number, kept, kept_pieces. clear ends_. induction pieces as [| e rest IH]; [reflexivity |].
    cbn [flat_map map]. rewrite map_app, sum_of_both, IH. unfold sum at 3. cbn [fold_right]. f_equal.
    unfold kept_piece, kept_sign.
    destruct (right_inside (reversed e)), (right_inside e); cbn [map]; unfold sum;
      cbn [fold_right as_number]; rewrite ?signed_crossing_reversed; lia.
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

    Definition free_at (a : Q) : Prop := forall e, In e pieces -> spans e y = true -> ~ place_at e == a.

    (* A piece that has a point to the right is met there. *)
Lemma met_where_it_is (e : segment) (w : vector) : In e pieces -> vy w == y -> lies_on w e ->
      spans e y = true /\ place_at e == vx w.
    Proof.
      intros E height on. destruct (pieces_avoid e E) as [no_source no_target].
      destruct (met_at_height w e y on height no_source no_target). now split.
    Qed.

    Lemma same_if_none_between (a b : Q) : a <= b -> free_at a ->
      (forall e, In e pieces -> meets_ahead a e = true -> b < place_at e) ->
      inside (Vector a y) = inside (Vector b y).
    Proof.
      intros order free none. apply (same_off_pieces _ _ _ ends_). intros w (k & range & X & Y) e E on.
      cbn [source target vx vy] in X, Y.
      destruct (met_where_it_is e w E) as [spanning where_]; [rewrite Y; ring | exact on |].
      assert (0 <= k * (b - a)) by (apply Qmult_le_0_compat; lra).
      assert (0 <= (1 - k) * (b - a)) by (apply Qmult_le_0_compat; lra).
      destruct (meets_ahead a e) eqn:met; [specialize (none e E met); lra |].
      apply (free e E spanning). apply Qle_antisym; [| lra]. apply Qnot_lt_le. intros ahead.
      destruct (meets_ahead_spec a e) as [| behind]; [discriminate |]. apply behind. now split.
    Qed.

    (* Close to a piece, on its two sides, in the direction in which it goes up. *)
    Lemma beside_the_piece (e : segment) : In e pieces -> spans e y = true ->
      exists up, (direction_of e * kept_sign e)%Z =
          (as_number (right_inside (reversed up)) - as_number (right_inside up))%Z /\
        eventually (fun d => inside (Vector (place_at e + d) y) = right_inside up /\
                             inside (Vector (place_at e - d) y) = right_inside (reversed up)).
    Proof.
      intros E spanning. pose proof (inside_at_height e y (pieces_avoid e E) spanning) as inside_.
      apply heights_of_spanning in spanning.
      assert (found : exists up, (up = e \/ up = reversed e) /\ vy (source up) < vy (target up) /\
        (direction_of e * kept_sign e)%Z = (as_number (right_inside (reversed up)) - as_number (right_inside up))%Z).
      { unfold direction_of, kept_sign. destruct (at_most_spec (vy (source e)) y); [exists e | exists (reversed e)];
          rewrite ?reversed_twice; cbn [reversed source target]; (split; [tauto |]); (split; [lra | lia]). }
      destruct found as (up & which & rising & sign_). exists up. split; [exact sign_ |].
      assert (inside_up : strictly_inside (point_at_height e y) up)
        by (destruct which as [-> | ->]; [exact inside_ | now apply strictly_inside_reversed]).
      assert (back : reversed up = e \/ reversed up = reversed e)
        by (destruct which as [-> | ->]; [now right | left; apply reversed_twice]).
      refine (eventually_implied _ _ _ (eventually_and _ _
        (same_beside_pieces _ _ _ ends_ e up _ (Vector 1 0) E which inside_up ltac:(in_coordinates; lra))
        (same_beside_pieces _ _ _ ends_ e (reversed up) _ (Vector (-1) 0) E back
          (strictly_inside_reversed _ _ inside_up) ltac:(in_coordinates; lra)))).
      intros d [<- <-]. split; apply (same_of_equal _ _ _ ends_); unfold moved_along, place_at, point_at_height;
        split; cbn [vx vy]; ring.
    Qed.

    (* At a height at which there are no ends. *)
    Lemma core_at_height (fuel : nat) : forall a, free_at a -> (length (filter (meets_ahead a) pieces) <= fuel)%nat ->
      winding_number (Vector a y) kept = as_number (inside (Vector a y)).
    Proof.
      induction fuel as [| fuel IH]; intros a free few.
      - assert (none : forall e, In e pieces -> meets_ahead a e = false).
        { intros e E. destruct (meets_ahead a e) eqn:ahead; [| reflexivity]. exfalso.
          assert (In e (filter (meets_ahead a) pieces)) as found by (now apply filter_In).
          destruct (filter (meets_ahead a) pieces); [destruct found | cbn in few; lia]. }
        rewrite crossings_of_kept, sum_of_zeros by (intros e E; now rewrite crossing_at_height, none).
        destruct (nothing_far_away _ _ _ ends_) as (limit & far).
        rewrite (same_if_none_between a (Qmax (limit + 1) a)); trivial.
        + rewrite far; [reflexivity |]. cbn [vx]. pose proof (Q.le_max_l (limit + 1) a). lra.
        + apply Q.le_max_r.
        + intros e E ahead. now rewrite none in ahead.
      - destruct (filter (meets_ahead a) pieces) as [| first_ others] eqn:met.
        { apply IH; [exact free |]. rewrite met. cbn. lia. }
        destruct (least_of place_at (filter (meets_ahead a) pieces)) as (e & listed & least); [now rewrite met |].
        apply filter_In in listed. destruct listed as [E ahead].
        assert (least_piece : forall f, In f pieces -> meets_ahead a f = true -> place_at e <= place_at f).
        { intros f F ahead_f. apply least. now apply filter_In. }
        assert (facts : spans e y = true /\ a < place_at e) by (now destruct (meets_ahead_spec a e)).
        destruct facts as [spanning before]. destruct (in_split _ _ E) as (earlier & later & pieces_are).
        assert (part : incl (earlier ++ later) pieces).
        { intros f F. rewrite pieces_are. apply in_app_iff in F. apply in_app_iff. cbn. tauto. }
        assert (others_beyond : forall f, In f (earlier ++ later) -> meets_ahead a f = true ->
          place_at e < place_at f).
        { intros f F ahead_f. pose proof (part f F) as F'.
          destruct (Q_dec (place_at e) (place_at f)) as [[less | more] | equal]; [exact less | |].
          - pose proof (least_piece f F' ahead_f). lra.
          - exfalso. destruct (meets_ahead_spec a f) as [[spanning_f _] |]; [| discriminate].
            pose proof (inside_at_height e y (pieces_avoid e E) spanning) as inside_e.
            pose proof (inside_at_height f y (pieces_avoid f F') spanning_f) as inside_f.
            apply (pieces_have_nothing_in_common _ _ _ ends_ earlier e later f (point_at_height e y) pieces_are F
              inside_e).
            destruct inside_f as (k & range & X & Y). exists k. split; [exact range |].
            split; [| exact Y]. unfold place_at in equal. now rewrite equal. }
        (* a little further, and a little before *)
        assert (gaps : eventually (fun d => forall f, In f (earlier ++ later) -> meets_ahead a f = true ->
          place_at e + d < place_at f)).
        { apply (eventually_for_all (fun f d => meets_ahead a f = true -> place_at e + d < place_at f)). intros f F.
          destruct (meets_ahead a f) eqn:ahead_f.
          - pose proof (others_beyond f F ahead_f). exists (place_at f - place_at e). split; [lra |]. intros; lra.
          - exists 1. split; [lra |]. discriminate. }
        destruct (beside_the_piece e E spanning) as (up & sign_ & beside_).
        destruct (some_small _ (eventually_and _ _ gaps (eventually_and _ _ beside_
          (eventually_below (place_at e - a) ltac:(lra)))))
          as (d & _ & beyond & (after_number & before_number) & d_some & d_small).
        rewrite (same_if_none_between a (place_at e - d)); [| lra | exact free |].
        2: { intros f F ahead_f. pose proof (least_piece f F ahead_f). lra. }
        assert (passed : meets_ahead (place_at e + d) e = false).
        { destruct (meets_ahead_spec (place_at e + d) e) as [[_ wrong] |]; [lra | reflexivity]. }
        assert (same_others : forall f, In f (earlier ++ later) -> meets_ahead (place_at e + d) f = meets_ahead a f).
        { intros f F. destruct (meets_ahead a f) eqn:ahead_f.
          - pose proof (beyond f F ahead_f). destruct (meets_ahead_spec a f) as [[spanning_f _] |]; [| discriminate].
            destruct (meets_ahead_spec (place_at e + d) f) as [| no]; [reflexivity |]. exfalso. apply no.
            split; [assumption | lra].
          - destruct (meets_ahead_spec (place_at e + d) f) as [[spanning_f beyond_f] |]; [| reflexivity].
            destruct (meets_ahead_spec a f) as [| no]; [discriminate |]. exfalso. apply no. split; [assumption | lra]. }
        assert (free_after : free_at (place_at e + d)).
        { intros f F spanning_f where_. rewrite pieces_are in F. apply in_elt_inv in F.
          destruct F as [<- | F]; [lra |]. assert (ahead_f : meets_ahead a f = true).
          { destruct (meets_ahead_spec a f) as [| no]; [reflexivity |]. exfalso. apply no. split; [assumption | lra]. }
          pose proof (beyond f F ahead_f). lra. }
        assert (fewer : (length (filter (meets_ahead (place_at e + d)) pieces) <= fuel)%nat).
        { rewrite <- met in few. rewrite pieces_are in few |- *. rewrite !filter_app, !app_length in few |- *.
          cbn [filter] in *. rewrite passed. rewrite ahead in few. cbn [length] in few.
          assert (alike : forall l, incl l (earlier ++ later) ->
            filter (meets_ahead (place_at e + d)) l = filter (meets_ahead a) l).
          { intros l part'. apply filter_ext_in. intros f F. apply same_others, part', F. }
          rewrite (alike earlier), (alike later); [lia | |]; intros f F; apply in_app_iff; tauto. }
        specialize (IH (place_at e + d) free_after fewer).
        assert (step : winding_number (Vector a y) kept =
          (winding_number (Vector (place_at e + d) y) kept + direction_of e * kept_sign e)%Z).
        { rewrite !crossings_of_kept, pieces_are, (sums_but_for_one _ _ (fun f =>
            signed_crossing (Vector (place_at e + d) y) f * kept_sign f)%Z), !crossing_at_height, ahead, passed;
              [lia |].
          intros f F. now rewrite !crossing_at_height, (same_others f F). }
        rewrite step, IH, before_number, after_number. lia.
    Qed.
  End OneHeight.

  (* Theorem. Seen from anywhere, also from points on the pieces: the winding number is that close beside. *)
  Theorem core (x : vector) :
    eventually (fun d => winding_number x kept = as_number (inside (moved (shifted x) d))).
  Proof.
    assert (beside : eventually (fun d =>
      (forall s, In s kept -> signed_crossing (moved (shifted x) d) s = signed_crossing x s) /\
      (forall e, In e pieces -> ends_avoid (vy (moved (shifted x) d)) e) /\ off (moved (shifted x) d) pieces)).
    { apply eventually_and; [| apply eventually_and; [| apply shifted_off_all]].
      - apply (eventually_for_all (fun s d => signed_crossing (moved (shifted x) d) s = signed_crossing x s)).
        intros s _. apply crossing_beside.
      - apply (eventually_for_all (fun s d => ends_avoid (vy (moved (shifted x) d)) s)). intros s _.
        refine (eventually_implied _ _ _ (eventually_and _ _
          (below_nearby (shifted x) (source s) (shifted_leaves_its_height x))
          (below_nearby (shifted x) (target s) (shifted_leaves_its_height x)))).
        intros d ((_ & no_source) & (_ & no_target)). now split. }
    refine (eventually_implied _ _ _ beside). intros d (same_crossing & avoid & free).
    assert (same_number : winding_number x kept = winding_number (moved (shifted x) d) kept).
    { unfold winding_number. f_equal. apply map_ext_in. intros s S. symmetry. now apply same_crossing. }
    rewrite same_number. destruct (moved (shifted x) d) as [a y]. cbn [vy] in avoid.
    apply (core_at_height y avoid (length (filter (meets_ahead y a) pieces))); [| lia].
    intros e E spanning where_. apply (free e E).
    refine (lies_on_equal (point_at_height e y) _ e _ (point_at_height_lies_on e y spanning)).
    split; [exact where_ | reflexivity].
  Qed.

  (* A set that ends at the pieces does not end around a point off them. *)
  Lemma unchanged_near (x : vector) : off x pieces ->
    exists radius, 0 < radius /\ forall y, within radius x y -> off y pieces /\ inside y = inside x.
  Proof.
    intros free. destruct (off_near x pieces free) as (radius & R & near). exists radius. split; [exact R |].
    intros y close. split; [now apply near |]. symmetry. apply (same_off_pieces _ _ _ ends_). intros w on. apply near.
    apply (within_along radius x x y); trivial. unfold within. lra.
  Qed.

  Corollary core_off_pieces (x : vector) : off x pieces -> winding_number x kept = as_number (inside x).
  Proof.
    intros free. destruct (unchanged_near x free) as (radius & R & near).
    destruct (some_small _ (eventually_and _ _ (core x) (shifted_stays_within radius x R))) as (e & _ & -> & close).
    now destruct (near _ close) as [_ ->].
  Qed.
End Core.
