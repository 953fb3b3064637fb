(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* oplus-proved: what is computed by programs that are proved. *)

let help =
  "Compute Minkowski sums, where regions fit, unions and complements by a program that is proved\n\
   Usage: oplus-proved COMMAND [OPTIONS] P Q\n\n\
   It is proved in Coq that a point is in the result if and only if it is the sum of a point of P and a point\n\
   of Q, or, of the other commands, a place as is said below. docs/proved.md has what is proved, and what is\n\
   trusted. `oplus` has the same commands and is faster.\n\n\
   Commands:\n\
  \  sum                       the Minkowski sum\n\
  \  nfp                       the no-fit polygon: all x where Q, moved by x, overlaps P\n\
  \  ifp                       the inner-fit polygon: all x where Q, moved by x, is inside P\n\
  \  erode                     the same without edges and points of its own\n\
  \  open                      all points of Q where it is moved inside P\n\
  \  close                     all x where Q, moved by x, is inside the sum, without edges and points of its own\n\
  \  union                     the union of P and Q\n\
  \  intersection              the closure of what is inside both\n\
  \  difference                the closure of what is inside P and not in Q\n\
  \  complement                all points outside P, and its boundary; P alone, which may be unbounded\n\n\
   Arguments:\n\
  \  P Q                       regions in WKT, POLYGON, MULTIPOLYGON or EMPTY, or in .dat; numbers are\n\
  \                            integers, decimals (also 1.5e-3) and fractions p/q; - is standard input\n\n\
   Options:\n\
  \  -h,--help                 show this help\n\
  \  --version                 show the version\n\
  \  --trusted                 show what has to be believed, that is, what the proofs are not about\n\
  \  -o,--output FILE          write the result there, in WKT, an unbounded one in .dat; by default to standard output\n\
  \  --open                    sum the regions' interiors: keeps dangling edges and isolated vertices\n\n\
   Example:\n\
  \  oplus-proved sum p.wkt q.wkt -o sum.wkt\n\n\
   Exit codes:\n\
  \  0  done\n\
  \  2  invalid input or usage, a file that cannot be read or written, or too little memory\n"

type arguments = { output : string option; is_open : bool; rest : string list }

let compute { output; is_open; rest } =
  let command, files = match rest with [] -> ("", []) | command :: files -> (command, files) in
  if is_open && command <> "sum" then Program.refuse "--open is an option of sum (see --help)";
  let files_are expected = Program.refuse (Printf.sprintf "%d files; expected %s (see --help)" (List.length files) expected) in
  let to_output () = Output.to_file (Option.value output ~default:"-") in
  match (command, Commands.operation command is_open, files) with
  | "", _, _ ->
      let names = List.map fst Commands.all @ [ "complement" ] in
      Program.refuse (Printf.sprintf "no command; expected %s (see --help)" (String.concat ", " names))
  | "complement", _, [ p ] ->
      let write = to_output () in
      write (Commands.complement p (Regions.read_any p))
  | "complement", _, _ -> files_are "P"
  | _, Some operation, [ p; q ] ->
      let write = to_output () in
      let p = Commands.valid p (Regions.read p) in
      let q = Commands.valid q (Regions.read q) in
      write (operation p q)
  | _, Some _, _ -> files_are "P Q"
  | _, None, _ -> Program.refuse (Printf.sprintf "the command '%s' is not known (see --help)" (String.escaped command))

let rec read arguments = function
  | [] -> { arguments with rest = List.rev arguments.rest }
  | ("-o" | "--output") :: rest when arguments.output <> None || rest = [] || rest = [ "" ] ->
      Program.refuse "-o takes the name of one file (see --help)"
  | ("-o" | "--output") :: file :: rest -> read { arguments with output = Some file } rest
  | "--open" :: rest -> read { arguments with is_open = true } rest
  | option :: _ when String.length option > 1 && option.[0] = '-' ->
      Program.refuse (Printf.sprintf "the option '%s' is not known (see --help)" (String.escaped option))
  | file :: rest -> read { arguments with rest = file :: arguments.rest } rest

let answer arguments =
  (match arguments with
   | _ when List.exists (fun a -> a = "-h" || a = "--help") arguments -> print_string help
   | [ "--version" ] -> print_endline ("oplus-proved " ^ Version.version)
   | [ "--trusted" ] -> print_string Trusted.text
   | _ -> compute (read { output = None; is_open = false; rest = [] } arguments));
  0

let () = Program.run "oplus-proved" answer
