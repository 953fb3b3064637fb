// SPDX-License-Identifier: MIT
#include "checked/bindings/python/shapes.hpp"

#include <cstdint>
#include <cstring>
#include <string>

#include "checked/bindings/python/numbers.hpp"
#include "checked/bindings/python/unlocked.hpp"

namespace oplus::python {

namespace {

InvalidInput invalid(const std::string& wrong, const std::string& expected) {
  return InvalidInput({"geometry", 0, 0}, wrong, expected);
}

void open_ring(Chain& chain) {
  if (chain.size() > 1 && chain.front() == chain.back()) chain.pop_back();
}

bool is_list(py::handle value) {
  return py::isinstance<py::list>(value) || py::isinstance<py::tuple>(value);
}

Chain points_of(py::handle value) {
  Chain chain;
  if (py::isinstance<py::array>(value)) {
    const auto array = py::reinterpret_borrow<py::array>(value);
    // Fractions and ints of any size, say.
    if (array.dtype().kind() == 'O' && array.ndim() != 0) return points_of(array.attr("tolist")());
    const Points points(array);
    for (std::size_t i = 0; i < points.size(); ++i) chain.push_back(points[i]);
    return chain;
  }
  if (!PySequence_Check(value.ptr()) || PyUnicode_Check(value.ptr()))
    throw py::type_error("a chain of type " + type_of(value) + ": expected a list of points");
  for (const py::handle point : value) chain.push_back(point_of(point));
  return chain;
}

Chain ring_of(py::handle value) {
  Chain chain = points_of(value);
  open_ring(chain);
  return chain;
}

void add_polygon(py::handle rings, Region& region) {
  Component component;
  bool is_first = true;
  for (const py::handle ring : rings) {
    if (is_first)
      component.outer = ring_of(ring);
    else
      component.holes.push_back(ring_of(ring));
    is_first = false;
  }
  // An empty outer chain would stand for the plane.
  if (!is_first && component.outer.empty())
    throw invalid("a polygon without an outer ring", "at least 3 vertices");
  if (!is_first) region.components.push_back(std::move(component));
}

void add_line(py::handle points, Shapes& shapes) {
  auto& line = shapes.lines.emplace_back();
  for (const Point& p : points_of(points)) line.emplace_back(p);
}

/// A sum that is a closed set. Throws InvalidInput where it is more.
void require_closed(const ValidSet& sum) {
  if (sum.boundary() == Boundary::open &&
      !(sum.dangling_edges().empty() && sum.isolated_vertices().empty()))
    throw invalid("an open set with dangling edges or isolated vertices",
                  "a closed set, such as its region");
}

void add_region(const ValidRegion& region, Shapes& shapes) {
  for (const Component& component : region.components())
    shapes.region.components.push_back(component);
}

void add_sum(const ValidSet& sum, Shapes& shapes) {
  require_closed(sum);
  add_region(sum.region(), shapes);
  for (const Segment& edge : sum.dangling_edges())
    shapes.lines.push_back({edge.source, edge.target});
  for (const Point& p : sum.isolated_vertices()) shapes.points.emplace_back(p);
}

/// Returns its __geo_interface__, or nothing. Throws what that raises, but for AttributeError.
py::object geo_interface_of(py::handle value) {
  PyObject* const result = PyObject_GetAttrString(value.ptr(), "__geo_interface__");
  if (result == nullptr) {
    if (PyErr_ExceptionMatches(PyExc_AttributeError) == 0) throw py::error_already_set();
    PyErr_Clear();
  }
  return py::reinterpret_steal<py::object>(result);
}

/// level: how many objects it is inside of, which may contain themselves.
void add_geometry(py::handle value, Shapes& shapes, int level = 0) {
  if (level == 64)
    throw invalid("a geometry inside of 64 others", "less, and none that contains itself");
  if (value.is_none()) return;
  // Exactly, not by the doubles of __geo_interface__.
  if (py::isinstance<PreparedRegion>(value))
    return add_region(value.cast<const PreparedRegion&>().region(), shapes);
  if (py::isinstance<ValidSet>(value)) return add_sum(value.cast<const ValidSet&>(), shapes);
  if (!py::isinstance<py::dict>(value)) {
    const py::object geometry = geo_interface_of(value);
    if (!geometry)
      throw py::type_error("a geometry of type " + type_of(value) + ": expected a dictionary");
    return add_geometry(geometry, shapes, level + 1);
  }
  const auto geometry = py::reinterpret_borrow<py::dict>(value);
  const auto member = [&](const char* name) -> py::object {
    if (!geometry.contains(name))
      throw invalid("it has no \"" + std::string(name) + '"', "a GeoJSON object");
    return geometry[name];
  };
  const auto type = text_of(py::str(member("type")));
  if (type == "Feature") return add_geometry(member("geometry"), shapes, level + 1);
  if (type == "FeatureCollection" || type == "GeometryCollection") {
    for (const py::handle one : member(type == "FeatureCollection" ? "features" : "geometries"))
      add_geometry(one, shapes, level + 1);
    return;
  }
  if (type == "Polygon") {
    add_polygon(member("coordinates"), shapes.region);
  } else if (type == "MultiPolygon") {
    for (const py::handle polygon : member("coordinates")) add_polygon(polygon, shapes.region);
  } else if (type == "LineString" || type == "LinearRing") {
    add_line(member("coordinates"), shapes);
  } else if (type == "MultiLineString") {
    for (const py::handle line : member("coordinates")) add_line(line, shapes);
  } else if (type == "Point") {
    const py::object point = member("coordinates");
    if (py::len(point) != 0) shapes.points.emplace_back(point_of(point));
  } else if (type == "MultiPoint") {
    for (const py::handle point : member("coordinates"))
      shapes.points.emplace_back(point_of(point));
  } else {
    throw invalid("its type is " + text_of(py::repr(member("type"))), "one of GeoJSON");
  }
}

constexpr const char* expected_lists = "a ring of points, a list of rings or a list of these";

/// Returns how many lists are around the first number: 2 for a ring. 0 for an empty list. level: how many
/// lists it is inside of. Throws InvalidInput for too many: a list may contain itself.
int depth(py::handle value, int level = 0) {
  if (py::isinstance<py::array>(value))
    return static_cast<int>(py::reinterpret_borrow<py::array>(value).ndim());
  if (!is_list(value)) {
    if (is_number(value)) return 0;
    throw py::type_error("a geometry of type " + type_of(value) +
                         ": expected a Region, text, bytes, an object with __geo_interface__, "
                         "lists of coordinates or an array");
  }
  const auto list = py::reinterpret_borrow<py::sequence>(value);
  if (list.size() == 0) return 0;
  if (level == 5) throw invalid("coordinates in more than 5 lists", expected_lists);
  return 1 + depth(py::object(list[0]), level + 1);
}

ValidSet planar_set(const Shapes& shapes) {
  return ValidSet(ValidRegion(shapes.region), shapes.lines, shapes.points);
}

bool has_more_than_region(const ValidSet& sum) {
  return !sum.dangling_edges().empty() || !sum.isolated_vertices().empty();
}

}  // namespace

Points::Points(const py::array& array) {
  const char kind = array.dtype().kind();
  const py::ssize_t bytes = array.dtype().itemsize();
  is_float_ = kind == 'f';
  if (is_float_ && bytes <= 8)
    array_ = array_of<py::array_t<double, py::array::forcecast>>(array, "geometry", "float64");
  else if ((kind == 'i' && bytes <= 8) || (kind == 'u' && bytes < 8))
    array_ = array_of<py::array_t<std::int64_t, py::array::forcecast>>(array, "geometry", "int64");
  else
    throw py::type_error(
        "an array of " + py::str(array.dtype()).cast<std::string>() +
        ": expected floats or signed integers of at most 64 bits, or unsigned ones of at most 32");
  if (array_.ndim() != 2 || array_.shape(1) != 2)
    throw invalid("an array of another shape than points", "shape (n, 2)");
  data_ = static_cast<const char*>(array_.data());
  by_row_ = array_.strides(0);
  by_column_ = array_.strides(1);
  size_ = static_cast<std::size_t>(array_.shape(0));
}

Point Points::operator[](std::size_t i) const {
  const char* const x = data_ + static_cast<py::ssize_t>(i) * by_row_;
  const auto number = [&](const char* at) -> Number {
    if (is_float_) {
      double value = 0;
      std::memcpy(&value, at, sizeof value);
      return value;
    }
    std::int64_t value = 0;
    std::memcpy(&value, at, sizeof value);
    return value;
  };
  return {number(x).value(), number(x + by_column_).value()};
}

Chain Points::chain(std::size_t begin, std::size_t end) const {
  Chain chain;
  chain.reserve(end - begin);
  for (std::size_t i = begin; i < end; ++i) chain.push_back((*this)[i]);
  open_ring(chain);
  return chain;
}

bool is_single(py::handle value) { return !is_list(value) && !py::isinstance<py::array>(value); }

Shapes shapes_of(py::handle value) {
  Shapes shapes;
  if (py::isinstance<py::dict>(value)) {
    add_geometry(value, shapes);
    return shapes;
  }
  if (is_single(value)) {
    if (const py::object geometry = geo_interface_of(value)) {
      add_geometry(geometry, shapes, 1);
      return shapes;
    }
  }
  const int lists = depth(value);
  if (lists == 2) {
    shapes.region.components.push_back({ring_of(value), {}});
    if (shapes.region.components[0].outer.empty()) shapes.region.components.clear();
  } else if (lists == 3) {
    add_polygon(value, shapes.region);
  } else if (lists == 4) {
    for (const py::handle polygon : value) add_polygon(polygon, shapes.region);
  } else if (!is_list(value) || py::len(value) != 0) {
    throw invalid("coordinates in " + std::to_string(lists) + " lists", expected_lists);
  }
  return shapes;
}

PreparedRegion region_of(py::handle value) {
  if (py::isinstance<PreparedRegion>(value)) return value.cast<PreparedRegion>();
  if (py::isinstance<ValidSet>(value)) {
    const ValidSet sum = value.cast<ValidSet>();
    if (has_more_than_region(sum))
      throw invalid("a set with dangling edges or isolated vertices",
                    "a region, such as its region");
    return sum.region();
  }
  if (is_text(value)) {
    const std::string text = text_of(value);
    const Unlocked released;
    return read_text(text);
  }
  Shapes shapes = shapes_of(value);
  if (!shapes.lines.empty() || !shapes.points.empty())
    throw invalid("line strings or points", "polygons");
  const Unlocked released;
  return ValidRegion(std::move(shapes.region));
}

ValidSet planar_set_of(py::handle value) {
  if (py::isinstance<ValidSet>(value)) return value.cast<ValidSet>();
  if (py::isinstance<PreparedRegion>(value)) return value.cast<const PreparedRegion&>().region();
  if (is_text(value)) {
    const std::string text = text_of(value);
    const Unlocked released;
    return read_set(text);
  }
  const Shapes shapes = shapes_of(value);
  const Unlocked released;
  return planar_set(shapes);
}

Set set_of(py::handle value) {
  if (py::isinstance<ValidSet>(value)) {
    const ValidSet set = value.cast<ValidSet>();
    if (has_more_than_region(set)) return set;
    return PreparedRegion(set.region());
  }
  if (is_text(value)) {
    try {
      return region_of(value);
    } catch (const InvalidInput&) {
      return planar_set_of(value);  // or says what is wrong with it as a set
    }
  }
  if (!py::isinstance<PreparedRegion>(value)) {
    Shapes shapes = shapes_of(value);
    const Unlocked released;
    if (!shapes.lines.empty() || !shapes.points.empty()) return planar_set(shapes);
    return PreparedRegion(ValidRegion(std::move(shapes.region)));
  }
  return region_of(value);
}

}  // namespace oplus::python
