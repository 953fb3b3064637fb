(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The convolution of two regions consists of closed chains, so that it has winding numbers. *)
From Coq Require Import ZArith Lia Bool List Permutation SetoidList SetoidPermutation.
From Oplus Require Import numbers convolution shifted_ray signed_crossings total_turn.
Import ListNotations.

Open Scope nat_scope.

(* The convolution as directed segments: reference/definitions/convolution.cpp. *)
Definition convolution_segments (p q : region) : list segment :=
  map (fun s => Segment (starts_at s) (ends_at s)) (segments_of_regions p q).

(* Theorem. At every point as many segments of the convolution of two regions start as end: they are
   the edges of closed chains, which is what the theorems on winding numbers ask for. *)
Theorem convolution_is_closed : forall p q : region,
  (forall chain, In chain p -> no_edge_is_a_point chain) ->
  (forall chain, In chain q -> no_edge_is_a_point chain) ->
  winding_number.cycles (convolution_segments p q).
Proof.
  intros p q P Q. unfold winding_number.cycles, convolution_segments. rewrite !map_map. cbn.
  apply permuted_vectors. now apply region_points_permute.
Qed.

(* Theorem. The winding number of a point off the convolution of two regions, as the code counts it on a ray to the
   right, is what every other ray counts, and is how many full turns the convolution makes around the point. *)
Theorem convolution_winding_number_by_any_ray : forall (p q : region) x k d,
  (forall chain, In chain p -> no_edge_is_a_point chain) ->
  (forall chain, In chain q -> no_edge_is_a_point chain) ->
  off x (convolution_segments p q) -> nonzero d ->
  winding_number_by_ray k d x (convolution_segments p q) =
    winding_number.winding_number x (convolution_segments p q) /\
  (total_angle (map (seen_from x) (convolution_segments p q)) ==
    4 * inject_Z (winding_number.winding_number x (convolution_segments p q)))%Q.
Proof.
  intros p q x k d P Q O D. pose proof (convolution_is_closed p q P Q) as C. split.
  - now apply winding_number_by_any_ray.
  - now apply winding_number_counts_turns.
Qed.

(* Theorem. Observation 4.2.5: along any path of straight steps between two points off the convolution of
   two regions, the signed crossings add up to the difference of the winding numbers at its ends,
   wherever the points between are; along a closed path they add up to zero. *)
Theorem convolution_crossings_add_up : forall (p q : region) path first,
  (forall chain, In chain p -> no_edge_is_a_point chain) ->
  (forall chain, In chain q -> no_edge_is_a_point chain) ->
  off first (convolution_segments p q) -> off (last path first) (convolution_segments p q) ->
  signed_crossings_of_path (first :: path) (convolution_segments p q) =
    (winding_number.winding_number (last path first) (convolution_segments p q) -
     winding_number.winding_number first (convolution_segments p q))%Z /\
  (last path first = first ->
   signed_crossings_of_path (first :: path) (convolution_segments p q) = 0%Z).
Proof.
  intros p q path first P Q A B.
  pose proof (signed_crossings_add_up _ path first (convolution_is_closed p q P Q) A B) as E.
  split; [exact E |]. intros closed. rewrite E, closed. lia.
Qed.
