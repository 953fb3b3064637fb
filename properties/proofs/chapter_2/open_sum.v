(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Theorems 2.2.6, 2.2.10 and 2.3.2 for the sum of the open regions, dangling edges and isolated vertices included:
   every point that is not in it but has points of it near is on the convolution (fans_that_touch.v). It is on the
   reduced convolution (reduced_edges_that_pass.v), if no chains of P touch, and none of Q, or if it is no sum of two
   vertices; where a touching point of P meets one of Q it need not be (docs/findings.md). *)
From Coq Require Import QArith Lqa ZArith Bool List.
From Oplus Require Import regions_and_sums theorem_2_2_10 theorem_2_2_6 lemma_2_2_2 boundary_points reduced_convolution
  fans_that_touch reduced_edges_that_pass.

Open Scope Q_scope.

(* x is a boundary point of the open sum: it is not in it, but has points of it in every neighbourhood. *)
Definition on_boundary_of_open_sum (x : vector) (p q : region) : Prop :=
  ~ interiors_meet x p q /\ forall radius, 0 < radius -> exists y, within radius x y /\ interiors_meet y p q.

Lemma open_sum_is_in_the_sum (p q : region) (x : vector) : interiors_meet x p q -> in_sum x p q.
Proof.
  intros (z & [_ in_p] & [_ in_q]). exists z, (minus x z). split; [now left |]. split; [now left |].
  split; unfold plus, minus; cbn [vx vy]; ring.
Qed.

Lemma boundary_of_open_sum_is_in_the_sum (p q : region) (x : vector) :
  valid_region p -> valid_region q -> on_boundary_of_open_sum x p q -> ~ ~ in_sum x p q.
Proof.
  intros p_region q_region [_ near] out. apply out, sum_is_closed; trivial. intros radius R. split.
  - destruct (near radius R) as (y & close & meet). exists y. split; [exact close |]. now apply open_sum_is_in_the_sum.
  - exists x. split; [| exact out]. unfold within. lra.
Qed.

Lemma boundary_of_the_open_sum_where_alone (p q : region) (x : vector) :
  valid_region p -> valid_region q -> on_boundary_of_open_sum x p q ->
  (forall w u, is_vertex w p -> is_vertex u q -> equal_vectors x (plus w u) -> alone w p /\ alone u q) ->
  on_reduced_convolution x p q.
Proof.
  intros p_region q_region boundary alone_.
  destruct (on_or_off x (reduced_convolution p q)) as [on | free]; [exact on | exfalso].
  apply (boundary_of_open_sum_is_in_the_sum p q x); trivial. intros common. destruct boundary as [outside _].
  destruct (common_point_is_on_the_reduced_convolution p q x p_region q_region outside alone_ common)
    as (s & S & on). exact (free s S on).
Qed.

(* Theorem 2.3.2 for open sums: their boundary is part of the reduced convolution. *)
Theorem boundary_of_the_open_sum (p q : region) (x : vector) :
  valid_region p -> valid_region q -> chains_do_not_touch p -> chains_do_not_touch q ->
  on_boundary_of_open_sum x p q -> on_reduced_convolution x p q.
Proof. intros. apply boundary_of_the_open_sum_where_alone; auto using alone_if_chains_do_not_touch. Qed.

(* Where chains touch, the same but for sums of two vertices. *)
Theorem boundary_of_the_open_sum_off_sums_of_vertices (p q : region) (x : vector) :
  valid_region p -> valid_region q -> on_boundary_of_open_sum x p q ->
  (forall w u, is_vertex w p -> is_vertex u q -> ~ equal_vectors x (plus w u)) -> on_reduced_convolution x p q.
Proof.
  intros p_region q_region boundary no_vertices. apply boundary_of_the_open_sum_where_alone; trivial.
  intros w u of_p of_q sum_. now destruct (no_vertices w u of_p of_q).
Qed.

(* Theorem 2.2.10 for open sums: their boundary is part of the convolution, where chains touch, too. *)
Theorem boundary_of_the_open_sum_is_on_the_convolution (p q : region) (x : vector) :
  valid_region p -> valid_region q -> on_boundary_of_open_sum x p q ->
  exists s, In s (convolution_segments p q) /\ lies_on x s.
Proof.
  intros p_region q_region boundary.
  destruct (on_or_off x (convolution_segments p q)) as [on | free]; [exact on | exfalso].
  apply (boundary_of_open_sum_is_in_the_sum p q x); trivial. intros common.
  destruct boundary as [out _]. apply out. now apply common_point_off_the_convolution.
Qed.

(* Theorem 2.2.6 for open sums: their boundary is part of the vertex-edge sum. *)
Corollary boundary_of_the_open_sum_is_on_the_vertex_edge_sum (p q : region) (x : vector) :
  valid_region p -> valid_region q -> on_boundary_of_open_sum x p q -> on_vertex_edge_sum x p q.
Proof.
  intros p_region q_region boundary.
  destruct (boundary_of_the_open_sum_is_on_the_convolution p q x p_region q_region boundary) as (s & I & on).
  now apply (convolution_is_part_of_the_vertex_edge_sum p q x s).
Qed.
