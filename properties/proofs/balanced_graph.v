(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* A finite directed graph whose nodes are entered as often as they are left falls into cycles that share
   no edge and pass no node twice. *)
From Coq Require Import Lia Bool List Permutation Arith.
From Oplus Require Import distinct.
Import ListNotations.

Open Scope nat_scope.

Section graph.

Context {node edge : Type} (node_eq_dec : forall a b : node, {a = b} + {a <> b})
        (source target : edge -> node).

(* Several edges may join the same nodes, hence a list, not a relation. *)
Definition entered_as_left (edges : list edge) : Prop :=
  forall x, count_occ node_eq_dec (map target edges) x = count_occ node_eq_dec (map source edges) x.

Fixpoint leads (a : node) (walk : list edge) (b : node) : Prop :=
  match walk with
  | [] => a = b
  | e :: rest => source e = a /\ leads (target e) rest b
  end.

(* A closed walk of at least one edge that leaves no node twice. *)
Definition simple_cycle (cycle : list edge) : Prop :=
  cycle <> [] /\ NoDup (map source cycle) /\ exists a, leads a cycle a.

Lemma leads_app a w : forall b v c, leads a w b -> leads b v c -> leads a (w ++ v) c.
Proof.
  revert a. induction w as [| e w IH]; intros a b v c; cbn.
  - now intros ->.
  - intros [? ?] ?. split; [assumption |]. now apply (IH _ b).
Qed.

Lemma leads_split a w : forall v b, leads a (w ++ v) b -> exists c, leads a w c /\ leads c v b.
Proof.
  revert a. induction w as [| e w IH]; intros a v b; cbn.
  - intros l. now exists a.
  - intros [? l]. destruct (IH _ _ _ l) as (c & ? & ?). exists c. auto.
Qed.

(* The sources of a walk with its end are its start with its targets. *)
Lemma ends_of_walk a w : forall b, leads a w b -> Permutation (b :: map source w) (a :: map target w).
Proof.
  revert a. induction w as [| e w IH]; intros a b; cbn.
  - intros ->. apply Permutation_refl.
  - intros [<- l]. etransitivity; [apply perm_swap |]. apply perm_skip. exact (IH _ _ l).
Qed.

Lemma count_occ_permuted l l' x :
  Permutation l l' -> count_occ node_eq_dec l x = count_occ node_eq_dec l' x.
Proof. intros p. now apply (Permutation_count_occ node_eq_dec). Qed.

Lemma cycle_entered_as_left cycle a : leads a cycle a -> entered_as_left cycle.
Proof.
  intros l x. apply ends_of_walk, Permutation_cons_inv in l. symmetry. now apply count_occ_permuted.
Qed.

(* A walk that leaves no node twice goes on, among the edges that are left, until it closes a cycle. *)
Lemma walk_closes edges : forall rest walk a e,
  entered_as_left edges -> Permutation (rest ++ walk ++ [e]) edges ->
  leads a (walk ++ [e]) (target e) -> NoDup (map source (walk ++ [e])) ->
  exists cycle others, simple_cycle cycle /\ Permutation (cycle ++ others) edges.
Proof.
  intros rest. remember (length rest) as size eqn:size_is. revert rest size_is.
  induction size as [size IH] using lt_wf_ind. intros rest size_is walk a e balanced all l distinct.
  destruct (in_dec node_eq_dec (target e) (map source (walk ++ [e]))) as [met | new].
  - apply in_map_iff in met. destruct met as (first & met & I).
    apply in_split in I. destruct I as (before & after & w_is). rewrite w_is in *.
    exists (first :: after), (rest ++ before). repeat split.
    + discriminate.
    + rewrite map_app in distinct. now apply NoDup_second in distinct.
    + exists (target e). apply leads_split in l. destruct l as (c & _ & l).
      pose proof l as [from _]. rewrite met in from. now rewrite <- from in l at 1.
    + rewrite <- all, (app_assoc rest). apply Permutation_app_comm.
  - assert (target_in : In (target e) (map target edges)).
    { apply in_map. apply (Permutation_in _ all). rewrite !in_app_iff. cbn. tauto. }
    apply (count_occ_In node_eq_dec) in target_in. rewrite balanced in target_in.
    apply (count_occ_In node_eq_dec) in target_in. apply in_map_iff in target_in.
    destruct target_in as (next & from & I). apply (Permutation_in _ (Permutation_sym all)) in I.
    apply in_app_iff in I. destruct I as [I | I].
    2: { exfalso. apply new. rewrite <- from. now apply in_map. }
    apply in_split in I. destruct I as (before & after & rest_is).
    refine (IH (length (before ++ after)) _ (before ++ after) eq_refl (walk ++ [e]) a next balanced _ _ _).
    + rewrite size_is, rest_is, !app_length. cbn. lia.
    + rewrite <- all, rest_is. transitivity (next :: (before ++ after) ++ walk ++ [e]).
      * rewrite app_assoc. apply Permutation_sym, Permutation_cons_append.
      * rewrite <- !app_assoc. cbn [app]. apply Permutation_middle.
    + apply (leads_app _ _ (target e)); [exact l |]. now split.
    + rewrite map_app. apply NoDup_of_two; [exact distinct | repeat constructor; intros [] |].
      cbn. intros b J [<- | []]. apply new. now rewrite <- from.
Qed.

Lemma without_cycle edges cycle others :
  entered_as_left edges -> simple_cycle cycle -> Permutation (cycle ++ others) edges ->
  entered_as_left others.
Proof.
  intros balanced (_ & _ & a & l) all x. specialize (balanced x).
  rewrite <- (count_occ_permuted _ _ x (Permutation_map target all)) in balanced.
  rewrite <- (count_occ_permuted _ _ x (Permutation_map source all)) in balanced.
  rewrite !map_app, !count_occ_app, (cycle_entered_as_left cycle a l x) in balanced. lia.
Qed.

Theorem falls_into_cycles edges :
  entered_as_left edges ->
  exists cycles, Forall simple_cycle cycles /\ Permutation (concat cycles) edges.
Proof.
  remember (length edges) as size eqn:size_is. revert edges size_is.
  induction size as [size IH] using lt_wf_ind. intros [| e edges] size_is balanced.
  - exists []. split; constructor.
  - destruct (walk_closes (e :: edges) edges [] (source e) e balanced) as (cycle & others & simple & all).
    + rewrite Permutation_app_comm. apply Permutation_refl.
    + now split.
    + repeat constructor. intros [].
    + destruct (IH (length others)) with (edges := others) as (cycles & good & rest); trivial.
      * apply Permutation_length in all. rewrite app_length in all. destruct simple as [nonempty _].
        destruct cycle; [contradiction | cbn in *; lia].
      * exact (without_cycle _ _ _ balanced simple all).
      * exists (cycle :: cycles). split; [now constructor |]. cbn [concat].
        rewrite <- all. now apply Permutation_app_head.
Qed.

End graph.
