(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The edges of a region at a point w, any number of them, however its chains connect them: chains may touch there. In
   a direction a from w, add up three numbers: the winding number there, the edges that leave w to the left of a, and
   the vertices at w that have -a in their tangent sets. The sum is the same in all directions: turning a, one passes
   an edge that leaves w, or one that enters it, or the opposite of one, and each time the sum stays (tangent sets are
   differences, weight.v). So if the winding number is zero in the direction a, and no tangent set contains -a, more
   than half of the edges that leave w do so to the left of a. *)
From Coq Require Import ZArith Lia Bool List.
From Oplus Require Import numbers convolution shifted_ray signed_crossings crossing_of_a_step tie_rule regions weight
  finite_sums tangent_count meeting_of_segments neighbourhoods beside_every_point winding_number_of_the_sum
  interiors_meet left_of_an_edge theorem_4_2_1 edges_at_a_point.
Import ListNotations.

Open Scope Q_scope.

(* Edges by vertices: at each vertex at w one edge enters and one leaves. *)
Lemma vertices_at_a_point (r : region) (w : vector) (f : vector -> Z) :
  sum_of (fun v => Z.b2z (same_place w (fst v)) * (f (incoming (snd v)) - f (outgoing (snd v))))%Z
    (region_vertices r) =
  sum_of (fun s => (Z.b2z (arrives w s) - Z.b2z (departs w s)) * f (along s))%Z (region_edges r).
Proof.
  unfold region_vertices, region_edges. rewrite !sum_of_flat_map. apply sum_equally. intros chain _.
  rewrite vertices_by_index, (sum_by_index _ _ no_segment _ (length chain)) by apply edges_are_as_many.
  set (n := length chain). set (at_ i := Z.b2z (same_place w (nth i chain nowhere))).
  set (e i := f (edge_of_chain chain i)).
  transitivity (sum_below n (fun i => e i * at_ (next i n) - at_ i * e i)%Z).
  - rewrite sum_below_equally with (g := fun i => (e (previous n i) * at_ i - at_ i * e i)%Z).
    + pose proof (sum_of_previous n e at_) as moved_. unfold sum_below in *. rewrite !sum_minus. lia.
    + intros i I. cbn [fst snd]. rewrite corner_is by exact I. unfold e, at_. cbn [incoming outgoing]. fold n. lia.
  - apply sum_below_equally. intros i I. unfold e. rewrite direction_by_index by exact I.
    set (s := nth i (edges chain) no_segment).
    assert (ends : at_ i = Z.b2z (same_place w (source s)) /\ at_ (next i n) = Z.b2z (same_place w (target s))).
    { unfold s. rewrite edge_by_index by exact I. now split. }
    destruct ends as [-> ->]. unfold arrives, departs, comes_by.
    destruct (lies_on_dec w s) as [on | free], (same_place_spec w (source s)) as [at_source |],
      (same_place_spec w (target s)) as [at_target |]; cbn [andb negb Z.b2z]; try lia; exfalso; apply free.
    + apply (lies_on_equal (source s)); [now symmetry | apply source_lies_on].
    + apply (lies_on_equal (target s)); [now symmetry | apply target_lies_on].
Qed.

Lemma left_by_angles (u v : vector) : nonzero u -> nonzero v ->
  (0 < cross u v -> 0 < angle v - angle u < 2 \/ angle v - angle u < -2) /\
  (~ 0 < cross u v -> -2 <= angle v - angle u <= 0 \/ 2 <= angle v - angle u).
Proof.
  intros proper_u proper_v. pose proof (cross_angle u v proper_u proper_v) as turns_. unfold turns_by in turns_.
  split; intros sign; destruct turns_ as [[c turn_] | [[c turn_] | [(c & _ & turn_) | (c & _ & turn_)]]]; lra.
Qed.

Section Turning.
  Variables a b da db : vector.
  Variable label : summand.
  Hypothesis turn : 0 < cross a b.
  Hypothesis a_back : angle da == angle (opposite a).
  Hypothesis b_back : angle db == angle (opposite b).
  Hypothesis proper_da : nonzero da.
  Hypothesis proper_db : nonzero db.

  Definition change (v : vector) : Z :=
    (Z.b2z (before (Direction v (other label)) (Direction da label)) -
     Z.b2z (before (Direction v (other label)) (Direction db label)))%Z.

  (* Whether turning from -a to -b one passes the angle zero. *)
  Definition wraps : Z := if Qlt_le_dec (angle db) (angle da) then 1 else 0.

  Lemma edges_while_turning (v : vector) : nonzero v -> ~ angle v == angle da -> ~ angle v == angle db ->
    (change v + Z.b2z (is_amid a b (opposite v)) = wraps)%Z.
  Proof.
    intros proper_v differ_a differ_b.
    assert (proper_a : nonzero a) by (intros [X Y]; unfold cross in turn; rewrite X, Y in turn; lra).
    assert (proper_b : nonzero b) by (intros [X Y]; unfold cross in turn; rewrite X, Y in turn; lra).
    pose proof (opposite_nonzero a proper_a) as proper_oa. pose proof (opposite_nonzero b proper_b) as proper_ob.
    assert (back : cross a (opposite v) == cross (opposite a) v /\ cross (opposite v) b == cross v (opposite b) /\
      cross a b == cross (opposite a) (opposite b)) by (unfold cross, opposite; cbn [vx vy]; repeat split; ring).
    destruct back as (back_a & back_b & turn_back). rewrite turn_back in turn.
    destruct (left_by_angles _ _ proper_oa proper_ob) as [a_to_b _]. specialize (a_to_b turn).
    destruct (left_by_angles _ v proper_oa proper_v) as [after_a not_after_a].
    destruct (left_by_angles v _ proper_v proper_ob) as [before_b not_before_b].
    rewrite <- a_back in *. rewrite <- b_back in *. rewrite <- back_a in *. rewrite <- back_b in *.
    clear a_back b_back turn_back back_a back_b turn.
    pose proof (angle_range v proper_v). pose proof (angle_range da proper_da). pose proof (angle_range db proper_db).
    unfold change, wraps, is_amid.
    destruct (before_spec (Direction v (other label)) (Direction da label) proper_v proper_da) as [va | va],
      (before_spec (Direction v (other label)) (Direction db label) proper_v proper_db) as [vb | vb];
      unfold earlier in va, vb; cbn [vec] in va, vb.
    all: destruct (positive_spec (cross a (opposite v))) as [sa | sa];
      [specialize (after_a sa); clear not_after_a | specialize (not_after_a sa); clear after_a];
      (destruct (positive_spec (cross (opposite v) b)) as [sb | sb];
       [specialize (before_b sb); clear not_before_b | specialize (not_before_b sb); clear before_b]);
      clear sa sb; destruct (Qlt_le_dec (angle db) (angle da)); cbn [andb Z.b2z]; try reflexivity; exfalso.
    all: lra.
  Qed.

  Lemma departing_while_turning (v : vector) : ~ cross a v == 0 -> ~ cross b v == 0 ->
    (Z.b2z (positive (cross a v)) - Z.b2z (positive (cross b v)) - Z.b2z (is_amid a b v) +
     Z.b2z (is_amid a b (opposite v)) = 0)%Z.
  Proof.
    intros off_a off_b.
    assert (back : cross a (opposite v) == - cross a v /\ cross (opposite v) b == - cross v b /\
      cross b v == - cross v b) by (unfold cross, opposite; cbn [vx vy]; repeat split; ring).
    destruct back as (back_a & back_b & swapped).
    unfold is_amid. destruct (positive_spec (cross a v)), (positive_spec (cross b v)), (positive_spec (cross v b)),
      (positive_spec (cross a (opposite v))), (positive_spec (cross (opposite v) b));
      cbn [andb Z.b2z]; try reflexivity; exfalso; lra.
  Qed.
End Turning.

(* How many vertices at w have d in their tangent sets, and edges that leave w, and those that do so to the left. *)
Definition tangents_at (w : vector) (d : direction) (r : region) : Z :=
  sum_of (fun v => Z.b2z (same_place w (fst v)) * if_tangent d (snd v))%Z (region_vertices r).

Definition departures (w : vector) (r : region) : Z := sum_of (fun s => Z.b2z (departs w s)) (region_edges r).

Definition departures_left_of (w a : vector) (r : region) : Z :=
  sum_of (fun s => Z.b2z (departs w s) * Z.b2z (positive (cross a (along s))))%Z (region_edges r).

(* No edge at w has the direction -a, and none leaves w in the direction a. *)
Definition clear_direction (w a : vector) (r : region) : Prop :=
  forall s, In s (region_edges r) -> lies_on w s ->
    ~ same_direction (along s) (opposite a) /\ (departs w s = true -> ~ cross a (along s) == 0).

Lemma general_directions_are_clear (r : region) (w a : vector) :
  (forall s, In s (region_edges r) -> lies_on w s -> ~ cross a (along s) == 0) -> clear_direction w a r.
Proof.
  intros general s I on. pose proof (general s I on) as aside. split; [| intros _; exact aside].
  intros (m & _ & X & Y). apply aside. unfold cross, opposite in *; cbn [vx vy] in *. rewrite X, Y. ring.
Qed.

Section AtThePoint.
  Variable r : region.
  Variable w : vector.
  Variable label : summand.
  Variable radius : Q.
  Hypothesis not_points : no_edges_are_points r.
  Hypothesis near : nothing_else_near w radius r.

  Lemma clear_directions_are_off (a : vector) : nonzero a -> within radius w (plus w a) -> clear_direction w a r ->
    off (plus w a) (region_edges r).
  Proof.
    intros proper_a near_a clear_a s I on. pose proof (region_edges_are_directions r not_points s I) as long.
    destruct (proj2 near s) as [on_w | free].
    - apply in_flat_map. exists s. split; [exact I | now left].
    - destruct (clear_a s I on_w) as [differ aside].
      destruct (ahead_or_behind w a s on_w on) as (m & X & Y & ahead & _).
      destruct (Q_dec m 0) as [[low | high] | none].
      + apply differ. exists (/ - m). split; [apply Qinv_lt_0_compat; lra |]. unfold opposite; cbn [vx vy].
        rewrite X, Y. split; field; lra.
      + apply (aside (ahead high long)). unfold cross. rewrite X, Y. ring.
      + apply proper_a. rewrite X, Y, none. split; ring.
    - exact (free _ near_a on).
  Qed.

  (* A direction a in which nothing is in the way, and d, which leads back. *)
  Definition clear_step (a d : vector) : Prop :=
    within radius w (plus w a) /\ clear_direction w a r /\ nonzero d /\ same_direction d (opposite a).

  Definition total_around (a d : vector) : Z :=
    (tangents_at w (Direction d label) r + departures_left_of w a r + winding_number (plus w a) (region_edges r))%Z.

  Lemma same_to_the_left (a b da db : vector) : 0 < cross a b -> clear_step a da -> clear_step b db ->
    total_around a da = total_around b db.
  Proof.
    intros turn (near_a & clear_a & proper_da & a_back) (near_b & clear_b & proper_db & b_back).
    assert (proper_a : nonzero a) by (intros [X Y]; unfold cross in turn; rewrite X, Y in turn; lra).
    assert (proper_b : nonzero b) by (intros [X Y]; unfold cross in turn; rewrite X, Y in turn; lra).
    pose proof (winding_number_around_the_point r w a b radius not_points near turn near_a near_b
      (clear_directions_are_off a proper_a near_a clear_a) (clear_directions_are_off b proper_b near_b clear_b))
      as numbers.
    apply opposite_nonzero in proper_a, proper_b. apply same_direction_angle in a_back, b_back; trivial.
    assert (tangents : (tangents_at w (Direction da label) r - tangents_at w (Direction db label) r)%Z =
      sum_of (fun s => (Z.b2z (arrives w s) - Z.b2z (departs w s)) * change da db label (along s))%Z (region_edges r)).
    { rewrite <- vertices_at_a_point. unfold tangents_at. rewrite <- sum_minus. apply sum_equally. intros [v c] I.
      cbn [fst snd]. unfold if_tangent, change.
      assert (proper_c : proper_corner c).
      { destruct (edges_of_vertex v c r I) as ((s & S & _ & in_) & (t & T & _ & out_)).
        unfold proper_corner. rewrite <- in_, <- out_. split; now apply (region_edges_are_directions r). }
      rewrite !in_tangent_set_as_difference by assumption. cbn [of]. lia. }
    assert (as_many : sum_of (fun s => (Z.b2z (arrives w s) - Z.b2z (departs w s)) * wraps da db)%Z
      (region_edges r) = 0%Z).
    { rewrite <- (vertices_at_a_point r w (fun _ => wraps da db)). apply sum_of_zeros. intros. lia. }
    enough (each : (sum_of (fun s => (Z.b2z (arrives w s) - Z.b2z (departs w s)) * change da db label (along s))%Z
        (region_edges r) + departures_left_of w a r - departures_left_of w b r -
        sum_of (fun s => Z.b2z (departs w s) * Z.b2z (is_amid a b (along s)) -
                         Z.b2z (arrives w s) * Z.b2z (is_amid a b (opposite (along s))))%Z (region_edges r) =
        sum_of (fun s => (Z.b2z (arrives w s) - Z.b2z (departs w s)) * wraps da db)%Z (region_edges r))%Z)
      by (unfold total_around; lia).
    unfold departures_left_of. rewrite <- sum_plus, <- !sum_minus. apply sum_equally. intros s I.
    destruct (lies_on_dec w s) as [on | free].
    2: { unfold departs, arrives, comes_by. destruct (lies_on_dec w s); [contradiction | reflexivity]. }
    destruct (clear_a s I on) as [apart_a aside_a], (clear_b s I on) as [apart_b aside_b].
    pose proof (region_edges_are_directions r not_points s I) as long.
    rewrite same_direction_angle in apart_a, apart_b by trivial.
    rewrite <- a_back in apart_a. rewrite <- b_back in apart_b.
    pose proof (edges_while_turning a b da db label turn a_back b_back proper_da proper_db (along s) long apart_a
      apart_b) as turned_.
    destruct (departs w s) eqn:departing_.
    - pose proof (departing_while_turning a b (along s) (aside_a eq_refl) (aside_b eq_refl)) as left_.
      destruct (arrives w s); cbn [Z.b2z]; lia.
    - destruct (arrives w s); cbn [Z.b2z]; lia.
  Qed.

  (* Theorem. The sum of the three numbers is the same in all directions. *)
  Theorem same_in_all_directions (a b da db : vector) : ~ cross a b == 0 -> clear_step a da -> clear_step b db ->
    total_around a da = total_around b db.
  Proof.
    intros aside clear_a clear_b.
    destruct (Q_dec (cross a b) 0) as [[right_ | left_] | parallel]; [symmetry | | contradiction];
      apply same_to_the_left; trivial. unfold cross in *. lra.
  Qed.
End AtThePoint.

(* Small steps in a direction. *)
Definition scaled_by (k : Q) (v : vector) : vector := Vector (k * vx v) (k * vy v).

Lemma small_steps_are_clear (r : region) (w b : vector) (radius : Q) :
  nothing_else_near w radius r -> nonzero b -> clear_direction w b r ->
  eventually (fun k => clear_step r w radius (scaled_by k b) (opposite b) /\ nonzero (scaled_by k b) /\
    departures_left_of w (scaled_by k b) r = departures_left_of w b r).
Proof.
  intros [R _] long clear_b. refine (eventually_implied _ _ _ (eventually_and _ _ (eventually_below 1 ltac:(lra))
    (small_steps_stay_within radius w b R))).
  intros k [[some _] near_k]. assert (value : forall v, cross (scaled_by k b) v == k * cross b v)
    by (intros; unfold cross, scaled_by; cbn [vx vy]; ring).
  assert (ratio : / k * k == 1) by (field; lra). pose proof (Qinv_lt_0_compat k some) as some'. split; [| split].
  - split; [exact near_k |]. split; [| split; [now apply opposite_nonzero |]].
    + intros s I on. destruct (clear_b s I on) as [differ aside]. split.
      * intros (m & m_some & X & Y). apply differ. exists (m * k). unfold scaled_by, opposite in *; cbn [vx vy] in *.
        rewrite X, Y. split; [now apply Qmult_lt_0_compat | split; ring].
      * intros departing flat. apply (aside departing), (Qmult_inj_r _ _ k); [lra |]. rewrite value in flat. lra.
    + exists (/ k). unfold opposite, scaled_by; cbn [vx vy]. split; [exact some' |]. split; field; lra.
  - intros [X Y]. unfold scaled_by in X, Y; cbn [vx vy] in X, Y. apply long. split; apply (Qmult_inj_r _ _ k); lra.
  - apply sum_equally. intros s _. f_equal. f_equal.
    destruct (positive_spec (cross (scaled_by k b) (along s))) as [left_ | none], (positive_spec (cross b (along s)));
      trivial; exfalso; rewrite value in *; [nra |]. apply none. now apply Qmult_lt_0_compat.
Qed.

Lemma inside_or_nothing_there (r : region) (w z d : vector) (radius : Q) : valid_region r ->
  nothing_else_near w radius r -> clear_step r w radius z d -> nonzero z ->
  inside (plus w z) r \/ winding_number (plus w z) (region_edges r) = 0%Z.
Proof.
  intros (not_points & valid & _) near (near_z & clear_z & _) proper_z.
  pose proof (clear_directions_are_off r w radius not_points near z proper_z near_z clear_z) as free.
  pose proof (valid _ free). destruct (Z_lt_le_dec 0 (winding_number (plus w z) (region_edges r))); [now left; split |].
  right. lia.
Qed.

(* Near w is a point with the same winding number that is on none of some segments, nor on some lines. *)
Lemma point_beside (w : vector) (radius : Q) (segments lines : list segment) :
  0 < radius -> (forall t, In t lines -> nonzero (along t)) ->
  exists y, within radius w y /\ winding_number y segments = winding_number w segments /\ off y segments /\
    forall t, In t lines -> ~ area t y == 0.
Proof.
  intros R long.
  assert (off_line : forall t, In t lines -> eventually (fun e => ~ area t (moved (shifted w) e) == 0)).
  { intros t I. refine (eventually_implied _ _ _ (side_of_segment_nearby w t (long t I))).
    intros e [_ off_line] on_line. apply off_line. rewrite orientation_by_area. destruct t.
    now apply (proj1 (Qeq_alt _ _)). }
  destruct (some_small _ (eventually_and _ _ (shifted_stays_within _ w R) (eventually_and _ _
    (same_beside w segments) (eventually_and _ _ (shifted_off_all w segments)
    (eventually_for_all _ lines off_line))))) as (e & _ & found). exists (moved (shifted w) e). exact found.
Qed.

(* Near w, w + y is inside in a direction y that is parallel to no edge at w, nor to z. *)
Lemma inner_direction (r : region) (w z : vector) (radius : Q) : valid_region r -> 0 < radius -> nonzero z ->
  (exists s, In s (region_edges r) /\ lies_on w s) ->
  exists y, within radius w (plus w y) /\ within radius w (plus w (opposite y)) /\ ~ cross z y == 0 /\
    (forall s, In s (region_edges r) -> lies_on w s -> ~ cross y (along s) == 0) /\
    (0 < winding_number (plus w y) (region_edges r))%Z.
Proof.
  intros (not_points & valid & meet) R proper_z on_boundary. assert (half : 0 < (1 # 2) * radius) by lra.
  destruct (inside_near r w _ (regions_are_regular r not_points valid meet) (or_intror on_boundary) half)
    as (a & close_a & free & round).
  destruct (point_beside a _ (region_edges r) (Segment w (plus w z) :: region_edges r) half)
    as (p & close_p & same_number & _ & general).
  { intros t [<- | I]; [| now apply (region_edges_are_directions r)].
    intros [X Y]. apply proper_z. unfold along, plus, minus in X, Y; cbn [source target vx vy] in X, Y. lra. }
  pose proof (within_twice ((1 # 2) * radius) ((1 # 2) * radius) radius w a p ltac:(lra) close_a close_p) as close.
  set (y := minus p w). exists y.
  split; [unfold within, y, plus, minus in *; cbn [vx vy]; lra |].
  split; [unfold within, y, plus, opposite, minus in *; cbn [vx vy]; lra |].
  split; [| split].
  - intros aside. apply (general _ (or_introl eq_refl)). transitivity (cross z y); [| exact aside].
    unfold area, cross, y, plus, minus; cbn [source target vx vy]. ring.
  - intros s I (k & _ & X & Y) parallel. apply (general s (or_intror I)). transitivity (- cross y (along s)); [| lra].
    unfold area, cross, y, along, minus; cbn [vx vy]. rewrite X, Y. ring.
  - rewrite <- (winding_number_of_equal p (plus w y)); [lia | unfold y, plus, minus; cbn [vx vy]; ring ..].
Qed.

(* Theorem. If the direction b does not lead inside, and -b is in no tangent set, more than half of the edges that leave
   w do so to the left of b: the sum is the same in a direction y that is inside, and in -y. *)
Theorem more_than_half_depart_to_the_left (r : region) (w b : vector) (label : summand) :
  valid_region r -> nonzero b -> clear_direction w b r -> tangents_at w (Direction (opposite b) label) r = 0%Z ->
  (exists s, In s (region_edges r) /\ lies_on w s) ->
  eventually (fun k => inside (moved_along w b k) r \/ (departures w r < 2 * departures_left_of w b r)%Z).
Proof.
  intros r_region long clear_b no_tangent on_boundary. destruct (some_square w r) as (radius & near).
  refine (eventually_implied _ _ _ (small_steps_are_clear r w b radius near long clear_b)).
  intros k (clear_z & proper_z & <-). pose proof (proj1 r_region) as not_points. set (z := scaled_by k b) in *.
  destruct (inside_or_nothing_there r w z _ radius r_region near clear_z proper_z) as [| nothing_there];
    [now left | right].
  destruct (inner_direction r w z radius r_region (proj1 near) proper_z on_boundary)
    as (y & near_y & near_back & aside & general & round).
  assert (proper_y : nonzero y) by (intros [X Y]; apply aside; unfold cross; rewrite X, Y; ring).
  assert (turned_ : forall v, cross (opposite y) v == - cross y v /\ cross v (opposite y) == - cross v y)
    by (intros; unfold cross, opposite; cbn [vx vy]; split; ring).
  assert (itself : forall v, same_direction v v) by (intros v; exists 1; split; [lra | split; ring]).
  assert (ahead : total_around r w label z (opposite b) = total_around r w label y (opposite y)).
  { apply (same_in_all_directions r w label radius not_points near); trivial. split; [exact near_y |].
    split; [now apply general_directions_are_clear |]. split; [now apply opposite_nonzero | apply itself]. }
  assert (behind : total_around r w label z (opposite b) = total_around r w label (opposite y) y).
  { apply (same_in_all_directions r w label radius not_points near); trivial.
    - destruct (turned_ z) as [_ value]. rewrite value. lra.
    - split; [exact near_back |]. split; [| split; [exact proper_y | rewrite opposite_twice; apply itself]].
      apply general_directions_are_clear. intros s I on. destruct (turned_ (along s)) as [value _].
      pose proof (general s I on). rewrite value. lra. }
  assert (both_sides : (departures_left_of w y r + departures_left_of w (opposite y) r = departures w r)%Z).
  { unfold departures_left_of, departures. rewrite <- sum_plus. apply sum_equally. intros s I.
    destruct (departs w s) eqn:departing_; cbn [Z.b2z]; [| lia]. apply departs_is in departing_.
    pose proof (general s I (proj1 departing_)). pose proof (turned_ (along s)).
    destruct (positive_spec (cross y (along s))), (positive_spec (cross (opposite y) (along s)));
      cbn [Z.b2z]; try lia; exfalso; lra. }
  assert (tangents : forall d', (0 <= tangents_at w d' r)%Z).
  { intros d'. apply sum_is_not_negative. intros v _. unfold if_tangent.
    destruct (same_place w (fst v)), (in_tangent_set d' (snd v)); discriminate. }
  pose proof (tangents (Direction y label)). pose proof (tangents (Direction (opposite y) label)).
  pose proof (nowhere_negative_everywhere r (proj1 (proj2 r_region)) (plus w (opposite y))).
  unfold total_around in *. lia.
Qed.
