(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Going straight on in a simple polygon, one leaves it only to the right of an edge: near a point of the boundary all
   that is to the left of the edges there is inside. So nobody leaves it who goes to the left of all edges. *)
From Coq Require Import QArith Lqa ZArith Lia List.
From Oplus Require Import convolution regions_and_sums small_numbers simple_chain boundary_points inside_a_corner
  edges_at_a_point fans_that_touch polygons_of_the_thesis edges_of_polygons points_of_the_intersection
  first_on_the_way.
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
        pose proof (left_normal t long_t) as left_n. set (k := Vector (- vy (along t)) (vx (along t))) in *.
        destruct (some_small _ (eventually_and _ _ (small_steps_stay_within ((1 # 2) * radius) z (along t) ltac:(lra))
          (eventually_below 1 ltac:(lra)))) as (h & _ & close_m & h_some & h_less).
        set (m := moved_along z (along t) h) in *.
        assert (on_m : strictly_inside m t).
        { destruct z_is as [zx zy]. exists h. unfold m, moved_along, along, minus. cbn [vx vy]. rewrite zx, zy.
          split; [lra | split; ring]. }
        assert (ahead : 0 < cross (along s) (minus m z)).
        { setoid_replace (cross (along s) (minus m z)) with (h * cross (along s) (along t))
            by (unfold m; by_coordinates). now apply Qmult_lt_0_compat. }
        destruct (some_small _ (eventually_and _ _ (beside_an_edge c polygon t m k T on_m left_n) (eventually_and _ _
          (small_steps_stay_within ((1 # 2) * radius) m k ltac:(lra))
          (eventually_positive _ (cross (along s) k) ahead)))) as (e & some & [round _] & near_start & left_s).
        set (start := moved_along m k e) in *.
        assert (left_s' : 0 < cross (along s) (minus start z)).
        { setoid_replace (cross (along s) (minus start z)) with (cross (along s) (minus m z) + e * cross (along s) k)
            by (unfold start; by_coordinates). exact left_s. }
        assert (left_t' : 0 < cross (along t) (minus start z)).
        { rewrite <- (area_from z start t on_t). setoid_replace (area t start) with (area t m + e * cross (along t) k)
            by (unfold start; by_coordinates). rewrite (on_the_line m t (strictly_inside_lies_on m t on_m)).
          pose proof (Qmult_lt_0_compat _ _ some left_n). lra. }
        assert (between_ : forall f w, lies_on w (Segment start y) -> 0 < cross f (minus start z) ->
          0 < cross f (minus y z) -> 0 < cross f (minus w z)).
        { intros f w (g & range & X & Y) at_start at_y. cbn [source target] in X, Y.
          setoid_replace (cross f (minus w z)) with ((1 - g) * cross f (minus start z) + g * cross f (minus y z))
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
End OnePolygon.
