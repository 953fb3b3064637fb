(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Lemma 4.1.5 with connected parts, as its proof in the thesis has them: each connected part of a graph that enters
   each node as often as it leaves it has an Euler circuit, a closed walk that takes each of its edges once, no others.
   The circuits of balanced_graph.v are these: a walk is connected, and of two circuits that share no node no edge of
   the one meets an edge of the other. *)
From Coq Require Import List Permutation.
From Oplus Require Import convolution balanced_graph convolution_graph.
Import ListNotations.

Section parts.

Context {edge node : Type} (node_eq_dec : forall a b : node, {a = b} + {a <> b}) (source target : edge -> node).

(* Two edges meet if they have a node in common, whatever their directions. *)
Definition edges_meet (e f : edge) : Prop :=
  source e = source f \/ source e = target f \/ target e = source f \/ target e = target f.

(* From one edge to another one over edges that meet. *)
Inductive is_connected (edges : list edge) (e : edge) : edge -> Prop :=
| ConnectedToItself : is_connected edges e e
| ConnectedOver f g : is_connected edges e f -> In g edges -> edges_meet f g -> is_connected edges e g.

Lemma walks_are_connected edges e : forall walk before_ a b,
  incl walk edges -> is_connected edges e before_ -> target before_ = a -> leads source target a walk b ->
  forall f, In f walk -> is_connected edges e f.
Proof.
  induction walk as [| g walk IH]; intros before_ a b within_ so_far ends l f I; [destruct I |].
  destruct l as [from l].
  assert (here : is_connected edges e g).
  { apply (ConnectedOver _ _ before_); [exact so_far | apply within_; now left |].
    right. right. left. now rewrite ends, from. }
  destruct I as [<- | I]; [exact here |].
  now apply (IH g (target g) b (fun x X => within_ x (or_intror X)) here eq_refl l).
Qed.

(* A closed walk leaves both nodes of each of its edges. *)
Lemma both_nodes_are_left walk e node_ : closed_walk_of_edges source target walk -> In e walk ->
  source e = node_ \/ target e = node_ -> exists f, In f walk /\ source f = node_.
Proof.
  intros w I [at_source | at_target]; [now exists e |].
  destruct (started_at source target walk e w I) as ([| f rest] & all & _ & l).
  - exists e. split; [exact I |]. cbn in l. congruence.
  - exists f. split; [apply (Permutation_in _ all); cbn; tauto |]. destruct l as [from _]. congruence.
Qed.

(* Theorem. A circuit is a connected part: the edges that are connected to one of its edges, and no others. *)
Theorem circuits_are_connected_parts circuits edges circuit e f :
  circuits_of source target circuits edges -> In circuit circuits -> In e circuit ->
  In f circuit <-> is_connected edges e f.
Proof.
  intros (walks & apart & all) C E. pose proof (proj1 (Forall_forall _ _) walks) as each.
  assert (within_ : incl circuit edges).
  { intros g G. apply (Permutation_in _ all), in_concat. now exists circuit. }
  split.
  - intros F. destruct (started_at source target circuit e (each _ C) E) as (rest & same_ & l).
    apply (Permutation_in _ (Permutation_sym same_)) in F. destruct F as [<- | F]; [constructor |].
    destruct l as [_ l]. apply (walks_are_connected edges e rest e (target e) (source e)); trivial; [| constructor].
    intros g G. apply within_, (Permutation_in _ same_). now right.
  - intros connected. induction connected as [| f g _ F G meet]; [exact E |].
    apply (Permutation_in _ (Permutation_sym all)), in_concat in G. destruct G as (other & O & G).
    destruct (ForallOrdPairs_In apart circuit other C O) as [<- | no]; [exact G | exfalso].
    assert (node_ : exists x, (source f = x \/ target f = x) /\ (source g = x \/ target g = x)).
    { destruct meet as [m | [m | [m | m]]];
        [exists (source f) | exists (source f) | exists (target f) | exists (target f)];
        rewrite m; tauto. }
    destruct node_ as (x & of_f & of_g).
    destruct (both_nodes_are_left circuit f x (each _ C) F of_f) as (f' & F' & from).
    destruct (both_nodes_are_left other g x (each _ O) G of_g) as (g' & G' & from').
    destruct no as [no | no]; [apply (no f' g') | apply (no g' f')]; congruence.
Qed.

(* Theorem. Each connected part has an Euler circuit; the other edges are those of other parts. *)
Theorem connected_parts_have_circuits edges e :
  entered_as_left node_eq_dec source target edges -> In e edges ->
  exists circuit others, closed_walk_of_edges source target circuit /\ Permutation (circuit ++ others) edges /\
    (forall f, In f circuit <-> is_connected edges e f) /\ (forall f, In f others -> ~ is_connected edges e f).
Proof.
  intros balanced_ I. destruct (euler_circuits node_eq_dec source target edges balanced_) as (circuits & good).
  destruct (good) as (walks & apart & all).
  apply (Permutation_in _ (Permutation_sym all)), in_concat in I. destruct I as (circuit & C & E).
  pose proof (fun f => circuits_are_connected_parts circuits edges circuit e f good C E) as part.
  pose proof (in_split _ _ C) as (front & back & split_). exists circuit, (concat (front ++ back)).
  rewrite Forall_forall in walks. split; [now apply walks |]. split; [| split; [exact part |]].
  - rewrite <- all, split_, !concat_app. cbn [concat]. rewrite !app_assoc. apply Permutation_app_tail.
    apply Permutation_app_comm.
  - intros f F connected. apply part in connected. apply in_concat in F. destruct F as (other & O & F).
    rewrite split_ in apart. assert (no : no_common_node source circuit other \/ no_common_node source other circuit).
    { clear - apart O. induction front as [| c front IH]; cbn in *; inversion apart as [| ? ? with_c others]; subst.
      - left. rewrite Forall_forall in with_c. now apply with_c.
      - destruct O as [-> | O]; [| now apply IH]. right. rewrite Forall_forall in with_c.
        apply with_c, in_app_iff. right. now left. }
    destruct no as [no | no]; now apply (no f f).
Qed.

End parts.

(* Theorem, Lemma 4.1.5 with connected parts. Each connected part of the convolution graph of two regions has an Euler
   circuit: a closed walk along its segments, each taken once, and no others. *)
Theorem euler_circuit_of_a_connected_part (p q : region) e :
  (forall chain, In chain p -> no_edge_is_a_point chain) ->
  (forall chain, In chain q -> no_edge_is_a_point chain) -> In e (segments_of_regions p q) ->
  exists circuit others, closed_walk_of_edges starts_at_node ends_at_node circuit /\
    Permutation (circuit ++ others) (segments_of_regions p q) /\
    (forall f, In f circuit <-> is_connected starts_at_node ends_at_node (segments_of_regions p q) e f) /\
    (forall f, In f others -> ~ is_connected starts_at_node ends_at_node (segments_of_regions p q) e f).
Proof.
  intros p_edges q_edges. apply (connected_parts_have_circuits vector_eq_dec). now apply points_entered_as_left.
Qed.

(* Theorem. The same in the fiber grid of two closed chains. *)
Theorem euler_circuit_of_connected_states (p q : list vector) e :
  no_edge_is_a_point p -> no_edge_is_a_point q -> In e (convolution p q) ->
  let after := state_after (length p) (length q) in
  exists circuit others, closed_walk_of_edges state_before after circuit /\
    Permutation (circuit ++ others) (convolution p q) /\
    (forall f, In f circuit <-> is_connected state_before after (convolution p q) e f) /\
    (forall f, In f others -> ~ is_connected state_before after (convolution p q) e f).
Proof.
  intros p_edges q_edges. apply (connected_parts_have_circuits state_eq_dec). now apply states_entered_as_left.
Qed.
