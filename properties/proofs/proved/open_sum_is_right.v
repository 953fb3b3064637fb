(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* What open_sum_program.v returns is the open sum, for any chains of the closed sum of which every point is beside
   the outside. An inner point of the sum that is on no sum of a vertex and an edge is in the open sum by Theorem
   4.2.1; one that is, and is not in the open sum, is an end of a piece or inside one, along which the interiors meet
   nowhere (open_along_a_piece.v). *)
From Coq Require Import QArith Qminmax Lqa ZArith Lia Bool List.
From Oplus Require Import convolution tracing signed_crossings tie_rule shifted_ray convolution_winding regions
  reflected
  meeting_of_segments crossing_edges winding_number_of_the_sum interiors_meet neighbourhoods left_of_an_edge
  theorem_4_2_1 observation_2_2_4 right_of_an_edge theorem_2_2_10 theorem_2_2_6 lemma_2_2_2 boundary_points location
    pieces naive_collision met_pieces
  collision_is_sound collision_is_complete placed_collision beside_a_piece filling kept_pieces_go_round
  kept_pieces_balance cut_pieces contacts contacts_that_stay open_sum_program open_along_a_piece.
Import ListNotations.

Open Scope Q_scope.

(* A segment of the convolution is a sum of a vertex and an edge. *)
Lemma convolution_segment_is_listed (p q : region) (t : segment) : In t (convolution_segments p q) ->
  exists u, In u (all_vertex_edge_segments p q) /\ equal_vectors (source t) (source u) /\ equal_vectors (target t)
    (target u).
Proof.
  intros I. apply in_map_iff in I. destruct I as ([chains named] & <- & I).
  apply in_flat_map in I. destruct I as ([a b] & J & I). apply in_prod_iff in J. destruct J as [in_p in_q].
  apply in_map_iff in I. destruct I as (named' & equal & I). injection equal as <- <-. cbn [fst snd] in *.
  apply (in_those (length a) (length b) (in_convolution a b)) in I. destruct I as [[i_below j_below] _].
  destruct named' as [along_ [i j]]. cbn in i_below, j_below.
  unfold starts_at, ends_at, point_of, state_before, state_after. cbn [fst snd].
  destruct along_; cbn [step fst snd source target].
  - exists (moved_segment (source (edge_at b j)) (edge_at a i)). split.
    + apply in_app_iff. right. apply in_vertex_edge_segments. exists (edge_at b j), (edge_at a i).
      split; [now apply edge_at_in_region |]. split; [now apply edge_at_in_region | reflexivity].
    + rewrite !edge_at_is by assumption. unfold moved_segment, plus; cbn [source target vx vy].
      repeat split; cbn [vx vy]; ring.
  - exists (moved_segment (source (edge_at a i)) (edge_at b j)). split.
    + apply in_app_iff. left. apply in_vertex_edge_segments. exists (edge_at a i), (edge_at b j).
      split; [now apply edge_at_in_region |]. split; [now apply edge_at_in_region | reflexivity].
    + rewrite !edge_at_is by assumption. unfold moved_segment, plus; cbn [source target vx vy].
      repeat split; cbn [vx vy]; ring.
Qed.

Lemma off_all_is_general (p q : region) (x : vector) : off x (all_vertex_edge_segments p q) -> off_vertex_edge_sum x p
  q.
Proof.
  intros free e f E F.
  assert (of_p : forall v, is_vertex v p -> ~ lies_on (minus x v) f).
  { intros v (s & S & vx_is & vy_is) on. apply (free (moved_segment (source s) f)).
    - apply in_app_iff. left. apply in_vertex_edge_segments. now exists s, f.
    - apply on_moved_segment. refine (lies_on_equal _ _ _ _ on). unfold minus; split; cbn [vx vy]; lra. }
  assert (of_q : forall v, is_vertex v q -> ~ lies_on (minus x v) e).
  { intros v (t & T & vx_is & vy_is) on. apply (free (moved_segment (source t) e)).
    - apply in_app_iff. right. apply in_vertex_edge_segments. now exists t, e.
    - apply on_moved_segment. refine (lies_on_equal _ _ _ _ on). unfold minus; split; cbn [vx vy]; lra. }
  assert (itself : forall r s, In s (region_edges r) -> is_vertex (source s) r)
    by (intros r s S; exists s; split; [exact S | split; reflexivity]).
  repeat split; [apply of_p | apply of_p | apply of_q | apply of_q];
    try (now apply itself); now apply target_is_vertex.
Qed.

Lemma listed_is_on_the_sum_of (p q : region) (x : vector) (t : segment) : In t (all_vertex_edge_segments p q) ->
  lies_on x t -> on_vertex_edge_sum x p q.
Proof.
  intros T on. apply in_app_iff in T. destruct T as [T | T]; apply in_vertex_edge_segments in T;
    destruct T as (s & f & S & F & ->); apply on_moved_segment in on; [left | right];
    exists (source s), f; (split; [exists s; split; [exact S | split; reflexivity] | now split]).
Qed.

Section OpenSum.
  Variables p q sum_ : region.
  Hypothesis p_region : valid_region p.
  Hypothesis q_region : valid_region q.
  Hypothesis p_simple : nowhere_above_one p.
  Hypothesis q_simple : nowhere_above_one q.
  (* The chains of the closed sum, all of them beside the outside. *)
  Hypothesis sum_is : forall x,
    (exists s, In s (region_edges sum_) /\ lies_on x s) \/ winding_number x (region_edges sum_) <> 0%Z <-> in_sum x p q.
  Hypothesis sum_is_bounded : forall x s radius, In s (region_edges sum_) -> lies_on x s -> 0 < radius ->
    exists y, within radius x y /\ ~ in_sum y p q.

  Let convolution_ := convolution_segments p q.
  Let dangling := dangling_among p q (touching_pieces p q) (region_edges sum_).
  Let isolated := isolated_among p q (touching_pieces p q) (region_edges sum_) dangling.

  Lemma convolution_is_closed_ : cycles convolution_.
  Proof. destruct p_region as (p_edges & _), q_region as (q_edges & _). now apply convolution_is_closed. Qed.

  (* Where all points near are in the sum, the winding number is positive. *)
  Lemma inner_points_are_gone_round (x : vector) : inner_point_of_sum x p q -> (0 < winding_number x convolution_)%Z.
  Proof.
    intros (radius & R & near).
    destruct (eventually_and _ _
      (eventually_for_all (fun s e => ~ lies_on (moved (shifted x) e) s) convolution_ (fun s _ => shifted_off x s))
      (eventually_and _ _ (same_beside x convolution_)
        (eventually_and _ _ (small_steps_stay_within radius x (Vector 1 0) R)
          (ex_intro _ 1 (conj (ltac:(lra) : 0 < 1) (fun e some small => conj some small : 0 < e /\ e < 1))))))
      as (limit & L & all).
    destruct (all ((1 # 2) * limit)) as (free & same_number & close & some & small); [lra | lra |].
    set (e := (1 # 2) * limit) in *. clearbody e. clear all. rewrite <- same_number.
    apply positive_winding_number_iff_common_point; trivial. apply near.
    assert (0 < e * e /\ e * e <= e) by (split; nra).
    unfold within, moved, shifted, moved_along in *. cbn [at_ first second vx vy] in *. split; lra.
  Qed.

  Lemma all_near_are_inner (x : vector) : off x (region_edges sum_) -> winding_number x (region_edges sum_) <> 0%Z ->
    exists radius, 0 < radius /\ forall y, within radius x y -> inner_point_of_sum y p q.
  Proof.
    intros free round. destruct (winding_number_near x _ (region_cycles sum_) free) as (radius & R & near).
    exists ((1 # 2) * radius). split; [lra |]. intros y close. exists ((1 # 2) * radius). split; [lra |].
    intros z close_z. apply sum_is. right.
    destruct (near z) as [_ same_number]; [unfold within in *; lra |]. now rewrite same_number.
  Qed.

  Lemma pieces_are_met_along_only (e : segment) : In e (touching_pieces p q) -> met_only_along convolution_ e.
  Proof.
    intros E w t inside_ T on.
    destruct (touching_piece_is p q e E) as (s & piece & S & I & place_).
    destruct (convolution_segment_is_listed p q t T) as (u & U & same_source & same_target).
    pose proof (all_vertex_edge_segments_are_long p q p_region q_region s S) as long.
    apply (strictly_inside_of_one_place _ _ _ place_) in inside_.
    assert (on_u : lies_on w u).
    { destruct on as (k & range & X & Y), same_source as [sx sy], same_target as [tx ty]. exists k.
      split; [exact range |]. rewrite <- sx, <- sy, <- tx, <- ty. now split. }
    destruct (nothing_meets_a_piece s _ piece u w long I inside_ U) as (_ & _ & parallel). specialize (parallel on_u).
    apply (collinear_of_one_place e piece t place_).
    apply (collinear_by_direction piece t w); [now apply strictly_inside_lies_on | exact on |].
    destruct (cut_returns s (flat_map (intersection s) (all_vertex_edge_segments p q)) long) as [parts _].
    destruct (parts piece I) as [part _]. destruct (part_is_long piece s part long) as (_ & c & _ & cx & cy).
    assert (same_x : vx (along t) == vx (along u) /\ vy (along t) == vy (along u)).
    { destruct same_source as [sx sy], same_target as [tx ty]. unfold along, minus; cbn [vx vy].
      rewrite sx, sy, tx, ty. split; reflexivity. }
    destruct same_x as [along_x along_y]. unfold cross in *. rewrite cx, cy, along_x, along_y.
    setoid_replace (c * vx (along s) * vy (along u) - c * vy (along s) * vx (along u))
      with (c * (vx (along s) * vy (along u) - vy (along s) * vx (along u))) by ring.
    rewrite parallel. ring.
  Qed.

  (* On both sides of a piece is the sum. *)
  Lemma sides_are_inside (e s : segment) (w : vector) : In e (touching_pieces p q) -> s = e \/ s = reversed e ->
    strictly_inside w e -> off w (region_edges sum_) -> winding_number w (region_edges sum_) <> 0%Z ->
    is_right_inside convolution_ s = true.
  Proof.
    intros E is_s inside_ free round. destruct (all_near_are_inner w free round) as (radius & R & near).
    assert (long_e : nonzero (along e)).
    { destruct (touching_piece_is p q e E) as (t & piece & T & I & place_).
      apply (long_of_one_place _ _ place_).
      pose proof (all_vertex_edge_segments_are_long p q p_region q_region t T) as long.
      destruct (cut_returns t (flat_map (intersection t) (all_vertex_edge_segments p q)) long) as [parts _].
      destruct (parts piece I) as [part _]. now destruct (part_is_long piece t part long). }
    pose proof (pieces_are_met_along_only e E) as only.
    assert (facts : nonzero (along s) /\ met_only_along convolution_ s /\ strictly_inside w s).
    { destruct is_s as [-> | ->]; [tauto |]. split; [exact (long_of_one_place _ _ (reversed_place e) long_e) |].
      split; [now apply met_only_along_reversed | now apply strictly_inside_reversed]. }
    destruct facts as (long & only_s & inside_s).
    set (n := Vector (vy (along s)) (- vx (along s))).
    assert (right_ : cross (along s) n < 0).
    { pose proof (rotation.square_positive _ long). unfold n, cross, dot in *; cbn [vx vy] in *. lra. }
    destruct (eventually_and _ _ (small_steps_stay_within radius w n R)
      (to_the_right_of_a_piece convolution_ s convolution_is_closed_ only_s long w n inside_s right_))
      as (limit & L & all).
    destruct (all ((1 # 2) * limit)) as (close & same_number); [lra | lra |].
    unfold is_right_inside. rewrite <- same_number. apply Z.ltb_lt, inner_points_are_gone_round, near, close.
  Qed.

  Lemma meets_at (x : vector) : interiors_meet_at p q x = true <-> interiors_meet x p q.
  Proof. now apply collide_decides_whether_interiors_meet. Qed.

  Lemma crossing_means_meeting (x : vector) : pieces_cross_at (boundary_pieces p) (boundary_pieces q) x = true ->
    interiors_meet x p q.
  Proof.
    intros crossing_. unfold pieces_cross_at in crossing_.
    apply existsb_exists in crossing_. destruct crossing_ as (s & S & crossing_).
    apply existsb_exists in crossing_. destruct crossing_ as (t' & T & crossing_). apply in_map_iff in T.
    destruct T as (t & <- & T). destruct (proper_crossing s (reflected x t) crossing_) as (w & in_s & in_t & turn).
    destruct (boundary_piece_is p s (proj1 p_region) S) as (e & E & long_e & s_part & p_free).
    destruct (boundary_piece_is q t (proj1 q_region) T) as (f & F & long_f & t_part & q_free).
    destruct (p_free w in_s) as [on_e not_p].
    destruct (q_free (minus x w)) as [on_f not_q].
    { destruct in_t as (k & range & X & Y). exists k. unfold reflected, minus in *; cbn [source target vx vy] in *.
      split; [exact range |]. split; lra. }
    apply meet_inside_placed, (edges_that_cross_show p (placed x q) p_region (placed_is_valid x q q_region)).
    exists e, (reflected x f), w. rewrite edges_of_placed.
    repeat split; trivial; [now apply in_map | now apply on_reflected | now rewrite vertex_of_placed_iff |].
    intros parallel. apply turn. destruct (long_reflected x s t) as [cross_s _].
    destruct (long_reflected x e f) as [cross_e _].
    destruct (cross_of_parts s t e f long_e long_f s_part t_part) as (c & _ & cross_is & _).
    rewrite cross_s, cross_is. assert (none : cross (along e) (along f) == 0) by lra. rewrite none. ring.
  Qed.

  Lemma left_out_is (v : vector) : is_left_out p q (boundary_pieces p) (boundary_pieces q) (region_edges sum_) v =
    true <->
    off v (region_edges sum_) /\ winding_number v (region_edges sum_) <> 0%Z /\ ~ interiors_meet v p q.
  Proof.
    unfold is_left_out.
    destruct (is_on_one_spec v (region_edges sum_)) as [(s & S & on) | off_].
    { split; [discriminate |]. intros (free & _). exfalso. exact (free s S on). }
    assert (free : off v (region_edges sum_)) by (intros s S on; apply off_; now exists s).
    destruct (Z.eqb_spec (winding_number v (region_edges sum_)) 0) as [zero_ | round]; [split; [discriminate | tauto]
      |].
    destruct (pieces_cross_at _ _ v) eqn:crossing_.
    { apply crossing_means_meeting in crossing_. split; [discriminate | tauto]. }
    rewrite negb_true_iff, <- not_true_iff_false, meets_at. tauto.
  Qed.

  Lemma inner_points_are_off (x : vector) : inner_point_of_sum x p q -> off x (region_edges sum_).
  Proof.
    intros (radius & R & near) s S on. destruct (sum_is_bounded x s radius S on R) as (y & close & out).
    exact (out (near y close)).
  Qed.

  (* The open sum is inside the closed one. *)
  Lemma open_points_are_inside (x : vector) : interiors_meet x p q ->
    winding_number x (region_edges sum_) <> 0%Z /\ off x (region_edges sum_).
  Proof.
    intros meet_x. destruct (interiors_meet_means_inner_point p q x meet_x) as (radius & R & near).
    assert (free : off x (region_edges sum_)).
    { intros s S on. destruct (sum_is_bounded x s radius S on R) as (y & close & out). exact (out (near y close)). }
    split; [| exact free]. destruct (proj2 (sum_is x)) as [(s & S & on) | round]; [| exfalso; exact (free s S on) |
      exact round].
    apply near. now apply within_of_equal.
  Qed.

  (* From a point of a segment towards its middle. *)
  Lemma towards_the_middle (s : segment) (x : vector) (t : Q) : lies_on x s -> 0 < t -> t < 1 ->
    strictly_inside (moved_along x (minus (middle s) x) t) s.
  Proof.
    intros (k & range & X & Y) some small. exists ((1 - t) * k + t * (1 # 2)).
    assert (0 <= (1 - t) * k) by (apply Qmult_le_0_compat; lra).
    assert (0 <= (1 - t) * (1 - k)) by (apply Qmult_le_0_compat; lra). split; [lra |].
    unfold moved_along, minus, middle; cbn [vx vy]. rewrite X, Y. split; field.
  Qed.

  Lemma open_points_are_on_no_dangling_edge (x : vector) (e : segment) : interiors_meet x p q -> In e dangling ->
    ~ lies_on x e.
  Proof.
    intros meet_x E on. unfold dangling, dangling_among in E. apply nodup_In, filter_In in E. destruct E as [E dangles].
    apply left_out_is in dangles. destruct dangles as (_ & _ & outside). apply outside.
    destruct (interiors_meet_all_near p q x meet_x) as (radius & R & near).
    destruct (eventually_and _ _ (small_steps_stay_within radius x (minus (middle e) x) R)
      (ex_intro _ 1 (conj (ltac:(lra) : 0 < 1) (fun t some small => conj some small : 0 < t /\ t < 1))))
      as (limit & L & all).
    destruct (all ((1 # 2) * limit)) as (close & some & small); [lra | lra |].
    apply (meeting_is_the_same_along_a_piece p q p_region q_region p_simple q_simple e
      (moved_along x (minus (middle e) x) ((1 # 2) * limit))); trivial.
    - now apply towards_the_middle.
    - apply middle_is_inside.
    - now apply near.
  Qed.

  (* An end of a piece, or a sum of two vertices. *)
  Lemma isolated_is_listed (x w : vector) : equal_vectors x w ->
    In w (flat_map (fun e => [source e; target e]) (touching_pieces p q) ++ vertex_sums p q) ->
    off x (region_edges sum_) -> winding_number x (region_edges sum_) <> 0%Z -> off x dangling ->
    ~ interiors_meet x p q -> In w isolated.
  Proof.
    intros equal I free round free_d outside. unfold isolated, isolated_among. apply nodup_In, filter_In.
    split; [exact I |].
    destruct (is_on_one_spec w dangling) as [(s & S & on) | _].
    - exfalso. apply (free_d s S). apply (lies_on_equal w); [now symmetry | exact on].
    - apply left_out_is. split; [now apply (off_equal x) |]. destruct equal as [X Y]. split.
      + now rewrite <- (winding_number_of_equal _ _ _ X Y).
      + intros meet. apply outside. apply (interiors_meet_of_equal p q w); [split; lra | exact meet].
  Qed.

  (* All along a piece are inner points of the sum, if one is. *)
  Lemma inner_all_along (e : segment) (x : vector) : In e (touching_pieces p q) -> strictly_inside x e ->
    off x (region_edges sum_) -> winding_number x (region_edges sum_) <> 0%Z -> inner_point_of_sum (middle e) p q.
  Proof.
    intros E inside_ free round.
    destruct (touching_piece_is p q e E) as (s & piece & S & I & place_).
    pose proof (all_vertex_edge_segments_are_long p q p_region q_region s S) as long_s.
    destruct (cut_returns s (flat_map (intersection s) (all_vertex_edge_segments p q)) long_s) as [parts _].
    destruct (parts piece I) as [part _]. destruct (part_is_long piece s part long_s) as [long_piece _].
    pose proof (long_of_one_place _ _ place_ long_piece) as long_e.
    pose proof (pieces_are_met_along_only e E) as only.
    assert (middle_at : equal_vectors (middle e) (point_at e (1 # 2)))
      by (unfold middle, point_at; split; cbn [vx vy]; field).
    assert (middle_back : equal_vectors (middle e) (point_at (reversed e) (1 # 2)))
      by (unfold middle, point_at, reversed; cbn [source target]; split; cbn [vx vy]; field).
    destruct (value_to_the_right_of_the_middle convolution_ e convolution_is_closed_ only long_e) as (r1 & R1 &
      value_1).
    destruct (value_to_the_right_of_the_middle convolution_ (reversed e) convolution_is_closed_
      (met_only_along_reversed _ _ only) (long_of_one_place _ _ (reversed_place e) long_e)) as (r2 & R2 & value_2).
    pose proof (sides_are_inside e e x E (or_introl eq_refl) inside_ free round) as right_.
    pose proof (sides_are_inside e (reversed e) x E (or_intror eq_refl) inside_ free round) as left_.
    apply Z.ltb_lt in right_, left_.
    destruct (on_its_edge_near e (middle e)) as (r3 & R3 & on_e).
    { pose proof (rotation.square_positive _ long_e) as square. unfold dot, along, minus, middle in *; cbn [vx vy] in *.
      set (ux := vx (target e) - vx (source e)) in *. set (uy := vy (target e) - vy (source e)) in *.
      assert (value : (vx (source e) - (vx (source e) + vx (target e)) / 2) *
        (vx (target e) - (vx (source e) + vx (target e)) / 2) +
        (vy (source e) - (vy (source e) + vy (target e)) / 2) *
        (vy (target e) - (vy (source e) + vy (target e)) / 2) == - (1 # 4) * (ux * ux + uy * uy))
        by (unfold ux, uy; field).
      rewrite value. lra. }
    exists (Qmin r1 (Qmin r2 r3)). split; [repeat apply Q.min_glb_lt; assumption |]. intros y close.
    pose proof (Q.le_min_l r1 (Qmin r2 r3)). pose proof (Q.le_min_r r1 (Qmin r2 r3)).
    pose proof (Q.le_min_l r2 r3). pose proof (Q.le_min_r r2 r3).
    pose proof p_region as (p_edges & p_valid & _). pose proof q_region as (q_edges & q_valid & _).
    destruct middle_at as [mx my], middle_back as [bx by_].
    destruct (Q_dec (area e y) 0) as [[low | high] | flat].
    - apply positive_winding_number_is_in_the_sum; trivial. fold convolution_. rewrite (value_1 y); [exact right_ | |
      exact low].
      unfold within in *. lra.
    - apply positive_winding_number_is_in_the_sum; trivial. fold convolution_.
      rewrite (value_2 y); [exact left_ | unfold within in *; lra |]. rewrite area_reversed. lra.
    - apply vertex_edge_sums_are_in_the_sum, (listed_is_on_the_sum_of p q y s); [exact S |].
      apply (part_lies_on piece s y long_s part). apply (lies_on_of_one_place _ _ y place_). apply on_e; [| exact flat].
      unfold within in *. lra.
  Qed.

  Theorem open_sum_has (x : vector) :
    (winding_number x (region_edges sum_) <> 0%Z /\ off x (region_edges sum_)) /\
      off x dangling /\ (forall v, In v isolated -> ~ equal_vectors x v) <->
    interiors_meet x p q.
  Proof.
    split.
    - intros ((round & free) & free_d & not_isolated).
      destruct (interiors_meet_at p q x) eqn:met; [now apply meets_at |]. exfalso.
      assert (outside : ~ interiors_meet x p q) by (rewrite <- meets_at; congruence).
      destruct (on_or_off x (all_vertex_edge_segments p q)) as [(t & T & on) | general].
      + pose proof (listed_is_on_the_sum_of p q x t T on) as on_sum.
        destruct (not_meeting_is_on_a_piece p q p_region q_region p_simple q_simple x on_sum outside) as [(w & W &
          equal) | (e & E &
          on_e)].
        * apply (not_isolated w); [| exact equal]. apply (isolated_is_listed x w); trivial. apply in_app_iff. now right.
        * assert (ends : forall w, w = source e \/ w = target e -> ~ equal_vectors x w).
          { intros w end_ equal. apply (not_isolated w); [| exact equal]. apply (isolated_is_listed x w); trivial.
            apply in_app_iff. left. apply in_flat_map. exists e. split; [exact E |]. cbn.
            destruct end_ as [-> | ->]; tauto. }
          assert (inside_ : strictly_inside x e).
          { destruct on_e as (k & range & X & Y). exists k. split; [| now split].
            split; apply Qnot_le_lt; intros extreme.
            - apply (ends (source e)); [now left |]. assert (k_is : k == 0) by lra. rewrite k_is in X, Y. split; lra.
            - apply (ends (target e)); [now right |]. assert (k_is : k == 1) by lra. rewrite k_is in X, Y. split; lra. }
          apply (free_d e); [| exact on_e]. unfold dangling, dangling_among. apply nodup_In, filter_In. split; [exact
            E |].
          apply left_out_is. pose proof (inner_all_along e x E inside_ free round) as inner.
          assert (free_middle : off (middle e) (region_edges sum_)) by now apply inner_points_are_off.
          split; [exact free_middle |]. split.
          { destruct inner as (radius & R & near). destruct (proj2 (sum_is (middle e))) as [(s & S & on_s) | round_];
            trivial.
            - apply near. now apply within_of_equal.
            - exfalso. exact (free_middle s S on_s). }
          intros meet. apply outside.
          apply (meeting_is_the_same_along_a_piece p q p_region q_region p_simple q_simple e (middle e)); trivial.
          apply middle_is_inside.
      + apply outside. apply off_all_is_general in general.
        apply (positive_winding_number_iff_interiors_meet p q x p_region q_region general).
        apply inner_points_are_gone_round. destruct (all_near_are_inner x free round) as (radius & R & near).
        apply near. now apply within_of_equal.
    - intros meet_x. split; [now apply open_points_are_inside |]. split.
      + intros e E. now apply open_points_are_on_no_dangling_edge.
      + intros v V equal. unfold isolated, isolated_among in V. apply nodup_In, filter_In in V. destruct V as [_ alone].
        destruct (existsb _ dangling); [discriminate |]. apply left_out_is in alone. destruct alone as (_ & _ &
          outside).
        apply outside. now apply (interiors_meet_of_equal p q x).
  Qed.
End OpenSum.
