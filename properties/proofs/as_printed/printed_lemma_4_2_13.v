(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Lemma 4.2.13 as printed: with the segments of reflex vertices replaced by their flip sets (Definitions 4.2.11 and
   4.2.12), winding numbers off the segments are well defined. The thesis says what that means: along each closed path
   from a point off the segments, signed crossings add up to zero, so the number at a point does not depend on the
   path by which it is found. That is so because as many segments end at each point as start there: winding numbers are
   those of closed chains (Definition 4.2.2), so it is said as well. Paths consist of straight steps here. It is proved
   in lemma_4_2_13.v, for any vertices of any regions. *)
From Coq Require Import ZArith List.
From Oplus Require Import convolution signed_crossings replaced_segments lemma_4_2_13 theorem_4_2_1
  polygons_of_the_thesis.
Import ListNotations.

Open Scope Z_scope.

(* As many segments end at each point as start there; closed paths add up to zero; and two paths from points of known
   numbers to the same point give it the same number. *)
Definition well_defined_winding_numbers (segments : list segment) : Prop :=
  cycles segments /\
  (forall path first, off first segments -> last path first = first ->
     signed_crossings_of_path (first :: path) segments = 0) /\
  (forall path first other_path other_first, off first segments -> off other_first segments ->
     off (last path first) segments -> last path first = last other_path other_first ->
     winding_number first segments + signed_crossings_of_path (first :: path) segments =
     winding_number other_first segments + signed_crossings_of_path (other_first :: other_path) segments).

(* Theorem, Lemma 4.2.13. *)
Theorem lemma_4_2_13_as_printed (chosen : vertex_of_summand -> bool) (p q : region) :
  valid_region p -> valid_region q -> well_defined_winding_numbers (replaced chosen p q).
Proof.
  intros [p_edges _] [q_edges _].
  destruct (replaced_winding_number_is_well_defined chosen p q p_edges q_edges) as (_ & along_paths & closed).
  split; [now apply replaced_segments_are_cycles |]. split; [intros; now apply closed |]. intros path first other_path other_first free other_free free_end same_end.
  rewrite (along_paths path first), (along_paths other_path other_first), <- same_end; trivial; [ring |].
  now rewrite <- same_end.
Qed.
