(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The open sum of two regions, as a program: the sum of the points inside them. It is what the chains of the closed
   sum go round (total_sum.v), but for the points at which the interiors of P and -Q + x do not meet. These are on
   sums of a vertex and an edge. So such segments are cut where others meet them; along each piece the interiors meet
   in all points or in none (open_along_a_piece.v), and the collision test at its middle says which. What is left are
   the ends of pieces, and the sums of two vertices. That the result is right is proved in open_sum_is_right.v. *)
From Coq Require Import QArith ZArith Bool List.
From Oplus Require Import specification convolution convolution_winding specification_bridge regions location pieces
  naive_collision placed_collision filling sum_program total_sum.
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

(* Whether an edge of r that starts in v leads into the other region, if v is strictly inside its edge f, reflected:
   then the interiors meet all along v + f. *)
Definition leads_across (r : region) (f : segment) (v : vector) : bool :=
  existsb (fun e => same_point (source e) v && negative (cross (along f) (along e))) (region_edges r).

(* Those along which the interiors can fail to meet. *)
Definition touching_segments (a b : region) : list segment :=
  flat_map (fun v => map (moved_segment v) (filter (fun f => negb (leads_across a f v)) (region_edges b)))
    (vertices_of a).

Definition touching_pieces (p q : region) : list segment :=
  let all := all_vertex_edge_segments p q in
  nodup segment_dec
    (flat_map (fun s => map undirected (cut_where_met s all)) (touching_segments p q ++ touching_segments q p)).

Definition interiors_meet_at (p q : region) (x : vector) : bool := collide p (placed x q).

(* Pieces with the sum on both sides, along which the interiors do not meet. *)
Definition is_dangling (p q : region) (convolution_ : list segment) (e : segment) : bool :=
  if is_right_inside convolution_ e then
    if is_right_inside convolution_ (reversed e) then negb (interiors_meet_at p q (middle e)) else false
  else false.

Definition vertex_sums (p q : region) : list vector :=
  flat_map (fun v => map (fun u => reduced_vector (plus v u)) (vertices_of q)) (vertices_of p).

(* Points inside the sum, on no dangling edge, at which the interiors do not meet. *)
Definition is_isolated (p q : region) (sum_ dangling : list segment) (v : vector) : bool :=
  if existsb (is_on_segment v) (sum_ ++ dangling) then false
  else if (winding_number v sum_ =? 0)%Z then false else negb (interiors_meet_at p q v).

Definition dangling_pieces (p q : region) : list segment :=
  let convolution_ := convolution_segments p q in
  filter (is_dangling p q convolution_) (touching_pieces p q).

Definition isolated_vertices (p q : region) (sum_ dangling : list segment) : list vector :=
  filter (is_isolated p q sum_ dangling)
    (nodup vector_dec (flat_map (fun e => [source e; target e]) (touching_pieces p q) ++ vertex_sums p q)).

Definition as_edge (s : segment) : edge := (as_point (source s), as_point (target s)).

(* The chains are those of a closed sum, however it was found. *)
Definition open_sum_around (sum_ p q : polygonal_region) : open_region :=
  let dangling := dangling_pieces (as_region p) (as_region q) in
  OpenRegion sum_ (map as_edge dangling)
    (map as_point (isolated_vertices (as_region p) (as_region q) (region_edges (as_region sum_)) dangling)).

Definition open_sum_of_regions (p q : polygonal_region) : open_region := open_sum_around (sum_of_regions p q) p q.
