(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* x is moved along a segment. If no vertex of P comes to an edge of -Q + x on the way or leaves one, nor a vertex of
   -Q + x an edge of P, and no vertices meet, then the interiors of P and -Q + x meet all along the way, or nowhere.
   What shows that they meet (contacts.v) is still there after the move: the parallelogram of two edges that cross
   still goes round x (crossing_edges.v), and vertices on an edge keep their order, so that the part between two of
   them is met by other edges where it was met before. *)
From Coq Require Import QArith Lqa Qfield ZArith Lia Bool List.
From Oplus Require Import convolution signed_crossings meeting_of_segments regions reflected parallelogram
  crossing_edges interiors_meet neighbourhoods left_of_an_edge winding_number_of_the_sum theorem_4_2_1
  boundary_points location rotation pieces naive_collision met_pieces collision_is_sound collision_is_complete
  placed_collision contacts.
Import ListNotations.

Open Scope Q_scope.

Lemma minus_twice (x w : vector) : equal_vectors (minus x (minus x w)) w.
Proof. unfold minus. split; cbn [vx vy]; ring. Qed.

Lemma vertex_of_placed_iff (x w : vector) (q : region) : is_vertex w (placed x q) <-> is_vertex (minus x w) q.
Proof.
  split; [| apply vertex_of_placed]. intros (u & U & X & Y). rewrite edges_of_placed in U. apply in_map_iff in U.
  destruct U as (t & <- & T). exists t. split; [exact T |].
  unfold reflected, minus in *; cbn [source vx vy] in *. split; cbn [vx vy]; lra.
Qed.

Lemma meet_inside_placed (x : vector) (p q : region) : meet_inside p (placed x q) <-> interiors_meet x p q.
Proof.
  unfold meet_inside, interiors_meet. split; intros (z & in_p & in_q); exists z; (split; [exact in_p |]);
    now apply inside_placed.
Qed.

Lemma fraction_of_reflected (x w : vector) (f : segment) :
  fraction (reflected x f) w == fraction f (minus x w).
Proof.
  assert (top : dot (minus w (source (reflected x f))) (along (reflected x f)) ==
    dot (minus (minus x w) (source f)) (along f))
    by (unfold dot, along, reflected, minus; cbn [source target vx vy]; ring).
  assert (bottom : dot (along (reflected x f)) (along (reflected x f)) == dot (along f) (along f))
    by (unfold dot, along, reflected, minus; cbn [source target vx vy]; ring).
  unfold fraction. rewrite top, bottom. reflexivity.
Qed.

Lemma edge_of_placed (x : vector) (q : region) (f' : segment) : In f' (region_edges (placed x q)) ->
  exists f, In f (region_edges q) /\ f' = reflected x f.
Proof. rewrite edges_of_placed. intros I. apply in_map_iff in I. destruct I as (f & <- & I). now exists f. Qed.

(* All of it reflected. *)
Lemma part_shows_reflected (x : vector) (p q : region) (f' : segment) (c d : vector) :
  part_shows (placed x q) p f' c d ->
  exists f, part_shows q (placed x p) f (minus x c) (minus x d).
Proof.
  intros (F & c_is & d_is & on_c & on_d & order & none & shows).
  destruct (edge_of_placed x q f' F) as (f & I & ->). exists f.
  assert (either : forall v, vertex_of_either v (placed x q) p <-> vertex_of_either (minus x v) q (placed x p)).
  { intros v. unfold vertex_of_either. rewrite !vertex_of_placed_iff.
    split; (intros [of_q | of_p]; [now left | right]).
    - refine (equal_vertex _ _ p _ of_p). symmetry. apply minus_twice.
    - refine (equal_vertex _ _ p _ of_p). apply minus_twice. }
  rewrite fraction_of_reflected, fraction_of_reflected in order. apply either in c_is, d_is.
  apply on_reflected in on_c, on_d. repeat split; trivial.
  - intros v vertex on [after before]. apply (none (minus x v)).
    + apply either. destruct vertex as [of_q | of_p]; [left | right].
      * refine (equal_vertex _ _ q _ of_q). symmetry. apply minus_twice.
      * refine (equal_vertex _ _ _ _ of_p). symmetry. apply minus_twice.
    + apply on_reflected. refine (lies_on_equal _ _ _ _ on). symmetry. apply minus_twice.
    + unfold comes_between. rewrite !fraction_of_reflected, (fraction_of_equal f _ _ (minus_twice x v)). now
      split.
  - assert (middle_is : equal_vectors (minus x (midpoint (minus x c) (minus x d))) (midpoint c d))
      by (unfold midpoint, middle, minus; cbn [source target vx vy]; split; cbn [vx vy]; field).
    destruct shows as [inside_p | (e & E & on & parallel & same_way)]; [left | right].
    + apply inside_placed. refine (inside_equal _ _ _ _ inside_p). now symmetry.
    + exists (reflected x e). rewrite edges_of_placed. split; [now apply in_map |].
      split; [apply on_reflected; refine (lies_on_equal _ _ _ _ on); now symmetry |].
      unfold cross, dot, along, reflected, minus in *; cbn [source target vx vy] in *. split; lra.
Qed.

(* Contacts stay on the way. *)
Record contacts_stay (p q : region) (way : segment) : Prop := {
  vertices_of_p_stay : forall y z s f, lies_on y way -> lies_on z way -> In s (region_edges p) ->
    In f (region_edges q) -> lies_on (minus y (source s)) f -> lies_on (minus z (source s)) f;
  vertices_of_q_stay : forall y z e t, lies_on y way -> lies_on z way -> In e (region_edges p) ->
    In t (region_edges q) -> lies_on (minus y (source t)) e -> lies_on (minus z (source t)) e;
  no_vertices_meet : forall y s t, lies_on y way -> In s (region_edges p) -> In t (region_edges q) ->
    ~ equal_vectors y (plus (source s) (source t)) }.

Lemma contacts_stay_other_way (p q : region) (way : segment) : contacts_stay p q way -> contacts_stay q p way.
Proof.
  intros [of_p of_q none]. split.
  - intros y z s f Y Z S F. now apply of_q.
  - intros y z e t Y Z E T. now apply of_p.
  - intros y s t Y S T [X' Y']. apply (none y t s Y T S). unfold plus in *; cbn [vx vy] in *. split; cbn [vx vy]; lra.
Qed.

Lemma long_reflected (x : vector) (e f : segment) :
  cross (along e) (along (reflected x f)) == - cross (along e) (along f) /\
  dot (along e) (along (reflected x f)) == - dot (along e) (along f).
Proof. unfold cross, dot, along, reflected, minus; cbn [source target vx vy]. split; ring. Qed.

Lemma common_part (s : segment) (v w y : vector) : lies_on v s -> lies_on w s -> lies_on y (Segment v w) -> lies_on y s.
Proof.
  intros (k & k_range & kx & ky) (l & l_range & lx & ly) (t & t_range & tx & ty). cbn [source target] in *.
  exists ((1 - t) * k + t * l). split; [| rewrite tx, ty, kx, ky, lx, ly; split; ring].
  assert (0 <= (1 - t) * k) by (apply Qmult_le_0_compat; lra). assert (0 <= t * l) by (apply Qmult_le_0_compat; lra).
  assert (0 <= (1 - t) * (1 - k)) by (apply Qmult_le_0_compat; lra).
  assert (0 <= t * (1 - l)) by (apply Qmult_le_0_compat; lra). lra.
Qed.

Section OnTheWay.
  Variables p q : region.
  Variable way : segment.
  Hypothesis p_region : valid_region p.
  Hypothesis q_region : valid_region q.
  Hypothesis stay : contacts_stay p q way.

  Let p_edges : no_edges_are_points p := proj1 p_region.
  Let q_edges : no_edges_are_points q := proj1 q_region.

  Lemma ends_stay (y z : vector) (e f : segment) : lies_on y way -> lies_on z way -> In e (region_edges p) ->
    In f (region_edges q) -> not_sum_of_an_end y e f -> not_sum_of_an_end z e f.
  Proof.
    intros Y Z E F (not_1 & not_2 & not_3 & not_4).
    destruct (target_is_vertex p e E) as (e' & E' & ex & ey). destruct (target_is_vertex q f F) as (f' & F' & fx & fy).
    assert (same_e : forall x, equal_vectors (minus x (target e)) (minus x (source e')))
      by (intros x; unfold minus; split; cbn [vx vy]; lra).
    assert (same_f : forall x, equal_vectors (minus x (target f)) (minus x (source f')))
      by (intros x; unfold minus; split; cbn [vx vy]; lra).
    assert (back : forall a b : vector, equal_vectors a b -> equal_vectors b a) by (intros a b equal; now symmetry).
    repeat split; intros on.
    - apply not_1. now apply (vertices_of_p_stay _ _ _ stay z y e f).
    - apply not_2. apply (lies_on_equal _ _ _ (back _ _ (same_e y))), (vertices_of_p_stay _ _ _ stay z y e' f); trivial.
      now apply (lies_on_equal _ _ _ (same_e z)).
    - apply not_3. now apply (vertices_of_q_stay _ _ _ stay z y e f).
    - apply not_4. apply (lies_on_equal _ _ _ (back _ _ (same_f y))), (vertices_of_q_stay _ _ _ stay z y e f'); trivial.
      now apply (lies_on_equal _ _ _ (same_f z)).
  Qed.

  (* Edges that cross keep crossing. *)
  Lemma crossing_stays (y z : vector) : lies_on y way -> lies_on z way ->
    boundaries_cross p (placed y q) -> interiors_meet z p q.
  Proof.
    intros Y Z (e & f' & w & E & F' & on_e & on_f & not_p & not_q & turn).
    destruct (edge_of_placed y q f' F') as (f & F & ->). clear F'.
    assert (turn' : ~ cross (along e) (along f) == 0) by (destruct (long_reflected y e f) as [equal _]; lra).
    assert (general : not_sum_of_an_end y e f).
    { assert (vertex_of_p : forall v, is_vertex v p -> lies_on v e -> ~ lies_on (minus y v) f).
      { intros v vertex on_v on. apply not_p. apply (equal_vertex v); [| exact vertex].
        apply (lines_meet_once e (reflected y f) w); trivial. now apply on_reflected. }
      assert (vertex_of_q : forall v, is_vertex v q -> lies_on v f -> ~ lies_on (minus y v) e).
      { intros v vertex on_v on. apply not_q. apply vertex_of_placed_iff. apply (equal_vertex v); [| exact vertex].
        destruct (lines_meet_once e (reflected y f) w (minus y v) turn) as [vx_is vy_is]; trivial.
        - apply on_reflected. refine (lies_on_equal _ _ _ _ on_v). symmetry. apply minus_twice.
        - unfold minus in *; cbn [vx vy] in *. split; cbn [vx vy]; lra. }
      assert (itself : forall r s, In s (region_edges r) -> is_vertex (source s) r)
        by (intros r s S; exists s; split; [exact S | split; reflexivity]).
      repeat split; [apply vertex_of_p | apply vertex_of_p | apply vertex_of_q | apply vertex_of_q];
        try apply source_lies_on; try apply target_lies_on; try (now apply itself); now apply target_is_vertex. }
    assert (is_sum : is_sum_of_points y e f).
    { exists w, (minus y w). split; [exact on_e |]. split; [now apply on_reflected |].
      unfold plus, minus. split; cbn [vx vy]; ring. }
    pose proof (region_edges_are_directions p p_edges e E) as long_e.
    pose proof (region_edges_are_directions q q_edges f F) as long_f.
    assert (same_number : winding_number y (parallelogram e f) = winding_number z (parallelogram e f)).
    { apply (winding_number_along (Segment y z) _ (closed_chain_cycles _)). intros v on.
      apply off_parallelogram, (ends_stay y v e f); trivial. now apply (common_part way y z). }
    assert (round : winding_number z (parallelogram e f) <> 0%Z).
    { rewrite <- same_number. destruct (crossing_edges_count y e f long_e long_f is_sum general); lia. }
    destruct (parallelogram_winding_number z e f) as [none | [_ (w' & u' & on_e' & on_f' & sum_x & sum_y)]];
      [contradiction |].
    assert (u_is : equal_vectors u' (minus z w')).
    { unfold plus, minus in *; cbn [vx vy] in *. split; cbn [vx vy]; lra. }
    apply meet_inside_placed, (edges_that_cross_show p (placed z q) p_region (placed_is_valid z q q_region)).
    exists e, (reflected z f), w'. rewrite edges_of_placed.
    split; [exact E |]. split; [now apply in_map |]. split; [exact on_e' |].
    split; [apply on_reflected; now apply (lies_on_equal u') |]. split; [| split].
    - intros (s & S & equal). apply not_p. exists s. split; [exact S |]. symmetry.
      apply (lines_meet_once e (reflected y f) w); trivial.
      + now apply (lies_on_equal w').
      + apply on_reflected, (vertices_of_p_stay _ _ _ stay z y s f); trivial. refine (lies_on_equal _ _ _ _ on_f').
        destruct u_is, equal. unfold minus in *; cbn [vx vy] in *. split; cbn [vx vy]; lra.
    - rewrite vertex_of_placed_iff. intros (s & S & equal). apply not_q. apply vertex_of_placed_iff. exists s.
      split; [exact S |].
      destruct (lines_meet_once e (reflected y f) w (minus y (source s)) turn) as [s_x s_y]; trivial.
      + apply (vertices_of_q_stay _ _ _ stay z y e s); trivial. refine (lies_on_equal _ _ _ _ on_e').
        destruct equal. unfold minus in *; cbn [vx vy] in *. split; cbn [vx vy]; lra.
      + apply on_reflected. refine (lies_on_equal _ _ _ _ on_f'). destruct u_is, equal. unfold minus in *; cbn [vx vy]
        in *.
        split; cbn [vx vy]; lra.
      + unfold minus in *; cbn [vx vy] in *. split; cbn [vx vy]; lra.
    - destruct (long_reflected z e f) as [equal _]. lra.
  Qed.
  (* A vertex of P, or one of -Q + x, by an edge that starts there. *)
  Definition marker_at (x : vector) (m : segment + segment) : vector :=
    match m with inl s => source s | inr t => minus x (source t) end.

  Definition listed (m : segment + segment) : Prop :=
    match m with inl s => In s (region_edges p) | inr t => In t (region_edges q) end.

  Lemma marker_of_vertex (x v : vector) : vertex_of_either v p (placed x q) ->
    exists m, listed m /\ equal_vectors v (marker_at x m).
  Proof.
    intros [(s & S & equal) | of_q]; [now exists (inl s) |]. apply vertex_of_placed_iff in of_q.
    destruct of_q as (t & T & X & Y). exists (inr t). split; [exact T |]. unfold marker_at, minus in *; cbn [vx vy] in
      *.
    split; cbn [vx vy]; lra.
  Qed.

  Lemma vertex_of_marker (x : vector) (m : segment + segment) : listed m ->
    vertex_of_either (marker_at x m) p (placed x q).
  Proof.
    destruct m as [s | t]; intros I; [left | right].
    - exists s. split; [exact I | split; reflexivity].
    - apply vertex_of_placed_iff. exists t. split; [exact I |]. apply minus_twice.
  Qed.

  Lemma markers_stay_on_p (y z : vector) (e : segment) (m : segment + segment) : lies_on y way -> lies_on z way ->
    In e (region_edges p) -> listed m -> lies_on (marker_at y m) e -> lies_on (marker_at z m) e.
  Proof. intros Y Z E. destruct m as [s | t]; cbn; [trivial |]. now apply (vertices_of_q_stay _ _ _ stay). Qed.

  Lemma markers_stay_on_q (y z : vector) (f : segment) (m : segment + segment) : lies_on y way -> lies_on z way ->
    In f (region_edges q) -> listed m -> lies_on (minus y (marker_at y m)) f -> lies_on (minus z (marker_at z m)) f.
  Proof.
    intros Y Z F. destruct m as [s | t]; cbn [listed marker_at]; [intros S; now apply (vertices_of_p_stay _ _ _ stay y
      z s f) |].
    intros _ on. apply (lies_on_equal (source t)); [symmetry; apply minus_twice |].
    refine (lies_on_equal _ _ _ _ on). apply minus_twice.
  Qed.

  Definition part_of_the_way (y z : vector) (t : Q) : vector :=
    Vector ((1 - t) * vx y + t * vx z) ((1 - t) * vy y + t * vy z).

  Lemma part_of_the_way_is_on (y z : vector) (t : Q) : lies_on y way -> lies_on z way -> 0 <= t <= 1 ->
    lies_on (part_of_the_way y z t) way.
  Proof.
    intros Y Z range. apply (common_part way y z); trivial. exists t. split; [exact range |]. split; reflexivity.
  Qed.

  Lemma marker_moves (y z : vector) (t : Q) (m : segment + segment) :
    vx (marker_at (part_of_the_way y z t) m) == (1 - t) * vx (marker_at y m) + t * vx (marker_at z m) /\
    vy (marker_at (part_of_the_way y z t) m) == (1 - t) * vy (marker_at y m) + t * vy (marker_at z m).
  Proof. destruct m as [s | s]; unfold marker_at, part_of_the_way, minus; cbn [vx vy]; split; ring. Qed.

  Lemma fraction_moves (e : segment) (y z : vector) (t : Q) (m : segment + segment) :
    fraction e (marker_at (part_of_the_way y z t) m) ==
    (1 - t) * fraction e (marker_at y m) + t * fraction e (marker_at z m).
  Proof.
    destruct (marker_moves y z t m) as [X Y]. unfold fraction, Qdiv.
    assert (top : dot (minus (marker_at (part_of_the_way y z t) m) (source e)) (along e) ==
      (1 - t) * dot (minus (marker_at y m) (source e)) (along e) + t * dot (minus (marker_at z m) (source e)) (along e))
      by (unfold dot, minus; cbn [vx vy]; rewrite X, Y; ring).
    rewrite top. ring.
  Qed.

  (* Vertices on an edge of P keep their order. *)
  Lemma markers_keep_their_order (y z : vector) (e : segment) (m n : segment + segment) :
    lies_on y way -> lies_on z way -> In e (region_edges p) -> listed m -> listed n ->
    lies_on (marker_at y m) e -> lies_on (marker_at y n) e ->
    fraction e (marker_at y m) < fraction e (marker_at y n) -> fraction e (marker_at z m) < fraction e (marker_at z n).
  Proof.
    intros Y Z E M N on_m on_n order. apply Qnot_le_lt. intros turned.
    pose proof (region_edges_are_directions p p_edges e E) as long.
    set (before := fraction e (marker_at y n) - fraction e (marker_at y m)).
    set (after := fraction e (marker_at z n) - fraction e (marker_at z m)).
    assert (before_some : 0 < before) by (unfold before; lra). assert (after_none : after <= 0) by (unfold after; lra).
    set (t := before / (before - after)).
    assert (t_is : t * (before - after) == before) by (unfold t; field; lra).
    assert (range : 0 <= t <= 1) by (unfold t; split; [apply Qle_shift_div_l; lra | apply Qle_shift_div_r; lra]).
    clearbody t. pose proof (part_of_the_way_is_on y z t Y Z range) as here. set (v := part_of_the_way y z t) in *.
    assert (equal : equal_vectors (marker_at v m) (marker_at v n)).
    { apply (same_fraction e); [exact long | now apply (markers_stay_on_p y v) .. |].
      unfold v. rewrite !fraction_moves. unfold before, after in *. lra. }
    assert (not_at_y : ~ equal_vectors (marker_at y m) (marker_at y n))
      by (intros same_; pose proof (fraction_of_equal e _ _ same_); lra).
    destruct equal as [X' Y']. destruct m as [s | s], n as [u | u]; cbn [marker_at listed] in *.
    - apply not_at_y. now split.
    - apply (no_vertices_meet _ _ _ stay v s u here M N). unfold plus, minus in *; cbn [vx vy] in *.
      split; cbn [vx vy]; lra.
    - apply (no_vertices_meet _ _ _ stay v u s here N M). unfold plus, minus in *; cbn [vx vy] in *.
      split; cbn [vx vy]; lra.
    - apply not_at_y. unfold minus in *; cbn [vx vy] in *. split; cbn [vx vy]; lra.
  Qed.

  Lemma none_comes_between (y z : vector) (e : segment) (m n : segment + segment) :
    lies_on y way -> lies_on z way -> In e (region_edges p) -> listed m -> listed n ->
    lies_on (marker_at y m) e -> lies_on (marker_at y n) e ->
    no_vertex_between p (placed y q) e (marker_at y m) (marker_at y n) ->
    no_vertex_between p (placed z q) e (marker_at z m) (marker_at z n).
  Proof.
    intros Y Z E M N on_m on_n none v vertex on [after before].
    destruct (marker_of_vertex z v vertex) as (k & K & equal).
    pose proof (lies_on_equal _ _ _ equal on) as on_k. rewrite (fraction_of_equal e v _ equal) in after, before.
    assert (on_y : lies_on (marker_at y k) e) by now apply (markers_stay_on_p z y).
    apply (none (marker_at y k)); [now apply vertex_of_marker | exact on_y |].
    split; apply (markers_keep_their_order z y); trivial; now apply (markers_stay_on_p y z).
  Qed.

  Hypothesis p_simple : nowhere_above_one p.
  Hypothesis q_simple : nowhere_above_one q.

  Lemma midpoint_between (e : segment) (c d : vector) : nonzero (along e) -> lies_on c e -> lies_on d e ->
    fraction e c < fraction e d -> lies_on (midpoint c d) e /\ comes_between e c d (midpoint c d).
  Proof.
    intros long on_c on_d order. destruct (ahead_by_fractions e d c long on_d on_c) as [X Y].
    set (step := fraction e d - fraction e c) in *.
    assert (mid_x : vx (midpoint c d) == vx c + (1 # 2) * step * vx (along e))
      by (unfold midpoint, middle; cbn [source target vx]; rewrite X; field).
    assert (mid_y : vy (midpoint c d) == vy c + (1 # 2) * step * vy (along e))
      by (unfold midpoint, middle; cbn [source target vy]; rewrite Y; field).
    pose proof (fraction_ahead e _ c _ long mid_x mid_y) as at_. unfold step in at_.
    split; [| split; rewrite at_; lra].
    apply (common_part e c d); trivial. exists (1 # 2). split; [lra |]. cbn [source target].
    unfold midpoint, middle; cbn [source target vx vy]. split; field.
  Qed.

  (* A part of an edge that shows that the interiors meet still shows it. *)
  Lemma part_stays (y z : vector) (e : segment) (c d : vector) : lies_on y way -> lies_on z way ->
    part_shows p (placed y q) e c d -> interiors_meet z p q.
  Proof.
    intros Y Z (E & c_is & d_is & on_c & on_d & order & none & shows).
    destruct (collide p (placed z q)) eqn:met;
      [now apply (collide_decides_whether_interiors_meet p q z p_region q_region p_simple q_simple) |].
    assert (not_met : ~ interiors_meet z p q).
    { rewrite <- (collide_decides_whether_interiors_meet p q z p_region q_region p_simple q_simple). congruence. }
    clear met.
    destruct (marker_of_vertex y c c_is) as (m & M & c_equal). destruct (marker_of_vertex y d d_is) as (n & N &
      d_equal).
    pose proof (region_edges_are_directions p p_edges e E) as long.
    pose proof (lies_on_equal _ _ _ c_equal on_c) as on_m. pose proof (lies_on_equal _ _ _ d_equal on_d) as on_n.
    rewrite (fraction_of_equal e _ _ c_equal), (fraction_of_equal e _ _ d_equal) in order.
    assert (none_y : no_vertex_between p (placed y q) e (marker_at y m) (marker_at y n)).
    { intros v vertex on [after before]. apply (none v vertex on). split.
      - now rewrite (fraction_of_equal e _ _ c_equal).
      - now rewrite (fraction_of_equal e _ _ d_equal). }
    assert (mid_equal : equal_vectors (midpoint c d) (midpoint (marker_at y m) (marker_at y n))).
    { destruct c_equal as [cx cy], d_equal as [dx dy]. unfold midpoint, middle; cbn [source target].
      split; cbn [vx vy]; [rewrite cx, dx | rewrite cy, dy]; reflexivity. }
    set (mid := fun x => midpoint (marker_at x m) (marker_at x n)).
    assert (facts : forall v, lies_on v way -> lies_on (marker_at v m) e /\ lies_on (marker_at v n) e /\
      lies_on (mid v) e /\ comes_between e (marker_at v m) (marker_at v n) (mid v) /\
      no_vertex_between p (placed v q) e (marker_at v m) (marker_at v n)).
    { intros v V. assert (on_m_v : lies_on (marker_at v m) e) by now apply (markers_stay_on_p y v).
      assert (on_n_v : lies_on (marker_at v n) e) by now apply (markers_stay_on_p y v).
      destruct (midpoint_between e _ _ long on_m_v on_n_v) as [on_mid between_];
        [now apply (markers_keep_their_order y v) |].
      repeat split; trivial; try apply between_. now apply (none_comes_between y v). }
    assert (parallel_runs : forall v x f, lies_on v way -> lies_on x way -> In f (region_edges q) ->
      cross (along e) (along f) == 0 -> lies_on (mid v) (reflected v f) -> lies_on (mid x) (reflected x f)).
    { intros v x f V X F parallel on. destruct (facts v V) as (m_v & n_v & mid_v & between_v & none_v).
      assert (parallel_ : cross (along e) (along (reflected v f)) == 0) by (destruct (long_reflected v e f); lra).
      assert (F' : In (reflected v f) (region_edges (placed v q))) by (rewrite edges_of_placed; now apply in_map).
      pose proof (proj1 (placed_is_valid v q q_region)) as placed_edges. destruct between_v as [after before].
      assert (both : lies_on (marker_at x m) (reflected x f) /\ lies_on (marker_at x n) (reflected x f)).
      { split; apply on_reflected, (markers_stay_on_q v x); trivial; apply on_reflected;
          apply (runs_along_the_part p (placed v q) e (reflected v f) (marker_at v m) (marker_at v n) (mid v)); trivial;
          try (split; assumption); lra. }
      destruct both as [m_x n_x]. apply (common_part _ _ _ _ m_x n_x). exists (1 # 2). split; [lra |].
      unfold mid, midpoint, middle; cbn [source target vx vy]. split; field. }
    assert (no_vertex : forall v, lies_on v way -> ~ is_vertex (mid v) p /\ ~ is_vertex (mid v) (placed v q)).
    { intros v V. destruct (facts v V) as (_ & _ & mid_v & between_v & none_v).
      split; intros vertex; apply (none_v (mid v)); trivial; [now left | now right]. }
    destruct shows as [inside_ | (f' & F' & on_f & parallel & same_way)].
    - (* it stays inside *)
      apply inside_placed in inside_. destruct inside_ as [free round].
      assert (off_all : forall v, lies_on v way -> off (minus v (mid v)) (region_edges q)).
      { intros v V f F on. apply on_reflected in on.
        destruct (Qeq_dec (cross (along e) (along f)) 0) as [parallel | turn].
        - apply (free f F). apply (lies_on_equal (minus y (mid y))).
          + destruct mid_equal as [X' Y']. unfold mid, minus; split; cbn [vx vy]; lra.
          + apply on_reflected. now apply (parallel_runs v y f).
        - apply not_met. apply (crossing_stays v z V Z). destruct (facts v V) as (_ & _ & mid_v & _).
          destruct (no_vertex v V) as [not_p not_q]. exists e, (reflected v f), (mid v).
          rewrite edges_of_placed. repeat split; trivial; [now apply in_map |].
          destruct (long_reflected v e f). lra. }
      assert (same_number : winding_number (minus y (mid y)) (region_edges q) =
        winding_number (minus z (mid z)) (region_edges q)).
      { apply (winding_number_along (Segment (minus y (mid y)) (minus z (mid z))) _ (region_cycles q)).
        intros w (t & range & wx & wy). cbn [source target] in wx, wy.
        pose proof (part_of_the_way_is_on y z t Y Z range) as V. apply (off_equal _ _ _) with (2 := off_all _ V).
        destruct (marker_moves y z t m) as [mx my], (marker_moves y z t n) as [nx ny].
        unfold mid, midpoint, middle, minus in *; cbn [source target vx vy] in *.
        split; cbn [vx vy]; [rewrite wx, mx, nx | rewrite wy, my, ny]; unfold part_of_the_way; cbn [vx vy]; field. }
      apply interiors_meet_other_way.
      apply (inner_point_and_point q p z (minus z (mid z)) (mid z)).
      + destruct p_region as (p_edges_ & p_valid & p_meet). now apply regions_are_regular.
      + split; [now apply off_all |]. rewrite <- same_number.
        destruct mid_equal as [X' Y'].
        rewrite <- (winding_number_of_equal (minus y (midpoint c d)) (minus y (mid y)));
          [exact round | unfold mid, minus; cbn [vx vy]; lra ..].
      + right. exists e. split; [exact E |]. now destruct (facts z Z) as (_ & _ & mid_z & _).
      + unfold plus, minus. split; cbn [vx vy]; ring.
    - (* it stays on the same edge *)
      destruct (edge_of_placed y q f' F') as (f & F & ->). destruct (long_reflected y e f) as [cross_is dot_is].
      assert (on_z : lies_on (mid z) (reflected z f)).
      { apply (parallel_runs y z f); trivial; [lra |]. now apply (lies_on_equal (midpoint c d)). }
      destruct (facts z Z) as (_ & _ & mid_z & _), (no_vertex z Z) as [not_p not_q].
      destruct (long_reflected z e f) as [cross_z dot_z]. pose proof (square_positive _ long) as square.
      apply meet_inside_placed.
      apply (left_of_both p (placed z q) e (reflected z f) (mid z) (Vector (- vy (along e)) (vx (along e)))); trivial.
      + now apply placed_is_valid.
      + rewrite edges_of_placed. now apply in_map.
      + unfold cross, dot in *; cbn [vx vy]. lra.
      + set (F_ := along (reflected z f)) in *. unfold cross, dot in *; cbn [vx vy]. lra.
  Qed.
End OnTheWay.

(* Theorem. While contacts stay, the interiors meet all along the way or nowhere. *)
Theorem meeting_stays (p q : region) (way : segment) (y z : vector) :
  valid_region p -> valid_region q -> nowhere_above_one p -> nowhere_above_one q -> contacts_stay p q way ->
  lies_on y way -> lies_on z way -> interiors_meet y p q -> interiors_meet z p q.
Proof.
  intros p_region q_region p_simple q_simple stay Y Z meet.
  destruct (what_shows p (placed y q)) as [crossing_ | [(e & c & d & part) | (f & c & d & part)]]; trivial.
  - now apply placed_is_valid.
  - now apply placed_is_at_most_one.
  - now apply meet_inside_placed.
  - now apply (crossing_stays p q way p_region q_region stay y z).
  - now apply (part_stays p q way p_region q_region stay p_simple q_simple y z e c d).
  - destruct (part_shows_reflected y p q f c d part) as (f' & part').
    apply interiors_meet_other_way.
    apply (part_stays q p way q_region p_region (contacts_stay_other_way p q way stay) q_simple p_simple y z
      f' (minus y c) (minus y d)); trivial.
Qed.
