(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* What the checker answers about a layout, as an exit code and a line. *)

let certified container parts =
  Printf.sprintf "certified: no two of %d parts overlap%s" (List.length parts)
    (if container = None then "" else ", and all are in the container")

(* Which region it is: a part, or what is outside the container. *)
let rec part_of (piece : Proved.piece) number = function
  | [] -> invalid_arg "part_of"
  | region :: rest ->
      if List.memq piece.corners_of region.Proved.convex_pieces then number else part_of piece (number + 1) rest

let why container (certificate : Proved.layout_certificate) refusal =
  let first = if container = None then 0 else -1 in
  let pieces_of n = if n < 0 then "the outside of the container" else Printf.sprintf "part %d" n in
  match refusal with
  | Proved.NotPieces n ->
      Printf.sprintf "the pieces of %s are not convex, or are not all of it" (pieces_of (first + Z.to_int n))
  | NotSeparate (t, u) ->
      let i = part_of t first certificate.of_regions and j = part_of u first certificate.of_regions in
      if i = j then Printf.sprintf "pieces of %s overlap" (pieces_of i)
      else if min i j < 0 then Printf.sprintf "part %d is not shown to be in the container" (max i j)
      else Printf.sprintf "part %d and part %d are not shown to be apart" (min i j) (max i j)

let of_certificate container parts certificate =
  match Proved.check_layout container parts certificate with
  | None -> (0, certified container parts)
  | Some refusal -> (1, "not certified: " ^ why container certificate refusal)
