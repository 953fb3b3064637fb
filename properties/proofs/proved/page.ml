(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* oplus-proved on the page: "closed" or "open", P and Q. *)

let region name text = Commands.valid name (Regions.read (Worker.file name text))

let answer = function
  | [| boundary; p; q |] ->
      let sum = Option.get (Commands.operation "sum" (boundary = "open")) in
      let p = region "P" p in
      let q = region "Q" q in
      (0, sum p q)
  | _ -> invalid_arg "answer"

let () = Worker.run answer
