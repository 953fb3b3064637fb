#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""nesting_step.py PICTURE: places parts in a bin, one after another, each as low and then as far to the left as
possible, in the rotation in which it is lowest, and plots them. Exact fits are found: the key fills the slot."""

import sys

import matplotlib.pyplot
import numpy
from shapely.geometry import Polygon

import oplus

BIN = Polygon([(0, 0), (12, 0), (12, 8), (0, 8)])
PARTS = {"channel": [[0, 0], [8, 0], [8, 4], [6, 4], [6, 2], [2, 2], [2, 4], [0, 4]],
         "bracket": [[0, 0], [5, 0], [5, 2], [2, 2], [2, 4], [0, 4]],
         "key": [[0, 0], [2, 0], [2, 4], [0, 4]],
         "wedge": [[0, 0], [4, 0], [0, 4]],
         "plate": [[0, 0], [4, 0], [4, 2], [0, 2]]}
QUARTERS = [numpy.array(matrix) for matrix in ([[1, 0], [0, 1]], [[0, 1], [-1, 0]], [[-1, 0], [0, -1]], [[0, -1], [1, 0]])]


def corners(places):
    """All points among which the lowest one is, areas, edges and exact fits alike."""
    for outer, _ in places.components:
        yield from outer
    for edge in places.dangling_edges:
        yield from edge
    yield from places.isolated_vertices


def place(free, part):
    """Returns (the part where it is placed, its rotation in degrees), or None. One call for all rotations."""
    turned = numpy.concatenate([part @ matrix for matrix in QUARTERS])
    offsets = numpy.arange(len(QUARTERS) + 1) * len(part)
    found = []
    for i, places in enumerate(oplus.batch("ifp", free, oplus.Arrays(turned, offsets))):
        height = turned[offsets[i]:offsets[i + 1], 1].max()
        found += [(y + height, y, x, i) for x, y in corners(places)]
    if not found:
        return None
    _, y, x, i = min(found)
    return turned[offsets[i]:offsets[i + 1]] + numpy.array([x, y], dtype=float), 90 * i


if __name__ == "__main__":
    free, placed = BIN, {}
    for name, points in PARTS.items():
        at = place(oplus.Region(free), numpy.array(points))
        if at is None:
            print(f"{name} does not fit")
            continue
        placed[name], degrees = at
        x, y = placed[name].min(axis=0)
        print(f"{name}, turned by {degrees} degrees, from ({x:g}, {y:g})")
        # Whole numbers and slopes of 1, so Shapely's difference is exact.
        free = free.difference(Polygon(placed[name]))

    figure, axes = matplotlib.pyplot.subplots()
    axes.add_patch(matplotlib.pyplot.Polygon(BIN.exterior.coords, fill=False))
    for i, (name, points) in enumerate(placed.items()):
        axes.add_patch(matplotlib.pyplot.Polygon(points, facecolor=f"C{i}", edgecolor="black", label=name))
    axes.set_aspect("equal")
    axes.autoscale_view()
    axes.legend(loc="center left", bbox_to_anchor=(1, 0.5))
    figure.savefig(sys.argv[1], bbox_inches="tight")
