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

Lemma strictly_inside_equal (v w : vector) (s : segment) : equal_vectors v w -> strictly_inside v s ->
  strictly_inside w s.
Proof. intros [X Y] (k & range & kx & ky). exists k. rewrite <- X, <- Y. tauto. Qed.

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

Lemma is_a_multiple (u v : vector) : nonzero u -> cross u v == 0 ->
  exists c, vx v == c * vx u /\ vy v == c * vy u.
Proof. intros long parallel. apply multiple_of; [exact long | unfold cross in *; lra]. Qed.

Lemma reversed_place (f : segment) : of_one_place (reversed f) f.
Proof. right. unfold reversed; cbn [source target]. repeat split; reflexivity. Qed.

(* If f runs in the direction of e, with a point inside both, and no end of f is inside e, it reaches beyond e. *)
Lemma reaches_beyond (e f : segment) (k j c : Q) : 0 < k < 1 -> 0 < j < 1 -> 0 < c ->
  vx (along f) == c * vx (along e) -> vy (along f) == c * vy (along e) ->
  equal_vectors (point_at e k) (point_at f j) -> ~ strictly_inside (source f) e -> ~ strictly_inside (target f) e ->
  k <= j * c /\ 1 - k <= (1 - j) * c.
Proof.
  intros k_range j_range some along_x along_y [X Y] f_source f_target. unfold point_at in X, Y; cbn [vx vy] in X, Y.
  assert (0 < j * c /\ 0 < (1 - j) * c) by (split; apply Qmult_lt_0_compat; lra).
  split; apply Qnot_lt_le; intros inside_;
    [apply f_source; exists (k - j * c) | apply f_target; exists (k + (1 - j) * c)];
    (split; [lra |]); clear - X Y along_x along_y; in_coordinates; split; by_equations.
Qed.

(* Two segments with a common point inside both, and no end of one inside the other, are in one place. *)
Lemma one_place (e f : segment) (w : vector) :
  nonzero (along e) -> nonzero (along f) -> cross (along e) (along f) == 0 ->
  strictly_inside w e -> strictly_inside w f ->
  ~ strictly_inside (source f) e -> ~ strictly_inside (target f) e ->
  ~ strictly_inside (source e) f -> ~ strictly_inside (target e) f -> of_one_place e f.
Proof.
  intros long_e long_f parallel in_e in_f f_source f_target e_source e_target.
  destruct (is_a_multiple _ _ long_e parallel) as (r & rx & ry).
  assert (ahead : forall g c, 0 < c -> vx (along g) == c * vx (along e) -> vy (along g) == c * vy (along e) ->
    strictly_inside w g -> ~ strictly_inside (source g) e -> ~ strictly_inside (target g) e ->
    ~ strictly_inside (source e) g -> ~ strictly_inside (target e) g ->
    equal_vectors (source e) (source g) /\ equal_vectors (target e) (target g)).
  { intros g c some cx cy (j & j_range & jx & jy) g1 g2 e1 e2. destruct in_e as (k & k_range & kx & ky).
    assert (same : equal_vectors (point_at e k) (point_at g j)) by (split; cbn [point_at vx vy]; lra).
    assert (inverse : / c * c == 1) by (field; lra). pose proof (Qinv_lt_0_compat c some) as some'.
    destruct (reaches_beyond e g k j c) as [a1 a2]; trivial.
    destruct (reaches_beyond g e j k (/ c)) as [b1 b2]; trivial;
      [rewrite cx, Qmult_assoc, inverse; ring | rewrite cy, Qmult_assoc, inverse; ring | now symmetry |].
    apply (Qmult_le_compat_r _ _ c) in b1, b2; [| lra ..]. rewrite <- Qmult_assoc, inverse in b1, b2.
    assert (c_is : c == 1) by lra. rewrite c_is in *. assert (j_is : j == k) by lra. rewrite j_is in *.
    clear - kx ky jx jy cx cy. in_coordinates. split; split; by_equations. }
  destruct (Q_dec r 0) as [[low | high] | none].
  - assert (back : forall v, ~ strictly_inside v f -> ~ strictly_inside v (reversed f))
      by (intros v out in_back; apply out; rewrite <- (reversed_twice f); now apply strictly_inside_reversed).
    right. apply (ahead (reversed f) (- r)); auto using strictly_inside_reversed; in_coordinates; lra.
  - left. now apply (ahead f r).
  - exfalso. apply long_f. rewrite rx, ry, none. split; ring.
Qed.

Lemma ends_of_a_piece (s piece : segment) (others : list segment) (p : vector) :
  In piece (cut_where_met s others) -> p = source piece \/ p = target piece ->
  p = source s \/ p = target s \/ exists f, In f others /\ In p (intersection s f).
Proof.
  intros I end_. destruct (consecutive_are _ _ I) as (before & after & points_are).
  assert (J : In p (points_along s (flat_map (intersection s) others)))
    by (rewrite points_are; apply in_app_iff; cbn; destruct end_ as [-> | ->]; tauto).
  clear points_are. unfold points_along in J. set (sorted := sorted_points _) in J.
  assert (K : In p sorted) by (destruct (compare_points (target s) (source s)); trivial; now apply in_rev).
  apply sorted_in, in_app_iff in K. destruct K as [K | [<- | [<- | []]]]; [| tauto ..].
  apply filter_In in K. destruct K as [(f & F & K)%in_flat_map _]. right. right. now exists f.
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
    intros S1 S2 P1 P2 end_ inside_. pose proof (all_long s2 S2) as long.
    assert (no_end : forall f, In f segments -> p <> source f /\ p <> target f).
    { intros f F. destruct (nothing_meets_a_piece s2 segments p2 f p long P2 inside_ F) as (a & b & _).
      split; intros ->; [now apply a | now apply b]. }
    destruct (no_end s1 S1). destruct (ends_of_a_piece s1 p1 segments p P1 end_) as [| [| (f & F & met)]];
      [contradiction .. |].
    destruct (intersection_is_on_both s1 f p met) as (on_s1 & on_f & [ends | turn]); [destruct (no_end f F); tauto |].
    apply turn. destruct (nothing_meets_a_piece s2 segments p2 s1 p long P2 inside_ S1) as (_ & _ & first_).
    destruct (nothing_meets_a_piece s2 segments p2 f p long P2 inside_ F) as (_ & _ & second_).
    destruct (is_a_multiple _ _ long (first_ on_s1)) as (a & ax & ay), (is_a_multiple _ _ long (second_ on_f))
      as (b & bx & by_).
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

  Theorem pieces_are_pieces : are_pieces segments (pieces_of segments).
  Proof.
    split.
    - intros e E. destruct (piece_is e E) as (s & piece & _ & _ & -> & _ & long & _).
      exact (long_of_one_place _ _ (undirected_place piece) long).
    - intros e w E on. destruct (piece_is e E) as (s & piece & S & _ & -> & part & _). exists s. split; [exact S |].
      apply (part_lies_on piece s w part).
      exact (lies_on_of_one_place _ _ w (undirected_place piece) on).
    - intros t w J on.
      destruct (cut_returns t (flat_map (intersection t) segments) (all_long t J)) as [_ covers_].
      destruct (covers_ w on) as (piece & I & _ & on_piece). exists (undirected piece). split.
      + unfold pieces_of. apply nodup_In, in_flat_map. exists t. split; [exact J |]. now apply in_map.
      + exact (lies_on_of_one_place _ _ w (of_one_place_sym _ _ (undirected_place piece)) on_piece).
    - intros e E w t inside_ J on. destruct (piece_is e E) as (s & piece & S & P & -> & _).
      apply (strictly_inside_of_one_place _ _ w (undirected_place piece)) in inside_.
      apply (collinear_of_one_place _ piece); [apply undirected_place |].
      exact (pieces_are_met_only_along s segments piece (all_long s S) P w t inside_ J on).
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
      specialize (parallel (part_lies_on p2 s2 w part2 (strictly_inside_lies_on w p2 in_f))).
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

  Lemma no_vertex_is_inside (e f : segment) (v : vector) : In e (pieces_of segments) -> In f (pieces_of segments) ->
    v = source e \/ v = target e -> ~ strictly_inside v f.
  Proof.
    intros E F end_ inside_.
    destruct (piece_is e E) as (s1 & p1 & S1 & P1 & -> & _), (piece_is f F) as (s2 & p2 & S2 & P2 & -> & _).
    apply (strictly_inside_of_one_place _ _ v (undirected_place p2)) in inside_.
    assert (end_of_p1 : equal_vectors v (source p1) \/ equal_vectors v (target p1))
      by (destruct (undirected_place p1) as [[a b] | [a b]], end_ as [-> | ->]; tauto).
    destruct end_of_p1 as [equal | equal]; apply (strictly_inside_equal _ _ _ equal) in inside_;
      revert inside_; apply (no_end_inside s1 s2 p1 p2); tauto.
  Qed.

  Definition no_common_inside (s t : segment) : Prop := forall w, strictly_inside w s -> ~ strictly_inside w t.

  Lemma different_pieces (e f : segment) : In e (pieces_of segments) -> In f (pieces_of segments) -> e <> f ->
    no_common_inside e f.
  Proof.
    intros E F differ w. destruct (in_split _ _ E) as (before & after & pieces_are).
    apply (pieces_are_apart _ _ pieces_are_pieces before e after f w pieces_are).
    rewrite pieces_are in F. apply in_elt_inv in F. destruct F as [-> | F]; [now destruct differ | exact F].
  Qed.

  (* A point inside a piece is on no other. *)
  Lemma inside_one_piece (e f : segment) (w : vector) : In e (pieces_of segments) -> In f (pieces_of segments) ->
    strictly_inside w e -> lies_on w f -> e = f.
  Proof.
    intros E F inside_ on. destruct (segment_dec e f) as [| differ]; [assumption | exfalso].
    destruct (inside_or_end w f on) as [in_f | [equal | equal]];
      [exact (different_pieces e f E F differ w inside_ in_f) | |];
      symmetry in equal; apply (strictly_inside_equal _ _ _ equal) in inside_; revert inside_;
      apply (no_vertex_is_inside f e); tauto.
  Qed.
End Pieces.
