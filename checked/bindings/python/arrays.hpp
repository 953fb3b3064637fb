// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <cstddef>
#include <cstdint>
#include <oplus/oplus.hpp>
#include <vector>

#include "checked/bindings/python/shapes.hpp"

/// @file
/// Many regions in a few arrays.
namespace oplus::python {

/// Imports the type Arrays of the package: (coordinates, rings, polygons, regions). Ring i has the points
/// coordinates[rings[i]:rings[i + 1]]; polygon i the rings rings[polygons[i]:polygons[i + 1]], the outer one first;
/// region i the polygons likewise. To be called when the module is made.
void prepare_arrays();

/// Whether it is an object of that type.
bool is_arrays(py::handle value);

/// Arrays, checked: each ring, polygon and region exists.
class RegionArrays {
 public:
  /// polygons None: each ring is one; regions None: each polygon is one. Throws InvalidInput.
  RegionArrays(const py::array& coordinates, py::handle rings, py::handle polygons,
               py::handle regions);

  /// The same of an object of type Arrays. Throws likewise.
  explicit RegionArrays(py::handle arrays);

  std::size_t size() const { return regions_.size() - 1; }  ///< Returns the number of regions.

  /// Returns a region, not yet checked. Needs no lock. Throws InvalidInput for an infinity and what is not a
  /// number.
  Region operator[](std::size_t i) const;

 private:
  Points points_;
  std::vector<std::size_t> rings_, polygons_, regions_;
};

/// Arrays that are being made, each coordinate the nearest double. Rings are open.
class NewArrays {
 public:
  /// Adds a region. Throws InvalidInput for an unbounded one.
  void add(const ValidRegion& region);

  /// Returns an object of type Arrays, without a copy.
  py::object take() &&;

 private:
  void add(const Chain& chain);

  std::vector<double> coordinates_;
  std::vector<std::int64_t> rings_{0}, polygons_{0}, regions_{0};
};

}  // namespace oplus::python
