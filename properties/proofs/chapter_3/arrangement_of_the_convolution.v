(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The arrangement of the convolution: its segments cut where they meet, each piece with the direction of its segment.
   The edges of the boundary loops are those of its edges that are on the boundary, and the largest clockwise turn from
   one of them leads to another one. For the next ray counterclockwise from the way back has the outside on its right,
   as the edge has; and then the sum on its left, since near all points of the convolution are inner points of the sum.
   So it is on the boundary, and leaves the vertex; and no edge that leaves it is met before. *)
From Coq Require Import QArith Lqa ZArith Lia Bool List Permutation.
From Oplus Require Import regions_and_sums angle beside_every_point theorem_2_2_10 theorem_2_2_6 reduced_convolution
  observation_2_2_4 pieces met_pieces naive_collision collision_is_sound beside_a_piece filling kept_pieces_go_round
  cut_pieces rule_of_sides beside_a_vertex region_of_pieces sum_is_right loops_of_the_boundary algorithm_1
  what_algorithm_1_traces.
Import ListNotations.

Open Scope Q_scope.

Definition reduced_segment (e : segment) : segment :=
  Segment (reduced_vector (source e)) (reduced_vector (target e)).

Definition arrangement_of (segments : list segment) : list segment :=
  nodup segment_dec (flat_map (fun s => map reduced_segment (cut_where_met s segments)) segments).

Definition convolution_arrangement (p q : region) : list segment := arrangement_of (convolution_segments p q).

Lemma reduced_segment_is (e : segment) :
  equal_vectors (source (reduced_segment e)) (source e) /\ equal_vectors (target (reduced_segment e)) (target e).
Proof. split; apply reduced_is. Qed.

Lemma reduced_segment_place (e : segment) : of_one_place (reduced_segment e) e.
Proof. left. apply reduced_segment_is. Qed.

Lemma undirected_is_one_direction (e : segment) :
  undirected e = reduced_segment e \/ undirected e = reversed (reduced_segment e).
Proof. unfold undirected, reduced_segment, reversed. cbn [source target]. destruct (compare_points _ _); tauto. Qed.

(* An edge of the arrangement is a piece, in one of its directions, and part of a segment of its direction. *)
Lemma arrangement_edge_is (segments : list segment) (e : segment) :
  (forall t, In t segments -> nonzero (along t)) -> In e (arrangement_of segments) ->
  directed (pieces_of segments) e /\
  exists t, In t segments /\ same_direction (along e) (along t) /\ forall x, lies_on x e -> lies_on x t.
Proof.
  intros all_long E. apply nodup_In, in_flat_map in E. destruct E as (t & T & E).
  apply in_map_iff in E. destruct E as (piece & <- & P). split.
  - assert (listed : In (undirected piece) (pieces_of segments))
      by (apply nodup_In, in_flat_map; exists t; split; [exact T | now apply in_map]).
    destruct (undirected_is_one_direction piece) as [is_ | is_]; rewrite is_ in listed; [now left | now right].
  - destruct (proj1 (cut_returns t (flat_map (intersection t) segments) (all_long t T)) piece P) as [part _].
    exists t. split; [exact T |]. split.
    + destruct (part_is_long piece t part (all_long t T)) as [_ (c & some & X & Y)]. exists c. split; [exact some |].
      destruct (reduced_segment_is piece) as [[sx sy] [tx ty]]. unfold along, minus in *. cbn [vx vy] in *.
      rewrite sx, sy, tx, ty. now split.
    + intros x on. apply (part_lies_on piece t x part).
      exact (lies_on_of_one_place _ _ x (reduced_segment_place piece) on).
Qed.

Definition is_boundary_edge (p q : region) (e : segment) : Prop := forall x, lies_on x e -> on_boundary_of_sum x p q.

Section Sum.
  Variables p q : region.
  Hypothesis p_region : valid_region p.
  Hypothesis q_region : valid_region q.

  Let segments := convolution_segments p q.
  Let all_long := all_are_long p q p_region q_region.
  Let ends_ := filled_ends_at_pieces segments all_long (all_are_closed p q p_region q_region).
  Let cut_ := pieces_of_share_ends segments all_long.
  Let loops := boundary_loops p q.
  Let edges_are : Permutation (region_edges loops) (filled segments) := edges_of_the_loops p q p_region q_region.
  Let arrangement := convolution_arrangement p q.
  Let best := best_direction arrangement.

  Lemma arrangement_is_directed (e : segment) : In e arrangement -> directed (pieces_of segments) e.
  Proof. intros E. now apply arrangement_edge_is. Qed.

  Lemma edge_of_a_loop_is (e : segment) : In e (region_edges loops) <-> directed (pieces_of segments) e /\
    is_right_inside segments (reversed e) = true /\ is_right_inside segments e = false.
  Proof.
    rewrite <- of_kept. split; apply Permutation_in; [exact edges_are | exact (Permutation_sym edges_are)].
  Qed.

  (* No edge of the arrangement runs against one of a loop. *)
  Lemma none_runs_back (e : segment) : In e (region_edges loops) -> ~ In (reversed e) arrangement.
  Proof.
    intros E I. destruct (arrangement_edge_is segments (reversed e) all_long I) as (_ & t & T & same_ & covers_).
    pose proof (strictly_inside_lies_on _ _ (strictly_inside_reversed _ _ (middle_is_inside e))) as on.
    destruct (segments_along_the_loops p q p_region q_region e t (middle e) E T (middle_is_inside e) (covers_ _ on))
      as [_ (c & some & X & Y)]. destruct same_ as (d & some' & X' & Y').
    apply (all_long t T). unfold along, minus in *. cbn [reversed source target vx vy] in *.
    split; apply (Qmult_inj_r _ _ (c + d)); lra.
  Qed.

  Lemma loops_are_in_the_arrangement (e : segment) : In e (region_edges loops) -> In e arrangement.
  Proof.
    intros E. destruct (reduced_segment_along_the_loops p q p_region q_region e E) as (t & T & covers_ & same_).
    apply reduced_is_part_of_the_convolution in T. pose proof (middle_is_inside e) as inside_.
    pose proof (covers_ _ (strictly_inside_lies_on _ _ inside_)) as on.
    destruct (proj2 (cut_returns t (flat_map (intersection t) segments) (all_long t T)) _ on)
      as (piece & P & part & on_piece).
    assert (listed : In (reduced_segment piece) arrangement)
      by (apply nodup_In, in_flat_map; exists t; split; [exact T | now apply in_map]).
    pose proof (lies_on_of_one_place _ _ _ (of_one_place_sym _ _ (reduced_segment_place piece)) on_piece) as on_reduced.
    destruct (proj1 (edge_of_a_loop_is e) E) as (D & _).
    pose proof (arrangement_is_directed _ listed) as D'.
    destruct (segment_dec e (reduced_segment piece)) as [is_ | other]; [now rewrite is_ |].
    destruct (segment_dec e (reversed (reduced_segment piece))) as [is_ | other'].
    - exfalso. apply (none_runs_back e E). now rewrite is_, reversed_twice.
    - exfalso. exact (directed_are_apart _ cut_ e _ _ D D' other other' inside_ on_reduced).
  Qed.

  (* Theorem. *)
  Theorem boundary_edges_are_those_of_the_loops (e : segment) : In e arrangement ->
    (is_boundary_edge p q e <-> In e (region_edges loops)).
  Proof.
    intros E. split.
    - intros boundary. pose proof (middle_is_inside e) as inside_.
      pose proof (boundary _ (strictly_inside_lies_on _ _ inside_)) as on_boundary.
      apply (boundary_is_on_the_loops p q p_region q_region) in on_boundary. destruct on_boundary as (k & K & on).
      destruct (segment_dec e k) as [-> | other]; [exact K |].
      destruct (segment_dec e (reversed k)) as [-> | other'].
      + destruct (none_runs_back k K E).
      + exfalso. exact (directed_are_apart _ cut_ e k _ (arrangement_is_directed e E) (proj1 (proj1
          (edge_of_a_loop_is k) K)) other other' inside_ on).
    - intros L x on. apply (boundary_is_on_the_loops p q p_region q_region). exists e. split; assumption.
  Qed.

  (* Of a piece there is the sum on one side. *)
  Lemma sum_on_one_side (f : segment) : directed (pieces_of segments) f -> is_right_inside segments f = false ->
    is_right_inside segments (reversed f) = true.
  Proof.
    intros D right_. destruct (is_right_inside segments (reversed f)) eqn:left_; [reflexivity | exfalso].
    assert (exists t, In t segments /\ lies_on (middle f) t) as (t & T & on).
    { pose proof (pieces_are_pieces segments all_long) as all_pieces. destruct D as [D | D].
      - apply (pieces_are_on _ _ all_pieces f _ D), strictly_inside_lies_on, middle_is_inside.
      - apply (pieces_are_on _ _ all_pieces _ _ D), strictly_inside_lies_on, strictly_inside_reversed,
          middle_is_inside. }
    pose proof (on_the_convolution_is_in_the_sum p q (middle f) t T on) as in_.
    apply (loops_fill_the_sum p q p_region q_region) in in_.
    destruct (on_or_off (middle f) (region_edges loops)) as [(k & K & on_k) | free].
    - destruct (proj1 (edge_of_a_loop_is k) K) as (D' & k_left & k_right).
      destruct (segment_dec f k) as [<- | other]; [congruence |].
      destruct (segment_dec f (reversed k)) as [is_ | other']; [rewrite is_ in right_; congruence |].
      exact (directed_are_apart _ cut_ f k _ D D' other other' (middle_is_inside f) on_k).
    - destruct in_ as [some | (k & K & on_k)]; [| exact (free k K on_k)].
      destruct (winding_number_near (middle f) _ (region_cycles loops) free) as (radius & R & near).
      set (n := Vector (vy (along f)) (- vx (along f))).
      assert (turn : cross (along f) n < 0).
      { pose proof (left_normal f (directed_is_long _ cut_ f D)). unfold n, cross in *. cbn [vx vy] in *. lra. }
      destruct (some_small _ (eventually_and _ _ (small_steps_stay_within radius (middle f) n R)
        (same_beside_pieces _ _ _ ends_ f (middle f) n D (middle_is_inside f) turn))) as (d & _ & close & beside_).
      destruct (near _ close) as [_ number_is].
      rewrite (winding_number_of_chains p q loops p_region q_region edges_are) in number_is.
      cbv beta in beside_. rewrite right_ in beside_. fold segments in number_is. rewrite beside_ in number_is.
      fold loops in some. now rewrite <- number_is in some.
  Qed.

  (* Theorem. The largest clockwise turn from an edge of a loop leads to one of a loop. *)
  Theorem largest_turn_stays_on_the_loops (e : segment) : In e (region_edges loops) ->
    exists f, best e = Some f /\ In f (region_edges loops) /\ f = next_ray (pieces_of segments) (reversed e).
  Proof.
    intros E. pose proof (loops_are_in_the_arrangement e E) as listed.
    destruct (proj1 (edge_of_a_loop_is e) E) as (D & left_e & right_e).
    pose proof (directed_reversed _ _ D) as back. set (f := next_ray (pieces_of segments) (reversed e)).
    destruct (next_ray_is _ _ back) as (D' & starts & first_). fold f in D', starts, first_.
    assert (right_f : is_right_inside segments f = false).
    { rewrite <- right_e. symmetry. rewrite <- (reversed_twice e) at 1.
      exact (left_of_a_ray _ cut_ _ (is_right_inside segments) (same_off_pieces _ _ _ ends_)
        (same_beside_pieces _ _ _ ends_) (reversed e) back). }
    assert (L : In f (region_edges loops)).
    { apply edge_of_a_loop_is. split; [exact D' |]. split; [now apply sum_on_one_side | exact right_f]. }
    pose proof (loops_are_in_the_arrangement f L) as listed_f. cbn [reversed source] in starts.
    exists f. split; [| split; [exact L | reflexivity]].
    destruct (best e) as [g |] eqn:chosen; [| destruct (nothing_leaves arrangement e chosen f listed_f starts)].
    f_equal. destruct (best_direction_is arrangement e g chosen) as (G & starts_g & least).
    specialize (least f listed_f starts). specialize (first_ g (arrangement_is_directed g G) starts_g).
    destruct (segment_dec g f) as [| other]; [assumption | exfalso].
    assert (long : forall s, directed (pieces_of segments) s -> nonzero (along s)) by exact (directed_is_long _ cut_).
    assert (same_ : turned_to (along (reversed e)) (along g) == turned_to (along (reversed e)) (along f)) by lra.
    apply same_turn in same_; [| exact (long _ back) | exact (long g (arrangement_is_directed g G)) |
      exact (long f D')].
    refine (rays_differ _ cut_ g f (arrangement_is_directed g G) D' _ other same_). congruence.
  Qed.

  Lemma largest_turns_differ (e f : segment) : In e (region_edges loops) -> In f (region_edges loops) ->
    best e = best f -> e = f.
  Proof.
    intros E F same. destruct (largest_turn_stays_on_the_loops e E) as (g & is_g & _ & g_is).
    destruct (largest_turn_stays_on_the_loops f F) as (h & is_h & _ & h_is).
    assert (same_ray : next_ray (pieces_of segments) (reversed e) = next_ray (pieces_of segments) (reversed f))
      by congruence.
    pose proof (directed_reversed _ _ (proj1 (proj1 (edge_of_a_loop_is e) E))) as D.
    pose proof (directed_reversed _ _ (proj1 (proj1 (edge_of_a_loop_is f) F))) as D'.
    rewrite <- (reversed_twice e), <- (reversed_twice f). apply (f_equal reversed).
    refine (next_rays_differ _ cut_ _ _ D D' _ same_ray).
    destruct (next_ray_is _ _ D) as (_ & a & _), (next_ray_is _ _ D') as (_ & b & _). congruence.
  Qed.

  (* Theorem. Algorithm 1 traces all edges of the boundary. *)
  Theorem boundary_is_traced (e : segment) : In e (region_edges loops) -> In e (concat (algorithm_1 arrangement)).
  Proof.
    intros E. pose proof (kept_share_ends_only p q p_region q_region) as parts.
    destruct (edges_around_are_traced arrangement (region_edges loops)) with (stack := arrangement)
      (earlier := @nil segment) (e := e) as [yes | two].
    - exact (Permutation_NoDup (Permutation_sym edges_are) (are_distinct _ parts)).
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
      apply (Permutation_in _ edges_are) in E, F. apply (not_turned _ parts e f E F).
      unfold reversed. rewrite <- starts, starts'. now destruct f.
  Qed.
End Sum.
