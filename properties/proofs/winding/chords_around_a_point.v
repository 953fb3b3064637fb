(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Two passes through a point, each along two rays, that do not cross: both rays of the one are inside the angle of the
   other, or both are not. Where each is cut short near the point, along a chord of a small strictly convex curve
   (strictly_convex_curve.v), they do not meet any more. *)
From Coq Require Import Bool List.
From Oplus Require Import numbers winding meeting_of_segments strictly_convex_curve.
Import ListNotations.

Open Scope Q_scope.

(* The rays a and b of one pass, c and e of the other. If a and b are opposite, both others are on one side of them. *)
Definition passes_do_not_cross (a b c e : vector) : Prop :=
  (~ cross a b == 0 -> (inside_angle a b c <-> inside_angle a b e)) /\
  (cross a b == 0 -> 0 < cross a c * cross a e).

Definition chord (v a b : vector) (e : Q) : segment := Segment (moved_along v a e) (moved_along v b e).

Section Chords.
  Variables v a b : vector.
  Variable e : Q.
  Hypothesis small : 0 < e.
  Hypothesis on_a : is_on_curve a.
  Hypothesis on_b : is_on_curve b.
  Hypothesis differ : ~ same_ray a b.

  Lemma opposite_rays : cross a b == 0 -> exists k, 0 < k /\ equal_vectors b (stretched (- k) a).
  Proof.
    intros line. destruct on_a as [some_a _], on_b as [some_b _].
    assert (turned : cross b a == 0) by (unfold cross in *; lra).
    destruct (multiple_of b a some_a turned) as (k & X & Y). exists (- k). unfold equal_vectors, stretched. cbn [vx vy].
    pose proof (square_positive a some_a) as square. split; [| rewrite X, Y; split; ring].
    destruct (Q_dec k 0) as [[less | more] | zero_]; [lra | exfalso | exfalso].
    - apply differ. split; [exact line |]. unfold dot in *. rewrite X, Y. nra.
    - apply some_b. rewrite X, Y, zero_. split; ring.
  Qed.

  (* Both ends of the other chord are on one side of this one. *)
  Lemma chords_do_not_meet (c f x : vector) : is_on_curve c -> is_on_curve f ->
    ~ same_ray c a -> ~ same_ray c b -> ~ same_ray f a -> ~ same_ray f b -> passes_do_not_cross a b c f ->
    lies_on x (chord v a b e) -> ~ lies_on x (chord v c f e).
  Proof.
    intros on_c on_f c_a c_b f_a f_b [inside_ opposite_] on (t & range & X & Y).
    pose proof (on_the_line x _ on) as line.
    set (at_c := cross (minus b a) (minus c a)). set (at_f := cross (minus b a) (minus f a)).
    assert (mixed_ : area (chord v a b e) x == e * e * ((1 - t) * at_c + t * at_f)).
    { unfold at_c, at_f, chord, area, cross, minus, moved_along in *. cbn [source target vx vy] in *. rewrite X, Y.
      ring. }
    assert (one_side : 0 < at_c * at_f).
    { destruct (Qeq_dec (cross a b) 0) as [flat | turn].
      - destruct (opposite_rays flat) as (k & some_k & BX & BY). unfold stretched in BX, BY. cbn [vx vy] in BX, BY.
        specialize (opposite_ flat).
        assert (c_is : at_c == - (1 + k) * cross a c) by (unfold at_c, cross, minus; cbn [vx vy]; rewrite BX, BY; ring).
        assert (f_is : at_f == - (1 + k) * cross a f) by (unfold at_f, cross, minus; cbn [vx vy]; rewrite BX, BY; ring).
        rewrite c_is, f_is. setoid_replace (- (1 + k) * cross a c * (- (1 + k) * cross a f))
          with ((1 + k) * (1 + k) * (cross a c * cross a f)) by ring.
        apply products; [nra | exact opposite_].
      - specialize (inside_ turn). destruct (side_of_a_chord a b c on_a on_b on_c turn c_a c_b) as [in_c out_c].
        destruct (side_of_a_chord a b f on_a on_b on_f turn f_a f_b) as [in_f out_f]. fold at_c in in_c, out_c.
        fold at_f in in_f, out_f. set (k := cross a b) in *. clearbody k at_c at_f.
        assert (both : 0 < (k * at_c) * (k * at_f)).
        { destruct (inside_angle_dec a b c) as [i | o].
          - specialize (in_c i). specialize (in_f (proj1 inside_ i)).
            setoid_replace ((k * at_c) * (k * at_f)) with ((- (k * at_c)) * (- (k * at_f))) by ring.
            apply products; lra.
          - specialize (out_c o). specialize (out_f (fun i => o (proj2 inside_ i))). now apply products. }
        destruct (squares k) as [square _]. destruct (Qlt_le_dec 0 (at_c * at_f)); [assumption | nra]. }
    rewrite line in mixed_. assert (zero_ : (1 - t) * at_c + t * at_f == 0).
    { apply (Qmult_inj_l _ _ (e * e)); [nra |]. rewrite <- mixed_. ring. }
    destruct (Qlt_le_dec 0 at_c) as [c_side | c_side].
    - assert (0 < at_f) by nra. pose proof (mixed_is_more t at_c at_f 0 range c_side H). lra.
    - assert (at_c < 0) by (destruct (Q_dec at_c 0) as [[less | more] | none]; [exact less | lra |
        rewrite none in one_side; lra]).
      assert (at_f < 0) by nra. pose proof (mixed_is_less t at_c at_f 0 range H H0). lra.
  Qed.

  (* What is on another ray, not nearer than the curve, is not on the chord. *)
  Lemma rays_do_not_meet_chords (r x : vector) (s : Q) : is_on_curve r -> ~ same_ray r a -> ~ same_ray r b ->
    e <= s -> equal_vectors x (moved_along v r s) -> ~ lies_on x (chord v a b e).
  Proof.
    intros [some_r one_r] not_a not_b far [X Y] (t & range & X' & Y'). unfold chord, moved_along in *.
    cbn [source target vx vy] in *.
    assert (r_x : s * vx r == e * ((1 - t) * vx a + t * vx b)) by lra.
    assert (r_y : s * vy r == e * ((1 - t) * vy a + t * vy b)) by lra. clear X Y X' Y'.
    assert (ray : forall c l, nonzero c -> s * vx r == l * vx c -> s * vy r == l * vy c -> 0 < l -> same_ray r c).
    { intros c l some_c CX CY L. pose proof (square_positive c some_c) as square. unfold same_ray. split.
      - apply (Qmult_inj_l _ _ s); [lra |]. unfold cross.
        setoid_replace (s * (vx r * vy c - vy r * vx c)) with ((s * vx r) * vy c - (s * vy r) * vx c) by ring.
        rewrite CX, CY. ring.
      - assert (s * dot r c == l * dot c c); [| destruct (Qlt_le_dec 0 (dot r c)); [assumption | nra]].
        unfold dot. setoid_replace (s * (vx r * vx c + vy r * vy c)) with ((s * vx r) * vx c + (s * vy r) * vy c) by
          ring.
        rewrite CX, CY. ring. }
    destruct (Qeq_dec (cross a b) 0) as [flat | turn].
    - destruct (opposite_rays flat) as (k & some_k & BX & BY). unfold stretched in BX, BY. cbn [vx vy] in BX, BY.
      set (l := e * ((1 - t) - t * k)).
      assert (l_x : s * vx r == l * vx a) by (rewrite r_x, BX; unfold l; ring).
      assert (l_y : s * vy r == l * vy a) by (rewrite r_y, BY; unfold l; ring). clearbody l.
      destruct (Q_dec l 0) as [[less | more] | none].
      + apply not_b, (ray b (- l * (1 / k)) (proj1 on_b)); [rewrite l_x, BX; field; lra | rewrite l_y, BY; field;
          lra |].
        apply products; [lra |]. apply Qlt_shift_div_l; lra.
      + exact (not_a (ray a l (proj1 on_a) l_x l_y more)).
      + apply some_r. rewrite none in l_x, l_y. split; apply (Qmult_inj_l _ _ s); lra.
    - destruct (Qlt_le_dec 0 t) as [t_some | t_none]; [destruct (Qlt_le_dec t 1) as [t_less | t_all] |].
      + assert (less : gauge (stretched s r) < e * (1 - t) + e * t).
        { apply (gauge_of_mixed a b); trivial; [nra | nra |]. unfold equal_vectors, vector_sum, stretched. cbn [vx vy].
          rewrite r_x, r_y. split; ring. }
        rewrite (gauge_of_stretched s r ltac:(lra) some_r), one_r in less. lra.
      + apply not_b, (ray b e (proj1 on_b)); [rewrite r_x | rewrite r_y | exact small];
          setoid_replace t with 1 by lra; ring.
      + apply not_a, (ray a e (proj1 on_a)); [rewrite r_x | rewrite r_y | exact small];
          setoid_replace t with 0 by lra; ring.
  Qed.

  (* Nor is a line that the chord's rays are both on one side of. *)
  Lemma chords_beside_a_line (s : segment) (x : vector) : area s v == 0 ->
    0 < cross (along s) a * cross (along s) b -> lies_on x (chord v a b e) -> ~ area s x == 0.
  Proof.
    intros line one_side (t & range & X & Y) zero_. unfold chord, moved_along in X, Y.
    cbn [source target vx vy] in X, Y.
    set (at_a := cross (along s) a) in *. set (at_b := cross (along s) b) in *.
    assert (x_is : area s x == area s v + e * ((1 - t) * at_a + t * at_b)).
    { unfold at_a, at_b, area, cross, along, minus. cbn [vx vy]. rewrite X, Y. ring. }
    assert (mixed_ : (1 - t) * at_a + t * at_b == 0).
    { apply (Qmult_inj_l _ _ e); [lra |]. lra. }
    clearbody at_a at_b. destruct (Qlt_le_dec 0 at_a) as [a_side | a_side].
    - assert (0 < at_b) by nra. pose proof (mixed_is_more t at_a at_b 0 range a_side H). lra.
    - assert (at_a < 0) by (destruct (Q_dec at_a 0) as [[less | more] | none]; [exact less | lra |
        rewrite none in one_side; lra]).
      assert (at_b < 0) by nra. pose proof (mixed_is_less t at_a at_b 0 range H H0). lra.
  Qed.
End Chords.
