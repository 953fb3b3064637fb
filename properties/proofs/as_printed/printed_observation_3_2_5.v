(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Observation 3.2.5 as printed: what Algorithm 1 returns is a union of edge disjoint orientable loops that do not
   cross. A loop is a closed sequence of edges of the arrangement, each of which ends where the next one starts.
   Different edges have no inner points in common, unless they run along each other in opposite directions, where
   segments of the convolution do. Loops cross in a vertex if one passes from the right of the other to its left; here,
   even more, to the right of a loop's passing through a vertex no loop passes, itself included. And, as the text says,
   the loops take all edges of the boundary. The convolution is the full one, the reduced one, or anything between. It
   is proved in what_algorithm_1_traces.v, for any arrangement. *)
From Coq Require Import QArith List.
From Oplus Require Import convolution theorem_4_2_1 theorem_2_2_10 beside_every_point winding_number regions
  rule_of_sides kept_pieces_go_round beside_a_vertex beside_a_piece filling sum_is_right loops_of_the_boundary
  algorithm_1 what_algorithm_1_traces arranged_convolution
  arrangement_of_the_convolution.
Import ListNotations.

Open Scope Q_scope.

Definition orientable_edges (loop : list segment) : Prop :=
  loop <> [] /\ map target loop = rotated (map source loop).

(* Edges e and f follow each other on a loop, as e' and f' do, and all meet in a vertex. *)
Definition follows_on (loops : list (list segment)) (e f : segment) : Prop :=
  exists loop before after, In loop loops /\ loop ++ [hd e loop] = before ++ e :: f :: after.

Lemma leads_to_starts (arrangement : list segment) (l : list segment) (z : segment) :
  leads_to arrangement l (Some z) -> map target l = map source (tl (l ++ [z])).
Proof.
  induction l as [| e [| f l] IH]; intros leads; [reflexivity | |]; destruct leads as [best leads].
  - destruct (best_direction_is arrangement e z best) as (_ & starts & _). cbn. now rewrite starts.
  - destruct (best_direction_is arrangement e f best) as (_ & starts & _). specialize (IH leads).
    cbn [map app tl] in *. now rewrite IH, starts.
Qed.

Lemma leads_to_next (arrangement : list segment) (l : list segment) (z e f : segment) : forall before after,
  leads_to arrangement l (Some z) -> l ++ [z] = before ++ e :: f :: after -> best_direction arrangement e = Some f.
Proof.
  induction l as [| g l IH]; intros before after leads is_.
  - destruct before as [| b [| c before]]; discriminate.
  - destruct leads as [best leads]. destruct before as [| b before]; cbn [app] in is_.
    + injection is_ as -> is_. rewrite best.
      destruct l as [| h l]; cbn [app] in is_; injection is_ as <- _; reflexivity.
    + injection is_ as _ is_. now apply (IH before after).
Qed.

(* Theorem, Observation 3.2.5. *)
Theorem observation_3_2_5_as_printed (p q : region) (segments : list segment) :
  valid_region p -> valid_region q -> is_convolution p q segments ->
  let loops := algorithm_1 (arrangement_of segments) in
  (forall loop, In loop loops -> incl loop (arrangement_of segments) /\ orientable_edges loop) /\
  NoDup (concat loops) /\
  (forall e f x, In e (concat loops) -> In f (concat loops) -> e <> f -> e <> reversed f ->
     ~ (strictly_inside x e /\ strictly_inside x f)) /\
  (forall e f e' f', follows_on loops e f -> follows_on loops e' f' -> e <> e' -> target e = target e' ->
     ~ right_of_passing e f (along f') /\ ~ right_of_passing e f (along (reversed e'))) /\
  (forall x, on_boundary_of_sum x p q -> exists e, In e (concat loops) /\ lies_on x e).
Proof.
  intros p_region q_region convolution_. set (arrangement := arrangement_of segments). cbv zeta.
  destruct (traced_loops arrangement arrangement []) as (are_loops & once & _);
    [constructor | intros g [] | apply incl_refl |]. fold (algorithm_1 arrangement) in are_loops, once.
  pose proof (pieces_of_share_ends _ (arranged_are_long p q p_region q_region segments convolution_)) as parts.
  pose proof (arrangement_is_directed p q p_region q_region segments convolution_) as directed_.
  fold arrangement in directed_.
  assert (listed : forall e, In e (concat (algorithm_1 arrangement)) -> In e arrangement).
  { intros e E. apply in_concat in E. destruct E as (loop & L & E). now apply (are_loops loop L). }
  assert (follows : forall e f, follows_on (algorithm_1 arrangement) e f ->
    In e (concat (algorithm_1 arrangement)) /\ best_direction arrangement e = Some f).
  { intros e f (loop & before & after & L & is_). destruct (are_loops loop L) as (some & _ & _ & leads).
    destruct loop as [| g l]; [contradiction |]. cbn [hd hd_error] in *. split.
    - apply in_concat. exists (g :: l). split; [exact L |].
      assert (I : In e ((g :: l) ++ [g])) by (rewrite is_; apply in_elt). apply in_app_iff in I.
      destruct I as [I | [<- | []]]; [exact I | now left].
    - exact (leads_to_next arrangement (g :: l) g e f before after leads is_). }
  split; [| split; [exact once | split; [| split]]].
  - intros loop L. destruct (are_loops loop L) as (some & _ & part & leads). split; [exact part |].
    split; [exact some |]. destruct loop as [| g l]; [contradiction |]. cbn [hd_error] in leads.
    rewrite (leads_to_starts arrangement (g :: l) g leads). cbn [app tl map rotated]. now rewrite map_app.
  - intros e f x E F other other' [in_e in_f].
    apply (directed_are_apart _ parts e f x (directed_ e (listed e E)) (directed_ f (listed f F)) other other' in_e).
    now apply strictly_inside_lies_on.
  - intros e f e' f' passes passes' other meet.
    destruct (follows e f passes) as [E best], (follows e' f' passes') as [E' best'].
    exact (nothing_to_the_right_of_a_passing arrangement _ parts directed_ e f e' f' E E' other meet best best').
  - intros x boundary. apply (boundary_is_kept p q _ _ _ (arranged_loops_are_the_sum p q p_region q_region segments
      convolution_)) in boundary.
    destruct boundary as (e & E & on). exists e. split; [| exact on].
    exact (boundary_is_traced p q p_region q_region segments convolution_ e E).
Qed.
