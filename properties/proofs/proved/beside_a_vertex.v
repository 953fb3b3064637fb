(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Segments that have nothing but ends in common, seen from an end of some: rays. Left of a ray is right of the next one
   counterclockwise, for between them is nothing: what does not change off the segments is the same on both sides. From
   just beside the one ray to just beside the other one comes in three straight steps. Each ray is the next one of
   another; so around a point as many rays have something on their left as on their right. *)
From Coq Require Import QArith Lqa Qfield ZArith Lia Bool List Permutation.
From Oplus Require Import regions_and_sums rotation distinct balanced_edges right_of_an_edge naive_collision
  collision_is_sound pieces beside_a_piece coordinates filling kept_pieces_go_round.
Import ListNotations.

Open Scope Q_scope.

(* How far b is turned counterclockwise until it comes to u; a full turn if it points there. *)
Definition turned_to (b u : vector) : Q :=
  if Qlt_le_dec (angle b) (angle u) then angle u - angle b else angle u - angle b + 4.

Lemma turned_range (b u : vector) : nonzero b -> nonzero u -> 0 < turned_to b u <= 4.
Proof.
  intros B U. pose proof (angle_range b B). pose proof (angle_range u U).
  unfold turned_to. destruct (Qlt_le_dec _ _); lra.
Qed.

Lemma full_turn (b : vector) : turned_to b b == 4.
Proof. unfold turned_to. destruct (Qlt_le_dec _ _); lra. Qed.

(* The sign of a cross product, by turns from a third vector. *)
Lemma cross_by_turns (b u v : vector) : nonzero b -> nonzero u -> nonzero v ->
  turns_by (turned_to b v - turned_to b u) (cross u v) (dot u v).
Proof.
  intros B U V. pose proof (cross_angle u v U V) as by_angles.
  pose proof (angle_range b B). pose proof (angle_range u U). pose proof (angle_range v V).
  unfold turns_by, turned_to in *. destruct (Qlt_le_dec (angle b) (angle u)), (Qlt_le_dec (angle b) (angle v)); lra.
Qed.

Corollary left_by_turns (b u v : vector) : nonzero b -> nonzero u -> nonzero v ->
  (0 < cross u v <-> 0 < turned_to b v - turned_to b u < 2 \/ turned_to b v - turned_to b u < -2).
Proof. intros B U V. pose proof (cross_by_turns b u v B U V) as signs. unfold turns_by in signs. lra. Qed.

Lemma same_turn (b u v : vector) : nonzero b -> nonzero u -> nonzero v -> turned_to b u == turned_to b v ->
  angle u == angle v.
Proof.
  intros B U V. pose proof (angle_range b B). pose proof (angle_range u U). pose proof (angle_range v V).
  unfold turned_to. destruct (Qlt_le_dec _ _), (Qlt_le_dec _ _); lra.
Qed.

Lemma some_vector (b : vector) (t radius : Q) : nonzero b -> 0 < t < 4 -> 0 < radius ->
  exists m, nonzero m /\ turned_to b m == t /\ forall v, within radius v (plus v m).
Proof.
  intros B range R. pose proof (angle_range b B).
  assert (exists a, 0 <= a < 4 /\ (a == angle b + t \/ a == angle b + t - 4)) as (a & a_range & a_is).
  { destruct (Qlt_le_dec (angle b + t) 4); [exists (angle b + t) | exists (angle b + t - 4)]; lra. }
  set (m := Vector ((1 # 2) * radius * vx (diamond a)) ((1 # 2) * radius * vy (diamond a))).
  assert (m_is : angle m == a) by (apply (angle_diamond m a ((1 # 2) * radius)); (lra || reflexivity)).
  pose proof (diamond_on a a_range) as on. exists m. split; [| split].
  - unfold nonzero, m, on_diamond in *. cbn [vx vy]. nra.
  - unfold turned_to. destruct (Qlt_le_dec _ _); lra.
  - intros v. unfold m, on_diamond, within, plus in *. cbn [vx vy]. nra.
Qed.

Section Rays.
  Variable segments : list segment.
  Hypothesis parts : share_ends_only segments.

  Lemma directed_is_long (s : segment) : directed segments s -> nonzero (along s).
  Proof.
    intros [S | S]; pose proof (are_long _ parts _ S) as long; [exact long |]. intros [X Y]. apply long. by_computing.
  Qed.

  Lemma directed_are_apart (s t : segment) (w : vector) : directed segments s -> directed segments t -> s <> t ->
    s <> reversed t -> strictly_inside w s -> ~ lies_on w t.
  Proof.
    assert (of : forall u, directed segments u -> exists e, In e segments /\ (u = e \/ u = reversed e) /\
      (strictly_inside w u -> strictly_inside w e) /\ (lies_on w u -> lies_on w e)).
    { intros u [U | U]; [exists u; tauto |]. exists (reversed u). split; [exact U |].
      split; [right; now rewrite reversed_twice |]. split; [apply strictly_inside_reversed |].
      intros (k & range & X & Y). at_fraction (1 - k). }
    intros S T differ_ differ_' inside_ on. destruct (of s S) as (e & E & s_is & in_e & _), (of t T)
      as (f & F & t_is & _ & on_f).
    apply (nothing_inside _ parts e f w E F); auto. intros <-.
    destruct s_is as [-> | ->], t_is as [-> | ->]; rewrite ?reversed_twice in *; contradiction.
  Qed.

  Lemma met_by_itself_only (part : list segment) (s : segment) : incl part segments -> directed segments s ->
    met_only_along part s.
  Proof.
    intros incl_ S w t inside_ T on. assert (T' : directed segments t) by (left; auto). unfold collinear.
    destruct (segment_dec s t) as [<- | other]; [| destruct (segment_dec s (reversed t)) as [-> | other']].
    - split; by_coordinates.
    - split; by_coordinates.
    - destruct (directed_are_apart s t w S T' other other' inside_ on).
  Qed.

  Lemma not_turned (e f : segment) : In e segments -> In f segments -> f <> reversed e.
  Proof.
    intros E F ->. pose proof (are_long _ parts e E) as long.
    apply (nothing_inside _ parts e (reversed e) (middle e) E F).
    - intros equal. apply (f_equal source) in equal. apply long. unfold along. cbn in equal. rewrite equal.
      split; unfold minus; cbn; ring.
    - apply strictly_inside_lies_on, strictly_inside_reversed, middle_is_inside.
    - apply middle_is_inside.
  Qed.

  Lemma some_directions (l : list segment) : NoDup l ->
    (forall s, In s l -> directed segments s /\ ~ In (reversed s) l) -> share_ends_only l.
  Proof.
    intros distinct_ all. split; [exact distinct_ | | |].
    - intros s S. now apply directed_is_long, all.
    - intros s t w S T other on inside_. apply (directed_are_apart s t w); try apply all; trivial.
      intros ->. now apply (all t T).
    - intros s t v w S T. destruct (all s S) as [[S' | S'] _], (all t T) as [[T' | T'] _]; intros V W;
        apply (have_same_ends _ parts _ _ v w S' T'); cbn; tauto.
  Qed.

  (* Two rays have two directions. *)
  Lemma rays_differ (s t : segment) : directed segments s -> directed segments t -> source s = source t -> s <> t ->
    ~ angle (along s) == angle (along t).
  Proof.
    intros S T starts other same_angle.
    assert (turned : s <> reversed t).
    { intros ->. apply (directed_is_long t T). unfold along. cbn [reversed source] in starts. rewrite starts.
      split; unfold minus; cbn; ring. }
    assert (all : forall s t c, directed segments s -> directed segments t -> source s = source t -> s <> t ->
      s <> reversed t -> 0 < c <= 1 -> vx (along s) == c * vx (along t) -> vy (along s) == c * vy (along t) -> False).
    { clear - parts. intros s t c S T starts other turned range X Y.
      apply (directed_are_apart s t (middle s) S T other turned (middle_is_inside s)).
      exists ((1 # 2) * c). rewrite <- starts. split; [lra |]. clear - starts X Y.
      apply (f_equal vx) in starts as sx. apply (f_equal vy) in starts as sy.
      to_coordinates. rewrite sx, sy in *. split; lra. }
    apply (same_direction_angle _ _ (directed_is_long s S) (directed_is_long t T)) in same_angle.
    destruct same_angle as (c & some & X & Y). destruct (Qlt_le_dec 1 c) as [more | less].
    - assert (value : / c * c == 1) by (field; lra). set (d := / c) in *. clearbody d.
      apply (all t s d); auto; [intros -> | nra | rewrite X | rewrite Y]; [now rewrite reversed_twice in turned | ..];
        clear - value; by_equations.
    - now apply (all s t c).
  Qed.

  Lemma both_directions (s : segment) : In s (segments ++ map reversed segments) <-> directed segments s.
  Proof.
    unfold directed. rewrite in_app_iff, in_map_iff. enough ((exists e, reversed e = s /\ In e segments) <->
      In (reversed s) segments) by tauto.
    split; [intros (e & <- & E); now rewrite reversed_twice | intros S; exists (reversed s);
      now rewrite reversed_twice].
  Qed.

  Lemma both_directions_are_distinct : NoDup (segments ++ map reversed segments).
  Proof.
    apply NoDup_of_two; [apply (are_distinct _ parts) | |].
    - apply NoDup_images; [apply (are_distinct _ parts) |]. intros e f _ _ equal.
      now rewrite <- (reversed_twice e), equal, reversed_twice.
    - intros e E (f & <- & F)%in_map_iff. now apply (not_turned f (reversed f)).
  Qed.

  (* The rays from a point, and which is the next one. *)
  Definition rays (v : vector) : list segment :=
    filter (fun s => if vector_dec (source s) v then true else false) (segments ++ map reversed segments).

  Lemma rays_are (v : vector) (s : segment) : In s (rays v) <-> directed segments s /\ source s = v.
  Proof.
    unfold rays. rewrite filter_In, both_directions. destruct (vector_dec (source s) v); intuition discriminate.
  Qed.

  Definition next_ray (s : segment) : segment :=
    fold_right (fun u best =>
      if Qlt_le_dec (turned_to (along s) (along u)) (turned_to (along s) (along best)) then u else best)
      s (rays (source s)).

  Lemma next_ray_is (s : segment) : directed segments s ->
    directed segments (next_ray s) /\ source (next_ray s) = source s /\
    forall u, directed segments u -> source u = source s ->
      turned_to (along s) (along (next_ray s)) <= turned_to (along s) (along u).
  Proof.
    intros S. assert (all : (In (next_ray s) (rays (source s)) \/ next_ray s = s) /\ forall u, In u (rays (source s)) ->
      turned_to (along s) (along (next_ray s)) <= turned_to (along s) (along u)).
    { unfold next_ray. induction (rays (source s)) as [| u l [which least]]; cbn [fold_right];
        [now split; [right |] |].
      destruct (Qlt_le_dec _ _); (split; [cbn; tauto |]); intros t [<- | T]; try specialize (least t T); lra. }
    destruct all as [which least]. assert (next_ : In (next_ray s) (rays (source s))).
    { destruct which as [| ->]; [assumption | now apply rays_are]. }
    apply rays_are in next_. split; [| split]; try tauto. intros u U starts. apply least. now apply rays_are.
  Qed.

  Lemma next_rays_differ (s t : segment) : directed segments s -> directed segments t -> source s = source t ->
    next_ray s = next_ray t -> s = t.
  Proof.
    intros S T starts same. destruct (segment_dec s t) as [| other]; [assumption | exfalso].
    pose proof (rays_differ s t S T starts other) as differ_.
    destruct (next_ray_is s S) as (F & _ & first_), (next_ray_is t T) as (_ & _ & first_').
    specialize (first_ t T (eq_sym starts)). specialize (first_' s S starts). rewrite <- same in first_'.
    pose proof (angle_range _ (directed_is_long s S)). pose proof (angle_range _ (directed_is_long t T)).
    pose proof (angle_range _ (directed_is_long _ F)). unfold turned_to in *.
    set (f := along (next_ray s)) in *. destruct (Qlt_le_dec (angle (along s)) (angle f)),
      (Qlt_le_dec (angle (along s)) (angle (along t))), (Qlt_le_dec (angle (along t)) (angle f)),
      (Qlt_le_dec (angle (along t)) (angle (along s))); lra.
  Qed.

  (* Near a point that is an end there are rays only. *)
  Definition is_on_a_ray (v y : vector) : Prop := exists u k, directed segments u /\ source u = v /\ 0 <= k /\
    equal_vectors y (moved_along v (along u) k).
  Definition only_rays_near (v : vector) (radius : Q) : Prop := forall e, In e segments ->
    forall y, within radius v y ->
    lies_on y e -> is_on_a_ray v y.

  Lemma rays_near (s : segment) : directed segments s -> eventually (only_rays_near (source s)).
  Proof.
    intros S. set (v := source s).
    apply (eventually_for_all (fun e r => forall y, within r v y -> lies_on y e -> is_on_a_ray v y)). intros e E.
    destruct (lies_on_dec v e) as [on | free]; [| destruct (off_one_segment_near v e free) as (r & R & near)].
    2: { exists r. split; [exact R |]. intros q _ less y close on. destruct (near y); [| exact on].
      apply (within_smaller q); [lra | exact close]. }
    exists 1. split; [lra |]. intros r _ _ y _ (k & range & X & Y).
    assert (exists f, In f segments /\ (v = source f \/ v = target f)) as (f & F & end_)
      by (destruct S as [S | S]; [exists s | exists (reversed s)]; unfold v; cbn; tauto).
    assert (v = source e \/ v = target e) as [v_is | v_is].
    { destruct (segment_dec e f) as [-> | other]; [exact end_ |].
      assert (on_f : lies_on v f) by (destruct end_ as [-> | ->]; [apply source_lies_on | apply target_lies_on]).
      destruct (inside_or_end v e on) as [inside_ | [equal | equal]];
        [destruct (nothing_inside _ parts e f v E F other on_f inside_) | left | right];
        symmetry; apply (have_same_ends _ parts e f); tauto. }
    - exists e, k. rewrite v_is. split; [now left |]. split; [reflexivity |]. split; [lra |]. by_computing.
    - exists (reversed e), (1 - k). rewrite v_is. split; [right; now rewrite reversed_twice |].
      split; [reflexivity |]. split; [lra |]. by_computing.
  Qed.
End Rays.

Section Sides.
  Variable segments : list segment.
  Hypothesis parts : share_ends_only segments.
  (* What does not change off the segments, up to a relation, and what it is to the right of them. *)
  Context {A : Type}.
  Variable same : A -> A -> Prop.
  Hypothesis same_turned : forall a b, same a b -> same b a.
  Hypothesis same_on : forall a b c, same a b -> same b c -> same a c.
  Variable value : vector -> A.
  Variable on_the_right : segment -> A.
  Hypothesis same_off : forall a b, (forall w, lies_on w (Segment a b) -> off w segments) -> same (value a) (value b).
  Hypothesis same_beside : forall s w n, directed segments s -> strictly_inside w s -> cross (along s) n < 0 ->
    eventually (fun d => same (value (moved_along w n d)) (on_the_right s)).

  Notation next := (next_ray segments).

  (* A step over which no ray leads. *)
  Lemma nothing_is_met (v : vector) (radius : Q) (a b c1 c2 : vector) : only_rays_near segments v radius ->
    within radius v a -> within radius v b -> equal_vectors a (plus v c1) -> equal_vectors b (plus v c2) ->
    0 < cross c1 c2 ->
    (forall u, directed segments u -> source u = v -> 0 <= cross c1 (along u) -> 0 <= cross (along u) c2 -> False) ->
    same (value a) (value b).
  Proof.
    intros near close_1 close_2 [ax ay] [bx by_] left_ none. apply same_off. intros w on e E on_e.
    destruct (near e E w (within_along _ _ _ _ _ close_1 close_2 on) on_e) as (u & k & U & starts & some & X & Y).
    destruct on as (h & range & wx & wy). unfold plus, moved_along in *. cbn [source target vx vy] in *.
    rewrite ax, bx in wx. rewrite ay, by_ in wy.
    assert (ux : k * vx (along u) == (1 - h) * vx c1 + h * vx c2) by lra.
    assert (uy : k * vy (along u) == (1 - h) * vy c1 + h * vy c2) by lra.
    assert (one : k * cross c1 (along u) == h * cross c1 c2).
    { setoid_replace (k * cross c1 (along u)) with (vx c1 * (k * vy (along u)) - vy c1 * (k * vx (along u)))
        by (unfold cross; ring). rewrite ux, uy. unfold cross. ring. }
    assert (two : k * cross (along u) c2 == (1 - h) * cross c1 c2).
    { setoid_replace (k * cross (along u) c2) with ((k * vx (along u)) * vy c2 - (k * vy (along u)) * vx c2)
        by (unfold cross; ring). rewrite ux, uy. unfold cross. ring. }
    assert (0 < k).
    { apply Qnot_le_lt. intros less. assert (k_is : k == 0) by lra. rewrite k_is in one, two. lra. }
    apply (none u U starts); nra.
  Qed.

  (* Theorem. *)
  Theorem beside_the_next_ray (s : segment) : directed segments s ->
    same (on_the_right (reversed s)) (on_the_right (next s)).
  Proof.
    intros S. destruct (next_ray_is segments s S) as (F & starts & first_). set (f := next s) in *.
    set (v := source s) in *. set (b := along s) in *. set (g := along f) in *.
    pose proof (directed_is_long segments parts s S : nonzero b) as b_long.
    pose proof (directed_is_long segments parts f F : nonzero g) as g_long.
    pose proof (turned_range b g b_long g_long) as range. set (t := turned_to b g) in *.
    destruct (some_small _ (rays_near segments parts s S)) as (radius & R & near). fold v in near.
    destruct (some_vector b ((1 # 3) * t) radius) as (m1 & m1_long & m1_at & close_1); [assumption | lra | exact R |].
    destruct (some_vector b ((2 # 3) * t) radius) as (m2 & m2_long & m2_at & close_2); [assumption | lra | exact R |].
    (* a point of each ray, and one beside it *)
    assert (inside_s : forall k, 0 < k < 1 -> strictly_inside (moved_along v b k) s)
      by (intros k k_range; exists k; split; [exact k_range | unfold b, v; clear; by_computing]).
    assert (inside_f : forall k, 0 < k < 1 -> strictly_inside (moved_along v g k) f)
      by (intros k k_range; exists k; split; [exact k_range | rewrite <- starts; unfold g; clear; by_computing]).
    assert (half : 0 < (1 # 2) * radius) by lra.
    destruct (some_small _ (eventually_and _ _ (small_steps_stay_within _ v b half) (eventually_and _ _
      (small_steps_stay_within _ v g half) (eventually_below 1 ltac:(lra))))) as (k & _ & close_s & close_f & k_range).
    set (p := Vector (- vy b) (vx b)). set (q := Vector (vy g) (- vx g)).
    pose proof (square_positive b b_long) as b_square. pose proof (square_positive g g_long) as g_square.
    assert (0 < cross b m1 /\ 0 < cross m1 m2 /\ 0 < cross m2 g) as (b_m1 & m1_m2 & m2_g).
    { pose proof (full_turn b). fold t in range. repeat split; apply (left_by_turns b); trivial; fold t; lra. }
    assert (0 < k * cross b m1 /\ 0 < k * cross m2 g) as [k_m1 k_m2] by (split; apply Qmult_lt_0_compat; lra).
    destruct (some_small _ (eventually_and _ _ (eventually_and _ _
        (same_beside (reversed s) _ p (directed_reversed _ _ S) (strictly_inside_reversed _ _ (inside_s k k_range))
          ltac:(unfold p, b in *; in_coordinates; lra))
        (same_beside f _ q F (inside_f k k_range) ltac:(unfold q, g in *; in_coordinates; lra)))
      (eventually_and _ _ (eventually_and _ _ (eventually_positive _ (cross p m1) k_m1)
        (eventually_positive _ (cross m2 q) k_m2))
      (eventually_and _ _ (small_steps_stay_within _ (moved_along v b k) p half)
        (small_steps_stay_within _ (moved_along v g k) q half)))))
      as (d & some & (beside_s & beside_f) & (c1_m1 & m2_c2) & near_s & near_f).
    set (c1 := minus (moved_along (moved_along v b k) p d) v).
    set (c2 := minus (moved_along (moved_along v g k) q d) v).
    assert (b_c1 : 0 < cross b c1)
      by (setoid_replace (cross b c1) with (d * dot b b) by (unfold c1, p; by_coordinates); nra).
    assert (c2_g : 0 < cross c2 g)
      by (setoid_replace (cross c2 g) with (d * dot g g) by (unfold c2, q; by_coordinates); nra).
    assert (c1_left : 0 < cross c1 m1) by (setoid_replace (cross c1 m1) with (k * cross b m1 + d * cross p m1)
      by (unfold c1, p; by_coordinates); lra).
    assert (c2_left : 0 < cross m2 c2) by (setoid_replace (cross m2 c2) with (k * cross m2 g + d * cross m2 q)
      by (unfold c2, q; by_coordinates); lra).
    assert (differ_ : forall x y : vector, 0 < cross x y -> nonzero x /\ nonzero y)
      by (intros x y turn_; split; intros [X Y]; unfold cross in turn_; rewrite X, Y in turn_; lra).
    destruct (differ_ _ _ c1_left) as [c1_long _], (differ_ _ _ c2_left) as [_ c2_long].
    assert (none : forall c c' u, nonzero c -> nonzero c' -> turned_to b c < turned_to b c' < turned_to b c + 2 ->
      turned_to b c' < t -> directed segments u -> source u = v ->
      0 <= cross c (along u) -> 0 <= cross (along u) c' -> False).
    { intros c c' u C C' order before U is_v after_c before_c'. pose proof (directed_is_long segments parts u U) as U'.
      pose proof (cross_by_turns b c _ b_long C U') as one. pose proof (cross_by_turns b _ c' b_long U' C') as two.
      pose proof (turned_range b _ b_long U'). pose proof (turned_range b c b_long C). specialize (first_ u U is_v).
      unfold turns_by in one, two. lra. }
    assert (before_1 : turned_to b c1 < turned_to b m1).
    { apply (left_by_turns b) in b_c1, c1_left; trivial.
      pose proof (full_turn b). pose proof (turned_range b c1 b_long c1_long). lra. }
    assert (turned_to b m2 < turned_to b c2 < turned_to b m2 + 2 /\ turned_to b c2 < t) as [before_2 before_3].
    { apply (left_by_turns b) in c2_g, c2_left; trivial.
      fold t in c2_g. pose proof (turned_range b c2 b_long c2_long). lra. }
    pose proof (turned_range b c1 b_long c1_long).
    apply (same_on _ _ _ (same_turned _ _ beside_s)). refine (same_on _ _ _ _ beside_f).
    apply (same_on _ (value (plus v m1))); [| apply (same_on _ (value (plus v m2)))].
    - apply (nothing_is_met v radius _ _ c1 m1 near); trivial; [unfold within in *; lra | unfold c1; by_computing |
        reflexivity |]. intros u. apply none; trivial; lra.
    - apply (nothing_is_met v radius _ _ m1 m2 near); trivial; [reflexivity | reflexivity |]. intros u.
      apply none; trivial; lra.
    - apply (nothing_is_met v radius _ _ m2 c2 near); trivial; [unfold within in *; lra | reflexivity |
        unfold c2; by_computing |]. intros u. apply none; trivial; lra.
  Qed.

End Sides.

Section Values.
  Variable segments : list segment.
  Hypothesis parts : share_ends_only segments.
  (* The same with equal values. *)
  Context {A : Type}.
  Variable value : vector -> A.
  Variable on_the_right : segment -> A.
  Hypothesis same_off : forall a b, (forall w, lies_on w (Segment a b) -> off w segments) -> value a = value b.
  Hypothesis same_beside : forall s w n, directed segments s -> strictly_inside w s -> cross (along s) n < 0 ->
    eventually (fun d => value (moved_along w n d) = on_the_right s).

  Notation next := (next_ray segments).

  (* Theorem. *)
  Theorem left_of_a_ray (s : segment) : directed segments s -> on_the_right (reversed s) = on_the_right (next s).
  Proof.
    exact (beside_the_next_ray segments parts eq (@eq_sym A) (@eq_trans A) value on_the_right same_off same_beside s).
  Qed.

  (* Corollary. All rays together have as much on their left as on their right. *)
  Corollary left_and_right_of_rays (number : A -> Z) (v : vector) :
    sum (map (fun s => (number (on_the_right (reversed s)) - number (on_the_right s))%Z) (rays segments v)) = 0%Z.
  Proof.
    assert (next_permutes : Permutation (map next (rays segments v)) (rays segments v)).
    { apply injective_permutes; [now apply NoDup_filter, both_directions_are_distinct | |].
      - intros s [S <-]%rays_are. apply rays_are. destruct (next_ray_is segments s S). tauto.
      - intros s t [S starts]%rays_are [T starts']%rays_are. apply next_rays_differ; trivial. congruence. }
    transitivity (sum (map (fun s => number (on_the_right s)) (map next (rays segments v))) -
      sum (map (fun s => number (on_the_right s)) (rays segments v)))%Z.
    - rewrite map_map.
      rewrite (map_ext_in _ (fun s => number (on_the_right (next s)) - number (on_the_right s))%Z)
        by (intros s [S _]%rays_are; now rewrite left_of_a_ray).
      unfold sum. clear next_permutes. induction (rays segments v) as [| s l IH]; cbn [map fold_right]; lia.
    - rewrite (sum_of_permutation _ _ (Permutation_map _ next_permutes)). lia.
  Qed.
End Values.
