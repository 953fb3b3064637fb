(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The checker as OCaml. *)
From Oplus Require Import zarith checker.

Extraction "proved.ml" check accepts homogeneous.
