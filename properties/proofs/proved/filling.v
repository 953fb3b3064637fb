(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The boundary of what closed segments go round: of the pieces into which they cut each other, those with a positive
   winding number to the left and none to the right. A program; what it returns is proved in cut_pieces.v. *)
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
Proof. destruct a as [a c], b as [b d]. destruct (number_dec a b), (number_dec c d); [left; congruence | right;
  congruence ..]. Defined.

Definition segment_dec (s t : segment) : {s = t} + {s <> t}.
Proof.
  destruct s as [a c], t as [b d]. destruct (vector_dec a b), (vector_dec c d); [left; congruence | right;
    congruence ..].
Defined.

Definition pieces_of (segments : list segment) : list segment :=
  nodup segment_dec (flat_map (fun s => map undirected (cut_where_met s segments)) segments).

(* Whether the winding number to the right of a piece is positive. *)
Definition is_right_inside (segments : list segment) (e : segment) : bool :=
  (0 <? winding_number_shifted (right_of_middle e) segments)%Z.

Definition kept_piece (segments : list segment) (e : segment) : list segment :=
  match is_right_inside segments (reversed e), is_right_inside segments e with
  | true, false => [e]
  | false, true => [reversed e]
  | _, _ => []
  end.

Definition filled (segments : list segment) : list segment := flat_map (kept_piece segments) (pieces_of segments).
