(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Every sum of a point in a piece of P and a point in a piece of Q is on an edge of S or S goes round it, if the checker
   (checker.v) accepts. Each edge of S is beside all sums of two pieces (edges_beside_sums.v), so it meets the way from
   such a sum to that of two points inside the pieces at most where it begins: along the way the winding number is the
   same. So it is the same for any two pieces of P with a common corner, for all of P by the links
   (connected_pieces.v), and likewise for Q; and for the roots it is not 0. *)
From Coq Require Import QArith Lqa Qfield ZArith Lia Bool List Permutation SetoidList SetoidPermutation.
From Oplus Require Import turning_number specification checker direction angular_crossings winding_number signed_crossings
  neighbourhoods meeting_of_segments homogeneous_points specification_bridge fans pieces_cover edges_beside_sums
  connected_pieces what_is_checked.
Import ListNotations.

Open Scope Q_scope.

(** Points inside a piece *)

Lemma dot_of_combination (p q r : Q) (n a b c x : vector) :
  is_combination p q r a b c x -> dot n x == p * dot n a + q * dot n b + r * dot n c.
Proof. intros [x_is y_is]. unfold dot. rewrite x_is, y_is. ring. Qed.

(* No point inside is less far than all corners. *)
Lemma inside_is_as_far (n : vector) (k : Q) (t : piece) (x : vector) :
  is_convex t = true -> t = piece_of (corners_of t) -> (forall a, In a (corners_of t) -> k <= dot n (vector_of a)) ->
  inside_piece t x -> k <= dot n x.
Proof.
  intros convex lines far within_. destruct (inside_convex_is_combination t x convex lines within_)
    as (a & b & c & p & q & r & A & B & C & (p_sign & q_sign & r_sign & total_) & combination).
  rewrite (dot_of_combination _ _ _ n _ _ _ _ combination).
  assert (part : forall h c, 0 <= h -> In c (corners_of t) -> 0 <= h * (dot n (vector_of c) - k)).
  { intros h d sign D_. apply Qmult_le_0_compat; [exact sign |]. specialize (far d D_). lra. }
  pose proof (part p a p_sign A). pose proof (part q b q_sign B). pose proof (part r c r_sign C).
  assert (r_is : r == 1 - p - q) by lra. rewrite r_is in *.
  lra.
Qed.

Definition inner (t : piece) : hpoint := match inner_point t with Some x => x | None => Hpoint 0 0 1 end.

Lemma inner_is (t : piece) : is_convex t = true -> inner_point t = Some (inner t) /\
  exists a b c, In a (corners_of t) /\ In b (corners_of t) /\ In c (corners_of t) /\ (0 < left_turn a b c)%Z /\
    forall n, 3 * dot n (vector_of (inner t)) == dot n (vector_of a) + dot n (vector_of b) + dot n (vector_of c).
Proof.
  unfold is_convex, inner, inner_point. rewrite andb_true_iff. intros [fan _].
  destruct (corners_of t) as [| a [| b [| c rest]]]; try discriminate. split; [reflexivity |].
  cbn [has_a_fan fan_turns_left] in fan. apply andb_true_iff in fan. destruct fan as [turn_ _]. apply Z.ltb_lt in turn_.
  exists a, b, c. cbn [In]. repeat split; try tauto. intros n.
  rewrite <- dot_added, <- (dot_of_equal n _ _ (vector_of_plus a b)), <- dot_added,
    <- (dot_of_equal n _ _ (vector_of_plus (hplus a b) c)).
  set (s := hplus (hplus a b) c). unfold dot, vector_of. cbn [vx vy px py pw].
  rewrite !as_quotient, Pos2Z.inj_mul, inject_Z_mult.
  pose proof (positive_denominator (pw s)). change (inject_Z 3) with 3. field. lra.
Qed.

(* The inner point is farther in every direction than some corner. *)
Lemma inner_is_farther (n : vector) (k : Q) (t : piece) : is_convex t = true -> nonzero n ->
  (forall a, In a (corners_of t) -> k <= dot n (vector_of a)) -> k < dot n (vector_of (inner t)).
Proof.
  intros convex some far. destruct (inner_is t convex) as (_ & a & b & c & A & B & C & turn_ & middle).
  specialize (middle n). pose proof (far a A) as far_a. pose proof (far b B) as far_b. pose proof (far c C) as far_c.
  unfold left_turn in turn_. rewrite value_positive, value_of_line_through in turn_.
  apply Qnot_le_lt. intros near.
  assert (a_is : dot n (vector_of a) == k) by lra. assert (b_is : dot n (vector_of b) == k) by lra.
  assert (c_is : dot n (vector_of c) == k) by lra. clear - some turn_ a_is b_is c_is.
  assert (none : turn_of (vector_of a) (vector_of b) (vector_of c) == 0); [| rewrite none in turn_; lra].
  unfold dot, turn_of, nonzero in *.
  set (ax := vx (vector_of a)) in *. set (ay := vy (vector_of a)) in *. set (bx := vx (vector_of b)) in *.
  set (by_ := vy (vector_of b)) in *. set (cx := vx (vector_of c)) in *. set (cy := vy (vector_of c)) in *.
  set (area := (bx - ax) * (cy - ay) - (by_ - ay) * (cx - ax)).
  assert (u_is : vx n * (bx - ax) + vy n * (by_ - ay) == 0) by lra.
  assert (v_is : vx n * (cx - ax) + vy n * (cy - ay) == 0) by lra.
  assert (x_part : vx n * area == 0).
  { unfold area. by_equations. }
  assert (y_part : vy n * area == 0).
  { unfold area. by_equations. }
  apply Qmult_integral in x_part. apply Qmult_integral in y_part. tauto.
Qed.

(** Ways beside edges *)

(* From a point not before the edge to one beyond it: the edge is not met, but at the beginning. *)
Lemma way_beside_an_edge (n y z w : vector) (s : segment) :
  dot n (source s) <= dot n y -> dot n (target s) <= dot n y ->
  dot n (source s) < dot n z -> dot n (target s) < dot n z ->
  ~ lies_on y s -> lies_on w (Segment y z) -> ~ lies_on w s.
Proof.
  intros source_y target_y source_z target_z free (t & range & x_is & y_is) on. cbn [source target] in *.
  destruct (Qlt_le_dec 0 t) as [later | start].
  - destruct on as (r & range' & x_is' & y_is').
    assert (w_is : dot n w == (1 - t) * dot n y + t * dot n z) by (unfold dot; rewrite x_is, y_is; ring).
    assert (w_is' : dot n w == (1 - r) * dot n (source s) + r * dot n (target s))
      by (unfold dot; rewrite x_is', y_is'; ring).
    assert (split_ : exists m, dot n (source s) <= m /\ dot n (target s) <= m /\ m <= dot n y /\ m < dot n z).
    { destruct (Qlt_le_dec (dot n (source s)) (dot n (target s)));
        [exists (dot n (target s)) | exists (dot n (source s))]; repeat split; lra. }
    destruct split_ as (m & source_m & target_m & m_y & m_z).
    assert (0 < t * (dot n z - m)) by (apply Qmult_lt_0_compat; lra).
    assert (0 <= (1 - t) * (dot n y - m)) by (apply Qmult_le_0_compat; lra).
    assert (0 <= r * (m - dot n (target s))) by (apply Qmult_le_0_compat; lra).
    assert (0 <= (1 - r) * (m - dot n (source s))) by (apply Qmult_le_0_compat; lra). lra.
  - apply free. assert (t_is : t == 0) by lra. rewrite t_is in x_is, y_is.
    destruct s as [a b]. refine (lies_on_of_equal w y a b a b _ _ _ on); [split; lra | reflexivity ..].
Qed.

Section Beside.
  Variables (es : list hedge) (p q : list piece).

  Let segments : list segment := map segment_of_hedge es.

  Hypothesis closed : cycles segments.
  Hypothesis p_convex : forall t, In t p -> is_convex t = true /\ t = piece_of (corners_of t).
  Hypothesis q_convex : forall u, In u q -> is_convex u = true /\ u = piece_of (corners_of u).
  Hypothesis beside : forall e t u, In e es -> In t p -> In u q -> are_beside e t u.

  Definition inner_sum (t u : piece) : vector := added (vector_of (inner t)) (vector_of (inner u)).

  Lemma inner_sum_is_farther (n : vector) (k : Q) (t u : piece) :
    is_convex t = true -> is_convex u = true -> nonzero n ->
    (forall a b, In a (corners_of t) -> In b (corners_of u) -> k <= dot n (added (vector_of a) (vector_of b))) ->
    k < dot n (inner_sum t u).
  Proof.
    intros t_convex u_convex some far. unfold inner_sum. rewrite dot_added.
    assert (k - dot n (vector_of (inner t)) < dot n (vector_of (inner u))); [| lra].
    apply inner_is_farther; [exact u_convex | exact some |]. intros b B.
    assert (k - dot n (vector_of b) < dot n (vector_of (inner t))); [| lra].
    apply inner_is_farther; [exact t_convex | exact some |]. intros a A. specialize (far a b A B).
    rewrite dot_added in far. lra.
  Qed.

  (* From a point that is not before any edge to the inner sum the winding number is the same. *)
  Lemma winding_number_on_the_way (y : vector) (t u : piece) : In t p -> In u q -> off y segments ->
    (forall n e, nonzero n -> is_beside n e t u ->
      dot n (vector_of (fst e)) <= dot n y /\ dot n (vector_of (snd e)) <= dot n y) ->
    winding_number y segments = winding_number (inner_sum t u) segments.
  Proof.
    intros T U free not_before.
    apply (winding_number_along (Segment y (inner_sum t u)) segments); [exact closed |].
    intros w on s S. pose proof (free s S) as s_free. apply in_map_iff in S. destruct S as (e & <- & E).
    destruct (beside e t u E T U) as (n & some & sides_). destruct (not_before n e some sides_) as [first second].
    apply (way_beside_an_edge n y (inner_sum t u)); cbn [source target segment_of_hedge]; trivial.
    - apply inner_sum_is_farther; [now apply p_convex | now apply q_convex | exact some |]. intros a b A B.
      now apply (sides_ a b).
    - apply inner_sum_is_farther; [now apply p_convex | now apply q_convex | exact some |]. intros a b A B.
      now apply (sides_ a b).
  Qed.

  Lemma winding_number_of_sum (x a b : vector) (t u : piece) : In t p -> In u q -> inside_piece t a -> inside_piece u b ->
    equal_vectors x (added a b) -> off x segments ->
    winding_number x segments = winding_number (inner_sum t u) segments.
  Proof.
    intros T U A B x_is free. apply winding_number_on_the_way; trivial. intros n e some sides_.
    destruct (p_convex t T) as [t_convex t_lines]. destruct (q_convex u U) as [u_convex u_lines].
    assert (not_before : forall k, (forall c d, In c (corners_of t) -> In d (corners_of u) ->
      k <= dot n (added (vector_of c) (vector_of d))) -> k <= dot n x).
    { intros k far. rewrite (dot_of_equal n _ _ x_is), dot_added.
      assert (k - dot n a <= dot n b); [| lra]. apply (inside_is_as_far n _ u); trivial. intros d D_.
      assert (k - dot n (vector_of d) <= dot n a); [| lra]. apply (inside_is_as_far n _ t); trivial. intros c C.
      specialize (far c d C D_). rewrite dot_added in far. lra. }
    split; apply not_before; intros c d C D_; now apply (sides_ c d).
  Qed.

  (* What is strictly beyond all edges is on none. *)
  Lemma off_if_beyond (y : vector) (t u : piece) : In t p -> In u q ->
    (forall n e, nonzero n -> is_beside n e t u ->
      dot n (vector_of (fst e)) < dot n y /\ dot n (vector_of (snd e)) < dot n y) -> off y segments.
  Proof.
    intros T U beyond s S on. apply in_map_iff in S. destruct S as (e & <- & E).
    destruct (beside e t u E T U) as (n & some & sides_). destruct (beyond n e some sides_) as [first second].
    destruct on as (r & range & x_is & y_is). cbn [source target segment_of_hedge] in *.
    assert (y_dot : dot n y == (1 - r) * dot n (vector_of (fst e)) + r * dot n (vector_of (snd e)))
      by (unfold dot; rewrite x_is, y_is; ring).
    pose proof (mixed_is_less r _ _ _ range first second). lra.
  Qed.

  Lemma winding_number_by_a_corner_of_p (m : hpoint) (t u : piece) : In t p -> In u q -> In m (corners_of t) ->
    winding_number (added (vector_of m) (vector_of (inner u))) segments = winding_number (inner_sum t u) segments.
  Proof.
    intros T U M.
    assert (beyond : forall n e, nonzero n -> is_beside n e t u ->
      dot n (vector_of (fst e)) < dot n (added (vector_of m) (vector_of (inner u))) /\
      dot n (vector_of (snd e)) < dot n (added (vector_of m) (vector_of (inner u)))).
    { intros n e some sides_. rewrite !dot_added.
      assert (far : forall k, (forall b, In b (corners_of u) -> k <= dot n (added (vector_of m) (vector_of b))) ->
        k < dot n (vector_of m) + dot n (vector_of (inner u))).
      { intros k far. assert (k - dot n (vector_of m) < dot n (vector_of (inner u))); [| lra].
        apply inner_is_farther; [now apply q_convex | exact some |]. intros b B. specialize (far b B).
        rewrite dot_added in far. lra. }
      split; apply far; intros b B; now apply (sides_ m b). }
    apply winding_number_on_the_way; trivial; [now apply (off_if_beyond _ t u) |].
    intros n e some sides_. destruct (beyond n e some sides_). split; lra.
  Qed.

  Lemma winding_number_by_a_corner_of_q (m : hpoint) (t u : piece) : In t p -> In u q -> In m (corners_of u) ->
    winding_number (added (vector_of (inner t)) (vector_of m)) segments = winding_number (inner_sum t u) segments.
  Proof.
    intros T U M.
    assert (beyond : forall n e, nonzero n -> is_beside n e t u ->
      dot n (vector_of (fst e)) < dot n (added (vector_of (inner t)) (vector_of m)) /\
      dot n (vector_of (snd e)) < dot n (added (vector_of (inner t)) (vector_of m))).
    { intros n e some sides_. rewrite !dot_added.
      assert (far : forall k, (forall a, In a (corners_of t) -> k <= dot n (added (vector_of a) (vector_of m))) ->
        k < dot n (vector_of (inner t)) + dot n (vector_of m)).
      { intros k far. assert (k - dot n (vector_of m) < dot n (vector_of (inner t))); [| lra].
        apply inner_is_farther; [now apply p_convex | exact some |]. intros a A. specialize (far a A).
        rewrite dot_added in far. lra. }
      split; apply far; intros a A; now apply (sides_ a m). }
    apply winding_number_on_the_way; trivial; [now apply (off_if_beyond _ t u) |].
    intros n e some sides_. destruct (beyond n e some sides_). split; lra.
  Qed.

  Lemma common_corner (t u : piece) : have_a_common_corner t u = true -> exists m, In m (corners_of t) /\ In m (corners_of u).
  Proof.
    unfold have_a_common_corner. rewrite existsb_exists. intros (a & A & common). apply existsb_exists in common.
    destruct common as (b & B & equal_). apply same_is_equal in equal_. subst b. now exists a.
  Qed.

  (* Theorem. If all pieces are reached from roots, and the sums of two roots' inner points are inside, all sums are. *)
  Theorem sums_are_inside_by_roots (is_in_s : hpoint -> bool) (p_roots q_roots : list positive)
    (p_links q_links : list (positive * positive)) :
    (forall z, is_in_s z = true -> off (vector_of z) segments ->
      winding_number (vector_of z) segments <> 0%Z) ->
    are_all_reached (numbers_from 1 p) (all_reached (numbers_from 1 p) p_roots p_links) = true ->
    are_all_reached (numbers_from 1 q) (all_reached (numbers_from 1 q) q_roots q_links) = true ->
    are_roots_inside is_in_s (numbers_from 1 p) (numbers_from 1 q) p_roots q_roots = true ->
    forall (t u : piece) (a b x : vector), In t p -> In u q -> inside_piece t a -> inside_piece u b -> equal_vectors x (added a b) ->
    (exists s, In s segments /\ lies_on x s) \/ winding_number x segments <> 0%Z.
  Proof.
    intros is_right p_reached q_reached roots_inside t u a b x T U A B x_is.
    destruct (on_or_off x segments) as [on | free]; [now left | right].
    rewrite (winding_number_of_sum x a b t u T U A B x_is free).
    destruct (reached_from_a_root p 1 p_roots
      (fun t t' => forall u, In u q -> winding_number (inner_sum t u) segments = winding_number (inner_sum t' u) segments))
      with (those := p_links) (t := t) as (i & t_root & I & found_t & t_connected); trivial.
    { intros t1 t2 same_ u' U'. now rewrite same_. }
    { intros t1 t2 t3 one other u' U'. now rewrite one, other. }
    { intros t1 t2 T1 T2 common u' U'. apply common_corner in common. destruct common as (m & M1 & M2).
      now rewrite <- (winding_number_by_a_corner_of_p m t1), <- (winding_number_by_a_corner_of_p m t2). }
    destruct (reached_from_a_root q 1 q_roots
      (fun u u' => forall t, In t p -> winding_number (inner_sum t u) segments = winding_number (inner_sum t u') segments))
      with (those := q_links) (t := u) as (j & u_root & J & found_u & u_connected); trivial.
    { intros u1 u2 same_ t' T'. now rewrite same_. }
    { intros u1 u2 u3 one other t' T'. now rewrite one, other. }
    { intros u1 u2 U1 U2 common t' T'. apply common_corner in common. destruct common as (m & M1 & M2).
      now rewrite <- (winding_number_by_a_corner_of_q m t' u1), <- (winding_number_by_a_corner_of_q m t' u2). }
    pose proof found_t as T_root. apply numbers_are_from in T_root. destruct T_root as [_ T_root].
    pose proof found_u as U_root. apply numbers_are_from in U_root. destruct U_root as [_ U_root].
    rewrite (t_connected u U), (u_connected t_root T_root).
    unfold are_roots_inside in roots_inside. rewrite forallb_forall in roots_inside. specialize (roots_inside i I).
    rewrite forallb_forall in roots_inside. specialize (roots_inside j J). rewrite found_t, found_u in roots_inside.
    destruct (inner_is t_root) as [t_inner _]; [now apply p_convex |].
    destruct (inner_is u_root) as [u_inner _]; [now apply q_convex |].
    rewrite t_inner, u_inner in roots_inside.
    pose proof (vector_of_plus (inner t_root) (inner u_root)) as z_is. fold (inner_sum t_root u_root) in z_is.
    rewrite <- (winding_number_of_equal _ _ segments (proj1 z_is) (proj2 z_is)).
    apply is_right; [exact roots_inside |]. apply (off_if_beyond _ t_root u_root); trivial. intros n e some sides_.
    rewrite (dot_of_equal n _ _ z_is).
    split; (apply inner_sum_is_farther; [now apply p_convex | now apply q_convex | exact some |]);
      intros c d C D_; now apply (sides_ c d).
  Qed.
End Beside.

(** What the checker looks at *)

Lemma convex_has_corners (t : piece) : is_convex t = true -> corners_of t <> [].
Proof. unfold is_convex. intros convex none. now rewrite none in convex. Qed.

Lemma all_beside (D : positive) (es : list hedge) (p q : list piece) :
  (forall t, In t p -> is_convex t = true /\ t = piece_of (corners_of t)) ->
  (forall u, In u q -> is_convex u = true /\ u = piece_of (corners_of u)) ->
  (forall e, In e es ->
    forallb (fun t => forallb (are_trees_apart D (placed_hedge D e) t) (trees_of D q)) (trees_of D p) = true) ->
  forall e t u, In e es -> In t p -> In u q -> are_beside e t u.
Proof.
  intros p_convex q_convex apart e t u E T U.
  destruct (trees_have_all_pieces D p t T) as (t_tree & T_tree & t_there & t_boxed);
    [now apply convex_has_corners, p_convex |].
  destruct (trees_have_all_pieces D q u U) as (u_tree & U_tree & u_there & u_boxed);
    [now apply convex_has_corners, q_convex |].
  specialize (apart e E). rewrite forallb_forall in apart. specialize (apart t_tree T_tree).
  rewrite forallb_forall in apart. specialize (apart u_tree U_tree).
  apply (search_finds_directions D e t_tree u_tree); trivial.
  - intros a A. now apply p_convex, (trees_have_only_pieces D p t_tree).
  - intros a A. now apply q_convex, (trees_have_only_pieces D q u_tree).
Qed.

Lemma pieces_of_polygons_are_convex (es : list hedge) (inserted : list (list hpoint)) (polygons : list polygon) :
  are_a_region es inserted (map piece_of polygons) = true ->
  forall t, In t (map piece_of polygons) -> is_convex t = true /\ t = piece_of (corners_of t).
Proof.
  unfold are_a_region. rewrite !andb_true_iff, forallb_forall. intros [[convex _] _] t T. split; [now apply convex |].
  apply in_map_iff in T. now destruct T as (v & <- & _).
Qed.

(** Where the roots' sums are *)

Lemma found_in_a_tree (x : hpoint) (b : bounding_box) (t : tree) : is_in_tree x b t = true ->
  exists a, In a (pieces_in t) /\ inside_piece a (vector_of x).
Proof.
  induction t as [c a | c one IH_one other IH_other]; cbn [is_in_tree pieces_in]; rewrite !andb_true_iff; intros [_ found].
  - exists a. split; [now left |]. now apply left_of_all_is_inside.
  - apply orb_true_iff in found. destruct found as [found | found]; [apply IH_one in found | apply IH_other in found];
      destruct found as (a & A & x_in); exists a; (split; [apply in_or_app; tauto | exact x_in]).
Qed.

(* A point on no edge of S that the checker finds inside S, by its pieces or by its winding number. *)
Lemma found_inside (D : positive) (s : polygonal_region) (inserted : list (list hpoint)) (polygons : list polygon)
  (z : hpoint) :
  are_a_region (hedges_of_region s) inserted (map piece_of polygons) = true ->
  is_in_region D (hedges_of_region s) (trees_of D (map piece_of polygons)) z = true ->
  off (vector_of z) (boundary s) -> winding_number (vector_of z) (boundary s) <> 0%Z.
Proof.
  intros s_region found free. unfold is_in_region in found. apply orb_true_iff in found. destruct found as [found | found].
  - apply existsb_exists in found. destruct found as (tree_ & T & found). apply found_in_a_tree in found.
    destruct found as (a & A & z_in). apply (trees_have_only_pieces D (map piece_of polygons)) in A; [| exact T].
    assert (in_s : member (as_point (vector_of z)) s).
    { apply (pieces_are_in_region _ _ _ s_region (pieces_of_corners _) a); [exact A |]. now rewrite as_vector_of_point. }
    apply member_is in in_s. rewrite as_vector_of_point in in_s. destruct in_s as [(e & E & on) | round]; [| exact round].
    now destruct (free e E).
  - rewrite hwinding_is in found. now apply negb_true_iff, Z.eqb_neq in found.
Qed.

(* Theorem. If the checker accepts, the sums of what is inside a piece of P and what is inside a piece of Q are in S. *)
Theorem sums_of_pieces_are_members (is_open : bool) (p q : polygonal_region) (s : open_region) (c : certificate) :
  is_checked is_open p q s c ->
  forall (t u : piece) (a b : vector) (x : point), In t (p_pieces c) -> In u (q_pieces c) ->
  inside_piece t a -> inside_piece u b -> equal_vectors (as_vector x) (added a b) -> member x (open_chains s).
Proof.
  intros [p_region q_region s_region p_reached q_reached roots_inside all_apart _ _ _ _ _ _] t u a b x T U A B x_is.
  pose proof (pieces_of_polygons_are_convex _ _ _ p_region) as p_convex.
  pose proof (pieces_of_polygons_are_convex _ _ _ q_region) as q_convex.
  assert (s_apart : forall e, In e (hedges_of_region (open_chains s)) ->
    forallb (fun t => forallb (are_trees_apart (unit c) (placed_hedge (unit c) e) t) (trees_of (unit c) (q_pieces c)))
      (trees_of (unit c) (p_pieces c)) = true) by (intros e E; apply all_apart, in_or_app; now left).
  apply member_is. unfold s_pieces in *. rewrite <- (map_map fst piece_of) in s_region, roots_inside.
  apply (sums_are_inside_by_roots (hedges_of_region (open_chains s)) _ _ (boundary_cycles (open_chains s)) p_convex
    q_convex (all_beside (unit c) _ _ _ p_convex q_convex s_apart) _ _ _ _ _
    (fun z => found_inside (unit c) (open_chains s) (sum_inserted c) (map fst (sum_pieces c)) z s_region)
    p_reached q_reached roots_inside t u a b); assumption.
Qed.
