(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The chains of a region as polygons with holes, as files have them: a hole is given to the innermost of the outer
   chains around it. On which one that is, the points of a region do not depend; that it is right is in
   nested_polygons.v. A hole with no chain around it, which no valid region has, would be a polygon of its own. *)
From Coq Require Import QArith ZArith Bool List Permutation.
From Oplus Require Import direction winding_number convolution specification regions simple_chains_turn_once
  specification_bridge touching_vertices.
Import ListNotations.

Open Scope Q_scope.

Definition polygon_with_holes := (chain * list chain)%type.
Definition chains_of_polygon (p : polygon_with_holes) : list chain := fst p :: snd p.

Definition is_outer_chain (c : chain) : bool := is_counterclockwise (map as_vector c).

(* A point on the hole's first edge, and not on the outer chain, which it meets in vertices only: halfway to the first
   vertex of that on this edge, or to its end. *)
Definition point_on_hole (outer hole : list vector) : vector :=
  match hole with
  | a :: b :: _ =>
    let first := fold_left (fun v w => if is_between_ends w a v then w else v) outer b in
    Vector ((vx a + vx first) / 2) ((vy a + vy first) / 2)
  | _ => nowhere
  end.

(* Whether the hole is in the outer chain. *)
Definition goes_round (outer hole : chain) : bool :=
  let around := map as_vector outer in
  negb (winding_number (point_on_hole around (map as_vector hole)) (edges around) =? 0)%Z.

(* Given to the first polygon around it of which none that follows is inside and around the hole, too. *)
Fixpoint with_hole (polygons : list polygon_with_holes) (hole : chain) : list polygon_with_holes :=
  match polygons with
  | [] => [(hole, [])]
  | (outer, holes) :: others =>
    if goes_round outer hole && negb (existsb (fun p => goes_round (fst p) hole && goes_round outer (fst p)) others)
    then (outer, holes ++ [hole]) :: others else (outer, holes) :: with_hole others hole
  end.

(* In the order of the chains. *)
Definition polygons_of (r : polygonal_region) : list polygon_with_holes :=
  let (outer, holes) := partition is_outer_chain r in
  fold_left with_hole holes (map (fun c => (c, [])) outer).

Lemma with_hole_adds (hole : chain) (polygons : list polygon_with_holes) :
  Permutation (flat_map chains_of_polygon (with_hole polygons hole))
    (hole :: flat_map chains_of_polygon polygons).
Proof.
  induction polygons as [| [outer holes] others IH]; [reflexivity |]. cbn [with_hole].
  match goal with |- context [if ?test then _ else _] => destruct test end;
    cbn [flat_map chains_of_polygon fst snd app].
  - rewrite <- app_assoc. cbn [app]. rewrite perm_swap. constructor. symmetry. apply Permutation_middle.
  - rewrite IH. rewrite perm_swap. constructor. symmetry. apply Permutation_middle.
Qed.

Lemma partition_permutes {A : Type} (f : A -> bool) (l : list A) : forall yes no, partition f l = (yes, no) ->
  Permutation l (yes ++ no).
Proof.
  induction l as [| a l IH]; intros yes no parts; [now injection parts as <- <- |]. cbn [partition] in parts.
  destruct (partition f l) as [y n]. specialize (IH y n eq_refl).
  destruct (f a); injection parts as <- <-; rewrite IH; [reflexivity | apply Permutation_middle].
Qed.

(* Each chain is there once. *)
Lemma chains_of_polygons (r : polygonal_region) : Permutation (flat_map chains_of_polygon (polygons_of r)) r.
Proof.
  unfold polygons_of. destruct (partition _ r) as [outer holes] eqn:parts.
  rewrite (partition_permutes _ _ _ _ parts). clear parts r.
  assert (all : forall ps, Permutation (flat_map chains_of_polygon (fold_left with_hole holes ps))
    (flat_map chains_of_polygon ps ++ holes)).
  { induction holes as [| hole holes IH]; intros ps; cbn [fold_left]; [now rewrite app_nil_r |].
    rewrite IH, with_hole_adds. cbn [app]. apply Permutation_middle. }
  rewrite all. apply Permutation_app_tail. clear. induction outer as [| c outer IH]; [reflexivity |]. cbn. now
    constructor.
Qed.

(* It is around the hole, and of all others that are, each is around it, and not inside. *)
Definition is_innermost (outer : list chain) (c hole : chain) : Prop :=
  In c outer /\ goes_round c hole = true /\ forall d, In d outer -> d <> c -> goes_round d hole = true ->
    goes_round d c = true /\ goes_round c d = false.

Lemma given_to_the_innermost (c hole : chain) (polygons : list polygon_with_holes) : NoDup (map fst polygons) ->
  is_innermost (map fst polygons) c hole -> exists before holes after,
    polygons = before ++ (c, holes) :: after /\ with_hole polygons hole = before ++ (c, holes ++ [hole]) :: after.
Proof.
  induction polygons as [| [d holes] others IH]; intros once (I & around & inner); [destruct I |].
  cbn [map fst] in *. inversion once as [| ? ? new once_others]; subst. cbn [with_hole]. destruct I as [-> | I].
  - exists [], holes, others. split; [reflexivity |]. rewrite around. cbn [andb app].
    match goal with |- context [existsb ?test others] => destruct (existsb test others) eqn:found end;
      [exfalso | reflexivity].
    apply existsb_exists in found. destruct found as (p & P & both). apply andb_true_iff in both.
    apply (in_map fst) in P. destruct (inner (fst p)) as [_ no]; [now right | | apply both |].
    + intros is_c. apply new. now rewrite <- is_c.
    + rewrite no in both. now destruct both.
  - destruct IH as (before & hs & after & is_ & given); [exact once_others | |].
    { split; [exact I |]. split; [exact around |]. intros e E. apply inner. now right. }
    assert (no : goes_round d hole && negb (existsb (fun p => goes_round (fst p) hole && goes_round d (fst p)) others) =
      false).
    { destruct (goes_round d hole) eqn:round; [| reflexivity]. cbn [andb]. apply negb_false_iff, existsb_exists.
      apply in_map_iff in I. destruct I as (p & <- & P). exists p. split; [exact P |]. rewrite around. cbn [andb].
      apply inner; [now left | | exact round]. intros ->. apply new, in_map, P. }
    rewrite no, given, is_. now exists ((d, holes) :: before), hs, after.
Qed.

(* Theorem. If around each hole there is an innermost one, it has it, and all others are where they were. *)
Theorem holes_are_given_to_the_innermost (outers holes : list chain) : NoDup outers ->
  (forall h, In h holes -> exists c, is_innermost outers c h) ->
  forall p, In p (fold_left with_hole holes (map (fun c => (c, [])) outers)) ->
    In (fst p) outers /\ forall h, In h (snd p) -> In h holes /\ is_innermost outers (fst p) h.
Proof.
  intros once all.
  assert (step : forall hs polygons, incl hs holes -> map fst polygons = outers ->
    (forall p h, In p polygons -> In h (snd p) -> In h holes /\ is_innermost outers (fst p) h) ->
    forall p, In p (fold_left with_hole hs polygons) ->
    In (fst p) outers /\ forall h, In h (snd p) -> In h holes /\ is_innermost outers (fst p) h).
  { induction hs as [| h hs IH]; intros polygons part outer_are given p P; cbn [fold_left] in P.
    - split; [rewrite <- outer_are; now apply in_map | intros h; now apply given].
    - destruct (all h (part h (or_introl eq_refl))) as (c & inner).
      destruct (given_to_the_innermost c h polygons) as (before & l & after & is_ & new); [now rewrite outer_are ..|].
      apply (IH (with_hole polygons h)); [intros k K; apply part; now right | | | exact P]; rewrite new.
      + rewrite <- outer_are, is_, !map_app. reflexivity.
      + intros q k Q K. rewrite is_ in given. apply in_app_iff in Q. destruct Q as [Q | [<- | Q]].
        * apply given; [apply in_app_iff; now left | exact K].
        * cbn [fst snd] in *. apply in_app_iff in K. destruct K as [K | [<- | []]].
          -- apply (given (c, l)); [apply in_elt | exact K].
          -- split; [apply part; now left | exact inner].
        * apply given; [apply in_app_iff; right; now right | exact K]. }
  apply step; [apply incl_refl | rewrite map_map; apply map_id |].
  intros p h P H. apply in_map_iff in P. destruct P as (c & <- & _). destruct H.
Qed.
