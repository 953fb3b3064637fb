(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* A number that is printed (region_printer.v) is read (region_reader.v) as itself, in lowest terms: its digits have its
   value, whether they are added up one after another or in pairs of pairs. *)
From Coq Require Import QArith ZArith Lia Bool List.
From Oplus Require Import specification region_reader region_printer.
Import ListNotations.

Open Scope Z_scope.

Lemma reversed_as_rev {A : Type} (l : list A) : rev' l = rev l.
Proof. symmetry. apply rev_alt. Qed.

(** Digits and their value *)

Definition is_digit (d : Z) : Prop := 0 <= d < 10.

Definition value_in (base : Z) (digits : list Z) : Z := fold_right (fun digit value => digit + base * value) 0 digits.

Lemma value_in_pairs (base : Z) : forall digits, value_in (base * base) (in_pairs base digits) = value_in base digits.
Proof.
  fix IH 1. intros [| low [| high digits]]; cbn; [reflexivity | ring |].
  change (low + base * high + base * base * value_in (base * base) (in_pairs base digits) =
    low + base * (high + base * value_in base digits)). rewrite IH. ring.
Qed.

Lemma value_of_digits_is (levels : nat) : forall base digits, value_of_digits levels base digits = value_in base digits.
Proof.
  induction levels as [| fewer IH]; intros base [| a [| b digits]]; cbn [value_of_digits]; try reflexivity;
    try (cbn; ring).
  rewrite IH. apply value_in_pairs.
Qed.

Lemma value_with_zeros (count : nat) : forall digits, value_in 10 (digits ++ repeat 0 count) = value_in 10 digits.
Proof.
  induction digits as [| d digits IH]; cbn [app value_in fold_right].
  - induction count as [| count IH]; [reflexivity |]. cbn [repeat fold_right]. fold (value_in 10 (repeat 0 count)).
    change (value_in 10 (repeat 0 count) = 0) in IH. now rewrite IH.
  - fold (value_in 10 (digits ++ repeat 0 count)) (value_in 10 digits). now rewrite IH.
Qed.

Lemma digits_have_the_value (levels : nat) : forall n, 0 <= n < 2 ^ Z.of_nat levels ->
  value_in 10 (decimal_digits levels n) = n /\ Forall is_digit (decimal_digits levels n).
Proof.
  induction levels as [| fewer IH]; intros n range.
  - cbn in range. split; [cbn; lia | constructor].
  - rewrite Nat2Z.inj_succ, Z.pow_succ_r in range by lia. cbn [decimal_digits].
    destruct (Z.ltb_spec n 10) as [small | large].
    + split; [cbn; lia | repeat constructor; unfold is_digit; lia].
    + destruct (IH (n / 10)) as [value_ digits].
      { split; [apply Z.div_pos; lia | apply Z.div_lt_upper_bound; lia]. }
      split.
      * cbn [value_in fold_right]. fold (value_in 10 (decimal_digits fewer (n / 10))). rewrite value_.
        pose proof (Z.div_mod n 10). lia.
      * constructor; [apply Z.mod_pos_bound; lia | exact digits].
Qed.

Lemma below_its_size (p : positive) : Zpos p < 2 ^ Z.of_nat (Pos.size_nat p).
Proof.
  induction p as [p IH | p IH |]; cbn [Pos.size_nat]; [| | reflexivity];
    rewrite Nat2Z.inj_succ, Z.pow_succ_r by lia; lia.
Qed.

Lemma digits_of_natural_are (n : Z) : 0 <= n ->
  value_in 10 (digits_of_natural n) = n /\ Forall is_digit (digits_of_natural n) /\ digits_of_natural n <> [].
Proof.
  intros sign. destruct n as [| p | p]; [repeat split; [repeat constructor; cbn; lia | discriminate] | | lia].
  cbn [digits_of_natural]. pose proof (below_its_size p).
  destruct (digits_have_the_value (Pos.size_nat p) (Zpos p)) as [value_ digits]; [lia |].
  repeat split; trivial. destruct p; cbn [Pos.size_nat decimal_digits]; destruct (_ <? 10); discriminate.
Qed.

Lemma natural_of_digits (n : Z) : 0 <= n -> natural_of (digits_of_natural n) = n.
Proof. intros sign. unfold natural_of. rewrite value_of_digits_is. now apply digits_of_natural_are. Qed.

Lemma power_of_ten_is_positive (n : positive) : 0 < power_of_ten n.
Proof. induction n as [n IH | n IH |]; cbn [power_of_ten]; nia. Qed.

(** Digits in words *)

Definition is_digit_byte (b : Z) : bool := (digit_0 <=? b) && (b <=? digit_9).

Definition starts_without_digit (w : text) : Prop := match w with b :: _ => is_digit_byte b = false | [] => True end.

Lemma digits_are_read (w : text) : starts_without_digit w -> forall digits found, Forall is_digit digits ->
  leading_digits found (map (Z.add digit_0) digits ++ w) = (rev digits ++ found, w).
Proof.
  intros after. induction digits as [| d digits IH]; intros found all.
  - cbn [map app rev]. destruct w as [| b w]; [reflexivity |]. cbn [starts_without_digit] in after.
    cbn [leading_digits].
    fold (is_digit_byte b). now rewrite after.
  - inversion_clear all as [| ? ? digit_ rest]. cbn [map app leading_digits]. fold (is_digit_byte (digit_0 + d)).
    replace (is_digit_byte (digit_0 + d)) with true.
    + replace (digit_0 + d - digit_0) with d by ring. rewrite IH by exact rest. cbn [rev]. now rewrite <- app_assoc.
    + symmetry. unfold is_digit_byte. change digit_0 with 48. change digit_9 with 57. unfold is_digit in digit_.
      apply andb_true_iff. split; apply Z.leb_le; lia.
Qed.

Lemma printed_digits_are_read (digits : list Z) (found : list Z) (w : text) : Forall is_digit digits ->
  starts_without_digit w ->
  leading_digits found (printed_digits digits ++ w) = (digits ++ found, w).
Proof.
  intros all after. unfold printed_digits. rewrite reversed_as_rev, digits_are_read; trivial.
  - now rewrite rev_involutive.
  - now apply Forall_rev.
Qed.

Lemma printed_digits_start (digits : list Z) (w : text) : Forall is_digit digits -> digits <> [] ->
  exists d rest, printed_digits digits ++ w = digit_0 + d :: rest /\ is_digit d.
Proof.
  intros all some. unfold printed_digits. rewrite reversed_as_rev. apply Forall_rev in all.
  destruct (rev digits) as [| d rest] eqn:turned.
  - destruct some. rewrite <- (rev_involutive digits), turned. reflexivity.
  - inversion_clear all as [| ? ? digit_ more]. cbn [map app]. now exists d, (map (Z.add digit_0) rest ++ w).
Qed.

(** Numbers *)

Definition signed (is_negative : bool) (body : text) : text := (if is_negative then [sign_minus] else []) ++ body.

Lemma sign_is_read (is_negative : bool) (d : Z) (rest : text) : is_digit d ->
  begins_with sign_minus (signed is_negative (digit_0 + d :: rest)) = is_negative /\
  without_sign (signed is_negative (digit_0 + d :: rest)) = digit_0 + d :: rest.
Proof.
  unfold is_digit. intros range. unfold signed, without_sign, begins_with. destruct is_negative; [split; reflexivity |].
  cbn [app tl]. change digit_0 with 48. change sign_minus with 45. change sign_plus with 43.
  rewrite (proj2 (Z.eqb_neq (48 + d) 45)), (proj2 (Z.eqb_neq (48 + d) 43)) by lia. now split.
Qed.

Lemma sign_times_size (n : Z) : (if n <? 0 then -1 else 1) * Z.abs n = n.
Proof. destruct (Z.ltb_spec n 0); lia. Qed.

Lemma fraction_is_read (q : Q) : number_in (signed (Qnum q <? 0) (printed_digits (digits_of_natural (Z.abs (Qnum q))) ++
  match Qden q with xH => [] | _ => slash_sign :: printed_digits (digits_of_natural (Zpos (Qden q))) end)) =
    inl (Qred q).
Proof.
  destruct (digits_of_natural_are (Z.abs (Qnum q))) as (_ & whole & some); [lia |].
  set (after := match Qden q with xH => [] | _ => slash_sign :: printed_digits (digits_of_natural (Zpos (Qden q))) end).
  assert (no_digit : starts_without_digit after) by (unfold after; now destruct (Qden q)).
  destruct (printed_digits_start _ after whole some) as (d & rest & starts & digit_).
  unfold number_in. rewrite starts. destruct (sign_is_read (Qnum q <? 0) d rest digit_) as [-> ->]. rewrite <- starts.
  rewrite printed_digits_are_read, app_nil_r by trivial. unfold after. destruct q as [n e]. cbn [Qnum Qden] in *.
  assert (of_one : forall below, e = below -> below <> xH ->
    (if begins_with slash_sign (slash_sign :: printed_digits (digits_of_natural (Zpos below))) then
      match digits_of_natural (Z.abs n),
        leading_digits [] (tl (slash_sign :: printed_digits (digits_of_natural (Zpos below)))) with
      | _ :: _, ((_ :: _) as below', []) =>
        match natural_of below' with
        | Zpos d' => inl (Qred ((if n <? 0 then -1 else 1) * natural_of (digits_of_natural (Z.abs n)) # d'))
        | _ => inr NoDenominator
        end
      | _, _ => inr NoNumber
      end else inr NoNumber) = inl (Qred (n # e))).
  { intros below -> _. destruct (digits_of_natural_are (Zpos below)) as (_ & all & more); [lia |].
    change (begins_with slash_sign (slash_sign :: ?w)) with true. cbn [tl].
    pose proof (printed_digits_are_read (digits_of_natural (Zpos below)) [] [] all I) as is_read.
    rewrite !app_nil_r in is_read. cbv iota. rewrite is_read.
    rewrite (natural_of_digits (Z.abs n)), sign_times_size by lia.
    destruct (digits_of_natural (Z.abs n)) as [| ? ?]; [easy |].
    destruct (digits_of_natural (Zpos below)) as [| b bs] eqn:B; [easy |]. rewrite <- B, natural_of_digits by lia.
    reflexivity. }
  destruct e as [e | e |].
  - rewrite <- (of_one (xI e)) by easy. reflexivity.
  - rewrite <- (of_one (xO e)) by easy. reflexivity.
  - change (begins_with slash_sign []) with false. change (begins_with full_stop []) with false. cbv iota zeta.
    rewrite Z.sub_diag. destruct (digits_of_natural (Z.abs n)) as [| b bs] eqn:B; [easy |]. rewrite <- B.
    rewrite natural_of_digits, sign_times_size by lia. cbn [times_power_of_ten Z.opp]. f_equal.
    unfold Qred, inject_Z. pose proof (Z.ggcd_gcd n 1) as gcd. pose proof (Z.ggcd_correct_divisors n 1) as parts.
    destruct (Z.ggcd n 1) as (g & a & c). cbn [fst] in gcd. rewrite Z.gcd_1_r in gcd. subst g.
    destruct parts as [n_is one]. rewrite Z.mul_1_l in n_is, one. subst a c. reflexivity.
Qed.

Lemma decimal_is_read (q : Q) (k : positive) : power_of_ten k mod Zpos (Qden q) = 0 ->
  number_in (signed (Qnum q <? 0) (printed_decimal (Z.abs (Qnum q) * (power_of_ten k / Zpos (Qden q))) k)) =
    inl (Qred q).
Proof.
  intros divides. set (m := power_of_ten k / Zpos (Qden q)). pose proof (power_of_ten_is_positive k) as power.
  assert (power_is : power_of_ten k = Zpos (Qden q) * m) by (unfold m;
    pose proof (Z.div_mod (power_of_ten k) (Zpos (Qden q))); lia).
  assert (0 < m) by nia. unfold printed_decimal.
  destruct (digits_of_natural_are (Z.abs (Qnum q) * m)) as (value_ & digits & some); [nia |].
  set (count := Pos.to_nat k). set (all := digits_of_natural _ ++ repeat 0 _).
  assert (all_digits : Forall is_digit all).
  { apply Forall_app. split; [exact digits |]. apply Forall_forall. intros d D. apply repeat_spec in D. subst d.
    unfold is_digit. lia. }
  assert (long : (count < length all)%nat) by (unfold all; rewrite app_length, repeat_length; lia).
  rewrite <- (firstn_skipn count all) in all_digits. apply Forall_app in all_digits.
  destruct all_digits as [decimals_ whole].
  assert (whole_some : skipn count all <> []) by (intros none; apply (f_equal (@length Z)) in none;
    rewrite skipn_length in none; cbn in none; lia).
  destruct (printed_digits_start _ (full_stop :: printed_digits (firstn count all)) whole whole_some) as (d & rest &
    starts & digit_).
  unfold number_in. rewrite starts. destruct (sign_is_read (Qnum q <? 0) d rest digit_) as [-> ->]. rewrite <- starts.
  rewrite printed_digits_are_read, app_nil_r by first [exact whole | reflexivity].
  change (begins_with slash_sign (full_stop :: ?w)) with false.
  change (begins_with full_stop (full_stop :: ?w)) with true.
  cbn [tl]. cbv iota.
  pose proof (printed_digits_are_read (firstn count all) (skipn count all) [] decimals_ I) as is_read.
  rewrite app_nil_r, firstn_skipn in is_read. rewrite is_read. cbv iota zeta.
  replace (Z.of_nat (length all) - Z.of_nat (length (skipn count all))) with (Zpos k)
    by (rewrite skipn_length; unfold count in *; lia).
  assert (natural_of all = Z.abs (Qnum q) * m) as ->.
  { unfold natural_of. rewrite value_of_digits_is. unfold all. now rewrite value_with_zeros. }
  destruct all as [| a l]; [cbn in long; lia |]. rewrite Z.mul_assoc, sign_times_size. cbn [Z.opp times_power_of_ten].
  f_equal.
  apply Qred_complete. unfold Qeq. cbn [Qnum Qden]. rewrite Z2Pos.id by lia. rewrite power_is. ring.
Qed.

Lemma printed_in_lowest_terms_is_read (q : Q) : number_in (printed_in_lowest_terms q) = inl (Qred q).
Proof.
  unfold printed_in_lowest_terms. destruct (decimals_of (Qden q)) as [| k |];
    [apply fraction_is_read | | apply fraction_is_read].
  destruct (Z.eqb_spec (power_of_ten k mod Zpos (Qden q)) 0) as [divides |]; [| apply fraction_is_read].
  now apply decimal_is_read.
Qed.

(* Theorem. *)
Theorem printed_numbers_are_read (q : Q) : number_in (printed_number q) = inl (Qred q).
Proof. unfold printed_number. rewrite printed_in_lowest_terms_is_read. f_equal. apply Qred_complete, Qred_correct. Qed.
