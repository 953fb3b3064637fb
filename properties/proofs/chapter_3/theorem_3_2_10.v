(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Theorem 3.2.10 of the thesis, in part: the segments of the reduced convolution that cover an isolated vertex of the
   open sum do not leave a half plane uncovered, so they have three directions, unless they are of two opposite ones
   only (which is not excluded here). For isolated vertices that are not the sum of two vertices.
   From segments_beside_the_open_sum.v: the open sum is on all sides, and each direction that is along none of the
   segments is to the left of one of them. *)
From Coq Require Import ZArith Lia Bool List Arith.
From Oplus Require Import numbers regions_and_sums parallelogram crossing_edges observation_2_2_4 lemma_2_2_9
  inside_a_corner tangent_direction boundary_points reduced_convolution right_of_an_edge reduced_edges_that_pass
  segments_beside_the_open_sum theorem_3_2_8.
Import ListNotations.

Open Scope Q_scope.

(* x is not in the open sum, and all other points near it are. *)
Definition isolated_vertex (x : vector) (p q : region) : Prop :=
  ~ interiors_meet x p q /\
  exists radius, 0 < radius /\ forall y, within radius x y -> ~ equal_vectors x y -> interiors_meet y p q.

Definition covers (s : segment) (x : vector) (p q : region) : Prop := In s (reduced_convolution p q) /\ lies_on x s.

Section IsolatedVertex.
  Variables p q : region.
  Variable x : vector.
  Hypothesis p_region : valid_region p.
  Hypothesis q_region : valid_region q.
  Hypothesis isolated : isolated_vertex x p q.
  Hypothesis no_vertices : forall w u, is_vertex w p -> is_vertex u q -> ~ equal_vectors x (plus w u).

  Let none_meet : forall w u, is_vertex w p -> is_vertex u q -> equal_vectors x (plus w u) -> alone w p /\ alone u q.
  Proof. intros w u of_p of_q equal. now destruct (no_vertices w u of_p of_q). Qed.

  (* Every direction n along which no segment covers x is to the left of one that does. *)
  Lemma segment_with_direction_to_its_left (n : vector) : nonzero n ->
    (forall s, covers s x p q -> nonzero (along s) -> ~ cross (along s) n == 0) ->
    exists s, covers s x p q /\ 0 < cross (along s) n.
  Proof.
    intros proper_n generic. destruct isolated as (outside & radius & R & near).
    assert (meet_ : eventually (fun t => interiors_meet (moved_along x n t) p q)).
    { destruct (small_steps_stay_within radius x n R) as (limit & L & close). exists limit. split; [exact L |].
      intros t t0 t1. apply near; [now apply close |]. intros [X Y]. unfold moved_along in X, Y; cbn [vx vy] in X, Y.
      apply proper_n. assert (zero_x : t * vx n == 0) by lra. assert (zero_y : t * vy n == 0) by lra.
      apply Qmult_integral in zero_x, zero_y. split; lra. }
    assert (not_along : forall e, nonzero (along e) -> reduced_along p q x (along e) -> ~ cross (along e) n == 0).
    { intros e long (s & S & on & (a & some & a_x & a_y)) flat.
      apply (generic s (conj S on)).
      - intros [X Y]. apply long. rewrite a_x in X. rewrite a_y in Y. apply Qmult_integral in X, Y. split; lra.
      - assert (value : cross (along s) n == a * cross (along e) n)
          by (unfold cross; rewrite a_x, a_y; ring). rewrite value, flat. ring. }
    destruct (segments_beside_the_open_sum p q x n)
      as (d & (s & S & on & (a & some & a_x & a_y)) & left_d & _); trivial.
    - intros e w u I on no_vertex in_q x_is. apply not_along.
      + now apply (region_edges_are_directions p (proj1 p_region)).
      + now apply (passing_edges_of_p_are_covered p q x p_region q_region outside none_meet w u e).
    - intros f u w I on no_vertex in_p x_is. apply not_along.
      + now apply (region_edges_are_directions q (proj1 q_region)).
      + now apply (passing_edges_of_q_are_covered p q x p_region q_region outside none_meet u w f).
    - exists s. split; [now split |].
      assert (value : cross (along s) n == a * cross d n) by (unfold cross; rewrite a_x, a_y; ring).
      rewrite value. now apply Qmult_lt_0_compat.
  Qed.

  (* m turned a little to one side. *)
  Lemma covers_when_turned_a_little (m m' : vector) : nonzero m' -> (forall v, cross v m == 0 -> cross v m' == 0) ->
    ~ dot m' m == 0 ->
    exists s, covers s x p q /\ (0 < cross (along s) m \/ same_direction (along s) m').
  Proof.
    intros proper_m' parallel some. set (l := Vector (- vy m') (vx m')).
    assert (value : forall v e, cross v (moved_along m l e) == cross v m + e * dot m' v)
      by (intros v e; unfold l, moved_along, cross, dot; cbn [vx vy]; ring).
    assert (each : eventually (fun e => forall s, In s (reduced_convolution p q) -> nonzero (along s) ->
      ~ cross (along s) (moved_along m l e) == 0 /\
      (0 < cross (along s) (moved_along m l e) -> 0 < cross (along s) m \/ same_direction (along s) m'))).
    { apply (eventually_for_all (fun s e => nonzero (along s) ->
        ~ cross (along s) (moved_along m l e) == 0 /\
        (0 < cross (along s) (moved_along m l e) -> 0 < cross (along s) m \/ same_direction (along s) m'))).
      intros s S. destruct (Q_dec (cross (along s) m) 0) as [[right_ | left_] | flat].
      - assert (above : 0 < - cross (along s) m) by lra.
        refine (eventually_implied _ _ _ (eventually_positive _ (- dot m' (along s)) above)).
        intros e positive_ _. rewrite value. split; intros; lra.
      - refine (eventually_implied _ _ _ (eventually_positive _ (dot m' (along s)) left_)).
        intros e positive_ _. rewrite value. split; [lra | intros _; now left].
      - exists 1. split; [lra |]. intros e e0 _ long. rewrite value, flat. split.
        + intros zero_. assert (none : e * dot m' (along s) == 0) by lra. apply Qmult_integral in none.
          destruct none as [none | none]; [lra |]. apply long.
          destruct (multiple_of _ m' proper_m' (parallel _ flat)) as (c & X & Y).
          pose proof (square_positive m' proper_m') as square. unfold dot in none, square. rewrite X, Y in none.
          assert (c_none : c == 0) by (apply (Qmult_inj_r _ _ (vx m' * vx m' + vy m' * vy m')); lra).
          rewrite X, Y, c_none. split; ring.
        + intros positive_. right. apply parallel_and_ahead; [exact proper_m' | now apply parallel |].
          destruct (Qlt_le_dec 0 (dot m' (along s))) as [| low]; [assumption | exfalso].
          assert (0 <= e * - dot m' (along s)) by (apply Qmult_le_0_compat; lra). lra. }
    destruct (some_small _ each) as (e & _ & at_e).
    destruct (segment_with_direction_to_its_left (moved_along m l e)) as (s & (S & on) & left_s).
    - intros [X Y]. apply some.
      assert (zero_ : dot m' (moved_along m l e) == dot m' m)
        by (unfold l, moved_along, dot; cbn [vx vy]; ring).
      rewrite <- zero_. unfold dot. rewrite X, Y. ring.
    - intros s (S & on) long. now apply (at_e s S long).
    - exists s. split; [now split |]. apply (at_e s S); [| exact left_s].
      intros [X Y]. unfold cross in left_s. rewrite X, Y in left_s. lra.
  Qed.

  Lemma segments_on_all_sides (m : vector) : nonzero m ->
    (exists s, covers s x p q /\ 0 < cross (along s) m) \/
    ((exists s, covers s x p q /\ same_direction (along s) m) /\
     (exists s, covers s x p q /\ same_direction (along s) (opposite m))).
  Proof.
    intros proper_m.
    pose proof (square_positive m proper_m) as square. unfold dot in square.
    destruct (covers_when_turned_a_little m m) as (s & covers_s & [left_s | same_s]); trivial.
    { unfold dot. lra. }
    { left. now exists s. }
    destruct (covers_when_turned_a_little m (opposite m)) as (t & covers_t & [left_t | same_t]).
    { now apply opposite_nonzero. }
    { intros v flat. unfold cross, opposite in *; cbn [vx vy]. lra. }
    { unfold dot, opposite; cbn [vx vy]. lra. }
    { left. now exists t. }
    right. split; [now exists s | now exists t].
  Qed.

  Lemma two_directions_are_opposite (d1 d2 : vector) : nonzero d1 -> nonzero d2 ->
    (forall s, covers s x p q -> same_direction (along s) d1 \/ same_direction (along s) d2) ->
    same_direction d2 (opposite d1).
  Proof.
    intros proper_1 proper_2 only.
    assert (one : forall d d', nonzero d -> (forall s, covers s x p q -> same_direction (along s) d \/
      same_direction (along s) d') -> 0 < cross d' d \/ same_direction d' (opposite d)).
    { intros d d' proper_d only_two. pose proof (square_positive d proper_d) as square.
      destruct (segments_on_all_sides d proper_d) as [(s & covers_s & left_s) | [_ (s & covers_s & back)]];
        destruct (only_two s covers_s) as [(a & some & X & Y) | (a & some & X & Y)].
      - exfalso. unfold cross in left_s. rewrite X, Y in left_s. lra.
      - left. assert (value : cross (along s) d == a * cross d' d) by (unfold cross; rewrite X, Y; ring). nra.
      - exfalso. destruct back as (b & some_b & X' & Y'). unfold opposite, dot in *; cbn [vx vy] in *.
        assert (0 < (a + b) * (vx d * vx d + vy d * vy d)) by (apply Qmult_lt_0_compat; lra).
        assert ((a + b) * vx d == 0) by lra. assert ((a + b) * vy d == 0) by lra. nra.
      - right. apply (same_direction_transitive _ (along s)); [| exact back].
        apply same_direction_symmetric. now exists a. }
    destruct (one d1 d2 proper_1 only) as [left_2 |]; [| assumption].
    destruct (one d2 d1 proper_2) as [left_1 | (a & some & X & Y)];
      [intros s covers_s; destruct (only s covers_s); auto | |].
    - exfalso. unfold cross in *. lra.
    - exists (/ a). split; [now apply Qinv_lt_0_compat |]. unfold opposite in *; cbn [vx vy] in *. rewrite X, Y.
      split; field; lra.
  Qed.
End IsolatedVertex.

(* Every direction m is to the left of a segment that covers the isolated vertex, or two cover it along m, of opposite
   directions. *)
Theorem segments_on_all_sides_of_an_isolated_vertex (p q : region) (x m : vector) :
  valid_region p -> valid_region q -> isolated_vertex x p q ->
  (forall w u, is_vertex w p -> is_vertex u q -> ~ equal_vectors x (plus w u)) ->
  nonzero m ->
  (exists s, covers s x p q /\ 0 < cross (along s) m) \/
  ((exists s, covers s x p q /\ same_direction (along s) m) /\
   (exists s, covers s x p q /\ same_direction (along s) (opposite m))).
Proof. intros. now apply segments_on_all_sides. Qed.

(* Two directions are too few, unless they are opposite. *)
Theorem three_directions_at_an_isolated_vertex (p q : region) (x d1 d2 : vector) :
  valid_region p -> valid_region q -> isolated_vertex x p q ->
  (forall w u, is_vertex w p -> is_vertex u q -> ~ equal_vectors x (plus w u)) ->
  nonzero d1 -> nonzero d2 ->
  (forall s, covers s x p q -> same_direction (along s) d1 \/ same_direction (along s) d2) ->
  same_direction d2 (opposite d1).
Proof. intros. now apply (two_directions_are_opposite p q x). Qed.
