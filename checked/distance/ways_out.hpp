// SPDX-License-Identifier: MIT
#pragma once

#include "checked/collision/segment_tree.hpp"
#include "checked/distance/nearest_points.hpp"
#include "reference/definitions/values.hpp"

namespace oplus {

/// The shortest moves after which a region Q only touches a region P, from many places of Q.
class WaysOut {
 public:
  /// Takes the edges of both; `no_fit` is the no-fit polygon of the two (operations.hpp). Cost: O(n log n) for all
  /// edges.
  WaysOut(SegmentTree p, SegmentTree q, const PlanarSet& no_fit);

  /// Of Q + x: to the point of the no-fit polygon's boundary, its dangling edges and isolated vertices that is nearest
  /// to x. If x is not in the no-fit polygon, the squared depth is the squared distance of P and Q + x. Exact;
  /// near-logarithmic by experience. Throws InvalidInput where there is no such point: the no-fit polygon is the plane.
  Overlap from(const Vector& x) const;

 private:
  SegmentTree p_, q_, boundary_;
};

/// A way out of an overlap, from where Q is, to the nearest of some parts of the boundary of the no-fit polygon.
/// Requires: the regions touch after that move. Throws InvalidInput where there is no such part.
Overlap way_out(const SegmentTree& p, const SegmentTree& q, const Vector& from,
                const SegmentTree& boundary);

/// Throws InvalidInput: Q overlaps P wherever it is moved to.
[[noreturn]] void refuse_to_part();

}  // namespace oplus
