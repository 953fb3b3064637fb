(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Which edges of P meet which of -Q + x: three ways to find these pairs, which find the same (Sections 5.1, 5.1.1 and
   5.1.2). All pairs may be tested. Or hierarchies of boxes are built, once, of the edges of P and of those of -Q; for
   each x the second one is moved by x, and where two boxes do not overlap nothing below them is looked at. Or a line is
   swept over all edges, which meets them in the order of their lower ends; each one is tested with those that the line
   still meets. Edges that have a point in common have boxes that overlap there, and so have all boxes around them; and
   the line meets both at the height of the point. *)
From Coq Require Import ZArith Lia Bool List Permutation.
From Oplus Require Import numbers convolution meeting_of_segments regions.
Import ListNotations.

Open Scope Q_scope.

Definition lesser (a b : Q) : Q := if at_most a b then a else b.
Definition greater (a b : Q) : Q := if at_most a b then b else a.

Lemma lesser_is (a b : Q) : lesser a b <= a /\ lesser a b <= b /\ forall c, c <= a -> c <= b -> c <= lesser a b.
Proof. unfold lesser. destruct (at_most_spec a b); repeat split; intros; lra. Qed.

Lemma greater_is (a b : Q) : a <= greater a b /\ b <= greater a b /\ forall c, a <= c -> b <= c -> greater a b <= c.
Proof. unfold greater. destruct (at_most_spec a b); repeat split; intros; lra. Qed.

(* What is between the coordinates of two corners. *)
Record box_of_edges := BoxOfEdges { low_corner : vector; high_corner : vector }.

Definition is_in_box (z : vector) (b : box_of_edges) : Prop :=
  vx (low_corner b) <= vx z <= vx (high_corner b) /\ vy (low_corner b) <= vy z <= vy (high_corner b).

Definition box_of_edge (s : segment) : box_of_edges :=
  BoxOfEdges (Vector (lesser (vx (source s)) (vx (target s))) (lesser (vy (source s)) (vy (target s))))
             (Vector (greater (vx (source s)) (vx (target s))) (greater (vy (source s)) (vy (target s)))).

Definition box_of_two (b c : box_of_edges) : box_of_edges :=
  BoxOfEdges (Vector (lesser (vx (low_corner b)) (vx (low_corner c))) (lesser (vy (low_corner b)) (vy (low_corner c))))
    (Vector (greater (vx (high_corner b)) (vx (high_corner c))) (greater (vy (high_corner b)) (vy (high_corner c)))).

Definition boxes_overlap (b c : box_of_edges) : bool :=
  at_most (vx (low_corner b)) (vx (high_corner c)) && at_most (vx (low_corner c)) (vx (high_corner b)) &&
  at_most (vy (low_corner b)) (vy (high_corner c)) && at_most (vy (low_corner c)) (vy (high_corner b)).

Definition moved_box (x : vector) (b : box_of_edges) : box_of_edges :=
  BoxOfEdges (plus (low_corner b) x) (plus (high_corner b) x).

Lemma edges_are_in_their_boxes (z : vector) (s : segment) : lies_on z s -> is_in_box z (box_of_edge s).
Proof.
  assert (between_ : forall k a b c, 0 <= k <= 1 -> c == (1 - k) * a + k * b -> lesser a b <= c <= greater a b).
  { intros k a b c range c_is. destruct (lesser_is a b) as (l1 & l2 & _), (greater_is a b) as (g1 & g2 & _).
    rewrite c_is. split; nra. }
  intros (k & range & X & Y). unfold is_in_box, box_of_edge. cbn [low_corner high_corner vx vy].
  split; now apply (between_ k).
Qed.

Lemma common_points_in_boxes (z : vector) (b c : box_of_edges) : is_in_box z b -> is_in_box z c ->
  boxes_overlap b c = true.
Proof.
  unfold is_in_box, boxes_overlap. intros ([? ?] & [? ?]) ([? ?] & [? ?]). rewrite !andb_true_iff.
  repeat split; match goal with |- at_most ?a ?b = true => destruct (at_most_spec a b); [reflexivity | exfalso;
    lra] end.
Qed.

(* Hierarchies of boxes. *)
Inductive hierarchy : Type :=
| OneEdge (s : segment)
| TwoParts (b : box_of_edges) (one two : hierarchy).

Definition box_around (t : hierarchy) : box_of_edges :=
  match t with OneEdge s => box_of_edge s | TwoParts b _ _ => b end.

Fixpoint edges_of_hierarchy (t : hierarchy) : list segment :=
  match t with OneEdge s => [s] | TwoParts _ one two => edges_of_hierarchy one ++ edges_of_hierarchy two end.

(* Each box holds the edges below it. *)
Fixpoint is_boxed (t : hierarchy) : Prop :=
  match t with
  | OneEdge _ => True
  | TwoParts b one two => is_boxed one /\ is_boxed two /\
      forall s z, In s (edges_of_hierarchy one ++ edges_of_hierarchy two) -> lies_on z s -> is_in_box z b
  end.

(* One is made from any parts. *)
Definition joined_hierarchies (one two : hierarchy) : hierarchy :=
  TwoParts (box_of_two (box_around one) (box_around two)) one two.

Lemma in_its_box (t : hierarchy) (s : segment) (z : vector) : is_boxed t -> In s (edges_of_hierarchy t) ->
  lies_on z s -> is_in_box z (box_around t).
Proof.
  destruct t as [e | b one two]; cbn [edges_of_hierarchy box_around].
  - intros _ [<- | []]. apply edges_are_in_their_boxes.
  - intros (_ & _ & all). apply all.
Qed.

Lemma joined_is_boxed (one two : hierarchy) : is_boxed one -> is_boxed two -> is_boxed (joined_hierarchies one two).
Proof.
  intros first_ second_. split; [exact first_ |]. split; [exact second_ |]. intros s z S on.
  assert (in_one : is_in_box z (box_around one) \/ is_in_box z (box_around two)).
  { apply in_app_iff in S. destruct S as [S | S]; [left | right]; now apply (in_its_box _ s). }
  unfold is_in_box, box_of_two. cbn [low_corner high_corner vx vy].
  repeat match goal with |- context [lesser ?a ?b] => pose proof (lesser_is a b); set (lesser a b) in *
    | |- context [greater ?a ?b] => pose proof (greater_is a b); set (greater a b) in * end.
  destruct in_one as [[? ?] | [? ?]]; repeat split; lra.
Qed.

Section Pairs.
  (* -Q is moved by x. The test of two edges says yes only if they meet. *)
  Variable x : vector.
  Variable meet : segment -> segment -> bool.
  Definition do_meet (s t : segment) : Prop := exists z, lies_on z s /\ lies_on (minus z x) t.
  Hypothesis meet_is_sound : forall s t, meet s t = true -> do_meet s t.

  Definition all_pairs_tested (of_p of_q : list segment) : list (segment * segment) :=
    filter (fun pair_ => meet (fst pair_) (snd pair_)) (list_prod of_p of_q).

  Fixpoint pairs_by_hierarchy (t : hierarchy) : hierarchy -> list (segment * segment) :=
    fix with_parts (u : hierarchy) : list (segment * segment) :=
      if boxes_overlap (box_around t) (moved_box x (box_around u)) then
        match t, u with
        | TwoParts _ one two, _ => pairs_by_hierarchy one u ++ pairs_by_hierarchy two u
        | OneEdge _, TwoParts _ one two => with_parts one ++ with_parts two
        | OneEdge s, OneEdge f => if meet s f then [(s, f)] else []
        end
      else [].

  Lemma pairs_by_hierarchy_are (t u : hierarchy) : pairs_by_hierarchy t u =
    if boxes_overlap (box_around t) (moved_box x (box_around u)) then
      match t, u with
      | TwoParts _ one two, _ => pairs_by_hierarchy one u ++ pairs_by_hierarchy two u
      | OneEdge _, TwoParts _ one two => pairs_by_hierarchy t one ++ pairs_by_hierarchy t two
      | OneEdge s, OneEdge f => if meet s f then [(s, f)] else []
      end
    else [].
  Proof. now destruct t, u. Qed.

  Lemma boxes_of_edges_that_meet (t u : hierarchy) (s f : segment) : is_boxed t -> is_boxed u ->
    In s (edges_of_hierarchy t) -> In f (edges_of_hierarchy u) -> meet s f = true ->
    boxes_overlap (box_around t) (moved_box x (box_around u)) = true.
  Proof.
    intros T U S F yes. destruct (meet_is_sound s f yes) as (z & on_s & on_f).
    apply (common_points_in_boxes z); [exact (in_its_box t s z T S on_s) |].
    pose proof (in_its_box u f (minus z x) U F on_f) as in_. unfold is_in_box, moved_box, minus, plus in *.
    cbn [low_corner high_corner vx vy] in *. lra.
  Qed.

  Lemma pairs_of_hierarchies (t u : hierarchy) : is_boxed t -> is_boxed u -> forall s f,
    In (s, f) (pairs_by_hierarchy t u) <-> In (s, f) (all_pairs_tested (edges_of_hierarchy t) (edges_of_hierarchy u)).
  Proof.
    intros T U s f. unfold all_pairs_tested. rewrite filter_In, in_prod_iff. cbn [fst snd]. revert u T U.
    induction t as [e | b one IH_one two IH_two]; intros u T U.
    - induction u as [g | c one IH_one two IH_two]; rewrite pairs_by_hierarchy_are.
      + pose proof (boxes_of_edges_that_meet (OneEdge e) (OneEdge g) e g T U (or_introl eq_refl) (or_introl eq_refl))
        as far.
        assert (ends : (In s [e] /\ In f [g]) /\ meet s f = true <-> (e = s /\ g = f) /\ meet e g = true).
        { cbn [In]. split; [intros [[[<- | []] [<- | []]] yes] | intros [[<- <-] yes]]; tauto. }
        cbn [edges_of_hierarchy]. rewrite ends. clear ends.
        destruct (boxes_overlap _ _), (meet e g); cbn [In].
        * split; [intros [[= <- <-] | []]; tauto | intros [[-> ->] _]; now left].
        * split; [intros [] | intros [_ no]; discriminate].
        * split; [intros [] | intros _; discriminate (far eq_refl)].
        * split; [intros [] | intros [_ no]; discriminate].
      + pose proof (boxes_of_edges_that_meet (OneEdge e) (TwoParts c one two) s f T U) as far.
        destruct U as (U_one & U_two & _). specialize (IH_one U_one). specialize (IH_two U_two).
        cbn [edges_of_hierarchy] in *. rewrite in_app_iff in *.
        destruct (boxes_overlap _ _); [rewrite in_app_iff; tauto |].
        split; [intros [] | intros [[S F] yes]; discriminate (far S F yes)].
    - rewrite pairs_by_hierarchy_are.
      pose proof (boxes_of_edges_that_meet (TwoParts b one two) u s f T U) as far.
      destruct T as (T_one & T_two & _). specialize (IH_one u T_one U). specialize (IH_two u T_two U).
      cbn [edges_of_hierarchy] in *. rewrite in_app_iff in *.
      destruct (boxes_overlap _ _); [rewrite in_app_iff; tauto |].
      split; [intros [] | intros [[S F] yes]; discriminate (far S F yes)].
  Qed.

  (* The sweep: edges of P, and of -Q moved by x, each with the list it is of, in the order of their lower ends. *)
  Definition swept_edge : Type := (bool * segment)%type.
  Definition low_end (e : swept_edge) : Q :=
    vy (low_corner (if fst e then box_of_edge (snd e) else moved_box x (box_of_edge (snd e)))).
  Definition high_end (e : swept_edge) : Q :=
    vy (high_corner (if fst e then box_of_edge (snd e) else moved_box x (box_of_edge (snd e)))).

  Definition pair_of (e f : swept_edge) : list (segment * segment) :=
    match e, f with
    | (true, s), (false, t) | (false, t), (true, s) => if meet s t then [(s, t)] else []
    | _, _ => []
    end.

  Fixpoint pairs_by_sweep (events met : list swept_edge) : list (segment * segment) :=
    match events with
    | [] => []
    | e :: rest =>
        let still_met := filter (fun f => at_most (low_end e) (high_end f)) met in
        flat_map (pair_of e) still_met ++ pairs_by_sweep rest (e :: still_met)
    end.

  Definition are_swept_upwards (events : list swept_edge) : Prop :=
    ForallOrdPairs (fun e f => low_end e <= low_end f) events.

  Lemma edges_that_meet_are_met_together (s t : segment) : meet s t = true ->
    low_end (true, s) <= high_end (false, t) /\ low_end (false, t) <= high_end (true, s).
  Proof.
    intros yes. destruct (meet_is_sound s t yes) as (z & on_s & on_t).
    apply edges_are_in_their_boxes in on_s, on_t. unfold is_in_box, minus in *. cbn [vx vy] in *.
    unfold low_end, high_end. cbn [fst snd moved_box low_corner high_corner plus vx vy] in *. lra.
  Qed.

  Lemma pair_is (e f : swept_edge) (s t : segment) : In (s, t) (pair_of e f) <->
    meet s t = true /\ (e = (true, s) /\ f = (false, t) \/ e = (false, t) /\ f = (true, s)).
  Proof.
    destruct e as [[] e], f as [[] f]; cbn [pair_of];
      try (split; [intros [] | intros (_ & [[? ?] | [? ?]]); discriminate]).
    - destruct (meet e f) eqn:yes; cbn [In]; split; try (intros [[= <- <-] | []]; tauto); try easy.
      + intros (_ & [[[= ->] [= ->]] | [? ?]]); [now left | discriminate].
      + intros (no & [[[= ->] [= ->]] | [? ?]]); [congruence | discriminate].
    - destruct (meet f e) eqn:yes; cbn [In]; split; try (intros [[= <- <-] | []]; tauto); try easy.
      + intros (_ & [[? ?] | [[= ->] [= ->]]]); [discriminate | now left].
      + intros (no & [[? ?] | [[= ->] [= ->]]]); [discriminate | congruence].
  Qed.

  (* Those met are all that may meet what comes. *)
  Lemma sweep_finds (s t : segment) : meet s t = true -> forall events met, are_swept_upwards events ->
    (In (s, t) (pairs_by_sweep events met) <->
     (In (true, s) events \/ In (true, s) met) /\ (In (false, t) events \/ In (false, t) met) /\
     (In (true, s) events \/ In (false, t) events)).
  Proof.
    intros yes. destruct (edges_that_meet_are_met_together s t yes) as [low_s low_t].
    induction events as [| e rest IH]; intros met order; [cbn; tauto |]. inversion order as [| ? ? first_ order'];
      subst.
    rewrite Forall_forall in first_. cbn [pairs_by_sweep]. rewrite in_app_iff, in_flat_map, (IH _ order'). cbn [In].
    set (still := filter (fun f => at_most (low_end e) (high_end f)) met).
    assert (still_is : forall f, In f still <-> In f met /\ low_end e <= high_end f).
    { intros f. unfold still. rewrite filter_In. destruct (at_most_spec (low_end e) (high_end f));
      intuition discriminate. }
    assert (found : (exists f, In f still /\ In (s, t) (pair_of e f)) <->
      e = (true, s) /\ In (false, t) met \/ e = (false, t) /\ In (true, s) met).
    { split.
      - intros (f & F & pair_). apply still_is in F. apply pair_is in pair_.
        destruct pair_ as (_ & [[-> ->] | [-> ->]]); tauto.
      - intros [[-> F] | [-> F]]; [exists (false, t) | exists (true, s)]; rewrite still_is, pair_is; tauto. }
    assert (keeps_s : In (false, t) rest -> (In (true, s) still <-> In (true, s) met)).
    { intros later. rewrite still_is. specialize (first_ _ later). intuition lra. }
    assert (keeps_t : In (true, s) rest -> (In (false, t) still <-> In (false, t) met)).
    { intros later. rewrite still_is. specialize (first_ _ later). intuition lra. }
    rewrite found. clear found order order' IH first_ still_is. intuition (subst; try congruence; tauto).
  Qed.

  Lemma pairs_of_sweeps (of_p of_q : list segment) (events : list swept_edge) : are_swept_upwards events ->
    Permutation events (map (pair true) of_p ++ map (pair false) of_q) -> forall s f,
    In (s, f) (pairs_by_sweep events []) <-> In (s, f) (all_pairs_tested of_p of_q).
  Proof.
    intros order all s f. unfold all_pairs_tested. rewrite filter_In, in_prod_iff. cbn [fst snd].
    assert (in_events : (In (true, s) events <-> In s of_p) /\ (In (false, f) events <-> In f of_q)).
    { assert (same_ : forall e, In e events <-> In e (map (pair true) of_p ++ map (pair false) of_q))
        by (intros e; split; apply Permutation_in; [exact all | now symmetry]).
      rewrite !same_, !in_app_iff, !in_map_iff. split; split; try (intros [(g & [=] & G) | (g & [=] & G)]; now subst);
        intros I; [left; now exists s | right; now exists f]. }
    destruct (meet s f) eqn:yes.
    - rewrite (sweep_finds s f yes events [] order). cbn [In]. tauto.
    - split; [| now intros [_ no]]. assert (none : forall events met, ~ In (s, f) (pairs_by_sweep events met)).
      { clear - yes. induction events as [| e rest IH]; intros met; cbn [pairs_by_sweep]; [tauto |].
        rewrite in_app_iff, in_flat_map. intros [(g & _ & pair_) | later]; [| exact (IH _ later)].
        apply pair_is in pair_. destruct pair_ as [no _]. congruence. }
      intros found. destruct (none _ _ found).
  Qed.
End Pairs.

(* Theorem. *)
Theorem hierarchies_find_all_pairs (x : vector) (meet : segment -> segment -> bool) (t u : hierarchy) :
  (forall s f, meet s f = true -> do_meet x s f) -> is_boxed t -> is_boxed u -> forall s f,
  In (s, f) (pairs_by_hierarchy x meet t u) <->
  In (s, f) (all_pairs_tested meet (edges_of_hierarchy t) (edges_of_hierarchy u)).
Proof. intros sound. exact (pairs_of_hierarchies x meet sound t u). Qed.

(* Theorem. *)
Theorem sweep_finds_all_pairs (x : vector) (meet : segment -> segment -> bool) (of_p of_q : list segment)
    (events : list swept_edge) :
  (forall s f, meet s f = true -> do_meet x s f) -> are_swept_upwards x events ->
  Permutation events (map (pair true) of_p ++ map (pair false) of_q) -> forall s f,
  In (s, f) (pairs_by_sweep x meet events []) <-> In (s, f) (all_pairs_tested meet of_p of_q).
Proof. intros sound. exact (pairs_of_sweeps x meet sound of_p of_q events). Qed.
