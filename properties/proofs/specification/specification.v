(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* What a Minkowski sum is, certified or proved: all that a reader must believe. Nothing else is needed to understand
   the theorem of certified_sums.v, accepts_only_sums accepts, and those of proved/. docs/believe.md explains each line. *)
From Coq Require Import QArith List.
Import ListNotations.

Open Scope Q_scope.

(* Coordinates are rational numbers. *)
Record point := Point { x_of : Q; y_of : Q }.

Definition equal_points (a b : point) : Prop := x_of a == x_of b /\ y_of a == y_of b.

Definition sum_of_points (a b : point) : point := Point (x_of a + x_of b) (y_of a + y_of b).

(* A region is given by closed chains, each by its vertices in order: outer chains counterclockwise, holes clockwise. *)
Definition chain := list point.
Definition polygonal_region := list chain.

(* The edges of a chain, the last of which leads back to the first vertex. *)
Definition edge := (point * point)%type.

Definition edges_of_chain (c : chain) : list edge :=
  match c with
  | [] => []
  | first :: rest => combine c (rest ++ [first])
  end.

Definition edges_of_region (r : polygonal_region) : list edge := flat_map edges_of_chain r.

(* The point divides the edge in some ratio, ends included. *)
Definition is_on (x : point) (e : edge) : Prop :=
  exists t, 0 <= t <= 1 /\
    equal_points x (Point ((1 - t) * x_of (fst e) + t * x_of (snd e)) ((1 - t) * y_of (fst e) + t * y_of (snd e))).

(* Positive if c is to the left of the line from a to b, negative if it is to the right. *)
Definition turn (a b c : point) : Q :=
  (x_of b - x_of a) * (y_of c - y_of a) - (y_of b - y_of a) * (x_of c - x_of a).

(* What an edge adds to the winding number of x: 1 if it crosses the ray from x to the right upwards, -1 if it does so
   downwards, 0 otherwise. An end at the height of x counts as below it. *)
Definition crossing (x : point) (e : edge) : Z :=
  let below (a : point) := Qle_bool (y_of a) (y_of x) in
  let side := turn (fst e) (snd e) x in
  match below (fst e), below (snd e) with
  | true, false => if Qle_bool side 0 then 0 else 1
  | false, true => if Qle_bool 0 side then 0 else -1
  | _, _ => 0
  end.

Definition region_winding_number (x : point) (r : polygonal_region) : Z := fold_right Z.add 0%Z (map (crossing x) (edges_of_region r)).

(* A region consists of its edges and of what they go round. *)
Definition member (x : point) (r : polygonal_region) : Prop :=
  (exists e, In e (edges_of_region r) /\ is_on x e) \/ region_winding_number x r <> 0%Z.

(* s is the Minkowski sum of p and q. *)
Definition is_minkowski_sum (p q s : polygonal_region) : Prop :=
  forall x, member x s <-> exists a b, member a p /\ member b q /\ equal_points x (sum_of_points a b).

(* Inside a region, and not on its boundary. *)
Definition is_inner_point (x : point) (r : polygonal_region) : Prop :=
  region_winding_number x r <> 0%Z /\ forall e, In e (edges_of_region r) -> ~ is_on x e.

(* An open set: what chains go round, without the chains, without some edges, and without some points. *)
Record open_region := OpenRegion {
  open_chains : polygonal_region; dangling_edges : list edge; isolated_points : list point }.

Definition open_member (x : point) (s : open_region) : Prop :=
  is_inner_point x (open_chains s) /\ (forall e, In e (dangling_edges s) -> ~ is_on x e) /\
  (forall v, In v (isolated_points s) -> ~ equal_points x v).

(* s is the open Minkowski sum of p and q: all sums of points inside them. *)
Definition is_open_sum (p q : polygonal_region) (s : open_region) : Prop :=
  forall x, open_member x s <->
    exists a b, is_inner_point a p /\ is_inner_point b q /\ equal_points x (sum_of_points a b).

(* b, moved by x, overlaps a for these x and no others: a point is inside both. *)
Definition is_no_fit (a b : polygonal_region) (s : open_region) : Prop :=
  forall x, open_member x s <->
    exists y z, is_inner_point y a /\ is_inner_point z b /\ equal_points y (sum_of_points x z).

(* Where a region fits: chains with what they go round, edges, and points. *)
Record placements := Placements {
  fit_chains : polygonal_region; fit_edges : list edge; fit_points : list point }.

Definition fits (x : point) (f : placements) : Prop :=
  member x (fit_chains f) \/ (exists e, In e (fit_edges f) /\ is_on x e) \/
  (exists v, In v (fit_points f) /\ equal_points x v).

(* b, moved by x, is inside a for these x and no others. *)
Definition is_inner_fit (a b : polygonal_region) (f : placements) : Prop :=
  forall x, fits x f <-> forall y, member y b -> member (sum_of_points x y) a.

(* No point is inside two of the parts, and all of their points are points of the container, if there is one. *)
Definition is_layout (container : option polygonal_region) (parts : list polygonal_region) : Prop :=
  ForallOrdPairs (fun a b => forall x, ~ (is_inner_point x a /\ is_inner_point x b)) parts /\
  forall c a x, container = Some c -> In a parts -> member x a -> member x c.

(* Within less than the radius in both coordinates. *)
Definition is_near (radius : Q) (a b : point) : Prop :=
  (- radius < x_of b - x_of a < radius) /\ (- radius < y_of b - y_of a < radius).

Definition interior (A : point -> Prop) (a : point) : Prop :=
  exists radius, 0 < radius /\ forall b, is_near radius a b -> A b.

Definition closure (A : point -> Prop) (a : point) : Prop :=
  forall radius, 0 < radius -> exists b, is_near radius a b /\ A b.

(* s consists of all points of p and of q. *)
Definition is_union (p q s : polygonal_region) : Prop := forall x, member x s <-> member x p \/ member x q.

(* s consists of what p and q have in common, but for points and edges without anything around them. *)
Definition is_intersection (p q s : polygonal_region) : Prop :=
  forall x, member x s <-> closure (interior (fun y => member y p /\ member y q)) x.

(* s consists of what is in p and not in q, and of the boundary of that. *)
Definition is_difference (p q s : polygonal_region) : Prop :=
  forall x, member x s <-> closure (interior (fun y => member y p /\ ~ member y q)) x.

(* An unbounded region is all that its chains do not go round, and these chains. *)
Definition unbounded_member (x : point) (r : polygonal_region) : Prop :=
  (exists e, In e (edges_of_region r) /\ is_on x e) \/ region_winding_number x r = 0%Z.

(* s, unbounded, consists of what is not in p, and of the boundary of that. *)
Definition is_complement (p s : polygonal_region) : Prop :=
  forall x, unbounded_member x s <-> closure (fun y => ~ member y p) x.

(* The same of an unbounded p and a bounded s. *)
Definition is_complement_of_unbounded (p s : polygonal_region) : Prop :=
  forall x, member x s <-> closure (fun y => ~ unbounded_member y p) x.

(* Where q is inside A: all its points, moved by x, are points of A. *)
Definition is_moved_into (q : polygonal_region) (A : point -> Prop) (x : point) : Prop :=
  forall y, member y q -> A (sum_of_points x y).

(* s consists of the places at which q is inside p, but for edges and points without anything around them. *)
Definition is_erosion (p q s : polygonal_region) : Prop :=
  forall x, member x s <-> closure (interior (is_moved_into q (fun y => member y p))) x.

(* s consists of the points of q at these places. *)
Definition is_opening (p q s : polygonal_region) : Prop :=
  forall x, member x s <->
    exists y z, is_moved_into q (fun a => member a p) y /\ member z q /\ equal_points x (sum_of_points y z).

(* s consists of the places at which q is inside the sum of p and q, but for edges and points as before. *)
Definition is_closing (p q s : polygonal_region) : Prop :=
  forall x, member x s <-> closure (interior (is_moved_into q (fun y =>
    exists a b, member a p /\ member b q /\ equal_points y (sum_of_points a b)))) x.

(* A checker is right if it accepts nothing but what it is to accept, whatever it is given as a certificate. *)
Definition accepts_only_no_fits {certificate : Type} (accepts : polygonal_region -> polygonal_region -> open_region -> certificate -> bool) : Prop :=
  forall a b s c, accepts a b s c = true -> is_no_fit a b s.

Definition accepts_only_inner_fits {certificate : Type} (accepts : polygonal_region -> polygonal_region -> placements -> certificate -> bool) : Prop :=
  forall a b f c, accepts a b f c = true -> is_inner_fit a b f.

Definition accepts_only_layouts {certificate : Type} (accepts : option polygonal_region -> list polygonal_region -> certificate -> bool) : Prop :=
  forall container parts c, accepts container parts c = true -> is_layout container parts.

(* On the edge, and none of its ends. *)
Definition is_within (x : point) (e : edge) : Prop :=
  is_on x e /\ ~ equal_points x (fst e) /\ ~ equal_points x (snd e).

(* No two edges cross or overlap: where they have a point in common, it is an end of one of them. *)
Definition edges_touch_at_most (r : polygonal_region) : Prop :=
  ForallOrdPairs (fun e f => forall x, ~ (is_within x e /\ is_within x f)) (edges_of_region r).

(* A checker is right if it accepts nothing but Minkowski sums whose edges touch at most, as those of the summands do,
   whatever it is given as a certificate. *)
Definition accepts_only_sums {certificate : Type} (accepts : polygonal_region -> polygonal_region -> polygonal_region -> certificate -> bool) : Prop :=
  forall p q s c, accepts p q s c = true ->
    is_minkowski_sum p q s /\ edges_touch_at_most p /\ edges_touch_at_most q /\ edges_touch_at_most s.

(* The same of open sums. *)
Definition accepts_only_open_sums {certificate : Type} (accepts : polygonal_region -> polygonal_region -> open_region -> certificate -> bool) : Prop :=
  forall p q s c, accepts p q s c = true ->
    is_open_sum p q s /\ edges_touch_at_most p /\ edges_touch_at_most q /\ edges_touch_at_most (open_chains s).
