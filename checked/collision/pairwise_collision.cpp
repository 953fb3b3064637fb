// SPDX-License-Identifier: MIT
#include <algorithm>
#include <functional>
#include <optional>
#include <span>
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
    const IntervalSegment& ab = p_.pieces.certified(i);
    const IntervalSegment cd = translated(minus_q_.pieces.certified(j), by_);
    const Segment& of_p = p_.pieces[i];
    const auto side_of_p = [&](const IntervalPoint& near, Point Segment::*end) {
      const std::optional<int> known = orientation(ab.source, ab.target, near);
      return known ? *known : orientation(of_p.source, of_p.target, piece_of_q(j).*end);
    };
    const int of_c = side_of_p(cd.source, &Segment::source),
              of_d = side_of_p(cd.target, &Segment::target);
    if (of_c == of_d && of_c != 0) return false;
    const auto side_of_q = [&](const IntervalPoint& near, const Point& exact) {
      if (const std::optional<int> known = orientation(cd.source, cd.target, near)) return *known;
      const Segment& of_q = piece_of_q(j);
      return orientation(of_q.source, of_q.target, exact);
    };
    const int of_a = side_of_q(ab.source, of_p.source), of_b = side_of_q(ab.target, of_p.target);
    if (of_a == of_b && of_a != 0) return false;
    if (of_a * of_b < 0 && of_c * of_d < 0) return true;
    const End ends[] = {{ab.source, Summand::P, i, &Segment::source},
                        {ab.target, Summand::P, i, &Segment::target},
                        {cd.source, Summand::Q, j, &Segment::source},
                        {cd.target, Summand::Q, j, &Segment::target}};
    if (of_c != 0 || of_d != 0) {  // they meet in one point, which is an end
      contacts_.push_back({ends[of_a == 0 ? 0 : of_b == 0 ? 1 : of_c == 0 ? 2 : 3], i, j});
      return false;
    }
    for (std::size_t k = 0; k < 4; ++k) {
      const std::size_t other = k < 2 ? 2 : 0;
      if (compare(ends[other], ends[k]) * compare(ends[k], ends[other + 1]) >= 0)
        contacts_.push_back({ends[k], i, j});
    }
    return false;
  }

  bool meet_without_crossing() {
    return meet_at_contacts() ||
           one_contains_untouched_chain(p_, minus_q_, x_, touched_by_contacts());
  }

 private:
  /// An end of a piece, where it is.
  struct End {
    IntervalPoint near;
    Summand of;
    std::size_t piece;
    Point Segment::*end;
  };

  /// A pair that meets in a point, or at an end of an overlap: that is an end of one.
  struct Contact {
    End at;
    std::size_t i, j;
  };

  const Segment& piece_of_q(std::size_t j) {
    if (!is_moved_) return minus_q_.pieces[j];
    if (moved_number_ != j) moved_ = translated(minus_q_.pieces[j], x_);
    moved_number_ = j;
    return moved_;
  }

  /// In the order of the plane.
  int compare(const End& a, const End& b) {
    std::optional<int> known = oplus::compare(a.near.x, b.near.x);
    if (known == 0) known = oplus::compare(a.near.y, b.near.y);
    if (known) return *known;
    const Point of_a = exact(a);
    const auto order = of_a <=> exact(b);
    return (order > 0) - (order < 0);
  }

  const Point& exact(const End& end) {
    return (end.of == Summand::P ? p_.pieces[end.piece] : piece_of_q(end.piece)).*end.end;
  }

  /// Pieces meet others of their summand in common ends only: so all that pass through a contact are in
  /// pairs that meet there, and no vertex is inside an overlap.
  bool meet_at_contacts() {
    std::sort(contacts_.begin(), contacts_.end(),
              [&](const Contact& a, const Contact& b) { return compare(a.at, b.at) < 0; });
    for (auto first = contacts_.begin(); first != contacts_.end();) {
      const auto last = std::find_if(first, contacts_.end(), [&](const Contact& other) {
        return compare(other.at, first->at) != 0;
      });
      collect_rays({&*first, static_cast<std::size_t>(last - first)});
      if (interiors_meet_around(rays_) &&
          !OPLUS_MUTANT("weak-intersections-never-meet",
                        "boundaries that meet without a proper crossing are taken to touch only"))
        return true;
      first = last;
    }
    return false;
  }

  /// All rays of both boundaries at a contact.
  void collect_rays(std::span<const Contact> at_one_point) {
    rays_.clear();
    const End& at = at_one_point.front().at;
    for (const Summand of : {Summand::P, Summand::Q}) {
      const bool is_p = of == Summand::P;
      here_.clear();
      for (const Contact& contact : at_one_point) here_.push_back(is_p ? contact.i : contact.j);
      std::sort(here_.begin(), here_.end());
      here_.erase(std::unique(here_.begin(), here_.end()), here_.end());
      const SegmentTree& pieces = is_p ? p_.pieces : minus_q_.pieces;
      for (const std::size_t k : here_) {
        const IntervalSegment& near = pieces.certified(k);
        const IntervalSegment moved = is_p ? near : translated(near, by_);
        if (compare(at, {moved.target, of, k, &Segment::target}) != 0)
          rays_.push_back(ray_along(pieces[k], near, true, of));
        if (compare(at, {moved.source, of, k, &Segment::source}) != 0)
          rays_.push_back(ray_along(pieces[k], near, false, of));
      }
    }
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
  Segment moved_;  ///< the last one that was needed exactly
  std::optional<std::size_t> moved_number_;
  std::vector<Contact> contacts_;
  std::vector<std::size_t> here_;
  std::vector<BoundaryRay> rays_;
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
