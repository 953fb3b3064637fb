(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Corollary 3.1.3 as it holds: the boundary of the sum is weakly simple chains, and each of them bounds one face. The
   chains are walks along the boundary around faces (walks_around_faces.v). *)
From Coq Require Import QArith Lqa ZArith Lia Bool List Permutation.
From Oplus Require Import regions_and_sums connected_sets theorem_2_2_10 lemma_2_2_2 filling naive_collision
  collision_is_sound beside_a_piece just_right_of_a_piece printed_lemma_2_2_2 refuted_definition_2_1_9
  refuted_corollary_3_1_3 loops_of_the_boundary algorithm_1 what_algorithm_1_traces connected_beside_pieces
  walks_around_faces.
Import ListNotations.

Open Scope Q_scope.

(* Theorem, Corollary 3.1.3 as corrected: the boundary of the sum is weakly simple chains, each all on the boundary of
   one face; and where the boundary of a face has a point inside an edge of a chain, all of the chain is on it. *)
Theorem corollary_3_1_3_for_each_chain (p q : region) : valid_region p -> valid_region q ->
  exists chains : list (list vector),
    (forall chain, In chain chains -> weakly_simple chain) /\
    (forall x, on_boundary_of_sum x p q <-> on_boundary x chains) /\
    (forall chain, In chain chains -> exists a, inner_point_of_sum a p q /\
       forall x, on_boundary x [chain] -> on_boundary_of_set (face_of_the_sum p q a) x) /\
    (forall chain e x a, In chain chains -> In e (edges chain) -> strictly_inside x e ->
       on_boundary_of_set (face_of_the_sum p q a) x ->
       forall y, on_boundary y [chain] -> on_boundary_of_set (face_of_the_sum p q a) y).
Proof.
  intros p_region q_region. set (way := map reversed (filled (convolution_segments p q))).
  exists (map (map source) (algorithm_1 way)).
  pose proof (boundary_loops_are_loops_of_the_sum p q p_region q_region) as loops_.
  destruct (traced_loops way way []) as (are_loops & _ & _); [constructor | intros g [] | apply incl_refl |].
  fold (algorithm_1 way) in are_loops.
  assert (on_chain : forall loop y, In loop (algorithm_1 way) -> on_boundary y [map source loop] ->
    exists e, In e loop /\ lies_on y e).
  { intros loop y L (e & E & on). cbn [region_edges flat_map] in E. rewrite app_nil_r in E.
    rewrite (edges_of_a_walk way loop (are_loops loop L)) in E. now exists e. }
  assert (one_face : forall loop e f a, In loop (algorithm_1 way) -> In e loop -> In f loop ->
    face_of_the_sum p q a (just_right_of (filled (convolution_segments p q)) e) ->
    face_of_the_sum p q a (just_right_of (filled (convolution_segments p q)) f)).
  { intros loop e f a L E F face_. destruct (are_loops loop L) as (some & _ & part & leads).
    destruct loop as [| h l]; [contradiction |]. cbn [hd_error] in leads.
    pose proof (one_face_along p q p_region q_region l h (Some h) part leads) as from_first.
    apply (connected_on _ _ _ _ face_). destruct face_ as (path & walk).
    apply (connected_inside p q p_region q_region);
      [exact (connected_on _ _ _ _ (connected_back _ _ _ (from_first e E)) (from_first f F)) |].
    exact (leads_to_a_point _ _ _ _ walk). }
  split; [| split; [| split]].
  - intros chain C. apply in_map_iff in C. destruct C as (loop & <- & L).
    exact (walks_are_weakly_simple p q p_region q_region loop (are_loops loop L)).
  - intros x. rewrite (boundary_is_kept p q _ _ _ loops_ x). split.
    + intros (e & E & on). assert (W : In (reversed e) way) by now apply in_map.
      apply (all_turns_are_traced p q p_region q_region), in_concat in W. destruct W as (loop & L & W).
      exists (reversed e). split.
      * apply in_flat_map. exists (map source loop). split; [now apply in_map |].
        now rewrite (edges_of_a_walk way loop (are_loops loop L)).
      * destruct on as (k & range & X & Y). exists (1 - k). cbn [reversed source target]. split; [lra |].
        rewrite X, Y. split; ring.
    + intros (e & E & on). apply in_flat_map in E. destruct E as (chain & C & E). apply in_map_iff in C.
      destruct C as (loop & <- & L). rewrite (edges_of_a_walk way loop (are_loops loop L)) in E.
      exists (reversed e). split; [apply the_other_way_is; now apply (are_loops loop L) |].
      destruct on as (k & range & X & Y). exists (1 - k). cbn [reversed source target]. split; [lra |].
      rewrite X, Y. split; ring.
  - intros chain C. apply in_map_iff in C. destruct C as (loop & <- & L). pose proof (are_loops loop L) as traced.
    destruct traced as (some & _ & part & _). destruct loop as [| e l]; [contradiction |].
    assert (E : In e (e :: l)) by now left. pose proof (part e E) as W.
    destruct (close_to_the_right p q p_region q_region e (middle e) 1 W (middle_is_inside e) ltac:(lra))
      as (a & _ & _ & connected & inner).
    exists a. split; [exact inner |]. intros x on. destruct (on_chain _ x L on) as (f & F & on_f).
    apply (edge_of_the_face p q p_region q_region a f x (part f F) on_f), (one_face (e :: l) e f a L E F).
    exact (connected_inside p q p_region q_region a _ connected inner).
  - intros chain e x a C E inside_ boundary y on. apply in_map_iff in C. destruct C as (loop & <- & L).
    pose proof (are_loops loop L) as (_ & _ & part & _).
    rewrite (edges_of_a_walk way loop (are_loops loop L)) in E. destruct (on_chain _ y L on) as (f & F & on_f).
    apply (edge_of_the_face p q p_region q_region a f y (part f F) on_f), (one_face loop e f a L E F).
    exact (face_of_the_edge p q p_region q_region a e x (part e E) inside_ boundary).
Qed.
