(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Winding numbers of points on chains, as the code counts them, are those of points beside them: the shift by
   (e, e^2) of signed_crossings.v. So what holds of winding numbers off all chains holds of them everywhere. *)
From Coq Require Import ZArith Lia Bool List.
From Oplus Require Import numbers convolution shifted_ray signed_crossings small_numbers tie_rule regions.
Import ListNotations.

Open Scope Q_scope.

(* Beside each point is one off finitely many segments, with the same winding number. *)
Lemma winding_number_beside (x : vector) (segments : list segment) :
  exists y, off y segments /\ winding_number y segments = winding_number x segments.
Proof.
  destruct (some_small _ (eventually_and _ _ (shifted_off_all x segments) (same_beside x segments)))
    as (e & _ & beside).
  now exists (moved (shifted x) e).
Qed.

Lemma nowhere_negative_everywhere (r : region) :
  nowhere_negative r -> forall x, (0 <= winding_number x (region_edges r))%Z.
Proof. intros valid x. destruct (winding_number_beside x (region_edges r)) as (y & beside & <-). now apply valid. Qed.
