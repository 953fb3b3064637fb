(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Walks that turn clockwise most (walks.v), along segments that have nothing but ends in common and a set on their left
   only: each goes around one face of what is not in the set. So what closed chains of these segments do on the right of
   a walk is the same all along. Proof: clockwise most, the next ray at a vertex is a segment that leaves, since one
   that enters has the set where the last one has not; it follows one segment only; so each walk takes what follows. *)
From Coq Require Import QArith Lqa ZArith Lia Bool List Permutation.
From Oplus Require Import balanced_edges direction angle angular_crossings winding_number shifted_ray rotation
  in_out_degree regions meeting_of_segments interiors_meet neighbourhoods location pieces naive_collision
  collision_is_sound beside_a_piece filling cut_pieces kept_pieces_go_round walks beside_a_vertex.
Import ListNotations.

Open Scope Q_scope.

Lemma is_met_between_spec (b g u : vector) : reflect (met_between b g u) (is_met_between b g u).
Proof.
  assert (flip : forall x y, cross x y == - cross y x) by (intros; unfold cross; ring).
  apply iff_reflect. unfold met_between, is_met_between. rewrite (flip b g), (flip b u), (flip u g).
  destruct (negative_spec (cross g b)), (negative_spec (cross u b)), (negative_spec (cross g u)); cbn;
    (split; [intros; try reflexivity; exfalso; lra | intros; try discriminate; lra]).
Qed.

(* Directions that differ. *)
Definition differ (u w : vector) : Prop := cross u w == 0 -> dot u w < 0.

(* In terms of the signs of b x u and the like. *)
Ltac signs_of b g :=
  let s := fresh "s" in destruct (Q_dec (cross b g) 0) as [[s | s] | s].

Lemma parallel_sides (b f g : vector) : cross f g == 0 -> dot f g < 0 -> ~ (0 < cross b f /\ 0 < cross b g) /\
  ~ (cross b f < 0 /\ cross b g < 0).
Proof.
  intros line back. assert (value : cross b f * dot g g == cross b g * dot f g).
  { assert (cross b f * dot g g == cross b g * dot f g - dot b g * cross f g) as -> by (unfold cross, dot; ring).
    rewrite line. ring. }
  assert (0 <= dot g g) by (unfold dot; pose proof (squares_are_not_negative (vx g) (vy g)); lra).
  split; intros [F G]; nra.
Qed.

Lemma opposite_of_both (b f g : vector) : nonzero b -> cross b f == 0 -> cross b g == 0 -> dot b f < 0 -> dot b g < 0 ->
  cross f g == 0 /\ 0 < dot f g.
Proof.
  intros long F G back_f back_g. pose proof (square_positive b long) as square.
  assert (one : dot b b * cross f g == 0).
  { assert (dot b b * cross f g == dot b f * cross b g - dot b g * cross b f) as -> by (unfold cross, dot; ring).
    rewrite F, G. ring. }
  assert (two : dot b b * dot f g == dot b f * dot b g).
  { assert (dot b b * dot f g == dot b f * dot b g + cross b f * cross b g) as -> by (unfold cross, dot; ring).
    rewrite F, G. ring. }
  split; [apply (Qmult_inj_l _ _ (dot b b)); lra |]. assert (0 < dot b f * dot b g) by nra. nra.
Qed.

Lemma in_one_line (b f g : vector) : cross f g == 0 -> cross b f == 0 -> dot b f < 0 -> cross b g == 0.
Proof.
  intros one two back. assert (value : cross b g * dot f f == 0).
  { assert (cross b g * dot f f == cross b f * dot g f + dot b f * cross f g) as -> by (unfold cross, dot; ring).
    rewrite one, two. ring. }
  apply Qmult_integral in value. destruct value as [| none]; [assumption | exfalso].
  unfold dot in *. destruct (no_squares (vx f) (vy f)) as [X Y]; [lra |]. rewrite X, Y in back. lra.
Qed.

Lemma one_is_met (b f g : vector) : nonzero b -> differ b f -> differ b g -> differ f g ->
  ~ met_between b f g -> met_between b g f.
Proof.
  unfold met_between. intros long bf bg fg none. assert (flip : cross g f == - cross f g) by (unfold cross; ring).
  signs_of b f; signs_of b g; signs_of f g; try lra; exfalso.
  all: try (destruct (parallel_sides b f g ltac:(lra) (fg ltac:(lra))); lra).
  all: try (pose proof (in_one_line b f g ltac:(lra) ltac:(lra) (bf ltac:(lra))); lra).
  all: try (pose proof (in_one_line b g f ltac:(lra) ltac:(lra) (bg ltac:(lra))); lra).
  all: destruct (opposite_of_both b f g long) as [line ahead]; try lra; try (now apply bf); try (now apply bg).
  all: specialize (fg line); lra.
Qed.

Lemma one_comes_first (b g u : vector) : nonzero b -> nonzero u -> differ b g -> differ u g -> differ b u ->
  met_between b g u \/ met_between u g b.
Proof.
  unfold met_between. intros long long_u bg ug bu. assert (flip : cross u b == - cross b u) by (unfold cross; ring).
  signs_of b g; signs_of u g; signs_of b u; try lra; exfalso.
  all: assert (back : dot b u < 0) by (now apply bu).
  all: assert (flip_b : cross g b == - cross b g) by (unfold cross; ring).
  all: assert (flip_u : cross g u == - cross u g) by (unfold cross; ring).
  all: assert (back' : dot u b < 0) by (unfold dot in *; lra).
  all: try (destruct (parallel_sides g b u ltac:(lra) back); lra).
  all: try (pose proof (in_one_line u b g ltac:(lra) ltac:(lra) back'); lra).
  all: try (pose proof (in_one_line b u g ltac:(lra) ltac:(lra) back); lra).
  all: destruct (opposite_of_both b u g long) as [line ahead]; try lra; try (now apply bg).
  all: specialize (ug line); lra.
Qed.

Lemma met_before_met (b a u w : vector) : nonzero b -> differ b a -> differ b u -> differ b w ->
  met_between b u w -> met_between b a u -> met_between b a w.
Proof.
  unfold met_between. intros long ba bu bw one two. pose proof (square_positive b long) as square.
  assert (value : cross b u * cross w a == cross b w * cross u a + cross b a * cross w u) by (unfold cross; ring).
  assert (on_u : dot b b * cross w u == dot b w * cross b u - cross b w * dot b u) by (unfold cross, dot; ring).
  assert (on_a : cross u a * dot w w == - cross w u * dot a w - dot u w * cross a w) by (unfold cross, dot; ring).
  signs_of b a; signs_of b u; signs_of b w; try lra.
  all: try (right; split; [lra |]; right; nra).
  all: try (left; repeat split; [lra | lra | nra]).
  all: exfalso.
  all: try (specialize (bu ltac:(lra)); nra).
  all: destruct (opposite_of_both b a w long) as [line ahead]; try lra; try (now apply ba); try (now apply bw).
  all: rewrite line in on_a; assert (0 <= dot w w) by (unfold dot; pose proof (squares_are_not_negative (vx w) (vy
    w)); lra);
    nra.
Qed.

Section Walks.
  Variable segments : list segment.
  Hypothesis long : forall e, In e segments -> nonzero (along e).
  Hypothesis apart : forall e f w, In e segments -> In f segments -> e <> f -> lies_on w f -> ~ strictly_inside w e.
  Hypothesis same_ends : forall e f v w, In e segments -> In f segments ->
    v = source e \/ v = target e -> w = source f \/ w = target f -> equal_vectors v w -> v = w.
  Hypothesis balanced : is_balanced segments.
  Hypothesis closed : cycles segments.
  Hypothesis right_is_outside : forall e, In e segments -> winding_number_shifted (right_of_middle e) segments = 0%Z.
  Hypothesis left_is_inside : forall e, In e segments ->
    winding_number_shifted (right_of_middle (reversed e)) segments <> 0%Z.

  Let directed := directed segments.

  Lemma rays_differ (s t : segment) : directed s -> directed t -> source s = source t -> s <> t ->
    differ (along s) (along t).
  Proof.
    intros S T starts other line. pose proof (directed_is_long segments long s S) as long_s.
    pose proof (directed_is_long segments long t T) as long_t.
    destruct (is_a_multiple (along s) (along t) long_s line) as (c & cx & cy).
    pose proof (square_positive _ long_s) as square. apply Qnot_le_lt. intros ahead.
    assert (some : 0 < c).
    { assert (value : dot (along s) (along t) == c * dot (along s) (along s)) by (unfold dot; rewrite cx, cy; ring).
      rewrite value in ahead. destruct (Qlt_le_dec 0 c) as [| none]; [assumption | exfalso].
      assert (c_is : c == 0) by nra. apply long_t. rewrite cx, cy, c_is. split; ring. }
    assert (h_is : exists h, 0 < h /\ h < 1 /\ h < c).
    { destruct (Qlt_le_dec 1 c); [exists (1 # 2) | exists ((1 # 2) * c)]; lra. }
    destruct h_is as (h & h_some & h_less & h_c).
    set (w := moved_along (source s) (along s) h).
    assert (in_s : strictly_inside w s).
    { exists h. split; [lra |]. unfold w, moved_along, along, minus. cbn [vx vy]. split; ring. }
    assert (in_t : strictly_inside w t).
    { assert (value : h / c * c == h) by (field; lra). exists (h / c).
      split; [split; [apply Qlt_shift_div_l | apply Qlt_shift_div_r]; lra |].
      set (k := h / c) in *. clearbody k. unfold w, moved_along. cbn [vx vy].
      assert (tx : vx (target t) == vx (source t) + c * vx (along s)) by (rewrite <- cx; unfold along, minus; cbn
        [vx]; ring).
      assert (ty : vy (target t) == vy (source t) + c * vy (along s)) by (rewrite <- cy; unfold along, minus; cbn
        [vy]; ring).
      rewrite tx, ty, starts, <- value. split; ring. }
    assert (of : forall u : segment, directed u -> exists e, In e segments /\ (u = e \/ u = reversed e) /\
      (strictly_inside w u -> strictly_inside w e)).
    { intros u [U | U]; [exists u; tauto |]. exists (reversed u). split; [exact U |].
      split; [right; now rewrite reversed_twice | apply strictly_inside_reversed]. }
    destruct (of s S) as (e & E & s_is & in_e), (of t T) as (f & F & t_is & in_f).
    destruct (segment_dec e f) as [<- | differ_].
    - assert (turned : s = reversed t).
      { destruct s_is as [-> | ->], t_is as [-> | ->]; try contradiction; try reflexivity. now rewrite reversed_twice. }
      apply long_s. unfold along, minus. cbn [vx vy]. rewrite turned in *. cbn [reversed source target] in *.
      rewrite starts. split; ring.
    - apply (apart e f w E F differ_); [apply strictly_inside_lies_on |]; auto.
  Qed.

  (* What follows a segment clockwise most. *)
  Definition follows (e f : segment) : Prop := In f segments /\ source f = target e /\
    forall s, directed s -> source s = target e -> ~ met_between (minus (source e) (target e)) (along f) (along s).

  Lemma way_back (e : segment) : equal_vectors (minus (source e) (target e)) (along (reversed e)).
  Proof. unfold minus, along, reversed, minus. cbn [source target]. split; reflexivity. Qed.

  Lemma not_turned (e f : segment) : In e segments -> In f segments -> f <> reversed e.
  Proof.
    intros E F ->. apply (apart e (reversed e) (middle e) E F).
    - intros equal. apply (long e E). apply (f_equal source) in equal. cbn [reversed source] in equal.
      unfold along, minus. cbn [vx vy]. rewrite <- equal. split; ring.
    - apply strictly_inside_lies_on, strictly_inside_reversed, middle_is_inside.
    - apply middle_is_inside.
  Qed.

  Lemma one_follows (e : segment) : In e segments -> exists f, follows e f.
  Proof.
    intros E. set (v := target e). set (b := minus (source e) v).
    assert (back_is : directed (reversed e)) by (right; now rewrite reversed_twice).
    assert (b_long : nonzero b) by (apply (directed_is_long segments long _ back_is)).
    set (is_ray := fun s => if vector_dec (source s) v then if segment_dec s (reversed e) then false else true else
      false).
    set (rays := filter is_ray (segments ++ map reversed segments)).
    assert (rays_are : forall s, In s rays <-> directed s /\ source s = v /\ s <> reversed e).
    { intros s. unfold rays, is_ray. rewrite filter_In, in_app_iff, in_map_iff. unfold directed,
      beside_a_vertex.directed.
      split.
      - intros [which test]. destruct (vector_dec (source s) v); [| discriminate].
        destruct (segment_dec s (reversed e)); [discriminate |]. split; [| tauto].
        destruct which as [S | (t & <- & T)]; [now left | right; now rewrite reversed_twice].
      - intros (which & starts & other). destruct (vector_dec (source s) v); [| contradiction].
        destruct (segment_dec s (reversed e)); [contradiction |]. split; [| reflexivity].
        destruct which as [S | S]; [now left | right]. exists (reversed s). split; [apply reversed_twice | exact S]. }
    assert (away : forall s, In s rays -> differ b (along s)).
    { intros s S. apply rays_are in S. destruct S as (S & starts & other).
      apply (rays_differ (reversed e) s back_is S); [now symmetry | congruence]. }
    assert (least : forall l, incl l rays -> l <> [] -> exists f, In f l /\ forall s, In s l -> ~ met_between b
      (along f) (along s)).
    { induction l as [| s l IH]; intros part some; [contradiction |]. destruct l as [| t l].
      - exists s. split; [now left |]. intros u [<- | []]. unfold met_between, cross. lra.
      - destruct IH as (f & F & none); [intros u U; apply part; now right | discriminate |].
        destruct (is_met_between_spec b (along f) (along s)) as [met | not_met].
        + exists s. split; [now left |]. intros u [<- | U] met'; [unfold met_between, cross in met'; lra |].
          apply (none u U). apply (met_before_met b (along f) (along s) (along u)); trivial; apply away, part; cbn;
            tauto.
        + exists f. split; [now right |]. intros u [<- | U]; auto. }
    assert (some : rays <> []).
    { destruct (in_split _ _ E) as (before & after & is_). specialize (balanced v).
      rewrite (surplus_permuted v segments (e :: before ++ after)), surplus_of_more in balanced
        by (rewrite is_; symmetry; apply Permutation_middle).
      assert (source e <> v).
      { intros equal. apply (long e E). unfold along, minus. cbn [vx vy]. fold v. rewrite equal. split; ring. }
      unfold one_if in balanced. destruct (vector_dec (source e) v); [contradiction |].
      destruct (vector_dec (target e) v); [| now destruct n0].
      destruct (something_leaves v (before ++ after)) as (f & F & starts); [lia |].
      assert (In f segments) by (rewrite is_; apply in_app_iff; apply in_app_iff in F; cbn; tauto).
      intros none. apply (in_nil (a := f)). rewrite <- none. apply rays_are.
      split; [now left |]. split; [exact starts |]. now apply not_turned. }
    destruct (least rays (incl_refl _) some) as (f & F & first). pose proof (away f F) as away_f.
    apply rays_are in F. destruct F as (F & starts & other).
    assert (all : forall s, directed s -> source s = v -> ~ met_between b (along f) (along s)).
    { intros s S starts_s met. destruct (segment_dec s (reversed e)) as [-> | other_s].
      - destruct (way_back e) as [X Y]. fold v b in X, Y. unfold met_between, cross in met. rewrite <- X, <- Y in met.
        unfold differ, cross, dot in away_f. lra.
      - apply (first s); [now apply rays_are | exact met]. }
    exists f. destruct F as [F | entering]; [now split |]. exfalso.
    apply (left_is_inside (reversed f) entering). rewrite reversed_twice, <- (right_is_outside e E). symmetry.
    apply (nothing_between segments long apart same_ends v ltac:(exists e; split; [exact E | now right]) segments e f);
      trivial; [apply incl_refl | now left | now right].
  Qed.

  Lemma away (e s : segment) : In e segments -> directed s -> source s = target e -> s <> reversed e ->
    differ (minus (source e) (target e)) (along s).
  Proof.
    intros E S starts other. refine (rays_differ (reversed e) s _ S _ _); [right; now rewrite reversed_twice | now
      symmetry |].
    congruence.
  Qed.

  Lemma back_is_long (e : segment) : In e segments -> nonzero (minus (source e) (target e)).
  Proof. intros E. apply (directed_is_long segments long (reversed e)). right. now rewrite reversed_twice. Qed.

  (* It is chosen before all others. *)
  Lemma chosen_first (e f g : segment) : In e segments -> follows e f -> In g segments -> source g = target e -> g <>
    f ->
    turns_more e f g = true /\ turns_more e g f = false.
  Proof.
    intros E (F & starts & first) G starts_g other. pose proof (first g (or_introl G) starts_g) as none.
    unfold turns_more. rewrite negb_true_iff, negb_false_iff. split.
    - destruct (is_met_between_spec (minus (source e) (target e)) (along f) (along g)); [contradiction | reflexivity].
    - destruct (is_met_between_spec (minus (source e) (target e)) (along g) (along f)) as [| no]; [reflexivity |].
      exfalso. apply no, one_is_met; trivial.
      + now apply back_is_long.
      + apply away; trivial; [now left | now apply not_turned].
      + apply away; trivial; [now left | now apply not_turned].
      + apply rays_differ; [now left | now left | congruence | congruence].
  Qed.

  Lemma follows_one (e e' f : segment) : In e segments -> In e' segments -> follows e f -> follows e' f -> e = e'.
  Proof.
    intros E E' (F & starts & first) (_ & starts' & first'). destruct (segment_dec e e') as [| other]; [assumption |
      exfalso].
    assert (same_end : target e = target e') by congruence.
    assert (turned : reversed e <> reversed e').
    { intros equal. apply other. rewrite <- (reversed_twice e), equal. apply reversed_twice. }
    assert (D : directed (reversed e)) by (right; now rewrite reversed_twice).
    assert (D' : directed (reversed e')) by (right; now rewrite reversed_twice).
    destruct (one_comes_first (minus (source e) (target e)) (along f) (minus (source e') (target e'))) as [met | met].
    - now apply back_is_long.
    - now apply back_is_long.
    - apply away; trivial; [now left | now apply not_turned].
    - apply away; trivial; [now left | now apply not_turned].
    - exact (rays_differ _ _ D D' same_end turned).
    - apply (first (reversed e') D'); [now symmetry | exact met].
    - apply (first' (reversed e) D); [exact same_end | exact met].
  Qed.

  Lemma next_follows (e f : segment) (l : list segment) : In e segments -> follows e f -> incl l segments -> In f l ->
    exists others, next_and_others e l = Some (f, others).
  Proof.
    intros E next_. pose proof next_ as (F & starts & _). induction l as [| g l IH]; intros part I; [destruct I |].
    assert (part_l : incl l segments) by (intros s S; apply part; now right). cbn [next_and_others].
    destruct (segment_dec g f) as [-> | other].
    - destruct (vector_dec (source f) (target e)); [| contradiction]. destruct (next_and_others e l) as [[h others]
      |] eqn:rest;
        [| now exists l]. apply next_is in rest. destruct rest as [starts_h permuted]. cbn [andb].
      destruct (segment_dec h f) as [-> | other]; [destruct (turns_more e f f); eexists; reflexivity |].
      destruct (chosen_first e f h E next_) as [-> _]; [| exact starts_h | exact other | now exists l].
      apply part_l, (Permutation_in _ permuted). now left.
    - destruct I as [-> | I]; [contradiction |]. destruct (IH part_l I) as (others & ->).
      destruct (vector_dec (source g) (target e)) as [starts_g |]; [| now exists (g :: others)]. cbn [andb].
      destruct (chosen_first e f g E next_) as [_ ->]; trivial; [apply part; now left | now exists (g :: others)].
  Qed.

  (* From each to what follows, and from the last one to z. *)
  Fixpoint linked (e : segment) (l : list segment) (z : segment) : Prop :=
    match l with [] => follows e z | f :: rest => follows e f /\ linked f rest z end.

  Definition is_whole (l : list segment) : Prop := forall e f, In e l -> follows e f -> In f l.

  Lemma walk_takes_what_follows (fuel : nat) (first : segment) : In first segments -> forall before l,
    (length l <= fuel)%nat -> In before segments -> incl l segments -> NoDup l -> ~ In before l -> ~ In first l ->
    (forall e f, e = before \/ In e l -> follows e f -> f = first \/ In f l) ->
    let (chain, others) := walk fuel first before l in
    linked before (path chain (source first)) first /\ hd (source first) chain = target before /\
    incl others l /\ NoDup others /\ is_whole others.
  Proof.
    intros First. assert (stop : forall before l, In before segments -> incl l segments -> NoDup l -> ~ In before l ->
      (forall e f, e = before \/ In e l -> follows e f -> f = first \/ In f l) -> follows before first ->
      linked before (path [] (source first)) first /\ hd (source first) [] = target before /\
      incl l l /\ NoDup l /\ is_whole l).
    { intros before l B part distinct_ new all next_. split; [exact next_ |]. split; [apply next_ |].
      split; [apply incl_refl |]. split; [exact distinct_ |]. intros e f E follows_.
      destruct (all e f (or_intror E) follows_) as [-> |]; [| assumption].
      exfalso. apply new. now rewrite (follows_one before e first B (part e E) next_ follows_). }
    induction fuel as [| fuel IH]; intros before l few B part distinct_ new new_first all;
      destruct (one_follows before B) as (f & next_); pose proof (all before f (or_introl eq_refl) next_) as which.
    - destruct l; [| cbn in few; lia]. cbn [walk]. destruct which as [-> | []]. now apply stop.
    - cbn [walk]. destruct (segment_dec f first) as [-> | other].
      + destruct (next_and_others before l) as [[e rest] |] eqn:chosen; [| now apply stop].
        apply next_is in chosen. destruct chosen as [starts permuted].
        assert (I : In e l) by (apply (Permutation_in _ permuted); now left).
        destruct (vector_dec (target before) (source first)) as [| no]; [| destruct no; symmetry; apply next_].
        destruct (chosen_first before first e B next_ (part e I) starts) as [-> _]; [congruence |]. now apply stop.
      + destruct which as [| I]; [contradiction |].
        destruct (next_follows before f l B next_ part I) as (rest & chosen). rewrite chosen.
        apply next_is in chosen. destruct chosen as [starts permuted].
        assert (closes : (if vector_dec (target before) (source first) then turns_more before first f else false) =
          false).
        { destruct (vector_dec (target before) (source first)) as [ends_ |]; [| reflexivity].
          apply (chosen_first before f first B next_ First); [now symmetry | congruence]. }
        rewrite closes. pose proof (Permutation_NoDup (Permutation_sym permuted) distinct_) as both.
        inversion both as [| ? ? new_f distinct_rest]; subst.
        assert (rest_in : forall e, In e rest -> In e l) by (intros e R; apply (Permutation_in _ permuted); now right).
        specialize (IH f rest). destruct (walk fuel first f rest) as [chain others].
        destruct IH as (linked_ & head & incl_ & more).
        * apply Permutation_length in permuted. cbn in permuted. lia.
        * now apply part.
        * intros e R. now apply part, rest_in.
        * exact distinct_rest.
        * exact new_f.
        * intros R. now apply new_first, rest_in.
        * intros e g which follows_. assert (in_l : In e l) by (destruct which as [-> | R]; auto).
          destruct (all e g (or_intror in_l) follows_) as [-> | G]; [now left |].
          apply (Permutation_in _ (Permutation_sym permuted)) in G. destruct G as [<- | G]; [| now right].
          exfalso. apply new. now rewrite (follows_one before e f B (part e in_l) next_ follows_).
        * cbn [path hd]. rewrite head. split; [split; [| destruct f; exact linked_] |].
          -- destruct f; exact next_.
          -- split; [exact starts |]. split; [intros e R; now apply rest_in, incl_ | exact more].
  Qed.

  (* Theorem. In each chain each edge follows the one before, the first one the last. *)
  Theorem chains_are_linked (fuel : nat) : forall l, incl l segments -> NoDup l -> is_whole l ->
    forall chain, In chain (chains_of fuel l) -> exists e rest, edges chain = e :: rest /\ In e segments /\ linked e
      rest e.
  Proof.
    induction fuel as [| fuel IH]; intros l part distinct_ whole chain C; [destruct C |].
    destruct l as [| e l]; [destruct C |]. cbn [chains_of] in C. inversion distinct_ as [| ? ? new distinct_l]; subst.
    pose proof (walk_takes_what_follows (length l) e (part e (or_introl eq_refl)) e l (le_n _) (part e (or_introl
      eq_refl))
      (fun s S => part s (or_intror S)) distinct_l new new) as taken.
    destruct (walk (length l) e e l) as [vertices others].
    destruct taken as (linked_ & head & incl_ & distinct_others & whole_others).
    { intros a f which follows_. destruct (whole a f) as [<- | F]; [destruct which as [-> | A]; [now left | now right] |
        exact follows_ | now left | now right]. }
    destruct C as [<- | C].
    - exists e, (path vertices (source e)). split; [| split; [apply part; now left | exact linked_]].
      change (edges (source e :: vertices) = e :: path vertices (source e)).
      transitivity (path (source e :: vertices) (source e)); [rewrite path_is; reflexivity |].
      cbn [path]. rewrite head. now destruct e.
    - apply (IH others); trivial. intros s S. apply part. right. now apply incl_.
  Qed.

  Corollary linked_all (chain : list vector) : In chain (chains_of (length segments) segments) -> NoDup segments ->
    exists e rest, edges chain = e :: rest /\ In e segments /\ linked e rest e.
  Proof.
    intros C distinct_. apply (chains_are_linked (length segments) segments (incl_refl _) distinct_); [| exact C].
    intros e f _ follows_. apply follows_.
  Qed.

  (* Theorem. On the right of a chain closed chains of the segments have one winding number. *)
  Theorem same_on_the_right (part : list segment) (chain : list vector) (e f : segment) : NoDup segments ->
    In chain (chains_of (length segments) segments) -> incl part segments -> cycles part ->
    In e (edges chain) -> In f (edges chain) ->
    winding_number_shifted (right_of_middle e) part = winding_number_shifted (right_of_middle f) part.
  Proof.
    intros distinct_ C incl_ cycles_. destruct (linked_all chain C distinct_) as (first & rest & -> & First & linked_).
    assert (step : forall a b, In a segments -> follows a b ->
      winding_number_shifted (right_of_middle a) part = winding_number_shifted (right_of_middle b) part).
    { intros a b A follows_. pose proof follows_ as (B & starts & none).
      apply (nothing_between segments long apart same_ends (target a) ltac:(exists a; split; [exact A | now right])
        part a b incl_ cycles_ (or_introl A) (or_introl B) eq_refl starts); [| exact none].
      apply away; trivial; [now left | now apply not_turned]. }
    assert (all : forall l a, In a segments -> linked a l first -> forall b, In b l ->
      winding_number_shifted (right_of_middle a) part = winding_number_shifted (right_of_middle b) part).
    { induction l as [| g l IH]; intros a A linked_a b B; [destruct B |]. destruct linked_a as [follows_ linked_g].
      rewrite (step a g A follows_). destruct B as [<- | B]; [reflexivity | apply IH; trivial; apply follows_]. }
    intros [<- | E] [<- | F]; [reflexivity | now apply (all rest) | symmetry; now apply (all rest) |].
    transitivity (winding_number_shifted (right_of_middle first) part); [symmetry |]; now apply (all rest).
  Qed.
End Walks.
