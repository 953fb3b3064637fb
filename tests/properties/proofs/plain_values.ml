(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Values of a program in the types of Plain, in which nothing is replaced, and back. *)
module Integer = Z
open Plain

let rec positive n =
  if Integer.equal n Integer.one then XH
  else
    let half = positive (Integer.shift_right n 1) in
    if Integer.is_odd n then XI half else XO half

let integer n = match Integer.sign n with 0 -> Z0 | 1 -> Zpos (positive n) | _ -> Zneg (positive (Integer.neg n))
let rec coq_list f = function [] -> Nil | a :: rest -> Cons (f a, coq_list f rest)
let rational (q : Proved.q) = { qnum = integer q.qnum; qden = positive q.qden }
let point (p : Proved.point) = { x_of = rational p.x_of; y_of = rational p.y_of }
let region = coq_list (coq_list point)

let rec value = function
  | XH -> Integer.one
  | XO p -> Integer.shift_left (value p) 1
  | XI p -> Integer.succ (Integer.shift_left (value p) 1)

let whole = function Z0 -> Integer.zero | Zpos p -> value p | Zneg p -> Integer.neg (value p)
let natural = function N0 -> Integer.zero | Npos p -> value p
let rec list_of f = function Nil -> [] | Cons (a, rest) -> f a :: list_of f rest
let number q : Proved.q = { qnum = whole q.qnum; qden = value q.qden }
let point_of p : Proved.point = { x_of = number p.x_of; y_of = number p.y_of }
