(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Union, intersection and difference of valid regions, by one rule each over the winding numbers of both. *)
From Coq Require Import QArith Lqa ZArith Lia Bool List.
From Oplus Require Import specification regions_and_sums specification_bridge filling rule_of_sides region_of_pieces
  sum_program sum_is_right regions_by_rule.
Import ListNotations.

Open Scope Q_scope.

Definition some_positive (numbers : list Z) : bool := existsb (Z.ltb 0) numbers.
Definition all_positive (numbers : list Z) : bool := forallb (Z.ltb 0) numbers.
Definition first_positive (numbers : list Z) : bool :=
  match numbers with [] => false | first :: others => (0 <? first)%Z && negb (some_positive others) end.

Definition of_two (rule : list Z -> bool) (p q : polygonal_region) : polygonal_region :=
  region_by_rule rule [region_edges (as_region p); region_edges (as_region q)].

Definition union : polygonal_region -> polygonal_region -> polygonal_region := of_two some_positive.
Definition intersection_of_regions : polygonal_region -> polygonal_region -> polygonal_region := of_two all_positive.
Definition difference : polygonal_region -> polygonal_region -> polygonal_region := of_two first_positive.

Section TwoRegions.
  Variables p q : polygonal_region.
  Hypothesis p_valid : valid_region (as_region p).
  Hypothesis q_valid : valid_region (as_region q).
  Let families := [region_edges (as_region p); region_edges (as_region q)].

  Lemma two_are_closed (l : list segment) : In l families -> cycles l.
  Proof. intros [<- | [<- | []]]; apply region_cycles. Qed.

  Lemma two_are_long (t : segment) : In t (concat families) -> nonzero (along t).
  Proof.
    destruct p_valid as (p_edges & _), q_valid as (q_edges & _). intros T. apply in_concat in T.
    destruct T as (l & [<- | [<- | []]] & T).
    - exact (region_edges_are_directions _ p_edges t T).
    - exact (region_edges_are_directions _ q_edges t T).
  Qed.

  Lemma off_both (y : point) : off (as_vector y) (concat families) ->
    (member y p <-> (0 <? winding_number (as_vector y) (region_edges (as_region p)))%Z = true) /\
    (member y q <-> (0 <? winding_number (as_vector y) (region_edges (as_region q)))%Z = true).
  Proof.
    intros free. split; (apply member_off_edges; [assumption |]); intros s S; apply free, in_concat;
      [exists (region_edges (as_region p)) | exists (region_edges (as_region q))]; split; trivial; cbn; tauto.
  Qed.

  (* Theorem. *)
  Theorem union_is_the_union : is_union p q (union p q).
  Proof.
    intros x. apply (members_of_a_closed_set some_positive families two_are_closed two_are_long eq_refl
      (fun y => member y p \/ member y q)).
    - intros y free. destruct (off_both y free) as [-> ->]. unfold by_rule, some_positive, families. cbn [map existsb].
      rewrite orb_false_r, orb_true_iff. tauto.
    - intros y t T on. apply in_concat in T. destruct T as (l & [<- | [<- | []]] & T); [left | right];
        (apply member_of_region; [assumption |]; right; now exists t).
    - assert (regular : forall r y, valid_region (as_region r) -> (forall z, member z r -> member z p \/ member z q) ->
        member y r -> closure (interior (fun y => member y p \/ member y q)) y).
      { intros r y r_valid part in_r radius R. apply member_of_region in in_r; [| exact r_valid].
        pose proof r_valid as (r_edges & r_numbers & r_meet).
        destruct (inside_near _ _ radius (regions_are_regular _ r_edges r_numbers r_meet) in_r R) as (z & close & free
          & some).
        exists (as_point z). split; [exact close |].
        destruct (winding_number_near z _ (region_cycles _) free) as (inner & I & near). exists inner. split;
          [exact I |].
        intros b close_b. apply part, member_of_region; [exact r_valid |]. left.
        destruct (near (as_vector b)) as [_ ->]; [exact close_b | exact some]. }
      intros y [in_p | in_q]; [apply (regular p) | apply (regular q)]; tauto.
  Qed.

  (* Theorem. *)
  Theorem intersection_is_the_intersection : is_intersection p q (intersection_of_regions p q).
  Proof.
    intros x. apply (members_by_rule all_positive families two_are_closed two_are_long eq_refl).
    intros y free. destruct (off_both y free) as [-> ->]. unfold by_rule, all_positive, families. cbn [map forallb].
    rewrite andb_true_r, andb_true_iff. tauto.
  Qed.

  (* Theorem. *)
  Theorem difference_is_the_difference : is_difference p q (difference p q).
  Proof.
    intros x. apply (members_by_rule first_positive families two_are_closed two_are_long eq_refl).
    intros y free. destruct (off_both y free) as [-> ->]. unfold by_rule, first_positive, some_positive, families.
    cbn [map existsb]. rewrite orb_false_r, andb_true_iff, negb_true_iff, not_true_iff_false. tauto.
  Qed.
End TwoRegions.
