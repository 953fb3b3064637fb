(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* A chain that touches itself, but does not cross, is simple when its corners are cut (cut_corners.v). What is left of
   its edges is inside them, and so apart. A chord at a corner is apart from the chords of other passes through the
   same vertex, since these do not cross; from edges that end there, since these are outside of the curve then; from
   an edge that passes there, since the corner is on one side of it; and from all else, since that is further away. *)
From Coq Require Import ZArith Lia Bool List.
From Oplus Require Import numbers convolution small_numbers neighbourhoods regions meeting_of_segments secants
  segments_apart simple_chain strictly_convex_curve chords_around_a_point cut_corners.
Import ListNotations.

Open Scope Q_scope.

(* No point is inside two of the edges. *)
Definition edges_are_interior_disjoint (chain : list vector) : Prop :=
  forall i j x, (i < length chain)%nat -> (j < length chain)%nat -> i <> j ->
    ~ (strictly_inside x (edge_at chain i) /\ strictly_inside x (edge_at chain j)).

(* Where a vertex is inside an edge, the vertices before and after it are on the same side of that edge. *)
Definition vertices_touch_from_one_side (chain : list vector) : Prop :=
  let n := length chain in
  forall i j, (i < n)%nat -> (j < n)%nat -> strictly_inside (vertex chain i) (edge_at chain j) ->
    let side k := area (edge_at chain j) (vertex chain k) in
    (0 <= side (previous n i) /\ 0 <= side (next i n)) \/ (side (previous n i) <= 0 /\ side (next i n) <= 0).

(* Where two vertices are one point, the chain does not cross itself. *)
Definition vertices_do_not_cross (chain : list vector) : Prop :=
  forall i j, (i < length chain)%nat -> (j < length chain)%nat -> i <> j ->
    equal_vectors (vertex chain i) (vertex chain j) ->
    passes_do_not_cross (ray_back chain i) (ray_out chain i) (ray_back chain j) (ray_out chain j).

(* Rays do not change if they are stretched. *)
Lemma same_ray_stretched (u v : vector) (k l : Q) : 0 < k -> 0 < l ->
  same_ray (stretched k u) (stretched l v) -> same_ray u v.
Proof.
  intros K L [flat forwards]. unfold same_ray, cross, dot, stretched in *. cbn [vx vy] in *.
  pose proof (products k l K L) as kl. split.
  - apply (Qmult_inj_l _ _ (k * l)); [lra |]. lra.
  - destruct (Qlt_le_dec 0 (vx u * vx v + vy u * vy v)); [assumption | nra].
Qed.

Lemma crossing_of_stretched (a b c f : vector) (k l i j : Q) : 0 < k -> 0 < l -> 0 < i -> 0 < j ->
  passes_do_not_cross a b c f ->
  passes_do_not_cross (stretched k a) (stretched l b) (stretched i c) (stretched j f).
Proof.
  intros K L I J [inside_ opposite_].
  assert (turned : forall s t u w, cross (stretched s u) (stretched t w) == s * t * cross u w)
    by (intros; unfold cross, stretched; cbn [vx vy]; ring).
  pose proof (products k l K L) as kl. pose proof (products k i K I) as ki. pose proof (products k j K J) as kj.
  pose proof (products i l I L) as il. pose proof (products j l J L) as jl.
  assert (angle_is : forall s r, 0 < s -> inside_angle (stretched k a) (stretched l b) (stretched s r) <->
    inside_angle a b r).
  { intros s r S. unfold inside_angle. rewrite !turned. pose proof (products k s K S). pose proof (products s l S L).
    assert (scale : forall x y p q, 0 < p -> 0 < q -> 0 < p * x * (q * y) <-> 0 < x * y).
    { intros x y p q P Q. pose proof (products p q P Q) as pq.
      setoid_replace (p * x * (q * y)) with (p * q * (x * y)) by ring.
      split; intros sign; [destruct (Qlt_le_dec 0 (x * y)); [assumption | nra] | now apply products]. }
    now rewrite !scale by assumption. }
  split.
  - rewrite turned. intros some. rewrite !angle_is by assumption. apply inside_. intros zero_. apply some.
    rewrite zero_. ring.
  - rewrite !turned. intros flat. assert (zero_ : cross a b == 0) by (apply (Qmult_inj_l _ _ (k * l)); lra).
    specialize (opposite_ zero_). setoid_replace (k * i * cross a c * (k * j * cross a f))
      with ((k * i) * (k * j) * (cross a c * cross a f)) by ring.
    apply products; [now apply products | exact opposite_].
Qed.

Section Cut.
  Variable chain : list vector.
  Let n := length chain.
  Hypothesis turn : turns_everywhere chain.
  Hypothesis disjoint : edges_are_interior_disjoint chain.
  Hypothesis one_side : vertices_touch_from_one_side chain.
  Hypothesis crossing_free : vertices_do_not_cross chain.

  (* Points on a ray are inside its edge. *)
  Definition ray_of_edge (j : nat) (v r : vector) : Prop :=
    (j < n)%nat /\ forall s, 0 < s < 1 -> strictly_inside (moved_along v r s) (edge_at chain j).

  Lemma ray_out_of_edge (i : nat) : (i < n)%nat -> ray_of_edge i (vertex chain i) (ray_out chain i).
  Proof.
    intros I. split; [exact I |]. intros s range. exists s. split; [exact range |]. rewrite edge_is by exact I. fold n.
    unfold moved_along, ray_out, minus. cbn [source target vx vy]. fold n. split; ring.
  Qed.

  Lemma ray_back_of_edge (i : nat) : (i < n)%nat -> ray_of_edge (previous n i) (vertex chain i) (ray_back chain i).
  Proof.
    intros I. split; [now apply previous_below |]. intros s range. exists (1 - s). split; [lra |].
    rewrite edge_is by now apply previous_below. fold n. rewrite next_previous by exact I.
    unfold moved_along, ray_back, minus. cbn [source target vx vy]. fold n. split; ring.
  Qed.

  Lemma inside_of_equal_points (x y : vector) (s : segment) :
    equal_vectors x y -> strictly_inside x s -> strictly_inside y s.
  Proof. intros [X Y] (k & range & xk & yk). exists k. rewrite <- X, <- Y. now repeat split. Qed.

  (* Rays of two edges from one point are two. *)
  Lemma rays_of_two_edges_differ (j k : nat) (v w r q : vector) : j <> k -> equal_vectors v w -> nonzero q ->
    ray_of_edge j v r -> ray_of_edge k w q -> ~ same_ray r q.
  Proof.
    intros differ [X Y] some [J on_j] [K on_k] [flat forwards].
    destruct (multiple_of r q some flat) as (c & r_x & r_y). pose proof (square_positive q some) as square.
    assert (c_positive : 0 < c).
    { assert (dot r q == c * dot q q) by (unfold dot; rewrite r_x, r_y; ring). nra. }
    destruct (some_small _ (eventually_and _ _ (eventually_below 1 ltac:(lra))
      (eventually_positive 1 (- c) ltac:(lra)))) as (s & S & [_ less] & less').
    apply (disjoint j k (moved_along v r s) J K differ). split; [apply on_j; lra |].
    apply (inside_of_equal_points (moved_along w q (s * c))); [| apply on_k; split; [now apply products | lra]].
    unfold equal_vectors, moved_along. cbn [vx vy]. rewrite r_x, r_y, X, Y. split; ring.
  Qed.

  (* The ray of a corner and an edge that has the vertex inside are not in line. *)
  Lemma ray_leaves_an_edge (j k : nat) (v r : vector) : j <> k -> (k < n)%nat -> ray_of_edge j v r ->
    strictly_inside v (edge_at chain k) -> ~ cross (along (edge_at chain k)) r == 0.
  Proof.
    intros differ K [J on_j] (p & range & X & Y) flat.
    pose proof (edges_of_simple_chains chain k (turning_chains_have_edges chain turn) K) as some.
    assert (along_some : nonzero (along (edge_at chain k))).
    { rewrite edge_is by exact K. exact some. }
    assert (turned : cross r (along (edge_at chain k)) == 0) by (unfold cross in *; lra).
    destruct (multiple_of r _ along_some turned) as (c & r_x & r_y).
    destruct (some_small _ (eventually_and _ _ (eventually_below 1 ltac:(lra)) (eventually_and _ _
      (eventually_positive p c ltac:(lra)) (eventually_positive (1 - p) (- c) ltac:(lra)))))
      as (s & S & [_ less] & low & high).
    apply (disjoint j k (moved_along v r s) J K differ). split; [apply on_j; lra |].
    exists (p + s * c). split; [lra |]. unfold along, minus in r_x, r_y. cbn [vx vy] in r_x, r_y.
    unfold moved_along. cbn [vx vy]. rewrite r_x, r_y, X, Y. split; ring.
  Qed.

  (* A vertex inside an edge is none of the edge's own, and its rays are on one side of the edge. *)
  Lemma rays_on_one_side (i k : nat) : (i < n)%nat -> (k < n)%nat ->
    strictly_inside (vertex chain i) (edge_at chain k) ->
    area (edge_at chain k) (vertex chain i) == 0 /\
    0 < cross (along (edge_at chain k)) (ray_back chain i) * cross (along (edge_at chain k)) (ray_out chain i).
  Proof.
    intros I K inside_. pose proof (on_the_line _ _ (strictly_inside_lies_on _ _ inside_)) as line.
    split; [exact line |].
    pose proof (edges_of_simple_chains chain k (turning_chains_have_edges chain turn) K) as some. fold n in some.
    assert (no_end : forall c, c = vertex chain k \/ c = vertex chain (next k n) ->
      ~ equal_vectors (vertex chain i) c).
    { intros c which [X Y]. destruct inside_ as (p & range & xp & yp). rewrite edge_is in xp, yp by exact K.
      fold n in xp, yp.
      cbn [source target] in xp, yp. apply some. unfold minus. cbn [vx vy].
      destruct which as [-> | ->]; split; nra. }
    assert (not_out : i <> k) by (intros ->; apply (no_end (vertex chain k)); [now left | split; reflexivity]).
    assert (not_back : previous n i <> k).
    { intros <-. apply (no_end (vertex chain i)); [right; now rewrite next_previous | split; reflexivity]. }
    pose proof (ray_leaves_an_edge i k _ _ not_out K (ray_out_of_edge i I) inside_) as out_.
    pose proof (ray_leaves_an_edge _ k _ _ not_back K (ray_back_of_edge i I) inside_) as back_.
    pose proof (one_side i k I K inside_) as sides. cbv zeta in sides. fold n in sides.
    assert (area_is : forall c, cross (along (edge_at chain k)) (minus c (vertex chain i)) == area (edge_at chain k) c).
    { intros c. assert (parts : cross (along (edge_at chain k)) (minus c (vertex chain i)) ==
        area (edge_at chain k) c - area (edge_at chain k) (vertex chain i))
        by (unfold area, cross, along, minus; cbn [vx vy]; ring). rewrite parts, line. ring. }
    unfold ray_out, ray_back in *. fold n in out_, back_ |- *. rewrite area_is in out_, back_. rewrite !area_is.
    assert (strictly : forall q, 0 <= q -> ~ q == 0 -> 0 < q)
      by (intros q at_least no; destruct (Q_dec q 0) as [[less | more] | equal]; [lra | exact more | contradiction]).
    set (p := area (edge_at chain k) (vertex chain (previous n i))) in *.
    set (q := area (edge_at chain k) (vertex chain (next i n))) in *. clearbody p q.
    destruct sides as [[a b] | [a b]].
    - apply products; now apply strictly.
    - setoid_replace (p * q) with (- p * - q) by ring. apply products; apply strictly; lra.
  Qed.

  Definition cut_chord (e : Q) (i : nat) : segment := Segment (before_corner chain e i) (after_corner chain e i).

  Lemma corner_rays_on_curve (i : nat) : (i < n)%nat ->
    is_on_curve (on_curve (ray_back chain i)) /\ is_on_curve (on_curve (ray_out chain i)).
  Proof.
    intros I. destruct (rays_are_some chain turn i I) as [some_back some_out].
    destruct (on_curve_is_a_multiple _ some_back) as (_ & _ & _ & at_back).
    destruct (on_curve_is_a_multiple _ some_out) as (_ & _ & _ & at_out). now split.
  Qed.

  Lemma on_curve_same_ray (u v : vector) : nonzero u -> nonzero v -> same_ray (on_curve u) (on_curve v) -> same_ray u v.
  Proof.
    intros some_u some_v. destruct (on_curve_is_a_multiple u some_u) as (k & K & -> & _).
    destruct (on_curve_is_a_multiple v some_v) as (l & L & -> & _). now apply same_ray_stretched.
  Qed.

  (* The chain does not turn back. *)
  Lemma corner_rays_differ (i : nat) : (i < n)%nat ->
    ~ same_ray (on_curve (ray_back chain i)) (on_curve (ray_out chain i)).
  Proof.
    intros I same_. destruct (rays_are_some chain turn i I) as [some_back some_out].
    apply on_curve_same_ray in same_; trivial. destruct same_ as [flat forwards].
    destruct (ray_back_is chain i I) as [X Y]. destruct (turns_at_a_corner chain turn i I) as (_ & _ & goes_on).
    rewrite ray_out_is in flat, forwards by exact I. unfold opposite in X, Y. cbn [vx vy] in X, Y.
    fold n in X, Y, goes_on.
    unfold cross, dot in *. rewrite X, Y in *. lra.
  Qed.

  (* Chords of two passes through one point. *)
  Lemma chords_at_one_point (e : Q) (i j : nat) (x : vector) : 0 < e -> (i < n)%nat -> (j < n)%nat -> i <> j ->
    equal_vectors (vertex chain i) (vertex chain j) -> lies_on x (cut_chord e i) -> ~ lies_on x (cut_chord e j).
  Proof.
    intros some I J differ same_ on on_j.
    destruct (corner_rays_on_curve i I) as [back_i out_i], (corner_rays_on_curve j J) as [back_j out_j].
    destruct (rays_are_some chain turn i I) as [back_i' out_i'], (rays_are_some chain turn j J) as [back_j' out_j'].
    assert (same_' : equal_vectors (vertex chain j) (vertex chain i)) by (destruct same_; split; lra).
    assert (not_previous : previous n i <> previous n j).
    { intros equal. apply differ. rewrite <- (next_previous n i I), equal. now apply next_previous. }
    assert (no_loop : forall k l, (k < n)%nat -> (l < n)%nat -> k = previous n l ->
      ~ equal_vectors (vertex chain k) (vertex chain l)).
    { intros k l K L -> equal. destruct (rays_are_some chain turn l L) as [long _]. apply long.
      unfold ray_back, minus. cbn [vx vy]. fold n. destruct equal. split; lra. }
    refine (chords_do_not_meet (vertex chain i) _ _ e some back_i out_i (corner_rays_differ i I)
      (on_curve (ray_back chain j)) (on_curve (ray_out chain j)) x back_j out_j _ _ _ _ _ on _).
    - intros ray. apply on_curve_same_ray in ray; trivial. revert ray.
      apply (rays_of_two_edges_differ (previous n j) (previous n i) (vertex chain j) (vertex chain i));
        auto using ray_back_of_edge.
    - intros ray. apply on_curve_same_ray in ray; trivial. revert ray.
      apply (rays_of_two_edges_differ (previous n j) i (vertex chain j) (vertex chain i));
        auto using ray_back_of_edge, ray_out_of_edge.
      intros equal. exact (no_loop i j I J (eq_sym equal) same_).
    - intros ray. apply on_curve_same_ray in ray; trivial. revert ray.
      apply (rays_of_two_edges_differ j (previous n i) (vertex chain j) (vertex chain i));
        auto using ray_back_of_edge, ray_out_of_edge.
      intros equal. exact (no_loop j i J I equal same_').
    - intros ray. apply on_curve_same_ray in ray; trivial. revert ray.
      apply (rays_of_two_edges_differ j i (vertex chain j) (vertex chain i)); auto using ray_out_of_edge.
    - destruct (on_curve_is_a_multiple _ back_i') as (k1 & K1 & ->
        & _), (on_curve_is_a_multiple _ out_i') as (k2 & K2 & -> & _),
        (on_curve_is_a_multiple _ back_j') as (k3 & K3 & ->
          & _), (on_curve_is_a_multiple _ out_j') as (k4 & K4 & -> & _).
      apply crossing_of_stretched; trivial. now apply crossing_free.
    - destruct on_j as (t & range & X & Y). exists t. split; [exact range |]. destruct same_ as [sx sy].
      unfold cut_chord, before_corner, after_corner, chord, moved_along in *. cbn [source target vx vy] in *.
      rewrite X, Y, sx, sy. split; ring.
  Qed.

  (* A chord and what is left of an edge that ends at its vertex, but is none of its own. *)
  Lemma chord_and_short_edge (e : Q) (i k : nat) (x : vector) : is_small chain e -> (i < n)%nat -> (k < n)%nat ->
    i <> k -> i <> next k n -> lies_on (vertex chain i) (edge_at chain k) ->
    lies_on x (cut_chord e i) -> ~ lies_on x (Segment (after_corner chain e k) (before_corner chain e (next k n))).
  Proof.
    intros small I K not_k not_next at_edge on on_short. pose proof (next_in_range k n K) as K'.
    destruct (short_edges chain turn e k x small K on_short) as (inside_ & (s & far & from_k) & (s' & far' &
      from_next)).
    destruct (corner_rays_on_curve i I) as [back_i out_i].
    destruct (rays_are_some chain turn i I) as [back_i' out_i'].
    assert (previous_next_k : previous n (next k n) = k) by now apply previous_next.
    assert (not_previous : previous n i <> k).
    { intros equal. apply not_next. rewrite <- equal. symmetry. now apply next_previous. }
    destruct (inside_or_end _ _ at_edge) as [within_ | [ends | ends]].
    - destruct (rays_on_one_side i k I K within_) as [line one_side_].
      destruct (on_curve_is_a_multiple _ back_i') as (k1 & K1 & e1 & _),
        (on_curve_is_a_multiple _ out_i') as (k2 & K2 & e2 & _).
      apply (chords_beside_a_line (vertex chain i) (on_curve (ray_back chain i)) (on_curve (ray_out chain i)) e
        (proj1 small) (edge_at chain k) x line); [| exact on | exact (on_the_line _ _ (strictly_inside_lies_on _ _
          inside_))].
      rewrite e1, e2. set (d := along (edge_at chain k)) in *.
      assert (parts : cross d (stretched k1 (ray_back chain i)) * cross d (stretched k2 (ray_out chain i)) ==
        k1 * k2 * (cross d (ray_back chain i) * cross d (ray_out chain i)))
        by (unfold cross, stretched; cbn [vx vy]; ring).
      rewrite parts. apply products; [now apply products | exact one_side_].
    - rewrite edge_is in ends by exact K. cbn [source] in ends.
      destruct (corner_rays_on_curve k K) as [_ out_k], (rays_are_some chain turn k K) as [_ out_k'].
      assert (moved_is : equal_vectors x (moved_along (vertex chain i) (on_curve (ray_out chain k)) s)).
      { destruct from_k as [X Y], ends as [ex ey]. unfold equal_vectors, moved_along in *. cbn [vx vy] in *.
        split; lra. }
      refine (rays_do_not_meet_chords (vertex chain i) _ _ e (proj1 small) back_i out_i (corner_rays_differ i I)
        (on_curve (ray_out chain k)) x s out_k _ _ far moved_is on).
      + intros ray. apply on_curve_same_ray in ray; trivial. revert ray.
        apply (rays_of_two_edges_differ k (previous n i) (vertex chain k) (vertex chain i));
          auto using ray_back_of_edge, ray_out_of_edge.
      + intros ray. apply on_curve_same_ray in ray; trivial. revert ray.
        apply (rays_of_two_edges_differ k i (vertex chain k) (vertex chain i)); auto using ray_out_of_edge.
    - rewrite edge_is in ends by exact K. cbn [target] in ends. fold n in ends.
      destruct (corner_rays_on_curve (next k n) K') as [back_k _],
        (rays_are_some chain turn (next k n) K') as [back_k' _].
      assert (moved_is : equal_vectors x (moved_along (vertex chain i) (on_curve (ray_back chain (next k n))) s')).
      { destruct from_next as [X Y], ends as [ex ey]. unfold equal_vectors, moved_along in *. cbn [vx vy] in *.
        fold n in X, Y. split; lra. }
      pose proof (ray_back_of_edge (next k n) K') as of_k. rewrite previous_next_k in of_k.
      refine (rays_do_not_meet_chords (vertex chain i) _ _ e (proj1 small) back_i out_i (corner_rays_differ i I)
        (on_curve (ray_back chain (next k n))) x s' back_k _ _ far' moved_is on).
      + intros ray. apply on_curve_same_ray in ray; trivial. revert ray.
        apply (rays_of_two_edges_differ k (previous n i) (vertex chain (next k n)) (vertex chain i));
          auto using ray_back_of_edge.
      + intros ray. apply on_curve_same_ray in ray; trivial. revert ray.
        apply (rays_of_two_edges_differ k i (vertex chain (next k n)) (vertex chain i)); auto using ray_out_of_edge.
  Qed.
End Cut.
