(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* Writes what Zarith's functions return for pairs of integers: all near powers of two, where representations change,
   and others of up to 400 bits. *)

let near_powers =
  let near k = List.map (fun d -> Z.add (Z.pow (Z.of_int 2) k) (Z.of_int d)) [ -2; -1; 0; 1; 2 ] in
  List.concat_map near [ 1; 4; 15; 16; 30; 31; 32; 52; 53; 54; 61; 62; 63; 64; 128; 300 ]

(* The same on all machines: OCaml's own generator depends on the size of an int. *)
let rec others count seed =
  if count = 0 then []
  else
    let next = Z.((seed * of_string "6364136223846793005") + of_string "1442695040888963407") in
    let next = snd (Z.ediv_rem next (Z.pow (Z.of_int 2) 400)) in
    fst (Z.ediv_rem next (Z.pow (Z.of_int 2) (13 * count))) :: others (count - 1) next

let numbers =
  let positive = near_powers @ others 25 (Z.of_int 7) in
  Z.zero :: positive @ List.map Z.neg positive

let of_outcome f = try f () with e -> Printexc.to_string e
let integer f = of_outcome (fun () -> Z.to_string (f ()))
let both f = of_outcome (fun () -> let q, r = f () in Z.to_string q ^ " " ^ Z.to_string r)
let say words = print_string (String.concat " " words ^ "\n")

let () =
  List.iter (fun a ->
      say (Z.to_string a :: string_of_int (Z.sign a) :: List.map (fun f -> Z.to_string (f a)) Z.[ neg; abs; succ; pred ]);
      (* An int is longer on the machine than in JavaScript. *)
      if Z.compare (Z.abs a) (Z.of_int 0x3fff_ffff) <= 0 || Z.compare (Z.abs a) (Z.pow (Z.of_int 2) 63) > 0 then
        say [ "as int"; of_outcome (fun () -> string_of_int (Z.to_int a)) ];
      List.iter (fun n -> say [ "power"; integer (fun () -> Z.pow a n) ]) [ 0; 1; 2; 5; 16; 31; -1 ];
      List.iter (fun b ->
          let exact = if Z.sign b <> 0 && Z.sign (snd (Z.ediv_rem a b)) = 0 then Z.to_string (Z.divexact a b) else "no" in
          say
            ([ string_of_int (Z.compare a b); string_of_bool (Z.equal a b); string_of_bool (a = b); exact;
               (* An integer has one representation, whatever made it. *)
               string_of_bool (Z.add a b = Z.of_string (Z.to_string (Z.add a b))) ]
             @ List.map (fun f -> integer (fun () -> f a b)) Z.[ add; sub; mul; gcd; fdiv; cdiv; ediv; rem ]
             @ List.map (fun f -> both (fun () -> f a b)) Z.[ div_rem; ediv_rem ]))
        numbers)
    numbers;
  let texts = [ "+5"; "-0"; "007"; "-2147483649"; "+4611686018427387904"; "1 2"; "a"; "5a" ] in
  List.iter (fun text -> say [ text; integer (fun () -> Z.of_string text) ]) texts
