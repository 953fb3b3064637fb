(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* A set that ends at pieces only, which have no points but ends in common: the pieces that have it on one side go
   round it once. So seen from a point of the set, they are crossed once more in one direction than in the other, and as
   often from elsewhere. Go along the ray to the right, from piece to piece. What the set is does not matter: that its
   points are those of some winding number (rule_of_sides.v), or those where two regions meet. *)
From Coq Require Import QArith Qabs Qminmax Lqa Qfield ZArith Lia Bool List Permutation.
From Oplus Require Import balanced_edges direction angle angular_crossings winding_number shifted_ray small_numbers
  signed_crossings tie_rule regions meeting_of_segments first_hit neighbourhoods left_of_an_edge beside_every_point
  location pieces beside_a_piece filling.
Import ListNotations.

Open Scope Q_scope.

Definition ends_avoid (height : Q) (s : segment) : Prop := ~ vy (source s) == height /\ ~ vy (target s) == height.

Lemma inside_at_height (s : segment) (y : Q) : ends_avoid y s -> spans s y = true ->
  strictly_inside (point_at_height s y) s.
Proof. intros [no_source no_target] spanning. apply inside_by_height; trivial. now apply point_at_height_lies_on. Qed.

Lemma signed_crossing_reversed (x : vector) (s : segment) :
  signed_crossing x (reversed s) = (- signed_crossing x s)%Z.
Proof.
  pose proof (area_reversed s x) as turned. destruct s as [a b]. unfold signed_crossing, ray_crossing, reversed in *.
  cbn [source target] in *. rewrite !orientation_by_area.
  destruct (at_most (vy a) (vy x)), (at_most (vy b) (vy x)); cbn [Bool.eqb]; trivial;
    compared_numbers (area (Segment a b) x ?= 0); compared_numbers (area (Segment b a) x ?= 0); trivial; exfalso; lra.
Qed.

(* No position is taken twice. *)
Definition apart_from_all (pieces : list segment) : Prop :=
  forall before e after f w, pieces = before ++ e :: after -> In f (before ++ after) ->
    strictly_inside w e -> ~ strictly_inside w f.

Record share_ends_only (segments : list segment) : Prop := {
  are_distinct : NoDup segments;
  are_long : forall e, In e segments -> nonzero (along e);
  nothing_inside : forall e f w, In e segments -> In f segments -> e <> f -> lies_on w f -> ~ strictly_inside w e;
  have_same_ends : forall e f v w, In e segments -> In f segments ->
    v = source e \/ v = target e -> w = source f \/ w = target f -> equal_vectors v w -> v = w }.

(* A segment, in one of its directions. *)
Definition directed (segments : list segment) (s : segment) : Prop := In s segments \/ In (reversed s) segments.

Lemma directed_reversed (segments : list segment) (s : segment) : directed segments s -> directed segments (reversed s).
Proof. unfold directed. rewrite reversed_twice. tauto. Qed.

(* A set of points, of which only those off the pieces matter, and what is said to be to the right of pieces. *)
Record ends_at_pieces (inside : vector -> bool) (right_inside : segment -> bool) (pieces : list segment) : Prop := {
  pieces_share_ends : share_ends_only pieces;
  same_of_equal : forall a b, equal_vectors a b -> inside a = inside b;
  same_off_pieces : forall a b, (forall w, lies_on w (Segment a b) -> off w pieces) -> inside a = inside b;
  same_beside_pieces : forall s w n, directed pieces s -> strictly_inside w s -> cross (along s) n < 0 ->
    eventually (fun d => inside (moved_along w n d) = right_inside s);
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
      assert (exists up, directed pieces up /\ strictly_inside (point_at_height e y) up /\
        vy (source up) < vy (target up) /\
        (direction_of e * kept_sign e)%Z = (as_number (right_inside (reversed up)) - as_number (right_inside up))%Z)
        as (up & D & inside_up & rising & sign_).
      { unfold directed, direction_of, kept_sign. destruct (at_most_spec (vy (source e)) y);
          [exists e | exists (reversed e)];
          rewrite ?reversed_twice; cbn [reversed source target]; (split; [tauto |]); (split; [| split; [lra | lia]]);
          [exact inside_ | now apply strictly_inside_reversed]. }
      exists up. split; [exact sign_ |]. refine (eventually_implied _ _ _ (eventually_and _ _
        (same_beside_pieces _ _ _ ends_ up _ (Vector 1 0) D inside_up ltac:(in_coordinates; lra))
        (same_beside_pieces _ _ _ ends_ (reversed up) _ (Vector (-1) 0) (directed_reversed _ _ D)
          (strictly_inside_reversed _ _ inside_up) ltac:(in_coordinates; lra)))).
      intros d [<- <-]. split; apply (same_of_equal _ _ _ ends_); unfold moved_along, place_at, point_at_height;
        split; cbn [vx vy]; ring.
    Qed.

    Definition ahead_of_point (a : Q) : list segment := filter (meets_ahead a) pieces.

    Lemma ahead_is (a : Q) (e : segment) : In e (ahead_of_point a) <-> In e pieces /\ spans e y = true /\
      a < place_at e.
    Proof. unfold ahead_of_point. rewrite filter_In. destruct (meets_ahead_spec a e); intuition discriminate. Qed.

    (* The pieces ahead are passed one by one. *)
    Lemma passed_one_by_one (fuel : nat) : forall a, free_at a -> (length (ahead_of_point a) <= fuel)%nat ->
      sum (map (fun e => (direction_of e * kept_sign e)%Z) (ahead_of_point a)) = as_number (inside (Vector a y)).
    Proof.
      induction fuel as [| fuel IH]; intros a free few.
      all: destruct (list_eq_dec segment_dec (ahead_of_point a) []) as [none | some].
      2: { destruct (ahead_of_point a); [contradiction | cbn in few; lia]. }
      1, 2: destruct (nothing_far_away _ _ _ ends_) as (limit & far);
        pose proof (Q.le_max_l (limit + 1) a); rewrite none, (same_if_none_between a (Qmax (limit + 1) a)), far;
        trivial; [cbn [vx]; lra | apply Q.le_max_r |];
        intros e E ahead; destruct (meets_ahead_spec a e) as [met |]; [| discriminate];
        assert (I : In e (ahead_of_point a)) by (now apply ahead_is); rewrite none in I; destruct I.
      destruct (least_of place_at _ some) as (e & listed & least).
      pose proof listed as (E & spanning & before)%ahead_is.
      assert (beyond_e : forall f, In f (ahead_of_point a) -> f <> e -> place_at e < place_at f).
      { intros f I other. specialize (least f I). apply ahead_is in I. destruct I as (F & spanning_f & _).
        destruct (Qlt_le_dec (place_at e) (place_at f)) as [| more]; [assumption | exfalso].
        apply (nothing_inside _ (pieces_share_ends _ _ _ ends_) f e (point_at_height e y)); auto.
        - now apply point_at_height_lies_on.
        - destruct (inside_at_height f y (pieces_avoid f F) spanning_f) as (k & range & X & Y).
          exists k. split; [exact range |]. split; [| exact Y]. rewrite <- X. fold (place_at e). fold (place_at f).
          lra. }
      (* a little further, and a little before *)
      assert (gaps : eventually (fun d => forall f, In f (ahead_of_point a) -> f <> e -> place_at e + d < place_at f)).
      { apply (eventually_for_all (fun f d => f <> e -> place_at e + d < place_at f)). intros f I.
        destruct (segment_dec f e) as [same | other]; [exists 1; split; [lra | contradiction] |].
        pose proof (beyond_e f I other). exists (place_at f - place_at e). split; [lra |]. intros; lra. }
      destruct (beside_the_piece e E spanning) as (up & sign_ & beside_).
      destruct (some_small _ (eventually_and _ _ gaps (eventually_and _ _ beside_
        (eventually_below (place_at e - a) ltac:(lra)))))
        as (d & _ & beyond & (after_number & before_number) & d_some & d_small).
      assert (others : forall f, In f (ahead_of_point a) <-> In f (e :: ahead_of_point (place_at e + d))).
      { intros f. cbn [In]. rewrite (ahead_is (place_at e + d)). split.
        - intros I. destruct (segment_dec f e) as [-> | other]; [now left | right]. specialize (beyond f I other).
          apply ahead_is in I. tauto.
        - intros [<- | (F & spanning_f & ahead_f)]; [exact listed |]. apply ahead_is. split; [exact F |].
          split; [exact spanning_f | lra]. }
      assert (one_less : Permutation (ahead_of_point a) (e :: ahead_of_point (place_at e + d))).
      { pose proof (are_distinct _ (pieces_share_ends _ _ _ ends_)).
        apply NoDup_Permutation; [now apply NoDup_filter | | exact others].
        constructor; [intros (_ & _ & wrong)%ahead_is; lra | now apply NoDup_filter]. }
      rewrite (sum_of_permutation _ _ (Permutation_map _ one_less)). cbn [map]. unfold sum at 1. cbn [fold_right].
      fold (sum (map (fun e => (direction_of e * kept_sign e)%Z) (ahead_of_point (place_at e + d)))).
      rewrite IH, sign_, (same_if_none_between a (place_at e - d)), before_number, after_number;
        [lia | lra | exact free | | |].
      - intros f F ahead_f. destruct (meets_ahead_spec a f); [| discriminate].
        enough (place_at e <= place_at f) by lra. now apply least, ahead_is.
      - intros f F spanning_f where_. assert (I : In f (ahead_of_point a))
          by (apply ahead_is; split; [| split]; trivial; lra).
        apply others in I. destruct I as [<- | (_ & _ & I)%ahead_is]; lra.
      - apply Permutation_length in one_less. cbn [length] in one_less. lia.
    Qed.

    (* At a height at which there are no ends. *)
    Lemma core_at_height (a : Q) : free_at a -> winding_number (Vector a y) kept = as_number (inside (Vector a y)).
    Proof.
      intros free. rewrite <- (passed_one_by_one _ a free (le_n _)), crossings_of_kept. unfold ahead_of_point, sum.
      clear. induction pieces as [| e l IH]; [reflexivity |]. cbn [map fold_right filter].
      rewrite IH, crossing_at_height. now destruct (meets_ahead a e).
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
    apply (core_at_height y avoid).
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
