(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* What is written of a set that ends at pieces, as canonical chains, is a valid region, which the test of regions
   accepts: so what oplus-proved writes, it reads. *)
From Coq Require Import QArith Lqa ZArith Lia Bool List Permutation SetoidList SetoidPermutation.
From Oplus Require Import specification checker balanced_edges convolution convolution_winding direction angle
  angular_crossings winding_number shifted_ray small_numbers rotation in_out_degree simple_chain
  simple_chains_turn_once regions meeting_of_segments winding_number_of_the_sum interiors_meet neighbourhoods
  left_of_an_edge theorem_4_2_1 observation_2_2_4 homogeneous_points specification_bridge location pieces
  naive_collision collision_is_sound collision_is_complete checked_collision beside_a_piece filling cut_pieces
  kept_pieces_go_round kept_pieces_balance rule_of_sides walks region_of_pieces sum_program sum_is_right
  inner_fit_program placed_collision complement_in_a_frame touching_vertices simple_rings canonical_chains
  canonical_regions regions_by_rule sum_of_uncovered_pieces valid_regions_are_accepted beside_a_vertex clockwise_most_walks
  written_rings.
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
  - apply edges_meet_by_pairs in meet. apply edges_meet_by_pairs. apply (each_two_permuted _ _ _ edges_are).
    intros before e after f is_ F w on_e on_f. destruct (meet before e after f is_ F w on_e on_f) as (g & G & equal).
    exists g. split; [exact (Permutation_in _ edges_are G) | exact equal].
  - intros x free. rewrite <- (permuted_winding_number x _ _ edges_are). auto.
Qed.

Lemma simple_turned (l : list vector) : forall m, simple (l ++ m) -> simple (m ++ l).
Proof.
  induction l as [| a l IH]; intros m is_simple; [now rewrite app_nil_r |].
  apply simple_rotated in is_simple. cbn [app rotated] in is_simple. rewrite <- app_assoc in is_simple.
  apply IH in is_simple. now rewrite <- app_assoc in is_simple.
Qed.

Section Region.
  Variable segments : list segment.
  Hypothesis all_long : forall t, In t segments -> nonzero (along t).
  Variable inside : vector -> bool.
  Variable right_inside : segment -> bool.
  Let pieces := pieces_of segments.
  Hypothesis ends_ : ends_at_pieces inside right_inside pieces.
  Variable kept : list segment.
  Hypothesis kept_are : Permutation kept (kept_pieces right_inside pieces).

  Lemma of_a_piece (e : segment) : In e kept -> exists f, In f pieces /\ (e = f \/ e = reversed f) /\
    right_inside (reversed e) = true /\ right_inside e = false.
  Proof.
    intros E. apply (Permutation_in _ kept_are), in_flat_map in E. destruct E as (f & F & E). exists f.
    split; [exact F |]. unfold kept_piece in E. destruct (right_inside (reversed f)) eqn:left_, (right_inside f)
      eqn:right_;
      try destruct E as [<- | []]; try destruct E; rewrite ?reversed_twice; tauto.
  Qed.

  Lemma kept_end (e : segment) (v : vector) : In e kept -> v = source e \/ v = target e ->
    exists f, In f pieces /\ (v = source f \/ v = target f) /\ is_reduced v.
  Proof.
    intros E which. destruct (of_a_piece e E) as (f & F & is_f & _). exists f. split; [exact F |].
    destruct (ends_are_reduced segments all_long f F).
    destruct is_f as [-> | ->]; cbn [reversed source target] in which; destruct which as [-> | ->]; tauto.
  Qed.

  Lemma kept_long (e : segment) : In e kept -> nonzero (along e).
  Proof. intros E. exact (kept_is_long segments inside right_inside ends_ e (Permutation_in _ kept_are E)). Qed.

  Lemma kept_apart (e f : segment) (w : vector) : In e kept -> In f kept -> e <> f -> lies_on w f -> ~
    strictly_inside w e.
  Proof.
    intros E F differ on inside_e. destruct (inside_or_end w f on) as [inside_f | end_].
    - exact (different_kept segments all_long right_inside e f (Permutation_in _ kept_are E) (Permutation_in _
      kept_are F)
        differ w inside_e inside_f).
    - assert (exists v, (v = source f \/ v = target f) /\ equal_vectors v w) as (v & which & X & Y)
        by (destruct end_; eexists; (split; [| eassumption]); tauto).
      destruct (kept_end f v F which) as (g & G & end_of_g & _), (of_a_piece e E) as (h & H & is_h & _).
      apply (no_vertex_is_inside segments all_long g h v G H end_of_g).
      assert (inside_v : strictly_inside v e).
      { destruct inside_e as (k & range & kx & ky). exists k. rewrite X, Y. tauto. }
      destruct is_h as [-> | ->]; [exact inside_v |]. apply strictly_inside_reversed in inside_v.
      now rewrite reversed_twice in inside_v.
  Qed.

  Lemma kept_ends (e f : segment) (v w : vector) : In e kept -> In f kept ->
    v = source e \/ v = target e -> w = source f \/ w = target f -> equal_vectors v w -> v = w.
  Proof.
    intros E F of_e of_f equal. destruct (kept_end e v E of_e) as (_ & _ & _ & reduced_v).
    destruct (kept_end f w F of_f) as (_ & _ & _ & reduced_w). apply reduced_of_equal in equal.
    now rewrite reduced_v, reduced_w in equal.
  Qed.

  Lemma kept_balanced : is_balanced kept.
  Proof.
    intros v. rewrite (surplus_permuted v _ _ kept_are). exact (kept_is_balanced segments all_long inside
      right_inside ends_ v).
  Qed.

  Let chains := chains_of (length kept) kept.

  Lemma chains_take_kept : Permutation (region_edges chains) kept.
  Proof. apply chains_take_all; [lia | exact kept_balanced]. Qed.

  Lemma kept_closed : cycles kept.
  Proof.
    unfold cycles. pose proof (region_cycles chains) as closed. unfold cycles in closed.
    assert (same : forall f : segment -> vector, PermutationA equal_vectors (map f kept) (map f (region_edges chains))).
    { intros f. apply Permutation_PermutationA; [exact equal_vectors_equivalence |].
      apply Permutation_map. symmetry. exact chains_take_kept. }
    transitivity (map source (region_edges chains)); [apply same |].
    transitivity (map target (region_edges chains)); [exact closed | symmetry; apply same].
  Qed.

  Lemma kept_numbers (x : vector) : (0 <= winding_number x kept <= 1)%Z.
  Proof.
    rewrite (permuted_winding_number x _ _ kept_are).
    destruct (core _ _ _ ends_ x) as (limit & L & number_is). rewrite (number_is ((1 # 2) * limit)) by lra.
    destruct (inside _); cbn; lia.
  Qed.

  (* What the rule said of the sides. *)
  Lemma beside_kept (e s : segment) : In e kept -> s = e \/ s = reversed e ->
    winding_number_shifted (right_of_middle s) kept = as_number (right_inside s).
  Proof.
    intros E which. destruct (of_a_piece e E) as (f & F & is_f & _).
    assert (D : directed kept s) by (destruct which as [-> | ->]; [now left | right; now rewrite reversed_twice]).
    assert (of_f : s = f \/ s = reversed f).
    { destruct which as [-> | ->], is_f as [-> | ->]; rewrite ?reversed_twice; tauto. }
    pose proof (directed_is_long kept kept_long s D) as long_s. pose proof (middle_is_inside s) as inside_s.
    set (n := Vector (vy (along s)) (- vx (along s))).
    assert (turn : cross (along s) n < 0).
    { pose proof (square_positive _ long_s). unfold n, cross, dot in *. cbn [vx vy]. lra. }
    assert (inside_f : strictly_inside (middle s) f).
    { destruct of_f as [-> | ->]; [exact inside_s |]. apply strictly_inside_reversed in inside_s.
      now rewrite reversed_twice in inside_s. }
    assert (turn_f : ~ cross (along f) n == 0).
    { destruct of_f as [is_s | is_s]; rewrite is_s in turn; unfold cross, along, minus, reversed in *;
        cbn [source target vx vy] in *; lra. }
    destruct (eventually_and _ _ (to_the_right_of_a_piece kept s kept_closed
        (met_by_itself_only kept kept_apart kept s (incl_refl _) D) long_s (middle s) n inside_s turn)
      (eventually_and _ _ (same_beside_pieces _ _ _ ends_ f s (middle s) n F of_f inside_s turn)
        (beside_is_off segments all_long f (middle s) n F inside_f turn_f))) as (limit & L & all).
    destruct (all ((1 # 2) * limit)) as (<- & <- & free); [lra | lra |].
    rewrite (permuted_winding_number _ _ _ kept_are). exact (core_off_pieces _ _ _ ends_ _ free).
  Qed.

  Lemma kept_distinct : NoDup kept.
  Proof. apply (Permutation_NoDup (Permutation_sym kept_are)). exact (kept_is_distinct segments all_long
    right_inside). Qed.

  Lemma same_right_of_ring (ring : list vector) (part : list segment) (e f : segment) :
    In ring (rings_in_order chains) -> incl part kept -> cycles part -> In e (edges ring) -> In f (edges ring) ->
    winding_number_shifted (right_of_middle e) part = winding_number_shifted (right_of_middle f) part.
  Proof.
    intros I part_of closed E F. apply rings_of_chains in I. destruct I as (c & C & I).
    assert (in_chain : forall g, In g (edges ring) -> In g (edges c)).
    { intros g G. apply (Permutation_in _ (edges_of_a_rotation _ _ (canonical_start_is_a_rotation c))).
      apply (Permutation_in _ (rings_have_the_edges (canonical_start c) [])). apply in_flat_map. now exists ring. }
    pose proof kept_distinct.
    apply (same_on_the_right kept kept_long kept_apart kept_ends kept_balanced kept_closed) with (chain := c); auto.
    - intros g G. destruct (of_a_piece g G) as (_ & _ & _ & _ & right_).
      rewrite (beside_kept g g G (or_introl eq_refl)). now rewrite right_.
    - intros g G. destruct (of_a_piece g G) as (_ & _ & _ & left_ & _).
      rewrite (beside_kept g (reversed g) G (or_intror eq_refl)), left_. discriminate.
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
    apply (canonical_chains_are_valid kept kept_long kept_apart kept_ends kept_distinct kept_numbers _ rings_take_kept);
      [apply rings_pass_once | exact same_right_of_ring].
  Qed.

  (* Theorem. And its chains are simple. *)
  Theorem written_chains_are_simple (c : list vector) : In c (written_chains chains) -> simple c.
  Proof.
    intros I. apply in_map_iff in I. destruct I as (ring & <- & I).
    destruct (written_ring_is_a_rotation ring) as (l & m & chain_is & ->). apply simple_turned. rewrite <- chain_is.
    apply (canonical_chains_are_simple kept kept_long kept_apart kept_ends _ rings_take_kept
      (fun r R => proj1 (rings_pass_once r R)) ring I).
    destruct (rings_pass_once ring I) as [_ some]. unfold canonical_chain.
    destruct (from_smallest_is_a_rotation ring) as (k & n & -> & turned). rewrite turned.
    destruct n, k; cbn; try discriminate. contradiction.
  Qed.
End Region.

(* Theorem. Polygons written of such chains are accepted. *)
Theorem written_polygons_are_accepted (chains : region) :
  valid_region (written_chains chains) /\ nowhere_above_one (written_chains chains) ->
  covers_nothing_twice (as_region (prepared_region
    (flat_map polygons.chains_of_polygon (canonical_polygons (map (map as_point) chains))))) = true.
Proof.
  intros [valid above]. destruct (polygonal_is_valid _ valid above) as [valid' above'].
  assert (permuted : Permutation (as_polygonal (written_chains chains))
    (flat_map polygons.chains_of_polygon (canonical_polygons (map (map as_point) chains)))).
  { symmetry. rewrite canonical_polygons_permute. unfold canonical_region, as_polygonal.
    rewrite (map_map (map as_point)), (map_ext _ (fun c => c)), map_id; [reflexivity |].
    intros c. rewrite map_map. rewrite <- (map_id c) at 2. apply map_ext. now intros []. }
  destruct (same_edges_are_valid _ _ (Permutation_flat_map edges (Permutation_map _ permuted))
    (conj valid' above')).
  now apply valid_regions_are_accepted.
Qed.

(* Theorem. So are sums, and regions by a rule. *)
Theorem written_sums_are_accepted (p q : polygonal_region) :
  valid_region (as_region p) -> valid_region (as_region q) ->
  covers_nothing_twice (as_region (prepared_region
    (flat_map polygons.chains_of_polygon (canonical_polygons (quick_sum p q))))) = true.
Proof.
  intros p_valid q_valid. apply written_polygons_are_accepted.
  set (convolution_ := convolution_segments (as_region p) (as_region q)).
  assert (long_ : forall t, In t convolution_ -> nonzero (along t)) by (now apply all_are_long).
  apply (written_region_is_valid convolution_ long_ _ _
    (filled_ends_at_pieces convolution_ long_ (all_are_closed _ _ p_valid q_valid))).
  now apply quick_filled_is.
Qed.

Theorem written_regions_by_rule_are_accepted (rule : list Z -> bool) (families : list (list segment)) :
  (forall l, In l families -> cycles l) -> (forall t, In t (concat families) -> nonzero (along t)) ->
  rule (map (fun _ => 0%Z) families) = false ->
  covers_nothing_twice (as_region (prepared_region
    (flat_map polygons.chains_of_polygon (canonical_polygons (region_by_rule rule families))))) = true.
Proof.
  intros closed long_ nothing. apply written_polygons_are_accepted.
  exact (written_region_is_valid _ long_ _ _ (rule_ends_at_pieces rule families closed long_ nothing) _
    (Permutation_refl _)).
Qed.

(* All chains that are written of these are simple. *)
Lemma chains_of_written (chains : region) (c : chain) :
  In c (flat_map polygons.chains_of_polygon (canonical_polygons (map (map as_point) chains))) ->
  In (map as_vector c) (written_chains chains).
Proof.
  assert (back : forall d, map as_vector (map as_point d) = d).
  { intros d. rewrite map_map. rewrite <- (map_id d) at 2. apply map_ext. now intros []. }
  intros I. apply (Permutation_in _ (canonical_polygons_permute _)) in I. unfold canonical_region in I.
  rewrite (map_map (map as_point)), (map_ext _ (fun d => d) back), map_id in I.
  apply in_map_iff in I. destruct I as (d & <- & D). now rewrite back.
Qed.

Definition is_simple_chain (c : chain) : Prop := simple (map as_vector c).

Theorem written_sums_are_simple (p q : polygonal_region) (c : chain) :
  valid_region (as_region p) -> valid_region (as_region q) ->
  In c (flat_map polygons.chains_of_polygon (canonical_polygons (quick_sum p q))) -> is_simple_chain c.
Proof.
  intros p_valid q_valid I. apply chains_of_written in I. unfold is_simple_chain. revert I.
  set (convolution_ := convolution_segments (as_region p) (as_region q)).
  assert (long_ : forall t, In t convolution_ -> nonzero (along t)) by (now apply all_are_long).
  apply (written_chains_are_simple convolution_ long_ _ _
    (filled_ends_at_pieces convolution_ long_ (all_are_closed _ _ p_valid q_valid))).
  now apply quick_filled_is.
Qed.

Theorem written_regions_by_rule_are_simple (rule : list Z -> bool) (families : list (list segment)) (c : chain) :
  (forall l, In l families -> cycles l) -> (forall t, In t (concat families) -> nonzero (along t)) ->
  rule (map (fun _ => 0%Z) families) = false ->
  In c (flat_map polygons.chains_of_polygon (canonical_polygons (region_by_rule rule families))) ->
  is_simple_chain c.
Proof.
  intros closed long_ nothing I. apply chains_of_written in I. unfold is_simple_chain. revert I.
  exact (written_chains_are_simple _ long_ _ _ (rule_ends_at_pieces rule families closed long_ nothing) _
    (Permutation_refl _) _).
Qed.
