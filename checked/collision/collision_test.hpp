// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "reference/definitions/region.hpp"

namespace oplus {

struct SummandBoundary;

/// The collision predicate of two fixed regions P and Q, asked at many placements (thesis, Section
/// 5.1). Implementations are built once a pair.
class CollisionTest {
 public:
  CollisionTest() = default;
  CollisionTest(const CollisionTest&) = delete;
  CollisionTest& operator=(const CollisionTest&) = delete;
  virtual ~CollisionTest() = default;

  /// Whether the interiors of P and -Q+x meet, that is, whether x is in the sum of the open
  /// regions.
  virtual bool interiors_meet_at(const Point& x) = 0;
};

// All require: p and q are valid (validity.hpp).

/// By two hierarchies of bounding volumes, built once, of which that of -Q is translated (Section
/// 5.1.2). About O(log n + log m) where the interiors meet, by experience; O(nm) at worst.
std::unique_ptr<CollisionTest> hierarchy_collision(const Region& p, const Region& q);

/// Whether the interiors of P and Q + by meet, both given by their boundaries: the same of regions of many pairs.
bool interiors_meet(const SummandBoundary& p, const SummandBoundary& q, const Vector& by);

/// Compares each edge of P with each of -Q+x (Section 5.1): O(nm) unless an early pair crosses.
/// What the two fast ones are measured against.
std::unique_ptr<CollisionTest> naive_collision(const Region& p, const Region& q);

}  // namespace oplus
