(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The theorem for open sums: what the checker (checker.v) accepts is all sums of points inside P and points inside Q.
   These are the sums of points strictly inside pieces: moved a little in opposite directions, along no side of a piece,
   two points inside P and Q are strictly inside pieces, and points strictly inside pieces are on no edge of P and Q. No
   edge of S, dangling edge or isolated point has such a sum on it, since all are beside T + U (edges_beside_sums.v). And
   what is inside S is such a sum or left out: by cells and seams in the pieces of S (seams_are_covered.v), by seams on
   the diagonals between them. *)
From Coq Require Import QArith Lqa ZArith Lia Bool List FMapPositive.
From Oplus Require Import specification checker direction angular_crossings winding_number small_numbers neighbourhoods
  homogeneous_points specification_bridge fans sums_of_pieces clipped_polygons balanced_edges pieces_cover
  connected_pieces edges_beside_sums sums_are_inside inner_sums seams_are_covered off_the_sides_of_a_piece
  what_is_checked certified_sums.
Import ListNotations.

Open Scope Q_scope.

(** Steps along none of some lines *)

Lemma some_direction_is_across (lines : list line) : (forall l, In l lines -> nonzero (normal_of l)) ->
  exists v, forall l, In l lines -> ~ dot (normal_of l) v == 0.
Proof.
  intros some.
  assert (bounded : exists n, (0 <= n)%Z /\ forall l, In l lines -> (Z.abs (la l) <= n)%Z).
  { clear some. induction lines as [| l rest (n & sign & bound)]; [exists 0%Z; now split |].
    exists (Z.max n (Z.abs (la l))). split; [lia |]. intros m [<- | M]; [lia | specialize (bound m M); lia]. }
  destruct bounded as (n & sign & bound). exists (Vector 1 (inject_Z (n + 1))). intros l L.
  specialize (some l L). specialize (bound l L). unfold nonzero, dot, normal_of in *. cbn [vx vy] in *.
  rewrite Qmult_1_r, <- inject_Z_mult, <- inject_Z_plus. change 0 with (inject_Z 0). rewrite inject_Z_injective.
  change 0 with (inject_Z 0) in some. rewrite !inject_Z_injective in some. intros none.
  destruct (Z.lt_trichotomy (lb l) 0) as [low | [level | high]]; [nia | rewrite level in *; lia | nia].
Qed.

Definition is_off_lines (lines : list line) (x : vector) : Prop := forall l, In l lines -> ~ value_at l x == 0.

Lemma steps_leave_lines (lines : list line) (x v : vector) : (forall l, In l lines -> ~ dot (normal_of l) v == 0) ->
  eventually (fun e => is_off_lines lines (moved_along x v e)).
Proof.
  intros across. apply (eventually_for_all (fun l e => ~ value_at l (moved_along x v e) == 0)). intros l L.
  refine (eventually_implied _ _ _ (leaves_a_number (value_at l x) _ 0 (across l L))). intros e.
  now rewrite value_moved.
Qed.

Lemma strictly_in_if_off_lines (lines : list line) (t : piece) (x : vector) :
  (forall l, In l (side_lines t) -> In l lines) -> is_off_lines lines x -> inside_piece t x -> strictly_in t x.
Proof.
  intros its free x_in l L. specialize (x_in l L). specialize (free l (its l L)).
  destruct (Q_dec (value_at l x) 0) as [[low | high] | on]; [lra | exact high | tauto].
Qed.

Lemma off_boundary_if_off_lines (r : polygonal_region) (inserted : list (list hpoint)) (polygons : list polygon)
  (lines : list line) (x : vector) : are_a_region (hedges_of_region r) inserted (map piece_of polygons) = true ->
  (forall t l, In t (map piece_of polygons) -> In l (side_lines t) -> In l lines) -> is_off_lines lines x ->
  off x (boundary r).
Proof.
  intros accepted its free s S on. unfold boundary in S. apply in_map_iff in S. destruct S as (e & <- & E).
  destruct (edges_are_on_sides _ _ _ accepted e x E on) as (t & side & T & I & (k & range & X & Y)).
  apply (free (line_through (fst side) (snd side))).
  - apply (its t); [exact T |]. rewrite (pieces_of_corners _ t T). cbn [piece_of side_lines].
    apply in_map_iff. now exists side.
  - rewrite (value_at_equal _ x (point_between (vector_of (fst side)) (vector_of (snd side)) k)) by (now split).
    rewrite value_between, value_at_first, value_at_second. ring.
Qed.

Section Checked.
  Variables (p q : polygonal_region) (s : open_region) (c : certificate).
  Hypothesis checked : is_checked true p q s c.

  Let lines : list line := flat_map side_lines (p_pieces c ++ q_pieces c).

  Lemma p_pieces_are_convex (t : piece) : In t (p_pieces c) -> is_convex t = true /\ t = piece_of (corners_of t).
  Proof. exact (pieces_of_polygons_are_convex _ _ _ (p_is_made_of_pieces _ _ _ _ _ checked) t). Qed.

  Lemma q_pieces_are_convex (u : piece) : In u (q_pieces c) -> is_convex u = true /\ u = piece_of (corners_of u).
  Proof. exact (pieces_of_polygons_are_convex _ _ _ (q_is_made_of_pieces _ _ _ _ _ checked) u). Qed.

  Lemma lines_of_p (t : piece) (l : line) : In t (p_pieces c) -> In l (side_lines t) -> In l lines.
  Proof. intros T L. apply in_flat_map. exists t. split; [apply in_or_app; now left | exact L]. Qed.

  Lemma lines_of_q (u : piece) (l : line) : In u (q_pieces c) -> In l (side_lines u) -> In l lines.
  Proof. intros U L. apply in_flat_map. exists u. split; [apply in_or_app; now right | exact L]. Qed.

  (* A direction that is along no side. *)
  Lemma direction_across : exists v, forall x, eventually (fun e => is_off_lines lines (moved_along x v e)) /\
    eventually (fun e => is_off_lines lines (moved_along x (opposite_of v) e)).
  Proof.
    destruct (some_direction_is_across lines) as (v & across).
    { intros l L. apply in_flat_map in L. destruct L as (t & T & L). apply in_app_or in T.
      destruct T as [T | T]; [apply p_pieces_are_convex in T | apply q_pieces_are_convex in T];
        destruct T as [convex its]; now apply (side_line_has_a_normal t). }
    exists v. intros x. split; apply steps_leave_lines; [exact across |]. intros l L on. apply (across l L).
    unfold dot, opposite_of in *. cbn [vx vy] in *. lra.
  Qed.

  (* A point inside a region, with the points near it. *)
  Lemma members_near (r : polygonal_region) (x : point) (v : vector) : is_inner_point x r ->
    eventually (fun e => member (as_point (moved_along (as_vector x) v e)) r).
  Proof.
    rewrite inner_point_by_boundary. intros [round free].
    destruct (winding_number_near _ _ (boundary_cycles r) free) as (radius & R & near).
    refine (eventually_implied _ _ _ (small_steps_stay_within radius (as_vector x) v R)). intros e close.
    apply member_is. right. rewrite as_vector_of_point. now rewrite (proj2 (near _ close)).
  Qed.

  (* Sums of inner points are sums of points strictly inside pieces. *)
  Lemma sums_are_of_pieces (a b x : point) : is_inner_point a p -> is_inner_point b q ->
    equal_points x (sum_of_points a b) -> is_inner_sum_of_some (p_pieces c) (q_pieces c) (as_vector x).
  Proof.
    intros in_p in_q [x_x x_y]. destruct direction_across as (v & across).
    destruct (some_small _ (eventually_and _ _
      (eventually_and _ _ (members_near p a v in_p) (members_near q b (opposite_of v) in_q))
      (eventually_and _ _ (proj1 (across (as_vector a))) (proj2 (across (as_vector b))))))
      as (e & _ & [a_in b_in] & a_off & b_off).
    apply (region_is_in_pieces _ _ _ (p_is_made_of_pieces _ _ _ _ _ checked)) in a_in. destruct a_in as (t & T & a_in).
    apply (region_is_in_pieces _ _ _ (q_is_made_of_pieces _ _ _ _ _ checked)) in b_in. destruct b_in as (u & U & b_in).
    rewrite as_vector_of_point in a_in, b_in. exists t, u. split; [exact T | split; [exact U |]].
    eexists _, _. split; [exact (strictly_in_if_off_lines lines t _ (fun l => lines_of_p t l T) a_off a_in) |].
    split; [exact (strictly_in_if_off_lines lines u _ (fun l => lines_of_q u l U) b_off b_in) |].
    unfold equal_vectors, added, moved_along, opposite_of, as_vector in *. cbn [vx vy x_of y_of sum_of_points] in *.
    rewrite x_x, x_y. split; ring.
  Qed.

  (* And conversely. *)
  Lemma sums_of_pieces_are_sums (x : point) : is_inner_sum_of_some (p_pieces c) (q_pieces c) (as_vector x) ->
    exists a b, is_inner_point a p /\ is_inner_point b q /\ equal_points x (sum_of_points a b).
  Proof.
    intros (t & u & T & U & a & b & A & B & x_x & x_y). destruct direction_across as (v & across).
    destruct (some_small _ (eventually_and _ _
      (eventually_and _ _ (stays_strictly_in t a v A) (stays_strictly_in u b (opposite_of v) B))
      (eventually_and _ _ (proj1 (across a)) (proj2 (across b))))) as (e & _ & [a_in b_in] & a_off & b_off).
    assert (inner_ : forall r inserted polygons m y,
      are_a_region (hedges_of_region r) inserted (map piece_of polygons) = true ->
      (forall m l, In m (map piece_of polygons) -> In l (side_lines m) -> In l lines) -> In m (map piece_of polygons) ->
      strictly_in m y -> is_off_lines lines y -> is_inner_point (as_point y) r).
    { intros r inserted polygons m y accepted its M y_in y_off. apply inner_point_by_boundary.
      rewrite as_vector_of_point.
      pose proof (off_boundary_if_off_lines r inserted polygons lines y accepted its y_off) as free.
      split; [| exact free]. apply strictly_in_is_inside in y_in.
      assert (there : member (as_point y) r).
      { apply (pieces_are_in_region _ _ _ accepted (pieces_of_corners _) m _ M). now rewrite as_vector_of_point. }
      apply member_is in there. rewrite as_vector_of_point in there.
      destruct there as [(e' & E' & on) | round]; [now destruct (free e' E') | exact round]. }
    eexists _, _.
    split; [exact (inner_ _ _ _ t _ (p_is_made_of_pieces _ _ _ _ _ checked) lines_of_p T a_in a_off) |].
    split; [exact (inner_ _ _ _ u _ (q_is_made_of_pieces _ _ _ _ _ checked) lines_of_q U b_in b_off) |].
    unfold equal_points, added, moved_along, opposite_of, as_vector, as_point in *.
    cbn [vx vy x_of y_of sum_of_points] in *.
    rewrite x_x, x_y. split; ring.
  Qed.

  (* No edge of S, dangling edge or isolated point is on a sum of points strictly inside pieces. *)
  Lemma edges_are_on_no_sum (e : hedge) (x : vector) : is_inner_sum_of_some (p_pieces c) (q_pieces c) x ->
    In e (hedges_of_region (open_chains s) ++ dangling s ++ map (fun v => (v, v)) (isolated s)) ->
    ~ lies_on x (segment_of_hedge e).
  Proof.
    intros (t & u & T & U & x_in) E (k & range & X & Y). cbn [segment_of_hedge source target] in *.
    destruct (all_beside (unit c) _ _ _ p_pieces_are_convex q_pieces_are_convex (edges_are_beside _ _ _ _ _ checked)
      e t u E T U) as (n & some & sides_).
    destruct (p_pieces_are_convex t T) as [t_convex t_lines]. destruct (q_pieces_are_convex u U) as [u_convex u_lines].
    pose proof (inner_sum_is_farther_than n (dot n (vector_of (fst e))) t u x t_convex t_lines u_convex u_lines some
      x_in (fun a b A B => proj1 (sides_ a b A B))) as first.
    pose proof (inner_sum_is_farther_than n (dot n (vector_of (snd e))) t u x t_convex t_lines u_convex u_lines some
      x_in (fun a b A B => proj2 (sides_ a b A B))) as second.
    pose proof (mixed_is_less k _ _ _ range first second) as less.
    assert (x_is : dot n x == (1 - k) * dot n (vector_of (fst e)) + k * dot n (vector_of (snd e)))
      by (unfold dot; rewrite X, Y; ring). lra.
  Qed.

  (* What is inside S is a sum of points strictly inside pieces, or left out. *)
  Lemma inside_is_covered (x : point) : is_inner_point x (open_chains s) ->
    is_sum_or_left_out (p_pieces c) (q_pieces c) (dangling s) (isolated s) (as_vector x).
  Proof.
    intros inside_. pose proof inside_ as [round _]. apply inner_point_by_boundary in inside_.
    destruct inside_ as [_ free].
    pose proof (s_is_made_of_pieces _ _ _ _ _ checked) as s_region. unfold s_pieces in s_region.
    pose proof s_region as of_corners. rewrite <- (map_map fst piece_of) in of_corners.
    pose proof (pieces_of_polygons_are_convex _ _ _ of_corners) as convex. rewrite map_map in convex.
    destruct (region_is_in_pieces _ _ _ s_region x (or_intror round)) as (t & T & x_in).
    destruct (convex t T) as [t_convex t_lines].
    destruct (on_or_off (as_vector x) (map segment_of_hedge (sides (corners_of t)))) as [(side & I & on) | off_sides].
    - apply in_map_iff in I. destruct I as (h & <- & I).
      destruct (sides_are_edges_or_diagonals _ _ _ _ s_region (sides_are_listed _ _ _ _ _ checked eq_refl) t h _ T I on)
        as [(e & E & on_e) | ([[a b] its_seam] & D & on_d)].
      + now destruct (free _ (in_map segment_of_hedge _ e E)).
      + pose proof (seams_are_checked _ _ _ _ _ checked eq_refl _ D) as found.
        assert (not_end : forall y, y = a \/ y = b -> ~ equal_vectors (as_vector x) (vector_of y)).
        { intros y end_ equal_. destruct (ends_of_diagonals_are_on_edges _ _ _ _ s_region a b its_seam y D end_)
            as (e & E & on_e). apply (free _ (in_map segment_of_hedge _ e E)).
          unfold segment_of_hedge in *. symmetry in equal_.
          now refine (lies_on_of_equal _ _ _ _ _ _ equal_ _ _ on_e). }
        assert (apart : ~ equal_vectors (vector_of a) (vector_of b)).
        { intros [x_is y_is]. apply (not_end a); [now left |]. destruct on_d as (k & _ & X & Y).
          cbn [fst snd segment_of_hedge source target] in *. rewrite <- x_is in X. rewrite <- y_is in Y. split; lra. }
        unfold is_seam_of_edge in found. cbn [fst snd] in *.
        apply (seam_is_covered (p_pieces c) (q_pieces c) (dangling s) (isolated s) p_pieces_are_convex
          q_pieces_are_convex (line_through a b) (later its_seam) (line_has_a_normal a b apart) a b (beginning its_seam) _ found);
          [apply value_at_first | apply value_at_second |].
        split; [exact apart |]. destruct on_d as (k & range & X & Y). cbn [segment_of_hedge fst snd source target] in *.
        exists k. split; [| now split].
        destruct (Qeq_dec k 0) as [k_is | not_a]; [exfalso; apply (not_end a); [now left |] |].
        { rewrite k_is in X, Y. split; lra. }
        destruct (Qeq_dec k 1) as [k_is | not_b]; [exfalso; apply (not_end b); [now right |] |].
        { rewrite k_is in X, Y. split; lra. }
        lra.
    - apply in_map_iff in T. destruct T as (d & t_is & D). subst t.
      apply (cells_are_covered (p_pieces c) (q_pieces c) (dangling s) (isolated s) p_pieces_are_convex
        q_pieces_are_convex (snd d) (fst d) _ (cells_are_checked _ _ _ _ _ checked d D)).
      now apply piece_is_around.
  Qed.

  Theorem checked_is_open_sum : is_open_sum p q s.
  Proof.
    intros x. split.
    - intros (inside_ & off_dangling & not_isolated). apply sums_of_pieces_are_sums.
      destruct (inside_is_covered x inside_) as [sum_ | [(e & E & on) | (v & V & equal_)]]; [exact sum_ | exfalso ..].
      + unfold dangling in E. apply in_map_iff in E. destruct E as (d & <- & D). apply (off_dangling d D), is_on_is, on.
      + unfold isolated in V. apply in_map_iff in V. destruct V as (w & <- & W). apply (not_isolated w W).
        destruct equal_ as [X Y], (homogeneous_is w) as [X' Y']. cbn [vx vy as_vector] in *. split; lra.
    - intros (a & b & in_p & in_q & x_is). pose proof (sums_are_of_pieces a b x in_p in_q x_is) as sum_.
      assert (free : forall e,
        In e (hedges_of_region (open_chains s) ++ dangling s ++ map (fun v => (v, v)) (isolated s)) ->
        ~ lies_on (as_vector x) (segment_of_hedge e)) by (intros e; now apply edges_are_on_no_sum).
      split; [| split].
      + apply inner_point_by_boundary.
        assert (off_s : off (as_vector x) (boundary (open_chains s))).
        { intros h H. apply in_map_iff in H. destruct H as (e & <- & E). apply free, in_or_app. now left. }
        split; [| exact off_s]. destruct sum_ as (t & u & T & U & a' & b' & A & B & x_is').
        pose proof (sums_of_pieces_are_members true p q s c checked t u a' b' x T U (strictly_in_is_inside _ _ A)
          (strictly_in_is_inside _ _ B) x_is') as in_s.
        apply member_is in in_s. destruct in_s as [(h & H & on) | round]; [now destruct (off_s h H) | exact round].
      + intros e E on. apply is_on_is in on. apply (free (hedge_of e)); [| exact on].
        apply in_or_app. right. apply in_or_app. left. now apply in_map.
      + intros v V [X Y]. destruct (homogeneous_is v) as [X' Y']. cbn [vx vy] in X', Y'.
        apply (free (homogeneous v, homogeneous v)).
        * apply in_or_app. right. apply in_or_app. right. apply in_map_iff. exists (homogeneous v).
          split; [reflexivity | now apply in_map].
        * exists 0. cbn [segment_of_hedge fst snd source target as_vector vx vy]. split; [lra | split; lra].
  Qed.
End Checked.

(* What is known of an accepted open sum besides: its regions are made of the pieces. *)
Lemma accepted_regions (p q : polygonal_region) (s : open_region) (c : certificate) : accepts_open p q s c = true ->
  are_a_region (hedges_of_region p) (summand_inserted (of_p c)) (map piece_of (summand_pieces (of_p c))) = true /\
  are_a_region (hedges_of_region q) (summand_inserted (of_q c)) (map piece_of (summand_pieces (of_q c))) = true /\
  are_a_region (hedges_of_region (open_chains s)) (sum_inserted c) (map (fun d => piece_of (fst d)) (sum_pieces c)) =
    true.
Proof.
  intros accepted. apply accepted_open_is_checked in accepted. repeat split;
    [exact (p_is_made_of_pieces _ _ _ _ _ accepted) | exact (q_is_made_of_pieces _ _ _ _ _ accepted) |
     exact (s_is_made_of_pieces _ _ _ _ _ accepted)].
Qed.

(* If the checker accepts P, Q, S and a certificate, S is the open Minkowski sum of P and Q, and their edges touch at
   most. *)
Theorem accepted_open_sums_are_open_sums : accepts_only_open_sums accepts_open.
Proof.
  intros p q s c accepted. apply accepted_open_is_checked in accepted.
  split; [exact (checked_is_open_sum p q s c accepted) | exact (accepted_edges _ _ _ _ _ accepted)].
Qed.
