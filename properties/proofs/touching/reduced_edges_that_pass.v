(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Where an edge of one region passes a point of the other, the interiors do not meet, and x is no sum of two vertices,
   a segment of the reduced convolution that has the edge's direction covers x; chains may touch. No edge of the other
   leads across the edge. Either none lies along it, and a convex vertex has it in its tangent set
   (convex_corners.v); or both go on along each other to where one of them ends, at a convex vertex. *)
From Coq Require Import ZArith Lia Bool List.
From Oplus Require Import numbers convolution signed_crossings tie_rule regions weight finite_sums tangent_count
  meeting_of_segments neighbourhoods winding_number_of_the_sum interiors_meet left_of_an_edge theorem_4_2_1
  simple_chain lemma_2_2_2 definition_2_2_8 boundary_points reduced_convolution parallel_edges edges_at_a_point
  fan_at_a_point fans_that_touch edges_that_pass convex_corners.
Import ListNotations.

Open Scope Q_scope.

Lemma comes_from_behind (w : vector) (s : segment) : arrives w s = true ->
  eventually (fun t => lies_on (moved_along w (opposite (along s)) t) s).
Proof.
  intros arriving. apply arrives_is in arriving. destruct arriving as [(k & [k0 k1] & X & Y) comes].
  assert (after_start : 0 < k).
  { apply Qnot_le_lt. intros at_start. apply comes. assert (k_is : k == 0) by lra. rewrite k_is in X, Y.
    split; lra. }
  exists k. split; [exact after_start |]. intros t t0 t1. exists (k - t). split; [lra |].
  unfold moved_along, opposite, along, minus; cbn [vx vy]. rewrite X, Y. split; ring.
Qed.

Lemma passes_both_ways (r : region) (w : vector) (e : segment) : In e (region_edges r) -> lies_on w e ->
  ~ is_vertex w r -> departs w e = true /\ arrives w e = true.
Proof.
  intros E on no_vertex. split; [apply departs_is | apply arrives_is]; (split; [exact on |]); intros at_end;
    apply no_vertex.
  - destruct (target_is_vertex r e E) as (t & T & equal). exists t. split; [exact T | now rewrite at_end].
  - now exists e.
Qed.

Section Passing.
  Variables p q : region.
  Variables x w u : vector.
  Variable e : segment.
  Hypothesis p_region : valid_region p.
  Hypothesis q_region : valid_region q.
  Hypothesis outside : ~ interiors_meet x p q.
  Hypothesis sum_ : equal_vectors x (plus w u).
  Hypothesis E : In e (region_edges p).
  Hypothesis on_e : lies_on w e.
  Hypothesis no_vertex : ~ is_vertex w p.

  Let q_regular : is_regular q.
  Proof. destruct q_region as (q_edges & q_valid & q_meet). now apply regions_are_regular. Qed.

  (* Nothing of Q leads across the edge. *)
  Lemma nothing_leads_across (f : segment) (g : vector) : In f (region_edges q) ->
    eventually (fun t => lies_on (moved_along u g t) f) -> 0 <= cross (along e) g.
  Proof.
    intros F on_f. pose proof p_region as (p_edges & p_valid & p_meet). apply Qnot_lt_le. intros across.
    assert (left_ : 0 < cross (along e) (opposite g)) by (unfold cross, opposite in *; cbn [vx vy] in *; lra).
    apply outside.
    destruct (eventually_and _ _ (left_of_an_edge_is_inside p e w (opposite g) p_valid p_meet E on_e no_vertex left_)
      on_f) as (limit & L & close).
    destruct (close ((1 # 2) * limit)) as [in_p on]; [lra | lra |].
    apply (inner_point_and_point p q x _ _ q_regular in_p (or_intror (ex_intro _ f (conj F on)))).
    destruct sum_ as [X Y]. unfold plus, moved_along, opposite in *; cbn [vx vy] in *. split; cbn [vx vy]; lra.
  Qed.

  Lemma sides_of_edges (f : segment) : In f (region_edges q) -> lies_on u f ->
    (departs u f = true -> 0 <= cross (along e) (along f)) /\ (arrives u f = true -> cross (along e) (along f) <= 0).
  Proof.
    intros F on_f. split; intros there.
    - apply (nothing_leads_across f (along f) F). now apply goes_ahead_from.
    - pose proof (nothing_leads_across f (opposite (along f)) F (comes_from_behind u f there)) as side.
      unfold cross, opposite in *; cbn [vx vy] in *. lra.
  Qed.

  (* Nor does an edge of Q lie along it in the opposite direction. *)
  Lemma no_opposite_edge (f : segment) : In f (region_edges q) -> lies_on u f ->
    ~ same_direction (along e) (opposite (along f)).
  Proof.
    intros F on_f back. apply outside. destruct (passes_both_ways p w e E on_e no_vertex) as [e_departs e_arrives].
    destruct (departs u f) eqn:f_departs.
    { now apply (opposite_edges_meet p q x w u e f); trivial; apply goes_ahead_from. }
    assert (f_arrives : arrives u f = true).
    { apply arrives_is. split; [exact on_f |]. intros at_start.
      assert (at_end : equal_vectors u (target f)).
      { destruct (same_place_spec u (target f)) as [| away]; [assumption | exfalso].
        enough (departs u f = true) by congruence. now apply departs_is. }
      apply (region_edges_are_directions q (proj1 q_region) f F). destruct at_start, at_end.
      unfold along, minus; cbn [vx vy]. lra. }
    destruct back as (m & some & mx & my). unfold opposite in mx, my; cbn [vx vy] in mx, my.
    destruct (comes_from_behind w e e_arrives) as (l1 & L1 & behind_e).
    destruct (comes_from_behind u f f_arrives) as (l2 & L2 & behind_f).
    set (limit := if Qlt_le_dec (l1 * m) l2 then l1 * m else l2).
    assert (l1_some : 0 < l1 * m) by now apply Qmult_lt_0_compat.
    assert (bounds : 0 < limit /\ limit <= l1 * m /\ limit <= l2)
      by (unfold limit; destruct (Qlt_le_dec (l1 * m) l2); lra).
    clearbody limit. set (k := (1 # 2) * limit). assert (k_range : 0 < k /\ k < l1 * m /\ k < l2) by (unfold k; lra).
    clearbody k. assert (scaled : k / m * m == k) by (field; lra). set (h := k / m) in *.
    assert (h_range : 0 < h < l1).
    { split; apply Qnot_le_lt; intros extreme.
      - assert (0 <= - h * m) by (apply Qmult_le_0_compat; lra). lra.
      - assert (0 <= (h - l1) * m) by (apply Qmult_le_0_compat; lra). lra. }
    clearbody h. set (w' := moved_along w (opposite (along e)) h). set (u' := moved_along u (opposite (along f)) k).
    apply (opposite_edges_meet p q x w' u' e f); trivial.
    - destruct sum_ as [X Y]. unfold w', u', plus, moved_along, opposite in *; cbn [vx vy] in *.
      split; cbn [vx vy]; rewrite ?mx, ?my, <- ?scaled; lra.
    - exists m. unfold opposite; cbn [vx vy]. now rewrite mx, my.
    - exists h. split; [lra |]. intros t t0 t1. apply (lies_on_equal (moved_along w (opposite (along e)) (h - t))).
      + unfold w', moved_along, opposite; cbn [vx vy]. split; cbn [vx vy]; ring.
      + apply behind_e; lra.
    - exists k. split; [lra |]. intros t t0 t1. apply (lies_on_equal (moved_along u (opposite (along f)) (k - t))).
      + unfold u', moved_along, opposite; cbn [vx vy]. split; cbn [vx vy]; ring.
      + apply behind_f; lra.
  Qed.

  (* If none lies along it, a convex vertex is there. *)
  Lemma convex_vertex_there : (exists f, In f (region_edges q) /\ lies_on u f) ->
    (forall f, In f (region_edges q) -> lies_on u f -> ~ same_direction (along f) (along e)) ->
    exists chain i, In chain q /\ (i < length chain)%nat /\ equal_vectors u (vertex chain i) /\
      convex (corner_of_chain chain i) /\
      forall label, in_tangent_set (Direction (along e) label) (corner_of_chain chain i) = true.
  Proof.
    intros on_q no_common. pose proof p_region as (p_edges & p_valid & p_meet).
    pose proof q_region as (q_edges & q_valid & q_meet).
    pose proof (region_edges_are_directions p p_edges e E) as long.
    assert (aside : forall f, In f (region_edges q) -> lies_on u f -> ~ cross (along e) (along f) == 0).
    { intros f F on_f flat. pose proof (region_edges_are_directions q q_edges f F) as long_f.
      pose proof (no_common f F on_f) as differ. pose proof (no_opposite_edge f F on_f) as differ_back.
      rewrite same_direction_angle in differ, differ_back by (trivial; now apply opposite_nonzero).
      pose proof (cross_angle _ _ long long_f) as turn_. unfold turns_by in turn_.
      pose proof (opposite_angle _ long_f). pose proof (angle_range _ long). pose proof (angle_range _ long_f).
      pose proof (angle_range _ (opposite_nonzero _ long_f)). lra. }
    destruct (some_square u q) as (radius & near). pose proof near as [R _].
    destruct (passes_both_ways p w e E on_e no_vertex) as [e_departs _].
    destruct (eventually_and _ _ (small_steps_stay_within radius u (opposite (along e)) R)
      (goes_ahead_from w e e_departs)) as (limit & L & close).
    destruct (close ((1 # 2) * limit)) as [near_z on]; [lra | lra |].
    set (k := (1 # 2) * limit) in *. assert (some : 0 < k) by (unfold k; lra). clearbody k.
    set (z := Vector (k * vx (opposite (along e))) (k * vy (opposite (along e)))).
    change (moved_along u (opposite (along e)) k) with (plus u z) in near_z.
    assert (clear_z : clear_direction u z q).
    { apply (general_directions_are_clear q u radius near z near_z). intros f F on_f flat. apply (aside f F on_f).
      apply (Qmult_inj_r _ _ k); [lra |]. transitivity (- cross z (along f)); [| lra].
      unfold z, cross, opposite; cbn [vx vy]. ring. }
    apply (convex_corner q u (along e) radius q_region near long on_q) with (k := k); trivial.
    - intros f F on_f. destruct (sides_of_edges f F on_f) as [ahead behind]. pose proof (aside f F on_f).
      split; intros there; [specialize (ahead there) | specialize (behind there)]; lra.
    - destruct clear_z as [off_z _]. pose proof (q_valid _ off_z).
      destruct (Z_lt_le_dec 0 (winding_number (plus u z) (region_edges q))) as [round | none]; [exfalso | fold z; lia].
      apply outside, interiors_meet_other_way.
      apply (inner_point_and_point q p x (plus u z) (moved_along w (along e) k)
        (regions_are_regular p p_edges p_valid p_meet)); [now split | |].
      + right. now exists e.
      + destruct sum_ as [X Y]. unfold plus, moved_along, z, opposite in *; cbn [vx vy] in *. split; cbn [vx vy]; lra.
  Qed.
End Passing.

Lemma at_vertex_of_chain (r : region) (chain : list vector) i (w : vector) : no_edges_are_points r -> In chain r ->
  (i < length chain)%nat -> equal_vectors w (vertex chain i) ->
  is_vertex w r /\ lies_on w (edge_at chain i) /\ departs w (edge_at chain i) = true /\
  lies_on w (edge_at chain (previous (length chain) i)) /\ arrives w (edge_at chain (previous (length chain) i)) = true.
Proof.
  intros not_points J I equal. pose proof (previous_below _ _ I) as before_.
  set (s := edge_at chain i). set (t := edge_at chain (previous (length chain) i)).
  assert (starts : equal_vectors w (source s)) by (unfold s; now rewrite edge_at_is).
  assert (ends : equal_vectors w (target t)) by (unfold t; rewrite edge_at_is, next_previous; trivial).
  pose proof (edge_at_in_region r chain i J I) as S. pose proof (edge_at_in_region r chain _ J before_) as T.
  pose proof (region_edges_are_directions r not_points _ S) as long_s. fold s in S, long_s.
  pose proof (region_edges_are_directions r not_points _ T) as long_t. fold t in T, long_t.
  assert (on_s : lies_on w s) by (apply (lies_on_equal (source s)); [now symmetry | apply source_lies_on]).
  assert (on_t : lies_on w t) by (apply (lies_on_equal (target t)); [now symmetry | apply target_lies_on]).
  split; [now exists s |]. split; [exact on_s |]. split; [| split; [exact on_t |]].
  - apply departs_is. split; [exact on_s |]. intros [X Y]. destruct starts. apply long_s.
    unfold along, minus; cbn [vx vy]. lra.
  - apply arrives_is. split; [exact on_t |]. intros [X Y]. destruct ends. apply long_t.
    unfold along, minus; cbn [vx vy]. lra.
Qed.

(* Edges that turn, and not to the right. *)
Lemma turns_to_the_left (f g : vector) : turns f g -> ~ angle f == angle g -> 0 <= cross f g -> 0 < cross f g.
Proof.
  intros (long_f & long_g & ahead) differ side. apply Qnot_le_lt. intros flat.
  assert (parallel : cross f g == 0) by lra. specialize (ahead parallel).
  pose proof (cross_angle f g long_f long_g) as turn_. unfold turns_by in turn_. lra.
Qed.

Lemma point_along_is_on (chain : list vector) i t : (i < length chain)%nat -> 0 <= t <= 1 ->
  lies_on (point_along chain i t) (edge_at chain i).
Proof.
  intros I range. exists t. split; [exact range |]. unfold point_along. rewrite edge_at_is, edge_of_chain_is by exact I.
  unfold vertex, minus. cbn [source target vx vy]. split; ring.
Qed.

Section Covered.
  Variables p q : region.
  Variable x : vector.
  Hypothesis p_region : valid_region p.
  Hypothesis q_region : valid_region q.
  Hypothesis outside : ~ interiors_meet x p q.
  Hypothesis no_vertices : forall w u, is_vertex w p -> is_vertex u q -> ~ equal_vectors x (plus w u).

  Let p_edges : no_edges_are_points p := proj1 p_region.
  Let q_edges : no_edges_are_points q := proj1 q_region.
  Let outside' : ~ interiors_meet x q p.
  Proof. intros meet. apply outside. now apply interiors_meet_other_way. Qed.
  Let swapped (w u : vector) : equal_vectors x (plus w u) -> equal_vectors x (plus u w).
  Proof. intros [X Y]. unfold plus in *; cbn [vx vy] in *. split; cbn [vx vy]; lra. Qed.

  (* The tie rule gives a segment at a convex vertex. *)
  Lemma ties_are_reduced (a b : list vector) (d : vector) : In a p -> In b q -> nonzero d ->
    on_a_tie a b d x -> reduced_along p q x d.
  Proof.
    intros A B proper_d (i & j & t & I & J & range & f_is & cases).
    pose proof (chains_turn_everywhere p a p_region A) as turning_p.
    pose proof (chains_turn_everywhere q b q_region B) as turning_q.
    assert (corner_turns : forall chain k, turns_everywhere chain -> (k < length chain)%nat ->
      turns (edge_of_chain chain (previous (length chain) k)) (edge_of_chain chain k)).
    { intros chain k turning K. pose proof (turning (corner_of_chain chain k)) as turn.
      rewrite corner_is in turn by exact K. apply turn.
      rewrite <- corner_is by exact K. unfold corner_of_chain. apply nth_In. now rewrite corners_length. }
    pose proof (corner_turns a i turning_p I) as turn_a. pose proof (corner_turns b j turning_q J) as turn_b.
    clear corner_turns. pose proof (previous_below _ _ I) as I'. pose proof (previous_below _ _ J) as J'.
    destruct cases as [(e_is & turn & x_is) | (e_is & turn & x_is)].
    - set (w := point_along a i t) in *. set (u := vertex b j) in *.
      destruct (at_vertex_of_chain q b j u q_edges B J) as (u_vertex & _ & _ & on_f & f_arrives);
        [split; reflexivity |].
      assert (no_vertex : ~ is_vertex w p) by (intros w_vertex; now apply (no_vertices w u)).
      pose proof (edge_at_in_region p a i A I) as E. pose proof (edge_at_in_region q b _ B J') as F.
      pose proof (proj2 (sides_of_edges p q x w u _ p_region q_region outside x_is E (point_along_is_on a i t I range)
        no_vertex _ F on_f) f_arrives) as side.
      unfold edge_at in side. rewrite <- !direction_by_index in side by assumption.
      set (e := edge_of_chain a i) in *. set (g := edge_of_chain b j) in *.
      set (f := edge_of_chain b (previous (length b) j)) in *.
      assert (long_e : nonzero e) by (apply edge_nonzero; trivial; now apply p_edges).
      assert (long_g : nonzero g) by apply turn_b.
      assert (same_ : angle g == angle e) by lra. pose proof same_ as ratio.
      apply same_direction_angle in ratio; trivial. destruct ratio as (m & some & mx & my).
      assert (is_convex : convex (corner_of_chain b j)).
      { unfold convex. rewrite corner_is by exact J. cbn [incoming outgoing]. apply turns_to_the_left; trivial.
        fold f g. setoid_replace (cross f g) with (m * - cross e f) by (unfold cross; rewrite mx, my; ring).
        apply Qmult_le_0_compat; lra. }
      apply (reduced_along_same p q x e); [apply same_direction_angle; trivial; exact e_is |].
      apply (reduced_along_by_p p q a b A B x i j I J); trivial.
      + apply (segment_of_p a b turning_p turning_q i j I J). right. split; [now symmetry | exact turn].
      + apply (lies_on_equal w); [| now apply point_along_is_on]. destruct x_is as [X Y].
        unfold w, u, vertex, plus, minus in *; cbn [vx vy] in *. split; cbn [vx vy]; lra.
    - set (w := vertex a i) in *. set (u := point_along b j t) in *.
      destruct (at_vertex_of_chain p a i w p_edges A I) as (w_vertex & on_e & e_departs & _); [split; reflexivity |].
      assert (no_vertex : ~ is_vertex u q) by (intros u_vertex; now apply (no_vertices w u)).
      pose proof (edge_at_in_region p a i A I) as E. pose proof (edge_at_in_region q b j B J) as F.
      pose proof (proj1 (sides_of_edges q p x u w _ q_region p_region outside' (swapped _ _ x_is) F
        (point_along_is_on b j t J range) no_vertex _ E on_e) e_departs) as side.
      unfold edge_at in side. rewrite <- !direction_by_index in side by assumption.
      set (e := edge_of_chain a i) in *. set (g := edge_of_chain b j) in *.
      set (f := edge_of_chain a (previous (length a) i)) in *.
      assert (long_g : nonzero g) by apply turn_b. assert (long_f : nonzero f) by apply turn_a.
      assert (same_ : angle f == angle g) by lra. pose proof same_ as ratio.
      apply same_direction_angle in ratio; trivial. destruct ratio as (m & some & mx & my).
      assert (is_convex : convex (corner_of_chain a i)).
      { unfold convex. rewrite corner_is by exact I. cbn [incoming outgoing]. apply turns_to_the_left; trivial.
        fold f e. setoid_replace (cross f e) with (m * cross g e) by (unfold cross; rewrite mx, my; ring).
        apply Qmult_le_0_compat; lra. }
      apply (reduced_along_same p q x g); [apply same_direction_angle; trivial; exact f_is |].
      apply (reduced_along_by_q p q a b A B x i j I J); trivial.
      + apply (segment_of_q a b turning_p turning_q i j I J). right. split; [now symmetry | exact turn].
      + apply (lies_on_equal u); [| now apply point_along_is_on]. destruct x_is as [X Y].
        unfold w, u, vertex, plus, minus in *; cbn [vx vy] in *. split; cbn [vx vy]; lra.
  Qed.

  Lemma parallel_edges_are_reduced (w u : vector) (e f : segment) : In e (region_edges p) -> In f (region_edges q) ->
    lies_on w e -> lies_on u f -> equal_vectors x (plus w u) -> angle (along e) == angle (along f) ->
    reduced_along p q x (along e).
  Proof.
    intros E F on_e on_f sum_ same_. pose proof (region_edges_are_directions p p_edges e E) as long.
    destruct (edge_by_chain p e E) as (a & i & A & I & ->), (edge_by_chain q f F) as (b & j & B & J & ->).
    destruct (on_by_index a i w I on_e) as (t & t_range & w_is), (on_by_index b j u J on_f) as (o & o_range & u_is).
    apply (ties_are_reduced a b); trivial. unfold edge_at in *. rewrite <- !direction_by_index in * by assumption.
    apply (sum_along_two_edges a b (chains_turn_everywhere p a p_region A) (chains_turn_everywhere q b q_region B)
      i j t o); trivial.
    rewrite sum_. now apply plus_of_equal.
  Qed.

  (* Theorem. Where an edge of P passes through x, by a point inside it and any point of Q, a segment of the reduced
     convolution of its direction covers x. *)
  Theorem passing_edges_of_p_are_covered (w u : vector) (e : segment) : In e (region_edges p) -> lies_on w e ->
    ~ is_vertex w p -> in_region u q -> equal_vectors x (plus w u) -> reduced_along p q x (along e).
  Proof.
    intros E on_e no_vertex in_q sum_. pose proof (region_edges_are_directions p p_edges e E) as long.
    destruct (boundary_or_meet p q x w u e p_region E on_e sum_ in_q) as [on_q | meet]; [| contradiction].
    destruct (some_or_no_common_direction q u (along e) q_edges long) as [(f & F & on_f & same_) | none].
    { symmetry in same_. now apply (parallel_edges_are_reduced w u e f). }
    destruct (convex_vertex_there p q x w u e) as (b & j & B & J & at_vertex & is_convex & tangent); trivial.
    destruct (edge_by_chain p e E) as (a & i & A & I & ->). specialize (tangent OfP).
    unfold edge_at in tangent |- *. rewrite <- direction_by_index in * by exact I.
    apply (reduced_along_by_p p q a b A B x i j I J tangent is_convex).
    apply (lies_on_equal w); [| exact on_e]. destruct sum_ as [X Y], at_vertex as [X' Y'].
    unfold vertex, plus, minus in *; cbn [vx vy] in *. split; cbn [vx vy]; lra.
  Qed.

  (* And where an edge of Q does. *)
  Theorem passing_edges_of_q_are_covered (u w : vector) (f : segment) : In f (region_edges q) -> lies_on u f ->
    ~ is_vertex u q -> in_region w p -> equal_vectors x (plus u w) -> reduced_along p q x (along f).
  Proof.
    intros F on_f no_vertex in_p sum_. pose proof (region_edges_are_directions q q_edges f F) as long.
    destruct (boundary_or_meet q p x u w f q_region F on_f sum_ in_p) as [on_p | meet]; [| contradiction].
    destruct (some_or_no_common_direction p w (along f) p_edges long) as [(e & E & on_e & same_) | none].
    { apply (reduced_along_same p q x (along e)).
      - apply same_direction_angle; trivial. now apply (region_edges_are_directions p).
      - apply (parallel_edges_are_reduced w u e f); trivial. destruct sum_ as [X Y].
        unfold plus in *; cbn [vx vy] in *. split; cbn [vx vy]; lra. }
    destruct (convex_vertex_there q p x u w f) as (a & i & A & I & at_vertex & is_convex & tangent); trivial.
    destruct (edge_by_chain q f F) as (b & j & B & J & ->). specialize (tangent OfQ).
    unfold edge_at in tangent |- *. rewrite <- direction_by_index in * by exact J.
    apply (reduced_along_by_q p q a b A B x i j I J tangent is_convex).
    apply (lies_on_equal u); [| exact on_f]. destruct sum_ as [X Y], at_vertex as [X' Y'].
    unfold vertex, plus, minus in *; cbn [vx vy] in *. split; cbn [vx vy]; lra.
  Qed.

  (* So where P and -Q + x have a point in common, x is on the reduced convolution. *)
  Theorem common_point_is_on_the_reduced_convolution : in_sum x p q -> on_reduced_convolution x p q.
  Proof.
    intros (w & u & in_p & in_q & sum_).
    assert (found : forall d, reduced_along p q x d -> on_reduced_convolution x p q)
      by (intros d (s & S & on & _); now exists s).
    pose proof p_region as (_ & p_valid & p_meet). pose proof q_region as (_ & q_valid & q_meet).
    destruct (inside_or_on_boundary w p in_p) as [inside_p | (e & E & on_e)].
    { exfalso. apply outside, (inner_point_and_point p q x w u); trivial. now apply regions_are_regular. }
    destruct (inside_or_on_boundary u q in_q) as [inside_q | (f & F & on_f)].
    { exfalso. apply outside', (inner_point_and_point q p x u w); auto. now apply regions_are_regular. }
    destruct (vertex_or_not w p) as [w_vertex | no_vertex].
    - destruct (vertex_or_not u q) as [u_vertex | no_vertex];
        [exfalso; exact (no_vertices w u w_vertex u_vertex sum_) |].
      apply (found (along f)). apply (passing_edges_of_q_are_covered u w f); auto.
    - apply (found (along e)). now apply (passing_edges_of_p_are_covered w u e).
  Qed.
End Covered.
