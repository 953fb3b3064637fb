(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Chains that pass a point several times are cut into rings that do not, as files have them: whenever a walk along the
   chain comes to a point where it has been, what it has gone since is a ring. The edges stay, so the points do. *)
From Coq Require Import QArith Bool List Permutation.
From Oplus Require Import specification winding_number specification_bridge filling canonical_regions.
Import ListNotations.

Section Rings.
  Context {A : Type} (same_place : forall a b : A, {a = b} + {a <> b}).

  (* From one place to the next, and from the last to z. *)
  Fixpoint steps_to (l : list A) (z : A) : list (A * A) :=
    match l with [] => [] | a :: rest => (a, hd z rest) :: steps_to rest z end.

  Definition steps_around (l : list A) : list (A * A) := match l with [] => [] | a :: _ => steps_to l a end.

  (* What has been gone since v, the last place first, and before. *)
  Fixpoint gone_since (v : A) (gone : list A) : option (list A * list A) :=
    match gone with
    | [] => None
    | a :: before =>
      if same_place a v then Some ([], before)
      else match gone_since v before with Some (since, rest) => Some (a :: since, rest) | None => None end
    end.

  Fixpoint rings_of (gone to_go : list A) : list (list A) :=
    match to_go with
    | [] => match gone with [] => [] | _ => [rev gone] end
    | v :: rest =>
      match gone_since v gone with
      | None => rings_of (v :: gone) rest
      | Some (since, before) => (v :: rev since) :: rings_of (v :: before) rest
      end
    end.

  Lemma steps_through (l : list A) (v z : A) (m : list A) : steps_to (l ++ v :: m) z = steps_to l v ++ steps_to (v :: m) z.
  Proof.
    induction l as [| a l IH]; [reflexivity |]. change ((a :: l) ++ v :: m) with (a :: (l ++ v :: m)).
    cbn [steps_to]. rewrite IH. cbn [app]. f_equal. now destruct l.
  Qed.

  Lemma gone_since_is (v : A) (gone : list A) : forall since before,
    gone_since v gone = Some (since, before) -> gone = since ++ v :: before.
  Proof.
    induction gone as [| a gone IH]; intros since before; cbn [gone_since]; [discriminate |].
    destruct (same_place a v) as [-> | _]; [now intros [= <- <-] |].
    destruct (gone_since v gone) as [[s b] |]; [| discriminate]. intros [= <- <-]. now rewrite (IH s b eq_refl).
  Qed.

  Lemma a_ring_apart (l m rest : list A) (v : A) :
    Permutation (steps_around (v :: m) ++ steps_around (l ++ v :: rest)) (steps_around (l ++ v :: m ++ v :: rest)).
  Proof.
    enough (all : forall z, Permutation (steps_to (v :: m) v ++ steps_to (l ++ v :: rest) z)
      (steps_to (l ++ v :: m ++ v :: rest) z)) by (destruct l as [| a l]; apply all).
    intros z. rewrite !steps_through, app_comm_cons, steps_through. apply Permutation_app_swap_app.
  Qed.

  Lemma rings_have_the_steps (to_go : list A) : forall gone,
    Permutation (flat_map steps_around (rings_of gone to_go)) (steps_around (rev gone ++ to_go)).
  Proof.
    induction to_go as [| v rest IH]; intros gone; cbn [rings_of].
    - rewrite app_nil_r. destruct gone as [| a gone]; [reflexivity |]. cbn [flat_map]. now rewrite app_nil_r.
    - destruct (gone_since v gone) as [[since before] |] eqn:found.
      + apply gone_since_is in found. subst gone. cbn [flat_map]. rewrite IH. cbn [rev]. rewrite rev_app_distr. cbn [rev].
        rewrite <- !app_assoc. cbn [app]. apply a_ring_apart.
      + rewrite IH. cbn [rev]. now rewrite <- app_assoc.
  Qed.
End Rings.

Definition point_dec (a b : point) : {a = b} + {a <> b}.
Proof.
  destruct (vector_dec (as_vector a) (as_vector b)) as [same | other]; [left | right; congruence].
  destruct a, b. unfold as_vector in same. cbn in same. congruence.
Defined.

Definition simple_rings (r : polygonal_region) : polygonal_region := flat_map (rings_of point_dec []) r.

Lemma edges_are_steps (c : chain) : edges_of_chain c = steps_around c.
Proof.
  destruct c as [| first rest]; [reflexivity |]. cbn [edges_of_chain steps_around].
  enough (all : forall z a, combine (a :: rest) (rest ++ [z]) = steps_to (a :: rest) z) by apply all.
  intros z. induction rest as [| b rest IH]; intros a; [reflexivity |]. cbn [app combine steps_to hd]. f_equal. apply IH.
Qed.

(* Theorem. *)
Theorem simple_rings_have_the_points (r : polygonal_region) (x : point) :
  (member x (simple_rings r) <-> member x r) /\ (is_inner_point x (simple_rings r) <-> is_inner_point x r).
Proof.
  apply edges_in_another_order. unfold edges_of_region, simple_rings.
  induction r as [| c r IH]; [reflexivity |]. cbn [flat_map]. rewrite flat_map_app. apply Permutation_app; [| exact IH].
  rewrite (flat_map_ext _ _ edges_are_steps), edges_are_steps. apply rings_have_the_steps.
Qed.
