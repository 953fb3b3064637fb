(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Paths inside a polygon of one chain, and sums of paths (Observation 3.2.6). From a point inside, one goes straight on
   until one meets the chain, and along the chain to all of its points: so the closed polygon is connected. Say a is a
   point of P and b one inside Q: then a + b is an inner point of the sum, and so is all of a path of a in P, moved by
   b. So all sums of a point inside P and one inside Q are connected in the interior of the sum, which is connected, as
   each of its points has such a sum close to it. *)
From Coq Require Import QArith Lqa ZArith Lia Bool List.
From Oplus Require Import regions_and_sums connected_sets connected_beside_pieces first_edge_of_a_ray theorem_2_2_10
  inside_a_corner boundary_points lemma_2_2_2 theorem_2_3_2 fiber_grid specification_bridge coordinates.
Import ListNotations.

Open Scope Q_scope.

Section Chain.
  Variable chain : list vector.
  Let r : region := [chain].
  Let in_it := fun z => in_region z r.

  Lemma path_to_the_chain (a : vector) : inside a r ->
    exists y, (exists s, In s (region_edges r) /\ lies_on y s) /\ connected_in in_it a y.
  Proof.
    intros [free round].
    destruct (ray_to_a_segment (region_edges r) (region_edges r) a free (incl_refl _) ltac:(lia))
      as (u & k & avoided & K & on_k).
    destruct (ray_meets_one_first a u (region_edges r) k 1 free avoided K ltac:(lra) on_k)
      as (s & first & part & S & some & p0 & p1 & _ & equal & only).
    set (y := moved_along a u first) in *. exists y.
    assert (on_y : lies_on y s).
    { apply (lies_on_equal (inside_segment s part)); [now symmetry |]. exists part. split; [lra |].
      unfold inside_segment. cbn [vx vy]. split; ring. }
    split; [now exists s |]. apply connected_by_a_step. intros z on.
    destruct (on_or_off z (region_edges r)) as [(t & T & on_t) | free_z]; [right; now exists t | left].
    enough (free_way : forall v, lies_on v (Segment a z) -> off v (region_edges r)).
    { pose proof (winding_number_along (Segment a z) _ (region_cycles r) free_way) as same_number.
      cbn [source target] in same_number. lia. }
    intros v on_v t T on_t. assert (on_way : lies_on v (Segment a y)).
    { destruct on as (h & range & X & Y), on_v as (g & range' & X' & Y'). cbn [source target] in *.
      exists (g * h). cbn [source target]. split; [split; nra |]. rewrite X', Y', X, Y. split; ring. }
    pose proof (only t v T on_way on_t) as at_y.
    (* then z is y, too *)
    apply (free_z s S). apply (lies_on_equal y); [| exact on_y].
    assert (moves : nonzero u).
    { intros [X Y]. apply (free s S). apply (lies_on_equal y); [| exact on_y].
      unfold y, moved_along. split; cbn [vx vy]; rewrite ?X, ?Y; ring. }
    destruct on as (h & range & X & Y), on_v as (g & range' & X' & Y'). destruct at_y as [X'' Y''].
    cbn [source target] in *. unfold y, moved_along in *. cbn [vx vy] in *.
    assert (full : g * h == 1).
    { destruct (Qeq_dec (vx u) 0) as [flat | some_x].
      - assert (some_y : ~ vy u == 0) by (intros none; apply moves; now split).
        apply (Qmult_inj_r _ _ (first * vy u));
          [intros none; destruct (Qmult_integral _ _ none); [lra | contradiction] |].
        rewrite Y in Y'. rewrite Y' in Y''. lra.
      - apply (Qmult_inj_r _ _ (first * vx u));
          [intros none; destruct (Qmult_integral _ _ none); [lra | contradiction] |].
        rewrite X in X'. rewrite X' in X''. lra. }
    assert (h_is : h == 1) by nra. rewrite h_is in X, Y. split; cbn [vx vy]; lra.
  Qed.

  Lemma along_an_edge (i : nat) (v w : vector) : (i < length chain)%nat -> lies_on v (edge_at chain i) ->
    lies_on w (edge_at chain i) -> connected_in in_it v w.
  Proof.
    intros I on_v on_w. apply connected_by_a_step. intros z on. right. exists (edge_at chain i).
    split; [apply edge_at_in_region; [now left | exact I] |]. exact (common_part _ v w z on_v on_w on).
  Qed.

  Lemma back_to_the_first_vertex (i : nat) : (i < length chain)%nat ->
    connected_in in_it (nth i chain nowhere) (nth 0 chain nowhere).
  Proof.
    induction i as [| i IH]; intros I.
    - apply (along_an_edge 0); trivial; rewrite edge_at_is by exact I; apply (source_lies_on (Segment _ _)).
    - apply (connected_on _ _ (nth i chain nowhere)); [| apply IH; lia].
      apply (along_an_edge i); [lia | |]; rewrite edge_at_is by lia.
      + assert (is_next : next i (length chain) = S i)
          by (unfold next; destruct (Nat.eqb_spec (S i) (length chain)); [lia | reflexivity]).
        rewrite is_next. apply (target_lies_on (Segment _ _)).
      + apply (source_lies_on (Segment _ _)).
  Qed.

  (* Theorem. A polygon of one chain is connected. *)
  Theorem polygon_is_connected (a b : vector) : in_region a r -> in_region b r -> connected_in in_it a b.
  Proof.
    assert (to_first : forall c, in_region c r -> connected_in in_it c (nth 0 chain nowhere)).
    { assert (from_edge : forall c s, In s (region_edges r) -> lies_on c s ->
        connected_in in_it c (nth 0 chain nowhere)).
      { intros c s S on. destruct (edge_by_chain r s S) as (chain' & i & [<- | []] & I & ->).
        apply (connected_on _ _ (nth i chain nowhere)); [| now apply back_to_the_first_vertex].
        apply (along_an_edge i); trivial. rewrite edge_at_is by exact I. apply (source_lies_on (Segment _ _)). }
      intros c in_c. destruct (on_or_off c (region_edges r)) as [(s & S & on) | free]; [now apply (from_edge c s) |].
      destruct in_c as [round | (s & S & on)]; [| destruct (free s S on)].
      destruct (path_to_the_chain c (conj free round)) as (y & (s & S & on) & way).
      exact (connected_on _ _ _ _ way (from_edge y s S on)). }
    intros A B. exact (connected_on _ _ _ _ (to_first a A) (connected_back _ _ _ (to_first b B))).
  Qed.
End Chain.

(* A path moved by b. *)
Lemma path_moved (A B : vector -> Prop) (b : vector) : (forall y z, equal_vectors y z -> B y -> B z) ->
  (forall z, A z -> B (plus z b)) -> forall a c, connected_in A a c -> connected_in B (plus a b) (plus c b).
Proof.
  intros same_ moves a c (path & walk). exists (map (fun v => plus v b) path). revert a walk.
  assert (step : forall a c, (forall z, lies_on z (Segment a c) -> A z) ->
    forall z, lies_on z (Segment (plus a b) (plus c b)) -> B z).
  { intros a' c' all z (k & range & X & Y). apply (same_ (plus (minus z b) b)).
    - unfold plus, minus. split; cbn [vx vy]; ring.
    - apply moves, all. exists k. unfold plus, minus in *. cbn [source target vx vy] in *.
      split; [exact range |]. split; lra. }
  induction path as [| d rest IH]; intros a walk; cbn [map leads_through] in *; [exact (step a c walk) |].
  destruct walk as [first_ walk]. split; [exact (step a d first_) | now apply IH].
Qed.

Section Sum.
  Variables p q : list vector.
  Let P : region := [p].
  Let Q_ : region := [q].
  Hypothesis p_region : valid_region P.
  Hypothesis q_region : valid_region Q_.

  Let inner := fun z => inner_point_of_sum z P Q_.

  Lemma point_and_inner_point (a b : vector) (k l : region) : in_region a k -> inside b l ->
    inner_point_of_sum (plus a b) k l.
  Proof. intros in_k in_l. now apply inner_other_way, (inner_plus_point l k b a), sum_in_other_order. Qed.

  (* Theorem. The interior of the sum is connected. *)
  Theorem interior_of_the_sum_is_connected (y z : vector) : inner y -> inner z -> connected_in inner y z.
  Proof.
    assert (same_ : forall v w, equal_vectors v w -> inner v -> inner w)
      by (intros v w; now apply inner_point_equal).
    assert (close_sum : forall v, inner v -> exists a b, inside a P /\ inside b Q_ /\ connected_in inner v (plus a b)).
    { intros v (radius & R & near).
      destruct (interiors_meet_near P Q_ v ((1 # 2) * radius)) as (w & close & a & in_p & in_q);
        [now apply valid_is_regular | now apply valid_is_regular | apply near; unfold within; lra | lra |].
      exists a, (minus w a). split; [exact in_p |]. split; [exact in_q |]. apply connected_by_a_step.
      intros u on. exists ((1 # 2) * radius). split; [lra |]. intros x close_x. apply near.
      assert (close_u : within ((1 # 2) * radius) v u).
      { destruct on as (k & range & X & Y). unfold within, plus, minus in *. cbn [source target vx vy] in *.
        rewrite X, Y. split; split; nra. }
      unfold within in *. lra. }
    intros inner_y inner_z. destruct (close_sum y inner_y) as (a & b & in_p & in_q & way).
    destruct (close_sum z inner_z) as (a' & b' & in_p' & in_q' & way').
    assert (closed : forall v r, inside v r -> in_region v r) by (intros v r [_ round]; now left).
    apply (connected_on _ _ _ _ way), (connected_on _ _ (plus a' b)); [| apply (connected_on _ _ (plus a' b'))].
    - apply (path_moved (fun v => in_region v P)); [exact same_ | |].
      + intros v in_v. now apply point_and_inner_point.
      + apply polygon_is_connected; now apply closed.
    - assert (other_order : forall v w, equal_vectors (plus v w) (plus w v))
        by (intros; unfold plus; split; cbn [vx vy]; ring).
      assert (turned : connected_in inner (plus b a') (plus b' a')).
      { apply (path_moved (fun v => in_region v Q_)); [exact same_ | |].
        - intros v in_v. apply inner_other_way. now apply point_and_inner_point.
        - apply polygon_is_connected; now apply closed. }
      apply (connected_on _ _ (plus b a')); [| apply (connected_on _ _ _ _ turned)]; apply connected_by_a_step;
        intros v (k & range & X & Y); [apply (same_ (plus a' b)) | apply (same_ (plus a' b'))];
        try (now apply point_and_inner_point; [apply closed |]);
        unfold plus in *; cbn [source target vx vy] in *; split; cbn [vx vy]; rewrite ?X, ?Y; ring.
    - now apply connected_back.
  Qed.

  (* Theorem. And so is the sum. *)
  Theorem sum_is_connected (y z : vector) : in_sum y P Q_ -> in_sum z P Q_ ->
    connected_in (fun v => in_sum v P Q_) y z.
  Proof.
    assert (same_ : forall v w, equal_vectors v w -> in_sum v P Q_ -> in_sum w P Q_).
    { intros v w [X Y] (a & b & A & B & [X' Y']). exists a, b. split; [exact A |]. split; [exact B |]. split; lra. }
    assert (a_step : forall v w, equal_vectors v w -> in_sum v P Q_ -> connected_in (fun v => in_sum v P Q_) v w).
    { intros v w [X Y] in_v. apply connected_by_a_step. intros u (k & _ & UX & UY). apply (same_ v); [| exact in_v].
      cbn [source target] in *. split; rewrite ?UX, ?UY; [rewrite <- X | rewrite <- Y]; ring. }
    intros (a & b & A & B & equal) (a' & b' & A' & B' & equal').
    assert (is_sum : forall c d, in_region c P -> in_region d Q_ -> in_sum (plus c d) P Q_)
      by (intros c d C D; exists c, d; split; [exact C |]; split; [exact D | reflexivity]).
    apply (connected_on _ _ (plus a b)); [apply a_step; [exact equal | now exists a, b] |].
    apply (connected_on _ _ (plus a' b)).
    - apply (path_moved (fun v => in_region v P)); [exact same_ | intros v in_v; now apply is_sum |].
      now apply polygon_is_connected.
    - apply (connected_on _ _ (plus b a')).
      { apply a_step; [unfold plus; split; cbn [vx vy]; ring | now apply is_sum]. }
      apply (connected_on _ _ (plus b' a')).
      + apply (path_moved (fun v => in_region v Q_)); [exact same_ | | now apply polygon_is_connected].
        intros v in_v. apply (same_ (plus a' v)); [unfold plus; split; cbn [vx vy]; ring | now apply is_sum].
      + apply connected_back, a_step; [| exists a', b'; split; [exact A' |]; split; [exact B' | exact equal']].
        destruct equal' as [X Y]. unfold plus in *. cbn [vx vy] in *. split; cbn [vx vy]; lra.
  Qed.
End Sum.
