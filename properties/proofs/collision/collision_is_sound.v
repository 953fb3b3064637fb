(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* What the naive collision test (naive_collision.v) finds is there: where it says that the interiors of two valid
   regions meet, there is a point inside both. Two pieces that cross do so at no vertex, and to the left of both is
   inside (left_of_an_edge.v); beside a point of one boundary inside the other region is a point inside both; and
   pieces that run along each other in the same direction have the inside on the same side. *)
From Coq Require Import ZArith Lia Bool List.
From Oplus Require Import numbers regions_and_sums location pieces naive_collision met_pieces.
Import ListNotations.

Open Scope Q_scope.

(* A point inside both. *)
Definition meet_inside (a b : region) : Prop := exists z, inside z a /\ inside z b.

Lemma left_of_both (a b : region) (e f : segment) (w n : vector) :
  valid_region a -> valid_region b -> In e (region_edges a) -> In f (region_edges b) ->
  lies_on w e -> lies_on w f -> ~ is_vertex w a -> ~ is_vertex w b ->
  0 < cross (along e) n -> 0 < cross (along f) n -> meet_inside a b.
Proof.
  intros (_ & a_valid & a_meet) (_ & b_valid & b_meet) E F on_e on_f a_free b_free left_of_e left_of_f.
  destruct (some_small _ (eventually_and _ _
    (left_of_an_edge_is_inside a e w n a_valid a_meet E on_e a_free left_of_e)
    (left_of_an_edge_is_inside b f w n b_valid b_meet F on_f b_free left_of_f))) as (d & _ & both).
  now exists (moved_along w n d).
Qed.

(* Two edges that cross. *)
Lemma crossing_edges_show (a b : region) (e f : segment) (w : vector) :
  valid_region a -> valid_region b -> In e (region_edges a) -> In f (region_edges b) ->
  lies_on w e -> lies_on w f -> ~ is_vertex w a -> ~ is_vertex w b ->
  ~ cross (along e) (along f) == 0 -> meet_inside a b.
Proof.
  intros a_region b_region E F on_e on_f a_free b_free turn.
  destruct (Q_dec (cross (along e) (along f)) 0) as [[right_ | left_] | none]; [| | contradiction].
  - apply (left_of_both a b e f w (minus (along e) (along f))); trivial;
      unfold cross, minus in *; cbn [vx vy] in *; lra.
  - apply (left_of_both a b e f w (minus (along f) (along e))); trivial;
      unfold cross, minus in *; cbn [vx vy] in *; lra.
Qed.

Lemma cross_of_parts (s t e f : segment) : nonzero (along e) -> nonzero (along f) -> is_part s e -> is_part t f ->
  exists c, 0 < c /\ cross (along s) (along t) == c * cross (along e) (along f) /\
    dot (along s) (along t) == c * dot (along e) (along f).
Proof.
  intros long_e long_f s_part t_part.
  destruct (part_is_long s e s_part long_e) as (_ & c & C & cx & cy).
  destruct (part_is_long t f t_part long_f) as (_ & d & D & dx & dy).
  exists (c * d). split; [now apply Qmult_lt_0_compat |].
  unfold cross, dot. rewrite cx, cy, dx, dy. split; ring.
Qed.

Lemma proper_crossing (s t : segment) : cross_properly s t = true ->
  exists w, strictly_inside w s /\ strictly_inside w t /\ ~ cross (along s) (along t) == 0.
Proof.
  intros crossing_. unfold cross_properly in crossing_. rewrite !orientation_by_area in crossing_.
  apply andb_true_iff in crossing_. destruct crossing_ as [t_across s_across].
  set (u := area (Segment (source s) (target s)) (source t)) in *.
  set (v := area (Segment (source s) (target s)) (target t)) in *.
  set (p := area (Segment (source t) (target t)) (source s)) in *.
  set (q := area (Segment (source t) (target t)) (target s)) in *.
  assert (sides : forall x y : Q, opposite_sides (x ?= 0) (y ?= 0) = true -> x < 0 /\ 0 < y \/ 0 < x /\ y < 0).
  { intros x y opposite_. compared_numbers (x ?= 0); compared_numbers (y ?= 0); try discriminate opposite_; lra. }
  apply sides in t_across. apply sides in s_across. clear sides.
  assert (turn_1 : cross (along s) (along t) == v - u)
    by (unfold u, v, area, cross, along, minus; cbn [source target vx vy]; ring).
  assert (turn_2 : cross (along s) (along t) == p - q)
    by (unfold p, q, area, cross, along, minus; cbn [source target vx vy]; ring).
  assert (turn : ~ cross (along s) (along t) == 0) by lra.
  set (D := cross (along s) (along t)) in *.
  assert (p_is : p / D * D == p) by (field; exact turn). assert (u_is : - u / D * D == - u) by (field; exact turn).
  set (k := p / D) in *. set (l := - u / D) in *. clearbody k l.
  assert (fraction_ : forall x y : Q, 0 < x * y -> 0 < (1 - x) * y -> 0 < x < 1).
  { intros x y X Y. destruct (Qlt_le_dec 0 y); split; apply Qnot_le_lt; intros extreme; nra. }
  assert (range : 0 < k < 1 /\ 0 < l < 1).
  { destruct s_across as [[P Q_] | [P Q_]], t_across as [[P' Q'] | [P' Q']]; split;
      first [apply (fraction_ _ D); lra | apply (fraction_ _ (- D)); lra]. }
  destruct range as [k_range l_range].
  exists (Vector ((1 - k) * vx (source s) + k * vx (target s)) ((1 - k) * vy (source s) + k * vy (target s))).
  split; [exists k; split; [exact k_range |]; split; reflexivity |]. split; [| exact turn].
  exists l. split; [exact l_range |]. clear fraction_ k_range l_range s_across t_across. cbn [vx vy].
  split; apply (Qmult_inj_r _ _ D turn); unfold p, u, q, v, D in *; in_coordinates; by_equations.
Qed.

Lemma middle_is_inside (s : segment) : strictly_inside (middle s) s.
Proof. exists (1 # 2). unfold middle; cbn [vx vy]. split; [lra |]. split; field. Qed.

(* Every vertex of a region is an end of one of its pieces; so of a piece cut once more where the other region's pieces
   meet it no point strictly inside is a vertex of the other region. *)
Lemma vertex_ends_a_piece (r : region) (w : vector) : no_edges_are_points r -> is_vertex w r ->
  exists t, In t (boundary_pieces r) /\ equal_vectors w (source t).
Proof.
  intros not_points (e & E & equal).
  pose proof (region_edges_are_directions r not_points e E) as long.
  destruct (cut_returns e (flat_map (intersection e) (region_edges r)) long) as [_ cover].
  destruct (cover (source e) (source_lies_on e)) as (piece & I & part & on).
  exists piece. split; [apply in_flat_map; now exists e |].
  destruct part as (on_source & on_target & before).
  destruct (fraction_on e _ long on_source) as (range_j & jx & jy).
  destruct on as (t & range & X & Y).
  assert (part_ : is_part piece e) by (split; [exact on_source | split; [exact on_target | exact before]]).
  destruct (point_of_part piece e (source e) t long part_ range X Y) as [_ t_is].
  assert (start : fraction e (source e) == 0) by (apply fraction_is; trivial; ring).
  rewrite start in t_is. set (j := fraction e (source piece)) in *. set (k := fraction e (target piece)) in *.
  assert (0 <= t * (k - j)) by (apply Qmult_le_0_compat; lra).
  assert (j_is : j == 0) by lra. rewrite j_is in jx, jy. unfold equal_vectors in *. lra.
Qed.

Lemma piece_shows (a b : region) (s piece : segment) : valid_region a -> valid_region b ->
  In s (boundary_pieces a) -> In piece (cut_where_met s (boundary_pieces b)) ->
  shows_common_interior piece b (boundary_pieces b) = true -> meet_inside a b.
Proof.
  intros a_region b_region I J shows.
  pose proof a_region as (a_edges & a_valid & a_meet). pose proof b_region as (b_edges & b_valid & b_meet).
  destruct (boundary_piece_is a s a_edges I) as (e & E & long_e & s_part & no_vertex).
  destruct (part_is_long s e s_part long_e) as [long_s _].
  destruct (cut_returns s (flat_map (intersection s) (boundary_pieces b)) long_s) as [parts _].
  destruct (parts piece J) as [piece_part _].
  pose proof (middle_is_inside piece) as in_piece.
  pose proof (strictly_inside_part piece s _ long_s piece_part in_piece) as in_s.
  destruct (no_vertex _ in_s) as [on_e a_free].
  unfold shows_common_interior in shows. pose proof (locate_returns (middle piece) b) as where_.
  destruct (locate (middle piece) b); [discriminate | |].
  - apply existsb_exists in shows. destruct shows as (t & T & both). apply andb_true_iff in both.
    destruct both as [on_t same_way].
    destruct (is_on_spec (middle piece) t) as [on_t' |]; [clear on_t | discriminate].
    destruct (boundary_piece_is b t b_edges T) as (f & F & long_f & t_part & _).
    destruct (nothing_meets_a_piece s _ piece t _ long_s J in_piece T) as (_ & _ & parallel).
    specialize (parallel on_t').
    assert (on_f : lies_on (middle piece) f).
    { destruct on_t' as (k & range & X & Y). now destruct (point_of_part t f _ k long_f t_part range X Y). }
    assert (b_free : ~ is_vertex (middle piece) b).
    { intros vertex. destruct (vertex_ends_a_piece b _ b_edges vertex) as (u & U & equal).
      destruct (nothing_meets_a_piece s _ piece u _ long_s J in_piece U) as (no_source & _).
      exact (no_source equal). }
    destruct (cross_of_parts s t e f long_e long_f s_part t_part) as (c & C & cross_is & _).
    assert (parallel_edges : cross (along e) (along f) == 0).
    { destruct (Qmult_integral c (cross (along e) (along f))); [lra | lra | assumption]. }
    assert (piece_of_e : exists d, 0 < d /\
      vx (along piece) == d * vx (along e) /\ vy (along piece) == d * vy (along e)).
    { destruct (part_is_long piece s piece_part long_s) as (_ & c1 & C1 & c1x & c1y).
      destruct (part_is_long s e s_part long_e) as (_ & c2 & C2 & c2x & c2y).
      exists (c1 * c2). split; [now apply Qmult_lt_0_compat |]. rewrite c1x, c1y, c2x, c2y. split; ring. }
    destruct piece_of_e as (d & D & dx & dy).
    destruct (part_is_long t f t_part long_f) as (_ & k & K & kx & ky).
    assert (same_direction_ : 0 < dot (along f) (along e)).
    { unfold positive in same_way. destruct (negative_spec (- dot (along t) (along piece))); [| discriminate].
      assert (product : dot (along t) (along piece) == k * d * dot (along f) (along e))
        by (unfold dot; rewrite kx, ky, dx, dy; ring).
      assert (0 < k * d) by now apply Qmult_lt_0_compat.
      destruct (Qlt_le_dec 0 (dot (along f) (along e))); [assumption | exfalso; nra]. }
    pose proof (square_positive _ long_e) as square_e. unfold cross, dot in *.
    apply (left_of_both a b e f (middle piece) (Vector (- vy (along e)) (vx (along e)))); trivial;
      unfold cross; cbn [vx vy]; lra.
  - destruct where_ as [free inside_b].
    destruct (winding_number_near _ _ (region_cycles b) free) as (radius & R & near).
    destruct (regions_are_regular a a_edges a_valid a_meet (middle piece) e radius E on_e R) as (z & close & in_a).
    exists z. split; [exact in_a |]. destruct (near z close) as [off_b same_number]. split; [exact off_b | lia].
Qed.

Lemma meet_inside_other_way (a b : region) : meet_inside a b -> meet_inside b a.
Proof. intros (z & in_a & in_b). now exists z. Qed.

Lemma boundary_shows (a b : region) : valid_region a -> valid_region b ->
  boundary_enters (boundary_pieces a) b (boundary_pieces b) = true -> meet_inside a b.
Proof.
  intros a_region b_region enters. apply existsb_exists in enters. destruct enters as (s & I & enters).
  apply existsb_exists in enters. destruct enters as (piece & J & shows).
  exact (piece_shows a b s piece a_region b_region I J shows).
Qed.

(* Theorem. If the collision test of two valid regions returns true, there is a point inside both. *)
Theorem collide_is_sound (a b : region) : valid_region a -> valid_region b ->
  collide a b = true -> exists z, inside z a /\ inside z b.
Proof.
  intros a_region b_region meets. unfold collide in meets.
  apply orb_true_iff in meets. destruct meets as [meets | enters].
  - apply orb_true_iff in meets. destruct meets as [crossing_ | enters]; [| now apply boundary_shows].
    apply existsb_exists in crossing_. destruct crossing_ as (s & I & crossing_).
    apply existsb_exists in crossing_. destruct crossing_ as (t & J & crossing_).
    destruct (proper_crossing s t crossing_) as (w & in_s & in_t & turn).
    destruct (boundary_piece_is a s (proj1 a_region) I) as (e & E & long_e & s_part & a_free).
    destruct (boundary_piece_is b t (proj1 b_region) J) as (f & F & long_f & t_part & b_free).
    destruct (a_free w in_s) as [on_e no_vertex_a], (b_free w in_t) as [on_f no_vertex_b].
    apply (crossing_edges_show a b e f w); trivial. intros parallel. apply turn.
    destruct (cross_of_parts s t e f long_e long_f s_part t_part) as (c & _ & -> & _). rewrite parallel. ring.
  - apply meet_inside_other_way. now apply boundary_shows.
Qed.
