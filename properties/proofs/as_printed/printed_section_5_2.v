(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Section 5.2: a ray that starts directly to the right of an edge gives the same winding number of the convolution as
   going from face to face, from the unbounded face inwards. The rules of such a traversal are these: the unbounded face
   has the number 0; all of a face has one number; and who crosses edges adds the signed crossings, of edges that
   overlap one by one. In whatever order faces are visited, breadth first or not, by Observation 4.2.5 each gets its
   winding number (signed_crossings.v); and what the ray counts is that of the points close enough to the edge
   (shifted_ray.v). *)
From Coq Require Import ZArith Lia Bool List.
From Oplus Require Import numbers winding small_numbers shifted_ray signed_crossings meeting_of_segments first_hit
  convolution convolution_winding.
Import ListNotations.

Open Scope Q_scope.

Section Faces.
  Variable segments : list segment.

  Definition is_above_all (y : vector) : Prop :=
    forall s, In s segments -> vy (source s) < vy y /\ vy (target s) < vy y.

  (* A traversal of the faces may give this number to the face around this point. *)
  Inductive gets_number : vector -> Z -> Prop :=
  | UnboundedFace (y : vector) : is_above_all y -> gets_number y 0
  | SameFace (y z : vector) (k : Z) : gets_number y k -> (forall w, lies_on w (Segment y z) -> off w segments) ->
      gets_number z k
  | FaceAcross (y z : vector) (k : Z) : gets_number y k -> off z segments -> nonzero (minus z y) ->
      gets_number z (k + sum (map (signed_crossing_of_step y z) segments)).

  Lemma above_all_is_outside (y : vector) : is_above_all y ->
    off y segments /\ winding_number y segments = 0%Z.
  Proof.
    intros above. split.
    - intros s S (k & range & _ & Y). destruct (above s S) as [low low'].
      pose proof (mixed_is_less k (vy (source s)) (vy (target s)) (vy y) range low low'). lra.
    - unfold winding_number. assert (none : forall s, In s segments -> signed_crossing y s = 0%Z).
      { intros s S. destruct (Z.eq_dec (signed_crossing y s) 0) as [| some]; [assumption | exfalso].
        destruct (crossed_ahead y s some) as [spanning _]. apply heights_of_spanning in spanning.
        destruct (above s S). lra. }
      clear above. induction segments as [| s l IH]; [reflexivity |]. cbn [map]. unfold sum. cbn [fold_right].
      rewrite (none s (or_introl eq_refl)). apply IH. intros t T. apply none. now right.
  Qed.

  Hypothesis closed : cycles segments.

  (* Theorem. However faces are traversed, a face gets its winding number. *)
  Theorem faces_get_winding_numbers (y : vector) (k : Z) : gets_number y k ->
    off y segments /\ k = winding_number y segments.
  Proof.
    intros number. induction number as [y above | y z k _ [free ->] face | y z k _ [free ->] free_z moves].
    - destruct (above_all_is_outside y above) as [free none]. now split.
    - split; [exact (face z (target_lies_on (Segment y z))) |].
      exact (winding_number_along (Segment y z) segments closed face).
    - split; [exact free_z |]. rewrite (step_changes_winding_number y z segments closed free free_z moves). lia.
  Qed.

  Lemma some_point_is_above (least : Q) : exists height, least < height /\
    forall s, In s segments -> vy (source s) < height /\ vy (target s) < height.
  Proof.
    clear closed. induction segments as [| s l (height & more & above)]; [exists (least + 1); split;
      [lra | intros s []] |].
    destruct (least_of (fun v => - v) [height; vy (source s); vy (target s)]) as (most & _ & below); [discriminate |].
    assert (height <= most /\ vy (source s) <= most /\ vy (target s) <= most) as (a & b & c).
    { assert (each : forall v, In v [height; vy (source s); vy (target s)] -> v <= most)
        by (intros v V; specialize (below v V); lra). repeat split; apply each; cbn; tauto. }
    exists (most + 1). split; [lra |]. intros t [<- | T]; [lra |]. destruct (above t T). lra.
  Qed.

  (* And each face gets one. *)
  Theorem each_face_gets_a_number (y : vector) : off y segments -> exists k, gets_number y k.
  Proof.
    intros free. destruct (some_point_is_above (vy y)) as (height & more & above).
    exists (0 + sum (map (signed_crossing_of_step (Vector (vx y) height) y) segments))%Z.
    apply FaceAcross; [now apply UnboundedFace | exact free |]. unfold nonzero, minus. cbn [vx vy]. lra.
  Qed.
End Faces.

(* Theorem, Section 5.2. Close enough to the right of an edge, a traversal of the faces gives a number, and it gives no
   other than the ray counts. *)
Theorem section_5_2_as_printed (p q : region) (edge : segment) :
  (forall chain, In chain p -> no_edge_is_a_point chain) -> (forall chain, In chain q -> no_edge_is_a_point chain) ->
  nonzero (along edge) ->
  let segments := convolution_segments p q in
  eventually (fun e => (exists k, gets_number segments (moved (right_of_middle edge) e) k) /\
    forall k, gets_number segments (moved (right_of_middle edge) e) k ->
      k = winding_number_shifted (right_of_middle edge) segments).
Proof.
  intros p_edges q_edges long segments.
  refine (eventually_implied _ _ _ (shifts_are_small_moves edge segments long)). intros e [free number].
  split; [now apply each_face_gets_a_number |]. intros k face. rewrite <- number.
  apply faces_get_winding_numbers; [exact (convolution_is_closed p q p_edges q_edges) | exact face].
Qed.
