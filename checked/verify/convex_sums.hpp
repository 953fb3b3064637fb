// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include "reference/definitions/region.hpp"

namespace oplus {

/// The sum of two regions as the union of sums of convex parts. P and Q are cut into convex parts T and
/// U (summand_parts.hpp). The interiors of P and -Q+x meet iff those of some T and -U+x do: they are
/// open, and the interiors of the parts are dense in them. So the open sum is the union of all open
/// T ⊕ U, each a convex polygon, which a line meets in one open interval.
class ConvexSums {
 public:
  /// Requires: p and q are valid (validity.hpp).
  ConvexSums(const Region& p, const Region& q);
  ~ConvexSums();

  /// A candidate for the boundary: the sum of an edge of one summand and a vertex of the other, both by their
  /// numbers in `edges` of that summand; the vertex is the source of its edge.
  struct EdgeAtVertex {
    Summand edge_of;
    std::size_t edge;
    std::size_t vertex;
  };

  /// The segments of the reduced convolution (thesis, Definition 2.3.1), by binary search among the
  /// edges in the order of their directions; those of a vertex in the order of the edges. Of equal ones of small
  /// integers, one.
  /// O((n + m) log(n + m)), and O(log(n + m)) for each.
  std::vector<EdgeAtVertex> reduced_convolution() const;

  Segment segment(const EdgeAtVertex& candidate) const;

  /// The parts of a segment that are on the boundary of the closed sum: with the sum to the left,
  /// which is always so, and not to the right.
  std::vector<Segment> boundary_parts(const EdgeAtVertex& candidate);

  /// The parts of a segment outside the open sum: of the boundary, and with the sum on both sides. A
  /// part of those may be a point.
  struct Outside {
    std::vector<Segment> boundary;
    std::vector<Segment> inside_closed_sum;
    std::vector<Point> points;
  };
  Outside outside_parts(const EdgeAtVertex& candidate);

  /// Whether the source of a segment is outside the open sum.
  bool source_is_outside(const EdgeAtVertex& candidate);

 private:
  class Search;
  std::unique_ptr<Search> search_;
};

}  // namespace oplus
