(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The complement of a region has its chains, turned: they go round what was outside. That edges belong to it is all
   that there is to prove: near each of their points is one outside. In any frame around a point, an unbounded region is
   a bounded one there. *)
From Coq Require Import QArith Lqa ZArith Lia Bool List.
From Oplus Require Import specification regions_and_sums specification_bridge collision_is_complete checked_collision
  sum_program sum_is_right coordinates open_sums turned_chains inner_fit_program complement_in_a_frame
  inner_fit_is_right.
Import ListNotations.

Open Scope Q_scope.

Definition turned_region (r : region) : polygonal_region := as_polygonal (map turned_chain r).

Lemma unbounded_member_is (x : point) (r : polygonal_region) : unbounded_member x r <-> ~ is_inner_point x r.
Proof.
  unfold unbounded_member. rewrite on_boundary_is, number_of_region_is, inner_point_is.
  destruct (on_or_off (as_vector x) (region_edges (as_region r))) as [on | free],
    (Z.eq_dec (winding_number (as_vector x) (region_edges (as_region r))) 0); rewrite off_is in *; tauto.
Qed.

Lemma unbounded_member_of_chains (x : point) (r : region) : unbounded_member x (as_polygonal r) <->
  (exists s, In s (region_edges r) /\ lies_on (as_vector x) s) \/ winding_number (as_vector x) (region_edges r) = 0%Z.
Proof.
  unfold unbounded_member, as_polygonal. rewrite on_boundary_is, number_of_region_is.
  destruct (chains_as_points (as_vector x) r) as [-> ->]. reflexivity.
Qed.

(* What is not in A, if off some edges that is where numbers are 0, and edges are beside such points. *)
Lemma closure_of_the_rest (A : point -> Prop) (edges_ : list segment) (number : Z) (x : point) : cycles edges_ ->
  (forall y, off (as_vector y) edges_ -> (~ A y <-> winding_number (as_vector y) edges_ = number)) ->
  (forall s radius, In s edges_ -> lies_on (as_vector x) s -> 0 < radius ->
    exists y, is_near radius x y /\ ~ A y) ->
  (closure (fun y => ~ A y) x <->
   (exists s, In s edges_ /\ lies_on (as_vector x) s) \/ winding_number (as_vector x) edges_ = number).
Proof.
  intros closed A_is beside. destruct (on_or_off (as_vector x) edges_) as [(s & S & on) | free].
  - split; [intros _; left; now exists s | intros _ radius R; now apply (beside s)].
  - split.
    + intros near. right. destruct (winding_number_near _ _ closed free) as (radius & R & same_).
      destruct (near radius R) as (y & close & out). destruct (same_ (as_vector y) close) as [free_y <-].
      now apply A_is.
    + intros [(s & S & on) | number_is] radius R; [destruct (free s S on) |]. exists x.
      split; [unfold is_near; lra | now apply A_is].
Qed.

(* Theorem. *)
Theorem turned_region_is_the_complement (p : polygonal_region) : valid_region (as_region p) ->
  nowhere_above_one (as_region p) -> is_complement p (turned_region (as_region p)).
Proof.
  intros valid simple x. unfold turned_region. rewrite unbounded_member_of_chains, on_turned, winding_number_of_turned.
  assert (outside : forall y, off (as_vector y) (region_edges (as_region p)) ->
    (~ member y p <-> winding_number (as_vector y) (region_edges (as_region p)) = 0%Z)).
  { intros y free. rewrite member_by_edges. split; [intros out | intros zero_ [(s & S & on) | round]].
    - destruct (Z.eq_dec (winding_number (as_vector y) (region_edges (as_region p))) 0); tauto.
    - exact (free s S on).
    - contradiction. }
  rewrite (closure_of_the_rest _ _ 0 x (region_cycles _) outside).
  - split; (intros [on | number_is]; [now left | right; lia]).
  - intros s radius S on R. destruct (outside_is_near _ _ s radius valid simple S on R) as (y & close & free & zero_).
    exists (as_point y). split; [exact close |]. apply outside; now rewrite as_vector_of_point.
Qed.

(* An unbounded region, all of whose chains are in a square, is one with a larger square as its outer chain. *)
Definition framed (u : region) : region := frame (2 * size_of (concat u)) :: u.

Section Unbounded.
  Variable u : region.
  Hypothesis valid : valid_region (framed u).
  Hypothesis simple : nowhere_above_one (framed u).
  Let m := size_of (concat u).

  Lemma u_is_in_the_square : 1 <= m /\ forall s, In s (region_edges u) -> in_square m (source s) /\ in_square m
    (target s).
  Proof.
    destruct (size_is_large (concat u)) as [large all]. split; [exact large | now apply edges_in_square].
  Qed.

  Lemma number_in_the_frame (x : vector) : in_square m x ->
    (off x (region_edges (framed u)) <-> off x (region_edges u)) /\
    winding_number x (region_edges (framed u)) = (1 + winding_number x (region_edges u))%Z.
  Proof.
    destruct u_is_in_the_square as [large _]. intros [in_x in_y].
    change (region_edges (framed u)) with (edges (frame (2 * m)) ++ region_edges u).
    rewrite number_of_both, frame_goes_round by lra. split; [| reflexivity].
    pose proof (off_the_frame (2 * m) x ltac:(lra) ltac:(lra)) as apart.
    split; intros free s S; [apply free, in_app_iff; now right |]. apply in_app_iff in S. destruct S; auto.
  Qed.

  Lemma number_of_unbounded (x : vector) : off x (region_edges u) ->
    winding_number x (region_edges u) = 0%Z \/ winding_number x (region_edges u) = (-1)%Z.
  Proof.
    intros free. destruct u_is_in_the_square as [large all]. destruct (is_in_square_spec m x) as [close | far].
    - destruct (number_in_the_frame x close) as [free_is number_is]. apply free_is in free.
      destruct valid as (_ & not_negative & _). pose proof (not_negative x free). pose proof (simple x free). lia.
    - left. now apply (nothing_goes_round_outside m); [apply region_cycles | |].
  Qed.

  (* Theorem. *)
  Theorem turned_region_is_the_complement_of_unbounded : is_complement_of_unbounded (as_polygonal u) (turned_region u).
  Proof.
    intros x. unfold turned_region, as_polygonal at 2. rewrite member_of_chains, on_turned, winding_number_of_turned.
    assert (outside : forall y, off (as_vector y) (region_edges u) ->
      (~ unbounded_member y (as_polygonal u) <-> winding_number (as_vector y) (region_edges u) = (-1)%Z)).
    { intros y free. rewrite unbounded_member_of_chains. destruct (number_of_unbounded _ free) as [number_is |
        number_is].
      - rewrite number_is. split; [tauto | discriminate].
      - split; [trivial |]. intros _ [(s & S & on) | zero_]; [exact (free s S on) | congruence]. }
    rewrite (closure_of_the_rest _ _ (-1) x (region_cycles _) outside).
    - destruct (on_or_off (as_vector x) (region_edges u)) as [on | free]; [tauto |].
      destruct (number_of_unbounded _ free); split; (intros [on | number_is]; [now left | right; lia]).
    - intros s radius S on R. destruct u_is_in_the_square as [large all]. destruct (all s S) as [in_source in_target].
      pose proof (squares_are_convex m s _ in_source in_target on) as close_x.
      assert (S' : In s (region_edges (framed u))) by (apply (in_or_app (edges (frame (2 * m)))); now right).
      assert (small : 0 < Qminmax.Qmin radius m) by (apply Qminmax.Q.min_glb_lt; lra).
      destruct (outside_is_near _ _ s _ valid simple S' on small) as (y & close & free & zero_).
      pose proof (Qminmax.Q.le_min_l radius m). pose proof (Qminmax.Q.le_min_r radius m).
      exists (as_point y). split; [exact (within_smaller _ _ _ _ (Qminmax.Q.le_min_l radius m) close) |].
      change (region_edges (framed u)) with (edges (frame (2 * m)) ++ region_edges u) in *.
      unfold within, in_square in *.
      rewrite number_of_both, frame_goes_round in zero_ by lra. apply outside; rewrite as_vector_of_point; [| lia].
      intros t T. apply free, in_app_iff. now right.
  Qed.

  (* Theorem. The frame does not matter: in every square it is the same. *)
  Theorem the_frame_does_not_matter (k : Q) (x : point) : - k < x_of x < k -> - k < y_of x < k ->
    (member x (as_polygonal (frame k :: u)) <-> unbounded_member x (as_polygonal u)).
  Proof.
    intros in_x in_y. unfold as_polygonal at 1. rewrite member_of_chains, unbounded_member_of_chains.
    change (region_edges (frame k :: u)) with (edges (frame k) ++ region_edges u).
    rewrite number_of_both, frame_goes_round by assumption.
    pose proof (off_the_frame k (as_vector x) in_x in_y) as apart.
    destruct (on_or_off (as_vector x) (region_edges u)) as [(s & S & on) | free].
    - split; intros _; left; exists s; (split; [| exact on]); [exact S | apply in_app_iff; now right].
    - destruct (number_of_unbounded _ free) as [number_is | number_is]; rewrite number_is.
      + split; intros _; right; [reflexivity | discriminate].
      + split; intros [(s & S & on) | wrong]; try (exfalso; exact (free s S on)); try (exfalso; now apply wrong);
          try discriminate.
        apply in_app_iff in S. exfalso. destruct S as [S | S]; [exact (apart s S on) | exact (free s S on)].
  Qed.
End Unbounded.
