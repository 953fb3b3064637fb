(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The region of a rule over winding numbers, in the words of specification.v: it is the closure of the interior of the
   set that the rule describes off all segments, and a valid region. What is to be proved of a rule is what it says
   there; that chains touch, overlap or cross does not matter any more. *)
From Coq Require Import QArith Lqa ZArith Lia Bool List Permutation.
From Oplus Require Import specification checker regions_and_sums homogeneous_points specification_bridge filling walks
  kept_pieces_go_round rule_of_sides region_of_pieces sum_program sum_is_right inner_fit_program
  complement_in_a_frame.
Import ListNotations.

Open Scope Q_scope.

Lemma member_off_edges (x : point) (r : polygonal_region) : valid_region (as_region r) ->
  off (as_vector x) (region_edges (as_region r)) ->
  (member x r <-> (0 <? winding_number (as_vector x) (region_edges (as_region r)))%Z = true).
Proof.
  intros valid free. rewrite member_of_region by exact valid. unfold in_region. rewrite Z.ltb_lt.
  split; [intros [? | (s & S & on)]; [assumption | destruct (free s S on)] | tauto].
Qed.

(* What is returned has the coordinates of the chains, in other words. *)
Lemma written_chains_are_valid (chains : region) : valid_region chains ->
  valid_region (as_region (as_polygonal chains)).
Proof. intros valid. destruct (as_image chains) as (h & same & ->). now apply images_are_valid. Qed.

Lemma member_of_written_chains (x : point) (chains : region) : valid_region chains ->
  (member x (as_polygonal chains) <-> in_region (as_vector x) chains).
Proof. exact (member_of_valid_chains x chains). Qed.

Definition region_by_rule (rule : list Z -> bool) (families : list (list segment)) : polygonal_region :=
  let pieces := boundary_by_rule rule families in as_polygonal (chains_of (length pieces) pieces).

Lemma closure_of_interior (A : point -> Prop) (x : point) :
  regularised (fun v => A (as_point v)) (as_vector x) <-> closure (interior A) x.
Proof.
  split.
  - intros closure_ radius R. destruct (closure_ radius R) as (y & close & inner & I & all_in).
    exists (as_point y). split; [exact close |]. exists inner. split; [exact I |]. intros b close_b.
    specialize (all_in (as_vector b)). destruct b. apply all_in. exact close_b.
  - intros closure_ radius R. destruct (closure_ radius R) as (y & close & inner & I & all_in).
    exists (as_vector y). split; [exact close |]. exists inner. split; [exact I |]. intros z close_z.
    apply all_in. exact close_z.
Qed.

Section ByRule.
  Variable rule : list Z -> bool.
  Variable families : list (list segment).
  Hypothesis closed : forall l, In l families -> cycles l.
  Hypothesis all_long : forall t, In t (concat families) -> nonzero (along t).
  Hypothesis nothing : rule (map (fun _ => 0%Z) families) = false.

  Let ends_ := rule_ends_at_pieces rule families closed all_long nothing.

  Let pieces := boundary_by_rule rule families.
  Let chains := chains_of (length pieces) pieces.

  Lemma chains_by_rule : Permutation (region_edges chains) pieces.
  Proof. exact (chains_of_kept _ _ _ ends_). Qed.

  Lemma chains_by_rule_are_valid : valid_region chains.
  Proof. exact (chains_are_valid _ _ _ ends_ _ chains_by_rule). Qed.

  (* Theorem. *)
  Theorem region_by_rule_is_valid : valid_region (as_region (region_by_rule rule families)).
  Proof. exact (written_chains_are_valid _ chains_by_rule_are_valid). Qed.

  (* Theorem. *)
  Theorem members_by_rule (A : point -> Prop) (x : point) :
    (forall y, off (as_vector y) (concat families) -> (A y <-> by_rule rule families (as_vector y) = true)) ->
    (member x (region_by_rule rule families) <-> closure (interior A) x).
  Proof.
    intros A_is. unfold region_by_rule. cbv zeta. fold pieces. fold chains.
    rewrite (member_of_written_chains x _ chains_by_rule_are_valid), <- closure_of_interior.
    apply (points_of_the_chains _ all_long _ _ ends_ _ chains_by_rule). intros y free.
    specialize (A_is (as_point y)). rewrite as_vector_of_point in A_is. now apply A_is.
  Qed.

  (* Corollary. *)
  Corollary members_of_a_closed_set (A : point -> Prop) (x : point) :
    (forall y, off (as_vector y) (concat families) -> (A y <-> by_rule rule families (as_vector y) = true)) ->
    (forall y t, In t (concat families) -> lies_on (as_vector y) t -> A y) ->
    (forall y, A y -> closure (interior A) y) ->
    (member x (region_by_rule rule families) <-> A x).
  Proof.
    intros A_is on_segments regular. unfold region_by_rule. cbv zeta. fold pieces. fold chains.
    rewrite (member_of_written_chains x _ chains_by_rule_are_valid).
    rewrite (points_of_a_closed_set _ all_long _ _ ends_ _ chains_by_rule (fun v => A (as_point v)) (as_vector x)).
    - now destruct x.
    - intros y free. specialize (A_is (as_point y)). rewrite as_vector_of_point in A_is. now apply A_is.
    - intros y t T on. apply (on_segments _ t T). now rewrite as_vector_of_point.
    - intros y in_A. rewrite <- (as_vector_of_point y). now apply closure_of_interior, regular.
  Qed.
End ByRule.
