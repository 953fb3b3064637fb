(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Lemma 2.2.2 as printed, for any two sets of points A and B, closed or not: if a boundary point x of their sum is a
   + b, then a is on the boundary of A and b on that of B. Were a whole square around a in A, this square moved by b
   would be in the sum, around x. For regions, whose boundary is their chains, it is summands_of_boundary_points
   (lemma_2_2_2.v). *)
From Coq Require Import List.
From Oplus Require Import numbers convolution regions neighbourhoods theorem_2_2_10.
Import ListNotations.

Open Scope Q_scope.

(* Points of A and points that are not in A are in every neighbourhood of x. *)
Definition on_boundary_of_set (A : vector -> Prop) (x : vector) : Prop :=
  forall radius, 0 < radius -> (exists y, within radius x y /\ A y) /\ (exists y, within radius x y /\ ~ A y).

(* The Minkowski sum of two sets (Definition 2.0.1). *)
Definition sum_of_sets (A B : vector -> Prop) (x : vector) : Prop :=
  exists a b, A a /\ B b /\ equal_vectors x (plus a b).

Lemma first_summand_is_on_the_boundary (A B : vector -> Prop) (x a b : vector) :
  on_boundary_of_set (sum_of_sets A B) x -> A a -> B b -> equal_vectors x (plus a b) -> on_boundary_of_set A a.
Proof.
  intros boundary in_a in_b [X Y] radius R. split.
  - exists a. split; [unfold within; lra | exact in_a].
  - destruct (boundary radius R) as [_ (y & near & outside)]. exists (minus y b). split.
    + unfold within, minus, plus in *; cbn [vx vy] in *; lra.
    + intros in_y. apply outside. exists (minus y b), b. split; [exact in_y |]. split; [exact in_b |].
      unfold plus, minus; split; cbn [vx vy]; ring.
Qed.

(* Theorem, Lemma 2.2.2. *)
Theorem lemma_2_2_2_as_printed (A B : vector -> Prop) (x : vector) :
  on_boundary_of_set (sum_of_sets A B) x ->
  forall a b, A a -> B b -> equal_vectors x (plus a b) -> on_boundary_of_set A a /\ on_boundary_of_set B b.
Proof.
  intros boundary a b in_a in_b [X Y]. split.
  - now apply (first_summand_is_on_the_boundary A B x a b).
  - apply (first_summand_is_on_the_boundary B A x b a); trivial.
    + intros radius R. destruct (boundary radius R) as [(y & near & c & d & C & D & Z) (z & near_z & outside)].
      split; [exists y | exists z]; (split; [assumption |]).
      * exists d, c. split; [exact D |]. split; [exact C |]. destruct Z. unfold plus in *. split; cbn [vx vy] in *; lra.
      * intros (e & f & E_ & F_ & W). apply outside. exists f, e. split; [exact F_ |]. split; [exact E_ |].
        destruct W. unfold plus in *. split; cbn [vx vy] in *; lra.
    + unfold plus in *. split; cbn [vx vy] in *; lra.
Qed.

(* The sum of two regions is that of the sets of their points, so this is about its boundary, too. *)
Lemma sums_of_regions_are_sums_of_sets (p q : region) (x : vector) :
  on_boundary_of_sum x p q <-> on_boundary_of_set (sum_of_sets (fun a => in_region a p) (fun b => in_region b q)) x.
Proof. split; trivial. Qed.
