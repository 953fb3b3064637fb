// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "reference/definitions/region.hpp"

namespace oplus {

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

enum class CollisionMethod { hierarchy, sweep, naive };

/// Requires: p and q are valid (validity.hpp).
std::unique_ptr<CollisionTest> collision_test(CollisionMethod method, const Region& p,
                                              const Region& q);

}  // namespace oplus
