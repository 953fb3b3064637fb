// SPDX-License-Identifier: MIT
#include <algorithm>
#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "checked/collision/collision_test.hpp"
#include "checked/collision/contact.hpp"
#include "checked/collision/summand_boundary.hpp"
#include "reference/arithmetic/interval.hpp"
#include "reference/definitions/mutant.hpp"

namespace oplus {

namespace {

/// One placement, and the contacts seen so far.
class Query {
 public:
  Query(const SummandBoundary& p, const SummandBoundary& minus_q, const Point& x)
      : p_(p), minus_q_(minus_q), x_(x), by_(interval(x)) {}

  /// Returns whether the pair crosses; remembers it where it touches.
  bool visit(std::size_t i, std::size_t j) {
    const std::optional<bool> crosses = do_cross(i, j);
    if (crosses) return *crosses;
    for (Point& at : intersection(p_.pieces[i], piece_of_q(j)))
      contacts_.push_back({std::move(at), i, j});
    return false;
  }

  bool meet_without_crossing() {
    return meet_at_contacts() ||
           one_contains_untouched_chain(p_, minus_q_, x_, touched_by_contacts());
  }

 private:
  /// Whether they cross properly; empty where they don't, but may have contact.
  std::optional<bool> do_cross(std::size_t i, std::size_t j) const {
    const auto& [a, b] = p_.pieces.certified(i);
    const auto [c, d] = translated(minus_q_.pieces.certified(j), by_);
    const std::optional<int> ab_c = orientation(a, b, c);
    const std::optional<int> ab_d = orientation(a, b, d);
    if (ab_c && ab_d) {
      if (*ab_c == *ab_d && *ab_c != 0) return false;
      const std::optional<int> cd_a = orientation(c, d, a);
      const std::optional<int> cd_b = orientation(c, d, b);
      if (cd_a && cd_b) {
        if (*cd_a == *cd_b && *cd_a != 0) return false;
        if (*ab_c * *ab_d < 0 && *cd_a * *cd_b < 0) return true;
        return std::nullopt;
      }
    }
    if (cross_properly(p_.pieces[i], piece_of_q(j))) return true;
    return std::nullopt;
  }

  Segment piece_of_q(std::size_t j) const {
    const Segment& s = minus_q_.pieces[j];
    return is_moved_ ? translated(s, x_) : s;
  }

  /// A pair that meets in a point, or at an end of an overlap.
  struct Contact {
    Point at;
    std::size_t i, j;
  };

  /// Pieces meet others of their summand in common ends only: so all that pass through a contact are in
  /// pairs that meet there, and no vertex is inside an overlap.
  bool meet_at_contacts() {
    std::sort(contacts_.begin(), contacts_.end(),
              [](const Contact& a, const Contact& b) { return a.at < b.at; });
    for (auto first = contacts_.begin(); first != contacts_.end();) {
      const auto last = std::find_if(first, contacts_.end(),
                                     [&](const Contact& other) { return other.at != first->at; });
      if (interiors_meet_around(rays({&*first, static_cast<std::size_t>(last - first)})) &&
          !OPLUS_MUTANT("weak-intersections-never-meet",
                        "boundaries that meet without a proper crossing are taken to touch only"))
        return true;
      first = last;
    }
    return false;
  }

  /// All rays of both boundaries at a contact.
  std::vector<BoundaryRay> rays(std::span<const Contact> at_one_point) const {
    std::vector<std::size_t> of_p, of_q;
    for (const Contact& contact : at_one_point) {
      of_p.push_back(contact.i);
      of_q.push_back(contact.j);
    }
    for (std::vector<std::size_t>* pieces : {&of_p, &of_q}) {
      std::sort(pieces->begin(), pieces->end());
      pieces->erase(std::unique(pieces->begin(), pieces->end()), pieces->end());
    }
    const Point& at = at_one_point.front().at;
    std::vector<BoundaryRay> result;
    for (const std::size_t i : of_p) add_rays(p_.pieces[i], Summand::P, at, result);
    for (const std::size_t j : of_q) add_rays(piece_of_q(j), Summand::Q, at, result);
    return result;
  }

  TouchedChains touched_by_contacts() const {
    TouchedChains touched = untouched(p_, minus_q_);
    for (const auto& [at, i, j] : contacts_) {
      touched[0][p_.chain_of[i]] = true;
      touched[1][minus_q_.chain_of[j]] = true;
    }
    return touched;
  }

  const SummandBoundary& p_;
  const SummandBoundary& minus_q_;
  const Point& x_;
  const IntervalPoint by_;
  const bool is_moved_ = x_ != Point{};
  std::vector<Contact> contacts_;
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

  const SummandBoundary& p() const { return p_; }
  const SummandBoundary& minus_q() const { return minus_q_; }

 private:
  /// Calls `visit` for each pair that has a point in common, and for as many others as it likes,
  /// each once, until a call returns true. Returns whether one did.
  virtual bool visit_pairs(const Point& x, const Visit& visit) const = 0;

  const SummandBoundary p_;
  const SummandBoundary minus_q_;
};

class HierarchyCollision : public PairwiseCollision {
 public:
  using PairwiseCollision::PairwiseCollision;

 private:
  bool visit_pairs(const Point& x, const Visit& visit) const override {
    return p().pieces.visit_meeting(minus_q().pieces, x, visit);
  }
};

class NaiveCollision : public PairwiseCollision {
 public:
  using PairwiseCollision::PairwiseCollision;

 private:
  bool visit_pairs(const Point&, const Visit& visit) const override {
    for (std::size_t i = 0; i < p().pieces.size(); ++i) {
      for (std::size_t j = 0; j < minus_q().pieces.size(); ++j) {
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

bool interiors_meet(const SummandBoundary& p, const SummandBoundary& q, const Vector& by) {
  Query query(p, q, by);
  const auto visit = [&](std::size_t i, std::size_t j) { return query.visit(i, j); };
  return p.pieces.visit_meeting(q.pieces, by, visit) || query.meet_without_crossing();
}

std::unique_ptr<CollisionTest> naive_collision(const Region& p, const Region& q) {
  return std::make_unique<NaiveCollision>(p, q);
}

}  // namespace oplus
