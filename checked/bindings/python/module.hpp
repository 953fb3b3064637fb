// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

#include <oplus/oplus.hpp>
#include <string>

/// @file
/// What the module _oplus is made of. The package's Python has the names, defaults and docstrings of all this.
namespace oplus::python {

namespace py = pybind11;

/// Returns Boundary::closed or Boundary::open. Throws std::invalid_argument for another name.
Boundary boundary_of(const std::string& name);

/// Defines Region, PlanarSet, and functions of one of them.
void define_sets(py::module_& module);

/// Defines Placements, distance and depth.
void define_distances(py::module_& module);

/// Defines batch, from_arrays and to_arrays.
void define_batch(py::module_& module);

}  // namespace oplus::python
