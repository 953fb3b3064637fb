#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""nesting.py PARTS HEIGHT COPIES: places so many copies of each part, a line of WKT each, in a strip of that height, and
prints the layout as `oplus layout` reads it.

A simple rule. One part after another, the largest first, goes to where its right end is farthest to the left, and there
as low as possible, upright or turned by 180 degrees. It is tried at the vertices of no-fit and inner-fit polygons, and where the
former cross the border of the latter. All of it is exact: parts touch, and none overlaps another one."""

import functools
import json
import sys
from fractions import Fraction
from pathlib import Path
from typing import NamedTuple

import oplus


class Turned(NamedTuple):
    """A part, turned by 0 or 180 degrees. Equal ones share no-fit polygons."""
    name: str
    degrees: int


class Placed(NamedTuple):
    turned: Turned
    x: Fraction
    y: Fraction


def edges(places):
    """Of all chains; dangling ones; and isolated vertices, as edges of length zero."""
    for outer, holes in places.components:
        for chain in (outer, *holes):
            yield from zip(chain, chain[1:] + chain[:1])
    yield from places.dangling_edges
    yield from ((point, point) for point in places.isolated_vertices)


def extent(places):
    """The smallest and the largest x, and those of y."""
    return [limit(values) for values in zip(*(point for edge in edges(places) for point in edge)) for limit in (min, max)]


class Nesting:
    def __init__(self, parts, height, copies):
        self.parts = parts
        extents = [extent(oplus.PlanarSet(part)) for part in parts.values()]
        self.length = copies * sum(right - left for left, right, _, _ in extents)  # of all in a row
        self.strip = oplus.Region([[0, 0], [self.length, 0], [self.length, height], [0, height]])
        self.placed = []

    @functools.cache
    def region(self, turned):
        return -self.parts[turned.name] if turned.degrees else self.parts[turned.name]

    @functools.cache
    def no_fit(self, fixed, moving):
        """Where the moving part overlaps the fixed one, which is at the origin; and its edges."""
        blocked = oplus.nfp(self.region(fixed), self.region(moving))
        return blocked, list(edges(blocked))

    @functools.cache
    def inner_fit(self, moving):
        """Where it is in the strip: a rectangle, if need be as thin as a line."""
        return extent(oplus.ifp(self.strip, self.region(moving)))

    def candidates(self, moving):
        left, right, low, high = self.inner_fit(moving)
        found = {(left, low), (left, high)}
        for placed in self.placed:
            for edge in self.no_fit(placed.turned, moving)[1]:
                (ax, ay), (bx, by) = [(x + placed.x, y + placed.y) for x, y in edge]
                found |= {(ax, ay), (bx, by)}
                found |= {(ax + (bx - ax) * (y - ay) / (by - ay), y) for y in (low, high) if (ay < y) != (by < y)}
                found |= {(left, ay + (by - ay) * (left - ax) / (bx - ax))} if (ax < left) != (bx < left) else set()
        return [(x, y) for x, y in found if left <= x <= right and low <= y <= high]

    def overlaps_nothing(self, moving, x, y):
        return all(self.no_fit(placed.turned, moving)[0].locate((x - placed.x, y - placed.y)) != "inside" for placed in self.placed)

    def place(self, name):
        tried = sorted((x + self.length - self.inner_fit(moving)[1], y, Placed(moving, x, y))
                       for moving in (Turned(name, 0), Turned(name, 180)) for x, y in self.candidates(moving))
        end, _, placed = next(each for each in tried if self.overlaps_nothing(*each[2]))
        self.placed.append(placed)
        return end  # the part's right end


if __name__ == "__main__":
    file, height, copies = Path(sys.argv[1]), int(sys.argv[2]), int(sys.argv[3])
    parts = {f"{file.stem} {i}": oplus.Region(text) for i, text in enumerate(file.read_text().splitlines(), 1)}
    nesting = Nesting(parts, height, copies)
    order = sorted(parts, key=lambda name: -parts[name].area)
    length = str(max(nesting.place(name) for name in order for _ in range(copies)))
    print(json.dumps({"container": [[0, 0], [length, 0], [length, height], [0, height]],
                      "parts": {name: part.to_wkt().strip() for name, part in parts.items()},
                      "placements": [{"part": name, "at": [str(x), str(y)], "rotation": degrees}
                                     for (name, degrees), x, y in nesting.placed]}, indent=1))
