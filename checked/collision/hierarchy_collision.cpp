// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/collision/hierarchy_collision.hpp"

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "checked/collision/bounding_volume_hierarchy.hpp"
#include "checked/collision/contact.hpp"
#include "reference/definitions/mutant.hpp"

namespace oplus {

namespace {

Segment translated(const Segment& s, const Vector& by) { return {s.source + by, s.target + by}; }

/// The pieces of a region's boundary, cut where its chains touch, and the hierarchy over all.
struct Summary {
  explicit Summary(Region of) : region(std::move(of)), edges(pieces()), hierarchy(edges) {
    for (const Segment& e : edges) ends.emplace_back(interval(e.source), interval(e.target));
  }

  std::vector<Segment> pieces() {
    std::vector<Segment> all;
    for (const std::vector<Segment>& of_chain : boundary_pieces(region)) {
      chain_of.insert(chain_of.end(), of_chain.size(), chain_starts.size());
      chain_starts.push_back(all.size());
      all.insert(all.end(), of_chain.begin(), of_chain.end());
    }
    return all;
  }

  Region region;
  std::vector<std::size_t> chain_of;      ///< of each piece
  std::vector<std::size_t> chain_starts;  ///< the first piece of each chain
  std::vector<Segment> edges;
  std::vector<std::pair<IntervalPoint, IntervalPoint>> ends;
  BoundingVolumeHierarchy hierarchy;
};

enum class Meeting { none, crossing, contact };

class HierarchyCollision : public CollisionTest {
 public:
  HierarchyCollision(const Region& p, const Region& q) : p_(p), minus_q_(reflected(q)) {}

  bool interiors_meet_at(const Point& x) override {
    const CGAL::Protect_FPU_rounding<true> rounding;
    contacts_.clear();
    const IntervalPoint by = interval(x);
    const bool crossing =
        p_.hierarchy.visit_meeting(minus_q_.hierarchy, by, [&](std::size_t i, std::size_t j) {
          const Meeting meeting = meeting_of(i, j, x, by);
          if (meeting == Meeting::contact) contacts_.emplace_back(i, j);
          return meeting == Meeting::crossing;
        });
    return crossing || meet_at_contacts(x) || one_contains_chain_of_other(x);
  }

 private:
  Meeting meeting_of(std::size_t i, std::size_t j, const Point& x, const IntervalPoint& by) const {
    const auto& [a, b] = p_.ends[i];
    const IntervalPoint c = minus_q_.ends[j].first + by;
    const IntervalPoint d = minus_q_.ends[j].second + by;
    const auto ab_c = orientation(a, b, c);
    const auto ab_d = orientation(a, b, d);
    if (CGAL::is_certain(ab_c) && CGAL::is_certain(ab_d)) {
      if (ab_c.inf() == ab_d.inf() && ab_c.inf() != CGAL::ZERO) return Meeting::none;
      const auto cd_a = orientation(c, d, a);
      const auto cd_b = orientation(c, d, b);
      if (CGAL::is_certain(cd_a) && CGAL::is_certain(cd_b)) {
        if (cd_a.inf() == cd_b.inf() && cd_a.inf() != CGAL::ZERO) return Meeting::none;
        if (ab_c.inf() * ab_d.inf() < 0 && cd_a.inf() * cd_b.inf() < 0) return Meeting::crossing;
      }
    }
    const Segment& s = p_.edges[i];
    const Segment t = translated(minus_q_.edges[j], x);
    if (cross_properly(s, t)) return Meeting::crossing;
    return intersection(s, t).empty() ? Meeting::none : Meeting::contact;
  }

  bool meet_at_contacts(const Point& x) const {
    std::set<Point> points;
    for (const auto& [i, j] : contacts_) {
      for (const Point& at : intersection(p_.edges[i], translated(minus_q_.edges[j], x)))
        points.insert(at);
    }
    return std::any_of(points.begin(), points.end(), [&](const Point& at) {
      return !OPLUS_MUTANT("weak-intersections-never-meet") && interiors_meet_around(rays(at, x));
    });
  }

  /// All rays of both boundaries at a contact. An edge may pass through it that overlaps another
  /// from before it to behind it.
  std::vector<BoundaryRay> rays(const Point& at, const Point& x) const {
    std::set<std::size_t> of_p;
    std::set<std::size_t> of_q;
    for (const auto& [i, j] : contacts_) {
      if (lies_on(at, p_.edges[i])) of_p.insert(i);
      if (lies_on(at, translated(minus_q_.edges[j], x))) of_q.insert(j);
    }
    std::vector<BoundaryRay> result;
    for (const std::size_t i : of_p) add_rays(p_.edges[i], Summand::P, at, result);
    for (const std::size_t j : of_q)
      add_rays(translated(minus_q_.edges[j], x), Summand::Q, at, result);
    return result;
  }

  /// Without a crossing, and where contacts show no common interior, a chain that has a contact
  /// runs outside the other region's interior; one without is inside or outside as a whole.
  bool one_contains_chain_of_other(const Point& x) const {
    std::vector<bool> p_touched(p_.chain_starts.size(), false);
    std::vector<bool> q_touched(minus_q_.chain_starts.size(), false);
    for (const auto& [i, j] : contacts_) {
      p_touched[p_.chain_of[i]] = true;
      q_touched[minus_q_.chain_of[j]] = true;
    }
    for (std::size_t c = 0; c < p_touched.size(); ++c) {
      const Point& vertex = p_.edges[p_.chain_starts[c]].source;
      if (!p_touched[c] && locate(vertex - x, minus_q_.region) == Location::inside) return true;
    }
    for (std::size_t c = 0; c < q_touched.size(); ++c) {
      const Point& vertex = minus_q_.edges[minus_q_.chain_starts[c]].source;
      if (!q_touched[c] && locate(vertex + x, p_.region) == Location::inside) return true;
    }
    return false;
  }

  Summary p_;
  Summary minus_q_;
  std::vector<std::pair<std::size_t, std::size_t>> contacts_;
};

}  // namespace

std::unique_ptr<CollisionTest> hierarchy_collision(const Region& p, const Region& q) {
  return std::make_unique<HierarchyCollision>(p, q);
}

}  // namespace oplus
