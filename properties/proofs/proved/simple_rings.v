(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Chains that pass a point several times are cut into rings that do not, as files have them: whenever a walk along
   the chain comes to a point where it has been, what it has gone since is a ring. The edges stay. *)
From Coq Require Import QArith Bool List Permutation.
From Oplus Require Import balanced_edges distinct direction winding_number in_out_degree regions filling walks.
Import ListNotations.

(* What has been gone since v, the last place first, and before. *)
Fixpoint gone_since (v : vector) (gone : list vector) : option (list vector * list vector) :=
  match gone with
  | [] => None
  | a :: before =>
    if vector_dec a v then Some ([], before)
    else match gone_since v before with Some (since, rest) => Some (a :: since, rest) | None => None end
  end.

Fixpoint rings_of (gone to_go : list vector) : list (list vector) :=
  match to_go with
  | [] => match gone with [] => [] | _ => [rev gone] end
  | v :: rest =>
    match gone_since v gone with
    | None => rings_of (v :: gone) rest
    | Some (since, before) => (v :: rev since) :: rings_of (v :: before) rest
    end
  end.

Definition simple_rings (r : region) : region := flat_map (rings_of []) r.

Lemma gone_since_is (v : vector) (gone : list vector) : match gone_since v gone with
  | Some (since, before) => gone = since ++ v :: before
  | None => ~ In v gone
  end.
Proof.
  induction gone as [| a gone IH]; cbn [gone_since]; [intros [] |]. destruct (vector_dec a v) as [-> | other];
    [reflexivity |].
  destruct (gone_since v gone) as [[since before] |]; [now rewrite IH | intros [is_v | I]; contradiction].
Qed.

Lemma a_ring_apart (l m rest : list vector) (v : vector) :
  Permutation (edges (v :: m) ++ edges (l ++ v :: rest)) (edges (l ++ v :: m ++ v :: rest)).
Proof.
  enough (all : forall z, Permutation (path (v :: m) v ++ path (l ++ v :: rest) z) (path (l ++ v :: m ++ v :: rest) z)).
  { destruct l as [| a l]; cbn [app] in *; rewrite !edges_are_a_path; apply all. }
  intros z. rewrite !path_of_both, app_comm_cons, path_of_both. apply Permutation_app_swap_app.
Qed.

Lemma rings_have_the_edges (to_go : list vector) : forall gone,
  Permutation (region_edges (rings_of gone to_go)) (edges (rev gone ++ to_go)).
Proof.
  induction to_go as [| v rest IH]; intros gone; cbn [rings_of].
  - rewrite app_nil_r. destruct gone as [| a gone]; [reflexivity |]. cbn [region_edges flat_map]. now rewrite app_nil_r.
  - pose proof (gone_since_is v gone) as found. destruct (gone_since v gone) as [[since before] |].
    + subst gone. cbn [region_edges flat_map]. fold (region_edges (rings_of (v :: before) rest)). rewrite IH. cbn [rev].
      rewrite rev_app_distr. cbn [rev]. rewrite <- !app_assoc. cbn [app]. apply a_ring_apart.
    + rewrite IH. cbn [rev]. now rewrite <- app_assoc.
Qed.

(* Theorem. *)
Theorem simple_rings_have_the_edges (r : region) : Permutation (region_edges (simple_rings r)) (region_edges r).
Proof.
  unfold simple_rings, region_edges. induction r as [| c r IH]; [reflexivity |]. cbn [flat_map]. rewrite flat_map_app.
  apply Permutation_app; [exact (rings_have_the_edges c []) | exact IH].
Qed.

(* Theorem. No ring passes a point twice. *)
Theorem rings_are_simple (to_go : list vector) : forall gone ring, NoDup gone -> In ring (rings_of gone to_go) ->
  NoDup ring.
Proof.
  induction to_go as [| v rest IH]; intros gone ring distinct_ I; cbn [rings_of] in I.
  - destruct gone as [| a gone]; [destruct I | destruct I as [<- | []]]. now apply NoDup_rev.
  - pose proof (gone_since_is v gone) as found. destruct (gone_since v gone) as [[since before] |].
    + subst gone. pose proof (NoDup_remove_1 _ _ _ distinct_) as both.
      pose proof (NoDup_remove_2 _ _ _ distinct_) as new. rewrite in_app_iff in new. destruct I as [<- | I].
      * constructor; [rewrite <- in_rev; tauto |]. apply NoDup_rev, (NoDup_second _ before).
        exact (Permutation_NoDup (Permutation_app_comm since before) both).
      * apply (IH (v :: before) ring); [| exact I]. constructor; [tauto | exact (NoDup_second _ since before both)].
    + apply (IH (v :: gone) ring); [now constructor | exact I].
Qed.

Lemma rings_are_not_empty (to_go : list vector) : forall gone ring, In ring (rings_of gone to_go) -> ring <> [].
Proof.
  induction to_go as [| v rest IH]; intros gone ring I; cbn [rings_of] in I.
  - destruct gone as [| a gone]; [destruct I | destruct I as [<- | []]]. cbn [rev]. now destruct (rev gone).
  - destruct (gone_since v gone) as [[since before] |]; [destruct I as [<- | I]; [discriminate |] |]; now apply IH in I.
Qed.
