(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Lemma 4.1.3 as printed: at each state (i, j) to which Algorithm 2 comes along a convolution segment, (1) a
   convolution segment leaves the state; (2) two do, to (i+1, j) and to (i, j+1), if and only if two lead to it, from
   (i-1, j) and from (i, j-1). Indices are cyclic. It is proved in states.v, for all closed chains without edges that
   are points. *)
From Coq Require Import List.
From Oplus Require Import convolution polygons_of_the_thesis drawn_regions.
Import ListNotations.

Open Scope nat_scope.

(* The convolution segment from (i, j) along P's edge or Q's edge exists; so does that to (i, j). *)
Definition segment_leaves (p q : list vector) (along_ : summand) (at_ : state) : Prop :=
  in_convolution p q (along_, at_) = true.
Definition segment_leads_to (p q : list vector) (along_ : summand) (at_ : state) : Prop :=
  in_convolution p q (segment_to (length p) (length q) along_ at_) = true.

(* Theorem, Lemma 4.1.3. *)
Theorem lemma_4_1_3_as_printed (p q : list vector) (i j : nat) :
  no_edge_is_a_point p -> no_edge_is_a_point q -> i < length p -> j < length q ->
  (exists along_, segment_leads_to p q along_ (i, j)) ->
  (exists along_, segment_leaves p q along_ (i, j)) /\
  (segment_leaves p q OfP (i, j) /\ segment_leaves p q OfQ (i, j) <->
   segment_leads_to p q OfP (i, j) /\ segment_leads_to p q OfQ (i, j)).
Proof.
  intros p_edges q_edges I J (along_ & leads).
  destruct (forward_traversal_of_states p q (i, j) p_edges q_edges) as [goes_on two]; [now split |].
  split; [| exact two].
  destruct goes_on as [along_p | along_q]; [destruct along_; [now left | now right] | now exists OfP | now exists OfQ].
Qed.

(* Two rooms: at the inner corner (6, 5) of one and (1, 1) of the other both segments leave, so both lead there. *)
Example opposite_inner_corners : segment_leads_to room room OfP (5, 7) /\ segment_leads_to room room OfQ (5, 7).
Proof.
  assert (edges_ : no_edge_is_a_point room)
    by (apply (simple_polygons_are_regions room); [apply drawn_polygons | now left]).
  apply (lemma_4_1_3_as_printed room room 5 7); trivial.
  - cbn. repeat constructor.
  - cbn. repeat constructor.
  - exists OfP. vm_compute. reflexivity.
  - split; vm_compute; reflexivity.
Qed.
