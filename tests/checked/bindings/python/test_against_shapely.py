# SPDX-License-Identifier: GPL-3.0-or-later
"""Operations beside their definitions, computed by Shapely."""

from collections import Counter
from fractions import Fraction

import pytest
from hypothesis import given, settings, strategies
from shapely.affinity import translate
from shapely.geometry import Point

import oplus
from tiles import small_tilings, sum_of, tilings, union

half_integers = strategies.integers(-2, 8).map(lambda n: n / 2)
positions = strategies.tuples(half_integers, half_integers)


seen = Counter()


@pytest.fixture(scope="module", autouse=True)
def what_was_seen(request):
    """Fails where the cases were too simple."""
    yield
    if len(request.session.items) > 7 and not request.session.testsfailed:
        assert all(seen[what] >= 10 for what in (
            "several components", "holes", "holes of sums", "overlap", "no overlap", "fits", "does not fit", "opening",
            "closing")), seen


def classify(region, suffix=""):
    components = region.components
    seen["several components" + suffix] += len(components) > 1
    seen["holes" + suffix] += any(holes for _, holes in components)


@settings(max_examples=500)
@given(tilings(4), small_tilings)
def test_sum_is_the_union_of_sums_of_convex_pieces(p, q):
    region = oplus.Region(union(p))
    found = oplus.minkowski_sum(region, union(q))
    classify(found, " of sums")
    expected = sum_of(p, q)
    assert float(found.area) == expected.area
    assert found.to_shapely().symmetric_difference(expected).area == 0
    assert oplus.verify(region, union(q), expected)


@given(tilings(4))
def test_a_region_is_what_was_given(pieces):
    shape = union(pieces)
    region = oplus.Region(shape)
    classify(region)
    assert region.to_shapely().equals(shape)
    assert region.area == Fraction(shape.area)
    assert oplus.Region(shape.wkb) == oplus.Region(shape.wkt) == region
    assert oplus.Region(region.to_wkb()) == oplus.Region(region.to_geojson()) == region
    assert oplus.from_arrays(oplus.to_arrays(region)._replace(regions=None))[0].area <= region.area
    assert oplus.from_arrays(oplus.to_arrays(region)) == [region]


@given(tilings(3), positions)
def test_location_of_a_point(pieces, point):
    shape, region = union(pieces), oplus.Region(union(pieces))
    where = region.locate(point)
    assert (where == "inside") == shape.contains(Point(point))
    assert (where == "boundary") == shape.boundary.covers(Point(point))
    assert (point in region) == shape.covers(Point(point)) == (where != "outside")


@given(tilings(3), small_tilings, positions)
def test_no_fit_is_where_interiors_meet(p, q, x):
    overlap = union(p).intersection(translate(union(q), *x)).area > 0
    seen["overlap" if overlap else "no overlap"] += 1
    assert (x in oplus.nfp(union(p), union(q))) == overlap


@given(tilings(4), small_tilings, positions)
def test_inner_fit_is_where_it_is_inside(p, q, x):
    fits = union(p).covers(translate(union(q), *x))
    seen["fits" if fits else "does not fit"] += 1
    places = oplus.ifp(union(p), union(q))
    assert (x in places) == fits
    assert oplus.erode(union(p), union(q)).area == places.area


@given(tilings(4), small_tilings)
def test_opening_is_contained_and_closing_contains(p, q):
    opened, closed = oplus.open(union(p), union(q)), oplus.close(union(p), union(q))
    seen["opening"] += 0 < opened.area < Fraction(union(p).area)
    seen["closing"] += closed.area > Fraction(union(p).area)
    assert opened == oplus.minkowski_sum(oplus.ifp(union(p), union(q)), union(q))
    assert closed == oplus.erode(oplus.minkowski_sum(union(p), union(q)), union(q))
    assert opened.to_shapely().difference(union(p)).area == 0
    assert union(p).difference(closed.to_shapely()).area == 0


@given(strategies.lists(strategies.tuples(tilings(2), tilings(2)), max_size=5),
       strategies.sampled_from(["minkowski_sum", "nfp", "ifp", "erode", "open", "close"]))
def test_batch_is_each_operation(pairs, name):
    ps, qs = [union(p) for p, _ in pairs], [union(q) for _, q in pairs]
    expected = [getattr(oplus, name)(p, q) for p, q in zip(ps, qs)]
    arrays = [oplus.to_arrays([oplus.Region(one) for one in side]) for side in (ps, qs)]
    assert oplus.batch(name, ps, qs) == oplus.batch(name, *arrays, threads=1) == expected
