// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "checked/arrangement/convolution_arrangement.hpp"
#include "checked/engine.hpp"

namespace oplus {

/// Whether the face to the right of a halfedge is in the complement.
using IsHoleRightOf = std::function<bool(ConvolutionArrangement::Halfedge)>;

/// What the methods on an arrangement differ in.
struct ArrangementMethod {
  /// The segments that are arranged: the convolution or the reduced one.
  std::vector<ConvolutionSegment> (*convolution)(const Region& p, const Region& q);

  /// Returns the halfedges of the regularized boundary, the sum to their left.
  std::vector<ConvolutionArrangement::Halfedge> (*boundary)(const ConvolutionArrangement&,
                                                            const IsHoleRightOf&);

  /// Whether `boundary` asks: then the hole test is prepared at once, which is a stage of its own.
  /// Otherwise it is prepared where a point is asked about, as most sums have none.
  bool has_hole_test;
};

/// Runs the stages that they have in common (thesis, Section 6.2.1): hole test, convolution,
/// arrangement, regularized boundary, low-dimensional features, canonical form.
ComputedSum sum_on_arrangement(const Region& p, const Region& q, Boundary boundary,
                               const EngineOptions& options, const ArrangementMethod& method);

}  // namespace oplus
