# SPDX-License-Identifier: GPL-3.0-or-later
"""How a sum is computed: origins, statistics, progress; and what is summed: line strings in nfp."""

from fractions import Fraction

import pytest
from hypothesis import given
from shapely.affinity import translate
from shapely.geometry import LineString
from tqdm import tqdm

import oplus
from test_batch import stars
from tiles import small_tilings, tilings, union

SQUARE = [[0, 0], [1, 0], [1, 1], [0, 1]]
FRAME = [[[0, 0], [4, 0], [4, 4], [0, 4]], [[1, 1], [1, 3], [3, 3], [3, 1]]]


def test_statistics_are_numbers():
    statistics = oplus.minkowski_sum(FRAME, SQUARE).statistics
    assert statistics["segments slid along"] > 0
    assert all(type(value) in (int, float, Fraction) for value in statistics.values())
    assert oplus.PlanarSet(SQUARE).statistics == {}


def vertex(region, index):
    rings = [ring for outer, holes in region.components for ring in (outer, *holes)]
    ring = rings[index[0]]
    return ring[index[1]], ring[(index[1] + 1) % len(ring)]


@given(tilings(3), small_tilings)
def test_origins_run_along_edges(p_pieces, q_pieces):
    p, q = oplus.Region(union(p_pieces)), oplus.Region(union(q_pieces))
    found = oplus.minkowski_sum(p, q, boundary="open", with_origins=True)
    assert oplus.minkowski_sum(p, q).origins == []
    rings = [ring for outer, holes in found.components for ring in (outer, *holes)]
    assert len(found.origins) == sum(map(len, rings)) + len(found.dangling_edges)
    for edge, of_edge in zip(found.dangling_edges[::-1], found.origins[::-1]):
        assert of_edge
        for kind, edge_at, vertex_at in of_edge:
            a, b = vertex(p if kind == "p" else q, edge_at)
            c, _ = vertex(q if kind == "p" else p, vertex_at)
            # On the line of the edge.
            (x0, y0), (x1, y1) = edge
            for x, y in ((a[0] + c[0], a[1] + c[1]), (b[0] + c[0], b[1] + c[1])):
                assert (x - x0) * (y1 - y0) == (y - y0) * (x1 - x0)


@given(tilings(3))
def test_a_line_in_nfp_meets_the_inside(pieces):
    shape, line = union(pieces), LineString([(0, 0), (1, 0), (1, 2)])
    found = oplus.nfp(shape, line)
    assert found.boundary == "open" and oplus.nfp(line, shape) == -found
    for i in range(-3, 6):
        for j in range(-3, 6):
            x = (i / 2 + 0.25, j / 2 + 0.125)
            inside = shape.intersection(translate(line, *x)).length > 0
            assert (x in found) == inside


@pytest.mark.parametrize("threads", [1, 2])
def test_progress_of_a_sum(threads):
    p, q = (oplus.from_arrays(stars(1, n, n))[0] for n in (400, 300))
    calls = []
    oplus.minkowski_sum(p, q, threads=threads, progress=lambda *call: calls.append(call))
    assert calls and calls[-1][0] == calls[-1][1] > 0
    assert all(0 <= done <= total for done, total in calls)

    def failing(done, total):
        raise RuntimeError("enough")

    for compute in (oplus.minkowski_sum, oplus.nfp, oplus.close, oplus.Placements):
        with pytest.raises(RuntimeError, match="enough"):
            compute(p, q, threads=threads, progress=failing)


def test_progress_of_a_batch():
    calls = []
    p = stars(20000, 6, 1)
    found = oplus.batch("sum", p, p, threads=1, progress=lambda *call: calls.append(call))
    assert len(found) == 20000 and calls[-1] == (20000, 20000)
    assert calls == sorted(calls) and {total for _, total in calls} == {20000} and len(calls) > 2

    def failing(done, total):
        raise RuntimeError("enough")

    with pytest.raises(RuntimeError, match="enough"):
        oplus.batch("sum", p, p, progress=failing)


def test_a_bar_of_tqdm():
    p = stars(20000, 6, 1)
    with tqdm(disable=False, file=open("/dev/null", "w"), leave=False) as bar:
        oplus.batch("sum", p, p, threads=1, progress=bar)
        assert (bar.n, bar.total) == (20000, 20000)
