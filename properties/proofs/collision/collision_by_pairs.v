(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Sections 5.1, 5.1.1 and 5.1.2 in general position: however the pairs of edges that meet are found, by testing all,
   by a sweep or by hierarchies of boxes, built once and moved by x (pairs_of_edges.v), there is such a pair, or a
   vertex of one region inside the other, if and only if the interiors of P and -Q + x meet. *)
From Coq Require Import ZArith Lia Bool List Permutation.
From Oplus Require Import numbers regions_and_sums reflected parallelogram segments_apart section_5_1 pairs_of_edges.
Import ListNotations.

Open Scope Q_scope.

(* By signs of coordinates. *)
Definition meets_moved (x : vector) (s t : segment) : bool :=
  negb (zero (vx (along s)) && zero (vy (along s))) &&
  negb (are_apart (source s) (target s) (plus (source t) x) (plus (target t) x)).

Lemma on_moved_edge (x z : vector) (t : segment) :
  lies_on z (Segment (plus (source t) x) (plus (target t) x)) <-> lies_on (minus z x) t.
Proof.
  unfold lies_on, plus, minus. cbn [source target vx vy]. split; intros (k & range & X & Y); exists k; split;
    trivial; lra.
Qed.

Lemma meets_moved_is (x : vector) (s t : segment) : nonzero (along s) ->
  (meets_moved x s t = true <-> do_meet x s t).
Proof.
  intros long. unfold meets_moved.
  destruct (are_apart_decides (source s) (target s) (plus (source t) x) (plus (target t) x) long) as [one not_both].
  assert (same_ : have_a_common_point (source s) (target s) (plus (source t) x) (plus (target t) x) <-> do_meet x s t).
  { unfold do_meet. split; intros (z & on_s & on_t); exists z; split;
      try (now apply on_moved_edge); destruct s; exact on_s. }
  rewrite same_ in *. destruct (zero_spec (vx (along s))), (zero_spec (vy (along s))); cbn [negb andb];
    try (exfalso; now apply long); rewrite negb_true_iff, <- not_true_iff_false; tauto.
Qed.

Lemma meets_moved_is_sound (x : vector) (s t : segment) : meets_moved x s t = true -> do_meet x s t.
Proof.
  intros yes. apply meets_moved_is; [| exact yes]. unfold meets_moved in yes. intros [X Y].
  destruct (zero_spec (vx (along s))), (zero_spec (vy (along s))); try contradiction. discriminate.
Qed.

Section Regions.
  Variables p q : region.
  Variable x : vector.
  Hypothesis p_region : valid_region p.
  Hypothesis q_region : valid_region q.
  Hypothesis general : off_vertex_edge_sum x p q.

  Let of_p := region_edges p.
  Let of_q := map (reflected (Vector 0 0)) (region_edges q).

  Lemma naive_collision_test : interiors_meet x p q <->
    (exists s f, In (s, f) (all_pairs_tested (meets_moved x) of_p of_q)) \/
    a_vertex_is_inside x p q \/ a_vertex_is_inside x q p.
  Proof.
    rewrite (collision_in_general_position p q x p_region q_region general).
    assert (pairs_ : edges_cross x p q <-> exists s f, In (s, f) (all_pairs_tested (meets_moved x) of_p of_q));
      [| tauto].
    assert (tested : forall s f, In (s, f) (all_pairs_tested (meets_moved x) of_p of_q) <->
      (In s of_p /\ In f of_q) /\ do_meet x s f).
    { intros s f. unfold all_pairs_tested. rewrite filter_In, in_prod_iff. cbn [fst snd]. split.
      - intros [listed yes]. split; [exact listed | now apply meets_moved_is_sound].
      - intros [[S F] common]. split; [now split |]. apply meets_moved_is; [| exact common].
        exact (region_edges_are_directions p (proj1 p_region) s S). }
    split.
    - intros (e & f & E & F & v & w & on_e & on_f & X & Y). exists e, (reflected (Vector 0 0) f). apply tested.
      split; [split; [exact E | now apply in_map] |]. exists v. split; [exact on_e |]. apply on_reflected.
      apply (lies_on_equal w); [| exact on_f]. unfold plus, minus in *. split; cbn [vx vy] in *; lra.
    - intros (s & g & found). apply tested in found. destruct found as [[S G] (z & on_s & on_g)].
      apply in_map_iff in G. destruct G as (f & <- & F). apply (proj1 (on_reflected _ _ _)) in on_g. exists s, f.
        split; [exact S |].
      split; [exact F |]. exists z, (minus (Vector 0 0) (minus z x)). split; [exact on_s |]. split; [exact on_g |].
      unfold plus, minus. split; cbn [vx vy]; ring.
  Qed.
End Regions.

(* Theorem, Section 5.1: the naive test. *)
Theorem collision_by_all_pairs (p q : region) (x : vector) :
  valid_region p -> valid_region q -> off_vertex_edge_sum x p q ->
  let of_p := region_edges p in
  let of_q := map (reflected (Vector 0 0)) (region_edges q) in
  (interiors_meet x p q <->
   (exists s f, In (s, f) (all_pairs_tested (meets_moved x) of_p of_q)) \/
   a_vertex_is_inside x p q \/ a_vertex_is_inside x q p).
Proof. exact (naive_collision_test p q x). Qed.

(* Theorem, Section 5.1.2. *)
Theorem collision_by_hierarchies (p q : region) (x : vector) (t u : hierarchy) :
  valid_region p -> valid_region q -> off_vertex_edge_sum x p q -> is_boxed t -> is_boxed u ->
  (forall s, In s (edges_of_hierarchy t) <-> In s (region_edges p)) ->
  (forall s, In s (edges_of_hierarchy u) <-> In s (map (reflected (Vector 0 0)) (region_edges q))) ->
  (interiors_meet x p q <->
   (exists s f, In (s, f) (pairs_by_hierarchy x (meets_moved x) t u)) \/
   a_vertex_is_inside x p q \/ a_vertex_is_inside x q p).
Proof.
  intros p_region q_region general T U edges_t edges_u.
  rewrite (collision_by_all_pairs p q x p_region q_region general). cbv zeta.
  enough (same_ : forall s f, In (s, f) (pairs_by_hierarchy x (meets_moved x) t u) <->
    In (s, f) (all_pairs_tested (meets_moved x) (region_edges p) (map (reflected (Vector 0 0)) (region_edges q))))
    by (setoid_rewrite same_; tauto).
  intros s f. rewrite (hierarchies_find_all_pairs x _ t u (meets_moved_is_sound x) T U s f).
  unfold all_pairs_tested. rewrite !filter_In, !in_prod_iff, edges_t, edges_u. tauto.
Qed.

(* Theorem, Section 5.1.1. *)
Theorem collision_by_sweep (p q : region) (x : vector) (events : list swept_edge) :
  valid_region p -> valid_region q -> off_vertex_edge_sum x p q -> are_swept_upwards x events ->
  Permutation events (map (pair true) (region_edges p) ++
    map (pair false) (map (reflected (Vector 0 0)) (region_edges q))) ->
  (interiors_meet x p q <->
   (exists s f, In (s, f) (pairs_by_sweep x (meets_moved x) events [])) \/
   a_vertex_is_inside x p q \/ a_vertex_is_inside x q p).
Proof.
  intros p_region q_region general order all.
  rewrite (collision_by_all_pairs p q x p_region q_region general). cbv zeta.
  setoid_rewrite (sweep_finds_all_pairs x _ _ _ events (meets_moved_is_sound x) order all). tauto.
Qed.
