(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Directions and their cyclic order, computed as reference/definitions/direction.cpp computes them.
   That these functions are what the thesis means by them is proved in angle.v and cyclic_order.v. *)
From Coq Require Import Bool.
From Oplus Require Import numbers.

Open Scope Q_scope.

Record vector := Vector { vx : Q; vy : Q }.

Definition cross (u v : vector) : Q := vx u * vy v - vy u * vx v.
Definition dot (u v : vector) : Q := vx u * vx v + vy u * vy v.

(* Thesis, Definition 2.1.7: a direction is a vector other than zero, up to positive scaling. *)
Definition nonzero (v : vector) : Prop := ~ (vx v == 0 /\ vy v == 0).

Inductive summand := OfP | OfQ.

Definition other (s : summand) : summand := match s with OfP => OfQ | OfQ => OfP end.

(* A direction together with the summand it belongs to, which decides ties. *)
Record direction := Direction { vec : vector; of : summand }.

Definition proper (d : direction) : Prop := nonzero (vec d).

Definition negative (q : Q) : bool := match q ?= 0 with Lt => true | _ => false end.
Definition zero (q : Q) : bool := match q ?= 0 with Eq => true | _ => false end.

(* false for angles in [0, pi), true for angles in [pi, 2 pi). *)
Definition half (v : vector) : bool := negative (vy v) || (zero (vy v) && negative (vx v)).

(* The angles of u and v from the positive x-axis, counterclockwise, in [0, 2 pi). *)
Definition compare_angle (u v : vector) : comparison :=
  match half u, half v with
  | false, true => Lt
  | true, false => Gt
  | _, _ => vy u * vx v ?= vx u * vy v
  end.

(* The tie rule (thesis, Definition 2.2.7): of two equal directions, that of Q comes later. *)
Definition compare (a b : direction) : comparison :=
  match compare_angle (vec a) (vec b) with
  | Eq => match of a, of b with OfP, OfQ => Lt | OfQ, OfP => Gt | _, _ => Eq end
  | c => c
  end.

Definition before (a b : direction) : bool := match compare a b with Lt => true | _ => false end.

(* CCW(d, from, to) (thesis, Definitions 2.1.10 and 2.1.11): turning counterclockwise from `from`,
   d is met before `to`. *)
Definition ccw (d from to : direction) : bool :=
  match compare from to with
  | Eq => false
  | Lt => before from d && before d to
  | Gt => before from d || before d to
  end.

(* Equal directions of one summand. *)
Definition same (a b : direction) : bool := match compare a b with Eq => true | _ => false end.
