(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The naive collision test (naive_collision.v) misses nothing: where a point is inside two regions whose winding
   numbers are 0 and 1, it returns true. Of all edges that a ray from such a point meets take the first, as in
   first_hit.v, at a height at which no piece ends. Before it is met all points are inside both, and they are to its
   left: to the right of an edge nothing is inside its region. So the test returns true for its piece
   (collision_is_sound.v). *)
From Coq Require Import ZArith Lia Bool List.
From Oplus Require Import numbers regions_and_sums right_of_an_edge location pieces naive_collision met_pieces.
From Oplus Require Export collision_is_sound.
Import ListNotations.

Open Scope Q_scope.

(* Pieces of the boundary of a, cut once more where the boundary of b meets them. *)
Definition pieces_between_contacts (a b : region) : list segment :=
  flat_map (fun s => cut_where_met s (boundary_pieces b)) (boundary_pieces a).

Lemma first_hit_shows (a b : region) (z : vector) (s : segment) :
  valid_region a -> valid_region b -> nowhere_above_one a -> nowhere_above_one b -> inside z a -> inside z b ->
  (forall t, In t (pieces_between_contacts a b) -> ~ vy (source t) == vy z /\ ~ vy (target t) == vy z) ->
  In s (region_edges a) -> signed_crossing z s <> 0%Z ->
  (forall t, In t (region_edges a ++ region_edges b) -> signed_crossing z t <> 0%Z ->
    vx (point_at_height s (vy z)) <= vx (point_at_height t (vy z))) ->
  boundary_enters (boundary_pieces a) b (boundary_pieces b) = true.
Proof.
  intros a_region b_region a_simple b_simple [_ in_a] [_ in_b] no_end S met first_.
  destruct (crossed_ahead z s met) as [spanning ahead]. pose proof (point_at_height_lies_on s (vy z) spanning) as on_s.
  set (w := point_at_height s (vy z)) in *. pose proof (proj1 a_region) as a_edges.
  assert (before_ : forall r, incl (region_edges r) (region_edges a ++ region_edges b) ->
    eventually (fun d => winding_number (moved_along w (Vector (-1) 0) d) (region_edges r) =
      winding_number z (region_edges r))).
  { intros r part. refine (eventually_implied _ _ _ (eventually_below (vx w - vx z) ltac:(lra))). intros d range.
    rewrite (winding_number_of_equal _ (Vector (vx w - d) (vy z))) by (unfold moved_along, w;
      cbn [vx vy point_at_height]; ring).
    apply (same_before_the_first_hit z _ s); [reflexivity | cbn [vx]; lra | cbn [vx]; fold w; lra |].
    intros t T. now apply first_, part. }
  destruct (on_a_piece a s w a_edges S on_s) as (s' & I & part & on_s').
  destruct (part_is_long s' s part (region_edges_are_directions a a_edges s S)) as [long_s' _].
  destruct (proj2 (cut_returns s' (flat_map (intersection s') (boundary_pieces b)) long_s') w on_s')
    as (piece & J & _ & on_piece).
  destruct (no_end piece) as [no_source no_target]; [apply in_flat_map; now exists s' |].
  pose proof (inside_by_height w piece on_piece no_source no_target) as in_piece.
  apply existsb_exists. exists s'. split; [exact I |]. apply existsb_exists. exists piece. split; [exact J |].
  destruct (contact_piece_is a b s' piece a_edges (proj1 b_region) I J) as (_ & _ & e & E & (c & C & cx & cy) & free).
  destruct (free w in_piece) as (on_e & no_vertex & _).
  destruct (Q_dec (cross (along piece) (Vector (-1) 0)) 0) as [[right_ | left_] | flat].
  - exfalso. destruct (inside_beside_an_edge a e w a_region a_simple E on_e no_vertex) as (radius & R & near).
    destruct (some_small _ (eventually_and _ _ (before_ a (incl_appl _ (incl_refl _)))
      (small_steps_stay_within radius w (Vector (-1) 0) R))) as (d & some & same_number & close).
    assert (e_right : area e (moved_along w (Vector (-1) 0) d) < 0).
    { apply (Qmult_lt_l _ _ c C).
      setoid_replace (c * area e (moved_along w (Vector (-1) 0) d)) with (d * cross (along piece) (Vector (-1) 0));
        [nra |]. transitivity (c * (area e w + d * vy (along e))); [by_coordinates |].
      rewrite (on_the_line w e on_e). unfold cross. rewrite cy. cbn [vx vy]. ring. }
    apply near in e_right; [lia | exact close].
  - destruct (some_small _ (eventually_and _ _ (before_ b (incl_appr _ (incl_refl _)))
      (test_of_a_piece a b s' piece w _ a_region b_region b_simple I J in_piece left_))) as (d & _ & same_number & ->).
    now rewrite same_number.
  - exfalso. apply no_source. destruct on_piece as (k & _ & _ & Y). change (vy w) with (vy z) in Y. rewrite Y.
    unfold cross, along, minus in flat; cbn [vx vy] in flat.
    assert (vy (target piece) == vy (source piece)) as -> by lra. ring.
Qed.

(* Near a point inside both is another at whose height no segment of a list ends. *)
Lemma inside_at_another_height (a b : region) (z : vector) (segments : list segment) : inside z a -> inside z b ->
  exists y, inside y a /\ inside y b /\ forall s, In s segments -> ~ vy (source s) == vy y /\ ~ vy (target s) == vy y.
Proof.
  intros [off_a in_a] [off_b in_b].
  destruct (winding_number_near z _ (region_cycles a) off_a) as (r1 & R1 & near_a).
  destruct (winding_number_near z _ (region_cycles b) off_b) as (r2 & R2 & near_b).
  destruct (some_small _ (eventually_and _ _ (leaves_all_heights (segments ++ map reversed segments) z)
    (eventually_and _ _ (small_steps_stay_within r1 z (Vector 0 1) R1) (small_steps_stay_within r2 z (Vector 0 1) R2))))
    as (height & _ & leaves & close_a & close_b).
  destruct (near_a _ close_a), (near_b _ close_b). exists (moved_along z (Vector 0 1) height).
  split; [split; [assumption | lia] |]. split; [split; [assumption | lia] |]. intros s S.
  split; intros equal; [apply (leaves s) | apply (leaves (reversed s))]; try (now symmetry); apply in_app_iff;
    [now left | right; now apply in_map].
Qed.

(* Theorem. If a point is inside two valid regions whose winding numbers are at most 1, the collision test returns
   true. *)
Theorem collide_is_complete (a b : region) (z : vector) :
  valid_region a -> valid_region b -> nowhere_above_one a -> nowhere_above_one b ->
  inside z a -> inside z b -> collide a b = true.
Proof.
  intros a_region b_region a_simple b_simple in_a_ in_b_.
  destruct (inside_at_another_height a b z (pieces_between_contacts a b ++ pieces_between_contacts b a) in_a_ in_b_)
    as (y & in_a & in_b & heights). clear in_a_ in_b_ z.
  destruct (first_crossed y (region_edges a ++ region_edges b)) as [none | (s & I & met & first_of_all)].
  { destruct in_a as [_ positive_]. assert (winding_number y (region_edges a) = 0%Z); [| lia].
    apply sum_of_zeros. intros s I. apply none, in_app_iff. now left. }
  unfold collide. rewrite !orb_true_iff. apply in_app_iff in I. destruct I as [I | I]; [left |]; right.
  - apply (first_hit_shows a b y s); trivial. intros t T. apply heights, in_app_iff. now left.
  - apply (first_hit_shows b a y s); trivial; intros t T; [apply heights, in_app_iff; now right |].
    apply first_of_all. rewrite in_app_iff in *. tauto.
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
