(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The test of regions (checked_collision.v) accepts all valid regions whose winding numbers are 0 and 1, once vertices
   that touch edges are vertices of these (touching_vertices.v): the parts of edges have nothing but ends in common, and
   for such segments the signs that are compared are as the test asks. *)
From Coq Require Import QArith Lqa Qfield ZArith Lia Bool List.
From Oplus Require Import specification checker direction angle angular_crossings distinct winding_number shifted_ray
  small_numbers signed_crossings rotation in_out_degree regions meeting_of_segments weight winding_number_of_the_sum
  interiors_meet neighbourhoods left_of_an_edge right_of_an_edge theorem_4_2_1 observation_2_2_4 homogeneous_points
  specification_bridge location pieces met_pieces test_of_regions collision_is_sound collision_is_complete
  placed_collision checked_collision
  beside_a_piece cut_pieces kept_pieces_balance walks sum_program sum_is_right inner_fit_program complement_in_a_frame
  touching_vertices.
Import ListNotations.

Open Scope Q_scope.

(* Pairs of a list, and of lists put together. *)
Lemma pairs_by_position {A : Type} (R : A -> A -> Prop) (l : list A) :
  (forall earlier s later t, l = earlier ++ s :: later -> In t (earlier ++ later) -> R s t) -> ForallOrdPairs R l.
Proof.
  induction l as [| a l IH]; intros all; constructor.
  - apply Forall_forall. intros b B. now apply (all [] a l).
  - apply IH. intros earlier s later t -> T. apply (all (a :: earlier) s later); [reflexivity | now right].
Qed.

Lemma pair_at_position {A : Type} (R : A -> A -> Prop) (s t : A) (later earlier : list A) :
  (forall a b, R a b -> R b a) -> ForallOrdPairs R (earlier ++ s :: later) -> In t (earlier ++ later) -> R s t.
Proof.
  intros sym. induction earlier as [| a earlier IH]; intros pairs T; cbn [app] in *; inversion pairs as [| ? ? first
    rest];
    subst; rewrite Forall_forall in first; [now apply first |].
  destruct T as [<- | T]; [| now apply IH]. apply sym, first, in_elt.
Qed.

Lemma pairs_of_lists {A B : Type} (R : A -> A -> Prop) (S : B -> B -> Prop) (f : A -> list B) (l : list A) :
  (forall a, In a l -> ForallOrdPairs S (f a)) ->
  (forall a b, In a l -> In b l -> R a b -> forall c d, In c (f a) -> In d (f b) -> S c d) ->
  ForallOrdPairs R l -> ForallOrdPairs S (flat_map f l).
Proof.
  intros each across pairs. induction pairs as [| a l first rest IH]; [constructor |]. cbn [flat_map].
  assert (joined : forall k, ForallOrdPairs S k -> (forall c, In c k -> In c (f a)) ->
    ForallOrdPairs S (k ++ flat_map f l)).
  { intros k pairs_k part. induction pairs_k as [| c k first_k rest_k IH_k].
    - apply IH; intros; [apply each; now right | eapply across; eauto; now right].
    - cbn [app]. constructor; [| apply IH_k; intros; apply part; now right]. apply Forall_app. split; [exact first_k |].
      apply Forall_forall. intros d D. apply in_flat_map in D. destruct D as (b & B_ & D).
      rewrite Forall_forall in first. apply (across a b); auto; [now left | now right |]. apply part. now left. }
  apply joined; [apply each; now left | trivial].
Qed.

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
    pose proof (square_positive _ long_s) as square. set (len := dot (along s) (along s)) in *.
    set (a := dot (along s) (minus (source t) (source s))). set (b := dot (along s) (minus (target t) (source s))).
    assert (places : forall p, area s p == 0 -> let k := dot (along s) (minus p (source s)) / len in
      vx p == vx (source s) + k * vx (along s) /\ vy p == vy (source s) + k * vy (along s)).
    { intros p line k. destruct (is_a_multiple (along s) (minus p (source s)) long_s) as (c & cx & cy).
      { exact line. }
      assert (k_is : k == c).
      { unfold k, dot. rewrite cx, cy. unfold len, dot in *. field. lra. }
      rewrite k_is. unfold minus in cx, cy; cbn [vx vy] in cx, cy. split; lra. }
    destruct (places (source t) line_1) as [ax ay], (places (target t) line_2) as [bx by_]. fold a in ax, ay. fold b
      in bx, by_.
    assert (a_is : a / len * len == a) by (field; lra). assert (b_is : b / len * len == b) by (field; lra).
    set (j := a / len) in *. set (k := b / len) in *. clearbody j k len.
    assert (differ : ~ j == k).
    { intros same. apply long_t. unfold along, minus. cbn [vx vy]. rewrite ax, ay, bx, by_, same. split; ring. }
    assert (overlap : forall m, 0 < m < 1 -> (j < m < k \/ k < m < j) -> False).
    { intros m range between_. apply (none (Vector (vx (source s) + m * vx (along s)) (vy (source s) + m * vy (along
      s)))).
      - exists m. split; [exact range |]. unfold along, minus. cbn [vx vy]. split; ring.
      - assert (some : ~ k - j == 0) by lra. exists ((m - j) / (k - j)).
        assert (value : (m - j) / (k - j) * (k - j) == m - j) by (field; exact some).
        set (h := (m - j) / (k - j)) in *. clearbody h. split; [destruct between_; split; nra |]. cbn [vx vy].
        rewrite ax, ay, bx, by_. assert (m_is : m == j + h * (k - j)) by lra. rewrite m_is. split; ring. }
    assert (apart : (j <= 0 /\ k <= 0) \/ (1 <= j /\ 1 <= k)).
    { destruct (Qlt_le_dec j k) as [less | more].
      - destruct (Qlt_le_dec 0 k); [| left; lra]. destruct (Qlt_le_dec j 1); [| right; lra]. exfalso.
        destruct (Qlt_le_dec j 0), (Qlt_le_dec k 1);
          [apply (overlap ((1 # 2) * k)) | apply (overlap (1 # 2)) | apply (overlap ((1 # 2) * (j + k)))
          | apply (overlap ((1 # 2) * (j + 1)))]; lra.
      - destruct (Qlt_le_dec 0 j); [| left; lra]. destruct (Qlt_le_dec k 1); [| right; lra]. exfalso.
        destruct (Qlt_le_dec k 0), (Qlt_le_dec j 1);
          [apply (overlap ((1 # 2) * j)) | apply (overlap (1 # 2)) | apply (overlap ((1 # 2) * (j + k)))
          | apply (overlap ((1 # 2) * (k + 1)))]; lra. }
    destruct (negative_spec (- a)), (negative_spec (- b)), (negative_spec (a - len)), (negative_spec (b - len));
      try reflexivity; exfalso; destruct apart; nra.
  - (* the ends of t are on two sides of s; so are those of s, and they cross *)
    exfalso. destruct (negative_spec (area s (source t))), (negative_spec (- area s (source t))),
      (negative_spec (area s (target t))), (negative_spec (- area s (target t))); try discriminate one; try lra.
    all: destruct (zero_spec (area t (source s))) as [on_1 | beside_1], (zero_spec (area t (target s))) as [on_2 |
      beside_2];
      try discriminate four.
    all: try (apply off_1; destruct (is_a_multiple (along t) (minus (source s) (source t)) long_t on_1) as (c & cx &
      cy);
      destruct (is_a_multiple (along t) (minus (target s) (source t)) long_t on_2) as (d & dx & dy);
      unfold area, cross, along, minus in *; cbn [vx vy] in *; nra).
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
  intros long. induction l as [| v l IH]; intros a on less all order; [reflexivity |].
  destruct order as [first rest].
  destruct (all v (or_introl eq_refl)) as (on_v & after_a & before_end). cbn [are_in_order]. apply andb_true_iff. split.
  - apply is_between_ends_iff. destruct (fraction_on s a long on) as (_ & ax & ay), (fraction_on s v long on_v) as (_ & bx &
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
  rewrite is_between_ends_iff. intros (long & k & range & vx_is & vy_is) (i & range_i & ix & iy) (j & range_j & jx & jy).
  cbn [source target] in *.
  assert (i_is : i * k == k + j * (1 - k)).
  { assert (both : (k + j * (1 - k) - i * k) * (vx b - vx a) == 0 /\ (k + j * (1 - k) - i * k) * (vy b - vy a) == 0).
    { rewrite vx_is in ix, jx. rewrite vy_is in iy, jy. split; lra. }
    destruct both as [one two]. apply Qmult_integral in one, two. destruct one as [| X]; [lra |].
    destruct two as [| Y]; [lra |]. exfalso. apply long. split; lra. }
  assert (j == 0) as j_is by nra. rewrite j_is in jx, jy. split; lra.
Qed.

(* The parts of an edge meet each other in the vertices on it, and have none of them inside. *)
Lemma parts_in_order (P : vector -> Prop) (b : vector) (l : list vector) :
  (forall v w, In v l -> equal_vectors w v -> P w) -> forall a, are_in_order a b l = true -> ~ equal_vectors a b ->
  (forall s, In s (path (a :: l) b) -> nonzero (along s) /\ (forall w, lies_on w s -> lies_on w (Segment a b)) /\
     (source s = a \/ In (source s) l) /\ forall v, v = a \/ v = b \/ In v l -> ~ strictly_inside v s) /\
  ForallOrdPairs (fun s t => forall w, lies_on w s -> lies_on w t -> P w) (path (a :: l) b).
Proof.
  assert (ends_are_not_inside : forall s v, nonzero (along s) -> strictly_inside v s ->
    ~ equal_vectors v (source s) /\ ~ equal_vectors v (target s)).
  { intros s v long (k & range & X & Y). split; intros [ex ey]; apply long; unfold along, minus; cbn [vx vy];
      [split; apply (Qmult_inj_l _ _ k) | split; apply (Qmult_inj_l _ _ (1 - k))]; lra. }
  induction l as [| v l IH]; intros is_P a order long_.
  - cbn [path hd]. assert (long : nonzero (along (Segment a b))).
    { intros [X Y]. apply long_. unfold along, minus in *; cbn [source target vx vy] in *. split; lra. }
    split; [| constructor; constructor]. intros s [<- | []]. split; [exact long |]. split; [trivial |].
    split; [now left |]. intros v [-> | [-> | []]] inside_; destruct (ends_are_not_inside _ _ long inside_) as [no_a
      no_b];
      [apply no_a | apply no_b]; split; reflexivity.
  - cbn [are_in_order] in order. apply andb_true_iff in order. destruct order as [between_ order].
    pose proof (is_between_ends_iff v a b) as facts. rewrite between_ in facts. destruct facts as [facts _].
    destruct (facts eq_refl) as (_ & k & range & X & Y). clear facts.
    assert (long_v : ~ equal_vectors v b).
    { intros [ex ey]. apply long_. split; apply (Qmult_inj_l _ _ (1 - k)); lra. }
    assert (long_a : nonzero (along (Segment a v))).
    { intros [ex ey]. apply long_. unfold along, minus in *; cbn [source target vx vy] in *.
      split; apply (Qmult_inj_l _ _ k); lra. }
    destruct (IH (fun u w U => is_P u w (or_intror U)) v order long_v) as [each pairs].
    change (path (a :: v :: l) b) with (Segment a v :: path (v :: l) b).
    assert (on_rest : forall u, u = v \/ u = b \/ In u l -> lies_on u (Segment v b)).
    { intros u [-> | [-> | U]]; [apply (source_lies_on (Segment v b)) | apply (target_lies_on (Segment v b)) |].
      assert (exists s, In s (path (v :: l) b) /\ source s = u) as (s & S & <-).
      { revert U. clear. revert v. induction l as [| c l IH]; intros v U; [destruct U |].
        change (path (v :: c :: l) b) with (Segment v c :: path (c :: l) b). destruct U as [<- | U].
        - exists (Segment c (hd b l)). split; [now right; left | reflexivity].
        - destruct (IH c U) as (s & S & is_u). exists s. split; [now right | exact is_u]. }
      apply (each s S), source_lies_on. }
    split.
    + intros s [<- | S].
      * split; [exact long_a |]. split; [intros w on; apply (on_divided v a b w between_); now left |].
        split; [now left |]. intros u which inside_.
        destruct (ends_are_not_inside _ _ long_a inside_) as [no_a no_v]. cbn [source target] in *.
        destruct which as [-> | U]; [apply no_a; split; reflexivity |].
        apply no_v, (common_end a v b u between_); [now apply strictly_inside_lies_on |].
        apply on_rest. destruct U as [-> | [-> | U]]; tauto.
      * destruct (each s S) as (long_s & part & source_ & clear_). split; [exact long_s |].
        split; [intros w on; apply (on_divided v a b w between_); right; now apply part |].
        split; [right; destruct source_ as [-> | U]; cbn; tauto |].
        intros u [-> | U] inside_; [| apply (clear_ u); [destruct U as [-> | [<- | U]]; tauto | exact inside_]].
        assert (on : lies_on a (Segment v b)) by (now apply part, strictly_inside_lies_on).
        pose proof (common_end a v b a between_ (source_lies_on (Segment a v)) on) as [ex ey].
        apply long_a. unfold along, minus; cbn [source target vx vy]. split; lra.
    + constructor; [| exact pairs]. apply Forall_forall. intros t T w on_s on_t.
      apply (is_P v); [now left |]. apply (common_end a v b w between_ on_s). now apply (each t T).
Qed.

(* Theorem. The test accepts a valid region whose winding numbers are at most 1, if no vertex is inside an edge. *)
Theorem clear_regions_are_accepted (s : region) : valid_region s -> nowhere_above_one s ->
  (forall t, In t (region_edges s) -> forall w, strictly_inside w t -> ~ is_vertex w s) -> covers_nothing_twice s =
    true.
Proof.
  intros (not_points & not_negative & meet) above clear_.
  assert (long : forall t, In t (region_edges s) -> nonzero (along t))
    by (intros t T; exact (region_edges_are_directions s not_points t T)).
  assert (number_is : forall t, In t (region_edges s) ->
    winding_number_shifted (right_of_middle t) (region_edges s) = 0%Z).
  { intros t T. pose proof (long t T) as long_t.
    destruct (right_value_of_the_middle s t meet T long_t (fun k w range X Y => clear_ t T w (ex_intro _ k (conj
      range (conj X Y))))) as (radius & R & value).
    set (n := Vector (- vy (along t)) (vx (along t))). pose proof (left_normal t long_t) as turn. fold n in turn.
    assert (range : 0 < 1 # 2 < 1) by lra. pose proof (strictly_inside_at t (1 # 2) range) as inside_.
    destruct (eventually_and _ _ (left_is_one_more s t (point_at t (1 # 2)) n meet T
        (strictly_inside_lies_on _ _ inside_) (clear_ t T _ inside_) turn)
      (small_steps_stay_within radius (point_at t (1 # 2)) (opposite n) R)) as (limit & L & near).
    destruct (near ((1 # 2) * limit)) as ((free & free' & more) & close); [lra | lra |].
    set (d := (1 # 2) * limit) in *. assert (some : 0 < d) by (unfold d; lra). clearbody d.
    rewrite <- (value (moved_along (point_at t (1 # 2)) n (- d))).
    - pose proof (above _ free). pose proof (not_negative _ free'). lia.
    - unfold within, moved_along, opposite in *. cbn [vx vy] in *. lra.
    - apply right_step_is_right; [apply point_at_is_on_the_line | exact turn | exact some]. }
  unfold covers_nothing_twice, is_valid_region. rewrite !andb_true_iff, !forallb_forall. repeat split.
  - intros t T. pose proof (long t T) as long_t. apply negb_true_iff.
    destruct (zero_spec (vx (along t))), (zero_spec (vy (along t))); try reflexivity. exfalso. apply long_t. now split.
  - assert (forall t u, In t (region_edges s) -> In u (region_edges s) ->
      (forall w, lies_on w t -> lies_on w u -> is_vertex w s) -> meet_at_ends t u = true) as all.
    { intros t u T U common. apply meet_at_ends_is_complete; [now apply long .. |]. intros w inside_ on.
      exact (clear_ t T w inside_ (common w (strictly_inside_lies_on _ _ inside_) on)). }
    assert (pairs : ForallOrdPairs (fun t u => forall w, lies_on w t -> lies_on w u -> is_vertex w s) (region_edges s)).
    { apply pairs_by_position. intros earlier t later u is_ U w. now apply (meet earlier t later u w). }
    revert pairs all. generalize (region_edges s). intros l pairs. induction pairs as [| t l first _ IH];
      [reflexivity |].
    intros all. cbn [all_pairs]. apply andb_true_iff. split; [| apply IH; intros; apply all; cbn; tauto].
    rewrite Forall_forall in first. apply forallb_forall. intros u U.
    apply all; [now left | now right | now apply first].
  - intros t T. apply forallb_forall. intros u U. destruct (is_on_spec (source u) t) as [on |]; [| reflexivity].
    cbn [negb orb]. unfold at_an_end.
    destruct (inside_or_end (source u) t on) as [inside_ | [[X Y] | [X Y]]].
    + exfalso. apply (clear_ t T _ inside_). exists u. split; [exact U | split; reflexivity].
    + destruct (zero_spec (vx (source u) - vx (source t))), (zero_spec (vy (source u) - vy (source t)));
        try reflexivity; exfalso; lra.
    + destruct (zero_spec (vx (source u) - vx (target t))), (zero_spec (vy (source u) - vy (target t)));
        try (exfalso; lra). now rewrite orb_true_r.
  - intros t T. rewrite number_is by exact T. reflexivity.
  - intros t T. rewrite number_is by exact T. reflexivity.
Qed.

(* With touching vertices put in, none is inside an edge. *)
Theorem divided_regions_are_clear (r : region) : valid_region r -> nowhere_above_one r ->
  let s := with_touching_vertices r in valid_region s /\ nowhere_above_one s /\
  forall t, In t (region_edges s) -> forall w, strictly_inside w t -> ~ is_vertex w s.
Proof.
  intros (not_points & not_negative & meet) above. intros s.
  assert (edges_are : region_edges s = flat_map (divided (concat r)) (region_edges r))
    by apply edges_with_touching_vertices.
  assert (long : forall e, In e (region_edges r) -> nonzero (along e))
    by (intros e E; exact (region_edges_are_directions r not_points e E)).
  assert (vertices : forall v, In v (concat r) <-> exists e, In e (region_edges r) /\ source e = v).
  { intros v. rewrite in_concat. unfold region_edges. setoid_rewrite in_flat_map. split.
    - intros (c & C & V). destruct (edges_ends c) as [sources _]. rewrite <- sources in V.
      apply in_map_iff in V. destruct V as (e & is_v & E). exists e. split; [now exists c | exact is_v].
    - intros (e & (c & C & E) & <-). exists c. split; [exact C |].
      destruct (edges_ends c) as [sources _]. rewrite <- sources. now apply in_map. }
  assert (parts : forall e, In e (region_edges r) ->
    exists inner, divided (concat r) e = path (source e :: inner) (target e) /\
      are_in_order (source e) (target e) inner = true /\ incl inner (concat r) /\
      (forall v, In v (concat r) -> strictly_inside v e -> exists w, In w inner /\ equal_vectors v w) /\
      ~ equal_vectors (source e) (target e)).
  { intros e E. destruct (vertices_along_are (concat r) e (long e E)) as (inner & is_ & more). exists inner.
    unfold divided. rewrite is_. split; [reflexivity |]. split; [tauto |]. split; [tauto |]. split; [tauto |].
    intros [X Y]. apply (long e E). unfold along, minus. cbn [vx vy]. split; lra. }
  assert (is_vertex_of_s : forall v w, In v (concat r) -> equal_vectors w v -> is_vertex w s).
  { intros v w V equal. apply vertices in V. destruct V as (e & E & <-).
    destruct (parts e E) as (inner & is_ & _). exists (Segment (source e) (hd (target e) inner)).
    split; [| exact equal]. rewrite edges_are. apply in_flat_map. exists e. split; [exact E |]. rewrite is_. now left. }
  assert (each : forall e, In e (region_edges r) ->
    (forall t, In t (divided (concat r) e) -> nonzero (along t) /\ (forall w, lies_on w t -> lies_on w e) /\
       In (source t) (concat r) /\ forall v, In v (concat r) -> ~ strictly_inside v t) /\
    ForallOrdPairs (fun t u => forall w, lies_on w t -> lies_on w u -> is_vertex w s) (divided (concat r) e)).
  { intros e E. destruct (parts e E) as (inner & -> & order & part & has & ends_differ).
    destruct (parts_in_order (fun w => is_vertex w s) (target e) inner
      (fun v w V => is_vertex_of_s v w (part v V)) (source e) order ends_differ) as [all pairs].
    split; [| exact pairs]. intros t T. destruct (all t T) as (long_t & on_e & source_ & clear_).
    assert (on : forall w, lies_on w t -> lies_on w e) by (destruct e; exact on_e).
    split; [exact long_t |]. split; [exact on |]. split.
    - destruct source_ as [-> | U]; [apply vertices; now exists e | now apply part].
    - intros v V inside_. pose proof (on v (strictly_inside_lies_on _ _ inside_)) as on_v.
      assert (equal_inside : forall u, equal_vectors v u -> strictly_inside u t).
      { intros u [X Y]. destruct inside_ as (k & range & kx & ky). exists k. rewrite <- X, <- Y. tauto. }
      destruct (inside_or_end v e on_v) as [inside_e | [equal | equal]].
      + destruct (has v V inside_e) as (u & U & equal). apply (clear_ u); [tauto | now apply equal_inside].
      + apply (clear_ (source e)); [tauto |]. apply equal_inside. now symmetry.
      + apply (clear_ (target e)); [tauto |]. apply equal_inside. now symmetry. }
  assert (edge_of_s : forall t, In t (region_edges s) -> nonzero (along t) /\ In (source t) (concat r) /\
    forall v, In v (concat r) -> ~ strictly_inside v t).
  { intros t T. rewrite edges_are in T. apply in_flat_map in T. destruct T as (e & E & T).
    destruct (each e E) as [all _]. destruct (all t T) as (? & _ & ?). tauto. }
  assert (pairs : ForallOrdPairs (fun t u => forall w, lies_on w t -> lies_on w u -> is_vertex w s) (region_edges s)).
  { rewrite edges_are. apply (pairs_of_lists (fun t u => forall w, lies_on w t -> lies_on w u -> is_vertex w r)).
    - intros e E. now apply each.
    - intros e f E F meet_ t u T U w on_t on_u. destruct (meet_ w) as (g & G & equal).
      + now apply (proj1 (each e E) t T).
      + now apply (proj1 (each f F) u U).
      + apply (is_vertex_of_s (source g)); [apply vertices; now exists g | exact equal].
    - apply pairs_by_position. intros earlier t later u is_ U w. now apply (meet earlier t later u w). }
  assert (clear_ : forall t, In t (region_edges s) -> forall w, strictly_inside w t -> ~ is_vertex w s).
  { intros t T w (k & range & X & Y) (u & U & ex & ey). apply (proj2 (proj2 (edge_of_s t T)) (source u)).
    - now apply edge_of_s.
    - exists k. rewrite <- ex, <- ey. tauto. }
  assert (meet_s : edges_meet_in_vertices s).
  { intros earlier t later u w is_ U. rewrite is_ in pairs. revert w.
    refine (pair_at_position (fun t u => forall w, lies_on w t -> lies_on w u -> is_vertex w s) t u later earlier _
      pairs U).
    intros a b R w on_b on_a. now apply R. }
  assert (off_r : forall y, off y (region_edges s) -> off y (region_edges r)).
  { intros y free u U on. destruct (divided_region r y) as [same _].
    destruct (proj2 same) as (t & T & on_t); [now exists u | exact (free t T on_t)]. }
  split; [split; [| split; [| exact meet_s]] |].
  - apply edges_are_no_points. intros t T. now apply edge_of_s.
  - intros y free. destruct (divided_region r y) as [_ number_is]. fold s in number_is. rewrite number_is. auto.
  - split; [| exact clear_]. intros y free. destruct (divided_region r y) as [_ number_is]. fold s in number_is.
    rewrite number_is. auto.
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
  set (h := fun v => vector_of (homogeneous (as_point v))).
  assert (same : forall v, equal_vectors (h v) v).
  { intros v. unfold h. rewrite (homogeneous_is (as_point v)). split; reflexivity. }
  assert (is_image : as_region (as_polygonal s) = map (map h) s).
  { unfold as_region, as_polygonal. rewrite map_map. apply map_ext. intros c. now rewrite map_map. }
  change (prepared_region r) with (as_polygonal s). rewrite is_image.
  intros t T w (k & range & X & Y) (u & U & ux & uy). rewrite edges_of_images in T, U.
  apply in_map_iff in T, U. destruct T as (t' & <- & T), U as (u' & <- & U). unfold moved_ends in *. cbn [source
    target] in *.
  destruct (same (source t')) as [ax ay], (same (target t')) as [bx by_], (same (source u')) as [cx cy].
  apply (clear_ t' T w); [exists k | exists u'; split; [exact U |]]; [rewrite <- ax, <- ay, <- bx, <- by_; tauto |].
  split; lra.
Qed.
