# SPDX-License-Identifier: GPL-3.0-or-later
"""What results say, and how they leave."""

import subprocess
import sys
from fractions import Fraction

import numpy
import pytest
from shapely import geometry, wkb

import oplus

SQUARE = [[0, 0], [1, 0], [1, 1], [0, 1]]
ROOM = [[[0, 0], [9, 0], [9, 9], [0, 9]], [[1, 1], [1, 8], [8, 8], [8, 1]]]
# It fits into the room from (1, 1) to (8, 8) in a line, and blocks it elsewhere.
BAR = [[0, 0], [7, 0], [7, 1], [0, 1]]


def test_dangling_edges_and_isolated_vertices_reach_shapely():
    blocked = oplus.nfp(ROOM, BAR)
    assert blocked.boundary == "open"
    assert blocked.dangling_edges == [((1, 1), (1, 7))]
    shape = blocked.to_shapely()
    assert [part.geom_type for part in shape.geoms] == ["Polygon", "LineString"]
    assert shape.geoms[1].equals(geometry.LineString([(1, 1), (1, 7)]))
    only = oplus.nfp(ROOM, [[0, 0], [7, 0], [7, 7], [0, 7]])
    assert only.isolated_vertices == [(1, 1)]
    assert only.to_shapely().geoms[1].equals(geometry.Point(1, 1))
    assert wkb.loads(only.to_wkb()).equals(only.to_shapely())
    assert geometry.shape(only).equals(only.to_shapely())
    assert only.locate((1, 1)) == "boundary" and (1, 1) not in only and (1, 2) in only


def test_fractions_and_doubles():
    thirds = oplus.minkowski_sum([[0, 0], ["1/3", 0], [0, 1]], SQUARE)
    [(outer, holes)] = thirds.components
    assert (Fraction(4, 3), Fraction(1)) in outer and holes == []
    assert [4 / 3, 1.0] in oplus.to_arrays(thirds).coordinates.tolist()
    assert (4 / 3, 1.0) in thirds.to_shapely().exterior.coords[:]
    assert "4/3" in thirds.to_wkt() and "1.33 1" in thirds.to_wkt(digits=2)
    assert numpy.array(outer, dtype=float).shape == (5, 2)
    with pytest.raises(oplus.InvalidInput, match="4/3 is not a double"):
        thirds.to_wkb()


def test_text_of_what_is_unbounded():
    outside = oplus.complement(SQUARE)
    assert str(outside) == outside.to_dat() == "0\n1\n4\n0 0\n0 1\n1 1\n1 0\n"
    assert oplus.Region(str(outside)) == outside
    open_outside = oplus.complement(oplus.PlanarSet(SQUARE))
    assert str(open_outside) == open_outside.to_dat() == str(outside)
    with pytest.raises(ValueError, match="dangling edges"):
        oplus.ifp(SQUARE, SQUARE).to_dat()
    with pytest.raises(ValueError, match="unbounded"):
        outside.to_wkt()


def test_many_regions_as_arrays():
    two = oplus.Region([[SQUARE], [[[5, 5], [6, 5], [5, 6]]]])
    arrays = oplus.to_arrays([ROOM, two, []])
    assert arrays.rings.tolist() == [0, 4, 8, 12, 15]
    assert arrays.polygons.tolist() == [0, 2, 3, 4]
    assert arrays.regions.tolist() == [0, 1, 3, 3]
    assert oplus.from_arrays(arrays) == [oplus.Region(ROOM), two, oplus.Region([])]
    with pytest.raises(oplus.InvalidInput, match="unbounded"):
        oplus.to_arrays(oplus.complement(SQUARE))
    with pytest.raises(oplus.InvalidInput, match="a set with dangling edges or isolated vertices"):
        oplus.to_arrays(oplus.ifp(SQUARE, SQUARE))


@pytest.mark.parametrize("arrays, wrong", [
    (([[0, 0]], [1, 1]), "rings: offset 0 is 1"), (([[0, 0]], [0, 2]), "rings: the last offset is 2; .* from 0 to 1"),
    (([[0, 0]] * 3, [0, 2, 1, 3]), "rings: offset 2 is 1 after 2"), (([[0, 0]], []), "rings: not an array"),
    (([[0, 0]], [0.0, 1.0]), "rings: not integers"), (([[0, 0]], [[0, 1]]), "rings: not an array"),
    (([[0, 0]], [0, 1], [0, 2]), "polygons: the last"), (([[0, 0]], [0, 1], [0, 1], [0, 2]), "regions: the last"),
    (([[0, 0], [1, 0], [0, 1], [0, 0], [2, 2], [2, 0], [0, 2]], [0, 3, 7]), "region 1: two edges .* cross"),
    (([[0, 0]], [0, 1], [0, 0, 1]), "region 0: a polygon without an outer ring")])
def test_arrays_that_do_not_fit(arrays, wrong):
    with pytest.raises(oplus.InvalidInput, match=wrong):
        oplus.from_arrays(oplus.Arrays(numpy.array(arrays[0]), *arrays[1:]))


def test_unbounded_regions():
    outside = oplus.complement(SQUARE)
    assert outside.is_unbounded and outside.area == -1
    assert oplus.complement(outside) == oplus.Region(SQUARE)
    grown = oplus.minkowski_sum(outside, [[0, 0], ["1/2", 0], ["1/2", "1/2"], [0, "1/2"]])
    assert oplus.complement(grown).area == Fraction(1, 4) and oplus.complement(grown).boundary == "open"
    for convert in (outside.to_shapely, outside.to_wkb, outside.to_wkt, grown.to_shapely):
        with pytest.raises(ValueError, match="unbounded"):
            convert()


def test_maps():
    region = oplus.Region([[0, 0], [2, 0], [0, 1]])
    assert region.translated("1/3", -1).components[0][0][0] == (Fraction(1, 3), -1)
    assert region.scaled(-1, 1).area == 1 and -region == region.rotated(180) == region.scaled(-1, -1)
    cosine, sine = oplus.rotation(30, "0.01")
    assert region.rotated(30, "0.01").components[0][0][1] == (2 * cosine, 2 * sine)
    assert cosine**2 + sine**2 == 1 and abs(float(sine) - 0.5) < 2e-4
    with pytest.raises(oplus.InvalidInput):
        region.scaled(0, 1)


def test_discs_and_offsets():
    inside, outside = oplus.disc(1, "inside", "0.01"), oplus.disc(1, "outside", "0.01")
    assert inside.area < Fraction(314159, 100000) < outside.area
    assert inside.area > Fraction(304, 100)
    with pytest.raises(ValueError, match="side left; expected inside or outside"):
        oplus.disc(1, "left", 1)


def test_rounding():
    exact = oplus.minkowski_sum([[0, 0], ["1/3", 0], [0, "1/3"]], [[0, 0], ["1/7", 0], [0, 1]])
    for side in ("nearest", "contain", "contained"):
        rounded = oplus.rounded(exact, 2**-10, side)
        shape = rounded.sum.to_shapely()
        assert shape.is_valid and Fraction(shape.area) == rounded.sum.area and not rounded.is_exact
        assert 0 < rounded.bound <= Fraction(1, 2**10)
    assert oplus.rounded(exact, 2**-10, "contain").sum.area > exact.area > oplus.rounded(exact, 2**-10, "contained").sum.area
    assert oplus.rounded(SQUARE, 1).is_exact
    vanished = oplus.rounded(SQUARE, 10)
    assert vanished.changes == {"vanished_components": 1} and vanished.sum.components == []
    with pytest.raises(ValueError, match="side up; expected nearest, contain or contained"):
        oplus.rounded(exact, 1, "up")
    with pytest.raises(oplus.InvalidInput):
        oplus.rounded(exact, 0)


def test_verify():
    right = oplus.minkowski_sum(ROOM, BAR)
    assert oplus.verify(ROOM, BAR, right) and oplus.verify(ROOM, BAR, right.to_shapely())
    opened = oplus.minkowski_sum(ROOM, -oplus.Region(BAR), boundary="open")
    assert opened.dangling_edges and oplus.verify(ROOM, -oplus.Region(BAR), opened)
    verdict = oplus.verify(ROOM, -oplus.Region(BAR), opened.region, boundary="open")
    assert not verdict and not verdict.is_sum
    assert [reason.kind for reason in verdict.reasons] == [
        "missing dangling edge", "wrong kind of boundary"]
    reason = verdict.reasons[0]
    assert (reason.in_sum, reason.in_given) == (False, True)
    assert reason.witness[0] == 1 and "dangling" in reason.detail
    assert [reason.kind for reason in oplus.verify(ROOM, SQUARE, oplus.minkowski_sum(ROOM, SQUARE).components[0][0]).reasons] == ["missing hole"]
    # Chains that cross are judged too.
    assert not oplus.verify(SQUARE, SQUARE, [[0, 0], [2, 2], [2, 0], [0, 2]])
    with pytest.raises(oplus.InvalidInput):
        oplus.verify(oplus.complement(SQUARE), SQUARE, SQUARE)


@pytest.mark.parametrize("extra", [[[20, 20]], [[20, 20], [20, 20]]])
def test_verify_takes_a_line_without_edges_for_its_point(extra):
    line = {"type": "LineString", "coordinates": extra}
    total = oplus.minkowski_sum(SQUARE, SQUARE)
    verdict = oplus.verify(SQUARE, SQUARE, {"type": "GeometryCollection", "geometries": [total, line]})
    assert not verdict and verdict.reasons[0].witness == (20, 20)


def test_repair_leaves_what_is_exact():
    exact = oplus.Region([[0, 0], ["1/3", 0], [0, 1]])
    total = oplus.minkowski_sum(exact, exact)
    assert oplus.repair(exact) == (exact, []) and oplus.repair(total) == (total.region, [])
    outside = oplus.complement(exact)
    assert oplus.repair(outside) == (outside, [])
    assert oplus.repair(oplus.Region(SQUARE).to_wkb())[0] == oplus.Region(SQUARE)
    bow_tie = geometry.Polygon([[0, 0], [2, 2], [2, 0], [0, 2]])
    assert oplus.repair(bow_tie.wkb, "even-odd")[0].area == 2


def test_repair():
    region, mends = oplus.repair([[0, 0], [4, 0], [4, 0], [4, 4], [6, 4], [4, 4], [0, 4]])
    assert region == oplus.Region([[0, 0], [4, 0], [4, 4], [0, 4]])
    assert len(mends) == 3 and all("\n" not in mend for mend in mends)
    bow_tie = [[0, 0], [2, 2], [2, 0], [0, 2]]
    assert oplus.repair(bow_tie, "nonzero")[0].area == 2
    overlapping = [[[[0, 0], [2, 0], [2, 2], [0, 2]]], [[[1, 1], [3, 1], [3, 3], [1, 3]]]]
    assert oplus.repair(overlapping, "nonzero")[0].area == 7 and oplus.repair(overlapping, "even-odd")[0].area == 6
    with pytest.raises(oplus.InvalidInput, match="cross"):
        oplus.repair(bow_tie)
    with pytest.raises(ValueError, match="fill odd; expected even-odd or nonzero"):
        oplus.repair(bow_tie, "odd")


def test_equal_sets_are_equal():
    assert oplus.minkowski_sum(SQUARE, SQUARE) == oplus.minkowski_sum([[1, 1], [0, 1], [0, 0], [1, 0]], SQUARE)
    assert oplus.minkowski_sum(SQUARE, SQUARE) != oplus.minkowski_sum(SQUARE, SQUARE, boundary="open").region
    assert oplus.Region(SQUARE) != oplus.Region(ROOM) and oplus.Region(SQUARE) != "POLYGON"
    assert repr(oplus.minkowski_sum(SQUARE, SQUARE)) == (
        "<oplus.PlanarSet: closed, 1 component, 0 dangling edges, 0 isolated vertices>")


def test_text_of_an_open_sum_is_verified():
    slot = [[[0, 0], [4, 0], [4, 4], [0, 4]], [[1, 1], [1, 3], [3, 3], [3, 1]]]
    plug = [[0, 0], [2, 0], [2, 2], [0, 2]]
    open_sum = oplus.minkowski_sum(slot, plug, boundary="open")
    assert open_sum.isolated_vertices and oplus.verify(slot, plug, str(open_sum), boundary="open")
    assert not oplus.verify(slot, plug, str(open_sum.region), boundary="open")


def test_a_set_is_true_unless_it_is_empty():
    assert oplus.Region(SQUARE) and oplus.ifp(SQUARE, SQUARE) and oplus.PlanarSet("POINT (1 1)")
    assert not oplus.Region([]) and not oplus.ifp(SQUARE, [[0, 0], [2, 0], [0, 2]])


def test_one_factor_scales_both_coordinates():
    assert oplus.Region(SQUARE).scaled(2) == oplus.Region(SQUARE).scaled(2, 2)


def test_equal_sets_are_equal_in_any_form():
    turned = oplus.Region(SQUARE[1:] + SQUARE[:1])
    assert turned == oplus.Region(SQUARE)
    twice = oplus.minkowski_sum(SQUARE, SQUARE)
    assert twice == oplus.PlanarSet(twice.region) and twice.region == turned.scaled(2)


def test_files(tmp_path):
    (tmp_path / "set.wkt").write_text("GEOMETRYCOLLECTION (POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0)), POINT (3 3))")
    (tmp_path / "region.dat").write_text("4 0 0 1 0 1 1 0 1")
    assert oplus.read_file(tmp_path / "region.dat") == oplus.Region(SQUARE)
    assert oplus.read_set_file(str(tmp_path / "set.wkt")).isolated_vertices == [(3, 3)]
    with pytest.raises(oplus.InvalidInput, match="cannot be opened"):
        oplus.read_file(tmp_path / "missing")


def test_ctrl_c_ends_a_computation():
    program = """
import math, oplus, os, signal, threading
ring = [(round(1e6 * (1 + i % 2) * math.cos(i / 600 * math.pi)), round(1e6 * (1 + i % 2) * math.sin(i / 600 * math.pi)))
        for i in range(1200)]
thorns = oplus.Region(ring)
threading.Timer(0.5, lambda: os.kill(os.getpid(), signal.SIGINT)).start()
try:
    for _ in range(10000):
        oplus.close(thorns, thorns)
    print("finished")
except KeyboardInterrupt:
    print("ended")
"""
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, timeout=300, check=True)
    assert done.stdout == "ended\n"
