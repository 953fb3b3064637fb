(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* What inner_fit_program.v returns are the placements. With coordinates of at most m, the frame is the square of 5 m,
   and placements are in the square of 2 m. In the square of 3 m, b does not come to the frame, so all that is not in
   the open sum there is a placement; chains, edges and points of its boundary are in the square of 2 m, or not in
   that of 3 m. Around what is in the smaller square the chains outside go once. *)
From Coq Require Import QArith Qabs Qminmax Lqa ZArith Lia Bool List Permutation.
From Oplus Require Import specification checker convolution signed_crossings convolution_winding regions
  meeting_of_segments winding_number_of_the_sum interiors_meet neighbourhoods left_of_an_edge beside_every_point
  theorem_4_2_1 location homogeneous_points specification_bridge pieces collision_is_complete placed_collision
  checked_collision sum_program sum_is_right sum_of_uncovered_pieces open_sum_program open_sums
    turned_chains
  inner_fit_program complement_in_a_frame walks.
Import ListNotations.

Open Scope Q_scope.

Lemma the_larger_is (a b : Q) : a <= the_larger a b /\ b <= the_larger a b.
Proof.
  unfold the_larger. destruct (Qle_bool a b) eqn:order.
  - apply Qle_bool_iff in order. lra.
  - assert (b <= a); [| lra]. apply Qnot_lt_le. intros less. apply not_true_iff_false in order. apply order,
    Qle_bool_iff. lra.
Qed.

Lemma size_is_large (points : list vector) :
  1 <= size_of points /\ forall v, In v points -> in_square (size_of points) v.
Proof.
  induction points as [| w points [large all]]; [split; [cbn; lra | intros v []] |]. cbn [size_of fold_right].
  fold (size_of points). set (size := size_of points) in *. clearbody size.
  destruct (the_larger_is (Qabs (vx w)) (the_larger (Qabs (vy w)) size)) as [x_low more].
  destruct (the_larger_is (Qabs (vy w)) size) as [y_low least].
  set (k := the_larger (Qabs (vx w)) (the_larger (Qabs (vy w)) size)) in *. clearbody k. split; [lra |]. intros v [->
    | I].
  - pose proof (abs_bounds (vx v)). pose proof (abs_bounds (vy v)). split; lra.
  - apply (in_larger_square size); [lra | now apply all].
Qed.

Lemma ends_are_vertices (r : region) (s : segment) : In s (region_edges r) ->
  In (source s) (concat r) /\ In (target s) (concat r).
Proof.
  intros S. apply in_flat_map in S. destruct S as (c & C & S).
  assert (ends : In (source s) c /\ In (target s) (rotated c)).
  { destruct (edges_ends c) as [sources targets].
    split; [rewrite <- sources | rewrite <- targets]; now apply in_map. }
  destruct ends as [source_in target_in]. split; apply in_concat; exists c; (split; [exact C |]); [exact source_in |].
  destruct c as [| v rest]; [destruct target_in |]. cbn [rotated] in target_in. apply in_app_iff in target_in.
  destruct target_in as [I | [<- | []]]; [now right | now left].
Qed.

(* Members and inner points of regions whose vertices are written in another way. *)
Lemma inner_point_of_chains (x : point) (r : region) :
  is_inner_point x (as_polygonal r) <->
  winding_number (as_vector x) (region_edges r) <> 0%Z /\ off (as_vector x) (region_edges r).
Proof.
  set (h := fun v => vector_of (homogeneous (as_point v))).
  assert (same : forall v, equal_vectors (h v) v).
  { intros v. unfold h. rewrite (homogeneous_is (as_point v)). split; reflexivity. }
  assert (edges_are : region_edges (as_region (as_polygonal r)) = map (moved_ends h) (region_edges r)).
  { unfold as_region, as_polygonal. rewrite map_map, <- edges_of_images. f_equal. apply map_ext. intros c.
    now rewrite map_map. }
  rewrite inner_point_is, edges_are, (winding_number_of_images h same).
  pose proof (on_images h same (as_vector x) (region_edges r)) as on_both. unfold off.
  split; intros [round free]; (split; [exact round |]); intros s S on.
  - destruct (proj2 on_both) as (t & T & on_t); [now exists s | exact (free t T on_t)].
  - destruct (proj1 on_both) as (t & T & on_t); [now exists s | exact (free t T on_t)].
Qed.

Lemma member_by_edges (x : point) (r : polygonal_region) :
  member x r <-> (exists s, In s (region_edges (as_region r)) /\ lies_on (as_vector x) s) \/
    winding_number (as_vector x) (region_edges (as_region r)) <> 0%Z.
Proof. unfold member. now rewrite on_boundary_is, number_of_region_is. Qed.

(* Whether x is on one of some edges, or one of some points. *)
Lemma on_one_or_none (x : point) (l : list edge) :
  (exists e, In e l /\ is_on x e) \/ forall e, In e l -> ~ is_on x e.
Proof.
  induction l as [| e l IH]; [right; intros e [] |].
  destruct (lies_on_dec (as_vector x) (Segment (as_vector (fst e)) (as_vector (snd e)))) as [on | off_];
    [left; exists e; split; [now left | exact on] |].
  destruct IH as [(f & F & on) | none]; [left; exists f; split; [now right | exact on] |].
  right. intros f [<- | F]; [exact off_ | now apply none].
Qed.

Lemma one_of_or_none (x : point) (l : list point) :
  (exists v, In v l /\ equal_points x v) \/ forall v, In v l -> ~ equal_points x v.
Proof.
  induction l as [| v l IH]; [right; intros v [] |].
  destruct (same_point_spec (as_vector x) (as_vector v)) as [equal | differ];
    [left; exists v; split; [now left | exact equal] |].
  destruct IH as [(u & U & equal) | none]; [left; exists u; split; [now right | exact equal] |].
  right. intros u [<- | U]; [exact differ | now apply none].
Qed.

Lemma half_turned_inner_point (b : polygonal_region) (z : point) : valid_region (as_region b) ->
( is_inner_point z (as_polygonal (half_turned (as_region b))) <->
  inside (minus (Vector 0 0) (as_vector z)) (as_region b)).
Proof.
  intros b_region. rewrite inner_point_of_chains. unfold half_turned. rewrite <- inside_placed. unfold inside.
  destruct (placed_is_valid (Vector 0 0) (as_region b) b_region) as (_ & not_negative & _).
  split; intros [round free]; split; trivial; [specialize (not_negative _ free) | specialize (not_negative _
    round)]; lia.
Qed.

Section InnerFit.
  Variables a b : polygonal_region.
  Variable m : Q.
  Variable s : open_region.
  Hypothesis large : 1 <= m.
  Hypothesis a_fits : forall v, In v (concat (as_region a)) -> in_square m v.
  Hypothesis b_fits : forall v, In v (concat (as_region b)) -> in_square m v.
  Hypothesis b_some : exists v, In v (concat (as_region b)).
  Hypothesis a_region : valid_region (as_region a).
  Hypothesis a_simple : nowhere_above_one (as_region a).
  Hypothesis b_region : valid_region (as_region b).
  Let outside := complement_in_frame (5 * m) (as_region a).
  Hypothesis is_open : is_open_sum (as_polygonal outside) (as_polygonal (half_turned (as_region b))) s.
  Let chains := as_region (open_chains s).
  Hypothesis chains_simple : forall x, off x (region_edges chains) ->
    winding_number x (region_edges chains) = 0%Z \/ winding_number x (region_edges chains) = 1%Z.

  Definition is_placement (x : point) : Prop := forall y, member y b -> member (sum_of_points x y) a.

  Lemma edges_in_square (r : region) (k : Q) : (forall v, In v (concat r) -> in_square k v) ->
    forall e, In e (region_edges r) -> in_square k (source e) /\ in_square k (target e).
  Proof. intros all e E. destruct (ends_are_vertices r e E). split; now apply all. Qed.

  Lemma members_are_in_the_square (r : polygonal_region) (k : Q) (x : point) :
    (forall v, In v (concat (as_region r)) -> in_square k v) -> member x r -> in_square k (as_vector x).
  Proof.
    intros all in_r. apply member_by_edges in in_r. destruct in_r as [(e & E & on) | round].
    - destruct (edges_in_square _ _ all e E). now apply (squares_are_convex k e).
    - destruct (is_in_square_spec k (as_vector x)) as [| out]; [assumption | exfalso]. apply round.
      apply (nothing_goes_round_outside k); [apply region_cycles | now apply edges_in_square | exact out].
  Qed.

  Lemma member_dec (x : point) (r : polygonal_region) : member x r \/ ~ member x r.
  Proof.
    rewrite member_by_edges. destruct (on_or_off (as_vector x) (region_edges (as_region r))) as [on | free]; [tauto |].
    destruct (Z.eq_dec (winding_number (as_vector x) (region_edges (as_region r))) 0) as [zero_ | round]; [| tauto].
    right. intros [(e & E & on) | round]; [exact (free e E on) | contradiction].
  Qed.

  (* Inner points of the outside are outside. *)
  Lemma edges_of_outside : region_edges outside = edges (frame (5 * m)) ++ region_edges (map turned_chain (as_region
    a)).
  Proof. reflexivity. Qed.

  Lemma outside_is_not_inside (x : point) : is_inner_point x (as_polygonal outside) -> ~ member x a.
  Proof.
    intros [round free]%inner_point_of_chains in_a.
    pose proof (members_are_in_the_square a m x a_fits in_a) as [in_x in_y].
    rewrite edges_of_outside, number_of_both, winding_number_of_turned in round.
    pose proof (frame_goes_round (5 * m) (as_vector x) ltac:(lra) ltac:(lra)) as once.
    apply member_by_edges in in_a. destruct in_a as [on | round_a].
    - apply on_turned in on. destruct on as (e & E & on). apply (free e); [| exact on].
      rewrite edges_of_outside. apply in_app_iff. now right.
    - assert (free_a : off (as_vector x) (region_edges (as_region a))).
      { intros e E on. destruct (proj2 (on_turned (as_vector x) (as_region a))) as (e' & E' & on'); [now exists e |].
        apply (free e'); [| exact on']. rewrite edges_of_outside. apply in_app_iff. now right. }
      pose proof (a_simple _ free_a). destruct a_region as (_ & not_negative & _).
      pose proof (not_negative _ free_a). lia.
  Qed.

  Lemma what_is_not_inside_is_outside (x : point) : in_square (4 * m) (as_vector x) -> ~ member x a ->
    is_inner_point x (as_polygonal outside).
  Proof.
    intros [in_x in_y] out. apply inner_point_of_chains. rewrite member_by_edges in out.
    pose proof (frame_goes_round (5 * m) (as_vector x) ltac:(lra) ltac:(lra)) as once.
    pose proof (off_the_frame (5 * m) (as_vector x) ltac:(lra) ltac:(lra)) as free.
    rewrite edges_of_outside, number_of_both, winding_number_of_turned, once. split.
    - destruct (Z.eq_dec (winding_number (as_vector x) (region_edges (as_region a))) 0); [lia | exfalso; tauto].
    - intros e E on. apply in_app_iff in E. destruct E as [E | E]; [exact (free e E on) |].
      apply out. left. apply on_turned. now exists e.
  Qed.

  Lemma equal_inner_points (x y : point) (r : polygonal_region) : equal_points x y -> is_inner_point x r ->
    is_inner_point y r.
  Proof.
    intros equal. rewrite !inner_point_is. intros [round free]. destruct equal as [X Y]. split.
    - now rewrite <- (winding_number_of_equal (as_vector x) (as_vector y) _ X Y).
    - apply (off_equal (as_vector x)); [now split | exact free].
  Qed.

  Lemma equal_members (x y : point) (r : polygonal_region) : equal_points x y -> member x r -> member y r.
  Proof.
    intros [X Y]. rewrite !member_by_edges. intros [(e & E & on) | round].
    - left. exists e. split; [exact E |]. apply (lies_on_equal (as_vector x)); [now split | exact on].
    - right. now rewrite <- (winding_number_of_equal (as_vector x) (as_vector y) _ X Y).
  Qed.

  Lemma open_members_are_no_placements (x : point) : open_member x s -> ~ is_placement x.
  Proof.
    intros open placement. apply is_open in open. destruct open as (w & z & in_w & in_z & [X Y]).
    apply (half_turned_inner_point b z b_region) in in_z. apply (outside_is_not_inside w in_w).
    set (y := Point (0 - x_of z) (0 - y_of z)).
    apply (equal_members (sum_of_points x y)).
    - unfold equal_points, sum_of_points, y in *; cbn [x_of y_of] in *. rewrite X, Y. split; ring.
    - apply placement, member_of_region; [exact b_region |]. left. now destruct in_z.
  Qed.

  (* Where b does not come to the frame. *)
  Lemma others_are_placements (x : point) : in_square (3 * m) (as_vector x) -> ~ open_member x s -> is_placement x.
  Proof.
    intros close not_open y in_b. destruct (member_dec (sum_of_points x y) a) as [| out]; [assumption | exfalso].
    apply not_open, is_open. pose proof (members_are_in_the_square b m y b_fits in_b) as in_y.
    assert (in_sum : in_square (4 * m) (as_vector (sum_of_points x y))).
    { unfold in_square, as_vector, sum_of_points in *; cbn [vx vy x_of y_of] in *. lra. }
    pose proof (what_is_not_inside_is_outside _ in_sum out) as inner. apply inner_point_of_chains in inner.
    destruct inner as [round free]. destruct (winding_number_near _ _ (region_cycles outside) free) as (radius & R &
      near).
    apply (member_of_region y b b_region) in in_b. destruct b_region as (b_edges & b_valid & b_meet).
    destruct (inside_near (as_region b) (as_vector y) radius (regions_are_regular _ b_edges b_valid b_meet) in_b R)
      as (y' & near_y & inner_y).
    exists (sum_of_points x (as_point y')), (Point (0 - vx y') (0 - vy y')). split; [| split].
    - apply inner_point_of_chains. destruct (near (as_vector (sum_of_points x (as_point y')))) as [free' same_].
      + unfold within, as_vector, sum_of_points, as_point in *; cbn [vx vy x_of y_of] in *. lra.
      + split; [congruence | exact free'].
    - apply half_turned_inner_point; [exact b_region |]. refine (inside_equal _ _ _ _ inner_y).
      unfold minus, as_vector; cbn [vx vy x_of y_of]. split; cbn [vx vy]; ring.
    - unfold equal_points, sum_of_points, as_point; cbn [x_of y_of]. split; ring.
  Qed.

  Lemma placements_are_close (x : point) : is_placement x -> in_square (2 * m) (as_vector x).
  Proof.
    intros placement. destruct b_some as (v & V).
    assert (in_b : member (as_point v) b).
    { apply member_by_edges. left. rewrite as_vector_of_point. apply in_concat in V. destruct V as (c & C & V).
      destruct (edges_ends c) as [sources _]. rewrite <- sources in V. apply in_map_iff in V. destruct V as (e & <- &
        E).
      exists e. split; [apply in_flat_map; now exists c | apply source_lies_on]. }
    pose proof (members_are_in_the_square a m _ a_fits (placement _ in_b)) as in_a. pose proof (b_fits v V) as in_v.
    unfold in_square, as_vector, sum_of_points, as_point in *; cbn [vx vy x_of y_of] in *. lra.
  Qed.

  (* What has no points of the open set, and a point in the smaller square, is in it. *)
  Lemma stays_in_the_square (e : segment) (u v : vector) :
    (forall x, lies_on (as_vector x) e -> ~ open_member x s) -> lies_on u e -> lies_on v e ->
    in_square (3 * m) u -> in_square (2 * m) v.
  Proof.
    intros not_open on_u on_v close.
    assert (in_u : in_square (2 * m) u).
    { rewrite <- (as_vector_of_point u). apply placements_are_close, others_are_placements;
        [now rewrite as_vector_of_point |]. apply not_open. now rewrite as_vector_of_point. }
    destruct (is_in_square_spec (2 * m) v) as [| out]; [assumption | exfalso].
    destruct (leaves_the_square u v m) as (w & on_w & close_w & far_w); [lra | exact in_u | exact out |].
    apply far_w. rewrite <- (as_vector_of_point w). apply placements_are_close, others_are_placements;
      [now rewrite as_vector_of_point |]. apply not_open. rewrite as_vector_of_point.
    now apply (contacts_that_stay.common_part e u v).
  Qed.

  Lemma chains_are_not_open (e : segment) (x : point) : In e (region_edges chains) -> lies_on (as_vector x) e ->
    ~ open_member x s.
  Proof. intros E on [inner _]. apply inner_point_is in inner. destruct inner as [_ free]. exact (free e E on). Qed.

  Lemma dangling_edges_are_not_open (e : edge) (x : point) : In e (dangling_edges s) -> is_on x e -> ~ open_member x s.
  Proof. intros E on (_ & free & _). exact (free e E on). Qed.

  (* All vertices of a chain are in the smaller square, or none. *)
  Lemma chain_is_in_or_out (c : list vector) (e : segment) (w : vector) : In c chains -> In e (edges c) -> lies_on w e
    ->
    in_square (3 * m) w -> starts_in (2 * m) c = true.
  Proof.
    intros C E on close. destruct c as [| first rest]; [destruct E |]. cbn [starts_in].
    destruct (is_in_square_spec (2 * m) first) as [| out]; [reflexivity | exfalso].
    assert (not_open : forall f, In f (edges (first :: rest)) -> forall x, lies_on (as_vector x) f -> ~ open_member x
      s).
    { intros f F x. apply chains_are_not_open. apply in_flat_map. now exists (first :: rest). }
    assert (all_out : forall f, In f (edges (first :: rest)) -> ~ in_square (2 * m) (source f)).
    { rewrite edges_are_consecutive in *. clear E on. cbn [app].
      assert (step : forall l v, (forall f, In f (consecutive (v :: l)) ->
          In f (consecutive (first :: rest ++ [first]))) -> ~ in_square (2 * m) v ->
        forall f, In f (consecutive (v :: l)) -> ~ in_square (2 * m) (source f)).
      { induction l as [| u l IH]; intros v among out_v f F; [destruct F |].
        change (consecutive (v :: u :: l)) with (Segment v u :: consecutive (u :: l)) in *.
        destruct F as [<- | F]; [exact out_v |]. apply (IH u); trivial.
        - intros g G. apply among. now right.
        - intros in_u. apply out_v. apply (stays_in_the_square (Segment v u) u v).
          + apply not_open, among. now left.
          + exact (target_lies_on (Segment v u)).
          + exact (source_lies_on (Segment v u)).
          + apply (in_larger_square (2 * m)); [lra | exact in_u]. }
      apply (step (rest ++ [first]) first); trivial. }
    apply (all_out e E). apply (stays_in_the_square e w); [now apply not_open | exact on | apply source_lies_on |
      exact close].
  Qed.

  Let inner_chains := filter (starts_in (2 * m)) chains.
  Let outer_chains := filter (fun c => negb (starts_in (2 * m) c)) chains.

  Lemma number_of_inner_and_outer (x : vector) :
    winding_number x (region_edges chains) =
    (winding_number x (region_edges inner_chains) + winding_number x (region_edges outer_chains))%Z.
  Proof.
    unfold inner_chains, outer_chains, region_edges. generalize chains. intros r. induction r as [| c l IH];
      [reflexivity |].
    cbn [filter flat_map]. rewrite number_of_both, IH.
    destruct (starts_in (2 * m) c); cbn [negb flat_map]; rewrite number_of_both; lia.
  Qed.

  Lemma inner_chains_are_close (e : segment) (w : vector) : In e (region_edges inner_chains) -> lies_on w e ->
    in_square (2 * m) w.
  Proof.
    intros E on. apply in_flat_map in E. destruct E as (c & C & E). apply filter_In in C. destruct C as [C starts].
    destruct c as [| first rest]; [discriminate |]. cbn [starts_in] in starts.
    destruct (is_in_square_spec (2 * m) first) as [in_first |]; [| discriminate].
    assert (not_open : forall f, In f (edges (first :: rest)) -> forall x, lies_on (as_vector x) f -> ~ open_member x
      s).
    { intros f F x. apply chains_are_not_open. apply in_flat_map. now exists (first :: rest). }
    assert (all_in : forall f, In f (edges (first :: rest)) -> in_square (2 * m) (source f)).
    { rewrite edges_are_consecutive in *. clear E.
      assert (step : forall l v, (forall f, In f (consecutive (v :: l)) ->
          In f (consecutive (first :: rest ++ [first]))) -> in_square (2 * m) v ->
        forall f, In f (consecutive (v :: l)) -> in_square (2 * m) (source f)).
      { induction l as [| u l IH]; intros v among in_v f F; [destruct F |].
        change (consecutive (v :: u :: l)) with (Segment v u :: consecutive (u :: l)) in *.
        destruct F as [<- | F]; [exact in_v |]. apply (IH u); trivial.
        - intros g G. apply among. now right.
        - apply (stays_in_the_square (Segment v u) v u).
          + apply not_open, among. now left.
          + exact (source_lies_on (Segment v u)).
          + exact (target_lies_on (Segment v u)).
          + apply (in_larger_square (2 * m)); [lra | exact in_v]. }
      apply (step (rest ++ [first]) first); trivial. }
    apply (stays_in_the_square e (source e) w); [now apply not_open | apply source_lies_on | exact on |].
    apply (in_larger_square (2 * m)); [lra | now apply all_in].
  Qed.

  Lemma outer_chains_are_far (w : vector) : in_square (3 * m) w -> off w (region_edges outer_chains).
  Proof.
    intros close e E on. apply in_flat_map in E. destruct E as (c & C & E). apply filter_In in C. destruct C as [C
      starts].
    rewrite (chain_is_in_or_out c e w C E on close) in starts. discriminate.
  Qed.

  Lemma nothing_inside_goes_round_outside (x : vector) : ~ in_square (2 * m) x ->
    winding_number x (region_edges inner_chains) = 0%Z.
  Proof.
    intros far. apply (nothing_goes_round_outside (2 * m)); [apply region_cycles | | exact far].
    intros e E. split; apply (inner_chains_are_close e); trivial; [apply source_lies_on | apply target_lies_on].
  Qed.

  Lemma open_member_dec (x : point) : open_member x s \/ ~ open_member x s.
  Proof.
    unfold open_member. rewrite inner_point_is.
    destruct (Z.eq_dec (winding_number (as_vector x) (region_edges (as_region (open_chains s)))) 0) as [zero_ | round];
      [right; tauto |].
    destruct (on_or_off (as_vector x) (region_edges (as_region (open_chains s)))) as [(e & E & on) | free];
      [right; intros ((_ & free) & _); exact (free e E on) |].
    destruct (on_one_or_none x (dangling_edges s)) as [(e & E & on) | none]; [right; intros (_ & free' & _); exact
      (free' e E on) |].
    destruct (one_of_or_none x (isolated_points s)) as [(v & V & equal) | none']; [right; intros (_ & _ & free');
      exact (free' v V equal) | tauto].
  Qed.

  (* The outer chains go once round the smaller square. *)
  Lemma outer_chains_go_round (x : vector) : in_square (2 * m) x ->
    winding_number x (region_edges outer_chains) = 1%Z.
  Proof.
    intros close. set (y := Vector ((5 # 2) * m) 0).
    assert (in_y : in_square (3 * m) y) by (unfold in_square, y; cbn [vx vy]; lra).
    assert (far_y : ~ in_square (2 * m) y) by (unfold in_square, y; cbn [vx vy]; lra).
    pose proof (winding_number_along (Segment x y) (region_edges outer_chains) (region_cycles _)) as same_.
    cbn [source target] in same_. rewrite same_.
    2: { intros w on. apply outer_chains_are_far. apply (squares_are_convex (3 * m) (Segment x y)); trivial.
         apply (in_larger_square (2 * m)); [lra | exact close]. }
    assert (open : open_member (as_point y) s).
    { destruct (open_member_dec (as_point y)) as [| not_]; [assumption | exfalso]. apply far_y.
      rewrite <- (as_vector_of_point y). apply placements_are_close, others_are_placements; [| exact not_].
      now rewrite as_vector_of_point. }
    destruct open as [inner _]. apply inner_point_is in inner. rewrite as_vector_of_point in inner.
    fold chains in inner. destruct inner as [round free].
    pose proof (number_of_inner_and_outer y) as both. rewrite (nothing_inside_goes_round_outside y far_y) in both.
    destruct (chains_simple y free); lia.
  Qed.

  (* Theorem. *)
  Theorem placements_are_the_inner_fit : is_inner_fit a b (placements_in (2 * m) s).
  Proof.
    intros x. unfold fits, placements_in. cbn [fit_chains fit_edges fit_points].
    rewrite member_of_chains, on_turned, winding_number_of_turned. fold chains inner_chains.
    assert (enough : in_square (2 * m) (as_vector x) -> ~ open_member x s -> is_placement x).
    { intros close not_open. apply others_are_placements; [| exact not_open].
      apply (in_larger_square (2 * m)); [lra | exact close]. }
    assert (among : forall e, In e (region_edges inner_chains) -> In e (region_edges chains)).
    { intros e E. apply in_flat_map in E. destruct E as (c & C & E). apply filter_In in C. apply in_flat_map. now
      exists c. }
    split.
    - intros [[(e & E & on) | round] | [(e & E & on) | (v & V & equal)]]; apply enough.
      + now apply (inner_chains_are_close e).
      + intros open. exact (chains_are_not_open e x (among e E) on open).
      + destruct (is_in_square_spec (2 * m) (as_vector x)) as [| far]; [assumption | exfalso].
        rewrite (nothing_inside_goes_round_outside _ far) in round. now apply round.
      + intros [inner _]. apply inner_point_is in inner. fold chains in inner. destruct inner as [some free].
        destruct (is_in_square_spec (2 * m) (as_vector x)) as [close | far].
        * pose proof (number_of_inner_and_outer (as_vector x)) as both. rewrite (outer_chains_go_round _ close) in both.
          destruct (chains_simple _ free); lia.
        * rewrite (nothing_inside_goes_round_outside _ far) in round. now apply round.
      + apply filter_In in E. destruct E as [E close].
        destruct (is_in_square_spec (2 * m) (as_vector (fst e))) as [in_ |]; [| discriminate].
        apply (stays_in_the_square (Segment (as_vector (fst e)) (as_vector (snd e))) (as_vector (fst e))).
        * intros y on_y. now apply (dangling_edges_are_not_open e).
        * exact (source_lies_on (Segment (as_vector (fst e)) (as_vector (snd e)))).
        * exact on.
        * apply (in_larger_square (2 * m)); [lra | exact in_].
      + apply filter_In in E. destruct E as [E _]. now apply (dangling_edges_are_not_open e).
      + apply filter_In in V. destruct V as [_ close]. destruct (is_in_square_spec (2 * m) (as_vector v)) as [in_ |];
        [| discriminate].
        destruct equal as [X Y]. unfold in_square, as_vector in *; cbn [vx vy] in *. lra.
      + apply filter_In in V. destruct V as [V _]. intros (_ & _ & free). exact (free v V equal).
    - intros placement. pose proof (placements_are_close x placement) as close.
      assert (not_open : ~ open_member x s) by (intros open; exact (open_members_are_no_placements x open placement)).
      assert (close_ : in_square (3 * m) (as_vector x)) by (apply (in_larger_square (2 * m)); [lra | exact close]).
      destruct (on_or_off (as_vector x) (region_edges inner_chains)) as [on | free_inner]; [left; now left |].
      pose proof (number_of_inner_and_outer (as_vector x)) as both. rewrite (outer_chains_go_round _ close) in both.
      destruct (Z.eq_dec (winding_number (as_vector x) (region_edges inner_chains)) 0) as [zero_ | round];
        [| left; right; lia].
      assert (free : off (as_vector x) (region_edges chains)).
      { intros e E on. apply in_flat_map in E. destruct E as (c & C & E).
        apply (free_inner e); [| exact on]. apply in_flat_map. exists c. split; [| exact E]. apply filter_In.
        split; [exact C |]. now apply (chain_is_in_or_out c e (as_vector x)). }
      right.
      destruct (on_one_or_none x (dangling_edges s)) as [(e & E & on) | none].
      + left. exists e. split; [| exact on]. apply filter_In. split; [exact E |].
        destruct (is_in_square_spec (2 * m) (as_vector (fst e))) as [| far]; [reflexivity | exfalso]. apply far.
        apply (stays_in_the_square (Segment (as_vector (fst e)) (as_vector (snd e))) (as_vector x)); trivial.
        * intros y on_y. now apply (dangling_edges_are_not_open e).
        * exact (source_lies_on (Segment (as_vector (fst e)) (as_vector (snd e)))).
      + right.
        destruct (one_of_or_none x (isolated_points s)) as [(v & V & equal) | none'].
        * exists v. split; [| exact equal]. apply filter_In. split; [exact V |].
          destruct (is_in_square_spec (2 * m) (as_vector v)) as [| far]; [reflexivity | exfalso]. apply far.
          destruct equal as [X Y]. unfold in_square, as_vector in *; cbn [vx vy] in *. lra.
        * exfalso. apply not_open. split; [| split; [exact none | exact none']]. apply inner_point_is. fold chains.
          split; [lia | exact free].
  Qed.
End InnerFit.

(* The winding numbers of a sum are 0 and 1. *)
Lemma sums_go_round_once (p q : polygonal_region) (x : vector) :
  valid_region (as_region p) -> valid_region (as_region q) ->
  winding_number x (region_edges (as_region (quick_sum p q))) = 0%Z \/
  winding_number x (region_edges (as_region (quick_sum p q))) = 1%Z.
Proof.
  intros p_region q_region. pose proof (quick_chains_are (as_region p) (as_region q) p_region q_region) as permuted.
  unfold quick_sum. cbv zeta in *. set (f := quick_filled _ _) in *.
  set (h := fun v => vector_of (homogeneous (as_point v))).
  assert (same : forall v, equal_vectors (h v) v).
  { intros v. unfold h. rewrite (homogeneous_is (as_point v)). split; reflexivity. }
  unfold as_region at 1 2. rewrite !map_map, (map_ext _ (map h)) by (intros c; now rewrite map_map).
  rewrite edges_of_images, (winding_number_of_images h same).
  rewrite (winding_number_of_chains (as_region p) (as_region q) _ p_region q_region permuted).
  destruct (0 <? _)%Z; tauto.
Qed.

Lemma half_turned_is_valid (b : region) : valid_region b -> nowhere_above_one b ->
  valid_region (as_region (as_polygonal (half_turned b))) /\
  nowhere_above_one (as_region (as_polygonal (half_turned b))).
Proof.
  intros valid simple. apply polygonal_is_valid; [now apply placed_is_valid | now apply placed_is_at_most_one].
Qed.

(* Theorem. What inner_fit returns are the places where b is inside a. *)
Theorem inner_fit_is_the_inner_fit (a b : polygonal_region) :
  valid_region (as_region a) -> nowhere_above_one (as_region a) ->
  valid_region (as_region b) -> nowhere_above_one (as_region b) -> (exists c v, In c b /\ In v c) ->
  is_inner_fit a b (inner_fit a b).
Proof.
  intros a_region a_simple b_region b_simple (c & v & C & V). unfold inner_fit. set (size := size_of _).
  destruct (size_is_large (concat (as_region a) ++ concat (as_region b))) as [large all]. fold size in large, all.
  assert (a_fits : forall w, In w (concat (as_region a)) -> in_square size w)
    by (intros w W; apply all, in_app_iff; now left).
  destruct (complement_is_valid (as_region a) size (5 * size)) as [p_region p_simple]; trivial; [lra | lra | |].
  { intros s S. destruct (ends_are_vertices (as_region a) s S). split; now apply a_fits. }
  destruct (polygonal_is_valid _ p_region p_simple), (half_turned_is_valid _ b_region b_simple).
  apply placements_are_the_inner_fit; trivial.
  - intros w W. apply all, in_app_iff. now right.
  - exists (vector_of (homogeneous v)). apply in_concat. exists (map (fun p => vector_of (homogeneous p)) c).
    split; [unfold as_region; now apply in_map | now apply (in_map (fun p => vector_of (homogeneous p)))].
  - now apply open_sum_of_regions_is_the_open_sum.
  - intros x _. now apply sums_go_round_once.
Qed.

(* Theorem. And what no_fit returns are those where they overlap. *)
Theorem no_fit_is_the_no_fit (a b : polygonal_region) :
  valid_region (as_region a) -> nowhere_above_one (as_region a) ->
  valid_region (as_region b) -> nowhere_above_one (as_region b) -> is_no_fit a b (no_fit a b).
Proof.
  intros a_region a_simple b_region b_simple x.
  destruct (half_turned_is_valid _ b_region b_simple) as [q_region q_simple].
  unfold no_fit. rewrite (open_sum_of_regions_is_the_open_sum a _ a_region q_region a_simple q_simple x). split.
  - intros (y & z & in_a & in_b & [X Y]). apply (half_turned_inner_point b z b_region) in in_b.
    exists y, (Point (0 - x_of z) (0 - y_of z)). split; [exact in_a |]. split.
    + apply inner_point_of_valid; [exact b_region | exact in_b].
    + unfold equal_points, sum_of_points in *; cbn [x_of y_of] in *. rewrite X, Y. split; ring.
  - intros (y & z & in_a & in_b & [X Y]). exists y, (Point (0 - x_of z) (0 - y_of z)). split; [exact in_a |]. split.
    + apply half_turned_inner_point; [exact b_region |]. apply (inner_point_of_valid z b b_region) in in_b.
      refine (inside_equal _ _ _ _ in_b). unfold minus, as_vector; split; cbn [vx vy x_of y_of]; ring.
    + unfold equal_points, sum_of_points in *; cbn [x_of y_of] in *. rewrite X, Y. split; ring.
Qed.
