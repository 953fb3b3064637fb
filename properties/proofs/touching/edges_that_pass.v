(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Theorem 2.2.10, its second part: where an edge of P passes a point of Q in the placement -Q + x, at a point of the
   edge that is no vertex, and the interiors of P and -Q + x do not meet, x is on a segment of the convolution that has
   the edge's direction; and where an edge of Q passes a point of P. Chains may touch. By fan_at_a_point.v: otherwise
   an edge of Q leads across the edge, to where P's inside is. *)
From Coq Require Import ZArith Lia Bool List.
From Oplus Require Import numbers convolution signed_crossings tie_rule convolution_winding regions weight finite_sums
  tangent_count tracing meeting_of_segments neighbourhoods winding_number_of_the_sum interiors_meet left_of_an_edge
  theorem_4_2_1 simple_chain definition_2_2_8 boundary_points parallel_edges edges_at_a_point fan_at_a_point
  fans_that_touch.
Import ListNotations.

Open Scope Q_scope.

(* A segment of the convolution of the direction d covers x. *)
Definition covered_along (p q : region) (x d : vector) : Prop :=
  exists s, In s (convolution_segments p q) /\ lies_on x s /\ same_direction (along s) d.

Lemma covered_by_index (p q : region) (x d : vector) (a b : list vector) :
  no_edges_are_points p -> no_edges_are_points q -> nonzero d -> In a p -> In b q ->
  on_a_segment_along a b d x -> covered_along p q x d.
Proof.
  intros p_edges q_edges proper_d A B (i & j & t & I & J & range & cases).
  assert (found : forall summand e, is_convolution_segment a b summand i j = true -> nonzero e -> angle e == angle d ->
    (let s := ((a, b), (summand, (i, j))) in
     equal_vectors (minus (ends_at s) (starts_at s)) e /\ lies_on x (Segment (starts_at s) (ends_at s))) ->
    covered_along p q x d).
  { intros summand e belongs proper_e same_ [[X Y] on].
    set (s := ((a, b), (summand, (i, j)))) in *. exists (Segment (starts_at s) (ends_at s)). split; [| split].
    - apply (in_map (fun s => Segment (starts_at s) (ends_at s))). apply in_flat_map. exists (a, b).
      split; [now apply in_prod |]. unfold s. apply in_map.
      apply (in_those (length a) (length b) (in_convolution a b)). now split.
    - exact on.
    - apply same_direction_angle in same_; trivial. destruct same_ as (m & some & mx & my). exists m.
      unfold along. cbn [source target]. rewrite X, Y. now split. }
  destruct cases as [(belongs & same_ & x_is) | (belongs & same_ & x_is)].
  - apply (found OfP (edge_of_chain a i)); trivial; [apply edge_nonzero; trivial; now apply p_edges |].
    cbv zeta. rewrite lies_on_a_segment_of by assumption. split; [| now exists t].
    rewrite edge_of_chain_is by exact I. unfold starts_at, ends_at, point_of, state_before, state_after, step.
    unfold plus, minus. cbn [fst snd vx vy]. split; cbn [vx vy]; ring.
  - apply (found OfQ (edge_of_chain b j)); trivial; [apply edge_nonzero; trivial; now apply q_edges |].
    cbv zeta. rewrite lies_on_a_segment_of by assumption. split; [| now exists t].
    rewrite edge_of_chain_is by exact J. unfold starts_at, ends_at, point_of, state_before, state_after, step.
    unfold plus, minus. cbn [fst snd vx vy]. split; cbn [vx vy]; ring.
Qed.

(* Whether an edge at u has the direction of e is decided. *)
Lemma some_or_no_common_direction (r : region) (u d : vector) : no_edges_are_points r -> nonzero d ->
  (exists f, In f (region_edges r) /\ lies_on u f /\ angle (along f) == angle d) \/
  (forall f, In f (region_edges r) -> lies_on u f -> ~ same_direction (along f) d).
Proof.
  intros not_points proper_d.
  destruct (one_or_all (exists f, In f (region_edges r) /\ lies_on u f /\ angle (along f) == angle d)
    (fun f => lies_on u f -> ~ same_direction (along f) d) (region_edges r)) as [some | none]; auto.
  intros f F. destruct (lies_on_dec u f) as [on | off_f]; [| right; contradiction].
  pose proof (region_edges_are_directions r not_points f F) as long.
  destruct (Qeq_dec (angle (along f)) (angle d)) as [same_ | differ]; [left; now exists f | right].
  intros _. now rewrite same_direction_angle.
Qed.

(* An edge that passes, of no direction of the edges there and in no tangent set there. *)
Lemma passing_edge_meets (p q : region) (x w u : vector) (e : segment) (label : summand) :
  valid_region p -> valid_region q -> In e (region_edges p) -> lies_on w e -> ~ is_vertex w p ->
  (exists f, In f (region_edges q) /\ lies_on u f) -> equal_vectors x (plus w u) ->
  (forall f, In f (region_edges q) -> lies_on u f -> ~ same_direction (along f) (along e)) ->
  tangents_at u (Direction (along e) label) q = 0%Z -> interiors_meet x p q.
Proof.
  intros p_region q_region E on no_vertex on_q sum_ no_common no_tangent.
  pose proof p_region as (p_edges & p_valid & p_meet). pose proof q_region as (q_edges & q_valid & q_meet).
  pose proof (regions_are_regular q q_edges q_valid q_meet) as q_regular.
  assert (e_departs : departs w e = true).
  { apply departs_is. split; [exact on |]. intros at_end. apply no_vertex.
    destruct (target_is_vertex p e E) as (t & T & equal). exists t. split; [exact T | now rewrite at_end]. }
  assert (swapped : equal_vectors x (plus u w))
    by (destruct sum_ as [X Y]; unfold plus in *; cbn [vx vy] in *; split; cbn [vx vy]; lra).
  destruct (half_beside_an_edge q p x u w e label) as [meet | half]; trivial; [now apply interiors_meet_other_way |].
  assert (some_left : (0 < departures_left_of u (opposite (along e)) q)%Z).
  { assert (0 <= departures u q)%Z; [| lia]. apply sum_is_not_negative. intros f _. now destruct (departs u f). }
  apply positive_sum in some_left. destruct some_left as (f & F & term).
  destruct (departs u f) eqn:f_departs; [| discriminate].
  destruct (positive_spec (cross (opposite (along e)) (along f))) as [across |]; [| discriminate].
  assert (left_ : 0 < cross (along e) (opposite (along f)))
    by (unfold cross, opposite in *; cbn [vx vy] in *; lra).
  destruct (eventually_and _ _
    (left_of_an_edge_is_inside p e w (opposite (along f)) p_valid p_meet E on no_vertex left_)
    (goes_ahead_from u f f_departs)) as (limit & L & close).
  destruct (close ((1 # 2) * limit)) as [in_p on_f]; [lra | lra |].
  apply (inner_point_and_point p q x _ _ q_regular in_p (or_intror (ex_intro _ f (conj F on_f)))).
  destruct sum_ as [X Y]. unfold plus, moved_along, opposite in *; cbn [vx vy] in *. split; cbn [vx vy]; lra.
Qed.

Lemma boundary_or_meet (p q : region) (x w u : vector) (e : segment) : valid_region p ->
  In e (region_edges p) -> lies_on w e -> equal_vectors x (plus w u) -> in_region u q ->
  (exists f, In f (region_edges q) /\ lies_on u f) \/ interiors_meet x p q.
Proof.
  intros (p_edges & p_valid & p_meet) E on_e [X Y] in_q.
  destruct (on_or_off u (region_edges q)) as [on_q | off_q]; [now left | right].
  apply interiors_meet_other_way, (inner_point_and_point q p x u w (regions_are_regular p p_edges p_valid p_meet)).
  - split; [exact off_q |]. destruct in_q as [positive_ | (s & S & on)]; [exact positive_ |].
    exfalso. exact (off_q s S on).
  - right. now exists e.
  - unfold plus in *; cbn [vx vy] in *. split; cbn [vx vy]; lra.
Qed.

Section Passing.
  Variables p q : region.
  Variables x w u : vector.
  Hypothesis p_region : valid_region p.
  Hypothesis q_region : valid_region q.
  Hypothesis sum_ : equal_vectors x (plus w u).

  Let p_edges : no_edges_are_points p := proj1 p_region.
  Let q_edges : no_edges_are_points q := proj1 q_region.

  Lemma common_direction_is_covered (e f : segment) : In e (region_edges p) -> In f (region_edges q) ->
    lies_on w e -> lies_on u f -> angle (along e) == angle (along f) -> covered_along p q x (along e).
  Proof.
    intros E F on_e on_f same_. pose proof (region_edges_are_directions p p_edges e E) as long.
    destruct (edge_by_chain p e E) as (a & i & A & I & ->), (edge_by_chain q f F) as (b & j & B & J & ->).
    destruct (on_by_index a i w I on_e) as (t & t_range & w_is), (on_by_index b j u J on_f) as (o & o_range & u_is).
    apply (covered_by_index p q x _ a b); trivial. unfold edge_at in *.
    rewrite <- !direction_by_index in * by assumption.
    pose proof (chains_turn_everywhere p a p_region A) as turning_p.
    pose proof (chains_turn_everywhere q b q_region B) as turning_q.
    apply (ties_are_segments a b turning_p turning_q), (sum_along_two_edges a b turning_p turning_q i j t o); trivial.
    rewrite sum_. now apply plus_of_equal.
  Qed.

  (* Theorem. An edge of P that passes. *)
  Theorem passing_edge_of_p_covers (e : segment) : In e (region_edges p) -> lies_on w e -> ~ is_vertex w p ->
    in_region u q -> interiors_meet x p q \/ covered_along p q x (along e).
  Proof.
    intros E on_e no_vertex in_q. pose proof (region_edges_are_directions p p_edges e E) as long.
    destruct (boundary_or_meet p q x w u e p_region E on_e sum_ in_q) as [on_q | meet]; [| now left].
    destruct (some_or_no_common_direction q u (along e) q_edges long) as [(f & F & on_f & same_) | none].
    { right. symmetry in same_. now apply (common_direction_is_covered e f). }
    destruct (tangent_vertex_or_none q u (Direction (along e) OfP))
      as [(b & j & B & J & at_vertex & tangent) | no_tangent].
    - right. destruct (edge_by_chain p e E) as (a & i & A & I & ->).
      destruct (on_by_index a i w I on_e) as (t & range & w_is).
      apply (covered_by_index p q x _ a b); trivial. exists i, j, t. unfold edge_at in *.
      rewrite <- !direction_by_index in * by assumption.
      split; [exact I |]. split; [exact J |]. split; [exact range |]. left. split; [exact tangent |].
      split; [reflexivity |]. rewrite sum_. now apply plus_of_equal.
    - left. now apply (passing_edge_meets p q x w u e OfP).
  Qed.

  (* Theorem. An edge of Q that passes. *)
  Theorem passing_edge_of_q_covers (f : segment) : In f (region_edges q) -> lies_on u f -> ~ is_vertex u q ->
    in_region w p -> interiors_meet x p q \/ covered_along p q x (along f).
  Proof.
    intros F on_f no_vertex in_p. pose proof (region_edges_are_directions q q_edges f F) as long.
    assert (swapped : equal_vectors x (plus u w))
      by (destruct sum_ as [X Y]; unfold plus in *; cbn [vx vy] in *; split; cbn [vx vy]; lra).
    destruct (boundary_or_meet q p x u w f q_region F on_f swapped in_p) as [on_p | meet];
      [| left; now apply interiors_meet_other_way].
    destruct (some_or_no_common_direction p w (along f) p_edges long) as [(e & E & on_e & same_) | none].
    { right. destruct (common_direction_is_covered e f E F on_e on_f same_) as (s & S & on & along_e). exists s.
      split; [exact S |]. split; [exact on |]. apply (same_direction_transitive _ (along e)); [exact along_e |].
      apply same_direction_angle; trivial. now apply (region_edges_are_directions p). }
    destruct (tangent_vertex_or_none p w (Direction (along f) OfQ))
      as [(a & i & A & I & at_vertex & tangent) | no_tangent].
    - right. destruct (edge_by_chain q f F) as (b & j & B & J & ->).
      destruct (on_by_index b j u J on_f) as (t & range & u_is).
      apply (covered_by_index p q x _ a b); trivial. exists i, j, t. unfold edge_at in *.
      rewrite <- !direction_by_index in * by assumption.
      split; [exact I |]. split; [exact J |]. split; [exact range |]. right. split; [exact tangent |].
      split; [reflexivity |]. rewrite sum_. now apply plus_of_equal.
    - left. apply interiors_meet_other_way. now apply (passing_edge_meets q p x u w f OfQ).
  Qed.
End Passing.

(* Theorem 2.2.10, second part. Where x is not in the open sum, but inside a segment of the vertex-edge sum, a segment
   of the convolution of the same direction covers it. *)
Theorem covered_in_its_own_direction (p q : region) (x w u : vector) (s : segment) :
  valid_region p -> valid_region q -> ~ interiors_meet x p q -> equal_vectors x (plus w u) ->
  (In s (region_edges p) /\ lies_on w s /\ ~ is_vertex w p /\ is_vertex u q) \/
  (In s (region_edges q) /\ lies_on u s /\ ~ is_vertex u q /\ is_vertex w p) ->
  exists t, In t (convolution_segments p q) /\ lies_on x t /\ same_direction (along t) (along s).
Proof.
  intros p_region q_region outside sum_ inside_a_segment.
  assert (vertex_in : forall v r, is_vertex v r -> in_region v r).
  { intros v r (e & E & equal). right. exists e. split; [exact E |].
    apply (lies_on_equal (source e)); [now symmetry | apply source_lies_on]. }
  destruct inside_a_segment as [(S & on & no_vertex & vertex) | (S & on & no_vertex & vertex)].
  - now destruct (passing_edge_of_p_covers p q x w u p_region q_region sum_ s S on no_vertex (vertex_in u q vertex)).
  - now destruct (passing_edge_of_q_covers p q x w u p_region q_region sum_ s S on no_vertex (vertex_in w p vertex)).
Qed.
