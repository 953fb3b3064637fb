(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Segments cut where others meet them, computed as reference/definitions/ does (`intersection` and `cut` in
   segment.cpp, `cut_where_met` in cut_at_intersections.cpp), but for the comparison of boxes, which only saves
   time. Proved here: pieces are parts of their segment in its direction, they cover it, and no point at which it
   is cut is inside a piece. Points on segments are decided in location.v. *)
From Coq Require Import ZArith Lia Bool List.
From Oplus Require Import numbers convolution meeting_of_segments regions first_hit location rotation beside_a_piece.
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

Lemma ordered_backwards R (l : list vector) : ordered R l -> ordered (fun a b => R b a) (rev l).
Proof.
  assert (one_more : forall S (m : list vector) a, ordered S m -> (forall b, In b m -> S b a) -> ordered S (m ++ [a])).
  { intros S m a. induction m as [| c m IH]; cbn; [easy |]. intros [first rest] last_. split; [| now apply IH; auto].
    intros b I. apply in_app_iff in I. destruct I as [I | [<- | []]]; auto. }
  induction l as [| a l IH]; cbn; [trivial |]. intros [first rest]. apply one_more; [now apply IH |].
  intros b I. now apply first, in_rev.
Qed.

Lemma ordered_by_more (R S : vector -> vector -> Prop) (l : list vector) :
  (forall a b, In a l -> In b l -> R a b -> S a b) -> ordered R l -> ordered S l.
Proof.
  induction l as [| a l IH]; cbn; [trivial |]. intros more [first rest]. split.
  - intros b I. apply more; [now left | now right | now apply first].
  - apply IH; [| exact rest]. intros b c I J. apply more; now right.
Qed.

Lemma inserted (p q : vector) (l : list vector) :
  (In q (insert_point p l) -> q = p \/ In q l) /\ (In q l -> In q (insert_point p l)).
Proof. induction l as [| r l IH]; cbn; [intuition |]. destruct (compare_points p r); cbn; intuition. Qed.

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
  destruct (IH I) as (q & J & equal). exists q. split; [now apply inserted | exact equal].
Qed.

Lemma sorted_ordered (l : list vector) : ordered comes_first (sorted_points l).
Proof. induction l as [| p l IH]; cbn; [trivial | now apply insert_ordered]. Qed.

Lemma consecutive_are (piece : segment) (l : list vector) :
  In piece (consecutive l) -> exists before after, l = before ++ source piece :: target piece :: after.
Proof.
  induction l as [| a [| b l] IH]; cbn [consecutive]; [easy | easy |]. intros [<- | I]; [now exists [], l |].
  destruct (IH I) as (before & after & ->). now exists (a :: before), after.
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
  set (e := fraction s q - fraction s p). unfold comes_first.
  set (dx := vx (target s) - vx (source s)). set (dy := vy (target s) - vy (source s)).
  assert (step_x : vx q - vx p == e * dx) by (rewrite px, qx; unfold e, dx; ring).
  assert (step_y : vy q - vy p == e * dy) by (rewrite py, qy; unfold e, dy; ring).
  intros order. assert (forward : 0 < e * dx \/ e * dx == 0 /\ 0 < e * dy) by lra.
  enough ((0 < dx \/ dx == 0 /\ 0 < dy -> 0 < e) /\ (dx < 0 \/ dx == 0 /\ dy < 0 -> e < 0))
    by (unfold e, dx, dy in *; lra).
  clearbody e dx dy. clear - forward. split; intros direction_; apply Qnot_le_lt; intros other_way;
    (destruct (Q_dec e 0) as [[low | high] | none]; [| | rewrite none in forward; lra]); try lra;
    destruct forward as [forward | [flat forward]], direction_ as [direction_ | [no_x direction_]];
    try rewrite no_x in *; nra.
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
  assert (listed : forall p q, equal_vectors p q -> In q (inner ++ [source s; target s]) ->
    exists q, In q sorted /\ equal_vectors p q).
  { intros p q equal I. destruct (sorted_has q _ I) as (r & J & equal_r). exists r. split; [exact J |].
    unfold equal_vectors in *. lra. }
  assert (has : forall p, p = source s \/ p = target s \/ (In p points /\ lies_on p s) ->
     exists q, In q sorted /\ equal_vectors p q).
  { intros p which. setoid_rewrite in_app_iff in listed. assert (same : equal_vectors p p) by (split; reflexivity).
    destruct (same_point_spec p (source s)) as [equal | n1]; [apply (listed p _ equal); cbn; tauto |].
    destruct (same_point_spec p (target s)) as [equal | n2]; [apply (listed p _ equal); cbn; tauto |].
    destruct which as [-> | [-> | [I on_s]]]; [now destruct n1 | now destruct n2 |]. apply (listed p p same). left.
    apply filter_In. split; [exact I |].
    destruct (same_point_spec p (source s)), (same_point_spec p (target s)); try tauto.
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

(* A part of a segment, in its direction. *)
Definition is_part (piece s : segment) : Prop :=
  exists j k, 0 <= j /\ j < k /\ k <= 1 /\
    equal_vectors (source piece) (point_at s j) /\ equal_vectors (target piece) (point_at s k).

Lemma point_of_part (piece s : segment) (w : vector) (j k t : Q) : equal_vectors (source piece) (point_at s j) ->
  equal_vectors (target piece) (point_at s k) -> equal_vectors w (point_at piece t) ->
  equal_vectors w (point_at s ((1 - t) * j + t * k)).
Proof.
  intros [jx jy] [kx ky] [X Y]. unfold point_at in *; cbn [vx vy] in *. split; cbn [vx vy].
  - rewrite X, jx, kx. ring.
  - rewrite Y, jy, ky. ring.
Qed.

Lemma gap (f : vector -> Q) (before after : list vector) (p q : vector) :
  ordered (fun a b => f a < f b) (before ++ p :: q :: after) ->
  f p < f q /\ forall r, In r (before ++ p :: q :: after) -> f r <= f p \/ f q <= f r.
Proof.
  induction before as [| c before IH]; cbn [app]; intros [first rest].
  - split; [apply first; now left |]. intros r [<- | [<- | I]]; [left; lra | right; lra | right].
    assert (f q < f r) by (apply rest, I). lra.
  - destruct (IH rest) as [less none]. split; [exact less |]. intros r [<- | I]; [left | now apply none].
    assert (f c < f p) by (apply first, in_elt). lra.
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
  intros long. destruct (points_along_are s points long) as (on & order & has). unfold along_is_ordered in order.
  assert (ends : forall piece, In piece (cut s points) ->
    fraction s (source piece) < fraction s (target piece) /\ (forall r, In r (points_along s points) ->
      fraction s r <= fraction s (source piece) \/ fraction s (target piece) <= fraction s r) /\
    (0 <= fraction s (source piece) /\ fraction s (target piece) <= 1) /\
    equal_vectors (source piece) (point_at s (fraction s (source piece))) /\
    equal_vectors (target piece) (point_at s (fraction s (target piece)))).
  { intros piece I. unfold cut in I. apply consecutive_are in I. destruct I as (before & after & list_is).
    destruct (fraction_on s (source piece) long) as (j_range & j_is); [apply on; rewrite list_is; apply in_elt |].
    destruct (fraction_on s (target piece) long) as (k_range & k_is);
      [apply on; rewrite list_is; apply in_app_iff; cbn; tauto |].
    rewrite list_is in order. apply gap in order. rewrite <- list_is in order.
    do 3 (split; [tauto |]). exact (conj j_is k_is). }
  split.
  - intros piece I. destruct (ends piece I) as (less & none & range & j_is & k_is). split.
    { exists (fraction s (source piece)), (fraction s (target piece)). tauto. }
    intros p w J (t & t_range & in_piece) equal.
    set (n := (1 - t) * fraction s (source piece) + t * fraction s (target piece)).
    assert (w_is : equal_vectors w (point_at s n)) by exact (point_of_part piece s w _ _ t j_is k_is in_piece).
    pose proof (fraction_is s w n long (proj1 w_is) (proj2 w_is)) as n_is.
    assert (on_p : lies_on p s)
      by (apply (lies_on_equal w _ _ equal); exists n; split; [unfold n; split; nra | exact w_is]).
    destruct (has p (or_intror (or_intror (conj J on_p)))) as (q & K & equal_q). specialize (none q K).
    rewrite <- (fraction_of_equal s p q equal_q), <- (fraction_of_equal s w p equal), n_is in none.
    unfold n in none. nra.
  - intros w on_w. destruct (fraction_on s w long on_w) as (range & X & Y).
    destruct (has (source s) (or_introl eq_refl)) as (a & A & a_is).
    destruct (has (target s) (or_intror (or_introl eq_refl))) as (b & B & b_is).
    assert (zero_ : fraction s a == 0)
      by (rewrite <- (fraction_of_equal s _ _ a_is); apply fraction_is; [exact long | ring ..]).
    assert (one : fraction s b == 1)
      by (rewrite <- (fraction_of_equal s _ _ b_is); apply fraction_is; [exact long | ring ..]).
    destruct (covered_by_consecutive (fraction s) _ a b (fraction s w) order A B) as (piece & I & between_);
      [lra | lra |].
    exists piece. split; [exact I |]. destruct (ends piece I) as (less & _ & piece_range & j_is & k_is).
    split; [exists (fraction s (source piece)), (fraction s (target piece)); tauto |].
    set (j := fraction s (source piece)) in *. set (k := fraction s (target piece)) in *.
    set (t := fraction s w) in *. clearbody j k t. destruct j_is as [jx jy], k_is as [kx ky].
    unfold point_at in *; cbn [vx vy] in *.
    assert (quotient : (t - j) / (k - j) * (k - j) == t - j) by (field; lra).
    exists ((t - j) / (k - j)). split; [split; [apply Qle_shift_div_l | apply Qle_shift_div_r]; lra |].
    set (r := (t - j) / (k - j)) in *. clearbody r. split; by_equations.
Qed.
