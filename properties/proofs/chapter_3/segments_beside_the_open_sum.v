(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Where the open sum is beside x, in a direction n, and x itself is not in it, a segment of the reduced convolution
   covers x that has n to its left. Not so for sums of two vertices yet, nor if an edge that touches at x is along n.
   Where the sum is beside x, a vertex of one region is inside the other, or edges cross (winding_number_of_the_sum.v);
   close to x, these touch at x, and the sum is to the left of the edge that touches. That a segment of the reduced
   convolution is there is from reduced_edges_that_pass.v. *)
From Coq Require Import ZArith Lia Bool List Arith.
From Oplus Require Import numbers regions_and_sums parallelogram crossing_edges observation_2_2_4 lemma_2_2_9
  inside_a_corner tangent_direction boundary_points reduced_convolution right_of_an_edge reduced_edges_that_pass.
Import ListNotations.

Open Scope Q_scope.

(* A point inside an edge of P that has n to its left, and a vertex of Q, add up to x. *)
Definition touches (x n : vector) (p q : region) : Prop :=
  exists e w u, In e (region_edges p) /\ lies_on w e /\ ~ is_vertex w p /\ is_vertex u q /\
    equal_vectors x (plus w u) /\ 0 < cross (along e) n.

Lemma vertex_in_region (u : vector) (r : region) : is_vertex u r ->
  exists s, In s (region_edges r) /\ lies_on u s.
Proof.
  intros (s & I & [X Y]). exists s. split; [exact I |]. exists 0. rewrite X, Y. split; [lra |]. split; ring.
Qed.

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

  Let p_regular : is_regular p.
  Proof. destruct p_region as (p_edges & p_valid & p_meet). now apply regions_are_regular. Qed.
  Let q_regular : is_regular q.
  Proof. destruct q_region as (q_edges & q_valid & q_meet). now apply regions_are_regular. Qed.

  (* A vertex of Q that is inside P where x is moved to the left a little. *)
  Lemma vertex_beside (v : vector * corner) : In v (region_vertices q) ->
    eventually (fun t => (0 < winding_number (minus (moved_along x n t) (fst v)) (region_edges p))%Z ->
      touches x n p q).
  Proof.
    intros I. destruct v as [v c]. cbn [fst].
    destruct (edges_of_vertex v c q I) as [_ (g & G & source_is & _)].
    assert (vertex : is_vertex v q) by (exists g; split; [exact G | rewrite source_is; split; reflexivity]).
    destruct (vertex_in_region v q vertex) as (s & S & on_s).
    assert (in_q : in_region v q) by (right; now exists s).
    set (w := minus x v).
    assert (x_is : equal_vectors x (plus w v)) by (unfold w, plus, minus; split; cbn [vx vy]; ring).
    assert (moved_is : forall t, minus (moved_along x n t) v = Vector (vx x + t * vx n - vx v) (vy x + t * vy n - vy v))
      by reflexivity.
    assert (close : forall radius, 0 < radius -> eventually (fun t => within radius w (minus (moved_along x n t) v))).
    { intros radius R. refine (eventually_implied _ _ _ (small_steps_stay_within radius w n R)).
      intros t. unfold within, w, moved_along, minus; cbn [vx vy]. lra. }
    destruct (on_or_off w (region_edges p)) as [(e & E & on) | free].
    - assert (no_vertex : ~ is_vertex w p) by (intros is_; exact (no_vertices w v is_ vertex x_is)).
      pose proof p_region as (p_edges & _). pose proof (region_edges_are_directions p p_edges e E) as long.
      destruct (Q_dec (cross (along e) n) 0) as [[right_ | same_] | along_];
        [| | exfalso; exact (transversal e w v E on no_vertex in_q x_is along_)].
      2: { exists 1. split; [lra |]. intros t _ _ _. now exists e, w, v. }
      destruct (right_side_near p e w (proj2 (proj2 p_region)) E on no_vertex) as (r1 & R1 & same_number).
      destruct (half_square_beside_an_edge p e w p_region E on no_vertex) as (r2 & R2 & half_square).
      destruct (q_regular v s (Qmin r1 r2) S on_s) as (z & z_near & z_in); [now apply Q.min_glb_lt |].
      pose proof (Q.le_min_l r1 r2) as below_1. pose proof (Q.le_min_r r1 r2) as below_2.
      destruct (close r1 R1) as (limit & L & near). exists limit. split; [exact L |]. intros t t0 t1 positive_.
      exfalso. apply outside. apply interiors_meet_other_way.
      refine (inner_point_and_point q p x z (minus x z) p_regular z_in _ _);
        [| unfold plus, minus; split; cbn [vx vy]; ring].
      assert (b_near : within (Qmin r1 r2) w (minus x z))
        by (unfold within, w, minus in *; cbn [vx vy] in *; lra).
      assert (b_1 : within r1 w (minus x z)) by exact (within_smaller _ _ _ _ below_1 b_near).
      assert (b_2 : within r2 w (minus x z)) by exact (within_smaller _ _ _ _ below_2 b_near).
      destruct (half_square _ b_2) as [to_the_left on_the_line].
      destruct (Q_dec (area e (minus x z)) 0) as [[below | above] | line].
      + left. rewrite (same_number _ (minus (moved_along x n t) v) b_1 (near t t0 t1) below); [exact positive_ |].
        setoid_replace (area e (minus (moved_along x n t) v)) with (area e w + t * cross (along e) n)
          by (unfold w; by_coordinates).
        rewrite (meeting_of_segments.on_the_line w e on). nra.
      + now apply inside_is_in_region, to_the_left.
      + right. exists e. split; [exact E |]. now apply on_the_line.
    - destruct (winding_number_near w _ (region_cycles p) free) as (radius & R & same_number).
      destruct (close radius R) as (limit & L & near). exists limit. split; [exact L |]. intros t t0 t1 positive_.
      exfalso. apply outside. destruct (same_number _ (near t t0 t1)) as [_ equal].
      apply (inner_point_and_point p q x w v q_regular); trivial. split; [exact free | lia].
  Qed.

  (* Edges e and f that add up to points to the left of x, and to x by an end of f. *)
  Lemma edges_beside (e f : segment) (w u : vector) : In e (region_edges p) -> In f (region_edges q) ->
    lies_on w e -> lies_on u f -> is_vertex u q -> equal_vectors x (plus w u) ->
    eventually (fun t => is_sum_of_points (moved_along x n t) e f -> touches x n p q).
  Proof.
    intros E F on_e on_f vertex x_is.
    assert (no_vertex : ~ is_vertex w p) by (intros is_; exact (no_vertices w u is_ vertex x_is)).
    pose proof p_region as (p_edges & valid & meet). pose proof (region_edges_are_directions p p_edges e E) as long.
    assert (in_q : in_region u q) by (right; now exists f).
    destruct (Q_dec (cross (along e) n) 0) as [[right_ | same_] | along_];
      [| | exfalso; exact (transversal e w u E on_e no_vertex in_q x_is along_)].
    2: { exists 1. split; [lra |]. intros t _ _ _. now exists e, w, u. }
    exists 1. split; [lra |]. intros t t0 _ (w' & u' & on_e' & on_f' & [X' Y']). exfalso. apply outside.
    set (g := minus u' u).
    assert (side : 0 < cross (along e) (opposite g)).
    { pose proof (meeting_of_segments.on_the_line w e on_e) as at_w.
      pose proof (meeting_of_segments.on_the_line w' e on_e') as at_w'. destruct x_is as [X Y].
      assert (value : cross (along e) (opposite g) == - (t * cross (along e) n) + area e w' - area e w)
        by (unfold g, plus in *; in_coordinates; by_equations).
      rewrite value, at_w, at_w'. nra. }
    destruct (some_small _ (eventually_and _ _
      (left_of_an_edge_is_inside p e w (opposite g) valid meet E on_e no_vertex side) (eventually_below 1 ltac:(lra))))
      as (h & _ & in_p & h0 & h1).
    refine (inner_point_and_point p q x _ (moved_along u g h) q_regular in_p _ _).
    - right. exists f. split; [exact F |].
      destruct on_f as (k & k_range & ux & uy), on_f' as (l & l_range & ux' & uy').
      exists ((1 - h) * k + h * l). split.
      + split; nra.
      + unfold moved_along, g, minus; cbn [vx vy]. rewrite ux, uy, ux', uy'. split; ring.
    - destruct x_is as [X Y]. unfold plus, moved_along, opposite in *; cbn [vx vy] in *.
      split; cbn [vx vy]; [rewrite X | rewrite Y]; ring.
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
  Proof. intros [X Y]. unfold plus in *; cbn [vx vy] in *. split; cbn [vx vy]; lra. Qed.
  Let no_vertices' : forall w u, is_vertex w q -> is_vertex u p -> ~ equal_vectors x (plus w u).
  Proof. intros w u of_q of_p equal. exact (no_vertices u w of_p of_q (other_order _ _ equal)). Qed.

  Let none_meet : forall w u, is_vertex w p -> is_vertex u q -> equal_vectors x (plus w u) -> alone w p /\ alone u q.
  Proof. intros w u of_p of_q equal. now destruct (no_vertices w u of_p of_q). Qed.

    Lemma parallelogram_beside (e f : segment) : In e (region_edges p) -> In f (region_edges q) ->
      eventually (fun t => winding_number (moved_along x n t) (parallelogram e f) <> 0%Z ->
        touches x n p q \/ touches x n q p).
    Proof.
      intros E F.
      assert (counted : forall y, winding_number y (parallelogram e f) <> 0%Z ->
        is_sum_of_points y e f /\ ~ cross (along e) (along f) == 0).
      { intros y some. destruct (parallelogram_winding_number y e f) as [none | [sign is_sum]]; [contradiction |].
        split; [exact is_sum |]. destruct sign as [[_ sign] | [_ sign]]; lra. }
      assert (source_f : is_vertex (source f) q) by (exists f; split; [exact F | split; reflexivity]).
      assert (source_e : is_vertex (source e) p) by (exists e; split; [exact E | split; reflexivity]).
      pose proof (target_is_vertex q f F) as target_f. pose proof (target_is_vertex p e E) as target_e.
      assert (by_f : forall w u, lies_on w e -> lies_on u f -> is_vertex u q -> equal_vectors x (plus w u) ->
        eventually (fun t => winding_number (moved_along x n t) (parallelogram e f) <> 0%Z ->
          touches x n p q \/ touches x n q p)).
      { intros w u on_e on_f vertex x_is.
        refine (eventually_implied _ _ _ (edges_beside p q x n p_region q_region outside transversal
          no_vertices e f w u E F on_e on_f vertex x_is)).
        intros t one some. left. apply one. now apply counted. }
      assert (by_e : forall w u, lies_on w e -> lies_on u f -> is_vertex w p -> equal_vectors x (plus w u) ->
        eventually (fun t => winding_number (moved_along x n t) (parallelogram e f) <> 0%Z ->
          touches x n p q \/ touches x n q p)).
      { intros w u on_e on_f vertex x_is.
        refine (eventually_implied _ _ _ (edges_beside q p x n q_region p_region outside' transversal'
          no_vertices' f e u w F E on_f on_e vertex (other_order _ _ x_is))).
        intros t one some. right. apply one. destruct (counted _ some) as [(a & b & on_a & on_b & [X Y]) _].
        exists b, a. split; [exact on_b |]. split; [exact on_a |].
        unfold plus in *; cbn [vx vy] in *. split; cbn [vx vy]; lra. }
      set (part := fun (s : segment) (k : Q) => Vector ((1 - k) * vx (source s) + k * vx (target s))
                                                       ((1 - k) * vy (source s) + k * vy (target s))).
      assert (part_on : forall s k, 0 <= k <= 1 -> lies_on (part s k) s)
        by (intros s k range; exists k; split; [exact range |]; split; reflexivity).
      destruct (on_or_off x (parallelogram e f)) as [(side & S & (k & range & X & Y)) | free].
      - unfold parallelogram in S. cbn in S.
        destruct S as [<- | [<- | [<- | [<- | []]]]]; unfold plus in X, Y; cbn [source target vx vy] in X, Y.
        + apply (by_f (part e k) (source f)); [now apply part_on | apply source_lies_on | exact source_f |].
          unfold plus, part; split; cbn [vx vy]; [rewrite X | rewrite Y]; ring.
        + apply (by_e (target e) (part f k)); [apply target_lies_on | now apply part_on | exact target_e |].
          unfold plus, part; split; cbn [vx vy]; [rewrite X | rewrite Y]; ring.
        + apply (by_f (part e (1 - k)) (target f)); [apply part_on; lra | apply target_lies_on | exact target_f |].
          unfold plus, part; split; cbn [vx vy]; [rewrite X | rewrite Y]; ring.
        + apply (by_e (source e) (part f (1 - k))); [apply source_lies_on | apply part_on; lra | exact source_e |].
          unfold plus, part; split; cbn [vx vy]; [rewrite X | rewrite Y]; ring.
      - destruct (Z.eq_dec (winding_number x (parallelogram e f)) 0) as [none | some].
        + assert (closed_ : cycles (parallelogram e f)).
          { pose proof (region_cycles [[plus (source e) (source f); plus (target e) (source f);
              plus (target e) (target f); plus (source e) (target f)]]) as closed_.
            unfold region_edges in closed_. cbn [flat_map] in closed_. rewrite app_nil_r in closed_. exact closed_. }
          destruct (winding_number_near x _ closed_ free) as (radius & R & near).
          refine (eventually_implied _ _ _ (small_steps_stay_within radius x n R)).
          intros t close some. exfalso. destruct (near _ close) as [_ equal]. lia.
        + destruct (counted x some) as [(w & u & on_e & on_f & x_is) turn].
          destruct (vertex_or_not w p) as [w_vertex | w_free]; [now apply (by_e w u) |].
          destruct (vertex_or_not u q) as [u_vertex | u_free]; [now apply (by_f w u) |].
          exfalso. apply outside. now apply (transversal_edges_meet p q x w u e f).
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
      assert (of_both : eventually (fun t => forall e, In e (region_edges p) -> forall f, In f (region_edges q) ->
        winding_number (moved_along x n t) (parallelogram e f) <> 0%Z -> touches x n p q \/ touches x n q p))
        by (apply (eventually_for_all (fun e t => forall f, In f (region_edges q) ->
              winding_number (moved_along x n t) (parallelogram e f) <> 0%Z -> touches x n p q \/ touches x n q p));
            intros e E;
            apply (eventually_for_all (fun f t =>
              winding_number (moved_along x n t) (parallelogram e f) <> 0%Z -> touches x n p q \/ touches x n q p));
            intros f F; now apply parallelogram_beside).
      destruct (some_small _ (eventually_and _ _ meet_ (eventually_and _ _ of_p (eventually_and _ _ of_q of_both))))
        as (t & _ & meets & by_p & by_q & by_both).
      set (y := moved_along x n t) in *.
      pose proof (interiors_meet_means_positive_winding_number p q y p_edges q_edges p_valid q_valid meets) as positive_.
      assert (proper_d : nonzero (Vector 1 0)) by (unfold nonzero; cbn; lra).
      destruct (a_term_is_positive p q (Vector 1 0) y p_edges q_edges p_valid q_valid proper_d positive_)
        as [(v & I & _ & inside_q) | [(v & I & _ & inside_p) | (e & f & E & F & _ & some & _)]].
      - right. exact (by_p v I inside_q).
      - left. exact (by_q v I inside_p).
      - exact (by_both e E f F some).
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
       (f & u & w & F & on_f & no_vertex & vertex & x_is & left_)].
    - destruct (vertex_in_region u q vertex) as (f & F & on_f).
      assert (in_q : in_region u q) by (right; now exists f).
      exists (along e). split; [| split; [exact left_ | exists e, w, u; tauto]].
      now apply (passing_edges_of_p_are_covered p q x p_region q_region outside none_meet w u e).
    - destruct (vertex_in_region w p vertex) as (e & E & on_e).
      assert (in_p : in_region w p) by (right; now exists e).
      exists (along f). split; [| split; [exact left_ | exists f, u, w; tauto]].
      now apply (passing_edges_of_q_are_covered p q x p_region q_region outside none_meet u w f).
  Qed.
End BothSides.
