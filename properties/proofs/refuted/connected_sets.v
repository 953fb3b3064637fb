(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Connected sets of points: two of their points are joined by a path of straight steps inside the set. For what
   polygons bound, this is what connected means; over rational numbers it is the notion that makes sense. *)
From Coq Require Import QArith List.
From Oplus Require Import winding meeting_of_segments.
Import ListNotations.

(* The path leads from a to b inside A. *)
Fixpoint leads_through (A : vector -> Prop) (a : vector) (path : list vector) (b : vector) : Prop :=
  match path with
  | [] => forall z, lies_on z (Segment a b) -> A z
  | c :: rest => (forall z, lies_on z (Segment a c) -> A z) /\ leads_through A c rest b
  end.

Definition connected_in (A : vector -> Prop) (a b : vector) : Prop := exists path, leads_through A a path b.

(* A has k connected components: one for each of k points. *)
Definition has_components (A : vector -> Prop) (k : nat) : Prop :=
  exists points, length points = k /\ (forall a, In a points -> A a) /\
    (forall z, A z -> exists a, In a points /\ connected_in A z a) /\
    ForallOrdPairs (fun a b => ~ connected_in A a b) points.

Lemma leads_further (A : vector -> Prop) (path : list vector) : forall a b c, leads_through A a path b ->
  (forall z, lies_on z (Segment b c) -> A z) -> leads_through A a (path ++ [b]) c.
Proof.
  induction path as [| d rest IH]; intros a b c walk step; cbn [leads_through app] in *; [now split |].
  destruct walk as [first_ walk]. split; [exact first_ | now apply IH].
Qed.

Lemma leads_to_a_point (A : vector -> Prop) (path : list vector) : forall a b, leads_through A a path b -> A b.
Proof.
  induction path as [| c rest IH]; intros a b; cbn [leads_through].
  - intros step. apply step, (target_lies_on (Segment a b)).
  - intros [_ walk]. exact (IH c b walk).
Qed.
