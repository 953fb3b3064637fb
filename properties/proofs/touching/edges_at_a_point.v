(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Edges that come to a point w or leave it, any number of them: chains may touch there, or cross. In a small square
   around w nothing but these edges is met, and they go out of it. A step in it from w + a to w + b, where b is to the
   left of a, crosses those that lie between a and b as seen from w, and the winding number changes by one at each. *)
From Coq Require Import ZArith Lia Bool List.
From Oplus Require Import numbers convolution signed_crossings regions finite_sums meeting_of_segments neighbourhoods
  winding_number_of_the_sum left_of_an_edge.
Import ListNotations.

Open Scope Q_scope.

Definition same_place (a b : vector) : bool := zero (vx a - vx b) && zero (vy a - vy b).

Lemma same_place_spec (a b : vector) : reflect (equal_vectors a b) (same_place a b).
Proof.
  unfold same_place, equal_vectors. destruct (zero_spec (vx a - vx b)), (zero_spec (vy a - vy b)); constructor; lra.
Qed.

(* The edge s departs from w, or arrives at it; it does both if w is between its ends. *)
Definition comes_by (w : vector) (s : segment) : bool := if lies_on_dec w s then true else false.
Definition departs (w : vector) (s : segment) : bool := comes_by w s && negb (same_place w (target s)).
Definition arrives (w : vector) (s : segment) : bool := comes_by w s && negb (same_place w (source s)).

Lemma departs_is (w : vector) (s : segment) :
  departs w s = true <-> lies_on w s /\ ~ equal_vectors w (target s).
Proof.
  unfold departs, comes_by. destruct (lies_on_dec w s), (same_place_spec w (target s)); cbn [andb negb];
    split; try discriminate; tauto.
Qed.

Lemma arrives_is (w : vector) (s : segment) :
  arrives w s = true <-> lies_on w s /\ ~ equal_vectors w (source s).
Proof.
  unfold arrives, comes_by. destruct (lies_on_dec w s), (same_place_spec w (source s)); cbn [andb negb];
    split; try discriminate; tauto.
Qed.

Lemma departs_from_its_source (w : vector) (s : segment) :
  nonzero (along s) -> equal_vectors w (source s) -> departs w s = true.
Proof.
  intros long at_start. apply departs_is.
  split; [apply (lies_on_equal (source s)); [now symmetry | apply source_lies_on] |].
  intros [X Y]. destruct at_start. apply long. unfold along, minus; cbn [vx vy]. lra.
Qed.

Lemma arrives_at_its_target (w : vector) (s : segment) :
  nonzero (along s) -> equal_vectors w (target s) -> arrives w s = true.
Proof.
  intros long at_end. apply arrives_is.
  split; [apply (lies_on_equal (target s)); [now symmetry | apply target_lies_on] |].
  intros [X Y]. destruct at_end. apply long. unfold along, minus; cbn [vx vy]. lra.
Qed.

Lemma departs_or_arrives (w : vector) (s : segment) :
  nonzero (along s) -> lies_on w s -> departs w s = true \/ arrives w s = true.
Proof.
  intros long on. destruct (same_place_spec w (source s)); [left; now apply departs_from_its_source | right].
  now apply arrives_is.
Qed.

(* Another point of an edge at w is ahead of w, if it departs from w, or behind, if it arrives. *)
Lemma ahead_or_behind (w y : vector) (s : segment) : lies_on w s -> lies_on (plus w y) s ->
  exists m, vx y == m * vx (along s) /\ vy y == m * vy (along s) /\
    (0 < m -> nonzero (along s) -> departs w s = true) /\ (m < 0 -> nonzero (along s) -> arrives w s = true).
Proof.
  intros on (l & [l0 l1] & lx & ly). pose proof on as (k & [k0 k1] & kx & ky). unfold plus in lx, ly.
  cbn [vx vy] in lx, ly. exists (l - k). unfold along, minus; cbn [vx vy]. split; [lra |]. split; [lra |].
  split; intros sign long; [apply departs_is | apply arrives_is]; (split; [exact on |]); intros [X Y]; apply long;
    cbn [vx vy].
  - split; apply (Qmult_inj_r _ _ (1 - k)); lra.
  - split; apply (Qmult_inj_r _ _ k); lra.
Qed.

(* In the square around w only edges that pass w are met. *)
Definition with_ends (s : segment) : list segment :=
  [s; Segment (source s) (source s); Segment (target s) (target s)].

Definition nothing_else_near (w : vector) (radius : Q) (r : region) : Prop :=
  0 < radius /\ forall t, In t (flat_map with_ends (region_edges r)) ->
    lies_on w t \/ forall y, within radius w y -> ~ lies_on y t.

Lemma some_square (w : vector) (r : region) : exists radius, nothing_else_near w radius r.
Proof.
  set (segments := flat_map with_ends (region_edges r)).
  destruct (off_near w (filter (fun t => negb (comes_by w t)) segments)) as (radius & R & near).
  - intros t I on. apply filter_In in I. destruct I as [_ I]. unfold comes_by in I. now destruct (lies_on_dec w t).
  - exists radius. split; [exact R |]. intros t I. destruct (lies_on_dec w t) as [on | free] eqn:decided; [now left |].
    right. intros y close. apply (near y close), filter_In. split; [exact I |]. unfold comes_by. now rewrite decided.
Qed.

(* v is between a and b, which is to the left of a. *)
Definition is_amid (a b v : vector) : bool := positive (cross a v) && positive (cross v b).

Lemma is_amid_spec (a b v : vector) : reflect (0 < cross a v /\ 0 < cross v b) (is_amid a b v).
Proof.
  unfold is_amid. destruct (positive_spec (cross a v)), (positive_spec (cross v b)); constructor; tauto.
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
  Variable r : region.
  Variables w a b : vector.
  Variable radius : Q.
  Hypothesis not_points : no_edges_are_points r.
  Hypothesis near : nothing_else_near w radius r.
  Hypothesis turn : 0 < cross a b.
  Hypothesis near_a : within radius w (plus w a).
  Hypothesis near_b : within radius w (plus w b).
  Hypothesis off_a : off (plus w a) (region_edges r).
  Hypothesis off_b : off (plus w b) (region_edges r).

  (* An edge between a and b goes on beyond the step. *)
  Lemma goes_beyond_the_step (s : segment) (v end_ : vector) (k : Q) : In s (region_edges r) ->
    end_ = source s \/ end_ = target s -> ~ equal_vectors w end_ -> equal_vectors end_ (moved_along w v k) ->
    0 < cross a v -> 0 < cross v b -> 0 <= k -> cross a b - k * (cross a v + cross v b) < 0.
  Proof.
    intros I is_end differ [ex ey] after_a before_b some. apply Qnot_le_lt. intros below.
    set (d := cross a v + cross v b) in *. assert (0 < d) by (unfold d; lra).
    set (h := cross a v / d). set (l := cross a b / d).
    assert (h_is : h * d == cross a v) by (unfold h; field; lra).
    assert (l_is : l * d == cross a b) by (unfold l; field; lra).
    assert (h_range : 0 <= h <= 1)
      by (unfold h; split; [apply Qle_shift_div_l | apply Qle_shift_div_r]; unfold d; lra).
    assert (some_l : 0 < l) by (unfold l; apply Qlt_shift_div_l; lra).
    assert (l_range : k <= l) by (unfold l; apply Qle_shift_div_l; lra).
    assert (there : within radius w (moved_along w v l)).
    { apply (within_along radius w (plus w a) (plus w b)); trivial. exists h. split; [exact h_range |].
      unfold moved_along, plus; cbn [source target vx vy].
      split; apply (Qmult_inj_r _ _ d); try lra.
      - setoid_replace ((vx w + l * vx v) * d) with (vx w * d + l * d * vx v) by ring.
        setoid_replace (((1 - h) * (vx w + vx a) + h * (vx w + vx b)) * d) with
          (vx w * d + (d - h * d) * vx a + h * d * vx b) by ring. rewrite h_is, l_is. unfold d, cross. ring.
      - setoid_replace ((vy w + l * vy v) * d) with (vy w * d + l * d * vy v) by ring.
        setoid_replace (((1 - h) * (vy w + vy a) + h * (vy w + vy b)) * d) with
          (vy w * d + (d - h * d) * vy a + h * d * vy b) by ring. rewrite h_is, l_is. unfold d, cross. ring. }
    assert (close : within radius w end_).
    { apply (within_along radius w w (moved_along w v l)); trivial; [destruct near_a; split; lra |].
      exists (k / l). assert (value : k / l * l == k) by (field; lra).
      split; [split; [apply Qle_shift_div_l | apply Qle_shift_div_r]; lra |].
      set (part := k / l) in *. clearbody part.
      unfold moved_along in *; cbn [source target vx vy] in *. rewrite ex, ey, <- value. split; ring. }
    destruct near as [_ near_]. destruct (near_ (Segment end_ end_)) as [(t & _ & X & Y) | free].
    - apply in_flat_map. exists s. split; [exact I |]. destruct is_end as [-> | ->]; cbn; tauto.
    - cbn [source target] in X, Y. apply differ. split; lra.
    - apply (free end_ close), (source_lies_on (Segment end_ end_)).
  Qed.

  Lemma crossing_at_the_point (s : segment) : In s (region_edges r) ->
    signed_crossing_of_step (plus w a) (plus w b) s =
    (Z.b2z (departs w s && is_amid a b (along s)) -
     Z.b2z (arrives w s && is_amid a b (opposite (along s))))%Z.
  Proof.
    intros I. pose proof (region_edges_are_directions r not_points s I) as long.
    destruct (signed_crossing_by_areas (plus w a) (plus w b) s) as [once once_back].
    assert (back : forall u v : vector, cross u (opposite v) == - cross u v /\ cross (opposite v) u == - cross v u)
      by (intros; unfold cross, opposite; cbn [vx vy]; split; ring).
    destruct (back a (along s)) as [back_a _], (back b (along s)) as [_ back_b]. clear back.
    assert (areas : lies_on w s -> exists k, 0 <= k <= 1 /\
      equal_vectors (source s) (moved_along w (opposite (along s)) k) /\
      equal_vectors (target s) (moved_along w (along s) (1 - k)) /\
      area s (plus w a) == - cross a (along s) /\ area s (plus w b) == cross (along s) b /\
      area (Segment (plus w a) (plus w b)) (source s) == cross a b + k * (cross a (along s) + cross (along s) b) /\
      area (Segment (plus w a) (plus w b)) (target s) ==
        cross a b - (1 - k) * (cross a (along s) + cross (along s) b)).
    { intros (k & range & X & Y). exists k. split; [exact range |].
      unfold equal_vectors, moved_along, area, plus, cross, opposite, along, minus; cbn [source target vx vy].
      repeat split; rewrite ?X, ?Y; ring. }
    destruct (departs w s && is_amid a b (along s)) eqn:ahead,
      (arrives w s && is_amid a b (opposite (along s))) eqn:behind; cbn [Z.b2z].
    - exfalso. apply andb_true_iff in ahead, behind. destruct ahead as [_ ahead], behind as [_ behind].
      destruct (is_amid_spec a b (along s)), (is_amid_spec a b (opposite (along s))); try discriminate. lra.
    - apply andb_true_iff in ahead. destruct ahead as [leaving ahead]. apply departs_is in leaving.
      destruct leaving as [on goes_on]. destruct (is_amid_spec a b (along s)) as [[after_a before_b] |];
        [| discriminate].
      destruct (areas on) as (k & [k0 k1] & _ & target_is & area_a & area_b & of_source & of_target).
      apply once; try lra.
      + assert (0 <= k * (cross a (along s) + cross (along s) b)) by (apply Qmult_le_0_compat; lra). lra.
      + rewrite of_target. apply (goes_beyond_the_step s _ (target s)); trivial; [tauto | lra].
    - apply andb_true_iff in behind. destruct behind as [entering behind]. apply arrives_is in entering.
      destruct entering as [on comes]. destruct (is_amid_spec a b (opposite (along s))) as [[after_a before_b] |];
        [| discriminate].
      destruct (areas on) as (k & [k0 k1] & source_is & _ & area_a & area_b & of_source & of_target).
      apply once_back; try lra.
      + pose proof (goes_beyond_the_step s _ (source s) k I (or_introl eq_refl) comes source_is after_a before_b k0)
          as beyond. rewrite back_a, back_b in beyond. lra.
      + assert (0 <= (1 - k) * - (cross a (along s) + cross (along s) b)) by (apply Qmult_le_0_compat; lra). lra.
    - destruct (Z.eq_dec (signed_crossing_of_step (plus w a) (plus w b) s) 0) as [| crosses]; [assumption | exfalso].
      destruct (crossing_steps_meet _ _ _ crosses) as (c & on_step & on_s).
      destruct near as [_ near_]. destruct (near_ s) as [on | free].
      { apply in_flat_map. exists s. split; [exact I | now left]. }
      2: { apply (free c); [| exact on_s]. now apply (within_along radius w (plus w a) (plus w b)). }
      pose proof on_step as (h & [h0 h1] & cx & cy). cbn [source target] in cx, cy.
      set (y := Vector ((1 - h) * vx a + h * vx b) ((1 - h) * vy a + h * vy b)).
      assert (c_is : equal_vectors c (plus w y)).
      { unfold y, plus in *; cbn [vx vy] in *. split; cbn [vx vy]; lra. }
      destruct (ahead_or_behind w y s on (lies_on_equal _ _ _ c_is on_s)) as (m & mx & my & leaving & entering).
      assert (from_a : h * cross a b == m * cross a (along s)).
      { setoid_replace (m * cross a (along s)) with (vx a * (m * vy (along s)) - vy a * (m * vx (along s)))
          by (unfold cross; ring). rewrite <- mx, <- my. unfold cross, y; cbn [vx vy]. ring. }
      assert (to_b : (1 - h) * cross a b == m * cross (along s) b).
      { setoid_replace (m * cross (along s) b) with (m * vx (along s) * vy b - m * vy (along s) * vx b)
          by (unfold cross; ring). rewrite <- mx, <- my. unfold cross, y; cbn [vx vy]. ring. }
      assert (inner : 0 < h < 1).
      { split; apply Qnot_le_lt; intros extreme; [apply (off_a s I) | apply (off_b s I)];
          apply (lies_on_equal c); trivial.
        - assert (h_is : h == 0) by lra. rewrite h_is in cx, cy. split; lra.
        - assert (h_is : h == 1) by lra. rewrite h_is in cx, cy. split; lra. }
      assert (after_a : 0 < h * cross a b) by (apply Qmult_lt_0_compat; lra).
      assert (before_b : 0 < (1 - h) * cross a b) by (apply Qmult_lt_0_compat; lra).
      rewrite from_a in after_a. rewrite to_b in before_b.
      assert (sign : forall u : Q, 0 < m * u -> (0 < m /\ 0 < u) \/ (m < 0 /\ u < 0)).
      { intros u some. destruct (Q_dec m 0) as [[low | high] | none]; [right | left | rewrite none in some; lra].
        - split; [exact low |]. apply Qnot_le_lt. intros up.
          assert (0 <= - m * u) by (apply Qmult_le_0_compat; lra). lra.
        - split; [exact high |]. apply Qnot_le_lt. intros down.
          assert (0 <= m * - u) by (apply Qmult_le_0_compat; lra). lra. }
      destruct (sign _ after_a) as [[front u] | [rear u]], (sign _ before_b) as [[front' u'] | [rear' u']];
        try (exfalso; lra).
      + rewrite (leaving front long) in ahead.
        destruct (is_amid_spec a b (along s)) as [| []]; [discriminate | tauto].
      + rewrite (entering rear long) in behind.
        destruct (is_amid_spec a b (opposite (along s))) as [| []]; [discriminate | lra].
  Qed.

  (* Theorem. How the winding number changes around w. *)
  Theorem winding_number_around_the_point :
    (winding_number (plus w b) (region_edges r) - winding_number (plus w a) (region_edges r))%Z =
    sum_of (fun s => Z.b2z (departs w s) * Z.b2z (is_amid a b (along s)) -
                     Z.b2z (arrives w s) * Z.b2z (is_amid a b (opposite (along s))))%Z (region_edges r).
  Proof.
    rewrite <- step_changes_winding_number; trivial; [| apply region_cycles |].
    - apply sum_equally. intros s I. rewrite (crossing_at_the_point s I).
      destruct (departs w s), (arrives w s), (is_amid a b (along s)), (is_amid a b (opposite (along s)));
        reflexivity.
    - intros [X Y]. unfold minus, plus in X, Y; cbn [vx vy] in X, Y. assert (cross a b == 0); [| lra].
      unfold cross. assert (vx_is : vx b == vx a) by lra. assert (vy_is : vy b == vy a) by lra.
      rewrite vx_is, vy_is. ring.
  Qed.
End OneStep.
