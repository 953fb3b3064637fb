(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The checkers and the reader as OCaml. *)
From Oplus Require Import zarith checker layout_checker placement_checkers region_reader.

Extraction "proved.ml" check accepts accepts_open check_no_fit accepts_no_fit half_turned_region check_inner_fit
  accepts_inner_fit outside_of open_sum_around_placements check_layout accepts_layout regions_of_layout homogeneous
  start start_of_set take_byte at_end at_end_of_set number_in.
