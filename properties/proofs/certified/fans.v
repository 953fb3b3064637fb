(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Convex polygons of the checker (checker.v) are fans of triangles: a point to the left of all sides of a polygon is in
   a triangle of its first corner and a side, so it is a sum of three corners with weights. Conversely such a sum is
   in the polygon if it is convex. The same is true of polygons of which any corner has a fan. *)
From Coq Require Import QArith Lqa Qfield ZArith Lia Bool List Setoid.
From Oplus Require Import direction angular_crossings winding_number specification checker homogeneous_points.
Import ListNotations.

Open Scope Q_scope.

(** Triangles *)

(* x is in the closed triangle a b c, counterclockwise. *)
Definition in_triangle (a b c x : vector) : Prop := 0 <= turn_of a b x /\ 0 <= turn_of b c x /\ 0 <= turn_of c a x.

(* x is the sum of a, b and c with these weights. *)
Definition is_combination (p q r : Q) (a b c x : vector) : Prop :=
  vx x == p * vx a + q * vx b + r * vx c /\ vy x == p * vy a + q * vy b + r * vy c.

Definition are_weights (p q r : Q) : Prop := 0 <= p /\ 0 <= q /\ 0 <= r /\ p + q + r == 1.

Lemma in_triangle_is_combination (a b c x : vector) :
  0 < turn_of a b c -> in_triangle a b c x -> exists p q r, are_weights p q r /\ is_combination p q r a b c x.
Proof.
  intros turns_left (of_c & of_a & of_b).
  assert (turns : forall q, 0 <= q -> 0 <= q / turn_of a b c).
  { intros q not_negative. apply Qle_shift_div_l; [assumption | now rewrite Qmult_0_l]. }
  exists (turn_of b c x / turn_of a b c), (turn_of c a x / turn_of a b c), (turn_of a b x / turn_of a b c).
  unfold are_weights. repeat split; auto; unfold turn_of in *; field; lra.
Qed.

Lemma value_at_combination (p q r : Q) (l : line) (a b c x : vector) :
  are_weights p q r -> is_combination p q r a b c x ->
  value_at l x == p * value_at l a + q * value_at l b + r * value_at l c.
Proof.
  intros (_ & _ & _ & total) [x_is y_is]. unfold value_at. rewrite x_is, y_is.
  assert (r_is : r == 1 - p - q) by lra. rewrite r_is. ring.
Qed.

(* If three points are to the left of a line or on it, so is a sum of them with weights. *)
Lemma combination_is_left (p q r : Q) (l : line) (a b c x : vector) :
  are_weights p q r -> is_combination p q r a b c x ->
  0 <= value_at l a -> 0 <= value_at l b -> 0 <= value_at l c -> 0 <= value_at l x.
Proof.
  intros weights combination a_left b_left c_left. rewrite (value_at_combination _ _ _ _ _ _ _ _ weights combination).
  destruct weights as (p_sign & q_sign & r_sign & _).
  pose proof (Qmult_le_0_compat _ _ p_sign a_left). pose proof (Qmult_le_0_compat _ _ q_sign b_left).
  pose proof (Qmult_le_0_compat _ _ r_sign c_left). lra.
Qed.

Lemma combination_is_inside (p q r : Q) (t : piece) (a b c x : vector) :
  are_weights p q r -> is_combination p q r a b c x -> inside_piece t a -> inside_piece t b -> inside_piece t c -> inside_piece t x.
Proof.
  intros weights combination a_in b_in c_in l side.
  exact (combination_is_left _ _ _ _ _ _ _ _ weights combination (a_in l side) (b_in l side) (c_in l side)).
Qed.

(** Sides *)

Lemma turn_of_is_value_at (a b : hpoint) (x : vector) :
  0 <= value_at (line_through a b) x <-> 0 <= turn_of (vector_of a) (vector_of b) x.
Proof.
  rewrite value_of_line_through.
  assert (positive : 0 < inject_Z (Zpos (pw a)) * inject_Z (Zpos (pw b)))
    by (apply Qmult_lt_0_compat; apply positive_denominator).
  split; intros sign.
  - rewrite <- (Qmult_0_l (inject_Z (Zpos (pw a)) * inject_Z (Zpos (pw b)))) in sign.
    now apply Qmult_lt_0_le_reg_r in sign.
  - apply Qmult_le_0_compat; lra.
Qed.

Lemma left_turn_is_positive (a b c : hpoint) :
  (0 < left_turn a b c)%Z <-> 0 < turn_of (vector_of a) (vector_of b) (vector_of c).
Proof.
  unfold left_turn. rewrite value_positive, value_of_line_through.
  assert (positive : 0 < inject_Z (Zpos (pw a)) * inject_Z (Zpos (pw b)))
    by (apply Qmult_lt_0_compat; apply positive_denominator).
  split; intros sign.
  - rewrite <- (Qmult_0_l (inject_Z (Zpos (pw a)) * inject_Z (Zpos (pw b)))) in sign. now apply Qmult_lt_r in sign.
  - now apply Qmult_lt_0_compat.
Qed.

Lemma inside_is_left_of_sides (v : polygon) (x : vector) :
  inside_piece (piece_of v) x <-> forall e, In e (sides v) -> 0 <= turn_of (vector_of (fst e)) (vector_of (snd e)) x.
Proof.
  unfold inside_piece, piece_of. cbn [side_lines]. split.
  - intros left_ e side. rewrite <- turn_of_is_value_at. apply left_, in_map_iff. now exists e.
  - intros left_ l side. apply in_map_iff in side as (e & <- & side). now apply turn_of_is_value_at, left_.
Qed.

Lemma left_of_all_is_inside (t : piece) (x : hpoint) : 
  is_left_of_all (side_lines t) x = true <-> inside_piece t (vector_of x).
Proof.
  unfold is_left_of_all, inside_piece. rewrite forallb_forall.
  split; intros left_ l side; apply left_ in side; 
    [apply value_not_negative; lia | apply value_not_negative in side; lia].
Qed.

Lemma corners_are_inside (t : piece) (a : hpoint) : is_convex t = true -> In a (corners_of t) -> inside_piece t (vector_of a).
Proof.
  unfold is_convex. rewrite andb_true_iff, forallb_forall. intros [_ all_inside] corner.
  now apply left_of_all_is_inside, all_inside.
Qed.

(** The fan of the first corner *)

Fixpoint fan_triangles_of (first : hpoint) (others : polygon) : list (hpoint * hpoint * hpoint) :=
  match others with
  | b :: ((c :: _) as rest) => (first, b, c) :: fan_triangles_of first rest
  | _ => []
  end.

Definition fan_triangles (v : polygon) : list (hpoint * hpoint * hpoint) :=
  match v with
  | [] => []
  | first :: others => fan_triangles_of first others
  end.

Lemma fan_triangles_turn_left (v : polygon) (a b c : hpoint) :
  has_a_fan v = true -> In (a, b, c) (fan_triangles v) -> 0 < turn_of (vector_of a) (vector_of b) (vector_of c).
Proof.
  destruct v as [| first others]; [easy |]. intros fan. cbn [fan_triangles].
  assert (turns : fan_turns_left first others = true) by now destruct others as [| ? [|]].
  clear fan. revert turns. induction others as [| b' rest IH]; [easy |].
  destruct rest as [| c' rest]; [easy |]. cbn [fan_turns_left fan_triangles_of].
  rewrite andb_true_iff, Z.ltb_lt, left_turn_is_positive. intros [turns more] [[= <- <- <-] | later]; auto.
Qed.

Lemma fan_triangles_have_corners (v : polygon) (a b c : hpoint) :
  In (a, b, c) (fan_triangles v) -> In a v /\ In b v /\ In c v.
Proof.
  destruct v as [| first others]; [easy |]. cbn [fan_triangles]. revert first.
  induction others as [| b' rest IH]; [easy |]. intros first.
  destruct rest as [| c' rest]; [easy |]. intros [[= <- <- <-] | later]; [cbn; tauto |].
  destruct (IH first later) as (a_in & b_in & c_in). cbn [In] in *. tauto.
Qed.

(* Consecutive corners. *)
Definition consecutive_sides (v : polygon) : list hedge := combine v (tl v).

Lemma combine_with_more {A B} (l : list A) (m : list B) (more : list A) :
  length l = length m -> combine (l ++ more) m = combine l m.
Proof.
  revert m. induction l as [| a l IH]; intros [| b m] equal_; try easy; [now destruct more |].
  cbn. f_equal. apply IH. now injection equal_.
Qed.

Lemma sides_are_consecutive (first : hpoint) (rest : polygon) :
  sides (first :: rest) = consecutive_sides (first :: rest ++ [first]).
Proof.
  unfold sides, consecutive_sides. cbn [tl]. change (first :: rest ++ [first]) with ((first :: rest) ++ [first]).
  rewrite combine_with_more; [reflexivity |]. rewrite app_length. cbn. lia.
Qed.

(* Between a corner that has x on its left, seen from the first, and the end of the fan, which has x on its right. *)
Lemma inside_is_in_the_rest (first b : hpoint) (rest : polygon) (x : vector) :
  rest <> [] ->
  0 <= turn_of (vector_of first) (vector_of b) x ->
  (forall e, In e (consecutive_sides (b :: rest ++ [first])) -> 0 <= turn_of (vector_of (fst e)) (vector_of (snd e)) x) ->
  exists p q r, In (p, q, r) (fan_triangles_of first (b :: rest)) /\
    in_triangle (vector_of p) (vector_of q) (vector_of r) x.
Proof.
  revert b. induction rest as [| c rest IH]; [easy |]. intros b _ b_left sides_left.
  assert (side : 0 <= turn_of (vector_of b) (vector_of c) x) by exact (sides_left (b, c) (or_introl eq_refl)).
  assert (later : forall e, In e (consecutive_sides (c :: rest ++ [first])) ->
    0 <= turn_of (vector_of (fst e)) (vector_of (snd e)) x).
  { intros e in_rest. apply sides_left. right. exact in_rest. }
  destruct (Qlt_le_dec (turn_of (vector_of c) (vector_of first) x) 0) as [beyond | within].
  - assert (c_left : 0 <= turn_of (vector_of first) (vector_of c) x) by (unfold turn_of in *; lra).
    destruct rest as [| d rest].
    + pose proof (later (c, first) (or_introl eq_refl)) as last_side. cbn [fst snd] in last_side. lra.
    + destruct (IH c ltac:(easy) c_left later) as (p & q & r & triangle & x_in).
      exists p, q, r. split; [| assumption]. right. exact triangle.
  - exists first, b, c. split; [now left | easy].
Qed.

Theorem inside_is_in_a_fan_triangle (v : polygon) (x : vector) :
  has_a_fan v = true -> inside_piece (piece_of v) x ->
  exists a b c, In (a, b, c) (fan_triangles v) /\ in_triangle (vector_of a) (vector_of b) (vector_of c) x.
Proof.
  rewrite inside_is_left_of_sides. destruct v as [| first [| b [| c rest]]]; try easy. intros _ left_.
  rewrite sides_are_consecutive in left_.
  apply (inside_is_in_the_rest first b (c :: rest)); [easy | |].
  - exact (left_ (first, b) (or_introl eq_refl)).
  - intros e side. apply left_. right. exact side.
Qed.

(** The fan of any corner *)

Lemma turned_has_the_sides (v : polygon) (e : hedge) : In e (sides (first_moved_last v)) <-> In e (sides v).
Proof.
  destruct v as [| first [| b rest]]; try easy.
  assert (consecutive_app : forall (l : polygon) (m n : hpoint),
    consecutive_sides (l ++ [m] ++ [n]) = consecutive_sides (l ++ [m]) ++ [(m, n)]).
  { induction l as [| k l IH]; [easy |]. intros m n. specialize (IH m n). destruct l as [| j l]; [easy |].
    unfold consecutive_sides in *. cbn in *. now rewrite IH. }
  unfold first_moved_last. cbn [app]. rewrite !sides_are_consecutive.
  replace (b :: (rest ++ [first]) ++ [b]) with ((b :: rest) ++ [first] ++ [b]) by now rewrite <- app_assoc.
  rewrite consecutive_app, in_app_iff. cbn. tauto.
Qed.

Lemma turned_has_the_corners (v : polygon) (a : hpoint) : In a (first_moved_last v) <-> In a v.
Proof. destruct v as [| first rest]; [easy |]. unfold first_moved_last. rewrite in_app_iff. cbn. tauto. Qed.

Theorem inside_is_in_a_triangle (tries : nat) (v : polygon) (x : vector) :
  some_corner_has_a_fan tries v = true -> inside_piece (piece_of v) x ->
  exists a b c, In a v /\ In b v /\ In c v /\ 0 < turn_of (vector_of a) (vector_of b) (vector_of c) /\
    in_triangle (vector_of a) (vector_of b) (vector_of c) x.
Proof.
  assert (of_first : forall v, has_a_fan v = true -> inside_piece (piece_of v) x ->
    exists a b c, In a v /\ In b v /\ In c v /\ 0 < turn_of (vector_of a) (vector_of b) (vector_of c) /\
      in_triangle (vector_of a) (vector_of b) (vector_of c) x).
  { intros w fan x_in. destruct (inside_is_in_a_fan_triangle w x fan x_in) as (a & b & c & triangle & within).
    exists a, b, c. pose proof (fan_triangles_have_corners w a b c triangle).
    pose proof (fan_triangles_turn_left w a b c fan triangle). tauto. }
  revert v. induction tries as [| tries IH]; intros v; cbn [some_corner_has_a_fan]; rewrite orb_true_iff.
  - intros [fan |] x_in; [auto | easy].
  - intros [fan | fan] x_in; [auto |]. destruct (IH (first_moved_last v) fan) as (a & b & c & triangle).
    + apply inside_is_left_of_sides. intros e side. apply (proj1 (turned_has_the_sides v e)) in side.
      now apply (proj1 (inside_is_left_of_sides v x) x_in).
    + exists a, b, c. now rewrite !turned_has_the_corners in triangle.
Qed.

(* A point of a polygon is a sum of three corners with weights. *)
Corollary inside_is_combination (tries : nat) (v : polygon) (x : vector) :
  some_corner_has_a_fan tries v = true -> inside_piece (piece_of v) x ->
  exists a b c p q r, In a v /\ In b v /\ In c v /\ are_weights p q r /\
    is_combination p q r (vector_of a) (vector_of b) (vector_of c) x.
Proof.
  intros fan x_in. destruct (inside_is_in_a_triangle tries v x fan x_in)
    as (a & b & c & a_in & b_in & c_in & turns & within).
  destruct (in_triangle_is_combination _ _ _ _ turns within) as (p & q & r & combination).
  exists a, b, c, p, q, r. tauto.
Qed.

Corollary inside_convex_is_combination (t : piece) (x : vector) :
  is_convex t = true -> t = piece_of (corners_of t) -> inside_piece t x ->
  exists a b c p q r, In a (corners_of t) /\ In b (corners_of t) /\ In c (corners_of t) /\ are_weights p q r /\
    is_combination p q r (vector_of a) (vector_of b) (vector_of c) x.
Proof.
  unfold is_convex. rewrite andb_true_iff. intros [fan _] t_is x_in. rewrite t_is in x_in.
  apply (inside_is_combination 0); [| exact x_in]. cbn. now rewrite fan.
Qed.

(* What is in a triangle of corners is in the piece. *)
Corollary triangle_is_inside (t : piece) (a b c : hpoint) (x : vector) :
  is_convex t = true -> In a (corners_of t) -> In b (corners_of t) -> In c (corners_of t) ->
  0 < turn_of (vector_of a) (vector_of b) (vector_of c) -> in_triangle (vector_of a) (vector_of b) (vector_of c) x ->
  inside_piece t x.
Proof.
  intros convex a_in b_in c_in turns within.
  destruct (in_triangle_is_combination _ _ _ _ turns within) as (p & q & r & weights & combination).
  apply (combination_is_inside p q r t (vector_of a) (vector_of b) (vector_of c)); auto using corners_are_inside.
Qed.
