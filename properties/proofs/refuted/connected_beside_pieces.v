(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Points that are connected off segments (connected_sets.v): connected is an equivalence, and all that is close to the
   right of a piece, all along it, is connected with a point just right of its middle. *)
From Coq Require Import QArith Qminmax Lqa ZArith Lia Bool List Permutation.
From Oplus Require Import regions_and_sums connected_sets inside_a_corner observation_2_2_4 pieces met_pieces
  naive_collision collision_is_sound beside_a_piece just_right_of_a_piece.
Import ListNotations.

Open Scope Q_scope.

Lemma leads_back (A : vector -> Prop) (path : list vector) : forall a b, leads_through A a path b ->
  exists back, leads_through A b back a.
Proof.
  assert (turned : forall a b, (forall z, lies_on z (Segment a b) -> A z) -> forall z, lies_on z (Segment b a) -> A z).
  { intros a b step z (k & range & X & Y). apply step. exists (1 - k). cbn [source target] in *. split; [lra |].
    rewrite X, Y. split; ring. }
  induction path as [| c rest IH]; intros a b walk; cbn [leads_through] in walk.
  - exists []. exact (turned a b walk).
  - destruct walk as [step walk]. destruct (IH c b walk) as (back & walk').
    exists (back ++ [c]). apply leads_further; [exact walk' | exact (turned a c step)].
Qed.

Lemma leads_on (A : vector -> Prop) (path : list vector) : forall a b c more, leads_through A a path b ->
  leads_through A b more c -> leads_through A a (path ++ b :: more) c.
Proof.
  induction path as [| d rest IH]; intros a b c more walk walk'; cbn [leads_through app] in *; [now split |].
  split; [apply walk | now apply IH].
Qed.

Lemma connected_back (A : vector -> Prop) (a b : vector) : connected_in A a b -> connected_in A b a.
Proof. intros (path & walk). exact (leads_back A path a b walk). Qed.

Lemma connected_on (A : vector -> Prop) (a b c : vector) :
  connected_in A a b -> connected_in A b c -> connected_in A a c.
Proof. intros (path & walk) (more & walk'). exists (path ++ b :: more). now apply leads_on. Qed.

Lemma connected_by_a_step (A : vector -> Prop) (a b : vector) :
  (forall z, lies_on z (Segment a b) -> A z) -> connected_in A a b.
Proof. intros step. now exists []. Qed.

(* Along a piece: all that is close to its right is connected off the segments. *)
Section Beside.
  Variable segments : list segment.
  Variable s : segment.
  Hypothesis only : met_only_along segments s.
  Hypothesis long : nonzero (along s).

  Let off_them := fun z => off z segments.

  Lemma right_half_is_free (w : vector) : strictly_inside w s -> exists radius, 0 < radius /\
    forall y, within radius w y -> area s y < 0 -> off y segments.
  Proof.
    intros inside_.
    destruct (off_near w (filter (fun t => if lies_on_dec w t then false else true) segments)) as (radius & R & near).
    { intros t T. apply filter_In in T. destruct T as [_ T]. now destruct (lies_on_dec w t). }
    exists radius. split; [exact R |]. intros y close right_ t T on.
    destruct (lies_on_dec w t) as [on_w | off_w] eqn:is_.
    - pose proof (area_of_collinear s t y (only w t inside_ T on_w) on). lra.
    - apply (near y close t); [| exact on]. apply filter_In. split; [exact T | now rewrite is_].
  Qed.

  Lemma right_half_is_connected (w : vector) : strictly_inside w s -> exists radius, 0 < radius /\
    forall y z, within radius w y -> within radius w z -> area s y < 0 -> area s z < 0 -> connected_in off_them y z.
  Proof.
    intros inside_. destruct (right_half_is_free w inside_) as (radius & R & free). exists radius. split; [exact R |].
    intros y z close_y close_z right_y right_z. apply connected_by_a_step. intros v on.
    apply free; [exact (within_along radius w y z v close_y close_z on) | exact (area_between s y z v right_y right_z
      on)].
  Qed.

  Lemma right_of_a_step (w : vector) (d : Q) : lies_on w s -> 0 < d -> area s (moved_along w (to_the_right s) d) < 0.
  Proof.
    intros on some. rewrite (area_from w _ s on).
    setoid_replace (cross (along s) (minus (moved_along w (to_the_right s) d) w))
      with (d * cross (along s) (to_the_right s)) by (unfold cross, minus, moved_along; cbn [vx vy]; ring).
    pose proof (right_normal s long). nra.
  Qed.

  (* Theorem. *)
  Theorem connected_beside (w n : vector) : strictly_inside w s -> cross (along s) n < 0 ->
    eventually (fun d => connected_in off_them (moved_along w n d) (just_right_of segments s)).
  Proof.
    intros inside_ right_. set (m := middle s). set (r := to_the_right s). set (far := half_way m r segments).
    destruct (right_half_is_connected w inside_) as (radius & R & alike).
    assert (parallel : eventually (fun e => connected_in off_them (moved_along w r e) (moved_along m r e))).
    { destruct (zero_or_not (minus m w)) as [[X Y] | moves].
      - destruct (right_half_is_free w inside_) as (r1 & R1 & free).
        refine (eventually_implied _ _ _ (eventually_and _ _ (small_steps_stay_within r1 w r R1)
          (eventually_below 1 ltac:(lra)))). intros e [close [some _]]. apply connected_by_a_step. intros z on.
        assert (equal : equal_vectors (moved_along w r e) z).
        { destruct on as (k & _ & zx & zy). unfold moved_along, minus in *. cbn [source target vx vy] in *.
          assert (mx : vx m == vx w) by lra. assert (my : vy m == vy w) by lra.
          split; cbn [vx vy]; rewrite ?zx, ?zy, ?mx, ?my; ring. }
        apply (off_equal _ _ _ equal), free; [exact close |].
        exact (right_of_a_step w e (strictly_inside_lies_on _ _ inside_) some).
      - assert (between_ : forall p, lies_on p (Segment w m) -> strictly_inside p s)
          by (intros p on; exact (strictly_inside_between w m p s inside_ (middle_is_inside s) on)).
        assert (others : eventually (fun e => forall t, In t segments -> ~ collinear s t ->
          forall p, lies_on p (Segment (moved_along w r e) (moved_along m r e)) -> ~ lies_on p t)).
        { apply (eventually_for_all (fun t e => ~ collinear s t -> forall p,
            lies_on p (Segment (moved_along w r e) (moved_along m r e)) -> ~ lies_on p t)).
          intros t T. destruct (collinear_dec s t) as [line | across]; [exists 1; split; [lra | contradiction] |].
          refine (eventually_implied _ _ _ (shifted_segments_do_not_meet w m r t moves _));
            [intros e apart_ _; exact apart_ |].
          intros p on on_t. exact (across (only p t (between_ p on) T on_t)). }
        refine (eventually_implied _ _ _ (eventually_and _ _ others (eventually_below 1 ltac:(lra)))).
        intros e [free [some _]]. apply connected_by_a_step. intros p on t T on_t.
        destruct (collinear_dec s t) as [line | across]; [| exact (free t T across p on on_t)].
        pose proof (area_of_collinear s t p line on_t) as zero_.
        pose proof (area_between s _ _ p (right_of_a_step w e (strictly_inside_lies_on _ _ inside_) some)
          (right_of_a_step m e (strictly_inside_lies_on _ _ (middle_is_inside s)) some) on). lra. }
    assert (far_some : 0 < far) by apply half_way_is.
    destruct (some_small _ (eventually_and _ _ parallel (eventually_and _ _ (small_steps_stay_within radius w r R)
      (eventually_below far far_some)))) as (e & some & step & close_e & _ & less).
    refine (eventually_implied _ _ _ (eventually_and _ _ (small_steps_stay_within radius w n R)
      (eventually_below 1 ltac:(lra)))). intros d [close_d [d_some _]].
    apply (connected_on _ _ (moved_along w r e)).
    - apply alike; trivial; [| exact (right_of_a_step w e (strictly_inside_lies_on _ _ inside_) some)].
      rewrite (area_from w _ s (strictly_inside_lies_on _ _ inside_)).
      setoid_replace (cross (along s) (minus (moved_along w n d) w)) with (d * cross (along s) n)
        by (unfold cross, minus, moved_along; cbn [vx vy]; ring). nra.
    - apply (connected_on _ _ _ _ step). apply connected_by_a_step. intros p (k & range & X & Y).
      apply (off_equal (moved_along m r (e + k * (far - e)))).
      + unfold just_right_of, moved_along in *. fold m r far in X, Y. cbn [source target vx vy] in *.
        split; cbn [vx vy]; rewrite ?X, ?Y; ring.
      + assert (0 <= k * (far - e)) by (apply Qmult_le_0_compat; lra).
        assert (0 <= (1 - k) * (far - e)) by (apply Qmult_le_0_compat; lra).
        apply (nothing_just_right segments s long only); [lra |]. fold m r far. lra.
  Qed.
End Beside.
