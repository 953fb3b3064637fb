(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The same pieces in less time: copies of pieces are found in a search tree, and segments that do not span the
   height of a ray are passed over. *)
From Coq Require Import QArith ZArith Lia Bool List SetoidList Orders OrdersEx MSetAVL.
From Oplus Require Import direction angular_crossings winding_number shifted_ray.
Import ListNotations.

Module Number := PairOrderedType Z_as_OT Positive_as_OT.
Module Place := PairOrderedType Number Number.
Module Key := PairOrderedType Place Place.
Module Keys := MSetAVL.Make Key.

Definition key_of_number (q : Q) : Number.t := (Qnum q, Qden q).
Definition key_of_vector (v : vector) : Place.t := (key_of_number (vx v), key_of_number (vy v)).
Definition key_of (s : segment) : Key.t := (key_of_vector (source s), key_of_vector (target s)).
Definition number_of (k : Number.t) : Q := Qmake (fst k) (snd k).
Definition vector_of_key (k : Place.t) : vector := Vector (number_of (fst k)) (number_of (snd k)).
Definition segment_of_key (k : Key.t) : segment := Segment (vector_of_key (fst k)) (vector_of_key (snd k)).

Definition without_copies (l : list segment) : list segment :=
  map segment_of_key (Keys.elements (fold_left (fun set s => Keys.add (key_of s) set) l Keys.empty)).

Lemma key_and_back (s : segment) : segment_of_key (key_of s) = s.
Proof. now destruct s as [[[a b] [c d]] [[e f] [g h]]]. Qed.

Lemma equal_keys (a b : Key.t) : Key.eq a b <-> a = b.
Proof.
  destruct a as [[[a1 a2] [a3 a4]] [[a5 a6] [a7 a8]]], b as [[[b1 b2] [b3 b4]] [[b5 b6] [b7 b8]]].
  split; [| intros ->; reflexivity]. intros [[[u1 u2] [u3 u4]] [[u5 u6] [u7 u8]]]. cbn in *.
  repeat match goal with H : RelationPairs.RelCompFun _ _ _ _ |- _ => unfold RelationPairs.RelCompFun in H;
    cbn in H end.
  congruence.
Qed.

Lemma in_keys (a : Key.t) (l : list Key.t) : InA Key.eq a l <-> In a l.
Proof.
  rewrite InA_alt. split; [intros (b & equal & I); apply equal_keys in equal; now subst | intros I; exists a; split;
    [reflexivity | exact I]].
Qed.

Lemma in_without_copies (s : segment) (l : list segment) : In s (without_copies l) <-> In s l.
Proof.
  assert (in_set : forall l set a, Keys.In a (fold_left (fun set s => Keys.add (key_of s) set) l set) <->
    Keys.In a set \/ exists t, In t l /\ a = key_of t).
  { clear. induction l as [| t l IH]; intros set a; cbn [fold_left].
    - split; [tauto | intros [I | (t & [] & _)]; exact I].
    - rewrite IH, Keys.add_spec, equal_keys. split.
      + intros [[-> | I] | (u & U & ->)]; [right; exists t; cbn; tauto | tauto | right; exists u; cbn; tauto].
      + intros [I | (u & [<- | U] & ->)]; [tauto | tauto | right; exists u; tauto]. }
  unfold without_copies. rewrite in_map_iff. split.
  - intros (k & <- & I). apply in_keys, Keys.elements_spec1, in_set in I. destruct I as [I | (t & T & ->)].
    + now apply Keys.empty_spec in I.
    + now rewrite key_and_back.
  - intros I. exists (key_of s). split; [apply key_and_back |]. apply in_keys, Keys.elements_spec1, in_set.
    right. now exists s.
Qed.

Lemma without_copies_is_distinct (l : list segment) : NoDup (without_copies l).
Proof.
  assert (back : forall k, key_of (segment_of_key k) = k)
    by (intros [[[a1 a2] [a3 a4]] [[a5 a6] [a7 a8]]]; reflexivity).
  apply FinFun.Injective_map_NoDup; [intros j k same; now rewrite <- (back j), same |].
  pose proof (Keys.elements_spec2w (fold_left (fun set s => Keys.add (key_of s) set) l Keys.empty)) as distinct_.
  induction distinct_; constructor; [now rewrite <- in_keys | assumption].
Qed.

(* Only what spans the height needs a side. *)
Definition fast_crossing (p : shifted_point) (s : segment) : Z :=
  let below a := if is_above p then at_most (vy a) (vy (at_ p)) else negb (at_most (vy (at_ p)) (vy a)) in
  let from := below (source s) in
  let to := below (target s) in
  if Bool.eqb from to then 0%Z else ray_crossing from to (side p s).

Lemma fast_crossing_is (p : shifted_point) (s : segment) : fast_crossing p s = signed_crossing_of_shifted p s.
Proof.
  unfold fast_crossing, signed_crossing_of_shifted, ray_crossing. destruct (Bool.eqb _ _); reflexivity.
Qed.

Definition number_to_the_right (segments : list segment) (e : segment) : Z :=
  let p := right_of_middle e in fold_left (fun n s => (n + fast_crossing p s)%Z) segments 0%Z.

Lemma number_to_the_right_is (segments : list segment) (e : segment) :
  number_to_the_right segments e = winding_number_shifted (right_of_middle e) segments.
Proof.
  unfold number_to_the_right, winding_number_shifted. set (p := right_of_middle e).
  enough (from : forall n, fold_left (fun n s => (n + fast_crossing p s)%Z) segments n =
    (n + sum (map (signed_crossing_of_shifted p) segments))%Z) by (rewrite from; lia).
  induction segments as [| s l IH]; intros n; cbn [fold_left map]; [unfold sum; cbn; lia |].
  rewrite IH, fast_crossing_is. unfold sum. cbn [fold_right]. lia.
Qed.
