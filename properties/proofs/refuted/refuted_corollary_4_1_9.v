(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Corollary 4.1.9 is false as printed: two simple polygons of n and m vertices need not have a convolution cycle of n
   + m segments. The convolution of the triangle and the arrow head of no_short_cycle.v is one cycle of 10 segments
   that passes no point twice, so every closed walk in it has a multiple of 10 segments, and not 7. What holds is
   proved in corollary_4_1_9.v: each cycle that is traced goes round both chains whole numbers of times, and one of
   them goes round both, so it has n + m segments or more; two convex polygons have one cycle, of n + m segments. *)
From Coq Require Import QArith Lia List Permutation.
From Oplus Require Import convolution tracing balanced_graph convolution_graph no_short_cycle sizes_of_cycles
  corollary_4_1_9 small_polygons simple_chain polygons_of_the_thesis drawn_regions.
Import ListNotations.

Open Scope nat_scope.

(* A convolution cycle (Definition 4.1.1) is a closed walk from point to point along convolution segments. *)
Definition corollary_4_1_9_as_printed : Prop :=
  forall p q, simple_polygon p -> simple_polygon q ->
    exists cycle a, cycle <> [] /\ incl cycle (segments_of_regions [p] [q]) /\
      leads starts_at_node ends_at_node a cycle a /\ length cycle = length p + length q.

(* Numbers of the points of the one cycle, in its order. *)
Fixpoint rank_among (v : vector) (l : list vector) : nat :=
  match l with [] => 0 | u :: rest => if vector_eq_dec u v then 0 else S (rank_among v rest) end.
Definition points_of_the_cycle : list vector :=
  match their_segments with [] => [] | s :: _ => map starts_at_node (reached 10 s) end.
Definition rank_of (v : vector) : nat := rank_among v points_of_the_cycle.

Lemma each_segment_leads_on (s : segment_of_regions) :
  In s their_segments -> rank_of (ends_at_node s) = (rank_of (starts_at_node s) + 1) mod 10.
Proof.
  assert (checked : forallb (fun s => rank_of (ends_at_node s) =? (rank_of (starts_at_node s) + 1) mod 10)
    their_segments = true) by (vm_compute; reflexivity).
  rewrite forallb_forall in checked. intros I. now apply Nat.eqb_eq, checked.
Qed.

Lemma walks_go_round (c : list segment_of_regions) : forall a b, incl c their_segments ->
  leads starts_at_node ends_at_node a c b -> (rank_of a + length c) mod 10 = rank_of b mod 10.
Proof.
  induction c as [| s c IH]; intros a b within_ walk; cbn [leads length] in *.
  - subst b. now rewrite Nat.add_0_r.
  - destruct walk as [<- walk]. rewrite <- (IH _ _ (fun t I => within_ t (or_intror I)) walk).
    rewrite (each_segment_leads_on s) by (apply within_; now left).
    rewrite Nat.add_mod_idemp_l by discriminate. f_equal. lia.
Qed.

(* Theorem. *)
Theorem corollary_4_1_9_is_false_as_printed : ~ corollary_4_1_9_as_printed.
Proof.
  intros printed. destruct (printed some_triangle dart) as (cycle & a & some & within_ & walk & size).
  - split; [apply is_simple_decides |]; vm_compute; reflexivity.
  - split; [apply is_simple_decides |]; vm_compute; reflexivity.
  - pose proof (walks_go_round cycle a a within_ walk) as round. unfold segment_of_regions in round.
    rewrite size in round. change (length some_triangle + length dart) with 7 in round.
    pose proof (Nat.div_mod (rank_of a + 7) 10). pose proof (Nat.div_mod (rank_of a) 10).
    pose proof (Nat.mod_upper_bound (rank_of a) 10). lia.
Qed.

(* Theorem, Corollary 4.1.9 as corrected. *)
Theorem corollary_4_1_9_as_corrected (p q : list vector) : simple p -> simple q ->
  exists cycles,
    trace_cycles (length p) (length q) (in_convolution p q) = Some cycles /\
    Permutation (concat cycles) (convolution p q) /\
    (forall cycle, In cycle cycles ->
       exists a b, length cycle = a * length p + b * length q /\
                   steps_of_p (map fst cycle) = a * length p /\
                   steps_of_q (map fst cycle) = b * length q /\ (a <> 0 \/ b <> 0)) /\
    (exists cycle, In cycle cycles /\
       length p <= steps_of_p (map fst cycle) /\ length q <= steps_of_q (map fst cycle)) /\
    length p + length q <= length (convolution p q).
Proof. exact (cycles_of_simple_chains p q). Qed.

(* Theorem. Convex polygons are as printed. *)
Theorem corollary_4_1_9_for_convex_polygons (p q : list vector) :
  simple p -> simple q -> reflex_vertices p = 0 -> reflex_vertices q = 0 ->
  exists cycle,
    trace_cycles (length p) (length q) (in_convolution p q) = Some [cycle] /\ length cycle = length p + length q.
Proof. exact (one_cycle_of_convex_chains p q). Qed.

(* The square and the diamond have one cycle, of 8 segments. *)
Example square_and_diamond :
  exists cycle, trace_cycles 4 4 (in_convolution square fitting_diamond) = Some [cycle] /\ length cycle = 8.
Proof.
  apply (corollary_4_1_9_for_convex_polygons square fitting_diamond); [apply drawn_polygons .. | |];
    vm_compute; reflexivity.
Qed.
