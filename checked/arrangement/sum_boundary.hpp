// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "checked/arrangement/convolution_arrangement.hpp"
#include "reference/definitions/planar_set.hpp"

namespace oplus {

/// Which parts of a convolution's arrangement are the boundary of the sum.
struct SumBoundary {
  std::vector<ConvolutionArrangement::Halfedge> edges;     ///< the sum to their left
  std::vector<ConvolutionArrangement::Halfedge> dangling;  ///< either halfedge of each
  std::vector<Point> isolated_vertices;
};

/// Adds the low-dimensional features of the open sum (thesis, Section 3.2.4): what passes the
/// filters of Theorems 3.2.8 and 3.2.10 and is found by `interiors_meet_at` not to be in the sum.
/// Requires: boundary.edges is complete.
void add_low_dimensional_features(const ConvolutionArrangement& arrangement, const Region& p,
                                  const Region& q,
                                  const std::function<bool(const Point&)>& interiors_meet_at,
                                  SumBoundary& boundary);

PlanarSet sum_within(const ConvolutionArrangement& arrangement, const SumBoundary& boundary);

/// The origins of edges(sum), those of the reduced convolution only.
/// Requires: sum = sum_within(arrangement, boundary).
Origins origins_of(const PlanarSet& sum, const ConvolutionArrangement& arrangement,
                   const SumBoundary& boundary);

}  // namespace oplus
