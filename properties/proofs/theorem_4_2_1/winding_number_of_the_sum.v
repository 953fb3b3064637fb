(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Theorem 4.2.1, one direction, and that winding numbers of the convolution are nowhere negative: from the
   identity of tangent_count.v, of which no term is negative. The other direction is in interiors_meet.v. *)
From Coq Require Import ZArith Lia Bool List.
From Oplus Require Import numbers convolution convolution_winding finite_sums weight regions parallelogram
  tangent_count beside_every_point.
Import ListNotations.

Open Scope Z_scope.

Lemma region_edges_are_directions (r : region) :
  no_edges_are_points r -> forall e, In e (region_edges r) -> nonzero (along e).
Proof.
  intros not_points e I. apply in_flat_map in I. destruct I as (chain & J & I).
  apply (not_points chain J). unfold edge_directions. apply in_map_iff. now exists e.
Qed.

(* What a pair of edges counts: it is not negative, and not zero only if x is a sum of points of both. *)
Lemma pair_of_edges (d x : vector) (e f : segment) :
  nonzero d -> nonzero (along e) -> nonzero (along f) ->
  0 <= weight d (along e) (along f) * winding_number x (parallelogram e f) /\
  (0 < weight d (along e) (along f) * winding_number x (parallelogram e f) -> is_sum_of_points x e f).
Proof.
  intros proper_d proper_e proper_f.
  destruct (weight_has_the_sign_of_the_skew_product d (along e) (along f) proper_d proper_e proper_f)
    as [left_turn right_turn].
  destruct (parallelogram_winding_number x e f) as [-> | [[[-> sign] | [-> sign]] sum_]];
    [split; lia | specialize (left_turn sign) | specialize (right_turn sign)]; (split; [lia | trivial]).
Qed.

(* Nor is what a vertex counts. *)
Lemma no_vertex_is_negative (d : direction) (r : region) (x : vector) (vertices : list (vector * corner)) :
  nowhere_negative r ->
  forall v, In v vertices -> 0 <= if_tangent d (snd v) * winding_number (minus x (fst v)) (region_edges r).
Proof.
  intros valid v _. pose proof (nowhere_negative_everywhere r valid (minus x (fst v))).
  unfold if_tangent. destruct (in_tangent_set _ _); cbn [Z.b2z]; lia.
Qed.

Section Regions.
  Variables p q : region.
  Variables d x : vector.
  Hypothesis p_edges : no_edges_are_points p.
  Hypothesis q_edges : no_edges_are_points q.
  Hypothesis p_valid : nowhere_negative p.
  Hypothesis q_valid : nowhere_negative q.
  Hypothesis proper_d : nonzero d.

  Lemma no_pair_of_edges_is_negative : forall pair, In pair (list_prod (region_edges p) (region_edges q)) ->
    0 <= weight d (along (fst pair)) (along (snd pair)) *
         winding_number x (parallelogram (fst pair) (snd pair)).
  Proof.
    intros [e f] I. apply in_prod_iff in I. destruct I as [in_p in_q].
    apply pair_of_edges; [exact proper_d | |].
    - now apply (region_edges_are_directions p).
    - now apply (region_edges_are_directions q).
  Qed.

  (* No term of the identity is negative. *)
  Lemma no_term_is_negative :
    0 <= tangent_vertices_of_p d x (region_vertices p) (region_edges q) /\
    0 <= tangent_vertices_of_q d x (region_vertices q) (region_edges p) /\
    0 <= tangent_crossings d x (region_edges p) (region_edges q).
  Proof.
    split; [| split]; apply sum_is_not_negative.
    - now apply no_vertex_is_negative.
    - now apply no_vertex_is_negative.
    - exact no_pair_of_edges_is_negative.
  Qed.

  (* Where the sum is positive, a term is. *)
  Lemma a_term_is_positive :
    0 < winding_number x (convolution_segments p q) ->
    (exists v, In v (region_vertices p) /\ in_tangent_set (Direction d OfQ) (snd v) = true /\
       0 < winding_number (minus x (fst v)) (region_edges q)) \/
    (exists v, In v (region_vertices q) /\ in_tangent_set (Direction (opposite d) OfP) (snd v) = true /\
       0 < winding_number (minus x (fst v)) (region_edges p)) \/
    (exists e f, In e (region_edges p) /\ In f (region_edges q) /\ weight d (along e) (along f) <> 0 /\
       winding_number x (parallelogram e f) <> 0 /\ is_sum_of_points x e f).
  Proof.
    intros positive. rewrite (tangent_count_of_regions p q d x p_edges q_edges proper_d) in positive.
    destruct no_term_is_negative as (of_p & of_q & of_both).
    destruct (Z_lt_le_dec 0 (tangent_vertices_of_p d x (region_vertices p) (region_edges q))) as [some | none].
    { apply positive_sum in some. destruct some as (v & I & term). left. exists v. split; [exact I |].
      unfold if_tangent in term. destruct (in_tangent_set _ _); cbn [Z.b2z] in term; split; trivial; lia. }
    destruct (Z_lt_le_dec 0 (tangent_vertices_of_q d x (region_vertices q) (region_edges p))) as [some | none'].
    { apply positive_sum in some. destruct some as (v & I & term). right. left. exists v. split; [exact I |].
      unfold if_tangent in term. destruct (in_tangent_set _ _); cbn [Z.b2z] in term; split; trivial; lia. }
    assert (some : 0 < tangent_crossings d x (region_edges p) (region_edges q)) by lia.
    apply positive_sum in some. destruct some as ([e f] & I & term). cbn [fst snd] in term.
    apply in_prod_iff in I. destruct I as [in_p in_q]. right. right. exists e, f.
    repeat split; trivial; try (intros zero_; rewrite zero_ in term; lia).
    apply (pair_of_edges d x e f); trivial.
    - now apply (region_edges_are_directions p).
    - now apply (region_edges_are_directions q).
  Qed.
End Regions.

(* Theorem. If the winding numbers of two regions are nowhere negative, off their own boundaries, then those of
   their convolution are nowhere negative, also on it. *)
Theorem convolution_is_nowhere_negative (p q : region) (x : vector) :
  no_edges_are_points p -> no_edges_are_points q -> nowhere_negative p -> nowhere_negative q ->
  0 <= winding_number x (convolution_segments p q).
Proof.
  intros p_edges q_edges p_valid q_valid.
  assert (proper_d : nonzero (Vector 1 0)) by (unfold nonzero; cbn; lra).
  rewrite (tangent_count_of_regions p q (Vector 1 0) x p_edges q_edges proper_d).
  pose proof (no_term_is_negative p q (Vector 1 0) x p_edges q_edges p_valid q_valid proper_d). lia.
Qed.

(* Theorem. And every point with a positive winding number, also on the convolution, is in the Minkowski sum. *)
Theorem positive_winding_number_is_in_the_sum (p q : region) (x : vector) :
  no_edges_are_points p -> no_edges_are_points q -> nowhere_negative p -> nowhere_negative q ->
  0 < winding_number x (convolution_segments p q) -> in_sum x p q.
Proof.
  intros p_edges q_edges p_valid q_valid positive.
  assert (proper_d : nonzero (Vector 1 0)) by (unfold nonzero; cbn; lra).
  destruct (a_term_is_positive p q (Vector 1 0) x p_edges q_edges p_valid q_valid proper_d positive)
    as [([v c] & I & _ & inside) | [([v c] & I & _ & inside) |
      (e & f & in_p & in_q & _ & _ & a & b & on_e & on_f & is_sum)]].
  - exists v, (minus x v). split; [| split].
    + right. now apply vertex_is_on_the_boundary with c.
    + left. exact inside.
    + split; cbn; ring.
  - exists (minus x v), v. split; [| split].
    + left. exact inside.
    + right. now apply vertex_is_on_the_boundary with c.
    + split; cbn; ring.
  - exists a, b. split; [| split; [| exact is_sum]]; right; [exists e | exists f]; now split.
Qed.
