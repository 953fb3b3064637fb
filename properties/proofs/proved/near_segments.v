(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Points that are near each of some segments: if they are near enough, the segments have a point in common. Being near
   is linear conditions on coordinates. Coordinates are eliminated from these, one after the other; what is left are
   conditions on how near the points are (Fourier and Motzkin). So if at each point there is a direction to the left of
   all segments there, such a direction is found for all points, where the nearly met segments count, too. *)
From Coq Require Import QArith Qminmax Lqa Bool List.
From Oplus Require Import regions_and_sums small_numbers first_hit neighbourhoods coordinates.
Import ListNotations.

Open Scope Q_scope.

(* A condition on x and y, with a slack in proportion to e. *)
Record condition := Condition { of_x : Q; of_y : Q; limit : Q; slack : Q }.

Definition holds (e x y : Q) (c : condition) : Prop := of_x c * x + of_y c * y <= limit c + slack c * e.
Definition all_hold (e x y : Q) (l : list condition) : Prop := forall c, In c l -> holds e x y c.

Definition both_conditions (pair_ : condition * condition) : condition :=
  let (c, d) := pair_ in
  Condition (of_y d * of_x c - of_y c * of_x d) 0 (of_y d * limit c - of_y c * limit d)
    (of_y d * slack c - of_y c * slack d).
Definition from_below (c : condition) : bool := negative (of_y c).
Definition from_above (c : condition) : bool := positive (of_y c).
Definition on_x_only (c : condition) : bool := negb (from_below c || from_above c).

(* What they ask of x. *)
Definition eliminated (l : list condition) : list condition :=
  filter on_x_only l ++ map both_conditions (list_prod (filter from_below l) (filter from_above l)).

Lemma conditions_by_sign (l : list condition) (c : condition) :
  (In c (filter from_below l) <-> In c l /\ of_y c < 0) /\ (In c (filter from_above l) <-> In c l /\ 0 < of_y c) /\
  (In c (filter on_x_only l) <-> In c l /\ of_y c == 0).
Proof.
  rewrite !filter_In. unfold on_x_only, from_below, from_above.
  destruct (negative_spec (of_y c)), (positive_spec (of_y c)); cbn; intuition (lra || discriminate).
Qed.

Lemma a_number_between (lows highs : list Q) : (forall l h, In l lows -> In h highs -> l <= h) ->
  exists y, (forall l, In l lows -> l <= y) /\ (forall h, In h highs -> y <= h).
Proof.
  intros ordered_. destruct lows as [| l0 lows]; [destruct highs as [| h0 highs] |].
  - exists 0. split; intros ? [].
  - destruct (least_of (fun h => h) (h0 :: highs)) as (y & _ & least); [discriminate |]. exists y.
    split; [intros ? [] | exact least].
  - destruct (least_of (fun l => - l) (l0 :: lows)) as (y & Y & most); [discriminate |]. exists y.
    split; [intros l L; specialize (most l L); lra | intros h H; exact (ordered_ y h Y H)].
Qed.

Lemma eliminated_is (e x : Q) (l : list condition) :
  all_hold e x 0 (eliminated l) <-> exists y, all_hold e x y l.
Proof.
  split.
  - intros all. set (bound := fun c => (limit c + slack c * e - of_x c * x) / of_y c).
    assert (value : forall c, ~ of_y c == 0 -> bound c * of_y c == limit c + slack c * e - of_x c * x)
      by (intros c some; unfold bound; field; exact some).
    clearbody bound.
    destruct (a_number_between (map bound (filter from_below l)) (map bound (filter from_above l))) as (y & lows &
      highs).
    { intros low high L H. apply in_map_iff in L, H. destruct L as (c & <- & C), H as (d & <- & D).
      assert (both : holds e x 0 (both_conditions (c, d)))
        by (apply all, in_app_iff; right; apply in_map, in_prod; assumption).
      apply conditions_by_sign in C, D. destruct C as [_ c_low], D as [_ d_high].
      pose proof (value c ltac:(lra)) as c_is. pose proof (value d ltac:(lra)) as d_is.
      unfold holds, both_conditions in both. cbn [of_x of_y limit slack] in both. apply Qnot_lt_le. intros less.
      assert (of_y d * (bound c * of_y c) - of_y c * (bound d * of_y d) >= 0) by (rewrite c_is, d_is; lra).
      assert (0 < (bound c - bound d) * (of_y d * - of_y c)) by (repeat apply Qmult_lt_0_compat; lra). lra. }
    exists y. intros c C. unfold holds. destruct (Q_dec (of_y c) 0) as [[low | high] | none].
    + specialize (lows (bound c) (in_map bound _ _ (proj2 (proj1 (conditions_by_sign l c)) (conj C low)))).
      pose proof (value c ltac:(lra)). nra.
    + specialize (highs (bound c) (in_map bound _ _ (proj2 (proj1 (proj2 (conditions_by_sign l c))) (conj C high)))).
      pose proof (value c ltac:(lra)). nra.
    + assert (there : holds e x 0 c) by (apply all, in_app_iff; left; now apply conditions_by_sign).
      unfold holds in there. rewrite none in *. lra.
  - intros (y & all) c C. apply in_app_iff in C. destruct C as [C | C].
    + apply conditions_by_sign in C. destruct C as [C none]. specialize (all c C). unfold holds in *.
      rewrite none in *. lra.
    + apply in_map_iff in C. destruct C as ([d f] & <- & D). apply in_prod_iff in D. destruct D as [D F].
      apply conditions_by_sign in D, F. destruct D as [D low], F as [F high].
      pose proof (all d D) as d_holds. pose proof (all f F) as f_holds. unfold holds, both_conditions in *.
      cbn [of_x of_y limit slack]. nra.
Qed.

Definition swapped (c : condition) : condition := Condition (of_y c) (of_x c) (limit c) (slack c).

Lemma all_hold_swapped (e x y : Q) (l : list condition) : all_hold e y x (map swapped l) <-> all_hold e x y l.
Proof.
  split.
  - intros all c C. specialize (all _ (in_map swapped l c C)). unfold holds, swapped in *. cbn in all. lra.
  - intros all c C. apply in_map_iff in C. destruct C as (d & <- & D). specialize (all d D).
    unfold holds, swapped in *. cbn. lra.
Qed.

(* Conditions can be met, or not nearly. *)
Theorem met_or_not_nearly (l : list condition) :
  (exists x y, all_hold 0 x y l) \/ eventually (fun e => forall x y, ~ all_hold e x y l).
Proof.
  set (left_ := eliminated (map swapped (eliminated l))).
  assert (solved : forall e, all_hold e 0 0 left_ <-> exists x y, all_hold e x y l).
  { intros e. unfold left_. rewrite eliminated_is. split; intros (x & all); exists x.
    - apply all_hold_swapped, eliminated_is in all. exact all.
    - apply all_hold_swapped, eliminated_is. exact all. }
  destruct (Exists_dec (fun c => limit c < 0) left_) as [some | none].
  { intros c. destruct (Qlt_le_dec (limit c) 0); [now left | right; lra]. }
  - right. apply Exists_exists in some. destruct some as (c & C & less).
    refine (eventually_implied _ _ _ (eventually_positive (- limit c) (- slack c) ltac:(lra))).
    intros e few x y all. assert (here : holds e 0 0 c) by (apply (solved e); [now exists x, y | exact C]).
    unfold holds in here. lra.
  - left. apply solved. intros c C. unfold holds. apply Qnot_lt_le. intros less. apply none, Exists_exists.
    exists c. split; [exact C | lra].
Qed.

(* Near a segment. *)
Definition near_segment (e : Q) (z : vector) (s : segment) : Prop :=
  (- e <= area s z /\ area s z <= e) /\ - e <= dot (along s) (minus z (source s)) /\
  dot (along s) (minus z (target s)) <= e.

Definition near_it (s : segment) : list condition :=
  let a := along s in let v := source s in let w := target s in
  let base := vy a * vx v - vx a * vy v in
  [Condition (vy a) (- vx a) base 1; Condition (- vy a) (vx a) (- base) 1;
   Condition (- vx a) (- vy a) (- (vx a * vx v + vy a * vy v)) 1;
   Condition (vx a) (vy a) (vx a * vx w + vy a * vy w) 1].

Lemma near_is (e x y : Q) (s : segment) : all_hold e x y (near_it s) <-> near_segment e (Vector x y) s.
Proof.
  unfold all_hold, near_it, holds, near_segment. to_coordinates. split.
  - intros all. pose proof (all _ (or_introl eq_refl)). pose proof (all _ (or_intror (or_introl eq_refl))).
    pose proof (all _ (or_intror (or_intror (or_introl eq_refl)))).
    pose proof (all _ (or_intror (or_intror (or_intror (or_introl eq_refl))))). cbn in *. lra.
  - intros near_ c [<- | [<- | [<- | [<- | []]]]]; cbn [of_x of_y limit slack]; lra.
Qed.

Lemma near_is_on (z : vector) (s : segment) : nonzero (along s) -> near_segment 0 z s -> lies_on z s.
Proof.
  intros long [on between_]. pose proof (square_positive _ long) as square. set (a := along s) in *.
  exists (dot a (minus z (source s)) / dot a a).
  assert (value : dot a (minus z (source s)) / dot a a * dot a a == dot a (minus z (source s))) by (field; lra).
  set (k := dot a (minus z (source s)) / dot a a) in *. clearbody k.
  assert (line : area s z == 0) by lra.
  assert (share : dot a (minus z (target s)) == dot a (minus z (source s)) - dot a a) by (unfold a; by_computing).
  split; [nra |].
  assert (X : vx z == vx (source s) + k * vx a /\ vy z == vy (source s) + k * vy a).
  { unfold area in line. fold (along s) in line. fold a in line. clearbody a. unfold dot, cross, minus in *.
    cbn [vx vy] in *. split; apply (Qmult_inj_l _ _ (vx a * vx a + vy a * vy a)); (lra || by_equations). }
  destruct X as [X Y]. rewrite X, Y. unfold a, along, minus. cbn [vx vy]. split; ring.
Qed.

Lemma nearer (d e : Q) (z : vector) (s : segment) : d <= e -> near_segment d z s -> near_segment e z s.
Proof. unfold near_segment. lra. Qed.

Lemma near_dec (e : Q) (z : vector) (s : segment) : {near_segment e z s} + {~ near_segment e z s}.
Proof.
  unfold near_segment.
  destruct (Qlt_le_dec (area s z) (- e)); [right; lra |]. destruct (Qlt_le_dec e (area s z)); [right; lra |].
  destruct (Qlt_le_dec (dot (along s) (minus z (source s))) (- e)); [right; lra |].
  destruct (Qlt_le_dec e (dot (along s) (minus z (target s)))); [right; lra | left; lra].
Qed.

Definition all_near (e : Q) (z : vector) (l : list segment) : Prop := forall s, In s l -> near_segment e z s.

(* Segments have a common point, or nothing is near all of them. *)
Lemma common_point_or_none_near (l : list segment) : (forall s, In s l -> nonzero (along s)) ->
  (exists z, forall s, In s l -> lies_on z s) \/ eventually (fun e => forall z, ~ all_near e z l).
Proof.
  intros long. destruct (met_or_not_nearly (flat_map near_it l)) as [(x & y & all) | none]; [left | right].
  - exists (Vector x y). intros s S. apply near_is_on; [now apply long |]. apply near_is. intros c C. apply all.
    apply in_flat_map. now exists s.
  - refine (eventually_implied _ _ _ none). intros e far [x y] close. apply (far x y). intros c C.
    apply in_flat_map in C. destruct C as (s & S & C). exact (proj2 (near_is e x y s) (close s S) c C).
Qed.

Definition at_most_one (u : vector) : Prop := within 1 nowhere u.

(* Theorem. *)
Theorem directions_to_the_left (l : list segment) : (forall s, In s l -> nonzero (along s)) ->
  (forall v, exists u, forall s, In s l -> lies_on v s -> 0 < cross (along s) u) ->
  eventually (fun r => forall z, exists u, at_most_one u /\
    forall s, In s l -> near_segment r z s -> r * r <= cross (along s) u).
Proof.
  intros long each.
  (* those of one part all near, of the other some *)
  enough (all : forall some part, incl part l -> incl some l -> eventually (fun r => forall z, all_near r z part ->
    exists u, at_most_one u /\ forall s, In s (part ++ some) -> near_segment r z s -> r * r <= cross (along s) u)).
  { refine (eventually_implied _ _ _ (all l [] ltac:(intros s []) (incl_refl _))). intros r there z.
    apply there. intros s []. }
  induction some as [| a some IH]; intros part P S.
  - destruct (common_point_or_none_near part) as [(v & on) | none]; [intros s I; now apply long, P | |].
    + destruct (each v) as (u & left_).
      refine (eventually_implied _ _ _ (eventually_and _ _ (eventually_and _ _ (eventually_below 1 ltac:(lra))
        (small_steps_stay_within 1 nowhere u ltac:(lra)))
        (eventually_for_all (fun s r => r <= cross (along s) u) part _))).
      * intros r [[[some _] short] below] z _. exists (moved_along nowhere u r). split; [exact short |].
        intros s I _. rewrite app_nil_r in I. setoid_replace (cross (along s) (moved_along nowhere u r))
          with (r * cross (along s) u) by (unfold cross, moved_along, nowhere; cbn [vx vy]; ring).
        specialize (below s I). nra.
      * intros s I. exists (cross (along s) u). split; [apply left_; [now apply P | now apply on] |]. intros; lra.
    + refine (eventually_implied _ _ _ none). intros r far z close. destruct (far z close).
  - refine (eventually_implied _ _ _ (eventually_and _ _ (IH part P _) (IH (a :: part) _ _))).
    + intros r [without with_] z close. destruct (near_dec r z a) as [near_a | far_a].
      * destruct (with_ z) as (u & one & left_); [intros s [<- | I]; [exact near_a | now apply close] |].
        exists u. split; [exact one |]. intros s I. apply left_. apply in_app_iff in I. apply in_app_iff.
        cbn in *. tauto.
      * destruct (without z close) as (u & one & left_). exists u. split; [exact one |]. intros s I here.
        apply left_; [| exact here]. apply in_app_iff in I. apply in_app_iff.
        destruct I as [I | [<- | I]]; [now left | contradiction | now right].
    + intros s I. apply S. now right.
    + intros s [<- | I]; [apply S; now left | now apply P].
    + intros s I. apply S. now right.
Qed.

(* What is close to a point of a segment is near the segment. *)
Lemma close_is_near (s : segment) (z v : vector) (radius : Q) : lies_on v s -> within radius v z ->
  near_segment (radius * size (along s)) z s.
Proof.
  intros on [X Y]. pose proof (on_the_line v s on) as line.
  pose proof (product_bounds _ (vx (along s)) radius X). pose proof (product_bounds _ (vy (along s)) radius X).
  pose proof (product_bounds _ (vx (along s)) radius Y). pose proof (product_bounds _ (vy (along s)) radius Y).
  assert (turned : area s z == area s v + (vx (along s) * (vy z - vy v) - vy (along s) * (vx z - vx v)))
    by (to_coordinates; ring).
  assert (ahead : forall w, dot (along s) (minus z w) == dot (along s) (minus v w) +
    (vx (along s) * (vx z - vx v) + vy (along s) * (vy z - vy v))) by (intros w; to_coordinates; ring).
  destruct on as (k & range & vx_is & vy_is).
  assert (from_ : dot (along s) (minus v (source s)) == k * dot (along s) (along s))
    by (to_coordinates; rewrite vx_is, vy_is; ring).
  assert (to : dot (along s) (minus v (target s)) == - ((1 - k) * dot (along s) (along s)))
    by (to_coordinates; rewrite vx_is, vy_is; ring).
  pose proof (squares_are_not_negative (vx (along s)) (vy (along s))) as square.
  change (0 <= dot (along s) (along s)) in square.
  assert (0 <= k * dot (along s) (along s)) by (apply Qmult_le_0_compat; lra).
  assert (0 <= (1 - k) * dot (along s) (along s)) by (apply Qmult_le_0_compat; lra).
  unfold near_segment. rewrite (ahead (source s)), (ahead (target s)), turned, line, from_, to. unfold size. lra.
Qed.

Lemma sizes_are_bounded (l : list segment) : exists most, 0 < most /\ forall s, In s l -> size (along s) <= most.
Proof.
  induction l as [| s l (most & some & all)]; [exists 1; split; [lra | intros s []] |].
  exists (Qmax most (size (along s))).
  pose proof (Q.le_max_l most (size (along s))). pose proof (Q.le_max_r most (size (along s))).
  split; [lra |]. intros t [<- | T]; [assumption |]. specialize (all t T). lra.
Qed.
