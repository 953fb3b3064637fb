(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Where the interiors of P and -Q + x do not meet, and all that is to the left of an edge of P is inside near a point
   of it (inside_a_corner.v), no edge of Q leads across it. Either one lies along it, or a convex vertex has it in its
   tangent set (convex_corners.v). Chains may touch. So Theorem 2.2.10, its second part: where an edge passes a point of
   the other region, at a point of the edge that is no vertex, and the interiors do not meet, x is on a segment of the
   convolution that has the edge's direction. *)
From Coq Require Import ZArith Lia Bool List.
From Oplus Require Import numbers convolution signed_crossings tie_rule convolution_winding regions weight finite_sums
  tangent_count tracing meeting_of_segments neighbourhoods winding_number_of_the_sum interiors_meet left_of_an_edge
  theorem_4_2_1 simple_chain definition_2_2_8 inside_a_corner boundary_points reduced_convolution edges_at_a_point
  fan_at_a_point fans_that_touch convex_corners.
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

(* No edge of Q leads across a direction d to the left of which P is filled. *)
Lemma sides_of_edges (p q : region) (x w u d : vector) (f : segment) :
  valid_region q -> ~ interiors_meet x p q -> equal_vectors x (plus w u) -> fills_left w d p ->
  In f (region_edges q) ->
  (departs u f = true -> 0 <= cross d (along f)) /\ (arrives u f = true -> cross d (along f) <= 0).
Proof.
  intros (q_edges & q_valid & q_meet) outside [X Y] (radius & R & fills) F.
  assert (across : forall g, eventually (fun t => lies_on (moved_along u g t) f) -> 0 <= cross d g).
  { intros g on_f. apply Qnot_lt_le. intros across. apply outside.
    destruct (some_small _ (eventually_and _ _ (small_steps_stay_within radius w (opposite g) R) on_f))
      as (t & some & near & on).
    apply (inner_point_and_point p q x (moved_along w (opposite g) t) (moved_along u g t)
      (regions_are_regular q q_edges q_valid q_meet)); [| right; now exists f |].
    - apply fills; [exact near |].
      setoid_replace (cross d (minus (moved_along w (opposite g) t) w)) with (t * - cross d g) by by_coordinates. nra.
    - unfold plus, moved_along, opposite in *; cbn [vx vy] in *. split; cbn [vx vy]; lra. }
  split; intros there.
  - now apply across, goes_ahead_from.
  - pose proof (across _ (comes_from_behind u f there)). unfold cross, opposite in *; cbn [vx vy] in *. lra.
Qed.

(* An edge of Q lies along it, or a convex vertex is there. *)
Lemma common_direction_or_convex_vertex (p q : region) (x w u : vector) (e : segment) :
  valid_region p -> valid_region q -> ~ interiors_meet x p q -> equal_vectors x (plus w u) ->
  In e (region_edges p) -> departs w e = true -> fills_left w (along e) p -> in_region u q ->
  (exists f, In f (region_edges q) /\ lies_on u f /\ same_direction (along e) (along f)) \/
  exists chain i, In chain q /\ (i < length chain)%nat /\ equal_vectors u (vertex chain i) /\
    convex (corner_of_chain chain i) /\
    forall label, in_tangent_set (Direction (along e) label) (corner_of_chain chain i) = true.
Proof.
  intros p_region q_region outside sum_ E e_departs fills in_q. pose proof p_region as (p_edges & p_valid & p_meet).
  pose proof (region_edges_are_directions p p_edges e E) as long.
  assert (on_e : lies_on w e) by (now apply departs_is in e_departs).
  destruct (both_on_boundaries_or_meet p q x w u) as [[_ on_q] |]; trivial; [right; now exists e | | contradiction].
  destruct (one_or_all (exists f, In f (region_edges q) /\ lies_on u f /\ same_direction (along e) (along f))
    (fun f => lies_on u f -> ~ cross (along e) (along f) == 0) (region_edges q)) as [| aside]; [| now left | right].
  { intros f F. destruct (lies_on_dec u f) as [on_f |]; [| now right].
    destruct (Qeq_dec (cross (along e) (along f)) 0) as [flat |]; [left | now right].
    pose proof (region_edges_are_directions q (proj1 q_region) f F) as long_f.
    destruct (parallel_directions (along e) (along f) long long_f flat) as [same_ | back]; [now exists f | exfalso].
    now apply outside, (opposite_edge_meets p q x w u (along e) f). }
  assert (one_side : forall f, In f (region_edges q) ->
    (departs u f = true -> 0 < cross (along e) (along f)) /\ (arrives u f = true -> cross (along e) (along f) < 0)).
  { intros f F. destruct (sides_of_edges p q x w u (along e) f) as [ahead behind]; trivial.
    split; intros there; [specialize (ahead there); apply departs_is in there |
      specialize (behind there); apply arrives_is in there]; pose proof (aside f F (proj1 there)); lra. }
  destruct (some_small _ (eventually_and _ _ (goes_ahead_from w e e_departs)
    (convex_corner q u (along e) q_region long on_q one_side))) as (k & _ & on & [in_q' | found]);
    [exfalso | exact found].
  apply outside, interiors_meet_other_way.
  apply (inner_point_and_point q p x _ (moved_along w (along e) k) (regions_are_regular p p_edges p_valid p_meet) in_q'
    (or_intror (ex_intro _ e (conj E on)))).
  destruct sum_ as [X Y]. unfold plus, moved_along, opposite in *; cbn [vx vy] in *. split; cbn [vx vy]; lra.
Qed.

Lemma passes_both_ways (r : region) (w : vector) (e : segment) : In e (region_edges r) -> lies_on w e ->
  ~ is_vertex w r -> departs w e = true /\ arrives w e = true.
Proof.
  intros E on no_vertex. split; [apply departs_is | apply arrives_is]; (split; [exact on |]); intros at_end;
    apply no_vertex; [| now exists e].
  apply (vertex_of_equal (target e)); [now symmetry | now apply target_is_vertex].
Qed.

(* An edge of P that passes, and one of Q that does. *)
Section Passing.
  Variables p q : region.
  Variables x w u : vector.
  Hypothesis p_region : valid_region p.
  Hypothesis q_region : valid_region q.
  Hypothesis outside : ~ interiors_meet x p q.
  Hypothesis sum_ : equal_vectors x (plus w u).

  Lemma edge_of_p_passes (e : segment) : In e (region_edges p) -> departs w e = true -> fills_left w (along e) p ->
    in_region u q ->
    (exists a b, In a p /\ In b q /\ on_a_tie a b (along e) x) \/ reduced_along p q x (along e).
  Proof.
    intros E e_departs fills in_q. assert (on_e : lies_on w e) by (now apply departs_is in e_departs).
    destruct (common_direction_or_convex_vertex p q x w u e) as
      [(f & F & on_f & same_) | (b & j & B & J & at_vertex & is_convex & tangent)]; trivial; [left | right].
    - now apply (common_direction_is_a_tie p q x w u p_region q_region sum_ e f).
    - now apply (tangent_of_p_is_covered p q x w u sum_ e b j).
  Qed.

  Lemma edge_of_q_passes (f : segment) : In f (region_edges q) -> departs u f = true -> fills_left u (along f) q ->
    in_region w p ->
    (exists a b, In a p /\ In b q /\ on_a_tie a b (along f) x) \/ reduced_along p q x (along f).
  Proof.
    intros F f_departs fills in_p. assert (on_f : lies_on u f) by (now apply departs_is in f_departs).
    pose proof (region_edges_are_directions q (proj1 q_region) f F) as long.
    destruct (common_direction_or_convex_vertex q p x u w f) as
      [(e & E & on_e & same_) | (a & i & A & I & at_vertex & is_convex & tangent)]; trivial.
    - intros meet. now apply outside, interiors_meet_other_way.
    - now apply sum_in_other_order.
    - left. destruct (common_direction_is_a_tie p q x w u p_region q_region sum_ e f) as
        (a & b & A & B & i & j & t & I & J & range & tie); trivial; [now apply same_direction_symmetric |].
      apply same_direction_angle in same_; [| exact long | now apply (region_edges_are_directions p (proj1 p_region))].
      exists a, b. split; [exact A |]. split; [exact B |]. exists i, j, t. rewrite same_. tauto.
    - right. now apply (tangent_of_q_is_covered p q x w u sum_ f a i).
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
  assert (covered : nonzero (along s) -> (exists a b, In a p /\ In b q /\ on_a_tie a b (along s) x) \/
    reduced_along p q x (along s) -> covered_along p q x (along s)).
  { intros long [(a & b & A & B & tie) | reduced]; [now apply (tie_is_covered p q x p_region q_region a b) |].
    now apply reduced_along_is_covered. }
  destruct inside_a_segment as [(S & on & no_vertex & vertex) | (S & on & no_vertex & vertex)]; apply covered.
  - now apply (region_edges_are_directions p (proj1 p_region)).
  - apply (edge_of_p_passes p q x w u); auto using vertex_is_in_region, fills_left_beside_an_edge.
    now apply (passes_both_ways p w s).
  - now apply (region_edges_are_directions q (proj1 q_region)).
  - apply (edge_of_q_passes p q x w u); auto using vertex_is_in_region, fills_left_beside_an_edge.
    now apply (passes_both_ways q u s).
Qed.
