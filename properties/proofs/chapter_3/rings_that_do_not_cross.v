(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Whatever the set is that ends at pieces of segments: the walks along the pieces that have it on their left only, cut
   where they pass a point twice, are simple chains that do not cross. They share no edges, so they have nothing but ends
   in common; and on the right of one of them all others have one winding number (written_regions.v). *)
From Coq Require Import QArith Lqa ZArith Lia Bool List Permutation.
From Oplus Require Import regions_and_sums simple_chain valid_components collision_is_sound beside_a_piece filling
  kept_pieces_go_round cut_pieces region_of_pieces walks canonical_regions nested_chains nested_polygons written_rings
  written_regions.
Import ListNotations.

Open Scope Q_scope.

Section Rings.
  Variable segments : list segment.
  Variable inside : vector -> bool.
  Variable right_inside : segment -> bool.
  Hypothesis ends_ : ends_at_pieces inside right_inside (pieces_of segments).
  Variable kept : list segment.
  Hypothesis kept_are : Permutation kept (kept_pieces right_inside (pieces_of segments)).

  Let rings := rings_in_order (chains_of (length kept) kept).
  Let parts := kept_parts segments inside right_inside ends_ kept kept_are.
  Let take_kept := rings_take_kept segments inside right_inside ends_ kept kept_are.
  Let pass_once := rings_pass_once kept.
  Let disjoint := rings_are_disjoint segments inside right_inside ends_ kept kept_are.
  Let same_right := same_right_of_ring segments inside right_inside ends_ kept kept_are.

  Lemma rings_are_kept (a : list vector) : In a rings -> incl (edges a) kept.
  Proof. apply (edges_of_rings segments inside right_inside ends_). exact kept_are. Qed.

  Lemma kept_rings_are_simple (a : list vector) : In a rings -> simple a.
  Proof.
    intros A. destruct (pass_once a A) as [once some].
    now apply (rings_are_simple_chains kept a parts (rings_are_kept a A)).
  Qed.

  Lemma rings_are_valid : valid_region rings /\ nowhere_above_one rings.
  Proof.
    apply (same_edges_are_valid (chains_of (length kept) kept)).
    - symmetry. apply rings_in_order_have_the_edges.
    - exact (chains_are_written_of_kept segments inside right_inside ends_ kept kept_are).
  Qed.

  (* Theorem. The rings do not cross. *)
  Theorem rings_do_not_cross : do_not_cross rings.
  Proof.
    split; [| split; [exact kept_rings_are_simple | split; [exact rings_are_valid |]]].
    - apply (parts_are_distinct edges).
      + exact (edges_once segments inside right_inside ends_ kept kept_are).
      + intros a A none. destruct (some_edge kept a A) as (e & E). now rewrite none in E.
    - intros a b A B other. split.
      + intros p (s & S & on_s) (t & T & on_t).
        assert (differ : s <> t) by (intros ->; exact (disjoint a b A B other t T S)).
        destruct (inside_or_end p s on_s) as [inside_ | [equal | equal]].
        * exfalso. apply (nothing_inside _ parts s t p); trivial; [now apply (rings_are_kept a) |
            now apply (rings_are_kept b)].
        * exists s. split; [apply in_app_iff; now left | now symmetry].
        * destruct (edge_from_vertex a (target s) (proj2 (ends_of_edges a s S))) as (f & F & is_target).
          exists f. split; [apply in_app_iff; now left |]. rewrite is_target. now symmetry.
      + destruct (some_edge kept b B) as (k & K). intros p q on_p free_p on_q free_q.
        now rewrite !(number_all_along kept parts rings take_kept same_right a b _ k A B (disjoint a b A B other) K).
  Qed.
End Rings.
