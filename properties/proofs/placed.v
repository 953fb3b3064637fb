(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* -Q + x as a region (notation.md), and that the collision test (collision_test.v) and winding numbers of the convolution
   (Theorem 4.2.1, interiors_at_touching_points.v) give the same verdict. Reflected segments are from reflected.v. *)
From Coq Require Import QArith Lqa ZArith Lia Bool List.
From Oplus Require Import direction sweep winding_number turning_number states in_out_degree convolution_winding weight
  regions reflected interiors_meet left_of_an_edge theorem_4_2_1 inside_a_corner boundary_points interiors_at_touching_points
  common_interior collision_test.
Import ListNotations.

Open Scope Q_scope.

Definition placed (x : vector) (q : region) : region := map (map (fun v => minus x v)) q.

Lemma edges_of_placed (x : vector) (q : region) :
  region_edges (placed x q) = map (reflected x) (region_edges q).
Proof.
  unfold region_edges, placed. induction q as [| chain q IH]; [reflexivity |].
  cbn [map flat_map]. rewrite map_app, IH. f_equal. clear IH.
  assert (rotated_ : rotated (map (fun v => minus x v) chain) = map (fun v => minus x v) (rotated chain)).
  { destruct chain as [| v rest]; [reflexivity |]. cbn [rotated map]. now rewrite map_app. }
  unfold edges. rewrite rotated_. generalize (rotated chain) as ends.
  clear rotated_. induction chain as [| v rest IH]; intros [| w ends]; [reflexivity .. |].
  cbn [map combine fst snd]. unfold reflected at 1. cbn [source target]. f_equal. apply IH.
Qed.

Lemma off_placed (x z : vector) (q : region) : off z (region_edges (placed x q)) <-> off (minus x z) (region_edges q).
Proof.
  rewrite edges_of_placed. split.
  - intros free s I on. apply (free (reflected x s)); [now apply in_map | now apply on_reflected].
  - intros free s I on. apply in_map_iff in I. destruct I as (t & <- & I). apply on_reflected in on. exact (free t I on).
Qed.

Lemma winding_number_of_placed (x z : vector) (q : region) : off z (region_edges (placed x q)) ->
  winding_number z (region_edges (placed x q)) = winding_number (minus x z) (region_edges q).
Proof.
  intros free. rewrite edges_of_placed. apply winding_number_of_reflected; [apply region_cycles |]. now apply off_placed.
Qed.

Lemma inside_placed (x z : vector) (q : region) : inside z (placed x q) <-> inside (minus x z) q.
Proof.
  unfold inside. rewrite <- off_placed. split; intros [free positive_]; (split; [exact free |]);
    now rewrite winding_number_of_placed in *.
Qed.

Lemma minus_twice (x w : vector) : equal_vectors (minus x (minus x w)) w.
Proof. split; unfold minus; cbn [vx vy]; ring. Qed.

Lemma vertex_of_placed (x w : vector) (q : region) : is_vertex (minus x w) q -> is_vertex w (placed x q).
Proof.
  intros (s & I & X & Y). exists (reflected x s). split.
  - rewrite edges_of_placed. now apply in_map.
  - unfold reflected, minus in *. cbn [source vx vy] in *. split; cbn [vx vy]; lra.
Qed.

(* Theorem. -Q + x is a valid region if Q is one. *)
Theorem placed_is_valid (x : vector) (q : region) : valid_region q -> valid_region (placed x q).
Proof.
  intros (not_points & valid & meet). split; [| split].
  - intros chain I e J. apply in_map_iff in J. destruct J as (s & <- & J).
    assert (K : In s (region_edges (placed x q))) by (apply in_flat_map; now exists chain).
    rewrite edges_of_placed in K. apply in_map_iff in K. destruct K as (t & <- & K).
    pose proof (winding_number_of_the_sum.region_edges_are_directions q not_points t K) as proper_t.
    intros [X Y]. apply proper_t. unfold reflected, along, minus in *. cbn [source target vx vy] in *. split; lra.
  - intros z free. rewrite winding_number_of_placed by exact free. apply valid. now apply off_placed.
  - intros earlier s later t w edges_are I on_s on_t. rewrite edges_of_placed in edges_are.
    apply map_eq_app in edges_are. destruct edges_are as (first & rest & q_edges & <- & rest_is).
    apply map_eq_cons in rest_is. destruct rest_is as (s' & last_ & rest_is & <- & <-). subst rest.
    rewrite <- map_app in I. apply in_map_iff in I. destruct I as (t' & <- & I).
    apply on_reflected in on_s. apply on_reflected in on_t. apply vertex_of_placed.
    exact (meet first s' last_ t' (minus x w) q_edges I on_s on_t).
Qed.

Lemma placed_at_most_once (x : vector) (q : region) : at_most_once q -> at_most_once (placed x q).
Proof. intros once z free. rewrite winding_number_of_placed by exact free. apply once. now apply off_placed. Qed.

Lemma interiors_meet_where_placed (x : vector) (p q : region) :
  have_common_interior p (placed x q) <-> interiors_meet x p q.
Proof. split; intros (z & in_p & in_q); exists z; (split; [exact in_p |]); now apply inside_placed. Qed.

(* Theorem. The collision test of P and -Q + x decides whether their interiors meet, for every x. *)
Theorem collide_decides_whether_interiors_meet (p q : region) (x : vector) :
  valid_region p -> valid_region q -> at_most_once p -> at_most_once q ->
  (collide p (placed x q) = true <-> interiors_meet x p q).
Proof.
  intros p_valid q_valid p_once q_once. rewrite <- interiors_meet_where_placed.
  apply collide_decides; trivial; [now apply placed_is_valid | now apply placed_at_most_once].
Qed.

(* Theorem. Off the convolution, the test and the winding number give the same verdict. *)
Theorem collision_and_winding_number_agree (p q : region) (x : vector) :
  valid_region p -> valid_region q -> at_most_once p -> at_most_once q ->
  chains_do_not_touch p -> chains_do_not_touch q -> off x (convolution_segments p q) ->
  collide p (placed x q) = (0 <? winding_number x (convolution_segments p q))%Z.
Proof.
  intros p_valid q_valid p_once q_once p_apart q_apart free. apply eq_true_iff_eq.
  rewrite Z.ltb_lt, (collide_decides_whether_interiors_meet p q x p_valid q_valid p_once q_once).
  symmetry. now apply positive_winding_number_iff_common_inner_point.
Qed.
