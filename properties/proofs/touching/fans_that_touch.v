(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Theorem 4.2.1 for interiors, for all valid regions, chains that touch included: off the convolution, the winding
   number is positive if and only if the interiors of P and -Q + x have a point in common. And so Theorems 2.2.6 and
   2.2.10 for the open sum (open_sum.v).
   Say P and -Q + x touch in a point, and their interiors do not meet. An edge f of Q that leaves this point, in
   -Q + x backwards, is outside P, and if it is in no tangent set there, more than half of the edges of P that leave
   the point are to the left of f backwards (fan_at_a_point.v), which is to the right of f. In the same way more than
   half of the edges of Q that leave it are to the right of each such edge of P. But of two edges only one is to the
   right of the other. So an edge of one is in a tangent set of the other, and x is on the convolution. *)
From Coq Require Import ZArith Lia Bool List.
From Oplus Require Import numbers convolution signed_crossings tie_rule convolution_winding regions weight finite_sums
  tangent_count meeting_of_segments neighbourhoods winding_number_of_the_sum interiors_meet left_of_an_edge
  theorem_4_2_1 simple_chain definition_2_2_8 boundary_points parallel_edges edges_at_a_point fan_at_a_point.
Import ListNotations.

Open Scope Q_scope.

(* Chains of a valid region turn back nowhere. *)
Lemma chains_turn_everywhere (r : region) (chain : list vector) :
  valid_region r -> In chain r -> turns_everywhere chain.
Proof.
  intros r_valid I c J. apply (In_nth _ _ (Corner nowhere nowhere)) in J. destruct J as (i & below & <-).
  rewrite corners_length in below. fold (corner_of_chain chain i).
  pose proof (previous_below _ _ below) as before_.
  rewrite corner_is by exact below. cbn [incoming outgoing]. rewrite !direction_by_index by assumption.
  apply (consecutive_edges_turn r); trivial; try now apply edge_at_in_region.
  rewrite !edge_by_index by assumption. cbn [source target]. rewrite next_previous by exact below.
  split; reflexivity.
Qed.

Lemma on_by_index (chain : list vector) i (w : vector) : (i < length chain)%nat -> lies_on w (edge_at chain i) ->
  exists t, 0 <= t <= 1 /\ equal_vectors w (point_along chain i t).
Proof.
  intros below (t & range & X & Y). exists t. split; [exact range |].
  rewrite edge_at_is in X, Y by exact below. unfold point_along. rewrite edge_of_chain_is by exact below.
  unfold minus, vertex in *. cbn [source target vx vy] in *. split; cbn [vx vy]; lra.
Qed.

Lemma on_the_convolution (p q : region) (x : vector) (a b : list vector) :
  In a p -> In b q -> on_a_segment a b x -> ~ off x (convolution_segments p q).
Proof.
  intros A B on_segment free.
  destruct (proj2 (on_segments_of_regions p q x)) as (s & I & on); [now exists a, b |].
  apply (free (Segment (starts_at s) (ends_at s))); [| exact on].
  apply (in_map (fun s => Segment (starts_at s) (ends_at s)) _ _ I).
Qed.

Lemma tangent_vertex_or_none (r : region) (w : vector) (d : direction) :
  (exists chain i, In chain r /\ (i < length chain)%nat /\ equal_vectors w (vertex chain i) /\
     in_tangent_set d (corner_of_chain chain i) = true) \/ tangents_at w d r = 0%Z.
Proof.
  destruct (Z_lt_le_dec 0 (tangents_at w d r)) as [some | none]; [left | right].
  - apply positive_sum in some. destruct some as (v & I & term).
    apply in_flat_map in I. destruct I as (chain & J & I). apply (In_nth _ _ (nowhere, Corner nowhere nowhere)) in I.
    destruct I as (i & below & v_is). rewrite combine_length, corners_length in below.
    rewrite combine_nth in v_is by (symmetry; apply corners_length). subst v. cbn [fst snd] in term.
    exists chain, i. split; [exact J |]. split; [lia |]. unfold if_tangent, corner_of_chain, vertex in *.
    destruct (same_place_spec w (nth i chain nowhere)); [| discriminate].
    destruct (in_tangent_set d _); [now split | discriminate].
  - assert (0 <= tangents_at w d r)%Z; [| lia]. apply sum_is_not_negative. intros v _. unfold if_tangent.
    destruct (same_place w (fst v)), (in_tangent_set d (snd v)); discriminate.
Qed.

(* Off the convolution no edges of one direction add up to x, and no tangent edge. *)
Section OffTheConvolution.
  Variables p q : region.
  Variables x w u : vector.
  Hypothesis p_region : valid_region p.
  Hypothesis q_region : valid_region q.
  Hypothesis free : off x (convolution_segments p q).
  Hypothesis sum_ : equal_vectors x (plus w u).

  Lemma no_common_direction (e f : segment) : In e (region_edges p) -> In f (region_edges q) ->
    lies_on w e -> lies_on u f -> ~ same_direction (along e) (along f).
  Proof.
    intros E F on_e on_f same_.
    apply same_direction_angle in same_; [| apply (region_edges_are_directions _ (proj1 p_region)); exact E |
      apply (region_edges_are_directions _ (proj1 q_region)); exact F].
    destruct (edge_by_chain p e E) as (a & i & A & I & ->). destruct (edge_by_chain q f F) as (b & j & B & J & ->).
    destruct (on_by_index a i w I on_e) as (t & t_range & w_is), (on_by_index b j u J on_f) as (o & o_range & u_is).
    apply (on_the_convolution p q x a b A B); [| exact free].
    apply (sum_of_two_edges a b (chains_turn_everywhere p a p_region A) (chains_turn_everywhere q b q_region B)
      i j t o); trivial.
    - rewrite !direction_by_index by assumption. exact same_.
    - rewrite sum_. now apply plus_of_equal.
  Qed.

  Lemma no_tangent_of_q (f : segment) : In f (region_edges q) -> lies_on u f ->
    tangents_at w (Direction (along f) OfQ) p = 0%Z.
  Proof.
    intros F on_f. destruct (edge_by_chain q f F) as (b & j & B & J & ->).
    destruct (on_by_index b j u J on_f) as (o & o_range & u_is).
    destruct (tangent_vertex_or_none p w (Direction (along (edge_at b j)) OfQ))
      as [(a & i & A & I & at_vertex & tangent) |]; [exfalso | assumption].
    apply (on_the_convolution p q x a b A B); [| exact free].
    exists i, j, o. split; [exact I |]. split; [exact J |]. split; [exact o_range |]. right. split.
    - unfold is_convolution_segment. rewrite direction_by_index by exact J. exact tangent.
    - rewrite sum_. now apply plus_of_equal.
  Qed.

  Lemma no_tangent_of_p (e : segment) : In e (region_edges p) -> lies_on w e ->
    tangents_at u (Direction (along e) OfP) q = 0%Z.
  Proof.
    intros E on_e. destruct (edge_by_chain p e E) as (a & i & A & I & ->).
    destruct (on_by_index a i w I on_e) as (t & t_range & w_is).
    destruct (tangent_vertex_or_none q u (Direction (along (edge_at a i)) OfP))
      as [(b & j & B & J & at_vertex & tangent) |]; [exfalso | assumption].
    apply (on_the_convolution p q x a b A B); [| exact free].
    exists i, j, t. split; [exact I |]. split; [exact J |]. split; [exact t_range |]. left. split.
    - unfold is_convolution_segment. rewrite direction_by_index by exact I. exact tangent.
    - rewrite sum_. now apply plus_of_equal.
  Qed.
End OffTheConvolution.

Lemma goes_ahead_from (w : vector) (s : segment) : departs w s = true ->
  eventually (fun t => lies_on (moved_along w (along s) t) s).
Proof.
  intros departing_. apply departs_is in departing_. destruct departing_ as [(k & [k0 k1] & X & Y) goes_on].
  assert (before_end : k < 1).
  { apply Qnot_le_lt. intros at_end. apply goes_on. assert (k_is : k == 1) by lra. rewrite k_is in X, Y.
    split; lra. }
  exists (1 - k). split; [lra |]. intros t t0 t1. exists (k + t). split; [lra |].
  unfold moved_along, along, minus; cbn [vx vy]. rewrite X, Y. split; ring.
Qed.

Lemma one_or_all {T : Type} (A : Prop) (B : T -> Prop) (l : list T) :
  (forall s, In s l -> A \/ B s) -> A \/ forall s, In s l -> B s.
Proof.
  induction l as [| s l IH]; intros each; [right; intros s [] |].
  destruct (each s (or_introl eq_refl)) as [a | here]; [now left |].
  destruct IH as [a | there]; [intros t I; apply each; now right | now left |].
  right. intros t [<- | I]; auto.
Qed.

Lemma same_half (r : region) (w a b : vector) (k : Q) : 0 < k -> vx b == k * vx a -> vy b == k * vy a ->
  departures_left_of w b r = departures_left_of w a r.
Proof.
  intros some X Y. apply sum_equally. intros s _. f_equal. f_equal.
  assert (value : cross b (along s) == k * cross a (along s)) by (unfold cross; rewrite X, Y; ring).
  destruct (positive_spec (cross b (along s))) as [left_ | none],
    (positive_spec (cross a (along s))) as [left' | none']; try reflexivity; exfalso.
  - assert (0 <= k * - cross a (along s)) by (apply Qmult_le_0_compat; lra). lra.
  - apply none. rewrite value. now apply Qmult_lt_0_compat.
Qed.

(* An edge f of the one that leaves the common point: the interiors meet, or more than half of the edges of the other
   leave to the right of it. *)
Lemma half_beside_an_edge (p q : region) (x w u : vector) (f : segment) (label : summand) :
  valid_region p -> valid_region q -> equal_vectors x (plus w u) ->
  (exists e, In e (region_edges p) /\ lies_on w e) -> In f (region_edges q) -> departs u f = true ->
  (forall e, In e (region_edges p) -> lies_on w e -> ~ same_direction (along e) (along f)) ->
  tangents_at w (Direction (along f) label) p = 0%Z ->
  interiors_meet x p q \/ (departures w p < 2 * departures_left_of w (opposite (along f)) p)%Z.
Proof.
  intros p_region q_region sum_ on_boundary F f_departs no_common no_tangent.
  pose proof p_region as (p_edges & p_valid & p_meet). pose proof q_region as (q_edges & q_valid & q_meet).
  pose proof (regions_are_regular q q_edges q_valid q_meet) as q_regular.
  pose proof (region_edges_are_directions q q_edges f F) as long. set (g := along f) in *.
  assert (decided : interiors_meet x p q \/ forall e, In e (region_edges p) ->
    departs w e = true -> ~ cross (opposite g) (along e) == 0).
  { apply (one_or_all _ (fun e => departs w e = true -> ~ cross (opposite g) (along e) == 0)). intros e E.
    destruct (departs w e) eqn:e_departs; [| right; discriminate].
    destruct (Qeq_dec (cross (opposite g) (along e)) 0) as [parallel | turn]; [left | now right].
    apply (opposite_edges_meet p q x w u e f); trivial; try now apply goes_ahead_from.
    pose proof (region_edges_are_directions p p_edges e E) as long_e. fold g.
    pose proof (opposite_nonzero g long) as long_back. apply departs_is in e_departs.
    pose proof (no_common e E (proj1 e_departs)) as differ. rewrite same_direction_angle in differ |- * by trivial.
    pose proof (cross_angle _ _ long_back long_e) as turn_. unfold turns_by in turn_.
    pose proof (opposite_angle g long). pose proof (angle_range _ long). pose proof (angle_range _ long_e). lra. }
  destruct decided as [| aside]; [now left |].
  destruct (some_square w p) as (radius & near). pose proof near as [R near_].
  destruct (eventually_and _ _ (small_steps_stay_within radius w (opposite g) R) (goes_ahead_from u f f_departs))
    as (limit & L & close).
  destruct (close ((1 # 2) * limit)) as [near_z on_f]; [lra | lra |].
  set (k := (1 # 2) * limit) in *. assert (some : 0 < k) by (unfold k; lra). clearbody k. fold g in on_f.
  set (z := Vector (k * vx (opposite g)) (k * vy (opposite g))).
  assert (z_back : same_direction g (opposite z)).
  { exists (/ k). split; [now apply Qinv_lt_0_compat |]. unfold z, opposite; cbn [vx vy]. split; field; lra. }
  assert (aside_z : forall e, cross z (along e) == 0 -> cross (opposite g) (along e) == 0).
  { intros e parallel. apply (Qmult_inj_r _ _ k); [lra |].
    transitivity (cross z (along e)); [unfold cross, z; cbn [vx vy]; ring | lra]. }
  assert (no_common_z : forall e, In e (region_edges p) -> lies_on w e -> ~ same_direction (along e) (opposite z)).
  { intros e E on (m & m_some & X & Y). apply (no_common e E on). exists (m * k).
    unfold z, opposite in X, Y; cbn [vx vy] in X, Y. rewrite X, Y.
    split; [now apply Qmult_lt_0_compat | split; ring]. }
  destruct (on_or_off (plus w z) (region_edges p)) as [(e & E & on) | off_z].
  - (* an edge there neither leaves w nor enters it *)
    exfalso. destruct (near_ e) as [on_w | free]; [apply in_flat_map; exists e; split; [exact E | now left] | |].
    2: exact (free _ near_z on).
    pose proof (region_edges_are_directions p p_edges e E) as long_e.
    destruct (ahead_or_behind w z e on_w on) as (m & X & Y & ahead & _).
    destruct (Q_dec m 0) as [[low | high] | none].
    + apply (no_common_z e E on_w). exists (/ - m). split; [apply Qinv_lt_0_compat; lra |].
      unfold opposite; cbn [vx vy]. rewrite X, Y. split; field; lra.
    + apply (aside e E (ahead high long_e)), aside_z. unfold cross. rewrite X, Y. ring.
    + apply long. rewrite none in X, Y. unfold z, opposite in X, Y; cbn [vx vy] in X, Y.
      split; apply (Qmult_inj_r _ _ k); lra.
  - destruct (Z_lt_le_dec 0 (winding_number (plus w z) (region_edges p))) as [round | none].
    + left. apply (inner_point_and_point p q x (plus w z) (moved_along u g k) q_regular); [now split | |].
      * right. now exists f.
      * destruct sum_ as [X Y]. unfold plus, moved_along, z, opposite in *; cbn [vx vy] in *. split; cbn [vx vy]; lra.
    + right. pose proof (p_valid _ off_z). rewrite <- (same_half p w (opposite g) z k some); [| reflexivity ..].
      apply (more_than_half_depart_to_the_left p w z g label radius); trivial; [| lia].
      split; [exact off_z |]. intros e E on. split; [now apply no_common_z |].
      intros e_departs parallel. now apply (aside e E e_departs), aside_z.
Qed.

Lemma some_edge_departs (r : region) (w : vector) : no_edges_are_points r ->
  (exists s, In s (region_edges r) /\ lies_on w s) -> (0 < departures w r)%Z.
Proof.
  intros not_points (s & I & on).
  assert (found : exists t, In t (region_edges r) /\ departs w t = true).
  { destruct (same_place_spec w (target s)) as [at_end | goes_on];
      [| exists s; split; [exact I | apply departs_is; tauto]].
    destruct (target_is_vertex r s I) as (t & J & equal). exists t. split; [exact J |]. apply departs_is.
    assert (at_start : equal_vectors w (source t)) by now rewrite at_end.
    split; [apply (lies_on_equal (source t)); [now symmetry | apply source_lies_on] |].
    intros [X Y]. destruct at_start as [X' Y']. apply (region_edges_are_directions r not_points t J).
    unfold along, minus; cbn [vx vy]. lra. }
  destruct found as (t & J & t_departs).
  assert (terms : forall s, In s (region_edges r) -> (0 <= Z.b2z (departs w s))%Z)
    by (intros e _; destruct (departs w e); cbn; lia).
  pose proof (sum_is_not_negative _ _ _ terms) as not_negative. fold (departures w r) in not_negative.
  destruct (Z.eq_dec (departures w r) 0) as [none |]; [exfalso | lia].
  pose proof (zero_sum _ _ _ terms none t J) as term. cbv beta in term.
  rewrite t_departs in term. discriminate.
Qed.

Lemma sum_is_at_most (A : Type) (f g : A -> Z) (l : list A) :
  (forall a, In a l -> f a <= g a)%Z -> (sum_of f l <= sum_of g l)%Z.
Proof.
  intros each. enough (0 <= sum_of (fun a => g a - f a) l)%Z by (rewrite sum_minus in *; lia).
  apply sum_is_not_negative. intros a I. specialize (each a I). lia.
Qed.

(* If of each pair only one sees the other, not all of both see more than half of the others. *)
Lemma not_more_than_half_both_ways (A B : Type) (l : A -> Z) (m : B -> Z) (c d : A -> B -> Z) some others :
  (forall a, 0 <= l a)%Z -> (forall b, 0 <= m b)%Z -> (forall a b, c a b + d a b <= 1)%Z ->
  (forall b, In b others -> 0 < m b -> sum_of l some < 2 * sum_of (fun a => l a * c a b) some)%Z ->
  (forall a, In a some -> 0 < l a -> sum_of m others < 2 * sum_of (fun b => m b * d a b) others)%Z ->
  (0 < sum_of l some)%Z -> (0 < sum_of m others)%Z -> False.
Proof.
  intros l_sign m_sign one_way most most' l_some m_some.
  set (L := sum_of l some) in *. set (M := sum_of m others) in *.
  assert (by_others : ((L + 1) * M <= 2 * sum_of (fun b => m b * sum_of (fun a => l a * c a b) some) others)%Z).
  { unfold M. rewrite <- !sum_times. apply sum_is_at_most. intros b I. specialize (most b I).
    destruct (Zle_lt_or_eq _ _ (m_sign b)) as [high | <-]; [specialize (most high); nia | lia]. }
  assert (by_some : ((M + 1) * L <= 2 * sum_of (fun a => l a * sum_of (fun b => m b * d a b) others) some)%Z).
  { unfold L. rewrite <- !sum_times. apply sum_is_at_most. intros a I. specialize (most' a I).
    destruct (Zle_lt_or_eq _ _ (l_sign a)) as [high | <-]; [specialize (most' high); nia | lia]. }
  assert (pairs : (sum_of (fun b => m b * sum_of (fun a => l a * c a b) some) others +
    sum_of (fun a => l a * sum_of (fun b => m b * d a b) others) some <= M * L)%Z).
  { rewrite (sum_equally _ _ (fun b => sum_of (fun a => m b * (l a * c a b)) some)%Z)
      by (intros; now rewrite sum_times).
    rewrite (sums_exchanged _ _ (fun b a => m b * (l a * c a b))%Z), <- sum_plus. unfold L. rewrite <- sum_times.
    apply sum_is_at_most. intros a _. rewrite <- sum_times, <- sum_plus, Z.mul_comm. unfold M. rewrite <- sum_times.
    apply sum_is_at_most. intros b _. specialize (one_way a b). specialize (l_sign a). specialize (m_sign b). nia. }
  nia.
Qed.

(* Theorem. Off the convolution, where P and -Q + x have a point in common, their interiors meet. *)
Theorem common_point_off_the_convolution (p q : region) (x : vector) :
  valid_region p -> valid_region q -> off x (convolution_segments p q) -> in_sum x p q -> interiors_meet x p q.
Proof.
  intros p_region q_region free (w & u & in_p & in_q & sum_).
  pose proof p_region as (p_edges & p_valid & p_meet). pose proof q_region as (q_edges & q_valid & q_meet).
  pose proof (regions_are_regular p p_edges p_valid p_meet) as p_regular.
  pose proof (regions_are_regular q q_edges q_valid q_meet) as q_regular.
  assert (swapped : equal_vectors x (plus u w))
    by (destruct sum_ as [X Y]; unfold plus in *; cbn [vx vy] in *; split; cbn [vx vy]; lra).
  destruct (on_or_off w (region_edges p)) as [on_p | off_p].
  2: { apply (inner_point_and_point p q x w u q_regular); trivial. split; [exact off_p |].
       destruct in_p as [positive_ | (s & S & on)]; [exact positive_ | exfalso; exact (off_p s S on)]. }
  destruct (on_or_off u (region_edges q)) as [on_q | off_q].
  2: { apply interiors_meet_other_way. apply (inner_point_and_point q p x u w p_regular); trivial.
       split; [exact off_q |].
       destruct in_q as [positive_ | (s & S & on)]; [exact positive_ | exfalso; exact (off_q s S on)]. }
  destruct (one_or_all (interiors_meet x p q) (fun f => departs u f = true ->
    (departures w p < 2 * departures_left_of w (opposite (along f)) p)%Z) (region_edges q)) as [| right_of_q]; trivial.
  { intros f F. destruct (departs u f) eqn:f_departs; [| right; discriminate].
    pose proof (proj1 (proj1 (departs_is u f) f_departs)) as on_f.
    destruct (half_beside_an_edge p q x w u f OfQ p_region q_region sum_ on_p F f_departs) as [|]; auto.
    - intros e E on_e. now apply (no_common_direction p q x w u).
    - now apply (no_tangent_of_q p q x w u). }
  destruct (one_or_all (interiors_meet x p q) (fun e => departs w e = true ->
    (departures u q < 2 * departures_left_of u (opposite (along e)) q)%Z) (region_edges p)) as [| right_of_p]; trivial.
  { intros e E. destruct (departs w e) eqn:e_departs; [| right; discriminate].
    pose proof (proj1 (proj1 (departs_is w e) e_departs)) as on_e.
    destruct (half_beside_an_edge q p x u w e OfP q_region p_region swapped on_q E e_departs) as [meet |]; auto.
    - intros f F on_f same_. apply (no_common_direction p q x w u p_region q_region free sum_ e f); trivial.
      now apply same_direction_symmetric.
    - now apply (no_tangent_of_p p q x w u).
    - left. now apply interiors_meet_other_way. }
  (* of two edges only one is to the right of the other *)
  exfalso. apply (not_more_than_half_both_ways _ _ (fun e => Z.b2z (departs w e)) (fun f => Z.b2z (departs u f))
    (fun e f => Z.b2z (positive (cross (opposite (along f)) (along e))))
    (fun e f => Z.b2z (positive (cross (opposite (along e)) (along f)))) (region_edges p) (region_edges q)).
  - intros e. destruct (departs w e); discriminate.
  - intros f. destruct (departs u f); discriminate.
  - intros e f. assert (turned_ : cross (opposite (along f)) (along e) == - cross (opposite (along e)) (along f))
      by (unfold cross, opposite; cbn [vx vy]; ring).
    destruct (positive_spec (cross (opposite (along f)) (along e))),
      (positive_spec (cross (opposite (along e)) (along f))); cbn [Z.b2z]; try lia; exfalso; lra.
  - intros f F f_departs. apply (right_of_q f F). now destruct (departs u f).
  - intros e E e_departs. apply (right_of_p e E). now destruct (departs w e).
  - now apply (some_edge_departs p w).
  - now apply (some_edge_departs q u).
Qed.

(* Theorem 4.2.1 for interiors. Off the convolution, the winding number is positive if and only if the interiors of P
   and -Q + x have a point in common. *)
Theorem positive_winding_number_iff_common_inner_point (p q : region) (x : vector) :
  valid_region p -> valid_region q -> off x (convolution_segments p q) ->
  ((0 < winding_number x (convolution_segments p q))%Z <-> interiors_meet x p q).
Proof.
  intros p_region q_region free. split.
  - intros positive_. apply common_point_off_the_convolution; trivial.
    now apply (positive_winding_number_iff_common_point p q x p_region q_region free).
  - destruct p_region as (p_edges & p_valid & _), q_region as (q_edges & q_valid & _).
    now apply interiors_meet_means_positive_winding_number.
Qed.
