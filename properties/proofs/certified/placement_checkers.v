(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The checkers of no-fits and inner fits (docs/certificates.md), as programs: where b, moved, overlaps a, and where
   it is inside a. Both ask the checker of open sums (checker.v) about -b, the first one with a, the second one with
   what is outside a in a square frame, and with a set of which the placements are left out. That they accept nothing
   but no-fits and inner fits is proved in certified_placements.v. *)
From Coq Require Import QArith Bool List.
From Oplus Require Import specification specification_bridge checker sum_program turned_chains inner_fit_program
  layout_checker.
Import ListNotations.

Definition half_turned_region (b : polygonal_region) : polygonal_region := as_polygonal (half_turned (as_region b)).

Definition check_no_fit (a b : polygonal_region) (s : open_region) (c : certificate) : option refusal :=
  check true a (half_turned_region b) s c.

Definition accepts_no_fit (a b : polygonal_region) (s : open_region) (c : certificate) : bool :=
  match check_no_fit a b s c with None => true | Some _ => false end.

(* What is outside a in the frame. *)
Definition outside_of (a b : polygonal_region) : polygonal_region :=
  as_polygonal (complement_in_frame (5 * size_of_regions [a; b]) (as_region a)).

(* What the open sum with -b has beside the boundary of the placements, and the certificate of the sum. *)
Record inner_fit_certificate := InnerFitCertificate { beyond : open_region; of_open_sum : certificate }.

Definition open_sum_around_placements (outer : open_region) (f : placements) : open_region :=
  OpenRegion (open_chains outer ++ map turned_chain (fit_chains f)) (dangling_edges outer ++ fit_edges f)
    (isolated_points outer ++ fit_points f).

(* Of each chain, edge and point, whether it starts in the square. *)
Definition start_in (k : Q) (s : open_region) : list bool :=
  map (starts_in k) (as_region (open_chains s)) ++
  map (fun e : edge => is_in_square k (as_vector (fst e))) (dangling_edges s) ++
  map (fun v => is_in_square k (as_vector v)) (isolated_points s).

Inductive inner_fit_refusal :=
| NoVertexOfB
| PlacementsNotInSquare
| BeyondInSquare (* what is to be beyond the square in which placements are *)
| OverlapOutside (t u : piece) (* pieces of the outside of a are not apart *)
| OverlapOfSum (t u : piece) (* pieces of the sum are not apart *)
| NotOpenSum (r : refusal).

Definition check_inner_fit (a b : polygonal_region) (f : placements) (c : inner_fit_certificate) :
  option inner_fit_refusal :=
  let k := (2 * size_of_regions [a; b])%Q in
  let sum := of_open_sum c in
  match concat b with
  | [] => Some NoVertexOfB
  | _ =>
    if negb (forallb (fun is_in => is_in) (start_in k (OpenRegion (fit_chains f) (fit_edges f) (fit_points f)))) then
      Some PlacementsNotInSquare
    else if negb (forallb negb (start_in k (beyond c))) then Some BeyondInSquare
    else
      match found_overlap (unit sum) (map piece_of (summand_pieces (of_p sum))) with
      | Some (t, u) => Some (OverlapOutside t u)
      | None =>
        match found_overlap (unit sum) (map (fun d => piece_of (fst d)) (sum_pieces sum)) with
        | Some (t, u) => Some (OverlapOfSum t u)
        | None =>
          match check true (outside_of a b) (half_turned_region b) (open_sum_around_placements (beyond c) f) sum with
          | Some r => Some (NotOpenSum r)
          | None => None
          end
        end
      end
  end.

Definition accepts_inner_fit (a b : polygonal_region) (f : placements) (c : inner_fit_certificate) : bool :=
  match check_inner_fit a b f c with None => true | Some _ => false end.
