(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* What is read beside regions: sets that have edges and points of their own, and lists of regions. *)

(* A region with edges and points of its own. *)
let read_set file = Regions.read_from Proved.start_of_set Proved.at_end_of_set file

(* The regions of a text that has one in each line; lines may be empty. *)
let read_each file =
  Files.read file (fun name next_block ->
      let start line =
        match Proved.start false with
        | Inl reading -> Proved.Inl { reading with line_number = line }
        | failure -> failure
      in
      let ended = function
        | Proved.Inl { Proved.stage_of = Start _; word = []; _ } -> []
        | now -> ( match Proved.at_end now with Inl (_, region) -> [ region ] | Inr failure -> Regions.refuse name failure)
      in
      let rec go_on line regions now =
        let take (line, regions, now) byte =
          if byte = '\n' then (line + 1, ended now @ regions, start (Z.of_int (line + 1)))
          else (line, regions, Proved.take_byte now (Z.of_int (Char.code byte)))
        in
        match (now, next_block line) with
        | Proved.Inr failure, _ -> Regions.refuse name failure
        | Inl _, "" -> List.rev (ended now @ regions)
        | Inl _, block ->
            let line, regions, now = String.fold_left take (line, regions, now) block in
            go_on line regions now
      in
      go_on 1 [] (start Z.one))
