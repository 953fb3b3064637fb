(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The theorem: what the checker of layouts (layout_checker.v) accepts is a layout, as specification.v says. Near each
   point of a region are points of it that are in no other one, since their pieces are apart (pieces_apart.v). So no
   point is an inner point of two parts; and no point of a part is off the container, with points outside all
   around. *)
From Coq Require Import NArith QArith Lqa ZArith Lia Bool List.
From Oplus Require Import regions specification checker direction angular_crossings winding_number signed_crossings
  neighbourhoods homogeneous_points specification_bridge fans pieces_cover sums_are_inside what_is_checked inner_sums
  sum_program sum_is_right coordinates turned_chains inner_fit_program complement_in_a_frame open_sums
  inner_fit_is_right layout_checker pieces_apart.
Import ListNotations.

Open Scope Q_scope.

(** Regions *)

Definition its_pieces (r : polygonal_region * region_certificate) : list piece := pieces_of_certificate (snd r).

Lemma certified_pieces (r : polygonal_region * region_certificate) :
  is_certified r = true -> Forall is_piece (its_pieces r).
Proof. intros certified. apply Forall_forall. exact (pieces_of_polygons_are_convex _ _ _ certified). Qed.

Definition regions_are_apart (r s : polygonal_region * region_certificate) : Prop :=
  forall t u, In t (its_pieces r) -> In u (its_pieces s) -> are_apart_by_a_line t u.

(* A point of the one has no square around it of points of the other. *)
Lemma not_all_around (r s : polygonal_region * region_certificate) (x : point) (radius : Q) :
  is_certified r = true -> is_certified s = true -> regions_are_apart r s -> member x (fst r) -> 0 < radius ->
  exists y, within radius (as_vector x) (as_vector y) /\ member y (fst r) /\ ~ member y (fst s).
Proof.
  intros r_certified s_certified apart in_r R.
  pose proof (certified_pieces r r_certified) as r_pieces. pose proof (certified_pieces s s_certified) as s_pieces.
  rewrite Forall_forall in r_pieces, s_pieces.
  destruct (region_is_in_pieces _ _ _ r_certified x in_r) as (t & T & in_t).
  destruct (strictly_in_near t (as_vector x) radius (r_pieces t T) in_t R) as (y & close & in_y).
  exists (as_point y). rewrite as_vector_of_point. split; [exact close |]. split.
  - apply (pieces_are_in_region _ _ _ r_certified (pieces_of_corners _) t); [exact T |]. rewrite as_vector_of_point.
    now apply strictly_in_is_inside.
  - intros in_s. destruct (region_is_in_pieces _ _ _ s_certified _ in_s) as (u & U & in_u).
    rewrite as_vector_of_point in in_u.
    exact (strictly_in_alone t u y (r_pieces t T) (s_pieces u U) (apart t u T U) in_y in_u).
Qed.

Lemma members_near_inner_points (x : point) (r : polygonal_region) : is_inner_point x r ->
  exists radius, 0 < radius /\ forall y, within radius (as_vector x) (as_vector y) -> member y r.
Proof.
  intros [round free]%inner_point_is.
  destruct (winding_number_near _ _ (region_cycles (as_region r)) free) as (radius & R & near).
  exists radius. split; [exact R |]. intros y close. apply member_by_edges. right. now rewrite (proj2 (near _ close)).
Qed.

Lemma no_common_inner_point (r s : polygonal_region * region_certificate) (x : point) :
  is_certified r = true -> is_certified s = true -> regions_are_apart r s ->
  ~ (is_inner_point x (fst r) /\ is_inner_point x (fst s)).
Proof.
  intros r_certified s_certified apart [[round _] in_s].
  destruct (members_near_inner_points x _ in_s) as (radius & R & near).
  destruct (not_all_around r s x radius r_certified s_certified apart) as (y & close & _ & out);
    [now right | exact R |].
  exact (out (near y close)).
Qed.

(* What is in the frame and not in the region has around it only points outside. *)
Lemma outside_in_frame (k : Q) (r : polygonal_region) (x : point) :
  - k < x_of x < k -> - k < y_of x < k -> ~ member x r ->
  is_inner_point x (as_polygonal (complement_in_frame k (as_region r))).
Proof.
  intros in_x in_y out. rewrite inner_point_of_chains. rewrite member_by_edges in out.
  change (region_edges (complement_in_frame k (as_region r)))
    with (edges (frame k) ++ region_edges (map turned_chain (as_region r))).
  assert (free : off (as_vector x) (region_edges (as_region r)))
    by (apply off_is; intros on; now apply out; left).
  rewrite number_of_both, winding_number_of_turned, frame_goes_round by trivial. split.
  - destruct (Z.eq_dec (winding_number (as_vector x) (region_edges (as_region r))) 0); [lia | exfalso; tauto].
  - intros e [E | E]%in_app_iff; [now apply (off_the_frame k) |]. revert e E.
    apply off_is. rewrite on_turned. now apply off_is.
Qed.

(** The whole *)

Lemma pairs_within_parts {Whole Part : Type} (related : Part -> Part -> Prop) (f : Whole -> list Part)
  (l : list Whole) : ForallOrdPairs related (flat_map f l) ->
  ForallOrdPairs (fun a b => forall c d, In c (f a) -> In d (f b) -> related c d) l.
Proof.
  induction l as [| a l IH]; cbn [flat_map]; intros pairs; [constructor |].
  assert (both : ForallOrdPairs related (flat_map f l) /\
    forall c d, In c (f a) -> In d (flat_map f l) -> related c d).
  { clear IH. induction (f a) as [| c k IH]; [split; [exact pairs | intros c d []] |].
    inversion_clear pairs as [| ? ? first_ rest]. destruct (IH rest) as [of_rest of_both]. split; [exact of_rest |].
    intros c' d [<- | C] E; [| now apply of_both]. rewrite Forall_forall in first_.
    apply first_, in_app_iff. now right. }
  destruct both as [of_rest of_both]. constructor; [| now apply IH]. apply Forall_forall. intros b B c d C E.
  apply of_both; [exact C | apply in_flat_map; now exists b].
Qed.

Lemma regions_with_certificates (regions : list polygonal_region) : forall certificates,
  map fst (with_certificates regions certificates) = regions.
Proof. induction regions as [| r l IH]; intros [| c rest]; cbn; now rewrite ?IH. Qed.

Lemma accepted_layout_regions (container : option polygonal_region) (parts : list polygonal_region)
  (c : layout_certificate) : accepts_layout container parts c = true -> exists regions,
  map fst regions = regions_of_layout container parts /\
  (forall r, In r regions -> is_certified r = true) /\ ForallOrdPairs regions_are_apart regions.
Proof.
  unfold accepts_layout, check_layout. cbv zeta. set (regions := with_certificates _ _). intros accepted.
  exists regions. split; [apply regions_with_certificates |].
  destruct (first_failure is_certified 0 regions) eqn:passed; [discriminate |].
  pose proof (no_failure _ _ _ passed) as certified. split; [exact certified |].
  destruct (found_overlap _ _) as [[t u] |] eqn:none; [discriminate |]. apply no_overlap_is_found in none.
  - exact (pairs_within_parts _ _ _ none).
  - apply Forall_flat_map, Forall_forall. intros r R. now apply certified_pieces, certified.
Qed.

(* If the checker accepts a container, parts and a certificate, the parts are in the container and do not overlap. *)
Theorem accepted_layouts_are_layouts : accepts_only_layouts accepts_layout.
Proof.
  intros container parts c (regions & are_these & certified & apart)%accepted_layout_regions.
  assert (alone : ForallOrdPairs (fun a b => forall x, ~ (is_inner_point x a /\ is_inner_point x b))
    (regions_of_layout container parts)).
  { rewrite <- are_these. refine (pairs_mapped _ _ _ _ _ apart). intros r s R S are_apart_ x.
    now apply no_common_inner_point; auto. }
  destruct container as [container |]; [| split; [exact alone | discriminate]].
  split; [now inversion_clear alone |]. intros its_container a x [= <-] A in_a.
  destruct (member_dec x container) as [| out]; [assumption | exfalso].
  set (m := size_of_regions (container :: parts)) in *.
  destruct (size_is_large (flat_map (fun r => concat (as_region r)) (container :: parts))) as [large all].
  change (size_of _) with m in large, all.
  destruct (members_are_in_the_square a m x) as [in_x in_y]; [| exact in_a |].
  { intros v V. apply all, in_flat_map. exists a. split; [now right | exact V]. }
  cbn [vx vy as_vector] in in_x, in_y. apply (outside_in_frame (2 * m)), members_near_inner_points in out; [| lra ..].
  destruct out as (radius & R & near).
  destruct regions as [| outside regions]; [discriminate |]. injection are_these as is_outside are_parts.
  rewrite <- are_parts in A. apply in_map_iff in A. destruct A as (part & is_a & A).
  inversion_clear apart as [| ? ? first_ _]. rewrite Forall_forall in first_. specialize (first_ part A).
  destruct (not_all_around part outside x radius) as (y & close & _ & not_outside); trivial.
  - apply certified. now right.
  - apply certified. now left.
  - intros t u T U. now apply apart_exchanged, first_.
  - now rewrite is_a.
  - apply not_outside. rewrite is_outside. now apply near.
Qed.
