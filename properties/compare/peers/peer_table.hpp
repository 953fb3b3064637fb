// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "properties/compare/peers/method.hpp"

namespace oplus {

/// Methods as functions: what each returns for a pair. They throw Unsupported, and may crash or throw
/// anything else, as the library does.
using MethodFunction = ReturnedChains(const Summands& pair);
MethodFunction cgal_reduced, cgal_full, cgal_vertical, cgal_triangulation, cgal_small_side,
    cgal_optimal, cgal_hertel_mehlhorn, cgal_greene, clipper, boost_polygon;

/// Lists the methods of other libraries that oplus has an adapter for, all of them for closed sums
/// only: calls `row(name, what, method)`. A method is linked only where it is called:
/// `oplus-check` needs the names and not the libraries.
template <typename Row>
void for_each_peer(Row row) {
  row("cgal-reduced", "CGAL's reduced convolution; one component, holes",
      [](const auto& pair) { return cgal_reduced(pair); });
  row("cgal-full", "CGAL's full convolution; one component, no holes",
      [](const auto& pair) { return cgal_full(pair); });
  row("cgal-vertical", "CGAL, by vertical decomposition; one component, holes",
      [](const auto& pair) { return cgal_vertical(pair); });
  row("cgal-triangulation", "CGAL, by triangulation; one component, holes",
      [](const auto& pair) { return cgal_triangulation(pair); });
  row("cgal-small-side", "CGAL, by small side angle bisectors; one component, no holes",
      [](const auto& pair) { return cgal_small_side(pair); });
  row("cgal-optimal", "CGAL, by optimal convex decomposition; one component, no holes",
      [](const auto& pair) { return cgal_optimal(pair); });
  row("cgal-hertel-mehlhorn",
      "CGAL, by Hertel and Mehlhorn's decomposition; one component, no holes",
      [](const auto& pair) { return cgal_hertel_mehlhorn(pair); });
  row("cgal-greene", "CGAL, by Greene's decomposition; one component, no holes",
      [](const auto& pair) { return cgal_greene(pair); });
  row("clipper",
      "Clipper 6, filled by the larger summand; one component, holes in the larger summand; rounds",
      [](const auto& pair) { return clipper(pair); });
  row("boost-polygon", "Boost.Polygon's convolution of polygon sets; any region; rounds",
      [](const auto& pair) { return boost_polygon(pair); });
}

/// Exit codes by which `oplus-peer` and other programs say why they return no sum. For
/// 77 see the manual of GNU Automake, for 65 sysexits.h.
inline constexpr int exit_refused = 77;    ///< it does not support such a pair
inline constexpr int exit_no_region = 65;  ///< its result is not the boundary of a region

}  // namespace oplus
