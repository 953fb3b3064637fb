(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* How two regions show that their interiors meet, in words that do not change while one of them is moved and keeps
   its contacts with the other (contacts_that_stay.v): two edges cross, or a part of an edge of one, between two
   vertices of either with none between them, is inside the other, or along its boundary in the same direction. The
   collision test (collision_is_complete.v) finds one of these. *)
From Coq Require Import QArith Lqa Qfield ZArith Lia Bool List.
From Oplus Require Import convolution signed_crossings meeting_of_segments regions reflected first_hit interiors_meet
  neighbourhoods left_of_an_edge winding_number_of_the_sum theorem_4_2_1 location rotation pieces naive_collision
  met_pieces collision_is_sound collision_is_complete placed_collision cut_pieces.
Import ListNotations.

Open Scope Q_scope.

(* Two edges with a common point that is a vertex of neither region. *)
Definition boundaries_cross (a b : region) : Prop :=
  exists e f w, In e (region_edges a) /\ In f (region_edges b) /\ lies_on w e /\ lies_on w f /\
    ~ is_vertex w a /\ ~ is_vertex w b /\ ~ cross (along e) (along f) == 0.

Definition vertex_of_either (v : vector) (a b : region) : Prop := is_vertex v a \/ is_vertex v b.

Definition comes_between (e : segment) (c d v : vector) : Prop :=
  fraction e c < fraction e v /\ fraction e v < fraction e d.

(* The edge e of a has no vertex between c and d. *)
Definition no_vertex_between (a b : region) (e : segment) (c d : vector) : Prop :=
  forall v, vertex_of_either v a b -> lies_on v e -> ~ comes_between e c d v.

Definition midpoint (c d : vector) : vector := middle (Segment c d).

(* Just to the left of its middle is inside b. *)
Definition middle_shows (b : region) (e : segment) (c d : vector) : Prop :=
  inside (midpoint c d) b \/
  exists f, In f (region_edges b) /\ lies_on (midpoint c d) f /\ cross (along e) (along f) == 0 /\
    0 < dot (along e) (along f).

Definition part_shows (a b : region) (e : segment) (c d : vector) : Prop :=
  In e (region_edges a) /\ vertex_of_either c a b /\ vertex_of_either d a b /\ lies_on c e /\ lies_on d e /\
  fraction e c < fraction e d /\ no_vertex_between a b e c d /\ middle_shows b e c d.

Lemma is_vertex_dec (w : vector) (r : region) : is_vertex w r \/ ~ is_vertex w r.
Proof.
  unfold is_vertex. induction (region_edges r) as [| u l IH]; [right; intros (u & [] & _) |].
  destruct (same_point_spec w (source u)) as [equal | differ]; [left; exists u; split; [now left | exact equal] |].
  destruct IH as [(t & I & equal) | none]; [left; exists t; split; [now right | exact equal] |].
  right. intros (t & [<- | I] & equal); [contradiction |]. apply none. now exists t.
Qed.

Lemma equal_vertex (v w : vector) (r : region) : equal_vectors v w -> is_vertex v r -> is_vertex w r.
Proof. intros [X Y] (u & U & ux & uy). exists u. split; [exact U |]. split; lra. Qed.

(* Edges of a valid region that are not parallel have only vertices in common. *)
Lemma common_point_is_a_vertex (r : region) (e f : segment) (w : vector) :
  valid_region r -> In e (region_edges r) -> In f (region_edges r) -> lies_on w e -> lies_on w f ->
  ~ cross (along e) (along f) == 0 -> is_vertex w r.
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
  assert (itself : forall f, In f (region_edges r) -> is_vertex (source f) r)
    by (intros f F; exists f; split; [exact F | split; reflexivity]).
  destruct (ends_of_a_piece e s (region_edges r) w I end_) as [-> | [-> | (f & F & met)]].
  - now apply itself.
  - now apply target_is_vertex.
  - apply intersection_is in met. destruct met as [[-> | [-> | [-> | ->]]] | (on_e & on_f & turn)].
    + now apply itself.
    + now apply target_is_vertex.
    + now apply itself.
    + now apply target_is_vertex.
    + now apply (common_point_is_a_vertex r e f).
Qed.

Section Shown.
  Variables a b : region.
  Hypothesis a_region : valid_region a.
  Hypothesis b_region : valid_region b.

  Lemma on_the_edge (r : region) (t f : segment) (w : vector) : no_edges_are_points r -> In f (region_edges r) ->
    is_part t f -> lies_on w t -> lies_on w f.
  Proof.
    intros not_points F part. apply part_lies_on; [| exact part]. now apply (region_edges_are_directions r).
  Qed.

  (* Where a piece ends is a vertex, or edges cross. *)
  Lemma contact_is_a_vertex (e s piece : segment) (w : vector) :
    In e (region_edges a) -> is_part s e -> In s (boundary_pieces a) -> In piece (cut_where_met s (boundary_pieces b))
      ->
    w = source piece \/ w = target piece -> boundaries_cross a b \/ vertex_of_either w a b.
  Proof.
    intros E part I J end_. pose proof a_region as (a_edges & _). pose proof b_region as (b_edges & _).
    destruct (is_vertex_dec w a) as [of_a | not_a]; [right; now left |].
    destruct (is_vertex_dec w b) as [of_b | not_b]; [right; now right |]. left.
    destruct (ends_of_a_piece s piece _ w J end_) as [is_end | [is_end | (t & T & met)]];
      [exfalso; apply not_a; apply (boundary_piece_ends_in_vertices a s); tauto .. |].
    assert (no_end : ~ (w = source s \/ w = target s) /\ ~ (w = source t \/ w = target t)).
    { split; intros is_end;
        [apply not_a, (boundary_piece_ends_in_vertices a s) | apply not_b, (boundary_piece_ends_in_vertices b t)];
          trivial. }
    apply intersection_is in met. destruct met as [ends | (on_s & on_t & turn)]; [exfalso; tauto |].
    destruct (boundary_piece_is b t b_edges T) as (f & F & long_f & t_part & _).
    pose proof (region_edges_are_directions a a_edges e E) as long_e.
    exists e, f, w. repeat split; trivial.
    - now apply (on_the_edge a s).
    - now apply (on_the_edge b t).
    - intros parallel. apply turn. destruct (cross_of_parts s t e f long_e long_f part t_part) as (c & _ & -> & _).
      rewrite parallel. ring.
  Qed.

  Theorem shown_part (s piece : segment) : In s (boundary_pieces a) ->
    In piece (cut_where_met s (boundary_pieces b)) -> shows_common_interior piece b (boundary_pieces b) = true ->
    boundaries_cross a b \/ exists e c d, part_shows a b e c d.
  Proof.
    intros I J shows. pose proof a_region as (a_edges & _). pose proof b_region as (b_edges & _).
    destruct (boundary_piece_is a s a_edges I) as (e & E & long_e & s_part & no_vertex).
    destruct (part_is_long s e s_part long_e) as [long_s (c1 & C1 & c1x & c1y)].
    destruct (cut_returns s (flat_map (intersection s) (boundary_pieces b)) long_s) as [parts _].
    destruct (parts piece J) as [piece_part _]. clear parts.
    destruct (part_is_long piece s piece_part long_s) as (_ & c2 & C2 & c2x & c2y).
    destruct (contact_is_a_vertex e s piece (source piece) E s_part I J) as [crossing_ | source_is]; [tauto | now left
      |].
    destruct (contact_is_a_vertex e s piece (target piece) E s_part I J) as [crossing_ | target_is]; [tauto | now left
      |].
    right. exists e, (source piece), (target piece).
    pose proof piece_part as (on_source & on_target & order).
    assert (source_on : lies_on (source piece) e) by now apply (on_the_edge a s).
    assert (target_on : lies_on (target piece) e) by now apply (on_the_edge a s).
    destruct (fraction_on e _ long_e source_on) as (_ & sx & sy).
    destruct (fraction_on e _ long_e target_on) as (_ & tx & ty).
    set (j := fraction e (source piece)) in *. set (k := fraction e (target piece)) in *.
    assert (along_x : vx (along piece) == (k - j) * vx (along e))
      by (unfold along, minus; cbn [vx vy]; rewrite sx, tx; ring).
    assert (along_y : vy (along piece) == (k - j) * vy (along e))
      by (unfold along, minus; cbn [vx vy]; rewrite sy, ty; ring).
    assert (multiple_is : k - j == c2 * c1).
    { pose proof (square_positive _ long_e) as square. unfold dot in square.
      apply (Qmult_inj_r _ _ (vx (along e) * vx (along e) + vy (along e) * vy (along e))); [lra |].
      setoid_replace ((k - j) * (vx (along e) * vx (along e) + vy (along e) * vy (along e))) with
        ((k - j) * vx (along e) * vx (along e) + (k - j) * vy (along e) * vy (along e)) by ring.
      rewrite <- along_x, <- along_y, c2x, c2y, c1x, c1y. ring. }
    assert (some : 0 < c2 * c1) by now apply Qmult_lt_0_compat.
    pose proof (middle_is_inside piece) as in_piece.
    assert (middle_eq : midpoint (source piece) (target piece) = middle piece) by reflexivity.
    repeat split; trivial.
    - fold j k. lra.
    - intros v vertex on [after before]. fold j in after. fold k in before.
      destruct (fraction_on e _ long_e on) as (_ & v_x & v_y). set (l := fraction e v) in *.
      assert (in_v : strictly_inside v piece).
      { assert (ratio : (l - j) / (k - j) * (k - j) == l - j) by (field; lra).
        exists ((l - j) / (k - j)). split.
        - split; [apply Qlt_shift_div_l; lra | apply Qlt_shift_div_r; lra].
        - set (r := (l - j) / (k - j)) in *. clearbody r. assert (l_is : l == j + r * (k - j)) by lra.
          rewrite sx, sy, tx, ty, v_x, v_y, l_is. split; ring. }
      destruct vertex as [of_a | of_b].
      + destruct (no_vertex v (strictly_inside_part piece s v long_s piece_part in_v)) as [_ none]. contradiction.
      + destruct (vertex_ends_a_piece b v b_edges of_b) as (u & U & equal).
        destruct (nothing_meets_a_piece s _ piece u v long_s J in_v U) as (no_source & _). exact (no_source equal).
    - unfold middle_shows. rewrite middle_eq.
      unfold shows_common_interior in shows. pose proof (locate_returns (middle piece) b) as where_.
      destruct (locate (middle piece) b); [discriminate | right | now left].
      apply existsb_exists in shows. destruct shows as (t & T & both). apply andb_true_iff in both.
      destruct both as [on_t same_way].
      destruct (is_on_spec (middle piece) t) as [on_t' |]; [clear on_t | discriminate].
      destruct (boundary_piece_is b t b_edges T) as (f & F & long_f & t_part & _). exists f.
      destruct (nothing_meets_a_piece s _ piece t _ long_s J in_piece T) as (_ & _ & parallel).
      specialize (parallel on_t').
      destruct (cross_of_parts s t e f long_e long_f s_part t_part) as (c & C & cross_is & dot_is).
      split; [exact F |]. split; [now apply (on_the_edge b t) |]. split.
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
  - left. destruct (proper_crossing s t found) as (w & in_s & in_t & turn).
    destruct (boundary_piece_is a s (proj1 a_region) I) as (e & E & long_e & s_part & a_free).
    destruct (boundary_piece_is b t (proj1 b_region) J) as (f & F & long_f & t_part & b_free).
    destruct (a_free w in_s) as [on_e no_vertex_a], (b_free w in_t) as [on_f no_vertex_b].
    exists e, f, w. repeat split; trivial. intros parallel. apply turn.
    destruct (cross_of_parts s t e f long_e long_f s_part t_part) as (c & _ & -> & _). rewrite parallel. ring.
  - destruct (shown_part a b a_region b_region s t I J found); tauto.
  - destruct (shown_part b a b_region a_region s t I J found) as [crossing_ | part]; [| tauto].
    left. now apply boundaries_cross_other_way.
Qed.

(* Where edges cross, there is a point inside both. *)
Lemma edges_that_cross_show (a b : region) : valid_region a -> valid_region b -> boundaries_cross a b -> meet_inside a
  b.
Proof.
  intros a_region b_region (e & f & w & E & F & on_e & on_f & not_a & not_b & turn).
  now apply (crossing_edges_show a b e f w).
Qed.

(* Along an edge. *)
Lemma fraction_ahead (e : segment) (u w : vector) (r : Q) : nonzero (along e) ->
  vx u == vx w + r * vx (along e) -> vy u == vy w + r * vy (along e) -> fraction e u == fraction e w + r.
Proof.
  intros long X Y. pose proof (square_positive _ long) as square. unfold fraction.
  assert (top : dot (minus u (source e)) (along e) ==
    dot (minus w (source e)) (along e) + r * dot (along e) (along e))
    by (unfold dot, minus; cbn [vx vy]; rewrite X, Y; ring).
  rewrite top. field. lra.
Qed.

Lemma ahead_by_fractions (e : segment) (u w : vector) : nonzero (along e) -> lies_on u e -> lies_on w e ->
  vx u == vx w + (fraction e u - fraction e w) * vx (along e) /\
  vy u == vy w + (fraction e u - fraction e w) * vy (along e).
Proof.
  intros long on_u on_w. destruct (fraction_on e u long on_u) as (_ & ux & uy).
  destruct (fraction_on e w long on_w) as (_ & wx & wy). set (j := fraction e u) in *. set (k := fraction e w) in *.
  rewrite ux, uy, wx, wy. unfold along, minus; cbn [vx vy]. split; ring.
Qed.

Lemma on_by_fraction (e : segment) (u w : vector) (r : Q) : nonzero (along e) -> lies_on w e ->
  vx u == vx w + r * vx (along e) -> vy u == vy w + r * vy (along e) -> 0 <= fraction e u <= 1 -> lies_on u e.
Proof.
  intros long on X Y range. pose proof (fraction_ahead e u w r long X Y) as u_is.
  destruct (fraction_on e w long on) as (_ & wx & wy). exists (fraction e u). split; [exact range |].
  rewrite u_is. set (k := fraction e w) in *. rewrite X, Y, wx, wy. unfold along, minus; cbn [vx vy]. split; ring.
Qed.

Lemma same_fraction (e : segment) (u w : vector) : nonzero (along e) -> lies_on u e -> lies_on w e ->
  fraction e u == fraction e w -> equal_vectors u w.
Proof.
  intros long on_u on_w same_. destruct (ahead_by_fractions e u w long on_u on_w) as [X Y].
  rewrite same_ in X, Y. split; [rewrite X | rewrite Y]; ring.
Qed.

(* What is parallel to e and has a point strictly between c and d runs along all of that part. *)
Lemma runs_along_the_part (a b : region) (e f : segment) (c d w v : vector) :
  no_edges_are_points a -> no_edges_are_points b -> In e (region_edges a) -> In f (region_edges b) ->
  lies_on c e -> lies_on d e -> no_vertex_between a b e c d ->
  lies_on w e -> comes_between e c d w -> lies_on w f -> cross (along e) (along f) == 0 ->
  lies_on v e -> fraction e c <= fraction e v -> fraction e v <= fraction e d -> lies_on v f.
Proof.
  intros a_edges b_edges E F on_c on_d none on_w [w_after w_before] on_f parallel on_v v_after v_before.
  pose proof (region_edges_are_directions a a_edges e E) as long_e.
  pose proof (region_edges_are_directions b b_edges f F) as long_f.
  destruct (multiple_of (along f) (along e) long_e) as (m & mx & my); [unfold cross in *; lra |].
  destruct (fraction_on e c long_e on_c) as (c_range & _). destruct (fraction_on e d long_e on_d) as (d_range & _).
  destruct on_f as (k & k_range & kx & ky).
  assert (vertex_outside : forall u r, is_vertex u b -> vx u == vx w + r * vx (along e) ->
    vy u == vy w + r * vy (along e) -> fraction e w + r <= fraction e c \/ fraction e d <= fraction e w + r).
  { intros u r vertex X Y. pose proof (fraction_ahead e u w r long_e X Y) as u_is.
    destruct (Qlt_le_dec (fraction e c) (fraction e w + r)) as [after |]; [| now left].
    destruct (Qlt_le_dec (fraction e w + r) (fraction e d)) as [before |]; [exfalso | now right].
    apply (none u); [now right | | split; lra]. apply (on_by_fraction e u w r); trivial. lra. }
  assert (fx : vx (target f) - vx (source f) == m * vx (along e)) by exact mx.
  assert (fy : vy (target f) - vy (source f) == m * vy (along e)) by exact my.
  assert (at_source : fraction e w + - (k * m) <= fraction e c \/ fraction e d <= fraction e w + - (k * m)).
  { apply (vertex_outside (source f)); [exists f; split; [exact F | split; reflexivity] | |].
    - setoid_replace (vx w + - (k * m) * vx (along e)) with (vx w - k * (m * vx (along e))) by ring.
      rewrite <- fx, kx. ring.
    - setoid_replace (vy w + - (k * m) * vy (along e)) with (vy w - k * (m * vy (along e))) by ring.
      rewrite <- fy, ky. ring. }
  assert (at_target : fraction e w + (1 - k) * m <= fraction e c \/ fraction e d <= fraction e w + (1 - k) * m).
  { apply (vertex_outside (target f)); [now apply target_is_vertex | |].
    - setoid_replace (vx w + (1 - k) * m * vx (along e)) with (vx w + (1 - k) * (m * vx (along e))) by ring.
      rewrite <- fx, kx. ring.
    - setoid_replace (vy w + (1 - k) * m * vy (along e)) with (vy w + (1 - k) * (m * vy (along e))) by ring.
      rewrite <- fy, ky. ring. }
  destruct (ahead_by_fractions e v w long_e on_v on_w) as [vx_is vy_is].
  assert (some : ~ m == 0).
  { intros zero_. apply long_f. rewrite mx, my, zero_. split; ring. }
  set (step := fraction e v - fraction e w) in *.
  assert (ratio : step / m * m == step) by (field; exact some). set (r := step / m) in *. clearbody r.
  assert (range : 0 <= k + r <= 1).
  { assert (0 <= k * m \/ k * m <= 0) by (destruct (Qlt_le_dec 0 (k * m)); lra).
    destruct (Q_dec m 0) as [[low | high] | none_]; [| | contradiction].
    - assert (0 <= k * - m) by (apply Qmult_le_0_compat; lra).
      assert (0 <= (1 - k) * - m) by (apply Qmult_le_0_compat; lra). unfold step in *.
      split; apply Qnot_lt_le; intros extreme; nra.
    - assert (0 <= k * m) by (apply Qmult_le_0_compat; lra).
      assert (0 <= (1 - k) * m) by (apply Qmult_le_0_compat; lra). unfold step in *.
      split; apply Qnot_lt_le; intros extreme; nra. }
  exists (k + r). split; [exact range |]. rewrite vx_is, vy_is, <- ratio.
  setoid_replace (r * m * vx (along e)) with (r * (m * vx (along e))) by ring.
  setoid_replace (r * m * vy (along e)) with (r * (m * vy (along e))) by ring.
  rewrite <- fx, <- fy, kx, ky. split; ring.
Qed.
