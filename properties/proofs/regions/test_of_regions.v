(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* A check, by finitely many comparisons, of what the theorems on Minkowski sums ask of a region: no edge is a
   point, edges meet in vertices only, and winding numbers are nowhere negative; and a check that chains do not touch,
   which they otherwise may. That chains are simple and holes inside them is tested in test_of_components.v. Pairs of
   edges are checked by signs of areas, winding numbers beside the middles of edges (right_of_an_edge.v). *)
From Coq Require Import ZArith Lia Bool List Arith.
From Oplus Require Import numbers regions_and_sums observation_2_2_4 right_of_an_edge inside_a_corner boundary_points
  location.
Import ListNotations.

Open Scope Q_scope.

(* Both ends of t are strictly on one side of the line of s. *)
Definition on_one_side (s t : segment) : bool :=
  let a := area s (source t) in let b := area s (target t) in
  (negative a && negative b) || (negative (- a) && negative (- b)).

(* Exactly one end of t is on the line of s. *)
Definition one_end_on_the_line (s t : segment) : bool :=
  xorb (zero (area s (source t))) (zero (area s (target t))).

(* t is on the line of s, and not between its ends. *)
Definition one_after_the_other (s t : segment) : bool :=
  let a := dot (along s) (minus (source t) (source s)) in let b := dot (along s) (minus (target t) (source s)) in
  let len := dot (along s) (along s) in
  zero (area s (source t)) && zero (area s (target t)) &&
  ((negb (negative (- a)) && negb (negative (- b))) || (negb (negative (a - len)) && negb (negative (b - len)))).

Definition meet_at_ends (s t : segment) : bool :=
  on_one_side s t || on_one_side t s || one_end_on_the_line s t || one_end_on_the_line t s ||
  one_after_the_other s t.

Definition same_number (a b : Q) : bool := if identical_dec a b then true else false.
Definition same_coordinates (a b : vector) : bool := same_number (vx a) (vx b) && same_number (vy a) (vy b).
Definition same_segment (s t : segment) : bool :=
  same_coordinates (source s) (source t) && same_coordinates (target s) (target t).

(* Only its two edges come to a vertex. *)
Definition vertex_is_alone (r : region) (chain : list vector) (i : nat) : bool :=
  forallb (fun t => negb (is_on_segment (nth i chain nowhere) t) ||
                    same_segment t (edge_at chain (previous (length chain) i)) ||
                    same_segment t (edge_at chain i)) (region_edges r).

(* A vertex on the edge is at one of its ends. *)
Definition at_an_end (v : vector) (s : segment) : bool :=
  (zero (vx v - vx (source s)) && zero (vy v - vy (source s))) ||
  (zero (vx v - vx (target s)) && zero (vy v - vy (target s))).

Definition edge_is_clear (r : region) (s : segment) : bool :=
  forallb (fun t => negb (is_on_segment (source t) s) || at_an_end (source t) s) (region_edges r).

(* Chains may touch in vertices; where a vertex touches the inside of an edge, the edge has to have a vertex, too. *)
Definition is_valid_region (r : region) : bool :=
  forallb (fun s => negb (zero (vx (along s)) && zero (vy (along s)))) (region_edges r) &&
  all_pairs meet_at_ends (region_edges r) && forallb (edge_is_clear r) (region_edges r) &&
  forallb (fun s => (0 <=? winding_number_shifted (right_of_middle s) (region_edges r))%Z) (region_edges r).

Definition does_not_touch (r : region) : bool :=
  forallb (fun chain => forallb (vertex_is_alone r chain) (seq 0 (length chain))) r.

Lemma area_of_common_point (s t : segment) (w : vector) (k : Q) :
  lies_on w s -> vx w == (1 - k) * vx (source t) + k * vx (target t) ->
  vy w == (1 - k) * vy (source t) + k * vy (target t) ->
  (1 - k) * area s (source t) + k * area s (target t) == 0.
Proof.
  intros (h & _ & wx & wy) X Y.
  in_coordinates. by_equations.
Qed.

Definition is_end (w : vector) (s : segment) : Prop := equal_vectors w (source s) \/ equal_vectors w (target s).

Lemma on_one_side_is_apart (s t : segment) (w : vector) :
  on_one_side s t = true -> lies_on w s -> lies_on w t -> False.
Proof.
  intros check on_s (k & [k0 k1] & X & Y). pose proof (area_of_common_point s t w k on_s X Y) as zero_.
  unfold on_one_side in check. set (a := area s (source t)) in *. set (b := area s (target t)) in *. clearbody a b.
  destruct (negative_spec a), (negative_spec b), (negative_spec (- a)), (negative_spec (- b)); try discriminate check;
    try lra.
  - pose proof (mixed_is_less k a b 0 (conj k0 k1) ltac:(assumption) ltac:(assumption)). lra.
  - pose proof (mixed_is_more k a b 0 (conj k0 k1) ltac:(lra) ltac:(lra)). lra.
Qed.

Lemma one_end_is_common (s t : segment) (w : vector) :
  one_end_on_the_line s t = true -> lies_on w s -> lies_on w t -> is_end w t.
Proof.
  intros check on_s (k & [k0 k1] & X & Y). pose proof (area_of_common_point s t w k on_s X Y) as zero_.
  unfold one_end_on_the_line in check. set (a := area s (source t)) in *. set (b := area s (target t)) in *.
  clearbody a b.
  destruct (zero_spec a) as [a_zero | a_some], (zero_spec b) as [b_zero | b_some]; try discriminate check.
  - left. rewrite a_zero in zero_. assert (k == 0) as k_is.
    { apply (Qmult_inj_r _ _ b b_some). lra. }
    rewrite k_is in X, Y. split; lra.
  - right. rewrite b_zero in zero_. assert (k == 1) as k_is.
    { assert (1 - k == 0); [| lra]. apply (Qmult_inj_r _ _ a a_some). lra. }
    rewrite k_is in X, Y. split; lra.
Qed.

Lemma one_after_the_other_has_common_ends (s t : segment) (w : vector) :
  nonzero (along s) -> one_after_the_other s t = true -> lies_on w s -> lies_on w t -> is_end w s.
Proof.
  intros long check (h & [h0 h1] & wx & wy) (k & [k0 k1] & X & Y).
  unfold one_after_the_other in check. cbv zeta in check.
  set (a := dot (along s) (minus (source t) (source s))) in *.
  set (b := dot (along s) (minus (target t) (source s))) in *. set (len := dot (along s) (along s)) in *.
  assert (some : 0 < len) by exact (square_positive _ long).
  assert (where_ : (1 - k) * a + k * b == h * len).
  { assert (by_t : (1 - k) * a + k * b == dot (along s) (minus w (source s)))
      by (unfold a, b, dot, minus; cbn [vx vy]; rewrite X, Y; ring).
    rewrite by_t. unfold len, dot, along, minus; cbn [vx vy]. rewrite wx, wy. ring. }
  clearbody a b len.
  assert (cases : (a <= 0 /\ b <= 0) \/ (len <= a /\ len <= b)).
  { destruct (zero (area s (source t))), (zero (area s (target t))); try discriminate check. cbn [andb] in check.
    destruct (negative_spec (- a)), (negative_spec (- b)), (negative_spec (a - len)), (negative_spec (b - len));
      try discriminate check; lra. }
  destruct cases as [[a_low b_low] | [a_high b_high]]; [left | right].
  - assert (h == 0) as h_is by nra. rewrite h_is in wx, wy. split; lra.
  - assert (h == 1) as h_is by nra. rewrite h_is in wx, wy. split; lra.
Qed.

Lemma meet_at_ends_is_right (s t : segment) (w : vector) :
  nonzero (along s) -> meet_at_ends s t = true -> lies_on w s -> lies_on w t -> is_end w s \/ is_end w t.
Proof.
  unfold meet_at_ends. intros long check on_s on_t. rewrite !orb_true_iff in check.
  destruct check as [[[[check | check] | check] | check] | check].
  - exfalso. exact (on_one_side_is_apart s t w check on_s on_t).
  - exfalso. exact (on_one_side_is_apart t s w check on_t on_s).
  - right. exact (one_end_is_common s t w check on_s on_t).
  - left. exact (one_end_is_common t s w check on_t on_s).
  - left. exact (one_after_the_other_has_common_ends s t w long check on_s on_t).
Qed.

Lemma end_is_vertex (r : region) (s : segment) (w : vector) : In s (region_edges r) -> is_end w s -> is_vertex w r.
Proof.
  intros I [equal | [X Y]]; [now exists s |].
  destruct (target_is_vertex r s I) as (u & J & tx & ty). exists u. split; [exact J |]. split; lra.
Qed.

Lemma same_segment_is_right (s t : segment) : same_segment s t = true -> s = t.
Proof.
  destruct s as [[a b] [c d]], t as [[a' b'] [c' d']].
  unfold same_segment, same_coordinates, same_number. cbn [source target vx vy].
  repeat match goal with |- context [identical_dec ?u ?v] => destruct (identical_dec u v) as [-> |] end;
    (reflexivity || discriminate).
Qed.

Lemma edge_is_clear_is_right (r : region) (s : segment) :
  nonzero (along s) -> edge_is_clear r s = true -> clear_edge r s.
Proof.
  intros long check k w range X Y (t & I & [tx ty]). unfold edge_is_clear in check.
  rewrite forallb_forall in check. specialize (check t I).
  assert (on : lies_on (source t) s) by (exists k; rewrite <- tx, <- ty; split; [lra | now split]).
  rewrite (proj1 (reflect_iff _ _ (is_on_spec _ _)) on) in check. cbn [negb orb] in check. unfold at_an_end in check.
  rewrite tx in X. rewrite ty in Y. apply long. unfold along, minus; cbn [vx vy].
  destruct (zero_spec (vx (source t) - vx (source s))), (zero_spec (vy (source t) - vy (source s)));
    cbn [andb orb] in check;
    try (split; apply (Qmult_inj_r _ _ k); lra);
    destruct (zero_spec (vx (source t) - vx (target s))), (zero_spec (vy (source t) - vy (target s)));
    try discriminate check; split; apply (Qmult_inj_r _ _ (1 - k)); lra.
Qed.

(* Theorem. What passes the first check is a valid region. *)
Theorem is_valid_region_is_right (r : region) : is_valid_region r = true -> valid_region r.
Proof.
  unfold is_valid_region. rewrite !andb_true_iff, !forallb_forall. intros (((long & pairs) & clear_) & middles).
  assert (not_points : forall s, In s (region_edges r) -> nonzero (along s)).
  { intros s I [X Y]. specialize (long s I).
    destruct (zero_spec (vx (along s))), (zero_spec (vy (along s))); try discriminate long; contradiction. }
  assert (r_edges : no_edges_are_points r).
  { intros chain I e J. unfold edge_directions in J. apply in_map_iff in J. destruct J as (s & <- & J).
    apply not_points. apply in_flat_map. now exists chain. }
  assert (meet : edges_meet_in_vertices r).
  { intros earlier s later t w edges_are J on_s on_t.
    assert (I : In s (region_edges r)) by (rewrite edges_are; apply in_app_iff; right; now left).
    assert (K : In t (region_edges r))
      by (rewrite edges_are; apply in_app_iff; apply in_app_iff in J; destruct J; [now left | right; now right]).
    apply (all_pairs_sound meet_at_ends (fun a b => meet_at_ends a b = true)) in pairs; [| trivial].
    rewrite edges_are in pairs. destruct (pair_at _ earlier later s t pairs J) as [check | check].
    - destruct (meet_at_ends_is_right s t w (not_points s I) check on_s on_t) as [end_ | end_].
      + exact (end_is_vertex r s w I end_).
      + exact (end_is_vertex r t w K end_).
    - destruct (meet_at_ends_is_right t s w (not_points t K) check on_t on_s) as [end_ | end_].
      + exact (end_is_vertex r t w K end_).
      + exact (end_is_vertex r s w I end_). }
  split; [exact r_edges |]. split; [| exact meet].
  apply nowhere_negative_by_middles; trivial.
  - intros s I. apply edge_is_clear_is_right; [now apply not_points | now apply clear_].
  - intros s I. apply Z.leb_le. now apply middles.
Qed.

(* Theorem. What passes the second has no chains that touch. *)
Theorem does_not_touch_is_right (r : region) : does_not_touch r = true -> chains_do_not_touch r.
Proof.
  unfold does_not_touch. rewrite forallb_forall. intros alone chain i I below.
  split; [now apply edge_at_in_region; [| apply previous_below] |].
  split; [now apply edge_at_in_region |]. rewrite !edge_at_is by (trivial; now apply previous_below).
  cbn [source target]. rewrite next_previous by exact below. split; [split; reflexivity |].
  intros t J on. specialize (alone chain I). rewrite forallb_forall in alone.
  assert (in_range : In i (seq 0 (length chain))) by (apply in_seq; lia).
  specialize (alone i in_range). unfold vertex_is_alone in alone.
  rewrite forallb_forall in alone. specialize (alone t J).
  rewrite (proj1 (reflect_iff _ _ (is_on_spec _ _)) on) in alone.
  cbn [negb orb] in alone. apply orb_prop in alone.
  rewrite !edge_at_is, next_previous in alone by (trivial; now apply previous_below).
  destruct alone as [same_ | same_]; apply same_segment_is_right in same_; tauto.
Qed.
