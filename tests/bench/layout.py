#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""layout.py OPLUS: the time of `oplus layout` on 10,000 parts of 100 vertices, all of the process (docs/layouts.md)."""

import math
import random
import resource
import subprocess
import sys
import tempfile
import time
from pathlib import Path

COLUMNS, VERTICES = 100, 100


def star(x, y, draw):
    """A star around (x, y) of a radius below 60."""
    turns = [2 * math.pi * i / VERTICES for i in range(VERTICES)]
    reach = [draw.uniform(40, 59.99) if i % 2 == 0 else draw.uniform(25, 40) for i in range(VERTICES)]
    return [(round(x + r * math.cos(t), 3), round(y + r * math.sin(t), 3)) for r, t in zip(reach, turns)]


def row_of_squares(x, y):
    """A square of 100 x 100 with 100 vertices, which touches its neighbours along its sides: teeth in both."""
    side = VERTICES // 4
    step = lambda i: 100 * i / side
    tooth = lambda i: 2 if i % 2 and i < side else 0
    south = [(x + step(i), y + tooth(i)) for i in range(side)]
    east = [(x + 100 + tooth(i), y + step(i)) for i in range(side)]
    north = [(x + step(i), y + 100 + tooth(i)) for i in range(side, 0, -1)]
    west = [(x + tooth(i), y + step(i)) for i in range(side, 0, -1)]
    return south + east + north + west


def wkt(parts):
    return "".join("POLYGON((%s))\n" % ",".join(f"{x:.10g} {y:.10g}" for x, y in part + part[:1]) for part in parts)


def main(program):
    draw = random.Random(1)
    places = [(100 * i, 100 * j) for i in range(COLUMNS) for j in range(COLUMNS)]
    squares = [row_of_squares(x, y) for x, y in places]
    with tempfile.TemporaryDirectory() as folder:
        for name, parts in (("stars beside each other", [star(0.849 * (x - y), 0.849 * (x + y), draw) for x, y in places]),
                            ("squares that touch all neighbours", squares),
                            ("the same in decimals", [[(x / 1000 + 0.7, y / 1000 + 0.1) for x, y in s] for s in squares])):
            file = Path(folder) / "parts.wkt"
            file.write_text(wkt(parts))
            for options in ([], ["--spacing", "0.001"]) if "stars" in name else ([],):
                before, start = resource.getrusage(resource.RUSAGE_CHILDREN), time.monotonic()
                ran = subprocess.run([program, "layout", file, *options], capture_output=True, text=True)
                wall, after = time.monotonic() - start, resource.getrusage(resource.RUSAGE_CHILDREN)
                cpu = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
                print(f"{name}{' '.join(['', *options])}: {wall:.1f} s, {cpu:.1f} s of processor time,",
                      ran.stdout.splitlines()[0] if ran.stdout else ran.stderr)


if __name__ == "__main__":
    main(*sys.argv[1:])
