(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* How a path without crossings turns, by its secants, the vectors from one of its vertices to a later one.
   It is Hopf's proof of his theorem of turning tangents (thesis, Definition 2.1.9), with finite sums: the
   secants form a grid; around each of its cells, two edges that have no point in common or two consecutive
   ones, nothing turns around zero, and what is left of the sum over all cells is its boundary. `sweep` and
   that it does not depend on the direction are in angular_crossings.v. *)
From Coq Require Import ZArith Lia Bool List SetoidList.
From Oplus Require Import numbers winding.
Import ListNotations.

Open Scope Q_scope.

(* u is on the open side of the line through zero to which w points. *)
Definition in_front (w u : vector) : Prop := 0 < dot w u.

Lemma in_front_nonzero (w u : vector) : in_front w u -> nonzero u.
Proof. unfold in_front, dot, nonzero. intros f [x_is y_is]. rewrite x_is, y_is in f. lra. Qed.

Lemma in_front_turns (w u v : vector) : in_front w u -> in_front w v -> turns u v.
Proof.
  intros f g. split; [| split]; [now apply in_front_nonzero with w .. |].
  unfold in_front in *. intros no_turn.
  assert (parallel : cross w u * dot w v == dot w u * cross w v).
  { setoid_replace (cross w u * dot w v) with
      (dot w u * cross w v - dot w w * cross u v) by (unfold cross, dot; ring).
    rewrite no_turn. ring. }
  assert (same_side : 0 <= cross w u * cross w v).
  { apply (Qmult_lt_0_le_reg_r _ _ (dot w u)); [assumption |].
    setoid_replace (cross w u * cross w v * dot w u) with (cross w u * (dot w u * cross w v)) by ring.
    rewrite <- parallel. nra. }
  assert (sizes : dot w w * dot u v == dot w u * dot w v + cross w u * cross w v)
    by (unfold cross, dot; ring).
  assert (0 <= dot w w) by (unfold dot; nra). nra.
Qed.

Lemma nothing_passes_behind (w u v : vector) (s : summand) :
  in_front w u -> in_front w v -> sweep (Direction (opposite w) s) u v = 0%Z.
Proof.
  intros f g. pose proof (in_front_nonzero w u f) as nu. pose proof (in_front_nonzero w v g) as nv.
  assert (nw : nonzero w) by (intros [x_is y_is]; unfold in_front, dot in f; rewrite x_is, y_is in f; lra).
  pose proof (square_positive w nw). rewrite sweep_by_sides by (trivial; now apply opposite_nonzero).
  assert (turn : dot w w * cross u v == dot w u * cross w v - cross w u * dot w v) by (unfold cross, dot; ring).
  assert (sides : forall a, cross a (opposite w) == cross w a /\ cross (opposite w) a == - cross w a)
    by (intros a; unfold cross, opposite; cbn [vx vy]; split; ring).
  destruct (sides u), (sides v). unfold ray_crossing, left_of_ray, in_front in *. destruct s;
    [destruct (negative_spec (cross (opposite w) u)), (negative_spec (cross (opposite w) v))
    | destruct (negative_spec (cross u (opposite w))), (negative_spec (cross v (opposite w)))];
    cbn [negb Bool.eqb]; trivial; compared_numbers (cross u v ?= 0); trivial; exfalso; nra.
Qed.

(* The sum around vectors all of which are on one side of a line through zero. *)
Definition around (us : list vector) : list (vector * vector) := combine us (rotated us).

Lemma nothing_turns_around_zero (w d : vector) (s : summand) (us : list vector) :
  nonzero d -> (forall u, In u us -> in_front w u) ->
  total (fun p => sweep (Direction d s) (fst p) (snd p)) (around us) = 0%Z.
Proof.
  intros nd front.
  assert (pairs : around us = map (fun e => (source e, target e)) (edges us)).
  { unfold edges, around. rewrite map_map. cbn [source target].
    rewrite <- (map_id (combine us (rotated us))) at 1. apply map_ext. now intros [a b]. }
  assert (both : forall u v, In (u, v) (around us) -> in_front w u /\ in_front w v).
  { intros u v I. unfold around in I. pose proof (in_combine_l _ _ _ _ I) as L.
    pose proof (in_combine_r _ _ _ _ I) as R. split; [now apply front |]. apply front.
    destruct us as [| first rest]; [destruct R |]. cbn in R. apply in_app_iff in R.
    destruct R as [R | [<- | []]]; [now right | now left]. }
  destruct us as [| first rest]; [reflexivity |].
  rewrite (sweeps_are_equal _ (Direction d s) (Direction (opposite w) s)).
  - apply sum_of_zeros. intros [u v] I. destruct (both u v I). now apply nothing_passes_behind.
  - unfold closed. rewrite pairs, !map_map. cbn [fst snd]. apply (closed_chain_cycles (first :: rest)).
  - intros u v I. destruct (both u v I). now apply in_front_turns with w.
  - exact nd.
  - pose proof (front first (or_introl eq_refl)) as f. unfold proper, nonzero, opposite, in_front, dot in *.
    cbn [vec vx vy]. intros [x_is y_is]. nra.
Qed.

Lemma cross_reversed (u v : vector) : cross v u == - cross u v.
Proof. unfold cross. ring. Qed.

Lemma sweep_reversed (d : direction) (u v : vector) : sweep d v u = (- sweep d u v)%Z.
Proof.
  unfold sweep. pose proof (cross_reversed u v) as e.
  compared_numbers (cross u v ?= 0); compared_numbers (cross v u ?= 0); try reflexivity;
    try (exfalso; lra). now rewrite Z.opp_involutive.
Qed.

(* Directions one of which turns to the other by less than half a circle have a side of a line. *)
Lemma turning_is_in_front (u v : vector) : turns u v -> exists w, in_front w u /\ in_front w v.
Proof.
  intros (nu & nv & ahead). destruct (Q_dec (cross u v) 0) as [turn | straight].
  - assert (positive : 0 < cross u v * cross u v) by (destruct turn; nra).
    exists (Vector (cross u v * (vy v - vy u)) (cross u v * (vx u - vx v))).
    unfold in_front, dot, cross in *. cbn [vx vy]. split; nra.
  - exists u. split; [exact (square_positive u nu) | now apply ahead].
Qed.

(* Two turns make one: the cell of two consecutive edges. *)
Lemma by_way_of_the_sum (d u v whole : vector) (s : summand) :
  nonzero d -> turns u v -> vx whole == vx u + vx v -> vy whole == vy u + vy v ->
  (sweep (Direction d s) u whole + sweep (Direction d s) whole v)%Z = sweep (Direction d s) u v.
Proof.
  intros nd t x_is y_is. destruct (turning_is_in_front u v t) as (w & f & g).
  pose proof (nothing_turns_around_zero w d s [u; whole; v] nd) as around_is.
  unfold total, around in around_is. cbn in around_is.
  rewrite (sweep_reversed _ u v) in around_is.
  assert (front : forall a, In a [u; whole; v] -> in_front w a).
  { intros a [<- | [<- | [<- | []]]]; try assumption. unfold in_front, dot in *. rewrite x_is, y_is. lra. }
  specialize (around_is front). lia.
Qed.

(* All of the segment from c to e is on the side of a line to which w points, seen from that from a to
   b: the two have no point in common. *)
Definition apart (a b c e : vector) : Prop :=
  exists w, in_front w (minus c a) /\ in_front w (minus c b) /\
            in_front w (minus e a) /\ in_front w (minus e b).

(* The cell of two edges that are apart. *)
Lemma cell_of_two_edges (d a b c e : vector) (s : summand) :
  nonzero d -> apart a b c e ->
  (sweep (Direction d s) (minus c a) (minus e a) + sweep (Direction d s) (minus e a) (minus e b))%Z =
  (sweep (Direction d s) (minus c a) (minus c b) + sweep (Direction d s) (minus c b) (minus e b))%Z.
Proof.
  intros nd (w & ca & cb & ea & eb).
  pose proof (nothing_turns_around_zero w d s [minus c a; minus e a; minus e b; minus c b] nd) as around_is.
  unfold total, around in around_is. cbn in around_is.
  rewrite (sweep_reversed _ (minus c b) (minus e b)), (sweep_reversed _ (minus c a) (minus c b)) in around_is.
  assert (front : forall u, In u [minus c a; minus e a; minus e b; minus c b] -> in_front w u)
    by (intros u [<- | [<- | [<- | [<- | []]]]]; assumption).
  specialize (around_is front). lia.
Qed.

(* What is passed from each of the vectors to the next. *)
Fixpoint in_succession (f : vector -> vector -> Z) (us : list vector) : Z :=
  match us with u :: ((v :: _) as rest) => f u v + in_succession f rest | _ => 0 end.

Fixpoint steps (path : list vector) : list vector :=
  match path with a :: ((b :: _) as rest) => minus b a :: steps rest | _ => [] end.

Section Path.
Variable d : vector.
Variable s : summand.
Let turn : vector -> vector -> Z := sweep (Direction d s).

(* What the secants from p pass, as their other end goes along a path; what those to z pass; and what the edges of a
   path pass, from the first to the last. *)
Definition seen_along (p : vector) (path : list vector) : Z := in_succession turn (map (fun a => minus a p) path).
Definition seen_towards (z : vector) (path : list vector) : Z := in_succession turn (map (fun a => minus z a) path).
Definition turns_along (path : list vector) : Z := in_succession turn (steps path).

Fixpoint apart_from (p q : vector) (path : list vector) : Prop :=
  match path with
  | a :: ((b :: _) as rest) => apart p q a b /\ apart_from p q rest
  | _ => True
  end.

(* Consecutive edges turn by less than half a circle, all others are apart. *)
Fixpoint without_crossings (path : list vector) : Prop :=
  match path with
  | p :: ((q :: ((r :: _) as others)) as rest) =>
      turns (minus q p) (minus r q) /\ apart_from p q others /\ without_crossings rest
  | _ => True
  end.

(* The cells of one edge, from p to q, and those of a path: a strip of the grid. *)
Lemma strip (p q z : vector) (path : list vector) :
  nonzero d -> apart_from p q (path ++ [z]) ->
  let first := hd z path in
  (seen_along p (path ++ [z]) + turn (minus z p) (minus z q) =
   turn (minus first p) (minus first q) + seen_along q (path ++ [z]))%Z.
Proof.
  intros nd. induction path as [| a path IH]; intros far; [cbn; lia |].
  destruct (path ++ [z]) as [| b rest] eqn:e; [destruct path; discriminate e |].
  assert (second : hd z path = b) by (destruct path; cbn in e |- *; congruence).
  rewrite <- app_comm_cons, e in *. cbn [hd] in *. destruct far as [here far].
  specialize (IH far). cbv zeta in IH. rewrite second in IH.
  pose proof (cell_of_two_edges d p q a b s nd here) as cell. fold turn in cell.
  unfold seen_along, turn in *. cbn [map in_succession] in *. lia.
Qed.

(* Theorem. A path without crossings turns as its secants do, first those from its first vertex, then those
   to its last. *)
Theorem path_turns_as_its_secants (z : vector) (path : list vector) :
  nonzero d -> forall p, without_crossings (p :: path ++ [z]) ->
  turns_along (p :: path ++ [z]) =
  (seen_along p (path ++ [z]) + seen_towards z (p :: path))%Z.
Proof.
  intros nd. induction path as [| q path IH]; intros p free; [reflexivity |].
  destruct (path ++ [z]) as [| r rest] eqn:e; [destruct path; discriminate e |].
  assert (second : hd z path = r) by (destruct path; cbn in e |- *; congruence).
  rewrite <- app_comm_cons, e in *.
  destruct free as (t & far & free). specialize (IH q free). rewrite <- e in far.
  pose proof (strip p q z path nd far) as cells. cbv zeta in cells. rewrite second, e in cells.
  assert (corner : (turn (minus q p) (minus r p) + turn (minus r p) (minus r q))%Z =
                   turn (minus q p) (minus r q))
    by (apply by_way_of_the_sum; trivial; unfold minus; cbn [vx vy]; ring).
  unfold turns_along, seen_along, seen_towards in *. cbn [steps map in_succession] in *. lia.
Qed.

End Path.
