(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Finite sums over lists, over cyclic indices, and over the fiber grid, summation by parts in both of its
   directions included. *)
From Coq Require Import ZArith Lia Bool List Permutation.
From Oplus Require Import winding turning_number fiber_grid states distinct.
Import ListNotations.

Open Scope Z_scope.

Definition sum_of {A} (f : A -> Z) (l : list A) : Z := sum (map f l).

Lemma sum_of_nil A (f : A -> Z) : sum_of f [] = 0.
Proof. reflexivity. Qed.

Lemma sum_of_more A (f : A -> Z) a l : sum_of f (a :: l) = f a + sum_of f l.
Proof. reflexivity. Qed.

Lemma sum_of_two_lists A (f : A -> Z) l m : sum_of f (l ++ m) = sum_of f l + sum_of f m.
Proof. unfold sum_of. now rewrite map_app, sum_of_both. Qed.

Lemma sum_equally A (f g : A -> Z) l : (forall a, In a l -> f a = g a) -> sum_of f l = sum_of g l.
Proof. intros equal. unfold sum_of. f_equal. now apply map_ext_in. Qed.

Lemma sum_plus A (f g : A -> Z) l : sum_of (fun a => f a + g a) l = sum_of f l + sum_of g l.
Proof. induction l as [| a l IH]; [reflexivity |]. rewrite !sum_of_more, IH. lia. Qed.

Lemma sum_minus A (f g : A -> Z) l : sum_of (fun a => f a - g a) l = sum_of f l - sum_of g l.
Proof. induction l as [| a l IH]; [reflexivity |]. rewrite !sum_of_more, IH. lia. Qed.

Lemma sum_times A (f : A -> Z) c l : sum_of (fun a => c * f a) l = c * sum_of f l.
Proof. induction l as [| a l IH]; [rewrite !sum_of_nil; lia |]. rewrite !sum_of_more, IH. lia. Qed.

Lemma sum_of_images A B (f : B -> Z) (g : A -> B) l : sum_of f (map g l) = sum_of (fun a => f (g a)) l.
Proof. unfold sum_of. now rewrite map_map. Qed.

Lemma sum_of_flat_map A B (f : B -> Z) (g : A -> list B) l :
  sum_of f (flat_map g l) = sum_of (fun a => sum_of f (g a)) l.
Proof. induction l as [| a l IH]; [reflexivity |]. cbn [flat_map]. now rewrite sum_of_two_lists, sum_of_more, IH. Qed.

Lemma sum_of_product A B (f : A * B -> Z) l m :
  sum_of f (list_prod l m) = sum_of (fun a => sum_of (fun b => f (a, b)) m) l.
Proof.
  induction l as [| a l IH]; [reflexivity |]. cbn [list_prod].
  now rewrite sum_of_two_lists, sum_of_images, sum_of_more, IH.
Qed.

Lemma sum_of_filter A (f : A -> Z) (belongs : A -> bool) l :
  sum_of f (filter belongs l) = sum_of (fun a => Z.b2z (belongs a) * f a) l.
Proof.
  induction l as [| a l IH]; [reflexivity |]. cbn [filter]. rewrite sum_of_more, <- IH.
  destruct (belongs a); rewrite ?sum_of_more; cbn [Z.b2z]; lia.
Qed.

Lemma sum_of_permuted_list A (f : A -> Z) l m : Permutation l m -> sum_of f l = sum_of f m.
Proof. intros p. induction p; rewrite ?sum_of_more; lia. Qed.

Lemma sums_exchanged A B (f : A -> B -> Z) l m :
  sum_of (fun a => sum_of (f a) m) l = sum_of (fun b => sum_of (fun a => f a b) l) m.
Proof.
  induction l as [| a l IH].
  - symmetry. now apply sum_of_zeros.
  - rewrite sum_of_more, IH, <- sum_plus. now apply sum_equally.
Qed.

Lemma sum_is_not_negative A (f : A -> Z) l : (forall a, In a l -> 0 <= f a) -> 0 <= sum_of f l.
Proof.
  intros terms. induction l as [| a l IH]; [now rewrite sum_of_nil |]. rewrite sum_of_more.
  pose proof (terms a (or_introl eq_refl)). specialize (IH (fun b I => terms b (or_intror I))). lia.
Qed.

Lemma positive_sum A (f : A -> Z) l : 0 < sum_of f l -> exists a, In a l /\ 0 < f a.
Proof.
  induction l as [| a l IH]; [rewrite sum_of_nil; lia |]. rewrite sum_of_more. intros positive.
  destruct (Z_lt_le_dec 0 (f a)) as [here | not_here]; [exists a; split; [now left | exact here] |].
  destruct IH as (b & I & there); [lia |]. exists b. split; [now right | exact there].
Qed.

(* Over the indices below n, which are cyclic. *)
Definition sum_below (n : nat) (f : nat -> Z) : Z := sum_of f (seq 0 n).

Lemma sum_below_equally n (f g : nat -> Z) : (forall i, (i < n)%nat -> f i = g i) -> sum_below n f = sum_below n g.
Proof. intros equal. apply sum_equally. intros i I. apply in_seq in I. apply equal. lia. Qed.

Lemma sum_by_index A (f : A -> Z) (default : A) l n : length l = n ->
  sum_of f l = sum_below n (fun i => f (nth i l default)).
Proof.
  intros <-. unfold sum_below. rewrite <- (sum_of_images _ _ f (fun i => nth i l default)).
  now rewrite convolution_size.nth_of_all.
Qed.

(* A sum over all indices may start anywhere. *)
Lemma sum_of_next n (f : nat -> Z) : sum_below n (fun i => f (next i n)) = sum_below n f.
Proof.
  unfold sum_below. rewrite <- (sum_of_images _ _ f (fun i => next i n)).
  apply sum_of_permuted_list, injective_permutes.
  - apply seq_NoDup.
  - intros i I. rewrite in_seq in *. assert (i < n)%nat as below by lia.
    pose proof (next_in_range i n below). lia.
  - intros i k I K equal. rewrite in_seq in *.
    rewrite <- (previous_next i n), <- (previous_next k n) by lia. now rewrite equal.
Qed.

Lemma sum_of_previous n (f g : nat -> Z) :
  sum_below n (fun i => f (previous n i) * g i) = sum_below n (fun i => f i * g (next i n)).
Proof.
  rewrite <- (sum_of_next n (fun i => f (previous n i) * g i)).
  apply sum_below_equally. intros i I. now rewrite previous_next.
Qed.

Definition sum_over_grid (n m : nat) (f : nat -> nat -> Z) : Z :=
  sum_below n (fun i => sum_below m (f i)).

Lemma grid_equally n m (f g : nat -> nat -> Z) :
  (forall i j, (i < n)%nat -> (j < m)%nat -> f i j = g i j) ->
  sum_over_grid n m f = sum_over_grid n m g.
Proof. intros equal. apply sum_below_equally. intros i I. apply sum_below_equally. auto. Qed.

Lemma grid_plus n m (f g : nat -> nat -> Z) :
  sum_over_grid n m (fun i j => f i j + g i j) = sum_over_grid n m f + sum_over_grid n m g.
Proof. unfold sum_over_grid, sum_below. rewrite <- sum_plus. apply sum_equally. intros i _. apply sum_plus. Qed.

Lemma grid_minus n m (f g : nat -> nat -> Z) :
  sum_over_grid n m (fun i j => f i j - g i j) = sum_over_grid n m f - sum_over_grid n m g.
Proof. unfold sum_over_grid, sum_below. rewrite <- sum_minus. apply sum_equally. intros i _. apply sum_minus. Qed.

Lemma grid_exchanged n m (f : nat -> nat -> Z) : sum_over_grid n m f = sum_over_grid m n (fun j i => f i j).
Proof. apply sums_exchanged. Qed.

Lemma grid_rows n m (c : nat -> Z) (f : nat -> nat -> Z) :
  sum_over_grid n m (fun i j => c i * f i j) = sum_below n (fun i => c i * sum_below m (f i)).
Proof. apply sum_below_equally. intros i _. apply sum_times. Qed.

(* Summation by parts. Let u be c, which depends on j only, plus the difference of w from j - 1 to j; and
   v be b, which depends on i only, less the difference of w from i - 1 to i. *)
Lemma grid_by_parts n m (u v w x y : nat -> nat -> Z) (b c : nat -> Z) :
  (forall i j, (i < n)%nat -> (j < m)%nat -> u i j = c j + w i j - w i (previous m j)) ->
  (forall i j, (i < n)%nat -> (j < m)%nat -> v i j = b i + w (previous n i) j - w i j) ->
  sum_over_grid n m (fun i j => u i j * x i j + v i j * y i j) =
  sum_below n (fun i => b i * sum_below m (y i)) +
  sum_below m (fun j => c j * sum_below n (fun i => x i j)) +
  sum_over_grid n m (fun i j => w i j * (x i j + y (next i n) j - x i (next j m) - y i j)).
Proof.
  intros u_is v_is.
  rewrite <- (grid_rows n m b y), <- (grid_rows m n c (fun j i => x i j)),
    <- (grid_exchanged n m (fun i j => c j * x i j)).
  assert (along_q : sum_over_grid n m (fun i j => w i (previous m j) * x i j) =
                    sum_over_grid n m (fun i j => w i j * x i (next j m))).
  { apply sum_below_equally. intros i _. exact (sum_of_previous m (w i) (x i)). }
  assert (along_p : sum_over_grid n m (fun i j => w (previous n i) j * y i j) =
                    sum_over_grid n m (fun i j => w i j * y (next i n) j)).
  { rewrite (grid_exchanged n m (fun i j => w (previous n i) j * y i j)),
      (grid_exchanged n m (fun i j => w i j * y (next i n) j)). apply sum_below_equally. intros j _.
    exact (sum_of_previous n (fun i => w i j) (fun i => y i j)). }
  transitivity (sum_over_grid n m (fun i j =>
    b i * y i j + c j * x i j + (w i j * x i j - w i j * y i j) +
    (w (previous n i) j * y i j - w i (previous m j) * x i j))).
  { apply grid_equally. intros i j I J. rewrite u_is, v_is by assumption. lia. }
  rewrite (grid_equally n m (fun i j => w i j * (x i j + y (next i n) j - x i (next j m) - y i j))
    (fun i j => (w i j * x i j - w i j * y i j) + (w i j * y (next i n) j - w i j * x i (next j m))))
    by (intros; lia).
  rewrite !grid_plus, !grid_minus, along_p, along_q. lia.
Qed.
