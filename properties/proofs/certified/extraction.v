(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The checker and the reader as OCaml. *)
From Oplus Require Import zarith checker layout_checker region_reader.

Extraction "proved.ml" check accepts regions_of_layout check_layout accepts_layout homogeneous start start_of_set take_byte at_end at_end_of_set number_in.
