(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Theorems 2.2.6, 2.2.10 and 2.3.2 for the sum of the open regions, dangling edges and isolated vertices included:
   every point that is not in it but has points of it near is on the convolution (fans_that_touch.v). It is on the
   reduced convolution, if no chains of P touch, and none of Q (interiors_at_touching_points.v), or if it is no sum of
   two vertices (reduced_edges_that_pass.v); where a touching point of P meets one of Q it need not be
   (docs/findings.md). *)
From Coq Require Import QArith Lqa ZArith Bool List.
From Oplus Require Import convolution convolution_winding regions interiors_meet neighbourhoods left_of_an_edge
  theorem_4_2_1 theorem_2_2_10 theorem_2_2_6 lemma_2_2_2 boundary_points reduced_convolution parallel_edges
  interiors_at_touching_points fans_that_touch reduced_edges_that_pass.

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

(* Theorem 2.3.2 for open sums: their boundary is part of the reduced convolution. *)
Theorem boundary_of_the_open_sum (p q : region) (x : vector) :
  valid_region p -> valid_region q -> chains_do_not_touch p -> chains_do_not_touch q ->
  on_boundary_of_open_sum x p q -> on_reduced_convolution x p q.
Proof.
  intros p_region q_region p_apart q_apart boundary.
  destruct (on_or_off x (reduced_convolution p q)) as [on | free]; [exact on | exfalso].
  apply (boundary_of_open_sum_is_in_the_sum p q x); trivial. intros common.
  destruct boundary as [out _]. apply out. now apply common_point_means_common_inner_point.
Qed.

(* Where chains touch, the same but for sums of two vertices. *)
Theorem boundary_of_the_open_sum_off_sums_of_vertices (p q : region) (x : vector) :
  valid_region p -> valid_region q -> on_boundary_of_open_sum x p q ->
  (forall w u, is_vertex w p -> is_vertex u q -> ~ equal_vectors x (plus w u)) -> on_reduced_convolution x p q.
Proof.
  intros p_region q_region boundary no_vertices.
  destruct (on_or_off x (reduced_convolution p q)) as [on | free]; [exact on | exfalso].
  apply (boundary_of_open_sum_is_in_the_sum p q x); trivial. intros (w & u & in_p & in_q & sum_).
  pose proof boundary as [outside _].
  assert (swapped : equal_vectors x (plus u w))
    by (destruct sum_ as [X Y]; unfold plus in *; cbn [vx vy] in *; split; cbn [vx vy]; lra).
  assert (found : forall d, ~ reduced_along p q x d) by (intros d (s & S & on & _); exact (free s S on)).
  pose proof p_region as (p_edges & p_valid & p_meet). pose proof q_region as (q_edges & q_valid & q_meet).
  destruct (inside_or_on_boundary w p in_p) as [inside_p | (e & E & on_e)].
  { apply outside, (inner_point_and_point p q x w u); trivial. now apply regions_are_regular. }
  destruct (inside_or_on_boundary u q in_q) as [inside_q | (f & F & on_f)].
  { apply outside, interiors_meet_other_way, (inner_point_and_point q p x u w); trivial.
    now apply regions_are_regular. }
  destruct (vertex_or_not w p) as [w_vertex | no_vertex].
  - destruct (vertex_or_not u q) as [u_vertex | no_vertex]; [exact (no_vertices w u w_vertex u_vertex sum_) |].
    apply (found (along f)).
    now apply (passing_edges_of_q_are_covered p q x p_region q_region outside no_vertices u w f).
  - apply (found (along e)).
    now apply (passing_edges_of_p_are_covered p q x p_region q_region outside no_vertices w u e).
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
