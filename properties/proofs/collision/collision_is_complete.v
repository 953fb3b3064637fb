(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The naive collision test (naive_collision.v) misses nothing: where a point is inside two regions whose winding numbers
   are 0 and 1, it returns true. Of all edges that a ray from such a point meets take the first, as in first_hit.v,
   at a height at which no piece ends. Where it is met, it is inside the other region, and so is the middle of its
   piece; or an edge of the other region is met, too, which runs along the whole piece (met_pieces.v), and in the same
   direction: else the winding number behind one of the two would be 2. That the test is right where it returns true is
   in collision_is_sound.v. *)
From Coq Require Import ZArith Lia Bool List.
From Oplus Require Import numbers regions_and_sums location pieces naive_collision met_pieces collision_is_sound.
Import ListNotations.

Open Scope Q_scope.

(* Nothing is covered twice. *)
Definition nowhere_above_one (r : region) : Prop :=
  forall x, off x (region_edges r) -> (winding_number x (region_edges r) <= 1)%Z.

Lemma strictly_inside_between (v w x : vector) (s : segment) : strictly_inside v s -> strictly_inside w s ->
  lies_on x (Segment v w) -> strictly_inside x s.
Proof.
  intros (k & k_range & kx & ky) (l & l_range & lx & ly) (t & t_range & tx & ty). cbn [source target] in *.
  exists ((1 - t) * k + t * l). split; [split; [apply mixed_is_more | apply mixed_is_less]; lra |].
  rewrite tx, ty, kx, ky, lx, ly. split; ring.
Qed.

(* Theorem. What has a point strictly inside a piece runs along all of it. *)
Theorem runs_along_the_piece (s : segment) (others : list segment) (piece t : segment) (v w : vector) :
  nonzero (along s) -> In piece (cut_where_met s others) -> In t others -> nonzero (along t) ->
  strictly_inside v piece -> lies_on v t -> strictly_inside w piece -> lies_on w t.
Proof.
  intros long I J long_t in_v on_v in_w.
  destruct (nothing_meets_a_piece s others piece t v long I in_v J) as (_ & _ & parallel). specialize (parallel on_v).
  assert (no_end : forall x, lies_on x (Segment v w) -> ~ equal_vectors x (source t) /\ ~ equal_vectors x (target t)).
  { intros x on. pose proof (strictly_inside_between v w x piece in_v in_w on) as in_x.
    destruct (nothing_meets_a_piece s others piece t x long I in_x J) as (no_source & no_target & _). now split. }
  destruct (cut_returns s (flat_map (intersection s) others) long) as [parts _].
  destruct (parts piece I) as [part _]. destruct (part_is_long piece s part long) as (_ & d & D & dx & dy).
  destruct (multiple_of (along s) (along t) long_t parallel) as (c & cx & cy).
  destruct in_v as (k & k_range & kx & ky), in_w as (l & l_range & lx & ly).
  destruct on_v as (m & m_range & mx & my).
  set (step := (l - k) * d * c).
  assert (x_is : vx w == (1 - (m + step)) * vx (source t) + (m + step) * vx (target t)).
  { unfold step. clear - kx lx mx dx cx. in_coordinates. by_equations. }
  assert (y_is : vy w == (1 - (m + step)) * vy (source t) + (m + step) * vy (target t)).
  { unfold step. clear - ky ly my dy cy. in_coordinates. by_equations. }
  clearbody step. exists (m + step). split; [| now split].
  destruct (Qlt_le_dec (m + step) 0) as [below | above]; [exfalso | split; [exact above |]].
  - assert (quotient : - m / step * step == - m) by (field; lra).
    set (r := - m / step) in *. clearbody r. assert (r_range : 0 <= r <= 1) by (split; nra).
    destruct (no_end (source t)) as [not_source _]; [| apply not_source; split; reflexivity].
    exists r. cbn [source target]. split; [exact r_range |].
    clear - x_is y_is mx my quotient. split; by_equations.
  - destruct (Qlt_le_dec 1 (m + step)) as [beyond | fine]; [exfalso | exact fine].
    assert (quotient : (1 - m) / step * step == 1 - m) by (field; lra).
    set (r := (1 - m) / step) in *. clearbody r. assert (r_range : 0 <= r <= 1) by (split; nra).
    destruct (no_end (target t)) as [_ not_target]; [| apply not_target; split; reflexivity].
    exists r. cbn [source target]. split; [exact r_range |].
    clear - x_is y_is mx my quotient. split; by_equations.
Qed.

(* Pieces of the boundary of a, cut once more where the boundary of b meets them. *)
Definition pieces_between_contacts (a b : region) : list segment :=
  flat_map (fun s => cut_where_met s (boundary_pieces b)) (boundary_pieces a).

(* No end of a segment is at this height. *)
Definition no_end_at (y : Q) (segments : list segment) : Prop :=
  forall s, In s segments -> ~ vy (source s) == y /\ ~ vy (target s) == y.

Lemma on_a_piece (r : region) (e : segment) (w : vector) : no_edges_are_points r -> In e (region_edges r) ->
  lies_on w e -> exists t, In t (boundary_pieces r) /\ is_part t e /\ lies_on w t.
Proof.
  intros not_points E on. pose proof (region_edges_are_directions r not_points e E) as long.
  destruct (cut_returns e (flat_map (intersection e) (region_edges r)) long) as [_ cover].
  destruct (cover w on) as (t & T & part & on_t). exists t. split; [apply in_flat_map; now exists e | now split].
Qed.

Section FirstHit.
  Variables a b : region.
  Variable z : vector.
  Variable s : segment.
  Hypothesis a_region : valid_region a.
  Hypothesis b_region : valid_region b.
  Hypothesis a_simple : nowhere_above_one a.
  Hypothesis b_simple : nowhere_above_one b.
  Hypothesis in_a : inside z a.
  Hypothesis in_b : inside z b.
  Hypothesis no_edge_ends : no_end_at (vy z) (region_edges a ++ region_edges b).
  Hypothesis no_piece_ends : no_end_at (vy z) (pieces_between_contacts a b).
  Hypothesis of_a : In s (region_edges a).
  Hypothesis met : signed_crossing z s <> 0%Z.
  Hypothesis first : forall t, In t (region_edges a ++ region_edges b) -> signed_crossing z t <> 0%Z ->
    vx (point_at_height s (vy z)) <= vx (point_at_height t (vy z)).

  Let w := point_at_height s (vy z).

  Lemma hit_is_ahead : lies_on w s /\ vx z < vx w.
  Proof.
    destruct (crossed_ahead z s met) as [spanning ahead]. split; [now apply point_at_height_lies_on | exact ahead].
  Qed.

  Lemma height_along (v : vector) : lies_on v (Segment z w) -> vy v == vy z /\ vx z <= vx v <= vx w.
  Proof.
    destruct hit_is_ahead as [_ ahead]. intros (t & range & X & Y). cbn [source target] in *.
    change (vy w) with (vy z) in Y. split; [rewrite Y; ring |]. rewrite X. split; nra.
  Qed.

  Lemma free_before_the_hit (v : vector) : lies_on v (Segment z w) -> vx v < vx w ->
    off v (region_edges a ++ region_edges b).
  Proof.
    intros on before f F on_f. destruct (height_along v on) as [height range].
    destruct (no_edge_ends f F) as [no_source no_target].
    destruct (met_at_height v f (vy z) on_f height no_source no_target) as [spanning here].
    destruct (Qlt_le_dec (vx z) (vx v)) as [after_z | at_z].
    - assert (vx w <= vx (point_at_height f (vy z))); [| lra]. apply first; [exact F |].
      apply ahead_is_crossed; [exact spanning | lra].
    - assert (on_z : lies_on z f) by (apply (lies_on_equal v); [split; lra | exact on_f]).
      apply in_app_iff in F. destruct F as [F | F].
      + exact (proj1 in_a f F on_z).
      + exact (proj1 in_b f F on_z).
  Qed.

  (* Just before the hit the winding numbers are those of z. *)
  Lemma same_before_the_hit (r : region) (v : vector) :
    incl (region_edges r) (region_edges a ++ region_edges b) -> lies_on v (Segment z w) -> vx v < vx w ->
    winding_number v (region_edges r) = winding_number z (region_edges r).
  Proof.
    intros part on before. symmetry. apply (winding_number_along (Segment z v) _ (region_cycles r)).
    intros u on_u f F. apply (free_before_the_hit u).
    - destruct on as (t & t_range & tx & ty), on_u as (k & k_range & kx & ky). cbn [source target] in *.
      exists (k * t). cbn [source target]. split; [split; nra |]. rewrite kx, ky, tx, ty. split; ring.
    - destruct (height_along v on) as [_ range]. destruct on_u as (k & k_range & kx & _). cbn [source target] in *.
      rewrite kx. nra.
    - now apply part.
  Qed.

  (* Neither boundary turns its right side to the hit from both regions. *)
  Lemma not_behind (r : region) (g : segment) : valid_region r -> nowhere_above_one r -> inside z r ->
    incl (region_edges r) (region_edges a ++ region_edges b) -> In g (region_edges r) -> lies_on w g ->
    ~ is_vertex w r -> 0 < cross (along g) (Vector 1 0) -> False.
  Proof.
    intros (_ & _ & meet) simple [_ positive_] part G on no_vertex left_.
    destruct hit_is_ahead as [_ ahead].
    destruct (some_small _ (eventually_and _ _ (left_is_one_more r g w (Vector 1 0) meet G on no_vertex left_)
      (eventually_below (vx w - vx z) ltac:(lra)))) as (e & _ & (off_ & _ & more) & E & E_ahead).
    pose proof (simple _ off_) as at_most_one.
    rewrite (same_before_the_hit r (moved_along w (Vector 1 0) (- e)) part) in more; [lia | |].
    - assert (quotient : e / (vx w - vx z) * (vx w - vx z) == e) by (field; lra).
      set (k := e / (vx w - vx z)) in *. clearbody k. exists (1 - k). cbn [source target].
      split; [split; nra |]. unfold moved_along; cbn [vx vy]. change (vy w) with (vy z). split; [lra | ring].
    - unfold moved_along; cbn [vx]. lra.
  Qed.

  Theorem first_hit_shows : boundary_enters (boundary_pieces a) b (boundary_pieces b) = true.
  Proof.
    pose proof a_region as (a_edges & a_valid & a_meet). pose proof b_region as (b_edges & b_valid & b_meet).
    destruct hit_is_ahead as [on_s ahead].
    destruct (on_a_piece a s w a_edges of_a on_s) as (s' & I & s_part & on_s').
    pose proof (region_edges_are_directions a a_edges s of_a) as long_s.
    destruct (part_is_long s' s s_part long_s) as (long_s' & c & C & cx & cy).
    destruct (cut_returns s' (flat_map (intersection s') (boundary_pieces b)) long_s') as [_ cover].
    destruct (cover w on_s') as (piece & J & part & on_piece).
    assert (in_piece : strictly_inside w piece).
    { destruct (no_piece_ends piece) as [no_source no_target]; [apply in_flat_map; now exists s' |].
      now apply inside_by_height. }
    apply existsb_exists. exists s'. split; [exact I |]. apply existsb_exists. exists piece. split; [exact J |].
    pose proof (middle_is_inside piece) as in_middle.
    assert (runs : forall f, In f (region_edges b) -> forall v, strictly_inside v piece -> lies_on v f ->
      exists t, In t (boundary_pieces b) /\ is_part t f /\ nonzero (along t) /\
        forall u, strictly_inside u piece -> lies_on u t).
    { intros f F v in_v on_f. destruct (on_a_piece b f v b_edges F on_f) as (t & T & t_part & on_t).
      pose proof (region_edges_are_directions b b_edges f F) as long_f.
      destruct (part_is_long t f t_part long_f) as [long_t _]. exists t.
      split; [exact T |]. split; [exact t_part |]. split; [exact long_t |].
      intros u in_u. exact (runs_along_the_piece s' _ piece t v u long_s' J T long_t in_v on_t in_u). }
    assert (on_edge : forall t f v, In f (region_edges b) -> is_part t f -> lies_on v t -> lies_on v f).
    { intros t f v F t_part (k & range & X & Y).
      pose proof (region_edges_are_directions b b_edges f F) as long_f.
      now destruct (point_of_part t f v k long_f t_part range X Y). }
    unfold shows_common_interior. pose proof (locate_returns (middle piece) b) as where_.
    destruct (on_or_off w (region_edges b)) as [(f & F & on_f) | free].
    - destruct (runs f F w in_piece on_f) as (t & T & t_part & long_t & all_on).
      pose proof (region_edges_are_directions b b_edges f F) as long_f.
      destruct (part_is_long t f t_part long_f) as (_ & d & D & dx & dy).
      pose proof (all_on _ in_middle) as middle_on.
      assert (middle_on_f : lies_on (middle piece) f) by now apply (on_edge t).
      destruct (locate (middle piece) b);
        [destruct where_ as [off_ _]; exfalso; exact (off_ f F middle_on_f) | |
         destruct where_ as [off_ _]; exfalso; exact (off_ f F middle_on_f)].
      apply existsb_exists. exists t. split; [exact T |]. apply andb_true_iff.
      split; [now destruct (is_on_spec (middle piece) t) |].
      destruct (nothing_meets_a_piece s' _ piece t w long_s' J in_piece T) as (_ & _ & parallel).
      specialize (parallel (all_on w in_piece)).
      destruct (part_is_long piece s' part long_s') as (_ & k & K & kx & ky).
      destruct (multiple_of (along s') (along t) long_t parallel) as (l & lx & ly).
      pose proof (square_positive _ long_t) as square.
      assert (product : dot (along t) (along piece) == k * l * dot (along t) (along t))
        by (unfold dot; rewrite kx, ky, lx, ly; ring).
      destruct (Qlt_le_dec 0 l) as [same_way | other_way].
      { unfold positive. destruct (negative_spec (- dot (along t) (along piece))) as [| not_negative]; [reflexivity |].
        exfalso. apply not_negative. rewrite product.
        assert (0 < k * l) by now apply Qmult_lt_0_compat.
        assert (0 < k * l * dot (along t) (along t)) by now apply Qmult_lt_0_compat. lra. }
      exfalso.
      (* They run in opposite directions. *)
      assert (a_free : ~ is_vertex w a).
      { destruct (boundary_piece_is a s' a_edges I) as (e & _ & _ & _ & no_vertex).
        now destruct (no_vertex w (strictly_inside_part piece s' w long_s' part in_piece)). }
      assert (b_free : ~ is_vertex w b).
      { intros vertex. destruct (vertex_ends_a_piece b _ b_edges vertex) as (u & U & equal).
        destruct (nothing_meets_a_piece s' _ piece u _ long_s' J in_piece U) as (no_source & _).
        exact (no_source equal). }
      assert (heights : ~ vy (along s) == 0).
      { destruct (no_edge_ends s) as [no_source _]; [apply in_app_iff; now left |]. intros flat.
        apply no_source. destruct on_s as (m & _ & _ & my). change (vy w) with (vy z) in my. rewrite my.
        unfold along, minus in flat; cbn [vy] in flat.
        assert (vy (target s) == vy (source s)) as -> by lra. ring. }
      assert (s_by_f : c * vy (along s) == l * d * vy (along f)) by (rewrite <- cy, ly, dy; ring).
      assert (l_negative : l < 0).
      { destruct (Qlt_le_dec l 0) as [| not_negative]; [assumption |]. exfalso. apply heights.
        assert (l_is : l == 0) by lra. rewrite l_is in s_by_f.
        destruct (Qmult_integral c (vy (along s))); [lra | exfalso; lra | assumption]. }
      assert (l * d < 0) by nra.
      destruct (Q_dec (vy (along s)) 0) as [[down | up] | flat]; [| | contradiction].
      + apply (not_behind a s a_region a_simple in_a); trivial.
        * intros g G. apply in_app_iff. now left.
        * unfold cross; cbn [vx vy]. lra.
      + apply (not_behind b f b_region b_simple in_b); trivial.
        * intros g G. apply in_app_iff. now right.
        * unfold cross; cbn [vx vy]. assert (0 < c * vy (along s)) by now apply Qmult_lt_0_compat.
          destruct (Qlt_le_dec (vy (along f)) 0); [lra | exfalso; nra].
    - assert (inside_w : winding_number w (region_edges b) = winding_number z (region_edges b)).
      { symmetry. apply (winding_number_along (Segment z w) _ (region_cycles b)). intros v on.
        destruct (height_along v on) as [height range].
        destruct (Qlt_le_dec (vx v) (vx w)) as [before | here].
        - intros g G. apply (free_before_the_hit v on before). apply in_app_iff. now right.
        - apply (off_equal w); [| exact free]. split; [lra |]. change (vy w) with (vy z). symmetry. exact height. }
      assert (free_piece : forall v, strictly_inside v piece -> off v (region_edges b)).
      { intros v in_v f F on_f. destruct (runs f F v in_v on_f) as (t & _ & t_part & _ & all_on).
        apply (free f F). apply (on_edge t); trivial. now apply all_on. }
      assert (inside_middle : winding_number (middle piece) (region_edges b) = winding_number w (region_edges b)).
      { symmetry. apply (winding_number_along (Segment w (middle piece)) _ (region_cycles b)). intros v on.
        apply free_piece. now apply (strictly_inside_between w (middle piece)). }
      pose proof (free_piece _ in_middle) as free_middle. destruct in_b as [_ positive_].
      destruct (locate (middle piece) b); [| | reflexivity]; exfalso.
      + destruct where_ as [_ not_inside]. apply not_inside. split; [exact free_middle | lia].
      + destruct where_ as (f & F & on_f). exact (free_middle f F on_f).
  Qed.
End FirstHit.

(* Near a point inside both is another at whose height no segment of a list ends. *)
Lemma inside_at_another_height (a b : region) (z : vector) (segments : list segment) : inside z a -> inside z b ->
  exists y, inside y a /\ inside y b /\ no_end_at (vy y) segments.
Proof.
  intros [off_a in_a] [off_b in_b].
  destruct (winding_number_near z _ (region_cycles a) off_a) as (r1 & R1 & near_a).
  destruct (winding_number_near z _ (region_cycles b) off_b) as (r2 & R2 & near_b).
  assert (leaves : forall c, eventually (fun e => ~ c == vy (moved_along z (Vector 0 1) e))).
  { intros c. refine (eventually_implied _ _ _ (leaves_a_number (vy z) 1 c _)); [| lra].
    intros e differ equal. apply differ. now symmetry. }
  destruct (some_small _ (eventually_and _ _ (small_steps_stay_within r1 z (Vector 0 1) R1)
    (eventually_and _ _ (small_steps_stay_within r2 z (Vector 0 1) R2)
      (eventually_for_all (fun s e => ~ vy (source s) == vy (moved_along z (Vector 0 1) e) /\
          ~ vy (target s) == vy (moved_along z (Vector 0 1) e)) segments
        (fun s _ => eventually_and _ _ (leaves (vy (source s))) (leaves (vy (target s))))))))
    as (height & _ & close_a & close_b & heights).
  destruct (near_a _ close_a) as [free_a same_a], (near_b _ close_b) as [free_b same_b].
  exists (moved_along z (Vector 0 1) height).
  split; [split; [exact free_a | lia] |]. split; [split; [exact free_b | lia] |]. exact heights.
Qed.

(* Theorem. If a point is inside two valid regions whose winding numbers are at most 1, the collision test returns
   true. *)
Theorem collide_is_complete (a b : region) (z : vector) :
  valid_region a -> valid_region b -> nowhere_above_one a -> nowhere_above_one b ->
  inside z a -> inside z b -> collide a b = true.
Proof.
  intros a_region b_region a_simple b_simple in_a_ in_b_.
  destruct (inside_at_another_height a b z
    ((region_edges a ++ region_edges b) ++ (region_edges b ++ region_edges a) ++
     pieces_between_contacts a b ++ pieces_between_contacts b a) in_a_ in_b_) as (y & in_a & in_b & heights).
  clear in_a_ in_b_ z.
  destruct (first_crossed y (region_edges a ++ region_edges b)) as [none | (s & I & met & first_of_all)].
  { destruct in_a as [_ positive_]. assert (winding_number y (region_edges a) = 0%Z); [| lia].
    apply sum_of_zeros. intros s I. apply none, in_app_iff. now left. }
  unfold collide. rewrite !orb_true_iff. apply in_app_iff in I. destruct I as [I | I].
  - left. right. apply (first_hit_shows a b y s); trivial.
    + intros t J. apply heights, in_app_iff. now left.
    + intros t J. apply heights. rewrite !in_app_iff. tauto.
  - right. apply (first_hit_shows b a y s); trivial.
    + intros t J. apply heights. rewrite !in_app_iff in *. tauto.
    + intros t J. apply heights. rewrite !in_app_iff. tauto.
    + intros t J. apply first_of_all. rewrite !in_app_iff in *. tauto.
Qed.

(* Theorem. The naive collision test decides whether there is a point inside both regions. *)
Theorem collide_returns (a b : region) :
  valid_region a -> valid_region b -> nowhere_above_one a -> nowhere_above_one b ->
  (collide a b = true <-> exists z, inside z a /\ inside z b).
Proof.
  intros a_region b_region a_simple b_simple. split.
  - now apply collide_is_sound.
  - intros (z & in_a & in_b). now apply (collide_is_complete a b z).
Qed.
