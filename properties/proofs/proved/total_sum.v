(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* What is kept (filling.v) enters each point as often as it leaves it, so the walks of sum_program.v end where they
   began and take every segment: of valid regions the program returns a sum. *)
From Coq Require Import QArith Qreduction Lqa ZArith Lia Bool List Permutation.
From Oplus Require Import balanced_edges specification direction angular_crossings winding_number regions
  meeting_of_segments convolution_winding theorem_4_2_1 test_of_regions homogeneous_points specification_bridge pieces
  filling kept_pieces_go_round cut_pieces kept_pieces_balance sum_program sum_is_right.
Import ListNotations.

Open Scope Z_scope.

Definition one_if (v w : vector) : Z := if vector_dec v w then 1 else 0.
Definition surplus (v : vector) (l : list segment) : Z :=
  sum (map (fun e => one_if (source e) v - one_if (target e) v) l).
Definition is_balanced (l : list segment) : Prop := forall v, surplus v l = 0.

Lemma surplus_of_more (v : vector) (e : segment) (l : list segment) :
  surplus v (e :: l) = one_if (source e) v - one_if (target e) v + surplus v l.
Proof. reflexivity. Qed.

Lemma surplus_permuted (v : vector) (l m : list segment) : Permutation l m -> surplus v l = surplus v m.
Proof. unfold surplus, sum. intros permuted. induction permuted; cbn; lia. Qed.

Lemma taken_from_is (v : vector) (l : list segment) (e : segment) : forall rest,
  taken_from v l = Some (e, rest) -> source e = v /\ Permutation (e :: rest) l.
Proof.
  induction l as [| f l IH]; intros rest; cbn; [discriminate |].
  destruct (vector_dec (source f) v) as [is_v |]; [intros [= <- <-]; split; [exact is_v | reflexivity] |].
  destruct (taken_from v l) as [[g others] |]; [| discriminate]. intros [= <- <-].
  destruct (IH others eq_refl) as [is_v permuted]. split; [exact is_v |]. rewrite <- permuted. apply perm_swap.
Qed.

Lemma something_is_taken (v : vector) (l : list segment) : (exists e, In e l /\ source e = v) -> taken_from v l <> None.
Proof.
  induction l as [| f l IH]; intros (e & I & is_v); [destruct I |]. cbn.
  destruct (vector_dec (source f) v); [discriminate |]. destruct I as [-> | I]; [contradiction |].
  destruct (taken_from v l) as [[g others] |] eqn:taken; [discriminate |].
  exfalso. apply IH; [now exists e | reflexivity].
Qed.

Lemma something_leaves (v : vector) (l : list segment) : 0 < surplus v l -> exists e, In e l /\ source e = v.
Proof.
  induction l as [| e l IH]; [cbn; lia |]. rewrite surplus_of_more. intros some.
  unfold one_if in some. destruct (vector_dec (source e) v) as [is_v |]; [exists e; split; [now left | exact is_v] |].
  destruct IH as (f & F & is_v).
  - destruct (vector_dec (target e) v); lia.
  - exists f. split; [now right | exact is_v].
Qed.

(* From vertex to vertex, and to the end. *)
Fixpoint path (chain : list vector) (z : vector) : list segment :=
  match chain with [] => [] | a :: rest => Segment a (hd z rest) :: path rest z end.

Lemma path_is (chain : list vector) (z : vector) : forall first,
  path (first :: chain) z = map (fun ends => Segment (fst ends) (snd ends)) (combine (first :: chain) (chain ++ [z])).
Proof.
  induction chain as [| a chain IH]; intros first; [reflexivity |].
  change (path (first :: a :: chain) z) with (Segment first a :: path (a :: chain) z). now rewrite IH.
Qed.

Lemma walk_returns (start : vector) (fuel : nat) : forall here l, (length l <= fuel)%nat ->
  (forall v, surplus v l = one_if here v - one_if start v) -> (exists e, In e l /\ source e = here) ->
  exists rest others, walk fuel start here l = (here :: rest, others) /\ is_balanced others /\
    Permutation (path (here :: rest) start ++ others) l.
Proof.
  induction fuel as [| fuel IH]; intros here l enough_ counts some.
  - destruct some as (e & I & _). destruct l; [destruct I | cbn in enough_; lia].
  - cbn [walk]. pose proof (something_is_taken here l some) as taken_.
    destruct (taken_from here l) as [[e rest] |] eqn:taken; [| contradiction]. clear taken_.
    apply taken_from_is in taken. destruct taken as [is_here permuted].
    assert (counts_rest : forall v, surplus v rest = one_if (target e) v - one_if start v).
    { intros v. specialize (counts v). rewrite <- (surplus_permuted v _ _ permuted), surplus_of_more,
      is_here in counts. lia. }
    destruct (vector_dec (target e) start) as [returned | going].
    + exists [], rest. split; [reflexivity |]. split.
      * intros v. rewrite counts_rest, returned. lia.
      * cbn [path hd app]. rewrite <- permuted, <- is_here, <- returned. now destruct e.
    + destruct (IH (target e) rest) as (further & others & -> & balanced_ & all).
      * apply Permutation_length in permuted. cbn in permuted. lia.
      * exact counts_rest.
      * apply something_leaves. rewrite counts_rest. unfold one_if.
        destruct (vector_dec (target e) (target e)) as [_ |]; [| contradiction].
        destruct (vector_dec start (target e)); [congruence | lia].
      * exists (target e :: further), others. split; [reflexivity |]. split; [exact balanced_ |].
        change (path (here :: target e :: further) start) with
          (Segment here (target e) :: path (target e :: further) start).
        cbn [app]. rewrite all, <- permuted, <- is_here. now destruct e.
Qed.

Lemma chains_take_all (fuel : nat) : forall l, (length l <= fuel)%nat -> is_balanced l ->
  Permutation (region_edges (chains_of fuel l)) l.
Proof.
  induction fuel as [| fuel IH]; intros l enough_ balanced_.
  - destruct l; [reflexivity | cbn in enough_; lia].
  - destruct l as [| e l]; [reflexivity |]. cbn [chains_of].
    destruct (walk_returns (source e) (length (e :: l)) (source e) (e :: l)) as (rest & others & -> & balanced_others
      & all).
    + lia.
    + intros v. rewrite balanced_. lia.
    + exists e. split; [now left | reflexivity].
    + cbn [region_edges flat_map]. fold (region_edges (chains_of fuel others)).
      assert (fewer : (length others <= fuel)%nat).
      { apply Permutation_length in all. rewrite app_length in all. cbn [path length] in all, enough_. lia. }
      change (flat_map edges (chains_of fuel others)) with (region_edges (chains_of fuel others)).
      rewrite (IH others fewer balanced_others). etransitivity; [| exact all]. apply Permutation_app_tail.
      rewrite path_is. reflexivity.
Qed.

(* The kept pieces. *)
Section Kept.
  Variable segments : list segment.
  Hypothesis all_long : forall t, In t segments -> nonzero (along t).
  Hypothesis closed : cycles segments.

  Definition is_reduced (v : vector) : Prop := reduced_vector v = v.

  Lemma reduced_is_reduced (v : vector) : is_reduced (reduced_vector v).
  Proof. apply reduced_of_equal, reduced_is. Qed.

  Lemma ends_are_reduced (e : segment) : In e (pieces_of segments) -> is_reduced (source e) /\ is_reduced (target e).
  Proof.
    intros E. destruct (piece_is segments all_long e E) as (s & piece & _ & _ & -> & _). unfold undirected.
    destruct (compare_points _ _); cbn [source target]; split; apply reduced_is_reduced.
  Qed.

  Lemma pieces_are_in_order (e : segment) : In e (pieces_of segments) -> comes_first (source e) (target e).
  Proof.
    intros E. pose proof (pieces_are_long _ _ (pieces_are_pieces segments all_long) e E) as long.
    destruct (piece_is segments all_long e E) as (s & piece & _ & _ & -> & _). unfold undirected in *.
    compared_points (reduced_vector (source piece)) (reduced_vector (target piece)); cbn [source target] in *; trivial.
    exfalso. apply long. destruct equal_points as [X Y]. unfold along, minus. cbn [source target vx vy]. split; lra.
  Qed.

  Lemma same_point_is (v w : vector) : is_reduced v -> is_reduced w -> as_number (same_point v w) = one_if v w.
  Proof.
    intros v_reduced w_reduced. unfold one_if. destruct (same_point_spec v w) as [equal | differ].
    - apply reduced_of_equal in equal. rewrite v_reduced, w_reduced in equal.
      destruct (vector_dec v w); [reflexivity | contradiction].
    - destruct (vector_dec v w) as [-> |]; [exfalso; apply differ; split; reflexivity | reflexivity].
  Qed.

  Lemma surplus_of_kept (v : vector) (l : list segment) : is_reduced v -> incl l (pieces_of segments) ->
    surplus v (flat_map (kept_piece segments) l) = weighted segments (leaves v) l.
  Proof.
    intros v_reduced part. induction l as [| e l IH]; [reflexivity |].
    assert (E : In e (pieces_of segments)) by (apply part; now left).
    destruct (ends_are_reduced e E) as [s_reduced t_reduced].
    assert (of_two : forall l m, surplus v (l ++ m) = surplus v l + surplus v m).
    { intros a b. unfold surplus. now rewrite map_app, sum_of_both. }
    cbn [flat_map]. rewrite of_two, IH by (intros f F; apply part; now right).
    unfold weighted. cbn [map]. unfold sum at 2. cbn [fold_right]. f_equal.
    unfold kept_piece, kept_sign, leaves. rewrite !same_point_is by assumption.
    destruct (is_right_inside segments (reversed e)), (is_right_inside segments e); unfold surplus, sum;
      cbn [map fold_right as_number reversed source target]; lia.
  Qed.

  Lemma no_vertex_is_inside (e f : segment) (v : vector) : In e (pieces_of segments) -> In f (pieces_of segments) ->
    v = source e \/ v = target e -> ~ strictly_inside v f.
  Proof.
    intros E F end_ inside_.
    destruct (piece_is segments all_long e E) as (s1 & p1 & S1 & P1 & -> & _).
    destruct (piece_is segments all_long f F) as (s2 & p2 & S2 & P2 & -> & _).
    apply (strictly_inside_of_one_place _ _ v (undirected_place p2)) in inside_.
    assert (end_of_p1 : equal_vectors v (source p1) \/ equal_vectors v (target p1)).
    { destruct (undirected_place p1) as [[a b] | [a b]], end_ as [-> | ->]; tauto. }
    assert (moved_ : forall w, equal_vectors v w -> strictly_inside w p2).
    { intros w [X Y]. destruct inside_ as (k & range & kx & ky). exists k. split; [exact range |].
      rewrite <- X, <- Y. tauto. }
    destruct end_of_p1 as [equal | equal];
      [apply (no_end_inside segments all_long s1 s2 p1 p2 (source p1)) |
       apply (no_end_inside segments all_long s1 s2 p1 p2 (target p1))]; trivial; try tauto; now apply moved_.
  Qed.

  Theorem filled_is_balanced : is_balanced (filled segments).
  Proof.
    intros v.
    destruct (existsb (fun e => if vector_dec (source e) v then true else if vector_dec (target e) v then true else
      false)
      (pieces_of segments)) eqn:is_end.
    - apply existsb_exists in is_end. destruct is_end as (e & E & end_).
      assert (end_is : v = source e \/ v = target e)
        by (destruct (vector_dec (source e) v); [now left |]; destruct (vector_dec (target e) v);
          [now right | discriminate]).
      destruct (ends_are_reduced e E) as [s_reduced t_reduced].
      unfold filled. rewrite surplus_of_kept; [| destruct end_is as [-> | ->]; assumption | apply incl_refl].
      apply balanced_at; trivial.
      + now apply pieces_are_pieces.
      + exact pieces_are_in_order.
      + intros f F. now apply (no_vertex_is_inside e f v).
    - assert (none : forall e, In e (pieces_of segments) -> source e <> v /\ target e <> v).
      { intros e E.
        assert (no_end : (if vector_dec (source e) v then true else if vector_dec (target e) v then true else false) =
          false).
        { destruct (if vector_dec (source e) v then _ else _) eqn:end_; [| reflexivity].
          assert (existsb (fun e => if vector_dec (source e) v then true else
            if vector_dec (target e) v then true else false) (pieces_of segments) = true)
            by (apply existsb_exists; now exists e). congruence. }
        destruct (vector_dec (source e) v); [discriminate |]. destruct (vector_dec (target e) v);
          [discriminate | now split]. }
      unfold filled. revert none. generalize (pieces_of segments). intros l none.
      induction l as [| e l IH]; [reflexivity |]. cbn [flat_map].
      unfold surplus. rewrite map_app, sum_of_both. fold (surplus v (flat_map (kept_piece segments) l)).
      rewrite IH by (intros f F; apply none; now right). destruct (none e (or_introl eq_refl)) as [a b].
      unfold kept_piece. destruct (is_right_inside segments (reversed e)), (is_right_inside segments e); unfold sum;
        cbn [map fold_right reversed source target]; unfold one_if;
        destruct (vector_dec (source e) v), (vector_dec (target e) v); try contradiction; reflexivity.
  Qed.
End Kept.

Lemma without_finds (e : segment) (l : list segment) : In e l -> exists m, without e l = Some m.
Proof.
  induction l as [| f l IH]; intros I; [destruct I |]. cbn. destruct (segment_dec e f); [now exists l |].
  destruct I as [-> | I]; [contradiction |]. destruct (IH I) as (m & ->). now exists (f :: m).
Qed.

Lemma permuted_are (l : list segment) : forall m, Permutation l m -> are_permuted l m = true.
Proof.
  induction l as [| e l IH]; intros m permuted; cbn.
  - apply Permutation_nil in permuted. now rewrite permuted.
  - destruct (without_finds e m) as (others & found); [apply (Permutation_in _ permuted); now left |]. rewrite found.
    apply IH. apply without_is in found. apply (Permutation_cons_inv (a := e)). now rewrite permuted, found.
Qed.

(* Without a test at run time. *)
Definition sum_of_regions (p q : polygonal_region) : polygonal_region :=
  let f := filled (convolution_segments (as_region p) (as_region q)) in
  map (map as_point) (chains_of (length f) f).

(* Theorem. Of valid regions it is the Minkowski sum. *)
Theorem sum_of_regions_is_the_sum (p q : polygonal_region) :
  valid_region (as_region p) -> valid_region (as_region q) -> is_minkowski_sum p q (sum_of_regions p q).
Proof.
  intros p_region q_region. apply sum_of_valid_regions; trivial. unfold chained.
  set (f := filled _). rewrite permuted_are; [reflexivity |]. apply chains_take_all; [lia |].
  destruct p_region as (p_edges & _), q_region as (q_edges & _). apply filled_is_balanced.
  - intros t. now apply convolution_segments_are_long.
  - now apply convolution_is_closed.
Qed.

(* So the program with its tests returns something for all regions that the test accepts. *)
Corollary minkowski_sum_returns (p q : polygonal_region) :
  is_valid_region (as_region p) = true -> is_valid_region (as_region q) = true ->
  minkowski_sum p q = Some (sum_of_regions p q).
Proof.
  intros p_valid q_valid. unfold minkowski_sum. cbv zeta. rewrite p_valid, q_valid. cbn [andb]. unfold chained.
  apply is_valid_region_is_right in p_valid, q_valid. destruct p_valid as (p_edges & _), q_valid as (q_edges & _).
  rewrite permuted_are; [reflexivity |]. apply chains_take_all; [lia |]. apply filled_is_balanced.
  - intros t. now apply convolution_segments_are_long.
  - now apply convolution_is_closed.
Qed.
