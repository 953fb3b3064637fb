(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Chains turned, their vertices in the other order: the same points, and the opposite winding number. And a square
   that contains chains: around a point outside of it they do not go. For complements in a frame
   (inner_fit_program.v). *)
From Coq Require Import QArith Lqa Qabs ZArith Lia Bool List Permutation.
From Oplus Require Import specification_bridge regions_and_sums pieces kept_pieces_go_round sum_is_right
  region_of_pieces naive_collision coordinates.
Import ListNotations.

Open Scope Q_scope.

(* The same first vertex, the others backwards. *)
Definition turned_chain {A : Type} (c : list A) : list A :=
  match c with [] => [] | first :: rest => first :: rev rest end.

Lemma edges_are_consecutive (first : vector) (rest : list vector) :
  edges (first :: rest) = consecutive (first :: rest ++ [first]).
Proof.
  unfold edges. cbn [rotated]. generalize first at 2 4. intros last. revert first.
  induction rest as [| v rest IH]; intros first; [reflexivity |].
  cbn [app combine map consecutive]. f_equal. apply IH.
Qed.

Lemma consecutive_of_more (l : list vector) (a b : vector) :
  consecutive (l ++ [a; b]) = consecutive (l ++ [a]) ++ [Segment a b].
Proof.
  induction l as [| v l IH]; [reflexivity |]. destruct l as [| w l]; [reflexivity |].
  change (consecutive ((v :: w :: l) ++ [a; b])) with (Segment v w :: consecutive ((w :: l) ++ [a; b])).
  rewrite IH. reflexivity.
Qed.

Lemma consecutive_backwards (l : list vector) : consecutive (rev l) = rev (map reversed (consecutive l)).
Proof.
  induction l as [| a l IH]; [reflexivity |]. destruct l as [| b l]; [reflexivity |].
  change (consecutive (a :: b :: l)) with (Segment a b :: consecutive (b :: l)). cbn [map rev] in *.
  rewrite <- IH, <- app_assoc. apply consecutive_of_more.
Qed.

Lemma edges_of_turned (c : list vector) : edges (turned_chain c) = rev (map reversed (edges c)).
Proof.
  destruct c as [| first rest]; [reflexivity |]. cbn [turned_chain]. rewrite !edges_are_consecutive.
  rewrite <- consecutive_backwards. f_equal. cbn [rev]. rewrite rev_app_distr. reflexivity.
Qed.

Lemma region_edges_of_turned (r : region) :
  Permutation (region_edges (map turned_chain r)) (map reversed (region_edges r)).
Proof.
  unfold region_edges. induction r as [| c r IH]; [reflexivity |]. cbn [map flat_map]. rewrite map_app, edges_of_turned.
  apply Permutation_app; [| exact IH]. apply Permutation_sym, Permutation_rev.
Qed.

Lemma lies_on_reversed (w : vector) (s : segment) : lies_on w (reversed s) <-> lies_on w s.
Proof.
  split; intros (k & range & X & Y); at_fraction (1 - k).
Qed.

Lemma on_turned (x : vector) (r : region) : (exists s, In s (region_edges (map turned_chain r)) /\ lies_on x s) <->
  (exists s, In s (region_edges r) /\ lies_on x s).
Proof.
  split; intros (s & S & on).
  - apply (Permutation_in _ (region_edges_of_turned r)), in_map_iff in S. destruct S as (t & <- & T). exists t.
    split; [exact T | now apply lies_on_reversed].
  - exists (reversed s). split; [| now apply lies_on_reversed].
    apply (Permutation_in _ (Permutation_sym (region_edges_of_turned r))). now apply in_map.
Qed.

Lemma winding_number_of_turned (x : vector) (r : region) :
  winding_number x (region_edges (map turned_chain r)) = (- winding_number x (region_edges r))%Z.
Proof.
  rewrite (permuted_winding_number x _ _ (region_edges_of_turned r)).
  unfold winding_number. rewrite map_map. unfold sum. induction (region_edges r) as [| s l IH]; [reflexivity |].
  cbn [map fold_right]. rewrite IH, signed_crossing_reversed. lia.
Qed.

(* A square around the origin. *)
Definition in_square (k : Q) (v : vector) : Prop := - k <= vx v <= k /\ - k <= vy v <= k.

Definition is_in_square (k : Q) (v : vector) : bool :=
  Qle_bool (- k) (vx v) && Qle_bool (vx v) k && Qle_bool (- k) (vy v) && Qle_bool (vy v) k.

Lemma is_in_square_spec (k : Q) (v : vector) : reflect (in_square k v) (is_in_square k v).
Proof. apply iff_reflect. unfold in_square, is_in_square. rewrite !andb_true_iff, !Qle_bool_iff. tauto. Qed.

Lemma in_larger_square (k l : Q) (v : vector) : k <= l -> in_square k v -> in_square l v.
Proof. unfold in_square. lra. Qed.

Lemma squares_are_convex (k : Q) (s : segment) (w : vector) :
  in_square k (source s) -> in_square k (target s) -> lies_on w s -> in_square k w.
Proof.
  intros [sx sy] [tx ty] (t & range & X & Y). unfold in_square. rewrite X, Y. split; split; nra.
Qed.

(* Theorem. Closed chains inside a square do not go round a point outside. *)
Theorem nothing_goes_round_outside (k : Q) (segments : list segment) (x : vector) : cycles segments ->
  (forall s, In s segments -> in_square k (source s) /\ in_square k (target s)) -> ~ in_square k x ->
  winding_number x segments = 0%Z.
Proof.
  intros closed all outside.
  assert (none : forall y : vector, vx y > k \/ vy y > k \/ vy y < - k -> winding_number y segments = 0%Z).
  { intros y far. unfold winding_number.
    assert (each : forall s, In s segments -> signed_crossing y s = 0%Z).
    { intros s S. destruct (all s S) as [in_source in_target]. rewrite signed_crossing_by_height.
      destruct (spans s (vy y)) eqn:spanning; [| reflexivity].
      pose proof (point_at_height_lies_on s (vy y) spanning) as on.
      destruct (squares_are_convex k s _ in_source in_target on) as [in_x in_y].
      change (vy (point_at_height s (vy y))) with (vy y) in in_y.
      destruct (negative_spec (vx y - vx (point_at_height s (vy y)))); [exfalso; lra | reflexivity]. }
    now apply sum_of_zeros. }
  destruct (Qlt_le_dec k (vx x)) as [right_ | not_right]; [now apply none; left |].
  destruct (Qlt_le_dec k (vy x)) as [above | not_above]; [apply none; tauto |].
  destruct (Qlt_le_dec (vy x) (- k)) as [below | not_below]; [apply none; tauto |].
  assert (left_ : vx x < - k) by (apply Qnot_le_lt; intros inside_; apply outside; unfold in_square; lra).
  pose proof (winding_number_along (Segment x (Vector (vx x) (k + 1))) segments closed) as same_.
  cbn [source target] in same_. rewrite same_; [apply none; cbn [vx vy]; right; left; lra |].
  intros w (t & _ & X & _) s S on. cbn [source target vx] in X.
  destruct (all s S) as [in_source in_target]. destruct (squares_are_convex k s w in_source in_target on) as [in_x _].
  assert (vx w == vx x) by (rewrite X; ring). lra.
Qed.

(* What holds at u, and stays in steps of less than m along a segment, holds at v: by halving. *)
Lemma stays_in_steps (A : vector -> Prop) (m : Q) (n : nat) : forall u v, within (m * inject_Z (2 ^ Z.of_nat n)) u v ->
  (forall w y, lies_on w (Segment u v) -> lies_on y (Segment u v) -> within m w y -> A w -> A y) -> A u -> A v.
Proof.
  induction n as [| n IH]; intros u v close step start.
  - apply (step u); [apply (source_lies_on (Segment u v)) | apply (target_lies_on (Segment u v)) | | exact start].
    change (inject_Z (2 ^ Z.of_nat 0)) with 1 in close. unfold within in *. lra.
  - rewrite Nat2Z.inj_succ, Z.pow_succ_r, inject_Z_mult in close by lia. change (inject_Z 2) with 2 in close.
    assert (on : lies_on (middle (Segment u v)) (Segment u v)) by (at_fraction (1 # 2)).
    apply (IH (middle (Segment u v)) v); [by_computing | | apply (IH u); [by_computing | | exact start]];
      intros w y W Y; apply step; (eapply common_part; [| | eassumption]); trivial;
      (apply (source_lies_on (Segment u v)) || apply (target_lies_on (Segment u v))).
Qed.

Lemma some_steps (m : Q) (u v : vector) : 0 < m -> exists n, within (m * inject_Z (2 ^ Z.of_nat n)) u v.
Proof.
  intros some. pose proof (abs_bounds (vx v - vx u)). pose proof (abs_bounds (vy v - vy u)).
  destruct (Qarchimedean ((Qabs (vx v - vx u) + Qabs (vy v - vy u)) / m)) as [p less]. exists (Pos.to_nat p).
  rewrite positive_nat_Z. pose proof (Z.pow_gt_lin_r 2 (Zpos p) ltac:(lia) ltac:(lia)) as more.
  rewrite Zlt_Qlt in more. apply (Qlt_trans _ _ _ less), (Qmult_lt_l _ _ m some) in more.
  rewrite Qmult_div_r in more by lra. unfold within. lra.
Qed.
