(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Small moves of the vertices of a chain do not change how often it goes round a point that is not on it. For that is
   counted by which edges lead across a line that no vertex is on, seen from the point, and in which direction they turn
   there; and both stay as they are for a while. *)
From Coq Require Import ZArith Lia Bool List.
From Oplus Require Import numbers convolution small_numbers neighbourhoods regions secants simple_chain.
Import ListNotations.

Open Scope Q_scope.

Definition near (radius : Q) (chain moved_ : list vector) : Prop :=
  length moved_ = length chain /\
  forall i, (i < length chain)%nat -> within radius (vertex chain i) (vertex moved_ i).

Lemma small_product (a b radius : Q) : - radius < a < radius -> - radius < b < radius -> 0 < radius < 1 ->
  - radius <= a * b <= radius.
Proof. intros A B R. split; nra. Qed.

(* Lemma. A turn to the left is one after small changes. *)
Lemma turn_stays (u v : vector) : 0 < cross u v ->
  eventually (fun radius => forall u' v', within radius u u' -> within radius v v' -> 0 < cross u' v').
Proof.
  intros turn.
  refine (eventually_implied _ _ _ (eventually_and _ _ (eventually_below 1 ltac:(lra))
    (eventually_positive (cross u v) (- (Qabs (vx u) + Qabs (vy u) + Qabs (vx v) + Qabs (vy v) + 2)) turn))).
  intros radius [small some] u' v' [X Y] [Z W].
  pose proof (product_bounds _ (vy v) _ X). pose proof (product_bounds _ (vx v) _ Y).
  pose proof (product_bounds _ (vy u) _ Z). pose proof (product_bounds _ (vx u) _ W).
  pose proof (small_product _ _ radius X W small). pose proof (small_product _ _ radius Y Z small).
  assert (parts : cross u' v' == cross u v + (vx u' - vx u) * vy v - (vy u' - vy u) * vx v - (vx v' - vx v) * vy u +
    (vy v' - vy v) * vx u + (vx u' - vx u) * (vy v' - vy v) - (vy u' - vy u) * (vx v' - vx v))
    by (unfold cross; ring).
  rewrite parts. nra.
Qed.

Lemma side_of_a_ray_stays (k : summand) (d u : vector) : ~ cross d u == 0 ->
  eventually (fun radius => forall u', within radius u u' -> left_of_ray k d u' = left_of_ray k d u /\ nonzero u').
Proof.
  intros beside_.
  assert (still : forall radius, 0 < radius -> within radius d d) by (unfold within; intros; lra).
  assert (turned : forall w, cross w d == - cross d w) by (intros; unfold cross; ring).
  assert (some : forall w, ~ cross d w == 0 -> nonzero w).
  { intros w no [X Y]. apply no. unfold cross. rewrite X, Y. ring. }
  destruct (Q_dec (cross d u) 0) as [[less | more] | none]; [| | contradiction].
  - refine (eventually_implied _ _ _ (eventually_and _ _ (eventually_below 1 ltac:(lra))
      (turn_stays u d ltac:(rewrite turned; lra)))).
    intros radius [[R _] stays] u' close. specialize (stays u' d close (still radius R)).
    pose proof (turned u) as at_u. pose proof (turned u') as at_u'. split; [| apply some; lra].
    unfold left_of_ray. destruct k; [f_equal; destruct (negative_spec (cross d u')), (negative_spec (cross d u)) |
      destruct (negative_spec (cross u' d)), (negative_spec (cross u d))]; trivial; exfalso; lra.
  - refine (eventually_implied _ _ _ (eventually_and _ _ (eventually_below 1 ltac:(lra)) (turn_stays d u more))).
    intros radius [[R _] stays] u' close. specialize (stays d u' (still radius R) close).
    pose proof (turned u) as at_u. pose proof (turned u') as at_u'. split; [| apply some; lra].
    unfold left_of_ray. destruct k; [f_equal; destruct (negative_spec (cross d u')), (negative_spec (cross d u)) |
      destruct (negative_spec (cross u' d)), (negative_spec (cross u d))]; trivial; exfalso; lra.
Qed.

(* Two directions on two sides of a line that neither is along do not lie in line, if they are not opposite. *)
Lemma across_a_line (k : summand) (d u v : vector) : turns u v -> ~ cross d u == 0 -> ~ cross d v == 0 ->
  left_of_ray k d u <> left_of_ray k d v -> ~ cross u v == 0.
Proof.
  intros (some_u & some_v & forwards) beside_u beside_v differ line. specialize (forwards line).
  destruct (multiple_of u v some_v line) as (c & X & Y). pose proof (square_positive v some_v) as square.
  assert (c_positive : 0 < c).
  { assert (c * dot v v == dot u v) by (unfold dot; rewrite X, Y; ring). nra. }
  assert (scaled : cross d u == c * cross d v) by (unfold cross; rewrite X, Y; ring).
  assert (turned : forall w, cross w d == - cross d w) by (intros; unfold cross; ring).
  pose proof (turned u). pose proof (turned v). apply differ. unfold left_of_ray.
  destruct k; [f_equal; destruct (negative_spec (cross d u)), (negative_spec (cross d v)) |
    destruct (negative_spec (cross u d)), (negative_spec (cross v d))]; trivial; exfalso; nra.
Qed.

(* Lemma. What a turn counts stays. *)
Lemma sweep_stays (k : summand) (d u v : vector) : nonzero d ->
  turns u v -> ~ cross d u == 0 -> ~ cross d v == 0 ->
  eventually (fun radius => forall u' v', within radius u u' -> within radius v v' ->
    sweep (Direction d k) u' v' = sweep (Direction d k) u v).
Proof.
  intros some turn beside_u beside_v.
  assert (turned : forall a b, cross a b == - cross b a) by (intros; unfold cross; ring).
  assert (sign_stays : left_of_ray k d u <> left_of_ray k d v -> eventually (fun radius => forall u' v',
    within radius u u' -> within radius v v' -> (cross u' v' ?= 0) = (cross u v ?= 0))).
  { intros differ. pose proof (across_a_line k d u v turn beside_u beside_v differ) as no.
    destruct (Q_dec (cross u v) 0) as [[less | more] | none]; [| | contradiction].
    - refine (eventually_implied _ _ _ (turn_stays v u ltac:(rewrite turned; lra))).
      intros radius stays u' v' U V. specialize (stays v' u' V U). rewrite turned in stays.
      now rewrite (proj1 (Qlt_alt (cross u v) 0) less), (proj1 (Qlt_alt (cross u' v') 0)) by lra.
    - refine (eventually_implied _ _ _ (turn_stays u v more)). intros radius stays u' v' U V.
      now rewrite (proj1 (Qgt_alt (cross u v) 0) more), (proj1 (Qgt_alt (cross u' v') 0) (stays u' v' U V)). }
  destruct turn as (some_u & some_v & forwards).
  destruct (bool_dec (left_of_ray k d u) (left_of_ray k d v)) as [equal | differ].
  - refine (eventually_implied _ _ _ (eventually_and _ _ (side_of_a_ray_stays k d u beside_u)
      (side_of_a_ray_stays k d v beside_v))).
    intros radius [at_u at_v] u' v' U V. destruct (at_u u' U) as [left_u some_u'], (at_v v' V) as [left_v some_v'].
    rewrite !sweep_by_sides by assumption. rewrite left_u, left_v, equal. unfold ray_crossing. now rewrite eqb_reflx.
  - refine (eventually_implied _ _ _ (eventually_and _ _ (sign_stays differ) (eventually_and _ _
      (side_of_a_ray_stays k d u beside_u) (side_of_a_ray_stays k d v beside_v)))).
    intros radius (sign & at_u & at_v) u' v' U V.
    destruct (at_u u' U) as [left_u some_u'], (at_v v' V) as [left_v some_v'].
    now rewrite !sweep_by_sides, left_u, left_v, (sign u' v' U V) by assumption.
Qed.

(* A direction to which none of these is parallel. *)
Lemma direction_parallel_to_none (l : list vector) : (forall u, In u l -> nonzero u) ->
  exists d, nonzero d /\ forall u, In u l -> ~ cross d u == 0.
Proof.
  intros some.
  assert (small : eventually (fun e => forall u, In u l -> ~ vy u + e * - vx u == 0)).
  { apply eventually_for_all. intros u U. destruct (Qeq_dec (vx u) 0) as [none | slanted].
    - exists 1. split; [lra |]. intros e _ _ zero_. apply (some u U). split; [exact none |]. rewrite none in zero_. lra.
    - apply leaves_a_number. lra. }
  destruct (some_small _ small) as (e & _ & across). exists (Vector 1 e).
  split; [unfold nonzero; cbn [vx vy]; lra |]. intros u U zero_. apply (across u U).
  unfold cross in zero_. cbn [vx vy] in zero_. lra.
Qed.

(* Lemma. What many turns count together stays. *)
Lemma sweeps_stay (n : nat) (k : summand) (d : vector) (f g : nat -> vector) : nonzero d ->
  (forall i, (i < n)%nat -> turns (f i) (g i) /\ ~ cross d (f i) == 0 /\ ~ cross d (g i) == 0) ->
  eventually (fun radius => forall f' g',
    (forall i, (i < n)%nat -> within radius (f i) (f' i) /\ within radius (g i) (g' i)) ->
    sum (map (fun i => sweep (Direction d k) (f' i) (g' i)) (seq 0 n)) =
    sum (map (fun i => sweep (Direction d k) (f i) (g i)) (seq 0 n))).
Proof.
  intros some each.
  refine (eventually_implied _ _ _ (eventually_for_all (fun i radius => forall u' v',
    within radius (f i) u' -> within radius (g i) v' ->
    sweep (Direction d k) u' v' = sweep (Direction d k) (f i) (g i)) (seq 0 n) _)).
  - intros radius stays f' g' close. f_equal. apply map_ext_in. intros i I. apply (stays i I); apply in_seq in I;
      apply close; lia.
  - intros i I. apply in_seq in I. destruct (each i ltac:(lia)) as (turn & beside_u & beside_v).
    now apply sweep_stays.
Qed.

Lemma edges_by_number (chain : list vector) : edges chain = map (edge_at chain) (seq 0 (length chain)).
Proof.
  apply (nth_ext _ _ no_segment (edge_at chain 0)).
  - now rewrite edges_are_as_many, map_length, seq_length.
  - intros i I. rewrite edges_are_as_many in I. rewrite map_nth, seq_nth by exact I. reflexivity.
Qed.

Lemma within_seen (radius : Q) (a b x : vector) : within radius a b -> within radius (minus a x) (minus b x).
Proof. unfold within, minus. cbn [vx vy]. lra. Qed.

(* Theorem. The winding number of a point off the chain stays while the vertices are moved a little. *)
Theorem winding_number_stays (chain : list vector) (x : vector) : off x (edges chain) ->
  eventually (fun radius => forall moved_, near radius chain moved_ -> off x (edges moved_) ->
    winding_number x (edges moved_) = winding_number x (edges chain)).
Proof.
  intros free. set (n := length chain).
  assert (turn : forall i, (i < n)%nat ->
    turns (minus (source (edge_at chain i)) x) (minus (target (edge_at chain i)) x)).
  { intros i I. apply turns_around, free, nth_In. now rewrite edges_are_as_many. }
  destruct (direction_parallel_to_none (map (fun i => minus (source (edge_at chain i)) x) (seq 0 n) ++
    map (fun i => minus (target (edge_at chain i)) x) (seq 0 n))) as (d & some & across).
  { intros u U. apply in_app_iff in U. destruct U as [U | U]; apply in_map_iff in U; destruct U as (i & <- & I);
      apply in_seq in I; apply turn; lia. }
  assert (by_sweeps : forall c, off x (edges c) -> winding_number x (edges c) =
    sum (map (fun i => sweep (Direction d OfP) (minus (source (edge_at c i)) x) (minus (target (edge_at c i)) x))
      (seq 0 (length c)))).
  { intros c free_c. rewrite <- (winding_number_by_any_ray x (edges c) OfP d (closed_chain_cycles c) free_c some).
    rewrite ray_as_sweeps by assumption. unfold total. rewrite edges_by_number at 1. now rewrite !map_map. }
  refine (eventually_implied _ _ _ (sweeps_stay n OfP d (fun i => minus (source (edge_at chain i)) x)
    (fun i => minus (target (edge_at chain i)) x) some _)).
  - intros radius stays moved_ [same_length close] free'.
    rewrite (by_sweeps chain free), (by_sweeps moved_ free'), same_length. apply stays. intros i I.
    rewrite (edge_is moved_ i), (edge_is chain i), same_length by (rewrite ?same_length; exact I). cbn [source target].
    split; apply within_seen, close; [exact I | now apply next_in_range].
  - intros i I. split; [now apply turn |].
    split; apply across, in_app_iff; [left | right]; apply in_map_iff; exists i; (split; [reflexivity |]);
      apply in_seq; lia.
Qed.

(* Small moves do not bring an edge to a point off the chain. *)
Lemma stays_off (chain : list vector) (x : vector) : off x (edges chain) ->
  eventually (fun radius => forall moved_, near radius chain moved_ -> off x (edges moved_)).
Proof.
  intros free.
  refine (eventually_implied _ _ _ (eventually_for_all (fun i radius => forall a b,
    within radius (vertex chain i) a -> within radius (vertex chain (next i (length chain))) b ->
    ~ lies_on x (Segment a b)) (seq 0 (length chain)) _)).
  - intros radius stays moved_ [same_length close] t T. rewrite edges_by_number in T. apply in_map_iff in T.
    destruct T as (i & <- & I). apply in_seq in I. rewrite same_length in I.
    rewrite edge_is, same_length by lia. apply (stays i); [apply in_seq; lia | apply close; lia |].
    apply close, next_in_range. lia.
  - intros i I. apply in_seq in I. pose proof (free (edge_at chain i)) as off_edge.
    rewrite edge_is in off_edge by lia.
    specialize (off_edge ltac:(rewrite <- edge_is by lia; apply nth_In; rewrite edges_are_as_many; lia)).
    destruct (turning_is_in_front _ _ (turns_around x _ off_edge)) as (w & f & g). cbn [source target] in f, g.
    assert (moves : forall a, in_front w (minus a x) -> eventually (fun radius => forall b, within radius a b ->
      in_front w (minus b x))).
    { intros a front. refine (eventually_implied _ _ _ (eventually_positive _ (- (Qabs (vx w) + Qabs (vy w))) front)).
      intros radius some b [X Y]. pose proof (product_bounds _ (vx w) _ X). pose proof (product_bounds _ (vy w) _ Y).
      unfold in_front, dot, minus in *. cbn [vx vy] in *. lra. }
    refine (eventually_implied _ _ _ (eventually_and _ _ (moves _ f) (moves _ g))).
    intros radius [at_a at_b] a b A B (t & range & X & Y). specialize (at_a a A). specialize (at_b b B).
    cbn [source target] in X, Y. unfold in_front, dot, minus in *. cbn [vx vy] in *.
    assert (0 < (1 - t) * (vx w * (vx a - vx x) + vy w * (vy a - vy x)) +
      t * (vx w * (vx b - vx x) + vy w * (vy b - vy x))) by (apply mixed_is_more; assumption).
    assert ((1 - t) * (vx w * (vx a - vx x) + vy w * (vy a - vy x)) +
      t * (vx w * (vx b - vx x) + vy w * (vy b - vy x)) == 0); [| lra].
    rewrite X, Y. ring.
Qed.
