(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Lemma 4.1.4: where states are put together to nodes, as many segments end at a node as start there. *)
From Coq Require Import PeanoNat Lia Bool List Permutation.
From Oplus Require Import numbers winding tangent_set turning_number convolution_size fiber_grid states.
Import ListNotations.

Open Scope nat_scope.

(* Those of a grid's segments that belong to something, in the order of all_segments. *)
Definition those (n m : nat) (belongs : named_segment -> bool) : list named_segment :=
  filter belongs (all_segments n m).

Lemma count_and A (f g : A -> bool) l : count f (filter g l) = count (fun a => g a && f a) l.
Proof.
  unfold count. induction l as [| a l IH]; [reflexivity |]. cbn. destruct (g a); cbn; [| exact IH].
  destruct (f a); cbn; lia.
Qed.

Lemma count_permuted A (f : A -> bool) l l' : Permutation l l' -> count f l = count f l'.
Proof.
  intros p. unfold count. induction p; cbn;
    repeat match goal with |- context [f ?a] => destruct (f a) end; cbn; congruence.
Qed.

Lemma count_all_segments n m (f : named_segment -> bool) :
  count f (all_segments n m) =
  count (fun at_ => f (OfP, at_)) (states n m) + count (fun at_ => f (OfQ, at_)) (states n m).
Proof. unfold all_segments. cbn [list_prod]. rewrite app_nil_r, count_of_two, !count_of_images. reflexivity. Qed.

Lemma count_sums A (f g h k : A -> bool) l :
  (forall a, In a l -> Nat.b2n (f a) + Nat.b2n (g a) = Nat.b2n (h a) + Nat.b2n (k a)) ->
  count f l + count g l = count h l + count k l.
Proof.
  unfold count. induction l as [| a l IH]; intros e; [reflexivity |]. cbn.
  pose proof (e a (or_introl eq_refl)). specialize (IH (fun b I => e b (or_intror I))).
  destruct (f a), (g a), (h a), (k a); cbn in *; lia.
Qed.

(* A segment that ends at a node is counted at the state it leads to. *)
Lemma count_ends n m (belongs : named_segment -> bool) (node : state -> bool) along :
  count (fun at_ => belongs (along, at_) && node (state_after n m (along, at_))) (states n m) =
  count (fun at_ => belongs (segment_to n m along at_) && node at_) (states n m).
Proof.
  rewrite <- (count_permuted _ (fun at_ => belongs (segment_to n m along at_) && node at_) _ _
                (states_permuted n m along)).
  rewrite count_of_images. apply count_equally. intros at_ I. apply in_states in I.
  pose proof (segment_to_after n m (along, at_) I) as e. cbn [fst] in e. now rewrite e.
Qed.

(* A node is any set of states. *)
Lemma as_many_end_as_start n m (belongs : named_segment -> bool) (node : state -> bool) :
  balanced n m belongs ->
  count (fun s => node (state_after n m s)) (those n m belongs) =
  count (fun s => node (state_before s)) (those n m belongs).
Proof.
  intros b. unfold those. rewrite !count_and, !count_all_segments, !count_ends. cbn [state_before snd].
  apply count_sums. intros at_ I. apply in_states in I. specialize (b at_ I).
  unfold entering_state, leaving_state in b.
  destruct (node at_); rewrite ?andb_true_r, ?andb_false_r; [exact b | reflexivity].
Qed.

(* Lemma 4.1.4 at states: as many segments of the convolution of two closed chains lead to any state as leave it. *)
Theorem in_out_degree_at_states (p q : list vector) (i j : nat) :
  no_edge_is_a_point p -> no_edge_is_a_point q ->
  let is_here (at_ : state) := (fst at_ =? i) && (snd at_ =? j) in
  count (fun s => is_here (state_after (length p) (length q) s)) (convolution p q) =
  count (fun s => is_here (state_before s)) (convolution p q).
Proof.
  intros ep eq is_here.
  exact (as_many_end_as_start _ _ _ is_here (convolution_is_balanced p q ep eq)).
Qed.

Lemma count_occ_is_count A B (dec : forall a b : B, {a = b} + {a <> b}) (f : A -> B) x l :
  count_occ dec (map f l) x = count (fun a => if dec (f a) x then true else false) l.
Proof.
  unfold count. induction l as [| a l IH]; [reflexivity |]. cbn.
  destruct (dec (f a) x); cbn; now rewrite IH.
Qed.

(* So the states that segments leave are those to which they lead, in another order. *)
Lemma states_permute (p q : list vector) : no_edge_is_a_point p -> no_edge_is_a_point q ->
  Permutation (map state_before (convolution p q)) (map (state_after (length p) (length q)) (convolution p q)).
Proof.
  intros ep eq. apply (Permutation_count_occ state_eq_dec). intros x. rewrite !count_occ_is_count. symmetry.
  exact (as_many_end_as_start _ _ _ (fun a => if state_eq_dec a x then true else false)
           (convolution_is_balanced p q ep eq)).
Qed.

(* A polygon with holes, or any set of closed chains, is a list of them. *)
Definition region : Type := list (list vector).

(* A convolution segment of two regions: which chain of P, which of Q, and a segment of theirs. *)
Definition segments_of_regions (p q : region) : list ((list vector * list vector) * named_segment) :=
  flat_map (fun chains => map (pair chains) (convolution (fst chains) (snd chains))) (list_prod p q).

Definition plus (u v : vector) : vector := Vector (vx u + vx v) (vy u + vy v).

(* The point of a state, and those where a segment starts and ends. *)
Definition point_of (chains : list vector * list vector) (at_ : state) : vector :=
  plus (nth (fst at_) (fst chains) nowhere) (nth (snd at_) (snd chains) nowhere).
Definition starts_at (s : (list vector * list vector) * named_segment) : vector :=
  point_of (fst s) (state_before (snd s)).
Definition ends_at (s : (list vector * list vector) * named_segment) : vector :=
  point_of (fst s)
    (state_after (length (fst (fst s))) (length (snd (fst s))) (snd s)).

Definition is_point (x y : vector) : bool := Qeq_bool (vx x) (vx y) && Qeq_bool (vy x) (vy y).

Lemma region_points_permute : forall p q : region,
  (forall chain, In chain p -> no_edge_is_a_point chain) ->
  (forall chain, In chain q -> no_edge_is_a_point chain) ->
  Permutation (map starts_at (segments_of_regions p q)) (map ends_at (segments_of_regions p q)).
Proof.
  intros p q P Q. unfold segments_of_regions.
  assert (I : forall chains, In chains (list_prod p q) ->
    no_edge_is_a_point (fst chains) /\ no_edge_is_a_point (snd chains)).
  { intros [a b] I. apply in_prod_iff in I. cbn. split; [apply P | apply Q]; tauto. }
  induction (list_prod p q) as [| chains rest IH]; [reflexivity |].
  cbn [flat_map]. rewrite !map_app, !map_map.
  apply Permutation_app; [| apply IH; intros; apply I; now right].
  destruct (I chains (or_introl eq_refl)) as [A B].
  pose proof (Permutation_map (point_of chains) (states_permute _ _ A B)) as M.
  rewrite !map_map in M. exact M.
Qed.

(* Lemma 4.1.4: at every point as many segments of the convolution end as start. P and Q are any closed
   chains, no two consecutive vertices of one equal: polygons with holes are among them. *)
Theorem in_out_degree (p q : region) (x : vector) :
  (forall chain, In chain p -> no_edge_is_a_point chain) ->
  (forall chain, In chain q -> no_edge_is_a_point chain) ->
  count (fun s => is_point x (ends_at s)) (segments_of_regions p q) =
  count (fun s => is_point x (starts_at s)) (segments_of_regions p q).
Proof.
  intros ep eq. rewrite <- (count_of_images _ _ (is_point x) ends_at), <- (count_of_images _ _ (is_point x) starts_at).
  symmetry. now apply count_permuted, region_points_permute.
Qed.
