(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Where a point lies with respect to a region, computed as `lies_on` and `locate` in reference/definitions/ compute
   it (segment.cpp, region.cpp), and that it is what the words mean: on an edge; or off all edges with a positive
   winding number, which is `inside` of interiors_meet.v; or neither. *)
From Coq Require Import ZArith Lia Bool List.
From Oplus Require Import numbers convolution regions first_hit interiors_meet neighbourhoods.
Import ListNotations.

Open Scope Q_scope.

Definition between (a value b : Q) : bool :=
  (at_most a value && at_most value b) || (at_most b value && at_most value a).

Definition is_on_segment (p : vector) (s : segment) : bool :=
  between (vx (source s)) (vx p) (vx (target s)) && between (vy (source s)) (vy p) (vy (target s)) &&
  match orientation (source s) (target s) p with Eq => true | _ => false end.

Inductive location := Outside | Boundary | Inside.

Definition locate (p : vector) (r : region) : location :=
  if existsb (is_on_segment p) (region_edges r) then Boundary
  else if (0 <? winding_number p (region_edges r))%Z then Inside else Outside.

Lemma between_spec (a value b : Q) : reflect (a <= value <= b \/ b <= value <= a) (between a value b).
Proof.
  unfold between.
  destruct (at_most_spec a value), (at_most_spec value b), (at_most_spec b value), (at_most_spec value a);
    cbn; constructor; lra.
Qed.

Lemma is_on_spec (p : vector) (s : segment) : reflect (lies_on p s) (is_on_segment p s).
Proof.
  unfold is_on_segment. apply iff_reflect. rewrite !andb_true_iff. split.
  - intros (t & range & X & Y). repeat split.
    + destruct (between_spec (vx (source s)) (vx p) (vx (target s))) as [| not_between]; [reflexivity | exfalso].
      apply not_between. rewrite X. destruct (Qlt_le_dec (vx (source s)) (vx (target s))); [left | right]; split; nra.
    + destruct (between_spec (vy (source s)) (vy p) (vy (target s))) as [| not_between]; [reflexivity | exfalso].
      apply not_between. rewrite Y. destruct (Qlt_le_dec (vy (source s)) (vy (target s))); [left | right]; split; nra.
    + rewrite shifted_ray.on_its_line; [reflexivity |]. now exists t.
  - intros [[in_x in_y] line]. apply lies_on_by_signs.
    destruct (between_spec (vx (source s)) (vx p) (vx (target s))) as [x_range |]; [| discriminate].
    destruct (between_spec (vy (source s)) (vy p) (vy (target s))) as [y_range |]; [| discriminate].
    unfold orientation in line. unfold cross, dot, minus; cbn [vx vy].
    compared_numbers ((vx (target s) - vx (source s)) * (vy p - vy (source s)) ?=
      (vy (target s) - vy (source s)) * (vx p - vx (source s))); try discriminate line.
    split; [lra |].
    assert (0 <= (vx p - vx (source s)) * (vx (target s) - vx p)) by nra.
    assert (0 <= (vy p - vy (source s)) * (vy (target s) - vy p)) by nra. lra.
Qed.

Lemma is_on_one_spec (p : vector) (segments : list segment) :
  reflect (exists s, In s segments /\ lies_on p s) (existsb (is_on_segment p) segments).
Proof.
  apply iff_reflect. rewrite existsb_exists.
  split; intros (s & I & on); exists s; (split; [exact I |]); now destruct (is_on_spec p s).
Qed.

(* Theorem. `locate` returns where a point lies: on the boundary if it is a point of an edge, inside if it is on no
   edge and its winding number is positive, and outside otherwise. *)
Theorem locate_returns (p : vector) (r : region) :
  match locate p r with
  | Boundary => exists s, In s (region_edges r) /\ lies_on p s
  | Inside => inside p r
  | Outside => off p (region_edges r) /\ ~ inside p r
  end.
Proof.
  unfold locate, inside.
  destruct (is_on_one_spec p (region_edges r)) as [on | not_on]; [exact on |].
  assert (free : off p (region_edges r)) by (intros s I on; apply not_on; now exists s).
  destruct (Z.ltb_spec 0 (winding_number p (region_edges r))); [now split |].
  split; [exact free |]. lia.
Qed.
