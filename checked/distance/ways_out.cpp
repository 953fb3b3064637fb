// SPDX-License-Identifier: MIT
#include "checked/distance/ways_out.hpp"

#include <utility>
#include <vector>

#include "checked/distance/nearest_segments.hpp"
#include "reference/definitions/contract.hpp"
#include "reference/definitions/mutant.hpp"
#include "reference/definitions/planar_set.hpp"
#include "reference/io/invalid_input.hpp"

namespace oplus {

namespace {

std::vector<Segment> boundary_of(const PlanarSet& set) {
  std::vector<Segment> all = edges(set);
  if (OPLUS_MUTANT("ways-out-miss-exact-fits", "no way out of an overlap leads to an exact fit"))
    all.resize(all.size() - set.dangling_edges.size());
  else
    for (const Point& p : set.isolated_vertices) all.push_back({p, p});
  return all;
}

}  // namespace

WaysOut::WaysOut(SegmentTree p, SegmentTree q, const PlanarSet& no_fit)
    : p_(std::move(p)), q_(std::move(q)), boundary_(boundary_of(no_fit)) {}

void refuse_to_part() {
  throw InvalidInput({"depth", 0, 0}, "Q overlaps P wherever it is moved to",
                     "regions that can be moved apart");
}

Overlap WaysOut::from(const Vector& x) const { return way_out(p_, q_, x, boundary_); }

Overlap way_out(const SegmentTree& p, const SegmentTree& q, const Vector& from,
                const SegmentTree& boundary) {
  if (boundary.empty()) refuse_to_part();
  NearestPoints nearest = nearest_points(SegmentTree(std::vector<Segment>{{from, from}}), boundary);
  // The boundaries have a point in common wherever a region moved a little overlaps the other, and it does not.
  const Vector& x = nearest.on_q;
  const IntervalPoint near_x = interval(x);
  std::vector<Point> common;
  [[maybe_unused]] const bool touch = p.visit_meeting(q, x, [&](std::size_t i, std::size_t j) {
    if (squared_distance(p.certified(i), translated(q.certified(j), near_x)).low > 0) return false;
    common = intersection(p[i], {q[j].source + x, q[j].target + x});
    return !common.empty();
  });
  OPLUS_ENSURES(touch, "regions touch on the boundary of their no-fit polygon");
  return {x - from, std::move(nearest.squared_distance), common.at(0)};
}

}  // namespace oplus
