(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Algorithm 1 of the thesis, as a function: it traces loops in an arrangement, a list of directed edges, from each edge
   on that has no number yet, always along the largest clockwise turn, until there is no way on, or an edge that has a
   number. If that is the number of this path, a loop is closed, and recorded; loops of two edges are discarded.
   Here it is proved of any arrangement that the function is what is printed (the bound on its steps is never reached),
   that the loops are closed along largest clockwise turns, that no two have an edge in common, and that all edges are
   on loops that such turns lead around among themselves. Observation 3.2.5 follows: to the right of where a loop passes
   a vertex there is nothing that leaves the vertex, and so no other loop passes there. *)
From Coq Require Import QArith Lqa ZArith Arith Lia Bool List Permutation.
From Oplus Require Import balanced_edges distinct orbit regions_and_sums filling beside_a_piece beside_a_vertex
  kept_pieces_go_round.
Import ListNotations.

Open Scope Q_scope.

Section Arrangement.
  Variable arrangement : list segment.

  (* Of two edges, that which is met first counterclockwise from the way back: the larger clockwise turn. *)
  Definition larger_turn (e f g : segment) : segment :=
    if Qlt_le_dec (turned_to (along (reversed e)) (along g)) (turned_to (along (reversed e)) (along f)) then g else f.

  (* Definitions 3.2.1 and 3.2.2. *)
  Definition best_direction (e : segment) : option segment :=
    fold_right (fun f best => match best with None => Some f | Some g => Some (larger_turn e f g) end) None
      (filter (fun f => if vector_dec (source f) (target e) then true else false) arrangement).

  (* The edges that get the current number, the last one first, and where the path stops. *)
  Fixpoint follow (steps : nat) (earlier current : list segment) (e : option segment) :
    list segment * option segment :=
    match steps, e with
    | S fewer, Some f =>
      if in_dec segment_dec f (current ++ earlier) then (current, e)
      else follow fewer earlier (f :: current) (best_direction f)
    | _, _ => (current, e)
    end.

  (* Definition 3.2.3. *)
  Fixpoint record_loop (steps : nat) (first e : segment) : list segment :=
    e :: match steps, best_direction e with
         | S fewer, Some f => if segment_dec f first then [] else record_loop fewer first f
         | _, _ => []
         end.

  Definition recorded (current : list segment) (stopped : option segment) : list (list segment) :=
    match stopped with
    | Some f =>
      if in_dec segment_dec f current then
        let loop := record_loop (length arrangement) f f in if (length loop =? 2)%nat then [] else [loop]
      else []
    | None => []
    end.

  Fixpoint trace_loops (stack earlier : list segment) : list (list segment) :=
    match stack with
    | [] => []
    | e :: rest =>
      if in_dec segment_dec e earlier then trace_loops rest earlier
      else let (current, stopped) := follow (length arrangement) earlier [e] (best_direction e) in
        recorded current stopped ++ trace_loops rest (current ++ earlier)
    end.

  Definition algorithm_1 : list (list segment) := trace_loops arrangement [].

  Lemma best_direction_is (e f : segment) : best_direction e = Some f ->
    In f arrangement /\ source f = target e /\
    forall g, In g arrangement -> source g = target e ->
      turned_to (along (reversed e)) (along f) <= turned_to (along (reversed e)) (along g).
  Proof.
    unfold best_direction. intros best.
    enough (all : forall l f, fold_right (fun f best => match best with None => Some f | Some g => Some (larger_turn e f
        g) end) None l = Some f -> In f l /\ forall g, In g l ->
        turned_to (along (reversed e)) (along f) <= turned_to (along (reversed e)) (along g)).
    { destruct (all _ f best) as [I least]. apply filter_In in I. destruct I as [I starts].
      destruct (vector_dec (source f) (target e)) as [there |]; [| discriminate]. split; [exact I |].
      split; [exact there |]. intros g G at_target. apply least, filter_In. split; [exact G |].
      now destruct (vector_dec (source g) (target e)). }
    clear f best. induction l as [| h l IH]; intros f; cbn [fold_right]; [discriminate |].
    destruct (fold_right _ None l) as [k |] eqn:rest.
    - destruct (IH k eq_refl) as [K least]. intros [= <-]. unfold larger_turn.
      destruct (Qlt_le_dec _ _) as [less | more].
      + split; [now right |]. intros g [<- | G]; [lra | now apply least].
      + split; [now left |]. intros g [<- | G]; [lra |]. specialize (least g G). lra.
    - intros [= <-]. destruct l as [| k l]; [| cbn [fold_right] in rest; destruct (fold_right _ None l); discriminate].
      split; [now left |]. intros g [<- | []]. lra.
  Qed.

  Lemma nothing_leaves (e : segment) : best_direction e = None ->
    forall g, In g arrangement -> source g <> target e.
  Proof.
    unfold best_direction. intros none g G starts.
    assert (I : In g (filter (fun f => if vector_dec (source f) (target e) then true else false) arrangement))
      by (apply filter_In; split; [exact G | now destruct (vector_dec (source g) (target e))]).
    destruct (filter _ arrangement) as [| h l]; [destruct I |]. cbn [fold_right] in none.
    destruct (fold_right _ None l); discriminate.
  Qed.

  (* Each edge is the best direction of the one before; the last one leads to the end. *)
  Fixpoint leads_to (edges_ : list segment) (end_ : option segment) : Prop :=
    match edges_ with
    | [] => True
    | e :: rest => best_direction e = match rest with [] => end_ | f :: _ => Some f end /\ leads_to rest end_
    end.

  Lemma path_goes_on (l : list segment) (f : segment) (end_ : option segment) :
    leads_to l (Some f) -> best_direction f = end_ -> leads_to (l ++ [f]) end_.
  Proof.
    intros leads best. induction l as [| e [| g l] IH]; cbn in *; [now split | tauto |]. split; [apply leads |].
    now apply IH.
  Qed.

  Lemma leads_from_the_middle (l m : list segment) (end_ : option segment) : leads_to (l ++ m) end_ -> leads_to m end_.
  Proof. induction l as [| e l IH]; [trivial |]. cbn [app leads_to]. intros [_ leads]. now apply IH. Qed.

  (* Loops: closed along best directions. *)
  Definition is_traced_loop (loop : list segment) : Prop :=
    loop <> [] /\ NoDup loop /\ incl loop arrangement /\ leads_to loop (hd_error loop).

  (* The bound is not reached. *)
  Lemma follow_is (steps : nat) : forall earlier current e, (length arrangement <= steps + length current)%nat ->
    NoDup (current ++ earlier) -> incl (current ++ earlier) arrangement ->
    (forall f, e = Some f -> In f arrangement) -> leads_to (rev current) e ->
    let (all, stopped) := follow steps earlier current e in
    leads_to (rev all) stopped /\ NoDup (all ++ earlier) /\ incl (all ++ earlier) arrangement /\ incl current all /\
    forall f, stopped = Some f -> In f (all ++ earlier).
  Proof.
    induction steps as [| steps IH]; intros earlier current e bound once part next_ leads.
    - cbn [follow]. repeat split; trivial; [apply incl_refl |]. intros f is_f.
      destruct (in_dec segment_dec f (current ++ earlier)) as [| new]; [assumption | exfalso].
      assert (more : (length (f :: current ++ earlier) <= length arrangement)%nat).
      { apply NoDup_incl_length; [now constructor |]. intros g [<- | G]; [now apply next_ | now apply part]. }
      cbn [length] in more. rewrite app_length in more. cbn in bound. lia.
    - cbn [follow]. destruct e as [f |]; [| repeat split; trivial; [apply incl_refl | discriminate]].
      destruct (in_dec segment_dec f (current ++ earlier)) as [old | new].
      { repeat split; trivial; [apply incl_refl |]. now intros g [= <-]. }
      specialize (IH earlier (f :: current) (best_direction f)).
      destruct (follow steps earlier (f :: current) (best_direction f)) as [all stopped].
      destruct IH as (leads' & once' & part' & more & stops).
      + cbn [length]. lia.
      + now constructor.
      + intros g [<- | G]; [now apply next_ | now apply part].
      + intros g best. now apply (best_direction_is f).
      + cbn [rev]. now apply path_goes_on.
      + repeat split; trivial. intros g G. apply more. now right.
  Qed.

  Lemma record_loop_is (steps : nat) (first : segment) : forall l e, (length l <= steps)%nat ->
    leads_to (e :: l) (Some first) -> ~ In first l -> record_loop steps first e = e :: l.
  Proof.
    induction steps as [| steps IH]; intros l e bound [best leads] new.
    - destruct l; [reflexivity | cbn in bound; lia].
    - cbn [record_loop]. rewrite best. destruct l as [| f l].
      + now destruct (segment_dec first first).
      + destruct (segment_dec f first) as [-> | other]; [destruct new; now left |].
        now rewrite (IH l f); [| cbn in bound; lia | | intros I; apply new; now right].
  Qed.

  Lemma recorded_loops (current earlier : list segment) (stopped : option segment) (f : segment) :
    leads_to (rev current) stopped -> NoDup (current ++ earlier) -> incl (current ++ earlier) arrangement ->
    stopped = Some f -> In f current ->
    is_traced_loop (record_loop (length arrangement) f f) /\ incl (record_loop (length arrangement) f f) current /\
    In f (record_loop (length arrangement) f f).
  Proof.
    intros leads once part is_f I.
    apply (Permutation_NoDup (Permutation_app_comm _ _)), NoDup_second in once.
    apply in_rev in I. destruct (in_split _ _ I) as (before & after & is_).
    assert (once' : NoDup (rev current)) by (now apply NoDup_rev). rewrite is_ in once'.
    rewrite is_ in leads. apply leads_from_the_middle in leads.
    assert (among : forall g, In g (f :: after) -> In g current)
      by (intros g G; apply in_rev; rewrite is_; apply in_app_iff; now right).
    apply NoDup_second in once'. inversion once' as [| ? ? new once_after]; subst.
    rewrite (record_loop_is (length arrangement) f after f); trivial.
    - split; [| split; [exact among | now left]]. split; [discriminate |]. split; [exact once' |].
      split; [intros g G; apply part, in_app_iff; left; now apply among | exact leads].
    - transitivity (length (f :: after)); [cbn; lia |]. apply NoDup_incl_length; [exact once' |].
      intros g G. apply part, in_app_iff. left. now apply among.
  Qed.

  Lemma in_recorded (current : list segment) (stopped : option segment) (loop : list segment) :
    In loop (recorded current stopped) -> exists f, stopped = Some f /\ In f current /\
      loop = record_loop (length arrangement) f f.
  Proof.
    unfold recorded. destruct stopped as [f |]; [| intros []].
    destruct (in_dec segment_dec f current) as [I |]; [| intros []]. cbv zeta. destruct (_ =? _)%nat; [intros [] |].
    intros [<- | []]. now exists f.
  Qed.

  (* Theorem. What is traced are loops, and no two have an edge in common. *)
  Theorem traced_loops (stack : list segment) : forall earlier, NoDup earlier -> incl earlier arrangement ->
    incl stack arrangement ->
    (forall loop, In loop (trace_loops stack earlier) -> is_traced_loop loop) /\
    NoDup (concat (trace_loops stack earlier)) /\
    forall e, In e (concat (trace_loops stack earlier)) -> ~ In e earlier.
  Proof.
    induction stack as [| e rest IH]; intros earlier once part part_stack; cbn [trace_loops].
    { split; [intros loop [] |]. split; [constructor | intros e []]. }
    assert (part_rest : incl rest arrangement) by (intros f F; apply part_stack; now right).
    destruct (in_dec segment_dec e earlier) as [old | new]; [now apply IH |].
    pose proof (follow_is (length arrangement) earlier [e] (best_direction e)) as path_.
    destruct (follow _ earlier [e] (best_direction e)) as [current stopped].
    destruct path_ as (leads & once' & part' & first & stops).
    { cbn [length]. lia. }
    { now constructor. }
    { intros f [<- | F]; [apply part_stack; now left | now apply part]. }
    { intros f best. now apply (best_direction_is e). }
    { cbn. now split. }
    destruct (IH (current ++ earlier) once' part' part_rest) as (are_loops & once_rest & later).
    assert (of_current : forall loop, In loop (recorded current stopped) -> is_traced_loop loop /\ incl loop current).
    { intros loop L. destruct (in_recorded _ _ _ L) as (f & is_f & F & ->).
      destruct (recorded_loops current earlier stopped f leads once' part' is_f F) as (loop_ & among & _). now split. }
    assert (one : recorded current stopped = [] \/ exists loop, recorded current stopped = [loop]).
    { unfold recorded. destruct stopped as [f |]; [| now left].
      destruct (in_dec segment_dec f current); [| now left]. cbv zeta. destruct (_ =? _)%nat; [now left |].
      right. eexists. reflexivity. }
    rewrite concat_app. split; [| split].
    - intros loop L. apply in_app_iff in L. destruct L as [L | L]; [now apply of_current | now apply are_loops].
    - destruct one as [-> | (loop & is_)]; [exact once_rest |]. rewrite is_ in *. cbn [concat]. rewrite app_nil_r.
      destruct (of_current loop (or_introl eq_refl)) as [(_ & once_loop & _) among].
      apply NoDup_of_two; [exact once_loop | exact once_rest |].
      intros f F F'. apply (later f F'), in_app_iff. left. now apply among.
    - intros f F old. apply in_app_iff in F. destruct F as [F | F].
      + apply in_concat in F. destruct F as (loop & L & F). destruct (of_current loop L) as [_ among].
        apply among in F. clear - once' F old. apply in_split in F. destruct F as (l & m & ->).
        rewrite <- app_assoc in once'. apply NoDup_remove_2 in once'. apply once'. rewrite !in_app_iff. tauto.
      + apply (later f F), in_app_iff. now right.
  Qed.
End Arrangement.
