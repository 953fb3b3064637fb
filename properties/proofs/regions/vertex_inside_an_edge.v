(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* With one more vertex, inside an edge, a simple chain is simple and has the same turning number. Simple chains
   are in simple_chain.v. *)
From Coq Require Import PeanoNat ZArith Lia Bool List.
From Oplus Require Import numbers convolution rotation regions secants segments_apart turning_tangents simple_chain
  simple_chains_turn_once.
Import ListNotations.

Open Scope Q_scope.

Lemma next_below i k : (S i < k)%nat -> next i k = S i.
Proof. intros L. unfold next. destruct (Nat.eqb_spec (S i) k); lia. Qed.

Lemma next_last k : (0 < k)%nat -> next (k - 1) k = 0%nat.
Proof. intros L. unfold next. destruct (Nat.eqb_spec (S (k - 1)) k); lia. Qed.

Section OneMore.
Variable chain : list vector.
Hypothesis chain_simple : simple chain.
Let n := length chain.
Let z := vertex chain (n - 1).
Let a := vertex chain 0.

(* y is inside the edge that closes the chain. *)
Variables (y : vector) (part : Q).
Hypothesis part_between : 0 < part /\ part < 1.
Hypothesis y_between :
  equal_vectors y (Vector (vx z + part * (vx a - vx z)) (vy z + part * (vy a - vy z))).

Lemma three_vertices : (3 <= n)%nat.
Proof. apply chain_simple. Qed.

Lemma closing_edge : edge_at chain (n - 1) = Segment z a.
Proof.
  pose proof three_vertices as N. rewrite edge_is by (fold n; lia). unfold z, a. f_equal.
  fold n. unfold next. destruct (Nat.eqb_spec (S (n - 1)) n); [reflexivity | lia].
Qed.

Lemma closing_edge_nonzero : nonzero (minus a z).
Proof.
  pose proof three_vertices as N. destruct chain_simple as (_ & e & _).
  assert (last : (n - 1 < length chain)%nat) by (fold n; lia).
  pose proof (edges_of_simple_chains chain (n - 1) e last) as nonzero_edge. fold n in nonzero_edge.
  unfold next in nonzero_edge. destruct (Nat.eqb_spec (S (n - 1)) n); [exact nonzero_edge | lia].
Qed.

Lemma parts_nonzero : nonzero (minus a y) /\ nonzero (minus y z).
Proof.
  pose proof closing_edge_nonzero as nonzero_edge. destruct y_between as [x_is y_is]. cbn [vx vy] in *.
  unfold nonzero, minus in *. cbn [vx vy] in *. split; intros [x_none y_none]; apply nonzero_edge.
  - split; [apply (Qmult_inj_l _ _ (1 - part)) | apply (Qmult_inj_l _ _ (1 - part))]; lra.
  - split; [apply (Qmult_inj_l _ _ part) | apply (Qmult_inj_l _ _ part)]; lra.
Qed.

(* What is on one of the two parts is on the edge. *)
Lemma part_on_edge x : lies_on x (Segment y a) \/ lies_on x (Segment z y) -> lies_on x (Segment z a).
Proof.
  destruct y_between as [x_is y_is]. cbn [vx vy] in *.
  intros [(t & range & x_on & y_on) | (t & range & x_on & y_on)]; cbn [source target] in *.
  - exists (part + t * (1 - part)). cbn [source target]. assert (0 <= t * (1 - part)) by nra.
    assert (0 <= (1 - t) * (1 - part)) by nra.
    split; [split; lra |]. rewrite x_on, y_on, x_is, y_is. split; ring.
  - exists (part * t). cbn [source target]. assert (0 <= part * t) by nra.
    assert (0 <= part * (1 - t)) by nra.
    split; [split; lra |]. rewrite x_on, y_on, x_is, y_is. split; ring.
Qed.

Lemma ends_of_parts : ~ lies_on z (Segment y a) /\ ~ lies_on a (Segment z y).
Proof.
  pose proof closing_edge_nonzero as nonzero_edge. destruct y_between as [x_is y_is]. cbn [vx vy] in *.
  unfold nonzero, minus in nonzero_edge. cbn [vx vy] in nonzero_edge.
  split; intros (t & range & x_on & y_on); cbn [source target] in *; apply nonzero_edge.
  - assert (0 <= t * (1 - part)) by nra.
    split; apply (Qmult_inj_l _ _ (part + t * (1 - part))); try lra.
    + rewrite x_is in x_on. lra.
    + rewrite y_is in y_on. lra.
  - assert (0 <= t * part) by nra. assert (0 <= (1 - t) * part) by nra.
    split; apply (Qmult_inj_l _ _ (1 - t * part)); try lra.
    + rewrite x_is in x_on. lra.
    + rewrite y_is in y_on. lra.
Qed.

Lemma only_y_on_both x : lies_on x (Segment y a) -> lies_on x (Segment z y) -> equal_vectors x y.
Proof.
  intros on_first on_last. destruct parts_nonzero as [first last].
  apply (proj1 (may_turn_decides z y a last first)); trivial.
  split; [exact last | split; [exact first |]]. intros _.
  destruct y_between as [x_is y_is]. cbn [vx vy] in *.
  pose proof (square_positive _ closing_edge_nonzero) as square.
  setoid_replace (dot (minus y z) (minus a y)) with (part * (1 - part) * dot (minus a z) (minus a z)).
  - assert (0 < part * (1 - part)) by nra. nra.
  - unfold dot, minus. cbn [vx vy]. rewrite x_is, y_is. ring.
Qed.

Lemma edges_with_y :
  edge_at (y :: chain) 0 = Segment y a /\
  (forall i, (i < n - 1)%nat -> edge_at (y :: chain) (S i) = edge_at chain i) /\
  edge_at (y :: chain) n = Segment z y.
Proof.
  pose proof three_vertices as N. assert (long : length (y :: chain) = S n) by reflexivity.
  split; [| split].
  - rewrite edge_is, long by (rewrite long; lia). rewrite next_below by lia. reflexivity.
  - intros i I. rewrite edge_is, long by (rewrite long; lia). rewrite next_below by lia.
    rewrite edge_is by (fold n; lia). fold n. now rewrite next_below by lia.
  - rewrite edge_is, long by (rewrite long; lia). replace n with (S n - 1)%nat at 2 by lia.
    rewrite next_last by lia. unfold z. replace n with (S (n - 1)) at 1 by lia. reflexivity.
Qed.

Lemma meeting_edges_with_y i j x : (i < j)%nat -> (j <= n)%nat ->
  lies_on x (edge_at (y :: chain) i) -> lies_on x (edge_at (y :: chain) j) ->
  (j = S i /\ equal_vectors x (vertex (y :: chain) j)) \/ (i = 0%nat /\ j = n /\ equal_vectors x y).
Proof.
  intros L J on_i on_j. pose proof three_vertices as N.
  destruct edges_with_y as (first & inner & last). destruct ends_of_parts as [z_off a_off].
  destruct chain_simple as (_ & _ & common). fold n in common.
  assert (in_edge : forall k, (k < n - 1)%nat -> lies_on x (edge_at chain k) -> lies_on x (Segment z a) ->
    (k = 0%nat /\ equal_vectors x a) \/ (S k = (n - 1)%nat /\ equal_vectors x z)).
  { intros k K on_k on_closing. rewrite <- closing_edge in on_closing.
    destruct (common k (n - 1)%nat x) as [[follows x_is] | [follows x_is]]; trivial; try lia.
    - right. rewrite next_below in follows by lia. split; [lia | exact x_is].
    - left. rewrite next_last in follows by lia. split; [exact follows |]. now rewrite follows in x_is. }
  assert (moved_end : forall v w s, equal_vectors v w -> lies_on v s -> lies_on w s).
  { intros v w s [xs ys] (t & range & x_on & y_on). exists t. split; [exact range |].
    now rewrite <- xs, <- ys. }
  destruct i as [| i].
  - rewrite first in on_i. destruct (Nat.eq_dec j n) as [-> | inside].
    + right. rewrite last in on_j. repeat split; trivial; now apply only_y_on_both.
    + destruct j as [| j]; [lia |]. rewrite inner in on_j by lia.
      destruct (in_edge j) as [[-> x_is] | [_ x_is]]; trivial; try lia.
      * apply part_on_edge. now left.
      * left. now split.
      * elim z_off. now apply (moved_end x z).
  - left. destruct j as [| j]; [lia |]. rewrite inner in on_i by lia.
    destruct (Nat.eq_dec (S j) n) as [last_one | inside].
    + rewrite last_one, last in on_j.
      destruct (in_edge i) as [[_ x_is] | [i_is x_is]]; trivial; try lia.
      * apply part_on_edge. now right.
      * elim a_off. now apply (moved_end x a).
      * split; [lia |]. change (vertex (y :: chain) (S j)) with (vertex chain j).
        replace j with (n - 1)%nat by lia. exact x_is.
    + rewrite inner in on_j by lia.
      destruct (common i j x) as [[follows x_is] | [follows x_is]]; trivial; try lia.
      * rewrite next_below in follows by lia. split; [lia | exact x_is].
      * rewrite next_below in follows by lia. lia.
Qed.

(* Theorem. The chain with y as first vertex is simple. *)
Theorem simple_with_one_more : simple (y :: chain).
Proof.
  pose proof three_vertices as N. destruct edges_with_y as (first & inner & last).
  destruct parts_nonzero as [n_first n_last].
  assert (long : length (y :: chain) = S n) by reflexivity.
  split; [cbn [length]; fold n; lia | split].
  - intros u I. apply (In_nth _ _ nowhere) in I. destruct I as (i & I & <-).
    rewrite edges_length, long in I. fold (edge_of_chain (y :: chain) i).
    rewrite edge_of_chain_joins_vertices, long by (rewrite long; lia).
    destruct (Nat.eq_dec i n) as [-> | inside].
    + replace n with (S n - 1)%nat at 1 by lia. rewrite next_last by lia.
      replace n with (S (n - 1)) by lia. exact n_last.
    + rewrite next_below by lia. destruct i as [| i]; [exact n_first |].
      destruct chain_simple as (_ & e & _).
      assert (i_below : (i < length chain)%nat) by (fold n; lia).
      pose proof (edges_of_simple_chains chain i e i_below) as n_edge. fold n in n_edge.
      rewrite next_below in n_edge by lia. exact n_edge.
  - rewrite long. intros i j x I J differ on_i on_j.
    assert (ordered : forall k l, (k < l)%nat -> (l <= n)%nat ->
      lies_on x (edge_at (y :: chain) k) -> lies_on x (edge_at (y :: chain) l) ->
      (l = next k (S n) /\ equal_vectors x (vertex (y :: chain) l)) \/
      (k = next l (S n) /\ equal_vectors x (vertex (y :: chain) k))).
    { intros k l K L on_k on_l.
      destruct (meeting_edges_with_y k l x K L on_k on_l) as [[l_is x_is] | (k_is & l_is & x_is)].
      - left. rewrite next_below by lia. now split.
      - right. subst k l. replace n with (S n - 1)%nat at 1 by lia. rewrite next_last by lia.
        split; [reflexivity | exact x_is]. }
    destruct (Nat.lt_trichotomy i j) as [less | [same | more]]; [| contradiction |].
    + apply ordered; trivial; lia.
    + destruct (ordered j i more) as [found | found]; trivial; [lia | now right | now left].
Qed.

End OneMore.

(* The length of an edge does not matter. *)
Lemma sweep_of_scaled (d : direction) (u v u' v' : vector) (k l : Q) :
  proper d -> nonzero u -> nonzero v -> 0 < k -> 0 < l ->
  equal_vectors u' (Vector (k * vx u) (k * vy u)) -> equal_vectors v' (Vector (l * vx v) (l * vy v)) ->
  sweep d u' v' = sweep d u v.
Proof.
  intros nd nu nv k_positive l_positive [xu yu] [xv yv]. cbn [vx vy] in *.
  assert (same_angles : forall w w' m, nonzero w -> 0 < m -> vx w' == m * vx w -> vy w' == m * vy w ->
    nonzero w' /\ angle w' == angle w).
  { intros w w' m nw positive x_is y_is. assert (nw' : nonzero w').
    { intros [x_none y_none]. apply nw. rewrite x_none in x_is. rewrite y_none in y_is.
      symmetry in x_is, y_is.
      destruct (Qmult_integral _ _ x_is), (Qmult_integral _ _ y_is); lra. }
    split; [exact nw' |]. apply same_direction_angle; trivial. now exists m. }
  destruct (same_angles u u' k) as [nu' angle_u]; trivial.
  destruct (same_angles v v' l) as [nv' angle_v]; trivial.
  assert (cross_is : cross u' v' == k * l * cross u v) by (unfold cross; rewrite xu, yu, xv, yv; ring).
  assert (0 < k * l) by (apply Qmult_lt_0_compat; assumption).
  destruct d as [d s].
  assert (comparisons : forall b b' c c' r t, nonzero b -> nonzero b' -> nonzero c -> nonzero c' ->
    angle b' == angle b -> angle c' == angle c ->
    compare (Direction b' r) (Direction c' t) = compare (Direction b r) (Direction c t)).
  { intros b b' c c' r t nb nb' nc nc' same_b same_c. unfold compare. cbn [vec of].
    rewrite !compare_angle_is by assumption. now rewrite same_b, same_c. }
  assert (itself : angle d == angle d) by reflexivity. unfold proper in nd. cbn [vec] in nd.
  unfold sweep, ccw, before. cbn [of].
  rewrite (comparisons u u' d d), (comparisons d d u u'), (comparisons v v' d d), (comparisons d d v v'),
    (comparisons u u' v v'), (comparisons v v' u u') by assumption.
  compared_numbers (cross u' v' ?= 0); compared_numbers (cross u v ?= 0); trivial; exfalso; nra.
Qed.

Lemma succession_between (f : vector -> vector -> Z) (u u' z z' : vector) (us : list vector) :
  us <> [] -> (forall w, In w us -> f u' w = f u w) -> (forall w, In w us -> f w z' = f w z) ->
  in_succession f (u' :: us ++ [z']) = in_succession f (u :: us ++ [z]).
Proof.
  intros some first last. destruct us as [| w us]; [contradiction |]. clear some.
  change (in_succession f (u' :: (w :: us) ++ [z'])) with (f u' w + in_succession f (w :: us ++ [z']))%Z.
  change (in_succession f (u :: (w :: us) ++ [z])) with (f u w + in_succession f (w :: us ++ [z]))%Z.
  rewrite (first w (or_introl eq_refl)). f_equal. clear first.
  revert w last. induction us as [| v us IH]; intros w last.
  - cbn. now rewrite (last w (or_introl eq_refl)).
  - change (in_succession f (w :: (v :: us) ++ [z'])) with (f w v + in_succession f (v :: us ++ [z']))%Z.
    change (in_succession f (w :: (v :: us) ++ [z])) with (f w v + in_succession f (v :: us ++ [z]))%Z.
    rewrite IH; [reflexivity |]. intros b I. apply last. now right.
Qed.

(* Theorem. The vertex inside the edge from z to a changes nothing about the turning number. *)
Theorem turning_number_with_one_more (a z y : vector) (middle : list vector) (part : Q) :
  simple (a :: middle ++ [z]) -> 0 < part /\ part < 1 ->
  equal_vectors y (Vector (vx z + part * (vx a - vx z)) (vy z + part * (vy a - vy z))) ->
  turning_number (y :: a :: middle ++ [z]) = turning_number (a :: middle ++ [z]).
Proof.
  intros chain_simple [after_z before_a] [x_is y_is]. cbn [vx vy] in *.
  pose proof (simple_chain_turns_everywhere _ chain_simple) as everywhere.
  unfold turning_number. set (d := Direction right OfQ).
  assert (nd : proper d) by (unfold proper, d, nonzero, right; cbn; lra).
  assert (edges_proper : forall w, In w (edge_directions (a :: middle ++ [z])) -> nonzero w).
  { intros w I. apply (In_nth _ _ nowhere) in I. destruct I as (i & I & <-). rewrite edges_length in I.
    now apply (edges_are_directions (a :: middle ++ [z]) i OfP). }
  assert (all_edges : edge_directions (a :: middle ++ [z]) = steps (a :: middle ++ [z]) ++ [minus a z]).
  { rewrite steps_of_edges, <- app_assoc. exact (steps_more (a :: middle) z a). }
  rewrite all_edges in edges_proper.
  assert (closing_proper : nonzero (minus a z)) by (apply edges_proper, in_app_iff; right; now left).
  change (turns_past d (y :: (a :: middle) ++ [z]) = turns_past d (a :: middle ++ [z])).
  unfold d. rewrite !turns_past_is_along, !turns_along_steps. fold d.
  assert (some_steps : steps (a :: middle ++ [z]) <> []) by (destruct middle; discriminate).
  change (steps (z :: a :: middle ++ [z; a])) with (minus a z :: steps ((a :: middle) ++ [z; a])).
  change (steps (z :: y :: (a :: middle) ++ [z; y])) with
    (minus y z :: minus a y :: steps ((a :: middle) ++ [z; y])).
  rewrite !steps_more. cbn [app] in *.
  set (inner := steps (a :: middle ++ [z])) in *.
  change (in_succession (sweep d) (minus y z :: minus a y :: inner ++ [minus y z])) with
    (sweep d (minus y z) (minus a y) + in_succession (sweep d) (minus a y :: inner ++ [minus y z]))%Z.
  assert (parts : equal_vectors (minus y z) (Vector (part * vx (minus a z)) (part * vy (minus a z))) /\
    equal_vectors (minus a y) (Vector ((1 - part) * vx (minus a z)) ((1 - part) * vy (minus a z)))).
  { unfold equal_vectors, minus. cbn [vx vy]. rewrite x_is, y_is. repeat split; ring. }
  destruct parts as [first_part second_part].
  assert (straight : cross (minus y z) (minus a y) == 0).
  { destruct first_part as [xf yf], second_part as [xs ys]. cbn [vx vy] in xf, yf, xs, ys.
    unfold cross. rewrite xf, yf, xs, ys. ring. }
  assert (none : sweep d (minus y z) (minus a y) = 0%Z).
  { unfold sweep. compared_numbers (cross (minus y z) (minus a y) ?= 0); [reflexivity | lra | lra]. }
  rewrite none. apply succession_between; trivial.
  - intros w I.
    apply (sweep_of_scaled d (minus a z) w (minus a y) w (1 - part) 1); trivial; try lra;
      [apply edges_proper, in_app_iff; now left | split; cbn [vx vy]; ring].
  - intros w I.
    apply (sweep_of_scaled d w (minus a z) w (minus y z) 1 part); trivial; try lra;
      [apply edges_proper, in_app_iff; now left | split; cbn [vx vy]; ring].
Qed.
