(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Walks that turn clockwise most (walks.v), along segments that have nothing but ends in common and a set on their left
   only: each goes around one face of what is not in the set. So what closed chains of these segments do on the right of
   a walk is the same all along. Proof: clockwise most, the next ray at a vertex is a segment that leaves, since one
   that enters has the set where the last one has not; it follows one segment only; so each walk takes what follows. *)
From Coq Require Import QArith Lqa ZArith Lia Bool List Permutation.
From Oplus Require Import regions_and_sums beside_a_piece filling kept_pieces_go_round walks beside_a_vertex.
Import ListNotations.

Open Scope Q_scope.

Lemma is_met_between_by_turns (b g u : vector) : nonzero b -> nonzero g -> nonzero u -> turned_to b u < 4 ->
  (is_met_between b g u = true -> turned_to b u < turned_to b g) /\
  (turned_to b g < 4 -> turned_to b u < turned_to b g -> is_met_between b g u = true).
Proof.
  intros B G U short_. pose proof (full_turn b). pose proof (turned_range b g B G). pose proof (turned_range b u B U).
  pose proof (left_by_turns b b g B B G) as b_g. pose proof (left_by_turns b b u B B U) as b_u.
  pose proof (left_by_turns b u g B U G) as u_g. clear B G U.
  assert (flip : forall x y, cross x y == - cross y x) by (intros; unfold cross; ring).
  rewrite (flip b g) in b_g. rewrite (flip b u) in b_u. rewrite (flip u g) in u_g. unfold is_met_between. clear flip.
  destruct (negative_spec (cross g b)), (negative_spec (cross u b)), (negative_spec (cross g u)); cbn;
    split; intros; try discriminate; try reflexivity; try lra.
Qed.

Section Walks.
  Variable segments : list segment.
  Hypothesis parts : share_ends_only segments.
  Hypothesis closed : cycles segments.
  Hypothesis right_is_outside : forall e, In e segments -> winding_number_shifted (right_of_middle e) segments = 0%Z.
  Hypothesis left_is_inside : forall e, In e segments ->
    winding_number_shifted (right_of_middle (reversed e)) segments <> 0%Z.

  (* What follows a segment clockwise most. *)
  Definition following (e : segment) : segment := next_ray segments (reversed e).

  Lemma back (e : segment) : In e segments -> directed segments (reversed e).
  Proof. intros E. apply directed_reversed. now left. Qed.

  Lemma same_on_both (part : list segment) (e : segment) : incl part segments -> cycles part -> In e segments ->
    winding_number_shifted (right_of_middle e) part = winding_number_shifted (right_of_middle (following e)) part.
  Proof.
    intros incl_ cycles_ E. rewrite <- (reversed_twice e) at 1.
    apply (left_of_a_ray segments parts (fun x => winding_number x part)
      (fun s => winding_number_shifted (right_of_middle s) part)); [| | now apply back].
    - intros a b free. apply (winding_number_along (Segment a b) part cycles_). intros w on t T.
      apply (free w on t), incl_, T.
    - intros s w n S. apply to_the_right_of_a_piece; [exact cycles_ | | now apply (directed_is_long segments)].
      now apply (met_by_itself_only segments parts).
  Qed.

  Lemma following_is (e : segment) : In e segments -> In (following e) segments /\ source (following e) = target e.
  Proof.
    intros E. destruct (next_ray_is segments _ (back e E)) as ([F | entering] & starts & _); [now split | exfalso].
    apply (left_is_inside _ entering). rewrite reversed_twice. fold (following e).
    rewrite <- (same_on_both segments e (incl_refl _) closed E). now apply right_is_outside.
  Qed.

  Lemma following_differs (e f : segment) : In e segments -> In f segments -> following e = following f -> e = f.
  Proof.
    intros E F same. destruct (following_is e E) as [_ ends_], (following_is f F) as [_ ends_'].
    rewrite <- (reversed_twice e), <- (reversed_twice f). apply (f_equal reversed).
    apply (next_rays_differ segments parts _ _ (back e E) (back f F)); [cbn [reversed source]; congruence | exact same].
  Qed.

  (* It is chosen before all others. *)
  Lemma chosen_first (e g : segment) : In e segments -> In g segments -> source g = target e -> g <> following e ->
    turns_more e (following e) g = true /\ turns_more e g (following e) = false.
  Proof.
    intros E G starts other. destruct (following_is e E) as [F starts_f]. set (f := following e) in *.
    destruct (next_ray_is segments _ (back e E)) as (_ & _ & first_). fold (following e) f in first_.
    specialize (first_ g (or_introl G) starts).
    pose proof (directed_is_long segments parts _ (back e E)) as b_long.
    pose proof (are_long _ parts f F) as f_long. pose proof (are_long _ parts g G) as g_long.
    assert (f_g : ~ turned_to (along (reversed e)) (along f) == turned_to (along (reversed e)) (along g)).
    { intros same%same_turn; trivial. revert same. apply (rays_differ segments parts);
        [now left | now left | congruence ..]. }
    assert (no_g : ~ turned_to (along (reversed e)) (along g) == turned_to (along (reversed e)) (along (reversed e))).
    { intros same%same_turn; trivial. revert same. apply (rays_differ segments parts); [now left | now apply back | |];
        [exact starts | now apply (not_turned segments parts)]. }
    rewrite full_turn in no_g. pose proof (turned_range _ _ b_long g_long).
    unfold turns_more. rewrite negb_true_iff, negb_false_iff.
    change (minus (source e) (target e)) with (along (reversed e)).
    destruct (is_met_between_by_turns _ _ _ b_long f_long g_long ltac:(lra)) as [no _].
    destruct (is_met_between_by_turns _ _ _ b_long g_long f_long ltac:(lra)) as [_ yes].
    split; [| apply yes; lra]. destruct (is_met_between _ _ _); [| reflexivity]. specialize (no eq_refl). lra.
  Qed.

  Lemma next_follows (e : segment) (l : list segment) : In e segments -> incl l segments -> In (following e) l ->
    exists others, next_and_others e l = Some (following e, others).
  Proof.
    intros E. destruct (following_is e E) as [F starts].
    induction l as [| g l IH]; intros part I; [destruct I |].
    assert (part_l : incl l segments) by (intros s S; apply part; now right). cbn [next_and_others].
    destruct (segment_dec g (following e)) as [-> | other].
    - destruct (vector_dec (source (following e)) (target e)); [| contradiction].
      destruct (next_and_others e l) as [[h others] |] eqn:rest; [| now exists l].
      apply next_is in rest. destruct rest as [starts_h permuted]. cbn [andb].
      destruct (segment_dec h (following e)) as [-> | other]; [destruct (turns_more e _ _); eexists; reflexivity |].
      destruct (chosen_first e h E) as [-> _]; trivial; [| now exists l]. apply part_l, (Permutation_in _ permuted).
      now left.
    - destruct I as [-> | I]; [contradiction |]. destruct (IH part_l I) as (others & ->).
      destruct (vector_dec (source g) (target e)) as [starts_g |]; [| now exists (g :: others)]. cbn [andb].
      destruct (chosen_first e g E) as [_ ->]; trivial; [apply part; now left | now exists (g :: others)].
  Qed.

  (* What holds of a segment, and with each of what follows it, holds all along a walk. *)
  Definition is_carried (holds : segment -> Prop) : Prop := forall e, In e segments -> holds e -> holds (following e).

  Definition is_whole (l : list segment) : Prop := forall e, In e l -> In (following e) l.

  Lemma walk_takes_what_follows (fuel : nat) (first : segment) : In first segments -> forall before l,
    (length l <= fuel)%nat -> In before segments -> incl l segments -> NoDup l -> ~ In before l -> ~ In first l ->
    (forall e, e = before \/ In e l -> following e = first \/ In (following e) l) ->
    let (chain, others) := walk fuel first before l in
    path (source before :: chain) (source first) = before :: path chain (source first) /\
    (forall holds, is_carried holds -> holds before -> forall e, In e (path chain (source first)) -> holds e) /\
    incl others l /\ NoDup others /\ is_whole others.
  Proof.
    intros First. assert (stop : forall before l, In before segments -> incl l segments -> NoDup l -> ~ In before l ->
      (forall e, e = before \/ In e l -> following e = first \/ In (following e) l) -> following before = first ->
      path [source before] (source first) = before :: path [] (source first) /\
      (forall holds, is_carried holds -> holds before -> forall e, In e (path [] (source first)) -> holds e) /\
      incl l l /\ NoDup l /\ is_whole l).
    { intros before l B part distinct_ new all next_. split.
      { cbn [path hd]. rewrite <- next_, (proj2 (following_is before B)). now destruct before. }
      split; [intros holds _ _ e [] |]. split; [apply incl_refl |].
      split; [exact distinct_ |]. intros e E. destruct (all e (or_intror E)) as [is_first |]; [| assumption].
      exfalso. apply new. rewrite (following_differs before e); auto. congruence. }
    induction fuel as [| fuel IH]; intros before l few B part distinct_ new new_first all;
      pose proof (all before (or_introl eq_refl)) as which; destruct (following_is before B) as [F starts].
    - destruct l; [| cbn in few; lia]. cbn [walk]. destruct which as [is_first | []]. now apply (stop before).
    - cbn [walk]. destruct (segment_dec (following before) first) as [is_first | other].
      + destruct (next_and_others before l) as [[e rest] |] eqn:chosen; [| now apply (stop before)].
        apply next_is in chosen. destruct chosen as [starts_e permuted].
        assert (I : In e l) by (apply (Permutation_in _ permuted); now left).
        destruct (vector_dec (target before) (source first)) as [| no]; [| destruct no; congruence].
        destruct (chosen_first before e B (part e I) starts_e) as [yes _]; [congruence |].
        rewrite is_first in yes. rewrite yes. now apply (stop before).
      + destruct which as [| I]; [contradiction |]. destruct (next_follows before l B part I) as (rest & chosen).
        rewrite chosen. apply next_is in chosen. destruct chosen as [_ permuted]. set (f := following before) in *.
        assert (closes : (if vector_dec (target before) (source first) then turns_more before first f else false) =
          false).
        { destruct (vector_dec (target before) (source first)) as [ends_ |]; [| reflexivity].
          apply (chosen_first before first B First); [now symmetry | now apply not_eq_sym]. }
        rewrite closes. pose proof (Permutation_NoDup (Permutation_sym permuted) distinct_) as both.
        inversion both as [| ? ? new_f distinct_rest]; subst.
        assert (rest_in : forall e, In e rest -> In e l) by (intros e R; apply (Permutation_in _ permuted); now right).
        specialize (IH f rest). destruct (walk fuel first f rest) as [chain others].
        destruct IH as (path_is_ & linked_ & incl_ & more).
        * apply Permutation_length in permuted. cbn in permuted. lia.
        * exact F.
        * intros e R. now apply part, rest_in.
        * exact distinct_rest.
        * exact new_f.
        * intros R. now apply new_first, rest_in.
        * intros e which. assert (in_l : In e l) by (destruct which as [-> | R]; auto).
          destruct (all e (or_intror in_l)) as [| G]; [now left |].
          apply (Permutation_in _ (Permutation_sym permuted)) in G. destruct G as [same | G]; [| now right].
          exfalso. apply new. rewrite (following_differs before e); auto.
        * assert (is_before : Segment (source before) (source f) = before) by (rewrite starts; now destruct before).
          split; [| rewrite path_is_; split; [| split; [intros e R; now apply rest_in, incl_ | exact more]]].
          -- exact (f_equal (fun b => b :: path (source f :: chain) (source first)) is_before).
          -- intros holds carried_ holds_ e [<- | I']; [| apply (linked_ holds carried_); trivial]; now apply carried_.
  Qed.

  Lemma carried_along_chains (fuel : nat) : forall l, incl l segments -> NoDup l -> is_whole l ->
    forall chain, In chain (chains_of fuel l) ->
    exists first, forall holds, is_carried holds -> holds first -> forall f, In f (edges chain) -> holds f.
  Proof.
    induction fuel as [| fuel IH]; intros l part distinct_ whole chain C; [destruct C |].
    destruct l as [| e l]; [destruct C |]. cbn [chains_of] in C. inversion distinct_ as [| ? ? new distinct_l]; subst.
    assert (E : In e segments) by (apply part; now left).
    pose proof (walk_takes_what_follows (length l) e E e l (le_n _) E (fun s S => part s (or_intror S)) distinct_l
      new new) as taken. destruct (walk (length l) e e l) as [vertices others].
    destruct taken as (path_is_ & all & incl_ & distinct_others & whole_others).
    { intros a which. destruct (whole a) as [is_e | I]; [destruct which as [-> |]; cbn; tauto | now left | now right]. }
    destruct C as [<- | C].
    - exists e. intros holds carried_ holds_. rewrite edges_are_a_path, path_is_.
      intros f [<- | F]; [exact holds_ | now apply (all holds)].
    - apply (IH others); trivial. intros s S. apply part. right. now apply incl_.
  Qed.

  (* Theorem. On the right of a chain closed chains of the segments have one winding number. *)
  Theorem same_on_the_right (part : list segment) (chain : list vector) (e f : segment) :
    In chain (chains_of (length segments) segments) -> incl part segments -> cycles part ->
    In e (edges chain) -> In f (edges chain) ->
    winding_number_shifted (right_of_middle e) part = winding_number_shifted (right_of_middle f) part.
  Proof.
    intros C incl_ cycles_ E F. destruct (carried_along_chains (length segments) segments (incl_refl _)
      (are_distinct _ parts) (fun a A => proj1 (following_is a A)) chain C) as (first & all).
    set (holds := fun e => winding_number_shifted (right_of_middle e) part =
      winding_number_shifted (right_of_middle first) part).
    assert (carried_ : is_carried holds).
    { intros a A same. unfold holds. rewrite <- same. symmetry. exact (same_on_both part a incl_ cycles_ A). }
    transitivity (winding_number_shifted (right_of_middle first) part); [| symmetry].
    - exact (all holds carried_ eq_refl e E).
    - exact (all holds carried_ eq_refl f F).
  Qed.
End Walks.
