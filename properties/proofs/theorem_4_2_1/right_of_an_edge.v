(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* All along an edge that meets others at its ends only, the winding number close to its right is the same: that
   right of its middle, as the code counts it on symbolic shifts (shifted_ray.v). And the winding number of every point off the
   chains is that to the right of some edge, one more, or zero: go to the right until the first edge (first_hit.v). So
   winding numbers are nowhere negative if they are not beside the middles of edges. *)
From Coq Require Import QArith Qabs Qminmax Lqa Qfield ZArith Lia Bool List.
From Oplus Require Import convolution shifted_ray signed_crossings tie_rule regions weight
  winding_number_of_the_sum meeting_of_segments first_hit interiors_meet neighbourhoods left_of_an_edge
  theorem_4_2_1 observation_2_2_4.
Import ListNotations.

Open Scope Q_scope.

(* Where a segment is as seen along another from w1 to w2: ahead, and to the side. *)
Definition ahead_of (w1 w2 p : vector) : Q := dot (minus w2 w1) (minus p w1).

Definition shifted_right (w1 w2 : vector) (e : Q) (p : vector) : vector :=
  moved_along p (Vector (vy (minus w2 w1)) (- vx (minus w2 w1))) e.

Lemma on_segment_by_coordinates (w1 w2 p : vector) :
  let len := dot (minus w2 w1) (minus w2 w1) in
  0 < len -> area (Segment w1 w2) p == 0 -> 0 <= ahead_of w1 w2 p <= len -> lies_on p (Segment w1 w2).
Proof.
  intros len some line range.
  assert (value : ahead_of w1 w2 p / len * len == ahead_of w1 w2 p) by (field; lra).
  exists (ahead_of w1 w2 p / len). split; [split; [apply Qle_shift_div_l; lra | apply Qle_shift_div_r; lra] |].
  set (t := ahead_of w1 w2 p / len) in *. clearbody t.
  unfold area, ahead_of, cross, dot, minus in *; cbn [source target vx vy] in *.
  set (u := vx w2 - vx w1) in *. set (v := vy w2 - vy w1) in *.
  assert (u_is : vx w2 == vx w1 + u) by (unfold u; ring). assert (v_is : vy w2 == vy w1 + v) by (unfold v; ring).
  set (a := vx p - vx w1) in *. set (b := vy p - vy w1) in *.
  assert (a_is : vx p == vx w1 + a) by (unfold a; ring). assert (b_is : vy p == vy w1 + b) by (unfold b; ring).
  rewrite u_is, v_is, a_is, b_is. clearbody u v a b.
  assert (a == t * u).
  { apply (Qmult_inj_r _ _ len); [lra |]. setoid_replace (t * u * len) with (t * len * u) by ring. rewrite value.
    unfold len. setoid_replace (a * (u * u + v * v)) with ((u * a + v * b) * u - (u * b - v * a) * v) by ring.
    rewrite line. ring. }
  assert (b == t * v).
  { apply (Qmult_inj_r _ _ len); [lra |]. setoid_replace (t * v * len) with (t * len * v) by ring. rewrite value.
    unfold len. setoid_replace (b * (u * u + v * v)) with ((u * a + v * b) * v + (u * b - v * a) * u) by ring.
    rewrite line. ring. }
  split; lra.
Qed.

(* A linear change that is small does not reach zero. *)
Lemma eventually_positive (a b : Q) : 0 < a -> eventually (fun e => 0 < a + e * b).
Proof.
  intros some. destruct (radius_for a (Qabs b) some) as (limit & L & small); [apply abs_bounds |].
  exists limit. split; [exact L |]. intros e e0 e1. pose proof (abs_bounds b) as [not_negative range].
  assert (e * Qabs b <= limit * Qabs b) by (apply Qmult_le_compat_r; lra).
  assert (0 <= e * (b + Qabs b)) by (apply Qmult_le_0_compat; lra). lra.
Qed.

(* A segment that does not meet another does not meet it either when that is shifted a little. *)
Lemma shifted_segments_do_not_meet (w1 w2 : vector) (t : segment) :
  nonzero (minus w2 w1) -> (forall p, lies_on p (Segment w1 w2) -> ~ lies_on p t) ->
  eventually (fun e => forall p,
    lies_on p (Segment (shifted_right w1 w2 e w1) (shifted_right w1 w2 e w2)) -> ~ lies_on p t).
Proof.
  intros moves apart_. destruct t as [t0 t1].
  set (len := dot (minus w2 w1) (minus w2 w1)).
  assert (some : 0 < len).
  { unfold len, dot. destruct (Qlt_le_dec 0 (vx (minus w2 w1) * vx (minus w2 w1) + vy (minus w2 w1) * vy (minus w2 w1)))
      as [| none]; [assumption |]. exfalso. apply moves. now apply no_squares. }
  set (A := area (Segment w1 w2) t0). set (B := area (Segment w1 w2) t1).
  set (G := ahead_of w1 w2 t0). set (H := ahead_of w1 w2 t1).
  (* where the two would meet *)
  assert (common : forall e p,
    lies_on p (Segment (shifted_right w1 w2 e w1) (shifted_right w1 w2 e w2)) -> lies_on p (Segment t0 t1) ->
    exists k, 0 <= k <= 1 /\ (1 - k) * A + k * B == - (e * len) /\ 0 <= (1 - k) * G + k * H <= len).
  { intros e p (h & [h0 h1] & px & py) (k & k_range & qx & qy). cbn [source target] in *.
    exists k. split; [exact k_range |].
    assert (side_t : (1 - k) * A + k * B == area (Segment w1 w2) p)
      by (unfold A, B, area, cross, minus; cbn [source target vx vy]; rewrite qx, qy; ring).
    assert (along_t : (1 - k) * G + k * H == ahead_of w1 w2 p)
      by (unfold G, H, ahead_of, dot, minus; cbn [vx vy]; rewrite qx, qy; ring).
    assert (side_s : area (Segment w1 w2) p == - (e * len))
      by (unfold len, area, cross, dot, shifted_right, moved_along, minus in *; cbn [source target vx vy] in *;
          rewrite px, py; ring).
    assert (along_s : ahead_of w1 w2 p == h * len)
      by (unfold len, ahead_of, dot, shifted_right, moved_along, minus in *; cbn [vx vy] in *; rewrite px, py; ring).
    rewrite side_t, along_t, along_s. split; [exact side_s |].
    assert (0 <= h * len) by (apply Qmult_le_0_compat; lra).
    assert (0 <= (1 - h) * len) by (apply Qmult_le_0_compat; lra). lra. }
  assert (all_left : 0 <= A -> 0 <= B -> eventually (fun e => forall p,
    lies_on p (Segment (shifted_right w1 w2 e w1) (shifted_right w1 w2 e w2)) -> ~ lies_on p (Segment t0 t1))).
  { intros a b. exists 1. split; [lra |]. intros e e0 _ p on_s on_t.
    destruct (common e p on_s on_t) as (k & [k0 k1] & side_ & _).
    assert (0 <= (1 - k) * A) by (apply Qmult_le_0_compat; lra). assert (0 <= k * B) by (apply Qmult_le_0_compat; lra).
    assert (0 < e * len) by now apply Qmult_lt_0_compat. lra. }
  assert (all_right : A < 0 -> B < 0 -> eventually (fun e => forall p,
    lies_on p (Segment (shifted_right w1 w2 e w1) (shifted_right w1 w2 e w2)) -> ~ lies_on p (Segment t0 t1))).
  { intros a b.
    refine (eventually_implied _ _ _ (eventually_and _ _ (eventually_positive (- A) (- len) _)
      (eventually_positive (- B) (- len) _))); [| lra | lra].
    intros e [small_a small_b] p on_s on_t.
    destruct (common e p on_s on_t) as (k & [k0 k1] & side_ & _).
    assert (0 <= (1 - k) * (- A - e * len)) by (apply Qmult_le_0_compat; lra).
    assert (0 <= k * (- B - e * len)) by (apply Qmult_le_0_compat; lra).
    destruct (Qlt_le_dec 0 k) as [k_some | k_none].
    - assert (0 < k * (- B - e * len)) by (apply Qmult_lt_0_compat; lra). lra.
    - assert (k == 0) as k_is by lra. rewrite k_is in side_. lra. }
  destruct (Qlt_le_dec A 0) as [a | a], (Qlt_le_dec B 0) as [b | b]; [now apply all_right | | | now apply all_left].
  all: assert (apart_ends : ~ A - B == 0) by lra;
    set (k0 := A / (A - B));
    assert (k0_value : k0 * (A - B) == A) by (unfold k0; field; exact apart_ends);
    assert (k0_range : 0 <= k0 <= 1)
      by (unfold k0; apply fraction_between; lra);
    (* where t crosses the line *)
    set (z := Vector ((1 - k0) * vx t0 + k0 * vx t1) ((1 - k0) * vy t0 + k0 * vy t1));
    assert (z_line : area (Segment w1 w2) z == 0)
      by (setoid_replace (area (Segment w1 w2) z) with (A - k0 * (A - B))
            by (unfold A, B, area, cross, minus, z; cbn [source target vx vy]; ring); rewrite k0_value; ring);
    assert (z_ahead : ahead_of w1 w2 z == G + k0 * (H - G))
      by (unfold G, H, ahead_of, dot, minus, z; cbn [vx vy]; ring);
    assert (z_on : lies_on z (Segment t0 t1))
      by (exists k0; cbn [source target]; unfold z; cbn [vx vy]; split; [exact k0_range | split; reflexivity]);
    assert (outside : G + k0 * (H - G) < 0 \/ len < G + k0 * (H - G))
      by (destruct (Qlt_le_dec (G + k0 * (H - G)) 0) as [| not_before]; [now left |];
          destruct (Qlt_le_dec len (G + k0 * (H - G))) as [| not_after]; [now right |]; exfalso;
          apply (apart_ z); [| exact z_on]; apply on_segment_by_coordinates;
            [exact some | exact z_line | fold len; rewrite z_ahead; now split]);
    set (rate := len / (A - B) * (H - G));
    assert (where_ : forall e k, (1 - k) * A + k * B == - (e * len) ->
              (1 - k) * G + k * H == G + k0 * (H - G) + e * rate)
      by (intros e k side_; unfold rate, k0;
          assert (k_is : k == (A + e * len) / (A - B))
            by (apply (Qmult_inj_r _ _ (A - B) apart_ends);
                setoid_replace ((A + e * len) / (A - B) * (A - B)) with (A + e * len)
                  by (field; exact apart_ends); lra);
          rewrite k_is; field; exact apart_ends);
    clearbody rate.
  all: destruct outside as [before_ | after_];
    [ refine (eventually_implied _ _ _ (eventually_positive (- (G + k0 * (H - G))) (- rate) _)); [| lra];
      intros e small p on_s on_t; destruct (common e p on_s on_t) as (k & _ & side_ & range);
      rewrite (where_ e k side_) in range; lra
    | refine (eventually_implied _ _ _ (eventually_positive (G + k0 * (H - G) - len) rate _)); [| lra];
      intros e small p on_s on_t; destruct (common e p on_s on_t) as (k & _ & side_ & range);
      rewrite (where_ e k side_) in range; lra ].
Qed.

(* All points close to the right of a point of an edge have one winding number. *)
Lemma right_side_near (r : region) (s : segment) (w : vector) :
  edges_meet_in_vertices r -> In s (region_edges r) -> lies_on w s -> ~ is_vertex w r ->
  exists radius, 0 < radius /\ forall y z, within radius w y -> within radius w z ->
    area s y < 0 -> area s z < 0 -> winding_number y (region_edges r) = winding_number z (region_edges r).
Proof.
  intros meet I on no_vertex. destruct (in_split _ _ I) as (earlier & later & edges_are).
  assert (free : off w (earlier ++ later)).
  { intros t J on_t. apply no_vertex. exact (meet earlier s later t w edges_are J on on_t). }
  destruct (off_near w _ free) as (radius & R & near). exists radius. split; [exact R |].
  intros y z y_near z_near y_right z_right.
  apply (winding_number_along (Segment y z) _ (region_cycles r)).
  intros v on_way t J. rewrite edges_are in J. apply in_app_iff in J.
  assert (v_near : within radius w v) by now apply (within_along radius w y z).
  destruct J as [J | [<- | J]]; [apply near; trivial; apply in_app_iff; tauto | |
    apply near; trivial; apply in_app_iff; tauto].
  apply off_by_area. destruct on_way as (h & range & vx_is & vy_is). cbn [source target] in *.
  assert (value : area s v == (1 - h) * area s y + h * area s z)
    by (unfold area, cross, minus; cbn [vx vy]; rewrite vx_is, vy_is; ring).
  rewrite value. intros zero_. destruct (Qlt_le_dec 0 h) as [some | none].
  - assert (0 < h * - area s z) by (apply Qmult_lt_0_compat; lra).
    assert (0 <= (1 - h) * - area s y) by (apply Qmult_le_0_compat; lra). lra.
  - assert (h == 0) as h_is by lra. rewrite h_is in zero_. lra.
Qed.

(* The winding number of all points close to the right of w. *)
Definition right_value (r : region) (s : segment) (w : vector) (number : Z) : Prop :=
  exists radius, 0 < radius /\ forall y, within radius w y -> area s y < 0 ->
    winding_number y (region_edges r) = number.

(* No vertex, of this or another chain, is between the ends of the edge. *)
Definition clear_edge (r : region) (s : segment) : Prop :=
  forall k w, 0 < k < 1 -> vx w == (1 - k) * vx (source s) + k * vx (target s) ->
    vy w == (1 - k) * vy (source s) + k * vy (target s) -> ~ is_vertex w r.

Definition point_at (s : segment) (k : Q) : vector :=
  Vector ((1 - k) * vx (source s) + k * vx (target s)) ((1 - k) * vy (source s) + k * vy (target s)).

Lemma right_step_is_right (s : segment) (w n : vector) (e : Q) :
  area s w == 0 -> 0 < cross (along s) n -> 0 < e -> area s (moved_along w n (- e)) < 0.
Proof.
  intros line left_ some.
  assert (value : area s (moved_along w n (- e)) == area s w - e * cross (along s) n)
    by (unfold area, cross, along, minus, moved_along; cbn [vx vy]; ring).
  rewrite value, line. assert (0 < e * cross (along s) n) by now apply Qmult_lt_0_compat. lra.
Qed.

Lemma point_at_is_on_the_line (s : segment) (k : Q) : area s (point_at s k) == 0.
Proof. unfold area, cross, minus, point_at; cbn [vx vy]. ring. Qed.

Lemma point_at_lies_on (s : segment) (k : Q) : 0 <= k <= 1 -> lies_on (point_at s k) s.
Proof. intros range. exists k. unfold point_at; cbn [vx vy]. split; [exact range |]. split; reflexivity. Qed.

Section OneEdge.
  Variable r : region.
  Variable s : segment.
  Hypothesis meet : edges_meet_in_vertices r.
  Hypothesis I : In s (region_edges r).
  Hypothesis long : nonzero (along s).
  Hypothesis clear_ : clear_edge r s.

  Lemma no_vertex_at (k : Q) : 0 < k < 1 -> ~ is_vertex (point_at s k) r.
  Proof. intros range. apply (clear_ k); [exact range | reflexivity | reflexivity]. Qed.

  Lemma some_right_value (k : Q) : 0 < k < 1 -> exists number, right_value r s (point_at s k) number.
  Proof.
    intros range. assert (on : lies_on (point_at s k) s) by (apply point_at_lies_on; lra).
    destruct (right_side_near r s (point_at s k) meet I on (no_vertex_at k range)) as (radius & R & alike).
    pose proof (left_normal s long) as left_. set (n := Vector (- vy (along s)) (vx (along s))) in *.
    destruct (small_steps_stay_within radius (point_at s k) (opposite n) R) as (limit & L & near).
    set (e := (1 # 2) * limit). assert (e_range : 0 < e < limit) by (unfold e; lra).
    set (y := moved_along (point_at s k) n (- e)).
    assert (y_near : within radius (point_at s k) y).
    { specialize (near e ltac:(lra) ltac:(lra)). unfold y, within, moved_along, opposite in *; cbn [vx vy] in *. lra. }
    assert (y_right : area s y < 0)
      by (apply right_step_is_right; [apply point_at_is_on_the_line | exact left_ | lra]).
    exists (winding_number y (region_edges r)), radius. split; [exact R |]. intros z z_near z_right.
    now apply alike.
  Qed.

  (* The same all along the edge. *)
  Lemma right_value_ahead (k1 k2 : Q) (number_1 number_2 : Z) : 0 < k1 -> k1 < k2 -> k2 < 1 ->
    right_value r s (point_at s k1) number_1 -> right_value r s (point_at s k2) number_2 -> number_1 = number_2.
  Proof.
    intros k1_some order k2_some (r1 & R1 & value_1) (r2 & R2 & value_2).
    set (w1 := point_at s k1) in *. set (w2 := point_at s k2) in *.
    set (n := Vector (vy (minus w2 w1)) (- vx (minus w2 w1))).
    assert (step_x : vx (minus w2 w1) == (k2 - k1) * vx (along s))
      by (unfold w1, w2, point_at, along, minus; cbn [vx vy]; ring).
    assert (step_y : vy (minus w2 w1) == (k2 - k1) * vy (along s))
      by (unfold w1, w2, point_at, along, minus; cbn [vx vy]; ring).
    assert (square : 0 < vx (along s) * vx (along s) + vy (along s) * vy (along s)).
    { destruct (Qlt_le_dec 0 (vx (along s) * vx (along s) + vy (along s) * vy (along s))) as [| none];
        [assumption |]. exfalso. apply long. now apply no_squares. }
    assert (right_ : cross (along s) n < 0).
    { assert (value : cross (along s) n ==
        - ((k2 - k1) * (vx (along s) * vx (along s) + vy (along s) * vy (along s))))
        by (unfold n, cross; cbn [vx vy]; rewrite step_x, step_y; ring).
      rewrite value. assert (0 < (k2 - k1) * (vx (along s) * vx (along s) + vy (along s) * vy (along s)))
        by (apply Qmult_lt_0_compat; lra). lra. }
    assert (moves : nonzero (minus w2 w1)).
    { intros [zero_x zero_y]. apply long. split; apply (Qmult_inj_r _ _ (k2 - k1)); lra. }
    assert (on_the_edge : forall p, lies_on p (Segment w1 w2) ->
      exists k, 0 < k < 1 /\ equal_vectors p (point_at s k)).
    { intros p (h & [h0 h1] & px & py). cbn [source target] in px, py. exists ((1 - h) * k1 + h * k2).
      assert (0 <= h * (k2 - k1)) by (apply Qmult_le_0_compat; lra).
      assert (0 <= (1 - h) * (k2 - k1)) by (apply Qmult_le_0_compat; lra). split; [lra |].
      unfold w1, w2, point_at in *; cbn [vx vy] in *. split; cbn [vx vy]; [rewrite px | rewrite py]; ring. }
    destruct (in_split _ _ I) as (earlier & later & edges_are).
    assert (others_apart : eventually (fun e => forall t, In t (earlier ++ later) ->
      forall p, lies_on p (Segment (shifted_right w1 w2 e w1) (shifted_right w1 w2 e w2)) -> ~ lies_on p t)).
    { apply (eventually_for_all (fun t e => forall p,
        lies_on p (Segment (shifted_right w1 w2 e w1) (shifted_right w1 w2 e w2)) -> ~ lies_on p t)).
      intros t J. apply shifted_segments_do_not_meet; [exact moves |]. intros p on on_t.
      destruct (on_the_edge p on) as (k & range & [px py]).
      apply (clear_ k p range px py). apply (meet earlier s later t p edges_are J); [| exact on_t].
      exists k. split; [lra |]. now split. }
    destruct (eventually_and _ _ others_apart (eventually_and _ _
      (small_steps_stay_within r1 w1 n R1) (small_steps_stay_within r2 w2 n R2))) as (limit & L & near).
    destruct (near ((1 # 2) * limit)) as (free & near_1 & near_2); [lra | lra |].
    set (e := (1 # 2) * limit) in *. assert (some : 0 < e) by (unfold e; lra). clearbody e. clear near.
    assert (to_the_right : forall k, area s (moved_along (point_at s k) n e) < 0).
    { intros k. assert (value : area s (moved_along (point_at s k) n e) == e * cross (along s) n)
        by (unfold area, point_at, cross, along, minus, moved_along; cbn [vx vy]; ring).
      rewrite value. assert (0 < e * - cross (along s) n) by (apply Qmult_lt_0_compat; lra). lra. }
    rewrite <- (value_1 (moved_along w1 n e) near_1 (to_the_right k1)).
    rewrite <- (value_2 (moved_along w2 n e) near_2 (to_the_right k2)).
    apply (winding_number_along (Segment (moved_along w1 n e) (moved_along w2 n e)) _ (region_cycles r)).
    intros p on t J. rewrite edges_are in J. apply in_app_iff in J.
    destruct J as [J | [<- | J]]; [apply (free t); [apply in_app_iff; tauto | exact on] | |
      apply (free t); [apply in_app_iff; tauto | exact on]].
    apply off_by_area. destruct on as (h & range & px & py). cbn [source target] in *.
    assert (value : area s p == (1 - h) * area s (moved_along w1 n e) + h * area s (moved_along w2 n e))
      by (unfold area, cross, minus; cbn [vx vy]; rewrite px, py; ring).
    pose proof (to_the_right k1) as right_1. pose proof (to_the_right k2) as right_2. fold w1 in right_1.
    fold w2 in right_2.
    rewrite value. intros zero_. destruct (Qlt_le_dec 0 h) as [h_some | none].
    - assert (0 < h * - area s (moved_along w2 n e)) by (apply Qmult_lt_0_compat; lra).
      assert (0 <= (1 - h) * - area s (moved_along w1 n e)) by (apply Qmult_le_0_compat; lra). lra.
    - assert (h == 0) as h_is by lra. rewrite h_is in zero_. lra.
  Qed.

  Lemma right_value_everywhere (k1 k2 : Q) (number_1 number_2 : Z) : 0 < k1 < 1 -> 0 < k2 < 1 ->
    right_value r s (point_at s k1) number_1 -> right_value r s (point_at s k2) number_2 -> number_1 = number_2.
  Proof.
    intros range_1 range_2 value_1 value_2. destruct (Q_dec k1 k2) as [[before_ | after_] | equal].
    - apply (right_value_ahead k1 k2); trivial; lra.
    - symmetry. apply (right_value_ahead k2 k1); trivial; lra.
    - (* one point *)
      destruct (Qlt_le_dec k1 (1 # 2)) as [low | high].
      + destruct (some_right_value (3 # 4)) as (number & value); [lra |].
        rewrite (right_value_ahead k1 (3 # 4) number_1 number), (right_value_ahead k2 (3 # 4) number_2 number);
          trivial; lra.
      + destruct (some_right_value (1 # 4)) as (number & value); [lra |].
        rewrite <- (right_value_ahead (1 # 4) k1 number number_1), <- (right_value_ahead (1 # 4) k2 number number_2);
          trivial; lra.
  Qed.

  (* Beside the middle it is what the code counts on symbolic shifts. *)
  Lemma right_value_of_the_middle :
    right_value r s (point_at s (1 # 2)) (winding_number_shifted (right_of_middle s) (region_edges r)).
  Proof.
    destruct (some_right_value (1 # 2)) as (number & radius & R & value); [lra |].
    enough (same_number : winding_number_shifted (right_of_middle s) (region_edges r) = number)
      by (rewrite same_number; now exists radius).
    set (m := right_of_middle s).
    destruct (shifts_are_small_moves s (region_edges r) long) as (l0 & L0 & shifts). fold m in shifts.
    assert (quarter : 0 < (1 # 2) * radius) by lra.
    destruct (small_steps_stay_within _ (point_at s (1 # 2)) (first m) quarter) as (l1 & L1 & near_1).
    destruct (small_steps_stay_within _ (point_at s (1 # 2)) (second m) quarter) as (l2 & L2 & near_2).
    set (limit := Qmin (Qmin l0 l1) (Qmin l2 1)).
    assert (bounds : 0 < limit /\ limit <= l0 /\ limit <= l1 /\ limit <= l2 /\ limit <= 1).
    { unfold limit. pose proof (Q.le_min_l (Qmin l0 l1) (Qmin l2 1)). pose proof (Q.le_min_r (Qmin l0 l1) (Qmin l2 1)).
      pose proof (Q.le_min_l l0 l1). pose proof (Q.le_min_r l0 l1). pose proof (Q.le_min_l l2 1).
      pose proof (Q.le_min_r l2 1). split; [repeat apply Q.min_glb_lt; lra | lra]. }
    clearbody limit. destruct bounds as (L & B0 & B1 & B2 & B3).
    set (e := (1 # 2) * limit). assert (e_range : 0 < e /\ e < limit) by (unfold e; lra). clearbody e.
    assert (e_square : 0 < e * e /\ e * e < limit) by (split; [apply Qmult_lt_0_compat; lra | nra]).
    destruct (shifts e) as [_ <-]; [lra | lra |].
    specialize (near_1 e ltac:(lra) ltac:(lra)). specialize (near_2 (e * e) ltac:(lra) ltac:(lra)).
    assert (at_x : vx (at_ m) == vx (point_at s (1 # 2)))
      by (unfold m, right_of_middle, point_at; cbn [at_ vx vy]; field).
    assert (at_y : vy (at_ m) == vy (point_at s (1 # 2)))
      by (unfold m, right_of_middle, point_at; cbn [at_ vx vy]; field).
    apply value.
    - unfold within, moved_along, moved in *; cbn [vx vy] in *. rewrite at_x, at_y. lra.
    - assert (area_is : area s (moved m e) ==
        e * cross (along s) (first m) + e * e * cross (along s) (second m)).
      { unfold area, cross, along, minus, moved; cbn [vx vy]. rewrite at_x, at_y. unfold point_at; cbn [vx vy]. ring. }
      assert (along_first : cross (along s) (first m) == 0).
      { unfold m, right_of_middle; cbn [first]. fold (along s). unfold cross.
        destruct (negative (vy (along s))); cbn [vx vy]; ring. }
      assert (to_second : cross (along s) (second m) < 0).
      { pose proof (left_normal s long) as left_. unfold cross in left_ |- *.
        unfold m, right_of_middle; cbn [second vx vy] in *. fold (along s). lra. }
      rewrite area_is, along_first.
      assert (0 < e * e * - cross (along s) (second m)) by (apply Qmult_lt_0_compat; lra). lra.
  Qed.
End OneEdge.

(* Up to the first edge to the right, the winding number is the same. *)
Lemma same_before_the_first_hit (x z : vector) (s : segment) (segments : list segment) :
  vy z = vy x -> vx x <= vx z -> vx z < vx (point_at_height s (vy x)) ->
  (forall t, In t segments -> signed_crossing x t <> 0%Z ->
     vx (point_at_height s (vy x)) <= vx (point_at_height t (vy x))) ->
  winding_number z segments = winding_number x segments.
Proof.
  intros height ahead_ before_ first_. unfold winding_number. f_equal. apply map_ext_in. intros t J.
  specialize (first_ t J). rewrite !signed_crossing_by_height. rewrite signed_crossing_by_height in first_.
  rewrite height. destruct (spans t (vy x)); [| reflexivity]. cbn [andb] in *.
  destruct (negative_spec (vx x - vx (point_at_height t (vy x)))) as [hit | miss],
    (negative_spec (vx z - vx (point_at_height t (vy x)))) as [hit_z | miss_z]; try reflexivity; exfalso.
  - assert (vx (point_at_height s (vy x)) <= vx (point_at_height t (vy x)))
      by (apply first_; destruct (at_most (vy (source t)) (vy x)); discriminate). lra.
  - lra.
Qed.

(* Theorem. Off the chains, every winding number is zero, or that to the right of the middle of some edge, or one more. *)
Theorem winding_number_by_middles (r : region) (x : vector) :
  no_edges_are_points r -> edges_meet_in_vertices r -> (forall s, In s (region_edges r) -> clear_edge r s) ->
  off x (region_edges r) ->
  winding_number x (region_edges r) = 0%Z \/
  exists s, In s (region_edges r) /\
    (winding_number x (region_edges r) = winding_number_shifted (right_of_middle s) (region_edges r) \/
     winding_number x (region_edges r) = (winding_number_shifted (right_of_middle s) (region_edges r) + 1)%Z).
Proof.
  intros not_points meet all_clear free.
  destruct (winding_number_near x _ (region_cycles r) free) as (radius & R & near).
  (* at a height at which there is no vertex *)
  assert (heights : eventually (fun e => forall t, In t (region_edges r) -> ~ vy x + e * 1 == vy (source t)))
    by (apply (eventually_for_all (fun t e => ~ vy x + e * 1 == vy (source t)));
        intros t _; apply leaves_a_number; lra).
  destruct (eventually_and _ _ heights (small_steps_stay_within radius x (Vector 0 1) R)) as (limit & L & good).
  destruct (good ((1 # 2) * limit)) as (no_vertex & close); [lra | lra |]. clear good.
  destruct (near _ close) as [_ <-]. set (x' := moved_along x (Vector 0 1) ((1 # 2) * limit)) in *.
  assert (no_vertex_' : forall t, In t (region_edges r) -> ~ vy x' == vy (source t)) by exact no_vertex.
  clearbody x'. clear no_vertex close near.
  destruct (filter (fun s => negb (signed_crossing x' s =? 0)%Z) (region_edges r)) as [| a rest] eqn:hits.
  - assert (none : forall s, In s (region_edges r) -> signed_crossing x' s = 0%Z).
    { intros s I. destruct (Z.eq_dec (signed_crossing x' s) 0) as [| met]; [assumption | exfalso].
      assert (In s []) as []. rewrite <- hits. apply filter_In. split; [exact I |].
      apply negb_true_iff, Z.eqb_neq, met. }
    assert (zero_ : forall l, incl l (region_edges r) -> winding_number x' l = 0%Z).
    { intros l. unfold winding_number, sum. induction l as [| s l IH]; intros part; [reflexivity |].
      cbn [map fold_right].
      rewrite (none s) by (apply part; now left). rewrite IH by (intros t J; apply part; now right). reflexivity. }
    left. apply zero_. intros t J. exact J.
  - destruct (least_of (fun s => vx (point_at_height s (vy x'))) (a :: rest)) as (s & I & first_);
      [discriminate |].
    rewrite <- hits in I, first_. apply filter_In in I. destruct I as [I met].
    apply negb_true_iff, Z.eqb_neq in met.
    assert (first_of_all : forall t, In t (region_edges r) -> signed_crossing x' t <> 0%Z ->
      vx (point_at_height s (vy x')) <= vx (point_at_height t (vy x'))).
    { intros t J also. apply first_. apply filter_In. split; [exact J |]. now apply negb_true_iff, Z.eqb_neq. }
    clear first_ hits.
    assert (hit : spans s (vy x') = true /\ vx x' < vx (point_at_height s (vy x'))).
    { rewrite signed_crossing_by_height in met. destruct (spans s (vy x')); [| now destruct met].
      destruct (negative_spec (vx x' - vx (point_at_height s (vy x'))));
        [split; [reflexivity | lra] | now destruct met]. }
    destruct hit as [spanning ahead_].
    pose proof (region_edges_are_directions r not_points s I) as long.
    set (w := point_at_height s (vy x')) in *.
    assert (on : lies_on w s) by now apply point_at_height_lies_on.
    assert (no_vertex_w : ~ is_vertex w r) by (intros (t & J & [_ wy]); exact (no_vertex_' t J wy)).
    pose proof on as (k & k_range & wx & wy).
    assert (k_inside : 0 < k < 1).
    { split; apply Qnot_le_lt; intros extreme; apply no_vertex_w.
      - exists s. split; [exact I |]. assert (k == 0) as k_is by lra. rewrite k_is in wx, wy. split; lra.
      - destruct (target_is_vertex r s I) as (u & J & tx & ty). exists u. split; [exact J |].
        assert (k == 1) as k_is by lra. rewrite k_is in wx, wy. split; lra. }
    (* the number to the right of the edge *)
    destruct (some_right_value r s meet I long (all_clear s I) k k_inside) as (number & value).
    pose proof (right_value_of_the_middle r s meet I long (all_clear s I)) as middle_value.
    assert (number_is : number = winding_number_shifted (right_of_middle s) (region_edges r))
      by (apply (right_value_everywhere r s meet I long (all_clear s I) k (1 # 2)); trivial; lra).
    right. exists s. split; [exact I |]. rewrite <- number_is. clear middle_value number_is.
    destruct value as (r0 & R0 & value).
    assert (right_number : forall n, 0 < cross (along s) n ->
      eventually (fun e => winding_number (moved_along w n (- e)) (region_edges r) = number)).
    { intros n left_.
      refine (eventually_implied _ _ _ (eventually_and _ _ (ex_intro _ 1 (conj (ltac:(lra) : 0 < 1)
        (fun e some _ => some : 0 < e))) (small_steps_stay_within r0 w (opposite n) R0))).
      intros e [some close]. apply value.
      - unfold within, moved_along, opposite, point_at in *; cbn [vx vy] in *. lra.
      - apply right_step_is_right; trivial. pose proof (on_its_line w s on) as line.
        rewrite orientation_by_area in line. apply equal_comparison in line. destruct s. exact line. }
    assert (before_hit : eventually (fun e =>
      winding_number (Vector (vx w - e) (vy x')) (region_edges r) = winding_number x' (region_edges r))).
    { exists (vx w - vx x'). split; [lra |]. intros e e0 e1.
      apply (same_before_the_first_hit x' (Vector (vx w - e) (vy x')) s); trivial; cbn [vx]; fold w; lra. }
    apply heights_of_spanning in spanning. destruct spanning as [up | down].
    + (* x is to the left of the edge *)
      set (n := Vector (-1) 0).
      assert (left_ : 0 < cross (along s) n) by (unfold cross, n, along, minus; cbn [vx vy]; lra).
      destruct (eventually_and _ _ before_hit (eventually_and _ _ (right_number n left_)
        (left_is_one_more r s w n meet I on no_vertex_w left_))) as (len & some & all).
      destruct (all ((1 # 2) * len)) as (same_number & right_ & _ & _ & more); [lra | lra |].
      rewrite <- same_number.
      rewrite (winding_number_of_equal _ (moved_along w n ((1 # 2) * len))); [right; lia | |];
        unfold moved_along, n, w, point_at_height; cbn [vx vy]; ring.
    + (* x is to the right of it *)
      set (n := Vector 1 0).
      assert (left_ : 0 < cross (along s) n) by (unfold cross, n, along, minus; cbn [vx vy]; lra).
      destruct (eventually_and _ _ before_hit (right_number n left_)) as (len & some & all).
      destruct (all ((1 # 2) * len)) as (same_number & right_); [lra | lra |].
      rewrite <- same_number.
      rewrite (winding_number_of_equal _ (moved_along w n (- ((1 # 2) * len)))); [left; lia | |];
        unfold moved_along, n, w, point_at_height; cbn [vx vy]; ring.
Qed.

(* Theorem. If winding numbers to the right of the middles of edges are not negative, none is. *)
Theorem nowhere_negative_by_middles (r : region) :
  no_edges_are_points r -> edges_meet_in_vertices r -> (forall s, In s (region_edges r) -> clear_edge r s) ->
  (forall s, In s (region_edges r) ->
     (0 <= winding_number_shifted (right_of_middle s) (region_edges r))%Z) ->
  nowhere_negative r.
Proof.
  intros not_points meet all_clear middles x free.
  destruct (winding_number_by_middles r x not_points meet all_clear free) as [zero_ | (s & I & value)]; [lia |].
  specialize (middles s I). lia.
Qed.
