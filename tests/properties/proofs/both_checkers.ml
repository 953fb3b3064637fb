(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Asks the checker of oplus-certified and the one that is extracted without any replacement, and fails unless they
   give one answer, which it writes. Usage: both_checkers KIND P Q S CERTIFICATE, KIND sum or open-sum *)
open Plain
open Plain_values

let hpoint (p : Proved.hpoint) = { px = integer p.px; py = integer p.py; pw = positive p.pw }
let polygon = coq_list hpoint
let line (l : Proved.line) = { la = integer l.la; lb = integer l.lb; lc = integer l.lc }
let numbers (i, j) = Pair (positive i, positive j)

let position = function
  | Proved.InSum (i, j) -> InSum (positive i, positive j)
  | Proved.OnEdge k -> OnEdge (positive k)
  | Proved.AtPoint k -> AtPoint (positive k)

let seam (s : Proved.seam) =
  let step ((x, of_x), next) = Pair (Pair (hpoint x, position of_x), position next) in
  { beginning = position s.beginning; later = coq_list step s.later }

let rec cells = function
  | Proved.SumsOf (i, j) -> SumsOf (positive i, positive j)
  | Proved.Cut (l, along, one, other) ->
      let along : seam option = match along with Some s -> Some (seam s) | None -> None in
      Cut (line l, along, cells one, cells other)

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
    seams = coq_list (fun (ends, along) -> Pair (numbers ends, seam along)) c.seams;
  }

let open_region (s : Proved.open_region) =
  let edge (a, b) = Pair (point a, point b) in
  {
    open_chains = region s.open_chains;
    dangling_edges = coq_list edge s.dangling_edges;
    isolated_points = coq_list point s.isolated_points;
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
  | Some DiagonalsOfS -> Some Proved.DiagonalsOfS
  | Some (SeamOutside n) -> Some (Proved.SeamOutside (natural n))
  | Some EdgesOfP -> Some Proved.EdgesOfP
  | Some EdgesOfQ -> Some Proved.EdgesOfQ
  | Some EdgesOfS -> Some Proved.EdgesOfS

let () =
  let p = Regions.read Sys.argv.(2) and q = Regions.read Sys.argv.(3) and s = Inputs.read_set Sys.argv.(4) in
  let is_open = Sys.argv.(1) = "open-sum" in
  let certificate = Certificates.read Sys.argv.(1) Sys.argv.(5) p q s in
  let fast : Proved.refusal Option.t = Proved.check is_open p q s certificate in
  let slow =
    refusal (check (if is_open then True else False) (region p) (region q) (open_region s) (plain certificate))
  in
  if fast <> slow then failwith "the checkers disagree";
  print_endline (if fast = None then "certified" else "not certified")
