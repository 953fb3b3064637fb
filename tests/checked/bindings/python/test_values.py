# SPDX-License-Identifier: GPL-3.0-or-later
"""Sets and small results as values of Python: equal, hashed, copied, pickled, iterated over, drawn."""

import copy
import multiprocessing
import pickle
from fractions import Fraction
from xml.etree import ElementTree

import matplotlib
import pytest
from hypothesis import given, strategies
from matplotlib import pyplot

import oplus
from tiles import small_tilings, tilings, union

SQUARE = [[0, 0], [1, 0], [1, 1], [0, 1]]
FRAME = [[[0, 0], [4, 0], [4, 4], [0, 4]], [[1, 1], [1, 3], [3, 3], [3, 1]]]
BAR = [[0, 0], [2, 0], [2, 1], [0, 1]]


def same(a, b):
    return (type(a) is type(b) and a == b and hash(a) == hash(b) and str(a) == str(b)
            and getattr(a, "boundary", "") == getattr(b, "boundary", ""))


def all_kinds():
    places = oplus.nfp(FRAME, BAR)
    assert places.dangling_edges
    path = oplus.PlanarSet("GEOMETRYCOLLECTION (LINESTRING (9 9, 12 9.125), POINT (-1 5), POLYGON ((0 0, 0.1 0, 0 1, 0 0)))")
    regions = [oplus.Region(FRAME), oplus.Region([]), oplus.Region([["1/3", 0], [1, 0], [0, Fraction(10**40, 3)]])]
    sets = [places, path, oplus.ifp(SQUARE, SQUARE), oplus.PlanarSet([]), regions[0] + BAR]
    return regions + sets + list(map(oplus.complement, regions + sets))


@pytest.mark.parametrize("value", all_kinds(), ids=repr)
def test_copies_are_equal(value):
    assert copy.copy(value) is value and copy.deepcopy([value])[0] is value
    for protocol in range(2, pickle.HIGHEST_PROTOCOL + 1):
        assert same(pickle.loads(pickle.dumps(value, protocol)), value)
    parts = list(value)
    assert all(type(part) is oplus.Region and len(part.components) == 1 for part in parts)
    assert sum(part.area for part in parts) == value.area
    assert len(parts) == len(value.components)


@given(tilings(3), small_tilings, strategies.sampled_from(["closed", "open"]))
def test_equal_sets_have_one_hash(p, q, boundary):
    found = oplus.minkowski_sum(union(p), union(q), boundary=boundary)
    again = oplus.minkowski_sum(union(list(reversed(q))), union(list(reversed(p))), boundary=boundary)
    assert same(found, again) and same(pickle.loads(pickle.dumps(found)), found)
    assert same(oplus.complement(oplus.complement(found)), found)
    turned = [([*outer[1:], outer[0]], holes[::-1]) for outer, holes in found.region.components[::-1]]
    region = oplus.Region([[outer, *holes] for outer, holes in turned])
    assert region == found.region and hash(region) == hash(found.region)
    assert len({found, again, found.region, region}) == 2


def doubled(region):
    return region + region, -region


def test_regions_go_to_other_processes():
    regions = [oplus.Region(FRAME), oplus.Region([[0, 0], ["1/3", 0], [0, 1]])]
    with multiprocessing.get_context("fork").Pool(2) as pool:
        found = pool.map(doubled, regions)
    assert found == list(map(doubled, regions))


def test_results_are_values():
    exact = oplus.Region([[0, 0], ["1/3", 0], [0, 1]])
    rounded = oplus.rounded(exact, "0.1")
    verdict = oplus.verify(exact, exact, exact)
    at = oplus.Placements(FRAME, BAR)
    assert pickle.loads(pickle.dumps(rounded)) == rounded and pickle.loads(pickle.dumps(verdict)) == verdict
    assert pickle.loads(pickle.dumps(at)).no_fit == at.no_fit
    assert rounded.__geo_interface__ == rounded.sum.__geo_interface__
    assert at.__geo_interface__ == at.no_fit.__geo_interface__
    assert oplus.PlanarSet(verdict).isolated_vertices == [tuple(map(float, verdict.reasons[0].witness))]
    assert repr(verdict) == "<oplus.Verdict: 1 reason>"
    with pytest.raises(AttributeError):
        verdict.reasons = []


def test_geo_interface_has_the_nearest_doubles():
    far = oplus.Region([[0, 0], ["1/3", 0], [0, 10**400]])
    [ring] = far.__geo_interface__["coordinates"]
    assert set(ring) == {(0.0, 0.0), (1 / 3, 0.0), (0.0, float("inf"))} and ring[0] == ring[-1]
    spot = oplus.PlanarSet({"type": "MultiPoint", "coordinates": [(10**400, Fraction(-10**400)), ("1/3", 0)]})
    assert [one["coordinates"] for one in spot.__geo_interface__["geometries"]] == [(1 / 3, 0.0), (float("inf"), float("-inf"))]


@given(tilings(3))
def test_bounds_are_shapelys(pieces):
    assert tuple(map(float, oplus.Region(union(pieces)).bounds)) == union(pieces).bounds


def test_bounds_and_emptiness():
    assert oplus.Region([]).bounds is None and oplus.Region([]).is_empty
    assert oplus.PlanarSet("POINT (1 2)").bounds == (1, 2, 1, 2) and not oplus.PlanarSet("POINT (1 2)").is_empty
    assert oplus.PlanarSet("GEOMETRYCOLLECTION (POLYGON ((0 0, 1 0, 1 1, 0 0)), LINESTRING (2 -1, 5 0))").bounds == (0, -1, 5, 1)
    with pytest.raises(oplus.InvalidInput, match="region: it is unbounded; expected a bounded region"):
        oplus.complement(SQUARE).bounds


def test_sets_are_moved_as_regions_are():
    places = oplus.nfp(FRAME, BAR)
    assert places.translated(1, "1/2").dangling_edges == [
        tuple((x + 1, y + Fraction(1, 2)) for x, y in edge) for edge in places.dangling_edges]
    assert places.rotated(180) == places.scaled(-1) == -places and places.scaled(-1).boundary == "open"


SVG = "{http://www.w3.org/2000/svg}"


def test_a_picture_for_notebooks():
    picture = ElementTree.fromstring(oplus.nfp(FRAME, BAR)._repr_svg_())
    assert picture.tag == SVG + "svg" and 0 < float(picture.get("width")) <= 301 and 0 < float(picture.get("height")) <= 301
    filled, edge = picture.iter(SVG + "path")
    assert filled.get("stroke-dasharray") and filled.get("d").count("M") == 1
    assert edge.get("d") == "M 1.0 -1.0 L 1.0 -2.0"
    left, top, width, height = map(float, picture.get("viewBox").split())
    assert left < -2 and top < -4 and left + width > 4 and top + height > 1
    spot = ElementTree.fromstring(oplus.ifp(SQUARE, SQUARE)._repr_svg_())
    assert len(list(spot.iter(SVG + "circle"))) == 1
    for value in (oplus.Region([]), oplus.complement(SQUARE), oplus.Region([[0, 0], [1, 0], [0, 10**400]])):
        assert value._repr_svg_() is None


def test_plots():
    matplotlib.use("agg")
    figure, axes = pyplot.subplots()
    assert oplus.nfp(FRAME, BAR).plot(axes, color="green") is axes
    [patch] = axes.patches
    assert patch.get_linestyle() == "--" and patch.get_path().get_extents().bounds == (-2, -1, 6, 5)
    assert axes.lines[0].get_xydata().tolist() == [[1, 1], [1, 2]]
    oplus.ifp(SQUARE, SQUARE).plot(axes)
    assert axes.lines[1].get_xydata().tolist() == [[0, 0]] and len(axes.patches) == 1
    with pytest.raises(oplus.InvalidInput, match="unbounded"):
        oplus.complement(SQUARE).plot(axes)
    figure.canvas.draw()


def test_the_place_of_a_fault():
    with pytest.raises(oplus.InvalidInput) as text:
        oplus.Region("POLYGON ((0 0, 1 0,\n x 1))")
    assert (text.value.place, text.value.line, text.value.column, text.value.index) == ("text", 2, 2, None)
    assert str(text.value) == f"text:2:2: {text.value.wrong}; expected {text.value.expected}"
    with pytest.raises(oplus.InvalidInput) as pair:
        oplus.batch("nfp", [SQUARE] * 2, [SQUARE, BAR[:2]])
    assert (pair.value.place, pair.value.index, pair.value.line) == ("pair 1, q", 1, None)
    assert str(pair.value) == f"pair 1, q: {pair.value.wrong}; expected {pair.value.expected}"
    again = pickle.loads(pickle.dumps(pair.value))
    assert str(again) == str(pair.value) and vars(again) == vars(pair.value)
