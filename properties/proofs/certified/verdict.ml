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

let why s (certificate : Proved.certificate) = function
  | Proved.PiecesOfP -> "the pieces of P are not convex, or are not P"
  | PiecesOfQ -> "the pieces of Q are not convex, or are not Q"
  | PiecesOfS -> "the pieces of S are not convex, or are not S"
  | LinksOfP -> "the links of P do not lead to all its pieces"
  | LinksOfQ -> "the links of Q do not lead to all its pieces"
  | RootOutside -> "the sum of a point inside a piece of P and one inside a piece of Q is not in S"
  | EdgeInside n ->
      let a, b = ends (Z.to_int n) s in
      Printf.sprintf
        "edge %s of S, from %s to %s, is not shown to be beside the sum of each piece of P and each of Q"
        (Z.to_string n) (described a) (described b)
  | CellOutside n ->
      Printf.sprintf "piece %s of S, %s, is not shown to consist of sums" (Z.to_string n)
        (corners (fst (List.nth certificate.sum_pieces (Z.to_int n))))
  | DiagonalsOfS -> "a side of a piece of S is no edge of S, and has no seam"
  | SeamOutside n -> Printf.sprintf "seam %s of S is not shown to consist of sums" (Z.to_string n)
  | EdgesOfP -> "edges of P cross or overlap"
  | EdgesOfQ -> "edges of Q cross or overlap"
  | EdgesOfS -> "edges of S cross or overlap"

let of_certificate p q s certificate =
  match Proved.check false p q { open_chains = s; dangling_edges = []; isolated_points = [] } certificate with
  | None -> (0, "certified")
  | Some refusal -> (1, "not certified: " ^ why s certificate refusal)
