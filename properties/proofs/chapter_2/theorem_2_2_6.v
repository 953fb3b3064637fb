(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Theorem 2.2.6: the boundary of the Minkowski sum is part of the vertex-edge sum (Definition 2.2.1). The convolution
   is part of the vertex-edge sum, so this follows from Theorem 2.2.10 (theorem_2_2_10.v). *)
From Coq Require Import ZArith Lia Bool List.
From Oplus Require Import numbers regions_and_sums tracing theorem_2_2_10.
Import ListNotations.

Open Scope Q_scope.

(* x is the sum of a vertex of P and a point of an edge of Q, or of a vertex of Q and a point of an edge of P. *)
Definition on_vertex_edge_sum (x : vector) (p q : region) : Prop :=
  (exists v f, is_vertex v p /\ In f (region_edges q) /\ lies_on (minus x v) f) \/
  (exists v e, is_vertex v q /\ In e (region_edges p) /\ lies_on (minus x v) e).

Lemma vertex_by_index (chain : list vector) (r : region) i :
  In chain r -> (i < length chain)%nat -> is_vertex (nth i chain nowhere) r.
Proof.
  intros I below. exists (edge_at chain i). split; [now apply edge_at_in_region |].
  rewrite edge_at_is by exact below. split; reflexivity.
Qed.

Lemma edge_in_region (chain : list vector) (r : region) i :
  In chain r -> (i < length chain)%nat ->
  In (Segment (nth i chain nowhere) (nth (next i (length chain)) chain nowhere)) (region_edges r).
Proof.
  intros I below. rewrite <- edge_at_is by exact below. now apply edge_at_in_region.
Qed.

(* A segment of the convolution is an edge moved by a vertex. *)
Lemma convolution_segment_is (p q : region) (s : segment) : In s (convolution_segments p q) ->
  exists a b i j, In a p /\ In b q /\ (i < length a)%nat /\ (j < length b)%nat /\
    (s = Segment (plus (nth i a nowhere) (nth j b nowhere))
           (plus (nth (next i (length a)) a nowhere) (nth j b nowhere)) \/
     s = Segment (plus (nth i a nowhere) (nth j b nowhere))
           (plus (nth i a nowhere) (nth (next j (length b)) b nowhere))).
Proof.
  intros I. apply in_map_iff in I. destruct I as ([chains named] & <- & I).
  apply in_flat_map in I. destruct I as ([a b] & J & I). apply in_prod_iff in J. destruct J as [in_p in_q].
  apply in_map_iff in I. destruct I as (named' & equal & I). injection equal as <- <-. cbn [fst snd] in *.
  apply (in_those (length a) (length b) (in_convolution a b)) in I. destruct I as [[i_below j_below] _].
  destruct named' as [along_ [i j]]. exists a, b, i, j. repeat split; trivial. destruct along_; [now left | now right].
Qed.

(* Lemma. The convolution is part of the vertex-edge sum. *)
Lemma convolution_is_part_of_the_vertex_edge_sum (p q : region) (x : vector) (s : segment) :
  In s (convolution_segments p q) -> lies_on x s -> on_vertex_edge_sum x p q.
Proof.
  intros I on.
  destruct (convolution_segment_is p q s I) as (a & b & i & j & in_p & in_q & i_below & j_below & [-> | ->]);
    destruct on as (k & range & X & Y); unfold plus in X, Y; cbn [source target vx vy] in X, Y.
  - right. exists (nth j b nowhere), (Segment (nth i a nowhere) (nth (next i (length a)) a nowhere)).
    split; [now apply vertex_by_index |]. split; [now apply edge_in_region |].
    exists k. unfold minus. cbn [source target vx vy]. split; [exact range |]. rewrite X, Y. split; ring.
  - left. exists (nth i a nowhere), (Segment (nth j b nowhere) (nth (next j (length b)) b nowhere)).
    split; [now apply vertex_by_index |]. split; [now apply edge_in_region |].
    exists k. unfold minus. cbn [source target vx vy]. split; [exact range |]. rewrite X, Y. split; ring.
Qed.

(* Theorem 2.2.6. The boundary of the sum is part of the vertex-edge sum. *)
Theorem boundary_is_part_of_the_vertex_edge_sum (p q : region) (x : vector) :
  valid_region p -> valid_region q -> on_boundary_of_sum x p q -> on_vertex_edge_sum x p q.
Proof.
  intros p_region q_region boundary.
  destruct (boundary_is_part_of_the_convolution p q x p_region q_region boundary) as (s & I & on).
  exact (convolution_is_part_of_the_vertex_edge_sum p q x s I on).
Qed.
