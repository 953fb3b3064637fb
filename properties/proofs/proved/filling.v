(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The boundary of a set, of pieces of segments: those that have the set on one side only, directed so that it is on
   their left. Programs; what they return is proved in kept_pieces_go_round.v and the files after it. *)
From Coq Require Import QArith ZArith Bool List.
From Oplus Require Import direction winding_number shifted_ray regions location pieces.
Import ListNotations.

Open Scope Q_scope.

(* Equal numbers become the same number. *)
Definition reduced_vector (v : vector) : vector := Vector (Qred (vx v)) (Qred (vy v)).

(* One of the two directions. *)
Definition undirected (e : segment) : segment :=
  let a := reduced_vector (source e) in
  let b := reduced_vector (target e) in
  match compare_points a b with Gt => Segment b a | _ => Segment a b end.

Definition number_dec (a b : Q) : {a = b} + {a <> b}.
Proof. repeat decide equality. Defined.

Definition vector_dec (a b : vector) : {a = b} + {a <> b}.
Proof.
  destruct a as [a c], b as [b d]. destruct (number_dec a b), (number_dec c d); [left; congruence | right;
    congruence ..].
Defined.

Definition segment_dec (s t : segment) : {s = t} + {s <> t}.
Proof.
  destruct s as [a c], t as [b d]. destruct (vector_dec a b), (vector_dec c d); [left; congruence | right;
    congruence ..].
Defined.

Definition pieces_of (segments : list segment) : list segment :=
  nodup segment_dec (flat_map (fun s => map undirected (cut_where_met s segments)) segments).

(* Given whether the set is to the right of a piece. *)
Definition kept_piece (right_inside : segment -> bool) (e : segment) : list segment :=
  match right_inside (reversed e), right_inside e with
  | true, false => [e]
  | false, true => [reversed e]
  | _, _ => []
  end.

Definition kept_pieces (right_inside : segment -> bool) (pieces : list segment) : list segment :=
  flat_map (kept_piece right_inside) pieces.

(* A rule says by the winding numbers of several lists of closed segments whether a point is in the set. *)
Definition right_by_rule (rule : list Z -> bool) (families : list (list segment)) (e : segment) : bool :=
  rule (map (winding_number_shifted (right_of_middle e)) families).

Definition boundary_by_rule (rule : list Z -> bool) (families : list (list segment)) : list segment :=
  kept_pieces (right_by_rule rule families) (pieces_of (concat families)).

(* What closed segments go round: where the winding number is positive. *)
Definition is_right_inside (segments : list segment) (e : segment) : bool :=
  (0 <? winding_number_shifted (right_of_middle e) segments)%Z.

Definition filled (segments : list segment) : list segment :=
  kept_pieces (is_right_inside segments) (pieces_of segments).
