(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Chains in canonical form (reference/definitions/values.hpp): no vertex is between the two beside it, and the first
   is the smallest, which therefore is between no others: so one walk along the chain finds all to leave out. The
   points of a region and all winding numbers stay what they were, since two edges in line have the points of one.
   That chains turn clockwise most is in walks.v. *)
From Coq Require Import QArith Lqa ZArith Lia Bool List Permutation.
From Oplus Require Import balanced_edges direction angular_crossings winding_number in_out_degree regions location
  pieces walks touching_vertices.
Import ListNotations.

Fixpoint compare_chains (c d : list vector) : comparison :=
  match c, d with
  | [], [] => Eq
  | [], _ :: _ => Lt
  | _ :: _, [] => Gt
  | v :: c, w :: d => match compare_points v w with Eq => compare_chains c d | by_first => by_first end
  end.

Definition smaller_point (v w : vector) : vector := match compare_points w v with Lt => w | _ => v end.

(* The chain from v on, given what is before the list, backwards. *)
Fixpoint starting_at (v : vector) (passed l : list vector) : list vector :=
  match l with
  | [] => rev passed
  | w :: rest => if same_point v w then l ++ rev passed else starting_at v (w :: passed) rest
  end.

Definition from_smallest (c : list vector) : list vector :=
  match c with [] => [] | first :: rest => starting_at (fold_left smaller_point rest first) [] c end.

(* The chains that begin with v, given what is before the list, backwards. *)
Fixpoint rotations_at (v : vector) (passed l : list vector) : list (list vector) :=
  match l with
  | [] => []
  | w :: rest => (if same_point v w then [l ++ rev passed] else []) ++ rotations_at v (w :: passed) rest
  end.

(* What follows a, up to z, without vertices between the two beside them. *)
Fixpoint straightened (a : vector) (l : list vector) (z : vector) : list vector :=
  match l with
  | [] => []
  | b :: rest => if is_between_ends b a (hd z rest) then straightened a rest z else b :: straightened b rest z
  end.

Definition straight_chain (c : list vector) : list vector :=
  match c with [] => [] | a :: rest => a :: straightened a rest a end.

Definition canonical_chain (c : list vector) : list vector := straight_chain (from_smallest c).

(* If a chain passes its smallest vertex several times, it begins so that its vertices, without those in straight
   lines, are the smallest list. *)
Definition smaller_chain (c d : list vector) : list vector :=
  match compare_chains (straight_chain d) (straight_chain c) with Lt => d | _ => c end.

Definition canonical_start (c : list vector) : list vector :=
  match c with
  | [] => []
  | first :: rest => fold_left smaller_chain (rotations_at (fold_left smaller_point rest first) [] c) c
  end.

(* A ring begins where it was closed, or with the next vertex that is left. *)
Definition written_ring (ring : list vector) : list vector :=
  let chain := canonical_chain ring in
  match find (fun v => existsb (same_point v) chain) ring with Some v => starting_at v [] chain | None => chain end.

Section Alike.
  Variable x : vector.

  Lemma straight_path (z : vector) (l : list vector) : forall a,
    alike_from x (path (a :: straightened a l z) z) (path (a :: l) z).
  Proof.
    induction l as [| b rest IH]; intros a; [now apply alike_permuted |]. cbn [straightened].
    destruct (is_between_ends b a (hd z rest)) eqn:between_.
    - apply (alike_transitive x _ _ _ (IH a)). set (c := hd z rest) in *.
      change (path (a :: rest) z) with ([Segment a c] ++ path rest z).
      change (path (a :: b :: rest) z) with ([Segment a b; Segment b c] ++ path rest z).
      apply alike_together; [now apply alike_divided | now apply alike_permuted].
    - exact (alike_together x [Segment a b] [Segment a b] _ _ (alike_permuted x _ _ (Permutation_refl _)) (IH b)).
  Qed.

  Lemma straight_chain_is_alike (c : list vector) : alike_from x (edges (straight_chain c)) (edges c).
  Proof.
    destruct c as [| a rest]; [now apply alike_permuted |]. cbn [straight_chain]. rewrite !edges_are_a_path.
    apply straight_path.
  Qed.
End Alike.

Lemma edges_of_rotation (a b : list vector) : Permutation (edges (b ++ a)) (edges (a ++ b)).
Proof.
  destruct a as [| v a]; [now rewrite app_nil_r |]. destruct b as [| w b]; [now rewrite app_nil_r |].
  cbn [app]. rewrite !edges_are_a_path.
  change (w :: b ++ v :: a) with ((w :: b) ++ v :: a). change (v :: a ++ w :: b) with ((v :: a) ++ w :: b).
  rewrite !path_of_both. apply Permutation_app_comm.
Qed.

Definition is_rotation (d c : list vector) : Prop := exists a b, c = a ++ b /\ d = b ++ a.

Lemma starting_at_is_a_rotation (v : vector) (l : list vector) : forall passed,
  is_rotation (starting_at v passed l) (rev passed ++ l).
Proof.
  induction l as [| w l IH]; intros passed; cbn [starting_at].
  - exists [], (rev passed). rewrite !app_nil_r. now split.
  - destruct (same_point v w); [now exists (rev passed), (w :: l) |].
    specialize (IH (w :: passed)). cbn [rev] in IH. now rewrite <- app_assoc in IH.
Qed.

Lemma from_smallest_is_a_rotation (c : list vector) : is_rotation (from_smallest c) c.
Proof. destruct c as [| first rest]; [now exists [], [] | apply (starting_at_is_a_rotation _ _ [])]. Qed.

Lemma rotations_are (v : vector) (l : list vector) : forall passed d, In d (rotations_at v passed l) ->
  is_rotation d (rev passed ++ l).
Proof.
  induction l as [| w rest IH]; intros passed d I; [destruct I |]. cbn [rotations_at] in I. apply in_app_iff in I.
  destruct I as [I | I].
  - destruct (same_point v w); [destruct I as [<- | []] | destruct I]. now exists (rev passed), (w :: rest).
  - apply IH in I. cbn [rev] in I. now rewrite <- app_assoc in I.
Qed.

Lemma canonical_start_is_a_rotation (c : list vector) : is_rotation (canonical_start c) c.
Proof.
  destruct c as [| first rest]; [now exists [], [] |]. unfold canonical_start. set (v := fold_left _ rest first).
  assert (one : forall ls best, In (fold_left smaller_chain ls best) (best :: ls)).
  { induction ls as [| d ls IH]; intros best; [now left |]. cbn [fold_left].
    destruct (IH (smaller_chain best d)) as [is_ | I]; [| right; now right].
    rewrite <- is_. unfold smaller_chain. destruct (compare_chains _ _); cbn; tauto. }
  destruct (one (rotations_at v [] (first :: rest)) (first :: rest)) as [is_ | I].
  - rewrite <- is_. exists [], (first :: rest). split; [reflexivity | now rewrite app_nil_r].
  - exact (rotations_are v (first :: rest) [] _ I).
Qed.

Lemma written_ring_is_a_rotation (ring : list vector) : is_rotation (written_ring ring) (canonical_chain ring).
Proof.
  unfold written_ring. destruct (find _ ring); [apply (starting_at_is_a_rotation _ _ []) |].
  exists [], (canonical_chain ring). split; [reflexivity | now rewrite app_nil_r].
Qed.

Lemma edges_of_a_rotation (c d : list vector) : is_rotation d c -> Permutation (edges d) (edges c).
Proof. intros (a & b & -> & ->). apply edges_of_rotation. Qed.

(* What is in a row in a chain is so however it begins. *)
Lemma in_a_row (c d before after : list vector) (a v b : vector) : is_rotation d c ->
  d ++ d = before ++ a :: v :: b :: after -> exists before' after', c ++ c = before' ++ a :: v :: b :: after'.
Proof.
  intros (l & m & -> & ->) twice.
  change (a :: v :: b :: after) with ([a; v; b] ++ after) in twice. rewrite <- !app_assoc in twice.
  assert (late : forall k, l ++ m ++ l = k ++ [a; v; b] ++ after -> exists before' after',
    (l ++ m) ++ l ++ m = before' ++ a :: v :: b :: after').
  { intros k rest. exists k, (after ++ m). replace ((l ++ m) ++ l ++ m) with ((l ++ m ++ l) ++ m) by now rewrite <-
    !app_assoc. rewrite rest. now rewrite <- !app_assoc. }
  destruct (app_eq_app _ _ _ _ twice) as (k & [[m_is rest] | [_ rest]]); [| now apply (late k)].
  destruct k as [| x k]; [now apply (late []) |].
  replace ((x :: k) ++ l ++ m ++ l) with (((x :: k) ++ l ++ m) ++ l) in rest by now rewrite <- !app_assoc.
  destruct (app_eq_app _ _ _ _ rest) as (j & [[whole l_is] | [whole _]]).
  - destruct j as [| y j].
    + exists (l ++ before), []. rewrite app_nil_r in whole. rewrite m_is at 1. rewrite <- !app_assoc. f_equal. f_equal.
      now rewrite <- whole.
    + exfalso. apply (f_equal (@length vector)) in whole, l_is, m_is. rewrite !app_length in *. cbn [length] in *. lia.
  - exists (l ++ before), j. rewrite m_is at 1. rewrite <- !app_assoc. f_equal. f_equal. exact whole.
Qed.

Lemma canonical_chain_is_alike (x : vector) (c : list vector) : alike_from x (edges (canonical_chain c)) (edges c).
Proof.
  apply (alike_transitive x _ _ _ (straight_chain_is_alike x _)).
  destruct (from_smallest_is_a_rotation c) as (a & b & c_is & ->). rewrite c_is. apply alike_permuted,
    edges_of_rotation.
Qed.

(* Theorem. *)
Theorem canonical_chains_are_alike (x : vector) (r : region) :
  alike_from x (region_edges (map canonical_chain r)) (region_edges r).
Proof.
  induction r as [| c r IH]; [now apply alike_permuted |]. cbn [map].
  exact (alike_together x _ _ _ _ (canonical_chain_is_alike x c) IH).
Qed.

(* From here on: no vertex is left inside a straight line. *)
(* Four points in line. *)
Lemma between_in_line (a b c d : vector) : is_between_ends c b d = true ->
  (is_between_ends a b c = true -> is_between_ends a b d = true) /\
  (is_between_ends b a d = true -> is_between_ends b a c = true).
Proof.
  rewrite !is_between_ends_iff. intros (long & t & [t0 t1] & cx & cy). split; intros (long' & s & [s0 s1] & sx & sy).
  - split; [exact long |]. exists (s * t). assert (0 < s * t) by (now apply Qmult_lt_0_compat).
    assert (0 < (1 - s) * t) by (apply Qmult_lt_0_compat; lra). split; [lra |]. rewrite sx, sy, cx, cy. split; ring.
  - assert (0 < (1 - s) * t) by (apply Qmult_lt_0_compat; lra).
    assert (0 < (1 - s) * (1 - t)) by (apply Qmult_lt_0_compat; lra).
    assert (value : s / (s + (1 - s) * t) * (s + (1 - s) * t) == s) by (field; lra).
    assert (range : 0 < s / (s + (1 - s) * t) < 1) by (split; [apply Qlt_shift_div_l | apply Qlt_shift_div_r]; lra).
    set (k := s / (s + (1 - s) * t)) in *. clearbody k.
    assert (cx' : vx c == vx a + (s + (1 - s) * t) * (vx d - vx a)) by (rewrite cx, sx; ring).
    assert (cy' : vy c == vy a + (s + (1 - s) * t) * (vy d - vy a)) by (rewrite cy, sy; ring). split.
    + intros [X Y]. apply long'. rewrite cx' in X. rewrite cy' in Y.
      split; apply (Qmult_inj_l _ _ (s + (1 - s) * t)); lra.
    + exists k. split; [exact range |].
      setoid_replace ((1 - k) * vx a + k * vx c) with (vx a + k * (s + (1 - s) * t) * (vx d - vx a)) by (rewrite cx';
        ring).
      setoid_replace ((1 - k) * vy a + k * vy c) with (vy a + k * (s + (1 - s) * t) * (vy d - vy a)) by (rewrite cy';
        ring).
      rewrite value, sx, sy. split; ring.
Qed.

(* What follows a vertex is what followed it before, or farther away in the same direction. *)
Lemma next_is_in_line (z : vector) (l : list vector) : forall a,
  hd z (straightened a l z) = hd z l \/ is_between_ends (hd z l) a (hd z (straightened a l z)) = true.
Proof.
  induction l as [| b rest IH]; intros a; [now left |]. cbn [straightened hd].
  destruct (is_between_ends b a (hd z rest)) eqn:between_; [right | now left].
  destruct (IH a) as [-> | farther]; [exact between_ | now apply (between_in_line _ _ (hd z rest))].
Qed.

Lemma straightened_is_straight (z : vector) (l : list vector) : forall a before x v after,
  a :: straightened a l z = before ++ x :: v :: after -> is_between_ends v x (hd z after) = false.
Proof.
  induction l as [| b rest IH]; intros a before x v after; cbn [straightened].
  - destruct before as [| ? [|]]; discriminate.
  - destruct (is_between_ends b a (hd z rest)) eqn:between_; [apply IH |].
    destruct before as [| a' before]; [intros [= <- <- <-] | intros [= _ equal]; exact (IH b before x v after equal)].
    destruct (next_is_in_line z rest b) as [-> | farther]; [exact between_ |].
    destruct (is_between_ends b a (hd z (straightened b rest z))) eqn:longer; [| reflexivity].
    rewrite <- between_. symmetry. now apply (between_in_line _ _ (hd z rest) (hd z (straightened b rest z))).
Qed.

Lemma not_greater (v w : vector) : compare_points v w <> Gt <-> vx v < vx w \/ (vx v == vx w /\ vy v <= vy w).
Proof.
  compared_points v w; unfold equal_vectors, comes_first in *; (split; [intros; lra || contradiction |]);
    try discriminate. intros other. exfalso. lra.
Qed.

Lemma smallest_is_between_none (v a b : vector) :
  compare_points v a <> Gt -> compare_points v b <> Gt -> is_between_ends v a b = false.
Proof.
  rewrite !not_greater. intros A B. destruct (is_between_ends v a b) eqn:between_; [exfalso | reflexivity].
  apply is_between_ends_iff in between_. destruct between_ as (long & k & range & X & Y).
  assert (ax : vx a == vx v) by nra. assert (bx : vx b == vx v) by nra. apply long. split; [lra | nra].
Qed.

Lemma smallest_of_all (rest : list vector) : forall first, In (fold_left smaller_point rest first) (first :: rest) /\
  forall w, In w (first :: rest) -> compare_points (fold_left smaller_point rest first) w <> Gt.
Proof.
  induction rest as [| a rest IH]; intros first; cbn [fold_left].
  - split; [now left |]. intros w [<- | []]. rewrite not_greater. lra.
  - destruct (IH (smaller_point first a)) as [I least].
    assert (both : In (smaller_point first a) [first; a] /\ compare_points (smaller_point first a) first <> Gt /\
      compare_points (smaller_point first a) a <> Gt).
    { rewrite !not_greater. unfold smaller_point.
      compared_points a first; unfold equal_vectors, comes_first in *; cbn; (split; [tauto | lra]). }
    destruct both as (one & before_first & before_a). pose proof (least _ (or_introl eq_refl)) as least_.
    split; [destruct I as [<- | I]; [destruct one as [<- | [<- | []]] |]; cbn; tauto |].
    intros w [<- | [<- | W]]; [| | apply least; now right]; rewrite not_greater in *; lra.
Qed.

Lemma starts_with (v : vector) (l : list vector) : forall passed, In v l ->
  exists w, equal_vectors v w /\ hd v (starting_at v passed l) = w.
Proof.
  induction l as [| w l IH]; intros passed I; [destruct I |]. cbn [starting_at].
  destruct (same_point_spec v w) as [equal | differ]; [now exists w |].
  destruct I as [<- | I]; [exfalso; apply differ; split; reflexivity | now apply IH].
Qed.

Lemma starts_with_the_smallest (c rest : list vector) (a v : vector) :
  from_smallest c = a :: rest -> In v c -> compare_points a v <> Gt.
Proof.
  destruct c as [| first others]; [discriminate |]. cbn [from_smallest]. intros starts I.
  destruct (smallest_of_all others first) as [there least].
  destruct (starts_with _ (first :: others) [] there) as (w & equal & head). rewrite starts in head. cbn [hd] in head.
  subst w. specialize (least v I). rewrite not_greater in *. unfold equal_vectors in equal. lra.
Qed.

Lemma straightened_are_of (z v : vector) (l : list vector) : forall a, In v (straightened a l z) -> In v l.
Proof.
  induction l as [| b rest IH]; intros a I; [exact I |]. cbn [straightened] in I.
  destruct (is_between_ends b a (hd z rest)); [right; now apply (IH a) |].
  destruct I as [<- | I]; [now left | right; now apply (IH b)].
Qed.

(* Theorem. No vertex is between the two beside it; going round twice, each has two. *)
Theorem canonical_chain_is_straight (c before after : list vector) (a v b : vector) :
  canonical_chain c ++ canonical_chain c = before ++ a :: v :: b :: after -> is_between_ends v a b = false.
Proof.
  unfold canonical_chain. destruct (from_smallest c) as [| first rest] eqn:starts; [destruct before; discriminate |].
  cbn [straight_chain]. set (chain := first :: straightened first rest first). intros twice.
  assert (smallest : forall w, In w chain -> compare_points first w <> Gt).
  { intros w W. apply (starts_with_the_smallest c rest); [exact starts |].
    destruct (from_smallest_is_a_rotation c) as (l & m & -> & turned). rewrite turned in starts.
    assert (In w (first :: rest)) by (destruct W as [<- | W]; [now left | right; now apply straightened_are_of in W]).
    rewrite <- starts in H. apply in_app_iff. apply in_app_iff in H. tauto. }
  assert (inner : forall l m, chain = l ++ a :: v :: m -> b = hd first m -> is_between_ends v a b = false)
    by (intros l m is_ ->; exact (straightened_is_straight _ _ _ l _ _ m is_)).
  assert (at_start : chain = before ++ [a] -> chain = v :: b :: after -> is_between_ends v a b = false).
  { intros ends_ starts_. assert (v_is : v = first) by (unfold chain in starts_; congruence). subst v.
    apply smallest_is_between_none; apply smallest; [rewrite ends_ | rewrite starts_]; [apply in_elt | cbn; tauto]. }
  assert (b_starts : forall m, b :: after = m ++ chain -> b = hd first m) by (intros [| ? ?] [= -> _]; reflexivity).
  clearbody chain. change (before ++ a :: v :: b :: after) with (before ++ [a] ++ v :: b :: after) in twice.
  rewrite app_assoc in twice. apply app_eq_app in twice. destruct twice as (m & [[one two] | [one two]]).
  - destruct m as [| v' m]; [rewrite app_nil_r in one; now apply at_start |]. injection two as <- two.
    rewrite <- app_assoc in one. exact (inner before m one (b_starts m two)).
  - destruct m as [| last m _] using rev_ind; [rewrite app_nil_r in one; now apply at_start |].
    rewrite app_assoc in one. apply app_inj_tail in one. destruct one as [_ <-]. rewrite <- app_assoc in two.
    exact (inner m (b :: after) two eq_refl).
Qed.
