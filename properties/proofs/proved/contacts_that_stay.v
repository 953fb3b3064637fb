(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* x is moved along a segment. If no vertex of P comes to an edge of -Q + x on the way or leaves one, nor a vertex of
   -Q + x an edge of P, and no vertices meet, then the interiors of P and -Q + x meet all along the way, or nowhere.
   Where they meet, what they have in common has a corner: a vertex of one of them, or a point where two edges cross.
   After the move, edges that crossed still cross: their parallelogram still goes round x (crossing_edges.v). A vertex
   that was inside the other region still is; and what was near a vertex on an edge, to the left of the edge, still
   is to its left. *)
From Coq Require Import QArith Qminmax Lqa ZArith Lia Bool List Permutation.
From Oplus Require Import specification_bridge regions_and_sums reflected parallelogram crossing_edges boundary_points
  pieces naive_collision met_pieces collision_is_sound collision_is_complete placed_collision filling
  kept_pieces_go_round cut_pieces
  rule_of_sides region_of_pieces coordinates.
Import ListNotations.

Open Scope Q_scope.

(* Edges of a valid region that are not parallel have only vertices in common. *)
Lemma common_point_is_a_vertex (r : region) (e f : segment) (w : vector) : valid_region r -> In e (region_edges r) ->
  In f (region_edges r) -> lies_on w e -> lies_on w f -> ~ cross (along e) (along f) == 0 -> is_vertex w r.
Proof.
  intros (_ & _ & meet) E F on_e on_f turn. destruct (in_split _ _ E) as (earlier & later & edges_are).
  apply (meet earlier e later f w edges_are); trivial. rewrite edges_are in F. apply in_elt_inv in F.
  destruct F as [-> | F]; [exfalso; apply turn; unfold cross; ring | exact F].
Qed.

(* Close to w there are points inside both. *)
Definition meet_near (p q : region) (x w : vector) : Prop :=
  forall radius, 0 < radius -> exists z, within radius w z /\ inside z p /\ inside (minus x z) q.

(* Two edges cross at w, which is no vertex. *)
Definition edges_cross_at (p q : region) (x w : vector) : Prop :=
  exists e f, In e (region_edges p) /\ In f (region_edges q) /\ lies_on w e /\ lies_on (minus x w) f /\
    ~ is_vertex w p /\ ~ is_vertex (minus x w) q /\ ~ cross (along e) (along f) == 0.

(* Theorem. What P and -Q + x have in common has a corner. *)
Theorem a_common_corner (p q : region) (x : vector) : valid_region p -> valid_region q -> interiors_meet x p q ->
  exists w, meet_near p q x w /\ (is_vertex w p \/ is_vertex (minus x w) q \/ edges_cross_at p q x w).
Proof.
  intros p_region q_region (z & in_p & in_q). apply inside_placed in in_q.
  pose proof (placed_is_valid x q q_region) as placed_region.
  set (families := [region_edges p; region_edges (placed x q)]).
  assert (closed : forall l, In l families -> cycles l) by (intros l [<- | [<- | []]]; apply region_cycles).
  assert (edge_is : forall t, In t (concat families) -> In t (region_edges p) \/ In t (region_edges (placed x q)))
    by (intros t T; cbn [families concat] in T; rewrite app_nil_r in T; now apply in_app_iff).
  assert (long : forall t, In t (concat families) -> nonzero (along t)).
  { intros t T. destruct (edge_is t T) as [E | F];
      [exact (region_edges_are_directions p (proj1 p_region) t E) |
       exact (region_edges_are_directions _ (proj1 placed_region) t F)]. }
  pose proof (rule_ends_at_pieces (forallb (Z.ltb 0)) families closed long eq_refl) as ends_.
  pose proof (boundary_by_rule_goes_round (forallb (Z.ltb 0)) families closed long eq_refl z) as round.
  assert (both : forall y, by_rule (forallb (Z.ltb 0)) families y = true <->
    (0 < winding_number y (region_edges p))%Z /\ (0 < winding_number y (region_edges (placed x q)))%Z)
    by (intros y; unfold by_rule; cbn [families map forallb]; rewrite !andb_true_iff, !Z.ltb_lt; tauto).
  rewrite (proj2 (both z) (conj (proj2 in_p) (proj2 in_q))) in round.
  destruct (boundary_by_rule _ families) as [| s l] eqn:boundary_; [discriminate round |].
  assert (S : In s (kept_pieces (right_by_rule (forallb (Z.ltb 0)) families) (pieces_of (concat families))))
    by (unfold boundary_by_rule in boundary_; rewrite boundary_; now left).
  clear z in_p in_q round boundary_.
  pose proof S as K. apply in_flat_map in K. destruct K as (e & E & K). apply kept_is in K. destruct K as [_ which].
  destruct (piece_is _ long e E) as (t & piece & T & P & e_is & _). exists (source piece).
  assert (on_s : lies_on (source piece) s).
  { apply (lies_on_of_one_place e s); [destruct which as [-> | ->] |].
    - left. split; reflexivity.
    - apply of_one_place_sym, reversed_place.
    - rewrite e_is. apply (lies_on_of_one_place piece);
        [apply of_one_place_sym, undirected_place | apply source_lies_on]. }
  split.
  - intros radius R. pose proof (chains_of_kept _ _ _ ends_) as edges_are.
    destruct (inside_near_the_chains _ long _ _ ends_ _ edges_are (source piece) radius) as (y & close & free & y_both);
      [right; exists s; split; [exact (Permutation_in _ (Permutation_sym edges_are) S) | exact on_s] | exact R |].
    apply both in y_both. destruct y_both as [round_p round_q]. exists y. split; [exact close |].
    rewrite <- inside_placed. split; (split; [| assumption]); intros f F; apply free, in_concat; eexists;
      (split; [| exact F]); cbn; tauto.
  - set (w := source piece) in *.
    assert (end_ : forall f v, In f (concat families) -> v = source f \/ v = target f ->
      is_vertex v p \/ is_vertex (minus x v) q).
    { intros f v F is_end. rewrite <- vertex_of_placed.
      destruct (edge_is f F), is_end as [-> | ->]; auto using source_is_vertex, target_is_vertex. }
    destruct (ends_of_a_piece t piece _ w P (or_introl eq_refl)) as [is_end | [is_end | (f & F & met)]];
      [destruct (end_ t w T); tauto .. |].
    apply intersection_is_on_both in met. destruct met as (on_t & on_f & [is_end | turn]).
    { destruct is_end as [is_end | [is_end | [is_end | is_end]]];
        [destruct (end_ t w T) | destruct (end_ t w T) | destruct (end_ f w F) | destruct (end_ f w F)]; tauto. }
    destruct (vertex_or_not w p) as [| not_p], (vertex_or_not (minus x w) q) as [| not_q]; [tauto .. |].
    right. right.
    assert (crossed : forall g h, In g (region_edges p) -> In h (region_edges (placed x q)) -> lies_on w g ->
      lies_on w h -> ~ cross (along g) (along h) == 0 -> edges_cross_at p q x w).
    { intros g h G H on_g on_h g_turn. rewrite edges_of_placed in H. apply in_map_iff in H.
      destruct H as (h' & <- & H). apply on_reflected in on_h. exists g, h'. repeat split; trivial.
      intros parallel. apply g_turn. by_computing. }
    destruct (edge_is t T) as [T_p | T_q], (edge_is f F) as [F_p | F_q].
    + now destruct not_p; apply (common_point_is_a_vertex p t f).
    + now apply (crossed t f).
    + apply (crossed f t); trivial. intros parallel. apply turn. unfold cross in *. lra.
    + now destruct not_q; apply vertex_of_placed, (common_point_is_a_vertex _ t f).
Qed.

(* P and Q, in one order or the other. *)
Definition are_both (p q a b : region) : Prop := a = p /\ b = q \/ a = q /\ b = p.

(* Contacts stay on the way. *)
Record contacts_stay (p q : region) (way : segment) : Prop := {
  vertices_stay : forall a b y z v f, are_both p q a b -> lies_on y way -> lies_on z way -> is_vertex v a ->
    In f (region_edges b) -> lies_on (minus y v) f -> lies_on (minus z v) f;
  no_vertices_meet : forall y v, lies_on y way -> is_vertex v p -> ~ is_vertex (minus y v) q }.

Lemma contacts_stay_other_way (p q : region) (way : segment) : contacts_stay p q way -> contacts_stay q p way.
Proof.
  intros [stay none]. split; [intros a b y z v f both; apply (stay a b); unfold are_both in *; tauto |].
  intros y v Y V U. apply (none y _ Y U), (vertex_of_equal v); [by_computing | exact V].
Qed.

Section OnTheWay.
  Variables p q : region.
  Variable way : segment.
  Variables y z w : vector.
  Hypotheses (p_region : valid_region p) (q_region : valid_region q).
  Hypothesis stay : contacts_stay p q way.
  Hypotheses (Y : lies_on y way) (Z : lies_on z way).

  (* Edges that cross keep crossing. *)
  Lemma crossing_stays : edges_cross_at p q y w -> interiors_meet z p q.
  Proof.
    intros (e & f & E & F & on_e & on_f & not_p & not_q & turn).
    pose proof (fun v z u f => vertices_stay _ _ _ stay p q v z u f (or_introl (conj eq_refl eq_refl))) as of_p.
    pose proof (fun v z u f => vertices_stay _ _ _ stay q p v z u f (or_intror (conj eq_refl eq_refl))) as of_q.
    assert (once : forall v, lies_on v e -> lies_on (minus y v) f -> equal_vectors v w).
    { intros v on on'. apply (lines_meet_once e (reflected y f) w); trivial; [| now apply on_reflected ..].
      intros parallel. apply turn. by_computing. }
    assert (vertex_of_p : forall v, is_vertex v p -> lies_on v e -> ~ lies_on (minus y v) f)
      by (intros v vertex on on'; apply not_p; now apply (vertex_of_equal v), vertex; apply once).
    assert (vertex_of_q : forall u, is_vertex u q -> lies_on u f -> ~ lies_on (minus y u) e).
    { intros u vertex on on'. apply not_q. apply (vertex_of_equal u); [| exact vertex].
      assert (equal : equal_vectors (minus y u) w); [| by_computing].
      apply once; [exact on' | apply (lies_on_equal u); [by_computing | exact on]]. }
    assert (general : forall v, lies_on v way -> not_sum_of_an_end v e f).
    { intros v V. repeat split; intros on.
      - apply (vertex_of_p (source e)), (of_p v y); auto using source_is_vertex, source_lies_on.
      - apply (vertex_of_p (target e)), (of_p v y); auto using target_is_vertex, target_lies_on.
      - apply (vertex_of_q (source f)), (of_q v y); auto using source_is_vertex, source_lies_on.
      - apply (vertex_of_q (target f)), (of_q v y); auto using target_is_vertex, target_lies_on. }
    assert (same_number : winding_number y (parallelogram e f) = winding_number z (parallelogram e f)).
    { apply (winding_number_along (Segment y z) _ (closed_chain_cycles _)). intros v on.
      now apply off_parallelogram, general, (common_part way y z). }
    destruct (parallelogram_winding_number z e f) as [none | [_ (v & u & on_v & on_u & equal)]].
    { destruct (crossing_edges_count y e f); auto; try lia;
        [exact (region_edges_are_directions p (proj1 p_region) e E) |
         exact (region_edges_are_directions q (proj1 q_region) f F) |].
      exists w, (minus y w). split; [exact on_e |]. split; [exact on_f | by_computing]. }
    apply (transversal_edges_meet p q z v u e f); trivial; intros vertex.
    - apply (vertex_of_p v vertex on_v), (of_p z y); trivial.
      apply (lies_on_equal u); [by_computing | exact on_u].
    - apply (vertex_of_q u vertex on_u), (of_q z y); trivial.
      apply (lies_on_equal v); [by_computing | exact on_v].
  Qed.

  Hypothesis q_simple : nowhere_above_one q.

  (* What is close to a vertex of P stays inside -Q + x. *)
  Lemma vertex_stays : is_vertex w p -> meet_near p q y w -> interiors_meet z p q.
  Proof.
    intros vertex near.
    pose proof (fun v z f => vertices_stay _ _ _ stay p q v z w f (or_introl (conj eq_refl eq_refl))) as stays.
    assert (free : forall v, lies_on v way -> ~ is_vertex (minus v w) q)
      by (intros v V; exact (no_vertices_meet _ _ _ stay v w V vertex)).
    destruct (on_or_off (minus y w) (region_edges q)) as [(f & F & on_y) | off_y].
    - pose proof (stays y z f Y Z vertex F on_y) as on_z.
      destruct (inside_beside_an_edge q f _ q_region q_simple F on_y (free y Y)) as (r1 & R1 & at_y).
      destruct (inside_beside_an_edge q f _ q_region q_simple F on_z (free z Z)) as (r2 & R2 & at_z).
      destruct (near (Qmin r1 r2)) as (v & close & in_p & in_q); [now apply Q.min_glb_lt |].
      pose proof (Q.le_min_l r1 r2). pose proof (Q.le_min_r r1 r2).
      exists v. split; [exact in_p |]. apply at_z; [by_computing |]. apply at_y in in_q; [| by_computing].
      pose proof (on_the_line _ f on_y). pose proof (on_the_line _ f on_z). by_computing.
    - destruct (winding_number_near _ _ (region_cycles q) off_y) as (radius & R & same_near).
      destruct (near radius R) as (v & close & _ & _ & round).
      destruct (same_near (minus y v)) as [_ same_v]; [by_computing |].
      assert (off_way : forall u, lies_on u (Segment (minus y w) (minus z w)) -> off u (region_edges q)).
      { intros u (k & range & kx & ky) f F on. apply (off_y f F), (stays (plus u w) y); trivial.
        - apply (common_part way y z); trivial. exists k. split; [exact range | by_computing].
        - apply (lies_on_equal u); [by_computing | exact on]. }
      destruct vertex as (s & S & equal).
      apply interiors_meet_other_way, (inner_point_and_point q p z (minus z w) w);
        [now apply valid_is_regular | | | by_computing].
      + split; [apply off_way, (target_lies_on (Segment _ _)) |].
        pose proof (winding_number_along _ _ (region_cycles q) off_way) as same_number.
        cbn [source target] in same_number.
        lia.
      + right. exists s. split; [exact S |]. apply (lies_on_equal (source s)); [now symmetry | apply source_lies_on].
  Qed.
End OnTheWay.

(* Theorem. While contacts stay, the interiors meet all along the way or nowhere. *)
Theorem meeting_stays (p q : region) (way : segment) (y z : vector) :
  valid_region p -> valid_region q -> nowhere_above_one p -> nowhere_above_one q -> contacts_stay p q way ->
  lies_on y way -> lies_on z way -> interiors_meet y p q -> interiors_meet z p q.
Proof.
  intros p_region q_region p_simple q_simple stay Y Z meet.
  destruct (a_common_corner p q y p_region q_region meet) as (w & near & [of_p | [of_q | crossing_]]).
  - now apply (vertex_stays p q way y z w).
  - apply interiors_meet_other_way.
    apply (vertex_stays q p way y z (minus y w)); trivial; [now apply contacts_stay_other_way |].
    intros radius R. destruct (near radius R) as (v & close & in_p & in_q). exists (minus y v).
    split; [by_computing |]. split; [exact in_q |]. apply (inside_equal v); [by_computing | exact in_p].
  - now apply (crossing_stays p q way y z w).
Qed.
