// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "checked/engine.hpp"
#include "checked/slide/prepared_summand.hpp"

namespace oplus {

/// Computes P ⊕ Q from the reduced convolution without an arrangement: docs/slide.md.
/// Neither the sum nor the statistics depend on the number of threads.
/// Requires: p and q are valid (validity.hpp).
ComputedSum slide_sum(const Region& p, const Region& q, Boundary boundary,
                      const EngineOptions& options = {});

/// The same of summands that belong to many pairs: what depends on one of them alone is computed once.
ComputedSum sum_of_prepared(const slide::PreparedSummand& p, const slide::PreparedSummand& q,
                            Boundary boundary, const EngineOptions& options = {});

/// Returns parts of the boundary of the open sum of P and Q, its dangling edges, and its isolated vertices as segments
/// from a point to itself: among them what is nearest to the origin. Empty where there is no such point. No more is
/// searched than is near: segments of the reduced convolution in the order of their distances, and of these none that
/// is in cells which are covered by pairs of edges that cross. Requires: the origin is in the open sum; p and q are
/// valid and bounded.
std::vector<Segment> nearest_boundary(const Region& p, const Region& q);

}  // namespace oplus
