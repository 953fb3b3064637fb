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
