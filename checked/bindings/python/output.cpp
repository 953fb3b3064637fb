// SPDX-License-Identifier: MIT
#include "checked/bindings/python/output.hpp"

#include <utility>

#include "checked/bindings/python/numbers.hpp"

namespace oplus::python {

namespace {

py::list chain_of(const Chain& chain) { return points_of(chain); }

py::tuple pair(const Point& p) {
  const auto [x, y] = to_double(p);
  return py::make_tuple(x, y);
}

/// Its first point is repeated, as GeoJSON has it.
py::tuple ring(const Chain& chain) {
  py::tuple result(chain.size() + 1);
  for (std::size_t i = 0; i <= chain.size(); ++i) result[i] = pair(chain[i % chain.size()]);
  return result;
}

py::tuple polygon(const Component& component) {
  py::tuple rings(1 + component.holes.size());
  rings[0] = ring(component.outer);
  for (std::size_t i = 0; i < component.holes.size(); ++i) rings[i + 1] = ring(component.holes[i]);
  return rings;
}

py::dict geometry(const char* type, const py::object& coordinates) {
  py::dict result;
  result["type"] = type;
  result["coordinates"] = coordinates;
  return result;
}

}  // namespace

py::list components_of(const std::vector<Component>& components) {
  py::list result;
  for (const Component& component : components) {
    py::list holes;
    for (const Chain& hole : component.holes) holes.append(chain_of(hole));
    result.append(py::make_tuple(chain_of(component.outer), holes));
  }
  return result;
}

py::list edges_of(const std::vector<Segment>& edges) {
  py::list result;
  for (const Segment& edge : edges)
    result.append(py::make_tuple(to_python(edge.source), to_python(edge.target)));
  return result;
}

py::list points_of(const std::vector<Point>& points) {
  py::list result;
  for (const Point& p : points) result.append(to_python(p));
  return result;
}

py::dict geo_interface(const ValidRegion& region, const std::vector<Segment>& edges,
                       const std::vector<Point>& points) {
  if (is_unbounded(region))
    throw InvalidInput({"region", 0, 0}, "it is unbounded", "a bounded region");
  py::list all;
  const auto& components = region.components();
  if (components.size() == 1) {
    all.append(geometry("Polygon", polygon(components[0])));
  } else if (!components.empty()) {
    py::tuple polygons(components.size());
    for (std::size_t i = 0; i < components.size(); ++i) polygons[i] = polygon(components[i]);
    all.append(geometry("MultiPolygon", polygons));
  }
  for (const Segment& edge : edges)
    all.append(geometry("LineString", py::make_tuple(pair(edge.source), pair(edge.target))));
  for (const Point& p : points) all.append(geometry("Point", pair(p)));
  if (all.size() == 1) return all[0];
  py::dict collection;
  collection["type"] = "GeometryCollection";
  collection["geometries"] = py::tuple(all);
  return collection;
}

py::object to_shapely(const py::dict& geometry) {
  return py::module_::import("shapely.geometry").attr("shape")(geometry);
}

py::bytes bytes_of(const std::string& digits) {
  return py::module_::import("builtins").attr("bytes").attr("fromhex")(digits);
}

std::string name_of(Location location) {
  return location == Location::inside     ? "inside"
         : location == Location::boundary ? "boundary"
                                          : "outside";
}

}  // namespace oplus::python
