(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Lemma 4.1.5: the convolution graph (thesis, Definition 4.1.2) decomposes into cycles that share
   no edge. *)
From Coq Require Import Lia Bool List Permutation.
From Oplus Require Import numbers convolution tracing balanced_graph.
Import ListNotations.

Open Scope nat_scope.

Definition vector_eq_dec (u v : vector) : {u = v} + {u <> v}.
Proof. decide equality; apply identical_dec. Defined.

(* The node of a point: coordinates in lowest terms, so that equal points have one node. *)
Definition node_of (v : vector) : vector := Vector (Qred (vx v)) (Qred (vy v)).

Lemma node_of_same u v : node_of u = node_of v <-> is_point u v = true.
Proof.
  unfold node_of, is_point. rewrite andb_true_iff, !Qeq_bool_iff. split.
  - intros e. injection e as ex ey.
    split; [rewrite <- (Qred_correct (vx u)), ex | rewrite <- (Qred_correct (vy u)), ey];
      apply Qred_correct.
  - intros [ex ey]. now rewrite (Qred_complete _ _ ex), (Qred_complete _ _ ey).
Qed.

Definition starts_at_node (s : (list vector * list vector) * named_segment) : vector :=
  node_of (starts_at s).
Definition ends_at_node (s : (list vector * list vector) * named_segment) : vector :=
  node_of (ends_at s).

Lemma count_at_node (point : (list vector * list vector) * named_segment -> vector) x l :
  count_occ vector_eq_dec (map (fun s => node_of (point s)) l) (node_of x) =
  count (fun s => is_point x (point s)) l.
Proof.
  rewrite count_occ_is_count. apply count_equally. intros s _.
  destruct (vector_eq_dec (node_of (point s)) (node_of x)) as [e | n]; symmetry.
  - apply node_of_same. now symmetry.
  - destruct (is_point x (point s)) eqn:e; trivial. apply node_of_same in e. congruence.
Qed.

Lemma count_elsewhere A (f : A -> vector) x l :
  (forall a, f a = node_of (f a)) -> x <> node_of x -> count_occ vector_eq_dec (map f l) x = 0.
Proof.
  intros reduced N. apply count_occ_not_In. intros I. apply in_map_iff in I.
  destruct I as (a & <- & _). now apply N.
Qed.

Lemma node_of_node v : node_of v = node_of (node_of v).
Proof.
  apply node_of_same. unfold is_point, node_of. cbn [vx vy].
  rewrite andb_true_iff, !Qeq_bool_iff. split; symmetry; apply Qred_correct.
Qed.

Lemma points_entered_as_left (p q : region) :
  (forall chain, In chain p -> no_edge_is_a_point chain) ->
  (forall chain, In chain q -> no_edge_is_a_point chain) ->
  entered_as_left vector_eq_dec starts_at_node ends_at_node (segments_of_regions p q).
Proof.
  intros ep eq x. destruct (vector_eq_dec x (node_of x)) as [-> | N].
  - unfold ends_at_node, starts_at_node. rewrite !count_at_node. now apply in_out_degree.
  - rewrite !count_elsewhere; trivial; intros; apply node_of_node.
Qed.

Lemma states_entered_as_left (p q : list vector) :
  no_edge_is_a_point p -> no_edge_is_a_point q ->
  entered_as_left state_eq_dec state_before (state_after (length p) (length q)) (convolution p q).
Proof. intros ep eq. exact (proj1 (Permutation_count_occ _ _ _) (Permutation_sym (states_permute p q ep eq))). Qed.

(* Lemma 4.1.5. The segments of the convolution of two regions are those of cycles, each segment in exactly
   one cycle, once. In a cycle each segment starts at the point where the one before it ends, the first
   where the last does, and no two start at the same point. *)
Theorem edge_disjoint_cycles (p q : region) :
  (forall chain, In chain p -> no_edge_is_a_point chain) ->
  (forall chain, In chain q -> no_edge_is_a_point chain) ->
  exists cycles,
    Forall (simple_cycle starts_at_node ends_at_node) cycles /\
    Permutation (concat cycles) (segments_of_regions p q).
Proof. intros ep eq. apply (falls_into_cycles vector_eq_dec). now apply points_entered_as_left. Qed.

(* The same in the fiber grid, where only equal states are one node. *)
Theorem edge_disjoint_cycles_of_states (p q : list vector) :
  no_edge_is_a_point p -> no_edge_is_a_point q ->
  exists cycles,
    Forall (simple_cycle state_before (state_after (length p) (length q))) cycles /\
    Permutation (concat cycles) (convolution p q).
Proof. intros ep eq. apply (falls_into_cycles state_eq_dec). now apply states_entered_as_left. Qed.

(* The segments of the convolution of two regions are also those of closed walks of which no two have a point
   in common, each segment in exactly one walk, once. As a closed walk is connected, and nothing joins two
   of them, each connected part of the graph has one: its Euler circuit. *)
Theorem euler_circuits_of_the_convolution (p q : region) :
  (forall chain, In chain p -> no_edge_is_a_point chain) ->
  (forall chain, In chain q -> no_edge_is_a_point chain) ->
  exists circuits, circuits_of starts_at_node ends_at_node circuits (segments_of_regions p q).
Proof. intros ep eq. apply (euler_circuits vector_eq_dec). now apply points_entered_as_left. Qed.

(* The same in the fiber grid. *)
Theorem euler_circuits_of_states (p q : list vector) :
  no_edge_is_a_point p -> no_edge_is_a_point q ->
  exists circuits,
    circuits_of state_before (state_after (length p) (length q)) circuits (convolution p q).
Proof. intros ep eq. apply (euler_circuits state_eq_dec). now apply states_entered_as_left. Qed.
