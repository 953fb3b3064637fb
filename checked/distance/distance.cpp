// SPDX-License-Identifier: MIT
#include "checked/distance/distance.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "checked/collision/segment_tree.hpp"
#include "reference/definitions/contract.hpp"
#include "reference/definitions/region.hpp"
#include "reference/definitions/squared_distance.hpp"
#include "reference/definitions/unbounded.hpp"

namespace oplus {

namespace {

NearestPoints nearest_points(const Segment& a, const Segment& b) {
  if (const std::vector<Point> common = intersection(a, b); !common.empty())
    return {0, common[0], common[0]};
  std::optional<NearestPoints> nearest;
  const auto add = [&](const Point& on_a, const Point& on_b) {
    Rational squared = squared_length(on_a - on_b);
    if (!nearest || squared < nearest->squared_distance) nearest = {std::move(squared), on_a, on_b};
  };
  for (const Point* end : {&a.source, &a.target}) add(*end, nearest_point(*end, b));
  for (const Point* end : {&b.source, &b.target}) add(nearest_point(*end, a), *end);
  return *std::move(nearest);
}

/// Requires: neither is empty.
NearestPoints nearest_points(const SegmentTree& a, const SegmentTree& b) {
  struct Candidate {
    double least;
    std::size_t i, j;
  };
  std::vector<Candidate> candidates;
  double most = SegmentTree::nothing;
  a.look_for_near(b, most, [&](std::size_t i, std::size_t j) {
    const Interval here = squared_distance(a.certified(i), b.certified(j));
    if (here.low <= most) candidates.push_back({here.low, i, j});
    return most = std::min(most, here.high);
  });
  std::optional<NearestPoints> nearest;
  for (const auto& [least, i, j] : candidates) {
    if (least > most) continue;
    NearestPoints here = nearest_points(a[i], b[j]);
    if (!nearest || here.squared_distance < nearest->squared_distance) nearest = std::move(here);
    if (sgn(nearest->squared_distance) == 0) break;
  }
  return *std::move(nearest);
}

/// A region, of which each component has a vertex in `boundary` unless it is the plane.
struct Bounded {
  const Region& region;
  SegmentTree boundary = edges(region);

  /// A vertex of a chain of the other one, or any point of the plane, that is in the region for certain.
  std::optional<Point> vertex_inside(const Region& other) const {
    for (const Chain& chain : chains(other)) {
      if (chain.empty()) continue;
      const std::optional<Crossing> first = first_to_the_right(chain[0], boundary);
      if (first ? first->runs_up : is_unbounded(region)) return chain[0];
    }
    return std::nullopt;
  }
};

}  // namespace

NearestPoints distance(const Region& p, const Region& q) {
  OPLUS_REQUIRES(!p.components.empty() && !q.components.empty(), "distance");
  const Bounded of_p{p}, of_q{q};
  if (of_p.boundary.empty() && of_q.boundary.empty()) return {0, {}, {}};
  std::optional<Point> common = of_p.vertex_inside(q);
  if (!common) common = of_q.vertex_inside(p);
  if (common) return {0, *common, *common};
  return nearest_points(of_p.boundary, of_q.boundary);
}

}  // namespace oplus
