(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* What the loops of Algorithm 1 (algorithm_1.v) are like: an edge is followed by the largest clockwise turn from it,
   and so different edges of loops are followed by different ones. Then nothing that a loop passes at a vertex is to the
   right of where another passing goes, in the sector clockwise from the way back to the edge that follows: nothing
   leaves there, and what came from there would be followed by the same edge. And edges that largest clockwise turns
   lead around among themselves, no two to one, are all traced, unless their loop has two edges: a path that comes to
   one of them goes on around until it is back there. *)
From Coq Require Import QArith Lqa ZArith Arith Lia Bool List Permutation.
From Oplus Require Import balanced_edges distinct orbit regions_and_sums filling beside_a_piece beside_a_vertex
  kept_pieces_go_round algorithm_1.
Import ListNotations.

Open Scope Q_scope.

Section Arrangement.
  Variable arrangement : list segment.

  Let best := best_direction arrangement.

  Lemma best_of_all (l : list segment) (z : segment) : leads_to arrangement l (Some z) ->
    map best l = map Some (tl (l ++ [z])).
  Proof.
    induction l as [| e [| f l] IH]; intros leads; [reflexivity | |].
    - destruct leads as [is_ _]. unfold best. cbn. now rewrite is_.
    - destruct leads as [is_ leads]. specialize (IH leads). cbn [map app tl] in *. rewrite IH.
      unfold best. now rewrite is_.
  Qed.

  Lemma best_permutes (loops : list (list segment)) :
    (forall loop, In loop loops -> is_traced_loop arrangement loop) ->
    Permutation (map best (concat loops)) (map Some (concat loops)).
  Proof.
    induction loops as [| loop loops IH]; intros are_loops; [reflexivity |]. cbn [concat]. rewrite !map_app.
    apply Permutation_app; [| apply IH; intros other O; apply are_loops; now right].
    destruct (are_loops loop (or_introl eq_refl)) as (some & _ & _ & leads).
    destruct loop as [| e l]; [contradiction |].
    cbn [hd_error] in leads. rewrite (best_of_all _ e leads). apply Permutation_map. cbn [app tl].
    symmetry. apply Permutation_cons_append.
  Qed.

  Lemma same_image {A B : Type} (g : A -> B) (l : list A) (a b : A) :
    NoDup (map g l) -> In a l -> In b l -> g a = g b -> a = b.
  Proof.
    induction l as [| c l IH]; intros once; [intros [] |]. cbn [map] in once.
    inversion once as [| ? ? new once']; subst.
    intros [-> | A'] [-> | B'] same; trivial.
    - exfalso. apply new. rewrite same. now apply in_map.
    - exfalso. apply new. rewrite <- same. now apply in_map.
    - now apply IH.
  Qed.

  (* Of two edges of loops, what follows them differs. *)
  Lemma followed_by_one (e f : segment) : In e (concat (algorithm_1 arrangement)) ->
    In f (concat (algorithm_1 arrangement)) -> best e = best f -> e = f.
  Proof.
    destruct (traced_loops arrangement arrangement []) as (are_loops & once & _);
      [constructor | intros g [] | apply incl_refl |]. fold (algorithm_1 arrangement) in *.
    apply same_image. apply (Permutation_NoDup (Permutation_sym (best_permutes _ are_loops))).
    apply NoDup_images; [exact once |]. congruence.
  Qed.

  Section Passings.
    Variable pieces : list segment.
    Hypothesis parts : share_ends_only pieces.
    Hypothesis directed_ : forall e, In e arrangement -> directed pieces e.

    Lemma turned_from (b c u : vector) : nonzero b -> nonzero c -> nonzero u -> turned_to b c < turned_to b u ->
      turned_to c u == turned_to b u - turned_to b c.
    Proof.
      intros B C U. pose proof (angle_range b B). pose proof (angle_range c C). pose proof (angle_range u U).
      unfold turned_to. destruct (Qlt_le_dec (angle b) (angle c)), (Qlt_le_dec (angle b) (angle u)),
        (Qlt_le_dec (angle c) (angle u)); lra.
    Qed.

    (* d is to the right of where one goes that comes along e and goes on along f. *)
    Definition right_of_passing (e f : segment) (d : vector) : Prop :=
      turned_to (along (reversed e)) d < turned_to (along (reversed e)) (along f).

    (* Theorem. To the right of a passing there is no other. *)
    Theorem nothing_to_the_right_of_a_passing (e f e' f' : segment) :
      In e (concat (algorithm_1 arrangement)) -> In e' (concat (algorithm_1 arrangement)) -> e <> e' ->
      target e = target e' -> best e = Some f -> best e' = Some f' ->
      ~ right_of_passing e f (along f') /\ ~ right_of_passing e f (along (reversed e')).
    Proof.
      intros E E' other meet next_ next_'.
      assert (listed : forall g, In g (concat (algorithm_1 arrangement)) -> In g arrangement).
      { intros g G. destruct (traced_loops arrangement arrangement []) as (are_loops & _);
          [constructor | intros h [] | apply incl_refl |]. fold (algorithm_1 arrangement) in *.
        apply in_concat in G. destruct G as (loop & L & G). now apply (are_loops loop L). }
      destruct (best_direction_is arrangement e f next_) as (F & starts & least).
      destruct (best_direction_is arrangement e' f' next_') as (F' & starts' & least').
      unfold right_of_passing. split.
      - assert (starts'' : source f' = target e) by congruence. specialize (least f' F' starts''). lra.
      - intros right_. assert (long : forall s, directed pieces s -> nonzero (along s))
          by exact (directed_is_long pieces parts).
        assert (back : forall g, In g (concat (algorithm_1 arrangement)) -> nonzero (along (reversed g)))
          by (intros g G; apply long, directed_reversed, directed_, listed, G).
        assert (differ : f <> f').
        { intros <-. apply other, followed_by_one; trivial. fold best in next_, next_'. congruence. }
        assert (starts'' : source f' = target e) by congruence.
        assert (starts''' : source f = target e') by congruence.
        specialize (least f' F' starts''). specialize (least' f F starts''').
        pose proof (long f (directed_ f F)) as long_f. pose proof (long f' (directed_ f' F')) as long_f'.
        rewrite (turned_from (along (reversed e)) (along (reversed e')) (along f)) in least' by auto.
        rewrite (turned_from (along (reversed e)) (along (reversed e')) (along f')) in least' by (auto; lra).
        assert (same_ : turned_to (along (reversed e)) (along f) == turned_to (along (reversed e)) (along f')) by lra.
        apply same_turn in same_; auto. revert same_.
        apply (rays_differ pieces parts f f' (directed_ f F) (directed_ f' F')); [congruence | exact differ].
    Qed.
  End Passings.

  (* Edges that lead around among themselves. *)
  Section Around.
    Variable around : list segment.
    Hypothesis once_around : NoDup around.
    Hypothesis stays : forall e, In e around -> exists f, In f around /\ best e = Some f.
    Hypothesis differ : forall e f, In e around -> In f around -> best e = best f -> e = f.

    Definition step_on (e : segment) : segment := match best e with Some f => f | None => e end.

    Lemma step_is (e : segment) : In e around -> In (step_on e) around /\ best e = Some (step_on e).
    Proof. intros E. destruct (stays e E) as (f & F & is_). unfold step_on. now rewrite is_. Qed.

    Lemma steps_permute : self_injection step_on around.
    Proof.
      split; [exact once_around |]. split; [intros e E; now apply step_is |].
      intros e f E F same. apply differ; trivial. rewrite (proj2 (step_is e E)), (proj2 (step_is f F)). congruence.
    Qed.

    Definition is_closed (l : list segment) : Prop := forall e f, In e l -> best e = Some f -> In f l.

    Lemma steps_add (i j : nat) (e : segment) : iterated step_on (i + j) e = iterated step_on i (iterated step_on j e).
    Proof. induction i as [| i IH]; [reflexivity |]. cbn. now rewrite IH. Qed.

    Lemma stays_in (l : list segment) (e : segment) (i : nat) : is_closed l -> In e around -> In e l ->
      In (iterated step_on i e) l.
    Proof.
      intros closed E I. induction i as [| i IH]; [exact I |]. cbn. apply (closed _ _ IH).
      apply step_is, iterated_in; [exact steps_permute | exact E].
    Qed.

    (* What is closed, and has an edge to which steps lead, has the edge from which they lead. *)
    Lemma comes_around (l : list segment) (e : segment) (j : nat) : is_closed l -> In e around ->
      In (iterated step_on j e) l -> In e l.
    Proof.
      intros closed E I. destruct (orbit_returns segment_dec step_on around e steps_permute E) as (k & K & returns).
      assert (again : forall m, iterated step_on (m * k) e = e).
      { induction m as [| m IH]; [reflexivity |]. cbn [Nat.mul]. now rewrite steps_add, IH. }
      rewrite <- (again j). replace (j * k)%nat with (j * k - j + j)%nat by nia. rewrite steps_add.
      apply stays_in; trivial. apply iterated_in; [exact steps_permute | exact E].
    Qed.

    Lemma leads_around (m : list segment) : forall e end_, In e around -> leads_to arrangement (e :: m) end_ ->
      end_ = Some (iterated step_on (S (length m)) e).
    Proof.
      induction m as [| f m IH]; intros e end_ E [is_ leads]; fold best in is_; rewrite (proj2 (step_is e E)) in is_.
      - now symmetry.
      - injection is_ as is_. cbn [length]. rewrite <- (iterated_once_more step_on). rewrite is_.
        apply IH; [| exact leads]. rewrite <- is_. now apply step_is.
    Qed.

    Lemma leads_among (m : list segment) : forall e end_, In e around -> leads_to arrangement (e :: m) end_ ->
      incl m around /\ forall f, end_ = Some f -> In f around.
    Proof.
      induction m as [| f m IH]; intros e end_ E [is_ leads]; fold best in is_; rewrite (proj2 (step_is e E)) in is_.
      - split; [intros g [] |]. intros f is_f. rewrite <- is_ in is_f. injection is_f as <-. now apply step_is.
      - injection is_ as is_. assert (F : In f around) by (rewrite <- is_; now apply step_is).
        destruct (IH f end_ F leads) as [all ends_]. split; [intros g [<- | G]; auto | exact ends_].
    Qed.

    (* Theorem. A loop that has one of them has no others. *)
    Theorem all_or_none (loop : list segment) (e : segment) : is_traced_loop arrangement loop -> In e loop ->
      In e around -> incl loop around.
    Proof.
      intros (some & _ & _ & leads) I E. destruct loop as [| h l]; [contradiction |]. cbn [hd_error] in leads.
      assert (H : In h around).
      { destruct (in_split _ _ I) as (before & after & is_). pose proof leads as leads'. rewrite is_ in leads'.
        apply leads_from_the_middle in leads'. now apply (leads_among after e (Some h) E leads'). }
      destruct (leads_among l h (Some h) H leads) as [all _]. intros f [<- | F]; auto.
    Qed.

    Lemma goes_on_in (l : list segment) (end_ : option segment) (e f : segment) : leads_to arrangement l end_ ->
      In e l -> best e = Some f -> In f l \/ end_ = Some f.
    Proof.
      induction l as [| g l IH]; intros leads I is_; [destruct I |]. destruct leads as [is_g leads].
      destruct I as [<- | I].
      - fold best in is_g. rewrite is_ in is_g. destruct l as [| h l]; [now right | left]. injection is_g as <-. cbn.
        tauto.
      - destruct (IH leads I is_) as [F | F]; [left; now right | now right].
    Qed.

    (* Theorem. *)
    Theorem edges_around_are_traced (stack : list segment) : forall earlier, NoDup earlier ->
      incl earlier arrangement -> incl stack arrangement -> is_closed earlier ->
      forall e, In e around -> In e stack -> ~ In e earlier ->
      In e (concat (trace_loops arrangement stack earlier)) \/ best (step_on e) = Some e.
    Proof.
      induction stack as [| g rest IH]; intros earlier once part part_stack closed e E I new; [destruct I |].
      assert (part_rest : incl rest arrangement) by (intros f F; apply part_stack; now right). cbn [trace_loops].
      destruct (in_dec segment_dec g earlier) as [old | new_g].
      { destruct I as [<- | I]; [contradiction |]. now apply IH. }
      pose proof (follow_is arrangement (length arrangement) earlier [g] (best_direction arrangement g)) as path_.
      destruct (follow arrangement _ earlier [g] (best_direction arrangement g)) as [current stopped].
      destruct path_ as (leads & once' & part' & first & stops).
      { cbn [length]. lia. }
      { now constructor. }
      { intros f [<- | F]; [apply part_stack; now left | now apply part]. }
      { intros f is_. now apply (best_direction_is arrangement g). }
      { cbn. now split. }
      assert (closed' : is_closed (current ++ earlier)).
      { intros x y X is_. apply in_app_iff in X. destruct X as [X | X].
        - apply in_rev in X. destruct (goes_on_in _ _ x y leads X is_) as [Y | Y]; [| now apply stops].
          apply in_app_iff. left. now apply in_rev.
        - apply in_app_iff. right. exact (closed x y X is_). }
      rewrite concat_app, in_app_iff.
      destruct (in_dec segment_dec e current) as [C | not_current].
      2: { destruct (IH (current ++ earlier) once' part' part_rest closed' e E) as [T | T]; [| | tauto | tauto].
           - destruct I as [<- | I]; [| exact I]. exfalso. apply not_current, first. now left.
           - rewrite in_app_iff. tauto. }
      pose proof C as C'. apply in_rev, in_split in C'. destruct C' as (before & after & is_).
      pose proof leads as leads'. rewrite is_ in leads'. apply leads_from_the_middle in leads'.
      pose proof (leads_around after e stopped E leads') as stops_at. set (f := iterated step_on _ e) in stops_at.
      assert (F : In f current).
      { specialize (stops f stops_at). apply in_app_iff in stops. destruct stops as [| old]; [assumption | exfalso].
        apply new. exact (comes_around earlier e _ closed E old). }
      destruct (recorded_loops arrangement current earlier stopped f leads once' part' stops_at F)
        as ((some & once_loop & part_loop & leads_loop) & among & F').
      set (loop := record_loop arrangement (length arrangement) f f) in *.
      assert (closed_loop : is_closed loop).
      { intros x y X next_. destruct (goes_on_in _ _ x y leads_loop X next_) as [| at_end]; [assumption |].
        destruct loop as [| z l]; [contradiction |]. injection at_end as ->. now left. }
      pose proof (comes_around loop e _ closed_loop E F') as on_loop.
      unfold recorded. rewrite stops_at. destruct (in_dec segment_dec f current) as [_ | no]; [| contradiction].
      cbv zeta. fold loop. destruct (Nat.eqb_spec (length loop) 2) as [two | other].
      - right. destruct loop as [| x [| y [| z l]]]; try discriminate.
        destruct leads_loop as (x_leads & y_leads & _). cbn [hd_error] in y_leads.
        pose proof (proj2 (step_is e E)) as e_leads. fold best in x_leads, y_leads.
        destruct on_loop as [<- | [<- | []]]; congruence.
      - left. left. cbn [concat]. rewrite app_nil_r. exact on_loop.
    Qed.
  End Around.
End Arrangement.
