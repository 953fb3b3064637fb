(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* oplus-certified: whether a certificate shows what it claims. *)

let help =
  "Check a certificate of a Minkowski sum, closed or open, of placements or of a layout\n\
   Usage: oplus-certified [OPTIONS] [sum] P Q S CERTIFICATE\n\
  \       oplus-certified [OPTIONS] open-sum P Q S CERTIFICATE\n\
  \       oplus-certified [OPTIONS] nfp A B S CERTIFICATE\n\
  \       oplus-certified [OPTIONS] ifp A B F CERTIFICATE\n\
  \       oplus-certified [OPTIONS] layout CONTAINER PARTS CERTIFICATE\n\n\
   The checkers are proved in Coq. For what they certify:\n\
  \  sum       a point is in S if and only if it is the sum of a point of P and a point of Q\n\
  \  open-sum  the same of points inside P and points inside Q\n\
  \  nfp       B, moved by x, overlaps A if and only if x is in S\n\
  \  ifp       B, moved by x, is inside A if and only if x is in F\n\
  \  layout    no point is inside two parts, and all points of parts are points of the container\n\
   docs/certificates.md says what is proved, docs/believe.md what is trusted.\n\n\
   Arguments:\n\
  \  P Q A B                   regions in WKT, POLYGON, MULTIPOLYGON or EMPTY, or in .dat; numbers are\n\
  \                            integers, decimals (also 1.5e-3) and fractions p/q\n\
  \  S F                       the same; of all but `sum` also a GEOMETRYCOLLECTION of a region, of edges,\n\
  \                            LINESTRING, and of points, POINT\n\
  \  CONTAINER                 a region, or POLYGON EMPTY: only that parts do not overlap is claimed\n\
  \  PARTS                     regions in WKT, one a line, where they lie\n\
  \  CERTIFICATE               what oplus wrote: `oplus certify`, or a command with --certificate\n\n\
   Options:\n\
  \  -h,--help                 show this help\n\
  \  --version                 show the version\n\
  \  --trusted                 show what has to be believed, that is, what the proof is not about\n\
  \  --echo                    write the regions as they were read: their chains, and of each the vertices in\n\
  \                            order, numbered as in certificates\n\n\
   Example:\n\
  \  oplus sum p.wkt q.wkt -o s.wkt\n\
  \  oplus certify p.wkt q.wkt s.wkt -o certificate\n\
  \  oplus-certified p.wkt q.wkt s.wkt certificate\n\n\
   Exit codes:\n\
  \  0  certified\n\
  \  1  not certified: the claim may be wrong, or only the certificate\n\
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

(* Each reads its files, shows regions as they were read, and answers. *)

let sum show p q s certificate =
  let p = Regions.read p and q = Regions.read q and s = Regions.read s in
  show [ ("P", p); ("Q", q); ("S", s) ];
  let s = { Proved.open_chains = s; dangling_edges = []; isolated_points = [] } in
  Verdict.of_sum ~is_open:false p q s (Certificates.read "sum" certificate p q s)

let open_sum show p q s certificate =
  let p = Regions.read p and q = Regions.read q and s = Inputs.read_set s in
  show [ ("P", p); ("Q", q); ("S", s.open_chains) ];
  Verdict.of_sum ~is_open:true p q s (Certificates.read "open-sum" certificate p q s)

let no_fit show a b s certificate =
  let a = Regions.read a and b = Regions.read b and s = Inputs.read_set s in
  show [ ("A", a); ("-B", Proved.half_turned_region b); ("S", s.open_chains) ];
  Placement_verdict.of_no_fit a b s (Words.read_file certificate (Placements.no_fit a b s))

let inner_fit show a b f certificate =
  let a = Regions.read a and b = Regions.read b and f = Inputs.read_set f in
  show [ ("the outside of A", Proved.outside_of a b); ("-B", Proved.half_turned_region b); ("F", f.open_chains) ];
  let f = { Proved.fit_chains = f.open_chains; fit_edges = f.dangling_edges; fit_points = f.isolated_points } in
  Placement_verdict.of_inner_fit a b f (Words.read_file certificate (Placements.inner_fit a b f))

let layout show container parts certificate =
  let container = match Regions.read container with [] -> None | region -> Some region in
  let parts = Inputs.read_each parts in
  show (List.map (fun region -> ("a region", region)) (Proved.regions_of_layout container parts));
  Layout_verdict.of_certificate container parts (Words.read_file certificate (Layouts.certificate container parts))

let check is_echoed files =
  let show regions = if is_echoed then List.iter (fun (name, region) -> echo name region) regions in
  let code, verdict =
    match files with
    | [ "layout"; container; parts; certificate ] -> layout show container parts certificate
    | [ p; q; s; certificate ] | [ "sum"; p; q; s; certificate ] -> sum show p q s certificate
    | [ "open-sum"; p; q; s; certificate ] -> open_sum show p q s certificate
    | [ "nfp"; a; b; s; certificate ] -> no_fit show a b s certificate
    | [ "ifp"; a; b; f; certificate ] -> inner_fit show a b f certificate
    | _ ->
        Program.refuse
          (Printf.sprintf "%d files; expected P Q S CERTIFICATE, or a kind before them (see --help)"
             (List.length files))
  in
  print_endline verdict;
  code

let answer arguments =
  let options, files = List.partition (fun a -> String.length a > 1 && a.[0] = '-') arguments in
  match options with
  | _ when List.exists (fun o -> o = "-h" || o = "--help") options -> print_string help; 0
  | [ "--version" ] -> print_endline ("oplus-certified " ^ Version.version); 0
  | [ "--trusted" ] -> print_string Trusted.text; 0
  | [] | [ "--echo" ] -> check (options <> []) files
  | option :: _ -> Program.refuse (Printf.sprintf "the option '%s' is not known (see --help)" (String.escaped option))

let () = Program.run "oplus-certified" answer
