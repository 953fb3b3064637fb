(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* What the checker (checker.v) keeps of a polygon on the left of a line: each of its sides is a part of a side of the
   polygon, or along the line with what is left of the line on its left. So what is to the left of the polygon's sides
   and of the line is to the left of the sides of what is kept. *)
From Coq Require Import QArith Lqa Qfield ZArith Lia Bool List.
From Oplus Require Import winding specification checker homogeneous_points fans.
Import ListNotations.

Open Scope Q_scope.

(** Where a segment crosses a line *)

Lemma vector_of_reduced (p : hpoint) : equal_vectors (vector_of (reduced p)) (vector_of p).
Proof.
  unfold reduced. set (g := Z.gcd (Z.gcd (px p) (py p)) (Zpos (pw p))).
  destruct (Z.eqb_spec g 1); [split; reflexivity |].
  assert (of_w : (g | Zpos (pw p))%Z) by apply Z.gcd_divide_r.
  assert (of_both : (g | Z.gcd (px p) (py p))%Z) by apply Z.gcd_divide_l.
  assert (of_x : (g | px p)%Z) by (apply (Z.divide_trans _ _ _ of_both), Z.gcd_divide_l).
  assert (of_y : (g | py p)%Z) by (apply (Z.divide_trans _ _ _ of_both), Z.gcd_divide_r).
  assert (low : (0 <= g)%Z) by apply Z.gcd_nonneg. clearbody g.
  assert (high : (0 < g)%Z) by (destruct of_w as [k w_is]; destruct (Z.eq_dec g 0) as [-> |]; lia).
  destruct of_w as [w w_is], of_x as [x x_is], of_y as [y y_is].
  unfold vector_of, equal_vectors, Qeq. cbn [vx vy px py pw Qnum Qden].
  rewrite w_is, x_is, y_is, !Z.div_mul, Z2Pos.id by nia. split; ring.
Qed.

Lemma positive_rational (n : Z) : (0 < n)%Z -> 0 < inject_Z n.
Proof. rewrite Zlt_Qlt. now intros. Qed.

Definition point_between (a b : vector) (s : Q) : vector :=
  Vector ((1 - s) * vx a + s * vx b) ((1 - s) * vy a + s * vy b).

Lemma value_between (l : line) (a b : vector) (s : Q) :
  value_at l (point_between a b s) == (1 - s) * value_at l a + s * value_at l b.
Proof. unfold value_at, point_between. cbn [vx vy]. ring. Qed.

Lemma value_at_equal (l : line) (a b : vector) : equal_vectors a b -> value_at l a == value_at l b.
Proof. unfold value_at. now intros [-> ->]. Qed.

Lemma meet_is_between (l : line) (a b : hpoint) :
  (0 < value l a /\ value l b < 0 \/ value l a < 0 /\ 0 < value l b)%Z ->
  exists s, 0 <= s <= 1 /\
    equal_vectors (vector_of (meet a b (value l a) (value l b))) (point_between (vector_of a) (vector_of b) s) /\
    value_at l (vector_of (meet a b (value l a) (value l b))) == 0.
Proof.
  intros signs. set (m := Z.abs (value l a)). set (n := Z.abs (value l b)).
  assert (m_positive : (0 < m)%Z) by (unfold m; lia). assert (n_positive : (0 < n)%Z) by (unfold n; lia).
  set (total := (n * Zpos (pw a) + m * Zpos (pw b))%Z).
  assert (total_positive : (0 < total)%Z) by (unfold total; nia).
  assert (m_rational : 0 < inject_Z m) by now apply (positive_rational m).
  assert (n_rational : 0 < inject_Z n) by now apply (positive_rational n).
  pose proof (positive_denominator (pw a)) as a_positive. pose proof (positive_denominator (pw b)) as b_positive.
  pose proof (Qmult_lt_0_compat _ _ n_rational a_positive) as na.
  pose proof (Qmult_lt_0_compat _ _ m_rational b_positive) as mb.
  assert (is_weighted : equal_vectors (vector_of (meet a b (value l a) (value l b)))
    (point_between (vector_of a) (vector_of b) (inject_Z m * inject_Z (Zpos (pw b)) /
      (inject_Z n * inject_Z (Zpos (pw a)) + inject_Z m * inject_Z (Zpos (pw b)))))).
  { unfold meet. fold m n total. destruct (vector_of_reduced (Hpoint (n * px a + m * px b) (n * py a + m * py b)
      (Z.to_pos total))) as [x_is y_is].
    unfold equal_vectors. rewrite x_is, y_is. unfold vector_of, point_between. cbn [vx vy px py pw].
    rewrite !as_quotient, Z2Pos.id by assumption. unfold total. rewrite !inject_Z_plus, !inject_Z_mult.
    split; field; repeat split; lra. }
  eexists. split; [| split; [exact is_weighted |]].
  - split; [apply Qle_shift_div_l | apply Qle_shift_div_r]; lra.
  - rewrite (value_at_equal _ _ _ is_weighted), value_between.
    pose proof (value_is l a) as value_a. pose proof (value_is l b) as value_b.
    assert (balanced : inject_Z n * inject_Z (value l a) + inject_Z m * inject_Z (value l b) == 0).
    { rewrite <- !inject_Z_mult, <- inject_Z_plus.
      replace (n * value l a + m * value l b)%Z with 0%Z by (unfold m, n; lia). reflexivity. }
    rewrite value_a, value_b in balanced.
    transitivity ((inject_Z n * (value_at l (vector_of a) * inject_Z (Zpos (pw a))) +
      inject_Z m * (value_at l (vector_of b) * inject_Z (Zpos (pw b)))) /
      (inject_Z n * inject_Z (Zpos (pw a)) + inject_Z m * inject_Z (Zpos (pw b)))); [field; lra |].
    rewrite balanced. field. lra.
Qed.

(** Sides of what is kept *)

Section Clip.
  Variable l : line.
  Variable x : vector.

  Definition has_on_its_left (a b : hpoint) : Prop := 0 <= turn_of (vector_of a) (vector_of b) x.

  (* a is on the line, which is one. *)
  Definition is_on_line (a : hpoint) : Prop := (la l <> 0 \/ lb l <> 0)%Z /\ value l a = 0%Z.

  Definition is_good (a b : hpoint) : Prop := has_on_its_left a b \/ is_on_line a /\ is_on_line b.

  (* Each leads to the next by a good step. *)
  Fixpoint are_linked (last : option hpoint) (kept_points : polygon) : Prop :=
    match kept_points with
    | [] => True
    | k :: rest => match last with Some p => is_good p k | None => True end /\ are_linked (Some k) rest
    end.

  Fixpoint last_of (last : option hpoint) (kept_points : polygon) : option hpoint :=
    match kept_points with
    | [] => last
    | k :: rest => last_of (Some k) rest
    end.

  (* The last point that was kept leads to a if that is kept, and is on the line otherwise. *)
  Definition is_ready (last : option hpoint) (a : hpoint) : Prop :=
    match last with
    | Some p => if (0 <=? value l a)%Z then is_good p a else is_on_line p
    | None => True
    end.

  Lemma are_linked_app (kept_points more : polygon) : forall last,
    are_linked last (kept_points ++ more) <->
      are_linked last kept_points /\ are_linked (last_of last kept_points) more.
  Proof. induction kept_points as [| k rest IH]; intros last; cbn; [tauto |]. rewrite IH. tauto. Qed.

  Lemma last_of_app (kept_points more : polygon) : forall last,
    last_of last (kept_points ++ more) = last_of (last_of last kept_points) more.
  Proof. induction kept_points as [| k rest IH]; intros last; cbn; [reflexivity |]. apply IH. Qed.

  Lemma are_linked_consecutive (kept_points : polygon) (a b : hpoint) : forall last,
    are_linked last kept_points -> In (a, b) (consecutive_sides kept_points) -> is_good a b.
  Proof.
    induction kept_points as [| k rest IH]; intros last; [easy |]. intros [_ linked].
    destruct rest as [| j rest]; [easy |]. intros [[= <- <-] | later]; [exact (proj1 linked) |].
    exact (IH (Some k) linked later).
  Qed.

  Lemma crosses_are_lines (a b : hpoint) : value l a = 0%Z -> (value l b < 0)%Z -> (la l <> 0 \/ lb l <> 0)%Z.
  Proof.
    unfold value. intros on_line right_. destruct (Z.eq_dec (la l) 0) as [a_zero |]; [| now left].
    destruct (Z.eq_dec (lb l) 0) as [b_zero |]; [| now right]. exfalso. rewrite a_zero, b_zero in *.
    assert (lc l = 0%Z) as c_zero by nia. rewrite c_zero in *. lia.
  Qed.

  (* The part of an edge up to a point of it, and the part from there. *)
  Lemma part_has_on_its_left (a b m : hpoint) (s : Q) :
    0 <= s <= 1 -> equal_vectors (vector_of m) (point_between (vector_of a) (vector_of b) s) ->
    has_on_its_left a b -> has_on_its_left a m /\ has_on_its_left m b.
  Proof.
    unfold has_on_its_left, point_between, equal_vectors, turn_of. cbn [vx vy].
    intros [low high] [x_is y_is] left_. rewrite x_is, y_is.
    assert (rest : 0 <= 1 - s) by lra.
    split;
      [pose proof (Qmult_le_0_compat _ _ low left_) as part | pose proof (Qmult_le_0_compat _ _ rest left_) as part];
      eapply Qle_trans; [exact part | | exact part |]; apply Qle_lteq; right; ring.
  Qed.

  Lemma kept_is_linked (last : option hpoint) (a b : hpoint) :
    has_on_its_left a b -> is_ready last a ->
    are_linked last (kept l (a, b)) /\ is_ready (last_of last (kept l (a, b))) b.
  Proof.
    intros left_ ready. unfold kept. cbn [fst snd].
    destruct (Z.lt_trichotomy (value l a) 0) as [a_right | [a_on | a_left]].
    - assert (0 <=? value l a = false)%Z as is_right by lia. assert (0 <? value l a = false)%Z as not_left by lia.
      assert (value l a <? 0 = true)%Z as strictly by lia.
      unfold is_ready in ready. rewrite is_right in ready. rewrite is_right, not_left, strictly. cbn [andb orb app].
      destruct (Z.ltb_spec 0 (value l b)) as [b_left | b_right].
      + destruct (meet_is_between l a b) as (s & within & m_is & m_on); [lia |].
        destruct (part_has_on_its_left a b _ s within m_is left_) as [_ part].
        cbn [are_linked last_of]. split; [split; [| exact I] |].
        * destruct last as [p |]; [| exact I]. right. split; [assumption |]. split; [exact (proj1 ready) |].
          now apply value_zero.
        * unfold is_ready. replace (0 <=? value l b)%Z with true by lia. now left.
      + cbn [are_linked last_of]. split; [exact I |]. destruct last as [p |]; [| exact I]. unfold is_ready.
        destruct (Z.leb_spec 0 (value l b)) as [b_on |]; [| assumption].
        right. split; [assumption |]. split; [exact (proj1 ready) | lia].
    - assert (0 <=? value l a = true)%Z as is_left by lia. assert (0 <? value l a = false)%Z as not_left by lia.
      assert (value l a <? 0 = false)%Z as not_right by lia.
      unfold is_ready in ready. rewrite is_left in ready. rewrite is_left, not_left, not_right.
      cbn [andb orb app are_linked last_of].
      split; [split; [| exact I]; now destruct last |]. unfold is_ready.
      destruct (Z.leb_spec 0 (value l b)) as [| b_right]; [now left |].
      split; [now apply (crosses_are_lines a b) | assumption].
    - assert (0 <=? value l a = true)%Z as is_left by lia. assert (0 <? value l a = true)%Z as strictly by lia.
      assert (value l a <? 0 = false)%Z as not_right by lia.
      unfold is_ready in ready. rewrite is_left in ready. rewrite is_left, strictly, not_right. cbn [andb orb app].
      destruct (Z.ltb_spec (value l b) 0) as [b_right | b_left]; cbn [orb app are_linked last_of].
      + destruct (meet_is_between l a b) as (s & within & m_is & m_on); [lia |].
        destruct (part_has_on_its_left a b _ s within m_is left_) as [part _]. apply value_zero in m_on.
        split; [split; [now destruct last |]; split; [now left | exact I] |].
        unfold is_ready. replace (0 <=? value l b)%Z with false by lia.
        split; [| assumption]. exact (crosses_are_lines _ b m_on b_right).
      + split; [split; [now destruct last | exact I] |]. unfold is_ready.
        replace (0 <=? value l b)%Z with true by lia. now left.
  Qed.

  Lemma path_is_linked (path : polygon) : forall (last : option hpoint) (a z : hpoint),
    (forall e, In e (consecutive_sides (a :: path ++ [z])) -> has_on_its_left (fst e) (snd e)) -> is_ready last a ->
    are_linked last (flat_map (kept l) (consecutive_sides (a :: path ++ [z]))) /\
    is_ready (last_of last (flat_map (kept l) (consecutive_sides (a :: path ++ [z])))) z.
  Proof.
    induction path as [| b path IH]; intros last a z left_ ready.
    - cbn [app consecutive_sides tl combine flat_map]. rewrite app_nil_r. apply kept_is_linked; [| assumption].
      exact (left_ (a, z) (or_introl eq_refl)).
    - change (consecutive_sides (a :: (b :: path) ++ [z])) with ((a, b) :: consecutive_sides (b :: path ++ [z])) in *.
      cbn [flat_map]. rewrite are_linked_app, last_of_app.
      destruct (kept_is_linked last a b) as [linked ready_for_b];
        [exact (left_ (a, b) (or_introl eq_refl)) | assumption |].
      rewrite and_assoc. split; [assumption |]. apply IH; [| assumption]. intros e in_path. apply left_. now right.
  Qed.

  (* The first point that is kept. *)
  Lemma first_kept (path : polygon) (z : hpoint) : forall (a k : hpoint) (more : polygon),
    flat_map (kept l) (consecutive_sides (a :: path ++ [z])) = k :: more ->
    if (0 <=? value l a)%Z then k = a else is_on_line k.
  Proof.
    assert (step : forall a b k (more later : polygon), kept l (a, b) ++ later = k :: more ->
      if (0 <=? value l a)%Z then k = a
      else is_on_line k \/ later = k :: more /\ (value l b <= 0)%Z).
    { intros a b k more later. unfold kept. cbn [fst snd].
      destruct (Z.leb_spec 0 (value l a)) as [a_left | a_right]; [now intros [= <-] |].
      replace (0 <? value l a)%Z with false by lia. replace (value l a <? 0)%Z with true by lia. cbn [andb orb app].
      destruct (Z.ltb_spec 0 (value l b)) as [b_left | b_right]; [| intros same_; right; split; [assumption | lia]].
      intros [= <-]. left. destruct (meet_is_between l a b) as (s & _ & _ & m_on); [lia |]. apply value_zero in m_on.
      split; [| assumption]. exact (crosses_are_lines _ a m_on a_right). }
    induction path as [| b path IH]; intros a k more.
    - cbn [app consecutive_sides tl combine flat_map]. intros first. specialize (step a z k more [] first).
      destruct (0 <=? value l a)%Z; [assumption |]. destruct step as [on_line | [no_more _]]; [assumption | easy].
    - change (consecutive_sides (a :: (b :: path) ++ [z])) with ((a, b) :: consecutive_sides (b :: path ++ [z])).
      cbn [flat_map]. intros first. specialize (step a b k more _ first).
      destruct (Z.leb_spec 0 (value l a)) as [| a_right]; [assumption |].
      destruct step as [on_line | [rest b_right]]; [assumption |].
      specialize (IH b k more rest). destruct (Z.leb_spec 0 (value l b)) as [b_left |]; [| assumption].
      assert (b_on : value l b = 0%Z) by lia. subst k.
      split; [exact (crosses_are_lines b a b_on a_right) | assumption].
  Qed.

  Lemma sides_of_clipped_are_good (v : polygon) (a b : hpoint) :
    inside_piece (piece_of v) x -> In (a, b) (sides (clipped l v)) -> is_good a b.
  Proof.
    rewrite inside_is_left_of_sides. intros left_. unfold clipped. destruct v as [| first rest]; [easy |].
    rewrite sides_are_consecutive in *.
    destruct (path_is_linked rest None first first left_ I) as [linked ready].
    destruct (flat_map (kept l) (consecutive_sides (first :: rest ++ [first]))) as [| k more] eqn:points; [easy |].
    pose proof (first_kept rest first first k more points) as starts.
    rewrite sides_are_consecutive. change (k :: more ++ [k]) with ((k :: more) ++ [k]).
    apply (are_linked_consecutive _ a b None), are_linked_app. split; [exact linked |].
    cbn [are_linked]. split; [| exact I]. destruct (last_of None (k :: more)) as [p |]; [| exact I].
    unfold is_ready in ready. destruct (0 <=? value l first)%Z; [now rewrite starts |]. now right.
  Qed.

  Lemma ahead_has_on_its_left (a b : hpoint) :
    0 <= value_at l x -> is_good a b -> is_ahead l (a, b) = true -> has_on_its_left a b.
  Proof.
    intros x_left [left_ | [[is_line a_on] [_ b_on]]]; [now intros |].
    unfold is_ahead. cbn [fst snd]. rewrite a_on, b_on. cbn [Z.eqb andb negb orb]. rewrite Z.leb_le.
    intros ahead. apply value_zero in a_on, b_on. rewrite Zle_Qle in ahead.
    pose proof (positive_denominator (pw a)) as wa. pose proof (positive_denominator (pw b)) as wb.
    pose proof (Qmult_lt_0_compat _ _ wa wb) as w.
    assert (forwards : 0 <= inject_Z (lb l) * (vx (vector_of b) - vx (vector_of a)) -
      inject_Z (la l) * (vy (vector_of b) - vy (vector_of a))).
    { apply (Qmult_lt_0_le_reg_r _ _ _ w). rewrite Qmult_0_l. eapply Qle_trans; [exact ahead |].
      apply Qle_lteq. right. unfold vector_of. cbn [vx vy]. unfold Zminus. rewrite !as_quotient.
      repeat rewrite ?inject_Z_plus, ?inject_Z_opp, ?inject_Z_mult. field. split; lra. }
    assert (length_ : 0 < inject_Z (la l) * inject_Z (la l) + inject_Z (lb l) * inject_Z (lb l)).
    { rewrite <- !inject_Z_mult, <- inject_Z_plus. apply (positive_rational _). nia. }
    unfold has_on_its_left. revert x_left a_on b_on forwards length_. clear. unfold value_at, turn_of.
    generalize (inject_Z (la l)), (inject_Z (lb l)), (inject_Z (lc l)), (vector_of a), (vector_of b).
    clear a b. intros m n k a b x_left a_on b_on forwards length_.
    apply (Qmult_lt_0_le_reg_r _ _ _ length_). rewrite Qmult_0_l.
    pose proof (Qmult_le_0_compat _ _ forwards x_left) as product. eapply Qle_trans; [exact product |].
    apply Qle_lteq. right.
    assert (k_is : k == - (m * vx a + n * vy a)) by lra.
    assert (across : n * (vy b - vy a) == - (m * (vx b - vx a))) by lra.
    rewrite k_is.
    transitivity ((m * m + n * n) * ((vx b - vx a) * (vy x - vy a) - (vy b - vy a) * (vx x - vx a)) +
      (m * (vx b - vx a) + n * (vy b - vy a)) * (n * (vx x - vx a) - m * (vy x - vy a))); [ring |].
    rewrite across. ring.
  Qed.
End Clip.

(* What is to the left of a polygon's sides and of a line is to the left of the sides of what is kept. *)
Theorem clipped_has_what_is_left (l : line) (v : polygon) (x : vector) :
  forallb (is_ahead l) (sides (clipped l v)) = true -> inside_piece (piece_of v) x -> 0 <= value_at l x ->
  inside_piece (piece_of (clipped l v)) x.
Proof.
  rewrite forallb_forall. intros ahead x_in x_left. apply inside_is_left_of_sides. intros [a b] side.
  apply (ahead_has_on_its_left l x a b x_left); [| exact (ahead (a, b) side)].
  now apply (sides_of_clipped_are_good l x v).
Qed.
