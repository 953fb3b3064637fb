(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The Minkowski sum of two regions, as a program: that what it returns is the sum is proved in sum_is_right.v. *)
From Coq Require Import QArith ZArith Bool List.
From Oplus Require Import specification checker direction winding_number homogeneous_points specification_bridge
  convolution_winding regions test_of_regions filling.
Import ListNotations.

Definition as_region (r : polygonal_region) : list (list vector) :=
  map (map (fun p => vector_of (homogeneous p))) r.

(* The first of the segments that starts there, and the others. *)
Fixpoint taken_from (v : vector) (l : list segment) : option (segment * list segment) :=
  match l with
  | [] => None
  | e :: rest =>
    if vector_dec (source e) v then Some (e, rest)
    else match taken_from v rest with None => None | Some (f, others) => Some (f, e :: others) end
  end.

(* From segment to segment until the start is reached again; the segments that are left. *)
Fixpoint walk (fuel : nat) (start here : vector) (l : list segment) : list vector * list segment :=
  match fuel with
  | O => ([], l)
  | S fewer =>
    match taken_from here l with
    | None => ([], l)
    | Some (e, rest) =>
      if vector_dec (target e) start then ([here], rest)
      else let (chain, others) := walk fewer start (target e) rest in (here :: chain, others)
    end
  end.

Fixpoint chains_of (fuel : nat) (l : list segment) : list (list vector) :=
  match fuel, l with
  | S fewer, e :: _ => let (chain, others) := walk (length l) (source e) (source e) l in chain :: chains_of fewer others
  | _, _ => []
  end.

Fixpoint without (e : segment) (l : list segment) : option (list segment) :=
  match l with
  | [] => None
  | f :: rest => if segment_dec e f then Some rest else option_map (cons f) (without e rest)
  end.

Fixpoint are_permuted (l m : list segment) : bool :=
  match l with
  | [] => match m with [] => true | _ => false end
  | e :: rest => match without e m with Some others => are_permuted rest others | None => false end
  end.

Definition chained (segments : list segment) : option (list (list vector)) :=
  let chains := chains_of (length segments) segments in
  if are_permuted (region_edges chains) segments then Some chains else None.

Definition minkowski_sum (p q : polygonal_region) : option polygonal_region :=
  let p := as_region p in
  let q := as_region q in
  if is_valid_region p && is_valid_region q then
    option_map (map (map as_point)) (chained (filled (convolution_segments p q)))
  else None.
