(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Between a point outside the sum and one inside, on a line that passes no end of a segment of the convolution, is a
   boundary point of the sum: it is among the finitely many points at which the line crosses the convolution, one before
   which the winding number is zero, and beyond which it is not. *)
From Coq Require Import ZArith Lia Bool List.
From Oplus Require Import numbers convolution signed_crossings small_numbers tie_rule convolution_winding regions
  winding_number_of_the_sum meeting_of_segments first_hit first_edge_of_a_ray neighbourhoods left_of_an_edge
  theorem_4_2_1 theorem_2_2_10.
Import ListNotations.

Open Scope Q_scope.

(* What changes between a and b, but only at numbers of a list, changes at one of them. *)
Lemma some_change (V : Q -> bool) (T : list Q) : forall a b, a < b -> (forall t, In t T -> ~ t == a /\ ~ t == b) ->
  (forall c d, a <= c -> c < d -> d <= b -> (forall t, In t T -> ~ c <= t <= d) -> V c = V d) ->
  V a = false -> V b = true ->
  exists f c d, a <= c /\ c < f /\ f < d /\ d <= b /\ V c = false /\ V d = true /\
    forall t, In t T -> c <= t <= d -> t == f.
Proof.
  induction T as [| m T IH]; intros a b order ends same_ before after.
  { rewrite (same_ a b) in before by (trivial; lra || intros t []). congruence. }
  assert (ends' : forall t, In t T -> ~ t == a /\ ~ t == b) by (intros t I; apply ends; now right).
  destruct (ends m (or_introl eq_refl)) as [not_a not_b].
  (* m is not between c and d *)
  assert (further : forall c d, a <= c -> c < d -> d <= b -> m < c \/ d < m ->
    (forall t, In t T -> ~ t == c /\ ~ t == d) -> V c = false -> V d = true ->
    exists f c d, a <= c /\ c < f /\ f < d /\ d <= b /\ V c = false /\ V d = true /\
      forall t, In t (m :: T) -> c <= t <= d -> t == f).
  { intros c d a_c c_d d_b aside ends_ V_c V_d.
    destruct (IH c d c_d ends_) as (f & c' & d' & c_c & c_f & f_d & d_d & V_c' & V_d' & only); trivial.
    - intros c' d' c_c' c_d' d_d' free. apply same_; try lra. intros t [<- | I]; [lra | now apply free].
    - exists f, c', d'. repeat split; trivial; try lra. intros t [<- | I] range; [lra | now apply only]. }
  destruct (Qlt_le_dec a m) as [after_a |]; [destruct (Qlt_le_dec m b) as [before_b |] |];
    [| apply (further a b); trivial; lra ..].
  assert (gap : eventually (fun e => forall t, In t T -> m - e <= t <= m + e -> t == m)).
  { apply (eventually_for_all (fun t e => m - e <= t <= m + e -> t == m)). intros t _.
    destruct (Q_dec t m) as [[low | high] | same_m]; [exists (m - t) | exists (t - m) | exists 1]; (split; [lra |]);
      intros e e0 e1 range; lra. }
  destruct (some_small _ (eventually_and _ _ gap (eventually_and _ _ (eventually_below (m - a) ltac:(lra))
    (eventually_below (b - m) ltac:(lra))))) as (e & some & only & below_a & below_b).
  assert (ends_of_gap : forall t, In t T -> ~ t == m - e /\ ~ t == m + e).
  { intros t I. split; intros at_end; specialize (only t I ltac:(lra)); lra. }
  destruct (V (m - e)) eqn:V_c.
  - apply (further a (m - e)); trivial; try lra. intros t I. split; [now apply ends' | now apply ends_of_gap].
  - destruct (V (m + e)) eqn:V_d.
    + exists m, (m - e), (m + e). repeat split; trivial; try lra. intros t [<- | I] range; [lra | now apply only].
    + apply (further (m + e) b); trivial; try lra. intros t I. split; [now apply ends_of_gap | now apply ends'].
Qed.

Section Line.
  Variables p q : region.
  Variables y u : vector.
  Hypothesis p_region : valid_region p.
  Hypothesis q_region : valid_region q.

  Let segments := convolution_segments p q.
  Let at_ (t : Q) : vector := moved_along y u t.

  Hypothesis generic : forall s, In s segments -> avoids y u s.

  Let crossings : list Q := map (place_of_crossing y u) (filter (crosses_line y u) segments).

  Lemma on_means_crossing (t : Q) (s : segment) : In s segments -> lies_on (at_ t) s ->
    exists c, In c crossings /\ t == c.
  Proof.
    intros I on. destruct (on_segment_is_crossing y u s t (generic s I) on) as [crossed place].
    exists (place_of_crossing y u s). split; [| exact place]. now apply in_map, filter_In.
  Qed.

  Lemma off_means_no_crossing (t c : Q) : off (at_ t) segments -> In c crossings -> ~ c == t.
  Proof.
    intros free I same_. apply in_map_iff in I. destruct I as (s & <- & I). apply filter_In in I.
    destruct I as [I crossed]. destruct (crossing_is_on_segment y u s crossed) as (k & k0 & k1 & X & Y).
    apply (free s I). exists k. split; [lra |]. unfold at_, moved_along, inside_segment in *; cbn [vx vy] in *.
    rewrite <- same_, X, Y. split; ring.
  Qed.

  Lemma same_number_along (a b : Q) : a < b -> (forall t, In t crossings -> ~ a <= t <= b) ->
    winding_number (at_ a) segments = winding_number (at_ b) segments.
  Proof.
    intros order free.
    apply (winding_number_along (Segment (at_ a) (at_ b)) segments (convolution_is_closed p q (proj1 p_region)
      (proj1 q_region))).
    intros v (k & [k0 k1] & X & Y) s I on. cbn [source target] in X, Y.
    destruct (on_means_crossing (a + k * (b - a)) s I) as (c & C & c_is).
    - apply (lies_on_equal v); [| exact on]. unfold at_, moved_along in *; cbn [vx vy] in *.
      split; cbn [vx vy]; [rewrite X | rewrite Y]; ring.
    - apply (free c C). rewrite <- c_is. split; nra.
  Qed.

  Theorem boundary_between : off (at_ 0) segments -> winding_number (at_ 0) segments = 0%Z ->
    off (at_ 1) segments -> (0 < winding_number (at_ 1) segments)%Z ->
    exists t, 0 < t /\ t < 1 /\ on_boundary_of_sum (at_ t) p q.
  Proof.
    intros off_0 zero_ off_1 round. pose proof p_region as (p_edges & p_valid & _).
    pose proof q_region as (q_edges & q_valid & _).
    destruct (some_change (fun t => 0 <? winding_number (at_ t) segments)%Z crossings 0 1)
      as (f & c & d & c0 & c_f & f_d & d1 & V_c & V_d & only); [lra | | | now rewrite zero_ | now apply Z.ltb_lt |].
    { intros t I. split; now apply off_means_no_crossing. }
    { intros c d _ order _ free. now rewrite (same_number_along c d order free). }
    apply Z.ltb_ge in V_c. apply Z.ltb_lt in V_d.
    exists f. split; [lra |]. split; [lra |]. intros radius R.
    destruct (some_small _ (eventually_and _ _
      (eventually_and _ _ (eventually_below (f - c) ltac:(lra)) (eventually_below (d - f) ltac:(lra)))
      (eventually_and _ _ (small_steps_stay_within radius (at_ f) u R)
        (small_steps_stay_within radius (at_ f) (opposite u) R)))) as (h & some & [below_c below_d] & near_1 & near_2).
    split; [exists (at_ (f + h)) | exists (at_ (f - h))]; unfold within, at_, moved_along, opposite in near_1, near_2;
      cbn [vx vy] in near_1, near_2; (split; [unfold within, at_, moved_along; cbn [vx vy]; lra |]).
    - apply positive_winding_number_is_in_the_sum; trivial. fold segments.
      rewrite (same_number_along (f + h) d); [exact V_d | lra |].
      intros t I range. specialize (only t I ltac:(lra)). lra.
    - assert (off_h : off (at_ (f - h)) segments).
      { intros s I on. destruct (on_means_crossing (f - h) s I on) as (t & T & t_is).
        specialize (only t T ltac:(lra)). lra. }
      intros in_. apply (positive_winding_number_iff_common_point p q _ p_region q_region off_h) in in_.
      fold segments in in_. rewrite <- (same_number_along c (f - h)) in in_; [lia | lra |].
      intros t I range. specialize (only t I ltac:(lra)). lra.
  Qed.
End Line.
