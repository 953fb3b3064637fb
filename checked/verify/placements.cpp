// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/verify/placements.hpp"

#include <utility>
#include <vector>

#include "checked/verify/certified.hpp"
#include "reference/definitions/cells.hpp"
#include "reference/definitions/collision.hpp"

namespace oplus {

struct Placements::Certified {
  Certified(const Region& p, const Region& minus_q)
      : of_p(pieces(p)), of_minus_q(pieces(minus_q)) {}

  /// Cut where chains touch, as in the definition: only inside such pieces does a crossing show
  /// common interior.
  static std::vector<CertifiedSegment> pieces(const Region& region) {
    std::vector<CertifiedSegment> result;
    for (const std::vector<Segment>& of_chain : boundary_pieces(region))
      for (const Segment& piece : of_chain)
        result.push_back({certified(piece.source), certified(piece.target)});
    return result;
  }

  bool a_crossing_shows(const Point& x) const {
    const CGAL::Protect_FPU_rounding<true> protector;
    const CertifiedPoint by = certified(x);
    for (const CertifiedSegment& of_q : of_minus_q) {
      const CertifiedSegment moved{of_q.source + by, of_q.target + by};
      for (const CertifiedSegment& piece : of_p)
        if (certainly_cross(piece, moved)) return true;
    }
    return false;
  }

  std::vector<CertifiedSegment> of_p;
  std::vector<CertifiedSegment> of_minus_q;
};

Placements::Placements(const Region& p, const Region& q)
    : p_(p), minus_q_(reflected(q)), certified_(std::make_unique<const Certified>(p_, minus_q_)) {}

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
