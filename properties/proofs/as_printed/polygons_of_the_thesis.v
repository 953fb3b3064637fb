(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Polygons as the thesis has them are regions as the proofs have them, so that the files of this folder can say what
   the thesis says. A simple polygon (Definition 2.1.12) is one closed chain that meets itself nowhere,
   counterclockwise, so that its interior is to the left of its edges. A region is a list of closed chains. The proofs
   ask of it that no edge is a point, that edges meet in vertices only (a vertex may touch the inside of an edge), and
   that chains go round no point clockwise more often than counterclockwise: `valid_region`. Collections of simple
   chains as in Definition 2.1.17 are such (valid_components_are_valid_regions), and simple polygons are, which is
   proved here. *)
From Coq Require Import Lia List.
From Oplus Require Import numbers convolution regions meeting_of_segments simple_chain simple_chains_turn_once
  valid_components winding_numbers_of_valid_regions theorem_4_2_1 theorem_4_2_1_for_valid_regions boundary_points
  collision_is_complete.
Import ListNotations.

Open Scope Q_scope.

Definition simple_polygon (chain : list vector) : Prop := simple chain /\ is_counterclockwise chain = true.

Lemma simple_polygon_is_a_component (chain : list vector) :
  simple_polygon chain -> valid_components [Component chain []].
Proof.
  intros [chain_simple turned]. split; [| repeat constructor].
  intros c [<- | []]. split; [exact chain_simple | split; [exact turned |]]. split; [intros h [] | constructor].
Qed.

Lemma edges_of_a_polygon (chain : list vector) : edges_of_components [Component chain []] = region_edges [chain].
Proof. apply edges_of_region_are_its_chains. Qed.

(* Theorem. A simple polygon is a valid region. *)
Theorem simple_polygons_are_regions (chain : list vector) : simple_polygon chain -> valid_region [chain].
Proof.
  intros polygon. now apply (valid_components_are_valid_regions [Component chain []]), simple_polygon_is_a_component.
Qed.

(* Its winding numbers are 0 and 1. *)
Lemma simple_polygons_go_round_once (chain : list vector) (x : vector) :
  simple_polygon chain -> off x (region_edges [chain]) ->
  winding_number x (region_edges [chain]) = 0%Z \/ winding_number x (region_edges [chain]) = 1%Z.
Proof.
  rewrite <- edges_of_a_polygon. intros polygon.
  now apply winding_numbers_of_valid_regions, simple_polygon_is_a_component.
Qed.

Lemma simple_polygons_cover_nothing_twice (chain : list vector) : simple_polygon chain -> nowhere_above_one [chain].
Proof. intros polygon x free. destruct (simple_polygons_go_round_once chain x polygon free) as [-> | ->]; lia. Qed.

(* It does not touch itself. *)
Lemma simple_polygons_do_not_touch (chain : list vector) : simple_polygon chain -> chains_do_not_touch [chain].
Proof.
  intros [(N & e & common) _] c i [<- | []] I.
  pose proof (previous_below _ _ I) as P.
  split; [now apply edge_at_in_region; [left |] |]. split; [now apply edge_at_in_region; [left |] |].
  rewrite !edge_at_is by assumption. cbn [source target]. rewrite next_previous by exact I.
  split; [split; reflexivity |].
  intros t T on. destruct (edge_by_chain [chain] t T) as (c & j & [<- | []] & J & ->).
  destruct (Nat.eq_dec i j) as [-> | differ]; [right; now rewrite <- edge_at_is |].
  assert (on_i : lies_on (nth i chain nowhere) (edge_at chain i))
    by (rewrite edge_at_is by exact I; apply (source_lies_on (Segment _ _))).
  destruct (common i j (nth i chain nowhere) I J differ on_i on) as [[follows [X Y]] | [follows _]].
  - exfalso. subst j. apply (edges_of_simple_chains chain i e I). unfold vertex in *.
    unfold minus; cbn [vx vy]. rewrite X, Y. split; ring.
  - left. subst i. now rewrite previous_next, edge_at_is by exact J.
Qed.

(* -Q + x as a set of points, and as the region of collision/placed_collision.v, whose edges are those of Q,
   reflected. *)
Definition in_reflected (x : vector) (q : region) (z : vector) : Prop :=
  exists b, in_region b q /\ equal_vectors z (minus x b).

(* z is in the intersection of P and -Q + x: the thesis's way to say that x is in the sum. *)
Lemma sum_as_intersection (p q : region) (x : vector) :
  in_sum x p q <-> exists z, in_region z p /\ in_reflected x q z.
Proof.
  split.
  - intros (a & b & in_p & in_q & X & Y). exists a. split; [exact in_p |]. exists b. split; [exact in_q |].
    unfold plus, minus in *. split; cbn [vx vy] in *; lra.
  - intros (a & in_p & b & in_q & X & Y). exists a, b. split; [exact in_p |]. split; [exact in_q |].
    unfold plus, minus in *. split; cbn [vx vy] in *; lra.
Qed.
