(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Observation 4.2.8 as printed: if x is a point of a convolution segment, then a vertex of P is on an edge of -Q + x,
   or a vertex of -Q + x on an edge of P. The thesis says it of points inside the segment; it holds for its ends, too.
   A segment of the convolution is a sum of a vertex and an edge (theorem_2_2_6.v); Equations 4.2 to 4.5 say the
   same. *)
From Coq Require Import List.
From Oplus Require Import numbers convolution convolution_winding regions left_of_an_edge theorem_2_2_6 reflected
  placed_collision.
Import ListNotations.

Open Scope Q_scope.

(* Theorem, Observation 4.2.8. `placed x q` is -Q + x. *)
Theorem observation_4_2_8_as_printed (p q : region) (x : vector) (s : segment) :
  In s (convolution_segments p q) -> lies_on x s ->
  (exists v f, is_vertex v p /\ In f (region_edges (placed x q)) /\ lies_on v f) \/
  (exists v e, is_vertex v (placed x q) /\ In e (region_edges p) /\ lies_on v e).
Proof.
  intros in_convolution_ on.
  destruct (convolution_is_part_of_the_vertex_edge_sum p q x s in_convolution_ on)
    as [(v & f & V & F & on_f) | (v & e & V & E & on_e)].
  - left. exists v, (reflected x f). split; [exact V |]. rewrite edges_of_placed. split; [now apply in_map |].
    now apply on_reflected.
  - right. exists (minus x v), e. split; [| now split]. apply vertex_of_placed.
    destruct V as (u & U & X & Y). exists u. split; [exact U |]. unfold minus; split; cbn [vx vy]; lra.
Qed.
