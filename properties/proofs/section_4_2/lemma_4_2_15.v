(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Lemma 4.2.15: replacing the segments of a vertex by its flip set (replaced_segments.v) lowers the winding number
   by one inside the other summand, moved by the vertex, and nowhere else. *)
From Coq Require Import ZArith Lia Bool List.
From Oplus Require Import numbers convolution convolution_winding finite_sums regions tangent_count replaced_segments.
Import ListNotations.

Open Scope Z_scope.

(* Theorem. For any choice of vertices of two regions, and every point: replacing the segments of a vertex v
   of P lowers the winding number of x by that of x - v by Q, which is 1 where x is inside Q moved by v and Q goes
   round it once, and 0 outside. *)
Theorem winding_number_of_replaced_segments (chosen : vertex_of_summand -> bool) (p q : region) (x : vector) :
  winding_number x (replaced chosen p q) =
  winding_number x (convolution_segments p q) -
  sum_of (fun v => Z.b2z (chosen (OfP, v)) * winding_number (minus x (fst v)) (region_edges q))
    (region_vertices p) -
  sum_of (fun v => Z.b2z (chosen (OfQ, v)) * winding_number (minus x (fst v)) (region_edges p))
    (region_vertices q).
Proof.
  rewrite !winding_number_as_sum, (sum_over_replaced (signed_crossing x)).
  - f_equal; [f_equal |]; apply sum_equally; intros v _; f_equal; apply sum_equally; intros [a b] _;
      apply crossing_of_moved.
  - intros [a b]. apply crossing_backwards.
  - apply crossing_of_equal_ends.
Qed.

(* Lemma 4.2.15. If one vertex v of P is chosen, and no other of P or Q, the winding number is lower by that of x - v
   by Q; so by one where Q goes round x - v once, and not at all where it does not go round. *)
Theorem replacing_at_one_vertex (chosen : vertex_of_summand -> bool) (p q : region) (x v : vector) (c : corner) before after :
  region_vertices p = before ++ (v, c) :: after -> chosen (OfP, (v, c)) = true ->
  (forall w, In w (before ++ after) -> chosen (OfP, w) = false) ->
  (forall w, In w (region_vertices q) -> chosen (OfQ, w) = false) ->
  winding_number x (replaced chosen p q) =
  winding_number x (convolution_segments p q) - winding_number (minus x v) (region_edges q).
Proof.
  intros vertices_are this none_of_p none_of_q. rewrite winding_number_of_replaced_segments, vertices_are.
  rewrite sum_of_two_lists, sum_of_more, this.
  unfold sum_of. rewrite !sum_of_zeros; [cbn [Z.b2z fst]; lia | | |]; intros w I.
  - now rewrite none_of_q.
  - rewrite none_of_p by (apply in_app_iff; now right). reflexivity.
  - rewrite none_of_p by (apply in_app_iff; now left). reflexivity.
Qed.
