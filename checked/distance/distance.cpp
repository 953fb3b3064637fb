// SPDX-License-Identifier: MIT
#include "checked/distance/distance.hpp"

#include "checked/collision/collision_test.hpp"
#include "checked/collision/summand_boundary.hpp"
#include "checked/distance/nearest_segments.hpp"
#include "checked/distance/ways_out.hpp"
#include "checked/slide/slide.hpp"
#include "reference/chains/frame.hpp"
#include "reference/definitions/contract.hpp"
#include "reference/definitions/exact_box.hpp"
#include "reference/definitions/mutant.hpp"
#include "reference/definitions/region.hpp"
#include "reference/definitions/unbounded.hpp"

namespace oplus {

namespace {

/// A vertex of a chain of one region that is in the other one; of each chain, one is tried. Where the boundaries
/// don't meet, there is one iff the regions meet, unless both are the plane.
std::optional<Point> vertex_inside(const Region& region, const SegmentTree& boundary,
                                   const Region& other) {
  for (const Chain& chain : chains(other)) {
    if (chain.empty()) continue;
    // A vertex on the boundary may be told to be inside, which is right, or not, and is found by its edges.
    const std::optional<Crossing> first = first_to_the_right(chain[0], boundary);
    if (first ? first->runs_up : is_unbounded(region)) return chain[0];
  }
  return std::nullopt;
}

/// With the edges of both.
NearestPoints nearest_points(const Region& p, const SegmentTree& of_p, const Region& q,
                             const SegmentTree& of_q) {
  std::optional<Point> common = vertex_inside(p, of_p, q);
  if (!common) common = vertex_inside(q, of_q, p);
  if (of_p.empty() && of_q.empty()) common = Point{};
  if (common &&
      !OPLUS_MUTANT("distances-from-boundaries",
                    "the distance of regions, one inside the other, is that of their boundaries"))
    return {0, *common, *common};
  return nearest_points(of_p, of_q);
}

std::optional<Overlap> depth_of_bounded(const Region& p, const Region& q) {
  const SummandBoundary of_p(p), of_q(q);
  if (!interiors_meet(of_p, of_q, {})) return std::nullopt;
  return way_out(of_p.pieces, of_q.pieces, {}, nearest_boundary(p, reflected(q)));
}

}  // namespace

NearestPoints distance(const Region& p, const Region& q) {
  OPLUS_REQUIRES(!p.components.empty() && !q.components.empty(), "distance");
  return nearest_points(p, edges(p), q, edges(q));
}

std::optional<Overlap> depth(const Region& p, const Region& q) {
  if (p.components.empty() || q.components.empty()) return std::nullopt;
  const bool is_framed = is_unbounded(p) || is_unbounded(q);
  if (!is_framed) return depth_of_bounded(p, q);
  const std::vector<Segment> of_p = edges(p), of_q = edges(q);
  if ((is_unbounded(p) && is_unbounded(q)) || of_p.empty() || of_q.empty()) refuse_to_part();
  // Q touches P only where it is moved to a place in the sum of the boxes around the boundaries of P and -Q. The frame
  // is so far away that it contains both, and that the frame of the no-fit polygon is further away than these places.
  const ExactBox box_p = box_around(of_p), box_q = box_around(of_q);
  const Vector low = box_p.low - box_q.high, high = box_p.high - box_q.low;
  const Rational margin = 1 + 2 * Rational(abs(low.x) + abs(low.y) + abs(high.x) + abs(high.y));
  std::optional<Overlap> overlap = depth_of_bounded(framed(p, margin), framed(q, margin));
  if (!overlap) return std::nullopt;
  const Vector& x = overlap->move;
  if (x.x < low.x || x.x > high.x || x.y < low.y || x.y > high.y) refuse_to_part();
  return overlap;
}

}  // namespace oplus
