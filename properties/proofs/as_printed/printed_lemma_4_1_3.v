(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Lemma 4.1.3 as printed: at each state (i, j) to which Algorithm 2 comes along a convolution segment, (1) a
   convolution segment leaves the state; (2) two do, to (i+1, j) and to (i, j+1), if and only if two lead to it, from
   (i-1, j) and from (i, j-1). Indices are cyclic. It is proved in states.v, for all closed chains without edges that
   are points. *)
From Coq Require Import List.
From Oplus Require Import convolution polygons_of_the_thesis.
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
