(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The convolution of two closed chains as the sums of an edge of one and a vertex of the other that
   belong to it, and how many they are. *)
From Coq Require Import ZArith Lia Bool List.
From Oplus Require Import numbers winding tangent_set turning_number.
Import ListNotations.

Open Scope nat_scope.

Arguments count : simpl never.

Definition nowhere : vector := Vector 0 0.

(* The edge that leaves vertex i, and the corner at vertex j. *)
Definition edge_of_chain (chain : list vector) (i : nat) : vector := nth i (edge_directions chain) nowhere.
Definition corner_of_chain (chain : list vector) (j : nat) : corner :=
  nth j (corners chain) (Corner nowhere nowhere).

(* Whether a convolution segment (thesis, Definition 2.2.7) leaves the state of vertex i of P and vertex j of Q along
   the edge of P, or that of Q, which begins there: the edge's direction is in the tangent set of the other vertex. *)
Definition is_convolution_segment (p q : list vector) (along : summand) (i j : nat) : bool :=
  match along with
  | OfP => in_tangent_set (Direction (edge_of_chain p i) OfP) (corner_of_chain q j)
  | OfQ => in_tangent_set (Direction (edge_of_chain q j) OfQ) (corner_of_chain p i)
  end.

(* All of them, each named by its state and the summand whose edge it is along. *)
Definition convolution (p q : list vector) : list (summand * (nat * nat)) :=
  filter (fun s => is_convolution_segment p q (fst s) (fst (snd s)) (snd (snd s)))
    (list_prod [OfP; OfQ] (list_prod (seq 0 (length p)) (seq 0 (length q)))).

Lemma count_of_two : forall A (f : A -> bool) l m, count f (l ++ m) = count f l + count f m.
Proof. intros A f l m. unfold count. rewrite filter_app, app_length. reflexivity. Qed.

Lemma count_of_images : forall A B (f : B -> bool) (g : A -> B) l, count f (map g l) = count (fun a => f (g a)) l.
Proof.
  intros A B f g l. unfold count. induction l as [| a l IH]; [reflexivity |].
  cbn. destruct (f (g a)); cbn; rewrite IH; reflexivity.
Qed.

Lemma count_equally : forall A (f g : A -> bool) l, (forall a, In a l -> f a = g a) -> count f l = count g l.
Proof. intros A f g l H. unfold count. f_equal. apply filter_ext_in. exact H. Qed.

Lemma count_column : forall A B (f : B * A -> bool) a l m,
  count f (list_prod m (a :: l)) = count (fun b => f (b, a)) m + count f (list_prod m l).
Proof.
  intros A B f a l m. induction m as [| b m IH]; [reflexivity |].
  change (list_prod (b :: m) (a :: l)) with (map (pair b) (a :: l) ++ list_prod m (a :: l)).
  change (list_prod (b :: m) l) with (map (pair b) l ++ list_prod m l).
  change (b :: m) with ([b] ++ m).
  change (a :: l) with ([a] ++ l) at 1. rewrite map_app, !count_of_two, IH.
  unfold count at 1 5. cbn. destruct (f (b, a)); cbn; lia.
Qed.

Lemma count_exchanged : forall A B (f : A * B -> bool) l m,
  count f (list_prod l m) = count (fun p => f (snd p, fst p)) (list_prod m l).
Proof.
  intros A B f l m. induction l as [| a l IH].
  - induction m as [| b m IM]; [reflexivity | exact IM].
  - rewrite count_column, <- IH. cbn. rewrite count_of_two, count_of_images. reflexivity.
Qed.

Lemma nth_of_all : forall A (l : list A) d, map (fun i => nth i l d) (seq 0 (length l)) = l.
Proof.
  intros A l d. apply nth_ext with (d := d) (d' := d).
  - rewrite map_length, seq_length. reflexivity.
  - intros n L. rewrite map_length, seq_length in L.
    rewrite nth_indep with (d' := nth 0 l d) by (rewrite map_length, seq_length; exact L).
    rewrite (map_nth (fun i => nth i l d) (seq 0 (length l)) 0 n), seq_nth by exact L. reflexivity.
Qed.

Lemma count_of_nth : forall A (f : A -> bool) l d k, length l = k ->
  count (fun i => f (nth i l d)) (seq 0 k) = count f l.
Proof. intros A f l d k <-. rewrite <- (count_of_images _ _ f (fun i => nth i l d)), nth_of_all. reflexivity. Qed.

Lemma edges_length : forall chain, length (edge_directions chain) = length chain.
Proof.
  intros chain. unfold edge_directions. rewrite map_length.
  rewrite <- (map_length source (edges chain)). destruct (edges_ends chain) as [-> _]. reflexivity.
Qed.

Lemma corners_length : forall chain, length (corners chain) = length chain.
Proof.
  intros chain. unfold corners. rewrite map_length, combine_length.
  rewrite (Permutation.Permutation_length (from_the_last_permutes _ (edge_directions chain))).
  rewrite edges_length. lia.
Qed.

Lemma edges_are_directions : forall chain i s,
  turns_everywhere chain -> i < length chain -> proper (Direction (edge_of_chain chain i) s).
Proof.
  intros chain i s T L. unfold proper; cbn. unfold edge_of_chain.
  set (e := nth i (edge_directions chain) nowhere).
  assert (I : In e (map outgoing (corners chain))).
  { unfold corners. rewrite map_map.
    change (In e (map snd (combine (from_the_last (edge_directions chain)) (edge_directions chain)))).
    destruct (combine_ends _ _ (from_the_last (edge_directions chain)) (edge_directions chain)) as [_ M].
    - apply Permutation.Permutation_length, from_the_last_permutes.
    - rewrite M. apply nth_In. rewrite edges_length. exact L. }
  apply in_map_iff in I. destruct I as (c & <- & I). apply (T c I).
Qed.

(* How many vertices of a chain have an edge of the other in their tangent sets. *)
Lemma covered : forall chain other side i,
  turns_everywhere chain -> turns_everywhere other -> i < length chain ->
  Z.of_nat (count (fun j => in_tangent_set (Direction (edge_of_chain chain i) side)
                              (nth j (corners other) (Corner nowhere nowhere)))
              (seq 0 (length other))) =
  (turning_number other + Z.of_nat (reflex_vertices other))%Z.
Proof.
  intros chain other side i C O I.
  rewrite (count_of_nth _ (in_tangent_set (Direction (edge_of_chain chain i) side)) (corners other)
             (Corner nowhere nowhere)) by apply corners_length.
  apply tangent_sets_cover; [assumption |]. apply edges_are_directions; assumption.
Qed.

Lemma covered_by_q : forall p q i,
  turns_everywhere p -> turns_everywhere q -> i < length p ->
  Z.of_nat (count (fun j => is_convolution_segment p q OfP i j) (seq 0 (length q))) =
  (turning_number q + Z.of_nat (reflex_vertices q))%Z.
Proof. intros p q i. exact (covered p q OfP i). Qed.

Lemma covered_by_p : forall p q j,
  turns_everywhere p -> turns_everywhere q -> j < length q ->
  Z.of_nat (count (fun i => is_convolution_segment p q OfQ i j) (seq 0 (length p))) =
  (turning_number p + Z.of_nat (reflex_vertices p))%Z.
Proof. intros p q j P Q. exact (covered q p OfQ j Q P). Qed.

Lemma rows_of_equal_size : forall A B (f : A * B -> bool) l m z,
  (forall a, In a l -> Z.of_nat (count (fun b => f (a, b)) m) = z) ->
  Z.of_nat (count f (list_prod l m)) = (Z.of_nat (length l) * z)%Z.
Proof.
  intros A B f l m z H. induction l as [| a l IH]; [reflexivity |].
  change (list_prod (a :: l) m) with (map (pair a) m ++ list_prod l m).
  rewrite count_of_two, count_of_images, Nat2Z.inj_add, (H a) by (left; reflexivity).
  rewrite IH by (intros; apply H; right; assumption). cbn [length]. lia.
Qed.

(* Theorem. The size of the convolution of two closed chains of n_P and n_Q vertices, of which r_P and
   r_Q are reflex, and of turning numbers t_P and t_Q, is n_P (t_Q + r_Q) + n_Q (t_P + r_P). *)
Theorem convolution_size_by_turning_numbers : forall p q,
  turns_everywhere p -> turns_everywhere q ->
  Z.of_nat (length (convolution p q)) =
  (Z.of_nat (length p) * (turning_number q + Z.of_nat (reflex_vertices q)) +
   Z.of_nat (length q) * (turning_number p + Z.of_nat (reflex_vertices p)))%Z.
Proof.
  intros p q P Q. unfold convolution. fold (count (fun s : summand * (nat * nat) =>
    is_convolution_segment p q (fst s) (fst (snd s)) (snd (snd s)))
    (list_prod [OfP; OfQ] (list_prod (seq 0 (length p)) (seq 0 (length q))))).
  cbn [list_prod]. rewrite app_nil_r, count_of_two, !count_of_images, Nat2Z.inj_add. cbn [fst snd].
  f_equal.
  - rewrite (rows_of_equal_size _ _ _ _ _ (turning_number q + Z.of_nat (reflex_vertices q)));
      [now rewrite seq_length |].
    intros i I. apply in_seq in I. apply (covered_by_q p q i); [assumption .. | lia].
  - rewrite count_exchanged.
    rewrite (rows_of_equal_size _ _ _ _ _ (turning_number p + Z.of_nat (reflex_vertices p)));
      [now rewrite seq_length |].
    intros j J. apply in_seq in J. apply (covered_by_p p q j); [assumption .. | lia].
Qed.

(* Theorem. The size of the convolution of two closed chains of turning number one, of n_P and n_Q
   vertices, of which r_P and r_Q are reflex, is n_P (1 + r_Q) + n_Q (1 + r_P). *)
Theorem convolution_size : forall p q,
  turns_everywhere p -> turns_everywhere q -> turning_number p = 1%Z -> turning_number q = 1%Z ->
  length (convolution p q) =
  length p * (1 + reflex_vertices q) + length q * (1 + reflex_vertices p).
Proof.
  intros p q P Q NP NQ. pose proof (convolution_size_by_turning_numbers p q P Q) as S.
  rewrite NP, NQ in S. nia.
Qed.
