(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* A naive collision test that decides whether the interiors of two valid regions have a point in common, in every
   position, as reference/definitions/collision.cpp does: it looks at each edge where it is cut by lines of other edges
   and midway between two cuts. That it need not look elsewhere follows from common_interior.v. *)
From Coq Require Import QArith Lqa Qfield ZArith Lia Bool List.
From Oplus Require Import direction angle sweep winding_number in_out_degree weight regions meeting_of_segments first_hit
  interiors_meet neighbourhoods left_of_an_edge theorem_4_2_1 winding_number_of_the_sum common_interior.
Import ListNotations.

Open Scope Q_scope.

(* The point of a segment's line at a parameter: 0 at its source, 1 at its target. *)
Definition point_on (s : segment) (k : Q) : vector :=
  Vector (vx (source s) + k * vx (along s)) (vy (source s) + k * vy (along s)).

Definition parameter (s : segment) (p : vector) : Q := dot (minus p (source s)) (along s) / dot (along s) (along s).

(* Where s is cut by the line of t, or, if they are parallel, beside the ends of t. *)
Definition cuts_by (s t : segment) : list Q :=
  let d := cross (along s) (along t) in
  if zero d then [parameter s (source t); parameter s (target t)]
  else [cross (minus (source t) (source s)) (along t) / d].

Definition cuts (s : segment) (others : list segment) : list Q := 0 :: 1 :: flat_map (cuts_by s) others.

Definition candidates (s : segment) (others : list segment) : list Q :=
  cuts s others ++ map (fun pair => (1 # 2) * (fst pair + snd pair)) (list_prod (cuts s others) (cuts s others)).

Definition lies_on_test (p : vector) (s : segment) : bool :=
  zero (cross (minus (source s) p) (minus (target s) p)) &&
  at_most (dot (minus (source s) p) (minus (target s) p)) 0.

Definition inside_test (p : vector) (r : region) : bool :=
  forallb (fun s => negb (lies_on_test p s)) (region_edges r) && (0 <? winding_number p (region_edges r))%Z.

Definition is_vertex_test (p : vector) (r : region) : bool :=
  existsb (fun s => Qeq_bool (vx p) (vx (source s)) && Qeq_bool (vy p) (vy (source s))) (region_edges r).

Definition not_opposite (u v : vector) : bool := negb (zero (cross u v)) || negb (at_most (dot u v) 0).

(* Whether a point of an edge s of a shows that a and b have a common interior. *)
Definition shows (a b : region) (s : segment) (p : vector) : bool :=
  inside_test p b ||
  existsb (fun t => lies_on_test p t && negb (is_vertex_test p a) && negb (is_vertex_test p b) &&
                    not_opposite (along s) (along t)) (region_edges b).

Definition boundary_shows (a b : region) : bool :=
  existsb (fun s => existsb (fun k => at_most 0 k && at_most k 1 && shows a b s (point_on s k))
                      (candidates s (region_edges a ++ region_edges b))) (region_edges a).

Definition collide (a b : region) : bool := boundary_shows a b || boundary_shows b a.

Lemma lies_on_spec (p : vector) (s : segment) : reflect (lies_on p s) (lies_on_test p s).
Proof.
  apply iff_reflect. rewrite lies_on_by_signs. unfold lies_on_test.
  destruct (zero_spec (cross (minus (source s) p) (minus (target s) p))),
    (at_most_spec (dot (minus (source s) p) (minus (target s) p)) 0); cbn [andb]; intuition discriminate.
Qed.

Lemma inside_spec (p : vector) (r : region) : inside_test p r = true <-> inside p r.
Proof.
  unfold inside_test, inside. rewrite andb_true_iff, forallb_forall, Z.ltb_lt. split.
  - intros [free positive_]. split; [| exact positive_]. intros s I on. specialize (free s I).
    destruct (lies_on_spec p s); [discriminate | contradiction].
  - intros [free positive_]. split; [| exact positive_]. intros s I. specialize (free s I).
    destruct (lies_on_spec p s); [contradiction | reflexivity].
Qed.

Lemma is_vertex_spec (p : vector) (r : region) : reflect (is_vertex p r) (is_vertex_test p r).
Proof.
  apply iff_reflect. unfold is_vertex, is_vertex_test, equal_vectors. rewrite existsb_exists.
  split; intros (s & I & equal); exists s; (split; [exact I |]).
  - destruct equal as [X Y]. apply Qeq_bool_iff in X. apply Qeq_bool_iff in Y. now rewrite X, Y.
  - apply andb_true_iff in equal. destruct equal as [X Y]. split; now apply Qeq_bool_iff.
Qed.

Lemma not_opposite_spec (u v : vector) : nonzero u -> nonzero v -> not_opposite u v = true <-> turns u v.
Proof.
  intros proper_u proper_v. unfold not_opposite, turns.
  destruct (zero_spec (cross u v)) as [parallel | turn], (at_most_spec (dot u v) 0) as [back | ahead]; cbn [negb orb];
    split; trivial; try discriminate.
  - intros (_ & _ & forward). specialize (forward parallel). exfalso. lra.
  - intros _. split; [exact proper_u |]. split; [exact proper_v |]. intros _. lra.
  - intros _. split; [exact proper_u |]. split; [exact proper_v |]. intros parallel. contradiction.
  - intros _. split; [exact proper_u |]. split; [exact proper_v |]. intros parallel. contradiction.
Qed.

Lemma on_segment (s : segment) (k : Q) : 0 <= k <= 1 -> lies_on (point_on s k) s.
Proof.
  intros range. exists k. unfold point_on, along, minus. cbn [vx vy]. split; [exact range |]. split; ring.
Qed.

Lemma point_of_segment (s : segment) (w : vector) : lies_on w s ->
  exists k, 0 <= k <= 1 /\ equal_vectors (point_on s k) w.
Proof.
  intros (k & range & X & Y). exists k. split; [exact range |]. unfold point_on, along, minus.
  split; cbn [vx vy]; [rewrite X | rewrite Y]; ring.
Qed.

Lemma lies_on_equal (v w : vector) (s : segment) : equal_vectors v w -> lies_on v s -> lies_on w s.
Proof. intros [X Y] (k & range & vx_is & vy_is). exists k. rewrite <- X, <- Y. now repeat split. Qed.

Lemma is_vertex_equal (v w : vector) (r : region) : equal_vectors v w -> is_vertex v r -> is_vertex w r.
Proof. intros [X Y] (s & I & sx & sy). exists s. split; [exact I |]. split; lra. Qed.

(* The parameter of a point of s's line. *)
Lemma parameter_is (s : segment) (k : Q) (p : vector) :
  nonzero (along s) -> equal_vectors (point_on s k) p -> parameter s p == k.
Proof.
  intros proper_s [X Y]. unfold point_on in X, Y. cbn [vx vy] in X, Y.
  pose proof (rotation.square_positive (along s) proper_s) as length_. unfold parameter.
  assert (top : dot (minus p (source s)) (along s) == k * dot (along s) (along s)).
  { unfold dot, minus. cbn [vx vy]. rewrite <- X, <- Y. ring. }
  rewrite top. field. lra.
Qed.

Section Cuts.
  Variable s : segment.
  Variable others : list segment.
  Hypothesis proper_s : nonzero (along s).

  Definition no_cut_between (lo hi : Q) : Prop :=
    lo < hi /\ forall c, In c (cuts s others) -> c <= lo \/ hi <= c.

  (* A segment that s meets strictly between two cuts runs along it there. *)
  Lemma runs_along (t : segment) (lo hi k : Q) :
    In t others -> nonzero (along t) -> no_cut_between lo hi -> lo < k < hi -> lies_on (point_on s k) t ->
    cross (along s) (along t) == 0 /\ forall l, lo < l < hi -> lies_on (point_on s l) t.
  Proof.
    intros I proper_t [_ none] range (j & [j0 j1] & X & Y).
    assert (is_cut : forall c, In c (cuts_by s t) -> c <= lo \/ hi <= c).
    { intros c J. apply none. right. right. apply in_flat_map. now exists t. }
    unfold cuts_by in is_cut. destruct (zero_spec (cross (along s) (along t))) as [parallel | turn].
    - split; [exact parallel |]. intros l l_range.
      pose proof (rotation.square_positive (along s) proper_s) as length_.
      (* the ends of t, seen from s *)
      set (r := dot (along t) (along s) / dot (along s) (along s)).
      assert (tx : vx (along t) == r * vx (along s) /\ vy (along t) == r * vy (along s)).
      { unfold r. unfold cross, dot in *. split.
        - apply (Qmult_inj_r _ _ (vx (along s) * vx (along s) + vy (along s) * vy (along s))); [lra |].
          transitivity ((vx (along t) * vx (along s) + vy (along t) * vy (along s)) * vx (along s)).
          + transitivity ((vx (along t) * vx (along s) + vy (along t) * vy (along s)) * vx (along s) -
              vy (along s) * (vx (along s) * vy (along t) - vy (along s) * vx (along t))); [ring |].
            rewrite parallel. ring.
          + field. lra.
        - apply (Qmult_inj_r _ _ (vx (along s) * vx (along s) + vy (along s) * vy (along s))); [lra |].
          transitivity ((vx (along t) * vx (along s) + vy (along t) * vy (along s)) * vy (along s)).
          + transitivity ((vx (along t) * vx (along s) + vy (along t) * vy (along s)) * vy (along s) +
              vx (along s) * (vx (along s) * vy (along t) - vy (along s) * vx (along t))); [ring |].
            rewrite parallel. ring.
          + field. lra. }
      clearbody r. destruct tx as [tx ty]. change (vx (target t) - vx (source t) == r * vx (along s)) in tx.
      change (vy (target t) - vy (source t) == r * vy (along s)) in ty.
      assert (r_some : ~ r == 0).
      { intros zero_. apply proper_t. unfold along, minus. cbn [vx vy]. rewrite zero_ in tx, ty. split; lra. }
      unfold point_on in X, Y. cbn [vx vy] in X, Y.
      assert (source_at : parameter s (source t) == k - j * r).
      { apply parameter_is; [exact proper_s |]. unfold point_on. split; cbn [vx vy].
        - assert (j * (vx (target t) - vx (source t)) == j * r * vx (along s)) by (rewrite tx; ring). lra.
        - assert (j * (vy (target t) - vy (source t)) == j * r * vy (along s)) by (rewrite ty; ring). lra. }
      assert (target_at : parameter s (target t) == k + (1 - j) * r).
      { apply parameter_is; [exact proper_s |]. unfold point_on. split; cbn [vx vy].
        - assert ((1 - j) * (vx (target t) - vx (source t)) == (1 - j) * r * vx (along s)) by (rewrite tx; ring). lra.
        - assert ((1 - j) * (vy (target t) - vy (source t)) == (1 - j) * r * vy (along s)) by (rewrite ty; ring). lra. }
      pose proof (is_cut _ (or_introl eq_refl)) as cut_source.
      pose proof (is_cut _ (or_intror (or_introl eq_refl))) as cut_target.
      rewrite source_at in cut_source. rewrite target_at in cut_target.
      set (h := (l - k) / r). assert (h_is : h * r == l - k) by (unfold h; field; exact r_some). clearbody h.
      exists (j + h). split.
      + destruct (Q_dec r 0) as [[back | ahead] | equal]; [| | contradiction].
        * assert (0 <= j * - r) by (apply Qmult_le_0_compat; lra).
          assert (0 <= (1 - j) * - r) by (apply Qmult_le_0_compat; lra). split; nra.
        * assert (0 <= j * r) by (apply Qmult_le_0_compat; lra).
          assert (0 <= (1 - j) * r) by (apply Qmult_le_0_compat; lra). split; nra.
      + unfold point_on. cbn [vx vy]. split.
        * assert (h * (vx (target t) - vx (source t)) == (l - k) * vx (along s)) by (rewrite tx, <- h_is; ring). lra.
        * assert (h * (vy (target t) - vy (source t)) == (l - k) * vy (along s)) by (rewrite ty, <- h_is; ring). lra.
    - exfalso. specialize (is_cut _ (or_introl eq_refl)).
      assert (cut_is : cross (minus (source t) (source s)) (along t) / cross (along s) (along t) == k).
      { assert (top : cross (minus (source t) (source s)) (along t) == k * cross (along s) (along t)).
        { unfold point_on in X, Y. cbn [vx vy] in X, Y. unfold cross, minus. cbn [vx vy].
          assert (dx : vx (source t) - vx (source s) == k * vx (along s) - j * vx (along t))
            by (change (vx (along t)) with (vx (target t) - vx (source t)); lra).
          assert (dy : vy (source t) - vy (source s) == k * vy (along s) - j * vy (along t))
            by (change (vy (along t)) with (vy (target t) - vy (source t)); lra).
          rewrite dx, dy. ring. }
        rewrite top. field. exact turn. }
      rewrite cut_is in is_cut. lra.
  Qed.

  (* No vertex of another segment is strictly between. *)
  Lemma no_source_between (t : segment) (lo hi k : Q) :
    In t others -> nonzero (along t) -> no_cut_between lo hi -> lo < k < hi -> ~ equal_vectors (point_on s k) (source t).
  Proof.
    intros I proper_t gap range equal.
    assert (on : lies_on (point_on s k) t).
    { destruct equal as [X Y]. exists 0. split; [lra |]. split; lra. }
    destruct (runs_along t lo hi k I proper_t gap range on) as [parallel _].
    assert (is_cut : In (parameter s (source t)) (cuts s others)).
    { right. right. apply in_flat_map. exists t. split; [exact I |]. unfold cuts_by.
      destruct (zero_spec (cross (along s) (along t))); [now left | contradiction]. }
    destruct gap as [_ none]. specialize (none _ is_cut). rewrite (parameter_is s k (source t) proper_s equal) in none. lra.
  Qed.

  (* A point of s is at a cut or strictly between two. *)
  Lemma cut_or_between (k : Q) : 0 <= k <= 1 ->
    (exists c, In c (cuts s others) /\ c == k) \/
    exists lo hi, In lo (cuts s others) /\ In hi (cuts s others) /\ lo < k < hi /\ 0 <= lo /\ hi <= 1 /\
      no_cut_between lo hi.
  Proof.
    intros range. destruct (existsb (fun c => Qeq_bool c k) (cuts s others)) eqn:at_cut.
    - left. apply existsb_exists in at_cut. destruct at_cut as (c & I & equal). exists c. split; [exact I |].
      now apply Qeq_bool_iff.
    - right. assert (not_cut : forall c, In c (cuts s others) -> ~ c == k).
      { intros c I equal. assert (existsb (fun d => Qeq_bool d k) (cuts s others) = true); [| congruence].
        apply existsb_exists. exists c. split; [exact I | now apply Qeq_bool_iff]. }
      assert (zero_in : In 0 (cuts s others)) by now left. assert (one_in : In 1 (cuts s others)) by (right; now left).
      pose proof (not_cut 0 zero_in) as not_0. pose proof (not_cut 1 one_in) as not_1.
      destruct (first_of Q (fun c => - c) (filter (fun c => at_most c k) (cuts s others))) as (lo & I & lo_last).
      { intros none. assert (J : In 0 []); [| destruct J]. rewrite <- none. apply filter_In. split; [exact zero_in |].
        destruct (at_most_spec 0 k); [reflexivity | exfalso; lra]. }
      destruct (first_of Q (fun c => c) (filter (fun c => at_most k c) (cuts s others))) as (hi & J & hi_first).
      { intros none. assert (K : In 1 []); [| destruct K]. rewrite <- none. apply filter_In. split; [exact one_in |].
        destruct (at_most_spec k 1); [reflexivity | exfalso; lra]. }
      apply filter_In in I. destruct I as [I lo_below]. apply filter_In in J. destruct J as [J hi_above].
      destruct (at_most_spec lo k) as [lo_k |]; [clear lo_below | discriminate].
      destruct (at_most_spec k hi) as [k_hi |]; [clear hi_above | discriminate].
      pose proof (not_cut lo I) as not_lo. pose proof (not_cut hi J) as not_hi.
      assert (below : forall c, In c (cuts s others) -> c <= k -> c <= lo).
      { intros c K le. assert (- lo <= - c); [| lra]. apply lo_last, filter_In. split; [exact K |].
        destruct (at_most_spec c k); [reflexivity | contradiction]. }
      assert (above : forall c, In c (cuts s others) -> k <= c -> hi <= c).
      { intros c K le. apply hi_first, filter_In. split; [exact K |].
        destruct (at_most_spec k c); [reflexivity | contradiction]. }
      exists lo, hi. split; [exact I |]. split; [exact J |]. split; [split; lra |].
      split; [apply below; [exact zero_in | lra] |]. split; [apply above; [exact one_in | lra] |].
      split; [lra |]. intros c K. destruct (Qlt_le_dec k c) as [after | before].
      + right. apply above; [exact K | lra].
      + left. now apply below.
  Qed.
End Cuts.

Lemma midway_is_candidate (s : segment) (others : list segment) (lo hi : Q) :
  In lo (cuts s others) -> In hi (cuts s others) -> In ((1 # 2) * (lo + hi)) (candidates s others).
Proof.
  intros I J. apply in_app_iff. right. apply in_map_iff. exists (lo, hi). split; [reflexivity | now apply in_prod].
Qed.

Lemma between_both (lo hi k m j : Q) :
  0 <= j -> j <= 1 -> lo < k < hi -> lo < m < hi -> lo < (1 - j) * k + j * m < hi.
Proof.
  intros j0 j1 k_between m_between. destruct (Qlt_le_dec 0 j) as [some | none].
  - assert (0 < j * (m - lo)) by (apply Qmult_lt_0_compat; lra).
    assert (0 < j * (hi - m)) by (apply Qmult_lt_0_compat; lra).
    assert (0 <= (1 - j) * (k - lo)) by (apply Qmult_le_0_compat; lra).
    assert (0 <= (1 - j) * (hi - k)) by (apply Qmult_le_0_compat; lra). split; lra.
  - assert (j == 0) as j_is by lra. rewrite j_is. split; lra.
Qed.

Section TwoRegions.
  Variables a b : region.
  Hypothesis a_valid : valid_region a.
  Hypothesis b_valid : valid_region b.

  Let all := region_edges a ++ region_edges b.

  Lemma proper_edge (s : segment) : In s all -> nonzero (along s).
  Proof.
    intros I. apply in_app_iff in I. destruct I as [I | I].
    - now apply (region_edges_are_directions a (proj1 a_valid)).
    - now apply (region_edges_are_directions b (proj1 b_valid)).
  Qed.

  Lemma shown (s : segment) (k : Q) :
    In s (region_edges a) -> In k (candidates s all) -> 0 <= k <= 1 -> shows a b s (point_on s k) = true ->
    boundary_shows a b = true.
  Proof.
    intros I J [k0 k1] here. apply existsb_exists. exists s. split; [exact I |]. apply existsb_exists. exists k.
    split; [exact J |]. rewrite here. destruct (at_most_spec 0 k), (at_most_spec k 1); trivial; contradiction.
  Qed.

  Lemma entering_is_found : boundary_enters a b -> boundary_shows a b = true.
  Proof.
    intros (s & w & I & on & in_b). destruct (point_of_segment s w on) as (k & range & at_w).
    assert (J : In s all) by (apply in_app_iff; now left). pose proof (proper_edge s J) as proper_s.
    assert (in_b' : inside (point_on s k) b) by (apply (inside_equal w); [now symmetry | exact in_b]).
    destruct (cut_or_between s all k range) as [(c & K & c_is) | (lo & hi & lo_in & hi_in & k_between & lo0 & hi1 & gap)].
    - apply (shown s c I); [apply in_app_iff; now left | lra |]. unfold shows.
      assert (here : inside_test (point_on s c) b = true); [| now rewrite here].
      apply inside_spec. apply (inside_equal (point_on s k)); [| exact in_b'].
      unfold point_on. split; cbn [vx vy]; now rewrite c_is.
    - set (m := (1 # 2) * (lo + hi)). assert (m_between : lo < m < hi) by (unfold m; lra).
      apply (shown s m I); [now apply midway_is_candidate | lra |]. unfold shows.
      assert (here : inside_test (point_on s m) b = true); [| now rewrite here]. apply inside_spec.
      destruct in_b' as [free positive_].
      assert (way : forall v, lies_on v (Segment (point_on s k) (point_on s m)) -> off v (region_edges b)).
      { intros v (j & [j0 j1] & X & Y) t T on_t. cbn [source target] in X, Y.
        set (l := (1 - j) * k + j * m).
        assert (l_between : lo < l < hi) by now apply between_both.
        assert (at_l : equal_vectors v (point_on s l)).
        { unfold point_on in *. cbn [vx vy] in *. unfold l. split; cbn [vx vy]; [rewrite X | rewrite Y]; ring. }
        assert (T' : In t all) by (apply in_app_iff; now right).
        destruct (runs_along s all proper_s t lo hi l T' (proper_edge t T') gap l_between
          (lies_on_equal _ _ t at_l on_t)) as [_ everywhere].
        exact (free t T (everywhere k k_between)). }
      pose proof (winding_number_along _ _ (region_cycles b) way) as same_number. cbn [source target] in same_number.
      split; [apply way; exists 1; cbn [source target]; split; [lra |]; split; ring |]. now rewrite <- same_number.
  Qed.

  Lemma passing_shows (s t : segment) (w : vector) :
    In s (region_edges a) -> In t (region_edges b) -> lies_on w t -> ~ is_vertex w a -> ~ is_vertex w b ->
    turns (along s) (along t) -> shows a b s w = true.
  Proof.
    intros I J on_t no_a no_b turn. unfold shows. apply orb_true_iff. right. apply existsb_exists. exists t.
    split; [exact J |]. destruct (lies_on_spec w t); [| contradiction].
    destruct (is_vertex_spec w a); [contradiction |]. destruct (is_vertex_spec w b); [contradiction |].
    cbn [andb negb]. apply not_opposite_spec; trivial; apply proper_edge, in_app_iff; tauto.
  Qed.

  Lemma passing_is_found : edges_pass a b -> boundary_shows a b = true.
  Proof.
    intros (s & t & w & I & T & on_s & on_t & no_a & no_b & turn).
    destruct (point_of_segment s w on_s) as (k & range & at_w).
    assert (J : In s all) by (apply in_app_iff; now left). pose proof (proper_edge s J) as proper_s.
    destruct (cut_or_between s all k range) as [(c & K & c_is) | (lo & hi & lo_in & hi_in & k_between & lo0 & hi1 & gap)].
    - apply (shown s c I); [apply in_app_iff; now left | lra |].
      assert (at_c : equal_vectors (point_on s c) w).
      { destruct at_w as [X Y]. unfold point_on in *. cbn [vx vy] in *. split; cbn [vx vy]; rewrite c_is; assumption. }
      apply (passing_shows s t); trivial.
      + apply (lies_on_equal w); [now symmetry | exact on_t].
      + intros vertex. apply no_a. now apply (is_vertex_equal (point_on s c)).
      + intros vertex. apply no_b. now apply (is_vertex_equal (point_on s c)).
    - set (m := (1 # 2) * (lo + hi)). assert (m_between : lo < m < hi) by (unfold m; lra).
      assert (T' : In t all) by (apply in_app_iff; now right).
      destruct (runs_along s all proper_s t lo hi k T' (proper_edge t T') gap k_between) as [_ everywhere].
      { apply (lies_on_equal w); [now symmetry | exact on_t]. }
      assert (no_vertex : forall u, In u all -> ~ equal_vectors (point_on s m) (source u)).
      { intros u U. now apply (no_source_between s all proper_s u lo hi m U (proper_edge u U)). }
      apply (shown s m I); [now apply midway_is_candidate | lra |].
      apply (passing_shows s t); trivial.
      + now apply everywhere.
      + intros (u & U & equal). apply (no_vertex u); [apply in_app_iff; now left | exact equal].
      + intros (u & U & equal). apply (no_vertex u); [apply in_app_iff; now right | exact equal].
  Qed.

  (* What the test finds is there. *)
  Lemma found_is_there : boundary_shows a b = true -> boundary_enters a b \/ edges_pass a b.
  Proof.
    intros found. apply existsb_exists in found. destruct found as (s & I & found).
    apply existsb_exists in found. destruct found as (k & _ & found). apply andb_true_iff in found.
    destruct found as [range found]. apply andb_true_iff in range. destruct range as [k0 k1].
    destruct (at_most_spec 0 k) as [k_0 |]; [| discriminate]. destruct (at_most_spec k 1) as [k_1 |]; [| discriminate].
    pose proof (on_segment s k (conj k_0 k_1)) as on_s. unfold shows in found. apply orb_true_iff in found.
    destruct found as [found | found].
    - left. exists s, (point_on s k). split; [exact I |]. split; [exact on_s |]. now apply inside_spec.
    - right. apply existsb_exists in found. destruct found as (t & T & found). rewrite !andb_true_iff in found.
      destruct found as [[[on_t no_a] no_b] turn]. exists s, t, (point_on s k).
      destruct (lies_on_spec (point_on s k) t); [| discriminate].
      destruct (is_vertex_spec (point_on s k) a); [discriminate |].
      destruct (is_vertex_spec (point_on s k) b); [discriminate |].
      do 6 (split; [assumption |]). apply not_opposite_spec; [| | exact turn]; apply proper_edge, in_app_iff; tauto.
  Qed.
End TwoRegions.

(* Theorem. The test decides whether the interiors of two valid regions have a point in common: whatever their
   position, with parallel edges, shared vertices and chains that touch. *)
Theorem collide_decides (a b : region) :
  valid_region a -> valid_region b -> at_most_once a -> at_most_once b ->
  (collide a b = true <-> have_common_interior a b).
Proof.
  intros a_valid b_valid a_once b_once.
  rewrite (common_interior_iff_boundaries_show_it a b a_valid b_valid a_once b_once).
  unfold collide. rewrite orb_true_iff. split.
  - intros [found | found].
    + destruct (found_is_there a b a_valid b_valid found); tauto.
    + destruct (found_is_there b a b_valid a_valid found) as [enters | pass]; [tauto |].
      right. right. now apply edges_pass_other_way.
  - intros [enters | [enters | pass]].
    + left. now apply entering_is_found.
    + right. now apply entering_is_found.
    + left. now apply passing_is_found.
Qed.
