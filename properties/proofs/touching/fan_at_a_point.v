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
  off (plus w a) (region_edges r) /\
  forall s, In s (region_edges r) -> lies_on w s ->
    ~ same_direction (along s) (opposite a) /\ (departs w s = true -> ~ cross a (along s) == 0).

Section AtThePoint.
  Variable r : region.
  Variable w : vector.
  Variable label : summand.
  Variable radius : Q.
  Hypothesis not_points : no_edges_are_points r.
  Hypothesis near : nothing_else_near w radius r.

  (* Theorem. The sum of the three numbers is the same in all directions. *)
  Theorem same_in_all_directions (a b da db : vector) : 0 < cross a b ->
    within radius w (plus w a) -> within radius w (plus w b) -> clear_direction w a r -> clear_direction w b r ->
    nonzero da -> nonzero db -> same_direction da (opposite a) -> same_direction db (opposite b) ->
    (tangents_at w (Direction da label) r + departures_left_of w a r + winding_number (plus w a) (region_edges r) =
     tangents_at w (Direction db label) r + departures_left_of w b r + winding_number (plus w b) (region_edges r))%Z.
  Proof.
    intros turn near_a near_b [off_a clear_a] [off_b clear_b] proper_da proper_db a_back b_back.
    pose proof (winding_number_around_the_point r w a b radius not_points near turn near_a near_b off_a off_b)
      as numbers.
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
        sum_of (fun s => (Z.b2z (arrives w s) - Z.b2z (departs w s)) * wraps da db)%Z (region_edges r))%Z) by lia.
    unfold departures_left_of. rewrite <- sum_plus, <- !sum_minus. apply sum_equally. intros s I.
    destruct (lies_on_dec w s) as [on | free].
    2: { unfold departs, arrives, comes_by. destruct (lies_on_dec w s); [contradiction | reflexivity]. }
    destruct (clear_a s I on) as [differ_a aside_a], (clear_b s I on) as [differ_b aside_b].
    pose proof (region_edges_are_directions r not_points s I) as long.
    assert (proper : forall v, 0 < cross v b \/ 0 < cross a v -> nonzero (opposite v)).
    { intros v some. apply opposite_nonzero. intros [X Y]. unfold cross in some. rewrite X, Y in some. lra. }
    assert (angles : forall d v, nonzero d -> nonzero (opposite v) -> same_direction d (opposite v) ->
      ~ same_direction (along s) (opposite v) -> angle d == angle (opposite v) /\ ~ angle (along s) == angle d).
    { intros d v proper_d proper_v same_ differ. rewrite same_direction_angle in same_, differ by trivial. lra. }
    destruct (angles da a) as [angle_a apart_a]; auto. destruct (angles db b) as [angle_b apart_b]; auto.
    pose proof (edges_while_turning a b da db label turn angle_a angle_b proper_da proper_db (along s) long apart_a
      apart_b) as turned_.
    destruct (departs w s) eqn:departing_.
    - pose proof (departing_while_turning a b (along s) (aside_a eq_refl) (aside_b eq_refl)) as left_.
      destruct (arrives w s); cbn [Z.b2z]; lia.
    - destruct (arrives w s); cbn [Z.b2z]; lia.
  Qed.

  (* A direction that is parallel to no edge at w. *)
  Lemma general_directions_are_clear (y : vector) : within radius w (plus w y) ->
    (forall s, In s (region_edges r) -> lies_on w s -> ~ cross y (along s) == 0) -> clear_direction w y r.
  Proof.
    intros close general. split.
    - intros s I on. destruct near as [_ near_]. destruct (near_ s) as [on_w | free].
      + apply in_flat_map. exists s. split; [exact I | now left].
      + destruct (ahead_or_behind w y s on_w on) as (m & X & Y & _). apply (general s I on_w).
        unfold cross. rewrite X, Y. ring.
      + exact (free _ close on).
    - intros s I on. pose proof (general s I on) as aside. split; [| intros _; exact aside].
      intros (m & _ & X & Y). apply aside. unfold cross, opposite in *; cbn [vx vy] in *. rewrite X, Y. ring.
  Qed.
End AtThePoint.

(* Near w is a point inside that is on none of some lines. *)
Lemma inner_point_off_lines (r : region) (w : vector) (radius : Q) (lines : list segment) :
  is_regular r -> in_region w r -> 0 < radius -> (forall t, In t lines -> nonzero (along t)) ->
  exists y, within radius w y /\ inside y r /\ forall t, In t lines -> ~ area t y == 0.
Proof.
  intros regular in_r R long. assert (half : 0 < (1 # 2) * radius) by lra.
  destruct (inside_near r w _ regular in_r half) as (a & close & free & round).
  assert (off_line : forall t, In t lines -> eventually (fun e => ~ area t (moved (shifted a) e) == 0)).
  { intros t I. refine (eventually_implied _ _ _ (side_of_segment_nearby a t (long t I))).
    intros e [_ off_line] on_line. apply off_line. rewrite orientation_by_area. destruct t.
    now apply (proj1 (Qeq_alt _ _)). }
  destruct (eventually_and _ _ (shifted_stays_within _ a half) (eventually_and _ _
    (same_beside a (region_edges r)) (eventually_and _ _
    (eventually_for_all _ (region_edges r) (fun s _ => shifted_off a s))
    (eventually_for_all _ lines off_line)))) as (limit & L & all).
  destruct (all ((1 # 2) * limit)) as (near_a & same_number & off_r & off_lines); [lra | lra |].
  exists (moved (shifted a) ((1 # 2) * limit)). split; [| split; [split; [exact off_r | lia] | exact off_lines]].
  apply (within_twice ((1 # 2) * radius) ((1 # 2) * radius) radius w a); [lra | exact close | exact near_a].
Qed.

(* Near w, w + y is inside in a direction y that is parallel to no edge at w, nor to z. *)
Lemma inner_direction (r : region) (w z : vector) (radius : Q) : valid_region r -> 0 < radius -> nonzero z ->
  (exists s, In s (region_edges r) /\ lies_on w s) ->
  exists y, within radius w (plus w y) /\ within radius w (plus w (opposite y)) /\ ~ cross z y == 0 /\
    (forall s, In s (region_edges r) -> lies_on w s -> ~ cross y (along s) == 0) /\
    (0 < winding_number (plus w y) (region_edges r))%Z.
Proof.
  intros (not_points & valid & meet) R proper_z on_boundary.
  destruct (inner_point_off_lines r w radius (Segment w (plus w z) :: region_edges r)
    (regions_are_regular r not_points valid meet) (or_intror on_boundary) R) as (p & close & [_ round] & general).
  { intros t [<- | I]; [| now apply (region_edges_are_directions r)].
    intros [X Y]. apply proper_z. unfold along, plus, minus in X, Y; cbn [source target vx vy] in X, Y. lra. }
  set (y := minus p w). exists y.
  split; [unfold within, y, plus, minus in *; cbn [vx vy]; lra |].
  split; [unfold within, y, plus, opposite, minus in *; cbn [vx vy]; lra |].
  split; [| split].
  - intros aside. apply (general _ (or_introl eq_refl)). transitivity (cross z y); [| exact aside].
    unfold area, cross, y, plus, minus; cbn [source target vx vy]. ring.
  - intros s I (k & _ & X & Y) parallel. apply (general s (or_intror I)). transitivity (- cross y (along s)); [| lra].
    unfold area, cross, y, along, minus; cbn [vx vy]. rewrite X, Y. ring.
  - rewrite <- (winding_number_of_equal p (plus w y)); [exact round | unfold y, plus, minus; cbn [vx vy]; ring ..].
Qed.

Section OneDirection.
  Variable r : region.
  Variables w z d : vector.
  Variable label : summand.
  Variable radius : Q.
  Hypothesis r_region : valid_region r.
  Hypothesis near : nothing_else_near w radius r.
  Hypothesis near_z : within radius w (plus w z).
  Hypothesis clear_z : clear_direction w z r.
  Hypothesis nothing_there : winding_number (plus w z) (region_edges r) = 0%Z.
  Hypothesis proper_d : nonzero d.
  Hypothesis z_back : same_direction d (opposite z).
  Hypothesis no_tangent : tangents_at w (Direction d label) r = 0%Z.

  Let not_points : no_edges_are_points r := proj1 r_region.

  (* The sum is the same in a direction y and in the opposite one: one of them is inside. *)
  Lemma half_by_a_general_direction (y : vector) : 0 < cross z y ->
    within radius w (plus w y) -> within radius w (plus w (opposite y)) ->
    (forall s, In s (region_edges r) -> lies_on w s -> ~ cross y (along s) == 0) ->
    (0 < winding_number (plus w y) (region_edges r) \/
     0 < winding_number (plus w (opposite y)) (region_edges r))%Z ->
    (departures w r < 2 * departures_left_of w z r)%Z.
  Proof.
    intros turn near_y near_back general round.
    assert (proper_y : nonzero y) by (intros [X Y]; unfold cross in turn; rewrite X, Y in turn; lra).
    assert (back : forall v, cross (opposite y) v == - cross y v)
      by (intros; unfold cross, opposite; cbn [vx vy]; ring).
    assert (turn_back : 0 < cross (opposite y) z) by (rewrite back; unfold cross in *; lra).
    assert (itself : forall v, same_direction v v) by (intros v; exists 1; split; [lra | split; ring]).
    pose proof (general_directions_are_clear r w radius near y near_y general) as clear_y.
    assert (clear_back : clear_direction w (opposite y) r).
    { apply (general_directions_are_clear r w radius); trivial. intros s I on. rewrite back.
      pose proof (general s I on). lra. }
    pose proof (same_in_all_directions r w label radius not_points near z y d (opposite y) turn near_z near_y
      clear_z clear_y proper_d (opposite_nonzero y proper_y) z_back (itself _)) as ahead.
    assert (y_back : same_direction y (opposite (opposite y))) by (rewrite opposite_twice; apply itself).
    pose proof (same_in_all_directions r w label radius not_points near (opposite y) z y d turn_back near_back near_z
      clear_back clear_z proper_y proper_d y_back z_back) as behind.
    assert (both_sides : (departures_left_of w y r + departures_left_of w (opposite y) r = departures w r)%Z).
    { unfold departures_left_of, departures. rewrite <- sum_plus. apply sum_equally. intros s I.
      destruct (departs w s) eqn:departing_; cbn [Z.b2z]; [| lia]. apply departs_is in departing_.
      pose proof (general s I (proj1 departing_)) as aside. pose proof (back (along s)).
      destruct (positive_spec (cross y (along s))), (positive_spec (cross (opposite y) (along s)));
        cbn [Z.b2z]; try lia; exfalso; lra. }
    assert (tangents : forall d', (0 <= tangents_at w d' r)%Z).
    { intros d'. apply sum_is_not_negative. intros v _. unfold if_tangent.
      destruct (same_place w (fst v)), (in_tangent_set d' (snd v)); cbn [Z.b2z]; lia. }
    pose proof (tangents (Direction y label)). pose proof (tangents (Direction (opposite y) label)).
    pose proof (nowhere_negative_everywhere r (proj1 (proj2 r_region))) as not_negative.
    pose proof (not_negative (plus w y)). pose proof (not_negative (plus w (opposite y))). lia.
  Qed.

  (* Theorem. So more than half of the edges that leave w do so to the left of z. *)
  Theorem more_than_half_depart_to_the_left : (exists s, In s (region_edges r) /\ lies_on w s) ->
    (departures w r < 2 * departures_left_of w z r)%Z.
  Proof.
    intros on_boundary.
    assert (proper_z : nonzero z).
    { intros [X Y]. apply proper_d. destruct z_back as (m & _ & dx & dy). rewrite dx, dy. unfold opposite; cbn [vx vy].
      rewrite X, Y. split; ring. }
    destruct (inner_direction r w z radius r_region (proj1 near) proper_z on_boundary)
      as (y & near_y & near_back & aside & general & round).
    destruct (Q_dec (cross z y) 0) as [[right_ | left_] | parallel]; [| | contradiction].
    - apply (half_by_a_general_direction (opposite y)); try rewrite opposite_twice; try tauto.
      + unfold cross, opposite in *; cbn [vx vy]. lra.
      + intros s I on parallel. apply (general s I on). unfold cross, opposite in *; cbn [vx vy] in *. lra.
    - apply (half_by_a_general_direction y); tauto.
  Qed.
End OneDirection.
