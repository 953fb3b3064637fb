(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Simple chains (thesis, Definition 2.1.4), as reference/chains/validity.cpp asks for them, defined by points;
   and that a test by signs of the coordinates decides whether a chain is one. That two segments have no
   point in common is decided in segments_apart.v. *)
From Coq Require Import PeanoNat Lia Bool List Permutation.
From Oplus Require Import numbers convolution regions secants segments_apart.
Import ListNotations.

Open Scope nat_scope.

(* Vertex i of a chain. *)
Definition vertex (chain : list vector) (i : nat) : vector := nth i chain nowhere.

(* Three vertices or more, no two consecutive ones equal; and where two edges have a point in common, one of
   them leads to it, and the other one is the next and leaves it. So no vertex is repeated, none is inside
   an edge, and edges neither cross nor overlap. A vertex may be inside a straight line. *)
Definition simple (chain : list vector) : Prop :=
  let n := length chain in
  3 <= n /\ no_edge_is_a_point chain /\
  forall i j x, i < n -> j < n -> i <> j -> lies_on x (edge_at chain i) -> lies_on x (edge_at chain j) ->
    (j = next i n /\ equal_vectors x (vertex chain j)) \/
    (i = next j n /\ equal_vectors x (vertex chain i)).

(* What the code can compute: at each vertex the chain does not turn back, and edges that do not follow each
   other are apart. *)
Definition is_simple (chain : list vector) : bool :=
  let n := length chain in
  let from i := vertex chain i in let to i := vertex chain (next i n) in
  (3 <=? n) &&
  forallb (fun i => may_turn (minus (to i) (from i)) (minus (to (next i n)) (from (next i n))))
    (seq 0 n) &&
  forallb (fun pair => let i := fst pair in let j := snd pair in
      (i =? j) || (j =? next i n) || (i =? next j n) || are_apart (from i) (to i) (from j) (to j))
    (list_prod (seq 0 n) (seq 0 n)).

Lemma rotated_length {A} (l : list A) : length (rotated l) = length l.
Proof. destruct l; [reflexivity |]. cbn. rewrite app_length. cbn. lia. Qed.

Lemma edge_is chain i :
  i < length chain ->
  edge_at chain i = Segment (vertex chain i) (vertex chain (next i (length chain))).
Proof. apply edge_by_index. Qed.

Lemma edge_of_chain_joins_vertices chain i :
  i < length chain ->
  edge_of_chain chain i = minus (vertex chain (next i (length chain))) (vertex chain i).
Proof. apply regions.edge_of_chain_is. Qed.

Lemma next_differs i n : 3 <= n -> i < n ->
  next i n < n /\ next i n <> i /\ next (next i n) n <> i /\ next (next i n) n <> next i n.
Proof.
  intros N I. unfold next. destruct (Nat.eqb_spec (S i) n); [destruct (Nat.eqb_spec 1 n); lia |].
  destruct (Nat.eqb_spec (S (S i)) n); lia.
Qed.

Lemma edges_of_simple_chains chain i :
  no_edge_is_a_point chain -> i < length chain ->
  nonzero (minus (vertex chain (next i (length chain))) (vertex chain i)).
Proof. intros e I. rewrite <- edge_of_chain_joins_vertices by exact I. now apply edge_nonzero. Qed.

Lemma simple_chain_turns chain i : simple chain -> i < length chain ->
  let n := length chain in
  turns (minus (vertex chain (next i n)) (vertex chain i))
        (minus (vertex chain (next (next i n) n)) (vertex chain (next i n))).
Proof.
  intros (N & e & common) I n. destruct (next_differs i n N I) as (J & differs & again & _).
  apply may_turn_decides; [now apply edges_of_simple_chains .. |].
  intros x on_i on_j. rewrite <- edge_is in on_i by exact I.
  pose proof (edge_is chain (next i n) J) as edge_j. fold n in edge_j. rewrite <- edge_j in on_j.
  destruct (common i (next i n) x I J (not_eq_sym differs) on_i on_j) as [[_ x_is] | [i_is _]];
    [exact x_is | now elim again].
Qed.

Lemma simple_chain_edges_apart chain i j : simple chain -> i < length chain -> j < length chain ->
  let n := length chain in
  i <> j -> j <> next i n -> i <> next j n ->
  are_apart (vertex chain i) (vertex chain (next i n)) (vertex chain j) (vertex chain (next j n)) = true.
Proof.
  intros (N & e & common) I J n differ not_next not_before.
  destruct (are_apart_decides (vertex chain i) (vertex chain (next i n)) (vertex chain j)
              (vertex chain (next j n))) as [[found | (x & on_i & on_j)] _];
    [now apply edges_of_simple_chains | exact found | exfalso].
  rewrite <- edge_is in on_i, on_j by assumption.
  destruct (common i j x I J differ on_i on_j) as [[? _] | [? _]]; contradiction.
Qed.

(* Where a chain turns at each vertex and other edges are apart, it is simple. *)
Lemma simple_by_turns chain : let n := length chain in
  3 <= n ->
  (forall i, i < n -> turns (minus (vertex chain (next i n)) (vertex chain i))
                            (minus (vertex chain (next (next i n) n)) (vertex chain (next i n)))) ->
  (forall i j, i < j -> j < n -> j <> next i n -> i <> next j n ->
     apart (vertex chain i) (vertex chain (next i n)) (vertex chain j) (vertex chain (next j n))) ->
  simple chain.
Proof.
  intros n N turn far.
  assert (edges_nonzero : no_edge_is_a_point chain).
  { intros e I. apply (In_nth _ _ nowhere) in I. destruct I as (i & I & <-).
    rewrite edges_length in I. fold (edge_of_chain chain i). rewrite edge_of_chain_joins_vertices by exact I.
    now destruct (turn i I). }
  split; [exact N | split; [exact edges_nonzero |]]. fold n.
  assert (one_way : forall i x, i < n -> lies_on x (edge_at chain i) -> lies_on x (edge_at chain (next i n)) ->
    equal_vectors x (vertex chain (next i n))).
  { intros i x I on_i on_j. destruct (next_differs i n N I) as (J & _).
    rewrite edge_is in on_i by exact I. rewrite (edge_is chain (next i n) J) in on_j.
    refine (proj1 (may_turn_decides _ _ _ _ _) (turn i I) x on_i on_j);
      now apply edges_of_simple_chains. }
  intros i j x I J differ on_i on_j.
  destruct (Nat.eq_dec j (next i n)) as [-> | not_next]; [left; split; [reflexivity | now apply one_way] |].
  destruct (Nat.eq_dec i (next j n)) as [-> | not_before]; [right; split; [reflexivity | now apply one_way] |].
  exfalso. rewrite edge_is in on_i, on_j by assumption.
  destruct (Nat.lt_trichotomy i j) as [less | [same | more]]; [| contradiction |].
  - exact (apart_have_no_common_point _ _ _ _ x (far i j less J not_next not_before) on_i on_j).
  - exact (apart_have_no_common_point _ _ _ _ x (far j i more I not_before not_next) on_j on_i).
Qed.

(* Theorem. A chain is simple iff the test says so. *)
Theorem is_simple_decides (chain : list vector) : is_simple chain = true <-> simple chain.
Proof.
  unfold is_simple. set (n := length chain).
  rewrite !andb_true_iff, Nat.leb_le, !forallb_forall. split.
  - intros [[N corners_turn] edges_apart]. apply simple_by_turns; [exact N | |]; fold n.
    + intros i I. specialize (corners_turn i). rewrite in_seq in corners_turn. cbv beta in corners_turn.
      destruct (may_turn_spec (minus (vertex chain (next i n)) (vertex chain i))
                  (minus (vertex chain (next (next i n) n)) (vertex chain (next i n))));
        [assumption | discriminate corners_turn; lia].
    + intros i j less J not_next not_before. specialize (edges_apart (i, j)). cbn [fst snd] in edges_apart.
      rewrite in_prod_iff, !in_seq in edges_apart. apply are_apart_sound.
      destruct (Nat.eqb_spec i j), (Nat.eqb_spec j (next i n)), (Nat.eqb_spec i (next j n)); try contradiction;
        [lia | apply edges_apart; lia].
  - intros chain_simple. pose proof chain_simple as (N & _).
    split; [split; [exact N |] |].
    + intros i I. apply in_seq in I.
      destruct (may_turn_spec (minus (vertex chain (next i n)) (vertex chain i))
                  (minus (vertex chain (next (next i n) n)) (vertex chain (next i n)))) as [| back];
        [reflexivity | exfalso; apply back, simple_chain_turns; [assumption | lia]].
    + intros [i j] I. apply in_prod_iff in I. rewrite !in_seq in I. cbn [fst snd].
      destruct (Nat.eqb_spec i j), (Nat.eqb_spec j (next i n)), (Nat.eqb_spec i (next j n));
        try reflexivity. cbn [orb]. apply simple_chain_edges_apart; trivial; lia.
Qed.
