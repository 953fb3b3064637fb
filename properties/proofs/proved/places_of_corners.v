(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The corners of chains made of the kept pieces, one for each vertex of the one polygon inside the other and for each
   crossing of their edges: a corner is where a kept piece starts (corners_of_the_intersection.v), from each such place
   one starts (starts_of_kept_pieces.v), and one only. *)
From Coq Require Import QArith Lqa ZArith Lia Bool List Permutation FinFun SetoidList SetoidPermutation.
From Oplus Require Import convolution distinct small_numbers regions meeting_of_segments simple_chain theorem_4_2_1
  polygons_of_the_thesis beside_a_piece pieces met_pieces filling kept_pieces_go_round cut_pieces region_of_pieces
  small_moves cut_corners corners_of_chains theorem_4_2_14 edges_of_polygons
  edges_of_the_intersection corners_of_the_intersection starts_of_kept_pieces.
Import ListNotations.

Open Scope Q_scope.

Section TwoPolygons.
  Variables a b : list vector.
  Hypothesis a_polygon : simple_polygon a.
  Hypothesis b_polygon : simple_polygon b.
  Hypothesis a_off : vertices_are_off a b.
  Hypothesis b_off : vertices_are_off b a.
  Variable do_cross : nat -> nat -> bool.
  Hypothesis crossings : forall i j, (i < length a)%nat -> (j < length b)%nat ->
    do_cross i j = true <-> exists v, lies_on v (edge_at a i) /\ lies_on v (edge_at b j).

  (* A vertex of the first polygon or of the second, or a crossing of two edges. *)
  Inductive corner_place := AtVertex (of_first : bool) (i : nat) | AtCrossing (i j : nat).

  Definition polygon_of (of_first : bool) : list vector := if of_first then a else b.

  Definition is_inside_other (of_first : bool) (i : nat) : bool :=
    (0 <? winding_number (vertex (polygon_of of_first) i) (region_edges [polygon_of (negb of_first)]))%Z.

  Definition places : list corner_place :=
    map (AtVertex true) (filter (is_inside_other true) (seq 0 (length a))) ++
    map (AtVertex false) (filter (is_inside_other false) (seq 0 (length b))) ++
    map (fun ends => AtCrossing (fst ends) (snd ends))
      (filter (fun ends => do_cross (fst ends) (snd ends)) (list_prod (seq 0 (length a)) (seq 0 (length b)))).

  Definition leads_out (i j : nat) : bool := negative (cross (along (edge_at b j)) (along (edge_at a i))).

  (* The corner there, and the edge along which it goes on. *)
  Definition corner_of_place (p : corner_place) : corner :=
    match p with
    | AtVertex of_first i => corner_of_chain (polygon_of of_first) i
    | AtCrossing i j => if leads_out i j then Corner (along (edge_at a i)) (along (edge_at b j))
                        else Corner (along (edge_at b j)) (along (edge_at a i))
    end.
  Definition edge_from (p : corner_place) : segment :=
    match p with
    | AtVertex of_first i => edge_at (polygon_of of_first) i
    | AtCrossing i j => if leads_out i j then edge_at b j else edge_at a i
    end.

  Definition is_at (v : vector) (p : corner_place) : Prop :=
    match p with
    | AtVertex of_first i => equal_vectors v (vertex (polygon_of of_first) i)
    | AtCrossing i j => lies_on v (edge_at a i) /\ lies_on v (edge_at b j)
    end.

  Lemma in_places (p : corner_place) : In p places <->
    match p with
    | AtVertex of_first i => (i < length (polygon_of of_first))%nat /\ is_inside_other of_first i = true
    | AtCrossing i j => (i < length a)%nat /\ (j < length b)%nat /\ do_cross i j = true
    end.
  Proof.
    unfold places. rewrite !in_app_iff, !in_map_iff. split.
    - intros [(i & <- & I) | [(i & <- & I) | ([i j] & <- & I)]]; apply filter_In in I; destruct I as [I yes];
        [apply in_seq in I; cbn; split; [lia | exact yes] .. |].
      cbn [fst snd] in *. apply in_prod_iff in I. rewrite !in_seq in I. repeat split; (lia || tauto).
    - destruct p as [[|] i | i j]; [intros [I yes] | intros [I yes] | intros (I & J & yes)].
      + left. exists i. split; [reflexivity |]. apply filter_In. split; [apply in_seq; cbn in I; lia | exact yes].
      + right. left. exists i. split; [reflexivity |]. apply filter_In.
        split; [apply in_seq; cbn in I; lia | exact yes].
      + right. right. exists (i, j). split; [reflexivity |]. apply filter_In. split; [| exact yes].
        apply in_prod_iff. rewrite !in_seq. lia.
  Qed.

  Lemma places_are_distinct : NoDup places.
  Proof.
    unfold places. apply NoDup_of_two; [| apply NoDup_of_two |].
    - apply (Injective_map_NoDup (f := AtVertex true)); [now intros i j [= ->] | apply NoDup_filter, seq_NoDup].
    - apply (Injective_map_NoDup (f := AtVertex false)); [now intros i j [= ->] | apply NoDup_filter, seq_NoDup].
    - apply (Injective_map_NoDup (f := fun ends => AtCrossing (fst ends) (snd ends))).
      + now intros [i j] [k l] [= -> ->].
      + apply NoDup_filter, NoDup_list_prod; apply seq_NoDup.
    - intros p P Q. apply in_map_iff in P, Q. destruct P as (i & <- & _), Q as (j & [=] & _).
    - intros p P Q. apply in_map_iff in P. destruct P as (i & <- & _). apply in_app_iff in Q. rewrite !in_map_iff in Q.
      destruct Q as [(j & [=] & _) | (j & [=] & _)].
  Qed.

  Lemma one_vertex (c : list vector) (i j : nat) : simple_polygon c -> (i < length c)%nat -> (j < length c)%nat ->
    equal_vectors (vertex c i) (vertex c j) -> i = j.
  Proof.
    intros polygon I J same_. assert (on : lies_on (vertex c i) (edge_at c j)).
    { apply (lies_on_equal (vertex c j)); [now symmetry |]. rewrite edge_is by exact J.
      apply (source_lies_on (Segment _ _)). }
    destruct (edges_at_a_vertex c polygon i j I J on) as [-> | next_is]; [reflexivity | exfalso].
    destruct polygon as [(_ & long & _) _]. apply (edges_of_simple_chains c j long J). rewrite next_is.
    unfold minus. cbn [vx vy]. destruct same_ as [X Y]. split; lra.
  Qed.

  Lemma one_place_there (v : vector) (p q : corner_place) : In p places -> In q places -> is_at v p -> is_at v q ->
    p = q.
  Proof.
    intros P Q. apply in_places in P, Q.
    assert (no_vertex_on : forall first_ i w, (i < length (polygon_of first_))%nat ->
      equal_vectors w (vertex (polygon_of first_) i) -> forall s, In s (region_edges [polygon_of (negb first_)]) ->
        ~ lies_on w s).
    { intros first_ i w I equal s S on. assert (on' : lies_on (vertex (polygon_of first_) i) s) by now apply
        (lies_on_equal w).
      destruct first_; [exact (a_off i I s S on') | exact (b_off i I s S on')]. }
    assert (in_a : forall i, (i < length a)%nat -> In (edge_at a i) (region_edges [a]))
      by (intros; apply edge_at_in_region; [now left | assumption]).
    assert (in_b : forall j, (j < length b)%nat -> In (edge_at b j) (region_edges [b]))
      by (intros; apply edge_at_in_region; [now left | assumption]).
    assert (vertex_on : forall first_ i, (i < length (polygon_of first_))%nat ->
      In (edge_at (polygon_of first_) i) (region_edges [polygon_of first_]) /\
      lies_on (vertex (polygon_of first_) i) (edge_at (polygon_of first_) i)).
    { intros first_ i I. split; [apply edge_at_in_region; [now left | exact I] |]. rewrite edge_is by exact I.
      apply (source_lies_on (Segment _ _)). }
    destruct p as [first_ i | i j], q as [first_' i' | i' j']; cbn [is_at]; intros at_p at_q.
    - destruct P as [I _], Q as [I' _]. destruct (vertex_on first_' i' I') as [S on].
      assert (v_on : lies_on v (edge_at (polygon_of first_') i')) by (apply (lies_on_equal (vertex (polygon_of
        first_') i'));
        [now symmetry | exact on]).
      destruct first_, first_'; try (exfalso; exact (no_vertex_on _ i v I at_p _ S v_on)); f_equal.
      + apply (one_vertex a i i' a_polygon I I'). now rewrite <- at_p.
      + apply (one_vertex b i i' b_polygon I I'). now rewrite <- at_p.
    - exfalso. destruct P as [I _], Q as (I' & J' & _), at_q as [on_a on_b], first_;
        [exact (no_vertex_on true i v I at_p _ (in_b j' J') on_b) | exact (no_vertex_on false i v I at_p _ (in_a i'
          I') on_a)].
    - exfalso. destruct Q as [I _], P as (I' & J' & _), at_p as [on_a on_b], first_';
        [exact (no_vertex_on true i' v I at_q _ (in_b j J') on_b) | exact (no_vertex_on false i' v I at_q _ (in_a i
          I') on_a)].
    - destruct P as (I & J & _), Q as (I' & J' & _), at_p as [on_i on_j], at_q as [on_i' on_j'].
      destruct (edges_of_both_cross a b a_polygon b_polygon a_off b_off a b _ _ v (FirstOne a b) (in_a i I) (in_b j J)
        on_i
        on_j)
        as (in_i & in_j & _).
      now rewrite (inside_one_edge a a_polygon i i' v I I' in_i on_i'),
        (inside_one_edge b b_polygon j j' v J J' in_j on_j').
  Qed.

  Lemma same_corner_of_parts (g f s t : segment) : nonzero (along s) -> nonzero (along t) -> is_part g s ->
    is_part f t ->
    same_corner (corner_of_edges (g, f)) (Corner (along s) (along t)).
  Proof.
    intros s_long t_long g_part f_part.
    destruct (part_is_long g s g_part s_long) as (g_long & k & K & gx & gy).
    destruct (part_is_long f t f_part t_long) as (f_long & l & L & fx & fy).
    unfold corner_of_edges. cbn [fst snd incoming outgoing]. unfold same_corner. cbn [incoming outgoing].
    split; [tauto |]. split; [tauto |].
    split; apply same_direction_angle; trivial; [now exists k | now exists l].
  Qed.

  Definition belongs_to (ends : segment * segment) (p : corner_place) : Prop :=
    is_at (source (snd ends)) p /\ is_part (snd ends) (edge_from p) /\
      same_corner (corner_of_edges ends) (corner_of_place p).

  Lemma each_corner_has_a_place (g f : segment) :
    In g (kept_boundary a b) -> In f (kept_boundary a b) -> target g = source f ->
    exists p, In p places /\ belongs_to (g, f) p.
  Proof.
    intros G F meets.
    destruct (corners_are_vertices_and_crossings a b a_polygon b_polygon a_off b_off g f G F meets)
      as (c & o & pair_ & [(i & I & at_v & f_part & g_part & some) | (s & t & S & T & in_s & in_t & f_part & g_part &
        into)]).
    - assert (found : exists of_first, c = polygon_of of_first /\ o = polygon_of (negb of_first))
        by (destruct pair_; [now exists true | now exists false]).
      destruct found as (of_first & -> & ->). exists (AtVertex of_first i).
      split; [apply in_places; split; [exact I |]; now apply Z.ltb_lt |].
      split; [exact at_v |]. split; [exact f_part |]. cbn [corner_of_place].
      assert (polygon : simple_polygon (polygon_of of_first)) by (now destruct of_first).
      pose proof (previous_below _ i I) as J.
      assert (along_is : forall k, (k < length (polygon_of of_first))%nat ->
        edge_of_chain (polygon_of of_first) k = along (edge_at (polygon_of of_first) k)).
      { intros k K. rewrite edge_of_chain_joins_vertices, edge_is by exact K. reflexivity. }
      rewrite corner_is, !along_is by assumption.
      apply same_corner_of_parts; trivial; apply (polygon_edges_are_long _ polygon), edge_at_in_region; trivial;
        now left.
    - destruct (both_polygons a b a_polygon b_polygon c o pair_) as [c_polygon o_polygon].
      pose proof (polygon_edges_are_long c c_polygon s S) as s_long.
      pose proof (polygon_edges_are_long o o_polygon t T) as t_long.
      destruct (edges_of_one c s S) as (i & I & s_is & _), (edges_of_one o t T) as (j & J & t_is & _).
      pose proof (strictly_inside_lies_on _ _ in_s) as on_s. pose proof (strictly_inside_lies_on _ _ in_t) as on_t.
      destruct pair_.
      + exists (AtCrossing i j). assert (out : leads_out i j = false).
        { unfold leads_out. rewrite <- s_is, <- t_is.
          destruct (negative_spec (cross (along t) (along s))); [lra | reflexivity]. }
        split; [apply in_places; split; [exact I | split; [exact J |]]; apply crossings; trivial; exists (source f);
          now rewrite <- s_is, <- t_is |].
        unfold belongs_to. cbn [is_at edge_from corner_of_place snd]. rewrite out, <- s_is, <- t_is.
        split; [now split |]. split; [exact f_part |]. now apply same_corner_of_parts.
      + exists (AtCrossing j i). assert (out : leads_out j i = true).
        { unfold leads_out. rewrite <- s_is, <- t_is.
          destruct (negative_spec (cross (along s) (along t))); [reflexivity |].
          unfold cross in *. lra. }
        split; [apply in_places; split; [exact J | split; [exact I |]]; apply crossings; trivial; exists (source f);
          now rewrite <- s_is, <- t_is |].
        unfold belongs_to. cbn [is_at edge_from corner_of_place snd]. rewrite out, <- s_is, <- t_is.
        split; [now split |]. split; [exact f_part |]. now apply same_corner_of_parts.
  Qed.

  Lemma each_place_has_a_corner (p : corner_place) : In p places ->
    exists f, In f (kept_boundary a b) /\ is_at (source f) p.
  Proof.
    intros P. apply in_places in P. destruct p as [of_first i | i j].
    - destruct P as [I some]. apply Z.ltb_lt in some.
      destruct (a_piece_starts_at_a_vertex a b a_polygon b_polygon a_off b_off (polygon_of of_first)
        (polygon_of (negb of_first)) i) as (f & F & there & _); trivial; [destruct of_first; constructor |].
      now exists f.
    - destruct P as (I & J & yes). apply crossings in yes; trivial. destruct yes as (v & on_i & on_j).
      assert (S : In (edge_at a i) (region_edges [a])) by (apply edge_at_in_region; [now left | exact I]).
      assert (T : In (edge_at b j) (region_edges [b])) by (apply edge_at_in_region; [now left | exact J]).
      destruct (edges_of_both_cross a b a_polygon b_polygon a_off b_off a b _ _ v (FirstOne a b) S T on_i on_j) as
        (in_i &
        in_j & no).
      assert (at_v : forall f, equal_vectors (source f) v -> is_at (source f) (AtCrossing i j)).
      { intros f equal. split; apply (lies_on_equal v); trivial; now symmetry. }
      destruct (Q_dec (cross (along (edge_at b j)) (along (edge_at a i))) 0) as [[less | more] | flat].
      + destruct (a_piece_starts_at_a_crossing a b a_polygon b_polygon a_off b_off b a _ _ v (SecondOne a b) T S in_j
          in_i)
          as (f & F & there & _); [unfold cross in *; lra |]. exists f. split; [exact F | now apply at_v].
      + destruct (a_piece_starts_at_a_crossing a b a_polygon b_polygon a_off b_off a b _ _ v (FirstOne a b) S T in_i
          in_j more)
          as (f & F & there & _). exists f. split; [exact F | now apply at_v].
      + exfalso. apply no. unfold cross in *. lra.
  Qed.

  Lemma edges_from_are_long (p : corner_place) : In p places -> nonzero (along (edge_from p)).
  Proof.
    intros P. apply in_places in P. destruct p as [of_first i | i j]; cbn [edge_from].
    - apply (polygon_edges_are_long (polygon_of of_first)); [now destruct of_first |].
      apply edge_at_in_region; [now left | apply P].
    - destruct P as (I & J & _). destruct (leads_out i j); [apply (polygon_edges_are_long b b_polygon) |
        apply (polygon_edges_are_long a a_polygon)]; apply edge_at_in_region; trivial; now left.
  Qed.

  (* Theorem. Chains made of the kept pieces have a corner at each place, and no others. *)
  Theorem corners_are_at_places (r : region) : Permutation (region_edges r) (kept_boundary a b) ->
    exists m, Permutation m places /\ Forall2 (fun c p => same_corner c (corner_of_place p)) (flat_map corners r) m.
  Proof.
    intros edges_are. rewrite corners_of_consecutive_edges.
    pose proof (two_families_end a b a_polygon b_polygon) as ends_.
    pose proof (kept_share_ends _ _ _ ends_) as share.
    assert (in_kept : forall f, In f (region_edges r) <-> In f (kept_boundary a b)).
    { intros f. split; apply Permutation_in; [exact edges_are | now symmetry]. }
    assert (distinct_ : NoDup (map snd (consecutive_edges r))).
    { rewrite second_of_consecutive_edges. apply (Permutation_NoDup (Permutation_sym edges_are)).
      apply (are_distinct _ share). }
    assert (there : forall ends, In ends (consecutive_edges r) -> exists p, In p places /\ belongs_to ends p).
    { intros [g f] I. destruct (consecutive_edges_are r g f I) as (G & F & meets). apply in_kept in G, F.
      now apply each_corner_has_a_place. }
    destruct (matched (fun ends p => In p places /\ belongs_to ends p) (consecutive_edges r) places) as (m & permuted
      & pairs_).
    - now apply (NoDup_map_inv snd).
    - exact places_are_distinct.
    - intros ends I. destruct (there ends I) as (p & P & belongs). now exists p.
    - intros p P. destruct (each_place_has_a_corner p P) as (f & F & at_p). apply in_kept in F.
      rewrite <- second_of_consecutive_edges in F. apply in_map_iff in F. destruct F as ([g f'] & f_is & I).
      cbn in f_is. subst f'.
      exists (g, f). split; [exact I |]. destruct (there _ I) as (p' & P' & belongs). split; [exact P |].
      now rewrite (one_place_there (source f) p p' P P' at_p (proj1 belongs)).
    - intros [g f] [g' f'] p I I' [P (at_p & part & _)] [_ (at_p' & part' & _)]. cbn [snd] in *.
      destruct (consecutive_edges_are r g f I) as (_ & F & _), (consecutive_edges_are r g' f' I') as (_ & F' & _).
      apply in_kept in F, F'.
      assert (f_is : f = f').
      { apply (one_kept_piece_starts a b a_polygon b_polygon f f' (edge_from p) (edges_from_are_long p P) F F' part
          part').
        pose proof P as P'. apply in_places in P'. destruct p as [of_first i | i j]; cbn [is_at] in at_p, at_p'.
        - rewrite at_p, at_p'. split; reflexivity.
        - destruct P' as (I0 & J0 & _), at_p as [on_i on_j], at_p' as [on_i' on_j'].
          assert (S : In (edge_at a i) (region_edges [a])) by (apply edge_at_in_region; [now left | exact I0]).
          assert (T : In (edge_at b j) (region_edges [b])) by (apply edge_at_in_region; [now left | exact J0]).
          destruct (edges_of_both_cross a b a_polygon b_polygon a_off b_off a b _ _ _ (FirstOne a b) S T on_i on_j) as
            (_ & _
            & no).
          exact (lines_meet_once _ _ (source f') (source f) no on_i' on_j' on_i on_j). }
      subst f'. now rewrite (distinct_by_second _ g g' f distinct_ I I').
    - intros [g f] p p' P P' [_ (at_p & _)] [_ (at_p' & _)]. exact (one_place_there (source f) p p' P P' at_p at_p').
    - exists m. split; [exact permuted |]. clear - pairs_.
      induction pairs_ as [| ends p l m [_ (_ & _ & same_)] _ IH]; cbn [map]; constructor; trivial.
  Qed.
End TwoPolygons.
