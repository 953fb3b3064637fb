(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* If the checker accepts pieces as a region (are_a_region of checker.v), they cover it: its points are those of
   the pieces. The winding number at every point, also on edges, is the sum of those of the fan triangles (fans.v) of
   the pieces (balanced_edges.v), which are 0 or 1 (winding_numbers_of_triangles.v); where a point is not on the region's
   edges, winding numbers are constant around it (neighbourhoods.v). *)
From Coq Require Import QArith Qminmax Lqa ZArith Lia Bool List.
From Oplus Require Import convolution specification checker signed_crossings homogeneous_points
  specification_bridge neighbourhoods fans winding_numbers_of_triangles balanced_edges.
Import ListNotations.

Open Scope Z_scope.

Definition triangle_of (t : hpoint * hpoint * hpoint) : list segment :=
  match t with (a, b, c) => sides_of_triangle (vector_of a) (vector_of b) (vector_of c) end.

Lemma sum_of_cons (z : Z) (l : list Z) : sum (z :: l) = z + sum l.
Proof. reflexivity. Qed.

(* What the sides of a polygon add to a winding number is what the triangles of its fan add. *)
Lemma fan_adds_up (v : polygon) (x : vector) : has_a_fan v = true ->
  winding_number x (map segment_of_hedge (sides v)) = sum (map (fun t => winding_number x (triangle_of t)) (fan_triangles v)).
Proof.
  intros fan. destruct v as [| first [| b [| c rest]]]; try easy. clear fan.
  set (crossing_of := fun a b => signed_crossing x (Segment (vector_of a) (vector_of b))).
  assert (cancels : forall a b, crossing_of a b + crossing_of b a = 0)
    by (intros u v; unfold crossing_of; rewrite (crossing_of_the_reverse x (vector_of u) (vector_of v)); lia).
  assert (one_more : forall e l, winding_number x (map segment_of_hedge (e :: l)) =
    crossing_of (fst e) (snd e) + winding_number x (map segment_of_hedge l)) by reflexivity.
  assert (of_triangle : forall a b d, winding_number x (triangle_of (a, b, d)) =
    crossing_of a b + (crossing_of b d + (crossing_of d a + 0))) by reflexivity.
  assert (of_rest : forall l e,
    winding_number x (map segment_of_hedge (combine (e :: l) (l ++ [first]))) + crossing_of first e =
    sum (map (fun t => winding_number x (triangle_of t)) (fan_triangles_of first (e :: l)))).
  { induction l as [| d l IH]; intros e.
    - specialize (cancels e first). cbn.
      change (signed_crossing x (segment_of_hedge (e, first))) with (crossing_of e first). lia.
    - change (fan_triangles_of first (e :: d :: l)) with ((first, e, d) :: fan_triangles_of first (d :: l)).
      change (combine (e :: d :: l) ((d :: l) ++ [first])) with ((e, d) :: combine (d :: l) (l ++ [first])).
      specialize (IH d). specialize (cancels first d).
      rewrite one_more. cbn [map fst snd]. rewrite sum_of_cons, of_triangle, <- IH. lia. }
  cbn [fan_triangles]. rewrite <- of_rest.
  change (sides (first :: b :: c :: rest)) with ((first, b) :: combine (b :: c :: rest) ((c :: rest) ++ [first])).
  rewrite one_more. cbn [fst snd]. lia.
Qed.

Lemma some_term_is_not_zero {A} (f : A -> Z) (l : list A) : sum (map f l) <> 0 -> exists a, In a l /\ f a <> 0.
Proof.
  induction l as [| a l IH]; [now cbn |]. unfold sum in *. cbn [map fold_right]. intros not_zero.
  destruct (Z.eq_dec (f a) 0) as [zero_ | other_].
  - destruct IH as (b & b_in & b_is); [lia |]. exists b. cbn [In]. tauto.
  - exists a. cbn [In]. tauto.
Qed.

Lemma terms_are_less {A} (f : A -> Z) (l : list A) :
  (forall a, In a l -> 0 <= f a) -> 0 <= sum (map f l) /\ forall a, In a l -> f a <= sum (map f l).
Proof.
  unfold sum. induction l as [| a l IH]; intros signs; cbn [map fold_right]; [split; [lia | intros a []] |].
  destruct IH as [whole parts]; [intros b b_in; apply signs; now right |].
  pose proof (signs a (or_introl eq_refl)). split; [lia |].
  intros b [<- | b_in]; [lia |]. specialize (parts b b_in). lia.
Qed.

(* A point of a triangle, moved towards its centre, is strictly inside. *)
Lemma strictly_inside_near (a b c x : vector) (radius : Q) :
  (0 < radius)%Q -> (0 < turn_of a b c)%Q -> in_triangle a b c x ->
  exists y, within radius x y /\ (0 < turn_of a b y)%Q /\ (0 < turn_of b c y)%Q /\ (0 < turn_of c a y)%Q.
Proof.
  intros some left_ (of_c & of_a & of_b).
  set (u := Vector (vx a + vx b + vx c - 3 * vx x) (vy a + vy b + vy c - 3 * vy x)).
  destruct (small_steps_stay_within radius x u some) as (limit & limit_some & near).
  set (e := Qmin (limit / 2) (1 # 6)).
  assert (half_ : (limit / 2 * 2 == limit)%Q) by field.
  assert (0 < e /\ e < limit /\ 3 * e < 1)%Q as (e_some & e_small & e_less).
  { pose proof (Q.le_min_l (limit / 2) (1 # 6)) as below_half.
    pose proof (Q.le_min_r (limit / 2) (1 # 6)) as below_sixth.
    fold e in below_half, below_sixth.
    assert (0 < e)%Q by (apply Q.min_glb_lt; lra). lra. }
  exists (moved_along x u e). split; [now apply near |].
  assert (step : forall s t, (turn_of s t (moved_along x u e) ==
    (1 - 3 * e) * turn_of s t x + e * (turn_of s t a + turn_of s t b + turn_of s t c))%Q)
    by (intros; unfold turn_of, moved_along, u; cbn [vx vy]; ring).
  assert (positive : forall k, (0 <= k -> 0 < (1 - 3 * e) * k + e * turn_of a b c)%Q).
  { intros k sign. assert (0 <= (1 - 3 * e) * k)%Q by (apply Qmult_le_0_compat; lra).
    assert (0 < e * turn_of a b c)%Q by now apply Qmult_lt_0_compat. lra. }
  assert (ends : (turn_of a b a == 0 /\ turn_of a b b == 0 /\ turn_of b c a == turn_of a b c /\ turn_of b c b == 0 /\
    turn_of b c c == 0 /\ turn_of c a a == 0 /\ turn_of c a b == turn_of a b c /\ turn_of c a c == 0)%Q)
    by (unfold turn_of; repeat split; ring).
  destruct ends as (e1 & e2 & e3 & e4 & e5 & e6 & e7 & e8).
  rewrite !step, e1, e2, e3, e4, e5, e6, e7, e8, !Qplus_0_l, !Qplus_0_r. repeat split; now apply positive.
Qed.

Lemma pieces_of_corners (polygons : list polygon) (t : piece) :
  In t (map piece_of polygons) -> t = piece_of (corners_of t).
Proof. intros t_in. apply in_map_iff in t_in as (v & <- & _). reflexivity. Qed.

Section Accepted.
  Variables (r : polygonal_region) (inserted : list (list hpoint)) (pieces : list piece).
  Hypothesis accepted : are_a_region (hedges_of_region r) inserted pieces = true.
  Hypothesis of_corners : forall t, In t pieces -> t = piece_of (corners_of t).

  Lemma has_its_fan (t : piece) : In t pieces -> has_a_fan (corners_of t) = true.
  Proof.
    intros t_in. pose proof (pieces_are_convex _ _ _ accepted t t_in) as convex. unfold is_convex in convex.
    rewrite andb_true_iff in convex. apply convex.
  Qed.

  Theorem winding_number_of_pieces (x : vector) :
    winding_number x (boundary r) =
    sum (map (fun t => sum (map (fun k => winding_number x (triangle_of k)) (fan_triangles (corners_of t)))) pieces).
  Proof.
    unfold boundary, winding_number at 1. rewrite map_map, (sum_over_pieces _ _ _ accepted).
    - f_equal. apply map_ext_in. intros t t_in. rewrite <- fan_adds_up by now apply has_its_fan.
      unfold winding_number. now rewrite map_map.
    - intros a b. apply crossing_of_the_reverse.
    - intros a m b between_. apply crossing_of_parts. now apply is_between_lies_on.
  Qed.

  Lemma triangle_is_not_negative (t : piece) (k : hpoint * hpoint * hpoint) (x : vector) :
    In t pieces -> In k (fan_triangles (corners_of t)) -> 0 <= winding_number x (triangle_of k).
  Proof.
    intros t_in k_in. destruct k as [[a b] c].
    apply winding_number_of_a_triangle, (fan_triangles_turn_left (corners_of t)); [now apply has_its_fan | exact k_in].
  Qed.

  (* Theorem. Every point of the region is in a piece. *)
  Theorem region_is_in_pieces (x : point) : member x r -> exists t, In t pieces /\ inside_piece t (as_vector x).
  Proof.
    rewrite member_is. intros [(s & s_in & on) | round].
    - unfold boundary in s_in. apply in_map_iff in s_in as (e & <- & e_in).
      destruct (edges_are_on_sides _ _ _ accepted e (as_vector x) e_in on) as (t & side & t_in & side_in & on_side).
      exists t. split; [exact t_in |]. pose proof (pieces_are_convex _ _ _ accepted t t_in) as convex.
      destruct side as [a b]. destruct on_side as (h & range & x_x & x_y). cbn [segment_of_hedge source target fst snd] in *.
      assert (In a (corners_of t) /\ In b (corners_of t)) as [a_in b_in].
      { unfold sides in side_in. destruct (corners_of t) as [| first rest]; [easy |].
        split; [now apply in_combine_l in side_in |].
        apply in_combine_r, in_app_or in side_in. cbn [In] in *. tauto. }
      apply (combination_is_inside (1 - h) h 0 t (vector_of a) (vector_of b) (vector_of b));
        [unfold are_weights; lra | | now apply corners_are_inside ..].
      unfold is_combination. rewrite x_x, x_y. split; ring.
    - rewrite winding_number_of_pieces in round. apply some_term_is_not_zero in round as (t & t_in & round).
      apply some_term_is_not_zero in round as ([[a b] c] & k_in & round). exists t. split; [exact t_in |].
      pose proof (fan_triangles_turn_left _ _ _ _ (has_its_fan t t_in) k_in) as left_.
      destruct (fan_triangles_have_corners _ _ _ _ k_in) as (a_in & b_in & c_in).
      apply (triangle_is_inside t a b c); trivial; [now apply (pieces_are_convex _ _ _ accepted) |].
      now apply winding_number_of_a_triangle.
  Qed.

  (* Theorem. Every point of a piece is a point of the region. *)
  Theorem pieces_are_in_region (t : piece) (x : point) : In t pieces -> inside_piece t (as_vector x) -> member x r.
  Proof.
    intros t_in x_in. apply member_is. destruct (on_or_off (as_vector x) (boundary r)) as [on | free];
      [now left | right].
    pose proof (has_its_fan t t_in) as fan. rewrite (of_corners t t_in) in x_in.
    destruct (inside_is_in_a_fan_triangle _ _ fan x_in) as (a & b & c & k_in & within_).
    pose proof (fan_triangles_turn_left _ _ _ _ fan k_in) as left_.
    destruct (winding_number_near (as_vector x) (boundary r) (boundary_cycles r) free) as (radius & some & near).
    destruct (strictly_inside_near _ _ _ _ radius some left_ within_) as (y & close & y_c & y_a & y_b).
    destruct (near y close) as [_ <-]. rewrite winding_number_of_pieces.
    assert (one : winding_number y (triangle_of (a, b, c)) = 1) by now apply winding_number_of_a_triangle.
    set (of_piece := fun t => sum (map (fun k => winding_number y (triangle_of k)) (fan_triangles (corners_of t)))).
    assert (winding_number y (triangle_of (a, b, c)) <= of_piece t).
    { apply (proj2 (terms_are_less (fun k => winding_number y (triangle_of k)) (fan_triangles (corners_of t))
        (fun k => triangle_is_not_negative t k y t_in)) (a, b, c)). exact k_in. }
    assert (of_piece t <= sum (map of_piece pieces)).
    { apply terms_are_less; [| exact t_in]. intros u u_in. apply terms_are_less. intros k k_in'.
      now apply (triangle_is_not_negative u). }
    lia.
  Qed.

End Accepted.
