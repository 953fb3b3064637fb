(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* When two segments have no point in common, by signs: all vectors from the one to the other are on one side
   of a line, and one of three lines will do. Whether two consecutive edges have only their common vertex
   in common is a question of signs, too. Used for simple chains (simple_chain.v). *)
From Coq Require Import Bool List.
From Oplus Require Import numbers winding rotation secants.
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
  intros (w & ca & cb & ea & eb) (s & range_s & xs & ys) (t & range_t & xt & yt).
  cbn [source target] in *. unfold in_front in *.
  assert (nothing : (1 - s) * (1 - t) * dot w (minus c a) + s * (1 - t) * dot w (minus c b) +
                    (1 - s) * t * dot w (minus e a) + s * t * dot w (minus e b) == 0).
  { in_coordinates. by_equations. }
  assert (0 <= (1 - s) * (1 - t) /\ 0 <= s * (1 - t) /\ 0 <= (1 - s) * t /\ 0 <= s * t) as parts
    by (repeat split; apply Qmult_le_0_compat; lra).
  set (p := (1 - s) * (1 - t)) in *. set (q := s * (1 - t)) in *. set (r := (1 - s) * t) in *.
  set (o := s * t) in *.
  assert (whole : p + q + r + o == 1) by (unfold p, q, r, o; ring).
  clearbody p q r o.
  assert (none : forall part side, 0 <= part -> 0 < side -> 0 <= part * side)
    by (intros; apply Qmult_le_0_compat; lra).
  assert (no_part : forall part side, 0 < side -> part * side == 0 -> part == 0)
    by (intros part side positive product; destruct (Qmult_integral part side product); lra).
  destruct parts as (p_is & q_is & r_is & o_is).
  pose proof (none p _ p_is ca). pose proof (none q _ q_is cb).
  pose proof (none r _ r_is ea). pose proof (none o _ o_is eb).
  pose proof (no_part p _ ca). pose proof (no_part q _ cb).
  pose proof (no_part r _ ea). pose proof (no_part o _ eb). lra.
Qed.

Lemma on_segment (a b x : vector) (t : Q) :
  0 <= t <= 1 -> equal_vectors x (Vector (vx a + t * (vx b - vx a)) (vy a + t * (vy b - vy a))) ->
  lies_on x (Segment a b).
Proof. intros r [x_is y_is]. cbn [vx vy] in *. exists t. cbn [source target]. repeat split; lra. Qed.

(* On one line, the segment from c to e goes past a if c is before a and e is not. *)
Lemma one_on_the_other (u a c e : vector) :
  cross u (minus c a) == 0 -> cross u (minus e a) == 0 -> nonzero u ->
  dot u (minus c a) <= 0 -> 0 <= dot u (minus e a) -> dot u (minus c a) < dot u (minus e a) ->
  lies_on a (Segment c e).
Proof.
  intros on_c on_e nu before_a after_a apart_ends.
  pose proof (square_positive u nu) as square.
  set (p := dot u (minus c a)) in *. set (q := dot u (minus e a)) in *.
  assert (along : forall z, cross u (minus z a) == 0 ->
    dot u u * (vx z - vx a) == dot u (minus z a) * vx u /\
    dot u u * (vy z - vy a) == dot u (minus z a) * vy u)
    by (intros z on; in_coordinates; split; by_equations).
  destruct (along c on_c) as [xc yc], (along e on_e) as [xe ye]. fold p in xc, yc. fold q in xe, ye.
  assert (value : - p / (q - p) * (q - p) == - p) by (field; lra).
  assert (range : 0 <= - p / (q - p) <= 1) by (split; [apply Qle_shift_div_l | apply Qle_shift_div_r]; lra).
  set (l := - p / (q - p)) in *. clearbody l p q. apply (on_segment c e a l); [exact range |].
  assert (some : ~ dot u u * (q - p) == 0) by nra. clear - xc yc xe ye value some.
  split; cbn [vx vy]; apply (Qmult_inj_l _ _ _ some); by_equations.
Qed.

(* On the line of the segment from a to b, a point that is neither before a nor after b is on it. *)
Lemma between_the_ends (a b z : vector) :
  nonzero (minus b a) -> cross (minus b a) (minus z a) == 0 ->
  0 <= dot (minus b a) (minus z a) -> dot (minus b a) (minus z b) <= 0 -> lies_on z (Segment a b).
Proof.
  intros n on after_a before_b.
  apply (one_on_the_other (minus b a) z a b); trivial;
    unfold cross, dot, minus, nonzero in *; cbn [vx vy] in *; try nra.
  pose proof (square_positive (minus b a) n) as square. unfold dot, minus in square. cbn [vx vy] in square.
  nra.
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
  intros u v crossing_lines.
  assert (nonzero_square : 0 < cross u v * cross u v) by (destruct (Q_dec (cross u v) 0) as [[? | ?] | ?]; nra).
  set (s := cross (minus c a) v / cross u v). set (t := cross (minus c a) u / cross u v).
  assert (s_is : s * cross u v == cross (minus c a) v) by (unfold s; field; assumption).
  assert (t_is : t * cross u v == cross (minus c a) u) by (unfold t; field; assumption).
  set (x := Vector (vx a + s * vx u) (vy a + s * vy u)).
  assert (x_on_both : equal_vectors x (Vector (vx c + t * vx v) (vy c + t * vy v))).
  { unfold x. clearbody s t.
    split; cbn [vx vy]; apply (Qmult_inj_l _ _ _ crossing_lines); unfold u, v in *; in_coordinates; by_equations. }
  assert (within_or_outside : have_a_common_point a b c e \/ ~ (0 <= s <= 1) \/ ~ (0 <= t <= 1)).
  { destruct (Qlt_le_dec s 0), (Qlt_le_dec 1 s), (Qlt_le_dec t 0), (Qlt_le_dec 1 t);
      try (right; left; lra); try (right; right; lra). left. exists x. split.
    - apply (on_segment a b x s); [lra |]. split; reflexivity.
    - apply (on_segment c e x t); [lra | exact x_on_both]. }
  clearbody s t. clear x x_on_both.
  destruct within_or_outside as [common | outside]; [now left | right].
  unfold normal. destruct outside as [outside | outside]; [right | left]; apply separated_spec.
  - assert (sides : dot (Vector (- vy v) (vx v)) (minus c a) == - s * cross u v /\
                    dot (Vector (- vy v) (vx v)) (minus c b) == (1 - s) * cross u v /\
                    dot (Vector (- vy v) (vx v)) (minus e a) == - s * cross u v /\
                    dot (Vector (- vy v) (vx v)) (minus e b) == (1 - s) * cross u v).
    { unfold u, v in *. in_coordinates. repeat split; lra. }
    destruct sides as (-> & -> & -> & ->).
    destruct (Q_dec (cross u v) 0) as [[? | ?] | ?]; [| | contradiction];
      (destruct (Qlt_le_dec s 0); [| assert (1 < s) by (apply Qnot_le_lt; intro; apply outside; lra)]);
      first [left; nra | right; nra].
  - assert (sides : dot (Vector (- vy u) (vx u)) (minus c a) == - t * cross u v /\
                    dot (Vector (- vy u) (vx u)) (minus c b) == - t * cross u v /\
                    dot (Vector (- vy u) (vx u)) (minus e a) == (1 - t) * cross u v /\
                    dot (Vector (- vy u) (vx u)) (minus e b) == (1 - t) * cross u v).
    { unfold u, v in *. in_coordinates. repeat split; lra. }
    destruct sides as (-> & -> & -> & ->).
    destruct (Q_dec (cross u v) 0) as [[? | ?] | ?]; [| | contradiction];
      (destruct (Qlt_le_dec t 0); [| assert (1 < t) by (apply Qnot_le_lt; intro; apply outside; lra)]);
      first [left; nra | right; nra].
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
  unfold are_apart. rewrite existsb_exists.
  destruct (zero_spec (cross u (minus c a))) as [on_c | beside].
  2: { right. exists (normal u). split; [left; reflexivity | now apply parallel_lines]. }
  assert (on_e : cross u (minus e a) == 0)
    by (unfold cross, u, v, minus in *; cbn [vx vy] in *; lra).
  assert (whole : forall z, dot u (minus z b) == dot u (minus z a) - dot u u)
    by (intros z; unfold dot, u, minus; cbn [vx vy]; ring).
  pose proof (whole c) as at_c. pose proof (whole e) as at_e. fold u in nu.
  assert (by_u : is_separated_by u a b c e = true ->
    have_a_common_point a b c e \/
    exists w, In w (candidates a b c e) /\ is_separated_by w a b c e = true).
  { intros separated. right. exists u. split; [right; right; left; reflexivity | exact separated]. }
  rewrite separated_spec in by_u.
  destruct (Qlt_le_dec (dot u (minus c a)) 0) as [c_before | c_after].
  - destruct (Qlt_le_dec (dot u (minus e a)) 0) as [e_before | e_after]; [apply by_u; right; lra |].
    left. exists a. split.
    + apply (on_segment a b a 0); [lra | split; cbn [vx vy]; ring].
    + apply (one_on_the_other u a c e); trivial; lra.
  - destruct (Qlt_le_dec 0 (dot u (minus c b))) as [c_beyond | c_within].
    + destruct (Qlt_le_dec 0 (dot u (minus e b))) as [e_beyond | e_within]; [apply by_u; left; lra |].
      left. exists b. split.
      { apply (on_segment a b b 1); [lra | split; cbn [vx vy]; ring]. }
      destruct (one_on_the_other u b e c) as (t & range & x_is & y_is); trivial; try lra;
        try (unfold cross, u, minus in *; cbn [vx vy] in *; lra).
      exists (1 - t). cbn [source target] in *. repeat split; lra.
    + left. exists c. split; [now apply between_the_ends |].
      apply (on_segment c e c 0); [lra | split; cbn [vx vy]; ring].
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
    set (u := minus b a) in *.
    destruct (Qlt_le_dec (dot u (minus c a)) 0) as [beyond_a | within].
    + assert (equal_vectors a b) as [x_is y_is].
      { apply only_b; [apply (on_segment a b a 0); [lra | split; cbn [vx vy]; ring] |].
        pose proof (square_positive u na). fold u in straight.
        destruct (one_on_the_other u a c b) as (t & range & x_is & y_is); trivial; fold u; try lra;
          try (unfold u, cross, minus in *; cbn [vx vy] in *; lra).
        exists (1 - t). cbn [source target] in *. repeat split; lra. }
      apply na. unfold u, minus. cbn [vx vy]. lra.
    + assert (equal_vectors c b) as [x_is y_is].
      { apply only_b; [| apply (on_segment b c c 1); [lra | split; cbn [vx vy]; ring]].
        apply between_the_ends; trivial. unfold u, cross, minus in *; cbn [vx vy] in *; lra. }
      apply nc. unfold minus. cbn [vx vy]. lra.
Qed.
