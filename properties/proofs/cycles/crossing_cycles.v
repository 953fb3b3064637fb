(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Which rows and columns the traced cycles of two closed chains cross. *)
From Coq Require Import Lia Bool List Permutation Arith.
From Oplus Require Import convolution tracing convolution_cycles.
Import ListNotations.

Open Scope nat_scope.

Lemma walks_are_steps : forall n m walked a b, is_walk n m a walked b ->
  arrived n m a (map fst walked) = b /\ passed n m a (map fst walked) = map state_before walked.
Proof.
  intros n m walked. induction walked as [| [along s] rest IH]; intros a b W; cbn in *.
  - auto.
  - destruct W as [<- W]. destruct (IH _ _ W) as [A P]. unfold state_after in *. cbn in *.
    rewrite A, P. auto.
Qed.

Lemma cycles_are_closed_walks : forall n m cycle,
  is_cycle n m cycle -> (forall s, In s cycle -> in_grid n m (state_before s)) ->
  exists start, closed_walk n m start (map fst cycle) /\
                passed n m start (map fst cycle) = map state_before cycle.
Proof.
  intros n m cycle [N (start & W)] G. exists start.
  destruct (walks_are_steps n m cycle start start W) as [A P]. split; [| exact P].
  destruct cycle as [| s rest]; [contradiction |].
  destruct W as [<- _]. destruct (G s (or_introl eq_refl)) as [I J].
  repeat split; trivial. discriminate.
Qed.

Lemma in_the_convolution : forall p q s, In s (convolution p q) ->
  in_grid (length p) (length q) (state_before s) /\ in_convolution p q s = true.
Proof. intros p q s I. exact (proj1 (in_those (length p) (length q) (in_convolution p q) s) I). Qed.

Lemma traced_in_grid : forall p q cycles cycle s,
  no_edge_is_a_point p -> no_edge_is_a_point q -> p <> [] -> q <> [] ->
  trace_cycles (length p) (length q) (in_convolution p q) = Some cycles ->
  In cycle cycles -> is_cycle (length p) (length q) cycle /\
                     (In s cycle -> In s (convolution p q)).
Proof.
  intros p q cycles cycle s P Q PN QN T I.
  destruct (cycles_cover_the_convolution p q P Q PN QN) as (others & E & C & M).
  rewrite T in E. injection E as <-. split.
  - rewrite Forall_forall in C. now apply C.
  - intros J. apply (Permutation_in s M). apply in_concat. eauto.
Qed.

(* Theorem. Each cycle that is traced of two closed chains passes every vertex of P, or every vertex of Q;
   and it takes a whole multiple of n_P edges of P, and a whole multiple of n_Q edges of Q. *)
Theorem traced_cycles_cross_the_grid : forall p q cycles cycle,
  no_edge_is_a_point p -> no_edge_is_a_point q -> p <> [] -> q <> [] ->
  trace_cycles (length p) (length q) (in_convolution p q) = Some cycles -> In cycle cycles ->
  ((forall i, i < length p -> exists s, In s cycle /\ fst (state_before s) = i) \/
   (forall j, j < length q -> exists s, In s cycle /\ snd (state_before s) = j)) /\
  (exists a b, steps_of_p (map fst cycle) = a * length p /\ steps_of_q (map fst cycle) = b * length q /\
               length cycle = a * length p + b * length q).
Proof.
  intros p q cycles cycle P Q PN QN T I.
  pose proof (fun s => traced_in_grid p q cycles cycle s P Q PN QN T I) as G.
  destruct (cycles_are_closed_walks (length p) (length q) cycle) as (start & W & A).
  - apply (G (OfP, (0, 0))).
  - intros s J. apply (in_the_convolution p q s). now apply G.
  - split.
    + destruct (closed_walks_cross_the_grid _ _ _ _ W) as [C | C]; [left | right].
      * intros i L. destruct (C i L) as (j & J). rewrite A in J. apply in_map_iff in J.
        destruct J as (s & E & J). exists s. rewrite E. auto.
      * intros j L. destruct (C j L) as (i & J). rewrite A in J. apply in_map_iff in J.
        destruct J as (s & E & J). exists s. rewrite E. auto.
    + destruct (closed_walks_go_round _ _ _ _ W) as ((a & E) & (b & F) & L). exists a, b.
      rewrite map_length, E, F in L. auto.
Qed.
