(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The sums of a vertex and an edge, cut where they meet (open_sum_program.v): along a piece of them the interiors of
   P and -Q + x meet everywhere or nowhere. What has a point strictly inside a piece runs along all of it, so while x
   moves along the piece, contacts stay (contacts_that_stay.v). And where x is strictly inside such a sum, and no sum
   of two vertices, the interiors can fail to meet only if no edge at the vertex leads across. *)
From Coq Require Import QArith Lqa Qfield ZArith Lia Bool List.
From Oplus Require Import convolution signed_crossings tie_rule meeting_of_segments regions reflected interiors_meet
  neighbourhoods left_of_an_edge winding_number_of_the_sum theorem_4_2_1 theorem_2_2_6 boundary_points location pieces
  naive_collision met_pieces collision_is_sound collision_is_complete placed_collision filling cut_pieces contacts
  contacts_that_stay open_sum_program.
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

  Lemma touching_piece_is (e : segment) : In e (touching_pieces p q) ->
    exists s piece, In s all /\ In piece (cut_where_met s all) /\ of_one_place e piece.
  Proof.
    intros E. unfold touching_pieces in E. apply in_flat_map in E. destruct E as (s & S & E).
    apply in_map_iff in E. destruct E as (piece & <- & I). exists s, piece.
    split; [| split; [exact I | apply undirected_place]].
    apply in_app_iff. apply in_app_iff in S.
    destruct S as [S | S]; apply touching_segments_are_sums in S; tauto.
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

  (* Theorem. All along a piece the interiors meet, or nowhere. *)
  Theorem meeting_is_the_same_along_a_piece (e : segment) (y z : vector) : In e (touching_pieces p q) ->
    strictly_inside y e -> strictly_inside z e -> interiors_meet y p q -> interiors_meet z p q.
  Proof.
    intros E in_y in_z. destruct (touching_piece_is e E) as (s & piece & S & I & place_).
    apply (strictly_inside_of_one_place _ _ _ place_) in in_y, in_z.
    apply (meeting_stays p q (Segment y z)); trivial.
    - now apply (contacts_stay_along_a_piece s piece).
    - exact (source_lies_on (Segment y z)).
    - exact (target_lies_on (Segment y z)).
  Qed.

  Lemma vertex_sum_is_listed (x : vector) (v u : vector) : is_vertex v p -> is_vertex u q ->
    equal_vectors x (plus v u) -> exists w, In w (vertex_sums p q) /\ equal_vectors x w.
  Proof.
    intros (s & S & sx & sy) (t & T & tx & ty) [X Y]. exists (reduced_vector (plus (source s) (source t))). split.
    - unfold vertex_sums, vertices_of. apply in_flat_map. exists (source s). split; [now apply in_map |].
      apply in_map_iff. exists (source t). split; [reflexivity | now apply in_map].
    - pose proof (reduced_is (plus (source s) (source t))) as [rx ry]. unfold plus in *; cbn [vx vy] in *.
      split; [rewrite X, rx | rewrite Y, ry]; lra.
  Qed.

  (* Theorem. Where the interiors do not meet, and x is the sum of a vertex and a point of an edge, it is one of two
     vertices, or on a piece. *)
  Theorem not_meeting_is_on_a_piece (x : vector) : on_vertex_edge_sum x p q -> ~ interiors_meet x p q ->
    (exists w, In w (vertex_sums p q) /\ equal_vectors x w) \/ exists e, In e (touching_pieces p q) /\ lies_on x e.
  Proof.
    intros on_sum outside.
    assert (found : forall s, In s (touching_segments p q ++ touching_segments q p) -> lies_on x s ->
      exists e, In e (touching_pieces p q) /\ lies_on x e).
    { intros s S on.
      assert (A : In s all).
      { apply in_app_iff. apply in_app_iff in S. destruct S as [S | S]; apply touching_segments_are_sums in S; tauto. }
      destruct (cut_returns s (flat_map (intersection s) all) (all_vertex_edge_segments_are_long s A)) as [_ cover].
      destruct (cover x on) as (piece & I & _ & on_piece). exists (undirected piece). split.
      - unfold touching_pieces. apply in_flat_map. exists s. split; [exact S |]. now apply in_map.
      - exact (lies_on_of_one_place _ _ x (of_one_place_sym _ _ (undirected_place piece)) on_piece). }
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
