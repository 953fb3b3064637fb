(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The boundary of the intersection of two simple polygons, of which no vertex is on an edge of the other, as the rule
   of sides has it (rule_of_sides.v): the pieces that are kept are parts of the edges of the one that are inside the
   other, in their direction. Each starts at a vertex that is inside the other polygon, or where an edge of the one
   leads into the other; and the piece before it ends there along the edge before, or along the edge that is crossed. *)
From Coq Require Import QArith Lqa ZArith Lia Bool List Permutation.
From Oplus Require Import convolution small_numbers neighbourhoods regions meeting_of_segments left_of_an_edge
  simple_chain
  signed_crossings winding_number_of_the_sum theorem_4_2_1 polygons_of_the_thesis beside_a_piece pieces met_pieces
    filling kept_pieces_go_round cut_pieces
  beside_a_vertex rule_of_sides region_of_pieces boolean_operations small_moves
  edges_of_polygons.
Import ListNotations.

Open Scope Q_scope.

Section TwoPolygons.
  Variables a b : list vector.
  Hypothesis a_polygon : simple_polygon a.
  Hypothesis b_polygon : simple_polygon b.
  Hypothesis a_off : vertices_are_off a b.
  Hypothesis b_off : vertices_are_off b a.

  Definition two_families : list (list segment) := [region_edges [a]; region_edges [b]].
  Definition pieces_of_both : list segment := pieces_of (concat two_families).
  Definition kept_boundary : list segment := boundary_by_rule all_positive two_families.

  (* One of the two, and the other. *)
  Inductive one_and_other : list vector -> list vector -> Prop :=
  | FirstOne : one_and_other a b
  | SecondOne : one_and_other b a.

  Lemma other_and_one (c o : list vector) : one_and_other c o -> one_and_other o c.
  Proof. intros []; constructor. Qed.

  Lemma both_polygons (c o : list vector) : one_and_other c o -> simple_polygon c /\ simple_polygon o.
  Proof. intros []; now split. Qed.

  Lemma both_off (c o : list vector) : one_and_other c o -> vertices_are_off c o /\ vertices_are_off o c.
  Proof. intros []; now split. Qed.

  Lemma segments_of_both (s : segment) :
    In s (concat two_families) <-> exists c o, one_and_other c o /\ In s (region_edges [c]).
  Proof.
    split.
    - intros S. apply in_concat in S. destruct S as (l & [<- | [<- | []]] & S);
        [exists a, b | exists b, a]; (split; [constructor | exact S]).
    - intros (c & o & pair_ & S). apply in_concat. exists (region_edges [c]).
      split; [destruct pair_; cbn; tauto | exact S].
  Qed.

  Lemma both_are_closed (l : list segment) : In l two_families -> cycles l.
  Proof. intros [<- | [<- | []]]; apply region_cycles. Qed.

  Lemma both_are_long (s : segment) : In s (concat two_families) -> nonzero (along s).
  Proof.
    intros S. apply segments_of_both in S. destruct S as (c & o & pair_ & S).
    exact (polygon_edges_are_long c (proj1 (both_polygons c o pair_)) s S).
  Qed.

  Let right_ := right_by_rule all_positive two_families.
  Definition two_families_end := rule_ends_at_pieces all_positive two_families both_are_closed both_are_long eq_refl.

  (* Where the two meet, they cross. *)
  Lemma edges_of_both_cross (c o : list vector) (s t : segment) (w : vector) : one_and_other c o ->
    In s (region_edges [c]) -> In t (region_edges [o]) -> lies_on w s -> lies_on w t ->
    strictly_inside w s /\ strictly_inside w t /\ ~ cross (along s) (along t) == 0.
  Proof.
    intros pair_ S T. destruct (both_off c o pair_) as [c_off o_off],
      (both_polygons c o pair_) as [c_polygon o_polygon].
    destruct (edges_of_one c s S) as (i & I & _ & s_source & s_target),
      (edges_of_one o t T) as (j & J & _ & t_source & t_target).
    apply without_ends_they_cross.
    - exact (polygon_edges_are_long c c_polygon s S).
    - exact (polygon_edges_are_long o o_polygon t T).
    - rewrite s_source. exact (c_off i I t T).
    - rewrite s_target. exact (c_off _ (next_in_range i _ I) t T).
    - rewrite t_source. exact (o_off j J s S).
    - rewrite t_target. exact (o_off _ (next_in_range j _ J) s S).
  Qed.

  Lemma all_positive_of_two (c o : list vector) (x : vector) : one_and_other c o ->
    by_rule all_positive two_families x = true <->
    (0 < winding_number x (region_edges [c]))%Z /\ (0 < winding_number x (region_edges [o]))%Z.
  Proof.
    intros pair_. unfold by_rule, all_positive, two_families. cbn [map forallb].
    rewrite !andb_true_iff, !Z.ltb_lt. destruct pair_; tauto.
  Qed.

  Lemma moved_back (w n : vector) (e : Q) : equal_vectors (moved_along w (opposite n) e) (moved_along w n (- e)).
  Proof. unfold equal_vectors, moved_along, opposite. cbn [vx vy]. split; ring. Qed.

  Lemma winding_number_back (w n : vector) (e : Q) (l : list segment) :
    winding_number (moved_along w (opposite n) e) l = winding_number (moved_along w n (- e)) l.
  Proof. destruct (moved_back w n e). now apply winding_number_of_equal. Qed.

  (* What is inside a part of an edge of the one, and on no edge of the other. *)
  Lemma inside_a_piece_is_off (c o : list vector) (f s : segment) (w : vector) : one_and_other c o ->
    directed pieces_of_both f -> In s (region_edges [c]) -> is_part f s -> strictly_inside w f ->
      off w (region_edges [o]).
  Proof.
    intros pair_ D S part inside_ t T on.
    pose proof (strictly_inside_part f s w part inside_) as in_s.
    destruct (edges_of_both_cross c o s t w pair_ S T (strictly_inside_lies_on _ _ in_s) on) as (_ & _ & turn).
    assert (only : met_only_along (concat two_families) f).
    { destruct D as [D | D]; [| rewrite <- (reversed_twice f); apply met_only_along_reversed];
        exact (pieces_are_met_along _ _ (pieces_are_pieces _ both_are_long) _ D). }
    assert (in_all : In t (concat two_families)).
    { apply segments_of_both. exists o, c. split; [now apply other_and_one | exact T]. }
    pose proof (only w t inside_ in_all on) as [at_source at_target].
    destruct (part_is_long f s part (polygon_edges_are_long c (proj1 (both_polygons c o pair_)) s S))
      as (_ & k & K & kx & ky).
    apply turn. apply (Qmult_inj_l _ _ k); [lra |]. unfold area, cross, along, minus in *. cbn [vx vy] in *.
    setoid_replace (k * ((vx (target s) - vx (source s)) * (vy (target t) - vy (source t)) -
      (vy (target s) - vy (source s)) * (vx (target t) - vx (source t))))
      with ((k * (vx (target s) - vx (source s))) * (vy (target t) - vy (source t)) -
      (k * (vy (target s) - vy (source s))) * (vx (target t) - vx (source t))) by ring.
    rewrite <- kx, <- ky. lra.
  Qed.

  (* The winding number of the other beside a point off it. *)
  Lemma beside_is_there (o : list vector) (w n : vector) : off w (region_edges [o]) ->
    eventually (fun e => winding_number (moved_along w n e) (region_edges [o]) = winding_number w (region_edges [o])).
  Proof.
    intros free. destruct (winding_number_near w (region_edges [o]) (region_cycles [o]) free) as (radius & R & near_).
    refine (eventually_implied _ _ _ (small_steps_stay_within radius w n R)). intros e close.
    exact (proj2 (near_ _ close)).
  Qed.

  (* Theorem. Kept is what is part of an edge of the one, in its direction, and inside the other. *)
  Theorem kept_is_inside_the_other (f : segment) : In f kept_boundary <->
    directed pieces_of_both f /\ exists c o s, one_and_other c o /\ In s (region_edges [c]) /\ is_part f s /\
      forall w, strictly_inside w f -> off w (region_edges [o]) /\ (0 < winding_number w (region_edges [o]))%Z.
  Proof.
    set (n := Vector (vy (along f)) (- vx (along f))).
    assert (in_kept : In f kept_boundary <-> directed pieces_of_both f /\ right_ (reversed f) = true /\
      right_ f = false).
    { exact (of_kept (concat two_families) right_ f). }
    rewrite in_kept. clear in_kept.
    assert (sides : directed pieces_of_both f -> forall w, strictly_inside w f ->
      eventually (fun e => by_rule all_positive two_families (moved_along w n e) = right_ f /\
                           by_rule all_positive two_families (moved_along w (opposite n) e) = right_ (reversed f))).
    { intros D w inside_. pose proof (directed_is_long _ (pieces_share_ends _ _ _ two_families_end) f D) as long.
      pose proof (square_positive _ long) as square. apply eventually_and.
      - apply (same_beside_pieces _ _ _ two_families_end f w n D inside_). unfold n, cross, dot in *. cbn [vx vy]. lra.
      - apply (same_beside_pieces _ _ _ two_families_end (reversed f) w (opposite n) (directed_reversed _ _ D)
          (strictly_inside_reversed w f inside_)).
        unfold n, cross, dot, opposite, along, reversed, minus in *. cbn [source target vx vy] in *. lra. }
    assert (middle : strictly_inside (point_at f (1 # 2)) f) by (apply strictly_inside_at; lra).
    split.
    - intros (D & left_in & right_out). split; [exact D |].
      assert (found : exists e s piece, of_one_place f piece /\ In s (concat two_families) /\ is_part piece s /\
        In e pieces_of_both).
      { destruct D as [D | D]; destruct (piece_is _ both_are_long _ D) as (s & piece & S & _ & e_is & part & _);
          pose proof (undirected_place piece) as place_; rewrite <- e_is in place_;
          [exists f, s, piece | exists (reversed f), s, piece]; (split; [| tauto]); trivial.
        unfold of_one_place in *. cbn [reversed source target] in place_. tauto. }
      destruct found as (_ & s & piece & place_ & S & part & _).
      apply segments_of_both in S. destruct S as (c & o & pair_ & S).
      destruct (both_polygons c o pair_) as [c_polygon o_polygon].
      destruct place_ as [[same_source same_target] | [back_source back_target]].
      + assert (f_part : is_part f s).
        { destruct part as (j & k & low & less & high & at_j & at_k). exists j, k.
          split; [exact low |]. split; [exact less |]. split; [exact high |].
          split; [now rewrite same_source | now rewrite same_target]. }
        exists c, o, s. split; [exact pair_ |]. split; [exact S |]. split; [exact f_part |]. intros w inside_.
        pose proof (inside_a_piece_is_off c o f s w pair_ D S f_part inside_) as free. split; [exact free |].
        destruct (some_small _ (eventually_and _ _ (sides D w inside_) (beside_is_there o w (opposite n) free)))
          as (e & _ & [_ left_] & same_number).
        rewrite left_in in left_. apply (all_positive_of_two c o) in left_; [| exact pair_].
        rewrite <- same_number. apply left_.
      + exfalso. set (w := point_at f (1 # 2)) in *.
        assert (in_s : strictly_inside w s).
        { apply (strictly_inside_part piece s w part).
          apply (strictly_inside_of_one_place f); [now right | exact middle]. }
        destruct (part_is_long piece s part (polygon_edges_are_long c c_polygon s S)) as (_ & k & K & kx & ky).
        pose proof (directed_is_long _ (pieces_share_ends _ _ _ two_families_end) f D) as long.
        pose proof (square_positive _ long) as square.
        assert (left_ : 0 < cross (along s) n).
        { destruct back_source as [X Y], back_target as [X' Y'].
          assert (fx : vx (along f) == - (k * vx (along s))) by (rewrite <- kx; unfold along, minus; cbn [vx]; lra).
          assert (fy : vy (along f) == - (k * vy (along s))) by (rewrite <- ky; unfold along, minus; cbn [vy]; lra).
          assert (k * cross (along s) n == dot (along f) (along f)).
          { unfold n, cross, dot. cbn [vx vy]. rewrite fx, fy. ring. }
          destruct (Qlt_le_dec 0 (cross (along s) n)); [assumption | nra]. }
        destruct (some_small _ (eventually_and _ _ (sides D w middle) (beside_an_edge c c_polygon s w n S in_s left_)))
          as (e & _ & [_ left_of_f] & _ & none).
        rewrite left_in in left_of_f. apply (all_positive_of_two c o) in left_of_f; [| exact pair_].
        rewrite winding_number_back, none in left_of_f. lia.
    - intros (D & c & o & s & pair_ & S & part & inside_other). split; [exact D |].
      destruct (both_polygons c o pair_) as [c_polygon o_polygon]. set (w := point_at f (1 # 2)) in *.
      destruct (inside_other w middle) as [free some].
      pose proof (strictly_inside_part f s w part middle) as in_s.
      destruct (part_is_long f s part (polygon_edges_are_long c c_polygon s S)) as (long & k & K & kx & ky).
      pose proof (square_positive _ long) as square.
      assert (left_ : 0 < cross (along s) (opposite n)).
      { assert (k * cross (along s) (opposite n) == dot (along f) (along f)).
        { unfold n, cross, dot, opposite. cbn [vx vy]. rewrite kx, ky. ring. }
        destruct (Qlt_le_dec 0 (cross (along s) (opposite n))); [assumption | nra]. }
      destruct (some_small _ (eventually_and _ _ (eventually_and _ _ (sides D w middle)
        (beside_an_edge c c_polygon s w (opposite n) S in_s left_)) (beside_is_there o w (opposite n) free)))
        as (e & _ & [[at_right at_left] [one none]] & same_number).
      rewrite <- winding_number_back in none.
      assert (back : winding_number (moved_along w (opposite (opposite n)) e) (region_edges [c]) =
        winding_number (moved_along w n e) (region_edges [c])).
      { apply winding_number_of_equal; unfold moved_along, opposite; cbn [vx vy]; ring. }
      rewrite back in none. split.
      + rewrite <- at_left. apply (all_positive_of_two c o); [exact pair_ |]. rewrite one, same_number.
        split; [lia | exact some].
      + rewrite <- at_right. apply not_true_iff_false. intros all.
        apply (all_positive_of_two c o) in all; [| exact pair_].
        rewrite none in all. lia.
  Qed.
End TwoPolygons.
