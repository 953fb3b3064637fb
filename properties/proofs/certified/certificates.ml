(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Certificates as docs/certificates.md has them. Nothing here need be believed: of a certificate that is read
   wrongly the checker accepts no more than of any other. *)
open Words

let end_line text = expect text "\n"

(* A line of a word and a count, and so many lines. *)
let lines text word line =
  expect text word;
  let n = take_count text in
  end_line text;
  let rec read done_ rest = if done_ = n then List.rev rest else read (done_ + 1) (line text :: rest) in
  read 0 []

(* The points that are put into the edges, by edges, and all vertices that pieces may have. *)
let points text region =
  let vertices = Array.of_list (List.concat region) in
  let inserted = Array.make (Array.length vertices) [] in
  let line text =
    let edge = text.word in
    let number = take_count text in
    if number >= Array.length vertices then
      refuse text ("there is no edge " ^ edge) (Printf.sprintf "one of %d edges" (Array.length vertices));
    let x = take_number text in
    let y = take_number text in
    let point = Proved.homogeneous { x_of = x; y_of = y } in
    inserted.(number) <- point :: inserted.(number);
    end_line text;
    point
  in
  let added = lines text "points" line in
  let given = Array.map Proved.homogeneous vertices in
  (Array.to_list (Array.map List.rev inserted), Array.append given (Array.of_list added))

(* The numbers of vertices up to the end of the line, of so many. *)
let corners count text =
  let vertex () =
    let word = text.word in
    let number = take_count text in
    if number >= count then refuse text ("there is no vertex " ^ word) (Printf.sprintf "one of %d vertices" count);
    number
  in
  let rec more found =
    let found = vertex () :: found in
    if text.word = "\n" then List.rev found else more found
  in
  let numbers = more [] in
  end_line text;
  numbers

let piece vertices text = List.map (Array.get vertices) (corners (Array.length vertices) text)

(* Numbers in files start from 0, those of the checker from 1. *)
let number text = Z.succ (take_natural text)

let link text =
  let from = number text in
  let reached = number text in
  end_line text;
  (from, reached)

(* The first piece, and what no link leads to. *)
let roots pieces links =
  let is_target = Hashtbl.create 64 in
  List.iter (fun (_, target) -> Hashtbl.replace is_target target ()) links;
  let numbers = List.mapi (fun i _ -> Z.of_int (i + 1)) pieces in
  List.filter (fun n -> Z.equal n Z.one || not (Hashtbl.mem is_target n)) numbers

let summand text name region =
  expect text "summand";
  expect text name;
  end_line text;
  let summand_inserted, vertices = points text region in
  let summand_pieces = lines text "pieces" (piece vertices) in
  let links = lines text "links" link in
  { Proved.summand_inserted; summand_pieces; roots = roots summand_pieces links; links }

(* Seams *)

(* Between points of a seam, or where such a point is. *)
let place text =
  match text.word with
  | "in" ->
      advance text;
      let i = number text in
      let j = number text in
      Proved.InSum (i, j)
  | "on" -> advance text; Proved.OnEdge (number text)
  | _ -> refuse_word text "'in' or 'on'"

(* The point of the line of which one coordinate is given: x if the line is rather flat, otherwise y. *)
let point_on text { Proved.la; lb; lc } { Proved.qnum; qden } =
  if Z.sign la = 0 && Z.sign lb = 0 then refuse text "the line of the seam is none" "a line";
  let given = Q.make qnum qden in
  let other a b = Q.neg (Q.div (Q.add (Q.mul (Q.of_bigint a) given) (Q.of_bigint lc)) (Q.of_bigint b)) in
  let x, y = if Z.leq (Z.abs la) (Z.abs lb) then (given, other la lb) else (other lb la, given) in
  let number q = { Proved.qnum = Q.num q; qden = Q.den q } in
  Proved.homogeneous { x_of = number x; y_of = number y }

(* Up to the end of the line; an interval is where the point before it is if it is not given. *)
let seam line isolated text =
  let rec more found =
    let point of_word at =
      let next = match text.word with "in" | "on" -> place text | _ -> at in
      more (((of_word, at), next) :: found)
    in
    match text.word with
    | "\n" -> List.rev found
    | "at" ->
        advance text;
        let coordinate = take_number text in
        point (point_on text line coordinate) (place text)
    | "point" ->
        advance text;
        let word = text.word in
        let k = take_count text in
        if k >= Array.length isolated then
          refuse text ("there is no point " ^ word) (Printf.sprintf "one of %d points" (Array.length isolated));
        point isolated.(k) (Proved.AtPoint (Z.of_int (k + 1)))
    | _ -> refuse_word text "'at' or 'point'"
  in
  let beginning = place text in
  { Proved.beginning; later = more [] }

(* What a seam is that is not given: in the sum of the first pair of a tree. *)
let rec usual = function
  | Proved.SumsOf (i, j) -> { Proved.beginning = InSum (i, j); later = [] }
  | Cut (_, _, one, _) -> usual one

let deepest_tree = 100_000

(* Cuts have seams if there are isolated points, even none. *)
let rec cells isolated depth text =
  match take text with
  | "in" ->
      let i, j = link text in
      Proved.SumsOf (i, j)
  | "cut" when depth < deepest_tree ->
      let coefficient () =
        let is_negative = String.starts_with ~prefix:"-" text.word in
        let digits = if is_negative then String.sub text.word 1 (String.length text.word - 1) else text.word in
        if not (is_natural digits) then refuse_word text "an integer";
        Z.of_string (take text)
      in
      let la = coefficient () in
      let lb = coefficient () in
      let lc = coefficient () in
      let line = { Proved.la; lb; lc } in
      let given = match isolated with Some points when text.word <> "\n" -> Some (seam line points text) | _ -> None in
      end_line text;
      let one = cells isolated (depth + 1) text in
      let other = cells isolated (depth + 1) text in
      let along = match (isolated, given) with Some _, None -> Some (usual other) | _ -> given in
      Proved.Cut (line, along, one, other)
  | word -> refuse text (Files.quoted word) (Printf.sprintf "'in', or 'cut' in a tree of depth at most %d" deepest_tree)

(* The seams of sides that two pieces have: that of the later one's tree, or what is given. *)
let seams vertices isolated pieces text =
  let line text =
    let count = Array.length vertices in
    let vertex () =
      let word = text.word in
      let v = take_count text in
      if v >= count then refuse text ("there is no vertex " ^ word) (Printf.sprintf "one of %d vertices" count);
      v
    in
    let v = vertex () in
    let w = vertex () in
    let along = seam (Proved.line_through vertices.(v) vertices.(w)) isolated text in
    end_line text;
    (v, w, along)
  in
  let given = lines text "seams" line in
  let is_given = Hashtbl.create 64 in
  List.iter (fun (v, w, _) -> Hashtbl.replace is_given (min v w, max v w) ()) given;
  let is_side = Hashtbl.create 1024 in
  let seams_of (corners, tree) =
    let side v w = Hashtbl.replace is_side (v, w) (); (v, w, usual tree) in
    let is_usual (v, w, _) = Hashtbl.mem is_side (w, v) && not (Hashtbl.mem is_given (min v w, max v w)) in
    List.filter is_usual (List.map2 side corners (List.tl corners @ [ List.hd corners ]))
  in
  let numbered (v, w, along) = ((Z.of_int (v + 1), Z.of_int (w + 1)), along) in
  List.map numbered (given @ List.concat_map seams_of pieces)

(* The whole *)

(* The first lines, with the kind of the claim. *)
let claim text kind =
  List.iter (expect text) [ "oplus"; "certificate"; "2"; "\n"; "claim" ];
  if text.word <> kind then refuse text ("a certificate of the kind " ^ Files.quoted text.word) (Files.quoted kind);
  advance text;
  end_line text

let unit_ text =
  expect text "unit";
  let d = take_natural text in
  if Z.equal d Z.zero then refuse text "the unit is 0" "a positive number";
  end_line text;
  d

let end_ text =
  expect text "end";
  end_line text

(* Of a closed or open sum, from the unit on. *)
let sum_like ~is_open p q { Proved.open_chains; isolated_points; _ } text =
  let unit0 = unit_ text in
  let of_p = summand text "p" p in
  let of_q = summand text "q" q in
  expect text "sum";
  end_line text;
  let sum_inserted, vertices = points text open_chains in
  let isolated = Array.of_list (List.map Proved.homogeneous isolated_points) in
  let piece_with_tree text =
    let corners = corners (Array.length vertices) text in
    (corners, cells (if is_open then Some isolated else None) 0 text)
  in
  let pieces = lines text "pieces" piece_with_tree in
  let seams = if is_open then seams vertices isolated pieces text else [] in
  end_ text;
  let sum_pieces = List.map (fun (corners, tree) -> (List.map (Array.get vertices) corners, tree)) pieces in
  { Proved.unit0; of_p; of_q; sum_inserted; sum_pieces; seams }

let read kind name p q s =
  read_file name (fun text ->
      claim text kind;
      sum_like ~is_open:(kind = "open-sum") p q s text)
