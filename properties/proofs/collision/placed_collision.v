(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The collision test of P and -Q + x (docs/notation.md), a region whose edges are those of Q reflected (reflected.v),
   and Theorem 4.2.1 for it: off the convolution the test returns true if and only if the winding number of the
   convolution at x is positive, so that the two ways to decide whether x is in the sum cannot differ. What the test
   returns is from collision_is_sound.v and collision_is_complete.v. *)
From Coq Require Import ZArith Lia Bool List.
From Oplus Require Import numbers regions_and_sums reflected parallelogram crossing_edges location pieces
  naive_collision met_pieces collision_is_complete fans_that_touch.
Import ListNotations.

Open Scope Q_scope.

(* -Q + x: turned by half a turn, so that chains keep their orientation. *)
Definition placed (x : vector) (q : region) : region := map (map (minus x)) q.

(* The edges of a region whose vertices are replaced. *)
Definition moved_ends (h : vector -> vector) (s : segment) : segment := Segment (h (source s)) (h (target s)).

Lemma edges_of_images (h : vector -> vector) (r : region) :
  region_edges (map (map h) r) = map (moved_ends h) (region_edges r).
Proof.
  unfold region_edges. induction r as [| c r IH]; [reflexivity |]. cbn [map flat_map]. rewrite map_app, IH. f_equal.
  unfold edges. assert (rotated_ : rotated (map h c) = map h (rotated c))
    by (destruct c; [reflexivity |]; cbn; now rewrite map_app).
  rewrite rotated_. generalize (rotated c). clear rotated_ IH.
  induction c as [| a c IH]; intros [| b l]; [reflexivity .. |]. cbn. now rewrite IH.
Qed.

Lemma edges_of_placed (x : vector) (q : region) : region_edges (placed x q) = map (reflected x) (region_edges q).
Proof. exact (edges_of_images (minus x) q). Qed.

Lemma off_placed (x z : vector) (q : region) :
  off z (region_edges (placed x q)) <-> off (minus x z) (region_edges q).
Proof.
  rewrite edges_of_placed. split.
  - intros free s I on. apply (free (reflected x s)); [now apply in_map | now apply on_reflected].
  - intros free s' I on. apply in_map_iff in I. destruct I as (s & <- & I). apply on_reflected in on.
    exact (free s I on).
Qed.

Lemma winding_number_of_placed (x z : vector) (q : region) : off (minus x z) (region_edges q) ->
  winding_number z (region_edges (placed x q)) = winding_number (minus x z) (region_edges q).
Proof. intros free. rewrite edges_of_placed. apply winding_number_of_reflected; [apply region_cycles | exact free]. Qed.

Lemma inside_placed (x z : vector) (q : region) : inside z (placed x q) <-> inside (minus x z) q.
Proof.
  unfold inside. rewrite off_placed. split; intros [free positive_]; split; trivial;
    now rewrite winding_number_of_placed in *.
Qed.

Lemma vertex_of_placed (x w : vector) (q : region) : is_vertex w (placed x q) <-> is_vertex (minus x w) q.
Proof.
  unfold is_vertex. rewrite edges_of_placed. split.
  - intros (u & (t & <- & T)%in_map_iff & X & Y). exists t. split; [exact T |].
    unfold reflected, minus in *; cbn [source vx vy] in *. split; cbn [vx vy]; lra.
  - intros (u & I & X & Y). exists (reflected x u). split; [now apply in_map |].
    unfold reflected, minus in *; cbn [source vx vy] in *. split; cbn [vx vy]; lra.
Qed.

Lemma edges_are_no_points (r : region) :
  (forall s, In s (region_edges r) -> nonzero (along s)) -> no_edges_are_points r.
Proof.
  intros long c C d D. unfold edge_directions in D. apply in_map_iff in D. destruct D as (s & <- & S).
  apply long, in_flat_map. now exists c.
Qed.

Lemma placed_is_valid (x : vector) (q : region) : valid_region q -> valid_region (placed x q).
Proof.
  intros (not_points & valid & meet). split; [| split].
  - apply edges_are_no_points. rewrite edges_of_placed. intros s' (s & <- & S)%in_map_iff [X Y].
    apply (region_edges_are_directions q not_points s S). unfold reflected in X, Y. in_coordinates. split; lra.
  - intros z free. rewrite winding_number_of_placed by now apply off_placed. apply valid. now apply off_placed.
  - intros earlier' s' later' t' w edges_are I on_s on_t. rewrite edges_of_placed in edges_are.
    destruct (map_eq_app _ _ _ _ edges_are) as (earlier & rest & list_is & earlier_is & rest_is).
    destruct rest as [| s later]; [discriminate |]. cbn [map] in rest_is. injection rest_is as s_is later_is.
    assert (J : exists t, In t (earlier ++ later) /\ reflected x t = t').
    { rewrite <- earlier_is, <- later_is, <- map_app in I. apply in_map_iff in I.
      destruct I as (t & equal & I). now exists t. }
    destruct J as (t & J & <-). rewrite <- s_is in on_s. apply on_reflected in on_s. apply on_reflected in on_t.
    apply vertex_of_placed. exact (meet earlier s later t (minus x w) list_is J on_s on_t).
Qed.

Lemma placed_is_at_most_one (x : vector) (q : region) : nowhere_above_one q -> nowhere_above_one (placed x q).
Proof.
  intros simple z free. rewrite winding_number_of_placed by now apply off_placed. apply simple. now apply off_placed.
Qed.

(* Theorem. For valid regions with winding numbers 0 and 1 and every x: the naive collision test of P and -Q + x returns
   true if and only if their interiors have a point in common. *)
Theorem collide_decides_whether_interiors_meet (p q : region) (x : vector) :
  valid_region p -> valid_region q -> nowhere_above_one p -> nowhere_above_one q ->
  (collide p (placed x q) = true <-> interiors_meet x p q).
Proof.
  intros p_region q_region p_simple q_simple.
  rewrite (collide_returns p (placed x q) p_region (placed_is_valid x q q_region) p_simple
    (placed_is_at_most_one x q q_simple)).
  unfold interiors_meet. split; intros (z & in_p & in_q); exists z; (split; [exact in_p |]); now apply inside_placed.
Qed.

(* Theorem. And off the convolution it returns true if and only if the winding number of the convolution is positive. *)
Theorem collide_is_positive_winding_number (p q : region) (x : vector) :
  valid_region p -> valid_region q -> nowhere_above_one p -> nowhere_above_one q ->
  off x (convolution_segments p q) ->
  (collide p (placed x q) = true <-> (0 < winding_number x (convolution_segments p q))%Z).
Proof.
  intros p_region q_region p_simple q_simple free.
  rewrite collide_decides_whether_interiors_meet by assumption.
  now rewrite positive_winding_number_iff_common_inner_point.
Qed.
