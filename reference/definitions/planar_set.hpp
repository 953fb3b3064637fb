// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "reference/definitions/convolution.hpp"
#include "reference/definitions/region.hpp"

namespace oplus {

/// The parts of a sum's boundary in no particular order, as an algorithm finds them.
struct BoundaryFeatures {
  /// The regularized boundary, the sum to the left; they meet at common ends only.
  std::vector<Segment> edges;
  std::vector<Segment> dangling_edges;
  std::vector<Point> isolated_vertices;
};

/// Where the rotation of a chain starts that is lexicographically smallest: at a smallest vertex.
std::size_t start_of_smallest_rotation(const Chain& chain);

/// Brings features into canonical form.
/// Requires: as many edges enter each point as leave it.
PlanarSet canonical_sum(const BoundaryFeatures& features);

/// The closure of a set's interior: the set without dangling edges and isolated vertices.
PlanarSet regularized(PlanarSet set);

/// The area of the regularized sum.
Rational area(const PlanarSet& sum);

/// All edges of a sum: of the outer chains, of the holes, then the dangling ones.
std::vector<Segment> edges(const PlanarSet& sum);

/// The origins of the edges of a sum, in the order of `edges(sum)`.
Origins origins(const PlanarSet& sum, const std::vector<ConvolutionSegment>& reduced);

}  // namespace oplus
