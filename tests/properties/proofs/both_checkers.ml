(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Asks the checker of oplus-certified and the one that is extracted without any replacement, and fails unless they
   give one answer, which it writes. Usage: both_checkers P Q S CERTIFICATE *)
module Integer = Z
open Plain_checker

let rec positive n =
  if Integer.equal n Integer.one then XH
  else
    let half = positive (Integer.shift_right n 1) in
    if Integer.is_odd n then XI half else XO half

let integer n = match Integer.sign n with 0 -> Z0 | 1 -> Zpos (positive n) | _ -> Zneg (positive (Integer.neg n))
let rec coq_list f = function [] -> Nil | a :: rest -> Cons (f a, coq_list f rest)
let rational (q : Checker.q) = { qnum = integer q.qnum; qden = positive q.qden }
let point (p : Checker.point) = { x_of = rational p.x_of; y_of = rational p.y_of }
let hpoint (p : Checker.hpoint) = { px = integer p.px; py = integer p.py; pw = positive p.pw }
let polygon = coq_list hpoint
let line (l : Checker.line) = { la = integer l.la; lb = integer l.lb; lc = integer l.lc }
let numbers (i, j) = Pair (positive i, positive j)

let rec cells = function
  | Checker.SumsOf (i, j) -> SumsOf (positive i, positive j)
  | Checker.Cut (l, one, other) -> Cut (line l, cells one, cells other)

let summand (c : Checker.summand_certificate) =
  {
    summand_inserted = coq_list polygon c.summand_inserted;
    summand_pieces = coq_list polygon c.summand_pieces;
    roots = coq_list positive c.roots;
    links = coq_list numbers c.links;
  }

let plain (c : Checker.certificate) =
  {
    unit0 = positive c.unit0;
    of_p = summand c.of_p;
    of_q = summand c.of_q;
    sum_inserted = coq_list polygon c.sum_inserted;
    sum_pieces = coq_list (fun (v, tree) -> Pair (polygon v, cells tree)) c.sum_pieces;
  }

let rec value = function XH -> Integer.one | XO p -> Integer.shift_left (value p) 1 | XI p -> Integer.succ (Integer.shift_left (value p) 1)
let natural = function N0 -> Integer.zero | Npos p -> value p

let refusal : refusal option -> Checker.refusal Option.t = function
  | None -> None
  | Some PiecesOfP -> Some Checker.PiecesOfP
  | Some PiecesOfQ -> Some Checker.PiecesOfQ
  | Some PiecesOfS -> Some Checker.PiecesOfS
  | Some LinksOfP -> Some Checker.LinksOfP
  | Some LinksOfQ -> Some Checker.LinksOfQ
  | Some RootOutside -> Some Checker.RootOutside
  | Some (EdgeInside n) -> Some (Checker.EdgeInside (natural n))
  | Some (CellOutside n) -> Some (Checker.CellOutside (natural n))

let () =
  let p = Regions.read Sys.argv.(1) and q = Regions.read Sys.argv.(2) and s = Regions.read Sys.argv.(3) in
  let certificate = Certificates.read Sys.argv.(4) p q s in
  let specified r = coq_list (coq_list point) (Regions.specified r) in
  let fast : Checker.refusal Option.t = Checker.check (Regions.specified p) (Regions.specified q) (Regions.specified s) certificate in
  let slow = refusal (check (specified p) (specified q) (specified s) (plain certificate)) in
  if fast <> slow then failwith "the checkers disagree";
  print_endline (if fast = None then "certified" else "not certified")
