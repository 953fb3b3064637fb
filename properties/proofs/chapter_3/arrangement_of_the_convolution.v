(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Largest clockwise turns in the arrangement of the convolution (arranged_convolution.v). Its edges on the boundary are
   those that have the sum on their left only, and the largest clockwise turn from one of them leads to another one. For
   the next ray counterclockwise from the way back has the outside on its right, as the edge has; and then the sum on
   its left, since near all points of the convolution are inner points of the sum. So it is on the boundary, and leaves
   the vertex; and no edge that leaves it is met before. So Algorithm 1 traces all of the boundary. *)
From Coq Require Import QArith Lqa ZArith Lia Bool List Permutation.
From Oplus Require Import regions_and_sums angle theorem_2_2_10 reduced_convolution observation_2_2_4 pieces met_pieces
  naive_collision collision_is_sound beside_a_piece filling kept_pieces_go_round cut_pieces rule_of_sides
  beside_a_vertex region_of_pieces sum_is_right walks loops_of_the_boundary algorithm_1 what_algorithm_1_traces
  arranged_convolution.
Import ListNotations.

Open Scope Q_scope.

Definition is_boundary_edge (p q : region) (e : segment) : Prop := forall x, lies_on x e -> on_boundary_of_sum x p q.

Section Sum.
  Variables p q : region.
  Hypothesis p_region : valid_region p.
  Hypothesis q_region : valid_region q.
  Variable segments : list segment.
  Hypothesis convolution_ : is_convolution p q segments.

  Let around := region_edges (boundary_loops p q).
  Let right_inside := is_right_inside around.
  Let pieces := pieces_of segments.
  Let arranged_are_long := arranged_are_long p q p_region q_region segments convolution_.
  Let parts := pieces_of_share_ends segments arranged_are_long.
  Let ends_ := sum_ends_at_pieces p q p_region q_region segments convolution_.
  Let kept := edges_on_the_boundary p q segments.
  Let chains := chains_of (length kept) kept.
  Let loops_ := arranged_loops_are_the_sum p q p_region q_region segments convolution_.
  Let loops_meet_along := loops_meet_along p q p_region q_region segments convolution_.
  Let arrangement := arrangement_of segments.
  Let best := best_direction arrangement.

  Lemma arrangement_is_directed (e : segment) : In e arrangement -> directed pieces e.
  Proof. intros E. exact (proj1 (arrangement_edge_is segments e arranged_are_long E)). Qed.

  Lemma kept_edge_is (e : segment) : In e kept <-> directed pieces e /\
    right_inside (reversed e) = true /\ right_inside e = false.
  Proof.
    exact (of_kept segments right_inside e).
  Qed.

  (* No edge of the arrangement runs against one of a loop. *)
  Lemma none_runs_back (e : segment) : In e kept -> ~ In (reversed e) arrangement.
  Proof.
    intros E I.
    destruct (arrangement_edge_is segments (reversed e) arranged_are_long I) as (_ & t & T & same_ & covers_).
    pose proof (strictly_inside_lies_on _ _ (strictly_inside_reversed _ _ (middle_is_inside e))) as on.
    destruct (segments_along_kept p q p_region q_region _ _ chains loops_ e t (middle e) E T (middle_is_inside e)
      (covers_ _ on))
      as [_ (c & some & X & Y)]. destruct same_ as (d & some' & X' & Y').
    apply (arranged_are_long t T). unfold along, minus in *. cbn [reversed source target vx vy] in *.
    split; apply (Qmult_inj_r _ _ (c + d)); lra.
  Qed.

  Lemma loops_are_in_the_arrangement (e : segment) : In e kept -> In e arrangement.
  Proof.
    intros E.
    destruct (reduced_segment_along_kept p q p_region q_region _ _ chains loops_ e E) as (t & T & covers_ & same_).
    apply convolution_ in T. pose proof (middle_is_inside e) as inside_.
    pose proof (covers_ _ (strictly_inside_lies_on _ _ inside_)) as on.
    destruct (proj2 (cut_returns t (flat_map (intersection t) segments) (arranged_are_long t T)) _ on)
      as (piece & P & part & on_piece).
    assert (listed : In (reduced_segment piece) arrangement)
      by (apply nodup_In, in_flat_map; exists t; split; [exact T | now apply in_map]).
    pose proof (lies_on_of_one_place _ _ _ (of_one_place_sym _ _ (reduced_segment_place piece)) on_piece) as on_reduced.
    destruct (proj1 (kept_edge_is e) E) as (D & _).
    pose proof (arrangement_is_directed _ listed) as D'.
    destruct (segment_dec e (reduced_segment piece)) as [is_ | other]; [now rewrite is_ |].
    destruct (segment_dec e (reversed (reduced_segment piece))) as [is_ | other'].
    - exfalso. apply (none_runs_back e E). now rewrite is_, reversed_twice.
    - exfalso. exact (directed_are_apart _ parts e _ _ D D' other other' inside_ on_reduced).
  Qed.

  (* Theorem. *)
  Theorem boundary_edges_are_kept (e : segment) : In e arrangement ->
    (is_boundary_edge p q e <-> In e kept).
  Proof.
    intros E. split.
    - intros boundary. pose proof (middle_is_inside e) as inside_.
      pose proof (boundary _ (strictly_inside_lies_on _ _ inside_)) as on_boundary.
      apply (boundary_is_kept p q _ _ chains loops_) in on_boundary. destruct on_boundary as (k & K & on).
      destruct (segment_dec e k) as [-> | other]; [exact K |].
      destruct (segment_dec e (reversed k)) as [-> | other'].
      + destruct (none_runs_back k K E).
      + exfalso. exact (directed_are_apart _ parts e k _ (arrangement_is_directed e E) (proj1 (proj1
          (kept_edge_is k) K)) other other' inside_ on).
    - intros L x on. apply (boundary_is_kept p q _ _ chains loops_). exists e. split; assumption.
  Qed.

  (* Of a piece there is the sum on one side. *)
  Lemma sum_on_one_side (f : segment) : directed pieces f -> right_inside f = false ->
    right_inside (reversed f) = true.
  Proof.
    intros D right_. destruct (right_inside (reversed f)) eqn:left_; [reflexivity | exfalso].
    assert (exists t, In t segments /\ lies_on (middle f) t) as (t & T & on).
    { pose proof (pieces_are_pieces segments arranged_are_long) as all_pieces. destruct D as [D | D].
      - apply (pieces_are_on _ _ all_pieces f _ D), strictly_inside_lies_on, middle_is_inside.
      - apply (pieces_are_on _ _ all_pieces _ _ D), strictly_inside_lies_on, strictly_inside_reversed,
          middle_is_inside. }
    pose proof (on_the_convolution_is_in_the_sum p q (middle f) t (proj1 convolution_ t T) on) as in_.
    destruct (on_or_off (middle f) (region_edges chains)) as [(k & K & on_k) | free].
    - apply (kept_are_edges p q _ _ chains loops_) in K. destruct (proj1 (kept_edge_is k) K) as (D' & k_left & k_right).
      destruct (segment_dec f k) as [<- | other]; [congruence |].
      destruct (segment_dec f (reversed k)) as [is_ | other']; [rewrite is_ in right_; congruence |].
      exact (directed_are_apart _ parts f k _ D D' other other' (middle_is_inside f) on_k).
    - destruct (off_the_loops_of_segments p q _ _ chains loops_ (middle f) free) as [(radius & R & inner) |
        (radius & R & none)]; [| apply (none (middle f)); [unfold within; lra | exact in_]].
      set (n := Vector (vy (along f)) (- vx (along f))).
      assert (turn : cross (along f) n < 0).
      { pose proof (left_normal f (directed_is_long _ parts f D)). unfold n, cross in *. cbn [vx vy] in *. lra. }
      destruct (some_small _ (eventually_and _ _ (eventually_and _ _ (small_steps_stay_within radius (middle f) n R)
        (nothing_met_beside around f (middle f) n (loops_meet_along f D) (middle_is_inside f) ltac:(lra)))
        (same_beside_pieces _ _ _ ends_ f (middle f) n D (middle_is_inside f) turn))) as (d & _ & (close & off_) &
          beside_).
      pose proof (inner _ close) as in_beside.
      apply (loops_fill_the_sum _ _ _ _ _ (boundary_loops_are_loops_of_the_sum p q p_region q_region)) in in_beside.
      destruct in_beside as [some | (k & K & on_k)]; [| exact (off_ k K on_k)].
      apply (Z.lt_irrefl 0), (Z.lt_le_trans _ _ _ some), Z.ltb_ge. exact (eq_trans beside_ right_).
  Qed.

  (* Theorem. The largest clockwise turn from an edge of a loop leads to one of a loop. *)
  Theorem largest_turn_stays_on_the_loops (e : segment) : In e kept ->
    exists f, best e = Some f /\ In f kept /\ f = next_ray pieces (reversed e).
  Proof.
    intros E. pose proof (loops_are_in_the_arrangement e E) as listed.
    destruct (proj1 (kept_edge_is e) E) as (D & left_e & right_e).
    pose proof (directed_reversed _ _ D) as back. set (f := next_ray pieces (reversed e)).
    destruct (next_ray_is _ _ back) as (D' & starts & first_). fold f in D', starts, first_.
    assert (right_f : right_inside f = false).
    { rewrite <- right_e. symmetry. rewrite <- (reversed_twice e) at 1.
      exact (left_of_a_ray _ parts _ (right_inside) (same_off_pieces _ _ _ ends_)
        (same_beside_pieces _ _ _ ends_) (reversed e) back). }
    assert (L : In f kept).
    { apply kept_edge_is. split; [exact D' |]. split; [now apply sum_on_one_side | exact right_f]. }
    pose proof (loops_are_in_the_arrangement f L) as listed_f. cbn [reversed source] in starts.
    exists f. split; [| split; [exact L | reflexivity]].
    destruct (best e) as [g |] eqn:chosen; [| destruct (nothing_leaves arrangement e chosen f listed_f starts)].
    f_equal. destruct (best_direction_is arrangement e g chosen) as (G & starts_g & least).
    specialize (least f listed_f starts). specialize (first_ g (arrangement_is_directed g G) starts_g).
    destruct (segment_dec g f) as [| other]; [assumption | exfalso].
    assert (long : forall s, directed pieces s -> nonzero (along s)) by exact (directed_is_long _ parts).
    assert (same_ : turned_to (along (reversed e)) (along g) == turned_to (along (reversed e)) (along f)) by lra.
    apply same_turn in same_; [| exact (long _ back) | exact (long g (arrangement_is_directed g G)) |
      exact (long f D')].
    refine (rays_differ _ parts g f (arrangement_is_directed g G) D' _ other same_). congruence.
  Qed.

  Lemma largest_turns_differ (e f : segment) : In e kept -> In f kept -> best e = best f -> e = f.
  Proof.
    intros E F same. destruct (largest_turn_stays_on_the_loops e E) as (g & is_g & _ & g_is).
    destruct (largest_turn_stays_on_the_loops f F) as (h & is_h & _ & h_is).
    assert (same_ray : next_ray pieces (reversed e) = next_ray pieces (reversed f))
      by congruence.
    pose proof (directed_reversed _ _ (proj1 (proj1 (kept_edge_is e) E))) as D.
    pose proof (directed_reversed _ _ (proj1 (proj1 (kept_edge_is f) F))) as D'.
    rewrite <- (reversed_twice e), <- (reversed_twice f). apply (f_equal reversed).
    refine (next_rays_differ _ parts _ _ D D' _ same_ray).
    destruct (next_ray_is _ _ D) as (_ & a & _), (next_ray_is _ _ D') as (_ & b & _). congruence.
  Qed.

  (* Theorem. Algorithm 1 traces all edges of the boundary. *)
  Theorem boundary_is_traced (e : segment) : In e kept -> In e (concat (algorithm_1 arrangement)).
  Proof.
    intros E. pose proof (kept_share_ends_only _ _ _ _ _ loops_) as kept_parts_.
    destruct (edges_around_are_traced arrangement kept) with (stack := arrangement)
      (earlier := @nil segment) (e := e) as [yes | two].
    - exact (are_distinct _ kept_parts_).
    - intros f F. destruct (largest_turn_stays_on_the_loops f F) as (g & is_ & G & _).
      exists g. split; assumption.
    - exact largest_turns_differ.
    - constructor.
    - intros f [].
    - apply incl_refl.
    - intros f g [].
    - exact E.
    - exact (loops_are_in_the_arrangement e E).
    - intros [].
    - exact yes.
    - exfalso. destruct (largest_turn_stays_on_the_loops e E) as (f & is_ & F & _).
      assert (steps : step_on arrangement e = f)
        by (unfold step_on; change (best_direction arrangement e) with (best e); now rewrite is_).
      rewrite steps in two.
      destruct (best_direction_is arrangement e f is_) as (_ & starts & _).
      destruct (best_direction_is arrangement f e two) as (_ & starts' & _).
      apply (not_turned _ kept_parts_ e f E F).
      unfold reversed. rewrite <- starts, starts'. now destruct f.
  Qed.
End Sum.
