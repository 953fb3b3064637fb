(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Theorem 4.2.14 as printed: for two simple polygons and each x off 𝒞 and 𝒞′, the winding number with respect to 𝒞′ is
   the number of components of the intersection of P and -Q + x. In general position it is
   (number_of_components.v). There is such a point close to x; there the winding number is the same, and so is the
   number of components (components_stay.v). *)
From Coq Require Import QArith ZArith List.
From Oplus Require Import convolution regions_and_sums small_numbers shifted_ray neighbourhoods replaced_segments
  lemma_4_2_13 polygons_of_the_thesis connected_sets components_of_near_sets components_stay number_of_components.
Import ListNotations.

Open Scope Q_scope.

(* Theorem. *)
Theorem theorem_4_2_14_as_printed (p q : list vector) (x : vector) : simple_polygon p -> simple_polygon q ->
  off x (convolution_segments [p] [q]) -> off x (original_convolution [p] [q]) ->
  exists k, has_components (fun z => in_region z [p] /\ in_reflected x [q] z) k /\
    winding_number x (original_convolution [p] [q]) = Z.of_nat k.
Proof.
  intros p_polygon q_polygon free free'.
  assert (closed : cycles (original_convolution [p] [q])).
  { apply replaced_segments_are_cycles; [exact (proj1 (simple_polygons_are_regions p p_polygon)) |
      exact (proj1 (simple_polygons_are_regions q q_polygon))]. }
  destruct (winding_number_near x _ closed free') as (r1 & R1 & near),
    (components_stay p q p_polygon q_polygon x free free') as (r2 & R2 & stay).
  destruct (some_small _ (eventually_and _ _ (general_position_beside [p] [q] x)
    (eventually_and _ _ (shifted_stays_within r1 x R1) (shifted_stays_within r2 x R2))))
    as (e & _ & general & one & two).
  destruct (theorem_4_2_14_in_general_position p q _ p_polygon q_polygon general) as (k & components & number).
  assert (same_ : forall y z, in_region z [p] /\ in_reflected y [q] z <-> in_common p q y z)
    by (intros y z; unfold in_common; now rewrite in_reflected_is).
  exists k. split.
  - apply (components_of_equal_sets (in_common p q x)); [intros z; symmetry; apply same_ |].
    apply (stay _ k two). revert components. apply components_of_equal_sets. apply same_.
  - now rewrite <- (proj2 (near _ one)).
Qed.
