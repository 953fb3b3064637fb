(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* What is written of a set that ends at pieces, as canonical chains, is a valid region, which the test of regions
   accepts: so what oplus-proved writes, it reads. *)
From Coq Require Import QArith Lqa ZArith Lia Bool List Permutation SetoidList SetoidPermutation.
From Oplus Require Import specification regions_and_sums distinct simple_chain specification_bridge naive_collision
  collision_is_sound collision_is_complete
  placed_collision checked_collision filling kept_pieces_go_round edges_of_valid_regions rule_of_sides walks
  region_of_pieces sum_program sum_is_right inner_fit_program complement_in_a_frame touching_vertices simple_rings
  canonical_chains canonical_regions regions_by_rule sum_of_uncovered_pieces valid_regions_are_accepted
  beside_a_vertex clockwise_most_walks written_rings valid_components nested_chains nested_polygons.
Import ListNotations.

Open Scope Q_scope.

(* Validity is about edges, in any order. *)
Lemma same_edges_are_valid (r s : region) : Permutation (region_edges r) (region_edges s) ->
  valid_region r /\ nowhere_above_one r -> valid_region s /\ nowhere_above_one s.
Proof.
  intros edges_are [(not_points & not_negative & meet) above].
  assert (off_r : forall x, off x (region_edges s) -> off x (region_edges r))
    by (intros x free e E; exact (free e (Permutation_in _ edges_are E))).
  split; [split; [| split] |].
  - apply edges_are_no_points. intros e E.
    exact (region_edges_are_directions r not_points e (Permutation_in _ (Permutation_sym edges_are) E)).
  - intros x free. rewrite <- (permuted_winding_number x _ _ edges_are). auto.
  - apply edges_meet_by_pairs in meet. apply edges_meet_by_pairs.
    apply (pairs_permuted _ (meet_in_sources_swapped _) _ _ edges_are). refine (weaker_pairs _ _ _ _ meet).
    intros e f _ _ common w on_e on_f. destruct (common w on_e on_f) as (g & G & equal).
    exists g. split; [exact (Permutation_in _ edges_are G) | exact equal].
  - intros x free. rewrite <- (permuted_winding_number x _ _ edges_are). auto.
Qed.

Lemma cycles_permuted (l k : list segment) : Permutation l k -> cycles l -> cycles k.
Proof.
  intros permuted closed. unfold cycles in *.
  assert (same : forall f : segment -> vector, PermutationA equal_vectors (map f l) (map f k))
    by (intros f; apply Permutation_PermutationA; [exact equal_vectors_equivalence | now apply Permutation_map]).
  rewrite <- (same source), <- (same target). exact closed.
Qed.

Section Region.
  Variable segments : list segment.
  Variable inside : vector -> bool.
  Variable right_inside : segment -> bool.
  Let pieces := pieces_of segments.
  Hypothesis ends_ : ends_at_pieces inside right_inside pieces.
  Variable kept : list segment.
  Hypothesis kept_are : Permutation kept (kept_pieces right_inside pieces).

  Let chains := chains_of (length kept) kept.

  Lemma chains_take_kept : Permutation (region_edges chains) kept.
  Proof.
    apply chains_take_all; [lia |]. intros v. rewrite (surplus_permuted v _ _ kept_are).
    exact (kept_is_balanced segments inside right_inside ends_ v).
  Qed.

  Lemma kept_parts : share_ends_only kept.
  Proof.
    pose proof (kept_share_ends segments inside right_inside ends_) as parts.
    apply (some_directions _ parts); [exact (Permutation_NoDup (Permutation_sym kept_are) (are_distinct _ parts)) |].
    intros s S. apply (Permutation_in _ kept_are) in S. split; [now left |]. intros turned.
    apply (Permutation_in _ kept_are) in turned. now apply (not_turned _ parts s (reversed s)).
  Qed.

  Lemma kept_numbers (x : vector) : (0 <= winding_number x kept <= 1)%Z.
  Proof.
    rewrite (permuted_winding_number x _ _ kept_are). destruct (some_small _ (core _ _ _ ends_ x)) as (d & _ & ->).
    destruct (inside _); cbn; lia.
  Qed.

  Lemma chains_are_written_of_kept : valid_region chains /\ nowhere_above_one chains.
  Proof.
    split; [exact (chains_are_valid segments inside right_inside ends_ chains (Permutation_trans chains_take_kept
      kept_are)) |].
    intros x _. rewrite (permuted_winding_number x _ _ chains_take_kept). apply kept_numbers.
  Qed.

  Lemma sides_of_kept (e : segment) : In e kept -> winding_number_shifted (right_of_middle e) kept = 0%Z /\
    winding_number_shifted (right_of_middle (reversed e)) kept = 1%Z.
  Proof.
    intros E. destruct chains_are_written_of_kept as [valid above].
    assert (same : forall p, winding_number_shifted p kept = winding_number_shifted p (region_edges chains)).
    { intros p. apply balanced_edges.sum_of_permutation, Permutation_map, Permutation_sym, chains_take_kept. }
    rewrite !same. apply sides_of_an_edge; trivial; [now apply (Permutation_in _ (Permutation_sym chains_take_kept)) |].
    intros w inside_ (f & F & equal). apply (Permutation_in _ chains_take_kept) in F.
    destruct (segment_dec e f) as [<- | other].
    - exact (proj1 (ends_are_not_inside e w (are_long _ kept_parts e E) inside_) equal).
    - apply (nothing_inside _ kept_parts e f w E F other); [| exact inside_].
      apply (lies_on_equal (source f)); [now symmetry | apply source_lies_on].
  Qed.

  Lemma same_right_of_ring (ring : list vector) (part : list segment) (e f : segment) :
    In ring (rings_in_order chains) -> incl part kept -> cycles part -> In e (edges ring) -> In f (edges ring) ->
    winding_number_shifted (right_of_middle e) part = winding_number_shifted (right_of_middle f) part.
  Proof.
    intros I part_of closed E F. apply rings_of_chains in I. destruct I as (c & C & I).
    assert (in_chain : forall g, In g (edges ring) -> In g (edges c)).
    { intros g G. apply (Permutation_in _ (edges_of_a_rotation _ _ (canonical_start_is_a_rotation c))).
      apply (Permutation_in _ (rings_have_the_edges (canonical_start c) [])). apply in_flat_map. now exists ring. }
    apply (same_on_the_right kept kept_parts (cycles_permuted _ _ chains_take_kept (region_cycles chains)))
      with (chain := c); auto.
    - intros g G. exact (proj1 (sides_of_kept g G)).
    - intros g G. rewrite (proj2 (sides_of_kept g G)). discriminate.
  Qed.

  Lemma rings_take_kept : Permutation (region_edges (rings_in_order chains)) kept.
  Proof. rewrite rings_in_order_have_the_edges. exact chains_take_kept. Qed.

  Lemma rings_pass_once (ring : list vector) : In ring (rings_in_order chains) -> NoDup ring /\ ring <> [].
  Proof.
    intros I. apply rings_of_chains in I. destruct I as (c & _ & I).
    split; [exact (rings_are_simple _ [] ring (NoDup_nil _) I) | exact (rings_are_not_empty _ [] ring I)].
  Qed.

  (* Theorem. *)
  Theorem written_region_is_valid :
    valid_region (written_chains chains) /\ nowhere_above_one (written_chains chains).
  Proof.
    apply (same_edges_are_valid _ _ (Permutation_sym (written_chains_have_the_edges chains))).
    exact (canonical_chains_are_valid kept kept_parts kept_numbers _ rings_take_kept rings_pass_once
      same_right_of_ring).
  Qed.

  (* Theorem. And its chains are simple. *)
  Theorem written_chains_are_simple (c : list vector) : In c (written_chains chains) -> simple c.
  Proof.
    intros I. apply in_map_iff in I. destruct I as (ring & <- & I).
    destruct (written_ring_is_a_rotation ring) as (l & m & chain_is & ->). apply simple_turned. rewrite <- chain_is.
    exact (canonical_chains_are_simple kept kept_parts _ rings_take_kept rings_pass_once ring I).
  Qed.

  Let rings := rings_in_order chains.

  Lemma written_ring_is_alike (ring : list vector) (x : vector) : alike_from x (edges (written_ring ring)) (edges ring).
  Proof.
    apply (alike_transitive x _ (edges (canonical_chain ring))); [| apply canonical_chain_is_alike].
    apply alike_permuted, edges_of_a_rotation, written_ring_is_a_rotation.
  Qed.

  Lemma some_edge (ring : list vector) : In ring rings -> exists e, In e (edges ring).
  Proof.
    intros I. destruct (rings_pass_once ring I) as [_ some]. destruct ring as [| v ring]; [contradiction |].
    destruct (edge_from_vertex (v :: ring) v (or_introl eq_refl)) as (e & E & _). now exists e.
  Qed.

  Lemma edges_once : NoDup (region_edges rings).
  Proof. exact (Permutation_NoDup (Permutation_sym rings_take_kept) (are_distinct _ kept_parts)). Qed.

  Lemma rings_are_disjoint (A B : list vector) : In A rings -> In B rings -> A <> B ->
    forall e, In e (edges B) -> ~ In e (edges A).
  Proof. intros C D other e E F. apply other. exact (in_one_part edges rings e A B edges_once C D F E). Qed.

  Lemma edges_of_rings (A : list vector) : In A rings -> incl (edges A) kept.
  Proof. intros C e E. apply (Permutation_in _ rings_take_kept), in_flat_map. now exists A. Qed.

  Lemma written_rings_differ (A B : list vector) : In A rings -> In B rings -> written_ring A = written_ring B -> A = B.
  Proof.
    intros C D same. destruct (list_eq_dec vector_dec A B) as [| other]; [assumption | exfalso].
    destruct (some_edge A C) as (e & E). pose proof (middle_is_inside e) as inside_.
    assert (on : exists f, In f (edges B) /\ lies_on (middle e) f).
    { apply (proj1 (written_ring_is_alike B (middle e))). rewrite <- same. apply written_ring_is_alike.
      exists e. split; [exact E | now apply strictly_inside_lies_on]. }
    destruct on as (f & F & on). apply (nothing_inside _ kept_parts e f (middle e)); trivial.
    - exact (edges_of_rings A C e E).
    - exact (edges_of_rings B D f F).
    - intros ->. exact (rings_are_disjoint A B C D other f F E).
  Qed.

  (* Theorem. They do not cross. *)
  Theorem written_chains_do_not_cross : do_not_cross (written_chains chains).
  Proof.
    split; [| split; [exact written_chains_are_simple | split; [exact written_region_is_valid |]]].
    - apply NoDup_images; [| exact written_rings_differ].
      apply (parts_are_distinct edges); [exact edges_once |]. intros A C none.
      destruct (some_edge A C) as (e & E). now rewrite none in E.
    - intros a b A B other. apply in_map_iff in A, B. destruct A as (A & <- & C), B as (B & <- & D).
      assert (differ : A <> B) by congruence. pose proof (rings_are_disjoint A B C D differ) as disjoint. split.
      + intros p (s & S & on_s) (t & T & on_t).
        pose proof (edges_of_a_rotation _ _ (written_ring_is_a_rotation A)) as of_A.
        pose proof (edges_of_a_rotation _ _ (written_ring_is_a_rotation B)) as of_B.
        destruct (rings_meet_in_vertices kept kept_parts rings rings_take_kept rings_pass_once same_right_of_ring A B s
          t) with (w := p) as (u & U & equal); trivial;
          [now apply (Permutation_in _ of_A) | now apply (Permutation_in _ of_B) |].
        exists u. split; [| exact equal]. cbn in U. rewrite app_nil_r in U.
        apply (Permutation_in _ (Permutation_sym (Permutation_app of_A of_B)) U).
      + destruct (some_edge B D) as (k & K).
        assert (at_p : forall p, on_one_of p (edges (written_ring B)) -> off p (edges (written_ring A)) ->
          winding_number p (edges (written_ring A)) = winding_number_shifted (right_of_middle k) (edges A)).
        { intros p on free. rewrite (proj2 (written_ring_is_alike A p)).
          apply (number_all_along kept kept_parts rings rings_take_kept same_right_of_ring A B p k); trivial.
          - now apply (written_ring_is_alike B p).
          - intros e E on_e. destruct (proj2 (proj1 (written_ring_is_alike A p))) as (s & S & on_s); [now exists e |].
            exact (free s S on_s). }
        intros p q on_p free_p on_q free_q. now rewrite !at_p.
  Qed.
End Region.

(* What is written of a region is accepted, its chains are simple, and its polygons valid components. *)
Definition is_simple_chain (c : chain) : Prop := simple (map as_vector c).

Definition is_read_again (r : polygonal_region) : Prop :=
  let written := flat_map polygons.chains_of_polygon (canonical_polygons r) in
  covers_nothing_twice (as_region (prepared_region written)) = true /\
  (forall c, In c written -> is_simple_chain c) /\ valid_components (map component_of (canonical_polygons r)).

(* Theorem. *)
Theorem chains_of_kept_are_read_again (segments kept : list segment) (inside : vector -> bool)
  (right_inside : segment -> bool) : ends_at_pieces inside right_inside (pieces_of segments) ->
  Permutation kept (kept_pieces right_inside (pieces_of segments)) ->
  is_read_again (as_polygonal (chains_of (length kept) kept)).
Proof.
  intros ends_ kept_are. set (chains := chains_of (length kept) kept).
  assert (back : forall d, map as_vector (map as_point d) = d).
  { intros d. rewrite map_map. rewrite <- (map_id d) at 2. apply map_ext. now intros []. }
  assert (permuted : Permutation (as_polygonal (written_chains chains))
    (flat_map polygons.chains_of_polygon (canonical_polygons (as_polygonal chains)))).
  { symmetry. rewrite canonical_polygons_permute. unfold canonical_region, as_polygonal.
    now rewrite (map_map (map as_point)), (map_ext _ (fun c => c) back), map_id. }
  split; [| split].
  - destruct (written_region_is_valid segments inside right_inside ends_ kept kept_are) as [valid above].
    destruct (polygonal_is_valid _ valid above) as [valid' above'].
    destruct (same_edges_are_valid _ _ (Permutation_flat_map edges (Permutation_map _ permuted)) (conj valid' above')).
    now apply valid_regions_are_accepted.
  - intros c I. apply (Permutation_in _ (Permutation_sym permuted)), in_map_iff in I. destruct I as (d & <- & D).
    unfold is_simple_chain. rewrite back. exact (written_chains_are_simple segments inside right_inside ends_ kept
      kept_are d D).
  - unfold canonical_polygons, canonical_region, as_polygonal.
    rewrite (map_map (map as_point)), (map_ext _ (fun c => c) back), map_id. apply polygons_are_valid_components.
    rewrite (map_map (map as_point)), (map_ext _ (fun c => c) back), map_id.
    exact (written_chains_do_not_cross segments inside right_inside ends_ kept kept_are).
Qed.

(* Theorem. So are sums, and regions by a rule. *)
Theorem sums_are_read_again (p q : polygonal_region) : valid_region (as_region p) -> valid_region (as_region q) ->
  is_read_again (quick_sum p q).
Proof.
  intros p_valid q_valid.
  apply (chains_of_kept_are_read_again (convolution_segments (as_region p) (as_region q))
    (quick_filled (as_region p) (as_region q)) _ _ (filled_ends_at_pieces _ (all_are_long _ _ p_valid q_valid)
      (all_are_closed _ _ p_valid q_valid))).
  now apply quick_filled_is.
Qed.

Theorem regions_by_rule_are_read_again (rule : list Z -> bool) (families : list (list segment)) :
  (forall l, In l families -> cycles l) -> (forall t, In t (concat families) -> nonzero (along t)) ->
  rule (map (fun _ => 0%Z) families) = false -> is_read_again (region_by_rule rule families).
Proof.
  intros closed long_ nothing.
  exact (chains_of_kept_are_read_again (concat families) (boundary_by_rule rule families) _ _
    (rule_ends_at_pieces rule families closed long_ nothing) (Permutation_refl _)).
Qed.
