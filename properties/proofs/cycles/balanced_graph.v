(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* A finite directed graph whose nodes are entered as often as they are left decomposes into cycles
   that share no edge and pass no node twice. *)
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

Lemma count_occ_permuted l l' x : Permutation l l' -> count_occ node_eq_dec l x = count_occ node_eq_dec l' x.
Proof. intros p. now apply (Permutation_count_occ node_eq_dec). Qed.

Lemma cycle_entered_as_left cycle a : leads a cycle a -> entered_as_left cycle.
Proof. intros l x. apply ends_of_walk, Permutation_cons_inv in l. symmetry. now apply count_occ_permuted. Qed.

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

(* Euler circuits. A closed walk takes each of its edges once, but may come to a node again. *)
Definition closed_walk_of_edges (walk : list edge) : Prop :=
  walk <> [] /\ exists a, leads a walk a.

(* No edge of one starts where one of the other does; closed walks then have no node in common. *)
Definition no_common_node (walk other : list edge) : Prop :=
  forall e f, In e walk -> In f other -> source e <> source f.

Lemma common_node_dec walk other :
  {no_common_node walk other} +
  {exists e f, In e walk /\ In f other /\ source e = source f}.
Proof.
  destruct (Exists_dec (fun e => In (source e) (map source other)) walk) as [common | none].
  - intros e. apply in_dec, node_eq_dec.
  - right. apply Exists_exists in common. destruct common as (e & I & J). apply in_map_iff in J.
    destruct J as (f & same & J). exists e, f. auto.
  - left. intros e f I J same. apply none, Exists_exists. exists e. split; [exact I |].
    rewrite same. now apply in_map.
Qed.

(* A closed walk can be started at any of its edges. *)
Lemma started_at walk e :
  closed_walk_of_edges walk -> In e walk ->
  exists rest, Permutation (e :: rest) walk /\ leads (source e) (e :: rest) (source e).
Proof.
  intros (_ & a & l) I. apply in_split in I. destruct I as (before & after & ->).
  exists (after ++ before). split.
  - apply (Permutation_app_comm (e :: after) before).
  - apply leads_split in l. destruct l as (c & first & last). pose proof last as [from _].
    rewrite <- from in first, last. exact (leads_app _ (e :: after) _ before _ last first).
Qed.

Lemma joined walk other e f :
  closed_walk_of_edges walk -> closed_walk_of_edges other ->
  In e walk -> In f other -> source e = source f ->
  exists both, closed_walk_of_edges both /\ Permutation both (walk ++ other).
Proof.
  intros w o I J same.
  destruct (started_at walk e w I) as (rest & all & l), (started_at other f o J) as (rest' & all' & l').
  exists ((e :: rest) ++ f :: rest'). split.
  - split; [discriminate |]. exists (source e). apply (leads_app _ _ (source e)); [exact l |].
    now rewrite same.
  - now apply Permutation_app.
Qed.

Lemma pairs_without_one A (R : A -> A -> Prop) a l : forall before,
  ForallOrdPairs R (before ++ a :: l) -> ForallOrdPairs R (before ++ l).
Proof.
  induction before as [| b before IH]; intros pairs; cbn in *.
  - now inversion pairs.
  - inversion pairs as [| ? ? with_b others]; subst. constructor; [| now apply IH].
    apply Forall_app in with_b. destruct with_b as [with_before with_rest].
    apply Forall_app. split; trivial. now inversion with_rest.
Qed.

Definition circuits_of (circuits : list (list edge)) (edges : list edge) : Prop :=
  Forall closed_walk_of_edges circuits /\ ForallOrdPairs no_common_node circuits /\
  Permutation (concat circuits) edges.

(* One more closed walk is joined with all that it meets. *)
Lemma one_more circuits : forall edges walk,
  circuits_of circuits edges -> closed_walk_of_edges walk ->
  exists more, circuits_of more (walk ++ edges).
Proof.
  remember (length circuits) as size eqn:size_is. revert circuits size_is.
  induction size as [size IH] using lt_wf_ind. intros circuits size_is edges walk (good & apart & all) w.
  destruct (Exists_dec (fun other => ~ no_common_node walk other) circuits) as [meets | meets].
  { intros other. destruct (common_node_dec walk other) as [n | common]; [right; tauto | left].
    intros n. destruct common as (e & f & I & J & same). exact (n e f I J same). }
  - apply Exists_exists in meets. destruct meets as (other & I & met).
    destruct (common_node_dec walk other) as [n | (e & f & I' & J' & same)]; [contradiction |].
    apply in_split in I. destruct I as (before & after & ->).
    apply Forall_app in good. destruct good as [good_before good].
    inversion good as [| ? ? o good_after]; subst.
    destruct (joined walk other e f w o I' J' same) as (both & b & both_is).
    destruct (IH (length (before ++ after))) with (circuits := before ++ after)
      (edges := concat (before ++ after)) (walk := both) as (more & good' & apart' & all'); trivial.
    + rewrite !app_length. cbn. lia.
    + repeat split; [now apply Forall_app | now apply pairs_without_one in apart | reflexivity].
    + exists more. repeat split; trivial. rewrite all', both_is, <- all, !concat_app. cbn [concat].
      rewrite <- app_assoc. apply Permutation_app_head.
      rewrite app_assoc. rewrite (Permutation_app_comm other). now rewrite <- app_assoc.
  - exists (walk :: circuits). repeat split.
    + now constructor.
    + constructor; [| exact apart]. apply Forall_forall. intros other I.
      destruct (common_node_dec walk other) as [n | (e & f & I' & J' & same)]; [exact n | exfalso].
      apply meets, Exists_exists. exists other. split; [exact I |]. intros n. exact (n e f I' J' same).
    + cbn [concat]. now apply Permutation_app_head.
Qed.

(* Euler's theorem: each connected part of the graph has a closed walk that takes each of its edges once. *)
Theorem euler_circuits edges : entered_as_left edges -> exists circuits, circuits_of circuits edges.
Proof.
  intros balanced. destruct (falls_into_cycles edges balanced) as (cycles & good & all).
  enough (exists circuits, circuits_of circuits (concat cycles)) as (circuits & good' & apart & all').
  { exists circuits. repeat split; trivial. now rewrite all'. }
  clear all balanced edges. induction good as [| cycle cycles simple _ IH].
  - exists []. repeat split; constructor.
  - destruct IH as (circuits & c). cbn [concat]. apply (one_more circuits); trivial.
    destruct simple as (nonempty & _ & closed). now split.
Qed.

End graph.
