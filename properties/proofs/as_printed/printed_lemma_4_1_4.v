(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Lemma 4.1.4 as printed: at each vertex of the convolution graph (Definition 4.1.2), which is a point, as many
   convolution segments end as start. It is proved in in_out_degree.v, for polygons of any number of chains. *)
From Coq Require Import List.
From Oplus Require Import numbers convolution regions.
Import ListNotations.

Definition indegree (p q : region) (x : vector) : nat :=
  count (fun s => is_point x (ends_at s)) (segments_of_regions p q).
Definition outdegree (p q : region) (x : vector) : nat :=
  count (fun s => is_point x (starts_at s)) (segments_of_regions p q).

(* Theorem, Lemma 4.1.4. *)
Theorem lemma_4_1_4_as_printed (p q : region) (x : vector) :
  no_edges_are_points p -> no_edges_are_points q -> indegree p q x = outdegree p q x.
Proof. exact (in_out_degree p q x). Qed.
