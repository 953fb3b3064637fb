(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Valid regions (thesis, Definition 2.1.17), as reference/chains/validity.cpp asks for them, defined by points.
   A chain is simple (simple_chain.v); chains may touch in vertices, but neither cross nor overlap; holes are
   inside their outer chain and not inside each other, and of two components none is inside the other. *)
From Coq Require Import ZArith Bool List.
From Oplus Require Import numbers convolution simple_chain simple_chains_turn_once.
Import ListNotations.

(* Points of the boundary. *)
Definition on_one_of (p : vector) (segments : list segment) : Prop :=
  exists s, In s segments /\ lies_on p s.

(* Where segments of the two have a point in common, it is an end of one. *)
Definition meet_in_ends_only (some others : list segment) : Prop :=
  forall p, on_one_of p some -> on_one_of p others ->
    exists s, In s (some ++ others) /\ equal_vectors p (source s).

(* p is neither on them nor do they wind around it. *)
Definition is_outside (p : vector) (segments : list segment) : Prop :=
  off p segments /\ winding_number p segments = 0%Z.

(* Neither has a point of its boundary inside the other; they may touch. *)
Definition beside_each_other (some others : list segment) : Prop :=
  meet_in_ends_only some others /\
  (forall p, on_one_of p some -> off p others -> is_outside p others) /\
  (forall p, on_one_of p others -> off p some -> is_outside p some).

(* The boundary of `inner` is inside `around`, or touches it, and that of `around` is not inside `inner`. *)
Definition is_inside (inner around : list segment) : Prop :=
  meet_in_ends_only inner around /\
  (forall p, on_one_of p inner -> off p around -> ~ is_outside p around) /\
  (forall p, on_one_of p around -> off p inner -> is_outside p inner).

(* A component: an outer chain, counterclockwise, and holes, clockwise. *)
Record component := Component { outer_chain : list vector; hole_chains : list (list vector) }.

Definition chains_of_component (c : component) : list (list vector) := outer_chain c :: hole_chains c.
Definition edges_of_component (c : component) : list segment := flat_map edges (chains_of_component c).

Definition valid_component (c : component) : Prop :=
  simple (outer_chain c) /\ is_counterclockwise (outer_chain c) = true /\
  (forall h, In h (hole_chains c) ->
     simple h /\ is_counterclockwise h = false /\ is_inside (edges h) (edges (outer_chain c))) /\
  ForallOrdPairs (fun g h => beside_each_other (edges g) (edges h)) (hole_chains c).

Definition valid_components (components : list component) : Prop :=
  (forall c, In c components -> valid_component c) /\
  ForallOrdPairs (fun b c => beside_each_other (edges_of_component b) (edges_of_component c)) components.

(* Its chains, and their edges. *)
Definition region_of (components : list component) : region := flat_map chains_of_component components.
Definition edges_of_components (components : list component) : list segment :=
  flat_map edges_of_component components.

Lemma chains_of_valid_regions_are_simple (components : list component) (chain : list vector) :
  valid_components components -> In chain (region_of components) -> simple chain.
Proof.
  intros [each _] I. apply in_flat_map in I. destruct I as (c & C & I).
  destruct (each c C) as (outer_simple & _ & holes_valid & _).
  destruct I as [<- | I]; [exact outer_simple | now apply holes_valid].
Qed.
