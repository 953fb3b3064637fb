(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The corners of the boundary of the intersection (edges_of_the_intersection.v): where one kept piece ends and another
   starts there is a vertex of the one polygon inside the other, with the directions of its edges, or an edge of the one
   leads into the other across an edge, and the pieces are along the edge that is crossed, and then along the first. *)
From Coq Require Import QArith Lqa ZArith Lia Bool List Permutation.
From Oplus Require Import convolution small_numbers neighbourhoods regions meeting_of_segments left_of_an_edge
  simple_chain
  signed_crossings theorem_4_2_1 polygons_of_the_thesis beside_a_piece pieces met_pieces filling kept_pieces_go_round
  cut_pieces beside_a_vertex rule_of_sides region_of_pieces boolean_operations small_moves edges_of_polygons
  edges_of_the_intersection.
Import ListNotations.

Open Scope Q_scope.

(* A part of a segment, just after it starts and just before it ends. *)
Lemma after_the_start (f s : segment) (v : vector) : is_part f s -> equal_vectors (source f) v ->
  eventually (fun e => strictly_inside (moved_along v (along s) e) f).
Proof.
  intros (j & k & low & less & high & [jx jy] & [kx ky]) [X Y]. exists (k - j). split; [lra |]. intros e some small.
  assert (inverse : (k - j) * (1 / (k - j)) == 1) by (field; lra).
  assert (0 < 1 / (k - j)) by (apply Qlt_shift_div_l; lra). set (d := 1 / (k - j)) in *. clearbody d.
  exists (e * d). split; [nra |]. unfold moved_along, along, minus, point_at in *. cbn [source target vx vy] in *.
  assert (e_is : e == e * d * (k - j)) by (setoid_replace (e * d * (k - j)) with (e * ((k - j) * d)) by ring;
    rewrite inverse; ring).
  rewrite <- X, <- Y, jx, jy, kx, ky. set (m := e * d) in *. clearbody m. rewrite e_is. split; ring.
Qed.

Lemma just_before_the_end (f s : segment) (v : vector) : is_part f s -> equal_vectors (target f) v ->
  eventually (fun e => strictly_inside (moved_along v (along s) (- e)) f).
Proof.
  intros (j & k & low & less & high & [jx jy] & [kx ky]) [X Y]. exists (k - j). split; [lra |]. intros e some small.
  assert (inverse : (k - j) * (1 / (k - j)) == 1) by (field; lra).
  assert (0 < 1 / (k - j)) by (apply Qlt_shift_div_l; lra). set (d := 1 / (k - j)) in *. clearbody d.
  exists (1 - e * d). split; [nra |]. unfold moved_along, along, minus, point_at in *. cbn [source target vx vy] in *.
  assert (e_is : e == e * d * (k - j)) by (setoid_replace (e * d * (k - j)) with (e * ((k - j) * d)) by ring;
    rewrite inverse; ring).
  rewrite <- X, <- Y, jx, jy, kx, ky. set (m := e * d) in *. clearbody m. rewrite e_is. split; ring.
Qed.

Section TwoPolygons.
  Variables a b : list vector.
  Hypothesis a_polygon : simple_polygon a.
  Hypothesis b_polygon : simple_polygon b.
  Hypothesis a_off : vertices_are_off a b.
  Hypothesis b_off : vertices_are_off b a.

  Let pair_of := one_and_other a b.
  Let inside_other := kept_is_inside_the_other a b a_polygon b_polygon a_off b_off.
  Let cross_there := edges_of_both_cross a b a_polygon b_polygon a_off b_off.
  Let piece_is_off := inside_a_piece_is_off a b a_polygon b_polygon a_off b_off.

  Lemma same_edge (c o : list vector) (s t : segment) (w : vector) : pair_of c o ->
    In s (region_edges [c]) -> In t (region_edges [c]) -> strictly_inside w s -> lies_on w t -> t = s.
  Proof.
    intros pair_ S T inside_ on. destruct (both_polygons a b a_polygon b_polygon c o pair_) as [c_polygon _].
    destruct (edges_of_one c s S) as (i & I & -> & _), (edges_of_one c t T) as (j & J & -> & _).
    now rewrite (inside_one_edge c c_polygon i j w I J inside_ on).
  Qed.

  (* A piece that ends inside an edge of the one ends on an edge of the other. *)
  Lemma ends_inside_are_crossings (c o : list vector) (f s : segment) (v : vector) : pair_of c o ->
    directed (pieces_of_both a b) f -> In s (region_edges [c]) -> is_part f s -> v = source f \/ v = target f ->
    strictly_inside v s -> exists t, In t (region_edges [o]) /\ lies_on v t.
  Proof.
    intros pair_ D S part end_ inside_.
    assert (middle : strictly_inside (point_at f (1 # 2)) f) by (apply strictly_inside_at; lra).
    assert (found : exists s' piece, In s' (concat (two_families a b)) /\
      In piece (cut_where_met s' (concat (two_families a b))) /\ is_part piece s' /\ of_one_place f piece).
    { pose proof (both_are_long a b a_polygon b_polygon) as long.
      destruct D as [D | D]; destruct (piece_is _ long _ D) as (s' & piece & S' & P & e_is & part' & _);
        pose proof (undirected_place piece) as place_; rewrite <- e_is in place_; exists s', piece;
        (split; [exact S' |]; split; [exact P |]; split; [exact part' |]); trivial.
      unfold of_one_place in *. cbn [reversed source target] in place_. tauto. }
    destruct found as (s' & piece & S' & P & part' & place_).
    assert (in_s' : strictly_inside (point_at f (1 # 2)) s').
    { apply (strictly_inside_part piece s' _ part'). now apply (strictly_inside_of_one_place f). }
    assert (s'_is : s' = s).
    { apply segments_of_both in S'. destruct S' as (c' & o' & pair' & S'').
      assert (c' = c \/ c' = o) as [-> | ->] by (destruct pair_, pair'; tauto).
      - apply (same_edge c o s s' (point_at f (1 # 2)) pair_ S S''); [| now apply strictly_inside_lies_on].
        exact (strictly_inside_part f s _ part middle).
      - exfalso. apply (piece_is_off c o f s _ pair_ D S part middle s' S''). now apply strictly_inside_lies_on. }
    subst s'.
    assert (p_end : exists p, (p = source piece \/ p = target piece) /\ equal_vectors v p).
    { destruct place_ as [[x y] | [x y]], end_ as [-> | ->];
        [exists (source piece) | exists (target piece) | exists (target piece) | exists (source piece)]; tauto. }
    destruct p_end as (p & p_end & v_is).
    assert (inside_p : strictly_inside p s) by (apply (cut_pieces.strictly_inside_equal v); assumption).
    assert (no_end : forall q, q = source s \/ q = target s -> p = q -> False).
    { intros q which ->. pose proof (polygon_edges_are_long c (proj1 (both_polygons a b a_polygon b_polygon c o
        pair_)) s S)
        as long. destruct inside_p as (k & range & kx & ky). apply long. unfold along, minus. cbn [vx vy].
      destruct which as [-> | ->]; split; nra. }
    destruct (ends_of_a_piece s piece _ p P p_end) as [at_source | [at_target | (t & T & I)]].
    - destruct (no_end _ (or_introl eq_refl) at_source).
    - destruct (no_end _ (or_intror eq_refl) at_target).
    - apply intersection_is_on_both in I. destruct I as (_ & on_t & how).
      apply segments_of_both in T. destruct T as (c' & o' & pair' & T).
      assert (c' = c \/ c' = o) as [-> | ->] by (destruct pair_, pair'; tauto).
      + exfalso. rewrite (same_edge c o s t p pair_ S T inside_p on_t) in how.
        destruct how as [[at_end | [at_end | [at_end | at_end]]] | no];
          [destruct (no_end _ (or_introl eq_refl) at_end) | destruct (no_end _ (or_intror eq_refl) at_end) |
           destruct (no_end _ (or_introl eq_refl) at_end) | destruct (no_end _ (or_intror eq_refl) at_end) |].
        apply no. unfold cross. ring.
      + exists t. split; [exact T |]. apply (lies_on_equal p); [now symmetry | exact on_t].
  Qed.

  (* An edge that leads to its left is left of the crossed one after it, and right of it before it. *)
  Lemma beside_a_crossing (o : list vector) (t : segment) (v d : vector) : simple_polygon o ->
    In t (region_edges [o]) -> strictly_inside v t ->
    (0 < cross (along t) d -> eventually (fun e => winding_number (moved_along v d e) (region_edges [o]) = 1%Z /\
       winding_number (moved_along v d (- e)) (region_edges [o]) = 0%Z)) /\
    (cross (along t) d < 0 -> eventually (fun e => winding_number (moved_along v d e) (region_edges [o]) = 0%Z /\
       winding_number (moved_along v d (- e)) (region_edges [o]) = 1%Z)).
  Proof.
    intros polygon T inside_. split; intros side.
    - exact (beside_an_edge o polygon t v d T inside_ side).
    - assert (left_ : 0 < cross (along t) (opposite d)) by (unfold cross, opposite in *; cbn [vx vy]; lra).
      refine (eventually_implied _ _ _ (beside_an_edge o polygon t v (opposite d) T inside_ left_)).
      intros e [one none]. split; [rewrite <- none | rewrite <- one]; apply winding_number_of_equal;
        unfold moved_along, opposite; cbn [vx vy]; ring.
  Qed.

  Definition at_vertex (c o : list vector) (g f : segment) : Prop :=
    exists i, (i < length c)%nat /\ equal_vectors (source f) (vertex c i) /\
      is_part f (edge_at c i) /\ is_part g (edge_at c (previous (length c) i)) /\
      (0 < winding_number (vertex c i) (region_edges [o]))%Z.

  Definition at_crossing (c o : list vector) (g f : segment) : Prop :=
    exists s t, In s (region_edges [c]) /\ In t (region_edges [o]) /\
      strictly_inside (source f) s /\ strictly_inside (source f) t /\ is_part f s /\ is_part g t /\
      0 < cross (along t) (along s).

  (* Theorem. *)
  Theorem corners_are_vertices_and_crossings (g f : segment) :
    In g (kept_boundary a b) -> In f (kept_boundary a b) -> target g = source f ->
    exists c o, pair_of c o /\ (at_vertex c o g f \/ at_crossing c o g f).
  Proof.
    intros G F meets. apply inside_other in G, F.
    destruct G as (g_piece & c' & o' & s' & pair' & S' & g_part & g_inside).
    destruct F as (f_piece & c & o & s & pair_ & S & f_part & f_inside). exists c, o. split; [exact pair_ |].
    destruct (both_polygons a b a_polygon b_polygon c o pair_) as [c_polygon o_polygon].
    destruct (both_off a b a_off b_off c o pair_) as [c_off o_off].
    set (v := source f) in *.
    assert (on_s : lies_on v s) by (apply (part_lies_on f s v f_part), source_lies_on).
    assert (on_s' : lies_on v s') by (rewrite <- meets; apply (part_lies_on g s' _ g_part), target_lies_on).
    pose proof (after_the_start f s v f_part (conj (Qeq_refl _) (Qeq_refl _))) as after_.
    assert (before_ : eventually (fun e => strictly_inside (moved_along v (along s') (- e)) g)).
    { apply (just_before_the_end g s' v g_part). rewrite meets. split; reflexivity. }
    assert (which : (c' = c /\ o' = o) \/ (c' = o /\ o' = c)) by (destruct pair_, pair'; tauto).
    destruct (inside_or_end v s on_s) as [inside_s | [at_source | at_target]].
    - right. destruct (ends_inside_are_crossings c o f s v pair_ f_piece S f_part (or_introl eq_refl) inside_s)
        as (t & T & on_t).
      destruct (cross_there c o s t v pair_ S T on_s on_t) as (_ & inside_t & no).
      destruct (beside_a_crossing o t v (along s) o_polygon T inside_t) as [up down].
      assert (into : 0 < cross (along t) (along s)).
      { destruct (Q_dec (cross (along t) (along s)) 0) as [[less | more] | flat]; [exfalso | exact more | exfalso].
        - destruct (some_small _ (eventually_and _ _ (down less) after_)) as (e & _ & [none _] & in_f).
          destruct (f_inside _ in_f) as [_ some]. lia.
        - apply no. unfold cross in *. lra. }
      exists s, t. split; [exact S |]. split; [exact T |]. split; [exact inside_s |]. split; [exact inside_t |].
      split; [exact f_part |]. split; [| exact into]. destruct which as [[-> ->] | [-> ->]].
      + exfalso. rewrite (same_edge c o s s' v pair_ S S' inside_s on_s') in before_.
        destruct (some_small _ (eventually_and _ _ (up into) before_)) as (e & _ & [_ none] & in_g).
        destruct (g_inside _ in_g) as [_ some]. lia.
      + destruct (cross_there c o s s' v pair_ S S' on_s on_s') as (_ & inside_s' & _).
        rewrite <- (same_edge o c t s' v (other_and_one a b c o pair_) T S' inside_t on_s'). exact g_part.
    - left. destruct (edges_of_one c s S) as (i & I & s_is & s_source & _). rewrite s_source in at_source.
      assert (v_is : equal_vectors v (vertex c i)) by now symmetry.
      assert (on_vertex : lies_on (vertex c i) s') by (apply (lies_on_equal v); assumption).
      destruct which as [[-> ->] | [-> ->]]; [| destruct (c_off i I s' S' on_vertex)].
      exists i. split; [exact I |]. split; [exact v_is |]. rewrite <- s_is. split; [exact f_part |].
      destruct (edges_of_one c s' S') as (j & J & s'_is & s'_source & _). rewrite s'_is in on_vertex.
      split.
      + destruct (edges_at_a_vertex c c_polygon i j I J on_vertex) as [-> | <-].
        * exfalso. destruct g_part as (j' & k & low & less & high & _ & [kx ky]). rewrite meets in kx, ky.
          fold v in kx, ky.
          destruct v_is as [vx_is vy_is]. rewrite vx_is, <- s'_source in kx. rewrite vy_is, <- s'_source in ky.
          unfold point_at in kx, ky. cbn [vx vy] in kx, ky. apply (polygon_edges_are_long c c_polygon s' S').
          unfold along, minus. cbn [vx vy]. split; nra.
        * rewrite previous_next by exact J. now rewrite <- s'_is.
      + destruct (winding_number_near (vertex c i) (region_edges [o]) (region_cycles [o]) (c_off i I)) as (radius & R
          & near_).
        assert (close : eventually (fun e => within radius (vertex c i) (moved_along v (along s) e))).
        { refine (eventually_implied _ _ _ (small_steps_stay_within radius (vertex c i) (along s) R)). intros e.
          destruct v_is as [X Y]. unfold within, moved_along. cbn [vx vy]. rewrite X, Y. trivial. }
        destruct (some_small _ (eventually_and _ _ close after_)) as (e & _ & near_e & in_f).
        destruct (f_inside _ in_f) as [_ some]. now rewrite <- (proj2 (near_ _ near_e)).
    - exfalso. destruct f_part as (j & k & low & less & high & [jx jy] & _). fold v in jx, jy.
      destruct at_target as [X Y]. rewrite <- X in jx. rewrite <- Y in jy. unfold point_at in jx, jy.
      cbn [vx vy] in jx, jy.
      apply (polygon_edges_are_long c c_polygon s S). unfold along, minus. cbn [vx vy]. split; nra.
  Qed.
End TwoPolygons.
