(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The reduced convolution (thesis, Definition 2.3.1): the segments of the convolution whose vertex is not reflex. And
   which points the segments of either cover, in which direction. *)
From Coq Require Import Lia Bool List Arith.
From Oplus Require Import numbers convolution tracing convolution_winding regions simple_chain definition_2_2_8.
Import ListNotations.

Open Scope Q_scope.

(* The corner at the vertex of which a segment of the convolution is the sum with an edge. *)
Definition vertex_corner (s : (list vector * list vector) * named_segment) : corner :=
  match fst (snd s) with
  | OfP => corner_of_chain (snd (fst s)) (snd (snd (snd s)))
  | OfQ => corner_of_chain (fst (fst s)) (fst (snd (snd s)))
  end.

Definition reduced_convolution (p q : region) : list segment :=
  map (fun s => Segment (starts_at s) (ends_at s))
    (filter (fun s => negb (is_reflex (vertex_corner s))) (segments_of_regions p q)).

Lemma reduced_is_part_of_the_convolution (p q : region) (s : segment) :
  In s (reduced_convolution p q) -> In s (convolution_segments p q).
Proof.
  intros I. apply in_map_iff in I. destruct I as (named & <- & I). apply filter_In in I.
  apply in_map_iff. exists named. tauto.
Qed.

Definition on_reduced_convolution (x : vector) (p q : region) : Prop :=
  exists s, In s (reduced_convolution p q) /\ lies_on x s.

Definition convex (c : corner) : Prop := 0 < cross (incoming c) (outgoing c).

Lemma same_direction_reflexive (u : vector) : same_direction u u.
Proof. exists 1. split; [lra |]. split; ring. Qed.

Lemma same_direction_symmetric (u v : vector) : same_direction u v -> same_direction v u.
Proof.
  intros (a & some & X & Y). exists (/ a). split; [now apply Qinv_lt_0_compat |].
  rewrite X, Y. split; field; lra.
Qed.

Lemma same_direction_transitive (u v w : vector) : same_direction u v -> same_direction v w -> same_direction u w.
Proof.
  intros (a & some & X & Y) (b & some_b & X' & Y'). exists (a * b). split; [now apply Qmult_lt_0_compat |].
  rewrite X, Y, X', Y'. split; ring.
Qed.

Lemma covered_in_the_same_direction (segments : list segment) (x d d' : vector) : same_direction d d' ->
  (exists s, In s segments /\ lies_on x s /\ same_direction (along s) d) ->
  exists s, In s segments /\ lies_on x s /\ same_direction (along s) d'.
Proof.
  intros same_ (s & I & on & direction_). exists s. split; [exact I |]. split; [exact on |].
  exact (same_direction_transitive _ _ _ direction_ same_).
Qed.

Section Covering.
  Variables p q : region.
  Variable x : vector.

  (* A segment of the convolution, of direction d, covers x; one of the reduced convolution does. *)
  Definition covered_along (d : vector) : Prop :=
    exists s, In s (convolution_segments p q) /\ lies_on x s /\ same_direction (along s) d.
  Definition reduced_along (d : vector) : Prop :=
    exists s, In s (reduced_convolution p q) /\ lies_on x s /\ same_direction (along s) d.

  Lemma reduced_along_is_covered (d : vector) : reduced_along d -> covered_along d.
  Proof. intros (s & I & covers). exists s. split; [now apply reduced_is_part_of_the_convolution | exact covers]. Qed.

  Variables a b : list vector.
  Hypothesis in_p : In a p.
  Hypothesis in_q : In b q.

  (* By index: edge i of P and vertex j of Q, or vertex i of P and edge j of Q. *)
  Lemma covered_by_index (label : summand) i j t : (i < length a)%nat -> (j < length b)%nat -> 0 <= t <= 1 ->
    is_convolution_segment a b label i j = true ->
    equal_vectors x (match label with OfP => plus (point_along a i t) (vertex b j)
                                    | OfQ => plus (vertex a i) (point_along b j t) end) ->
    let d := match label with OfP => edge_of_chain a i | OfQ => edge_of_chain b j end in
    covered_along d /\ (convex (vertex_corner ((a, b), (label, (i, j)))) -> reduced_along d).
  Proof.
    intros I J range belongs x_is d. set (s := ((a, b), (label, (i, j)))).
    assert (on : lies_on x (Segment (starts_at s) (ends_at s))).
    { apply lies_on_a_segment_of; trivial. now exists t. }
    assert (same_ : same_direction (along (Segment (starts_at s) (ends_at s))) d).
    { exists 1. split; [lra |]. unfold d, s, starts_at, ends_at, point_of, state_before, state_after, step, along.
      destruct label; cbn [fst snd source target]; rewrite edge_of_chain_is by assumption;
        unfold plus, minus; cbn [vx vy]; split; ring. }
    assert (named : In s (segments_of_regions p q)).
    { apply in_flat_map. exists (a, b). split; [now apply in_prod |]. apply in_map.
      apply (in_those (length a) (length b) (in_convolution a b)). now split. }
    split; [| intros is_convex]; exists (Segment (starts_at s) (ends_at s)); (split; [| now split]).
    - now apply (in_map (fun s => Segment (starts_at s) (ends_at s))).
    - apply (in_map (fun s => Segment (starts_at s) (ends_at s))), filter_In. split; [exact named |].
      unfold is_reflex, convex in *. destruct (negative_spec (cross (incoming (vertex_corner s))
        (outgoing (vertex_corner s)))) as [reflex |]; [exfalso; lra | reflexivity].
  Qed.
End Covering.
