(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Regions that pass a check by comparisons (validity.v), and of whose edges none has inside to its right: for two of
   them nothing is left open, and the collision test (collision_test.v) and the winding number of the convolution
   (interiors_at_touching_points.v) are two ways to decide whether the interiors of P and -Q + x meet. *)
From Coq Require Import QArith Lqa ZArith Lia Bool List.
From Oplus Require Import direction sweep winding_number shifted_ray in_out_degree convolution_winding regions
  winding_number_of_the_sum interiors_meet left_of_an_edge theorem_4_2_1 boundary_points interiors_at_touching_points right_of_an_edge validity
  common_interior collision_test placed small_intersection.
Import ListNotations.

Definition right_is_outside (r : region) : bool :=
  forallb (fun s => (winding_number_shifted (right_of_middle s) (region_edges r) <=? 0)%Z) (region_edges r).

Definition is_checked (r : region) : bool := is_valid r && right_is_outside r.

Lemma checked_once (r : region) : is_checked r = true -> at_most_once r.
Proof.
  unfold is_checked, right_is_outside. rewrite andb_true_iff, forallb_forall. intros [valid outside] x free.
  pose proof (is_valid_is_right r valid) as (not_points & _ & meet).
  assert (clear_ : forall s, In s (region_edges r) -> clear_edge r s).
  { unfold is_valid in valid. rewrite !andb_true_iff, !forallb_forall in valid. destruct valid as ((_ & clear_) & _).
    intros s I. apply edge_is_clear_is_right; [now apply (region_edges_are_directions r) | now apply clear_]. }
  destruct (winding_number_by_middles r x not_points meet clear_ free) as [zero_ | (s & I & value)]; [lia |].
  specialize (outside s I). apply Z.leb_le in outside. lia.
Qed.

(* Theorem. For all regions that pass the check, and every x, the collision test decides whether the interiors of P and
   -Q + x have a point in common. Off the convolution the winding number says the same, if chains do not touch. *)
Theorem verdicts_on_checked_regions (p q : region) (x : vector) :
  is_checked p = true -> is_checked q = true ->
  (collide p (placed x q) = true <-> interiors_meet x p q) /\
  (does_not_touch p = true -> does_not_touch q = true -> off x (convolution_segments p q) ->
   collide p (placed x q) = (0 <? winding_number x (convolution_segments p q))%Z).
Proof.
  intros p_check q_check. pose proof (checked_once p p_check) as p_once. pose proof (checked_once q q_check) as q_once.
  apply andb_true_iff in p_check. destruct p_check as [p_check _]. apply is_valid_is_right in p_check.
  apply andb_true_iff in q_check. destruct q_check as [q_check _]. apply is_valid_is_right in q_check. split.
  - now apply collide_decides_whether_interiors_meet.
  - intros p_apart q_apart free. apply does_not_touch_is_right in p_apart, q_apart.
    now apply collision_and_winding_number_agree.
Qed.

(* There are such regions. *)
Example small_regions_are_checked :
  is_checked letter_u = true /\ is_checked bar = true /\ is_checked square_with_touching_hole = true.
Proof. repeat split; vm_compute; reflexivity. Qed.

(* A square moved onto itself, along two of its edges, beside itself, and to a corner of itself. *)
Definition square_from (x y : Q) : region :=
  [[Vector x y; Vector (x + 2) y; Vector (x + 2) (y + 2); Vector x (y + 2)]].

Example small_verdicts :
  collide (square_from 0 0) (square_from 0 0) = true /\ collide (square_from 0 0) (square_from 1 0) = true /\
  collide (square_from 0 0) (square_from 2 1) = false /\ collide (square_from 0 0) (square_from 2 2) = false.
Proof. repeat split; vm_compute; reflexivity. Qed.
