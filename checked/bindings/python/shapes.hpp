// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <cstddef>
#include <oplus/oplus.hpp>
#include <utility>
#include <variant>
#include <vector>

#include "checked/bindings/python/instances.hpp"

/// @file
/// What functions take for a region or a set: objects of Python, of many types.
namespace oplus::python {

namespace py = pybind11;

/// Polygons, polylines and points as they were given; nothing is checked.
struct Shapes {
  Region region;                                ///< a last vertex equal to the first is left out
  std::vector<std::vector<Coordinates>> lines;  ///< each in its order
  std::vector<Coordinates> points;              ///< in their order
};

/// Returns an array, converted if need be. Throws InvalidInput, which is about `name`, where it is none or
/// values of it are masked.
template <typename Array = py::array>
Array array_of(py::handle value, const char* name, const char* expected) {
  if (py::hasattr(value, "mask") &&
      py::bool_(py::module_::import("numpy.ma").attr("is_masked")(value)))
    throw InvalidInput({name, 0, 0}, "values are masked", "an array without");
  Array array = Array::ensure(value);
  if (!array) throw InvalidInput({name, 0, 0}, "not an array", expected);
  return array;
}

/// A summand. Regions keep what depends on them alone.
using Set = std::variant<PreparedRegion, ValidSet>;

/// Coordinates in an array of shape (n, 2), of float or int64; what is of another type is
/// converted, exactly. Arrays of these types are not copied.
class Points {
 public:
  /// Throws InvalidInput for another shape, py::type_error for other numbers.
  explicit Points(const py::array& array);

  std::size_t size() const { return size_; }  ///< Returns the number of points.

  /// Returns a point. Needs no lock. Throws InvalidInput for an infinity and what is not a number.
  Point operator[](std::size_t i) const;

  /// Returns the chain of points from `begin` to `end`, the last one left out if it equals the first.
  Chain chain(std::size_t begin, std::size_t end) const;

 private:
  py::array array_;
  const char* data_;
  py::ssize_t by_row_, by_column_;
  std::size_t size_;
  bool is_float_;
};

/// Whether functions take it for one region, not for a sequence of them: all but a list, a tuple or an array.
bool is_single(py::handle value);

/// Returns the shapes of a geometry with __geo_interface__, such a dictionary, lists of coordinates or an
/// array. Throws InvalidInput and py::type_error.
Shapes shapes_of(py::handle value);

/// Returns the region of any of these, or of a Region, a PlanarSet without edges and points of its own, text in any
/// format that oplus reads, bytes of WKB. Throws InvalidInput and py::type_error.
PreparedRegion region_of(py::handle value);

/// The same where line strings and points are allowed too.
Set set_of(py::handle value);

/// Returns a set of the same, also of line strings and points.
ValidSet planar_set_of(py::handle value);

}  // namespace oplus::python
