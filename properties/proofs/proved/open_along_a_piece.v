(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The sums of a vertex and an edge, cut where they meet (open_sum_program.v): along a piece of them the interiors of
   P and -Q + x meet everywhere or nowhere. What has a point strictly inside a piece runs along all of it, so while x
   moves along the piece, contacts stay (contacts_that_stay.v). And where x is strictly inside such a sum, and no sum
   of two vertices, the interiors can fail to meet only if no edge at the vertex leads across. *)
From Coq Require Import QArith Lqa Qfield ZArith Lia Bool List.
From Oplus Require Import regions_and_sums reflected theorem_2_2_6 boundary_points pieces naive_collision met_pieces
  collision_is_complete test_of_regions right_of_an_edge filling cut_pieces coordinates contacts_that_stay
  sums_of_two_edges sum_of_uncovered_pieces open_sum_program.
Import ListNotations.

Open Scope Q_scope.

Lemma on_moved_segment (x v : vector) (s : segment) : lies_on x (moved_segment v s) <-> lies_on (minus x v) s.
Proof.
  unfold moved_segment. split; intros (t & range & on); exists t; (split; [exact range |]); destruct on; by_computing.
Qed.

Lemma both_meet (p q a b : region) (x : vector) : are_both p q a b -> interiors_meet x a b -> interiors_meet x p q.
Proof. intros [[-> ->] | [-> ->]]; [trivial | apply interiors_meet_other_way]. Qed.

Lemma in_all (p q : region) (t : segment) : In t (all_vertex_edge_segments p q) <-> exists a b s f,
  are_both p q a b /\ In s (region_edges a) /\ In f (region_edges b) /\ t = moved_segment (source s) f.
Proof.
  unfold all_vertex_edge_segments, vertex_edge_segments, vertices_of. rewrite in_app_iff, !in_flat_map.
  setoid_rewrite in_map_iff. split.
  - intros [(v & (s & <- & S) & f & <- & F) | (v & (s & <- & S) & f & <- & F)];
      [exists p, q, s, f | exists q, p, s, f]; unfold are_both; tauto.
  - intros (a & b & s & f & [[-> ->] | [-> ->]] & S & F & ->); [left | right]; exists (source s); split; eauto.
Qed.

Lemma touching_are_listed (p q : region) : incl (touching_segments p q ++ touching_segments q p)
  (all_vertex_edge_segments p q).
Proof.
  apply incl_app_app; intros t (v & V & (f & <- & [F _]%filter_In)%in_map_iff)%in_flat_map; apply in_flat_map;
    exists v; (split; [exact V | now apply in_map]).
Qed.

Lemma on_listed_is (p q : region) (x : vector) :
  (exists t, In t (all_vertex_edge_segments p q) /\ lies_on x t) <-> on_vertex_edge_sum x p q.
Proof.
  setoid_rewrite in_all. split.
  - intros (t & (a & b & s & f & both & S & F & ->) & on). apply on_moved_segment in on.
    destruct both as [[-> ->] | [-> ->]]; [left | right]; exists (source s), f; auto using source_is_vertex.
  - intros [(v & f & (s & S & equal) & F & on) | (v & f & (s & S & equal) & F & on)];
      exists (moved_segment (source s) f); (split; [| apply on_moved_segment, (lies_on_equal (minus x v)); trivial;
      by_computing]); [exists p, q, s, f | exists q, p, s, f]; unfold are_both; tauto.
Qed.

(* An edge e of a leads, from its point at g, into -b + x: to the left of an edge f, from a point of it that is no
   vertex. *)
Lemma leading_inside_meets (a b : region) (x u : vector) (e f : segment) (g : Q) : valid_region a -> valid_region b ->
  In e (region_edges a) -> In f (region_edges b) -> lies_on u f -> ~ is_vertex u b ->
  equal_vectors x (plus (point_at e g) u) -> 0 <= g <= 1 ->
  (cross (along f) (along e) < 0 /\ g < 1) \/ (0 < cross (along f) (along e) /\ 0 < g) -> interiors_meet x a b.
Proof.
  intros a_region (_ & b_valid & b_meet) E F on free equal g_range side.
  assert (found : forall k v, 0 <= k <= 1 -> inside v b -> equal_vectors x (plus (point_at e k) v) ->
    interiors_meet x a b).
  { intros k v range inside_b sum_.
    apply interiors_meet_other_way, (inner_point_and_point b a x v (point_at e k) (valid_is_regular _ a_region)
      inside_b);
      [right; exists e; split; [exact E | now apply point_at_lies_on] | by_computing]. }
  destruct side as [[right_ some] | [left_ some]].
  - destruct (some_small _ (eventually_and _ _ (left_of_an_edge_is_inside b f u (opposite (along e)) b_valid b_meet F on
      free ltac:(in_coordinates; lra)) (eventually_below (1 - g) ltac:(lra)))) as (t & _ & inside_b & range).
    apply (found (g + t) _ ltac:(lra) inside_b). by_computing.
  - destruct (some_small _ (eventually_and _ _ (left_of_an_edge_is_inside b f u (along e) b_valid b_meet F on
      free left_) (eventually_below g some))) as (t & _ & inside_b & range).
    apply (found (g - t) _ ltac:(lra) inside_b). by_computing.
Qed.

(* Where an edge leads across, the interiors meet. *)
Lemma leading_across_meets (a b : region) (x : vector) (s f : segment) : valid_region a -> valid_region b ->
  In f (region_edges b) -> leads_across a f (source s) = true -> lies_on (minus x (source s)) f ->
  ~ is_vertex (minus x (source s)) b -> interiors_meet x a b.
Proof.
  intros a_region b_region F across on free. apply existsb_exists in across. destruct across as (e & E & either).
  rewrite orb_true_iff, !andb_true_iff, <- !(reflect_iff _ _ (same_point_spec _ _)),
    <- !(reflect_iff _ _ (negative_spec _)) in either.
  destruct either as [[equal right_] | [equal left_]];
    [apply (leading_inside_meets a b x _ e f 0 a_region b_region E F on free); [by_computing | lra | left; lra] |
     apply (leading_inside_meets a b x _ e f 1 a_region b_region E F on free); [by_computing | lra | right]].
  unfold cross in *. lra.
Qed.

Lemma interiors_meet_all_near (p q : region) (x : vector) : interiors_meet x p q ->
  exists radius, 0 < radius /\ forall y, within radius x y -> interiors_meet y p q.
Proof.
  intros (z & in_p & [free positive_]).
  destruct (winding_number_near _ _ (region_cycles q) free) as (radius & R & near). exists radius. split; [exact R |].
  intros y close. exists z. split; [exact in_p |].
  destruct (near (minus y z)) as [free_y same_number]; [by_computing |]. split; [exact free_y | lia].
Qed.

Lemma interiors_meet_of_equal (p q : region) (x y : vector) :
  equal_vectors x y -> interiors_meet x p q -> interiors_meet y p q.
Proof.
  intros equal (z & in_p & in_q). exists z. split; [exact in_p |].
  apply (inside_equal (minus x z)); [by_computing | exact in_q].
Qed.

Section Pieces.
  Variables p q : region.
  Hypotheses (p_region : valid_region p) (q_region : valid_region q).
  Hypotheses (p_simple : nowhere_above_one p) (q_simple : nowhere_above_one q).

  Let all := all_vertex_edge_segments p q.

  Lemma both_are_valid (a b : region) : are_both p q a b -> valid_region a /\ valid_region b.
  Proof. intros [[-> ->] | [-> ->]]; now split. Qed.

  Lemma all_vertex_edge_segments_are_long (t : segment) : In t all -> nonzero (along t).
  Proof.
    intros I. apply in_all in I. destruct I as (a & b & s & f & both & _ & F & ->).
    destruct (both_are_valid a b both) as [_ (b_edges & _)].
    pose proof (region_edges_are_directions b b_edges f F) as long. intros [X Y]. apply long.
    unfold moved_segment in *. by_computing.
  Qed.

  Let touching := touching_segments p q ++ touching_segments q p.

  Lemma touching_piece_is (e : segment) : In e (touching_pieces p q) -> exists s piece, In s all /\
    In piece (cut_where_met s all) /\ of_one_place e piece /\ nonzero (along s) /\ is_part piece s /\ nonzero (along e).
  Proof.
    intros E. unfold touching_pieces in E. apply in_flat_map in E. destruct E as (s & S & E).
    apply in_map_iff in E. destruct E as (piece & <- & I). exists s, piece. apply (touching_are_listed p q) in S.
    pose proof (all_vertex_edge_segments_are_long s S) as long.
    assert (J : In piece (cut_where_met s all)).
    { unfold uncovered_pieces_among in I. rewrite quick_cut_is in I.
      destruct (uncovered_parts _ _ s); [destruct I |]. now apply filter_In in I. }
    pose proof (piece_is_part s piece all long J) as part_. pose proof (undirected_place piece) as place_.
    repeat split; trivial; try apply part_. now apply (long_of_one_place _ _ place_), (part_is_long piece s).
  Qed.

  (* While x moves inside a piece, contacts stay. *)
  Lemma meeting_is_the_same_inside (s piece : segment) (y z : vector) : In s all -> In piece (cut_where_met s all) ->
    strictly_inside y piece -> strictly_inside z piece -> interiors_meet y p q -> interiors_meet z p q.
  Proof.
    intros S I in_y in_z. pose proof (all_vertex_edge_segments_are_long s S) as long.
    assert (inside_ : forall v, lies_on v (Segment y z) -> strictly_inside v piece)
      by (intros v on; now apply (strictly_inside_between y z)).
    apply (meeting_stays p q (Segment y z)); trivial;
      [| exact (source_lies_on (Segment y z)) | exact (target_lies_on (Segment y z))]. split.
    - intros a b v w u f both V W (t & T & equal) F on.
      assert (same : forall x, equal_vectors (minus x u) (minus x (source t))) by (intros x; by_computing).
      assert (listed : In (moved_segment (source t) f) all) by (apply in_all; now exists a, b, t, f).
      apply (lies_on_equal _ _ _ (symmetry (same w))), on_moved_segment.
      apply (runs_along_the_piece s all piece _ v w); auto; [now apply all_vertex_edge_segments_are_long |].
      apply on_moved_segment. exact (lies_on_equal _ _ _ (same v) on).
    - intros v u V (t1 & T1 & equal_1) (t2 & T2 & equal_2).
      destruct (nothing_meets_a_piece s all piece (moved_segment (source t1) t2) v long I (inside_ v V)) as [none _].
      + apply in_all. exists p, q, t1, t2. unfold are_both. tauto.
      + apply none. unfold moved_segment. by_computing.
  Qed.

  (* Theorem. All along a piece the interiors meet, or nowhere. *)
  Theorem meeting_is_the_same_along_a_piece (e : segment) (y z : vector) : In e (touching_pieces p q) ->
    strictly_inside y e -> strictly_inside z e -> interiors_meet y p q -> interiors_meet z p q.
  Proof.
    intros E in_y in_z. destruct (touching_piece_is e E) as (s & piece & S & I & place_ & _).
    apply (strictly_inside_of_one_place _ _ _ place_) in in_y, in_z.
    now apply (meeting_is_the_same_inside s piece).
  Qed.

  Let of_p := region_edges p.
  Let of_q := clear_edges q.

  (* Where the interiors do not meet, a segment of a list is not covered: inside the sum of two edges, the one of P
     leads into -Q + x. *)
  Lemma not_meeting_is_uncovered (l : list segment) (s : segment) (k : Q) :
    let d := common_multiple (denominators (l ++ of_p ++ of_q)) in
    In s l -> 0 <= k <= 1 -> ~ interiors_meet (point_at s k) p q ->
    is_in_parts k (uncovered_parts d (sums_of_edges d of_p of_q) s) = true.
  Proof.
    intros d S range outside.
    destruct (is_in_parts_spec k (uncovered_parts d (sums_of_edges d of_p of_q) s)); [reflexivity | exfalso].
    destruct (covered_is_inside_a_sum_of_two of_p of_q d s k)
      as [| (e & f & E & [F clear_]%filter_In & (g & h & g_range & h_range & equal & turn))]; trivial;
        [| contradiction |].
    - intros t which. apply ends_have_denominator. rewrite !in_app_iff. destruct which as [-> | which]; tauto.
    - apply outside, (leading_inside_meets p q _ (point_at f h) e f g); trivial; [| | lra |].
      + apply point_at_lies_on. lra.
      + apply (edge_is_clear_is_right q f (region_edges_are_directions q (proj1 q_region) f F) clear_ h);
          reflexivity || trivial.
      + destruct (Q_dec (cross (along f) (along e)) 0) as [[low | high] | flat]; [left; lra | right; lra |].
        exfalso. apply turn. unfold cross in *. lra.
  Qed.

  Lemma vertex_sum_is_listed (x v u : vector) : is_vertex v p -> is_vertex u q ->
    equal_vectors x (plus v u) -> ~ interiors_meet x p q -> exists w, In w (vertex_sums p q) /\ equal_vectors x w.
  Proof.
    intros (s & S & equal_v) (t & T & equal_u) equal_x outside. set (w := plus (source s) (source t)).
    assert (equal : equal_vectors x w) by (unfold w; by_computing).
    exists (reduced_vector w). split; [| transitivity w; [exact equal | symmetry; apply reduced_is]].
    unfold vertex_sums. cbv zeta. fold of_p of_q. set (points := flat_map _ (vertices_of p)).
    assert (W : In (Segment w w) points).
    { unfold points, vertices_of. apply in_flat_map. exists (source s). split; [now apply in_map |].
      apply in_map_iff. exists (source t). split; [reflexivity | now apply in_map]. }
    apply in_map_iff. exists (Segment w w). split; [reflexivity |]. apply filter_In. split; [exact W |].
    assert (found : is_in_parts 0 (uncovered_parts (common_multiple (denominators (points ++ of_p ++ of_q)))
      (sums_of_edges (common_multiple (denominators (points ++ of_p ++ of_q))) of_p of_q) (Segment w w)) = true).
    { apply (not_meeting_is_uncovered points (Segment w w) 0 W); [lra |]. intros meet. apply outside.
      refine (interiors_meet_of_equal p q _ _ _ meet). by_computing. }
    now destruct (uncovered_parts _ _ _).
  Qed.

  Lemma not_meeting_is_on_a_touching_piece (x : vector) (s : segment) : In s touching -> lies_on x s ->
    ~ interiors_meet x p q -> exists e, In e (touching_pieces p q) /\ lies_on x e.
  Proof.
    intros S on outside. pose proof (touching_are_listed p q s S) as listed_.
    pose proof (all_vertex_edge_segments_are_long s listed_) as long.
    destruct (proj2 (cut_returns s (flat_map (intersection s) all) long) x on) as (piece & I & part_ & on_piece).
    exists (undirected piece).
    split; [| exact (lies_on_of_one_place _ _ x (of_one_place_sym _ _ (undirected_place piece)) on_piece)].
    unfold touching_pieces. apply in_flat_map. exists s. split; [exact S |]. apply in_map.
    fold touching all of_p of_q. set (d := common_multiple _). unfold uncovered_pieces_among. rewrite quick_cut_is.
    assert (some : exists w, In w [source piece; middle piece; target piece] /\ lies_on w piece /\
      ~ interiors_meet w p q).
    { destruct (inside_or_end x piece on_piece) as [inside_ | [equal | equal]];
        [exists (middle piece) | exists (source piece) | exists (target piece)]; (split; [cbn; tauto |]).
      - split; [apply strictly_inside_lies_on, middle_is_inside |]. intros meet. apply outside.
        apply (meeting_is_the_same_inside s piece (middle piece)); trivial. apply middle_is_inside.
      - split; [apply source_lies_on |]. intros meet. exact (outside (interiors_meet_of_equal p q _ x equal meet)).
      - split; [apply target_lies_on |]. intros meet. exact (outside (interiors_meet_of_equal p q _ x equal meet)). }
    destruct some as (w & W & on_w & outside_w).
    destruct (fraction_on s w long (part_lies_on piece s w part_ on_w)) as (range & X & Y).
    assert (uncovered : is_in_parts (fraction s w) (uncovered_parts d (sums_of_edges d of_p of_q) s) = true).
    { apply (not_meeting_is_uncovered touching s _ S range). intros meet. apply outside_w.
      refine (interiors_meet_of_equal p q _ _ _ meet). split; cbn [point_at vx vy]; now symmetry. }
    destruct (uncovered_parts d (sums_of_edges d of_p of_q) s); [discriminate uncovered |].
    apply filter_In. split; [exact I |]. apply existsb_exists. now exists w.
  Qed.

  (* Theorem. Where the interiors do not meet, and x is the sum of a vertex and a point of an edge, it is one of two
     vertices, or on a piece. *)
  Theorem not_meeting_is_on_a_piece (x : vector) (t : segment) : In t all -> lies_on x t -> ~ interiors_meet x p q ->
    (exists w, In w (vertex_sums p q) /\ equal_vectors x w) \/ exists e, In e (touching_pieces p q) /\ lies_on x e.
  Proof.
    intros T on outside. apply in_all in T. destruct T as (a & b & s & f & both & S & F & ->).
    destruct (both_are_valid a b both). pose proof (source_is_vertex a s S) as vertex_s.
    pose proof (proj1 (on_moved_segment x (source s) f) on) as on_f.
    destruct (vertex_or_not (minus x (source s)) b) as [vertex | free]; [left | right].
    - destruct both as [[-> ->] | [-> ->]];
        [apply (vertex_sum_is_listed x (source s) (minus x (source s))) |
         apply (vertex_sum_is_listed x (minus x (source s)) (source s))]; trivial; by_computing.
    - apply (not_meeting_is_on_a_touching_piece x (moved_segment (source s) f)); trivial.
      assert (listed_ : In (moved_segment (source s) f) (touching_segments a b)).
      { apply in_flat_map. exists (source s). split; [now apply in_map |]. apply in_map, filter_In. split; [exact F |].
        apply negb_true_iff, not_true_iff_false. intros across.
        apply outside, (both_meet p q a b x both). now apply (leading_across_meets a b x s f). }
      apply in_app_iff. destruct both as [[-> ->] | [-> ->]]; [now left | now right].
  Qed.
End Pieces.
