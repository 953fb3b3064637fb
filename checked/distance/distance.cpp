// SPDX-License-Identifier: MIT
#include "checked/distance/distance.hpp"

#include <utility>

#include "checked/distance/nearest_segments.hpp"
#include "checked/distance/ways_out.hpp"
#include "checked/operations/operations.hpp"
#include "checked/slide/slide.hpp"
#include "reference/definitions/contract.hpp"
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

}  // namespace

NearestPoints distance(const Region& p, const Region& q) {
  OPLUS_REQUIRES(!p.components.empty() && !q.components.empty(), "distance");
  return nearest_points(p, edges(p), q, edges(q));
}

std::optional<Overlap> depth(const Region& p, const Region& q) {
  if (p.components.empty() || q.components.empty()) return std::nullopt;
  SegmentTree of_p(edges(p)), of_q(edges(q));
  if (sgn(nearest_points(p, of_p, q, of_q).squared_distance) > 0) return std::nullopt;
  const PlanarSet set = no_fit(p, q, [](const Region& a, const Region& b, Boundary boundary) {
    return slide_sum(a, b, boundary).sum;
  });
  // They have a common point, so the origin is in the no-fit polygon or on its boundary, where they only touch.
  Overlap way_out = WaysOut(std::move(of_p), std::move(of_q), set).from({});
  if (sgn(way_out.squared_depth) == 0) return std::nullopt;
  return way_out;
}

}  // namespace oplus
