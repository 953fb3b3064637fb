(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The identity of docs/winding.md: the winding number of the convolution counts the points of the intersection's
   boundary at which a given direction is tangent. For all closed chains, all points and all directions. Weights
   are from weight.v, parallelograms from parallelogram.v, summation by parts from finite_sums.v. *)
From Coq Require Import ZArith Lia Bool List Arith.
From Oplus Require Import numbers convolution convolution_winding finite_sums weight regions parallelogram.
Import ListNotations.

Open Scope Z_scope.

Definition if_tangent (d : direction) (c : corner) : Z := Z.b2z (in_tangent_set d c).

(* What vertices of P count: those in whose tangent set d is, by how often they are inside -Q + x. *)
Definition tangent_vertices_of_p (d x : vector) (of_p : list (vector * corner)) (of_q : list segment) : Z :=
  sum_of (fun v => if_tangent (Direction d OfQ) (snd v) * winding_number (minus x (fst v)) of_q) of_p.

(* And vertices of Q, with -d. *)
Definition tangent_vertices_of_q (d x : vector) (of_q : list (vector * corner)) (of_p : list segment) : Z :=
  sum_of (fun v => if_tangent (Direction (opposite d) OfP) (snd v) * winding_number (minus x (fst v)) of_p) of_q.

(* And pairs of edges, by their weight and the winding number of x by the boundary of their sum. *)
Definition tangent_crossings (d x : vector) (of_p of_q : list segment) : Z :=
  sum_of (fun pair => weight d (along (fst pair)) (along (snd pair)) *
                      winding_number x (parallelogram (fst pair) (snd pair))) (list_prod of_p of_q).

Lemma winding_number_as_sum x segments : winding_number x segments = sum_of (signed_crossing x) segments.
Proof. reflexivity. Qed.

Lemma crossing_of_equal_ends x a b a' b' :
  equal_vectors a a' -> equal_vectors b b' ->
  signed_crossing x (Segment a b) = signed_crossing x (Segment a' b').
Proof.
  intros [ax ay] [bx by_]. unfold signed_crossing, at_most, orientation. cbn [source target].
  now rewrite ax, ay, bx, by_.
Qed.

Lemma crossing_backwards x a b : signed_crossing x (Segment b a) = - signed_crossing x (Segment a b).
Proof.
  unfold signed_crossing. cbn [source target]. rewrite <- crossing_reversed. f_equal.
  unfold orientation. rewrite Qcompare_antisym. apply compare_as_difference. ring.
Qed.

(* Moving a segment is moving the point the other way. *)
Lemma crossing_of_moved x v a b :
  signed_crossing x (Segment (plus v a) (plus v b)) = signed_crossing (minus x v) (Segment a b).
Proof.
  unfold signed_crossing. cbn [source target]. f_equal.
  - unfold at_most. rewrite (compare_as_difference _ _ (vy a) (vy (minus x v))); [reflexivity | cbn; ring].
  - unfold at_most. rewrite (compare_as_difference _ _ (vy b) (vy (minus x v))); [reflexivity | cbn; ring].
  - unfold orientation. apply compare_as_difference. cbn. ring.
Qed.

Lemma vertices_by_index (chain : list vector) (f : vector * corner -> Z) :
  sum_of f (combine chain (corners chain)) =
  sum_below (length chain) (fun i => f (nth i chain nowhere, corner_of_chain chain i)).
Proof.
  rewrite (sum_by_index _ _ (nowhere, Corner nowhere nowhere) _ (length chain))
    by (rewrite combine_length, corners_length; lia).
  apply sum_below_equally. intros i _. f_equal. apply combine_nth. symmetry. apply corners_length.
Qed.

Section TwoChains.
  Variables p q : list vector.
  Variables d x : vector.
  Hypothesis p_edges : no_edge_is_a_point p.
  Hypothesis q_edges : no_edge_is_a_point q.
  Hypothesis proper_d : nonzero d.

  Let n := length p.
  Let m := length q.
  Let p_at i := nth i p nowhere.
  Let q_at j := nth j q nowhere.

  (* Edge i of P moved by vertex j of Q, and edge j of Q moved by vertex i of P. *)
  Let of_p i j := signed_crossing x (Segment (plus (p_at i) (q_at j)) (plus (p_at (next i n)) (q_at j))).
  Let of_q i j := signed_crossing x (Segment (plus (p_at i) (q_at j)) (plus (p_at i) (q_at (next j m)))).

  Definition segments_of_chains (chains : list vector * list vector) : list segment :=
    map (fun s => Segment (starts_at (chains, s)) (ends_at (chains, s)))
      (convolution (fst chains) (snd chains)).

  Lemma winding_number_over_the_grid :
    winding_number x (segments_of_chains (p, q)) =
    sum_over_grid n m (fun i j => Z.b2z (is_convolution_segment p q OfP i j) * of_p i j +
                                  Z.b2z (is_convolution_segment p q OfQ i j) * of_q i j).
  Proof.
    rewrite grid_plus, winding_number_as_sum. unfold segments_of_chains, convolution. cbn [fst snd].
    rewrite sum_of_images, sum_of_filter. cbn [list_prod]. rewrite app_nil_r, sum_of_two_lists, !sum_of_images.
    rewrite !sum_of_product. reflexivity.
  Qed.

  Lemma p_by_weights i j : (i < n)%nat -> (j < m)%nat ->
    Z.b2z (is_convolution_segment p q OfP i j) =
    if_tangent (Direction (opposite d) OfP) (corner_of_chain q j) +
    weight d (edge_of_chain p i) (edge_of_chain q j) -
    weight d (edge_of_chain p i) (edge_of_chain q (previous m j)).
  Proof.
    intros I J. unfold is_convolution_segment, if_tangent.
    rewrite (p_in_tangent_set d (edge_of_chain p i)); [| exact proper_d | now apply edge_nonzero |
      now apply corner_proper].
    now rewrite (corner_is q j).
  Qed.

  Lemma q_by_weights i j : (i < n)%nat -> (j < m)%nat ->
    Z.b2z (is_convolution_segment p q OfQ i j) =
    if_tangent (Direction d OfQ) (corner_of_chain p i) +
    weight d (edge_of_chain p (previous n i)) (edge_of_chain q j) -
    weight d (edge_of_chain p i) (edge_of_chain q j).
  Proof.
    intros I J. unfold is_convolution_segment, if_tangent.
    rewrite (q_in_tangent_set d (edge_of_chain q j)); [| exact proper_d | now apply edge_nonzero |
      now apply corner_proper].
    now rewrite (corner_is p i).
  Qed.

  Lemma row_of_q i : sum_below m (of_q i) = winding_number (minus x (p_at i)) (edges q).
  Proof.
    rewrite winding_number_as_sum, (sum_by_index _ _ no_segment _ m) by apply edges_are_as_many.
    apply sum_below_equally. intros j J. rewrite edge_by_index by exact J. apply crossing_of_moved.
  Qed.

  Lemma column_of_p j : sum_below n (fun i => of_p i j) = winding_number (minus x (q_at j)) (edges p).
  Proof.
    rewrite winding_number_as_sum, (sum_by_index _ _ no_segment _ n) by apply edges_are_as_many.
    apply sum_below_equally. intros i I. rewrite edge_by_index by exact I. rewrite <- crossing_of_moved.
    apply crossing_of_equal_ends; split; apply Qplus_comm.
  Qed.

  Lemma around_a_cell i j : (i < n)%nat -> (j < m)%nat ->
    of_p i j + of_q (next i n) j - of_p i (next j m) - of_q i j =
    winding_number x (parallelogram (nth i (edges p) no_segment) (nth j (edges q) no_segment)).
  Proof.
    intros I J. rewrite !edge_by_index by assumption. unfold parallelogram. cbn [source target].
    unfold winding_number, edges. cbn [rotated app combine map fst snd sum fold_right].
    unfold of_p, of_q, p_at, q_at. fold n m.
    rewrite (crossing_backwards x (plus (nth i p nowhere) (nth (next j m) q nowhere))
        (plus (nth (next i n) p nowhere) (nth (next j m) q nowhere))),
      (crossing_backwards x (plus (nth i p nowhere) (nth j q nowhere))
        (plus (nth i p nowhere) (nth (next j m) q nowhere))). lia.
  Qed.

  Lemma tangent_count_of_chains :
    winding_number x (segments_of_chains (p, q)) =
    tangent_vertices_of_p d x (combine p (corners p)) (edges q) +
    tangent_vertices_of_q d x (combine q (corners q)) (edges p) +
    tangent_crossings d x (edges p) (edges q).
  Proof.
    rewrite winding_number_over_the_grid.
    rewrite (grid_by_parts n m _ _ (fun i j => weight d (edge_of_chain p i) (edge_of_chain q j)) of_p of_q
      _ _ p_by_weights q_by_weights).
    f_equal; [f_equal |].
    - unfold tangent_vertices_of_p. rewrite vertices_by_index. apply sum_below_equally. intros i _.
      cbn [fst snd]. now rewrite row_of_q.
    - unfold tangent_vertices_of_q. rewrite vertices_by_index. apply sum_below_equally. intros j _.
      cbn [fst snd]. now rewrite column_of_p.
    - unfold tangent_crossings. rewrite sum_of_product.
      rewrite (sum_by_index _ _ no_segment _ n) by apply edges_are_as_many.
      apply sum_below_equally. intros i I.
      rewrite (sum_by_index _ _ no_segment _ m) by apply edges_are_as_many.
      apply sum_below_equally. intros j J. cbn [fst snd].
      now rewrite around_a_cell, !direction_by_index.
  Qed.
End TwoChains.

Lemma winding_number_of_region x (r : region) :
  winding_number x (region_edges r) = sum_of (fun chain => winding_number x (edges chain)) r.
Proof. apply sum_of_flat_map. Qed.

Lemma winding_number_of_convolution x (p q : region) :
  winding_number x (convolution_segments p q) =
  sum_of (fun a => sum_of (fun b => winding_number x (segments_of_chains (a, b))) q) p.
Proof.
  rewrite winding_number_as_sum. unfold convolution_segments, segments_of_regions.
  rewrite sum_of_images, sum_of_flat_map, sum_of_product.
  apply sum_equally. intros a _. apply sum_equally. intros b _.
  rewrite sum_of_images. unfold segments_of_chains. now rewrite winding_number_as_sum, sum_of_images.
Qed.

Lemma sum_over_two A B (f g h : A -> B -> Z) l m :
  sum_of (fun a => sum_of (fun b => f a b + g a b + h a b) m) l =
  sum_of (fun a => sum_of (f a) m) l + sum_of (fun a => sum_of (g a) m) l + sum_of (fun a => sum_of (h a) m) l.
Proof. rewrite <- !sum_plus. apply sum_equally. intros a _. now rewrite <- !sum_plus. Qed.

Lemma vertices_by_chains (f : vector * corner -> Z) (moved : vector * corner -> vector) (p q : region) :
  sum_of (fun v => f v * winding_number (moved v) (region_edges q)) (region_vertices p) =
  sum_of (fun a => sum_of (fun b =>
    sum_of (fun v => f v * winding_number (moved v) (edges b)) (combine a (corners a))) q) p.
Proof.
  unfold region_vertices. rewrite sum_of_flat_map. apply sum_equally. intros a _.
  rewrite (sums_exchanged _ _ (fun b v => f v * winding_number (moved v) (edges b))).
  apply sum_equally. intros v _. now rewrite winding_number_of_region, sum_times.
Qed.

(* Theorem. For two regions of any closed chains, which may cross themselves and each other, every point x, also
   on the convolution, and every direction d: the winding number of the convolution at x is the sum
   - over the vertices p of P with d in their tangent sets, of the winding number of x - p by Q,
   - over the vertices q of Q with -d in their tangent sets, of the winding number of x - q by P,
   - over all pairs of edges, of their weight in direction d times the winding number of x by the boundary of
     their sum. *)
Theorem tangent_count_of_regions (p q : region) (d x : vector) :
  no_edges_are_points p -> no_edges_are_points q -> nonzero d ->
  winding_number x (convolution_segments p q) =
  tangent_vertices_of_p d x (region_vertices p) (region_edges q) +
  tangent_vertices_of_q d x (region_vertices q) (region_edges p) +
  tangent_crossings d x (region_edges p) (region_edges q).
Proof.
  intros p_edges q_edges proper_d. rewrite winding_number_of_convolution.
  transitivity (sum_of (fun a => sum_of (fun b =>
    tangent_vertices_of_p d x (combine a (corners a)) (edges b) +
    tangent_vertices_of_q d x (combine b (corners b)) (edges a) +
    tangent_crossings d x (edges a) (edges b)) q) p).
  { apply sum_equally. intros a I. apply sum_equally. intros b J.
    apply tangent_count_of_chains; [now apply p_edges | now apply q_edges | exact proper_d]. }
  rewrite sum_over_two. f_equal; [f_equal |].
  - symmetry. apply vertices_by_chains.
  - rewrite (sums_exchanged _ _ (fun a b => tangent_vertices_of_q d x (combine b (corners b)) (edges a))).
    symmetry. apply vertices_by_chains.
  - unfold tangent_crossings. rewrite sum_of_product. unfold region_edges. rewrite sum_of_flat_map.
    apply sum_equally. intros a _. symmetry.
    transitivity (sum_of (fun e => sum_of (fun b => sum_of (fun f =>
      weight d (along e) (along f) * winding_number x (parallelogram e f)) (edges b)) q) (edges a)).
    + apply sum_equally. intros e _. apply sum_of_flat_map.
    + rewrite sums_exchanged. apply sum_equally. intros b _. now rewrite sum_of_product.
Qed.

(* What reference/definitions/tangent_count.cpp computes. *)
Definition count_tangents (x : vector) (p q : region) (d : vector) : Z :=
  tangent_vertices_of_p d x (region_vertices p) (region_edges q) +
  tangent_vertices_of_q d x (region_vertices q) (region_edges p) +
  tangent_crossings d x (region_edges p) (region_edges q).

(* What the convolution's segments say, as reference/definitions/ computes it from `convolution`. *)
Definition convolution_winding_number (x : vector) (p q : region) : Z :=
  winding_number x (convolution_segments p q).

(* Theorem. For any closed chains, no edge of which is a point, and any direction: the tangents that are counted are as
   many as the convolution winds around x. *)
Theorem count_tangents_returns (x : vector) (p q : region) (d : vector) :
  no_edges_are_points p -> no_edges_are_points q -> nonzero d ->
  count_tangents x p q d = convolution_winding_number x p q.
Proof. intros p_edges q_edges proper_d. symmetry. now apply tangent_count_of_regions. Qed.
