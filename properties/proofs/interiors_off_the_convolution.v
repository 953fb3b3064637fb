(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Theorem 4.2.1 on interiors, for every x off the convolution: also where x is on the vertex-edge sum, which
   theorem_4_2_1.v leaves open. There a point of P's boundary is a point of that of -Q + x. Both have a wedge that is
   inside (wedge_is_inside.v), and since no segment of the convolution passes x the wedges overlap (wedges.v). *)
From Coq Require Import QArith Qminmax Lqa ZArith Lia Bool List Arith.
From Oplus Require Import direction angle cyclic_order sweep winding_number tie_rule turning_number convolution_size
  fiber_grid states in_out_degree convolution_winding tangent_set regions weight meeting_of_segments interiors_meet
  winding_number_of_the_sum neighbourhoods left_of_an_edge theorem_4_2_1 wedges wedge_is_inside.
Import ListNotations.

Open Scope Q_scope.

(* Chains do not touch, turn back nowhere, and have no vertex inside a straight line. *)
Definition vertices_are_proper (r : region) : Prop :=
  vertices_are_apart r /\
  forall v c, In (v, c) (region_vertices r) ->
    turns (incoming c) (outgoing c) /\ ~ angle (incoming c) == angle (outgoing c).

(* The edges at a point of the boundary: those of a vertex, or one edge twice. *)
Definition corner_at (a : vector) (c : corner) (r : region) : Prop :=
  (exists v, equal_vectors v a /\ In (v, c) (region_vertices r)) \/
  (~ is_vertex a r /\ exists s, In s (region_edges r) /\ lies_on a s /\ c = Corner (along s) (along s)).

Lemma is_vertex_dec (a : vector) (r : region) : is_vertex a r \/ ~ is_vertex a r.
Proof.
  unfold is_vertex. induction (region_edges r) as [| s l IH]; [right; intros (s & [] & _) |].
  destruct (Qeq_dec (vx a) (vx (source s))) as [X | X], (Qeq_dec (vy a) (vy (source s))) as [Y | Y].
  { left. exists s. split; [now left | now split]. }
  all: destruct IH as [(t & I & equal) | none];
    [left; exists t; split; [now right | exact equal] |
     right; intros (t & [<- | I] & equal); [now destruct equal | apply none; now exists t]].
Qed.

Lemma vertex_has_corner (s : segment) (r : region) :
  In s (region_edges r) -> exists c, In (source s, c) (region_vertices r).
Proof.
  intros I. apply in_flat_map in I. destruct I as (chain & J & I).
  apply (In_nth _ _ no_segment) in I. destruct I as (i & below & <-). rewrite edges_are_as_many in below.
  exists (corner_of_chain chain i). rewrite edge_by_index by exact below. now apply vertex_of_region.
Qed.

Lemma boundary_has_corners (a : vector) (s : segment) (r : region) :
  In s (region_edges r) -> lies_on a s -> exists c, corner_at a c r.
Proof.
  intros I on. destruct (is_vertex_dec a r) as [(t & J & [X Y]) | no_vertex].
  - destruct (vertex_has_corner t r J) as (c & K). exists c. left. exists (source t). split; [| exact K].
    split; now symmetry.
  - exists (Corner (along s) (along s)). right. split; [exact no_vertex |]. now exists s.
Qed.

Lemma turns_straight (u : vector) : nonzero u -> turns u u.
Proof.
  intros proper_u. split; [exact proper_u |]. split; [exact proper_u |]. intros _.
  exact (rotation.square_positive u proper_u).
Qed.

Lemma corner_turns (a : vector) (c : corner) (r : region) :
  valid_region r -> vertices_are_proper r -> corner_at a c r -> turns (incoming c) (outgoing c).
Proof.
  intros (not_points & _) (_ & proper_) [(v & _ & I) | (_ & s & I & _ & ->)].
  - now apply (proper_ v c I).
  - apply turns_straight. now apply (region_edges_are_directions r).
Qed.

(* The edges of a corner pass the point. *)
Lemma edges_of_corner (a : vector) (c : corner) (r : region) :
  corner_at a c r ->
  (exists s, In s (region_edges r) /\ lies_on a s /\ along s = incoming c) /\
  (exists s, In s (region_edges r) /\ lies_on a s /\ along s = outgoing c).
Proof.
  intros [(v & [X Y] & I) | (_ & s & I & on & ->)].
  - destruct (edges_of_vertex v c r I) as [(s & J & is_target & is_in) (t & K & is_source & is_out)]. split.
    + exists s. split; [exact J |]. split; [| exact is_in]. exists 1. rewrite is_target. repeat split; lra.
    + exists t. split; [exact K |]. split; [| exact is_out]. exists 0. rewrite is_source. repeat split; lra.
  - split; exists s; now repeat split.
Qed.

Lemma inside_along_wedge (a u : vector) (c : corner) (r : region) :
  valid_region r -> vertices_are_proper r -> corner_at a c r -> nonzero u -> in_wedge u c = true ->
  eventually (fun e => inside (moved_along a u e) r).
Proof.
  intros r_region r_proper at_a proper_u met. pose proof (corner_turns a c r r_region r_proper at_a) as turning.
  destruct r_region as (not_points & valid & meet), r_proper as (apart_ & _).
  destruct at_a as [(v & [X Y] & I) | (no_vertex & s & I & on & ->)].
  - refine (eventually_implied _ _ _ (wedge_is_inside r v u c valid meet apart_ I turning proper_u met)).
    intros e. apply inside_equal. split; unfold moved_along; cbn [vx vy]; [now rewrite X | now rewrite Y].
  - apply (left_of_an_edge_is_inside r s); trivial.
    pose proof (wedge_by_sides u _ proper_u turning met) as sides. cbn [incoming outgoing] in sides.
    assert (cross (along s) (along s) == 0) by (unfold cross; ring). lra.
Qed.

(* The sum of a point of an edge and a vertex is on the convolution if the tangent set says so. *)
Lemma on_the_convolution_by_p (p q : region) (x a v : vector) (e : segment) (c : corner) :
  In e (region_edges p) -> lies_on a e -> In (v, c) (region_vertices q) -> equal_vectors x (plus a v) ->
  in_tangent_set (Direction (along e) OfP) c = true -> off x (convolution_segments p q) -> False.
Proof.
  intros I on J [X Y] tangent free.
  apply in_flat_map in I. destruct I as (chain & K & I).
  apply (In_nth _ _ no_segment) in I. destruct I as (i & below & e_is). rewrite edges_are_as_many in below.
  apply in_flat_map in J. destruct J as (chain' & K' & J).
  apply (In_nth _ _ (nowhere, Corner nowhere nowhere)) in J. destruct J as (j & below' & at_j).
  rewrite combine_length, corners_length in below'. assert (range : (j < length chain')%nat) by lia.
  rewrite combine_nth in at_j by (symmetry; apply corners_length). injection at_j as v_is c_is.
  set (s := ((chain, chain'), (OfP, (i, j))) : (list vector * list vector) * named_segment).
  apply (free (Segment (starts_at s) (ends_at s))).
  - apply in_map_iff. exists s. split; [reflexivity |]. apply in_flat_map. exists (chain, chain').
    split; [now apply in_prod |]. apply in_map_iff. exists (OfP, (i, j)). split; [reflexivity |].
    apply filter_In. split; [now apply (in_all_segments (length chain) (length chain') (OfP, (i, j))) |].
    cbn [fst snd is_convolution_segment]. rewrite direction_by_index by exact below. rewrite e_is.
    change (corner_of_chain chain' j = c) in c_is. now rewrite c_is.
  - rewrite edge_by_index in e_is by exact below. rewrite <- e_is in on. destruct on as (k & range_k & ax & ay).
    exists k. split; [exact range_k |]. cbn [source target] in *. unfold s, starts_at, ends_at, point_of, state_after, step.
    cbn [fst snd state_before plus vx vy]. rewrite v_is. unfold plus in X, Y. cbn [vx vy] in *. split; lra.
Qed.

Lemma on_the_convolution_by_q (p q : region) (x b v : vector) (f : segment) (c : corner) :
  In f (region_edges q) -> lies_on b f -> In (v, c) (region_vertices p) -> equal_vectors x (plus v b) ->
  in_tangent_set (Direction (along f) OfQ) c = true -> off x (convolution_segments p q) -> False.
Proof.
  intros I on J [X Y] tangent free.
  apply in_flat_map in I. destruct I as (chain & K & I).
  apply (In_nth _ _ no_segment) in I. destruct I as (j & below & f_is). rewrite edges_are_as_many in below.
  apply in_flat_map in J. destruct J as (chain' & K' & J).
  apply (In_nth _ _ (nowhere, Corner nowhere nowhere)) in J. destruct J as (i & below' & at_i).
  rewrite combine_length, corners_length in below'. assert (range : (i < length chain')%nat) by lia.
  rewrite combine_nth in at_i by (symmetry; apply corners_length). injection at_i as v_is c_is.
  set (s := ((chain', chain), (OfQ, (i, j))) : (list vector * list vector) * named_segment).
  apply (free (Segment (starts_at s) (ends_at s))).
  - apply in_map_iff. exists s. split; [reflexivity |]. apply in_flat_map. exists (chain', chain).
    split; [now apply in_prod |]. apply in_map_iff. exists (OfQ, (i, j)). split; [reflexivity |].
    apply filter_In. split; [now apply (in_all_segments (length chain') (length chain) (OfQ, (i, j))) |].
    cbn [fst snd is_convolution_segment]. rewrite direction_by_index by exact below. rewrite f_is.
    change (corner_of_chain chain' i = c) in c_is. now rewrite c_is.
  - rewrite edge_by_index in f_is by exact below. rewrite <- f_is in on. destruct on as (k & range_k & bx & by_).
    exists k. split; [exact range_k |]. cbn [source target] in *. unfold s, starts_at, ends_at, point_of, state_after, step.
    cbn [fst snd state_before plus vx vy]. rewrite v_is. unfold plus in X, Y. cbn [vx vy] in *. split; lra.
Qed.

Lemma tangent_to_outgoing (e : vector) (c : corner) :
  nonzero e -> nonzero (incoming c) -> nonzero (outgoing c) ->
  angle e == angle (outgoing c) -> ~ angle (incoming c) == angle (outgoing c) ->
  in_tangent_set (Direction e OfP) c = true.
Proof.
  intros proper_e proper_in proper_out equal bend. unfold in_tangent_set. cbn [of other].
  destruct (ccw_spec (Direction e OfP) (Direction (incoming c) OfQ) (Direction (outgoing c) OfQ)
    proper_e proper_in proper_out) as [met | not_met]; [reflexivity | exfalso].
  apply not_met. unfold in_order, earlier, place. cbn [vec of]. clear not_met. lra.
Qed.

Lemma tangent_to_incoming (f : vector) (c : corner) :
  nonzero f -> nonzero (incoming c) -> nonzero (outgoing c) ->
  angle f == angle (incoming c) -> ~ angle (incoming c) == angle (outgoing c) ->
  in_tangent_set (Direction f OfQ) c = true.
Proof.
  intros proper_f proper_in proper_out equal bend. unfold in_tangent_set. cbn [of other].
  destruct (ccw_spec (Direction f OfQ) (Direction (incoming c) OfP) (Direction (outgoing c) OfP)
    proper_f proper_in proper_out) as [met | not_met]; [reflexivity | exfalso].
  apply not_met. unfold in_order, earlier, place. cbn [vec of]. clear not_met. lra.
Qed.

Section OffTheConvolution.
  Variables p q : region.
  Variables x a b : vector.
  Hypothesis p_region : valid_region p.
  Hypothesis q_region : valid_region q.
  Hypothesis p_proper : vertices_are_proper p.
  Hypothesis q_proper : vertices_are_proper q.
  Hypothesis free : off x (convolution_segments p q).
  Hypothesis is_sum : equal_vectors x (plus a b).

  (* No two edges of the same direction have x as a sum: sliding along both leads to a vertex. *)
  Lemma no_equal_directions (e f : segment) :
    In e (region_edges p) -> In f (region_edges q) -> lies_on a e -> lies_on b f ->
    ~ angle (along e) == angle (along f).
  Proof.
    intros E F (s & [s0 s1] & ax & ay) (t & [t0 t1] & bx & by_) equal. destruct is_sum as [X Y].
    pose proof (region_edges_are_directions p (proj1 p_region) e E) as proper_e.
    pose proof (region_edges_are_directions q (proj1 q_region) f F) as proper_f.
    destruct (proj2 (same_direction_angle (along f) (along e) proper_f proper_e) (Qeq_sym _ _ equal))
      as (l & L & lx & ly).
    unfold along, minus in lx, ly. cbn [vx vy] in lx, ly. unfold plus in X, Y. cbn [vx vy] in X, Y.
    destruct (Qlt_le_dec (1 - s) (t * l)) as [end_first | start_first].
    - (* the end of e *)
      destruct (target_is_vertex p e E) as (e' & E' & tx & ty).
      destruct (vertex_has_corner e' p E') as (c & I).
      destruct p_proper as [apart_ proper_]. destruct (proper_ _ _ I) as [(proper_in & proper_out & _) bend].
      assert (through : lies_on (source e') e) by (exists 1; repeat split; lra).
      destruct (apart_ _ _ e I E through) as [[_ is_in] | [[sx sy] _]].
      + set (k := (1 - s) / l).
        assert (k_is : k * l == 1 - s) by (unfold k; field; lra). clearbody k.
        assert (range : 0 <= t - k <= 1) by (split; nra).
        apply (on_the_convolution_by_q p q x
          (Vector (vx (source f) + (t - k) * (vx (target f) - vx (source f)))
                  (vy (source f) + (t - k) * (vy (target f) - vy (source f)))) (source e') f c); trivial.
        * exists (t - k). split; [exact range |]. cbn [vx vy]. split; ring.
        * unfold plus. split; cbn [vx vy]; [rewrite X, ax, bx, <- tx | rewrite Y, ay, by_, <- ty].
          -- assert (k * (vx (target f) - vx (source f)) == (1 - s) * (vx (target e) - vx (source e)))
               by (rewrite lx, <- k_is; ring). lra.
          -- assert (k * (vy (target f) - vy (source f)) == (1 - s) * (vy (target e) - vy (source e)))
               by (rewrite ly, <- k_is; ring). lra.
        * apply tangent_to_incoming; trivial. rewrite <- is_in. now symmetry.
      + exfalso. apply proper_e. unfold along, minus. cbn [vx vy]. split; lra.
    - (* the start of f *)
      destruct (vertex_has_corner f q F) as (c & I).
      destruct q_proper as [apart_ proper_]. destruct (proper_ _ _ I) as [(proper_in & proper_out & _) bend].
      assert (through : lies_on (source f) f) by apply source_lies_on.
      destruct (apart_ _ _ f I F through) as [[[tx ty] _] | [_ is_out]].
      + exfalso. apply proper_f. unfold along, minus. cbn [vx vy]. split; lra.
      + assert (range : 0 <= s + t * l <= 1) by (split; nra).
        apply (on_the_convolution_by_p p q x
          (Vector (vx (source e) + (s + t * l) * (vx (target e) - vx (source e)))
                  (vy (source e) + (s + t * l) * (vy (target e) - vy (source e)))) (source f) e c); trivial.
        * exists (s + t * l). split; [exact range |]. cbn [vx vy]. split; ring.
        * unfold plus. split; cbn [vx vy]; [rewrite X, ax, bx | rewrite Y, ay, by_].
          -- assert (t * (vx (target f) - vx (source f)) == t * l * (vx (target e) - vx (source e)))
               by (rewrite lx; ring). lra.
          -- assert (t * (vy (target f) - vy (source f)) == t * l * (vy (target e) - vy (source e)))
               by (rewrite ly; ring). lra.
        * apply tangent_to_outgoing; trivial. now rewrite <- is_out.
  Qed.

  Lemma straight_has_no_tangents (d : direction) (u : vector) :
    proper d -> nonzero u -> in_tangent_set d (Corner u u) = false.
  Proof.
    intros proper_d proper_u. unfold in_tangent_set. cbn [incoming outgoing].
    destruct (ccw_spec d (Direction u (other (of d))) (Direction u (other (of d))) proper_d proper_u proper_u)
      as [met |]; [exfalso; unfold in_order in met; order | reflexivity].
  Qed.

  (* Where the boundaries of P and -Q + x have a common point, their interiors have one near it. *)
  Lemma boundaries_in_common (c d : corner) :
    corner_at a c p -> corner_at b d q -> interiors_meet x p q.
  Proof.
    intros at_a at_b.
    pose proof (corner_turns a c p p_region p_proper at_a) as turn_p.
    pose proof (corner_turns b d q q_region q_proper at_b) as turn_q.
    destruct (edges_of_corner a c p at_a) as [(e & E & on_e & e_is) (e' & E' & on_e' & e'_is)].
    destruct (edges_of_corner b d q at_b) as [(f & F & on_f & f_is) (f' & F' & on_f' & f'_is)].
    assert (by_q : forall g, In g (region_edges q) -> lies_on b g ->
      in_tangent_set (Direction (along g) OfQ) c = false).
    { intros g G on_g. pose proof (region_edges_are_directions q (proj1 q_region) g G) as proper_g.
      destruct at_a as [(v & [vx_is vy_is] & I) | (_ & s & I & _ & ->)].
      - destruct (in_tangent_set (Direction (along g) OfQ) c) eqn:tangent; [exfalso | reflexivity].
        apply (on_the_convolution_by_q p q x b v g c); trivial.
        destruct is_sum as [X Y]. unfold plus in *. cbn [vx vy] in *. split; cbn [vx vy]; lra.
      - apply straight_has_no_tangents; [exact proper_g |]. now apply (region_edges_are_directions p (proj1 p_region)). }
    assert (by_p : in_tangent_set (Direction (along e) OfP) d = false).
    { pose proof (region_edges_are_directions p (proj1 p_region) e E) as proper_e.
      destruct at_b as [(v & [vx_is vy_is] & I) | (_ & s & I & _ & ->)].
      - destruct (in_tangent_set (Direction (along e) OfP) d) eqn:tangent; [exfalso | reflexivity].
        apply (on_the_convolution_by_p p q x a v e d); trivial.
        destruct is_sum as [X Y]. unfold plus in *. cbn [vx vy] in *. split; cbn [vx vy]; lra.
      - apply straight_has_no_tangents; [exact proper_e |]. now apply (region_edges_are_directions q (proj1 q_region)). }
    destruct (wedges_overlap c d turn_p turn_q) as (u & proper_u & in_p & in_q).
    - rewrite <- e_is, <- f_is. now apply no_equal_directions.
    - rewrite <- e_is, <- f'_is. now apply no_equal_directions.
    - rewrite <- e'_is, <- f_is. now apply no_equal_directions.
    - rewrite <- e'_is, <- f'_is. now apply no_equal_directions.
    - rewrite <- e_is. exact by_p.
    - rewrite <- f_is. now apply by_q.
    - rewrite <- f'_is. now apply by_q.
    - destruct (eventually_and _ _ (inside_along_wedge a u c p p_region p_proper at_a proper_u in_p)
        (inside_along_wedge b (opposite u) d q q_region q_proper at_b (opposite_nonzero u proper_u) in_q))
        as (limit & L & near).
      destruct (near ((1 # 2) * limit)) as [inside_p inside_q]; [lra | lra |].
      exists (moved_along a u ((1 # 2) * limit)). split; [exact inside_p |]. refine (inside_equal _ _ _ _ inside_q).
      destruct is_sum as [X Y]. unfold plus, minus, moved_along, opposite in *. split; cbn [vx vy] in *; lra.
  Qed.
End OffTheConvolution.

(* A point of P's boundary and an inner point of Q have inner points of both near them. *)
Lemma boundary_and_inside (p q : region) (x a b : vector) (s : segment) :
  valid_region p -> In s (region_edges p) -> lies_on a s -> inside b q -> equal_vectors x (plus a b) ->
  exists z, inside z p /\ inside (minus x z) q.
Proof.
  intros (p_edges & p_valid & p_meet) I on [free positive_] [X Y].
  destruct (winding_number_near b _ (region_cycles q) free) as (radius & R & near).
  destruct (regions_are_regular p p_edges p_valid p_meet a s radius I on R) as (z & close & in_p).
  exists z. split; [exact in_p |]. destruct (near (minus x z)) as [off_z same_number].
  - unfold within, minus, plus in *. cbn [vx vy] in *. lra.
  - split; [exact off_z | lia].
Qed.

Lemma in_region_cases (a : vector) (r : region) :
  in_region a r -> inside a r \/ exists s, In s (region_edges r) /\ lies_on a s.
Proof.
  intros [positive_ | on]; [| now right]. destruct (on_or_off a (region_edges r)) as [on | free]; [now right |].
  left. now split.
Qed.

(* Theorem. Off the convolution, every point of the sum is the sum of an inner point of P and one of Q. *)
Theorem off_the_convolution_interiors_meet (p q : region) (x : vector) :
  valid_region p -> valid_region q -> vertices_are_proper p -> vertices_are_proper q ->
  off x (convolution_segments p q) -> in_sum x p q -> interiors_meet x p q.
Proof.
  intros p_region q_region p_proper q_proper free (a & b & in_p & in_q & is_sum).
  destruct (in_region_cases a p in_p) as [inside_p | (s & I & on_a)],
    (in_region_cases b q in_q) as [inside_q | (t & J & on_b)].
  - exists a. split; [exact inside_p |]. refine (inside_equal _ _ _ _ inside_q).
    destruct is_sum as [X Y]. unfold plus, minus in *. split; cbn [vx vy] in *; lra.
  - destruct (boundary_and_inside q p x b a t q_region J on_b inside_p) as (z & z_q & z_p).
    { destruct is_sum as [X Y]. unfold plus in *. split; cbn [vx vy] in *; lra. }
    exists (minus x z). split; [exact z_p |]. refine (inside_equal _ _ _ _ z_q).
    unfold minus. split; cbn [vx vy]; ring.
  - exact (boundary_and_inside p q x a b s p_region I on_a inside_q is_sum).
  - destruct (boundary_has_corners a s p I on_a) as (c & at_a).
    destruct (boundary_has_corners b t q J on_b) as (d & at_b).
    exact (boundaries_in_common p q x a b p_region q_region p_proper q_proper free is_sum c d at_a at_b).
Qed.

(* Theorem 4.2.1. For every x off the convolution, the interiors of P and -Q + x have a point in common if and only
   if the winding number of x is positive. It is never negative. *)
Theorem positive_off_the_convolution_iff_interiors_meet (p q : region) (x : vector) :
  valid_region p -> valid_region q -> vertices_are_proper p -> vertices_are_proper q ->
  off x (convolution_segments p q) ->
  (0 <= winding_number x (convolution_segments p q))%Z /\
  ((0 < winding_number x (convolution_segments p q))%Z <-> interiors_meet x p q).
Proof.
  intros p_region q_region p_proper q_proper free.
  pose proof p_region as (p_edges & p_valid & _). pose proof q_region as (q_edges & q_valid & _). split.
  - now apply convolution_is_nowhere_negative.
  - split; [| now apply interiors_meet_means_positive_winding_number].
    intros positive_. apply off_the_convolution_interiors_meet; trivial.
    now apply positive_winding_number_is_in_the_sum.
Qed.
