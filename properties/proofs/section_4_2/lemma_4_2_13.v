(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Lemma 4.2.13: with the segments of vertices replaced by their flip sets (replaced_segments.v), the convolution
   still consists of closed chains, so that winding numbers are well defined, as the thesis means it: signed
   crossings of closed paths add up to zero. Closed chains and rays are from winding_number.v, paths from
   signed_crossings.v. *)
From Coq Require Import QArith ZArith Lia Bool List SetoidList SetoidPermutation.
From Oplus Require Import convolution signed_crossings convolution_winding finite_sums regions replaced_segments.
Import ListNotations.

Open Scope Z_scope.

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

(* Theorem. For any choice of vertices of two regions: with their segments replaced, as many segments still end at
   each point as start there. *)
Theorem replaced_segments_are_cycles (chosen : vertex_of_summand -> bool) (p q : region) :
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
      rewrite of_all. unfold sum_at_vertices.
      unfold sum_of in of_moved |- *. rewrite !sum_of_zeros; [reflexivity | |]; intros v _; rewrite of_moved; lia.
    - intros s. unfold f. cbn. lia.
    - intros a b a' b' start end_. unfold f. cbn. now rewrite (respects _ _ start), (respects _ _ end_). }
  unfold f in total_is. rewrite sum_minus in total_is. rewrite !sum_of_images. lia.
Qed.

(* Lemma 4.2.13, for any choice of vertices. Winding numbers of the result are the same for all rays, and change
   along each path by the signed crossings, so that those of a closed path add up to zero. *)
Theorem replaced_winding_number_is_well_defined (chosen : vertex_of_summand -> bool) (p q : region) :
  no_edges_are_points p -> no_edges_are_points q ->
  (forall x side d, off x (replaced chosen p q) -> nonzero d ->
     winding_number_by_ray side d x (replaced chosen p q) = winding_number x (replaced chosen p q)) /\
  (forall path first, off first (replaced chosen p q) -> off (last path first) (replaced chosen p q) ->
     signed_crossings_of_path (first :: path) (replaced chosen p q) =
       winding_number (last path first) (replaced chosen p q) - winding_number first (replaced chosen p q)) /\
  (forall path first, off first (replaced chosen p q) -> last path first = first ->
     signed_crossings_of_path (first :: path) (replaced chosen p q) = 0).
Proof.
  intros p_edges q_edges. pose proof (replaced_segments_are_cycles chosen p q p_edges q_edges) as closed.
  split; [| split].
  - intros x side d free proper_d. now apply winding_number_by_any_ray.
  - intros path first free_first free_last. now apply signed_crossings_add_up.
  - intros path first free back. rewrite signed_crossings_add_up; trivial; rewrite back; [lia | exact free].
Qed.
