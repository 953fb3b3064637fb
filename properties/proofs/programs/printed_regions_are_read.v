(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* What is printed (region_printer.v) is read (region_reader.v) as itself: of every list of polygons with holes, if
   their chains have the right orientations, and numbers are in lowest terms and no longer than words may be. What the
   reader is at after each part of the text, a word, a point, a ring, a polygon, follows from what it was at before. *)
From Coq Require Import QArith ZArith Lia Bool String List.
From Oplus Require Import specification region_reader region_printer printed_numbers_are_read.
Import ListNotations.

Open Scope Z_scope.

Definition nothing_beside : beside_chains := Beside false false [] [].

(** Words *)

Definition is_plain (b : Z) : bool :=
  negb ((b =? opening_sign) || (b =? closing_sign) || (b =? comma_sign) || (b =? blank_sign) || (b =? tab) ||
    (b =? carriage_return) || (b =? new_line)).

Definition is_word (w : text) : Prop := w <> [] /\ Forall (fun b => is_plain b = true) w /\
  Z.of_nat (length w) <= longest_word.

(* Before a word in this line. *)
Definition reading_at (line : Z) (p : stage) (r : so_far) : reading := Reading line [] 0 p r.
Definition taken_to (line : Z) (p : stage) (r : so_far) : reading + failure := inl (reading_at line p r).

Lemma plain_bytes_are_taken (w : text) : forall line word_ count p r, Forall (fun b => is_plain b = true) w ->
  count + Z.of_nat (length w) <= longest_word ->
  fold_left take_byte w (inl (Reading line word_ count p r)) =
    inl (Reading line (rev w ++ word_) (count + Z.of_nat (length w)) p r).
Proof.
  induction w as [| b w IH]; intros line word_ count p r plain short.
  - cbn [length fold_left rev app Z.of_nat]. now rewrite Z.add_0_r.
  - inversion_clear plain as [| ? ? plain_b plain_w]. cbn [length] in short |- *. rewrite Nat2Z.inj_succ in *.
    cbn [fold_left]. unfold is_plain in plain_b. rewrite negb_true_iff, !orb_false_iff in plain_b.
    destruct plain_b as [[[[[[o c] m] l] t] n] e].
    unfold take_byte at 2. cbn [and_then length_of_word line_number stage_of result word]. rewrite o, c, m, l, t, n, e.
    cbn [orb]. rewrite (proj2 (Z.eqb_neq count longest_word)) by lia. rewrite IH by (trivial; lia).
    cbn [rev]. rewrite <- app_assoc. cbn [app]. do 2 f_equal. lia.
Qed.

Lemma words_are_taken (w : text) (b line : Z) (p : stage) (r : so_far) : is_word w -> is_plain b = false ->
  b <> new_line ->
  fold_left take_byte (w ++ [b]) (taken_to line p r) =
    and_then (go_on (reading_at line p r) w) (fun s =>
      if (b =? opening_sign) || (b =? closing_sign) || (b =? comma_sign) then go_on s [b] else inl s).
Proof.
  intros (some & plain & short) symbol same_line. rewrite fold_left_app. unfold taken_to, reading_at.
  rewrite plain_bytes_are_taken by trivial. rewrite app_nil_r. cbn [fold_left]. unfold take_byte. cbn [and_then].
  assert (ends : forall s, word s = rev w -> end_word s = go_on s w).
  { intros s its_word. unfold end_word. rewrite its_word. destruct (rev w) as [| c l] eqn:turned.
    - destruct some. now rewrite <- (rev_involutive w), turned.
    - now rewrite reversed_as_rev, <- turned, rev_involutive. }
  rewrite !ends by reflexivity. unfold is_plain in symbol. apply negb_false_iff in symbol.
  destruct ((b =? opening_sign) || (b =? closing_sign) || (b =? comma_sign)) eqn:listed; [reflexivity |].
  destruct ((b =? blank_sign) || (b =? tab) || (b =? carriage_return)) eqn:between.
  - unfold go_on. cbn [line_number stage_of result]. destruct (take_word p r w) as [[] |]; reflexivity.
  - exfalso. apply Z.eqb_neq in same_line. rewrite same_line, orb_false_r in symbol.
    rewrite !orb_false_iff in between. destruct between as [[l t] e].
    rewrite l, t, e in symbol. discriminate.
Qed.

Lemma symbols_are_taken (b line : Z) (p : stage) (r : so_far) :
  (b =? opening_sign) || (b =? closing_sign) || (b =? comma_sign) = true ->
  take_byte (taken_to line p r) b = go_on (reading_at line p r) [b].
Proof. intros symbol. unfold take_byte, taken_to. cbn [and_then]. now rewrite symbol. Qed.

Lemma blank_is_taken (line : Z) (p : stage) (r : so_far) : take_byte (taken_to line p r) blank_sign = taken_to line p r.
Proof. reflexivity. Qed.

(** Numbers are words *)

Definition is_printable_number (q : Q) : Prop := Qred q = q /\ Z.of_nat (length (printed_number q)) <= longest_word.

Lemma digits_are_plain (digits : list Z) : Forall is_digit digits ->
  Forall (fun b => is_plain b = true) (printed_digits digits).
Proof.
  intros all. unfold printed_digits. rewrite reversed_as_rev. apply Forall_map, Forall_rev.
  refine (Forall_impl _ _ all). intros d range. unfold is_digit in range.
  unfold is_plain. change digit_0 with 48. change opening_sign with 40. change closing_sign with 41.
  change comma_sign with 44.
  change blank_sign with 32. change tab with 9. change carriage_return with 13. change new_line with 10.
  rewrite !(proj2 (Z.eqb_neq (48 + d) _)) by lia. reflexivity.
Qed.

Lemma some_digits (digits : list Z) : digits <> [] -> printed_digits digits <> [].
Proof.
  intros some none. apply some. unfold printed_digits in none. rewrite reversed_as_rev in none.
  apply map_eq_nil in none.
  now rewrite <- (rev_involutive digits), none.
Qed.

Lemma printed_numbers_are_words (q : Q) : is_printable_number q -> is_word (printed_number q).
Proof.
  intros [_ short]. split; [| split; [| exact short]]; clear short; unfold printed_number; generalize (Qred q);
    clear q; intros q;
    unfold printed_in_lowest_terms.
  - destruct (digits_of_natural_are (Z.abs (Qnum q))) as (_ & _ & some); [lia |]. apply some_digits in some.
    intros none. apply app_eq_nil in none. destruct none as [_ none].
    destruct (decimals_of _); try (apply app_eq_nil in none; tauto).
    destruct (_ =? 0); [| apply app_eq_nil in none; tauto]. unfold printed_decimal in none.
    apply app_eq_nil in none. destruct none as [_ none]. discriminate.
  - apply Forall_app. split; [destruct (_ <? 0); repeat constructor |].
    assert (of_natural : forall n, 0 <= n -> Forall (fun b => is_plain b = true) (printed_digits (digits_of_natural n)))
      by (intros n sign; now apply digits_are_plain, digits_of_natural_are).
    assert (fraction : Forall (fun b => is_plain b = true) (printed_digits (digits_of_natural (Z.abs (Qnum q))) ++
      match Qden q with xH => [] | _ => slash_sign :: printed_digits (digits_of_natural (Zpos (Qden q))) end)).
    { apply Forall_app. split; [apply of_natural; lia |].
      destruct (Qden q); constructor; trivial; apply of_natural; lia. }
    destruct (decimals_of (Qden q)) as [| k |]; [exact fraction | | exact fraction].
    destruct (_ =? 0); [| exact fraction]. unfold printed_decimal. set (n := _ * _). set (count := Pos.to_nat k).
    assert (all : Forall is_digit (digits_of_natural n ++ repeat 0 (S count - length (digits_of_natural n)))).
    { apply Forall_app. split.
      - apply digits_of_natural_are. unfold n. pose proof (power_of_ten_is_positive k).
        apply Z.mul_nonneg_nonneg; [lia | apply Z.div_pos; lia].
      - apply Forall_forall. intros d D. apply repeat_spec in D. subst d. unfold is_digit. lia. }
    rewrite <- (firstn_skipn count) in all. apply Forall_app in all. destruct all as [decimals_ whole].
    apply Forall_app. split; [now apply digits_are_plain |]. constructor; [reflexivity | now apply digits_are_plain].
Qed.

Lemma number_in_printed (q : Q) : is_printable_number q -> number_in (printed_number q) = inl q.
Proof. intros [lowest _]. now rewrite printed_numbers_are_read, lowest. Qed.

(** Points *)

Definition is_printable_point (v : point) : Prop := is_printable_number (x_of v) /\ is_printable_number (y_of v).

Lemma points_are_taken (v : point) (b line : Z) (all : lists) (r : so_far) : is_printable_point v ->
  b = comma_sign \/ b = closing_sign ->
  fold_left take_byte (printed_point v ++ [b]) (taken_to line (X all) r) =
    go_on (reading_at line (Next all Points) (with_vertex r (x_of v) (y_of v))) [b].
Proof.
  intros [printable_x printable_y] symbol. unfold printed_point.
  change (printed_number (x_of v) ++ blank_sign :: ?w) with (printed_number (x_of v) ++ [blank_sign] ++ w).
  rewrite app_assoc, <- app_assoc, fold_left_app.
  rewrite words_are_taken by first [now apply printed_numbers_are_words | reflexivity | discriminate].
  unfold go_on at 1. cbn [reading_at stage_of result line_number take_word with_number]. unfold with_number.
  rewrite number_in_printed by trivial. cbn [and_then].
  change ((blank_sign =? opening_sign) || (blank_sign =? closing_sign) || (blank_sign =? comma_sign)) with false.
  cbv iota.
  change (inl (Reading line [] 0 (Y all (x_of v)) r)) with (taken_to line (Y all (x_of v)) r).
  rewrite words_are_taken;
    [| now apply printed_numbers_are_words | destruct symbol as [-> | ->]; reflexivity | destruct symbol as [-> | ->];
      discriminate].
  unfold go_on at 1. cbn [reading_at stage_of result line_number take_word with_number]. unfold with_number.
  rewrite number_in_printed by trivial. cbn [and_then]. destruct symbol as [-> | ->]; reflexivity.
Qed.

Lemma lists_of_points_are_taken (line : Z) (all : lists) (points : chain) : forall v r,
  Forall is_printable_point (v :: points) ->
  fold_left take_byte (printed_point v ++ after_commas (map printed_point points) ++ [closing_sign])
    (taken_to line (X all) r) =
    go_on (reading_at line (Next all Points) (SoFar (chains r) (rev points ++ v :: ring_so_far r) (is_hole r)
      (beside r)))
      [closing_sign].
Proof.
  induction points as [| u points IH]; intros v r printable; inversion_clear printable as [| ? ? printable_v others].
  - cbn [map after_commas app]. rewrite points_are_taken by (trivial; now right). now destruct v.
  - cbn [map after_commas]. change ((comma_sign :: blank_sign :: ?w) ++ ?rest) with ([comma_sign] ++ blank_sign ::
      (w ++ rest)).
    rewrite app_assoc, fold_left_app, points_are_taken by (trivial; now left).
    change (go_on _ [comma_sign]) with (taken_to line (X all) (with_vertex r (x_of v) (y_of v))).
    cbn [fold_left]. rewrite blank_is_taken, <- app_assoc, IH by trivial. unfold with_vertex.
    cbn [chains ring_so_far is_hole beside rev]. rewrite <- app_assoc. now destruct v.
Qed.

(** Rings *)

Definition is_printable_chain (counterclockwise : bool) (c : chain) : Prop :=
  oriented counterclockwise c = Some c /\ Forall is_printable_point c.

Lemma oriented_chains_are_some (counterclockwise : bool) (c : chain) : oriented counterclockwise c = Some c -> c <> [].
Proof. now intros some ->. Qed.

Lemma points_compared_refl (v : point) : points_compared v v = Eq.
Proof.
  assert (same : forall q, (q ?= q)%Q = Eq) by (intros q; now apply (proj1 (Qeq_alt q q))).
  unfold points_compared. now rewrite !same.
Qed.

(* A polygon or a list of polygons. *)
Definition is_of_region (all : lists) : Prop := all = Polygons \/ all = Rings.

Lemma rings_are_taken (line : Z) (all : lists) (c : chain) (r : so_far) : is_of_region all ->
  is_printable_chain (negb (is_hole r)) c ->
  ring_so_far r = [] ->
  fold_left take_byte (printed_ring c) (taken_to line (Opening all Points) r) =
    taken_to line (after_list all Points) (SoFar (c :: chains r) [] true (beside r)).
Proof.
  intros of_region_ [is_oriented printable] none. pose proof (oriented_chains_are_some _ _ is_oriented) as some.
  destruct c as [| first rest]; [easy |]. unfold printed_ring. cbn [printed_list app fold_left].
  rewrite symbols_are_taken by reflexivity. change (go_on _ [opening_sign]) with (taken_to line (X all) r).
  rewrite lists_of_points_are_taken.
  - rewrite rev_app_distr, none. unfold go_on. cbn [reading_at stage_of result line_number take_word].
    change (is_symbol comma_sign [closing_sign]) with false. change (is_symbol closing_sign [closing_sign]) with true.
    cbv iota. replace (with_list all) with with_ring by (now destruct of_region_ as [-> | ->]).
    unfold with_ring. cbn [rev app ring_so_far].
    assert (others : exists v l, rev rest ++ [first] = v :: l) by (destruct (rev rest); now eexists _, _).
    destruct others as (v & l & is_). rewrite is_, <- is_, last_last, points_compared_refl.
    rewrite reversed_as_rev, rev_app_distr, rev_involutive. cbn [rev app]. unfold with_chain.
    cbn [is_hole chains beside].
    now rewrite is_oriented.
  - inversion_clear printable as [| ? ? printable_first others]. constructor; [exact printable_first |].
    apply Forall_app. split; [exact others | now constructor].
Qed.

Lemma lists_of_rings_are_taken (line : Z) (all : lists) (holes : list chain) : is_of_region all -> forall c r,
  is_printable_chain (negb (is_hole r)) c -> Forall (is_printable_chain false) holes -> ring_so_far r = [] ->
  fold_left take_byte (printed_ring c ++ after_commas (map printed_ring holes) ++ [closing_sign])
    (taken_to line (Opening all Points) r) =
    taken_to line (after_list all Rings) (SoFar (rev holes ++ c :: chains r) [] true (beside r)).
Proof.
  intros lists_. induction holes as [| hole holes IH]; intros c r printable others none; rewrite fold_left_app;
    rewrite rings_are_taken by trivial;
    (replace (after_list all Points) with (Next all Rings) by (now destruct lists_ as [-> | ->])).
  - cbn [map after_commas app fold_left]. rewrite symbols_are_taken by reflexivity. reflexivity.
  - inversion_clear others as [| ? ? printable_hole more]. cbn [map after_commas app fold_left].
    rewrite symbols_are_taken by reflexivity.
    match goal with |- context [go_on ?s [comma_sign]] =>
      change (go_on s [comma_sign]) with (taken_to line (Opening all Points) (result s)) end.
    cbn [reading_at result]. rewrite blank_is_taken, <- app_assoc. rewrite IH by trivial.
    cbn [chains beside rev]. now rewrite <- app_assoc.
Qed.

(** Polygons *)

Definition is_printable_polygon (p : chain * list chain) : Prop :=
  is_printable_chain true (fst p) /\ Forall (is_printable_chain false) (snd p).

Definition chains_in (p : chain * list chain) : polygonal_region := fst p :: snd p.

Lemma polygons_are_taken (line : Z) (all : lists) (start_ : stage) (p : chain * list chain) (r : so_far) :
  is_of_region all ->
  start_ = Opening all Rings \/ start_ = Contents all /\ all = Rings -> is_printable_polygon p ->
  fold_left take_byte (printed_polygon p) (taken_to line start_ r) =
    taken_to line (after_list all Rings) (SoFar (rev (chains_in p) ++ chains r) [] true (beside r)).
Proof.
  intros lists_ starts [printable others]. destruct p as [outer holes]. cbn [fst snd] in *. unfold printed_polygon.
  cbn [fst snd printed_list fold_left]. rewrite symbols_are_taken by reflexivity.
  replace (go_on _ [opening_sign]) with (taken_to line (Opening all Points) (with_outer_chain_next r))
    by (destruct starts as [-> | [-> ->]]; reflexivity).
  rewrite lists_of_rings_are_taken by trivial. unfold chains_in. cbn [rev with_outer_chain_next chains beside].
  now rewrite <- app_assoc.
Qed.

Lemma lists_of_polygons_are_taken (line : Z) (polygons : list (chain * list chain)) : forall p r,
  Forall is_printable_polygon (p :: polygons) ->
  fold_left take_byte (printed_polygon p ++ after_commas (map printed_polygon polygons) ++ [closing_sign])
    (taken_to line (Opening Polygons Rings) r) =
    taken_to line Complete (SoFar (rev (flat_map chains_in (p :: polygons)) ++ chains r) [] true (beside r)).
Proof.
  induction polygons as [| q polygons IH]; intros p r printable;
    inversion_clear printable as [| ? ? printable_p others];
    rewrite fold_left_app, (polygons_are_taken line Polygons (Opening Polygons Rings) p r)
      by (trivial; now left || easy);
    cbn [after_list].
  - cbn [map after_commas app fold_left flat_map]. rewrite symbols_are_taken by reflexivity. rewrite app_nil_r.
    reflexivity.
  - cbn [map after_commas app fold_left]. rewrite symbols_are_taken by reflexivity.
    match goal with |- context [go_on ?s [comma_sign]] =>
      change (go_on s [comma_sign]) with (taken_to line (Opening Polygons Rings) (result s)) end.
    cbn [reading_at result]. rewrite blank_is_taken, <- app_assoc, IH by trivial. cbn [chains beside].
    change (flat_map chains_in (p :: q :: polygons)) with (chains_in p ++ flat_map chains_in (q :: polygons)).
    now rewrite rev_app_distr, <- app_assoc.
Qed.

(* Where keywords are read as these. *)
Lemma regions_are_taken (line : Z) (p : stage) (r : so_far) (polygons : list (chain * list chain)) : polygons <> [] ->
  Forall is_printable_polygon polygons ->
  fold_left take_byte (bytes "POLYGON ") (taken_to line p r) = taken_to line (Contents Rings) r ->
  fold_left take_byte (bytes "MULTIPOLYGON ") (taken_to line p r) = taken_to line (Contents Polygons) r ->
  fold_left take_byte (printed_region polygons) (taken_to line p r) =
    taken_to line Complete (SoFar (rev (flat_map chains_in polygons) ++ chains r) [] true (beside r)).
Proof.
  intros some printable single several. unfold printed_region.
  destruct polygons as [| polygon [| q polygons]]; [easy | |]; rewrite fold_left_app.
  - inversion_clear printable as [| ? ? printable_p _].
    etransitivity; [exact (f_equal (fold_left take_byte (printed_polygon polygon)) single) |]. clear single several.
    rewrite (polygons_are_taken line Rings (Contents Rings) polygon r); [| now right | now right | exact printable_p].
    cbn [after_list flat_map]. now rewrite app_nil_r.
  - etransitivity;
      [exact (f_equal (fold_left take_byte (printed_list printed_polygon (polygon :: q :: polygons))) several) |].
    clear single several. unfold printed_list. cbn [fold_left]. rewrite symbols_are_taken by reflexivity.
    change (go_on _ [opening_sign]) with (taken_to line (Opening Polygons Rings) r).
    now rewrite lists_of_polygons_are_taken by trivial.
Qed.

(* Theorem. *)
Theorem printed_regions_are_read (may_be_unbounded : bool) (polygons : list (chain * list chain)) :
  Forall is_printable_polygon polygons ->
  region_in may_be_unbounded (printed_polygons polygons) = inl (false, flat_map chains_in polygons).
Proof.
  intros printable. destruct polygons as [| p rest] eqn:these; [now destruct may_be_unbounded |].
  rewrite <- these in *.
  unfold region_in, printed_polygons. rewrite fold_left_app.
  change (start may_be_unbounded) with (taken_to 1 (Start may_be_unbounded) (SoFar [] [] false nothing_beside)).
  rewrite (regions_are_taken 1 (Start may_be_unbounded)); [| now rewrite these | exact printable | reflexivity ..].
  assert (complete : forall cs, at_end (fold_left take_byte [new_line]
    (taken_to 1 Complete (SoFar cs [] true nothing_beside))) = inl (false, rev cs))
    by (intros cs; now rewrite <- reversed_as_rev).
  cbn [chains beside]. now rewrite app_nil_r, complete, rev_involutive.
Qed.
