(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The reduced convolution (thesis, Definition 2.3.1): the segments of the convolution whose vertex is not reflex. *)
From Coq Require Import Lia Bool List Arith.
From Oplus Require Import numbers convolution convolution_winding regions boundary_points.
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

Section TwoChains.
  Variables p q : region.
  Variables a b : list vector.
  Hypothesis in_p : In a p.
  Hypothesis in_q : In b q.
  Variable x : vector.

  Lemma reduced_member (along_ : summand) i j :
    (i < length a)%nat -> (j < length b)%nat -> is_convolution_segment a b along_ i j = true ->
    convex (vertex_corner ((a, b), (along_, (i, j)))) ->
    In (Segment (starts_at ((a, b), (along_, (i, j)))) (ends_at ((a, b), (along_, (i, j)))))
      (reduced_convolution p q).
  Proof.
    intros I J belongs is_convex. apply in_map_iff. exists ((a, b), (along_, (i, j))). split; [reflexivity |].
    apply filter_In. split.
    - apply in_flat_map. exists (a, b). split; [now apply in_prod |]. apply in_map. unfold convolution.
      apply filter_In. split; [| exact belongs]. apply in_prod; [destruct along_; cbn; tauto |].
      apply in_prod; apply in_seq; cbn [fst snd]; lia.
    - unfold is_reflex, convex in *. destruct (negative_spec (cross (incoming (vertex_corner (a, b, (along_, (i, j)))))
        (outgoing (vertex_corner (a, b, (along_, (i, j))))))) as [reflex |]; [exfalso; lra | reflexivity].
  Qed.

End TwoChains.
