(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Programs that trace cycles, and what they cost. Such a program knows of the two chains how many vertices they have;
   all else it learns from comparisons of the directions of two edges, and it may ask whether it has marked a segment.
   It writes segments, which marks them. Each of these three is one operation: directions are compared by a bounded
   number of operations on coordinates, marks are kept in an array, one for each segment that may be. Between two
   operations it adds one to indices and compares them, a bounded number of times.
   So time is counted up to a factor, and a program that writes K segments costs K or more. *)
From Coq Require Import Lia Bool List.
From Oplus Require Import convolution tracing.
Import ListNotations.

Open Scope nat_scope.

(* Edge i of P or of Q. *)
Definition named_edge : Set := summand * nat.

Inductive tracing_program (A : Type) : Type :=
| Returned (a : A)
| Compared (d e : named_edge) (go_on : comparison -> tracing_program A)
| Marked (s : named_segment) (go_on : bool -> tracing_program A)
| Written (s : named_segment) (go_on : tracing_program A).
Arguments Returned {A}.
Arguments Compared {A}.
Arguments Marked {A}.
Arguments Written {A}.

(* What a run returns, which segments are written and marked then, the last one first, and how many operations that
   took. *)
Record run_of (A : Type) := Run { answer : A; written : list named_segment; operation_count : nat }.
Arguments Run {A}.
Arguments answer {A}.
Arguments written {A}.
Arguments operation_count {A}.

Definition once_more {A} (r : run_of A) : run_of A := Run (answer r) (written r) (S (operation_count r)).

(* A run, given how directions of edges compare and which segments are marked at first. *)
Fixpoint run {A} (order : named_edge -> named_edge -> comparison) (program : tracing_program A)
    (marked : list named_segment) : run_of A :=
  match program with
  | Returned a => Run a marked 0
  | Compared d e go_on => once_more (run order (go_on (order d e)) marked)
  | Marked s go_on => once_more (run order (go_on (is_in s marked)) marked)
  | Written s go_on => once_more (run order go_on (s :: marked))
  end.

(* One program, and then another one that is given what the first returned. *)
Fixpoint followed_by {A B} (program : tracing_program A) (next_one : A -> tracing_program B) : tracing_program B :=
  match program with
  | Returned a => next_one a
  | Compared d e go_on => Compared d e (fun c => followed_by (go_on c) next_one)
  | Marked s go_on => Marked s (fun yes => followed_by (go_on yes) next_one)
  | Written s go_on => Written s (followed_by go_on next_one)
  end.

Lemma run_both {A B} order (program : tracing_program A) (next_one : A -> tracing_program B) : forall marked,
  let first_run := run order program marked in
  let rest := run order (next_one (answer first_run)) (written first_run) in
  run order (followed_by program next_one) marked =
    Run (answer rest) (written rest) (operation_count first_run + operation_count rest).
Proof.
  induction program as [a | d e go_on IH | s go_on IH | s go_on IH]; intros marked;
    cbn [run followed_by once_more answer written operation_count].
  - now destruct (run order (next_one a) marked).
  - now rewrite IH.
  - now rewrite IH.
  - now rewrite IH.
Qed.

Lemma run_followed_by {A B} order (program : tracing_program A) (next_one : A -> tracing_program B) marked a w k b v l :
  run order program marked = Run a w k -> run order (next_one a) w = Run b v l ->
  run order (followed_by program next_one) marked = Run b v (k + l).
Proof.
  intros ran goes_on. pose proof (run_both order program next_one marked) as both. cbv zeta in both.
  rewrite ran in both. cbn [answer written operation_count] in both. now rewrite goes_on in both.
Qed.

(* CCW(d, from, to), as direction.v has it, by at most three comparisons. *)
Definition is_ccw_between (d from to : named_edge) : tracing_program bool :=
  let is_less c := match c with Lt => true | _ => false end in
  Compared from to (fun c =>
    match c with
    | Eq => Returned false
    | Lt => Compared from d (fun c =>
        if is_less c then Compared d to (fun c => Returned (is_less c)) else Returned false)
    | Gt => Compared from d (fun c =>
        if is_less c then Returned true else Compared d to (fun c => Returned (is_less c)))
    end).

(* Whether a segment is in the convolution: inc_p and inc_q of Algorithm 2. *)
Definition decided (n m : nat) (s : named_segment) : tracing_program bool :=
  let '(along_, (i, j)) := s in
  match along_ with
  | OfP => is_ccw_between (OfP, i) (OfQ, previous m j) (OfQ, j)
  | OfQ => is_ccw_between (OfQ, j) (OfP, previous n i) (OfP, i)
  end.

(* How the directions of edges of these two chains compare. *)
Definition direction_of_edge (p q : list vector) (e : named_edge) : direction :=
  Direction (match fst e with OfP => edge_of_chain p (snd e) | OfQ => edge_of_chain q (snd e) end) (fst e).
Definition order_of (p q : list vector) (d e : named_edge) : comparison :=
  compare (direction_of_edge p q d) (direction_of_edge p q e).

Lemma ccw_by_three_comparisons (p q : list vector) (d from to : named_edge) marked :
  exists k, k <= 3 /\ run (order_of p q) (is_ccw_between d from to) marked =
    Run (ccw (direction_of_edge p q d) (direction_of_edge p q from) (direction_of_edge p q to)) marked k.
Proof.
  unfold is_ccw_between, order_of, ccw, before. cbn [run].
  destruct (compare (direction_of_edge p q from) (direction_of_edge p q to)); cbn [run].
  - exists 1. split; [lia | reflexivity].
  - destruct (compare (direction_of_edge p q from) (direction_of_edge p q d)); cbn [run];
      [exists 2 | exists 3 | exists 2]; (split; [lia | reflexivity]).
  - destruct (compare (direction_of_edge p q from) (direction_of_edge p q d)); cbn [run];
      [exists 3 | exists 2 | exists 3]; (split; [lia | reflexivity]).
Qed.

(* Lemma. A segment is decided on by three comparisons or fewer. *)
Lemma decided_by_three_comparisons (p q : list vector) (s : named_segment) marked :
  in_grid (length p) (length q) (state_before s) ->
  exists k, k <= 3 /\ run (order_of p q) (decided (length p) (length q) s) marked = Run (in_convolution p q s) marked k.
Proof.
  destruct s as [along_ [i j]]. intros [I J]. cbn [state_before fst snd] in I, J.
  unfold in_convolution, is_convolution_segment, in_tangent_set. cbn [fst snd of].
  destruct along_; cbn [decided]; [rewrite (corner_is q j J) | rewrite (corner_is p i I)];
    apply ccw_by_three_comparisons.
Qed.

(* Theorem. A program costs no less than what it writes. *)
Theorem writing_costs {A} order (program : tracing_program A) : forall marked,
  length (written (run order program marked)) <= length marked + operation_count (run order program marked).
Proof.
  induction program as [a | d e go_on IH | s go_on IH | s go_on IH]; intros marked;
    cbn [run once_more written operation_count].
  - lia.
  - specialize (IH (order d e) marked). lia.
  - specialize (IH (is_in s marked) marked). lia.
  - specialize (IH (s :: marked)). cbn [length] in IH. lia.
Qed.
