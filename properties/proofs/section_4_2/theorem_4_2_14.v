(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Theorem 4.2.14 and Section 4.2.4, as numbers of tangent features in every direction, and for an intersection whose
   boundary is given: if the corners of closed chains R are those of the boundary of the intersection of P and -Q + x
   (vertices of one inside the other, and crossings of edges), then the winding number of the original convolution at
   x is the sum of the turning numbers of R: outer chains less holes, if each chain turns once. From
   tangent_features.v, in a direction that no edge has. *)
From Coq Require Import ZArith Lia Bool List SetoidList SetoidPermutation.
From Oplus Require Import numbers convolution tie_rule convolution_winding finite_sums weight regions parallelogram
  tangent_count tangent_features beside_every_point replaced_segments lemma_4_2_15 region_size rows_and_columns
  first_edge_of_a_ray.
Import ListNotations.

Open Scope Q_scope.

Definition bends (c : corner) : bool := negb (zero (cross (incoming c) (outgoing c))).

(* A vertex of -Q + x. *)
Definition opposite_corner (c : corner) : corner := Corner (opposite (incoming c)) (opposite (outgoing c)).

(* Where an edge of P, with direction e, and one of -Q + x, with direction -f, cross, the intersection turns left from
   one to the other. *)
Definition crossing_corner (e f : vector) : corner :=
  if negative (cross e f) then Corner e (opposite f) else Corner (opposite f) e.

Definition is_vertex_inside (x : vector) (segments : list segment) (v : vector * corner) : bool :=
  (0 <? winding_number (minus x (fst v)) segments)%Z.

(* The corners of the boundary of the intersection of P and -Q + x. *)
Definition intersection_corners (x : vector) (p q : region) : list corner :=
  map snd (filter (is_vertex_inside x (region_edges q)) (region_vertices p)) ++
  map (fun v => opposite_corner (snd v)) (filter (is_vertex_inside x (region_edges p)) (region_vertices q)) ++
  map (fun pair => crossing_corner (along (fst pair)) (along (snd pair)))
    (filter (fun pair => negb (winding_number x (parallelogram (fst pair) (snd pair)) =? 0)%Z)
       (list_prod (region_edges p) (region_edges q))).

(* Corners of the same directions: edges may be parts of longer ones. *)
Definition same_corner (c d : corner) : Prop :=
  (nonzero (incoming c) <-> nonzero (incoming d)) /\ (nonzero (outgoing c) <-> nonzero (outgoing d)) /\
  angle (incoming c) == angle (incoming d) /\ angle (outgoing c) == angle (outgoing d).

(* The closed chains r have the corners of that boundary, vertices inside straight lines aside. *)
Definition bounds_the_intersection (r : region) (x : vector) (p q : region) : Prop :=
  PermutationA same_corner (filter bends (flat_map corners r)) (filter bends (intersection_corners x p q)).

Lemma bend_is_proper (c : corner) : bends c = true -> nonzero (incoming c) /\ nonzero (outgoing c).
Proof.
  destruct c as [a b]. unfold bends. cbn [incoming outgoing]. destruct (zero_spec (cross a b)) as [| turn]; [discriminate |].
  intros _. split; intros [X Y]; apply turn; unfold cross; rewrite X, Y; ring.
Qed.

Lemma sweep_of_same (d : direction) (c c' : corner) :
  proper d -> bends c = true -> bends c' = true -> same_corner c c' ->
  sweep d (incoming c) (outgoing c) = sweep d (incoming c') (outgoing c').
Proof.
  intros proper_d bend bend' (_ & _ & same_in & same_out).
  destruct (bend_is_proper c bend) as [proper_a proper_b], (bend_is_proper c' bend') as [proper_a' proper_b'].
  destruct c as [a b], c' as [a' b']. unfold bends in bend, bend'. cbn [incoming outgoing] in *.
  pose proof (cross_angle a b proper_a proper_b) as turn. pose proof (cross_angle a' b' proper_a' proper_b') as turn'.
  unfold turns_by in turn, turn'.
  destruct (zero_spec (cross a b)); [discriminate |]. destruct (zero_spec (cross a' b')); [discriminate |].
  unfold sweep. set (label := other (of d)).
  assert (same_ccw : forall u v u' v', nonzero u -> nonzero v -> nonzero u' -> nonzero v' ->
    angle u == angle u' -> angle v == angle v' ->
    ccw d (Direction u label) (Direction v label) = ccw d (Direction u' label) (Direction v' label)).
  { clear turn turn'. intros u v u' v' pu pv pu' pv' equal_u equal_v.
    destruct (ccw_spec d (Direction u label) (Direction v label) proper_d pu pv),
      (ccw_spec d (Direction u' label) (Direction v' label) proper_d pu' pv'); trivial;
      exfalso; unfold in_order, earlier, place in *; cbn [vec of] in *; order. }
  rewrite (same_ccw a b a' b'), (same_ccw b a b' a') by assumption.
  compared_numbers (cross a b ?= 0); compared_numbers (cross a' b' ?= 0); trivial; exfalso; lra.
Qed.

(* A vertex of -Q + x passes d where that of Q passes -d. *)
Lemma sweep_of_opposite (d : vector) (c : corner) :
  nonzero d -> bends c = true -> ~ cross d (incoming c) == 0 -> ~ cross d (outgoing c) == 0 ->
  sweep (Direction d OfQ) (incoming (opposite_corner c)) (outgoing (opposite_corner c)) =
  sweep (Direction (opposite d) OfP) (incoming c) (outgoing c).
Proof.
  intros proper_d bend beside_in beside_out. destruct (bend_is_proper c bend) as [proper_a proper_b].
  destruct c as [a b]. cbn [incoming outgoing opposite_corner] in *.
  rewrite !sweep_by_sides by (trivial; now apply opposite_nonzero).
  assert (same_left : forall v, ~ cross d v == 0 -> left_of_ray OfQ d (opposite v) = left_of_ray OfP (opposite d) v).
  { intros v beside. assert (cross (opposite v) d == cross d v /\ cross (opposite d) v == - cross d v)
      by (unfold cross, opposite; cbn [vx vy]; split; ring).
    unfold left_of_ray.
    destruct (negative_spec (cross (opposite v) d)), (negative_spec (cross (opposite d) v)); trivial; exfalso; lra. }
  rewrite !same_left by assumption. f_equal. apply compare_as_difference. unfold cross, opposite. cbn [vx vy]. ring.
Qed.

(* The weight of two edges that cross, times the winding number by the boundary of their sum, says whether the
   intersection's corner there passes d. *)
Lemma sweep_of_crossing (d e f : vector) :
  nonzero d -> nonzero e -> nonzero f -> ~ cross d e == 0 -> ~ cross d f == 0 ->
  let c := crossing_corner e f in
  (0 < cross e f -> weight d e f = sweep (Direction d OfQ) (incoming c) (outgoing c)) /\
  (cross e f < 0 -> (- weight d e f)%Z = sweep (Direction d OfQ) (incoming c) (outgoing c)).
Proof.
  intros proper_d proper_e proper_f beside_e beside_f c. unfold c, crossing_corner. clear c.
  pose proof (opposite_nonzero f proper_f) as proper_f'. pose proof (opposite_nonzero d proper_d) as proper_d'.
  pose proof (opposite_angle f proper_f) as of_. pose proof (opposite_angle d proper_d) as od.
  pose proof (angle_range d proper_d). pose proof (angle_range e proper_e). pose proof (angle_range f proper_f).
  pose proof (angle_range _ proper_d'). pose proof (angle_range _ proper_f').
  pose proof (cross_angle d e proper_d proper_e) as d_e. pose proof (cross_angle d f proper_d proper_f) as d_f.
  pose proof (cross_angle e f proper_e proper_f) as e_f. unfold turns_by in d_e, d_f, e_f.
  assert (apart : ~ cross e f == 0 ->
    compare (Direction e OfP) (Direction (opposite f) OfP) <> Eq /\
    compare (Direction (opposite f) OfP) (Direction e OfP) <> Eq).
  { intros turn. assert (differ : ~ angle e == angle (opposite f)) by lra. split.
    - destruct (compare_equal (Direction e OfP) (Direction (opposite f) OfP) proper_e proper_f') as [[equal_ _] |];
        [contradiction | assumption].
    - destruct (compare_equal (Direction (opposite f) OfP) (Direction e OfP) proper_f' proper_e) as [[equal_ _] |];
        [exfalso; apply differ; now symmetry | assumption]. }
  assert (turn_back : cross e (opposite f) == - cross e f /\ cross (opposite f) e == cross e f)
    by (split; unfold cross, opposite; cbn; ring).
  destruct turn_back as [turn_e turn_f].
  assert (no_ties : ~ angle e == angle d /\ ~ angle f == angle (opposite d) /\ ~ angle (opposite f) == angle d)
    by (clear e_f apart; repeat split; lra).
  destruct no_ties as (tie_e & tie_f & tie_f'). clear d_e d_f.
  split; intros sign; destruct (negative_spec (cross e f)) as [is_negative | not_negative]; try (exfalso; lra);
    cbn [incoming outgoing]; unfold sweep; cbn [of other].
  - compared_numbers (cross (opposite f) e ?= 0); try (exfalso; lra).
    rewrite ccw_as_difference; trivial; try discriminate; try (apply apart; lra).
    assert (turn : 0 < angle f - angle e < 2 \/ angle f - angle e < -2) by lra.
    unfold weight. clear C apart turn_e turn_f e_f sign not_negative beside_e beside_f.
    destruct (before_spec (Direction e OfP) (Direction f OfQ) proper_e proper_f),
      (before_spec (Direction f OfQ) (Direction (opposite d) OfP) proper_f proper_d'),
      (before_spec (Direction d OfQ) (Direction (opposite d) OfP) proper_d proper_d'),
      (before_spec (Direction (opposite f) OfP) (Direction d OfQ) proper_f' proper_d),
      (before_spec (Direction e OfP) (Direction (opposite f) OfP) proper_e proper_f');
      cbn [Z.b2z]; try lia; exfalso; unfold earlier, place in *; cbn [vec of] in *; lra.
  - compared_numbers (cross e (opposite f) ?= 0); try (exfalso; lra).
    rewrite ccw_as_difference; trivial; try discriminate; try (apply apart; lra).
    assert (turn : -2 < angle f - angle e < 0 \/ 2 < angle f - angle e) by lra.
    unfold weight. clear C apart turn_e turn_f e_f sign is_negative beside_e beside_f.
    destruct (before_spec (Direction e OfP) (Direction f OfQ) proper_e proper_f),
      (before_spec (Direction f OfQ) (Direction (opposite d) OfP) proper_f proper_d'),
      (before_spec (Direction d OfQ) (Direction (opposite d) OfP) proper_d proper_d'),
      (before_spec (Direction (opposite f) OfP) (Direction d OfQ) proper_f' proper_d),
      (before_spec (Direction (opposite f) OfP) (Direction e OfP) proper_f' proper_e);
      cbn [Z.b2z]; try lia; exfalso; unfold earlier, place in *; cbn [vec of] in *; lra.
Qed.

Lemma no_sweep (d : direction) (c : corner) : bends c = false -> sweep d (incoming c) (outgoing c) = 0%Z.
Proof.
  unfold bends. destruct (zero_spec (cross (incoming c) (outgoing c))) as [straight |]; [intros _ | discriminate].
  unfold sweep. compared_numbers (cross (incoming c) (outgoing c) ?= 0); trivial; exfalso; lra.
Qed.

Lemma bends_equally (c c' : corner) : same_corner c c' -> bends c = true -> bends c' = true.
Proof.
  intros (in_ & out & same_in & same_out) bend. destruct (bend_is_proper c bend) as [proper_a proper_b].
  pose proof (proj1 in_ proper_a) as proper_a'. pose proof (proj1 out proper_b) as proper_b'. clear in_ out.
  destruct c as [a b], c' as [a' b']. unfold bends in *. cbn [incoming outgoing] in *.
  pose proof (cross_angle a b proper_a proper_b) as turn. pose proof (cross_angle a' b' proper_a' proper_b') as turn'.
  unfold turns_by in turn, turn'.
  destruct (zero_spec (cross a b)); [discriminate |]. destruct (zero_spec (cross a' b')); [| reflexivity].
  exfalso. lra.
Qed.

Lemma same_corner_back (c c' : corner) : same_corner c c' -> same_corner c' c.
Proof. intros (in_ & out & same_in & same_out). unfold same_corner. repeat split; tauto || now symmetry. Qed.

Lemma sweep_respects (d : direction) (c c' : corner) : proper d -> same_corner c c' ->
  sweep d (incoming c) (outgoing c) = sweep d (incoming c') (outgoing c').
Proof.
  intros proper_d same_. destruct (bends c) eqn:bend.
  - apply sweep_of_same; trivial. now apply (bends_equally c).
  - rewrite (no_sweep d c bend). destruct (bends c') eqn:bend'; [| now rewrite no_sweep].
    rewrite (bends_equally c' c) in bend; [discriminate | now apply same_corner_back | exact bend'].
Qed.

Definition sweep_at (d : vector) (c : corner) : Z := sweep (Direction d OfQ) (incoming c) (outgoing c).

Lemma sum_over_same_corners (d : vector) (l m : list corner) :
  nonzero d -> PermutationA same_corner l m -> sum_of (sweep_at d) l = sum_of (sweep_at d) m.
Proof.
  intros proper_d permuted.
  induction permuted as [| c c' rest rest' same_ _ IH | c c' rest | some others more _ IH _ IH'];
    rewrite ?sum_of_more; try lia.
  assert (sweep_at d c = sweep_at d c') by (now apply sweep_respects). lia.
Qed.

Lemma sum_over_bends (d : vector) (l : list corner) : sum_of (sweep_at d) (filter bends l) = sum_of (sweep_at d) l.
Proof.
  rewrite sum_of_filter. apply sum_equally. intros c _. destruct (bends c) eqn:bend; cbn [Z.b2z]; [lia |].
  unfold sweep_at. rewrite no_sweep by exact bend. lia.
Qed.

Section OneDirection.
  Variables p q : region.
  Variables d x : vector.
  Hypothesis proper_d : nonzero d.
  Hypothesis p_edges : forall e, In e (region_edges p) -> nonzero (along e) /\ ~ cross d (along e) == 0.
  Hypothesis q_edges : forall f, In f (region_edges q) -> nonzero (along f) /\ ~ cross d (along f) == 0.

  Lemma sum_over_vertices (r : region) (others : list segment) (g : vector * corner -> Z) :
    (forall v, In v (region_vertices r) -> (0 <= winding_number (minus x (fst v)) others <= 1)%Z) ->
    sum_of g (filter (is_vertex_inside x others) (region_vertices r)) =
    sum_of (fun v => g v * winding_number (minus x (fst v)) others)%Z (region_vertices r).
  Proof.
    intros once. rewrite sum_of_filter. apply sum_equally. intros v I. specialize (once v I). unfold is_vertex_inside.
    set (times := winding_number (minus x (fst v)) others) in *. clearbody times.
    destruct (Z.ltb_spec 0 times); cbn [Z.b2z].
    - assert (times = 1%Z) as -> by lia. lia.
    - assert (times = 0%Z) as -> by lia. lia.
  Qed.

  Lemma corner_of_opposite (v : vector * corner) : In v (region_vertices q) ->
    sweep_at d (opposite_corner (snd v)) =
    sweep (Direction (opposite d) OfP) (incoming (snd v)) (outgoing (snd v)).
  Proof.
    destruct v as [v c]. intros I. cbn [snd]. unfold sweep_at.
    destruct (edges_of_vertex v c q I) as [(s & S & _ & s_in) (t & T & _ & t_out)].
    destruct (bends c) eqn:bend.
    - apply sweep_of_opposite; trivial; [rewrite <- s_in | rewrite <- t_out]; now apply q_edges.
    - rewrite (no_sweep _ c bend). apply no_sweep. unfold bends in *. cbn [opposite_corner incoming outgoing].
      destruct (zero_spec (cross (incoming c) (outgoing c))) as [straight |]; [| discriminate].
      destruct (zero_spec (cross (opposite (incoming c)) (opposite (outgoing c)))) as [| turn]; [reflexivity |].
      exfalso. apply turn. rewrite <- straight. unfold cross, opposite. cbn. ring.
  Qed.

  Lemma sum_over_crossings :
    sum_of (fun pair => sweep_at d (crossing_corner (along (fst pair)) (along (snd pair))))
      (filter (fun pair => negb (winding_number x (parallelogram (fst pair) (snd pair)) =? 0)%Z)
         (list_prod (region_edges p) (region_edges q))) =
    tangent_crossings d x (region_edges p) (region_edges q).
  Proof.
    unfold tangent_crossings. rewrite sum_of_filter. apply sum_equally. intros [e f] I.
    apply in_prod_iff in I. destruct I as [E F]. cbn [fst snd]. destruct (p_edges e E) as [proper_e beside_e].
    destruct (q_edges f F) as [proper_f beside_f].
    destruct (sweep_of_crossing d (along e) (along f) proper_d proper_e proper_f beside_e beside_f)
      as [left_turn right_turn]. unfold sweep_at.
    destruct (parallelogram_winding_number x e f) as [-> | [[[-> sign] | [-> sign]] _]]; cbn [Z.eqb negb Z.b2z].
    - lia.
    - rewrite <- (left_turn sign). lia.
    - rewrite <- (right_turn sign). lia.
  Qed.

  Lemma sum_over_the_intersection :
    (forall v, In v (region_vertices p) -> (0 <= winding_number (minus x (fst v)) (region_edges q) <= 1)%Z) ->
    (forall v, In v (region_vertices q) -> (0 <= winding_number (minus x (fst v)) (region_edges p) <= 1)%Z) ->
    sum_of (sweep_at d) (intersection_corners x p q) = tangent_features d x p q.
  Proof.
    intros p_once q_once. unfold intersection_corners, tangent_features.
    rewrite !sum_of_two_lists, !sum_of_images, Z.add_assoc, sum_over_crossings. f_equal. f_equal.
    - apply sum_over_vertices. exact p_once.
    - unfold signed_tangent_vertices.
      rewrite <- (sum_over_vertices q (region_edges p)
        (fun v => sweep (Direction (opposite d) OfP) (incoming (snd v)) (outgoing (snd v))) q_once).
      apply sum_equally. intros v I. apply filter_In in I. now apply corner_of_opposite.
  Qed.
End OneDirection.

Lemma turning_numbers_by_corners (r : region) (d : vector) : turns_in_all_chains r -> nonzero d ->
  sum_of (sweep_at d) (flat_map corners r) = turning_numbers r.
Proof.
  intros turning proper_d. rewrite sum_of_flat_map. apply sum_equally. intros chain I.
  exact (turns_past_every_direction chain (Direction d OfQ) (turning chain I) proper_d).
Qed.

(* Theorem. The winding number of the original convolution at x is the signed number of features of the intersection
   of P and -Q + x at which d is tangent, in every direction d. *)
Theorem original_winding_number_counts_tangent_features (p q : region) (d x : vector) :
  turns_in_all_chains p -> turns_in_all_chains q -> nonzero d ->
  winding_number x (original_convolution p q) = tangent_features d x p q.
Proof.
  intros p_turns q_turns proper_d. rewrite <- winding_number_less_reflex_vertices by assumption.
  apply winding_number_of_replaced_segments.
Qed.

(* Theorem. P and Q are regions of which no vertex is more than once inside the other. If the corners of the closed
   chains r are those of the boundary of the intersection of P and -Q + x, then the winding number of the original
   convolution at x is the sum of the turning numbers of r. *)
Theorem original_winding_number_is_the_turning_number_of_the_intersection (p q r : region) (x : vector) :
  turns_in_all_chains p -> turns_in_all_chains q -> turns_in_all_chains r ->
  (forall v, In v (region_vertices p) -> (0 <= winding_number (minus x (fst v)) (region_edges q) <= 1)%Z) ->
  (forall v, In v (region_vertices q) -> (0 <= winding_number (minus x (fst v)) (region_edges p) <= 1)%Z) ->
  bounds_the_intersection r x p q ->
  winding_number x (original_convolution p q) = turning_numbers r.
Proof.
  intros p_turns q_turns r_turns p_once q_once bounds.
  assert (directions : forall s, turns_in_all_chains s -> forall e, In e (region_edges s) -> nonzero (along e)).
  { intros s s_turns e I. apply in_flat_map in I. destruct I as (chain & J & I).
    apply (turning_chains_have_edges chain (s_turns chain J)). unfold edge_directions.
    apply in_map_iff. now exists e. }
  destruct (direction_beside (map along (region_edges p ++ region_edges q))) as (d & proper_d & beside).
  { intros v I. apply in_map_iff in I. destruct I as (e & <- & I). apply in_app_iff in I.
    destruct I as [I | I]; [now apply (directions p) | now apply (directions q)]. }
  rewrite (original_winding_number_counts_tangent_features p q d x p_turns q_turns proper_d).
  rewrite <- (turning_numbers_by_corners r d r_turns proper_d), <- sum_over_bends.
  rewrite (sum_over_same_corners d _ _ proper_d bounds), sum_over_bends.
  symmetry. apply sum_over_the_intersection; trivial; intros e I; split.
  - exact (directions p p_turns e I).
  - apply beside, in_map, in_app_iff. now left.
  - exact (directions q q_turns e I).
  - apply beside, in_map, in_app_iff. now right.
Qed.

(* As valid regions have. *)
Definition numbers_are_0_or_1 (r : region) : Prop :=
  forall x, off x (region_edges r) -> (0 <= winding_number x (region_edges r) <= 1)%Z.

Lemma numbers_are_0_or_1_everywhere (r : region) (x : vector) :
  numbers_are_0_or_1 r -> (0 <= winding_number x (region_edges r) <= 1)%Z.
Proof. intros valid. destruct (winding_number_beside x (region_edges r)) as (y & beside & <-). now apply valid. Qed.

(* Theorem. So if winding numbers of P and of Q are 0 and 1, and r consists of outer chains and holes, it is the number
   of outer chains less that of holes. *)
Theorem original_winding_number_counts_components_less_holes (p q outer_chains holes : region) (x : vector) :
  turns_in_all_chains p -> turns_in_all_chains q -> turns_in_all_chains (outer_chains ++ holes) ->
  numbers_are_0_or_1 p -> numbers_are_0_or_1 q -> bounds_the_intersection (outer_chains ++ holes) x p q ->
  (forall chain, In chain outer_chains -> outer chain) -> (forall chain, In chain holes -> hole chain) ->
  winding_number x (original_convolution p q) = (Z.of_nat (length outer_chains) - Z.of_nat (length holes))%Z.
Proof.
  intros p_turns q_turns r_turns p_valid q_valid bounds are_outer are_holes.
  rewrite (original_winding_number_is_the_turning_number_of_the_intersection p q (outer_chains ++ holes) x); trivial;
    [| intros v _; now apply numbers_are_0_or_1_everywhere ..].
  change (turning_numbers (outer_chains ++ holes)) with (sum_of turning_number (outer_chains ++ holes)).
  rewrite sum_of_two_lists.
  assert (constant : forall (l : region) k, (forall chain, In chain l -> turning_number chain = k) ->
    sum_of turning_number l = (k * Z.of_nat (length l))%Z).
  { intros l k each. induction l as [| chain l IH]; [rewrite sum_of_nil; cbn; ring |].
    rewrite sum_of_more, (each chain (or_introl eq_refl)), IH by (intros; apply each; now right).
    cbn [length]. rewrite Nat2Z.inj_succ. ring. }
  rewrite (constant outer_chains 1%Z are_outer), (constant holes (-1)%Z are_holes). lia.
Qed.
