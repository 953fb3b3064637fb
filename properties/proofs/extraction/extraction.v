(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The predicates that theorems are about, as OCaml. Nothing is replaced by types or functions of OCaml:
   numbers are Coq's binary ones, and what runs is what was proved, but for extraction itself. *)
From Coq Require Extraction.
From Oplus Require Import convolution tangent_set shifted_ray signed_crossings tracing convolution_cycles
  location pieces naive_collision convolution_winding regions tangent_count checked_collision.

Extraction Language OCaml.
Extraction "proved.ml" compare ccw is_reflex in_tangent_set
  signed_crossing winding_number.winding_number edges right_of_middle winding_number_shifted
  turning_number.turning_number in_convolution trace_cycles states_looked_at
  signed_crossing_of_step signed_crossings_of_path region_edges locate collide count_tangents
  convolution_segments convolution_winding_number covers_nothing_twice.
