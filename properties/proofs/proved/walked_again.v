(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The edges of chains put together to chains again, which turn clockwise most at each point (walks.v). Chains that went
   round holes of another region do so only after that, once they are turned. The points stay. *)
From Coq Require Import QArith ZArith Lia Bool List Permutation.
From Oplus Require Import specification balanced_edges angular_crossings convolution regions specification_bridge
  filling open_sum_program walks canonical_regions.
Import ListNotations.

Definition walked_again (r : polygonal_region) : polygonal_region :=
  let edges_ := region_edges (map (map as_vector) r) in map (map as_point) (chains_of (length edges_) edges_).

Lemma chains_are_balanced (r : region) : is_balanced (region_edges r).
Proof.
  intros v. unfold surplus, region_edges. induction r as [| chain r IH]; [reflexivity |].
  cbn [flat_map]. rewrite map_app, sum_of_both, IH, Z.add_0_r. clear IH.
  destruct (edges_ends chain) as [sources targets].
  enough (parts : forall l : list segment, sum (map (fun e => one_if (source e) v - one_if (target e) v)%Z l) =
    (sum (map (fun w => one_if w v) (map source l)) - sum (map (fun w => one_if w v) (map target l)))%Z).
  { rewrite parts, sources, targets.
    rewrite (sum_of_permutation _ _ (Permutation_map (fun w => one_if w v) (rotated_permutes chain))). lia. }
  unfold sum. induction l as [| e l IH]; cbn; lia.
Qed.

Lemma edges_of_chains (r : region) : edges_of_region (map (map as_point) r) = map as_edge (region_edges r).
Proof.
  unfold edges_of_region, region_edges. induction r as [| c r IH]; [reflexivity |]. cbn [map flat_map].
  rewrite IH, map_app. f_equal. clear IH. destruct c as [| first rest]; [reflexivity |]. unfold edges.
  cbn [map rotated edges_of_chain]. change [as_point first] with (map as_point [first]). rewrite <- map_app.
  change (as_point first :: map as_point rest) with (map as_point (first :: rest)).
  generalize (first :: rest) (rest ++ [first]). intros l. induction l as [| a l IH]; intros [| b m]; [reflexivity .. |].
  cbn. now rewrite IH.
Qed.

(* Theorem. *)
Theorem walked_again_has_the_points (r : polygonal_region) (x : point) :
  (member x (walked_again r) <-> member x r) /\ (is_inner_point x (walked_again r) <-> is_inner_point x r).
Proof.
  apply edges_in_another_order. rewrite <- (as_written r) at 2. unfold walked_again. rewrite !edges_of_chains.
  apply Permutation_map, chains_take_all; [apply le_n | apply chains_are_balanced].
Qed.
