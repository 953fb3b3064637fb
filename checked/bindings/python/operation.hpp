// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

#include <oplus/oplus.hpp>
#include <string>

/// @file
/// The operations on two regions, one at a time and many at once.
namespace oplus::python {

namespace py = pybind11;

/// Returns Boundary::closed or Boundary::open. Throws std::invalid_argument for another name.
Boundary boundary_of(const std::string& name);

/// Defines batch, from_arrays and to_arrays.
void define_batch(py::module_& module);

}  // namespace oplus::python
