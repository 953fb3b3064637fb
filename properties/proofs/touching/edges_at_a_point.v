(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Edges that come to a point w or leave it, any number of them: chains may touch there, or cross. In a small square
   around w nothing but these edges is met. A step from w + a to w + b, where b is to the left of a, crosses those
   that lie between a and b as seen from w, and the winding number changes by one at each of them. *)
From Coq Require Import QArith Qminmax Lqa Qfield ZArith Lia Bool List.
From Oplus Require Import convolution signed_crossings regions finite_sums meeting_of_segments neighbourhoods
  winding_number_of_the_sum left_of_an_edge.
Import ListNotations.

Open Scope Q_scope.

Definition same_place (a b : vector) : bool := zero (vx a - vx b) && zero (vy a - vy b).

Lemma same_place_spec (a b : vector) : reflect (equal_vectors a b) (same_place a b).
Proof.
  unfold same_place, equal_vectors. destruct (zero_spec (vx a - vx b)), (zero_spec (vy a - vy b)); constructor; lra.
Qed.

(* The edge s leaves w, or enters it; it does both if w is between its ends. *)
Definition passes (w : vector) (s : segment) : bool := if lies_on_dec w s then true else false.
Definition leaves (w : vector) (s : segment) : bool := passes w s && negb (same_place w (target s)).
Definition enters (w : vector) (s : segment) : bool := passes w s && negb (same_place w (source s)).

Lemma leaves_is (w : vector) (s : segment) :
  leaves w s = true <-> lies_on w s /\ ~ equal_vectors w (target s).
Proof.
  unfold leaves, passes. destruct (lies_on_dec w s), (same_place_spec w (target s)); cbn [andb negb];
    split; try discriminate; try tauto.
Qed.

Lemma enters_is (w : vector) (s : segment) :
  enters w s = true <-> lies_on w s /\ ~ equal_vectors w (source s).
Proof.
  unfold enters, passes. destruct (lies_on_dec w s), (same_place_spec w (source s)); cbn [andb negb];
    split; try discriminate; try tauto.
Qed.

(* Only edges that pass w meet the square around it, and they go out of it. *)
Definition nothing_else_near (w : vector) (radius : Q) (segments : list segment) : Prop :=
  0 < radius /\ forall s, In s segments ->
    (lies_on w s \/ forall y, within radius w y -> ~ lies_on y s) /\
    (within radius w (source s) -> equal_vectors w (source s)) /\
    (within radius w (target s) -> equal_vectors w (target s)).

Lemma some_square (w : vector) (segments : list segment) : exists radius, nothing_else_near w radius segments.
Proof.
  assert (away : forall s, exists radius, 0 < radius /\
    forall r, r <= radius -> lies_on w s \/ forall y, within r w y -> ~ lies_on y s).
  { intros s. destruct (lies_on_dec w s) as [on | free]; [exists 1; split; [lra |]; now left |].
    destruct (off_one_segment_near w s free) as (radius & R & near). exists radius. split; [exact R |].
    intros r small. right. intros y close. apply near. now apply (within_smaller r). }
  assert (one : forall s, exists radius, 0 < radius /\ forall r, r <= radius ->
    (lies_on w s \/ forall y, within r w y -> ~ lies_on y s) /\
    (within r w (source s) -> equal_vectors w (source s)) /\ (within r w (target s) -> equal_vectors w (target s))).
  { intros s.
    assert (end_ : forall v, exists radius, 0 < radius /\ forall r, r <= radius -> within r w v -> equal_vectors w v).
    { intros v. destruct (away (Segment v v)) as (radius & R & near). exists radius. split; [exact R |].
      intros r small close. destruct (near r small) as [(t & _ & X & Y) | free].
      - cbn [source target] in X, Y. split; lra.
      - exfalso. apply (free v close), (source_lies_on (Segment v v)). }
    destruct (away s) as (r1 & R1 & near_1), (end_ (source s)) as (r2 & R2 & near_2),
      (end_ (target s)) as (r3 & R3 & near_3).
    exists (Qmin r1 (Qmin r2 r3)). split; [repeat apply Q.min_glb_lt; assumption |]. intros r small.
    pose proof (Q.le_min_l r1 (Qmin r2 r3)). pose proof (Q.le_min_r r1 (Qmin r2 r3)).
    pose proof (Q.le_min_l r2 r3). pose proof (Q.le_min_r r2 r3).
    split; [apply near_1 | split; [apply near_2 | apply near_3]]; lra. }
  unfold nothing_else_near. induction segments as [| s rest (r1 & R1 & near_1)].
  - exists 1. split; [lra |]. intros s [].
  - destruct (one s) as (r2 & R2 & near_2). exists (Qmin r1 r2). split; [now apply Q.min_glb_lt |].
    pose proof (Q.le_min_l r1 r2) as B1. pose proof (Q.le_min_r r1 r2) as B2.
    intros t [<- | I]; [now apply near_2 |]. destruct (near_1 t I) as (free & of_source & of_target).
    split; [destruct free as [on | free]; [now left | right; intros y close; apply free; now apply (within_smaller _ r1 _ y B1)] |].
    split; intros close; [apply of_source | apply of_target]; now apply (within_smaller _ r1 _ _ B1).
Qed.

(* v is between a and b, which is to the left of a. *)
Definition is_between (a b v : vector) : bool := positive (cross a v) && positive (cross v b).

Lemma is_between_spec (a b v : vector) : reflect (0 < cross a v /\ 0 < cross v b) (is_between a b v).
Proof.
  unfold is_between. destruct (positive_spec (cross a v)), (positive_spec (cross v b)); constructor; tauto.
Qed.

Lemma signed_crossing_by_areas (from to : vector) (s : segment) :
  (area s from < 0 -> 0 < area s to -> 0 < area (Segment from to) (source s) ->
   area (Segment from to) (target s) < 0 -> signed_crossing_of_step from to s = 1%Z) /\
  (0 < area s from -> area s to < 0 -> area (Segment from to) (source s) < 0 ->
   0 < area (Segment from to) (target s) -> signed_crossing_of_step from to s = (-1)%Z).
Proof.
  unfold signed_crossing_of_step, side_of_segment, side_of_step. destruct s as [p q]. cbn [source target].
  rewrite !orientation_by_area.
  assert (low : forall u, u < 0 -> (u ?= 0) = Lt) by (intros; now apply (proj1 (Qlt_alt _ _))).
  assert (high : forall u, 0 < u -> (u ?= 0) = Gt) by (intros; now apply (proj1 (Qgt_alt _ _))).
  split; intros A B C D.
  - now rewrite (low _ A), (high _ B), (high _ C), (low _ D).
  - now rewrite (high _ A), (low _ B), (low _ C), (high _ D).
Qed.

Section OneStep.
  Variable w a b : vector.
  Variable radius : Q.
  Hypothesis turn : 0 < cross a b.
  Hypothesis near_a : within radius w (plus w a).
  Hypothesis near_b : within radius w (plus w b).

  (* What is between a and b is met by the step before it leaves the square. *)
  Lemma step_is_near (v : vector) (k : Q) : 0 < cross a v -> 0 < cross v b -> 0 <= k ->
    k * (cross a v + cross v b) <= cross a b -> within radius w (moved_along w v k).
  Proof.
    intros after_a before_b some below. set (d := cross a v + cross v b) in *.
    assert (0 < d) by (unfold d; lra). set (h := cross a v / d). set (l := cross a b / d).
    assert (h_is : h * d == cross a v) by (unfold h; field; lra).
    assert (l_is : l * d == cross a b) by (unfold l; field; lra).
    assert (h_range : 0 <= h <= 1)
      by (unfold h; split; [apply Qle_shift_div_l | apply Qle_shift_div_r]; unfold d; lra).
    assert (l_range : k <= l) by (unfold l; apply Qle_shift_div_l; lra).
    assert (some_l : 0 < l) by (unfold l; apply Qlt_shift_div_l; lra).
    assert (there : within radius w (moved_along w v l)).
    { apply (within_along radius w (plus w a) (plus w b)); trivial. exists h. split; [exact h_range |].
      unfold moved_along, plus; cbn [source target vx vy].
      assert (x_is : (l * vx v - ((1 - h) * vx a + h * vx b)) * d == 0).
      { setoid_replace ((l * vx v - ((1 - h) * vx a + h * vx b)) * d) with
          (l * d * vx v - (d - h * d) * vx a - h * d * vx b) by ring.
        rewrite h_is, l_is. unfold d, cross. ring. }
      assert (y_is : (l * vy v - ((1 - h) * vy a + h * vy b)) * d == 0).
      { setoid_replace ((l * vy v - ((1 - h) * vy a + h * vy b)) * d) with
          (l * d * vy v - (d - h * d) * vy a - h * d * vy b) by ring.
        rewrite h_is, l_is. unfold d, cross. ring. }
      destruct (Qmult_integral _ _ x_is), (Qmult_integral _ _ y_is); try (exfalso; lra). split; lra. }
    apply (within_along radius w w (moved_along w v l)); trivial.
    - destruct near_a as [X Y]. split; lra.
    - exists (k / l). assert (value : k / l * l == k) by (field; lra).
      split; [split; [apply Qle_shift_div_l | apply Qle_shift_div_r]; lra |].
      set (part := k / l) in *. clearbody part.
      unfold moved_along; cbn [source target vx vy]. rewrite <- value. split; ring.
  Qed.

  (* Where the step crosses an edge at w, it crosses it ahead of w or behind. *)
  Lemma crosses_ahead_or_behind (s : segment) : nonzero (along s) -> lies_on w s ->
    ~ lies_on (plus w a) s -> ~ lies_on (plus w b) s -> signed_crossing_of_step (plus w a) (plus w b) s <> 0%Z ->
    (leaves w s = true /\ is_between a b (along s) = true) \/
    (enters w s = true /\ is_between a b (opposite (along s)) = true).
  Proof.
    intros long on off_a off_b crosses. pose proof on as (k & [k0 k1] & wx & wy).
    destruct (crossing_steps_meet _ _ _ crosses) as (c & (h & [h0 h1] & cx & cy) & on_s).
    pose proof on_s as (m & [m0 m1] & mx & my). unfold plus in cx, cy; cbn [source target vx vy] in cx, cy.
    set (v := along s).
    assert (px : (1 - h) * vx a + h * vx b == (m - k) * vx v) by (unfold v, along, minus; cbn [vx]; lra).
    assert (py : (1 - h) * vy a + h * vy b == (m - k) * vy v) by (unfold v, along, minus; cbn [vy]; lra).
    assert (from_a : h * cross a b == (m - k) * cross a v).
    { setoid_replace ((m - k) * cross a v) with (vx a * ((m - k) * vy v) - vy a * ((m - k) * vx v))
        by (unfold cross; ring). rewrite <- px, <- py. unfold cross. ring. }
    assert (to_b : (1 - h) * cross a b == (m - k) * cross v b).
    { setoid_replace ((m - k) * cross v b) with ((m - k) * vx v * vy b - (m - k) * vy v * vx b)
        by (unfold cross; ring). rewrite <- px, <- py. unfold cross. ring. }
    assert (inner : 0 < h < 1).
    { split; apply Qnot_le_lt; intros extreme.
      - apply off_a, (lies_on_equal c); [| exact on_s]. assert (h_is : h == 0) by lra. rewrite h_is in cx, cy.
        unfold plus; split; cbn [vx vy]; lra.
      - apply off_b, (lies_on_equal c); [| exact on_s]. assert (h_is : h == 1) by lra. rewrite h_is in cx, cy.
        unfold plus; split; cbn [vx vy]; lra. }
    assert (after_a : 0 < h * cross a b) by (apply Qmult_lt_0_compat; lra).
    assert (before_b : 0 < (1 - h) * cross a b) by (apply Qmult_lt_0_compat; lra).
    rewrite from_a in after_a. rewrite to_b in before_b.
    assert (sign : forall l u : Q, 0 < l * u -> (0 < l /\ 0 < u) \/ (l < 0 /\ u < 0)).
    { intros l u some. destruct (Q_dec l 0) as [[low | high] | none].
      - right. split; [exact low |]. apply Qnot_le_lt. intros up.
        assert (0 <= - l * u) by (apply Qmult_le_0_compat; lra). lra.
      - left. split; [exact high |]. apply Qnot_le_lt. intros down.
        assert (0 <= l * - u) by (apply Qmult_le_0_compat; lra). lra.
      - rewrite none in some. lra. }
    destruct (sign _ _ after_a) as [[ahead u] | [behind u]], (sign _ _ before_b) as [[ahead' u'] | [behind' u']];
      try (exfalso; lra); [left | right].
    - split; [apply leaves_is; split; [exact on |] | now destruct (is_between_spec a b v) as [| []]].
      intros [X Y]. apply long. fold v. unfold v, along, minus. cbn [vx vy].
      split; apply (Qmult_inj_r _ _ (1 - k)); lra.
    - split; [apply enters_is; split; [exact on |] |].
      + intros [X Y]. apply long. unfold along, minus. cbn [vx vy]. split; apply (Qmult_inj_r _ _ k); lra.
      + destruct (is_between_spec a b (opposite v)) as [| []]; [reflexivity |].
        unfold cross, opposite in *; cbn [vx vy] in *. lra.
  Qed.

  (* A step that crosses the edge v or, if it enters w, that edge backwards. *)
  Lemma ends_on_both_sides (v : vector) (k : Q) : 0 < cross a v -> 0 < cross v b -> 0 <= k ->
    (within radius w (moved_along w v k) -> k == 0) -> ~ k == 0 ->
    cross a b - k * (cross a v + cross v b) < 0.
  Proof.
    intros after_a before_b some away differ. apply Qnot_le_lt. intros near.
    apply differ, away, step_is_near; trivial. lra.
  Qed.

  Lemma crossing_at_the_point (s : segment) : nonzero (along s) -> lies_on w s ->
    (within radius w (source s) -> equal_vectors w (source s)) ->
    (within radius w (target s) -> equal_vectors w (target s)) ->
    ~ lies_on (plus w a) s -> ~ lies_on (plus w b) s ->
    signed_crossing_of_step (plus w a) (plus w b) s =
    (Z.b2z (leaves w s && is_between a b (along s)) -
     Z.b2z (enters w s && is_between a b (opposite (along s))))%Z.
  Proof.
    intros long on source_away target_away off_a off_b.
    pose proof (crosses_ahead_or_behind s long on off_a off_b) as ahead_or_behind.
    pose proof on as (k & [k0 k1] & wx & wy). set (v := along s) in *.
    assert (source_x : vx (source s) == vx w - k * vx v) by (unfold v, along, minus; cbn [vx]; lra).
    assert (source_y : vy (source s) == vy w - k * vy v) by (unfold v, along, minus; cbn [vy]; lra).
    assert (target_x : vx (target s) == vx w + (1 - k) * vx v) by (unfold v, along, minus; cbn [vx]; lra).
    assert (target_y : vy (target s) == vy w + (1 - k) * vy v) by (unfold v, along, minus; cbn [vy]; lra).
    assert (area_a : area s (plus w a) == - cross a v).
    { unfold area. fold (along s). fold v. unfold minus, plus. unfold cross. cbn [vx vy].
      rewrite source_x, source_y. ring. }
    assert (area_b : area s (plus w b) == cross v b).
    { unfold area. fold (along s). fold v. unfold minus, plus. unfold cross. cbn [vx vy].
      rewrite source_x, source_y. ring. }
    assert (area_source : area (Segment (plus w a) (plus w b)) (source s) ==
      cross a b + k * (cross a v + cross v b)).
    { unfold area, minus, plus, cross. cbn [source target vx vy]. rewrite source_x, source_y. ring. }
    assert (area_target : area (Segment (plus w a) (plus w b)) (target s) ==
      cross a b - (1 - k) * (cross a v + cross v b)).
    { unfold area, minus, plus, cross. cbn [source target vx vy]. rewrite target_x, target_y. ring. }
    assert (back : cross a (opposite v) == - cross a v /\ cross (opposite v) b == - cross v b)
      by (unfold cross, opposite; cbn [vx vy]; split; ring).
    destruct back as [back_a back_b]. destruct (signed_crossing_by_areas (plus w a) (plus w b) s) as [once once_back].
    assert (unless_zero : forall l, l * vx v == 0 -> l * vy v == 0 -> l == 0).
    { intros l X Y. destruct (Qeq_dec l 0) as [| some]; [assumption | exfalso]. apply long.
      destruct (Qmult_integral _ _ X), (Qmult_integral _ _ Y); tauto. }
    destruct (leaves w s && is_between a b v) eqn:ahead, (enters w s && is_between a b (opposite v)) eqn:behind;
      cbn [Z.b2z].
    - exfalso. apply andb_true_iff in ahead, behind. destruct ahead as [_ ahead], behind as [_ behind].
      destruct (is_between_spec a b v), (is_between_spec a b (opposite v)); try discriminate. lra.
    - apply andb_true_iff in ahead. destruct ahead as [leaving ahead]. apply leaves_is in leaving.
      destruct leaving as [_ goes_on]. destruct (is_between_spec a b v) as [[after_a before_b] |]; [| discriminate].
      apply once; [lra | lra | |].
      + rewrite area_source. assert (0 <= k * (cross a v + cross v b)) by (apply Qmult_le_0_compat; lra). lra.
      + rewrite area_target. apply ends_on_both_sides; trivial; [lra | |].
        * intros close. destruct target_away as [X Y];
            [unfold within in *; rewrite target_x, target_y; exact close | apply unless_zero; lra].
        * intros zero_. apply goes_on. rewrite zero_ in target_x, target_y. split; lra.
    - apply andb_true_iff in behind. destruct behind as [entering behind]. apply enters_is in entering.
      destruct entering as [_ comes]. destruct (is_between_spec a b (opposite v)) as [[after_a before_b] |];
        [| discriminate].
      apply once_back; [lra | lra | |].
      + rewrite area_source.
        assert (before : cross a b - k * (cross a (opposite v) + cross (opposite v) b) < 0);
          [| rewrite back_a, back_b in before; lra].
        apply ends_on_both_sides; trivial.
        * intros close. destruct source_away as [X Y];
            [| apply unless_zero; lra].
          unfold within, moved_along, opposite in *; cbn [vx vy] in *. rewrite source_x, source_y.
          setoid_replace (vx w - k * vx v) with (vx w + k * - vx v) by ring.
          setoid_replace (vy w - k * vy v) with (vy w + k * - vy v) by ring. exact close.
        * intros zero_. apply comes. rewrite zero_ in source_x, source_y. split; lra.
      + rewrite area_target.
        assert (0 <= (1 - k) * - (cross a v + cross v b)) by (apply Qmult_le_0_compat; lra). lra.
    - destruct (Z.eq_dec (signed_crossing_of_step (plus w a) (plus w b) s) 0) as [| crosses]; [assumption | exfalso].
      destruct (ahead_or_behind crosses) as [[one two] | [one two]]; rewrite one, two in *; discriminate.
  Qed.

  (* Theorem. How the winding number changes around w. *)
  Theorem winding_number_around_the_point (r : region) :
    no_edges_are_points r -> nothing_else_near w radius (region_edges r) ->
    off (plus w a) (region_edges r) -> off (plus w b) (region_edges r) ->
    (winding_number (plus w b) (region_edges r) - winding_number (plus w a) (region_edges r))%Z =
    sum_of (fun s => Z.b2z (leaves w s) * Z.b2z (is_between a b (along s)) -
                     Z.b2z (enters w s) * Z.b2z (is_between a b (opposite (along s))))%Z (region_edges r).
  Proof.
    intros not_points [R near] off_a off_b.
    rewrite <- step_changes_winding_number; trivial.
    2: apply region_cycles.
    2: { intros [X Y]. unfold minus, plus in X, Y; cbn [vx vy] in X, Y.
         assert (cross a b == 0); [| lra]. unfold cross.
         assert (vx_is : vx b == vx a) by lra. assert (vy_is : vy b == vy a) by lra. rewrite vx_is, vy_is. ring. }
    apply sum_equally. intros s I. destruct (near s I) as ([on | free] & source_away & target_away).
    - rewrite crossing_at_the_point; try apply (region_edges_are_directions r not_points s I); auto.
      destruct (leaves w s), (enters w s), (is_between a b (along s)), (is_between a b (opposite (along s)));
        reflexivity.
    - assert (not_on : ~ lies_on w s) by (apply free; destruct near_a; split; lra).
      unfold leaves, enters, passes. destruct (lies_on_dec w s); [contradiction |]. cbn [andb Z.b2z].
      destruct (Z.eq_dec (signed_crossing_of_step (plus w a) (plus w b) s) 0) as [-> | crosses]; [reflexivity | exfalso].
      destruct (crossing_steps_meet _ _ _ crosses) as (c & on_step & on_s).
      apply (free c); [| exact on_s]. now apply (within_along radius w (plus w a) (plus w b)).
  Qed.
End OneStep.
