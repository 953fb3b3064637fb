(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* -Q + x is a simple polygon, if Q is. *)
From Coq Require Import QArith Lqa ZArith Lia Bool List.
From Oplus Require Import convolution small_numbers regions meeting_of_segments left_of_an_edge simple_chain
  simple_chains_turn_once winding_numbers_of_simple_chains signed_crossings theorem_4_2_1 polygons_of_the_thesis
  placed_collision reflected small_moves edges_of_polygons.
Import ListNotations.

Open Scope Q_scope.

Definition reflected_polygon (x : vector) (q : list vector) : list vector := map (minus x) q.

Lemma reflected_vertex (x : vector) (q : list vector) (j : nat) : (j < length q)%nat ->
  vertex (reflected_polygon x q) j = minus x (vertex q j).
Proof.
  intros J. unfold vertex, reflected_polygon. rewrite (nth_indep _ _ (minus x nowhere)) by now rewrite map_length.
  apply map_nth.
Qed.

Lemma reflected_edge (x : vector) (q : list vector) (j : nat) : (j < length q)%nat ->
  edge_at (reflected_polygon x q) j = reflected x (edge_at q j).
Proof.
  intros J. pose proof (next_in_range j _ J) as J'.
  assert (size : length (reflected_polygon x q) = length q) by apply map_length.
  rewrite !edge_is, size by (rewrite ?size; exact J). now rewrite !reflected_vertex.
Qed.

Lemma reflected_twice (x z : vector) : equal_vectors (minus x (minus x z)) z.
Proof. unfold equal_vectors, minus. cbn [vx vy]. split; ring. Qed.

Lemma reflected_polygon_is_one (x : vector) (q : list vector) : simple_polygon q ->
  simple_polygon (reflected_polygon x q).
Proof.
  intros polygon. pose proof polygon as [(N & long & common) turned].
  assert (size : length (reflected_polygon x q) = length q) by apply map_length.
  assert (simple_ : simple (reflected_polygon x q)).
  { unfold simple. rewrite size. split; [exact N |]. split.
    - intros e I. apply (In_nth _ _ nowhere) in I. destruct I as (j & J & <-). rewrite edges_length, size in J.
      fold (edge_of_chain (reflected_polygon x q) j).
      rewrite edge_of_chain_joins_vertices, size, !reflected_vertex by (rewrite ?size; trivial;
        now apply next_in_range).
      pose proof (edges_of_simple_chains q j long J) as some. intros [X Y]. apply some. unfold minus in *.
      cbn [vx vy] in *.
      split; lra.
    - intros i j y I J differ on_i on_j. rewrite reflected_edge in on_i, on_j by assumption.
      apply on_reflected in on_i, on_j.
      assert (back : forall k, (k < length q)%nat -> equal_vectors (minus x y) (vertex q k) ->
        equal_vectors y (vertex (reflected_polygon x q) k)).
      { intros k K [X Y]. rewrite reflected_vertex by exact K. unfold equal_vectors, minus in *. cbn [vx vy] in *.
        lra. }
      destruct (common i j (minus x y) I J differ on_i on_j) as [[follows there] | [follows there]];
        [left | right]; (split; [exact follows | now apply back]). }
  split; [exact simple_ |]. destruct (is_counterclockwise (reflected_polygon x q)) eqn:way; [reflexivity | exfalso].
  assert (J : (0 < length q)%nat) by lia. set (s := edge_at q 0).
  assert (S : In s (region_edges [q])) by (apply edge_at_in_region; [now left | exact J]).
  pose proof (simple_polygons_are_regions q polygon) as (_ & not_negative & meet).
  pose proof (polygon_edges_are_long q polygon s S) as s_long. pose proof (left_normal s s_long) as left_.
  assert (middle : strictly_inside (beside_a_piece.point_at s (1 # 2)) s) by (apply beside_a_piece.strictly_inside_at;
    lra).
  destruct (some_small _ (left_of_an_edge_is_inside [q] s _ _ not_negative meet S (strictly_inside_lies_on _ _ middle)
    (inside_an_edge_is_no_vertex q polygon s _ S middle) left_)) as (e & _ & free & some).
  set (z := moved_along _ _ e) in *.
  assert (free' : off (minus x (minus x z)) (region_edges [q])).
  { intros t T on. apply (free t T). apply (lies_on_equal (minus x (minus x z))); [apply reflected_twice | exact on]. }
  pose proof (winding_number_of_placed x (minus x z) [q] free') as number.
  destruct (reflected_twice x z) as [X Y]. rewrite (winding_number_of_equal _ z _ X Y) in number.
  pose proof (proj2 (off_placed x (minus x z) [q]) free') as free_placed.
  change (placed x [q]) with [reflected_polygon x q] in number, free_placed. unfold region_edges in number, free_placed.
  cbn [flat_map] in number, free_placed. rewrite app_nil_r in number, free_placed.
  pose proof (winding_numbers_of_simple_chains _ _ simple_ free_placed) as range. rewrite way in range.
  unfold region_edges in some. cbn [flat_map] in some. lia.
Qed.
