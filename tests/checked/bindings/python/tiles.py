# SPDX-License-Identifier: GPL-3.0-or-later
"""Regions of tiles on a small grid: full of parallel edges, holes, and chains that touch. All that Shapely computes
of them has coordinates that are multiples of a quarter, so it is exact."""

from hypothesis import strategies
from shapely.geometry import MultiPoint, Polygon
from shapely.ops import unary_union

SQUARE = ((0, 0), (1, 0), (1, 1), (0, 1))
# Of a cell: nothing, all of it, or a half.
HALVES = tuple(SQUARE[:i] + SQUARE[i + 1:] for i in range(4))
SPARSE = ((), SQUARE) + HALVES
DENSE = ((),) + 8 * (SQUARE,) + HALVES


def tilings(size, side=1):
    """Returns lists of convex pieces, each a list of points; at least one. `side`: of a tile."""
    cells = [(x, y) for x in range(size) for y in range(size)]

    def of_all(tiles):
        return strategies.tuples(*[strategies.sampled_from(tiles) for _ in cells])

    return (of_all(SPARSE) | of_all(DENSE)).map(
        lambda chosen: [[(side * (x + u), side * (y + v)) for u, v in tile] for (x, y), tile in zip(cells, chosen) if tile]
    ).filter(bool)


small_tilings = tilings(2) | tilings(1) | tilings(2, 0.5)


def union(pieces):
    return unary_union([Polygon(piece) for piece in pieces])


def sum_of(p_pieces, q_pieces):
    """The Minkowski sum by its definition: the union of the sums of convex pieces."""
    return unary_union([MultiPoint([(a + c, b + d) for a, b in p for c, d in q]).convex_hull
                        for p in p_pieces for q in q_pieces])
