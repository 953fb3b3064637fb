(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Certificates of inner fits as docs/certificates.md has them: what the open sum has beyond the placements, then that sum.
   As with those of sums, nothing here need be believed. *)
open Words

let point text =
  let x_of = take_number text in
  { Proved.x_of; y_of = take_number text }

(* Points up to the end of the line. *)
let chain text =
  let rec more found = if text.word = "\n" then List.rev found else more (point text :: found) in
  let points = more [ point text ] in
  Certificates.end_line text;
  points

let edge text =
  match chain text with
  | [ a; b ] -> (a, b)
  | _ -> refuse text "an edge that has not two ends" "x y x y"

let single text =
  match chain text with
  | [ v ] -> v
  | _ -> refuse text "a line of more than one point" "x y"

let outer text =
  let open_chains = Certificates.lines text "outer" chain in
  let dangling_edges = Certificates.lines text "outer-edges" edge in
  let isolated_points = Certificates.lines text "outer-points" single in
  { Proved.open_chains; dangling_edges; isolated_points }

let inner_fit a b f text =
  Certificates.claim text "ifp";
  let beyond = outer text in
  let p = Proved.outside_of a b and q = Proved.half_turned_region b in
  { Proved.beyond; of_open_sum = Certificates.sum_like ~is_open:true p q (Proved.open_sum_around_placements beyond f) text }

let no_fit a b s text =
  Certificates.claim text "nfp";
  Certificates.sum_like ~is_open:true a (Proved.half_turned_region b) s text
