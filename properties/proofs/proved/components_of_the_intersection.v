(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The components of the intersection of two simple polygons in general position are what the chains of its boundary
   bound: these are simple (chains_of_the_intersection.v) and counterclockwise (no_holes_in_the_intersection.v). From a
   point of the intersection one comes to a chain (points_of_the_intersection.v), and along it to its first vertex. No
   path in the intersection leads from what one chain bounds to what another one does: chains have no point in common,
   so close to a chain there is nothing else of the intersection than what it bounds; and where a path leaves that, it
   passes the chain. *)
From Coq Require Import QArith Qminmax Lqa ZArith Lia Bool List Permutation.
From Oplus Require Import regions_and_sums small_numbers simple_chain simple_chains_turn_once
  winding_numbers_of_simple_chains left_of_an_edge interiors_meet valid_components coordinates polygons_of_the_thesis
  connected_sets filling kept_pieces_go_round cut_pieces rule_of_sides region_of_pieces nested_chains edges_of_polygons
  edges_of_the_intersection chains_of_the_intersection connected_beside_pieces leaving_a_polygon
  no_holes_in_the_intersection points_of_the_intersection.
Import ListNotations.

Open Scope Q_scope.

Lemma no_term_is_more_than_the_sum {A : Type} (f : A -> Z) (l : list A) : (forall d, In d l -> (0 <= f d)%Z) ->
  (0 <= sum (map f l))%Z /\ forall d, In d l -> (f d <= sum (map f l))%Z.
Proof.
  unfold sum. induction l as [| c l IH]; intros each; [split; [apply Z.le_refl | intros d []] |]. cbn [map fold_right].
  pose proof (each c (or_introl eq_refl)). destruct IH as [rest terms]; [intros d D; apply each; now right |].
  split; [lia |]. intros d [<- | D]; [lia |]. specialize (terms d D). lia.
Qed.

Section TwoPolygons.
  Variables a b : list vector.
  Hypothesis a_polygon : simple_polygon a.
  Hypothesis b_polygon : simple_polygon b.
  Hypothesis a_off : vertices_are_off a b.
  Hypothesis b_off : vertices_are_off b a.
  Let kept := kept_boundary a b.
  Let ends_ := two_families_end a b a_polygon b_polygon.
  Let in_both := in_both a b.
  Let share := kept_share_ends _ _ _ ends_.

  (* The chains. *)
  Variable r : region.
  Hypothesis edges_are : Permutation (region_edges r) kept.
  Hypothesis all_simple : forall chain, In chain r -> simple chain.
  Variable do_cross : nat -> nat -> bool.
  Hypothesis crossings : forall i j, (i < length a)%nat -> (j < length b)%nat ->
    do_cross i j = true <-> exists v, lies_on v (edge_at a i) /\ lies_on v (edge_at b j).

  Lemma edges_of_chain_are_kept (c : list vector) : In c r -> incl (edges c) kept.
  Proof. intros C e E. apply (Permutation_in _ edges_are), in_flat_map. now exists c. Qed.

  Lemma all_counterclockwise (c : list vector) : In c r -> simple_polygon c.
  Proof.
    intros C. split; [now apply all_simple |].
    apply (kept_chains_are_counterclockwise a b a_polygon b_polygon a_off b_off c (all_simple c C)).
    now apply edges_of_chain_are_kept.
  Qed.

  Lemma chains_are_distinct : NoDup r.
  Proof.
    apply (parts_are_distinct edges).
    - apply (Permutation_NoDup (Permutation_sym edges_are)), (are_distinct _ share).
    - intros c C none. destruct (all_simple c C) as (three & _). pose proof (edges_are_as_many c). rewrite none in *.
      cbn in *. lia.
  Qed.

  (* Two chains have no point in common. *)
  Lemma one_chain_at_each_point (c d : list vector) (e f : segment) (v : vector) : In c r -> In d r -> In e (edges c) ->
    In f (edges d) -> lies_on v e -> lies_on v f -> c = d.
  Proof.
    intros C D E F on_e on_f.
    assert (once : forall g, In g (edges c) -> In g (edges d) -> c = d).
    { intros g G G'. apply (in_one_part edges r g c d); trivial.
      apply (Permutation_NoDup (Permutation_sym edges_are)), (are_distinct _ share). }
    pose proof (edges_of_chain_are_kept c C e E) as K. pose proof (edges_of_chain_are_kept d D f F) as L.
    destruct (segment_dec e f) as [<- | other]; [exact (once e E F) |].
    (* an edge that starts there, and one that ends there *)
    assert (starts : forall c e, In c r -> In e (edges c) -> equal_vectors (source e) v \/ equal_vectors (target e) v ->
      exists g h, In g (edges c) /\ In h (edges c) /\ target g = source h /\ equal_vectors (source h) v).
    { clear - all_simple. intros c e C E end_. apply (In_nth _ _ no_segment) in E. destruct E as (i & I & <-).
      rewrite edges_are_as_many in I. fold (edge_at c i) in *.
      assert (listed : forall j, (j < length c)%nat -> In (edge_at c j) (edges c))
        by (intros j J; apply nth_In; now rewrite edges_are_as_many).
      pose proof (previous_below _ i I) as I'. pose proof (next_in_range i _ I) as I''.
      destruct end_ as [end_ | end_].
      - exists (edge_at c (previous (length c) i)), (edge_at c i). split; [auto |]. split; [auto |].
        split; [| exact end_]. rewrite !edge_is by assumption. cbn [source target]. now rewrite next_previous.
      - exists (edge_at c i), (edge_at c (next i (length c))). split; [auto |]. split; [auto |].
        assert (meets : target (edge_at c i) = source (edge_at c (next i (length c))))
          by (rewrite !edge_is by assumption; reflexivity).
        split; [exact meets | now rewrite <- meets]. }
    destruct (inside_or_end v e on_e) as [inside_ | end_e];
      [destruct (nothing_inside _ share e f v K L other on_f inside_) |].
    destruct (inside_or_end v f on_f) as [inside_ | end_f];
      [destruct (nothing_inside _ share f e v L K (not_eq_sym other) on_e inside_) |].
    destruct (starts c e C E end_e) as (g & h & G & H & meets & at_h), (starts d f D F end_f) as (g' & h' & G' & H' &
      meets' & at_h').
    assert (same_ : h = h').
    { apply (one_piece_starts a b a_polygon b_polygon a_off b_off do_cross crossings g h g' h'
        (edges_of_chain_are_kept c C g G) (edges_of_chain_are_kept c C h H) (edges_of_chain_are_kept d D g' G')
        (edges_of_chain_are_kept d D h' H') meets meets').
      now rewrite at_h. }
    subst h'. exact (once h H H').
  Qed.

  Section OneChain.
    Variables before after : region.
    Variable c : list vector.
    Hypothesis r_is : r = before ++ c :: after.
    Let others := region_edges (before ++ after).

    Lemma c_is_there : In c r.
    Proof. rewrite r_is. apply in_app_iff. right. now left. Qed.

    Lemma another_chain (d : list vector) : In d (before ++ after) -> In d r /\ c <> d.
    Proof.
      intros D. split; [rewrite r_is; apply in_app_iff; cbn; apply in_app_iff in D; tauto |]. intros <-.
      pose proof chains_are_distinct as once. rewrite r_is in once. exact (NoDup_remove_2 _ _ _ once D).
    Qed.

    Lemma kept_number (z : vector) :
      winding_number z kept = (winding_number z (edges c) + winding_number z others)%Z.
    Proof.
      rewrite <- (permuted_winding_number z _ _ edges_are), r_is. unfold others, region_edges.
      rewrite !flat_map_app. cbn [flat_map]. rewrite !winding_number_is_additive. lia.
    Qed.

    Lemma off_the_others (v : vector) : on_one_of v (edges c) -> off v others.
    Proof.
      intros (e & E & on) f F on_f. apply in_flat_map in F. destruct F as (d & D & F).
      destruct (another_chain d D) as [D' differ_]. apply differ_.
      exact (one_chain_at_each_point c d e f v c_is_there D' E F on on_f).
    Qed.

    Lemma others_are_not_negative (z : vector) : off z others ->
      (0 <= winding_number z others)%Z /\
      forall d, In d (before ++ after) -> (winding_number z (edges d) <= winding_number z others)%Z.
    Proof.
      unfold others. intros free. rewrite number_of_chains.
      apply (no_term_is_more_than_the_sum (fun d => winding_number z (edges d))). intros d D.
      destruct (another_chain d D) as [D' _]. destruct (all_counterclockwise d D') as [d_simple turned].
      assert (free_d : off z (edges d)) by (intros e E; apply free, in_flat_map; now exists d).
      pose proof (winding_numbers_of_simple_chains d z d_simple free_d) as range. rewrite turned in range. lia.
    Qed.

    Lemma others_do_not_go_round (v : vector) : on_one_of v (edges c) -> winding_number v others = 0%Z.
    Proof.
      intros on. destruct (winding_number_near v others (region_cycles _) (off_the_others v on)) as (radius & R & near).
      pose proof (all_counterclockwise c c_is_there) as polygon. destruct on as (e & E & on).
      destruct (valid_is_regular [c] (simple_polygons_are_regions c polygon) v e radius)
        as (z & close & free_z & some); [now rewrite one_chain | exact on | exact R |].
      destruct (near z close) as [free_o same_]. pose proof (proj1 (others_are_not_negative z free_o)).
      rewrite one_chain in *. pose proof (kept_number z) as both.
      assert (range : winding_number z kept = 0%Z \/ winding_number z kept = 1%Z).
      { unfold kept, kept_boundary. rewrite (boundary_by_rule_goes_round boolean_operations.all_positive
          (two_families a b) (both_are_closed a b) (both_are_long a b a_polygon b_polygon) eq_refl z).
        destruct (by_rule _ _ z); [now right | now left]. }
      lia.
    Qed.

    (* Close to the chain the intersection is what the chain bounds. *)
    Lemma close_to_the_chain (v : vector) : on_one_of v (edges c) -> exists radius, 0 < radius /\
      forall y, within radius v y -> in_both y -> in_region y [c].
    Proof.
      intros on. pose proof (off_the_others v on) as free.
      destruct (winding_number_near v others (region_cycles _) free) as (radius & R & near).
      exists radius. split; [exact R |]. pose proof (others_do_not_go_round v on) as none.
      intros y close in_. destruct (near y close) as [free_y same_]. unfold in_region. rewrite one_chain.
      destruct (on_or_off y (edges c)) as [on_y | off_y]; [now right | left].
      assert (free_all : off y kept).
      { intros f F on_f. apply (Permutation_in _ (Permutation_sym edges_are)) in F. apply in_flat_map in F.
        destruct F as (d & D & F). rewrite r_is in D. apply in_app_iff in D.
        destruct (list_eq_dec vector_dec c d) as [<- | differ_]; [exact (off_y f F on_f) |].
        apply (free_y f); [| exact on_f]. apply in_flat_map. exists d. split; [| exact F]. apply in_app_iff.
        destruct D as [D | [D | D]]; [now left | contradiction | now right]. }
      pose proof (on_the_boundary_or_inside a b a_polygon b_polygon a_off b_off y in_ free_all) as one.
        rewrite kept_number, same_, none in one. lia.
    Qed.

    (* What a step in the intersection leads to is bounded by the same chain. *)
    Lemma a_step_stays (y z : vector) : (forall w, lies_on w (Segment y z) -> in_both w) -> in_region y [c] ->
      in_region z [c].
    Proof.
      intros all in_. destruct (in_region_dec z [c]) as [| out]; [assumption | exfalso].
      destruct (leaving_to_the_right c (all_counterclockwise c c_is_there) y z in_ out) as (k & e & range & E & on & _ &
        gone).
      rewrite one_chain in E. set (u := minus z y) in *.
      destruct (close_to_the_chain (moved_along y u k)) as (radius & R & near); [now exists e |].
      destruct (some_small _ (eventually_and _ _ (small_steps_stay_within radius (moved_along y u k) u R)
        (eventually_below (1 - k) ltac:(lra)))) as (d & _ & close & d_some & less).
      apply (gone (k + d) ltac:(lra)), near.
      - unfold within, moved_along in *. cbn [vx vy] in *. lra.
      - apply all. exists (k + d). unfold moved_along, u, minus. cbn [source target vx vy]. split; [lra |]. split; ring.
    Qed.

    Lemma a_path_stays (y z : vector) : connected_in in_both y z -> in_region y [c] -> in_region z [c].
    Proof.
      intros (path & walk). revert y walk. induction path as [| w rest IH]; intros y walk in_.
      - exact (a_step_stays y z walk in_).
      - destruct walk as [first_ walk]. apply (IH w walk). exact (a_step_stays y w first_ in_).
    Qed.
  End OneChain.

  Lemma vertex_is_on_the_chain (c : list vector) (i : nat) : (i < length c)%nat ->
    In (edge_at c i) (edges c) /\ lies_on (vertex c i) (edge_at c i).
  Proof.
    intros I. split; [apply nth_In; now rewrite edges_are_as_many |]. rewrite edge_is by exact I.
    apply (source_lies_on (Segment _ _)).
  Qed.

  Lemma along_the_chain (c : list vector) (i : nat) (v : vector) : In c r -> (i < length c)%nat ->
    lies_on v (edge_at c i) -> connected_in in_both (vertex c 0) v.
  Proof.
    intros C. assert (step : forall i v, (i < length c)%nat -> lies_on v (edge_at c i) ->
      connected_in in_both (vertex c i) v).
    { intros j w J on. apply connected_by_a_step. intros p on_p.
      destruct (vertex_is_on_the_chain c j J) as [E _]. apply (kept_is_in_both a b a_polygon b_polygon a_off b_off
        (edge_at c j)).
      - now apply (edges_of_chain_are_kept c C).
      - rewrite edge_is in * by exact J. exact (part_of_a_step _ _ w p on on_p). }
    intros I on. refine (connected_on _ _ _ _ _ (step i v I on)). clear on. induction i as [| i IH].
    - apply step; [exact I |]. now apply vertex_is_on_the_chain.
    - apply (connected_on _ _ (vertex c i)); [apply IH; lia |]. apply step; [lia |].
      assert (follows : next i (length c) = S i) by (unfold next; destruct (Nat.eqb_spec (S i) (length c)); lia).
      rewrite edge_is, follows by lia. apply (target_lies_on (Segment _ _)).
  Qed.

  (* Theorem. *)
  Theorem components_are_the_chains : has_components in_both (length r).
  Proof.
    exists (map (fun c => vertex c 0) r). split; [apply map_length |].
    assert (some : forall c, In c r -> (0 < length c)%nat) by (intros c C; destruct (all_simple c C); lia).
    split; [| split].
    - intros v V. apply in_map_iff in V. destruct V as (c & <- & C).
      destruct (vertex_is_on_the_chain c 0 (some c C)) as [E on].
      exact (kept_is_in_both a b a_polygon b_polygon a_off b_off _ _ (edges_of_chain_are_kept c C _ E) on).
    - intros z in_. destruct (straight_to_the_boundary a b a_polygon b_polygon a_off b_off z in_) as (f & v & F & on &
      there).
      apply (Permutation_in _ (Permutation_sym edges_are)), edge_by_chain in F. destruct F as (c & i & C & I & ->).
      exists (vertex c 0). split; [apply in_map_iff; now exists c |].
      apply (connected_on _ _ _ _ there), connected_back. exact (along_the_chain c i v C I on).
    - assert (pairs : ForallOrdPairs (fun c d => ~ connected_in in_both (vertex c 0) (vertex d 0)) r).
      { apply pairs_of_different; [exact chains_are_distinct |]. intros c d C D differ_ there.
        destruct (in_split _ _ C) as (before & after & r_is).
        destruct (vertex_is_on_the_chain c 0 (some c C)) as [E on], (vertex_is_on_the_chain d 0 (some d D)) as [F on'].
        assert (in_c : in_region (vertex d 0) [c]).
        { apply (a_path_stays before after c r_is _ _ there). right. exists (edge_at c 0). now rewrite one_chain. }
        destruct in_c as [round | (e & E' & on_e)]; rewrite one_chain in *.
        - destruct (in_split _ _ D) as (before' & after' & r_is').
          pose proof (off_the_others before' after' d r_is' (vertex d 0) (ex_intro _ _ (conj F on'))) as free.
          pose proof (others_do_not_go_round before' after' d r_is' (vertex d 0) (ex_intro _ _ (conj F on'))) as none.
          destruct (others_are_not_negative before' after' d r_is' (vertex d 0) free) as [_ terms].
          assert (I : In c (before' ++ after')).
          { rewrite r_is' in C. apply in_app_iff. apply in_app_iff in C.
            destruct C as [C | [C | C]]; [now left | now destruct differ_ | now right]. }
          specialize (terms c I). lia.
        - apply differ_. exact (one_chain_at_each_point c d e _ _ C D E' F on_e on'). }
      clear - pairs. induction pairs as [| c l first_ _ IH]; cbn [map]; constructor; [| exact IH].
      rewrite Forall_forall in *. intros v V. apply in_map_iff in V. destruct V as (d & <- & D). now apply first_.
  Qed.
End TwoPolygons.
