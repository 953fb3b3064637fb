(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Regions as bytes, in WKT, as the programs write them, and sets that have edges and points of their own. *)
From Coq Require Import QArith ZArith Bool List String.
From Oplus Require Import specification region_reader.
Import ListNotations.

Open Scope Z_scope.

(** Numbers *)

(* The last one first. *)
Fixpoint decimal_digits (levels : nat) (n : Z) : list Z :=
  match levels with
  | O => []
  | S fewer => if n <? 10 then [n] else n mod 10 :: decimal_digits fewer (n / 10)
  end.

Definition digits_of_natural (n : Z) : list Z :=
  match n with Zpos p => decimal_digits (Pos.size_nat p) n | _ => [0] end.

Definition printed_digits (digits : list Z) : text := map (Z.add digit_0) (rev' digits).

(* How often the factor divides n, and what is left. *)
Fixpoint taken_out (levels : nat) (factor n : Z) : Z * Z :=
  match levels with
  | O => (0, n)
  | S fewer =>
    if n mod factor =? 0 then let (count, left) := taken_out fewer factor (n / factor) in (count + 1, left) else (0, n)
  end.

(* How many decimals the denominator's inverse has, if they end. *)
Definition decimals_of (d : positive) : Z :=
  let (twos, odd) := taken_out (Pos.size_nat d) 2 (Zpos d) in Z.max twos (fst (taken_out (Pos.size_nat d) 5 odd)).

Definition printed_decimal (n : Z) (decimals : positive) : text :=
  let digits := digits_of_natural n in
  let count := Pos.to_nat decimals in
  let all := digits ++ repeat 0 (S count - List.length digits) in
  printed_digits (skipn count all) ++ full_stop :: printed_digits (firstn count all).

(* In lowest terms: a decimal where there is one that ends, else p/q. *)
Definition printed_in_lowest_terms (q : Q) : text :=
  let n := Z.abs (Qnum q) in
  let sign := if Qnum q <? 0 then [sign_minus] else [] in
  let as_fraction := printed_digits (digits_of_natural n) ++
    match Qden q with xH => [] | _ => slash_sign :: printed_digits (digits_of_natural (Zpos (Qden q))) end in
  sign ++
  match decimals_of (Qden q) with
  | Zpos k =>
    let power := power_of_ten k in
    if power mod Zpos (Qden q) =? 0 then printed_decimal (n * (power / Zpos (Qden q))) k else as_fraction
  | _ => as_fraction
  end.

Definition printed_number (q : Q) : text := printed_in_lowest_terms (Qred q).

(** Regions *)

Fixpoint after_commas (items : list text) : text :=
  match items with
  | [] => []
  | item :: rest => comma_sign :: blank_sign :: item ++ after_commas rest
  end.

Definition printed_list {A : Type} (print : A -> text) (items : list A) : text :=
  match items with
  | [] => []
  | first :: rest => opening_sign :: print first ++ after_commas (map print rest) ++ [closing_sign]
  end.

Definition printed_point (p : point) : text := printed_number (x_of p) ++ blank_sign :: printed_number (y_of p).

Definition printed_ring (c : chain) : text :=
  printed_list printed_point (match c with [] => [] | first :: _ => c ++ [first] end).

(* An outer chain and its holes. *)
Definition printed_polygon (p : chain * list chain) : text := printed_list printed_ring (fst p :: snd p).

Definition printed_region (polygons : list (chain * list chain)) : text :=
  match polygons with
  | [] => bytes "POLYGON EMPTY"
  | [polygon] => bytes "POLYGON " ++ printed_polygon polygon
  | _ => bytes "MULTIPOLYGON " ++ printed_list printed_polygon polygons
  end.

Definition printed_polygons (polygons : list (chain * list chain)) : text := printed_region polygons ++ [new_line].

(* A region with edges and points of its own; without these, the region. *)
Definition printed_set (polygons : list (chain * list chain)) (edges : list edge) (points : list point) : text :=
  match edges, points with
  | [], [] => printed_polygons polygons
  | _, _ =>
    bytes "GEOMETRYCOLLECTION " ++ printed_list (fun item => item)
      (match polygons with [] => [] | _ => [printed_region polygons] end ++
       map (fun e => bytes "LINESTRING " ++ printed_list printed_point [fst e; snd e]) edges ++
       map (fun v => bytes "POINT " ++ printed_list printed_point [v]) points) ++ [new_line]
  end.
