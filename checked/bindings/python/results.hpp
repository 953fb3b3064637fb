// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

/// @file
/// The classes of the module.
namespace oplus::python {

namespace py = pybind11;

/// Defines Region.
void define_regions(py::module_& module);

/// Defines Placements, and the functions of its answers.
void define_distances(py::module_& module);

/// Defines PlanarSet, Rounded, Reason and Verdict.
void define_results(py::module_& module);

}  // namespace oplus::python
