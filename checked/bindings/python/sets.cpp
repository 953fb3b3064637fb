// SPDX-License-Identifier: MIT
#include <pybind11/stl.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "checked/bindings/python/module.hpp"
#include "checked/bindings/python/numbers.hpp"
#include "checked/bindings/python/output.hpp"
#include "checked/bindings/python/shapes.hpp"
#include "checked/bindings/python/unlocked.hpp"

namespace oplus::python {

namespace {

const ValidRegion& value(const PreparedRegion& region) { return region.region(); }
const ValidSet& value(const ValidSet& set) { return set; }
const ValidRegion& region(const PreparedRegion& region) { return region.region(); }
const ValidRegion& region(const ValidSet& set) { return set.region(); }

/// Returns the numbers of components, holes and vertices.
py::tuple counts(const ValidRegion& region) {
  std::size_t holes = 0, vertices = 0;
  for (const Component& component : region.components()) {
    holes += component.holes.size();
    vertices += component.outer.size();
    for (const Chain& hole : component.holes) vertices += hole.size();
  }
  return py::make_tuple(region.components().size(), holes, vertices);
}

/// Returns the least x and y, and the greatest ones; None without a component.
py::object bounds(const ValidRegion& region) {
  std::vector<const Rational*> x, y;
  for (const Component& component : region.components())
    for (const Point& p : component.outer) {
      x.push_back(&p.x);
      y.push_back(&p.y);
    }
  if (x.empty()) return py::none();
  const auto less = [](const Rational* a, const Rational* b) { return *a < *b; };
  const auto [left, right] = std::minmax_element(x.begin(), x.end(), less);
  const auto [below, above] = std::minmax_element(y.begin(), y.end(), less);
  return py::make_tuple(to_python(**left), to_python(**below), to_python(**right),
                        to_python(**above));
}

/// Returns each component as a region of its own.
std::vector<PreparedRegion> parts(const ValidRegion& region) {
  std::vector<PreparedRegion> result;
  for (const Component& component : region.components()) {
    Region holes;
    for (const Chain& hole : component.holes) holes.components.push_back({hole, {}});
    result.emplace_back(component.outer.empty() ? complement(ValidRegion(std::move(holes)))
                                                : ValidRegion({{component}}));
  }
  return result;
}

/// The closed union of a region, which may be unbounded, of edges and of points.
ValidSet planar_set(const PreparedRegion& region, const py::list& edges, const py::list& points) {
  std::vector<std::vector<Coordinates>> lines;
  std::vector<Coordinates> of_points;
  for (const py::handle edge : edges) {
    auto& line = lines.emplace_back();
    for (const py::handle point : edge) line.emplace_back(point_of(point));
  }
  for (const py::handle point : points) of_points.emplace_back(point_of(point));
  return unlocked([&] { return ValidSet(region.region(), lines, of_points); });
}

/// What both classes have.
template <typename T>
void define_set(py::module_& m, py::class_<T> type) {
  using S = const T&;
  type.def("__contains__", [](S s, py::handle point) {
    const Point p = point_of(point);
    return unlocked([&] { return contains(value(s), p); });
  });
  type.def("__neg__", [](S s) { return unlocked([&] { return T(-value(s)); }); });
  type.def(
      "__eq__", [](S a, S b) { return unlocked([&] { return value(a) == value(b); }); },
      py::is_operator());
  m.def("locate", [](S s, py::handle point) {
    const Point p = point_of(point);
    return name_of(unlocked([&] { return locate(p, value(s)); }));
  });
  m.def("transformed", [](S s, py::handle a, py::handle b, py::handle c, py::handle d, py::handle x,
                          py::handle y) {
    const AffineMap map{number_of(a).value(),
                        number_of(b).value(),
                        number_of(c).value(),
                        number_of(d).value(),
                        {number_of(x).value(), number_of(y).value()}};
    return unlocked([&] { return T(transformed(value(s), map)); });
  });
  m.def("scaled", [](S s, py::handle x, py::handle y) {
    const AffineMap map = scaling(number_of(x), number_of(y));
    return unlocked([&] { return T(transformed(value(s), map)); });
  });
  m.def("complement", [](S s) { return unlocked([&] { return T(complement(value(s))); }); });
  m.def("area", [](S s) { return to_python(unlocked([&] { return area(value(s)); })); });
  m.def("components", [](S s) { return components_of(value(s).components()); });
  m.def("parts", [](S s) { return unlocked([&] { return parts(region(s)); }); });
  m.def("counts", [](S s) { return counts(region(s)); });
  m.def("bounds", [](S s) { return bounds(region(s)); });
  m.def("is_unbounded", [](S s) { return is_unbounded(region(s)); });
  m.def("to_wkt", [](S s, std::optional<int> digits) {
    return unlocked([&] { return to_wkt(value(s), digits); });
  });
  m.def("to_geojson", [](S s, std::optional<int> digits) {
    return unlocked([&] { return to_geojson(value(s), digits); });
  });
  m.def("to_wkb", [](S s) { return unlocked([&] { return to_wkb(value(s)); }); });
  m.def("to_dat", [](S s) { return unlocked([&] { return to_dat(value(s)); }); });
}

py::dict statistics_of(const ValidSet& sum) {
  py::dict result;
  for (const Statistic& one : sum.statistics()) {
    const py::str name(one.name.data(), one.name.size());
    if (const auto* count = std::get_if<std::size_t>(&one.value))
      result[name] = *count;
    else if (const auto* seconds = std::get_if<Seconds>(&one.value))
      result[name] = seconds->count();
    else
      result[name] = to_python(std::get<Rational>(one.value));
  }
  return result;
}

py::list origins_of(const ValidSet& sum) {
  py::list result;
  for (const std::vector<Origin>& of_edge : sum.origins()) {
    py::list all;
    for (const Origin& one : of_edge)
      all.append(py::make_tuple(one.edge_of == Summand::P ? "p" : "q",
                                py::make_tuple(one.edge.chain, one.edge.vertex),
                                py::make_tuple(one.vertex.chain, one.vertex.vertex)));
    result.append(all);
  }
  return result;
}

}  // namespace

void define_sets(py::module_& m) {
  py::class_<PreparedRegion> regions(m, "Region");
  py::class_<ValidSet> sets(m, "PlanarSet");
  regions.def(py::init([](py::handle value) { return region_of(value); }), py::arg("value"));
  sets.def(py::init([](py::handle value) { return planar_set_of(value); }), py::arg("value"));
  define_set(m, regions);
  define_set(m, sets);
  m.def("planar_set", planar_set);
  m.def("boundary",
        [](const ValidSet& s) { return s.boundary() == Boundary::open ? "open" : "closed"; });
  m.def("region", [](const ValidSet& s) { return PreparedRegion(s.region()); });
  m.def("dangling_edges", [](const ValidSet& s) { return edges_of(s.dangling_edges()); });
  m.def("isolated_vertices", [](const ValidSet& s) { return points_of(s.isolated_vertices()); });
  m.def("statistics", statistics_of);
  m.def("origins", origins_of);
}

}  // namespace oplus::python
