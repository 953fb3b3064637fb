(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Corollary 4.1.9 as corrected: some cycle goes round both chains. *)
From Coq Require Import PeanoNat ZArith Lia Bool List Permutation.
From Oplus Require Import numbers convolution tracing convolution_cycles crossing_cycles rows_and_columns regions
  first_hit.
Import ListNotations.

Open Scope Q_scope.

(* What is met on a turn to the left, by less than half a circle, is on one side of a line. *)
Lemma between_on_one_side : forall e s u v,
  nonzero e -> nonzero u -> nonzero v -> (0 < cross u v)%Q ->
  ccw (Direction e s) (Direction u (other s)) (Direction v (other s)) = true ->
  0 < cross (minus u v) e.
Proof.
  intros e s u v D U V G I. rewrite crossed_to_the_left in I by assumption.
  assert (F : forall w, cross w e == - cross e w) by (intros; unfold cross; ring).
  assert (0 <= cross u e /\ 0 <= cross e v) as [A B].
  { unfold left_of_ray in I. destruct s;
      [ destruct (negative_spec (cross e u)), (negative_spec (cross e v))
      | destruct (negative_spec (cross u e)), (negative_spec (cross v e)) ];
      cbn in I; try discriminate; rewrite ?F in *; split; try lra; apply Qnot_lt_le; lra. }
  setoid_replace (cross (minus u v) e) with (cross u e + cross e v) by (unfold cross, minus; cbn; ring).
  destruct (Qlt_le_dec 0 (cross u e + cross e v)) as [|L]; [assumption | exfalso].
  assert (P : cross u e == 0) by lra. assert (Q : cross e v == 0) by lra. apply D.
  split; apply (Qmult_inj_l _ _ (cross u v)); try lra; unfold cross in *; by_equations.
Qed.

(* So is the tangent set of a vertex that is not reflex, and so is the complement of that of a reflex one. *)
Lemma tangents_on_one_side : forall d c,
  proper d -> turns (incoming c) (outgoing c) -> is_reflex c = false -> in_tangent_set d c = true ->
  0 < cross (minus (incoming c) (outgoing c)) (vec d).
Proof.
  intros [e s] [u v] D T R I. pose proof T as (U & V & _). cbn in U, V, T, R |- *.
  apply (between_on_one_side e s); trivial.
  pose proof (in_tangent_set_by_sweep (Direction e s) (Corner u v) D T) as S.
  unfold sweep, is_reflex in *. cbn in S, R. unfold negative in R, S.
  compared_numbers (cross u v ?= 0); try discriminate; [| assumption].
  rewrite I in S. discriminate.
Qed.

Lemma missing_on_one_side : forall d c,
  proper d -> turns (incoming c) (outgoing c) -> is_reflex c = true -> in_tangent_set d c = false ->
  0 < cross (minus (outgoing c) (incoming c)) (vec d).
Proof.
  intros [e s] [u v] D T R I. pose proof T as (U & V & _). cbn in U, V, T, R |- *.
  pose proof (in_tangent_set_by_sweep (Direction e s) (Corner u v) D T) as S.
  unfold sweep, is_reflex in *. cbn in S, R. unfold negative in R, S.
  compared_numbers (cross u v ?= 0); try discriminate. rewrite I in S.
  assert (0 < cross v u) by (unfold cross in *; lra).
  apply (between_on_one_side e s); trivial.
  destruct (ccw (Direction e s) (Direction v (other s)) (Direction u (other s))); [reflexivity | discriminate].
Qed.

Open Scope nat_scope.

(* The edge that leaves the vertex that is furthest in a direction does not go there: so not all edges are on one open
   side of a line. *)
Lemma edges_on_no_side : forall p w, p <> [] -> exists i, i < length p /\ ~ (0 < cross w (edge_of_chain p i))%Q.
Proof.
  intros p w N. destruct (least_of (fun v => - cross w v)%Q p N) as (v & I & least).
  apply (In_nth p v nowhere) in I. destruct I as (i & I & <-). exists i. split; [exact I |].
  specialize (least _ (nth_In p nowhere (next_in_range i (length p) I))). rewrite edge_of_chain_is by exact I.
  unfold cross, minus in *. cbn [vx vy]. lra.
Qed.

Lemma corners_turn : forall q j, turns_everywhere q -> j < length q ->
  turns (incoming (corner_of_chain q j)) (outgoing (corner_of_chain q j)).
Proof. intros q j T L. apply T. apply nth_In. now rewrite corners_length. Qed.

(* A walk along P alone stays in its row. *)
Lemma walks_along_p_stay : forall n m walked a b, is_walk n m a walked b ->
  (forall s, In s walked -> fst s = OfP) -> forall s, In s walked -> snd (state_before s) = snd a.
Proof.
  intros n m walked. induction walked as [| [along t] rest IH]; intros a b W A s I; [destruct I |].
  destruct W as [<- W]. destruct I as [<- | I]; [reflexivity |].
  rewrite (IH _ _ W (fun s J => A s (or_intror J)) s I).
  pose proof (A _ (or_introl eq_refl)) as E. cbn in E. subst along. reflexivity.
Qed.

Lemma no_steps_of_q : forall cycle : list named_segment,
  steps_of_q (map fst cycle) = 0 -> forall s, In s cycle -> fst s = OfP.
Proof.
  intros cycle. unfold steps_of_q. induction cycle as [| [[|] t] rest IH]; cbn; intros E s I.
  - destruct I.
  - destruct I as [<- | I]; [reflexivity | now apply IH].
  - discriminate.
Qed.

Lemma more_of_them : forall A (f g : A -> bool) l, count g l < count f l ->
  exists a, In a l /\ f a = true /\ g a = false.
Proof.
  intros A f g l. unfold count. induction l as [| a rest IH]; intros L; cbn in L; [lia |].
  destruct (f a) eqn:F, (g a) eqn:G; cbn in L;
    try (destruct IH as (b & I & B); [lia |]; exists b; split; [now right | exact B]).
  exists a. split; [now left | auto].
Qed.

Lemma more_with_one_more : forall A (f g : A -> bool) l a, In a l ->
  (forall b, In b l -> f b = true -> g b = true) -> f a = false -> g a = true -> count f l < count g l.
Proof.
  intros A f g l a I S F G. apply in_split in I. destruct I as (l1 & l2 & ->).
  assert (M : forall l, (forall b, In b l -> f b = true -> g b = true) -> count f l <= count g l).
  { clear. unfold count. intros l S. induction l as [| b rest IH]; [reflexivity |].
    specialize (IH (fun c J => S c (or_intror J))). specialize (S b (or_introl eq_refl)).
    cbn. destruct (f b), (g b); cbn; try lia; now discriminate S. }
  rewrite !count_of_two.
  assert (count f (a :: l2) < count g (a :: l2)).
  { unfold count. cbn. rewrite F, G. cbn.
    pose proof (M l2 (fun b J => S b (in_or_app l1 (a :: l2) b (or_intror (in_cons a b l2 J))))) as L.
    unfold count in L. lia. }
  pose proof (M l1 (fun b J => S b (in_or_app l1 (a :: l2) b (or_introl J)))). lia.
Qed.

Lemma all_or_one : forall (f : nat -> bool) l, (forall a, In a l -> f a = true) \/ exists a, In a l /\ f a = false.
Proof.
  intros f l. induction l as [| a rest [IH | (b & I & F)]];
    [left; intros a [] | | right; exists b; split; [now right | exact F]].
  destruct (f a) eqn:F; [left; intros b [<- | I]; auto | right; exists a; split; [now left | exact F]].
Qed.

Lemma row_of_reflex_vertices : forall q,
  count (fun j => is_reflex (corner_of_chain q j)) (seq 0 (length q)) = reflex_vertices q.
Proof. intros q. unfold reflex_vertices, corner_of_chain. apply count_of_nth. apply corners_length. Qed.

(* From the first column some convolution segment leads to the next one in a row in which not all do. *)
Lemma some_row_has_a_gap : forall p q,
  turns_everywhere p -> turns_everywhere q -> p <> [] ->
  outer q \/ hole q ->
  exists j i, j < length q /\ i < length p /\
    is_convolution_segment p q OfP 0 j = true /\ is_convolution_segment p q OfP i j = false.
Proof.
  intros p q P Q PN T.
  assert (0 < length p) as LP by (destruct p; [contradiction | cbn; lia]).
  set (row := seq 0 (length q)).
  destruct (all_or_one (fun j => negb (is_convolution_segment p q OfP 0 j) ||
      forallb (fun i => is_convolution_segment p q OfP i j) (seq 0 (length p))) row) as [A | (j & J & F)].
  2: { apply orb_false_elim in F. destruct F as [F G]. apply negb_false_iff in F. apply in_seq in J.
       destruct (all_or_one (fun i => is_convolution_segment p q OfP i j) (seq 0 (length p)))
         as [B | (i & I & H)].
       - apply forallb_forall in B. congruence.
       - apply in_seq in I. exists j, i. repeat split; trivial; lia. }
  exfalso.
  assert (full : forall j i, j < length q -> i < length p ->
    is_convolution_segment p q OfP 0 j = true -> is_convolution_segment p q OfP i j = true).
  { intros j i J I S. specialize (A j). assert (In j row) as K by (apply in_seq; lia).
    specialize (A K). cbv beta in A. rewrite S in A. cbn [negb orb] in A. rewrite forallb_forall in A.
    apply A. apply in_seq. lia. }
  clear A.
  assert (reflex : forall j, j < length q -> is_convolution_segment p q OfP 0 j = true ->
    is_reflex (corner_of_chain q j) = true).
  { intros j J S. destruct (is_reflex (corner_of_chain q j)) eqn:R; [reflexivity | exfalso].
    destruct (edges_on_no_side p
      (minus (incoming (corner_of_chain q j)) (outgoing (corner_of_chain q j))) PN) as (i & I & N).
    apply N. apply (tangents_on_one_side (Direction (edge_of_chain p i) OfP)); trivial.
    - now apply edges_are_directions.
    - now apply corners_turn.
    - apply (full j i J I S). }
  pose proof (covered_by_q p q 0 P Q LP) as C. fold row in C.
  pose proof (row_of_reflex_vertices q) as R. fold row in R.
  unfold outer, hole in T. destruct T as [T | T]; rewrite T in C.
  - destruct (more_of_them nat (fun j => is_convolution_segment p q OfP 0 j)
                (fun j => is_reflex (corner_of_chain q j)) row) as (j & J & S & F);
      [rewrite R; apply Nat2Z.inj_lt; rewrite C; lia |].
    apply in_seq in J. rewrite (reflex j) in F; [discriminate | lia | exact S].
  - destruct (more_of_them nat (fun j => is_reflex (corner_of_chain q j))
                (fun j => is_convolution_segment p q OfP 0 j) row) as (j & J & F & S);
      [rewrite R; apply Nat2Z.inj_lt; rewrite C; lia |].
    apply in_seq in J.
    destruct (edges_on_no_side p
      (minus (outgoing (corner_of_chain q j)) (incoming (corner_of_chain q j))) PN) as (i & I & N).
    apply N. apply (missing_on_one_side (Direction (edge_of_chain p i) OfP)); trivial.
    + now apply edges_are_directions.
    + apply corners_turn; [exact Q | lia].
    + destruct (is_convolution_segment p q OfP i j) eqn:X; [exfalso | exact X].
      pose proof (covered_by_q p q i P Q I) as D. fold row in D. rewrite T in D.
      assert (count (fun k => is_convolution_segment p q OfP 0 k) row <
              count (fun k => is_convolution_segment p q OfP i k) row) as L.
      { apply more_with_one_more with (a := j); trivial; [apply in_seq; lia |].
        intros k K Y. apply in_seq in K. apply full; trivial; lia. }
      apply Nat2Z.inj_lt in L. rewrite C, D in L. lia.
Qed.

(* Theorem. If Q's chain has turning number one, or minus one as a hole has, some cycle goes round both
   chains: it takes at least n_P edges of P and at least n_Q edges of Q. *)
Theorem some_cycle_goes_round_both : forall p q cycles,
  turns_everywhere p -> turns_everywhere q -> p <> [] -> q <> [] -> outer q \/ hole q ->
  trace_cycles (length p) (length q) (in_convolution p q) = Some cycles ->
  exists cycle, In cycle cycles /\
    length p <= steps_of_p (map fst cycle) /\ length q <= steps_of_q (map fst cycle).
Proof.
  intros p q cycles P Q PN QN T E.
  assert (0 < length p) as LP by (destruct p; [contradiction | cbn; lia]).
  pose proof (turning_chains_have_edges p P) as NP. pose proof (turning_chains_have_edges q Q) as NQ.
  destruct (some_row_has_a_gap p q P Q PN T) as (j & i & J & IL & S & N).
  destruct (cycles_cover_the_convolution p q NP NQ PN QN) as (others & E' & _ & M).
  rewrite E in E'. injection E' as <-.
  assert (I : In (OfP, (0, j)) (concat cycles)).
  { apply (Permutation_in _ (Permutation_sym M)). apply in_those. cbn. split; [split; [exact LP | exact J] | exact S]. }
  apply in_concat in I. destruct I as (cycle & I & K). exists cycle. split; [exact I |].
  destruct (traced_cycles_cross_the_grid p q cycles cycle NP NQ PN QN E I)
    as [_ (a & b & A & B & L)].
  pose proof (fun s => traced_in_grid p q cycles cycle s NP NQ PN QN E I) as G.
  assert (PA : steps_of_p (map fst cycle) <> 0).
  { clear - K. unfold steps_of_p. induction cycle as [| s rest IH]; [destruct K |].
    destruct K as [-> | K]; cbn; [discriminate |]. destruct (is_of_p (fst s)); cbn; [discriminate |].
    now apply IH. }
  assert (PB : steps_of_q (map fst cycle) <> 0).
  { intros Z. pose proof (no_steps_of_q cycle Z) as only_p.
    destruct (G (OfP, (0, j))) as [Y _].
    destruct (cycles_are_closed_walks (length p) (length q) cycle Y) as (start & W & H).
    { intros s X. apply (in_the_convolution p q s). now apply G. }
    destruct W as (W1 & W2 & W3 & W4). destruct start as [i0 j0]. cbn in W1, W2.
    destruct (every_index i0 (length p) (steps_of_p (map fst cycle)) W1) with (k := i) as (t & TL & TE);
      [rewrite A in PA |- *; destruct a; [now destruct PA | cbn; lia] | exact IL |].
    destruct (passed_of_p (length p) (length q) (map fst cycle) i0 j0 t W1 TL) as ([x y] & X & XE).
    cbn in XE. rewrite TE in XE. subst x. rewrite H in X. apply in_map_iff in X.
    destruct X as ([along st] & SE & X). cbn in SE. subst st.
    pose proof (only_p _ X) as O. cbn in O. subst along.
    destruct Y as [_ (from & Y)].
    pose proof (walks_along_p_stay _ _ _ _ _ Y only_p _ X) as R1.
    pose proof (walks_along_p_stay _ _ _ _ _ Y only_p _ K) as R2. cbn in R1, R2.
    rewrite R1, <- R2 in X.
    destruct (G (OfP, (i, j))) as [_ V]. specialize (V X). apply in_the_convolution in V.
    destruct V as [_ V]. change (is_convolution_segment p q OfP i j = true) in V. congruence. }
  split.
  - rewrite A in PA |- *. destruct a; [now destruct PA | cbn; lia].
  - rewrite B in PB |- *. destruct b; [now destruct PB | cbn; lia].
Qed.

(* Theorem. So with K segments in the convolution, K is at least n_P + n_Q, and there is a cycle of at
   least that size. *)
Theorem some_cycle_is_long : forall p q cycles,
  turns_everywhere p -> turns_everywhere q -> p <> [] -> q <> [] -> outer q \/ hole q ->
  trace_cycles (length p) (length q) (in_convolution p q) = Some cycles ->
  exists cycle, In cycle cycles /\ length p + length q <= length cycle <= length (convolution p q).
Proof.
  intros p q cycles P Q PN QN T E.
  destruct (some_cycle_goes_round_both p q cycles P Q PN QN T E) as (cycle & I & A & B).
  exists cycle. split; [exact I |].
  pose proof (turning_chains_have_edges p P) as NP. pose proof (turning_chains_have_edges q Q) as NQ.
  destruct (traced_cycles_cross_the_grid p q cycles cycle NP NQ PN QN E I)
    as [_ (a & b & C & D & L)].
  destruct (cycles_cover_the_convolution p q NP NQ PN QN) as (others & E' & _ & M).
  rewrite E in E'. injection E' as <-. apply Permutation_length in M.
  apply in_split in I. destruct I as (before & after & ->).
  rewrite concat_app, app_length in M. cbn [concat] in M. rewrite app_length in M.
  split; [rewrite L, <- C, <- D; now apply Nat.add_le_mono |].
  transitivity (length (concat before) + (length cycle + length (concat after))); [lia |].
  now apply Nat.eq_le_incl.
Qed.

(* Theorem. Two convex chains have one cycle, of exactly n_P + n_Q segments. *)
Theorem convex_chains_have_one_cycle : forall p q cycles,
  turns_everywhere p -> turns_everywhere q -> p <> [] -> q <> [] ->
  turning_number p = 1%Z -> turning_number q = 1%Z ->
  reflex_vertices p = 0 -> reflex_vertices q = 0 ->
  trace_cycles (length p) (length q) (in_convolution p q) = Some cycles ->
  exists cycle, cycles = [cycle] /\ length cycle = length p + length q.
Proof.
  intros p q cycles P Q PN QN TP TQ RP RQ E.
  destruct (some_cycle_is_long p q cycles P Q PN QN (or_introl TQ) E) as (cycle & I & L & U).
  pose proof (convolution_size p q P Q TP TQ) as S. rewrite RP, RQ in S.
  pose proof (turning_chains_have_edges p P) as NP. pose proof (turning_chains_have_edges q Q) as NQ.
  destruct (cycles_cover_the_convolution p q NP NQ PN QN) as (others & E' & F & M).
  rewrite E in E'. injection E' as <-. apply Permutation_length in M.
  apply in_split in I. destruct I as (before & after & ->).
  rewrite concat_app, app_length in M. cbn [concat] in M. rewrite app_length in M.
  apply Forall_app in F. destruct F as [FB FA]. inversion FA as [| ? ? _ FA']; subst.
  assert (length (convolution p q) = length p + length q) as K by (rewrite S; lia).
  unfold named_segment, state in *. rewrite K in *.
  assert (NB : before = []).
  { destruct before as [| c rest]; [reflexivity | exfalso]. inversion FB as [| ? ? [N _] _]; subst.
    cbn [concat] in M. rewrite app_length in M. destruct c; [contradiction | cbn [length] in M; lia]. }
  assert (NA : after = []).
  { destruct after as [| c rest]; [reflexivity | exfalso]. inversion FA' as [| ? ? [N _] _]; subst.
    cbn [concat] in M. rewrite app_length in M. destruct c; [contradiction | cbn [length] in M; lia]. }
  subst. exists cycle. split; [reflexivity | lia].
Qed.
