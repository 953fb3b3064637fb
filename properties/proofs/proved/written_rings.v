(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Rings of segments that have nothing but ends in common, without vertices in straight lines (canonical_chains.v), are
   a valid region again. One ring is a simple chain, and stays one when a vertex between the two beside it is left out.
   Two rings that crossed at such a point: on the other one's edges before and after it, one goes round differently
   often; but on the right of all edges of a ring that is the same (clockwise_most_walks.v). *)
From Coq Require Import QArith Lqa Qfield ZArith Arith Lia Bool List Permutation.
From Oplus Require Import regions_and_sums balanced_edges distinct simple_chain simple_chains_turn_once
  edges_of_valid_regions right_of_an_edge observation_2_2_4 boundary_points collision_is_complete placed_collision
  pieces beside_a_piece kept_pieces_go_round walks coordinates complement_in_a_frame touching_vertices
  valid_regions_are_accepted beside_a_vertex canonical_chains.
Import ListNotations.

Open Scope Q_scope.

Lemma simple_turned (l : list vector) : forall m, simple (l ++ m) -> simple (m ++ l).
Proof.
  induction l as [| a l IH]; intros m is_simple; [now rewrite app_nil_r |].
  apply simple_rotated in is_simple. cbn [app rotated] in is_simple. rewrite <- app_assoc in is_simple.
  apply IH in is_simple. now rewrite <- app_assoc in is_simple.
Qed.

Ltac cases_of_next :=
  unfold next; repeat match goal with |- context [Nat.eqb ?i ?j] => destruct (Nat.eqb_spec i j) end.

(* Without a vertex between the two beside it. *)
Lemma simple_without (a b : vector) (m : list vector) : simple (a :: b :: m) -> is_between_ends b a (hd a m) = true ->
  simple (a :: m).
Proof.
  intros (three & long & common) between_. set (c := hd a m) in *.
  assert (edges_are : edges (a :: b :: m) = Segment a b :: Segment b c :: path m a) by exact (edges_are_a_path _ a).
  assert (new_edges : edges (a :: m) = Segment a c :: path m a) by exact (edges_are_a_path m a).
  unfold edge_at in common. rewrite edges_are in common.
  destruct (proj1 (is_between_ends_iff b a c) between_) as (a_c & k & range & X & Y).
  destruct m as [| c' [| d m]]; [cbn in three; lia | |].
  { exfalso. subst c. cbn [hd] in *. destruct (common 0%nat 2%nat b) as [[wrong _] | [_ [ex ey]]]; try (cbn; lia).
    - exists 1. cbn. split; [lra | split; ring].
    - exists (1 - k). cbn. split; [lra | rewrite X, Y; split; ring].
    - discriminate.
    - apply a_c. cbn in ex, ey. split; apply (Qmult_inj_l _ _ k); lra. }
  unfold simple, edge_at. rewrite new_edges. cbn [length] in *. set (n := length m) in *.
  assert (forward : forall i j x, (i < j)%nat -> (j < S (S (S n)))%nat ->
    lies_on x (nth i (Segment a c :: path (c' :: d :: m) a) no_segment) ->
    lies_on x (nth j (Segment a c :: path (c' :: d :: m) a) no_segment) ->
    (j = next i (S (S (S n))) /\ equal_vectors x (vertex (a :: c' :: d :: m) j)) \/
    (i = next j (S (S (S n))) /\ equal_vectors x (vertex (a :: c' :: d :: m) i))).
  { intros [| i] [| j] x less below on_i on_j; try lia.
    - cbn [nth] in on_i. apply (on_divided b a c x between_) in on_i.
      destruct on_i as [on | on]; [destruct (common 0%nat (S (S j)) x) as [[is_ at_] | [is_ at_]] |
        destruct (common 1%nat (S (S j)) x) as [[is_ at_] | [is_ at_]]]; try lia; trivial; revert is_;
        cases_of_next; intros is_; try lia; [right; split; [lia | exact at_] | left].
      replace j with 0%nat in * by lia. split; [reflexivity | exact at_].
    - destruct (common (S (S i)) (S (S j)) x) as [[is_ at_] | [is_ at_]]; try lia; trivial; [left | right];
        (split; [| exact at_]); revert is_; cases_of_next; lia. }
  split; [lia |]. split.
  - intros e E. unfold edge_directions in E. rewrite new_edges in E. destruct E as [<- | E].
    + intros [ex ey]. apply a_c. by_computing.
    + apply long. unfold edge_directions. rewrite edges_are. now right; right.
  - intros i j x I J differ_ on_i on_j. destruct (Nat.lt_total i j) as [less | [same | more]]; [| contradiction |].
    + now apply forward.
    + apply or_comm. now apply forward.
Qed.

Lemma simple_straightened (z : vector) (l : list vector) : forall a others, simple (a :: l ++ others) ->
  hd a others = z -> simple (a :: straightened a l z ++ others).
Proof.
  induction l as [| b rest IH]; intros a others is_simple z_is; [exact is_simple |]. cbn [straightened].
  assert (next_is : hd a (rest ++ others) = hd z rest) by (destruct rest; [exact z_is | reflexivity]).
  destruct (is_between_ends b a (hd z rest)) eqn:between_.
  - apply IH; [| exact z_is]. apply (simple_without a b); [exact is_simple | now rewrite next_is].
  - apply simple_rotated in is_simple. cbn [rotated app] in *. rewrite <- app_assoc in is_simple.
    apply (IH b (others ++ [a])) in is_simple; [| now destruct others].
    rewrite app_assoc in is_simple. exact (simple_turned (b :: straightened b rest z ++ others) [a] is_simple).
Qed.

Lemma rings_are_simple_chains (segments : list segment) (ring : list vector) : share_ends_only segments ->
  incl (edges ring) segments -> NoDup ring -> ring <> [] -> simple ring.
Proof.
  intros parts part once some. destruct (edges_ends ring) as [sources _].
  assert (distinct_ : NoDup (edges ring)) by (apply (NoDup_map_inv source); now rewrite sources).
  split; [| split].
  - destruct ring as [| u [| v [| w ring]]]; [contradiction | exfalso .. | cbn; lia].
    + apply (are_long _ parts (Segment u u)); [apply part; now left | split; unfold along, minus; cbn; ring].
    + apply (not_turned _ parts (Segment u v) (Segment v u)); [apply part; cbn; tauto .. | reflexivity].
  - intros e E. apply in_map_iff in E. destruct E as (s & <- & S). apply (are_long _ parts), part, S.
  - set (n := length ring). intros i j x I J differ_ on_i on_j. unfold edge_at in *.
    assert (listed : forall k, (k < n)%nat -> In (nth k (edges ring) no_segment) (edges ring))
      by (intros k K; apply nth_In; now rewrite edges_are_as_many).
    assert (ends_ : forall k l, (k < n)%nat -> (l < n)%nat -> k <> l -> lies_on x (nth k (edges ring) no_segment) ->
      lies_on x (nth l (edges ring) no_segment) -> exists h, (h = k \/ h = next k n) /\ (h < n)%nat /\
        equal_vectors x (vertex ring h)).
    { intros k l K L other on_k on_l.
      destruct (inside_or_end x _ on_k) as [inside_ | [equal | equal]]; rewrite edge_by_index in * by assumption.
      - exfalso. rewrite <- !edge_by_index in * by assumption.
        apply (nothing_inside _ parts _ _ x (part _ (listed k K)) (part _ (listed l L))); trivial.
        intros same. apply other. apply (proj1 (NoDup_nth _ no_segment) distinct_); rewrite ?edges_are_as_many; trivial.
      - exists k. split; [tauto |]. split; [exact K | now symmetry].
      - exists (next k n). split; [tauto |]. split; [now apply next_in_range | now symmetry]. }
    destruct (ends_ i j I J differ_ on_i on_j) as (g & which & G & at_g).
    destruct (ends_ j i J I (not_eq_sym differ_) on_j on_i) as (h & which' & H & at_h).
    assert (same : g = h).
    { apply (proj1 (NoDup_nth ring nowhere) once); trivial.
      apply (have_same_ends _ parts _ _ _ _ (part _ (listed i I)) (part _ (listed j J)));
        [rewrite edge_by_index by exact I; destruct which as [-> | ->]; cbn; tauto
        | rewrite edge_by_index by exact J; destruct which' as [-> | ->]; cbn; tauto |].
      transitivity x; [now symmetry | exact at_h]. }
    subst h. destruct which as [-> | ->], which' as [is_ | is_]; subst; try contradiction.
    + now right.
    + left. split; [now symmetry | exact at_h].
    + exfalso. apply differ_. now apply (next_injective n).
Qed.

Section Rings.
  Variable segments : list segment.
  Hypothesis parts : share_ends_only segments.
  Hypothesis numbers : forall x, (0 <= winding_number x segments <= 1)%Z.
  Variable rings : region.
  Hypothesis edges_are : Permutation (region_edges rings) segments.
  Hypothesis pass_once : forall ring, In ring rings -> NoDup ring /\ ring <> [].
  Hypothesis same_on_the_right : forall ring part e f, In ring rings -> incl part segments -> cycles part ->
    In e (edges ring) -> In f (edges ring) ->
    winding_number_shifted (right_of_middle e) part = winding_number_shifted (right_of_middle f) part.

  Let written := map canonical_chain rings.

  Lemma edges_of_ring (ring : list vector) : In ring rings -> incl (edges ring) segments.
  Proof. intros C e E. apply (Permutation_in _ edges_are). apply in_flat_map. now exists ring. Qed.

  (* Theorem. Each chain is simple. *)
  Theorem canonical_chains_are_simple (ring : list vector) : In ring rings -> simple (canonical_chain ring).
  Proof.
    intros C. destruct (pass_once ring C) as [once some].
    pose proof (rings_are_simple_chains segments ring parts (edges_of_ring ring C) once some) as is_simple.
    unfold canonical_chain. destruct (from_smallest_is_a_rotation ring) as (l & m & ring_is & turned).
    rewrite ring_is in is_simple. apply simple_turned in is_simple. rewrite <- turned in is_simple.
    destruct (from_smallest ring) as [| a rest]; [exact is_simple |]. cbn [straight_chain].
    rewrite <- (app_nil_r (straightened _ _ _)). apply simple_straightened; [now rewrite app_nil_r | reflexivity].
  Qed.

  Lemma written_is_long (ring : list vector) (s : segment) : In ring rings -> In s (edges (canonical_chain ring)) ->
    nonzero (along s).
  Proof. intros C S. apply (proj1 (proj2 (canonical_chains_are_simple ring C))). now apply in_map. Qed.

  Lemma on_its_ring (ring : list vector) (s : segment) (x : vector) : In s (edges (canonical_chain ring)) ->
    lies_on x s ->
    exists k, In k (edges ring) /\ lies_on x k.
  Proof. intros S on. destruct (canonical_chain_is_alike x ring) as [same _]. apply same. now exists s. Qed.

  (* At a point of a ring another one goes round as often as on the right. *)
  Lemma number_on_a_ring (A : list vector) (k : segment) (x : vector) : In A rings -> In k segments ->
    ~ In k (edges A) ->
    strictly_inside x k -> off x (edges A) /\
    winding_number x (edges A) = winding_number_shifted (right_of_middle k) (edges A).
  Proof.
    intros C K other inside_. pose proof (edges_of_ring A C) as part. assert (free : off x (edges A)).
    { intros e E on. apply (nothing_inside _ parts k e x K (part e E)); trivial. intros <-. contradiction. }
    split; [exact free |]. set (n := Vector (vy (along k)) (- vx (along k))). assert (turn : cross (along k) n < 0)
      by (pose proof (square_positive _ (are_long _ parts k K)); unfold n, cross, dot in *; cbn [vx vy]; lra).
    destruct (winding_number_near x (edges A) (closed_chain_cycles A) free) as (radius & R & near).
    destruct (some_small _ (eventually_and _ _ (small_steps_stay_within radius x n R)
      (to_the_right_of_a_piece (edges A) k (closed_chain_cycles A)
        (met_by_itself_only segments parts (edges A) k part (or_introl K)) (are_long _ parts k K) x n inside_ turn)))
      as (d & _ & close & <-). now destruct (near _ close) as [_ <-].
  Qed.

  (* So it does at all points of the other one that are not on it. *)
  Lemma number_all_along (A B : list vector) (p : vector) (k : segment) : In A rings -> In B rings ->
    (forall e, In e (edges B) -> ~ In e (edges A)) -> In k (edges B) ->
    (exists e, In e (edges B) /\ lies_on p e) -> off p (edges A) ->
    winding_number p (edges A) = winding_number_shifted (right_of_middle k) (edges A).
  Proof.
    intros C D disjoint K (e & E & on) free.
    rewrite (same_on_the_right B (edges A) k e D (edges_of_ring A C) (closed_chain_cycles A) K E).
    pose proof (edges_of_ring B D e E) as E'. assert (at_inner : forall q, strictly_inside q e ->
      winding_number q (edges A) = winding_number_shifted (right_of_middle e) (edges A))
      by (intros q inside_; apply (number_on_a_ring A e q C E' (disjoint e E) inside_)).
    destruct (inside_or_end p e on) as [inside_ | at_end]; [now apply at_inner |].
    destruct (winding_number_near p (edges A) (closed_chain_cycles A) free) as (radius & R & near).
    assert (steps : forall u, (forall d, 0 < d < 1 -> strictly_inside (moved_along p u d) e) ->
      winding_number p (edges A) = winding_number_shifted (right_of_middle e) (edges A)).
    { intros u inner. destruct (some_small _ (eventually_and _ _ (small_steps_stay_within radius p u R)
        (eventually_below 1 ltac:(lra)))) as (d & _ & close & range).
      rewrite <- (at_inner _ (inner d range)). symmetry. now apply near. }
    destruct at_end as [[X Y] | [X Y]]; [apply (steps (along e)) | apply (steps (opposite (along e)))]; intros d range;
      [exists d | exists (1 - d)]; (split; [lra |]); unfold moved_along, opposite, along, minus; cbn [vx vy];
      rewrite <- X, <- Y; split; ring.
  Qed.

  Lemma rings_meet_in_vertices (A B : list vector) (s t : segment) : In A rings -> In B rings ->
    (forall e, In e (edges B) -> ~ In e (edges A)) -> In s (edges (canonical_chain A)) ->
    In t (edges (canonical_chain B)) -> meet_in_sources (region_edges [canonical_chain A; canonical_chain B]) s t.
  Proof.
    intros C D disjoint S T w on_s on_t. set (both := [canonical_chain A; canonical_chain B]).
    destruct (vertex_or_not w both) as [| no_vertex]; [assumption | exfalso].
    assert (in_A : incl (edges (canonical_chain A)) (region_edges both)) by apply incl_appl, incl_refl.
    assert (in_B : incl (edges (canonical_chain B)) (region_edges both))
      by (apply incl_appr, incl_appl, incl_refl).
    assert (inside_ : forall u, In u (region_edges both) -> lies_on w u -> strictly_inside w u).
    { intros u U on. destruct (inside_or_end w u on) as [| [equal | equal]]; [assumption | |]; exfalso; apply no_vertex.
      - exists u. split; [exact U | now symmetry].
      - destruct (target_is_vertex both u U) as (g & G & equal'). exists g. split; [exact G |].
        transitivity (target u); [now symmetry | exact equal']. }
    pose proof (inside_ s (in_A s S) on_s) as in_s. pose proof (inside_ t (in_B t T) on_t) as in_t. clear inside_.
    pose proof (written_is_long A s C S) as long_s. pose proof (written_is_long B t D T) as long_t.
    (* close to w on t are points inside edges of B, off A *)
    assert (beside : forall n c, nonzero n -> vx n == c * vx (along t) -> vy n == c * vy (along t) ->
      eventually (fun d => exists k, In k (edges B) /\ off (moved_along w n d) (edges A) /\
        winding_number (moved_along w n d) (edges A) = winding_number_shifted (right_of_middle k) (edges A))).
    { intros n c moves nx ny. destruct in_t as (h & range & X & Y).
      refine (eventually_implied _ _ _ (eventually_and _ _ (eventually_and _ _ (eventually_positive h c ltac:(lra))
        (eventually_positive (1 - h) (- c) ltac:(lra))) (eventually_for_all (fun k d =>
        ~ equal_vectors (moved_along w n d) (source k) /\ ~ equal_vectors (moved_along w n d) (target k)) segments
        (fun k _ => eventually_and _ _ (leaves_a_point w n (source k) moves) (leaves_a_point w n (target k) moves))))).
      intros d [[low high] no_end]. destruct (on_its_ring B t (moved_along w n d) T) as (k & K & on_k).
      { exists (h + d * c). split; [lra |]. unfold moved_along. cbn [vx vy]. rewrite nx, ny, X, Y.
        unfold along, minus. cbn [vx vy]. split; ring. }
      exists k. split; [exact K |]. pose proof (edges_of_ring B D k K) as K'.
      destruct (no_end k K') as [no_source no_target].
      apply number_on_a_ring; auto. destruct (inside_or_end _ k on_k) as [| [equal | equal]]; [assumption | |]; exfalso;
        [apply no_source | apply no_target]; now symmetry. }
    destruct (Qeq_dec (cross (along s) (along t)) 0) as [line | turn].
    - destruct (multiple_of (along s) (along t) long_t line) as (c & cx & cy). destruct in_s as (h & range & X & Y).
      destruct (some_small _ (eventually_and _ _ (beside (along s) c long_s cx cy) (eventually_and _ _
        (eventually_positive h 1 ltac:(lra)) (eventually_positive (1 - h) (- (1)) ltac:(lra)))))
        as (d & _ & (k & K & free & _) & low & high).
      destruct (on_its_ring A s (moved_along w (along s) d) S) as (k' & K' & on_k'); [| exact (free k' K' on_k')].
      exists (h + d). split; [lra |]. unfold moved_along. cbn [vx vy]. rewrite X, Y. unfold along, minus. cbn [vx vy].
      split; ring.
    - assert (exists n c, nonzero n /\ 0 < cross (along s) n /\ vx n == c * vx (along t) /\ vy n == c * vy (along t))
        as (n & c & moves & left_ & nx & ny).
      { destruct (Qlt_le_dec 0 (cross (along s) (along t))) as [some | none].
        - exists (along t), 1. split; [exact long_t |]. split; [exact some |]. split; ring.
        - exists (opposite (along t)), (- (1)). split; [now apply opposite_nonzero |].
          unfold opposite, cross in *. cbn [vx vy]. split; [lra | split; ring]. }
      assert (no_vertex_A : ~ is_vertex w [canonical_chain A]).
      { intros (u & U & equal). apply no_vertex. exists u. split; [| exact equal]. unfold region_edges in U.
        cbn [flat_map] in U. rewrite app_nil_r in U. exact (in_A u U). }
      assert (one_ring : region_edges [canonical_chain A] = edges (canonical_chain A)) by apply app_nil_r.
      assert (meet : edges_meet_in_vertices [canonical_chain A]).
      { apply edges_meet_by_pairs. rewrite one_ring. apply edges_of_one_chain;
          [now apply canonical_chains_are_simple | apply incl_refl]. }
      destruct (some_small _ (eventually_and _ _ (left_is_one_more [canonical_chain A] s w n meet
          ltac:(now rewrite one_ring) on_s no_vertex_A left_) (eventually_and _ _ (beside n c moves nx ny)
        (beside (opposite n) (- c) (opposite_nonzero n moves) ltac:(unfold opposite; cbn [vx]; rewrite nx; ring)
          ltac:(unfold opposite; cbn [vy]; rewrite ny; ring)))))
        as (d & _ & (_ & _ & more) & (k & K & free & number_y) & k' & K' & free' & number_z).
      rewrite one_ring, (winding_number_of_equal (moved_along w n (- d)) (moved_along w (opposite n) d)) in more
        by (unfold moved_along, opposite; cbn [vx vy]; ring).
      destruct (canonical_chain_is_alike (moved_along w n d) A) as [_ is_y].
      destruct (canonical_chain_is_alike (moved_along w (opposite n) d) A) as [_ is_z].
      rewrite is_y, is_z, number_y, number_z,
        (same_on_the_right B (edges A) k k' D (edges_of_ring A C) (closed_chain_cycles A) K K') in more. lia.
  Qed.

  (* Theorem. *)
  Theorem canonical_chains_are_valid : valid_region written /\ nowhere_above_one written.
  Proof.
    assert (edges_written : region_edges written = flat_map (fun ring => edges (canonical_chain ring)) rings).
    { unfold written, region_edges. now rewrite !flat_map_concat_map, map_map. }
    assert (number_is : forall x, (0 <= winding_number x (region_edges written) <= 1)%Z).
    { intros x. destruct (canonical_chains_are_alike x rings) as [_ same]. fold written in same. rewrite same.
      destruct (alike_permuted x _ _ edges_are) as [_ ->]. apply numbers. }
    assert (among : forall ring, In ring rings -> incl (edges (canonical_chain ring)) (region_edges written))
      by (intros ring R u U; rewrite edges_written; apply in_flat_map; now exists ring).
    assert (pairs : ForallOrdPairs (meet_in_sources (region_edges written)) (region_edges written)).
    { rewrite edges_written at 2. apply pairs_of_parts.
      - intros ring C. apply edges_of_one_chain; [now apply canonical_chains_are_simple | now apply among].
      - apply (weaker_pairs (fun A B => forall e, In e (edges A) -> ~ In e (edges B))).
        { intros A B C D disjoint s t S T w on_s on_t. destruct (rings_meet_in_vertices A B s t C D) with (w := w)
            as (u & U & equal); trivial; [intros e F E; exact (disjoint e E F) |].
          exists u. split; [| exact equal]. cbn in U. rewrite app_nil_r in U. apply in_app_iff in U.
          destruct U as [U | U]; [exact (among A C u U) | exact (among B D u U)]. }
        pose proof (Permutation_NoDup (Permutation_sym edges_are) (are_distinct _ parts)) as distinct_.
        revert distinct_.
        clear. induction rings as [| A l IH]; intros distinct_; constructor.
        + apply Forall_forall. intros B D e E F. cbn in distinct_. apply in_split in E.
          destruct E as (before & after & is_).
          rewrite is_, <- app_assoc in distinct_. apply (NoDup_remove_2 _ _ _ distinct_). rewrite !in_app_iff. right.
          right. apply in_flat_map. now exists B.
        + apply IH. now apply NoDup_second in distinct_. }
    split; [split; [| split] |].
    - apply edges_are_no_points. intros s S. rewrite edges_written in S. apply in_flat_map in S.
      destruct S as (ring & C & S). exact (written_is_long ring s C S).
    - intros x _. apply number_is.
    - now apply edges_meet_by_pairs.
    - intros x _. apply number_is.
  Qed.
End Rings.
