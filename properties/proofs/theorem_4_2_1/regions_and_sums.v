(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Regions, what is inside them and beside their edges, the convolution of two and its winding numbers, for others to
   require. *)
From Oplus Require Export convolution small_numbers shifted_ray signed_crossings tie_rule meeting_of_segments
  neighbourhoods first_hit convolution_winding regions weight beside_every_point winding_number_of_the_sum
  interiors_meet left_of_an_edge theorem_4_2_1.
