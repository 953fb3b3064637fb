(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The winding number of a simple chain at a point x, from its turning number and from the side on which x is of the
   first edge that a ray from x meets. What is seen from x around the chain is what is seen from the point
   where the ray meets the edge; and what is seen from there, in a direction and in the opposite one, adds up
   to the turning number. Secants are in secants.v and turning_tangents.v, rays in winding_number.v. *)
From Coq Require Import ZArith Lia Bool List.
From Oplus Require Import numbers winding rotation tangent_set turning_number secants turning_tangents segments_apart.
Import ListNotations.

Open Scope Q_scope.

Lemma around_is_seen_along (d : vector) (s : summand) (x a b : vector) (rest : list vector) :
  total (fun p => sweep (Direction d s) (fst p) (snd p))
    (map (seen_from x) (map (fun ends => Segment (fst ends) (snd ends)) (combine (a :: rest) (rest ++ [b])))) =
  seen_along d s x (a :: rest ++ [b]).
Proof.
  revert a. induction rest as [| c rest IH]; intros a; [reflexivity |].
  exact (f_equal (Z.add (sweep (Direction d s) (minus a x) (minus c x))) (IH c)).
Qed.

(* A winding number as what secants from the point pass. *)
Lemma winding_is_seen_along (d : vector) (s : summand) (x a z : vector) (middle : list vector) :
  nonzero d -> off x (edges (a :: middle ++ [z])) ->
  winding_number x (edges (a :: middle ++ [z])) =
  (seen_along d s x (a :: middle ++ [z]) + sweep (Direction d s) (minus z x) (minus a x))%Z.
Proof.
  intros nd x_off.
  rewrite <- (winding_number_by_any_ray x _ s d (closed_chain_cycles _) x_off nd).
  rewrite ray_as_sweeps by assumption.
  transitivity (seen_along d s x ((a :: middle) ++ [z; a])); [| apply seen_along_more].
  unfold edges. cbn [rotated]. rewrite around_is_seen_along, <- app_assoc. reflexivity.
Qed.

(* Straight through, nothing is passed. *)
Lemma no_turn_passes_nothing (d : direction) (u v : vector) : cross u v == 0 -> sweep d u v = 0%Z.
Proof. intros straight. unfold sweep. compared_numbers (cross u v ?= 0); [reflexivity | lra | lra]. Qed.

(* What is passed in one direction by the opposites. *)
Lemma sweep_of_opposites (d u v : vector) (s : summand) :
  nonzero u -> nonzero v -> nonzero d ->
  sweep (Direction d s) (opposite u) (opposite v) = sweep (Direction (opposite d) s) u v.
Proof.
  intros nu nv nd. rewrite !sweep_by_sides by (trivial; now apply opposite_nonzero).
  assert (same_left : forall a, left_of_ray s d (opposite a) = left_of_ray s (opposite d) a).
  { intros a. unfold left_of_ray, negative.
    rewrite (compare_as_difference (cross (opposite a) d) 0 (cross a (opposite d)) 0),
      (compare_as_difference (cross d (opposite a)) 0 (cross (opposite d) a) 0);
      [reflexivity | unfold cross, opposite; cbn [vx vy]; ring ..]. }
  rewrite !same_left. f_equal. apply compare_as_difference. unfold cross, opposite. cbn [vx vy]. ring.
Qed.

Lemma seen_towards_is_seen_along (d y : vector) (s : summand) (path : list vector) :
  nonzero d -> (forall a, In a path -> nonzero (minus a y)) ->
  seen_towards d s y path = seen_along (opposite d) s y path.
Proof.
  intros nd. unfold seen_towards, seen_along.
  induction path as [| a [| b path] IH]; intros away; [reflexivity .. |]. cbn [map in_succession] in *.
  rewrite IH, <- sweep_of_opposites by (trivial; intros; apply away; cbn in *; tauto). f_equal.
  apply sweep_of_equal; symmetry; apply opposite_of_minus.
Qed.

(* Turning from u by less than half a circle one does not pass its opposite. *)
Lemma opposite_not_passed (u v : vector) :
  nonzero u -> nonzero v -> ~ cross u v == 0 -> sweep (Direction (opposite u) OfP) u v = 0%Z.
Proof.
  intros nu nv turn. rewrite sweep_by_sides by (trivial; now apply opposite_nonzero).
  assert (cross (opposite u) u == 0 /\ cross (opposite u) v == - cross u v) as [along beside]
    by (unfold cross, opposite; cbn [vx vy]; split; ring).
  unfold ray_crossing, left_of_ray.
  destruct (negative_spec (cross (opposite u) u)), (negative_spec (cross (opposite u) v)); cbn [negb Bool.eqb]; trivial;
    compared_numbers (cross u v ?= 0); trivial; exfalso; lra.
Qed.

(* From one side of u over u to e on the other: u is passed once, counterclockwise if e is to the left. *)
Lemma passed_by_way_of_itself (u v e : vector) :
  nonzero u -> nonzero v -> nonzero e ->
  (0 < cross u v /\ cross u e < 0) \/ (cross u v < 0 /\ 0 < cross u e) ->
  (sweep (Direction u OfP) v u + sweep (Direction u OfP) u e)%Z =
  if negative (cross u e) then (-1)%Z else 1%Z.
Proof.
  intros nu nv ne sides. rewrite !sweep_by_sides by assumption. pose proof (cross_reversed u v).
  assert (itself : cross u u == 0) by (unfold cross; ring). unfold ray_crossing, left_of_ray.
  destruct (negative_spec (cross u v)), (negative_spec (cross u u)), (negative_spec (cross u e)); try (exfalso; lra);
    cbn [negb Bool.eqb]; compared_numbers (cross v u ?= 0); compared_numbers (cross u e ?= 0); trivial; exfalso; lra.
Qed.

(* The edges of a path that is not closed. *)
Definition open_edges (path : list vector) : list segment :=
  map (fun ends => Segment (fst ends) (snd ends)) (combine path (tl path)).

Lemma edges_with_one_more (a z w : vector) (middle : list vector) (e : segment) :
  In e (edges (a :: (middle ++ [z]) ++ [w])) ->
  In e (open_edges (a :: middle ++ [z])) \/ e = Segment z w \/ e = Segment w a.
Proof.
  unfold edges, open_edges. cbn [rotated tl]. rewrite <- !app_assoc. cbn [app].
  generalize a at 1 3. intros first. revert first.
  induction middle as [| b middle IH]; intros first I; cbn [app combine map fst snd] in *.
  - destruct I as [<- | [<- | [<- | []]]]; cbn; tauto.
  - destruct I as [<- | I]; [left; now left |]. destruct (IH b I) as [inside | last]; [left; now right | now right].
Qed.

Lemma closing_edge_listed (a z : vector) (middle : list vector) : In (Segment z a) (edges (a :: middle ++ [z])).
Proof.
  assert (each : forall first, In (Segment z a)
    (map (fun ends => Segment (fst ends) (snd ends)) (combine (first :: middle ++ [z]) ((middle ++ [z]) ++ [a])))).
  { induction middle as [| b rest IH]; intros first; [right; now left |]. right. apply IH. }
  exact (each a).
Qed.

Lemma seen_along_of_ends (d x a z w : vector) (s : summand) (middle : list vector) :
  seen_along d s x (a :: (middle ++ [z]) ++ [w]) =
  (seen_along d s x (a :: middle ++ [z]) + sweep (Direction d s) (minus z x) (minus w x))%Z.
Proof. rewrite <- app_assoc. apply (seen_along_more d s x z w (a :: middle)). Qed.

Section FirstEdge.
Variables x y a z : vector.
Variable middle : list vector.
Let u := minus y x.
Let e := minus a z.

(* The ray from x meets the edge from z to a in y, between its ends, and not along it. *)
Variable part : Q.
Hypothesis part_between : 0 < part /\ part < 1.
Hypothesis y_between :
  equal_vectors y (Vector (vx z + part * (vx a - vx z)) (vy z + part * (vy a - vy z))).
Hypothesis across : ~ cross u e == 0.
(* Before y it meets no other edge. *)
Hypothesis x_off : off x (edges (a :: middle ++ [z])).
Hypothesis apart_before : apart_from x y (a :: middle ++ [z]).
(* y as a vertex, the chain is without crossings. *)
Hypothesis y_off : off y (open_edges (a :: middle ++ [z])).
Hypothesis first_free : without_crossings (y :: a :: middle ++ [z]).
Hypothesis last_free : without_crossings (a :: middle ++ [z; y]).
Hypothesis everywhere : turns_everywhere (y :: a :: middle ++ [z]).
Hypothesis vertices_off : forall b, In b (a :: middle ++ [z]) -> nonzero (minus b y).

Lemma ahead_of_y : equal_vectors (minus a y) (Vector ((1 - part) * vx e) ((1 - part) * vy e)).
Proof.
  destruct y_between as [x_is y_is]. unfold equal_vectors, e, minus in *. cbn [vx vy] in *.
  rewrite x_is, y_is. split; ring.
Qed.

Lemma behind_y : equal_vectors (minus z y) (Vector (- part * vx e) (- part * vy e)).
Proof.
  destruct y_between as [x_is y_is]. unfold equal_vectors, e, minus in *. cbn [vx vy] in *.
  rewrite x_is, y_is. split; ring.
Qed.

Lemma nonzero_ray : nonzero u.
Proof. intros [x_is y_is]. apply across. unfold cross. rewrite x_is, y_is. ring. Qed.

Lemma turns_of_cross (v w : vector) : ~ cross v w == 0 -> turns v w.
Proof.
  intros turn. split; [| split; [| contradiction]]; intros [x_is y_is]; apply turn; unfold cross;
    rewrite x_is, y_is; ring.
Qed.

Lemma crosses_at_y : cross u (minus a y) == (1 - part) * cross u e /\ cross u (minus z y) == - part * cross u e.
Proof.
  destruct ahead_of_y as [xa ya], behind_y as [xz yz]. cbn [vx vy] in *.
  unfold cross at 1 3. rewrite xa, ya, xz, yz. unfold cross. split; ring.
Qed.

Lemma beside_the_ray : ~ cross u (minus a y) == 0 /\ ~ cross u (minus z y) == 0.
Proof.
  destruct crosses_at_y as [-> ->]. split; intros none; destruct (Qmult_integral _ _ none); (contradiction || lra).
Qed.

(* From x around the chain as much is seen of any direction as from y, but for the two turns from the ray to
   the edge. *)
Lemma seen_from_x_and_y (d : vector) (s : summand) :
  nonzero d ->
  winding_number x (edges (a :: middle ++ [z])) =
  (seen_along d s y (a :: middle ++ [z]) +
   sweep (Direction d s) u (minus a y) - sweep (Direction d s) u (minus z y))%Z.
Proof.
  intros nd. rewrite (winding_is_seen_along d s) by assumption.
  pose proof (strip d s x y z (a :: middle) nd apart_before) as cells. cbv zeta in cells.
  cbn [hd app] in cells.
  destruct beside_the_ray as [turn_a turn_z]. destruct part_between as [after_z before_a].
  assert (sums : forall b, vx (minus b x) == vx u + vx (minus b y) /\ vy (minus b x) == vy u + vy (minus b y))
    by (intros b; unfold u, minus; cbn [vx vy]; split; ring).
  destruct (sums a) as [xa ya], (sums z) as [xz yz].
  pose proof (by_way_of_the_sum d u (minus a y) (minus a x) s nd (turns_of_cross _ _ turn_a) xa ya) as at_a.
  pose proof (by_way_of_the_sum d u (minus z y) (minus z x) s nd (turns_of_cross _ _ turn_z) xz yz) as at_z.
  assert (edge_off : turns (minus z x) (minus a x))
    by exact (turns_around x (Segment z a) (x_off _ (closing_edge_listed _ _ _))).
  destruct (turning_is_in_front _ _ edge_off) as (w & front_z & front_a).
  assert (front_y : in_front w u).
  { destruct y_between as [x_is y_is]. unfold in_front, dot, u, minus in *. cbn [vx vy] in *. rewrite x_is, y_is.
    pose proof (mixed_is_more part _ _ 0 ltac:(lra) front_z front_a). lra. }
  pose proof (nothing_turns_around_zero w d s [minus z x; u; minus a x] nd) as around_is.
  assert (front : forall v, In v [minus z x; u; minus a x] -> in_front w v)
    by (intros v [<- | [<- | [<- | []]]]; assumption).
  specialize (around_is front). unfold total, around in around_is. cbn in around_is.
  rewrite (sweep_reversed _ u (minus z x)), (sweep_reversed _ (minus z x) (minus a x)) in around_is.
  lia.
Qed.

(* What is seen from y in the ray's direction and in the opposite one differs by one. *)
Lemma seen_in_opposite_directions :
  (seen_along (opposite u) OfP y (a :: middle ++ [z]) =
   seen_along u OfP y (a :: middle ++ [z]) + if negative (cross u e) then -1 else 1)%Z.
Proof.
  pose proof nonzero_ray as nu. pose proof (opposite_nonzero u nu) as no.
  destruct crosses_at_y as [cross_a cross_z]. destruct part_between as [after_z before_a].
  set (w := Vector (vx y + vx u) (vy y + vy u)).
  assert (w_is : equal_vectors (minus w y) u)
    by (unfold equal_vectors, w, minus; cbn [vx vy]; split; ring).
  destruct beside_the_ray as [a_off z_off].
  assert (closing_off : off y (edges (a :: (middle ++ [z]) ++ [w]))).
  { intros edge_ I. apply edges_with_one_more in I.
    assert (aside : forall b, ~ cross u (minus b y) == 0 ->
      ~ lies_on y (Segment b w) /\ ~ lies_on y (Segment w b)).
    { intros b b_off. split; intros on; apply lies_on_by_signs in on; destruct on as [line _]; apply b_off;
        revert line; unfold w, cross, minus; cbn [source target vx vy]; lra. }
    destruct I as [I | [-> | ->]]; [now apply y_off | now apply aside | now apply aside]. }
  pose proof (winding_is_seen_along u OfP y a w (middle ++ [z]) nu closing_off) as by_u.
  pose proof (winding_is_seen_along (opposite u) OfP y a w (middle ++ [z]) no closing_off) as by_opposite.
  rewrite seen_along_of_ends in by_u, by_opposite.
  assert (nz : nonzero (minus z y)) by (apply vertices_off; right; apply in_app_iff; right; now left).
  assert (na : nonzero (minus a y)) by (apply vertices_off; now left).
  assert (same : forall v, equal_vectors v v) by (intros v; split; reflexivity).
  rewrite (sweep_of_equal _ (minus z y) (minus w y) (minus z y) u),
    (sweep_of_equal _ (minus w y) (minus a y) u (minus a y)) in by_u by trivial.
  rewrite (sweep_of_equal _ (minus z y) (minus w y) (minus z y) u),
    (sweep_of_equal _ (minus w y) (minus a y) u (minus a y)) in by_opposite by trivial.
  rewrite (opposite_not_passed u (minus a y)) in by_opposite by trivial.
  rewrite (sweep_reversed _ u (minus z y)), (opposite_not_passed u (minus z y)) in by_opposite by trivial.
  assert (sides : (0 < cross u (minus z y) /\ cross u (minus a y) < 0) \/
                  (cross u (minus z y) < 0 /\ 0 < cross u (minus a y))).
  { destruct (Q_dec (cross u e) 0) as [[right_of | left_of] | ?]; [left | right | contradiction];
      rewrite cross_z, cross_a; split; nra. }
  pose proof (passed_by_way_of_itself u (minus z y) (minus a y) nu nz na sides) as once.
  assert (same_side : negative (cross u (minus a y)) = negative (cross u e)).
  { destruct (negative_spec (cross u e)), (negative_spec (cross u (minus a y))); trivial; exfalso; nra. }
  rewrite same_side in once. destruct (negative (cross u e)); lia.
Qed.

(* Theorem. Twice the winding number of x is the turning number and one more if the ray's first edge goes to the left,
   one less if to the right. *)
Theorem winding_number_by_first_edge :
  (2 * winding_number x (edges (a :: middle ++ [z])))%Z =
  (turning_number (y :: a :: middle ++ [z]) + if negative (cross u e) then -1 else 1)%Z.
Proof.
  pose proof nonzero_ray as nu. pose proof (opposite_nonzero u nu) as no.
  destruct crosses_at_y as [cross_a cross_z]. destruct part_between as [after_z before_a].
  assert (nz : nonzero (minus z y)) by (apply vertices_off; right; apply in_app_iff; right; now left).
  assert (na : nonzero (minus a y)) by (apply vertices_off; now left).
  destruct beside_the_ray as [a_off z_off].
  pose proof (seen_from_x_and_y (opposite u) OfP no) as from_x.
  rewrite !opposite_not_passed in from_x by trivial.
  pose proof (everywhere _ (first_corner y a z middle)) as at_y. cbn [incoming outgoing] in at_y.
  pose proof (chain_turns_as_the_secants_of_a_vertex u OfP y a z middle nu at_y first_free last_free) as whole.
  rewrite (turns_past_every_direction _ (Direction u OfP) everywhere nu) in whole.
  rewrite seen_towards_is_seen_along in whole by assumption.
  assert (straight : cross (minus z y) (minus a y) == 0).
  { destruct ahead_of_y as [xa ya], behind_y as [xz yz]. unfold cross. rewrite xa, ya, xz, yz. cbn [vx vy]. ring. }
  rewrite (no_turn_passes_nothing _ (minus y z)), (no_turn_passes_nothing _ (minus z y)) in whole
    by (unfold cross, minus in *; cbn [vx vy] in *; lra).
  pose proof seen_in_opposite_directions. lia.
Qed.

End FirstEdge.
