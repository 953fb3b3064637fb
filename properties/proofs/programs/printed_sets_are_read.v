(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* What is printed of a set with edges and points of its own (region_printer.v) is read (region_reader.v) as itself,
   under the conditions of printed_regions_are_read.v. Each item of the collection adds what it is to what was read
   before. *)
From Coq Require Import QArith ZArith Lia Bool String List.
From Oplus Require Import specification region_reader region_printer printed_numbers_are_read
  printed_regions_are_read.
Import ListNotations.

Open Scope Z_scope.

(* From where items of a collection may come to where they may again, with what they add. *)
Definition may_take_an_item (r : so_far) : Prop := in_collection (beside r) = true /\ ring_so_far r = [].

Definition is_item (w : text) (add : so_far -> so_far) : Prop := forall line r, may_take_an_item r ->
  fold_left take_byte w (taken_to line Item r) = taken_to line Complete (add r) /\ may_take_an_item (add r).

Definition add_all (items : list (text * (so_far -> so_far))) (r : so_far) : so_far :=
  fold_left (fun r i => snd i r) items r.

Lemma lists_of_items_are_taken (line : Z) (items : list (text * (so_far -> so_far))) : forall first r,
  Forall (fun i => is_item (fst i) (snd i)) (first :: items) -> may_take_an_item r ->
  fold_left take_byte (fst first ++ after_commas (map fst items) ++ [closing_sign]) (taken_to line Item r) =
    taken_to line Complete (with_collection (add_all (first :: items) r) false).
Proof.
  induction items as [| i items IH]; intros first r all ready; inversion_clear all as [| ? ? of_first others];
    rewrite fold_left_app; destruct (of_first line r ready) as [-> ready']; cbn [map after_commas app fold_left];
    rewrite symbols_are_taken by reflexivity; unfold go_on; cbn [reading_at stage_of take_word result line_number];
    rewrite (proj1 ready').
  - reflexivity.
  - change (is_symbol comma_sign [comma_sign]) with true. cbn [negb].
    change (inl (Reading line [] 0 Item (snd first r))) with (taken_to line Item (snd first r)).
    rewrite blank_is_taken, <- app_assoc. now rewrite IH.
Qed.

Definition with_region (polygons : list (chain * list chain)) (r : so_far) : so_far :=
  SoFar (rev (flat_map chains_in polygons) ++ chains r) [] true (beside r).

Definition with_edge (e : edge) (r : so_far) : so_far :=
  let o := beside r in
  SoFar (chains r) [] false (Beside (is_unbounded o) (in_collection o) (e :: edges_so_far o) (points_so_far o)).

Definition with_point (v : point) (r : so_far) : so_far :=
  let o := beside r in
  SoFar (chains r) [] false (Beside (is_unbounded o) (in_collection o) (edges_so_far o) (v :: points_so_far o)).

Lemma regions_are_items (polygons : list (chain * list chain)) :
  polygons <> [] -> Forall is_printable_polygon polygons -> is_item (printed_region polygons) (with_region polygons).
Proof.
  intros some printable line r [inside _].
  split; [apply regions_are_taken; trivial; reflexivity | now split].
Qed.

Lemma points_in_a_list (line : Z) (all : lists) (v : point) (others : list point) (r : so_far) :
  all = Points \/ all = Vertices -> Forall is_printable_point (v :: others) ->
  fold_left take_byte (printed_list printed_point (v :: others)) (taken_to line (Contents all) r) =
    go_on (reading_at line (Next all Points)
      (SoFar (chains r) (rev others ++ v :: ring_so_far r) (is_hole r) (beside r)))
      [closing_sign].
Proof.
  intros which printable. unfold printed_list. cbn [fold_left]. rewrite symbols_are_taken by reflexivity.
  replace (go_on _ [opening_sign]) with (taken_to line (X all) r) by (now destruct which as [-> | ->]).
  now apply lists_of_points_are_taken.
Qed.

Lemma edges_are_items (e : edge) : is_printable_point (fst e) -> is_printable_point (snd e) ->
  is_item (bytes "LINESTRING " ++ printed_list printed_point [fst e; snd e]) (with_edge e).
Proof.
  intros one other line r [inside none]. rewrite fold_left_app.
  change (fold_left take_byte (bytes "LINESTRING ") (taken_to line Item r)) with (taken_to line (Contents Points) r).
  rewrite points_in_a_list; [| now left | repeat (constructor; trivial)]. rewrite none. now destruct e.
Qed.

Lemma points_are_items (v : point) : is_printable_point v ->
  is_item (bytes "POINT " ++ printed_list printed_point [v]) (with_point v).
Proof.
  intros printable line r [inside none]. rewrite fold_left_app.
  change (fold_left take_byte (bytes "POINT ") (taken_to line Item r)) with (taken_to line (Contents Vertices) r).
  rewrite points_in_a_list; [| now right | repeat (constructor; trivial)]. now rewrite none.
Qed.

Definition edge_items (edges : list edge) : list (text * (so_far -> so_far)) :=
  map (fun e => (bytes "LINESTRING " ++ printed_list printed_point [fst e; snd e], with_edge e)) edges.

Definition point_items (points : list point) : list (text * (so_far -> so_far)) :=
  map (fun v => (bytes "POINT " ++ printed_list printed_point [v], with_point v)) points.

Definition region_items (polygons : list (chain * list chain)) : list (text * (so_far -> so_far)) :=
  match polygons with [] => [] | _ => [(printed_region polygons, with_region polygons)] end.

Lemma all_are_added (polygons : list (chain * list chain)) (edges : list edge) (points : list point) (r : so_far) :
  let s := add_all (region_items polygons ++ edge_items edges ++ point_items points) r in
  chains s = rev (flat_map chains_in polygons) ++ chains r /\
  edges_so_far (beside s) = rev edges ++ edges_so_far (beside r) /\
  points_so_far (beside s) = rev points ++ points_so_far (beside r).
Proof.
  unfold add_all. cbv zeta. rewrite !fold_left_app. set (first := fold_left _ (region_items polygons) r).
  assert (of_region : chains first = rev (flat_map chains_in polygons) ++ chains r /\ beside first = beside r)
    by (unfold first; destruct polygons; now split).
  destruct of_region as [<- <-]. clearbody first. clear r. unfold edge_items, point_items.
  revert first. induction edges as [| e edges IH]; cbn [map fold_left snd]; intros r.
  - revert r. induction points as [| v points IH]; cbn [map fold_left snd]; intros r; [now split |].
    destruct (IH (with_point v r)) as (of_chains & of_edges & of_points). rewrite of_chains, of_edges, of_points.
    cbn [with_point chains beside edges_so_far points_so_far rev app]. now rewrite <- app_assoc.
  - destruct (IH (with_edge e r)) as (of_chains & of_edges & of_points). rewrite of_chains, of_edges, of_points.
    cbn [with_edge chains beside edges_so_far points_so_far rev app]. now rewrite <- app_assoc.
Qed.

Definition is_printable_edge (e : edge) : Prop := is_printable_point (fst e) /\ is_printable_point (snd e).

(* Theorem. *)
Theorem printed_sets_are_read (polygons : list (chain * list chain)) (edges : list edge) (points : list point) :
  Forall is_printable_polygon polygons -> Forall is_printable_edge edges -> Forall is_printable_point points ->
  set_in (printed_set polygons edges points) = inl (OpenRegion (flat_map chains_in polygons) edges points).
Proof.
  intros of_region of_edges of_points.
  assert (items : Forall (fun i => is_item (fst i) (snd i))
    (region_items polygons ++ edge_items edges ++ point_items points)).
  { apply Forall_app. split; [| apply Forall_app; split].
    - destruct polygons as [| p rest] eqn:these; constructor; [| constructor]. rewrite <- these in *.
      apply regions_are_items; [now rewrite these | exact of_region].
    - apply Forall_map. refine (Forall_impl _ _ of_edges). intros e [one other]. now apply edges_are_items.
    - apply Forall_map. refine (Forall_impl _ _ of_points). intros v. apply points_are_items. }
  pose proof (all_are_added polygons edges points (SoFar [] [] false (Beside false true [] []))) as added_.
  destruct (region_items polygons ++ edge_items edges ++ point_items points) as [| first rest] eqn:these.
  - assert (edges = [] /\ points = [] /\ polygons = []) as (-> & -> & ->) by now destruct polygons, edges, points.
    reflexivity.
  - destruct added_ as (of_chains & edges_ & points_).
    assert (text_is : edges <> [] \/ points <> [] -> printed_set polygons edges points =
      bytes "GEOMETRYCOLLECTION " ++ [opening_sign] ++
        (fst first ++ after_commas (map fst rest) ++ [closing_sign]) ++ [new_line]).
    { intros some. unfold printed_set. replace (match edges with [] => _ | _ => _ end) with
        (bytes "GEOMETRYCOLLECTION " ++ printed_list (fun item => item) (map fst (first :: rest)) ++ [new_line]).
      - unfold printed_list. cbn [map app]. now rewrite map_id, <- !app_assoc.
      - rewrite <- these, !map_app. unfold edge_items, point_items. rewrite !map_map. cbn [fst].
        destruct edges, points, polygons; try reflexivity; tauto. }
    assert (empty_or_not : (edges = [] /\ points = []) \/ edges <> [] \/ points <> [])
      by (destruct edges, points; intuition discriminate).
    destruct empty_or_not as [[-> ->] | some].
    + assert (polygons <> []) by now intros ->. unfold printed_set, set_in, printed_polygons. rewrite fold_left_app.
      change start_of_set with (taken_to 1 StartOfSet (SoFar [] [] false nothing_beside)).
      rewrite (regions_are_taken 1 StartOfSet); [| assumption | assumption | reflexivity ..].
      assert (complete : forall cs, at_end_of_set (fold_left take_byte [new_line]
        (taken_to 1 Complete (SoFar cs [] true nothing_beside))) = inl (OpenRegion (rev cs) [] []))
        by (intros cs; now rewrite <- reversed_as_rev).
      cbn [chains beside]. now rewrite app_nil_r, complete, rev_involutive.
    + rewrite (text_is some), app_assoc. unfold set_in. rewrite fold_left_app.
      change (fold_left take_byte (bytes "GEOMETRYCOLLECTION " ++ [opening_sign]) start_of_set)
        with (taken_to 1 Item (SoFar [] [] false (Beside false true [] []))).
      rewrite fold_left_app, lists_of_items_are_taken; [| exact items | now split].
      set (s := add_all _ _) in *.
      change (at_end_of_set _) with (inl failure (OpenRegion (rev' (chains s)) (rev' (edges_so_far (beside s)))
        (rev' (points_so_far (beside s))))).
      rewrite of_chains, edges_, points_, !reversed_as_rev. cbn [chains beside edges_so_far points_so_far].
      now rewrite !app_nil_r, !rev_involutive.
Qed.
