(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Algorithm 2 as printed, where nothing is marked while a cycle is traced: it need not end. *)
From Coq Require Import QArith List.
From Oplus Require Import convolution tracing algorithm_2.
Import ListNotations.

Open Scope nat_scope.

(* As printed: only what earlier activations took counts as visited. *)
Fixpoint algorithm_2_as_printed (n m : nat) (belongs : named_segment -> bool) (steps : nat)
    (start : state) (visited : list named_segment) (at_ : state) : option (list named_segment) :=
  match steps with
  | 0 => None
  | S rest =>
    let s := chosen belongs visited at_ in
    let next_state := state_after n m s in
    if state_eq_dec next_state start then Some [s]
    else option_map (cons s)
           (algorithm_2_as_printed n m belongs rest start visited next_state)
  end.

Definition triangle : list vector := [Vector 0 0; Vector 1 0; Vector 0 1].
Definition quadrangle : list vector := [Vector 0 0; Vector 1 2; Vector 3 3; Vector 0 3].

(* The counterexample to Algorithm 2 as printed: from state (0, 0), which a segment of the convolution
   leaves, nothing visited, it does not return, however many steps it is given. *)
Theorem algorithm_2_as_printed_need_not_end :
  In (chosen (in_convolution triangle quadrangle) [] (0, 0)) (convolution triangle quadrangle) /\
  forall steps,
    algorithm_2_as_printed 3 4 (in_convolution triangle quadrangle) steps (0, 0) [] (0, 0) = None.
Proof.
  split; [vm_compute; tauto |]. intros steps.
  set (go := fun at_ => state_after 3 4 (chosen (in_convolution triangle quadrangle) [] at_)).
  assert (round : forall at_, In at_ [(0, 0); (1, 0); (1, 1); (2, 1); (0, 1)] ->
            In (go at_) [(1, 0); (1, 1); (2, 1); (0, 1)]).
  { intros at_ I. cbn [In] in I. destruct I as [<- | [<- | [<- | [<- | [<- | []]]]]];
      vm_compute; tauto. }
  assert (ever : forall steps at_, In at_ [(0, 0); (1, 0); (1, 1); (2, 1); (0, 1)] ->
            algorithm_2_as_printed 3 4 (in_convolution triangle quadrangle) steps (0, 0) [] at_ = None).
  { clear steps. induction steps as [| steps IH]; intros at_ I; [reflexivity |].
    cbn [algorithm_2_as_printed]. fold (go at_). specialize (round at_ I).
    destruct (state_eq_dec (go at_) (0, 0)) as [e | _].
    - rewrite e in round. cbn in round. intuition discriminate.
    - rewrite IH; [reflexivity | now right]. }
  apply ever. now left.
Qed.
