(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The program's functions as OCaml. *)
From Oplus Require Import zarith operations region_reader region_printer.

Extraction "proved.ml" is_covered has_points proved_sum proved_open_sum proved_no_fit proved_inner_fit proved_union
  proved_intersection proved_difference proved_erosion proved_opening proved_closing is_covered_unbounded
  proved_complement proved_complement_of_unbounded polygons_of_open polygons_of_placements
  start take_byte at_end printed_number printed_polygons printed_set.
