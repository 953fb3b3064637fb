(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Weakly simple chains that do not cross themselves turn once: with their corners cut they are simple
   (simple_when_cut.v), so these turn once (Hopf); and to cut a corner does not change how the chain turns. Such a chain
   may pass a point often, and touch its edges; it may have vertices in straight lines. *)
From Coq Require Import ZArith Lia Bool List.
From Oplus Require Import numbers convolution small_numbers neighbourhoods regions meeting_of_segments secants
  segments_apart simple_chain simple_chains_turn_once strictly_convex_curve direction_between
  chords_around_a_point small_moves cut_corners simple_when_cut.
Import ListNotations.

Open Scope Q_scope.

Lemma different_points_apart (v w : vector) : ~ equal_vectors v w ->
  exists radius, 0 < radius /\ forall x, within radius v x -> within radius w x -> False.
Proof.
  intros differ. unfold within.
  destruct (Q_dec (vx v) (vx w)) as [[less | more] | x_same].
  - exists ((1 # 2) * (vx w - vx v)). split; [lra |]. intros x. lra.
  - exists ((1 # 2) * (vx v - vx w)). split; [lra |]. intros x. lra.
  - destruct (Q_dec (vy v) (vy w)) as [[less | more] | y_same].
    + exists ((1 # 2) * (vy w - vy v)). split; [lra |]. intros x. lra.
    + exists ((1 # 2) * (vy v - vy w)). split; [lra |]. intros x. lra.
    + destruct differ. now split.
Qed.

Lemma apart_by_points (a b c f : vector) : nonzero (minus b a) ->
  (forall x, lies_on x (Segment a b) -> ~ lies_on x (Segment c f)) -> apart a b c f.
Proof.
  intros long none. destruct (are_apart_decides a b c f long) as [[found | (x & on & on')] _].
  - now apply are_apart_sound.
  - destruct (none x on on').
Qed.

Section Touching.
  Variable chain : list vector.
  Let n := length chain.
  Hypothesis long_enough : (2 <= n)%nat.
  Hypothesis turn : turns_everywhere chain.
  Hypothesis disjoint : edges_are_interior_disjoint chain.
  Hypothesis one_side : vertices_touch_from_one_side chain.
  Hypothesis crossing_free : vertices_do_not_cross chain.

  (* Chords are near their vertices. *)
  Lemma chords_are_near (i : nat) (radius : Q) : 0 < radius ->
    eventually (fun e => forall x, lies_on x (cut_chord chain e i) -> within radius (vertex chain i) x).
  Proof.
    intros R. refine (eventually_implied _ _ _ (eventually_and _ _
      (small_steps_stay_within radius (vertex chain i) (on_curve (ray_back chain i)) R)
      (small_steps_stay_within radius (vertex chain i) (on_curve (ray_out chain i)) R))).
    intros e [back_ out_] x on. exact (within_along radius (vertex chain i) _ _ x back_ out_ on).
  Qed.

  Definition far_is_apart (e : Q) : Prop := forall i j x, (i < n)%nat -> (j < n)%nat ->
    lies_on x (cut_chord chain e i) ->
    (~ equal_vectors (vertex chain i) (vertex chain j) -> ~ lies_on x (cut_chord chain e j)) /\
    (~ lies_on (vertex chain i) (edge_at chain j) -> ~ lies_on x (edge_at chain j)).

  Lemma eventually_far_is_apart : eventually far_is_apart.
  Proof.
    assert (each : forall i, In i (seq 0 n) -> eventually (fun e => forall j, In j (seq 0 n) -> forall x,
      lies_on x (cut_chord chain e i) ->
      (~ equal_vectors (vertex chain i) (vertex chain j) -> ~ lies_on x (cut_chord chain e j)) /\
      (~ lies_on (vertex chain i) (edge_at chain j) -> ~ lies_on x (edge_at chain j)))).
    { intros i _. apply eventually_for_all. intros j _.
      assert (chords : eventually (fun e => ~ equal_vectors (vertex chain i) (vertex chain j) -> forall x,
        lies_on x (cut_chord chain e i) -> ~ lies_on x (cut_chord chain e j))).
      { destruct (Qeq_dec (vx (vertex chain i)) (vx (vertex chain j))) as [X |];
          [destruct (Qeq_dec (vy (vertex chain i)) (vy (vertex chain j))) as [Y |] |];
          [exists 1; split; [lra |]; intros e _ _ differ; destruct differ; now split | |];
          (destruct (different_points_apart (vertex chain i) (vertex chain j)) as (radius & R & far);
            [unfold equal_vectors; tauto |];
           refine (eventually_implied _ _ _ (eventually_and _ _ (chords_are_near i radius R) (chords_are_near j radius
             R)));
           intros e [near_i near_j] _ x on on_j; exact (far x (near_i x on) (near_j x on_j))). }
      assert (edges_ : eventually (fun e => ~ lies_on (vertex chain i) (edge_at chain j) -> forall x,
        lies_on x (cut_chord chain e i) -> ~ lies_on x (edge_at chain j))).
      { destruct (lies_on_dec (vertex chain i) (edge_at chain j)) as [on | free].
        - exists 1. split; [lra |]. intros e _ _ no. contradiction.
        - destruct (off_one_segment_near _ _ free) as (radius & R & far).
          refine (eventually_implied _ _ _ (chords_are_near i radius R)). intros e near_i _ x on.
          exact (far x (near_i x on)). }
      refine (eventually_implied _ _ _ (eventually_and _ _ chords edges_)). intros e [a b] x on.
      split; intros no; eauto. }
    refine (eventually_implied _ _ _ (eventually_for_all _ _ each)). intros e all i j x I J.
    apply all; apply in_seq; lia.
  Qed.

  Section SmallEnough.
    Variable e : Q.
    Hypothesis small : is_small chain e.
    Hypothesis far : far_is_apart e.

    Let cut := with_cut_corners chain e.

    Lemma cut_edges (i : nat) : (i < n)%nat ->
      (vertex cut (2 * i) = before_corner chain e i /\
       vertex cut (next (2 * i) (2 * n)) = after_corner chain e i) /\
      (vertex cut (2 * i + 1) = after_corner chain e i /\
       vertex cut (next (2 * i + 1) (2 * n)) = before_corner chain e (next i n)).
    Proof.
      intros I. destruct (next_of_two n i I) as [-> ->]. destruct (cut_vertices chain e i I) as [before_ after_].
      destruct (cut_vertices chain e (next i n) (next_in_range i n I)) as [before_next _]. now repeat split.
    Qed.

    (* The directions at the two corners that replace one. *)
    Lemma cut_corner_turns (i : nat) : (i < n)%nat ->
      turns (minus (before_corner chain e (next (previous n i) n)) (after_corner chain e (previous n i)))
            (minus (after_corner chain e i) (before_corner chain e i)) /\
      turns (minus (after_corner chain e i) (before_corner chain e i))
            (minus (before_corner chain e (next i n)) (after_corner chain e i)).
    Proof.
      intros I. pose proof (previous_below n i I) as J.
      destruct (short_edge_direction chain e (previous n i) small J) as (j & J' & before_is).
      destruct (short_edge_direction chain e i small I) as (j' & J'' & after_is).
      destruct (chord_direction chain turn e i (proj1 small) I) as (k & l & K & L & chord_is).
      pose proof (turns_at_a_corner chain turn i I) as corner_. fold n in before_is, after_is, chord_is, corner_.
      split; (eapply turns_respects; [eassumption | eassumption |]); now apply turns_between.
    Qed.

    (* Theorem. The cut chain is simple. *)
    Theorem simple_with_cut_corners : simple cut.
    Proof.
      assert (size : length cut = (2 * n)%nat) by apply cut_length.
      apply simple_by_turns; rewrite size; [lia | |].
      - intros j J. destruct (one_of_two n j J) as (i & I & [-> | ->]).
        + destruct (cut_edges i I) as [[-> ->] _]. destruct (next_of_two n i I) as [-> _].
          destruct (cut_edges i I) as [_ [_ ->]]. now apply cut_corner_turns.
        + destruct (cut_edges i I) as [_ [-> ->]]. destruct (next_of_two n i I) as [_ ->].
          pose proof (next_in_range i n I) as I'. destruct (cut_edges (next i n) I') as [[_ ->] _].
          pose proof (cut_corner_turns (next i n) I') as [into _]. now rewrite previous_next in into by exact I.
      - assert (chord_long : forall i, (i < n)%nat -> nonzero (minus (after_corner chain e i) (before_corner chain e
          i)))
          by (intros i I; destruct (cut_corner_turns i I) as [_ [some _]]; exact some).
        assert (short_long : forall i, (i < n)%nat ->
          nonzero (minus (before_corner chain e (next i n)) (after_corner chain e i)))
          by (intros i I; destruct (cut_corner_turns i I) as [_ (_ & some & _)]; exact some).
        assert (inside_edges : forall i x, (i < n)%nat ->
          lies_on x (Segment (after_corner chain e i) (before_corner chain e (next i n))) ->
          strictly_inside x (edge_at chain i)) by (intros i x I on; now apply (short_edges chain turn e i x small I)).
        assert (chord_short : forall i k x, (i < n)%nat -> (k < n)%nat -> i <> k -> i <> next k n ->
          lies_on x (cut_chord chain e i) ->
          ~ lies_on x (Segment (after_corner chain e k) (before_corner chain e (next k n)))).
        { intros i k x I K not_k not_next on. destruct (lies_on_dec (vertex chain i) (edge_at chain k)) as [at_edge |
            free].
          - now apply (chord_and_short_edge chain turn disjoint one_side e i k x).
          - intros on_short. destruct (far i k x I K on) as [_ no]. apply (no free).
            apply strictly_inside_lies_on, inside_edges; assumption. }
        assert (flipped : forall a b c f, apart a b c f -> apart c f a b).
        { intros a b c f (w & ca & cb & fa & fb). exists (opposite w).
          unfold in_front, dot, minus, opposite in *. cbn [vx vy] in *. lra. }
        intros a b less B not_next not_before.
        destruct (one_of_two n a ltac:(lia)) as (i & I & a_is), (one_of_two n b B) as (k & K & b_is).
        destruct (cut_edges i I) as [[ci ci'] [si si']], (cut_edges k K) as [[ck ck'] [sk sk']].
        destruct (next_of_two n i I) as [ni ni'], (next_of_two n k K) as [nk nk'].
        destruct a_is as [-> | ->], b_is as [-> | ->]; rewrite ?ci, ?ci', ?si, ?si', ?ck, ?ck', ?sk, ?sk'.
        + apply apart_by_points; [now apply chord_long |]. intros x on on_k. assert (differ : i <> k) by lia.
          destruct (far i k x I K on) as [no _].
          destruct (Qeq_dec (vx (vertex chain i)) (vx (vertex chain k))) as [X |]; [| apply no; trivial; intros [];
            tauto].
          destruct (Qeq_dec (vy (vertex chain i)) (vy (vertex chain k))) as [Y |]; [| apply no; trivial; intros [];
            tauto].
          exact (chords_at_one_point chain turn disjoint crossing_free e i k x (proj1 small) I K differ (conj X Y) on
            on_k).
        + rewrite ni in not_next. rewrite nk' in not_before. apply apart_by_points; [now apply chord_long |].
          intros x on. apply (chord_short i k x I K); [lia | lia | exact on].
        + rewrite ni' in not_next. rewrite nk in not_before. apply flipped, apart_by_points; [now apply chord_long |].
          intros x on. apply (chord_short k i x K I); [lia | lia | exact on].
        + apply apart_by_points; [now apply short_long |]. intros x on on_k.
          apply (disjoint i k x I K ltac:(lia)). split; now apply inside_edges.
    Qed.

    (* Theorem. It turns as the chain does. *)
    Theorem cut_corners_turn_equally : turning_number cut = turning_number chain.
    Proof.
      assert (size : length cut = (2 * n)%nat) by apply cut_length.
      destruct (direction_parallel_to_none (edge_directions chain)) as (d & some & across).
      { intros u U. exact (turning_chains_have_edges chain turn u U). }
      assert (beside_ : forall i, (i < n)%nat -> ~ cross d (edge_of_chain chain i) == 0).
      { intros i I. apply across. unfold edge_of_chain. apply nth_In. now rewrite edges_length. }
      pose proof (simple_chain_turns_everywhere cut simple_with_cut_corners) as cut_turn.
      rewrite <- (turns_past_every_direction cut (Direction d OfP) cut_turn some).
      rewrite <- (turns_past_every_direction chain (Direction d OfP) turn some). unfold turns_past.
      rewrite !corners_by_index, !map_map, size, sum_of_twos. fold n. f_equal. apply map_ext_in. intros i I.
      apply in_seq in I. destruct I as [_ I]. cbn [Nat.add] in I.
      rewrite !corner_is by (rewrite ?size; fold n; lia). cbn [incoming outgoing]. rewrite size. fold n.
      destruct (previous_of_two n i I) as [-> ->]. pose proof (previous_below n i I) as J.
      rewrite !edge_of_chain_joins_vertices by (rewrite ?size; fold n; lia). rewrite size. fold n.
      destruct (cut_edges i I) as [[-> ->] [-> ->]], (cut_edges (previous n i) J) as [_ [-> ->]].
      rewrite <- !edge_of_chain_joins_vertices by (fold n; lia).
      destruct (short_edge_direction chain e (previous n i) small J) as (j & J' & before_is).
      destruct (short_edge_direction chain e i small I) as (j' & J'' & after_is).
      destruct (chord_direction chain turn e i (proj1 small) I) as (k & l & K & L & chord_is).
      pose proof (turns_at_a_corner chain turn i I) as corner_. fold n in before_is, after_is, chord_is, corner_.
      destruct (cut_corner_turns i I) as [(some_before & some_chord & _) (_ & some_after & _)].
      assert (stretch : forall u w u', (exists c, 0 < c /\ equal_vectors u (stretched c u')) -> nonzero u ->
        nonzero u' ->
        nonzero w -> sweep (Direction d OfP) u w = sweep (Direction d OfP) u' w /\
                     sweep (Direction d OfP) w u = sweep (Direction d OfP) w u').
      { intros u w u' (c & C & X & Y) some_u some_u' some_w. rewrite !sweep_by_sides by assumption.
        unfold stretched in X, Y. cbn [vx vy] in X, Y.
        assert (side_is : left_of_ray OfP d u = left_of_ray OfP d u').
        { unfold left_of_ray. f_equal. assert (scale : cross d u == c * cross d u') by (unfold cross; rewrite X, Y;
            ring).
          destruct (negative_spec (cross d u)), (negative_spec (cross d u')); trivial; exfalso; nra. }
        assert (sign : forall p q, p == c * q -> (p ?= 0) = (q ?= 0)).
        { intros p q p_is. compared_numbers (p ?= 0); compared_numbers (q ?= 0); trivial; exfalso; nra. }
        rewrite side_is, (sign (cross u w) (cross u' w)), (sign (cross w u) (cross w u')); [now split | |];
          unfold cross; rewrite X, Y; ring. }
      destruct corner_ as (some_in & some_out & forwards).
      set (w := minus (after_corner chain e i) (before_corner chain e i)) in *.
      rewrite (proj1 (stretch _ w _ (ex_intro _ j (conj J' before_is)) some_before some_in some_chord)).
      rewrite (proj2 (stretch _ w _ (ex_intro _ j' (conj J'' after_is)) some_after some_out some_chord)).
      apply (sweep_over_a_direction_between d _ _ w OfP k l); trivial; [now repeat split | now apply beside_ ..].
    Qed.
  End SmallEnough.

  (* Theorem. So small cuts make the chain simple, and leave its turning number. *)
  Theorem small_cuts_make_it_simple : eventually (fun e =>
    simple (with_cut_corners chain e) /\ turning_number (with_cut_corners chain e) = turning_number chain).
  Proof.
    refine (eventually_implied _ _ _ (eventually_and _ _ (eventually_small chain) eventually_far_is_apart)).
    intros e [small far]. split; [now apply simple_with_cut_corners | now apply cut_corners_turn_equally].
  Qed.

  (* Theorem. A weakly simple chain that does not cross itself turns once. *)
  Theorem touching_chain_turns_once : turning_number chain = 1%Z \/ turning_number chain = (-1)%Z.
  Proof.
    destruct (some_small _ small_cuts_make_it_simple) as (e & _ & simple_ & <-).
    rewrite (simple_chain_turns_once _ simple_). destruct (is_counterclockwise _); [now left | now right].
  Qed.
End Touching.
