(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Where b, moved, is inside a, and where it overlaps a, as programs; exact fits are edges and points. Moved by x, b
   is inside a iff no point inside b comes to a point outside a: iff x is not in the open sum of the outside of a and
   -b. The outside of a is unbounded; here it is bounded by a square frame so large that b, where it is close to a,
   does not come near it. Then what is in the frame's middle and not in the open sum are the placements: chains that
   were holes are turned. That this is so is proved in inner_fit_is_right.v. *)
From Coq Require Import QArith Qabs ZArith Bool List.
From Oplus Require Import specification convolution specification_bridge regions placed_collision
  sum_program open_sum_program turned_chains.
Import ListNotations.

Open Scope Q_scope.

Definition the_larger (a b : Q) : Q := if Qle_bool a b then b else a.

(* no coordinate is larger. *)
Definition size_of (points : list vector) : Q :=
  fold_right (fun v size => the_larger (Qabs (vx v)) (the_larger (Qabs (vy v)) size)) 1 points.

Definition frame (k : Q) : list vector := [Vector (- k) (- k); Vector k (- k); Vector k k; Vector (- k) k].

Definition complement_in_frame (k : Q) (a : region) : region := frame k :: map turned_chain a.

Definition half_turned (b : region) : region := placed (Vector 0 0) b.

Definition starts_in (k : Q) (c : list vector) : bool := match c with [] => false | v :: _ => is_in_square k v end.

(* What is in the square and not in the open set. *)
Definition placements_in (k : Q) (s : open_region) : placements :=
  Placements
    (map (map as_point) (map turned_chain (filter (starts_in k) (as_region (open_chains s)))))
    (filter (fun e => is_in_square k (as_vector (fst e))) (dangling_edges s))
    (filter (fun v => is_in_square k (as_vector v)) (isolated_points s)).

Definition as_polygonal (r : region) : polygonal_region := map (map as_point) r.

(* b has to have points. *)
Definition inner_fit (a b : polygonal_region) : placements :=
  let size := size_of (concat (as_region a) ++ concat (as_region b)) in
  placements_in (2 * size)
    (open_sum_of_regions (as_polygonal (complement_in_frame (5 * size) (as_region a)))
      (as_polygonal (half_turned (as_region b)))).

(* Where b, moved, overlaps a. *)
Definition no_fit (a b : polygonal_region) : open_region :=
  open_sum_of_regions a (as_polygonal (half_turned (as_region b))).
