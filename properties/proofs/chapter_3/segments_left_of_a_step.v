(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The open sum is not at x, but beside x in a direction n. Then a segment of the convolution covers x that has n to its
   left, also where x is a sum of two vertices, where chains touch, and whatever edges are along n. Beside x, what P and
   -Q + x have in common has a corner (contacts_that_stay.v): a vertex of one, or two edges that cross. There are
   finitely many of these, so close enough to x they touch at x, and inner points of both are close to that contact.
   So left_of_a_covered_edge.v says which edge is covered. *)
From Coq Require Import QArith Qminmax Lqa ZArith Lia Bool List.
From Oplus Require Import regions_and_sums reflected parallelogram boundary_points inside_a_corner edges_at_a_point
  fans_that_touch reduced_convolution pieces naive_collision beside_a_piece collision_is_sound contacts_that_stay
  coordinates chains_that_do_not_cross right_one_of_two_edges left_of_a_covered_edge.
Import ListNotations.

Open Scope Q_scope.

Section Contacts.
  Variables p q : region.
  Variables x n : vector.
  Variable label : summand.
  Hypothesis p_region : valid_region p.
  Hypothesis q_region : valid_region q.
  Hypothesis p_crosses_nowhere : chains_do_not_cross p.
  Hypothesis q_crosses_nowhere : chains_do_not_cross q.
  Hypothesis outside : ~ interiors_meet x p q.
  Hypothesis long : nonzero n.

  Let result := met_to_the_right p q x n label \/ met_to_the_right q p x n (other label).

  Let outside' : ~ interiors_meet x q p.
  Proof. intros meet_. apply outside. now apply interiors_meet_other_way. Qed.

  (* A step that is longer by k has the same on its right. *)
  Lemma step_by_length (a b : region) (l : summand) (m : vector) (k : Q) : 0 < k ->
    vx m == k * vx n -> vy m == k * vy n -> met_to_the_right a b x m l -> met_to_the_right a b x n l.
  Proof.
    intros some X Y (w & u & e & sum_ & E & on & met_ & left_). exists w, u, e.
    split; [exact sum_ |]. split; [exact E |]. split; [exact on |]. split; [exact met_ |].
    assert (value : cross (along e) m == k * cross (along e) n) by (unfold cross; rewrite X, Y; ring).
    rewrite value in left_. apply Qnot_le_lt. intros not_. nra.
  Qed.

  (* Inner points close to a contact, z of P and y of Q, that add up to a step from x. *)
  Lemma inner_points_at_a_contact (w u : vector) : equal_vectors x (plus w u) ->
    exists radius, 0 < radius /\ forall z y t, within radius w z -> within radius u y -> inside z p -> inside y q ->
      0 < t -> equal_vectors (plus z y) (moved_along x n t) -> result.
  Proof.
    intros sum_. destruct (some_square w p) as (r1 & near_p), (some_square u q) as (r2 & near_q).
    pose proof (proj1 near_p) as R1. pose proof (proj1 near_q) as R2.
    exists ((1 # 2) * Qmin r1 r2). pose proof (Q.min_glb_lt r1 r2 0 R1 R2) as R. split; [lra |].
    intros z y t close_z close_y in_p in_q some equal. pose proof (Q.le_min_l r1 r2). pose proof (Q.le_min_r r1 r2).
    (* turned a little, if they are parallel *)
    assert (turned_ : exists z' y', within ((1 # 2) * Qmin r1 r2) w z' /\ within ((1 # 2) * Qmin r1 r2) u y' /\
      inside z' p /\ inside y' q /\ equal_vectors (plus z' y') (moved_along x n t) /\
      ~ cross (minus z' w) (minus y' u) == 0).
    { destruct (Qeq_dec (cross (minus z w) (minus y u)) 0) as [flat | turn]; [| now exists z, y].
      set (m := Vector (- vy n) (vx n)).
      assert (inside_near_ : forall v r, inside v r -> forall d, eventually (fun e => inside (moved_along v d e) r)).
      { intros v r [free round] d. destruct (winding_number_near v _ (region_cycles r) free) as (radius & R' & near).
        refine (eventually_implied _ _ _ (small_steps_stay_within radius v d R')). intros e close.
        destruct (near _ close) as [off_ same_]. split; [exact off_ | lia]. }
      assert (stay : forall v w', within ((1 # 2) * Qmin r1 r2) w' v -> forall d,
        eventually (fun e => within ((1 # 2) * Qmin r1 r2) w' (moved_along v d e))).
      { intros v w' [[x0 x1] [y0 y1]] d. set (R' := (1 # 2) * Qmin r1 r2) in *.
        refine (eventually_implied _ _ _ (eventually_and _ _ (eventually_and _ _
          (eventually_positive (R' + (vx v - vx w')) (vx d) ltac:(lra))
          (eventually_positive (R' - (vx v - vx w')) (- vx d) ltac:(lra))) (eventually_and _ _
          (eventually_positive (R' + (vy v - vy w')) (vy d) ltac:(lra))
          (eventually_positive (R' - (vy v - vy w')) (- vy d) ltac:(lra))))).
        intros e. unfold within, moved_along. cbn [vx vy]. lra. }
      destruct (some_small _ (eventually_and _ _ (eventually_and _ _ (inside_near_ z p in_p m) (stay z w close_z m))
        (eventually_and _ _ (inside_near_ y q in_q (opposite m)) (stay y u close_y (opposite m)))))
        as (e & some_e & [in_z near_z] & [in_y near_y]).
      exists (moved_along z m e), (moved_along y (opposite m) e).
      split; [exact near_z |]. split; [exact near_y |]. split; [exact in_z |]. split; [exact in_y |].
      split; [destruct equal as [X Y]; unfold plus, moved_along, opposite in *; cbn [vx vy] in *; split; cbn [vx vy];
        lra |].
      assert (value : cross (minus (moved_along z m e) w) (minus (moved_along y (opposite m) e) u) ==
        cross (minus z w) (minus y u) + e * cross m (minus (plus z y) (plus w u)))
        by (unfold cross, minus, plus, moved_along, opposite; cbn [vx vy]; ring).
      rewrite value, flat. clear value. destruct equal as [X Y], sum_ as [X' Y'].
      pose proof (square_positive n long) as square.
      unfold m, cross, minus, plus, moved_along, dot in *. cbn [vx vy] in *. rewrite X, Y, <- X', <- Y'.
      intros none. assert (0 < e * t * (vx n * vx n + vy n * vy n)) by (apply Qmult_lt_0_compat; [nra | lra]). lra. }
    clear z y close_z close_y in_p in_q equal.
    destruct turned_ as (z & y & close_z & close_y & in_p & in_q & [X Y] & turn). pose proof sum_ as [X' Y'].
    assert (point_is : forall v v', equal_vectors (plus v (minus v' v)) v')
      by (intros; unfold plus, minus; split; cbn [vx vy]; ring).
    assert (in_z : inside (plus w (minus z w)) p) by (apply (inside_equal z); [symmetry; apply point_is | exact in_p]).
    assert (in_y : inside (plus u (minus y u)) q) by (apply (inside_equal y); [symmetry; apply point_is | exact in_q]).
    assert (step_x : vx (plus (minus z w) (minus y u)) == t * vx n /\ vy (plus (minus z w) (minus y u)) == t * vy n).
    { unfold plus, minus, moved_along in *. cbn [vx vy] in *. split; lra. }
    destruct step_x as [step_x step_y].
    destruct (Q_dec (cross (minus z w) (minus y u)) 0) as [[right_ | left_] | none]; [| | contradiction].
    - destruct (left_of_a_met_edge q p x u w (minus y u) (minus z w) (other label) r2 r1) as [met_ | met_]; trivial.
      1: now apply sum_in_other_order.
      1, 2, 3: clear - close_z close_y H H0; unfold within, plus, minus, opposite in *; cbn [vx vy] in *; lra.
      1: unfold cross in *; lra.
      + right. apply (step_by_length q p _ (plus (minus y u) (minus z w)) t some);
          [rewrite <- step_x | rewrite <- step_y |]; trivial; unfold plus; cbn [vx vy]; ring.
      + left. replace (other (other label)) with label in met_ by now destruct label.
        apply (step_by_length p q _ (plus (minus y u) (minus z w)) t some);
          [rewrite <- step_x | rewrite <- step_y |]; trivial; unfold plus; cbn [vx vy]; ring.
    - destruct (left_of_a_met_edge p q x w u (minus z w) (minus y u) label r1 r2) as [met_ | met_]; trivial.
      1, 2, 3: clear - close_z close_y H H0; unfold within, plus, minus, opposite in *; cbn [vx vy] in *; lra.
      + left. now apply (step_by_length p q _ (plus (minus z w) (minus y u)) t some).
      + right. now apply (step_by_length q p _ (plus (minus z w) (minus y u)) t some).
  Qed.

  (* A corner at a vertex v of P. *)
  Lemma corner_at_a_vertex (v : vector) : is_vertex v p ->
    eventually (fun t => meet_near p q (moved_along x n t) v -> result).
  Proof.
    intros vertex. set (u := minus x v).
    assert (sum_ : equal_vectors x (plus v u)) by (unfold u, plus, minus; split; cbn [vx vy]; ring).
    destruct (on_or_off u (region_edges q)) as [on_q | off_q].
    - destruct (inner_points_at_a_contact v u sum_) as (radius & R & found).
      refine (eventually_implied _ _ _ (eventually_and _ _ (eventually_below 1 ltac:(lra))
        (small_steps_stay_within ((1 # 2) * radius) u n ltac:(lra)))).
      intros t [[some _] close_t] near. destruct (near ((1 # 2) * radius)) as (z & close_z & in_p & in_q); [lra |].
      apply (found z (minus (moved_along x n t) z) t); trivial.
      + apply (within_smaller ((1 # 2) * radius)); [lra | exact close_z].
      + clear - close_z close_t. unfold u, within, minus, moved_along in *. cbn [vx vy] in *. lra.
      + unfold plus, minus. split; cbn [vx vy]; ring.
    - destruct (winding_number_near u _ (region_cycles q) off_q) as (radius & R & same_near).
      refine (eventually_implied _ _ _ (small_steps_stay_within ((1 # 2) * radius) u n ltac:(lra))).
      intros t close_t near. exfalso. destruct (near ((1 # 2) * radius)) as (z & close_z & _ & _ & round); [lra |].
      destruct (same_near (minus (moved_along x n t) z)) as [_ same_].
      { clear - close_z close_t. unfold u, within, minus, moved_along in *. cbn [vx vy] in *. lra. }
      apply outside', (inner_point_and_point q p x u v (valid_is_regular p p_region)).
      + split; [exact off_q | lia].
      + now apply vertex_is_in_region.
      + now apply sum_in_other_order.
  Qed.

  (* A corner where the edges e and f cross. *)
  Lemma corner_where_edges_cross (e f : segment) : In e (region_edges p) -> In f (region_edges q) ->
    eventually (fun t => (exists v, lies_on v e /\ lies_on (minus (moved_along x n t) v) f /\
      ~ cross (along e) (along f) == 0 /\ meet_near p q (moved_along x n t) v) -> result).
  Proof.
    intros E F. set (A := along e). set (B := along f). destruct (Qeq_dec (cross A B) 0) as [flat | turn].
    { exists 1. split; [lra |]. intros t _ _ (v & _ & _ & turn & _). contradiction. }
    (* where the lines of e and x - f meet, and how fast this moves *)
    set (base := minus x (plus (source e) (source f))).
    set (k := cross base B / cross A B). set (l := cross A base / cross A B).
    set (dk := cross n B / cross A B). set (dl := cross A n / cross A B).
    assert (fractions : forall t h g, equal_vectors (moved_along x n t) (plus (point_at e h) (point_at f g)) ->
      h == k + t * dk /\ g == l + t * dl).
    { intros t h g [X Y]. unfold plus, point_at, moved_along in X, Y. cbn [vx vy] in X, Y.
      assert (value_h : cross (moved_along base n t) B == h * cross A B).
      { unfold base, A, B, along, cross, minus, plus, moved_along. cbn [vx vy].
        setoid_replace (vx x - (vx (source e) + vx (source f)) + t * vx n) with
          (h * (vx (target e) - vx (source e)) + g * (vx (target f) - vx (source f))) by lra.
        setoid_replace (vy x - (vy (source e) + vy (source f)) + t * vy n) with
          (h * (vy (target e) - vy (source e)) + g * (vy (target f) - vy (source f))) by lra. ring. }
      assert (value_g : cross A (moved_along base n t) == g * cross A B).
      { unfold base, A, B, along, cross, minus, plus, moved_along. cbn [vx vy].
        setoid_replace (vx x - (vx (source e) + vx (source f)) + t * vx n) with
          (h * (vx (target e) - vx (source e)) + g * (vx (target f) - vx (source f))) by lra.
        setoid_replace (vy x - (vy (source e) + vy (source f)) + t * vy n) with
          (h * (vy (target e) - vy (source e)) + g * (vy (target f) - vy (source f))) by lra. ring. }
      unfold k, l, dk, dl. split; apply (Qmult_inj_r _ _ (cross A B) turn).
      - rewrite <- value_h. transitivity (cross base B + t * cross n B); [| field; exact turn].
        unfold cross, moved_along. cbn [vx vy]. ring.
      - rewrite <- value_g. transitivity (cross A base + t * cross A n); [| field; exact turn].
        unfold cross, moved_along. cbn [vx vy]. ring. }
    assert (in_range : forall c d, eventually (fun t => 0 <= c + t * d <= 1 -> 0 <= c <= 1)).
    { intros c d. destruct (Qlt_le_dec c 0) as [low |]; [| destruct (Qlt_le_dec 1 c) as [high |]].
      - refine (eventually_implied _ _ _ (eventually_positive (- c) (- d) ltac:(lra))). intros t some range. lra.
      - refine (eventually_implied _ _ _ (eventually_positive (c - 1) d ltac:(lra))). intros t some range. lra.
      - exists 1. split; [lra |]. intros. lra. }
    set (w := point_at e k). set (u := point_at f l).
    assert (sum_ : equal_vectors x (plus w u)).
    { assert (both : vx base == k * vx A + l * vx B /\ vy base == k * vy A + l * vy B)
        by (unfold k, l, cross; split; field; exact turn).
      clear - both. unfold w, u, base, A, B, point_at, along, plus, minus in *. cbn [vx vy] in *.
      split; cbn [vx vy]; lra. }
    destruct (inner_points_at_a_contact w u sum_) as (radius & R & found).
    refine (eventually_implied _ _ _ (eventually_and _ _ (eventually_below 1 ltac:(lra))
      (eventually_and _ _ (small_steps_stay_within ((1 # 2) * radius) w (Vector (dk * vx A) (dk * vy A)) ltac:(lra))
      (small_steps_stay_within ((1 # 2) * radius) u (Vector (dl * vx B) (dl * vy B)) ltac:(lra))))).
    intros t ([some _] & close_w & close_u) (v & (h & _ & VX & VY) & (g & _ & UX & UY) & _ & near).
    destruct (fractions t h g) as [h_is g_is].
    { unfold plus, point_at, minus in *. cbn [vx vy] in *. split; cbn [vx vy]; lra. }
    destruct (near ((1 # 2) * radius)) as (z & close_z & in_p & in_q); [lra |].
    apply (found z (minus (moved_along x n t) z) t); trivial.
    - assert (V : equal_vectors (moved_along w (Vector (dk * vx A) (dk * vy A)) t) v).
      { unfold w, point_at, moved_along, A, along, minus. split; cbn [vx vy]; rewrite ?VX, ?VY, h_is; ring. }
      destruct V as [V1 V2]. unfold within in *. lra.
    - assert (U : equal_vectors (moved_along u (Vector (dl * vx B) (dl * vy B)) t) (minus (moved_along x n t) v)).
      { split; [rewrite UX | rewrite UY]; unfold u, point_at, moved_along, B, along, minus; cbn [vx vy];
          rewrite g_is; ring. }
      destruct U as [U1 U2]. unfold within, minus in *. cbn [vx vy] in *. lra.
    - unfold plus, minus. split; cbn [vx vy]; ring.
  Qed.
End Contacts.

(* Theorem. *)
Theorem segment_left_of_a_step (p q : region) (x n : vector) :
  valid_region p -> valid_region q -> chains_do_not_cross p -> chains_do_not_cross q ->
  ~ interiors_meet x p q -> nonzero n -> eventually (fun t => interiors_meet (moved_along x n t) p q) ->
  exists s, In s (convolution_segments p q) /\ lies_on x s /\ 0 < cross (along s) n.
Proof.
  intros p_region q_region p_crosses_nowhere q_crosses_nowhere outside long beside.
  assert (outside' : ~ interiors_meet x q p) by (intros meet_; now apply outside, interiors_meet_other_way).
  apply (covered_to_the_right p q x n p_region q_region).
  set (result := met_to_the_right p q x n OfP \/ met_to_the_right q p x n OfQ).
  assert (of_p : eventually (fun t => forall s, In s (region_edges p) ->
    meet_near p q (moved_along x n t) (source s) -> result)).
  { apply eventually_for_all. intros s S. apply corner_at_a_vertex; trivial. now apply source_is_vertex. }
  assert (of_q : eventually (fun t => forall s, In s (region_edges q) ->
    meet_near q p (moved_along x n t) (source s) -> result)).
  { apply eventually_for_all. intros s S.
    refine (eventually_implied _ _ _ (corner_at_a_vertex q p x n OfQ q_region p_region q_crosses_nowhere
      p_crosses_nowhere outside' long (source s) (source_is_vertex q s S))).
    unfold result. cbn [other]. tauto. }
  assert (of_both : eventually (fun t => forall pair, In pair (list_prod (region_edges p) (region_edges q)) ->
    (exists v, lies_on v (fst pair) /\ lies_on (minus (moved_along x n t) v) (snd pair) /\
      ~ cross (along (fst pair)) (along (snd pair)) == 0 /\ meet_near p q (moved_along x n t) v) -> result)).
  { apply (eventually_for_all (fun pair t => (exists v, lies_on v (fst pair) /\
      lies_on (minus (moved_along x n t) v) (snd pair) /\
      ~ cross (along (fst pair)) (along (snd pair)) == 0 /\ meet_near p q (moved_along x n t) v) -> result)).
    intros [e f] I. apply in_prod_iff in I. now apply corner_where_edges_cross. }
  destruct (some_small _ (eventually_and _ _ beside (eventually_and _ _ of_p (eventually_and _ _ of_q of_both))))
    as (t & _ & meet & at_p & at_q & at_both).
  destruct (a_common_corner p q _ p_region q_region meet) as (v & near & [vertex | [vertex | crossing_]]).
  - destruct vertex as (s & S & equal). apply (at_p s S). intros radius R.
    destruct (near radius R) as (z & close & inside_). exists z. split; [| exact inside_].
    destruct equal as [X Y]. unfold within in *. lra.
  - destruct vertex as (s & S & equal). apply (at_q s S). intros radius R.
    destruct (near radius R) as (z & close & in_p & in_q). exists (minus (moved_along x n t) z).
    split; [| split; [exact in_q |]].
    + destruct equal as [X Y]. unfold within, minus in *. cbn [vx vy] in *. lra.
    + apply (inside_equal z); [unfold minus; split; cbn [vx vy]; ring | exact in_p].
  - destruct crossing_ as (e & f & E & F & on_e & on_f & _ & _ & turn).
    apply (at_both (e, f)); [now apply in_prod |]. now exists v.
Qed.
