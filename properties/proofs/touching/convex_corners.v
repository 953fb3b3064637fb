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

Lemma reflex_and_tangent (d f g : vector) (label : summand) :
  cross f g < 0 -> 0 < cross d g -> in_tangent_set (Direction d label) (Corner f g) = true.
Proof.
  intros reflex left_. assert (proper : nonzero d /\ nonzero f /\ nonzero g)
    by (split; [| split]; intros [X Y]; unfold cross in *; rewrite X, Y in *; lra).
  destruct proper as (proper_d & proper_f & proper_g).
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
  Hypothesis r_region : valid_region r.
  Hypothesis long : nonzero e.
  Hypothesis on_boundary : exists s, In s (region_edges r) /\ lies_on w s.
  Hypothesis one_side : forall s, In s (region_edges r) ->
    (departs w s = true -> 0 < cross e (along s)) /\ (arrives w s = true -> cross e (along s) < 0).

  Let not_points : no_edges_are_points r := proj1 r_region.

  Definition vertices_at : Z := sum_of (fun v => Z.b2z (same_place w (fst v))) (region_vertices r).

  Lemma sides_at_a_corner (v : vector) (c : corner) : In (v, c) (region_vertices r) -> equal_vectors w v ->
    cross e (incoming c) < 0 /\ 0 < cross e (outgoing c).
  Proof.
    intros I equal. destruct (edges_of_vertex v c r I) as ((s & S & s_end & <-) & (t & T & t_start & <-)). split.
    - apply (one_side s S), arrives_at_its_target; [now apply (region_edges_are_directions r) | now rewrite s_end].
    - apply (one_side t T), departs_from_its_source; [now apply (region_edges_are_directions r) | now rewrite t_start].
  Qed.

  Lemma outgoing_edges_depart (y : vector) :
    sum_of (fun v => Z.b2z (same_place w (fst v)) * Z.b2z (positive (cross y (outgoing (snd v)))))%Z
      (region_vertices r) = departures_left_of w y r.
  Proof.
    (* counted by vertices and by edges, of those to the left of e *)
    pose proof (vertices_at_a_point r w (fun v => - (Z.b2z (positive (cross e v)) * Z.b2z (positive (cross y v))))%Z)
      as counted.
    transitivity (sum_of (fun v => Z.b2z (same_place w (fst v)) *
      (- (Z.b2z (positive (cross e (incoming (snd v)))) * Z.b2z (positive (cross y (incoming (snd v))))) -
       - (Z.b2z (positive (cross e (outgoing (snd v)))) * Z.b2z (positive (cross y (outgoing (snd v)))))))%Z
      (region_vertices r)); [| rewrite counted]; apply sum_equally.
    - intros [v c] I. cbn [fst snd]. destruct (same_place_spec w v) as [equal |]; [| reflexivity].
      destruct (sides_at_a_corner v c I equal). destruct (positive_spec (cross e (incoming c))); [exfalso; lra |].
      destruct (positive_spec (cross e (outgoing c))); [| contradiction]. cbn [Z.b2z]. lia.
    - intros s I. destruct (one_side s I) as [ahead behind].
      destruct (departs w s), (arrives w s); try specialize (ahead eq_refl); try specialize (behind eq_refl);
        destruct (positive_spec (cross e (along s))); cbn [Z.b2z]; try lia; exfalso; lra.
  Qed.

  (* It does not turn back, so it is convex, if it is not reflex. *)
  Lemma not_reflex_is_convex (f g : vector) : turns f g -> cross e f < 0 -> 0 < cross e g -> 0 <= cross f g ->
    0 < cross f g.
  Proof.
    intros (long_f & _ & ahead) right_f left_g not_reflex. apply Qnot_le_lt. intros flat.
    assert (parallel : cross f g == 0) by lra. specialize (ahead parallel). pose proof (square_positive f long_f).
    assert (identity : cross e g * dot f f == cross e f * dot f g + cross f g * dot e f) by (unfold cross, dot; ring).
    rewrite parallel in identity. nra.
  Qed.

  (* Theorem. The direction -e leads inside, or one of the vertices at w is convex and has e in its tangent set. *)
  Theorem convex_corner : eventually (fun k => inside (moved_along w (opposite e) k) r \/
    exists chain i, In chain r /\ (i < length chain)%nat /\ equal_vectors w (vertex chain i) /\
      convex (corner_of_chain chain i) /\
      forall label, in_tangent_set (Direction e label) (corner_of_chain chain i) = true).
  Proof.
    destruct (some_square w r) as (radius & near).
    assert (turned_ : forall v, cross (opposite e) v == - cross e v)
      by (intros; unfold cross, opposite; cbn [vx vy]; ring).
    assert (clear_back : clear_direction w (opposite e) r).
    { apply general_directions_are_clear. intros s S on. rewrite turned_. destruct (one_side s S) as [ahead behind].
      destruct (departs_or_arrives w s (region_edges_are_directions r not_points s S) on) as [there | there];
        [specialize (ahead there) | specialize (behind there)]; lra. }
    refine (eventually_implied _ _ _
      (small_steps_are_clear r w (opposite e) radius near (opposite_nonzero e long) clear_back)).
    intros k (clear_z & proper_z & left_z). set (z := scaled_by k (opposite e)) in *.
    destruct (inside_or_nothing_there r w z _ radius r_region near clear_z proper_z) as [| nothing_there];
      [now left | right].
    destruct (one_or_all (exists v c, In (v, c) (region_vertices r) /\ equal_vectors w v /\
        0 <= cross (incoming c) (outgoing c))
      (fun v => equal_vectors w (fst v) -> cross (incoming (snd v)) (outgoing (snd v)) < 0) (region_vertices r))
      as [(v & c & I & equal & left_) | reflex].
    { intros [v c] I. cbn [fst snd]. destruct (same_place_spec w v) as [equal | away]; [| right; contradiction].
      destruct (Qlt_le_dec (cross (incoming c) (outgoing c)) 0) as [| left_]; [now right | left; now exists v, c]. }
    - destruct (sides_at_a_corner v c I equal) as [right_in left_out].
      apply in_flat_map in I. destruct I as (chain & J & I). apply (In_nth _ _ (nowhere, Corner nowhere nowhere)) in I.
      destruct I as (i & below & v_is). rewrite combine_length, corners_length in below.
      rewrite combine_nth in v_is by (symmetry; apply corners_length). injection v_is as v_is c_is.
      exists chain, i. split; [exact J |]. split; [lia |]. unfold vertex. rewrite v_is. split; [exact equal |].
      unfold corner_of_chain. rewrite c_is. split.
      + apply not_reflex_is_convex; trivial. apply (chains_turn_everywhere r chain r_region J). rewrite <- c_is.
        apply nth_In. rewrite corners_length. lia.
      + intros label. apply tangent_between; cbn [vec]; [unfold cross in *; lra | exact left_out].
    - exfalso.
      destruct (inner_direction r w z radius r_region (proj1 near) proper_z on_boundary)
        as (y & near_y & _ & aside & general_y & round).
      assert (proper_y : nonzero y) by (intros [X Y]; apply aside; unfold cross; rewrite X, Y; ring).
      assert (sums : total_around r w OfP z (opposite (opposite e)) = total_around r w OfP y (opposite y)).
      { apply (same_in_all_directions r w OfP radius not_points near); trivial. split; [exact near_y |].
        split; [now apply general_directions_are_clear |]. split; [now apply opposite_nonzero |].
        apply same_direction_reflexive. }
      assert (none_left : departures_left_of w (opposite e) r = 0%Z).
      { apply sum_of_zeros. intros s S. destruct (departs w s) eqn:d; [| reflexivity].
        pose proof (proj1 (one_side s S) d). pose proof (turned_ (along s)).
        destruct (positive_spec (cross (opposite e) (along s))); [exfalso; lra | reflexivity]. }
      assert (at_most : (tangents_at w (Direction (opposite (opposite e)) OfP) r <= vertices_at)%Z).
      { apply sum_is_at_most. intros v _. unfold if_tangent.
        destruct (same_place w (fst v)), (in_tangent_set _ (snd v)); discriminate. }
      assert (at_least : (vertices_at <= tangents_at w (Direction (opposite y) OfP) r + departures_left_of w y r)%Z).
      { rewrite <- outgoing_edges_depart. unfold vertices_at, tangents_at. rewrite <- sum_plus.
        apply sum_is_at_most. intros [v c] I. cbn [fst snd].
        destruct (same_place_spec w v) as [equal | _]; [| discriminate]. cbn [Z.b2z].
        pose proof (reflex (v, c) I equal) as right_. cbn [fst snd] in right_. unfold if_tangent.
        destruct (positive_spec (cross y (outgoing c))) as [| not_left];
          [destruct (in_tangent_set _ c); discriminate |].
        assert (aside_c : ~ cross y (outgoing c) == 0).
        { destruct (edges_of_vertex v c r I) as (_ & (t & T & t_start & <-)). apply (general_y t T).
          apply (lies_on_equal (source t)); [rewrite t_start; now symmetry | apply source_lies_on]. }
        destruct c as [f g]. cbn [incoming outgoing] in *.
        rewrite (reflex_and_tangent (opposite y) f g); [discriminate | exact right_ |].
        unfold cross, opposite in *; cbn [vx vy]. lra. }
      unfold total_around in sums. lia.
  Qed.
End Corners.
