(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Section 4.2.4 is false as printed where it says that for polygons that are not simple, too, the winding number of
   the original convolution and the number of connected components of the intersection of P and -Q + x remain the
   same, as Theorem 4.2.14 has it for simple ones. P is a triangle with a triangular hole, Q a triangle whose
   reflection covers the hole: the winding number is 0, and the intersection is not empty. What holds is proved in
   theorem_4_2_14.v, for an intersection whose boundary is given: the winding number is the number of its outer chains
   less that of its holes. What the section concludes, Theorem 4.2.1 for such polygons, is right
   (theorem_4_2_1_for_regions). *)
From Coq Require Import QArith Lia List.
From Oplus Require Import connected_sets convolution convolution_winding regions rows_and_columns theorem_4_2_1
  theorem_4_2_1_for_valid_regions valid_components test_of_components replaced_segments tangent_features
  theorem_4_2_14 checked_collision small_intersection simple_polygons polygons_of_the_thesis drawn_regions
  fans_that_touch.
Import ListNotations.

Open Scope Q_scope.

(* For each x off both convolutions. *)
Definition section_4_2_4_as_printed : Prop :=
  forall (p q : list component) (x : vector),
    valid_components p -> valid_components q ->
    off x (convolution_segments (region_of p) (region_of q)) ->
    off x (original_convolution (region_of p) (region_of q)) ->
    exists k, has_components (fun z => in_region z (region_of p) /\ in_reflected x (region_of q) z) k /\
      winding_number x (original_convolution (region_of p) (region_of q)) = Z.of_nat k.

Definition triangle_with_a_hole : list component :=
  [Component (points_at [(-2, -1); (1, 0); (0, 2)]) [points_at [(0, 0); (-1, 0); (0, 1)]]].
Definition covering_triangle : list component := [Component (points_at [(2, 0); (0, 0); (0, -2)]) []].

(* Theorem. *)
Theorem section_4_2_4_is_false_as_printed : ~ section_4_2_4_as_printed.
Proof.
  intros printed. set (x := Vector (3 # 5) (- (3 # 10))).
  assert (valid_p : valid_components triangle_with_a_hole)
    by (apply are_valid_components_sound; vm_compute; reflexivity).
  assert (valid_q : valid_components covering_triangle)
    by (apply are_valid_components_sound; vm_compute; reflexivity).
  assert (free : off x (convolution_segments (region_of triangle_with_a_hole) (region_of covering_triangle)))
    by (apply off_by_computation; vm_compute; reflexivity).
  destruct (printed triangle_with_a_hole covering_triangle x valid_p valid_q free) as (k & components & number).
  - apply off_by_computation. vm_compute. reflexivity.
  - assert (zero_ : winding_number x
      (original_convolution (region_of triangle_with_a_hole) (region_of covering_triangle)) = 0%Z)
      by (vm_compute; reflexivity).
    rewrite zero_ in number. assert (k = 0%nat) as -> by lia.
    assert (meet : exists z, in_region z (region_of triangle_with_a_hole) /\
      in_reflected x (region_of covering_triangle) z).
    { rewrite <- sum_as_intersection. apply positive_winding_number_iff_common_point; trivial;
        [now apply valid_components_are_valid_regions .. | vm_compute; reflexivity]. }
    destruct components as (points & none & _ & covered & _). destruct meet as (z & in_both).
    destruct (covered z in_both) as (a & I & _). destruct points; [destruct I | discriminate none].
Qed.

(* Theorem, Section 4.2.4 as corrected. *)
Theorem section_4_2_4_as_corrected (p q outer_chains holes : region) (x : vector) :
  turns_in_all_chains p -> turns_in_all_chains q -> turns_in_all_chains (outer_chains ++ holes) ->
  numbers_are_0_or_1 p -> numbers_are_0_or_1 q -> bounds_the_intersection (outer_chains ++ holes) x p q ->
  (forall chain, In chain outer_chains -> outer chain) -> (forall chain, In chain holes -> hole chain) ->
  winding_number x (original_convolution p q) = (Z.of_nat (length outer_chains) - Z.of_nat (length holes))%Z.
Proof. exact (original_winding_number_counts_components_less_holes p q outer_chains holes x). Qed.

(* A bar across the two arms of the letter U meets it in two rectangles, two outer chains and no hole. *)
Example two_outer_chains : winding_number origin (original_convolution region_of_letter_u bar) = 2%Z.
Proof.
  assert (once : forall r, covers_nothing_twice r = true ->
    valid_region r /\ turns_in_all_chains r /\ numbers_are_0_or_1 r).
  { intros r test. apply covers_nothing_twice_is_right in test. destruct test as [valid once].
    split; [exact valid |]. split; [intros chain; now apply chains_turn_everywhere |].
    intros x free. pose proof (proj1 (proj2 valid) x free). pose proof (once x free). lia. }
  destruct (once region_of_letter_u) as (_ & turns_u & numbers_u); [vm_compute; reflexivity |].
  destruct (once bar) as (_ & turns_bar & numbers_bar); [vm_compute; reflexivity |].
  destruct (once two_rectangles) as (_ & turns_both & _); [vm_compute; reflexivity |].
  apply (section_4_2_4_as_corrected region_of_letter_u bar two_rectangles []); trivial.
  - exact two_rectangles_bound_the_intersection.
  - intros chain [<- | [<- | []]]; vm_compute; reflexivity.
  - intros chain [].
Qed.
