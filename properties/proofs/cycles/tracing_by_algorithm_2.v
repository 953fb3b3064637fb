(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Tracing all cycles by Algorithm 2, as below Corollary 4.1.9: it is called for each state of the first row and the
   first column, as long as a segment leaves that is not visited, which is twice at most. Segments are marked as soon
   as they are taken (algorithm_2.v). The program here is one of tracing_programs.v, so that its operations are
   counted: 8 for each segment that a call takes, and 8 for each of the two times that a state is looked at.
   All segments are found, since what is left enters each state as often as it leaves it, so that it would meet the
   first row or column (fiber_grid.v). *)
From Coq Require Import Arith Lia Bool List Permutation.
From Oplus Require Import convolution tracing sizes_of_cycles algorithm_2 tracing_programs.
Import ListNotations.

Open Scope nat_scope.

(* P's edge if it is in the convolution and not visited, else Q's: the else branch, which has no test. *)
Definition taken_next (inc_p visited : bool) (at_ : state) : named_segment :=
  if inc_p && negb visited then (OfP, at_) else (OfQ, at_).

(* Algorithm 2, as printed but for marks: it computes inc_q, too, which it does not need. *)
Fixpoint trace_by_algorithm_2 (n m steps : nat) (start at_ : state) : tracing_program (option (list named_segment)) :=
  match steps with
  | 0 => Returned None
  | S rest =>
    followed_by (decided n m (OfP, at_)) (fun inc_p =>
    followed_by (decided n m (OfQ, at_)) (fun inc_q =>
    Marked (OfP, at_) (fun visited =>
      let s := taken_next inc_p visited at_ in
      Written s
        (if state_eq_dec (state_after n m s) start then Returned (Some [s])
         else followed_by (trace_by_algorithm_2 n m rest start (state_after n m s))
                (fun cycle => Returned (option_map (cons s) cycle))))))
  end.

(* One more cycle from this state, if an unvisited segment leaves it. *)
Definition one_more_cycle (n m : nat) (start : state) (cycles : option (list (list named_segment)))
    : tracing_program (option (list (list named_segment))) :=
  followed_by (decided n m (OfP, start)) (fun inc_p =>
  followed_by (decided n m (OfQ, start)) (fun inc_q =>
  Marked (OfP, start) (fun visited_p => Marked (OfQ, start) (fun visited_q =>
    if inc_p && negb visited_p || inc_q && negb visited_q then
      followed_by (trace_by_algorithm_2 n m (2 * n * m) start start) (fun cycle =>
        Returned (match cycle, cycles with Some c, Some others => Some (others ++ [c]) | _, _ => None end))
    else Returned cycles)))).

Fixpoint cycles_from (n m : nat) (at_ : list state) (cycles : option (list (list named_segment)))
    : tracing_program (option (list (list named_segment))) :=
  match at_ with
  | [] => Returned cycles
  | start :: rest => followed_by (one_more_cycle n m start cycles) (cycles_from n m rest)
  end.

Definition tracing_of_all_cycles (n m : nat) : tracing_program (option (list (list named_segment))) :=
  cycles_from n m (flat_map (fun start => [start; start]) (starts n m)) (Some []).

Section all_cycles.

Context (p q : list vector) (p_edges : no_edge_is_a_point p) (q_edges : no_edge_is_a_point q).

Let n := length p.
Let m := length q.
Let belongs := in_convolution p q.
Let run_here {A} (program : tracing_program A) := run (order_of p q) program.

Lemma two_decisions {A} at_ (next_one : bool -> bool -> tracing_program A) marked : in_grid n m at_ ->
  exists k, k <= 6 /\ forall b v l,
    run_here (next_one (belongs (OfP, at_)) (belongs (OfQ, at_))) marked = Run b v l ->
    run_here (followed_by (decided n m (OfP, at_)) (fun inc_p =>
      followed_by (decided n m (OfQ, at_)) (next_one inc_p))) marked = Run b v (k + l).
Proof.
  intros inside_.
  destruct (decided_by_three_comparisons p q (OfP, at_) marked inside_) as (k & few & decided_p).
  destruct (decided_by_three_comparisons p q (OfQ, at_) marked inside_) as (l & few' & decided_q).
  exists (k + l). split; [lia |]. intros b v rest goes_on. rewrite <- Nat.add_assoc.
  eapply run_followed_by; [exact decided_p |]. eapply run_followed_by; [exact decided_q | exact goes_on].
Qed.

(* A call takes the segments that Algorithm 2 takes, by eight operations each. *)
Lemma trace_is_algorithm_2 steps : forall start visited at_ cycle, in_grid n m at_ ->
  algorithm_2 n m belongs steps start visited at_ = Some cycle ->
  exists k, k <= 8 * length cycle /\
    run_here (trace_by_algorithm_2 n m steps start at_) visited = Run (Some cycle) (rev cycle ++ visited) k.
Proof.
  induction steps as [| steps IH]; intros start visited at_ cycle inside_ traced; [discriminate |].
  cbn [algorithm_2 trace_by_algorithm_2] in *.
  destruct (two_decisions at_ (fun inc_p inc_q => Marked (OfP, at_) (fun visited =>
      let s := taken_next inc_p visited at_ in
      Written s
        (if state_eq_dec (state_after n m s) start then Returned (Some [s])
         else followed_by (trace_by_algorithm_2 n m steps start (state_after n m s))
                (fun cycle => Returned (option_map (cons s) cycle))))) visited inside_) as (k & few & begins).
  unfold run_here in begins at 1. cbn [run] in begins.
  change (taken_next (belongs (OfP, at_)) (is_in (OfP, at_) visited) at_) with (chosen belongs visited at_) in begins.
  set (s := chosen belongs visited at_) in *.
  assert (after : in_grid n m (state_after n m s)).
  { apply after_in_grid. unfold s, chosen. destruct (_ && _); exact inside_. }
  revert begins traced. destruct (state_eq_dec (state_after n m s) start) as [_ | _]; intros begins traced.
  - injection traced as <-. exists (k + 2). split; [cbn [length]; lia |]. now apply begins.
  - destruct (algorithm_2 n m belongs steps start (s :: visited) (state_after n m s)) as [others |] eqn:found;
      [| discriminate]. injection traced as <-.
    destruct (IH _ _ _ _ after found) as (l & few' & rest).
    exists (k + S (S (l + 0))). split; [cbn [length]; lia |].
    apply begins. unfold run_here in rest.
    rewrite (run_followed_by _ _ (fun cycle => Returned (option_map (cons s) cycle)) _ _ _ _
      (Some (s :: others)) (rev others ++ s :: visited) 0 rest eq_refl).
    cbn [rev]. now rewrite <- app_assoc.
Qed.

(* Between calls: what is visited are the segments of cycles, none twice. *)
Definition traced_so_far (cycles : list (list named_segment)) (visited : list named_segment) : Prop :=
  Permutation (concat cycles) visited /\ Forall (is_cycle n m) cycles /\
  NoDup visited /\ incl visited (convolution p q) /\ balanced n m (fun s => is_in s visited).

(* How many unvisited segments leave a state. *)
Definition is_unvisited (visited : list named_segment) (s : named_segment) : bool :=
  belongs s && negb (is_in s visited).
Definition segments_from (at_ : state) : list named_segment := map (fun along_ => (along_, at_)) [OfP; OfQ].
Definition unvisited_at (visited : list named_segment) (at_ : state) : nat :=
  count (is_unvisited visited) (segments_from at_).

Lemma is_unvisited_spec visited s : is_unvisited visited s = true <-> belongs s = true /\ ~ In s visited.
Proof. unfold is_unvisited. rewrite andb_true_iff. destruct (is_in_spec s visited); cbn; intuition discriminate. Qed.

Lemma two_segments_leave visited at_ : unvisited_at visited at_ <= 2.
Proof.
  unfold unvisited_at, segments_from, count. cbn [map filter].
  destruct (is_unvisited _ _), (is_unvisited _ _); cbn; lia.
Qed.

Lemma fewer_are_unvisited visited more s : incl visited more ->
  In s more -> is_unvisited visited s = true ->
  unvisited_at more (state_before s) <= unvisited_at visited (state_before s) - 1.
Proof.
  intros sub now_in yes. enough (unvisited_at more (state_before s) < unvisited_at visited (state_before s)) by lia.
  apply (more_with_one_more _ _ _ _ s); [destruct s as [[|] at_]; cbn; tauto | | | exact yes].
  - intros t _ T. apply is_unvisited_spec in T. apply is_unvisited_spec. split; [apply T | intros V; now apply T, sub].
  - destruct (is_unvisited more s) eqn:still; [| reflexivity]. now apply is_unvisited_spec in still.
Qed.

Lemma none_is_unvisited visited at_ : unvisited_at visited at_ = 0 <->
  forall along_, is_unvisited visited (along_, at_) = false.
Proof.
  unfold unvisited_at, count. split.
  - intros none along_. destruct (is_unvisited visited (along_, at_)) eqn:yes; [| reflexivity].
    assert (I : In (along_, at_) (filter (is_unvisited visited) (segments_from at_)))
      by (apply filter_In; split; [destruct along_; cbn; tauto | exact yes]).
    destruct (filter (is_unvisited visited) (segments_from at_)); [destruct I | discriminate].
  - intros none. unfold segments_from. cbn [map filter]. now rewrite !none.
Qed.

Lemma one_more_is_traced start cycles visited :
  in_grid n m start -> traced_so_far cycles visited ->
  exists more now_visited k,
    run_here (one_more_cycle n m start (Some cycles)) visited = Run (Some more) now_visited k /\
    traced_so_far more now_visited /\ incl visited now_visited /\
    unvisited_at now_visited start <= unvisited_at visited start - 1 /\
    k + 8 * length visited <= 8 + 8 * length now_visited.
Proof.
  intros inside_ (together & are_cycles & distinct_ & within_ & even).
  destruct (two_decisions start (fun inc_p inc_q =>
    Marked (OfP, start) (fun visited_p => Marked (OfQ, start) (fun visited_q =>
    if inc_p && negb visited_p || inc_q && negb visited_q then
      followed_by (trace_by_algorithm_2 n m (2 * n * m) start start) (fun cycle =>
        Returned (match cycle, Some cycles with Some c, Some others => Some (others ++ [c]) | _, _ => None end))
    else Returned (Some cycles)))) visited inside_) as (k & few & begins).
  unfold run_here in begins at 1. cbn [run] in begins.
  destruct (belongs (OfP, start) && negb (is_in (OfP, start) visited) ||
            belongs (OfQ, start) && negb (is_in (OfQ, start) visited)) eqn:leaves.
  - assert (some : exists along_, In (along_, start) (convolution p q) /\ ~ In (along_, start) visited).
    { assert (unvisited : exists along_, is_unvisited visited (along_, start) = true)
        by (apply orb_prop in leaves; destruct leaves; [now exists OfP | now exists OfQ]).
      destruct unvisited as (along_ & yes). exists along_. apply is_unvisited_spec in yes. destruct yes as [yes new].
      split; [now apply (in_those n m belongs) | exact new]. }
    destruct inside_ as [I J].
    destruct (algorithm_2_traces_convolution_cycles p q visited start p_edges q_edges distinct_ within_ even I J some)
      as (cycle & traced & nonempty & walk & distinct' & within' & even').
    destruct (trace_is_algorithm_2 _ _ _ _ _ (conj I J) traced) as (l & few' & rest).
    exists (cycles ++ [cycle]), (rev cycle ++ visited), (k + S (S (l + 0))). split; [| split; [| split; [| split]]].
    + apply begins. unfold run_here in rest. now erewrite run_followed_by by (exact rest || reflexivity).
    + repeat split; trivial.
      * rewrite concat_app. cbn [concat]. rewrite app_nil_r, Permutation_app_comm.
        apply Permutation_app; [apply Permutation_rev | exact together].
      * apply Forall_app. split; [exact are_cycles |]. repeat constructor; [exact nonempty | now exists start].
    + apply incl_appr, incl_refl.
    + destruct cycle as [| [along_ from] others]; [contradiction |]. destruct walk as [from_is _].
      cbn in from_is. subst from.
      assert (now_in : In (along_, start) (rev ((along_, start) :: others) ++ visited))
        by (apply in_app_iff; left; apply -> in_rev; now left).
      apply (fewer_are_unvisited _ _ (along_, start)); [apply incl_appr, incl_refl | exact now_in |].
      apply is_unvisited_spec. split; [now apply within', (in_those n m belongs) in now_in |].
      cbn [rev] in distinct'. rewrite <- app_assoc in distinct'. apply NoDup_remove_2 in distinct'.
      intros V. apply distinct', in_app_iff. now right.
    + rewrite app_length, rev_length. lia.
  - exists cycles, visited, (k + 2). split; [now apply begins |]. split; [now repeat split |].
    split; [apply incl_refl |]. split; [| lia].
    apply orb_false_elim in leaves. assert (none : unvisited_at visited start = 0)
      by (apply none_is_unvisited; intros [|]; apply leaves). now rewrite none.
Qed.

Lemma both_are_visited visited at_ along_ :
  unvisited_at visited at_ = 0 -> belongs (along_, at_) = true -> In (along_, at_) visited.
Proof.
  intros none yes. pose proof (proj1 (none_is_unvisited visited at_) none along_) as no. unfold is_unvisited in no.
  rewrite yes in no. now destruct (is_in_spec (along_, at_) visited).
Qed.

Lemma all_are_traced l : forall cycles visited,
  (forall start, In start l -> in_grid n m start) -> traced_so_far cycles visited ->
  exists more now_visited k,
    run_here (cycles_from n m (flat_map (fun start => [start; start]) l) (Some cycles)) visited =
      Run (Some more) now_visited k /\
    traced_so_far more now_visited /\ incl visited now_visited /\
    (forall start along_, In start l -> belongs (along_, start) = true -> In (along_, start) now_visited) /\
    k + 8 * length visited <= 16 * length l + 8 * length now_visited.
Proof.
  induction l as [| start l IH]; intros cycles visited inside_ so_far.
  - exists cycles, visited, 0. repeat split; try apply so_far; [apply incl_refl | intros ? ? [] | cbn; lia].
  - assert (here : in_grid n m start) by (apply inside_; now left).
    destruct (one_more_is_traced start cycles visited here so_far)
      as (some & v1 & k1 & ran1 & so_far1 & sub1 & left1 & cost1).
    destruct (one_more_is_traced start some v1 here so_far1)
      as (more & v2 & k2 & ran2 & so_far2 & sub2 & left2 & cost2).
    destruct (IH more v2 (fun s S => inside_ s (or_intror S)) so_far2)
      as (all & v3 & k3 & ran3 & so_far3 & sub3 & found & cost3).
    exists all, v3, (k1 + (k2 + k3)). split; [| split; [exact so_far3 | split; [| split]]].
    + cbn [flat_map app cycles_from]. eapply run_followed_by; [exact ran1 |]. cbn [cycles_from].
      eapply run_followed_by; [exact ran2 | exact ran3].
    + exact (incl_tran sub1 (incl_tran sub2 sub3)).
    + intros start' along_ [<- | S] yes; [| now apply found]. apply sub3, both_are_visited; [| exact yes].
      pose proof (two_segments_leave visited start). lia.
    + cbn [length]. lia.
Qed.

(* What is not visited goes on at each state. *)
Lemma unvisited_goes_on visited t : incl visited (convolution p q) -> balanced n m (fun s => is_in s visited) ->
  in_grid n m (state_before t) -> is_unvisited visited t = true ->
  exists along_, is_unvisited visited (along_, state_after n m t) = true.
Proof.
  intros within_ even inside_ new.
  pose proof (after_in_grid n m t inside_) as x_inside. pose proof (segment_to_after n m t inside_) as back.
  set (x := state_after n m t) in *.
  destruct (is_unvisited visited (OfP, x)) eqn:P; [now exists OfP |].
  destruct (is_unvisited visited (OfQ, x)) eqn:Q; [now exists OfQ | exfalso].
  pose proof (convolution_is_balanced p q p_edges q_edges x x_inside) as whole. fold n m belongs in whole.
  pose proof (even x x_inside) as part. unfold entering_state, leaving_state in *.
  assert (small : forall s, is_unvisited visited s = false -> Nat.b2n (belongs s) <= Nat.b2n (is_in s visited)).
  { intros s. unfold is_unvisited. destruct (belongs s), (is_in s visited); cbn; discriminate || lia. }
  pose proof (small _ P). pose proof (small _ Q).
  pose proof (b2n_sub n m belongs (segment_to n m OfP x) visited within_).
  pose proof (b2n_sub n m belongs (segment_to n m OfQ x) visited within_).
  assert (here : Nat.b2n (is_in t visited) < Nat.b2n (belongs t)).
  { unfold is_unvisited in new. destruct (belongs t), (is_in t visited); cbn in *; discriminate || lia. }
  rewrite <- back in here. destruct (fst t); lia.
Qed.

(* So if nothing is left at the starts, nothing is left at all. *)
Lemma nothing_is_left visited : 0 < n -> 0 < m ->
  incl visited (convolution p q) -> balanced n m (fun s => is_in s visited) ->
  (forall start along_, In start (starts n m) -> belongs (along_, start) = true -> In (along_, start) visited) ->
  incl (convolution p q) visited.
Proof.
  intros N M within_ even found s I.
  set (unvisited := filter (is_unvisited visited) (all_segments n m)).
  assert (in_unvisited : forall t, In t unvisited <-> in_grid n m (state_before t) /\ is_unvisited visited t = true)
    by (intros t; unfold unvisited; rewrite filter_In, in_all_segments; reflexivity).
  destruct (is_in_spec s visited) as [V | V]; [exact V | exfalso].
  apply (in_those n m belongs) in I. destruct I as [inside_ yes].
  destruct (what_is_left_meets_the_first_row_or_column n m unvisited) as (along_ & i & j & L & first_).
  - intros along_ at_ L. apply in_unvisited in L. apply L.
  - intros along_ at_ L. apply in_unvisited in L. destruct L as [inside_' new].
    destruct (unvisited_goes_on visited (along_, at_) within_ even inside_' new) as (on & new').
    exists on. apply in_unvisited. split; [| exact new']. exact (after_in_grid n m (along_, at_) inside_').
  - intros none. assert (left_ : In s unvisited)
      by (apply in_unvisited; split; [exact inside_ | apply is_unvisited_spec; split; [exact yes | exact V]]).
    rewrite none in left_. exact left_.
  - apply in_unvisited in L. destruct L as [[I' J'] new]. apply is_unvisited_spec in new. destruct new as [yes' new].
    apply new, found; [| exact yes']. cbn in I', J'.
    unfold starts. apply in_app_iff. rewrite !in_map_iff. destruct (Nat.eq_dec j 0) as [-> | ?].
    + left. exists i. split; [reflexivity |]. apply in_seq. lia.
    + right. exists j. assert (i = 0) as -> by lia. split; [reflexivity |]. apply in_seq. lia.
Qed.

(* Theorem. Tracing by Algorithm 2 finds the cycles, each segment in one of them, by 16 operations for each of n + m - 1
   states and 8 for each segment. *)
Theorem tracing_finds_all_cycles : p <> [] -> q <> [] ->
  exists cycles written_ k,
    run (order_of p q) (tracing_of_all_cycles n m) [] = Run (Some cycles) written_ k /\
    Forall (is_cycle n m) cycles /\ Permutation (concat cycles) (convolution p q) /\
    k <= 16 * (n + m - 1) + 8 * length (convolution p q).
Proof.
  intros some_p some_q.
  assert (N : 0 < n) by (unfold n; destruct p; [contradiction | cbn; lia]).
  assert (M : 0 < m) by (unfold m; destruct q; [contradiction | cbn; lia]).
  destruct (all_are_traced (starts n m) [] []) as (cycles & visited & k & ran & so_far & _ & found & cost).
  - intros [i j] I. apply in_app_iff in I. rewrite !in_map_iff in I. unfold in_grid.
    destruct I as [(l & [= <- <-] & I) | (l & [= <- <-] & I)]; apply in_seq in I; cbn; lia.
  - split; [constructor |]. split; [constructor |]. split; [constructor |].
    split; [intros ? [] | intros ? _; reflexivity].
  - destruct so_far as (together & are_cycles & distinct_ & within_ & even).
    assert (all : Permutation visited (convolution p q)).
    { apply NoDup_Permutation; [exact distinct_ | apply (those_NoDup n m belongs) |].
      intros s. split; [apply within_ |]. now apply nothing_is_left. }
    exists cycles, visited, k. split; [exact ran |]. split; [exact are_cycles |]. split; [now rewrite together |].
    pose proof (Permutation_length all) as size. unfold starts in cost.
    rewrite app_length, !map_length, !seq_length in cost. cbn [length] in cost. unfold named_segment, state in *. lia.
Qed.

End all_cycles.
