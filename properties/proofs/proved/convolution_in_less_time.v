(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The segments of the convolution of two regions, where each edge and corner is computed once: the same list. *)
From Coq Require Import QArith Bool List.
From Oplus Require Import convolution fiber_grid states in_out_degree convolution_winding.
Import ListNotations.

(* A vertex, the next one, the edge between them, and the corner at the first. *)
Record vertex_data := VertexData { here : vector; there : vector; edge_there : vector; corner_here : corner }.

Definition vertex_data_of (chain : list vector) (i : nat) : vertex_data :=
  VertexData (nth i chain nowhere) (nth (next i (length chain)) chain nowhere) (edge_of_chain chain i)
    (corner_of_chain chain i).

Definition data_of (chain : list vector) : list vertex_data :=
  map (vertex_data_of chain) (seq 0 (length chain)).

Definition segment_along_p (a b : vertex_data) : list segment :=
  if in_tangent_set (Direction (edge_there a) OfP) (corner_here b)
  then [Segment (plus (here a) (here b)) (plus (there a) (here b))] else [].

Definition segment_along_q (a b : vertex_data) : list segment :=
  if in_tangent_set (Direction (edge_there b) OfQ) (corner_here a)
  then [Segment (plus (here a) (here b)) (plus (here a) (there b))] else [].

Definition for_all_pairs {A B C : Type} (f : A -> B -> list C) (l : list A) (m : list B) : list C :=
  flat_map (fun a => flat_map (f a) m) l.

Definition quick_convolution (p q : region) : list segment :=
  for_all_pairs (fun a b => for_all_pairs segment_along_p a b ++ for_all_pairs segment_along_q a b)
    (map data_of p) (map data_of q).

Lemma pairs_of_product (A B C : Type) (f : A * B -> list C) (l : list A) (m : list B) :
  flat_map f (list_prod l m) = for_all_pairs (fun a b => f (a, b)) l m.
Proof.
  unfold for_all_pairs. induction l as [| a l IH]; [reflexivity |]. cbn [list_prod flat_map].
  rewrite flat_map_app, IH, !flat_map_concat_map, map_map. reflexivity.
Qed.

Lemma pairs_of_images (A B C D F : Type) (f : C -> D -> list F) (g : A -> C) (h : B -> D) (l : list A)
  (m : list B) :
  for_all_pairs f (map g l) (map h m) = for_all_pairs (fun a b => f (g a) (h b)) l m.
Proof.
  unfold for_all_pairs. rewrite flat_map_concat_map, map_map, <- flat_map_concat_map. apply flat_map_ext. intros a.
  now rewrite flat_map_concat_map, map_map, <- flat_map_concat_map.
Qed.

Lemma filtered_images (A B C : Type) (f : B -> bool) (g : B -> C) (h : A -> B) (l : list A) :
  map g (filter f (map h l)) = flat_map (fun a => if f (h a) then [g (h a)] else []) l.
Proof. induction l as [| a l IH]; [reflexivity |]. cbn. destruct (f (h a)); cbn; now rewrite IH. Qed.

(* Theorem. It is the same list. *)
Theorem quick_convolution_is (p q : region) : quick_convolution p q = convolution_segments p q.
Proof.
  unfold quick_convolution, convolution_segments, segments_of_regions.
  rewrite pairs_of_images, flat_map_concat_map, concat_map, map_map, <- flat_map_concat_map, pairs_of_product.
  unfold for_all_pairs at 1 4. apply flat_map_ext. intros a. apply flat_map_ext. intros b.
  rewrite map_map. unfold convolution. cbn [list_prod]. rewrite app_nil_r, filter_app, map_app.
  now rewrite !filtered_images, !pairs_of_product; unfold data_of; rewrite !pairs_of_images.
Qed.
