(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The loops of the boundary: chains of the pieces of the convolution that have the sum on their left only, found by
   walks that turn clockwise most, and cut where they pass a point twice (sum_is_right.v, written_regions.v). They are
   simple chains that do not cross, and the boundary of the sum is what is on them. All segments of the convolution that
   have a point inside one of their edges go all along it, and in its direction: most points of the edge are no sums of
   two vertices, and there the sum is to the left of what passes (lemma_3_1_2.v), while the edge has no point of the
   sum on its right. So chains may touch. *)
From Coq Require Import QArith Qminmax Lqa ZArith Lia Bool List Permutation.
From Oplus Require Import regions_and_sums secants simple_chain valid_components edges_of_valid_regions theorem_2_2_10
  theorem_2_2_6 theorem_2_3_2 inside_a_corner reduced_convolution lemma_3_1_2 pieces met_pieces naive_collision
  collision_is_sound beside_a_piece filling kept_pieces_go_round cut_pieces rule_of_sides beside_a_vertex
  region_of_pieces walks canonical_regions specification_bridge nested_chains nested_polygons
  valid_regions_are_accepted written_rings written_regions sum_is_right rings_that_do_not_cross.
Import ListNotations.

Open Scope Q_scope.

(* A point inside a segment that is none of finitely many. *)
Lemma point_inside_but_for (e : segment) (points : list vector) : nonzero (along e) ->
  exists x, strictly_inside x e /\ forall v, In v points -> ~ equal_vectors x v.
Proof.
  intros long.
  destruct (some_small _ (eventually_and _ _ (eventually_below 1 ltac:(lra)) (eventually_for_all (fun v d =>
    ~ equal_vectors (moved_along (source e) (along e) d) v) points
    (fun v _ => leaves_a_point (source e) (along e) v long)))) as (d & _ & range & differ).
  exists (moved_along (source e) (along e) d). split; [| exact differ]. exists d. split; [exact range |].
  unfold moved_along, along, minus. cbn [vx vy]. split; ring.
Qed.

Definition sums_of_vertices (p q : region) : list vector :=
  map (fun ends => plus (source (fst ends)) (source (snd ends))) (list_prod (region_edges p) (region_edges q)).

Lemma no_sum_of_vertices (p q : region) (x w u : vector) :
  (forall v, In v (sums_of_vertices p q) -> ~ equal_vectors x v) -> equal_vectors x (plus w u) ->
  is_vertex u q -> ~ is_vertex w p.
Proof.
  intros differ [X Y] (t & T & [tx ty]) (s & S & [sx sy]). apply (differ (plus (source s) (source t))).
  - apply in_map_iff. exists (s, t). split; [reflexivity | now apply in_prod].
  - unfold plus in *. split; cbn [vx vy] in *; lra.
Qed.

(* What covers a point that is no sum of two vertices passes there. *)
Lemma segments_pass_but_at_vertices (p q : region) (x : vector) (s : segment) :
  In s (convolution_segments p q) -> lies_on x s -> (forall v, In v (sums_of_vertices p q) -> ~ equal_vectors x v) ->
  exists d, passes x d p q /\ equal_vectors d (along s).
Proof.
  assert (one : forall p q a b i j, In a p -> In b q -> (i < length a)%nat -> (j < length b)%nat ->
    (forall v, In v (sums_of_vertices p q) -> ~ equal_vectors x v) ->
    lies_on x (Segment (plus (nth i a nowhere) (nth j b nowhere))
                       (plus (nth (next i (length a)) a nowhere) (nth j b nowhere))) ->
    edge_passes x (along (edge_at a i)) p q).
  { intros p' q' a b i j A B I J differ (k & range & X & Y). cbn [source target] in X, Y.
    assert (vertex_j : is_vertex (nth j b nowhere) q').
    { exists (edge_at b j). split; [now apply edge_at_in_region |]. rewrite edge_at_is by exact J. reflexivity. }
    set (w := minus x (nth j b nowhere)).
    assert (sum_ : equal_vectors x (plus w (nth j b nowhere))) by (unfold w, plus, minus; split; cbn [vx vy]; ring).
    exists (edge_at a i), w, (nth j b nowhere). split; [now apply edge_at_in_region |]. split.
    - exists k. rewrite edge_at_is by exact I. cbn [source target]. split; [exact range |].
      unfold w, plus, minus in *. cbn [vx vy] in *. rewrite X, Y. split; ring.
    - split; [exact (no_sum_of_vertices p' q' x w _ differ sum_ vertex_j) |].
      split; [| split; [exact sum_ | reflexivity]].
      right. destruct vertex_j as (t & T & equal). exists t. split; [exact T |].
      apply (lies_on_equal (source t)); [now symmetry | apply source_lies_on]. }
  assert (turned : (forall v, In v (sums_of_vertices p q) -> ~ equal_vectors x v) ->
    forall v, In v (sums_of_vertices q p) -> ~ equal_vectors x v).
  { intros differ v V equal. apply in_map_iff in V. destruct V as ([f e] & <- & I). apply in_prod_iff in I.
    apply (differ (plus (source e) (source f))).
    - apply in_map_iff. exists (e, f). split; [reflexivity | apply in_prod_iff; tauto].
    - destruct equal as [X Y]. unfold plus in *. cbn [fst snd vx vy] in *. split; cbn [vx vy]; lra. }
  intros S on differ. destruct (convolution_segment_is p q s S) as (a & b & i & j & A & B & I & J & [-> | ->]).
  - exists (along (edge_at a i)). split; [left; now apply (one p q a b i j) |].
    rewrite edge_at_is by exact I. unfold along, plus, minus. cbn [source target vx vy]. split; cbn [vx vy]; ring.
  - exists (along (edge_at b j)). split.
    + right. apply (one q p b a j i); auto. refine (lies_on_of_equal x x _ _ _ _ _ _ _ on); [reflexivity | |];
        unfold plus; split; cbn [vx vy]; ring.
    + rewrite edge_at_is by exact J. unfold along, plus, minus. cbn [source target vx vy]. split; cbn [vx vy]; ring.
Qed.

(* Some segments of the convolution, all of the reduced one among them, and those of their pieces that are kept: loops
   of these, of which the points are those of the sum. *)
Record loops_of_the_sum (p q : region) (segments kept : list segment) (loops : region) : Prop := {
  of_the_convolution : incl segments (convolution_segments p q);
  with_the_reduced_ones : incl (reduced_convolution p q) segments;
  kept_share_ends_only : share_ends_only kept;
  kept_are_pieces : forall e, In e kept -> directed (pieces_of segments) e;
  loops_take_kept : Permutation (region_edges loops) kept;
  loops_are_valid : valid_region loops /\ nowhere_above_one loops;
  loops_fill_the_sum : forall x, in_region x loops <-> in_sum x p q }.

Section Boundary.
  Variables p q : region.
  Hypothesis p_region : valid_region p.
  Hypothesis q_region : valid_region q.
  Variables segments kept : list segment.
  Variable loops : region.
  Hypothesis loops_ : loops_of_the_sum p q segments kept loops.

  Let parts := kept_share_ends_only _ _ _ _ _ loops_.
  Let edges_are := loops_take_kept _ _ _ _ _ loops_.
  Let fills := loops_fill_the_sum _ _ _ _ _ loops_.

  Lemma segments_are_long (t : segment) : In t segments -> nonzero (along t).
  Proof. intros T. apply (all_are_long p q p_region q_region), (of_the_convolution _ _ _ _ _ loops_), T. Qed.

  Lemma kept_are_edges (e : segment) : In e kept <-> In e (region_edges loops).
  Proof. split; apply Permutation_in; [exact (Permutation_sym edges_are) | exact edges_are]. Qed.

  (* What is not on the loops is an inner point, or outside. *)
  Lemma off_the_loops_of_segments (x : vector) : off x (region_edges loops) ->
    inner_point_of_sum x p q \/ exists radius, 0 < radius /\ forall y, within radius x y -> ~ in_sum y p q.
  Proof.
    intros free. destruct (winding_number_near x _ (region_cycles loops) free) as (r1 & R1 & near).
    destruct (Z_lt_le_dec 0 (winding_number x (region_edges loops))) as [some | none]; [left | right].
    - exists r1. split; [exact R1 |]. intros y close. apply fills. left.
      now destruct (near y close) as [_ ->].
    - exists r1. split; [exact R1 |]. intros y close in_. apply fills in in_.
      destruct (near y close) as [free_y same]. destruct in_ as [some | (s & S & on)]; [lia | exact (free_y s S on)].
  Qed.

  (* Theorem. The boundary is what is on the loops. *)
  Theorem boundary_is_kept (x : vector) :
    on_boundary_of_sum x p q <-> exists e, In e kept /\ lies_on x e.
  Proof.
    split.
    - intros boundary. destruct (on_or_off x (region_edges loops)) as [(e & E & on) | free];
        [exists e; split; [now apply kept_are_edges | exact on] | exfalso].
      destruct (off_the_loops_of_segments x free) as [inner | (radius & R & none)].
      + exact (inner_points_are_not_on_the_boundary p q x inner boundary).
      + destruct (boundary radius R) as [(y & close & in_) _]. exact (none y close in_).
    - intros (e & E & on) radius R. apply kept_are_edges in E.
      destruct (loops_are_valid _ _ _ _ _ loops_) as [valid above]. split.
      + exists x. split; [unfold within; lra |]. apply fills. right. exists e. now split.
      + destruct (outside_is_near loops x e radius valid above E on R) as (y & close & free & none).
        exists y. split; [exact close |]. rewrite <- fills.
        intros [some | (s & S & on_s)]; [lia | exact (free s S on_s)].
  Qed.

  Lemma no_vertex_inside_kept (e : segment) (x : vector) : In e kept -> strictly_inside x e ->
    ~ is_vertex x loops.
  Proof.
    intros E inside_ (f & F & equal). apply kept_are_edges in F. destruct (segment_dec e f) as [<- | other].
    - exact (proj1 (ends_are_not_inside e x (are_long _ parts e E) inside_) equal).
    - apply (nothing_inside _ parts e f x E F other); [| exact inside_].
      apply (lies_on_equal (source f)); [now symmetry | apply source_lies_on].
  Qed.

  Lemma nothing_right_of_kept (e : segment) (x : vector) : In e kept -> strictly_inside x e ->
    complement_to_the_right x (along e) p q.
  Proof.
    intros E inside_. destruct (loops_are_valid _ _ _ _ _ loops_) as [valid above].
    pose proof (strictly_inside_lies_on _ _ inside_) as on.
    destruct (inside_beside_an_edge loops e x valid above (proj1 (kept_are_edges e) E) on (no_vertex_inside_kept e x E
      inside_)) as (radius & R & near).
    exists ((1 # 2) * radius). split; [lra |]. intros y close right_ in_. apply fills in in_.
    assert (area_y : area e y < 0) by (rewrite (area_from x y e on); exact right_).
    destruct (some_small _ (in_front_near (Vector (- vy (along e)) (vx (along e))) (source e) y
      ltac:(unfold in_front, dot; in_coordinates; lra))) as (d & some & stays).
    destruct valid as (points_ & numbers & meet).
    destruct (inside_near loops y (Qmin d ((1 # 2) * radius)) (regions_are_regular _ points_ numbers meet) in_)
      as (z & close_z & in_z).
    { apply Q.min_glb_lt; lra. }
    assert (near_z : within radius x z).
    { pose proof (Q.le_min_r d ((1 # 2) * radius)). unfold within in *. lra. }
    apply (near z near_z) in in_z.
    specialize (stays z (within_smaller _ _ _ _ (Q.le_min_l d ((1 # 2) * radius)) close_z)).
    unfold in_front, dot in stays. in_coordinates. lra.
  Qed.

  (* Theorem. A segment that has a point inside an edge of a loop goes all along it, in its direction. *)
  Theorem segments_along_kept (e t : segment) (x : vector) : In e kept -> In t segments ->
    strictly_inside x e -> lies_on x t ->
    (forall y, lies_on y e -> lies_on y t) /\ same_direction (along e) (along t).
  Proof.
    intros E T inside_ on. pose proof (segments_are_long t T) as long_t.
    pose proof (are_long _ parts e E) as long_e.
    destruct (proj2 (cut_returns t (flat_map (intersection t) segments) long_t) x on) as (piece & P & part & on_piece).
    pose proof (kept_are_pieces _ _ _ _ _ loops_ e E) as D.
    assert (listed : In (undirected piece) (pieces_of segments)).
    { apply nodup_In, in_flat_map. exists t. split; [exact T | now apply in_map]. }
    assert (on_undirected : lies_on x (undirected piece))
      by exact (lies_on_of_one_place _ _ _ (of_one_place_sym _ _ (undirected_place piece)) on_piece).
    assert (place_ : of_one_place e piece).
    { destruct D as [D | D].
      - rewrite (inside_one_piece segments segments_are_long e (undirected piece) x D listed inside_ on_undirected).
        apply undirected_place.
      - rewrite <- (reversed_twice e), (inside_one_piece segments segments_are_long (reversed e) (undirected piece) x D
          listed
          (strictly_inside_reversed _ _ inside_) on_undirected).
        destruct (undirected_place piece) as [[a b] | [a b]]; [right | left]; cbn [reversed source target]; tauto. }
    assert (covers_ : forall y, lies_on y e -> lies_on y t)
      by (intros y on_y; exact (part_lies_on piece t y part (lies_on_of_one_place _ _ y place_ on_y))).
    split; [exact covers_ |].
    destruct (point_inside_but_for e (sums_of_vertices p q) long_e) as (y & in_e & differ).
    destruct (segments_pass_but_at_vertices p q y t (of_the_convolution _ _ _ _ _ loops_ t T) (covers_ y
      (strictly_inside_lies_on _ _ in_e)) differ)
      as (d & passing & [dx dy]).
    destruct (boundary_edges_have_the_direction_of_segments p q y d (along e) p_region q_region long_e
      (nothing_right_of_kept e y E in_e) passing) as [parallel ahead_].
    apply same_direction_symmetric. destruct (multiple_of (along t) (along e) long_e) as (c & X & Y).
    { unfold cross in *. rewrite <- dx, <- dy. lra. }
    exists c. split; [| now split]. pose proof (square_positive _ long_e) as square. unfold dot in *.
    rewrite dx, dy, X, Y in ahead_. apply Qnot_le_lt. intros none. nra.
  Qed.

  (* Theorem. A segment of the reduced convolution does. *)
  Theorem reduced_segment_along_kept (e : segment) : In e kept ->
    exists t, In t (reduced_convolution p q) /\ (forall y, lies_on y e -> lies_on y t) /\
      same_direction (along e) (along t).
  Proof.
    intros E. pose proof (middle_is_inside e) as inside_.
    destruct (boundary_is_part_of_the_reduced_convolution p q (middle e) p_region q_region) as (t & T & on).
    { apply boundary_is_kept. exists e. split; [exact E | now apply strictly_inside_lies_on]. }
    exists t. split; [exact T |].
    exact (segments_along_kept e t (middle e) E (with_the_reduced_ones _ _ _ _ _ loops_ t T) inside_ on).
  Qed.
End Boundary.

(* The loops of the boundary of the sum. *)
Definition boundary_loops (p q : region) : list (list vector) :=
  let kept := filled (convolution_segments p q) in rings_in_order (chains_of (length kept) kept).

Section Sum.
  Variables p q : region.
  Hypothesis p_region : valid_region p.
  Hypothesis q_region : valid_region q.

  Let segments := convolution_segments p q.
  Let loops := boundary_loops p q.
  Let all_long := all_are_long p q p_region q_region.
  Let ends_ := filled_ends_at_pieces segments all_long (all_are_closed p q p_region q_region).
  Let kept_are := Permutation_refl (filled segments).

  Lemma boundary_loops_do_not_cross : do_not_cross loops.
  Proof. exact (rings_do_not_cross segments _ _ ends_ (filled segments) kept_are). Qed.

  (* Theorem. *)
  Theorem boundary_loops_are_loops_of_the_sum : loops_of_the_sum p q segments (filled segments) loops.
  Proof.
    assert (edges_are : Permutation (region_edges loops) (filled segments))
      by exact (rings_take_kept segments _ _ ends_ (filled segments) kept_are).
    split.
    - apply incl_refl.
    - intros s. apply reduced_is_part_of_the_convolution.
    - exact (kept_parts segments _ _ ends_ (filled segments) kept_are).
    - intros e E. exact (proj1 (proj1 (of_kept segments _ e) E)).
    - exact edges_are.
    - exact (rings_are_valid segments _ _ ends_ (filled segments) kept_are).
    - exact (points_of_the_sum p q loops p_region q_region edges_are).
  Qed.

  Let loops_ := boundary_loops_are_loops_of_the_sum.

  Lemma filled_are_edges (e : segment) : In e (region_edges loops) <-> In e (filled segments).
  Proof. symmetry. exact (kept_are_edges p q _ _ loops loops_ e). Qed.

  Lemma off_the_loops (x : vector) : off x (region_edges loops) ->
    inner_point_of_sum x p q \/ exists radius, 0 < radius /\ forall y, within radius x y -> ~ in_sum y p q.
  Proof. exact (off_the_loops_of_segments p q _ _ loops loops_ x). Qed.

  (* Theorem. The boundary is what is on the loops. *)
  Theorem boundary_is_on_the_loops (x : vector) :
    on_boundary_of_sum x p q <-> exists e, In e (region_edges loops) /\ lies_on x e.
  Proof. setoid_rewrite filled_are_edges. exact (boundary_is_kept p q _ _ loops loops_ x). Qed.

  Lemma inside_no_vertex (e : segment) (x : vector) : In e (region_edges loops) -> strictly_inside x e ->
    ~ is_vertex x loops.
  Proof. intros E. exact (no_vertex_inside_kept p q _ _ loops loops_ e x (proj1 (filled_are_edges e) E)). Qed.

  (* Theorem. A segment of the convolution that has a point inside an edge of a loop goes all along it, in its
     direction. *)
  Theorem segments_along_the_loops (e t : segment) (x : vector) : In e (region_edges loops) -> In t segments ->
    strictly_inside x e -> lies_on x t ->
    (forall y, lies_on y e -> lies_on y t) /\ same_direction (along e) (along t).
  Proof.
    intros E. exact (segments_along_kept p q p_region q_region _ _ loops loops_ e t x (proj1 (filled_are_edges e) E)).
  Qed.

  (* Theorem. A segment of the reduced convolution does. *)
  Theorem reduced_segment_along_the_loops (e : segment) : In e (region_edges loops) ->
    exists t, In t (reduced_convolution p q) /\ (forall y, lies_on y e -> lies_on y t) /\
      same_direction (along e) (along t).
  Proof.
    intros E.
    exact (reduced_segment_along_kept p q p_region q_region _ _ loops loops_ e (proj1 (filled_are_edges e) E)).
  Qed.
End Sum.
