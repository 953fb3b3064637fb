# SPDX-License-Identifier: GPL-3.0-or-later
"""A GeoSeries in, one out."""

import geopandas
import pytest
from shapely.geometry import Polygon, box

import oplus

CORNERS = [[0, 0], [1, 0], [1, 1], [0, 1]]
SQUARE = oplus.Region(CORNERS)


def series(*geometries, index="abcd", crs="EPSG:3857"):
    return geopandas.GeoSeries(list(geometries), index=list(index), crs=crs)


PARTS = series(box(0, 0, 2, 1), None, box(5, 5, 6, 6), Polygon())


def test_a_series_gives_a_series():
    found = oplus.batch("sum", PARTS, SQUARE)
    assert type(found) is geopandas.GeoSeries and found.crs == PARTS.crs and found.index.equals(PARTS.index)
    assert found.isna().tolist() == [False, True, False, False]
    assert found["a"].equals(box(0, 0, 3, 2)) and found["c"].equals(box(5, 5, 7, 7)) and found["d"].is_empty
    assert oplus.batch("ifp", SQUARE, series(box(0, 0, 1, 1), None, box(0, 0, 0.5, 1), box(0, 0, 2, 2)))[
        ["a", "c"]].geom_type.tolist() == ["Point", "LineString"]
    assert oplus.batch("sum", PARTS, SQUARE, boundary="open", threads=1).geom_equals(found).tolist() == [True, False, True, True]


def test_two_series_by_their_index():
    other = series(box(0, 0, 1, 1), box(0, 0, 1, 1), None, box(0, 0, 1, 1), crs=None)
    for found in (oplus.batch("sum", PARTS, other), oplus.batch("sum", other, PARTS)):
        assert found.isna().tolist() == [False, True, True, False] and found["a"].equals(box(0, 0, 3, 2))
        assert found.crs == PARTS.crs
    in_a_list = oplus.batch("nfp", PARTS, [SQUARE, "not even read", SQUARE, SQUARE])
    assert in_a_list.isna().tolist() == [False, True, False, False]
    assert oplus.batch("sum", series(None, None, None, None), SQUARE).isna().all()


@pytest.mark.parametrize("other, options, wrong", [
    (PARTS.sort_index(ascending=False), {}, "different indices"), (PARTS.to_crs("EPSG:4326"), {}, "EPSG:4326 and of EPSG:3857"),
    ([CORNERS], {}, "1 regions for a series of 4"), (SQUARE, {"errors": "return"}, "errors return of a series; expected raise")])
def test_series_that_do_not_fit(other, options, wrong):
    with pytest.raises(ValueError, match=wrong):
        oplus.batch("sum", PARTS, other, **options)


def test_an_invalid_geometry_is_named():
    bow_tie = Polygon([(0, 0), (2, 2), (2, 0), (0, 2)])
    with pytest.raises(oplus.InvalidInput, match="^pair 2, p: two edges .* cross"):
        oplus.batch("sum", series(None, box(0, 0, 1, 1), bow_tie, None), SQUARE)
