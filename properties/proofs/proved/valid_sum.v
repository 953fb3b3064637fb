(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* What sum_of_regions (total_sum.v) returns is as valid as what it was given: no edge is a point, winding numbers are 0
   and 1, and edges meet in vertices only. *)
From Coq Require Import QArith Lqa ZArith Lia Bool List Permutation.
From Oplus Require Import direction angular_crossings winding_number turning_number convolution_size states
  in_out_degree regions meeting_of_segments convolution_winding left_of_an_edge theorem_4_2_1 naive_collision
  collision_is_sound pieces filling kept_pieces_go_round cut_pieces kept_pieces_balance sum_is_right.
Import ListNotations.

Open Scope Q_scope.

Section Kept.
  Variable segments : list segment.
  Hypothesis all_long : forall t, In t segments -> nonzero (along t).

  Definition no_common_inside (s t : segment) : Prop := forall w, strictly_inside w s -> ~ strictly_inside w t.

  Lemma different_pieces (e f : segment) : In e (pieces_of segments) -> In f (pieces_of segments) -> e <> f ->
    no_common_inside e f.
  Proof.
    intros E F differ w. destruct (in_split _ _ E) as (before & after & pieces_are).
    apply (pieces_are_apart _ _ (pieces_are_pieces segments all_long) before e after f w pieces_are).
    rewrite pieces_are in F. apply in_app_iff in F. apply in_app_iff. destruct F as [F | [F | F]]; tauto.
  Qed.

  Lemma kept_is (e s : segment) : In s (kept_piece segments e) -> kept_piece segments e = [s] /\ (s = e \/ s =
    reversed e).
  Proof.
    unfold kept_piece. destruct (is_right_inside segments (reversed e)), (is_right_inside segments e); intros I;
      try destruct I as [<- | []]; try destruct I; tauto.
  Qed.

  Lemma inside_of_kept (e s : segment) (w : vector) : In s (kept_piece segments e) ->
    strictly_inside w s <-> strictly_inside w e.
  Proof.
    intros I. apply kept_is in I. destruct I as [_ [-> | ->]]; [tauto |]. split; [| apply strictly_inside_reversed].
    intros inside_. apply strictly_inside_reversed in inside_. now rewrite reversed_twice in inside_.
  Qed.

  Lemma different_kept (s t : segment) : In s (filled segments) -> In t (filled segments) -> s <> t ->
    no_common_inside s t.
  Proof.
    intros S T differ w in_s in_t. apply in_flat_map in S, T. destruct S as (e & E & S), T as (f & F & T).
    apply (inside_of_kept e s w S) in in_s. apply (inside_of_kept f t w T) in in_t.
    refine (different_pieces e f E F _ w in_s in_t). intros <-.
    destruct (kept_is e s S) as [one _], (kept_is e t T) as [two _]. congruence.
  Qed.

  Lemma filled_is_distinct : NoDup (filled segments).
  Proof.
    unfold filled. assert (distinct_ : NoDup (pieces_of segments)) by apply NoDup_nodup.
    assert (part : incl (pieces_of segments) (pieces_of segments)) by apply incl_refl.
    revert distinct_ part. generalize (pieces_of segments) at 1 2 4. intros l. induction l as [| e l IH];
      [constructor |].
    intros distinct_ part. inversion distinct_ as [| ? ? new rest]; subst. cbn [flat_map].
    assert (rest_is : NoDup (flat_map (kept_piece segments) l)) by (apply IH; trivial; intros f F; apply part;
      now right).
    destruct (kept_piece segments e) as [| s more] eqn:kept_; [exact rest_is |].
    assert (S : In s (kept_piece segments e)) by (rewrite kept_; now left).
    destruct (kept_is e s S) as [only _]. rewrite kept_ in only. injection only as ->. cbn [app]. constructor;
      [| exact rest_is].
    intros again. apply in_flat_map in again. destruct again as (f & F & again).
    pose proof (middle_is_inside s) as inside_.
    apply (different_pieces e f) with (middle s).
    - apply part. now left.
    - apply part. now right.
    - intros <-. contradiction.
    - now apply (inside_of_kept e s).
    - now apply (inside_of_kept f s).
  Qed.

  Lemma filled_is_long (s : segment) : In s (filled segments) -> nonzero (along s).
  Proof.
    intros S. apply in_flat_map in S. destruct S as (e & E & S). apply kept_is in S.
    pose proof (pieces_are_long _ _ (pieces_are_pieces segments all_long) e E) as long.
    destruct S as [_ [-> | ->]]; [exact long |]. exact (long_of_one_place _ _ (reversed_place e) long).
  Qed.
End Kept.

(* Theorem. *)
Theorem sums_are_valid (p q chains : region) : valid_region p -> valid_region q ->
  Permutation (region_edges chains) (filled (convolution_segments p q)) -> valid_region chains.
Proof.
  intros p_region q_region edges_are.
  assert (all_long : forall t, In t (convolution_segments p q) -> nonzero (along t))
    by (intros t; now apply all_are_long).
  split; [| split].
  - intros chain J e I. unfold edge_directions in I. apply in_map_iff in I. destruct I as (s & <- & I).
    apply (filled_is_long _ all_long). apply (Permutation_in _ edges_are). apply in_flat_map. now exists chain.
  - intros x _. rewrite (winding_number_of_chains p q chains p_region q_region edges_are).
    destruct (0 <? _)%Z; lia.
  - intros earlier s later t w list_is T on_s on_t.
    assert (S' : In s (region_edges chains)) by (rewrite list_is; apply in_app_iff; cbn; tauto).
    assert (T' : In t (region_edges chains))
      by (rewrite list_is; apply in_app_iff; apply in_app_iff in T; cbn; tauto).
    assert (ends : forall u, In u (region_edges chains) -> equal_vectors (source u) w \/ equal_vectors (target u) w ->
      is_vertex w chains).
    { intros u U [equal | equal].
      - exists u. split; [exact U |]. now symmetry.
      - destruct (target_is_vertex chains u U) as (v & V & equal'). exists v. split; [exact V |].
        transitivity (target u); [now symmetry | exact equal']. }
    assert (inside_dec : forall u, lies_on w u -> strictly_inside w u \/ equal_vectors (source u) w \/ equal_vectors
      (target u) w).
    { intros u (k & range & X & Y). destruct (Qlt_le_dec 0 k) as [some | none].
      - destruct (Qlt_le_dec k 1) as [less | all].
        + left. exists k. split; [lra | tauto].
        + right. right. assert (k_is : k == 1) by lra. rewrite k_is in X, Y. split; lra.
      - right. left. assert (k_is : k == 0) by lra. rewrite k_is in X, Y. split; lra. }
    destruct (inside_dec s on_s) as [in_s | end_]; [| now apply (ends s)].
    destruct (inside_dec t on_t) as [in_t | end_]; [| now apply (ends t)]. exfalso.
    assert (distinct_ : NoDup (region_edges chains))
      by (apply (Permutation_NoDup (Permutation_sym edges_are)), (filled_is_distinct _ all_long)).
    rewrite list_is in distinct_. apply NoDup_remove_2 in distinct_.
    refine (different_kept _ all_long s t _ _ _ w in_s in_t); [now apply (Permutation_in _ edges_are) .. |].
    intros <-. contradiction.
Qed.
