(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Between a point outside the sum and one inside, on a line that passes no end of a segment of the convolution, is a
   boundary point of the sum: it is among the finitely many points at which the line crosses the convolution, the first
   one beyond which the winding number is not zero. *)
From Coq Require Import ZArith Lia Bool List.
From Oplus Require Import numbers convolution signed_crossings tie_rule convolution_winding regions
  winding_number_of_the_sum meeting_of_segments first_hit first_edge_of_a_ray neighbourhoods left_of_an_edge
  theorem_4_2_1 theorem_2_2_10.
Import ListNotations.

Open Scope Q_scope.

Lemma filter_has_fewer {A : Type} (f g : A -> bool) (a : A) (l : list A) :
  (forall b, f b = true -> g b = true) -> In a l -> f a = false -> g a = true ->
  (length (filter f l) < length (filter g l))%nat.
Proof.
  intros implied I not_f is_g.
  assert (at_most : forall m, (length (filter f m) <= length (filter g m))%nat).
  { intros m. induction m as [| b m IH]; [reflexivity |]. cbn [filter]. specialize (implied b).
    destruct (f b), (g b); cbn [length]; lia. }
  induction l as [| b l IH]; [destruct I |]. cbn [filter]. destruct I as [-> | I].
  - rewrite not_f, is_g. cbn [length]. specialize (at_most l). lia.
  - specialize (IH I). specialize (implied b). destruct (f b), (g b); cbn [length]; lia.
Qed.

Section Line.
  Variables p q : region.
  Variables y u : vector.
  Hypothesis p_region : valid_region p.
  Hypothesis q_region : valid_region q.

  Let segments := convolution_segments p q.
  Let at_ (t : Q) : vector := moved_along y u t.

  Hypothesis generic : forall s, In s segments -> avoids y u s.
  Hypothesis off_end : off (at_ 1) segments.
  Hypothesis inside_end : (0 < winding_number (at_ 1) segments)%Z.

  Let closed : cycles segments := convolution_is_closed p q (proj1 p_region) (proj1 q_region).

  Lemma same_number_along (a b : Q) : a <= b ->
    (forall s t, In s segments -> a <= t <= b -> ~ lies_on (at_ t) s) ->
    winding_number (at_ a) segments = winding_number (at_ b) segments.
  Proof.
    intros order free. apply (winding_number_along (Segment (at_ a) (at_ b)) segments closed).
    intros v (k & [k0 k1] & X & Y) s I on. cbn [source target] in X, Y.
    assert (0 <= k * (b - a)) by (apply Qmult_le_0_compat; lra).
    assert (0 <= (1 - k) * (b - a)) by (apply Qmult_le_0_compat; lra).
    apply (free s (a + k * (b - a)) I); [lra |]. apply (lies_on_equal v); [| exact on].
    unfold at_, moved_along in *; cbn [vx vy] in *. split; cbn [vx vy]; [rewrite X | rewrite Y]; ring.
  Qed.

  Definition crosses_after (a : Q) (s : segment) : bool :=
    crosses_line y u s && positive (place_of_crossing y u s - a) && positive (1 - place_of_crossing y u s).

  Lemma crosses_after_is (a t : Q) (s : segment) : In s segments -> a < t -> t < 1 -> lies_on (at_ t) s ->
    crosses_after a s = true /\ t == place_of_crossing y u s.
  Proof.
    intros I after before on. destruct (on_segment_is_crossing y u s t (generic s I) on) as [crossed place].
    split; [| exact place]. unfold crosses_after. rewrite crossed. cbn [andb].
    destruct (positive_spec (place_of_crossing y u s - a)), (positive_spec (1 - place_of_crossing y u s));
      try reflexivity; exfalso; lra.
  Qed.

  Lemma crosses_after_range (a : Q) (s : segment) : crosses_after a s = true ->
    a < place_of_crossing y u s /\ place_of_crossing y u s < 1.
  Proof.
    unfold crosses_after. intros both. apply andb_true_iff in both. destruct both as [both before].
    apply andb_true_iff in both. destruct both as [_ after].
    destruct (positive_spec (place_of_crossing y u s - a)), (positive_spec (1 - place_of_crossing y u s));
      try discriminate. split; lra.
  Qed.

  Theorem boundary_between (n : nat) : forall a, a < 1 -> off (at_ a) segments ->
    winding_number (at_ a) segments = 0%Z -> (length (filter (crosses_after a) segments) <= n)%nat ->
    exists t, a < t /\ t < 1 /\ on_boundary_of_sum (at_ t) p q.
  Proof.
    pose proof p_region as (p_edges & p_valid & _). pose proof q_region as (q_edges & q_valid & _).
    induction n as [| n IH]; intros a before_end off_a zero_ many.
    all: destruct (filter (crosses_after a) segments) as [| k rest] eqn:met; cbn [length] in many; try lia.
    1, 2: exfalso; assert (same_ : winding_number (at_ a) segments = winding_number (at_ 1) segments); [| lia];
      apply same_number_along; [lra |]; intros s t I [t0 t1] on;
      (destruct (Qeq_dec t a) as [is_a |];
       [apply (off_a s I), (lies_on_equal (at_ t)); trivial; unfold at_, moved_along; split; cbn [vx vy];
        now rewrite is_a |]);
      (destruct (Qeq_dec t 1) as [is_1 |];
       [apply (off_end s I), (lies_on_equal (at_ t)); trivial; unfold at_, moved_along; split; cbn [vx vy];
        now rewrite is_1 |]);
      (assert (In s (filter (crosses_after a) segments)); [| now rewrite met in *]);
      apply filter_In; split; [exact I |]; apply (crosses_after_is a t s I); trivial; lra.
    (* the first crossing, and a point between it and the next *)
    destruct (least_of (place_of_crossing y u) (k :: rest)) as (s & S & least); [discriminate |].
    rewrite <- met in S, least. apply filter_In in S. destruct S as [S crossed].
    destruct (crosses_after_range a s crossed) as [after_a before_1]. set (f := place_of_crossing y u s) in *.
    assert (next_ : exists b, f < b /\ b <= 1 /\ forall s', In s' segments -> crosses_after f s' = true ->
      b <= place_of_crossing y u s').
    { destruct (filter (crosses_after f) segments) as [| k' rest'] eqn:later.
      - exists 1. split; [exact before_1 |]. split; [lra |]. intros s' I' crossed'.
        assert (In s' (filter (crosses_after f) segments)) by now apply filter_In. rewrite later in *. contradiction.
      - destruct (least_of (place_of_crossing y u) (k' :: rest')) as (s2 & S2 & least2); [discriminate |].
        rewrite <- later in S2, least2. apply filter_In in S2. destruct S2 as [S2 crossed2].
        destruct (crosses_after_range f s2 crossed2). exists (place_of_crossing y u s2).
        split; [assumption |]. split; [lra |]. intros s' I' crossed'. apply least2. now apply filter_In. }
    destruct next_ as (b & f_b & b_1 & none_between).
    assert (free_after : forall s' t, In s' segments -> f < t -> t < b -> ~ lies_on (at_ t) s').
    { intros s' t I' t0 t1 on. destruct (crosses_after_is f t s' I' t0 ltac:(lra) on) as [crossed' place].
      specialize (none_between s' I' crossed'). lra. }
    assert (free_before : forall s' t, In s' segments -> a <= t -> t < f -> ~ lies_on (at_ t) s').
    { intros s' t I' t0 t1 on. destruct (Qeq_dec t a) as [is_a | differ].
      - apply (off_a s' I'), (lies_on_equal (at_ t)); trivial. unfold at_, moved_along; split; cbn [vx vy];
          now rewrite is_a.
      - destruct (crosses_after_is a t s' I' ltac:(lra) ltac:(lra) on) as [crossed' place].
        assert (f <= place_of_crossing y u s'); [| lra]. apply least. now apply filter_In. }
    set (m := (1 # 2) * (f + b)). assert (m_range : f < m /\ m < b) by (unfold m; lra). clearbody m.
    assert (off_m : off (at_ m) segments) by (intros s' I'; apply free_after; trivial; lra).
    pose proof (convolution_is_nowhere_negative p q (at_ m) p_edges q_edges p_valid q_valid) as not_negative.
    fold segments in not_negative.
    destruct (Z.eq_dec (winding_number (at_ m) segments) 0) as [none | some].
    - destruct (IH m ltac:(lra) off_m none) as (t & t0 & t1 & boundary); [| exists t; split; [lra | now split]].
      assert (fewer : (length (filter (crosses_after m) segments) < length (filter (crosses_after a) segments))%nat).
      { apply (filter_has_fewer _ _ s); trivial.
        - intros s' later. unfold crosses_after in *. destruct (crosses_line y u s'); [| discriminate].
          destruct (positive_spec (place_of_crossing y u s' - m)), (positive_spec (place_of_crossing y u s' - a));
            cbn [andb] in *; try discriminate; trivial. exfalso. lra.
        - unfold crosses_after. fold f. destruct (positive_spec (f - m)); [exfalso; lra |].
          now rewrite andb_false_r. }
      rewrite met in fewer. cbn [length] in fewer. lia.
    - exists f. split; [exact after_a |]. split; [exact before_1 |]. intros radius R.
      destruct (small_steps_stay_within radius (at_ f) u R) as (l1 & L1 & near_1).
      destruct (small_steps_stay_within radius (at_ f) (opposite u) R) as (l2 & L2 & near_2). split.
      + set (h := if Qlt_le_dec l1 (m - f) then (1 # 2) * l1 else (1 # 2) * (m - f)).
        assert (h_range : 0 < h /\ h < l1 /\ h < m - f) by (unfold h; destruct (Qlt_le_dec l1 (m - f)); lra).
        clearbody h. exists (at_ (f + h)). split.
        * specialize (near_1 h ltac:(lra) ltac:(lra)). unfold within, at_, moved_along in *; cbn [vx vy] in *. lra.
        * apply positive_winding_number_is_in_the_sum; trivial. fold segments.
          rewrite (same_number_along (f + h) m); [lia | lra |]. intros s' t I' range. apply free_after; trivial; lra.
      + set (h := if Qlt_le_dec l2 (f - a) then (1 # 2) * l2 else (1 # 2) * (f - a)).
        assert (h_range : 0 < h /\ h < l2 /\ h < f - a) by (unfold h; destruct (Qlt_le_dec l2 (f - a)); lra).
        clearbody h. exists (at_ (f - h)). split.
        * specialize (near_2 h ltac:(lra) ltac:(lra)). unfold within, at_, moved_along, opposite in *; cbn [vx vy] in *.
          lra.
        * assert (off_h : off (at_ (f - h)) segments) by (intros s' I'; apply free_before; trivial; lra).
          intros in_. apply (positive_winding_number_iff_common_point p q _ p_region q_region off_h) in in_.
          fold segments in in_. rewrite <- (same_number_along a (f - h)) in in_; [lia | lra |].
          intros s' t I' range. apply free_before; trivial; lra.
  Qed.
End Line.
