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
  theorem_4_2_1 simple_chain definition_2_2_8 inside_a_corner boundary_points reduced_convolution edges_at_a_point
  fan_at_a_point.
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

(* Edges of one direction that add up to x, and an edge and a vertex that has it in its tangent set. *)
Section Pair.
  Variables p q : region.
  Variables x w u : vector.
  Hypothesis p_region : valid_region p.
  Hypothesis q_region : valid_region q.
  Hypothesis sum_ : equal_vectors x (plus w u).

  Lemma common_direction_is_a_tie (e f : segment) : In e (region_edges p) -> In f (region_edges q) ->
    lies_on w e -> lies_on u f -> same_direction (along e) (along f) ->
    exists a b, In a p /\ In b q /\ on_a_tie a b (along e) x.
  Proof.
    intros E F on_e on_f same_.
    apply same_direction_angle in same_; [| apply (region_edges_are_directions _ (proj1 p_region)); exact E |
      apply (region_edges_are_directions _ (proj1 q_region)); exact F].
    destruct (edge_by_chain p e E) as (a & i & A & I & ->), (edge_by_chain q f F) as (b & j & B & J & ->).
    destruct (on_by_index a i w I on_e) as (t & t_range & w_is), (on_by_index b j u J on_f) as (o & o_range & u_is).
    exists a, b. split; [exact A |]. split; [exact B |]. unfold edge_at in *.
    rewrite <- !direction_by_index in * by assumption.
    apply (sum_along_two_edges a b (chains_turn_everywhere p a p_region A) (chains_turn_everywhere q b q_region B)
      i j t o); trivial.
    rewrite sum_. now apply plus_of_equal.
  Qed.

  Lemma tie_is_covered (a b : list vector) (d : vector) : In a p -> In b q -> nonzero d -> on_a_tie a b d x ->
    covered_along p q x d.
  Proof.
    intros A B proper_d tie. pose proof (chains_turn_everywhere p a p_region A) as turning_p.
    pose proof (chains_turn_everywhere q b q_region B) as turning_q.
    apply (ties_are_segments a b turning_p turning_q) in tie.
    destruct tie as (i & j & t & I & J & range & [(belongs & same_ & x_is) | (belongs & same_ & x_is)]).
    - apply (covered_in_the_same_direction _ x (edge_of_chain a i));
        [apply same_direction_angle; trivial; now apply edge_proper |].
      exact (proj1 (covered_by_index p q x a b A B OfP i j t I J range belongs x_is)).
    - apply (covered_in_the_same_direction _ x (edge_of_chain b j));
        [apply same_direction_angle; trivial; now apply edge_proper |].
      exact (proj1 (covered_by_index p q x a b A B OfQ i j t I J range belongs x_is)).
  Qed.

  Lemma tangent_of_p_is_covered (e : segment) (b : list vector) j : In e (region_edges p) -> lies_on w e ->
    In b q -> (j < length b)%nat -> equal_vectors u (vertex b j) ->
    in_tangent_set (Direction (along e) OfP) (corner_of_chain b j) = true ->
    covered_along p q x (along e) /\ (convex (corner_of_chain b j) -> reduced_along p q x (along e)).
  Proof.
    intros E on_e B J at_vertex tangent. destruct (edge_by_chain p e E) as (a & i & A & I & ->).
    destruct (on_by_index a i w I on_e) as (t & range & w_is). unfold edge_at in *.
    rewrite <- direction_by_index in * by exact I.
    apply (covered_by_index p q x a b A B OfP i j t I J range tangent). rewrite sum_. now apply plus_of_equal.
  Qed.

  Lemma tangent_of_q_is_covered (f : segment) (a : list vector) i : In f (region_edges q) -> lies_on u f ->
    In a p -> (i < length a)%nat -> equal_vectors w (vertex a i) ->
    in_tangent_set (Direction (along f) OfQ) (corner_of_chain a i) = true ->
    covered_along p q x (along f) /\ (convex (corner_of_chain a i) -> reduced_along p q x (along f)).
  Proof.
    intros F on_f A I at_vertex tangent. destruct (edge_by_chain q f F) as (b & j & B & J & ->).
    destruct (on_by_index b j u J on_f) as (t & range & u_is). unfold edge_at in *.
    rewrite <- direction_by_index in * by exact J.
    apply (covered_by_index p q x a b A B OfQ i j t I J range tangent). rewrite sum_. now apply plus_of_equal.
  Qed.
End Pair.

Lemma goes_ahead_along (w d : vector) (s : segment) : departs w s = true -> same_direction d (along s) ->
  eventually (fun t => lies_on (moved_along w d t) s).
Proof.
  intros departing_ (m & some & mx & my). apply departs_is in departing_.
  destruct departing_ as [(k & [k0 k1] & X & Y) goes_on].
  assert (before_end : k < 1).
  { apply Qnot_le_lt. intros at_end. apply goes_on. assert (k_is : k == 1) by lra. rewrite k_is in X, Y.
    split; lra. }
  exists ((1 - k) / m). split; [apply Qlt_shift_div_l; lra |]. intros t t0 t1. exists (k + t * m).
  assert (t * m < (1 - k) / m * m) by now apply Qmult_lt_r. assert (value : (1 - k) / m * m == 1 - k) by (field; lra).
  split; [split; nra |]. in_coordinates. rewrite X, Y, mx, my. split; ring.
Qed.

Lemma goes_ahead_from (w : vector) (s : segment) : departs w s = true ->
  eventually (fun t => lies_on (moved_along w (along s) t) s).
Proof. intros departing_. apply (goes_ahead_along w _ s departing_), same_direction_reflexive. Qed.

Lemma parallel_directions (u v : vector) : nonzero u -> nonzero v -> cross u v == 0 ->
  same_direction u v \/ same_direction u (opposite v).
Proof.
  intros long_u long_v parallel. destruct (multiple_of u v long_v parallel) as (c & X & Y).
  destruct (Q_dec c 0) as [[low | high] | none]; [right | left | exfalso].
  - exists (- c). unfold opposite; cbn [vx vy]. rewrite X, Y. split; [lra | split; ring].
  - now exists c.
  - apply long_u. rewrite X, Y, none. split; ring.
Qed.

(* Edges that leave a common point in opposite directions. *)
Lemma opposite_edges_meet (p q : region) (x w u : vector) (e f : segment) :
  valid_region p -> valid_region q -> equal_vectors x (plus w u) -> In e (region_edges p) -> In f (region_edges q) ->
  departs w e = true -> departs u f = true -> same_direction (along e) (opposite (along f)) -> interiors_meet x p q.
Proof.
  intros p_region q_region [X Y] E F e_departs f_departs back.
  pose proof (region_edges_are_directions p (proj1 p_region) e E) as long. pose proof back as (m & some & mx & my).
  destruct (some_small _ (eventually_and _ _ (goes_ahead_from w e e_departs) (eventually_and _ _
    (goes_ahead_along u (opposite (along e)) f f_departs ltac:(exists m; unfold opposite in *; cbn [vx vy] in *;
      rewrite mx, my; split; [exact some | split; ring])) (leaves_all_vertices p w (along e) long))))
    as (t & _ & on_e & on_f & no_vertex).
  apply (opposite_edge_meets p q x (moved_along w (along e) t) (moved_along u (opposite (along e)) t) (along e) f);
    trivial; [| now apply fills_left_beside_an_edge].
  unfold plus, moved_along, opposite in *; cbn [vx vy] in *. split; cbn [vx vy]; lra.
Qed.

Lemma one_or_all {T : Type} (A : Prop) (B : T -> Prop) (l : list T) :
  (forall s, In s l -> A \/ B s) -> A \/ forall s, In s l -> B s.
Proof.
  induction l as [| s l IH]; intros each; [right; intros s [] |].
  destruct (each s (or_introl eq_refl)) as [a | here]; [now left |].
  destruct IH as [a | there]; [intros t I; apply each; now right | now left |].
  right. intros t [<- | I]; auto.
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
  pose proof (region_edges_are_directions q q_edges f F) as long. set (g := along f) in *.
  assert (long_back : nonzero (opposite g)) by now apply opposite_nonzero.
  destruct (one_or_all (interiors_meet x p q) (fun e => departs w e = true -> ~ cross (opposite g) (along e) == 0)
    (region_edges p)) as [| aside]; [| now left |].
  { intros e E. destruct (departs w e) eqn:e_departs; [| right; discriminate].
    destruct (Qeq_dec (cross (opposite g) (along e)) 0) as [flat | turn]; [left | now right].
    pose proof (region_edges_are_directions p p_edges e E) as long_e.
    destruct (parallel_directions (along e) g) as [same_ | back]; trivial;
      [unfold cross, opposite in *; cbn [vx vy] in *; lra | | now apply (opposite_edges_meet p q x w u e f)].
    exfalso. apply departs_is in e_departs. exact (no_common e E (proj1 e_departs) same_). }
  assert (clear_back : clear_direction w (opposite g) p).
  { intros e E on. split; [rewrite opposite_twice; now apply no_common | now apply aside]. }
  destruct (some_small _ (eventually_and _ _ (goes_ahead_from u f f_departs) (more_than_half_depart_to_the_left p w
    (opposite g) label p_region long_back clear_back ltac:(now rewrite opposite_twice) on_boundary)))
    as (k & _ & on_f & [in_p | half]); [left | now right].
  apply (inner_point_and_point p q x _ (moved_along u g k)
    (regions_are_regular q q_edges q_valid q_meet) in_p (or_intror (ex_intro _ f (conj F on_f)))).
  destruct sum_ as [X Y]. unfold plus, moved_along, opposite in *; cbn [vx vy] in *. split; cbn [vx vy]; lra.
Qed.

Lemma some_edge_departs (r : region) (w : vector) : no_edges_are_points r ->
  (exists s, In s (region_edges r) /\ lies_on w s) -> (0 < departures w r)%Z.
Proof.
  intros not_points (s & I & on).
  assert (found : exists t, In t (region_edges r) /\ departs w t = true).
  { destruct (same_place_spec w (target s)) as [at_end | goes_on];
      [| exists s; split; [exact I | apply departs_is; tauto]].
    destruct (target_is_vertex r s I) as (t & J & equal). exists t. split; [exact J |].
    apply departs_from_its_source; [now apply (region_edges_are_directions r) | now rewrite at_end]. }
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
  destruct (both_on_boundaries_or_meet p q x w u) as [[on_p on_q] |]; trivial.
  assert (not_covered : forall d, ~ covered_along p q x d) by (intros d (s & S & on & _); exact (free s S on)).
  assert (no_common : forall e f, In e (region_edges p) -> In f (region_edges q) -> lies_on w e -> lies_on u f ->
    ~ same_direction (along e) (along f)).
  { intros e f E F on_e on_f same_. destruct (common_direction_is_a_tie p q x w u p_region q_region sum_ e f)
      as (a & b & A & B & tie); trivial.
    apply (not_covered (along e)), (tie_is_covered p q x p_region q_region a b); trivial.
    now apply (region_edges_are_directions p (proj1 p_region)). }
  destruct (one_or_all (interiors_meet x p q) (fun f => departs u f = true ->
    (departures w p < 2 * departures_left_of w (opposite (along f)) p)%Z) (region_edges q)) as [| right_of_q]; trivial.
  { intros f F. destruct (departs u f) eqn:f_departs; [| right; discriminate].
    pose proof (proj1 (proj1 (departs_is u f) f_departs)) as on_f.
    destruct (half_beside_an_edge p q x w u f OfQ p_region q_region sum_ on_p F f_departs) as [|]; auto.
    destruct (tangent_vertex_or_none p w (Direction (along f) OfQ)) as [(a & i & A & I & at_vertex & tangent) |];
      trivial.
    exfalso. apply (not_covered (along f)), (tangent_of_q_is_covered p q x w u sum_ f a i); trivial. }
  destruct (one_or_all (interiors_meet x p q) (fun e => departs w e = true ->
    (departures u q < 2 * departures_left_of u (opposite (along e)) q)%Z) (region_edges p)) as [| right_of_p]; trivial.
  { intros e E. destruct (departs w e) eqn:e_departs; [| right; discriminate].
    pose proof (proj1 (proj1 (departs_is w e) e_departs)) as on_e.
    destruct (half_beside_an_edge q p x u w e OfP q_region p_region (sum_in_other_order _ _ _ sum_) on_q E e_departs)
      as [meet |]; auto.
    - intros f F on_f same_. now apply (no_common e f), same_direction_symmetric.
    - destruct (tangent_vertex_or_none q u (Direction (along e) OfP)) as [(b & j & B & J & at_vertex & tangent) |];
        trivial.
      exfalso. apply (not_covered (along e)), (tangent_of_p_is_covered p q x w u sum_ e b j); trivial.
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
  - exact (some_edge_departs p w (proj1 p_region) on_p).
  - exact (some_edge_departs q u (proj1 q_region) on_q).
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
