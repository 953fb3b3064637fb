(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* What inner_fit_program.v returns are the placements. With coordinates of at most m, the frame is the square of 5 m,
   and placements are in the square of 2 m. In the square of 3 m, b does not come to the frame, so all that is not in
   the open sum there is a placement; chains, edges and points of its boundary are in the square of 2 m, or not in
   that of 3 m. Around what is in the smaller square the chains outside go once. *)
From Coq Require Import QArith Qabs Qminmax Lqa ZArith Lia Bool List Permutation.
From Oplus Require Import specification checker regions_and_sums homogeneous_points specification_bridge pieces
  winding_number_of_the_sum collision_is_complete placed_collision sum_program sum_is_right sum_of_uncovered_pieces
    coordinates open_sum_program
  open_sums turned_chains inner_fit_program complement_in_a_frame.
Import ListNotations.

Open Scope Q_scope.

Lemma the_larger_is (a b : Q) : a <= the_larger a b /\ b <= the_larger a b.
Proof. unfold the_larger. rewrite <- at_most_is. destruct (at_most_spec a b); lra. Qed.

Lemma size_is_large (points : list vector) :
  1 <= size_of points /\ forall v, In v points -> in_square (size_of points) v.
Proof.
  induction points as [| w points [large all]]; [split; [cbn; lra | intros v []] |]. cbn [size_of fold_right].
  fold (size_of points). set (size := size_of points) in *.
  destruct (the_larger_is (Qabs (vx w)) (the_larger (Qabs (vy w)) size)), (the_larger_is (Qabs (vy w)) size).
  set (k := the_larger (Qabs (vx w)) _) in *. split; [lra |]. intros v [-> | I].
  - pose proof (abs_bounds (vx v)). pose proof (abs_bounds (vy v)). split; lra.
  - apply (in_larger_square size); [lra | now apply all].
Qed.

Lemma edges_in_square (r : region) (k : Q) : (forall v, In v (concat r) -> in_square k v) ->
  forall e, In e (region_edges r) -> in_square k (source e) /\ in_square k (target e).
Proof.
  intros all e E. apply in_flat_map in E. destruct E as (c & C & E). destruct (ends_of_edges c e E).
  split; apply all, in_concat; now exists c.
Qed.

(* What holds at one end of an edge and at the other, holds at all vertices of a chain or at none. *)
Lemma alike_along_a_chain (A : vector -> Prop) (c : list vector) :
  (forall e, In e (edges c) -> A (source e) <-> A (target e)) ->
  forall e, In e (edges c) -> (A (source e) <-> A (hd nowhere c)).
Proof.
  destruct c as [| first rest]; [intros _ e [] |]. rewrite edges_are_consecutive. cbn [hd app].
  generalize (rest ++ [first]). intros l. revert first. clear rest.
  induction l as [| u l IH]; intros v alike e E; [destruct E |]. destruct E as [<- | E]; [reflexivity |].
  rewrite (IH u (fun f F => alike f (or_intror F)) e E). symmetry. exact (alike _ (or_introl eq_refl)).
Qed.

(* Inner points of regions whose vertices are written in another way. *)
Lemma inner_point_of_chains (x : point) (r : region) : is_inner_point x (as_polygonal r) <->
  winding_number (as_vector x) (region_edges r) <> 0%Z /\ off (as_vector x) (region_edges r).
Proof.
  destruct (chains_as_points (as_vector x) r) as [same_points same_number].
  unfold as_polygonal. now rewrite inner_point_is, !off_is, same_points, same_number.
Qed.

Lemma equal_inner_points (x y : point) (r : polygonal_region) : equal_points x y -> is_inner_point x r ->
  is_inner_point y r.
Proof.
  intros [X Y]. rewrite !inner_point_is. intros [round free]. split.
  - now rewrite <- (winding_number_of_equal (as_vector x) (as_vector y) _ X Y).
  - apply (off_equal (as_vector x)); [now split | exact free].
Qed.

Lemma inner_points_of_half_turned (z : point) (b : polygonal_region) :
  is_inner_point z (as_polygonal (half_turned (as_region b))) <-> is_inner_point (Point (0 - x_of z) (0 - y_of z)) b.
Proof.
  rewrite inner_point_of_chains, inner_point_is. unfold half_turned. rewrite off_placed.
  change (as_vector (Point _ _)) with (minus (Vector 0 0) (as_vector z)).
  split; intros [round free]; (split; [| exact free]); now rewrite winding_number_of_placed in *.
Qed.

(* The open sum with -b has the places where b overlaps a. *)
Lemma overlaps_by_open_sum (a b : polygonal_region) (s : open_region) :
  is_open_sum a (as_polygonal (half_turned (as_region b))) s -> is_no_fit a b s.
Proof.
  intros open x. rewrite (open x).
  split; intros (y & z & in_a & in_b & equal); exists y, (Point (0 - x_of z) (0 - y_of z));
    (split; [exact in_a |]; split; [| by_computing]); [now apply inner_points_of_half_turned |].
  apply inner_points_of_half_turned. apply (equal_inner_points z); [by_computing | exact in_b].
Qed.

Lemma valid_goes_round_once (r : region) (x : vector) : valid_region r -> nowhere_above_one r ->
  off x (region_edges r) -> winding_number x (region_edges r) = 0%Z \/ winding_number x (region_edges r) = 1%Z.
Proof.
  intros (_ & not_negative & _) simple free. pose proof (not_negative x free). pose proof (simple x free). lia.
Qed.

Lemma equal_members (x y : point) (r : polygonal_region) : equal_points x y -> member x r -> member y r.
Proof.
  intros [X Y]. rewrite !member_by_edges. intros [(e & E & on) | round].
  - left. exists e. split; [exact E |]. apply (lies_on_equal (as_vector x)); [now split | exact on].
  - right. now rewrite <- (winding_number_of_equal (as_vector x) (as_vector y) _ X Y).
Qed.

Lemma member_dec (x : point) (r : polygonal_region) : member x r \/ ~ member x r.
Proof.
  rewrite member_by_edges. destruct (on_or_off (as_vector x) (region_edges (as_region r))) as [on | free]; [tauto |].
  rewrite off_is in free. destruct (Z.eq_dec (winding_number (as_vector x) (region_edges (as_region r))) 0); tauto.
Qed.

Lemma one_of_or_none {A : Type} (P : A -> Prop) (l : list A) : (forall a, {P a} + {~ P a}) ->
  (exists a, In a l /\ P a) \/ forall a, In a l -> ~ P a.
Proof.
  intros decided. destruct (Exists_dec P l decided) as [some | none]; [left; now apply Exists_exists | right].
  intros a I holds. apply none, Exists_exists. now exists a.
Qed.

Definition as_vectors (r : polygonal_region) : region := map (map as_vector) r.

Section InnerFit.
  Variables a b : polygonal_region.
  Variable m : Q.
  Variable s : open_region.
  Hypothesis large : 1 <= m.
  Hypothesis a_fits : forall v, In v (concat (as_region a)) -> in_square m v.
  Hypothesis b_fits : forall v, In v (concat (as_region b)) -> in_square m v.
  Hypothesis b_some : exists v, In v (concat (as_region b)).
  Hypothesis a_once : forall x, off x (region_edges (as_region a)) ->
    winding_number x (region_edges (as_region a)) = 0%Z \/ winding_number x (region_edges (as_region a)) = 1%Z.
  Hypothesis b_regular : forall y radius, member y b -> 0 < radius ->
    exists z, within radius (as_vector y) (as_vector z) /\ is_inner_point z b.
  Let outside := complement_in_frame (5 * m) (as_region a).
  Hypothesis is_open : is_no_fit (as_polygonal outside) b s.
  Let chains := as_region (open_chains s).
  Hypothesis chains_go_round_once : forall x, off x (region_edges chains) ->
    winding_number x (region_edges chains) = 0%Z \/ winding_number x (region_edges chains) = 1%Z.

  Definition is_placement (x : point) : Prop := forall y, member y b -> member (sum_of_points x y) a.

  Lemma members_are_in_the_square (r : polygonal_region) (k : Q) (x : point) :
    (forall v, In v (concat (as_region r)) -> in_square k v) -> member x r -> in_square k (as_vector x).
  Proof.
    intros all in_r. pose proof (edges_in_square _ _ all) as ends. apply member_by_edges in in_r.
    destruct in_r as [(e & E & on) | round].
    - destruct (ends e E). now apply (squares_are_convex k e).
    - destruct (is_in_square_spec k (as_vector x)) as [| out]; [assumption | exfalso]. apply round.
      now apply (nothing_goes_round_outside k); [apply region_cycles | |].
  Qed.

  (* Inner points of the outside are outside; and what is not inside, and not at the frame, is one. *)
  Lemma outside_is (x : point) : in_square (4 * m) (as_vector x) ->
    (is_inner_point x (as_polygonal outside) <-> ~ member x a).
  Proof.
    intros [in_x in_y]. rewrite inner_point_of_chains, member_by_edges. unfold outside.
    change (region_edges (complement_in_frame (5 * m) (as_region a)))
      with (edges (frame (5 * m)) ++ region_edges (map turned_chain (as_region a))).
    rewrite number_of_both, winding_number_of_turned, frame_goes_round by lra.
    pose proof (off_the_frame (5 * m) (as_vector x) ltac:(lra) ltac:(lra)) as free_frame.
    assert (same : off (as_vector x) (edges (frame (5 * m)) ++ region_edges (map turned_chain (as_region a))) <->
      off (as_vector x) (region_edges (as_region a))).
    { rewrite (off_is _ (region_edges (as_region a))), <- on_turned, <- off_is. split; intros free e E.
      - apply free, in_app_iff. now right.
      - apply in_app_iff in E. destruct E as [E | E]; [now apply free_frame | now apply free]. }
    rewrite same. pose proof (a_once (as_vector x)) as once. rewrite off_is in *.
    destruct (Z.eq_dec (winding_number (as_vector x) (region_edges (as_region a))) 0); [rewrite e; intuition lia |].
    split; [intros [round free] | tauto]. specialize (once free). lia.
  Qed.

  Lemma open_members_are_no_placements (x : point) : open_member x s -> ~ is_placement x.
  Proof.
    intros open placement. apply is_open in open. destruct open as (y & z & in_y & in_z & equal).
    assert (in_a : member y a).
    { apply (equal_members (sum_of_points x z)); [by_computing |]. apply placement, member_by_edges. right.
      now apply inner_point_is in in_z. }
    apply outside_is in in_y; [contradiction |].
    apply (in_larger_square m); [lra | now apply (members_are_in_the_square a)].
  Qed.

  (* Where b does not come to the frame. *)
  Lemma open_by_a_point (x y : point) : in_square (3 * m) (as_vector x) -> member y b ->
    ~ member (sum_of_points x y) a -> open_member x s.
  Proof.
    intros close in_b out. apply is_open. pose proof (members_are_in_the_square b m y b_fits in_b) as in_y.
    apply outside_is in out; [| unfold in_square in *; to_coordinates; lra].
    apply inner_point_of_chains in out. destruct out as [round free].
    destruct (winding_number_near _ _ (region_cycles outside) free) as (radius & R & near).
    destruct (b_regular y radius in_b R) as (y' & near_y & inner_y).
    exists (sum_of_points x y'), y'. split; [| split; [exact inner_y | by_computing]].
    apply inner_point_of_chains. destruct (near (as_vector (sum_of_points x y'))) as [free' same_];
      [by_computing | split; [congruence | exact free']].
  Qed.

  Lemma others_are_placements (x : point) : in_square (3 * m) (as_vector x) -> ~ open_member x s -> is_placement x.
  Proof.
    intros close not_open y in_b. destruct (member_dec (sum_of_points x y) a) as [| out]; [assumption | exfalso].
    now apply not_open, (open_by_a_point x y).
  Qed.

  Lemma some_point_of_b : exists v, member v b /\ in_square m (as_vector v).
  Proof.
    destruct b_some as (v & V). exists (as_point v). rewrite member_by_edges, as_vector_of_point.
    split; [left | now apply b_fits]. apply in_concat in V. destruct V as (c & C & V).
    destruct (edge_from_vertex c v V) as (e & E & <-). exists e. split; [apply in_flat_map; now exists c |].
    apply source_lies_on.
  Qed.

  Lemma placements_are_close (x : point) : is_placement x -> in_square (2 * m) (as_vector x).
  Proof.
    intros placement. destruct some_point_of_b as (v & in_b & in_v).
    pose proof (members_are_in_the_square a m _ a_fits (placement _ in_b)) as in_a.
    unfold in_square in *. to_coordinates. lra.
  Qed.

  (* What is not open is in the smaller square, or not in the larger one. *)
  Lemma not_open_is_close (w : vector) : ~ open_member (as_point w) s -> in_square (3 * m) w -> in_square (2 * m) w.
  Proof. intros not_open close. now apply (placements_are_close (as_point w)), others_are_placements. Qed.

  (* So what has no points of the open set, and a point in the one, is in the other. *)
  Lemma stays_in_the_square (e : segment) (u v : vector) : (forall w, lies_on w e -> ~ open_member (as_point w) s) ->
    lies_on u e -> lies_on v e -> in_square (3 * m) u -> in_square (2 * m) v.
  Proof.
    intros not_open on_u on_v close. destruct (some_steps m u v) as (n & steps); [lra |].
    apply (stays_in_steps (in_square (2 * m)) m n u v steps); [| now apply not_open_is_close; [apply not_open |]].
    intros w y W Y near in_w. apply not_open_is_close; [apply not_open; now apply (common_part e u v) |].
    unfold in_square, within in *. lra.
  Qed.

  Lemma chains_are_not_open (e : segment) (w : vector) : In e (region_edges chains) -> lies_on w e ->
    ~ open_member (as_point w) s.
  Proof. intros E on [inner _]. apply inner_point_is in inner. exact (proj2 inner e E on). Qed.

  Lemma dangling_edges_are_not_open (e : edge) (w : vector) : In e (dangling_edges s) ->
    lies_on w (ends_of e) -> ~ open_member (as_point w) s.
  Proof. intros E on (_ & free & _). exact (free e E on). Qed.

  (* A chain is in the smaller square, or none of its points are in the larger one. *)
  Lemma chain_is_in_or_out (c : list vector) (e : segment) (w : vector) : In c chains -> In e (edges c) ->
    lies_on w e ->
    (in_square (3 * m) w -> starts_in (2 * m) c = true) /\ (starts_in (2 * m) c = true -> in_square (2 * m) w).
  Proof.
    intros C E on.
    assert (stays : forall f u v, In f (edges c) -> lies_on u f -> lies_on v f -> in_square (3 * m) u ->
      in_square (2 * m) v).
    { intros f u v F. apply stays_in_the_square. intros y. apply chains_are_not_open, in_flat_map. now exists c. }
    assert (larger_ : forall v, in_square (2 * m) v -> in_square (3 * m) v) by (intros v; apply in_larger_square; lra).
    assert (starts : starts_in (2 * m) c = true <-> in_square (2 * m) (hd nowhere c)).
    { destruct c as [| v rest]; [destruct E |]. cbn. now destruct (is_in_square_spec (2 * m) v). }
    rewrite starts, <- (alike_along_a_chain (in_square (2 * m)) c) with (e := e); trivial.
    - split; intros in_; eapply (stays e); eauto using source_lies_on.
    - intros f F. split; intros in_; eapply (stays f); eauto using source_lies_on, target_lies_on.
  Qed.

  Let inner_chains := filter (starts_in (2 * m)) chains.
  Let outer_chains := filter (fun c => negb (starts_in (2 * m) c)) chains.

  Lemma inner_chains_are_among (e : segment) : In e (region_edges inner_chains) -> In e (region_edges chains).
  Proof. intros (c & [C _]%filter_In & E)%in_flat_map. apply in_flat_map. now exists c. Qed.

  Lemma number_of_inner_and_outer (x : vector) : winding_number x (region_edges chains) =
    (winding_number x (region_edges inner_chains) + winding_number x (region_edges outer_chains))%Z.
  Proof.
    unfold inner_chains, outer_chains, region_edges. generalize chains. intros r.
    induction r as [| c l IH]; [reflexivity |]. cbn [filter flat_map]. rewrite number_of_both, IH.
    destruct (starts_in (2 * m) c); cbn [negb flat_map]; rewrite number_of_both; lia.
  Qed.

  Lemma inner_chains_are_close (e : segment) (w : vector) : In e (region_edges inner_chains) -> lies_on w e ->
    in_square (2 * m) w.
  Proof.
    intros E on. apply in_flat_map in E. destruct E as (c & C & E). apply filter_In in C. destruct C as [C starts].
    now apply (chain_is_in_or_out c e).
  Qed.

  Lemma outer_chains_are_far (w : vector) : in_square (3 * m) w -> off w (region_edges outer_chains).
  Proof.
    intros close e E on. apply in_flat_map in E. destruct E as (c & C & E). apply filter_In in C. destruct C as [C far].
    now rewrite (proj1 (chain_is_in_or_out c e w C E on) close) in far.
  Qed.

  Lemma nothing_inside_goes_round_outside (x : vector) : ~ in_square (2 * m) x ->
    winding_number x (region_edges inner_chains) = 0%Z.
  Proof.
    apply (nothing_goes_round_outside (2 * m)); [apply region_cycles |].
    intros e E. split; apply (inner_chains_are_close e); trivial; [apply source_lies_on | apply target_lies_on].
  Qed.

  (* The outer chains go once round the smaller square. *)
  Lemma outer_chains_go_round (x : vector) : in_square (2 * m) x -> winding_number x (region_edges outer_chains) = 1%Z.
  Proof.
    intros close. set (y := Vector ((5 # 2) * m) 0).
    assert (in_y : in_square (3 * m) y) by (unfold in_square, y; cbn [vx vy]; lra).
    assert (far_y : ~ in_square (2 * m) y) by (unfold in_square, y; cbn [vx vy]; lra).
    pose proof (winding_number_along (Segment x y) (region_edges outer_chains) (region_cycles _)) as same_.
    cbn [source target] in same_. rewrite same_.
    2: { intros w on. apply outer_chains_are_far. apply (squares_are_convex (3 * m) (Segment x y)); trivial.
         apply (in_larger_square (2 * m)); [lra | exact close]. }
    assert (open : open_member (as_point y) s).
    { destruct some_point_of_b as (v & in_b & in_v). apply (open_by_a_point _ v); trivial.
      intros in_a. apply (members_are_in_the_square a m _ a_fits) in in_a.
      unfold in_square, y in *. to_coordinates. lra. }
    destruct open as [inner _]. apply inner_point_is in inner. rewrite as_vector_of_point in inner.
    fold chains in inner. destruct inner as [round free].
    pose proof (number_of_inner_and_outer y) as both. rewrite (nothing_inside_goes_round_outside y far_y) in both.
    destruct (chains_go_round_once y free); lia.
  Qed.

  (* Theorem. *)
  Theorem placements_are_the_inner_fit : is_inner_fit a b (placements_in (2 * m) s).
  Proof.
    intros x. unfold fits, placements_in. cbn [fit_chains fit_edges fit_points].
    rewrite member_of_chains, on_turned, winding_number_of_turned. fold chains inner_chains.
    setoid_rewrite filter_In.
    assert (in_is : forall v, is_in_square (2 * m) v = true <-> in_square (2 * m) v)
      by (intros v; now destruct (is_in_square_spec (2 * m) v)).
    setoid_rewrite in_is. pose proof (number_of_inner_and_outer (as_vector x)) as both.
    assert (larger_ : forall v, in_square (2 * m) v -> in_square (3 * m) v) by (intros v; apply in_larger_square; lra).
    assert (point_is : x = as_point (as_vector x)) by now destruct x.
    split.
    - assert (enough : in_square (2 * m) (as_vector x) -> ~ open_member x s -> is_placement x)
        by (intros close; apply others_are_placements; auto).
      intros [[(e & E & on) | round] | [(e & (E & close) & on) | (v & (V & close) & equal)]]; apply enough.
      + now apply (inner_chains_are_close e).
      + rewrite point_is. apply (chains_are_not_open e); [| exact on]. apply in_flat_map in E.
        destruct E as (c & C & E). apply filter_In in C. apply in_flat_map. now exists c.
      + destruct (is_in_square_spec (2 * m) (as_vector x)) as [| far]; [assumption | exfalso].
        rewrite (nothing_inside_goes_round_outside _ far) in round. now apply round.
      + intros [inner _]. apply inner_point_is in inner. fold chains in inner. destruct inner as [some free].
        destruct (is_in_square_spec (2 * m) (as_vector x)) as [close | far].
        * rewrite (outer_chains_go_round _ close) in both. destruct (chains_go_round_once _ free); lia.
        * rewrite (nothing_inside_goes_round_outside _ far) in round. now apply round.
      + apply (stays_in_the_square (ends_of e) (as_vector (fst e))); auto using (source_lies_on (ends_of e)).
        intros w. now apply dangling_edges_are_not_open.
      + rewrite point_is. now apply (dangling_edges_are_not_open e).
      + unfold in_square in *. clear - close equal. to_coordinates. lra.
      + intros (_ & _ & free). exact (free v V equal).
    - intros placement. pose proof (placements_are_close x placement) as close.
      assert (not_open : ~ open_member x s) by (intros open; exact (open_members_are_no_placements x open placement)).
      destruct (on_or_off (as_vector x) (region_edges inner_chains)) as [on | free_inner]; [tauto |].
      rewrite (outer_chains_go_round _ close) in both.
      destruct (Z.eq_dec (winding_number (as_vector x) (region_edges inner_chains)) 0) as [zero_ |];
        [right | left; right; lia].
      destruct (one_of_or_none (is_on x) (dangling_edges s)) as [(e & E & on) | none].
      { intros e. exact (lies_on_dec (as_vector x) (ends_of e)). }
      + left. exists e. split; [split; [exact E |] | exact on].
        apply (stays_in_the_square (ends_of e) (as_vector x)); auto using (source_lies_on (ends_of e)).
        intros w. now apply dangling_edges_are_not_open.
      + destruct (one_of_or_none (equal_points x) (isolated_points s)) as [(v & V & equal) | none'].
        { intros v. destruct (same_point_spec (as_vector x) (as_vector v)); [now left | now right]. }
        * right. exists v. split; [split; [exact V |] | exact equal].
          unfold in_square in *. clear - close equal. to_coordinates. lra.
        * exfalso. apply not_open. split; [| split; [exact none | exact none']]. apply inner_point_is. fold chains.
          split; [lia |]. intros f F on. apply in_flat_map in F. destruct F as (c & C & F).
          apply (free_inner f); [| exact on]. apply in_flat_map. exists c. split; [| exact F]. apply filter_In.
          split; [exact C |]. now apply (chain_is_in_or_out c f (as_vector x)); auto.
  Qed.

  Lemma fit_chains_are : as_vectors (fit_chains (placements_in (2 * m) s)) = map turned_chain inner_chains.
  Proof.
    cbn [placements_in fit_chains]. unfold as_vectors. rewrite map_map. etransitivity; [| apply map_id]. apply map_ext.
    intros c. rewrite map_map. etransitivity; [| apply map_id]. apply map_ext. exact as_vector_of_point.
  Qed.

  Hypothesis chains_region : valid_region chains.
  Hypothesis chains_simple : nowhere_above_one chains.

  Lemma edges_of_the_fit_are_long (t : segment) :
    In t (region_edges (as_vectors (fit_chains (placements_in (2 * m) s)))) -> nonzero (along t).
  Proof.
    rewrite fit_chains_are. intros T. apply (Permutation_in _ (region_edges_of_turned _)), in_map_iff in T.
    destruct T as (e & <- & E). destruct chains_region as (long & _).
    pose proof (region_edges_are_directions _ long e (inner_chains_are_among e E)) as e_long.
    intros [X Y]. apply e_long. by_computing.
  Qed.

  (* Theorem. Near each point of the chains, the placements have inner points: edges of the chains are beside them. *)
  Theorem chains_of_the_fit_are_regular (x : point) : member x (fit_chains (placements_in (2 * m) s)) ->
    closure (interior is_placement) x.
  Proof.
    intros in_chains radius R. pose proof in_chains as on_or_round. unfold placements_in in on_or_round.
    cbn [fit_chains] in on_or_round. rewrite member_of_chains, on_turned in on_or_round.
    destruct (on_or_off (as_vector x) (region_edges inner_chains)) as [(e & E & on) | free].
    - pose proof (inner_chains_are_close e _ E on) as close_x.
      destruct (outside_is_near chains (as_vector x) e (Qmin radius (1 # 2)) chains_region chains_simple
        (inner_chains_are_among e E) on) as (y & close & free & zero_); [apply Q.min_glb_lt; lra |].
      pose proof (Q.le_min_r radius (1 # 2)).
      exists (as_point y). split; [exact (within_smaller _ _ (as_vector x) y (Q.le_min_l radius (1 # 2)) close) |].
      destruct (winding_number_near y _ (region_cycles chains) free) as (inner & I & same_).
      exists (Qmin inner (1 # 2)). split; [apply Q.min_glb_lt; lra |]. intros z close_z.
      pose proof (Q.le_min_r inner (1 # 2)).
      apply others_are_placements; [unfold in_square, is_near, within in *; to_coordinates; lra |].
      intros [[round _]%inner_point_is _]. apply round.
      destruct (same_ (as_vector z) (within_smaller _ _ y (as_vector z) (Q.le_min_l inner
        (1 # 2)) close_z)) as [_ same].
      exact (eq_trans same zero_).
    - destruct on_or_round as [(e & E & on) | round]; [destruct (free e E on) |].
      assert (free' : off (as_vector x) (region_edges (map turned_chain inner_chains)))
        by (rewrite off_is, on_turned, <- off_is; exact free).
      destruct (winding_number_near _ _ (region_cycles _) free') as (inner & I & same_).
      exists x. split; [unfold is_near; lra |]. exists inner. split; [exact I |]. intros z close_z.
      refine (proj1 (placements_are_the_inner_fit z) _). left. unfold placements_in. cbn [fit_chains].
      rewrite member_of_chains. right.
      destruct (same_ (as_vector z) close_z) as [_ same]. exact (fun zero_ => round (eq_trans (eq_sym same) zero_)).
  Qed.
End InnerFit.

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
  is_inner_fit a b (inner_fit a b) /\
  (forall t, In t (region_edges (as_vectors (fit_chains (inner_fit a b)))) -> nonzero (along t)) /\
  forall x, member x (fit_chains (inner_fit a b)) -> closure (interior (is_placement a b)) x.
Proof.
  intros a_region a_simple b_region b_simple (c & v & C & V). unfold inner_fit. set (size := size_of _).
  destruct (size_is_large (concat (as_region a) ++ concat (as_region b))) as [large all]. fold size in large, all.
  assert (a_fits : forall w, In w (concat (as_region a)) -> in_square size w)
    by (intros w W; apply all, in_app_iff; now left).
  destruct (complement_is_valid (as_region a) size (5 * size)) as [p_region p_simple]; trivial;
    [lra | lra | now apply edges_in_square |].
  destruct (polygonal_is_valid _ p_region p_simple), (half_turned_is_valid _ b_region b_simple).
  assert (b_fits : forall w, In w (concat (as_region b)) -> in_square size w)
    by (intros w W; apply all, in_app_iff; now right).
  assert (b_some : exists w, In w (concat (as_region b))).
  { exists (vector_of (homogeneous v)). apply in_concat. exists (map (fun p => vector_of (homogeneous p)) c).
    split; [unfold as_region; now apply in_map | now apply (in_map (fun p => vector_of (homogeneous p)))]. }
  set (p := as_polygonal (complement_in_frame (5 * size) (as_region a))) in *.
  set (q := as_polygonal (half_turned (as_region b))) in *.
  assert (is_open : is_no_fit p b (open_sum_of_regions p q))
    by now apply overlaps_by_open_sum, open_sum_of_regions_is_the_open_sum.
  destruct (quick_sum_is_valid p q) as [s_region s_simple]; trivial.
  assert (b_regular : forall y radius, member y b -> 0 < radius ->
    exists z, within radius (as_vector y) (as_vector z) /\ is_inner_point z b).
  { intros y radius in_b R. apply (member_of_region y b b_region) in in_b.
    destruct (inside_near _ _ radius (valid_is_regular _ b_region) in_b R) as (z & close & inner_z).
    exists (as_point z). split; [exact close | now apply inner_point_of_valid]. }
  assert (a_once : forall x, off x (region_edges (as_region a)) ->
    winding_number x (region_edges (as_region a)) = 0%Z \/ winding_number x (region_edges (as_region a)) = 1%Z)
    by (intros x; now apply valid_goes_round_once).
  assert (s_once : forall x, off x (region_edges (as_region (open_chains (open_sum_of_regions p q)))) ->
    winding_number x (region_edges (as_region (open_chains (open_sum_of_regions p q)))) = 0%Z \/
    winding_number x (region_edges (as_region (open_chains (open_sum_of_regions p q)))) = 1%Z)
    by (intros x; now apply valid_goes_round_once).
  split; [| split]; [now apply placements_are_the_inner_fit | now apply edges_of_the_fit_are_long |
    now apply chains_of_the_fit_are_regular].
Qed.

(* Theorem. And what no_fit returns are those where they overlap. *)
Theorem no_fit_is_the_no_fit (a b : polygonal_region) :
  valid_region (as_region a) -> nowhere_above_one (as_region a) ->
  valid_region (as_region b) -> nowhere_above_one (as_region b) -> is_no_fit a b (no_fit a b).
Proof.
  intros a_region a_simple b_region b_simple. destruct (half_turned_is_valid _ b_region b_simple).
  now apply overlaps_by_open_sum, open_sum_of_regions_is_the_open_sum.
Qed.
