(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The theorems on oplus-certified and oplus-proved on regions that one can draw: a square and a triangle with a
   certificate of their sum; the room and the diamond. *)
From Coq Require Import QArith ZArith Bool List.
From Oplus Require Import specification checker layout_checker certified_sums certified_open_sums certified_layouts
  placement_checkers certified_placements operations.
Import ListNotations.

(* A square, a triangle, and their sum, a pentagon; both are convex, so each is a piece, and the sum's only piece is
   their sum. *)
Definition corner_at (x y : Z) : point := Point (inject_Z x) (inject_Z y).
Definition a_square : polygonal_region := [[corner_at 0 0; corner_at 2 0; corner_at 2 2; corner_at 0 2]].
Definition a_triangle : polygonal_region := [[corner_at 0 0; corner_at 1 0; corner_at 0 1]].
Definition a_pentagon : polygonal_region :=
  [[corner_at 0 0; corner_at 3 0; corner_at 3 2; corner_at 2 3; corner_at 0 3]].
Definition their_certificate : certificate :=
  Certificate 1
    (SummandCertificate [] [[Hpoint 0 0 1; Hpoint 2 0 1; Hpoint 2 2 1; Hpoint 0 2 1]] [1%positive] [])
    (SummandCertificate [] [[Hpoint 0 0 1; Hpoint 1 0 1; Hpoint 0 1 1]] [1%positive] [])
    [] [([Hpoint 0 0 1; Hpoint 3 0 1; Hpoint 3 2 1; Hpoint 2 3 1; Hpoint 0 3 1], SumsOf 1 1)] [].

Example a_certified_sum : is_minkowski_sum a_square a_triangle a_pentagon.
Proof. apply (accepted_sums_are_sums _ _ _ their_certificate). vm_compute. reflexivity. Qed.

(* So there is no seam, and the pentagon without its edges is the open sum. *)
Example a_certified_open_sum : is_open_sum a_square a_triangle (OpenRegion a_pentagon [] []).
Proof. apply (accepted_open_sums_are_open_sums _ _ _ their_certificate). vm_compute. reflexivity. Qed.

(* The square and its reflection: their open sum is where the square, moved, overlaps itself. *)
Definition overlaps : polygonal_region := [[Point (-2) (-2); Point 2 (-2); Point 2 2; Point (-2) 2]].
Definition their_no_fit_certificate : certificate :=
  Certificate 1
    (SummandCertificate [] [[Hpoint 0 0 1; Hpoint 2 0 1; Hpoint 2 2 1; Hpoint 0 2 1]] [1%positive] [])
    (SummandCertificate [] [[Hpoint 0 0 1; Hpoint (-2) 0 1; Hpoint (-2) (-2) 1; Hpoint 0 (-2) 1]] [1%positive] [])
    [] [([Hpoint (-2) (-2) 1; Hpoint 2 (-2) 1; Hpoint 2 2 1; Hpoint (-2) 2 1], SumsOf 1 1)] [].

Example a_certified_no_fit : is_no_fit a_square a_square (OpenRegion overlaps [] []).
Proof. apply (accepted_no_fits_are_no_fits _ _ _ their_no_fit_certificate). vm_compute. reflexivity. Qed.

(* The square and the triangle, moved to its right, in the strip around them. *)
Definition a_strip : polygonal_region := [[Point 0 0; Point 3 0; Point 3 2; Point 0 2]].
Definition a_moved_triangle : polygonal_region := [[Point 2 0; Point 3 0; Point 2 1]].
Definition their_layout_certificate : layout_certificate :=
  LayoutCertificate 1 [
    RegionCertificate [] [
      [Hpoint (-6) (-6) 1; Hpoint 6 (-6) 1; Hpoint 3 0 1; Hpoint 0 0 1];
      [Hpoint 6 (-6) 1; Hpoint 6 6 1; Hpoint 3 2 1; Hpoint 3 0 1];
      [Hpoint 6 6 1; Hpoint (-6) 6 1; Hpoint 0 2 1; Hpoint 3 2 1];
      [Hpoint (-6) 6 1; Hpoint (-6) (-6) 1; Hpoint 0 0 1; Hpoint 0 2 1]];
    RegionCertificate [] [[Hpoint 0 0 1; Hpoint 2 0 1; Hpoint 2 2 1; Hpoint 0 2 1]];
    RegionCertificate [] [[Hpoint 2 0 1; Hpoint 3 0 1; Hpoint 2 1 1]]].

Example a_certified_layout : is_layout (Some a_strip) [a_square; a_moved_triangle].
Proof. apply (accepted_layouts_are_layouts _ _ their_layout_certificate). vm_compute. reflexivity. Qed.

(* The room and the diamond, in halves. *)
Definition halves (points : list (Z * Z)) : chain := map (fun c => Point (fst c # 2) (snd c # 2)) points.
Definition the_room : polygonal_region :=
  [halves [(0, 0); (14, 0); (14, 12); (8, 12); (8, 10); (12, 10); (12, 2); (2, 2); (2, 10); (6, 10); (6, 12);
    (0, 12)]%Z].
Definition the_diamond : polygonal_region := [halves [(0, 0); (1, -1); (2, 0); (1, 1)]%Z].

Lemma they_are_covered : is_covered the_room = true /\ is_covered the_diamond = true.
Proof. split; vm_compute; reflexivity. Qed.

(* What is computed is their sum; and it has the open sum's dangling edge, along which the diamond passes the
   hatch. *)
Example a_proved_sum : is_minkowski_sum the_room the_diamond (region_of_polygons (proved_sum the_room the_diamond)).
Proof. apply proved_sum_is_the_sum; apply they_are_covered. Qed.

Example a_proved_open_sum : is_open_sum the_room the_diamond (proved_open_sum the_room the_diamond) /\
  length (dangling_edges (proved_open_sum the_room the_diamond)) = 1%nat.
Proof. split; [apply proved_open_sum_is_the_open_sum; apply they_are_covered | vm_compute; reflexivity]. Qed.

(* Where the diamond fits into the room's outline. *)
Example a_proved_inner_fit : is_inner_fit the_room the_diamond (proved_inner_fit the_room the_diamond).
Proof. apply proved_inner_fit_is_the_inner_fit; [apply they_are_covered .. | vm_compute; reflexivity]. Qed.
