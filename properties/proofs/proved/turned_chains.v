(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Chains turned, their vertices in the other order: the same points, and the opposite winding number. And a square
   that contains chains: around a point outside of it they do not go. For complements in a frame
   (inner_fit_program.v). *)
From Coq Require Import QArith Lqa Qabs ZArith Lia Bool List Permutation.
From Oplus Require Import convolution signed_crossings meeting_of_segments regions first_hit pieces
  kept_pieces_go_round sum_is_right region_of_pieces.
Import ListNotations.

Open Scope Q_scope.

(* The same first vertex, the others backwards. *)
Definition turned_chain {A : Type} (c : list A) : list A := match c with [] => [] | first :: rest => first :: rev rest
  end.

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
  split; intros (k & range & X & Y); exists (1 - k); cbn [reversed source target] in *; (split; [lra |]);
    rewrite X, Y; split; ring.
Qed.

Lemma on_turned (x : vector) (r : region) :
  (exists s, In s (region_edges (map turned_chain r)) /\ lies_on x s) <-> (exists s, In s (region_edges r) /\ lies_on
    x s).
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
Proof.
  apply iff_reflect. unfold in_square, is_in_square. rewrite !andb_true_iff, !Qle_bool_iff. tauto.
Qed.

Lemma in_larger_square (k l : Q) (v : vector) : k <= l -> in_square k v -> in_square l v.
Proof. unfold in_square. lra. Qed.

Lemma squares_are_convex (k : Q) (s : segment) (w : vector) :
  in_square k (source s) -> in_square k (target s) -> lies_on w s -> in_square k w.
Proof.
  intros [sx sy] [tx ty] (t & range & X & Y). unfold in_square. rewrite X, Y.
  assert (mixed : forall a b, - k <= a <= k -> - k <= b <= k -> - k <= (1 - t) * a + t * b <= k).
  { intros a b A B. assert (0 <= (1 - t) * (a + k)) by (apply Qmult_le_0_compat; lra).
    assert (0 <= t * (b + k)) by (apply Qmult_le_0_compat; lra).
    assert (0 <= (1 - t) * (k - a)) by (apply Qmult_le_0_compat; lra).
    assert (0 <= t * (k - b)) by (apply Qmult_le_0_compat; lra). lra. }
  split; now apply mixed.
Qed.

(* Theorem. Closed chains inside a square do not go round a point outside. *)
Theorem nothing_goes_round_outside (k : Q) (segments : list segment) (x : vector) : cycles segments ->
  (forall s, In s segments -> in_square k (source s) /\ in_square k (target s)) -> ~ in_square k x ->
  winding_number x segments = 0%Z.
Proof.
  intros closed all outside.
  assert (none : forall y : vector, vx y > k \/ vy y > k \/ vy y < - k -> winding_number y segments = 0%Z).
  { intros y far. unfold winding_number, sum.
    assert (each : forall s, In s segments -> signed_crossing y s = 0%Z).
    { intros s S. destruct (all s S) as [in_source in_target]. rewrite signed_crossing_by_height.
      destruct (spans s (vy y)) eqn:spanning; [| reflexivity].
      pose proof (squares_are_convex k s _ in_source in_target (point_at_height_lies_on s (vy y) spanning)) as [in_x
        in_y].
      change (vy (point_at_height s (vy y))) with (vy y) in in_y.
      destruct (negative_spec (vx y - vx (point_at_height s (vy y)))); [exfalso; lra | reflexivity]. }
    clear all closed. induction segments as [| s l IH]; [reflexivity |]. cbn [map fold_right].
    rewrite each, IH; [reflexivity | | now left]. intros t T. apply each. now right. }
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

(* A segment that leaves a square of half the size 2 m has a point outside of it that is in the square of 3 m. *)
Lemma first_exit (a b m : Q) : 0 < m -> - (2 * m) <= a <= 2 * m ->
  exists t, 0 <= t <= 1 /\ (forall s, 0 <= s <= t -> - (3 * m) <= (1 - s) * a + s * b <= 3 * m) /\
    (t == 1 \/ (1 - t) * a + t * b == 3 * m \/ (1 - t) * a + t * b == - (3 * m)).
Proof.
  intros some inside_.
  destruct (Qlt_le_dec (3 * m) b) as [over | not_over].
  - exists ((3 * m - a) / (b - a)).
    assert (value : (3 * m - a) / (b - a) * (b - a) == 3 * m - a) by (field; lra).
    assert (range : 0 <= (3 * m - a) / (b - a) <= 1) by (split; [apply Qle_shift_div_l; lra | apply Qle_shift_div_r;
      lra]).
    set (t := (3 * m - a) / (b - a)) in *. clearbody t. split; [exact range |]. split; [| lra].
    intros s s_range. assert (0 <= s * (b - a)) by (apply Qmult_le_0_compat; lra).
    assert (0 <= (t - s) * (b - a)) by (apply Qmult_le_0_compat; lra). lra.
  - destruct (Qlt_le_dec b (- (3 * m))) as [under | not_under].
    + exists ((3 * m + a) / (a - b)).
      assert (value : (3 * m + a) / (a - b) * (a - b) == 3 * m + a) by (field; lra).
      assert (range : 0 <= (3 * m + a) / (a - b) <= 1) by (split; [apply Qle_shift_div_l; lra | apply Qle_shift_div_r;
        lra]).
      set (t := (3 * m + a) / (a - b)) in *. clearbody t. split; [exact range |]. split; [| lra].
      intros s s_range. assert (0 <= s * (a - b)) by (apply Qmult_le_0_compat; lra).
      assert (0 <= (t - s) * (a - b)) by (apply Qmult_le_0_compat; lra). lra.
    + exists 1. split; [lra |]. split; [| left; reflexivity]. intros s range.
      assert (0 <= (1 - s) * (a + 3 * m)) by (apply Qmult_le_0_compat; lra).
      assert (0 <= s * (b + 3 * m)) by (apply Qmult_le_0_compat; lra).
      assert (0 <= (1 - s) * (3 * m - a)) by (apply Qmult_le_0_compat; lra).
      assert (0 <= s * (3 * m - b)) by (apply Qmult_le_0_compat; lra). lra.
Qed.

Lemma leaves_the_square (u v : vector) (m : Q) : 0 < m -> in_square (2 * m) u -> ~ in_square (2 * m) v ->
  exists w, lies_on w (Segment u v) /\ in_square (3 * m) w /\ ~ in_square (2 * m) w.
Proof.
  intros some [in_x in_y] out.
  destruct (first_exit (vx u) (vx v) m some in_x) as (t1 & range_1 & before_1 & end_1).
  destruct (first_exit (vy u) (vy v) m some in_y) as (t2 & range_2 & before_2 & end_2).
  assert (take : forall t, 0 <= t <= t1 -> t <= t2 -> t == 1 \/ t == t1 /\ ~ t1 == 1 \/ t == t2 /\ ~ t2 == 1 ->
    exists w, lies_on w (Segment u v) /\ in_square (3 * m) w /\ ~ in_square (2 * m) w).
  { intros t T1 T2 which. exists (Vector ((1 - t) * vx u + t * vx v) ((1 - t) * vy u + t * vy v)).
    specialize (before_1 t ltac:(lra)). specialize (before_2 t ltac:(lra)).
    split; [exists t; split; [lra | split; reflexivity] |]. split; [now split |].
    intros [still_x still_y]. cbn [vx vy] in *. destruct which as [whole | [[at_1 less] | [at_2 less]]].
    - apply out. rewrite whole in still_x, still_y. split; lra.
    - rewrite at_1 in still_x. destruct end_1 as [? | [? | ?]]; [contradiction | lra | lra].
    - rewrite at_2 in still_y. destruct end_2 as [? | [? | ?]]; [contradiction | lra | lra]. }
  destruct (Qlt_le_dec t1 t2) as [less | not_less].
  - apply (take t1); [lra | lra |]. right. left. split; [reflexivity | lra].
  - apply (take t2); [lra | lra |]. destruct (Qeq_dec t2 1) as [whole | part]; [now left | right; right].
    split; [reflexivity | exact part].
Qed.
