(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* A chain whose corners are cut: each vertex is replaced by two points near it, one on each of its edges, on a small
   strictly convex curve around the vertex. What the cut chain's vertices and edges are, where they are, and that it
   turns as the chain does. For touching_chains.v. *)
From Coq Require Import ZArith Lia Bool List.
From Oplus Require Import numbers convolution small_numbers neighbourhoods regions meeting_of_segments simple_chain
  strictly_convex_curve chords_around_a_point.
Import ListNotations.

Open Scope Q_scope.

(* The rays of a pass through a vertex: back along the edge before it, and out along the edge after it. *)
Definition ray_back (chain : list vector) (i : nat) : vector :=
  minus (vertex chain (previous (length chain) i)) (vertex chain i).
Definition ray_out (chain : list vector) (i : nat) : vector :=
  minus (vertex chain (next i (length chain))) (vertex chain i).

Definition before_corner (chain : list vector) (e : Q) (i : nat) : vector :=
  moved_along (vertex chain i) (on_curve (ray_back chain i)) e.
Definition after_corner (chain : list vector) (e : Q) (i : nat) : vector :=
  moved_along (vertex chain i) (on_curve (ray_out chain i)) e.

Definition with_cut_corners (chain : list vector) (e : Q) : list vector :=
  flat_map (fun i => [before_corner chain e i; after_corner chain e i]) (seq 0 (length chain)).

Lemma two_each (A : Type) (f g : nat -> A) (d : A) : forall n k i, (i < n)%nat ->
  nth (2 * i) (flat_map (fun i => [f i; g i]) (seq k n)) d = f (k + i)%nat /\
  nth (2 * i + 1) (flat_map (fun i => [f i; g i]) (seq k n)) d = g (k + i)%nat.
Proof.
  induction n as [| n IH]; intros k i I; [lia |]. cbn [seq flat_map app]. destruct i as [| i].
  - rewrite Nat.add_0_r. now split.
  - replace (2 * S i)%nat with (S (S (2 * i))) by lia. cbn [nth Nat.add]. destruct (IH (S k) i ltac:(lia)) as [-> ->].
    now replace (S k + i)%nat with (k + S i)%nat by lia.
Qed.

Lemma cut_length (chain : list vector) (e : Q) : length (with_cut_corners chain e) = (2 * length chain)%nat.
Proof.
  unfold with_cut_corners. rewrite <- (seq_length (length chain) 0) at 2. generalize (seq 0 (length chain)). intros l.
  induction l as [| i l IH]; [reflexivity |]. cbn [flat_map app length]. lia.
Qed.

Lemma cut_vertices (chain : list vector) (e : Q) (i : nat) : (i < length chain)%nat ->
  vertex (with_cut_corners chain e) (2 * i) = before_corner chain e i /\
  vertex (with_cut_corners chain e) (2 * i + 1) = after_corner chain e i.
Proof. intros I. exact (two_each vector _ _ nowhere (length chain) 0 i I). Qed.

Lemma next_of_two (n i : nat) : (i < n)%nat ->
  next (2 * i) (2 * n) = (2 * i + 1)%nat /\ next (2 * i + 1) (2 * n) = (2 * next i n)%nat.
Proof.
  intros I. unfold next. destruct (Nat.eqb_spec (S (2 * i)) (2 * n)), (Nat.eqb_spec (S (2 * i + 1)) (2 * n)),
    (Nat.eqb_spec (S i) n); lia.
Qed.

Lemma previous_of_two (n i : nat) : (i < n)%nat ->
  previous (2 * n) (2 * i) = (2 * previous n i + 1)%nat /\ previous (2 * n) (2 * i + 1) = (2 * i)%nat.
Proof. intros I. unfold previous. destruct i as [| i]; cbn [Nat.mul Nat.add]; [lia |]. split; lia. Qed.

Lemma one_of_two (n j : nat) : (j < 2 * n)%nat -> exists i, (i < n)%nat /\ (j = (2 * i)%nat \/ j = (2 * i + 1)%nat).
Proof.
  intros J. exists (Nat.div2 j). pose proof (Nat.div2_odd j) as parts.
  destruct (Nat.odd j); cbn [Nat.b2n] in parts; lia.
Qed.

Lemma sum_of_twos (f : nat -> Z) : forall n,
  sum (map f (seq 0 (2 * n))) = sum (map (fun i => (f (2 * i)%nat + f (2 * i + 1)%nat)%Z) (seq 0 n)).
Proof.
  induction n as [| n IH]; [reflexivity |]. replace (2 * S n)%nat with (2 * n + 2)%nat by lia.
  rewrite seq_app, map_app, sum_of_both, IH, (seq_S n 0), map_app, sum_of_both. f_equal. rewrite !Nat.add_0_l.
  cbn [seq map]. unfold sum. cbn [fold_right]. replace (S (2 * n)) with (2 * n + 1)%nat by lia. lia.
Qed.

Lemma corners_by_index (chain : list vector) :
  corners chain = map (corner_of_chain chain) (seq 0 (length chain)).
Proof.
  apply (nth_ext _ _ (Corner nowhere nowhere) (Corner nowhere nowhere)).
  - now rewrite corners_length, map_length, seq_length.
  - intros i I. rewrite corners_length in I.
    rewrite (nth_indep _ _ (corner_of_chain chain 0)) by now rewrite corners_length.
    rewrite (nth_indep (map _ _) _ (corner_of_chain chain 0)) by now rewrite map_length, seq_length.
    rewrite map_nth, seq_nth by exact I. unfold corner_of_chain at 1. apply nth_indep. now rewrite corners_length.
Qed.

Section Corners.
  Variable chain : list vector.
  Let n := length chain.
  Hypothesis turn : turns_everywhere chain.

  Lemma ray_out_is (i : nat) : (i < n)%nat -> ray_out chain i = edge_of_chain chain i.
  Proof. intros I. unfold ray_out. now rewrite edge_of_chain_joins_vertices. Qed.

  Lemma ray_back_is (i : nat) : (i < n)%nat ->
    equal_vectors (ray_back chain i) (opposite (edge_of_chain chain (previous n i))).
  Proof.
    intros I. rewrite edge_of_chain_joins_vertices by now apply previous_below. fold n.
    rewrite next_previous by exact I. unfold ray_back, equal_vectors, opposite, minus. cbn [vx vy]. fold n. split; ring.
  Qed.

  Lemma turns_at_a_corner (i : nat) : (i < n)%nat -> turns (edge_of_chain chain (previous n i)) (edge_of_chain chain i).
  Proof.
    intros I. pose proof (turn (corner_of_chain chain i) ltac:(apply nth_In; now rewrite corners_length)) as at_corner.
    now rewrite corner_is in at_corner by exact I.
  Qed.

  Lemma rays_are_some (i : nat) : (i < n)%nat -> nonzero (ray_back chain i) /\ nonzero (ray_out chain i).
  Proof.
    intros I. destruct (turns_at_a_corner i I) as (some_in & some_out & _). rewrite ray_out_is by exact I.
    split; [| exact some_out]. destruct (ray_back_is i I) as [X Y]. intros [X' Y']. apply some_in.
    unfold opposite in X, Y. cbn [vx vy] in X, Y. split; lra.
  Qed.

  (* Both ends of the edge from vertex i, seen from each other. *)
  Lemma ray_back_of_next (i : nat) : (i < n)%nat ->
    equal_vectors (ray_back chain (next i n)) (opposite (ray_out chain i)).
  Proof.
    intros I. unfold ray_back, ray_out, equal_vectors, opposite, minus. fold n. rewrite previous_next by exact I.
    cbn [vx vy]. split; ring.
  Qed.

  (* The part that is left of an edge is inside the edge, and on the rays from both ends, not nearer than the curve. *)
  Definition is_small (e : Q) : Prop := 0 < e /\ forall i, (i < n)%nat ->
    e * (1 / gauge (ray_out chain i)) < 1 # 2 /\ e * (1 / gauge (ray_back chain i)) < 1 # 2.

  Lemma eventually_small : eventually is_small.
  Proof.
    assert (each : forall i, In i (seq 0 n) -> eventually (fun e =>
      e * (1 / gauge (ray_out chain i)) < 1 # 2 /\ e * (1 / gauge (ray_back chain i)) < 1 # 2)).
    { intros i _. apply eventually_and.
      - refine (eventually_implied _ _ _ (eventually_positive (1 # 2) (- (1 / gauge (ray_out chain i))) _));
          lra || intros; lra.
      - refine (eventually_implied _ _ _ (eventually_positive (1 # 2) (- (1 / gauge (ray_back chain i))) _));
          lra || intros; lra. }
    refine (eventually_implied _ _ _ (eventually_and _ _ (eventually_below 1 ltac:(lra)) (eventually_for_all _ _
      each))).
    intros e [[some _] small]. split; [exact some |]. intros i I. apply small, in_seq. lia.
  Qed.

  Lemma short_edges (e : Q) (i : nat) (x : vector) : is_small e -> (i < n)%nat ->
    lies_on x (Segment (after_corner chain e i) (before_corner chain e (next i n))) ->
    strictly_inside x (edge_at chain i) /\
    (exists s, e <= s /\ equal_vectors x (moved_along (vertex chain i) (on_curve (ray_out chain i)) s)) /\
    (exists s, e <= s /\
       equal_vectors x (moved_along (vertex chain (next i n)) (on_curve (ray_back chain (next i n))) s)).
  Proof.
    intros [some small] I (t & range & X & Y). pose proof (next_in_range i n I) as J.
    destruct (small i I) as [small_out _], (small (next i n) J) as [_ small_back].
    destruct (rays_are_some i I) as [_ some_out], (rays_are_some (next i n) J) as [some_back _].
    pose proof (gauge_is_positive _ some_out) as g_positive. pose proof (gauge_is_positive _ some_back) as h_positive.
    destruct (ray_back_of_next i I) as [back_x back_y].
    assert (k_positive : 0 < 1 / gauge (ray_out chain i)) by (apply Qlt_shift_div_l; lra).
    assert (l_positive : 0 < 1 / gauge (ray_back chain (next i n))) by (apply Qlt_shift_div_l; lra).
    unfold after_corner, before_corner, on_curve, stretched, moved_along in *. cbn [source target vx vy] in *.
    set (k := 1 / gauge (ray_out chain i)) in *. set (l := 1 / gauge (ray_back chain (next i n))) in *.
    set (u := ray_out chain i) in *. set (w := ray_back chain (next i n)) in *.
    assert (v_x : vx (vertex chain (next i n)) == vx (vertex chain i) + vx u) by (unfold u, ray_out, minus; cbn [vx];
      fold n; ring).
    assert (v_y : vy (vertex chain (next i n)) == vy (vertex chain i) + vy u) by (unfold u, ray_out, minus; cbn [vy];
      fold n; ring).
    rewrite edge_is by exact I. fold n. unfold opposite in back_x, back_y. cbn [vx vy] in back_x, back_y.
    clearbody k l u w. set (p := (1 - t) * (e * k) + t * (1 - e * l)).
    assert (p_x : vx x == vx (vertex chain i) + p * vx u) by (rewrite X, back_x, v_x; unfold p; ring).
    assert (p_y : vy x == vy (vertex chain i) + p * vy u) by (rewrite Y, back_y, v_y; unfold p; ring).
    assert (low : e * k <= p) by (unfold p; nra). assert (high : p <= 1 - e * l) by (unfold p; nra). clearbody p.
    assert (k_inverse : 1 / k * k == 1) by (field; lra). assert (l_inverse : 1 / l * l == 1) by (field; lra).
    assert (0 < 1 / k) by (apply Qlt_shift_div_l; lra). assert (0 < 1 / l) by (apply Qlt_shift_div_l; lra).
    set (k' := 1 / k) in *. set (l' := 1 / l) in *. clearbody k' l'.
    split; [| split].
    - exists p. split; [nra |]. cbn [source target]. rewrite p_x, p_y, v_x, v_y. split; ring.
    - exists (p * k'). split; [nra |]. unfold equal_vectors. cbn [vx vy].
      setoid_replace (p * k' * (k * vx u)) with (p * (k' * k) * vx u) by ring.
      setoid_replace (p * k' * (k * vy u)) with (p * (k' * k) * vy u) by ring. rewrite k_inverse, p_x, p_y. split; ring.
    - exists ((1 - p) * l'). split; [nra |]. unfold equal_vectors. cbn [vx vy].
      setoid_replace ((1 - p) * l' * (l * vx w)) with ((1 - p) * (l' * l) * vx w) by ring.
      setoid_replace ((1 - p) * l' * (l * vy w)) with ((1 - p) * (l' * l) * vy w) by ring.
      rewrite l_inverse, back_x, back_y, v_x, v_y, p_x, p_y. split; ring.
  Qed.

  (* The directions of the cut chain's edges: parts of edges, and sums of parts of the two edges at a vertex. *)
  Lemma short_edge_direction (e : Q) (i : nat) : is_small e -> (i < n)%nat ->
    exists k, 0 < k /\ equal_vectors (minus (before_corner chain e (next i n)) (after_corner chain e i))
                         (stretched k (edge_of_chain chain i)).
  Proof.
    intros [some small] I. pose proof (next_in_range i n I) as J.
    destruct (small i I) as [small_out _], (small (next i n) J) as [_ small_back].
    exists (1 - e * (1 / gauge (ray_out chain i)) - e * (1 / gauge (ray_back chain (next i n)))). split; [lra |].
    destruct (ray_back_of_next i I) as [back_x back_y]. rewrite <- ray_out_is by exact I.
    unfold before_corner, after_corner, on_curve, stretched, moved_along, equal_vectors. cbn [vx vy].
    unfold opposite in back_x, back_y. cbn [vx vy] in back_x, back_y.
    assert (v_x : vx (vertex chain (next i n)) == vx (vertex chain i) + vx (ray_out chain i))
      by (unfold ray_out, minus; cbn [vx]; fold n; ring).
    assert (v_y : vy (vertex chain (next i n)) == vy (vertex chain i) + vy (ray_out chain i))
      by (unfold ray_out, minus; cbn [vy]; fold n; ring).
    unfold minus. cbn [vx vy]. rewrite back_x, back_y, v_x, v_y. split; ring.
  Qed.

  Lemma chord_direction (e : Q) (i : nat) : 0 < e -> (i < n)%nat ->
    exists k l, 0 < k /\ 0 < l /\ equal_vectors (minus (after_corner chain e i) (before_corner chain e i))
      (vector_sum (stretched k (edge_of_chain chain (previous n i))) (stretched l (edge_of_chain chain i))).
  Proof.
    intros some I. destruct (rays_are_some i I) as [some_back some_out].
    assert (0 < 1 / gauge (ray_back chain i)) by (apply Qlt_shift_div_l; [now apply gauge_is_positive | lra]).
    assert (0 < 1 / gauge (ray_out chain i)) by (apply Qlt_shift_div_l; [now apply gauge_is_positive | lra]).
    exists (e * (1 / gauge (ray_back chain i))), (e * (1 / gauge (ray_out chain i))).
    split; [now apply products |]. split; [now apply products |].
    destruct (ray_back_is i I) as [back_x back_y]. rewrite <- (ray_out_is i I).
    unfold before_corner, after_corner, on_curve, moved_along, equal_vectors. unfold stretched, vector_sum, minus.
    cbn [vx vy]. unfold opposite in back_x, back_y. cbn [vx vy] in back_x, back_y. rewrite back_x, back_y. split; ring.
  Qed.
End Corners.
