#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""python_calls.py BUILD: what calls from Python cost, on 10,000 pairs of small polygons: beside the same calls in C++
(programs/small_sums.cpp), one call of `batch` beside a loop, from arrays to arrays, and Shapely's union of the same
polygons. The least processor time, of all threads, of some rounds in which these take turns; and for `batch`, the least
elapsed time."""

import math
import random
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from measuring import Measurement, Row

PAIRS, ROUNDS = 10000, 7
POLYGONS = {"calls_4_to_8": ("polygons of 4 to 8 vertices", 4, 8), "calls_10": ("polygons of 10 vertices", 10, 10),
            "calls_convex_10": ("convex polygons of 10 vertices", 10, 10, True)}
ENGINES = {"cpp-regions": "C++, of regions", "cpp": "C++, of integers", "python-regions": "Python, of regions",
           "python-lists": "Python, of lists", "python": "Python, of arrays", "loop": "loop to arrays",
           "batch": "batch to arrays", "batch-elapsed": "elapsed: batch to arrays",
           "batch-all-cores": "elapsed: batch to arrays on all cores", "shapely": "Shapely, union"}


def polygon(choose, least, most, is_convex=False):
    """Integers around (0, 0) by their angles, which are less than half a turn: star-shaped, or on a circle."""
    while True:
        angles = {}
        for _ in range(choose.randint(least, most)):
            turn = choose.uniform(0, 2 * math.pi)
            x, y = ((round(1e6 * math.cos(turn)), round(1e6 * math.sin(turn))) if is_convex else
                    (choose.randint(-20, 20), choose.randint(-20, 20)))
            if x or y:
                angles[math.atan2(y, x)] = (x, y)
        order = sorted(angles)
        gaps = [b - a for a, b in zip(order, order[1:] + [order[0] + 2 * math.pi])] if order else []
        if len(order) >= least and max(gaps) < 3:
            return [list(angles[angle]) for angle in order]


def seconds(calls, clock=time.process_time):
    """A pair."""
    start = clock()
    kept = calls()  # freed after the clock, as in C++
    took = (clock() - start) / PAIRS
    del kept
    return took


def measured(build, shape):
    """The least times by engine."""
    import numpy
    import oplus
    import shapely.geometry

    def loop(pairs):
        return [oplus.minkowski_sum(p, q) for p, q in pairs]

    def batch(threads):
        return oplus.to_arrays(oplus.batch("minkowski_sum", *sides, threads=threads))

    choose = random.Random(1)
    lists = [(polygon(choose, *shape), polygon(choose, *shape)) for _ in range(PAIRS)]
    rings = [(numpy.array(p), numpy.array(q)) for p, q in lists]
    shapes = [(shapely.geometry.Polygon(p), shapely.geometry.Polygon(q)) for p, q in lists]
    sides = [oplus.Arrays(numpy.concatenate(side), numpy.cumsum([0] + [len(ring) for ring in side]))
             for side in zip(*rings)]
    assert loop(rings) == oplus.batch("minkowski_sum", *sides), "batch and loop differ"
    least = {}
    with tempfile.NamedTemporaryFile("w", suffix=".wkt") as file:
        file.writelines(oplus.Region(ring).to_wkt() + "\n" for pair in lists for ring in pair)
        file.flush()
        for _ in range(ROUNDS):
            # Regions keep what they computed for one sum, so these are new ones.
            regions = [(oplus.Region(p), oplus.Region(q)) for p, q in lists]
            in_cpp = subprocess.run([build / "bin/small-sums", file.name], check=True, capture_output=True, text=True)
            took = [1e-6 * float(word) for word in in_cpp.stdout.split()]
            took += [seconds(lambda: loop(regions)), seconds(lambda: loop(lists)), seconds(lambda: loop(rings)),
                     seconds(lambda: oplus.to_arrays(loop(rings))), seconds(lambda: batch(1)),
                     seconds(lambda: batch(1), time.perf_counter), seconds(lambda: batch(0), time.perf_counter),
                     seconds(lambda: [p.union(q) for p, q in shapes])]
            least = {name: min(now, least.get(name, now)) for name, now in zip(ENGINES, took)}
    return least


def rows(programs):
    """For table.py: a row for each size."""
    sys.path.insert(0, str(programs.parent / "python"))
    made = []
    for name, (what, *shape) in POLYGONS.items():
        row = Row(name, "calls", what, "calls", measurements=[
            Measurement(engine, numbers={"seconds": took}) for engine, took in measured(programs.parent, shape).items()])
        print(row.what)
        for m in row.measurements:
            print(f"  {ENGINES[m.engine]}: {1e6 * m.numbers['seconds']:.1f} µs a pair", flush=True)
        for over, under in (("python-regions", "cpp-regions"), ("python-lists", "cpp"), ("python", "cpp"), ("loop", "batch"),
                            ("batch-elapsed", "batch-all-cores"), ("shapely", "batch")):
            print(f"  {ENGINES[over]} / {ENGINES[under]}: {row.number(f'{over}.seconds/{under}.seconds'):.2f}")
        made.append(row)
    return made


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    rows(Path(sys.argv[1]).resolve() / "bin")
