// SPDX-License-Identifier: MIT
#include "checked/bindings/python/results.hpp"

#include <pybind11/stl.h>

#include <oplus/oplus.hpp>
#include <optional>

#include "checked/bindings/python/instances.hpp"
#include "checked/bindings/python/numbers.hpp"
#include "checked/bindings/python/output.hpp"
#include "checked/bindings/python/shapes.hpp"
#include "checked/bindings/python/unlocked.hpp"
#include "reference/io/counted.hpp"

namespace oplus::python {

namespace {

py::dict geo_interface(const ValidSet& s) {
  return python::geo_interface(s.region(), s.dangling_edges(), s.isolated_vertices());
}

std::string summary(const ValidSet& sum) {
  return std::string("<oplus.PlanarSet: ") +
         (sum.boundary() == Boundary::open ? "open, " : "closed, ") +
         counted(sum.components().size(), "component", "components") + ", " +
         counted(sum.dangling_edges().size(), "dangling edge", "dangling edges") + ", " +
         counted(sum.isolated_vertices().size(), "isolated vertex", "isolated vertices") + ">";
}

void define_sum(py::module_& m) {
  using S = const ValidSet&;
  py::class_<ValidSet>(m, "PlanarSet",
                       R"(A region, edges and points together, exact: what operations return.

PlanarSet(value) takes what Region takes, and geometries and text with line strings and points, which
may overlap. A set never changes. One without dangling edges and isolated vertices is taken wherever
a region is; of others, `region` is. All closed ones are summands of minkowski_sum.

>>> path = oplus.PlanarSet('LINESTRING (0 0, 4 0, 4 3)')
>>> print(oplus.minkowski_sum(path, [[0, 0], [1, 0], [1, 1], [0, 1]]))
POLYGON ((0 0, 5 0, 5 4, 4 4, 4 1, 0 1, 0 0))

>>> room = [[[0, 0], [5, 0], [5, 5], [0, 5]], [[1, 1], [1, 4], [4, 4], [4, 1]]]
>>> oplus.nfp(room, [[0, 0], [3, 0], [3, 1], [0, 1]])
<oplus.PlanarSet: open, 1 component, 1 dangling edge, 0 isolated vertices>
)")
      .def(py::init([](py::handle value) { return planar_set_of(value); }), py::arg("value"))
      .def(
          "__neg__", [](S s) { return unlocked([&] { return -s; }); },
          "The set, turned by 180 degrees.")
      .def_property_readonly(
          "boundary", [](S s) { return s.boundary() == Boundary::open ? "open" : "closed"; },
          R"('closed' or 'open'.

>>> oplus.nfp([[0, 0], [1, 0], [0, 1]], [[0, 0], [1, 0], [0, 1]]).boundary
'open'
)")
      .def_property_readonly(
          "region", [](S s) { return PreparedRegion(s.region()); },
          R"(Its Region, without dangling edges and isolated vertices.

>>> square = [[0, 0], [1, 0], [1, 1], [0, 1]]
>>> oplus.minkowski_sum(square, square).region.area
Fraction(4, 1)
)")
      .def_property_readonly(
          "components", [](S s) { return components_of(s.components()); },
          R"(A list of pairs (outer ring, list of holes), as Region.components has.

>>> [(outer, holes)] = oplus.minkowski_sum([[0, 0], [1, 0], [0, 1]], [[0, 0], [1, 0], [0, 1]]).components
>>> outer == [(0, 0), (2, 0), (0, 2)], holes
(True, [])
)")
      .def_property_readonly(
          "dangling_edges", [](S s) { return edges_of(s.dangling_edges()); },
          R"(Where one region just fits into the other and can be moved: pairs of points.

Of an open sum they belong to its complement, of a closed set to the set.

>>> oplus.ifp([[0, 0], [5, 0], [5, 1], [0, 1]], [[0, 0], [3, 0], [3, 1], [0, 1]]).dangling_edges
[((Fraction(0, 1), Fraction(0, 1)), (Fraction(2, 1), Fraction(0, 1)))]
)")
      .def_property_readonly(
          "isolated_vertices", [](S s) { return points_of(s.isolated_vertices()); },
          R"(Where one region just fits into the other and cannot be moved: points.

>>> bin = [[0, 0], [100, 0], [100, 100], [0, 100]]
>>> oplus.ifp(bin, bin).isolated_vertices
[(Fraction(0, 1), Fraction(0, 1))]
)")
      .def_property_readonly(
          "area", [](S s) { return to_python(unlocked([&] { return area(s); })); },
          R"(The area, a Fraction.

>>> oplus.minkowski_sum([[0, 0], [1, 0], [0, 1]], [[0, 0], [1, 0], [0, 1]]).area
Fraction(2, 1)
)")
      .def(
          "locate",
          [](S s, py::handle point) {
            const Point p = point_of(point);
            return name_of(unlocked([&] { return locate(p, s); }));
          },
          py::arg("point"), R"(locate(point)
--

Returns 'inside', 'boundary' or 'outside', exactly. Dangling edges and isolated vertices belong to
the boundary.

>>> oplus.minkowski_sum([[0, 0], [1, 0], [0, 1]], [[0, 0], [1, 0], [0, 1]]).locate((1, 1))
'boundary'
)")
      .def("__contains__",
           [](S s, py::handle point) {
             const Point p = point_of(point);
             return unlocked([&] { return contains(s, p); });
           })
      .def(
          "__eq__", [](S a, S b) { return unlocked([&] { return a == b; }); }, py::is_operator())
      .def("__repr__", summary)
      .def("__str__",
           [](S s) {
             const bool is_dat = is_unbounded(s.region());
             if (is_dat && !(s.dangling_edges().empty() && s.isolated_vertices().empty()))
               return summary(s);  // no format holds it
             return unlocked([&] { return is_dat ? to_dat(s) : to_wkt(s); });
           })
      .def(
          "to_wkt",
          [](S s, std::optional<int> digits) {
            return unlocked([&] { return to_wkt(s, digits); });
          },
          py::arg("digits") = py::none(), R"(to_wkt(digits=None)
--

Returns WKT as Region.to_wkt does, with edges and points in a collection.

>>> oplus.ifp([[0, 0], [5, 0], [5, 1], [0, 1]], [[0, 0], [3, 0], [3, 1], [0, 1]]).to_wkt()
'GEOMETRYCOLLECTION (LINESTRING (0 0, 2 0))'
)")
      .def(
          "to_geojson",
          [](S s, std::optional<int> digits) {
            return unlocked([&] { return to_geojson(s, digits); });
          },
          py::arg("digits") = py::none(), R"(to_geojson(digits=None)
--

Returns GeoJSON, as to_wkt does; fractions are strings.

>>> oplus.minkowski_sum([[0, 0], [1, 0], [0, 1]], [[0, 0], [1, 0], [0, 1]]).to_geojson()
'{"type": "Polygon", "coordinates": [[[0, 0], [2, 0], [0, 2], [0, 0]]]}'
)")
      .def(
          "to_wkb", [](S s) { return bytes_of(to_wkb(s)); }, R"(to_wkb()
--

Returns WKB, as to_wkt does. Raises InvalidInput where a coordinate is not exactly a double.

>>> len(oplus.minkowski_sum([[0, 0], [1, 0], [0, 1]], [[0, 0], [1, 0], [0, 1]]).to_wkb())
77
)")
      .def(
          "to_dat", [](S s) { return unlocked([&] { return to_dat(s); }); }, R"(to_dat()
--

Returns .dat, which holds unbounded regions, too; exactly. Raises ValueError where the set has dangling
edges or isolated vertices.

>>> oplus.erode([[0, 0], [2, 0], [0, 2]], [[0, 0], [1, 0], [0, 1]]).to_dat()
'3\n0 0\n1 0\n0 1\n'
)")
      .def("__bool__", [](S s) { return !(s == ValidSet()); })
      .def_property_readonly("__geo_interface__", [](S s) { return geo_interface(s); })
      .def(
          "to_shapely", [](S s) { return to_shapely(geo_interface(s)); }, R"(to_shapely()
--

Returns Shapely's geometry as Region.to_shapely does; dangling edges are line strings and isolated
vertices points, in a collection where there are several parts.

>>> oplus.ifp([[0, 0], [5, 0], [5, 1], [0, 1]], [[0, 0], [3, 0], [3, 1], [0, 1]]).to_shapely().length
2.0
)");
}

py::dict changes_of(const TopologyChanges& c) {
  py::dict result;
  const auto add = [&](const char* name, std::size_t n) {
    if (n != 0) result[name] = n;
  };
  add("vanished_components", c.vanished_components);
  add("joined_components", c.joined_components);
  add("split_components", c.split_components);
  add("new_components", c.new_components);
  add("closed_holes", c.closed_holes);
  add("joined_holes", c.joined_holes);
  add("split_holes", c.split_holes);
  add("opened_holes", c.opened_holes);
  add("new_holes", c.new_holes);
  add("lost_edges_and_points", c.lost_edges_and_points);
  return result;
}

void define_rounded(py::module_& m) {
  using R = const Rounded&;
  py::class_<Rounded>(m, "Rounded", "What rounded returns.")
      .def_property_readonly(
          "sum", [](R r) { return r.sum; }, "The PlanarSet on the grid.")
      .def_property_readonly(
          "is_exact", [](R r) { return r.is_exact; }, "Whether nothing had to be rounded.")
      .def_property_readonly(
          "bound", [](R r) { return to_python(r.bound); },
          "How far boundaries are from each other at most, in x and in y: a Fraction.")
      .def_property_readonly(
          "changes", [](R r) { return changes_of(r.changes); },
          "How many components and holes vanished, became one or came apart: those that are not "
          "zero, by name.");
}

void define_verdict(py::module_& m) {
  using X = const Reason&;
  py::class_<Reason>(m, "Reason", "A difference between a set and the sum.")
      .def_property_readonly(
          "kind", [](X r) { return describe(r.kind); }, "In words: 'missing hole'.")
      .def_property_readonly(
          "witness", [](X r) { return to_python(r.witness); }, "A point that shows it.")
      .def_property_readonly(
          "in_sum", [](X r) { return r.in_sum; }, "Whether the witness is in the sum.")
      .def_property_readonly(
          "in_given", [](X r) { return r.in_given; }, "Whether it is in the given set.")
      .def_property_readonly(
          "detail", [](X r) { return r.detail; }, "A line that says where.")
      .def("__repr__", [](X r) { return "<oplus.Reason: " + describe(r.kind) + '>'; });
  using V = const Verdict&;
  py::class_<Verdict>(m, "Verdict", "What verify returns. True where the set is the sum.")
      .def_property_readonly(
          "is_sum", [](V v) { return v.is_sum(); }, "Whether the given set is the sum.")
      .def("__bool__", [](V v) { return v.is_sum(); })
      .def_property_readonly(
          "reasons", [](V v) { return v.reasons; }, "Why it is not: a list of Reason.")
      .def_property_readonly(
          "notes", [](V v) { return v.notes; }, "What is unusual and changes nothing.")
      .def("__repr__", [](V v) {
        return v.is_sum()
                   ? std::string("<oplus.Verdict: it is the sum>")
                   : "<oplus.Verdict: " + counted(v.reasons.size(), "reason", "reasons") + ">";
      });
}

}  // namespace

void define_results(py::module_& m) {
  define_sum(m);
  define_rounded(m);
  define_verdict(m);
}

}  // namespace oplus::python
