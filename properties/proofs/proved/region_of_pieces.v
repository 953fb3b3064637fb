(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The region of a set that ends at pieces of segments: chains of the pieces that are kept. As many of these leave a
   point as enter it (beside_a_vertex.v), so walks take them all; the region is valid; and it is the closure of
   the set's interior. *)
From Coq Require Import QArith Qminmax Lqa ZArith Lia Bool List Permutation.
From Oplus Require Import balanced_edges regions_and_sums right_of_an_edge observation_2_2_4 naive_collision
  collision_is_sound pieces beside_a_piece filling kept_pieces_go_round cut_pieces beside_a_vertex walks.
Import ListNotations.

Open Scope Q_scope.

(* The closure of the interior of a set. *)
Definition regularised (A : vector -> Prop) (x : vector) : Prop :=
  forall radius, 0 < radius -> exists y, within radius x y /\
    exists inner, 0 < inner /\ forall z, within inner y z -> A z.

Lemma permuted_winding_number (x : vector) (l m : list segment) :
  Permutation l m -> winding_number x l = winding_number x m.
Proof. intros permuted. unfold winding_number, sum. induction permuted; cbn; lia. Qed.

Section Region.
  Variable segments : list segment.
  Hypothesis all_long : forall t, In t segments -> nonzero (along t).
  Variable inside : vector -> bool.
  Variable right_inside : segment -> bool.
  Let pieces := pieces_of segments.
  Hypothesis ends_ : ends_at_pieces inside right_inside pieces.
  Let kept := kept_pieces right_inside pieces.

  Let parts := pieces_share_ends _ _ _ ends_.

  Lemma of_kept (s : segment) : In s kept <-> directed pieces s /\ right_inside (reversed s) = true /\
    right_inside s = false.
  Proof.
    unfold kept, kept_pieces, directed, kept_piece. rewrite in_flat_map. split.
    - intros (e & E & I). destruct (right_inside (reversed e)) eqn:l, (right_inside e) eqn:r;
        try destruct I as [<- | []]; try destruct I; rewrite ?reversed_twice; tauto.
    - intros ([S | S] & l & r); [exists s | exists (reversed s)]; (split; [exact S |]); rewrite ?reversed_twice, l, r;
        now left.
  Qed.

  Lemma kept_is_distinct : NoDup kept.
  Proof.
    set (is_kept := fun s => right_inside (reversed s) && negb (right_inside s)).
    apply (Permutation_NoDup (l := filter is_kept (pieces ++ map reversed pieces))).
    - unfold kept, kept_pieces. generalize pieces. intros l. induction l as [| e l IH]; [reflexivity |].
      rewrite filter_app in *. cbn [map filter flat_map]. unfold kept_piece.
      destruct (is_kept e) eqn:k, (is_kept (reversed e)) eqn:k'; unfold is_kept in k, k'; rewrite reversed_twice in k';
        destruct (right_inside (reversed e)), (right_inside e); try discriminate; trivial; cbn [app];
          [now constructor |].
      rewrite <- IH. symmetry. apply Permutation_middle.
    - now apply NoDup_filter, both_directions_are_distinct.
  Qed.

  Theorem kept_share_ends : share_ends_only kept.
  Proof.
    apply (some_directions pieces parts); [exact kept_is_distinct |]. intros s (D & _ & r)%of_kept.
    split; [exact D |]. intros (_ & l & _)%of_kept. rewrite reversed_twice in l. congruence.
  Qed.

  (* Theorem. As many leave as enter. *)
  Theorem kept_is_balanced : is_balanced kept.
  Proof.
    intros v. rewrite <- (left_and_right_of_rays pieces parts inside right_inside (same_off_pieces _ _ _ ends_)
      (same_beside_pieces _ _ _ ends_) as_number v).
    unfold rays, kept, kept_pieces. generalize pieces. intros l. induction l as [| e l IH]; [reflexivity |].
    unfold surplus in *. rewrite filter_app in *. cbn [flat_map map filter]. rewrite !map_app, !sum_of_both in *.
    rewrite IH.
    assert (twice : right_inside (reversed (reversed e)) = right_inside e) by now rewrite reversed_twice.
    change (source (reversed e)) with (target e). unfold kept_piece, one_if, sum.
    destruct (vector_dec (source e) v) as [s_is |], (vector_dec (target e) v) as [t_is |],
      (right_inside (reversed e)) eqn:left_, (right_inside e) eqn:right_;
      cbn [map fold_right reversed source target as_number]; rewrite ?twice, ?left_, ?right_, ?s_is, ?t_is;
      repeat (destruct (vector_dec _ _)); try contradiction; cbn [as_number]; lia.
  Qed.

  Corollary chains_of_kept : Permutation (region_edges (chains_of (length kept) kept)) kept.
  Proof. apply chains_take_all; [lia | exact kept_is_balanced]. Qed.

  Lemma off_pieces (y : vector) : off y segments -> off y pieces.
  Proof.
    intros free e E on. destruct (pieces_are_on _ _ (pieces_are_pieces segments all_long) e y E on) as (t & T & on_t).
    exact (free t T on_t).
  Qed.

  Variable chains : region.
  Hypothesis edges_are : Permutation (region_edges chains) kept.

  Lemma round_the_chains (y : vector) : off y segments -> winding_number y (region_edges chains) = as_number (inside y).
  Proof.
    intros free. rewrite (permuted_winding_number y _ _ edges_are). apply (core_off_pieces _ _ _ ends_).
    now apply off_pieces.
  Qed.

  (* Theorem. *)
  Theorem chains_are_valid : valid_region chains.
  Proof.
    split; [| split].
    - intros chain J e I. unfold edge_directions in I. apply in_map_iff in I. destruct I as (s & <- & I).
      apply (are_long _ kept_share_ends), (Permutation_in _ edges_are), in_flat_map. now exists chain.
    - intros x _. rewrite (permuted_winding_number x _ _ edges_are).
      destruct (some_small _ (core _ _ _ ends_ x)) as (d & _ & number_is). unfold kept. rewrite number_is.
      destruct (inside _); cbn; lia.
    - intros earlier s later t w list_is T on_s on_t.
      assert (S' : In s (region_edges chains)) by (rewrite list_is; apply in_app_iff; cbn; tauto).
      assert (T' : In t (region_edges chains))
        by (rewrite list_is; apply in_app_iff; apply in_app_iff in T; cbn; tauto).
      assert (other : s <> t).
      { pose proof (Permutation_NoDup (Permutation_sym edges_are) kept_is_distinct) as distinct_.
        rewrite list_is in distinct_. intros <-. exact (NoDup_remove_2 _ _ _ distinct_ T). }
      destruct (inside_or_end w s on_s) as [in_s | [equal | equal]].
      + apply (Permutation_in _ edges_are) in S', T'. destruct (nothing_inside _ kept_share_ends s t w S' T' other on_t
          in_s).
      + exists s. split; [exact S' | now symmetry].
      + destruct (target_is_vertex chains s S') as (v & V & equal'). exists v. split; [exact V |].
        transitivity (target s); [now symmetry | exact equal'].
  Qed.

  (* A point off the segments near which are inner points of A is in the set, and so are those
     with its winding number. *)
  Lemma inside_near_inner_points (A : vector -> Prop) (x : vector) (radius : Q) :
    (forall y, off y segments -> (A y <-> inside y = true)) -> regularised A x -> 0 < radius ->
    exists z, within radius x z /\ off z segments /\ inside z = true.
  Proof.
    intros A_is closure_ R. destruct (closure_ ((1 # 2) * radius)) as (y & close & inner & I & all_in); [lra |].
    destruct (some_small _ (eventually_and _ _ (eventually_and _ _ (shifted_stays_within inner y I)
      (shifted_stays_within ((1 # 2) * radius) y ltac:(lra))) (shifted_off_all y segments)))
      as (e & _ & (close_i & close_z) & free_z).
    exists (moved (shifted y) e). split; [unfold within in *; lra |]. split; [exact free_z |].
    apply A_is; [exact free_z | now apply all_in].
  Qed.

  Lemma inside_near_the_chains (x : vector) (radius : Q) : in_region x chains -> 0 < radius ->
    exists y, within radius x y /\ off y segments /\ inside y = true.
  Proof.
    intros in_ R.
    apply (inside_near_inner_points (fun y => (0 < winding_number y (region_edges chains))%Z) x radius); trivial.
    - intros y free. rewrite round_the_chains by exact free. now destruct (inside y).
    - destruct chains_are_valid as (edges_ & numbers_ & meet_). intros r r_some.
      destruct (inside_near _ x r (regions_are_regular _ edges_ numbers_ meet_) in_ r_some)
        as (z & close & free & some).
      destruct (winding_number_near z _ (region_cycles chains) free) as (inner & I & near). exists z.
      split; [exact close |]. exists inner. split; [exact I |]. intros u close_u.
      now destruct (near u close_u) as [_ ->].
  Qed.

  (* Theorem. If off the segments the set is A, the region is the closure of the interior of A. *)
  Theorem points_of_the_chains (A : vector -> Prop) (x : vector) :
    (forall y, off y segments -> (A y <-> inside y = true)) -> (in_region x chains <-> regularised A x).
  Proof.
    intros A_is. split.
    - intros in_ radius R.
      destruct (inside_near_the_chains x radius in_ R) as (y & close & free & inside_). exists y.
      split; [exact close |].
      destruct (off_near y segments free) as (r1 & R1 & near_1).
      destruct (unchanged_near _ _ _ ends_ y (off_pieces y free)) as (r2 & R2 & near_2).
      exists (Qmin r1 r2). split; [now apply Q.min_glb_lt |]. intros z close_z.
      pose proof (Q.le_min_l r1 r2). pose proof (Q.le_min_r r1 r2).
      apply A_is; [apply near_1 | rewrite <- inside_; apply near_2];
        apply (within_smaller (Qmin r1 r2)); trivial.
    - intros closure_. destruct (on_or_off x (region_edges chains)) as [on | free]; [now right | left].
      destruct (winding_number_near x _ (region_cycles chains) free) as (radius & R & near).
      destruct (inside_near_inner_points A x radius A_is closure_ R) as (z & close & free_z & inside_z).
      destruct (near z close) as [_ <-]. rewrite round_the_chains, inside_z by exact free_z. cbn. lia.
  Qed.

  (* Corollary. If the segments are in A, and near each point of A are inner points of it, the region is A. *)
  Corollary points_of_a_closed_set (A : vector -> Prop) (x : vector) :
    (forall y, off y segments -> (A y <-> inside y = true)) ->
    (forall y t, In t segments -> lies_on y t -> A y) -> (forall y, A y -> regularised A y) ->
    (in_region x chains <-> A x).
  Proof.
    intros A_is on_segments regular. rewrite (points_of_the_chains A x A_is). split; [| apply regular].
    intros closure_. destruct (on_or_off x segments) as [(t & T & on) | free]; [exact (on_segments x t T on) |].
    apply A_is; [exact free |]. destruct (unchanged_near _ _ _ ends_ x (off_pieces x free)) as (radius & R & near).
    destruct (inside_near_inner_points A x radius A_is closure_ R) as (z & close & free_z & inside_z).
    now destruct (near z close) as [_ <-].
  Qed.
End Region.
