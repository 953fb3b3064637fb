(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Who goes straight on from a to a + u and meets some segments on the way meets one first, also where a segment is
   along the way or a is on one: where the first is met is one of four numbers for each segment. *)
From Coq Require Import QArith Lqa Qfield ZArith Lia Bool List.
From Oplus Require Import winding meeting_of_segments first_hit neighbourhoods signed_crossings.
Import ListNotations.

Open Scope Q_scope.

Section Way.
  Variables a u : vector.
  Let at_ (k : Q) : vector := moved_along a u k.

  Definition met_at (t : segment) (k : Q) : Prop := 0 <= k <= 1 /\ lies_on (at_ k) t.

  Lemma met_at_dec (t : segment) (k : Q) : {met_at t k} + {~ met_at t k}.
  Proof.
    unfold met_at. destruct (Qlt_le_dec k 0); [right; lra |]. destruct (Qlt_le_dec 1 k); [right; lra |].
    destruct (lies_on_dec (at_ k) t); [left | right]; tauto.
  Qed.

  Definition places_to_look (t : segment) : list Q :=
    [0; cross (minus (source t) a) (along t) / cross u (along t);
     dot (minus (source t) a) u / dot u u; dot (minus (target t) a) u / dot u u].

  Lemma met_no_later (t : segment) (j : Q) : met_at t j -> exists k, In k (places_to_look t) /\ met_at t k /\ k <= j.
  Proof.
    intros [range on]. destruct (met_at_dec t 0) as [start_ | no_start]; [exists 0; cbn; tauto |].
    destruct on as (h & h_range & X & Y). unfold at_, moved_along in X, Y. cbn [vx vy] in X, Y.
    destruct (Qeq_dec (cross u (along t)) 0) as [flat | turn].
    - assert (moves : ~ dot u u == 0).
      { intros none. apply no_start. split; [lra |]. exists h. split; [exact h_range |].
        assert (vx u == 0 /\ vy u == 0) as [ux uy] by (unfold dot in none; split; nra).
        unfold at_, moved_along. cbn [vx vy]. rewrite ux in X |- *. rewrite uy in Y |- *. split; lra. }
      assert (place : forall e f, (e = source t /\ f = h \/ e = target t /\ f = 1 - h) ->
        let k := dot (minus e a) u / dot u u in vx e == vx a + k * vx u /\ vy e == vy a + k * vy u).
      { intros e f which k. assert (k_is : k * dot u u == dot (minus e a) u) by (unfold k; field; exact moves).
        assert (line : cross (minus e a) u == 0).
        { destruct which as [[-> _] | [-> _]].
          - assert (sx : vx (source t) == vx a + j * vx u - h * vx (along t))
              by (unfold along, minus; cbn [vx]; rewrite X; ring).
            assert (sy : vy (source t) == vy a + j * vy u - h * vy (along t))
              by (unfold along, minus; cbn [vy]; rewrite Y; ring).
            setoid_replace (cross (minus (source t) a) u) with (h * cross u (along t))
              by (unfold cross, minus; cbn [vx vy]; rewrite sx, sy; ring). rewrite flat. ring.
          - assert (sx : vx (target t) == vx a + j * vx u + (1 - h) * vx (along t))
              by (unfold along, minus; cbn [vx]; rewrite X; ring).
            assert (sy : vy (target t) == vy a + j * vy u + (1 - h) * vy (along t))
              by (unfold along, minus; cbn [vy]; rewrite Y; ring).
            setoid_replace (cross (minus (target t) a) u) with (- (1 - h) * cross u (along t))
              by (unfold cross, minus; cbn [vx vy]; rewrite sx, sy; ring). rewrite flat. ring. }
        clearbody k. unfold cross, dot, minus in *. cbn [vx vy] in *.
        set (p := vx e - vx a) in *. set (q := vy e - vy a) in *.
        assert (px : p == k * vx u).
        { apply (Qmult_inj_r _ _ _ moves).
          setoid_replace (p * (vx u * vx u + vy u * vy u))
            with (vx u * (p * vx u + q * vy u) + vy u * (p * vy u - q * vx u)) by ring.
          rewrite line, <- k_is. ring. }
        assert (py : q == k * vy u).
        { apply (Qmult_inj_r _ _ _ moves).
          setoid_replace (q * (vx u * vx u + vy u * vy u))
            with (vy u * (p * vx u + q * vy u) - vx u * (p * vy u - q * vx u)) by ring.
          rewrite line, <- k_is. ring. }
        rewrite <- px, <- py. unfold p, q. split; ring. }
      destruct (place (source t) h) as [sx sy]; [tauto |]. destruct (place (target t) (1 - h)) as [tx ty]; [tauto |].
      clear place. set (k := dot (minus (source t) a) u / dot u u) in *.
      set (l := dot (minus (target t) a) u / dot u u) in *.
      assert (k_looked : In k (places_to_look t)) by (cbn; tauto).
      assert (l_looked : In l (places_to_look t)) by (cbn; tauto). clearbody k l.
      assert (j_is : j == (1 - h) * k + h * l).
      { rewrite sx, tx in X. rewrite sy, ty in Y.
        assert (dx : (j - ((1 - h) * k + h * l)) * vx u == 0) by lra.
        assert (dy : (j - ((1 - h) * k + h * l)) * vy u == 0) by lra.
        set (d := j - ((1 - h) * k + h * l)) in *. assert (d * dot u u == 0).
        { unfold dot. setoid_replace (d * (vx u * vx u + vy u * vy u)) with (d * vx u * vx u + d * vy u * vy u) by ring.
          rewrite dx, dy. ring. }
        assert (d == 0) by (apply (Qmult_inj_r _ _ _ moves); lra). unfold d in *. lra. }
      (* a itself is not between an end before a and the point at j *)
      assert (no_start' : forall g, 0 <= g <= 1 -> (1 - g) * k + g * l == 0 -> False).
      { intros g g_range zero_. apply no_start. split; [lra |]. exists g. split; [exact g_range |].
        unfold at_, moved_along. cbn [vx vy]. rewrite sx, sy, tx, ty. split.
        - setoid_replace ((1 - g) * (vx a + k * vx u) + g * (vx a + l * vx u)) with (vx a + ((1 - g) * k + g * l) * vx
          u)
            by ring. rewrite zero_. ring.
        - setoid_replace ((1 - g) * (vy a + k * vy u) + g * (vy a + l * vy u)) with (vy a + ((1 - g) * k + g * l) * vy
          u)
            by ring. rewrite zero_. ring. }
      destruct (Qlt_le_dec j k) as [later | earlier].
      + assert (less : l <= j)
          by (apply Qnot_lt_le; intros more; pose proof (mixed_is_more h k l j h_range later more); lra).
        destruct (Qlt_le_dec l 0) as [negative_ | positive_].
        * exfalso. assert (share : k / (k - l) * (k - l) == k) by (field; lra).
          apply (no_start' (k / (k - l))); [| set (g := k / (k - l)) in *; clearbody g; lra].
          split; [apply Qle_shift_div_l; lra | apply Qle_shift_div_r; lra].
        * exists l. split; [exact l_looked |]. split; [| exact less]. split; [lra |]. exists 1. split; [lra |].
          unfold at_, moved_along. cbn [vx vy]. rewrite tx, ty. split; ring.
      + destruct (Qlt_le_dec k 0) as [negative_ | positive_].
        * exfalso. destruct (Qlt_le_dec l 0) as [also | not_];
            [pose proof (mixed_is_less h k l 0 h_range negative_ also); lra |].
          assert (share : (- k) / (l - k) * (l - k) == - k) by (field; lra).
          apply (no_start' ((- k) / (l - k))); [| set (g := (- k) / (l - k)) in *; clearbody g; lra].
          split; [apply Qle_shift_div_l; lra | apply Qle_shift_div_r; lra].
        * exists k. split; [exact k_looked |]. split; [| exact earlier]. split; [lra |]. exists 0. split; [lra |].
          unfold at_, moved_along. cbn [vx vy]. rewrite sx, sy. split; ring.
    - set (k := cross (minus (source t) a) (along t) / cross u (along t)).
      assert (k_is : k == j).
      { apply (Qmult_inj_r _ _ _ turn). unfold k. transitivity (cross (minus (source t) a) (along t)); [field;
        exact turn |].
        assert (sx : vx (source t) == vx a + j * vx u - h * vx (along t))
          by (unfold along, minus; cbn [vx]; rewrite X; ring).
        assert (sy : vy (source t) == vy a + j * vy u - h * vy (along t))
          by (unfold along, minus; cbn [vy]; rewrite Y; ring).
        set (v := along t) in *. unfold cross, minus. cbn [vx vy]. rewrite sx, sy. ring. }
      exists k. split; [cbn; tauto |]. split; [| lra]. split; [lra |]. exists h. split; [exact h_range |].
      unfold at_, moved_along. cbn [vx vy]. rewrite k_is. now split.
  Qed.

  (* Theorem. *)
  Theorem first_on_the_way (segments : list segment) : (forall k, 0 <= k <= 1 -> off (at_ k) segments) \/
    exists k t, In t segments /\ met_at t k /\ forall j, 0 <= j -> j < k -> off (at_ j) segments.
  Proof.
    set (looked := fun t => filter (fun k => if met_at_dec t k then true else false) (places_to_look t)).
    assert (looked_is : forall t k, In k (looked t) <-> In k (places_to_look t) /\ met_at t k).
    { intros t k. unfold looked. rewrite filter_In. destruct (met_at_dec t k); intuition discriminate. }
    set (all := flat_map looked segments). destruct all as [| k0 rest] eqn:all_are.
    - left. intros k range t T on. destruct (met_no_later t k (conj range on)) as (j & J & met & _).
      assert (I : In j all) by (apply in_flat_map; exists t; split; [exact T | now apply looked_is]).
      now rewrite all_are in I.
    - right. destruct (least_of (fun k => k) all) as (k & K & least); [rewrite all_are; discriminate |].
      pose proof K as K'. apply in_flat_map in K'. destruct K' as (t & T & met). apply looked_is in met.
      exists k, t. split; [exact T |]. split; [apply met |]. intros j low less s S on.
      destruct (met_no_later s j) as (l & L & met_l & before); [split; [destruct met as [_ [? _]]; lra | exact on] |].
      assert (I : In l all) by (apply in_flat_map; exists s; split; [exact S | now apply looked_is]).
      specialize (least l I). lra.
  Qed.

  (* Until then the winding number stays. *)
  Lemma number_on_the_way (segments : list segment) (k : Q) : cycles segments -> 0 <= k ->
    (forall j, 0 <= j -> j <= k -> off (at_ j) segments) ->
    winding_number (at_ k) segments = winding_number a segments.
  Proof.
    intros closed low free. symmetry. apply (winding_number_along (Segment a (at_ k)) segments closed).
    intros w (h & range & X & Y) s S on. apply (free (h * k) ltac:(nra) ltac:(nra) s S), (lies_on_equal w); [| exact on].
    unfold at_, moved_along in *. cbn [source target vx vy] in *. split; cbn [vx vy]; [rewrite X | rewrite Y]; ring.
  Qed.
End Way.
