#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""nesting.py PARTS HEIGHT COPIES: places that many copies of each part (a file of WKT, a line each) in a strip of that
height, and writes the layout as `oplus layout` reads it.

A simple rule: one part after another, the largest first, goes as far to the left as its right end can be, and there as
low as possible, upright or turned by 180 degrees. It is placed at a vertex of a no-fit or of the inner-fit polygon, or
where their boundaries cross on the border of the strip. All of it is exact: parts touch, and none overlap."""

import functools
import json
import sys
from fractions import Fraction
from pathlib import Path
from typing import NamedTuple

import oplus


class Turned(NamedTuple):
    """A part as it is turned. Equal ones share no-fit polygons."""

    name: str
    degrees: int


class Placed(NamedTuple):
    turned: Turned
    x: Fraction
    y: Fraction


class Nesting:
    def __init__(self, parts, height):
        self.parts = parts
        self.height = height
        # Longer than any layout: parts could lie one behind another.
        self.length = sum(max(x for x, _ in corners(part)) - min(x for x, _ in corners(part)) for part in parts.values())
        self.placed = []

    @functools.cache
    def region(self, turned):
        part = self.parts[turned.name]
        return -part if turned.degrees == 180 else part

    @functools.cache
    def no_fit(self, fixed, moving):
        """Where the one meets the inside of the other, which is at the origin; and its edges."""
        blocked = oplus.nfp(self.region(fixed), self.region(moving))
        return blocked, list(edges(blocked))

    @functools.cache
    def strip(self, moving, copies):
        """The inner-fit polygon in a strip: here a rectangle, which may be as thin as a line."""
        box = oplus.Region([[0, 0], [copies * self.length, 0], [copies * self.length, self.height], [0, self.height]])
        points = [point for edge in edges(oplus.ifp(box, self.region(moving))) for point in edge]
        return [min(values) for values in zip(*points)] + [max(values) for values in zip(*points)]

    def candidates(self, moving, frame):
        left, low, right, high = frame
        yield from ((left, low), (left, high))
        for placed in self.placed:
            for (ax, ay), (bx, by) in self.no_fit(placed.turned, moving)[1]:
                ax, ay, bx, by = ax + placed.x, ay + placed.y, bx + placed.x, by + placed.y
                yield ax, ay
                yield bx, by
                for border in (low, high):
                    if (ay < border) != (by < border):
                        yield ax + (bx - ax) * (border - ay) / (by - ay), border
                if (ax < left) != (bx < left):
                    yield left, ay + (by - ay) * (left - ax) / (bx - ax)

    def is_free(self, moving, x, y):
        return all(self.no_fit(placed.turned, moving)[0].locate((x - placed.x, y - placed.y)) != "inside"
                   for placed in self.placed)

    def place(self, name, copies):
        found = []
        for moving in (Turned(name, 0), Turned(name, 180)):
            frame = left, low, right, high = self.strip(moving, copies)
            reach = max(x for x, _ in corners(self.region(moving)))
            found += [(x + reach, y, moving.degrees, x) for x, y in set(self.candidates(moving, frame))
                      if left <= x <= right and low <= y <= high]
        end, y, degrees, x = next(at for at in sorted(found) if self.is_free(Turned(name, at[2]), at[3], at[1]))
        self.placed.append(Placed(Turned(name, degrees), x, y))
        return end


def corners(region):
    return [point for outer, _ in region.components for point in outer]


def edges(places):
    """Of all chains; dangling ones; and points, as edges of length zero."""
    for outer, holes in places.components:
        for chain in (outer, *holes):
            yield from zip(chain, chain[1:] + chain[:1])
    yield from places.dangling_edges
    yield from ((point, point) for point in places.isolated_vertices)


if __name__ == "__main__":
    file, height, copies = Path(sys.argv[1]), int(sys.argv[2]), int(sys.argv[3])
    parts = {f"{file.stem} {i}": oplus.Region(text) for i, text in enumerate(file.read_text().splitlines(), 1)}
    nesting = Nesting(parts, height)
    length = max(nesting.place(name, copies) for name in sorted(parts, key=lambda name: -parts[name].area) for _ in range(copies))
    print(json.dumps({
        "container": [[0, 0], [str(length), 0], [str(length), height], [0, height]],
        "parts": {name: part.to_wkt().strip() for name, part in parts.items()},
        "placements": [{"part": placed.turned.name, "at": [str(placed.x), str(placed.y)], "rotation": placed.turned.degrees}
                       for placed in nesting.placed]}, indent=1))
