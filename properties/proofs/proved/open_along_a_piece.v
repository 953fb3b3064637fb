(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The sums of a vertex and an edge, cut where they meet (open_sum_program.v): along a piece of them the interiors of
   P and -Q + x meet everywhere or nowhere. What has a point strictly inside a piece runs along all of it, so while x
   moves along the piece, contacts stay (contacts_that_stay.v). And where x is strictly inside such a sum, and no sum
   of two vertices, the interiors can fail to meet only if no edge at the vertex leads across. *)
From Coq Require Import QArith Lqa Qfield ZArith Lia Bool List.
From Oplus Require Import regions_and_sums reflected theorem_2_2_6 boundary_points pieces naive_collision met_pieces
  collision_is_sound collision_is_complete test_of_regions right_of_an_edge filling cut_pieces coordinates contacts
  contacts_that_stay sums_of_two_edges sum_of_uncovered_pieces open_sum_program.
Import ListNotations.

Open Scope Q_scope.

Lemma on_moved_segment (x v : vector) (s : segment) : lies_on x (moved_segment v s) <-> lies_on (minus x v) s.
Proof.
  unfold moved_segment. split; intros (t & range & on); exists t; (split; [exact range |]); destruct on; by_computing.
Qed.

(* P and Q, in one order or the other. *)
Definition are_both (p q a b : region) : Prop := a = p /\ b = q \/ a = q /\ b = p.

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

Lemma in_touching (p q : region) (t : segment) : In t (touching_segments p q ++ touching_segments q p) <->
  exists a b s f, are_both p q a b /\ In s (region_edges a) /\ In f (region_edges b) /\
    leads_across a f (source s) = false /\ t = moved_segment (source s) f.
Proof.
  unfold touching_segments, vertices_of. rewrite in_app_iff, !in_flat_map. setoid_rewrite in_map_iff.
  setoid_rewrite filter_In. setoid_rewrite negb_true_iff. split.
  - intros [(v & (s & <- & S) & f & <- & F) | (v & (s & <- & S) & f & <- & F)];
      [exists p, q, s, f | exists q, p, s, f]; unfold are_both; tauto.
  - intros (a & b & s & f & [[-> ->] | [-> ->]] & S & F & no & ->); [left | right]; exists (source s); split; eauto.
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

Lemma off_listed_is (p q : region) (x : vector) : off x (all_vertex_edge_segments p q) -> off_vertex_edge_sum x p q.
Proof.
  intros free e f E F.
  assert (none : ~ on_vertex_edge_sum x p q) by (rewrite <- on_listed_is; intros (t & T & on); exact (free t T on)).
  repeat split; intros on; apply none;
    [left; exists (source e), f | left; exists (target e), f |
     right; exists (source f), e | right; exists (target f), e]; auto using source_is_vertex, target_is_vertex.
Qed.

(* A point w of a, and u inside an edge of -b + x at w: a leads into it from w. *)
Lemma a_step_inside (a b : region) (x w u d : vector) (f : segment) (bound : Q) : valid_region a -> valid_region b ->
  In f (region_edges b) -> lies_on u f -> ~ is_vertex u b -> equal_vectors x (plus w u) -> cross (along f) d < 0 ->
  0 < bound -> (forall t, 0 < t < bound -> in_region (moved_along w d t) a) -> interiors_meet x a b.
Proof.
  intros a_region b_region F on free equal right_ some along_d. pose proof b_region as (_ & b_valid & b_meet).
  assert (left_ : 0 < cross (along f) (opposite d)) by (unfold cross, opposite in *; cbn [vx vy]; lra).
  destruct (some_small _ (eventually_and _ _ (left_of_an_edge_is_inside b f u _ b_valid b_meet F on free left_)
    (eventually_below bound some))) as (t & _ & inside_b & range).
  apply interiors_meet_other_way, (inner_point_and_point b a x (moved_along u (opposite d) t) (moved_along w d t));
    [now apply valid_is_regular | exact inside_b | now apply along_d | by_computing].
Qed.

(* Where an edge leads across, the interiors meet. *)
Lemma leading_across_meets (a b : region) (x : vector) (s f : segment) : valid_region a -> valid_region b ->
  In f (region_edges b) -> leads_across a f (source s) = true -> lies_on (minus x (source s)) f ->
  ~ is_vertex (minus x (source s)) b -> interiors_meet x a b.
Proof.
  intros a_region b_region F across on free.
  assert (found : forall d, cross (along f) d < 0 ->
    (forall t, 0 < t < 1 -> in_region (moved_along (source s) d t) a) -> interiors_meet x a b).
  { intros d right_. apply (a_step_inside a b x (source s) (minus x (source s)) d f 1); trivial;
      [by_computing | lra]. }
  apply existsb_exists in across. destruct across as (e & E & either).
  rewrite orb_true_iff, !andb_true_iff, <- !(reflect_iff _ _ (same_point_spec _ _)),
    <- !(reflect_iff _ _ (negative_spec _)) in either.
  destruct either as [[equal right_] | [equal left_]].
  - apply (found (along e) right_). intros t range. right. exists e. split; [exact E | at_fraction t].
  - apply (found (opposite (along e))); [unfold cross, opposite in *; cbn [vx vy]; lra |]. intros t range.
    right. exists e. split; [exact E | at_fraction (1 - t)].
Qed.

(* Inside the sum of two edges the interiors meet: beside the point where they cross, a point of the edge of P is
   inside -Q + x. *)
Lemma inside_a_sum_of_two_meets (p q : region) (e f : segment) (x a b : vector) : valid_region p -> valid_region q ->
  In e (region_edges p) -> In f (region_edges q) -> clear_edge q f ->
  (a = along e /\ b = along f \/ a = along f /\ b = along e) ->
  is_inside_the_sum_of_two (plus (source e) (source f)) a b x -> interiors_meet x p q.
Proof.
  intros p_region q_region E F clear_ sides inside_.
  assert (turn : ~ cross (along f) (along e) == 0)
    by (destruct inside_ as (i1 & i2 & _); destruct sides as [[-> ->] | [-> ->]]; unfold cross in *; lra).
  assert (found : forall g h, 0 < g < 1 -> 0 < h < 1 -> equal_vectors x (plus (point_at e g) (point_at f h)) ->
    interiors_meet x p q).
  { intros g h g_range h_range equal.
    assert (on_f : lies_on (point_at f h) f) by (apply point_at_lies_on; lra).
    assert (free : ~ is_vertex (point_at f h) q) by (apply (clear_ h); [exact h_range | reflexivity ..]).
    destruct (Q_dec (cross (along f) (along e)) 0) as [[low | high] | flat]; [| | contradiction].
    - apply (a_step_inside p q x _ _ (along e) f (1 - g) p_region q_region F on_f free equal low); [lra |].
      intros t range. right. exists e. split; [exact E |]. at_fraction (g + t).
    - apply (a_step_inside p q x _ _ (opposite (along e)) f g p_region q_region F on_f free equal);
        [clear - high; unfold cross, opposite in *; cbn [vx vy]; lra | lra |].
      intros t range. right. exists e. split; [exact E |]. at_fraction (g - t). }
  destruct (as_sum_of_points _ a b x inside_) as (g & h & g_range & h_range & X & Y). clear inside_ turn.
  destruct sides as [[-> ->] | [-> ->]]; [apply (found g h) | apply (found h g)]; trivial; by_computing.
Qed.

Lemma interiors_meet_all_near (p q : region) (x : vector) : interiors_meet x p q ->
  exists radius, 0 < radius /\ forall y, within radius x y -> interiors_meet y p q.
Proof.
  intros (z & in_p & [free positive_]).
  destruct (winding_number_near _ _ (region_cycles q) free) as (radius & R & near). exists radius. split; [exact R |].
  intros y close. exists z. split; [exact in_p |].
  destruct (near (minus y z)) as [free_y same_number]; [by_computing |]. split; [exact free_y | lia].
Qed.

Lemma within_of_equal (radius : Q) (x y : vector) : 0 < radius -> equal_vectors x y -> within radius x y.
Proof. intros R equal. by_computing. Qed.

Lemma interiors_meet_of_equal (p q : region) (x y : vector) :
  equal_vectors x y -> interiors_meet x p q -> interiors_meet y p q.
Proof.
  intros equal meet. destruct (interiors_meet_all_near p q x meet) as (radius & R & near).
  now apply near, within_of_equal.
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

  Lemma touching_are_listed : incl touching all.
  Proof.
    intros t T. apply in_touching in T. destruct T as (a & b & s & f & facts). apply in_all. exists a, b, s, f. tauto.
  Qed.

  Lemma touching_piece_is (e : segment) : In e (touching_pieces p q) -> exists s piece, In s all /\
    In piece (cut_where_met s all) /\ of_one_place e piece /\ nonzero (along s) /\ is_part piece s /\ nonzero (along e).
  Proof.
    intros E. unfold touching_pieces in E. apply in_flat_map in E. destruct E as (s & S & E).
    apply in_map_iff in E. destruct E as (piece & <- & I). exists s, piece. apply touching_are_listed in S.
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
    assert (stays : forall a b v w u f, are_both p q a b -> lies_on v (Segment y z) -> lies_on w (Segment y z) ->
      is_vertex u a -> In f (region_edges b) -> lies_on (minus v u) f -> lies_on (minus w u) f).
    { intros a b v w u f both V W (t & T & equal) F on.
      assert (same : forall x, equal_vectors (minus x u) (minus x (source t))) by (intros x; by_computing).
      assert (listed : In (moved_segment (source t) f) all) by (apply in_all; now exists a, b, t, f).
      apply (lies_on_equal _ _ _ (symmetry (same w))), on_moved_segment.
      apply (runs_along_the_piece s all piece _ v w); auto; [now apply all_vertex_edge_segments_are_long |].
      apply on_moved_segment. exact (lies_on_equal _ _ _ (same v) on). }
    apply (meeting_stays p q (Segment y z)); trivial;
      [| exact (source_lies_on (Segment y z)) | exact (target_lies_on (Segment y z))].
    split; [intros v w u f; apply (stays p q); now left |
      intros v w e u V W E U; apply (stays q p); trivial; now right |].
    intros v u1 u2 V (s1 & S1 & equal_1) (s2 & S2 & equal_2) equal.
    destruct (nothing_meets_a_piece s all piece (moved_segment (source s1) s2) v long I (inside_ v V)) as [no_source _].
    - apply in_all. exists p, q, s1, s2. unfold are_both. tauto.
    - apply no_source. unfold moved_segment. by_computing.
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

  (* Where the interiors do not meet, a segment of a list is not covered. *)
  Lemma not_meeting_is_uncovered (l : list segment) (s : segment) (k : Q) (w : vector) :
    let d := common_multiple (denominators (l ++ of_p ++ of_q)) in
    In s l -> 0 <= k <= 1 -> vx w == (1 - k) * vx (source s) + k * vx (target s) ->
    vy w == (1 - k) * vy (source s) + k * vy (target s) -> ~ interiors_meet w p q ->
    is_in_parts k (uncovered_parts d (sums_of_edges d of_p of_q) s) = true.
  Proof.
    intros d S range X Y outside.
    destruct (is_in_parts_spec k (uncovered_parts d (sums_of_edges d of_p of_q) s)); [reflexivity | exfalso].
    destruct (covered_is_inside_a_sum_of_two of_p of_q d s k w) as [| (e & f & a & b & E & F & sides & inside_)];
      trivial; [| contradiction |].
    - intros t which. apply ends_have_denominator. rewrite !in_app_iff. destruct which as [-> | which]; tauto.
    - apply outside. apply filter_In in F. destruct F as [F clear_].
      apply (inside_a_sum_of_two_meets p q e f w a b); trivial. apply edge_is_clear_is_right; [| exact clear_].
      now apply (region_edges_are_directions q (proj1 q_region)).
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
    assert (found : forall parts, is_in_parts 0 parts = true -> match parts with [] => false | _ => true end = true)
      by (intros [|]; [discriminate | reflexivity]).
    apply found, (not_meeting_is_uncovered points (Segment w w) 0 w W); cbn [source target]; [lra | lra | lra |].
    intros meet. apply outside. now apply (interiors_meet_of_equal p q w).
  Qed.

  Lemma not_meeting_is_on_a_touching_piece (x : vector) (s : segment) : In s touching -> lies_on x s ->
    ~ interiors_meet x p q -> exists e, In e (touching_pieces p q) /\ lies_on x e.
  Proof.
    intros S on outside. pose proof (all_vertex_edge_segments_are_long s (touching_are_listed s S)) as long.
    destruct (proj2 (cut_returns s (flat_map (intersection s) all) long) x on) as (piece & I & part_ & on_piece).
    exists (undirected piece).
    split; [| exact (lies_on_of_one_place _ _ x (of_one_place_sym _ _ (undirected_place piece)) on_piece)].
    unfold touching_pieces. apply in_flat_map. exists s. split; [exact S |]. apply in_map.
    fold touching all of_p of_q. set (d := common_multiple _). unfold uncovered_pieces_among. rewrite quick_cut_is.
    assert (some : exists w, In w [source piece; middle piece; target piece] /\ lies_on w piece /\
      ~ interiors_meet w p q).
    { destruct (inside_or_end x piece on_piece) as [inside_ | [equal | equal]].
      - exists (middle piece). split; [cbn; tauto |]. split; [apply strictly_inside_lies_on, middle_is_inside |].
        intros meet. apply outside. apply (meeting_is_the_same_inside s piece (middle piece)); trivial;
          [now apply touching_are_listed | apply middle_is_inside].
      - exists (source piece). split; [cbn; tauto |]. split; [apply source_lies_on |].
        intros meet. apply outside. now apply (interiors_meet_of_equal p q (source piece)).
      - exists (target piece). split; [cbn; tauto |]. split; [apply target_lies_on |].
        intros meet. apply outside. now apply (interiors_meet_of_equal p q (target piece)). }
    destruct some as (w & W & on_w & outside_w).
    destruct (fraction_on s w long (part_lies_on piece s w long part_ on_w)) as (range & X & Y).
    pose proof (not_meeting_is_uncovered touching s _ w S range X Y outside_w) as uncovered. cbv zeta in uncovered.
    fold d in uncovered. destruct (uncovered_parts d (sums_of_edges d of_p of_q) s); [discriminate uncovered |].
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
      apply in_touching. exists a, b, s, f. repeat split; trivial. apply not_true_iff_false. intros across.
      apply outside, (both_meet p q a b x both). now apply (leading_across_meets a b x s f).
  Qed.
End Pieces.
