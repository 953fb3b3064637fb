(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Asks the checker of oplus-certified and the one that is extracted without any replacement, and fails unless they
   give one answer, which it writes. Usage: both_checkers P Q S CERTIFICATE *)
open Plain
open Plain_values

let hpoint (p : Proved.hpoint) = { px = integer p.px; py = integer p.py; pw = positive p.pw }
let polygon = coq_list hpoint
let line (l : Proved.line) = { la = integer l.la; lb = integer l.lb; lc = integer l.lc }
let numbers (i, j) = Pair (positive i, positive j)

let rec cells = function
  | Proved.SumsOf (i, j) -> SumsOf (positive i, positive j)
  | Proved.Cut (l, one, other) -> Cut (line l, cells one, cells other)

let summand (c : Proved.summand_certificate) =
  {
    summand_inserted = coq_list polygon c.summand_inserted;
    summand_pieces = coq_list polygon c.summand_pieces;
    roots = coq_list positive c.roots;
    links = coq_list numbers c.links;
  }

let plain (c : Proved.certificate) =
  {
    unit0 = positive c.unit0;
    of_p = summand c.of_p;
    of_q = summand c.of_q;
    sum_inserted = coq_list polygon c.sum_inserted;
    sum_pieces = coq_list (fun (v, tree) -> Pair (polygon v, cells tree)) c.sum_pieces;
  }

let refusal : refusal option -> Proved.refusal Option.t = function
  | None -> None
  | Some PiecesOfP -> Some Proved.PiecesOfP
  | Some PiecesOfQ -> Some Proved.PiecesOfQ
  | Some PiecesOfS -> Some Proved.PiecesOfS
  | Some LinksOfP -> Some Proved.LinksOfP
  | Some LinksOfQ -> Some Proved.LinksOfQ
  | Some RootOutside -> Some Proved.RootOutside
  | Some (EdgeInside n) -> Some (Proved.EdgeInside (natural n))
  | Some (CellOutside n) -> Some (Proved.CellOutside (natural n))
  | Some EdgesOfP -> Some Proved.EdgesOfP
  | Some EdgesOfQ -> Some Proved.EdgesOfQ
  | Some EdgesOfS -> Some Proved.EdgesOfS

let () =
  let p = Regions.read Sys.argv.(1) and q = Regions.read Sys.argv.(2) and s = Regions.read Sys.argv.(3) in
  let certificate = Certificates.read Sys.argv.(4) p q s in
  let fast : Proved.refusal Option.t = Proved.check p q s certificate in
  let slow = refusal (check (region p) (region q) (region s) (plain certificate)) in
  if fast <> slow then failwith "the checkers disagree";
  print_endline (if fast = None then "certified" else "not certified")
