(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Off 𝒞 and 𝒞′, the intersection of P and -Q + x has as many components as that of P and -Q + y, for all y close to x.
   At each point z some step leads to the left of all edges near z (contacts_that_overlap.v, near_segments.v). So does
   one that is a little different: from points close to z, or into the intersection for another y. Such steps do not
   leave the polygons (leaving_a_polygon.v). So close to each point of one intersection is one of the other; and points
   of one that are close to each other are joined: by a step each, and one beside the way between the two. *)
From Coq Require Import QArith Qminmax Lqa ZArith List.
From Oplus Require Import convolution regions_and_sums small_numbers replaced_segments reflected polygons_of_the_thesis
  connected_sets coordinates edges_of_polygons connected_beside_pieces points_of_the_intersection near_segments
  leaving_a_polygon contacts_that_overlap components_of_near_sets.
Import ListNotations.

Open Scope Q_scope.

(* The intersection of P and -Q + x. *)
Definition in_common (p q : list vector) (x z : vector) : Prop := in_region z [p] /\ in_region (minus x z) [q].

Lemma in_common_of_equal (p q : list vector) (x v w : vector) : equal_vectors v w -> in_common p q x v ->
  in_common p q x w.
Proof.
  intros equal [in_p in_q]. split; [now apply (in_region_of_equal _ v) |].
  apply (in_region_of_equal _ (minus x v)); [| exact in_q]. destruct equal as [X Y].
  unfold equal_vectors, minus. cbn [vx vy]. rewrite X, Y. split; reflexivity.
Qed.

Lemma in_reflected_is (x : vector) (q : region) (z : vector) : in_reflected x q z <-> in_region (minus x z) q.
Proof.
  split.
  - intros (v & in_ & X & Y). apply (in_region_of_equal q v); [| exact in_]. unfold equal_vectors, minus in *.
    cbn [vx vy] in *. split; lra.
  - intros in_. exists (minus x z). split; [exact in_ |]. unfold equal_vectors, minus. cbn [vx vy]. split; ring.
Qed.

Section TwoPolygons.
  Variables p q : list vector.
  Hypothesis p_polygon : simple_polygon p.
  Hypothesis q_polygon : simple_polygon q.
  Variable x : vector.
  Hypothesis free : off x (convolution_segments [p] [q]).
  Hypothesis free' : off x (original_convolution [p] [q]).

  (* At z, a step u inwards. From a point of the intersection close to z all of it is inside; and so is where it leads
     to from other points close to z, and that for another y. *)
  Lemma steps_inwards (radius : Q) : 0 < radius -> eventually (fun e => forall z, exists u, within radius nowhere u /\
    forall y y' v w k, within e x y -> within e x y' -> within e z v -> within e z w -> 0 <= k <= 1 ->
      k = 1 \/ y = y' /\ v = w -> in_common p q y v -> in_common p q y' (moved_along w u k)).
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
    refine (eventually_implied _ _ _ (eventually_and _ _ (eventually_below ((1 # 12) * r) ltac:(lra))
      (eventually_positive (t * (n * n)) (- (4 * most)) (Qmult_lt_0_compat _ _ t_some (Qmult_lt_0_compat _ _ N N))))).
    intros e [[e_some e_few] slow] z. destruct (directions z) as (u & one & left_).
    assert (tu : - t < t * vx u < t /\ - t < t * vy u < t)
      by (unfold at_most_one, within, nowhere in one; cbn [vx vy] in one; split; nra).
    exists (moved_along nowhere u t). split; [unfold within, moved_along, nowhere; cbn [vx vy]; lra |].
    intros y y' v w k close close' close_v close_w range which [in_p in_q].
    assert (pushed : forall s c, In s l -> lies_on c s -> within r c z -> n * n <= cross (along s) u).
    { intros s c S on close_c. apply (left_ s S).
      apply (nearer (r * size (along s))); [| now apply (close_is_near s z c)].
      specialize (sizes s ltac:(apply in_app_iff; now left)). nra. }
    assert (enough_ : forall s m turn, In s (l ++ region_edges [q]) -> within (4 * e) nowhere m ->
      k = 1 \/ vx m == 0 /\ vy m == 0 -> n * n <= turn -> 0 <= cross (along s) m + k * (t * turn)).
    { intros s m turn S [mx my] small high. specialize (sizes s S). unfold nowhere in mx, my. cbn [vx vy] in mx, my.
      assert (t * (n * n) <= t * turn) by (apply Qmult_le_l; assumption). destruct small as [-> | [X Y]].
      - pose proof (product_bounds (vx m) (vy (along s)) (4 * e) ltac:(lra)).
        pose proof (product_bounds (vy m) (vx (along s)) (4 * e) ltac:(lra)).
        assert (e * size (along s) <= e * most) by (apply Qmult_le_l; assumption). unfold size, cross in *. lra.
      - unfold cross. rewrite X, Y. assert (0 <= k * (t * turn)) by (apply Qmult_le_0_compat; nra). lra. }
    assert (part : forall b h a, 0 <= h <= 1 -> - b < a < b -> - b < h * a < b).
    { intros b h a h_range [low high]. pose proof (mixed_is_less h 0 a b h_range ltac:(lra) high).
      pose proof (mixed_is_more h 0 a (- b) h_range ltac:(lra) low). split; lra. }
    split.
    - set (m := minus w v). assert (small : k = 1 \/ vx m == 0 /\ vy m == 0).
      { destruct which as [one_ | [_ <-]]; [now left | right]. unfold m, minus. cbn [vx vy]. split; ring. }
      apply (going_left_stays p p_polygon v _ in_p). intros j s j_range S on.
      assert (value : forall b, cross b (minus (moved_along w (moved_along nowhere u t) k) v) ==
        cross b m + k * (t * cross b u)) by (intros b; unfold m, nowhere; by_computing).
      rewrite value. apply enough_; trivial; [do 2 (apply in_app_iff; left); exact S | |].
      + unfold within, m, minus, nowhere in *. cbn [vx vy]. lra.
      + apply (pushed s _ ltac:(apply in_app_iff; now left) on).
        pose proof (part (2 * e) j (vx w - vx v) j_range ltac:(unfold within in *; lra)).
        pose proof (part (2 * e) j (vy w - vy v) j_range ltac:(unfold within in *; lra)).
        pose proof (part _ j _ j_range (part _ k _ range (proj1 tu))).
        pose proof (part _ j _ j_range (part _ k _ range (proj2 tu))).
        unfold within, moved_along, minus, nowhere in *. cbn [vx vy] in *. lra.
    - set (m := minus (minus y' y) (minus w v)). assert (small : k = 1 \/ vx m == 0 /\ vy m == 0).
      { destruct which as [one_ | [<- <-]]; [now left | right]. unfold m, minus. cbn [vx vy]. split; ring. }
      apply (going_left_stays q q_polygon (minus y v) _ in_q). intros j f j_range F on.
      assert (value : cross (along f) (minus (minus y' (moved_along w (moved_along nowhere u t) k)) (minus y v)) ==
        cross (along f) m + k * (t * cross (along (reflected x f)) u)) by (unfold m, nowhere; by_computing).
      rewrite value. apply enough_; trivial; [apply in_app_iff; now right | |].
      + unfold within, m, minus, nowhere in *. cbn [vx vy]. lra.
      + set (c := moved_along (minus y v) _ j) in on. apply (pushed (reflected x f) (minus x c)).
        * apply in_app_iff. right. now apply in_map.
        * apply on_reflected, (lies_on_equal c); [| exact on]. unfold equal_vectors, minus. cbn [vx vy]. split; ring.
        * pose proof (part (4 * e) j (vx m) j_range ltac:(unfold m, within, minus in *; cbn [vx vy]; lra)) as part_x.
          pose proof (part (4 * e) j (vy m) j_range ltac:(unfold m, within, minus in *; cbn [vx vy]; lra)) as part_y.
          pose proof (part _ j _ j_range (part _ k _ range (proj1 tu))).
          pose proof (part _ j _ j_range (part _ k _ range (proj2 tu))).
          unfold m, c, within, moved_along, minus, nowhere in *. cbn [vx vy] in *. lra.
  Qed.

  Lemma near_points_of_it_are_joined :
    eventually (fun d => forall y, within d x y -> joined_when_near d (in_common p q y)).
  Proof.
    refine (eventually_implied _ _ _ (eventually_and _ _ (steps_inwards 1 ltac:(lra)) (eventually_below 1 ltac:(lra)))).
    intros d [inwards [some _]] y close v w close_w in_v in_w. destruct (inwards v) as (u & _ & step).
    assert (close_v : within d v v) by (unfold within; lra).
    assert (out : forall s, within d v s -> in_common p q y s -> connected_in (in_common p q y) s (moved_along s u 1)).
    { intros s close_s in_s. apply connected_by_a_step. intros z (k & range & X & Y). cbn [source target] in X, Y.
      apply (in_common_of_equal p q y (moved_along s u k)).
      - unfold equal_vectors, moved_along in *. cbn [vx vy] in *. rewrite X, Y. split; ring.
      - apply (step y y s s k); auto. }
    apply (connected_on _ _ _ _ (out v close_v in_v)), connected_back, (connected_on _ _ _ _ (out w close_w in_w)).
    apply connected_by_a_step. intros z (k & range & X & Y). cbn [source target] in X, Y.
    set (m := moved_along w (minus v w) k).
    apply (in_common_of_equal p q y (moved_along m u 1)).
    - unfold m, equal_vectors, moved_along, minus in *. cbn [vx vy] in *. rewrite X, Y. split; ring.
    - apply (step y y v m 1); auto; [| lra]. apply (within_along d v w v m close_w close_v). exists k.
      unfold m, moved_along, minus. cbn [source target vx vy]. split; [exact range | split; ring].
  Qed.

  Lemma near_each_point_is_one (radius : Q) : 0 < radius -> eventually (fun e => forall y y', within e x y ->
    within e x y' -> comes_near radius (in_common p q y) (in_common p q y')).
  Proof.
    intros R. refine (eventually_implied _ _ _ (eventually_and _ _ (steps_inwards radius R)
      (eventually_below 1 ltac:(lra)))).
    intros e [inwards [some _]] y y' close close' z in_z. destruct (inwards z) as (u & few & step).
    assert (close_z : within e z z) by (unfold within; lra).
    exists (moved_along z u 1). split; [apply (step y y' z z 1); auto; lra |].
    unfold within, moved_along, nowhere in *. cbn [vx vy] in *. lra.
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
