(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Lemma 2.2.9, the sliding lemma: if an edge f of Q at its vertex q leads to the right of an edge e of P, the points of
   e + q are inner points of the sum, but for those that come from vertices of P. Those are excluded, touching ones too:
   there the lemma is false (docs/findings.md). A small step along f stays in Q, and the opposite step leads to the left
   of e, which is inside P. *)
From Coq Require Import ZArith Lia Bool List.
From Oplus Require Import numbers regions_and_sums inside_a_corner theorem_2_2_10 lemma_2_2_2.
Import ListNotations.

Open Scope Q_scope.

(* A step that leads out of the side of P that is filled, but stays in Q. *)
Theorem sliding (p q : region) (w u d n : vector) :
  fills_left w d p -> eventually (fun t => in_region (moved_along u n t) q) -> cross d n < 0 ->
  inner_point_of_sum (plus w u) p q.
Proof.
  intros (radius & R & fills) in_q right_.
  destruct (some_small _ (eventually_and _ _ in_q (small_steps_stay_within radius w (opposite n) R)))
    as (t & some & in_t & near).
  apply (inner_plus_point p q (moved_along w (opposite n) t) (moved_along u n t)); [| exact in_t |].
  - apply fills; [exact near |].
    setoid_replace (cross d (minus (moved_along w (opposite n) t) w)) with (t * - cross d n) by by_coordinates. nra.
  - unfold plus, moved_along, opposite. split; cbn [vx vy]; ring.
Qed.

(* Theorem, Lemma 2.2.9. f is the edge of Q that leaves its vertex q, and leads to the right of the edge e of P; or f
   is the edge that enters q, and f reversed leads to the right of e. Then each point of e, unless it is a
   vertex of P, plus q is an inner point of the sum. *)
Theorem sliding_lemma (p q : region) (e f : segment) (w : vector) :
  valid_region p -> In e (region_edges p) -> lies_on w e -> ~ is_vertex w p -> In f (region_edges q) ->
  (cross (along e) (along f) < 0 -> inner_point_of_sum (plus w (source f)) p q) /\
  (cross (along e) (opposite (along f)) < 0 -> inner_point_of_sum (plus w (target f)) p q).
Proof.
  intros p_region I on no_vertex J. pose proof (fills_left_beside_an_edge p e w p_region I on no_vertex) as fills.
  split; intros right_;
    [apply (sliding p q w (source f) (along e) (along f) fills) |
     apply (sliding p q w (target f) (along e) (opposite (along f)) fills)]; trivial; exists 1; (split; [lra |]);
    intros t t0 t1; right; exists f; (split; [exact J |]); [exists t | exists (1 - t)]; in_coordinates;
    (split; [lra |]); split; ring.
Qed.
