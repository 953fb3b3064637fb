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

/// Returns a GeoJSON geometry, each coordinate the nearest double. Throws InvalidInput where the region is
/// unbounded.
py::dict geo_interface(const ValidRegion& region, const std::vector<Segment>& edges,
                       const std::vector<Point>& points);

/// Returns Shapely's geometry of the same. Throws py::error_already_set where Shapely is not installed.
py::object to_shapely(const py::dict& geometry);

/// Returns the bytes of hexadecimal digits.
py::bytes bytes_of(const std::string& digits);

/// Returns "inside", "boundary" or "outside".
std::string name_of(Location location);

}  // namespace oplus::python
