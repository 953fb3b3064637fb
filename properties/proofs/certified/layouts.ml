(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Certificates of layouts as docs/certificates.md has them. As with those of sums, nothing here need be believed. *)
open Words

let region text region =
  let inserted_points, vertices = Certificates.points text region in
  { Proved.inserted_points; convex_pieces = Certificates.(lines text "pieces" (piece vertices)) }

let part text number part =
  expect text "part";
  if take_count text <> number then refuse text "parts are not in order" (Printf.sprintf "part %d" number);
  Certificates.end_line text;
  region text part

let certificate container parts text =
  Certificates.claim text "layout";
  let layout_unit = Certificates.unit_ text in
  expect text "container";
  Certificates.end_line text;
  let regions = Proved.regions_of_layout container parts in
  let of_container =
    match container with
    | Some _ -> [ region text (List.hd regions) ]
    | None -> ignore (region text []); []
  in
  let of_parts = List.mapi (part text) parts in
  Certificates.end_ text;
  { Proved.layout_unit; of_regions = of_container @ of_parts }
