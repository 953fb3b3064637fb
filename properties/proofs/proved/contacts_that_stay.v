(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* x is moved along a segment. If no vertex of P comes to an edge of -Q + x on the way or leaves one, nor a vertex of
   -Q + x an edge of P, and no vertices meet, then the interiors of P and -Q + x meet all along the way, or nowhere.
   What shows that they meet (contacts.v) is still there after the move: the parallelogram of two edges that cross
   still goes round x (crossing_edges.v), and vertices on an edge keep their order, so that the part between two of
   them is met by other edges where it was met before. *)
From Coq Require Import QArith Lqa Qfield ZArith Lia Bool List.
From Oplus Require Import regions_and_sums reflected parallelogram crossing_edges right_of_an_edge boundary_points
  rotation pieces naive_collision met_pieces collision_is_sound collision_is_complete placed_collision coordinates
  contacts.
Import ListNotations.

Open Scope Q_scope.

Lemma minus_twice (x w : vector) : equal_vectors (minus x (minus x w)) w.
Proof. by_computing. Qed.

Lemma vertex_of_placed_iff (x w : vector) (q : region) : is_vertex w (placed x q) <-> is_vertex (minus x w) q.
Proof.
  split; [| apply vertex_of_placed]. intros (u & U & equal). rewrite edges_of_placed in U. apply in_map_iff in U.
  destruct U as (t & <- & T). exists t. split; [exact T | by_computing].
Qed.

Lemma meet_inside_placed (x : vector) (p q : region) : meet_inside p (placed x q) <-> interiors_meet x p q.
Proof.
  unfold meet_inside, interiors_meet. split; intros (z & in_p & in_q); exists z; (split; [exact in_p |]);
    now apply inside_placed.
Qed.

Lemma edge_of_placed (x : vector) (q : region) (f' : segment) : In f' (region_edges (placed x q)) ->
  exists f, In f (region_edges q) /\ f' = reflected x f.
Proof. rewrite edges_of_placed. intros I. apply in_map_iff in I. destruct I as (f & <- & I). now exists f. Qed.

Lemma runs_inside_reflected (x : vector) (r : region) (s e : segment) : runs_inside r s e ->
  runs_inside (placed x r) (reflected x s) (reflected x e).
Proof.
  intros (E & (c & along_x & along_y) & free). split; [rewrite edges_of_placed; now apply in_map |].
  split; [exists c; to_coordinates; split; lra |]. intros w (k & range & X & Y).
  rewrite on_reflected, vertex_of_placed_iff. apply free. exists k. split; [exact range | by_computing].
Qed.

Lemma vertex_of_either_reflected (x v : vector) (p q : region) :
  vertex_of_either v (placed x q) p <-> vertex_of_either (minus x v) q (placed x p).
Proof.
  unfold vertex_of_either. rewrite !vertex_of_placed_iff.
  pose proof (vertex_of_equal _ _ p (minus_twice x v)).
  pose proof (vertex_of_equal _ _ p (symmetry (minus_twice x v))). tauto.
Qed.

(* All of it reflected. *)
Lemma part_shows_reflected (x : vector) (p q : region) (f' : segment) (c d : vector) :
  part_shows (placed x q) p f' c d -> exists f, part_shows q (placed x p) f (minus x c) (minus x d).
Proof.
  intros (F & c_is & d_is & on_c & on_d & ahead & none & shows).
  destruct (edge_of_placed x q f' F) as (f & I & ->). exists f.
  apply vertex_of_either_reflected in c_is, d_is. apply on_reflected in on_c, on_d. repeat split; trivial.
  - unfold comes_later in *. by_computing.
  - intros v vertex (k & range & X & Y). apply (none (minus x v)).
    + apply vertex_of_either_reflected.
      destruct vertex; [left | right]; now apply (vertex_of_equal v); [by_computing |].
    + exists k. split; [exact range | by_computing].
  - assert (middle_is : equal_vectors (minus x (middle (Segment (minus x c) (minus x d)))) (middle (Segment c d)))
      by by_computing.
    destruct shows as [inside_p | (e & E & on & parallel & same_way)]; [left | right].
    + apply inside_placed. now apply (inside_equal (middle (Segment c d))).
    + exists (reflected x e). rewrite edges_of_placed. split; [now apply in_map |].
      split; [apply on_reflected; now apply (lies_on_equal (middle (Segment c d))) | by_computing].
Qed.

(* Contacts stay on the way. *)
Record contacts_stay (p q : region) (way : segment) : Prop := {
  vertices_of_p_stay : forall y z v f, lies_on y way -> lies_on z way -> is_vertex v p ->
    In f (region_edges q) -> lies_on (minus y v) f -> lies_on (minus z v) f;
  vertices_of_q_stay : forall y z e u, lies_on y way -> lies_on z way -> In e (region_edges p) ->
    is_vertex u q -> lies_on (minus y u) e -> lies_on (minus z u) e;
  no_vertices_meet : forall y v u, lies_on y way -> is_vertex v p -> is_vertex u q -> ~ equal_vectors y (plus v u) }.

Lemma contacts_stay_other_way (p q : region) (way : segment) : contacts_stay p q way -> contacts_stay q p way.
Proof.
  intros [of_p of_q none]. split; [intros y z v f Y Z S F; now apply of_q | intros y z e u Y Z E U; now apply of_p |].
  intros y v u Y V U equal. apply (none y u v Y U V). by_computing.
Qed.

Lemma long_reflected (x : vector) (e f : segment) :
  cross (along e) (along (reflected x f)) == - cross (along e) (along f) /\
  dot (along e) (along (reflected x f)) == - dot (along e) (along f).
Proof. by_computing. Qed.

Section OnTheWay.
  Variables p q : region.
  Variable way : segment.
  Hypotheses (p_region : valid_region p) (q_region : valid_region q).
  Hypothesis stay : contacts_stay p q way.

  Let p_edges : no_edges_are_points p := proj1 p_region.
  Let q_edges : no_edges_are_points q := proj1 q_region.

  Lemma ends_stay (y z : vector) (e f : segment) : lies_on y way -> lies_on z way -> In e (region_edges p) ->
    In f (region_edges q) -> not_sum_of_an_end y e f -> not_sum_of_an_end z e f.
  Proof.
    intros Y Z E F (not_1 & not_2 & not_3 & not_4). repeat split; intros on;
      [apply not_1 | apply not_2 | apply not_3 | apply not_4];
      [apply (vertices_of_p_stay _ _ _ stay z) | apply (vertices_of_p_stay _ _ _ stay z) |
       apply (vertices_of_q_stay _ _ _ stay z) | apply (vertices_of_q_stay _ _ _ stay z)];
      auto using source_is_vertex, target_is_vertex.
  Qed.

  (* Edges that cross keep crossing. *)
  Lemma crossing_stays (y z : vector) : lies_on y way -> lies_on z way ->
    boundaries_cross p (placed y q) -> interiors_meet z p q.
  Proof.
    intros Y Z (e & f' & w & E & F' & on_e & on_f & not_p & not_q & turn).
    destruct (edge_of_placed y q f' F') as (f & F & ->). clear F'. rewrite vertex_of_placed_iff in not_q.
    assert (turn' : ~ cross (along e) (along f) == 0) by (destruct (long_reflected y e f) as [equal _]; lra).
    assert (once : forall v, lies_on v e -> lies_on (minus y v) f -> equal_vectors v w).
    { intros v on on'. apply (lines_meet_once e (reflected y f) w); trivial. now apply on_reflected. }
    assert (vertex_of_p : forall v, is_vertex v p -> lies_on v e -> ~ lies_on (minus y v) f)
      by (intros v vertex on on'; apply not_p; now apply (vertex_of_equal v), vertex; apply once).
    assert (vertex_of_q : forall u, is_vertex u q -> lies_on u f -> ~ lies_on (minus y u) e).
    { intros u vertex on on'. apply not_q. apply (vertex_of_equal u); [| exact vertex].
      assert (equal : equal_vectors (minus y u) w); [| by_computing].
      apply once; [exact on' | apply (lies_on_equal u); [by_computing | exact on]]. }
    assert (general : not_sum_of_an_end y e f).
    { repeat split; [apply vertex_of_p | apply vertex_of_p | apply vertex_of_q | apply vertex_of_q];
        auto using source_is_vertex, target_is_vertex, source_lies_on, target_lies_on. }
    assert (is_sum : is_sum_of_points y e f).
    { exists w, (minus y w). split; [exact on_e |]. split; [now apply on_reflected | by_computing]. }
    assert (same_number : winding_number y (parallelogram e f) = winding_number z (parallelogram e f)).
    { apply (winding_number_along (Segment y z) _ (closed_chain_cycles _)). intros v on.
      apply off_parallelogram, (ends_stay y v e f); trivial. now apply (common_part way y z). }
    assert (round : winding_number z (parallelogram e f) <> 0%Z).
    { rewrite <- same_number. destruct (crossing_edges_count y e f); trivial; try lia;
        [now apply (region_edges_are_directions p) | now apply (region_edges_are_directions q)]. }
    destruct (parallelogram_winding_number z e f) as [none | [_ (v & u & on_v & on_u & equal)]]; [contradiction |].
    apply meet_inside_placed, (edges_that_cross_show p (placed z q) p_region (placed_is_valid z q q_region)).
    exists e, (reflected z f), v. rewrite edges_of_placed, vertex_of_placed_iff.
    assert (on_minus : lies_on (minus z v) f) by (apply (lies_on_equal u); [by_computing | exact on_u]).
    repeat split; trivial; [now apply in_map | now apply on_reflected | | |].
    - intros vertex. apply (vertex_of_p v vertex on_v). now apply (vertices_of_p_stay _ _ _ stay z y).
    - intros vertex. apply (vertex_of_q _ vertex on_minus), (vertices_of_q_stay _ _ _ stay z y); trivial.
      apply (lies_on_equal v); [by_computing | exact on_v].
    - destruct (long_reflected z e f). lra.
  Qed.

  (* A vertex of P, or one of -Q + x, which moves with x. *)
  Definition marker_at (x : vector) (m : vector + vector) : vector :=
    match m with inl v => v | inr u => minus x u end.

  Definition listed (m : vector + vector) : Prop := match m with inl v => is_vertex v p | inr u => is_vertex u q end.

  Lemma marker_of_vertex (x v : vector) : vertex_of_either v p (placed x q) ->
    exists m, listed m /\ equal_vectors v (marker_at x m).
  Proof.
    intros [of_p | of_q]; [now exists (inl v) |]. apply vertex_of_placed_iff in of_q. exists (inr (minus x v)).
    split; [exact of_q | symmetry; apply minus_twice].
  Qed.

  Lemma vertex_of_marker (x : vector) (m : vector + vector) : listed m ->
    vertex_of_either (marker_at x m) p (placed x q).
  Proof.
    destruct m as [v | u]; intros I; [now left | right]. apply vertex_of_placed_iff.
    apply (vertex_of_equal u); [symmetry; apply minus_twice | exact I].
  Qed.

  Lemma markers_stay_on_p (y z : vector) (e : segment) (m : vector + vector) : lies_on y way -> lies_on z way ->
    In e (region_edges p) -> listed m -> lies_on (marker_at y m) e -> lies_on (marker_at z m) e.
  Proof. intros Y Z E. destruct m as [v | u]; cbn; [trivial |]. now apply (vertices_of_q_stay _ _ _ stay). Qed.

  Lemma markers_stay_on_q (y z : vector) (f : segment) (m : vector + vector) : lies_on y way -> lies_on z way ->
    In f (region_edges q) -> listed m -> lies_on (marker_at y m) (reflected y f) ->
    lies_on (marker_at z m) (reflected z f).
  Proof.
    rewrite !on_reflected. intros Y Z F. destruct m as [v | u]; cbn [listed marker_at]; intros I.
    - now apply (vertices_of_p_stay _ _ _ stay y z).
    - apply lies_on_equal. by_computing.
  Qed.

  (* Vertices on an edge of P keep their order. *)
  Lemma markers_keep_their_order (y z : vector) (e : segment) (m n : vector + vector) :
    lies_on y way -> lies_on z way -> In e (region_edges p) -> listed m -> listed n ->
    lies_on (marker_at y m) e -> lies_on (marker_at y n) e ->
    comes_later e (marker_at y m) (marker_at y n) -> comes_later e (marker_at z m) (marker_at z n).
  Proof.
    unfold comes_later. intros Y Z E M N on_m on_n before_some. apply Qnot_le_lt. intros after_none.
    set (gap := fun x => dot (along e) (minus (marker_at x n) (marker_at x m))).
    set (t := gap y / (gap y - gap z)).
    assert (t_is : t * (gap y - gap z) == gap y) by (unfold t; field; unfold gap; lra).
    assert (range : 0 <= t <= 1)
      by (unfold t, gap; split; [apply Qle_shift_div_l; lra | apply Qle_shift_div_r; lra]).
    clearbody t. set (v := point_at (Segment y z) t).
    assert (here : lies_on v way) by now apply (common_part way y z), point_at_lies_on.
    assert (linear : gap v == (1 - t) * gap y + t * gap z)
      by (unfold gap, v; destruct m, n; cbn [marker_at]; by_computing).
    assert (equal : equal_vectors (marker_at v m) (marker_at v n)).
    { apply (equal_if_not_apart e); [now apply (region_edges_are_directions p) | | | fold (gap v); lra];
        now apply (markers_stay_on_p y v). }
    destruct m as [s | s], n as [u | u]; cbn [marker_at listed] in *.
    - cbn in before_some. assert (dot (along e) (minus u s) == 0); [| lra]. by_computing.
    - apply (no_vertices_meet _ _ _ stay v s u here M N). by_computing.
    - apply (no_vertices_meet _ _ _ stay v u s here N M). by_computing.
    - cbn in before_some. assert (dot (along e) (minus (minus y u) (minus y s)) == 0); [| lra]. by_computing.
  Qed.

  Definition none_between (x : vector) (m n : vector + vector) : Prop :=
    forall k, listed k -> ~ strictly_inside (marker_at x k) (Segment (marker_at x m) (marker_at x n)).

  Lemma none_comes_between (y z : vector) (e : segment) (m n : vector + vector) : lies_on y way -> lies_on z way ->
    In e (region_edges p) -> listed m -> listed n -> lies_on (marker_at y m) e -> lies_on (marker_at y n) e ->
    comes_later e (marker_at y m) (marker_at y n) -> none_between y m n -> none_between z m n.
  Proof.
    intros Y Z E M N on_m on_n later none k K inside_.
    pose proof (markers_keep_their_order y z e m n Y Z E M N on_m on_n later) as later_z.
    destruct (later_inside e _ _ _ inside_ later_z) as [after before].
    assert (m_z : lies_on (marker_at z m) e) by now apply (markers_stay_on_p y z).
    assert (n_z : lies_on (marker_at z n) e) by now apply (markers_stay_on_p y z).
    pose proof (common_part e _ _ _ m_z n_z (strictly_inside_lies_on _ _ inside_)) as on_k.
    apply (none k K), (inside_if_between e); trivial; [now apply (region_edges_are_directions p) | | |];
      [now apply (markers_stay_on_p z y) | now apply (markers_keep_their_order z y) ..].
  Qed.

  Hypotheses (p_simple : nowhere_above_one p) (q_simple : nowhere_above_one q).

  (* A part of an edge that shows that the interiors meet still shows it. *)
  Lemma part_stays (y z : vector) (e : segment) (c d : vector) : lies_on y way -> lies_on z way ->
    part_shows p (placed y q) e c d -> interiors_meet z p q.
  Proof.
    intros Y Z (E & c_is & d_is & on_c & on_d & ahead & none & shows).
    pose proof (collide_decides_whether_interiors_meet p q z p_region q_region p_simple q_simple) as decided.
    destruct (collide p (placed z q)) eqn:met; [tauto |].
    assert (not_met : ~ interiors_meet z p q) by (rewrite <- decided; congruence). clear met decided.
    destruct (marker_of_vertex y c c_is) as (m & M & c_equal), (marker_of_vertex y d d_is) as (n & N & d_equal).
    pose proof (region_edges_are_directions p p_edges e E) as long.
    apply (lies_on_equal _ _ _ c_equal) in on_c. apply (lies_on_equal _ _ _ d_equal) in on_d.
    set (mid := fun x => middle (Segment (marker_at x m) (marker_at x n))).
    assert (mid_equal : equal_vectors (middle (Segment c d)) (mid y)) by (unfold mid; by_computing).
    assert (ahead_y : comes_later e (marker_at y m) (marker_at y n)).
    { destruct c_equal as [cx cy], d_equal as [dx dy]. unfold comes_later, dot, minus in *; cbn [vx vy] in *.
      now rewrite <- cx, <- cy, <- dx, <- dy. }
    assert (none_y : none_between y m n).
    { intros k K (t & range & tx & ty). apply (none (marker_at y k) (vertex_of_marker y k K)). exists t.
      split; [exact range |]. destruct c_equal as [cx cy], d_equal as [dx dy]. cbn [source target] in *.
      now rewrite cx, cy, dx, dy. }
    assert (facts : forall v, lies_on v way -> lies_on (marker_at v m) e /\ lies_on (marker_at v n) e /\
      lies_on (mid v) e /\ comes_later e (marker_at v m) (marker_at v n) /\ none_between v m n).
    { intros v V. assert (on_m_v : lies_on (marker_at v m) e) by now apply (markers_stay_on_p y v).
      assert (on_n_v : lies_on (marker_at v n) e) by now apply (markers_stay_on_p y v).
      split; [exact on_m_v |]. split; [exact on_n_v |].
      split; [apply (common_part e _ _ _ on_m_v on_n_v); apply strictly_inside_lies_on, middle_is_inside |].
      split; [now apply (markers_keep_their_order y v) | now apply (none_comes_between y v e)]. }
    assert (no_vertex : forall v, lies_on v way -> ~ is_vertex (mid v) p /\ ~ is_vertex (mid v) (placed v q)).
    { intros v V. destruct (facts v V) as (_ & _ & _ & _ & none_v). rewrite vertex_of_placed_iff.
      split; intros vertex; [apply (none_v (inl (mid v)) vertex), middle_is_inside |].
      apply (none_v (inr (minus v (mid v))) vertex). destruct (minus_twice v (mid v)) as [ex ey].
      destruct (middle_is_inside (Segment (marker_at v m) (marker_at v n))) as (k & range & kx & ky).
      exists k. split; [exact range |]. cbn [marker_at]. now rewrite ex, ey. }
    assert (parallel_runs : forall v x f, lies_on v way -> lies_on x way -> In f (region_edges q) ->
      cross (along e) (along f) == 0 -> lies_on (mid v) (reflected v f) -> lies_on (mid x) (reflected x f)).
    { intros v x f V X F parallel on. destruct (facts v V) as (m_v & n_v & _ & ahead_v & none_v).
      destruct (long_reflected v e f) as [cross_v _].
      destruct (runs_along_the_part e (reflected v f) (marker_at v m) (marker_at v n) (mid v)) as [m_f n_f]; trivial.
      - apply (region_edges_are_directions _ (proj1 (placed_is_valid v q q_region))).
        rewrite edges_of_placed. now apply in_map.
      - lra.
      - intros u [-> | ->]; [apply (none_v (inr (source f))) | apply (none_v (inr (target f)))];
          cbn; auto using source_is_vertex, target_is_vertex.
      - apply middle_is_inside.
      - apply (common_part _ (marker_at x m) (marker_at x n)); [now apply (markers_stay_on_q v x) .. |].
        apply strictly_inside_lies_on, middle_is_inside. }
    destruct shows as [inside_ | (f' & F' & on_f & parallel & same_way)].
    - (* it stays inside *)
      apply inside_placed in inside_. destruct inside_ as [free round].
      assert (off_all : forall v, lies_on v way -> off (minus v (mid v)) (region_edges q)).
      { intros v V f F on. apply on_reflected in on.
        destruct (Qeq_dec (cross (along e) (along f)) 0) as [parallel | turn].
        - apply (free f F). apply (lies_on_equal (minus y (mid y))); [by_computing |].
          apply on_reflected. now apply (parallel_runs v y f).
        - apply not_met. apply (crossing_stays v z V Z). destruct (facts v V) as (_ & _ & mid_v & _).
          destruct (no_vertex v V) as [not_p not_q]. exists e, (reflected v f), (mid v).
          rewrite edges_of_placed. repeat split; trivial; [now apply in_map |].
          destruct (long_reflected v e f). lra. }
      assert (same_number : winding_number (minus y (mid y)) (region_edges q) =
        winding_number (minus z (mid z)) (region_edges q)).
      { apply (winding_number_along (Segment (minus y (mid y)) (minus z (mid z))) _ (region_cycles q)).
        intros w (t & range & wx & wy). cbn [source target] in wx, wy.
        apply (off_equal (minus (point_at (Segment y z) t) (mid (point_at (Segment y z) t))));
          [| now apply off_all, (common_part way y z), point_at_lies_on].
        unfold mid in *. destruct m, n; cbn [marker_at] in *; by_computing. }
      apply interiors_meet_other_way, (inner_point_and_point q p z (minus z (mid z)) (mid z));
        [now apply valid_is_regular | | | by_computing].
      + split; [now apply off_all |]. rewrite <- same_number.
        now rewrite <- (winding_number_of_equal (minus y (middle (Segment c d))) (minus y (mid y))) by by_computing.
      + right. exists e. now destruct (facts z Z) as (_ & _ & mid_z & _).
    - (* it stays on the same edge *)
      destruct (edge_of_placed y q f' F') as (f & F & ->). destruct (long_reflected y e f) as [cross_is dot_is].
      assert (on_z : lies_on (mid z) (reflected z f)).
      { apply (parallel_runs y z f); trivial; [lra |]. now apply (lies_on_equal (middle (Segment c d))). }
      destruct (facts z Z) as (_ & _ & mid_z & _), (no_vertex z Z) as [not_p not_q].
      destruct (long_reflected z e f) as [cross_z dot_z]. pose proof (square_positive _ long) as square.
      apply meet_inside_placed.
      apply (left_of_both p (placed z q) e (reflected z f) (mid z) (Vector (- vy (along e)) (vx (along e)))); trivial.
      1, 2: now apply placed_is_valid || (rewrite edges_of_placed; now apply in_map).
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
  destruct (what_shows p (placed y q)) as [crossing_ | [(e & c & d & part) | (f & c & d & part)]]; trivial;
    [now apply placed_is_valid | now apply placed_is_at_most_one | now apply meet_inside_placed | | |].
  - now apply (crossing_stays p q way p_region q_region stay y z).
  - now apply (part_stays p q way p_region q_region stay p_simple q_simple y z e c d).
  - destruct (part_shows_reflected y p q f c d part) as (f' & part'). apply interiors_meet_other_way.
    apply (part_stays q p way q_region p_region (contacts_stay_other_way p q way stay) q_simple p_simple y z
      f' (minus y c) (minus y d)); trivial.
Qed.
