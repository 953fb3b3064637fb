(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Walks around faces of the sum. Those of loops_of_the_boundary.v go round what is not in the sum; those that go the
   other way, with the largest clockwise turns, go round faces of the sum: the next ray counterclockwise from an edge
   has on its right what the edge has on its left (beside_a_vertex.v). Algorithm 1 traces them. *)
From Coq Require Import QArith Qminmax Lqa ZArith Lia Bool List Permutation.
From Oplus Require Import simple_when_cut regions_and_sums connected_sets theorem_2_2_10 lemma_2_2_2 inside_a_corner lemma_3_1_2
  distinct balanced_edges observation_2_2_4 simple_chain pieces naive_collision collision_is_sound beside_a_piece
  filling kept_pieces_go_round beside_a_vertex just_right_of_a_piece valid_regions_are_accepted nested_polygons
  region_of_pieces rule_of_sides written_regions sum_is_right printed_lemma_2_2_2 refuted_definition_2_1_9
  refuted_corollary_3_1_3 loops_of_the_boundary algorithm_1 what_algorithm_1_traces printed_observation_3_2_5
  connected_beside_pieces.
Import ListNotations.

Open Scope Q_scope.

(* The edges of the vertices that a closed walk passes are the walk's. *)
Lemma edges_of_a_walk (arrangement loop : list segment) : is_traced_loop arrangement loop ->
  edges (map source loop) = loop.
Proof.
  intros (some & _ & _ & leads). destruct loop as [| e l]; [contradiction |]. cbn [hd_error] in leads.
  assert (targets : rotated (map source (e :: l)) = map target (e :: l)).
  { rewrite (leads_to_starts arrangement (e :: l) e leads). cbn [app tl map rotated]. now rewrite map_app. }
  unfold edges. rewrite targets. clear. generalize (e :: l). intros m.
  induction m as [| [a b] m IH]; [reflexivity |]. cbn [map combine fst snd source target]. now rewrite IH.
Qed.

Section Sum.
  Variables p q : region.
  Hypothesis p_region : valid_region p.
  Hypothesis q_region : valid_region q.

  Let segments := convolution_segments p q.
  Let kept := filled segments.
  Let loops := boundary_loops p q.
  Let loops_ := boundary_loops_are_loops_of_the_sum p q p_region q_region.
  Let parts := kept_share_ends_only _ _ _ _ _ loops_.
  Let edges_are := loops_take_kept _ _ _ _ _ loops_.
  Let the_other_way := map reversed kept.
  Let off_them := fun z => off z kept.
  Let beside := just_right_of kept.

  Lemma the_other_way_is (e : segment) : In e the_other_way <-> In (reversed e) kept.
  Proof.
    unfold the_other_way. rewrite in_map_iff. split; [intros (f & <- & F); now rewrite reversed_twice |].
    intros E. exists (reversed e). now rewrite reversed_twice.
  Qed.

  Lemma it_is_directed (e : segment) : In e the_other_way -> directed kept e.
  Proof. intros E. right. now apply the_other_way_is. Qed.

  Lemma sides_are (f : segment) : In f kept -> winding_number_shifted (right_of_middle f) kept = 0%Z /\
    winding_number_shifted (right_of_middle (reversed f)) kept = 1%Z.
  Proof.
    exact (sides_of_kept segments _ _ (filled_ends_at_pieces segments (all_are_long p q p_region q_region)
      (all_are_closed p q p_region q_region)) kept (Permutation_refl _) f).
  Qed.

  Lemma next_goes_the_other_way (f : segment) : In f kept ->
    In (next_ray kept f) the_other_way /\ source (next_ray kept f) = source f.
  Proof.
    intros F. destruct (next_ray_is kept f (or_introl F)) as (D & starts & _). split; [| exact starts].
    destruct D as [D | D]; [exfalso | now apply the_other_way_is].
    pose proof (cycles_permuted _ _ edges_are (region_cycles loops)) as closed.
    assert (same_number : winding_number_shifted (right_of_middle (reversed f)) kept =
      winding_number_shifted (right_of_middle (next_ray kept f)) kept).
    { apply (left_of_a_ray kept parts (fun x => winding_number x kept)
        (fun s => winding_number_shifted (right_of_middle s) kept)); [| | now left].
      - intros a b free. exact (winding_number_along (Segment a b) kept closed free).
      - intros s w n S. apply to_the_right_of_a_piece; [exact closed | | exact (directed_is_long kept parts s S)].
        exact (met_by_itself_only kept parts kept s (incl_refl _) S). }
    rewrite (proj2 (sides_are f F)), (proj1 (sides_are _ D)) in same_number. discriminate.
  Qed.

  Lemma best_is_next (e : segment) : In e the_other_way ->
    best_direction the_other_way e = Some (next_ray kept (reversed e)) /\
    In (next_ray kept (reversed e)) the_other_way /\ source (next_ray kept (reversed e)) = target e.
  Proof.
    intros E. pose proof (proj1 (the_other_way_is e) E) as F. set (f := next_ray kept (reversed e)).
    destruct (next_goes_the_other_way _ F) as [listed starts]. fold f in listed, starts.
    cbn [reversed source] in starts.
    split; [| now split]. destruct (next_ray_is kept _ (or_introl F)) as (_ & _ & first_). fold f in first_.
    destruct (best_direction the_other_way e) as [g |] eqn:chosen;
      [| destruct (nothing_leaves the_other_way e chosen f listed starts)].
    f_equal. destruct (best_direction_is the_other_way e g chosen) as (G & starts_g & least).
    specialize (least f listed starts). specialize (first_ g (it_is_directed g G) starts_g).
    destruct (segment_dec g f) as [| other]; [assumption | exfalso].
    assert (same_ : turned_to (along (reversed e)) (along g) == turned_to (along (reversed e)) (along f)) by lra.
    pose proof (directed_is_long kept parts) as long.
    apply same_turn in same_; [| exact (long _ (or_introl F)) | exact (long g (it_is_directed g G)) |
      exact (long f (it_is_directed f listed))].
    refine (rays_differ kept parts g f (it_is_directed g G) (it_is_directed f listed) _ other same_). congruence.
  Qed.

  Lemma all_turns_are_traced (e : segment) : In e the_other_way -> In e (concat (algorithm_1 the_other_way)).
  Proof.
    intros E. destruct (edges_around_are_traced the_other_way the_other_way) with (stack := the_other_way)
      (earlier := @nil segment) (e := e) as [yes | two].
    - apply NoDup_images; [apply (are_distinct _ parts) |]. intros f g _ _ equal.
      now rewrite <- (reversed_twice f), equal, reversed_twice.
    - intros f F. destruct (best_is_next f F) as (is_ & G & _). exists (next_ray kept (reversed f)). now split.
    - intros f g F G same_best. destruct (best_is_next f F) as (is_f & _ & starts_f).
      destruct (best_is_next g G) as (is_g & _ & starts_g).
      assert (same_ray : next_ray kept (reversed f) = next_ray kept (reversed g)) by congruence.
      rewrite <- (reversed_twice f), <- (reversed_twice g). apply (f_equal reversed).
      apply the_other_way_is in F, G.
      refine (next_rays_differ kept parts _ _ (or_introl F) (or_introl G) _ same_ray).
      cbn [reversed source]. congruence.
    - constructor.
    - intros f [].
    - apply incl_refl.
    - intros f g [].
    - exact E.
    - exact E.
    - intros [].
    - exact yes.
    - exfalso. destruct (best_is_next e E) as (is_ & F & starts).
      assert (steps : step_on the_other_way e = next_ray kept (reversed e)) by (unfold step_on; now rewrite is_).
      rewrite steps in two. destruct (best_direction_is _ _ _ two) as (_ & starts' & _).
      apply the_other_way_is in E, F.
      set (g := next_ray kept (reversed e)) in *. clearbody g.
      apply (not_turned kept parts _ _ E F). rewrite reversed_twice. unfold reversed. rewrite starts, <- starts'.
      now destruct e.
  Qed.

  Lemma off_beside (e : segment) : In e the_other_way -> off (beside e) kept.
  Proof.
    intros E. pose proof (it_is_directed e E) as D.
    apply (nothing_just_right kept e (directed_is_long kept parts e D)
      (met_by_itself_only kept parts kept e (incl_refl _) D)); [apply half_way_is | lra].
  Qed.

  (* Points just to the right of two edges that follow each other are connected. *)
  Lemma next_has_the_same_face (e : segment) : In e the_other_way ->
    connected_in off_them (beside e) (beside (next_ray kept (reversed e))).
  Proof.
    intros E. apply the_other_way_is in E. rewrite <- (reversed_twice e) at 1.
    apply (beside_the_next_ray kept parts (connected_in off_them) (connected_back off_them) (connected_on off_them)
      (fun v => v) beside); [| | now left].
    - intros a b free. apply connected_by_a_step. exact free.
    - intros s w n S. apply connected_beside; [| exact (directed_is_long kept parts s S)].
      exact (met_by_itself_only kept parts kept s (incl_refl _) S).
  Qed.

  Lemma one_face_along (m : list segment) : forall e end_, incl (e :: m) the_other_way ->
    leads_to the_other_way (e :: m) end_ -> forall f, In f (e :: m) -> connected_in off_them (beside e) (beside f).
  Proof.
    induction m as [| g m IH]; intros e end_ part [is_ leads] f [<- | F];
      try (apply connected_by_a_step; intros z (k & _ & X & Y); apply (off_equal (beside e));
        [split; cbn [source target] in *; rewrite ?X, ?Y; ring | apply off_beside, part; now left]).
    - destruct F.
    - assert (E : In e the_other_way) by (apply part; now left).
      destruct (best_is_next e E) as (best & _ & _). rewrite best in is_. injection is_ as <-.
      apply (connected_on _ _ (beside (next_ray kept (reversed e)))); [now apply next_has_the_same_face |].
      refine (IH _ end_ _ leads f F). intros h H. apply part. now right.
  Qed.

  Lemma inner_by_number (z : vector) : off z kept ->
    (inner_point_of_sum z p q <-> (0 < winding_number z (region_edges loops))%Z).
  Proof.
    intros free. assert (free' : off z (region_edges loops)).
    { intros s S. apply free, (Permutation_in _ edges_are), S. }
    pose proof (loops_fill_the_sum _ _ _ _ _ loops_) as fills. split.
    - intros (radius & R & near). assert (in_ : in_sum z p q) by (apply near; unfold within; lra).
      apply fills in in_. destruct in_ as [some | (s & S & on)]; [exact some | destruct (free' s S on)].
    - intros some. destruct (winding_number_near z _ (region_cycles loops) free') as (radius & R & near).
      exists radius. split; [exact R |]. intros y close. apply fills. left. fold loops.
      now destruct (near y close) as [_ ->].
  Qed.

  Lemma connected_inside (a b : vector) : connected_in off_them a b -> inner_point_of_sum a p q ->
    face_of_the_sum p q a b.
  Proof.
    intros (path & walk). revert a b walk.
    assert (step : forall a c, (forall z, lies_on z (Segment a c) -> off z kept) -> inner_point_of_sum a p q ->
      forall z, lies_on z (Segment a c) -> inner_point_of_sum z p q).
    { intros a c free inner z on. apply (inner_by_number z (free z on)).
      assert (same_number : winding_number a (region_edges loops) = winding_number z (region_edges loops)).
      { apply (winding_number_along (Segment a z) _ (region_cycles loops)). intros w on_w s S on_s.
        apply (free w) with (s := s); [| now apply (Permutation_in _ edges_are) | exact on_s].
        destruct on as (k & range & X & Y), on_w as (h & range' & X' & Y'). cbn [source target] in *.
        exists (h * k). cbn [source target]. split; [split; nra |]. rewrite X', Y', X, Y. split; ring. }
      rewrite <- same_number. apply inner_by_number; [| exact inner].
      apply free. apply (source_lies_on (Segment a c)). }
    induction path as [| c rest IH]; intros a b walk inner.
    - apply connected_by_a_step. exact (step a b walk inner).
    - destruct walk as [first_ walk]. destruct (IH c b walk) as (more & walk').
      { apply (step a c first_ inner). apply (target_lies_on (Segment a c)). }
      exists (c :: more). split; [exact (step a c first_ inner) | exact walk'].
  Qed.

  (* Close to the right of an edge is what its face has there. *)
  Lemma close_to_the_right (e : segment) (x : vector) (radius : Q) : In e the_other_way -> strictly_inside x e ->
    0 < radius -> exists y, within radius x y /\ area e y < 0 /\ connected_in off_them y (beside e) /\
      inner_point_of_sum y p q.
  Proof.
    intros E inside_ R. pose proof (it_is_directed e E) as D. pose proof (directed_is_long kept parts e D) as long.
    pose proof (met_by_itself_only kept parts kept e (incl_refl _) D) as only.
    pose proof (proj1 (the_other_way_is e) E) as F. apply strictly_inside_reversed in inside_ as inside_'.
    destruct (loops_are_valid _ _ _ _ _ loops_) as [valid above].
    apply (kept_are_edges p q _ _ _ loops_) in F as F'.
    destruct (inside_beside_an_edge loops (reversed e) x valid above F' (strictly_inside_lies_on _ _ inside_')
      (no_vertex_inside_kept p q _ _ _ loops_ (reversed e) x F inside_')) as (r1 & R1 & near).
    destruct (some_small _ (eventually_and _ _ (connected_beside kept e only long x (to_the_right e) inside_
      (right_normal e long)) (eventually_and _ _ (small_steps_stay_within r1 x (to_the_right e) R1)
      (small_steps_stay_within radius x (to_the_right e) R)))) as (d & some & connected & close_1 & close).
    set (y := moved_along x (to_the_right e) d) in *.
    assert (right_y : area e y < 0) by exact (right_of_a_step e long x d (strictly_inside_lies_on _ _ inside_) some).
    exists y. split; [exact close |]. split; [exact right_y |]. split; [exact connected |].
    assert (left_y : 0 < area (reversed e) y) by (rewrite area_reversed; lra).
    destruct (proj2 (proj1 (near y close_1)) left_y) as [free number_]. apply inner_by_number; [| exact number_].
    intros s S. apply free, (Permutation_in _ (Permutation_sym edges_are)), S.
  Qed.

  Lemma inside_no_end (e : segment) (x : vector) (radius : Q) : In e the_other_way -> lies_on x e -> 0 < radius ->
    exists y, within radius x y /\ strictly_inside y e.
  Proof.
    intros E on R. pose proof (directed_is_long kept parts e (it_is_directed e E)) as long.
    destruct (no_vertex_near loops e x radius long on R) as (y & close & on_y & no_vertex). exists y.
    split; [exact close |]. apply the_other_way_is, (kept_are_edges p q _ _ _ loops_) in E.
    destruct (inside_or_end y e on_y) as [| [equal | equal]]; [assumption | |]; exfalso; apply no_vertex.
    - apply (vertex_of_equal (target (reversed e))); [exact equal | now apply target_is_vertex].
    - exists (reversed e). split; [exact E | now symmetry].
  Qed.

  (* An edge is on the boundary of the face to its right. *)
  Lemma edge_of_the_face (a : vector) (e : segment) (x : vector) : In e the_other_way -> lies_on x e ->
    face_of_the_sum p q a (beside e) -> on_boundary_of_set (face_of_the_sum p q a) x.
  Proof.
    intros E on face_ radius R. split.
    - destruct (inside_no_end e x ((1 # 2) * radius) E on ltac:(lra)) as (w & close_w & inside_).
      destruct (close_to_the_right e w ((1 # 2) * radius) E inside_ ltac:(lra)) as (y & close & _ & connected & inner).
      exists y. split; [unfold within in *; lra |]. apply (connected_on _ _ _ _ face_), connected_back.
      exact (connected_inside y (beside e) connected inner).
    - assert (boundary : on_boundary_of_sum x p q).
      { apply (boundary_is_kept p q _ _ _ loops_). exists (reversed e). split; [now apply the_other_way_is |].
        destruct on as (k & range & X & Y). exists (1 - k). cbn [reversed source target]. split; [lra |].
        rewrite X, Y. split; ring. }
      destruct (boundary radius R) as [_ (y & close & outside)]. exists y. split; [exact close |].
      intros (path & walk). destruct (leads_to_a_point _ _ _ _ walk) as (r & r_some & near).
      apply outside, near. unfold within. lra.
  Qed.

  (* And a face that has a point inside an edge on its boundary is to the right. *)
  Lemma face_of_the_edge (a : vector) (e : segment) (x : vector) : In e the_other_way -> strictly_inside x e ->
    on_boundary_of_set (face_of_the_sum p q a) x -> face_of_the_sum p q a (beside e).
  Proof.
    intros E inside_ boundary. pose proof (it_is_directed e E) as D.
    pose proof (directed_is_long kept parts e D) as long.
    pose proof (met_by_itself_only kept parts kept e (incl_refl _) D) as only.
    pose proof (strictly_inside_lies_on _ _ inside_) as on.
    destruct (right_half_is_connected kept e only x inside_) as (r1 & R1 & alike).
    destruct (nothing_right_of_kept p q _ _ _ loops_ (reversed e) x (proj1 (the_other_way_is e) E)
      (strictly_inside_reversed _ _ inside_)) as (r2 & R2 & none).
    assert (R : 0 < Qmin r1 ((1 # 2) * r2)) by (apply Q.min_glb_lt; lra).
    destruct (boundary _ R) as [(y & close & path & walk) _].
    pose proof (leads_to_a_point _ _ _ _ walk) as inner.
    pose proof (within_smaller _ _ _ _ (Q.le_min_l r1 ((1 # 2) * r2)) close) as close_1.
    pose proof (within_smaller _ _ _ _ (Q.le_min_r r1 ((1 # 2) * r2)) close) as close_2. clear close.
    assert (right_y : area e y < 0).
    { apply Qnot_le_lt. intros left_. destruct inner as (r & r_some & near).
      set (n := opposite (to_the_right e)). pose proof (right_normal e long) as normal.
      destruct (some_small _ (eventually_and _ _ (small_steps_stay_within r y n r_some)
        (small_steps_stay_within ((1 # 2) * r2) y n ltac:(lra)))) as (d & some & near_y & close_y).
      apply (none (moved_along y n d)); [unfold within in *; lra | | now apply near].
      assert (value : cross (along (reversed e)) (minus (moved_along y n d) x) ==
        - area e y + d * cross (along e) (to_the_right e)).
      { rewrite (area_from x y e on). unfold n, reversed, along, cross, minus, moved_along, opposite.
        cbn [source target vx vy]. ring. }
      rewrite value. nra. }
    destruct (close_to_the_right e x r1 E inside_ R1) as (z & close_z & right_z & connected & _).
    apply (connected_on _ _ y); [now exists path |]. apply connected_inside; [| exact inner].
    apply (connected_on _ _ z); [now apply alike | exact connected].
  Qed.

  Lemma walks_are_weakly_simple (loop : list segment) : is_traced_loop the_other_way loop ->
    weakly_simple (map source loop).
  Proof.
    intros traced. pose proof (edges_of_a_walk _ _ traced) as edges_are_.
    destruct traced as (some & once & part & _).
    assert (edge_is : forall i, edge_at (map source loop) i = nth i loop no_segment)
      by (intros i; unfold edge_at; now rewrite edges_are_).
    assert (apart_ : forall i j x, (i < length loop)%nat -> (j < length loop)%nat -> i <> j ->
      strictly_inside x (nth i loop no_segment) -> ~ lies_on x (nth j loop no_segment)).
    { intros i j x I J other. pose proof (nth_In loop no_segment I) as E. pose proof (nth_In loop no_segment J) as F.
      apply part in E, F. apply (directed_are_apart kept parts _ _ x (it_is_directed _ E) (it_is_directed _ F)).
      - intros same_. apply other. now apply (proj1 (NoDup_nth loop no_segment) once).
      - intros same_. apply the_other_way_is in E, F. rewrite same_, reversed_twice in E.
        apply (not_turned kept parts _ _ F E). now rewrite reversed_twice. }
    unfold weakly_simple, edges_are_interior_disjoint, vertices_touch_from_one_side. cbv zeta.
    rewrite map_length. split.
    - intros i j x I J other [in_i in_j]. rewrite edge_is in in_i, in_j.
      exact (apart_ i j x I J other in_i (strictly_inside_lies_on _ _ in_j)).
    - intros i j I J inside_. exfalso. rewrite edge_is in inside_. unfold vertex in inside_.
      rewrite (nth_indep _ nowhere (source no_segment)) in inside_ by (now rewrite map_length).
      rewrite map_nth in inside_. destruct (Nat.eq_dec i j) as [<- | other].
      + pose proof (part _ (nth_In loop no_segment I)) as E.
        pose proof (directed_is_long kept parts _ (it_is_directed _ E)) as long.
        apply (proj1 (ends_are_not_inside _ _ long inside_)). reflexivity.
      + apply (apart_ j i _ J I (not_eq_sym other) inside_), source_lies_on.
  Qed.
End Sum.
