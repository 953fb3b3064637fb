(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* oplus-certified: whether a certificate shows that S is the Minkowski sum of P and Q. *)

let help =
  "Check a certificate that S is the Minkowski sum of P and Q\n\
   Usage: oplus-certified [OPTIONS] P Q S CERTIFICATE\n\n\
   The checker is proved in Coq: for what it certifies, a point is in S if and only if it is the sum of a\n\
   point of P and a point of Q. docs/certificates.md says what is proved, docs/believe.md what is trusted.\n\n\
   Arguments:\n\
  \  P Q S                     regions in WKT, POLYGON, MULTIPOLYGON or EMPTY, or in .dat; numbers are\n\
  \                            integers, decimals (also 1.5e-3) and fractions p/q\n\
  \  CERTIFICATE               what `oplus certify` writes\n\n\
   Options:\n\
  \  -h,--help                 show this help\n\
  \  --version                 show the version\n\
  \  --trusted                 show what has to be believed, that is, what the proof is not about\n\
  \  --echo                    write P, Q and S as they were read: their chains, and of each the vertices in\n\
  \                            order, numbered as in certificates\n\n\
   Example:\n\
  \  oplus sum p.wkt q.wkt -o s.wkt\n\
  \  oplus certify p.wkt q.wkt s.wkt -o certificate\n\
  \  oplus-certified p.wkt q.wkt s.wkt certificate\n\n\
   Exit codes:\n\
  \  0  certified\n\
  \  1  not certified: S may be wrong, or only the certificate\n\
  \  2  invalid input or usage, a file that cannot be read, output that cannot be written, or too\n\
  \     little memory\n"

let echo name region =
  Printf.printf "%s has %d chains\n" name (List.length region);
  let number = ref 0 in
  let vertex v =
    Printf.printf "%d: %s\n" !number (Verdict.described v);
    incr number
  in
  List.iter (fun chain -> Printf.printf "chain of %d vertices\n" (List.length chain); List.iter vertex chain) region

let check_sum ~is_open is_echoed p q s certificate =
  let p = Regions.read p and q = Regions.read q in
  let s =
    if is_open then Inputs.read_set s
    else { Proved.open_chains = Regions.read s; dangling_edges = []; isolated_points = [] }
  in
  if is_echoed then begin
    echo "P" p;
    echo "Q" q;
    echo "S" s.open_chains
  end;
  let kind = if is_open then "open-sum" else "sum" in
  let code, verdict = Verdict.of_sum ~is_open p q s (Certificates.read kind certificate p q s) in
  print_endline verdict;
  code

let check is_echoed = function
  | [ p; q; s; certificate ] | [ "sum"; p; q; s; certificate ] -> check_sum ~is_open:false is_echoed p q s certificate
  | [ "open-sum"; p; q; s; certificate ] -> check_sum ~is_open:true is_echoed p q s certificate
  | files -> Program.refuse (Printf.sprintf "%d files; expected P Q S CERTIFICATE (see --help)" (List.length files))

let answer arguments =
  let options, files = List.partition (fun a -> String.length a > 1 && a.[0] = '-') arguments in
  match options with
  | _ when List.exists (fun o -> o = "-h" || o = "--help") options -> print_string help; 0
  | [ "--version" ] -> print_endline ("oplus-certified " ^ Version.version); 0
  | [ "--trusted" ] -> print_string Trusted.text; 0
  | [] | [ "--echo" ] -> check (options <> []) files
  | option :: _ -> Program.refuse (Printf.sprintf "the option '%s' is not known (see --help)" (String.escaped option))

let () = Program.run "oplus-certified" answer
