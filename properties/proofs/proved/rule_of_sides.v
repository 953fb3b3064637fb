(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* A set given by a rule over winding numbers ends at the pieces into which the segments cut each other: off them no
   winding number changes, and along a piece those on its right are those right of its middle. So one program returns
   what closed segments go round, unions, intersections and differences. *)
From Coq Require Import QArith Qminmax Lqa ZArith Lia Bool List.
From Oplus Require Import direction angle angular_crossings winding_number shifted_ray small_numbers signed_crossings
  regions meeting_of_segments first_hit interiors_meet neighbourhoods location pieces beside_a_piece filling
  kept_pieces_go_round cut_pieces beside_a_vertex.
Import ListNotations.

Open Scope Q_scope.

Lemma nothing_far_to_the_right (segments : list segment) :
  exists limit, forall x s, limit < vx x -> In s segments -> signed_crossing x s = 0%Z.
Proof.
  induction segments as [| s l (limit & none)]; [now exists 0 |].
  set (most := Qmax (vx (source s)) (vx (target s))). exists (Qmax limit most). intros x t far T.
  pose proof (Q.le_max_l limit most). pose proof (Q.le_max_r limit most).
  destruct T as [<- | T]; [| apply none; [lra | exact T]].
  pose proof (Q.le_max_l (vx (source s)) (vx (target s)) : _ <= most).
  pose proof (Q.le_max_r (vx (source s)) (vx (target s)) : _ <= most).
  rewrite signed_crossing_by_height. destruct (spans s (vy x)) eqn:spanning; [| reflexivity]. cbn [andb].
  destruct (negative_spec (vx x - vx (point_at_height s (vy x)))) as [ahead |]; [exfalso | reflexivity].
  destruct (point_at_height_lies_on s (vy x) spanning) as (k & range & X & _).
  pose proof (mixed_is_less k (vx (source s)) (vx (target s)) (vx x) range ltac:(lra) ltac:(lra)). lra.
Qed.

Lemma pieces_of_share_ends (segments : list segment) : (forall t, In t segments -> nonzero (along t)) ->
  share_ends_only (pieces_of segments).
Proof.
  intros all_long. split.
  - apply NoDup_nodup.
  - exact (pieces_are_long _ _ (pieces_are_pieces segments all_long)).
  - intros e f w E F differ_ on in_e.
    assert (no_end : forall v, v = source f \/ v = target f -> ~ equal_vectors v w).
    { intros v end_ [X Y]. apply (no_vertex_is_inside segments all_long f e v F E end_).
      destruct in_e as (k & range & kx & ky). exists k. rewrite X, Y. tauto. }
    destruct (inside_or_end w f on) as [in_f | [equal | equal]]; 
      [| destruct (no_end _ (or_introl eq_refl) equal) | destruct (no_end _ (or_intror eq_refl) equal)].
    exact (different_pieces segments all_long e f E F differ_ w in_e in_f).
  - intros e f v w E F V W equal. destruct (ends_are_reduced segments all_long e E) as [e1 e2].
    destruct (ends_are_reduced segments all_long f F) as [f1 f2]. apply reduced_of_equal in equal.
    destruct V as [-> | ->], W as [-> | ->]; congruence.
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
    - now apply pieces_of_share_ends.
    - intros a b [X Y]. apply by_rule_same. intros l _. now apply winding_number_of_equal.
    - intros a b free. apply by_rule_same. intros l L.
      apply (winding_number_along (Segment a b) l (closed l L)). intros w on t T on_t.
      destruct (pieces_are_all _ _ cut_ t w) as (e & E & on_e); [apply in_concat; now exists l | exact on_t |].
      exact (free w on e E on_e).
    - intros s w n S inside_ turn.
      pose proof (directed_is_long _ (pieces_of_share_ends _ all_long) s S) as long.
      assert (only : met_only_along (concat families) s).
      { destruct S as [S | S]; [| rewrite <- (reversed_twice s); apply met_only_along_reversed];
          exact (pieces_are_met_along _ _ cut_ _ S). }
      assert (each : eventually (fun d => forall l, In l families ->
        winding_number (moved_along w n d) l = winding_number_shifted (right_of_middle s) l)).
      { apply (eventually_for_all (fun l d =>
          winding_number (moved_along w n d) l = winding_number_shifted (right_of_middle s) l)). intros l L.
        apply (to_the_right_of_a_piece l s (closed l L)); trivial. intros v t inside_v T. apply (only v t inside_v).
        apply in_concat. now exists l. }
      refine (eventually_implied _ _ _ each). intros d same_. unfold by_rule, right_by_rule. f_equal.
      now apply map_ext_in.
    - destruct (nothing_far_to_the_right (concat families)) as (limit & none). exists limit. intros x far.
      unfold by_rule. rewrite <- nothing. f_equal. apply map_ext_in. intros l L. apply sum_of_zeros. intros s S.
      apply none; [exact far | apply in_concat; now exists l].
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
