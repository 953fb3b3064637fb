// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstddef>
#include <memory>
#include <optional>

#include "checked/collision/collision_test.hpp"
#include "reference/definitions/region.hpp"

namespace oplus {

/// The collision test of two fixed regions P and Q, asked at many placements.
class CollisionVerdicts {
 public:
  /// Requires: p and q are valid (validity.hpp), and stay where they are.
  CollisionVerdicts(const Region& p, const Region& q);
  ~CollisionVerdicts();

  /// Whether the interiors of P and -Q+x meet, so that x is in the open sum: by hierarchies
  /// (collision_test.hpp).
  bool interiors_meet_at(const Point& x) const;

  /// The same, and by the definition (collision.hpp) as well, as long as that costs little: for what is
  /// said against a given sum. Throws VerdictsDiffer (verdicts_differ.hpp) where the two differ.
  bool interiors_meet_by_definition_at(const Point& x) const;

  /// A point of P that is one of -Q+x: an inner point of both, or, where their interiors do not
  /// meet, of both boundaries; empty where P and -Q+x are disjoint.
  std::optional<Point> common_point_at(const Point& x) const;

 private:
  const Region& p_;
  const Region& q_;
  const std::unique_ptr<CollisionTest> test_;
  const std::size_t cost_of_definition_;  ///< of asking it once
  mutable std::atomic<std::size_t> spent_on_it_ = 0;
};

}  // namespace oplus
