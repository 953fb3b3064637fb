(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Regions in canonical form, as oplus writes them: rings (simple_rings.v) that are canonical chains
   (canonical_chains.v), polygons with their holes (polygons.v) in order, and points in order. The points of a region
   stay, and so do its inner points. *)
From Coq Require Import QArith Lqa ZArith Lia Bool List Permutation Orders Mergesort.
From Oplus Require Import specification direction winding_number in_out_degree regions specification_bridge pieces
  cut_pieces sum_program sum_is_right touching_vertices inner_fit_is_right open_sums polygons simple_rings
  canonical_chains.
Import ListNotations.

(* Positive for chains that run counterclockwise, also if they touch themselves. *)
Definition twice_the_area (c : chain) : Q :=
  fold_right Qplus 0 (map (fun e => Qred (x_of (fst e) * y_of (snd e) - x_of (snd e) * y_of (fst e))) (edges_of_chain
    c)).

(* Outer chains before holes, each by their vertices that are in no straight line. *)
Definition chain_with_key := ((bool * list vector) * list vector)%type.

Definition with_key (c : list vector) : chain_with_key :=
  let start := canonical_start c in
  ((negb (Qle_bool 0 (twice_the_area (map as_point start))), straight_chain start), start).

Lemma compare_chains_antisym (c : list vector) : forall d, compare_chains d c = CompOpp (compare_chains c d).
Proof.
  induction c as [| v c IH]; intros [| w d]; try reflexivity. cbn [compare_chains].
  rewrite (compare_points_antisym v w), (IH d). destruct (compare_points v w); reflexivity.
Qed.

Module ByKey <: TotalLeBool.
  Definition t := chain_with_key.
  Definition leb (c d : t) : bool :=
    match fst (fst c), fst (fst d) with
    | false, true => true
    | true, false => false
    | _, _ => match compare_chains (snd (fst c)) (snd (fst d)) with Gt => false | _ => true end
    end.
  Lemma leb_total (c d : t) : leb c d = true \/ leb d c = true.
  Proof.
    unfold leb. destruct (fst (fst c)), (fst (fst d)); try tauto; rewrite (compare_chains_antisym (snd (fst c)));
      destruct (compare_chains (snd (fst c)) (snd (fst d))); cbn; tauto.
  Qed.
End ByKey.
Module SortedByKey := Sort ByKey.

(* The rings of a region, the chains in order; and what is written of them. *)
Definition rings_in_order (r : region) : region := simple_rings (map snd (SortedByKey.sort (map with_key r))).
Definition written_chains (r : region) : region := map written_ring (rings_in_order r).

Lemma rings_of_chains (r : region) (ring : list vector) : In ring (rings_in_order r) ->
  exists c, In c r /\ In ring (rings_of [] (canonical_start c)).
Proof.
  intros I. apply in_flat_map in I. destruct I as (c & C & I). apply in_map_iff in C. destruct C as (k & <- & K).
  apply (Permutation_in _ (Permutation_sym (SortedByKey.Permuted_sort _))), in_map_iff in K.
  destruct K as (d & <- & D). now exists d.
Qed.

Lemma rings_in_order_have_the_edges (r : region) : Permutation (region_edges (rings_in_order r)) (region_edges r).
Proof.
  unfold rings_in_order. rewrite simple_rings_have_the_edges. transitivity (region_edges (map snd (map with_key r))).
  - apply Permutation_flat_map, Permutation_map. symmetry. apply SortedByKey.Permuted_sort.
  - unfold region_edges. induction r as [| c r IH]; [reflexivity |]. cbn [map flat_map]. apply Permutation_app; [|
    exact IH]. apply edges_of_a_rotation, canonical_start_is_a_rotation.
Qed.

Lemma written_chains_have_the_edges (r : region) :
  Permutation (region_edges (written_chains r)) (region_edges (map canonical_chain (rings_in_order r))).
Proof.
  unfold written_chains, region_edges. induction (rings_in_order r) as [| c l IH]; [reflexivity |]. cbn [map flat_map].
  apply Permutation_app; [apply edges_of_a_rotation, written_ring_is_a_rotation | exact IH].
Qed.

Definition canonical_region (r : polygonal_region) : polygonal_region :=
  map (map as_point) (written_chains (map (map as_vector) r)).

Lemma as_written (r : polygonal_region) : map (map as_point) (map (map as_vector) r) = r.
Proof.
  rewrite map_map. rewrite <- (map_id r) at 2. apply map_ext. intros c. rewrite map_map. rewrite <- (map_id c) at 2.
  apply map_ext. now intros [a b].
Qed.

Lemma written_chains_go_the_same (x : vector) (r : region) :
  alike_from x (region_edges (written_chains r)) (region_edges r).
Proof.
  apply (alike_transitive x _ _ _ (alike_permuted x _ _ (written_chains_have_the_edges r))).
  apply (alike_transitive x _ _ _ (canonical_chains_are_alike x (rings_in_order r))).
  apply alike_permuted, rings_in_order_have_the_edges.
Qed.

(* Theorem. *)
Theorem canonical_region_has_the_points (r : polygonal_region) (x : point) :
  (member x (canonical_region r) <-> member x r) /\ (is_inner_point x (canonical_region r) <-> is_inner_point x r).
Proof.
  rewrite <- (as_written r) at 2 4. unfold canonical_region. rewrite !member_of_chains, !inner_point_of_chains.
  destruct (written_chains_go_the_same (as_vector x) (map (map as_vector) r)) as [on number_is].
  rewrite on, number_is. split; [reflexivity |]. split; intros [round free]; (split; [exact round |]); intros s S on_s.
  - destruct (proj2 on) as (t & T & on_t); [now exists s | exact (free t T on_t)].
  - destruct (proj1 on) as (t & T & on_t); [now exists s | exact (free t T on_t)].
Qed.

Definition canonical_polygons (r : polygonal_region) : list polygon_with_holes := polygons_of (canonical_region r).

(* Points depend on edges, in any order. *)
Lemma edges_in_another_order (r s : polygonal_region) (x : point) : Permutation (edges_of_region r) (edges_of_region
  s) ->
  (member x r <-> member x s) /\ (is_inner_point x r <-> is_inner_point x s).
Proof.
  intros edges_are.
  assert (number_is : region_winding_number x r = region_winding_number x s).
  { unfold region_winding_number. apply (Permutation_map (crossing x)) in edges_are. revert edges_are. clear.
    generalize (map (crossing x) (edges_of_region r)), (map (crossing x) (edges_of_region s)).
    intros l m permuted. induction permuted; cbn; lia. }
  assert (same : forall e, In e (edges_of_region r) <-> In e (edges_of_region s)).
  { intros e. split; apply Permutation_in; [exact edges_are | now symmetry]. }
  unfold member, is_inner_point. rewrite number_is. setoid_rewrite same. tauto.
Qed.

Lemma chains_in_another_order (r s : polygonal_region) (x : point) : Permutation r s ->
  (member x r <-> member x s) /\ (is_inner_point x r <-> is_inner_point x s).
Proof. intros permuted. now apply edges_in_another_order, Permutation_flat_map. Qed.

Lemma canonical_polygons_permute (r : polygonal_region) :
  Permutation (flat_map chains_of_polygon (canonical_polygons r)) (canonical_region r).
Proof. exact (chains_of_polygons (canonical_region r)). Qed.

(* Theorem. *)
Theorem canonical_polygons_are_the_region (r : polygonal_region) (x : point) :
  (member x (flat_map chains_of_polygon (canonical_polygons r)) <-> member x r) /\
  (is_inner_point x (flat_map chains_of_polygon (canonical_polygons r)) <-> is_inner_point x r).
Proof.
  destruct (chains_in_another_order _ _ x (canonical_polygons_permute r)) as [same_points same_inner].
  rewrite same_points, same_inner. apply canonical_region_has_the_points.
Qed.

(* Single points, sorted, each once. *)
Definition written_points (l : list point) : list point := map as_point (sorted_points (map as_vector l)).

Lemma written_points_are (l : list point) (x : point) :
  (exists v, In v (written_points l) /\ equal_points x v) <-> (exists v, In v l /\ equal_points x v).
Proof.
  split; intros (v & V & [X Y]).
  - apply in_map_iff in V. destruct V as (w & <- & W). apply sorted_in, in_map_iff in W. destruct W as (u & <- & U).
    exists u. split; [exact U | now split].
  - destruct (sorted_has (as_vector v) (map as_vector l) (in_map _ _ _ V)) as (w & W & [wx wy]). exists (as_point w).
    split; [now apply in_map |]. split; [rewrite X; exact wx | rewrite Y; exact wy].
Qed.

(* Theorem. Equal sets of points are equal lists, number by number. *)
Theorem equal_points_are_written_equally (l m : list point) :
  (forall x, (exists v, In v l /\ equal_points x v) <-> (exists v, In v m /\ equal_points x v)) ->
  Forall2 equal_points (written_points l) (written_points m).
Proof.
  intros same. setoid_rewrite <- written_points_are in same. unfold written_points in *.
  pose proof (sorted_ordered (map as_vector l)) as l_order. pose proof (sorted_ordered (map as_vector m)) as m_order.
  revert same l_order m_order. generalize (sorted_points (map as_vector l)), (sorted_points (map as_vector m)).
  clear l m.
  set (has := fun (l : list vector) x => exists v, In v (map as_point l) /\ equal_points x v).
  assert (rest : forall a b l m, (forall c, In c l -> comes_first a c) -> equal_points (as_point a) (as_point b) ->
    (forall x, has (a :: l) x -> has (b :: m) x) -> forall x, has l x -> has m x).
  { intros a b l m first_ [X Y] part x (v & V & at_v). destruct (part x) as (w & [<- | W] & at_w);
      [exists v; split; [now right | exact at_v] | exfalso | now exists w].
    apply in_map_iff in V. destruct V as (c & <- & C), at_v, at_w. specialize (first_ c C).
    unfold comes_first, as_point in *. cbn [x_of y_of] in *. lra. }
  induction l as [| a l IH]; intros [| b m] same l_order m_order.
  - constructor.
  - destruct (proj2 (same (as_point b))) as (? & [] & _). exists (as_point b). split; [now left | split; reflexivity].
  - destruct (proj1 (same (as_point a))) as (? & [] & _). exists (as_point a). split; [now left | split; reflexivity].
  - destruct l_order as [a_first l_order], m_order as [b_first m_order].
    assert (heads : equal_points (as_point a) (as_point b)).
    { destruct (proj1 (same (as_point a))) as (v & [<- | V] & at_v),
        (proj2 (same (as_point b))) as (w & [<- | W] & at_w);
        try (eexists; split; [now left | split; reflexivity]); trivial; [destruct at_w; now split; symmetry |].
      apply in_map_iff in V, W. destruct V as (c & <- & C), W as (d & <- & D). exfalso.
      specialize (b_first c C). specialize (a_first d D). destruct at_v, at_w.
      unfold comes_first, as_point in *. cbn [x_of y_of] in *. lra. }
    cbn [map]. constructor; [exact heads |]. apply IH; trivial. intros x. split.
    + apply (rest a b); trivial. intros y. apply same.
    + apply (rest b a); trivial; [destruct heads; now split; symmetry |]. intros y. apply same.
Qed.
