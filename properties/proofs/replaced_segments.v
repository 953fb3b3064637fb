(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Section 4.2.3: the convolution with the segments of some vertices replaced by their flip sets, as in
   reference/definitions/original_convolution.cpp. It still consists of closed chains (Lemma 4.2.13), and its winding
   numbers are lower by those of the other summand, moved by each of these vertices (Lemma 4.2.15). Sums are from
   sums.v, closed chains as in winding_number.v. *)
From Coq Require Import QArith ZArith Lia Bool List SetoidList SetoidPermutation.
From Oplus Require Import direction tangent_set sweep winding_number turning_number convolution_size fiber_grid
  states in_out_degree convolution_winding sums weight regions parallelogram tangent_count tangent_features.
Import ListNotations.

Open Scope Z_scope.

(* A vertex of P or of Q, with its edges. *)
Definition vertex : Type := summand * (vector * corner).

(* A sum of an edge of one chain and a vertex of another (Definition 2.2.1), and that vertex. *)
Definition edge_and_vertex : Type := (list vector * list vector) * named_segment.

Definition vertex_edge_sum (p q : region) : list edge_and_vertex :=
  flat_map (fun chains => map (pair chains) (all_segments (length (fst chains)) (length (snd chains))))
    (list_prod p q).

Definition vertex_of (s : edge_and_vertex) : vertex :=
  let '((a, b), (along_, (i, j))) := s in
  match along_ with
  | OfP => (OfQ, (nth j b nowhere, corner_of_chain b j))
  | OfQ => (OfP, (nth i a nowhere, corner_of_chain a i))
  end.

Definition belongs_to_convolution (s : edge_and_vertex) : bool :=
  in_convolution (fst (fst s)) (snd (fst s)) (snd s).

Definition reversed (s : segment) : segment := Segment (target s) (source s).

Definition segment_of (s : edge_and_vertex) : segment := Segment (starts_at s) (ends_at s).

(* At the chosen vertices, the segments of the convolution are taken away, and all other sums with edges are
   added, reversed: the flip sets (Definitions 4.2.11 and 4.2.12). *)
Definition replaced (chosen : vertex -> bool) (p q : region) : list segment :=
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
  Variable chosen : vertex -> bool.

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

  Lemma sum_over_replaced p q :
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

(* Lists over which all sums are equal have the same elements. *)
Lemma equal_sums_permute (us vs : list vector) :
  (forall g : vector -> Z, (forall u v, equal_vectors u v -> g u = g v) -> sum_of g us = sum_of g vs) ->
  PermutationA equal_vectors us vs.
Proof.
  revert vs. induction us as [| u us IH]; intros vs equal.
  - destruct vs as [| v vs]; [apply permA_nil |].
    specialize (equal (fun _ => 1) (fun _ _ _ => eq_refl)).
    pose proof (sum_is_not_negative _ (fun _ : vector => 1) vs (fun _ _ => Z.le_0_1)).
    rewrite sum_of_nil, sum_of_more in equal. lia.
  - set (is_u := fun v => Z.b2z (is_point u v)).
    assert (respects : forall v w, equal_vectors v w -> is_u v = is_u w).
    { intros v w [x y]. unfold is_u, is_point. now rewrite x, y. }
    assert (some : 0 < sum_of is_u vs).
    { rewrite <- (equal is_u respects), sum_of_more.
      assert (here : is_u u = 1).
      { unfold is_u, is_point. now rewrite !(proj2 (Qeq_bool_iff _ _) (Qeq_refl _)). }
      pose proof (sum_is_not_negative _ is_u us) as others. rewrite here.
      assert (0 <= sum_of is_u us) by (apply others; intros v _; unfold is_u; now destruct (is_point u v)). lia. }
    apply positive_sum in some. destruct some as (v & I & same). apply in_split in I.
    destruct I as (before & after & ->).
    assert (u_v : equal_vectors u v).
    { unfold is_u, is_point in same. destruct (Qeq_bool (vx u) (vx v)) eqn:x, (Qeq_bool (vy u) (vy v)) eqn:y;
        try discriminate. split; now apply Qeq_bool_eq. }
    etransitivity; [| apply PermutationA_middle; exact equal_vectors_equivalence].
    apply permA_skip; [exact u_v |]. apply IH. intros g g_respects. specialize (equal g g_respects).
    rewrite sum_of_more, sum_of_two_lists, sum_of_more in equal. rewrite sum_of_two_lists.
    rewrite (g_respects u v u_v) in equal. lia.
Qed.

Lemma cycles_sum (g : vector -> Z) (segments : list segment) :
  (forall u v, equal_vectors u v -> g u = g v) -> cycles segments ->
  sum_of (fun s => g (source s) - g (target s)) segments = 0.
Proof.
  intros respects closed. apply (sum_of_permuted g respects) in closed. rewrite sum_minus.
  unfold sum_of. rewrite <- (map_map source g), <- (map_map target g). lia.
Qed.

(* Lemma 4.2.13, for any choice of vertices of two regions: with their segments replaced, as many segments still
   end at each point as start there. So what is proved of winding numbers of closed chains holds: each ray counts
   the same (winding_number.v), and signed crossings of each closed path add up to zero (signed_crossings.v). *)
Theorem replaced_segments_are_cycles (chosen : vertex -> bool) (p q : region) :
  no_edges_are_points p -> no_edges_are_points q -> cycles (replaced chosen p q).
Proof.
  intros p_edges q_edges. apply equal_sums_permute. intros g respects.
  set (f := fun s => g (source s) - g (target s)).
  assert (of_moved : forall r v, sum_of (fun e => f (moved_by v e)) (region_edges r) = 0).
  { intros r v. apply (cycles_sum (fun u => g (plus v u)) _); [| apply region_cycles].
    intros a b [x y]. apply respects. split; cbn; [now rewrite x | now rewrite y]. }
  assert (total_is : sum_of f (replaced chosen p q) = 0).
  { rewrite sum_over_replaced.
    - assert (of_all : sum_of f (convolution_segments p q) = 0)
        by exact (cycles_sum g _ respects (convolution_is_closed p q p_edges q_edges)).
      rewrite of_all. unfold sum_at_vertices. rewrite !sum_of_zeros; [reflexivity | |]; intros v _; rewrite of_moved; lia.
    - intros s. unfold f. cbn. lia.
    - intros a b a' b' start end_. unfold f. cbn. now rewrite (respects _ _ start), (respects _ _ end_). }
  unfold f in total_is. rewrite sum_minus in total_is. rewrite !sum_of_images. lia.
Qed.

(* Lemma 4.2.15, for any choice of vertices of two regions, and every point: replacing the segments of a vertex v
   of P lowers the winding number of x by that of x - v by Q, which is 1 where x is inside Q moved by v and Q goes
   round it once, and 0 outside. *)
Theorem winding_number_of_replaced_segments (chosen : vertex -> bool) (p q : region) (x : vector) :
  winding_number x (replaced chosen p q) =
  winding_number x (convolution_segments p q) -
  sum_of (fun v => Z.b2z (chosen (OfP, v)) * winding_number (minus x (fst v)) (region_edges q))
    (region_vertices p) -
  sum_of (fun v => Z.b2z (chosen (OfQ, v)) * winding_number (minus x (fst v)) (region_edges p))
    (region_vertices q).
Proof.
  rewrite !winding_number_as_sum, (sum_over_replaced (signed_crossing x)).
  - f_equal; [f_equal |]; apply sum_equally; intros v _; f_equal; apply sum_equally; intros [a b] _;
      apply crossing_of_moved.
  - intros [a b]. apply crossing_backwards.
  - apply crossing_of_equal_ends.
Qed.

(* Theorem. The winding number of the original convolution at x is the signed number of features of the intersection
   of P and -Q + x at which d is tangent, in every direction d. *)
Theorem original_winding_number_counts_tangent_features (p q : region) (d x : vector) :
  turns_in_all_chains p -> turns_in_all_chains q -> nonzero d ->
  winding_number x (original_convolution p q) = tangent_features d x p q.
Proof.
  intros p_turns q_turns proper_d. rewrite <- winding_number_less_reflex_vertices by assumption.
  apply winding_number_of_replaced_segments.
Qed.
