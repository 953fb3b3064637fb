// SPDX-License-Identifier: MIT
#include "checked/distance/nearest_segments.hpp"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "reference/definitions/mutant.hpp"
#include "reference/definitions/squared_distance.hpp"

namespace oplus {

namespace {

/// Of segments that don't cross, an end of one is as near to the other as any point.
NearestPoints nearest_points(const Segment& a, const Segment& b) {
  if (const std::vector<Point> common = intersection(a, b); !common.empty())
    return {0, common[0], common[0]};
  std::optional<NearestPoints> nearest;
  const auto add = [&](const Point& on_a, const Point& on_b) {
    Rational squared = squared_length(on_a - on_b);
    if (!nearest || squared < nearest->squared_distance) nearest = {std::move(squared), on_a, on_b};
  };
  for (const Point* end : {&a.source, &a.target}) add(*end, nearest_point(*end, b));
  if (OPLUS_MUTANT("distances-from-one-side",
                   "of two segments, only the ends of the first are tried as nearest points"))
    return *std::move(nearest);
  for (const Point* end : {&b.source, &b.target}) add(nearest_point(*end, a), *end);
  return *std::move(nearest);
}

}  // namespace

NearestPoints nearest_points(const SegmentTree& p, const SegmentTree& q) {
  struct Candidate {
    double least;
    std::size_t i, j;
  };
  std::vector<Candidate> candidates;
  double most = SegmentTree::nothing;
  p.look_for_near(q, most, [&](std::size_t i, std::size_t j) {
    const Interval here = squared_distance(p.certified(i), q.certified(j));
    if (here.low <= most) candidates.push_back({here.low, i, j});
    return most = std::min(most, here.high);
  });
  std::optional<NearestPoints> nearest;
  for (const auto& [least, i, j] : candidates) {
    if (least > most) continue;
    NearestPoints here = nearest_points(p[i], q[j]);
    if (!nearest || here.squared_distance < nearest->squared_distance) nearest = std::move(here);
    if (sgn(nearest->squared_distance) == 0) break;
  }
  return *std::move(nearest);
}

}  // namespace oplus
