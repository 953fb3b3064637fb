(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Observation 5.2.1: a ray to the right from an edge of the convolution counts what is directly to the right of the
   edge. If the edge leads upwards, the ray leaves it behind; if it leads downwards, the ray crosses it first. That number
   is positive iff P and -Q, placed there, have a point in common. Shifts of the ray are in shifted_ray.v, what the
   number means in theorem_4_2_1.v. *)
From Coq Require Import ZArith Lia Bool List.
From Oplus Require Import numbers regions_and_sums.

Open Scope Q_scope.

Lemma middle_is_to_the_right (s : segment) :
  nonzero (minus (target s) (source s)) -> side (right_of_middle s) s = Lt.
Proof.
  intros some. unfold side.
  assert (on_line : orientation (source s) (target s) (at_ (right_of_middle s)) = Eq).
  { apply on_its_line. exists (1 # 2). split; [lra |]. split; unfold right_of_middle; cbn [at_ vx vy]; field. }
  rewrite on_line. set (d := minus (target s) (source s)) in *.
  assert (along_the_edge : (cross d (first (right_of_middle s)) ?= 0) = Eq).
  { apply (proj1 (Qeq_alt _ _)). unfold right_of_middle; cbn [first]. fold d.
    destruct (negative (vy d)); unfold cross; cbn [vx vy]; ring. }
  rewrite along_the_edge. apply (proj1 (Qlt_alt _ _)). unfold right_of_middle, cross; cbn [second]. fold d. cbn [vx vy].
  destruct (Qeq_dec (vx d) 0) as [x_zero | x_some]; [| nra].
  destruct (Qeq_dec (vy d) 0) as [y_zero | y_some]; [exfalso; now apply some | nra].
Qed.

(* Theorem, Observation 5.2.1, first part. The ray from an edge that leads upwards leaves that edge behind; from an edge
   that leads downwards, the edge itself counts -1. *)
Theorem what_an_edge_adds_to_its_ray (s : segment) :
  (vy (source s) < vy (target s) -> signed_crossing_of_shifted (right_of_middle s) s = 0%Z) /\
  (vy (target s) < vy (source s) -> signed_crossing_of_shifted (right_of_middle s) s = (-1)%Z).
Proof.
  assert (some : ~ vy (source s) == vy (target s) -> nonzero (minus (target s) (source s))).
  { intros slanted [_ flat]. apply slanted. unfold minus in flat; cbn [vy] in flat. lra. }
  assert (middle : vy (at_ (right_of_middle s)) == (1 # 2) * (vy (source s) + vy (target s)))
    by (unfold right_of_middle; cbn [at_ vy]; field).
  split; intros way; unfold signed_crossing_of_shifted; rewrite (middle_is_to_the_right s) by (apply some; lra);
    set (m := at_ (right_of_middle s)) in *;
    destruct (at_most_spec (vy (source s)) (vy m)), (at_most_spec (vy (target s)) (vy m)),
      (at_most_spec (vy m) (vy (source s))), (at_most_spec (vy m) (vy (target s))); try (exfalso; lra);
    now destruct (is_above _).
Qed.

(* Theorem, Observation 5.2.1, second part. The points directly to the right of an edge, close enough, are off the
   convolution, and in the sum if and only if the ray's number is positive. *)
Theorem rays_from_edges_decide (p q : region) (s : segment) :
  valid_region p -> valid_region q -> nonzero (minus (target s) (source s)) ->
  eventually (fun e =>
    off (moved (right_of_middle s) e) (convolution_segments p q) /\
    ((0 < winding_number_shifted (right_of_middle s) (convolution_segments p q))%Z <->
     in_sum (moved (right_of_middle s) e) p q)).
Proof.
  intros p_region q_region some.
  destruct (shifts_are_small_moves s (convolution_segments p q) some) as (limit & L & near).
  exists limit. split; [exact L |]. intros e some_shift small_shift.
  destruct (near e some_shift small_shift) as [free <-]. split; [exact free |].
  now apply positive_winding_number_iff_common_point.
Qed.
