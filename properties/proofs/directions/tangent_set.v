(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Tangent sets, computed as reference/definitions/tangent_set.cpp computes them. *)
From Coq Require Import Bool.
From Oplus Require Import numbers direction.

Open Scope Q_scope.

(* The edges that enter and leave a vertex of a chain. *)
Record corner := Corner { incoming : vector; outgoing : vector }.

Definition is_reflex (c : corner) : bool := negative (cross (incoming c) (outgoing c)).

(* Thesis, Definition 2.1.13, ties as in Definition 2.2.7: whether d, a direction of one summand, is
   in the tangent set of a vertex of the other. *)
Definition in_tangent_set (d : direction) (c : corner) : bool :=
  ccw d (Direction (incoming c) (other (of d))) (Direction (outgoing c) (other (of d))).
