(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Off 𝒞 and 𝒞′, the intersection of P and -Q + x has as many components as that of P and -Q + y, for all y close to x.
   Each point of the one is near one of the other: to the left of all edges there is inside both
   (contacts_that_overlap.v). And points of it that are near each other are joined in it: by a step; or by way of a
   reflex vertex of one that is near_segment (near_a_polygon.v), which is on no edge of the other, and so inside it. *)
From Coq Require Import QArith Qminmax Lqa ZArith Lia Bool List.
From Oplus Require Import convolution regions_and_sums small_numbers simple_chain replaced_segments reflected
  polygons_of_the_thesis connected_sets coordinates edges_of_polygons connected_beside_pieces points_of_the_intersection
  near_segments near_a_polygon contacts_that_overlap components_of_near_sets.
Import ListNotations.

Open Scope Q_scope.

(* The intersection of P and -Q + x. *)
Definition in_common (p q : list vector) (x z : vector) : Prop := in_region z [p] /\ in_region (minus x z) [q].

Lemma in_reflected_is (x : vector) (q : region) (z : vector) : in_reflected x q z <-> in_region (minus x z) q.
Proof.
  split.
  - intros (v & in_ & X & Y). apply (in_region_of_equal q v); [| exact in_]. unfold equal_vectors, minus in *.
    cbn [vx vy] in *. split; lra.
  - intros in_. exists (minus x z). split; [exact in_ |]. unfold equal_vectors, minus. cbn [vx vy]. split; ring.
Qed.

(* Two points of it that are near each other: one can go straight in the first polygon, or to a point in both. *)
Lemma straight_or_by_a_vertex (p q : list vector) (x : vector) : simple_polygon p ->
  (forall i, (i < length p)%nat -> reflex_at p i -> off (minus x (vertex p i)) (region_edges [q])) ->
  eventually (fun d => forall y v w, within d x y -> within d v w -> in_common p q y v -> in_common p q y w ->
    (forall m, lies_on m (Segment v w) -> in_region m [p]) \/
    exists u, forall m, lies_on m (Segment v u) \/ lies_on m (Segment w u) -> in_common p q y m).
Proof.
  intros polygon reflex_off.
  assert (all : eventually (fun r => forall i, In i (seq 0 (length p)) -> reflex_at p i ->
    (forall w m, within (2 * r) (vertex p i) w -> in_region w [p] -> lies_on m (Segment w (vertex p i)) ->
      in_region m [p]) /\
    forall g, within (3 * r) (minus x (vertex p i)) g -> off g (region_edges [q]) /\
      winding_number g (region_edges [q]) = winding_number (minus x (vertex p i)) (region_edges [q]))).
  { apply eventually_for_all. intros i I. apply in_seq in I. destruct I as [_ I].
    destruct (Qlt_le_dec (cross (along (edge_at p (previous (length p) i))) (along (edge_at p i))) 0)
      as [reflex | not_]; [| exists 1; split; [lra | intros e _ _ reflex; unfold reflex_at in reflex; lra]].
    destruct (straight_to_a_point p polygon (vertex p i)) as (r1 & R1 & straight).
    { right. exists (edge_at p i). split; [apply edge_at_in_region; [now left | exact I] |].
      rewrite edge_is by exact I. apply (source_lies_on (Segment _ _)). }
    destruct (winding_number_near _ _ (region_cycles [q]) (reflex_off i I reflex)) as (r2 & R2 & same_).
    exists ((1 # 3) * Qmin r1 r2). pose proof (Q.le_min_l r1 r2). pose proof (Q.le_min_r r1 r2).
    pose proof (Q.min_glb_lt _ _ _ R1 R2). split; [lra |]. intros e some less _. split.
    - intros w m close. apply straight. unfold within in *. lra.
    - intros g close. apply same_. unfold within in *. lra. }
  destruct (some_small _ all) as (r & R & around).
  refine (eventually_implied _ _ _ (eventually_and _ _ (near_points_are_joined p polygon r R) (eventually_below r R))).
  intros d [joined [some less]] y v w close_y close in_v in_w.
  destruct (joined v w close (proj1 in_v) (proj1 in_w)) as [(i & I & reflex & close_v) | straight]; [right | now left].
  destruct (around i ltac:(apply in_seq; lia) reflex) as [to_it same_]. exists (vertex p i).
  assert (ways : forall s m, in_common p q y s -> within (2 * r) (vertex p i) s -> lies_on m (Segment s (vertex p i)) ->
    in_common p q y m).
  { intros s m [in_p in_q] close_s on. split; [exact (to_it s m close_s in_p on) |].
    assert (close_m : within (2 * r) (vertex p i) m)
      by (apply (within_along (2 * r) (vertex p i) s (vertex p i)); trivial; unfold within; lra).
    destruct (same_ (minus y s)) as [free_s number_s]; [unfold within, minus in *; cbn [vx vy]; lra |].
    destruct (same_ (minus y m)) as [_ number_m]; [unfold within, minus in *; cbn [vx vy]; lra |].
    left. rewrite number_m, <- number_s. destruct in_q as [round | (f & F & on_f)]; [exact round |].
    destruct (free_s f F on_f). }
  intros m [on | on]; [apply (ways v) | apply (ways w)]; trivial; unfold within in *; lra.
Qed.

Section TwoPolygons.
  Variables p q : list vector.
  Hypothesis p_polygon : simple_polygon p.
  Hypothesis q_polygon : simple_polygon q.
  Variable x : vector.
  Hypothesis free : off x (convolution_segments [p] [q]).
  Hypothesis free' : off x (original_convolution [p] [q]).

  Lemma back_again (y z : vector) : equal_vectors (minus y (minus y z)) z.
  Proof. unfold equal_vectors, minus. cbn [vx vy]. split; ring. Qed.

  Lemma in_common_other_way (y z : vector) : in_common p q y z -> in_common q p y (minus y z).
  Proof.
    intros [in_p in_q]. split; [exact in_q |]. apply (in_region_of_equal [p] z); [| exact in_p].
    symmetry. apply back_again.
  Qed.

  Lemma lies_on_other_way (y m a b : vector) : lies_on m (Segment a b) ->
    lies_on (minus y m) (Segment (minus y a) (minus y b)).
  Proof.
    intros (k & range & X & Y). exists k. cbn [source target] in *. unfold minus. cbn [vx vy]. rewrite X, Y.
    split; [exact range | split; ring].
  Qed.

  Lemma near_points_of_it_are_joined :
    eventually (fun d => forall y, within d x y -> joined_when_near d (in_common p q y)).
  Proof.
    refine (eventually_implied _ _ _ (eventually_and _ _
      (straight_or_by_a_vertex p q x p_polygon (reflex_of_p_is_off p q x free free'))
      (straight_or_by_a_vertex q p x q_polygon (reflex_of_q_is_off p q x free free')))).
    intros d [in_p in_q] y close_y v w close in_v in_w.
    destruct (in_p y v w close_y close in_v in_w) as [straight | (u & ways)].
    2:{ apply (connected_on _ _ u); [| apply connected_back]; apply connected_by_a_step; auto. }
    destruct (in_q y (minus y v) (minus y w) close_y) as [straight' | (u & ways)].
    - unfold within, minus in *. cbn [vx vy]. lra.
    - now apply in_common_other_way.
    - now apply in_common_other_way.
    - apply connected_by_a_step. intros m on. split; [now apply straight |]. now apply straight', lies_on_other_way.
    - assert (step : forall s, s = v \/ s = w -> connected_in (in_common p q y) s (minus y u)).
      { intros s which. apply connected_by_a_step. intros m on.
        destruct (ways (minus y m)) as [one two].
        { apply (lies_on_other_way y) in on. destruct on as (k & range & X & Y). cbn [source target] in X, Y.
          assert (on_u : lies_on (minus y m) (Segment (minus y s) u)).
          { exists k. cbn [source target]. destruct (back_again y u) as [ux uy]. rewrite ux in X. rewrite uy in Y.
            split; [exact range | now split]. }
          destruct which as [-> | ->]; [now left | now right]. }
        split; [| exact one]. apply (in_region_of_equal [p] (minus y (minus y m))); [apply back_again | exact two]. }
      apply (connected_on _ _ (minus y u)); [| apply connected_back]; apply step; tauto.
  Qed.

  Lemma near_each_point_is_one (radius : Q) : 0 < radius -> eventually (fun e => forall y y', within e x y ->
    within e x y' -> comes_near radius (in_common p q y) (in_common p q y')).
  Proof.
    intros R. set (l := region_edges [p] ++ map (reflected x) (region_edges [q])).
    assert (long : forall s, In s l -> nonzero (along s)).
    { intros s S. apply in_app_iff in S. destruct S as [S | S]; [exact (polygon_edges_are_long p p_polygon s S) |].
      apply in_map_iff in S. destruct S as (f & <- & F). pose proof (polygon_edges_are_long q q_polygon f F) as some.
      intros [X Y]. apply some. unfold reflected, along, minus in *. cbn [source target vx vy] in *. split; lra. }
    destruct (some_small _ (directions_to_the_left l long
      (left_of_all_edges_there p q p_polygon q_polygon x free free'))) as (n & N & directions).
    destruct (sizes_are_bounded (l ++ region_edges [q])) as (most & most_some & sizes).
    assert (share : n / most * most == n) by (field; lra).
    assert (r_some : 0 < n / most) by (apply Qlt_shift_div_l; lra). set (r := n / most) in *. clearbody r.
    set (t := Qmin radius ((1 # 2) * r)).
    pose proof (Q.le_min_l radius ((1 # 2) * r) : t <= radius).
    pose proof (Q.le_min_r radius ((1 # 2) * r) : t <= (1 # 2) * r).
    assert (t_some : 0 < t) by (apply Q.min_glb_lt; lra).
    refine (eventually_implied _ _ _ (eventually_and _ _ (eventually_below ((1 # 6) * r) ltac:(lra))
      (eventually_positive (t * (n * n)) (- (2 * most)) (Qmult_lt_0_compat _ _ t_some (Qmult_lt_0_compat _ _ N N))))).
    intros e [[e_some e_few] slow] y y' close close' z [in_p in_q]. destruct (directions z) as (u & one & left_).
    assert (push : forall s, In s l -> forall v, lies_on v s -> within r v z -> n * n <= cross (along s) u).
    { intros s S v on close_v. apply (left_ s S).
      apply (nearer (r * size (along s))); [| now apply (close_is_near s z v)].
      specialize (sizes s ltac:(apply in_app_iff; now left)). nra. }
    set (z' := moved_along z u t). exists z'.
    assert (tu : - t < t * vx u < t /\ - t < t * vy u < t)
      by (unfold at_most_one, within, nowhere in one; cbn [vx vy] in one; split; nra).
    split; [split |].
    - apply (going_left_stays p p_polygon z z' in_p). intros k s range S on.
      assert (value : cross (along s) (minus z' z) == t * cross (along s) u) by (unfold z'; by_computing).
      rewrite value. apply Qmult_le_0_compat; [lra |]. apply Qle_trans with (n * n); [nra |].
      apply (push s ltac:(apply in_app_iff; now left) _ on). unfold within, z', moved_along, minus. cbn [vx vy].
      split; nra.
    - apply (going_left_stays q q_polygon (minus y z) (minus y' z') in_q). intros k f range F on.
      set (d := minus (minus y' z') (minus y z)) in *.
      assert (d_is : vx d == vx y' - vx y - t * vx u /\ vy d == vy y' - vy y - t * vy u)
        by (unfold d, z', minus, moved_along; cbn [vx vy]; split; ring).
      assert (pushed : n * n <= cross (along (reflected x f)) u).
      { apply (push (reflected x f) ltac:(apply in_app_iff; right; now apply in_map)
          (minus x (moved_along (minus y z) d k))).
        - apply on_reflected, (lies_on_equal (moved_along (minus y z) d k)); [symmetry; apply back_again | exact on].
        - assert (d_few : - (2 * e + t) < vx d < 2 * e + t /\ - (2 * e + t) < vy d < 2 * e + t)
            by (destruct d_is as [dx dy]; rewrite dx, dy; unfold within in *; lra).
          destruct d_few as [dx dy]. clearbody d z'. unfold within, moved_along, minus in *. cbn [vx vy] in *.
          split; nra. }
      assert (value : cross (along f) d == cross (along f) (minus y' y) + t * cross (along (reflected x f)) u).
      { destruct d_is as [dx dy]. unfold cross at 1. rewrite dx, dy. by_computing. }
      rewrite value. assert (few : size (along f) <= most) by (apply sizes, in_app_iff; now right).
      assert (slow_ : - (2 * e * size (along f)) <= cross (along f) (minus y' y)).
      { assert (apart_x : - (2 * e) < vx y' - vx y < 2 * e) by (unfold within in *; lra).
        assert (apart_y : - (2 * e) < vy y' - vy y < 2 * e) by (unfold within in *; lra).
        pose proof (product_bounds _ (vy (along f)) _ apart_x). pose proof (product_bounds _ (vx (along f)) _ apart_y).
        unfold size, cross, minus at 1, minus at 1. cbn [vx vy]. lra. }
      assert (2 * e * size (along f) <= 2 * e * most) by nra.
      assert (t * (n * n) <= t * cross (along (reflected x f)) u) by nra. lra.
    - unfold within, z', moved_along. cbn [vx vy]. lra.
  Qed.

  (* Theorem. *)
  Theorem components_stay : exists radius, 0 < radius /\ forall y k, within radius x y ->
    has_components (in_common p q y) k -> has_components (in_common p q x) k.
  Proof.
    destruct (some_small _ near_points_of_it_are_joined) as (d & D & joined).
    set (c := (1 # 4) * d). assert (c_some : 0 < c) by (unfold c; lra).
    destruct (some_small _ (eventually_and _ _ (near_each_point_is_one c c_some) (eventually_below d D)))
      as (e & E & close & _ & less).
    assert (at_x : forall r, 0 < r -> within r x x) by (intros r some; unfold within; lra).
    assert (joined' : forall y, within e x y -> joined_when_near (4 * c) (in_common p q y)).
    { intros y close_y v w close_v. apply (joined y); unfold within, c in *; lra. }
    exists e. split; [exact E |]. intros y k close_y.
    apply (near_sets_have_as_many_components (in_common p q y) (in_common p q x) c k c_some); auto.
  Qed.
End TwoPolygons.
