(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* What the checker answers, as an exit code and a line. *)

let described { Proved.x_of; y_of } =
  let number { Proved.qnum; qden } = Q.to_string (Q.make qnum qden) in
  Printf.sprintf "(%s, %s)" (number x_of) (number y_of)

(* The ends of an edge, numbered by its source. *)
let rec ends number = function
  | [] -> invalid_arg "ends"
  | chain :: rest ->
      let n = List.length chain in
      if number < n then (List.nth chain number, List.nth chain ((number + 1) mod n)) else ends (number - n) rest

let corners (polygon : Proved.polygon) =
  let corner { Proved.px; py; pw } = described { x_of = { qnum = px; qden = pw }; y_of = { qnum = py; qden = pw } } in
  String.concat " " (List.map corner polygon)

(* What a number means among the edges of S, its dangling edges, and its points. *)
let edge number { Proved.open_chains; dangling_edges; isolated_points } =
  let from_to (a, b) = Printf.sprintf "from %s to %s" (described a) (described b) in
  let edges = List.fold_left (fun count chain -> count + List.length chain) 0 open_chains in
  let later = number - edges in
  if later < 0 then Printf.sprintf "edge %d of S, %s," number (from_to (ends number open_chains))
  else if later < List.length dangling_edges then
    Printf.sprintf "dangling edge %d of S, %s," later (from_to (List.nth dangling_edges later))
  else
    let point = later - List.length dangling_edges in
    Printf.sprintf "isolated point %d of S, %s," point (described (List.nth isolated_points point))

let why s (certificate : Proved.certificate) = function
  | Proved.PiecesOfP -> "the pieces of P are not convex, or are not P"
  | PiecesOfQ -> "the pieces of Q are not convex, or are not Q"
  | PiecesOfS -> "the pieces of S are not convex, or are not S"
  | LinksOfP -> "the links of P do not lead to all its pieces"
  | LinksOfQ -> "the links of Q do not lead to all its pieces"
  | RootOutside -> "the sum of a point inside a piece of P and one inside a piece of Q is not in S"
  | EdgeInside n -> edge (Z.to_int n) s ^ " is not shown to be beside the sum of each piece of P and each of Q"
  | CellOutside n ->
      Printf.sprintf "piece %s of S, %s, is not shown to consist of sums" (Z.to_string n)
        (corners (fst (List.nth certificate.sum_pieces (Z.to_int n))))
  | DiagonalsOfS -> "a side of a piece of S is no edge of S, and has no seam"
  | SeamOutside n ->
      let (v, w), _ = List.nth certificate.seams (Z.to_int n) in
      Printf.sprintf "what is between vertices %s and %s of S is not shown to consist of sums, and of what is left out"
        (Z.to_string (Z.pred v)) (Z.to_string (Z.pred w))
  | EdgesOfP -> "edges of P cross or overlap"
  | EdgesOfQ -> "edges of Q cross or overlap"
  | EdgesOfS -> "edges of S cross or overlap"

(* Of a closed sum, without edges and points of its own, or of an open one. *)
let of_sum ~is_open p q s certificate =
  match Proved.check is_open p q s certificate with
  | None ->
      let kind = if is_open then "open Minkowski sum" else "Minkowski sum" in
      (0, Printf.sprintf "certified: S is the %s of P and Q" kind)
  | Some refusal -> (1, "not certified: " ^ why s certificate refusal)
