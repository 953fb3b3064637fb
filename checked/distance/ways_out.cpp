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

Overlap WaysOut::from(const Vector& x) const {
  if (boundary_.empty())
    throw InvalidInput({"depth", 0, 0}, "Q overlaps P wherever it is moved to",
                       "regions that can be moved apart");
  NearestPoints nearest = nearest_points(SegmentTree(std::vector<Segment>{{x, x}}), boundary_);
  return {nearest.on_q - x, std::move(nearest.squared_distance), contact_at(nearest.on_q)};
}

/// The boundaries have a point in common wherever a region moved a little overlaps the other, and it does not.
Point WaysOut::contact_at(const Vector& x) const {
  const IntervalPoint way = interval(x);
  std::vector<Point> common;
  [[maybe_unused]] const bool touch = p_.visit_meeting(q_, x, [&](std::size_t i, std::size_t j) {
    if (squared_distance(p_.certified(i), translated(q_.certified(j), way)).low > 0) return false;
    common = intersection(p_[i], {q_[j].source + x, q_[j].target + x});
    return !common.empty();
  });
  OPLUS_ENSURES(touch, "regions touch on the boundary of their no-fit polygon");
  return common.at(0);
}

}  // namespace oplus
