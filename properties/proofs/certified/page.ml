(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* oplus-certified on the page: P, Q, S and the certificate. *)

let region name text = Regions.read (Worker.file name text)

let answer = function
  | [| p; q; s; certificate |] ->
      let p = region "P" p and q = region "Q" q and s = region "S" s in
      let s = { Proved.open_chains = s; dangling_edges = []; isolated_points = [] } in
      let certificate = Certificates.read "sum" (Worker.file "certificate" certificate) p q s in
      Verdict.of_sum ~is_open:false p q s certificate
  | _ -> invalid_arg "answer"

let () = Worker.run answer
