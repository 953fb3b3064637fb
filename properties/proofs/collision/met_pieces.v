(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* What meets a piece of a segment, cut where others meet it (pieces.v): no end of another segment is strictly inside
   a piece, and another segment with a point strictly inside it runs along all of it. So inside the pieces of a
   region's boundary are no vertices. *)
From Coq Require Import ZArith Lia Bool List.
From Oplus Require Import numbers convolution meeting_of_segments regions first_hit winding_number_of_the_sum
  left_of_an_edge location pieces naive_collision.
Import ListNotations.

Open Scope Q_scope.

Lemma lines_meet_once (s f : segment) (p w : vector) : ~ cross (along s) (along f) == 0 ->
  lies_on p s -> lies_on p f -> lies_on w s -> lies_on w f -> equal_vectors w p.
Proof.
  intros turn (t & _ & tx & ty) (u & _ & ux & uy) (t' & _ & tx' & ty') (u' & _ & ux' & uy').
  split; apply (Qmult_inj_l _ _ _ turn); in_coordinates; by_equations.
Qed.

(* An end that is on the other segment is found. *)
Lemma intersection_has_ends (s f : segment) (p : vector) :
  (p = source s \/ p = target s) /\ lies_on p f \/ (p = source f \/ p = target f) /\ lies_on p s ->
  exists q, In q (intersection s f) /\ equal_vectors p q.
Proof.
  intros which. unfold intersection.
  set (ends := filter (fun p => is_on_segment p f) [source s; target s] ++ filter (fun p => is_on_segment p s) [source f; target f]).
  assert (I : In p ends).
  { apply in_app_iff. destruct which as [[end_ on] | [end_ on]]; [left | right]; apply filter_In;
      (split; [destruct end_ as [-> | ->]; cbn; tauto |]).
    - now destruct (is_on_spec p f).
    - now destruct (is_on_spec p s). }
  destruct (sorted_has p ends I) as (q & J & equal). exists q. split; [| exact equal].
  destruct (sorted_points ends); [destruct J | exact J].
Qed.

(* And so is the common point of two segments that are not parallel. *)
Lemma intersection_has (s f : segment) (w : vector) : ~ cross (along s) (along f) == 0 ->
  lies_on w s -> lies_on w f -> exists q, In q (intersection s f) /\ equal_vectors w q.
Proof.
  intros turn on_s on_f.
  destruct (intersection s f) as [| p rest] eqn:common.
  - exfalso.
    assert (no_end : forall p, (p = source s \/ p = target s) /\ lies_on p f \/
              (p = source f \/ p = target f) /\ lies_on p s -> False).
    { intros p which. destruct (intersection_has_ends s f p which) as (q & I & _). now rewrite common in I. }
    assert (crossing_ : cross_properly s f = true).
    { assert (in_s : strictly_inside w s).
      { destruct (inside_or_end w s on_s) as [| [equal | equal]]; [assumption | exfalso ..];
          [apply (no_end (source s)) | apply (no_end (target s))]; left;
          (split; [tauto | apply (lies_on_equal w); [now symmetry | exact on_f]]). }
      assert (in_f : strictly_inside w f).
      { destruct (inside_or_end w f on_f) as [| [equal | equal]]; [assumption | exfalso ..];
          [apply (no_end (source f)) | apply (no_end (target f))]; right;
          (split; [tauto | apply (lies_on_equal w); [now symmetry | exact on_s]]). }
      destruct in_s as (t & t_inside & tx & ty), in_f as (u & u_inside & ux & uy).
      set (D := cross (along s) (along f)) in *.
      assert (areas : (area (Segment (source s) (target s)) (source f) == - u * D /\
                       area (Segment (source s) (target s)) (target f) == (1 - u) * D) /\
                      (area (Segment (source f) (target f)) (source s) == t * D /\
                       area (Segment (source f) (target f)) (target s) == - ((1 - t) * D)))
        by (repeat split; unfold D; in_coordinates; by_equations).
      destruct areas as ((one & two) & three & four).
      unfold cross_properly. rewrite !orientation_by_area, one, two, three, four.
      clearbody D. clear - turn t_inside u_inside.
      compared_numbers (- u * D ?= 0); compared_numbers ((1 - u) * D ?= 0);
        compared_numbers (t * D ?= 0); compared_numbers (- ((1 - t) * D) ?= 0); try reflexivity; exfalso;
        destruct (Q_dec D 0) as [[negative_ | positive_] | none]; try contradiction; nra. }
    unfold intersection in common. rewrite crossing_ in common.
    destruct (sorted_points _); discriminate.
  - exists p. split; [now left |].
    assert (on_both : lies_on p s /\ lies_on p f \/ p = crossing_point s f).
    { assert (I : In p (intersection s f)) by (rewrite common; now left). unfold intersection in I.
      destruct (sorted_points _) as [| q l] eqn:sorted.
      - destruct (cross_properly s f); [destruct I as [<- | []]; now right | destruct I].
      - left. rewrite <- sorted in I. apply sorted_in, in_app_iff in I.
        destruct I as [I | I]; apply filter_In in I; destruct I as [I on]; cbn in I.
        + split; [destruct I as [<- | [<- | []]]; [apply source_lies_on | apply target_lies_on] |].
          now destruct (is_on_spec p f).
        + split; [| destruct I as [<- | [<- | []]]; [apply source_lies_on | apply target_lies_on]].
          now destruct (is_on_spec p s). }
    destruct on_both as [[p_on_s p_on_f] | ->]; [now apply (lines_meet_once s f) |].
    destruct on_s as (t & t_range & tx & ty), on_f as (u & u_range & ux & uy).
    assert (t_is : cross (minus (source f) (source s)) (along f) / cross (along s) (along f) == t).
    { setoid_replace (cross (minus (source f) (source s)) (along f)) with (t * cross (along s) (along f))
        by (in_coordinates; by_equations).
      field. exact turn. }
    unfold crossing_point. split; cbn [vx vy]; rewrite t_is; unfold along, minus; cbn [vx vy];
      [rewrite tx | rewrite ty]; ring.
Qed.

Lemma part_is_long (piece s : segment) : is_part piece s -> nonzero (along s) ->
  nonzero (along piece) /\ exists c, 0 < c /\
    vx (along piece) == c * vx (along s) /\ vy (along piece) == c * vy (along s).
Proof.
  intros (on_source & on_target & before) long.
  destruct (fraction_on s _ long on_source) as (_ & jx & jy).
  destruct (fraction_on s _ long on_target) as (_ & kx & ky).
  set (j := fraction s (source piece)) in *. set (k := fraction s (target piece)) in *. clearbody j k.
  assert (x_is : vx (along piece) == (k - j) * vx (along s)) by (in_coordinates; by_equations).
  assert (y_is : vy (along piece) == (k - j) * vy (along s)) by (in_coordinates; by_equations).
  split; [| exists (k - j); split; [lra | tauto]].
  intros [no_x no_y]. rewrite x_is in no_x. rewrite y_is in no_y. apply long.
  destruct (Qmult_integral _ _ no_x); destruct (Qmult_integral _ _ no_y); split; trivial; exfalso; lra.
Qed.

Lemma strictly_inside_part (piece s : segment) (w : vector) : nonzero (along s) -> is_part piece s ->
  strictly_inside w piece -> strictly_inside w s.
Proof.
  intros long part inside_. destruct (inside_a_part piece s w long part inside_) as [on between_].
  destruct part as (on_source & on_target & _).
  destruct (fraction_on s _ long on_source) as (range_j & _).
  destruct (fraction_on s _ long on_target) as (range_k & _).
  destruct (fraction_on s _ long on) as (_ & X & Y). exists (fraction s w). split; [lra | tauto].
Qed.

(* Theorem. Of a segment cut where others meet it: strictly inside a piece are no ends of the others, and what has a
   point strictly inside a piece is parallel to it. *)
Theorem nothing_meets_a_piece (s : segment) (others : list segment) (piece f : segment) (w : vector) :
  nonzero (along s) -> In piece (cut_where_met s others) -> strictly_inside w piece -> In f others ->
  ~ equal_vectors w (source f) /\ ~ equal_vectors w (target f) /\
  (lies_on w f -> cross (along s) (along f) == 0).
Proof.
  intros long I inside_ J. destruct (cut_returns s (flat_map (intersection s) others) long) as [none _].
  destruct (none piece I) as [part no_point].
  destruct (inside_a_part piece s w long part inside_) as [on _].
  assert (not_met : forall q, In q (intersection s f) -> ~ equal_vectors w q).
  { intros q K. apply no_point; [| exact inside_]. apply in_flat_map. now exists f. }
  assert (no_end : forall p, p = source f \/ p = target f -> ~ equal_vectors w p).
  { intros p which equal. destruct (intersection_has_ends s f p) as (q & K & equal_q).
    - right. split; [exact which |]. now apply (lies_on_equal w).
    - apply (not_met q K). unfold equal_vectors in *. lra. }
  split; [apply no_end; now left |]. split; [apply no_end; now right |].
  intros on_f. destruct (Qeq_dec (cross (along s) (along f)) 0) as [| turn]; [assumption | exfalso].
  destruct (intersection_has s f w turn on on_f) as (q & K & equal). exact (not_met q K equal).
Qed.

Lemma boundary_piece_is (r : region) (s : segment) : no_edges_are_points r -> In s (boundary_pieces r) ->
  exists e, In e (region_edges r) /\ nonzero (along e) /\ is_part s e /\
    (forall w, strictly_inside w s -> lies_on w e /\ ~ is_vertex w r).
Proof.
  intros not_points I. apply in_flat_map in I. destruct I as (e & E & I). exists e.
  pose proof (region_edges_are_directions r not_points e E) as long.
  destruct (cut_returns e (flat_map (intersection e) (region_edges r)) long) as [parts _].
  destruct (parts s I) as [part _].
  split; [exact E |]. split; [exact long |]. split; [exact part |]. intros w inside_. split.
  - now destruct (inside_a_part s e w long part inside_).
  - intros (u & U & equal). destruct (nothing_meets_a_piece e _ s u w long I inside_ U) as (no_source & _).
    exact (no_source equal).
Qed.
