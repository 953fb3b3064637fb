(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* A check, by finitely many comparisons, that a region covers nothing twice: its winding numbers are 0 and 1. With the
   check of test_of_regions.v no hypothesis of the theorems on the collision test (placed_collision.v) is left open. *)
From Coq Require Import QArith ZArith Lia Bool List.
From Oplus Require Import regions_and_sums right_of_an_edge small_polygons test_of_regions small_regions location
  pieces naive_collision collision_is_complete placed_collision.
Import ListNotations.

Open Scope Q_scope.

(* To the right of the middle of each edge is the outside. *)
Definition covers_nothing_twice (r : region) : bool :=
  is_valid_region r &&
  forallb (fun s => (winding_number_shifted (right_of_middle s) (region_edges r) <=? 0)%Z) (region_edges r).

(* Theorem. What passes the check is a valid region whose winding numbers are 0 and 1. *)
Theorem covers_nothing_twice_is_right (r : region) :
  covers_nothing_twice r = true -> valid_region r /\ nowhere_above_one r.
Proof.
  unfold covers_nothing_twice. rewrite andb_true_iff, forallb_forall. intros [check middles].
  pose proof (is_valid_region_is_right r check) as r_region. split; [exact r_region |].
  destruct r_region as (not_points & _ & meet).
  unfold is_valid_region in check. rewrite !andb_true_iff, !forallb_forall in check. destruct check as ((_ & clear_) & _).
  intros x free.
  destruct (winding_number_by_middles r x not_points meet)
    as [-> | (s & I & [-> | ->])]; trivial; [| lia | |].
  - intros s I. apply edge_is_clear_is_right; [exact (region_edges_are_directions r not_points s I) | now apply clear_].
  - pose proof (middles s I) as at_most. apply Z.leb_le in at_most. lia.
  - pose proof (middles s I) as at_most. apply Z.leb_le in at_most. lia.
Qed.

(* Theorem. For regions that pass the check and every x, the naive collision test of P and -Q + x returns true if and only
   if their interiors have a point in common. *)
Theorem collide_decides_for_checked_regions (p q : region) (x : vector) :
  covers_nothing_twice p = true -> covers_nothing_twice q = true ->
  (collide p (placed x q) = true <-> interiors_meet x p q).
Proof.
  intros p_check q_check. apply covers_nothing_twice_is_right in p_check, q_check.
  destruct p_check as [p_region p_simple], q_check as [q_region q_simple].
  now apply collide_decides_whether_interiors_meet.
Qed.

Example small_regions_cover_nothing_twice :
  covers_nothing_twice [square] = true /\ covers_nothing_twice [letter_l] = true /\
  covers_nothing_twice square_with_hole = true /\ covers_nothing_twice square_with_touching_hole = true /\
  covers_nothing_twice [square; map (fun v => Vector (3 * vx v - 2) (3 * vy v - 2)) square] = false.
Proof. repeat split; vm_compute; reflexivity. Qed.
