(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The pieces of filling.v are parts of the segments, all of them together, none has an end of another inside, and
   no two are the same. *)
From Coq Require Import QArith Qabs Qminmax Qreduction Lqa Qfield ZArith Lia Bool List.
From Oplus Require Import direction angular_crossings winding_number shifted_ray meeting_of_segments rotation regions
  neighbourhoods location pieces met_pieces naive_collision collision_is_sound beside_a_piece filling
  kept_pieces_go_round.
Import ListNotations.

Open Scope Q_scope.

Lemma reduced_is (v : vector) : equal_vectors (reduced_vector v) v.
Proof. split; apply Qred_correct. Qed.

Lemma reduced_of_equal (v w : vector) : equal_vectors v w -> reduced_vector v = reduced_vector w.
Proof. intros [X Y]. unfold reduced_vector. now rewrite (Qred_complete _ _ X), (Qred_complete _ _ Y). Qed.

(* The same ends, in one order or the other. *)
Definition of_one_place (e f : segment) : Prop :=
  (equal_vectors (source e) (source f) /\ equal_vectors (target e) (target f)) \/
  (equal_vectors (source e) (target f) /\ equal_vectors (target e) (source f)).

Lemma undirected_place (e : segment) : of_one_place (undirected e) e.
Proof.
  unfold of_one_place, undirected. pose proof (reduced_is (source e)). pose proof (reduced_is (target e)).
  destruct (compare_points _ _); cbn [source target]; tauto.
Qed.

Lemma of_one_place_sym (e f : segment) : of_one_place e f -> of_one_place f e.
Proof. unfold of_one_place, equal_vectors. intros [H | H]; [left | right]; lra. Qed.

Lemma compare_points_antisym (a b : vector) : compare_points b a = CompOpp (compare_points a b).
Proof.
  unfold compare_points. rewrite <- (Qcompare_antisym (vx a)), <- (Qcompare_antisym (vy a)).
  destruct (vx a ?= vx b); reflexivity.
Qed.

Lemma undirected_of_one_place (e f : segment) : of_one_place e f -> undirected e = undirected f.
Proof.
  unfold undirected. intros [[s t] | [s t]]; apply reduced_of_equal in s; apply reduced_of_equal in t; rewrite s, t.
  - reflexivity.
  - rewrite (compare_points_antisym (reduced_vector (source f)) (reduced_vector (target f))).
    compared_points (reduced_vector (source f)) (reduced_vector (target f)); cbn [CompOpp]; try reflexivity.
    enough (reduced_vector (source f) = reduced_vector (target f)) as -> by reflexivity. apply reduced_of_equal.
    destruct (reduced_is (source f)) as [X1 Y1], (reduced_is (target f)) as [X2 Y2], equal_points as [X Y].
    unfold equal_vectors. lra.
Qed.

Lemma lies_on_of_one_place (e f : segment) (w : vector) : of_one_place e f -> lies_on w e -> lies_on w f.
Proof.
  intros [[[X1 Y1] [X2 Y2]] | [[X1 Y1] [X2 Y2]]] (k & range & X & Y); [exists k | exists (1 - k)];
    (split; [lra |]); rewrite X, Y, X1, Y1, X2, Y2; split; ring.
Qed.

Lemma strictly_inside_of_one_place (e f : segment) (w : vector) :
  of_one_place e f -> strictly_inside w e -> strictly_inside w f.
Proof.
  intros [[[X1 Y1] [X2 Y2]] | [[X1 Y1] [X2 Y2]]] (k & range & X & Y); [exists k | exists (1 - k)];
    (split; [lra |]); rewrite X, Y, X1, Y1, X2, Y2; split; ring.
Qed.

Lemma long_of_one_place (e f : segment) : of_one_place e f -> nonzero (along f) -> nonzero (along e).
Proof.
  intros [[[X1 Y1] [X2 Y2]] | [[X1 Y1] [X2 Y2]]] long [X Y]; apply long; unfold along, minus in *; cbn [vx vy] in *;
    split; lra.
Qed.

Lemma collinear_of_one_place (e f t : segment) : of_one_place e f -> collinear f t -> collinear e t.
Proof.
  unfold collinear, area, cross, minus. cbn [vx vy].
  intros [[[X1 Y1] [X2 Y2]] | [[X1 Y1] [X2 Y2]]] [a b]; rewrite X1, Y1, X2, Y2; split; lra.
Qed.

(* On a line through a point of the piece, in its direction. *)
Lemma collinear_by_direction (e t : segment) (w : vector) :
  lies_on w e -> lies_on w t -> cross (along e) (along t) == 0 -> collinear e t.
Proof.
  intros (k & _ & X & Y) (j & _ & U & V) parallel. unfold collinear. in_coordinates. split; by_equations.
Qed.

Lemma is_a_multiple (u v : vector) : nonzero u -> cross u v == 0 ->
  exists c, vx v == c * vx u /\ vy v == c * vy u.
Proof. intros long parallel. apply multiple_of; [exact long | unfold cross in *; lra]. Qed.

(* Two segments with a common point inside both, and no end of one inside the other, are in one place. *)
Lemma same_place_ahead (e f : segment) (w : vector) (c : Q) :
  0 < c -> vx (along f) == c * vx (along e) -> vy (along f) == c * vy (along e) ->
  strictly_inside w e -> strictly_inside w f ->
  ~ strictly_inside (source f) e -> ~ strictly_inside (target f) e ->
  ~ strictly_inside (source e) f -> ~ strictly_inside (target e) f ->
  equal_vectors (source e) (source f) /\ equal_vectors (target e) (target f).
Proof.
  intros some along_x along_y (k & k_range & kx & ky) (j & j_range & jx & jy) f_source f_target e_source e_target.
  (* where points of f are along e *)
  set (a := k - j * c). assert (0 < j * c) by (apply Qmult_lt_0_compat; lra).
  assert (0 < (1 - j) * c) by (apply Qmult_lt_0_compat; lra). assert (a_range : a < 1 /\ 0 < a + c) by (unfold a; lra).
  assert (same_x : forall l, (1 - l) * vx (source f) + l * vx (target f) ==
    (1 - (a + l * c)) * vx (source e) + (a + l * c) * vx (target e))
    by (intros l; unfold a; clear - kx jx along_x; in_coordinates; by_equations).
  assert (same_y : forall l, (1 - l) * vy (source f) + l * vy (target f) ==
    (1 - (a + l * c)) * vy (source e) + (a + l * c) * vy (target e))
    by (intros l; unfold a; clear - ky jy along_y; in_coordinates; by_equations).
  clearbody a. clear along_x along_y kx ky jx jy.
  pose proof (same_x 0) as x0. pose proof (same_y 0) as y0. pose proof (same_x 1) as x1. pose proof (same_y 1) as y1.
  assert (a_low : a <= 0) by (apply Qnot_lt_le; intros high; apply f_source; exists a; repeat split; lra).
  assert (b_high : 1 <= a + c) by (apply Qnot_lt_le; intros low; apply f_target; exists (a + c); repeat split; lra).
  assert (a_is : a == 0).
  { destruct (Qlt_le_dec a 0) as [low |]; [exfalso | lra]. apply e_source. exists (- a / c).
    assert (value : - a / c * c == - a) by (field; lra). split.
    - split; [apply Qlt_shift_div_l; lra | apply Qlt_shift_div_r; lra].
    - pose proof (same_x (- a / c)). pose proof (same_y (- a / c)). set (l := - a / c) in *. clearbody l.
      split; by_equations. }
  assert (c_is : c == 1).
  { destruct (Qlt_le_dec 1 c) as [long |]; [exfalso | lra]. apply e_target. exists (1 / c).
    assert (value : 1 / c * c == 1) by (field; lra). split.
    - split; [apply Qlt_shift_div_l; lra | apply Qlt_shift_div_r; lra].
    - pose proof (same_x (1 / c)). pose proof (same_y (1 / c)). set (l := 1 / c) in *. clearbody l.
      split; by_equations. }
  rewrite a_is, c_is in x0, y0, x1, y1. unfold equal_vectors. lra.
Qed.

Lemma reversed_place (f : segment) : of_one_place (reversed f) f.
Proof. right. unfold reversed; cbn [source target]. repeat split; reflexivity. Qed.

Lemma one_place (e f : segment) (w : vector) :
  nonzero (along e) -> nonzero (along f) -> cross (along e) (along f) == 0 ->
  strictly_inside w e -> strictly_inside w f ->
  ~ strictly_inside (source f) e -> ~ strictly_inside (target f) e ->
  ~ strictly_inside (source e) f -> ~ strictly_inside (target e) f -> of_one_place e f.
Proof.
  intros long_e long_f parallel in_e in_f a b c d. destruct (is_a_multiple _ _ long_e parallel) as (r & rx & ry).
  destruct (Q_dec r 0) as [[low | high] | none].
  - right. apply (same_place_ahead e (reversed f) w (- r)); trivial; try lra.
    + in_coordinates. lra.
    + in_coordinates. lra.
    + now apply strictly_inside_reversed.
    + intros inside_. apply c. apply strictly_inside_reversed in inside_. now rewrite reversed_twice in inside_.
    + intros inside_. apply d. apply strictly_inside_reversed in inside_. now rewrite reversed_twice in inside_.
  - left. now apply (same_place_ahead e f w r).
  - exfalso. apply long_f. rewrite rx, ry, none. split; ring.
Qed.

Lemma intersection_is_on_both (s f : segment) (p : vector) : In p (intersection s f) ->
  lies_on p s /\ lies_on p f /\
  ((p = source s \/ p = target s \/ p = source f \/ p = target f) \/ ~ cross (along s) (along f) == 0).
Proof.
  intros I. unfold intersection in I. destruct (sorted_points _) as [| a l] eqn:sorted.
  - destruct (cross_properly s f) eqn:crossing_; [| destruct I]. destruct I as [<- | []].
    destruct (proper_crossing s f crossing_) as (w & in_s & in_f & turn).
    apply strictly_inside_lies_on in in_s, in_f. destruct (intersection_has s f w turn in_s in_f) as (q & J & equal).
    unfold intersection in J. rewrite sorted, crossing_ in J. destruct J as [<- | []].
    split; [now apply (lies_on_equal w) |]. split; [now apply (lies_on_equal w) | now right].
  - rewrite <- sorted in I. apply sorted_in, in_app_iff in I.
    destruct I as [I | I]; apply filter_In in I; destruct I as [end_ on]; cbn in end_.
    + destruct (is_on_spec p f) as [on_f |]; [| discriminate]. split; [| intuition].
      destruct end_ as [<- | [<- | []]]; [apply source_lies_on | apply target_lies_on].
    + destruct (is_on_spec p s) as [on_s |]; [| discriminate]. split; [exact on_s |]. split; [| intuition].
      destruct end_ as [<- | [<- | []]]; [apply source_lies_on | apply target_lies_on].
Qed.

Lemma intersection_is (s f : segment) (p : vector) : In p (intersection s f) ->
  (p = source s \/ p = target s \/ p = source f \/ p = target f) \/
  (lies_on p s /\ lies_on p f /\ ~ cross (along s) (along f) == 0).
Proof. intros I. destruct (intersection_is_on_both s f p I) as (on_s & on_f & [ends | turn]); tauto. Qed.

Lemma ends_of_a_piece (s piece : segment) (others : list segment) (p : vector) :
  In piece (cut_where_met s others) -> p = source piece \/ p = target piece ->
  p = source s \/ p = target s \/ exists f, In f others /\ In p (intersection s f).
Proof.
  intros I end_. unfold cut_where_met, cut in I. apply consecutive_iff in I.
    destruct I as (before & after & points_are).
  assert (J : In p (points_along s (flat_map (intersection s) others))).
  { rewrite points_are. apply in_app_iff. cbn. destruct end_ as [-> | ->]; tauto. }
  clear points_are. unfold points_along in J.
  assert (K : In p (sorted_points (filter (fun p => negb (same_point p (source s)) && negb (same_point p (target s)) &&
      is_on_segment p s) (flat_map (intersection s) others) ++ [source s; target s]))).
  { destruct (compare_points (target s) (source s)); trivial. now apply in_rev. }
  apply sorted_in, in_app_iff in K. destruct K as [K | [<- | [<- | []]]]; [| tauto ..].
  apply filter_In in K. destruct K as [K _]. apply in_flat_map in K. destruct K as (f & F & K).
  right. right. now exists f.
Qed.

(* What is asked of the pieces. *)
Record are_pieces (segments pieces : list segment) : Prop := {
  pieces_are_long : forall e, In e pieces -> nonzero (along e);
  pieces_are_on : forall e w, In e pieces -> lies_on w e -> exists t, In t segments /\ lies_on w t;
  pieces_are_all : forall t w, In t segments -> lies_on w t -> exists e, In e pieces /\ lies_on w e;
  pieces_are_met_along : forall e, In e pieces -> met_only_along segments e;
  pieces_are_apart : apart_from_all pieces }.

Section Pieces.
  Variable segments : list segment.
  Hypothesis all_long : forall t, In t segments -> nonzero (along t).

  (* No end of a piece is strictly inside another. *)
  Lemma no_end_inside (s1 s2 p1 p2 : segment) (p : vector) :
    In s1 segments -> In s2 segments -> In p1 (cut_where_met s1 segments) -> In p2 (cut_where_met s2 segments) ->
    p = source p1 \/ p = target p1 -> ~ strictly_inside p p2.
  Proof.
    intros S1 S2 P1 P2 end_ inside_.
    assert (itself : equal_vectors p p) by (split; reflexivity).
    assert (no_end : forall f, In f segments -> p <> source f /\ p <> target f).
    { intros f F. destruct (nothing_meets_a_piece s2 segments p2 f p (all_long s2 S2) P2 inside_ F) as (a & b & _).
      split; intros equal; [apply a | apply b]; rewrite <- equal; exact itself. }
    destruct (ends_of_a_piece s1 p1 segments p P1 end_) as [is_source | [is_target | (f & F & met)]].
    - destruct (no_end s1 S1). congruence.
    - destruct (no_end s1 S1). congruence.
    - apply intersection_is in met. destruct met as [ends | (on_s1 & on_f & turn)].
      + destruct (no_end s1 S1), (no_end f F). intuition congruence.
      + destruct (nothing_meets_a_piece s2 segments p2 s1 p (all_long s2 S2) P2 inside_ S1) as (_ & _ & first_).
        destruct (nothing_meets_a_piece s2 segments p2 f p (all_long s2 S2) P2 inside_ F) as (_ & _ & second_).
        specialize (first_ on_s1). specialize (second_ on_f). apply turn.
        destruct (is_a_multiple _ _ (all_long s2 S2) first_) as (a & ax & ay).
        destruct (is_a_multiple _ _ (all_long s2 S2) second_) as (b & bx & by_).
        unfold cross. rewrite ax, ay, bx, by_. ring.
  Qed.

  Lemma piece_is (e : segment) : In e (pieces_of segments) ->
    exists s piece, In s segments /\ In piece (cut_where_met s segments) /\ e = undirected piece /\
      is_part piece s /\ nonzero (along piece) /\
      exists c, 0 < c /\ vx (along piece) == c * vx (along s) /\ vy (along piece) == c * vy (along s).
  Proof.
    intros E. unfold pieces_of in E. apply nodup_In, in_flat_map in E. destruct E as (s & S & E).
    apply in_map_iff in E. destruct E as (piece & <- & I). exists s, piece.
    destruct (cut_returns s (flat_map (intersection s) segments) (all_long s S)) as [parts _].
    destruct (parts piece I) as [part _].
    destruct (part_is_long piece s part (all_long s S)) as [long multiple_]. tauto.
  Qed.

  Lemma part_lies_on (piece s : segment) (w : vector) : nonzero (along s) -> is_part piece s -> lies_on w piece ->
    lies_on w s.
  Proof.
    intros long part (k & range & X & Y). now destruct (point_of_part piece s w k long part range X Y).
  Qed.

  Theorem pieces_are_pieces : are_pieces segments (pieces_of segments).
  Proof.
    split.
    - intros e E. destruct (piece_is e E) as (s & piece & _ & _ & -> & _ & long & _).
      exact (long_of_one_place _ _ (undirected_place piece) long).
    - intros e w E on. destruct (piece_is e E) as (s & piece & S & _ & -> & part & _). exists s. split; [exact S |].
      apply (part_lies_on piece); [now apply all_long | exact part |].
      exact (lies_on_of_one_place _ _ w (undirected_place piece) on).
    - intros t w J on.
      destruct (cut_returns t (flat_map (intersection t) segments) (all_long t J)) as [_ covers_].
      destruct (covers_ w on) as (piece & I & _ & on_piece). exists (undirected piece). split.
      + unfold pieces_of. apply nodup_In, in_flat_map. exists t. split; [exact J |]. now apply in_map.
      + exact (lies_on_of_one_place _ _ w (of_one_place_sym _ _ (undirected_place piece)) on_piece).
    - intros e E w t inside_ J on. destruct (piece_is e E) as (s & piece & S & P & -> & part & _ & c & some & cx & cy).
      apply (strictly_inside_of_one_place _ _ w (undirected_place piece)) in inside_.
      apply (collinear_of_one_place _ piece); [apply undirected_place |].
      destruct (nothing_meets_a_piece s segments piece t w (all_long s S) P inside_ J) as (_ & _ & parallel).
      apply (collinear_by_direction piece t w); [now apply strictly_inside_lies_on | exact on |].
      specialize (parallel on). clear - parallel cx cy. unfold cross in *. by_equations.
    - intros before e after f w pieces_are F in_e in_f.
      assert (distinct_ : NoDup (pieces_of segments)) by apply NoDup_nodup.
      assert (E : In e (pieces_of segments)) by (rewrite pieces_are; apply in_app_iff; cbn; tauto).
      assert (F' : In f (pieces_of segments))
        by (rewrite pieces_are; apply in_app_iff; apply in_app_iff in F; cbn; tauto).
      rewrite pieces_are in distinct_. apply NoDup_remove_2 in distinct_. apply distinct_.
      enough (e = f) as -> by exact F.
      destruct (piece_is e E) as (s1 & p1 & S1 & P1 & -> & part1 & long1 & c1 & some1 & x1 & y1).
      destruct (piece_is f F') as (s2 & p2 & S2 & P2 & -> & part2 & long2 & c2 & some2 & x2 & y2).
      apply (strictly_inside_of_one_place _ _ w (undirected_place p1)) in in_e.
      apply (strictly_inside_of_one_place _ _ w (undirected_place p2)) in in_f.
      apply undirected_of_one_place.
      destruct (nothing_meets_a_piece s1 segments p1 s2 w (all_long s1 S1) P1 in_e S2) as (_ & _ & parallel).
      specialize (parallel (part_lies_on p2 s2 w (all_long s2 S2) part2 (strictly_inside_lies_on w p2 in_f))).
      apply (one_place p1 p2 w); trivial.
      + clear - parallel x1 y1 x2 y2. unfold cross in *. by_equations.
      + apply (no_end_inside s2 s1 p2 p1); tauto.
      + apply (no_end_inside s2 s1 p2 p1); tauto.
      + apply (no_end_inside s1 s2 p1 p2); tauto.
      + apply (no_end_inside s1 s2 p1 p2); tauto.
  Qed.

  Definition is_reduced (v : vector) : Prop := reduced_vector v = v.

  Lemma reduced_is_reduced (v : vector) : is_reduced (reduced_vector v).
  Proof. apply reduced_of_equal, reduced_is. Qed.

  Lemma ends_are_reduced (e : segment) : In e (pieces_of segments) -> is_reduced (source e) /\ is_reduced (target e).
  Proof.
    intros E. destruct (piece_is e E) as (s & piece & _ & _ & -> & _). unfold undirected.
    destruct (compare_points _ _); cbn [source target]; split; apply reduced_is_reduced.
  Qed.

  Lemma pieces_are_in_order (e : segment) : In e (pieces_of segments) -> comes_first (source e) (target e).
  Proof.
    intros E. pose proof (pieces_are_long _ _ pieces_are_pieces e E) as long.
    destruct (piece_is e E) as (s & piece & _ & _ & -> & _). unfold undirected in *.
    compared_points (reduced_vector (source piece)) (reduced_vector (target piece)); cbn [source target] in *; trivial.
    exfalso. apply long. destruct equal_points as [X Y]. unfold along, minus. cbn [source target vx vy]. split; lra.
  Qed.

  Lemma no_vertex_is_inside (e f : segment) (v : vector) : In e (pieces_of segments) -> In f (pieces_of segments) ->
    v = source e \/ v = target e -> ~ strictly_inside v f.
  Proof.
    intros E F end_ inside_.
    destruct (piece_is e E) as (s1 & p1 & S1 & P1 & -> & _).
    destruct (piece_is f F) as (s2 & p2 & S2 & P2 & -> & _).
    apply (strictly_inside_of_one_place _ _ v (undirected_place p2)) in inside_.
    assert (end_of_p1 : equal_vectors v (source p1) \/ equal_vectors v (target p1)).
    { destruct (undirected_place p1) as [[a b] | [a b]], end_ as [-> | ->]; tauto. }
    assert (moved_ : forall w, equal_vectors v w -> strictly_inside w p2).
    { intros w [X Y]. destruct inside_ as (k & range & kx & ky). exists k. split; [exact range |].
      rewrite <- X, <- Y. tauto. }
    destruct end_of_p1 as [equal | equal];
      [apply (no_end_inside s1 s2 p1 p2 (source p1)) |
       apply (no_end_inside s1 s2 p1 p2 (target p1))]; trivial; try tauto; now apply moved_.
  Qed.

  Definition no_common_inside (s t : segment) : Prop := forall w, strictly_inside w s -> ~ strictly_inside w t.

  Lemma different_pieces (e f : segment) : In e (pieces_of segments) -> In f (pieces_of segments) -> e <> f ->
    no_common_inside e f.
  Proof.
    intros E F differ w. destruct (in_split _ _ E) as (before & after & pieces_are).
    apply (pieces_are_apart _ _ pieces_are_pieces before e after f w pieces_are).
    rewrite pieces_are in F. apply in_elt_inv in F. destruct F as [-> | F]; [now destruct differ | exact F].
  Qed.
End Pieces.
