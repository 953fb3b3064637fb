# SPDX-License-Identifier: GPL-3.0-or-later
"""Operators on sets, beside Shapely's functions and the definitions."""

import operator

import numpy
import pytest
from hypothesis import given, strategies
from shapely.affinity import translate
from shapely.geometry import MultiPolygon

import oplus
from tiles import tilings, union

SQUARE = [[0, 0], [1, 0], [1, 1], [0, 1]]
OF_SETS = {"union": operator.or_, "intersection": operator.and_, "difference": operator.sub,
           "symmetric_difference": operator.xor}
half_integers = strategies.integers(-2, 6).map(lambda n: n / 2)


def inner(shape):
    """What has an area of it."""
    parts = [part for part in getattr(shape, "geoms", [shape]) if part.area > 0]
    return MultiPolygon([polygon for part in parts for polygon in getattr(part, "geoms", [part])])


@given(tilings(3), tilings(3), strategies.tuples(half_integers, half_integers))
def test_operators_are_those_of_sets(p, q, move):
    a, b = union(p), translate(union(q), *move)
    for name, of_two in OF_SETS.items():
        found, expected = of_two(oplus.Region(a), oplus.Region(b)), inner(getattr(a, name)(b))
        assert type(found) is oplus.Region and float(found.area) == expected.area, name
        assert found.to_shapely().symmetric_difference(expected).area == 0, name


@given(tilings(2), tilings(2), strategies.sampled_from(sorted(OF_SETS)), strategies.booleans(), strategies.booleans())
def test_operators_on_unbounded_regions(p, q, name, p_is_unbounded, q_is_unbounded):
    a = oplus.complement(union(p)) if p_is_unbounded else oplus.Region(union(p))
    b = oplus.complement(union(q)) if q_is_unbounded else oplus.Region(union(q))
    found = OF_SETS[name](a, b)
    rule = {"union": operator.or_, "intersection": operator.and_, "difference": operator.gt, "symmetric_difference": operator.ne}
    for x in range(-1, 3):
        for y in range(-1, 3):
            for point in [(x + 0.25, y + 0.375), (x + 0.75, y + 0.375), (x + 0.375, y + 0.25), (x + 0.375, y + 0.75)]:
                assert (point in found) == rule[name](point in a, point in b), point


@given(tilings(3), tilings(2))
def test_a_region_contains_what_shapely_says(p, q):
    assert oplus.Region(union(p)).contains(union(q)) == union(p).covers(union(q))
    assert oplus.Region(union(p)).contains(oplus.Region(union(p)) & union(q))


def test_a_sum_is_plus():
    region = oplus.Region(SQUARE)
    for other in (SQUARE, region, numpy.array(SQUARE), region + region, "POLYGON ((0 0, 3 0, 0 3, 0 0))"):
        assert region + other == oplus.minkowski_sum(region, other)
    for other in (SQUARE, numpy.array(SQUARE), tuple(map(tuple, SQUARE))):
        assert other + region == oplus.minkowski_sum(other, region)
        assert (other | region).area == 1 and (other - region).is_empty and other & region == region and not other ^ region
    assert (oplus.PlanarSet("LINESTRING (0 0, 4 0)") + region).area == 5
    assert region + -region == oplus.nfp(SQUARE, SQUARE)


def test_contains():
    region, frame = oplus.Region(SQUARE), oplus.Region([[[-1, -1], [2, -1], [2, 2], [-1, 2]], SQUARE])
    assert region.contains((1, "1/2")) and not region.contains(["9/8", 0]) and region.contains(numpy.array([0.5, 0.5]))
    assert not frame.contains(region) and not region.contains(frame) and (frame | region).contains(frame)
    assert frame.contains([[[0, 0], [1, 0], [1, -1]], ]) and not frame.contains([[[-1, -1], [2, -1], [2, 2], [-1, 2]], [[0, 0], ["1/2", 0], [0, "1/2"]]])
    with pytest.raises(oplus.InvalidInput, match="an open set"):
        oplus.nfp(region, region).contains(region)


@pytest.mark.parametrize("of_two", OF_SETS.values())
def test_operators_refuse_what_is_more_than_a_region(of_two):
    fit = oplus.ifp(SQUARE, SQUARE)
    for a, b in [(fit, oplus.Region(SQUARE)), (oplus.Region(SQUARE), fit)]:
        with pytest.raises(oplus.InvalidInput, match="dangling edges or isolated vertices"):
            of_two(a, b)
    with pytest.raises(oplus.InvalidInput, match="expected a ring of points"):
        of_two(oplus.Region(SQUARE), 5)
