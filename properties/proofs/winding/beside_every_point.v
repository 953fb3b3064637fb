(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Winding numbers of points on chains, as the code counts them, are those of points beside them: the shift by
   (e, e^2) of signed_crossings.v. So what holds of winding numbers off all chains holds of them everywhere. *)
From Coq Require Import QArith Qminmax Lqa ZArith Lia Bool List.
From Oplus Require Import convolution shifted_ray signed_crossings tie_rule regions.
Import ListNotations.

Open Scope Q_scope.

Lemma crossing_beside (p : vector) (s : segment) :
  eventually (fun e => signed_crossing (moved (shifted p) e) s = signed_crossing p s).
Proof.
  pose proof (below_nearby (shifted p) (source s) (shifted_leaves_its_height p)) as source_height.
  pose proof (below_nearby (shifted p) (target s) (shifted_leaves_its_height p)) as target_height.
  pose proof (side_nearby (shifted p) s) as on_side.
  refine (eventually_implied _ _ _ (eventually_and _ _ source_height (eventually_and _ _ target_height on_side))).
  intros e ((source_is & _) & (target_is & _) & side_is).
  change (is_above (shifted p)) with true in *. cbv iota in *.
  change (vy (at_ (shifted p))) with (vy p) in *.
  unfold signed_crossing. rewrite source_is, target_is, side_is. unfold side. cbn [shifted at_ first second].
  destruct (orientation (source s) (target s) p); try reflexivity. unfold ray_crossing, at_most.
  compared_numbers (vy (source s) ?= vy p); compared_numbers (vy (target s) ?= vy p);
    cbn [Bool.eqb]; try reflexivity;
    compared_numbers (cross (minus (target s) (source s)) (Vector 1 0) ?= 0);
    unfold cross, minus in *; cbn in *; try reflexivity; exfalso; lra.
Qed.

(* Beside each point is one off finitely many segments, with the same winding number. *)
Lemma winding_number_beside (x : vector) (segments : list segment) :
  exists y, off y segments /\ winding_number y segments = winding_number x segments.
Proof.
  assert (beside : eventually (fun e => forall s, In s segments ->
    ~ lies_on (moved (shifted x) e) s /\ signed_crossing (moved (shifted x) e) s = signed_crossing x s)).
  { apply (eventually_for_all (fun s e => ~ lies_on (moved (shifted x) e) s /\
      signed_crossing (moved (shifted x) e) s = signed_crossing x s)).
    intros s _. apply eventually_and; [apply shifted_off | apply crossing_beside]. }
  destruct beside as (limit & positive_limit & beside).
  exists (moved (shifted x) ((1 # 2) * limit)).
  assert (half : forall s, In s segments -> ~ lies_on (moved (shifted x) ((1 # 2) * limit)) s /\
    signed_crossing (moved (shifted x) ((1 # 2) * limit)) s = signed_crossing x s) by (apply beside; lra).
  split.
  - intros s I. now apply half.
  - unfold winding_number. f_equal. apply map_ext_in. intros s I. now apply half.
Qed.

Lemma nowhere_negative_everywhere (r : region) :
  nowhere_negative r -> forall x, (0 <= winding_number x (region_edges r))%Z.
Proof.
  intros valid x. destruct (winding_number_beside x (region_edges r)) as (y & beside & <-). now apply valid.
Qed.
