(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* A point of a piece of S that is on none of the piece's sides has some of the piece around it: the sides go round
   all points near it. And a point on a side is on an edge of S, or on a diagonal that the certificate lists, with both
   ends on edges of S (have_all_sides, diagonals_of of checker.v). *)
From Coq Require Import QArith Lqa ZArith Lia Bool List Permutation FMapPositive.
From Oplus Require Import turning_number convolution specification checker winding_number signed_crossings small_numbers
  neighbourhoods homogeneous_points specification_bridge fans winding_numbers_of_triangles balanced_edges pieces_cover
  connected_pieces.
Import ListNotations.

Open Scope Q_scope.

Lemma sides_are_cycles (v : polygon) : cycles (map segment_of_hedge (sides v)).
Proof.
  apply permuted_vectors. rewrite !map_map. destruct v as [| first rest]; [constructor |]. unfold sides.
  assert (ends : forall l m : polygon, length l = length m ->
    map (fun e => source (segment_of_hedge e)) (combine l m) = map vector_of l /\
    map (fun e => target (segment_of_hedge e)) (combine l m) = map vector_of m).
  { induction l as [| a l IH]; intros [| b m] equal_; try discriminate; [now split |].
    injection equal_ as equal_. destruct (IH m equal_) as [one other]. cbn [combine map]. rewrite one, other.
    now split. }
  destruct (ends (first :: rest) (rest ++ [first])) as [-> ->]; [rewrite app_length; cbn; lia |].
  apply Permutation_map, Permutation_cons_append.
Qed.

Theorem piece_is_around (t : piece) (x : vector) : is_convex t = true -> t = piece_of (corners_of t) ->
  inside_piece t x -> off x (map segment_of_hedge (sides (corners_of t))) ->
  forall w, eventually (fun e => inside_piece t (moved_along x w e)).
Proof.
  intros convex lines x_in free w.
  assert (fan : has_a_fan (corners_of t) = true) by (unfold is_convex in convex; now apply andb_true_iff in convex).
  destruct (winding_number_near x _ (sides_are_cycles (corners_of t)) free) as (radius & some & near).
  refine (eventually_implied _ _ _ (small_steps_stay_within radius x w some)). intros e close.
  destruct (near _ close) as [_ same_]. clear close. generalize dependent (moved_along x w e). intros z same_.
  pose proof x_in as x_in'. rewrite lines in x_in'.
  destruct (inside_is_in_a_fan_triangle _ _ fan x_in') as (a & b & c & k_in & within_).
  destruct (strictly_inside_near _ _ _ _ radius some (fan_triangles_turn_left _ _ _ _ fan k_in) within_)
    as (y & close & y_c & y_a & y_b).
  destruct (near y close) as [_ same_y]. rewrite <- same_y in same_.
  rewrite !(fan_adds_up _ _ fan) in same_.
  set (number := fun z k => winding_number z (triangle_of k)) in *.
  assert (signs : forall k, In k (fan_triangles (corners_of t)) -> (0 <= number y k)%Z).
  { intros [[a' b'] c'] K. now apply winding_number_of_a_triangle, (fan_triangles_turn_left (corners_of t)). }
  pose proof (proj2 (terms_are_less (number y) _ signs) _ k_in) as less.
  assert (one : number y (a, b, c) = 1%Z)
    by (apply winding_number_of_a_triangle; trivial; now apply (fan_triangles_turn_left (corners_of t))).
  destruct (some_term_is_not_zero (number z) (fan_triangles (corners_of t)))
    as ([[a' b'] c'] & K & round); [unfold number in *; lia |].
  destruct (fan_triangles_have_corners _ _ _ _ K) as (A & B & C).
  pose proof (fan_triangles_turn_left _ _ _ _ fan K) as left_.
  apply (triangle_is_inside t a' b' c'); trivial. now apply winding_number_of_a_triangle.
Qed.

(** Sides are parts of edges, or diagonals *)

Lemma lies_on_either_way (x a b : vector) : lies_on x (Segment a b) -> lies_on x (Segment b a).
Proof.
  intros (k & range & X & Y). exists (1 - k). cbn [source target] in *. split; [lra | rewrite X, Y; split; ring].
Qed.

Lemma source_is_on (a b : vector) : lies_on a (Segment a b).
Proof. exists 0. cbn [source target]. split; [lra | split; ring]. Qed.

Lemma parts_are_on_the_edge (inserted : list hpoint) : forall a b s x, is_split a b inserted = true ->
  In s (split_edge a b inserted) -> lies_on x (segment_of_hedge s) -> lies_on x (segment_of_hedge (a, b)).
Proof.
  induction inserted as [| m rest IH]; intros a b s x; cbn [is_split split_edge].
  - now intros _ [<- | []].
  - rewrite andb_true_iff. intros [between_ split_] I on. apply is_between_lies_on in between_.
    destruct I as [<- | I]; [exact (common_part _ _ _ _ (source_is_on _ _) between_ on) |].
    exact (common_part _ _ _ _ between_ (lies_on_either_way _ _ _ (source_is_on _ _)) (IH m b s x split_ I on)).
Qed.

Lemma inserted_points_are_on_the_edge (inserted : list hpoint) : forall a b m, is_split a b inserted = true ->
  In m inserted -> lies_on (vector_of m) (segment_of_hedge (a, b)).
Proof.
  induction inserted as [| n rest IH]; intros a b m; [easy |]. cbn [is_split].
  rewrite andb_true_iff. intros [between_ split_] I. apply is_between_lies_on in between_.
  destruct I as [<- | I]; [exact between_ |].
  exact (common_part _ _ _ _ between_ (lies_on_either_way _ _ _ (source_is_on _ _)) (IH n b m split_ I)).
Qed.

(* Each entry is of the edge of one of the region. *)
Lemma are_of_region_means (rest : list entry) : forall e found, are_of_region e found rest = true ->
  forall h, In h (e :: rest) ->
    (found = true /\ of_one_edge h e) \/ exists g, In g rest /\ of_region g = true /\ of_one_edge h g.
Proof.
  induction rest as [| f rest IH]; intros e found; cbn [are_of_region].
  - intros -> h [<- | []]. left. now split.
  - destruct (same_hpoint (low e) (low f) && same_hpoint (high e) (high f)) eqn:one_edge.
    + apply same_ends in one_edge. intros accepted h H.
      assert (of_f : of_one_edge h e \/ In h (f :: rest)) by (destruct H as [<- | H]; [now left | now right]).
      assert (there : exists k, In k (f :: rest) /\ of_one_edge h k).
      { destruct of_f as [same_ | I]; [exists f | now exists h].
        split; [now left |]. unfold of_one_edge in *. intuition congruence. }
      destruct there as (k & K & h_k). destruct (IH _ _ accepted k K) as [[flag k_f] | (g & G & region_ & k_g)].
      * apply orb_true_iff in flag. destruct flag as [flag | region_].
        { left. split; [exact flag |]. unfold of_one_edge in *. intuition congruence. }
        right. exists f. split; [now left | split; [exact region_ |]]. unfold of_one_edge in *. intuition congruence.
      * right. exists g. split; [now right | split; [exact region_ |]]. unfold of_one_edge in *. intuition congruence.
    + rewrite andb_true_iff. intros [-> accepted] h [<- | H]; [left; now split |].
      destruct (IH _ _ accepted h H) as [[region_ h_f] | (g & G & region_ & h_g)]; right;
        [exists f | exists g]; (split; [cbn; tauto | now split]).
Qed.

Section Sides.
  Variables (es : list hedge) (inserted : list (list hpoint)) (pieces : list piece).
  Variables (listed : list (BinNums.positive * BinNums.positive * seam)).

  Hypothesis accepted : are_a_region es inserted pieces = true.

  Let diagonals : list (hedge * seam) := diagonals_of es inserted listed.

  Hypothesis all_sides : have_all_sides es inserted pieces (map fst diagonals) = true.

  Theorem sides_are_edges_or_diagonals (t : piece) (side : hedge) (x : vector) :
    In t pieces -> In side (sides (corners_of t)) -> lies_on x (segment_of_hedge side) ->
    (exists e, In e es /\ lies_on x (segment_of_hedge e)) \/
    exists d, In d diagonals /\ lies_on x (segment_of_hedge (fst d)).
  Proof.
    intros T S on. unfold have_all_sides in all_sides. cbv zeta in all_sides.
    set (parts := flat_map (fun s => split_edge (fst (fst s)) (snd (fst s)) (snd s)) (with_inserted es inserted)) in *.
    set (entries := map (entry_of true) (parts ++ map fst diagonals) ++
      map (entry_of false) (flat_map (fun t => sides (corners_of t)) pieces)) in *.
    assert (there : In (entry_of false side) entries).
    { apply in_or_app. right. apply in_map, in_flat_map. now exists t. }
    pose proof (Sorted.Permuted_sort entries) as permuted. apply (Permutation_in _ permuted) in there.
    assert (exists g, In g (Sorted.sort entries) /\ of_region g = true /\ of_one_edge (entry_of false side) g)
      as (g & G & region_ & one_edge).
    { destruct (Sorted.sort entries) as [| e rest]; [easy |].
      destruct (are_of_region_means _ _ _ all_sides _ there) as [[region_ same_] | (g & G & region_ & same_)];
        [exists e | exists g]; (split; [cbn; tauto | now split]). }
    apply (Permutation_in _ (Permutation_sym permuted)), in_app_or in G. destruct G as [G | G].
    2: { apply in_map_iff in G. destruct G as (h & <- & _). now rewrite (proj1 (entry_is false h)) in region_. }
    apply in_map_iff in G. destruct G as (h & <- & H).
    assert (on_h : lies_on x (segment_of_hedge h)).
    { destruct one_edge as [low_is high_is]. destruct side as [a b], h as [c d]. unfold segment_of_hedge in *.
      cbn [fst snd] in *.
      destruct (entry_is false (a, b)) as [_ [(_ & l1 & h1) | (_ & l1 & h1)]],
        (entry_is true (c, d)) as [_ [(_ & l2 & h2) | (_ & l2 & h2)]]; cbn [fst snd] in *;
        rewrite l1, l2 in low_is; rewrite h1, h2 in high_is; subst; trivial; now apply lies_on_either_way. }
    apply in_app_or in H. destruct H as [H | H].
    - left. unfold parts in H. apply in_flat_map in H. destruct H as (s & s_in & part).
      pose proof (edges_are_split _ _ _ accepted s s_in) as split_. exists (fst s). split.
      + rewrite <- (with_inserted_has_the_edges es inserted). now apply in_map.
      + destruct s as [[a b] points]. exact (parts_are_on_the_edge points a b h x split_ part on_h).
    - right. apply in_map_iff in H. destruct H as (d & <- & D). now exists d.
  Qed.

  Theorem ends_of_diagonals_are_on_edges (a b : hpoint) (s : seam) (x : hpoint) : In ((a, b), s) diagonals ->
    x = a \/ x = b -> exists e, In e es /\ lies_on (vector_of x) (segment_of_hedge e).
  Proof.
    unfold diagonals, diagonals_of. cbv zeta. rewrite in_flat_map. intros (d & _ & found).
    set (vertices := numbers_from 1 (map fst es ++ flat_map snd (with_inserted es inserted))) in *.
    assert (is_vertex : forall n y, PositiveMap.find n vertices = Some y ->
      exists e, In e es /\ lies_on (vector_of y) (segment_of_hedge e)).
    { intros n y y_is. apply numbers_are_from in y_is. destruct y_is as [_ Y]. apply in_app_or in Y.
      destruct Y as [Y | Y].
      - apply in_map_iff in Y. destruct Y as (e & <- & E). exists e. split; [exact E | apply source_is_on].
      - apply in_flat_map in Y. destruct Y as (s' & s_in & Y).
        pose proof (edges_are_split _ _ _ accepted s' s_in) as split_. exists (fst s'). split.
        + rewrite <- (with_inserted_has_the_edges es inserted). now apply in_map.
        + destruct s' as [[c e] points]. exact (inserted_points_are_on_the_edge points c e y split_ Y). }
    destruct (PositiveMap.find (fst (fst d)) vertices) eqn:one; [| easy].
    destruct (PositiveMap.find (snd (fst d)) vertices) eqn:other_; [| easy].
    destruct found as [equal_ | []]. injection equal_ as -> -> _. intros [-> | ->]; eauto.
  Qed.
End Sides.
