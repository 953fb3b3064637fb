(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Segments that have nothing but ends in common, seen near an end of some: rays. Two rays, the second one the next to
   the left of the first: between them is nothing, so closed chains of some of the segments go round all points there
   equally often. From just beside the first ray one comes to just beside the second in two straight steps. *)
From Coq Require Import QArith Qminmax Lqa Qfield ZArith Lia Bool List.
From Oplus Require Import direction angle angular_crossings winding_number shifted_ray small_numbers signed_crossings
  rotation regions meeting_of_segments interiors_meet first_hit neighbourhoods left_of_an_edge right_of_an_edge
  theorem_4_2_1 location pieces beside_a_piece filling cut_pieces kept_pieces_go_round kept_pieces_balance.
Import ListNotations.

Open Scope Q_scope.

(* Lines on one side of which are both directions have all between them on that side. *)
Lemma in_a_cone (k a b u : vector) : 0 < cross a b -> 0 <= cross a u -> 0 <= cross u b -> nonzero u ->
  0 < cross k a -> 0 < cross k b -> 0 < cross k u.
Proof.
  intros turn after_a before_b long on_a on_b.
  assert (value : cross a b * cross k u == cross u b * cross k a + cross a u * cross k b) by (unfold cross; ring).
  assert (0 <= cross u b * cross k a) by (apply Qmult_le_0_compat; lra).
  assert (0 <= cross a u * cross k b) by (apply Qmult_le_0_compat; lra).
  apply Qnot_le_lt. intros none. assert (cross a b * cross k u <= 0) by nra.
  assert (zero_b : cross u b == 0) by nra. assert (zero_a : cross a u == 0) by nra. apply long.
  assert (x_is : cross a b * vx u == cross u b * vx a + cross a u * vx b) by (unfold cross; ring).
  assert (y_is : cross a b * vy u == cross u b * vy a + cross a u * vy b) by (unfold cross; ring).
  rewrite zero_a, zero_b in x_is, y_is. split; apply (Qmult_inj_l _ _ (cross a b)); lra.
Qed.

(* Met on the way counterclockwise from b to g, if these are not one direction. *)
Definition met_between (b g u : vector) : Prop :=
  (0 < cross b g /\ 0 < cross b u /\ 0 < cross u g) \/ (cross b g <= 0 /\ (0 < cross b u \/ 0 < cross u g)).

Section Vertex.
  Variable segments : list segment.
  Hypothesis long : forall e, In e segments -> nonzero (along e).
  Hypothesis apart : forall e f w, In e segments -> In f segments -> e <> f -> lies_on w f -> ~ strictly_inside w e.
  Hypothesis same_ends : forall e f v w, In e segments -> In f segments ->
    v = source e \/ v = target e -> w = source f \/ w = target f -> equal_vectors v w -> v = w.

  (* A segment, in one of its directions. *)
  Definition directed (s : segment) : Prop := In s segments \/ In (reversed s) segments.

  Lemma directed_is_long (s : segment) : directed s -> nonzero (along s).
  Proof.
    intros [S | S]; [now apply long |]. pose proof (long _ S) as long_. intros [X Y]. apply long_.
    unfold along, minus, reversed in *; cbn [source target vx vy] in *. split; lra.
  Qed.

  Lemma met_by_itself_only (part : list segment) (s : segment) : incl part segments -> directed s -> met_only_along
    part s.
  Proof.
    intros incl_ S w t inside_ T on.
    assert (itself : collinear s s) by (unfold collinear, area, cross, minus; cbn [vx vy]; split; ring).
    assert (back : collinear s (reversed s)) by (unfold collinear, reversed in *; cbn [source target] in *; tauto).
    destruct S as [S | S].
    - destruct (segment_dec s t) as [<- | differ]; [exact itself |].
      exfalso. exact (apart s t w S (incl_ t T) differ on inside_).
    - destruct (segment_dec (reversed s) t) as [<- | differ]; [exact back |].
      exfalso. apply (apart (reversed s) t w S (incl_ t T) differ on). now apply strictly_inside_reversed.
  Qed.

  Variable v : vector.
  Hypothesis v_is_an_end : exists e, In e segments /\ (v = source e \/ v = target e).

  Lemma rays_near : exists radius, 0 < radius /\ forall y e, within radius v y -> In e segments -> lies_on y e ->
    exists s k, directed s /\ source s = v /\ 0 <= k /\ vx y == vx v + k * vx (along s) /\ vy y == vy v + k * vy
      (along s).
  Proof.
    set (as_ray := fun (e : segment) (y : vector) => exists s k, directed s /\ source s = v /\ 0 <= k /\
      vx y == vx v + k * vx (along s) /\ vy y == vy v + k * vy (along s)).
    assert (each : forall e, In e segments -> eventually (fun r => forall y, within r v y -> lies_on y e -> as_ray e
      y)).
    { intros e E. destruct (lies_on_dec v e) as [on | free].
      - exists 1. split; [lra |]. intros r _ _ y _ on_y.
        assert (ends_ : v = source e \/ v = target e).
        { destruct v_is_an_end as (f & F & end_). destruct (segment_dec e f) as [<- | differ]; [exact end_ |].
          assert (on_f : lies_on v f) by (destruct end_ as [-> | ->]; [apply source_lies_on | apply target_lies_on]).
          destruct (on_but_not_inside v e on (apart e f v E F differ on_f)) as [equal | equal];
            [left | right]; symmetry; apply (same_ends e f); trivial; tauto. }
        destruct on_y as (k & range & X & Y). destruct ends_ as [-> | ->].
        + exists e, k. split; [now left |]. split; [reflexivity |]. split; [lra |].
          unfold along, minus. cbn [vx vy]. rewrite X, Y. split; ring.
        + exists (reversed e), (1 - k). split; [right; now rewrite reversed_twice |]. split; [reflexivity |].
          split; [lra |]. unfold along, minus, reversed. cbn [source target vx vy]. rewrite X, Y. split; ring.
      - destruct (off_one_segment_near v e free) as (radius & R & near). exists radius. split; [exact R |].
        intros r _ less y close on_y. exfalso. apply (near y); [| exact on_y]. apply (within_smaller r); trivial. lra. }
    destruct (eventually_for_all (fun e r => forall y, within r v y -> lies_on y e -> as_ray e y) segments each)
      as (limit & L & all). exists ((1 # 2) * limit). split; [lra |]. intros y e close E on.
    apply (all ((1 # 2) * limit) ltac:(lra) ltac:(lra) e E y close on).
  Qed.

  (* Theorem. *)
  Theorem nothing_between (part : list segment) (s1 s2 : segment) : incl part segments -> cycles part ->
    directed s1 -> directed s2 -> target s1 = v -> source s2 = v ->
    (cross (minus (source s1) v) (along s2) == 0 -> dot (minus (source s1) v) (along s2) < 0) ->
    (forall s, directed s -> source s = v -> ~ met_between (minus (source s1) v) (along s2) (along s)) ->
    winding_number_shifted (right_of_middle s1) part = winding_number_shifted (right_of_middle s2) part.
  Proof.
    intros incl_ closed S1 S2 ends_ starts_ no_turn_back empty.
    set (b := minus (source s1) v) in *. set (g := along s2) in *.
    pose proof (directed_is_long s1 S1) as long_1. pose proof (directed_is_long s2 S2) as long_2.
    assert (along_1 : vx (along s1) == - vx b /\ vy (along s1) == - vy b).
    { unfold b, along, minus. cbn [vx vy]. rewrite ends_. split; ring. }
    assert (long_b : 0 < dot b b).
    { assert (dot (along s1) (along s1) == dot b b) as <- by (unfold dot; destruct along_1 as [-> ->]; ring).
      now apply square_positive. }
    assert (long_g : 0 < dot g g) by (now apply square_positive).
    set (p := Vector (- vy b) (vx b)). set (q := Vector (vy g) (- vx g)).
    assert (between_ : exists m, 0 < cross b m /\ 0 < cross m g).
    { destruct (Q_dec (cross b g) 0) as [[less | more] | line].
      - exists (Vector (- (vx b + vx g)) (- (vy b + vy g))). unfold cross in *. cbn [vx vy]. split; lra.
      - exists (Vector (vx b + vx g) (vy b + vy g)). unfold cross in *. cbn [vx vy]. split; lra.
      - exists p. specialize (no_turn_back line). unfold p, cross, dot in *. cbn [vx vy]. split; lra. }
    destruct between_ as (m & after_b & before_g).
    destruct rays_near as (radius & R & near).
    (* two steps in which nothing is met *)
    assert (step : forall c1 c2, within radius v (moved_along v c1 1) -> within radius v (moved_along v c2 1) ->
      0 < cross c1 c2 ->
      (forall u, nonzero u -> 0 <= cross c1 u -> 0 <= cross u c2 -> met_between b g u) ->
      winding_number (moved_along v c1 1) part = winding_number (moved_along v c2 1) part).
    { intros c1 c2 close_1 close_2 turn all_between.
      apply (winding_number_along (Segment (moved_along v c1 1) (moved_along v c2 1)) part closed).
      intros w on e E on_e. destruct (near w e (within_along _ _ _ _ _ close_1 close_2 on) (incl_ e E) on_e)
        as (s & k & S & is_v & not_negative & X & Y).
      destruct on as (h & range & wx & wy). unfold moved_along in wx, wy. cbn [source target vx vy] in wx, wy.
      assert (ux : k * vx (along s) == (1 - h) * vx c1 + h * vx c2) by lra.
      assert (uy : k * vy (along s) == (1 - h) * vy c1 + h * vy c2) by lra.
      assert (one : k * cross c1 (along s) == h * cross c1 c2).
      { setoid_replace (k * cross c1 (along s)) with (vx c1 * (k * vy (along s)) - vy c1 * (k * vx (along s)))
          by (unfold cross; ring). rewrite ux, uy. unfold cross. ring. }
      assert (two : k * cross (along s) c2 == (1 - h) * cross c1 c2).
      { setoid_replace (k * cross (along s) c2) with ((k * vx (along s)) * vy c2 - (k * vy (along s)) * vx c2)
          by (unfold cross; ring). rewrite ux, uy. unfold cross. ring. }
      assert (some : 0 < k).
      { apply Qnot_le_lt. intros none. assert (k_is : k == 0) by lra.
        assert (h * cross c1 c2 + (1 - h) * cross c1 c2 == 0) by (rewrite <- one, <- two, k_is; ring). lra. }
      apply (empty s S is_v), all_between; [now apply directed_is_long | nra | nra]. }
    assert (steps : eventually (fun t => within ((1 # 2) * radius) v (moved_along v b t) /\
      within ((1 # 2) * radius) v (moved_along v g t) /\ within radius v (moved_along v m t) /\ t < 1)).
    { assert (half : 0 < (1 # 2) * radius) by lra.
      refine (eventually_and _ _ (small_steps_stay_within _ v b half) (eventually_and _ _ (small_steps_stay_within _
        v g half)
        (eventually_and _ _ (small_steps_stay_within _ v m R) (ex_intro _ 1 (conj (ltac:(lra) : 0 < 1) (fun t _ less
          => less)))))). }
    destruct steps as (limit & L & all). set (t := (1 # 2) * limit) in *. assert (T : 0 < t) by (unfold t; lra).
    destruct (all t) as (close_b & close_g & close_m & less); [lra | unfold t; lra |]. clearbody t. clear all L limit.
    set (w1 := moved_along v b t) in *. set (w2 := moved_along v g t) in *.
    assert (inside_1 : strictly_inside w1 s1).
    { exists (1 - t). split; [lra |]. unfold w1, moved_along, b, minus. cbn [vx vy]. rewrite ends_. split; ring. }
    assert (inside_2 : strictly_inside w2 s2).
    { exists t. split; [lra |]. unfold w2, moved_along, g, along, minus. cbn [vx vy]. rewrite starts_. split; ring. }
    assert (right_1 : cross (along s1) p < 0).
    { unfold cross, p. cbn [vx vy]. destruct along_1 as [-> ->]. unfold dot in long_b. lra. }
    assert (right_2 : cross g q < 0) by (unfold cross, q; cbn [vx vy]; unfold dot in long_g; lra).
    pose proof (to_the_right_of_a_piece part s1 closed (met_by_itself_only part s1 incl_ S1) long_1 w1 p inside_1
      right_1)
      as number_1.
    pose proof (to_the_right_of_a_piece part s2 closed (met_by_itself_only part s2 incl_ S2) long_2 w2 q inside_2
      right_2)
      as number_2.
    assert (positive_ : forall x y : Q, 0 < x -> eventually (fun d => 0 < t * x + d * y)).
    { intros x y some. apply eventually_positive. apply Qmult_lt_0_compat; lra. }
    assert (ahead : eventually (fun d => 0 < cross b g -> 0 < t * cross b g + d * cross p g /\ 0 < t * cross b g + d
      * cross b q)).
    { destruct (Qlt_le_dec 0 (cross b g)) as [some | none]; [| exists 1; split; [lra | intros; lra]].
      refine (eventually_implied _ _ _ (eventually_and _ _ (positive_ _ (cross p g) some) (positive_ _ (cross b q)
        some))).
      tauto. }
    destruct (eventually_and _ _ (eventually_and _ _ number_1 number_2) (eventually_and _ _ ahead
      (eventually_and _ _ (eventually_and _ _ (positive_ _ (cross p m) after_b) (positive_ _ (cross m q) before_g))
        (eventually_and _ _ (small_steps_stay_within ((1 # 2) * radius) w1 p ltac:(lra))
          (small_steps_stay_within ((1 # 2) * radius) w2 q ltac:(lra)))))) as (limit & L & all).
    destruct (all ((1 # 2) * limit)) as ((is_1 & is_2) & ahead_ & (turn_1 & turn_2) & close_1 & close_2); [lra | lra |].
    set (d := (1 # 2) * limit) in *. assert (D : 0 < d) by (unfold d; lra). clearbody d. clear all ahead positive_ L
      limit.
    set (c1 := Vector (t * vx b + d * vx p) (t * vy b + d * vy p)).
    set (c2 := Vector (t * vx g + d * vx q) (t * vy g + d * vy q)).
    set (cm := Vector (t * vx m) (t * vy m)).
    assert (as_is : forall x y : vector, equal_vectors x y -> winding_number x part = winding_number y part)
      by (intros x y [X Y]; now apply winding_number_of_equal).
    assert (equal_1 : equal_vectors (moved_along w1 p d) (moved_along v c1 1))
      by (unfold c1, w1, moved_along; split; cbn [vx vy]; ring).
    assert (equal_2 : equal_vectors (moved_along w2 q d) (moved_along v c2 1))
      by (unfold c2, w2, moved_along; split; cbn [vx vy]; ring).
    assert (equal_m : equal_vectors (moved_along v m t) (moved_along v cm 1))
      by (unfold cm, moved_along; split; cbn [vx vy]; ring).
    assert (within_equal : forall x y : vector, equal_vectors x y -> within radius v x -> within radius v y)
      by (unfold within, equal_vectors; intros; lra).
    pose proof (within_equal _ _ equal_m close_m) as close_cm.
    assert (close_c1 : within radius v (moved_along v c1 1))
      by (apply (within_equal _ _ equal_1); apply (within_twice ((1 # 2) * radius) ((1 # 2) * radius) _ v w1);
        trivial; lra).
    assert (close_c2 : within radius v (moved_along v c2 1))
      by (apply (within_equal _ _ equal_2); apply (within_twice ((1 # 2) * radius) ((1 # 2) * radius) _ v w2);
        trivial; lra).
    assert (b_c1 : 0 < cross b c1).
    { assert (cross b c1 == d * dot b b) as -> by (unfold c1, p, cross, dot; cbn [vx vy]; ring).
      now apply Qmult_lt_0_compat. }
    assert (c2_g : 0 < cross c2 g).
    { assert (cross c2 g == d * dot g g) as -> by (unfold c2, q, cross, dot; cbn [vx vy]; ring).
      now apply Qmult_lt_0_compat. }
    assert (b_cm : 0 < cross b cm).
    { assert (cross b cm == t * cross b m) as -> by (unfold cm, cross; cbn [vx vy]; ring). apply Qmult_lt_0_compat;
      lra. }
    assert (cm_g : 0 < cross cm g).
    { assert (cross cm g == t * cross m g) as -> by (unfold cm, cross; cbn [vx vy]; ring). apply Qmult_lt_0_compat;
      lra. }
    assert (c1_cm : 0 < cross c1 cm).
    { assert (cross c1 cm == t * (t * cross b m + d * cross p m)) as -> by (unfold c1, cm, cross; cbn [vx vy]; ring).
      apply Qmult_lt_0_compat; lra. }
    assert (cm_c2 : 0 < cross cm c2).
    { assert (cross cm c2 == t * (t * cross m g + d * cross m q)) as -> by (unfold c2, cm, cross; cbn [vx vy]; ring).
      apply Qmult_lt_0_compat; lra. }
    assert (flip : forall x y : vector, cross (Vector (- vx y) (- vy y)) x == cross x y)
      by (intros; unfold cross; cbn [vx vy]; ring).
    assert (c1_g : 0 < cross b g -> 0 < cross c1 g).
    { intros some. destruct (ahead_ some). assert (cross c1 g == t * cross b g + d * cross p g) as -> ;
        [unfold c1, cross; cbn [vx vy]; ring | lra]. }
    assert (b_c2 : 0 < cross b g -> 0 < cross b c2).
    { intros some. destruct (ahead_ some). assert (cross b c2 == t * cross b g + d * cross b q) as -> ;
        [unfold c2, cross; cbn [vx vy]; ring | lra]. }
    rewrite <- is_1, <- is_2, (as_is _ _ equal_1), (as_is _ _ equal_2).
    transitivity (winding_number (moved_along v cm 1) part); apply step; trivial; intros u u_long after_ before_.
    - pose proof (in_a_cone b c1 cm u c1_cm after_ before_ u_long b_c1 b_cm) as one.
      destruct (Qlt_le_dec 0 (cross b g)) as [some | none]; [left | right; tauto]. split; [exact some |].
      split; [exact one |]. rewrite <- flip. apply (in_a_cone _ c1 cm); trivial; rewrite flip; auto.
    - assert (two : 0 < cross u g).
      { rewrite <- flip. apply (in_a_cone _ cm c2); trivial; rewrite flip; auto. }
      destruct (Qlt_le_dec 0 (cross b g)) as [some | none]; [left | right; tauto]. split; [exact some |].
      split; [| exact two]. apply (in_a_cone _ cm c2); auto.
  Qed.
End Vertex.
