(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The same without a replacement: types, numbers and all are Coq's. Slow, and compared with the programs by tests. *)
From Coq Require Extraction.
From Oplus Require Import checker operations region_reader region_printer.

Extraction Language OCaml.
Extraction "plain.ml" check is_covered has_points proved_sum proved_open_sum proved_no_fit proved_inner_fit
  proved_union proved_intersection proved_difference polygons_of_open polygons_of_placements region_in printed_polygons.
