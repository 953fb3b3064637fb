(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* A region whose pieces are apart (pieces_apart.v) has the winding numbers 0 and 1, and near each of its points are
   inner points of it. The winding number is the sum of those of the fan triangles of all pieces (pieces_cover.v). A
   point on none of some lines is in at most one triangle of a fan, since beyond a triangle all later ones are on the
   other side; and it is in at most one piece. *)
From Coq Require Import QArith Lqa ZArith Lia Bool List.
From Oplus Require Import regions specification checker direction rotation angular_crossings winding_number
  small_numbers signed_crossings neighbourhoods edges_of_valid_regions homogeneous_points specification_bridge fans
  winding_numbers_of_triangles pieces_cover edges_beside_sums sums_are_inside inner_sums certified_open_sums
  layout_checker pieces_apart.
Import ListNotations.

Open Scope Q_scope.

Lemma off_lines_near (lines : list line) (x : vector) (radius : Q) : (forall l, In l lines -> nonzero (normal_of l)) ->
  0 < radius -> exists y, within radius x y /\ is_off_lines lines y.
Proof.
  intros proper R. destruct (some_direction_is_across lines proper) as (v & across).
  destruct (some_small _ (eventually_and _ _ (small_steps_stay_within radius x v R)
    (steps_leave_lines lines x v across))) as (e & _ & close & free). now exists (moved_along x v e).
Qed.

(** One piece *)

Definition number_in_triangle (y : vector) (k : hpoint * hpoint * hpoint) : Z := winding_number y (triangle_of k).

(* o is the first corner; the point is beyond the side to b, on the side of it on which all corners are. *)
Lemma fan_goes_round_once (o b : hpoint) (y : vector) : 0 < turn_of (vector_of o) (vector_of b) y ->
  forall rest c, fan_turns_left o (c :: rest) = true ->
  (forall d, In d (c :: rest) -> 0 <= turn_of (vector_of o) (vector_of b) (vector_of d)) ->
  (forall d, In d (c :: rest) -> ~ turn_of (vector_of o) (vector_of d) y == 0) ->
  (sum (map (number_in_triangle y) (fan_triangles_of o (c :: rest))) <= 1)%Z /\
  (turn_of (vector_of o) (vector_of c) y < 0 ->
    sum (map (number_in_triangle y) (fan_triangles_of o (c :: rest))) = 0%Z).
Proof.
  intros beyond. induction rest as [| d rest IH]; intros c fan left_ free; [cbn; lia |].
  cbn [fan_turns_left] in fan. apply andb_true_iff in fan. destruct fan as [turn_%Z.ltb_lt fan].
  apply left_turn_is_positive in turn_.
  destruct (IH d fan) as [once none]; [intros e E; apply left_; now right | intros e E; apply free; now right |].
  change (fan_triangles_of o (c :: d :: rest)) with ((o, c, d) :: fan_triangles_of o (d :: rest)). cbn [map].
  rewrite sum_of_cons. destruct (winding_number_of_a_triangle y _ _ _ turn_) as (range & within_ & _).
  change (winding_number y _) with (number_in_triangle y (o, c, d)) in range, within_.
  set (number := number_in_triangle y (o, c, d)) in *.
  assert (turned : turn_of (vector_of o) (vector_of d) y == - turn_of (vector_of d) (vector_of o) y)
    by (unfold turn_of; ring).
  pose proof (free d (or_intror (or_introl eq_refl))) as not_on. split.
  - destruct (Z.eq_dec number 0) as [-> | some]; [exact once |]. destruct (within_ some) as (_ & _ & last_).
    rewrite none by lra. lia.
  - intros right_. destruct (Z.eq_dec number 0) as [-> | some]; [apply none | destruct (within_ some); lra].
    pose proof (left_ c (or_introl eq_refl)) as left_c. pose proof (left_ d (or_intror (or_introl eq_refl))) as left_d.
    assert (identity : turn_of (vector_of o) (vector_of b) (vector_of c) * turn_of (vector_of o) (vector_of d) y ==
      turn_of (vector_of o) (vector_of b) (vector_of d) * turn_of (vector_of o) (vector_of c) y -
      turn_of (vector_of o) (vector_of b) y * turn_of (vector_of o) (vector_of c) (vector_of d))
      by (unfold turn_of; ring).
    apply Qnot_le_lt. intros not_right. pose proof (Qmult_le_0_compat _ _ left_c not_right).
    assert (0 <= - turn_of (vector_of o) (vector_of c) y) as left_y by lra.
    pose proof (Qmult_le_0_compat _ _ left_d left_y). pose proof (Qmult_lt_0_compat _ _ beyond turn_). lra.
Qed.

(* Lines along the sides of a piece, and through its first corner and the others. *)
Definition lines_of (t : piece) : list line :=
  side_lines t ++
  flat_map (fun k => match k with (o, b, c) => [line_through o b; line_through o c] end) (fan_triangles (corners_of t)).

Lemma lines_are_proper (t : piece) : is_piece t -> forall l, In l (lines_of t) -> nonzero (normal_of l).
Proof.
  intros [convex lines] l [L | L]%in_app_iff; [now apply (side_line_has_a_normal t) |].
  apply in_flat_map in L. destruct L as ([[o b] c] & K & L). unfold is_convex in convex.
  apply andb_true_iff in convex. apply (fan_triangles_turn_left _ _ _ _ (proj1 convex)), left_turn_is_positive,
    left_turn_is_proper in K. destruct K as (o_b & _ & c_o).
  destruct L as [<- | [<- | []]]; apply line_has_a_normal; [exact o_b | intros equal; apply c_o; now symmetry].
Qed.

Definition number_of_piece (y : vector) (t : piece) : Z :=
  sum (map (number_in_triangle y) (fan_triangles (corners_of t))).

Lemma off_a_line (o b : hpoint) (y : vector) : ~ value_at (line_through o b) y == 0 ->
  ~ turn_of (vector_of o) (vector_of b) y == 0.
Proof. intros off_ none. apply off_. rewrite value_of_line_through, none. ring. Qed.

Lemma piece_goes_round_once (t : piece) (y : vector) : is_piece t ->
  is_off_lines (lines_of t) y ->
  (0 <= number_of_piece y t <= 1)%Z /\ (number_of_piece y t <> 0%Z -> strictly_in t y).
Proof.
  intros [convex lines] free. pose proof convex as fan. unfold is_convex in fan. apply andb_true_iff in fan.
  destruct fan as [fan _]. unfold number_of_piece.
  assert (inside_ : sum (map (number_in_triangle y) (fan_triangles (corners_of t))) <> 0%Z -> strictly_in t y).
  { intros (([o b] & c) & K & some)%some_term_is_not_zero l L.
    pose proof (fan_triangles_turn_left _ _ _ _ fan K) as turn_.
    destruct (fan_triangles_have_corners _ _ _ _ K) as (O & B & C).
    pose proof (triangle_is_inside t o b c y convex O B C turn_
      (proj1 (proj2 (winding_number_of_a_triangle y _ _ _ turn_)) some) l L) as left_.
    apply Qle_lteq in left_. destruct left_ as [| on]; [assumption | destruct (free l)]; [| now symmetry].
    apply in_app_iff. now left. }
  split; [| exact inside_]. split.
  - apply terms_are_less. intros [[o b] c] K.
    now apply winding_number_of_a_triangle, (fan_triangles_turn_left (corners_of t)).
  - destruct (Z.eq_dec (sum (map (number_in_triangle y) (fan_triangles (corners_of t)))) 0) as [-> | some]; [lia |].
    specialize (inside_ some). destruct (corners_of t) as [| o [| b [| c rest]]] eqn:these; try discriminate.
    assert (first_side : In (line_through o b) (side_lines t)) by (rewrite lines; now left).
    assert (left_of : forall z, 0 <= value_at (line_through o b) z -> 0 <= turn_of (vector_of o) (vector_of b) z)
      by (intros z; apply turn_of_is_value_at).
    apply (fan_goes_round_once o b y).
    + pose proof (left_of y (Qlt_le_weak _ _ (inside_ _ first_side))) as left_. apply Qle_lteq in left_.
      destruct left_ as [| on]; [assumption | exfalso]. apply (off_a_line o b y); [| now symmetry].
      apply free, in_app_iff. now left.
    + exact fan.
    + intros d D. apply left_of. apply (corners_are_inside t d convex); [rewrite these; now right | exact first_side].
    + assert (each : forall l e d, In d (e :: l) -> l <> [] -> exists k, In k (fan_triangles_of o (e :: l)) /\
        match k with (_, u, v) => fst (fst k) = o /\ (d = u \/ d = v) end).
      { induction l as [| f l IH]; intros e d D not_alone; [easy |]. destruct D as [-> | [-> | D]].
        - exists (o, d, f). split; [now left |]. tauto.
        - exists (o, e, d). split; [now left |]. tauto.
        - destruct l as [| g l]; [easy |]. destruct (IH f d (or_intror D) ltac:(easy)) as (k & K & is_).
          exists k. split; [now right | exact is_]. }
      intros d D. destruct (each (c :: rest) b d D ltac:(easy)) as ([[o' u] v] & K & first_ & is_). cbn in first_.
      subst o'. apply off_a_line, free, in_app_iff. right. apply in_flat_map. exists (o, u, v). rewrite these.
      split; [exact K |]. destruct is_ as [-> | ->]; cbn; tauto.
Qed.

(** All pieces *)

Lemma at_most_one_term {A : Type} (f : A -> Z) (l : list A) : (forall a, In a l -> (0 <= f a <= 1)%Z) ->
  ForallOrdPairs (fun a b => f a = 0%Z \/ f b = 0%Z) l -> (sum (map f l) <= 1)%Z.
Proof.
  intros range pairs. induction pairs as [| a l first_ pairs IH]; [cbn; lia |]. cbn [map]. rewrite sum_of_cons.
  assert (rest : (sum (map f l) <= 1)%Z) by (apply IH; intros b B; apply range; now right).
  pose proof (range a (or_introl eq_refl)). destruct (Z.eq_dec (f a) 0) as [-> | some]; [exact rest |].
  assert (none : sum (map f l) = 0%Z); [| lia]. rewrite Forall_forall in first_. clear - first_ some.
  induction l as [| b l IH]; [reflexivity |]. cbn [map].
  rewrite sum_of_cons, IH by (intros c C; apply first_; now right).
  destruct (first_ b (or_introl eq_refl)); [contradiction | lia].
Qed.

Section Region.
  Variables (r : polygonal_region) (inserted : list (list hpoint)) (polygons : list polygon).
  Let pieces := map piece_of polygons.
  Hypothesis accepted : are_a_region (hedges_of_region r) inserted pieces = true.

  Lemma all_pieces (t : piece) : In t pieces -> is_piece t.
  Proof. exact (pieces_of_polygons_are_convex _ _ _ accepted t). Qed.

  (* Theorem. *)
  Theorem pieces_apart_go_round_once (x : vector) : ForallOrdPairs are_apart_by_a_line pieces -> off x (boundary r) ->
    winding_number x (boundary r) = 0%Z \/ winding_number x (boundary r) = 1%Z.
  Proof.
    intros apart free. destruct (winding_number_near x _ (boundary_cycles r) free) as (radius & R & near).
    destruct (off_lines_near (flat_map lines_of pieces) x radius) as (y & close & off_lines); [| exact R |].
    { intros l (t & T & L)%in_flat_map. now apply (lines_are_proper t (all_pieces t T)). }
    destruct (near y close) as [_ <-]. rewrite (winding_number_of_pieces _ _ _ accepted).
    change (sum (map _ pieces)) with (sum (map (number_of_piece y) pieces)).
    assert (each : forall t, In t pieces -> (0 <= number_of_piece y t <= 1)%Z /\
      (number_of_piece y t <> 0%Z -> strictly_in t y)).
    { intros t T. apply piece_goes_round_once; [now apply all_pieces |]. intros l L. apply off_lines, in_flat_map.
      now exists t. }
    assert (0 <= sum (map (number_of_piece y) pieces))%Z by (apply terms_are_less; intros t T; now apply each).
    assert (sum (map (number_of_piece y) pieces) <= 1)%Z; [| lia].
    apply at_most_one_term; [intros t T; now apply each |]. refine (weaker_pairs _ _ _ _ apart). intros t u T U apart_.
    destruct (Z.eq_dec (number_of_piece y t) 0) as [| some_t]; [now left |].
    destruct (Z.eq_dec (number_of_piece y u) 0) as [| some_u]; [now right | exfalso].
    apply (strictly_in_alone t u y (all_pieces t T) (all_pieces u U) apart_ (proj2 (each t T) some_t)).
    intros l L. apply Qlt_le_weak. now apply (proj2 (each u U) some_u).
  Qed.

  (* Theorem. A small step from a point strictly in a piece, along no side, leads off all edges. *)
  Theorem inner_points_are_near (x : point) (radius : Q) : member x r -> 0 < radius ->
    exists z, within radius (as_vector x) (as_vector z) /\ is_inner_point z r.
  Proof.
    intros in_r R. destruct (region_is_in_pieces _ _ _ accepted x in_r) as (t & T & in_t).
    destruct (strictly_in_near t (as_vector x) ((1 # 2) * radius) (all_pieces t T) in_t) as (y & close & strict);
      [lra |].
    destruct (some_direction_is_across (flat_map side_lines pieces)) as (v & across).
    { intros l (u & U & L)%in_flat_map. destruct (all_pieces u U). now apply (side_line_has_a_normal u). }
    destruct (some_small _ (eventually_and _ _ (small_steps_stay_within ((1 # 2) * radius) y v ltac:(lra))
      (eventually_and _ _ (stays_strictly_in t y v strict) (steps_leave_lines _ y v across))))
      as (e & _ & close_z & in_z & off_lines).
    exists (as_point (moved_along y v e)). rewrite inner_point_by_boundary, as_vector_of_point.
    split; [unfold within in *; lra |].
    assert (free : off (moved_along y v e) (boundary r)).
    { apply (off_boundary_if_off_lines r inserted polygons (flat_map side_lines pieces));
        [exact accepted | | exact off_lines].
      intros u l U L. apply in_flat_map. now exists u. }
    split; [| exact free].
    assert (there : member (as_point (moved_along y v e)) r).
    { apply (pieces_are_in_region _ _ _ accepted (fun u U => proj2 (all_pieces u U)) t _ T). rewrite as_vector_of_point.
      now apply strictly_in_is_inside. }
    apply member_is in there. rewrite as_vector_of_point in there.
    destruct there as [(s & S & on) | round]; [destruct (free s S on) | exact round].
  Qed.
End Region.
