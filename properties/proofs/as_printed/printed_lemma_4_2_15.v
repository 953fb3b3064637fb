(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Lemma 4.2.15 as printed: replacing the segments of one vertex of P, v, by its flip set lowers the winding number by
   one at all points inside Q + v, and, as its proof says, at no point outside; likewise for a vertex of Q. P and Q
   are simple polygons. The thesis says it of reflex vertices; it holds for all. In lemma_4_2_15.v it is proved for
   regions, and for any number of vertices: the number is lower by how often Q goes round x - v, which a simple
   polygon does once or not at all. *)
From Coq Require Import Lia List.
From Oplus Require Import numbers convolution convolution_winding convolution_graph finite_sums regions interiors_meet
  replaced_segments lemma_4_2_15 simple_chain simple_chains_turn_once polygons_of_the_thesis.
Import ListNotations.

(* Of all vertices of P and Q only vertex i of P; or of Q. *)
Definition only_vertex (from_ : summand) (chain : list vector) (i : nat) (w : vertex_of_summand) : bool :=
  match from_, w with
  | OfP, (OfP, (v, _)) | OfQ, (OfQ, (v, _)) => if vector_eq_dec v (vertex chain i) then true else false
  | _, _ => false
  end.

Lemma vertices_are_listed_once (chain : list vector) : simple chain -> NoDup chain.
Proof.
  intros chain_simple. apply (NoDup_nth chain nowhere). intros i j I J same_vertex.
  destruct (Nat.eq_dec i j) as [| differ]; [assumption | exfalso].
  apply (vertices_differ chain i j chain_simple I J differ). unfold vertex. rewrite same_vertex. split; reflexivity.
Qed.

(* Of a sum over all vertices that is zero but at one of them, one term is left. *)
Lemma sum_at_one_vertex (chain : list vector) (i : nat) (f : vector * corner -> Z) (at_vertex : Z) :
  simple chain -> (i < length chain)%nat ->
  (forall c, f (vertex chain i, c) = at_vertex) -> (forall v c, v <> vertex chain i -> f (v, c) = 0%Z) ->
  sum_of f (region_vertices [chain]) = at_vertex.
Proof.
  intros chain_simple I here elsewhere.
  assert (names : map fst (region_vertices [chain]) = chain).
  { unfold region_vertices. cbn [flat_map]. rewrite app_nil_r. apply combine_ends. now rewrite corners_length. }
  assert (J : In (vertex chain i) (map fst (region_vertices [chain]))) by (rewrite names; now apply nth_In).
  apply in_map_iff in J. destruct J as ([v c] & v_is & J). cbn [fst] in v_is. subst v.
  apply in_split in J. destruct J as (before & after & split_).
  pose proof (vertices_are_listed_once chain chain_simple) as once.
  rewrite <- names, split_, map_app in once. cbn [map fst] in once. apply NoDup_remove_2 in once.
  rewrite <- map_app in once. rewrite split_, sum_of_two_lists, sum_of_more, here. unfold sum_of.
  rewrite !sum_of_zeros; [lia | |]; intros [v d] K; apply elsewhere; intros ->;
    apply once, (in_map fst _ (vertex chain i, d)), in_app_iff; tauto.
Qed.

(* What is left where Q goes round a point once or not at all. *)
Lemma lower_by_one_inside (q : list vector) (y : vector) (before after : Z) :
  simple_polygon q -> off y (region_edges [q]) -> after = (before - winding_number y (region_edges [q]))%Z ->
  (inside y [q] -> after = (before - 1)%Z) /\ (~ inside y [q] -> after = before).
Proof.
  intros polygon free ->. unfold inside.
  destruct (simple_polygons_go_round_once q y polygon free) as [number | number]; rewrite number;
    split; intros where_; try lia.
  exfalso. apply where_. split; [exact free | reflexivity].
Qed.

(* Theorem, Lemma 4.2.15. *)
Theorem lemma_4_2_15_as_printed (p q : list vector) (i : nat) (x : vector) :
  simple_polygon p -> simple_polygon q -> (i < length p)%nat -> let v := vertex p i in
  off (minus x v) (region_edges [q]) ->
  (inside (minus x v) [q] ->
     winding_number x (replaced (only_vertex OfP p i) [p] [q]) =
     (winding_number x (convolution_segments [p] [q]) - 1)%Z) /\
  (~ inside (minus x v) [q] ->
     winding_number x (replaced (only_vertex OfP p i) [p] [q]) = winding_number x (convolution_segments [p] [q])).
Proof.
  intros [p_simple _] polygon I v free. apply (lower_by_one_inside q); trivial.
  rewrite winding_number_of_replaced_segments.
  rewrite (sum_at_one_vertex p i _ (winding_number (minus x v) (region_edges [q])) p_simple I).
  - unfold sum_of. rewrite sum_of_zeros; [lia |]. intros [u c] _. reflexivity.
  - intros c. cbn. fold v. destruct (vector_eq_dec v v); [apply Z.mul_1_l | contradiction].
  - intros u c differ. cbn. fold v in differ |- *. now destruct (vector_eq_dec u v).
Qed.

(* Theorem. Likewise for a vertex of Q. *)
Theorem lemma_4_2_15_for_a_vertex_of_q (p q : list vector) (j : nat) (x : vector) :
  simple_polygon p -> simple_polygon q -> (j < length q)%nat -> let v := vertex q j in
  off (minus x v) (region_edges [p]) ->
  (inside (minus x v) [p] ->
     winding_number x (replaced (only_vertex OfQ q j) [p] [q]) =
     (winding_number x (convolution_segments [p] [q]) - 1)%Z) /\
  (~ inside (minus x v) [p] ->
     winding_number x (replaced (only_vertex OfQ q j) [p] [q]) = winding_number x (convolution_segments [p] [q])).
Proof.
  intros polygon [q_simple _] J v free. apply (lower_by_one_inside p); trivial.
  rewrite winding_number_of_replaced_segments.
  rewrite (sum_at_one_vertex q j _ (winding_number (minus x v) (region_edges [p])) q_simple J).
  - unfold sum_of. rewrite sum_of_zeros; [lia |]. intros [u c] _. reflexivity.
  - intros c. cbn. fold v. destruct (vector_eq_dec v v); [apply Z.mul_1_l | contradiction].
  - intros u c differ. cbn. fold v in differ |- *. now destruct (vector_eq_dec u v).
Qed.
