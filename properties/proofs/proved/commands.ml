(* SPDX-License-Identifier: GPL-3.0-or-later *)
(* The commands: of each the proved function, from valid regions, of most commands two, to a text. *)

let refuse message = raise (Files.Invalid message)

let valid_by test name region =
  if test region then region
  else
    refuse
      (String.escaped name
       ^ ": not a valid region: edges may meet in vertices only, and holes are inside their outer chain, outside each \
          other (`oplus sum` says where it is wrong)")

(* The region, if the theorems are about it. *)
let valid = valid_by Proved.is_covered

let open_region s = Proved.(Text.set (polygons_of_open s) s.dangling_edges s.isolated_points)
let open_sum p q = open_region (Proved.proved_open_sum p q)
let no_fit p q = open_region (Proved.proved_no_fit p q)

let with_points q =
  if not (Proved.has_points q) then refuse "Q is empty, and fits everywhere; expected a region with points"

let inner_fit p q =
  with_points q;
  let f = Proved.proved_inner_fit p q in
  Text.set (Proved.polygons_of_placements f) f.fit_edges f.fit_points

let polygons operation p q = Text.wkt (operation p q)
let where_it_fits operation p q = with_points q; polygons operation p q

let all =
  [ ("sum", polygons Proved.proved_sum); ("nfp", no_fit); ("ifp", inner_fit);
    ("erode", where_it_fits Proved.proved_erosion); ("open", where_it_fits Proved.proved_opening);
    ("close", where_it_fits Proved.proved_closing); ("union", polygons Proved.proved_union);
    ("intersection", polygons Proved.proved_intersection); ("difference", polygons Proved.proved_difference) ]

let operation command is_open = if is_open && command = "sum" then Some open_sum else List.assoc_opt command all

(* Of a region that may be unbounded. *)
let complement name (is_unbounded, read) =
  if is_unbounded then Text.wkt (Proved.proved_complement_of_unbounded (valid_by Proved.is_covered_unbounded name read))
  else Text.dat (Proved.proved_complement (valid name read))
