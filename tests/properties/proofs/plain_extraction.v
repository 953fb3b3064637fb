(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The same without a replacement: types, numbers and all are Coq's. Slow, and compared with the program by tests. *)
From Coq Require Extraction.
From Oplus Require Import checker.

Extraction Language OCaml.
Extraction "plain_checker.ml" check homogeneous.
