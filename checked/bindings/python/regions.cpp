// SPDX-License-Identifier: MIT
#include <pybind11/stl.h>

#include <optional>

#include "checked/bindings/python/numbers.hpp"
#include "checked/bindings/python/output.hpp"
#include "checked/bindings/python/results.hpp"
#include "checked/bindings/python/shapes.hpp"
#include "checked/bindings/python/unlocked.hpp"
#include "reference/io/counted.hpp"

namespace oplus::python {

namespace {

PreparedRegion mapped(const PreparedRegion& region, const AffineMap& map) {
  return unlocked([&] { return PreparedRegion(transformed(region.region(), map)); });
}

std::string summary(const PreparedRegion& region) {
  std::size_t components = 0, holes = 0, vertices = 0;
  for (const Component& component : region.region().components()) {
    ++components;
    holes += component.holes.size();
    vertices += component.outer.size();
    for (const Chain& hole : component.holes) vertices += hole.size();
  }
  return "<oplus.Region: " + counted(components, "component", "components") + ", " +
         counted(holes, "hole", "holes") + ", " + counted(vertices, "vertex", "vertices") + ">";
}

void define_region(py::module_& m) {
  using R = const PreparedRegion&;
  py::class_<PreparedRegion>(m, "Region", R"(A polygonal region with holes: a valid one.

Region(value) takes an object with __geo_interface__, such a dictionary, text (WKT, GeoJSON and
others), bytes of WKB, lists of coordinates, or an array of shape (n, 2). Lists are a ring, a list
of rings (the outer one and the holes), or a list of these. A coordinate is an int, a float, a
Fraction, a Decimal or text such as '1/3', taken for exactly what it is. Rings may be turned either
way, and may or may not repeat their first point at the end. Raises InvalidInput where chains
cross, overlap, or are not one inside the other. Cost: n log n for n vertices.

A region never changes. It keeps what depends on it alone for the next sum with it.

>>> triangle = oplus.Region([[0, 0], [1, 0], [0.5, '1/3']])
>>> triangle
<oplus.Region: 1 component, 0 holes, 3 vertices>
>>> print(triangle)
POLYGON ((0 0, 1 0, 0.5 1/3, 0 0))
>>> oplus.Region([[0, 0], [2, 2], [2, 0], [0, 2]])
Traceback (most recent call last):
    ...
oplus.InvalidInput: region: two edges of outer chain of component 1 cross at (1, 1): edge 1 from (0, 0) to (2, 2) and edge 3 from (2, 0) to (0, 2); expected a simple chain
)")
      .def(py::init([](py::handle value) { return region_of(value); }), py::arg("value"))
      .def_property_readonly(
          "components", [](R r) { return components_of(r.region().components()); },
          R"(A list of pairs (outer ring, list of holes), rings as lists of pairs of Fractions, the outer
ones counterclockwise, without a repeated point. One outer ring of an unbounded region is empty.

>>> oplus.Region([[0, 0], ['1/3', 0], [0, 1]]).components
[([(Fraction(0, 1), Fraction(0, 1)), (Fraction(1, 3), Fraction(0, 1)), (Fraction(0, 1), Fraction(1, 1))], [])]
)")
      .def_property_readonly(
          "area", [](R r) { return to_python(unlocked([&] { return area(r.region()); })); },
          R"(The area, a Fraction; of an unbounded region, minus that of its complement.

>>> oplus.Region([[0, 0], [1, 0], [0, 1]]).area
Fraction(1, 2)
)")
      .def_property_readonly(
          "is_unbounded", [](R r) { return is_unbounded(r.region()); },
          R"(Whether all points far enough away belong to it.

>>> oplus.complement([[0, 0], [1, 0], [0, 1]]).is_unbounded
True
)")
      .def(
          "locate",
          [](R r, py::handle point) {
            const Point p = point_of(point);
            return name_of(unlocked([&] { return locate(p, r.region()); }));
          },
          py::arg("point"), R"(locate(point)
--

Returns 'inside', 'boundary' or 'outside', exactly.

>>> oplus.Region([[0, 0], [1, 0], [0, 1]]).locate(('1/3', '2/3'))
'boundary'
)")
      .def("__contains__",
           [](R r, py::handle p) {
             const Point point = point_of(p);
             return unlocked([&] { return contains(r.region(), point); });
           })
      .def(
          "translated",
          [](R r, py::handle x, py::handle y) {
            return mapped(r, translation({number_of(x), number_of(y)}));
          },
          py::arg("x"), py::arg("y"), R"(translated(x, y)
--

Returns the region, moved by a vector.

>>> print(oplus.Region([[0, 0], [1, 0], [0, 1]]).translated('1/2', 2))
POLYGON ((0.5 2, 1.5 2, 0.5 3, 0.5 2))
)")
      .def(
          "scaled",
          [](R r, py::handle x, py::handle y) {
            return mapped(r, scaling(number_of(x), number_of(y.is_none() ? x : y)));
          },
          py::arg("x"), py::arg("y") = py::none(), R"(scaled(x, y=None)
--

Returns the region with each x and each y multiplied by a factor, by default both by x; negative ones
reflect it. Raises InvalidInput if one is zero.

>>> print(oplus.Region([[0, 0], [1, 0], [0, 1]]).scaled(-1, 1))
POLYGON ((0 0, 0 1, -1 0, 0 0))
)")
      .def(
          "rotated",
          [](R r, py::handle degrees, py::handle error) {
            const Number angle = number_of(degrees), at_most = number_of(error);
            return mapped(r, unlocked([&] { return rotation(angle, at_most); }));
          },
          py::arg("degrees"), py::arg("error") = "1/1000", R"(rotated(degrees, error='1/1000')
--

Returns the region, rotated counterclockwise about the origin: exactly by multiples of 90 degrees, else
by an angle with a rational sine and cosine that differs by at most `error` degrees; see rotation.

>>> print(oplus.Region([[0, 0], [2, 0], [0, 1]]).rotated(90))
POLYGON ((0 0, 0 2, -1 0, 0 0))
)")
      .def(
          "__neg__", [](R r) { return unlocked([&] { return PreparedRegion(-r.region()); }); },
          "The region, turned by 180 degrees.")
      .def(
          "__eq__", [](R a, R b) { return unlocked([&] { return a.region() == b.region(); }); },
          py::is_operator())
      .def("__repr__", summary)
      .def("__str__",
           [](R r) {
             return unlocked([&] {
               return is_unbounded(r.region()) ? to_dat(r.region()) : to_wkt(r.region());
             });
           })
      .def(
          "to_wkt",
          [](R r, std::optional<int> digits) {
            return unlocked([&] { return to_wkt(r.region(), digits); });
          },
          py::arg("digits") = py::none(), R"(to_wkt(digits=None)
--

Returns WKT: exact, with fractions p/q where a decimal would not end; or rounded to that many
decimal places, 0 to 4096, as rounded does, which all programs read. Raises ValueError where the
region is unbounded.

>>> oplus.Region([[0, 0], ['1/3', 0], [0, 1]]).to_wkt(digits=2)
'POLYGON ((0 0, 0.33 0, 0 1, 0 0))'
)")
      .def(
          "to_geojson",
          [](R r, std::optional<int> digits) {
            return unlocked([&] { return to_geojson(r.region(), digits); });
          },
          py::arg("digits") = py::none(), R"(to_geojson(digits=None)
--

Returns GeoJSON, as to_wkt does; fractions are strings.

>>> oplus.Region([[0, 0], [1, 0], [0, 1]]).to_geojson()
'{"type": "Polygon", "coordinates": [[[0, 0], [1, 0], [0, 1], [0, 0]]]}'
)")
      .def(
          "to_wkb", [](R r) { return bytes_of(to_wkb(r.region())); }, R"(to_wkb()
--

Returns WKB. Raises InvalidInput where a coordinate is not exactly a double, ValueError where the
region is unbounded.

>>> oplus.Region(oplus.Region([[0, 0], [1, 0], [0, 1]]).to_wkb()).area
Fraction(1, 2)
)")
      .def(
          "to_dat", [](R r) { return unlocked([&] { return to_dat(r.region()); }); }, R"(to_dat()
--

Returns .dat, which holds unbounded regions, too; exactly.

>>> oplus.complement([[0, 0], [1, 0], [0, 1]]).to_dat()
'0\n1\n3\n0 0\n0 1\n1 0\n'
)")
      .def("__bool__", [](R r) { return !r.region().components().empty(); })
      .def_property_readonly("__geo_interface__",
                             [](R r) { return geo_interface(r.region(), {}, {}); })
      .def(
          "to_shapely", [](R r) { return to_shapely(geo_interface(r.region(), {}, {})); },
          R"(to_shapely()
--

Returns Shapely's geometry, each coordinate the nearest double, so that it may be invalid; that of
rounded(region, 2**-20), say, is valid and exact. Raises InvalidInput where the region is unbounded.

>>> oplus.Region([[0, 0], [1, 0], [0, 1]]).to_shapely().area
0.5
)");
}

}  // namespace

void define_regions(py::module_& m) { define_region(m); }

}  // namespace oplus::python
