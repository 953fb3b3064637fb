(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The Minkowski sum of two regions, as a program: that what it returns is the sum is proved in sum_is_right.v. *)
From Coq Require Import QArith ZArith Bool List.
From Oplus Require Import specification checker direction winding_number homogeneous_points specification_bridge
  convolution_winding regions test_of_regions filling walks.
Import ListNotations.

Definition as_region (r : polygonal_region) : list (list vector) :=
  map (map (fun p => vector_of (homogeneous p))) r.

Definition sum_of_regions (p q : polygonal_region) : polygonal_region :=
  let f := filled (convolution_segments (as_region p) (as_region q)) in
  map (map as_point) (chains_of (length f) f).

(* For regions that may be invalid. *)
Definition minkowski_sum (p q : polygonal_region) : option polygonal_region :=
  if is_valid_region (as_region p) && is_valid_region (as_region q) then Some (sum_of_regions p q) else None.
