(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Two regions with a hole that touches the outer chain, between the ends of its edges, and their sums with a triangle
   each: the counterexamples to Observation 2.2.4, Lemma 2.2.9 and Theorem 2.3.2 as printed (docs/findings.md has
   pictures). They are regions as in Definition 2.1.17, collections of simple chains, by the definition itself
   (valid_components.v). *)
From Coq Require Import QArith Lqa ZArith Lia Bool List.
From Oplus Require Import convolution convolution_winding regions meeting_of_segments neighbourhoods simple_chain
  simple_chains_turn_once valid_components location theorem_4_2_1 theorem_4_2_1_for_valid_regions theorem_2_2_10
  simple_polygons test_of_components polygons_of_the_thesis drawn_regions.
Import ListNotations.

Open Scope Q_scope.

(* Points of known edges: the edges one by one, the point by a number between 0 and 1. *)
Ltac each_edge H :=
  let s := fresh "s" in let I := fresh "I" in let t := fresh "t" in
  destruct H as (s & I & t & ? & ? & ?); vm_compute in I;
  repeat match type of I with _ \/ _ => destruct I as [I | I] end; try contradiction; subst s;
  cbn [source target vx vy] in *.

(* A point off segments is not a point that is on them. *)
Lemma apart_from_point_on (v : vector) (segments : list segment) (a b : Q) :
  off (Vector a b) segments -> existsb (is_on_segment v) segments = true ->
  a < vx v \/ vx v < a \/ b < vy v \/ vy v < b.
Proof.
  intros free found. destruct (is_on_one_spec v segments) as [(s & I & on) |]; [| discriminate found].
  destruct (Q_dec a (vx v)) as [[? | ?] | X]; [tauto.. |]. destruct (Q_dec b (vy v)) as [[? | ?] | Y]; [tauto.. |].
  exfalso. apply (free s I). apply (lies_on_equal v); [| exact on]. split; symmetry; assumption.
Qed.

(* That a hole is inside a chain by Definition 2.1.17, by arithmetic. It touches the chain in some of its vertices. *)
Ltac apart_from_each vertices free :=
  match vertices with
  | ?v :: ?rest =>
      let apart := fresh "apart" in
      pose proof (apart_from_point_on v _ _ _ free eq_refl) as apart; cbn [vx vy] in apart;
      destruct apart as [apart | [apart | [apart | apart]]]; try (exfalso; lra); apart_from_each rest free
  | _ => clear free
  end.

Ltac source_of_an_edge edges_ :=
  match edges_ with
  | ?s :: ?rest =>
      first [exists s; split; [vm_compute; tauto | split; cbn [source target vx vy]; lra] | source_of_an_edge rest]
  end.

Ltac hole_by_arithmetic hole vertices :=
  split; [| split];
  [ intros [? ?] on_hole on_outer; each_edge on_hole; each_edge on_outer;
    first [exfalso; lra | let l := eval vm_compute in (edges hole) in source_of_an_edge l]
  | intros [? ?] on_hole free [_ number]; each_edge on_hole;
    match type of number with ?n = _ => let one := fresh "one" in
      assert (one : n = 1%Z) by (clear number; apart_from_each vertices free; number_by_arithmetic);
      rewrite one in number; discriminate number end
  | intros [? ?] on_outer free; split; [exact free |]; each_edge on_outer;
    apart_from_each vertices free; number_by_arithmetic ].

(* A square from (0, 0) to (6, 6) with a hole that touches its lower side in (3, 0), and a triangle that, reflected,
   just fits into the hole's corner there. *)
Definition lower_hole : list vector := points_at [(3, 0); (1, 3); (5, 3)].
Definition large_square : list vector := points_at [(0, 0); (6, 0); (6, 6); (0, 6)].
Definition square_with_lower_hole : list component := [Component large_square [lower_hole]].
Definition narrow_triangle : list vector := points_at [(0, 0); (-1, -2); (0, -1)].

Lemma square_with_lower_hole_is_valid : valid_components square_with_lower_hole.
Proof.
  split; [| repeat constructor]. intros c [<- | []].
  split; [apply is_simple_decides; vm_compute; reflexivity |]. split; [vm_compute; reflexivity |].
  split; [| repeat constructor]. intros h [<- | []].
  split; [apply is_simple_decides; vm_compute; reflexivity |]. split; [vm_compute; reflexivity |].
  hole_by_arithmetic lower_hole [Vector 3 0].
Qed.

Lemma narrow_triangle_is_valid : valid_components [Component narrow_triangle []].
Proof. apply simple_polygon_is_a_component. split; [apply is_simple_decides |]; vm_compute; reflexivity. Qed.

(* The points (3, height) just above (3, 0), which is (3, 0) and (0, 0) added up, are not in the sum. *)
Lemma above_the_corner (height : Q) : 0 < height < 1 # 2 ->
  ~ in_sum (Vector 3 height) (region_of square_with_lower_hole) [narrow_triangle].
Proof.
  intros range. rewrite <- positive_winding_number_iff_common_point.
  - assert (none : winding_number (Vector 3 height)
      (convolution_segments (region_of square_with_lower_hole) [narrow_triangle]) = 0%Z) by number_by_arithmetic.
    rewrite none. now apply Z.lt_irrefl.
  - apply valid_components_are_valid_regions, square_with_lower_hole_is_valid.
  - apply (valid_components_are_valid_regions [Component narrow_triangle []]), narrow_triangle_is_valid.
  - off_by_arithmetic.
Qed.

(* A triangle with a hole that touches its right side in (4, 3), its upper side in (3, 4) and its third side in (2,
   3), and a smaller triangle with a vertical side from (2, 0) to (2, 1), which is as far right as it goes. *)
Definition inscribed_hole : list vector := points_at [(4, 3); (2, 3); (3, 4)].
Definition large_triangle : list vector := points_at [(4, 2); (4, 4); (0, 4)].
Definition triangle_with_inscribed_hole : list component := [Component large_triangle [inscribed_hole]].
Definition small_triangle : list vector := points_at [(1, 2); (2, 0); (2, 1)].

Lemma triangle_with_inscribed_hole_is_valid : valid_components triangle_with_inscribed_hole.
Proof.
  split; [| repeat constructor]. intros c [<- | []].
  split; [apply is_simple_decides; vm_compute; reflexivity |]. split; [vm_compute; reflexivity |].
  split; [| repeat constructor]. intros h [<- | []].
  split; [apply is_simple_decides; vm_compute; reflexivity |]. split; [vm_compute; reflexivity |].
  hole_by_arithmetic inscribed_hole [Vector 4 3; Vector 2 3; Vector 3 4].
Qed.

Lemma small_triangle_is_valid : valid_components [Component small_triangle []].
Proof. apply simple_polygon_is_a_component. split; [apply is_simple_decides |]; vm_compute; reflexivity. Qed.

(* The points of x = 6 between (6, 3) and (6, 4), sums of (4, 3) and that side, are on the boundary: the sum goes no
   further to the right. *)
Lemma right_of_the_sum (a b : Q) : 6 < a -> 3 <= b <= 4 ->
  ~ in_sum (Vector a b) [small_triangle] (region_of triangle_with_inscribed_hole).
Proof.
  intros right_ range. rewrite <- positive_winding_number_iff_common_point.
  - assert (none : winding_number (Vector a b)
      (convolution_segments [small_triangle] (region_of triangle_with_inscribed_hole)) = 0%Z) by number_by_arithmetic.
    rewrite none. now apply Z.lt_irrefl.
  - apply (valid_components_are_valid_regions [Component small_triangle []]), small_triangle_is_valid.
  - apply valid_components_are_valid_regions, triangle_with_inscribed_hole_is_valid.
  - off_by_arithmetic.
Qed.

Lemma right_side_is_on_the_boundary (a b : Q) : a == 6 -> 3 <= b <= 4 ->
  on_boundary_of_sum (Vector a b) [small_triangle] (region_of triangle_with_inscribed_hole).
Proof.
  intros right_ range radius R. split.
  - exists (Vector a b). split; [unfold within; cbn [vx vy]; lra |].
    exists (Vector 2 (b - 3)), (Vector 4 3). split; [| split; [| split; cbn [plus vx vy]; lra]]; right.
    + exists (Segment (Vector 2 0) (Vector 2 1)). split; [vm_compute; tauto |]. exists (b - 3).
      cbn [source target vx vy]. split; [lra |]. split; ring.
    + exists (Segment (Vector 4 3) (Vector 2 3)). split; [vm_compute; tauto |].
      apply on_edge_by_computation. vm_compute. reflexivity.
  - exists (Vector (a + (1 # 2) * radius) b). split; [unfold within; cbn [vx vy]; lra |].
    apply right_of_the_sum; lra.
Qed.
