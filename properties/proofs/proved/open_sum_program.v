(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The open sum of two regions, as a program: the sum of the points inside them. It is what the chains of the closed
   sum go round (sum_of_uncovered_pieces.v), but for the points at which the interiors of P and -Q + x do not meet. These are on
   sums of a vertex and an edge. So such segments are cut where others meet them; along each piece the interiors meet
   in all points or in none (open_along_a_piece.v), and the collision test at its middle says which. What is left are
   the ends of pieces, and the sums of two vertices. That the result is right is proved in open_sum_is_right.v. *)
From Coq Require Import QArith ZArith Bool List.
From Oplus Require Import specification convolution convolution_winding specification_bridge regions reflected
  location pieces
  naive_collision placed_collision filling sum_program sum_of_uncovered_pieces.
Import ListNotations.

Open Scope Q_scope.

(* A segment moved by a vector. *)
Definition moved_segment (v : vector) (s : segment) : segment := Segment (plus v (source s)) (plus v (target s)).

Definition vertices_of (r : region) : list vector := map source (region_edges r).

(* Sums of a vertex of one region and an edge of the other. *)
Definition vertex_edge_segments (a b : region) : list segment :=
  flat_map (fun v => map (moved_segment v) (region_edges b)) (vertices_of a).

Definition all_vertex_edge_segments (p q : region) : list segment :=
  vertex_edge_segments p q ++ vertex_edge_segments q p.

(* Whether an edge of r at its vertex v leads into the other region, if v is strictly inside its edge f, reflected:
   then the interiors meet all along v + f. *)
Definition leads_across (r : region) (f : segment) (v : vector) : bool :=
  existsb (fun e => (same_point (source e) v && negative (cross (along f) (along e))) ||
                    (same_point (target e) v && negative (cross (along e) (along f)))) (region_edges r).

(* Those along which the interiors can fail to meet. *)
Definition touching_segments (a b : region) : list segment :=
  flat_map (fun v => map (moved_segment v) (filter (fun f => negb (leads_across a f v)) (region_edges b)))
    (vertices_of a).

Definition touching_pieces (p q : region) : list segment :=
  let all := all_vertex_edge_segments p q in
  flat_map (fun s => map undirected (cut_where_met s all)) (touching_segments p q ++ touching_segments q p).

(* Edges that cross are looked for first: they are quickly found, where there are any. *)
Definition pieces_cross_at (of_p of_q : list segment) (x : vector) : bool :=
  let reflected_q := map (reflected x) of_q in existsb (fun s => existsb (cross_properly s) reflected_q) of_p.

Definition interiors_meet_at (p q : region) (x : vector) : bool := collide p (placed x q).

(* Pieces with the sum on both sides, along which the interiors do not meet. *)
Definition is_dangling (crossing_at meet_at : vector -> bool) (convolution_ : list segment) (e : segment) : bool :=
  if crossing_at (middle e) then false
  else if is_right_inside convolution_ e then
    if is_right_inside convolution_ (reversed e) then negb (meet_at (middle e)) else false
  else false.

Definition vertex_sums (p q : region) : list vector :=
  flat_map (fun v => map (fun u => reduced_vector (plus v u)) (vertices_of q)) (vertices_of p).

(* Points inside the sum, on no dangling edge, at which the interiors do not meet. *)
Definition is_isolated (crossing_at meet_at : vector -> bool) (sum_ dangling : list segment) (v : vector) : bool :=
  if crossing_at v then false
  else if existsb (is_on_segment v) (sum_ ++ dangling) then false
  else if (winding_number v sum_ =? 0)%Z then false else negb (meet_at v).

Definition dangling_among (p q : region) (pieces : list segment) : list segment :=
  let crossing_at := pieces_cross_at (boundary_pieces p) (boundary_pieces q) in
  nodup segment_dec
    (filter (is_dangling crossing_at (interiors_meet_at p q) (convolution_segments p q)) pieces).

Definition isolated_among (p q : region) (pieces sum_ dangling : list segment) : list vector :=
  let crossing_at := pieces_cross_at (boundary_pieces p) (boundary_pieces q) in
  nodup vector_dec
    (filter (is_isolated crossing_at (interiors_meet_at p q) sum_ dangling)
      (flat_map (fun e => [source e; target e]) pieces ++ vertex_sums p q)).

Definition as_edge (s : segment) : edge := (as_point (source s), as_point (target s)).

(* The chains are those of a closed sum, however it was found. *)
Definition open_sum_around (sum_ p q : polygonal_region) : open_region :=
  let p := as_region p in
  let q := as_region q in
  let pieces := touching_pieces p q in
  let dangling := dangling_among p q pieces in
  OpenRegion sum_ (map as_edge dangling)
    (map as_point (isolated_among p q pieces (region_edges (as_region sum_)) dangling)).

Definition open_sum_of_regions (p q : polygonal_region) : open_region := open_sum_around (quick_sum p q) p q.
