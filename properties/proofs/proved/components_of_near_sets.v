(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Two sets have as many components if near each point of the one is a point of the other, and in each set points that
   are near each other are connected: a path in the one is followed in the other, in steps that are short enough. *)
From Coq Require Import QArith Qround Lqa ZArith List.
From Oplus Require Import regions_and_sums neighbourhoods connected_sets coordinates connected_beside_pieces
  points_of_the_intersection.
Import ListNotations.

Open Scope Q_scope.

Lemma components_of_equal_sets (A B : vector -> Prop) (k : nat) : (forall z, A z <-> B z) ->
  has_components A k -> has_components B k.
Proof.
  intros same_ (points & long & in_ & all & apart_).
  assert (paths : forall v w, connected_in A v w <-> connected_in B v w)
    by (intros v w; split; apply connected_in_more; intros z; apply same_).
  exists points. split; [exact long |]. split; [intros v V; now apply same_, in_ |]. split.
  - intros z Z. destruct (all z (proj2 (same_ z) Z)) as (v & V & there). exists v. split; [exact V | now apply paths].
  - clear - apart_ paths. induction apart_ as [| v l first_ _ IH]; constructor; [| exact IH].
    rewrite Forall_forall in *. intros w W there. apply (first_ w W). now apply paths.
Qed.

Definition joined_when_near (d : Q) (A : vector -> Prop) : Prop :=
  forall v w, within d v w -> A v -> A w -> connected_in A v w.
Definition comes_near (d : Q) (A B : vector -> Prop) : Prop := forall v, A v -> exists w, B w /\ within d v w.

Section Followed.
  Variables A B : vector -> Prop.
  Variable d : Q.
  Hypothesis some : 0 < d.
  Hypothesis joined : joined_when_near (4 * d) B.
  Hypothesis near_ : comes_near d A B.

  Fixpoint doubled (number : nat) : Q := match number with O => d | S k => 2 * doubled k end.

  Lemma some_reach (most : Q) : exists number, most < doubled number.
  Proof.
    exists (Z.to_nat (Qfloor (most / d) + 1)).
    assert (grows : forall n, d <= doubled n /\ inject_Z (Z.of_nat n) * d <= doubled n).
    { induction n as [| n [one more]]; [change (inject_Z (Z.of_nat 0)) with 0; cbn [doubled]; lra |].
      rewrite Nat2Z.inj_succ, <- Z.add_1_r, inject_Z_plus. change (inject_Z 1) with 1. cbn [doubled]. lra. }
    apply Qlt_le_trans with (inject_Z (Qfloor (most / d) + 1) * d).
    - setoid_replace most with (most / d * d) at 1 by (field; lra).
      apply Qmult_lt_compat_r; [exact some | apply Qlt_floor].
    - destruct (Z_lt_le_dec (Qfloor (most / d) + 1) 0) as [negative_ | low].
      + apply Qle_trans with 0; [| apply Qle_trans with d; [lra | apply grows]].
        apply Z.lt_le_incl in negative_. rewrite Zle_Qle in negative_. change (inject_Z 0) with 0 in negative_. nra.
      + rewrite <- (Z2Nat.id _ low) at 1. apply grows.
  Qed.

  (* Half of a step is followed, and the other half. *)
  Lemma a_step_is_followed (number : nat) : forall v w v' w', (forall z, lies_on z (Segment v w) -> A z) ->
    within (doubled number) v w -> B v' -> B w' -> within d v v' -> within d w w' -> connected_in B v' w'.
  Proof.
    induction number as [| number IH]; intros v w v' w' step far in_v in_w close_v close_w.
    - cbn in far. apply joined; trivial. unfold within in *. lra.
    - set (m := moved_along v (minus w v) (1 # 2)).
      assert (parts : forall z, lies_on z (Segment v m) \/ lies_on z (Segment m w) -> lies_on z (Segment v w)).
      { intros z [(k & range & X & Y) | (k & range & X & Y)]; [exists (k * (1 # 2)) | exists ((1 + k) * (1 # 2))];
          unfold m, moved_along, minus in *; cbn [source target vx vy] in *; (split; [lra |]); rewrite X, Y; split;
          ring. }
      destruct (near_ m (step m (parts m (or_introl (target_lies_on (Segment v m)))))) as (m' & in_m & close_m).
      cbn [doubled] in far. set (r := doubled number) in *.
      apply (connected_on B v' m' w'); [apply (IH v m) | apply (IH m w)]; trivial;
        first [intros z on; apply step, parts; tauto |
          unfold within, m, moved_along, minus in *; cbn [vx vy] in *; lra].
  Qed.

  Lemma a_path_is_followed (v w v' w' : vector) : connected_in A v w -> B v' -> B w' -> within d v v' ->
    within d w w' -> connected_in B v' w'.
  Proof.
    intros (path & walk) in_v in_w close_v close_w. revert v v' walk in_v close_v.
    assert (step : forall v w v' w', (forall z, lies_on z (Segment v w) -> A z) -> B v' -> B w' -> within d v v' ->
      within d w w' -> connected_in B v' w').
    { intros a b a' b' all. destruct (some_reach (size (minus b a))) as (number & far).
      apply (a_step_is_followed number a b); trivial. pose proof (abs_bounds (vx b - vx a)).
      pose proof (abs_bounds (vy b - vy a)). unfold within, size, minus in *. cbn [vx vy] in *. lra. }
    induction path as [| c rest IH]; intros v v' walk in_v close_v; [now apply (step v w) |].
    destruct walk as [first_ walk].
    destruct (near_ c (first_ c (target_lies_on (Segment v c)))) as (c' & in_c & close_c).
    apply (connected_on B v' c' w'); [now apply (step v c) | now apply (IH c)].
  Qed.
End Followed.

Lemma within_back (d : Q) (v w : vector) : within d v w -> within d w v.
Proof. unfold within. lra. Qed.

(* Theorem. *)
Theorem near_sets_have_as_many_components (A B : vector -> Prop) (d : Q) (k : nat) : 0 < d ->
  joined_when_near (4 * d) A -> joined_when_near (4 * d) B -> comes_near d A B -> comes_near d B A ->
  has_components A k -> has_components B k.
Proof.
  intros some joined_a joined_b to_b to_a (points & long & in_ & all & apart_).
  assert (chosen : exists others, length others = length points /\
    Forall2 (fun v w => B w /\ within d v w) points others).
  { clear - in_ to_b. induction points as [| v l IH]; [now exists [] |].
    destruct (to_b v (in_ v (or_introl eq_refl))) as (w & W). destruct IH as (others & long & there).
    { intros u U. apply in_. now right. }
    exists (w :: others). cbn [length]. rewrite long. split; [reflexivity | now constructor]. }
  destruct chosen as (others & as_long & pairs). exists others. split; [now rewrite as_long |].
  split; [| split].
  - clear - pairs. induction pairs as [| v w l m [in_w _] _ IH]; [intros u [] | intros u [<- | U]; auto].
  - intros z Z. destruct (to_a z Z) as (z' & in_z' & close_z). destruct (all z' in_z') as (v & V & there).
    assert (exists w, In w others /\ B w /\ within d v w) as (w & W & in_w & close_w).
    { clear - pairs V. induction pairs as [| v' w l m both _ IH]; [destruct V |].
      destruct V as [-> | V]; [exists w; split; [now left | exact both] |].
      destruct (IH V) as (u & U & here). exists u. split; [now right | exact here]. }
    exists w. split; [exact W |]. apply (a_path_is_followed A B d some joined_b to_b z' v); trivial.
    now apply within_back.
  - assert (back : forall v v' w w', A v -> A w -> within d v v' -> within d w w' -> connected_in B v' w' ->
      connected_in A v w).
    { intros v v' w w' in_v in_w close_v close_w there.
      apply (a_path_is_followed B A d some joined_a to_a v' w'); trivial; now apply within_back. }
    clear - in_ apart_ pairs back. induction pairs as [| v v' l m [_ close_v] pairs IH]; [constructor |].
    inversion apart_ as [| ? ? first_ apart_']; subst. constructor.
    + rewrite Forall_forall in *. intros w' W' there.
      assert (exists w, In w l /\ within d w w') as (w & W & close_w).
      { clear - pairs W'. induction pairs as [| a b l m [_ close_] _ IH]; [destruct W' |].
        destruct W' as [-> | W']; [exists a; split; [now left | exact close_] |].
        destruct (IH W') as (u & U & here). exists u. split; [now right | exact here]. }
      apply (first_ w W). apply (back v v' w w'); trivial; apply in_; [now left | now right].
    + apply IH; [intros u U; apply in_; now right | exact apart_'].
Qed.
