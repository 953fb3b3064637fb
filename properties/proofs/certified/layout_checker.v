(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The checker of layouts (docs/certificates.md), as a program over integers: parts lie in a container and do not
   overlap. All regions, the parts and what is outside the container, are cut into convex pieces, and each two pieces
   have a line between them. That it accepts nothing but layouts is proved in certified_layouts.v. *)
From Coq Require Import QArith ZArith Bool List.
From Oplus Require Import specification checker sum_program inner_fit_program.
Import ListNotations.

Open Scope Z_scope.

(** Pieces with lines between them *)

(* All of u is to the right of a side of t, or on its line. *)
Definition is_right_of_a_side (t u : piece) : bool :=
  existsb (fun l => forallb (fun b => value l b <=? 0) (corners_of u)) (side_lines t).

Definition are_separate (t u : piece) : bool := is_right_of_a_side t u || is_right_of_a_side u t.

(* They may touch. *)
Definition are_boxes_separate (b c : bounding_box) : bool :=
  (x_high b <=? x_low c) || (x_high c <=? x_low b) || (y_high b <=? y_low c) || (y_high c <=? y_low b).

(* A piece of one tree and one of another that have no line between them, if there are any. *)
Fixpoint overlap_of_trees (t : tree) : tree -> option (piece * piece) :=
  fix for_this (u : tree) : option (piece * piece) :=
    if are_boxes_separate (box_of t) (box_of u) then None
    else
      match t, u with
      | Leaf _ a, Leaf _ b => if are_separate a b then None else Some (a, b)
      | Leaf _ _, Node _ u1 u2 => match for_this u1 with None => for_this u2 | found => found end
      | Node _ t1 t2, Leaf _ _ => match overlap_of_trees t1 u with None => overlap_of_trees t2 u | found => found end
      | Node b t1 t2, Node c u1 u2 =>
        if is_larger b c then match overlap_of_trees t1 u with None => overlap_of_trees t2 u | found => found end
        else match for_this u1 with None => for_this u2 | found => found end
      end.

(* Two pieces of one tree. *)
Fixpoint overlap_in_tree (t : tree) : option (piece * piece) :=
  match t with
  | Leaf _ _ => None
  | Node _ one other =>
    match overlap_in_tree one with
    | None => match overlap_in_tree other with None => overlap_of_trees one other | found => found end
    | found => found
    end
  end.

(* Two of the pieces. *)
Definition found_overlap (D : positive) (pieces : list piece) : option (piece * piece) :=
  match trees_by_place 64 (flat_map (leaf_of D) pieces) with
  | [] => None
  | t :: rest => overlap_in_tree (fold_left tree_of_both rest t)
  end.

(** Regions with pieces *)

Record region_certificate := RegionCertificate {
  inserted_points : list (list hpoint);
  convex_pieces : list polygon
}.

Definition pieces_of_certificate (c : region_certificate) : list piece := map piece_of (convex_pieces c).

Definition is_certified (r : polygonal_region * region_certificate) : bool :=
  are_a_region (hedges_of_region (fst r)) (inserted_points (snd r)) (pieces_of_certificate (snd r)).

(* A region for which there is no certificate is taken to have no pieces. *)
Fixpoint with_certificates (regions : list polygonal_region) (certificates : list region_certificate) :
  list (polygonal_region * region_certificate) :=
  match regions, certificates with
  | [], _ => []
  | r :: more, [] => (r, RegionCertificate [] []) :: with_certificates more []
  | r :: more, c :: rest => (r, c) :: with_certificates more rest
  end.

(** The whole *)

(* Certificates of what is outside the container, if there is one, and of the parts. *)
Record layout_certificate := LayoutCertificate { layout_unit : positive; of_regions : list region_certificate }.

Inductive layout_refusal :=
| NotPieces (n : N) (* the pieces of this region are not convex, or not the region *)
| NotSeparate (t u : piece). (* no side of one has the other one to its right *)

(* No coordinate of a vertex is larger. *)
Definition size_of_regions (regions : list polygonal_region) : Q :=
  size_of (flat_map (fun r => concat (as_region r)) regions).

(* What is outside the container, in a frame around all vertices; and the parts. *)
Definition regions_of_layout (container : option polygonal_region) (parts : list polygonal_region) :
  list polygonal_region :=
  match container with
  | None => parts
  | Some c => as_polygonal (complement_in_frame (2 * size_of_regions (c :: parts))%Q (as_region c)) :: parts
  end.

Definition check_layout (container : option polygonal_region) (parts : list polygonal_region)
  (c : layout_certificate) : option layout_refusal :=
  let regions := with_certificates (regions_of_layout container parts) (of_regions c) in
  match first_failure is_certified 0 regions with
  | Some n => Some (NotPieces n)
  | None =>
    match found_overlap (layout_unit c) (flat_map (fun r => pieces_of_certificate (snd r)) regions) with
    | Some (t, u) => Some (NotSeparate t u)
    | None => None
    end
  end.

Definition accepts_layout (container : option polygonal_region) (parts : list polygonal_region)
  (c : layout_certificate) : bool :=
  match check_layout container parts c with None => true | Some _ => false end.
