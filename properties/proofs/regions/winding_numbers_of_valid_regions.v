(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The winding numbers of a valid region are 0 and 1: 1 inside, 0 outside and in holes. Were a point inside two
   parts that are beside each other, the first edge that a ray from it meets would be inside the other part.
   Winding numbers of single chains are in winding_numbers_of_simple_chains.v, first edges in
   first_edge_of_a_ray.v, valid regions in valid_components.v. *)
From Coq Require Import ZArith Lia Bool List.
From Oplus Require Import numbers convolution signed_crossings crossing_of_a_step simple_chain simple_chains_turn_once
  first_edge_of_a_ray winding_numbers_of_simple_chains valid_components meeting_of_segments regions neighbourhoods.
Import ListNotations.

Open Scope Q_scope.

(* Around a point that one of two parts goes round there is a point of one part's boundary, off the other part,
   around which the other goes as often. *)
Lemma first_point_of_two_parts (some others : list segment) (x : vector) :
  cycles some -> cycles others -> off x (some ++ others) -> meet_in_ends_only some others ->
  winding_number x some <> 0%Z ->
  (exists y, on_one_of y some /\ off y others /\ winding_number y others = winding_number x others) \/
  (exists y, on_one_of y others /\ off y some /\ winding_number y some = winding_number x some).
Proof.
  intros closed_some closed_others x_off ends_only winds.
  destruct (ray_to_a_segment some (some ++ others) x x_off (incl_appl _ (incl_refl _)) winds)
    as (u & k & avoided & K & on_k).
  assert (K' : In k (some ++ others)) by (apply in_app_iff; now left).
  destruct (ray_meets_one_first x u (some ++ others) k 1 x_off avoided K' ltac:(lra) on_k)
    as (s & first & part & S & first_positive & after_start & before_end & _ & there & only).
  set (y := moved_along x u first) in *.
  assert (on_s : lies_on y s).
  { apply (lies_on_equal (inside_segment s part)); [now symmetry |].
    exists part. unfold inside_segment. cbn [vx vy]. repeat split; try lra; ring. }
  assert (no_end : forall e, In e (some ++ others) -> ~ equal_vectors y (source e)).
  { intros e E [xe ye]. destruct (avoided e E) as [off_line _]. apply off_line.
    unfold side_of, cross, minus. cbn [vx vy]. rewrite <- xe, <- ye. unfold y, moved_along. cbn [vx vy]. ring. }
  assert (not_both : on_one_of y some -> on_one_of y others -> False).
  { intros on_some on_others. destruct (ends_only y on_some on_others) as (e & E & at_end).
    now apply (no_end e E). }
  assert (unchanged : forall part_, incl part_ (some ++ others) -> cycles part_ -> off y part_ ->
    winding_number y part_ = winding_number x part_).
  { intros part_ among closed y_off. symmetry. apply (winding_number_along (Segment x y) part_ closed).
    intros z on_step e E on_e. apply (y_off e E). apply (lies_on_equal z); [| exact on_e].
    apply (only e z); trivial. now apply among. }
  apply in_app_iff in S. destruct S as [S | S]; [left | right]; exists y.
  - assert (on_part : on_one_of y some) by now exists s.
    assert (y_off : off y others) by (intros e E on_e; apply not_both; [exact on_part | now exists e]).
    split; [exact on_part | split; [exact y_off |]]. apply unchanged; trivial. apply incl_appr, incl_refl.
  - assert (on_part : on_one_of y others) by now exists s.
    assert (y_off : off y some) by (intros e E on_e; apply not_both; [now exists e | exact on_part]).
    split; [exact on_part | split; [exact y_off |]]. apply unchanged; trivial. apply incl_appl, incl_refl.
Qed.

(* No point is inside two parts that are beside each other. *)
Lemma not_inside_both (some others : list segment) (x : vector) :
  cycles some -> cycles others -> off x some -> off x others -> beside_each_other some others ->
  winding_number x some = 0%Z \/ winding_number x others = 0%Z.
Proof.
  intros closed_some closed_others off_some off_others (ends_only & some_outside & others_outside).
  destruct (Z.eq_dec (winding_number x some) 0) as [| winds]; [now left | right].
  destruct (first_point_of_two_parts some others x) as [(y & on_y & y_off & same) | (y & on_y & y_off & same)];
    trivial.
  - intros s I. apply in_app_iff in I. destruct I; auto.
  - rewrite <- same. now apply some_outside.
  - exfalso. apply winds. rewrite <- same. now apply others_outside.
Qed.

(* Inside the inner part is inside the part around it. *)
Lemma inside_what_is_around (inner around : list segment) (x : vector) :
  cycles inner -> cycles around -> off x inner -> off x around -> is_inside inner around ->
  winding_number x inner <> 0%Z -> winding_number x around <> 0%Z.
Proof.
  intros closed_inner closed_around off_inner off_around (ends_only & inner_inside & around_outside) winds none.
  destruct (first_point_of_two_parts inner around x) as [(y & on_y & y_off & same) | (y & on_y & y_off & same)];
    trivial.
  - intros s I. apply in_app_iff in I. destruct I; auto.
  - apply (inner_inside y on_y y_off). split; [exact y_off | congruence].
  - apply winds. rewrite <- same. now apply around_outside.
Qed.

Lemma off_one_of {A : Type} (f : A -> list segment) (l : list A) (a : A) (x : vector) :
  off x (flat_map f l) -> In a l -> off x (f a).
Proof. intros x_off I s S. apply x_off, in_flat_map. now exists a. Qed.

(* Of parts that are beside each other and each go around a point k times or not at all, at most one goes around it. *)
Lemma at_most_one_part {A : Type} (f : A -> list segment) (k : Z) (parts : list A) (x : vector) :
  (forall a, In a parts -> cycles (f a)) -> off x (flat_map f parts) ->
  ForallOrdPairs (fun a b => beside_each_other (f a) (f b)) parts ->
  (forall a, In a parts -> winding_number x (f a) = 0%Z \/ winding_number x (f a) = k) ->
  winding_number x (flat_map f parts) = 0%Z \/
  (winding_number x (flat_map f parts) = k /\ exists a, In a parts /\ winding_number x (f a) = k).
Proof.
  intros closed x_off beside each. induction beside as [| a parts beside_a beside IH]; [now left |].
  cbn [flat_map] in *. rewrite winding_number_is_additive.
  destruct IH as [none | [once (b & B & b_winds)]].
  - intros b I. apply closed. now right.
  - intros s I. apply x_off, in_app_iff. now right.
  - intros b I. apply each. now right.
  - rewrite none, Z.add_0_r. destruct (each a (or_introl eq_refl)) as [a_none | a_winds]; [now left | right].
    split; [exact a_winds |]. exists a. split; [now left | exact a_winds].
  - rewrite Forall_forall in beside_a.
    assert (a_off : off x (f a)) by (intros s I; apply x_off, in_app_iff; now left).
    assert (b_off : off x (f b)).
    { apply (off_one_of f parts b x); [| exact B]. intros s I. apply x_off, in_app_iff. now right. }
    destruct (not_inside_both (f a) (f b) x) as [a_none | b_none]; auto.
    + apply closed. now left.
    + apply closed. now right.
    + right. rewrite a_none, once. split; [reflexivity |]. exists b. split; [now right | exact b_winds].
    + assert (k_is : k = 0%Z) by congruence. rewrite once, k_is, Z.add_0_r.
      destruct (each a (or_introl eq_refl)) as [a_none | a_winds]; [now left | left; congruence].
Qed.

Lemma winding_numbers_of_valid_components (c : component) (x : vector) :
  valid_component c -> off x (edges_of_component c) ->
  winding_number x (edges_of_component c) = 0%Z \/ winding_number x (edges_of_component c) = 1%Z.
Proof.
  intros (outer_simple & counterclockwise & holes & beside) x_off.
  unfold edges_of_component, chains_of_component in *. cbn [flat_map] in *.
  rewrite winding_number_is_additive.
  assert (outer_off : off x (edges (outer_chain c))) by (intros s I; apply x_off, in_app_iff; now left).
  assert (holes_off : off x (flat_map edges (hole_chains c))) by (intros s I; apply x_off, in_app_iff; now right).
  pose proof (winding_numbers_of_simple_chains (outer_chain c) x outer_simple outer_off) as outer_winds.
  rewrite counterclockwise in outer_winds.
  destruct (at_most_one_part edges (-1) (hole_chains c) x) as [none | [once (h & H & h_winds)]]; trivial.
  - intros h _. apply closed_chain_cycles.
  - intros h I. destruct (holes h I) as (h_simple & clockwise & _).
    pose proof (winding_numbers_of_simple_chains h x h_simple (off_one_of edges _ h x holes_off I)) as winds.
    rewrite clockwise in winds. lia.
  - rewrite none. lia.
  - destruct (holes h H) as (_ & _ & h_inside).
    pose proof (inside_what_is_around (edges h) (edges (outer_chain c)) x (closed_chain_cycles h)
                  (closed_chain_cycles _) (off_one_of edges _ h x holes_off H) outer_off h_inside) as around.
    rewrite once. lia.
Qed.

(* Theorem. Off its boundary, the winding numbers of a valid region are 0 and 1. *)
Theorem winding_numbers_of_valid_regions (components : list component) (x : vector) :
  valid_components components -> off x (edges_of_components components) ->
  winding_number x (edges_of_components components) = 0%Z \/ winding_number x (edges_of_components components) = 1%Z.
Proof.
  intros [each beside] x_off.
  destruct (at_most_one_part edges_of_component 1 components x) as [none | [once _]]; trivial.
  - intros c _. apply region_cycles.
  - intros c I. apply winding_numbers_of_valid_components; [now apply each |].
    now apply (off_one_of edges_of_component components).
  - now left.
  - now right.
Qed.

(* The same of the region as a list of chains, whose edges are those of all chains together. *)
Lemma edges_of_region_are_its_chains (components : list component) :
  edges_of_components components = flat_map edges (region_of components).
Proof.
  unfold edges_of_components, region_of, edges_of_component.
  induction components as [| c rest IH]; [reflexivity |]. cbn [flat_map]. now rewrite flat_map_app, IH.
Qed.

Corollary valid_regions_are_nowhere_negative (components : list component) (x : vector) :
  valid_components components -> off x (flat_map edges (region_of components)) ->
  (0 <= winding_number x (flat_map edges (region_of components)) <= 1)%Z.
Proof.
  rewrite <- edges_of_region_are_its_chains. intros valid x_off.
  destruct (winding_numbers_of_valid_regions components x valid x_off) as [-> | ->]; lia.
Qed.
