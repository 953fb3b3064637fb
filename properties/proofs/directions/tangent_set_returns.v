(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* What `in_tangent_set` returns (tangent_set.v): whether the direction is met on the way counterclockwise from the edge
   that enters a vertex to the one that leaves it (thesis, Definition 2.1.13), all directions of Q turned a little
   (Definition 2.2.7). Rotating is from rotation.v, turning Q's directions from tie_rule.v. *)
From Coq Require Import Bool List.
From Oplus Require Import numbers winding tangent_set shifted_ray rotation tie_rule forward_traversal.
Import ListNotations.

Open Scope Q_scope.

(* Theorem. For a direction d of one summand, a corner of the other, and every epsilon that is small enough: d is in
   the tangent set if and only if, while rotating counterclockwise from the edge that enters, d is met before the
   edge that leaves, and that before the turn is full; where directions of Q are turned by epsilon. *)
Theorem in_tangent_set_returns (d : direction) (c : corner) : proper d -> proper_corner c ->
  let enters := Direction (incoming c) (other (of d)) in
  let leaves := Direction (outgoing c) (other (of d)) in
  eventually (fun epsilon =>
    (in_tangent_set d c = true <->
     exists s t, 0 < s /\ s < t /\ t < 4 /\
       same_direction (nudged epsilon d) (turned (nudged epsilon enters) s) /\
       same_direction (nudged epsilon leaves) (turned (nudged epsilon enters) t))).
Proof.
  intros proper_d [proper_in proper_out] enters leaves.
  assert (all_proper : forall u, In u [d; enters; leaves] -> proper u)
    by (intros u [<- | [<- | [<- | []]]]; assumption).
  refine (eventually_implied _ _ _ (eventually_and _ _ (tie_rule_is_a_rotation _ all_proper)
    (eventually_and _ _ (nudged_order d enters proper_d proper_in)
      (nudged_order leaves leaves proper_out proper_out)))).
  intros epsilon ([_ same_] & (of_d & of_enters & _) & (of_leaves & _)).
  unfold in_tangent_set. fold enters leaves.
  rewrite (same_ d enters leaves) by (cbn; tauto). now apply ccw_is_met_first.
Qed.
