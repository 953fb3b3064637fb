(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* What the checker's count of edges (are_balanced of checker.v) means: the edges of the region, split at the inserted
   points, and the sides of the pieces are the same edges, but for diagonals that pieces have in both directions. So a
   sum over the edges of the region is a sum over the sides of the pieces, if the terms of an edge and its reverse
   cancel, and those of the parts of an edge add up; and every point of an edge is on a side of a piece. *)
From Coq Require Import QArith Lqa ZArith Lia Bool List Permutation.
From Oplus Require Import convolution angular_crossings specification checker signed_crossings homogeneous_points
  specification_bridge neighbourhoods.
Import ListNotations.

Open Scope Z_scope.

Lemma sum_over_lists {A B} (f : B -> Z) (g : A -> list B) (l : list A) :
  sum (map f (flat_map g l)) = sum (map (fun a => sum (map f (g a))) l).
Proof. induction l as [| a l IH]; [reflexivity |]. cbn [flat_map map]. now rewrite map_app, sum_of_both, IH. Qed.

Lemma sum_of_permutation (l m : list Z) : Permutation l m -> sum l = sum m.
Proof. unfold sum. intros permuted. induction permuted; cbn; lia. Qed.

(* Entries of the same edge, in whatever direction. *)
Definition of_one_edge (e f : entry) : Prop := low e = low f /\ high e = high f.

Lemma same_ends (e f : entry) :
  same_hpoint (low e) (low f) && same_hpoint (high e) (high f) = true -> of_one_edge e f.
Proof. rewrite andb_true_iff. intros [low_ high_]. split; now apply same_is_equal. Qed.

Lemma entry_is (region : bool) (e : hedge) :
  of_region (entry_of region e) = region /\
  ((forward (entry_of region e) = true /\ low (entry_of region e) = fst e /\ high (entry_of region e) = snd e) \/
   (forward (entry_of region e) = false /\ low (entry_of region e) = snd e /\ high (entry_of region e) = fst e)).
Proof. unfold entry_of. destruct (compare_hpoints (fst e) (snd e)); cbn; tauto. Qed.

Section Sums.
  Variable f : hedge -> Z.
  Hypothesis reverse_cancels : forall a b, f (b, a) = - f (a, b).

  Definition weight_of_entry (e : entry) : Z := count_of_entry e * f (low e, high e).

  Lemma weight_is (region : bool) (e : hedge) : weight_of_entry (entry_of region e) = if region then - f e else f e.
  Proof.
    unfold weight_of_entry, count_of_entry. destruct (entry_is region e) as [-> [(-> & -> & ->) | (-> & -> & ->)]];
      destruct e as [a b]; cbn [fst snd].
    - destruct region; cbn [Bool.eqb]; lia.
    - rewrite (reverse_cancels a b). destruct region; cbn [Bool.eqb]; lia.
  Qed.

  Lemma balanced_entries_cancel (rest : list entry) : forall e count in_region in_piece,
    are_balanced e count in_region in_piece rest = true -> count * f (low e, high e) + sum (map weight_of_entry rest) = 0.
  Proof.
    induction rest as [| g rest IH]; intros e count in_region in_piece; cbn [are_balanced].
    - rewrite andb_true_iff, Z.eqb_eq. intros [-> _]. cbn. lia.
    - destruct (same_hpoint (low e) (low g) && same_hpoint (high e) (high g)) eqn:one_edge.
      + apply same_ends in one_edge as [low_is high_is]. intros balanced. apply IH in balanced.
        cbn [map]. unfold sum in *. cbn [fold_right]. unfold weight_of_entry at 1. rewrite <- low_is, <- high_is. lia.
      + rewrite !andb_true_iff, Z.eqb_eq. intros [[-> _] balanced]. apply IH in balanced.
        cbn [map]. unfold sum in *. cbn [fold_right]. unfold weight_of_entry at 1. lia.
  Qed.
End Sums.

Lemma region_edges_are_in_pieces (rest : list entry) : forall e count in_region in_piece,
  are_balanced e count in_region in_piece rest = true ->
  (in_region = true -> in_piece = true \/ exists g, In g rest /\ of_region g = false /\ of_one_edge e g) /\
  forall h, In h rest -> of_region h = true ->
    (in_piece = true /\ of_one_edge h e) \/ exists g, In g rest /\ of_region g = false /\ of_one_edge h g.
Proof.
  induction rest as [| g rest IH]; intros e count in_region in_piece; cbn [are_balanced].
  - rewrite andb_true_iff. intros [_ flags]. split; [| intros h []]. intros ->. left. exact flags.
  - destruct (same_hpoint (low e) (low g) && same_hpoint (high e) (high g)) eqn:one_edge.
    + apply same_ends in one_edge. intros balanced. apply IH in balanced as [of_e of_rest].
      destruct (of_region g) eqn:kind; cbn [negb] in *.
      * rewrite orb_true_r, orb_false_r in *. specialize (of_e eq_refl). split.
        { intros _. destruct of_e as [there | (k & k_in & k_kind & k_edge)]; [now left |]. right. exists k. cbn [In].
          tauto. }
        intros h [<- | h_in] h_kind.
        { unfold of_one_edge in *. destruct of_e as [there | (k & k_in & k_kind & k_edge)].
          - left. intuition congruence.
          - right. exists k. cbn [In]. intuition congruence. }
        destruct (of_rest h h_in h_kind) as [there | (k & k_in & k_kind & k_edge)]; [now left |].
        right. exists k. cbn [In]. tauto.
      * rewrite orb_true_r in *. split; [intros _; right; exists g; cbn [In]; tauto |].
        intros h [<- | h_in] h_kind; [congruence |].
        destruct (of_rest h h_in h_kind) as [[_ edge_] | (k & k_in & k_kind & k_edge)]; right.
        { exists g. unfold of_one_edge in *. cbn [In]. intuition congruence. }
        exists k. cbn [In]. tauto.
    + rewrite !andb_true_iff. intros [[_ flags] balanced]. apply IH in balanced as [of_g of_rest]. split.
      { intros ->. left. exact flags. }
      intros h [<- | h_in] h_kind.
      { rewrite h_kind in *. cbn [negb] in *. destruct (of_g eq_refl) as [| (k & k_in & k_kind & k_edge)];
          [discriminate |].
        right. exists k. cbn [In]. tauto. }
      destruct (of_rest h h_in h_kind) as [[kind edge_] | (k & k_in & k_kind & k_edge)]; right.
      { exists g. cbn [In]. apply negb_true_iff in kind. tauto. }
      exists k. cbn [In]. tauto.
Qed.

(* m is on the segment from a to b. *)
Lemma is_between_lies_on (a m b : hpoint) : is_between a m b = true ->
  lies_on (vector_of m) (Segment (vector_of a) (vector_of b)).
Proof.
  unfold is_between. rewrite !andb_true_iff, !orb_true_iff, !andb_true_iff, !Z.leb_le, Z.eqb_eq.
  intros [[line x_between] y_between].
  assert (order_ : forall s t : Z, forall c d, (s * Zpos d <= t * Zpos c)%Z <-> (s # c <= t # d)%Q) by reflexivity.
  rewrite !order_ in x_between, y_between.
  apply Z.compare_eq_iff in line. rewrite left_turn_compare in line. apply equal_comparison in line.
  change (px a # pw a) with (vx (vector_of a)) in *. change (py a # pw a) with (vy (vector_of a)) in *.
  change (px b # pw b) with (vx (vector_of b)) in *. change (py b # pw b) with (vy (vector_of b)) in *.
  change (px m # pw m) with (vx (vector_of m)) in *. change (py m # pw m) with (vy (vector_of m)) in *.
  apply lies_on_by_signs. unfold turn_of, cross, dot, winding_number.minus in *.
  cbn [source target vx vy] in *.
  split; [lra |].
  assert (opposite : forall s t z : Q, ((s <= z /\ z <= t) \/ (t <= z /\ z <= s) -> (s - z) * (t - z) <= 0)%Q)
    by (intros; nra).
  pose proof (opposite _ _ _ x_between). pose proof (opposite _ _ _ y_between). lra.
Qed.

(* A point of an edge is on one of its parts. *)
Lemma lies_on_a_part (inserted : list hpoint) : forall a b x, is_split a b inserted = true ->
  lies_on x (segment_of_hedge (a, b)) -> exists s, In s (split_edge a b inserted) /\ lies_on x (segment_of_hedge s).
Proof.
  induction inserted as [| m rest IH]; intros a b x; cbn [is_split split_edge].
  - intros _ on. exists (a, b). cbn. tauto.
  - rewrite andb_true_iff. intros [between_ split_] on. apply is_between_lies_on in between_.
    enough (lies_on x (segment_of_hedge (a, m)) \/ lies_on x (segment_of_hedge (m, b))) as [first | second].
    + exists (a, m). cbn. tauto.
    + destruct (IH m b x split_ second) as (s & s_in & s_on). exists s. cbn. tauto.
    + unfold segment_of_hedge in *. cbn [fst snd] in *. revert between_ on.
      generalize (vector_of a) (vector_of m) (vector_of b). clear.
      intros a m b (t & t_range & m_x & m_y) (s & s_range & x_x & x_y). unfold lies_on. cbn [source target] in *.
      destruct (Qlt_le_dec t s) as [beyond | within].
      * right. exists ((s - t) / (1 - t))%Q.
        assert (ratio : ((s - t) / (1 - t) * (1 - t) == s - t)%Q) by (field; lra).
        set (k := ((s - t) / (1 - t))%Q) in *.
        assert (0 <= k)%Q by (apply Qle_shift_div_l; lra). assert (k <= 1)%Q by (apply Qle_shift_div_r; lra).
        clearbody k. repeat split; [assumption .. | |]; rewrite ?m_x, ?m_y, ?x_x, ?x_y; nra.
      * left. destruct (Q_dec t 0) as [[low | some] | none]; [lra | |].
        { exists (s / t)%Q. assert (ratio : (s / t * t == s)%Q) by (field; lra). set (k := (s / t)%Q) in *.
          assert (0 <= k)%Q by (apply Qle_shift_div_l; lra). assert (k <= 1)%Q by (apply Qle_shift_div_r; lra).
          clearbody k. repeat split; [assumption .. | |]; rewrite ?m_x, ?m_y, ?x_x, ?x_y; nra. }
        exists 0%Q. assert (s_is : (s == 0)%Q) by lra. rewrite s_is in *. repeat split; lra.
Qed.

Lemma with_inserted_has_the_edges (es : list hedge) : forall inserted, map fst (with_inserted es inserted) = es.
Proof. induction es as [| e es IH]; intros [| points inserted]; cbn; [reflexivity .. | |]; now rewrite IH. Qed.

Definition sides_of_pieces (pieces : list piece) : list hedge := flat_map (fun t => sides (corners_of t)) pieces.

Section Accepted.
  Variables (es : list hedge) (inserted : list (list hpoint)) (pieces : list piece).
  Hypothesis accepted : are_a_region es inserted pieces = true.

  Let split := with_inserted es inserted.
  Let parts := flat_map (fun s => split_edge (fst (fst s)) (snd (fst s)) (snd s)) split.
  Let entries := map (entry_of true) parts ++ map (entry_of false) (sides_of_pieces pieces).

  Lemma pieces_are_convex (t : piece) : In t pieces -> is_convex t = true.
  Proof. unfold are_a_region in accepted. rewrite !andb_true_iff, !forallb_forall in accepted. now apply accepted. Qed.

  Lemma edges_are_split (s : hedge * list hpoint) : In s split -> is_split (fst (fst s)) (snd (fst s)) (snd s) = true.
  Proof. unfold are_a_region in accepted. rewrite !andb_true_iff, !forallb_forall in accepted. now apply accepted. Qed.

  Lemma entries_are_balanced :
    exists sorted, Permutation entries sorted /\
      match sorted with
      | [] => True
      | e :: rest => are_balanced e (count_of_entry e) (of_region e) (negb (of_region e)) rest = true
      end.
  Proof.
    unfold are_a_region in accepted. rewrite !andb_true_iff in accepted. destruct accepted as [_ balanced].
    exists (Sorted.sort entries). split; [apply Sorted.Permuted_sort |].
    unfold entries, parts, split, sides_of_pieces. now destruct (Sorted.sort _).
  Qed.

  Theorem sum_over_pieces (f : hedge -> Z) :
    (forall a b, f (b, a) = - f (a, b)) ->
    (forall a m b, is_between a m b = true -> f (a, b) = f (a, m) + f (m, b)) ->
    sum (map f es) = sum (map (fun t => sum (map f (sides (corners_of t)))) pieces).
  Proof.
    intros cancels adds_up.
    assert (all_entries : sum (map (weight_of_entry f) entries) = 0).
    { destruct entries_are_balanced as (sorted & permuted & balanced).
      rewrite (sum_of_permutation _ _ (Permutation_map (weight_of_entry f) permuted)).
      destruct sorted as [| e rest]; [reflexivity |]. now apply balanced_entries_cancel with (f := f) in balanced. }
    assert (all_parts : sum (map f parts) = sum (map f es)).
    { unfold parts. rewrite sum_over_lists. rewrite <- (with_inserted_has_the_edges es inserted) at 1. fold split.
      rewrite map_map. f_equal. apply map_ext_in. intros s s_in. apply edges_are_split in s_in.
      destruct s as [[a b] points].
      cbn [fst snd] in *. revert a s_in. induction points as [| m rest IH]; intros a; cbn [is_split split_edge map];
        [cbn; lia |].
      rewrite andb_true_iff. intros [between_ more]. rewrite (adds_up a m b between_). unfold sum in *.
      cbn [fold_right].
      now rewrite IH. }
    unfold entries in all_entries. rewrite map_app, sum_of_both, !map_map in all_entries.
    rewrite (map_ext _ _ (weight_is f cancels true)), (map_ext _ _ (weight_is f cancels false)) in all_entries.
    cbn in all_entries. rewrite <- all_parts. unfold sides_of_pieces in all_entries. rewrite <- sum_over_lists.
    assert (negated_ : sum (map (fun e => - f e) parts) = - sum (map f parts)).
    { generalize parts. intros l. unfold sum. induction l as [| e l IH]; cbn; lia. }
    lia.
  Qed.

  Theorem edges_are_on_sides (e : hedge) (x : vector) : In e es -> lies_on x (segment_of_hedge e) ->
    exists t s, In t pieces /\ In s (sides (corners_of t)) /\ lies_on x (segment_of_hedge s).
  Proof.
    intros e_in on. rewrite <- (with_inserted_has_the_edges es inserted) in e_in.
    apply in_map_iff in e_in as (s & s_is & s_in).
    fold split in s_in. pose proof (edges_are_split s s_in) as split_. destruct s as [[a b] points].
    cbn [fst snd] in *. subst e.
    destruct (lies_on_a_part points a b x split_ on) as (part & part_in & part_on).
    assert (there : In (entry_of true part) entries).
    { unfold entries. apply in_or_app. left. apply in_map. unfold parts. apply in_flat_map.
      now exists ((a, b), points). }
    destruct entries_are_balanced as (sorted & permuted & balanced).
    pose proof (Permutation_in _ permuted there) as in_sorted.
    assert (exists g, In g sorted /\ of_region g = false /\ of_one_edge (entry_of true part) g)
      as (g & g_in & g_kind & one_edge).
    { destruct sorted as [| first rest]; [easy |]. apply region_edges_are_in_pieces in balanced as [of_first of_rest].
      destruct (entry_is true part) as [kind _]. destruct in_sorted as [first_is | in_rest]; [subst first |].
      - destruct (of_first kind) as [none | (g & g_in & g_kind & g_edge)]; [now rewrite kind in none |].
        exists g. cbn [In]. tauto.
      - destruct (of_rest _ in_rest kind) as [[none edge_] | (g & g_in & g_kind & g_edge)].
        + exists first. cbn [In]. apply negb_true_iff in none. tauto.
        + exists g. cbn [In]. tauto. }
    apply (Permutation_in _ (Permutation_sym permuted)) in g_in. unfold entries in g_in.
    apply in_app_or in g_in as [g_in | g_in].
    { apply in_map_iff in g_in as (k & <- & _). destruct (entry_is true k). congruence. }
    apply in_map_iff in g_in as (k & <- & k_in). unfold sides_of_pieces in k_in.
    apply in_flat_map in k_in as (t & t_in & k_in).
    exists t, k. split; [exact t_in |]. split; [exact k_in |].
    destruct one_edge as [low_is high_is].
    destruct (entry_is true part) as [_ part_is], (entry_is false k) as [_ k_is]. destruct part as [u v], k as [y z].
    cbn [fst snd] in *.
    assert (either : (y = u /\ z = v) \/ (y = v /\ z = u)).
    { destruct part_is as [(_ & p1 & p2) | (_ & p1 & p2)], k_is as [(_ & k1 & k2) | (_ & k1 & k2)];
        [left | right | right | left]; split; congruence. }
    destruct either as [[-> ->] | [-> ->]]; [exact part_on |].
    destruct part_on as (r & range & x_x & x_y). exists (1 - r)%Q. cbn [source target segment_of_hedge fst snd] in *.
    split; [lra |]. rewrite x_x, x_y. split; ring.
  Qed.
End Accepted.
