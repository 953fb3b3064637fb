(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Going straight on in a simple polygon, one leaves it only to the right of an edge: near a point of the boundary all
   that is to the left of the edges there is inside. So points of a polygon that are near each other can be joined by a
   step, if no reflex vertex is near; and points near a vertex can be joined with it. *)
From Coq Require Import QArith Qminmax Lqa ZArith Lia Bool List.
From Oplus Require Import convolution regions_and_sums small_numbers simple_chain boundary_points inside_a_corner
  edges_at_a_point fans_that_touch polygons_of_the_thesis coordinates filling edges_of_polygons
  points_of_the_intersection first_on_the_way near_segments.
Import ListNotations.

Open Scope Q_scope.

Lemma left_of_both (a b : vector) : turns a b -> exists n, 0 < cross a n /\ 0 < cross b n.
Proof.
  intros (long_a & long_b & ahead). destruct (Q_dec (cross a b) 0) as [[right_ | left_] | flat].
  - exists (minus a b). unfold cross, minus in *. cbn [vx vy]. split; lra.
  - exists (minus b a). unfold cross, minus in *. cbn [vx vy]. split; lra.
  - specialize (ahead flat). pose proof (square_positive a long_a). exists (Vector (- vy a) (vx a)).
    unfold cross, dot in *. cbn [vx vy]. split; lra.
Qed.

Lemma in_region_dec (z : vector) (r : region) : in_region z r \/ ~ in_region z r.
Proof.
  destruct (on_or_off z (region_edges r)) as [on | free]; [left; now right |].
  destruct (Z_lt_le_dec 0 (winding_number z (region_edges r))) as [some | none]; [left; now left | right].
  intros [some | (s & S & on)]; [lia | exact (free s S on)].
Qed.

Lemma within_dec (radius : Q) (v w : vector) : {within radius v w} + {~ within radius v w}.
Proof.
  unfold within. destruct (Qlt_le_dec (- radius) (vx w - vx v)); [| right; lra].
  destruct (Qlt_le_dec (vx w - vx v) radius); [| right; lra].
  destruct (Qlt_le_dec (- radius) (vy w - vy v)); [| right; lra].
  destruct (Qlt_le_dec (vy w - vy v) radius); [left; lra | right; lra].
Qed.

Section OnePolygon.
  Variable c : list vector.
  Hypothesis polygon : simple_polygon c.
  Let n := length c.
  Let boundary := region_edges [c].
  Let c_region := simple_polygons_are_regions c polygon.

  Definition reflex_at (i : nat) : Prop := cross (along (edge_at c (previous n i))) (along (edge_at c i)) < 0.

  (* Of the edges at a point of the boundary there are one or two. *)
  Lemma edges_there (z : vector) : (exists e, In e boundary /\ lies_on z e) ->
    exists s t, In s boundary /\ In t boundary /\ lies_on z s /\ lies_on z t /\
      (forall e, In e boundary -> lies_on z e -> e = s \/ e = t) /\ turns (along s) (along t) /\
      (s = t /\ ~ is_vertex z [c] \/
       exists i, (i < n)%nat /\ equal_vectors z (vertex c i) /\ s = edge_at c (previous n i) /\ t = edge_at c i /\
         meet_in_vertex s t [c]).
  Proof.
    intros (e & E & on). destruct (vertex_or_not z [c]) as [(u & U & at_u) | no_vertex].
    - destruct (edges_of_one c u U) as (i & I & -> & source_is & _). rewrite source_is in at_u. fold n in I.
      pose proof (simple_polygons_do_not_touch c polygon c i (or_introl eq_refl) I) as meet. fold n in meet.
      set (s := edge_at c (previous n i)) in *. set (t := edge_at c i) in *.
      pose proof meet as (S & T & ends_ & only). exists s, t. rewrite source_is in ends_, only.
      split; [exact S |]. split; [exact T |]. split; [| split; [| split; [| split]]].
      + apply (lies_on_equal (target s)); [rewrite ends_; now symmetry | apply target_lies_on].
      + apply (lies_on_equal (source t)); [rewrite source_is; now symmetry | apply source_lies_on].
      + intros f F on_f. apply (only f F). now apply (lies_on_equal z).
      + apply (consecutive_edges_turn [c]); trivial. now rewrite source_is.
      + right. exists i. exact (conj I (conj at_u (conj eq_refl (conj eq_refl meet)))).
    - assert (long : nonzero (along e)) by (exact (polygon_edges_are_long c polygon e E)).
      exists e, e. do 4 (split; [assumption |]). split; [| split; [| left; now split]].
      + intros f F on_f. left. destruct (edges_of_one c e E) as (i & I & -> & _).
        destruct (edges_of_one c f F) as (j & J & -> & _). f_equal. symmetry.
        apply (inside_one_edge c polygon i j z I J); [| exact on_f].
        destruct (inside_or_end z _ on) as [inside_ | [equal | equal]]; [exact inside_ | exfalso | exfalso];
          apply no_vertex.
        * exists (edge_at c i). split; [exact E | now symmetry].
        * apply (vertex_of_equal (target (edge_at c i))); [exact equal |]. now apply target_is_vertex.
      + split; [exact long |]. split; [exact long |]. intros _. now apply square_positive.
  Qed.

  (* Near it, all that is to the left of all edges there is inside. *)
  Lemma left_of_the_edges_is_inside (z : vector) : (exists e, In e boundary /\ lies_on z e) ->
    exists radius, 0 < radius /\ forall y, within radius z y ->
      (forall e, In e boundary -> lies_on z e -> 0 < cross (along e) (minus y z)) -> inside y [c].
  Proof.
    intros on. destruct (edges_there z on) as (s & t & S & T & on_s & on_t & only & (long_s & long_t & _) &
      [[<- no_vertex] | (i & I & at_z & _ & t_is & meet)]).
    - destruct (fills_left_beside_an_edge [c] s z c_region S on_s no_vertex) as (radius & R & fills).
      exists radius. split; [exact R |]. intros y close left_. apply fills; [exact close | now apply left_].
    - assert (z_is : equal_vectors z (source t)) by (rewrite t_is, edge_is by exact I; exact at_z).
      destruct (Qlt_le_dec 0 (cross (along s) (along t))) as [convex_ | not_convex].
      + destruct (some_square z [c]) as (radius & R & near_). exists radius. split; [exact R |]. intros y close left_.
        assert (free : forall w, within radius z w -> 0 < cross (along s) (minus w z) ->
          0 < cross (along t) (minus w z) -> off w boundary).
        { intros w close_w left_s left_t f F on_w.
          destruct (near_ f) as [on_f | away]; [| | exact (away w close_w on_w)].
          - apply in_flat_map. exists f. split; [exact F | now left].
          - pose proof (area_from z w f on_f). pose proof (on_the_line w f on_w).
            destruct (only f F on_f) as [-> | ->]; lra. }
        destruct (no_vertex_near [c] t z ((1 # 2) * radius) long_t on_t) as (m & close_m & on_m & no_vertex); [lra |].
        pose proof (left_normal t long_t) as left_n. set (k := Vector (- vy (along t)) (vx (along t))) in *.
        assert (ahead : 0 < cross (along s) (minus m z)).
        { destruct on_m as (h & range & X & Y). destruct (Qlt_le_dec 0 h) as [some | none].
          - assert (value : cross (along s) (minus m z) == h * cross (along s) (along t)).
            { destruct z_is as [zx zy]. unfold cross, along, minus. cbn [vx vy]. rewrite X, Y, zx, zy. ring. }
            rewrite value. now apply Qmult_lt_0_compat.
          - exfalso. apply no_vertex. exists t. split; [exact T |]. assert (h_is : h == 0) by lra.
            rewrite h_is in X, Y. split; lra. }
        destruct c_region as (_ & valid & meets).
        destruct (some_small _ (eventually_and _ _ (left_of_an_edge_is_inside [c] t m k valid meets T on_m no_vertex
          left_n) (eventually_and _ _ (small_steps_stay_within ((1 # 2) * radius) m k ltac:(lra))
          (eventually_positive _ (cross (along s) k) ahead)))) as (e & some & [off_start round] & near_start & left_s).
        set (start := moved_along m k e) in *.
        assert (left_s' : 0 < cross (along s) (minus start z)).
        { setoid_replace (cross (along s) (minus start z)) with (cross (along s) (minus m z) + e * cross (along s) k)
            by (unfold start; by_coordinates). exact left_s. }
        assert (left_t' : 0 < cross (along t) (minus start z)).
        { rewrite <- (area_from z start t on_t). setoid_replace (area t start) with (area t m + e * cross (along t) k)
            by (unfold start; by_coordinates). rewrite (on_the_line m t on_m).
          pose proof (Qmult_lt_0_compat _ _ some left_n). lra. }
        assert (between_ : forall f w, lies_on w (Segment start y) -> 0 < cross f (minus start z) ->
          0 < cross f (minus y z) -> 0 < cross f (minus w z)).
        { intros f w (h & range & X & Y) at_start at_y. cbn [source target] in X, Y.
          setoid_replace (cross f (minus w z)) with ((1 - h) * cross f (minus start z) + h * cross f (minus y z))
            by (unfold cross, minus; cbn [vx vy]; rewrite X, Y; ring).
          now apply mixed_is_more. }
        assert (free_way : forall w, lies_on w (Segment start y) -> off w boundary).
        { intros w on_w. apply free.
          - apply (within_along radius z start y w); trivial.
            apply (within_twice ((1 # 2) * radius) ((1 # 2) * radius) radius z m); trivial. lra.
          - apply (between_ _ w on_w left_s'). now apply left_.
          - apply (between_ _ w on_w left_t'). now apply left_. }
        split; [apply free_way, (target_lies_on (Segment start y)) |].
        pose proof (winding_number_along (Segment start y) _ (region_cycles [c]) free_way) as same_number.
        cbn [source target] in same_number. fold boundary in round |- *. unfold boundary in *. lia.
      + destruct (fills_left_at_a_vertex [c] s t c_region meet not_convex) as [_ (radius & R & fills)].
        exists radius. split; [exact R |]. intros y close left_. specialize (left_ t T on_t).
        destruct z_is as [zx zy]. apply fills.
        * unfold within in *. rewrite <- zx, <- zy. exact close.
        * unfold cross, minus in *. cbn [vx vy] in *. rewrite <- zx, <- zy. exact left_.
  Qed.

  Lemma left_of_the_edges_there (z : vector) :
    exists u, forall e, In e boundary -> lies_on z e -> 0 < cross (along e) u.
  Proof.
    destruct (on_or_off z boundary) as [on | free]; [| exists nowhere; intros e E on; destruct (free e E on)].
    destruct (edges_there z on) as (s & t & _ & _ & _ & _ & only & turn & _).
    destruct (left_of_both _ _ turn) as (u & left_s & left_t). exists u. intros e E on_e.
    now destruct (only e E on_e) as [-> | ->].
  Qed.

  (* What leads outside is to the right of an edge. *)
  Lemma outwards_is_right (z d : vector) (limit : Q) : (exists e, In e boundary /\ lies_on z e) -> 0 < limit ->
    (forall j, 0 < j -> j <= limit -> ~ in_region (moved_along z d j) [c]) ->
    exists e, In e boundary /\ lies_on z e /\ cross (along e) d < 0.
  Proof.
    intros on some out.
    destruct (one_or_all (exists e, In e boundary /\ lies_on z e /\ cross (along e) d < 0)
      (fun e => lies_on z e -> 0 <= cross (along e) d) boundary) as [found | left_]; [| exact found | exfalso].
    { intros e E. destruct (lies_on_dec z e) as [on_e |]; [| right; contradiction].
      destruct (Qlt_le_dec (cross (along e) d) 0); [left; now exists e | now right]. }
    destruct (left_of_the_edges_is_inside z on) as (radius & R & fills), (left_of_the_edges_there z) as (u & strictly).
    destruct (some_small _ (eventually_and _ _ (small_steps_stay_within ((1 # 2) * radius) z d ltac:(lra))
      (eventually_below limit some))) as (j & J & close & _ & less).
    set (y := moved_along z d j) in *. specialize (out j J ltac:(lra)). fold y in out.
    assert (free : off y boundary) by (intros e E on_e; apply out; right; now exists e).
    destruct (winding_number_near y boundary (region_cycles _) free) as (around & A & same_).
    destruct (some_small _ (eventually_and _ _ (small_steps_stay_within around y u A)
      (small_steps_stay_within ((1 # 2) * radius) y u ltac:(lra)))) as (k & K & close' & close'').
    apply out. left. fold boundary. rewrite <- (proj2 (same_ _ close')). apply fills.
    - apply (within_twice ((1 # 2) * radius) ((1 # 2) * radius) radius z y); trivial. lra.
    - intros e E on_e. pose proof (left_ e E on_e). pose proof (strictly e E on_e).
      setoid_replace (cross (along e) (minus (moved_along y u k) z))
        with (j * cross (along e) d + k * cross (along e) u) by (unfold y; by_coordinates).
      assert (0 < k * cross (along e) u) by now apply Qmult_lt_0_compat.
      assert (0 <= j * cross (along e) d) by (apply Qmult_le_0_compat; lra). lra.
  Qed.

  (* Theorem. Who goes out passes an edge to its right. *)
  Theorem leaving_to_the_right (z m : vector) : in_region z [c] -> ~ in_region m [c] ->
    exists k e, 0 <= k < 1 /\ In e boundary /\ lies_on (moved_along z (minus m z) k) e /\
      cross (along e) (minus m z) < 0 /\ forall j, k < j <= 1 -> ~ in_region (moved_along z (minus m z) j) [c].
  Proof.
    intros in_ out. set (u := minus z m).
    assert (free : off m boundary) by (intros e E on; apply out; right; now exists e).
    assert (none : winding_number m boundary = 0%Z).
    { destruct (simple_polygons_go_round_once c m polygon free) as [none | one]; [exact none |].
      destruct out. left. fold boundary in one |- *. lia. }
    assert (out_there : forall j, 0 <= j -> (forall i, 0 <= i -> i <= j -> off (moved_along m u i) boundary) ->
      ~ in_region (moved_along m u j) [c]).
    { intros j low free_ [some | (e & E & on)]; [| exact (free_ j low ltac:(lra) e E on)].
      rewrite (number_on_the_way m u _ j (region_cycles _) low free_) in some. fold boundary in some. lia. }
    destruct (first_on_the_way m u boundary) as [all | (k & t & T & [range on] & before)].
    - destruct (out_there 1 ltac:(lra) (fun i low high => all i (conj low high))).
      apply (in_region_of_equal [c] z); [| exact in_]. unfold equal_vectors, moved_along, u, minus. cbn [vx vy].
      split; ring.
    - assert (k_some : 0 < k).
      { apply Qnot_le_lt. intros less. apply (free t T). apply (lies_on_equal (moved_along m u k)); [| exact on].
        assert (k_is : k == 0) by lra. unfold equal_vectors, moved_along. cbn [vx vy]. rewrite k_is. split; ring. }
      destruct (outwards_is_right (moved_along m u k) (minus m z) k) as (e & E & on_e & right_); trivial.
      + now exists t.
      + intros j some less in_j. apply (out_there (k - j)); [lra | intros i low high; apply before; lra |].
        apply (in_region_of_equal [c] (moved_along (moved_along m u k) (minus m z) j)); [| exact in_j].
        unfold equal_vectors, moved_along, u, minus. cbn [vx vy]. split; ring.
      + exists (1 - k), e. split; [lra |]. split; [exact E |]. split; [| split; [exact right_ |]].
        * apply (lies_on_equal (moved_along m u k)); [| exact on_e].
          unfold equal_vectors, moved_along, u, minus. cbn [vx vy]. split; ring.
        * intros j far in_j. apply (out_there (1 - j)); [lra | intros i low high; apply before; lra |].
          apply (in_region_of_equal [c] (moved_along z (minus m z) j)); [| exact in_j].
          unfold equal_vectors, moved_along, u, minus. cbn [vx vy]. split; ring.
  Qed.

  (* So nobody does who goes to the left of all edges on the way, or along them. *)
  Corollary going_left_stays (z m : vector) : in_region z [c] ->
    (forall k e, 0 <= k <= 1 -> In e boundary -> lies_on (moved_along z (minus m z) k) e ->
      0 <= cross (along e) (minus m z)) -> in_region m [c].
  Proof.
    intros in_ left_. destruct (in_region_dec m [c]) as [| out]; [assumption | exfalso].
    destruct (leaving_to_the_right z m in_ out) as (k & e & range & E & on & right_ & _).
    specialize (left_ k e ltac:(lra) E on). lra.
  Qed.

  (* Near a point of the polygon, one goes straight to it. *)
  Lemma straight_to_a_point (v : vector) : in_region v [c] -> exists radius, 0 < radius /\
    forall w m, within radius v w -> in_region w [c] -> lies_on m (Segment w v) -> in_region m [c].
  Proof.
    intros in_v. destruct (some_square v [c]) as (radius & R & near_). exists radius. split; [exact R |].
    intros w m close in_w (g & range & X & Y). cbn [source target] in X, Y.
    destruct (in_region_dec m [c]) as [| out]; [assumption | exfalso].
    destruct (leaving_to_the_right w m in_w out) as (h & e & range' & E & on & right_ & _).
    set (p := moved_along w (minus m w) h) in *.
    assert (p_is : vx p == (1 - g * h) * vx w + g * h * vx v /\ vy p == (1 - g * h) * vy w + g * h * vy v)
      by (unfold p, moved_along, minus; cbn [vx vy]; rewrite X, Y; split; ring).
    destruct p_is as [px py].
    assert (close_p : within radius v p).
    { apply (within_along radius v w v p close); [unfold within; lra |]. exists (g * h). cbn [source target].
      split; [split; nra | now split]. }
    destruct (near_ e) as [on_v | away]; [| | exact (away p close_p on)].
    - apply in_flat_map. exists e. split; [exact E | now left].
    - pose proof (on_the_line p e on) as line. rewrite (area_from v p e on_v) in line.
      assert (value : (1 - g * h) * cross (along e) (minus v w) == 0).
      { setoid_replace ((1 - g * h) * cross (along e) (minus v w)) with (- cross (along e) (minus p v)); [lra |].
        unfold cross, along, minus. cbn [vx vy]. rewrite px, py. ring. }
      assert (flat : cross (along e) (minus v w) == 0) by (apply (Qmult_inj_l _ _ (1 - g * h)); [nra | lra]).
      assert (value' : cross (along e) (minus m w) == g * cross (along e) (minus v w))
        by (unfold cross, along, minus; cbn [vx vy]; rewrite X, Y; ring).
      rewrite value', flat in right_. lra.
  Qed.

  (* Who is near two edges is near a reflex vertex, or the first is to the left of the second. *)
  Lemma near_two_edges (e f : segment) (radius : Q) : In e boundary -> In f boundary -> 0 < radius ->
    eventually (fun d => forall z, near_segment d z e -> near_segment d z f ->
      (exists i, (i < n)%nat /\ reflex_at i /\ within radius (vertex c i) z) \/ forall w, lies_on w e -> 0 <= area f w).
  Proof.
    intros E F R. pose proof (polygon_edges_are_long c polygon) as long.
    destruct (common_point_or_none_near [e; f]) as [(v & on) | none].
    { intros s [<- | [<- | []]]; now apply long. }
    2:{ refine (eventually_implied _ _ _ none). intros d far z near_e near_f. destruct (far z).
        intros s [<- | [<- | []]]; assumption. }
    assert (on_e : lies_on v e) by (apply on; now left). assert (on_f : lies_on v f) by (apply on; right; now left).
    destruct (edges_there v (ex_intro _ e (conj E on_e))) as (s & t & S & T & _ & _ & only & _ & corner_).
    assert (easy : (forall w, lies_on w e -> 0 <= area f w) -> eventually (fun d => forall z, near_segment d z e ->
      near_segment d z f -> (exists i, (i < n)%nat /\ reflex_at i /\ within radius (vertex c i) z) \/
      forall w, lies_on w e -> 0 <= area f w)) by (intros left_; exists 1; split; [lra | intros; now right]).
    destruct (segment_dec e f) as [<- | differ];
      [apply easy; intros w on_w; rewrite (on_the_line w e on_w); lra |].
    pose proof (only e E on_e) as e_is. pose proof (only f F on_f) as f_is.
    destruct corner_ as [[<- _] | (i & I & _ & s_is & t_is & (_ & _ & [X Y] & _))];
      [destruct differ; destruct e_is, f_is; congruence |].
    destruct (Qlt_le_dec (cross (along s) (along t)) 0) as [reflex | not_reflex].
    - set (turn := - cross (along s) (along t)). assert (some : 0 < turn) by (unfold turn; lra).
      refine (eventually_implied _ _ _ (eventually_and _ _ (eventually_below 1 ltac:(lra)) (eventually_positive
        (radius * turn) (- (2 * (size (along s) + size (along t)))) (Qmult_lt_0_compat _ _ R some)))).
      intros d [[d_some _] few] z near_e near_f. left. exists i. split; [exact I |].
      split; [unfold reflex_at; now rewrite <- s_is, <- t_is |].
      assert (both : - (2 * d) < area s z < 2 * d /\ - (2 * d) < area t z < 2 * d).
      { unfold near_segment in near_e, near_f.
        destruct e_is as [-> | ->], f_is as [-> | ->]; try (now destruct differ); lra. }
      destruct both as [near_s near_t].
      assert (v_is : vertex c i = source t) by (rewrite t_is, edge_is by exact I; reflexivity).
      assert (value : turn * (vx z - vx (source t)) == area t z * vx (along s) - area s z * vx (along t) /\
        turn * (vy z - vy (source t)) == area t z * vy (along s) - area s z * vy (along t))
        by (unfold turn, area, cross, along, minus; cbn [vx vy]; rewrite <- X, <- Y; split; ring).
      pose proof (product_bounds _ (vx (along t)) _ near_s). pose proof (product_bounds _ (vy (along t)) _ near_s).
      pose proof (product_bounds _ (vx (along s)) _ near_t). pose proof (product_bounds _ (vy (along s)) _ near_t).
      assert (low : forall h, 0 <= 2 * d * Qabs.Qabs h)
        by (intros h; apply Qmult_le_0_compat; [lra | apply abs_bounds]).
      pose proof (low (vx (along s))). pose proof (low (vy (along s))).
      pose proof (low (vx (along t))). pose proof (low (vy (along t))).
      unfold within, size in *. rewrite v_is. destruct value as [value_x value_y].
      assert (most : forall h, turn * - radius < turn * h -> turn * h < turn * radius -> - radius < h < radius)
        by (intros h low_ high; split; now apply (Qmult_lt_l _ _ turn some)).
      split; apply most; rewrite ?value_x, ?value_y; lra.
    - apply easy. intros w (k & range & wx & wy).
      destruct e_is as [-> | ->], f_is as [-> | ->]; try now destruct differ.
      + assert (value : area t w == (1 - k) * cross (along s) (along t))
          by (unfold area, cross, along, minus; cbn [vx vy]; rewrite wx, wy, <- X, <- Y; ring).
        rewrite value. apply Qmult_le_0_compat; lra.
      + assert (value : area s w == k * cross (along s) (along t))
          by (unfold area, cross, along, minus; cbn [vx vy]; rewrite wx, wy, <- X, <- Y; ring).
        rewrite value. apply Qmult_le_0_compat; lra.
  Qed.

  Lemma sizes_are_bounded (l : list segment) : exists most, 0 < most /\ forall s, In s l -> size (along s) <= most.
  Proof.
    clear. induction l as [| s l (most & some & all)]; [exists 1; split; [lra | intros s []] |].
    exists (Qmax most (size (along s))).
    pose proof (Q.le_max_l most (size (along s))). pose proof (Q.le_max_r most (size (along s))).
    split; [lra |]. intros t [<- | T]; [assumption |]. specialize (all t T). lra.
  Qed.

  (* Theorem. Points near each other can be joined by a step, or a reflex vertex is near. *)
  Theorem near_points_are_joined (radius : Q) : 0 < radius -> eventually (fun d =>
    forall v w, within d v w -> in_region v [c] -> in_region w [c] ->
      (exists i, (i < n)%nat /\ reflex_at i /\ within radius (vertex c i) v) \/
      forall m, lies_on m (Segment v w) -> in_region m [c]).
  Proof.
    intros R.
    destruct (eventually_for_all (fun ef d => forall z, near_segment d z (fst ef) -> near_segment d z (snd ef) ->
      (exists i, (i < n)%nat /\ reflex_at i /\ within radius (vertex c i) z) \/
      forall w, lies_on w (fst ef) -> 0 <= area (snd ef) w) (list_prod boundary boundary)) as (bound & B & all).
    { intros [e f] P. apply in_prod_iff in P. apply near_two_edges; tauto. }
    destruct (sizes_are_bounded boundary) as (most & M & sizes).
    assert (share : bound / most * most == bound) by (field; lra).
    exists (bound / most). split; [apply Qlt_shift_div_l; lra |]. set (q := bound / most) in *. clearbody q.
    intros d D less v w close in_v in_w.
    destruct (one_or_all (exists i, (i < n)%nat /\ reflex_at i /\ within radius (vertex c i) v)
      (fun i => (i < n)%nat -> reflex_at i -> ~ within radius (vertex c i) v) (seq 0 n)) as [found | none];
      [| now left | right].
    { intros i _. destruct (le_lt_dec n i) as [| I]; [right; lia |].
      destruct (within_dec radius (vertex c i) v) as [near_ | far]; [| now right].
      destruct (Qlt_le_dec (cross (along (edge_at c (previous n i))) (along (edge_at c i))) 0) as [reflex | not_];
        [left; now exists i | right; intros _ reflex; unfold reflex_at in reflex; lra]. }
    intros m (g & range & X & Y). cbn [source target] in X, Y.
    destruct (in_region_dec m [c]) as [| out]; [assumption | exfalso].
    destruct (leaving_to_the_right v m in_v out) as (k & e & k_range & E & on_e & _).
    destruct (leaving_to_the_right w m in_w out) as (l & f & l_range & F & on_f & right_f & _).
    set (p := moved_along v (minus m v) k) in *. set (o := moved_along w (minus m w) l) in *.
    assert (ahead : 0 < 1 - l * (1 - g) - k * g).
    { setoid_replace (1 - l * (1 - g) - k * g) with ((1 - g) * (1 - l) + g * (1 - k)) by ring.
      apply mixed_is_more; lra. }
    assert (near_it_ : forall s h, 0 <= h <= 1 -> In s boundary -> lies_on (moved_along v (minus w v) h) s ->
      near_segment (d * most) v s).
    { intros s h h_range S on. apply (nearer (d * size (along s))); [specialize (sizes s S); nra |].
      apply (close_is_near s v (moved_along v (minus w v) h)); [exact on |].
      unfold within, moved_along, minus in *. cbn [vx vy]. nra. }
    destruct (all (d * most) (Qmult_lt_0_compat _ _ D M) ltac:(nra) (e, f) ltac:(now apply in_prod) v)
      as [(i & I & reflex & close_v) | left_].
    - apply (near_it_ e (k * g)); [split; nra | exact E |]. apply (lies_on_equal p); [| exact on_e].
      unfold equal_vectors, p, moved_along, minus. cbn [vx vy]. rewrite X, Y. split; ring.
    - apply (near_it_ f (1 - l * (1 - g))); [split; nra | exact F |]. apply (lies_on_equal o); [| exact on_f].
      unfold equal_vectors, o, moved_along, minus. cbn [vx vy]. rewrite X, Y. split; ring.
    - exact (none i ltac:(apply in_seq; lia) I reflex close_v).
    - specialize (left_ p on_e). cbn [snd] in left_. pose proof (on_the_line o f on_f) as line.
      assert (back : cross (along f) (minus m w) == - ((1 - g) * cross (along f) (minus w v)))
        by (unfold cross, minus; cbn [vx vy]; rewrite X, Y; ring).
      assert (way : area f o - area f p == (1 - l * (1 - g) - k * g) * cross (along f) (minus w v))
        by (unfold area, cross, o, p, moved_along, along, minus; cbn [vx vy]; rewrite X, Y; ring).
      set (turn := cross (along f) (minus w v)) in *. assert (some : 0 < turn) by nra. nra.
  Qed.
End OnePolygon.
