# SPDX-License-Identifier: GPL-3.0-or-later
"""What regions are made from, and what is refused."""

import tracemalloc
from decimal import Decimal
from fractions import Fraction

import numpy
import pytest
import shapely.geometry
from hypothesis import given, strategies

import oplus

SQUARE = [[0, 0], [1, 0], [1, 1], [0, 1]]
HOLE = [[[0, 0], [4, 0], [4, 4], [0, 4]], [[1, 1], [1, 2], [2, 1]]]


def polygon(rings):
    return {"type": "Polygon", "coordinates": rings}


@given(strategies.one_of(
    strategies.fractions(), strategies.integers(), strategies.integers(-10**60, 10**60),
    strategies.floats(allow_nan=False, allow_infinity=False),
    strategies.decimals(allow_nan=False, allow_infinity=False),
    strategies.floats(allow_nan=False, allow_infinity=False, width=32).map(numpy.float32),
    strategies.integers(-2**63, 2**63 - 1).map(numpy.int64),
    strategies.integers(0, 2**64 - 1).map(numpy.uint64)))
def test_numbers_are_exact(number):
    exact = Fraction(int(number)) if isinstance(number, numpy.integer) else Fraction(*number.as_integer_ratio())
    found = oplus.Region([[number, number], [exact + 1, exact], [exact, exact + 1]])
    assert found.components[0][0][0] == (exact, exact)
    assert type(found.components[0][0][0][0]) is Fraction


def test_text_is_a_number():
    assert oplus.Region([["0.1", "-1/3"], ["1e2", 0], [0, 1]]).components[0][0][0] == (
        Fraction(1, 10), Fraction(-1, 3))


@pytest.mark.parametrize("value", [
    HOLE, [HOLE], [[ring + ring[:1] for ring in HOLE]], polygon(HOLE), tuple(map(tuple, HOLE)),
    [numpy.array(ring) for ring in HOLE], {"type": "MultiPolygon", "coordinates": [HOLE]},
    {"type": "Feature", "geometry": polygon(HOLE), "properties": {}},
    {"type": "FeatureCollection", "features": [{"type": "Feature", "geometry": polygon(HOLE)},
                                               {"type": "Feature", "geometry": None}]},
    {"type": "GeometryCollection", "geometries": [polygon(HOLE)]},
    shapely.geometry.Polygon(HOLE[0], HOLE[1:]),
    "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0), (1 1, 1 2, 2 1, 1 1))",
    shapely.geometry.Polygon(HOLE[0], HOLE[1:]).wkb,
    "M 0 0 h 4 v 4 h -4 z M 1 1 L 1 2 2 1 Z", oplus.Region(HOLE)], ids=lambda value: type(value).__name__)
def test_forms_of_a_region(value):
    assert oplus.Region(value) == oplus.Region(HOLE)


@pytest.mark.parametrize("empty", [[], (), "POLYGON EMPTY", shapely.geometry.Polygon(), numpy.zeros((0, 2)),
                                   {"type": "MultiPolygon", "coordinates": []}], ids=repr)
def test_the_empty_region(empty):
    assert oplus.Region(empty).components == []
    assert oplus.minkowski_sum(empty, SQUARE).to_shapely().is_empty


@pytest.mark.parametrize("kind", ["float64", "float32", "float16", "int64", "int32", "uint8", "uint32", ">f8", "object"])
def test_arrays_of_any_kind(kind):
    array = numpy.array(SQUARE).astype(kind)
    assert oplus.Region(array) == oplus.Region(SQUARE)
    # Every second row, the columns exchanged, two columns of four.
    assert oplus.Region(numpy.repeat(array, 2, axis=0)[::2]) == oplus.Region(SQUARE)
    assert oplus.Region(array[::-1, ::-1]).area == 1
    assert oplus.Region(numpy.ma.array(array)) == oplus.Region(SQUARE)
    assert oplus.Region(numpy.hstack([array, array])[:, 2:]) == oplus.Region(SQUARE)


@pytest.mark.parametrize("kind, is_copied", [("float64", False), ("int64", False), ("float32", True)])
def test_arrays_are_not_copied(kind, is_copied):
    n = 20000
    triangles = numpy.array([[0, 0], [1, 0], [0, 1]]) + 10 * numpy.arange(n)[:, None, None]
    coordinates = triangles.reshape(-1, 2).astype(kind)
    arrays = oplus.Arrays(coordinates, numpy.arange(0, 3 * n + 1, 3), regions=numpy.array([0, n]))
    tracemalloc.start()
    [region] = oplus.from_arrays(arrays)
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert region.area == Fraction(n, 2)
    assert (peak >= coordinates.nbytes) == is_copied


def test_results_are_not_copied():
    arrays = oplus.to_arrays([oplus.Region(SQUARE)] * 3)
    assert not any(array.flags.owndata for array in arrays)
    assert [array.dtype for array in arrays] == ["float64", "int64", "int64", "int64"]
    assert arrays.coordinates.shape == (12, 2)


@pytest.mark.parametrize("value, wrong", [
    ([[0, 0], [2, 2], [2, 0], [0, 2]], r"cross at \(1, 1\)"),
    ([[0, 0], [1, 0]], "2 vertices"),
    ([[0, 0], [1, 0], [0, float("inf")]], "infinite"),
    ([[0, 0], [1, 0], [0, numpy.float32("nan")]], "not a number"),
    ([[0, 0], [1, 0], [0, Decimal("Infinity")]], "infinite"),
    ([[0, 0], [1, 0], [0, "x"]], "x"),
    ([[0, 0], [1], [0, 1]], "less than two"),
    ([[[0, 0], [4, 0], [0, 4]], [[5, 5], [6, 5], [5, 6]]], "hole"),
    (b"\x01\x03", r"text:1:1: the byte '\\x01' is not text"),
    ({"type": "Curve"}, "Curve"), ({"type": "two\nlines"}, r"'two\\nlines'"),
    ({"coordinates": []}, "type"),
    ({"type": "LineString", "coordinates": [[0, 0], [1, 1]]}, "line strings or points"),
    (polygon([[], [[0, 0], [1, 0], [0, 1]]]), "outer ring"),
    (numpy.zeros((3, 1)), "shape"), (numpy.zeros(3), "coordinates in 1"), ([1, 2], "coordinates in 1"),
    ([[[[[0, 0]]]]], "coordinates in 5"),
    (numpy.ma.masked_equal([[0, 0], [1, 0], [0, 9]], 9), "masked"),
    (numpy.array([[0, 0], [1, 0], [0, numpy.nan]]), "not a number")], ids=repr)
def test_invalid_input_is_one_line(value, wrong):
    with pytest.raises(oplus.InvalidInput, match=wrong) as error:
        oplus.Region(value)
    assert isinstance(error.value, ValueError)
    assert "\n" not in str(error.value) and "expected" in str(error.value)


@pytest.mark.parametrize("value", [1, None, object(), [[0, 0], [1, None], [0, 1]], [[0, 0], {}, [0, 1]],
                                   [[0, 0], "12", [0, 1]], numpy.zeros((3, 2), dtype=complex), [["a", "b"], b"12"],
                                   numpy.zeros((3, 2), dtype=bool), iter(SQUARE), {1, 2}], ids=repr)
def test_other_types_are_type_errors(value):
    with pytest.raises((TypeError, oplus.InvalidInput)) as error:
        oplus.Region(value)
    assert "\n" not in str(error.value)


class Endless:
    @property
    def __geo_interface__(self):
        return self


class Ratio:
    def __init__(self, *ratio):
        self.ratio = ratio

    def as_integer_ratio(self):
        return self.ratio


def endless_list():
    value = []
    value.append(value)
    return value


def deep_list():
    value = []
    for _ in range(200000):
        value = [value]
    return value


def endless_collection():
    value = {"type": "GeometryCollection", "geometries": []}
    value["geometries"] += [value, value]
    return value


@pytest.mark.parametrize("make, wrong", [
    (endless_list, "in more than 5 lists"), (deep_list, "in more than 5 lists"),
    (Endless, "inside of 64 others"), (endless_collection, "inside of 64 others"),
    (lambda: [[0, 0], [1, 0], [0, Ratio(1, 0)]], "its denominator is 0"),
    (lambda: "\ud800", "text: a surrogate"), (lambda: [["\ud800", 0], [1, 0], [0, 1]], "text: a surrogate"),
    (lambda: {"type": "\ud800"}, "text: a surrogate")])
def test_input_without_end_or_sense(make, wrong):
    with pytest.raises(oplus.InvalidInput, match=wrong):
        oplus.Region(make())


@pytest.mark.parametrize("ratio", [("a", 2), (1e30, 2), (1, None), (1,), (1, 2, 3)])
def test_a_ratio_is_of_integers(ratio):
    with pytest.raises(TypeError):
        oplus.Region([[Ratio(*ratio), 0], [1, 0], [0, 1]])


class Refusing:
    def as_integer_ratio(self):
        raise ValueError


def test_a_number_that_is_neither_a_ratio_nor_a_float():
    with pytest.raises(TypeError):
        oplus.Region([[Refusing(), 0], [1, 0], [0, 1]])


@pytest.mark.parametrize("number", ["1e400000000", "-1e400000000", "1e-400000000"])
def test_exponents_of_decimals_are_limited(number):
    with pytest.raises(oplus.InvalidInput, match="too large an exponent"):
        oplus.Region([[Decimal(number), 0], [1, 0], [0, 1]])
    exact = Decimal("7" * 10000)
    assert oplus.Region([[exact, 0], [0, 1], [0, 0]]).area == Fraction(exact) / 2


class Emptying:
    """A number that empties the list it is in."""

    def __init__(self, owner):
        self.owner = owner

    def as_integer_ratio(self):
        self.owner.clear()
        raise OverflowError

    def __float__(self):
        return 5.0


def test_a_list_that_changes_while_it_is_read():
    point = [0, 7]
    point[0] = Emptying(point)
    assert oplus.Region([point, [1, 0], [0, 1]]) == oplus.Region([[5, 7], [1, 0], [0, 1]])


class Corners:
    """A sequence that makes its points when it is asked for them, as Shapely's do."""

    def __len__(self):
        return len(SQUARE)

    def __getitem__(self, i):
        return tuple(SQUARE[i])


def test_sequences_that_make_their_points():
    assert oplus.Region(polygon([Corners()])) == oplus.Region(SQUARE)
    ring = shapely.geometry.Polygon(SQUARE).exterior
    assert oplus.Region(polygon([ring.coords])) == oplus.Region(SQUARE)


@pytest.mark.parametrize("error", [ValueError, KeyboardInterrupt])
def test_errors_of_a_geometry_are_raised(error):
    class Broken:
        @property
        def __geo_interface__(self):
            raise error("broken")

    with pytest.raises(error, match="broken"):
        oplus.Region(Broken())


def test_a_geometry_is_asked_once():
    class Counting:
        asked = 0

        @property
        def __geo_interface__(self):
            self.asked += 1
            return polygon([SQUARE])

    value = Counting()
    assert oplus.Region(value).area == 1 and value.asked == 1


@pytest.mark.parametrize("kind, use", [
    (oplus.Region, repr), (oplus.PlanarSet, repr), (oplus.Region, lambda value: oplus.nfp(value, value))])
def test_objects_that_were_not_made(kind, use):
    with pytest.raises(TypeError, match="without a value"):
        use(kind.__new__(kind))


def test_an_array_of_a_type_that_is_not_taken():
    with pytest.raises(TypeError, match="array of uint64: expected floats or signed integers of at most 64 bits, or unsigned"):
        oplus.Region(numpy.array(SQUARE, dtype="uint64"))


@pytest.mark.parametrize("coordinates, rings, wrong", [
    ([[0, 0], [1]], [0, 2], "coordinates: not an array; expected shape"),
    ([[0, 0], [1, 0]], [[0], [1, 2]], "rings: not an array; expected offsets"),
    (numpy.ma.masked_equal([[0, 0], [1, 0], [0, 9]], 9), [0, 3], "coordinates: values are masked"),
    (SQUARE, numpy.ma.masked_equal([0, 3, 4], 3), "rings: values are masked")])
def test_values_that_are_no_array(coordinates, rings, wrong):
    with pytest.raises(oplus.InvalidInput, match=wrong):
        oplus.from_arrays(oplus.Arrays(coordinates, rings))


@pytest.mark.parametrize("value", [None, SQUARE, numpy.array(SQUARE), (SQUARE, [0, 4])], ids=repr)
def test_other_types_are_not_arrays(value):
    with pytest.raises(TypeError, match="expected oplus.Arrays"):
        oplus.from_arrays(value)


def test_geometries_of_exact_regions_are_exact():
    exact = oplus.Region([[0, 0], ["1/3", 0], [0, 1]])
    assert oplus.Region({"type": "Feature", "geometry": exact}) == exact
    total = oplus.minkowski_sum(exact, exact)
    assert oplus.Region({"type": "GeometryCollection", "geometries": [total]}) == total.region


def test_sums_of_line_strings_and_points():
    path = shapely.geometry.LineString([(0, 0), (4, 0), (4, 3)])
    assert oplus.minkowski_sum(path, SQUARE).area == 8
    assert oplus.minkowski_sum("POINT (3 4)", SQUARE).components == oplus.Region(SQUARE).translated(3, 4).components
    cross = oplus.minkowski_sum("LINESTRING (0 0, 1 0)", "LINESTRING (0 0, 2 0)")
    assert cross.dangling_edges == [((0, 0), (3, 0))] and cross.components == []
    collection = shapely.geometry.GeometryCollection([shapely.geometry.Point(9, 9), path])
    assert oplus.minkowski_sum(collection, [[0, 0], [1, 0], [0, 1]]).to_shapely().contains(shapely.geometry.Point(9.2, 9.2))
    assert oplus.PlanarSet(path) == oplus.PlanarSet(path.wkt) == -oplus.PlanarSet(path.wkt.replace("4", "-4").replace("3", "-3"))
    # The result is a summand again, edges included.
    assert oplus.minkowski_sum(cross, SQUARE).area == 4


def test_what_is_more_than_a_region_is_not_taken_for_one():
    places = oplus.ifp([[0, 0], [5, 0], [5, 1], [0, 1]], SQUARE)
    with pytest.raises(oplus.InvalidInput, match="dangling edges"):
        oplus.ifp(places, SQUARE)
    blocked = oplus.nfp([HOLE[0], [[1, 1], [1, 2], [2, 2], [2, 1]]], SQUARE)
    assert blocked.isolated_vertices == [(1, 1)]
    with pytest.raises(oplus.InvalidInput, match="open set"):
        oplus.minkowski_sum(blocked, SQUARE)
    assert oplus.minkowski_sum(blocked.region, SQUARE).area == 36


@pytest.mark.parametrize("value", [
    [[0, 0, 5], [1, 0, 5], [0, 1, 5]], numpy.zeros((3, 3)),
    shapely.geometry.Polygon([(0, 0, 5), (1, 0, 5), (0, 1, 5)])])
def test_a_third_coordinate_is_an_error(value):
    with pytest.raises(oplus.InvalidInput, match=r"more than two coordinates|expected shape \(n, 2\)"):
        oplus.Region(value)
    with pytest.raises(oplus.InvalidInput, match="more than two coordinates"):
        oplus.Region(SQUARE).locate((1, 2, 3))
