(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Where an edge of P crosses one of -Q + x, the interiors meet: x is inside the sum of the two edges, a parallelogram.
   So a segment is of no interest where such parallelograms cover it. A program that returns the parts of a segment that
   they do not cover, and the proof that all else is inside the sum (the first half of the collision test, for all x of
   a segment at once). Integers: coordinates are multiplied by a common denominator. Large parallelograms come first,
   which only saves time. *)
From Coq Require Import QArith Qabs Qminmax Lqa Qfield ZArith Lia Bool List Permutation Orders Mergesort.
From Oplus Require Import convolution in_out_degree regions meeting_of_segments neighbourhoods interiors_meet
  theorem_2_2_10.
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
  rewrite is_lcm in of_both. split; [| intros a [<- | I]; [| exact (of_others a I)]]; (etransitivity; [| exact of_both]).
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
Proof.
  intros I. repeat split; apply common_multiple_is, in_flat_map; exists s; (split; [exact I | cbn; tauto]).
Qed.

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
  Proof.
    intros [ax ay] [bx by_]. unfold stands_for, whole_minus, minus. cbn [fst snd vx vy].
    unfold Z.sub. rewrite !inject_Z_plus, !inject_Z_opp, ax, ay, bx, by_. split; ring.
  Qed.

  Lemma plus_stands_for (a b : whole_vector) (v w : vector) :
    stands_for a v -> stands_for b w -> stands_for (whole_plus a b) (plus v w).
  Proof.
    intros [ax ay] [bx by_]. unfold stands_for, whole_plus, plus. cbn [fst snd vx vy].
    rewrite !inject_Z_plus, ax, ay, bx, by_. split; ring.
  Qed.

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
Proof.
  unfold larger. destruct (Qle_bool a b) eqn:order; intros below; [apply Qle_bool_iff in order; lra |].
  assert (~ a <= b) by (rewrite <- Qle_bool_iff; congruence). lra.
Qed.

Lemma smaller_spec (a b k : Q) : k < smaller a b -> k < a /\ k < b.
Proof.
  unfold smaller. destruct (Qle_bool a b) eqn:order; intros below; [apply Qle_bool_iff in order; lra |].
  assert (~ a <= b) by (rewrite <- Qle_bool_iff; congruence). lra.
Qed.

Lemma quotient_is (n : Z) (k : denominator) : (n # k) * inject_Z (Zpos k) == inject_Z n.
Proof. unfold inject_Z, Qeq, Qmult. cbn [Qnum Qden]. lia. Qed.

Lemma narrowed_is (u v c : Z) (l : Q * Q) (k : Q) :
  fst (narrowed u v c l) < k -> k < snd (narrowed u v c l) -> fst l < k /\ k < snd l /\ is_strictly_between u v c k.
Proof.
  unfold narrowed, is_strictly_between. destruct v as [| m | m]; intros above below.
  - destruct ((0 <? u)%Z && (u <? c)%Z) eqn:inside_; cbn [fst snd] in *; [| lra].
    apply andb_true_iff in inside_. destruct inside_ as [u_some u_less]. apply Z.ltb_lt in u_some, u_less.
    rewrite Zlt_Qlt in u_some, u_less. change (inject_Z 0) with 0 in *. repeat split; lra.
  - cbn [fst snd] in *. apply larger_spec in above. apply smaller_spec in below.
    assert (some : 0 < inject_Z (Zpos m)) by reflexivity.
    pose proof (quotient_is (- u) m) as low. pose proof (quotient_is (c - u) m) as high.
    unfold Z.sub in high. rewrite inject_Z_plus in high. rewrite inject_Z_opp in low, high.
    set (unit_ := inject_Z (Zpos m)) in *. clearbody unit_.
    destruct above as [above above'], below as [below below'].
    apply (Qmult_lt_compat_r _ _ unit_ some) in above', below'. unfold Z.sub in below'. repeat split; lra.
  - cbn [fst snd] in *. apply larger_spec in above. apply smaller_spec in below.
    assert (some : 0 < inject_Z (Zpos m)) by reflexivity.
    pose proof (quotient_is (u - c) m) as low. pose proof (quotient_is u m) as high.
    unfold Z.sub in low. rewrite inject_Z_plus, inject_Z_opp in low.
    change (inject_Z (Zneg m)) with (- inject_Z (Zpos m)).
    set (unit_ := inject_Z (Zpos m)) in *. clearbody unit_.
    destruct above as [above above'], below as [below below'].
    apply (Qmult_lt_compat_r _ _ unit_ some) in above', below'. unfold Z.sub in above'. repeat split; lra.
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
  destruct (Qle_bool high low || Qle_bool (snd l) low || Qle_bool high (fst l)).
  { exists l. cbn. tauto. }
  destruct (Qlt_le_dec low k) as [after_ | before_].
  - assert (high_before : high <= k) by (apply Qnot_lt_le; tauto).
    assert (right_ : Qle_bool high (snd l) = true) by (apply Qle_bool_iff; lra).
    exists (high, snd l). split; [apply in_app_iff; right; rewrite right_; now left | cbn; lra].
  - assert (left_ : Qle_bool (fst l) low = true) by (apply Qle_bool_iff; lra).
    exists (fst l, low). split; [apply in_app_iff; left; rewrite left_; now left | cbn; lra].
Qed.

Lemma uncovered_is (start along_ : whole_vector) (k : Q) (sums : list sum_of_two) : forall l,
  (exists part_, In part_ l /\ is_in_part k part_) ->
  (exists part_, In part_ (uncovered start along_ l sums) /\ is_in_part k part_) \/
  (exists g, In g sums /\ covers_place start along_ g k).
Proof.
  induction sums as [| g sums IH]; intros l has; [left; now destruct l |].
  assert (unfolded : uncovered start along_ l (g :: sums) =
    match l with [] => [] | _ => uncovered start along_
      match part_inside start along_ g with None => l | Some inner => flat_map (without_inner inner) l end sums end)
    by now destruct l.
  rewrite unfolded. destruct l as [| first_ l]; [now destruct has as (? & [] & _) |].
  destruct (part_inside start along_ g) as [inner |] eqn:inside_.
  - destruct (Qlt_le_dec (fst inner) k) as [above |];
      [destruct (Qlt_le_dec k (snd inner)) as [below |] |].
    { right. exists g. split; [now left | exact (part_inside_is _ _ _ _ _ inside_ above below)]. }
    all: destruct (IH (flat_map (without_inner inner) (first_ :: l))) as [found | (h & H & covers_)];
      [| now left | right; exists h; split; [now right | exact covers_]];
      destruct has as (part_ & I & in_part); destruct (without_inner_is inner part_ k in_part) as (rest & R & in_rest);
      [lra | exists rest; split; [| exact in_rest]; apply in_flat_map; now exists part_].
  - destruct (IH (first_ :: l) has) as [found | (h & H & covers_)]; [now left |].
    right. exists h. split; [now right | exact covers_].
Qed.

(* Points strictly inside the sum of two edges are inside the sum of the regions. *)
Lemma positive_nearby_in_plane (w b : vector) (u : Q) : 0 < u ->
  exists radius, 0 < radius /\ forall y, within radius w y -> 0 < u + cross (minus y w) b.
Proof.
  intros some. pose proof (abs_bounds (vx b)) as (x0 & x1 & x2). pose proof (abs_bounds (vy b)) as (y0 & y1 & y2).
  set (X := Qabs (vx b)) in *. set (Y := Qabs (vy b)) in *. clearbody X Y.
  assert (radius_some : 0 < u / (1 + X + Y)) by (apply Qlt_shift_div_l; lra).
  assert (radius_is : u / (1 + X + Y) * (1 + X + Y) == u) by (field; lra).
  set (radius := u / (1 + X + Y)) in *. clearbody radius. exists radius. split; [exact radius_some |].
  intros y [near_x near_y]. unfold cross, minus. cbn [vx vy].
  set (dx := vx y - vx w) in *. set (dy := vy y - vy w) in *. clearbody dx dy.
  assert (- (radius * Y) <= dx * vy b) by nra. assert (- (radius * X) <= - (dy * vx b)) by nra. lra.
Qed.

Definition is_inside_the_sum_of_two (o a b w : vector) : Prop :=
  0 < cross (minus w o) b /\ cross (minus w o) b < cross a b /\ 0 < cross a (minus w o) /\
  cross a (minus w o) < cross a b.

(* Such a point is the sum of points inside the edges. *)
Lemma as_sum_of_points (o a b w : vector) : is_inside_the_sum_of_two o a b w ->
  exists g h, 0 < g < 1 /\ 0 < h < 1 /\
    vx w == vx o + g * vx a + h * vx b /\ vy w == vy o + g * vy a + h * vy b.
Proof.
  intros (i1 & i2 & j1 & j2). exists (cross (minus w o) b / cross a b), (cross a (minus w o) / cross a b).
  assert (turn_ : ~ cross a b == 0) by lra.
  split; [split; [apply Qlt_shift_div_l | apply Qlt_shift_div_r]; lra |].
  split; [split; [apply Qlt_shift_div_l | apply Qlt_shift_div_r]; lra |].
  unfold cross, minus in *; cbn [vx vy] in *. split; field; exact turn_.
Qed.

Lemma inside_the_sum_of_two_edges (p q : region) (e f : segment) (w a b : vector) :
  In e (region_edges p) -> In f (region_edges q) -> (a = along e /\ b = along f) \/ (a = along f /\ b = along e) ->
  0 < cross (minus w (plus (source e) (source f))) b -> cross (minus w (plus (source e) (source f))) b < cross a b ->
  0 < cross a (minus w (plus (source e) (source f))) -> cross a (minus w (plus (source e) (source f))) < cross a b ->
  inner_point_of_sum w p q.
Proof.
  intros E F sides i1 i2 j1 j2. set (o := plus (source e) (source f)) in *.
  destruct (positive_nearby_in_plane w b _ i1) as (r1 & R1 & near_1).
  destruct (positive_nearby_in_plane w (opposite b) (cross a b - cross (minus w o) b)) as (r2 & R2 & near_2); [lra |].
  destruct (positive_nearby_in_plane w (opposite a) _ j1) as (r3 & R3 & near_3).
  destruct (positive_nearby_in_plane w a (cross a b - cross a (minus w o))) as (r4 & R4 & near_4); [lra |].
  exists (Qmin (Qmin r1 r2) (Qmin r3 r4)). split; [repeat apply Q.min_glb_lt; assumption |].
  pose proof (Q.le_min_l (Qmin r1 r2) (Qmin r3 r4)). pose proof (Q.le_min_r (Qmin r1 r2) (Qmin r3 r4)).
  pose proof (Q.le_min_l r1 r2). pose proof (Q.le_min_r r1 r2). pose proof (Q.le_min_l r3 r4).
  pose proof (Q.le_min_r r3 r4). set (r := Qmin (Qmin r1 r2) (Qmin r3 r4)) in *. clearbody r.
  intros y close.
  assert (smaller_ : forall radius, r <= radius -> within radius w y) by (intros radius less; unfold within in *; lra).
  specialize (near_1 y (smaller_ r1 ltac:(lra))). specialize (near_2 y (smaller_ r2 ltac:(lra))).
  specialize (near_3 y (smaller_ r3 ltac:(lra))). specialize (near_4 y (smaller_ r4 ltac:(lra))).
  clear smaller_ close.
  assert (y1 : 0 < cross (minus y o) b) by (unfold cross, minus, opposite in *; cbn [vx vy] in *; lra).
  assert (y2 : cross (minus y o) b < cross a b) by (unfold cross, minus, opposite in *; cbn [vx vy] in *; lra).
  assert (y3 : 0 < cross a (minus y o)) by (unfold cross, minus, opposite in *; cbn [vx vy] in *; lra).
  assert (y4 : cross a (minus y o) < cross a b) by (unfold cross, minus, opposite in *; cbn [vx vy] in *; lra).
  clear near_1 near_2 near_3 near_4.
  set (g := cross (minus y o) b / cross a b). set (h := cross a (minus y o) / cross a b).
  assert (g_range : 0 <= g <= 1) by (unfold g; split; [apply Qle_shift_div_l | apply Qle_shift_div_r]; lra).
  assert (h_range : 0 <= h <= 1) by (unfold h; split; [apply Qle_shift_div_l | apply Qle_shift_div_r]; lra).
  assert (turn_ : ~ cross a b == 0) by lra.
  assert (y_x : vx y == vx o + g * vx a + h * vx b)
    by (unfold g, h, cross, minus in *; cbn [vx vy] in *; field; exact turn_).
  assert (y_y : vy y == vy o + g * vy a + h * vy b)
    by (unfold g, h, cross, minus in *; cbn [vx vy] in *; field; exact turn_).
  clearbody g h.
  assert (on_edge : forall (s : segment) k, 0 <= k <= 1 -> lies_on (moved_along (source s) (along s) k) s).
  { intros s k range. exists k. unfold moved_along, along, minus. cbn [vx vy]. split; [exact range |]. split; ring. }
  assert (in_p : forall k, 0 <= k <= 1 -> in_region (moved_along (source e) (along e) k) p)
    by (intros k range; right; exists e; split; [exact E | now apply on_edge]).
  assert (in_q : forall k, 0 <= k <= 1 -> in_region (moved_along (source f) (along f) k) q)
    by (intros k range; right; exists f; split; [exact F | now apply on_edge]).
  destruct sides as [[-> ->] | [-> ->]].
  - exists (moved_along (source e) (along e) g), (moved_along (source f) (along f) h).
    split; [now apply in_p |]. split; [now apply in_q |].
    unfold o, plus, moved_along in *. cbn [vx vy] in *. split; cbn [vx vy]; lra.
  - exists (moved_along (source e) (along e) h), (moved_along (source f) (along f) g).
    split; [now apply in_p |]. split; [now apply in_q |].
    unfold o, plus, moved_along in *. cbn [vx vy] in *. split; cbn [vx vy]; lra.
Qed.

Lemma in_sums_of_edges (d : denominator) (p q : list segment) (g : sum_of_two) : In g (sums_of_edges d p q) ->
  exists e f, In e p /\ In f q /\ In g (sum_of_edges d e f).
Proof.
  intros I. apply (Permutation_in _ (Permutation_sym (Sorted_by_size.Permuted_sort _))) in I.
  apply in_flat_map in I. destruct I as (e & E & I). apply in_flat_map in I. destruct I as (f & F & I). now exists e, f.
Qed.

(* Theorem. What is not in the parts that are returned is inside the sum of two edges. *)
Theorem covered_is_inside_a_sum_of_two (of_p of_q : list segment) (d : denominator) (s : segment) (k : Q) (w : vector) :
  (forall t, t = s \/ In t of_p \/ In t of_q -> has_denominator d (source t) /\ has_denominator d (target t)) ->
  0 <= k <= 1 -> vx w == (1 - k) * vx (source s) + k * vx (target s) ->
  vy w == (1 - k) * vy (source s) + k * vy (target s) ->
  (exists part_, In part_ (uncovered_parts d (sums_of_edges d of_p of_q) s) /\ is_in_part k part_) \/
  exists e f a b, In e of_p /\ In f of_q /\ (a = along e /\ b = along f \/ a = along f /\ b = along e) /\
    is_inside_the_sum_of_two (plus (source e) (source f)) a b w.
Proof.
  intros divides range X Y.
  destruct (uncovered_is (scaled d (source s)) (whole_minus (scaled d (target s)) (scaled d (source s))) k
    (sums_of_edges d of_p of_q) [(0, 1)]) as [found | (g & G & covers_)].
  { exists (0, 1). split; [now left | exact range]. }
  { now left. }
  right. apply in_sums_of_edges in G. destruct G as (e & f & E & F & G).
  assert (ends : forall t, t = s \/ In t of_p \/ In t of_q ->
    stands_for d (scaled d (source t)) (source t) /\ stands_for d (scaled d (target t)) (target t)).
  { intros t which. destruct (divides t which). split; now apply scaled_is. }
  destruct (ends s (or_introl eq_refl)) as [s_from s_to]. destruct (ends e ltac:(tauto)) as [e_from e_to].
  destruct (ends f ltac:(tauto)) as [f_from f_to].
  pose proof (minus_stands_for d _ _ _ _ s_to s_from) as s_along. fold (along s) in s_along.
  pose proof (minus_stands_for d _ _ _ _ e_to e_from) as e_along. fold (along e) in e_along.
  pose proof (minus_stands_for d _ _ _ _ f_to f_from) as f_along. fold (along f) in f_along.
  pose proof (plus_stands_for d _ _ _ _ e_from f_from) as start_.
  pose proof (minus_stands_for d _ _ _ _ s_from start_) as from_.
  pose proof (cross_stands_for d _ _ _ _ e_along f_along) as size_.
  set (o := plus (source e) (source f)) in *.
  assert (some : 0 < inject_Z (Zpos d) * inject_Z (Zpos d)) by reflexivity.
  set (unit_ := inject_Z (Zpos d) * inject_Z (Zpos d)) in *.
  assert (positive_ : forall u, 0 < unit_ * u -> 0 < u).
  { intros u above. apply (Qmult_lt_l 0 u unit_ some). lra. }
  assert (all : forall a b a' b', stands_for d a' a -> stands_for d b' b ->
    covers_place (scaled d (source s)) (whole_minus (scaled d (target s)) (scaled d (source s)))
      (SumOfTwo (whole_plus (scaled d (source e)) (scaled d (source f))) a' b' (its_size g)) k ->
    inject_Z (its_size g) == unit_ * cross a b ->
    0 < cross (minus w o) b /\ cross (minus w o) b < cross a b /\ 0 < cross a (minus w o) /\
    cross a (minus w o) < cross a b).
  { intros a b a' b' a_is b_is [[c1 c2] [c3 c4]] size_is. cbn [its_corner side_1 side_2 its_size] in *.
    rewrite (cross_stands_for d _ _ _ _ from_ b_is), (cross_stands_for d _ _ _ _ s_along b_is) in c1, c2.
    rewrite (cross_stands_for d _ _ _ _ a_is from_), (cross_stands_for d _ _ _ _ a_is s_along) in c3, c4.
    rewrite size_is in c2, c4. fold unit_ in c1, c2, c3, c4.
    assert (w_b : cross (minus w o) b == cross (minus (source s) o) b + k * cross (along s) b)
      by (unfold cross, along, minus; cbn [vx vy]; rewrite X, Y; ring).
    assert (a_w : cross a (minus w o) == cross a (minus (source s) o) + k * cross a (along s))
      by (unfold cross, along, minus; cbn [vx vy]; rewrite X, Y; ring).
    rewrite w_b, a_w.
    assert (0 < cross (minus (source s) o) b + k * cross (along s) b) by (apply positive_; lra).
    assert (0 < cross a b - (cross (minus (source s) o) b + k * cross (along s) b)) by (apply positive_; lra).
    assert (0 < cross a (minus (source s) o) + k * cross a (along s)) by (apply positive_; lra).
    assert (0 < cross a b - (cross a (minus (source s) o) + k * cross a (along s))) by (apply positive_; lra).
    repeat split; lra. }
  unfold sum_of_edges in G.
  destruct (whole_cross _ _) as [| m | m] eqn:size_is; [destruct G | |]; destruct G as [<- | []].
  - cbn [its_size] in all. destruct (all (along e) (along f) _ _ e_along f_along covers_) as (i1 & i2 & j1 & j2);
      [exact size_ |].
    exists e, f, (along e), (along f). unfold is_inside_the_sum_of_two. tauto.
  - cbn [its_size] in all. destruct (all (along f) (along e) _ _ f_along e_along covers_) as (i1 & i2 & j1 & j2).
    { assert (other_way : cross (along f) (along e) == - cross (along e) (along f)) by (unfold cross; ring).
      rewrite other_way. change (inject_Z (Zneg m)) with (- inject_Z (Zpos m)) in size_. lra. }
    exists e, f, (along f), (along e). unfold is_inside_the_sum_of_two. tauto.
Qed.

(* So it is inside the sum. *)
Corollary covered_is_inside_the_sum (p q : region) (d : denominator) (s : segment) (k : Q) (w : vector) :
  (forall t, t = s \/ In t (region_edges p) \/ In t (region_edges q) ->
    has_denominator d (source t) /\ has_denominator d (target t)) ->
  0 <= k <= 1 -> vx w == (1 - k) * vx (source s) + k * vx (target s) ->
  vy w == (1 - k) * vy (source s) + k * vy (target s) ->
  (exists part_, In part_ (uncovered_parts d (sums_of_edges d (region_edges p) (region_edges q)) s) /\
    is_in_part k part_) \/
  inner_point_of_sum w p q.
Proof.
  intros divides range X Y.
  destruct (covered_is_inside_a_sum_of_two _ _ d s k w divides range X Y)
    as [found | (e & f & a & b & E & F & sides & (i1 & i2 & j1 & j2))]; [now left | right].
  now apply (inside_the_sum_of_two_edges p q e f w a b).
Qed.
