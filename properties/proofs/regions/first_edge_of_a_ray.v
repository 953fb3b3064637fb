(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* From a point off some segments, unless all are on lines through the point, there is a ray that avoids their
   ends and meets one of them first. What holds for all small enough numbers is in shifted_ray.v and
   signed_crossings.v. *)
From Coq Require Import QArith Lqa Qfield ZArith Lia Bool List.
From Oplus Require Import convolution shifted_ray signed_crossings meeting_of_segments first_hit small_numbers
  regions neighbourhoods.
Import ListNotations.

Open Scope Q_scope.

(* Between two directions that are not parallel there is one that is parallel to none of finitely many. *)
Lemma direction_avoiding (others : list vector) (a b : vector) :
  (forall c, In c others -> nonzero c) -> ~ cross a b == 0 ->
  exists t, 0 < t < 1 /\
    forall c, In c others -> ~ cross (Vector (vx a + t * (vx b - vx a)) (vy a + t * (vy b - vy a))) c == 0.
Proof.
  intros all_nonzero across.
  assert (each : forall c, In c others ->
    eventually (fun t => ~ cross (Vector (vx a + t * (vx b - vx a)) (vy a + t * (vy b - vy a))) c == 0)).
  { intros c I. destruct (Qeq_dec (cross b c) (cross a c)) as [same | turn].
    - exists 1. split; [lra |]. intros t _ _ none. apply (all_nonzero c I).
      assert (cross a c == 0) by (unfold cross in *; cbn [vx vy] in *; by_equations).
      split; apply (Qmult_inj_l _ _ (cross a b)); trivial; unfold cross in *; by_equations.
    - refine (eventually_implied _ _ _ (leaves_a_number (cross a c) (cross b c - cross a c) 0 _)); [| lra].
      intros t apart_ none. apply apart_. rewrite <- none. unfold cross. cbn [vx vy]. ring. }
  destruct (some_small _ (eventually_and _ _ (eventually_below 1 ltac:(lra)) (eventually_for_all _ others each)))
    as (t & _ & range & avoided).
  now exists t.
Qed.

(* Some direction is that of none of finitely many vectors, nor opposite. *)
Lemma direction_beside (l : list vector) : (forall v, In v l -> nonzero v) ->
  exists d, nonzero d /\ forall v, In v l -> ~ cross d v == 0.
Proof.
  intros proper_l.
  destruct (direction_avoiding l (Vector 1 0) (Vector 0 1) proper_l) as (t & range & beside);
    [unfold cross; cbn; lra |].
  exists (Vector (1 + t * (0 - 1)) (0 + t * (1 - 0))). split; [unfold nonzero; cbn; lra | exact beside].
Qed.

(* The ray from x along u. *)
Section Ray.
Variables x u : vector.

Definition side_of (p : vector) : Q := cross u (minus p x).
(* The ray's line has no end of the segment on it. *)
Definition avoids (s : segment) : Prop := ~ side_of (source s) == 0 /\ ~ side_of (target s) == 0.

Definition crosses_line (s : segment) : bool := negative (side_of (source s) * side_of (target s)).
(* Where on the ray. *)
Definition place_of_crossing (s : segment) : Q :=
  cross (minus (source s) x) (along s) / cross u (along s).

Lemma across_segment s : cross u (along s) == side_of (target s) - side_of (source s).
Proof. unfold side_of, along, cross, minus. cbn [vx vy]. ring. Qed.

Lemma crosses_line_spec s : reflect (side_of (source s) * side_of (target s) < 0) (crosses_line s).
Proof. apply negative_spec. Qed.

Lemma crossing_not_parallel s : crosses_line s = true -> ~ cross u (along s) == 0.
Proof.
  destruct (crosses_line_spec s) as [crossed |]; [intros _ | discriminate].
  rewrite across_segment. intros none.
  assert (same : side_of (target s) == side_of (source s)) by lra. rewrite same in crossed. nra.
Qed.

(* A point of the ray's line on a segment is where the segment crosses the line. *)
Lemma on_segment_is_crossing s t : avoids s -> lies_on (moved_along x u t) s ->
  crosses_line s = true /\ t == place_of_crossing s.
Proof.
  intros [source_off target_off] (r & range & x_is & y_is).
  assert (balance : (1 - r) * side_of (source s) + r * side_of (target s) == 0)
    by (unfold side_of; in_coordinates; by_equations).
  assert (opposite_sides : side_of (source s) * side_of (target s) < 0).
  { set (p := side_of (source s)) in *. set (q := side_of (target s)) in *. clearbody p q.
    destruct (Q_dec p 0) as [[p_neg | p_pos] | ?], (Q_dec q 0) as [[q_neg | q_pos] | ?];
      try contradiction; [exfalso | nra | nra | exfalso].
    - pose proof (mixed_is_less r p q 0 range p_neg q_neg). lra.
    - pose proof (mixed_is_more r p q 0 range p_pos q_pos). lra. }
  assert (crossed : crosses_line s = true) by (destruct (crosses_line_spec s); [reflexivity | contradiction]).
  split; [exact crossed |]. pose proof (crossing_not_parallel s crossed) as nonzero_cross.
  assert (value : place_of_crossing s * cross u (along s) == cross (minus (source s) x) (along s))
    by (unfold place_of_crossing; field; exact nonzero_cross).
  apply (Qmult_inj_r _ _ _ nonzero_cross). clear balance opposite_sides. set (k := place_of_crossing s) in *.
    clearbody k.
  in_coordinates. by_equations.
Qed.

(* The point a part of the way along. *)
Definition inside_segment (s : segment) (part : Q) : vector :=
  Vector (vx (source s) + part * (vx (target s) - vx (source s)))
         (vy (source s) + part * (vy (target s) - vy (source s))).

(* And there is that point, between the ends. *)
Lemma crossing_is_on_segment s : crosses_line s = true ->
  exists part, 0 < part /\ part < 1 /\ equal_vectors (moved_along x u (place_of_crossing s)) (inside_segment s part).
Proof.
  intros crossed. pose proof (crossing_not_parallel s crossed) as nonzero_cross.
  destruct (crosses_line_spec s) as [opposite_sides |]; [clear crossed | discriminate].
  pose proof (across_segment s) as across.
  set (p := side_of (source s)) in *. set (q := side_of (target s)) in *.
  assert (differ : ~ p - q == 0) by (intros none; apply nonzero_cross; rewrite across; lra).
  set (part := p / (p - q)). assert (part_is : part * (p - q) == p) by (unfold part; field; exact differ).
  exists part.
  assert (range : 0 < part /\ part < 1).
  { assert (0 < (p - q) * (p - q)) by (destruct (Q_dec (p - q) 0) as [[? | ?] | ?]; [nra | nra | contradiction]).
    assert (first_part : part * ((p - q) * (p - q)) == p * p - p * q)
      by (transitivity (part * (p - q) * (p - q)); [ring | rewrite part_is; ring]).
    assert (second_part : (1 - part) * ((p - q) * (p - q)) == q * q - p * q)
      by (transitivity ((p - q) * (p - q) - part * (p - q) * (p - q)); [ring | rewrite part_is; ring]).
    assert (0 <= p * p /\ 0 <= q * q) as [? ?] by (split; nra).
    set (square := (p - q) * (p - q)) in *. clearbody square part. split; nra. }
  destruct range as [after_start before_end]. split; [exact after_start | split; [exact before_end |]].
  assert (k_is : place_of_crossing s * cross u (along s) == cross (minus (source s) x) (along s))
    by (unfold place_of_crossing; field; exact nonzero_cross).
  set (k := place_of_crossing s) in *. clearbody k part. clear opposite_sides differ after_start before_end across.
  unfold inside_segment, p, q, side_of in *. in_coordinates.
  split; apply (Qmult_inj_l _ _ _ nonzero_cross); by_equations.
Qed.

(* Theorem. If a ray that has no end of some segments on it meets one of them, it meets one first: between its ends,
   and up to there no other point of any of them. *)
Theorem ray_meets_one_first (segments : list segment) (k : segment) (t : Q) :
  off x segments -> (forall s, In s segments -> avoids s) ->
  In k segments -> 0 < t -> lies_on (moved_along x u t) k ->
  exists s first part, In s segments /\ 0 < first /\ 0 < part /\ part < 1 /\
    ~ cross u (along s) == 0 /\
    equal_vectors (moved_along x u first) (inside_segment s part) /\
    forall other z, In other segments -> lies_on z (Segment x (moved_along x u first)) -> lies_on z other ->
      equal_vectors z (moved_along x u first).
Proof.
  intros x_off all_avoided K t_positive on_k.
  set (met := filter (fun s => crosses_line s && negative (- place_of_crossing s)) segments).
  assert (in_met : forall s o, In s segments -> 0 < o -> lies_on (moved_along x u o) s ->
    In s met /\ o == place_of_crossing s).
  { intros s o S o_positive on_s.
    destruct (on_segment_is_crossing s o (all_avoided s S) on_s) as [crossed o_is].
    split; [| exact o_is]. apply filter_In. split; [exact S |]. rewrite crossed. cbn [andb].
    destruct (negative_spec (- place_of_crossing s)); [reflexivity | lra]. }
  destruct (least_of place_of_crossing met) as (s & listed & least).
  { destruct (in_met k t K t_positive on_k) as [I _]. intros none. now rewrite none in I. }
  apply filter_In in listed. destruct listed as [S both].
  apply andb_prop in both. destruct both as [crossed positive].
  destruct (negative_spec (- place_of_crossing s)) as [s_positive |]; [| discriminate].
  destruct (crossing_is_on_segment s crossed) as (part & after_start & before_end & there).
  exists s, (place_of_crossing s), part.
  split; [exact S |]. split; [lra |]. split; [exact after_start |]. split; [exact before_end |].
  split; [now apply crossing_not_parallel | split; [exact there |]].
  intros other z O (r & range & xz & yz) on_other. cbn [source target] in *.
  set (first := place_of_crossing s) in *.
  assert (z_is : equal_vectors z (moved_along x u (r * first))).
  { unfold moved_along, equal_vectors in *. cbn [vx vy] in *. rewrite xz, yz. split; ring. }
  apply (lies_on_equal z (moved_along x u (r * first))) in on_other; [| exact z_is].
  assert (of_equal : forall o, o == r * first -> equal_vectors (moved_along x u o) (moved_along x u (r * first))).
  { intros o o_is. unfold equal_vectors, moved_along. cbn [vx vy]. rewrite o_is. split; reflexivity. }
  destruct (Qlt_le_dec 0 r) as [r_positive | r_zero].
  - assert (0 < r * first) by (apply Qmult_lt_0_compat; lra).
    destruct (in_met other (r * first) O) as [other_met place_is]; trivial.
    specialize (least other other_met). fold first in least. rewrite <- place_is in least.
    rewrite z_is. symmetry. apply of_equal. nra.
  - exfalso. apply (x_off other O). apply (lies_on_equal (moved_along x u (r * first))); [| exact on_other].
    assert (r_is : r == 0) by lra. unfold equal_vectors, moved_along. cbn [vx vy]. rewrite r_is. split; ring.
Qed.

End Ray.

Lemma ends_are_not (x : vector) (s : segment) : ~ lies_on x s ->
  nonzero (minus (source s) x) /\ nonzero (minus (target s) x).
Proof.
  intros x_off. unfold nonzero, minus. cbn [vx vy].
  split; intros [x_is y_is]; apply x_off; [exists 0 | exists 1]; repeat split; lra.
Qed.

(* Theorem. Where the winding number with respect to some segments is not zero, a ray that has no end of any of
   finitely many segments on it meets one of them. *)
Theorem ray_to_a_segment (segments all : list segment) (x : vector) :
  off x all -> incl segments all -> winding_number x segments <> 0%Z ->
  exists u k, (forall s, In s all -> avoids x u s) /\ In k segments /\ lies_on (moved_along x u 1) k.
Proof.
  intros x_off among winds.
  assert (found : exists k, In k segments /\ ~ cross (minus (source k) x) (minus (target k) x) == 0).
  { destruct (forallb (fun s => zero (cross (minus (source s) x) (minus (target s) x))) segments) eqn:in_line.
    - exfalso. apply winds. rewrite winding_number_as_sweeps by (intros s I; now apply x_off, among).
      unfold total, sum. rewrite map_map. rewrite forallb_forall in in_line.
      clear - in_line. induction segments as [| s rest IH]; [reflexivity |].
      cbn [map fold_right]. rewrite IH by (intros; apply in_line; now right).
      specialize (in_line s (or_introl eq_refl)). cbn [seen_from fst snd]. unfold sweep.
      destruct (zero_spec (cross (minus (source s) x) (minus (target s) x))); [| discriminate].
      compared_numbers (cross (minus (source s) x) (minus (target s) x) ?= 0); [reflexivity | lra | lra].
    - clear - in_line. induction segments as [| s rest IH]; [discriminate |].
      cbn [forallb] in in_line. apply andb_false_iff in in_line. destruct in_line as [here | there].
      + exists s. split; [now left |].
        destruct (zero_spec (cross (minus (source s) x) (minus (target s) x))); [discriminate | assumption].
      + destruct (IH there) as (k & K & across). exists k. split; [now right | exact across]. }
  destruct found as (k & K & across).
  destruct (direction_avoiding (flat_map (fun s => [minus (source s) x; minus (target s) x]) all)
              (minus (source k) x) (minus (target k) x)) as (t & range & avoided); [| exact across |].
  { intros c I. apply in_flat_map in I. destruct I as (s & S & I).
    destruct (ends_are_not x s (x_off s S)) as [source_off target_off].
    destruct I as [<- | [<- | []]]; assumption. }
  set (u := Vector _ _) in avoided. exists u, k. split; [| split; [exact K |]].
  - intros s S. unfold avoids, side_of.
    split; apply avoided; apply in_flat_map; exists s; (split; [exact S |]); cbn; tauto.
  - exists t. unfold moved_along, u, minus. cbn [vx vy]. repeat split; try lra; ring.
Qed.
