(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Where an edge of P and an edge of Q of the same direction lie along each other in the placement -Q + x, x is on the
   reduced convolution, or the interiors meet near. By the tie rule the edge of Q is in the tangent set where the
   edge of P ends, and the edge of P where that of Q begins. If that vertex is reflex, the next edge leads inside the
   other; if it is inside a straight line, the next edge takes the place of the edge: no chain is straight
   everywhere (tangent_direction.v). *)
From Coq Require Import ZArith Lia Bool List Arith.
From Oplus Require Import numbers regions_and_sums inside_a_corner tangent_direction touching_corners boundary_points
  reduced_convolution.
Import ListNotations.

Open Scope Q_scope.

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

(* At a vertex a chain goes straight on, or turns left, or right. *)
Lemma straight_or_turns (r : region) (chain : list vector) i :
  valid_region r -> chains_do_not_touch r -> In chain r -> (i < length chain)%nat ->
  let u := edge_of_chain chain (previous (length chain) i) in let v := edge_of_chain chain i in
  same_direction u v \/ 0 < cross u v \/ cross u v < 0.
Proof.
  intros r_valid apart_ I below u v.
  pose proof (vertex_turns r _ _ r_valid (apart_ chain i I below)) as turn.
  unfold edge_at in turn. rewrite <- !direction_by_index in turn by (trivial; now apply previous_below).
  fold u in turn. fold v in turn. destruct turn as (proper_u & proper_v & straight).
  destruct (Q_dec (cross u v) 0) as [[right_ | left_] | along_]; [tauto | tauto | left].
  apply same_direction_angle; trivial. specialize (straight along_).
  pose proof (side_by_turn u v proper_u proper_v) as side_.
  pose proof (angle_range u proper_u). pose proof (angle_range v proper_v).
  assert (zero_ : turn_to u v == 0) by lra. unfold turn_to in zero_. clear side_ straight along_.
  destruct (Qlt_le_dec (angle v) (angle u)); lra.
Qed.

(* At a vertex that is straight or reflex, what is to the left of one of its edges is inside. *)
Lemma inside_beside_a_vertex (r : region) (chain : list vector) i (n : vector) :
  valid_region r -> chains_do_not_touch r -> In chain r -> (i < length chain)%nat ->
  let u := edge_of_chain chain (previous (length chain) i) in let v := edge_of_chain chain i in
  same_direction u v \/ cross u v < 0 -> 0 < cross u n \/ 0 < cross v n ->
  eventually (fun t => inside (moved_along (nth i chain nowhere) n t) r).
Proof.
  intros r_valid apart_ I below u v shape left_.
  pose proof (inside_a_corner r _ _ n r_valid (apart_ chain i I below)) as corner_.
  unfold edge_at in corner_. rewrite <- !direction_by_index in corner_ by (trivial; now apply previous_below).
  rewrite edge_by_index in corner_ by exact below. cbn [source] in corner_. apply corner_.
  fold u. fold v. unfold leads_inside. destruct shape as [(m & some & m_x & m_y) | reflex]; [left | right; tauto].
  assert (value : cross u n == m * cross v n) by (unfold cross; rewrite m_x, m_y; ring).
  destruct left_ as [left_ | left_].
  - split; [exact left_ |]. destruct (Qlt_le_dec 0 (cross v n)) as [| none]; [assumption | exfalso].
    assert (0 <= m * - cross v n) by (apply Qmult_le_0_compat; lra). lra.
  - split; [| exact left_]. rewrite value. now apply Qmult_lt_0_compat.
Qed.

(* A point strictly between the ends of an edge is no vertex. *)
Lemma between_is_no_vertex (r : region) (chain : list vector) i k (w : vector) :
  valid_region r -> chains_do_not_touch r -> In chain r -> (i < length chain)%nat -> 0 < k < 1 ->
  vx w == (1 - k) * vx (source (edge_at chain i)) + k * vx (target (edge_at chain i)) ->
  vy w == (1 - k) * vy (source (edge_at chain i)) + k * vy (target (edge_at chain i)) ->
  ~ is_vertex w r.
Proof.
  intros r_valid apart_ I below range X Y (s & S & [sx sy]).
  pose proof r_valid as (not_points & _).
  pose proof (region_edges_are_directions r not_points _ (edge_at_in_region r chain i I below)) as long.
  destruct (edge_by_chain r s S) as (c & m & c_in & m_below & ->).
  destruct (apart_ c m c_in m_below) as (_ & _ & [tx ty] & alone).
  assert (on : lies_on (source (edge_at c m)) (edge_at chain i)).
  { exists k. split; [lra |]. rewrite <- sx, <- sy. now split. }
  apply long. unfold along, minus. cbn [vx vy].
  destruct (alone _ (edge_at_in_region r chain i I below) on) as [is_in | is_out].
  - rewrite <- is_in in tx, ty. rewrite <- tx, X in sx. rewrite <- ty, Y in sy.
    split; apply (Qmult_inj_r _ _ (1 - k)); lra.
  - rewrite <- is_out in sx, sy. rewrite X in sx. rewrite Y in sy. split; apply (Qmult_inj_r _ _ k); lra.
Qed.

Lemma same_direction_reflexive (u : vector) : same_direction u u.
Proof. exists 1. split; [lra |]. split; ring. Qed.

Lemma same_direction_symmetric (u v : vector) : same_direction u v -> same_direction v u.
Proof.
  intros (a & some & X & Y). exists (/ a). split; [now apply Qinv_lt_0_compat |].
  rewrite X, Y. split; field; lra.
Qed.

Lemma same_direction_transitive (u v w : vector) : same_direction u v -> same_direction v w -> same_direction u w.
Proof.
  intros (a & some & X & Y) (b & some_b & X' & Y'). exists (a * b). split; [now apply Qmult_lt_0_compat |].
  rewrite X, Y, X', Y'. split; ring.
Qed.

Section TwoChains.
  Variables p q : region.
  Variables a b : list vector.
  Hypothesis p_region : valid_region p.
  Hypothesis q_region : valid_region q.
  Hypothesis p_apart : chains_do_not_touch p.
  Hypothesis q_apart : chains_do_not_touch q.
  Hypothesis in_p : In a p.
  Hypothesis in_q : In b q.
  Variable x : vector.

  Let a_edges : no_edge_is_a_point a.
  Proof. destruct p_region as (p_edges & _). exact (p_edges a in_p). Qed.
  Let b_edges : no_edge_is_a_point b.
  Proof. destruct q_region as (q_edges & _). exact (q_edges b in_q). Qed.
  Let p_regular : is_regular p.
  Proof. destruct p_region as (p_edges & p_valid & p_meet). now apply regions_are_regular. Qed.
  Let q_regular : is_regular q.
  Proof. destruct q_region as (q_edges & q_valid & q_meet). now apply regions_are_regular. Qed.

  (* A segment of the reduced convolution, of direction d, covers x. *)
  Definition reduced_along (d : vector) : Prop :=
    exists s, In s (reduced_convolution p q) /\ lies_on x s /\ same_direction (along s) d.
  Definition reduced_along_or_meet (d : vector) : Prop := reduced_along d \/ interiors_meet x p q.

  Lemma reduced_along_same (d d' : vector) : same_direction d d' -> reduced_along d -> reduced_along d'.
  Proof.
    intros same_ (s & I & on & direction_). exists s. split; [exact I |]. split; [exact on |].
    exact (same_direction_transitive _ _ _ direction_ same_).
  Qed.

  (* Edge i of P and the convex vertex j of Q; edge j of Q and the convex vertex i of P. *)
  Lemma reduced_along_by_p i j : (i < length a)%nat -> (j < length b)%nat ->
    in_tangent_set (Direction (edge_of_chain a i) OfP) (corner_of_chain b j) = true ->
    convex (corner_of_chain b j) ->
    lies_on (minus x (nth j b nowhere)) (edge_at a i) -> reduced_along (edge_of_chain a i).
  Proof.
    intros I J tangent is_convex (k & range & X & Y). eexists.
    split; [exact (reduced_member p q a b in_p in_q OfP i j I J tangent is_convex) |].
    rewrite edge_at_is in X, Y by exact I. split.
    - exists k. unfold starts_at, ends_at, point_of, plus, minus in *.
      cbn [fst snd source target vx vy state_before state_after step] in *. split; [exact range |]. split; lra.
    - exists 1. rewrite edge_of_chain_is by exact I. unfold along, starts_at, ends_at, point_of, plus, minus.
      cbn [fst snd source target vx vy state_before state_after step]. split; [lra |]. split; ring.
  Qed.

  Lemma reduced_along_by_q i j : (i < length a)%nat -> (j < length b)%nat ->
    in_tangent_set (Direction (edge_of_chain b j) OfQ) (corner_of_chain a i) = true ->
    convex (corner_of_chain a i) ->
    lies_on (minus x (nth i a nowhere)) (edge_at b j) -> reduced_along (edge_of_chain b j).
  Proof.
    intros I J tangent is_convex (k & range & X & Y). eexists.
    split; [exact (reduced_member p q a b in_p in_q OfQ i j I J tangent is_convex) |].
    rewrite edge_at_is in X, Y by exact J. split.
    - exists k. unfold starts_at, ends_at, point_of, plus, minus in *.
      cbn [fst snd source target vx vy state_before state_after step] in *. split; [exact range |]. split; lra.
    - exists 1. rewrite edge_of_chain_is by exact J. unfold along, starts_at, ends_at, point_of, plus, minus.
      cbn [fst snd source target vx vy state_before state_after step]. split; [lra |]. split; ring.
  Qed.

  (* An edge of P leaves vertex i and leads inside Q; one of Q enters vertex j and leads, reversed, inside P. *)
  Lemma meet_by_p i (u : vector) : (i < length a)%nat -> equal_vectors x (plus (nth i a nowhere) u) ->
    eventually (fun t => inside (moved_along u (opposite (edge_of_chain a i)) t) q) -> interiors_meet x p q.
  Proof.
    intros I [X Y] inside_q.
    destruct (some_small _ (eventually_and _ _ inside_q (eventually_below 1 ltac:(lra)))) as (t & _ & in_ & t0 & t1).
    apply interiors_meet_other_way.
    refine (inner_point_and_point q p x _ (moved_along (nth i a nowhere) (edge_of_chain a i) t) p_regular in_ _ _).
    - right. exists (edge_at a i). split; [now apply edge_at_in_region |]. exists t.
      unfold edge_at. rewrite direction_by_index, edge_by_index by exact I.
      unfold moved_along, along, minus; cbn [source target vx vy]. split; [lra |]. split; ring.
    - unfold plus, moved_along, opposite in *; cbn [vx vy] in *. split; cbn [vx vy]; [rewrite X | rewrite Y]; ring.
  Qed.

  Lemma meet_by_q j (w : vector) : (j < length b)%nat -> equal_vectors x (plus w (nth j b nowhere)) ->
    eventually (fun t => inside (moved_along w (edge_of_chain b (previous (length b) j)) t) p) -> interiors_meet x p q.
  Proof.
    intros J [X Y] inside_p. pose proof (previous_below _ _ J) as before_.
    destruct (some_small _ (eventually_and _ _ inside_p (eventually_below 1 ltac:(lra)))) as (t & _ & in_ & t0 & t1).
    refine (inner_point_and_point p q x _
      (moved_along (nth j b nowhere) (opposite (edge_of_chain b (previous (length b) j))) t) q_regular in_ _ _).
    - right. exists (edge_at b (previous (length b) j)). split; [now apply edge_at_in_region |]. exists (1 - t).
      unfold edge_at. rewrite direction_by_index, edge_by_index, next_previous by trivial.
      unfold moved_along, opposite, along, minus; cbn [source target vx vy]. split; [lra |]. split; ring.
    - unfold plus, moved_along, opposite in *; cbn [vx vy] in *. split; cbn [vx vy]; [rewrite X | rewrite Y]; ring.
  Qed.

  (* Where edge i of P ends with a left turn, on edge j of Q; and where edge j of Q begins with one, on edge i of P. *)
  Lemma reduced_at_end_of_p i j : (i < length a)%nat -> (j < length b)%nat ->
    angle (edge_of_chain a i) == angle (edge_of_chain b j) ->
    0 < cross (edge_of_chain a i) (edge_of_chain a (next i (length a))) ->
    lies_on (minus x (nth (next i (length a)) a nowhere)) (edge_at b j) -> reduced_along (edge_of_chain b j).
  Proof.
    intros I J parallel left_ on. pose proof (next_in_range _ _ I) as I_next.
    pose proof (edge_nonzero a i a_edges I) as proper_e. pose proof (edge_nonzero b j b_edges J) as proper_f.
    pose proof (edge_nonzero a _ a_edges I_next) as proper_next.
    apply (reduced_along_by_q (next i (length a)) j I_next J); trivial;
      rewrite corner_is, previous_next by assumption.
    - apply tangent_by_tie_of_q; trivial; [now symmetry |]. intros equal. rewrite <- parallel in equal.
      apply same_direction_angle in equal; trivial. destruct equal as (m & _ & m_x & m_y).
      unfold cross in left_. rewrite m_x, m_y in left_. lra.
    - exact left_.
  Qed.

  Lemma reduced_at_start_of_q i j : (i < length a)%nat -> (j < length b)%nat ->
    angle (edge_of_chain a i) == angle (edge_of_chain b j) ->
    0 < cross (edge_of_chain b (previous (length b) j)) (edge_of_chain b j) ->
    lies_on (minus x (nth j b nowhere)) (edge_at a i) -> reduced_along (edge_of_chain a i).
  Proof.
    intros I J parallel left_ on. pose proof (previous_below _ _ J) as before_.
    pose proof (edge_nonzero a i a_edges I) as proper_e. pose proof (edge_nonzero b j b_edges J) as proper_f.
    pose proof (edge_nonzero b _ b_edges before_) as proper_before.
    apply (reduced_along_by_p i j I J); trivial; rewrite corner_is by assumption.
    - apply tangent_by_tie; trivial. intros equal. rewrite parallel in equal.
      apply same_direction_angle in equal; trivial. destruct equal as (m & _ & m_x & m_y).
      unfold cross in left_. rewrite m_x, m_y in left_. lra.
    - exact left_.
  Qed.

  (* Edge i of P from its part k on, and edge j of Q up to its part l, lie along each other. *)
  Lemma parallel_edges_by_steps (ip jq : nat) :
    (ip < length a)%nat -> (jq < length b)%nat ->
    ~ angle (edge_of_chain a (previous (length a) ip)) == angle (edge_of_chain a ip) ->
    ~ angle (edge_of_chain b (previous (length b) jq)) == angle (edge_of_chain b jq) ->
    forall s t d i j k l, same_direction (edge_of_chain a i) d -> (i < length a)%nat -> (j < length b)%nat ->
    Nat.iter s (fun m => next m (length a)) (next i (length a)) = ip ->
    Nat.iter t (fun m => previous (length b) m) j = jq ->
    angle (edge_of_chain a i) == angle (edge_of_chain b j) ->
    0 <= k < 1 -> 0 < l <= 1 ->
    equal_vectors x (plus (moved_along (nth i a nowhere) (edge_of_chain a i) k)
                          (moved_along (nth j b nowhere) (edge_of_chain b j) l)) ->
    reduced_along_or_meet d.
  Proof.
    intros ip_below jq_below ip_turns jq_turns s t. remember (s + t)%nat as steps eqn:total_.
    revert s t total_. induction steps as [steps IH] using lt_wf_ind.
    intros s t total_ d i j k l is_d I J s_steps t_steps parallel k_range l_range [X Y].
    pose proof (edge_nonzero a i a_edges I) as proper_e. pose proof (edge_nonzero b j b_edges J) as proper_f.
    pose proof (next_in_range _ _ I) as I_next. pose proof (previous_below _ _ J) as J_before.
    pose proof (edge_nonzero a _ a_edges I_next) as proper_next.
    pose proof (edge_nonzero b _ b_edges J_before) as proper_before.
    pose proof (edge_of_chain_is a i I) as e_is. pose proof (edge_of_chain_is b j J) as f_is.
    assert (ratio : same_direction (edge_of_chain b j) (edge_of_chain a i))
      by (apply same_direction_angle; trivial; now symmetry).
    pose proof (same_direction_transitive _ _ _ ratio is_d) as f_is_d.
    destruct ratio as (r & some & f_x & f_y).
    unfold plus, moved_along in X, Y; cbn [vx vy] in X, Y.
    pose proof (straight_or_turns p a _ p_region p_apart in_p I_next) as p_shape.
    pose proof (straight_or_turns q b _ q_region q_apart in_q J) as q_shape.
    pose proof (inside_beside_a_vertex p a (next i (length a)) (edge_of_chain b (previous (length b) j))
      p_region p_apart in_p I_next) as p_inside.
    pose proof (inside_beside_a_vertex q b j (opposite (edge_of_chain a (next i (length a))))
      q_region q_apart in_q J) as q_inside.
    cbv zeta in p_shape, q_shape, p_inside, q_inside. rewrite previous_next in p_shape, p_inside by exact I.
    set (E := edge_of_chain a i) in *. set (F := edge_of_chain b j) in *.
    set (E' := edge_of_chain a (next i (length a))) in *. set (F' := edge_of_chain b (previous (length b) j)) in *.
    assert (f_left : cross E E' < 0 -> 0 < cross F (opposite E')).
    { intros turn. assert (value : cross F (opposite E') == r * - cross E E')
        by (unfold cross, opposite; cbn [vx vy]; rewrite f_x, f_y; ring).
      rewrite value. apply Qmult_lt_0_compat; lra. }
    assert (e_left : cross F' F < 0 -> 0 < cross E F').
    { intros turn. assert (value : - cross F' F == r * cross E F') by (unfold cross; rewrite f_x, f_y; ring).
      destruct (Qlt_le_dec 0 (cross E F')) as [| none]; [assumption | exfalso].
      assert (0 <= r * - cross E F') by (apply Qmult_le_0_compat; lra). lra. }
    assert (straight_angle : forall m n : vector, nonzero m -> nonzero n -> same_direction m n -> angle m == angle n)
      by (intros m n proper_m proper_n; now apply same_direction_angle).
    assert (p_steps : same_direction E E' -> exists s', s = S s').
    { intros straight. destruct s as [| s']; [exfalso | now exists s'].
      cbn in s_steps. rewrite <- s_steps in ip_turns. apply ip_turns. rewrite previous_next by exact I.
      now apply straight_angle. }
    assert (q_steps : same_direction F' F -> exists t', t = S t').
    { intros straight. destruct t as [| t']; [exfalso | now exists t'].
      cbn in t_steps. rewrite <- t_steps in jq_turns. apply jq_turns. now apply straight_angle. }
    assert (target_x : vx (nth (next i (length a)) a nowhere) == vx (nth i a nowhere) + vx E)
      by (rewrite e_is; unfold minus; cbn [vx]; ring).
    assert (target_y : vy (nth (next i (length a)) a nowhere) == vy (nth i a nowhere) + vy E)
      by (rewrite e_is; unfold minus; cbn [vy]; ring).
    assert (before_is : edge_of_chain b (previous (length b) j) =
      minus (nth j b nowhere) (nth (previous (length b) j) b nowhere))
      by (rewrite edge_of_chain_is, next_previous by assumption; reflexivity).
    fold F' in before_is.
    assert (source_x : vx (nth j b nowhere) == vx (nth (previous (length b) j) b nowhere) + 1 * vx F')
      by (rewrite before_is; unfold minus; cbn [vx]; ring).
    assert (source_y : vy (nth j b nowhere) == vy (nth (previous (length b) j) b nowhere) + 1 * vy F')
      by (rewrite before_is; unfold minus; cbn [vy]; ring).
    destruct (Q_dec (l * r) (1 - k)) as [[back | ahead_] | both].
    - (* the edge of Q begins inside that of P *)
      set (w := moved_along (nth i a nowhere) E (k + l * r)).
      assert (0 < l * r) by (apply Qmult_lt_0_compat; lra).
      assert (x_is : equal_vectors x (plus w (nth j b nowhere)))
        by (unfold w, plus, moved_along; split; cbn [vx vy]; [rewrite X, f_x | rewrite Y, f_y]; ring).
      destruct q_shape as [straight | [convex_ | reflex]].
      + destruct (q_steps straight) as (t' & ->).
        apply (IH (s + t')%nat) with (d := d) (s := s) (t := t') (i := i) (j := previous (length b) j) (k := k + l * r) (l := 1);
          trivial; try lia; try lra.
        * exact (eq_trans (iterated_first (fun m => previous (length b) m) t' _) t_steps).
        * fold F'. fold E. rewrite parallel. symmetry. now apply straight_angle.
        * destruct x_is as [x_x x_y]. fold F'. fold E. fold w. unfold plus, moved_along in *; cbn [vx vy] in *.
          split; cbn [vx vy]; [rewrite x_x, source_x | rewrite x_y, source_y]; reflexivity.
      + left. apply (reduced_along_same _ _ is_d). apply (reduced_at_start_of_q i j I J parallel convex_).
        rewrite edge_at_is by exact I. exists (k + l * r). destruct x_is as [x_x x_y].
        unfold plus, minus, w, moved_along in *; cbn [source target vx vy] in *. split; [lra |].
        rewrite target_x, target_y. split; [rewrite x_x | rewrite x_y]; ring.
      + right. apply (meet_by_q j w J x_is). fold F'.
        apply (left_of_an_edge_is_inside p (edge_at a i) w F').
        * apply p_region.
        * apply p_region.
        * now apply edge_at_in_region.
        * exists (k + l * r). rewrite edge_at_is by exact I. unfold w, moved_along; cbn [source target vx vy].
          split; [lra |]. rewrite target_x, target_y. split; ring.
        * apply (between_is_no_vertex p a i (k + l * r) w p_region p_apart in_p I); [lra | |];
            rewrite edge_at_is by exact I; unfold w, moved_along; cbn [source target vx vy];
            [rewrite target_x | rewrite target_y]; ring.
        * unfold edge_at. rewrite <- direction_by_index by exact I. now apply e_left.
    - (* the edge of P ends inside that of Q *)
      assert (value : (1 - k) / r * r == 1 - k) by (field; lra). set (m := (1 - k) / r) in *.
      assert (0 < m) by (unfold m; apply Qlt_shift_div_l; lra).
      assert (m < l) by (unfold m; apply Qlt_shift_div_r; lra).
      clearbody m. set (u := moved_along (nth j b nowhere) F (l - m)).
      assert (x_is : equal_vectors x (plus (nth (next i (length a)) a nowhere) u)).
      { unfold u, plus, moved_along. split; cbn [vx vy]; by_equations. }
      assert (end_x : vx (nth (next j (length b)) b nowhere) == vx (nth j b nowhere) + vx F)
        by (rewrite f_is; unfold minus; cbn [vx]; ring).
      assert (end_y : vy (nth (next j (length b)) b nowhere) == vy (nth j b nowhere) + vy F)
        by (rewrite f_is; unfold minus; cbn [vy]; ring).
      destruct p_shape as [straight | [convex_ | reflex]].
      + destruct (p_steps straight) as (s' & ->).
        apply (IH (s' + t)%nat) with (d := d) (s := s') (t := t) (i := next i (length a)) (j := j) (k := 0) (l := l - m);
          trivial; try lia; try lra.
        * exact (same_direction_transitive _ _ _ (same_direction_symmetric _ _ straight) is_d).
        * exact (eq_trans (iterated_first (fun m => next m (length a)) s' _) s_steps).
        * fold E'. fold F. rewrite <- parallel. symmetry. now apply straight_angle.
        * destruct x_is as [x_x x_y]. fold E'. fold F. fold u. unfold plus, moved_along in *; cbn [vx vy] in *.
          split; cbn [vx vy]; [rewrite x_x | rewrite x_y]; ring.
      + left. apply (reduced_along_same _ _ f_is_d). apply (reduced_at_end_of_p i j I J parallel convex_).
        rewrite edge_at_is by exact J. exists (l - m). destruct x_is as [x_x x_y].
        unfold plus, minus, u, moved_along in *; cbn [source target vx vy] in *. split; [lra |].
        rewrite end_x, end_y. split; [rewrite x_x | rewrite x_y]; ring.
      + right. apply (meet_by_p (next i (length a)) u I_next x_is). fold E'.
        apply (left_of_an_edge_is_inside q (edge_at b j) u (opposite E')).
        * apply q_region.
        * apply q_region.
        * now apply edge_at_in_region.
        * exists (l - m). rewrite edge_at_is by exact J. unfold u, moved_along; cbn [source target vx vy].
          split; [lra |]. rewrite end_x, end_y. split; ring.
        * apply (between_is_no_vertex q b j (l - m) u q_region q_apart in_q J); [lra | |];
            rewrite edge_at_is by exact J; unfold u, moved_along; cbn [source target vx vy];
            [rewrite end_x | rewrite end_y]; ring.
        * unfold edge_at. rewrite <- direction_by_index by exact J. now apply f_left.
    - (* both at once *)
      assert (x_is : equal_vectors x (plus (nth (next i (length a)) a nowhere) (nth j b nowhere))).
      { unfold plus. split; cbn [vx vy]; by_equations. }
      assert (by_convex_p : 0 < cross E E' -> reduced_along_or_meet d).
      { intros convex_. left. apply (reduced_along_same _ _ f_is_d). apply (reduced_at_end_of_p i j I J parallel convex_).
        rewrite edge_at_is by exact J. exists 0. destruct x_is as [x_x x_y].
        unfold plus, minus in *; cbn [source target vx vy] in *. split; [lra |].
        split; [rewrite x_x | rewrite x_y]; ring. }
      assert (by_convex_q : 0 < cross F' F -> reduced_along_or_meet d).
      { intros convex_. left. apply (reduced_along_same _ _ is_d). apply (reduced_at_start_of_q i j I J parallel convex_).
        rewrite edge_at_is by exact I. exists 1. destruct x_is as [x_x x_y].
        unfold plus, minus in *; cbn [source target vx vy] in *. split; [lra |].
        split; [rewrite x_x | rewrite x_y]; ring. }
      destruct p_shape as [straight_p | [convex_p | reflex_p]]; [| now apply by_convex_p |].
      + destruct q_shape as [straight_q | [convex_q | reflex_q]]; [| now apply by_convex_q |].
        * destruct (p_steps straight_p) as (s' & ->). destruct (q_steps straight_q) as (t' & ->).
          apply (IH (s' + t')%nat) with (d := d) (s := s') (t := t') (i := next i (length a)) (j := previous (length b) j)
            (k := 0) (l := 1); trivial; try lia; try lra.
          -- exact (same_direction_transitive _ _ _ (same_direction_symmetric _ _ straight_p) is_d).
          -- exact (eq_trans (iterated_first (fun m => next m (length a)) s' _) s_steps).
          -- exact (eq_trans (iterated_first (fun m => previous (length b) m) t' _) t_steps).
          -- fold E'. fold F'. rewrite <- (straight_angle E E'), (straight_angle F' F); trivial.
          -- destruct x_is as [x_x x_y]. fold E'. fold F'. unfold plus, moved_along in *; cbn [vx vy] in *.
             split; cbn [vx vy]; [rewrite x_x, source_x | rewrite x_y, source_y]; ring.
        * right. apply (meet_by_q j _ J x_is). fold F'. apply p_inside; [now left | left; now apply e_left].
      + destruct q_shape as [straight_q | [convex_q | reflex_q]]; [| now apply by_convex_q |].
        * right. apply (meet_by_p (next i (length a)) _ I_next x_is). fold E'.
          apply q_inside; [now left | right; now apply f_left].
        * right. apply (meet_by_p (next i (length a)) _ I_next x_is). fold E'.
          apply q_inside; [now right | right; now apply f_left].
  Qed.

  (* Theorem. If a point of an edge of P, not its end, and one of an edge of Q of the same direction, not its
     beginning, add up to x, then a segment of the reduced convolution covers x, of the same direction, or the
     interiors of P and -Q + x meet. *)
  Theorem parallel_edges_along i j k l : (i < length a)%nat -> (j < length b)%nat ->
    angle (edge_of_chain a i) == angle (edge_of_chain b j) -> 0 <= k < 1 -> 0 < l <= 1 ->
    equal_vectors x (plus (moved_along (nth i a nowhere) (edge_of_chain a i) k)
                          (moved_along (nth j b nowhere) (edge_of_chain b j) l)) ->
    reduced_along_or_meet (edge_of_chain a i).
  Proof.
    intros I J parallel k_range l_range x_is.
    destruct (some_vertex_turns a a_edges) as (ip & ip_below & ip_turns);
      [destruct a; [cbn in I; lia | discriminate] |].
    destruct (some_vertex_turns b b_edges) as (jq & jq_below & jq_turns);
      [destruct b; [cbn in J; lia | discriminate] |].
    destruct (some_steps_forward (length a) (next i (length a)) ip (next_in_range _ _ I) ip_below) as (s & s_steps).
    destruct (some_steps_forward (length b) jq j jq_below J) as (t & t_steps).
    apply (parallel_edges_by_steps ip jq ip_below jq_below ip_turns jq_turns s t _ i j k l); trivial;
      [apply same_direction_reflexive |].
    rewrite <- t_steps. now apply steps_back.
  Qed.

End TwoChains.
