(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Theorem 4.2.14 for an intersection whose boundary is constructed: P and Q are simple polygons, and x is in general
   position, off the vertex-edge sum. The pieces that the rule of sides keeps of the edges of P and -Q + x are the edges
   of closed chains that bound the intersection, as theorem_4_2_14.v asks for: they have a corner for each vertex of one
   inside the other and for each crossing (places_of_corners.v). So the winding number of the original convolution at x
   is the sum of their turning numbers. *)
From Coq Require Import QArith Lqa ZArith Lia Bool List Permutation SetoidList SetoidPermutation.
From Oplus Require Import convolution convolution_winding small_numbers regions meeting_of_segments left_of_an_edge
  simple_chain simple_chains_turn_once winding_numbers_of_simple_chains signed_crossings theorem_4_2_1
  polygons_of_the_thesis placed_collision reflected parallelogram crossing_edges interiors_meet region_size
  replaced_segments tangent_features theorem_4_2_14 filling walks kept_pieces_go_round rule_of_sides region_of_pieces
  boolean_operations direction_between small_moves edges_of_polygons edges_of_the_intersection
  places_of_corners reflected_polygons.
Import ListNotations.

Open Scope Q_scope.

(* Lists of corners. *)
Lemma same_corner_itself (c : corner) : same_corner c c.
Proof. unfold same_corner. repeat split; trivial; reflexivity. Qed.

Lemma same_corners_one_by_one (l m : list corner) : Forall2 same_corner l m -> PermutationA same_corner l m.
Proof. induction 1; [apply permA_nil | now apply permA_skip]. Qed.

Lemma same_corners_permuted (l m : list corner) : Permutation l m -> PermutationA same_corner l m.
Proof.
  induction 1; [apply permA_nil | apply permA_skip; [apply same_corner_itself | assumption] | apply permA_swap |
    eapply permA_trans; eassumption].
Qed.

Lemma same_corners_that_bend (l m : list corner) : PermutationA same_corner l m ->
  PermutationA same_corner (filter bends l) (filter bends m).
Proof.
  induction 1 as [| c d l m same_ _ IH | c d l | l m k _ IH _ IH'].
  - apply permA_nil.
  - cbn [filter]. destruct (bends c) eqn:bend.
    + rewrite (bends_equally c d same_ bend). now apply permA_skip.
    + destruct (bends d) eqn:bend'; [| exact IH].
      rewrite (bends_equally d c (same_corner_back c d same_) bend') in bend. discriminate.
  - cbn [filter].
    destruct (bends c), (bends d); [apply permA_swap | apply same_corners_permuted, Permutation_refl ..].
  - eapply permA_trans; eassumption.
Qed.

Lemma filter_mapped {A B} (f : A -> B) (test : B -> bool) (l : list A) :
  filter test (map f l) = map f (filter (fun a => test (f a)) l).
Proof. induction l as [| x l IH]; [reflexivity |]. cbn. destruct (test (f x)); cbn; now rewrite IH. Qed.

Lemma mapped_one_by_one {A} (f g : A -> corner) (l : list A) :
  (forall x, In x l -> same_corner (f x) (g x)) -> Forall2 same_corner (map f l) (map g l).
Proof. induction l as [| x l IH]; intros each; constructor; [apply each; now left | apply IH; intros; apply each;
  now right]. Qed.

Lemma list_prod_mapped {A B C D} (f : A -> C) (g : B -> D) (l : list A) (m : list B) :
  list_prod (map f l) (map g m) = map (fun ends => (f (fst ends), g (snd ends))) (list_prod l m).
Proof.
  induction l as [| x l IH]; [reflexivity |]. cbn [map list_prod]. rewrite map_app, IH. f_equal. now rewrite !map_map.
Qed.

Lemma vertices_by_number (c : list vector) :
  region_vertices [c] = map (fun i => (vertex c i, corner_of_chain c i)) (seq 0 (length c)).
Proof.
  unfold region_vertices. cbn [flat_map]. rewrite app_nil_r.
  apply (nth_ext _ _ (nowhere, Corner nowhere nowhere) (vertex c 0, corner_of_chain c 0)).
  - now rewrite combine_length, corners_length, Nat.min_id, map_length, seq_length.
  - intros i I. rewrite combine_length, corners_length, Nat.min_id in I.
    rewrite combine_nth by now rewrite corners_length.
    rewrite (map_nth (fun i => (vertex c i, corner_of_chain c i))), seq_nth by exact I. reflexivity.
Qed.

Lemma edges_of_one_by_number (c : list vector) : region_edges [c] = map (edge_at c) (seq 0 (length c)).
Proof. unfold region_edges. cbn [flat_map]. now rewrite app_nil_r, edges_by_number. Qed.

Section Intersection.
  Variables p q : list vector.
  Variable x : vector.
  Hypothesis p_polygon : simple_polygon p.
  Hypothesis q_polygon : simple_polygon q.
  Hypothesis general : off_vertex_edge_sum x [p] [q].

  Let b := reflected_polygon x q.
  Let b_polygon : simple_polygon b := reflected_polygon_is_one x q q_polygon.

  Lemma b_length : length b = length q.
  Proof. apply map_length. Qed.

  Lemma edges_in (c : list vector) (i : nat) : (i < length c)%nat -> In (edge_at c i) (region_edges [c]).
  Proof. intros I. apply edge_at_in_region; [now left | exact I]. Qed.

  Lemma p_off_b : vertices_are_off p b.
  Proof.
    intros i I. change [b] with (placed x [q]). apply off_placed. intros f F.
    destruct (general (edge_at p i) f (edges_in p i I) F) as (no & _). rewrite edge_is in no by exact I. exact no.
  Qed.

  Lemma b_off_p : vertices_are_off b p.
  Proof.
    intros j J e E on. rewrite b_length in J. unfold b in on. rewrite reflected_vertex in on by exact J.
    destruct (general e (edge_at q j) E (edges_in q j J)) as (_ & _ & no & _). rewrite edge_is in no by exact J.
    exact (no on).
  Qed.

  Definition edges_do_cross (i j : nat) : bool :=
    negb (winding_number x (parallelogram (edge_at p i) (edge_at q j)) =? 0)%Z.

  Lemma edges_do_cross_is_right (i j : nat) : (i < length p)%nat -> (j < length b)%nat ->
    edges_do_cross i j = true <-> exists v, lies_on v (edge_at p i) /\ lies_on v (edge_at b j).
  Proof.
    intros I J. rewrite b_length in J. unfold edges_do_cross, b. rewrite reflected_edge by exact J.
    rewrite negb_true_iff, Z.eqb_neq. split.
    - intros some. destruct (parallelogram_winding_number x (edge_at p i) (edge_at q j)) as [none | [_ (y & z & on_p &
        on_q & X & Y)]];
        [contradiction |].
      exists y. split; [exact on_p |]. apply on_reflected. apply (lies_on_equal z); [| exact on_q].
      unfold equal_vectors, minus, plus in *. cbn [vx vy] in *. split; lra.
    - intros (v & on_p & on_q). apply on_reflected in on_q.
      assert (sum_ : is_sum_of_points x (edge_at p i) (edge_at q j)).
      { exists v, (minus x v). split; [exact on_p |]. split; [exact on_q |]. unfold equal_vectors, plus, minus.
        cbn [vx vy].
        split; ring. }
      destruct (crossing_edges_count x (edge_at p i) (edge_at q j)) as [[_ ->] | [_ ->]]; trivial; try discriminate;
        [apply (polygon_edges_are_long p p_polygon) | apply (polygon_edges_are_long q q_polygon) | apply general];
          now apply edges_in.
  Qed.

  Let places_ := places p b edges_do_cross.
  Let corner_there := corner_of_place p b.

  Lemma same_corner_of_equal (u v u' v' : vector) : equal_vectors u u' -> equal_vectors v v' ->
    same_corner (Corner u v) (Corner u' v').
  Proof.
    intros U V. unfold same_corner. cbn [incoming outgoing]. split; [| split; [| split]].
    - destruct U as [X Y]. unfold nonzero. now rewrite X, Y.
    - destruct V as [X Y]. unfold nonzero. now rewrite X, Y.
    - now apply total_turn.angle_of_equal.
    - now apply total_turn.angle_of_equal.
  Qed.

  Lemma reflected_along (s : segment) : equal_vectors (along (reflected x s)) (opposite (along s)).
  Proof. unfold equal_vectors, reflected, along, opposite, minus. cbn [source target vx vy]. split; ring. Qed.

  Lemma places_are_the_intersection_corners :
    Forall2 same_corner (map corner_there places_) (intersection_corners x [p] [q]).
  Proof.
    unfold places_, places, intersection_corners.
    rewrite !map_app, !map_map, !vertices_by_number, !filter_mapped, !map_map.
    rewrite !edges_of_one_by_number, list_prod_mapped, filter_mapped, !map_map, b_length.
    apply Forall2_app; [| apply Forall2_app].
    - rewrite (filter_ext_in (is_inside_other p b true)
        (fun i => is_vertex_inside x (map (edge_at q) (seq 0 (length q))) (vertex p i, corner_of_chain p i))).
      + apply mapped_one_by_one. intros i _. apply same_corner_itself.
      + intros i I. apply in_seq in I. unfold is_inside_other, is_vertex_inside. cbn [polygon_of negb fst].
        rewrite <- edges_of_one_by_number. change [b] with (placed x [q]). f_equal. apply winding_number_of_placed.
        apply off_placed. exact (p_off_b i (proj2 I)).
    - rewrite (filter_ext_in (is_inside_other p b false)
        (fun j => is_vertex_inside x (map (edge_at p) (seq 0 (length p))) (vertex q j, corner_of_chain q j))).
      + apply mapped_one_by_one. intros j J. apply filter_In in J. destruct J as [J _]. apply in_seq in J.
        destruct J as [_ J].
        cbn [Nat.add] in J. unfold corner_there. cbn [corner_of_place polygon_of snd].
        pose proof (previous_below _ j J) as K.
        assert (direction_is : forall k, (k < length q)%nat ->
          equal_vectors (edge_of_chain b k) (opposite (edge_of_chain q k))).
        { intros k L. rewrite !edge_of_chain_joins_vertices, b_length by (rewrite ?b_length; exact L). unfold b.
          rewrite !reflected_vertex by (trivial; now apply next_in_range). unfold equal_vectors, opposite, minus.
          cbn [vx vy].
          split; ring. }
        rewrite !corner_is by (rewrite ?b_length; exact J). rewrite b_length. unfold opposite_corner.
        cbn [incoming outgoing].
        apply same_corner_of_equal; now apply direction_is.
      + intros j J. apply in_seq in J. unfold is_inside_other, is_vertex_inside. cbn [polygon_of negb fst].
        rewrite <- edges_of_one_by_number. unfold b. rewrite reflected_vertex by apply J. reflexivity.
    - rewrite (filter_ext_in (fun ends => edges_do_cross (fst ends) (snd ends)) (fun ends => negb (winding_number x
        (parallelogram (fst (edge_at p (fst ends), edge_at q (snd ends))) (snd (edge_at p (fst ends),
          edge_at q (snd ends)))) =? 0)%Z))
        by reflexivity.
      apply mapped_one_by_one. intros [i j] I. apply filter_In in I. destruct I as [I _]. apply in_prod_iff in I.
      rewrite !in_seq in I. unfold corner_there. cbn [corner_of_place fst snd]. unfold leads_out, b.
      rewrite reflected_edge by lia. destruct (reflected_along (edge_at q j)) as [X Y].
      unfold opposite in X, Y. cbn [vx vy] in X, Y. unfold crossing_corner.
      assert (same_test : negative (cross (along (reflected x (edge_at q j))) (along (edge_at p i))) =
        negative (cross (along (edge_at p i)) (along (edge_at q j)))).
      { apply same_negative. unfold cross. rewrite X, Y. ring. }
      rewrite same_test. destruct (negative (cross (along (edge_at p i)) (along (edge_at q j))));
        apply same_corner_of_equal; try apply reflected_along; split; reflexivity.
  Qed.

  (* Theorem. Chains made of the kept pieces bound the intersection. *)
  Theorem kept_pieces_bound_the_intersection (r : region) : Permutation (region_edges r) (kept_boundary p b) ->
    bounds_the_intersection r x [p] [q].
  Proof.
    intros edges_are.
    destruct (corners_are_at_places p b p_polygon b_polygon p_off_b b_off_p edges_do_cross edges_do_cross_is_right r
      edges_are)
      as (m & permuted & pairs_). apply same_corners_that_bend.
    apply permA_trans with (map corner_there m).
    - apply same_corners_one_by_one. clear - pairs_. induction pairs_; cbn [map]; constructor; assumption.
    - apply permA_trans with (map corner_there places_); [now apply same_corners_permuted, Permutation_map |].
      apply same_corners_one_by_one, places_are_the_intersection_corners.
  Qed.
  Lemma same_direction_turns (u v u' v' : vector) : same_direction u u' -> same_direction v v' -> turns u' v' ->
    turns u v.
  Proof.
    intros (k & K & ux & uy) (l & L & wx & wy) (some_u & some_v & forwards).
    assert (kl : 0 < k * l) by nra. unfold turns, nonzero, cross, dot in *. split; [| split].
    - intros [X Y]. apply some_u. split; apply (Qmult_inj_l _ _ k); lra.
    - intros [X Y]. apply some_v. split; apply (Qmult_inj_l _ _ l); lra.
    - intros flat. rewrite ux, uy, wx, wy in *.
      assert (zero_ : vx u' * vy v' - vy u' * vx v' == 0) by (apply (Qmult_inj_l _ _ (k * l)); lra).
      specialize (forwards zero_).
      setoid_replace (k * vx u' * (l * vx v') + k * vy u' * (l * vy v')) with (k * l * (vx u' * vx v' + vy u' * vy
        v')) by ring.
      nra.
  Qed.

  Lemma same_corner_turns (c d : corner) : same_corner c d -> turns (incoming d) (outgoing d) ->
    turns (incoming c) (outgoing c).
  Proof.
    intros (in_ & out & same_in & same_out) turn. pose proof turn as (some_in & some_out & _).
    apply (same_direction_turns _ _ (incoming d) (outgoing d)); trivial; apply same_direction_angle; tauto.
  Qed.

  Lemma kept_pieces_turn (r : region) : Permutation (region_edges r) (kept_boundary p b) -> turns_in_all_chains r.
  Proof.
    intros edges_are chain C c I.
    destruct (corners_are_at_places p b p_polygon b_polygon p_off_b b_off_p edges_do_cross edges_do_cross_is_right r
      edges_are)
      as (m & permuted & pairs_).
    assert (found : exists there, In there places_ /\ same_corner c (corner_there there)).
    { assert (J : In c (flat_map corners r)) by (apply in_flat_map; now exists chain).
      assert (pairs' : forall l n, Forall2 (fun c p0 => same_corner c (corner_of_place p b p0)) l n -> In c l ->
        exists there, In there n /\ same_corner c (corner_there there)).
      { induction 1 as [| d e l n same_ _ IH]; [easy |]. intros [<- | K]; [exists e; split; [now left | exact same_] |].
        destruct (IH K) as (there & T & same_'). exists there. split; [now right | exact same_']. }
      destruct (pairs' _ _ pairs_ J) as (there & T & same_). exists there. split; [| exact same_].
      exact (Permutation_in _ permuted T). }
    destruct found as (there & T & same_). apply (same_corner_turns c _ same_). apply in_places in T.
    destruct there as [of_first i | i j]; unfold corner_there; cbn [corner_of_place].
    - assert (polygon : simple_polygon (polygon_of p b of_first)) by (now destruct of_first).
      apply (simple_chain_turns_everywhere _ (proj1 polygon)). apply nth_In. rewrite corners_length. apply T.
    - destruct T as (I0 & J0 & yes). apply edges_do_cross_is_right in yes; trivial. destruct yes as (v & on_i & on_j).
      destruct (edges_of_both_cross p b p_polygon b_polygon p_off_b b_off_p p b _ _ v (FirstOne p b) (edges_in p i I0)
        (edges_in b j J0)
        on_i on_j) as (_ & _ & no).
      pose proof (polygon_edges_are_long p p_polygon _ (edges_in p i I0)) as p_long.
      pose proof (polygon_edges_are_long b b_polygon _ (edges_in b j J0)) as b_long.
      destruct (leads_out p b i j); cbn [incoming outgoing]; (split; [assumption | split; [assumption |]]);
        intros flat; exfalso;
        apply no; unfold cross in *; lra.
  Qed.

  (* Theorem 4.2.14 with the boundary of the intersection constructed: chains of the kept pieces are a region that has
     the points inside both, and no others, off the edges; and the winding number of the original convolution is the sum
     of their turning numbers. *)
  Theorem winding_number_of_the_constructed_intersection :
    let r := chains_of (length (kept_boundary p b)) (kept_boundary p b) in
    valid_region r /\
    (forall y, winding_number y (region_edges r) = 1%Z <->
       (0 < winding_number y (region_edges [p]))%Z /\ (0 < winding_number y (region_edges [b]))%Z) /\
    winding_number x (original_convolution [p] [q]) = turning_numbers r.
  Proof.
    intros r. pose proof (two_families_end p b p_polygon b_polygon) as ends_.
    assert (edges_are : Permutation (region_edges r) (kept_boundary p b)) by exact (chains_of_kept _ _ _ ends_).
    split; [exact (chains_are_valid _ _ _ ends_ r edges_are) |]. split.
    - intros y. rewrite (permuted_winding_number y _ _ edges_are). unfold kept_boundary.
      rewrite (boundary_by_rule_goes_round all_positive (two_families p b) (both_are_closed p b)
        (both_are_long p b p_polygon b_polygon) eq_refl y).
      rewrite <- (all_positive_of_two p b p b y (FirstOne p b)).
      destruct (by_rule _ _ y); cbn; split; intros; congruence || lia.
    - apply original_winding_number_is_the_turning_number_of_the_intersection.
      + intros chain [<- | []]. exact (simple_chain_turns_everywhere p (proj1 p_polygon)).
      + intros chain [<- | []]. exact (simple_chain_turns_everywhere q (proj1 q_polygon)).
      + exact (kept_pieces_turn r edges_are).
      + intros v _. apply numbers_are_0_or_1_everywhere. intros y free.
        destruct (simple_polygons_go_round_once q y q_polygon free) as [-> | ->]; lia.
      + intros v _. apply numbers_are_0_or_1_everywhere. intros y free.
        destruct (simple_polygons_go_round_once p y p_polygon free) as [-> | ->]; lia.
      + exact (kept_pieces_bound_the_intersection r edges_are).
  Qed.
End Intersection.
