(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Section 4.2.3: the convolution with the segments of some vertices replaced by their flip sets, as in
   reference/definitions/original_convolution.cpp. Whatever changes its sign with the direction of a segment, summed
   over all of them: the replacement subtracts, for each of these vertices, the whole other summand, moved there.
   Sums are from finite_sums.v. *)
From Coq Require Import ZArith Lia Bool List.
From Oplus Require Import numbers convolution convolution_winding finite_sums regions tangent_count.
Import ListNotations.

Open Scope Z_scope.

(* A vertex of P or of Q, with its edges. *)
Definition vertex_of_summand : Type := summand * (vector * corner).

(* A sum of an edge of one chain and a vertex of another (Definition 2.2.1), and that vertex. *)
Definition edge_and_vertex : Type := (list vector * list vector) * named_segment.

Definition vertex_edge_sum (p q : region) : list edge_and_vertex :=
  flat_map (fun chains => map (pair chains) (all_segments (length (fst chains)) (length (snd chains))))
    (list_prod p q).

Definition vertex_of (s : edge_and_vertex) : vertex_of_summand :=
  let '((a, b), (along_, (i, j))) := s in
  match along_ with
  | OfP => (OfQ, (nth j b nowhere, corner_of_chain b j))
  | OfQ => (OfP, (nth i a nowhere, corner_of_chain a i))
  end.

Definition belongs_to_convolution (s : edge_and_vertex) : bool :=
  in_convolution (fst (fst s)) (snd (fst s)) (snd s).

Definition segment_of (s : edge_and_vertex) : segment := Segment (starts_at s) (ends_at s).

(* At the chosen vertices, the segments of the convolution are taken away, and all other sums with edges are
   added, reversed: the flip sets (Definitions 4.2.11 and 4.2.12). *)
Definition replaced (chosen : vertex_of_summand -> bool) (p q : region) : list segment :=
  map segment_of (filter (fun s => belongs_to_convolution s && negb (chosen (vertex_of s))) (vertex_edge_sum p q)) ++
  map (fun s => reversed (segment_of s))
    (filter (fun s => negb (belongs_to_convolution s) && chosen (vertex_of s)) (vertex_edge_sum p q)).

(* The original convolution: at all reflex vertices. *)
Definition original_convolution (p q : region) : list segment := replaced (fun v => is_reflex (snd (snd v))) p q.

Definition moved_by (v : vector) (s : segment) : segment := Segment (plus v (source s)) (plus v (target s)).

(* Of the chosen vertices of one region, the sum over the edges of the other, moved there. *)
Definition sum_at_vertices (f : segment -> Z) (chosen : vector * corner -> bool) (r other_region : region) : Z :=
  sum_of (fun v => Z.b2z (chosen v) * sum_of (fun e => f (moved_by (fst v) e)) (region_edges other_region))
    (region_vertices r).

Section AnySum.
  Variable f : segment -> Z.
  Hypothesis of_reversed : forall s, f (reversed s) = - f s.
  Hypothesis of_equal_ends : forall a b a' b',
    equal_vectors a a' -> equal_vectors b b' -> f (Segment a b) = f (Segment a' b').
  Variable chosen : vertex_of_summand -> bool.

  Lemma sum_over_the_convolution p q :
    sum_of f (convolution_segments p q) =
    sum_of (fun s => Z.b2z (belongs_to_convolution s) * f (segment_of s)) (vertex_edge_sum p q).
  Proof.
    unfold convolution_segments, segments_of_regions, vertex_edge_sum.
    rewrite sum_of_images, !sum_of_flat_map. apply sum_equally. intros [a b] _.
    rewrite !sum_of_images. unfold convolution. rewrite sum_of_filter. reflexivity.
  Qed.

  Lemma sum_over_chains (a b : list vector) :
    sum_of (fun s => Z.b2z (chosen (vertex_of ((a, b), s))) * f (segment_of ((a, b), s)))
      (all_segments (length a) (length b)) =
    sum_of (fun v => Z.b2z (chosen (OfP, v)) * sum_of (fun e => f (moved_by (fst v) e)) (edges b))
      (combine a (corners a)) +
    sum_of (fun v => Z.b2z (chosen (OfQ, v)) * sum_of (fun e => f (moved_by (fst v) e)) (edges a))
      (combine b (corners b)).
  Proof.
    unfold all_segments. cbn [list_prod]. rewrite app_nil_r, sum_of_two_lists, !sum_of_images.
    unfold states, state. rewrite !sum_of_product, Z.add_comm, !vertices_by_index. f_equal.
    - apply sum_below_equally. intros i I. cbn [vertex_of fst snd].
      rewrite sum_times. f_equal.
      rewrite (sum_by_index _ _ no_segment _ (length b)) by apply edges_are_as_many.
      apply sum_below_equally. intros j J. now rewrite edge_by_index.
    - rewrite sums_exchanged. apply sum_below_equally. intros j J. cbn [vertex_of fst snd].
      rewrite sum_times. f_equal.
      rewrite (sum_by_index _ _ no_segment _ (length a)) by apply edges_are_as_many.
      apply sum_below_equally. intros i I. rewrite edge_by_index by exact I.
      apply of_equal_ends; split; apply Qplus_comm.
  Qed.

  Lemma sum_by_chains (chosen_here : vector * corner -> bool) (r other_region : region) :
    sum_at_vertices f chosen_here r other_region =
    sum_of (fun a => sum_of (fun b => sum_of (fun v =>
      Z.b2z (chosen_here v) * sum_of (fun e => f (moved_by (fst v) e)) (edges b)) (combine a (corners a)))
      other_region) r.
  Proof.
    unfold sum_at_vertices, region_vertices. rewrite sum_of_flat_map. apply sum_equally. intros a _.
    rewrite sums_exchanged. apply sum_equally. intros v _. rewrite sum_times. f_equal. apply sum_of_flat_map.
  Qed.

  (* Theorem. The replacement subtracts, for each chosen vertex, the sum over the other summand moved there. *)
  Theorem sum_over_replaced p q :
    sum_of f (replaced chosen p q) =
    sum_of f (convolution_segments p q) - sum_at_vertices f (fun v => chosen (OfP, v)) p q -
    sum_at_vertices f (fun v => chosen (OfQ, v)) q p.
  Proof.
    assert (at_chosen : sum_of (fun s => Z.b2z (chosen (vertex_of s)) * f (segment_of s)) (vertex_edge_sum p q) =
      sum_at_vertices f (fun v => chosen (OfP, v)) p q + sum_at_vertices f (fun v => chosen (OfQ, v)) q p).
    { rewrite !sum_by_chains. unfold vertex_edge_sum. rewrite sum_of_flat_map, sum_of_product.
      rewrite (sums_exchanged _ _ (fun a b => sum_of (fun v =>
        Z.b2z (chosen (OfQ, v)) * sum_of (fun e => f (moved_by (fst v) e)) (edges b)) (combine a (corners a)))).
      rewrite <- sum_plus. apply sum_equally. intros a _. rewrite <- sum_plus. apply sum_equally. intros b _.
      rewrite sum_of_images. apply sum_over_chains. }
    rewrite <- Z.sub_add_distr, <- at_chosen, sum_over_the_convolution, <- sum_minus.
    unfold replaced. rewrite sum_of_two_lists, !sum_of_images, !sum_of_filter, <- sum_plus.
    apply sum_equally. intros s _. rewrite of_reversed.
    destruct (belongs_to_convolution s), (chosen (vertex_of s)); cbn [andb negb Z.b2z]; lia.
  Qed.
End AnySum.
