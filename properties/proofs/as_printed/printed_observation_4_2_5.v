(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Observation 4.2.5 as printed, for polygonal curves. A path leads from one point to another, both off a closed chain
   that it never touches without crossing: it passes no vertex of the chain, none of its own vertices is on the chain,
   and no step is along an edge (Definition 4.2.4). At each point where a step crosses an edge the winding number
   changes by the sign of the dot product of the normal to the edge, which is to its right, and of the step, negated
   (Definition 4.2.3); edges that overlap there count one by one. The changes add up to the difference of the winding numbers at the
   ends. The thesis has continuous curves. Its chains, its rays and all paths in these proofs are polygonal, and two
   points of one face are joined by a polygonal path in it: so nothing that rests on the observation needs more.
   It is proved in signed_crossings.v and crossing_of_a_step.v, for paths in any position. *)
From Coq Require Import ZArith Lia Bool List.
From Oplus Require Import numbers convolution segments_apart signed_crossings meeting_of_segments crossing_of_a_step.
Import ListNotations.

Open Scope Q_scope.

Fixpoint steps_of_path (path : list vector) : list segment :=
  match path with a :: ((b :: _) as rest) => Segment a b :: steps_of_path rest | _ => [] end.

(* Where a step and an edge meet, they cross. *)
Definition crosses_where_it_meets (path : list vector) (curve : list segment) : Prop :=
  forall step_ s x, In step_ (steps_of_path path) -> In s curve -> lies_on x step_ -> lies_on x s ->
    strictly_inside x step_ /\ strictly_inside x s /\ ~ cross (along s) (along step_) == 0.

Definition normal_to_the_right (s : segment) : vector := Vector (vy (along s)) (- vx (along s)).

(* Definition 4.2.3. By how much the winding number changes where this step meets this edge. *)
Definition changes_by (step_ s : segment) (change : Z) : Prop :=
  (forall x, lies_on x step_ -> lies_on x s ->
     change = (- sign_of (dot (normal_to_the_right s) (along step_) ?= 0)%Q)%Z) /\
  ((forall x, lies_on x step_ -> ~ lies_on x s) -> change = 0%Z).

Lemma crossing_position (a b x : vector) (s : segment) :
  strictly_inside x (Segment a b) -> strictly_inside x s -> ~ cross (along s) (along (Segment a b)) == 0 ->
  in_general_position a b s.
Proof.
  destruct s as [c e]. intros (t & t_range & X & Y) (r & r_range & X' & Y') no. unfold in_general_position.
  rewrite !orientation_by_area. cbn [source target] in *.
  assert (differ : forall v : Q, ~ v == 0 -> (v ?= 0) <> Eq) by (intros v some equal; now apply some, Qeq_alt).
  set (k := cross (along (Segment c e)) (along (Segment a b))) in *.
  assert (at_a : area (Segment c e) a == - (t * k)) by (unfold k; in_coordinates; by_equations).
  assert (at_b : area (Segment c e) b == (1 - t) * k) by (unfold k; in_coordinates; by_equations).
  assert (at_c : area (Segment a b) c == r * k) by (unfold k; in_coordinates; by_equations).
  assert (at_e : area (Segment a b) e == - ((1 - r) * k)) by (unfold k; in_coordinates; by_equations).
  clearbody k.
  assert (k < 0 \/ 0 < k) by (destruct (Q_dec k 0) as [[less | more] | zero_]; [now left | now right | lra]).
  repeat split; apply differ; rewrite ?at_a, ?at_b, ?at_c, ?at_e; nra.
Qed.

(* The change is what signed_crossings.v counts. *)
Lemma change_is_signed_crossing (a b : vector) (s : segment) (change : Z) : changes_by (Segment a b) s change ->
  (forall x, lies_on x (Segment a b) -> lies_on x s ->
     strictly_inside x (Segment a b) /\ strictly_inside x s /\ ~ cross (along s) (along (Segment a b)) == 0) ->
  change = signed_crossing_of_step a b s.
Proof.
  intros [meets apart_] crosses.
  assert (sign_is : (- sign_of (dot (normal_to_the_right s) (along (Segment a b)) ?= 0)%Q)%Z =
    sign_of (dot (normal (minus (target s) (source s))) (minus b a) ?= 0)).
  { set (u := minus (target s) (source s)). set (v := minus b a).
    rewrite (compare_as_difference (dot (normal_to_the_right s) (along (Segment a b))) 0 0 (dot (normal u) v))
      by (unfold u, v, normal_to_the_right, normal, along, dot; cbn [vx vy source target]; ring).
    rewrite <- (Qcompare_antisym (dot (normal u) v) 0). now destruct (dot (normal u) v ?= 0). }
  destruct (Z.eq_dec (signed_crossing_of_step a b s) 0) as [none | some].
  - rewrite none. apply apart_. intros x on on_s. destruct (crosses x on on_s) as (inside_ & inside_s & no).
    pose proof (crossing_in_general_position a b s (crossing_position a b x s inside_ inside_s no)) as [iff_ _].
    apply (proj2 iff_); [now exists x | exact none].
  - destruct (crossing_steps_meet a b s some) as (x & on & on_s).
    destruct (crosses x on on_s) as (inside_ & inside_s & no).
    pose proof (crossing_in_general_position a b s (crossing_position a b x s inside_ inside_s no)) as [_ value].
    rewrite (value some), (meets x on on_s). exact sign_is.
Qed.

(* Theorem, Observation 4.2.5, for polygonal curves; the closed chain may overlap and cross itself. *)
Theorem observation_4_2_5_as_printed (chain path : list vector) (first_ : vector) (change : segment -> segment -> Z) :
  let c := edges chain in
  off first_ c -> off (last path first_) c -> crosses_where_it_meets (first_ :: path) c ->
  (forall step_ s, In step_ (steps_of_path (first_ :: path)) -> In s c -> changes_by step_ s (change step_ s)) ->
  sum (map (fun step_ => sum (map (change step_) c)) (steps_of_path (first_ :: path))) =
    (winding_number (last path first_) c - winding_number first_ c)%Z.
Proof.
  intros c off_first off_last crosses rule. rewrite <- signed_crossings_add_up by (trivial; apply closed_chain_cycles).
  clear off_first off_last. revert first_ crosses rule.
  induction path as [| b path IH]; intros a crosses rule; [reflexivity |].
  rewrite crossings_of_more.
  change (steps_of_path (a :: b :: path)) with (Segment a b :: steps_of_path (b :: path)) in *.
  cbn [map]. unfold sum at 1. cbn [fold_right].
  fold (sum (map (fun step_ => sum (map (change step_) c)) (steps_of_path (b :: path)))). f_equal.
  - assert (same_ : sum (map (change (Segment a b)) c) = sum (map (signed_crossing_of_step a b) c)).
    { f_equal. apply map_ext_in. intros s S. apply change_is_signed_crossing; [apply rule; [now left | exact S] |].
      intros x on on_s. apply (crosses (Segment a b) s x); [now left | exact S | exact on | exact on_s]. }
    rewrite same_. unfold crossings_of_step.
    destruct (zero_spec (vx b - vx a)) as [X |]; [destruct (zero_spec (vy b - vy a)) as [Y |] |]; cbn [andb]; trivial.
    assert (none : forall s, In s c -> signed_crossing_of_step a b s = 0%Z).
    { intros s S. destruct (Z.eq_dec (signed_crossing_of_step a b s) 0) as [zero_ | some]; [exact zero_ | exfalso].
      destruct (crossing_steps_meet a b s some) as (x & on & on_s).
      destruct (crosses (Segment a b) s x (or_introl eq_refl) S on on_s) as (_ & _ & no). apply no.
      unfold along, cross, minus. cbn [vx vy source target]. rewrite X, Y. ring. }
    rewrite (map_ext_in _ (fun _ => 0%Z) _ none). clear. induction c as [| s l IH]; [reflexivity | exact IH].
  - apply IH; [intros step_ s x I; apply crosses | intros step_ s I; apply rule]; now right.
Qed.
