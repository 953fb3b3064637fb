// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "reference/definitions/convolution.hpp"
#include "reference/definitions/region.hpp"

namespace oplus {

/// closed: the regularized sum of the closed regions. open: the sum of their interiors, an open set
/// whose complement may have dangling edges and isolated vertices (thesis, Section 3.2.4).
enum class Boundary { closed, open };

/// A Minkowski sum as a value, in one canonical form, so that equal sums are ==:
///  1. each chain is a part of the boundary of one face of the complement, the sum to its left, and
///     turns clockwise most at a vertex it meets more than once (thesis, Definition 3.2.1);
///  2. it starts at its lexicographically smallest vertex and has no vertex inside a straight line;
///  3. `outer` chains are counterclockwise, `holes` clockwise; both are sorted;
///  4. dangling edges are maximal, directed from their smaller end, and sorted; so are isolated
///     vertices. Both are empty for Boundary::closed.
struct MinkowskiSum {
  std::vector<Chain> outer;
  std::vector<Chain> holes;
  std::vector<Segment> dangling_edges;
  std::vector<Point> isolated_vertices;

  friend bool operator==(const MinkowskiSum&, const MinkowskiSum&) = default;
};

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
MinkowskiSum canonical_sum(const BoundaryFeatures& features);

/// The sum that is just this valid region: its chains in canonical form.
MinkowskiSum canonical_sum(const Region& region);

/// The regularized sum as a region (thesis, Definition 2.1.17): chains that touch themselves are
/// taken apart into simple ones, and each hole goes to the outer chain directly around it.
Region region_of(const MinkowskiSum& sum);

/// The area of the regularized sum.
Rational area(const MinkowskiSum& sum);

/// All edges of a sum: of the outer chains, of the holes, then the dangling ones.
std::vector<Segment> edges(const MinkowskiSum& sum);

/// For each of `edges(sum)`, sorted, the reduced convolution segments that run along it: those
/// that share more than a point with it and have its direction (for a dangling edge, either).
using Origins = std::vector<std::vector<Origin>>;
Origins origins(const MinkowskiSum& sum, const std::vector<ConvolutionSegment>& reduced);

}  // namespace oplus
