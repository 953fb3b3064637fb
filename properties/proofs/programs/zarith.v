(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* How programs are extracted: Zarith's integers for Coq's. Coq's own list of replacements, ExtrOcamlZBigInt, is trusted, and
   this one. *)
From Coq Require Extraction.
From Coq Require Export ExtrOcamlZBigInt.
From Coq Require Import ZArith.

Extraction Language OCaml.
Extract Constant Pos.eqb => "Big_int_Z.eq_big_int".
Extract Constant Z.leb => "Big_int_Z.le_big_int".
Extract Constant Z.ltb => "Big_int_Z.lt_big_int".
Extract Constant Z.gcd => "Big_int_Z.gcd_big_int".
Extract Constant Z.ggcd =>
  "(fun a b -> let g = Big_int_Z.gcd_big_int a b in
    if Big_int_Z.sign_big_int g = 0 then (g, (a, b)) else (g, (Big_int_Z.div_big_int a g, Big_int_Z.div_big_int b g)))".
