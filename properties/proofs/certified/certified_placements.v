(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The theorems: what the checkers of placement_checkers.v accept are no-fits and inner fits, as specification.v says.
   They follow from the theorem about open sums (certified_open_sums.v). Of an inner fit the pieces of the outside and
   of the sum are apart, so winding numbers are 0 and 1 (pieces_go_round_once.v), and near each point of b are inner
   points of it: what the theorem of inner_fit_is_right.v asks for. *)
From Coq Require Import QArith Lqa ZArith Lia Bool List.
From Oplus Require Import regions_and_sums reflected specification checker signed_crossings neighbourhoods
  homogeneous_points specification_bridge pieces_cover sums_are_inside placed_collision sum_program sum_is_right
  coordinates turned_chains inner_fit_program complement_in_a_frame open_sums inner_fit_is_right layout_checker
  pieces_apart certified_layouts pieces_go_round_once certified_open_sums placement_checkers.
Import ListNotations.

Open Scope Q_scope.

(* Theorem. *)
Theorem accepted_no_fits_are_no_fits : accepts_only_no_fits accepts_no_fit.
Proof. intros a b s c accepted. apply overlaps_by_open_sum. now apply (accepted_open_sums_are_open_sums a _ s c). Qed.

(** The set around the placements *)

Lemma turned_twice {A : Type} (c : list A) : turned_chain (turned_chain c) = c.
Proof. destruct c as [| v rest]; [reflexivity |]. cbn. now rewrite rev_involutive. Qed.

Lemma turned_images {A B : Type} (h : A -> B) (c : list A) : map h (turned_chain c) = turned_chain (map h c).
Proof. destruct c as [| v rest]; [reflexivity |]. cbn. now rewrite map_rev. Qed.

Lemma all_are_kept {A : Type} (test : A -> bool) (l : list A) :
  forallb (fun is_in => is_in) (map test l) = true -> filter test l = l.
Proof. induction l as [| a l IH]; [reflexivity |]. cbn. intros [-> rest]%andb_true_iff. now rewrite IH. Qed.

Lemma none_is_kept {A : Type} (test : A -> bool) (l : list A) : forallb negb (map test l) = true -> filter test l = [].
Proof. induction l as [| a l IH]; [reflexivity |]. cbn. intros [->%negb_true_iff rest]%andb_true_iff. now apply IH. Qed.

Lemma placements_in_the_square (k : Q) (outer : open_region) (f : placements) :
  forallb (fun is_in => is_in) (start_in k (OpenRegion (fit_chains f) (fit_edges f) (fit_points f))) = true ->
  forallb negb (start_in k outer) = true ->
  placements_in k (open_sum_around_placements outer f) =
    Placements (map (map as_point) (as_region (fit_chains f))) (fit_edges f) (fit_points f).
Proof.
  unfold start_in, placements_in, open_sum_around_placements. rewrite !forallb_app, !andb_true_iff.
  cbn [open_chains dangling_edges isolated_points].
  intros (in_chains & in_edges & in_points) (chains_ & edges_ & points_).
  rewrite !filter_app.
  f_equal; [| exact (f_equal2 (@app edge) (none_is_kept _ _ edges_) (all_are_kept _ _ in_edges)) |
    exact (f_equal2 (@app point) (none_is_kept _ _ points_) (all_are_kept _ _ in_points))]. f_equal.
  transitivity (map turned_chain (map turned_chain (as_region (fit_chains f)))).
  2: { rewrite map_map, (map_ext _ _ turned_twice). apply map_id. }
  f_equal. transitivity ([] ++ filter (starts_in k) (map turned_chain (as_region (fit_chains f)))).
  - unfold as_region at 1. rewrite map_app, filter_app. f_equal; [exact (none_is_kept _ _ chains_) |]. f_equal.
    unfold as_region. rewrite !map_map. apply map_ext. apply turned_images.
  - apply all_are_kept. rewrite map_map. etransitivity; [| exact in_chains]. f_equal. apply map_ext. intros c.
    now destruct c.
Qed.

Lemma same_placements (x : point) (f : placements) :
  fits x (Placements (map (map as_point) (as_region (fit_chains f))) (fit_edges f) (fit_points f)) <-> fits x f.
Proof. unfold fits. cbn [fit_chains fit_edges fit_points]. now rewrite member_of_chains, <- member_by_edges. Qed.

(** Winding numbers *)

Lemma outside_goes_round_once (a : polygonal_region) (m : Q) (x : vector) : 0 < m ->
  (forall v, In v (concat (as_region a)) -> in_square m v) ->
  (forall y, off y (boundary (as_polygonal (complement_in_frame (5 * m) (as_region a)))) ->
    winding_number y (boundary (as_polygonal (complement_in_frame (5 * m) (as_region a)))) = 0%Z \/
    winding_number y (boundary (as_polygonal (complement_in_frame (5 * m) (as_region a)))) = 1%Z) ->
  off x (region_edges (as_region a)) ->
  winding_number x (region_edges (as_region a)) = 0%Z \/ winding_number x (region_edges (as_region a)) = 1%Z.
Proof.
  intros some a_fits once free. specialize (once x). rewrite boundary_is in once.
  destruct (chains_as_points x (complement_in_frame (5 * m) (as_region a))) as [same_points same_number].
  fold (as_region (as_polygonal (complement_in_frame (5 * m) (as_region a)))) in once. unfold as_polygonal in once.
  rewrite off_is, same_points, same_number, <- off_is in once.
  change (region_edges (complement_in_frame (5 * m) (as_region a)))
    with (edges (frame (5 * m)) ++ region_edges (map turned_chain (as_region a))) in once.
  destruct (is_in_square_spec m x) as [[in_x in_y] | far].
  - rewrite number_of_both, winding_number_of_turned, frame_goes_round in once by lra.
    destruct once as [one | none]; [| right; lia | left; lia].
    intros e [E | E]%in_app_iff; [apply (off_the_frame (5 * m)); trivial; lra |]. revert e E. apply off_is.
    rewrite on_turned. now apply off_is.
  - left. now apply (nothing_goes_round_outside m); [apply region_cycles | apply edges_in_square |].
Qed.

Lemma members_of_half_turned (y : point) (b : polygonal_region) :
  member y b -> member (Point (0 - x_of y) (0 - y_of y)) (half_turned_region b).
Proof.
  intros in_b. apply member_by_edges in in_b. apply member_of_chains. unfold half_turned.
  assert (same : equal_vectors (as_vector y) (minus (Vector 0 0) (as_vector (Point (0 - x_of y) (0 - y_of y)))))
    by by_computing.
  destruct (on_or_off (as_vector y) (region_edges (as_region b))) as [(s & S & on) | free].
  - left. exists (reflected (Vector 0 0) s). rewrite edges_of_placed. split; [now apply in_map |].
    apply on_reflected. now apply (lies_on_equal (as_vector y)).
  - right. rewrite winding_number_of_placed by now apply (off_equal (as_vector y)).
    rewrite <- (winding_number_of_equal _ _ _ (proj1 same) (proj2 same)).
    destruct in_b as [(s & S & on) | round]; [destruct (free s S on) | exact round].
Qed.

(** The whole *)

Section InnerFit.
  Variables (a b : polygonal_region) (f : placements) (outer : open_region) (m : Q) (sum_ : certificate).
  Let outside := as_polygonal (complement_in_frame (5 * m) (as_region a)).
  Let s := open_sum_around_placements outer f.
  Hypothesis large : 1 <= m.
  Hypothesis a_fits : forall v, In v (concat (as_region a)) -> in_square m v.
  Hypothesis b_fits : forall v, In v (concat (as_region b)) -> in_square m v.
  Hypothesis b_some : exists v, In v (concat (as_region b)).
  Hypothesis inside_ :
    forallb (fun is_in => is_in) (start_in (2 * m) (OpenRegion (fit_chains f) (fit_edges f) (fit_points f))) = true.
  Hypothesis beyond_ : forallb negb (start_in (2 * m) outer) = true.
  Hypothesis outside_apart : found_overlap (unit sum_) (map piece_of (summand_pieces (of_p sum_))) = None.
  Hypothesis sum_apart : found_overlap (unit sum_) (map (fun d => piece_of (fst d)) (sum_pieces sum_)) = None.
  Hypothesis accepted : accepts_open outside (half_turned_region b) s sum_ = true.

  Theorem accepted_around_placements : is_inner_fit a b f.
  Proof.
    destruct (accepted_regions _ _ _ _ accepted) as (p_region & q_region & s_region).
    pose proof sum_apart as s_apart. rewrite <- (map_map fst piece_of) in s_region, s_apart.
    pose proof (all_pieces _ _ _ p_region) as p_pieces. pose proof (all_pieces _ _ _ s_region) as s_pieces.
    pose proof (no_overlap_is_found _ _ (proj2 (Forall_forall _ _) p_pieces) outside_apart) as p_apart.
    apply no_overlap_is_found in s_apart; [| now apply Forall_forall].
    intros x. rewrite <- same_placements, <- (placements_in_the_square (2 * m) outer f inside_ beyond_). revert x.
    apply placements_are_the_inner_fit; trivial.
    - intros x. apply (outside_goes_round_once a m); [lra | exact a_fits |]. intros y.
      exact (pieces_apart_go_round_once _ _ _ p_region y p_apart).
    - intros y radius in_b R.
      destruct (inner_points_are_near _ _ _ q_region (Point (0 - x_of y) (0 - y_of y)) radius)
        as (z & close & inner_z); [now apply members_of_half_turned | exact R |].
      exists (Point (0 - x_of z) (0 - y_of z)). split; [by_computing | now apply inner_points_of_half_turned].
    - apply overlaps_by_open_sum. now apply (accepted_open_sums_are_open_sums _ _ s sum_).
    - intros x. rewrite <- boundary_is. exact (pieces_apart_go_round_once _ _ _ s_region x s_apart).
  Qed.
End InnerFit.

(* Theorem. *)
Theorem accepted_inner_fits_are_inner_fits : accepts_only_inner_fits accepts_inner_fit.
Proof.
  intros a b f c. unfold accepts_inner_fit, check_inner_fit, outside_of. cbv zeta.
  destruct (size_is_large (flat_map (fun r => concat (as_region r)) [a; b])) as [large all].
  change (size_of _) with (size_of_regions [a; b]) in large, all. generalize dependent (size_of_regions [a; b]).
  intros m large all. cbn [flat_map] in all. rewrite app_nil_r in all.
  destruct (concat b) as [| v vertices] eqn:vertices_of_b; [discriminate |].
  destruct (forallb (fun is_in => is_in) _) eqn:inside_; cbn [negb]; [| discriminate].
  destruct (forallb negb _) eqn:beyond_; cbn [negb]; [| discriminate].
  destruct (found_overlap _ (map piece_of _)) as [[t u] |] eqn:outside_apart; [discriminate |].
  destruct (found_overlap _ (map _ (sum_pieces (of_open_sum c)))) as [[t u] |] eqn:sum_apart; [discriminate |].
  destruct (check _ _ _ _ _) eqn:passed; [discriminate |]. intros _.
  apply (accepted_around_placements a b f (beyond c) m (of_open_sum c)); trivial.
  - intros w W. apply all, in_app_iff. now left.
  - intros w W. apply all, in_app_iff. now right.
  - unfold as_region. rewrite <- concat_map, vertices_of_b. exists (vector_of (homogeneous v)). now left.
  - unfold accepts_open. now rewrite passed.
Qed.
