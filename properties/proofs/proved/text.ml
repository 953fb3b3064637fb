(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Results as text, numbers as oplus writes them. *)

let number q = Regions.as_string (Proved.printed_number q)
let point { Proved.x_of; y_of } = number x_of ^ " " ^ number y_of
let wkt polygons = Regions.as_string (Proved.printed_polygons polygons)

let set polygons edges points = Regions.as_string (Proved.printed_set polygons edges points)

(* An unbounded region: what is in its holes, and these, of a component without an outer chain. *)
let dat (holes, components) =
  let chain c = Printf.sprintf "%d\n%s" (List.length c) (String.concat "" (List.map (fun p -> point p ^ "\n") c)) in
  let chains l = Printf.sprintf "%d\n%s" (List.length l) (String.concat "" (List.map chain l)) in
  String.concat "" (List.map (fun (outer, holes) -> chain outer ^ chains holes) components) ^ "0\n" ^ chains holes
