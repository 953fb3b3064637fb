(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* What most proofs are about: directions, their angles, their cyclic order. *)
From Oplus Require Export direction angle cyclic_order rotation.
