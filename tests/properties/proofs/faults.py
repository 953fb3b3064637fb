#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes one-line faults in what is defined, one at a time, and demands that a proof fails: what holds of
a faulty definition too says little about the right one.
Usage: faults.py SOURCES BUILD [few | rest], BUILD made by compiled.py; few: those in the folders of FEW; rest: the others"""

import re
import subprocess
import sys
import tempfile
from pathlib import Path

# What it is about, the file, what stands there, what stands there instead, and where a proof fails.
FAULTS = [
    ("a chain does not close", "specification/specification.v",
     "combine c (rest ++ [first])", "combine c rest", "certified/specification_bridge.v"),
    ("a point is on the line of an edge", "specification/specification.v",
     "exists t, 0 <= t <= 1 /\\", "exists t, 0 <= t /\\", "certified/specification_bridge.v"),
    ("an end at a point's height is above it", "specification/specification.v",
     "Qle_bool (y_of a) (y_of x) in", "negb (Qle_bool (y_of x) (y_of a)) in", "certified/specification_bridge.v"),
    ("edges are no part of their region", "specification/specification.v",
     "(exists e, In e (edges_of_region r) /\\ is_on x e) \\/ ", "", "certified/specification_bridge.v"),
    ("any points of a sum will do", "specification/specification.v",
     "forall x, member x s <-> exists", "forall x, member x s -> exists", "certified/certified_sums.v"),
    ("ties go the other way", "directions/direction.v",
     "OfP, OfQ => Lt | OfQ, OfP => Gt", "OfP, OfQ => Gt | OfQ, OfP => Lt", "directions/cyclic_order.v"),
    ("left and right are one direction", "directions/direction.v",
     " || (zero (vy v) && negative (vx v))", "", "directions/angle.v"),
    ("angles grow clockwise", "directions/direction.v",
     "vy u * vx v ?= vx u * vy v", "vx u * vy v ?= vy u * vx v", "directions/angle.v"),
    ("nothing is between a direction and an earlier one", "directions/direction.v",
     "before from d || before d to", "before from d && before d to", "directions/cyclic_order.v"),
    ("the tie rule depends on who asks", "directions/tangent_set.v",
     "(Direction (incoming c) (other (of d)))", "(Direction (incoming c) (of d))",
     "cycles/forward_traversal.v"),
    ("a cycle turns to P's edge whenever it can", "cycles/tracing.v",
     "if belongs (came_by, at_) then came_by else other came_by",
     "if belongs (OfP, at_) then OfP else OfQ", "cycles/tracing.v"),
    ("no start in the first column", "cycles/tracing.v",
     " ++ map (fun j => (0, j)) (seq 1 (m - 1))", "", "cycles/tracing.v"),
    ("P's edge is taken though visited", "cycles/algorithm_2.v",
     " && negb (is_in (OfP, at_) visited)", "", "cycles/algorithm_2.v"),
    ("both crossings of a ray count 1", "winding/winding_number.v",
     "if target_right then -1 else 0", "if target_right then 1 else 0", "winding/winding_number.v"),
    ("a ray through a vertex counts both edges", "winding/winding_number.v",
     "(at_most (vy (source s)) (vy p)) (at_most (vy (target s)) (vy p))",
     "(negb (at_most (vy p) (vy (source s)))) (at_most (vy (target s)) (vy p))", "winding/winding_number.v"),
    ("steps are not shifted", "winding/signed_crossings.v",
     "| Eq => turn_to_shift (minus (target s) (source s))", "| Eq => Gt", "winding/signed_crossings.v"),
    ("a step crosses the line of a segment", "winding/signed_crossings.v",
     "if same_side before after || same_side (side_of_step from to (source s)) (side_of_step from to (target s))",
     "if same_side before after", "winding/signed_crossings.v"),
    ("shifted points are at their old height", "winding/shifted_ray.v",
     "positive (vy (first p)) || positive (vy (second p))", "positive (vy (first p))", "winding/shifted_ray.v"),
    ("an edge's middle is not shifted upwards", "winding/shifted_ray.v",
     "(if negative (vy d) then Vector (- vx d) (- vy d) else d)\n    (Vector (vy d) (- vx d)).",
     "d\n    (Vector (vy d) (- vx d)).", "winding/shifted_ray.v"),
    ("a chain turns backwards", "chains/turning_number.v",
     "sum (map (fun c => sweep d (incoming c) (outgoing c)) (corners chain))",
     "sum (map (fun c => sweep d (outgoing c) (incoming c)) (corners chain))", "chains/turning_number.v"),
    ("a state before the first is the first", "cycles/states.v",
     "match i with 0 => n - 1 | S k => k end", "match i with 0 => 0 | S k => k end", "cycles/states.v"),
    ("an edge of P leads along Q", "cycles/fiber_grid.v",
     "OfP => (next (fst s) n, snd s) | OfQ => (fst s, next (snd s) m)",
     "OfQ => (next (fst s) n, snd s) | OfP => (fst s, next (snd s) m)", "cycles/fiber_grid.v"),
    ("segments start where they end", "cycles/in_out_degree.v",
     "point_of (fst s) (state_before (snd s)).",
     "point_of (fst s) (0, snd (state_before (snd s))).", "cycles/in_out_degree.v"),
    ("points above each other are one", "cycles/in_out_degree.v",
     "Qeq_bool (vx x) (vx y) && Qeq_bool (vy x) (vy y)", "Qeq_bool (vx x) (vx y)",
     "cycles/convolution_graph.v"),
    ("edges of P and of a direction are exchanged", "theorem_4_2_1/weight.v",
     "Z.b2z (before (Direction e OfP) (Direction f OfQ)) - Z.b2z (before (Direction e OfP) (Direction d OfQ))",
     "Z.b2z (before (Direction e OfP) (Direction d OfQ)) - Z.b2z (before (Direction e OfP) (Direction f OfQ))",
     "theorem_4_2_1/weight.v"),
    ("an end is not on its segment", "winding/location.v",
     "vx (source s)) (vx p) (vx (target s)) && between", "vx (source s)) (vx p) (vx (source s)) && between",
     "winding/location.v"),
    ("ends on another segment are not met", "collision/pieces.v",
     "filter (fun p => is_on_segment p a) [source b; target b]", "[]", "collision/met_pieces.v"),
    ("pieces run from left to right", "collision/pieces.v",
     "match compare_points (target s) (source s) with Lt => rev sorted | _ => sorted end",
     "sorted", "collision/pieces.v"),
    ("opposite edges show common interior", "collision/naive_collision.v",
     " && positive (dot (along f) (along piece))", "", "collision/collision_is_sound.v"),
    ("containment is no collision", "collision/naive_collision.v",
     "| Inside => true", "| Inside => false", "collision/collision_is_complete.v"),
    ("a region may cover something twice", "collision/checked_collision.v",
     "(region_edges r) <=? 0)%Z", "(region_edges r) <=? 1)%Z", "collision/checked_collision.v"),
    ("pieces need not be convex", "certified/checker.v",
     "has_a_fan (corners_of t) && forallb (is_left_of_all (side_lines t)) (corners_of t)",
     "has_a_fan (corners_of t)", "certified/fans.v"),
    ("triangles of a fan may be flat", "certified/checker.v",
     "(0 <? left_turn first b c) && fan_turns_left", "(0 <=? left_turn first b c) && fan_turns_left", "certified/fans.v"),
    ("points are put beyond edges", "certified/checker.v",
     "((x a m <=? x m a) && (x m b <=? x b m) ||", "((x a m <=? x m a) ||", "certified/balanced_edges.v"),
    ("edges of the region count as the pieces' do", "certified/checker.v",
     "if Bool.eqb (forward e) (of_region e) then -1 else 1", "if forward e then 1 else -1", "certified/balanced_edges.v"),
    ("no piece need have the last edge of the region", "certified/checker.v",
     "| [] => (count =? 0) && (negb in_region || in_piece)", "| [] => count =? 0", "certified/balanced_edges.v"),
    ("boxes are rounded down at their tops", "certified/checker.v",
     "- (- x * Zpos D / Zpos w)", "x * Zpos D / Zpos w", "certified/edges_beside_sums.v"),
    ("one end of an edge is beyond a side", "certified/checker.v",
     " && (value l (hminus (to e) b) <=? 0)", "", "certified/edges_beside_sums.v"),
    ("the sums of one corner are beside an edge", "certified/checker.v",
     "forallb (fun a => forallb (fun b => test (hplus a b)) (corners_of u)) (corners_of t).",
     "existsb (fun a => forallb (fun b => test (hplus a b)) (corners_of u)) (corners_of t).", "certified/edges_beside_sums.v"),
    ("a tree has half of the pieces", "certified/checker.v",
     "tree_of_both a b :: paired rest", "tree_of_both a a :: paired rest", "certified/edges_beside_sums.v"),
    ("links need no common corner", "certified/checker.v",
     "if have_a_common_corner t u then PositiveMap.add", "if true then PositiveMap.add", "certified/connected_pieces.v"),
    ("links lead to one piece", "certified/checker.v",
     "forallb (fun entry => PositiveMap.mem (fst entry) reached)",
     "existsb (fun entry => PositiveMap.mem (fst entry) reached)", "certified/connected_pieces.v"),
    ("first pieces have their sums outside", "certified/checker.v",
     "negb (hwinding x es =? 0)", "(hwinding x es =? 0)", "certified/sums_are_inside.v"),
    ("edges that are points do not matter", "certified/checker.v",
     "is_simple && existsb", "existsb", "certified/sums_are_inside.v"),
    ("one piece of s for all points", "certified/checker.v",
     "| Leaf _ a => is_in_piece a x", "| Leaf _ a => true", "certified/sums_are_inside.v"),
    ("an inner point is three times as far", "certified/checker.v",
     "Some (Hpoint (px s) (py s) (3 * pw s))", "Some s", "certified/sums_are_inside.v"),
    ("a cut loses what is on its line", "certified/checker.v",
     "(if 0 <=? u then [fst e] else [])", "(if 0 <? u then [fst e] else [])", "certified/clipped_polygons.v"),
    ("what is cut off may be turned", "certified/checker.v",
     " && forallb (is_ahead (opposite_line l)) (sides v2)", "", "certified/cells_are_sums.v"),
    ("a cell is flat", "certified/checker.v",
     "some_corner_has_a_fan (length v) v && forallb (is_sum_of_both t u) v",
     "forallb (is_sum_of_both t u) v", "certified/cells_are_sums.v"),
    ("one corner of a cell is a sum", "certified/checker.v",
     "some_corner_has_a_fan (length v) v && forallb (is_sum_of_both t u) v",
     "some_corner_has_a_fan (length v) v && existsb (is_sum_of_both t u) v", "certified/cells_are_sums.v"),
    ("sides that miss each other cross", "certified/checker.v",
     "(left_turn a b c * left_turn a b d <? 0) && (left_turn c d a * left_turn c d b <? 0)",
     "(left_turn a b c * left_turn a b d <? 0)", "certified/sums_of_pieces.v"),
    ("half of a cut cell is a sum", "certified/checker.v",
     "are_sums p q v1 one && are_sums p q v2 other", "are_sums p q v1 one", "certified/cells_are_sums.v"),
    ("the pieces of Q are not linked", "certified/checker.v",
     "(all_reached q_numbered (roots (of_q c)) (links (of_q c)))", "p_numbered", "certified/sums_are_inside.v"),
    ("a part reaches beyond the sum of two edges", "proved/sums_of_two_edges.v",
     "smaller (snd l) (Qmake (c - u) k)", "snd l", "proved/sums_of_two_edges.v"),
    ("what is before a covered part is covered", "proved/sums_of_two_edges.v",
     "(if Qle_bool (fst l) low then [(fst l, low)] else []) ++ ", "", "proved/sums_of_two_edges.v"),
    ("numbers are scaled by their own denominators", "proved/sums_of_two_edges.v",
     "Qnum q * (Zpos d / Zpos (Qden q))", "Qnum q", "proved/sums_of_two_edges.v"),
    ("edges that turn to the right are exchanged twice", "proved/sums_of_two_edges.v",
     "| Zneg k => [SumOfTwo start b a (Zpos k)]", "| Zneg k => [SumOfTwo start a b (Zpos k)]",
     "proved/sums_of_two_edges.v"),
    ("boxes that overlap are apart", "proved/sum_of_uncovered_pieces.v",
     "(negb (at_most c a) && negb (at_most c b) && negb (at_most d a)", "(negb (at_most c a) && negb (at_most d a)",
     "proved/sum_of_uncovered_pieces.v"),
    ("no pieces are listed", "proved/sum_of_uncovered_pieces.v",
     "filter (fun piece => is_in_parts (fraction s (middle piece)) parts)", "filter (fun piece => false)",
     "proved/sum_of_uncovered_pieces.v"),
    ("an edge of Q leads along P", "proved/convolution_in_less_time.v",
     "(plus (here a) (there b))", "(plus (there a) (here b))", "proved/convolution_in_less_time.v"),
    ("the point to the right may be on a segment", "proved/just_right_of_a_piece.v",
     "(flat_map (distances m n) segments) / 2", "(flat_map (distances m n) segments)", "proved/just_right_of_a_piece.v"),
    ("the test is made to the left", "proved/just_right_of_a_piece.v",
     "Vector (vy (along e)) (- vx (along e))", "Vector (- vy (along e)) (vx (along e))", "proved/just_right_of_a_piece.v"),
    ("a hole is lost", "proved/polygons.v",
     "(outer, hole :: holes) :: others else", "(outer, holes) :: others else", "proved/polygons.v"),
    ("a hole is given to all chains around it", "proved/polygons.v",
     "then (outer, hole :: holes) :: others", "then (outer, hole :: holes) :: with_hole hole others", "proved/polygons.v"),
    ("outer chains are lost", "proved/polygons.v",
     "(map (fun c => (snd c, [])) outer) (map snd holes)", "[] (map snd holes)", "proved/polygons.v"),
    ("regions may cover something twice", "proved/operations.v",
     "covers_nothing_twice (as_region (prepared_region r))", "true", "proved/operations.v"),
    ("vertices that touch edges are tested, not used", "proved/operations.v",
     "open_sum_of_regions (prepared_region p) (prepared_region q)", "open_sum_of_regions p q", "proved/operations.v"),
    ("nothing is placed somewhere", "proved/operations.v",
     "[] => false | _ => true", "_ => true", "proved/operations.v"),
    ("a complement has the chains of the region", "proved/complements.v",
     "as_polygonal (map turned_chain r)", "as_polygonal r", "proved/complements.v"),
    ("the frame of an unbounded region touches it", "proved/complements.v",
     "frame (2 * size_of (concat u))", "frame (size_of (concat u))", "proved/complements.v"),
    ("unbounded regions may cover something twice", "proved/operations.v",
     "covers_nothing_twice (framed (with_touching_vertices (as_region u)))", "true", "proved/operations.v"),
    ("what is in the holes of an unbounded region is lost", "proved/operations.v",
     "(region_of_polygons holes, polygons)", "(region_of_polygons holes, [])", "proved/operations.v"),
    ("what is moved along a segment stays where it is at first", "proved/swept_regions.v",
     "[] else map (parallelogram s) (region_edges b)", "[] else []", "proved/swept_regions.v"),
    ("what is moved along a segment leaves where it is at first", "proved/swept_regions.v",
     "region_edges (placed (source s) (placed (Vector 0 0) b)) ::\n", "region_edges (placed (target s) (placed (Vector 0 0) b)) ::\n",
     "proved/swept_regions.v"),
    ("parallelograms count if they run counterclockwise", "proved/openings.v",
     "existsb (fun n => negb (n =? 0)%Z) numbers", "existsb (fun n => 0 <? n)%Z numbers", "proved/openings.v"),
    ("points at which something just fits do not count", "proved/openings.v",
     " ++ map (fun v => ends_of (v, v)) (fit_points f)", "", "proved/openings.v"),
    ("an opening is what exact fits cover only", "proved/openings.v",
     "gone_round (region_edges (as_region (quick_sum (areas f) b)) :: ", "gone_round (", "proved/openings.v"),
    ("a closing is the sum", "proved/openings.v",
     ":= erosion (quick_sum a b) b.", ":= quick_sum a b.", "proved/openings.v"),
    ("a chain starts anywhere", "proved/canonical_chains.v",
     "starting_at (fold_left smaller_point rest first)", "starting_at first", "proved/canonical_chains.v"),
    ("no vertices are put in", "proved/touching_vertices.v",
     "filter (fun v => is_between_ends v (source e) (target e)) vertices", "filter (fun v => false) vertices",
     "proved/valid_regions_are_accepted.v"),
    ("walks turn counterclockwise most", "proved/walks.v",
     "negb (is_met_between (minus (source before) (target before)) (along a) (along b))",
     "is_met_between (minus (source before) (target before)) (along a) (along b)", "proved/clockwise_most_walks.v"),
    ("a vertex may be left out that is not in line", "proved/touching_vertices.v",
     "is_on_segment v (Segment a b) && negb (same_point v a)", "negb (same_point v a)", "proved/touching_vertices.v"),
    ("a ring is lost", "proved/simple_rings.v",
     "(v :: rev since) :: rings_of (v :: before) rest", "rings_of (v :: before) rest", "proved/simple_rings.v"),
    ("the rest of a chain starts elsewhere", "proved/simple_rings.v",
     ":: rings_of (v :: before) rest", ":: rings_of before rest", "proved/simple_rings.v"),
    ("chains of placements are walked with an edge left out", "proved/walked_again.v",
     "chains_of (length edges_) edges_", "chains_of (length edges_) (tl edges_)", "proved/walked_again.v"),
]

# Where definitions are that all else is about: of the specification, and of Chapter 2.
FEW = ("specification", "directions", "winding", "chains")


def in_a_proof(text, line, character):
    """Whether the place is between `Proof.` and the `Qed.` that follows."""
    before = "\n".join(text.splitlines()[:line - 1] + [text.splitlines()[line - 1][:character]])
    return before.rfind("Proof.") > max(before.rfind("Qed."), before.rfind("Defined."))


def required(build):
    """By coqdep: of each source the sources that it requires."""
    said = subprocess.run(["coqdep", "-f", "_CoqProject"], cwd=build, stdout=subprocess.PIPE, text=True, check=True).stdout
    rules = [line.split(": ") for line in said.splitlines() if ".vo " in line]
    return {made.split()[0][:-1]: [word[:-1] for word in needed.split() if word.endswith(".vo")] for made, needed in rules}


def way(requires, file, where):
    """What must be compiled to find in `where` what is wrong in `file`, in order; and what else is read."""
    known, found = {}, []

    def depends(source):
        if source not in known:
            known[source] = any([depends(one) for one in requires[source]]) or source == file
            if known[source]:
                found.append(source)
        return known[source]

    depends(where)
    return found, known.keys() - found


def rejected(folder, sources):
    """The last of the sources, if Coq rejects a proof there, or what else happens. Proofs in the others are not checked
    again: what they prove is about the right definition, and is taken for granted of the faulty one."""
    for source in sources:
        done = subprocess.run(["coqc", "-q", "-vok" if source == sources[-1] else "-vos", "-R", ".", "Oplus", source],
                              cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        if done.returncode == 0:
            continue
        place = re.search(r'^File "\./([\w/]+\.v)", line (\d+), characters (\d+)-\d+:\nError', done.stdout, re.MULTILINE)
        if not place:
            return done.stdout
        name, line, character = place.group(1), int(place.group(2)), int(place.group(3))
        text = (folder / name).read_text(encoding="utf-8")
        return name if in_a_proof(text, line, character) else f"line {line} of {name}, which is no proof"
    return "nothing"


def survivor(build, sources, fault, requires):
    """What is wrong with a fault: it cannot be made, or no proof fails, or another one. Or none."""
    name, file, right, wrong, where = fault
    text = (sources / file).read_text(encoding="utf-8")
    if text.count(right) != 1:
        return f"{name}: `{right}` stands in {file} {text.count(right)} times"
    with tempfile.TemporaryDirectory() as directory:
        compiled, read = way(requires, file, where)
        for source in [*compiled, *read]:
            used = source if source in compiled else source + "o"
            (Path(directory) / used).parent.mkdir(exist_ok=True)
            (Path(directory) / used).symlink_to((build / used).resolve())
        if compiled:
            (Path(directory) / file).unlink()
            (Path(directory) / file).write_text(text.replace(right, wrong), encoding="utf-8")
        found = rejected(Path(directory), compiled)
    return None if found == where else f"{name}: Coq rejects {found}, not {where}"


def chosen(which):
    few = [fault for fault in FAULTS if fault[1].split("/")[0] in FEW]
    return {"": FAULTS, "few": few, "rest": [fault for fault in FAULTS if fault not in few]}[which]


def main():
    sources, build = map(Path, sys.argv[1:3])
    faults, requires = chosen("".join(sys.argv[3:])), required(build)
    found = [one for one in (survivor(build, sources, fault, requires) for fault in faults) if one]
    for one in found:
        print(one)
    print(f"{len(faults)} faults made, {len(found)} not found")
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
