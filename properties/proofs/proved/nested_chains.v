(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Simple chains that together are a valid region with winding numbers 0 and 1, and of which each goes equally often
   round all of another one: they are nested or apart. If one goes round another one, it is not inside that one: the
   rightmost of their points at some height is outside of one of them. What goes round a chain goes round all that it
   goes round, and of two that go round a third one goes round the other: from a point of the third, a ray meets one
   of the two first. And beside an edge, the chains together go round 0 times on its right and once on its left: so all
   others go 0 times round a counterclockwise chain, and once round a clockwise one. The rest is in
   order_of_nesting.v. *)
From Coq Require Import QArith Lqa ZArith Lia Bool List Permutation.
From Oplus Require Import regions_and_sums simple_chain simple_chains_turn_once winding_numbers_of_simple_chains
  valid_components winding_numbers_of_valid_regions edges_of_valid_regions first_hit collision_is_sound boundary_points
  complement_in_a_frame beside_a_vertex filling order_of_nesting.
Import ListNotations.

Open Scope Q_scope.

(* Of two, one has a point that the other one does not go round. *)
Lemma one_is_outside (some others : list segment) (x : vector) : cycles some -> off x some ->
  meet_in_ends_only some others -> winding_number x some <> 0%Z ->
  (exists z, on_one_of z some /\ off z others /\ winding_number z others = 0%Z) \/
  (exists z, on_one_of z others /\ off z some /\ winding_number z some = 0%Z).
Proof.
  intros closed free ends_only winds. destruct (winding_number_near x some closed free) as (radius & R & near).
  (* at a height of no vertex *)
  destruct (some_small _ (eventually_and _ _ (small_steps_stay_within radius x (Vector 0 1) R) (eventually_for_all
    (fun t d => ~ vy x + d * 1 == vy (source t)) (some ++ others)
    (fun t _ => leaves_a_number (vy x) 1 (vy (source t)) ltac:(lra))))) as (d & _ & close & no_end).
  set (y := moved_along x (Vector 0 1) d) in *. destruct (near y close) as [_ same]. rewrite <- same in winds.
  set (h := vy y) in *. set (met := filter (fun t => spans t h) (some ++ others)).
  destruct (least_of (fun t => - vx (point_at_height t h)) met) as (t & T & most).
  { intros none. apply winds, sum_of_zeros. intros s S. rewrite signed_crossing_by_height. fold h.
    destruct (spans s h) eqn:spanning; [exfalso | reflexivity]. assert (I : In s met)
      by (apply filter_In; split; [apply in_app_iff; now left | exact spanning]). now rewrite none in I. }
  apply filter_In in T. destruct T as [T spans_t]. set (z := point_at_height t h) in *.
  pose proof (point_at_height_lies_on t h spans_t) as on_t. fold z in on_t.
  assert (number_is : forall l, incl l (some ++ others) -> winding_number z l = 0%Z).
  { intros l part. apply sum_of_zeros. intros e E. rewrite signed_crossing_by_height. change (vy z) with h.
    destruct (spans e h) eqn:spans_e; [| reflexivity]. cbn [andb].
    destruct (negative_spec (vx z - vx (point_at_height e h))) as [less | _]; [exfalso | reflexivity].
    specialize (most e (proj2 (filter_In _ _ _) (conj (part e E) spans_e))).
    change (- vx z <= - vx (point_at_height e h)) in most. lra. }
  assert (not_both : on_one_of z some -> on_one_of z others -> False).
  { intros on_some on_others. destruct (ends_only z on_some on_others) as (e & E & [_ at_end]).
    apply (no_end e E). rewrite <- at_end. reflexivity. }
  apply in_app_iff in T. destruct T as [T | T]; [left | right]; exists z.
  - assert (on : on_one_of z some) by now exists t. split; [exact on |].
    split; [intros e E on_e; apply not_both; [exact on | now exists e] | apply number_is, incl_appr, incl_refl].
  - assert (on : on_one_of z others) by now exists t. split; [exact on |].
    split; [intros e E on_e; apply not_both; [now exists e | exact on] | apply number_is, incl_appl, incl_refl].
Qed.

Definition same_chain : forall a b : list vector, {a = b} + {a <> b} := list_eq_dec vector_dec.

Lemma number_of_chains (x : vector) (l : region) :
  winding_number x (region_edges l) = sum (map (fun a => winding_number x (edges a)) l).
Proof.
  induction l as [| a l IH]; [reflexivity |]. cbn [region_edges flat_map]. rewrite winding_number_is_additive.
  fold (region_edges l). now rewrite IH.
Qed.

Lemma in_one_part {A B : Type} (f : B -> list A) (l : list B) (a : A) (b c : B) : NoDup (flat_map f l) ->
  In b l -> In c l -> In a (f b) -> In a (f c) -> b = c.
Proof.
  induction l as [| d l IH]; intros once; [intros [] |]. cbn [flat_map] in once.
  assert (apart_ : In a (f d) -> forall e, In e l -> ~ In a (f e)).
  { intros here e E there. destruct (in_split _ _ here) as (before & after & is_). rewrite is_, <- app_assoc in once.
    apply (NoDup_remove_2 _ _ _ once). rewrite !in_app_iff. right. right. apply in_flat_map. now exists e. }
  intros [<- | I] [<- | J] in_b in_c; trivial.
  - destruct (apart_ in_b c J in_c).
  - destruct (apart_ in_c b I in_b).
  - apply IH; trivial. exact (NoDup_second _ _ _ once).
Qed.

Lemma parts_are_distinct {A B : Type} (f : B -> list A) (l : list B) : NoDup (flat_map f l) ->
  (forall b, In b l -> f b <> []) -> NoDup l.
Proof.
  induction l as [| b l IH]; intros once some; constructor.
  - intros I. destruct (f b) as [| a part] eqn:is_; [exact (some b (or_introl eq_refl) is_) |].
    cbn [flat_map] in once. rewrite is_ in once. inversion once as [| ? ? new _]; subst. apply new, in_app_iff. right.
    apply in_flat_map. exists b. split; [exact I | rewrite is_; now left].
  - apply IH; [exact (NoDup_second _ _ _ once) | intros c C; apply some; now right].
Qed.

Lemma pairs_of_different {A : Type} (related : A -> A -> Prop) (l : list A) : NoDup l ->
  (forall a b, In a l -> In b l -> a <> b -> related a b) -> ForallOrdPairs related l.
Proof.
  intros once. induction once as [| a l new once IH]; intros all; constructor.
  - apply Forall_forall. intros b B. apply all; [now left | now right |]. intros ->. contradiction.
  - apply IH. intros b c B C. apply all; now right.
Qed.

Section Chains.
  Variable chains : region.
  Hypothesis distinct_ : NoDup chains.
  Hypothesis are_simple : forall a, In a chains -> simple a.
  Hypothesis meet : edges_meet_in_vertices chains.
  Hypothesis numbers : forall x, off x (region_edges chains) -> (0 <= winding_number x (region_edges chains) <= 1)%Z.
  Hypothesis pairs_meet : forall a b, In a chains -> In b chains -> a <> b -> meet_in_ends_only (edges a) (edges b).
  Hypothesis same_all_along : forall a b p q, In a chains -> In b chains -> a <> b ->
    on_one_of p (edges b) -> off p (edges a) -> on_one_of q (edges b) -> off q (edges a) ->
    winding_number p (edges a) = winding_number q (edges a).

  Variable beside : list vector -> list vector -> vector.
  Hypothesis beside_is : forall a b, In a chains -> In b chains -> a <> b ->
    on_one_of (beside a b) (edges b) /\ off (beside a b) (edges a).

  (* How often a goes round b. *)
  Definition number (a b : list vector) : Z :=
    if same_chain a b then 0%Z else winding_number (beside a b) (edges a).

  Lemma number_at (a b : list vector) (p : vector) : In a chains -> In b chains -> a <> b ->
    on_one_of p (edges b) -> off p (edges a) -> winding_number p (edges a) = number a b.
  Proof.
    intros A B other on free. unfold number. destruct (same_chain a b); [contradiction |].
    destruct (beside_is a b A B other). now apply (same_all_along a b).
  Qed.

  Lemma number_of_itself (a : list vector) : number a a = 0%Z.
  Proof. unfold number. now destruct (same_chain a a). Qed.

  Let goes := is_round chains number.

  Lemma goes_round_another (a b : list vector) : goes a b -> a <> b.
  Proof. intros (_ & _ & some) ->. now rewrite number_of_itself in some. Qed.

  Lemma number_is (a b : list vector) : goes a b -> number a b = if is_counterclockwise a then 1%Z else (-1)%Z.
  Proof.
    intros round. pose proof (goes_round_another a b round) as other. destruct round as (A & B & some).
    unfold number in *. destruct (same_chain a b); [contradiction |]. destruct (beside_is a b A B other) as [_ free].
    pose proof (winding_numbers_of_simple_chains a _ (are_simple a A) free). destruct (is_counterclockwise a); lia.
  Qed.

  Lemma one_way (a b : list vector) : goes a b -> ~ goes b a.
  Proof.
    intros round. pose proof (goes_round_another a b round) as other. destruct round as (A & B & some).
    intros (_ & _ & some'). destruct (beside_is a b A B other) as [on free].
    destruct (one_is_outside (edges a) (edges b) (beside a b) (closed_chain_cycles a) free (pairs_meet a b A B other))
      as [(z & on_z & free_z & none) | (z & on_z & free_z & none)].
    - rewrite (number_at a b _ A B other on free). exact some.
    - apply some'. now rewrite <- (number_at b a z B A (not_eq_sym other) on_z free_z).
    - apply some. now rewrite <- (number_at a b z A B other on_z free_z).
  Qed.

  (* A point of an edge of the chain that is on no others. *)
  Lemma free_point (c : list vector) : In c chains -> exists e w, In e (edges c) /\ lies_on w e /\
    ~ is_vertex w chains.
  Proof.
    intros C. destruct (are_simple c C) as (three & long & _).
    destruct (edges c) as [| e rest] eqn:edges_are;
      [pose proof (edges_are_as_many c) as many; rewrite edges_are in many; cbn in many; lia |].
    assert (E : In e (edges c)) by (rewrite edges_are; now left).
    assert (moves : nonzero (along e)) by (apply long; now apply in_map).
    destruct (some_small _ (eventually_and _ _ (eventually_below 1 ltac:(lra)) (eventually_for_all (fun s d =>
      ~ equal_vectors (moved_along (source e) (along e) d) (source s)) (region_edges chains)
      (fun s _ => leaves_a_point (source e) (along e) (source s) moves)))) as (d & _ & range & no_vertex).
    exists e, (moved_along (source e) (along e) d). split; [now left |]. split.
    - exists d. split; [lra |]. unfold moved_along, along, minus. cbn [vx vy]. split; ring.
    - intros (s & S & equal). exact (no_vertex s S equal).
  Qed.

  Lemma edges_of (a : list vector) : In a chains -> incl (edges a) (region_edges chains).
  Proof. intros A e E. apply in_flat_map. now exists a. Qed.

  Lemma free_is_off (a c : list vector) (e : segment) (w : vector) : In a chains -> In c chains -> a <> c ->
    In e (edges c) -> lies_on w e -> ~ is_vertex w chains -> off w (edges a).
  Proof.
    intros A C other E on no_vertex s S on_s. apply no_vertex.
    destruct (pairs_meet a c A C other w) as (u & U & equal); [now exists s | now exists e |].
    exists u. split; [| exact equal]. apply in_app_iff in U. destruct U as [U | U]; [now apply (edges_of a) | now apply
      (edges_of c)].
  Qed.

  Lemma first_of_two (a b : list vector) (x : vector) : In a chains -> In b chains -> a <> b ->
    off x (edges a) -> off x (edges b) -> winding_number x (edges b) <> 0%Z ->
    number a b = winding_number x (edges a) \/ number b a = winding_number x (edges b).
  Proof.
    intros A B other free_a free_b winds.
    destruct (first_point_of_two_parts (edges b) (edges a) x (closed_chain_cycles b) (closed_chain_cycles a))
      as [(y & on & free & same) | (y & on & free & same)]; trivial.
    - intros s S. apply in_app_iff in S. destruct S; auto.
    - now apply pairs_meet, not_eq_sym.
    - left. rewrite <- same. symmetry. now apply number_at.
    - right. rewrite <- same. symmetry. apply number_at; auto.
  Qed.

  Lemma around_a_third (a b c : list vector) : In a chains -> In b chains -> In c chains ->
    a <> b -> a <> c -> b <> c -> number b c <> 0%Z -> number a b = number a c \/ number b a = number b c.
  Proof.
    intros A B C a_b a_c b_c. destruct (free_point c C) as (e & w & E & on & no_vertex).
    pose proof (free_is_off a c e w A C a_c E on no_vertex) as free_a.
    pose proof (free_is_off b c e w B C b_c E on no_vertex) as free_b.
    assert (on_c : on_one_of w (edges c)) by now exists e.
    rewrite <- (number_at a c w A C a_c on_c free_a), <- (number_at b c w B C b_c on_c free_b). now apply first_of_two.
  Qed.

  Lemma through (a b c : list vector) : goes a b -> goes b c -> goes a c.
  Proof.
    intros round_b round_c. pose proof (goes_round_another a b round_b) as a_b.
    pose proof (goes_round_another b c round_c) as b_c. pose proof (one_way a b round_b) as no_way.
    destruct (same_chain a c) as [<- | a_c]; [contradiction |].
    destruct round_b as (A & B & some_b), round_c as (_ & C & some_c).
    split; [exact A |]. split; [exact C |]. intros none.
    destruct (around_a_third a b c A B C a_b a_c b_c some_c) as [is_ | is_]; [congruence |].
    apply no_way. split; [exact B |]. split; [exact A | congruence].
  Qed.

  Lemma one_round_the_other (a b c : list vector) : goes a c -> goes b c -> a <> b -> goes a b \/ goes b a.
  Proof.
    intros round_a round_b a_b. pose proof (goes_round_another a c round_a) as a_c.
    pose proof (goes_round_another b c round_b) as b_c.
    destruct round_a as (A & C & some_a), round_b as (B & _ & some_b).
    destruct (around_a_third a b c A B C a_b a_c b_c some_b) as [is_ | is_]; [left | right]; (split; [assumption |]);
      (split; [assumption | congruence]).
  Qed.

  Lemma together (b : list vector) : In b chains ->
    sum (map (fun a => number a b) chains) = if is_counterclockwise b then 0%Z else 1%Z.
  Proof.
    intros B. destruct (free_point b B) as (e & w & E & on & no_vertex).
    set (n := Vector (- vy (along e)) (vx (along e))).
    assert (turn : 0 < cross (along e) n).
    { destruct (are_simple b B) as (_ & long & _). apply left_normal, long. now apply in_map. }
    assert (one : region_edges [b] = edges b) by apply app_nil_r.
    assert (meet_b : edges_meet_in_vertices [b]).
    { apply edges_meet_by_pairs. rewrite one. apply edges_of_one_chain; [now apply are_simple | apply incl_refl]. }
    assert (no_vertex_b : ~ is_vertex w [b]).
    { intros (u & U & equal). apply no_vertex. exists u. split; [| exact equal]. rewrite one in U.
      now apply (edges_of b B). }
    assert (others : forall a, In a chains -> eventually (fun d => a <> b ->
      winding_number (moved_along w n d) (edges a) = number a b /\
      winding_number (moved_along w n (- d)) (edges a) = number a b)).
    { intros a A. destruct (same_chain a b) as [-> | other];
        [exists 1; split; [lra |]; intros d _ _ no; now destruct no |].
      pose proof (free_is_off a b e w A B other E on no_vertex) as free.
      destruct (winding_number_near w (edges a) (closed_chain_cycles a) free) as (radius & R & near).
      rewrite <- (number_at a b w A B other) by (trivial; now exists e).
      refine (eventually_implied _ _ _ (eventually_and _ _ (small_steps_stay_within radius w n R)
        (small_steps_stay_within radius w (opposite n) R))).
      intros d [close close'] _. split; [now apply near |].
      rewrite (winding_number_of_equal (moved_along w n (- d)) (moved_along w (opposite n) d))
        by (unfold moved_along, opposite; cbn [vx vy]; ring). now apply near. }
    destruct (some_small _ (eventually_and _ _ (eventually_for_all _ chains others) (eventually_and _ _
      (left_is_one_more chains e w n meet (edges_of b B e E) on no_vertex turn)
      (left_is_one_more [b] e w n meet_b ltac:(now rewrite one) on no_vertex_b turn))))
      as (d & _ & same & (free & free' & more) & more_b). rewrite one in more_b. destruct more_b as (_ & _ & more_b).
    pose proof (numbers _ free) as range. pose proof (numbers _ free') as range'.
    assert (off_b : forall y, off y (region_edges chains) -> off y (edges b))
      by (intros y off_y s S; exact (off_y s (edges_of b B s S))).
    pose proof (winding_numbers_of_simple_chains b _ (are_simple b B) (off_b _ free)) as range_b.
    pose proof (winding_numbers_of_simple_chains b _ (are_simple b B) (off_b _ free')) as range_b'.
    rewrite (number_of_chains (moved_along w n (- d))) in *.
    pose proof (sums_differ_by (fun a => winding_number (moved_along w n (- d)) (edges a)) (fun a => number a b) b
      chains distinct_ B (fun a A other => proj2 (same a A other))) as sum_is.
    cbv beta in sum_is. rewrite number_of_itself in sum_is. destruct (is_counterclockwise b); lia.
  Qed.

  (* Components of which each outer chain is directly around the holes. *)
  Variable components : list component.
  Hypothesis chains_are : Permutation (region_of components) chains.
  Hypothesis outer_are : forall c, In c components -> is_counterclockwise (outer_chain c) = true.
  Hypothesis holes_are : forall c h, In c components -> In h (hole_chains c) ->
    is_counterclockwise h = false /\ directly_round chains number (outer_chain c) h.

  Lemma in_component (c : component) (a : list vector) : In c components -> In a (chains_of_component c) ->
    In a chains.
  Proof. intros C I. apply (Permutation_in _ chains_are), in_flat_map. now exists c. Qed.

  Lemma same_component (b c : component) (a : list vector) : In b components -> In c components ->
    In a (chains_of_component b) -> In a (chains_of_component c) -> b = c.
  Proof. apply in_one_part. exact (Permutation_NoDup (Permutation_sym chains_are) distinct_). Qed.

  Lemma chains_of_one_differ (c : component) : In c components -> NoDup (chains_of_component c).
  Proof.
    intros C. destruct (in_split _ _ C) as (before & after & is_).
    pose proof (Permutation_NoDup (Permutation_sym chains_are) distinct_) as once. unfold region_of in once.
    rewrite is_, flat_map_app in once. apply NoDup_second in once. cbn [flat_map] in once.
    exact (NoDup_second _ _ _ (Permutation_NoDup (Permutation_app_comm _ _) once)).
  Qed.

  Lemma all_holes_of (c : component) (h : list vector) : In c components ->
    In h (hole_chains c) <-> is_counterclockwise h = false /\ directly_round chains number (outer_chain c) h.
  Proof.
    intros C. split; [now apply holes_are |]. intros [clockwise direct].
    pose proof (Permutation_in _ (Permutation_sym chains_are) (proj1 (proj2 (proj1 direct)))) as I.
    apply in_flat_map in I. destruct I as (d & D & [<- | I]); [rewrite (outer_are d D) in clockwise; discriminate |].
    enough (c = d) as -> by exact I.
    destruct (holes_are d h D I) as [_ direct']. apply (same_component c d (outer_chain c)); trivial; [now left |].
    destruct (same_chain (outer_chain c) (outer_chain d)) as [-> | other]; [now left | exfalso].
    exact (one_way _ _ (proj2 direct' _ (proj1 direct) other) (proj2 direct _ (proj1 direct') (not_eq_sym other))).
  Qed.

  Lemma is_outside_of (a b : list vector) (p : vector) : In a chains -> In b chains -> a <> b -> ~ goes a b ->
    on_one_of p (edges b) -> off p (edges a) -> is_outside p (edges a).
  Proof.
    intros A B other no on free. split; [exact free |]. rewrite (number_at a b p A B other on free).
    exact (not_round chains number a b A B no).
  Qed.

  (* Theorem. *)
  Theorem nested_components_are_valid : valid_components components.
  Proof.
    split.
    - intros c C. assert (O : In (outer_chain c) chains) by (apply (in_component c); [exact C | now left]).
      assert (H : forall h, In h (hole_chains c) -> In h chains)
        by (intros h I; apply (in_component c); [exact C | now right]).
      split; [now apply are_simple |]. split; [now apply outer_are |]. split.
      + intros h I. destruct (holes_are c h C I) as [clockwise [round _]]. specialize (H h I).
        pose proof (goes_round_another _ _ round) as other.
        split; [now apply are_simple |]. split; [exact clockwise |].
        split; [now apply pairs_meet, not_eq_sym |]. split; intros p on free.
        * intros [_ none]. rewrite (number_at (outer_chain c) h) in none by assumption. now apply round.
        * apply (is_outside_of h (outer_chain c)); auto. now apply one_way.
      + pose proof (chains_of_one_differ c C) as once. inversion once as [| ? ? _ once_holes]; subst.
        apply pairs_of_different; [exact once_holes |]. intros g h G I other.
        destruct (holes_are c g C G) as [_ direct_g], (holes_are c h C I) as [_ direct_h].
        split; [auto |]. split; intros p on free; [apply (is_outside_of h g) | apply (is_outside_of g h)]; auto;
          now apply (beside_within _ _ one_way (outer_chain c)).
    - assert (outside : forall b c, In b components -> In c components -> b <> c -> forall p,
        on_one_of p (edges_of_component b) -> off p (edges_of_component c) -> is_outside p (edges_of_component c)).
      { intros b c B C other p (s & S & on) free. split; [exact free |]. apply in_flat_map in S.
        destruct S as (x & X & S).
        assert (not_own : ~ In x (chains_of_component c)) by (intros X'; apply other; now apply (same_component b c x)).
        change (edges_of_component c) with (region_edges (chains_of_component c)). rewrite number_of_chains.
        rewrite (map_ext_in _ (fun a => number a x)).
        - pose proof (chains_of_one_differ c C) as once. inversion once as [| ? ? _ once_holes]; subst.
          apply (components_are_beside same_chain chains distinct_ number is_counterclockwise number_of_itself number_is
            one_way through one_round_the_other together); auto.
          + apply (in_component c); [exact C | now left].
          + now apply (in_component b).
          + intros ->. apply not_own. now left.
          + intros g. now apply all_holes_of.
          + intros I. apply not_own. now right.
        - intros a A. apply number_at; [now apply (in_component c) | now apply (in_component b) | | now exists s |].
          + intros ->. contradiction.
          + intros e E. apply free, in_flat_map. now exists a. }
      apply pairs_of_different.
      + apply (parts_are_distinct chains_of_component); [| discriminate].
        exact (Permutation_NoDup (Permutation_sym chains_are) distinct_).
      + intros b c B C other. split; [| split; intros p; apply outside; auto].
        intros p (s & S & on_s) (t & T & on_t). apply in_flat_map in S, T.
        destruct S as (x & X & S), T as (y & Y & T).
        destruct (pairs_meet x y) with (p := p) as (u & U & equal); [now apply (in_component b) |
          now apply (in_component c) | | now exists s | now exists t |].
        * intros ->. apply other. now apply (same_component b c y).
        * exists u. split; [| exact equal]. apply in_app_iff. apply in_app_iff in U.
          destruct U as [U | U]; [left; apply in_flat_map; now exists x | right; apply in_flat_map; now exists y].
  Qed.
End Chains.
