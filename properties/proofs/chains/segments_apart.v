(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* When two segments have no point in common, by signs: all vectors from the one to the other are on one side
   of a line, and one of three lines will do. Whether two consecutive edges have only their common vertex
   in common is a question of signs, too. Used for simple chains (simple_chain.v). *)
From Coq Require Import Bool List.
From Oplus Require Import numbers winding rotation secants meeting_of_segments.
Import ListNotations.

Open Scope Q_scope.

(* To the left, by a right angle. *)
Definition normal (u : vector) : vector := Vector (- vy u) (vx u).

(* Normals of the two segments, and the direction of the first, which decides if both are on one line. *)
Definition candidates (a b c e : vector) : list vector :=
  let u := minus b a in let v := minus e c in
  [normal u; normal v; u].

Definition is_separated_by (w a b c e : vector) : bool :=
  let sides := map (dot w) [minus c a; minus c b; minus e a; minus e b] in
  forallb positive sides || forallb negative sides.

(* Whether the segment from a to b and that from c to e have no point in common. *)
Definition are_apart (a b c e : vector) : bool :=
  existsb (fun w => is_separated_by w a b c e) (candidates a b c e).

Lemma separated_spec (w a b c e : vector) :
  is_separated_by w a b c e = true <->
  (0 < dot w (minus c a) /\ 0 < dot w (minus c b) /\ 0 < dot w (minus e a) /\ 0 < dot w (minus e b)) \/
  (dot w (minus c a) < 0 /\ dot w (minus c b) < 0 /\ dot w (minus e a) < 0 /\ dot w (minus e b) < 0).
Proof.
  assert (negatives : forall q, negative q = true <-> q < 0)
    by (intros q; destruct (negative_spec q); intuition discriminate).
  assert (positives : forall q, positive q = true <-> 0 < q)
    by (intros q; destruct (positive_spec q); intuition discriminate).
  unfold is_separated_by. cbn [map forallb].
  rewrite orb_true_iff, !andb_true_iff, !positives, !negatives.
  split; (intros [sides | sides]; [left | right]; repeat split; apply sides).
Qed.

Lemma are_apart_sound (a b c e : vector) : are_apart a b c e = true -> apart a b c e.
Proof.
  unfold are_apart, apart. rewrite existsb_exists. intros (w & _ & separated).
  apply separated_spec in separated. unfold in_front.
  destruct separated as [separated | separated]; [now exists w |].
  exists (opposite w).
  assert (flipped : forall x, dot (opposite w) x == - dot w x)
    by (intros x; unfold dot, opposite; cbn [vx vy]; ring).
  rewrite !flipped. lra.
Qed.

(* Segments that are apart have no point in common. *)
Lemma apart_have_no_common_point (a b c e x : vector) :
  apart a b c e -> lies_on x (Segment a b) -> ~ lies_on x (Segment c e).
Proof.
  intros (w & ca & cb & ea & eb) (s & range_s & xs & ys) (t & range_t & xt & yt). unfold in_front in *.
  pose proof (mixed_is_more t _ _ 0 range_t (mixed_is_more s _ _ 0 range_s ca cb) (mixed_is_more s _ _ 0 range_s ea eb))
    as some.
  assert (none : (1 - t) * ((1 - s) * dot w (minus c a) + s * dot w (minus c b)) +
                 t * ((1 - s) * dot w (minus e a) + s * dot w (minus e b)) == 0) by (in_coordinates; by_equations).
  lra.
Qed.

Lemma on_segment (a b x : vector) (t : Q) :
  0 <= t <= 1 -> equal_vectors x (Vector (vx a + t * (vx b - vx a)) (vy a + t * (vy b - vy a))) ->
  lies_on x (Segment a b).
Proof. intros r [x_is y_is]. cbn [vx vy] in *. exists t. cbn [source target]. repeat split; lra. Qed.

(* Two points of a line on two sides of a third have it on their segment. *)
Lemma between_on_one_line (u a c e : vector) :
  nonzero u -> cross u (minus c a) == 0 -> cross u (minus e a) == 0 ->
  dot u (minus c a) * dot u (minus e a) <= 0 -> lies_on a (Segment c e).
Proof.
  intros nu on_c on_e sides. pose proof (square_positive u nu) as square. apply lies_on_by_signs. cbn [source target].
  set (p := minus c a) in *. set (q := minus e a) in *.
  assert (turn : dot u u * cross p q == dot u p * cross u q - cross u p * dot u q) by (unfold cross, dot; ring).
  assert (scalar : dot u u * dot p q == dot u p * dot u q + cross u p * cross u q) by (unfold cross, dot; ring).
  rewrite on_c, on_e in turn, scalar. split; [apply (Qmult_inj_l _ _ (dot u u)); lra | nra].
Qed.

(* On the line of the segment from a to b, a point that is neither before a nor after b is on it. *)
Lemma between_the_ends (a b z : vector) :
  nonzero (minus b a) -> cross (minus b a) (minus z a) == 0 ->
  0 <= dot (minus b a) (minus z a) -> dot (minus b a) (minus z b) <= 0 -> lies_on z (Segment a b).
Proof.
  intros n on after_a before_b. set (u := minus b a) in *.
  assert (back : forall y, cross u (minus y z) == - cross u (minus z y) /\ dot u (minus y z) == - dot u (minus z y))
    by (intros y; unfold cross, dot, minus; cbn [vx vy]; split; ring).
  assert (on_b : cross u (minus z b) == cross u (minus z a)) by (unfold u, cross, minus; cbn [vx vy]; ring).
  destruct (back a), (back b). apply (between_on_one_line u); trivial; nra.
Qed.

Definition have_a_common_point (a b c e : vector) : Prop :=
  exists x, lies_on x (Segment a b) /\ lies_on x (Segment c e).

(* Lines that are not parallel meet; if not within one of two segments, the other's line separates them. *)
Lemma meeting_lines (a b c e : vector) :
  let u := minus b a in let v := minus e c in
  ~ cross u v == 0 ->
  have_a_common_point a b c e \/
  is_separated_by (normal u) a b c e = true \/ is_separated_by (normal v) a b c e = true.
Proof.
  intros u v crossing_lines. rewrite !separated_spec.
  set (F := area (Segment c e) a). set (T := area (Segment c e) b).
  set (U := area (Segment a b) c). set (V := area (Segment a b) e).
  assert (by_u : dot (normal u) (minus c a) == U /\ dot (normal u) (minus c b) == U /\
                 dot (normal u) (minus e a) == V /\ dot (normal u) (minus e b) == V)
    by (unfold U, V, u, normal; in_coordinates; repeat split; ring).
  assert (by_v : dot (normal v) (minus c a) == - F /\ dot (normal v) (minus c b) == - T /\
                 dot (normal v) (minus e a) == - F /\ dot (normal v) (minus e b) == - T)
    by (unfold F, T, v, normal; in_coordinates; repeat split; ring).
  assert (turn : F - T == cross u v /\ U - V == - cross u v)
    by (unfold F, T, U, V, u, v; in_coordinates; split; ring).
  assert (same_or_not : forall x y : Q, (0 <= x /\ y <= 0 \/ x <= 0 /\ 0 <= y) \/ x < 0 /\ y < 0 \/ 0 < x /\ 0 < y)
    by (intros x y; lra).
  destruct (same_or_not F T) as [step_signs | same]; [| right; right; lra].
  destruct (same_or_not U V) as [signs | same]; [| right; left; lra].
  left. apply common_point; trivial; fold F T U V; lra.
Qed.

(* Parallel lines that are not one separate the segments. *)
Lemma parallel_lines (a b c e : vector) :
  let u := minus b a in
  cross u (minus e c) == 0 -> ~ cross u (minus c a) == 0 -> is_separated_by (normal u) a b c e = true.
Proof.
  intros u parallel beside.
  assert (sides : dot (normal u) (minus c a) == cross u (minus c a) /\
                  dot (normal u) (minus c b) == cross u (minus c a) /\
                  dot (normal u) (minus e a) == cross u (minus c a) /\
                  dot (normal u) (minus e b) == cross u (minus c a)).
  { repeat split; unfold normal, dot, cross, u, minus in *; cbn [vx vy] in *; lra. }
  apply separated_spec. destruct sides as (-> & -> & -> & ->).
  destruct (Q_dec (cross u (minus c a)) 0) as [[? | ?] | ?]; [right | left | contradiction]; lra.
Qed.

Lemma parallel_segments (a b c e : vector) :
  let u := minus b a in let v := minus e c in
  nonzero u -> cross u v == 0 -> have_a_common_point a b c e \/ are_apart a b c e = true.
Proof.
  intros u v nu parallel. pose proof (square_positive u nu) as square.
  assert (by_one : forall w, In w (candidates a b c e) -> is_separated_by w a b c e = true -> are_apart a b c e = true)
    by (intros w I found; apply existsb_exists; now exists w).
  destruct (zero_spec (cross u (minus c a))) as [on_c | beside];
    [| right; apply (by_one (normal u)); [now left | now apply parallel_lines]].
  assert (by_u : is_separated_by u a b c e = true -> are_apart a b c e = true)
    by (apply by_one; right; right; now left).
  rewrite separated_spec in by_u.
  assert (on_e : cross u (minus e a) == 0) by (unfold cross, u, v, minus in *; cbn [vx vy] in *; lra).
  assert (at_b : forall z, cross u (minus z b) == cross u (minus z a) /\
                           dot u (minus z b) == dot u (minus z a) - dot u u)
    by (intros z; unfold cross, dot, u, minus; cbn [vx vy]; split; ring).
  destruct (at_b c) as [c_line c_b], (at_b e) as [e_line e_b].
  destruct (Qlt_le_dec 0 (dot u (minus c a) * dot u (minus e a))) as [a_beside |];
    [| left; exists a; split; [exact (source_lies_on (Segment a b)) | now apply (between_on_one_line u)]].
  destruct (Qlt_le_dec 0 (dot u (minus c b) * dot u (minus e b))) as [b_beside |];
    [| left; exists b; split; [exact (target_lies_on (Segment a b)) | apply (between_on_one_line u); trivial; lra]].
  destruct (Qlt_le_dec (dot u (minus c a)) 0) as [c_before | c_after];
    [right; apply by_u; right; repeat split; nra |].
  destruct (Qlt_le_dec 0 (dot u (minus c b))) as [c_beyond | c_within];
    [right; apply by_u; left; repeat split; nra | left].
  exists c. split; [now apply between_the_ends | exact (source_lies_on (Segment c e))].
Qed.

(* Theorem. Two segments, the first of which is not a point, are found to be apart, or have a point in common;
   never both. *)
Theorem are_apart_decides (a b c e : vector) :
  nonzero (minus b a) ->
  (are_apart a b c e = true \/ have_a_common_point a b c e) /\
  ~ (are_apart a b c e = true /\ have_a_common_point a b c e).
Proof.
  intros n. split.
  - destruct (zero_spec (cross (minus b a) (minus e c))) as [parallel | crossing_lines].
    + destruct (parallel_segments a b c e n parallel); [now right | now left].
    + unfold are_apart. cbn [existsb candidates]. rewrite !orb_true_iff.
      destruct (meeting_lines a b c e crossing_lines) as [common | [found | found]];
        [now right | left; now left | left; right; now left].
  - intros [found (x & on_one & on_other)]. revert on_other.
    apply (apart_have_no_common_point a b); [now apply are_apart_sound | exact on_one].
Qed.

(* Whether a chain may turn from one edge to the next. *)
Definition may_turn (u v : vector) : bool :=
  negb (zero (vx u) && zero (vy u)) && negb (zero (vx v) && zero (vy v)) &&
  (negb (zero (cross u v)) || positive (dot u v)).

Lemma may_turn_spec (u v : vector) : reflect (turns u v) (may_turn u v).
Proof.
  unfold may_turn, turns, nonzero.
  destruct (zero_spec (vx u)), (zero_spec (vy u)), (zero_spec (vx v)), (zero_spec (vy v)),
    (zero_spec (cross u v)), (positive_spec (dot u v)); constructor; tauto.
Qed.

(* Theorem. Two segments that are not points, the second of which begins where the first ends, have no other
   point in common iff one may turn from the one to the other. *)
Theorem may_turn_decides (a b c : vector) :
  nonzero (minus b a) -> nonzero (minus c b) ->
  turns (minus b a) (minus c b) <->
  (forall x, lies_on x (Segment a b) -> lies_on x (Segment b c) -> equal_vectors x b).
Proof.
  intros na nc. split.
  - intros t x (s & range_s & xs & ys) (r & range_r & xr & yr). cbn [source target] in *.
    destruct (turning_is_in_front _ _ t) as (w & f & g). unfold in_front in *.
    assert (nothing : (1 - s) * dot w (minus b a) + r * dot w (minus c b) == 0).
    { in_coordinates. by_equations. }
    assert (0 <= (1 - s) * dot w (minus b a)) by (apply Qmult_le_0_compat; lra).
    assert (0 <= r * dot w (minus c b)) by (apply Qmult_le_0_compat; lra).
    assert (none : r * dot w (minus c b) == 0) by lra.
    destruct (Qmult_integral _ _ none) as [r_is | ?]; [| lra].
    rewrite r_is in xr, yr. split; lra.
  - intros only_b. split; [exact na |]. split; [exact nc |]. intros straight.
    destruct (Qlt_le_dec 0 (dot (minus b a) (minus c b))) as [| back]; [assumption | exfalso].
    pose proof (square_positive _ na) as square. set (u := minus b a) in *.
    assert (on_c : cross u (minus c a) == 0) by (unfold u, cross, minus in *; cbn [vx vy] in *; lra).
    destruct (Qlt_le_dec (dot u (minus c a)) 0) as [beyond_a | within].
    + assert (equal_vectors a b) as [x_is y_is].
      { apply only_b; [exact (source_lies_on (Segment a b)) |].
        apply (between_on_one_line u); trivial; [unfold u, cross; ring | fold u; nra]. }
      apply na. unfold u, minus. cbn [vx vy]. lra.
    + assert (equal_vectors c b) as [x_is y_is]
        by (apply only_b; [now apply between_the_ends | exact (target_lies_on (Segment b c))]).
      apply nc. unfold minus. cbn [vx vy]. lra.
Qed.
