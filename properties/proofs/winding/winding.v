(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Directions, and how often chains wind around points. *)
From Oplus Require Export directions angular_crossings winding_number.
