(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Directions, winding numbers, and the convolution of two chains: its segments, its states, their points. *)
From Oplus Require Export winding tangent_set turning_number convolution_size fiber_grid distinct forward_traversal
  states in_out_degree.
