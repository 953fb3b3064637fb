// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/collision/pairwise_collision.hpp"

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "checked/arithmetic/interval.hpp"
#include "checked/collision/contact.hpp"
#include "reference/definitions/mutant.hpp"

namespace oplus {

namespace {

using IntervalEnds = std::vector<std::pair<IntervalPoint, IntervalPoint>>;

IntervalEnds interval_ends(const std::vector<Segment>& pieces) {
  IntervalEnds ends;
  ends.reserve(pieces.size());
  for (const Segment& piece : pieces)
    ends.emplace_back(interval(piece.source), interval(piece.target));
  return ends;
}

enum class Meeting { none, crossing, contact };

}  // namespace

struct PairwiseCollision::CertifiedEnds {
  IntervalEnds of_p;
  IntervalEnds of_minus_q;
};

PairwiseCollision::PairwiseCollision(const Region& p, const Region& q)
    : p_(p),
      minus_q_(reflected(q)),
      ends_(std::make_unique<CertifiedEnds>(
          CertifiedEnds{interval_ends(p_.pieces), interval_ends(minus_q_.pieces)})) {}

PairwiseCollision::~PairwiseCollision() = default;

/// One placement, and the contacts seen so far.
class PairwiseCollision::Query {
 public:
  Query(const PairwiseCollision& test, const Point& x)
      : p_(test.p_), minus_q_(test.minus_q_), ends_(*test.ends_), x_(x), by_(interval(x)) {}

  /// Returns whether the pair crosses; remembers it where it touches.
  bool visit(std::size_t i, std::size_t j) {
    const Meeting meeting = meeting_of(i, j);
    if (meeting == Meeting::contact) contacts_.emplace_back(i, j);
    return meeting == Meeting::crossing;
  }

  bool meet_without_crossing() const {
    return meet_at_contacts() ||
           one_contains_untouched_chain(p_, minus_q_, x_, touched_by_contacts());
  }

 private:
  Meeting meeting_of(std::size_t i, std::size_t j) const {
    const auto& [a, b] = ends_.of_p[i];
    const IntervalPoint c = ends_.of_minus_q[j].first + by_;
    const IntervalPoint d = ends_.of_minus_q[j].second + by_;
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
    const Segment& s = p_.pieces[i];
    const Segment t = piece_of_q(j);
    if (cross_properly(s, t)) return Meeting::crossing;
    return intersection(s, t).empty() ? Meeting::none : Meeting::contact;
  }

  Segment piece_of_q(std::size_t j) const { return translated(minus_q_.pieces[j], x_); }

  bool meet_at_contacts() const {
    std::set<Point> points;
    for (const auto& [i, j] : contacts_) {
      for (const Point& at : intersection(p_.pieces[i], piece_of_q(j))) points.insert(at);
    }
    return std::any_of(points.begin(), points.end(), [&](const Point& at) {
      return !OPLUS_MUTANT(
                 "weak-intersections-never-meet",
                 "boundaries that meet without a proper crossing are taken to touch only") &&
             interiors_meet_around(rays(at));
    });
  }

  /// All rays of both boundaries at a contact. A piece may pass through it that overlaps another
  /// from before it to behind it.
  std::vector<BoundaryRay> rays(const Point& at) const {
    std::set<std::size_t> of_p;
    std::set<std::size_t> of_q;
    for (const auto& [i, j] : contacts_) {
      if (lies_on(at, p_.pieces[i])) of_p.insert(i);
      if (lies_on(at, piece_of_q(j))) of_q.insert(j);
    }
    std::vector<BoundaryRay> result;
    for (const std::size_t i : of_p) add_rays(p_.pieces[i], Summand::P, at, result);
    for (const std::size_t j : of_q) add_rays(piece_of_q(j), Summand::Q, at, result);
    return result;
  }

  TouchedChains touched_by_contacts() const {
    TouchedChains touched = untouched(p_, minus_q_);
    for (const auto& [i, j] : contacts_) {
      touched[0][p_.chain_of[i]] = true;
      touched[1][minus_q_.chain_of[j]] = true;
    }
    return touched;
  }

  const SummandBoundary& p_;
  const SummandBoundary& minus_q_;
  const CertifiedEnds& ends_;
  const Point& x_;
  const IntervalPoint by_;
  std::vector<std::pair<std::size_t, std::size_t>> contacts_;
};

bool PairwiseCollision::interiors_meet_at(const Point& x) {
  const CGAL::Protect_FPU_rounding<true> rounding;
  Query query(*this, x);
  const auto visit = [&](std::size_t i, std::size_t j) { return query.visit(i, j); };
  return visit_pairs(x, visit) || query.meet_without_crossing();
}

}  // namespace oplus
