(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Regions in WKT, POLYGON, MULTIPOLYGON and EMPTY, and in .dat (docs/files.md). A chain without its closing vertex
   starts at its first vertex and is turned if need be, so that outer chains are counterclockwise and holes clockwise. *)
open Words

let list_of text item =
  expect text "(";
  let rec more items =
    let items = item text :: items in
    if text.word = "," then begin advance text; more items end else List.rev items
  in
  let items = more [] in
  if text.word <> ")" then refuse_word text "',' or ')'";
  advance text;
  items

let point text =
  let x = take_number text in
  let y = take_number text in
  (x, y)

(* Positive if c is to the left of the line from a to b. *)
let turn (ax, ay) (bx, by) (cx, cy) =
  Q.sign Q.(((bx - ax) * (cy - ay)) - ((by - ay) * (cx - ax)))

let compare_points (ax, ay) (bx, by) = match Q.compare ax bx with 0 -> Q.compare ay by | order -> order

(* 1 for a counterclockwise chain, -1 for a clockwise one, which may touch itself but not cross. Beyond the first edge
   counterclockwise at its leftmost vertex, the lowest of these, is the outside: is it an edge that leaves, or arrives? *)
let orientation text chain =
  let v = Array.of_list chain in
  let n = Array.length v in
  let first = List.hd (List.sort compare_points chain) in
  let edges i = [ (v.((i + 1) mod n), 1); (v.((i + n - 1) mod n), -1) ] in
  let at_first = List.filter (fun i -> compare_points v.(i) first = 0) (List.init n Fun.id) in
  let lower (a, leaves) (b, also) =
    match turn first a b with
    | 0 -> refuse text "edges of a ring overlap at its leftmost vertex" "edges that meet only in ends"
    | side -> if side < 0 then (b, also) else (a, leaves)
  in
  match List.concat_map edges at_first with
  | edge :: others -> snd (List.fold_left lower edge others)
  | [] -> assert false

let turned wanted text chain =
  if orientation text chain = - wanted then List.hd chain :: List.rev (List.tl chain) else chain

let ring wanted text =
  match list_of text point with
  | first :: rest -> (
      match List.rev rest with
      | last :: others when compare_points first last = 0 -> turned wanted text (first :: List.rev others)
      | _ -> refuse text "a ring is not closed" "its first vertex again at its end")
  | [] -> assert false

let polygon text =
  let is_outer = ref true in
  list_of text (fun text ->
      let wanted = if !is_outer then 1 else -1 in
      is_outer := false;
      ring wanted text)

let wkt text =
  let keyword = String.uppercase_ascii text.word in
  if keyword <> "POLYGON" && keyword <> "MULTIPOLYGON" then
    refuse_word text "POLYGON, MULTIPOLYGON or a number of vertices";
  advance text;
  if String.uppercase_ascii text.word = "EMPTY" then begin advance text; [] end
  else if keyword = "POLYGON" then polygon text
  else List.concat (list_of text polygon)

let counted_chain wanted text =
  let line = text.line_of_word in
  let count = take_count text in
  if count < 3 then refuse_line text.name line (Printf.sprintf "a chain of %d vertices" count) "at least 3";
  turned wanted text (List.init count (fun _ -> point text))

(* Whether it is unbounded, and its chains. The chain that an unbounded region has not is written as 0 vertices, and so
   is, alone, what is empty. Of one component the number of holes may be left out. *)
let rec dat may_be_unbounded is_first text =
  let is_unbounded = text.word = "0" in
  let outer = if is_unbounded then begin advance text; [] end else [ counted_chain 1 text ] in
  if is_first && text.word = "" then (false, outer)
  else begin
    if is_unbounded && not may_be_unbounded then refuse text "an outer chain of 0 vertices" "a bounded region";
    let count = take_count text in
    let holes = List.init count (fun _ -> counted_chain (-1) text) in
    let others_are, others =
      if text.word = "" then (false, []) else dat (may_be_unbounded && not is_unbounded) false text
    in
    (is_unbounded || others_are, outer @ holes @ others)
  end

let region may_be_unbounded text =
  if is_natural text.word then dat may_be_unbounded true text else (false, wkt text)

let read_any name = read_file name "()," (region true)
let read name = snd (read_file name "()," (region false))

(* As specification.v has it. *)
let specified region =
  let number (q : Q.t) = { Proved.qnum = q.num; qden = q.den } in
  List.map (List.map (fun (x, y) -> { Proved.x_of = number x; y_of = number y })) region
