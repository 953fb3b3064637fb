(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* From each vertex of the one polygon inside the other, and from each point where an edge of the one leads into the
   other, a kept piece starts (edges_of_the_intersection.v), and one only. *)
From Coq Require Import QArith Lqa ZArith Lia Bool List Permutation.
From Oplus Require Import convolution small_numbers neighbourhoods regions meeting_of_segments left_of_an_edge
  simple_chain
  signed_crossings theorem_4_2_1 polygons_of_the_thesis beside_a_piece pieces met_pieces filling kept_pieces_go_round
  cut_pieces beside_a_vertex rule_of_sides region_of_pieces boolean_operations small_moves edges_of_polygons
  edges_of_the_intersection
  corners_of_the_intersection.
Import ListNotations.

Open Scope Q_scope.

Lemma inside_between (f : segment) (x y z : vector) : strictly_inside x f -> strictly_inside y f ->
  lies_on z (Segment x y) -> strictly_inside z f.
Proof.
  intros (k & k_range & kx & ky) (l & l_range & lx & ly) (t & range & X & Y). cbn [source target] in X, Y.
  exists ((1 - t) * k + t * l). split.
  - split; [apply mixed_is_more | apply mixed_is_less]; lra.
  - rewrite X, Y, kx, ky, lx, ly. split; ring.
Qed.

Lemma collinear_is_parallel (e s : segment) : collinear e s -> cross (along e) (along s) == 0.
Proof. intros [x y]. in_coordinates. lra. Qed.

Section TwoPolygons.
  Variables a b : list vector.
  Hypothesis a_polygon : simple_polygon a.
  Hypothesis b_polygon : simple_polygon b.
  Hypothesis a_off : vertices_are_off a b.
  Hypothesis b_off : vertices_are_off b a.

  Let pair_of := one_and_other a b.
  Let long_ := both_are_long a b a_polygon b_polygon.

  (* No piece ends just after a point. *)
  Lemma no_end_just_after (v d : vector) : nonzero d ->
    eventually (fun e => forall f p, In f (pieces_of_both a b) -> p = source f \/ p = target f ->
      forall h, 0 < h -> h <= e -> ~ equal_vectors p (moved_along v d h)).
  Proof.
    intros some. pose proof (square_positive d some) as square.
    assert (each : forall p, eventually (fun e => forall h, 0 < h -> h <= e -> ~ equal_vectors p (moved_along v d h))).
    { intros p. set (far := dot (minus p v) d / dot d d).
      assert (value : far * dot d d == dot (minus p v) d) by (unfold far; field; lra). clearbody far.
      assert (is_far : forall h, equal_vectors p (moved_along v d h) -> h == far).
      { intros h [X Y]. apply (Qmult_inj_l _ _ (dot d d)); [lra |]. rewrite (Qmult_comm _ far), value.
        unfold moved_along in X, Y. cbn [vx vy] in X, Y. unfold dot, minus. cbn [vx vy]. rewrite X, Y. ring. }
      destruct (Qlt_le_dec 0 far) as [positive_ | not_positive].
      - exists far. split; [exact positive_ |]. intros e _ small h some_h less equal. apply is_far in equal. lra.
      - exists 1. split; [lra |]. intros e _ _ h some_h _ equal. apply is_far in equal. lra. }
    refine (eventually_implied _ _ _ (eventually_and _ _
      (eventually_for_all _ (map source (pieces_of_both a b)) (fun p _ => each p))
      (eventually_for_all _ (map target (pieces_of_both a b)) (fun p _ => each p)))).
    intros e [sources targets] f p F [-> | ->]; [apply sources | apply targets]; now apply in_map.
  Qed.

  Lemma met_along (e s : segment) (w : vector) : In e (pieces_of_both a b) -> In s (concat (two_families a b)) ->
    strictly_inside w e -> lies_on w s -> cross (along e) (along s) == 0.
  Proof.
    intros E S inside_ on. apply collinear_is_parallel.
    exact (pieces_are_met_along _ _ (pieces_are_pieces _ long_) e E w s inside_ S on).
  Qed.

  (* Theorem. *)
  Theorem a_kept_piece_starts (c o : list vector) (s : segment) (v : vector) (j0 : Q) : pair_of c o ->
    In s (region_edges [c]) -> 0 <= j0 < 1 -> equal_vectors v (point_at s j0) ->
    (forall e, In e (pieces_of_both a b) -> ~ strictly_inside v e) ->
    eventually (fun e => (0 < winding_number (moved_along v (along s) e) (region_edges [o]))%Z) ->
    exists f, In f (kept_boundary a b) /\ equal_vectors (source f) v /\ is_part f s.
  Proof.
    intros pair_ S [low high] [vx_is vy_is] end_there goes_in.
    destruct (both_polygons a b a_polygon b_polygon c o pair_) as [c_polygon o_polygon].
    pose proof (polygon_edges_are_long c c_polygon s S) as s_long. pose proof (square_positive _ s_long) as square.
    destruct (some_small _ (eventually_and _ _ (eventually_below (1 - j0) ltac:(lra)) (eventually_and _ _
      (no_end_just_after v (along s) s_long) goes_in))) as (e & _ & [e_some e_less] & no_end & some).
    set (y := moved_along v (along s) e) in *.
    assert (y_is : equal_vectors y (point_at s (j0 + e))).
    { unfold y, equal_vectors, moved_along, point_at, along, minus in *. cbn [vx vy] in *. rewrite vx_is, vy_is.
      split; ring. }
    assert (y_in_s : strictly_inside y s).
    { apply (cut_pieces.strictly_inside_equal (point_at s (j0 + e))); [now symmetry |]. apply strictly_inside_at. lra. }
    assert (s_all : In s (concat (two_families a b))) by (apply segments_of_both; now exists c, o).
    destruct (pieces_are_all _ _ (pieces_are_pieces _ long_) s y s_all (strictly_inside_lies_on _ _ y_in_s))
      as (E & E_piece & on_E).
    assert (y_in_E : strictly_inside y E).
    { destruct (inside_or_end y E on_E) as [inside_ | [equal | equal]]; [exact inside_ | exfalso | exfalso].
      - exact (no_end E _ E_piece (or_introl eq_refl) e e_some (Qle_refl e) equal).
      - exact (no_end E _ E_piece (or_intror eq_refl) e e_some (Qle_refl e) equal). }
    destruct (piece_is _ long_ E E_piece) as (s' & piece & S' & _ & E_is & part & _).
    pose proof (undirected_place piece) as place_. rewrite <- E_is in place_.
    assert (y_in_s' : strictly_inside y s').
    { apply (strictly_inside_part piece s' y part). now apply (strictly_inside_of_one_place E). }
    assert (s'_is : s' = s).
    { pose proof S' as S''. apply segments_of_both in S''. destruct S'' as (c' & o' & pair' & S'').
      assert (c' = c \/ c' = o) as [-> | ->] by (destruct pair_, pair'; tauto).
      - exact (same_edge a b a_polygon b_polygon c o s s' y pair_ S S'' y_in_s (strictly_inside_lies_on _ _ y_in_s')).
      - exfalso. destruct (edges_of_both_cross a b a_polygon b_polygon a_off b_off c o s s' y pair_ S S''
          (strictly_inside_lies_on _ _ y_in_s) (strictly_inside_lies_on _ _ y_in_s')) as (_ & _ & no).
        pose proof (met_along E s y E_piece s_all y_in_E (strictly_inside_lies_on _ _ y_in_s)) as along_s.
        pose proof (met_along E s' y E_piece S' y_in_E (strictly_inside_lies_on _ _ y_in_s')) as along_s'.
        pose proof (are_long _ (pieces_of_share_ends _ long_) E E_piece) as E_long.
        destruct (is_a_multiple (along E) (along s) E_long along_s) as (k & kx & ky).
        apply no. unfold cross in *. rewrite kx, ky. 
        setoid_replace (k * vx (along E) * vy (along s') - k * vy (along E) * vx (along s'))
          with (k * (vx (along E) * vy (along s') - vy (along E) * vx (along s'))) by ring. rewrite along_s'. ring. }
    subst s'.
    assert (found : exists f, directed (pieces_of_both a b) f /\ is_part f s /\ of_one_place f E).
    { destruct part as (j & k & part_low & less & part_high & at_j & at_k).
      destruct place_ as [[x z] | [x z]]; [exists E | exists (reversed E)].
      - split; [now left |]. split; [| left; split; split; reflexivity].
        exists j, k. split; [exact part_low |]. split; [exact less |]. split; [exact part_high |].
        split; [now rewrite x | now rewrite z].
      - split; [right; now rewrite reversed_twice |]. split; [| apply reversed_place].
        exists j, k. split; [exact part_low |]. split; [exact less |]. split; [exact part_high |].
        cbn [reversed source target]. split; [now rewrite z | now rewrite x]. }
    destruct found as (f & f_piece & f_part & f_place).
    assert (y_in_f : strictly_inside y f) by (apply (strictly_inside_of_one_place E);
      [now apply of_one_place_sym | exact y_in_E]).
    assert (starts_there : equal_vectors (source f) v).
    { pose proof f_part as (j & k & part_low & less & part_high & at_j & at_k).
      assert (fraction_of : forall p q, equal_vectors (point_at s p) (point_at s q) -> p == q).
      { intros p q [X Y]. unfold point_at in X, Y. cbn [vx vy] in X, Y.
        apply (Qmult_inj_l _ _ (dot (along s) (along s)));
          [lra |]. unfold dot, along, minus. cbn [vx vy].
        assert (X' : (p - q) * (vx (target s) - vx (source s)) == 0) by lra.
        assert (Y' : (p - q) * (vy (target s) - vy (source s)) == 0) by lra.
        set (u := vx (target s) - vx (source s)) in *. set (w := vy (target s) - vy (source s)) in *. clearbody u w.
        assert ((u * u + w * w) * (p - q) == 0); [| lra].
        setoid_replace ((u * u + w * w) * (p - q)) with (u * ((p - q) * u) + w * ((p - q) * w)) by ring.
        rewrite X', Y'. ring. }
      assert (between_ : j < j0 + e /\ j0 + e < k).
      { destruct y_in_f as (t & t_range & tx & ty). assert (t_is : j0 + e == (1 - t) * j + t * k).
        { apply fraction_of. rewrite <- y_is. destruct at_j as [jx jy], at_k as [kx ky]. unfold point_at in *.
          unfold equal_vectors. cbn [vx vy] in *. rewrite tx, ty, jx, jy, kx, ky. split; ring. }
        rewrite t_is. split; nra. }
      destruct (Q_dec j j0) as [[before_ | after_] | same_].
      - exfalso. apply (end_there E E_piece). apply (strictly_inside_of_one_place f E v f_place).
        exists ((j0 - j) / (k - j)).
        assert (value : (j0 - j) / (k - j) * (k - j) == j0 - j) by (field; lra).
        assert (0 < (j0 - j) / (k - j)) by (apply Qlt_shift_div_l; lra).
        assert ((j0 - j) / (k - j) < 1) by (apply Qlt_shift_div_r; lra).
        set (t := (j0 - j) / (k - j)) in *. clearbody t. split; [lra |].
        destruct at_j as [jx jy], at_k as [kx ky]. unfold point_at in *. cbn [vx vy] in *.
        assert (j0_is : j0 == j + t * (k - j)) by lra. rewrite vx_is, vy_is, jx, jy, kx, ky, j0_is. split; ring.
      - exfalso. assert (moved_there : equal_vectors (source f) (moved_along v (along s) (j - j0))).
        { destruct at_j as [jx jy]. unfold equal_vectors, moved_along, point_at, along, minus in *. cbn [vx vy] in *.
          rewrite jx, jy, vx_is, vy_is. split; ring. }
        destruct f_place as [[x z] | [x z]].
        + apply (no_end E (source E) E_piece (or_introl eq_refl) (j - j0)); [lra | lra |]. now rewrite <- x.
        + apply (no_end E (target E) E_piece (or_intror eq_refl) (j - j0)); [lra | lra |]. now rewrite <- x.
      - destruct at_j as [jx jy]. unfold equal_vectors, point_at in *. cbn [vx vy] in *.
        rewrite jx, jy, vx_is, vy_is, same_. split; reflexivity. }
    exists f. split; [| now split].
    apply (kept_is_inside_the_other a b a_polygon b_polygon a_off b_off). split; [exact f_piece |]. exists c, o, s.
    split; [exact pair_ |]. split; [exact S |]. split; [exact f_part |]. intros w inside_.
    pose proof (fun z I => inside_a_piece_is_off a b a_polygon b_polygon a_off b_off c o f s z pair_ f_piece S f_part
      I) as free.
    split; [exact (free w inside_) |].
    pose proof (winding_number_along (Segment w y) (region_edges [o]) (region_cycles [o])
      (fun z on => free z (inside_between f w y z inside_ y_in_f on))) as same_number.
    cbn [source target] in same_number. now rewrite same_number.
  Qed.

  (* One only: kept pieces along one edge that start at one point are one. *)
  Lemma one_kept_piece_starts (f f' s : segment) : nonzero (along s) ->
    In f (kept_boundary a b) -> In f' (kept_boundary a b) -> is_part f s -> is_part f' s ->
    equal_vectors (source f) (source f') -> f = f'.
  Proof.
    intros long F F' part part' same_. destruct (segment_dec f f') as [| differ]; [assumption | exfalso].
    pose proof (two_families_end a b a_polygon b_polygon) as ends_.
    pose proof (kept_share_ends _ _ _ ends_) as share.
    destruct (some_small _ (eventually_and _ _ (after_the_start f s (source f) part (conj (Qeq_refl _) (Qeq_refl _)))
      (after_the_start f' s (source f) part' ltac:(now symmetry)))) as (e & _ & in_f & in_f').
    exact (nothing_inside _ share f f' _ F F' differ (strictly_inside_lies_on _ _ in_f') in_f).
  Qed.

  (* Theorem. From a vertex inside the other polygon. *)
  Theorem a_piece_starts_at_a_vertex (c o : list vector) (i : nat) : pair_of c o -> (i < length c)%nat ->
    (0 < winding_number (vertex c i) (region_edges [o]))%Z ->
    exists f, In f (kept_boundary a b) /\ equal_vectors (source f) (vertex c i) /\ is_part f (edge_at c i).
  Proof.
    intros pair_ I some. destruct (both_polygons a b a_polygon b_polygon c o pair_) as [c_polygon o_polygon].
    destruct (both_off a b a_off b_off c o pair_) as [c_off o_off].
    assert (S : In (edge_at c i) (region_edges [c])) by (apply edge_at_in_region; [now left | exact I]).
    apply (a_kept_piece_starts c o (edge_at c i) (vertex c i) 0 pair_ S); [lra | | |].
    - rewrite edge_is by exact I. unfold equal_vectors, point_at. cbn [source target vx vy]. split; ring.
    - intros E E_piece inside_. destruct (piece_is _ long_ E E_piece) as (s' & piece & S' & _ & E_is & part & _).
      pose proof (undirected_place piece) as place_. rewrite <- E_is in place_.
      assert (in_s' : strictly_inside (vertex c i) s').
      { apply (strictly_inside_part piece s' _ part). now apply (strictly_inside_of_one_place E). }
      apply segments_of_both in S'. destruct S' as (c' & o' & pair' & S'').
      assert (c' = c \/ c' = o) as [-> | ->] by (destruct pair_, pair'; tauto).
      + apply (inside_an_edge_is_no_vertex c c_polygon s' _ S'' in_s'). exists (edge_at c i). split; [exact S |].
        rewrite edge_is by exact I. split; reflexivity.
      + exact (c_off i I s' S'' (strictly_inside_lies_on _ _ in_s')).
    - refine (eventually_implied _ _ _ (beside_is_there o (vertex c i) (along (edge_at c i)) (c_off i I))).
      intros e ->. exact some.
  Qed.

  (* Theorem. From where an edge leads into the other polygon. *)
  Theorem a_piece_starts_at_a_crossing (c o : list vector) (s t : segment) (v : vector) : pair_of c o ->
    In s (region_edges [c]) -> In t (region_edges [o]) -> strictly_inside v s -> strictly_inside v t ->
    0 < cross (along t) (along s) ->
    exists f, In f (kept_boundary a b) /\ equal_vectors (source f) v /\ is_part f s.
  Proof.
    intros pair_ S T in_s in_t into. destruct (both_polygons a b a_polygon b_polygon c o pair_) as [c_polygon
      o_polygon].
    destruct in_s as (j & j_range & jx & jy).
    apply (a_kept_piece_starts c o s v j pair_ S); [lra | split; [exact jx | exact jy] | |].
    - intros E E_piece inside_.
      assert (on_s : lies_on v s) by (exists j; split; [lra | tauto]).
      assert (s_all : In s (concat (two_families a b))) by (apply segments_of_both; now exists c, o).
      assert (t_all : In t (concat (two_families a b)))
        by (apply segments_of_both; exists o, c; split; [now apply other_and_one | exact T]).
      pose proof (met_along E s v E_piece s_all inside_ on_s) as along_s.
      pose proof (met_along E t v E_piece t_all inside_ (strictly_inside_lies_on _ _ in_t)) as along_t.
      pose proof (are_long _ (pieces_of_share_ends _ long_) E E_piece) as E_long.
      destruct (is_a_multiple (along E) (along t) E_long along_t) as (k & kx & ky).
      unfold cross in *. rewrite kx, ky in into.
      setoid_replace (k * vx (along E) * vy (along s) - k * vy (along E) * vx (along s))
        with (k * (vx (along E) * vy (along s) - vy (along E) * vx (along s))) in into by ring.
        rewrite along_s in into. lra.
    - refine (eventually_implied _ _ _ (proj1 (beside_a_crossing o t v (along s) o_polygon T in_t) into)).
      intros e [-> _]. lia.
  Qed.
End TwoPolygons.
