(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Rings of segments that have nothing but ends in common, without vertices in straight lines (canonical_chains.v),
   are a valid region again. One ring: at a vertex that is left out two of its edges met, so one is left there. Two
   rings that crossed at such a point: on the other one's edges before and after it, one goes round differently often;
   but on the right of all edges of a ring that is the same (clockwise_most_walks.v). *)
From Coq Require Import QArith Lqa Qfield ZArith Arith Lia Bool List Permutation.
From Oplus Require Import balanced_edges direction angle angular_crossings winding_number shifted_ray small_numbers
  signed_crossings rotation convolution_size turning_number fiber_grid states in_out_degree simple_chain
  simple_chains_turn_once regions meeting_of_segments weight winding_number_of_the_sum interiors_meet neighbourhoods
  left_of_an_edge right_of_an_edge theorem_4_2_1 observation_2_2_4 boundary_points location pieces naive_collision
  collision_is_sound collision_is_complete beside_a_piece filling cut_pieces kept_pieces_go_round kept_pieces_balance
  walks placed_collision complement_in_a_frame touching_vertices valid_regions_are_accepted beside_a_vertex
  canonical_chains.
Import ListNotations.

Open Scope Q_scope.

(* How many of the segments a point is on. *)
Definition times (x : vector) (l : list segment) : nat := length (filter (is_on_segment x) l).

Lemma times_of_more (x : vector) (s : segment) (l : list segment) :
  times x (s :: l) = ((if is_on_segment x s then 1 else 0) + times x l)%nat.
Proof. unfold times. cbn [filter]. now destruct (is_on_segment x s). Qed.

Lemma times_of_both (x : vector) (l m : list segment) : times x (l ++ m) = (times x l + times x m)%nat.
Proof. unfold times. now rewrite filter_app, app_length. Qed.

Lemma once_on (x : vector) (t : segment) (l : list segment) : In t l -> lies_on x t -> (1 <= times x l)%nat.
Proof.
  intros T on. induction l as [| s l IH]; [destruct T |]. rewrite times_of_more.
  destruct T as [-> | T]; [| specialize (IH T); lia]. destruct (is_on_spec x t); [lia | contradiction].
Qed.

Lemma pairs_meet_twice (P : vector -> Prop) (l : list segment) : (forall x, (2 <= times x l)%nat -> P x) ->
  ForallOrdPairs (fun s t => forall w, lies_on w s -> lies_on w t -> P w) l.
Proof.
  intros twice. apply pairs_by_position. intros earlier s later t -> T w on_s on_t. apply twice.
  rewrite times_of_both, times_of_more. pose proof (once_on w t _ T on_t) as once. rewrite times_of_both in once.
  destruct (is_on_spec w s) as [_ | free]; [| destruct (free on_s)]. cbn iota. lia.
Qed.

(* Where a vertex is left out, one segment less is met. *)
Lemma straight_meets_less (z x : vector) (l : list vector) : forall a,
  (times x (path (a :: straightened a l z) z) <= times x (path (a :: l) z))%nat /\
  forall b, In b l -> equal_vectors x b -> In b (straightened a l z) \/
    (times x (path (a :: straightened a l z) z) < times x (path (a :: l) z))%nat.
Proof.
  induction l as [| b rest IH]; intros a; cbn [straightened]; [split; [apply le_n | intros b []] |].
  destruct (is_between_ends b a (hd z rest)) eqn:between_.
  - destruct (IH a) as [less dropped].
    assert (one_less : (times x (path (a :: rest) z) + (if same_point x b then 1 else 0) = times x (path (a :: b ::
      rest) z))%nat).
    { cbn [path hd]. rewrite !times_of_more. set (c := hd z rest) in *.
      pose proof (on_divided b a c x between_) as divided_. pose proof (common_end a b c x between_) as common.
      assert (ends_ : equal_vectors x b -> lies_on x (Segment a b) /\ lies_on x (Segment b c)).
      { intros [X Y]. split; [exists 1 | exists 0]; cbn [source target]; (split; [lra |]); split; lra. }
      destruct (same_point_spec x b), (is_on_spec x (Segment a b)), (is_on_spec x (Segment b c)), (is_on_spec x
        (Segment a c));
        tauto || lia. }
    split; [lia |]. intros b' [<- | B] equal.
    + right. destruct (same_point_spec x b); [lia | contradiction].
    + destruct (dropped b' B equal); [now left | right; lia].
  - destruct (IH b) as [less dropped].
    change (path (a :: b :: straightened b rest z) z) with (Segment a b :: path (b :: straightened b rest z) z).
    change (path (a :: b :: rest) z) with (Segment a b :: path (b :: rest) z). rewrite !times_of_more.
    split; [lia |]. intros b' [<- | B] equal; [left; now left |].
    destruct (dropped b' B equal); [left; now right | right; lia].
Qed.

Lemma straight_is_long (z : vector) (l : list vector) : forall a, (forall s, In s (path (a :: l) z) -> nonzero (along
  s)) ->
  forall s, In s (path (a :: straightened a l z) z) -> nonzero (along s).
Proof.
  induction l as [| b rest IH]; intros a long; [exact long |]. cbn [straightened].
  destruct (is_between_ends b a (hd z rest)) eqn:between_.
  - apply IH. intros s [<- | S]; [| apply long; now right; right].
    apply is_between_ends_iff in between_. destruct between_ as [differ _]. intros [X Y]. apply differ.
    unfold along, minus in *; cbn [source target vx vy] in *. split; lra.
  - intros s [<- | S]; [apply long; now left |]. apply (IH b); [| exact S]. intros t T. apply long. now right.
Qed.

Lemma few_of_one_place {A B : Type} (dec : forall a b : B, {a = b} + {a <> b}) (f : A -> B) (b : B) (l : list A) :
  NoDup (map f l) -> (length (filter (fun a => if dec (f a) b then true else false) l) <= 1)%nat.
Proof.
  induction l as [| a l IH]; cbn [map filter]; [cbn; lia |]. intros distinct_. inversion distinct_ as [| ? ? new
    rest]; subst.
  specialize (IH rest). destruct (dec (f a) b) as [<- |]; [| exact IH]. cbn [length].
  enough (none : filter (fun c => if dec (f c) (f a) then true else false) l = []) by (rewrite none; cbn; lia).
  clear - new. induction l as [| c l IH]; [reflexivity |]. cbn [filter map] in *.
  destruct (dec (f c) (f a)) as [same |]; [exfalso; apply new; now left | apply IH; intros I; apply new; now right].
Qed.

Lemma times_by_index (x : vector) (l : list segment) (indices : list nat) : NoDup indices ->
  (forall i, In i indices -> (i < length l)%nat /\ lies_on x (nth i l no_segment)) -> (length indices <= times x l)%nat.
Proof.
  intros distinct_ all.
  assert (times_is : forall k start, times x k = length (filter (fun i => is_on_segment x (nth (i - start) k
    no_segment))
    (seq start (length k)))).
  { induction k as [| s k IH]; intros start; [reflexivity |]. rewrite times_of_more. cbn [length seq filter].
    rewrite Nat.sub_diag. change (nth 0 (s :: k) no_segment) with s. rewrite (IH (S start)).
    assert (same : filter (fun i => is_on_segment x (nth (i - start) (s :: k) no_segment)) (seq (S start) (length k)) =
      filter (fun i => is_on_segment x (nth (i - S start) k no_segment)) (seq (S start) (length k))).
    { apply filter_ext_in. intros i I. apply in_seq in I. now replace (i - start)%nat with (S (i - S start)) by lia. }
    rewrite same. now destruct (is_on_segment x s). }
  rewrite (times_is l 0%nat). apply NoDup_incl_length; [exact distinct_ |]. intros i I. destruct (all i I) as [below
    on].
  apply filter_In. split; [apply in_seq; lia |]. rewrite Nat.sub_0_r. now destruct (is_on_spec x (nth i l no_segment)).
Qed.

Section Rings.
  Variable segments : list segment.
  Hypothesis long : forall e, In e segments -> nonzero (along e).
  Hypothesis apart : forall e f w, In e segments -> In f segments -> e <> f -> lies_on w f -> ~ strictly_inside w e.
  Hypothesis same_ends : forall e f v w, In e segments -> In f segments ->
    v = source e \/ v = target e -> w = source f \/ w = target f -> equal_vectors v w -> v = w.
  Hypothesis distinct_ : NoDup segments.
  Hypothesis numbers : forall x, (0 <= winding_number x segments <= 1)%Z.
  Variable rings : region.
  Hypothesis edges_are : Permutation (region_edges rings) segments.
  Hypothesis pass_once : forall ring, In ring rings -> NoDup ring.
  Hypothesis same_on_the_right : forall ring part e f, In ring rings -> incl part segments -> cycles part ->
    In e (edges ring) -> In f (edges ring) ->
    winding_number_shifted (right_of_middle e) part = winding_number_shifted (right_of_middle f) part.

  Let written := map canonical_chain rings.

  Lemma edges_of_ring (ring : list vector) : In ring rings -> incl (edges ring) segments.
  Proof. intros C e E. apply (Permutation_in _ edges_are). apply in_flat_map. now exists ring. Qed.

  Lemma where_edges_meet (c : list vector) (x : vector) : NoDup c -> incl (edges c) segments ->
    (2 <= times x (edges c))%nat -> exists b, In b c /\ equal_vectors x b /\ (times x (edges c) <= 2)%nat.
  Proof.
    intros once part two. destruct (edges_ends c) as [sources targets].
    assert (distinct_edges : NoDup (edges c)) by (apply (NoDup_map_inv source); now rewrite sources).
    unfold times in *. pose proof (NoDup_filter (is_on_segment x) distinct_edges) as both.
    assert (are_on : forall e, In e (filter (is_on_segment x) (edges c)) -> In e (edges c) /\ lies_on x e).
    { intros e E. apply filter_In in E. destruct E as [E on]. split; [exact E |]. now destruct (is_on_spec x e). }
    destruct (filter (is_on_segment x) (edges c)) as [| e [| f l]] eqn:list_is; [cbn in two; lia | cbn in two; lia |].
    destruct (are_on e) as [E on_e]; [now left |]. destruct (are_on f) as [F on_f]; [right; now left |].
    assert (differ_ : e <> f) by (intros <-; inversion both as [| ? ? new _]; apply new; now left).
    assert (ends_ : forall g, In g (e :: f :: l) -> equal_vectors (source g) x \/ equal_vectors (target g) x).
    { intros g G. destruct (are_on g G) as [G' on_g]. apply on_but_not_inside; [exact on_g |].
      destruct (segment_dec g e) as [-> | other]; [apply (apart e f) | apply (apart g e)]; auto. }
    assert (exists b, In b c /\ equal_vectors x b /\ (b = source e \/ b = target e)) as (b & B & equal & is_end).
    { destruct (ends_ e (or_introl eq_refl)) as [equal | equal]; [exists (source e) | exists (target e)].
      - split; [rewrite <- sources; now apply in_map | split; [now symmetry | now left]].
      - split; [| split; [now symmetry | now right]].
        apply (Permutation_in _ (rotated_permutes c)). rewrite <- targets. now apply in_map. }
    exists b. split; [exact B |]. split; [exact equal |]. rewrite <- list_is in *.
    pose proof (few_of_one_place vector_dec source b (edges c) ltac:(now rewrite sources)) as few.
    pose proof (few_of_one_place vector_dec target b (edges c)
      ltac:(rewrite targets; apply (Permutation_NoDup (Permutation_sym (rotated_permutes c)) once))) as few'.
    enough (forall k, incl k (edges c) -> (length (filter (is_on_segment x) k) <=
      length (filter (fun g => if vector_dec (source g) b then true else false) k) +
      length (filter (fun g => if vector_dec (target g) b then true else false) k))%nat) as sum
      by (specialize (sum (edges c) (incl_refl _)); lia).
    induction k as [| g k IH]; intros part_k; [cbn; lia |].
    specialize (IH (fun h H => part_k h (or_intror H))). cbn [filter].
    assert (G : In g (edges c)) by (apply part_k; now left).
    destruct (is_on_segment x g) eqn:on_g; [| destruct (vector_dec (source g) b), (vector_dec (target g) b); cbn
      [length]; lia].
    assert (is_b : source g = b \/ target g = b).
    { destruct (ends_ g) as [equal_g | equal_g]; [now apply filter_In | left | right];
        (apply (same_ends g e); [now apply part | now apply part | tauto | exact is_end |]);
        (transitivity x; [exact equal_g | exact equal]). }
    destruct (vector_dec (source g) b), (vector_dec (target g) b); cbn [length]; tauto || lia.
  Qed.

  Lemma where_written_edges_meet (ring : list vector) (x : vector) : In ring rings ->
    (2 <= times x (edges (canonical_chain ring)))%nat ->
    (times x (edges (canonical_chain ring)) <= 2)%nat /\ exists b, In b (canonical_chain ring) /\ equal_vectors x b.
  Proof.
    intros C two. unfold canonical_chain in *. destruct (from_smallest_is_a_rotation ring) as (l & m & ring_is &
      turned).
    assert (edges_turned : Permutation (edges (from_smallest ring)) (edges ring))
      by (rewrite turned, ring_is; apply edges_of_rotation).
    assert (once : NoDup (from_smallest ring)).
    { rewrite turned. apply (Permutation_NoDup (Permutation_app_comm l m)). rewrite <- ring_is. now apply pass_once. }
    destruct (from_smallest ring) as [| a rest]; [cbn in two; lia |]. cbn [straight_chain] in *.
    rewrite edges_are_a_path in two. destruct (straight_meets_less a x rest a) as [less dropped].
    destruct (where_edges_meet (a :: rest) x once) as (b & B & equal & few).
    - intros e E. apply (edges_of_ring ring C), (Permutation_in _ edges_turned E).
    - rewrite edges_are_a_path. lia.
    - rewrite edges_are_a_path in few |- *. split; [lia |].
      destruct B as [<- | B]; [exists a; split; [now left | exact equal] |].
      destruct (dropped b B equal) as [kept_ |]; [exists b; split; [now right | exact equal] | lia].
  Qed.

  Lemma vertex_written (ring : list vector) (x b : vector) : In ring rings -> In b (canonical_chain ring) ->
    equal_vectors x b -> is_vertex x written /\ is_vertex x [canonical_chain ring].
  Proof.
    intros C B equal. destruct (edges_ends (canonical_chain ring)) as [sources _].
    rewrite <- sources in B. apply in_map_iff in B. destruct B as (e & <- & E).
    split; exists e; (split; [| exact equal]); apply in_flat_map; exists (canonical_chain ring); (split; [| exact E]);
      [now apply in_map | now left].
  Qed.

  (* A ring's points off the others', and what others do around them. *)
  Lemma number_on_a_ring (A B : list vector) (y z : vector) : In A rings -> In B rings ->
    (forall x, x = y \/ x = z -> off x (edges A) /\ (exists k, In k (edges B) /\ lies_on x k) /\
       forall k, In k segments -> ~ equal_vectors x (source k) /\ ~ equal_vectors x (target k)) ->
    winding_number y (edges A) = winding_number z (edges A).
  Proof.
    intros C D both. pose proof (edges_of_ring A C) as part. pose proof (edges_of_ring B D) as part_b.
    assert (each : forall x, x = y \/ x = z -> exists k, In k (edges B) /\
      winding_number_shifted (right_of_middle k) (edges A) = winding_number x (edges A)).
    { intros x which. destruct (both x which) as (free & (k & K & on) & no_end). exists k. split; [exact K |].
      assert (inside_ : strictly_inside x k).
      { destruct (no_end k (part_b k K)). destruct (inside_or_end x k on) as [| [[X Y] | [X Y]]]; [assumption | |];
          exfalso; [apply H | apply H0]; split; lra. }
      set (n := Vector (vy (along k)) (- vx (along k))).
      assert (turn : cross (along k) n < 0).
      { pose proof (square_positive _ (long k (part_b k K))). unfold n, cross, dot in *. cbn [vx vy]. lra. }
      destruct (winding_number_near x (edges A) (closed_chain_cycles A) free) as (radius & R & near).
      destruct (eventually_and _ _ (small_steps_stay_within radius x n R)
        (to_the_right_of_a_piece (edges A) k (closed_chain_cycles A)
          (met_by_itself_only segments apart (edges A) k part (or_introl (part_b k K)))
          (long k (part_b k K)) x n inside_ turn)) as (limit & L & all).
      destruct (all ((1 # 2) * limit)) as (close & <-); [lra | lra |]. now apply near. }
    destruct (each y (or_introl eq_refl)) as (k & K & <-), (each z (or_intror eq_refl)) as (k' & K' & <-).
    apply (same_on_the_right B); trivial. apply closed_chain_cycles.
  Qed.

  Lemma written_is_long (ring : list vector) (s : segment) : In ring rings -> In s (edges (canonical_chain ring)) ->
    nonzero (along s).
  Proof.
    intros C. unfold canonical_chain. destruct (from_smallest_is_a_rotation ring) as (l & m & ring_is & turned).
    assert (all : forall e, In e (edges (from_smallest ring)) -> nonzero (along e)).
    { intros e E. apply long, (edges_of_ring ring C). rewrite turned in E. rewrite ring_is.
      exact (Permutation_in _ (edges_of_rotation l m) E). }
    destruct (from_smallest ring) as [| a rest]; [intros [] |]. cbn [straight_chain]. rewrite edges_are_a_path in *.
    now apply straight_is_long.
  Qed.

  Lemma on_its_ring (ring : list vector) (s : segment) (x : vector) : In s (edges (canonical_chain ring)) -> lies_on
    x s ->
    exists k, In k (edges ring) /\ lies_on x k.
  Proof. intros S on. destruct (canonical_chain_is_alike x ring) as [same _]. apply same. now exists s. Qed.

  Lemma near_and_on (s : segment) (w n : vector) (c : Q) : strictly_inside w s ->
    vx n == c * vx (along s) -> vy n == c * vy (along s) -> eventually (fun d => lies_on (moved_along w n d) s).
  Proof.
    intros (k & range & X & Y) nx ny.
    refine (eventually_implied _ _ _ (eventually_and _ _ (eventually_positive k c (proj1 range))
      (eventually_positive (1 - k) (- c) ltac:(lra)))).
    intros d [low high]. exists (k + d * c). split; [lra |]. unfold moved_along. cbn [vx vy].
    rewrite nx, ny, X, Y. unfold along, minus. cbn [vx vy]. split; ring.
  Qed.

  Lemma ring_meets_in_vertices (ring : list vector) : In ring rings -> edges_meet_in_vertices [canonical_chain ring].
  Proof.
    intros C earlier s later t w edges_is T.
    assert (pairs : ForallOrdPairs (fun s t => forall w, lies_on w s -> lies_on w t -> is_vertex w [canonical_chain
      ring])
      (region_edges [canonical_chain ring])).
    { unfold region_edges. cbn [flat_map]. rewrite app_nil_r. apply pairs_meet_twice. intros x two.
      destruct (where_written_edges_meet ring x C two) as (_ & b & B & equal). now apply (vertex_written ring x b). }
    rewrite edges_is in pairs. revert w.
    refine (pair_at_position (fun s t => forall w, lies_on w s -> lies_on w t -> is_vertex w [canonical_chain ring])
      s t later earlier _ pairs T). intros a b R w on_b on_a. now apply R.
  Qed.

  Lemma rings_meet_in_vertices (A B : list vector) (s t : segment) (w : vector) : In A rings -> In B rings ->
    (forall e f, In e (edges A) -> In f (edges B) -> e <> f) ->
    In s (edges (canonical_chain A)) -> In t (edges (canonical_chain B)) -> lies_on w s -> lies_on w t ->
    is_vertex w written.
  Proof.
    intros C D disjoint S T on_s on_t. destruct (vertex_or_not w written) as [| no_vertex]; [assumption | exfalso].
    assert (inside_ : forall ring u, In ring rings -> In u (edges (canonical_chain ring)) -> lies_on w u ->
      strictly_inside w u).
    { intros ring u R U on. assert (I : In u (region_edges written))
        by (apply in_flat_map; exists (canonical_chain ring); split; [now apply in_map | exact U]).
      destruct (inside_or_end w u on) as [| [equal | [X Y]]]; [assumption | |]; exfalso; apply no_vertex.
      - exists u. split; [exact I | now symmetry].
      - destruct (target_is_vertex written u I) as (g & G & gx & gy). exists g. split; [exact G |]. split; lra. }
    pose proof (inside_ A s C S on_s) as in_s. pose proof (inside_ B t D T on_t) as in_t.
    pose proof (written_is_long A s C S) as long_s. pose proof (written_is_long B t D T) as long_t.
    assert (no_ends : forall n, nonzero n -> eventually (fun d => forall k, In k segments ->
      ~ equal_vectors (moved_along w n d) (source k) /\ ~ equal_vectors (moved_along w n d) (target k))).
    { intros n moves. apply (eventually_for_all (fun k d => ~ equal_vectors (moved_along w n d) (source k) /\
        ~ equal_vectors (moved_along w n d) (target k))).
      intros k _. apply eventually_and; now apply leaves_a_point. }
    destruct (Qeq_dec (cross (along s) (along t)) 0) as [line | turn].
    - destruct (is_a_multiple (along s) (along t) long_s line) as (c & cx & cy).
      destruct (eventually_and _ _ (no_ends (along t) long_t) (eventually_and _ _ (near_and_on s w (along t) c in_s
        cx cy)
        (near_and_on t w (along t) 1 in_t ltac:(ring) ltac:(ring)))) as (limit & L & all).
      destruct (all ((1 # 2) * limit)) as (none & on_s' & on_t'); [lra | lra |].
      set (x := moved_along w (along t) _) in *. clearbody x.
      destruct (on_its_ring A s x S on_s') as (k & K & on_k), (on_its_ring B t x T on_t') as (k' & K' & on_k').
      pose proof (edges_of_ring A C k K) as K_in. pose proof (edges_of_ring B D k' K') as K_in'.
      destruct (none k K_in) as [no_source no_target].
      destruct (inside_or_end x k on_k) as [inside_k | [equal | equal]];
        [| now apply no_source; symmetry | now apply no_target; symmetry].
      exact (apart k k' x K_in K_in' (disjoint k k' K K') on_k' inside_k).
    - assert (exists n c, nonzero n /\ 0 < cross (along s) n /\ vx n == c * vx (along t) /\ vy n == c * vy (along t))
        as (n & c & moves & left_ & nx & ny).
      { destruct (Qlt_le_dec 0 (cross (along s) (along t))) as [some | none].
        - exists (along t), 1. split; [exact long_t |]. split; [exact some |]. split; ring.
        - exists (opposite (along t)), (- (1)). unfold opposite. cbn [vx vy]. split; [| split; [| split; ring]].
          + intros [X Y]. apply long_t. cbn [vx vy] in *. split; lra.
          + unfold cross in *. cbn [vx vy]. lra. }
      assert (moves_back : nonzero (opposite n)).
      { unfold opposite. intros [X Y]. apply moves. cbn [vx vy] in *. split; lra. }
      assert (no_vertex_A : ~ is_vertex w [canonical_chain A]).
      { intros (u & U & equal). apply no_vertex. exists u. split; [| exact equal]. unfold region_edges in U.
        cbn [flat_map] in U. rewrite app_nil_r in U. apply in_flat_map. exists (canonical_chain A).
        split; [now apply in_map | exact U]. }
      assert (S' : In s (region_edges [canonical_chain A])) by (apply in_flat_map; exists (canonical_chain A); split;
        [now left | exact S]).
      destruct (eventually_and _ _ (left_is_one_more [canonical_chain A] s w n (ring_meets_in_vertices A C) S' on_s
        no_vertex_A left_)
        (eventually_and _ _ (eventually_and _ _ (no_ends n moves) (no_ends (opposite n) moves_back))
          (eventually_and _ _ (near_and_on t w n c in_t nx ny)
            (near_and_on t w (opposite n) (- c) in_t ltac:(unfold opposite; cbn [vx]; rewrite nx; ring)
              ltac:(unfold opposite; cbn [vy]; rewrite ny; ring))))) as (limit & L & all).
      destruct (all ((1 # 2) * limit)) as ((free & free' & more) & (none & none') & on_t1 & on_t2); [lra | lra |].
      set (d := (1 # 2) * limit) in *. clearbody d.
      set (y := moved_along w n d) in *. set (z := moved_along w (opposite n) d) in *.
      assert (same_z : equal_vectors (moved_along w n (- d)) z)
        by (unfold z, moved_along, opposite; split; cbn [vx vy]; ring).
      unfold region_edges in free, free', more. cbn [flat_map] in free, free', more. rewrite app_nil_r in free,
        free', more.
      pose proof (off_equal _ _ _ same_z free') as free_z. destruct same_z as [zx zy].
      rewrite (winding_number_of_equal _ _ _ zx zy) in more.
      assert (off_ring : forall x, off x (edges (canonical_chain A)) -> off x (edges A)).
      { intros x off_x k K on. destruct (canonical_chain_is_alike x A) as [same _].
        destruct (proj2 same) as (u & U & on_u); [now exists k | exact (off_x u U on_u)]. }
      destruct (canonical_chain_is_alike y A) as [_ number_y], (canonical_chain_is_alike z A) as [_ number_z].
      rewrite number_y, number_z, (number_on_a_ring A B y z C D) in more; [lia |].
      intros x [-> | ->]; (split; [now apply off_ring |]; split; [now apply (on_its_ring B t) | assumption]).
  Qed.

  (* Theorem. Each chain is simple. *)
  Theorem canonical_chains_are_simple (ring : list vector) : In ring rings -> canonical_chain ring <> [] ->
    simple (canonical_chain ring).
  Proof.
    intros C some. set (c := canonical_chain ring) in *. set (n := length c).
    assert (long_c : forall i, (i < n)%nat -> nonzero (along (edge_at c i)))
      by (intros i I; apply (written_is_long ring _ C), nth_In; now rewrite edges_are_as_many).
    assert (starts : forall i, (i < n)%nat -> lies_on (vertex c i) (edge_at c i)).
    { intros i I. rewrite edge_is by exact I. apply (source_lies_on (Segment _ _)). }
    assert (ends_ : forall i, (i < n)%nat -> lies_on (vertex c (next i n)) (edge_at c i)).
    { intros i I. rewrite edge_is by exact I. apply (target_lies_on (Segment _ _)). }
    (* a vertex is on the edges before and after it only *)
    assert (alone : forall i k x, (i < n)%nat -> (k < n)%nat -> (n <> 1)%nat -> equal_vectors x (vertex c k) ->
      lies_on x (edge_at c i) -> i = k \/ next i n = k).
    { intros i k x I K more equal on. destruct (Nat.eq_dec i k) as [| other]; [now left |].
      destruct (Nat.eq_dec (next i n) k) as [| other']; [now right | exfalso].
      pose proof (previous_below n k K) as J. pose proof (next_previous n k K) as is_k.
      assert (on_k : lies_on x (edge_at c k) /\ lies_on x (edge_at c (previous n k))).
      { destruct equal as [X Y]. split; [destruct (starts k K) as (h & range & hx & hy) |
          pose proof (ends_ (previous n k) J) as end_; rewrite is_k in end_; destruct end_ as (h & range & hx & hy)];
          exists h; rewrite X, Y; tauto. }
      assert (three : (3 <= times x (edges c))%nat).
      { apply (times_by_index x (edges c) [i; k; previous n k]).
        - repeat constructor; cbn; intros H; repeat (destruct H as [H | H]); try contradiction; try lia.
          + apply other'. rewrite <- H. exact is_k.
          + unfold previous in *. destruct k; lia.
        - intros j [<- | [<- | [<- | []]]]; rewrite edges_are_as_many; tauto. }
      assert (two : (2 <= times x (edges c))%nat) by lia.
      destruct (where_written_edges_meet ring x C two) as [few _]. change (canonical_chain ring) with c in few. lia. }
    assert (meet : forall i j x, (i < n)%nat -> (j < n)%nat -> i <> j -> lies_on x (edge_at c i) -> lies_on x (edge_at
      c j) ->
      exists k, (k < n)%nat /\ equal_vectors x (vertex c k)).
    { intros i j x I J other on_i on_j. assert (two : (2 <= times x (edges c))%nat).
      { apply (times_by_index x (edges c) [i; j]).
        - constructor; [intros [|[]]; now apply other | constructor; [intros [] | constructor]].
        - intros k [<- | [<- | []]]; rewrite edges_are_as_many; tauto. }
      destruct (where_written_edges_meet ring x C two) as (_ & b & B & equal).
      apply (In_nth _ _ nowhere) in B. destruct B as (k & K & <-). now exists k. }
    assert (three : (3 <= n)%nat).
    { destruct (Nat.eq_dec n 1) as [one | more].
      - exfalso. apply (long_c 0%nat ltac:(lia)). rewrite edge_is by lia. fold n. rewrite one. unfold along, minus.
        cbn. split; ring.
      - destruct (Nat.eq_dec n 2) as [two | more']; [exfalso | destruct c; [contradiction | cbn in n; lia]].
        assert (is_0 : edge_at c 0 = Segment (vertex c 0) (vertex c 1)) by (rewrite edge_is by lia; fold n; now
          rewrite two).
        assert (is_1 : edge_at c 1 = Segment (vertex c 1) (vertex c 0)) by (rewrite edge_is by lia; fold n; now
          rewrite two).
        pose proof (long_c 0%nat ltac:(lia)) as long_0. rewrite is_0 in long_0.
        destruct (meet 0%nat 1%nat (middle (Segment (vertex c 0) (vertex c 1)))) as (k & K & X & Y); [lia | lia | lia
          | | |].
        + rewrite is_0. apply strictly_inside_lies_on, middle_is_inside.
        + rewrite is_1. apply strictly_inside_lies_on, (strictly_inside_reversed _ (Segment (vertex c 0) (vertex c 1))).
          apply middle_is_inside.
        + unfold middle, Qdiv in X, Y. cbn [source target vx vy] in X, Y. change (/ 2) with (1 # 2) in X, Y. apply
          long_0. unfold along, minus. cbn [source target vx vy].
          destruct k as [| [| k]]; [split; lra | split; lra | lia]. }
    split; [exact three |]. split.
    - intros e E. unfold edge_directions in E. apply in_map_iff in E. destruct E as (s & <- & S).
      exact (written_is_long ring s C S).
    - intros i j x I J other on_i on_j. destruct (meet i j x I J other on_i on_j) as (k & K & equal).
      destruct (alone i k x I K ltac:(lia) equal on_i) as [-> | i_k], (alone j k x J K ltac:(lia) equal on_j) as [j_k
        | j_k];
        subst; [contradiction | right; now split | left; now split |].
      exfalso. apply other. now apply (next_injective n).
  Qed.

  (* Theorem. *)
  Theorem canonical_chains_are_valid : valid_region written /\ nowhere_above_one written.
  Proof.
    assert (edges_written : region_edges written = flat_map (fun ring => edges (canonical_chain ring)) rings).
    { unfold written, region_edges. clear. induction rings as [| c l IH]; [reflexivity |]. cbn. now rewrite IH. }
    assert (number_is : forall x, (0 <= winding_number x (region_edges written) <= 1)%Z).
    { intros x. destruct (canonical_chains_are_alike x rings) as [_ same]. fold written in same. rewrite same.
      destruct (alike_permuted x _ _ edges_are) as [_ ->]. apply numbers. }
    assert (pairs : ForallOrdPairs (fun s t => forall w, lies_on w s -> lies_on w t -> is_vertex w written)
      (region_edges written)).
    { rewrite edges_written.
      apply (pairs_of_lists (fun A B => forall e f, In e (edges A) -> In f (edges B) -> e <> f)).
      - intros ring C. apply pairs_meet_twice. intros x two.
        destruct (where_written_edges_meet ring x C two) as (_ & b & B & equal). now apply (vertex_written ring x b).
      - intros A B C D disjoint s t S T w. now apply (rings_meet_in_vertices A B s t w).
      - apply pairs_by_position. intros earlier A later B rings_are D e f E F <-.
        apply (Permutation_NoDup (Permutation_sym edges_are)) in distinct_. rewrite rings_are in distinct_.
        assert (parts : Permutation (region_edges (earlier ++ A :: later)) (edges A ++ region_edges (earlier ++ later)))
          by (symmetry; apply (Permutation_flat_map edges (Permutation_middle earlier later A))).
        pose proof (Permutation_NoDup parts distinct_) as both.
        assert (F' : In e (region_edges (earlier ++ later))) by (apply in_flat_map; now exists B).
        clear - E F' both. induction (edges A) as [| g l IH]; [destruct E |]. inversion both as [| ? ? new rest]; subst.
        destruct E as [-> | E]; [apply new, in_app_iff; now right | now apply IH]. }
    split; [split; [| split] |].
    - apply edges_are_no_points. intros s S. rewrite edges_written in S. apply in_flat_map in S.
      destruct S as (ring & C & S). exact (written_is_long ring s C S).
    - intros x _. apply number_is.
    - intros earlier s later t w is_ T. rewrite is_ in pairs. revert w.
      refine (pair_at_position (fun s t => forall w, lies_on w s -> lies_on w t -> is_vertex w written) s t later
        earlier _ pairs T).
      intros a b R w on_b on_a. now apply R.
    - intros x _. apply number_is.
  Qed.
End Rings.
