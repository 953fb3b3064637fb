(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* oplus-proved: what is computed by programs that are proved. *)

let help =
  "Compute a Minkowski sum by a program that is proved\n\
   Usage: oplus-proved COMMAND [OPTIONS] P Q\n\n\
   The program is proved in Coq: a point is in the result if and only if it is the sum of a point of P and a\n\
   point of Q. docs/proved.md says what is proved, and what is trusted. It is slow; `oplus sum` is fast.\n\n\
   Commands:\n\
  \  sum                       the Minkowski sum\n\n\
   Arguments:\n\
  \  P Q                       regions in WKT, POLYGON, MULTIPOLYGON or EMPTY, or in .dat; numbers are\n\
  \                            integers, decimals (also 1.5e-3) and fractions p/q; - is standard input\n\n\
   Options:\n\
  \  -h,--help                 show this help\n\
  \  --version                 show the version\n\
  \  --trusted                 show what one has to believe: what the proofs are not about\n\
  \  -o,--output FILE          write the result there, in WKT; by default to standard output\n\n\
   Example:\n\
  \  oplus-proved sum p.wkt q.wkt -o sum.wkt\n\n\
   Exit codes:\n\
  \  0  done\n\
  \  2  invalid input or usage, a file that cannot be read or written, or too little memory\n"

let valid name =
  let region = Regions.specified (Regions.read name) in
  if Proved.can_be_summed region then region
  else
    Program.refuse
      (String.escaped name
       ^ ": not a valid region: edges may meet in vertices only, and holes are inside their outer chain, outside each \
          other (`oplus sum` says where it is wrong)")

let sum p q = Text.wkt (Proved.proved_sum p q)

let commands = [ ("sum", sum) ]

let compute command output files =
  match (List.assoc_opt command commands, files) with
  | None, _ -> Program.refuse (Printf.sprintf "the command '%s' is not known (see --help)" (String.escaped command))
  | Some operation, [ p; q ] ->
      let write = Output.to_file output in
      let p = valid p in
      let q = valid q in
      write (operation p q)
  | Some _, _ -> Program.refuse (Printf.sprintf "%d files; expected P Q (see --help)" (List.length files))

type arguments = { output : string option; rest : string list }

let rec read arguments = function
  | [] -> { arguments with rest = List.rev arguments.rest }
  | ("-o" | "--output") :: rest when arguments.output <> None || rest = [] || rest = [ "" ] ->
      Program.refuse "-o takes the name of one file (see --help)"
  | ("-o" | "--output") :: file :: rest -> read { arguments with output = Some file } rest
  | option :: _ when String.length option > 1 && option.[0] = '-' ->
      Program.refuse (Printf.sprintf "the option '%s' is not known (see --help)" (String.escaped option))
  | file :: rest -> read { arguments with rest = file :: arguments.rest } rest

let answer arguments =
  (match arguments with
   | _ when List.exists (fun a -> a = "-h" || a = "--help") arguments -> print_string help
   | [ "--version" ] -> print_endline ("oplus-proved " ^ Version.version)
   | [ "--trusted" ] -> print_string Trusted.text
   | _ -> (
       match read { output = None; rest = [] } arguments with
       | { rest = []; _ } -> Program.refuse "no command; expected sum (see --help)"
       | { output; rest = command :: files } -> compute command (Option.value output ~default:"-") files));
  0

let () = Program.run "oplus-proved" answer
