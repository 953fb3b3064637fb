(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* A region moved along a segment: where it is at first, and the parallelograms of its edges and the segment. For from
   a point of it, moved, one comes to where it is at first inside the region, or over an edge. *)
From Coq Require Import QArith Lqa ZArith Lia Bool List.
From Oplus Require Import regions_and_sums reflected parallelogram crossing_edges pieces placed_collision coordinates.
Import ListNotations.

Open Scope Q_scope.

Definition swept (b : region) (s : segment) : list (list segment) :=
  region_edges (placed (source s) (placed (Vector 0 0) b)) ::
  if same_point (source s) (target s) then [] else map (parallelogram s) (region_edges b).

Definition is_swept (b : region) (s : segment) (x : vector) : Prop :=
  exists t z, lies_on t s /\ ((exists e, In e (region_edges b) /\ lies_on z e) \/ winding_number z
    (region_edges b) <> 0%Z) /\
    equal_vectors x (plus t z).

Lemma not_on_a_side (x : vector) (e f : segment) : off x (parallelogram e f) -> not_sum_of_an_end x e f.
Proof.
  unfold parallelogram, edges. cbn [rotated app combine map fst snd]. intros free.
  repeat split; intros (k & range & X & Y);
    [eapply (free (Segment _ _)); [do 3 right; now left |]; at_fraction (1 - k) |
     eapply (free (Segment _ _)); [right; now left |]; at_fraction k |
     eapply (free (Segment _ _)); [now left |]; at_fraction k |
     eapply (free (Segment _ _)); [do 2 right; now left |]; at_fraction (1 - k)].
Qed.

Lemma sides_are_sums (x : vector) (e f side : segment) : In side (parallelogram e f) -> lies_on x side ->
  is_sum_of_points x e f.
Proof.
  intros S on.
  assert (of_e : forall u, lies_on u e -> lies_on (minus x u) f -> is_sum_of_points x e f)
    by (intros u on_e on_f; exists u, (minus x u); split; [exact on_e | split; [exact on_f | by_computing]]).
  assert (of_f : forall u, lies_on u f -> lies_on (minus x u) e -> is_sum_of_points x e f)
    by (intros u on_f on_e; exists (minus x u), u; split; [exact on_e | split; [exact on_f | by_computing]]).
  destruct (lies_on_dec (minus x (source e)) f); [now apply (of_e (source e) (source_lies_on e)) |].
  destruct (lies_on_dec (minus x (target e)) f); [now apply (of_e (target e) (target_lies_on e)) |].
  destruct (lies_on_dec (minus x (source f)) e); [now apply (of_f (source f) (source_lies_on f)) |].
  destruct (lies_on_dec (minus x (target f)) e); [now apply (of_f (target f) (target_lies_on f)) |].
  destruct (off_parallelogram x e f ltac:(now repeat split) side S on).
Qed.

Section Swept.
  Variable b : region.
  Variable s : segment.
  Hypothesis long : no_edges_are_points b.
  Variable x : vector.
  (* Where x is with respect to b, if s begins in 0. *)
  Let z := minus (Vector 0 0) (minus (source s) x).

  Lemma z_is : equal_vectors x (plus (source s) z).
  Proof. unfold z. by_computing. Qed.

  Lemma sums_are_swept (e : segment) : In e (region_edges b) -> is_sum_of_points x s e -> is_swept b s x.
  Proof. intros E (t & w & on_s & on_e & equal). exists t, w. split; [exact on_s | split; [left; now exists e |]].
  exact equal. Qed.

  Lemma swept_segments_are_long (l : list segment) (t : segment) : In l (swept b s) -> In t l -> nonzero (along t).
  Proof.
    intros L T. pose proof (region_edges_are_directions b long) as b_long. destruct L as [<- | L].
    - rewrite !edges_of_placed, map_map in T. apply in_map_iff in T. destruct T as (e & <- & E).
      specialize (b_long e E). intros [X Y]. apply b_long. by_computing.
    - destruct (same_point_spec (source s) (target s)) as [| differ]; [destruct L |].
      apply in_map_iff in L. destruct L as (e & <- & E). specialize (b_long e E).
      assert (s_long : nonzero (along s)) by (intros [X Y]; apply differ; by_computing).
      unfold parallelogram, edges in T. cbn [rotated app combine map fst snd] in T.
      destruct T as [<- | [<- | [<- | [<- | []]]]]; unfold nonzero in *; to_coordinates; lra.
  Qed.

  Lemma swept_are_closed (l : list segment) : In l (swept b s) -> cycles l.
  Proof.
    intros [<- | L]; [apply region_cycles |]. destruct (same_point _ _); [destruct L |].
    apply in_map_iff in L. destruct L as (e & <- & _). apply closed_chain_cycles.
  Qed.

  Lemma on_swept (l : list segment) (t : segment) : In l (swept b s) -> In t l -> lies_on x t -> is_swept b s x.
  Proof.
    intros [<- | L] T on.
    - rewrite !edges_of_placed, map_map in T. apply in_map_iff in T. destruct T as (e & <- & E).
      do 2 apply -> on_reflected in on. exists (source s), z. split; [apply source_lies_on |].
      split; [left; exists e; split; [exact E | exact on] | exact z_is].
    - destruct (same_point _ _); [destruct L |]. apply in_map_iff in L. destruct L as (e & <- & E).
      exact (sums_are_swept e E (sides_are_sums x s e t T on)).
  Qed.

  (* Theorem. *)
  Theorem inside_swept : (forall l, In l (swept b s) -> off x l) ->
    (is_swept b s x <-> exists l, In l (swept b s) /\ winding_number x l <> 0%Z).
  Proof.
    intros free.
    assert (free_z : off z (region_edges b)) by (do 2 apply -> off_placed; apply free; now left).
    assert (number_of_base : winding_number x (region_edges (placed (source s) (placed (Vector 0 0) b))) =
      winding_number z (region_edges b)) by (rewrite !winding_number_of_placed; trivial; now apply off_placed).
    split.
    - intros (t & w & on_s & in_b & equal).
      destruct (Z.eq_dec (winding_number z (region_edges b)) 0) as [zero_ | round];
        [| eexists; split; [now left | now rewrite number_of_base]].
      (* The numbers at z and at w differ. *)
      assert (way : forall v, lies_on v (Segment z w) -> exists u, lies_on u s /\ equal_vectors x (plus u v)).
      { intros v (k & range & X & Y). cbn [source target] in X, Y.
        exists (Vector ((1 - k) * vx (source s) + k * vx t) ((1 - k) * vy (source s) + k * vy t)). split.
        - destruct on_s as (h & h_range & tx & ty). exists (k * h). cbn [vx vy].
          assert (0 <= k * h) by (apply Qmult_le_0_compat; lra).
          assert (0 <= k * (1 - h)) by (apply Qmult_le_0_compat; lra).
          split; [lra |]. rewrite tx, ty. split; ring.
        - destruct equal as [ex ey]. unfold z, plus, minus in *. cbn [vx vy] in *.
          assert (k * vx x == k * vx t + k * vx w) by (rewrite ex; ring).
          assert (k * vy x == k * vy t + k * vy w) by (rewrite ey; ring). split; cbn [vx vy]; lra. }
      unfold swept in *. destruct (same_point_spec (source s) (target s)) as [[X Y] | differ].
      + exfalso. assert (same_ : equal_vectors z w).
        { destruct on_s as (h & _ & tx & ty), equal as [ex ey]. rewrite <- X in tx. rewrite <- Y in ty.
          unfold z, plus, minus in *. cbn [vx vy] in *.
          split; cbn [vx vy]; lra. }
        destruct in_b as [(e & E & on) | round].
        * apply (free_z e E). apply (lies_on_equal w); [now symmetry | exact on].
        * destruct same_ as [zx zy]. now rewrite <- (winding_number_of_equal z w _ zx zy) in round.
      + destruct (Exists_dec (fun e => winding_number x (parallelogram s e) <> 0%Z) (region_edges b)) as [some | none].
        { intros e. destruct (Z.eq_dec (winding_number x (parallelogram s e)) 0); [right | left]; tauto. }
        * apply Exists_exists in some. destruct some as (e & E & round). exists (parallelogram s e).
          split; [right; now apply in_map | exact round].
        * exfalso. assert (apart : forall v, lies_on v (Segment z w) -> off v (region_edges b)).
          { intros v on_way e E on_e. apply none, Exists_exists. exists e. split; [exact E |].
            destruct (way v on_way) as (u & on_u & equal_u).
            assert (s_long : nonzero (along s)) by (intros [X Y]; apply differ; by_computing).
            destruct (crossing_edges_count x s e s_long (region_edges_are_directions b long e E)) as [[_ ->] | [_ ->]];
              [now exists u, v | | discriminate | discriminate].
            apply not_on_a_side, free. right. now apply in_map. }
          destruct in_b as [(e & E & on) | round]; [exact (apart w (target_lies_on (Segment z w)) e E on) |].
          apply round. rewrite <- zero_. symmetry. exact (winding_number_along _ _ (region_cycles b) apart).
    - intros (l & [<- | L] & round).
      + exists (source s), z. split; [apply source_lies_on |]. split; [right; congruence | exact z_is].
      + destruct (same_point _ _); [destruct L |]. apply in_map_iff in L. destruct L as (e & <- & E).
        destruct (parallelogram_winding_number x s e) as [| [_ is_sum]]; [contradiction |].
        exact (sums_are_swept e E is_sum).
  Qed.
End Swept.
