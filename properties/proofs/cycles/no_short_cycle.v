(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Corollary 4.1.9 as printed is false: two chains of n and m vertices need not have a cycle of n + m
   segments. *)
From Coq Require Import PeanoNat QArith Lia Bool List Permutation.
From Oplus Require Import convolution tracing balanced_graph convolution_graph.
Import ListNotations.

Open Scope nat_scope.

Definition some_triangle : list vector := [Vector 0 0; Vector 1 0; Vector 0 1].
Definition dart : list vector := [Vector 0 0; Vector 2 1; Vector 0 2; Vector 1 1].

Definition segment_of_regions : Type := (list vector * list vector) * named_segment.
Definition their_segments : list segment_of_regions :=
  segments_of_regions [some_triangle] [dart].

Lemma segment_of_regions_eq_dec (s t : segment_of_regions) : {s = t} + {s <> t}.
Proof. repeat decide equality. Defined.

Definition joins (s t : segment_of_regions) : bool :=
  if vector_eq_dec (ends_at_node s) (starts_at_node t) then true else false.

(* The segments that start where s ends. *)
Definition followers (s : segment_of_regions) : list segment_of_regions :=
  filter (joins s) their_segments.

Fixpoint reached (steps : nat) (s : segment_of_regions) : list segment_of_regions :=
  match steps with
  | 0 => []
  | S rest => s :: match followers s with [t] => reached rest t | _ => [] end
  end.

(* A closed walk goes on after each of its segments. *)
Lemma walk_goes_on c a s : leads starts_at_node ends_at_node a c a -> In s c -> exists t, In t c /\ joins s t = true.
Proof.
  intros walk I. apply in_split in I. destruct I as (first & last & c_is).
  pose proof walk as l. rewrite c_is in l.
  apply leads_split in l. destruct l as (b & _ & _ & l).
  assert (joined : forall t, starts_at_node t = ends_at_node s -> joins s t = true)
    by (intros t e; unfold joins; rewrite e; now destruct (vector_eq_dec _ _)).
  destruct last as [| t last].
  - cbn in l. destruct c as [| t c]; [now destruct first |].
    exists t. split; [now left |]. apply joined. destruct walk as [from _]. congruence.
  - exists t. split; [rewrite c_is; apply in_or_app; cbn; tauto |]. apply joined. now destruct l.
Qed.

Lemma walk_reaches c a :
  leads starts_at_node ends_at_node a c a -> incl c their_segments ->
  forall steps s, In s c -> incl (reached steps s) c.
Proof.
  intros walk within. induction steps as [| steps IH]; intros s I; [intros t [] |].
  cbn [reached]. apply incl_cons; [exact I |].
  destruct (walk_goes_on c a s walk I) as (t & J & j).
  assert (K : In t (followers s)) by (apply filter_In; split; [now apply within | exact j]).
  destruct (followers s) as [| u [| v others]]; try (intros x []).
  apply IH. destruct K as [<- | []]. exact J.
Qed.

(* The triangle has 3 vertices and the arrow head 4; but every closed walk in their convolution graph, from
   point to point along its segments, none of them taken twice, has 10 segments, not 7. *)
Theorem no_cycle_of_n_plus_m (c : list segment_of_regions) (a : vector) :
  c <> [] -> NoDup c -> incl c their_segments ->
  leads starts_at_node ends_at_node a c a ->
  length c = 10 /\ length c <> length some_triangle + length dart.
Proof.
  intros nonempty distinct within walk.
  assert (round : forall s, In s their_segments -> incl their_segments (reached 10 s)).
  { assert (checked : forallb (fun s => forallb (fun t =>
              if in_dec segment_of_regions_eq_dec t (reached 10 s) then true else false)
              their_segments) their_segments = true) by (vm_compute; reflexivity).
    intros s I t J. rewrite forallb_forall in checked. specialize (checked s I).
    rewrite forallb_forall in checked. specialize (checked t J).
    now destruct (in_dec segment_of_regions_eq_dec t (reached 10 s)). }
  destruct c as [| s c]; [contradiction |].
  assert (all : incl their_segments (s :: c)).
  { eapply incl_tran; [apply (round s), within; now left |].
    apply (walk_reaches (s :: c) a walk within 10 s). now left. }
  assert (ten : length their_segments = 10) by (vm_compute; reflexivity).
  assert (NoDup their_segments) as listed.
  { apply (NoDup_count_occ' segment_of_regions_eq_dec). intros t I.
    assert (checked : forallb (fun t => count_occ segment_of_regions_eq_dec their_segments t =? 1)
              their_segments = true) by (vm_compute; reflexivity).
    rewrite forallb_forall in checked. now apply Nat.eqb_eq, checked. }
  pose proof (NoDup_incl_length distinct within). pose proof (NoDup_incl_length listed all).
  change (length some_triangle + length dart) with 7. lia.
Qed.
