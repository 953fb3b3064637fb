(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Segments cut where others meet them, computed as reference/definitions/ does (`intersection` and `cut` in
   segment.cpp, `cut_where_met` in cut_at_intersections.cpp), but for the comparison of boxes, which only saves
   time. Proved here: pieces are parts of their segment in its direction, they cover it, and no point at which it
   is cut is inside a piece. Points on segments are decided in location.v. *)
From Coq Require Import ZArith Lia Bool List.
From Oplus Require Import numbers convolution meeting_of_segments regions first_hit location rotation.
Import ListNotations.

Open Scope Q_scope.

(* Lexicographic: by x, then by y. *)
Definition compare_points (a b : vector) : comparison :=
  match vx a ?= vx b with Eq => vy a ?= vy b | by_x => by_x end.

Definition same_point (a b : vector) : bool := match compare_points a b with Eq => true | _ => false end.

(* Sorted, without copies. *)
Fixpoint insert_point (p : vector) (l : list vector) : list vector :=
  match l with
  | [] => [p]
  | q :: rest =>
      match compare_points p q with Lt => p :: l | Eq => l | Gt => q :: insert_point p rest end
  end.

Definition sorted_points (l : list vector) : list vector := fold_right insert_point [] l.

Definition opposite_sides (a b : comparison) : bool :=
  match a, b with Lt, Gt | Gt, Lt => true | _, _ => false end.

Definition cross_properly (a b : segment) : bool :=
  opposite_sides (orientation (source a) (target a) (source b)) (orientation (source a) (target a) (target b)) &&
  opposite_sides (orientation (source b) (target b) (source a)) (orientation (source b) (target b) (target a)).

Definition crossing_point (a b : segment) : vector :=
  let t := cross (minus (source b) (source a)) (along b) / cross (along a) (along b) in
  Vector (vx (source a) + t * vx (along a)) (vy (source a) + t * vy (along a)).

(* No point, one point, or the ends of the common part. *)
Definition intersection (a b : segment) : list vector :=
  match sorted_points (filter (fun p => is_on_segment p b) [source a; target a] ++
                       filter (fun p => is_on_segment p a) [source b; target b]) with
  | [] => if cross_properly a b then [crossing_point a b] else []
  | common => common
  end.

Fixpoint consecutive (l : list vector) : list segment :=
  match l with
  | a :: (b :: _) as rest => Segment a b :: consecutive rest
  | _ => []
  end.

(* Those of the points that are inside the segment, with its ends, in the order of its direction. *)
Definition points_along (s : segment) (points : list vector) : list vector :=
  let inner := filter (fun p => negb (same_point p (source s)) && negb (same_point p (target s)) && is_on_segment p s)
                 points in
  let sorted := sorted_points (inner ++ [source s; target s]) in
  match compare_points (target s) (source s) with Lt => rev sorted | _ => sorted end.

Definition cut (s : segment) (points : list vector) : list segment := consecutive (points_along s points).

Definition cut_where_met (s : segment) (others : list segment) : list segment :=
  cut s (flat_map (intersection s) others).

(* From here on: what they return. *)
Definition comes_first (a b : vector) : Prop := vx a < vx b \/ (vx a == vx b /\ vy a < vy b).

Lemma compare_points_spec (a b : vector) :
  CompareSpec (equal_vectors a b) (comes_first a b) (comes_first b a) (compare_points a b).
Proof.
  unfold compare_points, equal_vectors, comes_first.
  destruct (Qcompare_spec (vx a) (vx b)); [| constructor; lra..].
  destruct (Qcompare_spec (vy a) (vy b)); constructor; lra.
Qed.

Ltac compared_points a b :=
  let c := fresh "c" in
  pose proof (compare_points_spec a b) as c; apply CompareSpec2Type in c;
  destruct c as [equal_points | point_before | point_after].

Lemma same_point_spec (a b : vector) : reflect (equal_vectors a b) (same_point a b).
Proof.
  unfold same_point. compared_points a b; constructor; trivial; unfold equal_vectors, comes_first in *; lra.
Qed.

(* Every earlier one is related to every later one. *)
Fixpoint ordered (R : vector -> vector -> Prop) (l : list vector) : Prop :=
  match l with [] => True | a :: rest => (forall b, In b rest -> R a b) /\ ordered R rest end.

Lemma ordered_app R (l m : list vector) :
  ordered R (l ++ m) <-> ordered R l /\ ordered R m /\ forall a b, In a l -> In b m -> R a b.
Proof.
  induction l as [| c l IH]; cbn; [firstorder easy |]. rewrite IH. split.
  - intros (first & l_ordered & m_ordered & across). repeat split; trivial.
    + intros b I. apply first, in_app_iff. now left.
    + intros a b [<- | I] J; [apply first, in_app_iff; now right | now apply across].
  - intros ((first & l_ordered) & m_ordered & across). repeat split; trivial.
    + intros b I. apply in_app_iff in I. destruct I as [I | I]; [now apply first | apply across; tauto].
    + intros a b I J. apply across; tauto.
Qed.

Lemma ordered_backwards R (l : list vector) : ordered R l -> ordered (fun a b => R b a) (rev l).
Proof.
  induction l as [| a l IH]; cbn; [trivial |]. intros [first rest]. apply ordered_app.
  split; [now apply IH |]. split; [cbn; tauto |].
  intros b c I J. destruct J as [<- | []]. apply first. now apply in_rev.
Qed.

Lemma ordered_by_more (R S : vector -> vector -> Prop) (l : list vector) :
  (forall a b, In a l -> In b l -> R a b -> S a b) -> ordered R l -> ordered S l.
Proof.
  induction l as [| a l IH]; cbn; [trivial |]. intros more [first rest]. split.
  - intros b I. apply more; [now left | now right | now apply first].
  - apply IH; [| exact rest]. intros b c I J. apply more; now right.
Qed.

Lemma inserted (p q : vector) (l : list vector) : In q (insert_point p l) -> q = p \/ In q l.
Proof.
  induction l as [| r l IH]; cbn; [intros [<- | []]; now left |].
  destruct (compare_points p r); cbn; intuition congruence.
Qed.

Lemma insert_keeps (p q : vector) (l : list vector) : In q l -> In q (insert_point p l).
Proof.
  induction l as [| r l IH]; cbn; [easy |]. destruct (compare_points p r); cbn; intuition.
Qed.

Lemma insert_has (p : vector) (l : list vector) : exists q, In q (insert_point p l) /\ equal_vectors p q.
Proof.
  induction l as [| r l (q & I & equal)]; cbn; [exists p; split; [now left | split; reflexivity] |].
  compared_points p r.
  - exists r. split; [now left | exact equal_points].
  - exists p. split; [now left | split; reflexivity].
  - exists q. split; [now right | exact equal].
Qed.

Lemma insert_ordered (p : vector) (l : list vector) :
  ordered comes_first l -> ordered comes_first (insert_point p l).
Proof.
  induction l as [| r l IH]; cbn; [intros _; split; [intros b [] | trivial] |]. intros [first rest].
  compared_points p r; cbn.
  - now split.
  - repeat split; trivial. intros b [<- | I]; [exact point_before |].
    specialize (first b I). unfold comes_first in *. lra.
  - split; [| now apply IH]. intros b I. apply inserted in I.
    destruct I as [-> | I]; [exact point_after | now apply first].
Qed.

Lemma sorted_in (q : vector) (l : list vector) : In q (sorted_points l) -> In q l.
Proof.
  induction l as [| p l IH]; cbn; [trivial |]. intros I. apply inserted in I. destruct I; [now left | right; auto].
Qed.

Lemma sorted_has (p : vector) (l : list vector) : In p l -> exists q, In q (sorted_points l) /\ equal_vectors p q.
Proof.
  induction l as [| r l IH]; cbn; [easy |]. intros [-> | I]; [apply insert_has |].
  destruct (IH I) as (q & J & equal). exists q. split; [now apply insert_keeps | exact equal].
Qed.

Lemma sorted_ordered (l : list vector) : ordered comes_first (sorted_points l).
Proof. induction l as [| p l IH]; cbn; [trivial | now apply insert_ordered]. Qed.

Lemma consecutive_iff (piece : segment) (l : list vector) :
  In piece (consecutive l) <-> exists before after, l = before ++ source piece :: target piece :: after.
Proof.
  induction l as [| a [| b l] IH]; cbn [consecutive].
  - split; [easy |]. intros (before & after & equal). now destruct before.
  - split; [easy |]. intros ([| c [| d before]] & after & equal); discriminate.
  - split.
    + intros [<- | I]; [now exists [], l |]. apply IH in I. destruct I as (before & after & ->).
      now exists (a :: before), after.
    + intros ([| c before] & after & equal); injection equal as same_first rest.
      * left. destruct piece; cbn in *. congruence.
      * right. apply IH. now exists before, after.
Qed.

(* How far along a segment a point of it is. *)
Definition fraction (s : segment) (p : vector) : Q :=
  dot (minus p (source s)) (along s) / dot (along s) (along s).

Lemma fraction_is (s : segment) (p : vector) (t : Q) : nonzero (along s) ->
  vx p == (1 - t) * vx (source s) + t * vx (target s) ->
  vy p == (1 - t) * vy (source s) + t * vy (target s) -> fraction s p == t.
Proof.
  intros long X Y. pose proof (square_positive _ long) as square. unfold fraction.
  setoid_replace (dot (minus p (source s)) (along s)) with (t * dot (along s) (along s))
    by (in_coordinates; by_equations).
  field. lra.
Qed.

Lemma fraction_on (s : segment) (p : vector) : nonzero (along s) -> lies_on p s ->
  0 <= fraction s p <= 1 /\
  vx p == (1 - fraction s p) * vx (source s) + fraction s p * vx (target s) /\
  vy p == (1 - fraction s p) * vy (source s) + fraction s p * vy (target s).
Proof.
  intros long (t & range & X & Y). pose proof (fraction_is s p t long X Y) as equal.
  rewrite equal. tauto.
Qed.

Lemma fraction_of_equal (s : segment) (p q : vector) : equal_vectors p q -> fraction s p == fraction s q.
Proof. intros [X Y]. unfold fraction, dot, minus; cbn. rewrite X, Y. reflexivity. Qed.

Lemma order_along (s : segment) (p q : vector) : nonzero (along s) -> lies_on p s -> lies_on q s ->
  comes_first p q ->
  (comes_first (source s) (target s) -> fraction s p < fraction s q) /\
  (comes_first (target s) (source s) -> fraction s q < fraction s p).
Proof.
  intros long on_p on_q.
  destruct (fraction_on s p long on_p) as (_ & px & py), (fraction_on s q long on_q) as (_ & qx & qy).
  set (t := fraction s p) in *. set (u := fraction s q) in *. clearbody t u.
  unfold comes_first. set (dx := vx (target s) - vx (source s)). set (dy := vy (target s) - vy (source s)).
  assert (step_x : vx q - vx p == (u - t) * dx) by (rewrite px, qx; unfold dx; ring).
  assert (step_y : vy q - vy p == (u - t) * dy) by (rewrite py, qy; unfold dy; ring).
  assert (equal_x : vx p == vx q -> ~ dx == 0 -> u - t == 0).
  { intros equal some. destruct (Qmult_integral (u - t) dx) as [none |]; [lra | exact none | contradiction]. }
  assert (no_step : u - t == 0 -> vy q - vy p == 0) by (intros none; rewrite step_y, none; ring).
  assert (direction_x : dx == vx (target s) - vx (source s)) by reflexivity.
  assert (direction_y : dy == vy (target s) - vy (source s)) by reflexivity.
  clearbody dx dy. clear px py qx qy.
  assert (no_x : dx == 0 -> vx q - vx p == 0) by (intros none; rewrite step_x, none; ring).
  intros order. split; intros direction_;
    (destruct order as [order | [same_x order]], direction_ as [direction_ | [same_ends direction_]];
     [assert (0 < (u - t) * dx) by lra; clear step_y | assert (u - t == 0) by (apply equal_x; lra); lra
     | assert (vx q - vx p == 0) by (apply no_x; lra); lra | assert (0 < (u - t) * dy) by lra; clear step_x]).
  all: nra.
Qed.

Definition along_is_ordered (s : segment) (l : list vector) : Prop :=
  ordered (fun a b => fraction s a < fraction s b) l.

Lemma points_along_are (s : segment) (points : list vector) : nonzero (along s) ->
  (forall p, In p (points_along s points) -> lies_on p s) /\
  along_is_ordered s (points_along s points) /\
  (forall p, p = source s \/ p = target s \/ (In p points /\ lies_on p s) ->
     exists q, In q (points_along s points) /\ equal_vectors p q).
Proof.
  intros long. unfold points_along.
  set (inner := filter _ points). set (sorted := sorted_points (inner ++ [source s; target s])).
  assert (on : forall p, In p sorted -> lies_on p s).
  { intros p I. apply sorted_in, in_app_iff in I. destruct I as [I | [<- | [<- | []]]].
    - apply filter_In in I. destruct I as [_ both]. apply andb_true_iff in both. destruct both as [_ on].
      now destruct (is_on_spec p s).
    - apply source_lies_on.
    - apply target_lies_on. }
  assert (has : forall p, p = source s \/ p = target s \/ (In p points /\ lies_on p s) ->
     exists q, In q sorted /\ equal_vectors p q).
  { intros p which. destruct (same_point_spec p (source s)) as [is_source | not_source];
      [| destruct (same_point_spec p (target s)) as [is_target | not_target]].
    - destruct (sorted_has (source s) (inner ++ [source s; target s])) as (q & I & equal).
      { apply in_app_iff. cbn. tauto. }
      exists q. split; [exact I |]. unfold equal_vectors in *. lra.
    - destruct (sorted_has (target s) (inner ++ [source s; target s])) as (q & I & equal).
      { apply in_app_iff. cbn. tauto. }
      exists q. split; [exact I |]. unfold equal_vectors in *. lra.
    - apply sorted_has, in_app_iff. left. apply filter_In.
      destruct which as [-> | [-> | [I on_s]]].
      + exfalso. apply not_source. split; reflexivity.
      + exfalso. apply not_target. split; reflexivity.
      + split; [exact I |]. destruct (same_point_spec p (source s)), (same_point_spec p (target s)); try tauto.
        now destruct (is_on_spec p s). }
  pose proof (sorted_ordered (inner ++ [source s; target s])) as lexicographic. fold sorted in lexicographic.
  compared_points (target s) (source s).
  - exfalso. apply long. unfold along, minus, equal_vectors in *; cbn [vx vy] in *. lra.
  - split; [intros p I; apply on, in_rev, I |]. split.
    + apply ordered_backwards in lexicographic. refine (ordered_by_more _ _ _ _ lexicographic).
      intros a b I J before. apply in_rev in I. apply in_rev in J.
      destruct (order_along s b a long (on b J) (on a I) before) as [_ backwards]. now apply backwards.
    + intros p which. destruct (has p which) as (q & I & equal). exists q. split; [now apply -> in_rev | exact equal].
  - split; [exact on |]. split; [| exact has]. refine (ordered_by_more _ _ _ _ lexicographic).
    intros a b I J before.
    destruct (order_along s a b long (on a I) (on b J) before) as [forward _]. now apply forward.
Qed.

Definition is_part (piece s : segment) : Prop :=
  lies_on (source piece) s /\ lies_on (target piece) s /\ fraction s (source piece) < fraction s (target piece).

Lemma point_of_part (piece s : segment) (w : vector) (k : Q) : nonzero (along s) -> is_part piece s ->
  0 <= k <= 1 -> vx w == (1 - k) * vx (source piece) + k * vx (target piece) ->
  vy w == (1 - k) * vy (source piece) + k * vy (target piece) ->
  lies_on w s /\ fraction s w == (1 - k) * fraction s (source piece) + k * fraction s (target piece).
Proof.
  intros long (on_source & on_target & before) range X Y.
  destruct (fraction_on s _ long on_source) as (range_j & jx & jy).
  destruct (fraction_on s _ long on_target) as (range_k & kx & ky).
  set (j := fraction s (source piece)) in *. set (l := fraction s (target piece)) in *. clearbody j l.
  split; [exists ((1 - k) * j + k * l); split; [split; nra |]; split | apply fraction_is; [exact long | |]];
    by_equations.
Qed.

Lemma inside_a_part (piece s : segment) (w : vector) : nonzero (along s) -> is_part piece s ->
  strictly_inside w piece ->
  lies_on w s /\ fraction s (source piece) < fraction s w < fraction s (target piece).
Proof.
  intros long part (k & range & X & Y). destruct (point_of_part piece s w k long part) as [on equal]; trivial; [lra |].
  split; [exact on |]. rewrite equal. destruct part as (_ & _ & before). split; nra.
Qed.

Lemma gap (f : vector -> Q) (before after : list vector) (p q : vector) :
  ordered (fun a b => f a < f b) (before ++ p :: q :: after) ->
  f p < f q /\ forall r, In r (before ++ p :: q :: after) -> f r <= f p \/ f q <= f r.
Proof.
  intros order. apply ordered_app in order. destruct order as (_ & (first & second & _) & across).
  assert (less : f p < f q) by (apply first; now left). split; [exact less |].
  intros r I. apply in_app_iff in I. destruct I as [I | [<- | [<- | I]]].
  - left. assert (f r < f p) by (apply across; [exact I | now left]). lra.
  - left. lra.
  - right. lra.
  - right. assert (f q < f r) by now apply second. lra.
Qed.

Lemma covered_by_consecutive (f : vector -> Q) (l : list vector) (a b : vector) (x : Q) :
  ordered (fun c d => f c < f d) l -> In a l -> In b l -> f a < f b -> f a <= x <= f b ->
  exists piece, In piece (consecutive l) /\ f (source piece) <= x <= f (target piece).
Proof.
  revert a. induction l as [| c l IH]; [easy |]. intros a order I J less range.
  destruct order as [first order]. destruct l as [| d l].
  { destruct I as [<- | []], J as [<- | []]. lra. }
  assert (f c <= f a).
  { destruct I as [<- | I]; [lra |]. assert (f c < f a) by now apply first. lra. }
  destruct (Qlt_le_dec (f d) x) as [later | here].
  - assert (f c < f d) by (apply first; now left).
    destruct J as [<- | J]; [lra |].
    destruct (IH d order (or_introl eq_refl) J) as (piece & K & between_); [lra | lra |].
    exists piece. split; [now right | exact between_].
  - exists (Segment c d). split; [now left |]. cbn. lra.
Qed.

(* Theorem. What `cut` returns, for a segment that is no point: parts of it in its direction, none of which has one of
   the points strictly inside, and which together are the segment. *)
Theorem cut_returns (s : segment) (points : list vector) : nonzero (along s) ->
  (forall piece, In piece (cut s points) -> is_part piece s /\
     forall p w, In p points -> strictly_inside w piece -> ~ equal_vectors w p) /\
  (forall w, lies_on w s -> exists piece, In piece (cut s points) /\ is_part piece s /\ lies_on w piece).
Proof.
  intros long. destruct (points_along_are s points long) as (on & order & has).
  assert (part : forall piece, In piece (cut s points) -> is_part piece s).
  { intros piece I. unfold cut in I. apply consecutive_iff in I. destruct I as (before & after & list_is).
    unfold along_is_ordered in order. rewrite list_is in order, on. apply gap in order.
    repeat split; [apply on; apply in_app_iff; cbn; tauto | apply on; apply in_app_iff; cbn; tauto | tauto]. }
  split.
  - intros piece I. split; [now apply part |]. intros p w J inside_ equal.
    destruct (inside_a_part piece s w long (part piece I) inside_) as [on_w between_].
    assert (on_p : lies_on p s) by now apply (lies_on_equal w).
    destruct (has p (or_intror (or_intror (conj J on_p)))) as (q & K & equal_q).
    unfold cut in I. apply consecutive_iff in I. destruct I as (before & after & list_is).
    unfold along_is_ordered in order. rewrite list_is in order, K. apply gap in order.
    destruct order as [_ none]. specialize (none q K).
    rewrite <- (fraction_of_equal s p q equal_q), <- (fraction_of_equal s w p equal) in none. lra.
  - intros w on_w. destruct (fraction_on s w long on_w) as (range & X & Y).
    destruct (has (source s) (or_introl eq_refl)) as (a & A & a_is).
    destruct (has (target s) (or_intror (or_introl eq_refl))) as (b & B & b_is).
    pose proof (fraction_is s (source s) 0 long) as at_0. pose proof (fraction_is s (target s) 1 long) as at_1.
    rewrite (fraction_of_equal s _ _ a_is) in at_0. rewrite (fraction_of_equal s _ _ b_is) in at_1.
    assert (zero_ : fraction s a == 0) by (apply at_0; ring). assert (one : fraction s b == 1) by (apply at_1; ring).
    destruct (covered_by_consecutive (fraction s) _ a b (fraction s w) order A B) as (piece & I & between_); [lra | lra |].
    exists piece. split; [exact I |]. pose proof (part piece I) as is_part_. split; [exact is_part_ |].
    destruct is_part_ as (on_source & on_target & before).
    destruct (fraction_on s _ long on_source) as (_ & jx & jy).
    destruct (fraction_on s _ long on_target) as (_ & kx & ky).
    set (j := fraction s (source piece)) in *. set (k := fraction s (target piece)) in *.
    set (t := fraction s w) in *. clearbody j k t.
    assert (quotient : (t - j) / (k - j) * (k - j) == t - j) by (field; lra).
    exists ((t - j) / (k - j)). set (r := (t - j) / (k - j)) in *. clearbody r.
    split; [split; nra |]. split; by_equations.
Qed.
