(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Where a vertex of a region touches an edge between its ends, the edge gets a vertex there, too: what the tests of
   validity ask for (test_of_regions.v). The points of the region stay the same. That the vertices added are in order
   along the edge is tested, not proved; an edge for which they were not would stay as it is. *)
From Coq Require Import QArith Lqa ZArith Lia Bool List Permutation.
From Oplus Require Import specification checker homogeneous_points specification_bridge balanced_edges convolution
  shifted_ray in_out_degree regions meeting_of_segments interiors_meet location pieces sum_program sum_is_right walks.
Import ListNotations.

Open Scope Q_scope.

Definition is_between_ends (v a b : vector) : bool :=
  is_on_segment v (Segment a b) && negb (same_point v a) && negb (same_point v b).

Fixpoint are_in_order (a b : vector) (l : list vector) : bool :=
  match l with [] => true | v :: rest => is_between_ends v a b && are_in_order v b rest end.

(* The vertices on an edge, its target excepted. *)
Definition vertices_along (vertices : list vector) (e : segment) : list vector :=
  let sorted := sorted_points (filter (fun v => is_between_ends v (source e) (target e)) vertices) in
  let inner := match compare_points (target e) (source e) with Lt => rev sorted | _ => sorted end in
  source e :: if are_in_order (source e) (target e) inner then inner else [].

Definition with_touching_vertices (r : region) : region :=
  let vertices := concat r in map (fun chain => flat_map (vertices_along vertices) (edges chain)) r.

(* A point between two others divides the segment. *)
Lemma is_between_ends_is (v a b : vector) : is_between_ends v a b = true -> exists k, 0 < k < 1 /\
  vx v == (1 - k) * vx a + k * vx b /\ vy v == (1 - k) * vy a + k * vy b.
Proof.
  unfold is_between_ends. destruct (is_on_spec v (Segment a b)) as [(k & range & X & Y) |]; [| discriminate].
  destruct (same_point_spec v a) as [| not_a], (same_point_spec v b) as [| not_b]; try discriminate. intros _.
  cbn [source target] in *. exists k. split; [| now split]. split; apply Qnot_le_lt; intros extreme.
  - apply not_a. assert (k_is : k == 0) by lra. rewrite k_is in X, Y. split; lra.
  - apply not_b. assert (k_is : k == 1) by lra. rewrite k_is in X, Y. split; lra.
Qed.

Lemma is_between_ends_iff (v a b : vector) : is_between_ends v a b = true <-> ~ equal_vectors a b /\
  exists k, 0 < k < 1 /\
  vx v == (1 - k) * vx a + k * vx b /\ vy v == (1 - k) * vy a + k * vy b.
Proof.
  split.
  - intros between_. destruct (is_between_ends_is v a b between_) as (k & range & X & Y). split; [| now exists k].
    intros [same_x same_y]. unfold is_between_ends in between_.
    destruct (same_point_spec v a) as [| differ]; [now rewrite andb_false_r in between_ |].
    apply differ. rewrite <- same_x in X. rewrite <- same_y in Y. split; lra.
  - intros (long & k & range & X & Y). unfold is_between_ends.
    destruct (is_on_spec v (Segment a b)) as [_ | off_]; [| exfalso; apply off_; exists k; split; [lra | now split]].
    destruct (same_point_spec v a) as [[x_is y_is] |], (same_point_spec v b) as [[x_is' y_is'] |]; try reflexivity;
      exfalso; apply long; rewrite X in *; rewrite Y in *.
    1, 2: split; apply (Qmult_inj_r _ _ k); lra.
    split; apply (Qmult_inj_r _ _ (1 - k)); lra.
Qed.

Lemma on_divided (v a b x : vector) : is_between_ends v a b = true ->
  lies_on x (Segment a b) <-> lies_on x (Segment a v) \/ lies_on x (Segment v b).
Proof.
  intros between_. destruct (is_between_ends_is v a b between_) as (k & [some less] & X & Y). split.
  - intros (j & [j0 j1] & jx & jy). cbn [source target] in *. destruct (Qlt_le_dec k j) as [after_ | before_].
    + right. exists ((j - k) / (1 - k)). cbn [source target].
      assert (value : (j - k) / (1 - k) * (1 - k) == j - k) by (field; lra).
      split; [split; [apply Qle_shift_div_l | apply Qle_shift_div_r]; lra |].
      set (h := (j - k) / (1 - k)) in *. clearbody h. assert (j_is : j == k + h * (1 - k)) by lra.
      rewrite jx, jy, X, Y, j_is. split; ring.
    + left. exists (j / k). cbn [source target]. assert (value : j / k * k == j) by (field; lra).
      split; [split; [apply Qle_shift_div_l | apply Qle_shift_div_r]; lra |].
      set (h := j / k) in *. clearbody h. rewrite jx, jy, X, Y, <- value. split; ring.
  - intros [(j & [j0 j1] & jx & jy) | (j & [j0 j1] & jx & jy)]; cbn [source target] in *.
    + exists (j * k). cbn [source target]. rewrite jx, jy, X, Y.
      assert (0 <= j * k) by (apply Qmult_le_0_compat; lra).
      assert (0 <= (1 - j) * k) by (apply Qmult_le_0_compat; lra). split; [lra |]. split; ring.
    + exists (k + j * (1 - k)). cbn [source target]. rewrite jx, jy, X, Y.
      assert (0 <= j * (1 - k)) by (apply Qmult_le_0_compat; lra).
      assert (0 <= (1 - j) * (1 - k)) by (apply Qmult_le_0_compat; lra). split; [lra |]. split; ring.
Qed.

Lemma orientation_same (a b c d x : vector) (k : Q) : 0 < k ->
  cross (minus b a) (minus x a) == k * cross (minus d c) (minus x c) -> orientation a b x = orientation c d x.
Proof.
  intros some multiple. rewrite !orientation_by_area. change (area (Segment a b) x == k * area (Segment c d) x) in
    multiple.
  rewrite multiple. set (u := area (Segment c d) x). clearbody u.
  destruct (Qcompare_spec u 0); [apply (proj1 (Qeq_alt _ _)) | apply (proj1 (Qlt_alt _ _)) | apply (proj1 (Qgt_alt _
    _))]; nra.
Qed.

Lemma crossing_divided (v a b x : vector) : is_between_ends v a b = true ->
  signed_crossing x (Segment a b) = (signed_crossing x (Segment a v) + signed_crossing x (Segment v b))%Z.
Proof.
  intros between_. destruct (is_between_ends_is v a b between_) as (k & [some less] & X & Y).
  unfold signed_crossing. cbn [source target].
  rewrite (orientation_same a v a b x k some), (orientation_same v b a b x (1 - k)).
  2: lra.
  2: unfold cross, minus; cbn [vx vy]; rewrite X, Y; ring.
  2: unfold cross, minus; cbn [vx vy]; rewrite X, Y; ring.
  assert (0 < k * (1 - k)) by (apply Qmult_lt_0_compat; lra).
  destruct (at_most_spec (vy a) (vy x)) as [a_low | a_high], (at_most_spec (vy b) (vy x)) as [b_low | b_high],
    (at_most_spec (vy v) (vy x)) as [v_low | v_high]; unfold ray_crossing; cbn [Bool.eqb];
    destruct (orientation a b x); try lia; exfalso; nra.
Qed.

(* The same points, and the same winding number, as seen from x. *)
Definition alike_from (x : vector) (l m : list segment) : Prop :=
  ((exists s, In s l /\ lies_on x s) <-> (exists s, In s m /\ lies_on x s)) /\
  winding_number x l = winding_number x m.

Section Alike.
  Variable x : vector.

  Lemma alike_transitive (l m n : list segment) : alike_from x l m -> alike_from x m n -> alike_from x l n.
  Proof. unfold alike_from. intros [on number_is] [on' number_is']. split; [tauto | congruence]. Qed.

  Lemma alike_permuted (l m : list segment) : Permutation l m -> alike_from x l m.
  Proof.
    intros permuted. split.
    - split; intros (s & S & on); exists s; (split; [| exact on]);
        [now apply (Permutation_in _ permuted) | now apply (Permutation_in _ (Permutation_sym permuted))].
    - unfold winding_number. apply sum_of_permutation. now apply Permutation_map.
  Qed.

  Lemma alike_together (l l' m m' : list segment) :
    alike_from x l l' -> alike_from x m m' -> alike_from x (l ++ m) (l' ++ m').
  Proof.
    intros [on_l number_l] [on_m number_m]. split.
    - assert (both : forall a b, (exists s, In s (a ++ b) /\ lies_on x s) <->
        (exists s, In s a /\ lies_on x s) \/ (exists s, In s b /\ lies_on x s)).
      { intros a b. split; [intros (s & S & on); apply in_app_iff in S; destruct S; [left | right]; now exists s |].
        intros [(s & S & on) | (s & S & on)]; exists s; rewrite in_app_iff; tauto. }
      rewrite !both. tauto.
    - unfold winding_number in *. rewrite !map_app, !sum_of_both. lia.
  Qed.

  Lemma alike_divided (v a b : vector) : is_between_ends v a b = true ->
    alike_from x [Segment a b] [Segment a v; Segment v b].
  Proof.
    intros between_. pose proof (on_divided v a b x between_) as parts. split.
    - split.
      + intros (s & [<- | []] & on). apply parts in on.
        destruct on; [exists (Segment a v) | exists (Segment v b)]; cbn; tauto.
      + intros (s & S & on). exists (Segment a b). split; [now left |]. apply parts.
        destruct S as [<- | [<- | []]]; tauto.
    - unfold winding_number, sum. cbn [map fold_right]. rewrite (crossing_divided v a b x between_). lia.
  Qed.

  (* A whole edge. *)
  Lemma divided_edge (b : vector) (l : list vector) : forall a, are_in_order a b l = true ->
    alike_from x (path (a :: l) b) [Segment a b].
  Proof.
    induction l as [| v l IH]; intros a order; [now apply alike_permuted |]. cbn [are_in_order] in order.
    apply andb_true_iff in order. destruct order as [between_ order].
    apply (alike_transitive _ ([Segment a v] ++ [Segment v b])).
    - apply (alike_together [Segment a v] [Segment a v]); [now apply alike_permuted | now apply IH].
    - destruct (alike_divided v a b between_) as [on number_is]. now split.
  Qed.
End Alike.

Lemma divided_path (vertices : list vector) (z : vector) (chain : list vector) :
  path (flat_map (vertices_along vertices) (path chain z)) z =
  flat_map (fun e => path (vertices_along vertices e) (target e)) (path chain z).
Proof.
  induction chain as [| a chain IH]; [reflexivity |]. cbn [path flat_map]. rewrite path_of_both, IH. f_equal. f_equal.
  destruct chain as [| b chain]; reflexivity.
Qed.

Definition divided (vertices : list vector) (e : segment) : list segment :=
  path (vertices_along vertices e) (target e).

Lemma edges_with_touching_vertices (r : region) :
  region_edges (with_touching_vertices r) = flat_map (divided (concat r)) (region_edges r).
Proof.
  unfold with_touching_vertices. generalize (concat r). intros vertices. unfold region_edges.
  induction r as [| chain r IH]; [reflexivity |]. cbn [map flat_map].
  rewrite IH, flat_map_app. f_equal. destruct chain as [| a chain]; [reflexivity |].
  rewrite (edges_are_a_path chain a). unfold divided. rewrite <- divided_path.
  cbn [path flat_map]. unfold vertices_along at 1. cbn [source app]. rewrite edges_are_a_path. reflexivity.
Qed.

Theorem divided_region (r : region) (x : vector) :
  alike_from x (region_edges (with_touching_vertices r)) (region_edges r).
Proof.
  rewrite edges_with_touching_vertices. generalize (concat r). intros vertices.
  induction (region_edges r) as [| e l IH]; [now apply alike_permuted |].
  apply (alike_together x (divided vertices e) [e] _ l); [| exact IH]. destruct e as [a b].
  unfold divided, vertices_along. cbn [source target]. destruct (are_in_order a b _) eqn:order; now apply divided_edge.
Qed.

(* Theorem. The points stay the same. *)
Theorem touching_vertices_add_no_points (r : polygonal_region) (x : point) :
  member x (map (map as_point) (with_touching_vertices (as_region r))) <-> member x r.
Proof.
  rewrite member_of_chains. destruct (divided_region (as_region r) (as_vector x)) as [same_points same_number].
  rewrite same_points, same_number. now rewrite (member_is x r), boundary_is.
Qed.

Definition prepared_region (r : polygonal_region) : polygonal_region :=
  map (map as_point) (with_touching_vertices (as_region r)).

(* Corollary. So a sum of such regions is the sum of the given ones. *)
Corollary sum_of_prepared_regions (p q s : polygonal_region) :
  is_minkowski_sum (prepared_region p) (prepared_region q) s -> is_minkowski_sum p q s.
Proof.
  intros is_sum x. rewrite (is_sum x). unfold prepared_region.
  split; intros (a & b & in_p & in_q & equal); exists a, b; rewrite !touching_vertices_add_no_points in *; tauto.
Qed.
