(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Two edges of a valid region have no point in common but vertices of it, whether they are of one chain, of two, or
   of two components. Valid regions are in valid_components.v. *)
From Coq Require Import Lia Bool List.
From Oplus Require Import numbers convolution regions simple_chain simple_chains_turn_once valid_components
  winding_numbers_of_valid_regions.
Import ListNotations.

Open Scope nat_scope.

(* What two edges have in common are vertices, the sources of edges. *)
Definition meet_in_sources (all : list segment) (s t : segment) : Prop :=
  forall w, lies_on w s -> lies_on w t -> exists u, In u all /\ equal_vectors w (source u).

Section Pairs.
Context {A B : Type}.
Variable related : A -> A -> Prop.

Lemma pairs_of_two_lists some others :
  ForallOrdPairs related some -> ForallOrdPairs related others ->
  (forall a b, In a some -> In b others -> related a b) -> ForallOrdPairs related (some ++ others).
Proof.
  intros pairs_some pairs_others across. induction pairs_some as [| a some first pairs_some IH];
    [exact pairs_others |]. cbn [app]. constructor.
  - apply Forall_app. split; [exact first |]. apply Forall_forall. intros b I. apply across; [now left | exact I].
  - apply IH. intros b c I J. apply across; [now right | exact J].
Qed.

Lemma pairs_of_parts (f : B -> list A) (l : list B) :
  (forall b, In b l -> ForallOrdPairs related (f b)) ->
  ForallOrdPairs (fun b c => forall s t, In s (f b) -> In t (f c) -> related s t) l ->
  ForallOrdPairs related (flat_map f l).
Proof.
  intros each across. induction across as [| b l first across IH]; [constructor |]. cbn [flat_map].
  apply pairs_of_two_lists; [apply each; now left | apply IH; intros c I; apply each; now right |].
  intros s t S T. apply in_flat_map in T. destruct T as (c & C & T).
  rewrite Forall_forall in first. now apply (first c C).
Qed.

Lemma pairs_by_index (none : A) (l : list A) :
  (forall i j, i < j -> j < length l -> related (nth i l none) (nth j l none)) -> ForallOrdPairs related l.
Proof.
  induction l as [| a l IH]; intros each; constructor.
  - apply Forall_forall. intros b I. apply (In_nth _ _ none) in I. destruct I as (j & J & <-).
    apply (each 0 (S j)); cbn [length]; lia.
  - apply IH. intros i j L J. apply (each (S i) (S j)); cbn [length]; lia.
Qed.

End Pairs.

Lemma weaker_pairs {A : Type} (P Q : A -> A -> Prop) (l : list A) :
  (forall a b, In a l -> In b l -> P a b -> Q a b) -> ForallOrdPairs P l -> ForallOrdPairs Q l.
Proof.
  intros weaker pairs. induction pairs as [| a l first pairs IH]; constructor.
  - rewrite Forall_forall in *. intros b I. apply weaker; [now left | now right | now apply first].
  - apply IH. intros b c I J. apply weaker; now right.
Qed.

Lemma edges_of_one_chain (all : list segment) (chain : list vector) :
  simple chain -> incl (edges chain) all -> ForallOrdPairs (meet_in_sources all) (edges chain).
Proof.
  intros chain_simple among. apply (pairs_by_index _ (no_segment)).
  pose proof (edges_are_as_many chain) as long.
  rewrite long. intros i j L J w on_i on_j.
  assert (at_vertex : forall k, k < length chain -> equal_vectors w (vertex chain k) ->
    exists u, In u all /\ equal_vectors w (source u)).
  { intros k K w_is. exists (edge_at chain k). split.
    - apply among. unfold edge_at. apply nth_In. now rewrite long.
    - now rewrite edge_is by exact K. }
  destruct chain_simple as (_ & _ & common).
  destruct (common i j w) as [[_ w_is] | [_ w_is]]; try lia; trivial.
  - now apply (at_vertex j).
  - apply (at_vertex i); [lia | exact w_is].
Qed.

Lemma ends_among (all some others : list segment) :
  incl some all -> incl others all -> meet_in_ends_only some others ->
  forall s t, In s some -> In t others -> meet_in_sources all s t.
Proof.
  intros among_some among_others ends_only s t I J w on_s on_t.
  destruct (ends_only w) as (u & U & w_is); [now exists s | now exists t |].
  exists u. split; [| exact w_is]. apply in_app_iff in U. destruct U; auto.
Qed.

Lemma meet_in_sources_swapped all s t : meet_in_sources all s t -> meet_in_sources all t s.
Proof. intros meet w on_t on_s. now apply meet. Qed.

Lemma edges_of_one_component (all : list segment) (c : component) :
  valid_component c -> incl (edges_of_component c) all ->
  ForallOrdPairs (meet_in_sources all) (edges_of_component c).
Proof.
  intros (outer_simple & _ & holes_valid & beside) among. unfold edges_of_component in *.
  assert (chain_among : forall chain, In chain (chains_of_component c) -> incl (edges chain) all)
    by (intros chain I s S; apply among, in_flat_map; now exists chain).
  apply pairs_of_parts.
  - intros chain I. apply edges_of_one_chain; [| now apply chain_among].
    destruct I as [<- | I]; [exact outer_simple | now apply holes_valid].
  - unfold chains_of_component. constructor.
    + apply Forall_forall. intros h I s t S T. apply meet_in_sources_swapped.
      destruct (holes_valid h I) as (_ & _ & ends_only & _).
      apply (ends_among all (edges h) (edges (outer_chain c))); trivial; apply chain_among;
        [now right | now left].
    + apply (weaker_pairs (fun g h => beside_each_other (edges g) (edges h))); [| exact beside].
      intros g h I J (ends_only & _). apply ends_among; trivial; apply chain_among; now right.
Qed.

(* Theorem. In the list of all edges of a valid region, a point that is on two of them is a vertex. *)
Theorem edges_of_valid_regions_meet_in_vertices (components : list component) earlier s later t w :
  valid_components components ->
  flat_map edges (region_of components) = earlier ++ s :: later -> In t (earlier ++ later) ->
  lies_on w s -> lies_on w t ->
  exists u, In u (flat_map edges (region_of components)) /\ equal_vectors w (source u).
Proof.
  intros [each beside] split_ T on_s on_t.
  assert (pairs : ForallOrdPairs (meet_in_sources (edges_of_components components)) (edges_of_components components)).
  { assert (among : forall c, In c components -> incl (edges_of_component c) (edges_of_components components))
      by (intros c I e E; apply in_flat_map; now exists c).
    unfold edges_of_components at 2. apply pairs_of_parts.
    - intros c I. apply edges_of_one_component; [now apply each | now apply among].
    - apply (weaker_pairs (fun b c => beside_each_other (edges_of_component b) (edges_of_component c)));
        [| exact beside].
      intros b c I J (ends_only & _). apply ends_among; trivial; now apply among. }
  rewrite edges_of_region_are_its_chains in pairs. rewrite split_ in pairs at 2.
  destruct (pair_at _ _ _ _ _ pairs T) as [meet | meet]; now apply meet.
Qed.

(* No edge of it is a point. *)
Lemma valid_regions_have_edges (components : list component) (chain : list vector) :
  valid_components components -> In chain (region_of components) -> no_edge_is_a_point chain.
Proof.
  intros valid I. now destruct (chains_of_valid_regions_are_simple components chain valid I) as (_ & has_edges & _).
Qed.
