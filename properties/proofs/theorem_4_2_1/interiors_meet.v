(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Theorem 4.2.1, second half: where the interiors of P and -Q + x meet, the winding number of the convolution at x
   is positive. From the identity of tangent_count.v: if the winding number is zero, all its terms are, in
   every direction; so no edges cross (crossing_edges.v), no vertex of one is inside the other
   (tangent_direction.v), and nothing is inside both (winding_numbers_of_valid_regions.v). *)
From Coq Require Import PeanoNat ZArith Lia Bool List.
From Oplus Require Import numbers convolution shifted_ray signed_crossings small_numbers tie_rule convolution_winding
  finite_sums weight regions parallelogram tangent_count beside_every_point winding_number_of_the_sum
  meeting_of_segments first_hit reflected tangent_direction crossing_edges valid_components
  winding_numbers_of_valid_regions.
Import ListNotations.

Open Scope Q_scope.

(* Inside a region, and not on its boundary. *)
Definition inside (z : vector) (r : region) : Prop :=
  off z (region_edges r) /\ (0 < winding_number z (region_edges r))%Z.

(* The interiors of P and -Q + x have a point in common. *)
Definition interiors_meet (x : vector) (p q : region) : Prop :=
  exists z, inside z p /\ inside (minus x z) q.

(* x is on no sum of a vertex and an edge (thesis, Definition 2.2.1). *)
Definition off_vertex_edge_sum (x : vector) (p q : region) : Prop :=
  forall e f, In e (region_edges p) -> In f (region_edges q) -> not_sum_of_an_end x e f.

Lemma zero_sum (A : Type) (f : A -> Z) (l : list A) :
  (forall a, In a l -> 0 <= f a)%Z -> sum_of f l = 0%Z -> forall a, In a l -> f a = 0%Z.
Proof.
  intros terms total_ a I. induction l as [| b l IH]; [destruct I |].
  rewrite sum_of_more in total_. pose proof (terms b (or_introl eq_refl)) as first_term.
  assert (rest : (0 <= sum_of f l)%Z) by (apply sum_is_not_negative; intros c J; apply terms; now right).
  destruct I as [<- | I]; [lia |]. apply IH; [intros c J; apply terms; now right | lia | exact I].
Qed.

Lemma opposite_twice (d : vector) : opposite (opposite d) = d.
Proof.
  destruct d as [x y]. unfold opposite. cbn [vx vy]. now rewrite !negated_twice.
Qed.

(* The winding number is the same at all vertices of a chain that other chains do not meet. *)
Lemma same_at_all_vertices (chain : list vector) (others : list segment) :
  cycles others -> have_no_common_point (edges chain) others -> forall i, (i < length chain)%nat ->
  winding_number (nth i chain nowhere) others = winding_number (nth 0 chain nowhere) others.
Proof.
  intros closed separate i. induction i as [| i IH]; intros I; [reflexivity |].
  assert (J : (i < length chain)%nat) by lia. rewrite <- (IH J). clear IH.
  pose proof (edge_by_index chain i J) as edge.
  rewrite next_below in edge by exact I. symmetry.
  apply (winding_number_along (Segment (nth i chain nowhere) (nth (S i) chain nowhere)) others closed).
  intros w on t K on_t. refine (separate _ t w _ K on on_t). rewrite <- edge. apply nth_In.
  now rewrite edges_are_as_many.
Qed.

(* If the chains do not meet, and each chain has a vertex outside, all its vertices are. *)
Lemma all_vertices_outside (x : vector) (p q : region) :
  off_vertex_edge_sum x p q -> have_no_common_point (region_edges p) (map (reflected x) (region_edges q)) ->
  (forall chain, In chain p -> chain <> [] -> exists i, (i < length chain)%nat /\
     winding_number (minus x (nth i chain nowhere)) (region_edges q) = 0%Z) ->
  vertices_outside (region_edges p) (map (reflected x) (region_edges q)).
Proof.
  intros general separate one s I.
  pose proof (reflected_cycles x _ (region_cycles q)) as closed.
  apply in_flat_map in I. destruct I as (chain & J & I).
  destruct (ends_of_edges chain s I) as [_ K].
  destruct (one chain J) as (i & below & outside); [now destruct chain |].
  assert (separate_chain : have_no_common_point (edges chain) (map (reflected x) (region_edges q))).
  { intros e t w E. apply separate. apply in_flat_map. now exists chain. }
  apply (In_nth chain _ nowhere) in K. destruct K as (k & below_k & <-).
  rewrite (same_at_all_vertices chain _ closed separate_chain k below_k).
  rewrite <- (same_at_all_vertices chain _ closed separate_chain i below).
  rewrite winding_number_of_reflected; [exact outside | apply region_cycles |].
  intros f F on.
  assert (E : In (nth i (edges chain) no_segment) (region_edges p)).
  { now apply edge_at_in_region. }
  destruct (general _ f E F) as (free & _). rewrite edge_by_index in free by exact below. now apply free.
Qed.

Lemma vertex_of_region (chain : list vector) (r : region) i : In chain r -> (i < length chain)%nat ->
  In (nth i chain nowhere, corner_of_chain chain i) (region_vertices r).
Proof.
  intros I below. apply in_flat_map. exists chain. split; [exact I |].
  unfold corner_of_chain. rewrite <- combine_nth by now rewrite corners_length.
  apply nth_In. rewrite combine_length, corners_length. lia.
Qed.

(* If no vertex with a direction in its tangent set is inside the other region, each chain has one that is not. *)
Lemma some_vertex_outside (label : summand) (r other_region : region) (x : vector) :
  no_edges_are_points r -> nowhere_negative other_region ->
  (forall d, nonzero d -> sum_of (fun v => if_tangent (Direction d label) (snd v) *
     winding_number (minus x (fst v)) (region_edges other_region))%Z (region_vertices r) = 0%Z) ->
  forall chain, In chain r -> chain <> [] -> exists i, (i < length chain)%nat /\
    winding_number (minus x (nth i chain nowhere)) (region_edges other_region) = 0%Z.
Proof.
  intros not_points valid zero_ chain I some.
  destruct (some_tangent_set_is_not_empty chain (not_points chain I) some) as (i & d & below & proper_d & tangent).
  exists i. split; [exact below |].
  pose proof (zero_sum _ _ _ (no_vertex_is_negative (Direction d label) other_region x _ valid) (zero_ d proper_d) _
    (vertex_of_region chain r i I below)) as term.
  cbn [fst snd] in term. unfold if_tangent in term. rewrite tangent in term. cbn [Z.b2z] in term. lia.
Qed.

Lemma apart_other_way (x : vector) (p q : region) :
  have_no_common_point (region_edges p) (map (reflected x) (region_edges q)) ->
  have_no_common_point (region_edges q) (map (reflected x) (region_edges p)).
Proof.
  intros separate f e' w F E on_f on_e. apply in_map_iff in E. destruct E as (e & <- & E).
  apply on_reflected in on_e. apply (separate e (reflected x f) (minus x w) E); [now apply in_map | exact on_e |].
  apply on_reflected. destruct on_f as (t & range & X & Y). exists t. unfold minus; cbn.
  split; [exact range |]. split; [rewrite <- X | rewrite <- Y]; ring.
Qed.

Lemma off_vertex_edge_sum_other_way (x : vector) (p q : region) :
  off_vertex_edge_sum x p q -> off_vertex_edge_sum x q p.
Proof. intros general f e F E. pose proof (general e f E F). unfold not_sum_of_an_end in *. tauto. Qed.

(* If closed chains have no point in common with others, and no vertex of either has a winding number other than zero
   with respect to the other, then no point at all has winding numbers other than zero with respect to both. *)
Lemma apart_means_no_common_interior (some others : list segment) (z : vector) :
  cycles some -> cycles others -> have_no_common_point some others ->
  vertices_outside some others -> vertices_outside others some ->
  winding_number z some = 0%Z \/ winding_number z others = 0%Z.
Proof.
  intros closed closed_others separate outside others_outside.
  pose proof (no_common_point_swapped _ _ separate) as swapped.
  destruct (some_small _ (eventually_and _ _ (eventually_and _ _ (shifted_off_all z some) (shifted_off_all z others))
    (eventually_and _ _ (same_beside z some) (same_beside z others)))) as (e & _ & (off_some & off_others) & <- & <-).
  apply not_inside_both; trivial. split; [| split].
  - intros p (s & S & on_s) (t & T & on_t). destruct (separate s t p S T on_s on_t).
  - intros p (s & S & on_s) free. split; [exact free |]. rewrite (same_up_to_the_end some others s p); auto.
  - intros p (s & S & on_s) free. split; [exact free |]. rewrite (same_up_to_the_end others some s p); auto.
Qed.

Section NoCommonInterior.
  Variables p q : region.
  Variable x : vector.
  Hypothesis p_edges : no_edges_are_points p.
  Hypothesis q_edges : no_edges_are_points q.
  Hypothesis p_valid : nowhere_negative p.
  Hypothesis q_valid : nowhere_negative q.
  Hypothesis general : off_vertex_edge_sum x p q.
  Hypothesis zero_winding : winding_number x (convolution_segments p q) = 0%Z.

  Lemma all_terms_are_zero (d : vector) : nonzero d ->
    tangent_vertices_of_p d x (region_vertices p) (region_edges q) = 0%Z /\
    tangent_vertices_of_q d x (region_vertices q) (region_edges p) = 0%Z /\
    tangent_crossings d x (region_edges p) (region_edges q) = 0%Z.
  Proof.
    intros proper_d. pose proof (tangent_count_of_regions p q d x p_edges q_edges proper_d) as identity.
    pose proof (no_term_is_negative p q d x p_edges q_edges p_valid q_valid proper_d). lia.
  Qed.

  Lemma no_vertex_of_p_inside (chain : list vector) : In chain p -> chain <> [] ->
    exists i, (i < length chain)%nat /\
      winding_number (minus x (nth i chain nowhere)) (region_edges q) = 0%Z.
  Proof. apply (some_vertex_outside OfQ p q x p_edges q_valid). intros d D. now apply all_terms_are_zero. Qed.

  Lemma no_vertex_of_q_inside (chain : list vector) : In chain q -> chain <> [] ->
    exists i, (i < length chain)%nat /\
      winding_number (minus x (nth i chain nowhere)) (region_edges p) = 0%Z.
  Proof.
    apply (some_vertex_outside OfP q p x q_edges p_valid). intros d D.
    rewrite <- (opposite_twice d). now apply all_terms_are_zero, opposite_nonzero.
  Qed.

  Lemma no_edges_cross (e f : segment) :
    In e (region_edges p) -> In f (region_edges q) -> is_sum_of_points x e f -> False.
  Proof.
    intros E F is_sum.
    pose proof (region_edges_are_directions p p_edges e E) as proper_e.
    pose proof (region_edges_are_directions q q_edges f F) as proper_f.
    pose proof (crossing_edges_count x e f proper_e proper_f is_sum (general e f E F)) as crossing_.
    set (d := minus (along e) (along f)).
    assert (proper_d : nonzero d).
    { intros [X Y]. unfold d, minus in X, Y; cbn [vx vy] in X, Y.
      assert (cross (along e) (along f) == 0); [| lra].
      unfold cross. assert (vx (along e) == vx (along f)) as -> by lra.
      assert (vy (along e) == vy (along f)) as -> by lra. ring. }
    destruct (all_terms_are_zero d proper_d) as (_ & _ & zero_).
    assert (I : In (e, f) (list_prod (region_edges p) (region_edges q))) by now apply in_prod.
    pose proof (zero_sum _ _ _ (no_pair_of_edges_is_negative p q d x p_edges q_edges proper_d) zero_ _ I) as term.
    cbn [fst snd] in term.
    destruct (weight_in_the_direction_of_the_difference (along e) (along f) proper_e proper_f) as [left_ right_].
    fold d in left_, right_.
    destruct crossing_ as [[sign crossing_] | [sign crossing_]]; rewrite crossing_ in term;
      [rewrite (left_ sign) in term | rewrite (right_ sign) in term]; discriminate term.
  Qed.

  Lemma boundaries_are_apart : have_no_common_point (region_edges p) (map (reflected x) (region_edges q)).
  Proof.
    intros e f' w E F on_e on_f. apply in_map_iff in F. destruct F as (f & <- & F).
    apply on_reflected in on_f. apply (no_edges_cross e f E F).
    exists w, (minus x w). split; [exact on_e |]. split; [exact on_f |].
    split; unfold plus, minus; cbn; ring.
  Qed.

  Lemma no_point_inside_both (z : vector) :
    winding_number z (region_edges p) = 0%Z \/ winding_number z (map (reflected x) (region_edges q)) = 0%Z.
  Proof.
    pose proof boundaries_are_apart as separate.
    apply apart_means_no_common_interior.
    - apply region_cycles.
    - apply reflected_cycles, region_cycles.
    - exact separate.
    - apply all_vertices_outside; trivial. exact no_vertex_of_p_inside.
    - (* the vertices of -Q + x *)
      pose proof (all_vertices_outside x q p (off_vertex_edge_sum_other_way x p q general)
                    (apart_other_way x p q separate) no_vertex_of_q_inside) as outside.
      intros f' F. apply in_map_iff in F. destruct F as (f & <- & F). cbn [reflected target].
      rewrite <- (winding_number_of_reflected x (target f) (region_edges p)).
      + exact (outside f F).
      + apply region_cycles.
      + intros e E. now destruct (general e f E F) as (_ & _ & _ & free).
  Qed.
End NoCommonInterior.

(* In general position. *)
Lemma interiors_meet_in_general_position (p q : region) (x : vector) :
  no_edges_are_points p -> no_edges_are_points q -> nowhere_negative p -> nowhere_negative q ->
  off_vertex_edge_sum x p q -> interiors_meet x p q -> (0 < winding_number x (convolution_segments p q))%Z.
Proof.
  intros p_edges q_edges p_valid q_valid general (z & [_ in_p] & [free in_q]).
  pose proof (convolution_is_nowhere_negative p q x p_edges q_edges p_valid q_valid) as not_negative.
  destruct (Z.eq_dec (winding_number x (convolution_segments p q)) 0) as [zero_ |]; [exfalso | lia].
  destruct (no_point_inside_both p q x p_edges q_edges p_valid q_valid general zero_ z) as [none | none]; [lia |].
  rewrite winding_number_of_reflected in none; [lia | apply region_cycles | exact free].
Qed.

Lemma off_equal (a b : vector) (segments : list segment) : equal_vectors a b -> off a segments -> off b segments.
Proof. intros equal free s I on. apply (free s I). now apply (lies_on_equal b); [symmetry |]. Qed.

Lemma shifted_minus (x v : vector) (e : Q) :
  equal_vectors (moved (shifted (minus x v)) e) (minus (moved (shifted x) e) v).
Proof. split; unfold moved, shifted, minus; cbn; ring. Qed.

(* Beside each point is one in general position. *)
Lemma general_position_beside (p q : region) (x : vector) :
  eventually (fun e => off_vertex_edge_sum (moved (shifted x) e) p q).
Proof.
  refine (eventually_implied _ _ _
    (eventually_for_all (fun pair e => not_sum_of_an_end (moved (shifted x) e) (fst pair) (snd pair))
       (list_prod (region_edges p) (region_edges q)) _)).
  - intros e all_pairs s t S T. apply (all_pairs (s, t)). now apply in_prod.
  - intros [s t] _. cbn [fst snd].
    assert (one : forall v u, eventually (fun e => ~ lies_on (minus (moved (shifted x) e) v) u)).
    { intros v u. refine (eventually_implied _ _ _ (shifted_off (minus x v) u)).
      intros e free (k & range & X & Y). apply free. exists k. destruct (shifted_minus x v e) as [-> ->]. tauto. }
    unfold not_sum_of_an_end. repeat apply eventually_and; apply one.
Qed.

(* Theorem. P and Q are regions of any closed chains, with no negative winding number. If a point is inside P and
   inside -Q + x, the winding number of the convolution at x is positive. x may be on the convolution: there
   the winding number is that of a point beside it. *)
Theorem interiors_meet_means_positive_winding_number (p q : region) (x : vector) :
  no_edges_are_points p -> no_edges_are_points q -> nowhere_negative p -> nowhere_negative q ->
  interiors_meet x p q -> (0 < winding_number x (convolution_segments p q))%Z.
Proof.
  intros p_edges q_edges p_valid q_valid (z & in_p & [free in_q]).
  destruct (some_small _ (eventually_and _ _ (general_position_beside p q x)
    (eventually_and _ _ (same_beside x (convolution_segments p q)) (eventually_and _ _
      (same_beside (minus x z) (region_edges q)) (shifted_off_all (minus x z) (region_edges q))))))
    as (e & _ & general & <- & same_2 & free_2).
  apply interiors_meet_in_general_position; trivial.
  exists z. split; [exact in_p |]. destruct (shifted_minus x z e) as [X Y]. split.
  - exact (off_equal _ _ _ (shifted_minus x z e) free_2).
  - rewrite <- (winding_number_of_equal _ _ _ X Y), same_2. exact in_q.
Qed.
