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

(* Vertices up to the end of the line. *)
let piece vertices text =
  let rec corners found =
    let word = text.word in
    let number = take_count text in
    if number >= Array.length vertices then
      refuse text ("there is no vertex " ^ word) (Printf.sprintf "one of %d vertices" (Array.length vertices));
    let found = vertices.(number) :: found in
    if text.word = "\n" then List.rev found else corners found
  in
  let polygon = corners [] in
  end_line text;
  polygon

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

let deepest_tree = 100_000

let rec cells depth text =
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
      end_line text;
      let one = cells (depth + 1) text in
      let other = cells (depth + 1) text in
      Proved.Cut ({ la; lb; lc }, None, one, other)
  | word -> refuse text (Files.quoted word) (Printf.sprintf "'in', or 'cut' in a tree of depth at most %d" deepest_tree)

let certificate p q s text =
  expect text "oplus";
  expect text "certificate";
  expect text "1";
  end_line text;
  expect text "unit";
  let unit_ = take_natural text in
  if Z.equal unit_ Z.zero then refuse text "the unit is 0" "a positive number";
  end_line text;
  let of_p = summand text "p" p in
  let of_q = summand text "q" q in
  expect text "sum";
  end_line text;
  let sum_inserted, vertices = points text s in
  let piece_with_tree text =
    let polygon = piece vertices text in
    (polygon, cells 0 text)
  in
  let sum_pieces = lines text "pieces" piece_with_tree in
  expect text "end";
  end_line text;
  { Proved.unit0 = unit_; of_p; of_q; sum_inserted; sum_pieces; seams = [] }

let read name p q s = read_file name (certificate p q s)
