(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* What meets a piece of a segment, cut where others meet it (pieces.v): no end of another segment is strictly inside
   a piece, and another segment with a point strictly inside it runs along all of it. So inside the pieces of a
   region's boundary are no vertices; and inside those between two contacts of boundaries no vertices of either. *)
From Coq Require Import ZArith Lia Bool List.
From Oplus Require Import numbers regions_and_sums location beside_a_piece pieces naive_collision.
Import ListNotations.

Open Scope Q_scope.

Lemma lines_meet_once (s f : segment) (p w : vector) : ~ cross (along s) (along f) == 0 ->
  lies_on p s -> lies_on p f -> lies_on w s -> lies_on w f -> equal_vectors w p.
Proof.
  intros turn (t & _ & tx & ty) (u & _ & ux & uy) (t' & _ & tx' & ty') (u' & _ & ux' & uy').
  split; apply (Qmult_inj_l _ _ _ turn); in_coordinates; by_equations.
Qed.

(* Two segments that cross do so at their crossing point. *)
Lemma crossing_point_is (s f : segment) : cross_properly s f = true ->
  strictly_inside (crossing_point s f) s /\ strictly_inside (crossing_point s f) f /\
  ~ cross (along s) (along f) == 0.
Proof.
  intros crossing_. unfold cross_properly in crossing_. rewrite !orientation_by_area in crossing_.
  apply andb_true_iff in crossing_. destruct crossing_ as [f_across s_across].
  set (u := area (Segment (source s) (target s)) (source f)) in *.
  set (v := area (Segment (source s) (target s)) (target f)) in *.
  set (p := area (Segment (source f) (target f)) (source s)) in *.
  set (q := area (Segment (source f) (target f)) (target s)) in *.
  assert (sides : forall x y : Q, opposite_sides (x ?= 0) (y ?= 0) = true -> x < 0 /\ 0 < y \/ 0 < x /\ y < 0).
  { intros x y opposite_. compared_numbers (x ?= 0); compared_numbers (y ?= 0); try discriminate opposite_; lra. }
  apply sides in f_across. apply sides in s_across. clear sides.
  assert (turn_1 : cross (along s) (along f) == v - u) by (unfold u, v; by_coordinates).
  assert (turn_2 : cross (along s) (along f) == p - q) by (unfold p, q; by_coordinates).
  assert (turn : ~ cross (along s) (along f) == 0) by lra.
  set (D := cross (along s) (along f)) in *.
  assert (p_is : cross (minus (source f) (source s)) (along f) == p) by (unfold p; by_coordinates).
  assert (k_is : cross (minus (source f) (source s)) (along f) / D * D == p) by (rewrite p_is; field; exact turn).
  assert (l_is : - u / D * D == - u) by (field; exact turn).
  unfold crossing_point. fold D. set (k := _ / D) in *. set (l := - u / D) in *. clearbody k l.
  assert (fraction_ : forall x y : Q, 0 < x * y -> 0 < (1 - x) * y -> 0 < x < 1).
  { intros x y X Y. destruct (Qlt_le_dec 0 y); split; apply Qnot_le_lt; intros extreme; nra. }
  assert (range : 0 < k < 1 /\ 0 < l < 1).
  { destruct s_across as [[P Q_] | [P Q_]], f_across as [[P' Q'] | [P' Q']]; split;
      first [apply (fraction_ _ D); lra | apply (fraction_ _ (- D)); lra]. }
  destruct range as [k_range l_range].
  split; [exists k; split; [exact k_range |]; split; by_coordinates |]. split; [| exact turn].
  exists l. split; [exact l_range |]. clear fraction_ k_range l_range s_across f_across p_is. cbn [vx vy].
  split; apply (Qmult_inj_r _ _ D turn); unfold p, u, q, v, D in *; in_coordinates; by_equations.
Qed.

(* Those with a point inside both that are not parallel do. *)
Lemma inside_both_is_crossing (s f : segment) (w : vector) : ~ cross (along s) (along f) == 0 ->
  strictly_inside w s -> strictly_inside w f -> cross_properly s f = true.
Proof.
  intros turn (t & t_inside & tx & ty) (u & u_inside & ux & uy). set (D := cross (along s) (along f)) in *.
  assert (areas : (area (Segment (source s) (target s)) (source f) == - u * D /\
                   area (Segment (source s) (target s)) (target f) == (1 - u) * D) /\
                  (area (Segment (source f) (target f)) (source s) == t * D /\
                   area (Segment (source f) (target f)) (target s) == - ((1 - t) * D)))
    by (repeat split; unfold D; in_coordinates; by_equations).
  destruct areas as ((one & two) & three & four).
  unfold cross_properly. rewrite !orientation_by_area, one, two, three, four.
  clearbody D. clear - turn t_inside u_inside.
  compared_numbers (- u * D ?= 0); compared_numbers ((1 - u) * D ?= 0);
    compared_numbers (t * D ?= 0); compared_numbers (- ((1 - t) * D) ?= 0); try reflexivity; exfalso;
    destruct (Q_dec D 0) as [[negative_ | positive_] | none]; try contradiction; nra.
Qed.

Lemma intersection_is_on_both (s f : segment) (p : vector) : In p (intersection s f) ->
  lies_on p s /\ lies_on p f /\
  ((p = source s \/ p = target s \/ p = source f \/ p = target f) \/ ~ cross (along s) (along f) == 0).
Proof.
  intros I. unfold intersection in I. destruct (sorted_points _) as [| a l] eqn:sorted.
  - destruct (cross_properly s f) eqn:crossing_; [| destruct I]. destruct I as [<- | []].
    destruct (crossing_point_is s f crossing_) as (in_s & in_f & turn). auto using strictly_inside_lies_on.
  - rewrite <- sorted in I. apply sorted_in, in_app_iff in I.
    destruct I as [I | I]; apply filter_In in I; destruct I as [[<- | [<- | []]] on];
      match type of on with is_on_segment ?p ?t = true => destruct (is_on_spec p t); [| discriminate] end;
      auto 10 using source_lies_on, target_lies_on.
Qed.

(* An end that is on the other segment is found. *)
Lemma intersection_has_ends (s f : segment) (p : vector) :
  (p = source s \/ p = target s) /\ lies_on p f \/ (p = source f \/ p = target f) /\ lies_on p s ->
  exists q, In q (intersection s f) /\ equal_vectors p q.
Proof.
  intros which. unfold intersection. set (ends := filter _ [source s; target s] ++ filter _ _).
  destruct (sorted_has p ends) as (q & J & equal).
  { apply in_app_iff. destruct which as [[end_ on] | [end_ on]]; [left | right]; apply filter_In;
      (split; [destruct end_ as [-> | ->]; cbn; tauto | now apply (reflect_iff _ _ (is_on_spec p _))]). }
  exists q. split; [| exact equal]. destruct (sorted_points ends); [destruct J | exact J].
Qed.

(* And so is the common point of two segments that are not parallel. *)
Lemma intersection_has (s f : segment) (w : vector) : ~ cross (along s) (along f) == 0 ->
  lies_on w s -> lies_on w f -> exists q, In q (intersection s f) /\ equal_vectors w q.
Proof.
  intros turn on_s on_f.
  enough (some : exists p, In p (intersection s f)).
  { destruct some as (p & I). exists p. split; [exact I |]. apply intersection_is_on_both in I.
    now apply (lines_meet_once s f). }
  assert (end_ : forall p t, equal_vectors p w -> lies_on w t -> lies_on p t)
    by (intros p t equal; apply lies_on_equal; now symmetry).
  assert (at_end : forall p, (p = source s \/ p = target s) /\ lies_on p f \/
    (p = source f \/ p = target f) /\ lies_on p s -> exists p, In p (intersection s f))
    by (intros p which; destruct (intersection_has_ends s f p which) as (q & I & _); now exists q).
  destruct (inside_or_end w s on_s) as [in_s | [equal | equal]];
    [| apply (at_end (source s)); auto | apply (at_end (target s)); auto].
  destruct (inside_or_end w f on_f) as [in_f | [equal | equal]];
    [| apply (at_end (source f)); auto | apply (at_end (target f)); auto].
  unfold intersection. rewrite (inside_both_is_crossing s f w turn in_s in_f).
  destruct (sorted_points _) as [| p l]; eexists; now left.
Qed.

Lemma part_is_long (piece s : segment) : is_part piece s -> nonzero (along s) ->
  nonzero (along piece) /\ exists c, 0 < c /\
    vx (along piece) == c * vx (along s) /\ vy (along piece) == c * vy (along s).
Proof.
  intros (j & k & _ & less & _ & [jx jy] & [kx ky]) long. unfold point_at in *; cbn [vx vy] in *.
  assert (x_is : vx (along piece) == (k - j) * vx (along s))
    by (unfold along, minus; cbn [vx vy]; rewrite jx, kx; ring).
  assert (y_is : vy (along piece) == (k - j) * vy (along s))
    by (unfold along, minus; cbn [vx vy]; rewrite jy, ky; ring).
  split; [| exists (k - j); split; [lra | tauto]]. intros [no_x no_y]. apply long. rewrite x_is in no_x.
  rewrite y_is in no_y. destruct (Qmult_integral _ _ no_x), (Qmult_integral _ _ no_y); split; trivial; exfalso; lra.
Qed.

Lemma part_lies_on (piece s : segment) (w : vector) : is_part piece s -> lies_on w piece -> lies_on w s.
Proof.
  intros (j & k & low & less & high & j_is & k_is) (t & range & at_t). exists ((1 - t) * j + t * k).
  split; [split; nra | exact (point_of_part piece s w j k t j_is k_is at_t)].
Qed.

Lemma strictly_inside_part (piece s : segment) (w : vector) : is_part piece s ->
  strictly_inside w piece -> strictly_inside w s.
Proof.
  intros (j & k & low & less & high & j_is & k_is) (t & range & at_t). exists ((1 - t) * j + t * k).
  split; [split; nra | exact (point_of_part piece s w j k t j_is k_is at_t)].
Qed.

(* Theorem. Of a segment cut where others meet it: strictly inside a piece are no ends of the others, and what has a
   point strictly inside a piece is parallel to it. *)
Theorem nothing_meets_a_piece (s : segment) (others : list segment) (piece f : segment) (w : vector) :
  nonzero (along s) -> In piece (cut_where_met s others) -> strictly_inside w piece -> In f others ->
  ~ equal_vectors w (source f) /\ ~ equal_vectors w (target f) /\
  (lies_on w f -> cross (along s) (along f) == 0).
Proof.
  intros long I inside_ J. destruct (cut_returns s (flat_map (intersection s) others) long) as [none _].
  destruct (none piece I) as [part no_point].
  pose proof (part_lies_on piece s w part (strictly_inside_lies_on _ _ inside_)) as on.
  assert (not_met : forall q, In q (intersection s f) -> ~ equal_vectors w q)
    by (intros q K; apply no_point; [apply in_flat_map; now exists f | exact inside_]).
  assert (no_end : forall p, p = source f \/ p = target f -> ~ equal_vectors w p).
  { intros p which equal. destruct (intersection_has_ends s f p) as (q & K & equal_q).
    - right. split; [exact which | now apply (lies_on_equal w)].
    - apply (not_met q K). now transitivity p. }
  split; [apply no_end; now left |]. split; [apply no_end; now right |].
  intros on_f. destruct (Qeq_dec (cross (along s) (along f)) 0) as [| turn]; [assumption | exfalso].
  destruct (intersection_has s f w turn on on_f) as (q & K & equal). exact (not_met q K equal).
Qed.

Lemma strictly_inside_between (v w x : vector) (s : segment) : strictly_inside v s -> strictly_inside w s ->
  lies_on x (Segment v w) -> strictly_inside x s.
Proof.
  intros (k & k_range & kx & ky) (l & l_range & lx & ly) (t & t_range & tx & ty). cbn [source target] in *.
  exists ((1 - t) * k + t * l). split; [split; [apply mixed_is_more | apply mixed_is_less]; lra |].
  rewrite tx, ty, kx, ky, lx, ly. split; ring.
Qed.

(* On a line through a point of the piece, in its direction. *)
Lemma collinear_by_direction (e t : segment) (w : vector) :
  lies_on w e -> lies_on w t -> cross (along e) (along t) == 0 -> collinear e t.
Proof.
  intros (k & _ & X & Y) (j & _ & U & V) parallel. unfold collinear. in_coordinates. split; by_equations.
Qed.

Lemma pieces_are_met_only_along (s : segment) (others : list segment) (piece : segment) :
  nonzero (along s) -> In piece (cut_where_met s others) -> met_only_along others piece.
Proof.
  intros long I w t inside_ J on. destruct (nothing_meets_a_piece s others piece t w long I inside_ J)
    as (_ & _ & parallel).
  specialize (parallel on). destruct (proj1 (cut_returns s _ long) piece I) as [part _].
  destruct (part_is_long piece s part long) as (_ & c & _ & cx & cy).
  apply (collinear_by_direction piece t w (strictly_inside_lies_on _ _ inside_) on). unfold cross in *. by_equations.
Qed.

(* Theorem. So it runs along all of the piece. *)
Theorem runs_along_the_piece (s : segment) (others : list segment) (piece t : segment) (v w : vector) :
  nonzero (along s) -> In piece (cut_where_met s others) -> In t others -> nonzero (along t) ->
  strictly_inside v piece -> lies_on v t -> strictly_inside w piece -> lies_on w t.
Proof.
  intros long I J long_t in_v on_v in_w.
  assert (no_end : forall x, x = source t \/ x = target t -> ~ lies_on x (Segment v w)).
  { intros x which on. pose proof (strictly_inside_between v w x piece in_v in_w on) as in_x.
    destruct (nothing_meets_a_piece s others piece t x long I in_x J) as (no_source & no_target & _).
    destruct which as [-> | ->]; [now apply no_source | now apply no_target]. }
  destruct (pieces_are_met_only_along s others piece long I v t in_v J on_v) as [line_1 line_2].
  destruct (multiple_of (along piece) (along t) long_t) as (c & cx & cy); [in_coordinates; lra |].
  destruct in_v as (k & _ & kx & ky), in_w as (l & _ & lx & ly), on_v as (m & m_range & mx & my).
  set (n := m + (l - k) * c). clear line_1 line_2.
  assert (w_is : vx w == (1 - n) * vx (source t) + n * vx (target t) /\
    vy w == (1 - n) * vy (source t) + n * vy (target t))
    by (unfold n; in_coordinates; split; by_equations).
  clearbody n. clear kx ky lx ly cx cy. exists n. split; [| exact w_is]. destruct w_is.
  assert (between_ : forall r x, 0 <= r <= 1 -> vx x == (1 - r) * vx v + r * vx w ->
    vy x == (1 - r) * vy v + r * vy w ->
    lies_on x (Segment v w)) by (intros r x range X Y; exists r; tauto).
  split; apply Qnot_lt_le; intros outside_;
    [apply (no_end (source t)); [now left |] | apply (no_end (target t)); [now right |]].
  - assert (quotient : m / (m - n) * (m - n) == m) by (field; lra).
    apply (between_ (m / (m - n))); [split; [apply Qle_shift_div_l | apply Qle_shift_div_r]; lra | |];
      set (r := m / (m - n)) in *; clearbody r; by_equations.
  - assert (quotient : (1 - m) / (n - m) * (n - m) == 1 - m) by (field; lra).
    apply (between_ ((1 - m) / (n - m))); [split; [apply Qle_shift_div_l | apply Qle_shift_div_r]; lra | |];
      set (r := (1 - m) / (n - m)) in *; clearbody r; by_equations.
Qed.

(* Each point of an edge is on a piece of it. *)
Lemma on_a_piece (r : region) (e : segment) (w : vector) : no_edges_are_points r -> In e (region_edges r) ->
  lies_on w e -> exists t, In t (boundary_pieces r) /\ is_part t e /\ lies_on w t.
Proof.
  intros not_points E on.
  destruct (proj2 (cut_returns e (flat_map (intersection e) (region_edges r))
    (region_edges_are_directions r not_points e E)) w on) as (t & T & part & on_t).
  exists t. split; [apply in_flat_map; now exists e | now split].
Qed.

(* Inside a piece of an edge is no vertex. *)
Lemma boundary_piece_is (r : region) (s : segment) : no_edges_are_points r -> In s (boundary_pieces r) ->
  exists e, In e (region_edges r) /\ nonzero (along e) /\ is_part s e /\
    (forall w, strictly_inside w s -> lies_on w e /\ ~ is_vertex w r).
Proof.
  intros not_points I. apply in_flat_map in I. destruct I as (e & E & I). exists e.
  pose proof (region_edges_are_directions r not_points e E) as long.
  destruct (proj1 (cut_returns e (flat_map (intersection e) (region_edges r)) long) s I) as [part _].
  split; [exact E |]. split; [exact long |]. split; [exact part |]. intros w inside_.
  split; [exact (part_lies_on s e w part (strictly_inside_lies_on _ _ inside_)) |].
  intros (u & U & equal). now destruct (nothing_meets_a_piece e _ s u w long I inside_ U).
Qed.

(* A piece of an edge e of a, cut once more where the boundary of b meets it: edges of b run along it or do not meet
   it, and no vertices are inside it. *)
Theorem contact_piece_is (a b : region) (s piece : segment) : no_edges_are_points a -> no_edges_are_points b ->
  In s (boundary_pieces a) -> In piece (cut_where_met s (boundary_pieces b)) ->
  nonzero (along piece) /\ met_only_along (region_edges b) piece /\
  exists e, In e (region_edges a) /\
    (exists c, 0 < c /\ vx (along piece) == c * vx (along e) /\ vy (along piece) == c * vy (along e)) /\
    forall w, strictly_inside w piece -> lies_on w e /\ ~ is_vertex w a /\ ~ is_vertex w b.
Proof.
  intros a_edges b_edges I J. destruct (boundary_piece_is a s a_edges I) as (e & E & long_e & s_part & no_vertex).
  destruct (part_is_long s e s_part long_e) as (long_s & c & C & cx & cy).
  destruct (proj1 (cut_returns s (flat_map (intersection s) (boundary_pieces b)) long_s) piece J) as [part _].
  destruct (part_is_long piece s part long_s) as (long & d & D & dx & dy).
  split; [exact long |]. split.
  - intros w f in_piece F on. destruct (on_a_piece b f w b_edges F on) as (t & T & t_part & on_t).
    destruct (part_is_long t f t_part (region_edges_are_directions b b_edges f F)) as (_ & k & K & kx & ky).
    destruct (pieces_are_met_only_along s _ piece long_s J w t in_piece T on_t) as [line_1 line_2].
    apply (collinear_by_direction piece f w (strictly_inside_lies_on _ _ in_piece) on).
    apply (Qmult_inj_l _ _ k); [lra |]. transitivity (cross (along piece) (along t)); [| in_coordinates; lra].
    unfold cross. rewrite kx, ky. ring.
  - exists e. split; [exact E |]. split; [exists (d * c); split; [now apply Qmult_lt_0_compat |] |].
    { rewrite dx, dy, cx, cy. split; ring. }
    intros w in_piece.
    destruct (no_vertex w) as [on free]; [| split; [exact on |]; split; [exact free |]].
    { exact (strictly_inside_part piece s w part in_piece). }
    intros (f & F & equal). destruct (on_a_piece b f (source f) b_edges F (source_lies_on f)) as (t & T & _ & on_t).
    destruct (nothing_meets_a_piece s _ piece t w long_s J in_piece T) as (no_source & no_target & _).
    destruct (inside_or_end w t) as [in_t | [end_ | end_]];
      [now apply (lies_on_equal (source f)) | | now symmetry in end_ ..].
    destruct (boundary_piece_is b t b_edges T) as (g & _ & _ & _ & free_t). apply (free_t w in_t). now exists f.
Qed.
