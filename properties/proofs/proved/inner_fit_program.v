(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Where b, moved, is inside a, as a program; exact fits are edges and points. Moved by x, b is inside a iff no point
   inside b comes to a point outside a: iff x is not in the open sum of the outside of a and -b. The outside of a is
   unbounded; here it is bounded by a square frame so large that b, where it is close to a, does not come near it.
   Then what is in the frame's middle and not in the open sum are the placements: chains that were holes are turned.
   That this is so is proved in inner_fit_is_right.v. *)
From Coq Require Import QArith Qabs ZArith Bool List.
From Oplus Require Import specification convolution specification_bridge regions placed_collision checked_collision
  sum_program open_sum_program open_sums turned_chains.
Import ListNotations.

Open Scope Q_scope.

Definition larger (a b : Q) : Q := if Qle_bool a b then b else a.

(* No coordinate is larger. *)
Definition size_of (points : list vector) : Q :=
  fold_right (fun v size => larger (Qabs (vx v)) (larger (Qabs (vy v)) size)) 1 points.

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

(* Nothing is returned if a region does not pass the test, or b has no points. *)
Definition inner_fit (a b : polygonal_region) : option placements :=
  let a := as_region a in
  let b := as_region b in
  let size := size_of (concat a ++ concat b) in
  match concat b with
  | [] => None
  | _ =>
    if covers_nothing_twice a then
      if covers_nothing_twice b then
        option_map (placements_in (2 * size))
          (checked_open_sum (as_polygonal (complement_in_frame (5 * size) a)) (as_polygonal (half_turned b)))
      else None
    else None
  end.
