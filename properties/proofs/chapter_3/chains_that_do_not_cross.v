(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Chains of a region that may touch, but do not cross (thesis, Definition 2.1.17). A chain passes a point u along an
   edge that goes through u, or by a corner at u: it comes in a direction f and goes on in a direction g. To the left of
   the pass is the angle from g counterclockwise to where the chain comes from, to the right is the rest. Two passes
   cross if one chain comes from the left of the other and goes on to its right, or the other way round. And a test by
   computation, for examples. *)
From Coq Require Import Lia Bool List.
From Oplus Require Import numbers convolution signed_crossings location regions meeting_of_segments left_of_an_edge
  winding_number_of_the_sum neighbourhoods theorem_4_2_1
  interiors_meet simple_chain boundary_points fans_that_touch edges_at_a_point reduced_edges_that_pass.
Import ListNotations.

Open Scope Q_scope.

Definition is_pass (r : region) (u f g : vector) : Prop :=
  (exists e, In e (region_edges r) /\ strictly_inside u e /\ f = along e /\ g = along e) \/
  (exists chain j, In chain r /\ (j < length chain)%nat /\ equal_vectors u (vertex chain j) /\
     f = edge_of_chain chain (previous (length chain) j) /\ g = edge_of_chain chain j).

Definition left_of_pass (f g v : vector) : Prop :=
  (0 <= cross f g /\ 0 < cross f v /\ 0 < cross g v) \/ (cross f g < 0 /\ (0 < cross f v \/ 0 < cross g v)).
Definition right_of_pass (f g v : vector) : Prop :=
  (0 <= cross f g /\ (cross f v < 0 \/ cross g v < 0)) \/ (cross f g < 0 /\ cross f v < 0 /\ cross g v < 0).

Definition passes_cross (f g f' g' : vector) : Prop :=
  (left_of_pass f g (opposite f') /\ right_of_pass f g g') \/
  (right_of_pass f g (opposite f') /\ left_of_pass f g g').

Definition chains_do_not_cross (r : region) : Prop :=
  forall u f g f' g', is_pass r u f g -> is_pass r u f' g' -> ~ passes_cross f g f' g'.

Section Passes.
  Variable r : region.
  Hypothesis not_points : no_edges_are_points r.

  Lemma pass_of_departing (u : vector) (b : segment) : In b (region_edges r) -> departs u b = true ->
    exists f, is_pass r u f (along b).
  Proof.
    intros B there. apply departs_is in there. destruct there as [on goes_on].
    destruct (inside_or_end u b on) as [inside_ | [start | end_]].
    - exists (along b). left. now exists b.
    - destruct (edge_by_chain r b B) as (chain & j & C & J & ->).
      exists (edge_of_chain chain (previous (length chain) j)). right. exists chain, j.
      split; [exact C |]. split; [exact J |]. split; [now rewrite edge_at_is in start by exact J; symmetry |].
      split; [reflexivity |]. unfold edge_at. now rewrite <- direction_by_index.
    - destruct goes_on. now symmetry.
  Qed.

  Lemma pass_of_arriving (u : vector) (h : segment) : In h (region_edges r) -> arrives u h = true ->
    exists g, is_pass r u (along h) g.
  Proof.
    intros H there. apply arrives_is in there. destruct there as [on comes].
    destruct (inside_or_end u h on) as [inside_ | [start | end_]].
    - exists (along h). left. now exists h.
    - destruct comes. now symmetry.
    - destruct (edge_by_chain r h H) as (chain & i & C & I & ->). pose proof (next_in_range _ _ I) as J.
      exists (edge_of_chain chain (next i (length chain))). right. exists chain, (next i (length chain)).
      split; [exact C |]. split; [exact J |]. split; [now rewrite edge_at_is in end_ by exact I; symmetry |].
      split; [| reflexivity]. rewrite previous_next by exact I. unfold edge_at. now rewrite <- direction_by_index.
  Qed.

  (* Edges of a pass come to the point, or leave it. *)
  Lemma edges_of_a_pass (u f g : vector) : is_pass r u f g ->
    (exists s, In s (region_edges r) /\ arrives u s = true /\ along s = f) /\
    (exists t, In t (region_edges r) /\ departs u t = true /\ along t = g).
  Proof.
    intros [(e & E & inside_ & -> & ->) | (chain & j & C & J & equal & -> & ->)].
    - pose proof (region_edges_are_directions r not_points e E) as long.
      pose proof (strictly_inside_lies_on u e inside_) as on. destruct inside_ as (k & range & X & Y).
      split; exists e; (split; [exact E |]; split; [| reflexivity]);
        [apply arrives_is | apply departs_is]; (split; [exact on |]); intros [X' Y']; apply long;
        unfold along, minus; cbn [vx vy]; rewrite X in X'; rewrite Y in Y'.
      + split; apply (Qmult_inj_r _ _ k); lra.
      + split; apply (Qmult_inj_r _ _ (1 - k)); lra.
    - destruct (at_vertex_of_chain r chain j u not_points C J equal) as (_ & leaves & comes). split.
      + exists (edge_at chain (previous (length chain) j)). pose proof (previous_below _ _ J) as P.
        split; [now apply edge_at_in_region |]. split; [exact comes |].
        unfold edge_at. now rewrite <- direction_by_index.
      + exists (edge_at chain j). split; [now apply edge_at_in_region |]. split; [exact leaves |].
        unfold edge_at. now rewrite <- direction_by_index.
  Qed.
End Passes.

Lemma passes_turn (r : region) (u f g : vector) : valid_region r -> is_pass r u f g -> turns f g.
Proof.
  intros r_region [(e & E & _ & -> & ->) | (chain & j & C & J & _ & -> & ->)]; [| now apply (corner_turns r)].
  pose proof (region_edges_are_directions r (proj1 r_region) e E) as long. split; [exact long |].
  split; [exact long |]. intros _. now apply square_positive.
Qed.

Lemma pass_does_not_cross_itself (f g : vector) : ~ passes_cross f g f g.
Proof. unfold passes_cross, left_of_pass, right_of_pass, cross, opposite. cbn [vx vy]. lra. Qed.

(* At points that are no vertices there is one pass only. *)
Lemma passes_cross_at_vertices (r : region) (u f g f' g' : vector) : valid_region r -> ~ is_vertex u r ->
  is_pass r u f g -> is_pass r u f' g' -> ~ passes_cross f g f' g'.
Proof.
  intros r_region no_vertex first_ second.
  assert (on_edges : forall a b, is_pass r u a b ->
    exists e, In e (region_edges r) /\ lies_on u e /\ a = along e /\ b = along e).
  { intros a b [(e & E & inside_ & -> & ->) | (chain & j & C & J & equal & _)].
    - exists e. split; [exact E |]. split; [now apply strictly_inside_lies_on | now split].
    - destruct no_vertex. now apply (at_vertex_of_chain r chain j u (proj1 r_region) C J). }
  destruct (on_edges _ _ first_) as (e & E & on_e & -> & ->), (on_edges _ _ second) as (e' & E' & on_e' & -> & ->).
  destruct (in_split _ _ E) as (earlier & later & edges_are). destruct r_region as (_ & _ & meet).
  rewrite edges_are in E'. apply in_elt_inv in E'. destruct E' as [-> | E']; [apply pass_does_not_cross_itself |].
  destruct no_vertex. exact (meet earlier e later e' u edges_are E' on_e on_e').
Qed.

(* Theorem. Chains that do not touch have one pass at each vertex, too. *)
Theorem chains_that_do_not_touch_do_not_cross (r : region) : valid_region r -> chains_do_not_touch r ->
  chains_do_not_cross r.
Proof.
  intros r_region apart u f g f' g' first_ second. pose proof (proj1 r_region) as not_points.
  destruct (vertex_or_not u r) as [(v & V & equal) | no_vertex];
    [| now apply (passes_cross_at_vertices r u f g f' g')].
  destruct (edge_by_chain r v V) as (chain & j & C & J & ->). rewrite edge_at_is in equal by exact J.
  cbn [source] in equal.
  assert (one : forall a b, is_pass r u a b ->
    a = edge_of_chain chain (previous (length chain) j) /\ b = edge_of_chain chain j).
  { intros a b pass. pose proof (previous_below _ _ J) as I. destruct (apart chain j C J) as (_ & _ & _ & only).
    destruct (edges_of_a_pass r not_points u a b pass) as [(s & S & comes & <-) (t & T & leaves & <-)].
    assert (at_u : equal_vectors u (source (edge_at chain j))) by (now rewrite edge_at_is).
    assert (which : forall e, In e (region_edges r) -> lies_on u e ->
      e = edge_at chain (previous (length chain) j) \/ e = edge_at chain j)
      by (intros e E on; apply only; [exact E | now apply (lies_on_equal u)]).
    apply arrives_is in comes. apply departs_is in leaves. destruct comes as [on_s comes], leaves as [on_t leaves].
    rewrite !direction_by_index by assumption. fold (edge_at chain (previous (length chain) j)) (edge_at chain j).
    split.
    - destruct (which s S on_s) as [-> | ->]; [reflexivity | contradiction].
    - destruct (which t T on_t) as [-> | ->]; [| reflexivity]. destruct leaves.
      rewrite edge_at_is, next_previous by assumption. exact equal. }
  destruct (one f g first_) as [-> ->], (one f' g' second) as [-> ->]. apply pass_does_not_cross_itself.
Qed.

(* A test: all passes at all vertices. *)
Definition passes_at (r : region) (u : vector) : list (vector * vector) :=
  flat_map (fun e => if is_on_segment u e && negb (same_place u (source e) || same_place u (target e))
      then [(along e, along e)] else []) (region_edges r) ++
  flat_map (fun chain => flat_map (fun j => if same_place u (vertex chain j)
      then [(edge_of_chain chain (previous (length chain) j), edge_of_chain chain j)] else [])
    (seq 0 (length chain))) r.

Definition is_left_of_pass (f g v : vector) : bool :=
  if Qlt_le_dec (cross f g) 0 then positive (cross f v) || positive (cross g v)
  else positive (cross f v) && positive (cross g v).
Definition is_right_of_pass (f g v : vector) : bool :=
  if Qlt_le_dec (cross f g) 0 then negative (cross f v) && negative (cross g v)
  else negative (cross f v) || negative (cross g v).

Definition cross_nowhere (r : region) : bool :=
  forallb (fun e => let passes := passes_at r (source e) in
    forallb (fun a => forallb (fun b =>
      negb (is_left_of_pass (fst a) (snd a) (opposite (fst b)) && is_right_of_pass (fst a) (snd a) (snd b)) &&
      negb (is_right_of_pass (fst a) (snd a) (opposite (fst b)) && is_left_of_pass (fst a) (snd a) (snd b)))
      passes) passes) (region_edges r).

Lemma is_left_of_pass_iff (f g v : vector) : is_left_of_pass f g v = true <-> left_of_pass f g v.
Proof.
  unfold is_left_of_pass, left_of_pass. destruct (Qlt_le_dec (cross f g) 0) as [right_ | left_];
    destruct (positive_spec (cross f v)), (positive_spec (cross g v)); cbn [andb orb];
    intuition (try discriminate; lra).
Qed.

Lemma is_right_of_pass_iff (f g v : vector) : is_right_of_pass f g v = true <-> right_of_pass f g v.
Proof.
  unfold is_right_of_pass, right_of_pass. destruct (Qlt_le_dec (cross f g) 0) as [right_ | left_];
    destruct (negative_spec (cross f v)), (negative_spec (cross g v)); cbn [andb orb];
    intuition (try discriminate; lra).
Qed.

Lemma passes_are_listed (r : region) (u v f g : vector) : no_edges_are_points r -> equal_vectors v u ->
  is_pass r u f g -> In (f, g) (passes_at r v).
Proof.
  intros not_points equal [(e & E & inside_ & -> & ->) | (chain & j & C & J & at_ & -> & ->)]; apply in_app_iff.
  - left. apply in_flat_map. exists e. split; [exact E |].
    pose proof (region_edges_are_directions r not_points e E) as long.
    destruct (is_on_spec v e) as [_ | free];
      [| destruct free; apply (lies_on_equal u); [now symmetry | now apply strictly_inside_lies_on]].
    destruct inside_ as (k & range & X & Y), equal as [vx_ vy_].
    destruct (same_place_spec v (source e)) as [[X' Y'] |], (same_place_spec v (target e)) as [[X'' Y''] |];
      cbn [orb andb negb]; try (now left); exfalso; apply long; unfold along, minus; cbn [vx vy];
      rewrite vx_, vy_, ?X, ?Y in *.
    + split; apply (Qmult_inj_r _ _ k); lra.
    + split; apply (Qmult_inj_r _ _ k); lra.
    + split; apply (Qmult_inj_r _ _ (1 - k)); lra.
  - right. apply in_flat_map. exists chain. split; [exact C |]. apply in_flat_map. exists j.
    split; [apply in_seq; lia |]. destruct (same_place_spec v (vertex chain j)) as [_ | other]; [now left |].
    destruct other. destruct equal, at_. split; lra.
Qed.

(* Theorem. What passes the test has chains that do not cross. *)
Theorem cross_nowhere_is_right (r : region) : valid_region r -> cross_nowhere r = true -> chains_do_not_cross r.
Proof.
  intros r_region test u f g f' g' first_ second.
  assert (at_vertex : is_vertex u r -> ~ passes_cross f g f' g').
  { intros (e & E & equal) crossing_. unfold cross_nowhere in test. rewrite forallb_forall in test.
    specialize (test e E). cbv zeta in test. rewrite forallb_forall in test.
    assert (equal' : equal_vectors (source e) u) by now symmetry.
    specialize (test _ (passes_are_listed r u _ f g (proj1 r_region) equal' first_)). rewrite forallb_forall in test.
    specialize (test _ (passes_are_listed r u _ f' g' (proj1 r_region) equal' second)). cbn [fst snd] in test.
    apply andb_true_iff in test. destruct test as [none none']. apply negb_true_iff in none, none'.
    destruct crossing_ as [[left_ right_] | [right_ left_]]; apply is_left_of_pass_iff in left_;
      apply is_right_of_pass_iff in right_; rewrite left_, right_ in *; discriminate. }
  destruct (vertex_or_not u r) as [| no_vertex]; [now apply at_vertex |].
  now apply (passes_cross_at_vertices r u f g f' g').
Qed.
