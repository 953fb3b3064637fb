(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Edges of simple polygons: which points are on which, what is beside them, and that edges of two polygons that meet
   cross, if no vertex of the one is on an edge of the other. For the boundary of the intersection. *)
From Coq Require Import QArith Lqa ZArith Lia Bool List Permutation.
From Oplus Require Import convolution small_numbers neighbourhoods regions meeting_of_segments left_of_an_edge
  simple_chain
  signed_crossings winding_number_of_the_sum theorem_4_2_1 polygons_of_the_thesis beside_a_piece pieces met_pieces
    filling kept_pieces_go_round cut_pieces
  beside_a_vertex rule_of_sides region_of_pieces boolean_operations small_moves.
Import ListNotations.

Open Scope Q_scope.

(* No vertex of the one is on an edge of the other. *)
Definition vertices_are_off (c o : list vector) : Prop :=
  forall i, (i < length c)%nat -> off (vertex c i) (region_edges [o]).

Lemma edges_of_one (c : list vector) (s : segment) : In s (region_edges [c]) ->
  exists i, (i < length c)%nat /\ s = edge_at c i /\ source s = vertex c i /\ target s = vertex c (next i (length c)).
Proof.
  intros S. destruct (edge_by_chain [c] s S) as (chain & i & [<- | []] & I & ->). exists i.
  rewrite edge_is by exact I. now repeat split.
Qed.

(* Segments that meet and have no end on each other cross. *)
Lemma without_ends_they_cross (s t : segment) (w : vector) : nonzero (along s) -> nonzero (along t) ->
  ~ lies_on (source s) t -> ~ lies_on (target s) t -> ~ lies_on (source t) s -> ~ lies_on (target t) s ->
  lies_on w s -> lies_on w t -> strictly_inside w s /\ strictly_inside w t /\ ~ cross (along s) (along t) == 0.
Proof.
  intros long_s long_t s1 s2 t1 t2 on_s on_t.
  assert (in_s : strictly_inside w s).
  { destruct (inside_or_end w s on_s) as [inside_ | [equal | equal]]; [exact inside_ | exfalso | exfalso];
      [apply s1 | apply s2]; (apply (lies_on_equal w); [now symmetry | exact on_t]). }
  assert (in_t : strictly_inside w t).
  { destruct (inside_or_end w t on_t) as [inside_ | [equal | equal]]; [exact inside_ | exfalso | exfalso];
      [apply t1 | apply t2]; (apply (lies_on_equal w); [now symmetry | exact on_s]). }
  split; [exact in_s |]. split; [exact in_t |]. intros flat.
  destruct in_s as (k & k_range & kx & ky), in_t as (l & l_range & lx & ly).
  assert (turned : cross (along t) (along s) == 0) by (unfold cross in *; lra).
  destruct (multiple_of (along t) (along s) long_s turned) as (c & cx & cy).
  assert (c_some : ~ c == 0) by (intros none; apply long_t; rewrite cx, cy, none; split; ring).
  assert (inverse : c * (1 / c) == 1) by (field; exact c_some). set (d := 1 / c) in *. clearbody d.
  unfold along, minus in cx, cy. cbn [vx vy] in cx, cy.
  set (m := l + (1 - k) * d). assert (end_of_s : vx (target s) == (1 - m) * vx (source t) + m * vx (target t) /\
                                                 vy (target s) == (1 - m) * vy (source t) + m * vy (target t)).
  { setoid_replace (vx (target s)) with (vx w + (1 - k) * (d * (vx (target t) - vx (source t))))
      by (rewrite cx; setoid_replace (d * (c * (vx (target s) - vx (source s)))) with
        (c * d * (vx (target s) - vx (source s))) by ring; rewrite inverse, kx; ring).
    setoid_replace (vy (target s)) with (vy w + (1 - k) * (d * (vy (target t) - vy (source t))))
      by (rewrite cy; setoid_replace (d * (c * (vy (target s) - vy (source s)))) with
        (c * d * (vy (target s) - vy (source s))) by ring; rewrite inverse, ky; ring).
    unfold m. rewrite lx, ly. split; ring. }
  destruct (Q_dec c 0) as [[less | more] | none]; [| | contradiction].
  - assert (d < 0) by nra. destruct (Qlt_le_dec (1 - k) (l * - c)) as [near | far].
    + apply s2. exists m. split; [unfold m; nra | exact end_of_s].
    + apply t1. exists (k - l * c). split; [nra |].
      assert (X : vx w == vx (source t) + l * (c * (vx (target s) - vx (source s)))) by (rewrite <- cx, lx; ring).
      assert (Y : vy w == vy (source t) + l * (c * (vy (target s) - vy (source s)))) by (rewrite <- cy, ly; ring).
      rewrite kx in X. rewrite ky in Y. split; lra.
  - assert (0 < d) by nra. destruct (Qlt_le_dec (1 - k) ((1 - l) * c)) as [near | far].
    + apply s2. exists m. split; [unfold m; nra | exact end_of_s].
    + apply t2. exists (k + (1 - l) * c). split; [nra |].
      assert (X : vx (target t) == vx w + (1 - l) * (c * (vx (target s) - vx (source s)))) by (rewrite <- cx, lx; ring).
      assert (Y : vy (target t) == vy w + (1 - l) * (c * (vy (target s) - vy (source s)))) by (rewrite <- cy, ly; ring).
      rewrite X, Y, kx, ky. split; ring.
Qed.

Section OnePolygon.
  Variable c : list vector.
  Hypothesis polygon : simple_polygon c.

  Lemma polygon_edges_are_long (s : segment) : In s (region_edges [c]) -> nonzero (along s).
  Proof. apply (region_edges_are_directions [c] (proj1 (simple_polygons_are_regions c polygon))). Qed.

  (* What is inside an edge is on no other edge. *)
  Lemma inside_one_edge (i j : nat) (w : vector) : (i < length c)%nat -> (j < length c)%nat ->
    strictly_inside w (edge_at c i) -> lies_on w (edge_at c j) -> i = j.
  Proof.
    intros I J inside_ on. destruct (Nat.eq_dec i j) as [same_ | differ]; [exact same_ | exfalso].
    destruct polygon as [(N & long & common) _]. pose proof (edges_of_simple_chains c i long I) as some.
    assert (no_end : forall v, v = vertex c i \/ v = vertex c (next i (length c)) -> ~ equal_vectors w v).
    { intros v which [X Y]. destruct inside_ as (k & range & kx & ky). rewrite edge_is in kx, ky by exact I.
      cbn [source target] in kx, ky. apply some. unfold minus. cbn [vx vy]. destruct which as [-> | ->]; split; nra. }
    destruct (common i j w I J differ (strictly_inside_lies_on _ _ inside_) on) as [[-> at_end] | [i_is at_end]].
    - exact (no_end _ (or_intror eq_refl) at_end).
    - exact (no_end _ (or_introl eq_refl) at_end).
  Qed.

  Lemma inside_an_edge_is_no_vertex (s : segment) (w : vector) : In s (region_edges [c]) -> strictly_inside w s ->
    ~ is_vertex w [c].
  Proof.
    intros S inside_ (t & T & equal). destruct (edges_of_one c s S) as (i & I & -> & _).
    destruct (edges_of_one c t T) as (j & J & -> & at_source & _).
    assert (on : lies_on w (edge_at c j)) by (apply (lies_on_equal (source (edge_at c j)));
      [now symmetry | apply source_lies_on]).
    pose proof (inside_one_edge i j w I J inside_ on) as same_. subst j.
    destruct inside_ as (k & range & kx & ky). destruct equal as [ex ey].
    apply (polygon_edges_are_long (edge_at c i) S). unfold along, minus. cbn [vx vy]. split; nra.
  Qed.

  (* To the left of an edge is inside, to its right is not. *)
  Lemma beside_an_edge (s : segment) (w n : vector) : In s (region_edges [c]) -> strictly_inside w s ->
    0 < cross (along s) n ->
    eventually (fun e => winding_number (moved_along w n e) (region_edges [c]) = 1%Z /\
                         winding_number (moved_along w n (- e)) (region_edges [c]) = 0%Z).
  Proof.
    intros S inside_ left_. pose proof (simple_polygons_are_regions c polygon) as (_ & _ & meet).
    refine (eventually_implied _ _ _ (left_is_one_more [c] s w n meet S (strictly_inside_lies_on _ _ inside_)
      (inside_an_edge_is_no_vertex s w S inside_) left_)).
    intros e (free & free' & one_more).
    destruct (simple_polygons_go_round_once c _ polygon free), (simple_polygons_go_round_once c _ polygon free'); lia.
  Qed.

  (* A vertex is on its two edges only. *)
  Lemma edges_at_a_vertex (i j : nat) : (i < length c)%nat -> (j < length c)%nat ->
    lies_on (vertex c i) (edge_at c j) -> j = i \/ next j (length c) = i.
  Proof.
    intros I J on. destruct (Nat.eq_dec j i) as [same_ | differ]; [now left | right].
    destruct polygon as [(N & long & common) _].
    assert (on_i : lies_on (vertex c i) (edge_at c i)) by (rewrite edge_is by exact I;
      apply (source_lies_on (Segment _ _))).
    destruct (common i j (vertex c i) I J (not_eq_sym differ) on_i on) as [[-> at_end] | [-> _]];
      [exfalso | reflexivity].
    apply (edges_of_simple_chains c i long I). unfold minus. cbn [vx vy]. destruct at_end as [X Y]. split; lra.
  Qed.
End OnePolygon.
