(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* A set given by a rule over winding numbers ends at the pieces into which the segments cut each other: off them no
   winding number changes, and along a piece those on its right are those right of its middle. So one program returns
   what closed segments go round, unions, intersections and differences. *)
From Coq Require Import QArith Qminmax Lqa ZArith Lia Bool List.
From Oplus Require Import direction angle angular_crossings winding_number shifted_ray small_numbers signed_crossings
  regions meeting_of_segments first_hit interiors_meet neighbourhoods location pieces beside_a_piece filling
  kept_pieces_go_round cut_pieces.
Import ListNotations.

Open Scope Q_scope.

Lemma zero_far_to_the_right (segments : list segment) :
  exists limit, forall x, limit < vx x -> winding_number x segments = 0%Z.
Proof.
  unfold winding_number, sum. induction segments as [| s l (limit & zero_)]; [now exists 0 |].
  set (most := Qmax (vx (source s)) (vx (target s))). exists (Qmax limit most). intros x far. cbn [map fold_right].
  pose proof (Q.le_max_l limit most). pose proof (Q.le_max_r limit most).
  pose proof (Q.le_max_l (vx (source s)) (vx (target s))). pose proof (Q.le_max_r (vx (source s)) (vx (target s))).
  fold most in H1, H2. rewrite zero_ by lra. rewrite signed_crossing_by_height.
  destruct (spans s (vy x)) eqn:spanning; [| reflexivity]. cbn [andb].
  destruct (negative_spec (vx x - vx (point_at_height s (vy x)))) as [ahead |]; [exfalso | reflexivity].
  destruct (point_at_height_lies_on s (vy x) spanning) as (k & range & X & _).
  assert (0 <= k * (most - vx (target s))) by (apply Qmult_le_0_compat; lra).
  assert (0 <= (1 - k) * (most - vx (source s))) by (apply Qmult_le_0_compat; lra). lra.
Qed.

Section Rule.
  Variable rule : list Z -> bool.
  Variable families : list (list segment).
  Hypothesis closed : forall l, In l families -> cycles l.
  Hypothesis all_long : forall t, In t (concat families) -> nonzero (along t).
  Hypothesis nothing : rule (map (fun _ => 0%Z) families) = false.

  Definition by_rule (x : vector) : bool := rule (map (winding_number x) families).

  Lemma by_rule_same (x y : vector) :
    (forall l, In l families -> winding_number x l = winding_number y l) -> by_rule x = by_rule y.
  Proof. intros same_. unfold by_rule. f_equal. now apply map_ext_in. Qed.

  Theorem rule_ends_at_pieces :
    ends_at_pieces by_rule (right_by_rule rule families) (pieces_of (concat families)).
  Proof.
    pose proof (pieces_are_pieces (concat families) all_long) as cut_. split.
    - exact (pieces_are_long _ _ cut_).
    - exact (pieces_are_apart _ _ cut_).
    - intros a b [X Y]. apply by_rule_same. intros l _. now apply winding_number_of_equal.
    - intros a b free. apply by_rule_same. intros l L.
      apply (winding_number_along (Segment a b) l (closed l L)). intros w on t T on_t.
      destruct (pieces_are_all _ _ cut_ t w) as (e & E & on_e); [apply in_concat; now exists l | exact on_t |].
      exact (free w on e E on_e).
    - intros e s w n E which inside_ turn.
      assert (long : nonzero (along s)).
      { pose proof (pieces_are_long _ _ cut_ e E) as long. destruct which as [-> | ->]; [exact long |].
        exact (long_of_one_place _ _ (reversed_place e) long). }
      assert (only : met_only_along (concat families) s).
      { pose proof (pieces_are_met_along _ _ cut_ e E) as only. destruct which as [-> | ->]; [exact only |].
        now apply met_only_along_reversed. }
      assert (each : eventually (fun d => forall l, In l families ->
        winding_number (moved_along w n d) l = winding_number_shifted (right_of_middle s) l)).
      { apply (eventually_for_all (fun l d =>
          winding_number (moved_along w n d) l = winding_number_shifted (right_of_middle s) l)). intros l L.
        apply (to_the_right_of_a_piece l s (closed l L)); trivial. intros v t inside_v T. apply (only v t inside_v).
        apply in_concat. now exists l. }
      refine (eventually_implied _ _ _ each). intros d same_. unfold by_rule, right_by_rule. f_equal.
      now apply map_ext_in.
    - enough (all : exists limit, forall l, In l families -> forall x, limit < vx x -> winding_number x l = 0%Z).
      { destruct all as (limit & zero_). exists limit. intros x far. unfold by_rule. rewrite <- nothing. f_equal.
        apply map_ext_in. intros l L. now apply zero_. }
      clear. induction families as [| l rest (limit & zero_)]; [now exists 0 |].
      destruct (zero_far_to_the_right l) as (limit_of_l & zero_of_l). exists (Qmax limit limit_of_l).
      pose proof (Q.le_max_l limit limit_of_l). pose proof (Q.le_max_r limit limit_of_l).
      intros m [<- | M] x far; [apply zero_of_l | apply (zero_ m M)]; lra.
  Qed.

  (* Theorem. What is kept by a rule goes once round the points to which it applies, also seen from the segments. *)
  Theorem boundary_by_rule_goes_round (x : vector) :
    winding_number x (boundary_by_rule rule families) = as_number (by_rule x).
  Proof.
    assert (same_ : eventually (fun d => by_rule (moved (shifted x) d) = by_rule x)).
    { refine (eventually_implied _ _ _ (eventually_for_all (fun l d =>
        winding_number (moved (shifted x) d) l = winding_number x l) families (fun l _ => same_beside x l))).
      intros d. apply by_rule_same. }
    destruct (some_small _ (eventually_and _ _ (core _ _ _ rule_ends_at_pieces x) same_))
      as (e & _ & number_is & same_number).
    now rewrite <- same_number.
  Qed.
End Rule.

(* What closed segments go round. *)
Section Filled.
  Variable segments : list segment.
  Hypothesis all_long : forall t, In t segments -> nonzero (along t).
  Hypothesis closed : cycles segments.

  Definition first_is_positive (numbers : list Z) : bool := match numbers with [] => false | n :: _ => (0 <? n)%Z end.

  Theorem filled_ends_at_pieces : ends_at_pieces (fun x => 0 <? winding_number x segments)%Z (is_right_inside segments)
    (pieces_of segments).
  Proof.
    pose proof (rule_ends_at_pieces first_is_positive [segments]) as ends_. cbn [concat] in ends_.
    rewrite app_nil_r in ends_. apply ends_; [| exact all_long | reflexivity]. intros l [<- | []]. exact closed.
  Qed.

  Theorem filled_is_right (x : vector) :
    winding_number x (filled segments) = if (0 <? winding_number x segments)%Z then 1%Z else 0%Z.
  Proof.
    destruct (some_small _ (eventually_and _ _ (core _ _ _ filled_ends_at_pieces x) (same_beside x segments)))
      as (e & _ & number_is & same_number).
    now rewrite <- same_number.
  Qed.

End Filled.
