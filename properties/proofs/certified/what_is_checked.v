(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* What the checker (checker.v) has looked at where it refuses nothing: the steps of `check`, one by one. *)
From Coq Require Import NArith QArith Bool List.
From Oplus Require Import specification checker.
Import ListNotations.

Lemma no_failure {A} (test : A -> bool) (l : list A) : forall n,
  first_failure test n l = None -> forall a, In a l -> test a = true.
Proof.
  induction l as [| b l IH]; intros n none a; [easy |]. cbn [first_failure] in none.
  destruct (test b) eqn:passed; [| discriminate]. intros [<- | I]; [exact passed | now apply (IH (N.succ n))].
Qed.

Lemma not_refused (test : bool) (r : refusal) (rest : option refusal) :
  (if test then Some r else rest) = None -> test = false /\ rest = None.
Proof. now destruct test. Qed.

Lemma passed_test (test : bool) (r : refusal) (rest : option refusal) :
  (if negb test then Some r else rest) = None -> test = true /\ rest = None.
Proof. now destruct test. Qed.

Lemma none_failed {A} (test : A -> bool) (l : list A) (r : N -> refusal) (rest : option refusal) :
  match first_failure test 0 l with Some n => Some (r n) | None => rest end = None ->
  (forall a, In a l -> test a = true) /\ rest = None.
Proof.
  destruct (first_failure test 0 l) eqn:none; [discriminate |].
  split; [exact (no_failure test l _ none) | assumption].
Qed.

Section Checked.
  Variables (is_open : bool) (p q : polygonal_region) (s : open_region) (c : certificate).

  Definition p_pieces : list piece := map piece_of (summand_pieces (of_p c)).
  Definition q_pieces : list piece := map piece_of (summand_pieces (of_q c)).
  Definition s_pieces : list piece := map (fun d => piece_of (fst d)) (sum_pieces c).
  Definition p_numbered : numbered := numbers_from 1 p_pieces.
  Definition q_numbered : numbered := numbers_from 1 q_pieces.
  Definition dangling : list hedge := map hedge_of (dangling_edges s).
  Definition isolated : list hpoint := map homogeneous (isolated_points s).
  Definition diagonals : list (hedge * seam) :=
    diagonals_of (hedges_of_region (open_chains s)) (sum_inserted c) (seams c).

  Record is_checked : Prop := {
    p_is_made_of_pieces : are_a_region (hedges_of_region p) (summand_inserted (of_p c)) p_pieces = true;
    q_is_made_of_pieces : are_a_region (hedges_of_region q) (summand_inserted (of_q c)) q_pieces = true;
    s_is_made_of_pieces : are_a_region (hedges_of_region (open_chains s)) (sum_inserted c) s_pieces = true;
    p_is_reached : are_all_reached p_numbered (all_reached p_numbered (roots (of_p c)) (links (of_p c))) = true;
    q_is_reached : are_all_reached q_numbered (all_reached q_numbered (roots (of_q c)) (links (of_q c))) = true;
    roots_are_inside : are_roots_inside
      (is_in_region (unit c) (hedges_of_region (open_chains s)) (trees_of (unit c) s_pieces)) p_numbered q_numbered
      (roots (of_p c)) (roots (of_q c)) = true;
    edges_are_beside : forall e,
      In e (hedges_of_region (open_chains s) ++ dangling ++ map (fun v => (v, v)) isolated) ->
      forallb (fun t => forallb (are_trees_apart (unit c) (placed_hedge (unit c) e) t) (trees_of (unit c) q_pieces))
        (trees_of (unit c) p_pieces) = true;
    cells_are_checked : forall d, In d (sum_pieces c) ->
      are_sums (if is_open then
          is_seam_of_cut p_numbered q_numbered (numbers_from 1 dangling) (numbers_from 1 isolated)
        else fun _ _ _ => true) p_numbered q_numbered (fst d) (snd d) = true;
    sides_are_listed : is_open = true ->
      have_all_sides (hedges_of_region (open_chains s)) (sum_inserted c) s_pieces (map fst diagonals) = true;
    seams_are_checked : is_open = true -> forall d, In d diagonals ->
      is_seam_of_edge p_numbered q_numbered (numbers_from 1 dangling) (numbers_from 1 isolated) d = true;
    p_edges_touch : touch_at_most (unit c) (hedges_of_region p) = true;
    q_edges_touch : touch_at_most (unit c) (hedges_of_region q) = true;
    s_edges_touch : touch_at_most (unit c) (hedges_of_region (open_chains s)) = true }.

  Theorem check_means : check is_open p q s c = None -> is_checked.
  Proof.
    unfold check. cbv zeta. intros accepted.
    apply passed_test in accepted. destruct accepted as [p_is accepted].
    apply passed_test in accepted. destruct accepted as [q_is accepted].
    apply passed_test in accepted. destruct accepted as [s_is accepted].
    apply not_refused in accepted. destruct accepted as [listed accepted].
    apply passed_test in accepted. destruct accepted as [p_reached accepted].
    apply passed_test in accepted. destruct accepted as [q_reached accepted].
    apply passed_test in accepted. destruct accepted as [inside_ accepted].
    apply none_failed in accepted. destruct accepted as [beside accepted].
    apply none_failed in accepted. destruct accepted as [cells_ accepted].
    apply none_failed in accepted. destruct accepted as [seams_ accepted].
    apply passed_test in accepted. destruct accepted as [p_touch accepted].
    apply passed_test in accepted. destruct accepted as [q_touch accepted].
    apply passed_test in accepted. destruct accepted as [s_touch _].
    split; trivial; intros opened.
    - rewrite opened in listed. now apply negb_false_iff.
    - rewrite opened in seams_. exact seams_.
  Qed.
End Checked.

Lemma accepted_is_checked (p q s : polygonal_region) (c : certificate) : accepts p q s c = true ->
  is_checked false p q (OpenRegion s [] []) c.
Proof. unfold accepts. destruct (check _ _ _ _ _) eqn:none; [discriminate | intros _; now apply check_means]. Qed.

Lemma accepted_open_is_checked (p q : polygonal_region) (s : open_region) (c : certificate) :
  accepts_open p q s c = true -> is_checked true p q s c.
Proof. unfold accepts_open. destruct (check _ _ _ _ _) eqn:none; [discriminate | intros _; now apply check_means]. Qed.
