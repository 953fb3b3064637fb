(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* What the checkers answer about no-fits and inner fits, as an exit code and a line. *)

let not_certified why = (1, "not certified: " ^ why)

let of_no_fit a b s certificate =
  match Proved.check_no_fit a b s certificate with
  | None -> (0, "certified: S is where B, moved, overlaps A")
  | Some refusal -> not_certified ("with A as P and -B as Q: " ^ Verdict.why s certificate refusal)

let of_inner_fit a b f (certificate : Proved.inner_fit_certificate) =
  match Proved.check_inner_fit a b f certificate with
  | None -> (0, "certified: F is where B, moved, is inside A")
  | Some NoVertexOfB -> not_certified "B is empty"
  | Some PlacementsNotInSquare -> not_certified "part of F is too far out for B to be inside A"
  | Some BeyondInSquare -> not_certified "what the certificate has beyond F is not beyond it"
  | Some (OverlapOutside _) -> not_certified "pieces of the outside of A overlap"
  | Some (OverlapOfSum _) -> not_certified "pieces of the outside of F overlap"
  | Some (NotOpenSum refusal) ->
      let s = Proved.open_sum_around_placements certificate.beyond f in
      not_certified
        ("with the outside of A as P, -B as Q and that of F as S: " ^ Verdict.why s certificate.of_open_sum refusal)
