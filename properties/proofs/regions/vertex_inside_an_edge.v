(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* With one more vertex, inside an edge, a simple chain is simple and has the same turning number. Simple chains
   are in simple_chain.v. *)
From Coq Require Import PeanoNat ZArith Lia Bool List.
From Oplus Require Import numbers convolution rotation regions secants segments_apart turning_tangents simple_chain
  simple_chains_turn_once.
Import ListNotations.

Open Scope Q_scope.

Lemma nonzero_scaled (u u' : vector) (k : Q) :
  nonzero u -> 0 < k -> equal_vectors u' (Vector (k * vx u) (k * vy u)) -> nonzero u'.
Proof.
  intros nu some [x_is y_is] [x_none y_none]. cbn [vx vy] in *. apply nu.
  split; apply (Qmult_inj_l _ _ k); lra.
Qed.

Lemma turns_scaled (u v u' v' : vector) (k l : Q) : 0 < k -> 0 < l ->
  equal_vectors u' (Vector (k * vx u) (k * vy u)) -> equal_vectors v' (Vector (l * vx v) (l * vy v)) ->
  turns u v -> turns u' v'.
Proof.
  intros some_k some_l eu ev (nu & nv & ahead).
  split; [now apply (nonzero_scaled u _ k) | split; [now apply (nonzero_scaled v _ l) |]].
  destruct eu as [xu yu], ev as [xv yv]. cbn [vx vy] in *. unfold cross, dot in *. rewrite xu, yu, xv, yv.
  assert (0 < k * l) by nra. intros none.
  assert (vx u * vy v - vy u * vx v == 0) as straight by (apply (Qmult_inj_l _ _ (k * l)); lra).
  specialize (ahead straight). nra.
Qed.

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

Lemma directions_of_parts :
  equal_vectors (minus y z) (Vector (part * vx (minus a z)) (part * vy (minus a z))) /\
  equal_vectors (minus a y) (Vector ((1 - part) * vx (minus a z)) ((1 - part) * vy (minus a z))).
Proof.
  destruct y_between as [x_is y_is]. unfold equal_vectors, minus. cbn [vx vy] in *. rewrite x_is, y_is.
  repeat split; ring.
Qed.

Lemma parts_nonzero : nonzero (minus a y) /\ nonzero (minus y z).
Proof.
  pose proof closing_edge_nonzero as n_edge. destruct directions_of_parts as [from_z to_a].
  split; [apply (nonzero_scaled (minus a z) _ (1 - part)) | apply (nonzero_scaled (minus a z) _ part)]; trivial; lra.
Qed.

(* What is apart from the edge is apart from its parts. *)
Lemma parts_are_apart (c e : vector) : (apart z a c e -> apart y a c e) /\ (apart c e z a -> apart c e z y).
Proof.
  destruct y_between as [x_is y_is]. cbn [vx vy] in *.
  split; intros (w & f1 & f2 & f3 & f4); exists w; unfold in_front, dot, minus in *; cbn [vx vy] in *;
    rewrite x_is, y_is; repeat split; trivial; nra.
Qed.

(* So is one part from the edge before, the other from the edge after. *)
Lemma parts_beside_other_edges (c : vector) :
  (turns (minus z c) (minus a z) -> apart y a c z) /\ (turns (minus a z) (minus c a) -> apart a c z y).
Proof.
  destruct y_between as [x_is y_is]. cbn [vx vy] in *.
  split; intros turn; destruct (turning_is_in_front _ _ turn) as (w & f & g); exists (opposite w);
    unfold in_front, dot, opposite, minus in *; cbn [vx vy] in *; rewrite x_is, y_is; repeat split; nra.
Qed.

(* Theorem. The chain with y as first vertex is simple. *)
Theorem simple_with_one_more : simple (y :: chain).
Proof.
  pose proof three_vertices as N. destruct directions_of_parts as [from_z to_a].
  assert (itself : forall u, equal_vectors u (Vector (1 * vx u) (1 * vy u))) by (intros u; split; cbn; ring).
  assert (turn : forall i, (S (S i) < n)%nat ->
    turns (minus (vertex chain (S i)) (vertex chain i)) (minus (vertex chain (S (S i))) (vertex chain (S i)))).
  { intros i I. pose proof (simple_chain_turns chain i chain_simple) as t. cbv zeta in t. fold n in t.
    rewrite !next_below in t by lia. apply t. lia. }
  assert (turn_at_z : turns (minus z (vertex chain (n - 2))) (minus a z)).
  { pose proof (simple_chain_turns chain (n - 2) chain_simple) as t. cbv zeta in t. fold n in t.
    rewrite next_below in t by lia. replace (S (n - 2)) with (n - 1)%nat in t by lia.
    rewrite next_last in t by lia. apply t. lia. }
  assert (turn_at_a : turns (minus a z) (minus (vertex chain 1) a)).
  { pose proof (simple_chain_turns chain (n - 1) chain_simple) as t. cbv zeta in t. fold n in t.
    rewrite next_last, next_below in t by lia. apply t. lia. }
  assert (far : forall i j, (i < n)%nat -> (j < n)%nat -> i <> j -> j <> next i n -> i <> next j n ->
    apart (vertex chain i) (vertex chain (next i n)) (vertex chain j) (vertex chain (next j n)))
    by (intros; now apply are_apart_sound, simple_chain_edges_apart).
  apply simple_by_turns; cbn [length]; fold n; [lia | |].
  - intros [| i] I.
    + rewrite !next_below by lia.
      exact (turns_scaled _ _ _ _ (1 - part) 1 ltac:(lra) ltac:(lra) to_a (itself _) turn_at_a).
    + destruct (Nat.eq_dec (S i) n) as [last | inner].
      * replace (S i) with (S n - 1)%nat by lia. rewrite next_last, next_below by lia.
        replace (S n - 1)%nat with (S (n - 1)) by lia.
        apply (turns_scaled (minus a z) (minus a z) _ _ part (1 - part)); try lra; trivial.
        pose proof closing_edge_nonzero. repeat split; trivial. intros _. now apply square_positive.
      * rewrite (next_below (S i)) by lia. destruct (Nat.eq_dec (S (S i)) n) as [last | inner'].
        -- replace (S (S i)) with (S n - 1)%nat by lia. rewrite next_last by lia.
           replace (S n - 1)%nat with (S (n - 1)) by lia. replace (S i) with (S (n - 2)) by lia.
           exact (turns_scaled _ _ _ _ 1 part ltac:(lra) ltac:(lra) (itself _) from_z turn_at_z).
        -- rewrite next_below by lia. apply turn. lia.
  - intros i [| k] less J not_next not_before; [lia |]. destruct i as [| h].
    + rewrite !next_below in * by lia.
      destruct (Nat.eq_dec (S k) n) as [last | inner].
      { elim not_before. replace (S k) with (S n - 1)%nat by lia. symmetry. apply next_last. lia. }
      rewrite !next_below in * by lia. change (apart y a (vertex chain k) (vertex chain (S k))).
      destruct (Nat.eq_dec (S (S k)) n) as [before_z | not_adjacent].
      * replace (S k) with (n - 1)%nat by lia. apply (proj1 (parts_beside_other_edges _)).
        replace k with (n - 2)%nat by lia. exact turn_at_z.
      * apply (proj1 (parts_are_apart _ _)). pose proof (far (n - 1)%nat k) as f.
        rewrite next_last, next_below in f by lia. apply f; lia.
    + rewrite (next_below (S h)) in * by lia. destruct (Nat.eq_dec (S k) n) as [last | inner].
      * replace (S k) with (S n - 1)%nat by lia. rewrite next_last by lia.
        replace (S n - 1)%nat with (S (n - 1)) by lia. change (apart (vertex chain h) (vertex chain (S h)) z y).
        destruct h as [| h].
        -- exact (proj2 (parts_beside_other_edges _) turn_at_a).
        -- apply (proj2 (parts_are_apart _ _)). pose proof (far (S h) (n - 1)%nat) as f.
           rewrite next_last, next_below in f by lia. apply f; lia.
      * rewrite next_below in * by lia. pose proof (far h k) as f. rewrite !next_below in f by lia. apply f; lia.
Qed.

End OneMore.

(* The length of an edge does not matter. *)
Lemma sweep_of_scaled (d : direction) (u v u' v' : vector) (k l : Q) :
  proper d -> nonzero u -> nonzero v -> 0 < k -> 0 < l ->
  equal_vectors u' (Vector (k * vx u) (k * vy u)) -> equal_vectors v' (Vector (l * vx v) (l * vy v)) ->
  sweep d u' v' = sweep d u v.
Proof.
  intros nd nu nv k_positive l_positive eu ev. destruct d as [d s].
  assert (same_left : forall w w' m, 0 < m -> equal_vectors w' (Vector (m * vx w) (m * vy w)) ->
    left_of_ray s d w' = left_of_ray s d w).
  { intros w w' m some [x_is y_is]. cbn [vx vy] in *.
    assert (cross w' d == m * cross w d /\ cross d w' == m * cross d w) as [left_ right_]
      by (unfold cross; rewrite x_is, y_is; split; ring).
    unfold left_of_ray. destruct s; [destruct (negative_spec (cross d w')), (negative_spec (cross d w))
      | destruct (negative_spec (cross w' d)), (negative_spec (cross w d))]; trivial; exfalso; nra. }
  pose proof (nonzero_scaled u u' k nu k_positive eu). pose proof (nonzero_scaled v v' l nv l_positive ev).
  rewrite !sweep_by_sides by assumption.
  rewrite (same_left u u' k), (same_left v v' l) by assumption. f_equal.
  assert (cross_is : cross u' v' == k * l * cross u v)
    by (destruct eu as [xu yu], ev as [xv yv]; unfold cross; cbn [vx vy] in *; rewrite xu, yu, xv, yv; ring).
  assert (0 < k * l) by nra. destruct (Qcompare_spec (cross u' v') 0), (Qcompare_spec (cross u v) 0); trivial;
    exfalso; nra.
Qed.

Lemma succession_between (f : vector -> vector -> Z) (u u' z z' : vector) (us : list vector) :
  us <> [] -> (forall w, In w us -> f u' w = f u w) -> (forall w, In w us -> f w z' = f w z) ->
  in_succession f (u' :: us ++ [z']) = in_succession f (u :: us ++ [z]).
Proof.
  intros some first last. destruct us as [| w us]; [contradiction |]. cbn [app in_succession].
  rewrite (first w (or_introl eq_refl)). f_equal. clear some first.
  revert w last. induction us as [| v us IH]; intros w last; cbn [app in_succession] in *.
  - now rewrite (last w (or_introl eq_refl)).
  - now rewrite IH by (intros; apply last; now right).
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
  unfold d. rewrite !turns_past_is_along. unfold turns_along. fold d.
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
