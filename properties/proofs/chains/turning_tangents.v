(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Hopf's theorem of turning tangents (thesis, Definition 2.1.9) for chains whose first vertex is extreme:
   all others are on one side of a line through it. The secants from it and to it then stay on one side of
   that line, so what is passed is passed at that vertex, once. Secants are in secants.v; simple_chain.v
   says that simple chains are such chains, simple_chains_turn_once.v proves the theorem for all of them. *)
From Coq Require Import ZArith Lia Bool List.
From Oplus Require Import numbers winding rotation tangent_set turning_number secants.
Import ListNotations.

Open Scope Q_scope.

(* u is met in the half turn that begins at d, turned by an infinitesimal: clockwise if s is OfP, so that
   d itself is, counterclockwise if it is OfQ, so that the opposite of d is. *)
Definition in_half_turn (s : summand) (d u : vector) : Prop :=
  0 < cross d u \/
  (cross d u == 0 /\ match s with OfP => 0 < dot d u | OfQ => dot d u < 0 end).

Lemma half_turn_nonzero (s : summand) (d u : vector) : in_half_turn s d u -> nonzero u.
Proof.
  unfold in_half_turn, cross, dot, nonzero. intros [o | [_ o]] [x_is y_is];
    [| destruct s]; rewrite x_is, y_is in o; lra.
Qed.

Lemma opposite_cross (d u : vector) : cross d (opposite u) == - cross d u /\ dot d (opposite u) == - dot d u.
Proof. unfold cross, dot, opposite. cbn [vx vy]. split; ring. Qed.

(* Where a ray along d is crossed says on which of its sides a turn begins and ends. *)
Ltac by_sides d :=
  let sides := fresh "sides" in
  assert (sides : forall a, cross a d == - cross d a /\ cross d (opposite a) == - cross d a /\
    cross (opposite a) d == cross d a /\ dot d (opposite a) == - dot d a)
    by (intros; unfold cross, dot, opposite; cbn [vx vy]; repeat split; ring);
  unfold ray_crossing, left_of_ray;
  repeat match goal with |- context [negative (cross ?a ?b)] =>
    destruct (sides a), (sides b), (negative_spec (cross a b)); try (exfalso; lra) end;
  cbn [negb Bool.eqb]; trivial;
  try match goal with |- context [?a ?= 0] => compared_numbers (a ?= 0) end; trivial.

(* A turn within a half turn does not pass where that begins, nor the opposite. *)
Lemma turn_within_a_half_turn (s : summand) (d u v : vector) :
  nonzero d ->
  (in_half_turn s d u /\ in_half_turn s d v) \/
  (in_half_turn s d (opposite u) /\ in_half_turn s d (opposite v)) ->
  sweep (Direction d s) u v = 0%Z.
Proof.
  intros nd within. pose proof (square_positive d nd) as square.
  assert (proper : forall a, in_half_turn s d a \/ in_half_turn s d (opposite a) -> nonzero a).
  { intros a [one | one]; apply half_turn_nonzero in one; [exact one |].
    intros [x_is y_is]. apply one. unfold opposite. cbn [vx vy]. lra. }
  rewrite sweep_by_sides by (trivial; apply proper; tauto). clear proper.
  assert (turn : dot d d * cross u v == dot d u * cross d v - cross d u * dot d v)
    by (unfold cross, dot; ring).
  destruct (opposite_cross d u), (opposite_cross d v). unfold in_half_turn in within.
  destruct s, within as [[[U | [U U']] [V | [V V']]] | [[U | [U U']] [V | [V V']]]]; by_sides d; exfalso; nra.
Qed.

(* From one half turn to the other and back, once along the edges of a vertex, once along their opposites. *)
Lemma there_and_back (s : summand) (d u v : vector) :
  nonzero d -> turns u v -> in_half_turn s d (opposite u) -> in_half_turn s d v ->
  (sweep (Direction d s) u v + sweep (Direction d s) (opposite u) (opposite v))%Z =
  if negative (cross u v) then (-1)%Z else 1%Z.
Proof.
  intros nd (nu & nv & ahead) before_it after_it. pose proof (square_positive d nd) as square.
  rewrite !sweep_by_sides by (trivial; now apply opposite_nonzero).
  rewrite (compare_as_difference (cross (opposite u) (opposite v)) 0 (cross u v) 0)
    by (unfold cross, opposite; cbn [vx vy]; ring).
  assert (turn : dot d d * cross u v == dot d u * cross d v - cross d u * dot d v)
    by (unfold cross, dot; ring).
  assert (scalar : dot d d * dot u v == dot d u * dot d v + cross d u * cross d v)
    by (unfold cross, dot; ring).
  destruct (opposite_cross d u), (opposite_cross d v). unfold in_half_turn in *.
  assert (turning : ~ cross u v == 0).
  { intros none. specialize (ahead none). rewrite none in turn.
    assert (same : dot d u * dot d v * (cross d u * cross d v) == dot d u * cross d v * (dot d u * cross d v))
      by (clear - turn; by_equations).
    assert (0 < dot d u * dot d v + cross d u * cross d v) by nra.
    assert (0 <= dot d u * cross d v * (dot d u * cross d v)) by nra.
    assert (opposite_sides : cross d u < 0 /\ 0 < cross d v \/ cross d u * cross d v == 0)
      by (destruct before_it as [U | [U _]], after_it as [V | [V _]]; [left; lra | right; nra ..]).
    destruct opposite_sides as [[U V] | zero_]; [assert (cross d u * cross d v < 0) by nra; nra |].
    destruct s, before_it as [U | [U U']], after_it as [V | [V V']]; nra. }
  destruct (negative_spec (cross u v)), s, before_it as [U | [U U']], after_it as [V | [V V']];
    by_sides d; exfalso; nra.
Qed.

(* The same vector, however its coordinates are written. *)
Lemma sweep_of_equal (d : direction) (u v u' v' : vector) :
  equal_vectors u u' -> equal_vectors v v' -> sweep d u v = sweep d u' v'.
Proof.
  intros eu ev. pose proof (compare_angle_of_equal) as angles. destruct d as [d s].
  assert (own : equal_vectors d d) by reflexivity. unfold sweep, ccw, before, compare. cbn [vec of].
  rewrite (angles u u' d d), (angles d d u u'), (angles v v' d d), (angles d d v v'), (angles u u' v v'),
    (angles v v' u u') by assumption.
  destruct eu as [xu yu], ev as [xv yv].
  now rewrite (compare_as_difference (cross u v) 0 (cross u' v') 0) by (unfold cross; rewrite xu, yu, xv, yv; ring).
Qed.

Lemma half_turn_of_equal (s : summand) (d u v : vector) :
  equal_vectors u v -> in_half_turn s d u -> in_half_turn s d v.
Proof. intros [x_is y_is]. unfold in_half_turn, cross, dot. destruct s; rewrite x_is, y_is; trivial. Qed.

Lemma opposite_of_minus (a b : vector) : equal_vectors (opposite (minus a b)) (minus b a).
Proof. unfold equal_vectors, opposite, minus. cbn [vx vy]. split; ring. Qed.

(* A chain as the path of its edges, from the last to the first and on to the last. *)
Lemma steps_of_edges (a : vector) (rest : list vector) : edge_directions (a :: rest) = steps (a :: rest ++ [a]).
Proof.
  unfold edge_directions, edges. rewrite map_map. cbn [source target rotated].
  assert (path : forall z, map (fun ends => minus (snd ends) (fst ends)) (combine (a :: rest) (rest ++ [z])) =
                           steps (a :: rest ++ [z])); [| exact (path a)].
  revert a. induction rest as [| b rest IH]; intros a z; [reflexivity |].
  exact (f_equal (cons (minus b a)) (IH b z)).
Qed.

Lemma steps_more (path : list vector) (a z : vector) : steps (path ++ [a; z]) = steps (path ++ [a]) ++ [minus z a].
Proof.
  induction path as [| p path IH]; [reflexivity |]. destruct path as [| q path]; [reflexivity |].
  cbn [app steps] in *. now rewrite IH.
Qed.

Lemma combined_in_succession (f : vector -> vector -> Z) (us : list vector) (u z : vector) :
  total (fun p => f (fst p) (snd p)) (combine (u :: us) (us ++ [z])) = in_succession f (u :: us ++ [z]).
Proof.
  revert u. induction us as [| v us IH]; intros u; [reflexivity |].
  exact (f_equal (Z.add (f u v)) (IH v)).
Qed.

Lemma turns_past_is_along (d : vector) (s : summand) (a z : vector) (middle : list vector) :
  turns_past (Direction d s) (a :: middle ++ [z]) = turns_along d s (z :: a :: middle ++ [z; a]).
Proof.
  rewrite turns_past_total. unfold turns_of, turns_along.
  rewrite steps_of_edges, <- app_assoc. cbn [app].
  change (steps (z :: a :: middle ++ [z; a])) with (minus a z :: steps ((a :: middle) ++ [z; a])).
  change (a :: middle ++ [z; a]) with ((a :: middle) ++ [z; a]). rewrite steps_more.
  rewrite <- combined_in_succession. f_equal. f_equal.
  unfold from_the_last. rewrite rev_unit, rev_involutive. reflexivity.
Qed.

Lemma seen_along_more (d : vector) (s : summand) (p y z : vector) (path : list vector) :
  seen_along d s p (path ++ [y; z]) =
  (seen_along d s p (path ++ [y]) + sweep (Direction d s) (minus y p) (minus z p))%Z.
Proof.
  unfold seen_along. induction path as [| a path IH]; [cbn; lia |]. destruct path as [| b path]; [cbn; lia |].
  cbn [app map in_succession] in *. rewrite IH. lia.
Qed.

Lemma nothing_in_succession (f : vector -> vector -> Z) (us : list vector) :
  (forall u v, In u us -> In v us -> f u v = 0%Z) -> in_succession f us = 0%Z.
Proof.
  induction us as [| u [| v us] IH]; intros none; [reflexivity .. |]. cbn [in_succession] in *.
  rewrite IH, none by (intros; try apply none; cbn in *; tauto). reflexivity.
Qed.

(* Of a vertex beyond which all of a path is, the secants from and to the path pass nothing. *)
Lemma nothing_seen (d : vector) (s : summand) (v : vector) (path : list vector) :
  nonzero d -> (forall a, In a path -> in_half_turn s d (minus a v)) ->
  seen_along d s v path = 0%Z /\ seen_towards d s v path = 0%Z.
Proof.
  intros nd all. split; apply nothing_in_succession; intros u w I J; apply in_map_iff in I, J;
    destruct I as (a & <- & I), J as (b & <- & J); apply turn_within_a_half_turn; trivial; [left | right];
    split; auto; apply (half_turn_of_equal s d _ _ (symmetry (opposite_of_minus _ _))); auto.
Qed.

(* What a chain from v over a, more vertices, and z back to v passes: what its secants from v pass and those to
   v, and twice what is passed at v. *)
Theorem chain_turns_as_the_secants_of_a_vertex (d : vector) (s : summand) (v a z : vector)
    (middle : list vector) :
  nonzero d -> turns (minus v z) (minus a v) ->
  without_crossings (v :: a :: middle ++ [z]) -> without_crossings (a :: middle ++ [z; v]) ->
  turns_past (Direction d s) (v :: a :: middle ++ [z]) =
  (seen_along d s v (a :: middle ++ [z]) + seen_towards d s v (a :: middle ++ [z]) +
   sweep (Direction d s) (minus v z) (minus a v) + sweep (Direction d s) (minus z v) (minus v a))%Z.
Proof.
  intros nd at_v first_free last_free.
  change (v :: a :: middle ++ [z]) with (v :: (a :: middle) ++ [z]) at 1. rewrite turns_past_is_along.
  set (turn u w := sweep (Direction d s) u w).
  destruct (middle ++ [z]) as [| b rest] eqn:e; [destruct middle; discriminate e |].
  assert (second : hd z middle = b) by (destruct middle; cbn in e |- *; congruence).
  assert (closing : middle ++ [z; v] = (middle ++ [z]) ++ [v]) by now rewrite <- app_assoc.
  rewrite <- app_comm_cons.
  assert (path : turns_along d s (z :: v :: a :: middle ++ [z; v]) =
    (turn (minus v z) (minus a v) + turn (minus a v) (minus b a) +
     turns_along d s (a :: middle ++ [z; v]))%Z).
  { rewrite closing, e. unfold turns_along, turn. cbn [app steps in_succession]. lia. }
  rewrite path. clear path.
  pose proof (path_turns_as_its_secants d s v (middle ++ [z]) nd a) as secants.
  rewrite <- closing in secants. specialize (secants last_free). rewrite secants. clear secants.
  rewrite seen_along_more.
  cbn [without_crossings] in first_free. destruct first_free as (at_a & far & _). rewrite <- e in far |- *.
  pose proof (strip d s v a z middle nd far) as cells. cbv zeta in cells. rewrite second in cells.
  assert (first_leg : seen_along d s v (a :: middle ++ [z]) =
    (turn (minus a v) (minus b v) + seen_along d s v (middle ++ [z]))%Z) by (rewrite e; reflexivity).
  rewrite first_leg.
  assert (back : turns (minus z v) (minus v a)).
  { destruct at_v as (n_in & n_out & ahead). unfold turns, nonzero, cross, dot, minus in *. cbn [vx vy] in *.
    split; [lra | split; [lra |]]. intros straight. eapply Qlt_le_trans; [apply ahead |]; lra. }
  pose proof (by_way_of_the_sum d (minus a v) (minus b a) (minus b v) s nd at_a ltac:(cbn; ring) ltac:(cbn; ring)).
  pose proof (by_way_of_the_sum d (minus z v) (minus v a) (minus z a) s nd back ltac:(cbn; ring) ltac:(cbn; ring)).
  unfold turn in *. lia.
Qed.

Lemma first_corner (v a z : vector) (middle : list vector) :
  In (Corner (minus v z) (minus a v)) (corners (v :: a :: middle ++ [z])).
Proof.
  unfold corners. rewrite steps_of_edges, <- app_comm_cons, <- app_assoc. cbn [app].
  change (v :: a :: middle ++ [z; v]) with ((v :: a :: middle) ++ [z; v]). rewrite steps_more.
  unfold from_the_last. rewrite rev_unit. left. reflexivity.
Qed.

(* Theorem. A chain from v over a, more vertices, and z back to v, all but v on one side of a line through
   v, nowhere turning back and without crossings, turns once: to the left if it does so at v. *)
Theorem turns_once_at_an_extreme_vertex (d : vector) (s : summand) (v a z : vector) (middle : list vector) :
  nonzero d ->
  turns_everywhere (v :: a :: middle ++ [z]) ->
  without_crossings (v :: a :: middle ++ [z]) -> without_crossings (a :: middle ++ [z; v]) ->
  (forall b, In b (a :: middle ++ [z]) -> in_half_turn s d (minus b v)) ->
  turning_number (v :: a :: middle ++ [z]) =
  if is_reflex (Corner (minus v z) (minus a v)) then (-1)%Z else 1%Z.
Proof.
  intros nd everywhere first_free last_free extreme.
  pose proof (everywhere _ (first_corner v a z middle)) as at_v. cbn [incoming outgoing] in at_v.
  rewrite <- (turns_past_every_direction _ (Direction d s) everywhere nd).
  rewrite chain_turns_as_the_secants_of_a_vertex by assumption.
  destruct (nothing_seen d s v _ nd extreme) as [-> ->].
  assert (once := there_and_back s d (minus v z) (minus a v) nd at_v).
  rewrite (sweep_of_equal _ (opposite (minus v z)) (opposite (minus a v)) (minus z v) (minus v a)) in once
    by apply opposite_of_minus.
  unfold is_reflex. cbn [incoming outgoing]. rewrite <- once; [lia | |].
  { apply (half_turn_of_equal s d (minus z v)); [symmetry; apply opposite_of_minus |]. apply extreme.
    right. apply in_app_iff. right. now left. }
  { apply extreme. now left. }
Qed.
