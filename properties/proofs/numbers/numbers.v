(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The numbers that coordinates are: the rational ones. The theory requires this file and nothing of Coq's library
   that is about rational numbers only, so that it also compiles over the real numbers: over_the_reals/real_numbers.v
   gives the same names to them. `==` is equality of numbers, here not that of fractions. *)
From Coq Require Export QArith Qminmax Qabs Qfield Lqa Setoid.
From Coq Require NsatzTactic.

(* `=` says more than `==`: that two fractions are the same. *)
Definition identical_dec (x y : Q) : {x = y} + {x <> y}.
Proof. repeat decide equality. Defined.

Lemma negated_twice (x : Q) : - - x = x.
Proof. destruct x as [n d]. unfold Qopp; cbn. now rewrite Z.opp_involutive. Qed.
