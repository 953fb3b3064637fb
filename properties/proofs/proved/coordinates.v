(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* What is true of vectors and points of segments by computing with coordinates is left to Coq's decision procedures;
   and what many proofs about pieces of segments say: a piece is a part, a point is between the ends or an end. *)
From Coq Require Import QArith Lqa Qfield List.
From Oplus Require Import regions_and_sums reflected right_of_an_edge pieces naive_collision specification_bridge
  specification.
Import ListNotations.

Open Scope Q_scope.

Ltac to_coordinates :=
  unfold equal_vectors, equal_points, sum_of_points, as_vector, as_point, within, area, cross, dot, moved_along,
    opposite, plus, reflected, reversed, middle, point_at, along, minus, Qdiv in *;
  cbn [source target vx vy x_of y_of] in *; change (/ 2) with (1 # 2) in *.

(* Solves what is linear in coordinates, or equal as polynomials. *)
Ltac by_computing :=
  repeat match goal with E : equal_vectors _ _ |- _ => destruct E end;
  to_coordinates; repeat match goal with |- _ /\ _ => split end; first [lra | ring | field].

(* A point of a segment, (1 - k) source + k target. *)
Ltac at_fraction k := exists k; split; [lra | by_computing].

Lemma piece_is_part (s piece : segment) (others : list segment) :
  nonzero (along s) -> In piece (cut_where_met s others) -> is_part piece s.
Proof. intros long I. now destruct (proj1 (cut_returns s _ long) piece I). Qed.

Lemma source_is_vertex (r : region) (s : segment) : In s (region_edges r) -> is_vertex (source s) r.
Proof. intros S. exists s. split; [exact S | reflexivity]. Qed.

Lemma off_is (x : vector) (l : list segment) : off x l <-> ~ exists s, In s l /\ lies_on x s.
Proof. split; [intros free (s & S & on); exact (free s S on) | intros none s S on; apply none; now exists s]. Qed.

Lemma valid_is_regular (r : region) : valid_region r -> is_regular r.
Proof. intros (not_points & not_negative & meet). now apply regions_are_regular. Qed.
