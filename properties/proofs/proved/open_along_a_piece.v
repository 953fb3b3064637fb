(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The sums of a vertex and an edge, cut where they meet (open_sum_program.v): along a piece of them the interiors of
   P and -Q + x meet everywhere or nowhere. What has a point strictly inside a piece runs along all of it, so while x
   moves along the piece, contacts stay (contacts_that_stay.v). And where x is strictly inside such a sum, and no sum
   of two vertices, the interiors can fail to meet only if no edge at the vertex leads across. *)
From Coq Require Import QArith Qminmax Lqa Qfield ZArith Lia Bool List.
From Oplus Require Import convolution signed_crossings tie_rule meeting_of_segments regions reflected interiors_meet
  neighbourhoods left_of_an_edge winding_number_of_the_sum theorem_4_2_1 theorem_2_2_6 boundary_points location pieces
  naive_collision met_pieces collision_is_sound collision_is_complete placed_collision test_of_regions
    right_of_an_edge filling cut_pieces contacts
  contacts_that_stay sums_of_two_edges sum_of_uncovered_pieces open_sum_program.
Import ListNotations.

Open Scope Q_scope.

Lemma on_moved_segment (x v : vector) (s : segment) : lies_on x (moved_segment v s) <-> lies_on (minus x v) s.
Proof.
  unfold lies_on, moved_segment, plus, minus; cbn [source target vx vy].
  split; intros (t & range & X & Y); exists t; (split; [exact range |]); split; lra.
Qed.

Lemma in_vertex_edge_segments (a b : region) (t : segment) :
  In t (vertex_edge_segments a b) <->
  exists s f, In s (region_edges a) /\ In f (region_edges b) /\ t = moved_segment (source s) f.
Proof.
  unfold vertex_edge_segments, vertices_of. rewrite in_flat_map. split.
  - intros (v & V & I). apply in_map_iff in V, I. destruct V as (s & <- & S), I as (f & <- & F). now exists s, f.
  - intros (s & f & S & F & ->). exists (source s). split; [now apply in_map | now apply in_map].
Qed.

Lemma vertex_edge_segments_are_long (a b : region) (t : segment) : no_edges_are_points b ->
  In t (vertex_edge_segments a b) -> nonzero (along t).
Proof.
  intros b_edges I. apply in_vertex_edge_segments in I. destruct I as (s & f & _ & F & ->).
  pose proof (region_edges_are_directions b b_edges f F) as long. intros [X Y]. apply long.
  unfold along, moved_segment, minus, plus in *; cbn [source target vx vy] in *. split; lra.
Qed.

Lemma in_touching_segments (a b : region) (t : segment) :
  In t (touching_segments a b) <->
  exists s f, In s (region_edges a) /\ In f (region_edges b) /\ leads_across a f (source s) = false /\
    t = moved_segment (source s) f.
Proof.
  unfold touching_segments, vertices_of. rewrite in_flat_map. split.
  - intros (v & V & I). apply in_map_iff in V, I. destruct V as (s & <- & S), I as (f & <- & F).
    apply filter_In in F. destruct F as [F no]. apply negb_true_iff in no. now exists s, f.
  - intros (s & f & S & F & no & ->). exists (source s). split; [now apply in_map |]. apply in_map, filter_In.
    now rewrite no.
Qed.

Lemma touching_segments_are_sums (a b : region) : incl (touching_segments a b) (vertex_edge_segments a b).
Proof.
  intros t I. apply in_touching_segments in I. apply in_vertex_edge_segments. destruct I as (s & f & S & F & _ & ->).
  now exists s, f.
Qed.

(* Where an edge leads across, the interiors meet. *)
Lemma leading_across_meets (a b : region) (x : vector) (s f : segment) : valid_region a -> valid_region b ->
  In s (region_edges a) -> In f (region_edges b) -> leads_across a f (source s) = true ->
  lies_on (minus x (source s)) f -> ~ is_vertex (minus x (source s)) b -> interiors_meet x a b.
Proof.
  intros a_region b_region S F across on free. pose proof a_region as (a_edges & a_valid & a_meet).
  pose proof b_region as (b_edges & b_valid & b_meet).
  (* d leads from the vertex along an edge *)
  assert (found : forall d, 0 < cross (along f) (opposite d) ->
    (forall t, 0 < t -> t < 1 -> in_region (moved_along (source s) d t) a) -> interiors_meet x a b).
  { intros d left_ along_e.
    destruct (eventually_and _ _ (left_of_an_edge_is_inside b f _ _ b_valid b_meet F on free left_)
      (ex_intro _ 1 (conj (ltac:(lra) : 0 < 1) (fun t some small => conj some small : 0 < t /\ t < 1))))
      as (limit & L & near).
    destruct (near ((1 # 2) * limit)) as (inside_b & some & small); [lra | lra |].
    apply interiors_meet_other_way.
    refine (inner_point_and_point b a x _ (moved_along (source s) d ((1 # 2) * limit)) _ inside_b _ _).
    - now apply regions_are_regular.
    - now apply along_e.
    - unfold plus, moved_along, opposite, minus; cbn [vx vy]. split; cbn [vx vy]; ring. }
  unfold leads_across in across. apply existsb_exists in across. destruct across as (e & E & either).
  apply orb_true_iff in either. destruct either as [both | both]; apply andb_true_iff in both; destruct both as [at_v
    turn].
  - destruct (same_point_spec (source e) (source s)) as [[X Y] |]; [clear at_v | discriminate].
    destruct (negative_spec (cross (along f) (along e))) as [right_ |]; [clear turn | discriminate].
    apply (found (along e)); [unfold cross, opposite in *; cbn [vx vy]; lra |]. intros t some small.
    right. exists e. split; [exact E |]. exists t. split; [lra |]. unfold moved_along, along, minus; cbn [vx vy].
    rewrite <- X, <- Y. split; ring.
  - destruct (same_point_spec (target e) (source s)) as [[X Y] |]; [clear at_v | discriminate].
    destruct (negative_spec (cross (along e) (along f))) as [left_ |]; [clear turn | discriminate].
    apply (found (opposite (along e))); [unfold cross, opposite in *; cbn [vx vy]; lra |]. intros t some small.
    right. exists e. split; [exact E |]. exists (1 - t). split; [lra |].
    unfold moved_along, opposite, along, minus; cbn [vx vy]. rewrite <- X, <- Y. split; ring.
Qed.

(* Inside the sum of two edges the interiors meet: beside the point where they cross, a point of the edge of P is
   inside -Q + x. *)
Lemma inside_a_sum_of_two_meets (p q : region) (e f : segment) (x a b : vector) : valid_region p -> valid_region q ->
  In e (region_edges p) -> In f (region_edges q) -> clear_edge q f ->
  (a = along e /\ b = along f \/ a = along f /\ b = along e) ->
  is_inside_the_sum_of_two (plus (source e) (source f)) a b x -> interiors_meet x p q.
Proof.
  intros p_region q_region E F clear_ sides inside_.
  assert (turn : ~ cross (along f) (along e) == 0).
  { destruct inside_ as (i1 & i2 & _). destruct sides as [[-> ->] | [-> ->]]; unfold cross in *; lra. }
  assert (point_ : exists g h, 0 < g < 1 /\ 0 < h < 1 /\
    equal_vectors x (plus (moved_along (source e) (along e) g) (moved_along (source f) (along f) h))).
  { destruct (as_sum_of_points _ a b x inside_) as (g & h & g_range & h_range & X & Y).
    destruct sides as [[-> ->] | [-> ->]]; [exists g, h | exists h, g]; (split; [assumption |]; split; [assumption |]);
      unfold plus, moved_along in *; cbn [vx vy] in *; split; cbn [vx vy]; lra. }
  clear inside_ sides a b. destruct point_ as (g & h & g_range & h_range & X & Y).
  set (w := moved_along (source e) (along e) g) in *. set (u := moved_along (source f) (along f) h) in *.
  pose proof p_region as (p_edges & p_valid & p_meet). pose proof q_region as (q_edges & q_valid & q_meet).
  assert (on_f : lies_on u f)
    by (exists h; unfold u, moved_along, along, minus; cbn [vx vy]; split; [lra |]; split; ring).
  assert (free : ~ is_vertex u q)
    by (apply (clear_ h); [exact h_range | unfold u, moved_along, along, minus; cbn [vx vy]; ring ..]).
  assert (found : forall k : Q, 0 < cross (along f) (opposite (moved_along (Vector 0 0) (along e) k)) ->
    (forall t, 0 < t -> t < Qmin g (1 - g) -> lies_on (moved_along w (moved_along (Vector 0 0) (along e) k) t) e) ->
    interiors_meet x p q).
  { intros k left_ on_e. set (n := moved_along (Vector 0 0) (along e) k) in *.
    destruct (left_of_an_edge_is_inside q f u _ q_valid q_meet F on_f free left_) as (limit & L & near).
    assert (some : 0 < Qmin g (1 - g)) by (apply Q.min_glb_lt; lra).
    set (t := (1 # 2) * Qmin limit (Qmin g (1 - g))).
    assert (t_range : 0 < t /\ t < limit /\ t < Qmin g (1 - g)).
    { assert (0 < Qmin limit (Qmin g (1 - g))) by (now apply Q.min_glb_lt).
      pose proof (Q.le_min_l limit (Qmin g (1 - g))). pose proof (Q.le_min_r limit (Qmin g (1 - g))).
      unfold t. repeat split; lra. }
    clearbody t. destruct t_range as (t_some & t_limit & t_g).
    apply interiors_meet_other_way.
    refine (inner_point_and_point q p x _ (moved_along w n t) _ (near t t_some t_limit) _ _).
    - now apply regions_are_regular.
    - right. exists e. split; [exact E | now apply on_e].
    - unfold plus, moved_along, opposite; cbn [vx vy]. unfold plus in X, Y; cbn [vx vy] in X, Y.
      split; cbn [vx vy]; [rewrite X | rewrite Y]; ring. }
  pose proof (Q.le_min_l g (1 - g)). pose proof (Q.le_min_r g (1 - g)).
  destruct (Q_dec (cross (along f) (along e)) 0) as [[low | high] | flat]; [| | contradiction].
  - apply (found 1); [unfold cross, opposite, moved_along in *; cbn [vx vy]; lra |]. intros t some small.
    exists (g + t). split; [lra |]. unfold w, moved_along, along, minus; cbn [vx vy]. split; ring.
  - apply (found (-1)); [unfold cross, opposite, moved_along in *; cbn [vx vy]; lra |]. intros t some small.
    exists (g - t). split; [lra |]. unfold w, moved_along, along, minus; cbn [vx vy]. split; ring.
Qed.

Lemma interiors_meet_all_near (p q : region) (x : vector) : interiors_meet x p q ->
  exists radius, 0 < radius /\ forall y, within radius x y -> interiors_meet y p q.
Proof.
  intros (z & in_p & [free positive_]).
  destruct (winding_number_near _ _ (region_cycles q) free) as (radius & R & near). exists radius. split; [exact R |].
  intros y close. exists z. split; [exact in_p |].
  destruct (near (minus y z)) as [free_y same_number]; [unfold within, minus in *; cbn [vx vy]; lra |].
  split; [exact free_y | lia].
Qed.

Lemma within_of_equal (radius : Q) (x y : vector) : 0 < radius -> equal_vectors x y -> within radius x y.
Proof. intros R [X Y]. unfold within. lra. Qed.

Lemma interiors_meet_of_equal (p q : region) (x y : vector) :
  equal_vectors x y -> interiors_meet x p q -> interiors_meet y p q.
Proof.
  intros equal meet. destruct (interiors_meet_all_near p q x meet) as (radius & R & near).
  now apply near, within_of_equal.
Qed.

Section Pieces.
  Variables p q : region.
  Hypothesis p_region : valid_region p.
  Hypothesis q_region : valid_region q.
  Hypothesis p_simple : nowhere_above_one p.
  Hypothesis q_simple : nowhere_above_one q.

  Let all := all_vertex_edge_segments p q.

  Lemma all_vertex_edge_segments_are_long (t : segment) : In t all -> nonzero (along t).
  Proof.
    intros I. apply in_app_iff in I. destruct I as [I | I].
    - now apply (vertex_edge_segments_are_long p q t (proj1 q_region)).
    - now apply (vertex_edge_segments_are_long q p t (proj1 p_region)).
  Qed.

  Let touching := touching_segments p q ++ touching_segments q p.

  Lemma touching_are_listed : incl touching all.
  Proof.
    intros s S. apply in_app_iff. apply in_app_iff in S.
    destruct S as [S | S]; apply touching_segments_are_sums in S; tauto.
  Qed.

  Lemma touching_piece_is (e : segment) : In e (touching_pieces p q) ->
    exists s piece, In s all /\ In piece (cut_where_met s all) /\ of_one_place e piece.
  Proof.
    intros E. unfold touching_pieces in E. apply in_flat_map in E. destruct E as (s & S & E).
    apply in_map_iff in E. destruct E as (piece & <- & I). exists s, piece.
    split; [now apply touching_are_listed |]. split; [| apply undirected_place].
    unfold uncovered_pieces_among in I. rewrite quick_cut_is in I.
    destruct (uncovered_parts _ _ s); [destruct I |]. now apply filter_In in I.
  Qed.

  Lemma contacts_stay_along_a_piece (s piece : segment) (y z : vector) : In s all -> In piece (cut_where_met s all) ->
    strictly_inside y piece -> strictly_inside z piece -> contacts_stay p q (Segment y z).
  Proof.
    intros S I in_y in_z.
    assert (inside_ : forall v, lies_on v (Segment y z) -> strictly_inside v piece)
      by (intros v on; now apply (strictly_inside_between y z)).
    pose proof (all_vertex_edge_segments_are_long s S) as long.
    assert (runs : forall v w t, In t all -> lies_on v (Segment y z) -> lies_on w (Segment y z) -> lies_on v t ->
      lies_on w t).
    { intros v w t T V W on. apply (runs_along_the_piece s all piece t v w); auto.
      now apply all_vertex_edge_segments_are_long. }
    split.
    - intros v w u f V W U F on. apply on_moved_segment. apply (runs v w); trivial; [| now apply on_moved_segment].
      apply in_app_iff. left. apply in_vertex_edge_segments. now exists u, f.
    - intros v w e u V W E U on. apply on_moved_segment. apply (runs v w); trivial; [| now apply on_moved_segment].
      apply in_app_iff. right. apply in_vertex_edge_segments. now exists u, e.
    - intros v u t V U T equal.
      destruct (nothing_meets_a_piece s all piece (moved_segment (source u) t) v long I (inside_ v V)) as (no_source &
        _).
      + apply in_app_iff. left. apply in_vertex_edge_segments. now exists u, t.
      + exact (no_source equal).
  Qed.

  Lemma meeting_is_the_same_inside (s piece : segment) (y z : vector) : In s all ->
    In piece (cut_where_met s all) -> strictly_inside y piece -> strictly_inside z piece ->
    interiors_meet y p q -> interiors_meet z p q.
  Proof.
    intros S I in_y in_z. apply (meeting_stays p q (Segment y z)); trivial.
    - now apply (contacts_stay_along_a_piece s piece).
    - exact (source_lies_on (Segment y z)).
    - exact (target_lies_on (Segment y z)).
  Qed.

  (* Theorem. All along a piece the interiors meet, or nowhere. *)
  Theorem meeting_is_the_same_along_a_piece (e : segment) (y z : vector) : In e (touching_pieces p q) ->
    strictly_inside y e -> strictly_inside z e -> interiors_meet y p q -> interiors_meet z p q.
  Proof.
    intros E in_y in_z. destruct (touching_piece_is e E) as (s & piece & S & I & place_).
    apply (strictly_inside_of_one_place _ _ _ place_) in in_y, in_z.
    now apply (meeting_is_the_same_inside s piece).
  Qed.

  Let of_p := region_edges p.
  Let of_q := clear_edges q.
  Let d := common_multiple (denominators (touching ++ of_p ++ of_q)).

  (* Where the interiors do not meet, a segment is not covered. *)
  Lemma not_meeting_is_uncovered (s : segment) (w : vector) : In s touching -> lies_on w s -> ~ interiors_meet w p q ->
    is_in_parts (fraction s w) (uncovered_parts d (sums_of_edges d of_p of_q) s) = true.
  Proof.
    intros S on outside. pose proof (all_vertex_edge_segments_are_long s (touching_are_listed s S)) as long.
    destruct (fraction_on s w long on) as (range & X & Y).
    destruct (covered_is_inside_a_sum_of_two of_p of_q d s (fraction s w) w) as [found | (e & f & a & b & E & F &
      sides & inside_)];
      trivial.
    - intros t which. apply ends_have_denominator. rewrite !in_app_iff. destruct which as [-> | which]; tauto.
    - now destruct (is_in_parts_spec (fraction s w) (uncovered_parts d (sums_of_edges d of_p of_q) s)).
    - exfalso. apply outside. apply filter_In in F. destruct F as [F clear_].
      apply (inside_a_sum_of_two_meets p q e f w a b); trivial. apply edge_is_clear_is_right; [| exact clear_].
      now apply (region_edges_are_directions q (proj1 q_region)).
  Qed.

  Lemma vertex_sum_is_listed (x : vector) (v u : vector) : is_vertex v p -> is_vertex u q ->
    equal_vectors x (plus v u) -> ~ interiors_meet x p q -> exists w, In w (vertex_sums p q) /\ equal_vectors x w.
  Proof.
    intros (s & S & sx & sy) (t & T & tx & ty) [X Y] outside.
    set (w := plus (source s) (source t)).
    assert (equal : equal_vectors x w) by (unfold w, plus in *; cbn [vx vy] in *; split; cbn [vx vy]; lra).
    exists (reduced_vector w). split; [| transitivity w; [exact equal | symmetry; apply reduced_is]].
    unfold vertex_sums. cbv zeta. fold of_p of_q.
    set (points := flat_map _ (vertices_of p)).
    assert (W : In (Segment w w) points).
    { unfold points, vertices_of. apply in_flat_map. exists (source s). split; [now apply in_map |].
      apply in_map_iff. exists (source t). split; [reflexivity | now apply in_map]. }
    set (d' := common_multiple _). apply in_map_iff. exists (Segment w w). split; [reflexivity |]. apply filter_In.
    split; [exact W |].
    destruct (covered_is_inside_a_sum_of_two of_p of_q d' (Segment w w) 0 w)
      as [(part_ & P & _) | (e & f & a & b & E & F & sides & inside_)].
    - intros r which. apply ends_have_denominator. rewrite !in_app_iff. destruct which as [-> | which]; tauto.
    - lra.
    - cbn [source target]. ring.
    - cbn [source target]. ring.
    - destruct (uncovered_parts d' (sums_of_edges d' of_p of_q) (Segment w w)); [destruct P | reflexivity].
    - exfalso. apply outside. apply (interiors_meet_of_equal p q w); [now symmetry |].
      apply filter_In in F. destruct F as [F clear_].
      apply (inside_a_sum_of_two_meets p q e f w a b); trivial. apply edge_is_clear_is_right; [| exact clear_].
      now apply (region_edges_are_directions q (proj1 q_region)).
  Qed.

  (* Theorem. Where the interiors do not meet, and x is the sum of a vertex and a point of an edge, it is one of two
     vertices, or on a piece. *)
  Theorem not_meeting_is_on_a_piece (x : vector) : on_vertex_edge_sum x p q -> ~ interiors_meet x p q ->
    (exists w, In w (vertex_sums p q) /\ equal_vectors x w) \/ exists e, In e (touching_pieces p q) /\ lies_on x e.
  Proof.
    intros on_sum outside.
    assert (found : forall s, In s touching -> lies_on x s -> exists e, In e (touching_pieces p q) /\ lies_on x e).
    { intros s S on. pose proof (touching_are_listed s S) as A.
      destruct (cut_returns s (flat_map (intersection s) all) (all_vertex_edge_segments_are_long s A)) as [parts_
        cover].
      destruct (cover x on) as (piece & I & part_ & on_piece). exists (undirected piece).
      split; [| exact (lies_on_of_one_place _ _ x (of_one_place_sym _ _ (undirected_place piece)) on_piece)].
      unfold touching_pieces. apply in_flat_map. exists s. split; [exact S |]. apply in_map.
      fold touching all of_p of_q d. unfold uncovered_pieces_among. rewrite quick_cut_is.
      assert (some : exists w, In w [source piece; middle piece; target piece] /\ lies_on w piece /\
        ~ interiors_meet w p q).
      { pose proof on_piece as (k & range & X & Y).
        destruct (Qlt_le_dec 0 k) as [after | at_source]; [destruct (Qlt_le_dec k 1) as [before | at_target] |].
        - exists (middle piece). split; [cbn; tauto |]. split; [apply strictly_inside_lies_on, middle_is_inside |].
          intros meet. apply outside. apply (meeting_is_the_same_inside s piece (middle piece)); trivial.
          + apply middle_is_inside.
          + exists k. split; [lra | now split].
        - exists (target piece). split; [cbn; tauto |]. split; [apply target_lies_on |].
          intros meet. apply outside. apply (interiors_meet_of_equal p q (target piece)); [| exact meet].
          assert (k_is : k == 1) by lra. rewrite k_is in X, Y. split; lra.
        - exists (source piece). split; [cbn; tauto |]. split; [apply source_lies_on |].
          intros meet. apply outside. apply (interiors_meet_of_equal p q (source piece)); [| exact meet].
          assert (k_is : k == 0) by lra. rewrite k_is in X, Y. split; lra. }
      destruct some as (w & W & on_w & outside_w).
      pose proof (not_meeting_is_uncovered s w S (part_lies_on piece s w (all_vertex_edge_segments_are_long s A) part_
        on_w)
        outside_w) as uncovered.
      destruct (uncovered_parts d (sums_of_edges d of_p of_q) s); [discriminate uncovered |].
      apply filter_In. split; [exact I |]. apply existsb_exists. now exists w. }
    destruct on_sum as [(v & f & (s & S & equal) & F & on) | (u & e & (t & T & equal) & E & on)].
    - assert (on_s : lies_on (minus x (source s)) f).
      { refine (lies_on_equal _ _ _ _ on). destruct equal. unfold minus; split; cbn [vx vy]; lra. }
      destruct (is_vertex_dec (minus x (source s)) q) as [vertex | free].
      + left. apply (vertex_sum_is_listed x (source s) (minus x (source s))); trivial.
        * exists s. split; [exact S | split; reflexivity].
        * unfold plus, minus. split; cbn [vx vy]; ring.
      + right. apply (found (moved_segment (source s) f)); [| now apply on_moved_segment].
        apply in_app_iff. left. apply in_touching_segments. exists s, f. repeat split; trivial.
        destruct (leads_across p f (source s)) eqn:across; [exfalso | reflexivity].
        apply outside. now apply (leading_across_meets p q x s f).
    - assert (on_t : lies_on (minus x (source t)) e).
      { refine (lies_on_equal _ _ _ _ on). destruct equal. unfold minus; split; cbn [vx vy]; lra. }
      destruct (is_vertex_dec (minus x (source t)) p) as [vertex | free].
      + left. apply (vertex_sum_is_listed x (minus x (source t)) (source t)); trivial.
        * exists t. split; [exact T | split; reflexivity].
        * unfold plus, minus. split; cbn [vx vy]; ring.
      + right. apply (found (moved_segment (source t) e)); [| now apply on_moved_segment].
        apply in_app_iff. right. apply in_touching_segments. exists t, e. repeat split; trivial.
        destruct (leads_across q e (source t)) eqn:across; [exfalso | reflexivity].
        apply outside, interiors_meet_other_way. now apply (leading_across_meets q p x t e).
  Qed.
End Pieces.
