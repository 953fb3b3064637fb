(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The open sum of two regions, as a program: the sum of the points inside them. It is what the chains of the closed
   sum go round (sum_of_uncovered_pieces.v), but for the points at which the interiors of P and -Q + x do not meet.
   These are on sums of a vertex and an edge. So such segments are cut where others meet them, where no sums of two
   edges cover them; along each piece the interiors meet in all points or in none (open_along_a_piece.v), and the
   collision test at its middle says which. What is left are the ends of pieces, and the sums of two vertices. That
   the result is right is proved in open_sum_is_right.v. *)
From Coq Require Import QArith ZArith Bool List.
From Oplus Require Import specification convolution specification_bridge regions reflected location pieces
  naive_collision placed_collision test_of_regions filling sum_program sums_of_two_edges sum_of_uncovered_pieces
  maximal_segments.
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

(* The pieces of which a point is in none of the sums of two edges: inside those the interiors meet. *)
Definition uncovered_pieces_among (d : denominator) (sums : list sum_of_two) (all : list segment) (s : segment) :
  list segment :=
  match uncovered_parts d sums s with
  | [] => []
  | parts =>
    filter (fun piece => existsb (fun w => is_in_parts (fraction s w) parts) [source piece; middle piece; target piece])
      (quick_cut s all)
  end.

(* Edges of Q that vertices touch between their ends are left out of these sums. *)
Definition clear_edges (r : region) : list segment := filter (edge_is_clear r) (region_edges r).

Definition touching_pieces (p q : region) : list segment :=
  let all := all_vertex_edge_segments p q in
  let touching := touching_segments p q ++ touching_segments q p in
  let of_p := region_edges p in
  let of_q := clear_edges q in
  let d := common_multiple (denominators (touching ++ of_p ++ of_q)) in
  let sums := sums_of_edges d of_p of_q in
  flat_map (fun s => map undirected (uncovered_pieces_among d sums all s)) touching.

(* Edges that cross are looked for first: they are quickly found, where there are any. *)
Definition pieces_cross_at (of_p of_q : list segment) (x : vector) : bool :=
  let reflected_q := map (reflected x) of_q in existsb (fun s => existsb (cross_properly s) reflected_q) of_p.

Definition interiors_meet_at (p q : region) (x : vector) : bool := collide p (placed x q).

(* Sums of two vertices, but for those inside a sum of two edges. *)
Definition vertex_sums (p q : region) : list vector :=
  let points := flat_map (fun v => map (fun u => Segment (plus v u) (plus v u)) (vertices_of q)) (vertices_of p) in
  let of_p := region_edges p in
  let of_q := clear_edges q in
  let d := common_multiple (denominators (points ++ of_p ++ of_q)) in
  let sums := sums_of_edges d of_p of_q in
  map (fun s => reduced_vector (source s))
    (filter (fun s => match uncovered_parts d sums s with [] => false | _ => true end) points).

(* Points inside the closed sum, and not on its boundary, at which the interiors do not meet. *)
Definition is_left_out (p q : region) (of_p of_q sum_ : list segment) (v : vector) : bool :=
  if existsb (is_on_segment v) sum_ then false
  else if (winding_number v sum_ =? 0)%Z then false
  else if pieces_cross_at of_p of_q v then false
  else negb (interiors_meet_at p q v).

Definition dangling_among (p q : region) (pieces sum_ : list segment) : list segment :=
  let of_p := boundary_pieces p in
  let of_q := boundary_pieces q in
  nodup segment_dec (filter (fun e => is_left_out p q of_p of_q sum_ (middle e)) pieces).

Definition isolated_among (p q : region) (pieces sum_ dangling : list segment) : list vector :=
  let of_p := boundary_pieces p in
  let of_q := boundary_pieces q in
  nodup vector_dec
    (filter (fun v => if existsb (is_on_segment v) dangling then false else is_left_out p q of_p of_q sum_ v)
      (flat_map (fun e => [source e; target e]) pieces ++ vertex_sums p q)).

Definition as_edge (s : segment) : edge := (as_point (source s), as_point (target s)).

(* The chains are those of a closed sum, however it was found. *)
Definition open_sum_around (sum_ p q : polygonal_region) : open_region :=
  let p := as_region p in
  let q := as_region q in
  let boundary_ := region_edges (as_region sum_) in
  let pieces := touching_pieces p q in
  let dangling := dangling_among p q pieces boundary_ in
  OpenRegion sum_ (map as_edge (maximal_segments dangling)) (map as_point (isolated_among p q pieces boundary_ dangling)).

Definition open_sum_of_regions (p q : polygonal_region) : open_region := open_sum_around (quick_sum p q) p q.
