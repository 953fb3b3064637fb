// SPDX-License-Identifier: MIT
#include <algorithm>
#include <functional>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "checked/collision/bounding_volume_hierarchy.hpp"
#include "checked/collision/collision_test.hpp"
#include "checked/collision/contact.hpp"
#include "checked/collision/summand_boundary.hpp"
#include "reference/arithmetic/interval.hpp"
#include "reference/definitions/mutant.hpp"

namespace oplus {

namespace {

/// A summand's boundary, and its pieces as certified intervals.
struct CertifiedBoundary : SummandBoundary {
  explicit CertifiedBoundary(const Region& of) : SummandBoundary(of) {
    certified.reserve(pieces.size());
    for (const Segment& piece : pieces) certified.push_back(interval(piece));
  }

  std::vector<IntervalSegment> certified;
};

enum class Meeting { none, crossing, contact };

/// One placement, and the contacts seen so far.
class Query {
 public:
  Query(const CertifiedBoundary& p, const CertifiedBoundary& minus_q, const Point& x)
      : p_(p), minus_q_(minus_q), x_(x), by_(interval(x)) {}

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
    const auto& [a, b] = p_.certified[i];
    const auto [c, d] = translated(minus_q_.certified[j], by_);
    const std::optional<int> ab_c = orientation(a, b, c);
    const std::optional<int> ab_d = orientation(a, b, d);
    if (ab_c && ab_d) {
      if (*ab_c == *ab_d && *ab_c != 0) return Meeting::none;
      const std::optional<int> cd_a = orientation(c, d, a);
      const std::optional<int> cd_b = orientation(c, d, b);
      if (cd_a && cd_b) {
        if (*cd_a == *cd_b && *cd_a != 0) return Meeting::none;
        if (*ab_c * *ab_d < 0 && *cd_a * *cd_b < 0) return Meeting::crossing;
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

  const CertifiedBoundary& p_;
  const CertifiedBoundary& minus_q_;
  const Point& x_;
  const IntervalPoint by_;
  std::vector<std::pair<std::size_t, std::size_t>> contacts_;
};

/// The collision test by pairs of boundary pieces (thesis, Section 5.1): a proper crossing of two
/// decides; else the points in which pairs have contact, then chains without contact. Which pairs
/// are looked at is up to the implementation.
class PairwiseCollision : public CollisionTest {
 public:
  PairwiseCollision(const Region& p, const Region& q) : p_(p), minus_q_(reflected(q)) {}

  bool interiors_meet_at(const Point& x) final {
    Query query(p_, minus_q_, x);
    const auto visit = [&](std::size_t i, std::size_t j) { return query.visit(i, j); };
    return visit_pairs(x, visit) || query.meet_without_crossing();
  }

 protected:
  /// Whether piece i of P and piece j of -Q+x settle that the interiors meet.
  using Visit = std::function<bool(std::size_t i, std::size_t j)>;

  const std::vector<Segment>& pieces_of_p() const { return p_.pieces; }
  const std::vector<Segment>& pieces_of_minus_q() const { return minus_q_.pieces; }

 private:
  /// Calls `visit` for each pair that has a point in common, and for as many others as it likes,
  /// each once, until a call returns true. Returns whether one did.
  virtual bool visit_pairs(const Point& x, const Visit& visit) const = 0;

  const CertifiedBoundary p_;
  const CertifiedBoundary minus_q_;
};

class HierarchyCollision : public PairwiseCollision {
 public:
  using PairwiseCollision::PairwiseCollision;

 private:
  bool visit_pairs(const Point& x, const Visit& visit) const override {
    return of_p_.visit_meeting(of_minus_q_, x, visit);
  }

  BoundingVolumeHierarchy of_p_{pieces_of_p()};
  BoundingVolumeHierarchy of_minus_q_{pieces_of_minus_q()};
};

class NaiveCollision : public PairwiseCollision {
 public:
  using PairwiseCollision::PairwiseCollision;

 private:
  bool visit_pairs(const Point&, const Visit& visit) const override {
    for (std::size_t i = 0; i < pieces_of_p().size(); ++i) {
      for (std::size_t j = 0; j < pieces_of_minus_q().size(); ++j) {
        if (visit(i, j)) return true;
      }
    }
    return false;
  }
};

}  // namespace

std::unique_ptr<CollisionTest> hierarchy_collision(const Region& p, const Region& q) {
  return std::make_unique<HierarchyCollision>(p, q);
}

std::unique_ptr<CollisionTest> naive_collision(const Region& p, const Region& q) {
  return std::make_unique<NaiveCollision>(p, q);
}

}  // namespace oplus
