(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Where the open sum is beside x, in a direction n, and x itself is not in it, a segment of the reduced convolution
   covers x that has n to its left. Not so for sums of two vertices yet, nor if an edge that touches at x is along n.
   Where the sum is beside x, a vertex of one region is inside the other, or edges cross (winding_number_of_the_sum.v);
   close to x, these touch at x, and the sum is to the left of the edge that touches. That a segment of the reduced
   convolution is there is from reduced_edges_that_pass.v. *)
From Coq Require Import ZArith Lia Bool List Arith.
From Oplus Require Import numbers regions_and_sums parallelogram crossing_edges inside_a_corner boundary_points
  reduced_convolution right_of_an_edge edges_at_a_point fans_that_touch edges_that_pass reduced_edges_that_pass.
Import ListNotations.

Open Scope Q_scope.

(* A point inside an edge of P that has n to its left, and a vertex of Q, add up to x. *)
Definition touches (x n : vector) (p q : region) : Prop :=
  exists e w u, In e (region_edges p) /\ lies_on w e /\ ~ is_vertex w p /\ is_vertex u q /\
    equal_vectors x (plus w u) /\ 0 < cross (along e) n.

(* No edge that passes through x, by a point inside it and any point of the other region, is along n. *)
Definition none_passes_along (x n : vector) (p q : region) : Prop :=
  forall e w u, In e (region_edges p) -> lies_on w e -> ~ is_vertex w p -> in_region u q ->
    equal_vectors x (plus w u) -> ~ cross (along e) n == 0.

Section OneSide.
  Variables p q : region.
  Variables x n : vector.
  Hypothesis p_region : valid_region p.
  Hypothesis q_region : valid_region q.
  Hypothesis outside : ~ interiors_meet x p q.
  Hypothesis transversal : none_passes_along x n p q.
  Hypothesis no_vertices : forall w u, is_vertex w p -> is_vertex u q -> ~ equal_vectors x (plus w u).

  Let p_edges : no_edges_are_points p := proj1 p_region.
  Let q_edges : no_edges_are_points q := proj1 q_region.

  (* Where n is to the right of an edge through x, and the winding number there is positive, P is filled on both sides
     of the edge, and interiors meet. *)
  Lemma not_filled_to_the_right (e : segment) (w u : vector) : In e (region_edges p) -> lies_on w e ->
    ~ is_vertex w p -> is_vertex u q -> equal_vectors x (plus w u) -> cross (along e) n < 0 ->
    eventually (fun t => ~ (0 < winding_number (moved_along w n t) (region_edges p))%Z).
  Proof.
    intros E on no_vertex (g & G & at_source) x_is right_. pose proof p_region as (_ & _ & p_meet).
    destruct (right_side_near p e w p_meet E on no_vertex) as (r1 & R1 & same_number).
    destruct (no_other_edge_near p e w p_meet E on no_vertex) as (before & after & r2 & _ & R2 & free).
    refine (eventually_implied _ _ _ (eventually_and _ _ (small_steps_stay_within r1 w n R1)
      (eventually_below 1 ltac:(lra)))). intros t [near [some _]] round.
    assert (right_t : area e (moved_along w n t) < 0).
    { setoid_replace (area e (moved_along w n t)) with (area e w + t * cross (along e) n) by by_coordinates.
      rewrite (on_the_line w e on). nra. }
    assert (fills_right : fills_left w (opposite (along e)) p).
    { exists (Qmin r1 r2). split; [now apply Q.min_glb_lt |]. intros z close left_.
      assert (right_z : area e z < 0)
        by (rewrite (area_from w z e on); unfold cross, opposite in *; cbn [vx vy] in *; lra).
      assert (near_1 : within r1 w z) by (refine (within_smaller _ _ _ _ _ close); apply Q.le_min_l).
      assert (near_2 : within r2 w z) by (refine (within_smaller _ _ _ _ _ close); apply Q.le_min_r).
      split; [apply free; [exact near_2 | lra] |]. now rewrite (same_number z (moved_along w n t)). }
    pose proof (fills_left_beside_an_edge p e w p_region E on no_vertex) as fills.
    pose proof (region_edges_are_directions p p_edges e E) as long_e.
    pose proof (region_edges_are_directions q q_edges g G) as long_g.
    pose proof (departs_from_its_source u g long_g at_source) as g_departs.
    assert (on_g : lies_on u g) by (now apply departs_is in g_departs).
    pose proof (proj1 (sides_of_edges p q x w u _ g q_region outside x_is fills G) g_departs) as left_g.
    pose proof (proj1 (sides_of_edges p q x w u _ g q_region outside x_is fills_right G) g_departs) as right_g.
    destruct (parallel_directions (along e) (along g) long_e long_g) as [(m & m_some & X & Y) | back].
    - unfold cross, opposite in *; cbn [vx vy] in *. lra.
    - apply outside, (opposite_edge_meets p q x w u (opposite (along e)) g); trivial. exists m.
      unfold opposite; cbn [vx vy]. rewrite X, Y. split; [exact m_some | split; ring].
    - now apply outside, (opposite_edge_meets p q x w u (along e) g).
  Qed.

  (* A vertex of Q that is inside P where x is moved to the left a little. *)
  Lemma vertex_beside (v : vector * corner) : In v (region_vertices q) ->
    eventually (fun t => (0 < winding_number (minus (moved_along x n t) (fst v)) (region_edges p))%Z ->
      touches x n p q).
  Proof.
    intros I. destruct v as [v c]. cbn [fst]. destruct (edges_of_vertex v c q I) as [_ (g & G & source_is & _)].
    assert (vertex : is_vertex v q) by (exists g; split; [exact G | rewrite source_is; split; reflexivity]).
    set (w := minus x v).
    assert (x_is : equal_vectors x (plus w v)) by (unfold w, plus, minus; split; cbn [vx vy]; ring).
    assert (moved_is : forall t, winding_number (minus (moved_along x n t) v) (region_edges p) =
      winding_number (moved_along w n t) (region_edges p))
      by (intros t; apply winding_number_of_equal; unfold w, moved_along, minus; cbn [vx vy]; ring).
    pose proof (vertex_is_in_region v q vertex) as in_q.
    destruct (on_or_off w (region_edges p)) as [(e & E & on) | free].
    - assert (no_vertex : ~ is_vertex w p) by (intros is_; exact (no_vertices w v is_ vertex x_is)).
      destruct (Q_dec (cross (along e) n) 0) as [[right_ | left_] | flat].
      + refine (eventually_implied _ _ _ (not_filled_to_the_right e w v E on no_vertex vertex x_is right_)).
        intros t none round. rewrite moved_is in round. contradiction.
      + exists 1. split; [lra |]. intros t _ _ _. now exists e, w, v.
      + exfalso. now apply (transversal e w v E on no_vertex).
    - destruct (winding_number_near w _ (region_cycles p) free) as (radius & R & same_number).
      refine (eventually_implied _ _ _ (small_steps_stay_within radius w n R)). intros t near round. exfalso.
      destruct (same_number _ near) as [_ equal]. rewrite moved_is, equal in round.
      apply outside, (inner_point_and_point p q x w v); trivial; [| now split].
      apply regions_are_regular; apply q_region.
  Qed.

  (* Edges that add up to x by a point that is no vertex, and to a point beside x. *)
  Lemma edges_beside (e f : segment) (w u : vector) (t : Q) : In e (region_edges p) -> In f (region_edges q) ->
    lies_on w e -> lies_on u f -> ~ is_vertex w p -> equal_vectors x (plus w u) -> ~ cross (along e) (along f) == 0 ->
    0 < t -> is_sum_of_points (moved_along x n t) e f -> touches x n p q.
  Proof.
    intros E F on_e on_f no_vertex x_is turn some (w' & u' & on_e' & on_f' & [X' Y']).
    pose proof (fills_left_beside_an_edge p e w p_region E on_e no_vertex) as fills.
    destruct (sides_of_edges p q x w u _ f q_region outside x_is fills F) as [ahead behind].
    destruct (vertex_or_not u q) as [vertex | inside_].
    2: { exfalso. destruct (passes_both_ways q u f F on_f inside_) as [departing_ arriving].
         specialize (ahead departing_). specialize (behind arriving). lra. }
    destruct (Q_dec (cross (along e) n) 0) as [[right_ | left_] | flat].
    - exfalso. pose proof (region_edges_are_directions q q_edges f F) as long.
      destruct (ahead_or_behind u (minus u' u) f on_f) as (m & mx & my & departing_ & arriving).
      { refine (lies_on_equal _ _ _ _ on_f'). unfold plus, minus; split; cbn [vx vy]; ring. }
      assert (value : m * cross (along e) (along f) == t * cross (along e) n + area e w - area e w').
      { transitivity (cross (along e) (minus u' u)); [unfold cross; rewrite mx, my; ring |]. destruct x_is as [X Y].
        unfold plus in *. in_coordinates. by_equations. }
      rewrite (on_the_line w e on_e), (on_the_line w' e on_e') in value.
      assert (t * cross (along e) n < 0) by nra. destruct (Q_dec m 0) as [[low | high] | none].
      + specialize (behind (arriving low long)). nra.
      + specialize (ahead (departing_ high long)). nra.
      + rewrite none in value. lra.
    - now exists e, w, u.
    - exfalso. apply (transversal e w u E on_e no_vertex); trivial. right. now exists f.
  Qed.
End OneSide.

Section BothSides.
  Variables p q : region.
  Variables x n : vector.
  Hypothesis p_region : valid_region p.
  Hypothesis q_region : valid_region q.
  Hypothesis outside : ~ interiors_meet x p q.
  Hypothesis transversal : none_passes_along x n p q.
  Hypothesis transversal' : none_passes_along x n q p.
  Hypothesis no_vertices : forall w u, is_vertex w p -> is_vertex u q -> ~ equal_vectors x (plus w u).

  Let outside' : ~ interiors_meet x q p.
  Proof. intros meet_. apply outside. now apply interiors_meet_other_way. Qed.
  Let other_order (a b : vector) : equal_vectors x (plus a b) -> equal_vectors x (plus b a).
  Proof. apply sum_in_other_order. Qed.
  Let no_vertices' : forall w u, is_vertex w q -> is_vertex u p -> ~ equal_vectors x (plus w u).
  Proof. intros w u of_q of_p equal. exact (no_vertices u w of_p of_q (other_order _ _ equal)). Qed.
  Let none_meet : forall w u, is_vertex w p -> is_vertex u q -> equal_vectors x (plus w u) -> alone w p /\ alone u q.
  Proof. intros w u of_p of_q equal. now destruct (no_vertices w u of_p of_q). Qed.

  (* If the boundary of the sum of two edges goes round points beside x, x is in this sum. *)
  Lemma sum_beside (e f : segment) :
    eventually (fun t => winding_number (moved_along x n t) (parallelogram e f) <> 0%Z -> is_sum_of_points x e f).
  Proof.
    destruct (on_or_off x (parallelogram e f)) as [(side & S & (k & range & X & Y)) | free].
    - exists 1. split; [lra |]. intros _ _ _ _.
      set (part := fun (s : segment) (k : Q) => Vector ((1 - k) * vx (source s) + k * vx (target s))
                                                       ((1 - k) * vy (source s) + k * vy (target s))).
      assert (by_parts : forall h l, 0 <= h <= 1 -> 0 <= l <= 1 ->
        equal_vectors x (plus (part e h) (part f l)) -> is_sum_of_points x e f).
      { intros h l h_range l_range x_is. exists (part e h), (part f l).
        split; [exists h | split; [exists l | exact x_is]]; now repeat split. }
      cbn in S. destruct S as [<- | [<- | [<- | [<- | []]]]];
        [apply (by_parts k 0) | apply (by_parts 1 k) | apply (by_parts (1 - k) 1) | apply (by_parts 0 (1 - k))];
        try lra; unfold plus, part in *; cbn [source target vx vy] in *; split; cbn [vx vy]; rewrite ?X, ?Y; ring.
    - assert (closed_ : cycles (parallelogram e f)).
      { pose proof (region_cycles [[plus (source e) (source f); plus (target e) (source f);
          plus (target e) (target f); plus (source e) (target f)]]) as closed_.
        unfold region_edges in closed_. cbn [flat_map] in closed_. now rewrite app_nil_r in closed_. }
      destruct (winding_number_near x _ closed_ free) as (radius & R & near).
      refine (eventually_implied _ _ _ (small_steps_stay_within radius x n R)). intros t close some.
      destruct (near _ close) as [_ equal]. rewrite equal in some.
      now destruct (parallelogram_winding_number x e f) as [none | [_ is_sum]].
  Qed.

  Lemma parallelogram_beside (e f : segment) : In e (region_edges p) -> In f (region_edges q) ->
    eventually (fun t => winding_number (moved_along x n t) (parallelogram e f) <> 0%Z ->
      touches x n p q \/ touches x n q p).
  Proof.
    intros E F. destruct (Qeq_dec (cross (along e) (along f)) 0) as [flat | turn].
    { exists 1. split; [lra |]. intros t _ _ some. exfalso.
      destruct (parallelogram_winding_number (moved_along x n t) e f) as [none | [[[_ sign] | [_ sign]] _]];
        [contradiction | lra ..]. }
    refine (eventually_implied _ _ _ (eventually_and _ _ (sum_beside e f) (eventually_below 1 ltac:(lra)))).
    intros t [at_x [some _]] round.
    destruct (parallelogram_winding_number (moved_along x n t) e f) as [none | [_ beside]]; [contradiction |].
    destruct (at_x round) as (w & u & on_e & on_f & x_is).
    destruct (vertex_or_not w p) as [w_vertex | w_free].
    - destruct (vertex_or_not u q) as [u_vertex | u_free];
        [exfalso; exact (no_vertices w u w_vertex u_vertex x_is) | right].
      apply (edges_beside q p x n q_region p_region outside' transversal' f e u w t); trivial.
      + now apply other_order.
      + unfold cross in *. lra.
      + destruct beside as (a & b & on_a & on_b & X & Y). exists b, a. unfold plus in *; cbn [vx vy] in *.
        split; [exact on_b |]. split; [exact on_a |]. split; cbn [vx vy]; lra.
    - left. now apply (edges_beside p q x n p_region q_region outside transversal e f w u t).
  Qed.

  (* What is beside x shows at x. *)
  Lemma touches_beside :
    eventually (fun t => interiors_meet (moved_along x n t) p q) -> touches x n p q \/ touches x n q p.
  Proof.
    intros meet_. pose proof p_region as (p_edges & p_valid & _). pose proof q_region as (q_edges & q_valid & _).
    assert (of_p : eventually (fun t => forall v, In v (region_vertices p) ->
      (0 < winding_number (minus (moved_along x n t) (fst v)) (region_edges q))%Z -> touches x n q p))
      by (apply eventually_for_all; intros v I; now apply (vertex_beside q p)).
    assert (of_q : eventually (fun t => forall v, In v (region_vertices q) ->
      (0 < winding_number (minus (moved_along x n t) (fst v)) (region_edges p))%Z -> touches x n p q))
      by (apply eventually_for_all; intros v I; now apply (vertex_beside p q)).
    assert (of_both : eventually (fun t => forall s, In s (list_prod (region_edges p) (region_edges q)) ->
      winding_number (moved_along x n t) (parallelogram (fst s) (snd s)) <> 0%Z -> touches x n p q \/ touches x n q p)).
    { apply (eventually_for_all (fun s t => winding_number (moved_along x n t) (parallelogram (fst s) (snd s)) <> 0%Z ->
        touches x n p q \/ touches x n q p)). intros [e f] I. apply in_prod_iff in I. now apply parallelogram_beside. }
    destruct (some_small _ (eventually_and _ _ meet_ (eventually_and _ _ of_p (eventually_and _ _ of_q of_both))))
      as (t & _ & meets & by_p & by_q & by_both).
    pose proof (interiors_meet_means_positive_winding_number p q _ p_edges q_edges p_valid q_valid meets) as round.
    assert (proper_d : nonzero (Vector 1 0)) by (unfold nonzero; cbn; lra).
    destruct (a_term_is_positive p q (Vector 1 0) _ p_edges q_edges p_valid q_valid proper_d round)
      as [(v & I & _ & inside_q) | [(v & I & _ & inside_p) | (e & f & E & F & _ & some & _)]].
    - right. exact (by_p v I inside_q).
    - left. exact (by_q v I inside_p).
    - apply (by_both (e, f)); [now apply in_prod | exact some].
  Qed.

  (* Theorem. If the open sum is beside x in the direction n, a segment of the reduced convolution covers x that has n
     to its left; its direction is that of an edge that passes. *)
  Theorem segments_beside_the_open_sum : eventually (fun t => interiors_meet (moved_along x n t) p q) ->
    exists d, reduced_along p q x d /\ 0 < cross d n /\
      exists e w u, along e = d /\ lies_on w e /\ equal_vectors x (plus w u) /\
        ((In e (region_edges p) /\ ~ is_vertex w p /\ in_region u q) \/
         (In e (region_edges q) /\ ~ is_vertex w q /\ in_region u p)).
  Proof.
    intros meet_.
    destruct (touches_beside meet_) as
      [(e & w & u & E & on_e & no_vertex & vertex & x_is & left_) |
       (e & w & u & E & on_e & no_vertex & vertex & x_is & left_)]; apply vertex_is_in_region in vertex;
      exists (along e); (split; [| split; [exact left_ | exists e, w, u; tauto]]).
    - now apply (passing_edges_of_p_are_covered p q x p_region q_region outside none_meet w u e).
    - now apply (passing_edges_of_q_are_covered p q x p_region q_region outside none_meet w u e).
  Qed.
End BothSides.
