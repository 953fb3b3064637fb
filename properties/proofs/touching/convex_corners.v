(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* All edges at a point w of a region are on one side of a line through w in the direction e, and on the other side is
   nothing. Then a vertex at w is convex and has e in its tangent set, also if chains touch there. For all vertices at w
   have e in their tangent sets; so by fan_at_a_point.v, in every direction y, the vertices that have -y, the edges to
   the left of y, and the winding number are together no more than the vertices at w. Reflex vertices have -y in their
   tangent sets, or their edge leaves to the left of y. So if all were reflex, no winding number would be left. *)
From Coq Require Import ZArith Lia Bool List.
From Oplus Require Import numbers convolution signed_crossings tie_rule regions weight finite_sums tangent_count
  meeting_of_segments neighbourhoods beside_every_point winding_number_of_the_sum interiors_meet left_of_an_edge
  theorem_4_2_1 simple_chain rotation boundary_points reduced_convolution tangent_direction edges_at_a_point
  fan_at_a_point fans_that_touch.
Import ListNotations.

Open Scope Q_scope.

Lemma reflex_and_tangent (d f g : vector) (label : summand) : nonzero d -> nonzero f -> nonzero g ->
  cross f g < 0 -> 0 < cross d g -> in_tangent_set (Direction d label) (Corner f g) = true.
Proof.
  intros proper_d proper_f proper_g reflex left_.
  destruct (left_by_angles d g proper_d proper_g) as [d_to_g _]. specialize (d_to_g left_).
  pose proof (cross_angle f g proper_f proper_g) as f_to_g. unfold turns_by in f_to_g.
  pose proof (angle_range f proper_f). pose proof (angle_range g proper_g). pose proof (angle_range d proper_d).
  assert (turn : -2 < angle g - angle f < 0 \/ 2 < angle g - angle f) by lra. clear f_to_g reflex left_.
  unfold in_tangent_set. cbn [of incoming outgoing].
  destruct (ccw_spec (Direction d label) (Direction f (other label)) (Direction g (other label))
    proper_d proper_f proper_g) as [| not_between]; [reflexivity | exfalso].
  apply not_between. unfold in_order, earlier. cbn [vec]. lra.
Qed.

Section Corners.
  Variable r : region.
  Variables w e : vector.
  Variable radius : Q.
  Hypothesis r_region : valid_region r.
  Hypothesis near : nothing_else_near w radius r.
  Hypothesis long : nonzero e.
  Hypothesis on_boundary : exists s, In s (region_edges r) /\ lies_on w s.
  Hypothesis one_side : forall s, In s (region_edges r) -> lies_on w s ->
    (departs w s = true -> 0 < cross e (along s)) /\ (arrives w s = true -> cross e (along s) < 0).
  Variable k : Q.
  Let z := Vector (k * vx (opposite e)) (k * vy (opposite e)).
  Hypothesis some : 0 < k.
  Hypothesis near_z : within radius w (plus w z).
  Hypothesis nothing_there : winding_number (plus w z) (region_edges r) = 0%Z.

  Let not_points : no_edges_are_points r := proj1 r_region.

  Definition vertices_at : Z := sum_of (fun v => Z.b2z (same_place w (fst v))) (region_vertices r).

  Lemma corner_at (v : vector) (c : corner) : In (v, c) (region_vertices r) -> equal_vectors w v ->
    nonzero (incoming c) /\ nonzero (outgoing c) /\ cross e (incoming c) < 0 /\ 0 < cross e (outgoing c).
  Proof.
    intros I equal. destruct (edges_of_vertex v c r I) as ((s & S & s_end & <-) & (t & T & t_start & <-)).
    pose proof (region_edges_are_directions r not_points s S) as long_s.
    pose proof (region_edges_are_directions r not_points t T) as long_t.
    split; [exact long_s |]. split; [exact long_t |].
    assert (on_s : lies_on w s).
    { apply (lies_on_equal (target s)); [rewrite s_end; now symmetry | apply target_lies_on]. }
    assert (on_t : lies_on w t).
    { apply (lies_on_equal (source t)); [rewrite t_start; now symmetry | apply source_lies_on]. }
    destruct equal as [X Y]. split.
    - apply (one_side s S on_s), arrives_is. split; [exact on_s |]. intros [X' Y']. apply long_s.
      unfold along, minus. rewrite s_end. cbn [vx vy]. lra.
    - apply (one_side t T on_t), departs_is. split; [exact on_t |]. intros [X' Y']. apply long_t.
      unfold along, minus. rewrite t_start. cbn [vx vy]. lra.
  Qed.

  Lemma outgoing_edges_depart (y : vector) :
    (sum_of (fun v => Z.b2z (same_place w (fst v)) * Z.b2z (positive (cross y (outgoing (snd v)))))
      (region_vertices r) <= departures_left_of w y r)%Z.
  Proof.
    unfold departures_left_of, region_vertices, region_edges. rewrite !sum_of_flat_map.
    apply sum_is_at_most. intros chain J.
    rewrite vertices_by_index, (sum_by_index _ _ no_segment _ (length chain)) by apply edges_are_as_many.
    apply sum_is_at_most. intros i I. apply in_seq in I. assert (below : (i < length chain)%nat) by lia.
    cbn [fst snd]. rewrite corner_is by exact below. cbn [outgoing]. rewrite direction_by_index by exact below.
    pose proof (edge_at_in_region r chain i J below) as S. unfold edge_at in S.
    pose proof (region_edges_are_directions r not_points _ S) as long_s.
    rewrite edge_by_index in * by exact below. set (s := Segment _ _) in *.
    destruct (same_place_spec w (nth i chain nowhere)) as [equal | _];
      [| destruct (departs w s), (positive (cross y (along s))); discriminate].
    assert (departing_ : departs w s = true).
    { apply departs_is. split.
      - apply (lies_on_equal (source s)); [now symmetry | apply source_lies_on].
      - intros [X Y]. destruct equal as [X' Y']. apply long_s. unfold along, minus; cbn [vx vy].
        change (source s) with (nth i chain nowhere). lra. }
    rewrite departing_. reflexivity.
  Qed.

  (* Theorem. One of the vertices at w is convex, and has e in its tangent set. *)
  Theorem convex_corner : exists chain i, In chain r /\ (i < length chain)%nat /\ equal_vectors w (vertex chain i) /\
    convex (corner_of_chain chain i) /\
    forall label, in_tangent_set (Direction e label) (corner_of_chain chain i) = true.
  Proof.
    assert (turned_ : forall v, cross z v == - (k * cross e v))
      by (intros; unfold z, cross, opposite; cbn [vx vy]; ring).
    assert (differ : forall s, In s (region_edges r) -> lies_on w s -> ~ cross e (along s) == 0).
    { intros s S on. destruct (one_side s S on) as [ahead behind].
      pose proof (region_edges_are_directions r not_points s S) as long_s.
      destruct (departs w s) eqn:d; [specialize (ahead eq_refl); lra |].
      destruct (arrives w s) eqn:a; [specialize (behind eq_refl); lra |].
      exfalso. unfold departs, arrives, comes_by in d, a. destruct (lies_on_dec w s); [| contradiction].
      destruct (same_place_spec w (target s)) as [[X Y] |], (same_place_spec w (source s)) as [[X' Y'] |];
        try discriminate.
      apply long_s. unfold along, minus; cbn [vx vy]. lra. }
    assert (clear_z : clear_direction w z r).
    { apply (general_directions_are_clear r w radius near z near_z). intros s S on flat. apply (differ s S on).
      rewrite turned_ in flat. apply (Qmult_inj_r _ _ k); lra. }
    destruct (one_or_all (exists v c, In (v, c) (region_vertices r) /\ equal_vectors w v /\
        0 <= cross (incoming c) (outgoing c))
      (fun v => equal_vectors w (fst v) -> cross (incoming (snd v)) (outgoing (snd v)) < 0) (region_vertices r))
      as [(v & c & I & equal & left_) | reflex].
    { intros [v c] I. cbn [fst snd]. destruct (same_place_spec w v) as [equal | away]; [| right; contradiction].
      destruct (Qlt_le_dec (cross (incoming c) (outgoing c)) 0) as [| left_]; [now right | left; now exists v, c]. }
    - destruct (corner_at v c I equal) as (long_in & long_out & right_in & left_out).
      apply in_flat_map in I. destruct I as (chain & J & I). apply (In_nth _ _ (nowhere, Corner nowhere nowhere)) in I.
      destruct I as (i & below & v_is). rewrite combine_length, corners_length in below.
      rewrite combine_nth in v_is by (symmetry; apply corners_length). injection v_is as v_is c_is.
      assert (I : (i < length chain)%nat) by lia.
      exists chain, i. split; [exact J |]. split; [exact I |]. unfold vertex. rewrite v_is. split; [exact equal |].
      unfold corner_of_chain. rewrite c_is. split.
      + (* it does not turn back *)
        assert (turn : turns (incoming c) (outgoing c)).
        { apply (chains_turn_everywhere r chain r_region J). rewrite <- c_is. apply nth_In.
          now rewrite corners_length. }
        destruct turn as (_ & _ & ahead). unfold convex.
        destruct (Qlt_le_dec 0 (cross (incoming c) (outgoing c))) as [| flat]; [assumption | exfalso].
        assert (parallel : cross (incoming c) (outgoing c) == 0) by lra. specialize (ahead parallel).
        pose proof (square_positive _ long_in) as square. set (f := incoming c) in *. set (g := outgoing c) in *.
        assert (identity : cross f g * dot f e + cross g e * dot f f + cross e f * dot f g == 0)
          by (unfold cross, dot; ring).
        assert (back : cross g e == - cross e g) by (unfold cross; ring). rewrite parallel, back in identity.
        assert (0 < cross e g * dot f f) by (apply Qmult_lt_0_compat; [exact left_out | exact square]).
        assert (0 < - cross e f * dot f g) by (apply Qmult_lt_0_compat; lra). lra.
      + intros label. apply tangent_between; cbn [vec]; [unfold cross in *; lra | exact left_out].
    - exfalso.
      assert (proper_z : nonzero z).
      { intros [X Y]. unfold z, opposite in X, Y; cbn [vx vy] in X, Y. apply long.
        split; apply (Qmult_inj_r _ _ k); lra. }
      destruct (inner_direction r w z radius r_region (proj1 near) proper_z on_boundary)
        as (y & near_y & _ & aside & general_y & round).
      pose proof (general_directions_are_clear r w radius near y near_y general_y) as clear_y.
      assert (proper_y : nonzero y) by (intros [X Y]; apply aside; unfold cross; rewrite X, Y; ring).
      assert (z_back : same_direction e (opposite z)).
      { exists (/ k). split; [now apply Qinv_lt_0_compat |]. unfold z, opposite; cbn [vx vy]. split; field; lra. }
      assert (y_back : same_direction (opposite y) (opposite y)) by (exists 1; split; [lra | split; ring]).
      assert (sums : (tangents_at w (Direction e OfP) r + departures_left_of w z r +
        winding_number (plus w z) (region_edges r) =
        tangents_at w (Direction (opposite y) OfP) r + departures_left_of w y r +
        winding_number (plus w y) (region_edges r))%Z).
      { destruct (Q_dec (cross z y) 0) as [[right_ | left_] | parallel]; [symmetry | | contradiction].
        - apply (same_in_all_directions r w OfP radius not_points near y z (opposite y) e); trivial;
            [unfold cross in *; lra | now apply opposite_nonzero].
        - apply (same_in_all_directions r w OfP radius not_points near z y e (opposite y)); trivial.
          now apply opposite_nonzero. }
      assert (none_left : departures_left_of w z r = 0%Z).
      { apply sum_of_zeros. intros s S. destruct (departs w s) eqn:d; [| reflexivity].
        pose proof (proj1 (proj1 (departs_is w s) d)) as on. pose proof (proj1 (one_side s S on) d) as left_.
        destruct (positive_spec (cross z (along s))) as [left' |]; [exfalso | reflexivity].
        rewrite turned_ in left'. assert (0 < k * cross e (along s)) by now apply Qmult_lt_0_compat. lra. }
      assert (at_most : (tangents_at w (Direction e OfP) r <= vertices_at)%Z).
      { apply sum_is_at_most. intros v _. unfold if_tangent.
        destruct (same_place w (fst v)), (in_tangent_set _ (snd v)); discriminate. }
      assert (at_least : (vertices_at <= tangents_at w (Direction (opposite y) OfP) r + departures_left_of w y r)%Z).
      { etransitivity; [| apply Z.add_le_mono_l, outgoing_edges_depart].
        unfold vertices_at, tangents_at. rewrite <- sum_plus. apply sum_is_at_most. intros [v c] I. cbn [fst snd].
        destruct (same_place_spec w v) as [equal | _]; [| discriminate]. cbn [Z.b2z].
        destruct (corner_at v c I equal) as (long_in & long_out & _). pose proof (reflex (v, c) I equal) as right_.
        cbn [fst snd] in right_. unfold if_tangent.
        destruct (positive_spec (cross y (outgoing c))) as [| not_left];
          [destruct (in_tangent_set _ c); discriminate |].
        assert (aside_c : ~ cross y (outgoing c) == 0).
        { destruct (edges_of_vertex v c r I) as (_ & (t & T & t_start & <-)). apply (general_y t T).
          apply (lies_on_equal (source t)); [rewrite t_start; now symmetry | apply source_lies_on]. }
        destruct c as [f g]. cbn [incoming outgoing] in *.
        rewrite (reflex_and_tangent (opposite y) f g); [discriminate | now apply opposite_nonzero | trivial .. |].
        unfold cross, opposite in *; cbn [vx vy]. lra. }
      lia.
  Qed.
End Corners.
