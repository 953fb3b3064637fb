// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

#include "properties/compare/peers/method.hpp"

namespace oplus {

/// A method as functions. They throw Unsupported, and may crash or throw anything else, as the library does.
struct Peer {
  /// What it returns for a pair.
  std::function<ReturnedChains(const Summands& pair)> sum;

  /// Writes all no-fit polygons P ⊕ −Q of the parts P and Q, each with itself too, P by P, as the library returns
  /// them: nothing is checked. The first line is the number by which coordinates are multiplied; each other one is a
  /// no-fit polygon, as SVG path data. Each part is converted once.
  std::function<void(const std::vector<Region>& parts, std::ostream& out)> no_fit_polygons;
};

using MakePeer = Peer();
MakePeer cgal_reduced, cgal_full, cgal_vertical, cgal_triangulation, cgal_small_side, cgal_optimal,
    cgal_hertel_mehlhorn, cgal_greene, clipper, clipper2, boost_polygon;

/// Lists the methods of other libraries that oplus has an adapter for, all of them for closed sums
/// only: calls `row(name, what, make)`. A method is linked only where `make` is called:
/// `oplus-check` needs the names and not the libraries.
template <typename Row>
void for_each_peer(Row row) {
  row("cgal-reduced", "CGAL's reduced convolution; one component, holes",
      [] { return cgal_reduced(); });
  row("cgal-full", "CGAL's full convolution; one component, no holes", [] { return cgal_full(); });
  row("cgal-vertical", "CGAL, by vertical decomposition; one component, holes",
      [] { return cgal_vertical(); });
  row("cgal-triangulation", "CGAL, by triangulation; one component, holes",
      [] { return cgal_triangulation(); });
  row("cgal-small-side", "CGAL, by small side angle bisectors; one component, no holes",
      [] { return cgal_small_side(); });
  row("cgal-optimal", "CGAL, by optimal convex decomposition; one component, no holes",
      [] { return cgal_optimal(); });
  row("cgal-hertel-mehlhorn",
      "CGAL, by Hertel and Mehlhorn's decomposition; one component, no holes",
      [] { return cgal_hertel_mehlhorn(); });
  row("cgal-greene", "CGAL, by Greene's decomposition; one component, no holes",
      [] { return cgal_greene(); });
  row("clipper",
      "Clipper 6, filled by the larger summand; one component, holes in the larger summand; rounds",
      [] { return clipper(); });
#ifdef OPLUS_CLIPPER2
  row("clipper2",
      "Clipper2, filled by the larger summand; one component, holes in the larger summand; rounds",
      [] { return clipper2(); });
#endif
  row("boost-polygon", "Boost.Polygon's convolution of polygon sets; any region; rounds",
      [] { return boost_polygon(); });
}

/// The versions of the libraries that the methods are of, and of the compiler.
std::string libraries_of_peers();

/// Exit codes by which `oplus-peer` and other programs say why they return no sum. For
/// 77 see the manual of GNU Automake, for 65 sysexits.h.
inline constexpr int exit_refused = 77;    ///< it does not support such a pair
inline constexpr int exit_no_region = 65;  ///< its result is not the boundary of a region

}  // namespace oplus
