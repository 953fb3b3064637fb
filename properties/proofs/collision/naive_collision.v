(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The naive test whether the interiors of two regions have a point in common, computed as
   reference/definitions/collision.cpp computes it: edges are cut where chains of their own region touch; then
   either two of the pieces cross, or one, cut once more where the other region's boundary meets it, is inside the
   other region, or runs along its boundary in the same direction. *)
From Coq Require Import ZArith Bool List.
From Oplus Require Import numbers convolution shifted_ray regions location pieces.
Import ListNotations.

Open Scope Q_scope.

Definition middle (s : segment) : vector :=
  Vector ((vx (source s) + vx (target s)) / 2) ((vy (source s) + vy (target s)) / 2).

(* The edges of a region, cut where its chains touch. *)
Definition boundary_pieces (r : region) : list segment :=
  flat_map (fun e => cut_where_met e (region_edges r)) (region_edges r).

(* For a piece of a boundary between two contacts with the boundary of b. *)
Definition shows_common_interior (piece : segment) (b : region) (of_b : list segment) : bool :=
  match locate (middle piece) b with
  | Outside => false
  | Inside => true
  | Boundary => existsb (fun f => is_on_segment (middle piece) f && positive (dot (along f) (along piece))) of_b
  end.

Definition boundary_enters (of_a : list segment) (b : region) (of_b : list segment) : bool :=
  existsb (fun s => existsb (fun piece => shows_common_interior piece b of_b) (cut_where_met s of_b)) of_a.

Definition collide (a b : region) : bool :=
  let of_a := boundary_pieces a in
  let of_b := boundary_pieces b in
  existsb (fun s => existsb (cross_properly s) of_b) of_a ||
  boundary_enters of_a b of_b || boundary_enters of_b a of_a.
