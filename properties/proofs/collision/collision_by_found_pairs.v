(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The collision test needs to look only at pairs of pieces that have a point in common, also where boundaries touch or
   run along each other: others cut nothing and cross nothing. So whatever finds all of these pairs, as a sweep and
   hierarchies of boxes do (pairs_of_edges.v), the test returns what it returns by looking at all pairs. *)
From Coq Require Import ZArith Lia Bool List.
From Oplus Require Import numbers regions_and_sums location pieces naive_collision met_pieces collision_is_sound
  collision_is_complete placed_collision interiors_meet pairs_of_edges collision_by_pairs.
Import ListNotations.

Open Scope Q_scope.

Definition enters_among (found : segment -> segment -> bool) (of_a : list segment) (b : region) (of_b : list segment) :
    bool :=
  existsb (fun s => let found_ := filter (found s) of_b in
    existsb (fun piece => shows_common_interior piece b found_) (cut_where_met s found_)) of_a.

Definition collide_among (found : segment -> segment -> bool) (a b : region) : bool :=
  let of_a := boundary_pieces a in
  let of_b := boundary_pieces b in
  existsb (fun s => existsb (cross_properly s) (filter (found s) of_b)) of_a ||
  enters_among found of_a b of_b || enters_among (fun s f => found f s) of_b a of_a.

Lemma same_existence {A : Type} (f g : A -> bool) (l : list A) : (forall c, In c l -> f c = g c) ->
  existsb f l = existsb g l.
Proof.
  induction l as [| c l IH]; intros same_; [reflexivity |]. cbn [existsb]. rewrite (same_ c (or_introl eq_refl)).
  f_equal. apply IH. intros d D. apply same_. now right.
Qed.

Lemma existence_among {A : Type} (f found : A -> bool) (l : list A) : (forall c, In c l -> f c = true -> found c =
  true) ->
  existsb f (filter found l) = existsb f l.
Proof.
  induction l as [| c l IH]; intros all; [reflexivity |]. cbn [filter existsb].
  assert (rest : existsb f (filter found l) = existsb f l) by (apply IH; intros d D; apply all; now right).
  specialize (all c (or_introl eq_refl)). destruct (found c); cbn [existsb]; rewrite rest; [reflexivity |].
  destruct (f c); [discriminate all; reflexivity | reflexivity].
Qed.

(* Segments that are apart cut nothing. *)
Lemma nothing_is_cut (s f : segment) : (forall z, lies_on z s -> ~ lies_on z f) -> intersection s f = [].
Proof.
  intros apart_. unfold intersection.
  assert (ends_of_s : filter (fun p => is_on_segment p f) [source s; target s] = []).
  { cbn [filter]. destruct (is_on_spec (source s) f) as [on |]; [destruct (apart_ _ (source_lies_on s) on) |].
    destruct (is_on_spec (target s) f) as [on |]; [destruct (apart_ _ (target_lies_on s) on) | reflexivity]. }
  assert (ends_of_f : filter (fun p => is_on_segment p s) [source f; target f] = []).
  { cbn [filter]. destruct (is_on_spec (source f) s) as [on |]; [destruct (apart_ _ on (source_lies_on f)) |].
    destruct (is_on_spec (target f) s) as [on |]; [destruct (apart_ _ on (target_lies_on f)) | reflexivity]. }
  rewrite ends_of_s, ends_of_f. cbn [app sorted_points fold_right].
  destruct (cross_properly s f) eqn:crosses; [exfalso | reflexivity].
  destruct (crossing_point_is s f crosses) as (in_s & in_f & _).
  exact (apart_ _ (strictly_inside_lies_on _ _ in_s) (strictly_inside_lies_on _ _ in_f)).
Qed.

Lemma same_cuts (found : segment -> bool) (s : segment) (l : list segment) :
  (forall f z, In f l -> lies_on z s -> lies_on z f -> found f = true) ->
  cut_where_met s (filter found l) = cut_where_met s l.
Proof.
  intros all. unfold cut_where_met. f_equal. induction l as [| f l IH]; [reflexivity |]. cbn [filter flat_map].
  rewrite <- IH by (intros g z G; apply all; now right). destruct (found f) eqn:is_found; [reflexivity |].
  rewrite nothing_is_cut; [reflexivity |]. intros z on_s on_f.
  rewrite (all f z (or_introl eq_refl) on_s on_f) in is_found. discriminate.
Qed.

Lemma enters_among_is (found : segment -> segment -> bool) (of_a : list segment) (b : region) (of_b : list segment) :
  (forall s, In s of_a -> nonzero (along s)) ->
  (forall s f z, In s of_a -> In f of_b -> lies_on z s -> lies_on z f -> found s f = true) ->
  enters_among found of_a b of_b = boundary_enters of_a b of_b.
Proof.
  intros long all. unfold enters_among, boundary_enters. apply same_existence. intros s S. cbv zeta.
  rewrite (same_cuts (found s) s of_b) by (intros f z F; now apply all). apply same_existence. intros piece I.
  unfold shows_common_interior. destruct (locate (middle piece) b); try reflexivity.
  apply existence_among. intros f F test. apply andb_true_iff in test. destruct test as [on _].
  destruct (is_on_spec (middle piece) f) as [on_f |]; [| discriminate].
  apply (all s f (middle piece) S F); [| exact on_f].
  apply (part_lies_on piece s); [exact (proj1 (proj1 (cut_returns s _ (long s S)) piece I)) |].
  apply strictly_inside_lies_on, middle_is_inside.
Qed.

(* Theorem. *)
Theorem collision_by_found_pairs (found : segment -> segment -> bool) (a b : region) :
  no_edges_are_points a -> no_edges_are_points b ->
  (forall s f z, In s (boundary_pieces a) -> In f (boundary_pieces b) -> lies_on z s -> lies_on z f ->
     found s f = true) ->
  collide_among found a b = collide a b.
Proof.
  intros long_a long_b all.
  assert (long : forall r s, no_edges_are_points r -> In s (boundary_pieces r) -> nonzero (along s)).
  { intros r s not_points S. destruct (boundary_piece_is r s not_points S) as (e & _ & e_long & part & _).
    exact (proj1 (part_is_long s e part e_long)). }
  unfold collide_among, collide. cbv zeta. f_equal; [f_equal |].
  - apply same_existence. intros s S. apply existence_among. intros f F crosses.
    destruct (crossing_point_is s f crosses) as (in_s & in_f & _).
    exact (all s f _ S F (strictly_inside_lies_on _ _ in_s) (strictly_inside_lies_on _ _ in_f)).
  - apply enters_among_is; [intros s; now apply long | exact all].
  - apply enters_among_is; [intros s; now apply long |]. intros s f z S F on_s on_f. exact (all f s z F S on_f on_s).
Qed.

(* Pairs of pieces of P and of -Q, which is moved by x. *)
Definition is_among_the_pairs (x : vector) (pairs_ : list (segment * segment)) (s f : segment) : bool :=
  existsb (fun pair_ =>
    same_point (source (fst pair_)) (source s) && same_point (target (fst pair_)) (target s) &&
    same_point (plus (source (snd pair_)) x) (source f) && same_point (plus (target (snd pair_)) x) (target f)) pairs_.

Definition is_moved (x : vector) (g f : segment) : Prop :=
  equal_vectors (plus (source g) x) (source f) /\ equal_vectors (plus (target g) x) (target f).

Lemma what_is_listed (x : vector) (pairs_ : list (segment * segment)) (s g f : segment) : In (s, g) pairs_ ->
  is_moved x g f -> is_among_the_pairs x pairs_ s f = true.
Proof.
  intros listed [starts ends]. apply existsb_exists. exists (s, g). split; [exact listed |]. cbn [fst snd].
  rewrite !andb_true_iff.
  repeat split; match goal with |- same_point ?a ?b = true => destruct (same_point_spec a b) as [| no];
    [reflexivity |] end;
    exfalso; apply no; trivial; reflexivity.
Qed.

(* Theorem, Section 5.1.2, in any position: hierarchies of the pieces of P and of -Q, the second one moved by x, are all
   that the test has to look at. *)
Theorem collision_by_hierarchies_in_any_position (p q : region) (x : vector) (t u : hierarchy) :
  valid_region p -> valid_region q -> nowhere_above_one p -> nowhere_above_one q -> is_boxed t -> is_boxed u ->
  (forall s, In s (boundary_pieces p) -> In s (edges_of_hierarchy t)) ->
  (forall f, In f (boundary_pieces (placed x q)) -> exists g, In g (edges_of_hierarchy u) /\ is_moved x g f) ->
  (collide_among (is_among_the_pairs x (pairs_by_hierarchy x (meets_moved x) t u)) p (placed x q) = true <->
   interiors_meet x p q).
Proof.
  intros p_region q_region p_once q_once T U all_p all_q.
  rewrite collision_by_found_pairs; [now apply collide_decides_whether_interiors_meet | apply p_region | |].
  - exact (proj1 (placed_is_valid x q q_region)).
  - intros s f z S F on_s on_f. destruct (all_q f F) as (g & G & moved_). apply (what_is_listed x _ s g f);
    [| exact moved_].
    apply (hierarchies_find_all_pairs x _ t u (meets_moved_is_sound x) T U s g). unfold all_pairs_tested.
    apply filter_In. split; [apply in_prod_iff; split; [now apply all_p | exact G] |]. cbn [fst snd].
    apply meets_moved_is.
    + destruct (boundary_piece_is p s (proj1 p_region) S) as (e & _ & e_long & part & _).
      exact (proj1 (part_is_long s e part e_long)).
    + exists z. split; [exact on_s |]. apply on_moved_edge. destruct on_f as (k & range & X & Y).
      destruct moved_ as [[sx sy] [tx ty]]. exists k. cbn [source target]. split; [exact range |].
      split; [rewrite X, <- sx, <- tx | rewrite Y, <- sy, <- ty]; reflexivity.
Qed.
