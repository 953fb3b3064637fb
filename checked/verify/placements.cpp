// SPDX-License-Identifier: MIT
#include "checked/verify/placements.hpp"

#include <utility>
#include <vector>

#include "reference/arithmetic/interval.hpp"
#include "reference/chains/touching_points.hpp"
#include "reference/definitions/cells.hpp"
#include "reference/definitions/collision.hpp"

namespace oplus {

namespace {

/// Whether the ends of b are certainly on different sides of the line through a.
bool certainly_between(const IntervalSegment& a, const IntervalSegment& b) {
  const IntervalPoint along = a.target - a.source;
  const std::optional<int> of_source = sign(cross(along, b.source - a.source));
  if (!of_source || *of_source == 0) return false;
  const std::optional<int> of_target = sign(cross(along, b.target - a.source));
  return of_target && *of_target == -*of_source;
}

/// Cut where chains touch, as in the definition: only inside such pieces does a crossing show
/// common interior.
std::vector<IntervalSegment> pieces(const Region& region) {
  std::vector<IntervalSegment> result;
  for (const Segment& piece : boundary_pieces(region)) result.push_back(interval(piece));
  return result;
}

}  // namespace

struct Placements::Certified {
  bool a_crossing_shows(const Point& x) const {
    const IntervalPoint by = interval(x);
    for (const IntervalSegment& of_q : of_minus_q) {
      const IntervalSegment moved = translated(of_q, by);
      for (const IntervalSegment& piece : of_p)
        if (certainly_between(piece, moved) && certainly_between(moved, piece)) return true;
    }
    return false;
  }

  std::vector<IntervalSegment> of_p;
  std::vector<IntervalSegment> of_minus_q;
};

Placements::Placements(const Region& p, const Region& q)
    : p_(p), minus_q_(reflected(q)), certified_(new Certified{pieces(p_), pieces(minus_q_)}) {}

Placements::~Placements() = default;

bool Placements::interiors_meet_at(const Point& x) const {
  return certified_->a_crossing_shows(x) || interiors_meet(p_, translated(minus_q_, x));
}

std::optional<Point> Placements::common_point_at(const Point& x) const {
  const Region placed = translated(minus_q_, x);
  std::vector<Segment> both = edges(p_);
  for (const Segment& e : edges(placed)) both.push_back(e);
  const Cells cut = cells(both);
  for (const std::vector<Segment>& boundary : cut.faces) {
    if (boundary.empty()) continue;
    const Point inside = point_inside(boundary);
    if (locate(inside, p_) == Location::inside && locate(inside, placed) == Location::inside)
      return inside;
  }
  for (const Point& v : cut.vertices)
    if (locate(v, p_) != Location::outside && locate(v, placed) != Location::outside) return v;
  return std::nullopt;
}

}  // namespace oplus
