(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Observation 5.2.1 is false as printed, in its second part, where other segments of the convolution overlap the one
   that the ray leaves: both summands here are a quadrangle with a hole, and an edge of the loop that leads downwards
   is on two segments that do, so that the winding number inside the loop is the ray's number less two. The loop is a
   triangle, a face of the arrangement of all segments, whose edges are parts of the reduced convolution, clockwise.
   What holds is proved in ray_to_the_left.v: all that overlaps counts. *)
From Coq Require Import QArith Lqa ZArith Lia Bool List.
From Oplus Require Import convolution convolution_winding regions meeting_of_segments beside_a_piece location
  signed_crossings small_numbers simple_chain simple_chains_turn_once theorem_4_2_1 reduced_convolution
  checked_collision test_of_regions simple_polygons drawn_regions ray_to_the_left polygons_of_the_thesis.
Import ListNotations.

Open Scope Q_scope.

(* A loop that goes round a hole, clockwise (Section 3.2): its edges are parts of segments of the reduced convolution,
   in their direction, and nothing of the convolution is inside, so that there is one winding number. *)
Definition is_loop_of_a_hole (p q : region) (loop : list vector) : Prop :=
  simple loop /\ is_counterclockwise loop = false /\
  (forall i, (i < length loop)%nat -> exists s, In s (reduced_convolution p q) /\ let e := edge_at loop i in
     lies_on (source e) s /\ lies_on (target e) s /\ 0 < dot (along e) (along s)) /\
  (forall s x, In s (convolution_segments p q) -> lies_on x s -> ~ inside_loop x loop).

(* The winding number inside the loop less what a ray to the left counts that starts at the middle of an edge, a little
   to its right. *)
Definition differs_from_the_ray_by (p q : region) (loop : list vector) (s : segment) (difference : Z) : Prop :=
  eventually (fun e => forall x, inside_loop x loop ->
    winding_number x (convolution_segments p q) =
      (left_ray_number (moved_right (middle_of s) e) (convolution_segments p q) + difference)%Z).

Definition observation_5_2_1_as_printed : Prop :=
  forall p q loop i, valid_region p -> valid_region q -> is_loop_of_a_hole p q loop -> (i < length loop)%nat ->
    let s := edge_at loop i in
    passed_up_or_down (middle_of s) (convolution_segments p q) ->
    (leads_upwards s -> differs_from_the_ray_by p q loop s 0) /\
    (leads_downwards s -> differs_from_the_ray_by p q loop s (-1)).

Definition quadrangle_with_a_hole : region :=
  [points_at [(1, 0); (2, 3); (0, 3); (0, 2)]; points_at [(1, 1); (0, 3); (1, 2); (2, 3)]].
Definition kite_with_a_hole : region :=
  [points_at [(2, 0); (4, 0); (6, 4); (2, 6)]; points_at [(3, 1); (2, 6); (5, 4)]].
Definition triangular_loop : list vector :=
  [Vector (57 # 13) (92 # 13); Vector (63 # 13) (88 # 13); Vector (59 # 13) (82 # 13)].

(* No point has a chain round it whose vertices are all to the left of a line through the point, or on it. *)
Lemma nothing_goes_round_beside_a_line (x d : vector) (loop : list vector) : nonzero d -> off x (edges loop) ->
  (forall v, In v loop -> 0 <= cross d (minus v x)) -> winding_number x (edges loop) = 0%Z.
Proof.
  intros some free beside_.
  rewrite <- (winding_number_by_any_ray x (edges loop) OfP d) by (trivial; apply closed_chain_cycles).
  unfold winding_number_by_ray. assert (none : forall t, In t (edges loop) -> signed_crossing_of_ray OfP d x t = 0%Z).
  { intros t T. apply (In_nth _ _ no_segment) in T. destruct T as (j & J & <-). rewrite edges_are_as_many in J.
    rewrite edge_by_index by exact J. unfold signed_crossing_of_ray, left_of_ray. cbn [source target].
    pose proof (beside_ _ (nth_In loop nowhere J)).
    pose proof (beside_ _ (nth_In loop nowhere (next_in_range j _ J))).
    destruct (negative_spec (cross d (minus (nth j loop nowhere) x))); [lra |].
    destruct (negative_spec (cross d (minus (nth (next j (length loop)) loop nowhere) x))); [lra | reflexivity]. }
  clear free beside_. induction (edges loop) as [| t l IH]; [reflexivity |]. unfold sum in *. cbn [map fold_right].
  rewrite (none t (or_introl eq_refl)), IH; [reflexivity |]. intros u U. apply none. now right.
Qed.

(* A segment passes a chain by, as is computed: the chain is on one side of its line, or it is to the left of the line
   of an edge of the chain, and the chain to its right. *)
Definition all_to_the_left (s : segment) (l : list vector) : bool := forallb (fun v => at_most 0 (area s v)) l.
Definition passes_by (loop : list vector) (s : segment) : bool :=
  negb (is_point (source s) (target s)) &&
  (all_to_the_left s loop || all_to_the_left (reversed s) loop ||
   existsb (fun e => negb (is_point (source e) (target e)) && all_to_the_left e [source s; target s] &&
     all_to_the_left (reversed e) loop) (edges loop)).

Lemma points_apart (a b : vector) : negb (is_point a b) = true -> nonzero (minus b a).
Proof.
  unfold is_point, nonzero, minus. cbn [vx vy]. intros differ [X Y].
  apply negb_true_iff, andb_false_iff in differ. rewrite <- !not_true_iff_false, !Qeq_bool_iff in differ.
  destruct differ as [differ | differ]; apply differ; lra.
Qed.

Lemma what_passes_by_is_not_inside (loop : list vector) (s : segment) (x : vector) :
  passes_by loop s = true -> lies_on x s -> ~ inside_loop x loop.
Proof.
  intros passes on [free inside_]. apply inside_. clear inside_. apply andb_prop in passes.
  destruct passes as [long passes].
  pose proof (points_apart _ _ long : nonzero (along s)) as s_long. pose proof (on_the_line x s on) as line.
  assert (turned : nonzero (opposite (along s))) by (unfold nonzero, opposite in *; cbn [vx vy]; lra).
  assert (spec : forall t l, all_to_the_left t l = true -> forall v, In v l -> 0 <= area t v).
  { intros t l all v V. unfold all_to_the_left in all. rewrite forallb_forall in all. specialize (all v V).
    now destruct (at_most_spec 0 (area t v)). }
  apply orb_prop in passes.
  destruct passes as [passes | passes]; [apply orb_prop in passes; destruct passes as [passes | passes] |].
  - apply (nothing_goes_round_beside_a_line x (along s)); [exact s_long | exact free |]. intros v V.
    pose proof (spec _ _ passes v V). in_coordinates. lra.
  - apply (nothing_goes_round_beside_a_line x (opposite (along s))); [exact turned | exact free |]. intros v V.
    pose proof (spec _ _ passes v V). in_coordinates. lra.
  - apply existsb_exists in passes. destruct passes as (e & _ & passes).
    apply andb_prop in passes. destruct passes as [passes right_]. apply andb_prop in passes.
    destruct passes as [e_long left_].
    pose proof (points_apart _ _ e_long : nonzero (along e)) as some. destruct on as (k & range & X & Y).
    pose proof (spec _ _ left_ (source s) (or_introl eq_refl)) as a.
    pose proof (spec _ _ left_ (target s) (or_intror (or_introl eq_refl))) as b.
    assert (x_left : 0 <= area e x).
    { setoid_replace (area e x) with ((1 - k) * area e (source s) + k * area e (target s)); [nra |].
      unfold area, cross, minus. cbn [vx vy]. rewrite X, Y. ring. }
    apply (nothing_goes_round_beside_a_line x (opposite (along e)));
      [unfold nonzero, opposite in *; cbn [vx vy]; lra | exact free |].
    intros v V. pose proof (spec _ _ right_ v V). clear X Y. in_coordinates. lra.
Qed.

Definition passes_up_or_down (x : vector) (t : segment) : bool :=
  negb (is_on_segment x t) ||
  negb (is_point (source t) x) && negb (is_point (target t) x) && negb (zero (vy (target t) - vy (source t))).

Lemma passed_by_computation (x : vector) (segments : list segment) :
  forallb (passes_up_or_down x) segments = true -> passed_up_or_down x segments.
Proof.
  rewrite forallb_forall. intros each t T on. specialize (each t T). unfold passes_up_or_down in each.
  destruct (is_on_spec x t) as [_ | no]; [| contradiction]. cbn [negb orb] in each.
  apply andb_prop in each. destruct each as [each slanted]. apply andb_prop in each.
  destruct each as [no_source no_target].
  unfold leads_upwards, leads_downwards. split.
  - destruct (inside_or_end x t on) as [inside_ | [[X Y] | [X Y]]]; [exact inside_ | exfalso | exfalso];
      [apply points_apart in no_source; apply no_source | apply points_apart in no_target; apply no_target];
      unfold minus; cbn [vx vy]; split; lra.
  - destruct (zero_spec (vy (target t) - vy (source t))); [discriminate slanted |].
    destruct (Q_dec (vy (source t)) (vy (target t))) as [[less | more] | same_]; [now left | now right | lra].
Qed.

Lemma triangle_is_a_loop : is_loop_of_a_hole quadrangle_with_a_hole kite_with_a_hole triangular_loop.
Proof.
  split; [apply is_simple_decides; vm_compute; reflexivity |]. split; [vm_compute; reflexivity |]. split.
  - assert (found : forall i, (i < 3)%nat -> existsb (fun s => let e := edge_at triangular_loop i in
        is_on_segment (source e) s && is_on_segment (target e) s && positive (dot (along e) (along s)))
        (reduced_convolution quadrangle_with_a_hole kite_with_a_hole) = true)
      by (intros [| [| [| i]]] I; [vm_compute; reflexivity .. | lia]).
    intros i I. specialize (found i I). apply existsb_exists in found. destruct found as (s & S & on). exists s.
    split; [exact S |]. cbv zeta in on |- *. apply andb_prop in on. destruct on as [on way]. apply andb_prop in on.
    destruct on as [on on'].
    split; [now destruct (is_on_spec (source (edge_at triangular_loop i)) s) |].
    split; [now destruct (is_on_spec (target (edge_at triangular_loop i)) s) |].
    now destruct (positive_spec (dot (along (edge_at triangular_loop i)) (along s))).
  - assert (all : forallb (passes_by triangular_loop)
      (convolution_segments quadrangle_with_a_hole kite_with_a_hole) = true)
      by (vm_compute; reflexivity).
    rewrite forallb_forall in all. intros s x S on. exact (what_passes_by_is_not_inside _ s x (all s S) on).
Qed.

Lemma the_edge_is_passed : passed_up_or_down (middle_of (edge_at triangular_loop 1))
  (convolution_segments quadrangle_with_a_hole kite_with_a_hole).
Proof. apply passed_by_computation. vm_compute. reflexivity. Qed.

Lemma both_are_regions : valid_region quadrangle_with_a_hole /\ valid_region kite_with_a_hole.
Proof. split; apply is_valid_region_is_right; vm_compute; reflexivity. Qed.

(* Theorem. *)
Theorem observation_5_2_1_is_false_as_printed : ~ observation_5_2_1_as_printed.
Proof.
  intros printed. destruct both_are_regions as [p_valid q_valid].
  destruct (printed _ _ _ 1%nat p_valid q_valid triangle_is_a_loop ltac:(cbn; lia) the_edge_is_passed) as [_ down].
  assert (way : leads_downwards (edge_at triangular_loop 1)) by (vm_compute; reflexivity). specialize (down way).
  destruct (left_rays_from_a_loop (convolution_segments quadrangle_with_a_hole kite_with_a_hole) triangular_loop 1)
    as [_ right_].
  - apply convolution_is_closed; [apply p_valid | apply q_valid].
  - apply triangle_is_a_loop.
  - apply triangle_is_a_loop.
  - cbn. lia.
  - exact the_edge_is_passed.
  - specialize (right_ way).
    destruct (some_small _ (eventually_and _ _ down right_)) as (e & _ & less & inside_ & _ & number).
    specialize (less _ inside_). rewrite number in less.
    assert (two : upward_less_downward (middle_of (edge_at triangular_loop 1))
      (convolution_segments quadrangle_with_a_hole kite_with_a_hole) = (-2)%Z) by (vm_compute; reflexivity).
    rewrite two in less. lia.
Qed.

(* Theorem, Observation 5.2.1 as corrected. Inside the loop, beside the middle of its edge, the winding number is the
   ray's number if the edge leads upwards; if it leads downwards, all that overlaps it is added, the segments that lead
   upwards less those that lead downwards. *)
Theorem observation_5_2_1_as_corrected (p q : region) (loop : list vector) (i : nat) :
  valid_region p -> valid_region q -> simple loop -> is_counterclockwise loop = false -> (i < length loop)%nat ->
  let c := convolution_segments p q in let s := edge_at loop i in let m := middle_of s in passed_up_or_down m c ->
  (leads_upwards s -> eventually (fun e => let x := moved_right m e in inside_loop x loop /\ off x c /\
     winding_number x c = left_ray_number (moved_right m e) c)) /\
  (leads_downwards s -> eventually (fun e => let x := moved_right m (- e) in inside_loop x loop /\ off x c /\
     winding_number x c = (left_ray_number (moved_right m e) c + upward_less_downward m c)%Z)).
Proof.
  intros p_valid q_valid simple_ clockwise I c s m. apply left_rays_from_a_loop; trivial.
  apply convolution_is_closed; [apply p_valid | apply q_valid].
Qed.

Lemma one_segment_at_a_point (x : vector) (segments : list segment) (t : segment) :
  filter (is_on_segment x) segments = [t] -> leads_downwards t -> upward_less_downward x segments = (-1)%Z.
Proof.
  unfold leads_downwards. intros only way.
  assert (skipped : forall l, upward_less_downward x l = upward_less_downward x (filter (is_on_segment x) l)).
  { induction l as [| u l IH]; [reflexivity |]. unfold upward_less_downward, sum in *. cbn [map fold_right filter].
    destruct (is_on_segment x u) eqn:on; cbn [map fold_right]; rewrite ?on, IH; [reflexivity |]. apply Z.add_0_l. }
  assert (on : is_on_segment x t = true) by (apply (filter_In (is_on_segment x) t segments); rewrite only; now left).
  rewrite skipped, only. unfold upward_less_downward, sum. cbn [map fold_right]. rewrite on.
  destruct (negative_spec (vy (along t))) as [| up]; [reflexivity | exfalso]. unfold along, minus in up.
  cbn [vy] in up. lra.
Qed.

(* Theorem. Where one segment only is at the middle of an edge that leads downwards, it is as printed: less one. *)
Theorem observation_5_2_1_where_nothing_overlaps (p q : region) (loop : list vector) (i : nat) (t : segment) :
  valid_region p -> valid_region q -> simple loop -> is_counterclockwise loop = false -> (i < length loop)%nat ->
  let c := convolution_segments p q in let s := edge_at loop i in let m := middle_of s in passed_up_or_down m c ->
  filter (is_on_segment m) c = [t] -> leads_downwards s -> leads_downwards t ->
  eventually (fun e => let x := moved_right m (- e) in inside_loop x loop /\ off x c /\
    winding_number x c = (left_ray_number (moved_right m e) c - 1)%Z).
Proof.
  intros p_valid q_valid simple_ clockwise I c s m passed_ only way way'.
  destruct (observation_5_2_1_as_corrected p q loop i p_valid q_valid simple_ clockwise I passed_) as [_ down].
  fold c s m in down. rewrite (one_segment_at_a_point m c t only way') in down. exact (down way).
Qed.

(* The loop again, from its edge that leads downwards: the winding number inside is the ray's number less two. *)
Example two_segments_overlap : let c := convolution_segments quadrangle_with_a_hole kite_with_a_hole in
  let m := middle_of (edge_at triangular_loop 1) in
  eventually (fun e => let x := moved_right m (- e) in inside_loop x triangular_loop /\ off x c /\
    winding_number x c = (left_ray_number (moved_right m e) c + -2)%Z).
Proof.
  destruct both_are_regions as [p_valid q_valid].
  destruct (observation_5_2_1_as_corrected _ _ triangular_loop 1 p_valid q_valid) as [_ down];
    [apply triangle_is_a_loop .. | cbn; lia | exact the_edge_is_passed |]. apply down. vm_compute. reflexivity.
Qed.
