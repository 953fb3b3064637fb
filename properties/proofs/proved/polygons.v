(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The chains of a region as polygons with holes, as files have them: a hole is given to the smallest of the outer
   chains around it. That is a matter of the order of chains only, on which the points of a region do not depend: so
   no more is to be proved here. A hole with no chain around it, which no valid region has, would be a polygon of its
   own. *)
From Coq Require Import QArith ZArith Bool List Permutation.
From Oplus Require Import specification.
Import ListNotations.

Open Scope Q_scope.

Definition polygon_with_holes := (chain * list chain)%type.
Definition chains_of_polygon (p : polygon_with_holes) : list chain := fst p :: snd p.

(* Positive for chains that run counterclockwise. *)
Definition twice_the_area (c : chain) : Q :=
  fold_right Qplus 0 (map (fun e => Qred (x_of (fst e) * y_of (snd e) - x_of (snd e) * y_of (fst e))) (edges_of_chain
    c)).

(* Whether the hole is in the outer chain, which it meets in vertices only. *)
Definition goes_round (outer hole : chain) : bool :=
  match edges_of_chain hole with
  | (a, b) :: _ => negb (region_winding_number (Point ((x_of a + x_of b) / 2) ((y_of a + y_of b) / 2)) [outer] =? 0)%Z
  | [] => false
  end.

(* The smallest area of the chains around a hole, if there are any. *)
Definition smallest_around (hole : chain) (outer : list chain) : option Q :=
  fold_right (fun c smallest =>
    if goes_round c hole then
      let area := twice_the_area c in
      match smallest with Some least => if Qle_bool least area then smallest else Some area | None => Some area end
    else smallest) None outer.

(* Given to the first polygon for which the test says so. *)
Fixpoint with_hole (is_around : chain -> bool) (hole : chain) (polygons : list polygon_with_holes) :
  list polygon_with_holes :=
  match polygons with
  | [] => [(hole, [])]
  | (outer, holes) :: others =>
    if is_around outer then (outer, holes ++ [hole]) :: others else (outer, holes) :: with_hole is_around hole others
  end.

Definition with_hole_inside (outer : list chain) (polygons : list polygon_with_holes) (hole : chain) :
  list polygon_with_holes :=
  match smallest_around hole outer with
  | None => with_hole (fun _ => false) hole polygons
  | Some least => with_hole (fun c => goes_round c hole && Qle_bool (twice_the_area c) least) hole polygons
  end.

(* In the order of the chains. *)
Definition polygons_of (r : polygonal_region) : list polygon_with_holes :=
  let (outer, holes) := partition (fun c => Qle_bool 0 (twice_the_area c)) r in
  fold_left (with_hole_inside outer) holes (map (fun c => (c, [])) outer).

Lemma with_hole_adds (is_around : chain -> bool) (hole : chain) (polygons : list polygon_with_holes) :
  Permutation (flat_map chains_of_polygon (with_hole is_around hole polygons))
    (hole :: flat_map chains_of_polygon polygons).
Proof.
  induction polygons as [| [outer holes] others IH]; [reflexivity |]. cbn [with_hole].
  destruct (is_around outer); cbn [flat_map chains_of_polygon fst snd app].
  - rewrite <- app_assoc. cbn [app]. rewrite perm_swap. constructor. symmetry. apply Permutation_middle.
  - rewrite IH. rewrite perm_swap. constructor. symmetry. apply Permutation_middle.
Qed.

Lemma partition_permutes {A : Type} (f : A -> bool) (l : list A) : forall yes no, partition f l = (yes, no) ->
  Permutation l (yes ++ no).
Proof.
  induction l as [| a l IH]; intros yes no parts; [now injection parts as <- <- |]. cbn [partition] in parts.
  destruct (partition f l) as [y n]. specialize (IH y n eq_refl).
  destruct (f a); injection parts as <- <-; rewrite IH; [reflexivity | apply Permutation_middle].
Qed.

(* Each chain is there once. *)
Lemma chains_of_polygons (r : polygonal_region) : Permutation (flat_map chains_of_polygon (polygons_of r)) r.
Proof.
  unfold polygons_of. destruct (partition _ r) as [outer holes] eqn:parts.
  rewrite (partition_permutes _ _ _ _ parts). clear parts r.
  assert (all : forall of ps, Permutation (flat_map chains_of_polygon (fold_left (with_hole_inside of) holes ps))
    (flat_map chains_of_polygon ps ++ holes)).
  { intros of. induction holes as [| hole holes IH]; intros ps; cbn [fold_left]; [now rewrite app_nil_r |].
    rewrite IH. unfold with_hole_inside. destruct (smallest_around hole of); rewrite with_hole_adds; cbn [app];
      apply Permutation_middle. }
  rewrite all. apply Permutation_app_tail. clear. induction outer as [| c outer IH]; [reflexivity |]. cbn. now
    constructor.
Qed.
