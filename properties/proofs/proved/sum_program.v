(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Regions of the specification as lists of vectors. *)
From Coq Require Import List.
From Oplus Require Import specification checker direction homogeneous_points.
Import ListNotations.

Definition as_region (r : polygonal_region) : list (list vector) :=
  map (map (fun p => vector_of (homogeneous p))) r.
