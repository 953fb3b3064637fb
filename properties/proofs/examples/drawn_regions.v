(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Regions that one can draw, to which the theorems are applied, so that no hypothesis is empty: a square, and a
   larger one with a square hole; the room with a hatch and the diamond that just fits through it (README.md); a
   chamber and a diamond that just fits into it; a square with a hole that touches its side. And how points near them
   are located: coordinates may be unknown but for bounds, then each comparison is decided by linear arithmetic. *)
From Coq Require Import QArith Lqa ZArith Lia Bool List.
From Oplus Require Import convolution convolution_winding regions meeting_of_segments interiors_meet neighbourhoods
  left_of_an_edge theorem_4_2_1 theorem_2_2_10 boundary_points small_polygons simple_polygons simple_chain
  simple_chains_turn_once location test_of_regions small_regions collision_is_complete checked_collision
  polygons_of_the_thesis.
Import ListNotations.

Open Scope Q_scope.

(* The room has a hatch from (3, 5) to (4, 6), the diamond has the same width. *)
Definition room : list vector :=
  points_at [(0, 0); (7, 0); (7, 6); (4, 6); (4, 5); (6, 5); (6, 1); (1, 1); (1, 5); (3, 5); (3, 6); (0, 6)].
Definition fitting_diamond : list vector := points_at [(0, 0); (1 # 2, - (1 # 2)); (1, 0); (1 # 2, 1 # 2)].

(* A square of side 6 with a square hole of side 2, and the diamond that touches all four sides of this hole. *)
Definition chamber : region := square_with_hole.
Definition inscribed_diamond : list vector := points_at [(-1, 0); (0, -1); (1, 0); (0, 1)].

Lemma drawn_polygons : simple_polygon square /\ simple_polygon room /\ simple_polygon fitting_diamond /\
  simple_polygon inscribed_diamond /\ simple_polygon letter_l.
Proof. repeat split; apply is_simple_decides; vm_compute; reflexivity. Qed.

(* The hole of the chamber, and the hole that touches the side, where both have a vertex. *)
Lemma drawn_regions : valid_region chamber /\ chains_do_not_touch chamber /\ nowhere_above_one chamber /\
  valid_region square_with_touching_hole.
Proof.
  assert (once : covers_nothing_twice chamber = true) by (vm_compute; reflexivity).
  apply covers_nothing_twice_is_right in once. destruct once as [valid once].
  split; [exact valid |]. split; [apply does_not_touch_is_right; vm_compute; reflexivity |]. split; [exact once |].
  apply is_valid_region_is_right. vm_compute. reflexivity.
Qed.

Lemma square_is_a_region : valid_region [square].
Proof. apply simple_polygons_are_regions, drawn_polygons. Qed.

(* Points with known coordinates. *)
Lemma off_by_computation (x : vector) (segments : list segment) :
  existsb (is_on_segment x) segments = false -> off x segments.
Proof.
  intros none s I on. assert (found : existsb (is_on_segment x) segments = true); [| congruence].
  apply existsb_exists. exists s. split; [exact I |]. now destruct (is_on_spec x s).
Qed.

Lemma inside_by_computation (x : vector) (r : region) : locate x r = Inside -> inside x r.
Proof. intros found. pose proof (locate_returns x r) as said. now rewrite found in said. Qed.

Lemma on_edge_by_computation (x : vector) (s : segment) : is_on_segment x s = true -> lies_on x s.
Proof. now destruct (is_on_spec x s). Qed.

Definition is_corner (w : vector) (r : region) : bool :=
  existsb (fun s => Qeq_bool (vx w) (vx (source s)) && Qeq_bool (vy w) (vy (source s))) (region_edges r).

Lemma no_vertex_by_computation (w : vector) (r : region) : is_corner w r = false -> ~ is_vertex w r.
Proof.
  intros none (s & I & X & Y). assert (found : is_corner w r = true); [| congruence].
  apply existsb_exists. exists s. split; [exact I |]. rewrite andb_true_iff, !Qeq_bool_iff. now split.
Qed.

(* Points with unknown coordinates, off known segments and with a known winding number. *)
Ltac computed_segments :=
  repeat match goal with
  | |- context [region_edges ?r] =>
      let l := eval vm_compute in (region_edges r) in change (region_edges r) with l
  | |- context [edges ?chain] => let l := eval vm_compute in (edges chain) in change (edges chain) with l
  | |- context [convolution_segments ?p ?q] =>
      let l := eval vm_compute in (convolution_segments p q) in change (convolution_segments p q) with l
  end.

Ltac off_by_arithmetic :=
  computed_segments;
  let s := fresh "s" in let I := fresh "I" in intros s I; cbn in I;
  repeat match goal with H : _ \/ _ |- _ => destruct H as [H | H] end; try contradiction; subst s;
  let t := fresh "t" in intros (t & ? & ? & ?); cbn [source target vx vy] in *; lra.

Ltac number_by_arithmetic :=
  computed_segments; unfold winding_number, sum; cbn [map fold_right];
  unfold signed_crossing, orientation; cbn [source target vx vy];
  repeat match goal with
  | |- context [at_most ?a ?b] => destruct (at_most_spec a b); try (exfalso; lra); cbn [ray_crossing Bool.eqb]
  | |- context [?a ?= ?b] => destruct (Qcompare_spec a b); try (exfalso; lra); cbn [ray_crossing Bool.eqb]
  end;
  try reflexivity.

(* No point of a region is lower than all its vertices. *)
Lemma lowest_point (r : region) (height : Q) (a : vector) :
  (forall s, In s (region_edges r) -> height <= vy (source s) /\ height <= vy (target s)) ->
  in_region a r -> height <= vy a.
Proof.
  intros above [positive_ | (s & I & t & range & _ & Y)].
  - destruct (Qlt_le_dec (vy a) height) as [lower |]; [exfalso | assumption].
    assert (none : winding_number a (region_edges r) = 0%Z); [| lia].
    clear positive_. unfold winding_number. induction (region_edges r) as [| s l IH]; [reflexivity |].
    cbn [map sum fold_right]. unfold sum in IH. rewrite IH by (intros u J; apply above; now right).
    destruct (above s (or_introl eq_refl)) as [low_source low_target].
    unfold signed_crossing. destruct (at_most_spec (vy (source s)) (vy a)); [lra |].
    destruct (at_most_spec (vy (target s)) (vy a)); [lra |]. reflexivity.
  - destruct (above s I) as [low_source low_target]. rewrite Y.
    assert (0 <= (1 - t) * (vy (source s) - height)) by (apply Qmult_le_0_compat; lra).
    assert (0 <= t * (vy (target s) - height)) by (apply Qmult_le_0_compat; lra). lra.
Qed.

Definition is_not_below (height : Q) (r : region) : bool :=
  forallb (fun s => Qle_bool height (vy (source s)) && Qle_bool height (vy (target s))) (region_edges r).

(* So nothing of a sum is lower than P's and Q's lowest vertices together, and what is as low is on its boundary. *)
Lemma nothing_is_lower (p q : region) (low_p low_q : Q) (x : vector) :
  is_not_below low_p p = true -> is_not_below low_q q = true -> vy x < low_p + low_q -> ~ in_sum x p q.
Proof.
  unfold is_not_below. rewrite !forallb_forall. intros above_p above_q lower (a & b & in_p & in_q & _ & Y).
  unfold plus in Y. cbn [vy] in Y.
  assert (low_p <= vy a).
  { apply (lowest_point p); [| exact in_p]. intros s I. specialize (above_p s I).
    rewrite andb_true_iff, !Qle_bool_iff in above_p. exact above_p. }
  assert (low_q <= vy b).
  { apply (lowest_point q); [| exact in_q]. intros s I. specialize (above_q s I).
    rewrite andb_true_iff, !Qle_bool_iff in above_q. exact above_q. }
  lra.
Qed.

Lemma lowest_points_are_on_the_boundary (p q : region) (low_p low_q : Q) (x : vector) :
  is_not_below low_p p = true -> is_not_below low_q q = true -> in_sum x p q -> vy x == low_p + low_q ->
  on_boundary_of_sum x p q.
Proof.
  intros above_p above_q in_ low radius R. split.
  - exists x. split; [unfold within; lra | exact in_].
  - exists (Vector (vx x) (vy x - (1 # 2) * radius)). split; [unfold within; cbn [vx vy]; lra |].
    apply (nothing_is_lower p q low_p low_q); trivial. cbn [vy]. lra.
Qed.

(* Whether x is on no sum of a vertex and an edge. *)
Definition is_off_vertex_edge_sum (x : vector) (p q : region) : bool :=
  forallb (fun e => forallb (fun f =>
    negb (is_on_segment (minus x (source e)) f || is_on_segment (minus x (target e)) f ||
          is_on_segment (minus x (source f)) e || is_on_segment (minus x (target f)) e))
    (region_edges q)) (region_edges p).

Lemma general_position_by_computation (x : vector) (p q : region) :
  is_off_vertex_edge_sum x p q = true -> off_vertex_edge_sum x p q.
Proof.
  unfold is_off_vertex_edge_sum. rewrite forallb_forall. intros all e f E F. specialize (all e E).
  rewrite forallb_forall in all. specialize (all f F). rewrite negb_true_iff, !orb_false_iff in all.
  destruct all as [[[source_e target_e] source_f] target_f].
  repeat split; intros on; match goal with
  | none : is_on_segment ?w ?s = false |- _ => now destruct (is_on_spec w s); [discriminate none | contradiction]
  end.
Qed.

(* Whether no two vertices of P and Q add up to x. *)
Definition is_no_sum_of_vertices (x : vector) (p q : region) : bool :=
  forallb (fun e => negb (is_corner (minus x (source e)) q)) (region_edges p).

Lemma no_sum_of_vertices_by_computation (x : vector) (p q : region) : is_no_sum_of_vertices x p q = true ->
  forall w u, is_vertex w p -> is_vertex u q -> ~ equal_vectors x (plus w u).
Proof.
  unfold is_no_sum_of_vertices. rewrite forallb_forall. intros all w u (e & E & WX & WY) (f & F & UX & UY) [X Y].
  specialize (all e E). rewrite negb_true_iff in all. apply (no_vertex_by_computation _ q all).
  exists f. split; [exact F |]. unfold plus, minus in *. cbn [vx vy] in *. split; cbn [vx vy]; lra.
Qed.
