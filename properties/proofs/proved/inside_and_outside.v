(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The inside of a simple polygon is connected by paths of straight steps, and so is its outside. From a point that is
   on no edge go straight ahead until just before an edge is met. Just beside the edges, on one side, one goes all
   around: from an edge to the next one, since between the two there is nothing (beside_a_vertex.v). *)
From Coq Require Import QArith Lqa ZArith Lia Bool List.
From Oplus Require Import regions_and_sums simple_chain simple_chains_turn_once polygons_of_the_thesis connected_sets
  distinct first_edge_of_a_ray beside_a_piece interiors_meet inside_a_corner naive_collision collision_is_sound filling
  kept_pieces_go_round beside_a_vertex just_right_of_a_piece edges_of_polygons boundary_of_the_intersection
  connected_beside_pieces.
Import ListNotations.

Open Scope Q_scope.

(* Along a path off closed segments the winding number stays. *)
Lemma connected_points_have_one_number (l : list segment) (A : vector -> Prop) (a b : vector) : cycles l ->
  (forall z, A z -> off z l) -> connected_in A a b -> winding_number a l = winding_number b l.
Proof.
  intros closed free (path & walk). revert a walk.
  assert (step : forall a c, (forall z, lies_on z (Segment a c) -> A z) -> winding_number a l = winding_number c l).
  { intros a c all. apply (winding_number_along (Segment a c) l closed). intros w on. apply free, all, on. }
  induction path as [| c rest IH]; intros a walk; [now apply step |].
  destruct walk as [first_ walk]. rewrite (step a c first_). now apply IH.
Qed.

(* From a point that is on none of some segments one comes to just beside one of them. *)
Section Segments.
  Variable segments : list segment.
  Hypothesis parts : share_ends_only segments.
  Let off_them := fun z => off z segments.

  Lemma one_comes_to_the_segment (w u : vector) (d : Q) (s : segment) : directed segments s -> strictly_inside w s ->
    cross (along s) u < 0 -> 0 < d ->
    (forall t p, In t segments -> lies_on p (Segment (moved_along w u d) w) -> lies_on p t -> equal_vectors p w) ->
    connected_in off_them (moved_along w u d) (just_right_of segments s).
  Proof.
    intros S inside_ right_ some nothing.
    pose proof (connected_beside segments s (met_by_itself_only segments parts segments s (incl_refl _) S)
      (directed_is_long segments parts s S) w u inside_ right_) as beside.
    destruct (some_small _ (eventually_and _ _ beside (eventually_below d some))) as (e & _ & there & e_some & less).
    refine (connected_on _ _ _ _ _ there). apply connected_by_a_step. intros p (k & range & X & Y) t T on.
    unfold moved_along in X, Y. cbn [source target vx vy] in X, Y. set (h := (1 - k) * d + k * e).
    assert (h_some : 0 < h) by (unfold h; apply mixed_is_more; lra).
    assert (h_most : h <= d) by (unfold h; nra).
    assert (p_is : equal_vectors p (moved_along w u h))
      by (unfold equal_vectors, moved_along, h; cbn [vx vy]; rewrite X, Y; split; ring).
    destruct (nothing t p T) as [X' Y']; [| exact on |].
    - exists (1 - h / d). assert (share : h / d * d == h) by (field; lra).
      assert (0 <= h / d) by (apply Qle_shift_div_l; lra). assert (h / d <= 1) by (apply Qle_shift_div_r; lra).
      destruct p_is as [px py]. unfold moved_along in *. cbn [source target vx vy] in *.
      set (g := h / d) in *. clearbody g. split; [lra |]. rewrite px, py, <- share. split; ring.
    - destruct p_is as [px py]. rewrite px in X'. rewrite py in Y'. unfold moved_along, cross in *. cbn [vx vy] in *.
      assert (vx u == 0) by (apply (Qmult_inj_l _ _ h); lra). assert (vy u == 0) by (apply (Qmult_inj_l _ _ h); lra).
      nra.
  Qed.

  Theorem connected_with_beside (y : vector) : segments <> [] -> off y segments ->
    exists s, directed segments s /\ connected_in off_them y (just_right_of segments s).
  Proof.
    intros some free. assert (exists k, In k segments) as (k & K).
    { destruct segments as [| k l]; [contradiction |]. exists k. now left. }
    pose proof (are_long _ parts k K) as long. pose proof (left_normal k long) as left_.
    set (n := Vector (- vy (along k)) (vx (along k))) in *.
    (* a point close to y that is not on the line of k *)
    destruct (off_near y segments free) as (radius & R & near).
    destruct (some_small _ (eventually_and _ _ (small_steps_stay_within radius y n R)
      (leaves_a_number (area k y) (cross (along k) n) 0 ltac:(lra)))) as (d & _ & close & across).
    set (z := moved_along y n d) in *. pose proof (near z close) as z_free.
    assert (step : connected_in off_them y z).
    { apply connected_by_a_step. intros w on. apply near, (within_along radius y y z w); trivial. unfold within. lra. }
    (* from there a ray that meets k, and no end *)
    destruct (direction_avoiding (flat_map (fun s => [minus (source s) z; minus (target s) z]) segments)
      (minus (source k) z) (minus (target k) z)) as (t & range & avoided).
    { intros c I. apply in_flat_map in I. destruct I as (s & S & I).
      destruct (ends_are_not z s (z_free s S)). destruct I as [<- | [<- | []]]; assumption. }
    { intros none. apply across. rewrite <- none. unfold z, area, cross, along, minus, moved_along. cbn [vx vy]. ring. }
    set (u := Vector _ _) in avoided.
    destruct (ray_meets_one_first z u segments k 1) as (s & far & part & S & far_some & low & high & turn & there &
      nothing); trivial; [| lra | |].
    { intros s S. unfold avoids, side_of. split; apply avoided, in_flat_map; exists s; (split; [exact S | cbn;
      tauto]). }
    { exists t. unfold moved_along, u, minus. cbn [vx vy]. repeat split; try lra; ring. }
    set (w := moved_along z u far) in *.
    assert (inside_ : strictly_inside w s).
    { destruct there as [X Y]. exists part. unfold inside_segment in *. cbn [vx vy] in *. split; [lra |].
      rewrite X, Y. split; ring. }
    assert (z_is : equal_vectors (moved_along w (opposite u) far) z)
      by (unfold equal_vectors, w, moved_along, opposite; cbn [vx vy]; split; ring).
    assert (comes : forall s', directed segments s' -> strictly_inside w s' -> cross (along s') (opposite u) < 0 ->
      connected_in off_them y (just_right_of segments s')).
    { intros s' S' inside' right_. apply (connected_on _ _ z _ step).
      apply (connected_on _ _ (moved_along w (opposite u) far)).
      - apply connected_by_a_step. intros p (h & _ & X & Y). apply (off_equal z); [| exact z_free].
        destruct z_is as [zx zy]. cbn [source target] in X, Y. rewrite zx in X. rewrite zy in Y.
        split; [rewrite X | rewrite Y]; ring.
      - apply one_comes_to_the_segment; trivial. intros other p O on on_other. apply (nothing other p O);
        [| exact on_other].
        destruct on as (h & h_range & X & Y), z_is as [zx zy]. exists h. cbn [source target] in *.
        rewrite zx in X. rewrite zy in Y. split; [assumption | now split]. }
    destruct (Q_dec (cross (along s) (opposite u)) 0) as [[right_ | left_'] | none].
    - exists s. split; [now left |]. apply comes; [now left | exact inside_ | exact right_].
    - exists (reversed s). rewrite <- (reversed_twice s) in S. split; [now right |]. apply comes; [now right | |].
      + now apply strictly_inside_reversed.
      + unfold cross, along, reversed, minus in *. cbn [source target vx vy] in *. lra.
    - exfalso. apply turn. unfold cross, opposite in *. cbn [vx vy] in *. lra.
  Qed.
End Segments.

Section OnePolygon.
  Variable c : list vector.
  Hypothesis polygon : simple_polygon c.
  Let boundary := region_edges [c].
  Let n := length c.
  Let off_it := fun z => off z boundary.
  Let beside := just_right_of boundary.

  Lemma polygon_edges_share_ends : share_ends_only boundary.
  Proof.
    pose proof polygon as [chain_simple _]. pose proof chain_simple as (_ & long & common). fold n in common.
    assert (one : forall i j, (i < n)%nat -> (j < n)%nat -> equal_vectors (vertex c i) (vertex c j) -> i = j).
    { intros i j I J equal. destruct (Nat.eq_dec i j) as [| other]; [assumption |].
      destruct (vertices_differ c i j chain_simple I J other equal). }
    split.
    - unfold boundary. rewrite edges_of_one_by_number. apply NoDup_images; [apply seq_NoDup |].
      intros i j I J equal. apply in_seq in I, J. apply one; [apply I | apply J |].
      rewrite !edge_is in equal by tauto. now injection equal as -> _.
    - exact (polygon_edges_are_long c polygon).
    - intros e f w E F other on inside_. destruct (edges_of_one c e E) as (i & I & -> & _).
      destruct (edges_of_one c f F) as (j & J & -> & _).
      apply other. f_equal. exact (inside_one_edge c polygon i j w I J inside_ on).
    - assert (number : forall e v, In e boundary -> v = source e \/ v = target e -> exists i, (i < n)%nat /\ v =
      vertex c i).
      { intros e v E end_. destruct (edges_of_one c e E) as (i & I & _ & source_is & target_is).
        destruct end_ as [-> | ->]; [exists i; now split | exists (next i n)].
        split; [now apply next_in_range | exact target_is]. }
      intros e f v w E F V W equal. destruct (number e v E V) as (i & I & ->), (number f w F W) as (j & J & ->).
      f_equal. now apply one.
  Qed.
  Let parts := polygon_edges_share_ends.

  Lemma number_beside_an_edge (s : segment) : In s boundary ->
    winding_number (beside s) boundary = 0%Z /\ winding_number (beside (reversed s)) boundary = 1%Z.
  Proof.
    intros S. pose proof (middle_is_inside s) as inside_.
    assert (D : directed boundary s) by now left. pose proof (directed_reversed _ _ D) as D'.
    pose proof (directed_is_long boundary parts s D) as long. pose proof (right_normal s long) as right_.
    pose proof (directed_is_long boundary parts _ D') as long'. pose proof (right_normal _ long') as right_'.
    assert (same_number : forall a b, connected_in off_it a b -> winding_number a boundary = winding_number b boundary).
    { intros a b. apply connected_points_have_one_number; [apply region_cycles | trivial]. }
    pose proof (connected_beside boundary s (met_by_itself_only boundary parts boundary s (incl_refl _) D) long _ _
      inside_ right_) as near.
    pose proof (connected_beside boundary _ (met_by_itself_only boundary parts boundary _ (incl_refl _) D') long' _ _
      (strictly_inside_reversed _ _ inside_) right_') as near'.
    set (m := to_the_right s) in *. set (m' := to_the_right (reversed s)) in *.
    assert (left_ : 0 < cross (along s) m').
    { unfold m', to_the_right, cross, along, reversed, minus in *. cbn [source target vx vy] in *. lra. }
    destruct (some_small _ (eventually_and _ _ (eventually_and _ _ near near')
      (beside_an_edge c polygon s (middle s) m' S inside_ left_))) as (e & _ & [there there'] & one & none).
    rewrite <- (same_number _ (beside s) there), <- (same_number _ (beside (reversed s)) there'). split; [| exact one].
    rewrite <- none. apply winding_number_of_equal; unfold m, m', to_the_right, moved_along, along, reversed, minus;
      cbn [source target vx vy]; ring.
  Qed.

  Lemma beside_the_next (s : segment) : directed boundary s ->
    connected_in off_it (beside (reversed s)) (beside (next_ray boundary s)).
  Proof.
    apply (beside_the_next_ray boundary parts (connected_in off_it) (connected_back off_it) (connected_on off_it)
      (fun v => v) beside).
    - intros a b free. apply connected_by_a_step. exact free.
    - intros t w u T. apply connected_beside; [| exact (directed_is_long boundary parts t T)].
      exact (met_by_itself_only boundary parts boundary t (incl_refl _) T).
  Qed.

  (* Outside, edges are followed; inside, the other way. *)
  Lemma around_the_polygon (i : nat) : (i < n)%nat ->
    connected_in off_it (beside (edge_at c i)) (beside (edge_at c (next i n))) /\
    connected_in off_it (beside (reversed (edge_at c (next i n)))) (beside (reversed (edge_at c i))).
  Proof.
    intros I. pose proof (next_in_range i n I) as I'. set (j := next i n) in *.
    assert (E : In (edge_at c i) boundary) by (apply edge_at_in_region; [now left | exact I]).
    assert (F : In (edge_at c j) boundary) by (apply edge_at_in_region; [now left | exact I']).
    destruct polygon as [chain_simple _].
    (* the rays of vertex j *)
    assert (ray : forall s, directed boundary s -> source s = vertex c j -> s = edge_at c j \/ s = reversed (edge_at c
      i)).
    { intros s [S | S] starts.
      - destruct (edges_of_one c s S) as (k & K & -> & source_is & _). left. f_equal. rewrite starts in source_is.
        destruct (Nat.eq_dec k j) as [| other]; [assumption |].
        destruct (vertices_differ c k j chain_simple K I' other). now rewrite source_is.
      - destruct (edges_of_one c _ S) as (k & K & s_is & _ & target_is). right.
        rewrite <- (reversed_twice s), s_is. do 2 f_equal. cbn [reversed target] in target_is.
          rewrite starts in target_is.
        pose proof (next_in_range k n K) as K'. fold n in target_is.
        destruct (Nat.eq_dec (next k n) j) as [same_ | other].
        + rewrite <- (previous_next k n K), same_. now apply previous_next.
        + destruct (vertices_differ c _ j chain_simple K' I' other). now rewrite target_is. }
    assert (numbers : forall a b, connected_in off_it a b -> winding_number a boundary = winding_number b boundary).
    { intros a b. apply connected_points_have_one_number; [apply region_cycles | trivial]. }
    destruct (number_beside_an_edge _ E) as [e_right e_left], (number_beside_an_edge _ F) as [f_right f_left].
    split.
    - assert (D : directed boundary (reversed (edge_at c i))) by (right; now rewrite reversed_twice).
      pose proof (beside_the_next _ D) as there. rewrite reversed_twice in there.
      destruct (next_ray_is boundary _ D) as (D' & starts & _).
      destruct (ray _ D') as [is_ | is_]; [| rewrite is_ in there; exact there |].
      + rewrite starts. cbn [reversed source]. rewrite edge_is by exact I. reflexivity.
      + rewrite is_ in there. apply numbers in there. exfalso. lia.
    - assert (D : directed boundary (edge_at c j)) by now left.
      pose proof (beside_the_next _ D) as there. destruct (next_ray_is boundary _ D) as (D' & starts & _).
      destruct (ray _ D') as [is_ | is_]; [| | rewrite is_ in there; exact there].
      + rewrite starts, edge_is by exact I'. reflexivity.
      + rewrite is_ in there. apply numbers in there. exfalso. lia.
  Qed.

  Lemma all_around (i : nat) : (i < n)%nat ->
    connected_in off_it (beside (edge_at c 0)) (beside (edge_at c i)) /\
    connected_in off_it (beside (reversed (edge_at c i))) (beside (reversed (edge_at c 0))).
  Proof.
    induction i as [| i IH]; intros I.
    - assert (itself : forall a, off a boundary -> connected_in off_it a a).
      { intros a free. apply connected_by_a_step. intros z (k & _ & X & Y). apply (off_equal a); [| exact free].
        cbn [source target] in *. split; [rewrite X | rewrite Y]; ring. }
      assert (D : directed boundary (edge_at c 0)) by (left; apply edge_at_in_region; [now left | exact I]).
      split; apply itself; apply nothing_just_right; try apply half_way_is; try lra;
        first [apply (directed_is_long boundary parts) | apply (met_by_itself_only boundary parts);
          [apply incl_refl |]];
        trivial; now apply directed_reversed.
    - destruct IH as [outside_ inside_]; [lia |]. destruct (around_the_polygon i) as [next_ next_']; [lia |].
      assert (follows : next i n = S i) by (unfold next; destruct (Nat.eqb_spec (S i) n); lia).
      rewrite follows in *. split; [exact (connected_on _ _ _ _ outside_ next_) | exact (connected_on _ _ _ _ next_'
        inside_)].
  Qed.

  (* Theorem. *)
  Theorem inside_and_outside_are_connected (y z : vector) : off y boundary -> off z boundary ->
    winding_number y boundary = winding_number z boundary -> connected_in off_it y z.
  Proof.
    intros free_y free_z same_. assert (some : boundary <> []).
    { destruct polygon as [(N & _) _]. intros none.
      assert (I : In (edge_at c 0) boundary) by (apply edge_at_in_region; [now left | lia]). now rewrite none in I. }
    assert (all : forall v, off v boundary -> exists i, (i < n)%nat /\
      (winding_number v boundary = 0%Z /\ connected_in off_it v (beside (edge_at c i)) \/
       winding_number v boundary = 1%Z /\ connected_in off_it v (beside (reversed (edge_at c i))))).
    { intros v free. destruct (connected_with_beside boundary parts v some free) as (s & S & there).
      pose proof (connected_points_have_one_number boundary off_it _ _ (region_cycles _) (fun z no => no) there) as
        number.
      destruct S as [S | S]; destruct (edges_of_one c _ S) as (i & I & s_is & _); exists i; (split; [exact I |]).
      - left. rewrite <- s_is. split; [| exact there]. rewrite number. exact (proj1 (number_beside_an_edge s S)).
      - right. rewrite <- s_is, reversed_twice. split; [| exact there]. rewrite number, <- (reversed_twice s) at 1.
        exact (proj2 (number_beside_an_edge _ S)). }
    destruct (all y free_y) as (i & I & number_y), (all z free_z) as (j & J & number_z).
    destruct (all_around i I) as [right_i left_i], (all_around j J) as [right_j left_j].
    destruct number_y as [[y_is there] | [y_is there]], number_z as [[z_is there'] | [z_is there']]; try lia;
      apply (connected_on _ _ _ _ there), connected_back, (connected_on _ _ _ _ there').
    - exact (connected_on _ _ _ _ (connected_back _ _ _ right_j) right_i).
    - exact (connected_on _ _ _ _ left_j (connected_back _ _ _ left_i)).
  Qed.
End OnePolygon.
