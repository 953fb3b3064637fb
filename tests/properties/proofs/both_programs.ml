(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Asks the functions of oplus-proved and those that are extracted without any replacement for all that the program
   computes, and fails unless they return the same. Usage: both_programs P Q *)
open Plain_values

let polygon (Plain.Pair (outer, holes)) = (list_of point_of outer, list_of (list_of point_of) holes)
let edge (Plain.Pair (a, b)) = (point_of a, point_of b)
let polygons = list_of polygon

let open_set (s : Proved.open_region) = (Proved.polygons_of_open s, s.dangling_edges, s.isolated_points)
let fits (f : Proved.placements) = (Proved.polygons_of_placements f, f.fit_edges, f.fit_points)

let plain_open_set (s : Plain.open_region) =
  (polygons (Plain.polygons_of_open s), list_of edge s.dangling_edges, list_of point_of s.isolated_points)

let plain_fits (f : Plain.placements) =
  (polygons (Plain.polygons_of_placements f), list_of edge f.fit_edges, list_of point_of f.fit_points)

let bytes file =
  let channel = open_in_bin file in
  let text = really_input_string channel (in_channel_length channel) in
  close_in channel;
  List.map (fun c -> Z.of_int (Char.code c)) (List.of_seq (String.to_seq text))

let read_plainly file =
  match Plain.region_in Plain.False (coq_list integer (bytes file)) with
  | Inl (Pair (False, region)) -> list_of (list_of point_of) region
  | _ -> failwith (file ^ " is not read")

let () =
  let p = Regions.read Sys.argv.(1) and q = Regions.read Sys.argv.(2) in
  let plain_p = region p and plain_q = region q in
  let expect what same = if not same then failwith ("the programs disagree: " ^ what) in
  let holds = function Plain.True -> true | Plain.False -> false in
  let each what fast slow read = expect what (fast p q = read (slow plain_p plain_q)) in
  let test what fast slow = List.iter (fun (r, plain) -> expect what (fast r = holds (slow plain))) [ (p, plain_p); (q, plain_q) ] in
  expect "reading" (p = read_plainly Sys.argv.(1) && q = read_plainly Sys.argv.(2));
  each "printing"
    (fun p q -> Proved.(printed_polygons (proved_sum p q)))
    (fun p q -> Plain.(printed_polygons (proved_sum p q)))
    (list_of whole);
  test "valid" Proved.is_covered Plain.is_covered;
  test "points" Proved.has_points Plain.has_points;
  each "sum" Proved.proved_sum Plain.proved_sum polygons;
  each "open sum" (fun p q -> open_set (Proved.proved_open_sum p q)) Plain.proved_open_sum plain_open_set;
  each "nfp" (fun p q -> open_set (Proved.proved_no_fit p q)) Plain.proved_no_fit plain_open_set;
  each "ifp" (fun p q -> fits (Proved.proved_inner_fit p q)) Plain.proved_inner_fit plain_fits;
  each "union" Proved.proved_union Plain.proved_union polygons;
  each "intersection" Proved.proved_intersection Plain.proved_intersection polygons;
  each "difference" Proved.proved_difference Plain.proved_difference polygons;
  print_endline "the same"
