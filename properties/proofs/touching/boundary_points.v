(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Common points of P and -Q + x, and when the interiors of the two have one, too: if a point is inside one of them, or
   if an edge lies along a side of the other that is filled near it (inside_a_corner.v), in the opposite direction. *)
From Coq Require Import ZArith Lia Bool List Arith.
From Oplus Require Import numbers convolution signed_crossings tie_rule regions weight winding_number_of_the_sum
  meeting_of_segments interiors_meet neighbourhoods left_of_an_edge theorem_4_2_1 inside_a_corner tangent_direction.
Import ListNotations.

Open Scope Q_scope.

(* At each vertex only the two edges of its chain meet. *)
Definition chains_do_not_touch (r : region) : Prop :=
  forall chain i, In chain r -> (i < length chain)%nat ->
    meet_in_vertex (edge_at chain (previous (length chain) i)) (edge_at chain i) r.

Lemma vertex_or_not (w : vector) (r : region) : is_vertex w r \/ ~ is_vertex w r.
Proof.
  destruct (Exists_dec (fun s => equal_vectors w (source s)) (region_edges r)) as [some | none].
  - intros s. unfold equal_vectors. destruct (Qeq_dec (vx w) (vx (source s))), (Qeq_dec (vy w) (vy (source s))); tauto.
  - left. now apply Exists_exists.
  - right. intros vertex. now apply none, Exists_exists.
Qed.

(* Edges one of which begins where the other ends do not lie along each other. *)
Lemma consecutive_edges_turn (r : region) (f_in f_out : segment) :
  valid_region r -> In f_in (region_edges r) -> In f_out (region_edges r) ->
  equal_vectors (target f_in) (source f_out) -> turns (along f_in) (along f_out).
Proof.
  intros (not_points & valid & meet) I J [tx ty].
  pose proof (region_edges_are_directions r not_points f_in I) as long_in.
  pose proof (region_edges_are_directions r not_points f_out J) as long_out.
  split; [exact long_in |]. split; [exact long_out |]. intros parallel. apply Qnot_le_lt. intros back.
  pose proof (square_positive _ long_in) as square. pose proof (square_positive _ long_out) as square_out.
  assert (alone : forall v, lies_on v f_in -> lies_on v f_out -> is_vertex v r).
  { intros v on_in on_out. destruct (in_split _ _ J) as (earlier & later & edges_are).
    apply (meet earlier f_out later f_in v edges_are); trivial.
    rewrite edges_are in I. apply in_elt_inv in I. destruct I as [same_ | I]; [exfalso | exact I].
    rewrite same_ in back. lra. }
  destruct (multiple_of (along f_out) (along f_in) long_in) as (c & X & Y); [unfold cross in *; lra |].
  assert (c_range : c < 0) by (unfold dot in *; rewrite X, Y in back, square_out; nra).
  destruct (Qlt_le_dec c (-1)) as [longer | shorter].
  - destruct (no_vertex_near r f_in (target f_in) 1 long_in (target_lies_on f_in)) as (v & _ & on & no_vertex); [lra |].
    apply no_vertex, alone; [exact on |]. destruct on as (k & range & vx_is & vy_is).
    exists ((1 - k) / - c). assert (value : (1 - k) / - c * - c == 1 - k) by (field; lra).
    set (h := (1 - k) / - c) in *. clearbody h. split; [split; nra |]. in_coordinates. split; by_equations.
  - destruct (no_vertex_near r f_out (source f_out) 1 long_out (source_lies_on f_out)) as (v & _ & on & no_vertex);
      [lra |].
    apply no_vertex, alone; [| exact on]. destruct on as (k & range & vx_is & vy_is).
    exists (1 + k * c). split; [nra |]. in_coordinates. split; by_equations.
Qed.

(* An inner point of P and a point of Q have inner points of both near them. *)
Lemma inner_point_and_point (p q : region) (x a b : vector) :
  is_regular q -> inside a p -> in_region b q -> equal_vectors x (plus a b) -> interiors_meet x p q.
Proof.
  intros regular [free positive_] in_q [X Y].
  destruct (winding_number_near a _ (region_cycles p) free) as (radius & R & near).
  destruct (inside_near q b radius regular in_q R) as (b' & close & inside_q).
  exists (minus x b'). unfold plus in X, Y; cbn [vx vy] in X, Y. split.
  - destruct (near (minus x b')) as [free_a same_number].
    + unfold within, minus in *; cbn [vx vy]. lra.
    + split; [exact free_a | lia].
  - refine (inside_equal _ _ _ _ inside_q). unfold minus. split; cbn [vx vy]; ring.
Qed.

Lemma interiors_meet_other_way (p q : region) (x : vector) : interiors_meet x p q -> interiors_meet x q p.
Proof.
  intros (z & in_p & in_q). exists (minus x z). split; [exact in_q |].
  refine (inside_equal _ _ _ _ in_p). unfold minus. split; cbn [vx vy]; ring.
Qed.

Lemma sum_in_other_order (x w u : vector) : equal_vectors x (plus w u) -> equal_vectors x (plus u w).
Proof. intros [X Y]. unfold plus in *; cbn [vx vy] in *. split; cbn [vx vy]; lra. Qed.

(* Of points that add up to x, both are on boundaries, or the interiors meet. *)
Lemma both_on_boundaries_or_meet (p q : region) (x w u : vector) :
  valid_region p -> valid_region q -> in_region w p -> in_region u q -> equal_vectors x (plus w u) ->
  ((exists e, In e (region_edges p) /\ lies_on w e) /\ (exists f, In f (region_edges q) /\ lies_on u f)) \/
  interiors_meet x p q.
Proof.
  intros (p_edges & p_valid & p_meet) (q_edges & q_valid & q_meet) in_p in_q sum_.
  assert (inside_if_off : forall v r, in_region v r -> off v (region_edges r) -> inside v r).
  { intros v r [round | (s & S & on)] free; [now split | exfalso; exact (free s S on)]. }
  destruct (on_or_off w (region_edges p)) as [on_p | off_p]; [destruct (on_or_off u (region_edges q)) as [| off_q] |];
    [now left | right; apply interiors_meet_other_way | right].
  - apply (inner_point_and_point q p x u w); auto using regions_are_regular, sum_in_other_order.
  - apply (inner_point_and_point p q x w u); auto using regions_are_regular.
Qed.

(* An edge of Q that lies along a filled side of P in the opposite direction. *)
Lemma opposite_edge_meets (p q : region) (x w u d : vector) (f : segment) :
  valid_region q -> In f (region_edges q) -> lies_on u f -> equal_vectors x (plus w u) ->
  fills_left w d p -> same_direction d (opposite (along f)) -> interiors_meet x p q.
Proof.
  intros (q_edges & q_valid & q_meet) F on_f [X Y] (radius & R & fills) (m & some & mx & my).
  pose proof (region_edges_are_directions q q_edges f F) as long. pose proof (left_normal f long) as left_n.
  destruct (no_vertex_near q f u ((1 # 2) * radius) long on_f) as (v & near_v & on_v & no_vertex); [lra |].
  set (n := Vector (- vy (along f)) (vx (along f))) in *.
  destruct (some_small _ (eventually_and _ _ (left_of_an_edge_is_inside q f v n q_valid q_meet F on_v no_vertex left_n)
    (small_steps_stay_within ((1 # 2) * radius) v n ltac:(lra)))) as (t & t_some & in_q & near_t).
  set (u' := moved_along v n t) in *. exists (minus x u'). split.
  - apply fills; [unfold within, plus, minus in *; cbn [vx vy] in *; lra |].
    assert (value : cross d (minus (minus x u') w) == m * (area f u' - area f u)).
    { unfold plus in X, Y. in_coordinates. by_equations. }
    rewrite value, (on_the_line u f on_f). unfold u'.
    setoid_replace (area f (moved_along v n t)) with (area f v + t * cross (along f) n) by by_coordinates.
    rewrite (on_the_line v f on_v). assert (0 < t * cross (along f) n) by (now apply Qmult_lt_0_compat).
    apply Qmult_lt_0_compat; lra.
  - refine (inside_equal _ _ _ _ in_q). unfold minus. split; cbn [vx vy]; ring.
Qed.
