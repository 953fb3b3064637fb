(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* From a point off a simple chain, unless all its edges are on lines through the point, there is a ray that
   meets the chain first inside an edge. Simple chains are in simple_chain.v, `eventually` all nonzero in
   shifted_ray.v and signed_crossings.v. *)
From Coq Require Import QArith Lqa Qfield ZArith Lia Bool List.
From Oplus Require Import direction angle sweep winding_number shifted_ray signed_crossings
  turning_number convolution_size fiber_grid states secants segments_apart simple_chain.
Import ListNotations.

Open Scope Q_scope.

(* Of finitely many numbers one is the least. *)
Lemma least_of {A : Type} (f : A -> Q) (l : list A) : l <> [] ->
  exists b, In b l /\ forall c, In c l -> f b <= f c.
Proof.
  induction l as [| b l IH]; intros some; [contradiction |].
  destruct l as [| c l]; [exists b; split; [now left | intros e [<- | []]; lra] |].
  destruct IH as (least & listed & below); [discriminate |].
  destruct (Qlt_le_dec (f least) (f b)).
  - exists least. split; [now right |]. intros e [<- | I]; [lra | now apply below].
  - exists b. split; [now left |]. intros e [<- | I]; [lra |]. specialize (below e I). lra.
Qed.

Section Ray.
Variable chain : list vector.
Hypothesis chain_simple : simple chain.
Variable x : vector.
Hypothesis x_off : off x (edges chain).
Let n := length chain.

Definition from_x (i : nat) : vector := minus (vertex chain i) x.

Lemma off_edge j : (j < n)%nat -> ~ lies_on x (edge chain j).
Proof.
  intros J. apply x_off. unfold edge. apply nth_In.
  rewrite <- (map_length source). now destruct (edges_ends chain) as [-> _].
Qed.

Lemma vertex_not_x i : (i < n)%nat -> nonzero (from_x i).
Proof.
  intros I [x_is y_is]. apply (off_edge i I). rewrite edge_is by exact I.
  unfold from_x, minus in *. cbn [vx vy] in *. exists 0. cbn [source target]. repeat split; lra.
Qed.

(* To a point of an edge, near its beginning, there is a ray from x that meets no vertex. *)
Lemma ray_between_vertices k : (k < n)%nat -> ~ cross (from_x k) (from_x (next k n)) == 0 ->
  exists t, 0 < t < 1 /\
    let u := Vector (vx (from_x k) + t * (vx (from_x (next k n)) - vx (from_x k)))
                    (vy (from_x k) + t * (vy (from_x (next k n)) - vy (from_x k))) in
    forall i, (i < n)%nat -> ~ cross u (from_x i) == 0.
Proof.
  intros K across. set (a := from_x k) in *. set (b := from_x (next k n)) in *.
  destruct (all_nearby nat (fun i t =>
    ~ cross (Vector (vx a + t * (vx b - vx a)) (vy a + t * (vy b - vy a))) (from_x i) == 0) (seq 0 n))
    as (limit & positive & near).
  - intros i I. apply in_seq in I. assert (i_below : (i < n)%nat) by lia.
    pose proof (vertex_not_x i i_below) as ni. set (c := from_x i) in *.
    destruct (quadratic_nearby (cross a c) (cross b c - cross a c) 0) as (limit & positive & near).
    exists limit. split; [exact positive |]. intros e e_positive small none.
    specialize (near e e_positive small).
    assert (zero_is : cross a c + e * (cross b c - cross a c) + e * e * 0 == 0)
      by (etransitivity; [| exact none]; unfold cross; cbn [vx vy]; ring).
    apply (proj1 (Qeq_alt _ _)) in zero_is. rewrite zero_is in near. unfold sign_nearby in near.
    compared_numbers (cross a c ?= 0); try discriminate.
    compared_numbers (cross b c - cross a c ?= 0); try discriminate.
    assert (b_is : cross b c == 0) by lra.
    apply ni. split; apply (Qmult_inj_l _ _ (cross a b)); trivial.
    + setoid_replace (cross a b * vx c) with (vx a * cross c b - vx b * cross c a)
        by (unfold cross; ring).
      assert (cross c b == 0 /\ cross c a == 0) as [-> ->] by (unfold cross in *; split; lra). ring.
    + setoid_replace (cross a b * vy c) with (vy a * cross c b - vy b * cross c a)
        by (unfold cross; ring).
      assert (cross c b == 0 /\ cross c a == 0) as [-> ->] by (unfold cross in *; split; lra). ring.
  - set (t := (1 # 2) * (if Qlt_le_dec limit 1 then limit else 1)).
    assert (t_range : 0 < t /\ t < 1 /\ t < limit)
      by (unfold t; destruct (Qlt_le_dec limit 1); lra).
    exists t. split; [lra |]. intros u i I. apply (near t); try lra. apply in_seq. lia.
Qed.

Variable u : vector.
Hypothesis between_vertices : forall i, (i < n)%nat -> ~ cross u (from_x i) == 0.

Definition on_ray (t : Q) : vector := Vector (vx x + t * vx u) (vy x + t * vy u).
Definition side_of (i : nat) : Q := cross u (from_x i).
Definition crosses_line (j : nat) : bool := negative (side_of j * side_of (next j n)).
(* Where on the ray. *)
Definition place_of_crossing (j : nat) : Q :=
  cross (from_x j) (edge_of_chain chain j) / cross u (edge_of_chain chain j).

Lemma edge_from_x j : (j < n)%nat ->
  equal_vectors (edge_of_chain chain j) (minus (from_x (next j n)) (from_x j)).
Proof.
  intros J. rewrite edge_of_chain_is by exact J. fold n. unfold from_x, equal_vectors, minus. cbn [vx vy].
  split; ring.
Qed.

Lemma across_edge j : (j < n)%nat ->
  cross u (edge_of_chain chain j) == side_of (next j n) - side_of j.
Proof.
  intros J. destruct (edge_from_x j J) as [x_is y_is]. unfold side_of. unfold cross at 1.
  rewrite x_is, y_is. unfold cross, minus. cbn [vx vy]. ring.
Qed.

Lemma crossing_line_spec j :
  crosses_line j = true -> side_of j * side_of (next j n) < 0.
Proof. unfold crosses_line. destruct (negative_spec (side_of j * side_of (next j n))); [trivial | discriminate]. Qed.

(* A point of the ray's line on an edge is where the edge crosses the line. *)
Lemma on_edge_is_crossing j t : (j < n)%nat -> lies_on (on_ray t) (edge chain j) ->
  crosses_line j = true /\ t == place_of_crossing j.
Proof.
  intros J on_edge. rewrite edge_is in on_edge by exact J.
  destruct on_edge as (r & range & x_is & y_is). cbn [source target] in *. fold n in x_is, y_is.
  pose proof (next_in_range j n J) as J'.
  pose proof (between_vertices j J) as j_off. pose proof (between_vertices _ J') as j'_off.
  fold (side_of j) in j_off. fold (side_of (next j n)) in j'_off.
  assert (x_sum : t * vx u == (1 - r) * vx (from_x j) + r * vx (from_x (next j n)))
    by (unfold from_x, on_ray, minus in *; cbn [vx] in *; lra).
  assert (y_sum : t * vy u == (1 - r) * vy (from_x j) + r * vy (from_x (next j n)))
    by (unfold from_x, on_ray, minus in *; cbn [vy] in *; lra).
  assert (balance : (1 - r) * side_of j + r * side_of (next j n) == 0).
  { transitivity (vx u * ((1 - r) * vy (from_x j) + r * vy (from_x (next j n)))
                  - vy u * ((1 - r) * vx (from_x j) + r * vx (from_x (next j n)))).
    - unfold side_of, cross. ring.
    - rewrite <- x_sum, <- y_sum. ring. }
  assert (opposite_sides : side_of j * side_of (next j n) < 0).
  { set (p := side_of j) in *. set (q := side_of (next j n)) in *. clearbody p q.
    destruct (Q_dec p 0) as [[p_neg | p_pos] | ?], (Q_dec q 0) as [[q_neg | q_pos] | ?];
      try contradiction; [exfalso | nra | nra | exfalso].
    - assert (0 <= (1 - r) * - p) by (apply Qmult_le_0_compat; lra).
      assert (0 <= r * - q) by (apply Qmult_le_0_compat; lra). nra.
    - assert (0 <= (1 - r) * p) by (apply Qmult_le_0_compat; lra).
      assert (0 <= r * q) by (apply Qmult_le_0_compat; lra). nra. }
  split.
  - unfold crosses_line. destruct (negative_spec (side_of j * side_of (next j n)));
      [reflexivity | contradiction].
  - pose proof (across_edge j J) as across. destruct (edge_from_x j J) as [xe ye].
    assert (nonzero_cross : ~ cross u (edge_of_chain chain j) == 0).
    { rewrite across. intros none. assert (side_of (next j n) == side_of j) as same by lra.
      rewrite same in opposite_sides. nra. }
    apply (Qmult_inj_r _ _ (cross u (edge_of_chain chain j))); [exact nonzero_cross |].
    unfold place_of_crossing.
    setoid_replace (cross (from_x j) (edge_of_chain chain j) / cross u (edge_of_chain chain j)
                    * cross u (edge_of_chain chain j)) with (cross (from_x j) (edge_of_chain chain j))
      by (field; exact nonzero_cross).
    transitivity ((t * vx u) * vy (edge_of_chain chain j) - (t * vy u) * vx (edge_of_chain chain j));
      [unfold cross; ring |].
    rewrite x_sum, y_sum. unfold cross. rewrite xe, ye. unfold minus. cbn [vx vy]. ring.
Qed.

(* And there is that point, inside the edge. *)
Lemma crossing_is_on_edge j : (j < n)%nat -> crosses_line j = true ->
  exists part, 0 < part /\ part < 1 /\
    equal_vectors (on_ray (place_of_crossing j))
      (Vector (vx (vertex chain j) + part * (vx (vertex chain (next j n)) - vx (vertex chain j)))
              (vy (vertex chain j) + part * (vy (vertex chain (next j n)) - vy (vertex chain j)))).
Proof.
  intros J crossed. apply crossing_line_spec in crossed. pose proof (across_edge j J) as across.
  set (p := side_of j) in *. set (q := side_of (next j n)) in *.
  assert (differ : ~ p - q == 0) by (intros none; assert (same : p == q) by lra; rewrite same in crossed; nra).
  set (part := p / (p - q)). assert (part_is : part * (p - q) == p) by (unfold part; field; exact differ).
  exists part.
  assert (range : 0 < part /\ part < 1).
  { assert (0 < (p - q) * (p - q)) by (destruct (Q_dec (p - q) 0) as [[? | ?] | ?]; [nra | nra | contradiction]).
    assert (first_part : part * ((p - q) * (p - q)) == p * p - p * q)
      by (transitivity (part * (p - q) * (p - q)); [ring | rewrite part_is; ring]).
    assert (second_part : (1 - part) * ((p - q) * (p - q)) == q * q - p * q)
      by (transitivity ((p - q) * (p - q) - part * (p - q) * (p - q)); [ring | rewrite part_is; ring]).
    assert (0 <= p * p /\ 0 <= q * q) as [? ?] by (split; nra).
    set (square := (p - q) * (p - q)) in *. clearbody square part. split; nra. }
  destruct range as [after_start before_end]. split; [exact after_start | split; [exact before_end |]].
  set (e := edge_of_chain chain j) in *. set (k := place_of_crossing j).
  assert (nonzero_cross : ~ cross u e == 0) by (rewrite across; intros none; apply differ; lra).
  assert (k_is : k * cross u e == cross (from_x j) e)
    by (unfold k, place_of_crossing; fold e; field; exact nonzero_cross).
  destruct (edge_from_x j J) as [xe ye]. fold e in xe, ye.
  set (gap := Vector (vx (from_x j) + part * vx e - k * vx u) (vy (from_x j) + part * vy e - k * vy u)).
  assert (along_ray : cross u gap == 0).
  { transitivity (side_of j + part * cross u e); [unfold gap, side_of, cross; cbn [vx vy]; ring |].
    rewrite across. fold p. setoid_replace (p + part * (q - p)) with (p - part * (p - q)) by ring.
    rewrite part_is. ring. }
  assert (along_edge : cross gap e == 0).
  { transitivity (cross (from_x j) e - k * cross u e); [unfold gap, cross; cbn [vx vy]; ring |].
    rewrite k_is. ring. }
  assert (no_gap : vx gap == 0 /\ vy gap == 0).
  { split; apply (Qmult_inj_l _ _ (cross u e)); trivial.
    - setoid_replace (cross u e * vx gap) with (vx u * cross gap e + vx e * cross u gap)
        by (unfold cross; ring). rewrite along_ray, along_edge. ring.
    - setoid_replace (cross u e * vy gap) with (vy u * cross gap e + vy e * cross u gap)
        by (unfold cross; ring). rewrite along_ray, along_edge. ring. }
  destruct no_gap as [x_none y_none]. unfold gap in x_none, y_none. cbn [vx vy] in x_none, y_none.
  rewrite xe in x_none. rewrite ye in y_none.
  unfold on_ray, from_x, minus, equal_vectors in *. cbn [vx vy] in *. split; lra.
Qed.

(* Theorem. If the ray meets an edge, then some edge first: in a point between its ends, before which there is no
   point of another edge. *)
Theorem ray_has_a_first_edge k t : (k < n)%nat -> 0 < t -> lies_on (on_ray t) (edge chain k) ->
  exists m first part, (m < n)%nat /\ 0 < first /\ 0 < part /\ part < 1 /\
    ~ cross u (edge_of_chain chain m) == 0 /\
    equal_vectors (on_ray first)
      (Vector (vx (vertex chain m) + part * (vx (vertex chain (next m n)) - vx (vertex chain m)))
              (vy (vertex chain m) + part * (vy (vertex chain (next m n)) - vy (vertex chain m)))) /\
    forall j, (j < n)%nat -> j <> m -> forall z,
      lies_on z (Segment x (on_ray first)) -> ~ lies_on z (edge chain j).
Proof.
  intros K t_positive on_k.
  set (met := filter (fun j => crosses_line j && is_positive (place_of_crossing j)) (seq 0 n)).
  assert (in_met : forall j s, (j < n)%nat -> 0 < s -> lies_on (on_ray s) (edge chain j) ->
    In j met /\ s == place_of_crossing j).
  { intros j s J s_positive on_j. destruct (on_edge_is_crossing j s J on_j) as [crossed s_is].
    split; [| exact s_is]. apply filter_In. split; [apply in_seq; lia |]. rewrite crossed. cbn [andb].
    destruct (is_positive_spec (place_of_crossing j)); [reflexivity | lra]. }
  destruct (least_of place_of_crossing met) as (m & listed & least).
  { destruct (in_met k t K t_positive on_k) as [I _]. intros none. now rewrite none in I. }
  apply filter_In in listed. destruct listed as [M both]. apply in_seq in M.
  assert (m_below : (m < n)%nat) by lia.
  apply andb_prop in both. destruct both as [crossed positive].
  destruct (is_positive_spec (place_of_crossing m)) as [m_positive |]; [| discriminate].
  destruct (crossing_is_on_edge m m_below crossed) as (part & after_start & before_end & there).
  exists m, (place_of_crossing m), part.
  split; [exact m_below |]. split; [exact m_positive |]. split; [exact after_start |].
  split; [exact before_end |]. split; [| split; [exact there |]].
  { rewrite across_edge by exact m_below. apply crossing_line_spec in crossed. intros none.
    assert (same : side_of (next m n) == side_of m) by lra. rewrite same in crossed. nra. }
  intros j J differ z (r & range & xz & yz) on_j. cbn [source target] in *.
  set (first := place_of_crossing m) in *.
  assert (z_is : equal_vectors z (on_ray (r * first))).
  { unfold on_ray, equal_vectors in *. cbn [vx vy] in *. rewrite xz, yz. split; ring. }
  assert (moved_end : forall v w s, equal_vectors v w -> lies_on v s -> lies_on w s).
  { intros v w s [xs ys] (o & range_o & x_on & y_on). exists o. split; [exact range_o |].
    now rewrite <- xs, <- ys. }
  apply (moved_end z (on_ray (r * first))) in on_j; [| exact z_is].
  destruct (Qlt_le_dec 0 r) as [r_positive | r_zero].
  - assert (0 < r * first) by (apply Qmult_lt_0_compat; assumption).
    destruct (in_met j (r * first) J) as [j_met place_is]; trivial.
    specialize (least j j_met). fold first in least. rewrite <- place_is in least.
    assert (r_is : r == 1) by nra.
    assert (on_j' : lies_on (on_ray first) (edge chain j)).
    { apply (moved_end (on_ray (r * first))); [| exact on_j].
      unfold equal_vectors, on_ray. cbn [vx vy]. rewrite r_is. split; ring. }
    assert (on_m : lies_on (on_ray first) (edge chain m)).
    { rewrite edge_is by exact m_below. apply (on_segment _ _ _ part); [lra | exact there]. }
    assert (no_vertex : forall i, (i < n)%nat -> ~ equal_vectors (on_ray first) (vertex chain i)).
    { intros i I [xi yi]. apply (between_vertices i I). unfold cross, from_x, on_ray, minus in *.
      cbn [vx vy] in *. rewrite <- xi, <- yi. ring. }
    destruct chain_simple as (_ & _ & common).
    destruct (common j m (on_ray first) J m_below differ on_j' on_m) as [[_ at_vertex] | [_ at_vertex]];
      revert at_vertex; now apply no_vertex.
  - apply (off_edge j J). apply (moved_end (on_ray (r * first))); [| exact on_j].
    assert (r_is : r == 0) by lra. unfold equal_vectors, on_ray. cbn [vx vy]. rewrite r_is. split; ring.
Qed.

End Ray.
