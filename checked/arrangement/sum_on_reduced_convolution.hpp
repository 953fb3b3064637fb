// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "checked/arrangement/convolution_arrangement.hpp"
#include "checked/arrangement/hole_test.hpp"
#include "checked/computed_sum.hpp"

namespace oplus {

/// Whether the face to the right of a halfedge is in the complement.
using IsHoleRightOf = std::function<bool(ConvolutionArrangement::Halfedge)>;

/// Finds the halfedges of the regularized boundary, the sum to their left.
using FindBoundary = std::function<std::vector<ConvolutionArrangement::Halfedge>(
    const ConvolutionArrangement&, const IsHoleRightOf&)>;

/// The frame of the methods on the arrangement of the reduced convolution (thesis, Chapter 3).
ComputedSum sum_on_reduced_convolution(const Region& p, const Region& q, Boundary boundary,
                                       WithOrigins with_origins, HoleTest& hole_test,
                                       const FindBoundary& find_boundary);

/// Prepares a hole test and computes with it, the first counted as a stage of its own.
ComputedSum with_hole_test(const Region& p, const Region& q, HoleTestMethod method,
                           const std::function<ComputedSum(HoleTest&)>& compute);

}  // namespace oplus
