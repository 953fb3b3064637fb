(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Where an edge of one region passes a point of the other, and the interiors do not meet, a segment of the reduced
   convolution that has the edge's direction covers x; and if only P and -Q + x have a point in common, some segment of
   it does. Chains may touch, but not at vertices of P and Q that add up to x. By edges_that_pass.v, a convex vertex
   has the edge in its tangent set, or edges lie along each other. These go on along each other to where one of them
   ends, at a convex vertex: to the left of the edges at a vertex that is not convex and that no other chain touches
   all is inside, so no edge of the other leads across. *)
From Coq Require Import ZArith Lia Bool List.
From Oplus Require Import numbers convolution signed_crossings tie_rule convolution_winding regions weight finite_sums
  tangent_count meeting_of_segments neighbourhoods winding_number_of_the_sum interiors_meet left_of_an_edge
  theorem_4_2_1 simple_chain definition_2_2_8 inside_a_corner boundary_points reduced_convolution edges_at_a_point
  fan_at_a_point fans_that_touch edges_that_pass.
Import ListNotations.

Open Scope Q_scope.

(* If w is a vertex, no other edges come there. *)
Definition alone (w : vector) (r : region) : Prop :=
  forall chain i, In chain r -> (i < length chain)%nat -> equal_vectors w (vertex chain i) ->
    meet_in_vertex (edge_at chain (previous (length chain) i)) (edge_at chain i) r.

Lemma alone_if_chains_do_not_touch (w : vector) (r : region) : chains_do_not_touch r -> alone w r.
Proof. intros apart chain i C I _. now apply apart. Qed.

Lemma convex_or_fills_left (r : region) (chain : list vector) i (w : vector) :
  valid_region r -> In chain r -> (i < length chain)%nat -> equal_vectors w (vertex chain i) -> alone w r ->
  let f := edge_of_chain chain (previous (length chain) i) in let g := edge_of_chain chain i in
  0 < cross f g \/ (cross f g <= 0 /\ fills_left w f r /\ fills_left w g r).
Proof.
  intros r_region C I at_vertex alone_ f g. destruct (Qlt_le_dec 0 (cross f g)) as [| not_convex]; [now left | right].
  split; [exact not_convex |]. unfold f, g in *.
  rewrite !direction_by_index in * by (trivial; now apply previous_below).
  assert (same_place_ : forall d, fills_left (source (edge_at chain i)) d r -> fills_left w d r).
  { intros d (radius & R & fills). exists radius. split; [exact R |]. destruct at_vertex as [X Y].
    unfold vertex in X, Y. rewrite edge_at_is in fills by exact I. cbn [source] in fills. intros z close left_.
    apply fills; unfold within, cross, minus in *; cbn [vx vy] in *; rewrite <- X, <- Y; assumption. }
  destruct (fills_left_at_a_vertex r _ _ r_region (alone_ chain i C I at_vertex) not_convex) as [fills_f fills_g].
  split; now apply same_place_.
Qed.

Lemma at_vertex_of_chain (r : region) (chain : list vector) i (w : vector) : no_edges_are_points r -> In chain r ->
  (i < length chain)%nat -> equal_vectors w (vertex chain i) ->
  is_vertex w r /\ departs w (edge_at chain i) = true /\ arrives w (edge_at chain (previous (length chain) i)) = true.
Proof.
  intros not_points C I equal. pose proof (previous_below _ _ I) as before_.
  pose proof (edge_at_in_region r chain i C I) as S. pose proof (edge_at_in_region r chain _ C before_) as T.
  pose proof (region_edges_are_directions r not_points _ S) as long_s.
  pose proof (region_edges_are_directions r not_points _ T) as long_t.
  assert (starts : equal_vectors w (source (edge_at chain i))) by (now rewrite edge_at_is).
  split; [now exists (edge_at chain i) |]. split; [now apply departs_from_its_source |].
  apply arrives_at_its_target; trivial. rewrite edge_at_is, next_previous; trivial.
Qed.

Lemma corner_turns (r : region) (chain : list vector) i : valid_region r -> In chain r -> (i < length chain)%nat ->
  turns (edge_of_chain chain (previous (length chain) i)) (edge_of_chain chain i).
Proof.
  intros r_region C I. pose proof (chains_turn_everywhere r chain r_region C (corner_of_chain chain i)) as turn.
  rewrite corner_is in turn by exact I. apply turn. rewrite <- corner_is by exact I. unfold corner_of_chain.
  apply nth_In. now rewrite corners_length.
Qed.

Lemma point_along_is_on (chain : list vector) i t : (i < length chain)%nat -> 0 <= t <= 1 ->
  lies_on (point_along chain i t) (edge_at chain i).
Proof.
  intros I range. exists t. split; [exact range |]. unfold point_along. rewrite edge_at_is, edge_of_chain_is by exact I.
  unfold vertex, minus. cbn [source target vx vy]. split; ring.
Qed.

Lemma before_the_end (chain : list vector) i t : nonzero (edge_of_chain chain i) -> (i < length chain)%nat ->
  0 <= t <= 1 -> (t < 1 -> departs (point_along chain i t) (edge_at chain i) = true) /\
  (0 < t -> arrives (point_along chain i t) (edge_at chain i) = true).
Proof.
  intros long I range. rewrite departs_is, arrives_is. pose proof (point_along_is_on chain i t I range) as on.
  split; intros inside_; (split; [exact on |]); intros [X Y]; apply long; rewrite edge_at_is in X, Y by exact I;
    unfold point_along in X, Y; rewrite edge_of_chain_is in * by exact I; unfold vertex, minus in *;
    cbn [source target vx vy] in *.
  - split; apply (Qmult_inj_r _ _ (1 - t)); lra.
  - split; apply (Qmult_inj_r _ _ t); lra.
Qed.

Section Covered.
  Variables p q : region.
  Variable x : vector.
  Hypothesis p_region : valid_region p.
  Hypothesis q_region : valid_region q.
  Hypothesis outside : ~ interiors_meet x p q.
  Hypothesis alone_where_they_meet : forall w u, is_vertex w p -> is_vertex u q -> equal_vectors x (plus w u) ->
    alone w p /\ alone u q.

  Let p_edges : no_edges_are_points p := proj1 p_region.
  Let q_edges : no_edges_are_points q := proj1 q_region.
  Let outside' : ~ interiors_meet x q p.
  Proof. intros meet. apply outside. now apply interiors_meet_other_way. Qed.

  (* Where edge i of P and vertex j of Q add up to x, and the edge that leaves the vertex has the edge's direction. *)
  Lemma ties_at_vertices_of_q (a b : list vector) i j t : In a p -> In b q -> (i < length a)%nat ->
    (j < length b)%nat -> 0 <= t <= 1 -> angle (edge_of_chain b j) == angle (edge_of_chain a i) ->
    ~ straight_at b j -> equal_vectors x (plus (point_along a i t) (vertex b j)) ->
    reduced_along p q x (edge_of_chain a i).
  Proof.
    intros A B I J range same_ turn x_is.
    pose proof (chains_turn_everywhere p a p_region A) as turning_p.
    pose proof (chains_turn_everywhere q b q_region B) as turning_q.
    set (w := point_along a i t) in *. set (u := vertex b j) in *. set (e := edge_of_chain a i) in *.
    set (g := edge_of_chain b j) in *. set (f := edge_of_chain b (previous (length b) j)) in *.
    assert (long_e : nonzero e) by (apply edge_nonzero; auto).
    pose proof (corner_turns q b j q_region B J) as (long_f & long_g & ahead). fold f g in long_f, long_g, ahead.
    pose proof same_ as ratio. apply same_direction_angle in ratio; trivial. destruct ratio as (m & some & mx & my).
    assert (value : cross f g == m * cross f e) by (unfold cross; rewrite mx, my; ring).
    destruct (Qlt_le_dec 0 (cross f g)) as [is_convex | not_convex].
    { apply (covered_by_index p q x a b A B OfP i j t I J range); trivial.
      - apply (segment_of_p a b turning_p turning_q i j I J). right. split; [now symmetry | exact turn].
      - unfold convex, vertex_corner. cbn [fst snd]. now rewrite corner_is. }
    assert (reflex : cross f e < 0).
    { apply Qnot_le_lt. intros none. assert (flat : cross f g == 0) by nra. specialize (ahead flat).
      apply turn. unfold straight_at. fold f g. pose proof (cross_angle f g long_f long_g) as by_angle.
      unfold turns_by in by_angle. lra. }
    pose proof (edge_at_in_region p a i A I) as E. pose proof (edge_at_in_region q b _ B (previous_below _ _ J)) as F.
    destruct (at_vertex_of_chain q b j u q_edges B J) as (u_vertex & _ & f_arrives); [split; reflexivity |].
    assert (not_filled : ~ fills_left w e p).
    { intros fills. pose proof (proj2 (sides_of_edges p q x w u e _ q_region outside x_is fills F) f_arrives) as side.
      unfold edge_at in side. rewrite <- direction_by_index in side by (now apply previous_below). fold f in side.
      unfold cross in *. lra. }
    destruct (vertex_or_not w p) as [w_vertex | no_vertex].
    2: { exfalso. apply not_filled. unfold e. rewrite direction_by_index by exact I.
         apply fills_left_beside_an_edge; trivial. now apply point_along_is_on. }
    destruct (alone_where_they_meet w u w_vertex u_vertex x_is) as [w_alone u_alone].
    destruct (convex_or_fills_left q b j u q_region B J) as [is_convex | (_ & fills & _)]; trivial;
      [split; reflexivity | fold f g in is_convex; lra | fold f in fills].
    destruct (Qlt_le_dec t 1) as [before_end | at_end].
    - exfalso. destruct (before_the_end a i t long_e I range) as [departing _].
      pose proof (proj1 (sides_of_edges q p x u w f _ p_region outside' (sum_in_other_order _ _ _ x_is) fills E)
        (departing before_end)) as side.
      unfold edge_at in side. rewrite <- direction_by_index in side by exact I. fold e in side. lra.
    - (* where the edge of P ends is a convex vertex *)
      pose proof (next_in_range _ _ I) as I'. pose proof (previous_next _ _ I) as back.
      assert (w_is : equal_vectors w (vertex a (next i (length a)))).
      { unfold w. rewrite <- (along_all a i I). apply along_of_equal. lra. }
      destruct (convex_or_fills_left p a _ w p_region A I' w_is w_alone) as [is_convex | (_ & fills_e & _)];
        rewrite back in *; [| exfalso; exact (not_filled fills_e)].
      apply (covered_in_the_same_direction _ x g); [now exists m |].
      apply (covered_by_index p q x a b A B OfQ (next i (length a)) j 0 I' J); [lra | | |].
      + apply (segment_of_q a b turning_p turning_q _ j I' J). right. rewrite back. split; [exact same_ |].
        intros straight. fold e in is_convex, straight. apply same_direction_angle in straight; trivial;
          [| now apply edge_nonzero; auto]. destruct straight as (c & _ & X & Y). unfold cross in is_convex.
        rewrite X, Y in is_convex. lra.
      + rewrite x_is. apply plus_of_equal; [exact w_is | symmetry; apply along_nothing].
      + unfold convex, vertex_corner. cbn [fst snd]. rewrite corner_is, back by exact I'. exact is_convex.
  Qed.

  (* Where vertex i of P and edge j of Q do, and the edge that enters the vertex has the edge's direction. *)
  Lemma ties_at_vertices_of_p (a b : list vector) i j t : In a p -> In b q -> (i < length a)%nat ->
    (j < length b)%nat -> 0 <= t <= 1 ->
    angle (edge_of_chain a (previous (length a) i)) == angle (edge_of_chain b j) ->
    ~ straight_at a i -> equal_vectors x (plus (vertex a i) (point_along b j t)) ->
    reduced_along p q x (edge_of_chain b j).
  Proof.
    intros A B I J range same_ turn x_is.
    pose proof (chains_turn_everywhere p a p_region A) as turning_p.
    pose proof (chains_turn_everywhere q b q_region B) as turning_q.
    set (w := vertex a i) in *. set (u := point_along b j t) in *. set (e := edge_of_chain a i) in *.
    set (g := edge_of_chain b j) in *. set (f := edge_of_chain a (previous (length a) i)) in *.
    assert (long_g : nonzero g) by (apply edge_nonzero; auto).
    pose proof (corner_turns p a i p_region A I) as (long_f & long_e & ahead). fold f e in long_f, long_e, ahead.
    pose proof same_ as ratio. apply same_direction_angle in ratio; trivial. destruct ratio as (m & some & mx & my).
    assert (value : cross f e == m * cross g e) by (unfold cross; rewrite mx, my; ring).
    destruct (Qlt_le_dec 0 (cross f e)) as [is_convex | not_convex].
    { apply (covered_by_index p q x a b A B OfQ i j t I J range); trivial.
      - apply (segment_of_q a b turning_p turning_q i j I J). right. split; [now symmetry | exact turn].
      - unfold convex, vertex_corner. cbn [fst snd]. now rewrite corner_is. }
    assert (reflex : cross g e < 0).
    { apply Qnot_le_lt. intros none. assert (flat : cross f e == 0) by nra. specialize (ahead flat).
      apply turn. unfold straight_at. fold f e. pose proof (cross_angle f e long_f long_e) as by_angle.
      unfold turns_by in by_angle. lra. }
    pose proof (edge_at_in_region p a i A I) as E. pose proof (edge_at_in_region q b j B J) as F.
    destruct (at_vertex_of_chain p a i w p_edges A I) as (w_vertex & e_departs & _); [split; reflexivity |].
    assert (not_filled : ~ fills_left u g q).
    { intros fills. pose proof (proj1 (sides_of_edges q p x u w g _ p_region outside' (sum_in_other_order _ _ _ x_is)
        fills E) e_departs) as side.
      unfold edge_at in side. rewrite <- direction_by_index in side by exact I. fold e in side. lra. }
    destruct (vertex_or_not u q) as [u_vertex | no_vertex].
    2: { exfalso. apply not_filled. unfold g. rewrite direction_by_index by exact J.
         apply fills_left_beside_an_edge; trivial. now apply point_along_is_on. }
    destruct (alone_where_they_meet w u w_vertex u_vertex x_is) as [w_alone u_alone].
    destruct (convex_or_fills_left p a i w p_region A I) as [is_convex | (_ & _ & fills)]; trivial;
      [split; reflexivity | fold f e in is_convex; lra | fold e in fills].
    destruct (Qlt_le_dec 0 t) as [after_start | at_start].
    - exfalso. destruct (before_the_end b j t long_g J range) as [_ arriving].
      pose proof (proj2 (sides_of_edges p q x w u e _ q_region outside x_is fills F) (arriving after_start)) as side.
      unfold edge_at in side. rewrite <- direction_by_index in side by exact J. fold g in side. unfold cross in *. lra.
    - (* where the edge of Q begins is a convex vertex *)
      pose proof (previous_below _ _ I) as I'.
      assert (u_is : equal_vectors u (vertex b j)).
      { unfold u. rewrite <- (along_nothing b j). apply along_of_equal. lra. }
      destruct (convex_or_fills_left q b j u q_region B J u_is u_alone) as [is_convex | (_ & _ & fills_g)];
        [| exfalso; exact (not_filled fills_g)].
      apply (covered_in_the_same_direction _ x f); [now exists m |].
      apply (covered_by_index p q x a b A B OfP (previous (length a) i) j 1 I' J); [lra | | |].
      + apply (segment_of_p a b turning_p turning_q _ j I' J). right. split; [exact same_ |].
        intros straight. fold g in is_convex, straight. apply same_direction_angle in straight; trivial;
          [| now apply edge_nonzero; [auto | apply previous_below]]. destruct straight as (c & _ & X & Y).
        unfold cross in is_convex. rewrite X, Y in is_convex. lra.
      + rewrite x_is. apply plus_of_equal; [symmetry; now apply along_the_edge_before | exact u_is].
      + unfold convex, vertex_corner. cbn [fst snd]. rewrite corner_is by exact J. exact is_convex.
  Qed.

  Lemma ties_are_reduced (a b : list vector) (d : vector) : In a p -> In b q -> nonzero d ->
    on_a_tie a b d x -> reduced_along p q x d.
  Proof.
    intros A B proper_d (i & j & t & I & J & range & f_is & [(e_is & turn & x_is) | (e_is & turn & x_is)]).
    - apply (covered_in_the_same_direction _ x (edge_of_chain a i)).
      + apply same_direction_angle; trivial. apply edge_nonzero; auto.
      + apply (ties_at_vertices_of_q a b i j t); trivial. now rewrite f_is.
    - apply (covered_in_the_same_direction _ x (edge_of_chain b j)).
      + apply same_direction_angle; trivial. apply edge_nonzero; auto.
      + apply (ties_at_vertices_of_p a b i j t); trivial. now rewrite e_is.
  Qed.

  (* Edges with all to their left inside near the point. *)
  Lemma filled_edges_of_p_are_covered (w u : vector) (e : segment) : In e (region_edges p) -> departs w e = true ->
    fills_left w (along e) p -> in_region u q -> equal_vectors x (plus w u) -> reduced_along p q x (along e).
  Proof.
    intros E e_departs fills in_q sum_.
    destruct (edge_of_p_passes p q x w u p_region q_region outside sum_ e) as [(a & b & A & B & tie) |]; trivial.
    apply (ties_are_reduced a b); trivial. now apply (region_edges_are_directions p).
  Qed.

  Lemma filled_edges_of_q_are_covered (u w : vector) (f : segment) : In f (region_edges q) -> departs u f = true ->
    fills_left u (along f) q -> in_region w p -> equal_vectors x (plus w u) -> reduced_along p q x (along f).
  Proof.
    intros F f_departs fills in_p sum_.
    destruct (edge_of_q_passes p q x w u p_region q_region outside sum_ f) as [(a & b & A & B & tie) |]; trivial.
    apply (ties_are_reduced a b); trivial. now apply (region_edges_are_directions q).
  Qed.

  (* Theorem. Where an edge of P passes through x, by a point inside it and any point of Q, a segment of the reduced
     convolution of its direction covers x. *)
  Theorem passing_edges_of_p_are_covered (w u : vector) (e : segment) : In e (region_edges p) -> lies_on w e ->
    ~ is_vertex w p -> in_region u q -> equal_vectors x (plus w u) -> reduced_along p q x (along e).
  Proof.
    intros E on_e no_vertex in_q sum_. apply (filled_edges_of_p_are_covered w u); trivial.
    - now apply (passes_both_ways p w e).
    - now apply fills_left_beside_an_edge.
  Qed.

  (* And where an edge of Q does. *)
  Theorem passing_edges_of_q_are_covered (u w : vector) (f : segment) : In f (region_edges q) -> lies_on u f ->
    ~ is_vertex u q -> in_region w p -> equal_vectors x (plus u w) -> reduced_along p q x (along f).
  Proof.
    intros F on_f no_vertex in_p sum_. apply (filled_edges_of_q_are_covered u w); trivial.
    - now apply (passes_both_ways q u f).
    - now apply fills_left_beside_an_edge.
    - now apply sum_in_other_order.
  Qed.

  (* Theorem. Where P and -Q + x have a point in common, x is on the reduced convolution: it is on a segment of the
     convolution (fans_that_touch.v), and if the vertex of this is not convex, an edge that leaves it passes. *)
  Theorem common_point_is_on_the_reduced_convolution : in_sum x p q -> on_reduced_convolution x p q.
  Proof.
    intros common.
    assert (found : forall d, reduced_along p q x d -> on_reduced_convolution x p q)
      by (intros d (s & S & on & _); now exists s).
    destruct (on_or_off x (convolution_segments p q)) as [(s & S & on) | free];
      [| exfalso; now apply outside, common_point_off_the_convolution].
    apply in_map_iff in S. destruct S as (named & <- & S).
    destruct (proj1 (on_segments_of_regions p q x)) as (a & b & A & B & i & j & t & I & J & range & segment);
      [now exists named |].
    assert (in_p : forall k h, (k < length a)%nat -> 0 <= h <= 1 -> in_region (point_along a k h) p).
    { intros k h K. right. exists (edge_at a k). split; [now apply edge_at_in_region | now apply point_along_is_on]. }
    assert (in_q : forall k h, (k < length b)%nat -> 0 <= h <= 1 -> in_region (point_along b k h) q).
    { intros k h K. right. exists (edge_at b k). split; [now apply edge_at_in_region | now apply point_along_is_on]. }
    destruct segment as [[belongs x_is] | [belongs x_is]].
    - set (w := point_along a i t) in *. set (u := vertex b j) in *.
      destruct (at_vertex_of_chain q b j u q_edges B J) as (u_vertex & departing & _); [split; reflexivity |].
      destruct (vertex_or_not w p) as [w_vertex | no_vertex].
      + destruct (convex_or_fills_left q b j u q_region B J) as [is_convex | (_ & _ & fills)];
          [split; reflexivity | now apply (alone_where_they_meet w u) | |].
        * apply (found (edge_of_chain a i)).
          apply (covered_by_index p q x a b A B OfP i j t I J range belongs x_is).
          unfold convex, vertex_corner. cbn [fst snd]. now rewrite corner_is.
        * apply (found (along (edge_at b j))). apply (filled_edges_of_q_are_covered u w); trivial;
            [now apply edge_at_in_region | | now apply in_p]. unfold edge_at. now rewrite <- direction_by_index.
      + apply (found (along (edge_at a i))). apply (passing_edges_of_p_are_covered w u); trivial;
          [now apply edge_at_in_region | now apply point_along_is_on |].
        right. exists (edge_at b j). split; [now apply edge_at_in_region | now apply departs_is in departing].
    - set (w := vertex a i) in *. set (u := point_along b j t) in *.
      destruct (at_vertex_of_chain p a i w p_edges A I) as (w_vertex & departing & _); [split; reflexivity |].
      destruct (vertex_or_not u q) as [u_vertex | no_vertex].
      + destruct (convex_or_fills_left p a i w p_region A I) as [is_convex | (_ & _ & fills)];
          [split; reflexivity | now apply (alone_where_they_meet w u) | |].
        * apply (found (edge_of_chain b j)).
          apply (covered_by_index p q x a b A B OfQ i j t I J range belongs x_is).
          unfold convex, vertex_corner. cbn [fst snd]. now rewrite corner_is.
        * apply (found (along (edge_at a i))). apply (filled_edges_of_p_are_covered w u); trivial;
            [now apply edge_at_in_region | | now apply in_q]. unfold edge_at. now rewrite <- direction_by_index.
      + apply (found (along (edge_at b j))). apply (passing_edges_of_q_are_covered u w); trivial;
          [now apply edge_at_in_region | now apply point_along_is_on | | now apply sum_in_other_order].
        right. exists (edge_at a i). split; [now apply edge_at_in_region | now apply departs_is in departing].
  Qed.
End Covered.
