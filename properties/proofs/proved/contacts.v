(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* How two regions show that their interiors meet, in words that do not change while one of them is moved and keeps
   its contacts with the other (contacts_that_stay.v): two edges cross, or a part of an edge of one, between two
   vertices of either with none between them, is inside the other, or along its boundary in the same direction. The
   collision test (collision_is_complete.v) finds one of these. *)
From Coq Require Import QArith Lqa Qfield ZArith Lia Bool List.
From Oplus Require Import regions_and_sums reflected boundary_points location rotation pieces naive_collision met_pieces
  collision_is_sound collision_is_complete cut_pieces coordinates.
Import ListNotations.

Open Scope Q_scope.

(* Two edges with a common point that is a vertex of neither region. *)
Definition boundaries_cross (a b : region) : Prop :=
  exists e f w, In e (region_edges a) /\ In f (region_edges b) /\ lies_on w e /\ lies_on w f /\
    ~ is_vertex w a /\ ~ is_vertex w b /\ ~ cross (along e) (along f) == 0.

Definition vertex_of_either (v : vector) (a b : region) : Prop := is_vertex v a \/ is_vertex v b.

(* Along e, d is ahead of c. *)
Definition comes_later (e : segment) (c d : vector) : Prop := 0 < dot (along e) (minus d c).

Definition no_vertex_between (a b : region) (c d : vector) : Prop :=
  forall v, vertex_of_either v a b -> ~ strictly_inside v (Segment c d).

(* Just to the left of a point of e is inside b. *)
Definition point_shows (b : region) (e : segment) (w : vector) : Prop :=
  inside w b \/
  exists f, In f (region_edges b) /\ lies_on w f /\ cross (along e) (along f) == 0 /\ 0 < dot (along e) (along f).

Definition part_shows (a b : region) (e : segment) (c d : vector) : Prop :=
  In e (region_edges a) /\ vertex_of_either c a b /\ vertex_of_either d a b /\ lies_on c e /\ lies_on d e /\
  comes_later e c d /\ no_vertex_between a b c d /\ point_shows b e (middle (Segment c d)).

(* Edges of a valid region that are not parallel have only vertices in common. *)
Lemma common_point_is_a_vertex (r : region) (e f : segment) (w : vector) : valid_region r -> In e (region_edges r) ->
  In f (region_edges r) -> lies_on w e -> lies_on w f -> ~ cross (along e) (along f) == 0 -> is_vertex w r.
Proof.
  intros (_ & _ & meet) E F on_e on_f turn. destruct (in_split _ _ E) as (earlier & later & edges_are).
  apply (meet earlier e later f w edges_are); trivial. rewrite edges_are in F. apply in_app_iff in F.
  apply in_app_iff. destruct F as [F | [-> | F]]; [tauto | | tauto]. exfalso. apply turn. unfold cross. ring.
Qed.

(* The boundary of a valid region is cut in vertices. *)
Lemma boundary_piece_ends_in_vertices (r : region) (s : segment) (w : vector) :
  valid_region r -> In s (boundary_pieces r) -> w = source s \/ w = target s -> is_vertex w r.
Proof.
  intros r_region I end_. apply in_flat_map in I. destruct I as (e & E & I).
  destruct (ends_of_a_piece e s (region_edges r) w I end_) as [-> | [-> | (f & F & met)]];
    [now apply source_is_vertex | now apply target_is_vertex |].
  apply intersection_is in met. destruct met as [[-> | [-> | [-> | ->]]] | (on_e & on_f & turn)];
    try (now apply source_is_vertex); try now apply target_is_vertex.
  now apply (common_point_is_a_vertex r e f).
Qed.

Section Shown.
  Variables a b : region.
  Hypotheses (a_region : valid_region a) (b_region : valid_region b).

  (* Where a piece ends is a vertex, or edges cross. *)
  Lemma contact_is_a_vertex (e s piece : segment) (w : vector) :
    In e (region_edges a) -> nonzero (along e) -> is_part s e -> In s (boundary_pieces a) ->
    In piece (cut_where_met s (boundary_pieces b)) -> w = source piece \/ w = target piece ->
    boundaries_cross a b \/ vertex_of_either w a b.
  Proof.
    intros E long_e part I J end_. unfold vertex_of_either.
    destruct (vertex_or_not w a) as [| not_a]; [tauto |]. destruct (vertex_or_not w b) as [| not_b]; [tauto |]. left.
    destruct (ends_of_a_piece s piece _ w J end_) as [is_end | [is_end | (t & T & met)]];
      [exfalso; apply not_a; apply (boundary_piece_ends_in_vertices a s); tauto .. |].
    apply intersection_is in met. destruct met as [ends | (on_s & on_t & turn)].
    { exfalso. pose proof (boundary_piece_ends_in_vertices a s w a_region I).
      pose proof (boundary_piece_ends_in_vertices b t w b_region T). tauto. }
    destruct (boundary_piece_is b t (proj1 b_region) T) as (f & F & long_f & t_part & _).
    exists e, f, w. repeat split; trivial; [now apply (part_lies_on s e) | now apply (part_lies_on t f) |].
    intros parallel. apply turn. destruct (cross_of_parts s t e f long_e long_f part t_part) as (c & _ & -> & _).
    rewrite parallel. ring.
  Qed.

  Theorem shown_part (s piece : segment) : In s (boundary_pieces a) ->
    In piece (cut_where_met s (boundary_pieces b)) -> shows_common_interior piece b (boundary_pieces b) = true ->
    boundaries_cross a b \/ exists e c d, part_shows a b e c d.
  Proof.
    intros I J shows.
    destruct (boundary_piece_is a s (proj1 a_region) I) as (e & E & long_e & s_part & no_vertex).
    destruct (part_is_long s e s_part long_e) as [long_s (c1 & C1 & c1x & c1y)].
    pose proof (piece_is_part s piece _ long_s J) as piece_part.
    destruct (part_is_long piece s piece_part long_s) as (_ & c2 & C2 & c2x & c2y).
    destruct (contact_is_a_vertex e s piece (source piece)) as [| source_is]; [tauto .. |].
    destruct (contact_is_a_vertex e s piece (target piece)) as [| target_is]; [tauto .. |].
    right. exists e, (source piece), (target piece).
    assert (some : 0 < c2 * c1) by now apply Qmult_lt_0_compat.
    pose proof (middle_is_inside piece) as in_piece. pose proof piece_part as (on_source & on_target & _).
    repeat split; trivial; [now apply (part_lies_on s e) .. | | |].
    - unfold comes_later. fold (along piece).
      setoid_replace (dot (along e) (along piece)) with (c2 * c1 * dot (along e) (along e))
        by (unfold dot; rewrite c2x, c2y, c1x, c1y; ring).
      now apply Qmult_lt_0_compat, square_positive.
    - intros v vertex in_v. replace (Segment (source piece) (target piece)) with piece in in_v by now destruct piece.
      destruct vertex as [of_a | of_b].
      + now destruct (no_vertex v (strictly_inside_part piece s v long_s piece_part in_v)).
      + destruct (vertex_ends_a_piece b v (proj1 b_region) of_b) as (u & U & equal).
        now destruct (nothing_meets_a_piece s _ piece u v long_s J in_v U).
    - unfold shows_common_interior in shows. pose proof (locate_returns (middle piece) b) as where_.
      destruct (locate (middle piece) b); [discriminate | right | now left].
      apply existsb_exists in shows. destruct shows as (t & T & both). apply andb_true_iff in both.
      destruct both as [on_t same_way].
      destruct (is_on_spec (middle piece) t) as [on_t' |]; [clear on_t | discriminate].
      destruct (boundary_piece_is b t (proj1 b_region) T) as (f & F & long_f & t_part & _). exists f.
      destruct (nothing_meets_a_piece s _ piece t _ long_s J in_piece T) as (_ & _ & parallel).
      specialize (parallel on_t').
      destruct (cross_of_parts s t e f long_e long_f s_part t_part) as (c & C & cross_is & dot_is).
      split; [exact F |]. split; [now apply (part_lies_on t f) |]. split.
      + destruct (Qmult_integral c (cross (along e) (along f))); [lra | lra | assumption].
      + unfold positive in same_way. destruct (negative_spec (- dot (along t) (along piece))); [| discriminate].
        assert (product : dot (along t) (along piece) == c2 * (c * dot (along e) (along f)))
          by (rewrite <- dot_is; unfold dot; rewrite c2x, c2y; ring).
        assert (0 < c2 * c) by now apply Qmult_lt_0_compat.
        destruct (Qlt_le_dec 0 (dot (along e) (along f))); [assumption | exfalso; nra].
  Qed.
End Shown.

Lemma boundaries_cross_other_way (a b : region) : boundaries_cross a b -> boundaries_cross b a.
Proof.
  intros (e & f & w & E & F & on_e & on_f & not_a & not_b & turn). exists f, e, w. repeat split; trivial.
  intros parallel. apply turn. unfold cross in *. lra.
Qed.

(* A segment in the direction of an edge, and between vertices. *)
Definition runs_inside (r : region) (s e : segment) : Prop :=
  In e (region_edges r) /\ (exists c, vx (along s) == c * vx (along e) /\ vy (along s) == c * vy (along e)) /\
  forall w, strictly_inside w s -> lies_on w e /\ ~ is_vertex w r.

Lemma boundary_piece_runs (r : region) (s : segment) : no_edges_are_points r -> In s (boundary_pieces r) ->
  exists e, runs_inside r s e.
Proof.
  intros not_points S. destruct (boundary_piece_is r s not_points S) as (e & E & long & part & free).
  destruct (part_is_long s e part long) as (_ & c & _ & along_). exists e. split; [exact E |]. now split; [exists c |].
Qed.

(* Those that cross are on edges that do. *)
Lemma crossing_parts (a b : region) (s t e f : segment) : runs_inside a s e -> runs_inside b t f ->
  cross_properly s t = true -> boundaries_cross a b.
Proof.
  intros (E & (c & cx & cy) & a_free) (F & (d & dx & dy) & b_free) crossing_.
  destruct (proper_crossing s t crossing_) as (w & in_s & in_t & turn). destruct (a_free w in_s), (b_free w in_t).
  exists e, f, w. repeat split; trivial. intros parallel. apply turn. unfold cross in *. by_equations.
Qed.

(* Theorem. Where a point is inside both, edges cross or a part of an edge shows it. *)
Theorem what_shows (a b : region) :
  valid_region a -> valid_region b -> nowhere_above_one a -> nowhere_above_one b -> meet_inside a b ->
  boundaries_cross a b \/ (exists e c d, part_shows a b e c d) \/ (exists e c d, part_shows b a e c d).
Proof.
  intros a_region b_region a_simple b_simple (z & in_a & in_b).
  pose proof (collide_is_complete a b z a_region b_region a_simple b_simple in_a in_b) as meets.
  unfold collide, boundary_enters in meets. rewrite !orb_true_iff, !existsb_exists in meets.
  destruct meets as [[(s & I & found) | (s & I & found)] | (s & I & found)];
    apply existsb_exists in found; destruct found as (t & J & found).
  - left. destruct (boundary_piece_runs a s (proj1 a_region) I) as (e & e_is).
    destruct (boundary_piece_runs b t (proj1 b_region) J) as (f & f_is). now apply (crossing_parts a b s t e f).
  - destruct (shown_part a b a_region b_region s t I J found); tauto.
  - destruct (shown_part b a b_region a_region s t I J found) as [crossing_ | part]; [| tauto].
    left. now apply boundaries_cross_other_way.
Qed.

(* Where edges cross, there is a point inside both. *)
Lemma edges_that_cross_show (a b : region) : valid_region a -> valid_region b -> boundaries_cross a b ->
  meet_inside a b.
Proof. intros a_region b_region (e & f & w & facts). apply (crossing_edges_show a b e f w); tauto. Qed.

(* Along an edge. *)
Lemma step_along (e : segment) (c d : vector) : lies_on c e -> lies_on d e -> exists k,
  vx d == vx c + k * vx (along e) /\ vy d == vy c + k * vy (along e) /\
  dot (along e) (minus d c) == k * dot (along e) (along e).
Proof.
  intros (i & _ & ix & iy) (j & _ & jx & jy). exists (j - i). unfold dot, along, minus; cbn [vx vy].
  rewrite ix, iy, jx, jy. repeat split; ring.
Qed.

Lemma equal_if_not_apart (e : segment) (c d : vector) : nonzero (along e) -> lies_on c e -> lies_on d e ->
  dot (along e) (minus d c) == 0 -> equal_vectors c d.
Proof.
  intros long on_c on_d none. destruct (step_along e c d on_c on_d) as (k & X & Y & step).
  pose proof (square_positive _ long). rewrite none in step. symmetry in step.
  apply Qmult_integral in step. destruct step as [k_is |]; [rewrite k_is in X, Y; split; lra | lra].
Qed.

Lemma inside_if_between (e : segment) (c d v : vector) : nonzero (along e) -> lies_on c e -> lies_on d e ->
  lies_on v e -> comes_later e c v -> comes_later e v d -> strictly_inside v (Segment c d).
Proof.
  unfold comes_later. intros long on_c on_d on_v after before.
  destruct (step_along e c v on_c on_v) as (j & jx & jy & j_is), (step_along e v d on_v on_d) as (k & kx & ky & k_is).
  pose proof (square_positive _ long) as square. rewrite j_is in after. rewrite k_is in before.
  assert (0 < j) by nra. assert (0 < k) by nra. assert (value : j / (j + k) * (j + k) == j) by (field; lra).
  exists (j / (j + k)). split; [split; [apply Qlt_shift_div_l | apply Qlt_shift_div_r]; lra |].
  set (t := j / (j + k)) in *. clearbody t. cbn [source target].
  assert (multiple : forall u, t * (j + k) * u == j * u) by (intros u; now rewrite value).
  pose proof (multiple (vx (along e))). pose proof (multiple (vy (along e))). rewrite kx, ky, jx, jy. split; lra.
Qed.

Lemma later_inside (e : segment) (c d v : vector) : strictly_inside v (Segment c d) -> comes_later e c d ->
  comes_later e c v /\ comes_later e v d.
Proof.
  intros (k & range & X & Y) later. unfold comes_later, dot, minus in *; cbn [source target vx vy] in *. rewrite X, Y.
  split; nra.
Qed.

(* What is parallel to e, with a point strictly between c and d and no end there, runs along all of that part. *)
Lemma runs_along_the_part (e f : segment) (c d w : vector) : nonzero (along e) -> nonzero (along f) ->
  lies_on c e -> lies_on d e -> comes_later e c d -> cross (along e) (along f) == 0 ->
  (forall v, v = source f \/ v = target f -> ~ strictly_inside v (Segment c d)) ->
  strictly_inside w (Segment c d) -> lies_on w f -> lies_on c f /\ lies_on d f.
Proof.
  unfold comes_later. intros long_e long_f on_c on_d ahead parallel no_end (k & range & X & Y) (l & l_range & lx & ly).
  destruct (step_along e c d on_c on_d) as (g & gx & gy & g_is). pose proof (square_positive _ long_e) as square.
  rewrite g_is in ahead. assert (0 < g) by nra. cbn [source target] in X, Y.
  destruct (multiple_of (along f) (along e) long_e) as (n & nx & ny); [unfold cross in *; lra |].
  set (m := n / g). assert (m_is : n == m * g) by (unfold m; field; lra). clearbody m.
  rewrite m_is in nx, ny. set (ux := vx (along e)) in *. set (uy := vy (along e)) in *. clearbody ux uy.
  unfold along, minus in nx, ny; cbn [vx vy] in nx, ny.
  assert (fx : vx (target f) == vx (source f) + m * g * ux) by lra.
  assert (fy : vy (target f) == vy (source f) + m * g * uy) by lra.
  rewrite gx in X. rewrite gy in Y. rewrite fx in lx. rewrite fy in ly.
  assert (out : forall h v, (h == 0 /\ v = source f \/ h == 1 /\ v = target f) ->
    k + (h - l) * m <= 0 \/ 1 <= k + (h - l) * m).
  { intros h v which. destruct (Qlt_le_dec 0 (k + (h - l) * m)); [| now left].
    destruct (Qlt_le_dec (k + (h - l) * m) 1); [exfalso | now right].
    apply (no_end v); [tauto |]. exists (k + (h - l) * m). cbn [source target]. split; [lra |]. rewrite gx, gy.
    destruct which as [[-> ->] | [-> ->]]; rewrite ?fx, ?fy; split; lra. }
  pose proof (out 0 _ (or_introl (conj (Qeq_refl 0) eq_refl))) as at_source.
  pose proof (out 1 _ (or_intror (conj (Qeq_refl 1) eq_refl))) as at_target. clear out no_end.
  assert (some : ~ m == 0)
    by (intros none; apply long_f; unfold along, minus; cbn [vx vy]; rewrite fx, fy, none; split; ring).
  assert (ratio : / m * m == 1) by (field; exact some). set (r := / m) in *. clearbody r.
  assert (range_ : 0 <= l - k * r <= 1 /\ 0 <= l + (1 - k) * r <= 1).
  { destruct (Q_dec m 0) as [[low | high] | none]; [| | contradiction].
    - assert (r < 0) by nra. repeat split; nra.
    - assert (0 < r) by nra. repeat split; nra. }
  assert (multiple : forall u, r * m * u == u) by (intros u; rewrite ratio; ring).
  pose proof (multiple (k * g * ux)). pose proof (multiple (k * g * uy)). pose proof (multiple (g * ux)).
  pose proof (multiple (g * uy)).
  split; [exists (l - k * r) | exists (l + (1 - k) * r)]; (split; [tauto |]); rewrite ?gx, ?gy, fx, fy; split; lra.
Qed.
