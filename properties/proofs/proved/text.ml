(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Results as text, numbers and brackets as oplus writes them. *)

let number q = Regions.as_string (Proved.printed_number q)
let list_of item items = "(" ^ String.concat ", " (List.map item items) ^ ")"
let point { Proved.x_of; y_of } = number x_of ^ " " ^ number y_of
let wkt polygons = Regions.as_string (Proved.printed_polygons polygons)

(* A region with edges and points of its own; without these, the region. *)
let set components edges points =
  let region = match components with [] when edges <> [] || points <> [] -> "" | _ -> wkt components in
  if edges = [] && points = [] then region
  else
    let line (a, b) = "LINESTRING " ^ list_of point [ a; b ] in
    let single p = "POINT " ^ list_of point [ p ] in
    let parts = (if region = "" then [] else [ String.trim region ]) @ List.map line edges @ List.map single points in
    "GEOMETRYCOLLECTION " ^ list_of Fun.id parts ^ "\n"

(* An unbounded region: what is in its holes, and these, of a component without an outer chain. *)
let dat (holes, components) =
  let chain c = Printf.sprintf "%d\n%s" (List.length c) (String.concat "" (List.map (fun p -> point p ^ "\n") c)) in
  let chains l = Printf.sprintf "%d\n%s" (List.length l) (String.concat "" (List.map chain l)) in
  String.concat "" (List.map (fun (outer, holes) -> chain outer ^ chains holes) components) ^ "0\n" ^ chains holes
