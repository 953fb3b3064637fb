(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* What the naive collision test (naive_collision.v) says of a piece of one boundary: whether the points close to its
   left, which are inside the piece's own region, are inside the other region, too. So what the test finds is there:
   where it says that the interiors of two valid regions meet, there is a point inside both. Two pieces that cross do
   so at no vertex, and to the left of both is inside (left_of_an_edge.v). *)
From Coq Require Import ZArith Lia Bool List.
From Oplus Require Import numbers regions_and_sums inside_a_corner observation_2_2_4 right_of_an_edge location pieces
  naive_collision met_pieces.
Import ListNotations.

Open Scope Q_scope.

(* Nothing is covered twice. *)
Definition nowhere_above_one (r : region) : Prop :=
  forall x, off x (region_edges r) -> (winding_number x (region_edges r) <= 1)%Z.

(* Around a point of an edge that is no vertex, what is to the left of the edge is inside, and nothing else. *)
Lemma inside_beside_an_edge (r : region) (s : segment) (w : vector) : valid_region r -> nowhere_above_one r ->
  In s (region_edges r) -> lies_on w s -> ~ is_vertex w r ->
  exists radius, 0 < radius /\ forall z, within radius w z -> (inside z r <-> 0 < area s z) /\
    (area s z < 0 -> (winding_number z (region_edges r) <= 0)%Z).
Proof.
  intros r_region simple S on free. pose proof r_region as (not_points & _ & meet).
  destruct (fills_left_beside_an_edge r s w r_region S on free) as (r0 & R0 & fills).
  destruct (on_its_edge_near s w (strictly_between r s w (region_edges_are_directions r not_points s S) S on free))
    as (r3 & R3 & along_).
  destruct (right_side_near r s w meet S on free) as (r2 & R2 & right_).
  pose proof (left_normal s (region_edges_are_directions r not_points s S)) as turn. set (n := Vector _ _) in turn.
  destruct (some_small _ (eventually_and _ _ (left_is_one_more r s w n meet S on free turn)
    (small_steps_stay_within r2 w (opposite n) R2))) as (e & some & (off_left & _ & more) & close).
  pose proof (simple _ off_left) as at_most. set (v := moved_along w n (- e)) in more.
  assert (v_right : area s v < 0) by now apply (right_step_is_right s w n e (on_the_line w s on)).
  exists (Qmin (Qmin r0 r3) r2). split; [now repeat apply Q.min_glb_lt |]. intros z near.
  pose proof (within_smaller _ _ _ _ (Q.le_min_l (Qmin r0 r3) r2) near) as near_1.
  pose proof (fills z (within_smaller _ _ _ _ (Q.le_min_l r0 r3) near_1)) as inside_left.
  rewrite <- (area_from w z s on) in inside_left.
  pose proof (along_ z (within_smaller _ _ _ _ (Q.le_min_r r0 r3) near_1)) as on_line.
  apply (within_smaller _ _ _ _ (Q.le_min_r (Qmin r0 r3) r2)) in near.
  assert (none : area s z < 0 -> (winding_number z (region_edges r) <= 0)%Z).
  { intros z_right. rewrite (right_ z v near); [lia | | exact z_right | exact v_right].
    unfold within, v, moved_along, opposite in *. cbn [vx vy] in *. lra. }
  split; [| exact none]. split; [| exact inside_left]. intros [off_z positive_].
  destruct (Q_dec (area s z) 0) as [[low | high] | line]; [specialize (none low); lia | exact high |].
  now destruct (off_z s S); apply on_line.
Qed.

(* Near every point of an edge is one outside. *)
Lemma outside_is_near (r : region) (x : vector) (s : segment) (radius : Q) : valid_region r -> nowhere_above_one r ->
  In s (region_edges r) -> lies_on x s -> 0 < radius ->
  exists y, within radius x y /\ off y (region_edges r) /\ winding_number y (region_edges r) = 0%Z.
Proof.
  intros (not_points & not_negative & meet) simple S on R.
  pose proof (region_edges_are_directions r not_points s S) as long.
  destruct (no_vertex_near r s x ((1 # 2) * radius) long on) as (w & near_w & on_w & no_vertex); [lra |].
  set (n := Vector (- vy (along s)) (vx (along s))). pose proof (left_normal s long) as left_. fold n in left_.
  assert (half_ : 0 < (1 # 2) * radius) by lra.
  destruct (some_small _ (eventually_and _ _ (left_is_one_more r s w n meet S on_w no_vertex left_)
    (small_steps_stay_within _ w (opposite n) half_))) as (e & _ & (off_left & off_right & more) & close).
  exists (moved_along w n (- e)). split; [| split; [exact off_right |]].
  - clear - near_w close. unfold within, moved_along, opposite in *; cbn [vx vy] in *. lra.
  - pose proof (simple _ off_left). pose proof (not_negative _ off_right). lia.
Qed.

Lemma middle_is_inside (s : segment) : strictly_inside (middle s) s.
Proof. exists (1 # 2). unfold middle; cbn [vx vy]. split; [lra |]. split; field. Qed.

(* Two edges that cross. *)
Lemma crossing_edges_show (a b : region) (e f : segment) (w : vector) :
  valid_region a -> valid_region b -> In e (region_edges a) -> In f (region_edges b) ->
  lies_on w e -> lies_on w f -> ~ is_vertex w a -> ~ is_vertex w b ->
  ~ cross (along e) (along f) == 0 -> exists z, inside z a /\ inside z b.
Proof.
  intros (_ & a_valid & a_meet) (_ & b_valid & b_meet) E F on_e on_f a_free b_free turn.
  assert (found : forall n, 0 < cross (along e) n -> 0 < cross (along f) n -> exists z, inside z a /\ inside z b).
  { intros n left_of_e left_of_f. destruct (some_small _ (eventually_and _ _
      (left_of_an_edge_is_inside a e w n a_valid a_meet E on_e a_free left_of_e)
      (left_of_an_edge_is_inside b f w n b_valid b_meet F on_f b_free left_of_f))) as (d & _ & both).
    now exists (moved_along w n d). }
  destruct (Q_dec (cross (along e) (along f)) 0) as [[right_ | left_] | none]; [| | contradiction];
    [apply (found (minus (along e) (along f))) | apply (found (minus (along f) (along e)))];
    unfold cross, minus in *; cbn [vx vy] in *; lra.
Qed.

(* Theorem. What the test returns for a piece of the boundary of a, between two contacts with that of b, is whether
   close to its left is inside b. *)
Theorem test_of_a_piece (a b : region) (s piece : segment) (w n : vector) :
  valid_region a -> valid_region b -> nowhere_above_one b ->
  In s (boundary_pieces a) -> In piece (cut_where_met s (boundary_pieces b)) ->
  strictly_inside w piece -> 0 < cross (along piece) n ->
  eventually (fun d => shows_common_interior piece b (boundary_pieces b) = true <->
    (0 < winding_number (moved_along w n d) (region_edges b))%Z).
Proof.
  intros a_region b_region b_simple I J in_piece w_left.
  destruct (contact_piece_is a b s piece (proj1 a_region) (proj1 b_region) I J) as (long & only & e & _ & _ & free).
  pose proof (middle_is_inside piece) as in_middle. destruct (free _ in_middle) as (_ & _ & no_vertex). clear free e.
  assert (beside : forall v n, strictly_inside v piece -> 0 < cross (along piece) n ->
    eventually (fun d => winding_number (moved_along v n d) (region_edges b) =
      winding_number_shifted (right_of_middle (reversed piece)) (region_edges b))).
  { intros v n' in_v left_. apply to_the_right_of_a_piece; [apply region_cycles | | |
      now apply strictly_inside_reversed | in_coordinates; lra].
    - now apply met_only_along_reversed.
    - intros [X Y]. apply long. in_coordinates. lra. }
  refine (eventually_implied _ _ _ (beside w n in_piece w_left)). intros ? ->. clear w n in_piece w_left.
  set (m := middle piece) in *. set (n := Vector (- vy (along piece)) (vx (along piece))).
  pose proof (left_normal piece long) as left_. fold n in left_.
  specialize (beside m n in_middle left_). set (value := winding_number_shifted _ _) in *.
  assert (same_way : forall f, In f (region_edges b) -> lies_on m f ->
    (0 < dot (along f) (along piece) <-> (0 < value)%Z)).
  { intros f F on. destruct (only m f in_middle F on) as [line_1 line_2].
    destruct (multiple_of (along f) (along piece) long) as (c & cx & cy); [in_coordinates; lra |].
    destruct (inside_beside_an_edge b f m b_region b_simple F on no_vertex) as (radius & R & near).
    destruct (some_small _ (eventually_and _ _ beside (small_steps_stay_within radius m n R)))
      as (d & some & <- & close).
    destruct (near _ close) as [inside_left none].
    assert (area_is : area f (moved_along m n d) == d * (c * cross (along piece) n)).
    { pose proof (on_the_line m f on). transitivity (area f m + d * cross (along f) n); [by_coordinates |].
      unfold cross in *. rewrite cx, cy. lra. }
    assert (dot_is : dot (along f) (along piece) == c * cross (along piece) n)
      by (unfold dot, cross, n; cbn [vx vy]; rewrite cx, cy; ring).
    rewrite dot_is, area_is in *. set (turned := c * cross (along piece) n) in *.
    split; [intros high; apply inside_left, Qmult_lt_0_compat; assumption | intros round].
    destruct (Q_dec turned 0) as [[low |] | flat]; [| assumption |]; exfalso.
    - assert (0 < d * - turned) by (apply Qmult_lt_0_compat; lra). specialize (none ltac:(lra)). lia.
    - destruct (Qmult_integral _ _ flat) as [c_none |]; [| lra].
      apply (region_edges_are_directions b (proj1 b_region) f F). rewrite c_none in cx, cy. split; lra. }
  pose proof (locate_returns m b) as where_. unfold shows_common_interior. fold m.
  destruct (on_or_off m (region_edges b)) as [(f & F & on_f) | off_m].
  - destruct (locate m b); [now destruct (proj1 where_ f F) | | now destruct (proj1 where_ f F)].
    rewrite existsb_exists. split.
    + intros (t & T & both). apply andb_true_iff in both. rewrite <- (reflect_iff _ _ (is_on_spec m t)),
        <- (reflect_iff _ _ (positive_spec _)) in both. destruct both as [on_t same_].
      destruct (boundary_piece_is b t (proj1 b_region) T) as (g & G & long_g & part & _).
      destruct (part_is_long t g part long_g) as (_ & k & K & kx & ky).
      apply (same_way g G (part_lies_on t g m part on_t)). apply (Qmult_lt_l _ _ k K).
      unfold dot in *. rewrite kx, ky in same_. lra.
    + intros round. apply (same_way f F on_f) in round.
      destruct (on_a_piece b f m (proj1 b_region) F on_f) as (t & T & part & on_t). exists t. split; [exact T |].
      destruct (part_is_long t f part (region_edges_are_directions b (proj1 b_region) f F)) as (_ & k & K & kx & ky).
      apply andb_true_iff. rewrite <- (reflect_iff _ _ (is_on_spec m t)), <- (reflect_iff _ _ (positive_spec _)).
      split; [exact on_t |]. apply (Qmult_lt_l _ _ k K) in round. unfold dot in *. rewrite kx, ky. lra.
  - destruct (winding_number_near m _ (region_cycles b) off_m) as (radius & R & near).
    destruct (some_small _ (eventually_and _ _ beside (small_steps_stay_within radius m n R))) as (d & _ & <- & close).
    destruct (near _ close) as [_ ->].
    destruct (locate m b); [| destruct where_ as (f & F & on_f); now destruct (off_m f F) |].
    + split; [discriminate |]. intros round. now destruct (proj2 where_).
    + split; [intros _; apply where_ | reflexivity].
Qed.

Lemma boundary_shows (a b : region) : valid_region a -> valid_region b -> nowhere_above_one b ->
  boundary_enters (boundary_pieces a) b (boundary_pieces b) = true -> exists z, inside z a /\ inside z b.
Proof.
  intros a_region b_region b_simple (s & I & (piece & J & shows)%existsb_exists)%existsb_exists.
  destruct (contact_piece_is a b s piece (proj1 a_region) (proj1 b_region) I J)
    as (long & _ & e & E & (c & C & cx & cy) & free).
  pose proof (middle_is_inside piece) as in_middle. destruct (free _ in_middle) as (on_e & no_vertex & _).
  pose proof (left_normal piece long) as left_. set (n := Vector _ _) in left_.
  destruct a_region as (a_edges & a_valid & a_meet), b_region as (b_edges & b_valid & b_meet).
  assert (left_of_e : 0 < cross (along e) n).
  { apply (Qmult_lt_l _ _ c C). unfold cross in *. rewrite cx, cy in left_. lra. }
  destruct (some_small _ (eventually_and _ _ (test_of_a_piece a b s piece _ n ltac:(now split) ltac:(now split)
    b_simple I J in_middle left_)
    (left_of_an_edge_is_inside a e _ n a_valid a_meet E on_e no_vertex left_of_e))) as (d & _ & round & in_a).
  apply round in shows. destruct (winding_number_near _ _ (region_cycles a) (proj1 in_a)) as (radius & R & near).
  destruct (inside_near b _ radius (regions_are_regular b b_edges b_valid b_meet) (or_introl shows) R)
    as (z & close & in_b).
  exists z. split; [| exact in_b]. destruct in_a, (near z close). split; [assumption | lia].
Qed.

(* Theorem. If the collision test of two valid regions returns true, there is a point inside both. *)
Theorem collide_is_sound (a b : region) : valid_region a -> valid_region b -> nowhere_above_one a ->
  nowhere_above_one b ->
  collide a b = true -> exists z, inside z a /\ inside z b.
Proof.
  intros a_region b_region a_simple b_simple meets. unfold collide in meets.
  apply orb_true_iff in meets. destruct meets as [[crossing_ | enters]%orb_true_iff | enters].
  - apply existsb_exists in crossing_. destruct crossing_ as (s & I & (t & J & crossing_)%existsb_exists).
    destruct (crossing_point_is s t crossing_) as (in_s & in_t & turn).
    destruct (boundary_piece_is a s (proj1 a_region) I) as (e & E & long_e & s_part & a_free).
    destruct (boundary_piece_is b t (proj1 b_region) J) as (f & F & long_f & t_part & b_free).
    destruct (a_free _ in_s) as [on_e no_vertex_a], (b_free _ in_t) as [on_f no_vertex_b].
    apply (crossing_edges_show a b e f (crossing_point s t)); trivial. intros parallel. apply turn.
    destruct (part_is_long s e s_part long_e) as (_ & c & _ & cx & cy).
    destruct (part_is_long t f t_part long_f) as (_ & d & _ & dx & dy).
    transitivity (c * d * cross (along e) (along f));
      [unfold cross; rewrite cx, cy, dx, dy; ring | rewrite parallel; ring].
  - now apply boundary_shows.
  - destruct (boundary_shows b a) as (z & in_b & in_a); trivial. now exists z.
Qed.
