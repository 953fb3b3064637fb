(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Erosion, opening and closing, of where one region is inside another (inner_fit_program.v). The erosion is what the
   chains found there go round; the opening is its sum with b, together with b moved along the edges and to the points
   at which it just fits. Chains that go round something are the only ones that matter, so all are regions by a rule. *)
From Coq Require Import QArith Qminmax Lqa ZArith Lia Bool List Permutation.
From Oplus Require Import specification checker regions_and_sums homogeneous_points specification_bridge
  collision_is_complete filling kept_pieces_go_round rule_of_sides region_of_pieces sum_program sum_is_right
  sum_of_uncovered_pieces coordinates open_sum_program open_sums turned_chains inner_fit_program complement_in_a_frame
  regions_by_rule canonical_regions inner_fit_is_right swept_regions.
Import ListNotations.

Open Scope Q_scope.

(* What some of the families go round. *)
Definition some_nonzero (numbers : list Z) : bool := existsb (fun n => negb (n =? 0)%Z) numbers.
Definition gone_round : list (list segment) -> polygonal_region := region_by_rule some_nonzero.

Definition areas (f : placements) : polygonal_region := gone_round [region_edges (as_vectors (fit_chains f))].
Definition erosion (a b : polygonal_region) : polygonal_region := areas (inner_fit a b).

(* Where b just fits: edges, and points as edges from the point to itself. *)
Definition exact_fits (f : placements) : list segment :=
  map ends_of (fit_edges f) ++ map (fun v => ends_of (v, v)) (fit_points f).

Definition opening (a b : polygonal_region) : polygonal_region :=
  let f := inner_fit a b in
  gone_round (region_edges (as_region (quick_sum (areas f) b)) :: flat_map (swept (as_region b)) (exact_fits f)).

Definition closing (a b : polygonal_region) : polygonal_region := erosion (quick_sum a b) b.

Lemma by_some_nonzero (families : list (list segment)) (x : vector) :
  by_rule some_nonzero families x = true <-> exists l, In l families /\ winding_number x l <> 0%Z.
Proof.
  unfold by_rule, some_nonzero. rewrite existsb_exists. split.
  - intros (n & N & round). apply in_map_iff in N. destruct N as (l & <- & L). exists l. split; [exact L |].
    now apply negb_true_iff, Z.eqb_neq in round.
  - intros (l & L & round). exists (winding_number x l). split; [now apply in_map |].
    now apply negb_true_iff, Z.eqb_neq.
Qed.

Lemma nothing_is_zero (families : list (list segment)) : some_nonzero (map (fun _ => 0%Z) families) = false.
Proof. induction families as [| l families IH]; [reflexivity | exact IH]. Qed.

(* Theorem. They are valid regions. *)
Theorem gone_round_is_valid (families : list (list segment)) : (forall l, In l families -> cycles l) ->
  (forall t, In t (concat families) -> nonzero (along t)) ->
  valid_region (as_region (gone_round families)) /\ nowhere_above_one (as_region (gone_round families)).
Proof.
  intros closed all_long. pose proof (nothing_is_zero families) as nothing. apply polygonal_is_valid.
  - now apply chains_by_rule_are_valid.
  - intros x _. rewrite (permuted_winding_number x _ _ (chains_by_rule _ _ closed all_long nothing)).
    rewrite (boundary_by_rule_goes_round _ _ closed all_long nothing). destruct (by_rule _ _ x); cbn; lia.
Qed.

Lemma more_closure (A B : point -> Prop) (x : point) : (forall y, A y -> B y) -> closure (interior A) x ->
  closure (interior B) x.
Proof.
  intros more closure_ radius R. destruct (closure_ radius R) as (y & close & inner & I & all_in). exists y.
  split; [exact close |]. exists inner. split; [exact I |]. intros z close_z. now apply more, all_in.
Qed.

Lemma on_exact_fits (f : placements) (x : point) :
  (exists s, In s (exact_fits f) /\ lies_on (as_vector x) s) <->
  (exists e, In e (fit_edges f) /\ is_on x e) \/ exists v, In v (fit_points f) /\ equal_points x v.
Proof.
  unfold exact_fits. setoid_rewrite in_app_iff. setoid_rewrite in_map_iff. split.
  - intros (s & [(e & <- & E) | (v & <- & V)] & on); [left; now exists e | right].
    exists v. split; [exact V |]. destruct on as (k & _ & X & Y). unfold ends_of in *. cbn [fst snd] in *. by_computing.
  - intros [(e & E & on) | (v & V & X & Y)]; [exists (ends_of e); split; [left; now exists e | exact on] |].
    exists (ends_of (v, v)). split; [right; now exists v |]. unfold ends_of. cbn [fst snd]. at_fraction 0.
Qed.

Lemma member_of_vectors (x : point) (r : polygonal_region) : member x r <->
  (exists s, In s (region_edges (as_vectors r)) /\ lies_on (as_vector x) s) \/
  winding_number (as_vector x) (region_edges (as_vectors r)) <> 0%Z.
Proof. rewrite <- (as_written r) at 1. apply member_of_chains. Qed.

(* Edges and points have nothing around them. *)
Lemma interior_of_placements (f : placements) (x : point) :
  closure (interior (fun y => fits y f)) x -> closure (interior (fun y => member y (fit_chains f))) x.
Proof.
  set (edges_ := region_edges (as_vectors (fit_chains f))). intros near radius R.
  destruct (near ((1 # 2) * radius) ltac:(lra)) as (y & close & inner & I & all_fit).
  destruct (eventually_and _ _ (shifted_stays_within (Qmin inner ((1 # 2) * radius)) (as_vector y)
    ltac:(apply Q.min_glb_lt; lra)) (shifted_off_all (as_vector y) (edges_ ++ exact_fits f))) as (limit & L & beside).
  destruct (beside ((1 # 2) * limit)) as (close_z & free); [lra | lra |]. set (z := moved _ _) in *.
  pose proof (Q.le_min_l inner ((1 # 2) * radius)). pose proof (Q.le_min_r inner ((1 # 2) * radius)).
  exists (as_point z). split; [unfold within, is_near in *; cbn in *; lra |].
  assert (free_z : off z edges_) by (intros s S; apply free, in_app_iff; now left).
  destruct (winding_number_near z edges_ (region_cycles _) free_z) as (r & some & same_). exists r.
  split; [exact some |].
  intros w close_w. apply member_of_vectors. right. fold edges_. destruct (same_ (as_vector w) close_w) as [_ ->].
  destruct (all_fit (as_point z)) as [in_chains | on_fits].
  - unfold within, is_near in *; cbn in *; lra.
  - apply member_of_vectors in in_chains. fold edges_ in in_chains. rewrite as_vector_of_point in in_chains.
    destruct in_chains as [(s & S & on) | round]; [destruct (free_z s S on) | exact round].
  - apply on_exact_fits in on_fits. destruct on_fits as (s & S & on). rewrite as_vector_of_point in on.
    destruct (free s ltac:(apply in_app_iff; now right) on).
Qed.

Section Operations.
  Variables a b : polygonal_region.
  Hypothesis a_region : valid_region (as_region a).
  Hypothesis a_simple : nowhere_above_one (as_region a).
  Hypothesis b_region : valid_region (as_region b).
  Hypothesis b_simple : nowhere_above_one (as_region b).
  Hypothesis b_some : exists c v, In c b /\ In v c.
  Let f := inner_fit a b.
  Let places := is_moved_into b (fun y => member y a).
  Let right_ := inner_fit_is_the_inner_fit a b a_region a_simple b_region b_simple b_some.
  Let families := [region_edges (as_vectors (fit_chains f))].

  Lemma fit_edges_are_closed (l : list segment) : In l families -> cycles l.
  Proof. intros [<- | []]. apply region_cycles. Qed.

  Lemma fit_edges_are_long (t : segment) : In t (concat families) -> nonzero (along t).
  Proof. unfold families. cbn [concat]. rewrite app_nil_r. exact (proj1 (proj2 right_) t). Qed.

  Lemma erosion_is_valid : valid_region (as_region (erosion a b)) /\ nowhere_above_one (as_region (erosion a b)).
  Proof. exact (gone_round_is_valid _ fit_edges_are_closed fit_edges_are_long). Qed.

  Lemma erosion_of_chains (x : point) :
    member x (erosion a b) <-> closure (interior (fun y => member y (fit_chains f))) x.
  Proof.
    apply (members_by_rule some_nonzero families fit_edges_are_closed fit_edges_are_long (nothing_is_zero _)).
    intros y free. rewrite by_some_nonzero, member_of_vectors. unfold families in *. cbn [concat] in free.
    rewrite app_nil_r in free. split.
    - intros [(s & S & on) | round]; [destruct (free s S on) |]. eexists. split; [now left | exact round].
    - intros (l & [<- | []] & round). now right.
  Qed.

  Lemma erosion_is_where_it_fits (x : point) : member x (erosion a b) -> fits x f.
  Proof.
    rewrite erosion_of_chains. intros near. left. apply member_of_vectors.
    destruct (on_or_off (as_vector x) (region_edges (as_vectors (fit_chains f)))) as [on | free]; [now left | right].
    destruct (winding_number_near _ _ (region_cycles _) free) as (radius & R & same_).
    destruct (near radius R) as (y & close & inner & I & all_in). destruct (same_ (as_vector y) close) as [free_y <-].
    specialize (all_in y ltac:(unfold is_near; lra)). apply member_of_vectors in all_in.
    destruct all_in as [(s & S & on) | round]; [destruct (free_y s S on) | exact round].
  Qed.

  Lemma places_are (x : point) : fits x f <-> places x.
  Proof. apply right_. Qed.

  (* Theorem. *)
  Theorem erosion_is_the_erosion : is_erosion a b (erosion a b).
  Proof.
    intros x. rewrite erosion_of_chains. split; intros near.
    - refine (more_closure _ _ x _ near). intros y in_chains. apply places_are. now left.
    - apply interior_of_placements. refine (more_closure _ _ x _ near). intros y. apply places_are.
  Qed.

  Lemma placements_are (x : point) : fits x f ->
    member x (erosion a b) \/ exists s, In s (exact_fits f) /\ lies_on (as_vector x) s.
  Proof.
    intros [in_chains | on_fits]; [left | right; now apply on_exact_fits].
    apply erosion_is_the_erosion. now apply right_.
  Qed.

  Let all_families := region_edges (as_region (quick_sum (erosion a b) b)) ::
    flat_map (swept (as_region b)) (exact_fits f).

  Lemma opening_is : opening a b = gone_round all_families.
  Proof. reflexivity. Qed.

  Local Opaque inner_fit quick_sum erosion.

  Lemma in_families (l : list segment) : In l all_families ->
    l = region_edges (as_region (quick_sum (erosion a b) b)) \/
    exists s, In s (exact_fits f) /\ In l (swept (as_region b) s).
  Proof. intros [<- | L]; [now left | right]. apply in_flat_map in L. exact L. Qed.

  Lemma families_are_closed (l : list segment) : In l all_families -> cycles l.
  Proof. intros [-> | (s & _ & L)]%in_families; [apply region_cycles | exact (swept_are_closed _ _ l L)]. Qed.

  Lemma families_are_long (t : segment) : In t (concat all_families) -> nonzero (along t).
  Proof.
    intros (l & L & T)%in_concat. apply in_families in L. destruct L as [-> | (s & S & L)].
    - destruct (quick_sum_is_valid _ _ (proj1 erosion_is_valid) b_region) as [(long & _) _].
      exact (region_edges_are_directions _ long t T).
    - exact (swept_segments_are_long _ s (proj1 b_region) l t L T).
  Qed.

  Let is_covered_by_b (x : point) := exists t z, fits t f /\ member z b /\ equal_points x (sum_of_points t z).

  Lemma sums_are_covered (x : point) : member x (quick_sum (erosion a b) b) -> is_covered_by_b x.
  Proof.
    intros in_sum. apply (quick_sum_is_the_sum _ _ (proj1 erosion_is_valid) b_region) in in_sum.
    destruct in_sum as (t & z & in_r & in_b & equal). exists t, z. apply erosion_is_where_it_fits in in_r. tauto.
  Qed.

  Lemma swept_is_covered (s : segment) (x : point) : In s (exact_fits f) -> is_swept (as_region b) s (as_vector x) ->
    is_covered_by_b x.
  Proof.
    intros S (t & z & on & in_b & equal). exists (as_point t), (as_point z). split; [| split; [| exact equal]].
    - right. apply on_exact_fits. exists s. now rewrite as_vector_of_point.
    - apply member_by_edges. now rewrite as_vector_of_point.
  Qed.

  (* Theorem. *)
  Theorem opening_is_the_opening : is_opening a b (opening a b).
  Proof.
    intros x. rewrite opening_is. transitivity (is_covered_by_b x).
    2: { split; intros (t & z & place & in_b & equal); exists t, z; (split; [| tauto]);
         now apply places_are. }
    apply (members_of_a_closed_set some_nonzero all_families families_are_closed families_are_long (nothing_is_zero _)).
    - intros y free. rewrite by_some_nonzero.
      assert (free_swept : forall s, In s (exact_fits f) -> forall l, In l (swept (as_region b) s) ->
        off (as_vector y) l).
      { intros s S l L e E. apply free, in_concat. exists l. split; [| exact E]. right. apply in_flat_map.
        now exists s. }
      split.
      + intros (t & z & place & in_b & equal). destruct (placements_are t place) as [in_r | (s & S & on)].
        * eexists. split; [now left |].
          assert (in_sum : member y (quick_sum (erosion a b) b)).
          { apply (quick_sum_is_the_sum _ _ (proj1 erosion_is_valid) b_region). exists t, z. tauto. }
          apply member_by_edges in in_sum. destruct in_sum as [(e & E & on) | round]; [| exact round].
          destruct (free e ltac:(apply in_concat; eexists; split; [now left | exact E]) on).
        * destruct (proj1 (inside_swept _ s (proj1 b_region) (as_vector y) (free_swept s S))) as (l & L & round).
          { exists (as_vector t), (as_vector z). split; [exact on |]. now rewrite <- member_by_edges. }
          exists l. split; [| exact round]. right. apply in_flat_map. now exists s.
      + intros (l & [-> | (s & S & L)]%in_families & round).
        * apply sums_are_covered, member_by_edges. now right.
        * apply (swept_is_covered s y S), inside_swept; [exact (proj1 b_region) | exact (free_swept s S) | now exists
            l].
    - intros y t (l & L & T)%in_concat on. apply in_families in L. destruct L as [-> | (s & S & L)].
      + apply sums_are_covered, member_by_edges. left. now exists t.
      + apply (swept_is_covered s y S). exact (on_swept _ s _ l t L T on).
    - intros y (t & z & place & in_b & X & Y) radius R. pose proof b_region as (b_edges & b_numbers & b_meet).
      apply (member_of_region z b b_region) in in_b.
      destruct (inside_near _ _ radius (regions_are_regular _ b_edges b_numbers b_meet) in_b R) as
        (w & close & free & some).
      destruct (winding_number_near w _ (region_cycles _) free) as (inner & I & near).
      exists (sum_of_points t (as_point w)). cbn in X, Y. split; [unfold within, is_near in *; cbn in *; lra |].
      exists inner. split; [exact I |]. intros v close_v.
      set (u := Point (x_of v - x_of t) (y_of v - y_of t)). exists t, u. split; [exact place |].
      split; [| unfold u; split; cbn; ring]. apply member_of_region; [exact b_region | left].
      destruct (near (as_vector u)) as [_ ->]; [unfold within, is_near, u in *; cbn in *; lra | exact some].
  Qed.
End Operations.

(* Theorem. *)
Theorem closing_is_the_closing (a b : polygonal_region) : valid_region (as_region a) -> valid_region (as_region b) ->
  nowhere_above_one (as_region b) -> (exists c v, In c b /\ In v c) -> is_closing a b (closing a b).
Proof.
  intros a_region b_region b_simple b_some x. unfold closing. destruct (quick_sum_is_valid a b a_region b_region).
  etransitivity; [now apply erosion_is_the_erosion |].
  pose proof (quick_sum_is_the_sum a b a_region b_region) as sum_is.
  split; apply more_closure; intros y inside z in_b; apply sum_is; now apply inside.
Qed.
