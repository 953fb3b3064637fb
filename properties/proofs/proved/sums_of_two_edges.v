(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Where an edge of P crosses one of -Q + x, the interiors meet: x is inside the sum of the two edges, a parallelogram.
   So a segment is of no interest where such parallelograms cover it. A program that returns the parts of a segment that
   they do not cover, and the proof that all else is inside the sum (the first half of the collision test, for all x of
   a segment at once). Integers: coordinates are multiplied by a common denominator. Large parallelograms come first,
   which only saves time. *)
From Coq Require Import QArith Qabs Qminmax Lqa Qfield ZArith Lia Bool List Permutation Orders Mergesort.
From Oplus Require Import regions_and_sums in_out_degree right_of_an_edge specification_bridge theorem_2_2_10
  parallelogram crossing_edges coordinates.
Import ListNotations.

Open Scope Z_scope.

Definition denominator := BinNums.positive.
Definition whole_vector := (Z * Z)%type.

(* From the left, which needs no stack: browsers have little, and there are thousands of denominators. *)
Definition multiple_of_both (d a : denominator) : denominator := Z.to_pos (Z.lcm (Zpos d) (Zpos a)).
Definition common_multiple (l : list denominator) : denominator := fold_left multiple_of_both l 1%positive.

Definition denominators (l : list segment) : list denominator :=
  flat_map (fun s => [Qden (vx (source s)); Qden (vy (source s)); Qden (vx (target s)); Qden (vy (target s))]) l.

Definition scaled_number (d : denominator) (q : Q) : Z := Qnum q * (Zpos d / Zpos (Qden q)).
Definition scaled (d : denominator) (v : vector) : whole_vector := (scaled_number d (vx v), scaled_number d (vy v)).

Definition whole_plus (a b : whole_vector) : whole_vector := (fst a + fst b, snd a + snd b).
Definition whole_minus (a b : whole_vector) : whole_vector := (fst a - fst b, snd a - snd b).
Definition whole_cross (a b : whole_vector) : Z := fst a * snd b - snd a * fst b.

(* The sum of two edges: a corner, the sides there, and their cross product, which is positive. *)
Record sum_of_two := SumOfTwo { its_corner : whole_vector; side_1 : whole_vector; side_2 : whole_vector; its_size : Z }.

(* None if the edges are parallel. *)
Definition sum_of_edges (d : denominator) (e f : segment) : list sum_of_two :=
  let start := whole_plus (scaled d (source e)) (scaled d (source f)) in
  let a := whole_minus (scaled d (target e)) (scaled d (source e)) in
  let b := whole_minus (scaled d (target f)) (scaled d (source f)) in
  match whole_cross a b with
  | Z0 => []
  | Zpos k => [SumOfTwo start a b (Zpos k)]
  | Zneg k => [SumOfTwo start b a (Zpos k)]
  end.

Module Larger <: TotalLeBool.
  Definition t := sum_of_two.
  Definition leb (a b : t) : bool := its_size b <=? its_size a.
  Theorem leb_total : forall a b, leb a b = true \/ leb b a = true.
  Proof. intros a b. unfold leb. rewrite !Z.leb_le. apply Z.le_ge_cases. Qed.
End Larger.
Module Sorted_by_size := Sort Larger.

Definition sums_of_edges (d : denominator) (p q : list segment) : list sum_of_two :=
  Sorted_by_size.sort (flat_map (fun e => flat_map (sum_of_edges d e) q) p).

(* Parts of a segment are given by the least and the greatest k of their points (1 - k) source + k target. *)
Definition part := (Q * Q)%type.

Definition is_in_part (k : Q) (l : part) : Prop := (fst l <= k /\ k <= snd l)%Q.

Definition smaller (a b : Q) : Q := if Qle_bool a b then a else b.
Definition larger (a b : Q) : Q := if Qle_bool a b then b else a.

(* The k strictly between these numbers for which 0 < u + k v < c. *)
Definition narrowed (u v c : Z) (l : Q * Q) : Q * Q :=
  match v with
  | Z0 => if (0 <? u) && (u <? c) then l else (0%Q, 0%Q)
  | Zpos k => (larger (fst l) (Qmake (- u) k), smaller (snd l) (Qmake (c - u) k))
  | Zneg k => (larger (fst l) (Qmake (u - c) k), smaller (snd l) (Qmake u k))
  end.

(* For no k from 0 to 1 is 0 < u + k v < c. *)
Definition is_beyond (u v c : Z) : bool :=
  let w := u + v in ((u <=? 0) && (w <=? 0)) || ((c <=? u) && (c <=? w)).

(* Where the segment is strictly inside, if it is somewhere. *)
Definition part_inside (start along_ : whole_vector) (g : sum_of_two) : option (Q * Q) :=
  let from := whole_minus start (its_corner g) in
  let u := whole_cross from (side_2 g) in
  let v := whole_cross along_ (side_2 g) in
  if is_beyond u v (its_size g) then None
  else
    let u' := whole_cross (side_1 g) from in
    let v' := whole_cross (side_1 g) along_ in
    if is_beyond u' v' (its_size g) then None
    else Some (narrowed u' v' (its_size g) (narrowed u v (its_size g) (-1 # 1, 2 # 1)%Q)).

Definition without_inner (inner : Q * Q) (l : part) : list part :=
  let (low, high) := inner in
  if Qle_bool high low || Qle_bool (snd l) low || Qle_bool high (fst l) then [l]
  else (if Qle_bool (fst l) low then [(fst l, low)] else []) ++ (if Qle_bool high (snd l) then [(high, snd l)] else []).

Fixpoint uncovered (start along_ : whole_vector) (l : list part) (sums : list sum_of_two) : list part :=
  match l, sums with
  | [], _ | _, [] => l
  | _, g :: rest =>
    uncovered start along_
      match part_inside start along_ g with None => l | Some inner => flat_map (without_inner inner) l end rest
  end.

Definition uncovered_parts (d : denominator) (sums : list sum_of_two) (s : segment) : list part :=
  uncovered (scaled d (source s)) (whole_minus (scaled d (target s)) (scaled d (source s))) [(0%Q, 1%Q)] sums.

(* From here on: what they return. *)
Lemma common_multiple_from (l : list denominator) : forall d,
  (Zpos d | Zpos (fold_left multiple_of_both l d)) /\
  (forall a, In a l -> (Zpos a | Zpos (fold_left multiple_of_both l d))).
Proof.
  induction l as [| b l IH]; intros d; cbn [fold_left]; [split; [reflexivity | intros a []] |].
  destruct (IH (multiple_of_both d b)) as [of_both of_others].
  assert (is_lcm : Zpos (multiple_of_both d b) = Z.lcm (Zpos d) (Zpos b)).
  { apply Z2Pos.id. pose proof (Z.lcm_nonneg (Zpos d) (Zpos b)).
    assert (Z.lcm (Zpos d) (Zpos b) <> 0) by (intros none; apply Z.lcm_eq_0 in none; lia). lia. }
  rewrite is_lcm in of_both. split; [| intros a [<- | I]; [| exact (of_others a I)]]; (etransitivity;
    [| exact of_both]).
  - apply Z.divide_lcm_l.
  - apply Z.divide_lcm_r.
Qed.

Lemma common_multiple_is (a : denominator) (l : list denominator) :
  In a l -> (Zpos a | Zpos (common_multiple l)).
Proof. exact (proj2 (common_multiple_from l 1) a). Qed.

Open Scope Q_scope.

Definition has_denominator (d : denominator) (v : vector) : Prop :=
  (Zpos (Qden (vx v)) | Zpos d)%Z /\ (Zpos (Qden (vy v)) | Zpos d)%Z.

Lemma ends_have_denominator (l : list segment) (s : segment) : In s l ->
  has_denominator (common_multiple (denominators l)) (source s) /\
  has_denominator (common_multiple (denominators l)) (target s).
Proof. intros I. repeat split; apply common_multiple_is, in_flat_map; exists s; (split; [exact I | cbn; tauto]). Qed.

Section Scaled.
  Variable d : denominator.
  Let unit_ : Q := inject_Z (Zpos d).

  Definition stands_for (a : whole_vector) (v : vector) : Prop :=
    inject_Z (fst a) == unit_ * vx v /\ inject_Z (snd a) == unit_ * vy v.

  Lemma scaled_number_is (q : Q) : (Zpos (Qden q) | Zpos d)%Z -> inject_Z (scaled_number d q) == unit_ * q.
  Proof.
    intros [k multiple]. unfold scaled_number, unit_. rewrite multiple, Z.div_mul by discriminate.
    destruct q as [n den]. cbn [Qnum Qden] in *. unfold inject_Z, Qeq, Qmult. cbn [Qnum Qden]. lia.
  Qed.

  Lemma scaled_is (v : vector) : has_denominator d v -> stands_for (scaled d v) v.
  Proof. intros [X Y]. split; now apply scaled_number_is. Qed.

  Lemma minus_stands_for (a b : whole_vector) (v w : vector) :
    stands_for a v -> stands_for b w -> stands_for (whole_minus a b) (minus v w).
  Proof. unfold stands_for, whole_minus, minus, Z.sub; cbn. rewrite !inject_Z_plus, !inject_Z_opp. lra. Qed.

  Lemma plus_stands_for (a b : whole_vector) (v w : vector) :
    stands_for a v -> stands_for b w -> stands_for (whole_plus a b) (plus v w).
  Proof. unfold stands_for, whole_plus, plus; cbn. rewrite !inject_Z_plus. lra. Qed.

  Lemma cross_stands_for (a b : whole_vector) (v w : vector) : stands_for a v -> stands_for b w ->
    inject_Z (whole_cross a b) == unit_ * unit_ * cross v w.
  Proof.
    intros [ax ay] [bx by_]. unfold whole_cross, cross, Z.sub.
    rewrite inject_Z_plus, inject_Z_opp, !inject_Z_mult, ax, ay, bx, by_. ring.
  Qed.
End Scaled.

(* Strictly inside along one side. *)
Definition is_strictly_between (u v c : Z) (k : Q) : Prop :=
  0 < inject_Z u + k * inject_Z v /\ inject_Z u + k * inject_Z v < inject_Z c.

Definition covers_place (start along_ : whole_vector) (g : sum_of_two) (k : Q) : Prop :=
  let from := whole_minus start (its_corner g) in
  is_strictly_between (whole_cross from (side_2 g)) (whole_cross along_ (side_2 g)) (its_size g) k /\
  is_strictly_between (whole_cross (side_1 g) from) (whole_cross (side_1 g) along_) (its_size g) k.

Lemma larger_spec (a b k : Q) : larger a b < k -> a < k /\ b < k.
Proof. unfold larger. rewrite <- at_most_is. destruct (at_most_spec a b); lra. Qed.

Lemma smaller_spec (a b k : Q) : k < smaller a b -> k < a /\ k < b.
Proof. unfold smaller. rewrite <- at_most_is. destruct (at_most_spec a b); lra. Qed.

Lemma quotients (n : Z) (m : denominator) (k : Q) :
  ((n # m) < k <-> inject_Z n < k * inject_Z (Zpos m)) /\ (k < (n # m) <-> k * inject_Z (Zpos m) < inject_Z n).
Proof. unfold Qlt, Qmult, inject_Z. cbn [Qnum Qden]. rewrite !Pos.mul_1_r. lia. Qed.

Lemma narrowed_is (u v c : Z) (l : Q * Q) (k : Q) :
  fst (narrowed u v c l) < k -> k < snd (narrowed u v c l) -> fst l < k /\ k < snd l /\ is_strictly_between u v c k.
Proof.
  unfold narrowed, is_strictly_between. destruct v as [| m | m]; cbn [fst snd]; intros above below.
  - destruct ((0 <? u)%Z && (u <? c)%Z) eqn:inside_; cbn [fst snd] in *; [| lra].
    apply andb_true_iff in inside_. destruct inside_ as [u_some u_less]. apply Z.ltb_lt in u_some, u_less.
    rewrite Zlt_Qlt in u_some, u_less. change (inject_Z 0) with 0 in *. repeat split; lra.
  - apply larger_spec in above. apply smaller_spec in below.
    rewrite (proj1 (quotients _ m k)), inject_Z_opp in above. unfold Z.sub in below.
    rewrite (proj2 (quotients _ m k)), inject_Z_plus, inject_Z_opp in below. repeat split; lra.
  - apply larger_spec in above. apply smaller_spec in below. unfold Z.sub in above.
    rewrite (proj1 (quotients _ m k)), inject_Z_plus, inject_Z_opp in above. rewrite (proj2 (quotients _ m k)) in below.
    change (inject_Z (Zneg m)) with (- inject_Z (Zpos m)). repeat split; lra.
Qed.

Lemma part_inside_is (start along_ : whole_vector) (g : sum_of_two) (inner : Q * Q) (k : Q) :
  part_inside start along_ g = Some inner -> fst inner < k -> k < snd inner -> covers_place start along_ g k.
Proof.
  unfold part_inside, covers_place. destruct (is_beyond _ _ _); [discriminate |].
  destruct (is_beyond _ _ _); [discriminate |].
  intros [= <-] above below. destruct (narrowed_is _ _ _ _ _ above below) as (above' & below' & second_).
  destruct (narrowed_is _ _ _ _ _ above' below') as (_ & _ & first_). now split.
Qed.

Lemma without_inner_is (inner : Q * Q) (l : part) (k : Q) : is_in_part k l -> ~ (fst inner < k /\ k < snd inner) ->
  exists rest, In rest (without_inner inner l) /\ is_in_part k rest.
Proof.
  destruct inner as [low high]. unfold without_inner, is_in_part. cbn [fst snd]. intros [above below] not_inside.
  destruct (Qle_bool high low || Qle_bool (snd l) low || Qle_bool high (fst l)); [exists l; cbn; tauto |].
  setoid_rewrite in_app_iff. rewrite <- (at_most_is (fst l)), <- (at_most_is high). destruct (Qlt_le_dec low k).
  - assert (high <= k) by (apply Qnot_lt_le; tauto). exists (high, snd l).
    destruct (at_most_spec high (snd l)); [cbn; split; [right; now left | lra] | lra].
  - exists (fst l, low). destruct (at_most_spec (fst l) low); [cbn; split; [left; now left | lra] | lra].
Qed.

Lemma uncovered_is (start along_ : whole_vector) (k : Q) (sums : list sum_of_two) : forall l,
  (exists part_, In part_ l /\ is_in_part k part_) ->
  (exists part_, In part_ (uncovered start along_ l sums) /\ is_in_part k part_) \/
  (exists g, In g sums /\ covers_place start along_ g k).
Proof.
  induction sums as [| g sums IH]; intros l has; [left; now destruct l |].
  destruct l as [| first_ l]; [now destruct has as (? & [] & _) |]. cbn [uncovered]. set (l' := first_ :: l) in *.
  set (rest := match part_inside start along_ g with None => l' | Some _ => _ end).
  assert (step : (exists part_, In part_ rest /\ is_in_part k part_) \/ covers_place start along_ g k).
  { unfold rest. destruct (part_inside start along_ g) as [inner |] eqn:inside_; [| now left].
    destruct has as (part_ & I & in_part).
    destruct (Qlt_le_dec (fst inner) k); [destruct (Qlt_le_dec k (snd inner)) |];
      [right; now apply (part_inside_is _ _ _ inner) | left | left];
      (destruct (without_inner_is inner part_ k in_part) as (more & R & in_more); [lra |]);
      exists more; (split; [apply in_flat_map; now exists part_ | exact in_more]). }
  destruct step as [has' | covers_]; [| right; exists g; split; [now left | exact covers_]].
  destruct (IH rest has') as [| (h & H & covers_)]; [now left | right; exists h; split; [now right | exact covers_]].
Qed.

(* The sum of a point inside one edge and one inside another, which is not parallel. *)
Definition is_inside_the_sum_of_two (e f : segment) (w : vector) : Prop :=
  exists g h, 0 < g < 1 /\ 0 < h < 1 /\ equal_vectors w (plus (point_at e g) (point_at f h)) /\
    ~ cross (along e) (along f) == 0.

(* The parallelogram of the edges goes round it, and round all points near it. *)
Lemma inside_the_sum_of_two_edges (p q : region) (e f : segment) (w : vector) :
  In e (region_edges p) -> In f (region_edges q) -> is_inside_the_sum_of_two e f w -> inner_point_of_sum w p q.
Proof.
  intros E F (g & h & g_range & h_range & equal & turn).
  assert (once : forall i j, equal_vectors w (plus (point_at e i) (point_at f j)) -> g == i /\ h == j).
  { intros i j equal'. split; apply (Qmult_inj_r _ _ _ turn); destruct equal, equal'; clear - H H0 H1 H2;
      to_coordinates; by_equations. }
  assert (general : not_sum_of_an_end w e f).
  { repeat split; intros (k & _ & X & Y);
      [destruct (once 0 k) | destruct (once 1 k) | destruct (once k 0) | destruct (once k 1)]; try lra; by_computing. }
  destruct (winding_number_near w (parallelogram e f) (closed_chain_cycles _) (off_parallelogram w e f general))
    as (radius & R & near).
  exists radius. split; [exact R |]. intros y close. destruct (near y close) as [_ same_number].
  destruct (parallelogram_winding_number y e f) as [none | [_ (a & b & on_a & on_b & sum_)]].
  - exfalso. destruct (crossing_edges_count w e f); trivial; try lia;
      [intros [X Y]; apply turn; unfold cross; rewrite X, Y; ring .. |].
    exists (point_at e g), (point_at f h). split; [apply point_at_lies_on; lra |].
    split; [apply point_at_lies_on; lra | exact equal].
  - exists a, b. split; [right; now exists e |]. split; [right; now exists f | exact sum_].
Qed.

Lemma in_sums_of_edges (d : denominator) (p q : list segment) (g : sum_of_two) : In g (sums_of_edges d p q) ->
  exists e f, In e p /\ In f q /\ In g (sum_of_edges d e f).
Proof.
  intros I. apply (Permutation_in _ (Permutation_sym (Sorted_by_size.Permuted_sort _))) in I.
  apply in_flat_map in I. destruct I as (e & E & I). apply in_flat_map in I. destruct I as (f & F & I). now exists e, f.
Qed.

Definition ends_stand (d : denominator) (s : segment) : Prop :=
  has_denominator d (source s) /\ has_denominator d (target s).

Lemma along_stands_for (d : denominator) (s : segment) : ends_stand d s ->
  stands_for d (whole_minus (scaled d (target s)) (scaled d (source s))) (along s).
Proof. intros [from to]. apply minus_stands_for; now apply scaled_is. Qed.

Lemma sum_of_edges_is (d : denominator) (e f : segment) (g : sum_of_two) : ends_stand d e -> ends_stand d f ->
  In g (sum_of_edges d e f) -> exists a b, (a = e /\ b = f \/ a = f /\ b = e) /\
    stands_for d (its_corner g) (plus (source a) (source b)) /\ stands_for d (side_1 g) (along a) /\
    stands_for d (side_2 g) (along b) /\
    inject_Z (its_size g) == inject_Z (Zpos d) * inject_Z (Zpos d) * cross (along a) (along b).
Proof.
  intros e_is f_is G.
  pose proof (along_stands_for d e e_is) as e_along. pose proof (along_stands_for d f f_is) as f_along.
  pose proof (plus_stands_for d _ _ _ _ (scaled_is d _ (proj1 e_is)) (scaled_is d _ (proj1 f_is))) as start_.
  pose proof (cross_stands_for d _ _ _ _ e_along f_along) as size_. unfold sum_of_edges in G.
  destruct (whole_cross _ _) as [| m | m]; [destruct G | |]; destruct G as [<- | []];
    [exists e, f | exists f, e]; cbn [its_corner side_1 side_2 its_size]; repeat (split; [tauto |]);
    [exact size_ |].
  destruct start_ as [start_x start_y]. split; [split; [rewrite start_x | rewrite start_y]; by_computing |].
  repeat (split; [tauto |]).
  change (inject_Z (Zneg m)) with (- inject_Z (Zpos m)) in size_. unfold cross in *. lra.
Qed.

(* Theorem. What is not in the parts that are returned is inside the sum of two edges. *)
Theorem covered_is_inside_a_sum_of_two (of_p of_q : list segment) (d : denominator) (s : segment) (k : Q) :
  (forall t, t = s \/ In t of_p \/ In t of_q -> ends_stand d t) -> 0 <= k <= 1 ->
  (exists part_, In part_ (uncovered_parts d (sums_of_edges d of_p of_q) s) /\ is_in_part k part_) \/
  exists e f, In e of_p /\ In f of_q /\ is_inside_the_sum_of_two e f (point_at s k).
Proof.
  intros divides range.
  destruct (uncovered_is (scaled d (source s)) (whole_minus (scaled d (target s)) (scaled d (source s))) k
    (sums_of_edges d of_p of_q) [(0, 1)]) as [found | (g & G & [[c1 c2] [c3 c4]])];
    [exists (0, 1); split; [now left | exact range] | now left | right].
  apply in_sums_of_edges in G. destruct G as (e & f & E & F & G). exists e, f. split; [exact E |]. split; [exact F |].
  destruct (sum_of_edges_is d e f g (divides e ltac:(tauto)) (divides f ltac:(tauto)) G)
    as (a & b & sides & corner_ & a_is & b_is & size_is).
  pose proof (divides s (or_introl eq_refl)) as s_is. pose proof (along_stands_for d s s_is) as s_along.
  pose proof (minus_stands_for d _ _ _ _ (scaled_is d _ (proj1 s_is)) corner_) as from_.
  rewrite (cross_stands_for d _ _ _ _ from_ b_is), (cross_stands_for d _ _ _ _ s_along b_is) in c1, c2.
  rewrite (cross_stands_for d _ _ _ _ a_is from_), (cross_stands_for d _ _ _ _ a_is s_along) in c3, c4.
  rewrite size_is in c2, c4. clear - c1 c2 c3 c4 sides. set (o := minus (point_at s k) (plus (source a) (source b))).
  assert (some : 0 < inject_Z (Zpos d) * inject_Z (Zpos d)) by reflexivity.
  set (unit_ := inject_Z (Zpos d) * inject_Z (Zpos d)) in *.
  set (D := cross (along a) (along b)) in *. set (u := cross o (along b)). set (v := cross (along a) o).
  assert (u_is : u == cross (minus (source s) (plus (source a) (source b))) (along b) + k * cross (along s) (along b))
    by (unfold u, o; by_computing).
  assert (v_is : v == cross (along a) (minus (source s) (plus (source a) (source b))) + k * cross (along a) (along s))
    by (unfold v, o; by_computing).
  assert (u_range : 0 < u < D) by (rewrite u_is; split; apply (Qmult_lt_l _ _ unit_ some); lra).
  assert (v_range : 0 < v < D) by (rewrite v_is; split; apply (Qmult_lt_l _ _ unit_ some); lra).
  assert (fraction_ : forall n, 0 < n < D -> 0 < n / D < 1)
    by (intros n n_range; split; [apply Qlt_shift_div_l | apply Qlt_shift_div_r]; lra).
  assert (equal : equal_vectors (point_at s k) (plus (point_at a (u / D)) (point_at b (v / D)))).
  { clear - u_range. assert (turn : ~ D == 0) by lra. unfold u, v, D, o in *. to_coordinates.
    split; field; exact turn. }
  pose proof (fraction_ u u_range). pose proof (fraction_ v v_range).
  destruct sides as [[-> ->] | [-> ->]]; [exists (u / D), (v / D) | exists (v / D), (u / D)];
    (split; [assumption |]; split; [assumption |]; split; [by_computing | unfold D, cross in *; lra]).
Qed.

(* So it is inside the sum. *)
Corollary covered_is_inside_the_sum (p q : region) (d : denominator) (s : segment) (k : Q) :
  (forall t, t = s \/ In t (region_edges p) \/ In t (region_edges q) -> ends_stand d t) -> 0 <= k <= 1 ->
  (exists part_, In part_ (uncovered_parts d (sums_of_edges d (region_edges p) (region_edges q)) s) /\
    is_in_part k part_) \/ inner_point_of_sum (point_at s k) p q.
Proof.
  intros divides range. destruct (covered_is_inside_a_sum_of_two _ _ d s k divides range)
    as [found | (e & f & E & F & inside_)]; [now left | right]. now apply (inside_the_sum_of_two_edges p q e f).
Qed.
