(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Observation 3.1.4 as printed: the loops of the boundary of the sum are nested by turns. An external loop runs
   counterclockwise, so that the sum is inside it, a hole clockwise. One loop encloses another if it goes round all
   points of that which are not its own; directly, if no third is between them. The loops are those that walks along the
   boundary trace, with the largest clockwise turns (printed_lemma_3_1_2.v). Proof: beside a loop the winding numbers of
   all loops add up to 0 on its right and 1 on its left (order_of_nesting.v). *)
From Coq Require Import QArith ZArith Bool List.
From Oplus Require Import convolution convolution_winding theorem_4_2_1 simple_chain simple_chains_turn_once
  valid_components reduced_convolution meeting_of_segments regions theorem_2_2_10 order_of_nesting nested_chains
  polygons nested_polygons printed_lemma_3_1_2 loops_of_the_boundary.
Import ListNotations.

Open Scope Q_scope.

Definition encloses (a b : list vector) : Prop :=
  a <> b /\ forall x, on_one_of x (edges b) -> off x (edges a) -> winding_number x (edges a) <> 0%Z.

Definition directly_encloses (loops : list (list vector)) (a b : list vector) : Prop :=
  encloses a b /\ forall c, In c loops -> encloses a c -> ~ encloses c b.

(* Loops that do not cross, and with numbers of all of them 0 and 1. *)
Section Loops.
  Variable loops : list (list vector).
  Hypothesis apart_ : do_not_cross loops.

  Let distinct_ := proj1 apart_.
  Let are_simple := proj1 (proj2 apart_).
  Let meet := proj2 (proj2 (proj1 (proj1 (proj2 (proj2 apart_))))).
  Let numbers x (free : off x (region_edges loops)) : (0 <= winding_number x (region_edges loops) <= 1)%Z :=
    conj (proj1 (proj2 (proj1 (proj1 (proj2 (proj2 apart_))))) x free) (proj2 (proj1 (proj2 (proj2 apart_))) x free).
  Let pairs_meet a b A B other := proj1 (proj2 (proj2 (proj2 apart_)) a b A B other).
  Let same_all_along a b p q A B other := proj2 (proj2 (proj2 (proj2 apart_)) a b A B other) p q.

  Let beside (a b : list vector) (A : In a loops) (B : In b loops) (other : a <> b) :
    on_one_of (point_on_hole a b) (edges b) /\ off (point_on_hole a b) (edges a) :=
    point_on_hole_is a b (are_simple b B) (pairs_meet a b A B other).

  Let goes := is_round loops (number point_on_hole).

  Lemma encloses_is (a b : list vector) : In a loops -> In b loops -> (encloses a b <-> goes a b).
  Proof.
    intros A B. split.
    - intros [other round]. split; [exact A |]. split; [exact B |]. destruct (beside a b A B other) as [on free].
      rewrite <- (number_at loops same_all_along point_on_hole beside a b _ A B other on free). now apply round.
    - intros round. pose proof (goes_round_another loops point_on_hole a b round) as other. split; [exact other |].
      intros x on free. rewrite (number_at loops same_all_along point_on_hole beside a b x A B other on free).
      apply round.
  Qed.

  Lemma directly_encloses_is (a b : list vector) : In a loops -> In b loops ->
    directly_encloses loops a b -> directly_round loops (number point_on_hole) a b.
  Proof.
    intros A B [round none]. apply encloses_is in round; trivial. split; [exact round |]. intros c round_c other.
    pose proof (proj1 round_c) as C.
    destruct (one_round_the_other loops are_simple pairs_meet same_all_along point_on_hole beside a c b round round_c
      (not_eq_sym other)) as [between_ | yes]; [exfalso | exact yes].
    apply (none c C); now apply encloses_is.
  Qed.

  (* Theorem. *)
  Theorem nested_by_turns (a b : list vector) : In a loops -> In b loops -> directly_encloses loops a b ->
    is_counterclockwise a = negb (is_counterclockwise b).
  Proof.
    intros A B direct. apply directly_encloses_is in direct; trivial.
    exact (directions_alternate same_chain loops distinct_ (number point_on_hole) is_counterclockwise
      (number_of_itself point_on_hole) (nested_chains.number_is loops are_simple point_on_hole beside)
      (through loops are_simple pairs_meet same_all_along point_on_hole beside)
      (together loops distinct_ are_simple meet numbers pairs_meet same_all_along point_on_hole beside) a b direct).
  Qed.

  (* Theorem. What nothing encloses is external. *)
  Theorem outermost_is_external (b : list vector) : In b loops -> (forall a, In a loops -> ~ encloses a b) ->
    is_counterclockwise b = true.
  Proof.
    intros B none. destruct (is_counterclockwise b) eqn:turns_; [reflexivity | exfalso].
    destruct (outer_of_hole same_chain loops distinct_ (number point_on_hole) is_counterclockwise
      (number_of_itself point_on_hole) (nested_chains.number_is loops are_simple point_on_hole beside)
      (through loops are_simple pairs_meet same_all_along point_on_hole beside)
      (one_round_the_other loops are_simple pairs_meet same_all_along point_on_hole beside)
      (together loops distinct_ are_simple meet numbers pairs_meet same_all_along point_on_hole beside) b B turns_)
      as (a & [round _] & _).
    pose proof (proj1 round) as A. apply (none a A). now apply encloses_is.
  Qed.
End Loops.

(* Theorem, Observation 3.1.4. An external loop directly encloses holes only, a hole external loops only; and an
   outermost loop is external. *)
Theorem observation_3_1_4_as_printed (p q : region) :
  valid_region p -> valid_region q ->
  exists loops : list (list vector),
    (forall x, on_boundary_of_sum x p q <-> exists e, In e (region_edges loops) /\ lies_on x e) /\
    (forall loop, In loop loops -> orientable_loop loop) /\
    (forall e, In e (region_edges loops) -> is_directed_as_the_convolution p q e) /\
    (forall a b, In a loops -> In b loops -> directly_encloses loops a b ->
       (is_counterclockwise a = true -> is_counterclockwise b = false) /\
       (is_counterclockwise a = false -> is_counterclockwise b = true)) /\
    (forall b, In b loops -> (forall a, In a loops -> ~ encloses a b) -> is_counterclockwise b = true).
Proof.
  intros p_region q_region. pose proof (boundary_loops_do_not_cross p q p_region q_region) as apart_.
  exists (boundary_loops p q). split; [now apply boundary_is_on_the_loops |]. split; [| split; [| split]].
  - intros loop L. apply simple_chains_are_orientable_loops. exact (proj1 (proj2 apart_) loop L).
  - intros e E. split; [now apply reduced_segment_along_the_loops |]. intros s x S inside_ on.
    exact (proj2 (segments_along_the_loops p q p_region q_region e s x E S inside_ on)).
  - intros a b A B direct. rewrite (nested_by_turns _ apart_ a b A B direct).
    destruct (is_counterclockwise b); split; intros; trivial; discriminate.
  - intros b B. now apply outermost_is_external.
Qed.
