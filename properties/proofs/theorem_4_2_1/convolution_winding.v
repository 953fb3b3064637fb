(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The convolution of two regions consists of closed chains, so that it has winding numbers. *)
From Coq Require Import ZArith Lia Bool List Permutation SetoidList SetoidPermutation.
From Oplus Require Import numbers convolution shifted_ray signed_crossings total_turn tracing convolution_cycles.
Import ListNotations.

Open Scope nat_scope.

(* The convolution as directed segments: reference/definitions/convolution.cpp. *)
Definition convolution_segments (p q : region) : list segment :=
  map (fun s => Segment (starts_at s) (ends_at s)) (segments_of_regions p q).

Lemma walks_shift : forall n m walked a b, is_walk n m a walked b ->
  a :: map (state_after n m) walked = map state_before walked ++ [b].
Proof.
  intros n m walked. induction walked as [| s rest IH]; intros a b W; cbn in *.
  - congruence.
  - destruct W as [<- W]. now rewrite (IH _ _ W).
Qed.

Lemma cycles_permute : forall n m cycles, Forall (is_cycle n m) cycles ->
  Permutation (map state_before (concat cycles)) (map (state_after n m) (concat cycles)).
Proof.
  intros n m cycles F. induction F as [| cycle rest [_ (start & W)] _ IH]; [reflexivity |].
  cbn [concat]. rewrite !map_app. apply Permutation_app; [| exact IH].
  apply walks_shift in W. apply (Permutation_cons_inv (a := start)). rewrite W.
  apply Permutation_cons_append.
Qed.

Lemma nothing_with_no_vertex : forall p q, p = [] \/ q = [] -> convolution p q = [].
Proof.
  intros p q E. destruct (convolution p q) as [| s rest] eqn:C; [reflexivity | exfalso].
  assert (In s (convolution p q)) as I by (rewrite C; now left).
  apply (in_those (length p) (length q) (in_convolution p q)) in I. destruct I as [[A B] _].
  destruct E as [-> | ->]; cbn in A, B; lia.
Qed.

Lemma states_permute : forall p q, no_edge_is_a_point p -> no_edge_is_a_point q ->
  Permutation (map state_before (convolution p q))
              (map (state_after (length p) (length q)) (convolution p q)).
Proof.
  intros p q P Q.
  destruct p as [| v p']; [rewrite nothing_with_no_vertex by auto; constructor |].
  destruct q as [| w q']; [rewrite nothing_with_no_vertex by auto; constructor |].
  destruct (cycles_cover_the_convolution (v :: p') (w :: q') P Q) as (cycles & _ & F & M);
    try discriminate.
  apply cycles_permute in F.
  etransitivity; [apply Permutation_map, Permutation_sym, M |].
  etransitivity; [exact F |]. apply Permutation_map, M.
Qed.

Lemma region_points_permute : forall p q : region,
  (forall chain, In chain p -> no_edge_is_a_point chain) ->
  (forall chain, In chain q -> no_edge_is_a_point chain) ->
  Permutation (map starts_at (segments_of_regions p q)) (map ends_at (segments_of_regions p q)).
Proof.
  intros p q P Q. unfold segments_of_regions.
  assert (I : forall chains, In chains (list_prod p q) ->
    no_edge_is_a_point (fst chains) /\ no_edge_is_a_point (snd chains)).
  { intros [a b] I. apply in_prod_iff in I. cbn. split; [apply P | apply Q]; tauto. }
  induction (list_prod p q) as [| chains rest IH]; [reflexivity |].
  cbn [flat_map]. rewrite !map_app, !map_map.
  apply Permutation_app; [| apply IH; intros; apply I; now right].
  destruct (I chains (or_introl eq_refl)) as [A B].
  pose proof (Permutation_map (point_of chains) (states_permute _ _ A B)) as M.
  rewrite !map_map in M. exact M.
Qed.

(* Theorem. At every point as many segments of the convolution of two regions start as end: they are
   the edges of closed chains, which is what the theorems on winding numbers ask for. *)
Theorem convolution_is_closed : forall p q : region,
  (forall chain, In chain p -> no_edge_is_a_point chain) ->
  (forall chain, In chain q -> no_edge_is_a_point chain) ->
  winding_number.cycles (convolution_segments p q).
Proof.
  intros p q P Q. unfold winding_number.cycles, convolution_segments. rewrite !map_map. cbn.
  apply permuted_vectors. now apply region_points_permute.
Qed.

(* Theorem. The winding number of a point off the convolution of two regions, as the code counts it on a
   ray to the right, is what every other ray counts, and is how many full turns the convolution makes
   around the point. *)
Theorem convolution_winding_number_by_any_ray : forall (p q : region) x k d,
  (forall chain, In chain p -> no_edge_is_a_point chain) ->
  (forall chain, In chain q -> no_edge_is_a_point chain) ->
  off x (convolution_segments p q) -> nonzero d ->
  winding_number_by_ray k d x (convolution_segments p q) =
    winding_number.winding_number x (convolution_segments p q) /\
  (total_angle (map (seen_from x) (convolution_segments p q)) ==
    4 * inject_Z (winding_number.winding_number x (convolution_segments p q)))%Q.
Proof.
  intros p q x k d P Q O D. pose proof (convolution_is_closed p q P Q) as C. split.
  - now apply winding_number_by_any_ray.
  - now apply winding_number_counts_turns.
Qed.

(* Theorem. Observation 4.2.5: along any path of straight steps between two points off the convolution of
   two regions, the signed crossings add up to the difference of the winding numbers at its ends,
   wherever the points between are; along a closed path they add up to zero. *)
Theorem convolution_crossings_add_up : forall (p q : region) path first,
  (forall chain, In chain p -> no_edge_is_a_point chain) ->
  (forall chain, In chain q -> no_edge_is_a_point chain) ->
  off first (convolution_segments p q) -> off (last path first) (convolution_segments p q) ->
  signed_crossings_of_path (first :: path) (convolution_segments p q) =
    (winding_number.winding_number (last path first) (convolution_segments p q) -
     winding_number.winding_number first (convolution_segments p q))%Z /\
  (last path first = first ->
   signed_crossings_of_path (first :: path) (convolution_segments p q) = 0%Z).
Proof.
  intros p q path first P Q A B.
  pose proof (signed_crossings_add_up _ path first (convolution_is_closed p q P Q) A B) as E.
  split; [exact E |]. intros closed. rewrite E, closed. lia.
Qed.
