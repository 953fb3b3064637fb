(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The convolution by Definition 2.2.8, all sums of a point of P's boundary and one of Q's whose tangent sets
   have a direction in common, has the same points as by Definition 2.2.7, edges at vertices whose tangent
   set contains the edge's direction by the tie rule. Tangent sets in 2.2.8 do not contain their ends, and
   ties are not told apart. The segments by Definition 2.2.7 are in convolution_size.v, what rotating
   means in rotation.v, that edges do not all have one direction in sizes_of_cycles.v. *)
From Coq Require Import PeanoNat Lia Bool List.
From Oplus Require Import numbers convolution rotation tracing sizes_of_cycles secants segments_apart simple_chain
  tangent_direction.
Import ListNotations.

Open Scope Q_scope.

(* The tangent set of a vertex, without ties: the directions met strictly between the edges, turning
   counterclockwise; inside a straight line, the line's direction. *)
Definition touches_corner (c : corner) (d : vector) : Prop :=
  ccw_of_vectors d (incoming c) (outgoing c) = true \/
  (same_direction (incoming c) (outgoing c) /\ same_direction d (incoming c)).

(* The point a part t of the way along edge i. *)
Definition point_along (chain : list vector) (i : nat) (t : Q) : vector :=
  Vector (vx (vertex chain i) + t * vx (edge_of_chain chain i))
         (vy (vertex chain i) + t * vy (edge_of_chain chain i)).

(* a is on the boundary, and d in the tangent set it has there: that of a vertex, or, inside an edge, the
   edge's direction. *)
Definition tangent_at (chain : list vector) (a d : vector) : Prop :=
  exists i, (i < length chain)%nat /\
    ((equal_vectors a (vertex chain i) /\ touches_corner (corner_of_chain chain i) d) \/
     (exists t, 0 < t /\ t < 1 /\ equal_vectors a (point_along chain i t) /\
                same_direction d (edge_of_chain chain i))).

Definition in_convolution_by_2_2_8 (p q : region) (x : vector) : Prop :=
  exists chain_p chain_q a b d, In chain_p p /\ In chain_q q /\ nonzero d /\
    tangent_at chain_p a d /\ tangent_at chain_q b d /\ equal_vectors x (plus a b).

Definition in_convolution_by_2_2_7 (p q : region) (x : vector) : Prop :=
  exists s, In s (segments_of_regions p q) /\ lies_on x (Segment (starts_at s) (ends_at s)).

(* What ccw says of three directions, by their angles. *)
Ltac by_angles o :=
  unfold in_order, earlier, place in o; cbn [vec of] in o; split; intros; trivial; try discriminate;
    (lra || (exfalso; apply o; lra)).

(* Angles met in this order, going round. *)
Definition met (a b c : Q) : Prop := (a < b /\ b < c) \/ (b < c /\ c < a) \/ (c < a /\ a < b).

Lemma ccw_by_angles (d u v : vector) :
  nonzero d -> nonzero u -> nonzero v ->
  ccw_of_vectors d u v = true <-> met (angle u) (angle d) (angle v).
Proof.
  intros nd nu nv. unfold ccw_of_vectors, met.
  destruct (ccw_spec (Direction d OfP) (Direction u OfP) (Direction v OfP) nd nu nv) as [o | o]; by_angles o.
Qed.

(* The tie rule: an edge of P is also at a vertex of Q whose outgoing edge has its direction, an edge of Q at a
   vertex of P whose incoming edge has it. *)
Lemma edge_of_p_by_angles (e u v : vector) :
  nonzero e -> nonzero u -> nonzero v ->
  in_tangent_set (Direction e OfP) (Corner u v) = true <->
  met (angle u) (angle e) (angle v) \/ (angle e == angle v /\ ~ angle u == angle v).
Proof.
  intros ne nu nv. unfold in_tangent_set, met. cbn [incoming outgoing of other].
  destruct (ccw_spec (Direction e OfP) (Direction u OfQ) (Direction v OfQ) ne nu nv) as [o | o]; by_angles o.
Qed.

Lemma edge_of_q_by_angles (f u v : vector) :
  nonzero f -> nonzero u -> nonzero v ->
  in_tangent_set (Direction f OfQ) (Corner u v) = true <->
  met (angle u) (angle f) (angle v) \/ (angle f == angle u /\ ~ angle u == angle v).
Proof.
  intros nf nu nv. unfold in_tangent_set, met. cbn [incoming outgoing of other].
  destruct (ccw_spec (Direction f OfQ) (Direction u OfP) (Direction v OfP) nf nu nv) as [o | o]; by_angles o.
Qed.

Lemma direction_between (a b : Q) :
  0 <= a < 4 -> 0 <= b < 4 -> ~ a == b -> exists d, nonzero d /\ met a (angle d) b.
Proof.
  intros range_a range_b differ.
  assert (at_angle : forall t, 0 <= t < 4 -> exists d, nonzero d /\ angle d == t).
  { intros t range. exists (diamond t). split; [now apply diamond_nonzero |].
    apply (angle_diamond (diamond t) t 1); trivial; lra. }
  unfold met. destruct (Qlt_le_dec a b).
  - destruct (at_angle ((1 # 2) * (a + b))) as (d & nd & d_is); [lra |].
    exists d. split; [exact nd | lra].
  - destruct (at_angle ((1 # 2) * (a + 4))) as (d & nd & d_is); [lra |].
    exists d. split; [exact nd | lra].
Qed.

(* A direction a little before e, and one a little after. *)
Lemma just_before (e u v : vector) :
  nonzero e -> nonzero u -> nonzero v -> ~ angle u == angle e -> ~ angle v == angle e ->
  exists d, nonzero d /\ met (angle u) (angle d) (angle e) /\ met (angle v) (angle d) (angle e).
Proof.
  intros ne nu nv u_off v_off.
  pose proof (angle_range e ne). pose proof (angle_range u nu). pose proof (angle_range v nv).
  assert (met (angle u) (angle v) (angle e) \/ met (angle v) (angle u) (angle e) \/ angle u == angle v)
    as [later_v | later_u] by (unfold met; lra).
  - destruct (direction_between (angle v) (angle e)) as (d & nd & between); trivial.
    exists d. unfold met in *. split; [exact nd | lra].
  - destruct (direction_between (angle u) (angle e)) as (d & nd & between); trivial.
    exists d. unfold met in *. split; [exact nd | lra].
Qed.

Lemma just_after (e u v : vector) :
  nonzero e -> nonzero u -> nonzero v -> ~ angle u == angle e -> ~ angle v == angle e ->
  exists d, nonzero d /\ met (angle e) (angle d) (angle u) /\ met (angle e) (angle d) (angle v).
Proof.
  intros ne nu nv u_off v_off.
  pose proof (angle_range e ne). pose proof (angle_range u nu). pose proof (angle_range v nv).
  assert (met (angle e) (angle v) (angle u) \/ met (angle e) (angle u) (angle v) \/ angle u == angle v)
    as [sooner_v | sooner_u] by (unfold met; lra).
  - destruct (direction_between (angle e) (angle v)) as (d & nd & between); trivial; [lra |].
    exists d. unfold met in *. split; [exact nd | lra].
  - destruct (direction_between (angle e) (angle u)) as (d & nd & between); trivial; [lra |].
    exists d. unfold met in *. split; [exact nd | lra].
Qed.

(* Two arcs that have a direction in common: one begins inside the other, or both begin together. *)
Lemma arcs_in_common (d u v u' v' : Q) :
  met u d v -> met u' d v' -> met u u' v \/ met u' u v' \/ u == u'.
Proof. unfold met. lra. Qed.

(* Points along edges. *)
Section Chain.
Variable chain : list vector.
Hypothesis turning : turns_everywhere chain.
Let n := length chain.

Lemma edge_proper i : (i < n)%nat -> nonzero (edge_of_chain chain i).
Proof. intros I. now apply (edges_are_directions chain i OfP). Qed.

Lemma along_nothing i : equal_vectors (point_along chain i 0) (vertex chain i).
Proof. unfold equal_vectors, point_along. cbn [vx vy]. split; ring. Qed.

Lemma along_all i : (i < n)%nat -> equal_vectors (point_along chain i 1) (vertex chain (next i n)).
Proof.
  intros I. unfold point_along. rewrite edge_of_chain_joins_vertices by exact I. fold n.
  unfold equal_vectors, minus. cbn [vx vy]. split; ring.
Qed.

(* The vertex is inside a straight line. *)
Definition straight_at (i : nat) : Prop :=
  angle (edge_of_chain chain (previous n i)) == angle (edge_of_chain chain i).

Lemma touches_by_angles i d : (i < n)%nat -> nonzero d ->
  let u := edge_of_chain chain (previous n i) in let v := edge_of_chain chain i in
  touches_corner (corner_of_chain chain i) d <->
  met (angle u) (angle d) (angle v) \/ (straight_at i /\ angle d == angle v).
Proof.
  intros I nd u v. pose proof (previous_below n i I) as J.
  pose proof (edge_proper i I). pose proof (edge_proper _ J).
  unfold touches_corner, straight_at. rewrite corner_is by exact I. fold n. cbn [incoming outgoing]. fold u v.
  rewrite ccw_by_angles, !same_direction_angle by assumption.
  split; (intros [arc | [line same]]; [now left | right; split; [exact line | lra]]).
Qed.

(* At a vertex, or along an edge. *)
Lemma tangents_by_angles a d : nonzero d -> tangent_at chain a d ->
  (exists i, (i < n)%nat /\ equal_vectors a (vertex chain i) /\
     met (angle (edge_of_chain chain (previous n i))) (angle d) (angle (edge_of_chain chain i))) \/
  (exists i t, (i < n)%nat /\ 0 <= t <= 1 /\ equal_vectors a (point_along chain i t) /\
     angle d == angle (edge_of_chain chain i)).
Proof.
  intros nd (i & I & [(at_vertex & touches) | (t & t0 & t1 & a_is & same)]).
  - apply touches_by_angles in touches; trivial. destruct touches as [arc | [_ same]]; [left; now exists i | right].
    exists i, 0. split; [exact I |]. split; [lra |]. split; [| exact same].
    rewrite at_vertex. symmetry. apply along_nothing.
  - right. exists i, t. apply same_direction_angle in same; trivial; [| now apply edge_proper].
    split; [exact I |]. split; [lra | now split].
Qed.

Lemma tangent_inside i t d : (i < n)%nat -> 0 < t -> t < 1 -> nonzero d ->
  angle d == angle (edge_of_chain chain i) -> tangent_at chain (point_along chain i t) d.
Proof.
  intros I after_start before_end nd same. exists i. split; [exact I |]. right. exists t.
  repeat split; trivial. apply same_direction_angle; trivial. now apply edge_proper.
Qed.

Lemma tangent_at_vertex i d : (i < n)%nat -> nonzero d ->
  met (angle (edge_of_chain chain (previous n i))) (angle d) (angle (edge_of_chain chain i)) ->
  tangent_at chain (vertex chain i) d.
Proof.
  intros I nd arc. exists i. split; [exact I |]. left. split; [split; reflexivity |].
  apply touches_by_angles; trivial. now left.
Qed.

Lemma tangent_at_straight_vertex i d : (i < n)%nat -> nonzero d ->
  straight_at i -> angle d == angle (edge_of_chain chain i) ->
  tangent_at chain (vertex chain i) d.
Proof.
  intros I nd line same. exists i. split; [exact I |]. left. split; [split; reflexivity |].
  apply touches_by_angles; trivial. now right.
Qed.

(* A direction close to that of an edge, on the given side, in the tangent set of the edge's beginning, or of its
   end, and in an arc around the edge's direction. *)
Lemma touched_at_an_end i (u v : vector) t :
  (i < n)%nat -> nonzero u -> nonzero v ->
  met (angle u) (angle (edge_of_chain chain i)) (angle v) -> 0 <= t <= 1 ->
  exists a d, equal_vectors a (point_along chain i t) /\ nonzero d /\ tangent_at chain a d /\
    met (angle u) (angle d) (angle v).
Proof.
  intros I nu nv arc range. set (e := edge_of_chain chain i) in *.
  pose proof (edge_proper i I) as ne. pose proof (previous_below n i I) as J.
  pose proof (next_in_range i n I) as K. fold e in ne.
  pose proof (edge_proper _ J) as n_before. pose proof (edge_proper _ K) as n_after.
  pose proof (next_previous n i I) as np. pose proof (previous_next i n I) as pn.
  destruct (Qlt_le_dec 0 t) as [after_start | at_start].
  - destruct (Qlt_le_dec t 1) as [before_end | at_end].
    + exists (point_along chain i t), e. split; [split; reflexivity |]. split; [exact ne |].
      split; [apply tangent_inside; trivial; reflexivity | exact arc].
    + exists (vertex chain (next i n)).
      assert (there : equal_vectors (vertex chain (next i n)) (point_along chain i t)).
      { transitivity (point_along chain i 1); [symmetry; now apply along_all |].
        assert (t_is : t == 1) by lra. unfold equal_vectors, point_along. cbn [vx vy]. rewrite t_is.
        split; reflexivity. }
      destruct (Qeq_dec (angle e) (angle (edge_of_chain chain (next i n)))) as [line | corner].
      * exists e. repeat split; trivial; try apply there.
        apply tangent_at_straight_vertex; trivial. unfold straight_at. rewrite pn. exact line.
      * destruct (just_after e (edge_of_chain chain (next i n)) v) as (d & nd & in_corner & in_arc);
          trivial; [intros same; apply corner; now symmetry | unfold met in arc; lra |].
        exists d. split; [exact there |]. split; [exact nd |]. split.
        { apply tangent_at_vertex; trivial. rewrite pn. exact in_corner. }
        unfold met in *. lra.
  - exists (vertex chain i).
    assert (there : equal_vectors (vertex chain i) (point_along chain i t)).
    { transitivity (point_along chain i 0); [symmetry; apply along_nothing |].
      assert (t_is : t == 0) by lra. unfold equal_vectors, point_along. cbn [vx vy]. rewrite t_is.
      split; reflexivity. }
    destruct (Qeq_dec (angle (edge_of_chain chain (previous n i))) (angle e)) as [line | corner].
    + exists e. repeat split; trivial; try apply there.
      apply tangent_at_straight_vertex; trivial; reflexivity.
    + destruct (just_before e (edge_of_chain chain (previous n i)) u) as (d & nd & in_corner & in_arc);
        trivial; [unfold met in arc; lra |].
      exists d. split; [exact there |]. split; [exact nd |]. split.
      { now apply tangent_at_vertex. }
      unfold met in *. lra.
Qed.

(* Going on from vertex to vertex, one comes to one at which the chain turns. *)
Inductive comes_to_a_turn (go : nat -> nat) : nat -> Prop :=
| turns_here i : ~ straight_at i -> comes_to_a_turn go i
| turns_later i : comes_to_a_turn go (go i) -> comes_to_a_turn go i.

Lemma turns_all_along t : forall i, (i < n)%nat ->
  (comes_to_a_turn (fun k => next k n) ((i + t) mod n) -> comes_to_a_turn (fun k => next k n) i) /\
  (comes_to_a_turn (previous n) i -> comes_to_a_turn (previous n) ((i + t) mod n)).
Proof.
  induction t as [| t IH]; intros i I; [rewrite Nat.add_0_r, Nat.mod_small by exact I; tauto |].
  rewrite <- next_is_modulo by exact I. destruct (IH _ (next_in_range i n I)) as [ahead back].
  split; intros turn; [now apply turns_later, ahead |]. apply back, turns_later. now rewrite previous_next.
Qed.

Lemma turns_both_ways i : (i < n)%nat ->
  comes_to_a_turn (fun k => next k n) i /\ comes_to_a_turn (previous n) i.
Proof.
  intros I. destruct (some_vertex_turns chain (turning_chains_have_edges chain turning)) as (j & J & turn);
    [intros none; unfold n in I; rewrite none in I; cbn in I; lia |].
  destruct (every_index i n n I (Nat.le_refl n) j J) as (t & _ & to_j).
  destruct (every_index j n n J (Nat.le_refl n) i I) as (s & _ & from_j). split.
  - apply (turns_all_along t i I). rewrite to_j. now apply turns_here.
  - rewrite <- from_j. apply (turns_all_along s j J). now apply turns_here.
Qed.

End Chain.

Section Chains.
Variables p q : list vector.
Hypothesis turning_p : turns_everywhere p.
Hypothesis turning_q : turns_everywhere q.
Let n := length p.
Let m := length q.

Definition sum_of_tangents (x : vector) : Prop :=
  exists a b d, nonzero d /\ tangent_at p a d /\ tangent_at q b d /\ equal_vectors x (plus a b).

Definition on_a_segment (x : vector) : Prop :=
  exists i j t, (i < n)%nat /\ (j < m)%nat /\ 0 <= t <= 1 /\
    ((is_convolution_segment p q OfP i j = true /\ equal_vectors x (plus (point_along p i t) (vertex q j))) \/
     (is_convolution_segment p q OfQ i j = true /\ equal_vectors x (plus (vertex p i) (point_along q j t)))).

(* On one of the direction d. *)
Definition on_a_segment_along (d x : vector) : Prop :=
  exists i j t, (i < n)%nat /\ (j < m)%nat /\ 0 <= t <= 1 /\
    ((is_convolution_segment p q OfP i j = true /\ angle (edge_of_chain p i) == angle d /\
      equal_vectors x (plus (point_along p i t) (vertex q j))) \/
     (is_convolution_segment p q OfQ i j = true /\ angle (edge_of_chain q j) == angle d /\
      equal_vectors x (plus (vertex p i) (point_along q j t)))).

Lemma on_one_along (d x : vector) : on_a_segment_along d x -> on_a_segment x.
Proof. intros (i & j & t & I & J & range & [(? & _ & ?) | (? & _ & ?)]); exists i, j, t; tauto. Qed.

(* On one that the tie rule gives: edges of both have the direction d, and that of Q begins at a vertex that is not
   inside a straight line, or that of P ends at one. *)
Definition on_a_tie (d x : vector) : Prop :=
  exists i j t, (i < n)%nat /\ (j < m)%nat /\ 0 <= t <= 1 /\ angle (edge_of_chain q j) == angle d /\
    ((angle (edge_of_chain p i) == angle d /\ ~ straight_at q j /\
      equal_vectors x (plus (point_along p i t) (vertex q j))) \/
     (angle (edge_of_chain p (previous n i)) == angle d /\ ~ straight_at p i /\
      equal_vectors x (plus (vertex p i) (point_along q j t)))).

Lemma segment_of_p i j : (i < n)%nat -> (j < m)%nat ->
  let e := edge_of_chain p i in
  let u := edge_of_chain q (previous m j) in let v := edge_of_chain q j in
  is_convolution_segment p q OfP i j = true <->
  met (angle u) (angle e) (angle v) \/ (angle e == angle v /\ ~ angle u == angle v).
Proof.
  intros I J e u v. unfold is_convolution_segment. rewrite corner_is by exact J.
  apply edge_of_p_by_angles; apply edge_proper; trivial. now apply previous_below.
Qed.

Lemma segment_of_q i j : (i < n)%nat -> (j < m)%nat ->
  let f := edge_of_chain q j in
  let u := edge_of_chain p (previous n i) in let v := edge_of_chain p i in
  is_convolution_segment p q OfQ i j = true <->
  met (angle u) (angle f) (angle v) \/ (angle f == angle u /\ ~ angle u == angle v).
Proof.
  intros I J f u v. unfold is_convolution_segment. rewrite corner_is by exact I.
  apply edge_of_q_by_angles; apply edge_proper; trivial. now apply previous_below.
Qed.

Lemma multiple (e f : vector) : nonzero e -> nonzero f -> angle e == angle f ->
  exists k, 0 < k /\ vx f == k * vx e /\ vy f == k * vy e.
Proof. intros ne nf same. apply same_direction_angle; trivial. now symmetry. Qed.

Lemma ties_are_segments (d x : vector) : on_a_tie d x -> on_a_segment_along d x.
Proof.
  intros (i & j & t & I & J & range & f_is & [(e_is & turn & x_is) | (e_is & turn & x_is)]);
    exists i, j, t; (split; [exact I |]); (split; [exact J |]); (split; [exact range |]); [left | right].
  - split; [| now split]. apply segment_of_p; trivial. right. split; [now rewrite e_is | exact turn].
  - split; [| now split]. apply segment_of_q; trivial. right. split; [now rewrite f_is | exact turn].
Qed.

(* Two edges of one direction, a segment as long as both: inside it, points inside both add up. *)
Lemma inside_two_edges i j s r x : (i < n)%nat -> (j < m)%nat ->
  angle (edge_of_chain p i) == angle (edge_of_chain q j) ->
  0 <= s <= 1 -> 0 <= r <= 1 -> 0 < s + r -> s + r < 2 ->
  equal_vectors x (plus (point_along p i s) (point_along q j r)) -> sum_of_tangents x.
Proof.
  intros I J same range_s range_r some not_all [x_is y_is].
  pose proof (edge_proper p turning_p i I) as ne. pose proof (edge_proper q turning_q j J) as nf.
  destruct (multiple _ _ ne nf same) as (k & positive & xk & yk).
  set (w := (s + r * k) / (1 + k)).
  assert (w_is : w * (1 + k) == s + r * k) by (unfold w; field; lra).
  assert (0 <= r * k) by (apply Qmult_le_0_compat; lra).
  assert (0 <= (1 - r) * k) by (apply Qmult_le_0_compat; lra).
  assert (total_positive : 0 < s + r * k).
  { destruct (Qlt_le_dec 0 r); [|lra]. assert (0 < r * k) by (apply Qmult_lt_0_compat; lra). lra. }
  assert (total_below : s + r * k < 1 + k).
  { destruct (Qlt_le_dec r 1); [|lra]. assert (0 < (1 - r) * k) by (apply Qmult_lt_0_compat; lra). lra. }
  assert (0 < w) by (unfold w; apply Qlt_shift_div_l; lra).
  assert (w < 1) by (unfold w; apply Qlt_shift_div_r; lra).
  exists (point_along p i w), (point_along q j w), (edge_of_chain p i).
  split; [exact ne |]. split; [apply tangent_inside; trivial; reflexivity |].
  split; [now apply tangent_inside |].
  unfold equal_vectors, plus, point_along in *. cbn [vx vy] in *. clearbody w. split; by_equations.
Qed.

Lemma plus_of_equal (a b c e : vector) :
  equal_vectors a c -> equal_vectors b e -> equal_vectors (plus a b) (plus c e).
Proof.
  intros [xa ya] [xb yb]. unfold equal_vectors, plus. cbn [vx vy]. rewrite xa, ya, xb, yb.
  split; reflexivity.
Qed.

(* The end of the edge before is the vertex. *)
Lemma along_the_edge_before chain i : (i < length chain)%nat ->
  equal_vectors (point_along chain (previous (length chain) i) 1) (vertex chain i).
Proof.
  intros I. pose proof (along_all chain _ (previous_below _ i I)) as there.
  now rewrite next_previous in there by exact I.
Qed.

Lemma along_of_equal chain i s t : s == t -> equal_vectors (point_along chain i s) (point_along chain i t).
Proof. intros same. unfold equal_vectors, point_along. cbn [vx vy]. rewrite same. split; reflexivity. Qed.

(* Definition 2.2.7's points are 2.2.8's. *)
Lemma segments_are_sums x : on_a_segment x -> sum_of_tangents x.
Proof.
  intros (i & j & t & I & J & range & [[segment x_is] | [segment x_is]]).
  - apply segment_of_p in segment; trivial. set (e := edge_of_chain p i) in *.
    pose proof (previous_below m j J) as J'.
    destruct segment as [arc | [same corner]].
    + destruct (touched_at_an_end p turning_p i _ _ t I (edge_proper q turning_q _ J')
                  (edge_proper q turning_q j J) arc range) as (a & d & a_is & nd & at_a & in_arc).
      exists a, (vertex q j), d. split; [exact nd |]. split; [exact at_a |].
      split; [now apply tangent_at_vertex |].
      rewrite x_is. apply plus_of_equal; [now symmetry | reflexivity].
    + assert (on_both : equal_vectors x (plus (point_along p i t) (point_along q j 0))).
      { rewrite x_is. apply plus_of_equal; [reflexivity | symmetry; apply along_nothing]. }
      destruct (Qlt_le_dec 0 t); [apply (inside_two_edges i j t 0); trivial; lra |].
      pose proof (previous_below n i I) as I'.
      destruct (Qeq_dec (angle (edge_of_chain p (previous n i))) (angle e)) as [line | turn].
      * apply (inside_two_edges (previous n i) j 1 0); trivial; try lra.
        rewrite on_both. apply plus_of_equal; [| reflexivity].
        transitivity (point_along p i 0); [apply along_of_equal; lra |].
        rewrite along_nothing. symmetry. now apply along_the_edge_before.
      * destruct (just_before e (edge_of_chain p (previous n i)) (edge_of_chain q (previous m j)))
          as (d & nd & at_p & at_q); trivial; try (now apply edge_proper);
          [intros line; apply corner; now rewrite line |].
        exists (vertex p i), (vertex q j), d. split; [exact nd |].
        split; [now apply tangent_at_vertex |]. split; [apply tangent_at_vertex; trivial |].
        { unfold met in *. fold m. lra. }
        rewrite x_is. apply plus_of_equal; [| reflexivity].
        rewrite <- (along_nothing p i). apply along_of_equal. lra.
  - apply segment_of_q in segment; trivial. set (f := edge_of_chain q j) in *.
    pose proof (previous_below n i I) as I'.
    destruct segment as [arc | [same corner]].
    + destruct (touched_at_an_end q turning_q j _ _ t J (edge_proper p turning_p _ I')
                  (edge_proper p turning_p i I) arc range) as (b & d & b_is & nd & at_b & in_arc).
      exists (vertex p i), b, d. split; [exact nd |].
      split; [now apply tangent_at_vertex |]. split; [exact at_b |].
      rewrite x_is. apply plus_of_equal; [reflexivity | now symmetry].
    + assert (on_both : equal_vectors x (plus (point_along p (previous n i) 1) (point_along q j t))).
      { rewrite x_is. apply plus_of_equal; [| reflexivity]. symmetry. now apply along_the_edge_before. }
      destruct (Qlt_le_dec t 1).
      { apply (inside_two_edges (previous n i) j 1 t); trivial; try lra. now symmetry. }
      pose proof (next_in_range j m J) as J'. pose proof (previous_next j m J) as pn.
      assert (at_end : equal_vectors (point_along q j t) (vertex q (next j m))).
      { transitivity (point_along q j 1); [apply along_of_equal; lra | now apply along_all]. }
      destruct (Qeq_dec (angle f) (angle (edge_of_chain q (next j m)))) as [line | turn].
      * apply (inside_two_edges (previous n i) (next j m) 1 0); trivial; try lra.
        rewrite on_both. apply plus_of_equal; [reflexivity |]. rewrite at_end. symmetry. apply along_nothing.
      * destruct (just_after f (edge_of_chain p i) (edge_of_chain q (next j m)))
          as (d & nd & at_p & at_q); trivial; try (now apply edge_proper);
          [intros line; apply corner; rewrite line; now symmetry | intros line; apply turn; now symmetry |].
        exists (vertex p i), (vertex q (next j m)), d. split; [exact nd |].
        split; [apply tangent_at_vertex; trivial |].
        { unfold met in *. fold n. lra. }
        split; [apply tangent_at_vertex; trivial; fold m; rewrite pn; exact at_q |].
        rewrite x_is. apply plus_of_equal; [reflexivity | exact at_end].
Qed.

(* A sum of points of two edges of one direction is on a segment, or the line of Q begins before, or that of P goes
   on. *)
Lemma covered_or_further i j s r x : (i < n)%nat -> (j < m)%nat ->
  angle (edge_of_chain p i) == angle (edge_of_chain q j) -> 0 <= s <= 1 -> 0 <= r <= 1 ->
  equal_vectors x (plus (point_along p i s) (point_along q j r)) ->
  on_a_tie (edge_of_chain p i) x \/
  (straight_at q j /\ exists s', 0 <= s' <= 1 /\
     equal_vectors x (plus (point_along p i s') (point_along q (previous m j) 1))) \/
  (straight_at p (next i n) /\ exists r', 0 <= r' <= 1 /\
     equal_vectors x (plus (point_along p (next i n) 0) (point_along q j r'))).
Proof.
  intros I J same range_s range_r x_is.
  destruct (multiple _ _ (edge_proper p turning_p i I) (edge_proper q turning_q j J) same)
    as (k & positive & xk & yk).
  set (w := s + r * k). assert (0 <= r * k) by (apply Qmult_le_0_compat; lra).
  assert (on_p : equal_vectors x (plus (point_along p i w) (vertex q j))).
  { destruct x_is as [x_is y_is]. unfold equal_vectors, plus, point_along in *. cbn [vx vy] in *.
    rewrite x_is, y_is, xk, yk. unfold w. split; ring. }
  destruct (Qlt_le_dec 1 w) as [beyond | within].
  - set (r' := (w - 1) / k).
    assert (r'_is : r' * k == w - 1) by (unfold r'; field; lra).
    assert (range : 0 <= r' <= 1).
    { unfold r'. split; [apply Qle_shift_div_l | apply Qle_shift_div_r]; try lra.
      assert (0 <= (1 - r) * k) by (apply Qmult_le_0_compat; lra). unfold w. lra. }
    assert (on_q : equal_vectors x (plus (vertex p (next i n)) (point_along q j r'))).
    { transitivity (plus (point_along p i 1) (point_along q j r'));
        [| apply plus_of_equal; [now apply along_all | reflexivity]].
      destruct on_p as [x_is' y_is']. clear - x_is' y_is' xk yk r'_is.
      unfold equal_vectors, plus, point_along in *. cbn [vx vy] in *. rewrite x_is', y_is', xk, yk.
      split; by_equations. }
    pose proof (next_in_range i n I) as I'. pose proof (previous_next i n I) as pn.
    destruct (Qeq_dec (angle (edge_of_chain p (previous n (next i n)))) (angle (edge_of_chain p (next i n))))
      as [line | turn].
    + right. right. split; [exact line |]. exists r'. split; [exact range |].
      rewrite on_q. apply plus_of_equal; [symmetry; apply along_nothing | reflexivity].
    + left. exists (next i n), j, r'. repeat split; try tauto; try lra. right.
      split; [rewrite pn; reflexivity | now split].
  - destruct (Qeq_dec (angle (edge_of_chain q (previous m j))) (angle (edge_of_chain q j))) as [line | turn].
    + right. left. split; [exact line |]. exists w. split; [unfold w in *; lra |].
      rewrite on_p. apply plus_of_equal; [reflexivity |]. symmetry. now apply along_the_edge_before.
    + left. exists i, j, w. repeat split; trivial; [unfold w; lra | now symmetry |]. left.
      split; [reflexivity | now split].
Qed.

Lemma two_edges_are_covered k : comes_to_a_turn p (fun k => next k n) k ->
  forall j, comes_to_a_turn q (previous m) j ->
  forall i s r x d, k = next i n -> (i < n)%nat -> (j < m)%nat -> angle (edge_of_chain p i) == angle d ->
  angle (edge_of_chain p i) == angle (edge_of_chain q j) -> 0 <= s <= 1 -> 0 <= r <= 1 ->
  equal_vectors x (plus (point_along p i s) (point_along q j r)) -> on_a_tie d x.
Proof.
  intros later. induction later as [k turn_p | k later further];
    (intros j earlier; induction earlier as [j turn_q | j earlier back];
     intros i s r x d k_is I J is_d same range_s range_r x_is;
     (destruct (covered_or_further i j s r x I J same range_s range_r x_is)
        as [covered | [(line & s' & range' & x_is') | (line & r' & range' & x_is')]];
      [destruct covered as (i' & j' & t & parts); exists i', j', t; rewrite <- is_d; exact parts | |])).
  - contradiction.
  - rewrite k_is in turn_p. contradiction.
  - apply (back i s' 1 x d); trivial; [now apply previous_below | now rewrite same | lra].
  - rewrite k_is in turn_p. contradiction.
  - contradiction.
  - pose proof (previous_next i n I) as pn. unfold straight_at in line. fold n in line. rewrite pn in line.
    apply (further j (turns_here q (previous m) j turn_q) (next i n) 0 r' x d); trivial; try lra;
      [now rewrite k_is | now apply next_in_range].
  - apply (back i s' 1 x d); trivial; [now apply previous_below | now rewrite same | lra].
  - pose proof (previous_next i n I) as pn. unfold straight_at in line. fold n in line. rewrite pn in line.
    apply (further j (turns_later q (previous m) j earlier) (next i n) 0 r' x d); trivial; try lra;
      [now rewrite k_is | now apply next_in_range].
Qed.

Lemma sum_along_two_edges i j s r x : (i < n)%nat -> (j < m)%nat ->
  angle (edge_of_chain p i) == angle (edge_of_chain q j) -> 0 <= s <= 1 -> 0 <= r <= 1 ->
  equal_vectors x (plus (point_along p i s) (point_along q j r)) -> on_a_tie (edge_of_chain p i) x.
Proof.
  intros I J same range_s range_r. apply (two_edges_are_covered (next i n)) with (j := j); trivial; try reflexivity.
  - now apply turns_both_ways, next_in_range.
  - now apply turns_both_ways.
Qed.

Lemma sum_of_two_edges i j s r x : (i < n)%nat -> (j < m)%nat ->
  angle (edge_of_chain p i) == angle (edge_of_chain q j) -> 0 <= s <= 1 -> 0 <= r <= 1 ->
  equal_vectors x (plus (point_along p i s) (point_along q j r)) -> on_a_segment x.
Proof. intros. now apply (on_one_along (edge_of_chain p i)), ties_are_segments, (sum_along_two_edges i j s r). Qed.

(* Definition 2.2.8's points are 2.2.7's. *)
Lemma sums_are_on_segments x : sum_of_tangents x -> on_a_segment x.
Proof.
  intros (a & b & d & nd & at_p & at_q & x_is). apply tangents_by_angles in at_p, at_q; trivial. fold n m in at_p, at_q.
  assert (sum_is : forall a' b', equal_vectors a a' -> equal_vectors b b' -> equal_vectors x (plus a' b'))
    by (intros a' b' first second; rewrite x_is; now apply plus_of_equal).
  destruct at_p as [(i & I & a_is & arc_p) | (i & t & I & range_p & a_is & dir_p)],
    at_q as [(j & J & b_is & arc_q) | (j & o & J & range_q & b_is & dir_q)].
  - pose proof (previous_below n i I) as I'. pose proof (previous_below m j J) as J'.
    destruct (arcs_in_common _ _ _ _ _ arc_p arc_q) as [q_inside | [p_inside | together]].
    + exists i, (previous m j), 1. repeat split; trivial; try lra. right. split.
      { apply segment_of_q; trivial. now left. }
      apply sum_is; [exact a_is |]. rewrite b_is. symmetry. now apply along_the_edge_before.
    + exists (previous n i), j, 1. repeat split; trivial; try lra. left. split.
      { apply segment_of_p; trivial. now left. }
      apply sum_is; [| exact b_is]. rewrite a_is. symmetry. now apply along_the_edge_before.
    + exists i, (previous m j), 1. repeat split; trivial; try lra. right. split.
      { apply segment_of_q; trivial. right. fold n. unfold met in arc_p. split; lra. }
      apply sum_is; [exact a_is |]. rewrite b_is. symmetry. now apply along_the_edge_before.
  - exists i, j, o. repeat split; trivial; try apply range_q. right. split; [| now apply sum_is].
    apply segment_of_q; trivial. left. unfold met in *. fold n. lra.
  - exists i, j, t. repeat split; trivial; try apply range_p. left. split; [| now apply sum_is].
    apply segment_of_p; trivial. left. unfold met in *. fold m. lra.
  - apply (sum_of_two_edges i j t o); trivial; [lra | now apply sum_is].
Qed.

End Chains.

(* The segments of Definition 2.2.7 as they are named. *)
Lemma lies_on_a_segment_of p q i j x along_summand :
  (i < length p)%nat -> (j < length q)%nat ->
  let s := ((p, q), (along_summand, (i, j))) in
  lies_on x (Segment (starts_at s) (ends_at s)) <->
  exists t, 0 <= t <= 1 /\
    equal_vectors x (match along_summand with
                     | OfP => plus (point_along p i t) (vertex q j)
                     | OfQ => plus (vertex p i) (point_along q j t)
                     end).
Proof.
  intros I J s. unfold s, starts_at, ends_at, state_before, state_after, point_of, step.
  cbn [fst snd]. unfold lies_on, equal_vectors. cbn [source target].
  fold (vertex p i). fold (vertex q j). unfold point_along.
  rewrite !edge_of_chain_joins_vertices by assumption.
  destruct along_summand; cbn [fst snd];
    fold (vertex p i); fold (vertex q j); fold (vertex p (next i (length p)));
    fold (vertex q (next j (length q))); unfold plus, minus; cbn [vx vy];
    split; (intros (t & range & x_is & y_is); exists t; repeat split; lra).
Qed.

Lemma on_segments_of_regions (p q : region) (x : vector) :
  in_convolution_by_2_2_7 p q x <->
  exists chain_p chain_q, In chain_p p /\ In chain_q q /\ on_a_segment chain_p chain_q x.
Proof.
  unfold in_convolution_by_2_2_7, segments_of_regions, on_a_segment. split.
  - intros (s & listed & on_s). apply in_flat_map in listed.
    destruct listed as ([chain_p chain_q] & chains & listed). apply in_prod_iff in chains.
    apply in_map_iff in listed. destruct listed as ([summand [i j]] & <- & listed). cbn [fst snd] in listed.
    apply (in_those (length chain_p) (length chain_q) (in_convolution chain_p chain_q)) in listed.
    destruct listed as [[I J] segment]. cbn [state_before fst snd] in I, J.
    apply lies_on_a_segment_of in on_s; trivial. destruct on_s as (t & range & x_is).
    exists chain_p, chain_q. split; [tauto | split; [tauto |]]. exists i, j, t.
    unfold in_convolution in segment. cbn [fst snd] in segment.
    split; [exact I | split; [exact J | split; [exact range |]]].
    destruct summand; [left | right]; now split.
  - intros (chain_p & chain_q & P & Q & i & j & t & I & J & range & cases).
    assert (in_list : forall summand, is_convolution_segment chain_p chain_q summand i j = true ->
      In ((chain_p, chain_q), (summand, (i, j)))
        (flat_map (fun chains => map (pair chains) (convolution (fst chains) (snd chains))) (list_prod p q))).
    { intros summand segment. apply in_flat_map. exists (chain_p, chain_q).
      split; [now apply in_prod_iff |]. apply in_map_iff. exists (summand, (i, j)). split; [reflexivity |].
      apply (in_those (length chain_p) (length chain_q) (in_convolution chain_p chain_q)).
      split; [now split | exact segment]. }
    destruct cases as [[segment x_is] | [segment x_is]];
      [exists ((chain_p, chain_q), (OfP, (i, j))) | exists ((chain_p, chain_q), (OfQ, (i, j)))];
      (split; [now apply in_list |]); apply lies_on_a_segment_of; trivial; now exists t.
Qed.

(* Theorem. The two definitions of the convolution have the same points, for regions of any number of closed
   chains that turn back nowhere, with vertices inside straight lines or without, and with any ties. *)
Theorem both_definitions_have_the_same_points (p q : region) (x : vector) :
  (forall chain, In chain p -> turns_everywhere chain) ->
  (forall chain, In chain q -> turns_everywhere chain) ->
  in_convolution_by_2_2_7 p q x <-> in_convolution_by_2_2_8 p q x.
Proof.
  intros turning_p turning_q. rewrite on_segments_of_regions. unfold in_convolution_by_2_2_8. split.
  - intros (chain_p & chain_q & P & Q & on_segment).
    destruct (segments_are_sums chain_p chain_q (turning_p _ P) (turning_q _ Q) x on_segment)
      as (a & b & d & parts).
    exists chain_p, chain_q, a, b, d. tauto.
  - intros (chain_p & chain_q & a & b & d & P & Q & parts).
    exists chain_p, chain_q. split; [exact P | split; [exact Q |]].
    apply sums_are_on_segments; auto. now exists a, b, d.
Qed.
