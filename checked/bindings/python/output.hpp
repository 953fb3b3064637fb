// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

#include <oplus/oplus.hpp>
#include <string>
#include <vector>

/// @file
/// Regions and sums as Python's values.
namespace oplus::python {

namespace py = pybind11;

/// Returns a list of pairs (outer, holes), chains lists of pairs of Fractions.
py::list components_of(const std::vector<Component>& components);

/// Returns a list of pairs of points.
py::list edges_of(const std::vector<Segment>& edges);

/// Returns a list of pairs of Fractions.
py::list points_of(const std::vector<Point>& points);

/// Returns "inside", "boundary" or "outside".
std::string name_of(Location location);

/// Returns an oplus.InvalidInput. `message`, `place` and `index` say which of many it is about.
py::object error_of(const InvalidInput& error, const std::string& message, const std::string& place,
                    const py::object& index);

}  // namespace oplus::python
