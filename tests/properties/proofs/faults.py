#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes one-line faults in what is defined, one at a time, and demands that a proof fails: what holds of
a faulty definition too says little about the right one.
Usage: faults.py SOURCES BUILD, BUILD made by compiled.py"""

import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

# What it is about, the file, what stands there, what stands there instead, and where a proof fails.
FAULTS = [
    ("ties go the other way", "direction.v",
     "OfP, OfQ => Lt | OfQ, OfP => Gt", "OfP, OfQ => Gt | OfQ, OfP => Lt", "cyclic_order.v"),
    ("left and right are one direction", "direction.v",
     " || (zero (vy v) && negative (vx v))", "", "angle.v"),
    ("angles grow clockwise", "direction.v",
     "vy u * vx v ?= vx u * vy v", "vx u * vy v ?= vy u * vx v", "angle.v"),
    ("nothing is between a direction and an earlier one", "direction.v",
     "before from d || before d to", "before from d && before d to", "cyclic_order.v"),
    ("the tie rule depends on who asks", "tangent_set.v",
     "(Direction (incoming c) (other (of d)))", "(Direction (incoming c) (of d))",
     "forward_traversal.v"),
    ("a cycle turns to P's edge whenever it can", "tracing.v",
     "if belongs (came_by, at_) then came_by else other came_by",
     "if belongs (OfP, at_) then OfP else OfQ", "tracing.v"),
    ("no start in the first column", "tracing.v",
     " ++ map (fun j => (0, j)) (seq 1 (m - 1))", "", "tracing.v"),
    ("P's edge is taken though visited", "algorithm_2.v",
     " && negb (is_in (OfP, at_) visited)", "", "algorithm_2.v"),
    ("both crossings of a ray count 1", "winding_number.v",
     "if target_right then -1 else 0", "if target_right then 1 else 0", "winding_number.v"),
    ("a ray through a vertex counts both edges", "winding_number.v",
     "(at_most (vy (source s)) (vy p)) (at_most (vy (target s)) (vy p))",
     "(negb (at_most (vy p) (vy (source s)))) (at_most (vy (target s)) (vy p))", "winding_number.v"),
    ("steps are not shifted", "signed_crossings.v",
     "| Eq => turn_to_shift (minus (target s) (source s))", "| Eq => Gt", "signed_crossings.v"),
    ("a step crosses the line of a segment", "signed_crossings.v",
     "if same_side before after || same_side (side_of_step from to (source s)) (side_of_step from to (target s))",
     "if same_side before after", "signed_crossings.v"),
    ("shifted points are at their old height", "shifted_ray.v",
     "positive (vy (first p)) || positive (vy (second p))", "positive (vy (first p))", "shifted_ray.v"),
    ("an edge's middle is not shifted upwards", "shifted_ray.v",
     "(if negative (vy d) then Vector (- vx d) (- vy d) else d)\n    (Vector (vy d) (- vx d)).",
     "d\n    (Vector (vy d) (- vx d)).", "shifted_ray.v"),
    ("a chain turns backwards", "turning_number.v",
     "sum (map (fun c => sweep d (incoming c) (outgoing c)) (corners chain))",
     "sum (map (fun c => sweep d (outgoing c) (incoming c)) (corners chain))", "turning_number.v"),
    ("a state before the first is the first", "states.v",
     "match i with 0 => n - 1 | S k => k end", "match i with 0 => 0 | S k => k end", "states.v"),
    ("an edge of P leads along Q", "fiber_grid.v",
     "OfP => (next (fst s) n, snd s) | OfQ => (fst s, next (snd s) m)",
     "OfQ => (next (fst s) n, snd s) | OfP => (fst s, next (snd s) m)", "fiber_grid.v"),
    ("segments start where they end", "in_out_degree.v",
     "point_of (fst s) (state_before (snd s)).",
     "point_of (fst s) (0, snd (state_before (snd s))).", "in_out_degree.v"),
    ("points above each other are one", "in_out_degree.v",
     "Qeq_bool (vx x) (vx y) && Qeq_bool (vy x) (vy y)", "Qeq_bool (vx x) (vx y)",
     "convolution_graph.v"),
    ("edges of P and of a direction are exchanged", "weight.v",
     "Z.b2z (before (Direction e OfP) (Direction f OfQ)) - Z.b2z (before (Direction e OfP) (Direction d OfQ))",
     "Z.b2z (before (Direction e OfP) (Direction d OfQ)) - Z.b2z (before (Direction e OfP) (Direction f OfQ))",
     "weight.v"),
    ("an end is not on its segment", "location.v",
     "vx (source s)) (vx p) (vx (target s)) && between", "vx (source s)) (vx p) (vx (source s)) && between",
     "location.v"),
    ("ends on another segment are not met", "pieces.v",
     "filter (fun p => is_on p a) [source b; target b]", "[]", "met_pieces.v"),
    ("pieces run from left to right", "pieces.v",
     "match compare_points (target s) (source s) with Lt => rev sorted | _ => sorted end",
     "sorted", "pieces.v"),
    ("opposite edges show common interior", "naive_collision.v",
     " && positive (dot (along f) (along piece))", "", "collision_is_sound.v"),
    ("containment is no collision", "naive_collision.v",
     "| Inside => true", "| Inside => false", "collision_is_complete.v"),
    ("a region may cover something twice", "checked_collision.v",
     "(region_edges r) <=? 0)%Z", "(region_edges r) <=? 1)%Z", "checked_collision.v"),
    ("pieces need not be convex", "checker.v",
     "has_a_fan (corners t) && forallb (is_left_of_all (side_lines t)) (corners t)",
     "has_a_fan (corners t)", "fans.v"),
    ("triangles of a fan may be flat", "checker.v",
     "(0 <? left_turn first b c) && fan_turns_left", "(0 <=? left_turn first b c) && fan_turns_left", "fans.v"),
    ("points are put beyond edges", "checker.v",
     "((x a m <=? x m a) && (x m b <=? x b m) ||", "((x a m <=? x m a) ||", "balanced_edges.v"),
    ("edges of the region count as the pieces' do", "checker.v",
     "if Bool.eqb (forward e) (of_region e) then -1 else 1", "if forward e then 1 else -1", "balanced_edges.v"),
    ("no piece need have the last edge of the region", "checker.v",
     "| [] => (count =? 0) && (negb in_region || in_piece)", "| [] => count =? 0", "balanced_edges.v"),
    ("boxes are rounded down at their tops", "checker.v",
     "- (- x * Zpos D / Zpos w)", "x * Zpos D / Zpos w", "edges_beside_sums.v"),
    ("one end of an edge is beyond a side", "checker.v",
     " && (value l (minus (to e) b) <=? 0)", "", "edges_beside_sums.v"),
    ("the sums of one corner are beside an edge", "checker.v",
     "forallb (fun a => forallb (fun b => test (plus a b)) (corners u)) (corners t).",
     "existsb (fun a => forallb (fun b => test (plus a b)) (corners u)) (corners t).", "edges_beside_sums.v"),
    ("a tree has half of the pieces", "checker.v",
     "node_of a b :: paired rest", "node_of a a :: paired rest", "edges_beside_sums.v"),
    ("links need no common corner", "checker.v",
     "if have_a_common_corner t u then PositiveMap.add", "if true then PositiveMap.add", "connected_pieces.v"),
    ("links lead to one piece", "checker.v",
     "forallb (fun entry => PositiveMap.mem (fst entry) reached)",
     "existsb (fun entry => PositiveMap.mem (fst entry) reached)", "connected_pieces.v"),
    ("first pieces have their sums outside", "checker.v",
     "negb (hwinding x es =? 0)", "(hwinding x es =? 0)", "sums_are_inside.v"),
    ("edges that are points do not matter", "checker.v",
     "is_simple && existsb", "existsb", "sums_are_inside.v"),
    ("one piece of s for all points", "checker.v",
     "| Leaf _ a => is_in_piece a x", "| Leaf _ a => true", "sums_are_inside.v"),
    ("an inner point is three times as far", "checker.v",
     "Some (Hpoint (px s) (py s) (3 * pw s))", "Some s", "sums_are_inside.v"),
    ("a cut loses what is on its line", "checker.v",
     "(if 0 <=? u then [fst e] else [])", "(if 0 <? u then [fst e] else [])", "clipped_polygons.v"),
    ("what is cut off may be turned", "checker.v",
     " && forallb (is_ahead (opposite_line l)) (sides v2)", "", "cells_are_sums.v"),
    ("a cell is flat", "checker.v",
     "some_corner_has_a_fan (length v) v && forallb (is_sum_of_both t u) v",
     "forallb (is_sum_of_both t u) v", "cells_are_sums.v"),
    ("one corner of a cell is a sum", "checker.v",
     "some_corner_has_a_fan (length v) v && forallb (is_sum_of_both t u) v",
     "some_corner_has_a_fan (length v) v && existsb (is_sum_of_both t u) v", "cells_are_sums.v"),
    ("sides that miss each other cross", "checker.v",
     "(left_turn a b c * left_turn a b d <? 0) && (left_turn c d a * left_turn c d b <? 0)",
     "(left_turn a b c * left_turn a b d <? 0)", "sums_of_pieces.v"),
    ("half of a cut cell is a sum", "checker.v",
     "are_sums p q v1 one && are_sums p q v2 other", "are_sums p q v1 one", "cells_are_sums.v"),
    ("the pieces of Q are not linked", "checker.v",
     "(all_reached q_numbered (roots (of_q c)) (links (of_q c)))", "p_numbered", "sums_are_inside.v"),
]


def in_a_proof(text, line, character):
    """Whether the place is between `Proof.` and the `Qed.` that follows."""
    before = "\n".join(text.splitlines()[:line - 1] + [text.splitlines()[line - 1][:character]])
    return before.rfind("Proof.") > max(before.rfind("Qed."), before.rfind("Defined."))


def rejected(build, file):
    """The source in which Coq rejects a proof on the way to this one, or what else happens."""
    done = subprocess.run(["make", "--no-print-directory", Path(file).stem + ".vo"], cwd=build,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if done.returncode == 0:
        return "nothing"
    place = re.search(r'^File "\./(\w+\.v)", line (\d+), characters (\d+)-\d+:\nError', done.stdout,
                      re.MULTILINE)
    if not place:
        return done.stdout
    name, line, character = place.group(1), int(place.group(2)), int(place.group(3))
    text = (build / name).read_text(encoding="utf-8")
    return name if in_a_proof(text, line, character) else f"line {line} of {name}, which is no proof"


def survivor(build, sources, fault):
    """What is wrong with a fault: it cannot be made, or no proof fails, or another one. Or none."""
    name, file, right, wrong, where = fault
    text = (sources / file).read_text(encoding="utf-8")
    if text.count(right) != 1:
        return f"{name}: `{right}` stands in {file} {text.count(right)} times"
    with tempfile.TemporaryDirectory() as directory:
        faulty = Path(directory) / "build"
        shutil.copytree(build, faulty, ignore=shutil.ignore_patterns("extraction"))
        (faulty / file).write_text(text.replace(right, wrong), encoding="utf-8")
        found = rejected(faulty, where)
    return None if found == where else f"{name}: Coq rejects {found}, not {where}"


def main():
    sources, build = map(Path, sys.argv[1:3])
    found = [one for one in (survivor(build, sources, fault) for fault in FAULTS) if one]
    for one in found:
        print(one)
    print(f"{len(FAULTS)} faults made, {len(found)} not found")
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
