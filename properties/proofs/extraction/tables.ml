(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Tables of the proved predicates, a byte an entry but for cycles, for tests/properties/proofs/extracted_predicates.cpp to compare
   with. In lists of vectors x grows slowest, then y, then P comes before Q. *)
open Proved

let rec positive n =
  if n = 1 then XH else if n land 1 = 1 then XI (positive (n / 2)) else XO (positive (n / 2))

let integer n = if n = 0 then Z0 else if n > 0 then Zpos (positive n) else Zneg (positive (-n))
let rational numerator denominator = { qnum = integer numerator; qden = positive denominator }
let point ?(over = 1) x y = { vx = rational x over; vy = rational y over }
let rec natural n = if n = 0 then O else S (natural (n - 1))
let rec coq_list = function [] -> Nil | a :: rest -> Cons (a, coq_list rest)

let write_bit = function True -> print_char '1' | False -> print_char '0'
let write_order = function Lt -> print_char '<' | Eq -> print_char '=' | Gt -> print_char '>'

(* 0 to 9, and what follows in ASCII for more; a for -1, b for -2, and so on. *)
let write_number z =
  let rec value = function XH -> 1 | XO p -> 2 * value p | XI p -> (2 * value p) + 1 in
  let n = match z with Z0 -> 0 | Zpos p -> value p | Zneg p -> -value p in
  assert (-26 <= n && n < Char.code 'a' - Char.code '0');
  print_char (Char.chr (if n >= 0 then Char.code '0' + n else Char.code 'a' - 1 - n))

(* Points of a square grid around the origin. *)
let grid ?over radius =
  let range = List.init ((2 * radius) + 1) (fun i -> i - radius) in
  List.concat_map (fun x -> List.map (fun y -> point ?over x y) range) range

let vectors radius =
  List.filter (fun v -> not (v.vx.qnum = Z0 && v.vy.qnum = Z0)) (grid radius)

let directions radius =
  List.concat_map (fun vec -> [ { vec; of0 = OfP }; { vec; of0 = OfQ } ]) (vectors radius)

let each list action = List.iter action list

let orders radius =
  let all = directions radius in
  each all (fun a -> each all (fun b -> write_order (compare0 a b)))

let betweens radius =
  let all = directions radius in
  each all (fun d -> each all (fun from -> each all (fun to_ -> write_bit (ccw d from to_))))

let reflex radius =
  let all = vectors radius in
  each all (fun incoming -> each all (fun outgoing -> write_bit (is_reflex { incoming; outgoing })))

let tangents radius =
  let all = vectors radius in
  each (directions radius) (fun d ->
      each all (fun incoming ->
          each all (fun outgoing -> write_bit (in_tangent_set d { incoming; outgoing }))))

(* Halves are among the points that are wound around. *)
let crossings radius =
  let ends = grid radius in
  each (grid ~over:2 radius) (fun p ->
      each ends (fun source ->
          each ends (fun target -> write_number (signed_crossing p { source; target }))))

(* Steps and segments between grid points, all but those of length zero. *)
let steps radius =
  let segments =
    List.concat_map
      (fun source ->
        List.filter_map
          (fun target -> if source = target then None else Some { source; target })
          (grid radius))
      (grid radius)
  in
  each segments (fun step ->
      each segments (fun s -> write_number (signed_crossing_of_step step.source step.target s)))

(* What a file has in its lines, read by `parsed`. *)
let read_lines parsed file =
  let channel = open_in file in
  let rec lines found =
    match input_line channel with
    | line -> lines (parsed line :: found)
    | exception End_of_file -> close_in channel; List.rev found
  in
  lines []

(* A region: chains separated by semicolons, coordinates by blanks. *)
let chains_of text =
  let rec points = function
    | x :: y :: rest -> point x y :: points rest
    | [] -> []
    | [ _ ] -> failwith "a point with one coordinate"
  in
  let chain text =
    points (List.map int_of_string (List.filter (( <> ) "") (String.split_on_char ' ' text)))
  in
  List.map chain (String.split_on_char ';' text)

let regions = read_lines chains_of

let pairs =
  read_lines (fun line ->
      match String.split_on_char '|' line with
      | [ p; q ] -> (chains_of p, chains_of q)
      | _ -> failwith "no pair")

(* Polygons: regions of one chain. *)
let polygons file =
  List.map (function [ chain ] -> chain | _ -> failwith "a region of several chains") (regions file)

let region chains = coq_list (List.map coq_list chains)

(* From the grid's point 0 0 to that with both coordinates `side`. *)
let positions ?over side =
  let range = List.init (side + 1) (fun i -> i) in
  List.concat_map (fun x -> List.map (fun y -> point ?over x y) range) range

(* Of paths of two steps, one of which may have length zero, how they cross a region's boundary. *)
let paths side file =
  let points = positions side in
  each (regions file) (fun chains ->
      let boundary = region_edges (region chains) in
      each points (fun a ->
          each points (fun b ->
              each points (fun c -> write_number (signed_crossings_of_path (coq_list [ a; b; c ]) boundary)))))

let write_location = function
  | Outside -> print_char 'o'
  | Boundary -> print_char 'b'
  | Inside -> print_char 'i'

(* At points and points halfway between. *)
let locations side file =
  each (regions file) (fun chains ->
      let r = region chains in
      each (positions ~over:2 (2 * side)) (fun x -> write_location (locate x r)))

let validities file = each (regions file) (fun r -> write_bit (covers_nothing_twice (region r)))

(* Regions as sets of points up to translation, so that -Q + x is one of them. *)
let reflected_at x chains = region (List.map (List.map (fun v -> minus x v)) chains)

(* Of each pair, -Q placed at each of the points, whether the interiors meet. *)
let collisions file xs =
  each (pairs file) (fun (p, q) ->
      let p = region p in
      each xs (fun x -> write_bit (collide p (reflected_at x q))))

(* The segments of the convolution of each pair, a line each, as coordinates. *)
let convolutions file =
  let write_coordinate q =
    match q with
    | { qnum; qden = XH } -> write_number qnum
    | _ -> failwith "a coordinate that is no integer"
  in
  let rec write_segments = function
    | Nil -> print_char '\n'
    | Cons ({ source; target }, rest) ->
        each [ source.vx; source.vy; target.vx; target.vy ] write_coordinate;
        write_segments rest
  in
  each (pairs file) (fun (p, q) -> write_segments (convolution_segments (region p) (region q)))

(* Winding numbers of the convolution, and tangents that are counted in some directions. *)
let convolution_windings file xs =
  each (pairs file) (fun (p, q) ->
      let p = region p and q = region q in
      each xs (fun x -> write_number (convolution_winding_number x p q)))

let tangent_counts file xs =
  each (pairs file) (fun (p, q) ->
      let p = region p and q = region q in
      each xs (fun x ->
          each [ point 1 0; point (-1) 1; point (-1) (-2) ] (fun d -> write_number (count_tangents x p q d))))

(* Points given by twice their coordinates. *)
let rec halves = function
  | x :: y :: rest -> point ~over:2 (int_of_string x) (int_of_string y) :: halves rest
  | [] -> []
  | [ _ ] -> failwith "a point with one coordinate"

let windings radius file =
  let places = grid ~over:2 radius in
  each (polygons file) (fun polygon ->
      let boundary = edges (coq_list polygon) in
      each places (fun p -> write_number (winding_number p boundary)))

(* To the right of segments between grid points, by ray shooting's shifts. *)
let shots radius file =
  let ends = grid radius in
  each (polygons file) (fun polygon ->
      let boundary = edges (coq_list polygon) in
      each ends (fun source ->
          each ends (fun target ->
              if source <> target then
                write_number (winding_number_shifted (right_of_middle { source; target }) boundary))))

(* Turning numbers, of each polygon and of a hole of its shape. *)
let turnings file =
  each (polygons file) (fun polygon ->
      write_number (turning_number (coq_list polygon));
      write_number (turning_number (coq_list (List.rev polygon))))

(* Of each pair of polygons, the cycles as they are traced: a start and the steps from it, a line for each;
   then how many states were looked at. *)
let cycles file =
  let rec value = function O -> 0 | S n -> 1 + value n in
  let rec write_steps = function
    | Nil -> print_char '\n'
    | Cons (Pair (along, _), rest) ->
        print_char (match along with OfP -> 'P' | OfQ -> 'Q');
        write_steps rest
  in
  let rec write_cycles = function
    | Nil -> ()
    | Cons ((Cons (Pair (_, Pair (i, j)), _) as cycle), rest) ->
        Printf.printf "%d %d " (value i) (value j);
        write_steps cycle;
        write_cycles rest
    | Cons (Nil, _) -> failwith "a cycle without steps"
  in
  let cycles_of p q =
    let n = natural (List.length p) and m = natural (List.length q) in
    match trace_cycles n m (in_convolution (coq_list p) (coq_list q)) with
    | None -> failwith "a trace that does not end"
    | Some traced ->
        write_cycles traced;
        Printf.printf "%d\n" (value (states_looked_at n m traced))
  in
  each (pairs file) (function [ p ], [ q ] -> cycles_of p q | _ -> failwith "a region of several chains")

let () =
  match List.tl (Array.to_list Sys.argv) with
  | [ "orders"; radius ] -> orders (int_of_string radius)
  | [ "betweens"; radius ] -> betweens (int_of_string radius)
  | [ "reflex"; radius ] -> reflex (int_of_string radius)
  | [ "tangents"; radius ] -> tangents (int_of_string radius)
  | [ "crossings"; radius ] -> crossings (int_of_string radius)
  | [ "windings"; radius; file ] -> windings (int_of_string radius) file
  | [ "shots"; radius; file ] -> shots (int_of_string radius) file
  | [ "turnings"; file ] -> turnings file
  | [ "convolutions"; file ] -> convolutions file
  | [ "cycles"; file ] -> cycles file
  | [ "steps"; radius ] -> steps (int_of_string radius)
  | [ "paths"; side; file ] -> paths (int_of_string side) file
  | [ "locations"; side; file ] -> locations (int_of_string side) file
  | "collisions" :: file :: xs -> collisions file (halves xs)
  | [ "validities"; file ] -> validities file
  | "convolution-windings" :: file :: xs -> convolution_windings file (halves xs)
  | "tangent-counts" :: file :: xs -> tangent_counts file (halves xs)
  | _ ->
      prerr_endline "usage: (orders | betweens | reflex | tangents | crossings | steps) RADIUS, \
                     (windings | shots) RADIUS FILE, \
                     (turnings | validities) FILE, (paths | locations) SIDE FILE, \
                     (convolutions | cycles) PAIRS, or \
                     (collisions | convolution-windings | tangent-counts) PAIRS HALVES...";
      exit 2
