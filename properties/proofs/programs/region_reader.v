(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Regions as the programs read them, from bytes: WKT, POLYGON, MULTIPOLYGON and EMPTY, and .dat (docs/files.md); and
   sets that have edges and points of their own, a GEOMETRYCOLLECTION of a region, line strings and points. The reader
   goes from state to state, byte by byte, so a program need not hold a text as a whole, and can end at the first
   error. That it reads what is printed as what it was is proved in printed_regions_are_read.v. *)
From Coq Require Import QArith ZArith Bool List String Ascii.
From Oplus Require Import specification.
Import ListNotations.

Open Scope Z_scope.

(** Texts *)

(* Bytes are their codes. *)
Definition text := list Z.

Definition code (c : ascii) : Z := Z.of_N (N_of_ascii c).
Definition bytes (s : string) : text := map code (list_ascii_of_string s).

Definition digit_0 := code "0".
Definition digit_9 := code "9".
Definition sign_plus := code "+".
Definition sign_minus := code "-".
Definition full_stop := code ".".
Definition slash_sign := code "/".
Definition opening_sign := code "(".
Definition closing_sign := code ")".
Definition comma_sign := code ",".
Definition small_a := code "a".
Definition small_z := code "z".
Definition big_e := code "E".
Definition tab := 9.
Definition new_line := 10.
Definition carriage_return := 13.
Definition blank_sign := 32.
Definition polygon_word := bytes "POLYGON".
Definition multipolygon_word := bytes "MULTIPOLYGON".
Definition line_string_word := bytes "LINESTRING".
Definition line_strings_word := bytes "MULTILINESTRING".
Definition point_word := bytes "POINT".
Definition points_word := bytes "MULTIPOINT".
Definition collection_word := bytes "GEOMETRYCOLLECTION".
Definition empty_word := bytes "EMPTY".

Fixpoint same_text (a b : text) : bool :=
  match a, b with
  | [], [] => true
  | c :: a', d :: b' => (c =? d) && same_text a' b'
  | _, _ => false
  end.

Definition upper (b : Z) : Z := if (small_a <=? b) && (b <=? small_z) then b - blank_sign else b.

(** Numbers *)

(* Digits with the last one first, in base ten, a hundred, ten thousand, ..., so that long numbers take less time. *)
Fixpoint in_pairs (base : Z) (digits : list Z) : list Z :=
  match digits with
  | low :: high :: more => low + base * high :: in_pairs base more
  | _ => digits
  end.

Fixpoint value_of_digits (levels : nat) (base : Z) (digits : list Z) : Z :=
  match digits, levels with
  | [], _ => 0
  | [digit], _ => digit
  | _, S fewer => value_of_digits fewer (base * base) (in_pairs base digits)
  | _, O => fold_right (fun digit value => digit + base * value) 0 digits
  end.

(* The value of the digits that a word starts with, if there are any, how many these are, and the rest. *)
Fixpoint leading_digits (found : list Z) (w : text) : list Z * text :=
  match w with
  | b :: rest => if (digit_0 <=? b) && (b <=? digit_9) then leading_digits (b - digit_0 :: found) rest else (found, w)
  | [] => (found, [])
  end.

Definition natural_of (digits : list Z) : Z := value_of_digits 64 10 digits.

Fixpoint power_of_ten (n : positive) : Z :=
  match n with
  | xH => 10
  | xO half => let p := power_of_ten half in p * p
  | xI half => let p := power_of_ten half in 10 * (p * p)
  end.

Definition times_power_of_ten (n k : Z) : Q :=
  match k with
  | Z0 => inject_Z n
  | Zpos p => inject_Z (n * power_of_ten p)
  | Zneg p => Qred (n # Z.to_pos (power_of_ten p))
  end.

Inductive complaint :=
| NoKeyword | NotOpened | NotContinued | NoNumber | NoDenominator | LargeExponent | NotEnded | NoCount
| NotClosed | EdgesOverlap | FewVertices (count : Z) | NoOuterChain | LongWord
| NoSet | NoGeometry | ShortLine.

Definition begins_with (c : Z) (w : text) : bool := match w with b :: _ => b =? c | [] => false end.
Definition is_symbol (c : Z) (w : text) : bool := match w with [b] => b =? c | _ => false end.

Definition without_sign (w : text) : text := if begins_with sign_plus w || begins_with sign_minus w then tl w else w.

Definition largest_exponent : Z := 4096.

(* An integer, a decimal, which may have an exponent, or a fraction. *)
Definition number_in (w : text) : Q + complaint :=
  let sign := if begins_with sign_minus w then -1 else 1 in
  let (whole, rest) := leading_digits [] (without_sign w) in
  if begins_with slash_sign rest then
    match whole, leading_digits [] (tl rest) with
    | _ :: _, ((_ :: _) as below, []) =>
      match natural_of below with
      | Zpos d => inl (Qred (sign * natural_of whole # d))
      | _ => inr NoDenominator
      end
    | _, _ => inr NoNumber
    end
  else
    let (digits, rest') := if begins_with full_stop rest then leading_digits whole (tl rest) else (whole, rest) in
    let decimals := Z.of_nat (List.length digits) - Z.of_nat (List.length whole) in
    let mantissa := sign * natural_of digits in
    match digits, rest' with
    | [], _ => inr NoNumber
    | _, [] => inl (times_power_of_ten mantissa (- decimals))
    | _, e :: exponent =>
      match leading_digits [] (without_sign exponent) with
      | ((_ :: _) as digits', []) =>
        let n := natural_of digits' in
        if negb (upper e =? big_e) then inr NoNumber
        else if largest_exponent <? n then inr LargeExponent
        else inl (times_power_of_ten mantissa ((if begins_with sign_minus exponent then - n else n) - decimals))
      | _ => inr NoNumber
      end
    end.

Definition longest_text : Z := 2 ^ 27.

(* A number of things in a text. *)
Definition count_of (w : text) : option Z :=
  match leading_digits [] w with
  | ((_ :: _) as digits, []) => let n := natural_of digits in if n <=? longest_text then Some n else None
  | _ => None
  end.

(** Orientation *)

Definition points_compared (a b : point) : comparison :=
  match x_of a ?= x_of b with Eq => y_of a ?= y_of b | other => other end%Q.

(* An edge from a vertex to another one that leaves the vertex, or arrives there. *)
Definition lower_edge (v : point) (best : option (point * bool)) (e : point * bool) : option (point * bool) :=
  match best with
  | None => None
  | Some (a, leaves) =>
    match (turn v a (fst e) ?= 0)%Q with Eq => None | Lt => Some e | Gt => Some (a, leaves) end
  end.

(* Whether a chain, which may touch itself but not cross, is counterclockwise. Beyond the first edge counterclockwise
   at its leftmost vertex, the lowest of these, is the outside: is it an edge that leaves, or arrives? *)
Definition runs_counterclockwise (c : chain) : option bool :=
  match c with
  | [] => None
  | first :: rest =>
    let v := fold_left (fun a b => match points_compared b a with Lt => b | _ => a end) rest first in
    let corners := combine (last c first :: c) (combine c (rest ++ [first])) in
    let edges := flat_map (fun corner =>
      match points_compared (fst (snd corner)) v with
      | Eq => [(snd (snd corner), true); (fst corner, false)]
      | _ => []
      end) corners in
    match edges with
    | [] => None
    | e :: others => option_map snd (fold_left (lower_edge v) others (Some e))
    end
  end.

(* The same chain in this orientation, from the same vertex. *)
Definition oriented (counterclockwise : bool) (c : chain) : option chain :=
  match runs_counterclockwise c with
  | None => None
  | Some is_so =>
    if Bool.eqb is_so counterclockwise then Some c else Some (match c with [] => [] | v :: rest => v :: rev' rest end)
  end.

(** Words to regions *)

(* Points are a ring or a line string; Vertices are points of their own. *)
Inductive lists := Polygons | Rings | Points | Lines | Vertices.

(* What is expected next. In WKT `all` is the list that the text or an item of a collection is, after its keyword. *)
Inductive stage :=
| Start (may_be_unbounded : bool)
| StartOfSet
| Collection (* its items *)
| Item
| Contents (all : lists)
| Opening (all this : lists)
| X (all : lists)
| Y (all : lists) (x : Q)
| Next (all this : lists)
| Complete
| OuterChain (may_be_unbounded : bool) (* in .dat: its outer chain *)
| Holes (is_first is_unbounded may_be_unbounded : bool) (* their number *)
| Hole (holes : Z) (may_be_unbounded : bool)
| VertexX (count : Z) (then_ : stage)
| VertexY (count : Z) (then_ : stage) (x : Q).

(* What was read beside chains; edges and points with the last ones first. *)
Record beside_chains := Beside {
  is_unbounded : bool; in_collection : bool; edges_so_far : list edge; points_so_far : list point }.

(* What was read: chains, and the vertices of the next one, with the last ones first; and whether that one is a hole. *)
Record so_far := SoFar { chains : polygonal_region; ring_so_far : chain; is_hole : bool; beside : beside_chains }.

Definition with_vertex (r : so_far) (x y : Q) : so_far :=
  SoFar (chains r) (Point x y :: ring_so_far r) (is_hole r) (beside r).

Definition with_chain (r : so_far) (c : chain) : so_far + complaint :=
  match oriented (negb (is_hole r)) c with
  | Some c' => inl (SoFar (c' :: chains r) [] true (beside r))
  | None => inr EdgesOverlap
  end.

Definition with_outer_chain_next (r : so_far) : so_far := SoFar (chains r) [] false (beside r).
Definition with_holes_next (r : so_far) (unbounded : bool) : so_far :=
  let o := beside r in
  SoFar (chains r) [] true
    (Beside (unbounded || is_unbounded o) (in_collection o) (edges_so_far o) (points_so_far o)).

Definition with_collection (r : so_far) (is_open : bool) : so_far :=
  let o := beside r in SoFar (chains r) [] false (Beside (is_unbounded o) is_open (edges_so_far o) (points_so_far o)).

(* A ring has its first vertex again as its last one. *)
Definition with_ring (r : so_far) : so_far + complaint :=
  match ring_so_far r with
  | last_ :: ((_ :: _) as others) =>
    match points_compared last_ (last others last_) with
    | Eq => with_chain r (rev' others)
    | _ => inr NotClosed
    end
  | _ => inr NotClosed
  end.

(* The edges from each vertex to the next one. *)
Definition with_line (r : so_far) : so_far + complaint :=
  let o := beside r in
  match ring_so_far r with
  | _ :: ((_ :: _) as others_) =>
    inl (SoFar (chains r) [] false (Beside (is_unbounded o) (in_collection o)
      (combine others_ (ring_so_far r) ++ edges_so_far o) (points_so_far o)))
  | _ => inr ShortLine
  end.

Definition with_points (r : so_far) : so_far :=
  let o := beside r in
  SoFar (chains r) [] false
    (Beside (is_unbounded o) (in_collection o) (edges_so_far o) (ring_so_far r ++ points_so_far o)).

(* The list of vertices as what it is in. *)
Definition with_list (all : lists) (r : so_far) : so_far + complaint :=
  match all with
  | Polygons | Rings => with_ring r
  | Points | Lines => with_line r
  | Vertices => inl (with_points r)
  end.

Definition at_stage (p : stage) (read : so_far + complaint) : (so_far * stage) + complaint :=
  match read with inl r => inl (r, p) | inr wrong => inr wrong end.

Definition opened (all this : lists) (r : so_far) : so_far * stage :=
  match this with
  | Polygons => (r, Opening all Rings)
  | Rings => (with_outer_chain_next r, Opening all Points)
  | Lines => (r, Opening all Points)
  | Points | Vertices => (r, X all)
  end.

Definition after_list (all this : lists) : stage :=
  match all, this with
  | Polygons, Points => Next all Rings
  | Polygons, Rings => Next all Polygons
  | Rings, Points => Next all Rings
  | Lines, Points => Next all Lines
  | _, _ => Complete
  end.

Definition continued (all this : lists) (r : so_far) : so_far * stage :=
  match this with
  | Polygons => (r, Opening all Rings)
  | Rings | Lines => (r, Opening all Points)
  | Points | Vertices => (r, X all)
  end.

Definition with_count (r : so_far) (w : text) (f : Z -> (so_far * stage) + complaint) : (so_far * stage) + complaint :=
  match count_of w with Some n => f n | None => inr NoCount end.

Definition counted_chain (r : so_far) (then_ : stage) (n : Z) : (so_far * stage) + complaint :=
  if n <? 3 then inr (FewVertices n) else inl (r, VertexX n then_).

Definition with_number (r : so_far) (w : text) (f : Q -> (so_far * stage) + complaint) : (so_far * stage) + complaint :=
  match number_in w with inl q => f q | inr wrong => inr wrong end.

Definition take_component (is_first may_be_unbounded : bool) (r : so_far) (w : text) : (so_far * stage) + complaint :=
  if is_symbol digit_0 w then
    if is_first || may_be_unbounded then inl (with_holes_next r false, Holes is_first true may_be_unbounded)
    else inr NoOuterChain
  else
    let r' := with_outer_chain_next r in with_count r' w (counted_chain r' (Holes is_first false may_be_unbounded)).

(* The keyword of a region, or of edges or points. *)
Definition list_of_region (w : text) : option lists :=
  if same_text (map upper w) polygon_word then Some Rings
  else if same_text (map upper w) multipolygon_word then Some Polygons
  else None.

Definition list_of_item (w : text) : option lists :=
  if same_text (map upper w) line_string_word then Some Points
  else if same_text (map upper w) line_strings_word then Some Lines
  else if same_text (map upper w) point_word || same_text (map upper w) points_word then Some Vertices
  else list_of_region w.

(* Otherwise the region is in .dat. *)
Definition take_start (all : option lists) (wrong : complaint) (may_be_unbounded : bool) (r : so_far) (w : text) :
  (so_far * stage) + complaint :=
  match all, leading_digits [] w with
  | Some all, _ => inl (r, Contents all)
  | None, (_ :: _, []) => take_component true may_be_unbounded r w
  | None, _ => inr wrong
  end.

(* Goes on with a word; the empty_word word is the end. *)
Definition take_word (p : stage) (r : so_far) (w : text) : (so_far * stage) + complaint :=
  match p with
  | Start may_be_unbounded => take_start (list_of_region w) NoKeyword may_be_unbounded r w
  | StartOfSet =>
    if same_text (map upper w) collection_word then inl (r, Collection)
    else take_start (list_of_item w) NoSet false r w
  | Collection =>
    if same_text (map upper w) empty_word then inl (r, Complete)
    else if is_symbol opening_sign w then inl (with_collection r true, Item) else inr NotOpened
  | Item => match list_of_item w with Some all => inl (r, Contents all) | None => inr NoGeometry end
  | Contents all =>
    if same_text (map upper w) empty_word then inl (r, Complete)
    else if is_symbol opening_sign w then inl (opened all all r) else inr NotOpened
  | Opening all this => if is_symbol opening_sign w then inl (opened all this r) else inr NotOpened
  | X all => with_number r w (fun x => inl (r, Y all x))
  | Y all x => with_number r w (fun y => inl (with_vertex r x y, Next all Points))
  | Next all this =>
    if is_symbol comma_sign w then inl (continued all this r)
    else if is_symbol closing_sign w then
      match this with
      | Points => at_stage (after_list all this) (with_list all r)
      | _ => inl (r, after_list all this)
      end
    else inr NotContinued
  | Complete =>
    if negb (in_collection (beside r)) then inr NotEnded
    else if is_symbol comma_sign w then inl (r, Item)
    else if is_symbol closing_sign w then inl (with_collection r false, Complete) else inr NotContinued
  | OuterChain may_be_unbounded => take_component false may_be_unbounded r w
  | Holes is_first is_unbounded_ may_be_unbounded =>
    if is_unbounded_ && negb may_be_unbounded then inr NoOuterChain
    else with_count r w (fun n => inl (with_holes_next r is_unbounded_,
      let may_be_so := may_be_unbounded && negb is_unbounded_ in
      if n =? 0 then OuterChain may_be_so else Hole n may_be_so))
  | Hole holes may_be_unbounded =>
    with_count r w (counted_chain r
      (if holes =? 1 then OuterChain may_be_unbounded else Hole (holes - 1) may_be_unbounded))
  | VertexX n then_ => with_number r w (fun x => inl (r, VertexY n then_ x))
  | VertexY n then_ x =>
    with_number r w (fun y =>
      let r' := with_vertex r x y in
      if n =? 1 then at_stage then_ (with_chain r' (rev' (ring_so_far r'))) else inl (r', VertexX (n - 1) then_))
  end.

(* Whether a text may end there. *)
Definition may_end (p : stage) : bool :=
  match p with Complete | OuterChain _ | Holes true _ _ => true | _ => false end.

(** Bytes to words *)

(* The word that is being read has its last byte first. *)
Record reading := Reading { line_number : Z; word : text; length_of_word : Z; stage_of : stage; result : so_far }.

Record failure := Failure { in_line : Z; at_word : text; what : complaint }.

Definition start_from (p : stage) : reading + failure :=
  inl (Reading 1 [] 0 p (SoFar [] [] false (Beside false false [] []))).

Definition start (may_be_unbounded : bool) : reading + failure := start_from (Start may_be_unbounded).
Definition start_of_set : reading + failure := start_from StartOfSet.

Definition longest_word : Z := 100000.

Definition go_on (s : reading) (w : text) : reading + failure :=
  match take_word (stage_of s) (result s) w with
  | inl (r, p) => inl (Reading (line_number s) [] 0 p r)
  | inr wrong => inr (Failure (line_number s) w wrong)
  end.

Definition end_word (s : reading) : reading + failure := match word s with [] => inl s | w => go_on s (rev' w) end.

Definition and_then (now : reading + failure) (f : reading -> reading + failure) : reading + failure :=
  match now with inl s => f s | inr wrong => inr wrong end.

Definition next_line (s : reading) : reading + failure :=
  inl (Reading (line_number s + 1) (word s) (length_of_word s) (stage_of s) (result s)).

Definition take_byte (now : reading + failure) (b : Z) : reading + failure :=
  and_then now (fun s =>
    if (b =? opening_sign) || (b =? closing_sign) || (b =? comma_sign)
    then and_then (end_word s) (fun s' => go_on s' [b])
    else if (b =? blank_sign) || (b =? tab) || (b =? carriage_return) then end_word s
    else if b =? new_line then and_then (end_word s) next_line
    else if length_of_word s =? longest_word then inr (Failure (line_number s) (rev' (word s)) LongWord)
    else inl (Reading (line_number s) (b :: word s) (length_of_word s + 1) (stage_of s) (result s))).

(* What was read, at the end of the text. *)
Definition all_read (now : reading + failure) : so_far + failure :=
  match and_then now end_word with
  | inr wrong => inr wrong
  | inl s =>
    if may_end (stage_of s) && negb (in_collection (beside (result s))) then inl (result s)
    else match go_on s [] with inl _ => inr (Failure (line_number s) [] NotEnded) | inr wrong => inr wrong end
  end.

(* Whether the region is unbounded, and its chains. *)
Definition at_end (now : reading + failure) : (bool * polygonal_region) + failure :=
  match all_read now with
  | inl r => inl (is_unbounded (beside r), rev' (chains r))
  | inr wrong => inr wrong
  end.

(* The set: its chains, edges and points. *)
Definition at_end_of_set (now : reading + failure) : open_region + failure :=
  match all_read now with
  | inl r => inl (OpenRegion (rev' (chains r)) (rev' (edges_so_far (beside r))) (rev' (points_so_far (beside r))))
  | inr wrong => inr wrong
  end.

Definition region_in (may_be_unbounded : bool) (t : text) : (bool * polygonal_region) + failure :=
  at_end (fold_left take_byte t (start may_be_unbounded)).

Definition set_in (t : text) : open_region + failure := at_end_of_set (fold_left take_byte t start_of_set).
