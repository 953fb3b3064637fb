(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Winding numbers as signed crossings of a ray, as reference/definitions/winding_number.cpp counts
   them: they are the same for every ray. *)
From Coq Require Import ZArith Lia Bool List SetoidList SetoidPermutation.
From Oplus Require Import numbers direction angle rotation angular_crossings.
Import ListNotations.

Open Scope Q_scope.

(* A directed segment (thesis, Definition 2.1.7); points are radius vectors. *)
Record segment := Segment { source : vector; target : vector }.

Definition reversed (s : segment) : segment := Segment (target s) (source s).

Definition minus (a b : vector) : vector := Vector (vx a - vx b) (vy a - vy b).

Definition along (s : segment) : vector := minus (target s) (source s).

Definition moved_along (w u : vector) (e : Q) : vector := Vector (vx w + e * vx u) (vy w + e * vy u).

(* Twice the area of the triangle of a segment and a point: positive if the point is to the left. *)
Definition area (s : segment) (p : vector) : Q :=
  cross (minus (target s) (source s)) (minus p (source s)).

(* An equation between polynomials that follows from those in the context, by Groebner bases. *)
Ltac by_equations :=
  repeat match goal with H : ?P |- _ =>
    lazymatch type of P with Prop => lazymatch P with _ == _ => fail | _ => clear H end end
  end;
  solve [NsatzTactic.nsatz_default].

Ltac in_coordinates :=
  unfold equal_vectors, area, cross, dot, moved_along, along, opposite, minus, reversed in *;
  cbn [source target vx vy] in *.

Lemma left_normal (s : segment) : nonzero (along s) -> 0 < cross (along s) (Vector (- vy (along s)) (vx (along s))).
Proof. intros long. pose proof (square_positive _ long). unfold cross, dot in *. cbn [vx vy]. lra. Qed.

(* One that is always true. *)
Ltac by_coordinates :=
  unfold area, cross, dot, moved_along, along, opposite, minus, reversed; cbn [source target vx vy]; ring.

(* What is parallel is a multiple. *)
Lemma multiple_of (u v : vector) : nonzero v -> cross u v == 0 -> exists c, vx u == c * vx v /\ vy u == c * vy v.
Proof.
  intros some parallel. pose proof (square_positive v some) as square. exists (dot u v / dot v v).
  assert (value : dot u v / dot v v * dot v v == dot u v) by (field; lra).
  set (c := dot u v / dot v v) in *. clearbody c. unfold dot, cross in *.
  split; apply (Qmult_inj_l _ _ (vx v * vx v + vy v * vy v)); (lra || by_equations).
Qed.

(* A number between two others is on the same side of a third as these. *)
Lemma mixed_is_less (k a b c : Q) : 0 <= k <= 1 -> a < c -> b < c -> (1 - k) * a + k * b < c.
Proof. intros range less_a less_b. destruct (Qlt_le_dec 0 k); [nra |]. setoid_replace k with 0 by lra. lra. Qed.

Lemma mixed_is_more (k a b c : Q) : 0 <= k <= 1 -> c < a -> c < b -> c < (1 - k) * a + k * b.
Proof. intros range more_a more_b. destruct (Qlt_le_dec 0 k); [nra |]. setoid_replace k with 0 by lra. lra. Qed.

(* Greater than zero if a, b, c turn left, less if they turn right, equal if they are collinear. *)
Definition orientation (a b c : vector) : comparison :=
  (vx b - vx a) * (vy c - vy a) ?= (vy b - vy a) * (vx c - vx a).

Definition at_most (a b : Q) : bool := match a ?= b with Gt => false | _ => true end.

Lemma at_most_spec (a b : Q) : reflect (a <= b) (at_most a b).
Proof. unfold at_most. compared_numbers (a ?= b); constructor; lra. Qed.

(* What a segment adds of which each end is on the right of a ray or not, and on which side of it the
   ray's start is. *)
Definition ray_crossing (source_right target_right : bool) (side : comparison) : Z :=
  if Bool.eqb source_right target_right then 0
  else match side with
       | Gt => if source_right then 1 else 0
       | Lt => if target_right then -1 else 0
       | Eq => 0
       end.

(* What a segment adds to the winding number of p in the code: the ray goes to the right, and points at
   its height count as below it. *)
Definition signed_crossing (p : vector) (s : segment) : Z :=
  ray_crossing (at_most (vy (source s)) (vy p)) (at_most (vy (target s)) (vy p))
    (orientation (source s) (target s) p).

Definition winding_number (p : vector) (segments : list segment) : Z :=
  sum (map (signed_crossing p) segments).

(* The same for any ray: from p in the direction d, turned by an infinitesimal, or shifted, which is
   the same: counterclockwise if `side` is OfQ, clockwise if it is OfP. *)
Definition signed_crossing_of_ray (side : summand) (d p : vector) (s : segment) : Z :=
  ray_crossing (negb (left_of_ray side d (minus (source s) p)))
    (negb (left_of_ray side d (minus (target s) p))) (orientation (source s) (target s) p).

Definition winding_number_by_ray (side : summand) (d p : vector) (segments : list segment) : Z :=
  sum (map (signed_crossing_of_ray side d p) segments).

(* p is a point of the closed segment s. *)
Definition lies_on (p : vector) (s : segment) : Prop :=
  exists t, 0 <= t <= 1 /\
    vx p == (1 - t) * vx (source s) + t * vx (target s) /\
    vy p == (1 - t) * vy (source s) + t * vy (target s).

(* And none of its ends. *)
Definition strictly_inside (w : vector) (s : segment) : Prop :=
  exists k, 0 < k < 1 /\ vx w == (1 - k) * vx (source s) + k * vx (target s) /\
    vy w == (1 - k) * vy (source s) + k * vy (target s).

Lemma strictly_inside_lies_on (w : vector) (s : segment) : strictly_inside w s -> lies_on w s.
Proof. intros (k & range & X & Y). exists k. split; [lra | tauto]. Qed.

Lemma inside_or_end (v : vector) (e : segment) : lies_on v e ->
  strictly_inside v e \/ equal_vectors (source e) v \/ equal_vectors (target e) v.
Proof.
  intros (k & range & X & Y). destruct (Qlt_le_dec 0 k) as [some | none]; [destruct (Qlt_le_dec k 1) as [less | all] |].
  - left. exists k. split; [lra | tauto].
  - right. right. assert (k == 1) as k_is by lra. rewrite k_is in X, Y. split; lra.
  - right. left. assert (k == 0) as k_is by lra. rewrite k_is in X, Y. split; lra.
Qed.

Lemma lies_on_equal (p q : vector) (s : segment) : equal_vectors p q -> lies_on p s -> lies_on q s.
Proof. intros [X Y] (t & range & on_x & on_y). exists t. rewrite <- X, <- Y. tauto. Qed.

Definition off (p : vector) (segments : list segment) : Prop :=
  forall s, In s segments -> ~ lies_on p s.

(* As many segments end in a point as start there: the segments are those of closed chains. *)
Definition cycles (segments : list segment) : Prop :=
  PermutationA equal_vectors (map source segments) (map target segments).

Lemma zero_or_not (v : vector) : {vx v == 0 /\ vy v == 0} + {nonzero v}.
Proof. unfold nonzero. destruct (Qeq_dec (vx v) 0), (Qeq_dec (vy v) 0); [left | right ..]; tauto. Qed.

Lemma no_squares : forall u v, u * u + v * v <= 0 -> u == 0 /\ v == 0.
Proof.
  intros u v L.
  destruct (Qlt_le_dec u 0), (Qlt_le_dec 0 u), (Qlt_le_dec v 0), (Qlt_le_dec 0 v);
    try (split; lra); exfalso; nra.
Qed.

(* A point is on a segment if it is on its line, and between the ends as seen from there. *)
Lemma lies_on_by_signs (p : vector) (s : segment) :
  lies_on p s <->
  cross (minus (source s) p) (minus (target s) p) == 0 /\ dot (minus (source s) p) (minus (target s) p) <= 0.
Proof.
  destruct s as [a b]. unfold lies_on, cross, dot, minus. cbn [source target vx vy].
  set (u := vx b - vx a). set (v := vy b - vy a).
  assert (b_x : vx b == vx a + u) by (unfold u; ring). assert (b_y : vy b == vy a + v) by (unfold v; ring).
  clearbody u v. split.
  - intros (t & range & X & Y). split; [by_equations |].
    assert (0 <= t * (1 - t) * (u * u + v * v)) by (apply Qmult_le_0_compat; nra).
    setoid_replace ((vx a - vx p) * (vx b - vx p) + (vy a - vy p) * (vy b - vy p))
      with (- (t * (1 - t) * (u * u + v * v))) by by_equations. lra.
  - intros [line between_]. rewrite b_x, b_y in between_. destruct (Qlt_le_dec 0 (u * u + v * v)) as [long | point].
    + set (t := ((vx p - vx a) * u + (vy p - vy a) * v) / (u * u + v * v)).
      assert (value : t * (u * u + v * v) == (vx p - vx a) * u + (vy p - vy a) * v) by (unfold t; field; lra).
      assert (squares : forall k l : Q, 0 <= k * k + l * l) by (intros k l; nra).
      pose proof (squares (vx p - vx a) (vy p - vy a)). pose proof (squares (vx p - vx a - u) (vy p - vy a - v)).
      exists t. split; [unfold t; split; [apply Qle_shift_div_l | apply Qle_shift_div_r]; lra |].
      clearbody t. split; apply (Qmult_inj_l _ _ (u * u + v * v)); (lra || by_equations).
    + apply no_squares in point. destruct point as [no_x no_y].
      destruct (no_squares (vx a - vx p) (vy a - vy p)); [nra |]. exists 0. repeat split; lra.
Qed.

Lemma turns_around : forall p s, ~ lies_on p s -> turns (minus (source s) p) (minus (target s) p).
Proof.
  intros p s free. unfold turns, nonzero. repeat split.
  - intros [X Y]. apply free. exists 0. unfold minus in *. cbn in *. repeat split; lra.
  - intros [X Y]. apply free. exists 1. unfold minus in *. cbn in *. repeat split; lra.
  - intros line. apply Qnot_le_lt. intros between_. now apply free, lies_on_by_signs.
Qed.

Lemma permuted_images : forall (f : vector -> vector),
  (forall u v, equal_vectors u v -> equal_vectors (f u) (f v)) ->
  forall us vs, PermutationA equal_vectors us vs -> PermutationA equal_vectors (map f us) (map f vs).
Proof.
  intros f F us vs P.
  induction P; cbn; [apply permA_nil | apply permA_skip; auto | apply permA_swap | eapply permA_trans; eassumption].
Qed.

(* The segment's ends seen from p. *)
Definition seen_from (p : vector) (s : segment) : vector * vector :=
  (minus (source s) p, minus (target s) p).

Lemma cycles_seen : forall p segments, cycles segments -> closed (map (seen_from p) segments).
Proof.
  intros p segments C. unfold closed, cycles in *. rewrite !map_map. cbn.
  apply (permuted_images (fun a => minus a p)) in C; [| unfold equal_vectors, minus; cbn; intros ? ? [? ?]; split; lra].
  rewrite !map_map in C. exact C.
Qed.

(* Crossing a ray is passing its direction. *)
Lemma sweep_by_sides : forall k d u v, nonzero d -> nonzero u -> nonzero v ->
  sweep (Direction d k) u v =
  ray_crossing (negb (left_of_ray k d u)) (negb (left_of_ray k d v)) (cross u v ?= 0).
Proof.
  intros k d u v D U V. unfold sweep, ray_crossing. cbn [of].
  compared_numbers (cross u v ?= 0); rewrite ?crossed_to_the_left by (trivial; unfold cross in *; lra);
    destruct (left_of_ray k d u), (left_of_ray k d v); reflexivity.
Qed.

Lemma crossing_is_sweep : forall k d p s,
  nonzero d -> ~ lies_on p s ->
  signed_crossing_of_ray k d p s =
  sweep (Direction d k) (minus (source s) p) (minus (target s) p).
Proof.
  intros k d p s D N. destruct (turns_around p _ N) as (A & B & _). rewrite sweep_by_sides by assumption.
  unfold signed_crossing_of_ray, orientation. f_equal. apply compare_as_difference. unfold cross, minus; cbn; ring.
Qed.

Lemma ray_as_sweeps : forall p segments k d,
  off p segments -> nonzero d ->
  winding_number_by_ray k d p segments =
  total (fun q => sweep (Direction d k) (fst q) (snd q)) (map (seen_from p) segments).
Proof.
  intros p segments k d O D. unfold winding_number_by_ray, total. rewrite map_map.
  f_equal. apply map_ext_in. intros s I. apply crossing_is_sweep; auto.
Qed.

Lemma seen_turns : forall p segments, off p segments ->
  forall u v, In (u, v) (map (seen_from p) segments) -> turns u v.
Proof.
  intros p segments O u v I. apply in_map_iff in I. destruct I as (s & Q & I). inversion Q; subst.
  apply turns_around. now apply O.
Qed.

(* Theorem. The winding number of a point off closed chains, counted by signed crossings, is the same
   for all rays: in any direction, and whether points on the ray count as to its right or its left. *)
Theorem winding_number_is_the_same_for_all_rays : forall p segments k d l e,
  cycles segments -> off p segments -> nonzero d -> nonzero e ->
  winding_number_by_ray k d p segments = winding_number_by_ray l e p segments.
Proof.
  intros p segments k d l e C O D E. rewrite !ray_as_sweeps by assumption.
  apply sweeps_are_equal; [now apply cycles_seen | now apply seen_turns | exact D | exact E].
Qed.

Definition right : vector := Vector 1 0.

(* What the code counts is the crossings of the ray to the right, turned counterclockwise. *)
Lemma the_codes_ray : forall p s, signed_crossing p s = signed_crossing_of_ray OfQ right p s.
Proof.
  intros p [a b]. unfold signed_crossing, signed_crossing_of_ray, left_of_ray, ray_crossing; cbn [source target].
  assert (H : forall c, at_most (vy c) (vy p) = negb (negative (cross (minus c p) right))).
  { intros c. unfold at_most, negative.
    rewrite (compare_as_difference (cross (minus c p) right) 0 (vy p) (vy c))
      by (unfold cross, minus, right; cbn; ring).
    rewrite <- (Qcompare_antisym (vy c) (vy p)). destruct (vy c ?= vy p); reflexivity. }
  rewrite (H a), (H b). reflexivity.
Qed.

Lemma winding_number_as_sweeps : forall p segments,
  off p segments ->
  winding_number p segments =
  total (fun q => sweep (Direction right OfQ) (fst q) (snd q)) (map (seen_from p) segments).
Proof.
  intros p segments O. unfold winding_number. rewrite (map_ext _ _ (the_codes_ray p)).
  apply ray_as_sweeps; [exact O |]. unfold nonzero, right; cbn. lra.
Qed.

(* Theorem. What the code counts, on the ray to the right, is what any other ray counts: to the left, up
   or down, or in any direction, turned or shifted to either side. *)
Theorem winding_number_by_any_ray : forall p segments k d,
  cycles segments -> off p segments -> nonzero d ->
  winding_number_by_ray k d p segments = winding_number p segments.
Proof.
  intros p segments k d C O D. unfold winding_number.
  rewrite (map_ext _ _ (the_codes_ray p)).
  apply winding_number_is_the_same_for_all_rays; try assumption.
  unfold nonzero, right; cbn. lra.
Qed.

(* Theorem. Winding numbers of chains, or of any closed pieces, add up. *)
Theorem winding_number_is_additive : forall p some others,
  winding_number p (some ++ others) = (winding_number p some + winding_number p others)%Z.
Proof. intros p some others. unfold winding_number. now rewrite map_app, sum_of_both. Qed.

(* The edges of a closed chain, edge i leaving vertex i: reference/definitions/region.cpp. *)
Definition rotated {A} (l : list A) : list A :=
  match l with [] => [] | first :: rest => rest ++ [first] end.

Definition edges (chain : list vector) : list segment :=
  map (fun ends => Segment (fst ends) (snd ends)) (combine chain (rotated chain)).

Lemma edges_ends : forall chain, map source (edges chain) = chain /\ map target (edges chain) = rotated chain.
Proof.
  intros chain. unfold edges. rewrite !map_map. cbn.
  assert (length chain = length (rotated chain)) as L.
  { destruct chain; cbn; [reflexivity |]. rewrite app_length; cbn. lia. }
  revert L. generalize (rotated chain). induction chain as [| a rest IH]; intros [| b others] L;
    cbn in *; try discriminate; [split; reflexivity |].
  destruct (IH others) as [S T]; [lia |]. rewrite S, T. split; reflexivity.
Qed.

Lemma rotated_permuted : forall chain, PermutationA equal_vectors chain (rotated chain).
Proof.
  intros [| first rest]; cbn; [apply permA_nil |].
  apply PermutationA_cons_append. exact equal_vectors_equivalence.
Qed.

(* Closed chains satisfy what the theorems above ask for, and so do several together. *)
Lemma closed_chain_cycles : forall chain, cycles (edges chain).
Proof. intros chain. unfold cycles. destruct (edges_ends chain) as [-> ->]. apply rotated_permuted. Qed.

Lemma cycles_together : forall some others, cycles some -> cycles others -> cycles (some ++ others).
Proof. unfold cycles. intros some others A B. rewrite !map_app, A, B. reflexivity. Qed.
