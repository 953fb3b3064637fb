(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The chains of a region as polygons with holes, as files have them: a hole is given to the smallest of the outer chains
   around it. That is a matter of the order of chains only, on which the points of a region do not depend: so no more is
   to be proved here. A hole with no chain around it, which no valid region has, would be a polygon of its own. *)
From Coq Require Import QArith ZArith Bool List Permutation Orders Mergesort.
From Oplus Require Import specification.
Import ListNotations.

Open Scope Q_scope.

Definition polygon_with_holes := (chain * list chain)%type.
Definition chains_of_polygon (p : polygon_with_holes) : list chain := fst p :: snd p.

(* Positive for chains that run counterclockwise. *)
Definition twice_the_area (c : chain) : Q :=
  fold_right Qplus 0 (map (fun e => Qred (x_of (fst e) * y_of (snd e) - x_of (snd e) * y_of (fst e))) (edges_of_chain c)).

(* Chains with their areas, the smallest first. *)
Module ByArea <: TotalLeBool.
  Definition t := (Q * chain)%type.
  Definition leb (a b : t) := Qle_bool (fst a) (fst b).
  Lemma leb_total (a b : t) : leb a b = true \/ leb b a = true.
  Proof. unfold leb. rewrite !Qle_bool_iff. destruct (Qlt_le_dec (fst a) (fst b)); [left; now apply Qlt_le_weak | now right]. Qed.
End ByArea.
Module SortedByArea := Sort ByArea.

(* Whether the hole is in the outer chain, which it meets in vertices only. *)
Definition goes_round (outer hole : chain) : bool :=
  match edges_of_chain hole with
  | (a, b) :: _ => negb (region_winding_number (Point ((x_of a + x_of b) / 2) ((y_of a + y_of b) / 2)) [outer] =? 0)%Z
  | [] => false
  end.

Fixpoint with_hole (hole : chain) (polygons : list polygon_with_holes) : list polygon_with_holes :=
  match polygons with
  | [] => [(hole, [])]
  | (outer, holes) :: others =>
    if goes_round outer hole then (outer, hole :: holes) :: others else (outer, holes) :: with_hole hole others
  end.

Definition polygons_of (r : polygonal_region) : list polygon_with_holes :=
  let sorted := SortedByArea.sort (map (fun c => (twice_the_area c, c)) r) in
  let (outer, holes) := partition (fun c => Qle_bool 0 (fst c)) sorted in
  fold_right with_hole (map (fun c => (snd c, [])) outer) (map snd holes).

Lemma with_hole_adds (hole : chain) (polygons : list polygon_with_holes) :
  Permutation (flat_map chains_of_polygon (with_hole hole polygons)) (hole :: flat_map chains_of_polygon polygons).
Proof.
  induction polygons as [| [outer holes] others IH]; [reflexivity |]. cbn [with_hole].
  destruct (goes_round outer hole); cbn [flat_map chains_of_polygon fst snd app].
  - apply perm_swap.
  - rewrite IH. rewrite perm_swap. constructor. symmetry. apply Permutation_middle.
Qed.

(* Each chain is there once. *)
Lemma chains_of_polygons (r : polygonal_region) : Permutation (flat_map chains_of_polygon (polygons_of r)) r.
Proof.
  unfold polygons_of. set (with_areas := map _ r).
  assert (sorted : Permutation (map snd (SortedByArea.sort with_areas)) r).
  { rewrite <- (Permutation_map snd (SortedByArea.Permuted_sort with_areas)). unfold with_areas. now rewrite map_map, map_id. }
  transitivity (map snd (SortedByArea.sort with_areas)); [clear sorted | exact sorted].
  generalize (SortedByArea.sort with_areas). intros all.
  destruct (partition _ all) as [outer holes] eqn:parts.
  assert (both : Permutation (map snd all) (map snd holes ++ map snd outer)).
  { rewrite <- map_app. apply Permutation_map. revert outer holes parts. induction all as [| c all IH]; intros outer holes parts.
    - now injection parts as <- <-.
    - cbn [partition] in parts. destruct (partition _ all) as [o h]. specialize (IH o h eq_refl).
      destruct (Qle_bool 0 (fst c)); injection parts as <- <-.
      + rewrite IH. apply Permutation_middle.
      + cbn [app]. now constructor. }
  transitivity (map snd holes ++ map snd outer); [clear both | now symmetry].
  induction (map snd holes) as [| hole others IH]; cbn [fold_right app].
  - clear. induction outer as [| c outer IH]; [reflexivity |]. cbn. now constructor.
  - rewrite with_hole_adds. now constructor.
Qed.

(* Theorem. The points are those of the region. *)
Theorem polygons_are_the_region (r : polygonal_region) (x : point) :
  member x (flat_map chains_of_polygon (polygons_of r)) <-> member x r.
Proof.
  pose proof (chains_of_polygons r) as same. unfold member, region_winding_number, edges_of_region.
  assert (edges_are : Permutation (flat_map edges_of_chain (flat_map chains_of_polygon (polygons_of r))) (flat_map edges_of_chain r))
    by now apply Permutation_flat_map.
  enough (numbers : forall l m : list Z, Permutation l m -> fold_right Z.add 0%Z l = fold_right Z.add 0%Z m).
  { rewrite (numbers _ _ (Permutation_map (crossing x) edges_are)).
    split; (intros [(e & I & on) | round]; [left; exists e; split; [| exact on] | now right]);
      [apply (Permutation_in _ edges_are I) | apply (Permutation_in _ (Permutation_sym edges_are) I)]. }
  induction 1; cbn; ring || congruence || (etransitivity; eassumption).
Qed.
