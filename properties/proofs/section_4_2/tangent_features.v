(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* What Theorem 4.2.14 and Section 4.2.4 count, by directions: the winding number of the convolution,
   less the reflex vertices of one summand inside the other, is a signed number of points at which a direction is
   tangent to the intersection, the same number for every direction. From the identity of tangent_count.v: a
   tangent set is what a vertex passes, plus everything if it is reflex (turning_number.v). *)
From Coq Require Import ZArith Lia Bool List.
From Oplus Require Import numbers convolution convolution_winding finite_sums weight regions parallelogram
  tangent_count.
Import ListNotations.

Open Scope Z_scope.

(* A reflex vertex v counts as often as x is inside the other summand moved by v. *)
Definition reflex_vertices_inside (x : vector) (r other_region : region) : Z :=
  sum_of (fun v => Z.b2z (is_reflex (snd v)) * winding_number (minus x (fst v)) (region_edges other_region))
    (region_vertices r).

(* Vertices at which the tangent passes d, counterclockwise or clockwise, by how often they are inside. *)
Definition signed_tangent_vertices (d : direction) (x : vector) (r other_region : region) : Z :=
  sum_of (fun v => sweep d (incoming (snd v)) (outgoing (snd v)) *
                   winding_number (minus x (fst v)) (region_edges other_region)) (region_vertices r).

(* All features of the intersection of P and -Q + x at which d, or for features of Q -d, is tangent. *)
Definition tangent_features (d x : vector) (p q : region) : Z :=
  signed_tangent_vertices (Direction d OfQ) x p q + signed_tangent_vertices (Direction (opposite d) OfP) x q p +
  tangent_crossings d x (region_edges p) (region_edges q).

Definition turns_in_all_chains (r : region) : Prop := forall chain, In chain r -> turns_everywhere chain.

Lemma vertices_are_corners (v : vector * corner) (r : region) :
  In v (region_vertices r) -> exists chain, In chain r /\ In (snd v) (corners chain).
Proof.
  destruct v as [v c]. intros I. apply in_flat_map in I. destruct I as (chain & J & I).
  apply in_combine_r in I. now exists chain.
Qed.

Lemma tangent_vertices_by_turns (d : direction) (x : vector) (r other_region : region) :
  proper d -> turns_in_all_chains r ->
  sum_of (fun v => if_tangent d (snd v) * winding_number (minus x (fst v)) (region_edges other_region))
    (region_vertices r) =
  signed_tangent_vertices d x r other_region + reflex_vertices_inside x r other_region.
Proof.
  intros proper_d turning. unfold signed_tangent_vertices, reflex_vertices_inside.
  rewrite <- sum_plus. apply sum_equally. intros v I.
  destruct (vertices_are_corners v r I) as (chain & J & K). unfold if_tangent.
  rewrite in_tangent_set_by_sweep; [lia | exact proper_d | exact (turning chain J (snd v) K)].
Qed.

(* Theorem. The winding number of the convolution of two regions at x, less the number of reflex vertices of P
   inside -Q + x and of Q inside -P + x, is the signed number of tangent features in direction d. *)
Theorem winding_number_less_reflex_vertices (p q : region) (d x : vector) :
  turns_in_all_chains p -> turns_in_all_chains q -> nonzero d ->
  winding_number x (convolution_segments p q) - reflex_vertices_inside x p q - reflex_vertices_inside x q p =
  tangent_features d x p q.
Proof.
  intros p_turns q_turns proper_d.
  rewrite (tangent_count_of_regions p q d x); [| | | exact proper_d];
    [| intros chain I; apply turning_chains_have_edges; auto ..].
  unfold tangent_vertices_of_p, tangent_vertices_of_q, tangent_features.
  rewrite (tangent_vertices_by_turns (Direction d OfQ) x p q proper_d p_turns).
  rewrite (tangent_vertices_by_turns (Direction (opposite d) OfP) x q p (opposite_nonzero d proper_d) q_turns).
  lia.
Qed.

(* Theorem. So this number is the same for every direction. *)
Theorem tangent_features_do_not_depend_on_the_direction (p q : region) (d e x : vector) :
  turns_in_all_chains p -> turns_in_all_chains q -> nonzero d -> nonzero e ->
  tangent_features d x p q = tangent_features e x p q.
Proof. intros p_turns q_turns proper_d proper_e. now rewrite <- !winding_number_less_reflex_vertices. Qed.
