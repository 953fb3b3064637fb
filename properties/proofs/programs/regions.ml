(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Regions, read from files by what is extracted from region_reader.v, and what is said of those that are invalid. *)

let as_string bytes =
  let text = Buffer.create 1024 in
  List.iter (fun byte -> Buffer.add_char text (Char.chr (Z.to_int byte))) bytes;
  Buffer.contents text

let refuse name { Proved.in_line; at_word; what } =
  let word = Files.quoted (as_string at_word) in
  let wrong, expected =
    match what with
    | Proved.NoKeyword -> (word, "POLYGON, MULTIPOLYGON or a number of vertices")
    | NotOpened -> (word, "'('")
    | NotContinued -> (word, "',' or ')'")
    | NoNumber -> (word, "an integer, a decimal or a fraction p/q")
    | NoDenominator -> (word, "a fraction p/q with q > 0")
    | LargeExponent ->
        let largest = Z.to_string Proved.largest_exponent in
        (word, Printf.sprintf "an exponent from -%s to %s" largest largest)
    | NotEnded -> (word, "the end of the text")
    | NoCount -> (word, Printf.sprintf "a number from 0 to %d" Files.longest_text)
    | NotClosed -> ("a ring is not closed", "its first vertex again at its end")
    | EdgesOverlap -> ("edges of a ring overlap at its leftmost vertex", "edges that meet only in ends")
    | FewVertices n -> (Printf.sprintf "a chain of %s vertices" (Z.to_string n), "at least 3")
    | NoOuterChain -> ("an outer chain of 0 vertices", "a bounded region")
    | NoSet -> (word, "a (MULTI)POLYGON, (MULTI)LINESTRING, (MULTI)POINT, GEOMETRYCOLLECTION or a number of vertices")
    | NoGeometry -> (word, "(MULTI)POLYGON, (MULTI)LINESTRING or (MULTI)POINT")
    | ShortLine -> ("a line string of less than 2 vertices", "at least 2")
    | LongWord -> (word, Printf.sprintf "words of at most %s bytes" (Z.to_string Proved.longest_word))
  in
  Files.refuse name (Z.to_int in_line) wrong expected

(* What is read from `start` on, and taken from the reading `at_end`. *)
let read_from start at_end file =
  Files.read file (fun name next_block ->
      let rec go_on = function
        | Proved.Inr failure -> refuse name failure
        | Inl reading as now -> (
            match next_block (Z.to_int reading.Proved.line_number) with
            | "" -> now
            | block ->
                let take now byte = Proved.take_byte now (Z.of_int (Char.code byte)) in
                go_on (String.fold_left take now block))
      in
      match at_end (go_on start) with
      | Proved.Inl read -> read
      | Inr failure -> refuse name failure)

(* Whether it is unbounded, and its chains. *)
let read_any = read_from (Proved.start true) Proved.at_end
let read file = snd (read_from (Proved.start false) Proved.at_end file)
