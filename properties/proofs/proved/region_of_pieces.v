(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The region of a set that ends at pieces of segments: chains of the pieces that are kept. As many of these leave a
   point as enter it (kept_pieces_balance.v), so walks take them all; the region is valid; and it is the closure of
   the set's interior. *)
From Coq Require Import QArith Qminmax Lqa ZArith Lia Bool List Permutation.
From Oplus Require Import balanced_edges regions_and_sums right_of_an_edge observation_2_2_4 naive_collision
  collision_is_sound pieces beside_a_piece filling kept_pieces_go_round cut_pieces kept_pieces_balance walks.
Import ListNotations.

Open Scope Q_scope.

(* The closure of the interior of a set. *)
Definition regularised (A : vector -> Prop) (x : vector) : Prop :=
  forall radius, 0 < radius -> exists y, within radius x y /\
    exists inner, 0 < inner /\ forall z, within inner y z -> A z.

Lemma permuted_winding_number (x : vector) (l m : list segment) :
  Permutation l m -> winding_number x l = winding_number x m.
Proof. intros permuted. unfold winding_number, sum. induction permuted; cbn; lia. Qed.

Lemma same_point_is (v w : vector) : is_reduced v -> is_reduced w -> as_number (same_point v w) = one_if v w.
Proof.
  intros v_reduced w_reduced. unfold one_if. destruct (same_point_spec v w) as [equal | differ].
  - apply reduced_of_equal in equal. rewrite v_reduced, w_reduced in equal.
    destruct (vector_dec v w); [reflexivity | contradiction].
  - destruct (vector_dec v w) as [-> |]; [exfalso; apply differ; split; reflexivity | reflexivity].
Qed.

Lemma between_near (radius : Q) (x y : vector) : 0 < radius ->
  eventually (fun t => within radius x (Vector ((1 - t) * vx x + t * vx y) ((1 - t) * vy x + t * vy y))).
Proof.
  intros R. refine (eventually_implied _ _ _ (small_steps_stay_within radius x (minus y x) R)).
  intros t. unfold within, moved_along, minus. cbn [vx vy]. lra.
Qed.

Section Region.
  Variable segments : list segment.
  Hypothesis all_long : forall t, In t segments -> nonzero (along t).
  Variable inside : vector -> bool.
  Variable right_inside : segment -> bool.
  Let pieces := pieces_of segments.
  Hypothesis ends_ : ends_at_pieces inside right_inside pieces.
  Let kept := kept_pieces right_inside pieces.

  Lemma surplus_of_kept (v : vector) (l : list segment) : is_reduced v -> incl l pieces ->
    surplus v (flat_map (kept_piece right_inside) l) = weighted right_inside (leaves v) l.
  Proof.
    intros v_reduced part. induction l as [| e l IH]; [reflexivity |].
    assert (E : In e pieces) by (apply part; now left).
    destruct (ends_are_reduced segments all_long e E) as [s_reduced t_reduced].
    cbn [flat_map]. unfold surplus at 1. rewrite map_app, sum_of_both.
    fold (surplus v (flat_map (kept_piece right_inside) l)). rewrite IH by (intros f F; apply part; now right).
    unfold weighted. cbn [map]. unfold sum at 2. cbn [fold_right]. f_equal.
    unfold kept_piece, kept_sign, leaves. rewrite !same_point_is by assumption.
    destruct (right_inside (reversed e)), (right_inside e); unfold sum;
      cbn [map fold_right as_number reversed source target]; lia.
  Qed.

  (* Theorem. As many leave as enter. *)
  Theorem kept_is_balanced : is_balanced kept.
  Proof.
    intros v. set (ends_in := fun e => source e = v \/ target e = v).
    destruct (Exists_dec ends_in pieces) as [some | none].
    { intros e. unfold ends_in. destruct (vector_dec (source e) v), (vector_dec (target e) v); tauto. }
    - apply Exists_exists in some. destruct some as (e & E & end_).
      assert (v_end : v = source e \/ v = target e) by (destruct end_; [left | right]; congruence).
      destruct (ends_are_reduced segments all_long e E) as [s_reduced t_reduced].
      unfold kept, kept_pieces. rewrite surplus_of_kept;
        [| destruct v_end as [-> | ->]; assumption | apply incl_refl].
      apply (balanced_at _ _ _ ends_).
      + intros f. now apply pieces_are_in_order.
      + intros f F. now apply (no_vertex_is_inside segments all_long e f v).
    - assert (no_end : forall e, In e pieces -> source e <> v /\ target e <> v).
      { intros e E. split; intros end_; apply none, Exists_exists; exists e; split; trivial; [now left | now right]. }
      unfold kept, kept_pieces. revert no_end. generalize pieces. intros l no_end.
      induction l as [| e l IH]; [reflexivity |]. cbn [flat_map]. unfold surplus. rewrite map_app, sum_of_both.
      fold (surplus v (flat_map (kept_piece right_inside) l)).
      rewrite IH by (intros f F; apply no_end; now right). destruct (no_end e (or_introl eq_refl)) as [a b].
      unfold kept_piece. destruct (right_inside (reversed e)), (right_inside e); unfold sum;
        cbn [map fold_right reversed source target]; unfold one_if;
        destruct (vector_dec (source e) v), (vector_dec (target e) v); try contradiction; reflexivity.
  Qed.

  Corollary chains_of_kept : Permutation (region_edges (chains_of (length kept) kept)) kept.
  Proof. apply chains_take_all; [lia | exact kept_is_balanced]. Qed.

  Lemma inside_of_kept (e s : segment) (w : vector) : In s (kept_piece right_inside e) ->
    strictly_inside w s <-> strictly_inside w e.
  Proof.
    intros I. apply kept_is in I. destruct I as [_ [-> | ->]]; [tauto |]. split; [| apply strictly_inside_reversed].
    intros inside_. apply strictly_inside_reversed in inside_. now rewrite reversed_twice in inside_.
  Qed.

  Lemma different_kept (s t : segment) : In s kept -> In t kept -> s <> t -> no_common_inside s t.
  Proof.
    intros S T differ w in_s in_t. apply in_flat_map in S, T. destruct S as (e & E & S), T as (f & F & T).
    apply (inside_of_kept e s w S) in in_s. apply (inside_of_kept f t w T) in in_t.
    refine (different_pieces segments all_long e f E F _ w in_s in_t). intros <-.
    destruct (kept_is right_inside e s S) as [one _], (kept_is right_inside e t T) as [two _]. congruence.
  Qed.

  Lemma kept_is_distinct : NoDup kept.
  Proof.
    unfold kept, kept_pieces. assert (distinct_ : NoDup pieces) by apply NoDup_nodup.
    assert (part : incl pieces pieces) by apply incl_refl.
    revert distinct_ part. generalize pieces at 1 2 4. intros l.
    induction l as [| e l IH]; [constructor |].
    intros distinct_ part. inversion distinct_ as [| ? ? new rest]; subst. cbn [flat_map].
    assert (rest_is : NoDup (flat_map (kept_piece right_inside) l))
      by (apply IH; trivial; intros f F; apply part; now right).
    destruct (kept_piece right_inside e) as [| s more] eqn:kept_; [exact rest_is |].
    assert (S : In s (kept_piece right_inside e)) by (rewrite kept_; now left).
    destruct (kept_is right_inside e s S) as [only _]. rewrite kept_ in only. injection only as ->. cbn [app].
    constructor; [| exact rest_is].
    intros again. apply in_flat_map in again. destruct again as (f & F & again).
    pose proof (middle_is_inside s) as inside_.
    apply (different_pieces segments all_long e f) with (middle s).
    - apply part. now left.
    - apply part. now right.
    - intros <-. contradiction.
    - now apply (inside_of_kept e s).
    - now apply (inside_of_kept f s).
  Qed.

  Lemma kept_is_long (s : segment) : In s kept -> nonzero (along s).
  Proof.
    intros S. apply in_flat_map in S. destruct S as (e & E & S). apply kept_is in S.
    pose proof (pieces_have_length _ _ _ ends_ e E) as long.
    destruct S as [_ [-> | ->]]; [exact long |]. exact (long_of_one_place _ _ (reversed_place e) long).
  Qed.

  Lemma beside_is_off (e : segment) (w n : vector) : In e pieces -> strictly_inside w e ->
    ~ cross (along e) n == 0 -> eventually (fun d => off (moved_along w n d) pieces).
  Proof.
    intros E inside_ turn. apply (eventually_for_all (fun f d => ~ lies_on (moved_along w n d) f)). intros f F.
    destruct (segment_dec e f) as [<- | differ].
    - exists 1. split; [lra |]. intros d some _. apply off_by_area.
      pose proof (on_the_line w e (strictly_inside_lies_on w e inside_)) as line.
      setoid_replace (area e (moved_along w n d)) with (area e w + d * cross (along e) n) by by_coordinates.
      rewrite line. intros zero_. destruct (Qmult_integral d (cross (along e) n)); [lra | lra | contradiction].
    - assert (free : ~ lies_on w f)
        by (intros on; exact (differ (inside_one_piece segments all_long e f w E F inside_ on))).
      destruct (off_one_segment_near w f free) as (radius & R & near).
      refine (eventually_implied _ _ _ (small_steps_stay_within radius w n R)). intros d. apply near.
  Qed.

  (* Near a point of a kept piece are points of the set off all segments. *)
  Lemma inside_near_kept (f : segment) (x : vector) (radius : Q) : In f kept -> lies_on x f -> 0 < radius ->
    exists y, within radius x y /\ off y segments /\ inside y = true.
  Proof.
    intros I on R. assert (long := kept_is_long f I). apply in_flat_map in I. destruct I as (e & E & I).
    assert (which : f = e \/ f = reversed e) by (now apply kept_is in I).
    assert (left_ : right_inside (reversed f) = true).
    { unfold kept_piece in I. destruct (right_inside (reversed e)) eqn:l, (right_inside e) eqn:r;
        try destruct I as [<- | []]; try destruct I; [exact l |]. now rewrite reversed_twice. }
    destruct (some_small _ (eventually_and _ _ (between_near ((1 # 2) * radius) x (middle f) ltac:(lra))
      (eventually_below 1 ltac:(lra)))) as (t & t_some & near & _ & t_less). set (w := Vector _ _) in near.
    assert (inside_f : strictly_inside w f).
    { destruct on as (k & range & X & Y). exists ((1 - t) * k + t * (1 # 2)). split; [split; nra |].
      unfold w, middle. cbn [vx vy]. rewrite X, Y. split; field. }
    assert (inside_e : strictly_inside w e) by (now apply (inside_of_kept e f)).
    set (n := Vector (- vy (along f)) (vx (along f))). pose proof (left_normal f long) as turn. fold n in turn.
    destruct (some_small _ (eventually_and _ _ (same_beside_pieces _ _ _ ends_ e (reversed f) w n E
        ltac:(destruct which as [-> | ->]; [now right | left; apply reversed_twice])
        (strictly_inside_reversed _ _ inside_f) ltac:(in_coordinates; lra))
      (eventually_and _ _ (beside_is_off e w n E inside_e ltac:(destruct which as [-> | ->]; in_coordinates; lra))
        (small_steps_stay_within ((1 # 2) * radius) w n ltac:(lra))))) as (d & _ & inside_ & free & close).
    exists (moved_along w n d). split; [unfold within in *; lra |]. split.
    - intros s S on_s.
      destruct (pieces_are_all _ _ (pieces_are_pieces segments all_long) s _ S on_s) as (e' & E' & on').
      exact (free e' E' on').
    - now rewrite inside_, left_.
  Qed.

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
      apply kept_is_long. apply (Permutation_in _ edges_are). apply in_flat_map. now exists chain.
    - intros x _. rewrite (permuted_winding_number x _ _ edges_are).
      destruct (core _ _ _ ends_ x) as (limit & L & number_is). unfold kept.
        rewrite (number_is ((1 # 2) * limit)) by lra.
      destruct (inside _); cbn; lia.
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
      assert (distinct_ : NoDup (region_edges chains))
        by (apply (Permutation_NoDup (Permutation_sym edges_are)), kept_is_distinct).
      rewrite list_is in distinct_. apply NoDup_remove_2 in distinct_.
      assert (apart_ : no_common_inside s t).
      { apply different_kept; [now apply (Permutation_in _ edges_are) .. |]. intros <-. contradiction. }
      destruct (inside_or_end w s on_s) as [in_s | end_]; [| now apply (ends s)].
      apply (ends t T'). apply on_but_not_inside; [exact on_t | exact (apart_ w in_s)].
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

  (* Theorem. If off the segments the set is A, the region is the closure of the interior of A. *)
  Theorem points_of_the_chains (A : vector -> Prop) (x : vector) :
    (forall y, off y segments -> (A y <-> inside y = true)) -> (in_region x chains <-> regularised A x).
  Proof.
    intros A_is. split.
    - intros in_ radius R.
      assert (some : exists y, within radius x y /\ off y segments /\ inside y = true).
      { destruct in_ as [positive_ | (f & F & on)].
        - rewrite (permuted_winding_number x _ _ edges_are) in positive_.
          destruct (some_small _ (eventually_and _ _ (core _ _ _ ends_ x) (eventually_and _ _
            (shifted_stays_within radius x R) (shifted_off_all x segments)))) as (e & _ & number_is & close & free).
          exists (moved (shifted x) e). split; [exact close |]. split; [exact free |].
          unfold kept in positive_. rewrite number_is in positive_.
          destruct (inside _); [reflexivity | cbn in positive_; lia].
        - apply (inside_near_kept f x radius); trivial. now apply (Permutation_in _ edges_are). }
      destruct some as (y & close & free & inside_). exists y. split; [exact close |].
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
