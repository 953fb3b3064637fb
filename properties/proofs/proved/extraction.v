(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The program's functions as OCaml. *)
From Oplus Require Import zarith operations.

Extraction "proved.ml" can_be_summed proved_sum.
