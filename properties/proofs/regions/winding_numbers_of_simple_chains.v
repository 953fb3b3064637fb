(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* A simple chain winds around a point at most once: off the chain its winding number is 0, or 1 if it is
   counterclockwise, or -1 if it is clockwise. So of the Jordan curve theorem for polygons, that there are
   an inside and an outside by winding numbers. That a ray meets some edge first is in
   first_edge_of_a_ray.v, what that says in winding_by_first_edge.v. *)
From Coq Require Import PeanoNat ZArith Lia Bool List.
From Oplus Require Import numbers convolution regions secants segments_apart turning_tangents simple_chain
  simple_chains_turn_once vertex_inside_an_edge winding_by_first_edge first_edge_of_a_ray neighbourhoods.
Import ListNotations.

Open Scope Q_scope.

Lemma open_edge_by_index path e : In e (open_edges path) ->
  exists j, (S j < length path)%nat /\ e = Segment (vertex path j) (vertex path (S j)).
Proof.
  induction path as [| a path IH]; intros I; [destruct I |].
  destruct path as [| b path]; [destruct I |].
  destruct I as [<- | I].
  - exists 0%nat. cbn [length]. split; [lia | reflexivity].
  - destruct (IH I) as (j & J & e_is). exists (S j). cbn [length] in *. split; [lia | exact e_is].
Qed.

Lemma winds_at_most_once_by_the_closing_edge chain x y part :
  let n := length chain in let z := vertex chain (n - 1) in let a := vertex chain 0 in
  simple chain -> off x (edges chain) -> 0 < part /\ part < 1 ->
  equal_vectors y (Vector (vx z + part * (vx a - vx z)) (vy z + part * (vy a - vy z))) ->
  ~ cross (minus y x) (minus a z) == 0 ->
  (forall j, (j < n)%nat -> j <> (n - 1)%nat -> forall p,
     lies_on p (Segment x y) -> ~ lies_on p (edge_at chain j)) ->
  winding_number x (edges chain) = 0%Z \/ winding_number x (edges chain) = turning_number chain.
Proof.
  intros n z a chain_simple x_off part_between y_between across first_edge.
  pose proof (simple_with_one_more chain chain_simple y part part_between y_between) as with_y.
  pose proof (three_vertices chain chain_simple) as N. fold n in N.
  assert (shape : exists middle, chain = a :: middle ++ [z]).
  { unfold a, z, n in *. clear - N. destruct chain as [| first rest]; [cbn in N; lia |].
    destruct (exists_last (l := rest)) as (middle & last & ->); [intros ->; cbn in N; lia |].
    exists middle. unfold vertex. cbn [length nth]. rewrite app_length. cbn [length].
    replace (S (length middle + 1) - 1)%nat with (S (length middle)) by lia.
    cbn [nth]. now rewrite app_nth2, Nat.sub_diag by lia. }
  destruct shape as (middle & shape).
  assert (inner_edge : forall j, (S j < n)%nat ->
    edge_at chain j = Segment (vertex chain j) (vertex chain (S j))).
  { intros j J. rewrite edge_is by (fold n; lia). fold n. now rewrite next_below. }
  assert (ray : nonzero (minus y x)).
  { intros [x_none y_none]. apply across. unfold cross. rewrite x_none, y_none. ring. }
  assert (apart_before : apart_from x y chain).
  { apply apart_from_by_index. intros j J. apply are_apart_sound.
    destruct (are_apart_decides x y (vertex chain j) (vertex chain (S j)) ray) as [[found | common] _];
      [exact found | exfalso].
    destruct common as (p & on_ray_ & on_edge). rewrite <- inner_edge in on_edge by exact J.
    revert on_edge. apply (first_edge j); trivial; fold n in J; lia. }
  pose proof (parts_nonzero chain chain_simple y part part_between y_between) as [to_a from_z].
  assert (y_off : off y (open_edges chain)).
  { intros e I. apply open_edge_by_index in I. destruct I as (j & J & ->). fold n in J.
    rewrite <- inner_edge by exact J. intros on_j.
    assert (on_closing : lies_on y (edge_at chain (n - 1))).
    { unfold n. rewrite closing_edge by exact chain_simple. fold n. fold z a.
      apply (on_segment z a y part); [lra | exact y_between]. }
    destruct chain_simple as (_ & _ & common). fold n in common.
    destruct (common j (n - 1)%nat y) as [[_ [x_is y_is]] | [follows [x_is y_is]]]; trivial; try lia.
    - apply from_z. change (vx y - vx z == 0 /\ vy y - vy z == 0). fold z in x_is, y_is. split; lra.
    - apply to_a. rewrite next_last in follows by lia. rewrite follows in x_is, y_is.
      change (vx a - vx y == 0 /\ vy a - vy y == 0). fold a in x_is, y_is. split; lra. }
  assert (vertices_off : forall b, In b chain -> nonzero (minus b y)).
  { intros b I. apply (In_nth _ _ nowhere) in I. destruct I as (i & I & <-). fold (vertex chain i).
    intros [x_none y_none].
    apply (vertices_differ (y :: chain) (S i) 0 with_y); cbn [length]; try lia.
    unfold minus in *. cbn [vx vy] in *.
    change (equal_vectors (vertex chain i) y). unfold equal_vectors. split; lra. }
  pose proof (simple_chain_without_crossings _ with_y) as first_free.
  pose proof (simple_chain_without_crossings _ (simple_rotated _ with_y)) as last_free.
  pose proof (simple_chain_turns_everywhere _ with_y) as everywhere.
  cbn [rotated] in last_free.
  pose proof (turning_number_with_one_more a z y middle part) as same_number.
  rewrite <- shape in same_number. specialize (same_number chain_simple part_between y_between).
  pose proof (winding_number_by_first_edge x y a z middle part part_between y_between across) as twice.
  rewrite <- shape in twice.
  assert (last_shape : a :: middle ++ [z; y] = chain ++ [y]).
  { rewrite shape. cbn [app]. now rewrite <- app_assoc. }
  rewrite last_shape in twice.
  specialize (twice x_off apart_before y_off first_free last_free everywhere vertices_off).
  rewrite same_number in twice.
  pose proof (simple_chain_turns_once chain chain_simple) as once.
  destruct (is_counterclockwise chain), (negative _); lia.
Qed.

Lemma edges_rotated chain : edges (rotated chain) = rotated (edges chain).
Proof.
  pose proof edges_are_as_many as long.
  apply (nth_ext _ _ (no_segment) (no_segment)).
  - now rewrite rotated_length, !long, rotated_length.
  - intros i I. rewrite long, rotated_length in I.
    rewrite nth_rotated, long by now rewrite long. now apply edge_rotated.
Qed.

Lemma winding_number_rotated x chain : winding_number x (edges (rotated chain)) = winding_number x (edges chain).
Proof.
  rewrite edges_rotated. destruct (edges chain) as [| e rest]; [reflexivity |]. cbn [rotated].
  rewrite winding_number_is_additive. change (e :: rest) with ([e] ++ rest).
  rewrite winding_number_is_additive. lia.
Qed.

Lemma off_rotated x chain : off x (edges chain) -> off x (edges (rotated chain)).
Proof.
  intros x_off e I. apply x_off. rewrite edges_rotated in I. destruct (edges chain) as [| f rest]; [exact I |].
  cbn [rotated] in I. apply in_app_iff in I. destruct I as [I | [<- | []]]; [now right | now left].
Qed.

Lemma winds_at_most_once_by_edge m : forall chain x y part,
  let n := length chain in
  let z := vertex chain m in let a := vertex chain (next m n) in
  simple chain -> off x (edges chain) -> (m < n)%nat -> 0 < part /\ part < 1 ->
  equal_vectors y (Vector (vx z + part * (vx a - vx z)) (vy z + part * (vy a - vy z))) ->
  ~ cross (minus y x) (minus a z) == 0 ->
  (forall j, (j < n)%nat -> j <> m -> forall p,
     lies_on p (Segment x y) -> ~ lies_on p (edge_at chain j)) ->
  winding_number x (edges chain) = 0%Z \/ winding_number x (edges chain) = turning_number chain.
Proof.
  assert (rotate : forall m k chain x y, k = next m (length chain) -> (m < length chain)%nat ->
    (forall j, (j < length chain)%nat -> j <> k -> forall p,
       lies_on p (Segment x y) -> ~ lies_on p (edge_at chain j)) ->
    forall j, (j < length (rotated chain))%nat -> j <> m -> forall p,
       lies_on p (Segment x y) -> ~ lies_on p (edge_at (rotated chain) j)).
  { intros m' k chain x y -> M first_edge j J differ p on_ray_. rewrite rotated_length in J.
    rewrite edge_rotated by exact J. apply first_edge; trivial; [now apply next_in_range |].
    intros same_next. apply differ. now apply (next_injective (length chain)). }
  induction m as [| m IH]; intros chain x y part n z a chain_simple x_off M part_between y_between across
    first_edge; pose proof (three_vertices chain chain_simple) as N; fold n in N;
    rewrite <- winding_number_rotated, <- turning_number_rotated.
  - assert (last : next (n - 1) n = 0%nat) by (apply next_last; lia).
    apply (winds_at_most_once_by_the_closing_edge (rotated chain) x y part);
      rewrite ?rotated_length; fold n; rewrite ?vertex_rotated by (fold n; lia); fold n; rewrite ?last; trivial.
    + now apply simple_rotated.
    + now apply off_rotated.
    + intros j J differ. refine (rotate (n - 1)%nat 0%nat chain x y _ _ first_edge j _ differ);
        [now symmetry | fold n; lia | now rewrite rotated_length].
  - pose proof (next_below m n M) as following.
    pose proof (next_in_range m n) as in_range.
    apply (IH (rotated chain) x y part); rewrite ?rotated_length; fold n;
      rewrite ?vertex_rotated by (fold n; try apply in_range; lia); fold n; rewrite ?following; trivial.
    + now apply simple_rotated.
    + now apply off_rotated.
    + lia.
    + intros j J differ. refine (rotate m (S m) chain x y _ _ first_edge j _ differ);
        [now symmetry | fold n; lia | now rewrite rotated_length].
Qed.

(* Theorem. The winding number of a point off a simple chain is zero or the chain's turning number, which is 1
   or -1. *)
Theorem simple_chain_winds_at_most_once chain x :
  simple chain -> off x (edges chain) ->
  winding_number x (edges chain) = 0%Z \/ winding_number x (edges chain) = turning_number chain.
Proof.
  intros chain_simple x_off. set (n := length chain).
  destruct (Z.eq_dec (winding_number x (edges chain)) 0) as [none | winds]; [now left |].
  destruct (ray_to_a_segment (edges chain) (edges chain) x x_off (incl_refl _) winds)
    as (u & k & avoided & K & on_k).
  destruct (ray_meets_one_first x u (edges chain) k 1 x_off avoided K ltac:(lra) on_k)
    as (s & first & part & S & first_positive & after_start & before_end & across & there & only).
  assert (by_index : forall e, In e (edges chain) -> exists m, (m < n)%nat /\ edge_at chain m = e).
  { intros e I. apply (In_nth _ _ (no_segment)) in I. destruct I as (m & M & m_is).
    exists m. split; [| exact m_is]. now rewrite edges_are_as_many in M. }
  assert (listed : forall j, (j < n)%nat -> In (edge_at chain j) (edges chain)).
  { intros j J. unfold edge_at. apply nth_In. now rewrite edges_are_as_many. }
  destruct (by_index s S) as (m & M & <-).
  assert (on_m : lies_on (moved_along x u first) (edge_at chain m)).
  { rewrite edge_is in there |- * by exact M. apply (on_segment _ _ _ part); [lra | exact there]. }
  rewrite edge_is in across, there by exact M.
  apply (winds_at_most_once_by_edge m chain x (moved_along x u first) part); trivial; [now split | |].
  - intros none. apply across. apply (Qmult_inj_l _ _ first); [lra |].
    etransitivity; [| etransitivity; [exact none | ring]].
    unfold along, cross, moved_along, minus. cbn [source target vx vy]. ring.
  - fold n. intros j J differ z on_ray_ on_j.
    pose proof (only _ z (listed j J) on_ray_ on_j) as z_is.
    apply (lies_on_equal z (moved_along x u first)) in on_j; [| exact z_is].
    assert (no_vertex : forall i, (i < n)%nat -> ~ equal_vectors (moved_along x u first) (vertex chain i)).
    { intros i I [xi yi]. destruct (avoided _ (listed i I)) as [off_line _].
      rewrite edge_is in off_line by exact I. apply off_line. unfold side_of, cross, moved_along, minus in *.
      cbn [source vx vy] in *. rewrite <- xi, <- yi. ring. }
    destruct chain_simple as (_ & _ & common).
    destruct (common j m _ J M differ on_j on_m) as [[_ at_vertex] | [_ at_vertex]];
      revert at_vertex; now apply no_vertex.
Qed.

(* So a counterclockwise one has winding numbers 0 and 1 only, a clockwise one 0 and -1. *)
Corollary winding_numbers_of_simple_chains chain x :
  simple chain -> off x (edges chain) ->
  if is_counterclockwise chain then (0 <= winding_number x (edges chain) <= 1)%Z
  else (-1 <= winding_number x (edges chain) <= 0)%Z.
Proof.
  intros chain_simple x_off.
  pose proof (simple_chain_turns_once chain chain_simple) as once.
  destruct (simple_chain_winds_at_most_once chain x chain_simple x_off) as [-> | ->];
    [destruct (is_counterclockwise chain); lia |].
  rewrite once. destruct (is_counterclockwise chain); lia.
Qed.
