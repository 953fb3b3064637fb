(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* A region reflected in a point and moved, -Q + x (docs/notation.md): its points, and its winding numbers,
   which are those of Q. Winding numbers are those of winding_number.v. *)
From Coq Require Import ZArith Lia Bool List SetoidList SetoidPermutation.
From Oplus Require Import numbers winding signed_crossings.
Import ListNotations.

Open Scope Q_scope.

Definition reflected (x : vector) (s : segment) : segment :=
  Segment (minus x (source s)) (minus x (target s)).

Lemma on_reflected (x w : vector) (s : segment) : lies_on w (reflected x s) <-> lies_on (minus x w) s.
Proof. unfold lies_on, reflected, minus; cbn. split; intros (t & range & X & Y); exists t; split; trivial; lra. Qed.

Lemma reflected_cycles (x : vector) (segments : list segment) :
  cycles segments -> cycles (map (reflected x) segments).
Proof.
  unfold cycles. intros closed. rewrite !map_map. cbn.
  apply (permuted_images (fun a => minus x a)) in closed;
    [now rewrite !map_map in closed | unfold equal_vectors, minus; cbn; intros ? ? [? ?]; split; lra].
Qed.

Definition left : vector := Vector (-1) 0.

Lemma same_negative (u v : Q) : u == v -> negative u = negative v.
Proof. intros equal. destruct (negative_spec u), (negative_spec v); trivial; exfalso; lra. Qed.

(* A ray to the right, reflected, is a ray to the left. *)
Lemma crossing_of_reflected (x z : vector) (s : segment) :
  signed_crossing z (reflected x s) = signed_crossing_of_ray OfQ left (minus x z) s.
Proof.
  rewrite the_codes_ray. unfold signed_crossing_of_ray, left_of_ray, reflected. cbn [source target].
  rewrite (same_negative (cross (minus (minus x (source s)) z) right)
             (cross (minus (source s) (minus x z)) left)) by (unfold cross, minus, right, left; cbn; ring).
  rewrite (same_negative (cross (minus (minus x (target s)) z) right)
             (cross (minus (target s) (minus x z)) left)) by (unfold cross, minus, right, left; cbn; ring).
  f_equal. unfold orientation. apply compare_as_difference. unfold minus; cbn. ring.
Qed.

(* Theorem. Off Q's chains, the winding number of x - z with respect to Q is that of z with respect to -Q + x. *)
Theorem winding_number_of_reflected (x z : vector) (segments : list segment) :
  cycles segments -> off (minus x z) segments ->
  winding_number z (map (reflected x) segments) = winding_number (minus x z) segments.
Proof.
  intros closed free.
  rewrite <- (winding_number_by_any_ray (minus x z) segments OfQ left closed free)
    by (unfold nonzero, left; cbn; lra).
  unfold winding_number, winding_number_by_ray. rewrite map_map. f_equal.
  apply map_ext. intros s. apply crossing_of_reflected.
Qed.
