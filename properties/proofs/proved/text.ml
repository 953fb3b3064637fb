(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Results as text, numbers and brackets as oplus writes them. *)

(* How often the factor divides a number that is not zero, and what is left. *)
let rec taken_out factor n =
  let quotient, rest = Z.ediv_rem n factor in
  if Z.equal rest Z.zero then
    let count, left = taken_out factor quotient in
    (count + 1, left)
  else (0, n)

(* A decimal where there is one that ends, else p/q. *)
let number { Proved.qnum; qden } =
  let q = Q.make qnum qden in
  let twos, rest = taken_out (Z.of_int 2) q.den in
  let fives, rest = taken_out (Z.of_int 5) rest in
  let decimals = max twos fives in
  if decimals = 0 || not (Z.equal rest Z.one) then Q.to_string q
  else
    let digits = Z.to_string Z.(divexact (abs q.num * pow (of_int 10) decimals) q.den) in
    let zeros = String.make (max 0 (decimals + 1 - String.length digits)) '0' in
    let digits = zeros ^ digits in
    let whole = String.length digits - decimals in
    (if Q.sign q < 0 then "-" else "") ^ String.sub digits 0 whole ^ "." ^ String.sub digits whole decimals

let list_of item items = "(" ^ String.concat ", " (List.map item items) ^ ")"
let point { Proved.x_of; y_of } = number x_of ^ " " ^ number y_of
let ring chain = list_of point (chain @ [ List.hd chain ])
let polygon (outer, holes) = list_of ring (outer :: holes)

let wkt = function
  | [] -> "POLYGON EMPTY\n"
  | [ component ] -> "POLYGON " ^ polygon component ^ "\n"
  | components -> "MULTIPOLYGON " ^ list_of polygon components ^ "\n"

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
