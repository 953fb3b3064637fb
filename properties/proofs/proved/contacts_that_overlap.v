(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Where the boundaries of P and -Q + x touch, and x is on no segment of the convolution, nor of the original one, both
   are convex there, or straight, and some direction is to the left of the edges of both: it leads inside both. For a
   reflex vertex that touches an edge is one of 𝒞, or of its flip set. And if no direction is to the left of all edges,
   those of the one come between those of the other, reversed; so a tangent set contains an edge's direction. *)
From Coq Require Import QArith Lqa ZArith Lia Bool List.
From Oplus Require Import convolution regions_and_sums small_numbers simple_chain tracing convolution_winding
  reflected replaced_segments definition_2_2_8 tangent_direction reduced_convolution edges_at_a_point fans_that_touch
  polygons_of_the_thesis coordinates turned_chains edges_of_polygons leaving_a_polygon.
Import ListNotations.

Open Scope Q_scope.

Lemma strictly_between_two (s v t : vector) : nonzero v -> 0 < cross s t -> 0 <= cross s v -> 0 <= cross v t ->
  0 < cross v (minus t s).
Proof.
  intros long left_ low high. setoid_replace (cross v (minus t s)) with (cross v t + cross s v)
    by (unfold cross, minus; cbn [vx vy]; ring).
  apply Qnot_le_lt. intros none. pose proof (square_positive v long).
  assert (identity : cross s t * dot v v == cross s v * dot v t + cross v t * dot v s) by (unfold cross, dot; ring).
  assert (v_t : cross v t == 0) by lra. assert (s_v : cross s v == 0) by lra. rewrite v_t, s_v in identity. nra.
Qed.

Lemma same_direction_or_turn (a b : vector) : nonzero a -> nonzero b -> ~ same_direction a (opposite b) ->
  cross a b == 0 -> forall v, exists k, 0 < k /\ cross a v == k * cross b v.
Proof.
  intros long_a long_b not_back flat v. destruct (parallel_directions a b long_a long_b flat) as [(k & some & X & Y) |];
    [| contradiction].
  exists k. split; [exact some |]. unfold cross. rewrite X, Y. ring.
Qed.

Lemma turns_not_back (a b : vector) : turns a b -> ~ same_direction a (opposite b).
Proof.
  intros (_ & long & ahead) (k & some & X & Y). pose proof (square_positive b long).
  unfold cross, dot, opposite in *. cbn [vx vy] in *. rewrite X, Y in ahead. specialize (ahead ltac:(ring)). nra.
Qed.

(* Two corners that are not reflex, none of which has an edge of the other, reversed, between its edges. *)
Lemma left_of_two_corners (a1 a2 b1 b2 : vector) : turns a1 a2 -> turns b1 b2 -> 0 <= cross a1 a2 ->
  0 <= cross b1 b2 ->
  (forall a b, a = a1 \/ a = a2 -> b = b1 \/ b = b2 -> ~ same_direction a (opposite b) /\
    ~ (cross a1 b < 0 /\ cross b a2 < 0) /\ ~ (cross b1 a < 0 /\ cross a b2 < 0)) ->
  exists u, 0 < cross a1 u /\ 0 < cross a2 u /\ 0 < cross b1 u /\ 0 < cross b2 u.
Proof.
  revert a1 a2 b1 b2.
  assert (one_order : forall a1 a2 b1 b2, turns a1 a2 -> turns b1 b2 -> 0 <= cross a1 a2 -> 0 <= cross b1 b2 ->
    (forall a b, a = a1 \/ a = a2 -> b = b1 \/ b = b2 -> ~ same_direction a (opposite b) /\
      ~ (cross a1 b < 0 /\ cross b a2 < 0) /\ ~ (cross b1 a < 0 /\ cross a b2 < 0)) -> 0 <= cross a1 b1 ->
    exists u, 0 < cross a1 u /\ 0 < cross a2 u /\ 0 < cross b1 u /\ 0 < cross b2 u).
  { intros a1 a2 b1 b2 turn_a turn_b left_a left_b none first_. pose proof turn_a as (long_a1 & long_a2 & _).
    pose proof turn_b as (long_b1 & long_b2 & _).
    assert (back : forall v w, cross v w == - cross w v) by (intros; unfold cross; ring).
    assert (itself : forall v, cross v v == 0) by (intros; unfold cross; ring).
    (* a1 is to the right of all *)
    assert (right_most : 0 <= cross a1 b2).
    { apply Qnot_lt_le. intros right_. destruct (none a1 b1) as (apart_ & _); try tauto.
      destruct (none a1 b1) as (_ & _ & between_); try tauto. apply between_. split; [| exact right_].
      rewrite back. destruct (Qlt_le_dec 0 (cross a1 b1)) as [| level]; [lra | exfalso].
      destruct (same_direction_or_turn a1 b1 long_a1 long_b1 apart_ ltac:(lra) b2) as (k & some & value). nra. }
    destruct (Qlt_le_dec (cross a2 b2) 0) as [a2_last | b2_last].
    - assert (left_ : 0 < cross a1 a2).
      { apply Qnot_le_lt. intros level.
        destruct (same_direction_or_turn a1 a2 long_a1 long_a2 (turns_not_back _ _ turn_a) ltac:(lra) b2) as (k & some &
          value). nra. }
      assert (b1_before : 0 <= cross b1 a2).
      { apply Qnot_lt_le. intros beyond. destruct (none a2 b2) as (_ & _ & between_); try tauto. }
      exists (minus a2 a1). pose proof (back b2 a2).
      repeat split; apply strictly_between_two; trivial; rewrite ?itself; lra.
    - destruct (Qlt_le_dec 0 (cross a1 b2)) as [left_ | level].
      + exists (minus b2 a1). repeat split; apply strictly_between_two; trivial; rewrite ?itself; lra.
      + (* all have one direction *)
        destruct (none a1 b2) as (apart_ & _); try tauto.
        assert (flat : cross a1 b2 == 0) by lra.
        pose proof (same_direction_or_turn a1 b2 long_a1 long_b2 apart_ flat) as same_.
        assert (a_flat : cross a1 a2 == 0).
        { destruct (same_ a2) as (k & some & value). pose proof (back b2 a2). nra. }
        assert (b_flat : cross b1 b2 == 0).
        { destruct (same_ b1) as (k & some & value). pose proof (back b2 b1). nra. }
        set (u := Vector (- vy a1) (vx a1)). pose proof (square_positive a1 long_a1) as square.
        assert (a1_left : 0 < cross a1 u) by (unfold u, cross, dot in *; cbn [vx vy]; lra).
        destruct (same_ u) as (k & some & value).
        destruct (same_direction_or_turn a1 a2 long_a1 long_a2 (turns_not_back _ _ turn_a) a_flat u) as (l & some' &
          value').
        destruct (same_direction_or_turn b1 b2 long_b1 long_b2 (turns_not_back _ _ turn_b) b_flat u) as (m & some'' &
          value'').
        assert (b2_left : 0 < cross b2 u) by nra.
        exists u. repeat split; trivial; [| rewrite value'']; nra. }
  intros a1 a2 b1 b2 turn_a turn_b left_a left_b none.
  destruct (Qlt_le_dec (cross a1 b1) 0) as [b_first | a_first]; [| now apply one_order].
  destruct (one_order b1 b2 a1 a2) as (u & all); trivial; [| unfold cross in *; lra | exists u; tauto].
  intros b a B A. destruct (none a b A B) as (apart_ & one & two). split; [| tauto].
  intros (k & some & X & Y). apply apart_. exists (/ k). split; [now apply Qinv_lt_0_compat |].
  unfold opposite in *. cbn [vx vy] in *. rewrite X, Y. split; field; lra.
Qed.

Lemma edge_as_direction (c : list vector) (i : nat) : (i < length c)%nat -> along (edge_at c i) = edge_of_chain c i.
Proof. intros I. symmetry. now apply direction_by_index. Qed.

Lemma corner_by_edges (c : list vector) (i : nat) : (i < length c)%nat ->
  corner_of_chain c i = Corner (along (edge_at c (previous (length c) i))) (along (edge_at c i)).
Proof. intros I. rewrite corner_is, !edge_as_direction by (trivial; now apply previous_below). reflexivity. Qed.

Lemma reflex_corner (c : list vector) (i : nat) : (i < length c)%nat -> reflex_at c i ->
  is_reflex (corner_of_chain c i) = true.
Proof.
  intros I reflex. rewrite corner_by_edges by exact I. unfold is_reflex, reflex_at in *. cbn [incoming outgoing].
  destruct (negative_spec (cross (along (edge_at c (previous (length c) i))) (along (edge_at c i)))); [reflexivity |].
  contradiction.
Qed.

Section TwoPolygons.
  Variables p q : list vector.
  Hypothesis p_polygon : simple_polygon p.
  Hypothesis q_polygon : simple_polygon q.
  Variable x : vector.
  Hypothesis free : off x (convolution_segments [p] [q]).
  Hypothesis free' : off x (original_convolution [p] [q]).
  Let p_region := simple_polygons_are_regions p p_polygon.
  Let q_region := simple_polygons_are_regions q q_polygon.

  Lemma not_covered (d : vector) : ~ covered_along [p] [q] x d.
  Proof. intros (s & S & on & _). exact (free s S on). Qed.

  (* No segment of the vertex-edge sum at a reflex vertex has x. *)
  Lemma no_flip_there (label : summand) (i j : nat) : (i < length p)%nat -> (j < length q)%nat ->
    is_reflex (snd (snd (vertex_of ((p, q), (label, (i, j)))))) = true ->
    ~ exists t, 0 <= t <= 1 /\ equal_vectors x (match label with OfP => plus (point_along p i t) (vertex q j)
                                                                | OfQ => plus (vertex p i) (point_along q j t) end).
  Proof.
    intros I J reflex there. set (s := ((p, q), (label, (i, j)))) in *.
    assert (on : lies_on x (segment_of s)) by now apply lies_on_a_segment_of.
    assert (listed : In s (vertex_edge_sum [p] [q])).
    { apply in_flat_map. exists (p, q). split; [now left |]. apply in_map, in_all_segments. now split. }
    destruct (belongs_to_convolution s) eqn:belongs.
    - apply (free (segment_of s)); [| exact on]. apply (in_map segment_of), in_flat_map. exists (p, q).
      split; [now left |]. apply in_map. apply (in_those (length p) (length q) (in_convolution p q)). now split.
    - apply (free' (reversed (segment_of s))); [| now apply lies_on_reversed].
      apply in_app_iff. right. apply (in_map (fun s => reversed (segment_of s))), filter_In.
      split; [exact listed |]. now rewrite belongs, reflex.
  Qed.

  Lemma reflex_of_p_is_off (i : nat) : (i < length p)%nat -> reflex_at p i ->
    off (minus x (vertex p i)) (region_edges [q]).
  Proof.
    intros I reflex f F on. destruct (edges_of_one q f F) as (j & J & -> & _).
    apply (no_flip_there OfQ i j I J).
    - cbn. now apply reflex_corner.
    - destruct (on_by_index q j _ J on) as (t & range & X & Y). exists t. split; [exact range |].
      unfold equal_vectors, plus, minus in *. cbn [vx vy] in *. split; lra.
  Qed.

  Lemma reflex_of_q_is_off (j : nat) : (j < length q)%nat -> reflex_at q j ->
    off (minus x (vertex q j)) (region_edges [p]).
  Proof.
    intros J reflex e E on. destruct (edges_of_one p e E) as (i & I & -> & _).
    apply (no_flip_there OfP i j I J).
    - cbn. now apply reflex_corner.
    - destruct (on_by_index p i _ I on) as (t & range & X & Y). exists t. split; [exact range |].
      unfold equal_vectors, plus, minus in *. cbn [vx vy] in *. split; lra.
  Qed.

  Lemma not_reflex_where_it_touches (c : list vector) (z : vector) (s t : segment) (opposed : list segment) :
    (forall i, (i < length c)%nat -> reflex_at c i -> off (minus x (vertex c i)) opposed) ->
    (exists f, In f opposed /\ lies_on (minus x z) f) ->
    (s = t /\ ~ is_vertex z [c] \/ exists i, (i < length c)%nat /\ equal_vectors z (vertex c i) /\
      s = edge_at c (previous (length c) i) /\ t = edge_at c i /\ inside_a_corner.meet_in_vertex s t [c]) ->
    0 <= cross (along s) (along t).
  Proof.
    intros reflex_off (f & F & on) [[<- _] | (i & I & [X Y] & -> & -> & _)]; [unfold cross; lra |].
    apply Qnot_lt_le. intros reflex. apply (reflex_off i I reflex f F). apply (lies_on_equal (minus x z)); [| exact on].
    unfold equal_vectors, minus. cbn [vx vy]. rewrite X, Y. split; reflexivity.
  Qed.

  (* Theorem. *)
  Theorem left_of_all_edges_there (z : vector) : exists u, forall s,
    In s (region_edges [p] ++ map (reflected x) (region_edges [q])) -> lies_on z s -> 0 < cross (along s) u.
  Proof.
    assert (turned_ : forall f u, cross (along (reflected x f)) u == - cross (along f) u) by (intros; by_computing).
    enough (found : exists u, (forall e, In e (region_edges [p]) -> lies_on z e -> 0 < cross (along e) u) /\
      forall f, In f (region_edges [q]) -> lies_on (minus x z) f -> cross (along f) u < 0).
    { destruct found as (u & left_p & right_q). exists u. intros s S on. apply in_app_iff in S.
      destruct S as [S | S]; [now apply left_p |]. apply in_map_iff in S. destruct S as (f & <- & F).
      apply on_reflected in on. specialize (right_q f F on). rewrite turned_. lra. }
    destruct (on_or_off z (region_edges [p])) as [on_p | off_p].
    2:{ destruct (left_of_the_edges_there q q_polygon (minus x z)) as (u & left_). exists (opposite u).
        split; [intros e E on; destruct (off_p e E on) |]. intros f F on. specialize (left_ f F on).
        unfold cross, opposite in *. cbn [vx vy]. lra. }
    destruct (on_or_off (minus x z) (region_edges [q])) as [on_q | off_q].
    2:{ destruct (left_of_the_edges_there p p_polygon z) as (u & left_). exists u.
        split; [exact left_ | intros f F on; destruct (off_q f F on)]. }
    destruct (edges_there p p_polygon z on_p) as (s & t & S & T & on_s & on_t & only & turn & corner_).
    destruct (edges_there q q_polygon (minus x z) on_q) as (f & g & F & G & on_f & on_g & only' & turn' & corner_').
    assert (sum_ : equal_vectors x (plus z (minus x z)))
      by (unfold equal_vectors, plus, minus; cbn [vx vy]; split; ring).
    assert (on_p' : exists e, In e (region_edges [p]) /\ lies_on (minus x (minus x z)) e).
    { exists s. split; [exact S |]. apply (lies_on_equal z); [| exact on_s].
      unfold equal_vectors, minus. cbn [vx vy]. split; ring. }
    pose proof (not_reflex_where_it_touches p z s t _ reflex_of_p_is_off on_q corner_) as left_p.
    pose proof (not_reflex_where_it_touches q (minus x z) f g _ reflex_of_q_is_off on_p' corner_') as left_q.
    assert (itself : forall v w, ~ (0 < cross v w /\ 0 < cross w v)) by (intros v w; unfold cross; lra).
    destruct (left_of_two_corners (along s) (along t) (opposite (along f)) (opposite (along g))) as (u & su & tu & fu &
      gu); trivial.
    - destruct turn' as (long_f & long_g & ahead). split; [now apply opposite_nonzero |].
      split; [now apply opposite_nonzero |]. unfold cross, dot, opposite in *. cbn [vx vy] in *. intros flat.
      specialize (ahead ltac:(lra)). lra.
    - unfold cross, opposite in *. cbn [vx vy]. lra.
    - assert (all : forall e h, e = s \/ e = t -> h = f \/ h = g ->
        ~ same_direction (along e) (along h) /\ ~ (0 < cross (along s) (along h) /\ 0 < cross (along h) (along t)) /\
        ~ (0 < cross (along f) (along e) /\ 0 < cross (along e) (along g))).
      { intros e h E H.
        assert (in_e : In e (region_edges [p]) /\ lies_on z e) by (destruct E as [-> | ->]; now split).
        assert (in_h : In h (region_edges [q]) /\ lies_on (minus x z) h) by (destruct H as [-> | ->]; now split).
        destruct in_e as [E' on_e], in_h as [H' on_h]. split; [| split].
        - intros same_.
          destruct (common_direction_is_a_tie [p] [q] x z (minus x z) p_region q_region sum_ e h E' H' on_e on_h same_)
            as (a & b & A & B & tie).
          apply (not_covered (along e)), (tie_is_covered [p] [q] x p_region q_region a b); trivial.
          exact (polygon_edges_are_long p p_polygon e E').
        - intros [after before]. destruct corner_ as [[<- _] | (i & I & at_z & -> & -> & _)];
            [exact (itself _ _ (conj after before)) |].
          apply (not_covered (along h)). apply (tangent_of_q_is_covered [p] [q] x z (minus x z) sum_ h p i); trivial;
            [now left |].
          rewrite corner_by_edges by exact I. now apply tangent_between.
        - intros [after before]. destruct corner_' as [[<- _] | (j & J & at_z & -> & -> & _)];
            [exact (itself _ _ (conj after before)) |].
          apply (not_covered (along e)). apply (tangent_of_p_is_covered [p] [q] x z (minus x z) sum_ e q j); trivial;
            [now left |].
          rewrite corner_by_edges by exact J. now apply tangent_between. }
      intros a b A B.
      assert (exists e, (e = s \/ e = t) /\ a = along e) as (e & E & ->)
        by (destruct A as [-> | ->]; [exists s | exists t]; tauto).
      assert (exists h, (h = f \/ h = g) /\ b = opposite (along h)) as (h & H & ->)
        by (destruct B as [-> | ->]; [exists f | exists g]; tauto).
      destruct (all e h E H) as (apart_ & one & two). split; [| split].
      + intros (k & some & X & Y). apply apart_. exists k. unfold opposite in X, Y. cbn [vx vy] in X, Y.
        split; [exact some |]. split; lra.
      + intros [after before]. apply one. unfold cross, opposite in *. cbn [vx vy] in *. split; lra.
      + intros [after before]. apply two. unfold cross, opposite in *. cbn [vx vy] in *. split; lra.
    - exists u. split.
      + intros e E on. now destruct (only e E on) as [-> | ->].
      + intros h H on. destruct (only' h H on) as [-> | ->]; unfold cross, opposite in *; cbn [vx vy] in *; lra.
  Qed.
End TwoPolygons.
