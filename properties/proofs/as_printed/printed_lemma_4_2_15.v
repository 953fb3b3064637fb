(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Lemma 4.2.15 as printed: replacing the segments of vertex i of P, v, by its flip set lowers the winding number by one at
   all points inside Q + v, and, as its proof says, at no point outside. P and Q are simple polygons. The thesis says it
   of reflex vertices; it holds for all. It is proved in lemma_4_2_15.v, for regions; there the number is lower by how
   often Q goes round x - v, which for a simple polygon is once or not at all. *)
From Coq Require Import QArith Lqa ZArith Lia Bool List.
From Oplus Require Import convolution convolution_winding convolution_graph regions interiors_meet replaced_segments
  lemma_4_2_15 small_polygons simple_chain simple_chains_turn_once polygons_of_the_thesis drawn_regions.
Import ListNotations.

(* Of all vertices of P and Q only vertex i of P. *)
Definition only_vertex (p : list vector) (i : nat) (w : vertex_of_summand) : bool :=
  match w with
  | (OfP, (v, _)) => if vector_eq_dec v (vertex p i) then true else false
  | (OfQ, _) => false
  end.

Lemma vertices_are_listed_once (p : list vector) : simple p -> NoDup p.
Proof.
  intros p_simple. apply (NoDup_nth p nowhere). intros i j I J same_vertex.
  destruct (Nat.eq_dec i j) as [| differ]; [assumption | exfalso].
  apply (vertices_differ p i j p_simple I J differ). unfold vertex. rewrite same_vertex. split; reflexivity.
Qed.

(* Theorem, Lemma 4.2.15. *)
Theorem lemma_4_2_15_as_printed (p q : list vector) (i : nat) (x : vector) :
  simple_polygon p -> simple_polygon q -> (i < length p)%nat -> let v := vertex p i in
  off (minus x v) (region_edges [q]) ->
  (inside (minus x v) [q] ->
     winding_number x (replaced (only_vertex p i) [p] [q]) =
     (winding_number x (convolution_segments [p] [q]) - 1)%Z) /\
  (~ inside (minus x v) [q] ->
     winding_number x (replaced (only_vertex p i) [p] [q]) = winding_number x (convolution_segments [p] [q])).
Proof.
  intros [p_simple _] polygon I v free.
  assert (names : map fst (region_vertices [p]) = p).
  { unfold region_vertices. cbn [flat_map]. rewrite app_nil_r. apply combine_ends. now rewrite corners_length. }
  destruct (nth_split (region_vertices [p]) (nowhere, Corner nowhere nowhere) (n := i)) as (before & after & split_ & at_i).
  { rewrite <- (map_length fst), names. exact I. }
  destruct (nth i (region_vertices [p]) (nowhere, Corner nowhere nowhere)) as [u c].
  assert (u_is : u = v).
  { unfold v, vertex. rewrite <- names at 1. rewrite split_, map_app, app_nth2; rewrite map_length; [| lia].
    rewrite at_i, Nat.sub_diag. reflexivity. }
  subst u.
  rewrite (replacing_at_one_vertex (only_vertex p i) [p] [q] x v c before after split_).
  - unfold inside. destruct (simple_polygons_go_round_once q (minus x v) polygon free) as [number | number];
      rewrite number; split; intros where_; try lia.
    exfalso. apply where_. split; [exact free | reflexivity].
  - cbn. fold v. now destruct (vector_eq_dec v v).
  - intros [u d] J. cbn. fold v. destruct (vector_eq_dec u v) as [-> |]; [exfalso | reflexivity].
    pose proof (vertices_are_listed_once p p_simple) as once. rewrite <- names, split_, map_app in once. cbn [map fst] in once.
    apply NoDup_remove_2 in once. apply once. rewrite <- map_app. now apply (in_map fst) in J.
  - intros [u d] _. reflexivity.
Qed.

(* At the inner corner (6, 5) of the room, in a point inside the diamond placed there. *)
Example at_an_inner_corner : let x := Vector (13 # 2) 5 in
  winding_number x (replaced (only_vertex room 5) [room] [diamond]) =
  (winding_number x (convolution_segments [room] [diamond]) - 1)%Z.
Proof.
  apply (lemma_4_2_15_as_printed room diamond 5); [apply drawn_polygons .. | | |].
  - cbn. repeat constructor.
  - apply off_by_computation. vm_compute. reflexivity.
  - apply inside_by_computation. vm_compute. reflexivity.
Qed.
