(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* What is inside a region near a vertex that no other edge touches: what is to the left of both its edges, at a
   reflex vertex what is to the left of one of them. Beside the edges themselves that is left_of_an_edge.v; the
   proof goes from there along the edge to the vertex. *)
From Coq Require Import ZArith Lia Bool List.
From Oplus Require Import numbers regions_and_sums.
Import ListNotations.

Open Scope Q_scope.

(* f_in ends where f_out begins, and no other edge comes there. *)
Definition meet_in_vertex (f_in f_out : segment) (r : region) : Prop :=
  In f_in (region_edges r) /\ In f_out (region_edges r) /\ equal_vectors (target f_in) (source f_out) /\
  forall t, In t (region_edges r) -> lies_on (source f_out) t -> t = f_in \/ t = f_out.

(* The direction n leads inside, between the edge that leaves in direction v and the one that enters in
   direction u. *)
Definition leads_inside (u v n : vector) : Prop :=
  (0 < cross u n /\ 0 < cross v n) \/ (cross u v < 0 /\ (0 < cross u n \/ 0 < cross v n)).

(* Near the vertex, only its two edges are near. *)
Lemma only_its_edges_near (f_in f_out : segment) (r : region) : meet_in_vertex f_in f_out r ->
  exists radius, 0 < radius /\ forall y, within radius (source f_out) y ->
    ~ lies_on y f_in -> ~ lies_on y f_out -> off y (region_edges r).
Proof.
  intros (_ & _ & _ & alone).
  set (others := filter (fun t => if lies_on_dec (source f_out) t then false else true) (region_edges r)).
  assert (free : off (source f_out) others).
  { intros t I. apply filter_In in I. destruct I as [_ is_other].
    destruct (lies_on_dec (source f_out) t); [discriminate is_other | assumption]. }
  destruct (off_near _ _ free) as (radius & R & near). exists radius. split; [exact R |].
  intros y close not_in not_out t I. destruct (lies_on_dec (source f_out) t) as [on | off_t] eqn:decided.
  - destruct (alone t I on) as [-> | ->]; assumption.
  - apply near; [exact close |]. apply filter_In. split; [exact I |]. now rewrite decided.
Qed.

(* From a point inside, beside one of the edges, to one beside the vertex. *)
Lemma along_the_edge (r : region) (f_in f_out f : segment) (u v n : vector) (radius t : Q) :
  (forall y, within radius u y -> ~ lies_on y f_in -> ~ lies_on y f_out -> off y (region_edges r)) ->
  inside (moved_along v n t) r -> within radius u (moved_along v n t) -> within radius u (moved_along u n t) ->
  (forall y, lies_on y (Segment (moved_along v n t) (moved_along u n t)) -> ~ lies_on y f_in /\ ~ lies_on y f_out) ->
  inside (moved_along u n t) r.
Proof.
  intros near start_inside start_near end_near free.
  set (start := moved_along v n t) in *. set (end_ := moved_along u n t) in *.
  assert (free_way : forall y, lies_on y (Segment start end_) -> off y (region_edges r)).
  { intros y on_way. destruct (free y on_way) as [not_in not_out].
    apply near; trivial. now apply (within_along radius u start end_). }
  pose proof (winding_number_along (Segment start end_) _ (region_cycles r) free_way) as same_number.
  cbn [source target] in same_number. split; [| rewrite <- same_number; apply start_inside].
  apply free_way. apply (target_lies_on (Segment start end_)).
Qed.

(* Beside a point of the edge near the vertex. *)
Lemma start_beside_an_edge (r : region) (f : segment) (u n : vector) (radius : Q) :
  valid_region r -> In f (region_edges r) -> lies_on u f -> 0 < cross (along f) n -> 0 < radius ->
  exists v, lies_on v f /\ eventually (fun t => inside (moved_along v n t) r /\
    within radius u (moved_along v n t) /\ within radius u (moved_along u n t)).
Proof.
  intros (not_points & valid & meet) I on left_ R.
  pose proof (region_edges_are_directions r not_points f I) as long.
  assert (half_positive : 0 < (1 # 2) * radius) by lra.
  destruct (no_vertex_near r f u ((1 # 2) * radius) long on half_positive) as (v & v_near & v_on & v_free).
  exists v. split; [exact v_on |].
  refine (eventually_implied _ _ _
    (eventually_and _ _ (left_of_an_edge_is_inside r f v n valid meet I v_on v_free left_)
      (eventually_and _ _ (small_steps_stay_within ((1 # 2) * radius) v n half_positive)
        (small_steps_stay_within radius u n R)))).
  intros t (in_r & start_near & end_near). split; [exact in_r |]. split; [| exact end_near].
  apply (within_twice ((1 # 2) * radius) ((1 # 2) * radius) radius u v); [lra | exact v_near | exact start_near].
Qed.

(* Theorem. What is close to a vertex in a direction that leads inside is inside. *)
Theorem inside_a_corner (r : region) (f_in f_out : segment) (n : vector) :
  valid_region r -> meet_in_vertex f_in f_out r -> leads_inside (along f_in) (along f_out) n ->
  eventually (fun t => inside (moved_along (source f_out) n t) r).
Proof.
  intros r_valid vertex leads. pose proof vertex as (I & J & [tx ty] & _).
  destruct (only_its_edges_near f_in f_out r vertex) as (radius & R & near).
  set (u := source f_out) in *. set (c := cross (along f_in) (along f_out)) in *.
  assert (positive_steps : eventually (fun t => 0 < t)) by (exists 1; split; [lra | intros; assumption]).
  assert (u_on_in : lies_on u f_in).
  { exists 1. split; [lra |]. fold u in tx, ty. rewrite tx, ty. split; ring. }
  assert (cases : 0 < cross (along f_out) n /\ (c < 0 \/ (0 <= c /\ 0 < cross (along f_in) n)) \/
                  c < 0 /\ 0 < cross (along f_in) n).
  { unfold leads_inside in leads. fold c in leads. destruct (Qlt_le_dec c 0); tauto. }
  destruct cases as [[left_of_out rest] | [right_turn left_of_in]].
  - (* along the edge that leaves *)
    destruct (start_beside_an_edge r f_out u n radius r_valid J (source_lies_on f_out) left_of_out R)
      as (v & (s & [s0 s1] & vx_is & vy_is) & starts).
    refine (eventually_implied _ _ _ (eventually_and _ _ starts positive_steps)).
    intros t ((start_inside & start_near & end_near) & some).
    apply (along_the_edge r f_in f_out f_out u v n radius t near start_inside start_near end_near).
    intros y (h & [h0 h1] & yx & yy). cbn [source target] in yx, yy.
    set (b := cross (along f_out) n) in *. set (a := cross (along f_in) n) in *.
    assert (0 < t * b) by now apply Qmult_lt_0_compat. split.
    + intros (k & [k0 k1] & X & Y).
      assert (out_1 : cross (minus y u) (along f_out) == - (t * b)) by (unfold b, u in *; in_coordinates; by_equations).
      assert (out_2 : cross (minus y u) (along f_out) == - (1 - k) * c)
        by (unfold c, u in *; in_coordinates; by_equations).
      assert (in_1 : cross (along f_in) (minus y u) == (1 - h) * s * c + t * a)
        by (unfold a, c, u in *; in_coordinates; by_equations).
      assert (in_2 : cross (along f_in) (minus y u) == 0) by (unfold u in *; in_coordinates; by_equations).
      rewrite in_2 in in_1. rewrite out_2 in out_1. clearbody a b c.
      destruct rest as [right_turn | [left_turn left_of_in]].
      * assert (0 <= (1 - k) * - c) by (apply Qmult_le_0_compat; lra). lra.
      * assert (0 <= (1 - h) * s * c)
          by (apply Qmult_le_0_compat; [apply Qmult_le_0_compat; lra | lra]).
        assert (0 < t * a) by now apply Qmult_lt_0_compat. lra.
    + apply off_by_area.
      assert (value : area f_out y == t * b).
      { unfold b, u in *. in_coordinates. by_equations. }
      rewrite value. lra.
  - (* along the edge that enters *)
    destruct (start_beside_an_edge r f_in u n radius r_valid I u_on_in left_of_in R)
      as (v & (s & [s0 s1] & vx_is & vy_is) & starts).
    refine (eventually_implied _ _ _ (eventually_and _ _ starts positive_steps)).
    intros t ((start_inside & start_near & end_near) & some).
    apply (along_the_edge r f_in f_out f_in u v n radius t near start_inside start_near end_near).
    intros y (h & [h0 h1] & yx & yy). cbn [source target] in yx, yy.
    set (a := cross (along f_in) n) in *.
    assert (0 < t * a) by now apply Qmult_lt_0_compat.
    fold u in tx, ty.
    assert (value : cross (along f_in) (minus y u) == t * a).
    { unfold a, u in *. in_coordinates. by_equations. }
    split.
    + apply off_by_area.
      setoid_replace (area f_in y) with (cross (along f_in) (minus y u))
        by (unfold u in *; in_coordinates; by_equations).
      rewrite value. lra.
    + intros (k & [k0 k1] & X & Y).
      assert (value_2 : cross (along f_in) (minus y u) == k * c).
      { unfold c, u in *. in_coordinates. by_equations. }
      rewrite value in value_2. clearbody a c.
      assert (0 <= k * - c) by (apply Qmult_le_0_compat; lra). lra.
Qed.
