(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The checker of certificates (docs/certificates.md), as a program over integers. That it accepts nothing but Minkowski
   sums is proved in certified_sums.v. Points are homogeneous: (X, Y, W) with W > 0 is the point (X / W, Y / W). *)
From Coq Require Import QArith ZArith Bool List Mergesort Orders FMapPositive.
From Oplus Require Import specification.
Import ListNotations.

Open Scope Z_scope.

(** Points and lines *)

Record hpoint := Hpoint { px : Z; py : Z; pw : positive }.

Definition homogeneous (p : point) : hpoint :=
  let x := Qred (x_of p) in
  let y := Qred (y_of p) in
  let g := Z.gcd (Zpos (Qden x)) (Zpos (Qden y)) in
  Hpoint (Qnum x * (Zpos (Qden y) / g)) (Qnum y * (Zpos (Qden x) / g)) (Z.to_pos (Zpos (Qden x) * (Zpos (Qden y) / g))).

Definition same_hpoint (a b : hpoint) : bool := (px a =? px b) && (py a =? py b) && (Pos.eqb (pw a) (pw b)).

Definition hplus (a b : hpoint) : hpoint :=
  if Pos.eqb (pw a) (pw b) then Hpoint (px a + px b) (py a + py b) (pw a)
  else Hpoint (px a * Zpos (pw b) + px b * Zpos (pw a)) (py a * Zpos (pw b) + py b * Zpos (pw a)) (pw a * pw b).

Definition negated (a : hpoint) : hpoint := Hpoint (- px a) (- py a) (pw a).

Definition hminus (a b : hpoint) : hpoint := hplus a (negated b).

(* The line a x + b y + c = 0; points of which the value is positive are on its left. *)
Record line := Line { la : Z; lb : Z; lc : Z }.

Definition value (l : line) (p : hpoint) : Z := la l * px p + lb l * py p + lc l * Zpos (pw p).

Definition line_through (p q : hpoint) : line :=
  Line (py p * Zpos (pw q) - Zpos (pw p) * py q) (Zpos (pw p) * px q - px p * Zpos (pw q)) (px p * py q - py p * px q).

Definition left_turn (a b c : hpoint) : Z := value (line_through a b) c.

(** Polygons *)

Definition polygon := list hpoint.

Definition hedge := (hpoint * hpoint)%type.

Definition sides (v : polygon) : list hedge :=
  match v with
  | [] => []
  | first :: rest => combine v (rest ++ [first])
  end.

(* All triangles of the first corner and a side turn left. *)
Fixpoint fan_turns_left (first : hpoint) (others : polygon) : bool :=
  match others with
  | b :: ((c :: _) as rest) => (0 <? left_turn first b c) && fan_turns_left first rest
  | _ => true
  end.

Definition has_a_fan (v : polygon) : bool :=
  match v with
  | first :: ((_ :: _ :: _) as others) => fan_turns_left first others
  | _ => false
  end.

(* A convex polygon with the lines along its sides. *)
Record piece := Piece { corners_of : polygon; side_lines : list line }.

Definition piece_of (v : polygon) : piece := Piece v (map (fun s => line_through (fst s) (snd s)) (sides v)).

Definition is_left_of_all (lines : list line) (x : hpoint) : bool := forallb (fun l => 0 <=? value l x) lines.

Definition is_in_piece (t : piece) (x : hpoint) : bool := is_left_of_all (side_lines t) x.

Definition is_convex (t : piece) : bool :=
  has_a_fan (corners_of t) && forallb (is_left_of_all (side_lines t)) (corners_of t).

(** Pieces cover a region *)

(* The edge from a to b, split at the given points in between. *)
Fixpoint split_edge (a b : hpoint) (inserted : list hpoint) : list hedge :=
  match inserted with
  | [] => [(a, b)]
  | m :: rest => (a, m) :: split_edge m b rest
  end.

(* m is on the segment from a to b. *)
Definition is_between (a m b : hpoint) : bool :=
  let x := fun p q => px p * Zpos (pw q) in
  let y := fun p q => py p * Zpos (pw q) in
  (left_turn a b m =? 0) &&
  ((x a m <=? x m a) && (x m b <=? x b m) || (x b m <=? x m b) && (x m a <=? x a m)) &&
  ((y a m <=? y m a) && (y m b <=? y b m) || (y b m <=? y m b) && (y m a <=? y a m)).

Fixpoint is_split (a b : hpoint) (inserted : list hpoint) : bool :=
  match inserted with
  | [] => true
  | m :: rest => is_between a m b && is_split m b rest
  end.

(* Edges to be counted: from the lower end to the upper one or back, of the region or of a piece. *)
Record entry := Entry { low : hpoint; high : hpoint; forward : bool; of_region : bool }.

Definition compare_hpoints (a b : hpoint) : comparison :=
  match px a ?= px b with
  | Eq => match py a ?= py b with
          | Eq => Pos.compare (pw a) (pw b)
          | other => other
          end
  | other => other
  end.

Definition entry_of (region : bool) (e : hedge) : entry :=
  match compare_hpoints (fst e) (snd e) with
  | Gt => Entry (snd e) (fst e) false region
  | _ => Entry (fst e) (snd e) true region
  end.

Definition compare_entries (a b : entry) : comparison :=
  match compare_hpoints (low a) (low b) with
  | Eq => compare_hpoints (high a) (high b)
  | other => other
  end.

(* Among entries of one edge: edges of pieces less edges of the region, by direction. *)
Definition count_of_entry (e : entry) : Z := if Bool.eqb (forward e) (of_region e) then -1 else 1.

(* Sorted entries: for each edge, the pieces have it in one direction more often than in the other exactly as often as the
   region has; and what the region has, a piece has. `count` and the two flags are of the edges like `e` so far. *)
Fixpoint are_balanced (e : entry) (count : Z) (in_region in_piece : bool) (rest : list entry) : bool :=
  match rest with
  | [] => (count =? 0) && (negb in_region || in_piece)
  | f :: more =>
    if same_hpoint (low e) (low f) && same_hpoint (high e) (high f)
    then are_balanced e (count + count_of_entry f) (in_region || of_region f) (in_piece || negb (of_region f)) more
    else (count =? 0) && (negb in_region || in_piece) &&
      are_balanced f (count_of_entry f) (of_region f) (negb (of_region f)) more
  end.

Module EntryOrder <: TotalLeBool.
  Definition t := entry.
  Definition leb (a b : entry) : bool := match compare_entries a b with Gt => false | _ => true end.
  Lemma leb_total : forall a b, leb a b = true \/ leb b a = true.
  Proof.
    assert (points : forall a b, compare_hpoints a b = CompOpp (compare_hpoints b a)).
    { intros a b. unfold compare_hpoints. rewrite (Z.compare_antisym (px b)), (Z.compare_antisym (py b)),
        (Pos.compare_antisym (pw b)). destruct (px b ?= px a), (py b ?= py a); reflexivity. }
    intros a b. unfold leb, compare_entries. rewrite (points (low a)), (points (high a)).
    destruct (compare_hpoints (low b) (low a)), (compare_hpoints (high b) (high a)); cbn; tauto.
  Qed.
End EntryOrder.
Module Sorted := Sort EntryOrder.

(* The edges of a region, each with the points that are put into it. *)
Definition hedges_of_region (r : polygonal_region) : list hedge :=
  map (fun e => (homogeneous (fst e), homogeneous (snd e))) (edges_of_region r).

Fixpoint with_inserted (es : list hedge) (inserted : list (list hpoint)) : list (hedge * list hpoint) :=
  match es, inserted with
  | [], _ => []
  | e :: more, [] => (e, []) :: with_inserted more []
  | e :: more, points :: rest => (e, points) :: with_inserted more rest
  end.

Definition are_a_region (es : list hedge) (inserted : list (list hpoint)) (pieces : list piece) : bool :=
  let split := with_inserted es inserted in
  let parts := flat_map (fun s => split_edge (fst (fst s)) (snd (fst s)) (snd s)) split in
  let entries := map (entry_of true) parts ++ map (entry_of false) (flat_map (fun t => sides (corners_of t)) pieces) in
  forallb is_convex pieces &&
  forallb (fun s => is_split (fst (fst s)) (snd (fst s)) (snd s)) split &&
  match Sorted.sort entries with
  | [] => true
  | e :: rest => are_balanced e (count_of_entry e) (of_region e) (negb (of_region e)) rest
  end.

(** Boxes, in units of 1 / D *)

Record bounding_box := Box { x_low : Z; x_high : Z; y_low : Z; y_high : Z }.

Section Unit.
  Variable D : positive.

  Definition rounded_down (x : Z) (w : positive) : Z := x * Zpos D / Zpos w.
  Definition rounded_up (x : Z) (w : positive) : Z := - (- x * Zpos D / Zpos w).

  Definition box_of_point (p : hpoint) : bounding_box :=
    Box (rounded_down (px p) (pw p)) (rounded_up (px p) (pw p)) (rounded_down (py p) (pw p)) (rounded_up (py p) (pw p)).

  Definition box_of_both (a b : bounding_box) : bounding_box :=
    Box (Z.min (x_low a) (x_low b)) (Z.max (x_high a) (x_high b))
      (Z.min (y_low a) (y_low b)) (Z.max (y_high a) (y_high b)).

  Definition box_of_points (first : hpoint) (rest : list hpoint) : bounding_box :=
    fold_left (fun b p => box_of_both b (box_of_point p)) rest (box_of_point first).

  Inductive tree :=
  | Leaf (b : bounding_box) (t : piece)
  | Node (b : bounding_box) (one other : tree).

  Definition box_of (t : tree) : bounding_box := match t with Leaf b _ => b | Node b _ _ => b end.

  Definition leaf_of (t : piece) : list tree :=
    match corners_of t with
    | [] => []
    | first :: rest => [Leaf (box_of_points first rest) t]
    end.

  Definition tree_of_both (a b : tree) : tree := Node (box_of_both (box_of a) (box_of b)) a b.

  (* Neighbours in pairs. *)
  Fixpoint paired (l : list tree) : list tree :=
    match l with
    | a :: b :: rest => tree_of_both a b :: paired rest
    | _ => l
    end.

  (* One tree, if the list is no longer than two to the power of `levels`. *)
  Fixpoint tree_of (levels : nat) (l : list tree) : list tree :=
    match levels, l with
    | S fewer, _ :: _ :: _ => tree_of fewer (paired l)
    | _, _ => l
    end.

  Definition trees_of (pieces : list piece) : list tree := let leaves := flat_map leaf_of pieces in tree_of (length leaves) leaves.

  (** An edge of the sum has all sums of two pieces on one side of a line *)

  (* Along the edge; if that is a point, the horizontal line through it. *)
  Definition line_along (e : hedge) : line :=
    let l := line_through (fst e) (snd e) in
    if (la l =? 0) && (lb l =? 0) then Line 0 (Zpos (pw (fst e))) (- py (fst e)) else l.

  Record placed_edge := PlacedEdge { from : hpoint; to : hpoint; edge_box : bounding_box; edge_line : line }.

  Definition placed_hedge (e : hedge) : placed_edge :=
    PlacedEdge (fst e) (snd e) (box_of_points (fst e) [snd e]) (line_along e).

  (* The box of the sum is beyond a side of the edge's box, or beyond the edge's line. *)
  Definition are_boxes_apart (e : placed_edge) (t u : bounding_box) : bool :=
    let x0 := x_low t + x_low u in
    let x1 := x_high t + x_high u in
    let y0 := y_low t + y_low u in
    let y1 := y_high t + y_high u in
    let b := edge_box e in
    let l := edge_line e in
    (x_high b <=? x0) || (x1 <=? x_low b) || (y_high b <=? y0) || (y1 <=? y_low b) ||
    let c := lc l * Zpos D in
    (0 <=? la l * (if 0 <=? la l then x0 else x1) + lb l * (if 0 <=? lb l then y0 else y1) + c) ||
    (la l * (if 0 <=? la l then x1 else x0) + lb l * (if 0 <=? lb l then y1 else y0) + c <=? 0).

  Definition are_all_sums (test : hpoint -> bool) (t u : piece) : bool :=
    forallb (fun a => forallb (fun b => test (hplus a b)) (corners_of u)) (corners_of t).

  (* The edge and the other piece are on different sides of the side's line: e - u is to the right of it. *)
  Definition is_beyond_a_side (e : placed_edge) (t u : piece) : bool :=
    existsb (fun l => forallb (fun b => (value l (hminus (from e) b) <=? 0) && (value l (hminus (to e) b) <=? 0)) (corners_of u))
      (side_lines t).

  Definition are_pieces_apart (e : placed_edge) (t u : piece) : bool :=
    are_all_sums (fun s => 0 <=? value (edge_line e) s) t u ||
    are_all_sums (fun s => value (edge_line e) s <=? 0) t u ||
    is_beyond_a_side e t u || is_beyond_a_side e u t.

  Definition is_larger (a b : bounding_box) : bool :=
    (x_high b - x_low b) + (y_high b - y_low b) <=? (x_high a - x_low a) + (y_high a - y_low a).

  Fixpoint are_trees_apart (e : placed_edge) (t : tree) : tree -> bool :=
    fix for_this (u : tree) : bool :=
      are_boxes_apart e (box_of t) (box_of u) ||
      match t, u with
      | Leaf _ a, Leaf _ b => are_pieces_apart e a b
      | Leaf _ _, Node _ u1 u2 => for_this u1 && for_this u2
      | Node _ t1 t2, Leaf _ _ => are_trees_apart e t1 u && are_trees_apart e t2 u
      | Node b t1 t2, Node c u1 u2 =>
        if is_larger b c then are_trees_apart e t1 u && are_trees_apart e t2 u else for_this u1 && for_this u2
      end.
End Unit.

(** Edges touch at most *)

(* The line has all of e on its right or on it, all of f on its left or on it, and some end off it. *)
Definition separates (l : line) (e f : hedge) : bool :=
  let a := value l (fst e) in
  let b := value l (snd e) in
  let c := value l (fst f) in
  let d := value l (snd f) in
  (a <=? 0) && (b <=? 0) && (0 <=? c) && (0 <=? d) && negb ((a =? 0) && (b =? 0) && (c =? 0) && (d =? 0)).

(* All of f is on one side of the line along e, and not all on it. *)
Definition is_on_one_side (e f : hedge) : bool :=
  let l := line_through (fst e) (snd e) in
  let c := value l (fst f) in
  let d := value l (snd f) in
  ((0 <=? c) && (0 <=? d) || (c <=? 0) && (d <=? 0)) && negb ((c =? 0) && (d =? 0)).

(* The line across the edge's end, with the edge on its right. *)
Definition line_across (e : hedge) : line :=
  let (a, b) := e in
  let x := px b * Zpos (pw a) - px a * Zpos (pw b) in
  let y := py b * Zpos (pw a) - py a * Zpos (pw b) in
  Line (x * Zpos (pw b)) (y * Zpos (pw b)) (- (x * px b + y * py b)).

Definition do_touch_at_most (e f : hedge) : bool :=
  is_on_one_side e f || is_on_one_side f e || separates (line_across e) e f || separates (line_across (snd e, fst e)) e f.

Definition are_disjoint (b c : bounding_box) : bool :=
  (x_high b <? x_low c) || (x_high c <? x_low b) || (y_high b <? y_low c) || (y_high c <? y_low b).

(* A piece of two corners, to be put into a tree. *)
Definition piece_of_edge (e : hedge) : piece := Piece [fst e; snd e] [].

(* Halved by places, along the longer side of the box of their (doubled) centres; a few as they come. *)
Definition centre_of (t : tree) : bounding_box :=
  let b := box_of t in
  let x := x_low b + x_high b in
  let y := y_low b + y_high b in
  Box x x y y.

Fixpoint trees_by_place (levels : nat) (l : list tree) : list tree :=
  match levels, l with
  | S fewer, first :: _ :: _ :: _ :: _ :: _ =>
    let c := fold_left (fun b t => box_of_both b (centre_of t)) l (centre_of first) in
    let x := x_low c + x_high c in
    let y := y_low c + y_high c in
    let is_before :=
      if y_high c - y_low c <=? x_high c - x_low c
      then fun t => let b := box_of t in 2 * (x_low b + x_high b) <? x
      else fun t => let b := box_of t in 2 * (y_low b + y_high b) <? y in
    match partition is_before l with
    | ([], _) => tree_of (length l) l
    | (one, other) => tree_of 1 (trees_by_place fewer one ++ trees_by_place fewer other)
    end
  | _, _ => tree_of (length l) l
  end.

(* Of one tree and another. *)
Fixpoint touch_each_other (t : tree) : tree -> bool :=
  fix for_this (u : tree) : bool :=
    are_disjoint (box_of t) (box_of u) ||
    match t, u with
    | Leaf _ e, Leaf _ f =>
      match corners_of e, corners_of f with
      | [a; b], [c; d] => do_touch_at_most (a, b) (c, d)
      | _, _ => false
      end
    | Leaf _ _, Node _ u1 u2 => for_this u1 && for_this u2
    | Node _ t1 t2, Leaf _ _ => touch_each_other t1 u && touch_each_other t2 u
    | Node b t1 t2, Node c u1 u2 =>
      if is_larger b c then touch_each_other t1 u && touch_each_other t2 u else for_this u1 && for_this u2
    end.

(* Of one tree. *)
Fixpoint touch_in_tree (t : tree) : bool :=
  match t with
  | Leaf _ _ => true
  | Node _ one other => touch_in_tree one && touch_in_tree other && touch_each_other one other
  end.

(* No edge crosses or overlaps another one. *)
Definition touch_at_most (D : positive) (es : list hedge) : bool :=
  match trees_by_place 64 (flat_map (leaf_of D) (map piece_of_edge es)) with
  | [] => true
  | [t] => touch_in_tree t
  | _ => false
  end.

(** Pieces are connected *)

Definition numbered := PositiveMap.t piece.

Fixpoint numbers_from {A} (n : positive) (l : list A) : PositiveMap.t A :=
  match l with
  | [] => PositiveMap.empty A
  | t :: rest => PositiveMap.add n t (numbers_from (Pos.succ n) rest)
  end.

Definition have_a_common_corner (t u : piece) : bool :=
  existsb (fun a => existsb (same_hpoint a) (corners_of u)) (corners_of t).

(* Each piece that is reached, with the root it is reached from. *)
Definition reached_pieces := PositiveMap.t piece.

Definition reach (pieces : numbered) (reached : reached_pieces) (link : positive * positive) : reached_pieces :=
  match PositiveMap.find (fst link) reached, PositiveMap.find (fst link) pieces, PositiveMap.find (snd link) pieces with
  | Some root, Some t, Some u => if have_a_common_corner t u then PositiveMap.add (snd link) root reached else reached
  | _, _, _ => reached
  end.

Definition start_at_root (pieces : numbered) (reached : reached_pieces) (root : positive) : reached_pieces :=
  match PositiveMap.find root pieces with
  | Some t => PositiveMap.add root t reached
  | None => reached
  end.

Definition all_reached (pieces : numbered) (roots : list positive) (links : list (positive * positive)) : reached_pieces :=
  fold_left (reach pieces) links (fold_left (start_at_root pieces) roots (PositiveMap.empty piece)).

Definition are_all_reached (pieces : numbered) (reached : reached_pieces) : bool :=
  forallb (fun entry => PositiveMap.mem (fst entry) reached) (PositiveMap.elements pieces).

(* Three times the centre of the first triangle, as a point. *)
Definition inner_point (t : piece) : option hpoint :=
  match corners_of t with
  | a :: b :: c :: _ => let s := hplus (hplus a b) c in Some (Hpoint (px s) (py s) (3 * pw s))
  | _ => None
  end.

Definition hcrossing (x : hpoint) (e : hedge) : Z :=
  let below a := py a * Zpos (pw x) <=? py x * Zpos (pw a) in
  match below (fst e), below (snd e) with
  | true, false => if left_turn (fst e) (snd e) x <=? 0 then 0 else 1
  | false, true => if 0 <=? left_turn (fst e) (snd e) x then 0 else -1
  | _, _ => 0
  end.

Definition hwinding (x : hpoint) (es : list hedge) : Z := fold_left (fun count e => count + hcrossing x e) es 0.

(* A piece of the tree contains x, of which this is the box. *)
Fixpoint is_in_tree (x : hpoint) (b : bounding_box) (t : tree) : bool :=
  let c := box_of t in
  (x_low c <=? x_high b) && (x_low b <=? x_high c) && (y_low c <=? y_high b) && (y_low b <=? y_high c) &&
  match t with
  | Leaf _ a => is_in_piece a x
  | Node _ one other => is_in_tree x b one || is_in_tree x b other
  end.

(* By a piece of s that contains it, otherwise by its winding number. *)
Definition is_in_region (D : positive) (es : list hedge) (s_trees : list tree) (x : hpoint) : bool :=
  existsb (is_in_tree x (box_of_point D x)) s_trees || negb (hwinding x es =? 0).

Definition are_roots_inside (is_in_s : hpoint -> bool) (p q : numbered) (p_roots q_roots : list positive) : bool :=
  forallb (fun i => forallb (fun j =>
    match PositiveMap.find i p, PositiveMap.find j q with
    | Some t, Some u =>
      match inner_point t, inner_point u with
      | Some a, Some b => is_in_s (hplus a b)
      | _, _ => false
      end
    | _, _ => true
    end) q_roots) p_roots.

(** Pieces of the sum are made of sums *)

Definition reduced (p : hpoint) : hpoint :=
  let g := Z.gcd (Z.gcd (px p) (py p)) (Zpos (pw p)) in
  if g =? 1 then p else Hpoint (px p / g) (py p / g) (Z.to_pos (Zpos (pw p) / g)).

(* Where the segment from a to b meets the line, if a's value is u and b's value is v, of which one is negative. *)
Definition meet (a b : hpoint) (u v : Z) : hpoint :=
  let m := Z.abs u in
  let n := Z.abs v in
  reduced (Hpoint (n * px a + m * px b) (n * py a + m * py b) (Z.to_pos (n * Zpos (pw a) + m * Zpos (pw b)))).

(* What the polygon's edge from a to b leaves of it on the left of the line: a, and where it crosses. *)
Definition kept (l : line) (e : hedge) : polygon :=
  let u := value l (fst e) in
  let v := value l (snd e) in
  (if 0 <=? u then [fst e] else []) ++
  (if (0 <? u) && (v <? 0) || (u <? 0) && (0 <? v) then [meet (fst e) (snd e) u v] else []).

Definition clipped (l : line) (v : polygon) : polygon := flat_map (kept l) (sides v).

(* A side of what is left that is along the line has what is left of the line on its left. *)
Definition is_ahead (l : line) (e : hedge) : bool :=
  negb ((value l (fst e) =? 0) && (value l (snd e) =? 0)) ||
  (0 <=? lb l * (px (snd e) * Zpos (pw (fst e)) - px (fst e) * Zpos (pw (snd e)))
    - la l * (py (snd e) * Zpos (pw (fst e)) - py (fst e) * Zpos (pw (snd e)))).

Definition opposite_line (l : line) : line := Line (- la l) (- lb l) (- lc l).

Definition do_cross (a b c d : hpoint) : bool :=
  (left_turn a b c * left_turn a b d <? 0) && (left_turn c d a * left_turn c d b <? 0).

(* t and x - u have a common point. *)
Definition is_sum_of_both (t u : piece) (x : hpoint) : bool :=
  existsb (fun a => is_in_piece u (hminus x a)) (corners_of t) ||
  existsb (fun b => is_in_piece t (hminus x b)) (corners_of u) ||
  existsb (fun s => existsb (fun r => do_cross (fst s) (snd s) (hminus x (fst r)) (hminus x (snd r))) (sides (corners_of u)))
    (sides (corners_of t)).

Definition first_moved_last (v : polygon) : polygon := match v with [] => [] | first :: rest => rest ++ [first] end.

(* One corner can be the first of a fan. *)
Fixpoint some_corner_has_a_fan (tries : nat) (v : polygon) : bool :=
  has_a_fan v || match tries with O => false | S fewer => some_corner_has_a_fan fewer (first_moved_last v) end.

(** Seams: of an open sum, also what is on cuts and between pieces is a sum, or left out *)

(* Both have common points, and the middle of all corners of what they have in common is inside both. *)
Definition common_corners (t u : piece) (x : hpoint) : polygon :=
  filter (fun a => is_in_piece u (hminus x a)) (corners_of t) ++
  filter (is_in_piece t) (map (hminus x) (corners_of u)) ++
  flat_map (fun s => flat_map (fun r =>
    let c := hminus x (fst r) in
    let d := hminus x (snd r) in
    if do_cross (fst s) (snd s) c d then [meet (fst s) (snd s) (left_turn c d (fst s)) (left_turn c d (snd s))] else [])
    (sides (corners_of u))) (sides (corners_of t)).

Definition is_strictly_in (t : piece) (x : hpoint) : bool := forallb (fun l => 0 <? value l x) (side_lines t).

(* x is a sum of a point inside t and one inside u. *)
Definition is_inner_sum (t u : piece) (x : hpoint) : bool :=
  match common_corners t u x with
  | [] => false
  | first :: rest =>
    let s := fold_left hplus rest first in
    let middle := Hpoint (px s) (py s) (Pos.of_succ_nat (length rest) * pw s) in
    is_strictly_in t middle && is_strictly_in u (hminus x middle)
  end.

(* In the sum of the insides of two pieces, on a dangling edge, or at an isolated point. *)
Inductive position :=
| InSum (i j : positive)
| OnEdge (k : positive)
| AtPoint (k : positive).

(* From one point to another: what is between the first two; and each point in between, where it is, and what is between
   it and the next. *)
Record seam := Seam { beginning : position; later : list (hpoint * position * position) }.

Section Seams.
  Variables (p q : numbered) (edges : PositiveMap.t hedge) (points : PositiveMap.t hpoint).

  Definition is_on_edge (k : positive) (x : hpoint) : bool :=
    match PositiveMap.find k edges with Some e => is_between (fst e) x (snd e) | None => false end.

  (* What is strictly between a and b, both on the line: if they are sums, and some sums are strictly to the left of the
     line and some to the right, what is between a and b is inside all these. *)
  Definition is_interval_in (l : line) (a b : hpoint) (c : position) : bool :=
    match c with
    | InSum i j =>
      match PositiveMap.find i p, PositiveMap.find j q with
      | Some t, Some u =>
        negb (are_all_sums (fun s => 0 <=? value l s) t u) && negb (are_all_sums (fun s => value l s <=? 0) t u) &&
        is_sum_of_both t u a && is_sum_of_both t u b
      | _, _ => false
      end
    | OnEdge k => is_on_edge k a && is_on_edge k b
    | AtPoint _ => false
    end.

  Definition is_point_in (x : hpoint) (c : position) : bool :=
    match c with
    | InSum i j =>
      match PositiveMap.find i p, PositiveMap.find j q with
      | Some t, Some u => is_inner_sum t u x
      | _, _ => false
      end
    | OnEdge k => is_on_edge k x
    | AtPoint k => match PositiveMap.find k points with Some v => is_between v x v | None => false end
    end.

  Fixpoint is_seam (l : line) (a b : hpoint) (c : position) (others : list (hpoint * position * position)) : bool :=
    match others with
    | [] => is_interval_in l a b c
    | (x, of_x, next) :: rest =>
      (value l x =? 0) && is_interval_in l a x c && is_point_in x of_x && is_seam l x b next rest
    end.

  (* v is what is on the left of a cut: from where its sides come to the line to where they leave it. *)
  Definition is_seam_of_cut (l : line) (v : polygon) (s : option seam) : bool :=
    match s, find (fun e => (0 <? value l (fst e)) && (value l (snd e) =? 0)) (sides v),
      find (fun e => (value l (fst e) =? 0) && (0 <? value l (snd e))) (sides v) with
    | Some s, Some e, Some f =>
      (0 <? left_turn (fst e) (snd e) (fst f)) && (0 <? left_turn (fst f) (snd f) (snd e)) &&
      is_seam l (snd e) (fst f) (beginning s) (later s)
    | _, _, _ => false
    end.

  Definition is_seam_of_edge (d : hedge * seam) : bool :=
    let (a, b) := fst d in
    is_seam (line_through a b) a b (beginning (snd d)) (later (snd d)).
End Seams.

(* Sorted entries: each edge is one of the region. *)
Fixpoint are_of_region (e : entry) (found : bool) (rest : list entry) : bool :=
  match rest with
  | [] => found
  | f :: more =>
    if same_hpoint (low e) (low f) && same_hpoint (high e) (high f)
    then are_of_region f (found || of_region f) more
    else found && are_of_region f (of_region f) more
  end.

(* Each side of a piece is part of an edge or one of the diagonals. *)
Definition have_all_sides (es : list hedge) (inserted : list (list hpoint)) (pieces : list piece)
  (diagonals : list hedge) : bool :=
  let parts := flat_map (fun s => split_edge (fst (fst s)) (snd (fst s)) (snd s)) (with_inserted es inserted) in
  let entries :=
    map (entry_of true) (parts ++ diagonals) ++
    map (entry_of false) (flat_map (fun t => sides (corners_of t)) pieces) in
  match Sorted.sort entries with
  | [] => true
  | e :: rest => are_of_region e (of_region e) rest
  end.

(* Ends of diagonals are vertices, and points that are put into edges. *)
Definition diagonals_of (es : list hedge) (inserted : list (list hpoint)) (seams : list (positive * positive * seam)) :
  list (hedge * seam) :=
  let vertices := numbers_from 1 (map fst es ++ flat_map snd (with_inserted es inserted)) in
  flat_map (fun d =>
    match PositiveMap.find (fst (fst d)) vertices, PositiveMap.find (snd (fst d)) vertices with
    | Some a, Some b => [((a, b), snd d)]
    | _, _ => []
    end) seams.

(** Cells *)

(* A cut of an open sum has a seam. *)
Inductive cells :=
| SumsOf (i j : positive)
| Cut (l : line) (along : option seam) (one other : cells).

Fixpoint are_sums (is_seam : line -> polygon -> option seam -> bool) (p q : numbered) (v : polygon) (c : cells) : bool :=
  match c with
  | SumsOf i j =>
    match PositiveMap.find i p, PositiveMap.find j q with
    | Some t, Some u => some_corner_has_a_fan (length v) v && forallb (is_sum_of_both t u) v
    | _, _ => false
    end
  | Cut l along one other =>
    let v1 := clipped l v in
    let v2 := clipped (opposite_line l) v in
    forallb (is_ahead l) (sides v1) && forallb (is_ahead (opposite_line l)) (sides v2) && is_seam l v1 along &&
    are_sums is_seam p q v1 one && are_sums is_seam p q v2 other
  end.

(** The whole *)

Record summand_certificate := SummandCertificate {
  summand_inserted : list (list hpoint);
  summand_pieces : list polygon;
  roots : list positive;
  links : list (positive * positive)
}.

Record certificate := Certificate {
  unit : positive;
  of_p : summand_certificate;
  of_q : summand_certificate;
  sum_inserted : list (list hpoint);
  sum_pieces : list (polygon * cells);
  seams : list (positive * positive * seam) (* of an open sum: each diagonal, by the numbers of its ends *)
}.

(* Where a certificate fails. *)
Inductive refusal :=
| PiecesOfP | PiecesOfQ | PiecesOfS (* are not convex, or not the region *)
| LinksOfP | LinksOfQ (* do not reach all pieces *)
| RootOutside (* a sum of two inner points of pieces is not in s *)
| EdgeInside (n : N) (* edge number n of s, dangling edge or point after these, is not beside the sum of two pieces *)
| CellOutside (n : N) (* piece number n of s is not made of sums *)
| DiagonalsOfS (* have no seams *)
| SeamOutside (n : N) (* seam number n is not one *)
| EdgesOfP | EdgesOfQ | EdgesOfS. (* cross or overlap *)

(* The number of the first that fails. *)
Fixpoint first_failure {A} (test : A -> bool) (n : N) (l : list A) : option N :=
  match l with
  | [] => None
  | a :: rest => if test a then first_failure test (N.succ n) rest else Some n
  end.

Definition hedge_of (e : edge) : hedge := (homogeneous (fst e), homogeneous (snd e)).

(* An open sum is without its edges and points; a closed one has none. *)
Definition check (is_open : bool) (p q : polygonal_region) (s : open_region) (c : certificate) : option refusal :=
  let p_pieces := map piece_of (summand_pieces (of_p c)) in
  let q_pieces := map piece_of (summand_pieces (of_q c)) in
  let p_edges := hedges_of_region p in
  let q_edges := hedges_of_region q in
  let s_edges := hedges_of_region (open_chains s) in
  let s_pieces := map (fun d => piece_of (fst d)) (sum_pieces c) in
  let dangling := map hedge_of (dangling_edges s) in
  let isolated := map homogeneous (isolated_points s) in
  let p_numbered := numbers_from 1 p_pieces in
  let q_numbered := numbers_from 1 q_pieces in
  let edges := numbers_from 1 dangling in
  let points := numbers_from 1 isolated in
  let is_seam_of_its_cut :=
    if is_open then is_seam_of_cut p_numbered q_numbered edges points else fun _ _ _ => true in
  let diagonals := if is_open then diagonals_of s_edges (sum_inserted c) (seams c) else [] in
  if negb (are_a_region p_edges (summand_inserted (of_p c)) p_pieces) then Some PiecesOfP
  else if negb (are_a_region q_edges (summand_inserted (of_q c)) q_pieces) then Some PiecesOfQ
  else if negb (are_a_region s_edges (sum_inserted c) s_pieces) then Some PiecesOfS
  else if is_open && negb (have_all_sides s_edges (sum_inserted c) s_pieces (map fst diagonals)) then Some DiagonalsOfS
  else if negb (are_all_reached p_numbered (all_reached p_numbered (roots (of_p c)) (links (of_p c)))) then Some LinksOfP
  else if negb (are_all_reached q_numbered (all_reached q_numbered (roots (of_q c)) (links (of_q c)))) then Some LinksOfQ
  else if negb (are_roots_inside
      (is_in_region (unit c) s_edges (trees_of (unit c) s_pieces)) p_numbered q_numbered (roots (of_p c)) (roots (of_q c))) then Some RootOutside
  else
    let D := unit c in
    let p_trees := trees_of D p_pieces in
    let q_trees := trees_of D q_pieces in
    let beside e :=
      let placed_e := placed_hedge D e in
      forallb (fun t => forallb (are_trees_apart D placed_e t) q_trees) p_trees in
    match first_failure beside 0 (s_edges ++ dangling ++ map (fun v => (v, v)) isolated) with
    | Some n => Some (EdgeInside n)
    | None =>
      match first_failure (fun s => are_sums is_seam_of_its_cut p_numbered q_numbered (fst s) (snd s)) 0 (sum_pieces c) with
      | Some n => Some (CellOutside n)
      | None =>
        match first_failure (is_seam_of_edge p_numbered q_numbered edges points) 0 diagonals with
        | Some n => Some (SeamOutside n)
        | None =>
          if negb (touch_at_most D p_edges) then Some EdgesOfP
          else if negb (touch_at_most D q_edges) then Some EdgesOfQ
          else if negb (touch_at_most D s_edges) then Some EdgesOfS
          else None
        end
      end
    end.

Definition accepts (p q s : polygonal_region) (c : certificate) : bool :=
  match check false p q (OpenRegion s [] []) c with None => true | Some _ => false end.

Definition accepts_open (p q : polygonal_region) (s : open_region) (c : certificate) : bool :=
  match check true p q s c with None => true | Some _ => false end.
