(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Points of sums that one can draw, for the examples of this folder: points of the boundary of a closed sum, a point
   of a dangling edge of an open sum, and an isolated vertex of one. *)
From Coq Require Import QArith Qminmax Lqa ZArith Lia Bool List.
From Oplus Require Import convolution convolution_winding shifted_ray tie_rule regions meeting_of_segments
  interiors_meet neighbourhoods left_of_an_edge theorem_4_2_1 theorem_2_2_10 theorem_2_2_6 boundary_points
  small_polygons simple_polygons location test_of_regions checked_collision theorem_3_2_8 theorem_3_2_10
  polygons_of_the_thesis drawn_regions.
Import ListNotations.

Open Scope Q_scope.

(* The lower side of the sum of the chamber and the square of side 2. *)
Lemma lower_side_of_the_sum (a : Q) : 0 <= a <= 8 -> on_boundary_of_sum (Vector a 0) chamber [square].
Proof.
  intros range. apply (lowest_points_are_on_the_boundary _ _ 0 0); [vm_compute; reflexivity .. | | reflexivity].
  exists (Vector ((3 # 4) * a) 0), (Vector ((1 # 4) * a) 0).
  split; [| split; [| split; cbn [plus vx vy]; ring]]; right.
  - exists (Segment (Vector 0 0) (Vector 6 0)). split; [now left |]. exists (a / 8).
    cbn [source target vx vy]. split; [split; [apply Qle_shift_div_l | apply Qle_shift_div_r]; lra |]. split; field.
  - exists (Segment (Vector 0 0) (Vector 2 0)). split; [now left |]. exists (a / 8).
    cbn [source target vx vy]. split; [split; [apply Qle_shift_div_l | apply Qle_shift_div_r]; lra |]. split; field.
Qed.

(* Between (2, 3) and (3, 3) there is room for the reflected diamond in the room. *)
Lemma inside_the_room (a : Q) : 2 < a < 3 -> ~ in_sum (Vector a 3) [room] [fitting_diamond].
Proof.
  intros range. rewrite <- positive_winding_number_iff_common_point;
    try (apply simple_polygons_are_regions, drawn_polygons).
  - assert (none : winding_number (Vector a 3) (convolution_segments [room] [fitting_diamond]) = 0%Z)
      by number_by_arithmetic.
    rewrite none. now apply Z.lt_irrefl.
  - off_by_arithmetic.
Qed.

(* So the left wall is part of the boundary: the room's wall and the diamond's right vertex. *)
Lemma wall_of_the_sum : on_boundary_of_sum (Vector 2 3) [room] [fitting_diamond].
Proof.
  intros radius R. split.
  - exists (Vector 2 3). split; [unfold within; cbn [vx vy]; lra |].
    exists (Vector 1 3), (Vector 1 0). split; [| split; [| split; reflexivity]]; right.
    + exists (Segment (Vector 1 1) (Vector 1 5)). split; [vm_compute; tauto |].
      apply on_edge_by_computation. vm_compute. reflexivity.
    + exists (Segment (Vector 1 0) (Vector (1 # 2) (1 # 2))). split; [vm_compute; tauto |].
      apply on_edge_by_computation. vm_compute. reflexivity.
  - exists (Vector (2 + (1 # 2) * Qmin radius 1) 3).
    pose proof (Q.min_glb_lt radius 1 0 R ltac:(lra)). pose proof (Q.le_min_l radius 1).
    pose proof (Q.le_min_r radius 1).
    split; [unfold within; cbn [vx vy]; lra |]. apply inside_the_room. lra.
Qed.

Ltac inside_by_arithmetic :=
  split; [off_by_arithmetic |
  match goal with |- (0 < ?number)%Z =>
    let one := fresh "one" in assert (one : number = 1%Z) by number_by_arithmetic; rewrite one; reflexivity end].

(* The reflected diamond at (4, height) is between the sides of the hatch. *)
Lemma size_of_the_diamond (w : vector) :
  inside w [fitting_diamond] -> 0 < vx w < 1 /\ - (1 # 2) < vy w < 1 # 2.
Proof.
  destruct w as [a b]. intros [free positive_]. cbn [vx vy].
  assert (bounds : forall outside : Prop,
    (outside -> winding_number (Vector a b) (region_edges [fitting_diamond]) = 0%Z) -> ~ outside).
  { intros outside none yes. rewrite (none yes) in positive_. now apply Z.lt_irrefl in positive_. }
  assert (corner_ : ~ (a == 0 /\ b == 0)).
  { intros [X Y]. apply (free (Segment (Vector 0 0) (Vector (1 # 2) (- (1 # 2))))); [now left |].
    exists 0. cbn [source target vx vy]. lra. }
  repeat split; apply Qnot_le_lt; apply bounds; intros beyond; clear - beyond corner_;
    [| clear corner_; number_by_arithmetic ..].
  destruct (Qlt_le_dec b 0); [| destruct (Qlt_le_dec 0 b);
    [| assert (a < 0) by (apply Qnot_le_lt; intros ?; apply corner_; lra)]]; number_by_arithmetic.
Qed.

Lemma hatch_is_free (height : Q) :
  (11 # 2) - (1 # 4) < height -> height < (11 # 2) + (1 # 4) ->
  ~ interiors_meet (Vector 4 height) [room] [fitting_diamond].
Proof.
  intros above below ([a b] & [_ positive_] & in_diamond). apply size_of_the_diamond in in_diamond.
  unfold minus in in_diamond; cbn [vx vy] in in_diamond.
  assert (none : winding_number (Vector a b) (region_edges [room]) = 0%Z); [| rewrite none in positive_; lia].
  clear positive_. number_by_arithmetic.
Qed.

(* The diamond passes the hatch: (4, 11/2) is on a dangling edge of the open sum. A little to the left of it the
   reflected diamond overlaps the hatch's left side, a little to the right the right one. *)
Lemma passage_of_the_hatch : on_dangling_edge (Vector 4 (11 # 2)) (Vector 0 1) [room] [fitting_diamond].
Proof.
  split; [apply hatch_is_free; lra |]. split; [| split; [| split]].
  - exists (1 # 4). split; [lra |]. intros t some little. unfold moved_along; cbn [vx vy].
    intros (z & in_room & in_diamond). apply (hatch_is_free ((11 # 2) + t)); [lra .. |].
    exists z. split; [exact in_room |]. refine (inside_equal _ _ _ _ in_diamond).
    unfold minus; split; cbn [vx vy]; ring.
  - exists (1 # 4). split; [lra |]. intros t some little. unfold moved_along, angle.opposite; cbn [vx vy].
    intros (z & in_room & in_diamond). apply (hatch_is_free ((11 # 2) - t)); [lra .. |].
    exists z. split; [exact in_room |]. refine (inside_equal _ _ _ _ in_diamond).
    unfold minus; split; cbn [vx vy]; ring.
  - exists (Vector (-1) 0). split; [unfold cross; cbn; lra |].
    exists (1 # 4). split; [lra |]. intros t some little. exists (Vector (3 - (1 # 2) * t) (11 # 2)).
    unfold moved_along, minus; cbn [vx vy]. split; inside_by_arithmetic.
  - exists (Vector 1 0). split; [unfold cross; cbn; lra |].
    exists (1 # 4). split; [lra |]. intros t some little. exists (Vector (4 + (1 # 2) * t) (11 # 2)).
    unfold moved_along, minus; cbn [vx vy]. split; inside_by_arithmetic.
Qed.

(* Four vertices of the inscribed diamond touch the four sides of the chamber's hole, (3, 3) is its only place
   there. *)
Lemma only_place_in_the_chamber : isolated_vertex (Vector 3 3) chamber [inscribed_diamond].
Proof.
  split.
  - rewrite <- collide_decides_for_checked_regions by (vm_compute; reflexivity). vm_compute. discriminate.
  - exists (1 # 2). split; [lra |]. intros [a b] near differ. unfold within, equal_vectors in *; cbn [vx vy] in *.
    destruct (Qlt_le_dec 3 a) as [? | a_low]; [| destruct (Qlt_le_dec a 3) as [? | a_high];
      [| destruct (Qlt_le_dec 3 b) as [? | b_low]; [| destruct (Qlt_le_dec b 3) as [? | b_high]]]].
    + exists (Vector (4 + (1 # 2) * (a - 3)) b). unfold minus; cbn [vx vy]. split; inside_by_arithmetic.
    + exists (Vector (2 + (1 # 2) * (a - 3)) b). unfold minus; cbn [vx vy]. split; inside_by_arithmetic.
    + exists (Vector a (4 + (1 # 2) * (b - 3))). unfold minus; cbn [vx vy]. split; inside_by_arithmetic.
    + exists (Vector a (2 + (1 # 2) * (b - 3))). unfold minus; cbn [vx vy]. split; inside_by_arithmetic.
    + exfalso. apply differ. split; lra.
Qed.
