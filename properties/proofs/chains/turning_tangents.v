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

Lemma opposite_cross (d u : vector) :
  cross d (opposite u) == - cross d u /\ dot d (opposite u) == - dot d u.
Proof. unfold cross, dot, opposite. cbn [vx vy]. split; ring. Qed.

Lemma one_half_turn_only (s : summand) (d u : vector) :
  in_half_turn s d u -> in_half_turn s d (opposite u) -> False.
Proof.
  unfold in_half_turn. destruct (opposite_cross d u) as [c o]. destruct s; lra.
Qed.

(* A turn to the left crosses the ray iff it leads from the half turn before it to the one after it. *)
Lemma crossed_between_half_turns (s : summand) (d u v : vector) :
  nonzero d -> 0 < cross u v ->
  reflect (in_half_turn s d (opposite u) /\ in_half_turn s d v)
    (negb (left_of_ray s d u) && left_of_ray s d v).
Proof.
  intros nd positive. pose proof (square_positive d nd) as square.
  assert (turn : dot d d * cross u v == dot d u * cross d v - cross d u * dot d v)
    by (unfold cross, dot; ring).
  assert (above : 0 < dot d u * cross d v - cross d u * dot d v) by nra.
  pose proof (cross_reversed d u) as ru. pose proof (cross_reversed d v) as rv.
  destruct (opposite_cross d u) as [cu du].
  unfold in_half_turn, left_of_ray. destruct s.
  - destruct (negative_spec (cross d u)) as [a | a], (negative_spec (cross d v)) as [b | b]; cbn;
      constructor; [lra | | lra |].
    + split; [left; lra |].
      destruct (Q_dec (cross d v) 0) as [[? | ?] | on]; [lra | left; lra | right; rewrite on in above].
      split; [assumption | nra].
    + intros [[? | [on ?]] _]; [lra |]. assert (on_ray : cross d u == 0) by lra.
      rewrite on_ray in above. nra.
  - destruct (negative_spec (cross u d)) as [a | a], (negative_spec (cross v d)) as [b | b]; cbn;
      constructor; [lra | lra | |].
    + split; [| left; lra].
      destruct (Q_dec (cross d u) 0) as [[? | ?] | on]; [left; lra | lra | right; rewrite on in above].
      split; [lra | nra].
    + intros [_ [? | [on ?]]]; [lra |]. rewrite on in above. nra.
Qed.

Lemma turn_within_a_half_turn (s : summand) (d u v : vector) :
  nonzero d -> nonzero u -> nonzero v ->
  (in_half_turn s d u /\ in_half_turn s d v) \/
  (in_half_turn s d (opposite u) /\ in_half_turn s d (opposite v)) ->
  sweep (Direction d s) u v = 0%Z.
Proof.
  intros nd nu nv within. unfold sweep. cbn [of].
  pose proof (one_half_turn_only s d u) as only_u. pose proof (one_half_turn_only s d v) as only_v.
  compared_numbers (cross u v ?= 0); [reflexivity | |].
  - assert (positive : 0 < cross v u) by (pose proof (cross_reversed u v); lra).
    rewrite crossed_to_the_left by assumption.
    destruct (crossed_between_half_turns s d v u nd positive); [exfalso; tauto | reflexivity].
  - rewrite crossed_to_the_left by assumption.
    destruct (crossed_between_half_turns s d u v nd C); [exfalso; tauto | reflexivity].
Qed.

Lemma opposite_twice_in_half_turn (s : summand) (d u : vector) :
  in_half_turn s d u -> in_half_turn s d (opposite (opposite u)).
Proof.
  unfold in_half_turn. destruct (opposite_cross d u) as [c o], (opposite_cross d (opposite u)) as [c' o'].
  destruct s; lra.
Qed.

(* From one half turn to the other and back, once along the edges of a vertex, once along their opposites. *)
Lemma there_and_back (s : summand) (d u v : vector) :
  nonzero d -> turns u v -> in_half_turn s d (opposite u) -> in_half_turn s d v ->
  ~ cross u v == 0 /\
  (sweep (Direction d s) u v + sweep (Direction d s) (opposite u) (opposite v))%Z =
  if negative (cross u v) then (-1)%Z else 1%Z.
Proof.
  intros nd (nu & nv & ahead) before_it after_it.
  pose proof (opposite_nonzero u nu) as nou. pose proof (opposite_nonzero v nv) as nov.
  assert (same_turn : cross (opposite u) (opposite v) == cross u v)
    by (unfold cross, opposite; cbn [vx vy]; ring).
  assert (back_turn : cross (opposite v) (opposite u) == cross v u)
    by (unfold cross, opposite; cbn [vx vy]; ring).
  pose proof (cross_reversed u v) as reversed. pose proof (square_positive d nd) as square.
  assert (turn : dot d d * cross u v == dot d u * cross d v - cross d u * dot d v)
    by (unfold cross, dot; ring).
  assert (scalar : dot d d * dot u v == dot d u * dot d v + cross d u * cross d v)
    by (unfold cross, dot; ring).
  assert (turning : ~ cross u v == 0).
  { intros none. specialize (ahead none). rewrite none in turn.
    assert (along : 0 < dot d u * dot d v + cross d u * cross d v) by nra.
    assert (equal : dot d u * cross d v == cross d u * dot d v) by lra.
    destruct (opposite_cross d u) as [c o]. unfold in_half_turn in *.
    clear - before_it after_it equal along c o.
    set (cu := cross d u) in *. set (du := dot d u) in *.
    set (cv := cross d v) in *. set (dv := dot d v) in *.
    set (cou := cross d (opposite u)) in *. set (dou := dot d (opposite u)) in *.
    clearbody cu du cv dv cou dou.
    assert (scaled : du * dv * cv == cu * (dv * dv))
      by (setoid_replace (du * dv * cv) with (du * cv * dv) by ring; rewrite equal; ring).
    assert (0 <= dv * dv) by nra.
    destruct before_it as [? | [? side_u]], after_it as [? | [? side_v]]; destruct s; nra. }
  split; [exact turning |].
  pose proof (one_half_turn_only s d v after_it) as not_before.
  pose proof (opposite_twice_in_half_turn s d v after_it) as back.
  unfold sweep. cbn [of].
  destruct (negative_spec (cross u v)) as [right_turn | left_turn].
  - compared_numbers (cross u v ?= 0); [lra | | lra].
    compared_numbers (cross (opposite u) (opposite v) ?= 0); [lra | | lra].
    rewrite !crossed_to_the_left by (trivial; lra).
    destruct (crossed_between_half_turns s d v u nd) as [[yes _] | _]; [lra | tauto |].
    destruct (crossed_between_half_turns s d (opposite v) (opposite u) nd) as [_ | no]; [lra | reflexivity |].
    tauto.
  - compared_numbers (cross u v ?= 0); [lra | lra |].
    compared_numbers (cross (opposite u) (opposite v) ?= 0); [lra | lra |].
    rewrite !crossed_to_the_left by (trivial; lra).
    destruct (crossed_between_half_turns s d u v nd) as [_ | no]; [lra | | tauto].
    destruct (crossed_between_half_turns s d (opposite u) (opposite v) nd) as [[_ yes] | _];
      [lra | tauto | reflexivity].
Qed.

(* The same vector, however its coordinates are written. *)
Lemma sweep_of_equal (d : direction) (u v u' v' : vector) :
  equal_vectors u u' -> equal_vectors v v' -> sweep d u v = sweep d u' v'.
Proof.
  intros eu ev.
  assert (angles : forall a b c, equal_vectors b c -> compare_angle a b = compare_angle a c).
  { intros a b c [x_is y_is]. unfold compare_angle.
    replace (half b) with (half c) by (unfold half, negative, zero; rewrite x_is, y_is; reflexivity).
    destruct (half a), (half c); try reflexivity; rewrite x_is, y_is; reflexivity. }
  assert (comparisons : forall a b c e s t, equal_vectors a b -> equal_vectors c e ->
    compare (Direction a s) (Direction c t) = compare (Direction b s) (Direction e t)).
  { intros a b c e s t first second. unfold compare. cbn [vec of].
    now rewrite (angles a c e second), (compare_angle_of_equal a b e first). }
  assert (own : equal_vectors (vec d) (vec d)) by (split; reflexivity).
  destruct d as [d s]. cbn [vec] in own. unfold sweep, ccw, before. cbn [of].
  rewrite (comparisons _ _ _ _ (other s) s eu own), (comparisons _ _ _ _ s (other s) own eu),
    (comparisons _ _ _ _ (other s) s ev own), (comparisons _ _ _ _ s (other s) own ev),
    (comparisons _ _ _ _ (other s) (other s) eu ev), (comparisons _ _ _ _ (other s) (other s) ev eu).
  assert (cross u v == cross u' v') as crosses
    by (destruct eu as [xu yu], ev as [xv yv]; unfold cross; rewrite xu, yu, xv, yv; reflexivity).
  now rewrite (compare_as_difference (cross u v) 0 (cross u' v') 0) by (rewrite crosses; reflexivity).
Qed.

Lemma half_turn_of_equal (s : summand) (d u v : vector) :
  equal_vectors u v -> in_half_turn s d u -> in_half_turn s d v.
Proof.
  intros [x_is y_is]. unfold in_half_turn, cross, dot. destruct s; rewrite x_is, y_is; trivial.
Qed.

Lemma opposite_of_minus (a b : vector) : equal_vectors (opposite (minus a b)) (minus b a).
Proof. unfold equal_vectors, opposite, minus. cbn [vx vy]. split; ring. Qed.

(* A chain as the path of its edges, from the last to the first and on to the last. *)
Fixpoint in_succession (f : vector -> vector -> Z) (us : list vector) : Z :=
  match us with u :: ((v :: _) as rest) => f u v + in_succession f rest | _ => 0 end.

Fixpoint steps (path : list vector) : list vector :=
  match path with a :: ((b :: _) as rest) => minus b a :: steps rest | _ => [] end.

Lemma turns_along_steps (d : vector) (s : summand) (path : list vector) :
  turns_along d s path = in_succession (sweep (Direction d s)) (steps path).
Proof.
  induction path as [| p [| q [| r rest]] IH]; try reflexivity.
  change (turns_along d s (p :: q :: r :: rest)) with
    (sweep (Direction d s) (minus q p) (minus r q) + turns_along d s (q :: r :: rest))%Z.
  rewrite IH. reflexivity.
Qed.

Lemma steps_of_edges (a : vector) (rest : list vector) :
  edge_directions (a :: rest) = steps (a :: rest ++ [a]).
Proof.
  unfold edge_directions, edges. rewrite map_map. cbn [source target rotated].
  assert (path : forall z, map (fun ends => minus (snd ends) (fst ends)) (combine (a :: rest) (rest ++ [z])) =
                           steps (a :: rest ++ [z])); [| exact (path a)].
  revert a. induction rest as [| b rest IH]; intros a z; [reflexivity |].
  exact (f_equal (cons (minus b a)) (IH b z)).
Qed.

Lemma steps_more (path : list vector) (a z : vector) :
  steps (path ++ [a; z]) = steps (path ++ [a]) ++ [minus z a].
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
  rewrite turns_past_total, turns_along_steps. unfold turns_of.
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
  induction path as [| a path IH]; [cbn; lia |]. destruct path as [| b path]; [cbn; lia |].
  cbn [app seen_along] in *. rewrite IH. lia.
Qed.

Section ExtremeVertex.
Variables (d : vector) (s : summand) (v : vector).
Hypothesis nonzero_d : nonzero d.

Definition beyond (a : vector) : Prop := in_half_turn s d (minus a v).

Lemma nothing_seen_from_it (path : list vector) :
  (forall a, In a path -> beyond a) -> seen_along d s v path = 0%Z.
Proof.
  induction path as [| a path IH]; intros all; [reflexivity |].
  destruct path as [| b path]; [reflexivity |].
  change (seen_along d s v (a :: b :: path)) with
    (sweep (Direction d s) (minus a v) (minus b v) + seen_along d s v (b :: path))%Z.
  rewrite IH by (intros c I; apply all; now right).
  pose proof (all a (or_introl eq_refl)) as side_a. pose proof (all b (or_intror (or_introl eq_refl))) as side_b.
  rewrite turn_within_a_half_turn; trivial; [apply (half_turn_nonzero s d) .. | now left]; assumption.
Qed.

Lemma nothing_seen_towards_it (path : list vector) :
  (forall a, In a path -> beyond a) -> seen_towards d s v path = 0%Z.
Proof.
  induction path as [| a path IH]; intros all; [reflexivity |].
  destruct path as [| b path]; [reflexivity |].
  change (seen_towards d s v (a :: b :: path)) with
    (sweep (Direction d s) (minus v a) (minus v b) + seen_towards d s v (b :: path))%Z.
  rewrite IH by (intros c I; apply all; now right).
  assert (there : forall c, beyond c ->
    nonzero (minus v c) /\ in_half_turn s d (opposite (minus v c))).
  { intros c side_c. pose proof (half_turn_nonzero _ _ _ side_c) as n. split.
    - unfold nonzero, minus in *. cbn [vx vy] in *. intros o. apply n. lra.
    - apply (half_turn_of_equal s d (minus c v)); [symmetry; apply opposite_of_minus | exact side_c]. }
  destruct (there a (all a (or_introl eq_refl))) as [na side_a].
  destruct (there b (all b (or_intror (or_introl eq_refl)))) as [nb side_b].
  rewrite turn_within_a_half_turn; trivial. now right.
Qed.
End ExtremeVertex.

Lemma turns_opposite (u v : vector) : turns u v -> turns (opposite u) (opposite v).
Proof.
  intros (nu & nv & ahead). split; [| split]; [now apply opposite_nonzero .. |].
  assert (cross (opposite u) (opposite v) == cross u v /\ dot (opposite u) (opposite v) == dot u v)
    as [-> ->] by (unfold cross, dot, opposite; cbn [vx vy]; split; ring).
  exact ahead.
Qed.

Lemma turns_of_equal (u v u' v' : vector) :
  equal_vectors u u' -> equal_vectors v v' -> turns u v -> turns u' v'.
Proof.
  intros [xu yu] [xv yv]. unfold turns, nonzero, cross, dot. now rewrite xu, yu, xv, yv.
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
  { rewrite closing, e. cbn [app]. cbn [turns_along]. unfold turn. lia. }
  rewrite path. clear path.
  pose proof (path_turns_as_its_secants d s v (middle ++ [z]) nd a) as secants.
  rewrite <- closing in secants. specialize (secants last_free). rewrite secants. clear secants.
  rewrite seen_along_more.
  cbn [without_crossings] in first_free. destruct first_free as (at_a & far & _). rewrite <- e in far |- *.
  pose proof (strip d s v a z middle nd far) as cells. cbv zeta in cells. rewrite second in cells.
  assert (first_leg : seen_along d s v (a :: middle ++ [z]) =
    (turn (minus a v) (minus b v) + seen_along d s v (middle ++ [z]))%Z) by (rewrite e; reflexivity).
  rewrite first_leg.
  pose proof (by_way_of_the_sum d (minus a v) (minus b a) (minus b v) s nd at_a) as corner_a.
  pose proof (by_way_of_the_sum d (minus z v) (minus v a) (minus z a) s nd) as corner_v.
  assert (back : turns (minus z v) (minus v a)).
  { apply (turns_of_equal (opposite (minus v z)) (opposite (minus a v))); [apply opposite_of_minus .. |].
    now apply turns_opposite. }
  specialize (corner_v back).
  assert (sum_a : vx (minus b v) == vx (minus a v) + vx (minus b a) /\
                  vy (minus b v) == vy (minus a v) + vy (minus b a))
    by (unfold minus; cbn [vx vy]; split; ring).
  assert (sum_v : vx (minus z a) == vx (minus z v) + vx (minus v a) /\
                  vy (minus z a) == vy (minus z v) + vy (minus v a))
    by (unfold minus; cbn [vx vy]; split; ring).
  destruct sum_a as [xa ya], sum_v as [xv yv].
  specialize (corner_a xa ya). specialize (corner_v xv yv). unfold turn in *. lia.
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
  rewrite (nothing_seen_from_it d s v nd _ extreme), (nothing_seen_towards_it d s v nd _ extreme).
  destruct (there_and_back s d (minus v z) (minus a v) nd at_v) as [_ once].
  { apply (half_turn_of_equal s d (minus z v)); [symmetry; apply opposite_of_minus |]. apply extreme.
    right. apply in_app_iff. right. now left. }
  { apply extreme. now left. }
  rewrite (sweep_of_equal _ (opposite (minus v z)) (opposite (minus a v)) (minus z v) (minus v a)) in once
    by apply opposite_of_minus.
  unfold is_reflex. cbn [incoming outgoing]. rewrite <- once. lia.
Qed.
