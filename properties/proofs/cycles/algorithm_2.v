(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Algorithm 2 of the thesis, segments marked as soon as they are taken: where two unvisited
   segments leave a state, either may be taken. As printed nothing is marked within a cycle:
   algorithm_2_goes_round.v. *)
From Coq Require Import Lia Bool List Permutation Arith.
From Oplus Require Import convolution tracing.
Import ListNotations.

Open Scope nat_scope.

(* P's edge, if it is in the convolution and not visited; else Q's, without a test. *)
Definition chosen (belongs : named_segment -> bool) (visited : list named_segment) (at_ : state)
    : named_segment :=
  if belongs (OfP, at_) && negb (is_in (OfP, at_) visited) then (OfP, at_) else (OfQ, at_).

Fixpoint algorithm_2 (n m : nat) (belongs : named_segment -> bool) (steps : nat) (start : state)
    (visited : list named_segment) (at_ : state) : option (list named_segment) :=
  match steps with
  | 0 => None
  | S rest =>
    let s := chosen belongs visited at_ in
    let next_state := state_after n m s in
    if state_eq_dec next_state start then Some [s]
    else option_map (cons s) (algorithm_2 n m belongs rest start (s :: visited) next_state)
  end.

Definition is_state (a b : state) : nat := if state_eq_dec a b then 1 else 0.

Section algorithm.

Context (n m : nat) (belongs : named_segment -> bool) (is_balanced : balanced n m belongs).

(* Visited so far: segments that belong, none twice; each state is entered as often as left, but for the
   two ends of the walk that is under way. *)
Definition under_way (start at_ : state) (visited : list named_segment) : Prop :=
  NoDup visited /\ incl visited (those n m belongs) /\
  forall x, in_grid n m x ->
    entering_state n m (fun s => is_in s visited) x + is_state x start =
    leaving_state (fun s => is_in s visited) x + is_state x at_.

Lemma is_in_cons s t visited :
  ~ In s visited ->
  Nat.b2n (is_in t (s :: visited)) =
  Nat.b2n (is_in t visited) + (if segment_eq_dec t s then 1 else 0).
Proof.
  intros N. destruct (is_in_spec t (s :: visited)) as [I | I], (is_in_spec t visited) as [J | J],
    (segment_eq_dec t s) as [e | e]; cbn; trivial; exfalso; cbn in I; subst; intuition congruence.
Qed.

(* Taking an unvisited segment from where the walk is. *)
Lemma one_step start at_ visited s :
  in_grid n m at_ -> under_way start at_ visited ->
  state_before s = at_ -> In s (those n m belongs) -> ~ In s visited ->
  under_way start (state_after n m s) (s :: visited).
Proof.
  intros g (distinct & within & counted) from I N. repeat split.
  - now constructor.
  - intros t [<- | J]; [exact I | now apply within].
  - intros x gx. specialize (counted x gx).
    unfold entering_state, leaving_state in *. cbv beta in *. rewrite !is_in_cons by assumption.
    destruct s as [along here]. cbn in from. subst here.
    unfold is_state in *.
    assert (leaves : (if segment_eq_dec (OfP, x) (along, at_) then 1 else 0) +
                     (if segment_eq_dec (OfQ, x) (along, at_) then 1 else 0) =
                     (if state_eq_dec x at_ then 1 else 0)).
    { destruct (segment_eq_dec (OfP, x) (along, at_)), (segment_eq_dec (OfQ, x) (along, at_)),
        (state_eq_dec x at_); trivial; destruct along; congruence. }
    assert (enters : (if segment_eq_dec (segment_to n m OfP x) (along, at_) then 1 else 0) +
                     (if segment_eq_dec (segment_to n m OfQ x) (along, at_) then 1 else 0) =
                     (if state_eq_dec x (state_after n m (along, at_)) then 1 else 0)).
    { assert (to_is : forall a, segment_to n m a x = (along, at_) <->
                a = along /\ x = state_after n m (along, at_)).
      { intros a. split.
        - intros e. split; [destruct a; now injection e |].
          rewrite <- e. symmetry. now apply after_segment_to.
        - intros [-> ->]. exact (segment_to_after n m (along, at_) g). }
      destruct (segment_eq_dec (segment_to n m OfP x) (along, at_)) as [e | e],
        (segment_eq_dec (segment_to n m OfQ x) (along, at_)) as [f | f],
        (state_eq_dec x (state_after n m (along, at_))) as [h | h]; trivial; exfalso;
        rewrite ?to_is in *; destruct along; intuition congruence. }
    unfold named_segment, state in *. lia.
Qed.

Lemma b2n_sub (s : named_segment) visited :
  incl visited (those n m belongs) -> Nat.b2n (is_in s visited) <= Nat.b2n (belongs s).
Proof.
  intros within. destruct (is_in_spec s visited) as [I | I]; [| cbn; lia].
  apply within, in_those in I. destruct I as [_ ->]. reflexivity.
Qed.

(* Away from its start the walk finds an unvisited segment to go on, and if that is not P's, it is Q's. *)
Lemma chosen_is_right start at_ visited :
  in_grid n m at_ -> under_way start at_ visited -> at_ <> start ->
  In (chosen belongs visited at_) (those n m belongs) /\ ~ In (chosen belongs visited at_) visited.
Proof.
  intros g (distinct & within & counted) away. specialize (counted at_ g).
  unfold is_state in counted. destruct (state_eq_dec at_ start); [contradiction |].
  destruct (state_eq_dec at_ at_); [| contradiction].
  pose proof (is_balanced at_ g) as b. unfold entering_state, leaving_state in *.
  pose proof (b2n_sub (segment_to n m OfP at_) visited within).
  pose proof (b2n_sub (segment_to n m OfQ at_) visited within).
  pose proof (b2n_sub (OfP, at_) visited within). pose proof (b2n_sub (OfQ, at_) visited within).
  unfold chosen.
  destruct (belongs (OfP, at_)) eqn:p, (is_in (OfP, at_) visited) eqn:vp; cbn [andb negb];
    destruct (belongs (OfQ, at_)) eqn:q, (is_in (OfQ, at_) visited) eqn:vq; cbn in *; try lia;
    (split; [now apply in_those |]);
    try (intros I; destruct (is_in_spec (OfP, at_) visited); congruence);
    (intros I; destruct (is_in_spec (OfQ, at_) visited); congruence).
Qed.

Lemma algorithm_2_goes_on steps : forall start at_ visited,
  in_grid n m at_ -> under_way start at_ visited ->
  In (chosen belongs visited at_) (those n m belongs) -> ~ In (chosen belongs visited at_) visited ->
  length (those n m belongs) <= steps + length visited ->
  exists cycle,
    algorithm_2 n m belongs steps start visited at_ = Some cycle /\ cycle <> [] /\
    is_walk n m at_ cycle start /\ under_way start start (rev cycle ++ visited).
Proof.
  induction steps as [| steps IH]; intros start at_ visited g way I N enough.
  - exfalso. destruct way as (distinct & within & _).
    assert (NoDup (chosen belongs visited at_ :: visited)) as longer by now constructor.
    apply NoDup_incl_length with (l' := those n m belongs) in longer; [cbn [length Nat.add] in *; lia |].
    intros t [<- | J]; [exact I | now apply within].
  - cbn [algorithm_2]. set (s := chosen belongs visited at_) in *.
    assert (from : state_before s = at_) by (unfold s, chosen; now destruct (_ && _)).
    pose proof (one_step start at_ visited s g way from I N) as way'.
    assert (g' : in_grid n m (state_after n m s)) by (apply after_in_grid; now rewrite from).
    destruct (state_eq_dec (state_after n m s) start) as [e | away].
    + exists [s]. rewrite e in way'.
      split; [reflexivity | split; [discriminate | split; [split; [exact from | exact e] | exact way']]].
    + destruct (chosen_is_right _ _ _ g' way' away) as [I' N'].
      destruct (IH start _ _ g' way' I' N') as (cycle & -> & _ & walk & way'').
      { cbn [length]. lia. }
      exists (s :: cycle). cbn [rev]. rewrite <- app_assoc.
      split; [reflexivity | split; [discriminate | split; [split; [exact from | exact walk] | exact way'']]].
Qed.

(* Theorem 4.1.6. What earlier activations visited enters each state as often as it leaves it. From a state
   that an unvisited segment of the convolution leaves, Algorithm 2 takes unvisited segments of the
   convolution only, each from where the one before it led, and is back after finitely many steps. What
   is visited then enters each state as often as it leaves it again, so it can be called once more. *)
Theorem algorithm_2_traces_a_cycle (visited : list named_segment) (start : state) :
  NoDup visited -> incl visited (those n m belongs) ->
  balanced n m (fun s => is_in s visited) ->
  in_grid n m start ->
  (exists along, belongs (along, start) = true /\ ~ In (along, start) visited) ->
  exists cycle,
    algorithm_2 n m belongs (2 * n * m) start visited start = Some cycle /\ cycle <> [] /\
    is_walk n m start cycle start /\
    NoDup (rev cycle ++ visited) /\ incl (rev cycle ++ visited) (those n m belongs) /\
    balanced n m (fun s => is_in s (rev cycle ++ visited)).
Proof.
  intros distinct within closed g (along & b & N).
  assert (way : under_way start start visited).
  { repeat split; trivial. intros x gx. rewrite (closed x gx). reflexivity. }
  assert (right : In (chosen belongs visited start) (those n m belongs) /\
                  ~ In (chosen belongs visited start) visited).
  { unfold chosen. destruct (belongs (OfP, start)) eqn:p; cbn [andb].
    - destruct (is_in_spec (OfP, start) visited) as [I | I]; cbn [negb].
      + destruct along; [contradiction |]. split; [now apply in_those | exact N].
      + split; [now apply in_those | exact I].
    - destruct along; [congruence |]. split; [now apply in_those | exact N]. }
  destruct right as [I N'].
  destruct (algorithm_2_goes_on (2 * n * m) start start visited g way I N')
    as (cycle & e & nonempty & walk & distinct' & within' & counted).
  { pose proof (those_length n m belongs). lia. }
  exists cycle. repeat split; trivial. intros x gx. specialize (counted x gx). lia.
Qed.

End algorithm.

(* Theorem 4.1.6 for two closed chains: Algorithm 2, segments marked as soon as they are taken. *)
Theorem algorithm_2_traces_convolution_cycles (p q : list vector) (visited : list named_segment)
    (start : state) :
  no_edge_is_a_point p -> no_edge_is_a_point q ->
  let n := length p in
  let m := length q in
  NoDup visited -> incl visited (convolution p q) -> balanced n m (fun s => is_in s visited) ->
  fst start < n -> snd start < m ->
  (exists along, In (along, start) (convolution p q) /\ ~ In (along, start) visited) ->
  exists cycle,
    algorithm_2 n m (in_convolution p q) (2 * n * m) start visited start = Some cycle /\
    cycle <> [] /\ is_walk n m start cycle start /\
    NoDup (rev cycle ++ visited) /\ incl (rev cycle ++ visited) (convolution p q) /\
    balanced n m (fun s => is_in s (rev cycle ++ visited)).
Proof.
  intros ep eq n m distinct within closed i_range j_range (along & I & N).
  apply (algorithm_2_traces_a_cycle n m _ (convolution_is_balanced p q ep eq)); trivial.
  - now split.
  - exists along. split; [| exact N]. now apply (in_those n m (in_convolution p q)) in I.
Qed.
