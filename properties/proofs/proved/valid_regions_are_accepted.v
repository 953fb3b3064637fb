(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The test of regions (checked_collision.v) accepts all valid regions whose winding numbers are 0 and 1, once vertices
   that touch edges are vertices of these (touching_vertices.v): the parts of edges have nothing but ends in common, and
   for such segments the signs that are compared are as the test asks. *)
From Coq Require Import QArith Lqa Qfield ZArith Lia Bool List Permutation.
From Oplus Require Import specification checker regions_and_sums distinct right_of_an_edge observation_2_2_4
  homogeneous_points specification_bridge location pieces met_pieces naive_collision kept_pieces_go_round
  test_of_regions collision_is_sound collision_is_complete placed_collision checked_collision beside_a_piece
  cut_pieces edges_of_valid_regions walks sum_program sum_is_right inner_fit_program coordinates complement_in_a_frame
  touching_vertices.
Import ListNotations.

Open Scope Q_scope.

(* For segments of which no point of one is strictly inside the other, the signs are right. *)
Lemma meet_at_ends_is_complete (s t : segment) : nonzero (along s) -> nonzero (along t) ->
  (forall w, strictly_inside w s -> ~ lies_on w t) -> meet_at_ends s t = true.
Proof.
  intros long_s long_t none. unfold meet_at_ends. rewrite !orb_true_iff.
  destruct (on_one_side s t) eqn:one; [tauto |]. destruct (on_one_side t s) eqn:two; [tauto |].
  destruct (one_end_on_the_line s t) eqn:three; [tauto |]. destruct (one_end_on_the_line t s) eqn:four; [tauto |].
  right. unfold on_one_side, one_end_on_the_line in *.
  destruct (zero_spec (area s (source t))) as [line_1 | off_1], (zero_spec (area s (target t))) as [line_2 | off_2];
    try discriminate three.
  - (* in line *)
    unfold one_after_the_other. destruct (zero_spec (area s (source t))); [| contradiction].
    destruct (zero_spec (area s (target t))); [| contradiction]. cbn [andb].
    destruct (is_a_multiple (along s) (minus (source t) (source s)) long_s line_1) as (j & jx & jy).
    destruct (is_a_multiple (along s) (minus (target t) (source s)) long_s line_2) as (k & kx & ky).
    pose proof (square_positive _ long_s) as square. set (len := dot (along s) (along s)) in *.
    assert (a_is : dot (along s) (minus (source t) (source s)) == j * len)
      by (unfold len, dot; rewrite jx, jy; ring).
    assert (b_is : dot (along s) (minus (target t) (source s)) == k * len)
      by (unfold len, dot; rewrite kx, ky; ring).
    set (a := dot _ (minus (source t) _)) in *. set (b := dot _ (minus (target t) _)) in *. clearbody a b len.
    assert (no_source : ~ 0 < j < 1).
    { intros range. apply (none (source t)); [exists j | apply source_lies_on]. to_coordinates. split; lra. }
    assert (no_target : ~ 0 < k < 1).
    { intros range. apply (none (target t)); [exists k | apply target_lies_on]. to_coordinates. split; lra. }
    assert (no_middle : ~ (j < (1 # 2) < k \/ k < (1 # 2) < j)).
    { intros around. apply (none (middle s) (middle_is_inside s)). assert (some : ~ k - j == 0) by lra.
      exists (((1 # 2) - j) / (k - j)). assert (value : ((1 # 2) - j) / (k - j) * (k - j) == (1 # 2) - j)
        by (field; exact some).
      set (h := ((1 # 2) - j) / (k - j)) in *. clearbody h. split; [destruct around; split; nra |].
      assert (all : forall u v w d, v - u == j * d -> w - u == k * d -> u + (1 # 2) * d == (1 - h) * v + h * w).
      { intros u v w d to_v to_w. setoid_replace ((1 - h) * v + h * w) with (u + (v - u) + h * ((w - u) - (v - u))) by
          ring.
        rewrite to_v, to_w. setoid_replace (h * (k * d - j * d)) with (h * (k - j) * d) by ring. rewrite value. ring. }
      to_coordinates. rewrite <- (all _ _ _ _ jx kx), <- (all _ _ _ _ jy ky). split; ring. }
    assert (apart : (j <= 0 /\ k <= 0) \/ (1 <= j /\ 1 <= k)) by lra.
    destruct (negative_spec (- a)), (negative_spec (- b)), (negative_spec (a - len)), (negative_spec (b - len));
      try reflexivity; exfalso; destruct apart; nra.
  - (* the ends of t are on two sides of s; so are those of s, and they cross *)
    exfalso. assert (turn : area s (target t) - area s (source t) == area t (source s) - area t (target s))
      by by_coordinates.
    destruct (negative_spec (area s (source t))), (negative_spec (- area s (source t))),
      (negative_spec (area s (target t))), (negative_spec (- area s (target t))); try discriminate one; try lra.
    all: destruct (zero_spec (area t (source s))), (zero_spec (area t (target s))); try discriminate four; try lra.
    all: destruct (negative_spec (area t (source s))), (negative_spec (- area t (source s))),
      (negative_spec (area t (target s))), (negative_spec (- area t (target s))); try discriminate two; try lra.
    all: destruct (crossing_point_is s t) as (in_s & in_t & _); [| apply (none _ in_s); now apply
      strictly_inside_lies_on].
    all: unfold cross_properly; rewrite !orientation_by_area; destruct s as [s1 s2], t as [t1 t2]; cbn [source
      target] in *.
    all: compared_numbers (area (Segment s1 s2) t1 ?= 0); compared_numbers (area (Segment s1 s2) t2 ?= 0);
      compared_numbers (area (Segment t1 t2) s1 ?= 0); compared_numbers (area (Segment t1 t2) s2 ?= 0);
      try reflexivity; exfalso; lra.
Qed.

(* The vertices on an edge are in order along it. *)
Lemma in_order_along (s : segment) (l : list vector) : nonzero (along s) -> forall a, lies_on a s -> fraction s a < 1 ->
  (forall p, In p l -> lies_on p s /\ fraction s a < fraction s p < 1) -> along_is_ordered s l ->
  are_in_order a (target s) l = true.
Proof.
  intros long. induction l as [| v l IH]; intros a on less all order; [reflexivity |]. destruct order as [first rest].
  destruct (all v (or_introl eq_refl)) as (on_v & after_a & before_end). cbn [are_in_order]. apply andb_true_iff. split.
  - apply is_between_ends_iff. destruct (fraction_on s a long on) as (_ & ax & ay),
      (fraction_on s v long on_v) as (_ & bx &
    by_).
    set (j := fraction s a) in *. set (k := fraction s v) in *. clearbody j k. split.
    + intros [X Y]. apply long. unfold along, minus. cbn [vx vy]. rewrite ax in X. rewrite ay in Y.
      split; apply (Qmult_inj_l _ _ (1 - j)); lra.
    + assert (value : (k - j) / (1 - j) * (1 - j) == k - j) by (field; lra). exists ((k - j) / (1 - j)).
      split; [split; [apply Qlt_shift_div_l | apply Qlt_shift_div_r]; lra |].
      set (h := (k - j) / (1 - j)) in *. clearbody h. assert (k_is : k == j + h * (1 - j)) by lra.
      rewrite bx, by_, ax, ay, k_is. split; ring.
  - apply (IH v on_v before_end); [| exact rest]. intros p P. destruct (all p (or_intror P)) as (on_p & _ & less_p).
    split; [exact on_p |]. split; [now apply first | exact less_p].
Qed.

Lemma between_is_inside (v : vector) (e : segment) : nonzero (along e) ->
  (is_between_ends v (source e) (target e) = true <-> strictly_inside v e).
Proof.
  intros long. rewrite is_between_ends_iff. split; [now intros [_ inside_] |]. intros inside_. split; [| exact inside_].
  intros [X Y]. apply long. unfold along, minus. cbn [vx vy]. split; lra.
Qed.

Lemma vertices_along_are (vertices : list vector) (e : segment) : nonzero (along e) ->
  exists inner, vertices_along vertices e = source e :: inner /\ are_in_order (source e) (target e) inner = true /\
    incl inner vertices /\
    forall v, In v vertices -> strictly_inside v e -> exists w, In w inner /\ equal_vectors v w.
Proof.
  intros long. unfold vertices_along. set (on_e := filter _ vertices). set (sorted := sorted_points on_e).
  set (inner := match compare_points (target e) (source e) with Lt => rev sorted | _ => sorted end).
  assert (same : forall v, In v inner <-> In v sorted).
  { intros v. unfold inner. destruct (compare_points _ _); [tauto | symmetry; apply in_rev | tauto]. }
  assert (inside_ : forall v, In v sorted -> lies_on v e /\ 0 < fraction e v < 1 /\ In v vertices).
  { intros v V. apply sorted_in, filter_In in V. destruct V as [V between_].
    apply between_is_inside in between_; [| exact long]. destruct between_ as (k & range & X & Y).
    rewrite (fraction_is e v k long X Y). split; [exists k; split; [lra | tauto] | tauto]. }
  assert (order : are_in_order (source e) (target e) inner = true).
  { assert (at_0 : fraction e (source e) == 0) by (apply fraction_is; [exact long | ring | ring]).
    apply in_order_along; [exact long | apply source_lies_on | lra | |].
    - intros v V. apply same in V. destruct (inside_ v V) as (on & range & _). split; [exact on | lra].
    - pose proof (sorted_ordered on_e) as ordered_. fold sorted in ordered_. unfold inner, along_is_ordered.
      compared_points (target e) (source e).
      + exfalso. apply long. unfold along, minus, equal_vectors in *. cbn [vx vy]. lra.
      + refine (ordered_by_more _ _ _ _ (ordered_backwards _ _ ordered_)). intros a b A B before_.
        apply in_rev in A, B. now apply (order_along e b a long); [apply inside_ | apply inside_ | |].
      + refine (ordered_by_more _ _ _ _ ordered_). intros a b A B before_.
        now apply (order_along e a b long); [apply inside_ | apply inside_ | |]. }
  rewrite order. exists inner. split; [reflexivity |]. split; [exact order |]. split.
  - intros v V. apply same in V. now apply inside_.
  - intros v V between_. destruct (sorted_has v on_e) as (w & W & equal).
    + apply filter_In. split; [exact V | now apply between_is_inside].
    + exists w. split; [now apply same | exact equal].
Qed.

Lemma common_end (a v b w : vector) : is_between_ends v a b = true -> lies_on w (Segment a v) ->
  lies_on w (Segment v b) -> equal_vectors w v.
Proof.
  rewrite is_between_ends_iff. intros (long & k & range & vx_is & vy_is) (i & range_i & ix & iy) (j & range_j & jx &
    jy).
  cbn [source target] in *.
  assert (i_is : i * k == k + j * (1 - k)).
  { assert (both : (k + j * (1 - k) - i * k) * (vx b - vx a) == 0 /\ (k + j * (1 - k) - i * k) * (vy b - vy a) == 0).
    { rewrite vx_is in ix, jx. rewrite vy_is in iy, jy. split; lra. }
    destruct both as [one two]. apply Qmult_integral in one, two. destruct one as [| X]; [lra |].
    destruct two as [| Y]; [lra |]. exfalso. apply long. split; lra. }
  assert (j == 0) as j_is by nra. rewrite j_is in jx, jy. split; lra.
Qed.

Lemma ends_are_not_inside (s : segment) (v : vector) : nonzero (along s) -> strictly_inside v s ->
  ~ equal_vectors v (source s) /\ ~ equal_vectors v (target s).
Proof.
  intros long (k & range & X & Y). split; intros [ex ey]; apply long; unfold along, minus; cbn [vx vy];
    [split; apply (Qmult_inj_l _ _ k) | split; apply (Qmult_inj_l _ _ (1 - k))]; lra.
Qed.

Lemma on_parts (x b : vector) (l : list vector) (a : vector) : are_in_order a b l = true ->
  (exists s, In s (path (a :: l) b) /\ lies_on x s) -> lies_on x (Segment a b).
Proof. intros order on. apply (divided_edge x b l a order) in on. now destruct on as (s & [<- | []] & on_s). Qed.

(* No vertex on an edge is inside a part of it. *)
Lemma parts_in_order (b : vector) (l : list vector) : forall a, are_in_order a b l = true -> ~ equal_vectors a b ->
  forall s, In s (path (a :: l) b) -> nonzero (along s) /\ (source s = a \/ In (source s) l) /\
    forall v, v = a \/ v = b \/ In v l -> ~ strictly_inside v s.
Proof.
  induction l as [| v l IH]; intros a order a_b s S.
  - destruct S as [<- | []]. cbn [hd]. assert (long : nonzero (along (Segment a b)))
      by (intros [X Y]; apply a_b; by_computing).
    split; [exact long |]. split; [now left |]. intros v [-> | [-> | []]] inside_;
      destruct (ends_are_not_inside _ _ long inside_) as [no_a no_b]; [apply no_a | apply no_b]; reflexivity.
  - cbn [are_in_order] in order. apply andb_true_iff in order. destruct order as [between_ order].
    destruct (is_between_ends_is v a b between_) as (k & range & X & Y).
    assert (long : nonzero (along (Segment a v))).
    { intros [ex ey]. apply a_b. to_coordinates. split; apply (Qmult_inj_l _ _ k); lra. }
    assert (v_b : ~ equal_vectors v b) by (intros [ex ey]; apply a_b; split; apply (Qmult_inj_l _ _ (1 - k)); lra).
    assert (parts : forall w t, In t (path (v :: l) b) -> lies_on w t -> lies_on w (Segment v b))
      by (intros w t T on; apply (on_parts w b l v order); now exists t).
    destruct S as [<- | S].
    + split; [exact long |]. split; [now left |]. intros u which inside_.
      destruct (ends_are_not_inside _ _ long inside_) as [no_a no_v]. cbn [source target hd] in *.
      destruct which as [-> | U]; [apply no_a; reflexivity |].
      apply no_v, (common_end a v b u between_); [now apply strictly_inside_lies_on |].
      destruct U as [-> | [<- | U]]; [apply (target_lies_on (Segment v b)) | apply (source_lies_on (Segment v b)) |].
      assert (exists t, In t (path (v :: l) b) /\ source t = u) as (t & T & <-);
        [| apply (parts _ t T), source_lies_on].
      { clear - U. revert v. induction l as [| c l IH]; intros v; [destruct U |]. destruct U as [<- | U].
        - exists (Segment c (hd b l)). split; [now right; left | reflexivity].
        - destruct (IH U c) as (t & T & is_u). exists t. split; [now right | exact is_u]. }
    + destruct (IH v order v_b s S) as (long_s & source_ & clear_). split; [exact long_s |].
      split; [right; destruct source_ as [-> | U]; cbn; tauto |].
      intros u [-> | U] inside_; [| apply (clear_ u); [destruct U as [-> | [<- | U]]; tauto | exact inside_]].
      destruct (common_end a v b a between_ (source_lies_on (Segment a v))) as [ex ey];
        [now apply (parts _ s S), strictly_inside_lies_on |]. apply long. by_computing.
Qed.

(* In whatever way an edge is divided, its parts have what they had in common with others, and the new vertices. *)
Definition meet_among (vertices : list vector) (s t : segment) : Prop :=
  forall w, lies_on w s -> lies_on w t -> exists v, In v vertices /\ equal_vectors w v.

Lemma meet_among_swapped (vertices : list vector) (s t : segment) : meet_among vertices s t -> meet_among vertices t s.
Proof. intros meet w on_t on_s. now apply meet. Qed.

Lemma divided_edges_meet (vertices : list vector) (b : vector) (l : list vector) : incl l vertices -> forall a others,
  are_in_order a b l = true -> ForallOrdPairs (meet_among vertices) (Segment a b :: others) ->
  ForallOrdPairs (meet_among vertices) (path (a :: l) b ++ others).
Proof.
  induction l as [| v l IH]; intros part a others order pairs; [exact pairs |].
  cbn [are_in_order] in order. apply andb_true_iff in order. destruct order as [between_ order].
  inversion pairs as [| ? ? first rest]; subst. rewrite Forall_forall in first.
  assert (less : forall s, (forall w, lies_on w s -> lies_on w (Segment a b)) -> Forall (meet_among vertices s) others)
    by (intros s in_; apply Forall_forall; intros t T w on_s; apply (first t T); auto).
  change (path (a :: v :: l) b) with (Segment a v :: path (v :: l) b).
  apply (pairs_permuted _ (meet_among_swapped _) (path (v :: l) b ++ Segment a v :: others));
    [symmetry; apply Permutation_middle |].
  apply IH; [intros u U; apply part; now right | exact order |]. constructor; [constructor |].
  - intros w on_b on_a. exists v. split; [apply part; now left | exact (common_end a v b w between_ on_a on_b)].
  - apply less. intros w on. apply (on_divided v a b w between_). now right.
  - constructor; [| exact rest]. apply less. intros w on. apply (on_divided v a b w between_). now left.
Qed.

(* To the right of an edge inside which there is no vertex is the outside, to its left the inside. *)
Lemma sides_of_an_edge (s : region) (t : segment) : valid_region s -> nowhere_above_one s -> In t (region_edges s) ->
  (forall w, strictly_inside w t -> ~ is_vertex w s) ->
  winding_number_shifted (right_of_middle t) (region_edges s) = 0%Z /\
  winding_number_shifted (right_of_middle (reversed t)) (region_edges s) = 1%Z.
Proof.
  intros (not_points & not_negative & meet) above T clear_.
  pose proof (region_edges_are_directions s not_points t T) as long.
  assert (only : met_only_along (region_edges s) t).
  { apply clear_edge_is_met_only_along; trivial. intros k w range X Y. apply clear_. now exists k. }
  set (n := Vector (- vy (along t)) (vx (along t))). pose proof (left_normal t long) as turn. fold n in turn.
  pose proof (middle_is_inside t) as inside_.
  destruct (some_small _ (eventually_and _ _ (left_is_one_more s t (middle t) n meet T
      (strictly_inside_lies_on _ _ inside_) (clear_ _ inside_) turn) (eventually_and _ _
    (to_the_right_of_a_piece _ t (region_cycles s) only long (middle t) (opposite n) inside_
      ltac:(unfold cross, opposite in *; cbn [vx vy]; lra))
    (to_the_right_of_a_piece _ (reversed t) (region_cycles s) (met_only_along_reversed _ _ only)
      (long_of_one_place _ _ (reversed_place t) long) (middle t) n (strictly_inside_reversed _ _ inside_)
      ltac:(in_coordinates; lra))))) as (d & _ & (free & free' & more) & <- & <-).
  pose proof (above _ free). pose proof (not_negative _ free').
  rewrite (winding_number_of_equal (moved_along (middle t) (opposite n) d) (moved_along (middle t) n (- d)))
    by (unfold moved_along, opposite; cbn [vx vy]; ring). lia.
Qed.

(* Theorem. The test accepts a valid region whose winding numbers are at most 1, if no vertex is inside an edge. *)
Theorem clear_regions_are_accepted (s : region) : valid_region s -> nowhere_above_one s ->
  (forall t, In t (region_edges s) -> forall w, strictly_inside w t -> ~ is_vertex w s) -> covers_nothing_twice s =
    true.
Proof.
  intros valid above clear_. pose proof valid as (not_points & not_negative & meet).
  assert (long : forall t, In t (region_edges s) -> nonzero (along t))
    by (intros t T; exact (region_edges_are_directions s not_points t T)).
  assert (number_is : forall t, In t (region_edges s) ->
    winding_number_shifted (right_of_middle t) (region_edges s) = 0%Z)
      by (intros t T; exact (proj1 (sides_of_an_edge s t valid above T (clear_ t T)))).
  unfold covers_nothing_twice, is_valid_region. rewrite !andb_true_iff, !forallb_forall. repeat split.
  - intros t T. pose proof (long t T) as long_t. apply negb_true_iff.
    destruct (zero_spec (vx (along t))), (zero_spec (vy (along t))); try reflexivity. exfalso. apply long_t. now split.
  - assert (pairs : ForallOrdPairs (fun t u => meet_at_ends t u = true) (region_edges s)).
    { refine (weaker_pairs _ _ _ _ (proj1 (edges_meet_by_pairs s) meet)). intros t u T U common.
      apply meet_at_ends_is_complete; [now apply long .. |]. intros w inside_ on.
      exact (clear_ t T w inside_ (common w (strictly_inside_lies_on _ _ inside_) on)). }
    clear - pairs. induction pairs as [| t l first _ IH]; [reflexivity |]. cbn [all_pairs]. rewrite IH, andb_true_r.
    apply forallb_forall. now apply Forall_forall.
  - intros t T. apply forallb_forall. intros u U. destruct (is_on_spec (source u) t) as [on |]; [| reflexivity].
    cbn [negb orb]. unfold at_an_end.
    destruct (inside_or_end (source u) t on) as [inside_ | [[X Y] | [X Y]]].
    + exfalso. apply (clear_ t T _ inside_). exists u. split; [exact U | split; reflexivity].
    + destruct (zero_spec (vx (source u) - vx (source t))), (zero_spec (vy (source u) - vy (source t)));
        try reflexivity; exfalso; lra.
    + destruct (zero_spec (vx (source u) - vx (target t))), (zero_spec (vy (source u) - vy (target t)));
        try (exfalso; lra). now rewrite orb_true_r.
  - intros t T. now rewrite number_is.
  - intros t T. now rewrite number_is.
Qed.

(* With touching vertices put in, none is inside an edge. *)
Theorem divided_regions_are_clear (r : region) : valid_region r -> nowhere_above_one r ->
  let s := with_touching_vertices r in valid_region s /\ nowhere_above_one s /\
  forall t, In t (region_edges s) -> forall w, strictly_inside w t -> ~ is_vertex w s.
Proof.
  intros (not_points & not_negative & meet) above. intros s. set (vertices := concat r).
  assert (edges_are : region_edges s = flat_map (divided vertices) (region_edges r)) by apply
    edges_with_touching_vertices.
  assert (long : forall e, In e (region_edges r) -> nonzero (along e))
    by (intros e E; exact (region_edges_are_directions r not_points e E)).
  assert (sources : forall v, In v vertices <-> exists e, In e (region_edges r) /\ source e = v).
  { intros v. unfold vertices. rewrite in_concat. unfold region_edges. setoid_rewrite in_flat_map. split.
    - intros (c & C & V). destruct (edges_ends c) as [sources _]. rewrite <- sources in V.
      apply in_map_iff in V. destruct V as (e & is_v & E). exists e. split; [now exists c | exact is_v].
    - intros (e & (c & C & E) & <-). exists c. split; [exact C |]. now apply ends_of_edges. }
  assert (parts : forall e, In e (region_edges r) ->
    exists inner, divided vertices e = path (source e :: inner) (target e) /\
      are_in_order (source e) (target e) inner = true /\ incl inner vertices /\
      forall v, In v vertices -> strictly_inside v e -> exists w, In w inner /\ equal_vectors v w).
  { intros e E. destruct (vertices_along_are vertices e (long e E)) as (inner & is_ & more). exists inner.
    unfold divided. now rewrite is_. }
  assert (each : forall t, In t (region_edges s) -> nonzero (along t) /\ In (source t) vertices /\
    forall v, In v vertices -> ~ strictly_inside v t).
  { intros t T. rewrite edges_are in T. apply in_flat_map in T. destruct T as (e & E & T).
    destruct (parts e E) as (inner & is_ & order & part & has). rewrite is_ in T.
    assert (ends_differ : ~ equal_vectors (source e) (target e)) by (intros [X Y]; apply (long e E); by_computing).
    destruct (parts_in_order _ _ _ order ends_differ t T) as (long_t & source_ & clear_). split; [exact long_t |].
    split; [destruct source_ as [-> | U]; [apply sources; now exists e | now apply part] |]. intros v V inside_.
    assert (equal_inside : forall u, equal_vectors v u -> u = source e \/ u = target e \/ In u inner -> False).
    { intros u [X Y] U. apply (clear_ u U). destruct inside_ as (k & range & kx & ky). exists k. rewrite <- X, <- Y.
      tauto. }
    assert (on_v : lies_on v (Segment (source e) (target e)))
      by (apply (on_parts v _ _ _ order); exists t; split; [exact T | now apply strictly_inside_lies_on]).
    destruct (inside_or_end v _ on_v) as [inside_e | [equal | equal]].
    - destruct (has v V) as (u & U & equal); [now destruct e | apply (equal_inside u); tauto].
    - apply (equal_inside (source e)); [now symmetry | tauto].
    - apply (equal_inside (target e)); [now symmetry | tauto]. }
  assert (is_vertex_of_s : forall v w, In v vertices -> equal_vectors w v -> is_vertex w s).
  { intros v w V equal. apply sources in V. destruct V as (e & E & <-).
    destruct (parts e E) as (inner & is_ & _). exists (Segment (source e) (hd (target e) inner)).
    split; [| exact equal]. rewrite edges_are. apply in_flat_map. exists e. split; [exact E |]. rewrite is_. now left. }
  assert (meet_s : edges_meet_in_vertices s).
  { apply edges_meet_by_pairs. apply (weaker_pairs (meet_among vertices)).
    { intros t u _ _ common w on_t on_u. destruct (common w on_t on_u) as (v & V & equal).
      now apply (is_vertex_of_s v). }
    rewrite edges_are, <- (app_nil_r (flat_map _ _)).
    assert (pairs : ForallOrdPairs (meet_among vertices) (region_edges r ++ [])).
    { rewrite app_nil_r. apply edges_meet_by_pairs in meet. refine (weaker_pairs _ _ _ _ meet).
      intros t u _ _ common w on_t on_u. destruct (common w on_t on_u) as (e & E & equal). exists (source e).
      split; [apply sources; now exists e | exact equal]. }
    revert parts pairs. clear. generalize (region_edges r) (@nil segment). intros l.
    induction l as [| e l IH]; intros others parts pairs; [exact pairs |]. cbn [flat_map].
    destruct (parts e (or_introl eq_refl)) as (inner & -> & order & part & _).
    apply (pairs_permuted _ (meet_among_swapped _) (flat_map (divided vertices) l ++ path (source e :: inner) (target
      e) ++ others)).
    { rewrite !app_assoc. apply Permutation_app_tail, Permutation_app_comm. }
    apply IH; [intros f F; apply parts; now right |].
    apply (pairs_permuted _ (meet_among_swapped _) (path (source e :: inner) (target e) ++ l ++ others));
      [apply Permutation_app_swap_app |]. apply divided_edges_meet; trivial. now destruct e. }
  assert (numbers : forall y, off y (region_edges s) -> off y (region_edges r) /\
    winding_number y (region_edges s) = winding_number y (region_edges r)).
  { intros y free. destruct (divided_region r y) as [same number_is]. split; [| exact number_is].
    apply off_is. intros on. apply same in on. now apply off_is in free. }
  split; [split; [| split; [| exact meet_s]] | split].
  - apply edges_are_no_points. intros t T. now apply each.
  - intros y free. destruct (numbers y free) as [free_r ->]. auto.
  - intros y free. destruct (numbers y free) as [free_r ->]. auto.
  - intros t T w (k & range & X & Y) (u & U & ex & ey). apply (proj2 (proj2 (each t T)) (source u)); [now apply each |].
    exists k. rewrite <- ex, <- ey. tauto.
Qed.

(* Theorem. So all regions that are valid are accepted. *)
Theorem valid_regions_are_accepted (r : polygonal_region) :
  valid_region (as_region r) -> nowhere_above_one (as_region r) ->
  covers_nothing_twice (as_region (prepared_region r)) = true.
Proof.
  intros valid above. destruct (divided_regions_are_clear _ valid above) as (s_valid & s_above & clear_).
  set (s := with_touching_vertices (as_region r)) in *.
  destruct (polygonal_is_valid s s_valid s_above) as [written_valid written_above].
  apply (clear_regions_are_accepted _ written_valid written_above).
  change (prepared_region r) with (as_polygonal s). destruct (as_image s) as (h & same & ->).
  intros t T w (k & range & X & Y) (u & U & ux & uy). rewrite edges_of_images in T, U.
  apply in_map_iff in T, U. destruct T as (t' & <- & T), U as (u' & <- & U). unfold moved_ends in *. cbn [source
    target] in *.
  destruct (same (source t')) as [ax ay], (same (target t')) as [bx by_], (same (source u')) as [cx cy].
  apply (clear_ t' T w); [exists k | exists u'; split; [exact U |]]; [rewrite <- ax, <- ay, <- bx, <- by_; tauto |].
  split; lra.
Qed.
