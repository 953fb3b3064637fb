(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Lemma 3.1.2 as printed: the boundary of the sum of two polygons is a union of orientable loops. A loop is a closed
   sequence of segments that have no inner points in common, here the edges of a list of vertices. It is orientable
   (Definition 3.1.1) if each segment ends where the next one starts, and only there; and the directions are those of
   the convolution: each edge of a loop is part of a segment of the reduced convolution with its direction, and there is
   no segment of the convolution along it with another direction. It is proved in loops_of_the_boundary.v. *)
From Coq Require Import QArith Lqa Lia List.
From Oplus Require Import convolution convolution_winding theorem_4_2_1 theorem_2_2_10 simple_chain
  simple_chains_turn_once reduced_convolution meeting_of_segments regions valid_regions_are_accepted
  loops_of_the_boundary.
Import ListNotations.

Open Scope Q_scope.

(* Definition 3.1.1. *)
Definition orientable_loop (loop : list vector) : Prop :=
  let n := length loop in
  (0 < n)%nat /\
  (forall i j x, (i < n)%nat -> (j < n)%nat -> i <> j ->
     ~ (strictly_inside x (edge_at loop i) /\ strictly_inside x (edge_at loop j))) /\
  (forall i j, (i < n)%nat -> (j < n)%nat ->
     (equal_vectors (target (edge_at loop i)) (source (edge_at loop j)) <-> j = next i n)).

(* It has the direction of the convolution's segments along it, of which there are some. *)
Definition is_directed_as_the_convolution (p q : region) (e : segment) : Prop :=
  (exists s, In s (reduced_convolution p q) /\ (forall x, lies_on x e -> lies_on x s) /\
     same_direction (along e) (along s)) /\
  (forall s x, In s (convolution_segments p q) -> strictly_inside x e -> lies_on x s ->
     same_direction (along e) (along s)).

Lemma simple_chains_are_orientable_loops (chain : list vector) : simple chain -> orientable_loop chain.
Proof.
  intros (three & long & common). set (n := length chain) in *.
  assert (long_edge : forall i, (i < n)%nat -> nonzero (along (edge_at chain i))).
  { intros i I. apply long, in_map, nth_In. now rewrite edges_are_as_many. }
  assert (vertex_is : forall i, (i < n)%nat -> source (edge_at chain i) = vertex chain i /\
    target (edge_at chain i) = vertex chain (next i n)).
  { intros i I. rewrite edge_at_is by exact I. now split. }
  split; [lia |]. split.
  - intros i j x I J differ [in_i in_j].
    destruct (common i j x I J differ (strictly_inside_lies_on _ _ in_i) (strictly_inside_lies_on _ _ in_j))
      as [[_ at_j] | [_ at_i]].
    + apply (proj1 (ends_are_not_inside _ x (long_edge j J) in_j)). now rewrite (proj1 (vertex_is j J)).
    + apply (proj1 (ends_are_not_inside _ x (long_edge i I) in_i)). now rewrite (proj1 (vertex_is i I)).
  - intros i j I J. split.
    + intros equal. destruct (Nat.eq_dec i j) as [<- | differ].
      * exfalso. destruct equal as [X Y]. apply (long_edge i I). unfold along, minus. cbn [vx vy]. split; lra.
      * destruct (common i j (source (edge_at chain j)) I J differ) as [[is_next _] | [is_next at_i]].
        -- apply (lies_on_equal _ _ _ equal), target_lies_on.
        -- apply source_lies_on.
        -- exact is_next.
        -- exfalso. destruct equal as [X Y], at_i as [X' Y']. apply (long_edge i I).
           rewrite <- (proj1 (vertex_is i I)) in X', Y'. unfold along, minus. cbn [vx vy]. split; lra.
    + intros ->. rewrite (proj2 (vertex_is i I)), (proj1 (vertex_is _ J)). reflexivity.
Qed.

(* Theorem, Lemma 3.1.2. *)
Theorem lemma_3_1_2_as_printed (p q : region) :
  valid_region p -> valid_region q ->
  exists loops : list (list vector),
    (forall x, on_boundary_of_sum x p q <-> exists e, In e (region_edges loops) /\ lies_on x e) /\
    (forall loop, In loop loops -> orientable_loop loop) /\
    (forall e, In e (region_edges loops) -> is_directed_as_the_convolution p q e).
Proof.
  intros p_region q_region. exists (boundary_loops p q). split; [| split].
  - now apply boundary_is_on_the_loops.
  - intros loop L. apply simple_chains_are_orientable_loops.
    exact (proj1 (proj2 (boundary_loops_do_not_cross p q p_region q_region)) loop L).
  - intros e E. split; [now apply reduced_segment_along_the_loops |]. intros s x S inside_ on.
    exact (proj2 (segments_along_the_loops p q p_region q_region e s x E S inside_ on)).
Qed.
