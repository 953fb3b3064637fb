(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Tracing that counts the states it looks at, as checked/cycles/cycle_tracing.cpp does: it traces the same
   cycles, and its counter ends at `states_looked_at` (Theorem 4.1.10). *)
From Coq Require Import Arith Lia Bool List.
From Oplus Require Import convolution tracing convolution_cycles.
Import ListNotations.

Open Scope nat_scope.

Section counted.

Context (n m : nat) (belongs : named_segment -> bool).

(* `trace`, which looks at each state where it asks how to go on. *)
Fixpoint trace_counting (steps : nat) (start : state) (s : named_segment) (looked : nat)
    : option (list named_segment * nat) :=
  match steps with
  | 0 => None
  | S rest =>
    if state_eq_dec (state_after n m s) start then Some ([s], looked)
    else option_map (fun traced => (s :: fst traced, snd traced))
           (trace_counting rest start (segment_after n m belongs s) (S looked))
  end.

Definition start_along_counting (so_far : option (list (list named_segment) * nat)) (s : named_segment)
    : option (list (list named_segment) * nat) :=
  match so_far with
  | None => None
  | Some (cycles, looked) =>
    if belongs s && negb (is_in s (concat cycles)) then
      option_map (fun traced => (cycles ++ [fst traced], snd traced))
        (trace_counting (2 * n * m) (state_before s) s looked)
    else Some (cycles, looked)
  end.

(* It looks at each start, too. *)
Definition start_at_counting (so_far : option (list (list named_segment) * nat)) (start : state) :=
  start_along_counting
    (start_along_counting (option_map (fun t => (fst t, S (snd t))) so_far) (OfP, start)) (OfQ, start).

Definition trace_cycles_counting : option (list (list named_segment) * nat) :=
  fold_left start_at_counting (starts n m) (Some ([], 0)).

Lemma trace_counting_spec steps : forall start s looked,
  trace_counting steps start s looked =
  option_map (fun cycle => (cycle, looked + (length cycle - 1))) (trace n m belongs steps start s) /\
  trace n m belongs steps start s <> Some [].
Proof.
  induction steps as [| rest IH]; intros start s looked; cbn [trace_counting trace].
  { now split. }
  destruct (state_eq_dec (state_after n m s) start) as [_ | _].
  { cbn. rewrite Nat.add_0_r. now split. }
  destruct (IH start (segment_after n m belongs s) (S looked)) as [-> nonempty].
  destruct (trace n m belongs rest start (segment_after n m belongs s)) as [[| t cycle] |];
    cbn; [now destruct nonempty | | now split].
  split; [| discriminate]. repeat f_equal. lia.
Qed.

(* How many states are looked at while these cycles are traced, starts not counted. *)
Definition looked_between (cycles : list (list named_segment)) : nat :=
  list_sum (map (fun cycle => length cycle - 1) cycles).

Definition with_states_looked_at (starts_so_far : nat) (cycles : list (list named_segment)) :=
  (cycles, starts_so_far + looked_between cycles).

Lemma start_along_counting_spec k cycles s :
  start_along_counting (option_map (with_states_looked_at k) cycles) s =
  option_map (with_states_looked_at k) (start_along n m belongs cycles s).
Proof.
  destruct cycles as [cycles |]; [| reflexivity]. cbn [option_map start_along].
  unfold with_states_looked_at at 1, start_along_counting.
  destruct (belongs s && negb (is_in s (concat cycles))); [| reflexivity].
  destruct (trace_counting_spec (2 * n * m) (state_before s) s (k + looked_between cycles)) as [-> _].
  destruct (trace n m belongs (2 * n * m) (state_before s) s) as [cycle |]; [| reflexivity].
  cbn [option_map fst snd]. unfold with_states_looked_at, looked_between. rewrite map_app, list_sum_app.
  unfold list_sum. cbn [map fold_right]. do 2 f_equal. lia.
Qed.

Lemma starts_counting_spec l : forall k cycles,
  fold_left start_at_counting l (option_map (with_states_looked_at k) cycles) =
  option_map (with_states_looked_at (k + length l)) (fold_left (start_at n m belongs) l cycles).
Proof.
  induction l as [| start l IH]; intros k cycles; cbn [fold_left length].
  { now rewrite Nat.add_0_r. }
  rewrite Nat.add_succ_r. change (S (k + length l)) with (S k + length l). rewrite <- IH. f_equal.
  unfold start_at_counting, start_at.
  rewrite <- !start_along_counting_spec. f_equal. f_equal. now destruct cycles.
Qed.

(* Theorem. Tracing with a counter traces the same cycles, and the counter ends at `states_looked_at`. *)
Theorem states_are_counted :
  trace_cycles_counting =
  option_map (fun cycles => (cycles, states_looked_at n m cycles)) (trace_cycles n m belongs).
Proof. exact (starts_counting_spec (starts n m) 0 (Some [])). Qed.

End counted.
