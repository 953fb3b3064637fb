// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "checked/arrangement/convolution_arrangement.hpp"
#include "checked/computed_sum.hpp"

namespace oplus {

/// What the methods on an arrangement differ in.
struct ArrangementMethod {
  std::function<std::vector<ConvolutionSegment>()> convolution;

  /// The halfedges of the regularized boundary, the sum to their left.
  std::function<std::vector<ConvolutionArrangement::Halfedge>(const ConvolutionArrangement&,
                                                              RunStatistics&)>
      boundary;

  /// Whether a point is in the sum of the open regions.
  std::function<bool(const Point&)> interiors_meet_at;
};

/// Runs the stages that they have in common (thesis, Section 6.2.1): convolution, arrangement,
/// regularized boundary, low-dimensional features, canonical form.
ComputedSum sum_on_arrangement(const Region& p, const Region& q, Boundary boundary,
                               WithOrigins with_origins, const ArrangementMethod& method);

}  // namespace oplus
