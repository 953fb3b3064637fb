(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Theorem 3.2.10 but for sums of two vertices: through an isolated vertex of the open sum there are segments of the
   reduced convolution of three different directions. It is on a sum of a vertex and an edge, and between its ends.
   Along a piece of such sums, cut where they meet, P and -Q + x collide everywhere or nowhere (open_along_a_piece.v);
   close to an isolated vertex they do everywhere, so it is an end of a piece, where two of them cross. Both edges
   pass, so segments of the reduced convolution run along both. There is a third one, since each direction is to the
   left of one or along two opposite ones (theorem_3_2_10.v), and some direction is to the right of the first two. *)
From Coq Require Import QArith Lqa ZArith Lia Bool List.
From Oplus Require Import regions_and_sums angle parallelogram theorem_2_2_6 inside_a_corner boundary_points
  reduced_convolution edges_at_a_point reduced_edges_that_pass observation_2_2_4 collision_is_sound theorem_3_2_10
  pieces met_pieces cut_pieces beside_a_piece contacts_that_stay coordinates open_sum_program open_along_a_piece.
Import ListNotations.

Open Scope Q_scope.

Section IsolatedVertex.
  Variables p q : region.
  Variable x : vector.
  Hypothesis p_region : valid_region p.
  Hypothesis q_region : valid_region q.
  Hypothesis p_simple : nowhere_above_one p.
  Hypothesis q_simple : nowhere_above_one q.
  Hypothesis isolated : isolated_vertex x p q.
  Hypothesis no_vertices : forall w u, is_vertex w p -> is_vertex u q -> ~ equal_vectors x (plus w u).

  Let all := all_vertex_edge_segments p q.

  Lemma no_end_is_isolated (t : segment) : In t all -> ~ equal_vectors x (source t) /\ ~ equal_vectors x (target t).
  Proof.
    intros T. apply in_all in T. destruct T as (a & b & s & f & both & S & F & ->).
    assert (none : forall w, is_vertex w b -> ~ equal_vectors x (plus w (source s))).
    { intros w W equal. pose proof (source_is_vertex a s S) as V. destruct both as [[-> ->] | [-> ->]].
      - apply (no_vertices (source s) w V W). now apply sum_in_other_order.
      - now apply (no_vertices w (source s) W V). }
    split; intros [X Y].
    - apply (none (source f) (source_is_vertex b f F)). unfold moved_segment in X, Y. by_computing.
    - apply (none (target f) (target_is_vertex b f F)). unfold moved_segment in X, Y. by_computing.
  Qed.

  Lemma passing_is_covered (t : segment) : In t all -> lies_on x t -> reduced_along p q x (along t).
  Proof.
    intros T on. pose proof T as T'. apply in_all in T. destruct T as (a & b & s & f & both & S & F & ->).
    apply on_moved_segment in on. set (w := minus x (source s)) in *.
    assert (x_is : equal_vectors x (plus w (source s))) by (unfold w, plus, minus; split; cbn [vx vy]; ring).
    pose proof (source_is_vertex a s S) as V.
    assert (none_meet : forall w u, is_vertex w p -> is_vertex u q -> equal_vectors x (plus w u) -> alone w p /\ alone
      u q)
      by (intros v u W U equal; now destruct (no_vertices v u W U)).
    assert (no_vertex : ~ is_vertex w b).
    { intros W. destruct both as [[-> ->] | [-> ->]].
      - apply (no_vertices (source s) w V W). now apply sum_in_other_order.
      - now apply (no_vertices w (source s) W V). }
    assert (along_f : reduced_along p q x (along f)).
    { destruct both as [[-> ->] | [-> ->]].
      - apply (passing_edges_of_q_are_covered p q x p_region q_region (proj1 isolated) none_meet w (source s) f);
          trivial.
        now apply vertex_is_in_region.
      - apply (passing_edges_of_p_are_covered p q x p_region q_region (proj1 isolated) none_meet w (source s) f);
          trivial.
        now apply vertex_is_in_region. }
    destruct along_f as (r & R & on_r & (c & some & X & Y)). exists r. split; [exact R |]. split; [exact on_r |].
    exists c. split; [exact some |]. unfold moved_segment, along, minus, plus in *. cbn [source target vx vy] in *.
    split; lra.
  Qed.

  (* Two sums of a vertex and an edge cross there. *)
  Lemma two_cross : exists t g, In t all /\ In g all /\ lies_on x t /\ lies_on x g /\ ~ cross (along t) (along g) == 0.
  Proof.
    assert (right_ : nonzero (Vector 1 0)) by (intros [X _]; discriminate X).
    assert (on_some : exists s, covers s x p q).
    { destruct (segments_on_all_sides_of_an_isolated_vertex p q x (Vector 1 0) p_region q_region isolated no_vertices
        right_) as [(s & covers_ & _) | [(s & covers_ & _) _]]; now exists s. }
    destruct on_some as (s & R & on_s). apply reduced_is_part_of_the_convolution in R.
    destruct (proj2 (on_listed_is p q x) (convolution_is_part_of_the_vertex_edge_sum p q x s R on_s)) as (t & T & on).
    pose proof (all_vertex_edge_segments_are_long p q p_region q_region t T) as long.
    destruct (proj2 (cut_returns t (flat_map (intersection t) all) long) x on) as (piece & I & part & on_piece).
    assert (crossing : forall v, equal_vectors x v -> v = source piece \/ v = target piece ->
      exists t g, In t all /\ In g all /\ lies_on x t /\ lies_on x g /\ ~ cross (along t) (along g) == 0).
    { intros v equal end_. assert (differ : forall f, In f all -> v <> source f /\ v <> target f).
      { intros f F. destruct (no_end_is_isolated f F) as [a b]. split; intros ->; contradiction. }
      destruct (ends_of_a_piece t piece all v I end_) as [is_ | [is_ | (g & G & met)]];
        [destruct (differ t T); contradiction .. |].
      destruct (intersection_is_on_both t g v met) as (_ & on_g & [ends_ | turn]).
      - exfalso. destruct (differ t T), (differ g G). tauto.
      - exists t, g. split; [exact T |]. split; [exact G |]. split; [exact on |]. split; [| exact turn].
        apply (lies_on_equal v); [now symmetry | exact on_g]. }
    destruct (inside_or_end x piece on_piece) as [inside_ | [equal | equal]];
      [exfalso | apply (crossing (source piece)); [now symmetry | now left] |
       apply (crossing (target piece)); [now symmetry | now right]].
    destruct isolated as (outside & radius & R' & near). apply outside.
    destruct (part_is_long piece t part long) as [long_piece _]. pose proof inside_ as (k & range & X & Y).
    destruct (some_small _ (eventually_and _ _ (small_steps_stay_within radius x (along piece) R') (eventually_and _ _
      (leaves_a_point x (along piece) x long_piece) (eventually_below (1 - k) ltac:(lra)))))
      as (d & some & close & moved_ & d_range).
    apply (meeting_is_the_same_inside p q p_region q_region p_simple q_simple t piece
      (moved_along x (along piece) d) x T I); [| exact inside_ |].
    - exists (k + d). split; [lra |]. unfold moved_along, along, minus. cbn [vx vy]. rewrite X, Y. split; ring.
    - apply near; [exact close |]. intros equal. apply moved_. now symmetry.
  Qed.

  Lemma three_segments : exists s1 s2 s3, covers s1 x p q /\ covers s2 x p q /\ covers s3 x p q /\
    ~ same_direction (along s1) (along s2) /\ ~ same_direction (along s1) (along s3) /\
    ~ same_direction (along s2) (along s3).
  Proof.
    destruct two_cross as (t & g & T & G & on_t & on_g & turn).
    destruct (passing_is_covered t T on_t) as (s1 & R1 & on_1 & (c1 & some_1 & X1 & Y1)).
    destruct (passing_is_covered g G on_g) as (s2 & R2 & on_2 & (c2 & some_2 & X2 & Y2)).
    assert (turn' : ~ cross (along s1) (along s2) == 0).
    { intros flat. apply turn. assert (0 < c1 * c2) by now apply Qmult_lt_0_compat.
      apply (Qmult_inj_l _ _ (c1 * c2)); [lra |]. rewrite Qmult_0_r, <- flat. unfold cross. rewrite X1, Y1, X2, Y2.
      ring. }
    assert (parallel : forall u v, same_direction u v -> cross u v == 0)
      by (intros u v (a & _ & X & Y); unfold cross; rewrite X, Y; ring).
    clear X1 Y1 X2 Y2 turn T G on_t on_g.
    assert (right_of_both : exists m, cross (along s1) m < 0 /\ cross (along s2) m < 0).
    { destruct (Q_dec (cross (along s1) (along s2)) 0) as [[low | high] | none]; [| | contradiction].
      - exists (minus (along s2) (along s1)). unfold cross, minus in *. cbn [vx vy]. lra.
      - exists (minus (along s1) (along s2)). unfold cross, minus in *. cbn [vx vy]. lra. }
    destruct right_of_both as (m & right_1 & right_2).
    assert (proper_m : nonzero m) by (intros [X Y]; unfold cross in right_1; rewrite X, Y in right_1; lra).
    assert (third : exists s, covers s x p q /\ (0 < cross (along s) m \/ same_direction (along s) m)).
    { destruct (segments_on_all_sides_of_an_isolated_vertex p q x m p_region q_region isolated no_vertices proper_m)
        as [(s & covers_ & left_) | [(s & covers_ & same_) _]]; exists s; tauto. }
    destruct third as (s3 & covers_3 & side).
    assert (differs : forall s, cross (along s) m < 0 -> ~ same_direction (along s) (along s3)).
    { intros s right_ (a & some & X & Y). destruct side as [left_ | (b & _ & X' & Y')].
      - assert (0 < a * cross (along s3) m) by now apply Qmult_lt_0_compat. unfold cross in *. rewrite X, Y in right_.
        lra.
      - unfold cross in right_. rewrite X, Y, X', Y' in right_. lra. }
    exists s1, s2, s3. split; [now split |]. split; [now split |]. split; [exact covers_3 |].
    split; [| split; now apply differs]. intros same_. now apply turn', parallel.
  Qed.
End IsolatedVertex.

(* Theorem. *)
Theorem three_segments_at_an_isolated_vertex (p q : region) (x : vector) :
  valid_region p -> valid_region q -> nowhere_above_one p -> nowhere_above_one q -> isolated_vertex x p q ->
  (forall w u, is_vertex w p -> is_vertex u q -> ~ equal_vectors x (plus w u)) ->
  exists s1 s2 s3, covers s1 x p q /\ covers s2 x p q /\ covers s3 x p q /\
    ~ same_direction (along s1) (along s2) /\ ~ same_direction (along s1) (along s3) /\
    ~ same_direction (along s2) (along s3).
Proof. intros. now apply three_segments. Qed.
