(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Two corners that meet with no inner point in common, as a corner of P and one of -Q + x: an edge of one is in the
   tangent set of the other, ties by the tie rule, unless edges lie along each other. It is a statement on the cyclic
   order of four directions, decided by how far each is turned from one of them (angle.v). *)
From Coq Require Import Lia Bool List.
From Oplus Require Import numbers convolution weight inside_a_corner.
Import ListNotations.

Open Scope Q_scope.

(* How far b is turned counterclockwise from a; a full turn is 4. *)
Definition turn_to (a b : vector) : Q :=
  if Qlt_le_dec (angle b) (angle a) then angle b - angle a + 4 else angle b - angle a.

Lemma turn_range (a b : vector) : nonzero a -> nonzero b -> 0 <= turn_to a b < 4.
Proof.
  intros proper_a proper_b. pose proof (angle_range a proper_a). pose proof (angle_range b proper_b).
  unfold turn_to. destruct (Qlt_le_dec (angle b) (angle a)); lra.
Qed.

Lemma turn_from_another (a b c : vector) : nonzero a -> nonzero b -> nonzero c ->
  (turn_to a b <= turn_to a c /\ turn_to b c == turn_to a c - turn_to a b) \/
  (turn_to a c < turn_to a b /\ turn_to b c == turn_to a c - turn_to a b + 4).
Proof.
  intros proper_a proper_b proper_c. pose proof (angle_range a proper_a). pose proof (angle_range b proper_b).
  pose proof (angle_range c proper_c). unfold turn_to.
  destruct (Qlt_le_dec (angle b) (angle a)), (Qlt_le_dec (angle c) (angle a)), (Qlt_le_dec (angle c) (angle b)); lra.
Qed.

Lemma turn_to_opposite (a b : vector) : nonzero a -> nonzero b ->
  (turn_to a b < 2 /\ turn_to a (opposite b) == turn_to a b + 2) \/
  (2 <= turn_to a b /\ turn_to a (opposite b) == turn_to a b - 2).
Proof.
  intros proper_a proper_b. pose proof (angle_range a proper_a). pose proof (angle_range b proper_b).
  pose proof (angle_range _ (opposite_nonzero b proper_b)). pose proof (opposite_angle b proper_b).
  unfold turn_to. destruct (Qlt_le_dec (angle b) (angle a)), (Qlt_le_dec (angle (opposite b)) (angle a)); lra.
Qed.

Lemma turn_to_itself (a : vector) : turn_to a a == 0.
Proof. unfold turn_to. destruct (Qlt_le_dec (angle a) (angle a)); lra. Qed.

Lemma side_by_turn (a b : vector) : nonzero a -> nonzero b ->
  (0 < cross a b /\ 0 < turn_to a b < 2) \/ (cross a b < 0 /\ 2 < turn_to a b) \/
  (cross a b == 0 /\ 0 < dot a b /\ turn_to a b == 0) \/ (cross a b == 0 /\ dot a b < 0 /\ turn_to a b == 2).
Proof.
  intros proper_a proper_b. pose proof (angle_range a proper_a). pose proof (angle_range b proper_b).
  pose proof (cross_angle a b proper_a proper_b) as turned_. unfold turns_by in turned_. unfold turn_to.
  destruct (Qlt_le_dec (angle b) (angle a)); lra.
Qed.

Lemma tangent_by_turn (d : direction) (c : corner) :
  nonzero (vec d) -> nonzero (incoming c) -> nonzero (outgoing c) ->
  0 < turn_to (incoming c) (vec d) < turn_to (incoming c) (outgoing c) -> in_tangent_set d c = true.
Proof.
  destruct d as [d label], c as [u v]. cbn [vec incoming outgoing]. intros proper_d proper_u proper_v range.
  pose proof (angle_range u proper_u). pose proof (angle_range v proper_v). pose proof (angle_range d proper_d).
  unfold in_tangent_set. cbn [of incoming outgoing].
  destruct (ccw_spec (Direction d label) (Direction u (other label)) (Direction v (other label))
              proper_d proper_u proper_v) as [between_ | not_between]; [reflexivity | exfalso].
  apply not_between. unfold in_order, earlier. cbn [vec]. unfold turn_to in range.
  destruct (Qlt_le_dec (angle d) (angle u)), (Qlt_le_dec (angle v) (angle u)); lra.
Qed.

(* By the tie rule, a direction of P that is equal to the edge that leaves a vertex of Q comes before it. *)
Lemma tangent_by_tie (f g v : vector) :
  nonzero f -> nonzero g -> nonzero v -> angle v == angle g -> ~ angle v == angle f ->
  in_tangent_set (Direction v OfP) (Corner f g) = true.
Proof.
  intros proper_f proper_g proper_v tie differ.
  unfold in_tangent_set. cbn [of incoming outgoing other].
  destruct (ccw_spec (Direction v OfP) (Direction f OfQ) (Direction g OfQ) proper_v proper_f proper_g)
    as [between_ | not_between]; [reflexivity | exfalso].
  apply not_between. unfold in_order, earlier, place. cbn [vec of]. lra.
Qed.

(* And a direction of Q that is equal to the edge that enters a vertex of P comes after it. *)
Lemma tangent_by_tie_of_q (u v f : vector) :
  nonzero u -> nonzero v -> nonzero f -> angle f == angle u -> ~ angle f == angle v ->
  in_tangent_set (Direction f OfQ) (Corner u v) = true.
Proof.
  intros proper_u proper_v proper_f tie differ.
  unfold in_tangent_set. cbn [of incoming outgoing other].
  destruct (ccw_spec (Direction f OfQ) (Direction u OfP) (Direction v OfP) proper_f proper_u proper_v)
    as [between_ | not_between]; [reflexivity | exfalso].
  apply not_between. unfold in_order, earlier, place. cbn [vec of]. lra.
Qed.

Lemma leads_inside_by_turn (u v n : vector) :
  nonzero u -> nonzero v -> nonzero n -> 0 < turn_to v n < turn_to v (opposite u) -> leads_inside u v n.
Proof.
  intros proper_u proper_v proper_n range.
  pose proof (turn_to_opposite v u proper_v proper_u) as back.
  pose proof (turn_from_another v u n proper_v proper_u proper_n) as u_to_n.
  pose proof (turn_from_another v u v proper_v proper_u proper_v) as u_to_v.
  pose proof (turn_to_itself v) as none.
  pose proof (turn_range v u proper_v proper_u). pose proof (turn_range v n proper_v proper_n).
  pose proof (side_by_turn v n proper_v proper_n) as v_n. pose proof (side_by_turn u n proper_u proper_n) as u_n.
  pose proof (side_by_turn u v proper_u proper_v) as u_v.
  unfold leads_inside. set (r := turn_to v u) in *. set (s := turn_to v n) in *.
  destruct (Qlt_le_dec (cross u v) 0); [right; split; [assumption |] |].
  - destruct (Qlt_le_dec 0 (cross v n)); [now right |]. left. lra.
  - left. lra.
Qed.

Section Corners.
  Variables u v f g : vector.
  Hypothesis proper_u : nonzero u.
  Hypothesis proper_v : nonzero v.
  Hypothesis proper_f : nonzero f.
  Hypothesis proper_g : nonzero g.

  Lemma turn_at_p : 0 < turn_to v (opposite u) ->
    (turn_to v (opposite u) <= 2 /\ turn_to u v == 2 - turn_to v (opposite u)) \/
    (2 < turn_to v (opposite u) /\ turn_to u v == 6 - turn_to v (opposite u)).
  Proof.
    pose proof (turn_range v u proper_v proper_u) as range.
    pose proof (turn_to_opposite v u proper_v proper_u) as back.
    pose proof (turn_from_another v u v proper_v proper_u proper_v) as turned_.
    rewrite turn_to_itself in turned_. lra.
  Qed.

  Lemma turn_of_f_to_v : 0 < turn_to v f -> turn_to f v == 4 - turn_to v f.
  Proof.
    pose proof (turn_from_another v f v proper_v proper_f proper_v) as turned_.
    rewrite turn_to_itself in turned_. lra.
  Qed.

  Lemma turn_of_u_to_g : turn_to v (opposite u) <= turn_to v (opposite g) ->
    turn_to u g == turn_to v (opposite g) - turn_to v (opposite u).
  Proof.
    pose proof (turn_range v u proper_v proper_u). pose proof (turn_range v g proper_v proper_g).
    pose proof (turn_to_opposite v u proper_v proper_u) as back.
    pose proof (turn_to_opposite v g proper_v proper_g) as back_g.
    pose proof (turn_from_another v u g proper_v proper_u proper_g) as turned_. lra.
  Qed.

  Lemma turn_at_q : turn_to v (opposite g) < turn_to v f ->
    let B := turn_to v f - turn_to v (opposite g) in
    (B <= 2 /\ turn_to f g == 2 - B) \/ (2 < B /\ turn_to f g == 6 - B).
  Proof.
    intros apart B.
    pose proof (turn_range v f proper_v proper_f). pose proof (turn_range v g proper_v proper_g).
    pose proof (turn_range f g proper_f proper_g).
    pose proof (turn_to_opposite v g proper_v proper_g) as back_g.
    pose proof (turn_from_another v f g proper_v proper_f proper_g) as turned_. unfold B. lra.
  Qed.

  Lemma reflected_v_inside : 0 < turn_to v f -> turn_to v f < turn_to v (opposite g) ->
    0 < turn_to g (opposite v) < turn_to g (opposite f).
  Proof.
    pose proof (turn_range v f proper_v proper_f). pose proof (turn_range v g proper_v proper_g) as range_g.
    pose proof (turn_to_opposite v g proper_v proper_g) as back_g.
    assert (to_v : 0 < turn_to v (opposite g) -> turn_to g (opposite v) == 4 - turn_to v (opposite g)).
    { pose proof (turn_to_opposite g v proper_g proper_v) as back_v.
      pose proof (turn_from_another v g v proper_v proper_g proper_v) as turned_.
      rewrite turn_to_itself in turned_. lra. }
    assert (to_f : turn_to v f < turn_to v (opposite g) ->
                   turn_to g (opposite f) == turn_to v f - turn_to v (opposite g) + 4).
    { clear to_v. pose proof (turn_to_opposite g f proper_g proper_f) as back_f.
      pose proof (turn_from_another v g f proper_v proper_g proper_f) as turned_. lra. }
    pose proof (turn_range v (opposite g) proper_v (opposite_nonzero g proper_g)). lra.
  Qed.

  (* If b comes within the turn from a to c, so does what is as far from a as c from b. *)
  Lemma turn_to_middle (a b c : vector) : nonzero a -> nonzero b -> nonzero c ->
    turn_to b c <= turn_to a c -> turn_to a b == turn_to a c - turn_to b c.
  Proof.
    intros proper_a proper_b proper_c. pose proof (turn_from_another a b c proper_a proper_b proper_c) as turned_.
    pose proof (turn_range a b proper_a proper_b). pose proof (turn_range b c proper_b proper_c). lra.
  Qed.

  Lemma turn_is_not_zero (a b : vector) : nonzero a -> nonzero b -> ~ angle a == angle b -> 0 < turn_to a b.
  Proof.
    intros proper_a proper_b differ. unfold turn_to.
    pose proof (angle_range a proper_a). pose proof (angle_range b proper_b).
    destruct (Qlt_le_dec (angle b) (angle a)); lra.
  Qed.

  Lemma not_turned_back (a b : vector) : turns a b -> ~ turn_to b (opposite a) == 0.
  Proof.
    intros (proper_a & proper_b & ahead) zero_.
    pose proof (turn_to_opposite b a proper_b proper_a) as back. pose proof (turn_range b a proper_b proper_a).
    pose proof (side_by_turn b a proper_b proper_a) as side_.
    assert (swapped : cross b a == - cross a b) by (unfold cross; ring).
    assert (dots : dot b a == dot a b) by (unfold dot; ring).
    assert (cross a b == 0) as along_ by lra. specialize (ahead along_). lra.
  Qed.

  (* Theorem. u and v are the edges that enter and leave a vertex of P, f and g those of a vertex of Q. Then
     - the edge g reversed leads from the one vertex inside P, or v reversed from the other inside Q, or
     - an edge of one is in the tangent set of the vertex of the other, and that vertex is convex, or
     - v and f, or u and g, have the same direction, or v and g opposite ones. *)
  Theorem touching_corners : turns u v -> turns f g ->
    ~ angle v == angle f -> ~ angle u == angle g -> ~ angle v == angle (opposite g) ->
    leads_inside u v (opposite g) \/ leads_inside f g (opposite v) \/
    (0 < cross u v /\ (in_tangent_set (Direction g OfQ) (Corner u v) = true \/
                       in_tangent_set (Direction f OfQ) (Corner u v) = true)) \/
    (0 < cross f g /\ (in_tangent_set (Direction u OfP) (Corner f g) = true \/
                       in_tangent_set (Direction v OfP) (Corner f g) = true)).
  Proof.
    intros p_turns q_turns v_f u_g v_back.
    pose proof (opposite_nonzero g proper_g) as proper_og. pose proof (opposite_nonzero v proper_v) as proper_ov.
    pose proof (opposite_nonzero u proper_u) as proper_ou.
    pose proof (turn_is_not_zero v f proper_v proper_f v_f) as some_f.
    pose proof (turn_is_not_zero u g proper_u proper_g u_g) as some_g.
    pose proof (turn_is_not_zero v (opposite g) proper_v proper_og v_back) as some_og.
    pose proof (turn_range v (opposite u) proper_v proper_ou) as range_A.
    pose proof (not_turned_back u v p_turns) as some_A.
    destruct (Qlt_le_dec (turn_to v (opposite g)) (turn_to v (opposite u))) as [inside_p | outside_p].
    { left. apply leads_inside_by_turn; trivial. lra. }
    destruct (Qlt_le_dec (turn_to v f) (turn_to v (opposite g))) as [inside_q | outside_q].
    { right. left. apply leads_inside_by_turn; trivial. now apply reflected_v_inside. }
    assert (apart_q : turn_to v (opposite g) < turn_to v f).
    { pose proof (turn_to_opposite v g proper_v proper_g) as back_g.
      pose proof (turn_from_another v f g proper_v proper_f proper_g) as f_to_g.
      pose proof (side_by_turn f g proper_f proper_g) as side_. destruct q_turns as (_ & _ & ahead).
      destruct (Qlt_le_dec (turn_to v (opposite g)) (turn_to v f)) as [| none]; [assumption | exfalso].
      assert (turn_to f g == 2) as back by (clear side_; lra).
      assert (cross f g == 0) as along_ by lra. specialize (ahead along_). lra. }
    right. right.
    pose proof (turn_at_p ltac:(lra)) as at_p. pose proof (turn_at_q apart_q) as at_q. cbv zeta in at_q.
    pose proof (turn_of_f_to_v some_f) as gap_1. pose proof (turn_of_u_to_g outside_p) as gap_2.
    pose proof (turn_range v f proper_v proper_f) as range_f.
    set (A := turn_to v (opposite u)) in *. set (B := turn_to v f - turn_to v (opposite g)) in *.
    assert (p_convex : A < 2 -> 0 < cross u v /\ turn_to u v == 2 - A).
    { intros small. pose proof (side_by_turn u v proper_u proper_v) as side_. clear at_q gap_1 gap_2. lra. }
    assert (q_convex : B < 2 -> 0 < cross f g /\ turn_to f g == 2 - B).
    { intros small. pose proof (side_by_turn f g proper_f proper_g) as side_.
      assert (0 < B) by (unfold B; lra). clear at_p gap_1 gap_2. lra. }
    clear at_p at_q.
    destruct (Qlt_le_dec A 2) as [convex_p | reflex_p].
    { destruct (p_convex convex_p) as [side_ turn_].
      destruct (Qlt_le_dec (turn_to u g) (turn_to u v)) as [g_in | g_out].
      { left. split; [exact side_ |]. left. apply tangent_by_turn; trivial. cbn [vec incoming outgoing]. lra. }
      destruct (Qlt_le_dec (turn_to f v) (turn_to u v)) as [f_in | f_out].
      { left. split; [exact side_ |]. right. apply tangent_by_turn; trivial. cbn [vec incoming outgoing].
        pose proof (turn_to_middle u f v proper_u proper_f proper_v). lra. }
      right. destruct (Qlt_le_dec B 2) as [convex_q | reflex_q]; [| exfalso; unfold B in *; lra].
      destruct (q_convex convex_q) as [side_q turn_q]. split; [exact side_q |].
      destruct (Qlt_le_dec (turn_to u g) (turn_to f g)) as [u_in | u_out].
      { left. apply tangent_by_turn; trivial. cbn [vec incoming outgoing].
        pose proof (turn_to_middle f u g proper_f proper_u proper_g). lra. }
      right. destruct (Qlt_le_dec (turn_to f v) (turn_to f g)) as [v_in | v_out].
      { apply tangent_by_turn; trivial. cbn [vec incoming outgoing]. lra. }
      destruct (Qeq_dec (turn_to f v) (turn_to f g)) as [tie | no_tie].
      - apply tangent_by_tie; trivial.
        pose proof (angle_range v proper_v) as of_v. pose proof (angle_range g proper_g) as of_g.
        pose proof (angle_range f proper_f) as of_f. unfold turn_to in tie. clear - tie of_v of_g of_f.
        destruct (Qlt_le_dec (angle v) (angle f)), (Qlt_le_dec (angle g) (angle f)); lra.
      - exfalso. unfold B in *. lra. }
    right. destruct (Qlt_le_dec B 2) as [convex_q | reflex_q]; [| exfalso; unfold B in *; lra].
    destruct (q_convex convex_q) as [side_q turn_q]. split; [exact side_q |].
    destruct (Qlt_le_dec (turn_to u g) (turn_to f g)) as [u_in | u_out].
    { left. apply tangent_by_turn; trivial. cbn [vec incoming outgoing].
      pose proof (turn_to_middle f u g proper_f proper_u proper_g). lra. }
    right. apply tangent_by_turn; trivial. cbn [vec incoming outgoing]. unfold B in *. lra.
  Qed.
End Corners.
