(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Algorithm 2 as checked/cycles/cycle_tracing.cpp has it, on any set of segments of a fiber grid that is
   entered at each state as often as it is left. *)
From Coq Require Import Lia Bool List Permutation Arith.
From Oplus Require Import convolution orbit.
Import ListNotations.

Open Scope nat_scope.

Definition segment_eq_dec (s t : named_segment) : {s = t} + {s <> t}.
Proof. repeat decide equality. Defined.

Definition is_in (s : named_segment) (l : list named_segment) : bool :=
  if in_dec segment_eq_dec s l then true else false.

(* Where a cycle goes on that entered a state along this summand's edge: along the same summand if
   possible, else along the other one, without a test. *)
Definition summand_after (belongs : named_segment -> bool) (came_by : summand) (at_ : state) : summand :=
  if belongs (came_by, at_) then came_by else other came_by.

Definition segment_after (n m : nat) (belongs : named_segment -> bool) (s : named_segment)
    : named_segment :=
  let at_ := state_after n m s in (summand_after belongs (fst s) at_, at_).

(* The segments of a cycle from s on, until it is at its start; None if that takes more than `steps`. *)
Fixpoint trace (n m : nat) (belongs : named_segment -> bool) (steps : nat) (start : state)
    (s : named_segment) : option (list named_segment) :=
  match steps with
  | 0 => None
  | S rest =>
    if state_eq_dec (state_after n m s) start then Some [s]
    else option_map (cons s) (trace n m belongs rest start (segment_after n m belongs s))
  end.

(* Traces a cycle if this segment, which leaves a starting state, belongs and has not been visited. *)
Definition start_along (n m : nat) (belongs : named_segment -> bool)
    (cycles : option (list (list named_segment))) (s : named_segment)
    : option (list (list named_segment)) :=
  match cycles with
  | None => None
  | Some cycles =>
    if belongs s && negb (is_in s (concat cycles)) then
      option_map (fun cycle => cycles ++ [cycle])
        (trace n m belongs (2 * n * m) (state_before s) s)
    else Some cycles
  end.

(* The first row, then what remains of the first column. *)
Definition starts (n m : nat) : list state :=
  map (fun i => (i, 0)) (seq 0 n) ++ map (fun j => (0, j)) (seq 1 (m - 1)).

Definition start_at (n m : nat) (belongs : named_segment -> bool)
    (cycles : option (list (list named_segment))) (start : state) :=
  start_along n m belongs (start_along n m belongs cycles (OfP, start)) (OfQ, start).

Definition trace_cycles (n m : nat) (belongs : named_segment -> bool)
    : option (list (list named_segment)) :=
  fold_left (start_at n m belongs) (starts n m) (Some []).

Section traced.

Context (n m : nat) (belongs : named_segment -> bool) (is_balanced : balanced n m belongs).

Let all : list named_segment := those n m belongs.
Let follow : named_segment -> named_segment := segment_after n m belongs.

Lemma in_those s : In s (those n m belongs) <-> in_grid n m (state_before s) /\ belongs s = true.
Proof. unfold those. now rewrite filter_In, in_all_segments. Qed.

Lemma those_NoDup : NoDup (those n m belongs).
Proof. apply NoDup_filter, all_segments_NoDup. Qed.

Lemma those_length : length (those n m belongs) <= 2 * n * m.
Proof.
  transitivity (length (all_segments n m)).
  - apply NoDup_incl_length; [apply those_NoDup |]. intros s I. now apply filter_In in I.
  - unfold all_segments, states, state.
    pose proof (prod_length [OfP; OfQ] (list_prod (seq 0 n) (seq 0 m))) as e.
    rewrite (prod_length (seq 0 n) (seq 0 m)), !seq_length in e.
    etransitivity; [exact (Nat.eq_le_incl _ _ e) | cbn [length]; lia].
Qed.

(* The next segment belongs too: the else branch, which has no test, is right (Lemma 4.1.3). *)
Lemma segment_after_in s : In s all -> In (follow s) all.
Proof.
  unfold all. rewrite !in_those. intros [g b]. unfold follow, segment_after, summand_after.
  pose proof (after_in_grid n m s g) as g'. split; [exact g' |].
  pose proof (is_balanced _ g') as e. unfold entering_state, leaving_state in e.
  pose proof (segment_to_after n m s g) as back.
  destruct (fst s); rewrite back, b in e; cbn [other];
    destruct (belongs (OfP, state_after n m s)) eqn:p, (belongs (OfQ, state_after n m s)) eqn:q;
    cbn in e; try lia; trivial.
Qed.

(* Two ways into a state go on along two ways out of it. *)
Lemma segment_after_injective s t : In s all -> In t all -> follow s = follow t -> s = t.
Proof.
  unfold all. rewrite !in_those. intros [g b] [g' b']. unfold follow, segment_after.
  intros e. injection e as summands ends.
  pose proof (segment_to_after n m s g) as back. pose proof (segment_to_after n m t g') as back'.
  rewrite <- ends in back', summands.
  pose proof (is_balanced _ (after_in_grid n m s g)) as d. unfold entering_state, leaving_state in d.
  unfold summand_after in summands.
  destruct (fst s), (fst t); try congruence; rewrite back, back', b, b' in d; exfalso;
    destruct (belongs (OfP, state_after n m s)), (belongs (OfQ, state_after n m s));
    cbn in d; try lia; discriminate summands.
Qed.

Lemma segment_after_self_injection : self_injection follow all.
Proof. split; [apply those_NoDup |]. split; [apply segment_after_in | apply segment_after_injective]. Qed.

Lemma trace_is_first_of_orbit start k : forall steps s,
  k < steps -> state_after n m (iterated follow k s) = start ->
  (forall j, j < k -> state_after n m (iterated follow j s) <> start) ->
  trace n m belongs steps start s = Some (first_of_orbit follow (S k) s).
Proof.
  induction k as [| k IH]; intros [| steps] s K e apart; try lia; cbn [trace].
  - now destruct (state_eq_dec (state_after n m s) start).
  - destruct (state_eq_dec (state_after n m s) start) as [e' | _].
    { exfalso. apply (apart 0); [lia | exact e']. }
    fold (follow s). rewrite first_of_orbit_cons, IH; trivial; [lia | |].
    + now rewrite iterated_once_more.
    + intros j J. rewrite iterated_once_more. apply apart. lia.
Qed.

(* Every trace ends, and within as many steps as there are segments. *)
Lemma trace_ends s :
  In s all ->
  exists k, trace n m belongs (2 * n * m) (state_before s) s = Some (first_of_orbit follow (S k) s) /\
            state_after n m (iterated follow k s) = state_before s /\
            (forall j, j < k -> state_after n m (iterated follow j s) <> state_before s).
Proof.
  intros I.
  destruct (orbit_returns segment_eq_dec follow all s segment_after_self_injection I) as (r & R & e).
  destruct (first_within (fun k => state_after n m (iterated follow k s) = state_before s)
              (fun k => state_eq_dec _ _) r) as [(k & K & ends & apart) | none].
  - exists k. repeat split; trivial. apply trace_is_first_of_orbit; trivial.
    pose proof those_length. fold all in H. lia.
  - exfalso. apply (none (r - 1)); [lia |].
    replace r with (S (r - 1)) in e by lia. cbn [iterated] in e. rewrite <- e at 2. reflexivity.
Qed.

(* The segments of a walk from one state to another. *)
Fixpoint is_walk (a : state) (walked : list named_segment) (b : state) : Prop :=
  match walked with
  | [] => a = b
  | s :: rest => state_before s = a /\ is_walk (state_after n m s) rest b
  end.

Definition is_cycle (cycle : list named_segment) : Prop :=
  cycle <> [] /\ exists start, is_walk start cycle start.

Lemma orbit_is_walk k : forall s,
  is_walk (state_before s) (first_of_orbit follow (S k) s) (state_after n m (iterated follow k s)).
Proof.
  induction k as [| k IH]; intros s.
  - now cbn.
  - rewrite first_of_orbit_cons. split; [reflexivity |].
    rewrite <- iterated_once_more. exact (IH (follow s)).
Qed.

(* What has been visited while cycles from `start` are traced: but for the segments that lead to
   `start`, a segment has been visited if and only if the one after it has. *)
Definition closed_but_at (start : state) (visited : list named_segment) : Prop :=
  NoDup visited /\ incl visited all /\
  (forall t, In t visited -> state_after n m t <> start -> In (follow t) visited) /\
  (forall t, In t all -> state_after n m t <> start -> In (follow t) visited -> In t visited).

Lemma trace_keeps_closed s visited k :
  In s all -> ~ In s visited -> closed_but_at (state_before s) visited ->
  state_after n m (iterated follow k s) = state_before s ->
  (forall j, j < k -> state_after n m (iterated follow j s) <> state_before s) ->
  closed_but_at (state_before s) (visited ++ first_of_orbit follow (S k) s).
Proof.
  intros I unvisited (distinct & within & forward & backward) ends apart.
  pose proof segment_after_self_injection as inj.
  assert (fresh : forall j, j <= k -> ~ In (iterated follow j s) visited).
  { induction j as [| j IH]; intros J; [exact unvisited |]. intros V. apply IH; [lia |].
    apply backward; trivial; [now apply iterated_in | apply apart; lia]. }
  repeat split.
  - apply NoDup_of_two; trivial.
    + apply (first_of_orbit_NoDup follow all); trivial. intros [| i] i_range e; [lia |].
      apply (apart i); [lia |]. rewrite <- e at 2. reflexivity.
    + intros t V J. apply in_first_of_orbit in J. destruct J as (i & i_range & ->).
      now apply (fresh i); [lia |].
  - intros t J. apply in_app_iff in J. destruct J as [J | J]; [now apply within |].
    apply in_first_of_orbit in J. destruct J as (i & _ & ->). now apply iterated_in.
  - intros t J away. apply in_app_iff in J. apply in_app_iff. destruct J as [J | J].
    + left. now apply forward.
    + right. apply in_first_of_orbit in J. destruct J as (i & i_range & ->).
      apply in_first_of_orbit. exists (S i). split; [| reflexivity].
      destruct (Nat.eq_dec i k) as [-> | ?]; [contradiction | lia].
  - intros t J away V. apply in_app_iff in V. apply in_app_iff. destruct V as [V | V].
    + left. now apply backward.
    + right. apply in_first_of_orbit in V. destruct V as ([| i] & i_range & e).
      * exfalso. apply away. cbn [iterated] in e. rewrite <- e. reflexivity.
      * apply in_first_of_orbit. exists i. split; [lia |].
        apply segment_after_injective; trivial. now apply iterated_in.
Qed.

Lemma is_in_spec s l : reflect (In s l) (is_in s l).
Proof. unfold is_in. destruct (in_dec segment_eq_dec s l); now constructor. Qed.

Lemma start_along_spec s cycles :
  in_grid n m (state_before s) -> closed_but_at (state_before s) (concat cycles) ->
  Forall is_cycle cycles ->
  exists more, start_along n m belongs (Some cycles) s = Some more /\
    closed_but_at (state_before s) (concat more) /\ Forall is_cycle more /\
    incl (concat cycles) (concat more) /\ (belongs s = true -> In s (concat more)).
Proof.
  intros g closed good. unfold start_along.
  destruct (belongs s) eqn:b; cbn [andb].
  - destruct (is_in_spec s (concat cycles)) as [V | V]; cbn [negb].
    + exists cycles. repeat split; try apply closed; trivial. apply incl_refl.
    + assert (I : In s all) by (now apply in_those).
      destruct (trace_ends s I) as (k & -> & ends & apart). cbn [option_map].
      eexists. split; [reflexivity |]. rewrite concat_app. cbn [concat]. rewrite app_nil_r.
      split; [now apply trace_keeps_closed |]. repeat split.
      * apply Forall_app. split; trivial. constructor; [| constructor]. split.
        -- now rewrite first_of_orbit_cons.
        -- exists (state_before s). rewrite <- ends at 2. apply orbit_is_walk.
      * apply incl_appl, incl_refl.
      * intros _. apply in_app_iff. right. rewrite first_of_orbit_cons. now left.
  - exists cycles. repeat split; try apply closed; trivial; [apply incl_refl | discriminate].
Qed.

(* Between starts: a segment has been visited if and only if the one after it has. *)
Definition closed_under_follow (visited : list named_segment) : Prop :=
  NoDup visited /\ incl visited all /\
  (forall t, In t all -> In (follow t) visited <-> In t visited).

Lemma start_at_spec start cycles :
  in_grid n m start -> closed_under_follow (concat cycles) -> Forall is_cycle cycles ->
  exists more, start_at n m belongs (Some cycles) start = Some more /\
    closed_under_follow (concat more) /\ Forall is_cycle more /\
    incl (concat cycles) (concat more) /\
    (forall along, belongs (along, start) = true -> In (along, start) (concat more)).
Proof.
  intros g (distinct & within & closed) good. unfold start_at.
  destruct (start_along_spec (OfP, start) cycles) as (some & -> & closed' & good' & sub & has_p);
    trivial.
  { repeat split; trivial; intros t I; [intros _; apply closed; auto | intros _; now apply closed]. }
  destruct (start_along_spec (OfQ, start) some) as (more & -> & closed'' & good'' & sub' & has_q);
    trivial.
  destruct closed'' as (distinct'' & within'' & forward & backward).
  assert (has : forall along, belongs (along, start) = true -> In (along, start) (concat more))
    by (intros [|] b; auto).
  assert (ahead : forall t, In t (concat more) -> In (follow t) (concat more)).
  { intros t I. destruct (state_eq_dec (state_after n m t) start) as [e | away]; [| now apply forward].
    pose proof (segment_after_in t (within'' t I)) as J. apply in_those in J. destruct J as [_ J].
    unfold follow, segment_after in *. rewrite e in *. now apply has. }
  exists more. repeat split; trivial; try (intros I'; now apply ahead).
  - intros V.
    assert (permuted : Permutation (map follow (concat more)) (concat more)).
    { apply injective_permutes; trivial. intros a b A B. apply segment_after_injective; auto. }
    apply (Permutation_in _ (Permutation_sym permuted)) in V. apply in_map_iff in V.
    destruct V as (u & e & U). rewrite <- (segment_after_injective u t); auto.
  - eapply incl_tran; eassumption.
Qed.

Lemma all_starts_spec l : forall cycles,
  (forall start, In start l -> in_grid n m start) ->
  closed_under_follow (concat cycles) -> Forall is_cycle cycles ->
  exists more, fold_left (start_at n m belongs) l (Some cycles) = Some more /\
    closed_under_follow (concat more) /\ Forall is_cycle more /\
    incl (concat cycles) (concat more) /\
    (forall along start, In start l -> belongs (along, start) = true ->
       In (along, start) (concat more)).
Proof.
  induction l as [| start l IH]; intros cycles g closed good.
  - exists cycles. repeat split; try apply closed; trivial; [apply incl_refl | intros ? ? []].
  - destruct (start_at_spec start cycles) as (some & e & closed' & good' & sub & has); trivial;
      [apply g; now left |].
    destruct (IH some) as (more & e' & closed'' & good'' & sub' & has'); trivial;
      [intros; apply g; now right |].
    exists more. cbn [fold_left]. rewrite e.
    repeat split; try apply closed''; trivial; [eapply incl_tran; eassumption |].
    intros along start' [<- | I] b; [apply sub'; now apply has | now apply has'].
Qed.

(* Starting from the first row and the first column, all traces end, each is a closed walk, and together
   they are all the segments, each once. *)
Theorem cycles_are_traced :
  0 < n -> 0 < m ->
  exists cycles, trace_cycles n m belongs = Some cycles /\ Forall is_cycle cycles /\
                 Permutation (concat cycles) (those n m belongs).
Proof.
  intros pn pm.
  destruct (all_starts_spec (starts n m) []) as (cycles & e & (distinct & within & closed) & good & _ & has).
  - intros [i j] I. apply in_app_iff in I. rewrite !in_map_iff in I. unfold in_grid.
    destruct I as [(k & [= <- <-] & I) | (k & [= <- <-] & I)]; apply in_seq in I; cbn; lia.
  - repeat split; [constructor | intros ? [] | intros [] | intros []].
  - constructor.
  - exists cycles. repeat split; trivial. apply NoDup_Permutation; [trivial | apply those_NoDup |].
    intros s. split; [apply within |]. intros I.
    set (left := filter (fun t => negb (is_in t (concat cycles))) all).
    assert (in_left : forall t, In t left <-> In t all /\ ~ In t (concat cycles)).
    { intros t. unfold left. rewrite filter_In. destruct (is_in_spec t (concat cycles)); intuition auto with *. }
    destruct (is_in_spec s (concat cycles)) as [V | V]; [exact V | exfalso].
    destruct (what_is_left_meets_the_first_row_or_column n m left) as (along & i & j & L & first).
    + intros along at_ L. apply in_left in L. destruct L as [L _]. now apply in_those in L.
    + intros along at_ L. apply in_left in L. destruct L as [L N].
      exists (fst (follow (along, at_))). apply in_left.
      split; [exact (segment_after_in _ L) |]. intros K. apply N. now apply closed.
    + intros none. assert (In s left) as K by (now apply in_left). rewrite none in K. exact K.
    + apply in_left in L. destruct L as [L N]. apply N. apply in_those in L. destruct L as [[gi gj] b].
      cbn [fst snd state_before] in gi, gj. apply has; [| exact b]. unfold starts. apply in_app_iff.
      rewrite !in_map_iff. destruct (Nat.eq_dec j 0) as [-> | ?].
      * left. exists i. split; [reflexivity |]. apply in_seq. lia.
      * right. exists j. assert (i = 0) as -> by lia. split; [reflexivity |]. apply in_seq. lia.
Qed.

End traced.
