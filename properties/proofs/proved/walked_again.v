(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The edges of chains put together to chains again, which turn clockwise most at each point (walks.v). Chains that went
   round holes of another region do so only after that, once they are turned. The points stay. *)
From Coq Require Import QArith ZArith Lia Bool List Permutation.
From Oplus Require Import specification balanced_edges angular_crossings convolution regions specification_bridge
  homogeneous_points filling sum_is_right walks.
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
    enough (same : forall l m : list Z, Permutation l m -> sum l = sum m).
    { rewrite (same _ _ (Permutation_map (fun w => one_if w v) (rotated_permutes chain))). lia. }
    unfold sum. intros l m permuted. induction permuted; cbn; lia. }
  unfold sum. induction l as [| e l IH]; cbn; lia.
Qed.

(* Theorem. *)
Theorem walked_again_has_the_points (r : polygonal_region) (x : point) : member x (walked_again r) <-> member x r.
Proof.
  assert (same : r = map (map as_point) (map (map as_vector) r)).
  { rewrite map_map. rewrite <- (map_id r) at 1. apply map_ext. intros c. rewrite map_map. rewrite <- (map_id c) at 1.
    apply map_ext. now intros [a b]. }
  rewrite same at 2. unfold walked_again. set (chains := map (map as_vector) r).
  pose proof (chains_take_all (length (region_edges chains)) (region_edges chains) (le_n _) (chains_are_balanced chains))
    as permuted.
  rewrite !member_of_chains.
  assert (number_is : winding_number.winding_number (as_vector x) (region_edges (chains_of (length (region_edges chains)) (region_edges chains)))
    = winding_number.winding_number (as_vector x) (region_edges chains)).
  { unfold winding_number.winding_number. apply (Permutation_map (winding_number.signed_crossing (as_vector x))) in permuted. revert permuted.
    generalize (map (winding_number.signed_crossing (as_vector x)) (region_edges chains)).
    generalize (map (winding_number.signed_crossing (as_vector x))
      (region_edges (chains_of (length (region_edges chains)) (region_edges chains)))).
    unfold sum. intros l m permuted. induction permuted; cbn; lia. }
  rewrite number_is.
  split; (intros [(s & S & on) | round]; [left; exists s; split; [| exact on] | now right]);
    [exact (Permutation_in _ permuted S) | exact (Permutation_in _ (Permutation_sym permuted) S)].
Qed.
