#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""python_calls.py BUILD: what calls from Python cost, on 10,000 pairs of polygons of 4 to 8 vertices: beside the same
calls in C++ (programs/small_sums.cpp), and one call of `batch` beside a loop, from arrays to arrays. The least
processor time, of all threads, of some rounds in which these take turns; and for `batch`, the least elapsed time."""

import math
import random
import subprocess
import sys
import tempfile
import time
from pathlib import Path

PAIRS, ROUNDS = 10000, 7


def polygon(choose):
    """Integers around (0, 0) by their angles: star-shaped, not always convex. All angles are less than half a turn."""
    while True:
        angles = {}
        for _ in range(choose.randint(4, 8)):
            x, y = choose.randint(-20, 20), choose.randint(-20, 20)
            if x or y:
                angles[math.atan2(y, x)] = (x, y)
        order = sorted(angles)
        gaps = [b - a for a, b in zip(order, order[1:] + [order[0] + 2 * math.pi])] if order else []
        if len(order) >= 4 and max(gaps) < 3:
            return [list(angles[angle]) for angle in order]


def microseconds(calls, clock=time.process_time):
    start = clock()
    kept = calls()  # freed after the clock, as in C++
    took = 1e6 * (clock() - start) / PAIRS
    del kept
    return took


def main(build):
    sys.path.insert(0, str(build / "python"))
    import numpy
    import oplus

    def loop(pairs):
        return [oplus.minkowski_sum(p, q) for p, q in pairs]

    def loop_to_arrays():
        return oplus.to_arrays(loop(rings))

    def batch_to_arrays(threads):
        return oplus.to_arrays(oplus.batch("minkowski_sum", *sides, threads=threads))

    choose = random.Random(1)
    lists = [(polygon(choose), polygon(choose)) for _ in range(PAIRS)]
    rings = [(numpy.array(p), numpy.array(q)) for p, q in lists]
    regions = [(oplus.Region(p), oplus.Region(q)) for p, q in lists]
    sides = [oplus.Arrays(numpy.concatenate(side), numpy.cumsum([0] + [len(ring) for ring in side]))
             for side in zip(*rings)]
    assert loop(rings) == oplus.batch("minkowski_sum", *sides), "batch and loop differ"
    measured = {}
    with tempfile.NamedTemporaryFile("w", suffix=".wkt") as file:
        file.writelines(region.to_wkt() + "\n" for pair in regions for region in pair)
        file.flush()
        for _ in range(ROUNDS):
            # Regions keep what they computed for one sum, so these are new ones.
            regions = [(oplus.Region(p), oplus.Region(q)) for p, q in lists]
            in_cpp = subprocess.run([build / "bin/small-sums", file.name], check=True, capture_output=True, text=True)
            of_regions, of_integers = map(float, in_cpp.stdout.split())
            for name, took in (("C++, of regions", of_regions), ("C++, of integers", of_integers),
                               ("Python, of regions", microseconds(lambda: loop(regions))),
                               ("Python, of lists", microseconds(lambda: loop(lists))),
                               ("Python, of arrays", microseconds(lambda: loop(rings))),
                               ("loop to arrays", microseconds(loop_to_arrays)),
                               ("batch to arrays", microseconds(lambda: batch_to_arrays(1))),
                               ("batch to arrays on all cores", microseconds(lambda: batch_to_arrays(0))),
                               ("elapsed: batch to arrays",
                                microseconds(lambda: batch_to_arrays(1), time.perf_counter)),
                               ("elapsed: batch to arrays on all cores",
                                microseconds(lambda: batch_to_arrays(0), time.perf_counter))):
                measured[name] = min(took, measured.get(name, took))
    for name, took in measured.items():
        print(f"{name}: {took:.1f} µs a pair")
    for over, under in (("Python, of regions", "C++, of regions"), ("Python, of lists", "C++, of integers"),
                        ("Python, of arrays", "C++, of integers"), ("loop to arrays", "batch to arrays"),
                        ("batch to arrays on all cores", "batch to arrays"),
                        ("elapsed: batch to arrays", "elapsed: batch to arrays on all cores")):
        print(f"{over} / {under}: {measured[over] / measured[under]:.2f}")


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(Path(sys.argv[1]))
