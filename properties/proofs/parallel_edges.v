(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The sums of two edges of one direction are on the convolution. By the tie rule the edge of Q is in the tangent set
   where the edge of P ends, and the edge of P where that of Q begins. Where that vertex is inside a straight line,
   the next edge takes the place of the edge: no chain is straight everywhere (tangent_direction.v). *)
From Coq Require Import QArith Lqa Qfield Lia Bool List Arith.
From Oplus Require Import direction angle cyclic_order tangent_set sweep winding_number turning_number
  convolution_size fiber_grid forward_traversal states in_out_degree convolution_winding regions parallelogram
  tangent_direction touching_corners.
Import ListNotations.

Open Scope Q_scope.

Definition edge_at (chain : list vector) (i : nat) : segment := nth i (edges chain) no_segment.

Lemma edge_at_is (chain : list vector) i : (i < length chain)%nat ->
  edge_at chain i = Segment (nth i chain nowhere) (nth (next i (length chain)) chain nowhere).
Proof. apply edge_by_index. Qed.

Definition on_convolution (x : vector) (p q : region) : Prop :=
  exists s, In s (convolution_segments p q) /\ lies_on x s.

Section TwoChains.
  Variables p q : region.
  Variables a b : list vector.
  Hypothesis in_p : In a p.
  Hypothesis in_q : In b q.
  Hypothesis a_edges : no_edge_is_a_point a.
  Hypothesis b_edges : no_edge_is_a_point b.
  Variable x : vector.

  Lemma convolution_member (along_ : summand) i j :
    (i < length a)%nat -> (j < length b)%nat -> is_convolution_segment a b along_ i j = true ->
    In (Segment (starts_at ((a, b), (along_, (i, j)))) (ends_at ((a, b), (along_, (i, j)))))
      (convolution_segments p q).
  Proof.
    intros I J belongs. apply in_map_iff. exists ((a, b), (along_, (i, j))). split; [reflexivity |].
    apply in_flat_map. exists (a, b). split; [now apply in_prod |]. apply in_map. unfold convolution.
    apply filter_In. split; [| exact belongs]. apply in_prod; [destruct along_; cbn; tauto |].
    apply in_prod; apply in_seq; cbn [fst snd]; lia.
  Qed.

  Lemma on_convolution_by_p i j : (i < length a)%nat -> (j < length b)%nat ->
    in_tangent_set (Direction (edge_of_chain a i) OfP) (corner_of_chain b j) = true ->
    lies_on (minus x (nth j b nowhere)) (edge_at a i) -> on_convolution x p q.
  Proof.
    intros I J tangent (k & range & X & Y). eexists. split; [exact (convolution_member OfP i j I J tangent) |].
    rewrite edge_at_is in X, Y by exact I. exists k. unfold starts_at, ends_at, point_of, plus, minus in *.
    cbn [fst snd source target vx vy state_before state_after step] in *. split; [exact range |]. split; lra.
  Qed.

  Lemma on_convolution_by_q i j : (i < length a)%nat -> (j < length b)%nat ->
    in_tangent_set (Direction (edge_of_chain b j) OfQ) (corner_of_chain a i) = true ->
    lies_on (minus x (nth i a nowhere)) (edge_at b j) -> on_convolution x p q.
  Proof.
    intros I J tangent (k & range & X & Y). eexists. split; [exact (convolution_member OfQ i j I J tangent) |].
    rewrite edge_at_is in X, Y by exact J. exists k. unfold starts_at, ends_at, point_of, plus, minus in *.
    cbn [fst snd source target vx vy state_before state_after step] in *. split; [exact range |]. split; lra.
  Qed.

  Lemma iterated_first (f : nat -> nat) (t i : nat) : Nat.iter t f (f i) = f (Nat.iter t f i).
  Proof.
    induction t as [| t IH]; [reflexivity |].
    change (f (Nat.iter t f (f i)) = f (f (Nat.iter t f i))). now rewrite IH.
  Qed.

  Lemma next_often (n i t : nat) : (i < n)%nat -> Nat.iter t (fun k => next k n) i = ((i + t) mod n)%nat.
  Proof.
    revert i. induction t as [| t IH]; intros i I; [cbn; now rewrite Nat.add_0_r, Nat.mod_small |].
    change (Nat.iter (S t) (fun k => next k n) i) with (next (Nat.iter t (fun k => next k n) i) n).
    rewrite <- (iterated_first (fun k => next k n) t i), IH by now apply next_in_range.
    now apply next_is_modulo.
  Qed.

  Lemma some_steps_forward (n i k : nat) : (i < n)%nat -> (k < n)%nat ->
    exists t, Nat.iter t (fun l => next l n) i = k.
  Proof.
    intros I K. destruct (every_index i n n I (Nat.le_refl n) k K) as (t & _ & reached).
    exists t. now rewrite next_often.
  Qed.

  Lemma steps_back (n i t : nat) : (i < n)%nat ->
    Nat.iter t (fun l => previous n l) (Nat.iter t (fun l => next l n) i) = i.
  Proof.
    revert i. induction t as [| t IH]; intros i I; [reflexivity |].
    change (Nat.iter (S t) (fun l => next l n) i) with (next (Nat.iter t (fun l => next l n) i) n).
    change (previous n (Nat.iter t (fun l => previous n l) (next (Nat.iter t (fun l => next l n) i) n)) = i).
    rewrite <- (iterated_first (fun l => next l n) t i), IH by now apply next_in_range.
    now apply previous_next.
  Qed.

  (* The first of the edges to end, when one moves ahead and the other back. *)
  Lemma an_end_is_reached (e f : segment) (r : Q) :
    0 < r -> vx (along f) == r * vx (along e) -> vy (along f) == r * vy (along e) -> is_sum_of_points x e f ->
    lies_on (minus x (target e)) f \/ lies_on (minus x (source f)) e.
  Proof.
    intros some f_x f_y (w & u & (k & [k0 k1] & wx & wy) & (l & [l0 l1] & ux & uy) & X & Y).
    unfold plus in X, Y; cbn [vx vy] in X, Y. unfold along, minus in f_x, f_y; cbn [vx vy] in f_x, f_y.
    assert (f2x : vx (target f) == vx (source f) + r * (vx (target e) - vx (source e))) by lra.
    assert (f2y : vy (target f) == vy (source f) + r * (vy (target e) - vy (source e))) by lra.
    rewrite wx, ux, f2x in X. rewrite wy, uy, f2y in Y.
    destruct (Qlt_le_dec (l * r) (1 - k)) as [back | ahead].
    - right. exists (k + l * r). assert (0 <= l * r) by (apply Qmult_le_0_compat; lra).
      unfold minus; cbn [vx vy]. split; [lra |]. rewrite X, Y. split; ring.
    - left. assert (value : (1 - k) / r * r == 1 - k) by (field; lra).
      set (m := (1 - k) / r) in *.
      assert (0 <= m) by (unfold m; apply Qle_shift_div_l; lra).
      assert (m <= l) by (unfold m; apply Qle_shift_div_r; lra).
      clearbody m. exists (l - m). unfold minus; cbn [vx vy]. split; [lra |]. rewrite X, Y, f2x, f2y.
      setoid_replace ((1 - (l - m)) * vx (source f) + (l - m) * (vx (source f) + r * (vx (target e) - vx (source e))))
        with (vx (source f) + (l * r - m * r) * (vx (target e) - vx (source e))) by ring.
      setoid_replace ((1 - (l - m)) * vy (source f) + (l - m) * (vy (source f) + r * (vy (target e) - vy (source e))))
        with (vy (source f) + (l * r - m * r) * (vy (target e) - vy (source e))) by ring.
      rewrite value. split; ring.
  Qed.

  (* A vertex that is not inside a straight line. *)
  Lemma some_vertex_turns (chain : list vector) : no_edge_is_a_point chain -> chain <> [] ->
    exists i, (i < length chain)%nat /\
      ~ angle (edge_of_chain chain (previous (length chain) i)) == angle (edge_of_chain chain i).
  Proof.
    intros proper some. destruct (some_tangent_set_is_not_empty chain proper some) as (i & d & I & D & tangent).
    exists i. split; [exact I |]. intros straight. specialize (tangent OfP).
    rewrite corner_is in tangent by exact I. unfold in_tangent_set in tangent. cbn [of other incoming outgoing] in tangent.
    pose proof (edge_nonzero chain i proper I) as out_. pose proof (edge_nonzero chain _ proper (previous_below _ _ I)) as in_.
    destruct (ccw_spec (Direction d OfP) (Direction (edge_of_chain chain (previous (length chain) i)) OfQ)
                (Direction (edge_of_chain chain i) OfQ) D in_ out_) as [order_ |]; [| discriminate tangent].
    unfold in_order, earlier, place in order_. cbn [vec of] in order_. lra.
  Qed.

  Lemma parallel_edges_by_steps (ip jq : nat) :
    (ip < length a)%nat -> (jq < length b)%nat ->
    ~ angle (edge_of_chain a (previous (length a) ip)) == angle (edge_of_chain a ip) ->
    ~ angle (edge_of_chain b (previous (length b) jq)) == angle (edge_of_chain b jq) ->
    forall s t i j, (i < length a)%nat -> (j < length b)%nat ->
    Nat.iter s (fun k => next k (length a)) (next i (length a)) = ip ->
    Nat.iter t (fun k => previous (length b) k) j = jq ->
    angle (edge_of_chain a i) == angle (edge_of_chain b j) ->
    is_sum_of_points x (edge_at a i) (edge_at b j) -> on_convolution x p q.
  Proof.
    intros ip_below jq_below ip_turns jq_turns s t. remember (s + t)%nat as steps eqn:total_.
    revert s t total_. induction steps as [steps IH] using lt_wf_ind.
    intros s t total_ i j I J s_steps t_steps parallel is_sum.
    pose proof (edge_nonzero a i a_edges I) as proper_e. pose proof (edge_nonzero b j b_edges J) as proper_f.
    pose proof (next_in_range _ _ I) as I_next. pose proof (previous_below _ _ J) as J_before.
    pose proof (edge_nonzero a _ a_edges I_next) as proper_next.
    pose proof (edge_nonzero b _ b_edges J_before) as proper_before.
    assert (ratio : same_direction (edge_of_chain b j) (edge_of_chain a i))
      by (apply same_direction_angle; trivial; now symmetry).
    destruct ratio as (r & some & f_x & f_y).
    rewrite (direction_by_index a i I), (direction_by_index b j J) in f_x, f_y.
    destruct (an_end_is_reached (edge_at a i) (edge_at b j) r some f_x f_y is_sum) as [at_target | at_source].
    - (* P's edge ends *)
      rewrite edge_at_is in at_target by exact I. cbn [target] in at_target.
      destruct (Qeq_dec (angle (edge_of_chain a (next i (length a)))) (angle (edge_of_chain a i))) as [straight | turns_].
      + destruct s as [| s].
        { exfalso. cbn in s_steps. rewrite <- s_steps in ip_turns. apply ip_turns.
          rewrite previous_next by exact I. now symmetry. }
        apply (IH (s + t)%nat) with (s := s) (t := t) (i := next i (length a)) (j := j); trivial; try lia.
        * exact (eq_trans (iterated_first (fun k => next k (length a)) s _) s_steps).
        * now rewrite straight.
        * exists (nth (next i (length a)) a nowhere), (minus x (nth (next i (length a)) a nowhere)).
          split; [| split; [exact at_target | split; unfold plus, minus; cbn [vx vy]; ring]].
          rewrite edge_at_is by exact I_next. exists 0. cbn [source target]. split; [lra |]. split; ring.
      + apply (on_convolution_by_q (next i (length a)) j I_next J); [| exact at_target].
        rewrite corner_is, previous_next by assumption. apply tangent_by_tie_of_q; trivial; [now symmetry |].
        intros equal. apply turns_. rewrite <- equal. now symmetry.
    - (* Q's edge begins *)
      rewrite (edge_at_is b j J) in at_source. cbn [source] in at_source.
      destruct (Qeq_dec (angle (edge_of_chain b (previous (length b) j))) (angle (edge_of_chain b j))) as [straight | turns_].
      + destruct t as [| t].
        { exfalso. cbn in t_steps. rewrite <- t_steps in jq_turns. now apply jq_turns. }
        apply (IH (s + t)%nat) with (s := s) (t := t) (i := i) (j := previous (length b) j); trivial; try lia.
        * exact (eq_trans (iterated_first (fun k => previous (length b) k) t _) t_steps).
        * now rewrite straight.
        * exists (minus x (nth j b nowhere)), (nth j b nowhere).
          split; [exact at_source | split; [| split; unfold plus, minus; cbn [vx vy]; ring]].
          rewrite edge_at_is, next_previous by assumption. exists 1. cbn [source target]. split; [lra |].
          split; ring.
      + apply (on_convolution_by_p i j I J); [| exact at_source].
        rewrite corner_is by exact J. apply tangent_by_tie; trivial.
        intros equal. apply turns_. rewrite <- equal. exact parallel.
  Qed.

  (* Theorem. A sum of points of two edges of the same direction is on the convolution. *)
  Theorem parallel_edges_are_on_the_convolution i j : (i < length a)%nat -> (j < length b)%nat ->
    angle (edge_of_chain a i) == angle (edge_of_chain b j) ->
    is_sum_of_points x (edge_at a i) (edge_at b j) -> on_convolution x p q.
  Proof.
    intros I J parallel is_sum.
    destruct (some_vertex_turns a a_edges) as (ip & ip_below & ip_turns); [destruct a; [cbn in I; lia | discriminate] |].
    destruct (some_vertex_turns b b_edges) as (jq & jq_below & jq_turns); [destruct b; [cbn in J; lia | discriminate] |].
    destruct (some_steps_forward (length a) (next i (length a)) ip (next_in_range _ _ I) ip_below) as (s & s_steps).
    destruct (some_steps_forward (length b) jq j jq_below J) as (t & t_steps).
    apply (parallel_edges_by_steps ip jq ip_below jq_below ip_turns jq_turns s t i j); trivial.
    rewrite <- t_steps. now apply steps_back.
  Qed.
End TwoChains.
