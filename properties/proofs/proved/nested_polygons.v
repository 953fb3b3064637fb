(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Polygons with holes, made of chains that do not cross, are valid components: outer chains, counterclockwise, each
   with its holes, clockwise, inside it and beside each other, and components beside each other. For these chains are
   nested or apart (nested_chains.v), and a hole is given to the innermost one around it (polygons.v), by a point of the
   hole that is not on the other chain. *)
From Coq Require Import QArith Lqa ZArith Arith Lia Bool List Permutation.
From Oplus Require Import specification regions_and_sums simple_chain simple_chains_turn_once valid_components
  specification_bridge pieces collision_is_sound filling touching_vertices polygons canonical_chains order_of_nesting
  nested_chains.
Import ListNotations.

Open Scope Q_scope.

Lemma nearest_vertex (a : vector) (l : list vector) : forall b,
  let v := fold_left (fun v w => if is_between_ends w a v then w else v) l b in
  (v = b \/ is_between_ends v a b = true) /\ forall w, In w l -> is_between_ends w a v = false.
Proof.
  induction l as [| c l IH]; intros b v; [split; [now left | intros w []] |]. cbn [fold_left] in v.
  destruct (IH (if is_between_ends c a b then c else b)) as [which none]. fold v in which, none.
  destruct (is_between_ends c a b) eqn:nearer.
  - assert (next : v = b \/ is_between_ends v a b = true).
    { right. destruct which as [-> | between_]; [exact nearer | now apply (between_in_line v a c b)]. }
    split; [exact next |]. intros w [<- | W]; [| now apply none].
    destruct (is_between_ends c a v) eqn:between_; [exfalso | reflexivity].
    assert (itself : is_between_ends v a v = true).
    { destruct which as [is_c | v_c]; [now rewrite is_c in between_ |- * | now apply (between_in_line v a c v)]. }
    unfold is_between_ends in itself. destruct (same_point_spec v v) as [_ | no];
      [now rewrite andb_false_r in itself | apply no; split; reflexivity].
  - split; [exact which |]. intros w [<- | W]; [| now apply none].
    destruct (is_between_ends c a v) eqn:between_; [exfalso | reflexivity].
    destruct which as [is_b | v_b]; [congruence |].
    enough (is_between_ends c a b = true) by congruence. now apply (between_in_line c a v b).
Qed.

(* The point that is tested is on the hole, and not on the other chain. *)
Lemma point_on_hole_is (outer hole : list vector) : simple hole -> meet_in_ends_only (edges outer) (edges hole) ->
  on_one_of (point_on_hole outer hole) (edges hole) /\ off (point_on_hole outer hole) (edges outer).
Proof.
  intros is_simple meet. pose proof is_simple as (three & long & common).
  destruct hole as [| a [| b rest]]; [cbn in three; lia .. |]. unfold point_on_hole.
  destruct (nearest_vertex a outer b) as [which none]. set (v := fold_left _ outer b) in *. set (p := Vector _ _).
  assert (first : edge_at (a :: b :: rest) 0 = Segment a b) by (rewrite edge_is by (cbn; lia); reflexivity).
  assert (E : In (Segment a b) (edges (a :: b :: rest)))
    by (rewrite <- first; apply nth_In; rewrite edges_are_as_many; cbn; lia).
  assert (a_b : nonzero (along (Segment a b))) by (apply long; now apply in_map).
  assert (differ : ~ equal_vectors a b).
  { intros [X Y]. apply a_b. unfold along, minus. cbn [source target vx vy]. rewrite X, Y. split; ring. }
  assert (far : exists k, 0 < k <= 1 /\ vx v == (1 - k) * vx a + k * vx b /\ vy v == (1 - k) * vy a + k * vy b).
  { destruct which as [-> | between_]; [exists 1; split; [lra | split; ring] |].
    apply is_between_ends_iff in between_. destruct between_ as (_ & k & range & X & Y). exists k.
    split; [lra | tauto]. }
  destruct far as (k & range & X & Y).
  assert (a_v : ~ equal_vectors a v).
  { intros [X' Y']. rewrite X in X'. rewrite Y in Y'. apply differ. split; apply (Qmult_inj_l _ _ k); lra. }
  assert (p_x : vx p == (1 - (1 # 2) * k) * vx a + (1 # 2) * k * vx b) by (unfold p; cbn [vx]; rewrite X; field).
  assert (p_y : vy p == (1 - (1 # 2) * k) * vy a + (1 # 2) * k * vy b) by (unfold p; cbn [vy]; rewrite Y; field).
  assert (half : 0 < (1 # 2) * k < 1) by (lra). set (j := (1 # 2) * k) in *. clearbody j.
  assert (on : lies_on p (Segment a b)) by (exists j; split; [lra | now split]).
  assert (no_end : ~ equal_vectors p a /\ ~ equal_vectors p b).
  { split; intros [X' Y']; rewrite p_x in X'; rewrite p_y in Y'; apply differ;
      [split; apply (Qmult_inj_l _ _ j); lra | split; apply (Qmult_inj_l _ _ (1 - j)); lra]. }
  assert (on_hole : on_one_of p (edges (a :: b :: rest))) by now exists (Segment a b).
  split; [exact on_hole |]. intros s S on_s. destruct (meet p) as (u & U & equal); [now exists s | exact on_hole |].
  apply in_app_iff in U. destruct U as [U | U].
  - assert (V : In (source u) outer) by (destruct (edges_ends outer) as [<- _]; now apply in_map).
    apply none in V. enough (is_between_ends (source u) a v = true) by congruence.
    apply is_between_ends_iff. split; [exact a_v |]. exists (1 # 2). split; [lra |]. destruct equal as [<- <-].
    unfold p. cbn [vx vy]. split; field.
  - apply (In_nth _ _ no_segment) in U. destruct U as (i & I & <-). rewrite edges_are_as_many in I.
    fold (edge_at (a :: b :: rest) i) in equal. pose proof (source_lies_on (edge_at (a :: b :: rest) i)) as at_i.
    apply (lies_on_equal _ p) in at_i; [| now symmetry]. destruct (Nat.eq_dec i 0) as [-> | other].
    { rewrite first in equal. now apply no_end. }
    rewrite <- first in on. destruct (common 0%nat i p) as [[is_ at_]| [_ at_]]; trivial; [cbn; lia | lia | | now apply
      no_end].
    cbn in is_. subst i. now apply no_end.
Qed.

Lemma partition_filters {A : Type} (f : A -> bool) (l : list A) :
  partition f l = (filter f l, filter (fun a => negb (f a)) l).
Proof. induction l as [| a l IH]; [reflexivity |]. cbn [partition filter]. rewrite IH. now destruct (f a). Qed.

(* Chains as above: simple, without crossings, and with winding numbers 0 and 1. *)
Definition do_not_cross (chains : region) : Prop :=
  NoDup chains /\ (forall a, In a chains -> simple a) /\ (valid_region chains /\ nowhere_above_one chains) /\
  forall a b, In a chains -> In b chains -> a <> b -> meet_in_ends_only (edges a) (edges b) /\
    forall p q, on_one_of p (edges b) -> off p (edges a) -> on_one_of q (edges b) -> off q (edges a) ->
      winding_number p (edges a) = winding_number q (edges a).

Definition component_of (p : polygon_with_holes) : component :=
  Component (map as_vector (fst p)) (map (map as_vector) (snd p)).

Section Components.
  Variable written : polygonal_region.
  Let chains := map (map as_vector) written.
  Hypothesis apart_ : do_not_cross chains.

  Let distinct_ := proj1 apart_.
  Let are_simple := proj1 (proj2 apart_).
  Let meet := proj2 (proj2 (proj1 (proj1 (proj2 (proj2 apart_))))).

  Lemma numbers_of_chains (x : vector) : off x (region_edges chains) ->
    (0 <= winding_number x (region_edges chains) <= 1)%Z.
  Proof.
    pose proof apart_ as (_ & _ & [(_ & not_negative & _) above] & _). intros free.
    split; [exact (not_negative x free) | exact (above x free)].
  Qed.

  Let pairs_meet a b A B other := proj1 (proj2 (proj2 (proj2 apart_)) a b A B other).
  Let same_all_along a b p q A B other := proj2 (proj2 (proj2 (proj2 apart_)) a b A B other) p q.

  Lemma beside_is (a b : list vector) : In a chains -> In b chains -> a <> b ->
    on_one_of (point_on_hole a b) (edges b) /\ off (point_on_hole a b) (edges a).
  Proof. intros A B other. apply point_on_hole_is; [now apply are_simple | now apply pairs_meet]. Qed.

  Let goes := is_round chains (number point_on_hole).
  Let directly := directly_round chains (number point_on_hole).

  Lemma as_vectors_differ (c d : chain) : map as_vector c = map as_vector d -> c = d.
  Proof.
    intros same. apply (f_equal (map as_point)) in same. rewrite !map_map in same.
    rewrite !(map_ext (fun x => as_point (as_vector x)) (fun x => x)), !map_id in same by (now intros []). exact same.
  Qed.

  Lemma goes_round_is (c d : chain) : In c written -> In d written -> c <> d ->
    (goes_round c d = true <-> goes (map as_vector c) (map as_vector d)).
  Proof.
    intros C D other. unfold goes, is_round, goes_round, number.
    destruct (same_chain (map as_vector c) (map as_vector d)) as [same | _];
      [destruct other; now apply as_vectors_differ |].
    rewrite negb_true_iff, Z.eqb_neq. split; [| tauto]. intros some. split; [now apply in_map |].
    split; [now apply in_map | exact some].
  Qed.

  Let outer := filter is_outer_chain written.
  Let holes := filter (fun c => negb (is_outer_chain c)) written.

  Lemma in_parts (c : chain) : (In c outer <-> In c written /\ is_outer_chain c = true) /\
    (In c holes <-> In c written /\ is_outer_chain c = false).
  Proof. unfold outer, holes. rewrite !filter_In, negb_true_iff. split; reflexivity. Qed.

  Let one_way_ := one_way chains pairs_meet same_all_along point_on_hole beside_is.

  Lemma directly_is_innermost (c h : chain) : In c outer -> In h holes ->
    directly (map as_vector c) (map as_vector h) -> is_innermost outer c h.
  Proof.
    intros O H [round first]. pose proof (proj1 (proj1 (in_parts c)) O) as [C c_turns].
    pose proof (proj1 (proj2 (in_parts h)) H) as [I h_turns].
    split; [exact O |]. split; [apply goes_round_is; trivial; intros ->; congruence |].
    intros d D other around. pose proof (proj1 (proj1 (in_parts d)) D) as [D' d_turns].
    apply goes_round_is in around; [| trivial .. | intros ->; congruence].
    assert (inside_ : goes (map as_vector d) (map as_vector c))
      by (apply first; [exact around | intros same; now apply other, as_vectors_differ]).
    split; [now apply goes_round_is |]. destruct (goes_round c d) eqn:back; [exfalso | reflexivity].
    apply goes_round_is in back; [| trivial .. | now apply not_eq_sym]. exact (one_way_ _ _ inside_ back).
  Qed.

  Lemma around_a_hole (h : chain) : In h holes -> exists c, In c outer /\ directly (map as_vector c) (map as_vector h).
  Proof.
    intros H. pose proof (proj1 (proj2 (in_parts h)) H) as [I h_turns].
    destruct (outer_of_hole same_chain chains distinct_ (number point_on_hole) is_counterclockwise
      (number_of_itself point_on_hole) (nested_chains.number_is chains are_simple point_on_hole beside_is)
      (through chains are_simple pairs_meet same_all_along point_on_hole beside_is)
      (one_round_the_other chains are_simple pairs_meet same_all_along point_on_hole beside_is)
      (together chains distinct_ are_simple meet numbers_of_chains pairs_meet same_all_along point_on_hole beside_is)
      (map as_vector h)) as (a & direct & turns); [now apply in_map | exact h_turns |].
    pose proof direct as [(A & _) _]. apply in_map_iff in A. destruct A as (c & <- & C).
    exists c. split; [now apply in_parts | exact direct].
  Qed.

  Lemma innermost_is_directly (c h : chain) : In h holes -> is_innermost outer c h ->
    directly (map as_vector c) (map as_vector h).
  Proof.
    intros H (O & around & inner). destruct (around_a_hole h H) as (d & D & direct).
    destruct (list_eq_dec vector_dec (map as_vector d) (map as_vector c)) as [same | other]; [now rewrite <- same |].
    assert (differ : d <> c) by (intros ->; contradiction).
    destruct (directly_is_innermost d h D H direct) as (_ & around_d & inner_d).
    destruct (inner d D differ around_d) as [_ no]. destruct (inner_d c O (not_eq_sym differ) around) as [yes _].
    congruence.
  Qed.

  (* Theorem. *)
  Theorem polygons_are_valid_components : valid_components (map component_of (polygons_of written)).
  Proof.
    assert (given : forall p, In p (polygons_of written) ->
      In (fst p) outer /\ forall h, In h (snd p) -> In h holes /\ is_innermost outer (fst p) h).
    { unfold polygons_of. rewrite partition_filters. apply holes_are_given_to_the_innermost.
      - apply NoDup_filter, (NoDup_map_inv (map as_vector)), distinct_.
      - intros h H. destruct (around_a_hole h H) as (c & O & direct). exists c. now apply directly_is_innermost. }
    apply (nested_components_are_valid chains distinct_ are_simple meet numbers_of_chains pairs_meet same_all_along
      point_on_hole beside_is).
    - transitivity (map (map as_vector) (flat_map chains_of_polygon (polygons_of written)));
        [| apply Permutation_map, chains_of_polygons].
      unfold region_of. rewrite !flat_map_concat_map, map_map, concat_map, map_map. reflexivity.
    - intros c C. apply in_map_iff in C. destruct C as (p & <- & P). now apply (in_parts (fst p)), given.
    - intros c h C I. apply in_map_iff in C. destruct C as (p & <- & P). apply in_map_iff in I.
      destruct I as (k & <- & K). destruct (proj2 (given p P) k K) as [H inner].
      split; [now apply (in_parts k) | now apply innermost_is_directly].
  Qed.
End Components.
