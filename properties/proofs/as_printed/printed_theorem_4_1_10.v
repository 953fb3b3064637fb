(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Theorem 4.1.10 as printed: for polygons of n and m vertices whose convolution has K segments, tracing all cycles
   takes O(n + m + K) operations, and no program that writes the convolution takes less, up to a factor. Tracing is by
   Algorithm 2 from the first row and the first column, with segments marked as soon as they are taken, without which it
   need not end (Theorem 4.1.6). What an operation is, is said in tracing_programs.v: a comparison of the directions of
   two edges, a look at a mark, or a segment that is written. That it is optimal is what the thesis argues: the K
   segments have to be written, and K is at least n + m, since some cycle goes round both polygons (corollary_4_1_9.v).
   Of regions, n + m adds up over the pairs of their chains, and is at most K, too. *)
From Coq Require Import Lia List Permutation.
From Oplus Require Import convolution tracing convolution_cycles tracing_programs tracing_by_algorithm_2 simple_chain
  simple_chains_turn_once rows_and_columns lemma_4_1_8 sizes_of_cycles corollary_4_1_9 polygons_of_the_thesis.
Import ListNotations.

Open Scope nat_scope.

Definition traced (p q : list vector) : run_of (option (list (list named_segment))) :=
  run (order_of p q) (tracing_of_all_cycles (length p) (length q)) [].

(* What is asked of the chains of regions: they turn once, as simple chains do, and those that touch themselves but do
   not cross (touching_chains.v). *)
Definition turns_once (chain : list vector) : Prop :=
  chain <> [] /\ turns_everywhere chain /\ (outer chain \/ hole chain).

Lemma simple_chains_turn_so (chain : list vector) : simple chain -> turns_once chain.
Proof.
  intros simple_. split; [now apply simple_chain_not_empty |]. split; [now apply simple_chain_turns_everywhere |].
  now apply simple_chain_is_outer_or_hole.
Qed.

Lemma traced_in_time (p q : list vector) : turns_once p -> turns_once q ->
  let n := length p in let m := length q in let k := length (convolution p q) in
  (exists cycles, answer (traced p q) = Some cycles /\ Forall (is_cycle n m) cycles /\
                  Permutation (concat cycles) (convolution p q)) /\
  operation_count (traced p q) <= 16 * (n + m) + 8 * k /\ n + m <= k.
Proof.
  intros (p_some & p_turns & _) (q_some & q_turns & q_once) n m k.
  pose proof (turning_chains_have_edges p p_turns) as p_edges.
  pose proof (turning_chains_have_edges q q_turns) as q_edges.
  destruct (tracing_finds_all_cycles p q p_edges q_edges p_some q_some)
    as (cycles & written_ & cost & ran & are_cycles & together & few).
  destruct (cycles_cover_the_convolution p q p_edges q_edges p_some q_some) as (others & coded & _).
  destruct (some_cycle_is_long p q others p_turns q_turns p_some q_some q_once coded)
    as (cycle & _ & at_least & at_most_).
  assert (long : n + m <= k) by (unfold n, m, k; lia).
  unfold traced. rewrite ran. cbn [answer operation_count]. split; [| split; [| exact long]].
  - exists cycles. now split.
  - unfold k, n, m. lia.
Qed.

(* Theorem 4.1.10. *)
Theorem theorem_4_1_10_as_printed (p q : list vector) : simple_polygon p -> simple_polygon q ->
  let n := length p in let m := length q in let k := length (convolution p q) in
  (exists cycles, answer (traced p q) = Some cycles /\ Forall (is_cycle n m) cycles /\
                  Permutation (concat cycles) (convolution p q)) /\
  operation_count (traced p q) <= 16 * (n + m + k) /\
  (forall A (program : tracing_program A), incl (convolution p q) (written (run (order_of p q) program [])) ->
     n + m + k <= 2 * operation_count (run (order_of p q) program [])).
Proof.
  intros [p_simple _] [q_simple _] n m k.
  destruct (traced_in_time p q (simple_chains_turn_so p p_simple) (simple_chains_turn_so q q_simple))
    as (cycles & few & long). fold n m k in cycles, few, long.
  split; [exact cycles |]. split; [lia |]. intros A program all.
  pose proof (writing_costs (order_of p q) program []) as cost. cbn [length] in cost.
  apply (NoDup_incl_length (those_NoDup _ _ (in_convolution p q))) in all.
  change (length (those (length p) (length q) (in_convolution p q))) with k in all.
  unfold named_segment, state in *. lia.
Qed.

Lemma size_of_regions_is_a_sum (p q : region) : length (segments_of_regions p q) =
  list_sum (map (fun chains => length (convolution (fst chains) (snd chains))) (list_prod p q)).
Proof.
  unfold segments_of_regions. induction (list_prod p q) as [| chains rest IH]; [reflexivity |].
  cbn [flat_map map list_sum fold_right]. rewrite app_length, map_length. f_equal. exact IH.
Qed.

Lemma pairs_have_all_vertices (p q : region) : p <> [] -> q <> [] ->
  list_sum (map (@length vector) p) + list_sum (map (@length vector) q) <=
  list_sum (map (fun chains => length (fst chains) + length (snd chains)) (list_prod p q)).
Proof.
  intros p_some q_some.
  set (both := fun chains : list vector * list vector => length (fst chains) + length (snd chains)).
  assert (one_more : forall a r, list_sum (map both (list_prod (a :: r) q)) =
            length q * length a + list_sum (map (@length vector) q) + list_sum (map both (list_prod r q))).
  { intros a r. cbn [list_prod]. rewrite map_app, list_sum_app, map_map. f_equal. unfold both. cbn [fst snd].
    clear. induction q as [| b q IH]; [reflexivity |]. unfold list_sum in *. cbn [map fold_right length]. lia. }
  assert (1 <= length q) by (destruct q; [contradiction | cbn; lia]).
  assert (at_least : forall r, list_sum (map (@length vector) r) <= list_sum (map both (list_prod r q))).
  { induction r as [| a r IH]; [cbn; lia |]. rewrite one_more. unfold list_sum in *. cbn [map fold_right]. nia. }
  destruct p as [| a r]; [contradiction |]. rewrite one_more. specialize (at_least r).
  unfold list_sum in *. cbn [map fold_right]. nia.
Qed.

(* Theorem 4.1.10 for regions, each of any number of chains that turn once, holes among them: all pairs of chains
   together take no more than 24 operations for each segment, and there are at least n + m segments. *)
Theorem theorem_4_1_10_for_regions (p q : region) :
  Forall turns_once p -> Forall turns_once q -> p <> [] -> q <> [] ->
  let k := length (segments_of_regions p q) in
  list_sum (map (fun chains => operation_count (traced (fst chains) (snd chains))) (list_prod p q)) <= 24 * k /\
  list_sum (map (@length vector) p) + list_sum (map (@length vector) q) <= k.
Proof.
  intros p_once q_once p_some q_some k. pose proof (pairs_have_all_vertices p q p_some q_some) as vertices.
  unfold k. rewrite size_of_regions_is_a_sum.
  assert (each : forall chains, In chains (list_prod p q) ->
    operation_count (traced (fst chains) (snd chains)) <= 24 * length (convolution (fst chains) (snd chains)) /\
    length (fst chains) + length (snd chains) <= length (convolution (fst chains) (snd chains))).
  { intros [a b] I. apply in_prod_iff in I. rewrite Forall_forall in p_once, q_once.
    destruct (traced_in_time a b (p_once a (proj1 I)) (q_once b (proj2 I))) as (_ & few & long).
    cbn [fst snd]. split; [lia | exact long]. }
  clear p_once q_once. enough (sums : forall l, (forall c, In c l -> In c (list_prod p q)) ->
    list_sum (map (fun chains => operation_count (traced (fst chains) (snd chains))) l) <=
      24 * list_sum (map (fun chains => length (convolution (fst chains) (snd chains))) l) /\
    list_sum (map (fun chains => length (fst chains) + length (snd chains)) l) <=
      list_sum (map (fun chains => length (convolution (fst chains) (snd chains))) l)).
  { destruct (sums (list_prod p q) (fun c I => I)). split; [assumption |]. lia. }
  induction l as [| c l IH]; intros within_; [now split |].
  destruct (each c (within_ c (or_introl eq_refl))), (IH (fun d I => within_ d (or_intror I))).
  unfold list_sum in *. cbn [map fold_right]. split; lia.
Qed.
