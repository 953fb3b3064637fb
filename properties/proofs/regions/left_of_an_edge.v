(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* In a region whose edges meet in vertices only, and whose winding numbers are not negative, what is close to the
   left of an edge is inside: the winding number there is one more than to the right (thesis, Observation
   4.2.5, on a step across the edge). So every point of a region has points near it that are inside. Small steps
   and neighbourhoods are from neighbourhoods.v. *)
From Coq Require Import QArith Qminmax Lqa ZArith Lia Bool List.
From Oplus Require Import convolution shifted_ray signed_crossings tie_rule regions weight beside_every_point
  meeting_of_segments interiors_meet neighbourhoods.
Import ListNotations.

Open Scope Q_scope.

Definition is_vertex (w : vector) (r : region) : Prop :=
  exists u, In u (region_edges r) /\ equal_vectors w (source u).

(* A point that is on two edges is a vertex. Chains may touch, also a vertex the inside of an edge; they may not
   cross or overlap, and no edge may be there twice. *)
Definition edges_meet_in_vertices (r : region) : Prop :=
  forall earlier s later t w, region_edges r = earlier ++ s :: later -> In t (earlier ++ later) ->
    lies_on w s -> lies_on w t -> is_vertex w r.

(* The closure of its interior: every boundary point has points inside the region near it. *)
Definition is_regular (r : region) : Prop :=
  forall w s radius, In s (region_edges r) -> lies_on w s -> 0 < radius ->
    exists z, within radius w z /\ inside z r.

Lemma target_is_vertex (r : region) (s : segment) : In s (region_edges r) -> is_vertex (target s) r.
Proof.
  intros I. apply in_flat_map in I. destruct I as (chain & J & I).
  assert (K : In (target s) chain).
  { destruct (edges_ends chain) as [_ targets].
    assert (K : In (target s) (rotated chain)) by (rewrite <- targets; now apply in_map).
    destruct chain as [| v rest]; [destruct K |]. cbn [rotated] in K. apply in_app_iff in K.
    destruct K as [K | [<- | []]]; [now right | now left]. }
  destruct (edges_ends chain) as [sources _]. rewrite <- sources in K. apply in_map_iff in K.
  destruct K as (u & is_source & K). exists u. split; [apply in_flat_map; now exists chain |].
  rewrite is_source. split; reflexivity.
Qed.

(* A step across an edge from its right to its left is counted once. *)
Lemma step_across (s : segment) (w n : vector) (k e : Q) :
  0 < k < 1 -> vx w == (1 - k) * vx (source s) + k * vx (target s) ->
  vy w == (1 - k) * vy (source s) + k * vy (target s) ->
  0 < cross (along s) n -> 0 < e ->
  area s (moved_along w n e) > 0 /\ area s (moved_along w n (- e)) < 0 /\
  signed_crossing_of_step (moved_along w n (- e)) (moved_along w n e) s = 1%Z.
Proof.
  intros range X Y left_ small. destruct s as [a b]. unfold along in left_. cbn [source target] in *.
  set (c := cross (minus b a) n) in *.
  assert (after : area (Segment a b) (moved_along w n e) == e * c)
    by (unfold area, c, cross, minus, moved_along; cbn; rewrite X, Y; ring).
  assert (before : area (Segment a b) (moved_along w n (- e)) == - (e * c))
    by (unfold area, c, cross, minus, moved_along; cbn; rewrite X, Y; ring).
  assert (positive_ : 0 < e * c) by nra.
  split; [lra |]. split; [lra |].
  unfold signed_crossing_of_step, side_of_segment, side_of_step. cbn [source target].
  rewrite !orientation_by_area.
  rewrite (proj1 (Qlt_alt (area (Segment a b) (moved_along w n (- e))) 0)) by lra.
  rewrite (proj1 (Qgt_alt (area (Segment a b) (moved_along w n e)) 0)) by lra.
  assert (of_source : area (Segment (moved_along w n (- e)) (moved_along w n e)) a == 2 * k * (e * c))
    by (unfold area, c, cross, minus, moved_along; cbn; rewrite X, Y; ring).
  assert (of_target : area (Segment (moved_along w n (- e)) (moved_along w n e)) b == - (2 * (1 - k) * (e * c)))
    by (unfold area, c, cross, minus, moved_along; cbn; rewrite X, Y; ring).
  rewrite (proj1 (Qgt_alt (area (Segment (moved_along w n (- e)) (moved_along w n e)) a) 0))
    by (rewrite of_source; apply Qmult_lt_0_compat; lra).
  rewrite (proj1 (Qlt_alt (area (Segment (moved_along w n (- e)) (moved_along w n e)) b) 0)).
  - reflexivity.
  - rewrite of_target. assert (0 < 2 * (1 - k) * (e * c)) by (apply Qmult_lt_0_compat; lra). lra.
Qed.

Lemma off_by_area (p : vector) (s : segment) : ~ area s p == 0 -> ~ lies_on p s.
Proof.
  intros beside on. apply beside. apply on_its_line in on. rewrite orientation_by_area in on.
  apply equal_comparison in on. destruct s. exact on.
Qed.

(* Theorem. Where an edge meets no other, at a point that is no vertex, the winding number to its left is one more than
   to its right. *)
Theorem left_is_one_more (r : region) (s : segment) (w n : vector) :
  edges_meet_in_vertices r -> In s (region_edges r) -> lies_on w s -> ~ is_vertex w r -> 0 < cross (along s) n ->
  eventually (fun e =>
    off (moved_along w n e) (region_edges r) /\ off (moved_along w n (- e)) (region_edges r) /\
    winding_number (moved_along w n e) (region_edges r) =
      (winding_number (moved_along w n (- e)) (region_edges r) + 1)%Z).
Proof.
  intros meet I on no_vertex left_.
  destruct (in_split _ _ I) as (earlier & later & edges_are).
  assert (free : off w (earlier ++ later)).
  { intros t J on_t. apply no_vertex. exact (meet earlier s later t w edges_are J on on_t). }
  destruct (off_near w _ free) as (radius & R & near).
  destruct on as (k & [k0 k1] & X & Y).
  assert (k_inside : 0 < k < 1).
  { split; apply Qnot_le_lt; intros extreme; apply no_vertex.
    - exists s. split; [exact I |]. assert (k == 0) as k_is by lra. rewrite k_is in X, Y. split; lra.
    - destruct (target_is_vertex r s I) as (u & J & tx & ty). exists u. split; [exact J |].
      assert (k == 1) as k_is by lra. rewrite k_is in X, Y. split; lra. }
  pose proof (small_steps_stay_within radius w n R) as close.
  pose proof (small_steps_stay_within radius w (opposite n) R) as close_back.
  refine (eventually_implied _ _ _ (eventually_and _ _ (ex_intro _ 1 (conj _ (fun e some _ => some)))
            (eventually_and _ _ close close_back))); [| lra].
  intros e (some & close_left & close_right).
  assert (close_right_ : within radius w (moved_along w n (- e))).
  { unfold within, moved_along, opposite in *; cbn [vx vy] in *. lra. }
  clear close close_back close_right.
  destruct (step_across s w n k e k_inside X Y left_ some) as (on_left & on_right & once).
  set (from := moved_along w n (- e)) in *. set (to := moved_along w n e) in *.
  assert (off_both : off from (region_edges r) /\ off to (region_edges r)).
  { rewrite edges_are. split; intros t J; apply in_app_iff in J; destruct J as [J | [<- | J]];
      try (apply off_by_area; lra); apply near; trivial; apply in_app_iff; tauto. }
  destruct off_both as [off_from off_to].
  assert (moves : nonzero (minus to from)).
  { intros [zero_x zero_y]. assert (area s to == area s from); [| lra].
    unfold minus in zero_x, zero_y; cbn [vx vy] in zero_x, zero_y. unfold area, cross, minus; cbn [vx vy].
    assert (vx to == vx from) as -> by lra. assert (vy to == vy from) as -> by lra. reflexivity. }
  pose proof (step_changes_winding_number from to _ (region_cycles r) off_from off_to moves) as change.
  assert (others : forall l, incl l (earlier ++ later) ->
    sum (map (signed_crossing_of_step from to) l) = 0%Z).
  { intros l. induction l as [| t l IH]; intros part; [reflexivity |]. unfold sum in *. cbn [map fold_right].
    rewrite IH by (intros u J; apply part; now right).
    destruct (Z.eq_dec (signed_crossing_of_step from to t) 0) as [-> | crosses]; [reflexivity |]. exfalso.
    destruct (crossing_steps_meet from to t crosses) as (v & on_step & on_t).
    apply (near v) with t; [| apply part; now left | exact on_t].
    now apply (within_along radius w from to). }
  assert (one : sum (map (signed_crossing_of_step from to) (region_edges r)) = 1%Z).
  { rewrite edges_are, map_app. cbn [map].
    assert (sum_app : forall a b, sum (a ++ b) = (sum a + sum b)%Z).
    { intros a b. unfold sum. induction a as [| c a IH]; cbn; [reflexivity | rewrite IH; lia]. }
    rewrite sum_app. change (sum (signed_crossing_of_step from to s :: map (signed_crossing_of_step from to) later))
      with (signed_crossing_of_step from to s + sum (map (signed_crossing_of_step from to) later))%Z.
    rewrite once, (others earlier), (others later); [reflexivity | |];
      intros t J; apply in_app_iff; tauto. }
  split; [exact off_to |]. split; [exact off_from |]. lia.
Qed.

(* Theorem. So what is close to its left is inside, if no winding number is negative. *)
Theorem left_of_an_edge_is_inside (r : region) (s : segment) (w n : vector) :
  nowhere_negative r -> edges_meet_in_vertices r ->
  In s (region_edges r) -> lies_on w s -> ~ is_vertex w r -> 0 < cross (along s) n ->
  eventually (fun e => inside (moved_along w n e) r).
Proof.
  intros valid meet I on no_vertex left_.
  refine (eventually_implied _ _ _ (left_is_one_more r s w n meet I on no_vertex left_)).
  intros e (off_to & off_from & more). split; [exact off_to |].
  pose proof (valid _ off_from). lia.
Qed.

(* Adding small multiples of a number, one leaves every number. *)
Lemma leaves_a_number (a b c : Q) : ~ b == 0 -> eventually (fun e => ~ a + e * b == c).
Proof.
  intros some. destruct (Qlt_le_dec 0 ((c - a) / b)) as [ahead | behind].
  - exists ((c - a) / b). split; [exact ahead |]. intros e _ below equal.
    assert (e == (c - a) / b); [| lra]. rewrite <- equal. field. exact some.
  - exists 1. split; [lra |]. intros e positive_ _ equal.
    assert (e == (c - a) / b); [| lra]. rewrite <- equal. field. exact some.
Qed.

(* Of the points close to w in a direction, at most one is a given point. *)
Lemma leaves_a_point (w u v : vector) : nonzero u -> eventually (fun e => ~ equal_vectors (moved_along w u e) v).
Proof.
  intros moves.
  destruct (Qeq_dec (vx u) 0) as [no_x | some_x].
  - destruct (Qeq_dec (vy u) 0) as [no_y | some_y]; [exfalso; now apply moves |].
    refine (eventually_implied _ _ _ (leaves_a_number (vy w) (vy u) (vy v) some_y)).
    intros e differ [_ equal]. exact (differ equal).
  - refine (eventually_implied _ _ _ (leaves_a_number (vx w) (vx u) (vx v) some_x)).
    intros e differ [equal _]. exact (differ equal).
Qed.

(* Near each point of an edge are points of it that are no vertices. *)
Lemma no_vertex_near (r : region) (s : segment) (w : vector) (radius : Q) :
  nonzero (along s) -> lies_on w s -> 0 < radius ->
  exists v, within radius w v /\ lies_on v s /\ ~ is_vertex v r.
Proof.
  intros long (k & [k0 k1] & X & Y) R.
  assert (found : forall u, nonzero u -> eventually (fun e => lies_on (moved_along w u e) s) ->
    exists v, within radius w v /\ lies_on v s /\ ~ is_vertex v r).
  { intros u moves on.
    destruct (eventually_and _ _ on (eventually_and _ _ (small_steps_stay_within radius w u R)
      (eventually_for_all (fun t e => ~ equal_vectors (moved_along w u e) (source t)) (region_edges r)
         (fun t _ => leaves_a_point w u (source t) moves)))) as (limit & L & near).
    destruct (near ((1 # 2) * limit)) as (on_s & close & differ); [lra | lra |].
    exists (moved_along w u ((1 # 2) * limit)). split; [exact close |]. split; [exact on_s |].
    intros (t & I & equal). exact (differ t I equal). }
  destruct (Qlt_le_dec k 1) as [before_end | at_end].
  - apply (found (along s) long). exists (1 - k). split; [lra |]. intros e positive_ below.
    exists (k + e). unfold moved_along, along, minus; cbn [vx vy]. split; [lra |].
    rewrite X, Y. split; ring.
  - apply (found (opposite (along s)) (opposite_nonzero _ long)). exists 1. split; [lra |]. intros e positive_ below.
    exists (k - e). unfold moved_along, along, opposite, minus; cbn [vx vy]. split; [lra |].
    rewrite X, Y. split; ring.
Qed.

Lemma within_twice (r1 r2 radius : Q) (x y z : vector) :
  r1 + r2 <= radius -> within r1 x y -> within r2 y z -> within radius x z.
Proof. unfold within. lra. Qed.

(* Theorem. So such a region is the closure of its interior. *)
Theorem regions_are_regular (r : region) :
  no_edges_are_points r -> nowhere_negative r -> edges_meet_in_vertices r -> is_regular r.
Proof.
  intros not_points valid meet w s radius I on R.
  pose proof (winding_number_of_the_sum.region_edges_are_directions r not_points s I) as long.
  destruct (no_vertex_near r s w ((1 # 2) * radius) long on) as (v & near_v & on_v & no_vertex); [lra |].
  set (n := Vector (- vy (along s)) (vx (along s))).
  assert (left_ : 0 < cross (along s) n).
  { unfold cross, n; cbn [vx vy].
    destruct (Qlt_le_dec 0 (vx (along s) * vx (along s) + vy (along s) * vy (along s))) as [| none]; [lra |].
    exfalso. apply long. now apply no_squares. }
  destruct (eventually_and _ _ (left_of_an_edge_is_inside r s v n valid meet I on_v no_vertex left_)
    (small_steps_stay_within ((1 # 2) * radius) v n ltac:(lra))) as (limit & L & near).
  destruct (near ((1 # 2) * limit)) as (in_r & close); [lra | lra |].
  exists (moved_along v n ((1 # 2) * limit)). split; [| exact in_r].
  apply (within_twice ((1 # 2) * radius) ((1 # 2) * radius) radius w v); [lra | exact near_v | exact close].
Qed.

(* Every point of a region has points inside near it. *)
Lemma inside_near (r : region) (a : vector) (radius : Q) :
  is_regular r -> in_region a r -> 0 < radius -> exists z, within radius a z /\ inside z r.
Proof.
  intros regular [positive_ | (s & I & on)] R; [| now apply (regular a s)].
  assert (close : eventually (fun e => within radius a (moved (shifted a) e))).
  { refine (eventually_implied _ _ _ (eventually_and _ _
      (ex_intro _ 1 (conj _ (fun e some below => conj some below)))
      (small_steps_stay_within radius a (Vector 1 1) R))); [| lra].
    intros e [[some below] near]. unfold within, moved_along, moved, shifted in *; cbn in *.
    assert (0 <= e * e <= e) by nra. lra. }
  assert (free : eventually (fun e => off (moved (shifted a) e) (region_edges r))).
  { apply (eventually_for_all (fun s e => ~ lies_on (moved (shifted a) e) s)). intros s _. apply shifted_off. }
  destruct (eventually_and _ _ close (eventually_and _ _ free (same_beside a (region_edges r))))
    as (limit & L & near).
  destruct (near ((1 # 2) * limit)) as (near_a & off_r & same_number); [lra | lra |].
  exists (moved (shifted a) ((1 # 2) * limit)). split; [exact near_a |]. split; [exact off_r | lia].
Qed.
