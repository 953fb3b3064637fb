// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <memory>

#include "checked/collision/collision_test.hpp"
#include "checked/collision/summand_boundary.hpp"

namespace oplus {

/// The collision test by pairs of boundary pieces (thesis, Section 5.1): a proper crossing of two
/// decides; else the points in which pairs have contact, then chains without contact. Which pairs
/// are looked at is up to the implementation.
class PairwiseCollision : public CollisionTest {
 public:
  ~PairwiseCollision() override;
  bool interiors_meet_at(const Point& x) final;

 protected:
  /// Whether piece i of P and piece j of -Q+x settle that the interiors meet.
  using Visit = std::function<bool(std::size_t i, std::size_t j)>;

  /// Requires: p and q are valid (validity.hpp).
  PairwiseCollision(const Region& p, const Region& q);

  const SummandBoundary& p() const { return p_; }
  const SummandBoundary& minus_q() const { return minus_q_; }

 private:
  /// Calls `visit` for each pair that has a point in common, and for as many others as it likes,
  /// each once, until a call returns true. Returns whether one did.
  virtual bool visit_pairs(const Point& x, const Visit& visit) const = 0;

  /// Each piece's ends as certified intervals.
  struct CertifiedEnds;

  class Query;

  SummandBoundary p_;
  SummandBoundary minus_q_;
  std::unique_ptr<const CertifiedEnds> ends_;
};

}  // namespace oplus
